//! Something about each of many quantities, in one row sorted by the quantities' places.
//!
//! What is known of a collision is looked up and copied more often than anything else is done. So a quantity is looked up
//! by its place among all quantities, which is one number, worked out once for each look.

use std::borrow::Borrow;
use std::cmp::Ordering;

use litemap::LiteMap;

use super::Quantity;

/// A map from quantities, sorted as they are declared.
#[derive(Clone, Debug, PartialEq)]
pub struct Quantities<T>(LiteMap<Placed, T>);

/// A quantity with its place, by which it is compared.
#[derive(Clone, Copy, Debug)]
struct Placed {
    place: u16,
    quantity: Quantity,
}

impl From<Quantity> for Placed {
    fn from(quantity: Quantity) -> Placed {
        Placed { place: quantity.place(), quantity }
    }
}

impl PartialEq for Placed {
    fn eq(&self, other: &Placed) -> bool {
        self.place == other.place
    }
}

impl Eq for Placed {}

impl PartialOrd for Placed {
    fn partial_cmp(&self, other: &Placed) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Placed {
    fn cmp(&self, other: &Placed) -> Ordering {
        self.place.cmp(&other.place)
    }
}

impl Borrow<u16> for Placed {
    fn borrow(&self) -> &u16 {
        &self.place
    }
}

impl<T> Default for Quantities<T> {
    fn default() -> Quantities<T> {
        Quantities(LiteMap::new())
    }
}

impl<T> Quantities<T> {
    /// How many there are.
    pub fn len(&self) -> usize {
        self.0.len()
    }

    /// Is there none?
    pub fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// Makes room for so many more.
    pub fn reserve(&mut self, more: usize) {
        self.0.reserve(more);
    }

    /// What there is about a quantity.
    pub fn get(&self, quantity: &Quantity) -> Option<&T> {
        self.0.get(&quantity.place())
    }

    /// Is there anything about a quantity?
    pub fn contains_key(&self, quantity: &Quantity) -> bool {
        self.0.contains_key(&quantity.place())
    }

    /// Enters something about a quantity; what was there before.
    pub fn insert(&mut self, quantity: Quantity, about: T) -> Option<T> {
        self.0.insert(quantity.into(), about)
    }

    /// Enters something about a quantity, unless there is something already.
    pub fn insert_new(&mut self, quantity: Quantity, about: T) {
        self.0.try_insert(quantity.into(), about);
    }

    /// Takes out what there is about a quantity.
    pub fn remove(&mut self, quantity: &Quantity) -> Option<T> {
        self.0.remove(&quantity.place())
    }

    /// The quantities.
    pub fn keys(&self) -> impl DoubleEndedIterator<Item = &Quantity> {
        self.0.keys().map(|placed| &placed.quantity)
    }

    /// All of it.
    pub fn iter(&self) -> impl DoubleEndedIterator<Item = (&Quantity, &T)> {
        self.0.iter().map(|(placed, about)| (&placed.quantity, about))
    }

    /// All of it, to be changed.
    pub fn iter_mut(&mut self) -> impl Iterator<Item = (&Quantity, &mut T)> {
        self.0.iter_mut().map(|(placed, about)| (&placed.quantity, about))
    }

    /// All of it, taken out.
    pub fn into_pairs(self) -> impl Iterator<Item = (Quantity, T)> {
        self.0.into_tuple_vec().into_iter().map(|(placed, about)| (placed.quantity, about))
    }
}

impl<T> Extend<(Quantity, T)> for Quantities<T> {
    fn extend<I: IntoIterator<Item = (Quantity, T)>>(&mut self, all: I) {
        self.0.extend(all.into_iter().map(|(quantity, about)| (Placed::from(quantity), about)));
    }
}

impl<T> FromIterator<(Quantity, T)> for Quantities<T> {
    fn from_iter<I: IntoIterator<Item = (Quantity, T)>>(all: I) -> Quantities<T> {
        let all = all.into_iter();
        // Room is made once, and most come in their order.
        let mut quantities = Quantities(LiteMap::with_capacity(all.size_hint().1.unwrap_or_default()));
        for (quantity, about) in all {
            if let Some((placed, about)) = quantities.0.try_append(quantity.into(), about) {
                quantities.0.insert(placed, about);
            }
        }
        quantities
    }
}
