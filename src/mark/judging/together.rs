//! One answer in which several things are asked, shared out to them.

use std::borrow::Cow;

use crate::answer::Kind;
use crate::mark::reading::{Form, Label, Reading, Said, Statement, Unreadable};

use super::finding::Finding;
use super::{BLANK, Judgement, Model, Note, one, refused, report, spheres};

/// Judges one answer in which several things are asked: labelled with their spheres, or in the order asked.
///
/// A thing that is not answered is blank.
pub fn judge_together(models: &[Model], readings: &Result<Vec<Reading>, Unreadable>) -> Vec<Judgement> {
    let readings = match readings {
        Ok(readings) => readings,
        Err(unreadable) => return models.iter().map(|_| refused(unreadable)).collect(),
    };
    let each = |reading: &Reading| -> Vec<Finding> {
        let shares = shared_out(models, &with_directions_apart(models, reading));
        models
            .iter()
            .zip(&shares)
            .map(|(model, share)| share.as_ref().map_or(BLANK, |share| one(model, share)))
            .collect()
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
    if !named {
        return (0..models.len()).map(|at| share(reading.statements.get(at).cloned().into_iter().collect())).collect();
    }
    // Within the statements of one sphere its quantities are in the order asked.
    let mut next = [0; 3];
    let mut sphere = None;
    let placed: Vec<(Option<_>, &Statement)> = reading
        .statements
        .iter()
        .map(|statement| {
            sphere = spheres::named_sphere(statement).or(sphere);
            (sphere, statement)
        })
        .collect();
    models
        .iter()
        .map(|model| {
            let asked = model.quantity.and_then(spheres::sphere)?;
            let own = placed.iter().filter(|(named, _)| *named == Some(asked)).map(|(_, statement)| *statement);
            let count = &mut next[asked as usize];
            *count += 1;
            share(own.clone().nth(*count - 1).cloned().into_iter().collect())
        })
        .collect()
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
            let is_size = matches!(said.form, Form::Value(_)) && !said.unit.as_ref().is_some_and(|unit| unit.degrees);
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
