//! Tests of each kind with readings made by hand: what a reader can hand over, and what it earns.

mod angles;
mod models;
mod numbers;
mod ratios_and_lines;
mod several;
mod vectors;
mod velocities;

use super::tests::{expr, model, named, reading, said};
use super::*;
use crate::expr::print;
use crate::mark::reading::{Form, Notation, ReferenceLine, Said, SaidUnit, read_answer};
use ReferenceLine::{AlongCommonTangent, AlongLineOfCentres, CommonTangent, FromBToA, I, LineOfCentres};

fn unit(typed: &str, dimension: [i8; 4], scale: &str) -> Option<SaidUnit> {
    Some(SaidUnit { typed: typed.to_owned(), dimension, scale: expr(scale), degrees: typed == "°" })
}

fn degrees() -> Option<SaidUnit> {
    unit("°", [0, 0, 0, 1], "1")
}

fn radians() -> Option<SaidUnit> {
    unit("rad", [0, 0, 0, 1], "1")
}

fn value(text: &str) -> Said {
    said(Form::Value(expr(text)))
}

fn earns(model: &Model, label: Option<&str>, said: Vec<Said>) -> String {
    named(&judge(model, &Ok(vec![reading(label, said)])))
}

fn states(model: &Model, statements: &[(Option<&str>, Said)]) -> String {
    let parts = statements.iter().flat_map(|(label, said)| reading(*label, vec![said.clone()]).statements).collect();
    named(&judge(model, &Ok(vec![Reading { statements: parts, ..reading(None, Vec::new()) }])))
}

fn asked(text: &str, kind: Option<Kind>, quantity: &str) -> Model {
    Model { quantity: Some(quantity.parse().unwrap()), ..model(text, kind, "") }
}

/// How answers fare as students type them, through the reader: what is right, its kind, what is typed, what it earns.
fn fare(rows: &[(&str, Option<Kind>, &str, &str)]) {
    for (right, kind, typed, expected) in rows {
        let model = Model::read(right, &ModelOptions { kind: *kind, ..ModelOptions::default() }).unwrap();
        let judged = judge(&model, &read_answer(typed, &model.vocabulary));
        assert_eq!(named(&judged), *expected, "{right}: {typed}");
    }
}
