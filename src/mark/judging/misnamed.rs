//! Words by which a right value is something else than any question asks: an extreme, a total, a ratio, a wall's speed, a state
//! that is only nearly so.

use crate::answer::Kind;
use crate::mark::reading::{Form, LEAST, MOST, NOT_QUITE, PAST, Reading, SIZES, Said, Statement};
use crate::mechanics::{Moment, Quantity};
use crate::unit::Unit;

use super::Model;
use super::moments::{LATER, moment};
use super::sorts::words;

/// Words for several things together.
const TOGETHER: [&str; 3] = ["total", "both", "combined"];
/// Words for an instance among others.
const INSTANCES: [&str; 3] = ["eg", "e.g", "e.g."];
/// Words for impacts after the first.
const LATER_ONES: [&str; 5] = ["second", "2nd", "third", "3rd", "next"];
/// Words for an impact.
const IMPACTS: [&str; 3] = ["collision", "impact", "bounce"];

/// Do the words around the value make it something else?
pub(super) fn is_of_something_else(model: &Model, reading: &Reading) -> bool {
    let one = |statement: &Statement| {
        let label = statement.label.as_ref().map(|label| label.typed.to_lowercase()).unwrap_or_default();
        model.quantity.is_some_and(|asked| is_called_otherwise(asked, &label))
            || statement.said.iter().any(|said| is_said_otherwise(model, said))
    };
    let is_alone = reading.statements.len() == 1;
    // `from 2.78`, but `8, from 42.5 - 34.5`
    let is_source = |statement: &Statement| statement.remarks().any(|remark| remark.trim() == "from");
    let is_alone_else = |statement: &Statement| is_source(statement) || is_a_part_or_a_size(model, statement);
    reading.statements.iter().any(one) || is_alone && reading.statements.iter().any(is_alone_else)
}

fn has(text: &str, wanted: &[&str]) -> bool {
    words(text).any(|word| wanted.contains(&word))
}

/// `greatest speed`, `total speed`, `speed of the wall`, `ratio`, `speed after the second collision` of one.
fn is_called_otherwise(asked: Quantity, label: &str) -> bool {
    let is_speed = matches!(asked.of_its_impact(), Quantity::Speed(..) | Quantity::Velocity(..));
    // Nobody asks for the least. The greatest deflection is asked for, and so is the angle for it.
    let is_extreme = has(label, &LEAST) || !asked.is_angle() && has(label, &MOST);
    let is_of_wall = has(label, &["wall"]) && (label.contains("of the wall") || label.contains("of wall"));
    let is_of_several = has(label, &TOGETHER) || is_of_wall;
    let is_ratio = asked.unit() != Unit::None && has(label, &["ratio"]);
    is_extreme || is_speed && is_of_several || is_ratio || is_after_a_later_impact(asked, label)
}

/// Is the first impact asked about, and a later one named?
fn is_after_a_later_impact(asked: Quantity, label: &str) -> bool {
    let words: Vec<&str> = words(label).collect();
    let is_later = words.windows(2).any(|pair| LATER_ONES.contains(&pair[0]) && IMPACTS.contains(&pair[1]));
    asked.impact() == 0 && moment(asked) == Some(Moment::After) && words.contains(&"after") && is_later
}

/// `nearly 4i + j`, `B was at rest`, `at rest then moves`, `e.g. 2.78`, `2.78 ratio`.
fn is_said_otherwise(model: &Model, said: &Said) -> bool {
    let remarked = |wanted: &[&str]| said.remarks.iter().any(|remark| has(remark, wanted));
    let is_sharp = matches!(model.kind, Kind::Vector | Kind::Velocity | Kind::Range | Kind::Line);
    if is_sharp && remarked(&NOT_QUITE) {
        return true;
    }
    let is_instance = said.remarks.iter().any(|remark| INSTANCES.contains(&remark.trim()));
    let is_number = matches!(model.kind, Kind::Number | Kind::Expression | Kind::Angle | Kind::Vector);
    if is_number && is_instance {
        return true;
    }
    let is_sized = model.quantity.is_some_and(|asked| asked.unit() != Unit::None);
    if is_sized && remarked(&["ratio"]) {
        return true;
    }
    // `no component along the line of centres`
    let is_speed = matches!(model.quantity.map(Quantity::of_its_impact), Some(Quantity::Speed(..)));
    if is_speed && remarked(&["component", "components"]) {
        return true;
    }
    let is_after = model.quantity.and_then(moment) == Some(Moment::After);
    said.form == Form::AtRest && is_after && (remarked(&PAST) && !remarked(&LATER) || goes_on(said))
}

/// Does it move after all: `at rest, then moves`?
fn goes_on(said: &Said) -> bool {
    const MOVES: [&str; 5] = ["moves", "move", "starts", "travels", "accelerates"];
    let is_filler = |word: &&str| matches!(*word, "" | "then" | "and");
    said.remarks
        .iter()
        .filter_map(|remark| words(remark).find(|word| !is_filler(word)))
        .any(|word| MOVES.contains(&word))
}

/// Is it one component, or the size, where a vector is asked?
fn is_a_part_or_a_size(model: &Model, statement: &Statement) -> bool {
    let label = statement.label.as_ref().map(|label| label.typed.to_lowercase()).unwrap_or_default();
    let is_named = |wanted: &[&str]| has(&label, wanted) || statement.remarks().any(|remark| has(remark, wanted));
    let is = |wanted: fn(&Form) -> bool| statement.said.iter().any(|said| wanted(&said.form));
    model.kind == Kind::Vector
        && (is(|form| matches!(form, Form::Value(_))) && is_named(&["component", "comp"])
            || is(|form| matches!(form, Form::Vector(..))) && has(&label, &SIZES))
}
