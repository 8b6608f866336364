//! Why a scene cannot be solved, in the words of mechanics.

use std::fmt;

use super::Setting;
use super::later::{Meeting, ordinal};

/// The kind of a refusal.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Because {
    /// It cannot happen.
    Impossible,
    /// Too little is given.
    Underdetermined,
    /// The methods of the exam do not reach it.
    BeyondMethods,
}

/// A scene that is refused.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Refusal {
    /// The kind.
    pub because: Because,
    /// The reason, a sentence without a full stop.
    pub reason: String,
    /// One thing to try.
    pub help: Option<String>,
}

impl Refusal {
    /// A scene that cannot happen.
    pub fn impossible(reason: impl Into<String>) -> Refusal {
        Refusal { because: Because::Impossible, reason: reason.into(), help: None }
    }

    /// A scene that leaves something open.
    pub fn underdetermined(reason: impl Into<String>) -> Refusal {
        Refusal { because: Because::Underdetermined, reason: reason.into(), help: None }
    }

    /// A scene that needs more than the exam's methods.
    pub fn beyond(reason: impl Into<String>) -> Refusal {
        Refusal { because: Because::BeyondMethods, reason: reason.into(), help: None }
    }

    /// The refusal of a later impact, said of who has the parts of A and B there.
    pub(super) fn at(self, meeting: Meeting) -> Refusal {
        let reason = format!("at the {} impact: {}", ordinal(meeting.number), meeting.in_words(&self.reason));
        Refusal { reason, ..self }
    }

    /// The refusal with one thing to try.
    pub fn try_this(mut self, help: impl Into<String>) -> Refusal {
        self.help = Some(help.into());
        self
    }

    /// The same refusal in the words of another setting.
    pub fn said_of(self, setting: Setting) -> Refusal {
        let say = |words: String| setting.say(&words).into_owned();
        Refusal { reason: say(self.reason), help: self.help.map(say), ..self }
    }
}

impl fmt::Display for Refusal {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.reason)
    }
}

impl std::error::Error for Refusal {}
