//! What numbers that hide a slip have in common: a requirement that turns them away shows it.
//!
//! A slip hides where something is nought, or equal to something else: with *A* stopped along the line of centres the
//! speed of separation is the sum of both speeds as well as their difference. Each [`CANDIDATES`] is such a
//! coincidence, written as the requirement that there is none.

use std::cmp::Reverse;
use std::collections::BTreeMap;

use super::shows::Slips;
use crate::bank::{Opened, Question, Requirement, Style};
use crate::generate::{Deal, Variant};
use crate::mechanics::{Quantity, Slip};

/// So many variants of a style are looked at.
const MOST: usize = 600;

/// What an author may require, the plainest first.
const CANDIDATES: [&str; 23] = [
    "A.mass != B.mass",
    "e != 1",
    "e != 0",
    "A.before.n != 0",
    "B.before.n != 0",
    "A.before.t != 0",
    "B.before.t != 0",
    "A.after.n != 0",
    "B.after.n != 0",
    "A.before.speed != B.before.speed",
    "A.after.speed != B.after.speed",
    "abs(A.before.n) != abs(B.before.n)",
    "abs(A.after.n) != abs(B.after.n)",
    "abs(A.after.n) != abs(A.before.n)",
    "abs(A.before.n) != abs(A.before.t)",
    "abs(B.before.n) != abs(B.before.t)",
    "abs(A.after.n) != abs(A.after.t)",
    "A.after.n > 0",
    "A.after.n < 0",
    "B.after.n > 0",
    "B.after.n < 0",
    "B.before.n > 0",
    "B.before.n < 0",
];

/// Requirements for the author to add.
#[derive(Default)]
pub struct Wanted {
    texts: Vec<&'static str>,
    /// The slips that show in all that they leave, and did not in all.
    pub shows: Vec<&'static str>,
    /// How many variants they leave, and of how many.
    left: (usize, usize),
    /// Are those all that there are?
    are_all: bool,
}

impl Wanted {
    /// What to add to `require`, and what that costs; nothing if nothing is wanted.
    pub fn in_words(&self) -> Option<String> {
        let (last, others) = self.texts.split_last()?;
        let others: Vec<String> = others.iter().map(|text| format!("`\"{text}\"`")).collect();
        let and = if others.is_empty() { String::new() } else { format!("{} and ", others.join(", ")) };
        let (left, all) = self.left;
        let leave = if others.is_empty() { "leaves" } else { "leave" };
        let of = if self.are_all { format!("{all} variants") } else { format!("the {all} variants that were tried") };
        Some(format!("add {and}`\"{last}\"` to `require`, which {leave} {left} of {of}"))
    }
}

/// A variant: which candidates it does not meet, and which slips do not show in it.
struct Seen {
    unmet: Vec<bool>,
    hidden: Vec<&'static str>,
}

/// Requirements that show some of these slips, as many as leave at least half of the variants together.
pub fn wanted(question: &Question, acting: u128, tags: &[&'static str]) -> Wanted {
    let requirements: Vec<Requirement> =
        CANDIDATES.iter().filter_map(|candidate| Requirement::read(candidate).ok()).collect();
    let mut are_all = true;
    let mut seen = Vec::new();
    for style in &question.styles {
        let variants = variants(question, style, acting, &requirements);
        are_all &= variants.len() < MOST;
        seen.extend(variants);
    }
    let lost = |candidates: &[usize]| {
        let is_lost = |variant: &&Seen| candidates.iter().any(|candidate| variant.unmet[*candidate]);
        seen.iter().filter(is_lost).count()
    };
    let leaves_half = |candidates: &[usize]| 2 * lost(candidates) <= seen.len();
    let explains = |candidate: usize, tag: &str| {
        let mut hiding = seen.iter().filter(|variant| variant.hidden.contains(&tag)).peekable();
        hiding.peek().is_some() && hiding.all(|variant| variant.unmet[candidate])
    };
    let losses: Vec<usize> = (0..requirements.len()).map(|candidate| lost(&[candidate])).collect();
    // For each slip the requirement that costs least; those that show most slips come first.
    let mut chosen: BTreeMap<usize, usize> = BTreeMap::new();
    for tag in tags {
        let may_be =
            (0..requirements.len()).filter(|candidate| explains(*candidate, tag) && leaves_half(&[*candidate]));
        if let Some(candidate) = may_be.min_by_key(|candidate| losses[*candidate]) {
            *chosen.entry(candidate).or_default() += 1;
        }
    }
    let mut by_slips: Vec<(usize, usize)> = chosen.into_iter().collect();
    by_slips.sort_by_key(|(_, slips)| Reverse(*slips));
    let mut taken: Vec<usize> = Vec::new();
    for (candidate, _) in by_slips {
        taken.push(candidate);
        if !leaves_half(&taken) {
            taken.pop();
        }
    }
    // `A.after.n < 0` makes `A.after.n != 0` needless.
    let is_needless =
        |one: usize, other: usize| one != other && losses[one] < losses[other] && lost(&[one, other]) == losses[other];
    let kept: Vec<usize> =
        taken.iter().copied().filter(|one| !taken.iter().any(|other| is_needless(*one, *other))).collect();
    let is_shown = |tag: &&str| kept.iter().any(|candidate| explains(*candidate, tag));
    Wanted {
        texts: kept.iter().map(|candidate| CANDIDATES[*candidate]).collect(),
        shows: Slip::all().iter().map(|(_, slip)| slip.tag).filter(is_shown).collect(),
        left: (seen.len() - lost(&kept), seen.len()),
        are_all,
    }
}

/// Variants from anywhere in the style, or all of them.
fn variants(question: &Question, style: &Style, acting: u128, requirements: &[Requirement]) -> Vec<Seen> {
    let is_given = |name: &str| question.is_given(style, name);
    let named = requirements.iter().flat_map(|requirement| requirement.quantities(&is_given));
    let wanted: Vec<Quantity> = question.wanted(style).into_iter().chain(named).collect();
    let look = |variant: Variant| {
        let mut slips = Slips::default();
        slips.follow(question, &variant);
        let opened = Opened::new(question, variant.givens.clone()).ok()?;
        let posed = opened.as_far_as_determined(&wanted).ok()??;
        let is_unmet = |requirement: &Requirement| requirement.holds(&|name| posed.meaning(name)) == Ok(false);
        let hidden = slips.hidden(acting).into_iter().map(|(tag, ..)| tag).collect();
        Some(Seen { unmet: requirements.iter().map(is_unmet).collect(), hidden })
    };
    Deal::new(question, style, 1).take(MOST).filter_map(look).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::examine::{Edits, edited};

    #[test]
    fn what_is_proposed_shows_the_slip() {
        let (rest, wall) = ("rest/speeds-and-directions", "walls/rebound-speed-and-direction");
        let table: [(&str, Edits, &str, &[&str]); 4] = [
            (rest, &[("  \"mA != mB\",\n", "")], "masses-swapped", &["A.mass != B.mass"]),
            (
                rest,
                &[("alpha = [\"30\", \"60\"]", "alpha = [\"30\", \"45\", \"60\"]")],
                "sincos-swap",
                &["abs(A.before.n) != abs(A.before.t)"],
            ),
            // Nothing that is required of other numbers shows a slip that acts nowhere.
            (rest, &[], "wall-axis-swap", &[]),
            (wall, &[], "masses-swapped", &[]),
        ];
        for (id, edits, tag, expected) in table {
            let question = edited(id, edits);
            let found = wanted(&question, u128::MAX, &[tag]);
            assert_eq!(found.texts, expected, "{id}: {tag}");
            assert_eq!(found.shows.contains(&tag), !expected.is_empty(), "{id}: {tag}");
            assert!(2 * found.left.0 >= found.left.1, "{id}: {:?}", found.left);
        }
    }
}
