//! The form in which an answer comes out: a whole number, a fraction, a surd, a decimal, a formula in letters.

use crate::bank::Answer;
use crate::number::{Angle, Root, Value};
use crate::solve::Solution;

/// A surd has at most so many terms; a longer sum is read as a decimal.
const MOST_TERMS: usize = 3;

/// The form of an answer, the simplest first.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Form {
    /// A whole number, or a whole number of degrees.
    Whole,
    /// A fraction of whole numbers.
    Fraction,
    /// A sum of few square roots of whole numbers with fractions before them.
    Surd,
    /// Anything else without letters: it is given rounded.
    Decimal,
    /// A formula in letters.
    Letters,
}

impl Form {
    /// Every form, the simplest first.
    pub const ALL: [Form; 5] = [Form::Whole, Form::Fraction, Form::Surd, Form::Decimal, Form::Letters];

    /// Its name in a census.
    pub fn name(self) -> &'static str {
        match self {
            Form::Whole => "whole",
            Form::Fraction => "fraction",
            Form::Surd => "surd",
            Form::Decimal => "decimal",
            Form::Letters => "letters",
        }
    }

    /// The form of a number.
    ///
    /// ```
    /// use carom::generate::Form;
    /// use carom::number::Value;
    /// assert_eq!(Form::of_number(&Value::fraction(3, 4)), Form::Fraction);
    /// assert_eq!(Form::of_number(&Value::from(12).square_root().unwrap()), Form::Surd);
    /// ```
    pub fn of_number(value: &Value) -> Form {
        if let Some(fraction) = value.as_fraction() {
            return if fraction.is_integer() { Form::Whole } else { Form::Fraction };
        }
        if !value.is_constant() {
            return Form::Letters;
        }
        let plain = value.roots().iter().all(|root| matches!(root, Root::Prime(_)));
        if plain && value.terms() <= MOST_TERMS { Form::Surd } else { Form::Decimal }
    }

    /// The form of an angle in degrees.
    pub fn of_angle(angle: &Angle) -> Form {
        match angle.whole_degrees() {
            Some(degrees) if degrees.is_integer() => Form::Whole,
            Some(_) => Form::Fraction,
            None if angle.is_constant() => Form::Decimal,
            None => Form::Letters,
        }
    }

    /// The form of an answer, of a vector that of its less simple component; none of a letter that is to be found.
    pub fn of_answer(answer: &Answer, solution: &Solution) -> Option<Form> {
        let one = |quantity| {
            let number = solution.number(quantity).map(|value| Form::of_number(&value));
            // The letters of a direction may cancel; of numbers all that is asked is whether the degrees are whole.
            let of_numbers = || {
                let (y, x) = solution.known().direction(quantity)?;
                (y.is_constant() && x.is_constant()).then(|| Form::of_angle(&Angle::unscaled(&y, &x)))
            };
            number.or_else(of_numbers).or_else(|| solution.angle(quantity).map(|angle| Form::of_angle(&angle)))
        };
        answer.find.quantities().into_iter().filter_map(one).max()
    }
}
