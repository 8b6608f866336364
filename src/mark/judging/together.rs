//! One answer in which several things are asked, shared out to them.

use std::borrow::Cow;

use crate::answer::Kind;
use crate::mark::reading::{Form, Label, Reading, Said, Statement, Unreadable};

use crate::expr::{Expr, Function};
use crate::mechanics::Sphere;

use super::finding::Finding;
use super::statements::is_called_by_a_letter;
use super::{BLANK, Judgement, Model, Note, besides, one, refused, report, spheres, velocity};

/// Judges one answer in which several things are asked: labelled with their spheres, or in the order asked.
///
/// A thing that is not answered is blank.
pub fn judge_together(models: &[Model], readings: &Result<Vec<Reading>, Unreadable>) -> Vec<Judgement> {
    let readings = match readings {
        Ok(readings) => readings,
        Err(unreadable) => return models.iter().map(|_| refused(unreadable)).collect(),
    };
    let each = |reading: &Reading| -> Vec<Finding> {
        // `5 (w = 15)`: what is an aside to one thing may be the answer to another.
        let is_aside = |remark: &str| besides::letter_of_aside(remark).or(besides::letter_of_place(remark)).is_some();
        if reading.remarks().any(|remark| is_aside(remark)) {
            return vec![Finding::unreadable(Note::SeveralAnswers); models.len()];
        }
        let in_order = |reading: &Reading| -> Vec<Finding> {
            let shares = shared_out(models, &with_directions_apart(models, reading));
            let of_each = models.iter().zip(&shares);
            of_each.map(|(model, share)| share.as_ref().map_or(BLANK, |share| one(model, share))).collect()
        };
        let findings = in_order(reading);
        // `w = 20, v = 11`, where 11 is asked first: the letters may say which is which.
        let turned_round =
            || Reading { statements: reading.statements.iter().rev().cloned().collect(), ..reading.clone() };
        let are_letters =
            models.len() == 2 && reading.statements.len() == 2 && reading.statements.iter().all(is_called_by_a_letter);
        if are_letters
            && !findings.iter().any(Finding::is_credited)
            && in_order(&turned_round()).iter().all(Finding::is_correct)
        {
            return vec![Finding::unreadable(Note::NamedOtherwise); models.len()];
        }
        findings
    };
    let worth = |findings: &[Finding]| {
        findings.iter().map(|finding| (finding.is_correct(), finding.is_credited())).fold(
            (0, 0),
            |(right, credited), (is_right, is_credited)| {
                (right + u32::from(is_right), credited + u32::from(is_credited))
            },
        )
    };
    let found = readings.iter().map(|reading| (each(reading), reading));
    match found.reduce(|best, next| if worth(&next.0) > worth(&best.0) { next } else { best }) {
        Some((findings, reading)) => findings.into_iter().map(|finding| report(finding, Some(reading))).collect(),
        None => models.iter().map(|_| report(Finding::unreadable(Note::CannotBeRead), None)).collect(),
    }
}

/// What a reading says of each of the models.
fn shared_out(models: &[Model], reading: &Reading) -> Vec<Option<Reading>> {
    let named = reading.statements.iter().any(|statement| spheres::named_sphere(statement).is_some());
    let share =
        |statements: Vec<Statement>| (!statements.is_empty()).then(|| Reading { statements, ..reading.clone() });
    let asked = |model: &Model| asked_of(model, named);
    // `7.21 at 56.3° to the line of centres, B 6`: what stands before the second sphere is of the first.
    let first_named = reading.statements.iter().find_map(spheres::named_sphere);
    let first_asked = models.iter().find_map(asked);
    let mut sphere = first_asked.filter(|asked| first_named.is_some_and(|named| named > *asked));
    let mut left: Vec<(Option<Sphere>, &Statement)> = Vec::with_capacity(reading.statements.len());
    for statement in reading.statements.iter().filter(|statement| !leads_to_angle(statement, reading)) {
        sphere = spheres::named_sphere(statement).or(sphere);
        left.push((sphere.filter(|_| named), statement));
    }
    let of_each = |(at, model): (usize, &Model)| {
        let asked = asked(model);
        if named && asked.is_none() {
            return None;
        }
        let of_same = |models: &[Model]| models.iter().filter(|other| asked_of(other, named) == asked).count();
        // `v_A = 2i + 2j so |v_A| = 2√2`
        if named && of_same(models) == 1 {
            return share(
                left.iter().filter(|(own, _)| *own == asked).map(|(_, statement)| (*statement).clone()).collect(),
            );
        }
        // Of one sphere its quantities are in the order asked, but that `56.3°` is no speed.
        let is_of_other_letter = |place: &usize| {
            let mut others = models.iter().filter(|other| other.letter != model.letter);
            others.any(|other| is_called_by_its_letter(other, left[*place].1))
        };
        let own = (0..left.len()).filter(|place| left[*place].0 == asked && !is_of_other_letter(place));
        let own: Vec<usize> = own.collect();
        let is_other_kind = |other: &Model| (other.kind == Kind::Angle) != (model.kind == Kind::Angle);
        let is_mixed = models.iter().any(|other| asked_of(other, named) == asked && is_other_kind(other));
        // `8.06, 82.9, 3, along the line of centres`: where all is there, and fewer are said to be angles than are asked, the
        // order tells.
        let angles = models[at..].iter().filter(|other| asked_of(other, named) == asked && other.kind == Kind::Angle);
        let angular = own.iter().filter(|place| is_angular(left[**place].1)).count();
        let is_by_order = angular < angles.count() && own.len() >= of_same(&models[at..]);
        let is_angle = model.kind == Kind::Angle;
        let is_of_kind =
            |place: &&usize| is_mixed && !(is_angle && is_by_order) && is_angular(left[**place].1) == is_angle;
        let is_in_order = |place: &&usize| {
            let is_speed = is_mixed && model.kind != Kind::Angle && is_angular(left[**place].1);
            !is_speed || own.len() >= of_same(&models[at..])
        };
        let is_of_component = |place: &&usize| velocity::is_of_component(model, left[**place].1) == Some(true);
        let is_of_letter = |place: &&usize| is_called_by_its_letter(model, left[**place].1);
        let of_component = own.iter().find(is_of_letter).or(own.iter().find(is_of_component));
        let place = of_component.or(own.iter().find(is_of_kind)).or(own.first().filter(is_in_order)).copied()?;
        share(vec![left.remove(place).1.clone()])
    };
    models.iter().enumerate().map(of_each).collect()
}

/// `tan α = 0.6 so α = 30.96°`: is it the tangent of what another statement names?
fn leads_to_angle(statement: &Statement, reading: &Reading) -> bool {
    let expr = |statement: &Statement| statement.label.as_ref().and_then(|label| label.expr.clone());
    let Some(Expr::Call(Function::Sin | Function::Cos | Function::Tan, angle)) = expr(statement) else { return false };
    reading.statements.iter().any(|other| expr(other).is_some_and(|named| named == *angle))
}

/// `13.3° at α = 38.3°`: is it called by the letter that is to be found?
fn is_called_by_its_letter(model: &Model, statement: &Statement) -> bool {
    let name = statement.label.as_ref().and_then(|label| label.expr.as_ref());
    matches!((name, &model.letter), (Some(Expr::Name(name)), Some(letter)) if name.text == *letter)
}

/// The sphere of which a thing is asked, where spheres are named.
fn asked_of(model: &Model, named: bool) -> Option<Sphere> {
    model.quantity.and_then(spheres::sphere).filter(|_| named)
}

/// `B: 5 m/s along the line of centres` where a speed and a direction are asked: two things in one.
fn with_directions_apart<'r>(models: &[Model], reading: &'r Reading) -> Cow<'r, Reading> {
    if !models.iter().any(|model| model.kind == Kind::Angle) {
        return Cow::Borrowed(reading);
    }
    let mut statements: Vec<Statement> = Vec::with_capacity(reading.statements.len());
    for statement in &reading.statements {
        let mut statement = statement.clone();
        let sphere = spheres::named_sphere(&statement);
        let direction = statement.said.last_mut().and_then(|said| {
            let is_size = matches!(said.form, Form::Value(_)) && !is_in_degrees(said);
            said.reference.take_if(|line| is_size && line.is_direction())
        });
        statements.push(statement);
        if direction.is_some() {
            let said = Said { form: Form::Direction, unit: None, reference: direction, remarks: Vec::new() };
            let label = sphere.map(|sphere| Label { typed: sphere.name().to_owned(), expr: None });
            statements.push(Statement { label, said: vec![said] });
        }
    }
    Cow::Owned(Reading { statements, ..reading.clone() })
}

/// Is it an angle, or a direction in words?
fn is_angular(statement: &Statement) -> bool {
    statement.said.last().is_some_and(|said| is_in_degrees(said) || matches!(said.form, Form::Direction))
}

fn is_in_degrees(said: &Said) -> bool {
    said.unit.as_ref().is_some_and(|unit| unit.degrees)
}
