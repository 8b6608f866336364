//! The words of a question alone, with the numbers of a variant: what an author wrote, without diagrams and working.

use super::working::result;
use super::{compose, wording};
use crate::bank::{Question, Style};
use crate::expr::Text;
use crate::generate::Variant;

/// The words that a variant prints of what its author wrote.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Words {
    /// The paragraphs before the first part, the style's note at their end.
    pub stem: Vec<Text>,
    /// What each part asks.
    pub asks: Vec<Text>,
    /// Of each answer its name and the words that complete it; of each mark what earns it and what is condoned.
    pub said: Vec<Text>,
}

/// Puts the numbers of a variant into the words of its question. Much cheaper than [`compose`](compose()), so that
/// every variant of a bank can be read.
pub fn words(question: &Question, style: &Style, variant: &Variant) -> Words {
    let filled = |text: &Text| wording::sentence(text, variant, None);
    let mut words = Words { stem: wording::paragraphs(&style.stem, variant, None), ..Words::default() };
    words.stem.extend((!style.note.is_empty()).then(|| filled(&style.note)));
    for part in &question.parts {
        let shown = part.answers.iter().find_map(|answer| result(answer, variant));
        words.asks.push(wording::joined(wording::paragraphs(&part.ask, variant, shown.as_ref())));
        for answer in &part.answers {
            words.said.extend([compose::name(answer, variant), filled(&answer.phrase)]);
        }
        words.said.extend(part.marks.iter().flat_map(|mark| [&mark.text, &mark.note]).flatten().map(filled));
    }
    words.said.retain(|text| !text.is_empty());
    words
}
