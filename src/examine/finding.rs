//! What is amiss with a question.

use crate::diagnostic::{Diagnostic, Severity, Source};

/// Something amiss, with all that a person needs to mend it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Finding {
    /// How bad it is.
    pub severity: Severity,
    /// What it is, in one sentence.
    pub message: String,
    /// What stands in the file at the place where it can be mended; empty if no place is better than another.
    pub at: String,
    /// What was expected there.
    pub label: String,
    /// One thing to try.
    pub help: Option<String>,
}

impl Finding {
    /// A finding that must be mended.
    pub fn new(message: impl Into<String>, at: impl Into<String>, label: impl Into<String>) -> Finding {
        let (message, at, label) = (message.into(), at.into(), label.into());
        Finding { severity: Severity::Error, message, at, label, help: None }
    }

    /// With one thing to try.
    pub fn with_help(self, help: impl Into<String>) -> Finding {
        Finding { help: Some(help.into()), ..self }
    }

    /// The finding in the file of its question.
    pub fn diagnostic(&self, id: &str, source: &Source) -> Diagnostic {
        let found = if self.at.is_empty() { None } else { source.text.find(&self.at) };
        let span = found.map_or(0..0, |start| start..start + self.at.len());
        let label = if found.is_some() { self.label.as_str() } else { "" };
        let fault = Diagnostic::new(format!("`{id}`: {}", self.message), source, span, label);
        Diagnostic { severity: self.severity, help: self.help.clone(), ..fault }
    }
}
