//! What is amiss with one variant, and by which numbers that variant is known.

use crate::bank::Style;
use crate::expr::print;

/// Something amiss with one variant; of others with the same words only the first is told, and how many there are.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Remark {
    pub(super) what: String,
    pub(super) at: String,
    pub(super) label: String,
    pub(super) help: String,
    pub(super) shown: String,
}

impl Remark {
    /// What it is; what stands in the file at its place; what was expected there; one thing to try.
    pub fn new(what: impl Into<String>, at: impl Into<String>, label: &str, help: impl Into<String>) -> Remark {
        let (what, at, help) = (what.into(), at.into(), help.into());
        Remark { what, at, label: label.to_owned(), help, shown: String::new() }
    }

    /// With what stands on the page of this variant.
    pub fn showing(self, shown: &str) -> Remark {
        Remark { shown: shown.to_owned(), ..self }
    }
}

/// The numbers of a set: `mA = 1, mB = 2`.
pub fn numbers(style: &Style, index: u64) -> String {
    let all = style.parameters_at(index);
    let each = all.iter().map(|(name, value)| format!("{name} = {}", print::plain(value)));
    each.collect::<Vec<_>>().join(", ")
}
