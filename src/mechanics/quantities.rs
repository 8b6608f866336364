//! Something about each of many quantities, in the order of the quantities' places.
//!
//! What is known of a collision is looked up, changed and copied more often than anything else is done. So where the entry
//! of a quantity stands is read off at the quantity's place, and entries stay where they are when others come.

use super::Quantity;
use super::place::OF_AN_IMPACT;

/// A map from quantities, in the order in which they are declared.
#[derive(Debug)]
pub struct Quantities<T> {
    /// Of the quantity at each place which entry it has, counted from one; nought where it has none.
    numbers: Vec<u16>,
    /// As they were entered.
    entries: Vec<Entry<T>>,
}

/// Something about a quantity.
#[derive(Clone, Debug)]
struct Entry<T> {
    quantity: Quantity,
    /// The place of the quantity, which is not read off it twice.
    place: u16,
    about: T,
}

/// What is copied is mostly added to.
const ROOM: usize = 16;

impl<T: Clone> Clone for Quantities<T> {
    fn clone(&self) -> Quantities<T> {
        let mut entries = Vec::with_capacity(self.len() + ROOM);
        entries.extend_from_slice(&self.entries);
        Quantities { numbers: self.numbers.clone(), entries }
    }
}

impl<T> Default for Quantities<T> {
    fn default() -> Quantities<T> {
        Quantities { numbers: Vec::new(), entries: Vec::new() }
    }
}

impl<T: PartialEq> PartialEq for Quantities<T> {
    fn eq(&self, other: &Quantities<T>) -> bool {
        self.len() == other.len()
            && self.entries.iter().all(|own| {
                let entry = other.entry(usize::from(own.place));
                entry.is_some_and(|entry| other.entries[entry].about == own.about)
            })
    }
}

impl<T> Quantities<T> {
    /// How many there are.
    pub fn len(&self) -> usize {
        self.entries.len()
    }

    /// Is there none?
    pub fn is_empty(&self) -> bool {
        self.entries.is_empty()
    }

    /// Makes room for so many more.
    pub fn reserve(&mut self, more: usize) {
        self.entries.reserve(more);
    }

    /// Which entry the quantity at a place has.
    fn entry(&self, place: usize) -> Option<usize> {
        usize::from(*self.numbers.get(place)?).checked_sub(1)
    }

    /// What there is about a quantity.
    pub fn get(&self, quantity: &Quantity) -> Option<&T> {
        self.at(quantity.place())
    }

    /// What there is about the quantity of a place.
    #[inline]
    pub(super) fn at(&self, place: usize) -> Option<&T> {
        self.entry(place).map(|entry| &self.entries[entry].about)
    }

    /// What there is about the quantity of a place, to be changed.
    pub(super) fn at_mut(&mut self, place: usize) -> Option<&mut T> {
        self.entry(place).map(|entry| &mut self.entries[entry].about)
    }

    /// Is there anything about a quantity?
    pub fn contains_key(&self, quantity: &Quantity) -> bool {
        self.entry(quantity.place()).is_some()
    }

    /// Enters something about a quantity; what was there before.
    pub fn insert(&mut self, quantity: Quantity, about: T) -> Option<T> {
        self.insert_at(quantity.place(), quantity, about)
    }

    /// The same of a quantity that has this place.
    pub(super) fn insert_at(&mut self, place: usize, quantity: Quantity, about: T) -> Option<T> {
        match self.entry(place) {
            Some(entry) => Some(std::mem::replace(&mut self.entries[entry].about, about)),
            None => {
                self.append(quantity, place, about);
                None
            }
        }
    }

    /// Enters something about a quantity, unless there is something already.
    pub fn insert_new(&mut self, quantity: Quantity, about: T) {
        let place = quantity.place();
        if self.entry(place).is_none() {
            self.append(quantity, place, about);
        }
    }

    /// Enters something about a quantity about which there is nothing.
    fn append(&mut self, quantity: Quantity, place: usize, about: T) {
        if self.numbers.len() <= place {
            self.numbers.resize((place + 1).next_multiple_of(OF_AN_IMPACT), 0);
        }
        let number = |number: usize| u16::try_from(number).expect("there are fewer quantities than that");
        self.entries.push(Entry { quantity, place: number(place), about });
        self.numbers[place] = number(self.entries.len());
    }

    /// Takes out what there is about a quantity.
    pub fn remove(&mut self, quantity: &Quantity) -> Option<T> {
        self.remove_at(quantity.place())
    }

    /// The same of the quantity of a place.
    pub(super) fn remove_at(&mut self, place: usize) -> Option<T> {
        let entry = self.entry(place)?;
        if let Some(last) = self.entries.last() {
            self.numbers[usize::from(last.place)] = self.numbers[place];
        }
        self.numbers[place] = 0;
        Some(self.entries.swap_remove(entry).about)
    }

    /// The quantities.
    pub fn keys(&self) -> impl DoubleEndedIterator<Item = &Quantity> + Clone {
        self.iter().map(|(quantity, _)| quantity)
    }

    /// All of it.
    pub fn iter(&self) -> impl DoubleEndedIterator<Item = (&Quantity, &T)> + Clone {
        let entries = self.numbers.iter().filter(|number| **number > 0).map(|number| usize::from(*number) - 1);
        entries.map(|entry| (&self.entries[entry].quantity, &self.entries[entry].about))
    }

    /// The quantities as they were entered, unless some have been taken out since, each with its place.
    pub(super) fn placed_as_entered(&self) -> impl ExactSizeIterator<Item = (Quantity, usize)> + Clone {
        self.entries.iter().map(|entry| (entry.quantity, usize::from(entry.place)))
    }

    /// The quantities as they were entered, unless some have been taken out since.
    pub fn as_entered(&self) -> impl ExactSizeIterator<Item = Quantity> {
        self.entries.iter().map(|entry| entry.quantity)
    }

    /// All of it, to be changed, in any order.
    pub fn values_mut(&mut self) -> impl Iterator<Item = (&Quantity, &mut T)> {
        self.entries.iter_mut().map(|entry| (&entry.quantity, &mut entry.about))
    }

    /// All of it, taken out, as it was entered.
    pub fn into_pairs(self) -> impl Iterator<Item = (Quantity, T)> {
        self.entries.into_iter().map(|entry| (entry.quantity, entry.about))
    }
}

impl<T> Extend<(Quantity, T)> for Quantities<T> {
    fn extend<I: IntoIterator<Item = (Quantity, T)>>(&mut self, all: I) {
        for (quantity, about) in all {
            self.insert(quantity, about);
        }
    }
}

impl<T> FromIterator<(Quantity, T)> for Quantities<T> {
    fn from_iter<I: IntoIterator<Item = (Quantity, T)>>(all: I) -> Quantities<T> {
        let all = all.into_iter();
        let mut quantities = Quantities::default();
        quantities.reserve(all.size_hint().0);
        quantities.extend(all);
        quantities
    }
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeMap;

    use super::super::{Axis, Moment, Sphere};
    use super::*;

    /// Quantities of two impacts, in no order.
    fn several() -> Vec<Quantity> {
        let first = [
            Quantity::Restitution,
            Quantity::Mass(Sphere::B),
            Quantity::InALine,
            Quantity::Velocity(Sphere::A, Moment::After, Axis::T),
            Quantity::Mass(Sphere::A),
        ];
        first.into_iter().chain(first.into_iter().filter_map(|quantity| quantity.in_impact(2))).collect()
    }

    #[test]
    fn it_is_a_map_in_the_order_of_the_quantities() {
        let all = several();
        let (mut quantities, mut map) = (Quantities::default(), BTreeMap::new());
        let mut seed = 1_usize;
        for about in 0..2000 {
            seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            let quantity = all[(seed >> 33) % all.len()];
            match (seed >> 20) % 4 {
                0 => assert_eq!(quantities.remove(&quantity), map.remove(&quantity)),
                1 => {
                    quantities.insert_new(quantity, about);
                    map.entry(quantity).or_insert(about);
                }
                _ => assert_eq!(quantities.insert(quantity, about), map.insert(quantity, about)),
            }
            assert!(quantities.iter().eq(&map), "{quantities:?} is not {map:?}");
            assert!(all.iter().all(|quantity| quantities.get(quantity) == map.get(quantity)));
            assert_eq!(quantities, map.iter().rev().map(|(quantity, about)| (*quantity, *about)).collect());
            assert_eq!((quantities.len(), quantities.is_empty()), (map.len(), map.is_empty()));
        }
    }
}
