//! Tests of each kind with readings made by hand: what a reader can hand over, and what it earns.

use super::tests::{expr, model, named, reading, said};
use super::*;
use crate::expr::print;
use crate::mark::reading::{Form, Notation, ReferenceLine, Said, SaidUnit, read_answer};
use ReferenceLine::{AlongCommonTangent, AlongLineOfCentres, CommonTangent, FromBToA, I, LineOfCentres};

fn unit(typed: &str, dimension: [i8; 4], scale: &str) -> Option<SaidUnit> {
    Some(SaidUnit { typed: typed.to_owned(), dimension, scale: expr(scale), degrees: typed == "°" })
}

fn degrees() -> Option<SaidUnit> {
    unit("°", [0, 0, 0, 1], "1")
}

fn radians() -> Option<SaidUnit> {
    unit("rad", [0, 0, 0, 1], "1")
}

fn value(text: &str) -> Said {
    said(Form::Value(expr(text)))
}

fn earns(model: &Model, label: Option<&str>, said: Vec<Said>) -> String {
    named(&judge(model, &Ok(vec![reading(label, said)])))
}

fn states(model: &Model, statements: &[(Option<&str>, Said)]) -> String {
    let parts = statements.iter().flat_map(|(label, said)| reading(*label, vec![said.clone()]).statements).collect();
    named(&judge(model, &Ok(vec![Reading { statements: parts, ..reading(None, Vec::new()) }])))
}

fn asked(text: &str, kind: Option<Kind>, quantity: &str) -> Model {
    Model { quantity: Some(quantity.parse().unwrap()), ..model(text, kind, "") }
}

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
fn a_vector_is_right_in_both_components_or_not_at_all() {
    let four = asked("4*i + j", None, "A.after.speed");
    let vector = |x: &str, y: &str, notation| said(Form::Vector(expr(x), expr(y), notation));
    use Notation::{Column, Coordinates, UnitVectors, Words};
    for (x, y, notation, expected) in [
        ("4", "1", UnitVectors, "correct"),
        ("4", "1", Column, "correct"),
        ("4", "1", Coordinates, "partial coordinates"),
        ("4.00", "1.00", UnitVectors, "correct"),
        ("1", "4", UnitVectors, "wrong components-exchanged"),
        ("-4", "-1", UnitVectors, "wrong sign"),
        ("4", "-1", UnitVectors, "wrong"),
        ("4", "0", Words, "wrong"),
        ("4", "1.009", UnitVectors, "partial near-miss"),
        ("4", "1.01", UnitVectors, "wrong"),
        ("x", "1", UnitVectors, "unreadable unknown-letter"),
    ] {
        assert_eq!(earns(&four, None, vec![vector(x, y, notation)]), expected, "{x}, {y} {notation:?}");
    }
    assert_eq!(earns(&four, None, vec![value("(8*i + 2*j)/2")]), "correct");
    assert_eq!(earns(&four, None, vec![value("4")]), "wrong scalar-for-vector");
    assert_eq!(earns(&four, None, vec![said(Form::Mixed(expr("4")))]), "wrong number-plus-vector");
    assert_eq!(earns(&four, None, vec![said(Form::AtRest)]), "wrong");
    let centimetres = Said { unit: unit("cm/s", [0, 1, -1, 0], "1/100"), ..vector("400", "100", UnitVectors) };
    assert_eq!(earns(&four, None, vec![centimetres]), "correct unit-converted");
    let rest = model("[0, 0]", None, "");
    assert_eq!(earns(&rest, None, vec![said(Form::AtRest)]), "correct");
    assert_eq!(earns(&rest, None, vec![value("0")]), "correct");
    let speed = asked("sqrt(2665)/16", None, "A.after.speed");
    assert_eq!(earns(&speed, None, vec![vector("-19/16", "3", UnitVectors)]), "partial magnitude-not-evaluated");
    assert_eq!(earns(&speed, None, vec![vector("-19/16", "2", UnitVectors)]), "wrong");
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

/// As students type it, through the reader.
#[test]
fn what_is_said_piece_by_piece_is_put_together() {
    const COMPONENTS: &str = "partial components-not-combined";
    let rows = [
        ("4*i + j", None, "4 in the i direction, 1 in the j direction", "correct"),
        ("4*i + j", None, "4 along i and 1 along j", "correct"),
        ("4*i + j", None, "i: 4, j: 1", "correct"),
        ("4*i + j", None, "j: 1, i: 4", "correct"),
        ("4*i + j", None, "4i, j", "partial coordinates"),
        ("4*i + j", None, "4 right, 1 up", "partial coordinates"),
        ("4*i + j", None, "1, 4", "wrong components-exchanged"),
        ("4*i + j", None, "4i, 2j", "wrong"),
        ("2/3", Some(Kind::Ratio), "2 to 3", "correct"),
        ("2/3", Some(Kind::Ratio), "2 or 3", "wrong"),
        ("2/3", Some(Kind::Ratio), "2, alternatively 3", "wrong"),
        ("4*i + j", None, "4i or j", "wrong"),
        ("4*i + j", None, "4 or 1", "wrong scalar-for-vector"),
        ("2/3", Some(Kind::Ratio), "3 to 2", "wrong inverted"),
        ("2/3", Some(Kind::Ratio), "2 to 3 to 4", "wrong"),
        ("2/3", Some(Kind::Ratio), "mA:mB = 2:3", "correct"),
        ("2/3", Some(Kind::Ratio), "m_A/m_B = 2/3", "correct"),
        ("2/3", Some(Kind::Ratio), "mB:mA = 2:3", "unreadable ratio-unchecked"),
        ("2/3", Some(Kind::Ratio), "mB/mA = 2/3", "unreadable ratio-unchecked"),
        ("2/3", Some(Kind::Ratio), "mB:mA = 3:2", "unreadable ratio-unchecked"),
        ("2/3", Some(Kind::Ratio), "mA:mB = 3:2", "unreadable ratio-unchecked"),
        ("2/3", Some(Kind::Ratio), "mB:mA = 3:5", "wrong"),
        ("2/3", Some(Kind::Ratio), "2∶3", "correct"),
        ("2/3", Some(Kind::Ratio), "A to B is 2 to 3", "correct"),
        ("2/3", Some(Kind::Ratio), "B to A is 2 to 3", "unreadable ratio-unchecked"),
        ("2*i - j", Some(Kind::Line), "perpendicular to i + 2j", "correct"),
        ("2*i - j", Some(Kind::Line), "direction perpendicular to i + 2j", "correct"),
        ("2*i - j", Some(Kind::Line), "perpendicular to 2i - j", "unreadable cannot-be-compared"),
        ("2*i - j", Some(Kind::Line), "direction perpendicular to 2i - j", "unreadable cannot-be-compared"),
        ("2*i - j", Some(Kind::Line), "x + 2y = 0", "correct"),
        ("2*i - j", Some(Kind::Line), "2x + y = 0", "wrong"),
        ("2*i - j", Some(Kind::Line), "y = -0.5x + c", "correct"),
        ("2*i - j", Some(Kind::Line), "λ(2i - j)", "correct"),
        ("2*i - j", Some(Kind::Line), "±(2i - j)", "correct"),
        ("2*i - j", Some(Kind::Line), "k(2i + j)", "wrong"),
        ("2*i - j", Some(Kind::Vector), "λ(2i - j)", "wrong"),
        ("4*i + j", None, "v_x = 4, v_y = 1", "partial coordinates"),
        ("4*i + j", None, "x = 4, y = 1", "partial coordinates"),
        ("4*i + j", None, "vy = 1 and vx = 4", "partial coordinates"),
        ("4*i + j", None, "v_x = 1, v_y = 4", "wrong components-exchanged"),
        ("4*i + j", None, "v_x = 4, v_x = 1", "wrong scalar-for-vector"),
        ("4*i + j", None, "v_i = 4, v_j = 1", "correct"),
        ("4*i + j", None, "i component 4, j component 1", "correct"),
        ("4*i + j", None, "x component 4 and y component 1", "partial coordinates"),
        ("4*i + j", None, "velocity 4 along i and 1 along j", "correct"),
        ("4*i + j", None, "velocity of A is 4 along i and 1 along j", "correct"),
        ("4*i + j", None, "(4 1)^T", "correct"),
        ("4*i + j", None, "(4, 1)^T", "correct"),
        ("4*i + j", None, r"[4, 1]^{\top}", "correct"),
        ("4*i + j", None, "(4, 1)", "partial coordinates"),
        ("4*sqrt(39)/9", None, "v² = 208/27", "partial square-not-rooted"),
        ("4*sqrt(39)/9", None, "v^2 = 7.70 = 2.78", "correct"),
        ("4*sqrt(39)/9", None, "v² = 7.80", "wrong"),
        ("2/3", None, "e² = 4/9", "partial square-not-rooted"),
        ("u*sqrt(1-e^2)", None, "v² = u²(1 - e²)", "partial square-not-rooted"),
        (
            "[5/2, 3*sqrt(3)/2]",
            Some(Kind::Velocity),
            "2.5 along the line of centres and 2.60 perpendicular to it",
            COMPONENTS,
        ),
        ("[5/2, 3*sqrt(3)/2]", Some(Kind::Velocity), "2.5 along LOC or 2.60 perpendicular to LOC", "wrong"),
        ("[5/2, 3*sqrt(3)/2]", Some(Kind::Velocity), "3√3/2 perp, 5/2 along LOC", COMPONENTS),
        ("[5/2, 3*sqrt(3)/2]", Some(Kind::Velocity), "2.5 along and 2.60 perpendicular", COMPONENTS),
        ("[5/2, 3*sqrt(3)/2]", Some(Kind::Velocity), "3 along LOC and 2 perpendicular to LOC", "wrong"),
        ("[5/2, 3*sqrt(3)/2]", Some(Kind::Velocity), "3.61 m/s, tan θ = 3√3/5", "partial angle-not-evaluated"),
        ("[5/2, 3*sqrt(3)/2]", Some(Kind::Velocity), "3.61 m/s, tan θ = 5/(3√3)", "wrong direction-wrong"),
        ("[5/2, 3*sqrt(3)/2]", Some(Kind::Velocity), "3.61 in direction 46.1° to the line of centres", "correct"),
        ("1/3 < e <= 1", None, "e is greater than 1/3", "correct"),
        ("1/3 < e <= 1", None, "e is at least 1/3", "partial range-end"),
        ("1/3 < e <= 1", None, "e is less than 1/3", "wrong range-turned"),
    ];
    for (right, kind, typed, expected) in rows {
        let model = Model::read(right, &ModelOptions { kind, ..ModelOptions::default() }).unwrap();
        let judged = judge(&model, &read_answer(typed, &model.vocabulary));
        assert_eq!(named(&judged), expected, "{right}: {typed}");
    }
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
fn a_velocity_needs_its_size_and_its_direction() {
    let across = model("6*sin(10*deg) perpendicular to the line of centres", Some(Kind::Velocity), "");
    let oblique = model("[5/2, 3*sqrt(3)/2]", Some(Kind::Velocity), "");
    let size = model("6*sin(10*deg)", Some(Kind::Velocity), "");
    let towards = |text: &str, reference| Said { reference, ..value(text) };
    let angle = |text: &str, reference| Said { reference, unit: degrees(), ..value(text) };
    for (model, said, expected) in [
        (&across, vec![towards("1.04", Some(AlongCommonTangent))], "correct"),
        (&across, vec![towards("1.04", Some(AlongLineOfCentres))], "wrong direction-wrong"),
        (&across, vec![towards("1.04", None)], "partial direction-missing"),
        (&across, vec![towards("1.0", Some(AlongCommonTangent))], "partial under-accurate"),
        (&across, vec![towards("5.91", Some(AlongCommonTangent))], "wrong"),
        (&across, vec![towards("0", None)], "wrong"),
        (&across, vec![said(Form::AtRest)], "wrong"),
        (&across, vec![value("1.04"), angle("90", Some(LineOfCentres))], "correct"),
        (&oblique, vec![value("sqrt(13)"), angle("46.1", None)], "correct"),
        (&oblique, vec![value("3.61"), angle("46.1", Some(LineOfCentres))], "correct"),
        (&oblique, vec![value("3.61"), angle("43.9", Some(CommonTangent))], "correct"),
        (&oblique, vec![value("3.61"), angle("43.9", None)], "wrong complement"),
        (&oblique, vec![value("3.61"), value("46.1")], "correct"),
        (&oblique, vec![said(Form::Vector(expr("2.5"), expr("2.598"), Notation::Column))], "correct"),
        (&size, vec![towards("1.04", Some(AlongCommonTangent))], "partial direction-unchecked"),
        (&size, vec![towards("1.04", None)], "partial direction-missing"),
        (&size, vec![towards("1.4", None)], "wrong"),
    ] {
        let statements: Vec<_> = said.into_iter().map(|said| (None, said)).collect();
        assert_eq!(states(model, &statements), expected, "{statements:?}");
    }
}

#[test]
fn ratios_and_lines_have_no_scale() {
    let ratio = |a: &str, b: &str| said(Form::Ratio(expr(a), expr(b)));
    for right in ["2/3", "[2, 3]", "[4, 6]"] {
        let right = model(right, Some(Kind::Ratio), "");
        for (said, expected) in [
            (ratio("2", "3"), "correct"),
            (ratio("4", "6"), "correct"),
            (ratio("2*m", "3*m"), "wrong unknown-letter"),
            (value("2/3"), "correct"),
            (ratio("1", "1.5"), "correct"),
            (ratio("0.667", "1"), "correct"),
            (ratio("3", "2"), "wrong inverted"),
            (ratio("2", "0"), "wrong"),
            (ratio("2", "5"), "wrong"),
        ] {
            assert_eq!(earns(&right, None, vec![said.clone()]), expected, "{said:?}");
        }
    }
    let line = model("i - 3*j", Some(Kind::Line), "");
    let along = |x: &str, y: &str| said(Form::Vector(expr(x), expr(y), Notation::UnitVectors));
    for (said, expected) in [
        (along("1", "-3"), "correct"),
        (along("-1", "3"), "correct"),
        (along("1/sqrt(10)", "-3/sqrt(10)"), "correct"),
        (along("0.316", "-0.949"), "correct"),
        (along("2", "-6"), "correct"),
        (along("0", "0"), "wrong"),
        (along("3", "-1"), "wrong components-exchanged"),
        (along("-3", "1"), "wrong components-exchanged"),
        (along("1", "3"), "wrong"),
        (said(Form::Gradient(expr("-3"))), "correct"),
        (said(Form::Gradient(expr("3"))), "wrong"),
        (value("-3"), "partial gradient-unstated"),
        (said(Form::AtRest), "wrong"),
        (said(Form::Direction), "unreadable cannot-be-compared"),
    ] {
        assert_eq!(earns(&line, None, vec![said.clone()]), expected, "{said:?}");
    }
}

#[test]
fn a_unit_is_read_converted_condoned_or_flagged() {
    let joules = asked("48/25", None, "ke.lost");
    let impulse = asked("4/3 + 11*sqrt(2)/9", None, "impulse.magnitude");
    let fraction = asked("10/43", None, "ke.fraction_lost");
    let with = |text: &str, unit| Said { unit, ..value(text) };
    for (model, said, expected) in [
        (&joules, with("1.92", None), "correct"),
        (&joules, with("1.92", unit("J", [1, 2, -2, 0], "1")), "correct"),
        (&joules, with("1920", unit("mJ", [1, 2, -2, 0], "1/1000")), "correct unit-converted"),
        (&joules, with("0.00192", unit("kJ", [1, 2, -2, 0], "1000")), "correct unit-converted"),
        (&joules, with("1.92", unit("kJ", [1, 2, -2, 0], "1000")), "partial unit-wrong"),
        (&joules, with("1.92", unit("N", [1, 1, -2, 0], "1")), "partial unit-wrong"),
        (&joules, with("3.84", unit("J", [1, 2, -2, 0], "1")), "wrong"),
        (&impulse, with("3.06", unit("N/s", [1, 1, -3, 0], "1")), "correct unit-condoned"),
        (&impulse, with("3.06", unit("kg m/s", [1, 1, -1, 0], "1")), "correct"),
        (&fraction, with("10/43", unit("J", [1, 2, -2, 0], "1")), "partial unit-not-needed"),
        (&fraction, said(Form::Percentage(expr("23.3"))), "correct"),
        (&fraction, said(Form::Percentage(expr("23"))), "partial under-accurate"),
        (&fraction, said(Form::Percentage(expr("0.233"))), "wrong"),
        (&fraction, said(Form::Ratio(expr("10"), expr("43"))), "partial ratio-for-number"),
    ] {
        assert_eq!(earns(model, None, vec![said.clone()]), expected, "{said:?}");
    }
}

#[test]
fn a_sign_is_lost_unless_it_is_said_to_be_a_change() {
    let joules = asked("48/25", None, "ke.lost");
    assert_eq!(earns(&joules, Some("ΔKE"), vec![value("-1.92")]), "correct change-not-loss");
    assert_eq!(earns(&joules, Some("KE lost"), vec![value("-1.92")]), "partial sign");
    let component = asked("48/25", None, "A.after.n");
    assert_eq!(earns(&component, None, vec![value("-1.92")]), "wrong sign");
    let mass = asked("9*m", None, "ke.lost");
    for (text, expected) in [("9", "partial letter-missing"), ("-9*m", "partial sign"), ("9*v", "wrong unknown-letter")]
    {
        assert_eq!(earns(&mass, None, vec![value(text)]), expected, "{text}");
    }
    let sixth = model("v/6", None, "awrt 3sf");
    for (text, expected) in [
        ("0.167*v", "correct"),
        ("0.17*v", "partial under-accurate"),
        ("0.166*v", "partial truncated"),
        ("0.2*v", "wrong too-few-figures"),
        ("0.167", "partial letter-missing"),
        ("5*v/6", "wrong"),
    ] {
        assert_eq!(earns(&sixth, None, vec![value(text)]), expected, "{text}");
    }
    let long = model("u*(sqrt(3)*cos(alpha) + e*sin(alpha)/3)", None, "awrt 3sf");
    assert_eq!(earns(&long, None, vec![value("u*(1.73*cos(alpha) + 0.333*e*sin(alpha))")]), "correct");
    assert_eq!(earns(&long, None, vec![value("u*(1.73*cos(alpha) + 0.433*e*sin(alpha))")]), "wrong");
}

#[test]
fn a_tangent_may_be_told_by_its_angle() {
    let tangent = asked("3*sqrt(3)/7", None, "A.tan_deflection");
    let angle = |text: &str| Said { unit: degrees(), ..value(text) };
    assert_eq!(earns(&tangent, Some("theta"), vec![angle("36.6")]), "correct angle-for-tangent");
    assert_eq!(earns(&tangent, None, vec![value("atan(3*sqrt(3)/7)")]), "correct angle-for-tangent");
    assert_eq!(earns(&tangent, None, vec![value("36.58677555")]), "partial angle-for-tangent");
    assert_eq!(earns(&tangent, None, vec![angle("96.6")]), "wrong");
    assert_eq!(earns(&tangent, None, vec![value("3*sqrt(3)")]), "unreadable broken-off");
    assert_eq!(earns(&tangent, Some("tan(theta)"), vec![value("9/(7*sqrt(3))")]), "correct");
    let speed = asked("1", None, "A.after.speed");
    assert_eq!(earns(&speed, None, vec![angle("45")]), "wrong");
}

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
    assert_eq!(earns(&speed, None, vec![with(value("3"), "is not it")]), "wrong too-few-figures");
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
    assert_eq!(together(&[(Some("speed of A"), "1")]), ["correct", "blank blank"]);
    assert_eq!(together(&[(None, "1")]), ["correct", "blank blank"]);
}

#[test]
fn a_printed_result_is_never_earned_by_its_last_line() {
    let shown = model("tan(beta) = 2*tan(alpha)/(1-e)", Some(Kind::Shown), "");
    let shown = Model {
        vocabulary: Vocabulary {
            letters: [
                shown.vocabulary.letters.clone(),
                vec![crate::number::Letter::new("u", crate::number::Range::Positive).unwrap()],
            ]
            .concat(),
            ..shown.vocabulary.clone()
        },
        ..shown
    };
    let steps =
        |label: &str, texts: &[&str]| earns(&shown, Some(label), texts.iter().map(|text| value(text)).collect());
    assert_eq!(steps("tan(beta)", &["2*tan(alpha)/(1-e)"]), "wrong restated");
    assert_eq!(steps("tan(beta)", &["2*tan(alpha)/(1-e)", "2*tan(alpha)/(1-e)"]), "wrong restated");
    let derived = "u*sin(alpha)/(1/2*u*cos(alpha)*(1-e))";
    assert_eq!(steps("tan(beta)", &[derived, "2*tan(alpha)/(1-e)"]), "partial working-not-judged");
    assert_eq!(steps("(1-e)*tan(beta)", &["2*tan(alpha)"]), "partial not-as-printed");
    assert_eq!(steps("tan(beta)", &["2*tan(alpha)", "2*tan(alpha)/(1-e)"]), "wrong working-not-judged");
    assert_eq!(steps("tan(beta)", &["2*tan(alpha)/(1+e)"]), "wrong working-not-judged");
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
fn a_model_fits_its_kind_or_is_refused() {
    for (text, kind) in [
        ("4*i + j", Kind::Vector),
        ("[4, 1]", Kind::Vector),
        ("2.5", Kind::Number),
        ("6*sin(10*deg)", Kind::Number),
        ("u*sin(alpha)", Kind::Expression),
        ("atan(7)/deg", Kind::Angle),
        ("30 deg", Kind::Angle),
        ("2*pi/3", Kind::Number),
        ("v = 2*u", Kind::Equation),
    ] {
        assert_eq!(model(text, None, "").kind, kind, "{text}");
    }
    let of = |kind| ModelOptions { kind: Some(kind), ..ModelOptions::default() };
    for (text, kind) in [
        ("4", Kind::Vector),
        ("v = 2*u", Kind::Number),
        ("2*u", Kind::Equation),
        ("4*i", Kind::Angle),
        ("sqrt(-1)", Kind::Number),
        ("1/0", Kind::Number),
        ("", Kind::Number),
        ("sin(10)", Kind::Number),
    ] {
        assert!(Model::read(text, &of(kind)).is_err(), "{text} as {}", kind.name());
    }
}

#[test]
fn every_model_accepts_what_carom_prints_of_it() {
    for text in ["4*sqrt(39)/9", "10/43", "7*sqrt(2)/9 + 77/54", "sqrt(61)*v/6", "u*cos(alpha)*(1-e)/2", "48/25"] {
        let model = model(text, None, "");
        assert_eq!(tests::on(&model, text), "correct");
        assert_eq!(tests::on(&model, &print::plain(&model.value)), "correct");
    }
}

#[test]
fn notes_have_tags_in_kebab_case_and_sentences() {
    let mut tags: Vec<&str> = Note::ALL.iter().map(|note| note.tag()).collect();
    for note in Note::ALL {
        let tag = note.tag();
        assert!(tag.chars().all(|letter| letter.is_ascii_lowercase() || letter == '-'), "{tag}");
        assert!(note.sentence().ends_with('.'), "{tag}");
    }
    tags.sort_unstable();
    tags.dedup();
    assert_eq!(tags.len(), Note::ALL.len());
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
