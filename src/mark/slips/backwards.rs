//! A letter that is found backwards, found again by somebody with a slip.
//!
//! What the scene gives is taken with a number in place of the letter, the derivation is carried out again with the slip,
//! and what should vanish is looked at. From the right value on the number is changed until that vanishes again, by the
//! rule of the secant: most conditions are linear in the letter, or nearly so, and the third number is the one. Where it
//! is a rate of change that vanishes, Newton's rule is quicker, since values to both sides give the rate of that as well.
//! Every point has its own.

use crate::mechanics::{Carried, Condition, Datum, Known, MadeSlip, Quantity, Sought, Steps, Vanishing};
use crate::number::{Letter, Range, Value};

use super::evaluated::condition_gap;
use super::sample::{POINTS, Sample};
use super::table::value;

/// After so many numbers it is given up.
const MOST_STEPS: usize = 12;

/// Two numbers that differ by less than this part are one: of a condition, and of a rate of change, which is found from
/// differences.
const ONE: f64 = 1e-13;
const ONE_OF_A_SLOPE: f64 = 1e-5;

/// How far off the values are from which a rate of change is found: further, and it is less right; nearer, and what is left
/// of their difference is noise.
const FINE: f64 = 1e-4;

/// So many times as large, or as small, a number may become at once where a rate of change should vanish, and at all: what
/// is greatest further off is so for no angle that anybody would write.
const FAR: f64 = 8.0;
const FARTHEST: f64 = 1000.0;

/// What is right vanishes to this part of what it is a little further on.
const VANISHED: f64 = 1e-6;

/// How far off the second number is.
const FIRST_STEP: f64 = 1.0 / 16.0;

/// Data in place of others.
pub(super) type Entered<const N: usize = POINTS> = Vec<(Quantity, Datum<Sample<N>>)>;

/// A letter, with all that it is found from.
#[derive(Clone, Debug)]
pub(super) struct Backwards<const N: usize = POINTS> {
    pub(super) letter: Letter,
    /// The other letters, each with what it stands for.
    others: Vec<(Letter, Sample<N>)>,
    /// What is given in terms of the letter.
    given: Vec<(Quantity, Datum<Value>)>,
    /// What was asked of the scene to find it.
    asked: Vec<Quantity>,
    /// The right numbers.
    places: Vec<Place<N>>,
    /// Are they the ends of a range?
    pub(super) is_range: bool,
}

/// A right number, with what vanishes there.
#[derive(Clone, Debug)]
struct Place<const N: usize> {
    right: Landed<N>,
    vanishing: Vanishing,
}

/// How somebody looks for the letter.
struct Way<'w, const N: usize> {
    road: &'w mut Carried<Sample<N>>,
    /// The steps to what should vanish: no other is gone for a number that is only tried.
    steps: Steps,
    slips: &'w [MadeSlip<'w>],
    /// What he starts from in place of what is given.
    entered: &'w [(Quantity, Datum<Sample<N>>)],
}

impl<'w, const N: usize> Way<'w, N> {
    fn new(
        backwards: &Backwards<N>,
        road: &'w mut Carried<Sample<N>>,
        slips: &'w [MadeSlip<'w>],
        entered: &'w [(Quantity, Datum<Sample<N>>)],
    ) -> Way<'w, N> {
        let steps = road.steps_to(&backwards.asked);
        Way { road, steps, slips, entered }
    }
}

/// A number at which something vanishes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Landed<const N: usize = POINTS> {
    pub(super) number: Sample<N>,
    /// Does it grow with the number there? One, or else minus one: of a range that is the side on which it lies.
    pub(super) side: Sample<N>,
}

impl<const N: usize> Backwards<N> {
    /// Nothing if the right numbers do not exist at the points, or do not make vanish what they should.
    pub(super) fn of(sought: &Sought, road: &mut Carried<Sample<N>>) -> Option<Backwards<N>> {
        let has_letter = |value: &Value| value.has_letter(|own| *own == sought.letter);
        let is_open = |datum: &Datum<Value>| match datum {
            Datum::Number(value) => has_letter(value),
            Datum::Direction { y, x } => has_letter(y) || has_letter(x),
            Datum::Equation(_) => false,
        };
        let given = sought.given.0.iter().filter(|(_, datum)| is_open(datum));
        let given = given.map(|(quantity, datum)| (*quantity, datum.clone())).collect();
        let others = sought.letters.iter().filter(|other| **other != sought.letter);
        let others = others.map(|other| (*other, Sample::of_tangent(*other))).collect();
        let (letter, asked, is_range) = (sought.letter, sought.asked.clone(), sought.is_range);
        let mut backwards = Backwards { letter, others, given, asked, places: Vec::new(), is_range };
        let mut way = Way::new(&backwards, road, &[], &[]);
        for (value, vanishing) in &sought.places {
            let number = Sample::of(value)?;
            let [here, beside] = [number, beside(number)].map(|number| backwards.gap(vanishing, number, &mut way));
            let (here, beside) = (here?, beside?);
            if !here.0.iter().zip(beside.0).all(|(here, beside)| here.abs() <= VANISHED * beside.abs()) {
                return None;
            }
            let right = Landed { number, side: beside.map(f64::signum) };
            backwards.places.push(Place { right, vanishing: vanishing.clone() });
        }
        Some(backwards)
    }

    /// How many places there are.
    pub(super) fn count(&self) -> usize {
        self.places.len()
    }

    /// Is it quickly found again, so that pairs of slips can be tried? Where something is greatest it is not.
    pub(super) fn is_quick(&self) -> bool {
        !self.places.iter().any(|place| place.vanishing.is_slope())
    }

    /// The right number of a place.
    pub(super) fn right(&self, place: usize) -> Landed<N> {
        self.places[place].right
    }

    /// A number as an answer has it: an angle in degrees.
    pub(super) fn in_figures(&self, number: Sample<N>) -> Sample<N> {
        match self.letter.range() {
            Range::Acute => number.map(|tangent| tangent.atan().to_degrees()),
            _ => number,
        }
    }

    /// What is given where the letter is this number.
    pub(super) fn given_at(&self, number: Sample<N>) -> Entered<N> {
        let there = |value: &Value| self.nearly(value, number);
        let datum = |datum: &Datum<Value>| match datum {
            Datum::Number(value) => Datum::Number(there(value)),
            Datum::Direction { y, x } => Datum::Direction { y: there(y), x: there(x) },
            Datum::Equation(coefficients) => Datum::Equation([0, 1, 2].map(|place| there(&coefficients[place]))),
        };
        self.given.iter().map(|(quantity, given)| (*quantity, datum(given))).collect()
    }

    /// About a value, where the letter is this number.
    fn nearly(&self, value: &Value, number: Sample<N>) -> Sample<N> {
        Sample::nearly(value, &|letter| match letter == self.letter {
            true => Some(number),
            false => self.others.iter().find(|(other, _)| *other == letter).map(|(_, number)| *number),
        })
    }

    /// The number that somebody finds who makes these slips and starts from other data: none who finds nothing, or
    /// something that the letter cannot be.
    pub(super) fn found(
        &self,
        place: usize,
        road: &mut Carried<Sample<N>>,
        slips: &[MadeSlip],
        entered: &[(Quantity, Datum<Sample<N>>)],
    ) -> Option<Landed<N>> {
        let Place { right, vanishing } = &self.places[place];
        let is_changed =
            |carried: &Carried<Sample<N>>, trace| self.asked.iter().any(|own| carried.is_changed(*own, trace));
        let mut way = Way::new(self, road, slips, entered);
        if !way.road.again_by(way.steps, slips, entered, is_changed) {
            return Some(*right);
        }
        let found = if let Vanishing::Slope(quantity) = vanishing {
            let mut slopes = |number: Sample<N>| self.slopes(*quantity, number, &mut way);
            // Of a complement it is least where it should be greatest.
            let other = Landed { side: -right.side, ..*right };
            flat(*right, &mut slopes).or_else(|| flat(other, &mut slopes))?
        } else {
            let start = [right.number, beside(right.number)];
            let mut gap = |number: Sample<N>| self.gap(vanishing, number, &mut way);
            // What is not near a line in the number may be one in its reciprocal.
            let over = |number: Sample<N>| number.map(f64::recip);
            let by_reciprocal = |gap: &mut dyn FnMut(Sample<N>) -> Option<Sample<N>>| {
                let Landed { number, side } = root(start.map(over), |number| gap(over(number)))?;
                Some(Landed { number: over(number), side: -side })
            };
            root(start, &mut gap).or_else(|| by_reciprocal(&mut gap))?
        };
        let can_be = self.letter.range() == Range::Real || found.number.0.iter().all(|number| *number > 0.0);
        can_be.then_some(found)
    }

    /// What should vanish, for a number.
    fn gap(&self, vanishing: &Vanishing, number: Sample<N>, way: &mut Way<N>) -> Option<Sample<N>> {
        match vanishing {
            Vanishing::Gap(Condition { left, right, .. }) => {
                let gap =
                    |known: &Known<Sample<N>>| condition_gap(left, right, &self.others, (self.letter, number), known);
                self.carry_out(number, way, gap)
            }
            Vanishing::Distance(quantity, bound) => {
                let distance =
                    |known: &Known<Sample<N>>| Some(value(known.0.get(quantity)?)? - self.nearly(bound, number));
                self.carry_out(number, way, distance)
            }
            Vanishing::Slope(quantity) => Some(self.slopes(*quantity, number, way)?[0]),
        }
    }

    /// How fast a quantity changes with the number, and how fast that does.
    fn slopes(&self, quantity: Quantity, number: Sample<N>, way: &mut Way<N>) -> Option<[Sample<N>; 2]> {
        // By a value to each side: right but for the square of how far off they are.
        let step = number.map(|number| FINE * number.abs().max(FINE));
        let around = [number - step, number, number + step];
        let seen = |known: &Known<Sample<N>>| value(known.0.get(&quantity)?);
        let mut at = |number| self.carry_out(number, way, seen);
        let [below, here, above] = match self.others.is_empty() && N >= around.len() {
            // All points are one then, and the three numbers can have one each.
            true => {
                let found = at(Sample(std::array::from_fn(|point| around[point % around.len()].0[0])))?;
                [0, 1, 2].map(|point| Sample::constant(found.0[point]))
            }
            false => [at(around[0])?, at(around[1])?, at(around[2])?],
        };
        let slope = (above - below).with(step, |change, step| change / (2.0 * step));
        let rise = ((above - here) - (here - below)).with(step, |change, step| change / (step * step));
        Some([slope, rise])
    }

    /// Goes the way with this number; looks at what is known then.
    fn carry_out(
        &self,
        number: Sample<N>,
        way: &mut Way<N>,
        look: impl FnOnce(&Known<Sample<N>>) -> Option<Sample<N>>,
    ) -> Option<Sample<N>> {
        let mut other = self.given_at(number);
        other.extend_from_slice(way.entered);
        let look = |carried: &Carried<Sample<N>>, _| look(carried.known());
        way.road.again_by(way.steps, way.slips, &other, look).filter(|found| found.is_finite())
    }
}

/// The second number, a little further on.
fn beside<const N: usize>(number: Sample<N>) -> Sample<N> {
    number.map(|number| number + FIRST_STEP * number.abs().max(FIRST_STEP))
}

/// Where something vanishes, at each point for itself.
fn root<const N: usize>(
    start: [Sample<N>; 2],
    mut gap: impl FnMut(Sample<N>) -> Option<Sample<N>>,
) -> Option<Landed<N>> {
    let [mut last, mut here] = start;
    let (mut at_last, mut at_here) = (gap(last)?, gap(here)?);
    // What is the same for every number determines none.
    if at_last == at_here {
        return None;
    }
    let mut side = Sample::constant(1.0);
    for _ in 0..MOST_STEPS {
        let place = |point: usize| {
            let (change, rise) = (here.0[point] - last.0[point], at_here.0[point] - at_last.0[point]);
            match at_here.0[point] == 0.0 || change == 0.0 {
                true => (here.0[point], side.0[point]),
                false => (here.0[point] - at_here.0[point] * change / rise, (rise / change).signum()),
            }
        };
        let each: [(f64, f64); N] = std::array::from_fn(place);
        let next = Sample(each.map(|(next, _)| next));
        side = Sample(each.map(|(_, side)| side));
        if !next.is_finite() {
            return None;
        }
        if next.0.iter().zip(here.0).all(|(next, here)| (next - here).abs() <= ONE * next.abs()) {
            return Some(Landed { number: next, side });
        }
        (last, at_last) = (here, at_here);
        (here, at_here) = (next, gap(next)?);
    }
    None
}

/// Where a rate of change vanishes, at each point for itself: `slopes` is that rate and its own. From the right number on to
/// where something is greatest as it is there, or least.
fn flat<const N: usize>(
    right: Landed<N>,
    mut slopes: impl FnMut(Sample<N>) -> Option<[Sample<N>; 2]>,
) -> Option<Landed<N>> {
    let Landed { number: mut here, side } = right;
    // Between these it lies.
    let (mut low, mut high) = ([f64::NEG_INFINITY; N], [f64::INFINITY; N]);
    for _ in 0..MOST_STEPS {
        let [slope, rise] = slopes(here)?;
        let place = |point: usize| {
            let (here, slope, rise, side) = (here.0[point], slope.0[point], rise.0[point], side.0[point]);
            // What is the same for every number determines none.
            if slope == 0.0 && rise == 0.0 {
                return f64::NAN;
            }
            let ahead = -side * slope.signum();
            let bound = if ahead > 0.0 { &mut low } else { &mut high };
            bound[point] = here;
            // Far off it may be bent the other way: there it is followed, up or down, as far as is allowed at once.
            let step = if rise * side > 0.0 { -slope / rise } else { ahead * f64::INFINITY };
            let [least, most] = [here / FAR, here * FAR];
            let next = (here + step).clamp(least.min(most), least.max(most));
            let [low, high] = [low[point], high[point]];
            if low <= next && next <= high || low.is_infinite() || high.is_infinite() {
                return next;
            }
            (low * high).sqrt().copysign(here)
        };
        let next = Sample(std::array::from_fn(place));
        let times = next.with(right.number, |next, right| (next / right).max(right / next));
        if !times.0.iter().all(|times| *times < FARTHEST) {
            return None;
        }
        if next.0.iter().zip(here.0).all(|(next, here)| (next - here).abs() <= ONE_OF_A_SLOPE * next.abs()) {
            return Some(Landed { number: next, side });
        }
        here = next;
    }
    None
}

#[cfg(test)]
mod tests {
    use super::*;

    type Slopes<'s> = &'s dyn Fn(f64) -> [f64; 2];

    /// From 1 on, for something that is greatest at these numbers, by how fast it changes there and how fast that does.
    fn greatest_from_one(slopes: Slopes) -> Option<f64> {
        let right: Landed = Landed { number: Sample::constant(1.0), side: Sample::constant(-1.0) };
        let found = flat(right, |number| {
            let [slope, rise] = slopes(number.0[0]);
            Some([Sample::constant(slope), Sample::constant(rise)])
        });
        found.map(|found| found.number.0[0])
    }

    #[test]
    fn what_is_greatest_is_found_from_afar_and_given_up_where_it_is_greatest_nowhere() {
        // x/(a² + x²), which is bent the other way beyond a√3.
        let of = |a: f64| {
            move |x: f64| {
                let below = a * a + x * x;
                [(a * a - x * x) / below.powi(2), 2.0 * x * (x * x - 3.0 * a * a) / below.powi(3)]
            }
        };
        for a in [0.01, 0.2, 0.5, 0.999, 1.0, 1.5, 4.0, 70.0] {
            let found = greatest_from_one(&of(a)).unwrap();
            assert!((found - a).abs() < 1e-6 * a, "{found} for {a}");
        }
        let nowhere: [(&str, Slopes); 4] = [
            ("too far off", &of(5000.0)),
            ("it grows", &|x| [1.0 / x, -1.0 / (x * x)]),
            ("the same everywhere", &|_| [0.0, 0.0]),
            ("least at 2", &|x| [x - 2.0, 1.0]),
        ];
        for (what, slopes) in nowhere {
            assert_eq!(greatest_from_one(slopes), None, "{what}");
        }
    }
}
