//! Every way in which a student may have chosen letters and directions for the two components after the impact.

use crate::mechanics::Sphere;

/// Which letters of the student are the components after the impact, and which way each is positive.
#[derive(Clone, Debug, PartialEq)]
pub(in crate::mark::working) struct Convention {
    pub(in crate::mark::working) letters: [String; 2],
    /// +1 where the student's positive direction is from A to B.
    pub(in crate::mark::working) signs: [f64; 2],
    /// Does the letter that comes first in the alphabet stand for B?
    pub(super) is_unusual: bool,
    /// Does `v_1` stand for B? Only if both equations are right so: whoever exchanges the masses has not exchanged the numbers.
    pub(super) is_against_numbers: bool,
}

/// Every way to take the student's two unknowns: which is which, and the sign of each. The usual one first.
pub(super) fn conventions(names: &[String]) -> Vec<Convention> {
    let [one, other] = names else { return Vec::new() };
    let mut orders = vec![[one.clone(), other.clone()], [other.clone(), one.clone()]];
    if sphere(one) == Some(Sphere::B) || sphere(other) == Some(Sphere::A) {
        orders.reverse();
    }
    let has_both = sphere(one).is_some() && sphere(other).is_some() && sphere(one) != sphere(other);
    // `v_A` is the velocity of A; `v_1`, and a beside b, are what both equations make of them.
    let are_told = has_both || matches!([one.as_str(), other.as_str()], ["a", "b"]);
    if has_both && [one, other].iter().any(|letter| matches!(index(letter), Some('A' | 'B'))) {
        orders.truncate(1);
    }
    let signs = [[1.0, 1.0], [-1.0, 1.0], [1.0, -1.0], [-1.0, -1.0]];
    let usual = orders[0].clone();
    let of = |letters: &[String; 2]| {
        let is_unusual = *letters != usual;
        let is_against_numbers = is_unusual && are_told;
        signs.map(|signs| Convention { letters: letters.clone(), signs, is_unusual, is_against_numbers })
    };
    orders.iter().flat_map(of).collect()
}

/// The sphere that a letter names: `v_A`, `V_1`, `v_B'`, `v_Ax`.
pub(in crate::mark::working) fn sphere(letter: &str) -> Option<Sphere> {
    match index(letter)? {
        'A' | '1' => Some(Sphere::A),
        'B' | '2' => Some(Sphere::B),
        _ => None,
    }
}

/// What tells the sphere of a letter: its last sign before its primes, or the capital before that of a component or a moment.
fn index(letter: &str) -> Option<char> {
    let mut back = letter.trim_end_matches('\'').chars().rev();
    let (last, before, is_long) = (back.next()?, back.next()?, back.next().is_some());
    let is_told_before = is_long && matches!(before, 'A' | 'B') && !last.is_ascii_uppercase();
    Some(if is_told_before { before } else { last })
}
