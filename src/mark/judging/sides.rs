//! The side to which something is said to go: back or on, away from a wall, to the left, upwards, anticlockwise.

use std::cmp::Ordering;

use crate::expr::Expr;
use crate::mark::reading::Statement;
use crate::mechanics::{Axis, Moment, Quantity};

use super::otherwise::spheres_in_remark;
use super::spheres::sphere;
use super::{Model, exact, sorts};

/// Is what is asked said to go another way than it does?
pub(super) fn is_said_to_go_otherwise(model: &Model, statement: &Statement) -> bool {
    use Quantity::{AngleToLine, AngleToWall, ImpulseAngle, ImpulseMagnitude, Speed, Velocity};
    let is_else = |said: Option<bool>, own: Option<bool>| said.zip(own).is_some_and(|(said, own)| said != own);
    let remarks: Vec<&String> = statement.remarks().collect();
    match model.quantity.map(Quantity::of_its_impact) {
        Some(asked @ (Speed(..) | Velocity(_, _, Axis::N))) => {
            let is_above =
                model.vector.as_ref().filter(|_| matches!(asked, Speed(..))).and_then(|[_, y]| is_positive(y));
            let label = statement.label.iter().map(|label| &label.typed);
            // `in A's original direction` is said of B too.
            let is_of_another = |text: &&String| {
                !text.contains("toward") && spheres_in_remark(text).iter().any(|named| Some(*named) != sphere(asked))
            };
            let texts: Vec<&String> =
                label.chain(remarks.iter().copied()).filter(|text| !is_of_another(text)).collect();
            is_else(says_upwards(&remarks), is_above)
                || is_else(says_which_way(&texts), model.turns_back)
                || is_else(says_the_way_of_another(asked, &remarks), model.same_way)
                || remarks.iter().any(|remark| has_word(remark, &COMPASS))
                || is_else(says_away_from_the_wall(&remarks), model.rebounds)
                || is_else(says_to_the_left(&remarks), model.rebounds)
        }
        Some(AngleToWall(_, moment)) => is_else(says_away_from_the_wall(&remarks), Some(moment == Moment::After)),
        Some(ImpulseMagnitude) => {
            is_else(says_away_from_the_wall(&remarks), model.pushes_back)
                || is_else(says_to_the_left(&remarks), model.pushes_back)
        }
        Some(AngleToLine(..)) => {
            is_else(says_which_way(&remarks), model.turns_back) || is_else(says_to_the_left(&remarks), model.rebounds)
        }
        // Of which of the two impulses it is nobody says: the one that the answer turns to may be the other.
        Some(ImpulseAngle) if model.anticlockwise.is_none() => says_anticlockwise(&remarks) == Some(false),
        Some(_) => is_else(says_anticlockwise(&remarks), model.anticlockwise),
        None => false,
    }
}

/// Do words say that a sphere goes back?
pub(super) fn says_that_it_goes_back(words: &str) -> bool {
    const BACK: [&str; 10] = [
        "rebound",
        "bounc",
        "revers",
        "moving back",
        "moves back",
        "turns back",
        "goes back",
        "comes back",
        "opposite direction",
        "changes direction",
    ];
    BACK.iter().any(|back| words.contains(back))
}

/// Ways to say that a sphere goes on.
const ON: [&str; 14] = [
    "continu",
    "forward",
    "goes on",
    "going on",
    "moves on",
    "carries on",
    "keeps going",
    "same direction",
    "original direction",
    "initial direction",
    "direction it was",
    "direction unchanged",
    "same way",
    "towards c",
];

/// Do the words beside values say that a sphere goes back, or that it goes on?
pub(super) fn says_which_way(texts: &[&String]) -> Option<bool> {
    let words: String = texts.iter().map(|words| words.to_lowercase()).collect::<Vec<_>>().join(" ");
    let is_on = ON.iter().any(|on| words.contains(on)) && !words.contains("opposite");
    one_of(says_that_it_goes_back(&words), is_on)
}

/// Do they say that it goes the way of the other sphere: `in the same direction as A`, `opposite to A`?
fn says_the_way_of_another(asked: Quantity, remarks: &[&String]) -> Option<bool> {
    let own = sphere(asked)?;
    let words = remarks.iter().map(|remark| remark.as_str()).collect::<Vec<_>>().join(" ");
    let is_of_another = spheres_in_remark(&words).iter().any(|named| *named != own);
    let is_way = has_word(&words, &["direction", "way"]) || words.contains("along with");
    (is_of_another && is_way).then(|| !words.contains("opposite"))
}

/// No question has a map.
const COMPASS: [&str; 4] = ["north", "south", "east", "west"];

/// Which of two things is said, if one of them alone is.
pub(super) fn one_of(first: bool, second: bool) -> Option<bool> {
    (first != second).then_some(first)
}

/// Do they say that it goes away from the wall, or towards it? The wall is beyond B, or in the place of B.
fn says_away_from_the_wall(remarks: &[&String]) -> Option<bool> {
    let says = |wanted: &[&str]| {
        let mut of_wall = remarks.iter().filter(|remark| remark.contains("wall"));
        of_wall.any(|remark| wanted.iter().any(|words| remark.contains(words)))
    };
    let is_towards = says(&["toward", "into"]) || remarks.iter().any(|remark| remark.starts_with("to the wall"));
    one_of(says(&["away from", "off the"]), is_towards)
}

/// Do they say that it goes to the left, or to the right? A goes to the right towards B, as every diagram has it.
fn says_to_the_left(remarks: &[&String]) -> Option<bool> {
    let says = |side: &str| {
        remarks.iter().any(|remark| {
            *remark == side || remark.contains(&format!("to the {side}")) || remark.contains(&format!("{side}ward"))
        })
    };
    let is_arrow = remarks.iter().any(|remark| remark.contains(['←', '⟵']));
    one_of(says("left") || is_arrow, says("right"))
}

/// Do they say that it goes upwards, as **j** does?
pub(super) fn says_upwards(remarks: &[&String]) -> Option<bool> {
    let says = |wanted: &[&str]| remarks.iter().any(|remark| has_word(remark, wanted));
    one_of(says(&["above", "upwards", "up"]), says(&["below", "downwards", "down"]))
}

/// Do they say that an angle turns anticlockwise, or is above **i**?
fn says_anticlockwise(remarks: &[&String]) -> Option<bool> {
    const ANTICLOCKWISE: [&str; 6] = ["anticlockwise", "counterclockwise", "above", "upwards", "up", "left"];
    const CLOCKWISE: [&str; 5] = ["clockwise", "below", "downwards", "down", "right"];
    let says = |wanted: &[&str]| {
        let in_one = |remark: &String| remark.replace("ti-clock", "ticlock").replace("er-clock", "erclock");
        remarks.iter().any(|remark| has_word(&in_one(remark), wanted))
    };
    one_of(says(&ANTICLOCKWISE), says(&CLOCKWISE))
}

fn has_word(remark: &str, wanted: &[&str]) -> bool {
    sorts::words(remark).any(|word| wanted.contains(&word))
}

pub(super) fn is_positive(expr: &Expr) -> Option<bool> {
    exact::value(expr, &[])?.sign().filter(|sign| sign.is_ne()).map(Ordering::is_gt)
}
