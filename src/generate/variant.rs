//! A question with numbers that are fit for print, and why numbers are not.

use std::sync::Arc;

use crate::answer::Kind;
use crate::bank::{Answer, Find, Givens, Posed, Question, Style, StyleName, Unposed};
use crate::expr::Expr;
use crate::mechanics::Scene;
use crate::number::{Angle, Places, Range, Value};
use crate::solve::Solution;

use super::rounding::{degrees_round_safely, direction_rounds_safely, rounds_safely};

/// A question with numbers that are fit for print.
#[derive(Clone, Debug)]
pub struct Variant {
    /// The question's id.
    pub question: String,
    /// The style.
    pub style: StyleName,
    /// Which of the style's sets of parameters it is; none for the reference numbers.
    pub index: Option<u64>,
    /// The parameters in the order of the file.
    pub parameters: Vec<(String, Expr)>,
    /// What every given name stands for, derived names included.
    pub givens: Arc<Givens>,
    /// The collision.
    pub scene: Arc<Scene>,
    /// Its solution, for all that is asked and required.
    pub solution: Arc<Solution>,
}

/// Why a set of numbers is not fit for print, in the order in which that is examined.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Unfit {
    /// A requirement on givens does not hold: its place in the style's list.
    Givens(usize),
    /// A formula has no value.
    NoValue,
    /// A requirement on results does not hold: its place in the style's list.
    Results(usize),
    /// The collision cannot happen.
    Impossible,
    /// It leaves something open.
    Underdetermined,
    /// Exam methods do not reach it.
    BeyondMethods,
    /// An answer lies too near a tie to be rounded: its place among all answers.
    Tie(usize),
}

/// Is an answer clear of a tie at the figures to which it may be rounded in a style?
pub fn answer_rounds_safely(answer: &Answer, style: StyleName, solution: &Solution) -> bool {
    let Some(places) = answer.accept(style).places() else { return true };
    match &answer.find {
        _ if answer.kind == Kind::Range => range_rounds_safely(solution, places),
        Find::Unknown(name) => found_rounds_safely(solution, name, places),
        find => find.quantities().into_iter().all(|quantity| {
            let number = solution.number(quantity).map(|value| rounds_safely(&value, places));
            let angle = || solution.known().direction(quantity).map(|of| direction_rounds_safely(&of, places));
            number.or_else(angle).unwrap_or(true)
        }),
    }
}

/// Both ends of a range.
fn range_rounds_safely(solution: &Solution, places: &Places) -> bool {
    let ends = solution.range().into_iter().flat_map(|values| values.span.low.iter().chain(&values.span.high));
    ends.into_iter().all(|end| rounds_safely(&end.value, places))
}

/// The value of a letter that was found; for an angle its degrees.
fn found_rounds_safely(solution: &Solution, name: &str, places: &Places) -> bool {
    let Some((letter, value)) = solution.found().iter().find(|(letter, _)| letter.name() == name) else { return true };
    match letter.range() {
        Range::Acute => Angle::of(value, &Value::ONE).is_none_or(|angle| degrees_round_safely(&angle, places)),
        _ => rounds_safely(value, places),
    }
}

/// The question with its reference numbers. They were examined when its file was read, but need not meet the
/// requirements on random numbers.
///
/// # Errors
///
/// Why they do not make a question, if the question was not made by [`crate::bank::read_question`].
pub fn reference(question: &Question) -> Result<Variant, Unposed> {
    with_numbers(question, &question.styles[question.reference_style], &question.reference)
}

/// A question with any numbers, which need not lie in the domains or meet the requirements.
///
/// # Errors
///
/// Why they do not make a question.
pub fn with_numbers(question: &Question, style: &Style, numbers: &[(String, Expr)]) -> Result<Variant, Unposed> {
    let givens = Givens::new(style, numbers, &question.scene).map_err(|(name, fault)| Unposed::Given(name, fault))?;
    let posed = Posed::new(question, style, givens)?;
    Ok(variant(question, style, None, numbers.to_vec(), posed))
}

/// What was posed, as a variant.
pub(super) fn variant(
    question: &Question,
    style: &Style,
    index: Option<u64>,
    parameters: Vec<(String, Expr)>,
    posed: Posed,
) -> Variant {
    let Posed { givens, scene, solution } = posed;
    Variant { question: question.id.clone(), style: style.name, index, parameters, givens, scene, solution }
}
