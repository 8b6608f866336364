//! Numbers that were worked out wrongly on the way: after `9 cos 26° = 8.59` every 8.59 stands for `9 cos 26°`.
//!
//! Who goes on with such a number uses the same laws: with the formula in its place the lines show the method. What is
//! accurate is seen without.
//!
//! A given angle whose sine, cosine or tangent was taken wrongly is such a number too: after `cos α = √3/2` every √3/2 stands
//! for the cosine of α.

use super::angles::{NEW, definition, put_everywhere};
use crate::bank::Code;
use crate::expr::{Expr, Function};
use crate::mark::award::{Award, Ground};
use crate::mark::key::KeyedPart;
use crate::mark::working::examine::{Examined, Value, context, value};
use crate::mark::working::lines::Line;
use crate::mark::working::numbers::{constant, sizes};
use crate::mark::working::prepared::Prepared;
use crate::mark::working::theirs::is_nearly_right;
use crate::mechanics::{Moment, Quantity, Sphere};

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
    /// A given angle, in degrees: the one that was taken, and the one that is given.
    Angle {
        /// The one that was taken.
        wrong: f64,
        /// The one that is given.
        right: f64,
    },
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
    false_angle(equation, prepared).or_else(of_number)
}

/// `cos α = √3/2` of an angle that the question gives, and that is another.
fn false_angle(equation: &(Expr, Expr), prepared: &Prepared) -> Option<Slip> {
    let (name, wrong) = definition(equation, prepared)?;
    let named = prepared.angles.iter().find(|(own, _)| *own == name).map(|(_, angle)| *angle);
    let right = named.or_else(|| only_angle(prepared).filter(|_| !NEW.contains(&name.as_str())))?;
    let is_other = !is_nearly_right(wrong, right) && (1.0..89.0).contains(&wrong) && (wrong - 45.0).abs() > 0.1;
    is_other.then_some(Slip::Angle { wrong, right })
}

/// The angle with the line of centres before the impact, where there is one and nobody has given it a name.
fn only_angle(prepared: &Prepared) -> Option<f64> {
    let angle = |sphere| sizes(&prepared.known, Quantity::AngleToLine(sphere, Moment::Before))?.first().copied();
    let is_open = |angle: &f64| (1.0..179.0).contains(angle) && (angle - 90.0).abs() > 1.0;
    let mut angles = Sphere::BOTH.into_iter().filter_map(angle).filter(is_open);
    angles.next().filter(|_| prepared.angles.is_empty() && angles.next().is_none())
}

impl Slip {
    /// Is it the same number, or the same angle, taken for something else?
    fn is_of_the_same(&self, other: &Slip) -> bool {
        match (self, other) {
            (Slip::Number { number: one, .. }, Slip::Number { number: two, .. }) => one == two,
            (Slip::Angle { right: one, .. }, Slip::Angle { right: two, .. }) => one == two,
            _ => false,
        }
    }

    /// The formula in the place of the number; of an angle its sine, cosine or tangent as it should be.
    fn undone_in(&self, expr: &Expr, prepared: &Prepared) -> Expr {
        match self {
            Slip::Number { number, formula } if number == expr => formula.clone(),
            Slip::Angle { wrong, right } => {
                if let Some(product) = with_right_angle(expr, *wrong, *right, prepared) {
                    return product;
                }
                expr.map_children(&mut |child| self.undone_in(child, prepared))
            }
            Slip::Number { .. } => expr.map_children(&mut |child| self.undone_in(child, prepared)),
        }
    }
}

/// More factors do not make one sine: `√3/2`, `(2√5)/5`.
const MOST_FACTORS: u32 = 3;

/// A product some of whose factors make the sine, cosine or tangent of the wrong angle, with that of the right one in their
/// place: `8 × √3/2`, which is read as 8√3 over 2.
fn with_right_angle(expr: &Expr, wrong: f64, right: f64, prepared: &Prepared) -> Option<Expr> {
    let mut factors: Vec<(Expr, bool)> = Vec::new();
    take_factors(expr, false, &mut factors);
    let number = |(factor, is_below): &(Expr, bool)| {
        let value = constant(factor, &context(prepared, 0)).filter(|_| factor.names().is_empty())?.middle();
        Some(if *is_below { value.recip() } else { value })
    };
    let values: Vec<Option<f64>> = factors.iter().map(number).collect();
    let angle = wrong.to_radians();
    let functions = [(Function::Cos, angle.cos()), (Function::Sin, angle.sin()), (Function::Tan, angle.tan())];
    // `2/√5` is the cosine, where 1/√5 alone would be the sine.
    let mut sets: Vec<u32> =
        (1_u32..1 << factors.len().min(8)).filter(|set| set.count_ones() <= MOST_FACTORS).collect();
    sets.sort_by_key(|set| std::cmp::Reverse(set.count_ones()));
    let e = sizes(&prepared.known, Quantity::Restitution).and_then(|e| e.first().copied());
    let (set, function) = sets.into_iter().find_map(|set| {
        let own = |place: &usize| set >> place & 1 == 1;
        let product: Option<f64> = (0..factors.len().min(8)).filter(own).map(|place| values[place]).product();
        let product = product?;
        // As many figures as anybody writes; what a given number is too is left alone.
        let is_it = |(_, value): &&(Function, f64)| (value - product).abs() <= 6e-4 * value;
        let function = functions.iter().find(is_it)?.0;
        let is_given = |given: &Expr| {
            constant(given, &context(prepared, 0)).is_some_and(|given| (given.middle() - product).abs() < 1e-9)
        };
        let is_e = e.is_some_and(|e| (e - product).abs() < 1e-9);
        (!is_e && !prepared.given_numbers.iter().any(is_given)).then_some((set, function))
    })?;
    let right = Expr::call(function, Expr::degrees(Expr::Decimal(format!("{right:.12}"))));
    let (mut above, mut below) = (vec![right], Vec::new());
    for (place, (factor, is_below)) in factors.into_iter().enumerate() {
        if place >= 8 || set >> place & 1 == 0 {
            if is_below { below.push(factor) } else { above.push(factor) }
        }
    }
    let above = Expr::Product(above);
    Some(if below.is_empty() { above } else { above.over(Expr::Product(below)) })
}

/// What is multiplied in a formula, and what stands below the line.
fn take_factors(expr: &Expr, is_below: bool, factors: &mut Vec<(Expr, bool)>) {
    match expr {
        Expr::Product(inner) => inner.iter().for_each(|factor| take_factors(factor, is_below, factors)),
        Expr::Quotient(above, below) => {
            take_factors(above, is_below, factors);
            take_factors(below, !is_below, factors);
        }
        other => factors.push((other.clone(), is_below)),
    }
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
            self.theirs.0.extend(undone.theirs.0);
            (self.followed, self.solution, self.letters) = (undone.followed, undone.solution, undone.letters);
        }
    }
}
