//! The terms of a value: products of roots, each with the polynomial that it is multiplied by.
//!
//! They are few, and copied more often than looked up. So they stand in one sorted row, and what is made of one product alone,
//! as most values are, costs no memory of its own.

use smallvec::{SmallVec, smallvec};

use super::Polynomial;
use super::value::Root;

/// A product of roots, sorted; none for one.
pub type Roots = SmallVec<[Root; 1]>;

type Row = SmallVec<[(Roots, Polynomial); 1]>;

/// Products of roots with their coefficients, sorted by product.
#[derive(Clone, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Terms(Row);

impl Terms {
    /// One product with its coefficient.
    pub(crate) fn one(roots: Roots, coefficient: Polynomial) -> Terms {
        Terms(smallvec![(roots, coefficient)])
    }

    /// Of a row that is sorted, no product twice.
    pub(super) fn from_sorted(row: impl IntoIterator<Item = (Roots, Polynomial)>) -> Terms {
        let row: Row = row.into_iter().collect();
        debug_assert!(row.windows(2).all(|pair| pair[0].0 < pair[1].0), "sorted, no product twice");
        Terms(row)
    }

    /// How many there are.
    pub(crate) fn len(&self) -> usize {
        self.0.len()
    }

    /// Is there none?
    pub(crate) fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// The first.
    pub(super) fn first(&self) -> Option<&(Roots, Polynomial)> {
        self.0.first()
    }

    /// The coefficient of a product.
    pub(super) fn get(&self, roots: &[Root]) -> Option<&Polynomial> {
        let place = self.0.binary_search_by(|(own, _)| own.as_slice().cmp(roots)).ok()?;
        Some(&self.0[place].1)
    }

    /// The coefficient of a product, to be changed; nought if it was not there.
    pub(super) fn coefficient_mut(&mut self, roots: Roots) -> &mut Polynomial {
        let place = self.0.binary_search_by(|(own, _)| own.cmp(&roots)).unwrap_or_else(|place| {
            self.0.insert(place, (roots, Polynomial::zero()));
            place
        });
        &mut self.0[place].1
    }

    /// All of them.
    pub(crate) fn iter(&self) -> impl ExactSizeIterator<Item = (&Roots, &Polynomial)> + Clone {
        self.0.iter().map(|(roots, coefficient)| (roots, coefficient))
    }

    /// The products.
    pub(crate) fn products(&self) -> impl Iterator<Item = &Roots> + Clone {
        self.0.iter().map(|(roots, _)| roots)
    }

    /// Their coefficients.
    pub(crate) fn coefficients(&self) -> impl Iterator<Item = &Polynomial> + Clone {
        self.0.iter().map(|(_, coefficient)| coefficient)
    }

    /// Changes every coefficient.
    pub(super) fn change(&mut self, change: impl Fn(&Polynomial) -> Polynomial) {
        self.0.iter_mut().for_each(|(_, coefficient)| *coefficient = change(coefficient));
    }

    /// The same products with other coefficients, none of them nought.
    pub(super) fn with(&self, change: impl Fn(&Polynomial) -> Polynomial) -> Terms {
        Terms(self.0.iter().map(|(roots, coefficient)| (roots.clone(), change(coefficient))).collect())
    }

    /// Takes out the products whose coefficient is nought.
    pub(super) fn without_noughts(mut self) -> Terms {
        self.0.retain(|(_, coefficient)| !coefficient.is_zero());
        self
    }
}

impl IntoIterator for Terms {
    type Item = (Roots, Polynomial);
    type IntoIter = smallvec::IntoIter<[(Roots, Polynomial); 1]>;
    fn into_iter(self) -> Self::IntoIter {
        self.0.into_iter()
    }
}

/// In any order; coefficients of the same product are added.
impl FromIterator<(Roots, Polynomial)> for Terms {
    fn from_iter<I: IntoIterator<Item = (Roots, Polynomial)>>(all: I) -> Terms {
        let mut terms = Terms::default();
        for (roots, coefficient) in all {
            let sum = terms.coefficient_mut(roots);
            *sum = &*sum + &coefficient;
        }
        terms
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::Fraction;

    #[test]
    fn a_product_stands_once_whatever_the_order_in_which_terms_come() {
        let root = |primes: &[u128]| -> Roots { primes.iter().copied().map(Root::Prime).collect() };
        let times = |number: i64| Polynomial::constant(Fraction::from(number));
        let all = [(&[2][..], 3), (&[], 1), (&[2, 3], 5), (&[3], 4), (&[2], -3), (&[3], 1)];
        let of = |order: &[usize]| -> Terms {
            order.iter().map(|place| (root(all[*place].0), times(all[*place].1))).collect()
        };
        let terms = of(&[0, 1, 2, 3, 4, 5]);
        assert!(terms == of(&[5, 4, 3, 2, 1, 0]));
        assert_eq!((terms.len(), terms.is_empty()), (4, false));
        assert_eq!(terms.get(&root(&[3])), Some(&times(5)));
        assert_eq!(terms.get(&root(&[5])), None);
        assert_eq!(terms.get(&root(&[2])), Some(&Polynomial::zero()), "3 - 3, until noughts are taken out");
        let terms = terms.without_noughts();
        let expected = [(root(&[]), times(1)), (root(&[2, 3]), times(5)), (root(&[3]), times(5))];
        assert!(terms == Terms::from_sorted(expected));
        assert_eq!(terms.with(|coefficient| -coefficient).coefficients().next(), Some(&times(-1)));
    }
}
