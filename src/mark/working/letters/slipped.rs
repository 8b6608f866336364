//! Numbers that were worked out wrongly on the way: after `9 cos 26° = 8.59` every 8.59 stands for `9 cos 26°`.
//!
//! Who goes on with such a number uses the same laws: with the formula in its place the lines show the method. What is
//! accurate is seen without.

use super::angles::put_everywhere;
use super::wrong_angle::WrongAngle;
use crate::bank::Code;
use crate::expr::Expr;
use crate::mark::award::{Award, Ground};
use crate::mark::key::KeyedPart;
use crate::mark::working::examine::{Examined, Value, value};
use crate::mark::working::lines::Line;
use crate::mark::working::prepared::Prepared;
use crate::mark::working::theirs::is_nearly_right;

/// What was worked out wrongly.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Slip {
    /// A number, without its sign, and the formula that it stands for.
    Number {
        /// What it came to.
        number: Expr,
        /// What should have come to another.
        formula: Expr,
    },
    /// A given angle that was taken for another.
    Angle(WrongAngle),
}

/// The same lines with the formula in the place of each number that it was worked out to wrongly, and all such numbers;
/// nothing if none is used again.
pub(in crate::mark::working) fn undone(
    lines: &[Line],
    before: &[Slip],
    prepared: &Prepared,
) -> (Option<Vec<Line>>, Vec<Slip>) {
    let mut slips = before.to_vec();
    let mut undone = lines.to_vec();
    for (line, typed) in undone.iter_mut().zip(lines).filter(|(_, typed)| !typed.is_crossed_out()) {
        if !slips.is_empty() {
            let put = |expr: &Expr| slips.iter().fold(expr.clone(), |expr, slip| slip.undone_in(&expr, prepared));
            line.readings_mut().for_each(|reading| put_everywhere(reading, &put));
        }
        let equations = typed.readings.first().map(|reading| reading.equations.as_slice()).unwrap_or_default();
        let found = equations.iter().filter_map(|equation| slip(equation, prepared));
        for slip in found.collect::<Vec<Slip>>() {
            slips.retain(|other| !other.is_of_the_same(&slip));
            slips.push(slip);
        }
    }
    let is_changed = |(one, other): (&Line, &Line)| {
        one.readings.iter().zip(&other.readings).any(|(one, other)| one.equations != other.equations)
    };
    let is_used = !slips.is_empty() && lines.iter().zip(&undone).any(is_changed);
    (is_used.then_some(undone), slips)
}

/// The number that a formula is said to come to and does not; `5 cos α = 5` is no slip of the calculator.
pub(in crate::mark::working) fn false_number<'e>(
    formula: &Expr,
    number: &'e Expr,
    prepared: &Prepared,
) -> Option<&'e Expr> {
    let is_worked_out = !is_plain(formula) && !has(formula, number) && is_plain(number);
    (is_worked_out && is_false(formula, number, prepared)).then_some(number)
}

fn slip(equation: &(Expr, Expr), prepared: &Prepared) -> Option<Slip> {
    let (formula, number) = equation;
    let of_number = || {
        Some(match false_number(formula, number, prepared)? {
            Expr::Negative(size) => Slip::Number { formula: formula.clone().negated(), number: (**size).clone() },
            size => Slip::Number { formula: formula.clone(), number: size.clone() },
        })
    };
    WrongAngle::of(equation, prepared).map(Slip::Angle).or_else(of_number)
}

impl Slip {
    /// Is it the same number, or the same angle, taken for something else?
    fn is_of_the_same(&self, other: &Slip) -> bool {
        match (self, other) {
            (Slip::Number { number: one, .. }, Slip::Number { number: two, .. }) => one == two,
            (Slip::Angle(one), Slip::Angle(two)) => one.is_of_the_same(two),
            _ => false,
        }
    }

    /// What was meant in the place of what was taken for it.
    fn undone_in(&self, expr: &Expr, prepared: &Prepared) -> Expr {
        let undone = match self {
            Slip::Number { number, formula } if number == expr => Some(formula.clone()),
            // `y − x = 2.75` after 5.5, where e is ½.
            Slip::Number { number, formula } => {
                let e = prepared.restitution.as_ref().filter(|e| is_times(expr, e, number, prepared));
                e.map(|e| Expr::product([e.clone(), formula.clone()]))
            }
            Slip::Angle(angle) => angle.undone_in_product(expr, prepared),
        };
        undone.unwrap_or_else(|| expr.map_children(&mut |child| self.undone_in(child, prepared)))
    }
}

/// Is it a number that nobody has given, and comes to so much of another?
fn is_times(expr: &Expr, share: &Expr, number: &Expr, prepared: &Prepared) -> bool {
    if !is_plain(expr) || prepared.given_numbers.contains(expr) {
        return false;
    }
    let spread = |expr: &Expr| match value(expr, prepared, &[])?.first()? {
        Value::Number(spread) => Some(*spread),
        Value::Vector(..) => None,
    };
    let all = spread(expr).zip(spread(share)).zip(spread(number));
    all.is_some_and(|((own, share), number)| {
        let product = number.times(share.middle());
        (own - product).may_be_nought(product.middle().abs())
    })
}

fn has(formula: &Expr, number: &Expr) -> bool {
    formula.children().into_iter().any(|child| child == number || has(child, number))
}

/// Is it a number as it stands: `8.59`, `-33/5`?
fn is_plain(expr: &Expr) -> bool {
    match expr {
        Expr::Number(_) | Expr::Decimal(_) => true,
        Expr::Negative(size) => is_plain(size),
        Expr::Quotient(above, below) => is_plain(above) && is_plain(below),
        _ => false,
    }
}

/// Is the formula known, and comes to another number?
fn is_false(formula: &Expr, number: &Expr, prepared: &Prepared) -> bool {
    let values = |expr: &Expr| value(expr, prepared, &prepared.names);
    let is_other = |(right, own): (&Value, &Value)| match (right, own) {
        (Value::Number(right), Value::Number(own)) => {
            let (right, own) = (right.middle(), own.middle());
            !is_nearly_right(own, right) && right != 0.0 && own != 0.0
        }
        _ => false,
    };
    values(formula).zip(values(number)).is_some_and(|(right, own)| right.iter().zip(&own).all(is_other))
}

impl Examined {
    /// With the methods, and what follows through, that are seen where wrong numbers are what they were to be.
    pub(in crate::mark::working) fn follow_slips(&mut self, part: &KeyedPart, undone: Examined) {
        for ((mark, award), other) in part.scheme.iter().zip(&mut self.awards).zip(undone.awards) {
            let follows = mark.code.is_method() || mark.code == Code::A1FollowThrough;
            let is_open = award.as_ref().is_none_or(|award| !award.given);
            if let Some(other) = other.filter(|other| follows && is_open && other.given) {
                let (note, feedback) =
                    (Some(Ground::FollowThrough.tag()), "followed through from your own values".to_owned());
                *award = Some(Award { note, feedback, ..other });
            }
        }
        for (line, other) in self.lines.iter_mut().zip(undone.lines) {
            if line.role.is_empty() {
                line.role = other.role;
            }
        }
        if self.letters.is_none() && undone.letters.is_some() {
            self.theirs.values.extend(undone.theirs.values);
            (self.followed, self.solution, self.letters) = (undone.followed, undone.solution, undone.letters);
        }
    }
}
