//! Results that the author has printed by hand in the words of a part: they must be what is found.

use super::said::Seen;
use crate::answer::Kind;
use crate::bank::Answer;
use crate::examine::Finding;
use crate::expr::{Expr, Meaning, Piece, Relation, Turn, evaluate, print, written};
use crate::paper::{Size, letter, sizes};

impl Seen<'_> {
    /// Equations for the left side of what is to be shown, whose right side is something else.
    pub(super) fn results(&self, findings: &mut Vec<Finding>) {
        for (place, part) in self.question.parts.iter().enumerate() {
            let shown = part.answers.iter().enumerate().filter(|(_, answer)| answer.kind == Kind::Shown);
            for (row, answer) in shown {
                let mut pieces = part.ask.iter().flat_map(|text| &text.0);
                let help = "print `{display: result}`, which is worked out, in its place; or mend what was typed";
                let found = pieces.find_map(|piece| self.other_result(piece, answer));
                findings.extend(found.map(|message| self.finding(message, "", help).at_row(place, "answers", row)));
            }
        }
    }

    /// What is amiss with an equation for what is to be shown.
    fn other_result(&self, piece: &Piece, answer: &Answer) -> Option<String> {
        let (Piece::Formula(typed) | Piece::Display(typed)) = piece else { return None };
        let Expr::Relation(left, Relation::Equal, right) = typed else { return None };
        let show = answer.show.as_ref().filter(|show| print::plain(show) == print::plain(left))?;
        let sizes = sizes(answer, self.variant);
        let [Size::Number(has)] = sizes.as_slice() else { return None };
        let amiss = match evaluate(right, &|name| self.found(name).or_else(|| self.variant.givens.meaning(name))) {
            Ok(Meaning::Number(said)) if said.equals(has) => return None,
            Ok(Meaning::Number(_)) => "it is not so",
            _ => "its right side is no number",
        };
        let (typed, show, has) = (print::plain(typed), print::plain(show), print::unicode(&written(has)));
        Some(format!("the words print `{typed}`, and {amiss}: `{show}` is {has}"))
    }

    /// What a letter that was to be found stands for.
    fn found(&self, name: &str) -> Option<Meaning> {
        letter(self.variant, name).map(|size| match size {
            Size::Number(value) => Meaning::Number(value),
            Size::Angle(angle) => Meaning::Angle(Turn::of(angle)),
        })
    }
}
