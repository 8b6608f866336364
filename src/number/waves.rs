//! Sums of products of sines and cosines of given degrees, written as sums of cosines.
//!
//! `2 cos a cos b = cos(a − b) + cos(a + b)`, and a sine is the cosine of the complement. So what vanishes because angles add up,
//! as `sin 70° cos 20° + cos 70° sin 20° − 1` does, is seen to vanish term by term, whatever the angles are. √2 and √3 are twice the
//! cosines of 45° and 30°, which may be among these angles; and `cos(60° + a) = cos a − cos(60° − a)`, so that no angle beyond
//! 60° is left.

use std::collections::BTreeMap;

use super::terms::Terms;
use super::value::{Root, Value};
use super::{Direction, Fraction, Letter};

/// Powers of sines and cosines beyond which a sum is not written out.
const HIGHEST: u32 = 64;

/// Of each angle in degrees, from nought up to 90, how many times its cosine.
type Cosines = BTreeMap<Fraction, Fraction>;

/// Is it nought as a sum of cosines, times the `highest` powers of the cosines of its `angles`? If not, it may still be nought.
pub(super) fn vanishes(terms: &Terms, angles: &[Letter], highest: &[u32]) -> bool {
    let mut sum = Value::ZERO;
    for (roots, polynomial) in terms.iter() {
        let (mut surds, mut halves) = (Value::ONE, Vec::new());
        for root in roots {
            match root {
                Root::Prime(2) => halves.push(Fraction::from(45)),
                Root::Prime(3) => halves.push(Fraction::from(30)),
                Root::Prime(_) => surds = &surds * &Value::root(root.clone()),
                _ => {}
            }
        }
        let mut cosines = Cosines::new();
        for (monomial, coefficient) in polynomial.terms() {
            let power =
                |angle: &Letter| monomial.iter().find(|(letter, _)| letter == angle).map_or(0, |(_, power)| *power);
            let powers = angles.iter().zip(highest).map(|(angle, highest)| {
                let sines = power(angle);
                (angle, sines, highest - sines + u32::from(roots.contains(&Root::Cosine(*angle))))
            });
            let Some(product) = product(coefficient, powers) else { return false };
            let product = halves.iter().fold(product, |product, half| twice(times_cosine(&product, half)));
            for (degrees, times) in product {
                add(&mut cosines, degrees, times);
            }
        }
        for (degrees, times) in up_to_sixty(cosines) {
            let Some(direction) = Direction::degrees(&degrees) else { return false };
            sum = &sum + &(&(&surds * &direction.cos) * &Value::from(times));
        }
    }
    sum.is_written_zero()
}

/// A number times powers of the sine and of the cosine of each angle.
fn product<'a>(coefficient: &Fraction, powers: impl Iterator<Item = (&'a Letter, u32, u32)>) -> Option<Cosines> {
    let mut product = Cosines::from([(Fraction::ZERO, coefficient.clone())]);
    let mut factors = 0;
    for (angle, sines, cosines) in powers {
        let degrees: Fraction = angle.name().parse().ok()?;
        let complement = &Fraction::from(90) - &degrees;
        factors += sines + cosines;
        if factors > HIGHEST {
            return None;
        }
        for (angle, count) in [(&complement, sines), (&degrees, cosines)] {
            for _ in 0..count {
                product = times_cosine(&product, angle);
            }
        }
    }
    Some(product)
}

fn times_cosine(cosines: &Cosines, angle: &Fraction) -> Cosines {
    let mut product = Cosines::new();
    for (degrees, times) in cosines {
        let half = times * &Fraction::new(1, 2);
        add(&mut product, degrees - angle, half.clone());
        add(&mut product, degrees + angle, half);
    }
    product
}

fn twice(mut cosines: Cosines) -> Cosines {
    cosines.values_mut().for_each(|times| *times = &*times + &*times);
    cosines
}

/// The same without angles beyond 60 degrees.
fn up_to_sixty(cosines: Cosines) -> Cosines {
    let sixty = Fraction::from(60);
    let mut kept = Cosines::new();
    for (degrees, times) in cosines {
        if degrees > sixty {
            add(&mut kept, &degrees - &sixty, times.clone());
            add(&mut kept, &Fraction::from(120) - &degrees, -times);
        } else {
            add(&mut kept, degrees, times);
        }
    }
    kept
}

/// Adds so many times the cosine of any angle, which is that of an angle up to 90 degrees or its negative.
fn add(cosines: &mut Cosines, degrees: Fraction, times: Fraction) {
    let turns = (&degrees / &Fraction::from(360)).floor();
    let within = &degrees - &(&Fraction::from(turns) * &Fraction::from(360));
    let (straight, right) = (Fraction::from(180), Fraction::from(90));
    let within = if within > straight { &Fraction::from(360) - &within } else { within };
    let (acute, times) = if within > right { (&straight - &within, -times) } else { (within, times) };
    let sum = cosines.entry(acute).or_insert(Fraction::ZERO);
    *sum = &*sum + &times;
}
