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
    /// Is it of a later impact, and in the words of that one?
    is_of_later: bool,
}

impl Refusal {
    fn new(because: Because, reason: String) -> Refusal {
        Refusal { because, reason, help: None, is_of_later: false }
    }

    /// A scene that cannot happen.
    pub fn impossible(reason: impl Into<String>) -> Refusal {
        Refusal::new(Because::Impossible, reason.into())
    }

    /// A scene that leaves something open.
    pub fn underdetermined(reason: impl Into<String>) -> Refusal {
        Refusal::new(Because::Underdetermined, reason.into())
    }

    /// A scene that needs more than the exam's methods.
    pub fn beyond(reason: impl Into<String>) -> Refusal {
        Refusal::new(Because::BeyondMethods, reason.into())
    }

    /// A later impact that cannot happen, said of the spheres by their own names.
    pub(super) fn impossible_at(meeting: Meeting, reason: &str) -> Refusal {
        let reason = format!("at the {} impact: {reason}", ordinal(meeting.number));
        Refusal { is_of_later: true, ..Refusal::impossible(reason) }
    }

    /// The refusal of a later impact, said of who has the parts of A and B there.
    pub(super) fn at(self, meeting: Meeting) -> Refusal {
        if self.is_of_later {
            return self;
        }
        let said = if meeting.with_wall { self.said_of(Setting::Wall) } else { self };
        let reason = format!("at the {} impact: {}", ordinal(meeting.number), meeting.in_words(&said.reason));
        Refusal { reason, is_of_later: true, ..said }
    }

    /// The refusal with one thing to try.
    pub fn try_this(mut self, help: impl Into<String>) -> Refusal {
        self.help = Some(help.into());
        self
    }

    /// The same refusal in the words of the setting of the first impact, if it is of that one.
    pub fn said_of(self, setting: Setting) -> Refusal {
        if self.is_of_later {
            return self;
        }
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
