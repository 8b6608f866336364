//! Many impacts as columns of doubles: all masses of A, all masses of B and so on, each in a row of memory.
//!
//! A processor takes several impacts at a time that way, and what is left to wait for is the memory. The formula is that of
//! one quotient.

use crate::method::batch::{LETTERS_ARE_NO_FLOATS, float};
use crate::method::{After, Found, Impact, Method, Prepared, Promise, Role, Skip};
use crate::number::Value;

/// Columns of doubles.
pub(in crate::method) struct Columns;

/// How many impacts are taken at a time.
const LANES: usize = 8;

/// Five columns in and two out.
#[derive(Default)]
struct Table {
    m_a: Vec<f64>,
    m_b: Vec<f64>,
    a: Vec<f64>,
    b: Vec<f64>,
    e: Vec<f64>,
    v_a: Vec<f64>,
    v_b: Vec<f64>,
    /// The velocities before, for what is across the line of centres, and the place of what is along it.
    before: Vec<(After<f64>, usize)>,
}

impl Method for Columns {
    fn name(&self) -> &'static str {
        "columns"
    }

    fn role(&self) -> Role {
        Role::Beside
    }

    fn accepts(&self) -> &'static str {
        "all nine numbers without letters, a line of centres along an axis"
    }

    fn promises(&self) -> Promise {
        Promise::Scaled(64.0)
    }

    fn prepare(&self, impacts: &[Impact<Value>]) -> Result<Box<dyn Prepared>, Skip> {
        let mut table = Table::default();
        for (place, impact) in impacts.iter().enumerate() {
            let skip = |why: &str| Skip { place, why: why.to_owned() };
            let Impact { masses, before, line, restitution } =
                impact.in_floats().ok_or_else(|| skip(LETTERS_ARE_NO_FLOATS))?;
            let axis = match line {
                [_, 0.0] => 0,
                [0.0, _] => 1,
                _ => return Err(skip("the line of centres lies along neither axis")),
            };
            table.m_a.push(masses[0]);
            table.m_b.push(masses[1]);
            table.a.push(before[0][axis]);
            table.b.push(before[1][axis]);
            table.e.push(restitution);
            table.before.push((before, axis));
        }
        table.v_a = vec![0.0; impacts.len()];
        table.v_b = vec![0.0; impacts.len()];
        Ok(Box::new(table))
    }
}

impl Prepared for Table {
    fn run(&mut self) {
        let mut outs = self.v_a.chunks_exact_mut(LANES).zip(self.v_b.chunks_exact_mut(LANES));
        let masses = self.m_a.chunks_exact(LANES).zip(self.m_b.chunks_exact(LANES));
        let speeds = self.a.chunks_exact(LANES).zip(self.b.chunks_exact(LANES));
        let ins = masses.zip(speeds).zip(self.e.chunks_exact(LANES));
        for ((((m_a, m_b), (a, b)), e), (v_a, v_b)) in ins.zip(&mut outs) {
            for lane in 0..LANES {
                [v_a[lane], v_b[lane]] = on_line([m_a[lane], m_b[lane]], [a[lane], b[lane]], e[lane]);
            }
        }
        for row in self.a.len() / LANES * LANES..self.a.len() {
            let after = on_line([self.m_a[row], self.m_b[row]], [self.a[row], self.b[row]], self.e[row]);
            [self.v_a[row], self.v_b[row]] = after;
        }
    }

    fn found(&self) -> Vec<Found> {
        let along = self.v_a.iter().zip(&self.v_b);
        let whole = |((before, axis), (v_a, v_b)): (&(After<f64>, usize), (&f64, &f64))| {
            let mut after = *before;
            (after[0][*axis], after[1][*axis]) = (*v_a, *v_b);
            float(after)
        };
        self.before.iter().zip(along).map(whole).collect()
    }
}

#[inline(always)]
fn on_line([m_a, m_b]: [f64; 2], [a, b]: [f64; 2], e: f64) -> [f64; 2] {
    let per_mass = (1.0 + e) * (a - b) / (m_a + m_b);
    [a - per_mass * m_b, b + per_mass * m_a]
}
