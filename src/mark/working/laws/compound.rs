//! The tangent of two angles together, expanded: `(tan β - tan α)/(1 + tan α tan β)` for the difference of two directions, or
//! `(tan α + tan δ)/(1 - tan α tan δ)` for the direction after, where δ is the deflection that is sought.

use super::shapes::is_tangent;
use crate::expr::{Expr, Function};
use crate::mark::enclosure::about;
use crate::mark::working::evidence::Evidence;
use crate::mark::working::examine::{Working, context};
use crate::mark::working::numbers::{Context, Sum, any_within, comes_to, difference, sizes};
use crate::mechanics::{Law, Quantity};

/// The name that stands for the tangent that is sought, where an equation with it is tried.
const SOUGHT: &str = "tangent sought";

impl Working<'_> {
    /// A line with such a formula.
    pub(super) fn compound_angle(&self, law: Law) -> Option<Evidence> {
        let line = self.lines.iter().position(|studied| {
            let members = studied.reading.as_ref().map(|reading| reading.members.as_slice()).unwrap_or_default();
            members.iter().any(|member| any_within(&member.expr, &|inner| self.is_compound(inner)))
        })?;
        Some(Evidence::given(line, law.name()))
    }

    /// The first equation with the formula for the direction after that is right of the deflection that is sought.
    pub(super) fn compound_equation(&self, law: Law, quantities: &[Quantity]) -> Option<Evidence> {
        let mut tangents = quantities.iter().filter(|quantity| matches!(quantity, Quantity::TanDeflection(_)));
        let tangent = tangents.find_map(|quantity| sizes(&self.prepared.known, *quantity))?;
        let tried = |expr: &Expr| self.with_tangent_sought(expr);
        let holds = |(left, right): &(Expr, Expr)| {
            let names: Vec<_> = self.names.iter().cloned().chain([(SOUGHT.to_owned(), tangent.clone())]).collect();
            let [left, right] = [left, right].map(tried);
            (0..self.prepared.points.count).all(|point| {
                let context = Context { given: &names, ..context(self.prepared, point) };
                match difference(&left, &right, &context) {
                    Some(Sum::Number(linear)) => linear.is_number() && linear.constant.may_be_nought(linear.size),
                    _ => false,
                }
            })
        };
        let is_it = |equation: &&(Expr, Expr)| {
            let has_formula = |side: &Expr| any_within(side, &|inner| self.is_compound(inner));
            (has_formula(&equation.0) || has_formula(&equation.1)) && holds(equation)
        };
        let mut lines = self.lines.iter();
        let line = lines.position(|studied| {
            studied.reading.as_ref().is_some_and(|reading| reading.equations.iter().find(is_it).is_some())
        })?;
        Some(Evidence::given(line, law.name()))
    }

    fn with_tangent_sought(&self, expr: &Expr) -> Expr {
        match expr {
            Expr::Call(Function::Tan, angle) if self.is_sought_angle(angle) => Expr::name(SOUGHT),
            other => other.map_children(&mut |child| self.with_tangent_sought(child)),
        }
    }

    /// Is it the angle of which the tangent is asked for?
    fn is_sought_angle(&self, angle: &Expr) -> bool {
        let mut asked = self.part.blanks.iter().filter_map(|blank| blank.model.angle.as_deref());
        matches!(angle, Expr::Name(name) if asked.any(|own| own == name.text))
    }

    /// Is it such a formula, of tangents by their letters, or of two numbers of which one is called a tangent?
    fn is_compound(&self, expr: &Expr) -> bool {
        let Some([one, other]) = added(expr) else { return false };
        let is_difference = is_taken(one) != is_taken(other);
        match [one, other].map(angle_of) {
            [Some(one), Some(other)] => {
                one != other && (is_difference || [one, other].iter().any(|angle| self.is_sought_angle(angle)))
            }
            [Some(angle), None] | [None, Some(angle)] => self.is_sought_angle(angle) != is_difference,
            [None, None] => {
                let own = [one, other].map(|term| about(term, &[]));
                is_difference && own.iter().flatten().any(|tangent| self.is_own_tangent_of(tangent.abs()))
            }
        }
    }

    /// Does a line call a value of this size a tangent?
    fn is_own_tangent_of(&self, size: f64) -> bool {
        let mut all = self.lines.iter().flat_map(|studied| self.members(studied));
        all.any(|(member, values)| is_tangent(member) && values.iter().all(|value| comes_to(*value, size)))
    }
}

/// Has a formula tangents of two angles in it, whatever they are written as?
pub(super) fn has_two_tangents(expr: &Expr) -> bool {
    any_within(expr, &|inner| added(inner).is_some())
}

/// The two terms above the line of `(p + q)/(1 - pq)`, with their signs.
fn added(expr: &Expr) -> Option<[&Expr; 2]> {
    let Expr::Quotient(above, below) = expr else { return None };
    let (Expr::Sum(above), Expr::Sum(below)) = (&**above, &**below) else { return None };
    let ([one, other], [first, second]) = (above.as_slice(), below.as_slice()) else { return None };
    let product = match (*first == Expr::integer(1), *second == Expr::integer(1)) {
        (true, _) => second,
        (_, true) => first,
        _ => return None,
    };
    let [p, q, product] = [one, other, product].map(|term| about(&with_numbers(term), &[]));
    let (expected, product) = (-(p? * q?), product?);
    ((product - expected).abs() <= 0.005 * expected.abs()).then_some([one, other])
}

/// With a number in the place of every tangent of a letter, and of every other letter.
fn with_numbers(expr: &Expr) -> Expr {
    match expr {
        Expr::Call(Function::Tan, angle) if !angle.names().is_empty() => number_for(&format!("tan {angle:?}")),
        Expr::Name(name) => number_for(&name.text),
        other => other.map_children(&mut with_numbers),
    }
}

/// A number that is hardly that of another name.
fn number_for(name: &str) -> Expr {
    let spread = name.bytes().fold(7_u64, |sum, byte| (sum * 31 + u64::from(byte)) % 9973);
    Expr::Decimal(format!("0.{spread:04}"))
}

fn is_taken(term: &Expr) -> bool {
    matches!(term, Expr::Negative(_))
}

/// The angle of a tangent that is named by a letter.
fn angle_of(term: &Expr) -> Option<&Expr> {
    match term {
        Expr::Negative(inner) => angle_of(inner),
        Expr::Call(Function::Tan, angle) => Some(&**angle).filter(|angle| !angle.names().is_empty()),
        _ => None,
    }
}
