//! Momentum and restitution along the line of centres: which of them a line is, and how it departs from it.

mod added_up;
mod agreement;
mod another_e;
mod apiece;
mod brackets_lost;
mod changed;
mod convention;
mod conventions;
mod critical;
mod departure;
mod elastic;
mod misread;
mod offered;
mod own_pair;
mod pair;
mod shown_e;
mod solved;
mod substituted;
mod terms;
mod told_apart;
mod trials;
mod two_lines;
mod unlike;
mod unusual;

pub(super) use convention::{is_value, take_as_laws};
pub(super) use conventions::{Convention, sphere};
pub(super) use critical::Critical;
pub(super) use departure::Departure;
pub(in crate::mark) use misread::Misread;
pub(super) use misread::{given_numbers, numbers};
pub(super) use offered::differences;
pub(super) use pair::{BOTH, Laws, Matched};
pub(super) use shown_e::line_shows_e;
pub(super) use terms::ByNumbers;
