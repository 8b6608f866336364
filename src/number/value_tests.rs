//! What carom knows of exact values.

use super::*;

fn root(n: i64) -> Value {
    Value::from(n).square_root().unwrap()
}

fn letter(name: &str, range: Range) -> Letter {
    Letter::new(name, range).unwrap()
}

fn degrees(n: i64) -> Direction {
    Direction::degrees(&Fraction::from(n)).unwrap()
}

#[test]
fn surds_have_one_form_and_their_reciprocals_no_root_below() {
    assert_eq!(&root(8) + &root(2), &Value::from(3) * &root(2));
    assert_eq!(&root(6) * &root(10), &Value::from(2) * &root(15));
    let value = &(&Value::ONE + &root(2)) + &root(3);
    assert_eq!(&value * &value.reciprocal().unwrap(), Value::ONE);
    assert_eq!(Value::fraction(208, 27).square_root().unwrap(), &root(39) * &Value::fraction(4, 9));
}

#[test]
fn nested_roots_are_undone_where_they_can_be() {
    let five = &Value::from(5) + &(&Value::from(2) * &root(6));
    assert_eq!(five.square_root().unwrap(), &root(2) + &root(3));
    let minus = &Value::from(3) - &(&Value::from(2) * &root(2));
    assert_eq!(minus.square_root().unwrap(), &root(2) - &Value::ONE);
    let stays = (&Value::ONE + &root(2)).square_root().unwrap();
    assert_eq!(&stays * &stays, &Value::ONE + &root(2));
    assert_eq!(&stays * &stays.reciprocal().unwrap(), Value::ONE);
}

#[test]
fn nested_roots_are_compared_by_squaring() {
    // √(2+√2) √(2-√2) = √2, which the normal form does not see.
    let plus = (&Value::from(2) + &root(2)).square_root().unwrap();
    let minus = (&Value::from(2) - &root(2)).square_root().unwrap();
    let product = &plus * &minus;
    assert!(product.equals(&root(2)));
    assert!(!product.equals(&-root(2)));
    assert!((&product - &root(2)).reciprocal().is_none());
    assert!(!product.equals(&(&root(2) + &Value::fraction(1, 1_000_000_000_000))));
}

#[test]
fn a_zero_among_sines_of_whole_degrees_is_decided() {
    let cos = |n| degrees(n).cos;
    assert!(cos(20).equals(&(&cos(40) + &cos(80))));
    assert!(!cos(20).equals(&(&cos(40) + &cos(79))));
    // 4 sin 18° = √5 - 1.
    assert!((&Value::from(4) * &degrees(18).sin).equals(&(&root(5) - &Value::ONE)));
    let tan = |n| degrees(n).tangent().unwrap();
    assert!((&(&tan(20) * &tan(40)) * &tan(80)).equals(&root(3)));
    assert!((&degrees(80).cos - &degrees(10).sin).is_zero());
}

#[test]
fn the_circle_closes() {
    let theta = Direction::acute(letter("theta", Range::Acute));
    let one = &(&theta.cos * &theta.cos) + &(&theta.sin * &theta.sin);
    assert_eq!(one, Value::ONE);
    let double = theta.times(2);
    assert_eq!(double.sin, &(&Value::from(2) * &theta.sin) * &theta.cos);
    for n in [0, 10, 30, 45, 100, 135, 200, 270, 300, -30, 361] {
        let direction = degrees(n);
        assert!((&(&direction.cos * &direction.cos) + &(&direction.sin * &direction.sin)).equals(&Value::ONE), "{n}");
    }
}

#[test]
fn signs_in_letters_follow_from_their_ranges() {
    use std::cmp::Ordering::{Greater, Less};
    let e = Value::letter(letter("e", Range::Unit));
    let t = Value::letter(letter("alpha", Range::Acute));
    let x = Value::letter(letter("x", Range::Real));
    let two = Value::from(2);
    assert_eq!((&Value::ONE - &e).sign(), Some(Greater));
    assert_eq!((&e - &Value::from(3)).sign(), Some(Less));
    assert_eq!((&(&two * &(&t * &t)) + &(&Value::ONE - &e)).sign(), Some(Greater));
    assert_eq!((&(&two * &e) - &Value::ONE).sign(), None);
    assert_eq!(x.sign(), None);
    assert_eq!((&(&x * &x) + &Value::ONE).sign(), Some(Greater));
    assert_eq!((&(&root(2) - &two) * &t).sign(), Some(Less));
}

#[test]
fn roots_of_formulas_let_squares_out() {
    let v = Value::letter(letter("v", Range::Positive));
    let theta = Direction::acute(letter("theta", Range::Acute));
    let square = &(&v * &v) * &Value::fraction(61, 36);
    assert_eq!(square.square_root().unwrap(), &(&v * &root(61)) * &Value::fraction(1, 6));
    let whole = &(&(&v * &theta.cos) * &(&v * &theta.cos)) * &Value::from(2);
    assert_eq!(whole.square_root().unwrap(), &(&v * &theta.cos) * &root(2));
}

#[test]
fn angles_of_whole_degrees_are_found_and_proved() {
    let angle = Angle::of(&degrees(10).sin, &degrees(10).cos).unwrap();
    assert_eq!(angle.whole_degrees(), Some(Fraction::from(10)));
    assert_eq!(Angle::of(&root(3), &Value::from(-3)).unwrap().whole_degrees(), Some(Fraction::from(150)));
    assert_eq!(Angle::of(&Value::ZERO, &Value::from(-3)).unwrap().whole_degrees(), Some(Fraction::from(180)));
    for angle in (-165..=180).step_by(15) {
        let direction = degrees(angle);
        let size = root(7);
        let found = Angle::of(&(&direction.sin * &size), &(&direction.cos * &size)).unwrap().whole_degrees();
        assert_eq!(found, Some(Fraction::from(angle)), "{angle}");
    }
    // What adds up is proved at once, though its conjugates are thousands: 116.23° − 32.37° = 83.86°.
    let exact = |text: &str| Direction::degrees(&text.parse().unwrap()).unwrap();
    let turned = exact("116.23").plus(&exact("32.37").reversed());
    assert_eq!(Angle::of(&turned.sin, &turned.cos).unwrap().whole_degrees(), Some("83.86".parse().unwrap()));
    let (one, other) = (exact("17.123"), exact("12.345"));
    assert!(!turned.sin.equals(&one.sin) && one.plus(&other).sin.equals(&exact("29.468").sin));
    let thrice = exact("12.345").times(3);
    assert!(thrice.cos.equals(&exact("37.035").cos) && !thrice.cos.equals(&exact("37.036").cos));
    // √3 and √2 are cosines that join in: 36.87° + 30° = 66.87°.
    for (given, sum) in [("30", "66.87"), ("60", "96.87"), ("45", "81.87"), ("-30", "6.87"), ("-105", "-68.13")] {
        let turned = exact("36.87").plus(&exact(given));
        assert_eq!(Angle::of(&turned.sin, &turned.cos).unwrap().whole_degrees(), Some(sum.parse().unwrap()), "{given}");
    }
    // Tangents whose squares are 1/2, 2 and 9/16.
    for (y, x) in [(root(1), root(2)), (root(6), -&root(3)), (Value::from(3), Value::from(4))] {
        assert_eq!(Angle::of(&y, &x).unwrap().whole_degrees(), None);
    }
    let seed = Angle::acute(&Value::from(2), &(&root(3) * &Value::fraction(10, 9))).unwrap();
    assert_eq!(seed.whole_degrees(), None);
    assert_eq!(seed.rounded(&Places::SignificantFigures(3)).unwrap().to_string(), "46.1");
}

#[test]
fn a_letter_can_be_replaced_everywhere() {
    let name = letter("theta", Range::Acute);
    let theta = Direction::acute(name);
    let value = &theta.cos + &(&theta.sin * &theta.sin);
    let replaced = value.substitute(name, &root(3)).unwrap();
    assert_eq!(replaced, Value::fraction(5, 4));
}

#[test]
fn two_doubles_hold_what_a_finer_interval_holds() {
    let nested = (&Value::from(5) + &root(3)).square_root().unwrap();
    let surd = Value::fraction(7, 9).square_root().unwrap();
    let values = [&surd + &nested, &nested * &degrees(25).cos, &degrees(70).sin - &surd, Value::fraction(-22, 7)];
    for value in values {
        let (ends, finer) = (value.between_doubles().unwrap(), value.enclose_constant(160).unwrap());
        let [lower, upper] = [ends.lower, ends.upper].map(|end| Fraction::from_f64(end).unwrap());
        assert!(lower <= finer.lower() && finer.upper() <= upper, "{value:?}");
        assert!(ends.upper - ends.lower < 1e-12, "{value:?}");
    }
    assert_eq!(Value::letter(letter("u", Range::Positive)).between_doubles(), None);
}
