//! What a student wrote, as a number at the points, with the figures of its decimals.

use crate::expr::Expr;
use crate::mark::reading::{Form, Said};
use crate::number::{Fraction, Letter, Number, Range};

use super::evaluated::Evaluated;
use super::sample::Sample;

/// The fewest significant figures of a decimal that are evidence of anything.
const FEWEST: u32 = 2;

/// The fewest of a whole number that is taken for a rounded one. Angles are often given to the nearest degree.
const FEWEST_OF_WHOLE: u32 = 3;

/// Of what is known less closely than to this part, by the last of its figures, there are many that come near.
const ROUGH: f64 = 0.0101;

/// Two exact values that differ by less than this part are one.
pub(super) const EXACT: f64 = 1e-12;

/// What floats leave of a unit of the last figure. The next number, 12 of 11, is not cut off to it.
const SLACK: f64 = 1e-7;

/// A value as it was written.
#[derive(Clone, Copy, Debug)]
pub(super) struct Written {
    pub(super) value: Sample,
    /// One in the last figure, as a part of the value; `None` if no decimal is in it, or one with too few figures.
    unit: Option<f64>,
    /// Is it written in figures, without a fraction, a root or a function?
    pub(super) is_in_figures: bool,
}

/// How a value compares with what was written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Fit {
    /// It is that, or rounds to it.
    Rounded,
    /// Cut off, it is that.
    CutOff,
    None,
}

impl Written {
    /// A value with the letters of the question; `None` if it has others, or is no number.
    pub(super) fn of(expr: &Expr, letters: &[Letter]) -> Option<Written> {
        let value = Evaluated::in_letters(expr, letters)?.value;
        let fewest = if is_whole(expr) { FEWEST_OF_WHOLE } else { FEWEST };
        Written::with_figures(expr, value, fewest)
    }

    /// An angle in degrees. A plain number is of degrees, unless it is said to be of radians.
    pub(super) fn degrees(expr: &Expr, letters: &[Letter], in_radians: bool) -> Option<Written> {
        let found = Evaluated::in_letters(expr, letters)?;
        let turned = found.is_angle || in_radians;
        Written::with_figures(expr, if turned { found.value.map(f64::to_degrees) } else { found.value }, FEWEST)
    }

    fn with_figures(expr: &Expr, value: Sample, fewest: u32) -> Option<Written> {
        let unit = Decimals::of(expr).filter(|decimals| decimals.figures >= fewest).map(|decimals| decimals.unit);
        value.is_finite().then_some(Written { value, unit, is_in_figures: is_in_figures(expr) })
    }

    /// Has it fewer than three figures, so that two mistakes together come near it by chance?
    pub(super) fn is_rough(&self) -> bool {
        self.unit.is_some_and(|unit| unit > ROUGH)
    }

    /// The same as an exact value.
    pub(super) fn exactly(self) -> Written {
        Written { unit: None, ..self }
    }

    /// So many times the value.
    pub(super) fn times(self, factor: f64) -> Written {
        Written { value: self.value.map(|value| value * factor), ..self }
    }

    /// So many degrees less the value, known to the same place.
    pub(super) fn less_from(self, degrees: f64) -> Written {
        let value = self.value.map(|value| degrees - value);
        let unit = self.unit.map(|unit| (unit * self.value.0[0] / value.0[0]).abs()).filter(|unit| unit.is_finite());
        Written { value, unit, ..self }
    }

    /// The sizes between which a value must lie that can have been written so, at the first point.
    pub(super) fn sizes(self) -> (f64, f64) {
        let size = self.value.0[0].abs();
        let unit = self.unit.unwrap_or(0.0).max(4.0 * EXACT) * size + 2e-15;
        (size - unit, size + unit)
    }

    /// Can the value have been written so, rounded or cut off to these figures, by someone who found it and not the
    /// truth? Without regard to the sign if that is no part of the answer.
    pub(super) fn is(self, value: Sample, truth: Sample, signed: bool) -> bool {
        self.fit(value, signed) != Fit::None && !self.rounds_alike(value, truth, signed)
    }

    /// Is it the truth at its own figures?
    pub(super) fn is_right(self, truth: Sample, signed: bool) -> bool {
        self.fit(truth, signed) != Fit::None
    }

    /// Is it the truth, cut off and not rounded?
    pub(super) fn is_cut_off(self, truth: Sample) -> bool {
        self.fit(truth, false) == Fit::CutOff
    }

    /// The numbers that would be rounded to it; `None` for an exact value.
    pub(super) fn rounded_range(self) -> Option<(f64, f64)> {
        let own = self.value.0[0];
        let unit = (own * self.unit?).abs();
        Some((own - unit / 2.0, own + unit / 2.0))
    }

    /// The numbers that would be written so at the figures of what was written, at the first point: half a unit of the
    /// last figure to each side, or a unit further from nought where the truth was cut off. `None` if the truth is not
    /// among them.
    pub(super) fn range_around(self, truth: Sample) -> Option<(f64, f64)> {
        let own = self.value.0[0];
        let unit = own * self.unit.unwrap_or(4.0 * EXACT);
        let (one, two) = match self.fit(truth, true) {
            Fit::Rounded => (own - unit / 2.0, own + unit / 2.0),
            Fit::CutOff => (own, own + unit),
            Fit::None => return None,
        };
        Some((one.min(two), one.max(two)))
    }

    /// The numbers that would be rounded to it or cut off to it; `None` for an exact value.
    pub(super) fn range(self) -> Option<(f64, f64)> {
        let own = self.value.0[0];
        let unit = own * self.unit?;
        let (one, two) = (own - unit / 2.0, own + unit * (1.0 - SLACK));
        Some((one.min(two), one.max(two)))
    }

    /// Is it this value itself, in either sense, and no rounded one?
    pub(super) fn is_exactly(self, truth: Sample) -> bool {
        self.value.size().is_near(truth.size(), EXACT)
    }

    fn fit(self, value: Sample, signed: bool) -> Fit {
        let (value, own) = if signed { (value, self.value) } else { (value.size(), self.value.size()) };
        if value.is_near(own, EXACT) {
            return Fit::Rounded;
        }
        let Some(unit) = self.unit else { return Fit::None };
        // How far the value lies beyond what was written, in units of its last figure, away from nought.
        let beyond = value.with(own, |value, own| (value - own) / (own * unit));
        let all = |within: &dyn Fn(f64) -> bool| beyond.0.iter().all(|place| within(*place));
        if all(&|place| place.abs() <= 0.5 + SLACK) {
            Fit::Rounded
        } else if all(&|place| (-SLACK..1.0 - SLACK).contains(&place)) {
            Fit::CutOff
        } else {
            Fit::None
        }
    }

    /// Are the two one at the figures that were written?
    fn rounds_alike(self, one: Sample, two: Sample, signed: bool) -> bool {
        let Some(unit) = self.unit else { return one.is_near(two, EXACT) };
        let place = |value: f64, own: f64| {
            let size = (value.abs() / (own.abs() * unit) + SLACK).round();
            if signed { size.copysign(value) } else { size }
        };
        one.0.iter().zip(two.0).zip(self.value.0).all(|((one, two), own)| place(*one, own) == place(two, own))
    }
}

fn is_whole(expr: &Expr) -> bool {
    match expr {
        Expr::Number(number) => number.is_integer(),
        Expr::Negative(size) => is_whole(size),
        _ => false,
    }
}

/// Is nothing in it but figures and letters?
fn is_in_figures(expr: &Expr) -> bool {
    match expr {
        Expr::Quotient(..) | Expr::Call(..) | Expr::Pi => false,
        Expr::Number(number) => number.is_integer(),
        other => other.children().into_iter().all(is_in_figures),
    }
}

/// The decimals of a formula: the fewest figures of any, and the largest last place as a part of its number.
struct Decimals {
    figures: u32,
    unit: f64,
}

impl Decimals {
    fn of(expr: &Expr) -> Option<Decimals> {
        match expr {
            // A whole number by itself may be a rounded one.
            Expr::Number(number) => number.is_integer().then(|| Decimals::text(&number.to_string())).flatten(),
            Expr::Negative(inner) => Decimals::of(inner),
            _ => Decimals::within(expr),
        }
    }

    fn within(expr: &Expr) -> Option<Decimals> {
        let own = match expr {
            Expr::Decimal(text) => Decimals::text(text),
            // An exponent is a count and no measurement.
            Expr::Power(base, _) => return Decimals::within(base),
            _ => None,
        };
        let all = expr.children().into_iter().filter_map(Decimals::within).chain(own);
        all.reduce(|one, two| Decimals { figures: one.figures.min(two.figures), unit: one.unit.max(two.unit) })
    }

    fn text(text: &str) -> Option<Decimals> {
        let value = text.parse::<Fraction>().ok()?.to_f64().abs();
        let places = text.split_once('.').map_or(0, |(_, decimals)| decimals.len());
        let digits: String = text.chars().filter(char::is_ascii_digit).collect();
        let figures = digits.trim_start_matches('0').len() as u32;
        (value > 0.0).then(|| Decimals { figures, unit: 10_f64.powi(-(places as i32)) / value })
    }
}

/// The ends of the values that a letter is said to have, where they are more than what it can be anyway: the letter by
/// itself beside a number, or an inequality that is linear in it.
pub(super) fn ends(said: &Said, letter: Letter, letters: &[Letter]) -> Vec<Written> {
    let found: Vec<Written> = match &said.form {
        Form::Range(low, high) => {
            [low, high].into_iter().flatten().filter_map(|end| Written::of(&end.at, letters)).collect()
        }
        Form::Equation(relation) => pairs(relation).iter().filter_map(|pair| end(pair, letter, letters)).collect(),
        Form::Value(value) => Written::of(value, letters).into_iter().collect(),
        _ => Vec::new(),
    };
    let is_natural = |end: &Written| letter.range() == Range::Unit && [0.0, 1.0].contains(&end.value.0[0]);
    found.into_iter().filter(|end| !is_natural(end)).collect()
}

/// The sides of every relation of a chain, two by two.
fn pairs(relation: &Expr) -> Vec<[&Expr; 2]> {
    match relation {
        Expr::Relation(left, _, right) => match &**left {
            Expr::Relation(_, _, middle) => pairs(left).into_iter().chain([[&**middle, &**right]]).collect(),
            _ => vec![[left, right]],
        },
        _ => Vec::new(),
    }
}

/// The number at which the two sides meet.
fn end([left, right]: &[&Expr; 2], letter: Letter, letters: &[Letter]) -> Option<Written> {
    let is_letter = |side: &Expr| matches!(side, Expr::Name(name) if name.text == letter.name());
    if is_letter(left) || is_letter(right) {
        return Written::of(if is_letter(left) { right } else { left }, letters);
    }
    let apart = |number: f64| {
        let side = |side: &Expr| {
            Evaluated::of(side, &|name| match name == letter.name() {
                true => Some(Evaluated { value: Sample::constant(number), is_angle: false }),
                false => Evaluated::of_letter(name, letters),
            })
        };
        Some(side(left)?.value - side(right)?.value)
    };
    let (at_0, at_1, at_2) = (apart(0.0)?, apart(1.0)?, apart(2.0)?);
    let is_linear = (at_1 - at_0).is_near(at_2 - at_1, EXACT);
    let value = at_0.with(at_1, |at_0, at_1| at_0 / (at_0 - at_1));
    let unit = Decimals::within(left).into_iter().chain(Decimals::within(right)).map(|decimals| decimals.unit);
    let is_in_figures = is_in_figures(left) && is_in_figures(right);
    (is_linear && value.is_finite()).then(|| Written { value, unit: unit.reduce(f64::max), is_in_figures })
}
