//! The sense along the line of centres that is said beside a value, against that in which the sphere moves.
//!
//! Convention. A component along the line of centres is positive from A to B: `3 m/s from B to A` is −3. Beside a speed the
//! sense is not asked, and one that is not right is for a person. Beside the size of an impulse it may be either, for there
//! are two of them.

use std::cmp::Ordering;

use crate::answer::Kind;
use crate::expr::Expr;
use crate::mark::enclosure::enclose_roughly;
use crate::mark::reading::{Form, Label, Reading, ReferenceLine, Said, Sense, Statement};
use crate::mechanics::{Axis, Moment, Quantity, Sphere};

use super::finding::Finding;
use super::known::Prepared;
use super::otherwise::spheres_in_remark;
use super::{Model, Note, Verdict, angle, exact, number, selection, sorts};

/// Does a sphere that moves so, backwards or not, move in the sense that is said? `None` if nobody knows.
pub(super) fn agrees(said: Option<Sense>, backwards: Option<bool>) -> Option<bool> {
    match (said, backwards) {
        (None, _) | (Some(Sense::Perhaps), Some(false)) => Some(true),
        (Some(Sense::Perhaps), _) | (_, None) => None,
        (Some(Sense::AToB), Some(backwards)) => Some(!backwards),
        (Some(Sense::BToA), Some(backwards)) => Some(backwards),
    }
}

/// Do words say that a sphere goes back?
pub(super) fn says_that_it_goes_back(words: &str) -> bool {
    const BACK: [&str; 8] = [
        "rebound",
        "bounc",
        "revers",
        "moving back",
        "moves back",
        "turns back",
        "opposite direction",
        "changes direction",
    ];
    BACK.iter().any(|back| words.contains(back))
}

/// Do the words beside values say that a sphere goes back, or that it goes on?
pub(super) fn says_which_way(statements: &[&Statement]) -> Option<bool> {
    const ON: [&str; 6] = ["continues", "forwards", "goes on", "carries on", "same direction", "direction unchanged"];
    let labels = statements.iter().filter_map(|statement| statement.label.as_ref()).map(|label| &label.typed);
    let remarks = statements.iter().flat_map(|statement| &statement.said).flat_map(|said| &said.remarks);
    let words: String = labels.chain(remarks).map(|words| words.to_lowercase()).collect::<Vec<_>>().join(" ");
    match (says_that_it_goes_back(&words), ON.iter().any(|on| words.contains(on))) {
        (true, false) => Some(true),
        (false, true) => Some(false),
        _ => None,
    }
}

/// The remarks beside the values of a statement.
fn remarks(statement: &Statement) -> impl Iterator<Item = &str> {
    statement.said.iter().flat_map(|said| &said.remarks).map(String::as_str)
}

/// Which of two things is said, if one of them alone is.
fn one_of(first: bool, second: bool) -> Option<bool> {
    (first != second).then_some(first)
}

/// Do they say that it goes away from the wall, or towards it? The wall is beyond B, or in the place of B.
fn says_away_from_the_wall(statement: &Statement) -> Option<bool> {
    let says = |wanted: &[&str]| {
        let mut of_wall = remarks(statement).filter(|remark| remark.contains("wall"));
        of_wall.any(|remark| wanted.iter().any(|words| remark.contains(words)))
    };
    let is_towards = says(&["toward", "into"]) || remarks(statement).any(|remark| remark.starts_with("to the wall"));
    one_of(says(&["away from", "off the"]), is_towards)
}

/// Do they say that it goes to the left, or to the right? A goes to the right towards B, as every diagram has it.
fn says_to_the_left(statement: &Statement) -> Option<bool> {
    let says = |side: &str| {
        let is_side = |remark: &str| {
            remark == side || remark.contains(&format!("to the {side}")) || remark.contains(&format!("{side}ward"))
        };
        remarks(statement).any(is_side)
    };
    one_of(says("left"), says("right"))
}

/// Do they say that it goes upwards, as **j** does?
fn says_upwards(statement: &Statement) -> Option<bool> {
    let says = |wanted: &[&str]| remarks(statement).any(|remark| called_by(remark, wanted));
    one_of(says(&["above", "upwards", "up"]), says(&["below", "downwards", "down"]))
}

fn called_by(remark: &str, wanted: &[&str]) -> bool {
    sorts::words(remark).any(|word| wanted.contains(&word))
}

/// Do they say that an angle turns anticlockwise, or is above **i**?
fn says_anticlockwise(statement: &Statement) -> Option<bool> {
    const ANTICLOCKWISE: [&str; 6] = ["anticlockwise", "counterclockwise", "above", "upwards", "up", "left"];
    const CLOCKWISE: [&str; 5] = ["clockwise", "below", "downwards", "down", "right"];
    let says = |wanted: &[&str]| {
        let all = remarks(statement).map(|remark| remark.replace("ti-clock", "ticlock").replace("er-clock", "erclock"));
        all.into_iter().any(|remark| called_by(&remark, wanted))
    };
    one_of(says(&ANTICLOCKWISE), says(&CLOCKWISE))
}

/// Is what is asked said to go another way than it does?
pub(super) fn is_said_to_go_otherwise(model: &Model, statement: &Statement) -> bool {
    use Quantity::{AngleToWall, Speed, Velocity};
    let is_else = |said: Option<bool>, own: Option<bool>| said.zip(own).is_some_and(|(said, own)| said != own);
    match model.quantity.map(Quantity::of_its_impact) {
        Some(asked @ (Speed(..) | Velocity(_, _, Axis::N))) => {
            let is_above =
                model.vector.as_ref().filter(|_| matches!(asked, Speed(..))).and_then(|[_, y]| is_positive(y));
            is_else(says_upwards(statement), is_above)
                || is_else(says_which_way(&[statement]), model.turns_back)
                || is_else(says_away_from_the_wall(statement), model.rebounds)
                || is_else(says_to_the_left(statement), model.rebounds)
        }
        Some(AngleToWall(_, moment)) => is_else(says_away_from_the_wall(statement), Some(moment == Moment::After)),
        Some(_) => is_else(says_anticlockwise(statement), model.anticlockwise),
        None => false,
    }
}

/// Words for an impact that comes later, and those that deny what stands beside them.
const MEETING: [&str; 9] =
    ["collide", "collides", "collision", "collisions", "impact", "meet", "meets", "catches", "again"];
const NEVER: [&str; 8] = ["no", "not", "never", "without", "cannot", "don", "doesn", "won"];

/// Does a remark say that nothing meets?
pub(super) fn denies_a_meeting(remark: &str) -> bool {
    let has = |wanted: &[&str]| sorts::words(remark).any(|word| wanted.contains(&word));
    has(&NEVER) && has(&MEETING)
}

/// Is another collision spoken of beside what is no range: that there is none, or which of several it is?
pub(super) fn is_of_another_meeting(model: &Model, reading: &Reading) -> bool {
    const OTHERS: [&str; 6] = ["further", "more", "second", "other", "subsequent", "another"];
    let has = |remark: &str, wanted: &[&str]| sorts::words(remark).any(|word| wanted.contains(&word));
    let is_other = |remark: &str| denies_a_meeting(remark) || has(remark, &OTHERS) && has(remark, &MEETING);
    model.kind != Kind::Range && reading.statements.iter().flat_map(remarks).any(is_other)
}

/// Do words beside a range speak of something else than what is to happen: of the other sphere that turns back, of a
/// collision where there is to be none?
pub(super) fn is_of_another_event(model: &Model, statements: &[Statement]) -> bool {
    let all: Vec<&Statement> = statements.iter().collect();
    let texts = || {
        let labels = all.iter().filter_map(|statement| statement.label.as_ref()).map(|label| label.typed.as_str());
        labels.chain(all.iter().flat_map(|statement| remarks(statement)))
    };
    let has = |wanted: &[&str]| {
        texts().any(|text| sorts::words(text).any(|word| wanted.contains(&word.to_lowercase().as_str())))
    };
    let said = says_which_way(&all);
    let is_another_way = match model.turns_back {
        Some(turns_back) => said.is_some_and(|said| said != turns_back),
        // Where the letter is to be such that something else happens.
        None => said.is_some() && model.letter.is_some(),
    };
    let is_of_stranger = || texts().flat_map(spheres_in_remark).any(|sphere| model.strangers.contains(&sphere));
    let is_meeting = has(&MEETING).then(|| !has(&NEVER));
    is_another_way
        || (said.is_some() && is_of_stranger())
        || is_meeting.zip(model.meet_again).is_some_and(|(said, is)| said != is)
}

/// Judges a number by the direction that is said beside it, where that matters for what is asked.
pub(super) fn judge(model: &Model, said: &Said, label: Option<&Label>) -> Option<Finding> {
    let line = said.reference?;
    if lies_elsewhere(model.quantity?, line) {
        let plain = number::judge(model, &Said { reference: None, ..said.clone() }, label);
        return Some(if plain.is_credited() { Finding::unreadable(Note::ReferenceUnchecked) } else { plain });
    }
    let of = |form: Form| number::judge(model, &Said { form, reference: None, ..said.clone() }, label);
    let plain = || of(said.form.clone());
    let (sphere, axis) = match model.quantity? {
        Quantity::Velocity(sphere, _, axis) | Quantity::SphereMomentum(sphere, _, axis) => (sphere, axis),
        Quantity::Impulse(sphere, axis) => (sphere, axis),
        Quantity::Speed(sphere, _) => {
            // Away from B is where C goes.
            let is_of_c = sphere == Sphere::C && line.is_sense_alone();
            let agrees = is_of_c || agrees(line.sense(), model.rebounds) != Some(false);
            let lies = |degrees: i64| model.path.as_ref().is_none_or(|path| *path == Expr::integer(degrees));
            let lies = match line.unsensed() {
                ReferenceLine::AlongLineOfCentres => lies(0),
                ReferenceLine::AlongCommonTangent => lies(90),
                _ => true,
            };
            return (!(agrees && lies)).then(|| plain().at_most_partial(Note::DirectionUnchecked));
        }
        _ => return None,
    };
    let right = match axis {
        Axis::N => ReferenceLine::AlongLineOfCentres,
        Axis::T => ReferenceLine::AlongCommonTangent,
        _ => return None,
    };
    if line.is_direction() && line.unsensed() != right && !(axis == Axis::N && line.is_sense_alone()) {
        return Some(if plain().is_credited() { Finding::wrong(Note::DirectionWrong) } else { Finding::WRONG });
    }
    let Form::Value(expr) = &said.form else { return None };
    if line.sense() != Some(Sense::BToA) || axis == Axis::T {
        return None;
    }
    let (plain, turned) = (plain(), of(Form::Value(expr.clone().negated())));
    Some(match (turned.is_credited(), plain.is_credited()) {
        (false, false) => Finding::WRONG,
        // `−3 m/s from B to A`: said twice, or taken back? And where C lies nobody has said.
        _ if is_negative(expr) || sphere == Sphere::C => Finding::unreadable(Note::CannotBeCompared),
        (true, _) => turned,
        (false, true) => Finding::wrong(Note::Sign),
    })
}

/// Is it a line along which no impulse acts, or from which another angle is measured than that whose tangent is asked?
fn lies_elsewhere(asked: Quantity, line: ReferenceLine) -> bool {
    use ReferenceLine::{AlongCommonTangent, CommonTangent, LineOfCentres, OriginalDirection};
    match asked.of_its_impact() {
        Quantity::ImpulseMagnitude | Quantity::Approach | Quantity::Separation => line.unsensed() == AlongCommonTangent,
        Quantity::TanToLine(..) => matches!(line.unsensed(), CommonTangent | OriginalDirection),
        Quantity::TanToWall(..) => matches!(line.unsensed(), LineOfCentres | OriginalDirection),
        Quantity::TanDeflection(_) => matches!(line.unsensed(), CommonTangent | LineOfCentres),
        _ => false,
    }
}

/// Is an angle told beside a speed that is not the one at which the sphere moves?
pub(super) fn is_beside_the_path(model: &Model, reading: &Reading) -> bool {
    if reading.statements.iter().flat_map(|statement| &statement.said).any(|said| is_beside_the_vector(model, said)) {
        return true;
    }
    let along_centres = Expr::integer(0);
    let path = match (&model.path, model.quantity.map(Quantity::of_its_impact)) {
        (Some(path), Some(Quantity::Speed(..))) => path,
        // Smooth spheres push each other along the line of centres.
        (_, Some(Quantity::ImpulseMagnitude)) => &along_centres,
        _ => return false,
    };
    let to_centres =
        |line: ReferenceLine| matches!(line.unsensed(), ReferenceLine::LineOfCentres | ReferenceLine::CommonTangent);
    let mut angle_model = Model { kind: Kind::Angle, ..model.of_value(path.clone()) };
    // What is too long for its exact value is told apart by doubles.
    if angle_model.known().turn().is_none()
        && let Some(radians) = enclose_roughly(path, &[], 0)
    {
        angle_model.value = Expr::Decimal(format!("{:.9}", ((radians.lower + radians.upper) / 2.0).to_degrees()));
        angle_model.prepared = Prepared::default();
    }
    let said = reading.statements.iter().flat_map(|statement| &statement.said);
    let mut angles = said.filter(|said| selection::is_angular(said) && said.reference.is_some_and(to_centres));
    angles.any(|said| angle::judge(&angle_model, said, None).verdict == Verdict::Wrong)
}

/// Is it an angle with **i** or **j** at which the vector whose size is asked does not lie? Of an impulse there are two, the
/// one opposite to the other.
fn is_beside_the_vector(model: &Model, said: &Said) -> bool {
    let Some(line) = said.reference.filter(|_| selection::is_angular(said)) else { return false };
    let enclosed = |expr: &Expr| enclose_roughly(expr, &[], 0).map(|within| (within.lower + within.upper) / 2.0);
    let Some([x, y]) = &model.vector else { return false };
    let (Some(x), Some(y)) = (enclosed(x), enclosed(y)) else { return false };
    let degrees = match line {
        ReferenceLine::I => y.abs().atan2(x),
        ReferenceLine::J => x.abs().atan2(y),
        ReferenceLine::MinusI => y.abs().atan2(-x),
        _ => return false,
    }
    .to_degrees();
    let is_right = |degrees: f64| {
        let right = Model { kind: Kind::Angle, ..model.of_value(Expr::Decimal(format!("{degrees:.9}"))) };
        angle::judge(&right, &Said { reference: None, ..said.clone() }, None).is_credited()
    };
    let is_of_either = model.quantity.map(Quantity::of_its_impact) == Some(Quantity::ImpulseMagnitude);
    // `at 56.3° below i`
    let is_above = one_of(
        said.remarks.iter().any(|remark| remark == "above"),
        said.remarks.iter().any(|remark| remark == "below"),
    );
    if line == ReferenceLine::I && !is_of_either && is_above.is_some_and(|above| above != (y > 0.0)) {
        return true;
    }
    !(is_right(degrees) || is_of_either && is_right(180.0 - degrees))
}

fn is_positive(expr: &Expr) -> Option<bool> {
    exact::value(expr, &[])?.sign().filter(|sign| sign.is_ne()).map(Ordering::is_gt)
}

fn is_negative(expr: &Expr) -> bool {
    let sign = exact::value(expr, &[]).and_then(|value| value.sign());
    matches!(expr, Expr::Negative(_)) || sign == Some(Ordering::Less)
}
