//! Vectors: component by component, however they are written.

use crate::answer::Kind;
use crate::expr::{Expr, Function, Meaning, written};
use crate::mark::reading::{Form, Notation, Reading, Said, Statement, WAYS};

use super::accuracy::Written;
use super::exact;
use super::finding::Finding;
use super::sorts::words;
use super::spheres::{named_sphere, sphere};
use super::statements::{is_rival, pair, unnamed};
use super::units::{self, UnitCheck};
use super::{Model, Note, number, selection, sides};

/// The magnitude of a vector.
pub(super) fn magnitude(x: &Expr, y: &Expr) -> Expr {
    let square = |component: &Expr| component.clone().to_the(2);
    Expr::call(Function::Sqrt, Expr::Sum(vec![square(x), square(y)]))
}

/// The model's components.
pub(super) fn components(model: &Model) -> Option<(Expr, Expr)> {
    match model.known().meaning()? {
        Meaning::Vector(x, y) => Some((written(x), written(y))),
        _ => None,
    }
}

/// What was said, by its components.
pub(super) fn said_components(model: &Model, said: &Said) -> Option<(Expr, Expr, Notation)> {
    match &said.form {
        Form::Vector(x, y, notation) => Some((x.clone(), y.clone(), *notation)),
        Form::Value(expr) => match exact::meaning(expr, &model.vocabulary.letters)? {
            Meaning::Vector(x, y) => Some((written(&x), written(&y), Notation::UnitVectors)),
            _ => None,
        },
        Form::AtRest => Some((Expr::integer(0), Expr::integer(0), Notation::Words)),
        _ => None,
    }
}

/// A vector said component by component: `4 in the i direction, 1 in the j direction`, `i: 4, j: 1`; as coordinates are,
/// where no words say which is which: `4, 1`.
pub(super) fn of_its_components(model: &Model, reading: &Reading) -> Option<Said> {
    let [first, second] = pair_at_the_end(reading)?;
    let is_of_another = |statement: &Statement| {
        let asked = model.quantity.and_then(sphere);
        asked.is_some() && named_sphere(statement).is_some_and(|named| Some(named) != asked)
    };
    if is_of_another(first.0) {
        return None;
    }
    let nought = || Expr::integer(0);
    let of_whole = |statement: &Statement| statement.label.is_none() || std::ptr::eq(statement, first.0);
    let part = |(statement, said): (&Statement, &Said)| {
        let axis = statement.label.as_ref().and_then(|label| axis(&label.typed));
        let (x, y, notation) = match (&said.form, axis) {
            // `velocity 4 along i and 1 along j`
            (Form::Vector(x, y, Notation::Words), None) if of_whole(statement) => {
                (x.clone(), y.clone(), Notation::Words)
            }
            (Form::Vector(x, y, Notation::UnitVectors), None) if of_whole(statement) => {
                (x.clone(), y.clone(), Notation::Coordinates)
            }
            (Form::Value(value), Some('i')) => (value.clone(), nought(), Notation::Words),
            (Form::Value(value), Some('j')) => (nought(), value.clone(), Notation::Words),
            (Form::Value(value), Some('x')) => (value.clone(), nought(), Notation::Coordinates),
            (Form::Value(value), Some('y')) => (nought(), value.clone(), Notation::Coordinates),
            _ => return None,
        };
        let is_component = x.is_zero() != y.is_zero();
        is_component.then_some((x, y, notation))
    };
    let of_both = |one: Notation, other: Notation| if one == other { one } else { Notation::Coordinates };
    let (x, y, notation) = match (part(first), part(second)) {
        (Some((x, below, one)), Some((above, y, other))) if below.is_zero() && above.is_zero() => {
            (x, y, of_both(one, other))
        }
        (Some((left, y, one)), Some((x, right, other))) if left.is_zero() && right.is_zero() => {
            (x, y, of_both(one, other))
        }
        _ => (unnamed(first)?.clone(), unnamed(second)?.clone(), Notation::Coordinates),
    };
    let remarks = [first.1, second.1].into_iter().flat_map(|said| said.remarks.clone()).collect();
    Some(Said { form: Form::Vector(x, y, notation), unit: second.1.unit.clone(), reference: None, remarks })
}

/// Two things said, each with what leads to it: `x: 2 + 3 = 5, y: −1`.
fn pair_at_the_end(reading: &Reading) -> Option<[(&Statement, &Said); 2]> {
    let [first, second] = reading.statements.as_slice() else { return None };
    fn last(statement: &Statement) -> Option<(&Statement, &Said)> {
        let said = statement.said.last().filter(|_| statement.label.is_some() || statement.said.len() == 1);
        said.filter(|said| !is_rival(said)).map(|said| (statement, said))
    }
    Some([last(first)?, last(second)?])
}

/// Is a component still to be solved for, as in `2x = 4, y = −1`? Then it is no number where a vector is asked.
pub(super) fn is_unsolved_for_its_components(reading: &Reading) -> bool {
    let is_axis = |expr: &Expr| matches!(expr, Expr::Name(name) if axis(&name.text).is_some());
    let sides = |statement: &Statement| -> Vec<Expr> {
        let label = statement.label.iter().filter_map(|label| label.expr.clone());
        let equations = statement.said.iter().filter_map(|said| match &said.form {
            Form::Equation(relation) => Some(relation.clone()),
            _ => None,
        });
        label.chain(equations).collect()
    };
    let is_of_axes = |expr: &Expr| {
        let names = expr.names();
        !is_axis(expr) && !names.is_empty() && names.iter().all(|name| axis(&name.text).is_some())
    };
    reading.statements.iter().flat_map(sides).any(|side| is_of_axes(&side))
}

/// A size and an angle where a vector is asked: `4.25 m/s at 19.9° below i`. Which way it points is for a person to see.
pub(super) fn is_of_size_and_angle(model: &Model, reading: &Reading) -> Option<Finding> {
    let [(_, size), (_, angle)] = pair(reading)?;
    if selection::is_angular(size) || !selection::is_angular(angle) || !matches!(size.form, Form::Value(_)) {
        return None;
    }
    components(model)?;
    Some(if is_its_size(model, size) { Finding::unreadable(Note::DirectionUnchecked) } else { Finding::WRONG })
}

/// Two sizes along a line and across it where a vector is asked: `4 parallel to the wall and 3 away from it`. If they make
/// up its size, which way each points is for a person to see.
pub(super) fn is_of_components_by_a_line(model: &Model, reading: &Reading) -> Option<Finding> {
    let both = pair(reading)?;
    let says = |(statement, said): &(&Statement, &Said)| {
        let label = statement.label.as_ref().map(|label| label.typed.to_lowercase()).unwrap_or_default();
        said.reference.is_some() || label.contains("perp") || label.contains("parallel")
    };
    let value = |(_, said): &(&Statement, &Said)| match &said.form {
        Form::Value(value) => Some(value.clone()),
        _ => None,
    };
    let [first, second] = [value(&both[0])?, value(&both[1])?];
    let whole = Said { form: Form::Value(magnitude(&first, &second)), ..both[1].1.clone() };
    (both.iter().any(says) && is_its_size(model, &whole)).then(|| Finding::unreadable(Note::DirectionUnchecked))
}

/// Is it the size of the vector that is asked?
fn is_its_size(model: &Model, size: &Said) -> bool {
    components(model).is_some_and(|(x, y)| {
        let of_size = Model { kind: Kind::Number, ..model.of_value(magnitude(&x, &y)) };
        number::judge(&of_size, &Said { reference: None, ..size.clone() }, None).is_credited()
    })
}

/// Do words beside a value say which way it points?
fn tells_a_way(said: &Said) -> bool {
    said.remarks.iter().flat_map(|remark| words(remark)).any(|word| WAYS.contains(&word))
}

/// The axis along which a label says that a component lies: `i`, `v_x`, `vy`, `x component`.
fn axis(label: &str) -> Option<char> {
    let label = label.trim();
    // `i comp`, `in i`, `in the j direction`
    let ends = ["component", "comp", "direction"].into_iter().find_map(|end| label.strip_suffix(end));
    let word = ends.map_or(label, |axis| axis.trim_end_matches([' ', '-']));
    let word = ["in the ", "in ", "along "].into_iter().find_map(|start| word.strip_prefix(start)).unwrap_or(word);
    let mut letters = word.chars().rev();
    let axis = letters.next().filter(|last| matches!(last, 'i' | 'j' | 'x' | 'y'))?;
    let before: String = letters.rev().collect();
    // One letter for the velocity, and no sphere, may stand before it.
    let named = before.strip_suffix('_').unwrap_or(&before);
    (before.is_empty() || matches!(named, "u" | "v" | "w" | "V")).then_some(axis)
}

/// Judges one value against a vector.
pub(super) fn judge(model: &Model, said: &Said) -> Finding {
    let Some((right_x, right_y)) = components(model) else { return Finding::unreadable(Note::CannotBeCompared) };
    // `at rest along the line of centres`, `component is zero`: one of two.
    let is_of_line = said.reference.is_some_and(|line| line.is_direction());
    if matches!(said.form, Form::AtRest) && is_of_line {
        return Finding::unreadable(Note::NamedOtherwise);
    }
    let Some((x, y, notation)) = said_components(model, said) else {
        return match &said.form {
            // Nought is the one vector that is written like a number.
            Form::Value(expr) if expr.is_zero() && right_x.is_zero() && right_y.is_zero() => Finding::EXACT,
            Form::Value(expr) if exact::unknown_letter(expr, &model.vocabulary.letters).is_some() => {
                let bare = matches!(expr, Expr::Name(_));
                if bare { Finding::unreadable(Note::UnknownLetter) } else { Finding::wrong(Note::UnknownLetter) }
            }
            // `2 m/s to the right`: which way that is on the page is for a person to see.
            Form::Value(_) if tells_a_way(said) && is_its_size(model, said) => {
                Finding::unreadable(Note::DirectionUnchecked)
            }
            Form::Value(_) | Form::Percentage(_) => Finding::wrong(Note::ScalarForVector),
            Form::Mixed(_) => Finding::wrong(Note::NumberPlusVector),
            Form::Direction => Finding::unreadable(Note::CannotBeCompared),
            _ => Finding::WRONG,
        };
    };
    let (factor, unit_note, spoilt) = match units::check(model, said.unit.as_ref()) {
        UnitCheck::Fine => (None, None, None),
        UnitCheck::Converted(scale) => (Some(scale), Some(Note::UnitConverted), None),
        UnitCheck::Condoned(note) => (None, Some(note), None),
        UnitCheck::Spoilt(note) => (None, None, Some(note)),
    };
    let scaled = |component: &Expr| match &factor {
        Some(scale) => Expr::product([Expr::Number(scale.clone()), component.clone()]),
        None => component.clone(),
    };
    let (x, y) = (scaled(&x), scaled(&y));
    let mut finding = both(model, (&right_x, &x), (&right_y, &y));
    // `6 left and 2.4 down`: signs in words, on a page that nobody has drawn.
    let says = |side: &[&str]| said.remarks.iter().flat_map(|remark| words(remark)).any(|word| side.contains(&word));
    let is_turned = notation == Notation::Coordinates && says(&["left", "down", "west", "south"]);
    // `-3i + 2j to the right`
    let is_else =
        |said: Option<bool>, own: &Expr| said.zip(sides::is_positive(own)).is_some_and(|(said, own)| said != own);
    let is_to_another_side = is_else(sides::one_of(says(&["right"]), says(&["left"])), &right_x)
        || is_else(sides::one_of(says(&["up", "upwards"]), says(&["down", "downwards"])), &right_y);
    if finding.is_credited() && notation == Notation::UnitVectors && is_to_another_side {
        return Finding::unreadable(Note::DirectionUnchecked);
    }
    if is_turned || !finding.is_credited() && says(&["left", "down", "right", "up", "east", "west", "north", "south"]) {
        return Finding::unreadable(Note::DirectionUnchecked);
    }
    if !finding.is_credited() {
        return explain(model, (&right_x, &right_y), (&x, &y), finding);
    }
    if let Some(note) = unit_note {
        finding = finding.remarked(note);
    }
    if let Some(note) = spoilt {
        finding = finding.spoilt_by(note);
    }
    if notation == Notation::Coordinates { finding.spoilt_by(Note::Coordinates) } else { finding }
}

/// Each component against its own.
fn both(model: &Model, x: (&Expr, &Expr), y: (&Expr, &Expr)) -> Finding {
    let one = |(right, found): (&Expr, &Expr)| {
        let component = model.of_value(right.clone());
        number::value(&component, found, &Written::of(found))
    };
    one(x).and(one(y))
}

fn explain(model: &Model, right: (&Expr, &Expr), found: (&Expr, &Expr), finding: Finding) -> Finding {
    if both(model, (right.0, found.1), (right.1, found.0)).is_correct() {
        return Finding::wrong(Note::ComponentsExchanged);
    }
    let (x, y) = (found.0.clone().negated(), found.1.clone().negated());
    if both(model, (right.0, &x), (right.1, &y)).is_correct() {
        return Finding::wrong(Note::Sign);
    }
    finding
}
