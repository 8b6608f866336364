//! The velocity after a wall that lies along a vector, by two equations in its unknown components: `3x + 4y = 30` of what the
//! wall leaves as it is, and `4x − 3y = 17.5` of what *e* makes of the rest.

use crate::bank::Code;
use crate::expr::Expr;
use crate::mark::working::equations::differences;
use crate::mark::working::examine::Working;
use crate::mark::working::numbers::{Spread, sizes};
use crate::mechanics::{Axis, Moment, Quantity, Setting, Sphere};

impl Working<'_> {
    /// The line of the equation for the component along the wall, or for that across it. A method mark condones the sign of
    /// what it comes to.
    pub(super) fn by_unknown_components(&self, axis: Axis, code: Code) -> Option<usize> {
        let line = |axis| sizes(&self.prepared.known, Quantity::Line(axis));
        let (x, y) = line(Axis::X).zip(line(Axis::Y)).filter(|_| self.prepared.setting == Setting::Wall)?;
        let after = sizes(&self.prepared.known, Quantity::Velocity(Sphere::A, Moment::After, axis))?;
        let (x, y) = if axis == Axis::N { (x[0], y[0]) } else { (-y[0], x[0]) };
        // Along i or j one of the two is there by itself.
        if x.abs() < 1e-9 || y.abs() < 1e-9 {
            return None;
        }
        let signs: &[f64] = if code.is_accuracy() { &[1.0] } else { &[1.0, -1.0] };
        let is_it = |equation: &(Expr, Expr)| {
            let Some(all) = differences(equation, self.prepared) else { return false };
            let [all] = all.as_slice() else { return false };
            let mut unknowns: Vec<&(String, Spread)> = all.unknowns.iter().collect();
            unknowns.sort_by_key(|(name, _)| name);
            let [(_, first), (_, second)] = unknowns.as_slice() else { return false };
            // It may be that of one length, or of another multiple.
            let scale = first.middle() / x;
            let is_along = (second.middle() - scale * y).abs() < 1e-6 * scale.abs();
            is_along && signs.iter().any(|sign| all.constant.may_be(-scale * sign * after[0]))
        };
        let mut readings = self.lines.iter().map(|studied| studied.reading.as_ref());
        readings.position(|reading| reading.is_some_and(|reading| reading.equations.iter().any(is_it)))
    }
}
