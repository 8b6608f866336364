//! Numbers beside an angle, where degrees are expected: in `180 - alpha` they are degrees, as a number by itself is.

use super::{Expr, Meaning, Names, evaluate};

/// What a sum of numbers and angles stands for; none of any other formula.
pub(super) fn beside_an_angle(expr: &Expr, names: Names) -> Option<Meaning> {
    let Expr::Sum(terms) = expr else { return None };
    let in_degrees = |term: &Expr| match evaluate(term, names).ok()? {
        Meaning::Number(_) => Some(Expr::degrees(term.clone())),
        Meaning::Angle(_) => Some(term.clone()),
        _ => None,
    };
    let terms: Option<Vec<Expr>> = terms.iter().map(in_degrees).collect();
    evaluate(&Expr::sum(terms?), names).ok()
}

#[cfg(test)]
mod tests {
    use super::super::{Angles, Turn, degrees, print, read, written_angle};
    use super::*;
    use crate::number::{Angle, Letter, Range, Value};

    #[test]
    fn a_number_beside_an_angle_is_a_number_of_degrees() {
        let alpha = || Angle::of(&Value::letter(Letter::new("alpha", Range::Acute).unwrap()), &Value::ONE).unwrap();
        let k = || Value::letter(Letter::new("k", Range::Positive).unwrap());
        let name = |name: &str| match name {
            "alpha" => Some(Meaning::Angle(Turn::of(alpha()))),
            "k" => Some(Meaning::Number(k())),
            _ => None,
        };
        let of = |text: &str| degrees(&read(text, Angles::Degrees).unwrap(), &name).map_err(|fault| fault.message);
        for text in ["180 - alpha", "-alpha + 180", "90 + 90 - alpha"] {
            assert_eq!(of(text), of("180 deg - alpha"), "{text}");
        }
        assert_ne!(of("180 - alpha"), of("180 deg + alpha"));
        for text in ["k - alpha", "180 - k"] {
            assert!(of(text).is_err(), "{text}");
        }
        assert_eq!(print::unicode(&written_angle(&alpha())), "α");
    }
}
