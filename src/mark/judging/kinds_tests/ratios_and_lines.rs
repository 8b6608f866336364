//! Ratios and lines, which have no scale; and ranges.

use super::*;

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
fn a_ratio_is_told_by_its_terms_and_what_they_are_of() {
    fare(&[
        ("2/3", Some(Kind::Ratio), "2 to 3", "correct"),
        ("2/3", Some(Kind::Ratio), "2 or 3", "wrong"),
        ("2/3", Some(Kind::Ratio), "2, alternatively 3", "wrong"),
        ("2/3", Some(Kind::Ratio), "3 to 2", "wrong inverted"),
        ("2/3", Some(Kind::Ratio), "2 to 3 to 4", "wrong"),
        ("2/3", Some(Kind::Ratio), "mA:mB = 2:3", "correct"),
        ("2/3", Some(Kind::Ratio), "m_A/m_B = 2/3", "correct"),
        ("2/3", Some(Kind::Ratio), "mB:mA = 2:3", "unreadable ratio-unchecked"),
        ("2/3", Some(Kind::Ratio), "mB/mA = 2/3", "unreadable ratio-unchecked"),
        ("2/3", Some(Kind::Ratio), "mB:mA = 3:2", "unreadable ratio-unchecked"),
        ("2/3", Some(Kind::Ratio), "mA:mB = 3:2", "unreadable ratio-unchecked"),
        ("2/3", Some(Kind::Ratio), "mB:mA = 3:5", "wrong"),
        ("2/3", Some(Kind::Ratio), "m_A = 2, m_B = 3", "correct"),
        ("2/3", Some(Kind::Ratio), "B = 3, A = 2", "correct"),
        ("2/3", Some(Kind::Ratio), "A = 3, B = 2", "unreadable ratio-unchecked"),
        ("2/3", Some(Kind::Ratio), "2∶3", "correct"),
        ("2/3", Some(Kind::Ratio), "A to B is 2 to 3", "correct"),
        ("2/3", Some(Kind::Ratio), "B to A is 2 to 3", "unreadable ratio-unchecked"),
    ]);
}

#[test]
fn a_line_is_told_by_any_vector_along_it_and_by_its_equation() {
    fare(&[
        ("2*i - j", Some(Kind::Line), "perpendicular to i + 2j", "correct"),
        ("2*i - j", Some(Kind::Line), "direction perpendicular to i + 2j", "correct"),
        ("2*i - j", Some(Kind::Line), "perpendicular to 2i - j", "unreadable cannot-be-compared"),
        ("2*i - j", Some(Kind::Line), "direction perpendicular to 2i - j", "unreadable cannot-be-compared"),
        ("2*i - j", Some(Kind::Line), "x + 2y = 0", "correct"),
        ("2*i - j", Some(Kind::Line), "2x + y = 0", "wrong"),
        ("2*i - j", Some(Kind::Line), "x = 2, y = -1", "correct"),
        ("2*i - j", Some(Kind::Line), "x: 4, y: -2", "correct"),
        ("2*i - j", Some(Kind::Line), "i = 2, j = -1", "correct"),
        ("2*i - j", Some(Kind::Line), "x = 2, y = -1/2", "wrong"),
        ("2*i - j", Some(Kind::Line), "y = -0.5x + c", "correct"),
        ("2*i - j", Some(Kind::Line), "λ(2i - j)", "correct"),
        ("2*i - j", Some(Kind::Line), "±(2i - j)", "correct"),
        ("2*i - j", Some(Kind::Line), "k(2i + j)", "wrong"),
        ("2*i - j", Some(Kind::Vector), "λ(2i - j)", "wrong"),
    ]);
}

#[test]
fn a_range_is_told_in_words() {
    fare(&[
        ("1/3 < e <= 1", None, "e is greater than 1/3", "correct"),
        ("1/3 < e <= 1", None, "e is at least 1/3", "partial range-end"),
        ("1/3 < e <= 1", None, "e is less than 1/3", "wrong range-turned"),
    ]);
}
