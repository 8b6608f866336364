//! Two answers of a part in each other's places: then that is what is wrong with both, whatever slip comes to the same.

use std::rc::Rc;

use super::follow::is_near_miss;
use super::memory::Judged;
use crate::mark::award::{Cause, MarkedAnswer};
use crate::mark::judging::{Verdict, judge};
use crate::mark::key::KeyedPart;
use crate::mark::slips::{ANOTHER_ANSWER, OTHER_SPHERE};

/// Names it first for both.
pub(super) fn name_first(part: &KeyedPart, answers: &mut [MarkedAnswer], judged: &[Rc<Judged>]) {
    let is_open = |place: usize| {
        let judgement = &answers[place].judgement;
        judged[place].readings.is_some() && (judgement.verdict == Verdict::Wrong || is_near_miss(judgement))
    };
    let open: Vec<usize> = (0..part.blanks.len().min(judged.len())).filter(|place| is_open(*place)).collect();
    let is_answer_to = |own: usize, other: usize| {
        let readings = judged[own].readings.clone().unwrap_or_default();
        judge(&part.blanks[other].model, &Ok(readings)).verdict == Verdict::Correct
    };
    for (at, one) in open.iter().enumerate() {
        for other in &open[at + 1..] {
            if is_answer_to(*one, *other) && is_answer_to(*other, *one) {
                [*one, *other].into_iter().for_each(|place| put_first(&mut answers[place]));
            }
        }
    }
}

fn put_first(answer: &mut MarkedAnswer) {
    // It is another value altogether, and none that is only not accurate.
    answer.judgement = answer.judgement.clone().simply_wrong();
    let is_it = |cause: &Cause| [OTHER_SPHERE.tag, ANOTHER_ANSWER.tag].contains(&cause.tag.as_str());
    let known = answer.causes.iter().position(is_it).map(|place| answer.causes.remove(place));
    let said = || Cause {
        tag: ANOTHER_ANSWER.tag.to_owned(),
        sentence: ANOTHER_ANSWER.sentence.to_owned(),
        probable: Vec::new(),
    };
    answer.causes.insert(0, known.unwrap_or_else(said));
}
