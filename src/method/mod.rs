//! Interchangeable ways to solve an impact, one file each, one list, and what each accepts.
//!
//! A derivation that checks itself proves nothing. The methods here share no code with the laws of
//! [`mechanics`](crate::mechanics); `tests/data/impacts.toml` runs over them and the derivation alike. To add a
//! method, write its file and add its line to [`METHODS`].

mod elimination;
mod reduced_mass;

use crate::number::{Interval, Value};

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

/// A way to solve an impact in one kind of number; `None` where a quotient does not exist, as for a line
/// of centres without a direction.
pub type Solve<N> = fn(&Impact<N>) -> Option<After<N>>;

/// A method, and the kinds of number in which it works.
#[derive(Clone, Copy, Debug)]
pub struct Method {
    /// Its name: `reduced-mass`.
    pub name: &'static str,
    /// What it accepts, for a reader who wonders why it was not chosen.
    pub accepts: &'static str,
    /// In exact values, letters too.
    pub exact: Option<Solve<Value>>,
    /// In certified intervals.
    pub certified: Option<Solve<Interval>>,
    /// In doubles.
    pub float: Option<Solve<f64>>,
}

/// Every method.
///
/// ```
/// use carom::method::{Impact, METHODS};
/// // Equal masses and e = 1 exchange their components along the line of centres.
/// let impact = Impact { masses: [1.0, 1.0], before: [[3.0, 4.0], [0.0, 0.0]], line: [2.0, 0.0], restitution: 1.0 };
/// for method in METHODS {
///     let after = method.float.and_then(|solve| solve(&impact)).unwrap();
///     assert_eq!(after, [[0.0, 4.0], [3.0, 0.0]], "{}", method.name);
/// }
/// ```
pub const METHODS: &[Method] = &[reduced_mass::METHOD, elimination::METHOD];
