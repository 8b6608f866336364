//! Letters that a student brings, and numbers that stand for something: what each of them is.

mod angle_letters;
mod angles;
mod components;
mod own_letters;
mod radians;
mod signs;
mod slipped;
mod squares;
mod unknowns;
mod wrong_angle;

pub(super) use angles::is_short;
pub(super) use components::whole;
pub(super) use own_letters::{indexed_letters, is_used_anew, own_capitals, short_letters};
pub(super) use signs::with_signs;
pub(super) use slipped::{Slip, false_number, undone};
pub(super) use squares::squared;
pub(super) use unknowns::own_unknowns;

use super::lines::Line;
use super::prepared::Prepared;
use crate::expr::Expr;
use crate::number::Letter;

/// Puts in their place what letters and radians of the student's own stand for, where that is an angle of the question.
///
/// Letters that an earlier part has explained stand for the same here; those of this part are added to them.
pub(super) fn put_in_place(
    lines: &mut [Line],
    letters: &[Letter],
    explained: &mut Vec<(String, Expr)>,
    prepared: &Prepared,
) {
    radians::put_in_place(lines, prepared);
    angle_letters::put_in_place(lines, letters, &|angle| prepared.points.letter(angle, 0).is_some());
    angles::put_in_place(lines, letters, explained, prepared);
}
