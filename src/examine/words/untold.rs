//! What decides the answer and is never told to a student: conditions of the scene, how **i** and **j** lie, and from which
//! line an angle is measured.

use super::sentence::{Noun, Sentence, Token, is_one_of, noun_of, says, sentences};
use crate::bank::{Question, Style};
use crate::examine::Finding;
use crate::expr::{Angles, Expr, print, read};
use crate::mechanics::{Axis, Moment, Quantity, Sphere, VelocityText};
use crate::unit::Unit;

/// Conditions on a turn, on the way in which a sphere goes on, or on who is the faster afterwards, where no word tells of
/// such a thing. What a condition takes by name is looked for where names are.
pub fn conditions(question: &Question) -> Vec<Finding> {
    let mut findings = Vec::new();
    let is_in_a_line = matches!(question.scene.before.a, Some(VelocityText::Along(_)));
    for condition in &question.scene.conditions {
        let untold = question.styles.iter().find_map(|style| {
            let asks = question.parts.iter().flat_map(|part| &part.ask);
            let texts = style.stem.iter().chain([&style.note]).chain(asks);
            let said: Vec<Sentence> = texts.flat_map(sentences).collect();
            untold(condition, &said, is_in_a_line)
        });
        if let Some(Untold { what, example, is_hinted }) = untold {
            let message = format!("the words never tell of {what}, which the condition `{condition}` takes");
            let help = format!("say it in the stem or in the part, as in `{example}`; or take the condition out");
            let found = Finding::new(message, format!("\"{condition}\""), "a student cannot know it").with_help(help);
            findings.push(if is_hinted { found.as_warning() } else { found });
        }
    }
    findings
}

/// A coefficient of restitution that is a number in the scene, where no word tells of it.
pub fn elasticity(question: &Question) -> Vec<Finding> {
    const TOLD: [&str; 7] =
        ["elastic", "elastically", "inelastic", "inelastically", "restitution", "coalesce", "coalesced"];
    let is_number = |text: &&String| read(text, Angles::Degrees).is_ok_and(|expr| expr.names().is_empty());
    let scene = &question.scene;
    let given = scene.e.iter().chain(scene.then.iter().filter_map(|then| then.e.as_ref())).find(is_number);
    let is_told = |style: &Style| {
        let asks = question.parts.iter().flat_map(|part| &part.ask);
        let mut said = style.stem.iter().chain([&style.note]).chain(asks).flat_map(sentences);
        // That no energy is lost tells of an elastic impact, and of no other.
        said.any(|sentence| says(&sentence, &TOLD) || (says(&sentence, &["energy"]) && given.is_some_and(|e| e == "1")))
    };
    let Some(e) = given.filter(|_| !question.styles.iter().all(is_told)) else { return Vec::new() };
    let message = format!("the words never tell of the coefficient of restitution, which is {e} in the scene");
    let example =
        if e == "1" { "The collision is perfectly elastic." } else { "The coefficient of restitution is …" };
    let found = Finding::new(message, format!("e = \"{e}\""), "a student cannot know it");
    vec![found.with_help(format!("say it in the stem, as in `{example}`"))]
}

/// A sphere that turns back in one line, as its velocity after the impact is given with the other sign, where no word tells
/// of it.
pub fn turned_back(question: &Question) -> Vec<Finding> {
    let scene = &question.scene;
    let is_negative = |velocity: &Option<VelocityText<String>>| match velocity {
        Some(VelocityText::Along(text)) if text.trim() != "0" => Some(text.trim().starts_with('-')),
        _ => None,
    };
    let of = [(Sphere::A, &scene.before.a, &scene.after.a), (Sphere::B, &scene.before.b, &scene.after.b)];
    let is_turned =
        |before, after| is_negative(before).zip(is_negative(after)).is_some_and(|(one, other)| one != other);
    let is_told = |style: &Style| {
        let asks = question.parts.iter().flat_map(|part| &part.ask);
        let mut said = style.stem.iter().chain([&style.note]).chain(asks).flat_map(sentences);
        said.any(|sentence| tells_of_the_way_after(&sentence))
    };
    let Some((sphere, ..)) = of.into_iter().find(|(_, before, after)| is_turned(before, after)) else {
        return Vec::new();
    };
    if question.styles.iter().all(is_told) {
        return Vec::new();
    }
    let name = sphere.name();
    let message = format!("the words never tell that `*{name}*` turns back, as it does in the scene");
    let help = format!("say it in the stem, as in `The direction of motion of *{name}* is reversed.`");
    vec![Finding::new(message, "after =", "a student cannot know it").with_help(help)]
}

/// Vectors in **i** and **j** of which no sentence says that they are unit vectors, or how they lie.
pub fn unit_vectors(question: &Question) -> Vec<Finding> {
    let is_of_them = |expr: &Expr| {
        matches!(expr, Expr::Vector(..)) || expr.names().iter().any(|name| matches!(name.text.as_str(), "i" | "j"))
    };
    let introduces = |sentence: &Sentence| says(sentence, &["vector", "vectors"]) && says(sentence, &["unit"]);
    let is_told = |sentence: &Sentence| introduces(sentence) || says(sentence, &["east", "north"]);
    let untold = question.styles.iter().any(|style| {
        let asks = question.parts.iter().flat_map(|part| &part.ask);
        let said: Vec<Sentence> = style.stem.iter().chain([&style.note]).chain(asks).flat_map(sentences).collect();
        let are_used = said.iter().flatten().any(|token| matches!(token, Token::Number(expr, ..) if is_of_them(expr)));
        are_used && !said.iter().any(is_told)
    });
    let styles = question.styles.iter().flat_map(|style| &style.stem).flat_map(sentences);
    let are_parallel = |sentence: Sentence| {
        let pairs = sentence.windows(3);
        pairs.into_iter().any(|three| {
            is_one_of(&three[0], &["parallel"]) && is_one_of(&three[1], &["unit"]) && is_one_of(&three[2], &["vectors"])
        })
    };
    if styles.into_iter().any(are_parallel) {
        let found = Finding::new("the words say that the unit vectors are parallel", "parallel unit", "they are axes");
        return vec![found.with_help("say `perpendicular unit vectors`")];
    }
    let found = || {
        let message = "the words never tell what {i} and {j} are, in which vectors are given";
        let help = "begin the stem with `_[In this question_ {i} _and_ {j} _are perpendicular unit vectors.]_`";
        Finding::new(message, "{i}", "a student may not know how they lie").with_help(help).as_warning()
    };
    untold.then(found).into_iter().collect()
}

/// Angles that are given and of which no word says between what they are.
pub fn lines_of_angles(question: &Question) -> Vec<Finding> {
    const BETWEEN: [&str; 16] = [
        "meet",
        "meeting",
        "with",
        "to",
        "from",
        "between",
        "above",
        "below",
        "against",
        "through",
        "deflected",
        "turned",
        "turns",
        "than",
        "paths",
        "inclined",
    ];
    let untold = |sentence: &Sentence| {
        let is_angle = |place: usize| matches!(noun_of(sentence, place), Some((_, Noun::Angle, _)));
        let angle =
            (0..sentence.len()).find(|place| matches!(sentence[*place], Token::Number(..)) && is_angle(*place))?;
        let Token::Number(expr, _, lead) = &sentence[angle] else { return None };
        // Of a letter the words may tell elsewhere what angle it is.
        let is_open = matches!(expr, Expr::Name(name) if question.scene.symbols.contains_key(&name.text));
        (!says(sentence, &BETWEEN) && !is_open).then(|| (lead.clone(), print::plain(expr)))
    };
    let texts = question.styles.iter().flat_map(|style| style.stem.iter().chain([&style.note]));
    let found = texts.flat_map(sentences).find_map(|sentence| untold(&sentence)).map(|(lead, angle)| {
        let message = format!("the words never tell from which line the angle `{angle}` is measured");
        let help = "go on with `to the line of centres`, `with the wall` or `to the direction of {i}`";
        Finding::new(message, lead.trim(), "it may be measured from any line").with_help(help).as_warning()
    });
    found.into_iter().collect()
}

/// What no sentence tells of.
struct Untold {
    what: &'static str,
    /// How it might be told.
    example: &'static str,
    /// Are there words that may speak of it, though perhaps of another time?
    is_hinted: bool,
}

/// What a condition takes that no sentence tells of.
fn untold(condition: &str, said: &[Sentence], is_in_a_line: bool) -> Option<Untold> {
    let (left, right) = condition.split_once(['=', '<', '>'])?;
    let right = right.trim_start_matches('=').trim();
    let sides = [left.trim(), right].map(|side| side.parse::<Quantity>().ok().map(Quantity::of_its_impact));
    let along = |side: Option<Quantity>| matches!(side, Some(Quantity::Velocity(_, Moment::After, Axis::N | Axis::X)));
    let is_equation = condition.contains('=') && !condition.contains(['<', '>']);
    let any = |words: &[&str]| said.iter().any(|sentence| says(sentence, words));
    let is_told = |what: bool| what.then_some(());
    match (sides, right) {
        ([Some(Quantity::DeflectionDot(_)), None], "0") | ([Some(Quantity::Deflection(_)), None], "90") => {
            // What is said to be turned through another angle is told where it is said.
            let is_turned = |sentence: &Sentence| says(sentence, &["through"]) && !says(sentence, &["which"]);
            let is_right = said.iter().any(|sentence| tells_of_a_right_angle(sentence) || is_turned(sentence));
            // The angle of a path with a line may be acute too.
            let is_of_turn = |sentence: &Sentence| {
                says(sentence, &["acute", "obtuse"]) && says(sentence, &["turned", "turns", "deflected", "deflection"])
            };
            let is_sharp = !is_equation && said.iter().any(is_of_turn);
            is_told(!is_right && !is_sharp)?;
            let is_hinted = !is_equation && any(&["acute", "obtuse"]) && any(&["turned", "deflected", "deflection"]);
            let example = "The direction of motion of *A* is turned through a right angle.";
            Some(Untold { what: "the right angle", example, is_hinted })
        }
        ([side, None], "0") if along(side) && is_equation => {
            let tells = |sentence: &Sentence| {
                tells_of_rest(sentence) || tells_of_the_way_after(sentence) || sentence.iter().any(is_ninety_degrees)
            };
            is_told(!said.iter().any(|sentence| tells(sentence) && may_be_of(sentence, side)))?;
            // In a plane it still moves across the line of centres.
            let (what, example) = match is_in_a_line {
                true => ("a sphere that is brought to rest", "Immediately after the collision *A* is at rest."),
                false => (
                    "a sphere that goes on perpendicular to the line of centres",
                    "Immediately after the collision *A* moves perpendicular to the line of centres.",
                ),
            };
            Some(Untold { what, example, is_hinted: false })
        }
        ([side, None], "0") if along(side) => {
            is_told(!said.iter().any(|sentence| tells_of_the_way_after(sentence) && may_be_of(sentence, side)))?;
            let example = match condition.contains('>') {
                true => "The direction of motion of *A* is not changed.",
                false => "The direction of motion of *A* is reversed.",
            };
            Some(Untold { what: "the way in which a sphere goes on", example, is_hinted: false })
        }
        ([one, other], _) if along(one) && along(other) => {
            // `*B* does not strike *C* again` tells nothing of *A*.
            let is_theirs = |sentence: &Sentence| may_be_of(sentence, one) && may_be_of(sentence, other);
            is_told(!said.iter().any(|sentence| says(sentence, &AGAIN) && is_theirs(sentence)))?;
            let example = "*A* and *B* do not collide again.";
            Some(Untold { what: "who meets again, or does not", example, is_hinted: false })
        }
        _ => None,
    }
}

/// May a sentence be of the sphere of a quantity? Not if it names another sphere alone.
fn may_be_of(sentence: &[Token], quantity: Option<Quantity>) -> bool {
    let names = |sphere: Sphere| sentence.contains(&Token::Sphere(sphere));
    let own = quantity.and_then(Quantity::sphere);
    own.is_none_or(names)
        || !Sphere::ALL.into_iter().any(names)
        || says(sentence, &["both", "each", "they", "spheres", "it", "its", "other", "collision", "collisions"])
}

/// `Is brought to rest`, `stops`, and not `which is at rest`; along a line of centres `moves perpendicular to it` too.
fn tells_of_rest(sentence: &[Token]) -> bool {
    const STOPS: [&str; 10] =
        ["stops", "stop", "stopped", "stationary", "zero", "nought", "perpendicular", "right", "tangent", "motionless"];
    const THEN: [&str; 10] =
        ["after", "afterwards", "brought", "brings", "bring", "comes", "come", "reduced", "left", "then"];
    says(sentence, &STOPS) || (says(sentence, &["rest"]) && says(sentence, &THEN))
}

/// `Rebounds`, `is reversed`, `goes on in the same direction after it`: a way, and not the one before the impact.
fn tells_of_the_way_after(sentence: &[Token]) -> bool {
    const TURNED: [&str; 18] = [
        "reversed",
        "reverses",
        "reverse",
        "unchanged",
        "changed",
        "changes",
        "change",
        "rebound",
        "rebounds",
        "rebounding",
        "back",
        "backwards",
        "continues",
        "continue",
        "turned",
        "turns",
        "goes",
        "carries",
    ];
    const THEN: [&str; 8] = ["after", "afterwards", "result", "then", "leaves", "subsequently", "old", "original"];
    let is_as_before = |pair: &[Token]| is_one_of(&pair[0], &["as"]) && is_one_of(&pair[1], &["before"]);
    let is_then = says(sentence, &THEN) || sentence.windows(2).any(is_as_before);
    says(sentence, &TURNED) || (is_then && says(sentence, &WAYS))
}

/// Words of which way something moves.
const WAYS: [&str; 19] = [
    "direction",
    "directions",
    "reversed",
    "unchanged",
    "rebound",
    "rebounds",
    "rebounding",
    "back",
    "backwards",
    "opposite",
    "same",
    "towards",
    "away",
    "forward",
    "forwards",
    "continues",
    "goes",
    "turned",
    "turns",
];

/// Words of spheres that meet again, or never do, and of those that are faster than others.
const AGAIN: [&str; 15] = [
    "again",
    "another",
    "third",
    "exactly",
    "further",
    "more",
    "second",
    "subsequent",
    "subsequently",
    "catches",
    "catch",
    "once",
    "overtakes",
    "faster",
    "slower",
];

/// `A right angle`, `90 degrees`, `perpendicular to its old direction`.
fn tells_of_a_right_angle(sentence: &[Token]) -> bool {
    // These are perpendicular, and turn nothing.
    const OTHERS: [&str; 9] =
        ["vectors", "wall", "walls", "centres", "component", "components", "distance", "radius", "plane"];
    let is_pair = |pair: &[Token]| is_one_of(&pair[0], &["right"]) && is_one_of(&pair[1], &["angle", "angles"]);
    sentence.windows(2).any(is_pair)
        || sentence.iter().any(is_ninety_degrees)
        || (says(sentence, &["perpendicular"]) && !says(sentence, &OTHERS))
        || (0..sentence.len()).any(|at| is_across_the_old_way(&sentence[at..]))
}

/// `Perpendicular to its original path`
fn is_across_the_old_way(words: &[Token]) -> bool {
    const LEADING: [&str; 8] = ["to", "its", "the", "original", "old", "initial", "former", "previous"];
    let Some((first, rest)) = words.split_first() else { return false };
    let lead = rest.iter().take_while(|token| is_one_of(token, &LEADING));
    let way = rest.get(lead.clone().count());
    is_one_of(first, &["perpendicular"])
        && lead.clone().count() > 2
        && way.is_some_and(|way| is_one_of(way, &["path", "direction", "course"]))
}

fn is_ninety_degrees(token: &Token) -> bool {
    match token {
        Token::Number(expr @ Expr::Number(_), Unit::Degree, _) => print::plain(expr) == "90",
        token => is_one_of(token, &["90", "right-angle", "right-angles"]),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::examine::{Edits, edited};

    #[test]
    fn unit_vectors_are_introduced() {
        let sentence = "_[In this question_ {i} _and_ {j} _are perpendicular unit vectors in a horizontal plane.]_";
        let east = "The unit vector {i} points east and {j} points north.";
        for id in ["i-j/energy-lost", "vector-impulse/velocity-after-an-impulse", "successive/corner"] {
            let found = |edits: Edits| unit_vectors(&edited(id, edits)).len();
            assert_eq!((found(&[]), found(&[(sentence, "")]), found(&[(sentence, east)])), (0, 1, 0), "{id}");
            assert_eq!(found(&[("are perpendicular unit vectors", "are parallel unit vectors")]), 1, "{id}");
        }
        assert!(unit_vectors(&edited("rest/speeds-and-directions", &[])).is_empty());
    }

    #[test]
    fn an_elastic_impact_and_a_sphere_that_turns_back_are_told_of() {
        let elastic = "deflection/elastic";
        let said = |id, edits: Edits| {
            let question = edited(id, edits);
            let found = elasticity(&question).into_iter().chain(turned_back(&question));
            found.map(|finding| finding.message).collect::<String>()
        };
        assert_eq!(said(elastic, &[]), "");
        let untold = said(elastic, &[(" The collision is perfectly elastic.", "")]);
        assert!(untold.contains("the coefficient of restitution, which is 1 in the scene"), "{untold}");
        let energy = (" The collision is perfectly elastic.", " No kinetic energy is lost.");
        assert_eq!(said(elastic, &[energy]), "");
        let untold = said(elastic, &[energy, ("e               = \"1\"", "e               = \"1/2\"")]);
        assert!(untold.contains("which is 1/2 in the scene"), "{untold}");
        let line = "direct/restitution-from-one-speed";
        assert_eq!(said(line, &[]), "");
        let untold = said(line, &[(", and the direction of\nmotion of *A* is reversed", "")]);
        assert!(untold.contains("never tell that `*A*` turns back"), "{untold}");
    }

    #[test]
    fn angles_are_measured_from_a_line() {
        let (id, line) = ("rest/speeds-and-directions", " with the line of centres");
        let found = |edits: Edits| {
            lines_of_angles(&edited(id, edits)).into_iter().map(|finding| finding.message).collect::<String>()
        };
        assert_eq!(found(&[]), "");
        assert!(
            found(&[(line, "")]).contains("from which line the angle `alpha` is measured"),
            "{}",
            found(&[(line, "")])
        );
    }

    #[test]
    fn a_condition_is_told_of() {
        let (wall, letters) = ("walls/turned-through-a-right-angle", "rest-letters/turned-through-a-right-angle");
        let turn = "The impact turns\nthe direction of motion of *A* through a right angle.";
        let line = "successive/no-more-collisions";
        let (reversed, goes_on) = ("ranges/direction-reversed", "ranges/mass-ratio-when-a-goes-on");
        let back = "The direction of motion of *A* is reversed by the collision. Find";
        let on = "The direction of motion of *A* is not changed by the collision. Find";
        let at_rest = ("conditions = [\"A.after.x < 0\"]", "conditions = [\"A.after.x = 0\"]");
        let single = (", kind = \"range\"", "");
        let more = "The direction of motion of *A* is turned through more than a right angle by the impact. Find";
        let oblique = "ranges/turned-back-by-an-oblique-impact";
        let away = "After the collision the component of the velocity of *A* along the line of centres is directed away from *B*. Find";
        let across = ("conditions      = [\"A.after.n < 0\"]", "conditions = [\"A.after.n = 0\"]");
        let table: [(&str, Edits, &str); 39] = [
            (wall, &[(turn, "Once it has left the wall its path is perpendicular to its original path.")], ""),
            (oblique, &[across, single, (away, "*A* then moves along the common tangent. Find")], ""),
            (oblique, &[across, single, (away, "Its new path makes {90 deg} with the line of centres. Find")], ""),
            (oblique, &[across, single, (away, "Find")], "a sphere that goes on perpendicular to the line of centres"),
            (oblique, &[across, single, (away, "*A* then moves perpendicular to the line of centres. Find")], ""),
            (reversed, &[(back, "Find")], "the way in which a sphere goes on"),
            (reversed, &[(back, "As a result *A* moves away from *B*. Find")], ""),
            (reversed, &[(back, "For *A* to rebound, find")], ""),
            (reversed, &[(back, "The collision reverses the motion of *A*. Find")], ""),
            (reversed, &[(back, "*A* moves in the opposite direction after the collision. Find")], ""),
            (goes_on, &[(on, "Find")], "the way in which a sphere goes on"),
            (goes_on, &[(on, "*A* moves in the same direction as before. Find")], ""),
            (goes_on, &[(on, "*A* continues in its direction. Find")], ""),
            (
                goes_on,
                &[(on, "The direction of motion of *B* is not changed. Find")],
                "the way in which a sphere goes on",
            ),
            (reversed, &[at_rest, single, (back, "*B* is brought to rest. Find")], "a sphere that is brought to rest"),
            ("ranges/turned-through-more-than-a-right-angle", &[(more, "Find")], "the right angle"),
            (reversed, &[at_rest, single, (back, "Find")], "a sphere that is brought to rest"),
            (reversed, &[at_rest, single, (back, "*A* is brought to rest by the collision. Find")], ""),
            (reversed, &[at_rest, single, (back, "Immediately after the collision *A* is at rest. Find")], ""),
            (reversed, &[at_rest, single, (back, "*A* stops. Find")], ""),
            (reversed, &[at_rest, single, (back, "The velocity of *A* is then zero. Find")], ""),
            (reversed, &[at_rest, single, (back, "The collision leaves *A* stationary. Find")], ""),
            (wall, &[], ""),
            (wall, &[(turn, "")], "never tell of the right angle, which the condition `A.deflection_dot = 0` takes"),
            (wall, &[(turn, "The impact turns it through 90°.")], ""),
            (wall, &[(turn, "The impact turns it through {90 deg}.")], ""),
            (wall, &[(turn, "After the impact *A* moves at right angles to its old path.")], ""),
            (wall, &[(turn, "The paths of *A* before and after the impact are perpendicular.")], ""),
            (wall, &[(turn, "The impact turns it through 60°.")], ""),
            (wall, &[(turn, "The wall is perpendicular to the floor.")], "never tell of the right angle"),
            (letters, &[], ""),
            (
                letters,
                &[(
                    " As a result of the collision, the direction of motion of *A* is turned through a right angle.",
                    "",
                )],
                "never tell of the right angle",
            ),
            (line, &[], ""),
            (line, &[("After *B* has struck *C*, *A* does not strike *B* again. Find", "Find")], "who meets again"),
            (line, &[("*A* does not strike *B* again", "*A* and *B* collide only once")], ""),
            (line, &[("*A* does not strike *B* again", "*B* does not strike *C* again")], "who meets again"),
            (
                line,
                &[(
                    "After *B* has struck *C*, *A* does not strike *B* again. Find",
                    "There is no third collision. Find",
                )],
                "",
            ),
            (
                line,
                &[(
                    "After *B* has struck *C*, *A* does not strike *B* again. Find",
                    "There are exactly two collisions. Find",
                )],
                "",
            ),
            ("ranges/turned-through-more-than-a-right-angle", &[], ""),
        ];
        for (id, edits, words) in table {
            let said: String = conditions(&edited(id, edits)).into_iter().map(|finding| finding.message).collect();
            assert!(said.contains(words) && said.is_empty() == words.is_empty(), "{id}: {edits:?}: {said}");
        }
    }
}
