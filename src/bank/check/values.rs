//! Values of parameters that no collision has: whatever else is dealt, they would be dealt in vain.

use super::super::document::Faults;
use super::super::domain::Domain;
use super::super::file::{DomainFile, QuestionFile};
use super::super::literal::Words;
use super::super::scene_file::SceneFile;
use crate::expr::{Angles, number, print, read};
use crate::number::{Fraction, Value};

/// The most values of a range that are looked at one by one.
const MOST_VALUES: u64 = 1000;

/// Reports masses that are not above nought, and coefficients of restitution that are not from 0 to 1.
pub fn values(file: &QuestionFile, faults: &mut Faults) {
    let Some(scene) = &file.scene else { return };
    let own = file.styles.iter().flat_map(|style| &style.parameters);
    for (name, domain) in file.parameters.iter().chain(own) {
        let Some((is_possible, what)) = limits(name.get_ref(), scene) else { continue };
        let wrong = |value: &Value| value.as_fraction().is_some_and(|value| !is_possible(value));
        let Some((words, value)) = first(domain, &wrong) else { continue };
        let message = format!("`{}` may be {value}, and {what}", name.get_ref());
        let help = "take the value out; perhaps its fraction stands on its head, or its sign is wrong";
        faults.report(words.span(), message, "every value is to be possible", help);
    }
}

type Limits = (fn(&Fraction) -> bool, &'static str);

/// What a number must be that the scene takes as it is.
fn limits(name: &str, scene: &SceneFile) -> Option<Limits> {
    let scene = &scene.text;
    let is = |given: Option<&String>| given.is_some_and(|given| given.trim() == name);
    if is(scene.e.as_ref()) || scene.then.iter().any(|then| is(then.e.as_ref())) {
        let what = "a coefficient of restitution is from 0 to 1: no impact has another";
        return Some((|e| !e.sign().is_lt() && *e <= Fraction::ONE, what));
    }
    let masses = [scene.masses.a.as_ref(), scene.masses.b.as_ref()];
    let is_mass = masses.into_iter().any(is) || scene.then.iter().any(|then| is(then.mass.as_ref()));
    is_mass.then_some((|mass| mass.sign().is_gt(), "a mass is above nought: no sphere has another"))
}

/// The first value of a domain that is wrong, and where it stands.
fn first<'f>(domain: &'f DomainFile, wrong: &dyn Fn(&Value) -> bool) -> Option<(&'f Words, String)> {
    let one = |words: &'f Words, expr| {
        let value = number(&expr, &|_| None).ok().filter(|value| wrong(value));
        value.map(|_| (words, print::unicode(&expr)))
    };
    match domain {
        DomainFile::List(items, _) => {
            items.iter().find_map(|words| one(words, read(words.get_ref(), Angles::Degrees).ok()?))
        }
        DomainFile::Range(words) => {
            let domain = Domain::range(words.get_ref()).ok()?;
            (0..domain.size().min(MOST_VALUES)).find_map(|index| one(words, domain.value(index)))
        }
    }
}
