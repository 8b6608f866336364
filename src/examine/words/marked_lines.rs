//! Along which line the text of a mark has the component for which the mark is.

use super::sentence::{Token, is_one_of, sentences};
use crate::bank::{EarnedFor, Mark, Question};
use crate::examine::Finding;
use crate::expr::{Expr, Text};
use crate::mechanics::{Axis, Moment, Quantity, Sphere};

/// What a text measures a component along.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Along {
    /// The line of centres, or the normal to the wall; or what is across it.
    Line(Axis),
    /// A unit vector.
    Vector(Axis),
}

/// Marks for a component, whose text names the other line.
pub fn of_another_line(question: &Question) -> Vec<Finding> {
    let mut findings = Vec::new();
    for (place, part) in question.parts.iter().enumerate() {
        for (row, mark) in part.marks.iter().enumerate() {
            let said = mark.text.as_ref().map(components).unwrap_or_default();
            let said: Option<Vec<Axis>> = said.into_iter().map(|along| axis(along, question)).collect();
            let Some(said) = said.filter(|said| !said.is_empty()) else { continue };
            let Some(own) = own_axis(mark).filter(|own| !said.contains(own)) else { continue };
            let has = |axis| if axis == Axis::N { "along the line of centres" } else { "perpendicular to it" };
            let wall = |axis| if axis == Axis::N { "perpendicular to the wall" } else { "parallel to the wall" };
            let shown = |axis| if question.scene.wall.is_some() { wall(axis) } else { has(axis) };
            let message = format!(
                "the text of the mark {} is of a component {}, and it is for `{}`, which is of one {}",
                mark.id,
                shown(said[0]),
                mark.earned_for,
                shown(own)
            );
            let found = Finding::new(message, "", "of another component");
            let help = "name the other line in its `text`, or mend `for`";
            findings.push(found.with_help(help).at_row(place, "marks", row).as_warning());
        }
    }
    findings
}

/// Along the line of centres or across it: the axis of the component for which a mark is, or which its law gives alone.
fn own_axis(mark: &Mark) -> Option<Axis> {
    match &mark.earned_for {
        EarnedFor::Law(law, _) => {
            let gives = |axis| law.gives(Quantity::Velocity(Sphere::A, Moment::After, axis));
            match (gives(Axis::N), gives(Axis::T)) {
                (true, false) => Some(Axis::N),
                (false, true) => Some(Axis::T),
                _ => None,
            }
        }
        EarnedFor::Quantity(_) | EarnedFor::Both(_) => {
            let axis = |quantity: &Quantity| match quantity.of_its_impact() {
                Quantity::Velocity(_, _, axis @ (Axis::N | Axis::T)) => Some(axis),
                _ => None,
            };
            let mut axes = mark.earned_for.quantities().iter().map(axis);
            let first = axes.next()??;
            axes.all(|other| other == Some(first)).then_some(first)
        }
        _ => None,
    }
}

/// What the components of a text are along: `component parallel to {i}`, `component perpendicular to the wall`.
fn components(text: &Text) -> Vec<Along> {
    let mut found = Vec::new();
    for sentence in sentences(text) {
        for (place, token) in sentence.iter().enumerate() {
            let is_across = match token {
                _ if is_one_of(token, &["perpendicular", "normal"]) => true,
                _ if is_one_of(token, &["parallel", "along"]) => false,
                _ => continue,
            };
            // `The impulse is parallel to {j}`
            let is_of_impulse =
                sentence[place.saturating_sub(4)..place].iter().any(|token| is_one_of(token, &["impulse"]));
            let is_of_one =
                !is_of_impulse && sentence[..place].iter().any(|token| is_one_of(token, &["component", "components"]));
            let turned = |axis: Axis| match (axis, is_across) {
                (axis, false) => axis,
                (Axis::N, _) => Axis::T,
                (Axis::T, _) => Axis::N,
                (Axis::X, _) => Axis::Y,
                (Axis::Y, _) => Axis::X,
            };
            let next = sentence[place + 1..].iter().take(5).find_map(|token| match token {
                Token::Number(Expr::Name(name), ..) if name.text == "i" => Some(Along::Vector(turned(Axis::X))),
                Token::Number(Expr::Name(name), ..) if name.text == "j" => Some(Along::Vector(turned(Axis::Y))),
                _ if is_one_of(token, &["centres"]) => Some(Along::Line(turned(Axis::N))),
                _ if is_one_of(token, &["wall"]) => Some(Along::Line(turned(Axis::T))),
                _ => None,
            });
            found.extend(next.filter(|_| is_of_one));
        }
    }
    found
}

/// The axis along the line of centres, or across it, that is meant; of **i** and **j** where there is one impact, and one of
/// them is parallel to that line.
fn axis(along: Along, question: &Question) -> Option<Axis> {
    let scene = &question.scene;
    let vector = match along {
        Along::Line(axis) => return Some(axis),
        Along::Vector(axis) => axis,
    };
    let (line, own) = match (&scene.line_of_centres, &scene.wall) {
        _ if !scene.then.is_empty() => return None,
        (Some(line), _) => (line, Axis::N),
        (None, Some(wall)) => (wall, Axis::T),
        (None, None) => return None,
    };
    let along_line = match [line[0].as_str(), line[1].as_str()] {
        [_, "0"] => Axis::X,
        ["0", _] => Axis::Y,
        _ => return None,
    };
    let other = if own == Axis::N { Axis::T } else { Axis::N };
    Some(if vector == along_line { own } else { other })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::examine::{Edits, edited};

    #[test]
    fn the_text_of_a_mark_is_of_the_component_for_which_it_is() {
        let (vectors, wall) = ("i-j/velocities-after-impact", "walls/rebound-speed-and-direction");
        let table: [(&str, Edits, &str); 7] = [
            (vectors, &[], ""),
            (
                vectors,
                &[("parallel to {i} unchanged", "parallel to {j} unchanged")],
                "the mark B1a is of a component along",
            ),
            (vectors, &[("parallel to {i} unchanged", "perpendicular to {j} unchanged")], ""),
            (
                wall,
                &[("velocity perpendicular to the wall", "velocity parallel to the wall")],
                "of a component parallel",
            ),
            (
                "both-moving/components-given",
                &[("perpendicular to the line of centres unchanged", "along the line of centres unchanged")],
                "which is of one perpendicular to it",
            ),
            (
                "both-moving/components-given",
                &[("A.after.n and B.after.n", "A.after.t and B.after.t")],
                "of a component along the line of centres, and it is for `A.after.t and B.after.t`",
            ),
            ("walls/velocity-in-i-and-j", &[], ""),
        ];
        for (id, edits, words) in table {
            let said: String = of_another_line(&edited(id, edits)).into_iter().map(|finding| finding.message).collect();
            assert!(said.contains(words) && said.is_empty() == words.is_empty(), "{id}: {edits:?}: {said}");
        }
    }
}
