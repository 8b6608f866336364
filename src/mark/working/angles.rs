//! Angles that a student works with by a letter, where the question gives them as numbers: `5 cos θ` after `cos θ = 4/5`,
//! or `5 cos α` where α is the question's own name for the angle.

use super::examine::context;
use super::line::{Line, ReadLine};
use super::linear::constant;
use super::prepared::Prepared;
use crate::expr::{Expr, Function};

/// Letters for angles that are still to be found: nobody calls a given one so, unless the question does.
const NEW: [&str; 4] = ["beta", "gamma", "delta", "phi"];

/// Puts the angles that letters stand for in their places under sines, cosines and tangents.
///
/// A letter stands for what the working says of it before it is first used; else for the angle of that name in the
/// question, or for the only one that has a name there.
pub(super) fn put_in_place(lines: &mut [Line], prepared: &Prepared) {
    put_short_letters_in_place(lines, prepared);
    let mut known: Vec<(String, Expr)> = Vec::new();
    let mut guessed: Vec<String> = Vec::new();
    for reading in lines.iter_mut().flat_map(|line| &mut line.readings) {
        let defined = reading.equations.iter().find_map(|equation| definition(equation, prepared));
        if let Some((name, angle)) = defined {
            if known.iter().all(|(own, _)| *own != name) {
                known.push((name, in_degrees(angle)));
            }
            continue;
        }
        for name in used(reading) {
            let is_open = prepared.points.letter(&name, 0).is_none() && known.iter().all(|(own, _)| *own != name);
            let named = prepared.angles.iter().find(|(own, _)| *own == name);
            let is_new = NEW.contains(&name.as_str());
            let only = || prepared.angles.first().filter(|_| prepared.angles.len() == 1 && !is_new);
            if let Some((_, angle)) = named.or_else(only).filter(|_| is_open) {
                guessed.extend(named.is_none().then(|| name.clone()));
                known.push((name.clone(), in_degrees(*angle)));
            }
            reading.is_guessed |= guessed.contains(&name);
        }
        let put = |expr: &Expr| with_angles(expr, &known);
        for (left, right) in &mut reading.equations {
            (*left, *right) = (put(left), put(right));
        }
        for member in &mut reading.members {
            member.expr = put(&member.expr);
        }
    }
}

/// `let t = tan α`: from there on the letter is written for it.
fn put_short_letters_in_place(lines: &mut [Line], prepared: &Prepared) {
    let mut known: Vec<(String, Expr)> = Vec::new();
    for line in lines {
        let defined =
            line.readings.iter().flat_map(|reading| &reading.equations).find_map(|equation| short(equation, prepared));
        if let Some(letter) = defined {
            known.push(letter);
            continue;
        }
        let put = |expr: &Expr| {
            expr.substitute(&|name| known.iter().rfind(|(own, _)| own == name).map(|(_, put)| put.clone()))
        };
        for reading in line.readings.iter_mut().filter(|_| !known.is_empty()) {
            for (left, right) in &mut reading.equations {
                (*left, *right) = (put(left), put(right));
            }
            for member in &mut reading.members {
                member.expr = put(&member.expr);
            }
        }
    }
}

/// A letter of the student's own for a sine, cosine or tangent of a letter of the question.
fn short((left, right): &(Expr, Expr), prepared: &Prepared) -> Option<(String, Expr)> {
    let Expr::Name(letter) = left else { return None };
    let is_free = |name: &str| {
        prepared.points.letter(name, 0).is_none() && !prepared.names.iter().any(|(known, _)| known == name)
    };
    match argument(right)? {
        Expr::Name(angle) if is_free(&letter.text) && !is_free(&angle.text) => {
            Some((letter.text.clone(), right.clone()))
        }
        _ => None,
    }
}

fn in_degrees(degrees: f64) -> Expr {
    Expr::degrees(Expr::Decimal(format!("{degrees:.12}")))
}

/// `cos θ = 4/5` or `θ = 36.9°`: the letter, and the angle in degrees.
fn definition((left, right): &(Expr, Expr), prepared: &Prepared) -> Option<(String, f64)> {
    let number = |expr: &Expr| constant(expr, &context(prepared, 0)).map(super::spread::Spread::middle);
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

/// The letters alone under sines, cosines and tangents.
fn used(reading: &ReadLine) -> Vec<String> {
    let mut found = Vec::new();
    let sides = reading.equations.iter().flat_map(|(left, right)| [left, right]);
    for expr in sides.chain(reading.members.iter().map(|member| &member.expr)) {
        collect(expr, &mut found);
    }
    found
}

fn collect(expr: &Expr, found: &mut Vec<String>) {
    if let Some(Expr::Name(name)) = argument(expr) {
        found.push(name.text.clone());
    }
    expr.children().into_iter().for_each(|child| collect(child, found));
}

fn argument(expr: &Expr) -> Option<&Expr> {
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
