//! Tests of answers that are judged by what is known of the question: which way a sphere goes, who takes part in an impact,
//! which letter is to be found.

use super::known::Prepared;
use super::*;
use crate::expr::{Angles, Expr, read};
use crate::mark::reading::{Vocabulary, read_answer};
use crate::mechanics::Sphere;
use crate::number::{Letter, Range};

/// The verdicts on what is typed, of a model of which more is known.
fn earn(model: &Model, rows: &[(&str, &str)]) {
    let found = |typed: &str| judge(model, &read_answer(typed, &model.vocabulary)).verdict.name();
    let faults: Vec<String> = rows
        .iter()
        .filter(|(typed, expected)| found(typed) != *expected)
        .map(|(typed, expected)| format!("{typed}: {}, expected {expected}", found(typed)))
        .collect();
    assert!(faults.is_empty(), "\n{}", faults.join("\n"));
}

fn model(right: &str, quantity: &str, letters: &[(&str, Range)]) -> Model {
    let letters = letters.iter().map(|(name, range)| Letter::new(name, *range).unwrap()).collect();
    let quantity = (!quantity.is_empty()).then(|| quantity.parse().unwrap());
    Model::read(right, &ModelOptions { letters, quantity, ..ModelOptions::default() }).unwrap()
}

#[test]
fn a_sphere_that_is_said_to_go_another_way_is_for_a_person() {
    let speed = Model { turns_back: Some(true), rebounds: Some(true), ..model("10", "A.after.speed", &[]) };
    earn(
        &speed,
        &[
            ("10 m/s", "correct"),
            ("A rebounds at 10 m/s", "correct"),
            ("10 m/s in the opposite direction", "correct"),
            ("10 m/s away from the wall", "correct"),
            ("10 m/s in the same direction", "unreadable"),
            ("10 m/s in its original direction", "unreadable"),
            ("10 m/s in the direction it was moving", "unreadable"),
            ("10 m/s due west", "unreadable"),
            ("A continues at 10 m/s", "unreadable"),
            ("10 m/s towards the wall", "unreadable"),
            ("9 m/s towards the wall", "wrong"),
        ],
    );
    let goes_on = Model { turns_back: Some(false), ..speed };
    earn(
        &goes_on,
        &[
            ("A continues at 10 m/s", "correct"),
            ("A rebounds at 10 m/s", "unreadable"),
            ("A changes direction, 10 m/s", "unreadable"),
            ("10 m/s in its original direction", "correct"),
            ("10 m/s in B's original direction", "correct"),
        ],
    );
    let along_with_b = Model { same_way: Some(true), ..goes_on };
    earn(
        &along_with_b,
        &[("10 m/s in the same direction as B", "correct"), ("10 m/s in the opposite direction to B", "unreadable")],
    );
    let to_line = Model { turns_back: Some(true), ..model("atan(5/3)", "A.after.angle_to_loc_deg", &[]) };
    earn(
        &to_line,
        &[
            ("59.0° to the line of centres, A rebounds", "correct"),
            ("59.0° to the line of centres, A continues forwards", "unreadable"),
            ("59.0° to LOC in its original direction", "unreadable"),
        ],
    );
    let range = Model { turns_back: Some(true), ..model("1/3 < e <= 1", "", &[("e", Range::Unit)]) };
    let range = Model { letter: Some("e".to_owned()), ..range };
    earn(
        &range,
        &[
            ("A rebounds if e > 1/3", "correct"),
            ("A continues if e > 1/3", "unreadable"),
            ("e > 1/3 for A to reverse", "correct"),
            ("A hits B and rebounds, 1/3 < e ≤ 1", "correct"),
            ("e > 1/3 so A keeps going", "unreadable"),
            ("e > 1/3 so A moves away from B", "correct"),
            ("e > 1/3 so A moves towards B", "unreadable"),
            ("v < 0 if e > 1/3", "correct"),
            ("e > 1/3 so v < 0", "correct"),
            ("e > 1/3 so v > 0", "unreadable"),
            ("v < 0, so e > 1/3", "correct"),
            ("v = 4(1 - 3e) < 0, so e > 1/3", "correct"),
            ("angle > 90 so e > 1/3", "correct"),
            ("turned through more than 90° if e > 1/3", "correct"),
            ("turned through less than 90° if e > 1/3", "wrong"),
            ("v < 0", "wrong"),
            ("3e > 2, so e > 1/3", "wrong"),
        ],
    );
}

#[test]
fn an_impulse_is_not_on_a_sphere_that_takes_no_part() {
    let on_the_wall = Model { strangers: vec![Sphere::A, Sphere::C], ..model("42", "second.impulse.magnitude", &[]) };
    earn(
        &on_the_wall,
        &[
            ("impulse on B = 42", "correct"),
            ("42 Ns on B", "correct"),
            ("impulse on A = 42", "unreadable"),
            ("42 on A", "unreadable"),
            ("I_A = 42", "unreadable"),
        ],
    );
}

#[test]
fn an_impulse_on_one_body_has_a_sense() {
    let on_b = Model { pushes_back: Some(false), ..model("3.38", "impulse.magnitude", &[]) };
    earn(
        &on_b,
        &[
            ("3.38 N s", "correct"),
            ("3.38 N s from A to B", "correct"),
            ("3.38 N s towards B", "correct"),
            ("3.38 N s towards A", "partial"),
            ("3.38 in the direction BA", "partial"),
            ("3.38 to the right", "correct"),
            ("3.38 to the left", "unreadable"),
            ("3.38 N s towards A on A", "correct"),
            ("2.38 N s towards A", "wrong"),
        ],
    );
    let of_wall = Model { pushes_back: Some(true), ..model("5.2", "impulse.magnitude", &[]) };
    earn(
        &of_wall,
        &[
            ("5.2 N s away from the wall", "correct"),
            ("5.2 N s towards the wall", "unreadable"),
            ("5.2 N s into the wall", "unreadable"),
            ("5.2 N s perpendicular to the wall", "correct"),
        ],
    );
    let downwards = Some([Expr::integer(0), read("-26/5", Angles::Radians).unwrap()]);
    let vocabulary = Vocabulary { vectors: true, ..of_wall.vocabulary.clone() };
    let in_i_and_j = Model { vector: downwards, vocabulary, ..of_wall };
    earn(
        &in_i_and_j,
        &[
            ("5.2 N s in the direction -j", "correct"),
            ("5.2 N s in the -j direction", "correct"),
            ("5.2 N s, direction of -j", "correct"),
            ("5.2 N s in the +j direction", "partial"),
            ("5.2 N s in the direction of i", "partial"),
        ],
    );
    let unsaid = Model { pushes_back: None, ..on_b };
    earn(&unsaid, &[("3.38 N s towards A", "correct"), ("3.38 N s towards B", "correct")]);
}

#[test]
fn an_aside_tells_of_something_else() {
    let of_a = model("5", "A.after.speed", &[]);
    earn(
        &of_a,
        &[
            ("5 (w = 15)", "correct"),
            ("v_A = 5 (v_B = 15)", "correct"),
            ("5 (e = 2/3)", "correct"),
            ("5 (v = 15)", "unreadable"),
            ("5 (v_A = 15)", "unreadable"),
            ("15 (v = 5)", "wrong"),
            ("v = 5, w = 15", "correct"),
            ("v = 15, w = 5", "partial"),
        ],
    );
    earn(&model("15", "B.after.speed", &[]), &[("5 (w = 15)", "wrong"), ("w = 15 (v = 5)", "correct")]);
    let of_angle = model("75.9*deg", "A.deflection_deg", &[]);
    earn(&of_angle, &[("75.9° (δ = 70)", "unreadable")]);
    let later = Model { strangers: vec![Sphere::A], ..model("4", "second.B.after.speed", &[]) };
    earn(&later, &[("v = 4, w = 10", "partial"), ("w = 4, v = 10", "partial")]);
}

#[test]
fn a_name_is_of_one_sphere_at_one_moment() {
    let of_a = model("2.78", "A.after.speed", &[]);
    earn(
        &of_a,
        &[
            ("v_A = 2.78", "correct"),
            ("u_A = 2.78", "unreadable"),
            ("u_1 = 2.78", "unreadable"),
            ("v_0 = 2.78", "unreadable"),
            ("v_i = 2.78", "unreadable"),
            ("u = 2.78", "correct"),
            ("v_n = 2.78", "unreadable"),
            ("speed of the second sphere = 2.78", "unreadable"),
            ("speed of the other sphere = 2.78", "unreadable"),
        ],
    );
    earn(&model("2.78", "A.before.speed", &[]), &[("u_A = 2.78", "correct")]);
}

#[test]
fn an_angle_is_to_the_line_that_is_named() {
    earn(
        &model("46.1*deg", "A.after.angle_to_loc_deg", &[]),
        &[
            ("46.1°", "correct"),
            ("46.1^0", "correct"),
            ("angle 46.1°", "correct"),
            ("46.1° to AB", "correct"),
            ("46.1° tangent", "unreadable"),
            ("46.1° to B", "unreadable"),
            ("46.1° to it", "unreadable"),
            ("perpendicular: 46.1°", "unreadable"),
            ("change of direction 46.1°", "unreadable"),
        ],
    );
}

#[test]
fn the_third_figure_is_that_of_the_unit_that_is_used() {
    // 2.7755… m/s is 9.99 km/h.
    earn(&model("4*sqrt(39)/9", "A.after.speed", &[]), &[("10.0 km/h", "correct"), ("9.99 km/h", "correct")]);
    earn(
        &model("1234567/100", "ke.lost", &[]),
        &[("12.3 kJ", "correct"), ("12300 J", "correct"), ("12.35 kJ", "correct")],
    );
}

#[test]
fn at_rest_is_at_rest_and_no_less() {
    let at_rest = model("0", "B.after.speed", &[]);
    earn(
        &at_rest,
        &[
            ("at rest", "correct"),
            ("B is at rest", "correct"),
            ("B comes to rest", "correct"),
            ("comes to a stop", "correct"),
            ("B is now at rest", "correct"),
            ("0 (at rest)", "correct"),
            ("nearly at rest", "unreadable"),
            ("almost at rest", "unreadable"),
            ("hardly at rest", "unreadable"),
            ("momentarily at rest", "unreadable"),
            ("B was initially at rest", "unreadable"),
            ("before the collision B is at rest", "unreadable"),
            ("at rest along the line of centres", "unreadable"),
        ],
    );
}

#[test]
fn a_letter_that_is_asked_has_its_own_name_and_unit() {
    let of_k = Model { letter: Some("k".to_owned()), ..model("8", "", &[("k", Range::Positive)]) };
    earn(
        &of_k,
        &[
            ("k = 8", "correct"),
            ("k = 8, m = 2", "correct"),
            ("x = 8", "correct"),
            ("m = 8", "unreadable"),
            ("speed = 8", "unreadable"),
            ("e = 8", "unreadable"),
            ("A = 8", "unreadable"),
        ],
    );
    let of_m = Model { letter: Some("m".to_owned()), ..model("2", "", &[("m", Range::Positive)]) };
    earn(&of_m, &[("2 kg", "correct"), ("m = 2", "correct"), ("2 N", "partial"), ("2 m/s", "partial")]);
    let alpha = Model { letter: Some("alpha".to_owned()), ..model("37.1*deg", "", &[("alpha", Range::Acute)]) };
    earn(
        &alpha,
        &[
            ("α = 37.1°, greatest deflection = 15.8°", "correct"),
            ("α = 37.1° and δ = 15.8°", "correct"),
            ("37.1° (deflection 15.8°)", "correct"),
            ("α = 15.8°, greatest deflection = 37.1°", "wrong"),
        ],
    );
}

#[test]
fn the_event_that_is_named_beside_a_range_is_the_one_that_is_asked_of() {
    let e = [("e", Range::Unit)];
    let range = |right: &str| Model { letter: Some("e".to_owned()), ..model(right, "", &e) };
    let back = Model { turns_back: Some(true), strangers: vec![Sphere::B, Sphere::C], ..range("1/3 < e <= 1") };
    earn(
        &back,
        &[
            ("A rebounds if e > 1/3", "correct"),
            ("B rebounds if e > 1/3", "unreadable"),
            ("B is reversed if e > 1/3", "unreadable"),
            ("after the collision A is reversed for e > 1/3", "correct"),
        ],
    );
    let apart = Model { meet_again: Some(false), ..range("0 <= e <= 5/9") };
    earn(
        &apart,
        &[
            ("no collision if e ≤ 5/9", "correct"),
            ("no further collisions when e <= 5/9", "correct"),
            ("A and B never collide again for 0 <= e <= 5/9", "correct"),
            ("they do not collide again if e ≤ 5/9", "correct"),
            ("A does not hit B again when e ≤ 5/9", "correct"),
            ("no second collision: e ≤ 5/9", "correct"),
            ("collision for e ≤ 5/9", "unreadable"),
            ("e ≤ 5/9 for another collision", "unreadable"),
            ("e ≤ 5/9 if A strikes B", "unreadable"),
            ("when B hits C, e ≤ 5/9", "correct"),
            ("A rebounds if e ≤ 5/9", "unreadable"),
        ],
    );
    let again = Model { meet_again: Some(true), ..range("1/2 < e <= 1") };
    earn(
        &again,
        &[
            ("second collision if e > 1/2", "correct"),
            ("B catches A if e > 1/2", "correct"),
            ("e > 1/2 to collide again", "correct"),
            ("e > 1/2 for no more collisions", "unreadable"),
            ("no second collision e > 1/2", "unreadable"),
            ("no collision for e > 1/2", "unreadable"),
            ("no collision if e ≤ 1/2", "unreadable"),
        ],
    );
}

#[test]
fn a_side_that_is_named_is_the_one_to_which_it_goes() {
    let speed = Model { turns_back: Some(false), rebounds: Some(false), ..model("10", "B.after.speed", &[]) };
    earn(
        &speed,
        &[
            ("10 m/s to the right", "correct"),
            ("10 m/s, no collision", "unreadable"),
            ("10 m/s before the second collision", "unreadable"),
            ("10 m/s to the left", "unreadable"),
            ("A moves to the left at 10 m/s", "unreadable"),
        ],
    );
    let above = Model { anticlockwise: Some(true), ..model("atan(3/4)", "impulse.angle_to_i_deg", &[]) };
    earn(
        &above,
        &[
            ("36.9° above i", "correct"),
            ("36.9° anticlockwise from i", "correct"),
            ("36.9° below i", "unreadable"),
            ("36.9° clockwise", "unreadable"),
        ],
    );
    let turned = Model { anticlockwise: Some(false), ..model("8.13*deg", "A.deflection_deg", &[]) };
    earn(
        &turned,
        &[("8.13° clockwise", "correct"), ("8.13° anti-clockwise", "unreadable"), ("8.13° to the left", "unreadable")],
    );
    let to_wall = model("atan(1/3)", "A.after.angle_to_wall_deg", &[]);
    earn(
        &to_wall,
        &[
            ("18.4° away from the wall", "correct"),
            ("18.4° to the wall", "correct"),
            ("18.4° into the wall", "unreadable"),
        ],
    );
}

#[test]
fn a_direction_beside_the_size_of_a_vector_is_that_of_the_vector() {
    let vector = |x: i64, y: i64| Some([Expr::integer(x), Expr::integer(y)]);
    let size = Model { vector: vector(16, 12), ..model("20", "impulse.magnitude", &[]) };
    let size = Model { vocabulary: Vocabulary { vectors: true, ..size.vocabulary.clone() }, ..size };
    earn(
        &size,
        &[
            ("20 Ns at 36.9° to i", "correct"),
            ("20 Ns at 143° to i", "correct"),
            ("20 Ns at 53.1° to j", "correct"),
            ("20 Ns at 53.1° to i", "partial"),
        ],
    );
    let speed = Model { vector: vector(6, 9), quantity: "A.after.speed".parse().ok(), ..size };
    let speed = Model { value: read("3*sqrt(13)", Angles::Radians).unwrap(), prepared: Prepared::default(), ..speed };
    earn(
        &speed,
        &[
            ("3√13 at 56.3° to i", "correct"),
            ("3√13 at 33.7° to i", "partial"),
            ("3√13 at 56.3° above i", "correct"),
            ("3√13 at 56.3° below i", "partial"),
            ("3√13 downwards", "unreadable"),
        ],
    );
}

#[test]
fn an_energy_has_no_direction_and_a_small_j_is_joules() {
    let vocabulary = Vocabulary { vectors: true, ..model("45", "", &[]).vocabulary };
    let energy = Model { vocabulary: vocabulary.clone(), ..model("45", "ke.lost", &[]) };
    earn(&energy, &[("45j", "correct"), ("45 j", "correct"), ("45J", "correct"), ("44j", "wrong"), ("45i", "partial")]);
    let impulse = Model { vocabulary, ..model("45", "impulse.magnitude", &[]) };
    earn(&impulse, &[("45j", "partial")]);
}

#[test]
fn a_vector_is_no_number_but_perhaps_its_size() {
    let velocity = model("4*i - 3*j", "", &[]);
    earn(
        &velocity,
        &[
            ("4i - 3j", "correct"),
            ("4i - 3j = 5", "correct"),
            ("4i - 3j = 1", "unreadable"),
            ("4i - 3j = 1 m/s", "unreadable"),
        ],
    );
}
