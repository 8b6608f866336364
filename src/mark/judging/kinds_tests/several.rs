//! Several things said: chains, rivals, words beside a value, and answers to several things asked together.

use super::*;

#[test]
fn a_chain_ignores_what_follows_and_rivals_score_nothing() {
    let speed = asked("25/7", None, "A.after.speed");
    let chain = |texts: &[&str]| earns(&speed, Some("v"), texts.iter().map(|text| value(text)).collect());
    assert_eq!(chain(&["25/7", "3.6"]), "correct");
    assert_eq!(chain(&["25/7", "3.75"]), "correct ignored-after");
    assert_eq!(chain(&["2 + 1.57", "3.57"]), "correct");
    assert_eq!(chain(&["3.57", "3.6"]), "correct");
    assert_eq!(chain(&["3.57", "4.2"]), "wrong rival-answers");
    assert_eq!(chain(&["4.2", "3.57"]), "wrong rival-answers");
    assert_eq!(chain(&["5 - 1", "4"]), "wrong too-few-figures");
    let rivals = |rows: &[(Option<&str>, &str)]| {
        states(&speed, &rows.iter().map(|(label, text)| (*label, value(text))).collect::<Vec<_>>())
    };
    assert_eq!(rivals(&[(None, "25/7"), (None, "3.57")]), "correct");
    assert_eq!(rivals(&[(None, "25/7"); 17]), "unreadable too-long");
    assert_eq!(rivals(&[(None, "25/7"), (None, "4")]), "wrong rival-answers");
    assert_eq!(rivals(&[(None, "4"), (None, "25/7")]), "wrong rival-answers");
    assert_eq!(rivals(&[(Some("x"), "5/2"), (Some("y"), "3"), (Some("speed"), "25/7")]), "correct");
    assert_eq!(rivals(&[(Some("v_A"), "25/7"), (Some("v_B"), "9")]), "correct");
    assert_eq!(rivals(&[(Some("v_A"), "9"), (Some("v_B"), "25/7")]), "wrong");
    assert_eq!(rivals(&[(Some("v_B"), "25/7"), (Some("w_B"), "25/7")]), "wrong");
    let nameless = model("25/7", None, "");
    let labelled = |a: &str, b: &str| states(&nameless, &[(Some("A"), value(a)), (Some("B"), value(b))]);
    assert_eq!(labelled("25/7", "9"), "partial several-answers");
    assert_eq!(labelled("8", "9"), "wrong");
}

#[test]
fn words_that_turn_the_meaning_are_for_a_person() {
    let line = model("i - 3*j", Some(Kind::Line), "");
    let speed = model("25/7", None, "");
    let with = |said: Said, remark: &str| Said { remarks: vec![remark.to_owned()], ..said };
    let along = || said(Form::Vector(expr("1"), expr("-3"), Notation::UnitVectors));
    assert_eq!(earns(&line, None, vec![with(along(), "parallel to")]), "correct");
    assert_eq!(earns(&line, None, vec![with(along(), "perpendicular to")]), "unreadable cannot-be-compared");
    assert_eq!(earns(&speed, None, vec![with(value("25/7"), "as required")]), "correct");
    assert_eq!(earns(&speed, None, vec![with(value("25/7"), "is wrong")]), "unreadable cannot-be-compared");
    assert_eq!(earns(&speed, None, vec![with(value("3"), "is not it")]), "wrong");
}

#[test]
fn two_things_asked_together_are_told_apart_by_label_or_by_order() {
    let models = [asked("1", None, "A.after.speed"), asked("sqrt(13)", None, "B.after.speed")];
    let together = |rows: &[(Option<&str>, &str)]| -> Vec<String> {
        let statements = rows.iter().flat_map(|(label, text)| reading(*label, vec![value(text)]).statements).collect();
        let readings = Ok(vec![Reading { statements, ..reading(None, Vec::new()) }]);
        judge_together(&models, &readings).iter().map(named).collect()
    };
    assert_eq!(together(&[(None, "1"), (None, "3.61")]), ["correct", "correct"]);
    assert_eq!(together(&[(None, "3.61"), (None, "1")]), ["wrong", "wrong"]);
    assert_eq!(together(&[(Some("B"), "3.61"), (Some("A"), "1")]), ["correct", "correct"]);
    // Which is which the letters may say, and only to a person.
    let by_letters = |typed: &str| -> Vec<String> {
        judge_together(&models, &read_answer(typed, &models[0].vocabulary)).iter().map(named).collect()
    };
    assert_eq!(by_letters("v = 1, w = 3.61"), ["correct", "correct"]);
    assert_eq!(by_letters("w = 3.61, v = 1"), ["unreadable named-otherwise", "unreadable named-otherwise"]);
    assert_eq!(by_letters("w = 3.61, v = 2"), ["wrong", "wrong"]);
    assert_eq!(together(&[(Some("speed of A"), "1")]), ["correct", "blank blank"]);
    assert_eq!(together(&[(None, "1")]), ["correct", "blank blank"]);
}

#[test]
fn the_first_reading_that_fares_best_is_used_and_named() {
    let model = model("u/(2*v)", None, "");
    let one = |text: &str, printed: &str| Reading { printed: printed.to_owned(), ..reading(None, vec![value(text)]) };
    let both = Ok(vec![one("u/2*v", "(u/2)v"), one("u/(2*v)", "u/(2v)")]);
    let judgement = judge(&model, &both);
    assert_eq!((judgement.verdict, judgement.reading.as_deref()), (Verdict::Correct, Some("u/(2v)")));
    let neither = judge(&model, &Ok(vec![one("u", "u"), one("v", "v")]));
    assert_eq!((neither.verdict, neither.reading.as_deref()), (Verdict::Wrong, Some("u")));
    assert_eq!(named(&judge(&model, &Err(Unreadable::Blank))), "blank blank");
    assert_eq!(named(&judge(&model, &Err(Unreadable::TooLong))), "unreadable too-long");
    assert_eq!(named(&judge(&model, &Err(Unreadable::Sign(0, String::new())))), "unreadable cannot-be-read");
    assert_eq!(named(&judge(&model, &Ok(Vec::new()))), "unreadable cannot-be-read");
}

#[test]
fn an_answer_is_judged_alike_of_whichever_impact_it_is() {
    let rows = [
        ("A.after.angle_to_wall_deg", "90", "perpendicular to the wall", "correct"),
        ("A.after.angle_to_wall_deg", "30", "60 degrees to the normal", "correct"),
        ("A.after.angle_to_wall_deg", "30", "60 degrees to the wall", "wrong complement"),
        ("A.after.speed", "3", "-3", "partial sign"),
        ("A.after.n", "3", "-3", "wrong sign"),
    ];
    for (quantity, right, typed, expected) in rows {
        for of in [quantity.to_owned(), format!("second.{quantity}")] {
            let kind = quantity.ends_with("deg").then_some(Kind::Angle);
            let options = ModelOptions { kind, quantity: Some(of.parse().unwrap()), ..ModelOptions::default() };
            let model = Model::read(right, &options).unwrap();
            let judged = judge(&model, &read_answer(typed, &model.vocabulary));
            assert_eq!(named(&judged), expected, "{of}: {typed}");
        }
    }
}

#[test]
fn a_label_names_one_of_three_spheres() {
    // Three spheres, and which of them a label names.
    let models = ["second.B.after.speed", "second.C.after.speed"].map(|of| {
        let quantity = Some(of.parse().unwrap());
        let right = if of.contains('B') { "1" } else { "5" };
        Model::read(right, &ModelOptions { quantity, ..ModelOptions::default() }).unwrap()
    });
    for typed in ["B: 1, C: 5", "v_C = 5 and v_B = 1", "1, 5"] {
        let judged = judge_together(&models, &read_answer(typed, &models[0].vocabulary));
        assert_eq!(judged.iter().map(named).collect::<Vec<_>>(), ["correct", "correct"], "{typed}");
    }
}

#[test]
fn of_a_speed_and_an_angle_each_has_its_own() {
    let of = |right: &str, quantity: &str| {
        let kind = quantity.ends_with("deg").then_some(Kind::Angle);
        let options = ModelOptions { kind, quantity: Some(quantity.parse().unwrap()), ..ModelOptions::default() };
        Model::read(right, &options).unwrap()
    };
    let models = [
        of("2*sqrt(13)", "A.after.speed"),
        of("atan(3/2)/deg", "A.after.angle_to_loc_deg"),
        of("6", "B.after.speed"),
        of("0", "B.after.angle_to_loc_deg"),
    ];
    // r for right, w for wrong, b for blank, p for a person.
    let each = |models: &[Model], typed: &str| -> String {
        let judged = judge_together(models, &read_answer(typed, &models[0].vocabulary));
        let letter = |judged: &Judgement| match judged.verdict {
            Verdict::Correct => 'r',
            Verdict::Partial => 'h',
            Verdict::Wrong => 'w',
            Verdict::Unreadable => 'p',
            Verdict::Blank => 'b',
        };
        judged.iter().map(letter).collect()
    };
    for (typed, expected) in [
        ("A: 7.21 at 56.3° to the line of centres, B: 6 along the line of centres", "rrrr"),
        ("7.21 at 56.3° to the line of centres, B 6", "rrrb"),
        ("56.3°, 7.21; B 6, 0°", "rrrr"),
        ("7.21, 56.3, 6, 0", "rrrr"),
        ("56.3°", "brbb"),
        ("7.21", "rbbb"),
        ("7.21 (v = 6)", "pppp"),
    ] {
        assert_eq!(each(&models, typed), expected, "{typed}");
    }
    let angles = [of("12.3", "alpha_deg"), of("65.4", "A.deflection_deg")];
    for (typed, expected) in [("12.3", "rb"), ("12.3, 65.4°", "rr"), ("12.3°, 65.4", "rr")] {
        assert_eq!(each(&angles, typed), expected, "{typed}");
    }
    let speeds = [of("2*sqrt(2)", "A.after.speed"), of("sqrt(41)", "B.after.speed")];
    for (typed, expected) in [("|v_A| = 2√2, |v_B| = √41", "rr"), ("v_A = 2√2, so |v_A| = 2√2; v_B = √41", "rr")]
    {
        assert_eq!(each(&speeds, typed), expected, "{typed}");
    }
}

#[test]
fn two_equations_are_rivals_where_one_is_offered_for_the_other() {
    let letters = ["u", "v", "w"].map(|name| crate::number::Letter::new(name, crate::number::Range::Real).unwrap());
    let options = ModelOptions { letters: letters.into(), ..ModelOptions::default() };
    let model = Model::read("2*v + 3*w = 4*u", &options).unwrap();
    for (typed, expected) in [
        ("2v + 3w = 4u or 2v - 3w = 4u", "wrong rival-answers"),
        ("2v + 3w = 4u or 4v + 6w = 8u", "correct"),
        ("2v + 3w = 4u, v - w = u", "partial several-answers"),
    ] {
        assert_eq!(named(&judge(&model, &read_answer(typed, &model.vocabulary))), expected, "{typed}");
    }
}
