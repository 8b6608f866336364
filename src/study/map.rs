//! Maps of stability: in a regime that grows harder with an exponent k, how wrong each arrangement is at its worst.
//!
//! A row is an arrangement, a column an exponent, and a cell the worst error among some scenes. Scenes are dealt from a
//! stream that belongs to the map and the column, so that a few of them are the first few of many: what fails among
//! few fails among many.

use std::ops::RangeInclusive;

use rand::rngs::ChaCha8Rng;
use rand::{Rng, SeedableRng};

use super::double::Outcome;

/// One way to work a quantity out.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Arrangement {
    /// Its name: `difference`.
    pub name: &'static str,
    /// What is worked out, in a few words or a formula.
    pub says: &'static str,
}

/// A quantity in a regime.
#[derive(Clone, Copy)]
pub struct Subject {
    /// Its name on a command line, in a table and in the name of a file: `energy-nearly-elastic`.
    pub name: &'static str,
    /// What is worked out: `kinetic energy lost`.
    pub quantity: &'static str,
    /// The regime in words, with k: `e = 1 - 10^-k`.
    pub regime: &'static str,
    /// The values of k.
    pub exponents: (u32, u32),
    /// Ways to work it out, as many as `scene` gives outcomes and in that order.
    pub arrangements: &'static [Arrangement],
    /// Deals a scene for k and says how far each arrangement is off.
    pub scene: fn(k: u32, deal: &mut Dealer) -> Vec<Outcome>,
}

/// What was found: a row for each arrangement.
#[derive(Clone, Debug, PartialEq)]
pub struct Map {
    /// As the subject has it.
    pub name: String,
    /// As the subject has it.
    pub quantity: String,
    /// As the subject has it.
    pub regime: String,
    /// The first value of k.
    pub first: u32,
    /// The rows.
    pub rows: Vec<Row>,
}

/// What was found for one arrangement.
#[derive(Clone, Debug, PartialEq)]
pub struct Row {
    /// The arrangement's name.
    pub arrangement: String,
    /// What it works out.
    pub says: String,
    /// The worst outcome for each value of k.
    pub worst: Vec<Outcome>,
}

impl Subject {
    /// The values of k.
    pub fn columns(&self) -> RangeInclusive<u32> {
        self.exponents.0..=self.exponents.1
    }

    /// The worst of some scenes at every k.
    pub fn map(&self, scenes: usize) -> Map {
        let columns: Vec<Vec<Outcome>> = self.columns().map(|k| self.column(k, scenes)).collect();
        let row = |(place, arrangement): (usize, &Arrangement)| Row {
            arrangement: arrangement.name.to_owned(),
            says: arrangement.says.to_owned(),
            worst: columns.iter().map(|column| column[place]).collect(),
        };
        Map {
            name: self.name.to_owned(),
            quantity: self.quantity.to_owned(),
            regime: self.regime.to_owned(),
            first: self.exponents.0,
            rows: self.arrangements.iter().enumerate().map(row).collect(),
        }
    }

    /// The worst outcome of each arrangement among some scenes at one k.
    pub fn column(&self, k: u32, scenes: usize) -> Vec<Outcome> {
        let mut deal = Dealer::new(self.name, k);
        let mut worst = vec![Outcome::Refused; self.arrangements.len()];
        for _ in 0..scenes {
            for (worst, outcome) in worst.iter_mut().zip((self.scene)(k, &mut deal)) {
                *worst = worst.worse(outcome);
            }
        }
        worst
    }
}

impl Map {
    /// The row of an arrangement.
    pub fn row(&self, arrangement: &str) -> Option<&Row> {
        self.rows.iter().find(|row| row.arrangement == arrangement)
    }

    /// The last value of k.
    pub fn last(&self) -> u32 {
        self.first + self.rows.first().map_or(0, |row| row.worst.len().saturating_sub(1) as u32)
    }
}

impl Row {
    /// The first k at which it is no longer within a bound; none if it is always.
    pub fn fails_from(&self, first: u32, bound: f64) -> Option<u32> {
        self.worst.iter().position(|outcome| !outcome.within(bound)).map(|place| first + place as u32)
    }
}

/// Deals numbers that look like those of a scene, the same on every machine.
pub struct Dealer {
    random: ChaCha8Rng,
}

impl Dealer {
    /// The stream of a subject and an exponent.
    pub fn new(name: &str, k: u32) -> Dealer {
        let mut random = ChaCha8Rng::seed_from_u64(k.into());
        // Any number that differs between names will do; this is FNV-1a.
        let stream = name
            .bytes()
            .fold(0xcbf2_9ce4_8422_2325u64, |hash, byte| (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3));
        random.set_stream(stream);
        Dealer { random }
    }

    /// A double from a range, all of its figures at random.
    pub fn between(&mut self, low: f64, high: f64) -> f64 {
        let part = (self.random.next_u64() >> 11) as f64 / (1u64 << 53) as f64;
        low + (high - low) * part
    }

    /// A whole number below a bound.
    pub fn below(&mut self, bound: u64) -> u64 {
        // The bounds are small: what the last incomplete round adds to some of them is below 2^-50.
        self.random.next_u64() % bound
    }

    /// A mass in kg, from half to eight.
    pub fn mass(&mut self) -> f64 {
        self.between(0.5, 8.0)
    }

    /// A speed in m/s, from one to ten.
    pub fn speed(&mut self) -> f64 {
        self.between(1.0, 10.0)
    }

    /// A coefficient of restitution that is neither near nought nor near one.
    pub fn restitution(&mut self) -> f64 {
        self.between(0.1, 0.9)
    }
}
