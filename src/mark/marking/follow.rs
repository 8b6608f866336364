//! Answers followed through: right for the values that the student found before.

use crate::bank::{Code, EarnedFor, Find};
use crate::expr::Expr;
use crate::mark::award::MarkedAnswer;
use crate::mark::judging::{Judgement, Model, Verdict, judge};
use crate::mark::key::{KeyedPart, KeyedQuestion};
use crate::mark::reading::Reading;
use crate::mark::working::Examined;
use crate::mechanics::Datum;

/// For each blank the verdict against what follows from the student's own values, where the scheme follows through.
pub(super) fn answers(
    question: &KeyedQuestion,
    part: &KeyedPart,
    answers: &[MarkedAnswer],
    readings: &[Option<Vec<Reading>>],
    examined: &Examined,
) -> Vec<Option<Judgement>> {
    let each = part.blanks.iter().zip(answers).zip(readings);
    each.map(|((blank, answer), readings)| {
        let Find::Quantity(quantity) = blank.find else { return None };
        let follows = part
            .scheme
            .iter()
            .any(|mark| mark.code == Code::A1FollowThrough && mark.earned_for == EarnedFor::Quantity(quantity));
        let open = follows && answer.judgement.verdict != Verdict::Correct && !examined.theirs.0.is_empty();
        // A formula in letters is followed at points only, which is no proof.
        let [known] = examined.followed.as_slice() else { return None };
        let Some(Datum::Number(value)) = known.0.get(&quantity).filter(|_| open && question.letters.is_empty()) else {
            return None;
        };
        let value = Expr::Decimal(format!("{:.12}", value.abs()));
        let model = Model { value, ..blank.model.clone() };
        let judgement = judge(&model, &Ok(readings.clone()?));
        (judgement.verdict == Verdict::Correct).then_some(judgement)
    })
    .collect()
}
