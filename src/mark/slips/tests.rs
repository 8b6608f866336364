//! Wrong answers and their causes, in words and in marks.

use crate::expr::Angles;
use crate::mark::reading::{Form, Said, Vocabulary, read_answer};
use crate::mechanics::{Axis, Known, Law, Moment, Quantity, Scene, SceneText, Sphere, pose};
use crate::number::{Letter, Range, Value};
use crate::solve::solve;

use super::{Asked, Cause, Mistakes, early_rounding};

const SPEED_OF_A: Quantity = Quantity::Speed(Sphere::A, Moment::After);
const SPEED_OF_B: Quantity = Quantity::Speed(Sphere::B, Moment::After);
const ANGLE_OF_A: Quantity = Quantity::AngleToLine(Sphere::A, Moment::After);

fn scene(text: &str) -> Scene {
    let text: SceneText = serde_json::from_str(text).unwrap();
    Scene::read(&text, &(), Angles::Radians).unwrap()
}

fn posed(text: &str) -> Known<Value> {
    pose(&scene(text)).unwrap()
}

fn asked<const COUNT: usize>(answers: [Vec<Quantity>; COUNT]) -> [Asked; COUNT] {
    answers.map(Asked::Quantities)
}

/// A of 4 kg with 4 m/s at 30 degrees strikes B of 2 kg at rest, e = 1/3: A goes on with 2.78 at 46.1, B with 3.08.
fn b_at_rest() -> Known<Value> {
    posed(
        r#"{"masses": {"A": "4", "B": "2"}, "before": {"A": {"speed": "4", "angle_deg": "30"}, "B": ["0", "0"]},
            "line_of_centres": ["1", "0"], "sense": "A_to_B", "e": "1/3"}"#,
    )
}

/// A of 2 kg with 4i - j, B of 4 kg with 2i + j, line of centres along j, e = 1/2: afterwards 4i + j and 2i.
fn along_j() -> Known<Value> {
    posed(
        r#"{"masses": {"A": "2", "B": "4"}, "before": {"A": ["4", "-1"], "B": ["2", "1"]},
            "line_of_centres": ["0", "1"], "e": "1/2"}"#,
    )
}

/// Equal masses, A with u at alpha, B at rest.
fn in_letters() -> (Known<Value>, Vec<Letter>) {
    let letters = [("m", Range::Positive), ("u", Range::Positive), ("e", Range::Unit), ("alpha", Range::Acute)];
    let known = posed(
        r#"{"masses": {"A": "m", "B": "m"}, "before": {"A": ["u*cos(alpha)", "u*sin(alpha)"], "B": ["0", "0"]},
            "line_of_centres": ["1", "0"], "sense": "A_to_B", "e": "e",
            "symbols": {"m": "positive", "u": "positive", "e": "unit", "alpha": "acute"}}"#,
    );
    (known, letters.into_iter().map(|(name, range)| Letter::new(name, range).unwrap()).collect())
}

fn velocity(sphere: Sphere) -> Vec<Quantity> {
    [Axis::X, Axis::Y].map(|axis| Quantity::Velocity(sphere, Moment::After, axis)).to_vec()
}

fn said(text: &str, letters: &[Letter]) -> Said {
    let vocabulary = Vocabulary { letters: letters.to_vec(), vectors: true };
    let readings = read_answer(text, &vocabulary).unwrap_or_else(|fault| panic!("{text}: {fault:?}"));
    readings[0].statements[0].said[0].clone()
}

fn tags(causes: &[Cause]) -> Vec<&'static str> {
    causes.iter().filter(|cause| cause.tags.len() == 1).map(|cause| cause.tags[0]).collect()
}

fn law(name: &str) -> Law {
    *Law::ALL.iter().find(|law| law.name() == name).unwrap()
}

#[test]
fn carom_names_every_cause_of_a_wrong_number_likely_ones_first() {
    let answers = asked([vec![SPEED_OF_A], vec![SPEED_OF_B], vec![ANGLE_OF_A]]);
    let mistakes = Mistakes::of(&b_at_rest(), &answers, &[], None);
    for (answer, text, expected) in [
        (0, "3.64", &["sincos-swap", "wrong-axis"][..]),
        (0, "2.31", &["e-wrong-side", "masses-omitted", "e-taken-as-1"]),
        (0, "2.3", &["e-wrong-side", "perpendicular-shared", "masses-omitted", "e-taken-as-1"]),
        (0, "4√3/3", &["e-wrong-side", "masses-omitted", "e-taken-as-1"]),
        (0, "7.70", &["speed-no-root"]),
        (0, "1.92", &["perpendicular-dropped"]),
        (0, "3.08", &["other-sphere"]),
        (0, "27.8", &["factor-of-ten"]),
        (0, "2", &["right-angle-assumed", "one-component"]),
        (1, "1.78", &["sincos-swap", "wrong-axis"]),
        (1, "-1.78", &["sincos-swap", "wrong-axis"]),
        (2, "43.9°", &["angle-complement"]),
        (2, "16.1", &["deflection-for-direction"]),
        (2, "0.805", &["angle-in-radians"]),
        (2, "0.805 rad", &[]),
    ] {
        let found = mistakes.causes(&answers[answer], &said(text, &[]));
        assert_eq!(tags(&found), expected, "{text}");
    }
}

#[test]
fn a_slip_at_one_impact_of_two_says_at_which() {
    // 4i - 6j becomes 4i + 3j at the first wall and -i + 3j at the second.
    let known = posed(
        r#"{"masses": {"A": "1"}, "before": {"A": ["4", "-6"]}, "wall": ["1", "0"], "e": "1/2",
            "then": [{"of": ["A"], "wall": ["0", "1"], "e": "1/4"}]}"#,
    );
    let after = velocity(Sphere::A).into_iter().map(|quantity| quantity.in_impact(1).unwrap()).collect();
    let asked = asked([after]);
    let mistakes = Mistakes::of(&known, &asked, &[], None);
    for (text, only) in [
        ("-4i + 6j", None),
        ("-i + 6j", Some("So it is in the first impact only.")),
        ("-4i + 3j", Some("So it is in the second impact only.")),
    ] {
        let causes = mistakes.causes(&asked[0], &said(text, &[]));
        assert_eq!(tags(&causes), ["e-taken-as-1"], "{text}");
        let sentence = &causes[0].sentence;
        assert!(only.map_or(!sentence.contains("only"), |only| sentence.ends_with(only)), "{text}: {sentence}");
    }
}

#[test]
fn on_one_line_nobody_takes_another_axis() {
    let known = posed(r#"{"masses": {"A": "1", "B": "3"}, "before": {"A": "11", "B": "3"}, "e": "1/2"}"#);
    let asked = asked([vec![Quantity::Speed(Sphere::A, Moment::After)]]);
    let mistakes = Mistakes::of(&known, &asked, &[], None);
    let tags = tags(&mistakes.causes(&asked[0], &said("11", &[])));
    assert!(tags.contains(&"before-for-after") && !tags.contains(&"wrong-axis"), "{tags:?}");
}

#[test]
fn an_answer_that_is_right_at_its_figures_has_no_cause() {
    let answers = asked([vec![SPEED_OF_A], vec![SPEED_OF_B], vec![ANGLE_OF_A]]);
    let mistakes = Mistakes::of(&b_at_rest(), &answers, &[], None);
    for (answer, text) in
        [(0, "2.78"), (0, "2.8"), (0, "2.77"), (0, "4√39/9"), (1, "3.1"), (1, "3.07"), (2, "46"), (2, "46.1°")]
    {
        assert_eq!(mistakes.causes(&answers[answer], &said(text, &[])), [], "{text}");
    }
}

#[test]
fn one_figure_is_no_evidence_unless_it_is_the_exact_value() {
    let answers = asked([vec![SPEED_OF_A]]);
    let mistakes = Mistakes::of(&b_at_rest(), &answers, &[], None);
    assert_eq!(tags(&mistakes.causes(&answers[0], &said("4", &[]))), ["before-for-after"]);
    assert_eq!(mistakes.causes(&answers[0], &said("9", &[])), []);
}

#[test]
fn two_figures_are_no_evidence_of_two_mistakes() {
    let answers = asked([vec![SPEED_OF_A]]);
    let mistakes = Mistakes::of(&b_at_rest(), &answers, &[], None);
    let found = |text: &str| mistakes.causes(&answers[0], &said(text, &[]));
    for tenth in 10..100 {
        let text = format!("{}.{}", tenth / 10, tenth % 10);
        assert!(found(&text).iter().all(|cause| cause.tags.len() == 1), "{text}: {:?}", found(&text));
    }
    // Nor is a whole number, which would have been given to more figures; it may be the value itself.
    for text in ["11", "13", "14", "17", "19", "21", "23"] {
        assert_eq!(found(text), [], "{text}");
    }
    assert!(found("3.53").iter().any(|cause| cause.tags.len() == 2));
}

#[test]
fn vectors_are_recognised_by_their_components() {
    let answers = asked([velocity(Sphere::A), velocity(Sphere::B)]);
    let mistakes = Mistakes::of(&along_j(), &answers, &[], None);
    for (answer, text, expected) in [
        // Afterwards A has 4i + j.
        (0, "4i + 3j", &["e-wrong-side"][..]),
        (0, "2i + j", &["e-on-perpendicular"]),
        (0, "4i + 1.67j", &["e-taken-as-1"]),
        (0, "4i + 5/3 j", &["e-taken-as-1"]),
        (0, "j", &["perpendicular-dropped"]),
        (0, "2i", &["other-sphere"]),
        (0, "4i - j", &["before-for-after"]),
        (0, "4.00i - 1.00j", &["before-for-after"]),
        (0, "-4i - j", &["wrong-sign"]),
        (1, "2i - j", &["e-wrong-side", "masses-swapped"]),
    ] {
        let found = mistakes.causes(&answers[answer], &said(text, &[]));
        assert!(tags(&found).starts_with(expected) || tags(&found).ends_with(expected), "{text}: {:?}", tags(&found));
        assert_eq!(tags(&found).len(), expected.len(), "{text}: {:?}", tags(&found));
    }
}

#[test]
fn formulas_in_letters_are_recognised() {
    let (known, letters) = in_letters();
    let along = |sphere| vec![Quantity::Velocity(sphere, Moment::After, Axis::N)];
    let answers = asked([along(Sphere::A), along(Sphere::B), vec![Quantity::TanDeflection(Sphere::A)]]);
    let mistakes = Mistakes::of(&known, &answers, &letters, None);
    for (answer, text, expected) in [
        (0, "u cos α(1 + e)/2", &["restitution-reversed", "other-sphere"][..]),
        (0, "u sin α(1 - e)/2", &["sincos-swap"]),
        (0, "u(1 - e)/2", &["not-resolved"]),
        (0, "u cos α(e - 1)/(2e)", &["e-wrong-side"]),
        (2, "2tan α/(1-e) - tan α", &["tangents-subtracted"]),
        (2, "2tan α/(1-e)", &["direction-for-deflection"]),
    ] {
        let found = mistakes.causes(&answers[answer], &said(text, &letters));
        assert_eq!(tags(&found), expected, "{text}");
    }
}

#[test]
fn pairs_of_slips_come_after_single_ones() {
    let answers = asked([vec![SPEED_OF_A]]);
    let mistakes = Mistakes::of(&b_at_rest(), &answers, &[], None);
    // Sine for cosine, and e as 1: 2(4 - 2)/6 along the line of centres, 2 root 3 across it.
    let found = mistakes.causes(&answers[0], &said("3.5276684", &[]));
    let pair = found.iter().find(|cause| cause.tags == ["sincos-swap", "e-taken-as-1"]).expect("the pair");
    assert_eq!(pair.laws, [law("resolve"), law("restitution")]);
    assert_eq!((pair.earns_method(law("resolve")), pair.earns_method(law("restitution"))), (true, false));
    // Three figures have both by chance: in one scene of several.
    let mut both = 0;
    for (mass, e) in [("1", "1/2"), ("3", "1/4"), ("5", "2/3"), ("6", "3/5")] {
        let known = posed(&format!(
            r#"{{"masses": {{"A": "{mass}", "B": "2"}}, "before": {{"A": {{"speed": "7", "angle_deg": "35"}}, "B": ["0", "0"]}},
                "line_of_centres": ["1", "0"], "sense": "A_to_B", "e": "{e}"}}"#
        ));
        let mistakes = Mistakes::of(&known, &answers, &[], None);
        for hundredth in 100..1000 {
            let text = format!("{}.{:02}", hundredth / 100, hundredth % 100);
            let found = mistakes.causes(&answers[0], &said(&text, &[]));
            let single = found.iter().rposition(|cause| cause.tags.len() == 1);
            let pair = found.iter().position(|cause| cause.tags.len() == 2);
            if let Some((single, pair)) = single.zip(pair) {
                assert!(single < pair, "{text}: {found:?}");
                both += 1;
            }
        }
    }
    assert!(both > 0);
}

/// The table of which marks survive: perpendicular, momentum, restitution, solve, speed; method and accuracy of each.
#[test]
fn sign_slips_keep_the_method_and_missing_terms_lose_it() {
    let scene = posed(
        r#"{"masses": {"A": "3", "B": "1"}, "before": {"A": ["1", "3"], "B": ["-4", "2"]},
            "line_of_centres": ["1", "0"], "e": "3/4"}"#,
    );
    let answers = asked([vec![SPEED_OF_A]]);
    let mistakes = Mistakes::of(&scene, &answers, &[], None);
    let laws = ["perpendicular", "momentum", "restitution", "solve", "speed"].map(law);
    for (tag, text, marks) in [
        ("sincos-swap", "1.288470508", "M- M- M- M- M-"),
        ("restitution-reversed", "3.077768063", "MA MA M- M- M-"),
        ("momentum-sign", "3.108079189", "MA M- MA M- M-"),
        ("e-wrong-side", "3.560001560", "MA MA -- -- M-"),
        ("not-resolved", "3.005262904", "MA -- -- -- M-"),
        ("restitution-not-resolved", "3.439081663", "MA MA -- -- M-"),
        ("masses-swapped", "6.319921380", "MA -- MA -- M-"),
        ("e-on-perpendicular", "2.544141554", "-- MA MA MA M-"),
        ("perpendicular-dropped", "1.1875", "-- MA MA MA --"),
        ("speed-sum", "4.1875", "MA MA MA MA --"),
    ] {
        let causes = mistakes.causes(&answers[0], &said(text, &[]));
        let cause = causes.iter().find(|cause| cause.tags == [tag]).unwrap_or_else(|| panic!("{tag}: {causes:?}"));
        let of = |law| {
            let method = if cause.earns_method(law) { 'M' } else { '-' };
            let accuracy = if cause.earns_accuracy(law) { 'A' } else { '-' };
            format!("{method}{accuracy}")
        };
        assert_eq!(laws.map(of).join(" "), marks, "{tag}");
    }
}

#[test]
fn a_calculator_in_radians_is_recognised() {
    let answers = asked([vec![SPEED_OF_B]]);
    let mistakes = Mistakes::of(&b_at_rest(), &answers, &[], None);
    // 4 cos(30 rad) 4/6 (1 + 1/3)
    assert_eq!(tags(&mistakes.causes(&answers[0], &said("0.548", &[]))), ["radian-mode"]);
}

#[test]
fn rounding_on_the_way_is_recognised_with_the_working_and_without() {
    let expr = |text: &str| match said(text, &[]).form {
        Form::Value(expr) => expr,
        other => panic!("{other:?}"),
    };
    let along = Quantity::Velocity(Sphere::A, Moment::After, Axis::N);
    let rounding = |text: &str, shown: &[(Quantity, crate::expr::Expr)]| {
        early_rounding(&b_at_rest(), &[], SPEED_OF_A, shown, &said(text, &[]))
    };
    // v = 1.92450, so with 1.9 the speed may be 2.724 to 2.794.
    let shown = [(along, expr("1.9"))];
    assert_eq!(rounding("2.76", &shown).map(|found| found.figures), Some(None));
    assert_eq!(rounding("2.76", &[]).map(|found| found.figures), Some(Some(2)));
    assert_eq!(rounding("2.78", &shown), None, "it is right");
    assert_eq!(rounding("2.85", &shown), None, "it is further off than rounding explains");
    assert_eq!(rounding("2.72", &[(along, expr("1.8"))]), None, "what is shown is not the right value rounded");
    assert_eq!(rounding("2.79", &[]), None, "no rounding leads there");
}

/// What slips lead to where a letter is found backwards, as formulas of their own have it.
#[test]
fn a_letter_is_found_again_by_who_makes_a_slip() {
    // A of 2 strikes B of 3 at rest with 5: A's velocity after is 5(2 - 3e)/5, with the slips those of the comments.
    let turned_back = r#"{"masses": {"A": "2", "B": "3"}, "before": {"A": "5", "B": "0"}, "e": "e",
        "symbols": {"e": "unit"}, "unknowns": ["e"], "conditions": ["A.after.x < 0"]}"#;
    // B moves with 1 towards A: (k + 1) v = 2 k - 1 - e 3 with e = 1/2, in units of m and u.
    let goes_on = r#"{"masses": {"A": "k*m", "B": "m"}, "before": {"A": "2*u", "B": "-u"}, "e": "1/2",
        "symbols": {"k": "positive", "m": "positive", "u": "positive"}, "unknowns": ["k"],
        "conditions": ["A.after.x > 0"]}"#;
    // tan^2 = (3 - e)/4 makes the deflection greatest, for any e.
    let greatest = r#"{"masses": {"A": "3", "B": "1"}, "before": {"A": {"speed": "u", "angle_deg": "alpha"}, "B": ["0", "0"]},
        "line_of_centres": ["1", "0"], "sense": "A_to_B", "e": "1/2", "symbols": {"u": "positive", "alpha": "acute"},
        "unknowns": ["alpha"], "maximise": "A.tan_deflection"}"#;
    // At 60 degrees to the wall it leaves at a right angle to how it came: e = cot^2.
    let right_angle = r#"{"masses": {"A": "2"}, "before": {"A": {"speed": "4", "angle_deg": "-60"}}, "wall": ["1", "0"],
        "e": "e", "symbols": {"e": "unit"}, "unknowns": ["e"], "conditions": ["A.deflection_dot = 0"]}"#;
    let degrees = |square: f64| square.sqrt().atan().to_degrees();
    let e = Asked::Quantities(vec![Quantity::Restitution]);
    for (text, asked, tag, expected) in [
        (turned_back, Asked::Ends, "masses-swapped", 1.5),    // 3 - 2e
        (turned_back, Asked::Ends, "e-wrong-side", 1.5),      // 2 - 3/e
        (turned_back, Asked::Ends, "masses-omitted", 1.0),    // 1 - e
        (goes_on, Asked::Ends, "e-taken-as-1", 2.0),          // 2k - 1 - 3
        (goes_on, Asked::Ends, "coalesce", 0.5),              // 2k - 1
        (goes_on, Asked::Ends, "momentum-sign", 0.25),        // 2k + 1 - 3/2
        (goes_on, Asked::Ends, "restitution-ignores-b", 1.0), // 2k - 1 - 1
        (greatest, Asked::Unknown, "e-taken-as-1", degrees(2.0 / 4.0)),
        (greatest, Asked::Unknown, "coalesce", degrees(3.0 / 4.0)),
        (right_angle, e, "sincos-swap", 3.0),
    ] {
        let solution = solve(scene(text), &[]).unwrap();
        let letters = solution.scene().letters.clone();
        let given = solution.given().clone();
        let mistakes = Mistakes::of(&given, std::slice::from_ref(&asked), &letters, solution.sought().as_ref());
        let values = mistakes.values(&asked);
        let found: Vec<f64> = values.iter().filter(|(tags, _)| *tags == [tag]).map(|(_, value)| value[0]).collect();
        assert!(
            found.iter().any(|found| (found - expected).abs() < 1e-6),
            "{tag}: {found:?}, not {expected}\n{values:?}"
        );
    }
}

/// A slip that leaves nothing to be found leads to no number.
#[test]
fn who_finds_nothing_finds_no_number() {
    let text = r#"{"masses": {"A": "1", "B": "3"}, "before": {"A": "5", "B": "0"}, "e": "e", "symbols": {"e": "unit"},
        "unknowns": ["e"], "conditions": ["A.after.x < 0"]}"#;
    let solution = solve(scene(text), &[]).unwrap();
    let given = solution.given().clone();
    let mistakes = Mistakes::of(&given, &[Asked::Ends], &solution.scene().letters, solution.sought().as_ref());
    // With e = 1 or e = 0 there is no e to be found, and in a direct impact no paths are at right angles.
    let values = mistakes.values(&Asked::Ends);
    for tag in ["e-taken-as-1", "coalesce", "right-angle-assumed"] {
        assert!(!values.iter().any(|(tags, _)| *tags == [tag]), "{tag}: {values:?}");
    }
}

#[test]
fn an_end_of_a_range_that_is_none_has_its_causes() {
    let text = r#"{"masses": {"A": "2", "B": "3"}, "before": {"A": "5", "B": "0"}, "e": "e",
        "symbols": {"e": "unit"}, "unknowns": ["e"], "conditions": ["A.after.x < 0"]}"#;
    let solution = solve(scene(text), &[]).unwrap();
    let letters = solution.scene().letters.clone();
    let given = solution.given().clone();
    let mistakes = Mistakes::of(&given, &[Asked::Ends], &letters, solution.sought().as_ref());
    let three_halves = &["e-wrong-side", "masses-swapped"][..];
    for (text, expected) in [
        ("e > 3/2", three_halves),
        ("1.5 < e", three_halves),
        ("2e > 3", three_halves),
        ("1 < 2e/3", three_halves),
        ("e < 3/2", three_halves),
        ("2/3 < e <= 1", &[]),
        ("e > 0.667", &[]),
        ("e <= 1", &[]),
        ("e > 1/7", &[]),
    ] {
        let found = mistakes.causes(&Asked::Ends, &said(text, &letters));
        assert_eq!(tags(&found), expected, "{text}");
    }
}
