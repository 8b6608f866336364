//! Numbers and expressions: their units, signs and squares.

use super::*;

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
    let energy = asked("10*m*u^2*(1-e^2)", None, "ke.lost");
    for (text, expected) in [
        ("10*m*(1-e^2)", "wrong powers-of-letters"),
        ("10*(1-e^2)", "wrong powers-of-letters"),
        ("10*m*u*(1-e^2)", "wrong powers-of-letters"),
        ("10*m^2*u^2*(1-e^2)", "wrong powers-of-letters"),
        ("10*u^2*(1-e^2)", "partial letter-missing"),
        ("5*m*(1-e^2)", "wrong"),
        ("10*m*u^2*(1-e)", "wrong"),
    ] {
        assert_eq!(earns(&energy, None, vec![value(text)]), expected, "{text}");
    }
    let long = model("u*(sqrt(3)*cos(alpha) + e*sin(alpha)/3)", None, "awrt 3sf");
    assert_eq!(earns(&long, None, vec![value("u*(1.73*cos(alpha) + 0.333*e*sin(alpha))")]), "correct");
    assert_eq!(earns(&long, None, vec![value("u*(1.73*cos(alpha) + 0.433*e*sin(alpha))")]), "wrong");
}

#[test]
fn a_square_is_not_its_root() {
    fare(&[
        ("4*sqrt(39)/9", None, "v² = 208/27", "partial square-not-rooted"),
        ("4*sqrt(39)/9", None, "v^2 = 7.70 = 2.78", "correct"),
        ("4*sqrt(39)/9", None, "v² = 7.80", "wrong"),
        ("2/3", None, "e² = 4/9", "partial square-not-rooted"),
        ("u*sqrt(1-e^2)", None, "v² = u²(1 - e²)", "partial square-not-rooted"),
    ]);
}
