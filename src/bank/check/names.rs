//! Every name that a question uses, and whether each style gives it a meaning.

use std::ops::Range;

use super::super::document::{Faults, listed};
use super::super::literal::Words;
use super::super::requirement::Measure;
use super::quantities;
use crate::diagnostic::{Diagnostic, near};
use crate::expr::{Expr, Function, Name, Piece, Span, Text};
use crate::mechanics::Quantity;
use crate::unit::Unit;

/// Names that mean something already, and cannot be given to a parameter.
pub const RESERVED: [&str; 8] = ["i", "j", "pi", "deg", "result", "denominator", "radicand", "terms"];

/// What a scope calls a name that `[let]` derives.
pub const DERIVED: &str = "derived name";

/// What may stand at a place beside parameters, derived names and letters.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Also {
    /// Nothing else.
    Nothing,
    /// Nothing else, and no parameters or derived names either: the value of a parameter.
    OnlyLetters,
    /// Quantities of the collision.
    Quantities,
}

/// A name that was used.
#[derive(Clone, Debug)]
struct Use {
    name: String,
    span: Range<usize>,
    also: Also,
    /// In one style, or in all.
    style: Option<usize>,
    /// A unit that stands behind the number of a value, and where.
    unit: Option<(Unit, Range<usize>)>,
}

/// The unit that stands behind the number of a value, `4 m/s`, and where it stands.
fn unit_behind(value: &str) -> Option<(Unit, Span)> {
    let (number, unit) = value.trim().split_once(' ')?;
    let start = value.rfind(unit).filter(|_| number.starts_with(|sign: char| sign.is_ascii_digit()))?;
    Some((unit.parse().ok()?, Span { start, end: start + unit.len() }))
}

/// The names that have a meaning in one style.
#[derive(Clone, Debug, Default)]
pub struct Scope {
    /// Parameters and derived names with their places, and what they are: `parameter`, `derived name`.
    pub given: Vec<(String, Range<usize>, &'static str)>,
}

/// All uses of names in a file.
#[derive(Debug, Default)]
pub struct NamesUsed {
    uses: Vec<Use>,
}

impl NamesUsed {
    /// A name in a string of the file; `style` if only that style has the string.
    pub fn name(&mut self, words: &Words, name: &Name, also: Also, style: Option<usize>, faults: &Faults) {
        if name.text != "i" && name.text != "j" {
            let span = faults.place(words, name.span);
            let unit = unit_behind(words.get_ref()).filter(|_| also == Also::OnlyLetters);
            let unit = unit.map(|(unit, place)| (unit, faults.place(words, place)));
            self.uses.push(Use { name: name.text.clone(), span, also, style, unit });
        }
    }

    /// The names of an expression.
    pub fn expression(&mut self, words: &Words, expr: &Expr, also: Also, style: Option<usize>, faults: &Faults) {
        for name in expr.names() {
            self.name(words, name, also, style, faults);
        }
    }

    /// The names in the formulas of a text; `*A*` is a letter of the alphabet and no name.
    pub fn text(&mut self, words: &Words, text: &Text, style: Option<usize>, faults: &Faults) {
        self.pieces(words, &text.0, style, faults);
    }

    fn pieces(&mut self, words: &Words, pieces: &[Piece], style: Option<usize>, faults: &Faults) {
        for piece in pieces {
            match piece {
                Piece::Words(_) => {}
                Piece::Italic(inner) => self.pieces(words, inner, style, faults),
                Piece::Formula(Expr::Name(name)) if is_starred(words, name) => {}
                Piece::Formula(expr) | Piece::Quantity(expr, _) | Piece::Display(expr) => {
                    self.expression(words, expr, Also::Nothing, style, faults);
                }
            }
        }
    }

    /// Reports names without a meaning, and parameters that nothing uses.
    pub fn resolve(&self, scopes: &[(String, Scope)], letters: &[&str], faults: &mut Faults) {
        let mut lacking: Vec<(&str, &str)> = Vec::new();
        let mut unknown = false;
        let mut units: Vec<&Range<usize>> = Vec::new();
        let mut in_values: Vec<&str> = Vec::new();
        for used in &self.uses {
            let name = used.name.as_str();
            // Of a letter that stands in values it is told once.
            if in_values.contains(&name) {
                continue;
            }
            if letters.contains(&name) || (used.also == Also::Quantities && name.parse::<Quantity>().is_ok()) {
                continue;
            }
            if let Some((unit, place)) = &used.unit {
                if !units.contains(&place) {
                    units.push(place);
                    let message = format!("a value with its unit, `{}`", unit.plain());
                    let help = format!("leave the unit out: it stands in the words, as in `{{name {}}}`", unit.plain());
                    faults.report(place.clone(), message, "expected a number alone", help);
                }
                continue;
            }
            if used.also == Also::OnlyLetters {
                in_values.push(name);
                let message = format!("`{name}` in the value of a parameter");
                let label = "expected numbers, or letters that the scene declares";
                let is_given = scopes.iter().any(|(_, scope)| scope.given.iter().any(|(given, ..)| given == name));
                let help = match is_given {
                    true => "derive names from parameters in `[let]`".to_owned(),
                    false => format!("if it is a letter, declare it in `[scene.symbols]`: `{name} = \"positive\"`"),
                };
                faults.report(used.span.clone(), message, label, help);
                continue;
            }
            let here = |index: usize| used.style.is_none_or(|style| style == index);
            let concerned = scopes.iter().enumerate().filter(|(index, _)| here(*index)).map(|(_, scope)| scope);
            let (with, without): (Vec<_>, Vec<_>) =
                concerned.partition(|(_, scope)| scope.given.iter().any(|(given, ..)| given == name));
            let Some((style, _)) = without.first() else { continue };
            if with.is_empty() {
                self.report_unknown(used, scopes, letters, faults);
                unknown = true;
            } else if !lacking.contains(&(style, name)) {
                lacking.push((style, name));
                // `W` for `w` in the parameters: a name of this style alone that nothing uses.
                let other = |given: &&str| {
                    given.eq_ignore_ascii_case(name) && !self.uses.iter().any(|used| used.name == **given)
                };
                let own = scopes.iter().find(|scope| scope.0 == *style).map_or(&[][..], |scope| &scope.1.given);
                let meant = own.iter().map(|(given, ..)| given.as_str()).find(other);
                let help = match meant {
                    Some(meant) => format!("did you mean `{meant}`, which has values there? Write one of the two"),
                    None => format!("add `{name}` to the parameters of style `{style}`"),
                };
                let message = format!("style `{style}` gives no values to `{name}`");
                faults.report(used.span.clone(), message, "used in every style", help);
            }
        }
        if !unknown {
            // Else the parameter is perhaps the one that was meant there.
            self.report_unused(scopes, letters, faults);
        }
    }

    fn report_unknown(&self, used: &Use, scopes: &[(String, Scope)], letters: &[&str], faults: &mut Faults) {
        let name = used.name.as_str();
        let given = scopes.iter().flat_map(|(_, scope)| &scope.given).map(|(given, ..)| given.as_str());
        let mut known: Vec<&str> = Vec::new();
        for name in letters.iter().copied().chain(given) {
            if !known.contains(&name) {
                known.push(name);
            }
        }
        if name.contains('.') && used.also == Also::Nothing && name.parse::<Quantity>().is_ok() {
            let label = "not known before the collision is solved";
            let help = "use it in `require`, or in the `find` of an answer";
            faults.report(used.span.clone(), format!("`{name}` is a result"), label, help);
            return;
        }
        if used.also == Also::Quantities && name.contains('.') {
            quantities::unknown_at(used.span.clone(), "quantity", name, &[], faults);
            return;
        }
        if let Some((span, meant)) = unit_meant(&faults.source.text, &used.span).filter(|_| used.also == Also::Nothing)
        {
            let message = format!("unknown unit `{}`", &faults.source.text[span.clone()]);
            let label = format!("expected {}", listed(&units()));
            let typed = &faults.source.text[span.clone()];
            // Of `N` the second has been forgotten.
            let is_same = is_spelt(typed, meant) || meant.starts_with(typed);
            let number = if is_same { "" } else { ", and give the number in it" };
            faults.report(span, message, label, format!("write `{meant}`{number}"));
            return;
        }
        if let Some((span, name, unit)) =
            run_on(&faults.source.text, &used.span, &known).filter(|_| used.also == Also::Nothing)
        {
            let help = format!("write `{{{name} {unit}}}`");
            faults.report(span, "a unit without a space before it", "a name and its unit", help);
            return;
        }
        if name.len() > 1 && faults.source.text[used.span.end..].starts_with('(') {
            let functions = functions(used.also == Also::Quantities);
            let label = format!("formulas have {}", listed(&functions));
            let help = "say it with those; for a product write a star before the bracket";
            let fault = Diagnostic::new(format!("unknown function `{name}`"), &faults.source, used.span.clone(), label);
            let begun = Function::begins(name).map(Function::name);
            let near = begun.or_else(|| near(name, functions.into_iter().chain(known)));
            faults.found.push(fault.with_help(help).with_near(near));
            return;
        }
        let label = match known.as_slice() {
            [] => "the question has no parameters".to_owned(),
            _ => {
                format!("this question has {}", listed(&known))
            }
        };
        let mut candidates: Vec<String> = known.iter().map(|name| (*name).to_owned()).collect();
        if used.also == Also::Quantities {
            candidates.extend(Quantity::all().iter().map(Quantity::to_string));
        }
        if used.also == Also::Nothing {
            // At the end of a formula in the words it was perhaps to be a unit.
            candidates.extend(Unit::ALL.map(|unit| unit.plain().to_owned()));
            candidates.push("result".to_owned());
        }
        // The letter `m` and the metre have one name.
        candidates.retain(|candidate| candidate != name);
        let help = near(name, candidates.iter().map(String::as_str)).map(|near| format!("did you mean `{near}`?"));
        let help = help.unwrap_or_else(|| help_to_declare(name));
        faults.report(used.span.clone(), format!("unknown name `{name}`"), label, help);
    }

    fn report_unused(&self, scopes: &[(String, Scope)], letters: &[&str], faults: &mut Faults) {
        let mut reported: Vec<Range<usize>> = faults.found.iter().map(|fault| fault.span.clone()).collect();
        for (index, (_, scope)) in scopes.iter().enumerate() {
            for (name, span, what) in &scope.given {
                // A parameter that one style does not use would make the same variant again and again there; a name
                // that is derived for all styles may serve but one.
                let shared = |style: usize| scopes[style].1.given.iter().any(|given| given.1 == *span);
                let serves = |style: usize| if *what == DERIVED { shared(style) } else { style == index };
                let here = |used: &Use| used.style.is_none_or(serves);
                let counts = |used: &&Use| used.name == *name && used.also != Also::OnlyLetters && here(used);
                let is_used = self.uses.iter().any(|used| counts(&used));
                if is_used || reported.contains(span) || letters.contains(&name.as_str()) {
                    continue;
                }
                reported.push(span.clone());
                faults.report(
                    span.clone(),
                    format!("{what} `{name}` is never used"),
                    "nothing in the question depends on it",
                    format!("take it out, or use it as `{{{name}}}` in the stem or in the scene"),
                );
            }
        }
    }
}

/// How a name is given a meaning: values, a formula, a range of its own; a coefficient of restitution is often to be found.
fn help_to_declare(name: &str) -> String {
    const ANGLES: [&str; 6] = ["alpha", "beta", "gamma", "delta", "theta", "phi"];
    if name == "e" {
        return "give it values in `[parameters]`, as in `e = [\"1/4\", \"1/2\"]`; or declare the letter in \
                `[scene.symbols]`, as `e = \"unit\"`, and if it is to be found, name it in `unknowns` of `[scene]` and what \
                decides it in `conditions`"
            .to_owned();
    }
    let (values, range) = if ANGLES.contains(&name) { ("10..80", "acute") } else { ("1..6", "positive") };
    format!(
        "give it values in `[parameters]`, as in `{name} = \"{values}\"`, or a formula in `[let]`; or, as a letter, a range \
         in `[scene.symbols]`, as in `{name} = \"{range}\"`"
    )
}

/// The functions of a formula, and of a requirement.
fn functions(is_required: bool) -> Vec<&'static str> {
    let measures = Measure::ALL.iter().map(|measure| measure.name()).filter(|_| is_required);
    Function::ALL.iter().map(|function| function.name()).chain(measures).collect()
}

/// A name that is known and the unit that stands at its end without a space, as in `{um/s}`.
fn run_on<'n>(text: &str, at: &Range<usize>, known: &[&'n str]) -> Option<(Range<usize>, &'n str, &'static str)> {
    let open = text[..at.start].rfind('{')? + 1;
    let inside = text[open..].split('}').next()?;
    known.iter().find_map(|name| {
        let said = inside.strip_prefix(name)?;
        let unit = units().into_iter().find(|unit| *unit == said)?;
        Some((open..open + inside.len(), *name, unit))
    })
}

/// The units that have a name.
fn units() -> Vec<&'static str> {
    Unit::ALL.map(Unit::plain).into_iter().filter(|unit| !unit.is_empty()).collect()
}

/// Units that are written in words and that the bank does not have, with the one that it has in their place.
const OTHERS: [(&str, Unit); 13] = [
    ("N", Unit::NewtonSecond),
    ("g", Unit::Kilogram),
    ("gram", Unit::Kilogram),
    ("grams", Unit::Kilogram),
    ("t", Unit::Kilogram),
    ("mg", Unit::Kilogram),
    ("cm", Unit::Metre),
    ("mm", Unit::Metre),
    ("km", Unit::Metre),
    ("mph", Unit::MetrePerSecond),
    ("kJ", Unit::Joule),
    ("rad", Unit::Degree),
    ("radians", Unit::Degree),
];

/// A unit at the end of a formula in braces that is written otherwise than here, as `m s^-1` is: where it stands, if the
/// name at `at` is a part of it, and how it is written here.
fn unit_meant(text: &str, at: &Range<usize>) -> Option<(Range<usize>, &'static str)> {
    let open = text[..at.start].rfind(['{', '}', '\n']).filter(|open| text[*open..].starts_with('{'))? + 1;
    let close =
        at.end + text[at.end..].find(['{', '}', '\n']).filter(|length| text[at.end + length..].starts_with('}'))?;
    let inside = text[open..close].trim_end();
    // `{[p, q] N}`: the blank between components stands before no unit.
    let before = if inside.starts_with('[') { inside.rfind(']')? } else { inside.len() - inside.trim_start().len() };
    let start = open + before + inside[before..].find(char::is_whitespace)?;
    let unit = text[start..open + inside.len()].trim_start();
    let start = open + inside.len() - unit.len();
    let is_sign = |sign: char| sign.is_ascii_alphanumeric() || " ^-+()/.·⁻¹²−".contains(sign);
    if at.start < start || !unit.chars().all(is_sign) {
        return None;
    }
    let meant = units().into_iter().find(|known| is_spelt(unit, known));
    // Of a unit that is none of ours, as km/h, at least what it is a unit of.
    let is_speed = || unit.split_once('/').is_some_and(|(_, time)| ["h", "s", "min", "hr"].contains(&time));
    let meant = meant.or_else(|| is_speed().then(|| Unit::MetrePerSecond.plain()));
    let other = || OTHERS.iter().find(|(other, _)| *other == unit).map(|(_, meant)| meant.plain());
    let meant = meant.or_else(other)?;
    Some((start..start + unit.len(), meant))
}

/// Do two units have the same letters, as `m s^-1` and `m/s` have?
fn is_spelt(unit: &str, known: &str) -> bool {
    let [unit, known] = [unit, known].map(|unit| unit.chars().filter(char::is_ascii_alphabetic));
    unit.eq(known)
}

/// Was it written `*A*`?
fn is_starred(words: &Words, name: &Name) -> bool {
    words.get_ref().get(..name.span.start).is_some_and(|before| before.ends_with('*'))
}
