//! What is wrong with a key, and in which words it is said.

use crate::diagnostic::why_no_json;

/// What is wrong with a key.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct KeyFault {
    /// Where it stands: `questions[0].scene.e`; empty if the whole is no key.
    pub path: String,
    /// What is wrong.
    pub message: String,
    /// What stands under the caret: what was expected there.
    pub expected: String,
    /// One thing to try; empty if there is nothing but to look.
    pub help: String,
    /// Line and column in the text, where that is all that is known.
    pub place: Option<(usize, usize)>,
}

impl KeyFault {
    pub(super) fn new(message: impl Into<String>, expected: impl Into<String>) -> KeyFault {
        KeyFault {
            path: String::new(),
            message: message.into(),
            expected: expected.into(),
            help: String::new(),
            place: None,
        }
    }

    pub(super) fn unreadable(error: &serde_json::Error) -> KeyFault {
        let help = match error.is_eof() {
            true => "copy the file again, whole, or mark by the code of the sheet: `carom mark CODE SUBMISSIONS`",
            false => "",
        };
        let place = (error.line() > 0).then(|| (error.line(), error.column()));
        KeyFault {
            place,
            help: help.to_owned(),
            ..KeyFault::new(
                format!("this is no key: {}", why_no_json(error)),
                "expected the `key.json` that `carom sheet` writes",
            )
        }
    }

    pub(super) fn below(self, path: &str) -> KeyFault {
        let path = if self.path.is_empty() { path.to_owned() } else { format!("{path}.{}", self.path) };
        KeyFault { path, ..self }
    }
}
