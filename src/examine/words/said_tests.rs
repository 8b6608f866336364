//! What is said in the words and is not so in the scene, edit by edit.

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
    let table: [(&str, Edits, &str); 18] = [
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

#[test]
fn words_that_the_scene_contradicts_are_found() {
    let catches = "direct/one-sphere-catches-the-other";
    let (moving, rest, line) =
        ("both-moving/energy-lost-and-impulse", "rest/speeds-and-directions", "collide directly.");
    let (three, onto) = ("successive/three-in-a-line", "successive/struck-onto-a-wall");
    let table = [
        (catches, "*B* is {w m/s}", "*B* is {w m/s}", ""),
        (catches, "{mA kg} and {mB kg}", "{mB kg} and {mA kg}", "give `*A*` the mass `mB`"),
        (catches, "is {u m/s} and", "is {2*u m/s} and", "give `*A*` the speed `2*u`"),
        (catches, "in the same direction", "in opposite directions", "A and B move in opposite directions"),
        (catches, "in the same direction", "in the opposite direction along one line", "A and B move in the opposite"),
        (catches, line, "collide directly, and *A* carries on in the same direction as before.", ""),
        (catches, line, "collide directly. As a result *A* moves on with speed {w m/s}.", "give `*A*` the speed `w`"),
        (catches, line, "collide directly. *A* continues in the opposite direction.", "`*A*` moves in the opposite"),
        (catches, line, "collide directly, and *B* continues to move in its direction.", ""),
        (
            "deflection/equal-masses",
            "and each has mass {mA}",
            "and different masses",
            "say that the masses are different",
        ),
        (
            "rest/speeds-and-directions",
            "The spheres have equal radii.",
            "The spheres have different masses and equal radii.",
            "",
        ),
        (
            "vector-impulse/impulse-from-two-velocities",
            "struck by a stick. Immediately after it has been\nstruck its",
            "struck by a stick, and immediately after the hit its",
            "",
        ),
        (
            "vector-impulse/impulse-from-two-velocities",
            "struck by a stick. Immediately after it has been\nstruck its velocity is {[v, w] m/s}",
            "struck by a stick, and immediately after the hit its velocity is {[x, y] m/s}",
            "give `*A*` the velocity `[x, y]`",
        ),
        (
            "both-moving/paths-at-right-angles",
            "*B* is moving with speed {uB} along",
            "*B* is moving directly along",
            "",
        ),
        (catches, line, "collide directly. *A* does not change its direction.", ""),
        (catches, line, "collide directly. *A* reverses its direction.", "the direction of `*A*` is changed"),
        (
            catches,
            line,
            "collide directly. After that *A* moves in the direction opposite to that in which it was moving.",
            "then moves against its old direction",
        ),
        (
            moving,
            "moving towards the other",
            "moving towards each other in the same direction",
            "A and B move in the same direction",
        ),
        (catches, "in the same direction", "towards each other", "B moves towards A"),
        (catches, "in the same direction", "away from each other", "A moves away from B"),
        (catches, "collide directly.", "coalesce.", "the words say `coalesce`, for which e is 0"),
        (catches, "collide directly.", "collide obliquely.", "the words say `obliquely`"),
        (catches, "collide directly.", "collide. The direction of *A* is not reversed.", ""),
        (catches, "collide directly.", "collide. The direction of *B* is reversed.", "direction of `*B*` is reversed"),
        (
            "direct/mass-from-the-velocities",
            "opposite to\nits old one",
            "of its old one",
            "`*A*` then moves in its old",
        ),
        ("direct/mass-from-the-velocities", "to\nits old one", "to that of its former motion", ""),
        (
            "direct/mass-from-the-velocities",
            "opposite to\nits old one",
            "that it had, as before",
            "in its old direction",
        ),
        ("walls/tangents-in-letters", "towards a smooth", "away from a smooth", "away from the wall at first"),
        ("walls/tangents-in-letters", "rebounds from it", "rebounds, moving away from the wall", ""),
        (
            "walls/tangents-in-letters",
            "A smooth sphere *A* of mass {mass} slides",
            "A smooth sphere *A* of mass {mass} at rest slides",
            "at rest",
        ),
        (
            "walls/restitution-from-two-angles",
            "Before the collision the path of *A* makes an acute angle {alpha} with the wall, where {tan(alpha) = before}. After \
             the collision\nits path makes an acute angle {beta} with the wall, where {tan(beta) = after}.",
            "The path of *A* makes an acute angle {alpha} with the wall before the collision and an acute angle {beta} with \
             the wall after it, where {tan(alpha) = before} and {tan(beta) = after}.",
            "",
        ),
        (
            "walls/restitution-from-two-angles",
            "Before the collision the path of *A* makes an acute angle {alpha} with the wall, where {tan(alpha) = before}. After \
             the collision\nits path makes an acute angle {beta} with the wall, where {tan(beta) = after}.",
            "The path of *A* makes an acute angle {alpha} with the wall after the collision and an acute angle {beta} with \
             the wall before it, where {tan(alpha) = before} and {tan(beta) = after}.",
            "give `*A*` the angle `alpha`",
        ),
        ("walls/restitution-from-two-angles", "{tan(beta) = after}", "{sin(beta) = after}", "the angle `beta`"),
        ("walls/restitution-from-two-angles", "{beta} with the wall", "{beta} with the normal to the wall", "`beta`"),
        ("successive/second-collision", "{u m/s} along", "{u m/s} towards the wall along", ""),
        ("successive/second-collision", "{u m/s} along", "{u m/s} away from the wall along", "away from the wall"),
        ("ranges/mass-ratio-that-can-be", "{k*m} and", "{k} and", "give `*A*` the mass `k` where the scene gives it"),
        ("vector-impulse/size-of-the-impulse", "{[k*f, k*g] N s}", "{[f, g] N s}", "give the impulse `[f, g]`"),
        (moving, "collide.\n\nImm", "collide directly.\n\nImm", "the words say `directly`"),
        (moving, "acute angle of {alpha deg}", "acute angle of {beta deg}", "give `*A*` the angle `beta`"),
        (moving, "moving towards the other", "moving in the same direction", "A and B move in the same direction"),
        ("both-moving/components-given", "centres, towards *A*", "centres, away from *A*", "B moves away from A"),
        (
            "deflection/elastic",
            "perfectly elastic",
            "perfectly inelastic",
            "for which e is 0, and in the scene it is 1",
        ),
        (
            "walls/velocity-in-i-and-j",
            "wall is parallel to {i}",
            "wall is parallel to {j}",
            "the wall is parallel to j",
        ),
        ("walls/velocity-in-i-and-j", "wall is parallel to {i}", "wall is perpendicular to {j}", ""),
        ("successive/corner", "and the second to {j}", "and the second to {i}", "the wall is parallel to i"),
        ("i-j/energy-lost", "is parallel to {i}", "is perpendicular to {i}", "line of centres is perpendicular to i"),
        ("i-j/energy-lost", "{[bx, by] m/s}", "{[by, bx] m/s}", "give `*B*` the velocity"),
        (
            "ranges/direction-reversed",
            "collide directly",
            "collide directly and *A* continues in its direction",
            "`*A*` then moves in its old direction",
        ),
        (
            "ranges/direction-reversed",
            "A.after.x < 0",
            "A.after.x > 0",
            "the direction of `*A*` is reversed, and it is not",
        ),
        ("ranges/direction-reversed", "of *A* is reversed", "of *B* is reversed", "the direction of `*B*` is reversed"),
        ("ranges/direction-reversed", "moving towards it", "moving away from it", "`*A*` moves away from the other"),
        (
            "rest/speeds-and-directions",
            "which is at rest",
            "which is moving",
            "`*B*` is moving, and in the scene it is",
        ),
        ("walls/rebound-speed-and-direction", "{alpha deg} with the wall", "{alpha deg} to the wall", ""),
        (
            "walls/rebound-speed-and-direction",
            "{alpha deg} with the wall",
            "{alpha deg} with the normal to the wall",
            "give `*A*` the angle `alpha`",
        ),
        (
            "walls/rebound-speed-and-direction",
            "{e}.\n",
            "{e}. The direction of *A* is reversed.\n",
            "direction of `*A*` is reversed",
        ),
        (
            "walls/rebound-speed-and-direction",
            "{e}.\n",
            "{e}. The path of *A* is turned through a right angle.\n",
            "`*A*` is turned through 90°",
        ),
        ("walls/turned-through-a-right-angle", "through a right angle", "through an angle of {80 deg}", "through 80°"),
        (
            "ranges/turned-back-by-an-oblique-impact",
            "{tan(alpha) = t}",
            "{sin(alpha) = t}",
            "give `*A*` the angle `alpha`",
        ),
        ("ranges/turned-back-by-an-oblique-impact", "{tan(alpha) = t}", "{sin(alpha) = t/sqrt(1 + t^2)}", ""),
        (
            "ranges/turned-through-more-than-a-right-angle",
            "angle {alpha} with the wall",
            "angle {alpha} with the normal to the wall",
            "give `*A*` the angle `alpha`",
        ),
        (
            "rest-letters/direction-and-deflection",
            "acute angle {alpha} with the line of centres",
            "acute angle {alpha} with the common tangent",
            "give `*A*` the angle `alpha`",
        ),
        (
            "rest/speeds-and-directions",
            "spheres is {e}.",
            "spheres is {e}, and {sin(alpha) = 5/7}.",
            "the words say that `sin(alpha) = 5/7`",
        ),
        (
            "direct/velocities-in-letters",
            "taking the direction of motion of *A* before it as",
            "taking the direction opposite to the motion of *A* as",
            "take the other direction as positive",
        ),
        ("rest/speeds-and-directions", "is {e}.", "is {e}. Sphere *A* rebounds.", "`*A*` rebounds, and it is not so"),
        ("rest/speeds-and-directions", "have equal radii", "have different radii", "the radii are different"),
        (
            "rest/speeds-and-directions",
            "have equal radii",
            "have equal radii and equal masses",
            "`*A*` and `*B*` are not",
        ),
        (
            "i-j/energy-lost",
            "They are moving",
            "Their masses are equal. They are moving",
            "masses are equal, and those of",
        ),
        (
            "successive/three-in-a-line",
            "of equal radius and",
            "of equal radius, *A* and *B* of equal mass,",
            "are equal",
        ),
        ("deflection/equal-masses", "equal radii", "equal radii and the same mass", ""),
        ("successive/three-in-a-line", "in that order", "in the order *C*, *B*, *A*", ""),
        ("successive/three-in-a-line", "*A*, *B* and *C*, of", "*B*, *A* and *C*, of", "`*A*` between `*B*` and `*C*`"),
        ("successive/three-in-a-line", "in that order", "in the order *A*, *C*, *B*", "`*C*` between `*A*` and `*B*`"),
        ("i-j/energy-lost", "the velocity of *A* is", "the speed of *A* is", "call the vector `[ax, ay]` a speed"),
        (
            "i-j/energy-lost",
            "velocity of *A* is {[ax, ay] m/s}",
            "velocity of *A* is in the direction of {[ax, ay]}",
            "",
        ),
        (
            "rest/speeds-and-directions",
            "The spheres have equal radii",
            "The radius of *A* is twice that of *B*",
            "the radii are different",
        ),
        ("rest/speeds-and-directions", "have equal radii", "have equal radii, and one mass is twice the other", ""),
        ("rest/speeds-and-directions", "have equal radii", "have radius {5} and one has mass twice that of {4}", ""),
        (
            "rest/speeds-and-directions",
            "is {e}.",
            "is {e}. The path of *A* is turned through an angle and then makes another of {60 deg} with it.",
            "the words give `60 deg`, and nothing in the scene has it",
        ),
        (
            "rest-letters/distance-from-the-centre-of-b",
            "B = \"r\" }",
            "B = \"2*r\" }",
            "give the radius `r`, where the scene gives it 2r",
        ),
        (
            "rest-letters/distance-from-the-centre-of-b",
            "impact_parameter = \"-d\"",
            "impact_parameter = \"-d/2\"",
            "give the distance `d`",
        ),
        (
            "ranges/turned-through-more-than-a-right-angle",
            "more than a right angle by",
            "less than a right angle by",
            "turned through less than a right angle, and it is not so",
        ),
        (
            "ranges/turned-through-more-than-a-right-angle",
            "through more than a right angle by",
            "through an obtuse angle by",
            "",
        ),
        (
            "rest-letters/turned-through-a-right-angle",
            "turned through a right angle",
            "turned through an acute angle",
            "turned through an acute angle, and it is not so",
        ),
        (
            "ranges/turned-back-by-an-oblique-impact",
            "directed away from *B*",
            "directed towards *B*",
            "`*A*` then moves towards *B*",
        ),
        (
            "successive/second-collision",
            "*B* collides with *A* again",
            "*B* does not collide with *A* again",
            "do not meet again, and with the conditions of the scene they meet",
        ),
        (
            "successive/no-more-collisions",
            "does not strike *B* again",
            "strikes *B* again",
            "meet again, and with the conditions of the scene they do not meet",
        ),
        (
            "successive/no-more-collisions",
            "second.B.after.n >= A.after.n",
            "A.after.n > second.B.after.n",
            "do not meet again",
        ),
        (
            "ranges/mass-ratio-that-can-be",
            "with speed {vA}.",
            "with speed {vA}. After it *A* moves in the opposite direction.",
            "`*A*` moves in the opposite direction, and it is not so",
        ),
        (
            catches,
            "collide directly.",
            "collide directly. The speed of *A* increases.",
            "say `increases` of the speed of `*A*`",
        ),
        (catches, "collide directly.", "collide directly. The speed of *B* is increased.", ""),
        (
            "direct/mass-from-the-velocities",
            "are moving towards each other",
            "are moving in the same direction",
            "A and B move in the same direction",
        ),
        (
            "both-moving/components-given",
            "{p m/s} perpendicular to the line",
            "{p m/s} parallel to the line",
            "give `*A*` the component `p` along the line of centres",
        ),
        (
            "both-moving/components-given",
            "A = [\"a\", \"p\"]",
            "A = [\"p\", \"a\"]",
            "give `*A*` the component `a` along",
        ),
        (
            "both-moving/paths-at-right-angles",
            "{uA} perpendicular to the line",
            "{uA} along the line",
            "`*A*` moves along the line of centres",
        ),
        (
            "both-moving/paths-at-right-angles",
            "centres, towards *A*",
            "centres, towards *B*",
            "have `*B*` move towards itself",
        ),
        (
            "successive/struck-onto-a-wall",
            "which is perpendicular to the wall",
            "which is parallel to the wall",
            "the line of centres is parallel to the wall",
        ),
        (
            "vector-impulse/velocity-after-an-impulse",
            "impulse = [\"p\", \"q\"]",
            "impulse = [\"-p\", \"-q\"]",
            "give the impulse `[p, q]`",
        ),
        ("deflection/elastic", "perfectly elastic", "inelastic", "say `inelastic`, and in the scene e is 1"),
        (
            "rest/heavier-sphere-struck",
            "respectively. Sphere *B* is",
            "respectively. Sphere *B*, the lighter, is",
            "`*B*` is the lighter sphere",
        ),
        ("rest/heavier-sphere-struck", "respectively. Sphere *B* is", "respectively. The heavier sphere *B* is", ""),
        ("successive/corner", "meet at a\nright angle", "are perpendicular to each other", ""),
        (
            "successive/corner",
            "that meet at a\nright angle",
            "that are parallel to each other",
            "the walls are parallel",
        ),
        ("successive/corner", "two smooth fixed", "two parallel smooth fixed", "the walls are parallel"),
        (
            "successive/corner",
            "meet at a\nright angle.",
            "meet. Between the walls it moves parallel to one of them.",
            "",
        ),
        (
            "successive/walls-at-an-angle",
            "vertical walls.",
            "vertical walls. It meets none of the walls at right angles.",
            "",
        ),
        (
            "successive/walls-at-an-angle",
            "vertical walls.",
            "vertical walls that meet at right angles.",
            "at right angles",
        ),
        (onto, "which is perpendicular to the wall", "and the wall is perpendicular to the line of centres", ""),
        (
            onto,
            "which is perpendicular to the wall",
            "and the wall is parallel to the line of centres",
            "the line of centres is parallel to the wall",
        ),
        (three, "lie in that order\nin a", "lie in a", ""),
        (three, "lie in that order\nin a", "lie, with *B* between *A* and *C*, in a", ""),
        (
            three,
            "lie in that order\nin a",
            "lie, with *C* between *A* and *B*, in a",
            "put `*C*` between `*A*` and `*B*`",
        ),
        (three, "after *A* has struck it.", "after its collision with *A*.", ""),
        (
            three,
            "*C* immediately after they collide",
            "*C* after its collision with *A*",
            "collision of `*A*` and `*C*`",
        ),
        (
            "vector-impulse/mass-from-the-speed-after",
            "an impulse of\n",
            "an impulse of magnitude\n",
            "call the vector `[p, q]` a magnitude",
        ),
        (
            "rest/heavier-sphere-struck",
            "Sphere *B* is",
            "The heavier sphere is *A*. *B* is",
            "`*A*` is the heavier sphere",
        ),
        ("rest/heavier-sphere-struck", "Sphere *B* is", "The heavier sphere is *B*. *B* is", ""),
        (
            "ranges/direction-reversed",
            "spheres is {e}.",
            "spheres is {e}, where {e < 1/20}.",
            "say that `e < 1/20`, and it is",
        ),
        ("ranges/direction-reversed", "spheres is {e}.", "spheres is {e}, where {e > 1/20}.", ""),
        (
            "walls/turned-through-a-right-angle",
            "a right angle.\n",
            "a right angle, where {e < 1/20}.\n",
            "`e < 1/20`, and it is",
        ),
        (
            "rest-letters/turned-through-a-right-angle",
            "the direction of motion of *A* is turned",
            "the direction of motion of *B* is turned",
            "the path of `*B*` is turned, and `*B*` is at rest before",
        ),
        (
            "vector-impulse/mass-from-the-speed-after",
            "Its speed immediately after the impulse is {v m/s}.",
            "Immediately after, its path is not perpendicular to its path before, and *A* has speed {v m/s}.",
            "",
        ),
        ("deflection/equal-masses", "{e < 1}", "{e > 1}", "say that `e > 1`, and the scene declares it `unit`"),
        ("vector-impulse/size-of-the-impulse", "is a positive constant", "is a negative constant", "k is negative"),
        (
            "rest-letters/distance-from-the-centre-of-b",
            "*A* and *B* each have radius {r}",
            "*A* and *B* have radii {r} and {2*r}",
            "give `*B*` the radius `2*r`",
        ),
        (
            "direct/restitution-from-one-speed",
            "Immediately after the collision the speed of *A* is",
            "It rebounds and *A* leaves *B* with speed",
            "",
        ),
        (
            "rest-letters/turned-through-a-right-angle",
            "turned through a right angle",
            "turned through an angle of {60 deg}",
            "`*A*` is turned through 60°",
        ),
        (
            "walls/turned-through-a-right-angle",
            "through a right angle",
            "by {60 deg}",
            "the words give `60 deg`, and nothing in the scene has it",
        ),
        (
            "walls/rebound-speed-and-direction",
            "is {e}.",
            "is {1 - e}.",
            "the coefficient of restitution `1 - e` where the scene gives it",
        ),
        (
            "successive/three-in-a-line",
            "*A* and *B* is {e}, and that between *B* and *C* is {f}",
            "*A* and *B* is {f}, and that between *B* and *C* is {e}",
            "the coefficient of restitution `f` where the scene gives it",
        ),
        (
            "successive/corner",
            "the first wall is {e}, and that between *A* and the second wall is {f}",
            "the second wall is {f}, and that between *A* and the first wall is {e}",
            "",
        ),
        (
            "successive/corner",
            "the first wall is {e}, and that between *A* and the second wall is {f}",
            "the first wall is {f}, and that between *A* and the second wall is {e}",
            "the coefficient of restitution `e` where the scene gives it",
        ),
        (
            "successive/three-in-a-line",
            "Spheres *B* and *C* are at rest",
            "Sphere *B* is at rest",
            "the words do not say that `*C*` is at rest",
        ),
        ("successive/three-in-a-line", "Spheres *B* and *C* are at rest", "The others are at rest", ""),
        (
            "rest/speeds-and-directions",
            ", which is at rest on the plane",
            " on the plane",
            "the words do not say that `*B*` is at rest",
        ),
        ("ranges/mass-ratio-when-a-goes-on", "is not changed", "is reversed", "the direction of `*A*` is reversed"),
        (catches, line, "collide directly, which brings *A* to rest.", "`*A*` comes to rest, and it is not so"),
        (catches, line, "collide directly. Given that *A* is brought to rest, all is known.", "`*A*` comes to rest"),
        (catches, line, "collide directly, leaving *A* at rest.", "`*A*` comes to rest"),
        (catches, line, "collide directly. *A* is at rest immediately after this.", "`*A*` comes to rest"),
        (catches, line, "collide directly. *A* cannot be brought to rest.", ""),
        (catches, line, "collide directly. *A* is not brought to rest.", ""),
        (catches, line, "collide directly. An impulse is needed to bring *A* to rest.", ""),
        (rest, "the plane. The", "the plane and is not brought to rest. The", ""),
        (rest, "which is at rest on the plane", "which is at rest on the plane, and *A* then moves on", ""),
        (
            catches,
            line,
            "collide directly. The mass of *A* is 20 times that of *B*.",
            "`*A*` is 20 times that of `*B*`",
        ),
        (
            catches,
            line,
            "collide directly. The mass of *A* is half that of *B*.",
            "the mass of `*A*` is 1/2 times that of `*B*`",
        ),
        (catches, line, "collide directly. *A* has five times the mass of *B*.", "the mass of `*A*` is 5 times that"),
        (catches, line, "collide directly. *A* has more than five times the mass of *B*.", ""),
        (catches, line, "collide directly. *A* has {mA/mB} times the mass of *B*.", ""),
        (catches, line, "collide directly. *A* is a third as heavy as *B*.", "is 1/3 times that"),
        (
            catches,
            line,
            "collide directly. The speed of *A* is three times that of *B*.",
            "the speed of `*A*` is 3 times that",
        ),
        (catches, line, "collide directly, with equal speeds before it.", "speeds are equal"),
        (moving, "The coefficient", "Before it the spheres have equal speeds. The coefficient", "speeds are equal"),
        (moving, "The coefficient", "*B* then has the same speed as before. The coefficient", ""),
        (
            moving,
            "The coefficient",
            "The speeds of *A* and *B* are equal after it. The coefficient",
            "speeds are equal",
        ),
        (
            moving,
            "The coefficient",
            "Half of the kinetic energy is lost. The coefficient",
            "half of the kinetic energy",
        ),
        (
            moving,
            "The coefficient",
            "*A* loses {1/7} of its kinetic energy. The coefficient",
            "1/7 of the kinetic energy",
        ),
        (
            moving,
            "The coefficient",
            "{99.5}% of the total kinetic energy is lost. The coefficient",
            "99.5 of the kinetic",
        ),
        (moving, "The coefficient", "If half of the kinetic energy is lost, it is warm. The coefficient", ""),
        (
            rest,
            "Immediately before the collision the speed",
            "Sphere *A* moves perpendicular to the line of centres. The speed",
            "`*A*` moves perpendicular to the line",
        ),
        (
            rest,
            "Immediately before the collision the speed",
            "*A* moves parallel to the line of centres. The speed",
            "`*A*` moves along the line of centres",
        ),
    ];
    assert_said(&table);
}

#[test]
fn how_spheres_move_afterwards_and_what_they_have_beside_each_other_is_so() {
    let (rest, both, wall) =
        ("rest/speeds-and-directions", "both-moving/energy-lost-and-impulse", "walls/velocity-in-i-and-j");
    let (i_j, catches) = ("i-j/energy-lost", "direct/one-sphere-catches-the-other");
    let e = "The coefficient";
    let table = [
        (rest, e, "After the collision *B* moves along the line of centres. The coefficient", ""),
        (rest, e, "After the collision *A* moves along the line of centres. The coefficient", "`*A*` then moves along"),
        (
            rest,
            e,
            "Immediately after the collision *B* moves at right angles to the line of centres. The coefficient",
            "`*B*` then moves perpendicular to the line of centres",
        ),
        (i_j, e, "Immediately before the collision *A* is moving parallel to {i}. The coefficient", "moves along i"),
        (i_j, e, "After the collision *B* is not moving parallel to {i}. The coefficient", ""),
        (wall, e, "Before the impact *A* moves parallel to the wall. The coefficient", "moves along the wall"),
        (rest, e, "Immediately after the collision *B* is at rest. The coefficient", "`*B*` comes to rest"),
        (both, e, "Both spheres are brought to rest. The coefficient", "`*A*` comes to rest"),
        (catches, "collide directly.", "collide. *B* has its direction of motion reversed.", "`*B*` is reversed"),
        (catches, "collide directly.", "collide. They then move in opposite directions.", ""),
        (
            both,
            e,
            "The spheres move on opposite sides of the line of centres. The coefficient",
            "on opposite sides of the line",
        ),
        (both, e, "The spheres move on the same side of the line of centres. The coefficient", ""),
        (catches, "collide directly.", "collide. After it both spheres move in opposite directions.", "in opposite"),
        (
            catches,
            "in the same direction along the same\nstraight line",
            "along perpendicular lines",
            "move in perpendicular lines",
        ),
        (
            i_j,
            e,
            "Before the collision they move in perpendicular directions. The coefficient",
            "in perpendicular lines",
        ),
        (rest, e, "Their paths are then in perpendicular directions. The coefficient", ""),
        (
            "deflection/equal-masses",
            "{theta} with the line of centres",
            "{theta} with the common tangent",
            "give `*A*` the angle `theta`",
        ),
        (
            "vector-impulse/mass-from-the-speed-after",
            "Its speed immediately after",
            "The magnitude of its velocity immediately after",
            "",
        ),
        ("both-moving/components-given", "towards *B*, and", "towards *A*, and", "have `*A*` move towards itself"),
        (
            "vector-impulse/mass-from-the-speed-after",
            "Its speed immediately after",
            "Its velocity immediately after",
            "call `v` a velocity",
        ),
        (catches, "collide directly.", "collide. No kinetic energy is lost.", "`no energy is lost`, for which e is 1"),
        (catches, "collide directly.", "collide. Kinetic energy is not conserved.", ""),
        (rest, "have equal radii", "have different radii", "the radii are different"),
        (rest, "have equal radii", "have radii 2 cm and 3 cm", "the radii are different"),
        (rest, "have equal radii", "have equal radii of 2 cm", ""),
        (
            "rest/heavier-sphere-struck",
            e,
            "The mass of *A* is greater than that of *B*. The coefficient",
            "`*A*` is greater than that of `*B*`",
        ),
        ("rest/heavier-sphere-struck", e, "The mass of *A* is less than the mass of *B*. The coefficient", ""),
        (
            "direct/restitution-from-one-speed",
            "is {v m/s}.",
            "is {v m/s}. The coefficient of restitution is 1/2.",
            "give the coefficient of restitution, for which a part asks",
        ),
    ];
    assert_said(&table);
}

/// What is said after each edit; nothing where no words are to be said.
fn assert_said(table: &[(&str, &str, &str, &str)]) {
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
