//! Angles: from which line, in which sense and unit, and a tangent for one.

use super::*;

#[test]
fn an_angle_has_a_line_a_sense_and_a_unit() {
    let mut model = asked("atan(3*sqrt(3)/5)/deg", None, "A.after.angle_to_loc_deg");
    assert_eq!(model.kind, Kind::Angle);
    model.rebounds = Some(false);
    let rows: &[(&str, Option<SaidUnit>, Option<ReferenceLine>, &str)] = &[
        ("46.1", None, None, "correct"),
        ("46.1", degrees(), Some(LineOfCentres), "correct"),
        ("46.10211", None, None, "correct"),
        ("46", degrees(), None, "partial under-accurate"),
        ("50", degrees(), None, "wrong too-few-figures"),
        ("43.9", degrees(), Some(CommonTangent), "correct"),
        ("43.9", degrees(), None, "wrong complement"),
        ("43.9", degrees(), Some(LineOfCentres), "wrong complement"),
        ("46.1", degrees(), Some(CommonTangent), "wrong reference-wrong"),
        ("133.9", degrees(), Some(FromBToA), "correct"),
        ("133.9", degrees(), None, "wrong supplement"),
        ("46.1", degrees(), Some(I), "partial reference-unchecked"),
        ("16.1", degrees(), None, "wrong"),
        ("0.805", radians(), Some(LineOfCentres), "correct"),
        ("0.805", None, None, "partial radians-unstated"),
        ("0.80", radians(), None, "partial under-accurate"),
        ("atan(3*sqrt(3)/5)", None, None, "correct"),
        ("90 deg - atan(5/(3*sqrt(3)))", None, None, "correct"),
        ("atan(1.04)", None, None, "correct"),
        ("atan(1.0)", None, None, "wrong"),
        ("atan(5/(3*sqrt(3)))", None, None, "wrong complement"),
        ("-46.1", None, None, "wrong sign"),
        ("46.2", degrees(), None, "partial near-miss"),
    ];
    for (text, unit, reference, expected) in rows {
        let said = Said { unit: unit.clone(), reference: *reference, ..value(text) };
        assert_eq!(earns(&model, None, vec![said]), *expected, "{text} {unit:?} {reference:?}");
    }
    assert_eq!(earns(&model, Some("tan(theta)"), vec![value("3*sqrt(3)/5")]), "partial angle-not-evaluated");
    assert_eq!(earns(&model, Some("tan(theta)"), vec![value("5/3")]), "wrong");
    assert_eq!(earns(&model, Some("cos(theta)"), vec![value("5/sqrt(52)")]), "partial angle-not-evaluated");
    assert_eq!(earns(&model, None, vec![value("atan(3*sqrt(3)/5)"), value("46.2")]), "correct");
    let straight = asked("0", Some(Kind::Angle), "B.after.angle_to_loc_deg");
    let along = Said { reference: Some(AlongLineOfCentres), ..said(Form::Direction) };
    assert_eq!(earns(&straight, None, vec![along.clone()]), "correct");
    assert_eq!(earns(&model, None, vec![along]), "wrong");
    let whole = tests::model("atan(7)", Some(Kind::Angle), "nearest degree");
    assert_eq!(earns(&whole, None, vec![value("82")]), "correct");
    assert_eq!(earns(&whole, None, vec![value("81.9")]), "correct");
    assert_eq!(earns(&whole, None, vec![value("81")]), "partial truncated");
}

#[test]
fn an_angle_with_a_wall_may_be_told_from_the_perpendicular_and_one_with_i_from_j() {
    let rows = [
        ("A.after.angle_to_wall_deg", "16.1", None, "correct"),
        ("A.after.angle_to_wall_deg", "16.1", Some(CommonTangent), "correct"),
        ("A.after.angle_to_wall_deg", "73.9", Some(LineOfCentres), "correct"),
        ("A.after.angle_to_wall_deg", "73.9", None, "wrong complement"),
        ("A.after.angle_to_wall_deg", "16.1", Some(LineOfCentres), "wrong reference-wrong"),
        ("impulse.angle_to_i_deg", "16.1", Some(I), "correct"),
        ("impulse.angle_to_i_deg", "73.9", Some(ReferenceLine::J), "correct"),
        ("impulse.angle_to_i_deg", "73.9", Some(I), "wrong complement"),
        ("A.deflection_deg", "73.9", None, "wrong"),
        ("A.deflection_deg", "163.9", None, "wrong supplement"),
    ];
    for (quantity, typed, reference, expected) in rows {
        let model = asked("atan(sqrt(3)/6)/deg", None, quantity);
        let angle = Said { reference, unit: degrees(), ..value(typed) };
        assert_eq!(earns(&model, None, vec![angle]), expected, "{quantity}: {typed} {reference:?}");
    }
}

#[test]
fn an_angle_in_words_lies_along_its_own_line_or_across_it() {
    let rows = [
        ("A.after.angle_to_loc_deg", "0", AlongLineOfCentres, "correct"),
        ("A.after.angle_to_loc_deg", "90", AlongCommonTangent, "correct"),
        ("A.after.angle_to_loc_deg", "0", AlongCommonTangent, "wrong"),
        ("A.after.angle_to_wall_deg", "0", AlongCommonTangent, "correct"),
        ("A.after.angle_to_wall_deg", "90", AlongLineOfCentres, "correct"),
        ("A.after.angle_to_wall_deg", "0", AlongLineOfCentres, "wrong"),
        ("A.after.angle_to_wall_deg", "90", AlongCommonTangent, "wrong"),
        ("impulse.angle_to_i_deg", "0", AlongLineOfCentres, "unreadable cannot-be-compared"),
        ("A.after.angle_from_i_deg", "90", AlongCommonTangent, "unreadable cannot-be-compared"),
        ("A.deflection_deg", "0", AlongLineOfCentres, "unreadable cannot-be-compared"),
        ("A.deflection_deg", "90", AlongCommonTangent, "unreadable cannot-be-compared"),
    ];
    for (quantity, right, words, expected) in rows {
        let model = asked(right, Some(Kind::Angle), quantity);
        let told = Said { reference: Some(words), ..said(Form::Direction) };
        assert_eq!(earns(&model, None, vec![told]), expected, "{quantity} {right}: {words:?}");
    }
    // As students write it.
    for (right, words) in [("0", "parallel to the wall"), ("90", "perpendicular to the wall")] {
        let model = asked(right, Some(Kind::Angle), "A.after.angle_to_wall_deg");
        assert_eq!(named(&judge(&model, &read_answer(words, &model.vocabulary))), "correct", "{words}");
    }
}

#[test]
fn an_angle_from_b_to_a_depends_on_the_sense_of_the_motion() {
    let rows = [
        (Some(false), "133.9", "correct"),
        (Some(false), "46.1", "wrong supplement"),
        (Some(true), "133.9", "wrong supplement"),
        (Some(true), "46.1", "correct"),
        (None, "133.9", "unreadable reference-unchecked"),
        (None, "46.1", "unreadable reference-unchecked"),
        (None, "30", "wrong"),
    ];
    for (rebounds, answer, expected) in rows {
        let mut model = asked("atan(3*sqrt(3)/5)", Some(Kind::Angle), "A.after.angle_to_loc_deg");
        model.rebounds = rebounds;
        let said = Said { reference: Some(FromBToA), ..said(Form::Value(expr(answer))) };
        assert_eq!(named(&judge(&model, &Ok(vec![reading(None, vec![said])]))), expected, "{answer}, {rebounds:?}");
    }
}

#[test]
fn a_tangent_may_be_told_by_its_angle() {
    let tangent = asked("3*sqrt(3)/7", None, "A.tan_deflection");
    let angle = |text: &str| Said { unit: degrees(), ..value(text) };
    assert_eq!(earns(&tangent, Some("theta"), vec![angle("36.6")]), "correct angle-for-tangent");
    assert_eq!(earns(&tangent, None, vec![value("atan(3*sqrt(3)/7)")]), "correct angle-for-tangent");
    assert_eq!(earns(&tangent, None, vec![value("36.58677555")]), "partial angle-for-tangent");
    // The tangent is no angle.
    assert_eq!(earns(&tangent, Some("tan(theta)"), vec![value("atan(3*sqrt(3)/7)")]), "partial angle-for-tangent");
    let chain = vec![value("atan(3*sqrt(3)/7)"), angle("36.6")];
    assert_eq!(earns(&tangent, Some("tan(theta)"), chain), "partial angle-for-tangent");
    assert_eq!(earns(&tangent, None, vec![angle("96.6")]), "wrong");
    assert_eq!(earns(&tangent, None, vec![value("3*sqrt(3)")]), "unreadable broken-off");
    assert_eq!(earns(&tangent, Some("tan(theta)"), vec![value("9/(7*sqrt(3))")]), "correct");
    let speed = asked("1", None, "A.after.speed");
    assert_eq!(earns(&speed, None, vec![angle("45")]), "wrong");
}

#[test]
fn an_obtuse_angle_is_less_than_two_right_angles_by_what_is_long_to_work_out() {
    for (text, degrees) in [
        ("180 - atan(sin(25*deg)/(2*cos(25*deg) - 1))/deg", "153"),
        ("90 - atan(sin(25*deg)/(2*cos(25*deg) - 1))/deg", "62.5"),
        ("atan(sin(25*deg)/(2*cos(25*deg) - 1))/deg - 10", "17.5"),
    ] {
        let model = model(text, None, "awrt 3sf");
        assert_eq!(earns(&model, None, vec![value(degrees)]), "correct", "{text}");
        assert_eq!(earns(&model, None, vec![value("31.4")]), "wrong", "{text}");
    }
}

#[test]
fn an_angle_with_a_root_of_a_letter_is_compared_however_long_its_numbers_are() {
    for (text, own) in [
        ("atan(sqrt(10*(9 - e))/10)/deg", "arctan(√((9 − e)/10))"),
        ("atan(sqrt(10*(9 - e))/10)/deg", "tan⁻¹(√(90 − 10e)/10)"),
        ("atan(sqrt(35*(29 - 4*e))/35)/deg", "arctan(√((29 − 4e)/35))"),
    ] {
        let letters = vec![crate::number::Letter::new("e", crate::number::Range::Unit).unwrap()];
        let options = ModelOptions { letters, kind: Some(Kind::Angle), ..ModelOptions::default() };
        let model = Model::read(text, &options).unwrap();
        assert_eq!(named(&judge(&model, &read_answer(own, &model.vocabulary))), "correct", "{own}");
        assert_eq!(named(&judge(&model, &read_answer("arctan(√((9 + e)/10))", &model.vocabulary))), "wrong", "{own}");
    }
}

#[test]
fn an_angle_with_roots_of_sines_is_worked_out() {
    for (text, degrees) in [
        ("atan(sqrt(49*tan(40*deg)^2 - 15)/8)", "28.9"),
        ("asin(sqrt(15*cos(40*deg) - 1)/8)", "23.9"),
        ("acos(sqrt(1 - 4*sin(35*deg)^2/9))", "22.5"),
        ("atan(sqrt(2)*tan(40*deg)/sqrt(3*tan(40*deg) - 1))", "43.9"),
        // Too long to be worked out exactly.
        ("atan(sqrt(1 + sqrt(2 + sqrt(3 + tan(40*deg)))))", "60.0"),
    ] {
        let model = model(&format!("{text}/deg"), None, "awrt 3sf");
        assert_eq!(earns(&model, None, vec![value(degrees)]), "correct", "{text}");
        assert_eq!(earns(&model, None, vec![value("31.4")]), "wrong", "{text}");
        // The angle as a student writes it has no degree under a line.
        let own = format!("arc{}", text[1..].replace("*deg", "°"));
        let readings = read_answer(&own, &model.vocabulary);
        assert_eq!(named(&judge(&model, &readings)), "correct", "{own}");
    }
}
