//! What the student found: values to go on from.

use std::collections::BTreeMap;

use super::equations::{Convention, sphere};
use super::examine::{Studied, Value};
use super::laws::{momentum_by_components, multiple};
use super::letters::{Slip, whole};
use super::numbers::{Spread, sizes};
use super::prepared::Prepared;
use crate::bank::Find;
use crate::expr::{Expr, written};
use crate::mark::key::{KeyedPart, KeyedQuestion};
use crate::mark::reading::{Form, Reading};
use crate::mechanics::{Axis, Derivation, Known, Moment, Quantity, Setting, Sphere};

/// A value that is off by no more than that part of it is right, but perhaps for its figures.
const NEARLY_RIGHT: f64 = 0.01;

/// Is it right, but perhaps for its figures?
pub(super) fn is_nearly_right(own: f64, right: f64) -> bool {
    is_near(NEARLY_RIGHT, own, right)
}

fn is_near(share: f64, own: f64, right: f64) -> bool {
    (own - right).abs() <= share * right.abs()
}

/// What a student found.
#[derive(Clone, Debug, Default)]
pub(crate) struct Theirs {
    /// Values of quantities: at every point, and as they were written.
    pub(crate) values: BTreeMap<Quantity, (Vec<f64>, Expr)>,
    /// Numbers that were worked out wrongly.
    pub(super) slips: Vec<Slip>,
    /// The letters that equations have for the velocities of A and B after the first impact, with their signs.
    pub(super) letters: Option<([String; 2], [f64; 2])>,
    /// At a later impact, what was found of those before it, as it was written.
    pub(super) earlier: BTreeMap<Quantity, Expr>,
    /// Letters for what is known, with what they stand for.
    pub(super) meant: Vec<(String, Expr)>,
}

impl Theirs {
    /// Those that are not right, as they were written.
    pub(crate) fn wrong<'t>(&'t self, question: &'t KeyedQuestion) -> impl Iterator<Item = (Quantity, &'t Expr)> {
        self.off_by_more_than(NEARLY_RIGHT, question)
    }

    /// The components of velocities after the impact that are right.
    pub(crate) fn right_velocities(&self, question: &KeyedQuestion) -> Vec<Quantity> {
        let wrong: Vec<Quantity> = self.wrong(question).map(|(quantity, _)| quantity).collect();
        let is_velocity = |quantity: &Quantity| matches!(quantity, Quantity::Velocity(_, Moment::After, _));
        self.values.keys().copied().filter(|quantity| is_velocity(quantity) && !wrong.contains(quantity)).collect()
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
            |quantity| question.along_its_line(quantity).is_some_and(|(along, _)| self.values.contains_key(&along));
        let is_kept = |quantity: &Quantity| {
            let is_velocity_after = matches!(quantity.of_its_impact(), Quantity::Velocity(_, Moment::After, _));
            (wrong.contains(quantity) || is_velocity_after) && !is_said(*quantity)
        };
        let kept = self.values.iter().filter(|(quantity, _)| is_kept(quantity));
        kept.map(|(quantity, (_, written))| (*quantity, written.clone())).collect()
    }

    fn off_by_more_than<'t>(
        &'t self,
        share: f64,
        question: &'t KeyedQuestion,
    ) -> impl Iterator<Item = (Quantity, &'t Expr)> {
        let prepared = question.prepared();
        // Once a letter has been found, what it leads to is right too.
        let found = prepared.all_where_found().unwrap_or_default();
        let near = move |(own, right): (&f64, &f64)| is_near(share, *own, *right);
        self.values.iter().filter_map(move |(quantity, (values, written))| {
            let is = |known: &[Known<f64>]| values.iter().zip(&sizes(known, *quantity).unwrap_or_default()).all(near);
            let is_right = is(&prepared.known) || !found.is_empty() && is(&found);
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
                    let Some(numbers) = prepared.sizes_of(expr) else {
                        continue;
                    };
                    if let Some((along, is_negative)) = question.along_its_line(*quantity) {
                        let signed = |number: &f64| if is_negative { -number.abs() } else { number.abs() };
                        let written = if is_negative { expr.clone().negated() } else { expr.clone() };
                        let own = (numbers.iter().map(signed).collect(), written);
                        self.values.entry(along).or_insert(own);
                    }
                    self.values.insert(*quantity, (numbers, expr.clone()));
                    if let Some(letter) = prepared.letter_of(*quantity) {
                        self.take_letter(question, &letter, expr);
                    }
                }
                (Find::Vector(x, y), Form::Vector(along_i, along_j, _)) => {
                    for (quantity, expr) in [(x, along_i), (y, along_j)] {
                        let numbers = prepared.sizes_of(expr);
                        self.values.extend(numbers.map(|numbers| (*quantity, (numbers, expr.clone()))));
                    }
                }
                (Find::Unknown(letter), Form::Value(expr)) => self.take_letter(question, letter, expr),
                _ => {}
            }
        }
    }

    /// Takes a wrong value of a letter that was to be found by the velocities after the impact that it leads to: they are
    /// what the student goes on from.
    fn take_letter(&mut self, question: &KeyedQuestion, name: &str, found: &Expr) {
        let prepared = question.prepared();
        let size = |expr: &Expr| prepared.sizes_of(expr);
        let sought = prepared.found.iter().find(|(letter, _)| letter.name() == name);
        let (Some((letter, right)), Some(own), Some(sizes)) = (sought, question.exact(found), size(found)) else {
            return;
        };
        let is_near = |(own, right): (&f64, &Option<f64>)| right.is_none_or(|right| is_nearly_right(*own, right));
        if sizes.iter().zip(right).all(is_near) {
            return;
        }
        // What was found in the letter is now what it comes to with this value.
        for (values, in_letter) in self.values.values_mut() {
            let put = in_letter.substitute(&|other| (other == name).then(|| found.clone()));
            if put != *in_letter
                && let Some(sizes) = size(&put)
            {
                (*values, *in_letter) = (sizes, put);
            }
        }
        let after = |sphere| [Axis::X, Axis::Y].map(|axis| Quantity::Velocity(sphere, Moment::After, axis));
        let velocities: Vec<Quantity> = Sphere::BOTH.into_iter().flat_map(after).collect();
        let mut known = question.given.clone();
        Derivation::carry_out(&mut known, &velocities);
        for quantity in velocities {
            let value = known.number(quantity).filter(|value| value.letters().contains(letter));
            let own = value.and_then(|value| value.substitute(*letter, &own)).map(|value| written(&value));
            let own = own.and_then(|own| Some((size(&own)?, own)));
            self.values.extend(own.map(|own| (quantity, own)));
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
    let rebound = letter_of_rebound(lines, prepared);
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
            // Of `V sin θ = 2` and `V cos θ = 1.92` the letter is the speed, and neither component.
            let place = place.filter(|_| !is_resolved(lines, letter));
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
                    if let (Some(of), true) = (of, is_of_velocity(letter))
                        && let (Some(x), Some(y)) = (vector(first), vector(second))
                        && let Expr::Vector(along_i, along_j) = &member.expr
                    {
                        found.insert(Quantity::Velocity(of, Moment::After, Axis::X), (x, (**along_i).clone()));
                        found.insert(Quantity::Velocity(of, Moment::After, Axis::Y), (y, (**along_j).clone()));
                    }
                }
                // Of the one velocity that is to be found in a straight line.
                (Some(numbers), None, None) if prepared.setting == Setting::Direct => {
                    if let Some(of) = sphere(letter).or(unknown_sphere(prepared)).filter(|_| is_of_velocity(letter)) {
                        found.insert(Quantity::Velocity(of, Moment::After, Axis::N), (numbers, member.expr.clone()));
                    }
                }
                (Some(numbers), None, None) if rebound.as_ref() == Some(letter) => {
                    let own = Quantity::Velocity(Sphere::A, Moment::After, Axis::N);
                    let right = sizes(&prepared.known, own).unwrap_or_default();
                    // It goes away from the wall, whichever sign the student gives it.
                    let is_against = |own: &f64, right: &f64| own * right < 0.0;
                    let turned = numbers.iter().zip(&right).any(|(own, right)| is_against(own, right));
                    let sizes = numbers.iter().map(|number| if turned { -number } else { *number });
                    let written = if turned { member.expr.clone().negated() } else { member.expr.clone() };
                    found.insert(own, (sizes.collect(), written));
                }
                _ => {}
            }
        }
        // `0.8v = 1.2i - 3.2j`, where what is said of the letter itself goes before.
        for own in reading.equations.iter().filter_map(|equation| multiple(equation, prepared)) {
            let of = sphere(own.letter).or(unknown_sphere(prepared));
            for (of, [x, y]) in of.into_iter().zip(own.divided()) {
                // What is right is no value of their own.
                let is_right = |axis: Axis, own: &[f64]| {
                    let right = sizes(&prepared.known, Quantity::Velocity(of, Moment::After, axis));
                    let near = |(own, right): (&f64, &f64)| (own - right).abs() <= 1e-9 * right.abs().max(1.0);
                    right.is_some_and(|right| own.iter().zip(&right).all(near))
                };
                if is_right(Axis::X, &x.0) && is_right(Axis::Y, &y.0) {
                    continue;
                }
                found.entry(Quantity::Velocity(of, Moment::After, Axis::X)).or_insert(x);
                found.entry(Quantity::Velocity(of, Moment::After, Axis::Y)).or_insert(y);
            }
        }
        if let Some(convention) = convention.filter(|_| studied.matched.is_empty()) {
            for (place, expr) in reading.equations.iter().filter_map(|equation| of_multiple(equation, convention)) {
                let values = prepared.sizes_of(&expr);
                let values = values.filter(|_| !is_resolved(lines, &convention.letters[place]));
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
pub(super) fn letters_of_axes(lines: &[Studied], prepared: &Prepared) -> Vec<(String, Quantity)> {
    let Some((of, [x, y])) = unknown_sphere(prepared).zip(momentum_by_components(lines, prepared)) else {
        return Vec::new();
    };
    let component = |axis| Quantity::Velocity(of, Moment::After, axis);
    match x.letter == y.letter {
        true => Vec::new(),
        false => vec![(x.letter, component(Axis::X)), (y.letter, component(Axis::Y))],
    }
}

/// Is a letter multiplied by the sine or the cosine of an angle that is open?
fn is_resolved(lines: &[Studied], letter: &str) -> bool {
    let is_it = |name: &str| name.contains(' ') && whole(name) == letter;
    let readings = lines.iter().filter_map(|studied| studied.reading.as_ref());
    let mut sides = readings.flat_map(|reading| &reading.equations).flat_map(|(left, right)| [left, right]);
    sides.any(|side| side.names().iter().any(|name| is_it(&name.text)))
}

/// The letter for the component that an impact with a wall turns round: it is called *e* times another.
fn letter_of_rebound(lines: &[Studied], prepared: &Prepared) -> Option<String> {
    let restitution = sizes(&prepared.known, Quantity::Restitution).filter(|_| prepared.setting == Setting::Wall)?;
    let is_e = |factor: &Expr| {
        let values = prepared.sizes_of(factor);
        values.is_some_and(|values| values.iter().zip(&restitution).all(|(own, e)| (own - e).abs() <= 1e-9))
    };
    let is_rebound = |expr: &Expr| match expr {
        Expr::Product(factors) => {
            let is_square = |factor: &Expr| matches!(factor, Expr::Power(..));
            factors.iter().any(is_e) && !factors.iter().any(is_square)
        }
        _ => false,
    };
    let members = lines.iter().filter_map(|studied| studied.reading.as_ref()).flat_map(|reading| &reading.members);
    let mut rebounds = members.filter(|member| is_rebound(&member.expr)).filter_map(|member| member.letter.clone());
    rebounds.find(|letter| is_of_velocity(letter))
}

/// Is it a letter that is used for velocities after the impact?
pub(super) fn is_of_velocity(letter: &str) -> bool {
    letter.starts_with(['v', 'V', 'w', 'W', 'x', 'y', 'X', 'Y'])
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

/// Is the value the speed that the part asks for, rather than the component? Where all is along one line it is either.
fn is_asked_speed(part: &KeyedPart, sphere: Sphere, values: &[f64], prepared: &Prepared) -> bool {
    let [speed, along] = [Quantity::Speed(sphere, Moment::After), Quantity::Velocity(sphere, Moment::After, Axis::N)];
    let asked = part.blanks.iter().any(|blank| blank.find.quantities().contains(&speed));
    let is = |right: Option<Vec<f64>>, near: &dyn Fn(f64, f64) -> bool| {
        right.is_some_and(|right| right.iter().zip(values).all(|(right, value)| near(*value, *right)))
    };
    let is_along = || is(sizes(&prepared.known, along), &|own, right| is_nearly_right(own.abs(), right.abs()));
    asked && is(sizes(&prepared.known, speed), &|own, right| (right - own).abs() < 0.006 * right) && !is_along()
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
