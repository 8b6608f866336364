//! What is wrong with a text that should be an expression, and where.

use super::Span;

/// A fault in a text: what was found, where, and what to try.
///
/// The text of each part is lower case, with what was read in backticks and no full stop.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Fault {
    /// What is wrong.
    pub message: String,
    /// Where, in bytes of the text that was read.
    pub span: Span,
    /// What was expected there: a short label under the caret.
    pub expected: String,
    /// One thing to try.
    pub help: Option<String>,
}

impl Fault {
    /// A fault without a suggestion.
    pub fn new(message: impl Into<String>, span: Span, expected: impl Into<String>) -> Fault {
        Fault { message: message.into(), span, expected: expected.into(), help: None }
    }

    /// The fault with a suggestion.
    pub fn with_help(self, help: impl Into<String>) -> Fault {
        Fault { help: Some(help.into()), ..self }
    }

    /// The fault as it stands in a longer text, in which the text that was read begins at `start`.
    pub fn shifted(self, start: usize) -> Fault {
        let span = Span { start: self.span.start + start, end: self.span.end + start };
        Fault { span, ..self }
    }
}
