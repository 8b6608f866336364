//! The wrong values of one answer, sorted by size, and the search among them.

use crate::mechanics::{Datum, Known, Quantity};
use crate::number::{Number, Range};

use super::SAME;
use super::asked::Asked;
use super::backwards::Backwards;
use super::last_step::{ANOTHER_ANSWER, FACTOR_OF_TEN, LastStep, RADIANS, SIGN, has_a_sense, taken_for};
use super::sample::Sample;
use super::vector_steps::vector_steps;
use super::written::Written;

/// A number, or the components of a vector.
pub(super) type Values = Vec<Sample>;

/// The smallest size of a vector that has a direction; less is what floats leave of nought.
const SMALLEST: f64 = 1e-10;

/// An answer with its right value and the wrong ones.
#[derive(Clone, Debug)]
pub(super) struct Answer {
    pub(super) asked: Asked,
    /// Which place of what is found backwards it is.
    pub(super) place: usize,
    is_angle: bool,
    truth: Values,
    signed: bool,
    rows: Vec<Row>,
}

#[derive(Clone, Debug)]
struct Row {
    /// The size at the first point, by which rows are sorted.
    size: f64,
    values: Values,
    way: usize,
}

impl Answer {
    /// `None` if the quantities are not known.
    pub(super) fn of(asked: &[Quantity], known: &Known<Sample>) -> Option<Answer> {
        let signed = asked.len() > 1 || asked.iter().any(|quantity| has_a_sense(*quantity));
        let is_angle = asked.len() == 1 && asked[0].is_angle();
        let asked = Asked::Quantities(asked.to_vec());
        let mut answer = Answer { asked, place: 0, is_angle, truth: Vec::new(), signed, rows: Vec::new() };
        answer.truth = answer.values_in(known)?;
        Some(answer)
    }

    /// What is found backwards: its one value, or an end of its values.
    pub(super) fn of_letter(asked: &Asked, backwards: &Backwards, place: usize) -> Answer {
        let is_angle = backwards.letter.range() == Range::Acute;
        let truth = vec![backwards.in_figures(backwards.right(place).number)];
        Answer { asked: asked.clone(), place, is_angle, truth, signed: true, rows: Vec::new() }
    }

    pub(super) fn is_angle(&self) -> bool {
        self.is_angle
    }

    /// The quantities that are asked for; none of a letter.
    pub(super) fn quantities(&self) -> &[Quantity] {
        self.asked.quantities()
    }

    /// Is it an angle with the line of centres?
    pub(super) fn is_to_line(&self) -> bool {
        let first = self.quantities().first().map(|quantity| quantity.of_its_impact());
        matches!(first, Some(Quantity::AngleToLine(..) | Quantity::AngleFromN(..)))
    }

    /// Is it a direction of which any multiple will do?
    pub(super) fn is_line(&self) -> bool {
        matches!(self.quantities(), [Quantity::Line(_) | Quantity::Tangent(_), _])
    }

    /// The answer in what is known; an angle in degrees.
    pub(super) fn values_in(&self, known: &Known<Sample>) -> Option<Values> {
        let found: Option<Values> = self.quantities().iter().map(|quantity| value(known.0.get(quantity)?)).collect();
        found.filter(|values| !values.is_empty() && values.iter().all(|value| value.is_finite()))
    }

    pub(super) fn is_right(&self, values: &Values) -> bool {
        self.are_same(values, &self.truth)
    }

    fn are_same(&self, one: &Values, two: &Values) -> bool {
        if self.is_line() {
            return are_parallel(one, two);
        }
        one.iter().zip(two).all(|(one, two)| {
            let (one, two) = if self.signed { (*one, *two) } else { (one.size(), two.size()) };
            one.is_near(two, SAME)
        })
    }

    pub(super) fn add(&mut self, values: Values, way: usize) {
        let size = size(&values).0[0];
        let place = self.first(size);
        self.rows.insert(place, Row { size, values, way });
    }

    /// The place of the first row that is not smaller.
    fn first(&self, size: f64) -> usize {
        self.rows.partition_point(|row| row.size < size)
    }

    /// Is the value there already, by such a way?
    pub(super) fn has(&self, values: &Values, by: impl Fn(usize) -> bool) -> bool {
        let size = size(values).0[0];
        let apart = 2.0 * SAME * size.max(1.0);
        let near = self.rows[self.first(size - apart)..].iter().take_while(|row| row.size <= size + apart);
        near.into_iter().any(|row| self.are_same(&row.values, values) && by(row.way))
    }

    pub(super) fn rows(&self) -> impl Iterator<Item = (&Values, usize)> {
        self.rows.iter().map(|row| (&row.values, row.way))
    }

    /// Is it what was written, at the figures it has?
    pub(super) fn is_written(&self, written: &[Written]) -> bool {
        self.fits(written, &self.truth, &self.truth, |written, value, _, signed| written.is_right(value, signed))
    }

    /// The ways to what was written; none if it is right at the figures it has.
    pub(super) fn matching<'a>(&'a self, written: &'a [Written]) -> impl Iterator<Item = usize> + 'a {
        let (low, high) = if self.is_line() { (0.0, f64::INFINITY) } else { sizes(written) };
        let near = self.rows[self.first(low)..].iter().take_while(move |row| row.size <= high);
        let is_right = self.is_written(written);
        let fits = move |row: &&Row| !is_right && self.fits(written, &row.values, &self.truth, Written::is);
        near.filter(fits).map(|row| row.way)
    }

    /// Does what was written fit a value, with that of the components or the size of a vector?
    fn fits(
        &self,
        written: &[Written],
        values: &Values,
        truth: &Values,
        test: impl Fn(Written, Sample, Sample, bool) -> bool,
    ) -> bool {
        match (written, values.as_slice()) {
            (written, values) if self.is_line() => {
                written.len() == values.len() && are_parallel(&written.iter().map(|one| one.value).collect(), values)
            }
            ([one], [value]) => test(*one, *value, truth[0], self.signed),
            ([one], _) => test(*one, size(values), size(truth), false),
            (_, _) if written.len() != values.len() => false,
            // A component that is right may stand beside one that is not.
            _ => {
                let each = || written.iter().zip(values).zip(truth);
                let fit = |((written, value), truth): ((&Written, &Sample), &Sample)| {
                    test(*written, *value, *truth, true)
                        || (written.is_right(*truth, true) && value.is_near(*truth, SAME))
                };
                each().all(fit)
            }
        }
    }

    /// What the last line alone can go wrong with.
    pub(super) fn last_steps(&self, known: &Known<Sample>, answers: &[Answer]) -> Vec<(Values, LastStep)> {
        let changed =
            |change: &dyn Fn(f64) -> f64| -> Values { self.truth.iter().map(|value| value.map(change)).collect() };
        let mut found: Vec<(Values, LastStep)> = Vec::new();
        if self.is_line() {
            return found;
        }
        if self.signed {
            found.push((changed(&|value| -value), SIGN));
        }
        for factor in [0.1, 10.0, 0.01, 100.0, 0.001, 1000.0] {
            found.push((changed(&|value| value * factor), FACTOR_OF_TEN));
        }
        if self.is_angle() {
            found.push((changed(&f64::to_radians), RADIANS));
        }
        let taken: Vec<Vec<(Quantity, LastStep)>> =
            self.quantities().iter().map(|quantity| taken_for(*quantity)).collect();
        for place in 0..taken.iter().map(Vec::len).min().unwrap_or(0) {
            // The components of a vector are taken for others together.
            let values: Option<Values> = taken.iter().map(|taken| value(known.0.get(&taken[place].0)?)).collect();
            found.extend(values.map(|values| (values, taken[0][place].1)));
        }
        found.extend(vector_steps(self.quantities(), &self.truth, known));
        for other in answers.iter().filter(|other| other.truth.len() == 1 && self.truth.len() == 1) {
            if other.asked != self.asked && other.is_angle() == self.is_angle() {
                found.push((other.truth.clone(), ANOTHER_ANSWER));
            }
        }
        let mut kept: Vec<(Values, LastStep)> = Vec::new();
        for (values, step) in found {
            if !self.is_right(&values) && kept.iter().all(|(other, _)| !self.are_same(other, &values)) {
                kept.push((values, step));
            }
        }
        kept
    }
}

/// A number, or an angle in degrees.
pub(super) fn value<const N: usize>(datum: &Datum<Sample<N>>) -> Option<Sample<N>> {
    match datum {
        Datum::Number(number) => Some(*number),
        Datum::Direction { y, x } => has_direction(*x, *y).then(|| y.with(*x, f64::atan2).map(f64::to_degrees)),
        Datum::Equation(_) => None,
    }
}

/// Is a vector long enough to have a direction, at every point?
fn has_direction<const N: usize>(x: Sample<N>, y: Sample<N>) -> bool {
    (x * x + y * y).0.iter().all(|square| *square > SMALLEST * SMALLEST)
}

/// The size of a number or vector.
fn size(values: &[Sample]) -> Sample {
    match values {
        [value] => value.size(),
        _ => values.iter().fold(Sample::constant(0.0), |size, value| size.with(*value, f64::hypot)),
    }
}

/// Between which sizes a vector lies that can have been written so.
fn sizes(written: &[Written]) -> (f64, f64) {
    let each: Vec<(f64, f64)> = written.iter().map(|one| one.sizes()).collect();
    match each.as_slice() {
        [one] => *one,
        _ => each.iter().fold((0.0, 0.0), |(low, high): (f64, f64), (from, to)| {
            (low.hypot(from.max(0.0)), high.hypot(*to) * (1.0 + SAME))
        }),
    }
}

fn are_parallel(one: &Values, two: &[Sample]) -> bool {
    let [[a, b], [c, d]] = [[one[0], one[1]], [two[0], two[1]]];
    let cross = (a * d - b * c).size().with(size(one) * size(two), |cross, sizes| cross / sizes);
    has_direction(a, b) && has_direction(c, d) && cross.0.iter().all(|sine| *sine < SAME)
}
