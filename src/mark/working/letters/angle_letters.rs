//! A student's own letters for the question's angles, as keyboards have them: `cos a` for `cos α`.

use std::rc::Rc;

use super::angles::{argument, sides, used};
use crate::expr::Expr;
use crate::mark::working::lines::{Line, ReadLine};
use crate::number::{Letter, Range};

/// Writes the question's angle in the place of a letter that can be nothing else.
///
/// Under a sine, cosine or tangent stands an angle. The letter is that whose name begins with it, `b` for β; else the only
/// angle that is `given` and that the student does not name otherwise. Where such a letter stays unknown while an angle
/// that is given is not named at all, its lines are for a person.
pub(super) fn put_in_place(lines: &mut [Line], letters: &[Letter], given: &dyn Fn(&str) -> bool) {
    let angles: Vec<&str> = letters.iter().filter(|letter| letter.range() == Range::Acute).map(Letter::name).collect();
    if angles.is_empty() {
        return;
    }
    let readings = || lines.iter().flat_map(|line| &line.readings).map(Rc::as_ref);
    let mut under: Vec<String> = readings().flat_map(used).collect();
    under.sort();
    under.dedup();
    let is_named = |angle: &&str| readings().flat_map(sides).flat_map(Expr::names).any(|name| name.text == **angle);
    let mut open: Vec<&str> = angles.iter().filter(|angle| !is_named(angle)).copied().collect();
    // θ may stand for the question's α, but not a letter that is usual for what is to be found.
    let is_other = |name: &String| {
        let may_be_given = name.len() == 1 || matches!(name.as_str(), "alpha" | "theta" | "phi");
        may_be_given && !letters.iter().any(|letter| letter.name() == name)
    };
    let mut unknown: Vec<String> = under.into_iter().filter(is_other).collect();
    if open.is_empty() || unknown.is_empty() {
        return;
    }
    let is_letter = |name: &str| letters.iter().any(|letter| letter.name() == name && letter.range() != Range::Acute);
    // Beside the question's letters a velocity may be called so as well.
    let is_else = |own: &str| {
        readings().flat_map(|reading| &reading.equations).any(|(left, right)| {
            let outside: Vec<&str> = [left, right].into_iter().flat_map(outside).collect();
            outside.contains(&own) && outside.iter().any(|name| is_letter(name))
        })
    };
    let mut known: Vec<(String, String)> = Vec::new();
    unknown.retain(|own| {
        let namesake = open.iter().position(|angle| angle.starts_with(own.as_str())).filter(|_| !is_else(own));
        known.extend(namesake.map(|place| (own.clone(), open.remove(place).to_owned())));
        namesake.is_none()
    });
    let mut nameless = open.iter().filter(|angle| given(angle));
    if let (Some(angle), None, [own]) = (nameless.next(), nameless.next(), unknown.as_slice())
        && !is_else(own)
    {
        known.push((own.clone(), (*angle).to_owned()));
        (open, unknown) = (Vec::new(), Vec::new());
    }
    let greek = |name: &str| known.iter().find(|(own, _)| own == name).map(|(_, angle)| Expr::name(angle.as_str()));
    let is_open = open.iter().any(|angle| given(angle));
    for line in lines {
        let is_unknown = |reading: &ReadLine| used(reading).iter().any(|name| unknown.contains(name));
        if is_open && line.readings.iter().any(|reading| is_unknown(reading)) {
            line.readings.clear();
        }
        let has_own =
            |reading: &&mut ReadLine| sides(reading).flat_map(Expr::names).any(|name| greek(&name.text).is_some());
        line.readings_mut().filter(has_own).for_each(|reading| *reading = reading.in_letters(&greek));
    }
}

/// The names in a formula that do not stand under a sine, cosine or tangent.
fn outside(expr: &Expr) -> Vec<&str> {
    match (expr, argument(expr)) {
        (_, Some(_)) => Vec::new(),
        (Expr::Name(name), _) => vec![&name.text],
        _ => expr.children().into_iter().flat_map(outside).collect(),
    }
}
