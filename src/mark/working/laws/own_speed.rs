//! The speed after the impact that is given, set equal to that of the student's own velocity.

use super::shapes::two_squares;
use crate::expr::{Expr, Function};
use crate::mark::working::examine::{Value, Working, value};
use crate::mark::working::prepared::Prepared;
use crate::mark::working::theirs::{is_of_velocity, numbers};
use crate::mechanics::{Moment, Quantity};

/// How far two sizes may be apart and still be one, in parts of themselves: figures are rounded.
const NEAR: f64 = 0.002;

/// A velocity that a line states, times what stands before its letter: `mv = (8 + m)i + (4 + 2m)j`.
pub(in crate::mark::working) struct Multiple<'l> {
    pub(in crate::mark::working) letter: &'l str,
    /// What stands before the letter, and what that is at every point.
    before: Expr,
    factor: Vec<f64>,
    /// The formula of the whole, and its components at every point.
    vector: &'l Expr,
    components: [Vec<f64>; 2],
}

impl Multiple<'_> {
    /// The velocity itself, where it is so much of a letter: each component at every point, and as it is written.
    pub(in crate::mark::working) fn divided(&self) -> Option<[(Vec<f64>, Expr); 2]> {
        let Expr::Vector(x, y) = self.vector else { return None };
        let is_one = self.before == Expr::product([]);
        let [i, j] = &self.components;
        let over = |sizes: &[f64], written: &Expr| {
            let sizes = sizes.iter().zip(&self.factor).map(|(size, factor)| size / factor).collect();
            (sizes, written.clone().over(self.before.clone()))
        };
        (!is_one).then(|| [over(i, x), over(j, y)])
    }
}

impl Working<'_> {
    /// `(3 + k)² + (1 + 2k)² = 50`, `(8 + m)² + (4 + 2m)² = 18m²`: is the speed that is given set equal to that of the student's own
    /// velocity, which a line before this one has, in the letter that is sought?
    pub(super) fn is_of_own_speed(&self, (left, right): &(Expr, Expr), place: usize) -> bool {
        let Some(given) = self.given_speed() else { return false };
        let sizes = |expr: &Expr| self.values_of(expr).and_then(|values| numbers(&values));
        if !self.has_sought(left) && !self.has_sought(right) {
            return false;
        }
        let Some((one, other)) = sizes(left).zip(sizes(right)) else { return false };
        // The number that is given may be copied wrongly, but is squared where the velocity is.
        let is_a_square =
            |expr: &Expr| matches!(expr, Expr::Number(_)) && !sizes(expr).is_some_and(|own| is(&own, &given));
        self.own_velocities(place).any(|own| {
            let whole: Vec<f64> = own.components[0].iter().zip(&own.components[1]).map(|(x, y)| x.hypot(*y)).collect();
            let divided: Vec<f64> = whole.iter().zip(&own.factor).map(|(whole, factor)| whole / factor).collect();
            let times: Vec<f64> = given.iter().zip(&own.factor).map(|(given, factor)| given * factor).collect();
            let squared = |sizes: &[f64]| sizes.iter().map(|size| size * size).collect::<Vec<f64>>();
            [(&whole, &times), (&divided, &given)].into_iter().any(|(own, given)| {
                let (own_square, square) = (squared(own), squared(given));
                is(&one, own) && is(&other, given)
                    || is(&other, own) && is(&one, given)
                    || is(&one, &own_square) && (is(&other, &square) || is_a_square(right))
                    || is(&other, &own_square) && (is(&one, &square) || is_a_square(left))
            })
        })
    }

    /// `x² + y² = 25`: is the speed that is given set on the student's own letters for the components of the velocity?
    pub(super) fn is_speed_by_letters(&self, (left, right): &(Expr, Expr), place: usize) -> bool {
        let is_letter = |expr: &Expr, letter: &str| matches!(expr, Expr::Name(name) if name.text == letter);
        let squares = |side: &Expr| match side {
            Expr::Call(Function::Sqrt, inner) => two_squares(inner).map(|two| (two, false)),
            side => two_squares(side).map(|two| (two, true)),
        };
        let is_set = |side: &Expr, other: &Expr| {
            let Some(((one, another), is_squared)) = squares(side) else { return false };
            let (Some(given), Some([x, y])) = (self.given_speed(), self.letters_of_components(place)) else {
                return false;
            };
            let are_both =
                is_letter(&one, &x) && is_letter(&another, &y) || is_letter(&one, &y) && is_letter(&another, &x);
            let size: Vec<f64> = given.iter().map(|given| if is_squared { given * given } else { *given }).collect();
            are_both && self.values_of(other).and_then(|values| numbers(&values)).is_some_and(|own| is(&own, &size))
        };
        is_set(left, right) || is_set(right, left)
    }

    /// The speed after the impact, where that is what is given.
    fn given_speed(&self) -> Option<Vec<f64>> {
        let condition = self.question.scene.conditions.first().filter(|condition| !condition.is_inequality())?;
        let Expr::Name(name) = &condition.left else { return None };
        let Ok(Quantity::Speed(_, Moment::After)) = name.text.parse() else { return None };
        numbers(&self.values_of(&condition.right)?)
    }

    /// The velocities that the lines before one state as vectors.
    fn own_velocities(&self, place: usize) -> impl Iterator<Item = Multiple<'_>> {
        let readings = self.lines[..place].iter().filter_map(|studied| studied.reading.as_ref());
        readings.flat_map(|reading| &reading.equations).filter_map(|equation| multiple(equation, self.prepared))
    }
}

/// The velocity that an equation states as a vector, with its letter on one side.
pub(in crate::mark::working) fn multiple<'l>(
    (left, right): &'l (Expr, Expr),
    prepared: &Prepared,
) -> Option<Multiple<'l>> {
    let of = |called: &'l Expr, vector: &'l Expr| {
        let (letter, before) = letter_of(called)?;
        let values = value(vector, prepared, &prepared.names)?;
        let component = |of: fn(&Value) -> Option<f64>| values.iter().map(of).collect::<Option<Vec<f64>>>();
        let x = component(|value| match value {
            Value::Vector(x, _) => Some(x.middle()),
            Value::Number(_) => None,
        })?;
        let y = component(|value| match value {
            Value::Vector(_, y) => Some(y.middle()),
            Value::Number(_) => None,
        })?;
        let factor = prepared.sizes_of(&before)?;
        Some(Multiple { letter, before, factor, vector, components: [x, y] })
    };
    of(left, right).or_else(|| of(right, left))
}

/// The letter of a velocity, and what stands before it.
fn letter_of(called: &Expr) -> Option<(&str, Expr)> {
    let velocity = |expr: &Expr| matches!(expr, Expr::Name(name) if is_of_velocity(&name.text));
    let factors = match called {
        Expr::Product(factors) => factors.as_slice(),
        one => std::slice::from_ref(one),
    };
    let at = factors.iter().position(velocity)?;
    let Expr::Name(name) = &factors[at] else { return None };
    let others = factors.iter().enumerate().filter(|(place, _)| *place != at).map(|(_, factor)| factor.clone());
    Some((&name.text, Expr::product(others)))
}

/// Are they the same at every point, but for their figures?
fn is(one: &[f64], other: &[f64]) -> bool {
    one.iter().zip(other).all(|(one, other)| (one.abs() - other.abs()).abs() <= NEAR * other.abs())
}
