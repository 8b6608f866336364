//! Many impacts as columns of doubles: all masses of A, all masses of B and so on, each in a row of memory.
//!
//! A processor takes several impacts at a time that way, and what is left to wait for is the memory. The formula is that of
//! one quotient.

use crate::method::batch::{LETTERS_ARE_NO_FLOATS, float};
use crate::method::{After, Found, Impact, Method, Prepared, Promise, Role, Skip};
use crate::number::Value;

/// Columns of doubles.
pub(in crate::method) struct Columns;

/// How many impacts are taken at a time: enough for processors with many registers, and not too many for others.
const LANES: usize = 32;
type Lanes = [f64; LANES];

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
        let Table { m_a, m_b, a, b, e, v_a, v_b, .. } = self;
        let rows = a.len() / LANES * LANES..a.len();
        let masses = lanes(m_a).zip(lanes(m_b));
        let ins = masses.zip(lanes(a).zip(lanes(b))).zip(lanes(e));
        let outs = v_a.as_chunks_mut::<LANES>().0.iter_mut().zip(v_b.as_chunks_mut::<LANES>().0);
        for ((((m_a, m_b), (a, b)), e), (v_a, v_b)) in ins.zip(outs) {
            // A stage for all of them before the next stage: else wide processors gather what lies side by side.
            let per_mass: Lanes =
                std::array::from_fn(|lane| per_mass([m_a[lane], m_b[lane]], [a[lane], b[lane]], e[lane]));
            *v_a = std::array::from_fn(|lane| a[lane] - per_mass[lane] * m_b[lane]);
            *v_b = std::array::from_fn(|lane| b[lane] + per_mass[lane] * m_a[lane]);
        }
        for row in rows {
            let per_mass = per_mass([m_a[row], m_b[row]], [a[row], b[row]], e[row]);
            (v_a[row], v_b[row]) = (a[row] - per_mass * m_b[row], b[row] + per_mass * m_a[row]);
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
fn per_mass([m_a, m_b]: [f64; 2], [a, b]: [f64; 2], e: f64) -> f64 {
    (1.0 + e) * (a - b) / (m_a + m_b)
}

fn lanes(column: &[f64]) -> std::slice::Iter<'_, Lanes> {
    column.as_chunks().0.iter()
}
