//! Which of the values that a student states is the answer.
//!
//! * Of several statements those labelled with the sphere that is asked count; else the last, if each has its own label.
//! * Two that are not labelled are rivals: they score only if all of them do, unless the last is concluded from the others.

use crate::answer::Kind;
use crate::expr::Expr;
use crate::mark::reading::{Form, Label, Reading, Said, Statement};
use crate::mechanics::{Moment, Quantity, Sphere};

use super::chain::chain;
use super::finding::Finding;
use super::left_side::{self, Left};
use super::several::{
    are_of_both_spheres, by_custom, is_chosen_from_the_others, is_from_one_to_another, is_made_of_the_others,
    is_rounded_from,
};
use super::spheres::{self, SPHERES, named_sphere, sphere};
use super::{Model, Note, called, moments, velocity};

/// How a kind judges one value.
pub(super) type One<'a> = &'a dyn Fn(&Said, Option<&Label>) -> Finding;

/// Judges a reading where one value is asked.
pub(super) fn judge(model: &Model, reading: &Reading, one: One) -> Finding {
    let statements: Vec<&Statement> = reading.statements.iter().filter(|s| !s.said.is_empty()).collect();
    match statements.as_slice() {
        [] => Finding::unreadable(Note::CannotBeRead),
        [single] => chain(model, single, one),
        several => choose(model, several, one),
    }
}

/// Two things said one after the other, neither of them as the rival of the other.
pub(super) fn pair(reading: &Reading) -> Option<[(&Statement, &Said); 2]> {
    let [first, second] = reading.statements.as_slice() else { return None };
    fn single(statement: &Statement) -> Option<(&Statement, &Said)> {
        match statement.said.as_slice() {
            [said] => Some((statement, said)),
            _ => None,
        }
    }
    let pair = [single(first)?, single(second)?];
    (!pair.iter().any(|(_, said)| is_rival(said))).then_some(pair)
}

/// Is it offered in place of another?
pub(super) fn is_rival(said: &Said) -> bool {
    let mut words = said.remarks.iter().flat_map(|remark| remark.split_whitespace());
    words.any(|word| matches!(word, "or" | "alternatively"))
}

/// The value that is said, if it has neither a name nor a direction.
pub(super) fn unnamed<'s>((statement, said): (&Statement, &'s Said)) -> Option<&'s Expr> {
    match &said.form {
        Form::Value(value) if statement.label.is_none() && said.reference.is_none() => Some(value),
        _ => None,
    }
}

/// `k = 8, m = 2`, `α = 37.1°, deflection = 15.8°`, where k or α is to be found: what is called so, if each of the others has
/// a name of its own.
fn called_as_asked<'s>(model: &Model, statements: &[&'s Statement]) -> Option<&'s Statement> {
    let asked = model.letter.as_ref()?;
    let is_asked = |statement: &&&Statement| {
        let name = statement.label.as_ref().and_then(|label| label.expr.as_ref());
        matches!(name, Some(Expr::Name(name)) if name.text == *asked)
    };
    let mut own = statements.iter().filter(is_asked);
    let only = own.next()?;
    let any_rival = statements.iter().flat_map(|statement| &statement.said).any(is_rival);
    let are_named = statements.iter().all(|statement| statement.label.is_some());
    (own.next().is_none() && are_named && !any_rival).then_some(*only)
}

/// `along LOC 1.92, perpendicular 2.00, B 3.08`, where a component is asked: the one in that direction, if each of the others
/// is in the other or of another sphere.
fn of_the_component<'s>(model: &Model, statements: &[&'s Statement]) -> Option<&'s Statement> {
    let asked = model.quantity.and_then(sphere)?;
    let is_of_other = |statement: &&&Statement| named_sphere(statement).is_some_and(|named| named != asked);
    let own: Vec<&&Statement> = statements.iter().filter(|statement| !is_of_other(statement)).collect();
    let directions = own.iter().map(|statement| velocity::is_of_component(model, statement));
    let directions = directions.collect::<Option<Vec<bool>>>()?;
    let mut right = own.iter().zip(directions).filter(|(_, is_right)| *is_right);
    let (only, _) = right.next().filter(|_| right.next().is_none())?;
    let any_rival = statements.iter().flat_map(|statement| &statement.said).any(is_rival);
    (!any_rival).then_some(**only)
}

fn choose(model: &Model, statements: &[&Statement], one: One) -> Finding {
    if let Some(own) = called_as_asked(model, statements).or_else(|| of_the_component(model, statements)) {
        return chain(model, own, one);
    }
    if let Some(size) = size_at_the_end(model, statements, one) {
        return size;
    }
    let spheres: Vec<Option<Sphere>> = statements.iter().map(|statement| named_sphere(statement)).collect();
    if let Some(asked) = model.quantity.and_then(sphere) {
        let own: Vec<&Statement> =
            statements.iter().zip(&spheres).filter(|(_, named)| **named == Some(asked)).map(|(s, _)| *s).collect();
        match own.as_slice() {
            [] if spheres.iter().all(Option::is_some) => return Finding::WRONG,
            [] => {
                // `−3i (B: 3i − j)`: what stands before another sphere is named is of the one that is asked.
                let before = spheres.iter().take_while(|named| named.is_none()).count();
                if (1..statements.len()).contains(&before) {
                    return last_or_rivals(model, &statements[..before], one);
                }
            }
            [single] => {
                let finding = chain(model, single, one);
                // `m_B/m = 5 so 5m`
                let is_solved = finding.note == Some(Note::Unsolved) && is_concluded(statements);
                return match statements.last().filter(|_| is_solved) {
                    Some(last) => finding.or_better(chain(model, last, one)),
                    None => finding,
                };
            }
            several => return last_or_rivals(model, several, one),
        }
    }
    let finding = last_or_rivals(model, statements, one);
    // Of two labelled spheres only a person knows which was asked.
    let several = SPHERES.into_iter().filter(|sphere| spheres.contains(&Some(*sphere))).count() > 1;
    let findings: Vec<Finding> = statements.iter().map(|statement| chain(model, statement, one)).collect();
    let any_right = findings.iter().any(Finding::is_credited);
    // Each sphere receives the same impulse, in a sense of its own.
    let is_of_each = model.quantity.map(Quantity::of_its_impact) == Some(Quantity::ImpulseMagnitude);
    if several && is_of_each && findings.iter().all(Finding::is_credited) {
        return findings.into_iter().reduce(Finding::or_better).unwrap_or(finding);
    }
    match several {
        // `vA = 3, vB = 2, e = 0.5`
        true if finding.is_credited() && spheres.last() == Some(&None) => finding,
        true if any_right => Finding::partial(Note::SeveralAnswers),
        true => Finding::WRONG,
        false => finding,
    }
}

/// `v_A = -5 so speed = 5`, `-5, i.e. 5 m/s` where a speed is asked: a velocity, and last its size.
fn size_at_the_end(model: &Model, statements: &[&Statement], one: One) -> Option<Finding> {
    let asked = model.quantity.map(Quantity::of_its_impact)?;
    let (last, before) = statements.split_last().filter(|_| matches!(asked, Quantity::Speed(..)))?;
    let is_of_asked = |statement: &&Statement| named_sphere(statement).is_none_or(|own| Some(own) == sphere(asked));
    let any_rival = || statements.iter().flat_map(|statement| &statement.said).any(is_rival);
    let is_size = is_called_a_size(last) || is_concluded(statements) || is_said_in_other_words(last);
    if before.is_empty() || !is_size || any_rival() || !statements.iter().all(is_of_asked) {
        return None;
    }
    let is_velocity = |statement: &&Statement| chain(model, statement, one).note == Some(Note::Sign);
    let size = chain(model, last, one);
    (size.is_correct() && before.iter().all(is_velocity)).then_some(size)
}

/// `speed = 5`, `|v| = 5`
fn is_called_a_size(statement: &Statement) -> bool {
    let label = statement.label.as_ref().map(|label| label.typed.to_lowercase());
    label.is_some_and(|label| ["speed", "magnitude", "size", "|"].iter().any(|size| label.contains(size)))
}

/// `i.e. 5 m/s`
fn is_said_in_other_words(statement: &Statement) -> bool {
    let first = statement.said.first();
    first.is_some_and(|said| said.remarks.iter().any(|remark| matches!(remark.as_str(), "i.e" | "i.e." | "ie")))
}

fn last_or_rivals(model: &Model, statements: &[&Statement], one: One) -> Finding {
    // `tan θ = 3/4, speed 5`: what has the name of something else is no rival, nor what is called so beside the answer.
    let any_named = statements.iter().any(|statement| called::is_named(model, statement));
    let is_of_another = |statement: &&&Statement| {
        let is_known = model.quantity.is_some() || model.letter.is_some();
        let label = statement.label.as_ref().filter(|_| is_known);
        let is_another = label.is_some_and(|label| {
            matches!(left_side::of(model, label), Left::Another)
                || (any_named || model.letter.is_some()) && called::is_word_for_another(model, label)
        });
        is_another && !statement.said.iter().any(is_rival)
    };
    let (others, own): (Vec<&Statement>, Vec<&Statement>) = statements.iter().partition(is_of_another);
    match own.as_slice() {
        [single] if !others.is_empty() => return chain(model, single, one),
        [_, _, ..] if !others.is_empty() => return last_or_rivals(model, &own, one),
        _ => {}
    }
    // `8 → 5.19, loss 2.81`: of several values the last alone is called what is asked.
    if let [steps @ .., last] = statements
        && !steps.is_empty()
        && !matches!(model.kind, Kind::Vector | Kind::Velocity | Kind::Line)
        && (called::is_named(model, last) || steps.len() > 1 && called::is_said_to_be_lost(model, last))
        && steps.iter().all(|step| step.label.is_none())
        && !statements.iter().flat_map(|statement| &statement.said).any(is_rival)
    {
        return chain(model, last, one);
    }
    if let Some(right) = by_custom(model, statements).map(|own| chain(model, own, one)).filter(Finding::is_credited) {
        return right;
    }
    let findings: Vec<Finding> = statements.iter().map(|statement| chain(model, statement, one)).collect();
    let typed = |statement: &&Statement| statement.label.as_ref().map(|label| label.typed.trim().to_lowercase());
    let labels: Vec<Option<String>> = statements.iter().map(typed).collect();
    let distinct = labels.iter().enumerate().all(|(at, label)| label.is_some() && !labels[..at].contains(label));
    let last = findings[findings.len() - 1];
    if distinct {
        let begins =
            |label: &Option<String>, letters: &[char]| label.as_ref().is_some_and(|label| label.starts_with(letters));
        // `w = 5, v = −3`: which of the letters is meant is not said.
        let letters = statements.len() > 1 && statements.iter().all(|statement| is_called_by_a_letter(statement));
        let any_right = findings.iter().any(Finding::is_correct);
        // `v = 5, u = 3.57`: u is what there was before, unless it is the name of another sphere's speed.
        let is_of_before = letters
            && model.quantity.and_then(moments::moment) == Some(Moment::After)
            && begins(&labels[labels.len() - 1], &['u'])
            && labels.iter().any(|label| begins(label, &['v', 'w']));
        if is_of_before && last.is_credited() {
            return Finding::unreadable(Note::NamedOtherwise);
        }
        // `v1 = 3.08, v2 = 2.78`: of names alike none is the answer because it stands last.
        let family = |statement: &&Statement| statement.label.as_ref().and_then(spheres::family);
        let of_last = statements.last().and_then(family);
        let alike =
            statements.iter().zip(&findings).filter(|(statement, _)| of_last.is_some() && family(statement) == of_last);
        let (right, others): (Vec<&Finding>, Vec<&Finding>) =
            alike.map(|(_, finding)| finding).partition(|finding| finding.is_credited());
        let is_open = !right.is_empty() && !others.is_empty();
        return if is_open || (letters && any_right && !last.is_credited()) {
            Finding::partial(Note::SeveralAnswers)
        } else {
            last
        };
    }
    // `u(1-e)/2, w = u(1+e)/2`: w may be what is asked, or the speed of the other sphere.
    if let ([first, others @ ..], [None, ..]) = (statements, labels.as_slice())
        && findings[0].is_correct()
        && !others.is_empty()
        && others.iter().all(|other| is_called_by_a_letter(other) && !other.said.iter().any(is_rival))
        && !first.said.iter().any(is_rival)
        && !findings[1..].iter().any(Finding::is_credited)
    {
        // `8.54, v = 3 along the line of centres`: a component of it.
        let is_part = |other: &&Statement| {
            other.said.iter().all(|said| said.reference.is_some_and(|line| line.is_direction()))
                && !model.path.as_ref().is_some_and(Expr::is_zero)
        };
        let is_speed = matches!(model.quantity.map(Quantity::of_its_impact), Some(Quantity::Speed(..)));
        return match is_speed && others.iter().all(is_part) {
            true => findings[0],
            false => Finding::partial(Note::SeveralAnswers),
        };
    }
    // `-4 m/s, speed = 4`: the velocity, and then its size.
    let is_size = statements.last().is_some_and(|last| is_called_a_size(last));
    let before = &findings[..findings.len() - 1];
    if last.note == Some(Note::Sign) && is_size && before.iter().all(Finding::is_correct) {
        return before.first().copied().unwrap_or(last);
    }
    if matches!(model.quantity.map(Quantity::of_its_impact), Some(Quantity::Speed(..) | Quantity::ImpulseMagnitude))
        && last.is_correct()
        && is_size
        && before.iter().all(|finding| finding.note == Some(Note::Sign) || finding.is_correct())
    {
        return last;
    }
    let right = findings.iter().copied().find(Finding::is_correct);
    // `42 on B, −42 on A`
    let is_of_each = model.quantity.map(Quantity::of_its_impact) == Some(Quantity::ImpulseMagnitude)
        && statements.iter().all(|statement| spheres::names_any(statement));
    if let Some(right) = right.filter(|_| is_of_each)
        && findings.iter().all(|finding| finding.is_correct() || finding.note == Some(Note::Sign))
    {
        return right;
    }
    // `1/14 (about 0.07)`
    if let ([exact, rounded @ ..], Some(true)) = (statements, findings.first().map(Finding::is_correct))
        && !rounded.is_empty()
        && rounded.iter().all(|rounded| is_rounded_from(exact, rounded))
    {
        return findings[0];
    }
    // A value and its opposite are two values.
    let spoilt = findings.iter().any(|finding| !finding.is_credited() || finding.note == Some(Note::Sign));
    // A right value and one that lacks a letter, has another unit, or is another by a figure, are two values.
    let differs = |finding: &Finding| {
        use Note::{LetterMissing, NearMiss, Truncated, UnitNotNeeded, UnitWrong};
        matches!(finding.note, Some(LetterMissing | UnitWrong | UnitNotNeeded | NearMiss | Truncated))
            && !finding.is_correct()
    };
    let spoilt = spoilt || (right.is_some() && findings.iter().any(differs));
    match right {
        // `20 → 7`: from what to what, or what follows from what?
        _ if spoilt && last.is_credited() && is_concluded(statements) && is_from_one_to_another(model, statements) => {
            Finding::unreadable(Note::SeveralAnswers)
        }
        // `m = 2 or −18/13, so m = 2`
        _ if spoilt && (is_concluded(statements) || is_chosen_from_the_others(statements)) => last,
        _ if spoilt && last.is_credited() && is_made_of_the_others(statements) => last,
        Some(_) if spoilt && are_of_both_spheres(model, statements) => Finding::unreadable(Note::SeveralAnswers),
        Some(_) if spoilt => Finding::wrong(Note::RivalAnswers),
        Some(right) => right,
        None if spoilt && findings.iter().any(Finding::is_credited) => Finding::wrong(Note::RivalAnswers),
        None => last,
    }
}

/// Is it called by a single letter?
pub(super) fn is_called_by_a_letter(statement: &Statement) -> bool {
    let name = statement.label.as_ref().and_then(|label| label.expr.as_ref());
    matches!(name, Some(Expr::Name(name)) if name.text.chars().count() == 1)
}

/// Is the last of them drawn from the others, as after `so`?
pub(super) fn is_concluded(statements: &[&Statement]) -> bool {
    let first = statements.last().and_then(|last| last.said.first());
    first.is_some_and(|said| said.remarks.iter().any(|remark| remark == "so") && !is_rival(said))
}
