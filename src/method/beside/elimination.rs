//! All four equations at once, by Gauss's elimination in doubles, with the unknowns along **i** and **j**.
//!
//! Momentum along the line of centres, restitution, and for each sphere no change across the line: four linear
//! equations for the four components after the impact, and nothing resolved beforehand.

use crate::method::batch::floats;
use crate::method::{After, Impact, Method, Prepared, Promise, Role, Skip};
use crate::number::Value;

/// Gauss's elimination of four unknowns.
pub(in crate::method) struct Elimination;

impl Method for Elimination {
    fn name(&self) -> &'static str {
        "elimination"
    }

    fn role(&self) -> Role {
        Role::Beside
    }

    fn accepts(&self) -> &'static str {
        "all nine numbers without letters, any line of centres"
    }

    fn promises(&self) -> Promise {
        Promise::Nothing("rows of unlike masses are not scaled, and lose the lighter sphere's figures")
    }

    fn prepare(&self, impacts: &[Impact<Value>]) -> Result<Box<dyn Prepared>, Skip> {
        floats(impacts, |impact| solve(impact).unwrap_or([[f64::NAN; 2]; 2]))
    }
}

fn solve(impact: &Impact<f64>) -> Option<After<f64>> {
    let [m_a, m_b] = impact.masses;
    let [[a_x, a_y], [b_x, b_y]] = impact.before;
    let e = impact.restitution;
    let size = impact.line[0].hypot(impact.line[1]);
    let (x, y) = (impact.line[0] / size, impact.line[1] / size);
    // Columns: components of A along i and j, of B along i and j, and the right side.
    let mut rows = [
        [m_a * x, m_a * y, m_b * x, m_b * y, m_a * (a_x * x + a_y * y) + m_b * (b_x * x + b_y * y)],
        [-x, -y, x, y, e * ((a_x - b_x) * x + (a_y - b_y) * y)],
        [-y, x, 0.0, 0.0, a_y * x - a_x * y],
        [0.0, 0.0, -y, x, b_y * x - b_x * y],
    ];
    let [v_a_x, v_a_y, v_b_x, v_b_y] = eliminate(&mut rows)?;
    Some([[v_a_x, v_a_y], [v_b_x, v_b_y]])
}

/// Solves the rows, each time with the largest pivot; `None` if they do not determine the unknowns.
fn eliminate(rows: &mut [[f64; 5]; 4]) -> Option<[f64; 4]> {
    for column in 0..4 {
        let largest = (column..4).max_by(|a, b| rows[*a][column].abs().total_cmp(&rows[*b][column].abs()))?;
        rows.swap(column, largest);
        let pivot = rows[column];
        if pivot[column] == 0.0 || pivot[column].is_nan() {
            return None;
        }
        for (place, row) in rows.iter_mut().enumerate() {
            let share = row[column] / pivot[column];
            if place != column {
                row.iter_mut().zip(pivot).for_each(|(entry, above)| *entry -= share * above);
            }
        }
    }
    Some(std::array::from_fn(|unknown| rows[unknown][4] / rows[unknown][unknown]))
}
