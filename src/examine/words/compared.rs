//! Who is said to be heavier or faster than another.

use std::cmp::Ordering;

use super::said_of_spheres::is_always;
use super::sentence::{Token, is_one_of, is_supposed, sentences, subject};
use super::truth::remark;
use crate::examine::remark::Remark;
use crate::expr::Text;
use crate::generate::Variant;
use crate::mechanics::{Axis, Moment, Quantity, Setting, Sphere};
use crate::number::Value;

/// What one sphere is said to be beside another, and how what it has is then to that of the other.
const BESIDE: [(&str, Ordering); 4] = [
    ("heavier", Ordering::Greater),
    ("lighter", Ordering::Less),
    ("faster", Ordering::Greater),
    ("slower", Ordering::Less),
];

/// The speed before the collision; in one line it is the size of the velocity.
fn speed(variant: &Variant, sphere: Sphere) -> Option<Value> {
    let known = variant.solution.known();
    known.number(Quantity::Speed(sphere, Moment::Before)).or_else(|| {
        let along = [Axis::N, Axis::X].map(|axis| Quantity::Velocity(sphere, Moment::Before, axis));
        let along = along.into_iter().find_map(|along| known.number(along));
        let along = along.filter(|_| variant.scene.setting == Setting::Direct)?;
        Some(if along.sign()?.is_lt() { -&along } else { along })
    })
}

/// A sphere that is said to be heavier or faster than another.
#[derive(Clone, Debug)]
pub(super) struct Compared {
    one: Sphere,
    said: &'static str,
    wanted: Ordering,
    other: Sphere,
    /// Of what comes later nothing is compared but masses.
    is_later: bool,
}

impl Compared {
    /// A remark where it is not so.
    pub(super) fn if_untrue(&self, variant: &Variant) -> Option<Remark> {
        let Compared { one, said, wanted, other, is_later } = self;
        let of = |sphere| match *said {
            "heavier" | "lighter" => variant.solution.known().number(Quantity::Mass(sphere)),
            _ if *is_later => None,
            _ => speed(variant, sphere),
        };
        let is_so = is_always(variant, &(&of(*one)? - &of(*other)?), *wanted)?;
        let shown = format!("{} is {said} than {}", one.name(), other.name());
        let help = "require that it is so, or take the words out";
        (!is_so).then(|| remark("a comparison that is not so", &format!("{said} than"), &shown, help))
    }
}

/// Who is said so in a text.
pub(super) fn compared(text: &Text, found: &mut Vec<Compared>) {
    for sentence in sentences(text).into_iter().filter(|sentence| !is_supposed(sentence)) {
        for (place, token) in sentence.iter().enumerate() {
            let Some((said, wanted)) = BESIDE.iter().find(|(said, _)| is_one_of(token, &[said])) else { continue };
            let other = sentence[place + 1..].iter().take(3).find_map(|token| match token {
                Token::Sphere(sphere) => Some(*sphere),
                _ => None,
            });
            let (Some(one), Some(other)) = (subject(&sentence[..place]), other) else { continue };
            // `*A* strikes a heavier sphere *B*` says it of *B*.
            let is_before_its_name = !sentence[place + 1..].iter().take(3).any(|token| is_one_of(token, &["than"]));
            let (one, other) = if is_before_its_name { (other, one) } else { (one, other) };
            let is_later = sentence.iter().any(|token| is_one_of(token, &["after", "then"]));
            found.push(Compared { one, said, wanted: *wanted, other, is_later });
        }
    }
}
