//! What is amiss with a question.

use crate::bank::{StyleName, parameter_span};
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
    /// Or the parameter, as a style has it, at whose key it can be mended.
    pub parameter: Option<(StyleName, String)>,
    /// What was expected there.
    pub label: String,
    /// One thing to try.
    pub help: Option<String>,
}

impl Finding {
    /// A finding that must be mended.
    pub fn new(message: impl Into<String>, at: impl Into<String>, label: impl Into<String>) -> Finding {
        let (message, at, label) = (message.into(), at.into(), label.into());
        Finding { severity: Severity::Error, message, at, parameter: None, label, help: None }
    }

    /// A finding at the key of a parameter, which must be mended.
    pub fn at_parameter(message: impl Into<String>, style: StyleName, name: &str, label: &str) -> Finding {
        Finding { parameter: Some((style, name.to_owned())), ..Finding::new(message, "", label) }
    }

    /// With one thing to try.
    pub fn with_help(self, help: impl Into<String>) -> Finding {
        Finding { help: Some(help.into()), ..self }
    }

    /// The finding in the file of its question.
    pub fn diagnostic(&self, id: &str, source: &Source) -> Diagnostic {
        let key = self.parameter.as_ref().and_then(|(style, name)| parameter_span(&source.text, *style, name));
        let found = || source.text.find(&self.at).filter(|_| !self.at.is_empty());
        let span = key.or_else(|| found().map(|start| start..start + self.at.len()));
        let label = if span.is_some() { self.label.as_str() } else { "" };
        let fault = Diagnostic::new(format!("`{id}`: {}", self.message), source, span.unwrap_or(0..0), label);
        Diagnostic { severity: self.severity, help: self.help.clone(), ..fault }
    }
}
