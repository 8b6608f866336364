//! Working that ends with another value than the answer: `√(1.01² + 3.63²) = 2.4`, where the blank has 3.77.

use super::by_line::Wanted;
use super::{is_unfinished, middle};
use crate::expr::{Expr, Relation};
use crate::mark::judging::dimension;
use crate::mark::reading::{Form, Label, Said, Statement};
use crate::mark::working::examine::{Value, Working};
use crate::mark::working::lines::Member;
use crate::mark::working::numbers::{comes_to, is_vector, sizes};
use crate::mark::working::theirs::is_nearly_right;
use crate::mechanics::{Axis, Moment, Quantity, Sphere};
use crate::unit::Unit;

/// By more than such a part of it a number is another, however it was rounded.
const PLAINLY: f64 = 0.05;

/// The value with which the working of a part ends, if it is nothing that anybody finds on the way.
pub(crate) struct End {
    /// What it says, and what it is called.
    pub(crate) statement: Statement,
    /// For each blank: does the right value stand nowhere in the lines, but as what this was worked out from?
    pub(crate) is_never_right: Vec<bool>,
    /// Does it stand there?
    pub(crate) is_worked_out: Vec<bool>,
}

/// The unit in which a value is said to be, or in which that is what it is called.
fn unit_of(statement: &Statement, said: &Said) -> Option<Unit> {
    if let Some(said) = &said.unit {
        return Unit::ALL.into_iter().find(|unit| dimension(*unit) == said.dimension);
    }
    let label = statement.label.as_ref()?.typed.to_lowercase();
    let has = |words: &[&str]| words.iter().any(|word| label.contains(word));
    let is_letter = |letters: &str| {
        let mut signs = label.trim().chars();
        let first = signs.next().is_some_and(|first| letters.contains(first));
        let rest = signs.as_str();
        first && (rest.is_empty() || rest.starts_with(['_', '\'', '’']) || matches!(rest, "a" | "b" | "c" | "1" | "2"))
    };
    if has(&["speed", "velocity"]) || is_letter("vw") {
        Some(Unit::MetrePerSecond)
    } else if has(&["impulse"]) || is_letter("ij") {
        Some(Unit::NewtonSecond)
    } else if has(&["energy"]) || label.split(|sign: char| !sign.is_alphanumeric()).any(|word| word == "ke") {
        Some(Unit::Joule)
    } else {
        None
    }
}

impl Working<'_> {
    pub(in crate::mark::working) fn end(&self) -> Option<End> {
        let studied = self.lines.iter().rfind(|studied| !studied.line.is_crossed_out())?;
        let reading = studied.reading.as_ref()?;
        let (member, values) = self.members(studied).last()?;
        let statement = reading.statements.last()?;
        let said = statement.said.last()?;
        let is_result = studied.line.typed.contains(['=', '≈']) || said.unit.is_some();
        // `8v = 4√3` is left to be solved.
        let is_name = |label: &Label| matches!(label.expr, None | Some(Expr::Name(_)));
        let is_member = |said: &Said| match (&said.form, &member.expr) {
            (Form::Value(value), expr) => value == expr,
            (Form::Vector(x, y, _), Expr::Vector(own_x, own_y)) => *x == **own_x && *y == **own_y,
            // `3m(2u - 2eu) = 6mu(1 - e)`: a formula of what is given, and what it comes to.
            (Form::Equation(Expr::Relation(left, Relation::Equal, right)), expr) => {
                **right == *expr && self.in_given_names(left).is_some()
            }
            _ => false,
        };
        let is_value = |said: &Said| !matches!(said.form, Form::Equation(_)) || is_member(said);
        let is_solved = is_member(said) && statement.said.iter().all(is_value);
        let is_unsolved = !is_solved || !statement.label.as_ref().is_none_or(is_name);
        // A formula in letters is a result where something was worked out to come to it.
        let is_plain = !is_unfinished(&member.expr)
            || !member.expr.names().is_empty() && !self.members_before(studied, member).is_empty();
        if is_unsolved || !(is_plain && is_result && self.in_given_names(&member.expr).is_some()) {
            return None;
        }
        let before = self.members_before(studied, member);
        if self.is_on_the_way(values, unit_of(statement, said)) && !self.is_worked_out_wrongly(values, &before) {
            return None;
        }
        let is_before = |own: &Member| before.iter().any(|one| std::ptr::eq(*one, own));
        let of_blanks = |of: &dyn Fn(&Wanted) -> bool| {
            let each = self.part.blanks.iter().map(|blank| self.wanted(&blank.find));
            each.map(|wanted| wanted.is_some_and(|wanted| of(&wanted))).collect()
        };
        let is_never_right = of_blanks(&|wanted| self.members_that_are(wanted).all(|(_, own)| is_before(own)));
        let is_worked_out = of_blanks(&|wanted| self.members_that_are(wanted).any(|(_, own)| is_before(own)));
        let form = match said.form {
            Form::Equation(_) => Form::Value(member.expr.clone()),
            ref form => form.clone(),
        };
        let statement = Statement { said: vec![Said { form, ..said.clone() }], ..statement.clone() };
        Some(End { statement, is_never_right, is_worked_out })
    }

    /// Is it set equal to what plainly comes to another number, and to no square of it? Who writes `√(1.92² + 2²) = 2.0` has
    /// written no step that is known, though it has the number of one.
    fn is_worked_out_wrongly(&self, values: &[Value], before: &[&Member]) -> bool {
        let is_another = |one: f64, other: f64| (one - other).abs() > PLAINLY * one.abs().max(other.abs());
        let is_plainly = |own: Vec<Value>| {
            own.iter().zip(values).all(|(own, end)| match (own, end) {
                (Value::Number(own), Value::Number(end)) => {
                    let (own, end) = (own.middle().abs(), end.middle().abs());
                    is_another(own, end) && is_another(own, end * end)
                }
                _ => false,
            })
        };
        let formulas = before.iter().filter(|member| member.multiple.is_none() && is_unfinished(&member.expr));
        formulas.filter_map(|member| self.in_given_names(&member.expr)).any(is_plainly)
    }

    /// The velocities after the impact whose right value some letter has in the lines, where the same letter may be of the
    /// whole speed as well: not in a line.
    pub(in crate::mark::working) fn found_once(&self) -> Vec<Quantity> {
        if self.across().is_empty() {
            return Vec::new();
        }
        let axes = [Axis::N, Axis::T, Axis::X, Axis::Y];
        let all = Sphere::BOTH
            .into_iter()
            .flat_map(|sphere| axes.map(|axis| Quantity::Velocity(sphere, Moment::After, axis)));
        let is_found = |quantity: &Quantity| {
            let Some(right) = sizes(&self.prepared.known, *quantity) else { return false };
            let wanted = Wanted::Number { right, is_angle: false };
            self.members_that_are(&wanted).any(|(_, member)| member.letter.is_some())
        };
        all.filter(is_found).collect()
    }

    /// Is it the size of anything that is known of the impact, or the square of a speed, a momentum, an energy, or a speed of
    /// approach or of separation? Who ends with such a number has written a step, and the answer in its place. What is said to be in
    /// another unit only has the same number, and nobody works out what the question gives for a mass or for e.
    fn is_on_the_way(&self, values: &[Value], unit: Option<Unit>) -> bool {
        if values.iter().any(|value| matches!(value, Value::Vector(..))) {
            return self.is_vector_on_the_way(values);
        }
        let known = |quantity: Quantity| sizes(&self.prepared.known, quantity);
        // It may come of what was rounded.
        let nearly =
            |value: &Value, size: f64| comes_to(*value, size) || is_nearly_right(middle(value)[0].abs(), size.abs());
        let is = |of: &dyn Fn(usize) -> Option<f64>| {
            values.iter().enumerate().all(|(point, value)| of(point).is_some_and(|size| nearly(value, size)))
        };
        let may_be_in = |own: Unit| unit.is_none_or(|unit| unit == own);
        let is_given = |quantity: &Quantity| {
            let is_of_question = matches!(quantity.of_its_impact(), Quantity::Mass(_) | Quantity::Restitution);
            is_of_question && self.prepared.given[0].0.contains_key(quantity)
        };
        let all = || self.prepared.known[0].0.keys().copied();
        let quantities = || all().filter(|quantity| may_be_in(quantity.unit()) && !is_given(quantity));
        let is_speed = |quantity: &Quantity| matches!(quantity, Quantity::Velocity(..) | Quantity::Speed(..));
        let mass = |sphere: Sphere, point: usize| Some(known(Quantity::Mass(sphere))?[point]);
        let of_speed = |speed: &[f64]| {
            let momentum = |sphere| is(&|point| Some(mass(sphere, point)? * speed[point]));
            let energy = |sphere| is(&|point| Some(0.5 * mass(sphere, point)? * speed[point].powi(2)));
            unit.is_none() && is(&|point| Some(speed[point].powi(2)))
                || may_be_in(Unit::NewtonSecond) && Sphere::BOTH.into_iter().any(momentum)
                || may_be_in(Unit::Joule) && Sphere::BOTH.into_iter().any(energy)
        };
        let of_both = |moment: Moment| {
            let along = Sphere::BOTH.map(|sphere| known(Quantity::Velocity(sphere, moment, Axis::N)));
            let [Some(a), Some(b)] = along else { return false };
            let momentum = |point: usize| Some(mass(Sphere::A, point)? * a[point] + mass(Sphere::B, point)? * b[point]);
            may_be_in(Unit::MetrePerSecond) && is(&|point| Some(a[point] - b[point]))
                || may_be_in(Unit::NewtonSecond) && is(&momentum)
        };
        quantities().filter_map(known).any(|all| is(&|point| Some(all[point])))
            || all().filter(is_speed).filter_map(known).any(|speed| of_speed(&speed))
            || [Moment::Before, Moment::After].into_iter().any(of_both)
    }

    /// Is it a velocity, an impulse or a momentum, of one sphere or of both, whichever way it points?
    fn is_vector_on_the_way(&self, values: &[Value]) -> bool {
        let both = |of: &dyn Fn(Axis) -> Quantity| {
            let [x, y] = [Axis::X, Axis::Y].map(|axis| sizes(&self.prepared.known, of(axis)));
            x.zip(y)
        };
        let is = |x: &[f64], y: &[f64]| [1.0, -1.0].into_iter().any(|sign| is_vector(values, x, y, sign));
        let times = |mass: &[f64], along: &[f64]| -> Vec<f64> { mass.iter().zip(along).map(|(m, v)| m * v).collect() };
        let of_sphere = |sphere: Sphere| {
            let mass = sizes(&self.prepared.known, Quantity::Mass(sphere));
            let velocities =
                [Moment::Before, Moment::After].map(|at| both(&|axis| Quantity::Velocity(sphere, at, axis)));
            let impulse = both(&|axis| Quantity::Impulse(sphere, axis));
            let momenta = velocities.iter().flatten().filter_map(|(x, y)| Some((mass.as_ref()?, x, y)));
            momenta.into_iter().any(|(mass, x, y)| is(&times(mass, x), &times(mass, y)))
                || velocities.iter().flatten().chain(&impulse).any(|(x, y)| is(x, y))
        };
        Sphere::BOTH.into_iter().any(of_sphere)
    }
}
