//! From what a condition comes to, to the letter that was to be found: squared and collected, both roots, and why one of
//! them is left out.

use std::cmp::Ordering;

use super::backwards::Posed;
use super::condition::{Gap, name_of};
use super::formula::multiple;
use super::line::Line;
use super::scene::Condition;
use super::scene_reader::meaning;
use super::working::Show;
use crate::expr::{Expr, Function, Meaning, Turn, evaluate, written, written_angle};
use crate::number::{Angle, Fraction, Letter, Range, Root, Value, collected, solve_system};

/// Longer equations would not help a reader.
pub(super) const MOST_SHOWN: usize = 8;

/// How a letter was found from an equation that must be nought, where it is one equation alone. In other solutions it has
/// the other values.
pub(super) fn lines(equation: Option<&Value>, letter: Letter, value: &Value, others: &[&Value]) -> Vec<Line> {
    let (coefficients, is_squared) =
        equation.and_then(|equation| collected(equation, letter)).unwrap_or((Vec::new(), false));
    match coefficients.as_slice() {
        [constant, linear, square] if linear.is_zero() => {
            let found =
                (-constant).divided_by(square).map(|square| Expr::equation(base(letter).to_the(2), written(&square)));
            vec![Line::plain("So", with_value(letter, value, found))]
        }
        [_, _, _] => {
            let is_solution = |root: &Value| others.iter().any(|other| other.equals(root));
            by_quadratic(equation, &coefficients, is_squared, letter, value, is_solution)
        }
        _ => {
            let square = value * value;
            let is_root = !value.roots().is_empty() && square.roots().is_empty();
            let found = is_root.then(|| Expr::equation(base(letter).to_the(2), written(&square)));
            vec![Line::plain("So", with_value(letter, value, found))]
        }
    }
}

impl Posed {
    /// The condition with what was derived put in, where that is short: of angles their tangents.
    pub(super) fn condition_in_unknowns(&self, condition: &Condition) -> Option<Expr> {
        let names = |name: &str| name_of(name, &|name| meaning(&self.scene.letters, name), &self.known);
        // A quotient that takes minutes would not be short.
        let tangent = |turn: Turn| if turn.dot()?.is_laborious() { None } else { turn.tangent() };
        let side = |expr: &Expr| match evaluate(expr, &names).ok()? {
            Meaning::Number(value) => Some((value, false)),
            Meaning::Degrees(turn) | Meaning::Angle(turn) => Some((tangent(turn)?, true)),
            _ => None,
        };
        let (left, of_angle) = side(&condition.left)?;
        let right = match side(&condition.right)? {
            (value, false) if of_angle => Turn::degrees(value.as_fraction()?.clone()).tangent()?,
            (_, true) if !of_angle => return None,
            (value, _) => value,
        };
        let nested =
            |value: &Value| value.roots().iter().filter(|root| matches!(root, Root::Nested { .. })).count() > 1;
        let short = left.terms() <= MOST_SHOWN && right.terms() <= MOST_SHOWN && !nested(&left) && !nested(&right);
        short.then(|| Expr::equation(written(&left), written(&right)))
    }
}

/// `m`, or of an angle its tangent.
fn base(letter: Letter) -> Expr {
    let name = name(letter);
    if letter.range() == Range::Acute { Expr::call(Function::Tan, name) } else { name }
}

fn name(letter: Letter) -> Expr {
    Expr::name(letter.name().replace("A.mass", "m_A").replace("B.mass", "m_B"))
}

/// The value, behind what was found of its square; of an angle the tangent and then the angle.
fn with_value(letter: Letter, value: &Value, square: Option<Expr>) -> Vec<Expr> {
    let mut equations = Vec::from_iter(square);
    let (name, acute) = (name(letter), letter.range() == Range::Acute);
    if !acute || value.is_constant() || equations.is_empty() {
        equations.push(Expr::equation(base(letter), written(value)));
    }
    if !acute {
        equations.extend(Show::approximately(&name, value));
    }
    if let Some(angle) = Angle::of(value, &Value::ONE).filter(|_| acute && value.is_constant()) {
        equations.push(Expr::equation(name.clone(), written_angle(&angle)));
        equations.extend(Show::approximate_angle(&name, &angle));
    }
    equations
}

/// The quadratic equation, its factors where they are rational, and both roots.
fn by_quadratic(
    equation: Option<&Value>,
    coefficients: &[Value],
    is_squared: bool,
    letter: Letter,
    value: &Value,
    is_solution: impl Fn(&Value) -> bool,
) -> Vec<Line> {
    let mut lines = Vec::new();
    if coefficients.iter().map(Value::terms).sum::<usize>() <= MOST_SHOWN {
        let nought = |left: Expr| Expr::equation(left, Expr::integer(0));
        let mut equations = vec![nought(polynomial(coefficients, letter))];
        let roots = [Some(value), other_root(coefficients, value).as_ref()]
            .map(|root| root.and_then(|root| factor(root, letter)));
        if let [Some(first), Some(second)] = roots {
            equations.push(nought(Expr::product([first, second])));
        }
        let words = if is_squared { "Squaring both sides and collecting terms:" } else { "Collecting terms:" };
        lines.push(Line::plain(words, equations));
    }
    let all =
        equation.and_then(|equation| solve_system(std::slice::from_ref(equation), &[letter]).ok()).unwrap_or_default();
    let other = all.iter().flatten().find(|root| !root.equals(value));
    let found = with_value(letter, value, None);
    lines.push(match other.filter(|other| other.is_constant() == value.is_constant()) {
        Some(other) => {
            let root = |value: &Value| Expr::equation(base(letter), written(value));
            let came_in = is_squared && equation.is_some_and(|equation| !is_root_of(equation, letter, other));
            let words = match is_solution(other) {
                true => "So {a} or {b}, both of which are possible; here:".to_owned(),
                false => format!("So {{a}} or {{b}}, {}:", why(letter, other, came_in)),
            };
            let formulas = [("a", root(value)), ("b", root(other)), ("x", base(letter))];
            Line::with(&words, &formulas, found)
        }
        None => Line::plain("So", found),
    });
    lines
}

/// Does it make the equation nought? Of a number an enclosure says so, at once however many roots are in it.
fn is_root_of(equation: &Value, letter: Letter, value: &Value) -> bool {
    let gap = Gap { value: equation.clone(), cosine: None };
    let exactly = || Some(equation.substitute(letter, value)?.is_zero());
    gap.vanishes_at(&[letter], std::slice::from_ref(value)).or_else(exactly).unwrap_or(true)
}

fn other_root(coefficients: &[Value], value: &Value) -> Option<Value> {
    let [_, linear, square] = coefficients else { return None };
    Some(&(-linear).divided_by(square)? - value)
}

/// The highest power first, and its coefficient positive.
fn polynomial(coefficients: &[Value], letter: Letter) -> Expr {
    let turned = coefficients.last().and_then(Value::sign).is_some_and(Ordering::is_lt);
    let powers = coefficients.iter().enumerate().rev().filter(|(_, coefficient)| !coefficient.is_zero());
    let terms = powers.map(|(power, coefficient)| {
        let coefficient = if turned { -coefficient } else { coefficient.clone() };
        match i64::try_from(power) {
            Ok(power) if power > 0 => multiple(&coefficient, base(letter).to_the(power)),
            _ => written(&coefficient),
        }
    });
    Expr::sum(terms)
}

/// `5m - 4` for the root 4/5.
fn factor(root: &Value, letter: Letter) -> Option<Expr> {
    let root = root.as_fraction()?;
    let [above, below] = [root.numerator(), root.denominator()].map(|whole| Value::Rational(Fraction::from(whole)));
    Some(polynomial(&[-above, below], letter))
}

/// Why the other root is left out.
fn why(letter: Letter, other: &Value, came_in: bool) -> &'static str {
    let sign = other.sign();
    match letter.range() {
        Range::Positive | Range::Acute if sign.is_some_and(Ordering::is_le) => "and {x} is positive",
        Range::Unit if sign == Some(Ordering::Less) => "and {x} is not negative",
        Range::Unit if (other - &Value::ONE).sign() == Some(Ordering::Greater) => "and {x} is at most 1",
        _ if came_in => "of which the second came in by squaring",
        _ => "of which the second is not possible",
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::expr::print;

    /// The lines for the positive root of `square x² + linear x + constant = 0`, perhaps of a root of that.
    fn told(range: Range, [constant, linear, square]: [i64; 3], value: Value, under_root: bool) -> String {
        let letter = Letter::new("x", range).unwrap();
        let x = Value::letter(letter);
        let terms = [Value::from(constant), &Value::from(linear) * &x, &Value::from(square) * &(&x * &x)];
        let equation = terms.iter().fold(Value::ZERO, |sum, term| &sum + term);
        let equation = if under_root { &(&equation + &(&x * &x)).square_root().unwrap() - &x } else { equation };
        let lines = lines(Some(&equation), letter, &value, &[]).into_iter();
        let text = |line: Line| [print::text_unicode(&line.words), all(&line.equations)].join(" ");
        lines.map(text).collect::<Vec<_>>().join(" | ")
    }

    fn all(equations: &[Expr]) -> String {
        equations.iter().map(print::unicode).collect::<Vec<_>>().join("; ")
    }

    #[test]
    fn a_letter_is_found_as_on_paper() {
        let two = || Value::from(2);
        for (range, coefficients, value, under_root, expected) in [
            (Range::Positive, [-6, 3, 0], two(), false, "So x = 2"),
            (Range::Positive, [-4, 0, 1], two(), false, "So x² = 4; x = 2"),
            (Range::Positive, [-3, 0, 1], Value::from(3).square_root().unwrap(), false, "So x² = 3; x = √3; x ≈ 1.73"),
            (
                Range::Positive,
                [-6, 1, 1],
                two(),
                false,
                "Collecting terms: x² + x − 6 = 0; (x − 2)(x + 3) = 0 | So x = 2 or x = −3, and x is positive: x = 2",
            ),
            (
                Range::Positive,
                [-6, 1, 1],
                two(),
                true,
                "Squaring both sides and collecting terms: x² + x − 6 = 0; (x − 2)(x + 3) = 0 | So x = 2 or x = −3, and x is positive: x = 2",
            ),
        ] {
            assert_eq!(told(range, coefficients, value, under_root), expected);
        }
    }

    #[test]
    fn a_root_that_squaring_brought_in_is_named_as_such() {
        let letter = Letter::new("x", Range::Real).unwrap();
        let x = Value::letter(letter);
        let equation = &(&x + &Value::from(7)).square_root().unwrap() - &(&x + &Value::ONE);
        let lines = lines(Some(&equation), letter, &Value::from(2), &[]);
        let words = print::text_unicode(&lines[1].words);
        assert_eq!(words, "So x = 2 or x = −3, of which the second came in by squaring:");
    }
}
