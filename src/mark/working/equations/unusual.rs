//! Letters for velocities that are usual for something else: `λ` and `μ`, `α` and `β`.

use super::offered::{Offered, may_be_velocity};
use super::substituted::is_impulse;

/// The equations of which all unknowns are velocities, and the others.
pub(super) fn of_velocities(offered: Vec<Offered>) -> (Vec<Offered>, Vec<Offered>) {
    let unusual = unusual_pair(&offered);
    let is_of = |offered: &Offered| {
        let unknowns = &offered.linear[0].unknowns;
        !unknowns.is_empty() && unknowns.iter().all(|(name, _)| unusual.contains(name))
    };
    offered.into_iter().partition(|offered| offered.is_of_velocities() || is_of(offered))
}

/// Two such letters, of which one equation has the sum and another the difference, as the two laws have; nothing if there are none.
fn unusual_pair(offered: &[Offered]) -> Vec<String> {
    let pairs = || offered.iter().filter_map(pair);
    let has_other_sign =
        |(names, is_sum): &([&str; 2], bool)| pairs().any(|(other, sign)| other == *names && sign != *is_sum);
    let found = pairs().find(has_other_sign).map(|(names, _)| names.map(str::to_owned).to_vec());
    found.unwrap_or_default()
}

/// The two letters of an equation that are usual for something else, and whether it has their sum or their difference.
fn pair(offered: &Offered) -> Option<([&str; 2], bool)> {
    let [(one, first), (other, second)] = offered.linear[0].unknowns.as_slice() else { return None };
    let (first, second) = (first.middle(), second.middle());
    let is_sum = first * second > 0.0;
    let is_difference = (first + second).abs() < 1e-9 * first.abs();
    let is_unusual = is_impulse(one) == is_impulse(other) && !(may_be_velocity(one) && may_be_velocity(other));
    let names = if one < other { [one.as_str(), other] } else { [other.as_str(), one] };
    (is_unusual && (is_sum || is_difference)).then_some((names, is_sum))
}
