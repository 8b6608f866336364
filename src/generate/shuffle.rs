//! The order in which numbers are dealt: a seeded permutation, made as it is asked for.
//!
//! The generator is ChaCha8 by name, and the step from its bits to a number below `n` is our own, so
//! that a seed printed on a paper gives the same paper whatever any library does later. Each
//! question and style has a stream of its own: to add a question changes no other.

use std::collections::HashMap;

use rand::rngs::ChaCha8Rng;
use rand::{Rng, SeedableRng};

/// The numbers from nought up to, not including, `size`, each once, in an order that the seed decides.
///
/// ```
/// use carom::generate::Shuffle;
/// let mut dealt: Vec<u64> = Shuffle::new(6, 2027, "rest/speeds-and-directions", "exact").collect();
/// assert_eq!(dealt, [2, 0, 5, 4, 1, 3]);
/// dealt.sort();
/// assert_eq!(dealt, [0, 1, 2, 3, 4, 5]);
/// ```
#[derive(Debug)]
pub struct Shuffle {
    random: ChaCha8Rng,
    size: u64,
    dealt: u64,
    /// What Fisher and Yates's array would hold where it no longer holds its own index.
    moved: HashMap<u64, u64>,
}

impl Shuffle {
    /// The order for a question in a style.
    pub fn new(size: u64, seed: u64, question: &str, style: &str) -> Shuffle {
        let mut random = ChaCha8Rng::seed_from_u64(seed);
        random.set_stream(stream(question, style));
        Shuffle { random, size, dealt: 0, moved: HashMap::new() }
    }

    /// How many there are in all.
    pub fn size(&self) -> u64 {
        self.size
    }
}

impl Iterator for Shuffle {
    type Item = u64;

    fn next(&mut self) -> Option<u64> {
        let left = self.size.checked_sub(self.dealt).filter(|left| *left > 0)?;
        let here = self.dealt;
        let chosen = here + below(left, &mut self.random);
        let displaced = self.moved.remove(&here).unwrap_or(here);
        self.dealt += 1;
        if chosen == here {
            return Some(displaced);
        }
        Some(self.moved.insert(chosen, displaced).unwrap_or(chosen))
    }

    fn size_hint(&self) -> (usize, Option<usize>) {
        let left = usize::try_from(self.size - self.dealt);
        (left.unwrap_or(usize::MAX), left.ok())
    }
}

/// A number from nought up to, not including, `bound`, every one equally likely: Lemire's method, by
/// which the high half of a product is the number and the few low halves that would favour some
/// numbers are thrown away. Nought if the bound is.
pub fn below(bound: u64, random: &mut impl Rng) -> u64 {
    if bound == 0 {
        return 0;
    }
    let unfair = bound.wrapping_neg() % bound;
    loop {
        let product = u128::from(random.next_u64()) * u128::from(bound);
        if product as u64 >= unfair {
            return (product >> 64) as u64;
        }
    }
}

/// The number of a question's and style's own stream: FNV-1a of both, a nought byte between.
fn stream(question: &str, style: &str) -> u64 {
    let bytes = question.bytes().chain([0]).chain(style.bytes());
    bytes.fold(0xcbf2_9ce4_8422_2325, |hash, byte| (hash ^ u64::from(byte)).wrapping_mul(0x0000_0100_0000_01b3))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_first_numbers_dealt_are_pinned_for_ever() {
        let first = |size, seed| Shuffle::new(size, seed, "rest/speeds", "exact").take(8).collect::<Vec<_>>();
        assert_eq!(first(1000, 1), PINNED_1);
        assert_eq!(first(1 << 40, 2), PINNED_2);
        assert_eq!(stream("", ""), 0xaf63_bd4c_8601_b7df);
    }

    const PINNED_1: [u64; 8] = [989, 373, 587, 371, 222, 439, 887, 152];
    const PINNED_2: [u64; 8] = [
        570845199154,
        709242599834,
        903352251942,
        300548479681,
        755801973925,
        609450080632,
        891883533484,
        920644619867,
    ];

    #[test]
    fn every_number_is_dealt_once_and_then_no_more() {
        for size in [0, 1, 2, 7, 100] {
            let mut dealt: Vec<u64> = Shuffle::new(size, 5, "q", "s").collect();
            dealt.sort();
            assert_eq!(dealt, (0..size).collect::<Vec<_>>());
        }
    }

    #[test]
    fn every_order_of_three_is_equally_likely() {
        let mut counts: HashMap<Vec<u64>, u32> = HashMap::new();
        for seed in 0..6000 {
            *counts.entry(Shuffle::new(3, seed, "q", "s").collect()).or_default() += 1;
        }
        assert_eq!(counts.len(), 6);
        // Five standard deviations of 1000 draws are about 145.
        assert!(counts.values().all(|count| count.abs_diff(1000) < 145), "{counts:?}");
    }

    #[test]
    fn another_question_or_style_has_another_order() {
        let order = |question, style| Shuffle::new(1000, 7, question, style).take(5).collect::<Vec<_>>();
        assert_ne!(order("a", "exact"), order("b", "exact"));
        assert_ne!(order("a", "exact"), order("a", "friendly"));
        assert_ne!(order("ab", "c"), order("a", "bc"));
    }
}
