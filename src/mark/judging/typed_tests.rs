//! Tests of whole answers as they are typed: their sense, what they call the value, and what of several things counts.

use super::tests::named;
use super::*;
use crate::mark::reading::read_answer;
use crate::number::{Letter, Range};

/// What is asked: the model, its kind, the quantity, and whether the sphere moves from B towards A.
pub(super) struct Asked(
    pub(super) &'static str,
    pub(super) Option<Kind>,
    pub(super) &'static str,
    pub(super) Option<bool>,
);

pub(super) fn earn(Asked(right, kind, quantity, rebounds): &Asked, rows: &[(&str, &str)]) {
    let letters = [
        ("m", Range::Positive),
        ("u", Range::Positive),
        ("e", Range::Unit),
        ("alpha", Range::Acute),
        ("k", Range::Positive),
    ];
    let letters = letters.map(|(name, range)| Letter::new(name, range).unwrap()).to_vec();
    let letters = letters.into_iter().filter(|letter| right.contains(letter.name()) || letter.name() == "k").collect();
    let quantity = (!quantity.is_empty()).then(|| quantity.parse().unwrap());
    let options = ModelOptions { kind: *kind, quantity, letters, ..ModelOptions::default() };
    let mut model = Model::read(right, &options).unwrap();
    model.rebounds = *rebounds;
    let mut faults = Vec::new();
    for (typed, expected) in rows {
        let found = named(&judge(&model, &read_answer(typed, &model.vocabulary)));
        if found != *expected {
            faults.push(format!("{typed} for {right}: {found}, expected {expected}"));
        }
    }
    assert!(faults.is_empty(), "\n{}", faults.join("\n"));
}

#[test]
fn a_direction_along_the_line_of_centres_has_a_sense() {
    earn(
        &Asked("0", Some(Kind::Angle), "B.after.angle_to_loc_deg", Some(false)),
        &[
            ("along BA", "wrong supplement"),
            ("BA", "wrong supplement"),
            ("along the line of centres towards A", "wrong supplement"),
            ("along the line of centres, away from B", "unreadable direction-unchecked"),
            ("along the line of centres, away from A", "correct"),
            ("along the line of centres towards B", "correct"),
            ("from A to B", "correct"),
            ("to the right along the line of centres", "correct"),
            ("to the left along the line of centres", "unreadable direction-unchecked"),
            ("along the line of centres, to the left", "unreadable direction-unchecked"),
            ("in the direction from A to B", "correct"),
            ("along AB", "correct"),
            ("LOC", "correct"),
            ("line of centres", "correct"),
            ("along line of centers", "correct"),
            ("parallel to AB", "correct"),
            ("towards B", "unreadable cannot-be-compared"),
        ],
    );
    earn(
        &Asked("0", Some(Kind::Angle), "A.after.angle_to_loc_deg", Some(true)),
        &[
            ("along BA", "correct"),
            ("along the line of centres", "correct"),
            ("along AB", "unreadable reference-unchecked"),
            ("from A to B", "wrong supplement"),
        ],
    );
    earn(
        &Asked("0", Some(Kind::Angle), "A.after.angle_to_loc_deg", None),
        &[("along AB", "correct"), ("along BA", "unreadable reference-unchecked")],
    );
}

#[test]
fn an_angle_to_a_direction_is_obtuse_where_the_sphere_moves_the_other_way() {
    earn(
        &Asked("atan(3)/deg", Some(Kind::Angle), "A.after.angle_to_loc_deg", Some(true)),
        &[
            ("71.6° to the line of centres", "correct"),
            ("71.6° to AB", "correct"),
            ("108.4° to AB", "correct"),
            ("108.4° to the direction AB", "correct"),
            ("71.6° to the direction AB", "wrong supplement"),
            ("71.6° to the line of centres, towards B", "wrong supplement"),
            ("71.6° to the line of centres, towards A", "correct"),
            ("71.6° to the line of centres, A moves towards B", "wrong supplement"),
            ("71.6° to the line of centres away from B", "correct"),
            ("71.6° to the direction in which B moves", "unreadable cannot-be-read"),
            ("71.6° to BA", "correct"),
            ("108.4° to BA", "wrong supplement"),
            ("108.4°", "wrong supplement"),
            ("9.49 m/s at 71.6° to the line of centres", "correct"),
        ],
    );
    earn(
        &Asked("atan(3)/deg", Some(Kind::Angle), "A.after.angle_to_loc_deg", Some(false)),
        &[("71.6° to AB", "correct"), ("71.6° to the direction AB", "correct"), ("108.4° to AB", "wrong supplement")],
    );
}

#[test]
fn a_velocity_and_its_components_have_a_sense() {
    earn(
        &Asked("[3*cos(10*deg), 0]", Some(Kind::Velocity), "", None),
        &[
            ("2.95 m/s along BA", "wrong direction-wrong"),
            ("2.95 m/s towards A along the line of centres", "wrong direction-wrong"),
            ("2.95 m/s in direction A to B", "correct"),
            ("2.95 m/s along AB", "correct"),
            ("2.95 m/s along the line of centres", "correct"),
            ("2.95 m/s towards B", "partial direction-unchecked"),
        ],
    );
    earn(
        &Asked("[-3, 0]", Some(Kind::Velocity), "", None),
        &[
            ("3.00 m/s along BA", "correct"),
            ("3.00 m/s from A to B", "wrong direction-wrong"),
            ("3.00 m/s along AB", "partial direction-unchecked"),
        ],
    );
    earn(
        &Asked("3", None, "A.after.n", None),
        &[
            ("3 m/s along the line of centres", "correct"),
            ("3 m/s towards B", "correct"),
            ("3 m/s away from B", "unreadable direction-unchecked"),
            ("3 m/s along BA", "wrong sign"),
            ("-3 m/s along BA", "unreadable cannot-be-compared"),
            ("3 m/s, away from B", "unreadable direction-unchecked"),
            ("3 m/s perpendicular to the line of centres", "wrong direction-wrong"),
            ("3 m/s in the opposite direction", "unreadable direction-unchecked"),
            ("3 m/s in opposite direction", "unreadable direction-unchecked"),
        ],
    );
    earn(
        &Asked("-3", None, "A.after.n", None),
        &[("3 m/s along BA", "correct"), ("-3 m/s along AB", "correct"), ("3 m/s along AB", "wrong sign")],
    );
    earn(
        &Asked("5", None, "A.after.t", None),
        &[
            ("5 perpendicular to the line of centres", "correct"),
            ("5 along the line of centres", "wrong direction-wrong"),
        ],
    );
    earn(
        &Asked("5", None, "B.after.speed", Some(false)),
        &[
            ("5 m/s along the line of centres", "correct"),
            ("5 m/s along AB", "correct"),
            ("5 m/s along BA", "partial direction-unchecked"),
        ],
    );
    earn(&Asked("27/2", None, "impulse.magnitude", None), &[("13.5 N s along BA", "correct")]);
}

#[test]
fn a_right_value_under_another_name_is_for_a_person() {
    const OTHERWISE: &str = "unreadable named-otherwise";
    earn(
        &Asked("5", None, "B.after.speed", None),
        &[
            ("v_A = 5 m/s", OTHERWISE),
            ("5 m/s for A", OTHERWISE),
            ("speed of A is 5", OTHERWISE),
            ("impulse = 5", OTHERWISE),
            ("e = 5", OTHERWISE),
            ("v_A = 4 m/s", "wrong"),
            ("v = 5", "correct"),
            ("x = 5", "correct"),
            ("w = 5", "correct"),
            ("v_2 = 5", "correct"),
            ("V_B = 5", "correct"),
            ("answer = 5", "correct"),
            ("5 m/s for B", "correct"),
            ("B's speed is 5", "correct"),
        ],
    );
    earn(
        &Asked("-3*i + j/4", None, "A.after.x", None),
        &[
            ("v_B = -3i + 0.25j", OTHERWISE),
            ("v_A = -3i + 0.25j", "correct"),
            ("-3i + 0.25j (B: 3i - 1.75j)", "correct"),
        ],
    );
    earn(
        &Asked("atan(1/2)/deg", Some(Kind::Angle), "A.after.angle_to_loc_deg", None),
        &[
            ("deflection = 26.6°", OTHERWISE),
            ("angle = 26.6°", "correct"),
            ("velocity of A is at 26.6° to the line of centres", "correct"),
            ("theta = 26.6°", "correct"),
        ],
    );
    earn(
        &Asked("3/4", None, "e", None),
        &[("I = 3/4", OTHERWISE), ("e = 3/4", "correct"), ("speed of separation/speed of approach = 3/4", "correct")],
    );
    earn(
        &Asked("729/16", None, "ke.lost", None),
        &[
            ("impulse = 45.6", OTHERWISE),
            ("KE increases by 45.6 J", "partial sign"),
            ("gain of 45.6 J", "partial sign"),
            ("gain of -45.6 J", "correct change-not-loss"),
            ("KE decreases by 45.6 J", "correct"),
            ("loss of 45.6 J", "correct"),
        ],
    );
    earn(
        &Asked("63", None, "A.ke_gained", None),
        &[
            ("63 J", "correct"),
            ("gain of 63 J", "correct"),
            ("KE increases by 63 J", "correct"),
            ("change in KE = 63", "correct"),
            ("ΔKE = 63 J", "correct"),
            ("KE2 - KE1 = 63", "correct"),
            ("KE1 - KE2 = 63", "partial sign"),
            ("KE decreases by 63 J", "partial sign"),
            ("loss of 63 J", "partial sign"),
            ("-63 J", "partial sign"),
            ("ΔKE = -63 J", "partial sign"),
            ("81 J before, 18 J after, 63 J gained", "correct"),
            ("KE2 = 63", OTHERWISE),
        ],
    );
}
