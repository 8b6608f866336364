//! What an impact costs: every method on every kind of scene that it takes, timed in turns.
//!
//! The room has no clock of its own: whoever asks brings one. Machines differ and so do days, hence each time stands beside
//! its ratio to the plain formula in doubles on the same kind of scene in the same run. Methods take turns, so that a slow
//! moment of the machine falls on all of them, and the shortest time of each counts.

use super::chart::Work;
use super::impacts::{in_values, ordinary};
use super::map::Dealer;
use super::velocities::ordinary_error;
use crate::method::exhibit::{FixedStep, Sequential, Spring};
use crate::method::{Impact, METHODS, Method, Prepared, Promise, Role, Skip};
use crate::number::{Direction, Fraction, Letter, Range, Value};

/// How long to look at the clock.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Effort {
    /// Nanoseconds for one turn of one method.
    pub turn: u64,
    /// How many turns each has.
    pub turns: usize,
}

impl Effort {
    /// A look: a few seconds in all.
    pub const QUICK: Effort = Effort { turn: 1_000_000, turns: 7 };
    /// Half a minute or so.
    pub const THOROUGH: Effort = Effort { turn: 5_000_000, turns: 25 };
}

/// What one method costs on one kind of scene.
#[derive(Clone, Debug, PartialEq)]
pub struct Cost {
    /// The method, or another program's.
    pub name: String,
    /// What kind of method it is.
    pub work: Work,
    /// The kind of scene.
    pub scene: String,
    /// Steps for one contact, if it has steps; the points of a method with several are a curve.
    pub steps: Option<u32>,
    /// Nanoseconds for one impact.
    pub nanoseconds: f64,
    /// The same as a multiple of the plain formula in doubles.
    pub ratio: f64,
    /// The worst error of a velocity as a part of the largest speed; none where it has not been worked out.
    pub error: Option<f64>,
}

/// A kind of scene.
#[derive(Clone, Copy)]
pub struct Kind {
    /// Its name in tables: `oblique-fractions`.
    pub name: &'static str,
    /// In words: `any line of centres, fractions`.
    pub words: &'static str,
    scene: fn(&mut Dealer) -> Option<Impact<Value>>,
}

/// Kinds of scenes, the simple before the rich.
pub const KINDS: &[Kind] = &[
    Kind { name: "head-on", words: "head-on, fractions", scene: |deal| Some(head_on(deal)) },
    Kind { name: "oblique", words: "any line of centres, fractions", scene: |deal| Some(in_values(&ordinary(deal))) },
    Kind {
        name: "special-angles",
        words: "30°, 45° and 60°: surds",
        scene: |deal| {
            let degrees = [30, 45, 60][deal.below(3) as usize];
            polar(deal, degrees)
        },
    },
    Kind {
        name: "any-angle",
        words: "any whole number of degrees",
        scene: |deal| {
            let degrees = 10 + 5 * deal.below(15) as i64 + 1;
            polar(deal, degrees)
        },
    },
    Kind {
        name: "surd-e",
        words: "fractions, but e = √2/3",
        scene: |deal| {
            let surd = Value::from(2).square_root()?.divided_by(&Value::from(3))?;
            Some(Impact { restitution: surd, ..in_values(&ordinary(deal)) })
        },
    },
    Kind {
        name: "letters",
        words: "masses m and km, e a letter",
        scene: |deal| {
            let letter = |name: &str, range| Letter::new(name, range).map(Value::letter);
            let (m, k, e) = (letter("m", Range::Positive)?, letter("k", Range::Positive)?, letter("e", Range::Unit)?);
            let masses = [m.clone(), &m * &k];
            Some(Impact { masses, restitution: e, ..head_on(deal) })
        },
    },
];

/// How many impacts are solved in a row.
const BATCH: usize = 128;

/// How many scenes the error is looked for in.
const SCENES: usize = 400;

/// The name of the method by which all others are measured.
pub const PLAIN: &str = "ratio";

/// What kind of method it is.
pub fn work_of(method: &dyn Method) -> Work {
    match (method.role(), method.promises()) {
        (Role::Exhibit, _) => Work::Simulated,
        (_, Promise::Exact) => Work::Exact,
        (_, Promise::Enclosed) => Work::Certified,
        // A formula in doubles is off by some of their roundoffs, and one in single precision by millions.
        (_, Promise::Scaled(roundoffs)) if roundoffs > 1000.0 => Work::OtherPrecision,
        _ => Work::Double,
    }
}

/// What runs: a method of the list, or an exhibit in one of its settings.
struct Entrant {
    method: Box<dyn Method>,
    steps: Option<u32>,
}

/// Sizes of step, as steps in a contact and as looks a second, that make the curves of the exhibits.
const CONTACT_STEPS: [u32; 4] = [10, 100, 1000, 10_000];
const LOOKS: [u32; 4] = [60, 240, 1000, 10_000];

/// How long a contact by a spring takes here: so short that turning during it costs less than most steps do.
pub const CONTACT: f64 = 1e-6;

fn entrants() -> Vec<Entrant> {
    let listed = METHODS.iter().filter(|method| method.role() != Role::Exhibit);
    let mut all: Vec<Entrant> =
        listed.map(|method| Entrant { method: Box::new(Listed(*method)), steps: None }).collect();
    all.push(Entrant { method: Box::new(Sequential::USUAL), steps: None });
    for looks in LOOKS {
        let method = FixedStep { step: 1.0 / f64::from(looks), ..FixedStep::USUAL };
        all.push(Entrant { method: Box::new(method), steps: Some(looks) });
    }
    for usual in [Spring::VERLET, Spring::RUNGE_KUTTA] {
        for steps in CONTACT_STEPS {
            all.push(Entrant { method: Box::new(Spring { steps, contact: CONTACT, ..usual }), steps: Some(steps) });
        }
    }
    all
}

/// A method of the list where one is owned.
struct Listed(&'static dyn Method);

impl Method for Listed {
    fn name(&self) -> &'static str {
        self.0.name()
    }
    fn role(&self) -> Role {
        self.0.role()
    }
    fn accepts(&self) -> &'static str {
        self.0.accepts()
    }
    fn promises(&self) -> Promise {
        self.0.promises()
    }
    fn prepare(&self, impacts: &[Impact<Value>]) -> Result<Box<dyn Prepared>, Skip> {
        self.0.prepare(impacts)
    }
}

/// The error of an entrant in ordinary scenes; none where it refuses them or finds nothing.
fn error(entrant: &Entrant) -> Option<f64> {
    // What simulates is slow.
    let scenes = if entrant.steps.is_some() { SCENES / 4 } else { SCENES };
    ordinary_error(&*entrant.method, scenes).error()
}

/// Times every method on every kind of scene that it takes; what simulates on one, since it minds none of the differences.
/// `now` tells nanoseconds from some moment on.
pub fn costs(effort: Effort, now: &dyn Fn() -> u64, step: &mut dyn FnMut()) -> Vec<Cost> {
    let entrants = entrants();
    let errors: Vec<Option<f64>> = entrants.iter().map(error).collect();
    let mut costs = Vec::new();
    for kind in KINDS {
        let mut deal = Dealer::new(kind.name, 0);
        let impacts: Vec<Impact<Value>> = (0..BATCH).filter_map(|_| (kind.scene)(&mut deal)).collect();
        let mut racers: Vec<Racer> = Vec::new();
        for (place, entrant) in entrants.iter().enumerate() {
            if entrant.steps.is_some() && kind.name != "oblique" {
                continue;
            }
            // A few impacts are enough for what takes thousands of steps for each.
            let impacts = if entrant.steps.is_some() { &impacts[..BATCH / 16] } else { &impacts[..] };
            if let Ok(prepared) = entrant.method.prepare(impacts) {
                let (turns, impacts) = (effort.turns, impacts.len());
                racers.push(Racer { place, prepared, impacts, repeats: 1, turns, best: f64::INFINITY });
            }
        }
        racers.iter_mut().for_each(|racer| racer.warm_up(effort.turn, now));
        for turn in 0..effort.turns {
            racers.iter_mut().filter(|racer| turn < racer.turns).for_each(|racer| racer.turn(now));
            step();
        }
        let name = |racer: &Racer| entrants[racer.place].method.name();
        let plain = racers.iter().find(|racer| name(racer) == PLAIN).map(|racer| racer.best);
        let found = racers.iter().map(|racer| Cost {
            name: name(racer).to_owned(),
            work: work_of(&*entrants[racer.place].method),
            scene: kind.name.to_owned(),
            steps: entrants[racer.place].steps,
            nanoseconds: racer.best,
            ratio: plain.map_or(f64::NAN, |plain| racer.best / plain),
            error: errors[racer.place],
        });
        costs.extend(found);
    }
    against_doubles_elsewhere(&mut costs);
    costs
}

/// Where no double is taken, as with letters, the plain formula is that of the same run on any line of centres.
fn against_doubles_elsewhere(costs: &mut [Cost]) {
    let plain = costs.iter().find(|cost| cost.name == PLAIN && cost.scene == "oblique").map(|cost| cost.nanoseconds);
    for cost in costs.iter_mut().filter(|cost| !cost.ratio.is_finite()) {
        cost.ratio = plain.map_or(f64::NAN, |plain| cost.nanoseconds / plain);
    }
}

/// How many steps `costs` reports.
pub fn steps(effort: Effort) -> u64 {
    (KINDS.len() * effort.turns) as u64
}

struct Racer {
    place: usize,
    prepared: Box<dyn Prepared>,
    impacts: usize,
    repeats: u64,
    turns: usize,
    best: f64,
}

impl Racer {
    /// Finds out how often it is run in a turn.
    fn warm_up(&mut self, turn: u64, now: &dyn Fn() -> u64) {
        loop {
            let taken = self.run(now);
            if taken * 2 > turn || self.repeats > 1 << 20 {
                // What takes so long is not disturbed by a moment, and three turns of it are enough.
                self.turns = if taken > 20 * turn { self.turns.min(3) } else { self.turns };
                return;
            }
            self.repeats = (self.repeats * turn.div_euclid(taken.max(turn / 64))).max(self.repeats * 2);
        }
    }

    fn run(&mut self, now: &dyn Fn() -> u64) -> u64 {
        let begun = now();
        for _ in 0..self.repeats {
            self.prepared.run();
        }
        now().saturating_sub(begun)
    }

    fn turn(&mut self, now: &dyn Fn() -> u64) {
        let taken = self.run(now) as f64 / (self.repeats as f64 * self.impacts as f64);
        self.best = self.best.min(taken);
    }
}

/// Along **i**, with B at rest in one of three.
fn head_on(deal: &mut Dealer) -> Impact<Value> {
    let mut whole = |low: i64, high: i64| Value::from(low + deal.below((high - low + 1) as u64) as i64);
    let nought = Value::from(0);
    let before = [[whole(1, 9), nought.clone()], [whole(-2, 0), nought.clone()]];
    let masses = [whole(1, 9), whole(1, 9)];
    let parts = 2 + deal.below(8) as i64;
    let restitution = Value::Rational(Fraction::new(1 + deal.below(parts as u64) as i64, parts));
    Impact { masses, before, line: [Value::from(1), nought], restitution }
}

/// A at an angle with the line of centres, B moving along it.
fn polar(deal: &mut Dealer, degrees: i64) -> Option<Impact<Value>> {
    let impact = head_on(deal);
    let direction = Direction::degrees(&Fraction::from(degrees))?;
    let speed = &impact.before[0][0];
    let before = [[speed * &direction.cos, speed * &direction.sin], impact.before[1].clone()];
    Some(Impact { before, ..impact })
}

#[cfg(test)]
mod tests {
    use std::cell::Cell;

    use super::*;

    #[test]
    fn times_are_those_of_the_clock_that_is_brought() {
        // A clock that goes on by a thousand at every look: however fast the machine is, all cost the same.
        let time = Cell::new(0u64);
        let now = || {
            time.set(time.get() + 1000);
            time.get()
        };
        let effort = Effort { turn: 1000, turns: 2 };
        let mut steps_taken = 0;
        let found = costs(effort, &now, &mut || steps_taken += 1);
        assert_eq!(steps_taken, steps(effort));
        let plain: Vec<&Cost> = found.iter().filter(|cost| cost.name == PLAIN).collect();
        assert!(plain.len() >= 2, "{found:?}");
        let quick = found.iter().filter(|cost| cost.steps.is_none());
        assert!(quick.clone().all(|cost| cost.ratio == 1.0 && cost.nanoseconds == 1000.0 / BATCH as f64), "{found:?}");
        assert!(found.iter().filter(|cost| cost.steps.is_some()).all(|cost| cost.ratio == 16.0), "{found:?}");
    }

    #[test]
    fn every_kind_of_scene_is_solved_by_something_exact() {
        for kind in KINDS {
            let impact = (kind.scene)(&mut Dealer::new(kind.name, 0)).expect(kind.name);
            let exact = METHODS.iter().filter(|method| method.promises() == Promise::Exact);
            let solved = exact.filter(|method| method.prepare(std::slice::from_ref(&impact)).is_ok());
            assert!(solved.count() > 0, "{}", kind.name);
        }
    }
}
