//! How carom writes exact values.

use super::{print, written, written_angle};
use crate::number::{Angle, Direction, Fraction, Letter, Range, Value};

fn root(n: i64) -> Value {
    Value::from(n).square_root().unwrap()
}

fn letter(name: &str, range: Range) -> Value {
    Value::letter(Letter::new(name, range).unwrap())
}

#[test]
fn values_are_written_as_a_teacher_writes_them() {
    let (u, e, m) = (letter("u", Range::Positive), letter("e", Range::Unit), letter("m", Range::Positive));
    let theta = Direction::acute(Letter::new("theta", Range::Acute).unwrap());
    let (x, w) = (letter("x", Range::Real), letter("w", Range::Positive));
    let one = Value::ONE;
    let half = Value::fraction(1, 2);
    let ten = Direction::degrees(&Fraction::from(10)).unwrap();
    let square = |value: &Value| value * value;
    let quotient = |a: &Value, b: &Value| a.divided_by(b).unwrap();
    let table: Vec<(Value, &str)> = vec![
        (Value::fraction(-5, 2), "-5/2"),
        (&root(3) * &Value::fraction(16, 9), "16*sqrt(3)/9"),
        (&Value::fraction(4, 3) + &(&root(2) * &Value::fraction(11, 9)), "4/3 + 11*sqrt(2)/9"),
        (&(&root(2) * &Value::fraction(8, 9)) - &Value::fraction(2, 3), "8*sqrt(2)/9 - 2/3"),
        (&root(5) * &(&Value::from(-3) - &root(2)), "-3*sqrt(5) - sqrt(10)"),
        (&(&u * &(&root(2) + &root(6))) * &Value::fraction(1, 4), "sqrt(2)*u*(1 + sqrt(3))/4"),
        (&(&one - &e) * &half, "(1 - e)/2"),
        (&(&(&Value::from(2) * &e) - &one) * &Value::fraction(1, 3), "(2*e - 1)/3"),
        (&(&(&u * &theta.cos) * &(&one - &e)) * &half, "u*(1 - e)*cos(theta)/2"),
        (quotient(&(&Value::from(2) * &theta.tangent().unwrap()), &(&one - &e)), "2*tan(theta)/(1 - e)"),
        (quotient(&(&one + &e), &(&e - &Value::from(3))), "-(1 + e)/(3 - e)"),
        (&(&m * &(&u * &u)) * &Value::fraction(9, 2), "9*m*u^2/2"),
        // Products of brackets.
        (quotient(&(&(&m * &(&u - &w)) * &(&one + &e)), &(&m + &Value::from(3))), "m*(u - w)*(1 + e)/(3 + m)"),
        (&(&(&square(&(&w - &u)) * &m) * &(&one - &e)) * &half, "m*(u - w)^2*(1 - e)/2"),
        (&(&w - &u) * &(&e - &Value::from(2)), "(u - w)*(2 - e)"),
        (&(&u - &w) * &(&e - &Value::from(2)), "(w - u)*(2 - e)"),
        (&(-&square(&(&u - &w))) * &m, "-m*(u - w)^2"),
        (&square(&(&one + &(&e * &m))) * &Value::fraction(2, 3), "2*(1 + m*e)^2/3"),
        (&(&(&root(2) * &m) * &(&u - &w)) * &(&one + &e), "sqrt(2)*m*(u - w)*(1 + e)"),
        (&(&x.absolute() * &(&u - &w)) * &(&one + &e), "abs(x)*(u - w)*(1 + e)"),
        // Sizes of what may be negative.
        (quotient(&Value::from(20), &x.absolute()), "20/abs(x)"),
        (quotient(&m, &(&(&m - &Value::from(2)) * &Value::fraction(5, 2)).absolute()), "2*m/(5*abs(m - 2))"),
        (quotient(&x.absolute(), &(&x * &Value::from(3))), "abs(x)/(3*x)"),
        (&Value::from(6) * &ten.sin, "6*sin(10*deg)"),
        (quotient(&ten.sin, &ten.cos), "tan(10*deg)"),
        ((&Value::ONE + &root(2)).square_root().unwrap(), "sqrt(1 + sqrt(2))"),
        // Sines and cosines of two angles, in the fewest terms.
        (&square(&ten.cos) * &square(&theta.cos), "cos(10*deg)^2*cos(theta)^2"),
        (
            &square(&(&ten.cos + &theta.cos)) + &square(&(&ten.sin + &theta.cos)),
            "1 + 2*cos(theta)^2 + 2*cos(10*deg)*cos(theta) + 2*sin(10*deg)*cos(theta)",
        ),
        (
            &square(&(&ten.cos + &theta.sin)) - &square(&(&ten.sin + &theta.sin)),
            "2*cos(10*deg)^2 - 1 + 2*cos(10*deg)*sin(theta) - 2*sin(10*deg)*sin(theta)",
        ),
        (quotient(&one, &(&one + &square(&(&ten.cos * &root(3))))), "1/(4*cos(10*deg)^2 + sin(10*deg)^2)"),
    ];
    for (value, expected) in table {
        assert_eq!(print::plain(&written(&value)), expected);
    }
}

#[test]
fn an_angle_of_a_letter_is_one_sum_in_every_quadrant() {
    let theta = Direction::acute(Letter::new("theta", Range::Acute).unwrap());
    let tangent = theta.tangent().unwrap();
    let one = Value::ONE;
    for (y, x, expected) in [
        (&tangent, &one, "theta"),
        (&-&tangent, &one, "-theta"),
        (&tangent, &-&one, "180*deg - theta"),
        (&-&tangent, &-&one, "theta - 180*deg"),
        (&theta.cos, &theta.sin, "90*deg - theta"),
        (&-&theta.cos, &theta.sin, "theta - 90*deg"),
        (&theta.cos, &-&theta.sin, "90*deg + theta"),
        (&-&theta.cos, &-&theta.sin, "-theta - 90*deg"),
        (&Value::from(2), &-&one, "180*deg - atan(2)"),
    ] {
        assert_eq!(print::plain(&written_angle(&Angle::of(y, x).unwrap())), expected);
    }
}

#[test]
fn a_radicand_of_any_length_is_written_whole() {
    // Two primes of 61 and 89 bits: what is under the root is longer than any machine integer.
    let [one, other] = ["2305843009213693951", "618970019642690137449562111"]
        .map(|prime| Value::Rational(prime.parse::<Fraction>().unwrap()).square_root().unwrap());
    assert_eq!(print::plain(&written(&(&one * &other))), "sqrt(1427247692705959880439315947500961989719490561)");
    let sum = &(&one * &other) + &one;
    let expected = "sqrt(2305843009213693951) + sqrt(1427247692705959880439315947500961989719490561)";
    assert_eq!(print::plain(&written(&sum)), expected);
    let (letter, shared) =
        (letter("u", Range::Positive), "sqrt(2305843009213693951)*u*(1 + sqrt(618970019642690137449562111))");
    assert_eq!(print::plain(&written(&(&letter * &sum))), shared);
}
