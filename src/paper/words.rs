//! The words of a question alone, with the numbers of a variant: what an author wrote, without diagrams and working.

use std::borrow::Cow;

use super::working::result;
use super::{compose, wording};
use crate::bank::{Question, Style};
use crate::expr::Text;
use crate::generate::Variant;

/// The words that a variant prints of what its author wrote; what has no formula in it stands as it was written.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Words<'q> {
    /// The paragraphs before the first part, the style's note at their end.
    pub stem: Vec<Cow<'q, Text>>,
    /// What each part asks.
    pub asks: Vec<Cow<'q, Text>>,
    /// Of each answer its name and the words that complete it; of each mark what earns it and what is condoned.
    pub said: Vec<Cow<'q, Text>>,
}

/// Puts the numbers of a variant into the words of its question. Much cheaper than [`compose`](compose()), so that
/// every variant of a bank can be read.
pub fn words<'q>(question: &'q Question, style: &'q Style, variant: &Variant) -> Words<'q> {
    let filled = |text: &'q Text| wording::put_in(text, variant, None);
    let mut words = Words { stem: style.stem.iter().map(filled).collect(), ..Words::default() };
    words.stem.extend((!style.note.is_empty()).then(|| filled(&style.note)));
    for part in &question.parts {
        let shown = part.answers.iter().find_map(|answer| result(answer, variant));
        let shown = shown.as_ref();
        words.asks.push(match part.ask.as_slice() {
            [only] => wording::put_in(only, variant, shown),
            several => Cow::Owned(wording::joined(wording::paragraphs(several, variant, shown))),
        });
        for answer in &part.answers {
            words.said.extend([Cow::Owned(compose::name(answer, variant)), filled(&answer.phrase)]);
        }
        words.said.extend(part.marks.iter().flat_map(|mark| [&mark.text, &mark.note]).flatten().map(filled));
    }
    words.said.retain(|text| !text.is_empty());
    words
}
