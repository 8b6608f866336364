//! From two components along the line of centres to two velocities, in floats.
//!
//! A formula for two spheres on one line becomes a formula for any line of centres: each velocity is resolved along and
//! across the line, what is across stays, and both are put together again. Along an axis the components are there
//! already. Otherwise all is done with the vector as it is given, so that no root is taken: with `w = u·l` and
//! `c = l×u` the velocity is `(w l + c l⊥)/(l·l)`.

use crate::method::{After, Impact};

/// Both velocities after, by a formula for what is along the line of centres: from the masses, both components before
/// and e to both components after.
#[inline(always)]
pub(super) fn along(impact: &Impact<f64>, on_line: impl Fn([f64; 2], [f64; 2], f64) -> [f64; 2]) -> After<f64> {
    let [a, b] = impact.before;
    let [x, y] = impact.line;
    if y == 0.0 {
        let [v_a, v_b] = on_line(impact.masses, [a[0], b[0]], impact.restitution);
        return [[v_a, a[1]], [v_b, b[1]]];
    }
    if x == 0.0 {
        let [v_a, v_b] = on_line(impact.masses, [a[1], b[1]], impact.restitution);
        return [[a[0], v_a], [b[0], v_b]];
    }
    let dot = |u: [f64; 2]| u[0] * x + u[1] * y;
    let cross = |u: [f64; 2]| u[1] * x - u[0] * y;
    let [w_a, w_b] = on_line(impact.masses, [dot(a), dot(b)], impact.restitution);
    let square = x * x + y * y;
    let whole = |w: f64, c: f64| [(w * x - c * y) / square, (w * y + c * x) / square];
    [whole(w_a, cross(a)), whole(w_b, cross(b))]
}
