//! Reciprocals, quotients and powers of exact values.

use super::{Root, Value};

impl Value {
    /// One over the value; `None` for nought.
    pub fn reciprocal(&self) -> Option<Value> {
        if let Value::Rational(number) = self {
            return number.reciprocal().map(Value::Rational);
        }
        // 1/x = x/x², and the square of a surd is a number.
        if self.as_surd().is_some() {
            let square = self * self;
            return Some(self * &Value::Rational(square.as_fraction()?.reciprocal()?));
        }
        let Some(root) = self.roots().pop() else {
            let (numerator, denominator) = self.as_quotient()?;
            return Some(Value::quotient(denominator, numerator));
        };
        let (a, b) = self.split(&root);
        if a.is_written_zero() {
            return Some(&Value::root(root.clone()) * &(&b * &root.square()).reciprocal()?);
        }
        let norm = &(&a * &a) - &(&(&b * &b) * &root.square());
        if norm.is_zero() {
            // The root was no new number: either a + b root is nought, or a - b root is.
            return if self.is_zero() { None } else { (&a * &Value::from(2)).reciprocal() };
        }
        Some(&(&a - &(&b * &Value::root(root))) * &norm.reciprocal()?)
    }

    /// Would its reciprocal be a formula that nobody wants to read? Each root doubles it, and letters
    /// let it grow further, as given angles do, whose tangents are letters too.
    pub fn is_laborious(&self) -> bool {
        let roots = self.roots();
        // By a root one divides in multiplying by it and dividing by what stands under it.
        if roots.iter().any(|root| matches!(root, Root::Nested { radicand, .. } if radicand.is_laborious())) {
            return true;
        }
        let many = if self.has_letters() { 2 } else { 4 };
        roots.len() >= many && self.is_sum_of_roots()
    }

    /// Does it have several products of roots above the denominator, the product of none among them?
    pub(super) fn is_sum_of_roots(&self) -> bool {
        !matches!(self, Value::Compound(compound) if compound.terms.len() == 1)
    }

    /// The quotient; `None` by nought.
    pub fn divided_by(&self, divisor: &Value) -> Option<Value> {
        if let (Value::Rational(a), Value::Rational(b)) = (self, divisor) {
            return b.reciprocal().map(|inverse| Value::Rational(a * &inverse));
        }
        if let Value::Rational(number) = divisor {
            return number.reciprocal().map(|inverse| self * &Value::Rational(inverse));
        }
        if divisor.is_zero() { None } else { Some(self * &divisor.reciprocal()?) }
    }

    /// A whole power; `None` for a negative power of nought.
    pub fn power(&self, exponent: i32) -> Option<Value> {
        let base = if exponent < 0 { self.reciprocal()? } else { self.clone() };
        Some((0..exponent.unsigned_abs()).fold(Value::ONE, |product, _| &product * &base))
    }
}
