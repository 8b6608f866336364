//! The answers of a question: what was found, exact and rounded, as a paper prints it and as the key holds it.

use crate::answer::{Accept, Kind};
use crate::bank::{Answer, Find, StyleName};
use crate::expr::{Expr, Meaning, Turn, evaluate, in_degrees, written, written_angle};
use crate::generate::Variant;
use crate::mechanics::{Quantity, Show, Values};
use crate::number::{Angle, Decimal, Letter, Places, Range, Value};
use crate::unit::Unit;

/// One number or angle that was found.
#[derive(Clone, Debug)]
pub enum Size {
    /// A number.
    Number(Value),
    /// An angle.
    Angle(Angle),
}

impl Size {
    /// A quantity of a solved question.
    pub fn of(variant: &Variant, quantity: Quantity) -> Option<Size> {
        let solution = &variant.solution;
        let number = solution.number(quantity).map(Size::Number);
        number.or_else(|| solution.angle(quantity).map(Size::Angle))
    }

    /// The exact form as a teacher writes it; an angle is an angle.
    pub fn exact(&self) -> Expr {
        match self {
            Size::Number(value) => written(value),
            Size::Angle(angle) => written_angle(angle),
        }
    }

    /// The exact form of the exchange format; an angle is a number of degrees.
    pub fn exchange(&self) -> Expr {
        match self {
            Size::Number(value) => written(value),
            Size::Angle(angle) => in_degrees(&written_angle(angle)),
        }
    }

    /// The letters on which it depends.
    pub fn letters(&self) -> Vec<Letter> {
        let letters = match self {
            Size::Number(value) => value.letters(),
            Size::Angle(angle) => angle.letters(),
        };
        letters.into_iter().filter(|letter| !letter.is_constant()).collect()
    }

    /// The certified decimal; `None` where letters remain.
    pub fn rounded(&self, places: &Places) -> Option<Decimal> {
        if !self.letters().is_empty() {
            return None;
        }
        match self {
            Size::Number(value) => value.rounded(places).ok(),
            Size::Angle(angle) => angle.rounded(places).ok(),
        }
    }

    /// Is it a number of so few figures that rounding does not change it?
    pub fn is_short(&self, places: &Places) -> bool {
        let exact = match self {
            Size::Number(value) => value.as_fraction().cloned(),
            Size::Angle(angle) => angle.whole_degrees(),
        };
        exact.is_some_and(|exact| self.rounded(places).is_some_and(|rounded| rounded.to_fraction() == exact))
    }
}

/// What an answer comes to: one size, or the two components of a vector. Of a found letter that something is
/// shown about, it is that which is shown.
pub fn sizes(answer: &Answer, variant: &Variant) -> Vec<Size> {
    if answer.kind == Kind::Range {
        // From where to where is no size.
        return Vec::new();
    }
    match &answer.find {
        Find::Quantity(quantity) => Size::of(variant, *quantity).into_iter().collect(),
        Find::Vector(x, y) => [*x, *y].into_iter().filter_map(|quantity| Size::of(variant, quantity)).collect(),
        Find::Unknown(name) => unknown(answer, name, variant).into_iter().collect(),
    }
}

fn unknown(answer: &Answer, name: &str, variant: &Variant) -> Option<Size> {
    let meaning = |name: &str| found(variant, name).or_else(|| variant.givens.meaning(name));
    match &answer.show {
        Some(show) => match evaluate(show, &meaning).ok()? {
            Meaning::Number(value) => Some(Size::Number(value)),
            _ => None,
        },
        None => letter(variant, name),
    }
}

/// A letter that was to be found.
pub fn letter(variant: &Variant, name: &str) -> Option<Size> {
    let (letter, value) = variant.solution.found().iter().find(|(letter, _)| letter.name() == name)?;
    match letter.range() {
        Range::Acute => Angle::of(value, &Value::ONE).map(Size::Angle),
        _ => Some(Size::Number(value.clone())),
    }
}

fn found(variant: &Variant, name: &str) -> Option<Meaning> {
    letter(variant, name).map(|size| match size {
        Size::Number(value) => Meaning::Number(value),
        Size::Angle(angle) => Meaning::Angle(Turn::of(angle)),
    })
}

/// The exact form of a whole answer; the direction of a line has whole components where it can.
pub fn exact(answer: &Answer, variant: &Variant) -> Option<Expr> {
    if answer.kind == Kind::Range {
        return variant.solution.range().map(Values::written);
    }
    if answer.kind == Kind::Line {
        let solution = &variant.solution;
        return Some(Show::new(solution.scene(), solution.known(), &[]).line_direction());
    }
    match sizes(answer, variant).as_slice() {
        [] => None,
        [one] => Some(one.exact()),
        [x, y, ..] => Some(Expr::Vector(Box::new(x.exact()), Box::new(y.exact()))),
    }
}

/// The rounded form, where the answer may be given rounded and is not short already.
pub fn rounded(answer: &Answer, variant: &Variant) -> Option<Expr> {
    let places = answer.accept(variant.style).places()?;
    if matches!(answer.kind, Kind::Line | Kind::Range) {
        return None;
    }
    let sizes = sizes(answer, variant);
    if sizes.iter().all(|size| size.is_short(places)) {
        return None;
    }
    let mut each = sizes.iter().map(|size| {
        if size.is_short(places) { Some(size.exact()) } else { Some(Expr::Decimal(size.rounded(places)?.to_string())) }
    });
    match (each.next()??, each.next()) {
        (x, Some(y)) => Some(Expr::Vector(Box::new(x), Box::new(y?))),
        (one, None) => Some(one),
    }
}

/// Does the question ask for the exact form? Where its numbers are surds it does, but for an angle, which nobody would
/// write as an inverse tangent.
pub fn asks_exact(answer: &Answer, variant: &Variant) -> bool {
    let is_number = |size: &Size| matches!(size, Size::Number(_));
    *answer.accept(variant.style) == Accept::Exact
        || (variant.style == StyleName::Exact && sizes(answer, variant).iter().all(is_number))
}

/// The unit in which the answer is stated: none where its letters were given without.
pub fn unit(answer: &Answer, variant: &Variant, with_units: &[String]) -> Unit {
    let unit = match &answer.find {
        Find::Quantity(quantity) | Find::Vector(quantity, _) => quantity.unit(),
        Find::Unknown(name) if name.ends_with(".mass") => Unit::Kilogram,
        Find::Unknown(_) => match sizes(answer, variant).as_slice() {
            [Size::Angle(_)] => Unit::Degree,
            _ => Unit::None,
        },
    };
    let letters: Vec<Letter> = sizes(answer, variant).iter().flat_map(Size::letters).collect();
    let given = |letter: &Letter| with_units.iter().any(|name| name == letter.name());
    if answer.kind == Kind::Line || (unit != Unit::Degree && !letters.iter().all(given)) { Unit::None } else { unit }
}
