//! Tests of answers that say several things: which of them counts, and which are rivals.

use super::typed_tests::{Asked, earn};
use super::*;
use crate::mark::reading::read_answer;
use crate::number::{Letter, Range};

#[test]
fn values_that_differ_by_a_figure_are_rivals_and_a_rounder_one_is_not() {
    const RIVALS: &str = "wrong rival-answers";
    earn(
        &Asked("4*sqrt(39)/9", None, "A.after.speed", None),
        &[
            ("2.78 or 2.77", RIVALS),
            ("2.77, 2.78", RIVALS),
            ("2.79 or 2.78", RIVALS),
            ("2.78 or 2.8", "correct"),
            ("2.776, 2.78", "correct"),
            ("2.77 or 2.78 so 2.78", "correct"),
            ("2.7756 = 2.79", RIVALS),
            ("2.7756 ≈ 2.77", "correct"),
            ("2.7756 or 2.77", RIVALS),
            ("2.7656 ≈ 2.78", RIVALS),
        ],
    );
}

#[test]
fn a_value_that_is_rounded_the_wrong_way_is_no_rival() {
    const RIVALS: &str = "wrong rival-answers";
    earn(
        &Asked("3764317/1000000", None, "A.after.speed", None),
        &[
            ("3.7643 ≈ 3.76", "correct"),
            ("3.7643 ≈ 3.77", "correct ignored-after"),
            ("3.7643 = 3.77 m/s", "correct ignored-after"),
            ("3.7643 = 3.78", RIVALS),
            ("3.77 = 3.7643", RIVALS),
            ("3.7643 or 3.77", RIVALS),
            ("3.6643 ≈ 3.67", "wrong"),
        ],
    );
}

#[test]
fn what_was_rounded_before_it_was_put_in_is_not_cut_off_at_the_end() {
    const RIVALS: &str = "wrong rival-answers";
    earn(
        &Asked("10/tan(69*deg)", None, "A.after.speed", None),
        &[
            ("3.83", "partial truncated"),
            ("10√0.147 = 3.83", "partial early-rounding"),
            ("10√0.147 = 3.84", "correct"),
            ("3.8386 = 3.83", "correct"),
            ("3.8386 = 3.85", RIVALS),
            ("3.8386 ≈ 3.831", RIVALS),
            ("10√e = 3.84", "unreadable cannot-be-compared"),
        ],
    );
}

#[test]
fn a_value_and_its_opposite_are_rivals_unless_one_is_chosen() {
    const RIVALS: &str = "wrong rival-answers";
    earn(
        &Asked("8", None, "", None),
        &[
            ("k = 8 or -8", RIVALS),
            ("k = 8 or k = -8", RIVALS),
            ("-8 or 8", RIVALS),
            ("k = -8 or 8, k>0 so k=8", "correct"),
            ("k = 0 or 8, so 8", "correct"),
            ("k = 3 or -8, so k = 8", "correct"),
            ("k = 8 or 3, so k = 3", "wrong"),
            ("k = 8 or -8 but k > 0", "correct"),
            ("k = ±8, k > 0", "correct"),
            ("k = ±8 so k = 8", "correct"),
            ("k = \\pm 8, k = 8", "correct"),
            ("±8, take positive", "correct"),
            ("k = ±8 since k > 0", "correct"),
            ("k = ±3, k > 0 so k = 3", "wrong"),
            ("±8, 3", RIVALS),
            ("k = ±8", "unreadable cannot-be-read"),
            ("±8", "unreadable cannot-be-read"),
            ("k = 8 or k = -8 but k > 0", "correct"),
            ("k = 8, k > 0", "correct"),
            ("k > 0, k = 8 or -8", "correct"),
            ("k = -8 < 0 so k = 8", "correct"),
            ("k = 9 > 8 so k = 8", "correct"),
            ("k = 8 (k > 0)", "correct"),
            ("k = 8, k < 0", RIVALS),
            ("k=8 (reject k = -8)", "correct"),
            ("k = 8, k = -3 (rejected)", "correct"),
            ("k = 8 (rejected)", "unreadable cannot-be-compared"),
            ("8.1 -> 8", "correct"),
            ("8 so -8", "partial sign"),
        ],
    );
    earn(&Asked("27/2", None, "impulse.magnitude", None), &[("13.5 or -13.5", RIVALS)]);
    earn(
        &Asked("5", None, "B.after.speed", None),
        &[
            ("w = 5, v = -3", "correct"),
            ("v = -3, w = 5", "correct"),
            ("v = 5, w = 3", "partial several-answers"),
            ("w = 5, speed = 3", "wrong"),
            ("5 m/s at 56.3° to the line of centres", "correct"),
            ("5 m/s or 56.3°", RIVALS),
        ],
    );
}

#[test]
fn a_chain_of_equal_formulas_ends_in_the_answer() {
    earn(
        &Asked("20*m*u", None, "impulse.magnitude", None),
        &[
            ("5m/2 × 8u = 20mu", "correct"),
            ("m(11u + 9u) = 20mu", "correct"),
            ("m(11u + 9u) = m × 20u = 20mu N s", "correct"),
            ("5m/2 × 4u = 20mu", "wrong"),
            ("5m/2 × 4u = 10mu", "wrong"),
        ],
    );
}

#[test]
fn directions_told_in_one_breath_with_sizes_are_shared_out() {
    let asked = [
        ("sqrt(13)", "A.after.speed"),
        ("atan(3/2)/deg", "A.after.angle_to_loc_deg"),
        ("5", "B.after.speed"),
        ("0", "B.after.angle_to_loc_deg"),
    ];
    let models = asked.map(|(right, quantity)| {
        let kind = quantity.ends_with("deg").then_some(Kind::Angle);
        let options = ModelOptions { kind, quantity: Some(quantity.parse().unwrap()), ..ModelOptions::default() };
        Model::read(right, &options).unwrap()
    });
    for typed in [
        "A 3.61 56.3°; B 5 along LOC",
        "A: 3.61 m/s at 56.3° to the line of centres B: 5 m/s along the line of centres",
        "B: 5 m/s along LOC; A: 3.61, 56.3°",
        "3.61, 56.3°, 5 along LOC",
    ] {
        let judged = judge_together(&models, &read_answer(typed, &models[0].vocabulary));
        assert!(judged.iter().all(|judgement| judgement.verdict == Verdict::Correct), "{typed}: {judged:?}");
    }
}

#[test]
fn components_told_together_are_shared_out_by_their_directions() {
    let asked = [("24*cos(35*deg)/35", "A.after.n"), ("3*sin(35*deg)", "A.after.t"), ("2.53", "B.after.speed")];
    let models = asked.map(|(right, quantity)| {
        let options = ModelOptions { quantity: Some(quantity.parse().unwrap()), ..ModelOptions::default() };
        Model::read(right, &options).unwrap()
    });
    for typed in [
        "along LOC 0.562, perpendicular 1.72, B 2.53",
        "0.562 along LOC, 1.72 perpendicular, B 2.53",
        "perpendicular 1.72, along LOC 0.562, B 2.53",
        "B 2.53, A 0.562 along LOC, 1.72 perp",
        "0.562, 1.72, 2.53",
    ] {
        let judged = judge_together(&models, &read_answer(typed, &models[0].vocabulary));
        assert!(judged.iter().all(|judgement| judgement.verdict == Verdict::Correct), "{typed}: {judged:?}");
    }
    let turned = judge_together(&models, &read_answer("perpendicular 0.562, along LOC 1.72", &models[0].vocabulary));
    assert!(turned.iter().all(|judgement| judgement.verdict != Verdict::Correct), "{turned:?}");
}

#[test]
fn a_vector_and_its_size_by_its_letter_are_shared_out() {
    let asked = [("i + 9*j/2", None), ("sqrt(85)/2", Some("A.after.speed"))];
    let models = asked.map(|(right, quantity)| {
        let quantity = quantity.map(|quantity| quantity.parse().unwrap());
        Model::read(right, &ModelOptions { quantity, ..ModelOptions::default() }).unwrap()
    });
    for typed in ["v = i + 4.5j, |v| = 4.61", "v = i + 4.5j\n|v| = √85/2", "i + 4.5j, 4.61"] {
        let judged = judge_together(&models, &read_answer(typed, &models[0].vocabulary));
        assert!(judged.iter().all(|judgement| judgement.verdict == Verdict::Correct), "{typed}: {judged:?}");
    }
}

#[test]
fn what_is_called_by_the_letter_to_be_found_is_that() {
    let of = |right: &str, quantity: Option<&str>, letter: Option<&str>| {
        let options = ModelOptions {
            kind: Some(Kind::Angle),
            letters: vec![Letter::new("alpha", Range::Acute).unwrap()],
            quantity: quantity.map(|quantity| quantity.parse().unwrap()),
            letter: letter.map(str::to_owned),
            ..ModelOptions::default()
        };
        Model::read(right, &options).unwrap()
    };
    let models = [of("38.3", None, Some("alpha")), of("13.3", Some("A.deflection_deg"), None)];
    for typed in ["38.3°, 13.3°", "α = 38.3°, 13.3°", "13.3° at α = 38.3°", "13.3°, α = 38.3°"] {
        let judged = judge_together(&models, &read_answer(typed, &models[0].vocabulary));
        assert!(judged.iter().all(|judgement| judgement.verdict == Verdict::Correct), "{typed}: {judged:?}");
    }
    let judged = judge_together(&models, &read_answer("13.3° when α = 38.3°", &models[0].vocabulary));
    assert!(judged.iter().all(|judgement| judgement.verdict == Verdict::Unreadable), "{judged:?}");
    // What is asked is no place of itself.
    let alone = judge(&models[0], &read_answer("38.3° when α = 13.3°", &models[0].vocabulary));
    assert_eq!(alone.verdict, Verdict::Unreadable, "{alone:?}");
}

#[test]
fn a_rival_that_lacks_a_letter_or_has_another_unit_is_a_rival() {
    const RIVALS: &str = "wrong rival-answers";
    earn(&Asked("9*m", None, "", None), &[("9m or 9", RIVALS), ("9m, 9", RIVALS), ("9m or 9m", "correct")]);
    earn(&Asked("9*m*u", None, "", None), &[("9mu or 9u", RIVALS), ("9u or 9mu", RIVALS)]);
    earn(&Asked("u*(1 + e)/3", None, "", None), &[("u(1+e)/3 or (1+e)/3", RIVALS)]);
    earn(&Asked("48/25", None, "ke.lost", None), &[("1.92 J or 1.92 kJ", RIVALS), ("1.92 J, 1.92 kJ", RIVALS)]);
    earn(
        &Asked("25/7", None, "A.after.speed", None),
        &[("3.57 m/s or 3.57 cm/s", RIVALS), ("3.57 m/s or 357 cm/s", "correct"), ("25/7 or 3.57 m/s", "correct")],
    );
    earn(&Asked("9", None, "impulse.magnitude", None), &[("9 Ns or 9 kN s", RIVALS)]);
}

#[test]
fn what_leads_to_the_answer_or_is_true_besides_is_no_rival() {
    const RIVALS: &str = "wrong rival-answers";
    const OTHERWISE: &str = "unreadable named-otherwise";
    earn(
        &Asked("5/7", None, "e", None),
        &[
            ("separation 5, approach 7, e = 5/7", "correct"),
            ("speed of separation 5, speed of approach 7, e = 5/7", "correct"),
            ("approach 7 separation 5 so e = 5/7", "correct"),
            ("separation 5, approach 7, e = 7/5", "wrong inverted"),
            ("separation = 5/7", OTHERWISE),
            ("separation/approach = 5/7", "correct"),
            ("e = 5/7, 0 < e < 1", "correct"),
            ("e = 5/7 (0 < e < 1)", "correct"),
            ("e = 5/7 and 0 ≤ e ≤ 1", "correct"),
            ("e = 5/7 < 1", "correct"),
            ("e = 7/5 > 1", "wrong inverted"),
            ("e = 5/7 or 7/5, 0 < e < 1", "correct"),
            ("e = 5/7, which is less than 1", "correct"),
            ("e = 5/7, which is more than 1", "unreadable cannot-be-compared"),
        ],
    );
    earn(
        &Asked("25/9", None, "A.after.speed", None),
        &[
            ("v - 2.78 = 0", "partial not-solved"),
            ("v - 25/9 = 0", "partial not-solved"),
            ("v - 2.8 = 0", "partial under-accurate"),
            ("speed before 5, speed after 2.78", "correct"),
            ("speed before 2.78, speed after 5", "wrong"),
            ("5 before and 2.78 after", "correct"),
            ("2.78 before and 5 after", "wrong"),
            ("5 before or 2.78 after", RIVALS),
            ("2.78 (speed of separation)", OTHERWISE),
            ("increases by 2.78 m/s", OTHERWISE),
            ("its speed decreased by 2.78", OTHERWISE),
            ("its speed decreased to 2.78", "correct"),
            ("by CLM v = 2.78", "correct"),
            ("horizontal 1.5, vertical 2.34, speed 2.78", "correct"),
            ("horizontal 2.78, vertical 2.34, speed 3.64", "wrong"),
            ("reduced from 5 to 2.78", "unreadable cannot-be-compared"),
            ("reduced from 2.78 to 2", "wrong"),
            ("v = 5, u = 2.78", OTHERWISE),
            ("u = 2.78, v = 5", "partial several-answers"),
            ("u = 5, v = 2.78", "correct"),
        ],
    );
    earn(
        &Asked("4*i + j", None, "A.after.x", None),
        &[
            ("before 2i+j after 4i+j", "correct"),
            ("before 4i+j after 2i+j", "wrong"),
            ("2i+j before, 4i+j after", "correct"),
            ("velocity after is 4i + j (before it was 2i + j)", "correct"),
        ],
    );
    earn(
        &Asked("5/7", None, "", None),
        &[
            ("0.7 (5/7)", "correct"),
            ("5/7 = 0.7", "correct ignored-after"),
            ("0.7 = 5/7", "correct"),
            ("0.8 (4/5)", "wrong"),
            ("0.7 or 5/7", RIVALS),
            ("0.7 = 4/5", "wrong"),
            ("0.7 (0.714)", "correct"),
        ],
    );
    earn(
        &Asked("30", None, "A.deflection_deg", None),
        &[
            ("changed from 45 to 75, i.e. 30°", "correct"),
            ("from 45° to 75°, i.e. 30°", "correct"),
            ("changed from 45 to 75, i.e. 120°", "wrong"),
            ("from 45 to 75", "wrong"),
            ("before 75, after 45, deflection 30", "correct"),
            ("before 75, after 30, deflection 45", "wrong"),
            ("from 30 to 75", "wrong"),
            ("(15, 45), 30", RIVALS),
            ("from 45 to 70, i.e. 30°", "wrong"),
        ],
    );
    earn(
        &Asked("9", None, "impulse.magnitude", None),
        &[
            ("I = m(v-u) = 3(5-2) = 9 Ns", "correct"),
            ("I = mv - mu = 15 - 6 = 9", "correct"),
            ("impulse on A is -9, on B is 9", "correct"),
            ("impulse on A is 9, on B is 12", "partial several-answers"),
            ("momentum of A is 9", OTHERWISE),
            ("change in momentum of A is 9", "correct"),
            ("m(v-u) = 3(5-2) = 9", "correct"),
            ("I = m(v-u) = 3(5-3) = 6 Ns", "wrong"),
            ("I = m(v-u)", "unreadable cannot-be-read"),
            ("I = 9 = m(v-u)", "unreadable cannot-be-read"),
            ("v = x = 9", "unreadable cannot-be-read"),
        ],
    );
    earn(
        &Asked("48/25", None, "ke.lost", None),
        &[
            ("KE before 5.44, after 3.52, loss 1.92", "correct"),
            ("5.44 before, 3.52 after, 1.92 lost", "correct"),
            ("KE after = 1.92, KE lost = 3.52", "wrong"),
            ("1.92 after, 3.52 lost", "wrong"),
            ("E = 1.92 J", "correct"),
            ("KE goes from 5.44 to 3.52, so 1.92 J lost", "correct"),
            ("from 5.44 to 1.92", "wrong"),
            ("1.92 (48/25) J", "correct"),
            ("48/25 [1.92] J", "correct"),
            ("1.92 (48/25) kJ", RIVALS),
        ],
    );
    earn(
        &Asked("4*i + j", None, "", None),
        &[
            ("4i+j, speed √17", "correct"),
            ("4i + j (speed √17)", "correct"),
            ("v=4i+j so |v|=√17", "correct"),
            ("(4i+j) m/s, magnitude 4.12", "correct"),
            ("4i+j, speed 5", RIVALS),
            ("4i+j or speed √17", RIVALS),
            ("4i+2j, speed √17", "wrong"),
            ("speed √17", "wrong scalar-for-vector"),
        ],
    );
    earn(
        &Asked("5", None, "A.after.speed", None),
        &[
            ("v=5,θ=53.1", "correct"),
            ("speed 5 angle 53.1", "correct"),
            ("v = 3, θ = 5", "wrong"),
            ("θ = 5", OTHERWISE),
        ],
    );
    earn(
        &Asked("10/43", None, "ke.fraction_lost", None),
        &[
            ("lost 10/43, kept 33/43", "correct"),
            ("23.3% lost, 76.7% remains", "correct"),
            ("76.7% lost, 23.3% remains", "wrong"),
            ("10/43 remains", OTHERWISE),
            ("fraction lost = 10/43, fraction remaining = 33/43", "correct"),
            ("10/43 lost, 33/43 left", "correct"),
            ("33/43 lost, 10/43 left", "wrong"),
        ],
    );
}
