//! The words in which a condition is stated and what was found from it is told.

use super::Line;
use super::later;
use super::refusal::Refusal;
use super::scene::Condition;
use super::working::Show;
use super::{Axis, Moment, Quantity, Setting, Sphere};
use crate::expr::{Expr, Relation, written, written_angle};
use crate::number::{Angle, Letter, NoRoots, Range, Value};

/// The condition as a teacher says it.
pub(super) fn condition_line(condition: &Condition) -> Line {
    let quantity_of = |expr: &Expr| match expr {
        Expr::Name(name) => name.text.parse::<Quantity>().ok(),
        _ => None,
    };
    let (quantity, other) = (quantity_of(&condition.left), quantity_of(&condition.right));
    match quantity {
        Some(Quantity::DeflectionDot(sphere)) if condition.right.is_zero() => Line::with(
            "The path of {A} turns through a right angle, so the scalar product of its velocities before and after is nought.",
            &[("A", Expr::name(sphere.name()))],
            vec![],
        ),
        Some(Quantity::Deflection(sphere)) if condition.right.names().is_empty() => Line::with(
            "It is given that {A} is deflected through {r} degrees.",
            &[("A", Expr::name(sphere.name())), ("r", condition.right.clone())],
            vec![],
        ),
        Some(quantity) if other.is_some() => {
            let other = other.map_or_else(String::new, in_english);
            Line::plain(&format!("It is given that {} is equal to {other}.", in_english(quantity)), vec![])
        }
        Some(quantity) => Line::with(
            &format!("It is given that {} is {{r}}.", in_english(quantity)),
            &[("r", in_symbols(&condition.right))],
            vec![],
        ),
        None => Line::with(
            "It is given that {l}.",
            &[("l", Expr::equation(in_symbols(&condition.left), in_symbols(&condition.right)))],
            vec![],
        ),
    }
}

/// Names of quantities as symbols, for a formula in a sentence.
fn in_symbols(expr: &Expr) -> Expr {
    expr.substitute(&|name| {
        let quantity: Quantity = name.parse().ok()?;
        Some(Expr::name(match quantity {
            Quantity::Speed(Sphere::A, Moment::After) => "v_A",
            Quantity::Speed(Sphere::B, Moment::After) => "v_B",
            Quantity::Speed(Sphere::A, Moment::Before) => "u_A",
            Quantity::Speed(Sphere::B, Moment::Before) => "u_B",
            Quantity::Mass(Sphere::A) => "m_A",
            Quantity::Mass(Sphere::B) => "m_B",
            _ => return None,
        }))
    })
}

/// A quantity in words, as a sentence names it.
pub(super) fn in_english(quantity: Quantity) -> String {
    use Quantity::*;
    let when = |moment| if moment == Moment::Before { "before" } else { "after" };
    match quantity {
        Speed(s, m) => format!("the speed of *{}* {} the impact", s.name(), when(m)),
        AngleToLine(s, m) => format!("the angle of *{}* to the line of centres {} the impact", s.name(), when(m)),
        AngleToWall(s, m) => {
            format!("the angle in degrees of the path of *{}* with the wall {} the impact", s.name(), when(m))
        }
        TanToWall(s, m) => {
            format!("the tangent of the angle of the path of *{}* with the wall {} the impact", s.name(), when(m))
        }
        Deflection(s) | SignedDeflection(s) => {
            format!("the angle in degrees through which *{}* is deflected", s.name())
        }
        TanDeflection(s) => format!("the tangent of the deflection of *{}*", s.name()),
        EnergyLost => "the kinetic energy lost".to_string(),
        FractionLost => "the fraction of the kinetic energy lost".to_string(),
        ImpulseMagnitude => "the magnitude of the impulse".to_string(),
        Velocity(s, m, Axis::N) => {
            format!("the component of *{}* along the line of centres {} the impact", s.name(), when(m))
        }
        // As the second impact calls it.
        Later(quantity) => later::numbered(quantity.number(), &in_english(quantity.quantity())),
        other => other.to_string().replace('_', " "),
    }
}

/// `tan² θ = (2e - 1)/3` where the unknown is a root, then the unknown itself.
pub(super) fn found_line(letter: Letter, value: &Value) -> Line {
    use crate::expr::Function;
    let name = Expr::name(letter.name().replace("A.mass", "m_A").replace("B.mass", "m_B"));
    let acute = letter.range() == Range::Acute;
    let base = if acute { Expr::call(Function::Tan, name.clone()) } else { name.clone() };
    let mut equations = Vec::new();
    let square = value * value;
    if value.as_fraction().is_none() && square.roots().is_empty() {
        equations.push(Expr::equation(base.clone().to_the(2), written(&square)));
    }
    if acute && value.is_constant() {
        equations.push(Expr::equation(base, written(value)));
        if let Some(angle) = Angle::of(value, &Value::ONE) {
            equations.push(Expr::equation(name.clone(), written_angle(&angle)));
            equations.extend(Show::approximate_angle(&name, &angle));
        }
    } else if !acute || equations.is_empty() {
        equations.push(Expr::equation(base, written(value)));
    }
    Line::plain("Solving for the unknown:", equations)
}

/// What must be so for something to happen, and the same in the unknown.
pub(super) fn inequality_words(condition: &Condition, inequality: Expr, setting: Setting) -> Line {
    let quantity_of = |expr: &Expr| match expr {
        Expr::Name(name) => name.text.parse::<Quantity>().ok(),
        _ => None,
    };
    let to_nought = condition.right.is_zero();
    let must = match condition.relation {
        Relation::Less if to_nought => "must be negative",
        Relation::Greater if to_nought => "must be positive",
        Relation::Less => "must be less than",
        Relation::LessOrEqual => "must be at most",
        Relation::Greater => "must be more than",
        _ => "must be at least",
    };
    let formulas = [("r", in_symbols(&condition.right)), ("l", in_symbols(&condition.left))];
    let named = |quantity| match (setting, quantity) {
        (Setting::Direct, Quantity::Velocity(sphere, moment, Axis::X | Axis::N)) => {
            format!("the velocity of *{}* {moment} the impact", sphere.name())
        }
        (_, Quantity::Velocity(sphere, moment, axis @ (Axis::X | Axis::Y))) => {
            let along = if axis == Axis::X { "{i}" } else { "{j}" };
            format!("the component of the velocity of *{}* along {along} {moment} the impact", sphere.name())
        }
        (_, Quantity::Restitution) => "the coefficient of restitution".to_owned(),
        (_, other) => in_english(other),
    };
    let subject = quantity_of(&condition.left).map_or_else(|| "{l}".to_owned(), named);
    let other = quantity_of(&condition.right).map_or_else(|| "{r}".to_owned(), named);
    let short = to_nought && matches!(condition.relation, Relation::Less | Relation::Greater);
    let words =
        if short { format!("For this {subject} {must}:") } else { format!("For this {subject} {must} {other}:") };
    Line::with(&words, &formulas, vec![inequality]).said_of(setting)
}

/// Why a system was not solved, in words.
pub(super) fn no_roots(reason: NoRoots) -> Refusal {
    match reason {
        NoRoots::Always => Refusal::underdetermined("the conditions hold whatever the unknowns are"),
        NoRoots::Never => Refusal::impossible("the conditions contradict each other"),
        NoRoots::Degree(degree) => Refusal::beyond(format!(
            "the conditions lead to an equation of degree {degree}; only linear and quadratic ones, in an unknown or its square, are solved"
        )),
        NoRoots::TooLong => Refusal::beyond("the conditions lead to formulas too long to be solved exactly"),
    }
}
