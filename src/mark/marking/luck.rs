//! Right values that follow from wrong ones: the energy that is lost cannot see restitution the wrong way round.

use crate::mark::key::{KeyedMark, KeyedPart, KeyedQuestion};
use crate::mark::working::Examined;
use crate::mechanics::{Moment, Quantity, Sphere};

/// How far two sizes may be apart and still be one, in parts of themselves: figures are rounded.
const NEAR: f64 = 0.01;

/// For each mark: is it for an energy that comes out right from the student's own velocities after the impact, of which
/// neither is right?
pub(super) fn is_by_luck(question: &KeyedQuestion, part: &KeyedPart, examined: &Examined) -> Vec<bool> {
    let is_wrong = |of: Sphere| {
        let is_velocity = |quantity: &Quantity| {
            matches!(*quantity, Quantity::Velocity(sphere, Moment::After, _) | Quantity::Speed(sphere, Moment::After)
                if sphere == of)
        };
        let mut own = examined.theirs.values.iter().filter(|(quantity, _)| is_velocity(quantity));
        own.any(|(quantity, (values, _))| {
            let right = question.prepared().known_sizes(*quantity);
            right.is_some_and(|right| !are_near(values, &right))
        })
    };
    let are_wrong = Sphere::BOTH.into_iter().all(is_wrong);
    let is_lucky = |quantity: &Quantity| {
        let is_energy = matches!(quantity.of_its_impact(), Quantity::EnergyLost | Quantity::FractionLost);
        let [own, right] = [examined.followed(question, *quantity), question.prepared().known_sizes(*quantity)];
        is_energy && own.zip(right).is_some_and(|(own, right)| are_near(&own, &right))
    };
    let is_for_lucky = |mark: &KeyedMark| mark.code.is_accuracy() && mark.earned_for.quantities().iter().any(is_lucky);
    part.scheme.iter().map(|mark| are_wrong && is_for_lucky(mark)).collect()
}

/// Are they of one size at every point, whatever their signs?
fn are_near(own: &[f64], right: &[f64]) -> bool {
    let near = |(own, right): (&f64, &f64)| (own.abs() - right.abs()).abs() <= NEAR * right.abs();
    own.iter().zip(right).all(near)
}
