//! Velocities by magnitude and direction, where a question has no **i** and **j**.
//!
//! Convention. The model is a vector whose first component lies along the line of centres and whose second is
//! perpendicular to it: `[0, 6*sin(10*deg)]`. A model that is a number alone has no direction, and what a student says
//! of one is left to a person.

use crate::answer::Kind;
use crate::expr::{Expr, Function};
use crate::mark::reading::{Form, Label, Reading, ReferenceLine, Said, Statement};
use crate::mechanics::{Axis, Moment, Quantity, Sphere};

use super::chain::links;
use super::exact::{self, Equality, same};
use super::finding::Finding;
use super::known::Further;
use super::spheres::{named_sphere, sphere};
use super::statements::is_rival;
use super::{Model, Note, angle, moments, number, sense, sides, sorts, vector};

/// Words that tell of a direction, whichever it is.
const DIRECTIONS: [&str; 4] = ["direction", "vertically", "horizontally", "way"];

/// Judges a whole reading against a velocity.
pub(super) fn judge(model: &Model, reading: &Reading) -> Finding {
    let (statements, of_other) = of_asked(model, &reading.statements);
    let labels = statements.iter().filter_map(|statement| statement.label.as_ref()).map(|label| &label.typed);
    let texts: Vec<&String> = labels.chain(statements.iter().flat_map(|statement| statement.remarks())).collect();
    let turns = sides::says_which_way(&texts);
    let is_of_another_moment = model.quantity.is_some_and(|asked| {
        let label = |statement: &&Statement| statement.label.as_ref().map(|label| label.typed.to_lowercase());
        let remarks: Vec<&String> = statements.iter().flat_map(|statement| statement.remarks()).collect();
        let is_called_otherwise = statements.iter().filter_map(label).any(|name| !moments::fit(asked, &name));
        is_called_otherwise || moments::are_of_another(asked, &remarks)
    });
    let finding = of_one(model, statements);
    // Of a sphere of which nobody says from where it came, to go on says nothing, and to go back cannot be checked.
    let is_else = |back: bool| goes_back(model).map_or(back, |goes_back| goes_back != back);
    let is_turned = finding.is_credited() && turns.is_some_and(is_else);
    // `56.3° to the line of centres, reversed along it`: the line is named once more, and no other direction.
    let is_named_again = finding.note == Some(Note::DirectionWrong) && turns == Some(true);
    match finding.is_credited() && (of_other || is_of_another_moment) {
        true => Finding::unreadable(Note::NamedOtherwise),
        false if is_turned || is_named_again => Finding::unreadable(Note::DirectionUnchecked),
        false => finding,
    }
}

/// Does the sphere that is asked go back after the impact? Of A that is seen; of another nobody says from where it came.
fn goes_back(model: &Model) -> Option<bool> {
    let (along, _) = vector::components(model)?;
    let sign = exact::value(&along, &model.vocabulary.letters)?.sign()?;
    (model.quantity.and_then(sphere) == Some(Sphere::A)).then_some(sign.is_lt())
}

/// Judges what is said of one sphere.
fn of_one(model: &Model, statements: Vec<&Statement>) -> Finding {
    let is_of_direction = |statement: &&Statement| statement.label.as_ref().is_some_and(names_a_ratio);
    let ratio = statements.iter().copied().find(is_of_direction);
    let others = statements.into_iter().filter(|statement| !is_of_direction(statement));
    let told: Vec<(&Statement, &Said)> =
        others.filter_map(|statement| Some((statement, statement.said.last()?))).collect();
    let said: Vec<&Said> = told.iter().map(|(_, said)| *said).collect();
    let parts = vector::components(model);
    if let (Some(parts), [one, other]) = (&parts, told.as_slice())
        && let Some(finding) = by_components(model, parts, [*one, *other])
    {
        return finding;
    }
    if let (Some(_), Some(as_vector)) = (&parts, said.iter().find(|said| matches!(said.form, Form::Vector(..)))) {
        return vector::judge(model, as_vector);
    }
    let right = || match &parts {
        Some((along, across)) => vector::magnitude(along, across),
        None => model.value.clone(),
    };
    // A size of no sphere in particular is one of a velocity all the same.
    let quantity = model.quantity.or(Some(Quantity::Speed(Sphere::A, Moment::After)));
    let size_model = Model { quantity, ..model.further(Further::Size, Kind::Number, right) };
    let is_rest = || exact::equals(&size_model, &Expr::integer(0)) == Equality::Equal;
    let sizes: Vec<&&Said> = said.iter().filter(|said| is_size(said, model)).collect();
    // `6√3/5 = 2.1 along the line of centres`: the chain decides, as it does for a number.
    let of_chain = |size: &Said| {
        let statement = told.iter().find(|(_, said)| std::ptr::eq(*said, size)).map(|(statement, _)| *statement);
        let one = |said: &Said, _: Option<&Label>| number::judge(&size_model, said, None);
        statement.map_or(Finding::WRONG, |statement| links(statement, &one))
    };
    let size = match sizes.as_slice() {
        [] => return Finding::unreadable(Note::CannotBeRead),
        [size] => of_chain(size),
        // `4 or 5 perpendicular to the line of centres`
        [_, second] if is_rival(second) || second.reference.is_some_and(ReferenceLine::is_direction) => {
            return Finding::wrong(Note::RivalAnswers);
        }
        // A bare second number is the angle, as in `2.78, 46.1`.
        [size, _] => of_chain(size),
        _ => return Finding::wrong(Note::RivalAnswers),
    };
    if !size.is_credited() || is_rest() {
        return size;
    }
    let Some((along, across)) = parts else {
        let pointed = said.iter().any(|said| said.reference.is_some() || matches!(said.form, Form::Direction));
        return size.at_most_partial(if pointed { Note::DirectionUnchecked } else { Note::DirectionMissing });
    };
    // By how much the path turned is told besides, and says no direction.
    let (turned, kept): (Vec<_>, Vec<_>) = told.iter().partition(|(statement, _)| is_deflected(statement));
    let said: Vec<&Said> = kept.iter().map(|(_, said)| *said).collect();
    let bare = sizes.get(1).copied().filter(|_| turned.is_empty());
    let finding = direction(model, &along, &across, &said, bare, ratio);
    match finding.is_credited() && finding.note != Some(Note::DirectionMissing) || turned.is_empty() {
        true => size.and(finding),
        false => Finding::unreadable(Note::DirectionUnchecked),
    }
}

/// Is the way told by which it turns: `deflected through 50°`?
fn is_deflected(statement: &Statement) -> bool {
    let label = statement.label.iter().map(|label| &label.typed);
    let remarks = statement.remarks();
    let mut words = label.chain(remarks).flat_map(|words| sorts::words(words));
    words.any(|word| sorts::sort(word) == Some(sorts::Sort::Deflection))
}

/// `A: 1.04 perpendicular to AB, B: 2.95 along AB`: what is said of the sphere that is asked, up to where another is named.
/// If all is said of another, that, and so is told.
fn of_asked<'s>(model: &Model, statements: &'s [Statement]) -> (Vec<&'s Statement>, bool) {
    let asked = model.quantity.and_then(sphere);
    let mut named = None;
    let of: Vec<Option<Sphere>> = statements
        .iter()
        .map(|statement| {
            named = named_sphere(statement).or(named);
            named
        })
        .collect();
    let of_other = asked.is_some() && of.iter().all(|of| of.is_some() && *of != asked);
    let is_open = asked.is_none() || of_other;
    let own = statements.iter().zip(of).filter(|(_, of)| is_open || of.is_none() || *of == asked);
    (own.map(|(statement, _)| statement).collect(), of_other)
}

/// Is it called the tangent of an angle, or its sine or cosine?
fn names_a_ratio(label: &Label) -> bool {
    matches!(&label.expr, Some(Expr::Call(Function::Sin | Function::Cos | Function::Tan, _)))
}

/// `2.5 along the line of centres and 2.6 perpendicular to it`, `along LOC: 2.5, perp: 2.6`: right, and a step short. The
/// sense is not looked at.
fn by_components(model: &Model, parts: &(Expr, Expr), told: [(&Statement, &Said); 2]) -> Option<Finding> {
    let said = told.map(|(_, said)| said);
    if said.into_iter().any(is_rival) {
        return None;
    }
    let [along, across] = match told.map(|(statement, said)| is_across(statement, said)) {
        [Some(false), Some(true)] => said,
        [Some(true), Some(false)] => [said[1], said[0]],
        _ => return None,
    };
    let size = |right: &Expr, said: &Said| {
        let size = Expr::call(Function::Abs, right.clone());
        number::judge(&Model { kind: Kind::Number, ..model.of_value(size) }, said, None)
    };
    let both = size(&parts.0, along).and(size(&parts.1, across));
    // Where it is concluded that one of them is nought the other is all of it.
    let is_concluded = matches!(along.form, Form::AtRest) || across.remarks.iter().any(|remark| remark == "so");
    let is_nought = |component: &Expr| same(component, &Expr::integer(0), &model.vocabulary.letters) == Equality::Equal;
    Some(match both.is_credited() {
        true if is_concluded && is_nought(&parts.0) => both,
        true => Finding::partial(Note::ComponentsLeft),
        false => Finding::WRONG,
    })
}

/// Is a component said to be perpendicular to the line of centres, or else along it?
pub(super) fn is_across(statement: &Statement, said: &Said) -> Option<bool> {
    let label = statement.label.iter().map(|label| label.typed.to_lowercase());
    let words: Vec<String> = label.chain(said.remarks.iter().cloned()).collect();
    let says = |wanted: &str| words.iter().any(|words| words.split(' ').any(|word| word == wanted));
    match (&said.form, said.reference.map(ReferenceLine::unsensed)) {
        (Form::Value(_) | Form::AtRest, Some(ReferenceLine::AlongLineOfCentres)) => Some(false),
        (Form::Value(_) | Form::AtRest, Some(ReferenceLine::AlongCommonTangent)) => Some(true),
        (Form::Value(_) | Form::AtRest, None) if says("perpendicular") || says("perp") => Some(true),
        (Form::Value(_) | Form::AtRest, None) if says("along") || says("parallel") => Some(false),
        _ => None,
    }
}

/// Is the statement one of the component that is asked, by the direction that it names; nothing where another thing is asked, or
/// none is named.
pub(super) fn is_of_component(model: &Model, statement: &Statement) -> Option<bool> {
    let across = match model.quantity?.of_its_impact() {
        Quantity::Velocity(_, _, Axis::N) => false,
        Quantity::Velocity(_, _, Axis::T) => true,
        _ => return None,
    };
    Some(is_across(statement, statement.said.last()?)? == across)
}

/// Is a velocity told by its components, of which one is said to be perpendicular?
pub(super) fn is_told_by_components(model: &Model, reading: &Reading) -> bool {
    let (statements, _) = of_asked(model, &reading.statements);
    let told = statements.iter().filter_map(|statement| Some((*statement, statement.said.last()?)));
    let is_velocity = model.kind == Kind::Velocity;
    match (vector::components(model).filter(|_| is_velocity), told.collect::<Vec<_>>().as_slice()) {
        (Some(parts), [one, other]) => by_components(model, &parts, [*one, *other]).is_some(),
        _ => false,
    }
}

/// Is it the size of a velocity rather than an angle or words?
fn is_size(said: &Said, model: &Model) -> bool {
    match &said.form {
        Form::AtRest => true,
        Form::Value(expr) => {
            let angular = said.unit.as_ref().is_some_and(|unit| unit.degrees || unit.dimension == [0, 0, 0, 1]);
            let measured = said.reference.is_some_and(|line| !line.is_direction()) && said.unit.is_none();
            let inverse = exact::is_angle(expr, &model.vocabulary.letters);
            !(angular || measured || inverse)
        }
        _ => false,
    }
}

fn direction(
    model: &Model,
    along: &Expr,
    across: &Expr,
    said: &[&Said],
    bare: Option<&&Said>,
    ratio: Option<&Statement>,
) -> Finding {
    let nothing = |component: &Expr| same(component, &Expr::integer(0), &model.vocabulary.letters) == Equality::Equal;
    let named: Vec<ReferenceLine> =
        said.iter().filter_map(|said| said.reference).filter(|line| line.is_direction()).collect();
    let sense = exact::value(along, &model.vocabulary.letters).and_then(|along| along.sign());
    let rebounds = sense.map(std::cmp::Ordering::is_lt).or(model.rebounds);
    if let [line] = named.as_slice() {
        let lies = match line.unsensed() {
            ReferenceLine::AlongLineOfCentres => nothing(across),
            ReferenceLine::AlongCommonTangent => nothing(along),
            _ => return Finding::partial(Note::DirectionUnchecked),
        };
        // `4 perpendicular to the line of centres at 30°`
        if said.iter().any(|said| matches!(said.form, Form::Value(_)) && !is_size(said, model)) {
            return Finding::partial(Note::DirectionUnchecked);
        }
        return match sense::agrees(line.sense(), rebounds) {
            Some(true) if lies => Finding::EXACT,
            None if lies => Finding::partial(Note::DirectionUnchecked),
            _ => Finding::wrong(Note::DirectionWrong),
        };
    }
    if !named.is_empty() {
        return Finding::wrong(Note::RivalAnswers);
    }
    let angles: Vec<&Said> = said.iter().copied().filter(|said| !is_size(said, model)).collect();
    let by_ratio = ratio.and_then(|statement| Some((statement.said.last()?, statement.label.as_ref())));
    let (measured, label) = match (angles.as_slice(), bare, by_ratio) {
        ([], None, None) => {
            let mut words = said.iter().flat_map(|said| &said.remarks).flat_map(|remark| remark.split(' '));
            let is_said = words.any(|word| DIRECTIONS.contains(&word));
            return Finding::partial(if is_said { Note::DirectionUnchecked } else { Note::DirectionMissing });
        }
        ([], None, Some(ratio)) => ratio,
        ([], Some(bare), _) => (*bare, None),
        ([angle], None, _) => (*angle, None),
        _ => return Finding::wrong(Note::RivalAnswers),
    };
    let size = |component: &Expr| Expr::call(Function::Abs, component.clone());
    let value = || {
        if nothing(along) {
            Expr::degrees(Expr::integer(90))
        } else {
            Expr::call(Function::Atan, size(across).over(size(along)))
        }
    };
    let angle_model = Model { rebounds, ..model.further(Further::Direction, Kind::Angle, value) };
    let finding = angle::judge(&angle_model, measured, label);
    let is_for_a_person = finding.note == Some(Note::ReferenceUnchecked);
    match finding.is_credited() {
        true => finding,
        false if is_for_a_person => Finding::unreadable(Note::DirectionUnchecked),
        false => Finding::wrong(finding.note.unwrap_or(Note::DirectionWrong)),
    }
}
