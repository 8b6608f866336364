//! Velocities, momenta and the line of centres as vectors.

use super::Show;
use crate::expr::{Expr, written};
use crate::mechanics::formula::times;
use crate::mechanics::{Axis, Moment, Quantity, Sphere};
use crate::number::Value;

impl Show<'_> {
    /// The vector of a velocity.
    pub fn vector(&self, sphere: Sphere, moment: Moment) -> Expr {
        let at = |axis| Box::new(self.value(Quantity::Velocity(sphere, moment, axis)));
        Expr::Vector(at(Axis::X), at(Axis::Y))
    }

    /// `m v` as a vector, by the name of the velocity.
    pub fn named_momentum(&self, sphere: Sphere, moment: Moment) -> Expr {
        times(self.mass(sphere), Expr::name(self.vector_letter(sphere, moment)))
    }

    /// The name of an unknown velocity vector.
    pub fn vector_letter(&self, sphere: Sphere, moment: Moment) -> &'static str {
        match (moment, sphere == Sphere::A) {
            (Moment::Before, true) => "vector.u_A",
            (Moment::Before, false) => "vector.u_B",
            (Moment::After, true) => "vector.v_A",
            (Moment::After, false) => "vector.v_B",
        }
    }

    /// A vector along the line of centres with small whole components, where it has such.
    pub fn line_direction(&self) -> Expr {
        let (x, y) = (self.exact(Quantity::Line(Axis::X)), self.exact(Quantity::Line(Axis::Y)));
        let pair = |x: &Value, y: &Value| Expr::Vector(Box::new(written(x)), Box::new(written(y)));
        let Some(ratio) = y.divided_by(&x) else { return pair(&Value::ZERO, &Value::ONE) };
        match ratio.as_fraction() {
            Some(ratio) => {
                pair(&Value::Rational(ratio.denominator().into()), &Value::Rational(ratio.numerator().into()))
            }
            None => pair(&x, &y),
        }
    }

    /// The unit vector along the line of centres, from A to B.
    pub fn line_vector(&self) -> Expr {
        let at = |axis| Box::new(self.value(Quantity::Line(axis)));
        Expr::Vector(at(Axis::X), at(Axis::Y))
    }
}
