//! What a student said, as far as it can be read.

use super::ReferenceLine;
use crate::expr::Expr;
use crate::number::Letter;

/// The letters that the question has, by which names are told apart: where it has `m` and `u`, `mu` is their product.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Vocabulary {
    /// The question's letters; the physical range of each is its own.
    pub letters: Vec<Letter>,
    /// Are **i** and **j** unit vectors here?
    pub vectors: bool,
}

/// One way to read an answer.
#[derive(Clone, Debug, PartialEq)]
pub struct Reading {
    /// What is stated, in order: `A = √13, B = √20` states two things.
    pub statements: Vec<Statement>,
    /// The reading in the notation of a terminal, for the report: `(5/2)i + (1/2)j`.
    pub printed: String,
    /// Where the notation was open, what was decided: `u/2v read as u/(2v)`. Empty if there was no doubt.
    pub decided: Vec<String>,
}

/// A thing stated, perhaps by a chain of equals signs: `v = 25/7 = 3.6`.
#[derive(Clone, Debug, PartialEq)]
pub struct Statement {
    /// What the student calls it, if anything.
    pub label: Option<Label>,
    /// What is said of it; more than one in a chain.
    pub said: Vec<Said>,
}

impl Reading {
    /// Was a comma between figures read as a decimal point?
    pub(in crate::mark) fn has_decimal_comma(&self) -> bool {
        let figures = |text: &str| text.bytes().all(|sign| sign.is_ascii_digit() || sign == b',');
        let mut decided = self.decided.iter().filter_map(|decided| decided.split_once(" read as "));
        decided.any(|(typed, read)| typed.contains(',') && figures(typed) && read.contains('.'))
    }

    /// Says of every value that it is crossed out.
    pub(super) fn take_back(&mut self) {
        let said = self.statements.iter_mut().flat_map(|statement| &mut statement.said);
        said.for_each(|said| said.remarks.push("crossed out".to_owned()));
    }

    /// The words beside its values that are neither unit nor line.
    pub(crate) fn remarks(&self) -> impl Iterator<Item = &String> + Clone {
        self.statements.iter().flat_map(Statement::remarks)
    }
}

impl Statement {
    /// The words beside its values that are neither unit nor line.
    pub(crate) fn remarks(&self) -> impl Iterator<Item = &String> + Clone {
        self.said.iter().flat_map(|said| &said.remarks)
    }
}

/// What stands before the first equals sign or colon.
#[derive(Clone, Debug, PartialEq)]
pub struct Label {
    /// As it was typed, without blanks at its ends: `v_A`, `speed of A`, `KE lost`, `ΔKE`.
    pub typed: String,
    /// The same as an expression, where it is one: `tan(theta)`, `v_A`.
    pub expr: Option<Expr>,
}

/// One value.
#[derive(Clone, Debug, PartialEq)]
pub struct Said {
    /// The value.
    pub form: Form,
    /// Its unit, where one stands there.
    pub unit: Option<SaidUnit>,
    /// The line from which an angle or direction is said to be measured.
    pub reference: Option<ReferenceLine>,
    /// Other words around it that are neither, in lower case: `as required`, `both move to the right`.
    pub remarks: Vec<String>,
}

/// A value by its form. Decimals keep their digits: they are [`Expr::Decimal`].
#[derive(Clone, Debug, PartialEq)]
pub enum Form {
    /// A number or a formula in letters. Bare arguments of sines are in degrees.
    Value(Expr),
    /// `23.3%`: the number before the sign.
    Percentage(Expr),
    /// Components along **i** and **j**.
    Vector(Expr, Expr, Notation),
    /// A number plus a vector, as `4 + j`: written, but nothing.
    Mixed(Expr),
    /// `2 : 3`
    Ratio(Expr, Expr),
    /// An equation or inequality that is not the statement of a value: `3v + 2w = 4u`.
    Equation(Expr),
    /// A range of values by its ends, without the letter: `(1/3, 1]`, `more than 3`. What has no end there goes on for
    /// ever.
    Range(Option<End>, Option<End>),
    /// A gradient: the direction of a line.
    Gradient(Expr),
    /// `at rest`, `stationary`, `does not move`.
    AtRest,
    /// Words alone that name a direction: `along the line of centres`.
    Direction,
}

/// An end of a range.
#[derive(Clone, Debug, PartialEq)]
pub struct End {
    /// Where it is.
    pub at: Expr,
    /// Does it belong to the range? Words such as `from 1 to 3` do not say.
    pub included: Option<bool>,
}

/// How a vector was written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Notation {
    /// `4i + j`
    UnitVectors,
    /// `(4, 1)`
    Coordinates,
    /// A column, or `(4 1)`.
    Column,
    /// `2 m/s parallel to i`
    Words,
}

/// A unit as it was typed, and what it is a multiple of.
#[derive(Clone, Debug, PartialEq)]
pub struct SaidUnit {
    /// As it was typed: `ms^-1`, `N/s`.
    pub typed: String,
    /// Powers of kilogram, metre, second and radian: `[1, 1, -1, 0]` for N s. A degree counts as an angle.
    pub dimension: [i8; 4],
    /// How many of the base unit it is, exactly: 1000 for kJ; for a degree it is left to the kind, and is one.
    pub scale: Expr,
    /// Is it degrees?
    pub degrees: bool,
}

/// Why an answer goes to a person.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Unreadable {
    /// There is nothing.
    Blank,
    /// Longer than [`super::LONGEST`] bytes.
    TooLong,
    /// A sign that makes no sense where it stands: its place in the text, and what is wrong.
    Sign(usize, String),
}
