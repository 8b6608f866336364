//! One of the two laws in which a number that is given was copied wrongly: `4(5 cos 30°) = 4v + 2w` where the speed is 4.

use super::apiece::Apiece;
use super::conventions::Convention;
use super::departure::Departure;
use super::offered::differences;
use super::pair::{Laws, Matched};
use crate::expr::Expr;
use crate::mark::working::numbers::Linear;
use crate::mark::working::prepared::Prepared;
use crate::mechanics::{Quantity, Scene, Velocity};
use crate::number::Fraction;

/// A number that is given, and what a student has for it.
#[derive(Clone, Debug, PartialEq)]
pub(in crate::mark) struct Misread {
    given: Expr,
    written: Expr,
}

impl Misread {
    /// Another coefficient of restitution than the one that is given: a simple fraction, if it is one.
    pub(super) fn of_restitution(given: Expr, written: f64) -> Misread {
        let is_whole = |below: &i64| {
            let above = written * *below as f64;
            (above - above.round()).abs() < 1e-9
        };
        let written = match (2..=MOST_BELOW).find(is_whole) {
            Some(below) => Expr::integer((written * below as f64).round() as i64).over(Expr::integer(below)),
            None => Expr::Decimal(format!("{written:.9}")),
        };
        Misread { given, written }
    }

    /// Is what is written for it another number of the question, and so perhaps taken for it?
    pub(in crate::mark) fn is_of_another(&self, prepared: &Prepared) -> bool {
        prepared.given_numbers.contains(&self.written) || prepared.is_restitution_elsewhere(&self.written)
    }

    /// A formula of the question as the student has read it.
    pub(in crate::mark) fn read(&self, shown: &Expr) -> Expr {
        match shown {
            number if *number == self.given => self.written.clone(),
            number if *number == self.given.clone().negated() => self.written.clone().negated(),
            other => other.map_children(&mut |child| self.read(child)),
        }
    }
}

/// The largest denominator of a simple fraction.
const MOST_BELOW: i64 = 20;

/// An equation with more numbers is not gone through for one that is copied wrongly.
const MOST_NUMBERS: usize = 8;

/// The numbers that stand in a question for masses and velocities, and 1 where a letter stands alone: each once.
pub(in crate::mark::working) fn given_numbers(scene: &Scene) -> Vec<Expr> {
    let masses = scene.masses.iter().flatten().map(|mass| &mass.shown);
    let velocities = scene.before.iter().flatten().flat_map(|velocity| match velocity {
        Velocity::Components(x, y) => vec![&x.shown, &y.shown],
        Velocity::Polar { speed, angle, .. } => {
            std::iter::once(&speed.shown).chain(angle.iter().map(|(_, shown)| shown)).collect()
        }
    });
    let mut all: Vec<Expr> = Vec::new();
    for shown in masses.chain(velocities) {
        let mut own = numbers(shown);
        if own.is_empty() && !shown.names().is_empty() {
            own.push(Expr::integer(1));
        }
        for number in own.into_iter().map(without_sign) {
            // Of what is nought no number stands in the question.
            if !number.is_zero() && !all.contains(&number) {
                all.push(number);
            }
        }
    }
    all
}

/// The law that an equation is once one of its numbers, in one place or several, is what is given; with what was copied
/// wrongly, unless it is a velocity of another sphere or of before an earlier impact, which is no slip of the pen.
pub(super) fn with_number_misread(
    (left, right): &(Expr, Expr),
    laws: &Laws,
    convention: &Convention,
    prepared: &Prepared,
) -> Option<(Matched, Option<Misread>)> {
    let [left, right] = &[left, right].map(|side| with_ones(side, &prepared.letters_of_speeds));
    let has = |letter: &String| [left, right].iter().any(|side| side.names().iter().any(|name| name.text == *letter));
    let written: Vec<Expr> = [left, right].into_iter().flat_map(numbers).collect();
    if !convention.letters.iter().all(has) || written.len() > MOST_NUMBERS {
        return None;
    }
    // What is taken from itself comes to nought whatever it is.
    let comes_to_nought = |linear: &Vec<Linear>| linear.iter().all(|at| at.constant.may_be_nought(at.size));
    let as_written = differences(&(left.clone(), right.clone()), prepared).filter(|linear| !comes_to_nought(linear))?;
    let law = |put: &dyn Fn(usize, &Expr) -> Option<Expr>| -> Option<(Quantity, bool)> {
        let mut place = 0;
        let mut with = |side: &Expr| replaced(side, &mut place, put);
        let equation = (with(left), with(right));
        let linear = differences(&equation, prepared)?;
        let is_velocity = linear.iter().zip(&as_written).all(|(one, other)| one.unknowns == other.unknowns);
        Some((laws.exactly(&linear, || Apiece::of(&equation, prepared), convention)?, is_velocity))
    };
    let firsts =
        written.iter().enumerate().filter(|(at, typed)| !written[..*at].contains(typed)).map(|(_, typed)| typed);
    let mut found = firsts.flat_map(|typed| {
        let places: Vec<usize> = (0..written.len()).filter(|place| written[*place] == *typed).collect();
        let may_be = move |given: &&Expr| *given != typed && !prepared.are_masses(typed, given);
        let some = some_of(&places);
        prepared
            .given_numbers
            .iter()
            .chain(&prepared.carried)
            .filter(may_be)
            .flat_map(move |given| some.clone().into_iter().map(move |some| (some, given, typed)))
    });
    found.find_map(|(some, given, typed)| {
        let (equation, is_velocity) = law(&|place, _| some.contains(&place).then(|| given.clone()))?;
        if is_velocity && prepared.is_speed_elsewhere(typed) {
            return Some((Matched::with(equation, Departure::VelocityElsewhere), None));
        }
        let misread = Misread { given: given.clone(), written: typed.clone() };
        let is_given = prepared.given_numbers.contains(given);
        is_given.then(|| (Matched::with(equation, Departure::NumberMisread), Some(misread)))
    })
}

/// The places in which a number may have been copied wrongly: one of them, all, or some of a few.
fn some_of(places: &[usize]) -> Vec<Vec<usize>> {
    if places.len() > MOST_PLACES {
        return places.iter().map(|place| vec![*place]).chain([places.to_vec()]).collect();
    }
    let chosen =
        |bits: usize| (0..places.len()).filter(|place| bits >> place & 1 == 1).map(|place| places[place]).collect();
    let mut all: Vec<Vec<usize>> = (1..1_usize << places.len()).map(chosen).collect();
    all.sort_by_key(Vec::len);
    all
}

/// Of more places not every choice is tried.
const MOST_PLACES: usize = 3;

fn without_sign(number: Expr) -> Expr {
    match number {
        Expr::Number(value) if value < Fraction::ZERO => Expr::Number(-value),
        other => other,
    }
}

/// The formula with a 1 before each letter for a speed: who writes u for 2u, or 3mu for 3m × 2u, has left the 2 out.
fn with_ones(expr: &Expr, speeds: &[String]) -> Expr {
    let is_speed = |expr: &Expr| matches!(expr, Expr::Name(name) if speeds.contains(&name.text));
    let is_number = |expr: &Expr| matches!(expr, Expr::Number(_) | Expr::Decimal(_));
    match expr {
        Expr::Product(factors) if factors.iter().any(is_speed) => {
            let one = (factors.iter().filter(|factor| is_number(factor)).count() < 2).then(|| Expr::integer(1));
            let other = |factor: &Expr| if is_speed(factor) { factor.clone() } else { with_ones(factor, speeds) };
            Expr::Product(one.into_iter().chain(factors.iter().map(other)).collect())
        }
        speed if is_speed(speed) => Expr::Product(vec![Expr::integer(1), speed.clone()]),
        other => other.map_children(&mut |child| with_ones(child, speeds)),
    }
}

/// The numbers in a formula, in order.
pub(in crate::mark::working) fn numbers(expr: &Expr) -> Vec<Expr> {
    match expr {
        Expr::Number(_) | Expr::Decimal(_) => vec![expr.clone()],
        other => other.children().into_iter().flat_map(numbers).collect(),
    }
}

/// The formula with other numbers in the places for which there are such; places are counted on.
fn replaced(expr: &Expr, place: &mut usize, put: &dyn Fn(usize, &Expr) -> Option<Expr>) -> Expr {
    match expr {
        Expr::Number(_) | Expr::Decimal(_) => {
            let number = put(*place, expr).unwrap_or_else(|| expr.clone());
            *place += 1;
            number
        }
        other => other.map_children(&mut |child| replaced(child, place, put)),
    }
}
