//! What `carom check` calls an error in the questions of a sheet, said while there is still time.

use std::collections::BTreeMap;
use std::path::Path;

use super::super::output::say;
use crate::bank::{Question, StyleName};
use crate::examine::glance;
use crate::generate::reference;
use crate::paper::Dealer;

/// Says what is amiss with questions of a bank of one's own, as one variant of each shows it: the first of the seed, or the
/// reference numbers where there is none. The shipped bank has been checked.
pub(super) fn tell(
    bank: Option<&Path>,
    questions: &BTreeMap<&str, Question>,
    seed: Option<u64>,
    style: Option<StyleName>,
) {
    let Some(bank) = bank else { return };
    let mut is_sound = true;
    for (id, question) in questions {
        let variant = match seed {
            Some(seed) => Dealer::new(seed, style).next(question),
            None => reference(question).ok(),
        };
        for finding in variant.iter().flat_map(|variant| glance(question, variant)) {
            say(&format!("error: `{id}`: {}", finding.message));
            is_sound = false;
        }
    }
    if !is_sound {
        let bank = bank.display().to_string();
        let bank = if bank.contains(' ') { format!("\"{bank}\"") } else { bank };
        say(&format!(
            "`carom check {bank}` says where each stands and what to try; the sheet is made with the questions as they are"
        ));
    }
}
