//! Given angles that make a right angle together, such as 20° and 70°, in one value: one of them stands for both.
//!
//! Alone each keeps its own name, since who is given 70° expects cos 70° and not sin 20°. Where both meet, the
//! larger gives way: tan 70° = 1/tan 20°. So no value holds both, and sin² 20° + sin² 70° is 1 by form.

use std::cell::RefCell;

use smallvec::SmallVec;

use super::value::Value;
use super::{Fraction, Letter, Polynomial};

impl Value {
    /// The same value with one letter for every pair of given angles that make a right angle.
    pub(super) fn without_complements(self) -> Value {
        // Every value is asked, so no list is made of one that has no two such angles.
        let found: RefCell<SmallVec<[Letter; 4]>> = RefCell::default();
        self.has_letter(|letter| {
            if letter.is_constant() && !found.borrow().contains(letter) {
                found.borrow_mut().push(*letter);
            }
            false
        });
        let found = found.into_inner();
        if found.len() < 2 {
            return self;
        }
        let degrees = found.iter().filter_map(|letter| Some((letter.name().parse::<Fraction>().ok()?, *letter)));
        let mut angles: SmallVec<[(Fraction, Letter); 4]> = degrees.collect();
        angles.sort_by_key(|(_, letter)| *letter);
        let right = Fraction::from(90);
        for (degrees, letter) in &angles {
            let other = angles.iter().find(|(other, _)| other < degrees && other + degrees == right);
            if let Some((_, other)) = other {
                let tangent = Value::quotient(Polynomial::one(), Polynomial::letter(*other));
                return self.substitute(*letter, &tangent).expect("the tangent of an acute angle is not nought");
            }
        }
        self
    }
}

#[cfg(test)]
mod tests {
    use super::super::Direction;
    use super::*;

    fn degrees(text: &str) -> Direction {
        Direction::degrees(&text.parse().unwrap()).unwrap()
    }

    #[test]
    fn what_angles_share_is_seen_by_form() {
        let square = |value: &Value| value * value;
        for (a, b) in [("20", "70"), ("110", "160"), ("12.5", "77.5"), ("200", "-20")] {
            let (a, b) = (degrees(a), degrees(b));
            let sines = &square(&a.sin) + &square(&b.sin);
            let cosines = &square(&a.cos) + &square(&b.cos);
            assert_eq!(&sines + &cosines, Value::from(2));
            let letters = (&(&a.sin * &b.cos) + &b.sin).letters();
            assert_eq!(letters.len(), 1, "{letters:?}");
        }
        assert_eq!(&square(&degrees("20").sin) + &square(&degrees("70").sin), Value::ONE);
        assert_eq!(&degrees("70").cos - &degrees("20").sin, Value::ZERO);
        assert_eq!(degrees("160").cos, -degrees("20").cos);
        assert_eq!(degrees("250").sin, -degrees("70").sin);
        assert_eq!((degrees("90").cos, degrees("-90").sin), (Value::ZERO, Value::from(-1)));
    }

    #[test]
    fn roots_of_such_sums_are_brought_to_one_angle_too() {
        let (a, b) = (degrees("20"), degrees("70"));
        let root = (&Value::from(3) + &b.cos).square_root().unwrap();
        let sum = &root + &a.cos;
        assert_eq!(sum.letters().len(), 1);
        assert_eq!(&(&sum - &a.cos) * &root, &Value::from(3) + &a.sin);
    }
}
