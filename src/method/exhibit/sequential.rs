//! The impulse found by repeated correction, as engines do it.
//!
//! In each round the impulse that is still missing for the separation that restitution asks for is added, and the sum is
//! kept from pulling. With one contact the first round does all; the rounds after it only repeat the roundings. What an
//! engine gets wrong is not this: it is the line of centres, as [`FixedStep`](super::FixedStep) shows.

use super::{NO_APPROACH, approach};
use crate::method::batch::{LETTERS_ARE_NO_FLOATS, batch, float};
use crate::method::{After, Found, Impact, Method, Prepared, Promise, Role, Skip};
use crate::number::Value;

/// Repeated corrections of an impulse.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Sequential {
    /// How many rounds.
    pub rounds: u32,
}

impl Sequential {
    /// As many rounds as engines usually take.
    pub const USUAL: Sequential = Sequential { rounds: 8 };
}

impl Method for Sequential {
    fn name(&self) -> &'static str {
        "sequential-impulses"
    }

    fn role(&self) -> Role {
        Role::Exhibit
    }

    fn accepts(&self) -> &'static str {
        "all nine numbers without letters, spheres that approach"
    }

    fn promises(&self) -> Promise {
        Promise::Scaled(128.0)
    }

    fn prepare(&self, impacts: &[Impact<Value>]) -> Result<Box<dyn Prepared>, Skip> {
        let rounds = self.rounds;
        let form = |impact: &Impact<Value>| Ok((impact.in_floats().ok_or(LETTERS_ARE_NO_FLOATS)?, ()));
        batch(
            impacts,
            form,
            move |impact| solve(impact, rounds),
            |(), after: &Option<After<f64>>| match after {
                Some(after) => float(*after),
                None => Found::Missed(NO_APPROACH.to_owned()),
            },
        )
    }
}

fn solve(impact: &Impact<f64>, rounds: u32) -> Option<After<f64>> {
    let ([x, y], closing) = approach(impact)?;
    let [m_a, m_b] = impact.masses;
    let per_impulse = 1.0 / m_a + 1.0 / m_b;
    let [mut a, mut b] = impact.before;
    let mut total = 0.0_f64;
    for _ in 0..rounds {
        let separation = (b[0] - a[0]) * x + (b[1] - a[1]) * y;
        let raised = (total + (impact.restitution * closing - separation) / per_impulse).max(0.0);
        let added = raised - total;
        total = raised;
        a = [a[0] - added / m_a * x, a[1] - added / m_a * y];
        b = [b[0] + added / m_b * x, b[1] + added / m_b * y];
    }
    Some([a, b])
}
