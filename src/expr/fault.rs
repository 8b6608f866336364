//! A fault in an expression: what is wrong, where, what was expected and one thing to try.

use super::Span;

/// A fault in the text of an expression. Messages are lower case, names in backticks, no full stop.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Fault {
    /// What is wrong.
    pub message: String,
    /// Where, in bytes of the expression's text.
    pub span: Span,
    /// What stands under the caret: what was expected there.
    pub expected: String,
    /// One thing to try.
    pub help: Option<String>,
}

impl Fault {
    /// A fault without help.
    pub fn new(message: impl Into<String>, span: Span, expected: impl Into<String>) -> Fault {
        Fault { message: message.into(), span, expected: expected.into(), help: None }
    }

    /// The fault with one thing to try.
    pub fn try_this(mut self, help: impl Into<String>) -> Fault {
        self.help = Some(help.into());
        self
    }

    /// The fault as it stands in a longer text, in which the text that was read begins at `start`.
    pub fn shifted(self, start: usize) -> Fault {
        let span = Span { start: self.span.start + start, end: self.span.end + start };
        Fault { span, ..self }
    }
}
