//! What is known, as a law has it.

use super::{Datum, Known, all};
use crate::mechanics::Quantity;
use crate::mechanics::later::Meeting;
use crate::number::Number;

/// What is known of one impact, whose spheres the law calls A and B, with other numbers for some of it. Nothing is copied:
/// a law asks for little of what is known, and is asked often.
#[derive(Debug)]
pub struct Here<'k, N> {
    known: &'k Known<N>,
    meeting: Meeting,
    instead: &'k [(Quantity, N)],
}

impl<'k, N: Number> Here<'k, N> {
    /// Of an impact.
    pub fn at(meeting: Meeting, known: &'k Known<N>) -> Here<'k, N> {
        Here { known, meeting, instead: &[] }
    }

    /// The same with other numbers.
    pub fn with<'i>(&self, instead: &'i [(Quantity, N)]) -> Here<'i, N>
    where
        'k: 'i,
    {
        Here { known: self.known, meeting: self.meeting, instead }
    }

    #[inline(always)] // a law names its quantities: where they stand is known before the program runs
    fn datum(&self, quantity: Quantity) -> Option<&'k Datum<N>> {
        if self.meeting.number == 0 {
            return self.known.0.at(quantity.place());
        }
        self.known.0.get(&self.meeting.quantity(quantity))
    }

    /// Is the quantity known?
    pub fn knows(&self, quantity: Quantity) -> bool {
        self.datum(quantity).is_some()
    }

    /// A quantity that is a number.
    #[inline(always)]
    pub fn number(&self, quantity: Quantity) -> Option<N> {
        if !self.instead.is_empty()
            && let Some((_, number)) = self.instead.iter().find(|(other, _)| *other == quantity)
        {
            return Some(number.clone());
        }
        self.datum(quantity)?.number()
    }

    /// Several quantities that are numbers.
    #[inline(always)]
    pub fn numbers<const COUNT: usize>(&self, quantities: [Quantity; COUNT]) -> Option<[N; COUNT]> {
        all(quantities.map(|quantity| self.number(quantity)))
    }

    /// The vector of an angle.
    pub fn direction(&self, quantity: Quantity) -> Option<(N, N)> {
        self.datum(quantity)?.direction()
    }

    /// An equation for the components after the impact.
    pub fn equation(&self, quantity: Quantity) -> Option<[N; 3]> {
        self.datum(quantity)?.equation()
    }
}
