//! The equations of momentum and restitution for the two components after, as simple as they come.

use std::cmp::Ordering;

use super::Show;
use crate::expr::{Expr, print, written};
use crate::mechanics::formula::multiple;
use crate::mechanics::{Axis, Moment, Quantity, Sphere};
use crate::number::{Fraction, Value};

impl Show<'_> {
    /// The two equations along the line of centres in the working's own direction, as `p v + q w = r` with
    /// p and q as simple as they come.
    pub fn equation(&self, which: Quantity) -> Option<[Value; 3]> {
        let [p, q, r] = self.known.equation(which)?;
        let r = if self.against_n { -r } else { r };
        let scaled = match p.divided_by(&q)?.as_fraction() {
            // With masses in a rational ratio: coprime whole numbers.
            Some(ratio) => [ratio.numerator(), ratio.denominator()].map(|whole| Value::Rational(Fraction::from(whole))),
            None => return Some(without_common_letters([p, q, r])),
        };
        let scale = scaled[1].divided_by(&q)?;
        let turned = if scaled[1].sign() == Some(Ordering::Less) { Value::from(-1) } else { Value::ONE };
        let [p, q] = scaled.map(|coefficient| &coefficient * &turned);
        Some([p, q, &(&r * &scale) * &turned])
    }

    /// An equation as a student first writes it, and then simplified if that changes anything.
    pub fn with_simplified(&self, equation: Expr, which: Quantity) -> Vec<Expr> {
        let Some(coefficients) = self.equation(which) else { return vec![equation] };
        let simple = self.linear(&coefficients);
        let turned = match &equation {
            Expr::Relation(left, relation, right) => Expr::Relation(right.clone(), *relation, left.clone()),
            other => other.clone(),
        };
        let is_simple = |written: &Expr| print::plain(written) == print::plain(&simple);
        if is_simple(&equation) {
            vec![equation]
        } else if is_simple(&turned) {
            vec![simple]
        } else {
            vec![equation, simple]
        }
    }

    /// `p v + q w = r`, written.
    fn linear(&self, [p, q, r]: &[Value; 3]) -> Expr {
        let letter = |sphere| self.symbol(Quantity::Velocity(sphere, Moment::After, Axis::N));
        let (v, w) = (multiple(p, letter(Sphere::A)), multiple(q, letter(Sphere::B)));
        let negative_first = p.sign() == Some(Ordering::Less);
        let left = if negative_first { Expr::sum([w, v]) } else { Expr::sum([v, w]) };
        Expr::equation(left, written(r))
    }
}

/// With masses km and m every term has an m, which a student divides out before going on.
fn without_common_letters(mut equation: [Value; 3]) -> [Value; 3] {
    for letter in equation[0].letters().into_iter().filter(|letter| !letter.is_constant()) {
        let divided = |value: &Value| value.divided_by(&Value::letter(letter)).filter(|it| it.denominator().is_one());
        while let [Some(p), Some(q), Some(r)] = equation.each_ref().map(divided) {
            equation = [p, q, r];
        }
    }
    equation
}
