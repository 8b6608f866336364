//! Angles that a student works with by a letter, where the question gives them as numbers: `5 cos θ` after `cos θ = 4/5`,
//! or `5 cos α` where α is the question's own name for the angle.

use super::components::{has_component, name_components};
use super::slipped::false_number;
use crate::expr::{Expr, Function, Relation};
use crate::mark::reading::Form;
use crate::mark::working::examine::context;
use crate::mark::working::lines::{Line, Member, ReadLine, explains};
use crate::mark::working::numbers::{Spread, constant};
use crate::mark::working::prepared::Prepared;
use crate::number::{Letter, Range};

/// Letters for angles that are still to be found: nobody calls a given one so, unless the question does.
pub(super) const NEW: [&str; 4] = ["beta", "gamma", "delta", "phi"];

/// Puts the angles that letters stand for in their places under sines, cosines and tangents.
///
/// A letter stands for what the working says of it before it is first used; else for the angle of that name in the
/// question, or for the only one that has a name there.
pub(super) fn put_in_place(
    lines: &mut [Line],
    letters: &[Letter],
    explained: &mut Vec<(String, Expr)>,
    prepared: &Prepared,
) {
    put_short_letters_in_place(lines, letters, explained, prepared);
    let mut known: Vec<(String, Expr)> = Vec::new();
    let mut guessed: Vec<String> = Vec::new();
    let mut sought: Vec<String> = Vec::new();
    // `where cos θ = 3/5` is said of what stands before it.
    for line in lines.iter().filter(|line| line.typed.to_lowercase().starts_with("where ")) {
        let equations = line.readings.iter().flat_map(|reading| &reading.equations);
        let defined = equations.filter_map(|equation| definition(equation, prepared));
        known.extend(defined.map(|(name, angle)| (name, in_degrees(angle))));
    }
    for reading in lines.iter_mut().flat_map(Line::readings_mut) {
        let defined = reading.equations.iter().find_map(|equation| definition(equation, prepared));
        if let Some((name, own)) = defined {
            // A wrong angle leaves equations right that are written with its letter.
            let angle = from_distance(prepared, &name).unwrap_or(own);
            if known.iter().all(|(own, _)| *own != name) {
                known.push((name.clone(), in_degrees(angle)));
            }
            if is_used_beside(reading, &name, prepared) {
                put_everywhere(reading, &|expr| with_angles(expr, &known));
            }
            continue;
        }
        // `sin α = d/(2r)` is how it is found, rightly or not.
        if used(reading).iter().any(|name| from_distance(prepared, name).is_some() && is_found(reading, name)) {
            continue;
        }
        for name in used(reading) {
            let is_open = prepared.points.letter(&name, 0).is_none() && known.iter().all(|(own, _)| *own != name);
            let is_new = NEW.contains(&name.as_str());
            let is_sought =
                || sides(reading).any(|expr| has_component(expr, &name, prepared)) || is_found(reading, &name);
            if from_distance(prepared, &name).is_none() && is_sought() {
                sought.push(name.clone());
            }
            let is_new = is_new || sought.contains(&name);
            let is_named = |(own, _): &&(String, f64)| *own == name && !sought.contains(&name);
            let named = prepared.angles.iter().find(is_named);
            let only = || prepared.angles.first().filter(|_| prepared.angles.len() == 1 && !is_new);
            if let Some((_, angle)) = named.or_else(only).filter(|_| is_open) {
                guessed.extend(named.is_none().then(|| name.clone()));
                known.push((name.clone(), in_degrees(*angle)));
            }
            reading.is_guessed |= guessed.contains(&name);
        }
        if !known.is_empty() {
            put_everywhere(reading, &|expr| with_angles(expr, &known));
        }
        name_components(reading, prepared);
    }
}

/// The angle of this name, if it is one that is to be found from a distance.
fn from_distance(prepared: &Prepared, name: &str) -> Option<f64> {
    prepared.from_distance.filter(|_| prepared.angles.iter().any(|(known, _)| known == name))
}

/// `let t = tan α`, `k = 4cos30`: from there on the letter is written for it, in later parts too.
fn put_short_letters_in_place(
    lines: &mut [Line],
    letters: &[Letter],
    known: &mut Vec<(String, Expr)>,
    prepared: &Prepared,
) {
    let unsaid = unsaid(lines, letters, prepared).filter(|(own, _)| known.iter().all(|(letter, _)| letter != own));
    known.extend(unsaid);
    let mut used: Vec<String> = Vec::new();
    for line in lines {
        let put = |expr: &Expr| {
            expr.substitute(&|name| known.iter().rfind(|(own, _)| own == name).map(|(_, put)| put.clone()))
        };
        if !known.is_empty() {
            line.readings_mut().for_each(|reading| put_everywhere(reading, &put));
        }
        // `tan δ = 35t/(9 + 44t²), t = tan α`, `3u = 3v + 4w (u = 8 cos 48°)`: the line itself is written with it.
        let members = line.readings.iter().flat_map(|reading| &reading.members);
        let here: Vec<(String, Expr)> = members
            .filter_map(|member| short(member, prepared))
            .filter(|(letter, value)| argument(value).is_some() || explains(&line.typed, letter))
            .collect();
        let put = |expr: &Expr| {
            expr.substitute(&|name| {
                here.iter().find(|(own, _)| own == name && !used.contains(own)).map(|(_, put)| put.clone())
            })
        };
        if !here.is_empty() {
            let chains = line.readings_mut().filter(|reading| reading.equations.len() > 1);
            chains.for_each(|reading| put_everywhere(reading, &put));
        }
        let members = line.readings.iter().flat_map(|reading| &reading.members);
        let mut defined: Vec<(String, Expr)> = members.filter_map(|member| short(member, prepared)).collect();
        let equations = line.readings.iter().flat_map(|reading| &reading.equations);
        defined.extend(equations.filter_map(|equation| turned_round(equation, prepared)));
        // In `9cos26 = 8.59 = k` the letter is the number, which the formula is not.
        let equations = line.readings.iter().flat_map(|reading| &reading.equations);
        let false_numbers = equations.filter_map(|(formula, number)| false_number(formula, number, prepared));
        for number in false_numbers {
            defined.sort_by_key(|(_, value)| value != number);
        }
        for (letter, value) in defined {
            // What stood in an equation before is an unknown that has been found.
            if !used.contains(&letter) && known.iter().all(|(own, _)| *own != letter) {
                known.push((letter, value));
            }
        }
        let sides = line.readings.iter().flat_map(|reading| &reading.equations).flat_map(|(left, right)| [left, right]);
        used.extend(sides.flat_map(Expr::names).map(|name| name.text.clone()));
    }
}

/// The `t` that is squared in working about one angle is its tangent, unless a line says what it is.
fn unsaid(lines: &[Line], letters: &[Letter], prepared: &Prepared) -> Option<(String, Expr)> {
    let typed = lines.iter().map(|line| line.typed.as_str());
    let letter = tangent_letter(typed, letters)?;
    let angle = letters.iter().find(|letter| letter.range() == Range::Acute)?;
    let mut members = lines.iter().flat_map(|line| &line.readings).flat_map(|reading| &reading.members);
    let is_said = members.any(|member| {
        argument(&member.expr).is_some() && short(member, prepared).is_some_and(|(own, _)| own == letter)
    });
    (!is_said).then(|| (letter, Expr::call(Function::Tan, Expr::name(angle.name()))))
}

/// The `t` or `T` whose square stands in working about one angle: nothing else there is squared but the tangent.
pub(super) fn tangent_letter<'l>(lines: impl Iterator<Item = &'l str>, letters: &[Letter]) -> Option<String> {
    let lines: Vec<&str> = lines.collect();
    let angles = letters.iter().filter(|letter| letter.range() == Range::Acute).count();
    let is_free = |name: &&str| letters.iter().all(|letter| letter.name() != *name);
    let is_squared = |name: &&str| {
        lines.iter().any(|line| {
            line.match_indices(*name).any(|(at, _)| {
                let stands_alone = !line[..at].ends_with(|sign: char| sign.is_alphabetic() || sign == '\\');
                stands_alone && line[at + name.len()..].starts_with(['²', '^'])
            })
        })
    };
    ["t", "T"].into_iter().filter(is_free).find(is_squared).filter(|_| angles == 1).map(str::to_owned)
}

/// A letter of the student's own for what is known: a sine, cosine or tangent of a letter of the question, or a number.
fn short(member: &Member, prepared: &Prepared) -> Option<(String, Expr)> {
    let is_free = |name: &str| !prepared.gives(name);
    // A letter that is not expected before an equals sign is read as a word.
    let letter = member.letter.as_ref().or(member.label.as_ref().filter(|label| label.len() == 1))?;
    let value = &member.expr;
    let is_of_known = value.names().iter().all(|name| !is_free(&name.text));
    let is_known = is_of_known && (argument(value).is_some() || constant(value, &context(prepared, 0)).is_some());
    (is_known && is_free(letter) && is_short(letter)).then(|| (letter.clone(), value.clone()))
}

/// `u/√5 = c`, `u cos α = 2k`: the letter behind the equals sign, and what it is.
fn turned_round((left, right): &(Expr, Expr), prepared: &Prepared) -> Option<(String, Expr)> {
    let (number, name) = match right {
        Expr::Name(name) => (None, name),
        Expr::Product(factors) => match factors.as_slice() {
            [number @ Expr::Number(_), Expr::Name(name)] => (Some(number), name),
            _ => return None,
        },
        _ => return None,
    };
    let is_angle = |name: &str| prepared.angles.iter().any(|(known, _)| known == name);
    let is_of_question = |name: &str| prepared.points.letter(name, 0).is_some() || is_angle(name);
    let names = left.names();
    let is_known = !names.is_empty() && names.iter().all(|name| is_of_question(&name.text));
    let value = || number.map_or(left.clone(), |number| left.clone().over(number.clone()));
    (is_known && !prepared.gives(&name.text) && is_short(&name.text)).then(|| (name.text.clone(), value()))
}

/// May it be a letter for something known? Others stand for what is to be found, by the custom of the subject.
pub(in crate::mark::working) fn is_short(letter: &str) -> bool {
    const SOUGHT: [char; 18] =
        ['v', 'w', 'x', 'y', 'V', 'W', 'X', 'Y', 'I', 'J', 'E', 'e', 'm', 'M', 'i', 'A', 'B', 'C'];
    let is_greek = letter.len() > 2 && !letter.contains('_');
    letter.starts_with(char::is_alphabetic) && !is_greek && letter != "j" && !letter.starts_with(SOUGHT)
}

/// Puts something in the place of letters, wherever they stand in a reading.
pub(super) fn put_everywhere(reading: &mut ReadLine, put: &dyn Fn(&Expr) -> Expr) {
    for (left, right) in &mut reading.equations {
        (*left, *right) = (put(left), put(right));
    }
    for member in &mut reading.members {
        member.expr = put(&member.expr);
    }
    for said in reading.statements.iter_mut().flat_map(|statement| &mut statement.said) {
        if let Form::Value(formula) | Form::Equation(formula) = &mut said.form {
            *formula = put(formula);
        }
    }
}

fn in_degrees(degrees: f64) -> Expr {
    Expr::degrees(Expr::Decimal(format!("{degrees:.12}")))
}

/// `cos θ = 4/5` or `θ = 36.9°`: the letter, and the angle in degrees.
pub(super) fn definition((left, right): &(Expr, Expr), prepared: &Prepared) -> Option<(String, f64)> {
    let number = |expr: &Expr| constant(expr, &context(prepared, 0)).map(Spread::middle);
    // In letters of the question it is no number, and a letter of the question is none of the student's.
    let is_letter = |expr: &Expr| expr.names().iter().any(|name| prepared.points.letter(&name.text, 0).is_some());
    if is_letter(left) || is_letter(right) {
        return None;
    }
    match left {
        Expr::Call(function, argument) => {
            let Expr::Name(name) = &**argument else { return None };
            let value = number(right)?;
            let angle = match function {
                Function::Sin => value.asin(),
                Function::Cos => value.acos(),
                Function::Tan => value.atan(),
                _ => return None,
            };
            angle.is_finite().then(|| (name.text.clone(), angle.to_degrees()))
        }
        Expr::Name(name) if matches!(right, Expr::Degrees(_)) => Some((name.text.clone(), number(right)?.to_degrees())),
        _ => None,
    }
}

/// `7(10 cos α) = 7v + 8w, cos α = 3/5`: does a line use the angle that it defines, and not find it from components?
fn is_used_beside(reading: &ReadLine, angle: &str, prepared: &Prepared) -> bool {
    let has = |expr: &Expr| {
        let mut found = Vec::new();
        collect(expr, &mut found);
        found.iter().any(|name| name == angle)
    };
    let is_found = reading.members.iter().any(|member| has_component(&member.expr, angle, prepared));
    !is_found && reading.members.iter().any(|member| argument(&member.expr).is_none() && has(&member.expr))
}

/// `tan α = 2/(1 - e)`: is the angle found here, by a formula in letters, and not one that is given as a number?
fn is_found(reading: &ReadLine, angle: &str) -> bool {
    let is_its_own = |expr: &Expr| matches!(argument(expr), Some(Expr::Name(name)) if name.text == angle);
    let is_of_others = |expr: &Expr| {
        let names = expr.names();
        !names.is_empty() && names.iter().all(|name| name.text != angle)
    };
    let mut equations = reading.equations.iter();
    equations.any(|(left, right)| is_its_own(left) && is_of_others(right))
}

/// The letters alone under sines, cosines and tangents.
pub(super) fn used(reading: &ReadLine) -> Vec<String> {
    let mut found = Vec::new();
    sides(reading).for_each(|expr| collect(expr, &mut found));
    found
}

pub(super) fn sides(reading: &ReadLine) -> impl Iterator<Item = &Expr> {
    let of_equations = reading.equations.iter().flat_map(|(left, right)| [left, right]);
    let said = reading.statements.iter().flat_map(|statement| &statement.said);
    let of_inequalities = said.filter_map(|said| match &said.form {
        Form::Equation(Expr::Relation(left, relation, right)) if *relation != Relation::Equal => {
            Some([&**left, &**right])
        }
        _ => None,
    });
    of_equations.chain(of_inequalities.flatten()).chain(reading.members.iter().map(|member| &member.expr))
}

fn collect(expr: &Expr, found: &mut Vec<String>) {
    if let Some(Expr::Name(name)) = argument(expr) {
        found.push(name.text.clone());
    }
    expr.children().into_iter().for_each(|child| collect(child, found));
}

pub(super) fn argument(expr: &Expr) -> Option<&Expr> {
    match expr {
        Expr::Call(Function::Sin | Function::Cos | Function::Tan, argument) => Some(argument),
        _ => None,
    }
}

fn with_angles(expr: &Expr, known: &[(String, Expr)]) -> Expr {
    match (expr, argument(expr)) {
        (Expr::Call(function, _), Some(argument)) => {
            let angle = |name: &str| known.iter().find(|(own, _)| own == name).map(|(_, angle)| angle.clone());
            Expr::call(*function, argument.substitute(&angle))
        }
        _ => expr.map_children(&mut |child| with_angles(child, known)),
    }
}
