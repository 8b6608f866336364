//! The two equations along the line of centres, as students write them: which law a line is, and how it departs from it.
//!
//! Momentum and restitution are both `p x + q y = r` in the components x, y after the impact. A line is such an equation
//! if its numbers are in the proportion of the law's, so that a mass may be cancelled and the sides exchanged. A student
//! may take either direction as positive for either unknown; the choice that makes the lines agree best is kept for all
//! of them. A line that is not the law is compared with the law evaluated from inputs changed as students change them,
//! one or several at once, and the least change counts.

use super::apiece::Apiece;
use super::changed::{Change, changes};
use super::conventions::Convention;
use super::departure::Departure;
use crate::mark::working::numbers::{Linear, Spread, sizes};
use crate::mechanics::{Axis, Known, Moment, Quantity, Sphere};

/// The two equations.
pub(in crate::mark::working) const BOTH: [Quantity; 2] = [Quantity::MomentumEquation, Quantity::RestitutionEquation];

/// A line that is one of the two equations.
#[derive(Clone, Debug, PartialEq)]
pub(in crate::mark::working) struct Matched {
    /// Which of the two equations it is.
    pub(in crate::mark::working) equation: Quantity,
    /// How it departs from the law; nothing if it is right.
    pub(in crate::mark::working) departures: Vec<Departure>,
}

impl Matched {
    /// A law with one departure.
    pub(in crate::mark::working) fn with(equation: Quantity, departure: Departure) -> Matched {
        Matched { equation, departures: vec![departure] }
    }

    pub(in crate::mark::working) fn weight(&self) -> u32 {
        self.departures.iter().map(|departure| departure.weight()).sum()
    }

    pub(in crate::mark::working) fn is_method(&self) -> bool {
        self.departures.iter().all(|departure| departure.is_condoned())
    }
}

/// What the law is evaluated from, at one point.
#[derive(Clone, Debug)]
pub(in crate::mark::working) struct Inputs {
    pub(super) masses: [f64; 2],
    /// Along the line of centres, before.
    pub(super) along: [f64; 2],
    pub(in crate::mark::working) across: [f64; 2],
    pub(super) speed: [f64; 2],
    pub(super) e: f64,
    /// Are the velocities given by numbers for their components?
    pub(super) in_components: bool,
}

/// The two laws at every point of the letters.
#[derive(Clone, Debug)]
pub(in crate::mark::working) struct Laws {
    pub(super) inputs: Vec<Inputs>,
    /// What both velocities along the line of centres are after the impact, where that follows.
    pub(super) after: Option<Vec<[f64; 2]>>,
    /// Is something given of it?
    is_after_given: bool,
    /// What each letter of the speeds that are given stands for at every point.
    pub(in crate::mark::working) speeds: Vec<Vec<f64>>,
    /// The coefficients of restitution of other impacts at every point.
    pub(super) restitutions: Vec<Vec<f64>>,
    /// The numbers `p`, `q` that some changed law has at every point, each once: few, and most lines have others.
    unknowns: Vec<Vec<[f64; 2]>>,
    changed: Vec<Changed>,
}

/// A changed law with its numbers `p`, `q`, `r` at every point, whichever way is positive.
#[derive(Clone, Debug)]
struct Changed {
    /// Its place among all changes.
    change: usize,
    /// The place of `p` and `q` among those of all.
    unknowns: usize,
    numbers: Vec<[f64; 3]>,
}

impl Laws {
    /// The laws of a question from what is known at every point; `None` where its masses or velocities are not given.
    pub(in crate::mark::working) fn of(
        given: &Known<f64>,
        at_points: &[Known<f64>],
        in_components: bool,
        speeds: Vec<Vec<f64>>,
    ) -> Option<Laws> {
        let inputs = (0..at_points.len()).map(|point| {
            let known = std::slice::from_ref(&at_points[point]);
            let at = |quantity| sizes(known, quantity).map(|sizes| sizes[0]);
            let both = |one: &dyn Fn(Sphere) -> Option<f64>| Some([one(Sphere::A)?, one(Sphere::B)?]);
            let component = |sphere, axis| at(Quantity::Velocity(sphere, Moment::Before, axis));
            let along = both(&|sphere| component(sphere, Axis::N))?;
            let across = both(&|sphere| component(sphere, Axis::T))?;
            Some(Inputs {
                masses: both(&|sphere| at(Quantity::Mass(sphere)))?,
                speed: [along[0].hypot(across[0]), along[1].hypot(across[1])],
                along,
                across,
                e: at(Quantity::Restitution)?,
                in_components,
            })
        });
        let inputs: Vec<Inputs> = inputs.collect::<Option<_>>()?;
        let after = |sphere| sizes(at_points, Quantity::Velocity(sphere, Moment::After, Axis::N));
        let after = after(Sphere::A).zip(after(Sphere::B));
        let after = after.map(|(v, w)| v.into_iter().zip(w).map(|(v, w)| [v, w]).collect());
        let is_after = |quantity: &Quantity| {
            match quantity {
                // On a straight line nothing is across it, and that is no velocity that is given.
                Quantity::Velocity(_, Moment::After, axis) => *axis != Axis::T,
                other => matches!(other, Quantity::Speed(_, Moment::After)),
            }
        };
        let is_after_given = given.0.keys().any(is_after);
        let mut laws = Laws {
            inputs,
            speeds,
            after,
            is_after_given,
            restitutions: Vec::new(),
            unknowns: Vec::new(),
            changed: Vec::new(),
        };
        for (change, how) in changes().iter().enumerate() {
            let numbers: Option<Vec<[f64; 3]>> = laws.inputs.iter().map(|at| how.numbers(at)).collect();
            let Some(numbers) = numbers else { continue };
            let own: Vec<[f64; 2]> = numbers.iter().map(|[p, q, _]| [*p, *q]).collect();
            let unknowns = laws.unknowns.iter().position(|known| *known == own).unwrap_or_else(|| {
                laws.unknowns.push(own);
                laws.unknowns.len() - 1
            });
            laws.changed.push(Changed { change, unknowns, numbers });
        }
        Some(laws)
    }

    /// The same laws where a sphere is at rest after the impact: without the term of its velocity.
    pub(super) fn with_at_rest(&self, sphere: Sphere) -> Laws {
        let mut laws = self.clone();
        laws.unknowns.iter_mut().flatten().for_each(|numbers| numbers[sphere as usize] = 0.0);
        laws.changed.iter_mut().flat_map(|changed| &mut changed.numbers).for_each(|at| at[sphere as usize] = 0.0);
        laws
    }

    /// What a line is, its unknowns in this convention: one of the laws as it stands, or either of them with the least
    /// change; nothing if it is neither, however changed.
    ///
    /// The line is its left minus its right side at every point. Where e is seen to stand in it, it was not left out.
    pub(in crate::mark::working) fn either(
        &self,
        line: &[Linear],
        apiece: &Apiece,
        convention: &Convention,
        shows_e: bool,
    ) -> Vec<Matched> {
        let as_it_stands = self.as_it_stands(line, apiece, convention, shows_e);
        if !as_it_stands.is_empty() {
            return as_it_stands;
        }
        let without = |letter: &Vec<f64>| self.without_letter(line, convention, shows_e, letter);
        self.speeds.iter().map(without).find(|found| !found.is_empty()).unwrap_or_default()
    }

    /// The laws in which a letter of the speeds is left out of every term, and that a method mark condones otherwise.
    fn without_letter(&self, line: &[Linear], convention: &Convention, shows_e: bool, letter: &[f64]) -> Vec<Matched> {
        let put = |(linear, letter): (&Linear, &f64)| {
            let constant = linear.constant.times(*letter);
            Linear { constant, size: linear.size * letter.max(1.0), ..linear.clone() }
        };
        let whole: Vec<Linear> = line.iter().zip(letter).map(put).collect();
        let mut found = self.as_it_stands(&whole, &Apiece::default(), convention, shows_e);
        found.retain(|one| one.is_method() && !one.departures.contains(&Departure::AnotherRestitution));
        found.iter_mut().for_each(|one| one.departures.insert(0, Departure::LetterMissing));
        found
    }

    fn as_it_stands(&self, line: &[Linear], apiece: &Apiece, convention: &Convention, shows_e: bool) -> Vec<Matched> {
        let others = |line: &Linear| line.unknowns.iter().any(|(name, _)| !convention.letters.contains(name));
        if line.iter().any(others) {
            return Vec::new();
        }
        let sides: Vec<Side> = line.iter().map(|line| Side::of(line, convention)).collect();
        let has = |unknowns: &Vec<[f64; 2]>| unknowns.iter().zip(&sides).all(|(numbers, side)| side.has(*numbers));
        let in_proportion: Vec<bool> = self.unknowns.iter().map(has).collect();
        // Most lines are neither law, however changed.
        if !in_proportion.contains(&true) {
            return Vec::new();
        }
        let is_line = |changed: &&Changed| {
            let change @ Change { tolerance, departures, .. } = &changes()[changed.change];
            let factors = || -> Vec<Spread> {
                let each = changed.numbers.iter().zip(&sides);
                each.map(|([p, q, _], side)| side.factor([*p, *q])).collect()
            };
            let is_without_e = departures.contains(&Departure::RestitutionMissing);
            in_proportion[changed.unknowns]
                && !(shows_e && is_without_e)
                && changed.numbers.iter().zip(&sides).all(|(numbers, side)| side.is_law(*numbers, *tolerance))
                && apiece.may_be(change, &self.inputs, &factors())
        };
        let in_components = self.inputs[0].in_components;
        let named = |departure: &Departure| match departure {
            Departure::SineForCosine if in_components => Departure::WrongAxis,
            other => *other,
        };
        let mut either: Vec<Matched> = Vec::new();
        let mut of = self.changed.iter().filter(is_line).map(|changed| &changes()[changed.change]);
        while let Some(change) = of.find(|change| either.iter().all(|first| first.equation != change.equation)) {
            let departures: Vec<Departure> = change.departures.iter().map(named).collect();
            either.push(Matched { equation: change.equation, departures });
            if change.departures.is_empty() || either.len() == BOTH.len() {
                break;
            }
        }
        // What is true of the velocities is no law that was written wrongly, but what follows from both.
        let is_law = either.iter().any(|one| one.departures.is_empty());
        either.retain(|_| is_law || !self.is_true(line, convention));
        either
    }

    /// Is it what both equations say of one of the velocities after the impact?
    pub(in crate::mark::working) fn is_step(&self, line: &[Linear], convention: &Convention) -> bool {
        let is_of_one =
            |line: &Linear| matches!(line.unknowns.as_slice(), [(name, _)] if convention.letters.contains(name));
        line.iter().all(is_of_one) && self.is_true(line, convention)
    }

    /// Of one velocity alone it is not asked which, nor which way.
    fn is_true(&self, line: &[Linear], convention: &Convention) -> bool {
        let is_of_one = |(line, after): (&Linear, &[f64; 2])| match line.unknowns.as_slice() {
            [(_, number)] => after.iter().any(|own| {
                let moved = number.times(*own).absolute();
                (moved - line.constant.absolute()).may_be_nought(line.size.max(moved.high))
            }),
            _ => false,
        };
        let is = |(line, after): (&Linear, &[f64; 2])| {
            let term =
                |place: usize| line.before(&convention.letters[place]).times(convention.signs[place] * after[place]);
            let terms = [term(0), term(1)];
            let size = terms.iter().fold(line.size, |size, term| size.max(term.middle().abs()));
            (terms[0] + terms[1] + line.constant).may_be_nought(size)
        };
        self.after.as_ref().is_some_and(|after| {
            let each = || line.iter().zip(after);
            each().all(is) || each().all(is_of_one)
        })
    }

    /// The law that a line is as it stands; what it has of each sphere is asked for where all else is right.
    pub(in crate::mark::working) fn exactly(
        &self,
        line: &[Linear],
        apiece: impl Fn() -> Apiece,
        convention: &Convention,
    ) -> Option<Quantity> {
        let sides: Vec<Side> = line.iter().map(|line| Side::of(line, convention)).collect();
        let has_others =
            line.iter().flat_map(|line| &line.unknowns).any(|(name, _)| !convention.letters.contains(name));
        // What is not changed at all comes first.
        let laws = self.changed.iter().map(|changed| (&changes()[changed.change], &changed.numbers));
        let mut unchanged = laws.take_while(|(change, _)| change.departures.is_empty());
        let is_line = |(change, numbers): &(&Change, &Vec<[f64; 3]>)| {
            let factors = || Vec::from_iter(numbers.iter().zip(&sides).map(|([p, q, _], side)| side.factor([*p, *q])));
            numbers.iter().zip(&sides).all(|(numbers, side)| {
                let [p, q, _] = *numbers;
                side.has([p, q]) && side.is_law(*numbers, change.tolerance)
            }) && apiece().may_be(change, &self.inputs, &factors())
        };
        unchanged.find(|law| !has_others && is_line(law)).map(|(change, _)| change.equation)
    }

    /// Momentum with one velocity for both spheres, `16 cos 30° = (4 + 2)v`: that they move on together stands in it too.
    pub(super) fn moving_on_together(
        &self,
        line: &[Linear],
        apiece: &Apiece,
        convention: &Convention,
    ) -> Option<[Matched; 2]> {
        let is = |(at, line): (&Inputs, &Linear)| {
            let [(name, number)] = line.unknowns.as_slice() else { return false };
            let Some(place) = convention.letters.iter().position(|letter| letter == name) else { return false };
            let [a, b] = at.along;
            let velocity = (at.masses[0] * a + at.masses[1] * b) / (at.masses[0] + at.masses[1]);
            let moved = number.times(convention.signs[place] * velocity);
            // Where nothing moves on, nothing is seen of it.
            velocity.abs() > 1e-9 && (moved + line.constant).may_be_nought(line.size.max(moved.middle().abs()))
        };
        let momentum = Matched { equation: Quantity::MomentumEquation, departures: Vec::new() };
        // With one velocity given there is but one to be found.
        let factor = |(at, line): (&Inputs, &Linear)| {
            let side = Side::of(line, convention).unknowns;
            (side[0] + side[1]).times(1.0 / (at.masses[0] + at.masses[1]))
        };
        let each = || self.inputs.iter().zip(line);
        let is_together = !self.is_after_given
            && each().all(is)
            && apiece.may_be_momentum(&self.inputs, &each().map(factor).collect::<Vec<_>>());
        is_together.then(|| [momentum, self.one_velocity()])
    }

    /// That both spheres have one velocity afterwards: restitution where e is nought, and else a mistake.
    pub(super) fn one_velocity(&self) -> Matched {
        let departures = Vec::from_iter(self.inputs.iter().any(|at| at.e != 0.0).then_some(Departure::Coalesced));
        Matched { equation: Quantity::RestitutionEquation, departures }
    }
}

/// A line at a point: the numbers before the two unknowns, both positive from A to B, and the constant.
struct Side {
    unknowns: [Spread; 2],
    /// Are the unknowns there at all?
    are_there: [bool; 2],
    constant: Spread,
    size: f64,
}

impl Side {
    fn of(line: &Linear, convention: &Convention) -> Side {
        let unknowns = [0, 1].map(|place| {
            let before = line.before(&convention.letters[place]);
            if convention.signs[place] < 0.0 { -before } else { before }
        });
        let are_there = unknowns.map(|number| !number.may_be_nought(line.size));
        Side { unknowns, are_there, constant: line.constant, size: line.size }
    }

    /// Do the unknowns stand in it as in this law, up to a factor? Nobody rounds a mass.
    fn has(&self, [p, q]: [f64; 2]) -> bool {
        let [v, w] = self.unknowns;
        self.are_there == [p != 0.0, q != 0.0]
            && (v.times(q) - w.times(p)).may_be_nought(self.size.max(1e-300) * p.abs().max(q.abs()))
    }

    /// What this law is multiplied by, of which it has the unknowns.
    fn factor(&self, [p, q]: [f64; 2]) -> Spread {
        let [v, w] = self.unknowns;
        if p != 0.0 { v.times(1.0 / p) } else { w.times(1.0 / q) }
    }

    /// Is it this law, up to a factor that the unknowns have?
    fn is_law(&self, [p, q, r]: [f64; 3], tolerance: f64) -> bool {
        let [v, w] = self.unknowns;
        // In proportion: (v, w, constant) is a multiple of (p, q, -r).
        let scale = self.size.max(1e-300) * p.abs().max(q.abs()).max(r.abs());
        let close = |one: Spread, other: Spread| {
            let difference = one - other;
            let slack = tolerance * one.middle().abs().max(other.middle().abs());
            Spread { low: difference.low - slack, high: difference.high + slack }.may_be_nought(scale)
        };
        close(self.constant.times(p), v.times(-r)) && close(self.constant.times(q), w.times(-r))
    }
}
