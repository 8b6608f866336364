//! Words that say what is not so in the scene, edit by edit: each check has its table beside it, and here is what reads them,
//! and what is of several checks.

use super::said::contradicted;
use super::truth;
use crate::examine::{Edits, edited};
use crate::generate::Deal;
use crate::paper::words;

/// What is said of the first variant of a shipped question after edits.
pub(super) fn said(id: &str, edits: Edits) -> String {
    let question = edited(id, edits);
    let style = &question.styles[0];
    let variant = Deal::new(&question, style, 1).next().unwrap();
    let mut remarks = Vec::new();
    let words = words(&question, style, &variant);
    truth::untrue(&truth::Claims::of(&words), &words, &variant, &mut remarks);
    let found = contradicted(&question, style, &variant);
    found.into_iter().map(|finding| finding.message).chain(remarks.iter().map(|remark| format!("{remark:?}"))).collect()
}

#[test]
fn sentences_of_other_teachers_contradict_nothing() {
    let (rest, apart) = ("rest/speeds-and-directions", "direct/restitution-from-one-speed");
    let (old, wall) = ("direct/mass-from-the-velocities", "walls/wall-along-a-vector");
    let reversed =
        "and the direction of\nmotion of *A* is reversed. Immediately after the collision the speed of *A* is {v m/s}.";
    let each = "After they have collided directly each sphere is moving in the direction opposite to\n\
                its old one, *A* with speed {vA} and *B* with speed {vB}.";
    let own = "After they have collided directly *A* is moving with speed {vA} in the direction opposite to that in which it was \
               moving before, and *B* is moving with speed {vB}, also in the opposite direction to before.";
    let strikes = "is sliding on a smooth horizontal surface. It strikes a smooth vertical wall which is parallel\n\
                   to the vector {[f, g]}. Immediately before the impact the velocity of *A* is {[x, y] m/s}.";
    let moving = "moving on a smooth horizontal plane with velocity {[x, y] m/s}, collides with a smooth vertical wall \
                  and rebounds. The wall is parallel to the vector {[f, g]}.";
    let back = "backwards/velocity-of-b-and-restitution";
    let after = "when they\ncollide.\n\nImmediately after the collision the velocity of *A* is {[vAx, vAy] m/s}.";
    let again = "rest/components-of-each-velocity";
    let heavier = "rest/heavier-sphere-struck";
    let struck = "rest on a smooth horizontal plane when it is struck by *A*, which is moving on the plane.";
    let (second, angle) = ("successive/second-collision", "successive/walls-at-an-angle");
    let energy = "i-j/energy-lost";
    let velocities = "They are moving on a smooth\nhorizontal plane when they collide. Immediately before the collision the \
                      velocity of *A* is {[ax, ay] m/s} and the velocity\nof *B* is {[bx, by] m/s}.";
    let in_turn = "*A*, moving with velocity {[ax, ay] m/s}, collides with *B*, moving with velocity {[bx, by] m/s}.";
    let crossed = "*A*, moving with velocity {[bx, by] m/s}, collides with *B*, moving with velocity {[bx, by] m/s}.";
    let rebounds = "They collide directly and each of them rebounds: *A* then moves with speed {vA}, and *B* is then moving \
                    with speed {vB}.";
    let table: [(&str, Edits, &str); 25] = [
        (energy, &[(velocities, in_turn)], ""),
        (energy, &[(velocities, crossed)], "give `*A*` the velocity `[bx, by]`"),
        (old, &[(each, rebounds)], ""),
        (
            second,
            &[(
                "Sphere *A* is moving with speed {u m/s} along",
                "*A* is on the other side of *B* from the wall, and is moving with speed {u m/s} along",
            )],
            "",
        ),
        (
            angle,
            &[(
                "The velocity of *A* is {[x, y] m/s} when it strikes the first wall; then it strikes the\nsecond.",
                "It comes with velocity {[x, y] m/s} to the first wall and, after rebounding from it, hits the second wall.",
            )],
            "",
        ),
        (
            rest,
            &[("*A*, of mass {mA kg}, is moving", "*A*, of mass {mA kg}, is at rest")],
            "say that `*A*` is at rest, and in the scene it moves",
        ),
        (
            "direct/velocities-in-letters",
            &[("{m}, {u} and {e}, the kinetic", "{m}, {u} and {e}, which is greater than 1, the kinetic")],
            "say that `e` is greater than 1",
        ),
        (
            rest,
            &[("spheres is {e}.", "spheres is {e}, which is greater than 1.")],
            "say that `e` is greater than 1, and it is",
        ),
        (rest, &[("spheres is {e}.", "spheres is {e}, which is less than 1.")], ""),
        (again, &[], ""),
        (heavier, &[(struck, "rest on a smooth horizontal plane. *A* strikes the heavier sphere *B*.")], ""),
        (
            heavier,
            &[(struck, "rest on a smooth horizontal plane. *A* strikes a lighter sphere *B*.")],
            "a comparison that is not so",
        ),
        (back, &[(after, "and collide. *A* moves off with velocity {[vAx, vAy] m/s}.")], ""),
        (
            back,
            &[(after, "and collide. *A* moves off with velocity {[vAy, vAx] m/s}.")],
            "give `*A*` the velocity `[vAy, vAx]`",
        ),
        (
            "successive/corner",
            &[("before = { A = [\"x\", \"y\"] }", "before = { A = [\"y\", \"x\"] }")],
            "the velocity `[x, y]`",
        ),
        (
            "vector-impulse/mass-from-the-speed-after",
            &[("speed immediately after the impulse is", "speed immediately before the impulse is")],
            "give `*A*` the speed `v`",
        ),
        (
            "vector-impulse/mass-from-the-speed-after",
            &[("speed immediately after the impulse", "speed after it receives the impulse")],
            "",
        ),
        (rest, &[("which is at rest on the plane", "which rests on the plane")], ""),
        (rest, &[("which is at rest on the plane", "which is not moving")], ""),
        (rest, &[("which is at rest on the plane", "on the plane")], "do not say that `*B*` is at rest"),
        (
            apart,
            &[(reversed, "and after they collide *A* moves in the opposite direction to its original direction.")],
            "",
        ),
        (
            apart,
            &[(reversed, "and after they collide *A* moves on in its original direction.")],
            "`*A*` then moves in its old direction",
        ),
        (old, &[(each, own)], ""),
        (wall, &[(strikes, moving)], ""),
        (wall, &[(strikes, &moving.replace("[x, y]", "[x, -y]"))], "give `*A*` the velocity `[x, -y]`"),
    ];
    for (id, edits, words) in table {
        let said = said(id, edits);
        assert!(said.contains(words) && said.is_empty() == words.is_empty(), "{id}: {edits:?}: {said}");
    }
}

/// What is said after each edit; nothing where no words are to be said.
pub(super) fn assert_said(table: &[(&str, &str, &str, &str)]) {
    let mut wrong = Vec::new();
    for (id, from, to, words) in table.iter().copied() {
        let said = said(id, &[(from, to)]);
        if !said.contains(words) || said.is_empty() != words.is_empty() {
            wrong.push(format!("{id}: {to}: {said}"));
        }
    }
    assert!(wrong.is_empty(), "{wrong:#?}");
}

#[test]
fn a_letter_for_what_is_to_be_shown_is_no_other_value() {
    let ask = "taking the direction of motion of *A* before it as positive.";
    let shown = |sphere: &str| format!("Show that the speed of *{sphere}* is then {{v}}, where {{display: result}}");
    let found = |sphere: &str| {
        said(
            "direct/velocities-in-letters",
            &[
                (ask, &shown(sphere)),
                ("e = \"unit\"", "e = \"unit\"\nv = \"positive\""),
                ("find = \"A.after.n\", accept = \"exact\"", "find = \"A.after.n\", kind = \"shown\", show = \"v\""),
                ("\"A1\", for = \"A.after.n\"", "\"A1*\", for = \"A.after.n\""),
            ],
        )
    };
    assert_eq!(found("A"), "");
    assert!(found("B").contains("give `*B*` the speed `v`"), "{}", found("B"));
}
