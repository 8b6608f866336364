//! One impact in numbers of some kind, and what it leads to.
//!
//! Components are along **i** and **j**. The line of centres is a vector from A to B of any length.

use crate::number::Value;

/// One impact, everything known before it.
#[derive(Clone, Debug, PartialEq)]
pub struct Impact<N> {
    /// Masses of A and B.
    pub masses: [N; 2],
    /// Velocities of A and B before, by components along **i** and **j**.
    pub before: [[N; 2]; 2],
    /// A vector along the line of centres from A to B, of any length.
    pub line: [N; 2],
    /// The coefficient of restitution.
    pub restitution: N,
}

/// Velocities of A and B after the impact, by components along **i** and **j**.
pub type After<N> = [[N; 2]; 2];

impl<N> Impact<N> {
    /// The same impact in another kind of number; `None` where one of its numbers has no such form.
    pub fn turned_into<M>(&self, into: impl Fn(&N) -> Option<M>) -> Option<Impact<M>> {
        let pair = |[one, other]: &[N; 2]| -> Option<[M; 2]> { Some([into(one)?, into(other)?]) };
        Some(Impact {
            masses: pair(&self.masses)?,
            before: [pair(&self.before[0])?, pair(&self.before[1])?],
            line: pair(&self.line)?,
            restitution: into(&self.restitution)?,
        })
    }

    /// All nine numbers.
    pub fn numbers(&self) -> impl Iterator<Item = &N> {
        let velocities = self.before.as_flattened().iter();
        self.masses.iter().chain(velocities).chain(&self.line).chain([&self.restitution])
    }
}

impl Impact<Value> {
    /// In doubles, each the nearest or one beside it; `None` where a letter stands for a number.
    pub fn in_floats(&self) -> Option<Impact<f64>> {
        self.turned_into(Value::to_f64)
    }
}
