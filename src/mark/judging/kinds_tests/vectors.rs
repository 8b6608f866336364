//! Vectors: their components, and how they are written.

use super::*;

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
fn a_vector_said_piece_by_piece_is_put_together() {
    fare(&[
        ("4*i + j", None, "4 in the i direction, 1 in the j direction", "correct"),
        ("4*i + j", None, "4 along i and 1 along j", "correct"),
        ("4*i + j", None, "i: 4, j: 1", "correct"),
        ("4*i + j", None, "j: 1, i: 4", "correct"),
        ("4*i + j", None, "i = 4, j = 1", "correct"),
        ("4*i + j", None, "i=4 j=1", "correct"),
        ("4*i + j", None, "i = 1, j = 4", "wrong components-exchanged"),
        ("4*i + j", None, "i = 4", "wrong scalar-for-vector"),
        ("4*i + j", None, "i: 3 + 1 = 4, j: 1", "correct"),
        ("4*i + j", None, "x: 3 + 1 = 4, y: 2 - 1 = 1", "partial coordinates"),
        ("4*i + j", None, "x: 3 + 1 = 5, y: 1", "wrong"),
        ("4*i + j", None, "x-component 4, y-component 1", "partial coordinates"),
        ("4*i + j", None, "2x = 8, y = 1", "unreadable cannot-be-compared"),
        ("4*i + j", None, "x - 4 = 0, y - 1 = 0", "unreadable cannot-be-compared"),
        ("4*i + j", None, "4i, j", "partial coordinates"),
        ("4*i + j", None, "4 right, 1 up", "partial coordinates"),
        ("4*i + j", None, "1, 4", "wrong components-exchanged"),
        ("4*i + j", None, "4i, 2j", "wrong"),
        ("4*i + j", None, "4i or j", "wrong"),
        ("4*i + j", None, "4 or 1", "wrong scalar-for-vector"),
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
    ]);
}
