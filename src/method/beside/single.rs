//! One quotient in single precision: half the memory, and about seven figures.

use crate::method::batch::{LETTERS_ARE_NO_FLOATS, batch, float};
use crate::method::{Impact, Method, Prepared, Promise, Role, Skip};
use crate::number::Value;

/// Single precision.
pub(in crate::method) struct Single;

impl Method for Single {
    fn name(&self) -> &'static str {
        "single"
    }

    fn role(&self) -> Role {
        Role::Beside
    }

    fn accepts(&self) -> &'static str {
        "all nine numbers without letters, any line of centres"
    }

    fn promises(&self) -> Promise {
        // As the same formula in doubles, in roundoffs that are 2^29 times as large.
        Promise::Scaled(64.0 * f64::from(1 << 29))
    }

    fn prepare(&self, impacts: &[Impact<Value>]) -> Result<Box<dyn Prepared>, Skip> {
        let form = |impact: &Impact<Value>| {
            let doubles = impact.in_floats().ok_or(LETTERS_ARE_NO_FLOATS)?;
            #[allow(clippy::cast_possible_truncation)]
            let singles = doubles.turned_into(|number| Some(*number as f32));
            Ok((singles.ok_or(LETTERS_ARE_NO_FLOATS)?, ()))
        };
        batch(impacts, form, solve, |(), after| float(after.map(|velocity| velocity.map(f64::from))))
    }
}

#[inline(always)]
fn solve(impact: &Impact<f32>) -> [[f32; 2]; 2] {
    let ([m_a, m_b], [a, b], [x, y]) = (impact.masses, impact.before, impact.line);
    let approach = (a[0] - b[0]) * x + (a[1] - b[1]) * y;
    let per_mass = (1.0 + impact.restitution) * approach / ((m_a + m_b) * (x * x + y * y));
    let (to_a, to_b) = (per_mass * m_b, per_mass * m_a);
    [[a[0] - to_a * x, a[1] - to_a * y], [b[0] + to_b * x, b[1] + to_b * y]]
}
