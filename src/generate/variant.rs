//! One set of numbers of a question, examined: everything that is required of it holds.

use crate::answer::Kind;
use crate::bank::{Find, Givens, Posed, Question, Style, StyleName, Unposed};
use crate::expr::Expr;
use crate::mechanics::{Because, Scene};
use crate::number::{Angle, Places, Range, Value};
use crate::solve::Solution;

use super::rounding::{degrees_round_safely, rounds_safely};

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
    pub givens: Givens,
    /// The collision.
    pub scene: Scene,
    /// Its solution, for all that is asked and required.
    pub solution: Solution,
}

/// Why a set of numbers is not fit for print, in the order in which that is examined.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Unfit {
    /// A requirement on givens does not hold: its place in the style's list.
    Givens(usize),
    /// A formula has no value.
    NoValue,
    /// The collision cannot happen.
    Impossible,
    /// It leaves something open.
    Underdetermined,
    /// Exam methods do not reach it.
    BeyondMethods,
    /// A requirement on results does not hold: its place in the style's list.
    Results(usize),
    /// An answer lies too near a tie to be rounded: its place among all answers.
    Tie(usize),
}

/// A set of parameters with an index below the style's size, examined.
///
/// # Errors
///
/// The first thing that makes it unfit.
pub fn examine(question: &Question, style: &Style, index: u64) -> Result<Variant, Unfit> {
    let parameters = style.parameters_at(index);
    let givens = Givens::new(style, &parameters, &question.scene).map_err(|_| Unfit::NoValue)?;
    for (place, requirement) in style.require.iter().enumerate() {
        let on_results = requirement.is_on_results(&question.scene.unknowns, &|name| givens.contains(name));
        if !on_results && !requirement.holds(&|name| givens.meaning(name)).unwrap_or(false) {
            return Err(Unfit::Givens(place));
        }
    }
    let posed = Posed::new(question, style, givens).map_err(|reason| match reason {
        Unposed::Given(..) | Unposed::Scene(_) => Unfit::NoValue,
        Unposed::Refused(refusal) => match refusal.because {
            Because::Impossible => Unfit::Impossible,
            Because::Underdetermined => Unfit::Underdetermined,
            Because::BeyondMethods => Unfit::BeyondMethods,
        },
    })?;
    for (place, requirement) in style.require.iter().enumerate() {
        let on_results = requirement.is_on_results(&question.scene.unknowns, &|name| posed.givens.contains(name));
        if on_results && !requirement.holds(&|name| posed.meaning(name)).unwrap_or(false) {
            return Err(Unfit::Results(place));
        }
    }
    for (place, answer) in question.parts.iter().flat_map(|part| &part.answers).enumerate() {
        if let Some(places) = answer.accept.places() {
            let safe = match &answer.find {
                _ if answer.kind == Kind::Range => range_rounds_safely(&posed.solution, places),
                Find::Unknown(name) => found_rounds_safely(&posed.solution, name, places),
                find => find.quantities().into_iter().all(|quantity| {
                    let number = posed.solution.number(quantity).map(|value| rounds_safely(&value, places));
                    let angle = || posed.solution.angle(quantity).map(|angle| degrees_round_safely(&angle, places));
                    number.or_else(angle).unwrap_or(true)
                }),
            };
            if !safe {
                return Err(Unfit::Tie(place));
            }
        }
    }
    Ok(variant(question, style, Some(index), parameters, posed))
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
    let style = &question.styles[question.reference_style];
    let givens = Givens::new(style, &question.reference, &question.scene)
        .map_err(|(name, fault)| Unposed::Given(name, fault))?;
    let posed = Posed::new(question, style, givens)?;
    Ok(variant(question, style, None, question.reference.clone(), posed))
}

fn variant(
    question: &Question,
    style: &Style,
    index: Option<u64>,
    parameters: Vec<(String, Expr)>,
    posed: Posed,
) -> Variant {
    let Posed { givens, scene, solution } = posed;
    Variant { question: question.id.clone(), style: style.name, index, parameters, givens, scene, solution }
}
