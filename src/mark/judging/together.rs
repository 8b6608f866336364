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
        let mut statements = reading.statements.iter().peekable();
        let of_one = |(at, model): (usize, &Model)| {
            // `56.3°` by itself is no speed.
            let is_missing = statements.len() < models.len() - at
                && model.kind != Kind::Angle
                && models[at..].iter().any(|later| later.kind == Kind::Angle);
            let next = statements.next_if(|next| !(is_missing && next.said.last().is_some_and(is_in_degrees)));
            share(next.cloned().into_iter().collect())
        };
        return models.iter().enumerate().map(of_one).collect();
    }
    // Within the statements of one sphere its quantities are in the order asked.
    let mut next = [0; 3];
    // `7.21 at 56.3° to the line of centres, B 6`: what stands before the second sphere is of the first.
    let first_named = reading.statements.iter().find_map(spheres::named_sphere);
    let first_asked = models.iter().find_map(|model| model.quantity.and_then(spheres::sphere));
    let mut sphere = first_asked.filter(|asked| first_named.is_some_and(|named| named > *asked));
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
            let is_alone = models
                .iter()
                .filter_map(|model| model.quantity.and_then(spheres::sphere))
                .filter(|sphere| *sphere == asked)
                .count()
                == 1;
            // `v_A = 2i + 2j so |v_A| = 2√2`
            if is_alone {
                return share(own.cloned().collect());
            }
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

fn is_in_degrees(said: &Said) -> bool {
    said.unit.as_ref().is_some_and(|unit| unit.degrees)
}
