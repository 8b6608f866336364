//! A fault in an expression: what is wrong, where, what was expected and one thing to try.

use super::{Function, Span};
use crate::diagnostic::near;

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

    /// The fault of a name straight before a bracket that is no function; `None` of any other name.
    pub fn unknown_function(text: &str, name: Span) -> Option<Fault> {
        let (word, behind) = (text.get(name.start..name.end)?, text.get(name.end..)?);
        if word.len() < 2 || !behind.starts_with('(') {
            return None;
        }
        let names: Vec<&str> = Function::ALL.iter().map(|function| function.name()).collect();
        let listed = names.iter().map(|name| format!("`{name}`")).collect::<Vec<_>>().join(", ");
        let fault = Fault::new(format!("unknown function `{word}`"), name, format!("formulas have {listed}"));
        let meant = Function::begins(word).map(Function::name).or_else(|| near(word, names));
        Some(fault.try_this(match meant {
            Some(meant) => format!("did you mean `{meant}`?"),
            None => "say it with those; for a product write a star before the bracket".to_owned(),
        }))
    }

    /// The fault as it stands in a longer text, in which the text that was read begins at `start`.
    pub fn shifted(self, start: usize) -> Fault {
        let span = Span { start: self.span.start + start, end: self.span.end + start };
        Fault { span, ..self }
    }
}
