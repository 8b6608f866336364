//! Chains of equations, as far as the figures that are printed at their end.

use super::Show;
use crate::expr::{Expr, Relation, written_angle};
use crate::number::{Angle, Places, Value};

impl Show<'_> {
    /// Equations with one left side.
    pub fn chain(left: Expr, rights: impl IntoIterator<Item = Expr>) -> Vec<Expr> {
        let mut chain: Vec<Expr> = Vec::new();
        for right in rights {
            let equation = Expr::equation(left.clone(), right);
            if chain.last() != Some(&equation) {
                chain.push(equation);
            }
        }
        chain
    }

    /// A value with its rounded decimal where it is no short fraction.
    pub fn approximately(left: &Expr, value: &Value) -> Option<Expr> {
        if value.as_fraction().is_some() || !value.is_constant() {
            return None;
        }
        let rounded = value.rounded(&Places::SignificantFigures(3)).ok()?;
        let right = Box::new(Expr::Decimal(rounded.to_string()));
        Some(Expr::Relation(Box::new(left.clone()), Relation::Approximately, right))
    }

    /// The same for an angle.
    pub fn approximate_angle(left: &Expr, angle: &Angle) -> Option<Expr> {
        if angle.whole_degrees().is_some() || !angle.letters().iter().all(|letter| letter.is_constant()) {
            return None;
        }
        let rounded = angle.rounded(&Places::SignificantFigures(3)).ok()?;
        let right = Box::new(Expr::degrees(Expr::Decimal(rounded.to_string())));
        Some(Expr::Relation(Box::new(left.clone()), Relation::Approximately, right))
    }

    /// An angle as an expression.
    pub fn angle_expr(angle: &Angle) -> Expr {
        written_angle(angle)
    }
}
