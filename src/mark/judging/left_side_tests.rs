//! Tables of what stands left of an equals sign.

use super::tests::named;
use super::typed_tests::{Asked, earn};
use super::{Model, ModelOptions, judge};
use crate::answer::Kind;
use crate::expr::{Angles, Expr, read};
use crate::mark::reading::read_answer;

const OTHERWISE: &str = "unreadable named-otherwise";

#[test]
fn an_equation_for_a_speed_must_be_true_of_it() {
    earn(
        &Asked("4*sqrt(5)", None, "A.after.speed", None),
        &[
            ("v² = 8.94", "wrong"),
            ("v² = 80", "partial square-not-rooted"),
            ("v² = 80 = 8.94", "correct"),
            ("v² = 8.94 = 8.94", "wrong"),
            ("2v = 8.94", "wrong"),
            ("2v = 17.9", "partial not-solved"),
            ("17.9 = 2v", "partial not-solved"),
            ("8.94 = 2v", "wrong"),
            ("8.94 = v", "correct"),
            ("speed² = 80", "partial square-not-rooted"),
            ("speed squared = 80", "partial square-not-rooted"),
            ("speed^2 = 8.94", "wrong"),
            ("KE² = 80", "wrong"),
            ("v/2 = 4.47", "partial not-solved"),
            ("1/v = 8.94", "wrong"),
            ("√v = 8.94", "wrong"),
            ("√v = 2.99", "partial not-solved"),
            ("v - 1 = 8.94", "wrong"),
            ("v - 1 = 7.94", "partial not-solved"),
            // The sum swallows the figures.
            ("v + 1000 = 1009", "wrong too-few-figures"),
            ("-v = 8.94", "partial sign"),
            ("v2 = 8.94", "correct"),
            ("v1 = 8.94", "correct"),
            ("|v| = 8.94", "correct"),
            ("V = 8.94", "correct"),
            ("√(x² + y²) = 8.94", "correct"),
            ("v + w = 8.94", OTHERWISE),
            ("v_A/v_B = 8.94", OTHERWISE),
            ("m v = 8.94", OTHERWISE),
            ("mv = 8.94", OTHERWISE),
            ("v + w = 5", "wrong"),
            ("v - v = 0", "unreadable cannot-be-compared"),
            ("v/v = 1", "unreadable cannot-be-compared"),
            ("2v - 2v + 1 = 1", "unreadable cannot-be-compared"),
        ],
    );
}

#[test]
fn a_letter_is_the_name_of_what_the_subject_calls_by_it() {
    earn(
        &Asked("4*sqrt(5)", None, "A.after.speed", None),
        &[("θ = 8.94", OTHERWISE), ("m = 8.94", OTHERWISE), ("E = 8.94", OTHERWISE), ("s = 8.94", "correct")],
    );
    earn(
        &Asked("11/14", None, "e", None),
        &[
            ("v = 11/14", OTHERWISE),
            ("E = 11/14", "correct"),
            ("k = 11/14", "correct"),
            ("(w - v)/u = 11/14", "correct"),
        ],
    );
    earn(
        &Asked("5*m/2", None, "B.mass", None),
        &[
            ("m = 5m/2", OTHERWISE),
            ("m_B = 5m/2", "correct"),
            ("2m_B = 5m", "partial not-solved"),
            ("m_B/m = 5/2 so 5m/2", "correct"),
            ("M = 5m/2", "correct"),
        ],
    );
    earn(
        &Asked("24/5", None, "impulse.magnitude", None),
        &[
            ("v = 4.8", OTHERWISE),
            ("mI = 4.8", OTHERWISE),
            ("mv - mu = 4.8", "correct"),
            ("2I = 9.6", "partial not-solved"),
        ],
    );
    earn(
        &Asked("4*i - 29/20*j", Some(Kind::Vector), "A.after.x", None),
        &[
            ("2v = 4i - 1.45j", "wrong"),
            ("2v = 8i - 2.9j", "partial not-solved"),
            ("v_A - u_A = 4i - 1.45j", OTHERWISE),
            ("I = 4i - 1.45j", OTHERWISE),
        ],
    );
}

#[test]
fn an_equation_for_the_coefficient_of_restitution_is_solved() {
    earn(
        &Asked("11/14", None, "e", None),
        &[
            ("e² = 11/14", "wrong"),
            ("e² = 121/196", "partial square-not-rooted"),
            ("1/e = 14/11", "partial not-solved"),
            ("1/e = 11/14", "wrong inverted"),
            ("14e = 11", "partial not-solved"),
            ("2(1 - e) = 3/7", "partial not-solved"),
            ("1 - e = 11/14", "wrong"),
            ("1 - e = 3/14", "partial not-solved"),
            ("1 - e = 0.21", "partial under-accurate"),
        ],
    );
}

#[test]
fn an_equation_for_an_angle_or_its_tangent_is_true_of_it() {
    earn(
        &Asked("atan(2)/deg", Some(Kind::Angle), "A.after.angle_to_loc_deg", None),
        &[
            ("2θ = 63.4", "wrong"),
            ("2θ = 126.9", "partial not-solved"),
            ("90 - θ = 63.4", "wrong complement"),
            ("90 - θ = 26.6", "partial not-solved"),
            ("90° - θ = 26.6°", "partial not-solved"),
            ("θ - α = 63.4", OTHERWISE),
            ("v = 63.4", OTHERWISE),
            ("bearing 063.4", OTHERWISE),
            ("turned through 63.4°", OTHERWISE),
            ("angle of deflection = 63.4°", OTHERWISE),
            ("α = 63.4", "correct"),
            ("tan θ = 2", "partial angle-not-evaluated"),
            ("cot θ = 1/2", "partial angle-not-evaluated"),
            ("tan 2θ = 2", "wrong"),
            ("sin²θ = 4/5", "partial not-solved"),
        ],
    );
    earn(
        &Asked("12/71", None, "A.tan_deflection", None),
        &[
            ("tan θ = 12/71", "correct"),
            ("tan(β - α) = 12/71", "correct"),
            ("θ = 12/71", OTHERWISE),
            ("sin θ = 12/71", "wrong"),
            ("tan²θ = 12/71", "wrong"),
            ("tan 2θ = 12/71", "wrong"),
            ("tan(θ/2) = 12/71", "wrong"),
            ("cot θ = 71/12", "partial not-solved"),
            ("2tan θ = 24/71", "partial not-solved"),
        ],
    );
    earn(
        &Asked("e*tan(alpha)", None, "A.after.tan_to_wall", None),
        &[
            ("tan γ = e tan α", "correct"),
            ("tan α = e tan α", OTHERWISE),
            ("β = arctan(e tan α)", "partial angle-for-tangent"),
        ],
    );
    earn(&Asked("8", None, "", None), &[("k = 8", "correct"), ("2k = 16", "partial not-solved"), ("k/2 = 8", "wrong")]);
}

#[test]
fn words_name_what_is_lost_or_what_there_is() {
    earn(
        &Asked("30", None, "ke.lost", None),
        &[
            ("KE after = 30", OTHERWISE),
            ("KE before = 30", OTHERWISE),
            ("final KE = 30 J", OTHERWISE),
            ("½KE = 30", OTHERWISE),
            ("-KE lost = 30", OTHERWISE),
            ("2E = 30", "wrong"),
            ("KE before - KE after = 30", "correct"),
            ("E_1 - E_2 = 30", "correct"),
            ("KE lost = 30", "correct"),
            ("ΔKE = 30", "correct"),
            ("energy = 30", "correct"),
            ("30 J gained", "partial sign"),
            ("30 J is left", OTHERWISE),
        ],
    );
    earn(
        &Asked("4/9", None, "ke.fraction_lost", None),
        &[
            ("fraction left = 4/9", OTHERWISE),
            ("KE after/KE before = 4/9", OTHERWISE),
            ("1 - x = 4/9", "wrong"),
            ("KE lost/KE before = 4/9", "correct"),
            ("fraction of initial KE = 4/9", "correct"),
        ],
    );
    earn(
        &Asked("4*sqrt(5)", None, "A.after.speed", None),
        &[
            ("speed of A before = 8.94", OTHERWISE),
            ("8.94 before the collision", OTHERWISE),
            ("8.94, the same as before", "correct"),
            ("final speed of A = 8.94", "correct"),
            ("component of the velocity of A = 8.94", OTHERWISE),
            ("A: 4√5 = 8.94", "correct"),
        ],
    );
}

#[test]
fn words_that_turn_a_component_are_for_a_person() {
    const UNCHECKED: &str = "unreadable direction-unchecked";
    earn(
        &Asked("241/100", None, "A.after.n", Some(false)),
        &[
            ("2.41 left", UNCHECKED),
            ("2.41 leftwards", UNCHECKED),
            ("A reverses at 2.41", UNCHECKED),
            ("A rebounds with 2.41", UNCHECKED),
            ("2.41 perpendicular", UNCHECKED),
            ("2.41 right", "correct"),
        ],
    );
    earn(
        &Asked("4*i - 29/20*j", Some(Kind::Vector), "A.after.x", None),
        &[("4.25 m/s at 19.9° below i", UNCHECKED), ("5 m/s at 19.9° below i", "wrong")],
    );
    earn(
        &Asked("i - j", Some(Kind::Line), "", None),
        &[("at 45° below i", "unreadable cannot-be-compared"), ("at 30° below i", "wrong")],
    );
}

#[test]
fn what_is_known_of_the_impact_is_held_against_the_words() {
    let asked = |right: &str, quantity: &str| {
        Model::read(right, &ModelOptions { quantity: quantity.parse().ok(), ..ModelOptions::default() }).unwrap()
    };
    let earns = |model: &Model, typed: &str| named(&judge(model, &read_answer(typed, &model.vocabulary)));
    let of_both = asked("30", "ke.lost");
    for (typed, expected) in
        [("KE lost by A = 30", OTHERWISE), ("KE lost by A and B = 30", "correct"), ("30", "correct")]
    {
        assert_eq!(earns(&of_both, typed), expected, "{typed}");
    }
    for (typed, expected) in
        [("30 J lost by B", OTHERWISE), ("30 J (by A)", OTHERWISE), ("30 J lost by A and B", "correct")]
    {
        assert_eq!(earns(&of_both, typed), expected, "{typed}");
    }
    let at_a_wall = Model { is_of_both: false, ..asked("30", "ke.lost") };
    assert_eq!(earns(&at_a_wall, "KE lost by A = 30"), "correct");
    const UNCHECKED: &str = "partial direction-unchecked";
    let along = Model { path: Some(Expr::integer(0)), ..asked("5", "B.after.speed") };
    let slanting = Model { path: read("atan(2)", Angles::Radians).ok(), ..asked("5", "B.after.speed") };
    for (typed, of_along, of_slanting) in [
        ("5 along the line of centres", "correct", UNCHECKED),
        ("5 perpendicular to the line of centres", UNCHECKED, UNCHECKED),
        ("5 at 63.4° to the line of centres", UNCHECKED, "correct"),
        ("5 at 26.6° to the common tangent", UNCHECKED, "correct"),
        ("5 at 60° to the line of centres", UNCHECKED, UNCHECKED),
        ("5 m/s", "correct", "correct"),
    ] {
        assert_eq!(earns(&along, typed), of_along, "{typed}");
        assert_eq!(earns(&slanting, typed), of_slanting, "{typed}");
    }
}

#[test]
fn a_label_names_the_line_from_which_an_angle_is_measured() {
    const REFERENCE: &str = "wrong reference-wrong";
    earn(
        &Asked("atan(7)", None, "A.after.angle_to_loc_deg", None),
        &[
            ("angle with tangent = 81.9°", REFERENCE),
            ("angle to tangent: 81.9", REFERENCE),
            ("angle from common tangent = 81.9", REFERENCE),
            ("angle with the common tangent at impact = 81.9°", REFERENCE),
            ("θ to tangent = 81.9", REFERENCE),
            ("to the tangent: 81.9°", REFERENCE),
            ("tangent: 81.9°", REFERENCE),
            ("angle between velocity and tangent = 81.9°", REFERENCE),
            ("81.9° between path and tangent", REFERENCE),
            ("the tangent makes 81.9° with A's path", REFERENCE),
            ("angle with the perpendicular to the line of centres = 81.9", REFERENCE),
            ("angle with the wall: 81.9", REFERENCE),
            ("angle with tangent = 8.13°", "correct"),
            ("angle from the tangent is 8.13°", "correct"),
            ("angle between the tangent and v = 8.13°", "correct"),
            ("8.13° between path and tangent", "correct"),
            ("angle to loc: 81.9, angle to tangent: 8.13", "correct"),
            ("angle to tangent: 8.13, angle to loc: 81.9", "correct"),
            ("makes an angle with the line of centres of 81.9°", "correct"),
            ("angle with AB = 81.9°", "correct"),
            ("angle with the line of centres AB = 81.9°", "correct"),
            ("angle between tangent and line of centres = 81.9°", "unreadable reference-unchecked"),
            ("angle with j = 81.9", "unreadable reference-unchecked"),
            // The tangent of an angle is no line.
            ("tan θ = 7", "partial angle-not-evaluated"),
            ("tan θ = 7, θ = 81.9", "correct"),
            ("tangent of the angle = 7, angle = 81.9", "correct"),
        ],
    );
}

#[test]
fn a_right_value_by_the_name_of_another_is_for_a_person() {
    earn(
        &Asked("25/9", None, "A.after.speed", None),
        &[
            ("2.78 (B)", OTHERWISE),
            ("2.78 (speed of B)", OTHERWISE),
            ("2.78 m/s (sphere B)", OTHERWISE),
            ("2.78, B", OTHERWISE),
            ("2.78 (A)", "correct"),
            ("initial speed 2.78", OTHERWISE),
            ("relative speed 2.78", OTHERWISE),
            ("average speed 2.78", OTHERWISE),
            ("final speed 2.78", "correct"),
            ("speed of separation = 2.78", OTHERWISE),
            ("speed of approach = 2.78", OTHERWISE),
            ("change in speed = 2.78", OTHERWISE),
            ("speed lost = 2.78", OTHERWISE),
            ("speed difference 2.78", OTHERWISE),
            ("Δv = 2.78", OTHERWISE),
            ("horizontal speed = 2.78", OTHERWISE),
            ("perpendicular speed 2.78", OTHERWISE),
            ("acceleration = 2.78", OTHERWISE),
            ("distance 2.78", OTHERWISE),
            ("v_x = 2.78", OTHERWISE),
            ("v_y=2.78", OTHERWISE),
            ("velocity along loc = 2.78", OTHERWISE),
            ("the component along the line of centres is 2.78", OTHERWISE),
            ("2.78 (component along LOC)", OTHERWISE),
            ("2.78 (momentum)", OTHERWISE),
            ("2.78 (speed)", "correct"),
        ],
    );
    earn(&Asked("5", None, "B.after.speed", None), &[("5 (A)", OTHERWISE), ("5 m/s (sphere A)", OTHERWISE)]);
    earn(
        &Asked("9", None, "impulse.magnitude", None),
        &[
            ("momentum before = 9", OTHERWISE),
            ("momentum of A after = 9", OTHERWISE),
            ("final momentum = 9", OTHERWISE),
            ("total momentum = 9", OTHERWISE),
            ("force is 9", OTHERWISE),
            ("change in momentum = 9", "correct"),
            ("momentum after - momentum before = 9", "correct"),
            ("impulse = 9", "correct"),
        ],
    );
    earn(
        &Asked("48/25", None, "ke.lost", None),
        &[
            ("PE lost = 1.92", OTHERWISE),
            ("1.92 J each", OTHERWISE),
            ("work done 1.92", OTHERWISE),
            ("percentage lost 1.92", OTHERWISE),
            ("KE lost + KE left = 1.92", OTHERWISE),
            ("loss of KE = 1.92", "correct"),
        ],
    );
    earn(
        &Asked("4*i + j", None, "A.after.x", None),
        &[
            ("change in velocity 4i + j", OTHERWISE),
            ("relative velocity = 4i + j", OTHERWISE),
            ("final velocity = 4i + j", "correct"),
        ],
    );
    earn(
        &Asked("30", None, "A.after.angle_to_loc_deg", None),
        &[
            ("angle of incidence = 30°", OTHERWISE),
            ("30° with B's path", OTHERWISE),
            ("30° with the line of centres", "correct"),
        ],
    );
    const ORDER: &str = "unreadable ratio-unchecked";
    earn(
        &Asked("2/3", Some(Kind::Ratio), "", None),
        &[("2:3 (B to A)", ORDER), ("2:3 (B first)", ORDER), ("2:3 (A to B)", "correct"), ("2:3", "correct")],
    );
}

#[test]
fn a_number_of_degrees_is_an_angle_where_one_is_asked() {
    earn(
        &Asked("30", None, "A.after.angle_to_loc_deg", None),
        &[
            ("30° to the tangent", "wrong reference-wrong"),
            ("60° to the tangent", "correct"),
            ("π/6", "correct"),
            ("arctan(1/√3)", "correct"),
            ("30", "correct"),
        ],
    );
}
