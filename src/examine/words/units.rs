//! Are the numbers that the scene takes said in their units?

use super::given::unit_of;
use crate::bank::{Question, Style};
use crate::examine::Finding;
use crate::expr::{Angles, Expr, Piece, Text, print, read};
use crate::mechanics::VelocityText;
use crate::unit::Unit;

/// Numbers in the words with the unit of something else, and angles without theirs.
pub fn astray(question: &Question) -> Vec<Finding> {
    let mut findings: Vec<Finding> = Vec::new();
    for style in &question.styles {
        let asks = question.parts.iter().flat_map(|part| &part.ask);
        for text in style.stem.iter().chain([&style.note]).chain(asks) {
            of_text(&text.0, question, style, &mut findings);
        }
    }
    // Styles share most of their words.
    findings.sort_by(|one, other| one.message.cmp(&other.message));
    findings.dedup();
    findings
}

fn of_text(pieces: &[Piece], question: &Question, style: &Style, findings: &mut Vec<Finding>) {
    for (place, piece) in pieces.iter().enumerate() {
        let (expr, said) = match piece {
            Piece::Italic(inner) => {
                of_text(inner, question, style, findings);
                continue;
            }
            Piece::Quantity(expr, unit) => (expr, *unit),
            Piece::Formula(expr) => (expr, Unit::None),
            _ => continue,
        };
        let words = |piece: Option<&'_ Piece>| match piece {
            Some(Piece::Words(words)) => words.clone(),
            _ => String::new(),
        };
        let after = words(pieces.get(place + 1));
        if let Some(unit) = typed_unit(&after) {
            findings.push(beside(unit, &after, expr, said));
            continue;
        }
        let own = match expr {
            Expr::Name(name) if is_in_degrees(&name.text, question) => Unit::Degree,
            _ => unit_of(expr, &question.scene),
        };
        if let Some((written, _)) = after.strip_prefix(' ').and_then(stated) {
            findings.push(foreign(written, own, expr));
            continue;
        }
        if said != Unit::None && is_coefficient(expr, question) {
            let (name, said) = (print::plain(expr), said.plain());
            let message = format!("`{name}` is said in {said}, and a coefficient of restitution has no unit");
            let found = Finding::new(message, format!("{name} {said}}}"), "a number alone");
            findings.push(found.with_help(format!("write `{{{name}}}`")));
            continue;
        }
        // A letter brings its unit with it, and a bare mass or speed may be one of several: 'masses 3m and {k}m'.
        let is_bare = said == Unit::None
            && match expr {
                Expr::Name(name) if own == Unit::Degree => !is_number(&name.text, style),
                Expr::Name(name) => !is_number(&name.text, style) || !is_stated(&pieces[..place], &after, style),
                _ => true,
            };
        if own == Unit::None || own == said || is_bare {
            continue;
        }
        let (said, own, name) = (said.plain(), own.plain(), print::plain(expr));
        let (at, message) = match said {
            "" => {
                let what = if own == Unit::Degree.plain() { "the angle " } else { "" };
                (format!("{{{name}}}"), format!("{what}`{name}` is said without a unit"))
            }
            _ => (format!("{name} {said}}}"), format!("`{name}` is said in {said}, and the scene takes it in {own}")),
        };
        let help = format!("write `{{{name} {own}}}`");
        findings.push(Finding::new(message, at, format!("expected {own}")).with_help(help));
    }
}

/// How units are written by hand; the longer before what it begins with.
const BY_HAND: [(&str, Unit); 27] = [
    ("metres per second", Unit::MetrePerSecond),
    ("meters per second", Unit::MetrePerSecond),
    ("newton seconds", Unit::NewtonSecond),
    ("newton second", Unit::NewtonSecond),
    ("newton-seconds", Unit::NewtonSecond),
    ("kilograms", Unit::Kilogram),
    ("kilogram", Unit::Kilogram),
    ("joules", Unit::Joule),
    ("joule", Unit::Joule),
    ("degree", Unit::Degree),
    ("kg m/s", Unit::NewtonSecond),
    ("kg m s^-1", Unit::NewtonSecond),
    ("kg ms^-1", Unit::NewtonSecond),
    ("kg m s⁻¹", Unit::NewtonSecond),
    ("m/s", Unit::MetrePerSecond),
    ("m s^-1", Unit::MetrePerSecond),
    ("ms^-1", Unit::MetrePerSecond),
    ("m s-1", Unit::MetrePerSecond),
    ("ms-1", Unit::MetrePerSecond),
    ("m s⁻¹", Unit::MetrePerSecond),
    ("ms⁻¹", Unit::MetrePerSecond),
    ("kg", Unit::Kilogram),
    ("N s", Unit::NewtonSecond),
    ("Ns", Unit::NewtonSecond),
    ("J", Unit::Joule),
    ("°", Unit::Degree),
    ("degrees", Unit::Degree),
];

/// Units in which no scene takes a number and no answer is stated.
const FOREIGN: [&str; 31] = [
    "grams",
    "gram",
    "g",
    "tonnes",
    "cm/s",
    "cm s^-1",
    "cm s⁻¹",
    "centimetres per second",
    "km/h",
    "kmh",
    "km h^-1",
    "km h⁻¹",
    "kph",
    "kilometres per hour",
    "kilometers per hour",
    "km per hour",
    "cm per second",
    "centimeters per second",
    "millimetres per second",
    "mm/s",
    "feet per second",
    "mph",
    "miles per hour",
    "newtons",
    "newton",
    "N",
    "kilojoules",
    "kilojoule",
    "kJ",
    "radians",
    "rad",
];

/// A unit by which something is stated.
pub enum Stated {
    /// One that Carom has.
    In(Unit),
    /// One that it does not have.
    Foreign,
}

/// The unit with which words begin, as it is written there.
pub fn stated(words: &str) -> Option<(&'static str, Stated)> {
    let known = typed_unit(words).map(|(written, unit)| (written, Stated::In(unit)));
    known.or_else(|| {
        FOREIGN.into_iter().find(|written| begins(words, written)).map(|written| (written, Stated::Foreign))
    })
}

/// Do words begin with a unit, and not with a word of which it is a part?
fn begins(words: &str, written: &str) -> bool {
    words
        .strip_prefix(written)
        .is_some_and(|rest| !rest.starts_with(|sign: char| sign.is_alphanumeric() || sign == '^'))
}

/// A unit that stands in the words after a number, as it is written there.
pub(super) fn typed_unit(after: &str) -> Option<(&'static str, Unit)> {
    let after = after.strip_prefix(' ').unwrap_or(after);
    BY_HAND.into_iter().find(|(written, _)| begins(after, written))
}

fn beside((written, unit): (&str, Unit), after: &str, expr: &Expr, said: Unit) -> Finding {
    let space = if after.starts_with(' ') { " " } else { "" };
    let name = print::plain(expr);
    let message = format!("the unit `{written}` stands beside the braces of `{name}`");
    let (inside, help) = match said {
        Unit::None => (name.clone(), format!("write `{{{name} {}}}`", unit.plain())),
        _ => (format!("{name} {}", said.plain()), "take it out: the braces have a unit already".to_owned()),
    };
    Finding::new(message, format!("{{{inside}}}{space}{written}"), "expected it within them").with_help(help)
}

/// A number with a unit behind it in which the scene does not take it.
fn foreign(written: &str, own: Unit, expr: &Expr) -> Finding {
    let name = print::plain(expr);
    let (takes, help) = match own.plain() {
        "" => ("", "say it in a unit that Carom has: kg, m/s, N s, J or deg, within the braces".to_owned()),
        own => (own, format!("write `{{{name} {own}}}`, and change its values if they are others in that unit")),
    };
    let message = match takes {
        "" => format!("`{name}` is said in `{written}`, which is no unit of a scene"),
        takes => format!("`{name}` is said in `{written}`, and the scene takes it in {takes}"),
    };
    Finding::new(message, format!("}} {written}"), "another unit").with_help(help)
}

/// Do the words before and after say that a number is a mass or a speed, and not how many times another it is?
fn is_stated(before: &[Piece], after: &str, style: &Style) -> bool {
    let said = print::text_unicode(&Text(before[before.len().saturating_sub(6)..].to_vec()));
    let is_between = |word: &&str| {
        let word = word.trim_end_matches(',');
        matches!(word, "is" | "are" | "of" | "and" | "have" | "A" | "B" | "C" | "kg" | "m" | "s⁻¹")
            || is_number(word, style)
    };
    let mut words = said.split_whitespace().rev().skip_while(is_between);
    let is_said = words.next().is_some_and(|word| matches!(word, "speed" | "mass" | "speeds" | "masses"));
    let ends = after.is_empty() || after.starts_with(['.', ',', ';', ')']);
    is_said
        && (ends
            || [" and ", " is ", " to ", " towards ", " when ", " which ", " respectively"]
                .iter()
                .any(|next| after.starts_with(next)))
}

/// Is it what the scene has for the coefficient of restitution of an impact?
fn is_coefficient(expr: &Expr, question: &Question) -> bool {
    let scene = &question.scene;
    let mut all = [&scene.e].into_iter().chain(scene.then.iter().map(|then| &then.e)).flatten();
    matches!(expr, Expr::Name(name) if all.any(|e| *e == name.text))
}

/// Is it a parameter whose values are all plain numbers, or derived from such alone?
fn is_number(name: &str, style: &Style) -> bool {
    let domain = style.parameters.iter().find(|(own, _)| own == name).map(|(_, domain)| domain);
    let formula = style.lets.iter().find(|(own, _)| own == name).map(|(_, formula)| formula);
    let is_of_numbers = |formula: &Expr| formula.names().iter().all(|name| is_number(&name.text, style));
    match domain {
        Some(domain) => (0..domain.size().min(100)).all(|place| domain.value(place).names().is_empty()),
        None => formula.is_some_and(is_of_numbers),
    }
}

/// Is it a number of degrees, or a term of one, as in `180 - beta`?
fn is_in_degrees(name: &str, question: &Question) -> bool {
    let scene = &question.scene;
    let velocities = [&scene.before.a, &scene.before.b, &scene.after.a, &scene.after.b].into_iter().flatten();
    let mut angles = velocities.filter_map(|velocity| match velocity {
        VelocityText::Polar(polar) => polar.angle_deg.as_ref(),
        _ => None,
    });
    angles.any(|angle| read(angle, Angles::Degrees).is_ok_and(|expr| has_term(&expr, name)))
}

fn has_term(expr: &Expr, name: &str) -> bool {
    match expr {
        Expr::Name(own) => own.text == name,
        Expr::Negative(inner) => has_term(inner, name),
        Expr::Sum(terms) => terms.iter().any(|term| has_term(term, name)),
        _ => false,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::examine::{Edits, edited};

    #[test]
    fn each_number_is_said_in_its_unit() {
        let (line, size) = ("successive/no-more-collisions", "vector-impulse/size-of-the-impulse");
        let direct = "direct/velocities-after-impact";
        let (same, letters) = ("direct/one-sphere-catches-the-other", "vector-impulse/mass-from-the-speed-after");
        let table: [(&str, Edits, &str); 14] = [
            (line, &[], ""),
            (direct, &[("{mA kg} and", "{mA} grams and")], "`mA` is said in `grams`, and the scene takes it in kg"),
            (direct, &[("{u m/s} and", "{u} cm/s and")], "`u` is said in `cm/s`, and the scene takes it in m/s"),
            (direct, &[("{u m/s} and", "{u} kilometres per hour and")], "`u` is said in `kilometres per hour`"),
            (direct, &[("{u m/s} and", "{u} metres per second and")], "`metres per second` stands beside the braces"),
            (direct, &[("{mB kg} resp", "{mB} kg resp")], "`kg` stands beside the braces of `mB`"),
            (line, &[("{mC kg}", "{mC N s}")], "`mC` is said in N s, and the scene takes it in kg"),
            (size, &[], ""),
            (size, &[("*A* is {v m/s}", "*A* is {v m}")], "`v` is said in m, and the scene takes it in m/s"),
            (
                "walls/rebound-speed-and-direction",
                &[("the wall is {e}.", "the wall is {e m/s}.")],
                "`e` is said in m/s, and a coefficient of restitution has no unit",
            ),
            ("walls/restitution-from-two-angles", &[], ""),
            (same, &[("{w m/s}", "{w}")], "`w` is said without a unit"),
            (direct, &[("{mA kg} and {mB kg}", "{mA kg} and {mB}")], "`mB` is said without a unit"),
            (letters, &[], ""),
        ];
        for (id, edits, words) in table {
            let said: String = astray(&edited(id, edits)).into_iter().map(|finding| finding.message).collect();
            assert!(said.contains(words) && said.is_empty() == words.is_empty(), "{id}: {edits:?}: {said}");
        }
    }
}
