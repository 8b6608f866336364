//! What is amiss with one variant, and by which numbers that variant is known.

use super::finding::Finding;
use crate::bank::Style;
use crate::expr::print;

/// How much it counts that something is amiss with one variant.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Weight {
    /// It must be mended.
    Error,
    /// It may be meant.
    Warning,
    /// It may be, and of a few variants nobody need hear.
    InNearlyAll,
}

/// Something amiss with one variant; of others with the same words only the first is told, and how many there are.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Remark {
    pub(super) what: String,
    pub(super) at: String,
    /// Or the key of the style.
    pub(super) key: Option<&'static str>,
    pub(super) label: String,
    pub(super) help: String,
    pub(super) shown: String,
    pub(super) weight: Weight,
    /// One thing to try where all variants have it, and no requirement could keep one without; empty if it is the same.
    pub(super) help_for_all: &'static str,
}

impl Remark {
    /// What it is; what stands in the file at its place; what was expected there; one thing to try.
    pub fn new(what: impl Into<String>, at: impl Into<String>, label: &str, help: impl Into<String>) -> Remark {
        let (what, at, help) = (what.into(), at.into(), help.into());
        let (label, shown, weight) = (label.to_owned(), String::new(), Weight::Error);
        Remark { what, at, key: None, label, help, shown, weight, help_for_all: "" }
    }

    /// At a key of the style.
    pub fn at_key(self, key: &'static str) -> Remark {
        Remark { key: Some(key), ..self }
    }

    /// As one that stops nothing.
    pub fn warning(self) -> Remark {
        Remark { weight: Weight::Warning, ..self }
    }

    /// As one that stops nothing, and is told only where nearly all variants have it.
    pub fn of_nearly_all(self) -> Remark {
        Remark { weight: Weight::InNearlyAll, ..self }
    }

    /// With another thing to try where no variant is without it.
    pub fn with_help_for_all(self, help: &'static str) -> Remark {
        Remark { help_for_all: help, ..self }
    }

    /// As it is told of one variant by itself, with its numbers, if they are some of its style.
    pub fn in_variant(&self, style: &Style, index: Option<u64>) -> Finding {
        let shown = if self.shown.is_empty() { String::new() } else { format!(": `{}`", self.shown) };
        let with = index.map_or_else(String::new, |index| format!(", with {}", numbers(style, index)));
        let found = Finding::new(format!("{}{shown}{with}", self.what), self.at.as_str(), self.label.as_str());
        let found =
            self.key.iter().fold(found, |found, key| found.at_key(style.name, key)).with_help(self.help.as_str());
        if self.weight == Weight::Error { found } else { found.as_warning() }
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
