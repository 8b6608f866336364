//! Chains of equations, as far as the figures that are printed at their end.

use super::Show;
use crate::expr::{Expr, Relation, print, written, written_angle};
use crate::mechanics::{Axis, Line, Moment, Quantity, Sphere};
use crate::number::{Angle, Fraction, Letter, Places, Value};
use crate::unit::Unit;

/// The most signs of a value that stands as it is in a longer formula.
const LONG: usize = 16;

/// A fraction with a smaller denominator is as good as its decimal.
const SMALL: i64 = 10;

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

    /// Is it too long to stand in a longer formula, where a letter for it is at hand?
    pub fn is_long(expr: &Expr) -> bool {
        print::unicode(expr).chars().count() > LONG
    }

    /// `, in joules,`: the unit of a value in which no letter carries its own.
    pub fn in_units(&self, value: &Value, unit: &str) -> String {
        let is_given =
            |letter: &Letter| letter.is_constant() || self.with_units.iter().any(|name| name == letter.name());
        if value.has_letter(|letter| !is_given(letter)) { String::new() } else { format!(", in {unit},") }
    }

    /// A value with its rounded decimal where it is no short fraction.
    pub fn approximately(left: &Expr, value: &Value) -> Option<Expr> {
        if !value.is_constant() {
            return None;
        }
        let rounded = value.rounded(&Places::SignificantFigures(3)).ok()?;
        let is_short = |number: &Fraction| *number == rounded.to_fraction() || number.denominator() < SMALL.into();
        if value.as_fraction().is_some_and(is_short) {
            return None;
        }
        let right = Box::new(Expr::Decimal(rounded.to_string()));
        Some(Expr::Relation(Box::new(left.clone()), Relation::Approximately, right))
    }

    /// A value in a sentence, with its decimal where it has one: `8 cos 25°/3 ≈ 2.42`.
    pub fn stated(value: &Value) -> Expr {
        let exact = written(value);
        Show::approximately(&exact, value).unwrap_or(exact)
    }

    /// What is asked for and needs no equation of its own: `The momentum along i is 14 N s.`
    pub fn statement(&self, quantity: Quantity) -> Vec<Line> {
        if !self.is_asked(quantity) {
            return Vec::new();
        }
        let size = match self.angle(quantity) {
            Some(angle) => match (Show::angle_expr(&angle), Show::approximate_angle(&Expr::name("x"), &angle)) {
                (exact, Some(Expr::Relation(_, _, decimal))) if Show::is_long(&exact) => *decimal,
                (exact, _) => Show::approximate_angle(&exact, &angle).unwrap_or(exact),
            },
            None => Show::stated(&self.exact(quantity)),
        };
        let what = match quantity {
            Quantity::DeflectionCross(sphere) => {
                format!("vector product of the velocities of *{}* before and after", sphere.name())
            }
            Quantity::AngleFromI(sphere, moment) => {
                format!("angle from {{i}} to the velocity of *{}* {moment} the impact", sphere.name())
            }
            Quantity::AngleFromN(sphere, moment) => {
                format!("angle from the line of centres to the velocity of *{}* {moment} the impact", sphere.name())
            }
            Quantity::AngleBetween(moment) => format!("angle between the velocities {moment} the impact"),
            Quantity::Tangent(Axis::X) => "component along {i} of the unit vector along the common tangent".to_owned(),
            Quantity::Tangent(_) => "component along {j} of the unit vector along the common tangent".to_owned(),
            other => other.in_words(),
        };
        let unit = if quantity.unit() == Unit::NewtonSecond { " N s" } else { "" };
        vec![Line::with(&format!("The {what} is {{size{unit}}}."), &[("size", size)], vec![])]
    }

    /// The same of a velocity, along i and j.
    pub fn approximate_velocity(&self, left: &Expr, sphere: Sphere, moment: Moment) -> Option<Expr> {
        let values = [Axis::X, Axis::Y].map(|axis| self.exact(Quantity::Velocity(sphere, moment, axis)));
        let rounded = |value: &Value| match Show::approximately(left, value) {
            Some(Expr::Relation(_, _, decimal)) => (decimal, true),
            _ => (Box::new(written(value)), false),
        };
        let [(x, one), (y, other)] = [&values[0], &values[1]].map(rounded);
        let vector = Box::new(Expr::Vector(x, y));
        (one || other).then(|| Expr::Relation(Box::new(left.clone()), Relation::Approximately, vector))
    }

    /// Does it hold sines and cosines of given degrees, which nobody can picture?
    pub fn has_degrees(value: &Value) -> bool {
        value.has_letter(Letter::is_constant)
    }

    /// The same for an angle.
    pub fn approximate_angle(left: &Expr, angle: &Angle) -> Option<Expr> {
        if angle.whole_degrees().is_some() || !angle.is_constant() {
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
