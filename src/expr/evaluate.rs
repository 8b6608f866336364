//! The exact value of an expression.

use std::cmp::Ordering;

use super::nearly::nearly;
use super::{Expr, Fault, Function, Name, Relation, Span, Turn, beside_an_angle};
use crate::number::{Angle, Fraction, Interval, Letter, Value};

/// What an expression stands for.
#[derive(Clone, Debug, PartialEq)]
pub enum Meaning {
    /// A number, perhaps with letters.
    Number(Value),
    /// A vector by its components along i and j.
    Vector(Value, Value),
    /// An angle (in radians, as `atan(7)` or `30 deg` or `pi/6` is).
    Angle(Turn),
    /// A number of degrees: an angle over `deg`.
    Degrees(Turn),
    /// So many times one over pi, as in `180/pi*atan(7)`.
    OverPi(Fraction),
}

use Meaning::{Degrees, Number, OverPi, Vector};

/// What the names in an expression stand for.
pub type Names<'a> = &'a dyn Fn(&str) -> Option<Meaning>;

/// Formulas longer than this are refused: nobody writes them, and their roots would take for ever.
const MOST_TERMS: usize = 400;

/// Longer numbers than this, in bits, are refused: squared again and again, one would take for ever.
const LONGEST_NUMBER: usize = 1 << 14;

/// The largest whole power; higher ones only serve to stall a program.
const MOST_POWER: i64 = 16;

/// The meaning of an expression whose names mean what `names` says.
///
/// # Errors
///
/// An unknown name, a division by nought, a root of a negative number, the sine of a plain number:
/// each a [`Fault`] whose span is that of the name concerned, or empty for the whole expression.
pub fn evaluate(expr: &Expr, names: Names) -> Result<Meaning, Fault> {
    match expr {
        Expr::Number(value) => Ok(Number(Value::Rational(value.clone()))),
        Expr::Decimal(text) => match text.parse::<Fraction>() {
            Ok(value) => Ok(Number(value.into())),
            Err(_) => Err(fault(format!("`{text}` is no number"), "a decimal")),
        },
        Expr::Name(name) => named(name, names),
        Expr::Pi => Ok(Meaning::Angle(Turn::degrees(Fraction::from(180)))),
        Expr::Degrees(inner) => match evaluate(inner, names)? {
            Number(value) => match value.as_fraction() {
                Some(degrees) => Ok(Meaning::Angle(Turn::degrees(degrees.clone()))),
                None => Err(fault("an angle in degrees is not a fraction", "a rational number of degrees")),
            },
            Degrees(turn) | Meaning::Angle(turn) => Ok(Meaning::Angle(turn)),
            _ => Err(fault("a vector is no angle", "a number of degrees")),
        },
        Expr::Negative(inner) => match evaluate(inner, names)? {
            Number(value) => Ok(Number(-value)),
            Vector(x, y) => Ok(Vector(-x, -y)),
            Meaning::Angle(turn) => Ok(Meaning::Angle(turn.reversed())),
            Degrees(turn) => Ok(Degrees(turn.reversed())),
            OverPi(value) => Ok(OverPi(-value)),
        },
        Expr::Sum(terms) => {
            let mut sum: Option<Meaning> = None;
            for term in terms {
                let next = evaluate(term, names)?;
                sum = Some(match sum {
                    None => next,
                    Some(sum) => add(sum, next)?,
                });
            }
            Ok(sum.unwrap_or(Number(Value::ZERO)))
        }
        Expr::Product(factors) => {
            let mut product = Number(Value::ONE);
            for factor in factors {
                product = multiply(product, evaluate(factor, names)?)?;
            }
            Ok(product)
        }
        Expr::Quotient(above, below) => divide(evaluate(above, names)?, evaluate(below, names)?),
        Expr::Power(base, exponent) => power(evaluate(base, names)?, evaluate(exponent, names)?),
        Expr::Call(function, argument) => call(*function, evaluate(argument, names)?),
        Expr::Vector(x, y) => Ok(Vector(number(x, names)?, number(y, names)?)),
        Expr::Relation(..) => Err(fault("an equation has no value", "an expression without `=` or `<`")
            .try_this("write one of its sides alone")),
    }
}

/// The number that an expression stands for.
pub fn number(expr: &Expr, names: Names) -> Result<Value, Fault> {
    match evaluate(expr, names)? {
        Number(value) => Ok(value),
        Vector(..) => Err(fault("a vector stands where a number is expected", "a number")
            .try_this("write one of its components, without `i` and `j`")),
        Meaning::Angle(_) => Err(fault("an angle stands where a number is expected", "a number")
            .try_this("divide it by `deg` for the number of degrees")),
        Degrees(_) => Err(fault("a number of degrees without a rational value", "a number")),
        OverPi(_) => Err(fault("one over pi is of no use here", "a number").try_this("leave the sign of degrees out")),
    }
}

/// The angle that an expression stands for where a number of degrees is expected: `30`,
/// `atan(3/4)/deg`, or a letter that was declared `acute`.
pub fn degrees(expr: &Expr, names: Names) -> Result<Turn, Fault> {
    match evaluate(expr, names).or_else(|fault| beside_an_angle(expr, names).ok_or(fault))? {
        Number(value) => match value.as_fraction() {
            Some(degrees) => Ok(Turn::degrees(degrees.clone())),
            None => Err(fault("an angle in degrees is neither a fraction nor an acute letter", "a number of degrees")
                .try_this("declare the letter as `acute`, or give `cos` and `sin` instead")),
        },
        Degrees(turn) | Meaning::Angle(turn) => Ok(turn),
        OverPi(_) => Err(over_an_angle()),
        _ => Err(fault("a vector stands where an angle is expected", "a number of degrees")),
    }
}

/// Does a relation hold, exactly? `None` if that depends on letters.
pub fn holds(relation: &Expr, names: Names) -> Result<Option<bool>, Fault> {
    let Expr::Relation(left, relation, right) = relation else {
        return Err(fault("this is no relation", "`=`, `!=`, `<`, `<=`, `>` or `>=` between two expressions"));
    };
    let order = match order_by_doubles(left, right, names) {
        Some(order) => Compared::Order(order),
        None => compare(evaluate(left, names)?, evaluate(right, names)?)?,
    };
    Ok(match (relation, order) {
        (Relation::Equal, Compared::Order(order)) => Some(order.is_eq()),
        (Relation::NotEqual, Compared::Order(order)) => Some(order.is_ne()),
        (Relation::Equal, Compared::Different) => Some(false),
        (Relation::NotEqual, Compared::Different) => Some(true),
        (Relation::Less, Compared::Order(order)) => Some(order.is_lt()),
        (Relation::LessOrEqual, Compared::Order(order)) => Some(order.is_le()),
        (Relation::Greater, Compared::Order(order)) => Some(order.is_gt()),
        (Relation::GreaterOrEqual, Compared::Order(order)) => Some(order.is_ge()),
        _ => None,
    })
}

/// Which of two numbers is larger, where doubles tell: a difference of roots is long in exact form.
fn order_by_doubles(left: &Expr, right: &Expr, names: Names) -> Option<Ordering> {
    (nearly(left, names)? - nearly(right, names)?).sign().filter(|order| order.is_ne())
}

enum Compared {
    Order(Ordering),
    /// Not equal; which is larger depends on letters, or has no meaning.
    Different,
    /// Whether they are equal depends on letters, as far as can be seen.
    Unknown,
}

fn compare(left: Meaning, right: Meaning) -> Result<Compared, Fault> {
    let angle = |meaning: &Meaning| match meaning {
        Number(value) => value.as_fraction().map(|degrees| Turn::degrees(degrees.clone())),
        Degrees(turn) | Meaning::Angle(turn) => Some(turn.clone()),
        _ => None,
    };
    match (&left, &right) {
        (Number(a), Number(b)) => {
            let difference = a - b;
            if difference.is_zero() {
                return Ok(Compared::Order(Ordering::Equal));
            }
            Ok(difference.sign().map_or(Compared::Different, Compared::Order))
        }
        (Vector(a, b), Vector(c, d)) => {
            let equal = a.equals(c) && b.equals(d);
            Ok(if equal { Compared::Order(Ordering::Equal) } else { Compared::Different })
        }
        _ => {
            let both = angle(&left).zip(angle(&right));
            let (a, b) = both.ok_or_else(|| fault("a vector is compared with a number", "two of one kind"))?;
            let gap = a.plus(&b.reversed()).ok_or_else(too_fine)?;
            match gap.is_surely_degrees(&Fraction::ZERO) {
                Some(true) => return Ok(Compared::Order(Ordering::Equal)),
                Some(false) => {}
                None => return Ok(Compared::Unknown),
            }
            for bits in [64, 256, 1024] {
                let sign = gap.enclose(bits).as_ref().and_then(Interval::sign);
                if let Some(order) = sign.filter(|order| order.is_ne()) {
                    return Ok(Compared::Order(order));
                }
            }
            Ok(Compared::Different)
        }
    }
}

fn named(name: &Name, names: Names) -> Result<Meaning, Fault> {
    match (names(&name.text), name.text.as_str()) {
        (Some(meaning), _) => Ok(meaning),
        (None, "i") => Ok(Vector(Value::ONE, Value::ZERO)),
        (None, "j") => Ok(Vector(Value::ZERO, Value::ONE)),
        _ => Err(Fault::new(format!("unknown name `{}`", name.text), name.span, "not known here")),
    }
}

fn add(left: Meaning, right: Meaning) -> Result<Meaning, Fault> {
    let turns = |a: Turn, b: Turn| a.plus(&b).ok_or_else(too_fine);
    let plain = |value: &Value| value.as_fraction().cloned().map(Turn::degrees);
    match (left, right) {
        (Number(a), Number(b)) => sized(&a + &b),
        (Vector(a, b), Vector(c, d)) => Ok(Vector(&a + &c, &b + &d)),
        (Meaning::Angle(a), Meaning::Angle(b)) => Ok(Meaning::Angle(turns(a, b)?)),
        (Degrees(a), Degrees(b)) => Ok(Degrees(turns(a, b)?)),
        (Number(a), Degrees(b)) | (Degrees(b), Number(a)) => match plain(&a) {
            Some(a) => Ok(Degrees(turns(a, b)?)),
            None => Err(fault("a number of degrees and a number with letters are added", "a rational number")),
        },
        (Vector(..), Number(_)) | (Number(_), Vector(..)) => {
            Err(fault("a number is added to a vector", "both vectors or both numbers")
                .try_this("write the vector's other component with `i` or `j`"))
        }
        _ => Err(fault("an angle is added to something else", "two angles or two numbers")
            .try_this("write degrees with their unit, as in `180 deg - alpha`")),
    }
}

fn multiply(left: Meaning, right: Meaning) -> Result<Meaning, Fault> {
    let scaled = |factor: &Value, turn: &Turn| {
        let number =
            factor.as_fraction().ok_or_else(|| fault("an angle is multiplied by a letter", "a whole number"))?;
        turn.times(number).ok_or_else(part_of_an_angle)
    };
    match (left, right) {
        (Number(a), Number(b)) => sized(&a * &b),
        (Number(a), Vector(x, y)) | (Vector(x, y), Number(a)) => Ok(Vector(&a * &x, &a * &y)),
        (Number(a), Meaning::Angle(turn)) | (Meaning::Angle(turn), Number(a)) => Ok(Meaning::Angle(scaled(&a, &turn)?)),
        (Number(a), Degrees(turn)) | (Degrees(turn), Number(a)) => Ok(Degrees(scaled(&a, &turn)?)),
        (Number(a), OverPi(b)) | (OverPi(b), Number(a)) if a.as_fraction().is_some() => {
            Ok(OverPi(a.as_fraction().map_or(b.clone(), |a| a * &b)))
        }
        (OverPi(factor), Meaning::Angle(turn)) | (Meaning::Angle(turn), OverPi(factor)) => {
            let share = &factor / &Fraction::from(180);
            Ok(Degrees(turn.times(&share).ok_or_else(part_of_an_angle)?))
        }
        (Vector(..), Vector(..)) => Err(fault("two vectors are multiplied", "a number times a vector")),
        _ => Err(fault("an angle is multiplied by something else", "a number times an angle")),
    }
}

/// `7/3 deg` is seven over three degrees.
fn over_an_angle() -> Fault {
    fault("a number over an angle stands where an angle is expected", "an angle")
        .try_this("degrees belong to the number straight before them: put brackets round a fraction, as in `(7/3) deg`")
}

fn divide(above: Meaning, below: Meaning) -> Result<Meaning, Fault> {
    let nought = || fault("division by nought", "a denominator that is not nought");
    match (above, below) {
        (Number(a), Number(b)) => sized(a.divided_by(&b).ok_or_else(nought)?),
        (Vector(x, y), Number(b)) => {
            Ok(Vector(x.divided_by(&b).ok_or_else(nought)?, y.divided_by(&b).ok_or_else(nought)?))
        }
        (meaning @ (Meaning::Angle(_) | Degrees(_) | OverPi(_)), Number(b)) => {
            multiply(Number(b.reciprocal().ok_or_else(nought)?), meaning)
        }
        (Meaning::Angle(a), Meaning::Angle(b)) => match (&b.rest, b.degrees.reciprocal()) {
            (None, Some(_)) if b.degrees.is_one() => Ok(Degrees(a)),
            (None, Some(inverse)) if a.rest.is_none() => Ok(Number(Value::Rational(&a.degrees * &inverse))),
            _ => Err(fault("an angle is divided by an angle", "a division by `deg`")),
        },
        (Number(a), Meaning::Angle(b)) if b.rest.is_none() => match (a.as_fraction(), b.degrees.reciprocal()) {
            // The angle is so many times pi.
            (Some(a), Some(inverse)) => Ok(OverPi(&(a * &Fraction::from(180)) * &inverse)),
            _ => Err(nought()),
        },
        _ => Err(fault("this cannot be divided by an angle or a vector", "a number below")),
    }
}

fn power(base: Meaning, exponent: Meaning) -> Result<Meaning, Fault> {
    let (Number(base), Number(exponent)) = (base, exponent) else {
        return Err(fault("a power of an angle or a vector", "a power of a number"));
    };
    let exponent = exponent.as_fraction().and_then(Fraction::as_small);
    let (base, whole) = match exponent {
        Some((whole, 1)) => (base, whole),
        Some((whole, 2)) => (base.square_root().ok_or_else(negative_root)?, whole),
        _ => {
            return Err(fault("an exponent is no whole or half number", "a whole exponent such as `2`")
                .try_this("write what the power comes to as a decimal"));
        }
    };
    if whole.abs() > MOST_POWER {
        let (message, label) = match whole < 0 {
            true => (format!("the exponent {whole} is too low"), format!("at least -{MOST_POWER}")),
            false => (format!("the exponent {whole} is too high"), format!("at most {MOST_POWER}")),
        };
        return Err(fault(message, label).try_this("write the digits, or take another unit for the numbers"));
    }
    let mut result = Value::ONE;
    for _ in 0..whole.abs() {
        result = &result * &base;
        check_size(&result)?;
    }
    if whole >= 0 {
        return Ok(Number(result));
    }
    Ok(Number(result.reciprocal().ok_or_else(|| fault("division by nought", "a base that is not nought"))?))
}

fn call(function: Function, argument: Meaning) -> Result<Meaning, Fault> {
    let argument = match (function, argument) {
        (Function::Sin | Function::Cos | Function::Tan, argument) => return trigonometric(function, argument),
        (_, Number(value)) => value,
        (function, _) => {
            let name = function.name();
            return Err(fault(format!("`{name}` of an angle or a vector"), "one number in the brackets").try_this(
                format!("write one number in the brackets, with a point if it is a decimal: `{name}(2.5)`"),
            ));
        }
    };
    let beyond = || fault(format!("`{}` of a number beyond 1", function.name()), "a number from -1 to 1");
    let angle = |y: &Value, x: &Value| Angle::of(y, x).map(|angle| Meaning::Angle(Turn::of(angle)));
    match function {
        Function::Sqrt => sized(argument.square_root().ok_or_else(negative_root)?),
        Function::Abs => Ok(Number(argument.absolute())),
        Function::Atan => angle(&argument, &Value::ONE).ok_or_else(too_fine),
        Function::Asin | Function::Acos => {
            let other = (&Value::ONE - &(&argument * &argument)).square_root().ok_or_else(beyond)?;
            let (y, x) = if function == Function::Asin { (&argument, &other) } else { (&other, &argument) };
            angle(y, x).ok_or_else(too_fine)
        }
        Function::Sin | Function::Cos | Function::Tan => trigonometric(function, Number(argument)),
    }
}

fn trigonometric(function: Function, argument: Meaning) -> Result<Meaning, Fault> {
    let turn = match argument {
        Meaning::Angle(turn) => turn,
        Number(value) if value.is_zero() => Turn::degrees(Fraction::ZERO),
        Number(value) if value.is_constant() => {
            return Err(fault(format!("`{}` of a plain number, which would be radians", function.name()), "an angle")
                .try_this("write degrees with `deg`, as in `sin(30 deg)`"));
        }
        Number(_) => {
            return Err(fault(format!("`{}` of a letter that is no angle", function.name()), "an acute letter")
                .try_this("declare the letter as `acute`"));
        }
        OverPi(_) => return Err(over_an_angle()),
        _ => return Err(fault(format!("`{}` of something that is no angle", function.name()), "an angle")),
    };
    let direction = || turn.direction().ok_or_else(too_fine);
    sized(match function {
        Function::Sin => direction()?.sin,
        Function::Cos => direction()?.cos,
        _ => {
            turn.dot().ok_or_else(too_fine)?;
            turn.tangent().ok_or_else(right_angle)?
        }
    })
}

fn sized(value: Value) -> Result<Meaning, Fault> {
    check_size(&value)?;
    Ok(Number(value))
}

fn check_size(value: &Value) -> Result<(), Fault> {
    if value.terms() > MOST_TERMS {
        return Err(fault(format!("the formula grows beyond {MOST_TERMS} terms"), "a shorter formula"));
    }
    if value.longest_number() > LONGEST_NUMBER {
        return Err(fault("a number grows beyond thousands of digits", "smaller numbers, or fewer products of them"));
    }
    Ok(())
}

/// A fault of the expression as a whole.
fn fault(message: impl Into<String>, expected: impl Into<String>) -> Fault {
    Fault::new(message, Span::default(), expected)
}

fn right_angle() -> Fault {
    fault("the tangent of a right angle", "an angle other than 90 degrees")
        .try_this("give another angle, or use its sine and cosine")
}

fn negative_root() -> Fault {
    fault("the square root of a negative number", "a number that is not negative")
}

fn part_of_an_angle() -> Fault {
    fault("only whole multiples of such an angle can be taken", "a whole number times the angle")
}

fn too_fine() -> Fault {
    fault(
        "this angle is too finely given to be exact",
        format!("an angle of at most {} characters in degrees", Letter::LONGEST),
    )
}
