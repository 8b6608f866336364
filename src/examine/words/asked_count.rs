//! Do the answers of a part number as many as its words ask for? One of each sphere, one more thing, nothing beyond it.

use super::asked_for::sphere_of;
use super::sentence::{Sentence, Token, is_one_of, says};
use crate::answer::Kind;
use crate::bank::{Answer, Find, Part};
use crate::examine::Finding;
use crate::expr::{Expr, print};
use crate::mechanics::{Quantity, Sphere};
use crate::unit::Unit;

/// Answers that are missing or that nobody is asked for, each with the place of an answer of the part.
pub(super) fn otherwise(part: &Part, asked: &[Sentence]) -> Vec<(usize, Finding)> {
    let of_each = one_of_each(part, asked).map(|found| (0, found.as_warning()));
    let also = also_asked(part, asked).map(|found| (0, found));
    let more = more_than_asked(part, asked).map(|(row, found)| (row, found.as_warning()));
    of_each.into_iter().chain(also).chain(more).collect()
}

/// Words for what is stated in a unit, each in the singular and in the plural.
const STATED: [(Unit, &[&str], &[&str]); 5] = [
    (Unit::MetrePerSecond, &["speed", "velocity", "component"], &["speeds", "velocities", "components"]),
    (
        Unit::Degree,
        &["angle", "direction", "deflection", "inclination", "bearing"],
        &["angles", "directions", "deflections"],
    ),
    (Unit::Joule, &["energy", "loss"], &["energies", "losses"]),
    (Unit::NewtonSecond, &["impulse", "momentum"], &["impulses", "momenta"]),
    (Unit::Kilogram, &["mass"], &["masses"]),
];

/// One thing is asked for, and several answers are such things: the last of them is in nobody's mind.
fn more_than_asked(part: &Part, asked: &[Sentence]) -> Option<(usize, Finding)> {
    const OF_SEVERAL: [&str; 7] = ["each", "both", "their", "respectively", "all", "two", "other"];
    let all = || asked.iter().flatten();
    let spheres = Sphere::ALL.into_iter().filter(|sphere| all().any(|token| *token == Token::Sphere(*sphere))).count();
    let are_two_times = ["before", "after"].iter().all(|time| all().any(|token| is_one_of(token, &[time])));
    if spheres > 1 || are_two_times || all().any(|token| is_one_of(token, &OF_SEVERAL)) {
        return None;
    }
    let unit = |answer: &Answer| match &answer.find {
        _ if answer.kind == Kind::Shown => Unit::None,
        Find::Quantity(quantity) | Find::Vector(quantity, _) => quantity.unit(),
        _ if answer.kind == Kind::Angle => Unit::Degree,
        _ => Unit::None,
    };
    STATED.iter().find_map(|(stated, one, several)| {
        let count = |words: &[&str]| all().filter(|token| is_one_of(token, words)).count();
        let is_letter = |token: &&Token| matches!(token, Token::Number(Expr::Name(_) | Expr::Call(..), ..));
        let letters = all().filter(is_letter).count();
        let own = part.answers.iter().enumerate().filter(|(_, answer)| unit(answer) == *stated);
        let own: Vec<(usize, &Answer)> = own.collect();
        let is_more = count(one) > 0 && own.len() > count(one) + letters && count(several) == 0;
        let (row, last) = own.last().filter(|_| is_more)?;
        let (name, stated) = (print::text_unicode(&last.name), stated.plain());
        let asked = count(one) + letters;
        let plural = if asked == 1 { "" } else { "s" };
        let message = format!(
            "the words ask for {asked} answer{plural} in {stated}, and the part has {}, `{name}` the last of them",
            own.len()
        );
        let help = "ask for it in words of its own, or take the answer out";
        Some((*row, Finding::new(message, "", "nobody is asked for it").with_help(help)))
    })
}

/// Of each sphere something is asked for, and of one there is no such answer.
fn one_of_each(part: &Part, asked: &[Sentence]) -> Option<Finding> {
    const MOTIONS: [&str; 6] = ["speed", "speeds", "velocity", "velocities", "direction", "directions"];
    let of_each = |sentence: &Sentence| {
        let at = sentence.windows(2).position(|pair| {
            (is_one_of(&pair[0], &["each"]) && is_one_of(&pair[1], &["sphere"]))
                || (is_one_of(&pair[0], &["both"]) && is_one_of(&pair[1], &["spheres"]))
        });
        at.is_some_and(|at| says(&sentence[..at], &MOTIONS)) && !says(sentence, &["given"])
    };
    if !asked.iter().any(of_each) || part.answers.iter().any(|answer| answer.kind == Kind::Shown) {
        return None;
    }
    let kind = |answer: &Answer| match answer.find.quantities().first().map(|quantity| quantity.of_its_impact()) {
        Some(Quantity::Speed(..)) => Some("speed"),
        Some(Quantity::Velocity(..)) => Some("velocity"),
        Some(Quantity::AngleToLine(..) | Quantity::AngleToWall(..)) => Some("direction"),
        _ => None,
    };
    let lonely = part.answers.iter().find(|answer| {
        let alike = part.answers.iter().filter(|other| kind(other) == kind(answer));
        kind(answer).is_some()
            && alike.map(|other| sphere_of(&other.find)).all(|other| other == sphere_of(&answer.find))
    })?;
    let (name, kind) = (print::text_unicode(&lonely.name), kind(lonely)?);
    let message = format!("the words ask for the {kind} of each sphere, and only `{name}` is found");
    let help = "find it of the other sphere too, or ask for it of one";
    Some(Finding::new(message, "", "one sphere alone").with_help(help))
}

/// `Find k, and the speed of *B*`, and no answer is a motion of *B*.
fn also_asked(part: &Part, asked: &[Sentence]) -> Option<Finding> {
    const ASKING: [&str; 5] = ["find", "calculate", "determine", "state", "work"];
    const OTHERWISE: [&str; 9] = ["ratio", "between", "difference", "sum", "given", "when", "if", "where", "show"];
    let noun = |token: &Token| ["speed", "velocity"].into_iter().find(|noun| is_one_of(token, &[noun]));
    let motion = |words: &[Token]| match words {
        [joined, the, motion, of, Token::Sphere(sphere)]
            if (*joined == Token::Comma || is_one_of(joined, &["and"]))
                && is_one_of(the, &["the"])
                && is_one_of(of, &["of"]) =>
        {
            Some((noun(motion)?, *sphere))
        }
        _ => None,
    };
    let is_found = |sphere: Sphere| {
        part.answers.iter().any(|answer| answer.kind == Kind::Shown || sphere_of(&answer.find) == Some(sphere))
    };
    let is_asking = |sentence: &&Sentence| says(sentence, &ASKING);
    let (noun, sphere) = asked.iter().filter(is_asking).find_map(|sentence| {
        let at = sentence.windows(5).position(|words| motion(words).is_some_and(|(_, sphere)| !is_found(sphere)))?;
        let found = motion(&sentence[at..at + 5])?;
        (says(&sentence[..at], &ASKING) && !says(&sentence[..at], &OTHERWISE)).then_some(found)
    })?;
    let message = format!("the words ask for the {noun} of *{}* too, and no answer of the part is one", sphere.name());
    let help = "find it in an answer of its own, or do not ask for it";
    Some(Finding::new(message, "", "without it").with_help(help))
}
