//! A question with numbers becomes what is printed of it: words, answers, working and mark scheme.

use super::working::{self, result};
use super::{PrintedAnswer, PrintedPart, PrintedQuestion, answer, legible, scheme, wording};
use crate::bank::{Answer, Question};
use crate::diagram::{self, Diagram, Manner};
use crate::expr::{Expr, Piece, Text};
use crate::generate::Variant;
use crate::mechanics::Quantity;
use crate::number::Fraction;

/// Prints a question with the numbers of a variant as the question of this number on the sheet.
///
/// ```
/// use carom::bank::{read_question, shipped};
/// use carom::diagnostic::Source;
/// use carom::expr::print::unicode;
/// use carom::generate::reference;
/// use carom::paper::compose;
///
/// let (id, text) = shipped().find(|(id, _)| *id == "rest/speeds-and-directions").unwrap();
/// let question = read_question(id, &Source::new(id, text)).unwrap();
/// let printed = compose(&question, &reference(&question).unwrap(), 1);
/// let speed = &printed.parts[0].answers[0];
/// assert_eq!(unicode(speed.exact.as_ref().unwrap()), "4√39/9");
/// assert_eq!(unicode(speed.rounded.as_ref().unwrap()), "2.78");
/// ```
pub fn compose(question: &Question, variant: &Variant, number: usize) -> PrintedQuestion {
    let style = match variant.index {
        Some(_) => question.style(variant.style),
        None => question.styles.get(question.reference_style),
    };
    let mut stem = style.map(|style| wording::paragraphs(&style.stem, variant, None)).unwrap_or_default();
    stem.extend(
        style.filter(|style| !style.note.is_empty()).map(|style| wording::sentence(&style.note, variant, None)),
    );
    let with_units = wording::letters_with_units(&stem);
    let angles = wording::named_angles(&stem);
    let after_walls = working::angles_after_walls(question);
    let vectors = wording::has_unit_vectors(&stem);
    let manner = Manner { vectors, with_units: &with_units, angles: &angles, after_walls: &after_walls };
    let worked = working::work(question, variant, manner);
    // Letters that are found are letters until they are.
    let finding = variant.solution.finds_unknowns();
    let worked_scene = if finding { &variant.scene } else { variant.solution.scene() };
    let mut pictures = (0..).zip(diagram::solution(worked_scene, manner));
    let of_first = pictures.next().map(|(_, pictures)| pictures);
    let mut of_later: Vec<(u8, Vec<Diagram>)> = pictures.collect();
    let mut last = 0;
    let mut parts = Vec::new();
    for (place, part) in worked.iter().enumerate() {
        let shown = part.part.answers.iter().find_map(|answer| result(answer, variant));
        let asks = wording::paragraphs(&part.part.ask, variant, shown.as_ref());
        let here = of_later.extract_if(.., |(impact, _)| part.works_on(*impact));
        parts.push(legible::part(PrintedPart {
            label: part.part.label.clone(),
            ask: wording::joined(asks),
            answers: part.part.answers.iter().map(|answer| printed_answer(answer, variant, &with_units)).collect(),
            solution_diagrams: here.flat_map(|(_, pictures)| pictures).collect(),
            working: part.lines(variant, &mut last),
            scheme: scheme::rows(&worked[..=place], variant, &with_units),
        }));
    }
    PrintedQuestion {
        number,
        id: question.id.clone(),
        mirrors: question.mirrors.clone(),
        stem,
        diagrams: diagram::given(&variant.scene, manner),
        solution_diagrams: of_first.unwrap_or_default(),
        parts,
    }
}

fn printed_answer(answer: &Answer, variant: &Variant, with_units: &[String]) -> PrintedAnswer {
    let phrase = wording::sentence(&answer.phrase, variant, None);
    let (exact, phrase) = match direction_in_words(answer, variant) {
        Some(words) => (None, Text::words(words)),
        None => (answer::exact(answer, variant), phrase),
    };
    PrintedAnswer {
        name: name(answer, variant),
        rounded: exact.as_ref().and_then(|_| answer::rounded(answer, variant)),
        exact,
        asks_exact: answer::asks_exact(answer, variant),
        unit: answer::unit(answer, variant, with_units),
        phrase,
    }
}

/// What an answer is called, its numbers put in.
pub fn name(answer: &Answer, variant: &Variant) -> Text {
    let mut name = wording::sentence(&answer.name, variant, None);
    // A formula at the very front would be the left side of its own value.
    if let [Piece::Formula(Expr::Name(_) | Expr::Call(..) | Expr::Power(..))] = name.0.as_slice() {
        name = Text(vec![Piece::Words("value of ".to_owned()), name.0.remove(0)]);
    }
    name
}

/// A direction along the line of centres or perpendicular to it needs no angle.
fn direction_in_words(answer: &Answer, variant: &Variant) -> Option<&'static str> {
    let quantity = *answer.find.quantities().first()?;
    let Quantity::AngleToLine(..) = quantity.of_its_impact() else { return None };
    let degrees = variant.solution.angle(quantity)?.whole_degrees()?;
    if degrees.is_zero() {
        Some("along the line of centres")
    } else if degrees == Fraction::from(90) {
        Some("perpendicular to the line of centres")
    } else {
        None
    }
}
