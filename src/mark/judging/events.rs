//! What is said to happen beside a value: that spheres meet again or do not, that another sphere turns back.

use crate::answer::Kind;
use crate::mark::reading::{FURTHER, MEETING, NEVER, Reading, Statement};
use crate::mechanics::Sphere;

use super::otherwise::spheres_in_remark;
use super::spheres::named_sphere;
use super::{Model, sense, sides, sorts};

/// Is one of the words among those of a text? Of `don't` it is `don` that stands there.
fn has(text: &str, wanted: &[&str]) -> bool {
    let is_wanted = |word: &str| wanted.iter().any(|wanted| wanted.split('\'').next() == Some(word));
    sorts::words(text).any(is_wanted)
}

/// Does a remark say that nothing meets?
pub(super) fn denies_a_meeting(remark: &str) -> bool {
    has(remark, &NEVER) && says_that_they_meet(remark)
}

/// `after the first collision` and `after B has hit the wall` tell when, and not what happens; `A hits B once` and `B hits C`
/// speak of what has happened.
fn says_that_they_meet(text: &str) -> bool {
    (has(text, &MEETING) || has(text, &["again"])) && !has(text, &["before", "after", "wall", "once", "c"])
}

/// Is another collision spoken of beside what is no range: that there is none, or which of several it is?
pub(super) fn is_of_another_meeting(model: &Model, reading: &Reading) -> bool {
    let is_other = |remark: &String| {
        denies_a_meeting(remark) || (has(remark, &MEETING) || has(remark, &["again"])) && has(remark, &FURTHER)
    };
    model.kind != Kind::Range && reading.remarks().any(is_other)
}

/// Do words beside a range speak of something else than what is to happen: of the other sphere that turns back, of a
/// collision where there is to be none?
pub(super) fn is_of_another_event(model: &Model, statements: &[Statement]) -> bool {
    let labels = statements.iter().filter_map(|statement| statement.label.as_ref()).map(|label| &label.typed);
    let texts: Vec<&String> = labels.chain(statements.iter().flat_map(Statement::remarks)).collect();
    let said = sides::says_which_way(&texts);
    let is_another_way = match model.turns_back {
        Some(turns_back) => said.is_some_and(|said| said != turns_back),
        // Where the letter is to be such that something else happens.
        None => said.is_some() && model.meet_again.is_some(),
    };
    // `A hits B and rebounds` is of A.
    let named: Vec<Sphere> = texts.iter().flat_map(|text| spheres_in_remark(text)).collect();
    let is_of_stranger = || !named.is_empty() && named.iter().all(|sphere| model.strangers.contains(sphere));
    let texts: Vec<String> = texts.iter().map(|text| text.to_lowercase()).collect();
    let says = |says: fn(&str) -> bool| texts.iter().any(|text| says(text));
    let is_meeting = says(says_that_they_meet).then(|| !says(|text| has(text, &NEVER)));
    let goes = statements.iter().flat_map(|statement| {
        let senses = statement.said.iter().filter_map(|said| said.reference?.sense());
        senses.filter_map(|sense| Some((named_sphere(statement)?, sense)))
    });
    // `e > 7/8, so A moves towards B`
    let mut is_towards_another = goes.filter(|_| model.turns_back.is_some()).map(|(sphere, sense)| {
        model.strangers.contains(&sphere) || sense::agrees(Some(sense), model.turns_back) == Some(false)
    });
    is_another_way
        || is_towards_another.any(|is_another| is_another)
        || (said.is_some() && is_of_stranger())
        // Where nobody says what is to happen, it is hardly nothing.
        || is_meeting.is_some_and(|said| said != model.meet_again.unwrap_or(true))
}
