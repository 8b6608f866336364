//! What is told beside the answer and is no rival of it: the direction of a speed, the size of a vector, a bound that a value
//! meets, the name of a line.

use std::cmp::Ordering;

use crate::answer::{Accept, Kind};
use crate::expr::{Expr, Function, Relation};
use crate::mark::reading::{Form, ReferenceLine, Said, Statement, greek};
use crate::mechanics::Quantity;
use crate::number::Places;
use crate::unit::Unit;

use super::selection::{holds, is_angular, order};
use super::sorts::{Sort, sort, words};
use super::statements::is_rival;
use super::{Model, angle, letters, number, spheres, vector};

/// `u(1-e)/2 > 0`, `3.57 < 5`: what is remarked of the only value there is, where that is so.
pub(super) fn compared_with_a_bound(model: &Model, mut statements: Vec<Statement>) -> Vec<Statement> {
    if let [Statement { label: None, said }] = statements.as_mut_slice()
        && let [Said { form, .. }] = said.as_mut_slice()
        && let Form::Equation(Expr::Relation(value, relation, bound)) = form
        && !matches!(**value, Expr::Name(_))
        && !matches!(relation, Relation::Equal | Relation::NotEqual)
        && order(model, value, bound).is_some_and(|sign| holds(*relation, sign))
    {
        *form = Form::Value((**value).clone());
    }
    statements
}

/// `the direction of the line of centres is i - 3j`: what the line is called.
pub(super) fn without_its_name(statements: Vec<Statement>) -> Vec<Statement> {
    let is_name = |statement: &Statement| match statement.said.as_slice() {
        [said] => {
            let line = said.reference.map(ReferenceLine::unsensed);
            said.form == Form::Direction && line == Some(ReferenceLine::AlongLineOfCentres) && !is_rival(said)
        }
        _ => false,
    };
    let kept: Vec<Statement> = statements.iter().filter(|statement| !is_name(statement)).cloned().collect();
    if kept.is_empty() { statements } else { kept }
}

/// `4i + j (speed √17)`, `4i + j at 14.0° to i`: the size of the vector and its direction, told besides, where they are
/// right as far as they go.
pub(super) fn without_size_and_direction(model: &Model, statements: Vec<Statement>) -> Vec<Statement> {
    let is_vector = |statement: &Statement| statement.said.iter().any(|said| matches!(said.form, Form::Vector(..)));
    if statements.len() < 2 || !statements.iter().any(is_vector) {
        return statements;
    }
    let Some((x, y)) = vector::components(model) else { return statements };
    let of = |kind: Kind, value: Expr| {
        let accept = Accept::RoundsTo(Places::SignificantFigures(3));
        Model { kind, accept, ..model.of_value(value) }
    };
    let of_size = of(Kind::Number, vector::magnitude(&x, &y));
    let is_called_a_size = |statement: &Statement| {
        let is_size = |word: &str| matches!(&*word.to_lowercase(), "speed" | "magnitude" | "size");
        let names_size = |label: &str| label.starts_with('|') || words(label).any(is_size);
        statement.label.as_ref().is_none_or(|label| names_size(&label.typed))
    };
    let is_size = |said: &Said| !is_angular(said) && number::judge(&of_size, said, None).is_credited();
    let is_direction = |said: &Said| {
        let slopes: &[(&Expr, &Expr)] = match said.reference {
            _ if !is_angular(said) => &[],
            None => &[(&x, &y), (&y, &x)],
            Some(ReferenceLine::I) => &[(&x, &y)],
            Some(ReferenceLine::J) => &[(&y, &x)],
            Some(_) => &[],
        };
        let bare = Said { reference: None, ..said.clone() };
        let fits = |(along, across): &(&Expr, &Expr)| {
            let size = |part: &Expr| Expr::call(Function::Abs, part.clone());
            let acute = Expr::call(Function::Atan, size(across).over(size(along)));
            let obtuse = Expr::Sum(vec![Expr::degrees(Expr::integer(180)), acute.clone().negated()]);
            let is = |angle: Expr| angle::judge(&of(Kind::Angle, angle), &bare, None).is_credited();
            let points_back = || order(model, along, &Expr::integer(0)) == Some(Ordering::Less);
            is(acute) || (points_back() && is(obtuse))
        };
        slopes.iter().any(fits)
    };
    let is_besides = |statement: &Statement| {
        let is_right = |said: &Said| matches!(said.form, Form::Value(_)) && (is_size(said) || is_direction(said));
        is_called_a_size(statement)
            && !statement.said.is_empty()
            && !statement.said.iter().any(is_rival)
            && statement.said.iter().all(is_right)
    };
    statements.into_iter().filter(|statement| !is_besides(statement)).collect()
}

/// Is it called an angle?
fn is_called_an_angle(statement: &Statement) -> bool {
    statement.label.as_ref().is_some_and(|label| match &label.expr {
        Some(Expr::Name(name)) => number::is_angle_name(&name.text),
        Some(_) => false,
        None => words(&label.typed).any(|word| word.eq_ignore_ascii_case("angle")),
    })
}

/// `46.1°, deflected by 16.1°`, `46.1° (16.1° deflection)`
fn is_called_a_deflection(statement: &Statement) -> bool {
    let label = statement.label.iter().map(|label| label.typed.as_str());
    let called = label.chain(statement.remarks().map(String::as_str));
    called.flat_map(words).filter_map(sort).any(|sort| sort == Sort::Deflection)
}

/// `3.61 m/s at 56.3° to the line of centres`, where the speed or the direction is asked: the other is told besides. A
/// direction in words goes with the one value that is left.
pub(super) fn without_told_besides(model: &Model, statements: Vec<Statement>) -> Vec<Statement> {
    let Some(unit) = model.unit() else { return statements };
    let statements = without_the_other_of_a_pair(unit, statements);
    let statements = match model.quantity {
        Some(asked) => without_loss_or_share(asked, statements),
        None => statements,
    };
    let is_deflection = matches!(
        model.quantity,
        Some(Quantity::Deflection(_) | Quantity::SignedDeflection(_) | Quantity::AngleBetween(_))
    );
    let all_from_path = statements
        .iter()
        .flat_map(|statement| &statement.said)
        .all(|said| said.reference == Some(ReferenceLine::OriginalDirection));
    let is_besides = |statement: &Statement| {
        let Some(said) = statement.said.last().filter(|said| !is_rival(said)) else { return false };
        match (&said.form, unit) {
            (_, Unit::None) => false,
            (Form::Value(_), Unit::Degree) => {
                // `79.4° to LOC (26.3° from the original direction)`
                let is_from_path = said.reference == Some(ReferenceLine::OriginalDirection);
                let is_turn = is_called_a_deflection(statement) || is_from_path && !all_from_path;
                (said.unit.is_some() && !is_angular(said)) || (!is_deflection && is_turn)
            }
            (_, Unit::Degree) => false,
            (Form::Value(_), _) => is_angular(said) || (said.unit.is_none() && is_called_an_angle(statement)),
            (Form::Direction, _) => true,
            _ => false,
        }
    };
    let (besides, mut kept): (Vec<Statement>, Vec<Statement>) = statements.iter().cloned().partition(is_besides);
    if kept.is_empty() {
        return statements;
    }
    let directions: Vec<ReferenceLine> = besides
        .iter()
        .flat_map(|statement| &statement.said)
        .filter(|said| said.form == Form::Direction)
        .filter_map(|said| said.reference)
        .collect();
    // `2.78 (component along LOC)`
    if let ([only], [Statement { label: Some(label), .. }]) = (kept.as_mut_slice(), besides.as_slice())
        && only.label.is_none()
        && label.typed.to_lowercase().starts_with("comp")
    {
        only.label = Some(label.clone());
    }
    if let ([Statement { said, .. }], [direction]) = (kept.as_mut_slice(), directions.as_slice())
        && let Some(last) = said.last_mut()
        && last.reference.is_none()
    {
        last.reference = Some(*direction);
    }
    kept
}

/// `1.92 J (35.3%)`: the one told besides the other, where a share or what it is a share of is asked.
fn without_loss_or_share(asked: Quantity, statements: Vec<Statement>) -> Vec<Statement> {
    let is_besides = |said: &Said| match &said.form {
        Form::Percentage(_) => asked.unit() != Unit::None,
        _ => asked == Quantity::FractionLost && said.unit.as_ref().is_some_and(|unit| unit.dimension == [1, 2, -2, 0]),
    };
    let is_kept =
        |statement: &&Statement| !matches!(statement.said.as_slice(), [said] if is_besides(said) && !is_rival(said));
    let kept: Vec<Statement> = statements.iter().filter(is_kept).cloned().collect();
    if kept.is_empty() { statements } else { kept }
}

/// `2.78 at 46.1`, `3.57 at 81.9° to LOC`: what stands before `at` is a size and what stands after it a direction, though
/// neither has its unit.
fn without_the_other_of_a_pair(unit: Unit, mut statements: Vec<Statement>) -> Vec<Statement> {
    let is_bare = |statement: &Statement| match statement.said.as_slice() {
        [said] => matches!(said.form, Form::Value(_)) && said.unit.is_none() && !is_rival(said),
        _ => false,
    };
    let is_joined = |said: &Said| said.remarks.iter().any(|remark| remark == "at");
    match statements.as_slice() {
        [size, direction] if direction.said.first().is_some_and(is_joined) => {
            if unit == Unit::Degree && is_bare(size) && !size.said.iter().any(is_angular) {
                statements.remove(0);
            } else if !matches!(unit, Unit::Degree | Unit::None) && is_bare(direction) && direction.label.is_none() {
                statements.truncate(1);
            }
        }
        _ => {}
    }
    statements
}

/// The letter of an aside in brackets, as w in `5 (w = 15)`.
pub(super) fn letter_of_aside(remark: &str) -> Option<&str> {
    let (before, _) = remark.strip_prefix('(')?.strip_suffix(')')?.split_once('=')?;
    before.split_whitespace().last()
}

/// The letter whose value tells where another value is reached, as α in `13.3° when α = 38.3°`.
pub(super) fn letter_of_place(remark: &str) -> Option<&str> {
    let place = ["when ", "for "].into_iter().find_map(|word| remark.strip_prefix(word))?;
    Some(place.split_once('=')?.0.trim())
}

/// Do words beside a value tell another value of what is asked? `5 (v = 6)`; in `v_A = 5 (v_B = 15)` it is of the other sphere.
pub(super) fn is_told_otherwise(model: &Model, statement: &Statement) -> bool {
    let is_of_other = |letter: &str| spheres::is_of_the_other_by_custom(model, letter);
    let is_called =
        |own: &str, letter: &str| own == letter || greek(own).is_some_and(|(sign, _)| letter.chars().eq([sign]));
    let is_asked = |letter: &str| model.letter.as_ref().is_some_and(|own| is_called(own, letter));
    // `13.3° (α = 38.3°)`, where α is a letter of the question and another thing is asked.
    let is_of_question =
        |letter: &str| !is_asked(letter) && model.vocabulary.letters.iter().any(|own| is_called(own.name(), letter));
    let mut places = statement.remarks().filter_map(|remark| letter_of_place(remark));
    let mut letters = statement.remarks().filter_map(|remark| letter_of_aside(remark));
    places.any(is_asked)
        || letters.any(|letter| {
            letters::may_be_called(model, letter, letter) && !is_of_other(letter) && !is_of_question(letter)
        })
}
