//! What the student found: values to go on from.

use std::collections::BTreeMap;

use super::by_components::momentum_by_components;
use super::examine::{Examined, Studied, Value, value};
use super::pair::{Convention, sphere};
use super::points::sizes;
use super::prepared::{Prepared, complete};
use super::spread::Spread;
use crate::bank::Find;
use crate::expr::Expr;
use crate::mark::key::{KeyedPart, KeyedQuestion};
use crate::mark::reading::{Form, Reading};
use crate::mechanics::{Axis, Datum, Derivation, Known, Moment, Quantity, Setting, Sphere};

/// A value that is off by no more than that part of it is right, but perhaps for its figures.
const NEARLY_RIGHT: f64 = 0.01;

/// A student's own values, by quantity: at every point, and as they were written.
#[derive(Clone, Debug, Default)]
pub(crate) struct Theirs(pub(crate) BTreeMap<Quantity, (Vec<f64>, Expr)>);

impl Theirs {
    /// Those that are not right, as they were written.
    pub(crate) fn wrong<'t>(&'t self, question: &'t KeyedQuestion) -> impl Iterator<Item = (Quantity, &'t Expr)> {
        self.off_by_more_than(NEARLY_RIGHT, question)
    }

    /// Those that are right but for their figures.
    pub(crate) fn rounded<'t>(&'t self, question: &'t KeyedQuestion) -> impl Iterator<Item = (Quantity, &'t Expr)> {
        let wrong: Vec<Quantity> = self.wrong(question).map(|(quantity, _)| quantity).collect();
        self.off_by_more_than(1e-9, question).filter(move |(quantity, _)| !wrong.contains(quantity))
    }

    /// What the rest is solved again from, as it was written: nothing if all of it is right, and beside a wrong velocity
    /// the right ones, which are not found again from it.
    pub(crate) fn to_go_on_from(&self, question: &KeyedQuestion) -> Vec<(Quantity, Expr)> {
        let wrong: Vec<Quantity> = self.wrong(question).map(|(quantity, _)| quantity).collect();
        if wrong.is_empty() {
            return Vec::new();
        }
        // The velocity along the one line says what the speed says.
        let is_said =
            |quantity| question.along_its_line(quantity).is_some_and(|(along, _)| self.0.contains_key(&along));
        let is_kept = |quantity: &Quantity| {
            let is_velocity_after = matches!(quantity.of_its_impact(), Quantity::Velocity(_, Moment::After, _));
            (wrong.contains(quantity) || is_velocity_after) && !is_said(*quantity)
        };
        let kept = self.0.iter().filter(|(quantity, _)| is_kept(quantity));
        kept.map(|(quantity, (_, written))| (*quantity, written.clone())).collect()
    }

    fn off_by_more_than<'t>(
        &'t self,
        share: f64,
        question: &'t KeyedQuestion,
    ) -> impl Iterator<Item = (Quantity, &'t Expr)> {
        let right = |quantity: &Quantity| sizes(&question.prepared().known, *quantity).unwrap_or_default();
        let near = move |(own, right): (&f64, &f64)| (own - right).abs() <= share * right.abs();
        self.0.iter().filter_map(move |(quantity, (values, written))| {
            let is_right = values.iter().zip(&right(quantity)).all(near);
            (!is_right).then_some((*quantity, written))
        })
    }

    /// Takes the answers that were read as numbers, for the parts that follow: right or not, the student goes on with
    /// them.
    pub(crate) fn take_answers<'r>(
        &mut self,
        question: &KeyedQuestion,
        part: &KeyedPart,
        answers: impl Iterator<Item = Option<&'r [Reading]>>,
    ) {
        let prepared = question.prepared();
        for (blank, readings) in part.blanks.iter().zip(answers) {
            let Some(reading) = readings.and_then(|readings| readings.first()) else { continue };
            let Some(said) = reading.statements.last().and_then(|statement| statement.said.last()) else { continue };
            match (&blank.find, &said.form) {
                (Find::Quantity(quantity), Form::Value(expr)) if !quantity.is_angle() => {
                    let Some(numbers) = value(expr, prepared, &prepared.names).and_then(|values| numbers(&values))
                    else {
                        continue;
                    };
                    if let Some((along, is_negative)) = question.along_its_line(*quantity) {
                        let signed = |number: &f64| if is_negative { -number.abs() } else { number.abs() };
                        let written = if is_negative { expr.clone().negated() } else { expr.clone() };
                        let own = (numbers.iter().map(signed).collect(), written);
                        self.0.entry(along).or_insert(own);
                    }
                    self.0.insert(*quantity, (numbers, expr.clone()));
                }
                (Find::Vector(x, y), Form::Vector(along_i, along_j, _)) => {
                    for (quantity, expr) in [(x, along_i), (y, along_j)] {
                        let numbers = value(expr, prepared, &prepared.names).and_then(|values| numbers(&values));
                        self.0.extend(numbers.map(|numbers| (*quantity, (numbers, expr.clone()))));
                    }
                }
                _ => {}
            }
        }
    }
}

pub(super) fn numbers(values: &[Value]) -> Option<Vec<f64>> {
    let number = |value: &Value| match value {
        Value::Number(spread) => Some(spread.middle()),
        Value::Vector(..) => None,
    };
    values.iter().map(number).collect()
}

/// The values that the student states for quantities.
pub(super) fn own_values(
    lines: &[Studied],
    convention: Option<&Convention>,
    part: &KeyedPart,
    prepared: &Prepared,
) -> BTreeMap<Quantity, (Vec<f64>, Expr)> {
    let mut found = BTreeMap::new();
    let alone = asked_alone(lines, convention, part);
    let of_axes = letters_of_axes(lines, prepared);
    for studied in lines {
        let Some(reading) = &studied.reading else { continue };
        for (member, values) in reading.members.iter().zip(&studied.values) {
            let (Some(letter), Some(values)) = (&member.letter, values) else { continue };
            let numbers = numbers(values);
            if let (Some((_, component)), Some(numbers)) = (of_axes.iter().find(|(own, _)| own == letter), &numbers) {
                found.insert(*component, (numbers.clone(), member.expr.clone()));
                continue;
            }
            let place = convention.and_then(|convention| convention.letters.iter().position(|known| known == letter));
            // Where no equation says whose letter it is, it is of the sphere that is asked for.
            let place = place.and(alone.and_then(|of| Sphere::BOTH.into_iter().position(|one| one == of))).or(place);
            match (numbers, place, convention) {
                (Some(numbers), Some(place), Some(convention)) => {
                    let own = Quantity::Velocity(Sphere::BOTH[place], Moment::After, Axis::N);
                    // A letter may also be used for the speed that is found from it in the end.
                    if !is_asked_speed(part, Sphere::BOTH[place], &numbers, prepared) || !found.contains_key(&own) {
                        let sign = convention.signs[place];
                        let written = if sign < 0.0 { member.expr.clone().negated() } else { member.expr.clone() };
                        found.insert(own, (numbers.iter().map(|number| number * sign).collect(), written));
                    }
                }
                (None, ..) => {
                    let of = sphere(letter).or(unknown_sphere(prepared));
                    let vector = |component: fn(&Value) -> Option<Spread>| -> Option<Vec<f64>> {
                        values.iter().map(|value| component(value).map(Spread::middle)).collect()
                    };
                    let is_after = letter.starts_with(['v', 'V', 'w', 'W', 'x', 'y', 'X', 'Y']);
                    if let (Some(of), true) = (of, is_after)
                        && let (Some(x), Some(y)) = (vector(first), vector(second))
                        && let Expr::Vector(along_i, along_j) = &member.expr
                    {
                        found.insert(Quantity::Velocity(of, Moment::After, Axis::X), (x, (**along_i).clone()));
                        found.insert(Quantity::Velocity(of, Moment::After, Axis::Y), (y, (**along_j).clone()));
                    }
                }
                // Of the one velocity that is to be found in a straight line.
                (Some(numbers), None, None) if prepared.setting == Setting::Direct => {
                    let is_velocity = letter.starts_with(['v', 'V', 'w', 'W', 'x', 'y', 'X', 'Y']);
                    if let Some(of) = sphere(letter).or(unknown_sphere(prepared)).filter(|_| is_velocity) {
                        found.insert(Quantity::Velocity(of, Moment::After, Axis::N), (numbers, member.expr.clone()));
                    }
                }
                _ => {}
            }
        }
        if let Some(convention) = convention.filter(|_| studied.matched.is_empty()) {
            for (place, expr) in reading.equations.iter().filter_map(|equation| of_multiple(equation, convention)) {
                let values = value(&expr, prepared, &prepared.names).and_then(|values| numbers(&values));
                let sign = convention.signs[place];
                let written = if sign < 0.0 { expr.negated() } else { expr };
                let own = Quantity::Velocity(Sphere::BOTH[place], Moment::After, Axis::N);
                // What is said of the letter itself goes before.
                if let Some(numbers) = values {
                    let signed = numbers.iter().map(|number| number * sign).collect();
                    found.entry(own).or_insert((signed, written));
                }
            }
        }
    }
    let is_own = |quantity: &Quantity| !prepared.given[0].0.contains_key(quantity);
    found.retain(|quantity, (values, _)| is_own(quantity) && values.iter().all(|value| value.is_finite()));
    found
}

/// Letters for the components along i and j of the velocity that is to be found, where momentum is written out along each.
fn letters_of_axes(lines: &[Studied], prepared: &Prepared) -> Vec<(String, Quantity)> {
    let Some((of, [x, y])) = unknown_sphere(prepared).zip(momentum_by_components(lines, prepared)) else {
        return Vec::new();
    };
    let component = |axis| Quantity::Velocity(of, Moment::After, axis);
    match x.letter == y.letter {
        true => Vec::new(),
        false => vec![(x.letter, component(Axis::X)), (y.letter, component(Axis::Y))],
    }
}

/// `10v = 18 - 42e`: the place of the unknown, and what it is, in the student's direction.
fn of_multiple((left, right): &(Expr, Expr), convention: &Convention) -> Option<(usize, Expr)> {
    let has_unknown = |expr: &Expr| expr.names().iter().any(|name| convention.letters.contains(&name.text));
    let place = |expr: &Expr| match expr {
        Expr::Name(name) => convention.letters.iter().position(|letter| *letter == name.text),
        _ => None,
    };
    let of = |side: &Expr, other: &Expr| {
        let Expr::Product(factors) = side else { return None };
        let (unknown, known): (Vec<&Expr>, Vec<&Expr>) = factors.iter().partition(|factor| has_unknown(factor));
        let ([unknown], false) = (unknown.as_slice(), has_unknown(other)) else { return None };
        let known = Expr::Product(known.into_iter().cloned().collect());
        Some((place(unknown)?, Expr::Quotient(Box::new(other.clone()), Box::new(known))))
    };
    of(left, right).or_else(|| of(right, left))
}

/// The one sphere of which a part asks for the velocity, where no line is a law and one letter alone is used.
fn asked_alone(lines: &[Studied], convention: Option<&Convention>, part: &KeyedPart) -> Option<Sphere> {
    let is_used = |letter: &&String| {
        let mut members =
            lines.iter().filter_map(|studied| studied.reading.as_ref()).flat_map(|reading| &reading.members);
        members.any(|member| member.letter.as_ref() == Some(*letter))
    };
    let is_law = lines.iter().any(|studied| !studied.matched.is_empty());
    if is_law || convention?.letters.iter().filter(is_used).count() != 1 {
        return None;
    }
    let letter = convention?.letters.iter().find(is_used)?;
    let mut asked = part.blanks.iter().flat_map(|blank| blank.find.quantities());
    let of = asked.next()?.sphere().filter(|_| sphere(letter).is_none())?;
    asked.all(|quantity| quantity.sphere() == Some(of)).then_some(of)
}

fn first(value: &Value) -> Option<Spread> {
    match value {
        Value::Vector(x, _) => Some(*x),
        Value::Number(_) => None,
    }
}

fn second(value: &Value) -> Option<Spread> {
    match value {
        Value::Vector(_, y) => Some(*y),
        Value::Number(_) => None,
    }
}

/// Is the value the speed that the part asks for, rather than the component?
fn is_asked_speed(part: &KeyedPart, sphere: Sphere, values: &[f64], prepared: &Prepared) -> bool {
    let speed = Quantity::Speed(sphere, Moment::After);
    let asked = part.blanks.iter().any(|blank| blank.find.quantities().contains(&speed));
    let right = sizes(&prepared.known, speed);
    asked
        && right
            .is_some_and(|right| right.iter().zip(values).all(|(right, value)| (right - value).abs() < 0.006 * right))
}

/// The sphere whose velocity after the impact is to be found, where that of the other is given.
pub(super) fn unknown_sphere(prepared: &Prepared) -> Option<Sphere> {
    let given = |sphere| prepared.given[0].0.contains_key(&Quantity::Velocity(sphere, Moment::After, Axis::X));
    match (given(Sphere::A), given(Sphere::B)) {
        // A particle that receives an impulse is alone.
        _ if prepared.setting == Setting::Impulse => Some(Sphere::A),
        (true, false) => Some(Sphere::B),
        (false, true) => Some(Sphere::A),
        _ => None,
    }
}

/// What is given and the student's own values, to go on from, at every point.
///
/// A value that would make the rest trivial is not followed: nought where nothing is nought, a coefficient of restitution
/// that is none.
fn start(prepared: &Prepared, theirs: &Theirs) -> Vec<Known<f64>> {
    let mut at_points = prepared.given.clone();
    for (quantity, (values, _)) in &theirs.0 {
        let right = sizes(&prepared.known, *quantity);
        let trivial = match quantity {
            Quantity::Restitution => values.iter().any(|value| !(0.0..=1.0).contains(value)),
            _ => right
                .is_some_and(|right| right.iter().zip(values).any(|(right, own)| *own == 0.0 && right.abs() > 1e-9)),
        };
        if !trivial {
            for (known, value) in at_points.iter_mut().zip(values) {
                known.0.insert(*quantity, Datum::Number(*value));
            }
        }
    }
    for sphere in Sphere::BOTH {
        let energies = energies_by_speed(prepared, theirs, sphere);
        for (known, [after, lost]) in at_points.iter_mut().zip(energies.into_iter().flatten()) {
            known.0.insert(Quantity::KineticEnergy(sphere, Moment::After), Datum::Number(after));
            known.0.insert(Quantity::SphereEnergyLost(sphere), Datum::Number(lost));
        }
    }
    at_points
}

/// The energy of a sphere after the impact and what it has lost, at every point, where the student has a wrong speed for it
/// and no wrong component from which that comes.
fn energies_by_speed(prepared: &Prepared, theirs: &Theirs, sphere: Sphere) -> Option<Vec<[f64; 2]>> {
    let right = |quantity| sizes(&prepared.known, quantity);
    let own_if_wrong = |quantity: Quantity| {
        let (own, _) = theirs.0.get(&quantity)?;
        let near = |(own, right): (&f64, &f64)| (own.abs() - right.abs()).abs() <= NEARLY_RIGHT * right.abs();
        (!own.iter().zip(&right(quantity)?).all(near)).then_some(own)
    };
    let speeds = own_if_wrong(Quantity::Speed(sphere, Moment::After))?;
    let mut components =
        [Axis::N, Axis::T, Axis::X, Axis::Y].into_iter().map(|axis| Quantity::Velocity(sphere, Moment::After, axis));
    if components.any(|component| own_if_wrong(component).is_some()) {
        return None;
    }
    let (masses, before) = (right(Quantity::Mass(sphere))?, right(Quantity::Speed(sphere, Moment::Before))?);
    let each = speeds.iter().zip(masses).zip(before);
    Some(each.map(|((own, mass), before)| [own * own, before * before - own * own].map(|it| mass * it / 2.0)).collect())
}

/// Everything that follows from what is given and from the student's own values.
pub(super) fn follow(prepared: &Prepared, theirs: &Theirs) -> Vec<Known<f64>> {
    if theirs.0.is_empty() {
        return prepared.known.clone();
    }
    start(prepared, theirs).iter().map(complete).collect()
}

/// What follows for one quantity at every point.
pub(super) fn follow_to(prepared: &Prepared, theirs: &Theirs, quantity: Quantity) -> Option<Vec<f64>> {
    let mut start = start(prepared, theirs);
    start.iter_mut().for_each(|known| drop(Derivation::carry_out(known, &[quantity])));
    sizes(&start, quantity)
}

/// By no more than this part of it do figures that were dropped move what follows, or nothing can be said.
const NEAR: f64 = 0.05;

/// The most values of the student's own that are taken as rounded at once.
const MOST_ROUNDED: usize = 4;

/// What may follow for a quantity where the student's own decimals are what they were before they were rounded: who writes
/// 3.05 and goes on with what the calculator holds has something from 3.045 to 3.055. Only where nothing is a letter.
fn follow_unrounded(prepared: &Prepared, theirs: &Theirs, quantity: Quantity) -> Option<Spread> {
    let width = |written: &Expr| rounded(written, prepared);
    let own = theirs.0.iter().filter_map(|(quantity, (_, written))| Some((*quantity, width(written)?)));
    let own: Vec<(Quantity, Spread)> = own.take(MOST_ROUNDED).collect();
    let mut found: Option<Spread> = None;
    for corner in 0..1_u32 << own.len() {
        let mut theirs = theirs.clone();
        for (place, (quantity, spread)) in own.iter().enumerate() {
            let end = if corner >> place & 1 == 0 { spread.low } else { spread.high };
            if let Some((values, _)) = theirs.0.get_mut(quantity) {
                *values = vec![end];
            }
        }
        let [end] = follow_to(prepared, &theirs, quantity)?.as_slice().try_into().ok()?;
        let (low, high) = found.map_or((end, end), |found| (found.low.min(end), found.high.max(end)));
        found = Some(Spread::of(low, high)?);
    }
    found
}

/// What a decimal was before it was rounded; nothing of what is exact, or has too few figures to be taken as rounded.
fn rounded(written: &Expr, prepared: &Prepared) -> Option<Spread> {
    match value(written, prepared, &prepared.names)?.as_slice() {
        [Value::Number(spread)] if spread.low < spread.high => Some(*spread),
        _ => None,
    }
}

impl Examined {
    /// The size nearest to an answer that follows for a quantity from the student's own values as they may have been
    /// before they were rounded; `as_written` is what follows from them as they stand. Nothing for an answer far from that.
    pub(crate) fn followed_unrounded(
        &self,
        question: &KeyedQuestion,
        (quantity, as_written): (Quantity, f64),
        answer: &Expr,
    ) -> Option<f64> {
        let prepared = question.prepared();
        let answer = rounded(answer, prepared)?.middle().abs();
        if (answer - as_written.abs()).abs() > NEAR * answer {
            return None;
        }
        let Spread { low, high } = follow_unrounded(prepared, &self.theirs, quantity)?;
        let (least, greatest) = (low.abs().min(high.abs()), low.abs().max(high.abs()));
        (low * high > 0.0).then(|| answer.clamp(least, greatest))
    }
}
