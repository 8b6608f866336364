//! A right answer beside working that comes to another value: it has not come from there.

use super::memory::Lines;
use crate::bank::Find;
use crate::mark::award::MarkedAnswer;
use crate::mark::judging::{Verdict, is_named, judge};
use crate::mark::key::{KeyedBlank, KeyedPart};
use crate::mark::reading::{Reading, Statement};
use crate::mark::script::PartScript;
use crate::mechanics::Quantity;

/// Of answers that are right though the last value that the working has under their name is not, says so: they are partly
/// right, and imply nothing.
pub(super) fn contradict(part: &KeyedPart, script: &PartScript, answers: &mut [MarkedAnswer]) {
    let lines = Lines::default();
    for (place, answer) in answers.iter_mut().enumerate() {
        let is_typed = script.answers.iter().any(|(_, typed)| Some(typed) == answer.typed.as_ref());
        if answer.judgement.verdict == Verdict::Correct && is_typed && comes_to_another(part, place, script, &lines) {
            answer.judgement.verdict = Verdict::Partial;
            answer.judgement.note = Some("contradicted");
            answer.judgement.feedback = "This is the right value, but your working comes to another.".to_owned();
        }
    }
}

/// Is the last value that the working states under the name of a blank plainly another? One that is rounded from the value
/// before it, `m ≈ 2` after `m = 2.06`, is no other.
fn comes_to_another(part: &KeyedPart, place: usize, script: &PartScript, lines: &Lines) -> bool {
    let blank = &part.blanks[place];
    if !has_own_name(blank) {
        return false;
    }
    // What is about equal to the value before it is no other; what has no equals sign at all is not looked at.
    let typed = script.working.iter().flat_map(|cell| cell.lines()).map(str::trim);
    let said = typed.filter(|line| line.contains('=') && !line.contains("~~")).filter_map(|line| {
        let readings = lines.read(line, &blank.model.vocabulary);
        let reading = readings.as_ref().as_ref().ok()?.first()?;
        let is_named = reading.statements.iter().any(|statement| is_called(part, blank, statement));
        // Of two roots, `k = 8 or -24`, one is enough.
        let is_wrong = |statement: &Statement| each(statement).all(|said| verdict(blank, said) == Verdict::Wrong);
        is_named.then(|| reading.statements.iter().all(is_wrong))
    });
    said.last().unwrap_or(false)
}

/// Is there a name that belongs to what is asked alone? `v` may be a component where a speed is asked, and θ any angle.
fn has_own_name(blank: &KeyedBlank) -> bool {
    match &blank.find {
        Find::Unknown(_) => true,
        Find::Quantity(quantity) => matches!(
            quantity.of_its_impact(),
            Quantity::Restitution
                | Quantity::ImpulseMagnitude
                | Quantity::Impulse(..)
                | Quantity::EnergyLost
                | Quantity::FractionLost
        ),
        _ => false,
    }
}

fn is_called(part: &KeyedPart, blank: &KeyedBlank, statement: &Statement) -> bool {
    match &blank.find {
        Find::Unknown(name) => statement.label.as_ref().is_some_and(|label| label.typed.trim() == name),
        _ => {
            let mut others = part.blanks.iter().filter(|other| other.name != blank.name);
            is_named(&blank.model, statement) && !others.any(|other| is_named(&other.model, statement))
        }
    }
}

/// What a statement says, a value each.
fn each(statement: &Statement) -> impl Iterator<Item = Statement> + '_ {
    statement.said.iter().map(|said| Statement { said: vec![said.clone()], ..statement.clone() })
}

/// The verdict on a value by itself.
fn verdict(blank: &KeyedBlank, statement: Statement) -> Verdict {
    let reading = Reading { statements: vec![statement], printed: String::new(), decided: Vec::new() };
    judge(&blank.model, &Ok(vec![reading])).verdict
}
