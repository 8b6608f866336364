//! Every head-on scene that an examination might set, and what each method makes of its noughts and its ties.
//!
//! Masses are whole numbers up to a bound without a common factor, e is a fraction with a small denominator, velocities
//! are whole numbers of either sign with A the faster. A nought is a sphere that stops exactly. A tie is a velocity
//! half-way between two decimals of three figures; schools round it up in size.

use std::sync::mpsc;
use std::thread;

use crate::method::{Found, Impact, METHODS, Method};
use crate::number::{Fraction, Interval, Places, Value, round};

/// How large the grid is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Bounds {
    /// The largest mass.
    pub mass: i64,
    /// The largest denominator of e.
    pub parts: i64,
    /// The largest speed.
    pub speed: i64,
}

/// The whole grid: 310,365 scenes.
pub const WHOLE: Bounds = Bounds { mass: 9, parts: 10, speed: 9 };

/// A part of it that is soon gone through: 2,772 scenes.
pub const SMALL: Bounds = Bounds { mass: 4, parts: 4, speed: 4 };

/// What a method made of the grid.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Count {
    /// Its name.
    pub method: String,
    /// Velocities that should be nought and are not.
    pub ghosts: u64,
    /// Those that should not be nought and are.
    pub swallowed: u64,
    /// Velocities wrong in the third figure if printed by the usual formatting to three figures.
    pub formatted: u64,
    /// The same if multiplied by a power of ten, rounded half up, and divided.
    pub multiplied: u64,
    /// The same if first written with fifteen figures and these rounded half up.
    pub fifteen: u64,
    /// Wrong ones among all of these that were no ties.
    pub not_ties: u64,
    /// Velocities for which it left the third figure open, as an enclosure may.
    pub undecided: u64,
    /// Undecided ones that were neither ties nor noughts.
    pub undecided_plain: u64,
}

/// What is so, by integers.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Census {
    /// Of which grid.
    pub bounds: Bounds,
    /// Scenes.
    pub scenes: u64,
    /// Velocities that are nought.
    pub noughts: u64,
    /// Velocities that are ties at three figures.
    pub ties: u64,
    /// What each method made of them.
    pub counts: Vec<Count>,
}

/// Goes through the grid with every method that accepts it, on as many cores as there are; `step` is called for each block.
pub fn census(bounds: Bounds, methods: &[&dyn Method], step: &mut dyn FnMut()) -> Census {
    let cores = thread::available_parallelism().map_or(1, usize::from);
    let (done, steps) = mpsc::channel();
    let parts: Vec<Part> = thread::scope(|scope| {
        let part = |core: usize| {
            let done = done.clone();
            scope.spawn(move || Part::of(bounds, methods, (core, cores), &done))
        };
        let running: Vec<_> = (0..cores).map(part).collect();
        drop(done);
        steps.iter().for_each(|()| step());
        running.into_iter().filter_map(|part| part.join().ok()).collect()
    });
    let mut whole = Part::empty(bounds, methods);
    parts.iter().for_each(|part| whole.add(part));
    // A count of a part of the grid says nothing.
    let mut refused = whole.refused.iter();
    whole.census.counts.retain(|_| !refused.next().copied().unwrap_or(true));
    whole.census
}

/// What was counted on one core.
struct Part {
    census: Census,
    /// Which methods refused a block.
    refused: Vec<bool>,
}

impl Part {
    fn empty(bounds: Bounds, methods: &[&dyn Method]) -> Part {
        let count = |method: &&dyn Method| Count { method: method.name().to_owned(), ..Count::default() };
        let counts = methods.iter().map(count).collect();
        let census = Census { bounds, scenes: 0, noughts: 0, ties: 0, counts };
        Part { census, refused: vec![false; methods.len()] }
    }

    /// Every so many-th pair of masses.
    fn of(bounds: Bounds, methods: &[&dyn Method], (core, cores): (usize, usize), done: &mpsc::Sender<()>) -> Part {
        let mut part = Part::empty(bounds, methods);
        for masses in coprime_masses(bounds.mass).skip(core).step_by(cores) {
            for e in farey(bounds.parts) {
                part.block(masses, e, methods);
                // Nobody listening is no reason to stop counting.
                let _ = done.send(());
            }
        }
        part
    }

    /// All velocities with these masses and this e.
    fn block(&mut self, masses: (i64, i64), e: (i64, i64), methods: &[&dyn Method]) {
        let speeds: Vec<(i64, i64)> = speeds(self.census.bounds.speed).collect();
        let impacts: Vec<Impact<Value>> = speeds.iter().map(|u| impact(masses, *u, e)).collect();
        let right: Vec<[Exact; 2]> = speeds.iter().map(|u| exact(masses, *u, e)).collect();
        self.census.scenes += speeds.len() as u64;
        for value in right.iter().flatten() {
            self.census.noughts += u64::from(value.numerator == 0);
            self.census.ties += u64::from(value.is_tie);
        }
        for ((method, count), refused) in methods.iter().zip(&mut self.census.counts).zip(&mut self.refused) {
            match method.prepare(&impacts) {
                Ok(mut prepared) => {
                    prepared.run();
                    prepared.found().iter().zip(&right).for_each(|(found, right)| count.add(found, right));
                }
                Err(_) => *refused = true,
            }
        }
    }

    fn add(&mut self, other: &Part) {
        self.census.scenes += other.census.scenes;
        self.census.noughts += other.census.noughts;
        self.census.ties += other.census.ties;
        for (count, more) in self.census.counts.iter_mut().zip(&other.census.counts) {
            count.merge(more);
        }
        self.refused.iter_mut().zip(&other.refused).for_each(|(refused, other)| *refused |= other);
    }
}

/// How many blocks there are, for a progress bar.
pub fn blocks(bounds: Bounds) -> u64 {
    (coprime_masses(bounds.mass).count() * farey(bounds.parts).count()) as u64
}

/// The methods that compute without time steps.
pub fn methods() -> Vec<&'static dyn Method> {
    METHODS.iter().copied().filter(|method| method.role() != crate::method::Role::Exhibit).collect()
}

fn coprime_masses(largest: i64) -> impl Iterator<Item = (i64, i64)> {
    let all = (1..=largest).flat_map(move |m_a| (1..=largest).map(move |m_b| (m_a, m_b)));
    all.filter(|(m_a, m_b)| common(*m_a, *m_b) == 1)
}

/// Fractions from 0 to 1 in lowest terms.
fn farey(parts: i64) -> impl Iterator<Item = (i64, i64)> {
    (1..=parts).flat_map(|q| (0..=q).map(move |p| (p, q))).filter(|(p, q)| common(*p, *q) == 1)
}

fn speeds(largest: i64) -> impl Iterator<Item = (i64, i64)> {
    (-largest..=largest).flat_map(move |u_b| (u_b + 1..=largest).map(move |u_a| (u_a, u_b)))
}

fn common(a: i64, b: i64) -> i64 {
    if b == 0 { a } else { common(b, a % b) }
}

fn impact(masses: (i64, i64), (u_a, u_b): (i64, i64), (p, q): (i64, i64)) -> Impact<Value> {
    let whole = |number: i64| Value::fraction(number, 1);
    Impact {
        masses: [whole(masses.0), whole(masses.1)],
        before: [[whole(u_a), whole(0)], [whole(u_b), whole(0)]],
        line: [whole(1), whole(0)],
        restitution: Value::fraction(p, q),
    }
}

/// A velocity as it is, with what it is at three figures.
struct Exact {
    numerator: i64,
    denominator: i64,
    /// Three figures from the first that is not nought, with the power of ten of the last, rounded half up.
    three: (i64, i32),
    is_tie: bool,
}

/// Both velocities, by integers over one denominator.
fn exact((m_a, m_b): (i64, i64), (u_a, u_b): (i64, i64), (p, q): (i64, i64)) -> [Exact; 2] {
    let denominator = q * (m_a + m_b);
    [
        Exact::new((q * m_a - p * m_b) * u_a + (p + q) * m_b * u_b, denominator),
        Exact::new((p + q) * m_a * u_a + (q * m_b - p * m_a) * u_b, denominator),
    ]
}

impl Exact {
    fn new(numerator: i64, denominator: i64) -> Exact {
        let (n, d) = (i128::from(numerator.abs()), i128::from(denominator));
        if n == 0 {
            return Exact { numerator, denominator, three: (0, 0), is_tie: false };
        }
        // The power of ten with which the value, divided by it, has three figures before the point.
        let mut power = 0;
        let scaled = |power: i32| match power {
            0.. => (n, d * 10i128.pow(power as u32)),
            _ => (n * 10i128.pow(-power as u32), d),
        };
        while scaled(power).0 >= 1000 * scaled(power).1 {
            power += 1;
        }
        while scaled(power).0 < 100 * scaled(power).1 {
            power -= 1;
        }
        let (n, d) = scaled(power);
        let figures = (2 * n + d) / (2 * d);
        let is_tie = (2 * n + d) % (2 * d) == 0;
        let three = normal(figures as i64 * numerator.signum(), power);
        Exact { numerator, denominator, three, is_tie }
    }

    fn fraction(&self) -> Fraction {
        Fraction::new(self.numerator, self.denominator)
    }
}

/// 1000 of one power is 100 of the next.
fn normal(figures: i64, power: i32) -> (i64, i32) {
    if figures.abs() == 1000 { (figures / 10, power + 1) } else { (figures, power) }
}

impl Count {
    /// The names of its numbers, as in tables and claims.
    pub const COLUMNS: [&str; 8] =
        ["ghosts", "swallowed", "formatted", "multiplied", "fifteen", "not-ties", "undecided", "undecided-plain"];

    /// Its numbers in the order of their names.
    pub fn numbers(&self) -> [u64; 8] {
        let mut all = self.clone();
        all.places().map(|number| *number)
    }

    fn places(&mut self) -> [&mut u64; 8] {
        [
            &mut self.ghosts,
            &mut self.swallowed,
            &mut self.formatted,
            &mut self.multiplied,
            &mut self.fifteen,
            &mut self.not_ties,
            &mut self.undecided,
            &mut self.undecided_plain,
        ]
    }

    fn merge(&mut self, other: &Count) {
        self.places().into_iter().zip(other.numbers()).for_each(|(number, more)| *number += more);
    }

    fn add(&mut self, found: &Found, right: &[Exact; 2]) {
        for (sphere, right) in right.iter().enumerate() {
            match found {
                Found::Float(after) => self.float(after[sphere][0], right),
                Found::Exact(after) => {
                    if after[sphere][0].as_fraction() != Some(&right.fraction()) {
                        self.not_ties += 1;
                    }
                }
                Found::Enclosed(after) => {
                    if !decides(&after[sphere][0]) {
                        self.undecided += 1;
                        self.undecided_plain += u64::from(right.numerator != 0 && !right.is_tie);
                    }
                }
                Found::Missed(_) => self.not_ties += 1,
            }
        }
    }

    fn float(&mut self, found: f64, right: &Exact) {
        if right.numerator == 0 {
            self.ghosts += u64::from(found != 0.0);
            return;
        }
        if found == 0.0 {
            self.swallowed += 1;
            return;
        }
        // Far from a tie, and away from a power of ten, every way to round is right if one is.
        let scaled = found * super::double::power_of_ten_quickly(-right.three.1);
        let off = (scaled - right.three.0 as f64).abs();
        if off < 0.499_999 && right.three.0.abs() > 100 && right.three.0.abs() < 999 {
            return;
        }
        for (wrong, way) in [
            (&mut self.formatted, formatted(found)),
            (&mut self.multiplied, multiplied(found)),
            (&mut self.fifteen, fifteen(found)),
        ] {
            if way != right.three {
                *wrong += 1;
                self.not_ties += u64::from(!right.is_tie);
            }
        }
    }
}

/// Does an enclosure leave only one way to write three figures?
fn decides(enclosure: &Interval) -> bool {
    let three = |end: &Fraction| round(end, &Places::SignificantFigures(3));
    let agree = |enclosure: &Interval| {
        let (lower, upper) = (enclosure.lower(), enclosure.upper());
        lower == upper || three(&lower) == three(&upper)
    };
    // Most are decided by a few places, whose fractions are small.
    agree(&enclosure.with_bits(enclosure.bits().min(32))) || agree(enclosure)
}

/// Figures and power as the standard formatting writes them.
fn formatted(value: f64) -> (i64, i32) {
    let text = format!("{value:.2e}");
    let (figures, power) = text.split_once('e').unwrap_or((&text, "0"));
    let figures: i64 = figures.replace('.', "").parse().unwrap_or(0);
    (figures, power.parse::<i32>().unwrap_or(0) - 2)
}

/// As most programs do it.
fn multiplied(value: f64) -> (i64, i32) {
    let text = format!("{value:e}");
    let power = text.split_once('e').and_then(|(_, power)| power.parse::<i32>().ok()).unwrap_or(0) - 2;
    let figures = (value * super::double::power_of_ten_quickly(-power)).round();
    normal(figures as i64, power)
}

/// Fifteen figures first, which heals what the last places have lost.
fn fifteen(value: f64) -> (i64, i32) {
    let text = format!("{value:.14e}");
    let (figures, power) = text.split_once('e').unwrap_or((&text, "0"));
    let digits: i64 = figures.replace('.', "").parse().unwrap_or(0);
    let unit = 10i64.pow(12);
    let three = (digits.abs() + unit / 2) / unit * digits.signum();
    normal(three, power.parse::<i32>().unwrap_or(0) - 2)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn three_figures_by_integers_are_those_of_exact_rounding() {
        for numerator in (-300..300).filter(|numerator| *numerator != 0) {
            for denominator in [1, 3, 7, 8, 16, 40, 99, 1000] {
                let (figures, power) = Exact::new(numerator, denominator).three;
                let ours = &Fraction::from(figures) * &Fraction::from(10).power(power).unwrap();
                let rounded = round(&Fraction::new(numerator, denominator), &Places::SignificantFigures(3));
                assert_eq!(ours, rounded.to_fraction(), "{numerator}/{denominator}");
            }
        }
    }

    #[test]
    fn a_tie_is_seen() {
        // 9/8 = 1.125 is half-way between 1.12 and 1.13.
        assert!(Exact::new(9, 8).is_tie);
        assert_eq!(Exact::new(9, 8).three, (113, -2));
        assert_eq!((formatted(1.125), multiplied(1.125), fifteen(1.125)), ((112, -2), (113, -2), (113, -2)));
        assert!(!Exact::new(1, 3).is_tie);
        assert_eq!(Exact::new(-9995, 1000).three, (-100, -1));
    }

    #[test]
    fn the_grid_has_as_many_scenes_as_it_should() {
        let per_block = speeds(WHOLE.speed).count() as u64;
        assert_eq!(blocks(WHOLE) * per_block, 310_365);
    }
}
