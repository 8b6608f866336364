//! What a line shows of a mark.

use crate::mark::award::Ground;

/// What a line shows of a mark.
pub(super) struct Evidence {
    /// The place of the line.
    pub(super) line: usize,
    pub(super) given: bool,
    pub(super) note: Option<&'static str>,
    pub(super) feedback: String,
    /// What the line is.
    pub(super) role: String,
}

impl Evidence {
    pub(super) fn given(line: usize, role: impl Into<String>) -> Evidence {
        Evidence { line, given: true, note: None, feedback: String::new(), role: role.into() }
    }

    pub(super) fn followed(line: usize, role: impl Into<String>) -> Evidence {
        let feedback = "followed through from your own values".to_owned();
        Evidence { note: Some(Ground::FollowThrough.tag()), feedback, ..Evidence::given(line, role) }
    }
}
