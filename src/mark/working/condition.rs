//! Lines that use what is given of the motion after the impact.

use super::compare::{comes_to, is_composite};
use super::evidence::Evidence;
use super::examine::Working;
use super::points::sizes;
use crate::expr::{Expr, Relation};
use crate::mark::key::KeyedMark;
use crate::mark::reading::Form;
use crate::mechanics::{Axis, Known, Moment, Quantity, Sphere};

impl Working<'_> {
    /// A line that holds only because of what is given of the motion after the impact.
    pub(super) fn uses_condition(&self, mark: &KeyedMark) -> Option<Evidence> {
        if mark.code.is_accuracy() {
            return None;
        }
        let line = self.lines.iter().position(|studied| {
            let Some(reading) = &studied.reading else { return false };
            let statements = || reading.statements.iter().flat_map(|statement| &statement.said);
            let is_inequality = || statements().any(|said| self.is_demanded(&said.form, mark));
            let mut worked = reading.equations.iter().filter(|(_, right)| !self.is_printed_value(right));
            let mut holds = || worked.any(|equation| self.holds_only_where_found(equation));
            !self.is_printed_result(studied) && studied.matched.is_empty() && (holds() || is_inequality())
        })?;
        Some(Evidence::given(line, "uses what is given of the motion after the impact"))
    }

    fn holds_only_where_found(&self, (left, right): &(Expr, Expr)) -> bool {
        let mut held = 0;
        for point in 0..self.prepared.points.count {
            let Some(there) = self.prepared.where_found(point) else { continue };
            let at = |quantity| Some(vec![there.number(quantity)?; self.prepared.points.count]);
            let names = self.names(&at);
            let points = self.prepared.points.with(&self.prepared.found, point);
            let context = super::linear::Context {
                points: &points,
                given: &names,
                ..super::examine::context(self.prepared, point)
            };
            let Some(difference) = super::linear::difference(left, right, &context) else { return false };
            let super::linear::Sum::Number(linear) = difference else { return false };
            if !linear.is_number() || !linear.constant.may_be_nought(linear.size * 100.0) {
                return false;
            }
            held += 1;
        }
        // And not everywhere: an identity says nothing.
        held > 0 && !(0..self.prepared.points.count).all(|point| self.holds_at(left, right, point))
    }

    /// Is it the inequality of the scheme, or what that is for the student's own velocity, up to a positive factor? The
    /// letter alone on one side is what has been concluded from it.
    fn is_demanded(&self, form: &Form, mark: &KeyedMark) -> bool {
        let Form::Equation(Expr::Relation(left, relation, right)) = form else { return false };
        let is_sought = |expr: &Expr| {
            let is_one = |name: &str| self.question.scene.unknowns.iter().any(|letter| letter.name() == name);
            matches!(expr, Expr::Name(name) if is_one(&name.text))
        };
        if is_sought(left) || is_sought(right) || !self.is_of_stated(left) || !self.is_of_stated(right) {
            return false;
        }
        let Some(stated) = self.excess(left, *relation, right) else { return false };
        let of_scheme = || {
            let Some(Expr::Relation(left, relation, right)) = &mark.equation else { return None };
            self.excess(left, *relation, right)
        };
        let of_own = || {
            let mut conditions = self.question.scene.conditions.iter();
            let condition = conditions.next().filter(|condition| condition.is_inequality())?;
            let at = |expr: &Expr, known: &Known<f64>| match expr {
                Expr::Name(name) => known.number(name.text.parse::<Quantity>().ok()?),
                Expr::Number(number) => Some(number.to_f64()),
                _ => None,
            };
            let of = |known: &Known<f64>| {
                oriented(at(&condition.left, known)? - at(&condition.right, known)?, condition.relation)
            };
            self.followed.iter().map(of).collect::<Option<Vec<f64>>>()
        };
        let is = |demanded: Vec<f64>| self.is_positive_multiple(&stated, &demanded);
        of_scheme().is_some_and(is) || of_own().is_some_and(is)
    }

    /// The line of an inequality of which one side comes to this by a formula: `4f > 2` has the speed after a wall.
    pub(super) fn inequality_with(&self, right: &[f64]) -> Option<usize> {
        let is = |side: &Expr| {
            let values = self.values_of(side).filter(|_| is_composite(side));
            values.is_some_and(|values| values.iter().zip(right).all(|(value, right)| comes_to(*value, *right)))
        };
        let has = |form: &Form| match form {
            Form::Equation(Expr::Relation(left, relation, right)) => {
                oriented(0.0, *relation).is_some() && (is(left) || is(right))
            }
            _ => false,
        };
        self.lines.iter().position(|studied| {
            let statements = studied.reading.iter().flat_map(|reading| &reading.statements);
            statements.flat_map(|statement| &statement.said).any(|said| has(&said.form))
        })
    }

    /// Has every velocity in it been stated before, so that it says something of the letter that is sought?
    fn is_of_stated(&self, expr: &Expr) -> bool {
        let letters = self.convention.as_ref().map(|convention| convention.letters.as_slice()).unwrap_or_default();
        let is_stated = |name: &str| {
            let place = letters.iter().position(|letter| letter == name);
            let along = |place: usize| Quantity::Velocity(Sphere::BOTH[place], Moment::After, Axis::N);
            place.is_none_or(|place| self.theirs.0.contains_key(&along(place)))
        };
        expr.names().into_iter().all(|name| is_stated(&name.text))
    }

    /// By how much the side that is to be greater is, at every point.
    fn excess(&self, left: &Expr, relation: Relation, right: &Expr) -> Option<Vec<f64>> {
        let at = |point| match super::linear::difference(left, right, &self.context(point))? {
            super::linear::Sum::Number(linear) if linear.is_number() => oriented(linear.constant.middle(), relation),
            _ => None,
        };
        (0..self.prepared.points.count).map(at).collect()
    }

    /// Is one the other with a positive factor: a number, or with it the masses together or letters that were cancelled?
    fn is_positive_multiple(&self, stated: &[f64], demanded: &[f64]) -> bool {
        if demanded.iter().any(|demanded| demanded.abs() < 1e-9) {
            return false;
        }
        let quotients: Vec<f64> = stated.iter().zip(demanded).map(|(stated, demanded)| stated / demanded).collect();
        let masses = Sphere::BOTH.map(|sphere| sizes(&self.prepared.known, Quantity::Mass(sphere)));
        let together = match masses {
            [Some(a), Some(b)] => Some(a.iter().zip(b).map(|(a, b)| a + b).collect::<Vec<f64>>()),
            _ => None,
        };
        let is_sought = |name: &str| self.question.scene.unknowns.iter().any(|letter| letter.name() == name);
        let letters = self.question.letters.iter().filter(|letter| !is_sought(letter.name()));
        let mut factors = vec![vec![1.0; quotients.len()]];
        factors.extend(together);
        for letter in letters {
            let at = |point| self.prepared.points.letter(letter.name(), point).unwrap_or(1.0);
            let powers = factors.iter().flat_map(|factor| {
                [-1, 0, 1].map(|power| {
                    factor.iter().enumerate().map(|(point, one)| one * at(point).powi(power)).collect::<Vec<f64>>()
                })
            });
            factors = powers.collect();
        }
        factors.iter().any(|factor| {
            let mut each = quotients.iter().zip(factor).map(|(quotient, factor)| quotient / factor);
            let Some(first) = each.next().filter(|first| *first > 1e-9) else { return false };
            each.all(|other| (other - first).abs() < 1e-6 * first)
        })
    }

    fn holds_at(&self, left: &Expr, right: &Expr, point: usize) -> bool {
        let names = self.names(&|quantity| sizes(&self.prepared.known, quantity));
        let context = super::linear::Context { given: &names, ..super::examine::context(self.prepared, point) };
        match super::linear::difference(left, right, &context) {
            Some(super::linear::Sum::Number(linear)) => {
                linear.is_number() && linear.constant.may_be_nought(linear.size)
            }
            _ => false,
        }
    }
}

/// A difference as what is to be greater less what is to be smaller; `None` of an equation.
fn oriented(difference: f64, relation: Relation) -> Option<f64> {
    match relation {
        Relation::Greater | Relation::GreaterOrEqual => Some(difference),
        Relation::Less | Relation::LessOrEqual => Some(-difference),
        _ => None,
    }
}
