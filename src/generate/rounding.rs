//! Is a value fit to be asked for in rounded form? Not if the rounding hangs on the last figures of the working.

use crate::number::{Angle, FloatInterval, Fraction, Interval, Places, Value, clear_in_doubles, clear_of_tie, round};

/// The part of a unit in the last figure that must lie between a value and a tie.
const MARGIN: (i64, i64) = (1, 20);

/// Is the value clear of a tie, or exactly what it is rounded to? A formula in letters is never rounded.
///
/// ```
/// use carom::generate::rounds_safely;
/// use carom::number::{Places, Value};
/// let places = Places::SignificantFigures(3);
/// assert!(rounds_safely(&Value::fraction(5, 2), &places));
/// assert!(!rounds_safely(&Value::fraction(1245, 1000), &places));
/// assert!(!rounds_safely(&Value::fraction(12452, 10000), &places));
/// ```
pub fn rounds_safely(value: &Value, places: &Places) -> bool {
    if !value.is_constant() {
        return true;
    }
    safely_in_doubles(value.between_doubles(), places).unwrap_or_else(|| match value.as_fraction() {
        Some(exact) => fraction_rounds_safely(exact, places),
        None => clear(|bits| value.enclose(bits, &|_| None), places),
    })
}

/// As [`degrees_round_safely`], for the angle of a direction with these components.
pub fn direction_rounds_safely((y, x): &(Value, Value), places: &Places) -> bool {
    safely_in_doubles(Angle::size_between_doubles(y, x), places)
        .unwrap_or_else(|| Angle::of(y, x).is_none_or(|angle| degrees_round_safely(&angle, places)))
}

/// Nearly always doubles tell. What they find near a tie is not what it is rounded to, either.
fn safely_in_doubles(ends: Option<FloatInterval>, places: &Places) -> Option<bool> {
    clear_in_doubles(ends?, places, MARGIN.0 as f64 / MARGIN.1 as f64)
}

/// As [`rounds_safely`], for the number of degrees of an angle.
pub fn degrees_round_safely(angle: &Angle, places: &Places) -> bool {
    match angle.whole_degrees() {
        Some(exact) => fraction_rounds_safely(&exact, places),
        None => !angle.is_constant() || clear(|bits| angle.enclose(bits, &|_| None), places),
    }
}

fn fraction_rounds_safely(exact: &Fraction, places: &Places) -> bool {
    round(exact, places).to_fraction() == *exact || clear(|bits| Some(Interval::from_fraction(exact, bits)), places)
}

/// A margin that one twentieth of a unit wide need not be measured finely.
fn clear(enclose: impl Fn(usize) -> Option<Interval>, places: &Places) -> bool {
    let margin = Fraction::new(MARGIN.0, MARGIN.1);
    [64, 256].into_iter().any(|bits| enclose(bits).is_some_and(|value| clear_of_tie(&value, places, &margin)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn values_near_a_tie_are_not_asked_for() {
        let table = [
            ((2, 1), true),
            ((1, 3), true),
            ((9995, 1000), false),
            ((9999, 1000), true),
            ((10049, 1000), false),
            ((10051, 1000), false),
            ((1006, 100), true),
            ((0, 1), true),
            ((-1245, 1000), false),
        ];
        for ((numerator, denominator), expected) in table {
            let value = Value::fraction(numerator, denominator);
            assert_eq!(rounds_safely(&value, &Places::SignificantFigures(3)), expected, "{numerator}/{denominator}");
        }
        // The root of 1.55 is 1.24499…
        let root = Value::fraction(155, 100).square_root().unwrap();
        assert!(!rounds_safely(&root, &Places::SignificantFigures(3)));
        assert!(rounds_safely(&root, &Places::SignificantFigures(2)));
    }

    #[test]
    fn what_doubles_find_clear_of_a_tie_is_clear_of_it() {
        let margin = Fraction::new(MARGIN.0, MARGIN.1);
        let all = [Places::SignificantFigures(2), Places::SignificantFigures(3), Places::DecimalPlaces(1)];
        let mut found = [0, 0];
        for one in (-4000..4000_i64).step_by(7) {
            for below in [1, 3, 37, 400, 9973] {
                // Fractions, and fractions with a surd.
                let surd = &Value::fraction(one, below) * &Value::from(2).square_root().unwrap();
                for value in [Value::fraction(one, below), &surd + &Value::ONE] {
                    for places in &all {
                        if let Some(is_clear) = clear_in_doubles(value.between_doubles().unwrap(), places, 0.05) {
                            found[usize::from(is_clear)] += 1;
                            let certain = value.enclose_constant(128).unwrap();
                            assert_eq!(clear_of_tie(&certain, places, &margin), is_clear, "{value:?} to {places:?}");
                        }
                    }
                }
            }
        }
        // Nine in ten are clear, and of hardly any nothing is said.
        assert!(found[0] > 2_000 && found[1] > 25_000, "{found:?}");
    }

    #[test]
    fn a_direction_rounds_as_its_angle_does() {
        let places = Places::SignificantFigures(3);
        let root = Value::from(3).square_root().unwrap();
        let mut unsafe_ones = 0;
        for y in -40..40 {
            for x in -25..25 {
                for scale in [Value::ONE, root.clone()] {
                    let direction = (&Value::from(y) * &scale, Value::from(x));
                    let angle = Angle::of(&direction.0, &direction.1);
                    let expected = angle.is_none_or(|angle| degrees_round_safely(&angle, &places));
                    unsafe_ones += u32::from(!expected);
                    assert_eq!(direction_rounds_safely(&direction, &places), expected, "{y}, {x}");
                }
            }
        }
        assert!(unsafe_ones > 100, "{unsafe_ones}");
    }

    #[test]
    fn whole_degrees_are_exact_and_others_are_measured() {
        let angle = |y: i64, x: i64| Angle::of(&Value::from(y), &Value::from(x)).unwrap();
        let places = Places::SignificantFigures(3);
        assert!(degrees_round_safely(&angle(1, 1), &places));
        // 36.87 degrees
        assert!(degrees_round_safely(&angle(3, 4), &places));
        // 26.565 degrees, to two places
        assert!(!degrees_round_safely(&angle(1, 2), &Places::DecimalPlaces(2)));
    }
}
