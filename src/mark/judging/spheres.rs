//! The spheres that names are the names of: `A`, `v_B`, `vb`, `speed of A`.

use std::borrow::Cow;

use crate::expr::Expr;
use crate::mark::reading::{Label, Reading, Statement};
use crate::mechanics::{Quantity, Sphere};

use super::Model;
use super::letters::of_letter;
use super::otherwise::spheres_in_remark;
use super::sorts::{Sort, sort, words};

/// All that can take part in an impact.
pub(super) const SPHERES: [Sphere; 3] = [Sphere::A, Sphere::B, Sphere::C];

/// The sphere that a quantity is one of.
pub(super) fn sphere(quantity: Quantity) -> Option<Sphere> {
    let name = quantity.to_string();
    let first = name.split('.').next()?;
    SPHERES.into_iter().find(|sphere| sphere.name() == first)
}

/// Does it belong to two spheres together, so that no name of one alone is its name?
pub(super) fn takes_two(quantity: Quantity) -> bool {
    matches!(quantity.of_its_impact(), Quantity::AngleBetween(_) | Quantity::Approach | Quantity::Separation)
}

/// The sphere that a label names: `A`, `v_B`, `speed of A`.
pub(super) fn named_sphere(statement: &Statement) -> Option<Sphere> {
    let named = named_spheres(&statement.label.as_ref()?.typed);
    let first = named.first().copied()?;
    named.iter().all(|other| *other == first).then_some(first)
}

/// Is a letter that of the other sphere than is asked, by its name, or by the custom that v is of *A* and w of *B*?
pub(super) fn is_of_the_other_by_custom(model: &Model, letter: &str) -> bool {
    let asked = model.quantity.and_then(sphere);
    let by_custom = match letter {
        "v" | "v1" | "v_1" => Some(Sphere::A),
        "w" | "v2" | "v_2" => Some(Sphere::B),
        _ => named_spheres(letter).first().copied(),
    };
    asked.zip(by_custom).is_some_and(|(asked, named)| asked != named)
}

/// The spheres that a text names, in order: `m_B : m_A`, `mA/mB`, `A to B`, `va`.
pub(in crate::mark) fn named_spheres(typed: &str) -> Vec<Sphere> {
    let words: Vec<&str> = words_without_commands(typed).collect();
    let named = words.iter().enumerate().filter_map(|(at, word)| {
        let before = at.checked_sub(1).map(|before| words[before]);
        let after = words.get(at + 1).copied();
        SPHERES.into_iter().find(|sphere| {
            let small = sphere.name().to_lowercase();
            *word == sphere.name()
                || is_small_name(word, &small, before, after)
                || word.strip_suffix(sphere.name()).is_some_and(|stem| is_stem(stem) || is_letter_of_subject(stem))
                || word.strip_suffix(&*small).is_some_and(is_stem)
        })
    });
    named.collect()
}

/// `A and B have speeds 2 and 3`, `2 and 3 for A and B respectively`: as many values as spheres, each of them its own.
pub(super) fn each_to_its_own(reading: &Reading) -> Cow<'_, Reading> {
    let statements = &reading.statements;
    let Some(last) = statements.len().checked_sub(1).filter(|last| *last > 0) else { return Cow::Borrowed(reading) };
    let named = |at: usize| together(&statements[at]).filter(|spheres| spheres.len() == statements.len());
    let is_alone = |at: usize| statements.iter().enumerate().all(|(other, one)| other == at || one.label.is_none());
    let Some(spheres) = [0, last].into_iter().filter(|at| is_alone(*at)).find_map(named) else {
        return Cow::Borrowed(reading);
    };
    let mut shared = reading.clone();
    for (statement, sphere) in shared.statements.iter_mut().zip(spheres) {
        statement.label = Some(Label { typed: sphere.name().to_owned(), expr: None });
        statement.said.iter_mut().for_each(|said| said.remarks.clear());
    }
    Cow::Owned(shared)
}

/// Is one value said of several spheres: `A and B both 2.78`, `2.78 each`?
pub(super) fn is_of_several(statement: &Statement) -> bool {
    const EACH: [&str; 8] = ["both", "each", "for", "of", "them", "the", "spheres", ""];
    let says_each = |remark: &String| {
        words(remark).any(|word| matches!(word, "both" | "each")) && words(remark).all(|word| EACH.contains(&word))
    };
    together(statement).is_some() || statement.remarks().any(says_each)
}

/// Is a sphere named, by the name of a value or beside it?
pub(super) fn names_any(statement: &Statement) -> bool {
    let mut remarks = statement.remarks();
    named_sphere(statement).is_some() || remarks.any(|remark| !spheres_in_remark(remark).is_empty())
}

/// `A, B = 2.78, 3.08`: is one sphere the name of the first of two values, and another said beside the second?
pub(super) fn are_mixed_up(reading: &Reading) -> bool {
    let [first, second @ Statement { label: None, .. }] = reading.statements.as_slice() else { return false };
    let Some(named) = named_sphere(first) else { return false };
    let is_other = |remark: &String| {
        let joins = |word: &str| matches!(word, "a" | "b" | "c" | "and" | "then" | "");
        words(remark).all(joins)
            && words(remark)
                .any(|word| SPHERES.iter().any(|sphere| *sphere != named && sphere.name().to_lowercase() == word))
    };
    second.remarks().any(is_other)
}

/// The spheres that are named together, by the name of a value or by `for A and B` beside it.
fn together(statement: &Statement) -> Option<Vec<Sphere>> {
    let label = statement.label.as_ref()?;
    let joined = |between: &str| matches!(between.trim(), "and" | "&" | ",");
    let is_list = SPHERES.iter().any(|first| {
        let parts = label.typed.split_once(first.name());
        parts.is_some_and(|(_, after)| {
            SPHERES.iter().filter_map(|next| after.split_once(next.name())).any(|(between, _)| joined(between))
        })
    });
    let remarks = || statement.remarks();
    let is_for = || remarks().any(|remark| remark.starts_with("for "));
    let spheres = match is_list {
        true => named_spheres(&label.typed),
        false if is_for() => remarks().flat_map(|remark| spheres_in_remark(remark)).collect(),
        false => return None,
    };
    let is_once = |sphere: &Sphere| spheres.iter().filter(|other| *other == sphere).count() == 1;
    (spheres.len() > 1 && spheres.iter().all(is_once)).then_some(spheres)
}

/// A small letter names a sphere after the name of a quantity, as in `v_b`, or after words such as `of`. An `a` with a word
/// after it is an article.
fn is_small_name(word: &str, small: &str, before: Option<&str>, after: Option<&str>) -> bool {
    const BEFORE: [&str; 8] = ["of", "for", "by", "on", "sphere", "ball", "particle", "disc"];
    let leads = |before: &str| is_stem(before) || BEFORE.contains(&before.to_lowercase().as_str());
    let ends = || after.is_none_or(|after| matches!(after, "to" | "after" | "before"));
    word == small && before.is_some_and(leads) && (small != "a" || ends())
}

/// What a sphere can be the subscript of: `v`, `V`, `theta`, `speed`, but no sphere.
fn is_stem(stem: &str) -> bool {
    let is_letter = stem.chars().count() == 1 && stem.starts_with(char::is_alphabetic);
    let is_angle = || of_letter(&stem.to_lowercase()) == Some(Sort::Angle);
    sort(stem).is_some() || is_angle() || (is_letter && !ends_in_sphere(stem))
}

/// `vf` in `vfA`
fn is_letter_of_subject(stem: &str) -> bool {
    of_letter(stem).is_some() && !ends_in_sphere(stem)
}

fn ends_in_sphere(stem: &str) -> bool {
    stem.ends_with(['A', 'B', 'C', 'a', 'b', 'c'])
}

/// The words of a label; the commands of LaTeX are none.
pub(super) fn words_without_commands(typed: &str) -> impl Iterator<Item = &str> {
    let pieces = typed.split_inclusive(|letter: char| !letter.is_alphanumeric());
    let after_stroke = std::iter::once(false).chain(pieces.clone().map(|piece| piece.ends_with('\\')));
    let plain = pieces.zip(after_stroke).filter(|(_, is_command)| !is_command);
    plain.flat_map(|(piece, _)| words(piece)).filter(|word| !word.is_empty())
}

/// What names have in common of which only a person knows which is meant: `v1` and `v2`, `v` and `w`, `x` and `y`, `speed 1`
/// and `speed 2`. A u is what there was before, and has no fellows.
pub(super) fn family(label: &Label) -> Option<String> {
    let name = match &label.expr {
        Some(Expr::Name(name)) => name.text.as_str(),
        _ => label.typed.trim(),
    };
    if name.starts_with(['u', 'U']) {
        return None;
    }
    let is_letter = name.chars().count() == 1;
    if let Some(sort) = of_letter(name) {
        return Some(format!("{sort:?} {is_letter}"));
    }
    let words: Vec<&str> = words_without_commands(name).collect();
    match words.as_slice() {
        [_] if is_letter => Some("own".to_owned()),
        [stem @ .., last] if !stem.is_empty() && last.chars().count() == 1 => Some(stem.join(" ").to_lowercase()),
        _ => None,
    }
}
