//! A name that is no quantity of the collision: which was meant, or which there are.

use super::super::document::Faults;
use super::super::literal::Words;
use crate::mechanics::name_meant;

/// Reports a quantity that does not exist; `others` are names that may stand there too.
pub fn unknown(words: &Words, others: &[String], faults: &mut Faults) {
    unknown_at(words.span(), "quantity", words.get_ref(), others, faults);
}

/// As [`unknown`], at a place within a text; `what` is what the name was to be.
pub fn unknown_at(span: std::ops::Range<usize>, what: &str, name: &str, others: &[String], faults: &mut Faults) {
    let (label, help) = name_meant(name, others);
    faults.report(span, format!("unknown {what} `{name}`"), label, help);
}
