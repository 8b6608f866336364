//! What is found of one value before the report is written.

use super::{Note, Verdict};

/// A verdict on one value.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Finding {
    pub(super) verdict: Verdict,
    pub(super) note: Option<Note>,
    /// Is it right without any rounding? Then what follows it is ignored.
    pub(super) exact: bool,
}

impl Finding {
    pub(super) const EXACT: Finding = Finding { verdict: Verdict::Correct, note: None, exact: true };
    pub(super) const WRONG: Finding = Finding { verdict: Verdict::Wrong, note: None, exact: false };

    pub(super) fn correct(note: Option<Note>) -> Finding {
        Finding { verdict: Verdict::Correct, note, exact: false }
    }

    pub(super) fn partial(note: Note) -> Finding {
        Finding { verdict: Verdict::Partial, note: Some(note), exact: false }
    }

    pub(super) fn wrong(note: Note) -> Finding {
        Finding { verdict: Verdict::Wrong, note: Some(note), exact: false }
    }

    pub(super) fn unreadable(note: Note) -> Finding {
        Finding { verdict: Verdict::Unreadable, note: Some(note), exact: false }
    }

    pub(super) fn is_correct(&self) -> bool {
        self.verdict == Verdict::Correct
    }

    /// Did it earn anything?
    pub(super) fn is_credited(&self) -> bool {
        matches!(self.verdict, Verdict::Correct | Verdict::Partial)
    }

    /// A right value becomes partly right for this reason; anything else stays.
    pub(super) fn spoilt_by(self, note: Note) -> Finding {
        if self.is_correct() { Finding::partial(note) } else { self }
    }

    /// A right value keeps its credit, with a remark unless it has one.
    pub(super) fn remarked(self, note: Note) -> Finding {
        if self.is_correct() { Finding { note: self.note.or(Some(note)), ..self } } else { self }
    }

    /// A credited value is worth no more than partial, for this reason.
    pub(super) fn at_most_partial(self, note: Note) -> Finding {
        if self.is_credited() { Finding::partial(note) } else { self }
    }

    /// The better of two; the first if they are equal.
    pub(super) fn or_better(self, other: Finding) -> Finding {
        if other.rank() > self.rank() { other } else { self }
    }

    /// Both are needed, as the components of a vector are: the worse of two.
    pub(super) fn and(self, other: Finding) -> Finding {
        let worse = if other.rank() < self.rank() { other } else { self };
        Finding { note: worse.note.or(self.note).or(other.note), exact: self.exact && other.exact, ..worse }
    }

    fn rank(&self) -> u8 {
        match self.verdict {
            Verdict::Correct => 4,
            Verdict::Partial => 3,
            Verdict::Unreadable => 2,
            Verdict::Wrong => 1,
            Verdict::Blank => 0,
        }
    }
}
