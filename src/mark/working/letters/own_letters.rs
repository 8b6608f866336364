//! Letters that a student brings: told by how the whole working has them.

use std::collections::BTreeSet;

use super::angles::{is_short, tangent_letter};
use super::unknowns::own_unknowns;
use crate::mark::working::lines::{FUNCTIONS, OWN, typed};
use crate::number::Letter;

/// Capitals that a student tells from the question's small letters: `M` where there is an `m` too.
pub(in crate::mark::working) fn own_capitals(working: &[String], letters: &[Letter]) -> Vec<String> {
    let single = |letter: &&Letter| letter.name().len() == 1;
    let is_letter = |sign: char| letters.iter().filter(single).any(|letter| letter.name().starts_with(sign));
    let words = working.iter().flat_map(|line| line.split(|sign: char| !sign.is_alphabetic()));
    let formulas: String = words.filter(|word| word.chars().all(|sign| is_letter(sign.to_ascii_lowercase()))).collect();
    let has_both = |letter: &&Letter| {
        let small = letter.name();
        formulas.contains(small) && formulas.contains(&small.to_ascii_uppercase())
    };
    let both = letters.iter().filter(single).filter(has_both);
    both.map(|letter| letter.name().to_ascii_uppercase())
        .filter(|capital| !letters.iter().any(|letter| letter.name() == *capital))
        .collect()
}

/// Letters with an index that begin a word somewhere, as in `x2 - x1 = 5`: in `3x1 + 2x2` there is no sign of multiplication.
/// Any letter of which there is a first and a second is one, and so is one with a component along x and one along y: `T1` and
/// `T2`, `ux` and `uy`.
pub(in crate::mark::working) fn indexed_letters(working: &[String], letters: &[Letter]) -> Vec<String> {
    let names: BTreeSet<&str> = typed(working).flat_map(names_in).map(|(name, _)| name).collect();
    let is_there = |base: &str, index: &str| names.contains(&*format!("{base}{index}"));
    let usual = OWN.into_iter().filter(|name| name.split_once('_').is_some_and(|(base, index)| is_there(base, index)));
    let mut found: Vec<String> = usual.map(str::to_owned).collect();
    let is_free = |name: &String| !found.contains(name) && letters.iter().all(|own| own.name() != name);
    let counted = ('A'..='Z').chain('a'..='z').map(|letter| (letter.to_string(), ["1", "2"]));
    let of_velocities =
        ["u", "v", "w", "U", "V", "W"].into_iter().flat_map(|letter| ["", "A", "B"].map(|of| format!("{letter}{of}")));
    let pairs = counted.chain(of_velocities.map(|base| (base, ["x", "y"])));
    let pairs = pairs.filter(|(base, indices)| indices.iter().all(|index| is_there(base, index)));
    let named = pairs.flat_map(|(base, indices)| indices.map(|index| format!("{}_{}{index}", &base[..1], &base[1..])));
    let named: Vec<String> = named.filter(is_free).collect();
    found.extend(named);
    found
}

/// The names and numbers of a line, as it parts them, each with what stands behind it.
fn names_in(typed: &str) -> impl Iterator<Item = (&str, &str)> {
    let names = typed.split(|sign: char| !sign.is_alphanumeric() && sign != '_').scan(0, |start, name| {
        let end = *start + name.len();
        *start = end + typed[end..].chars().next().map_or(0, char::len_utf8);
        Some((name, &typed[end..]))
    });
    names.filter(|(name, _)| !name.is_empty())
}

/// Does a letter that an earlier part has explained stand for something else here: is it set equal to something again, or is
/// it one of two unknowns?
pub(in crate::mark::working) fn is_used_anew(letter: &str, working: &[String], letters: &[Letter]) -> bool {
    let is_set = |line| names_in(line).any(|(name, after)| name == letter && after.trim_start().starts_with('='));
    typed(working).any(is_set) || own_unknowns(working, letters).iter().any(|own| own == letter)
}

/// Letters that a student sets equal to a sine, cosine or tangent, or to a component: `let T = tan α`, `k = v cos α`.
pub(in crate::mark::working) fn short_letters(working: &[String], letters: &[Letter]) -> Vec<String> {
    let mut found: Vec<String> = Vec::from_iter(tangent_letter(typed(working), letters));
    for typed in
        working.iter().flat_map(|cell| cell.lines()).filter(|line| FUNCTIONS.iter().any(|name| line.contains(name)))
    {
        let sides: Vec<&str> = typed.split('=').collect();
        for pair in sides.windows(2) {
            let mut before = pair[0].trim_end().chars().rev();
            let (letter, stands_alone) =
                (before.next(), before.next().is_none_or(|sign| !sign.is_alphanumeric() && sign != '_'));
            let value = pair[1].split([',', ';']).next().unwrap_or_default();
            let Some(letter) = letter.filter(|_| stands_alone).map(String::from) else { continue };
            let is_new = letters.iter().all(|own| own.name() != letter) && !found.contains(&letter);
            if is_new && is_short(&letter) && FUNCTIONS.iter().any(|name| value.contains(name)) {
                found.push(letter);
            }
        }
    }
    found
}
