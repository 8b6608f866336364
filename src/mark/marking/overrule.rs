//! A person's word on single marks, and what follows from it for the marks that depend on them.

use super::decide::settled;
use crate::mark::award::{Examiner, MarkedPart};
use crate::mark::key::KeyedPart;

/// A person's word on one mark of a part.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Word {
    /// The place of the mark in the scheme.
    pub mark: usize,
    /// Is it given?
    pub given: bool,
    /// Why; may be empty.
    pub comment: String,
}

/// Gives and withholds marks as a person says; of several words on the same mark the last counts.
///
/// Dependent marks follow: one that was withheld only for want of a mark that is given now is given too, and one falls
/// with the mark on which it depends. A mark on which a person has spoken is as that person says.
pub fn overrule(part: &KeyedPart, marked: &mut MarkedPart, words: &[Word]) {
    for word in words {
        let Some(award) = marked.found.get_mut(word.mark) else { continue };
        award.given = word.given;
        award.by = Examiner::Person;
        award.note = None;
        award.feedback = word.comment.clone();
    }
    marked.awards = settled(part, &marked.answers, &marked.found);
}
