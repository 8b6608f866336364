//! The place of a quantity among all quantities: a number, so that quantities can be looked up as numbers are.

use super::{Axis, Moment, Quantity, Sphere};

/// The first place that no quantity of the first impact has, nor what says which impacts there are; the quantities of each
/// later impact have as many places.
pub(super) const OF_AN_IMPACT: usize = 256;

impl Quantity {
    /// Its place. Places are in the order in which quantities are declared, and no two quantities share one.
    #[inline(always)] // of a quantity that a law names it is known before the program runs
    pub(super) fn place(self) -> usize {
        use Quantity::*;
        let of = |first: usize, sphere: Sphere| first + sphere as usize;
        let at = |first: usize, sphere: Sphere, moment: Moment| first + 2 * sphere as usize + moment as usize;
        let along = |first: usize, sphere: Sphere, moment: Moment, axis: Axis| {
            first + 4 * at(0, sphere, moment) + axis as usize
        };
        match self {
            Mass(sphere) => of(0, sphere),
            Velocity(sphere, moment, axis) => along(3, sphere, moment, axis),
            Speed(sphere, moment) => at(27, sphere, moment),
            KineticEnergy(sphere, moment) => at(33, sphere, moment),
            SphereMomentum(sphere, moment, axis) => along(39, sphere, moment, axis),
            AngleToLine(sphere, moment) => at(63, sphere, moment),
            AngleFromN(sphere, moment) => at(69, sphere, moment),
            AngleFromI(sphere, moment) => at(75, sphere, moment),
            TanToLine(sphere, moment) => at(81, sphere, moment),
            TOverN(sphere, moment) => at(87, sphere, moment),
            AngleToWall(sphere, moment) => at(93, sphere, moment),
            TanToWall(sphere, moment) => at(99, sphere, moment),
            Deflection(sphere) => of(105, sphere),
            SignedDeflection(sphere) => of(108, sphere),
            DeflectionCross(sphere) => of(111, sphere),
            DeflectionDot(sphere) => of(114, sphere),
            TanDeflection(sphere) => of(117, sphere),
            Impulse(sphere, axis) => 120 + 4 * sphere as usize + axis as usize,
            SphereEnergyLost(sphere) => of(132, sphere),
            SphereEnergyGained(sphere) => of(135, sphere),
            ImpulseMagnitude => 138,
            ImpulseAngle => 139,
            Approach => 140,
            Separation => 141,
            Restitution => 142,
            MassRatio => 143,
            Line(axis) => 144 + axis as usize,
            Tangent(axis) => 148 + axis as usize,
            TotalEnergy(moment) => 152 + moment as usize,
            EnergyLost => 154,
            FractionLost => 155,
            TotalMomentum(axis) => 156 + axis as usize,
            AngleBetween(moment) => 160 + moment as usize,
            Alpha => 162,
            GivenDirection(sphere, moment) => at(163, sphere, moment),
            GivenImpulse(axis) => 169 + axis as usize,
            ContactSine => 173,
            MomentumEquation => 174,
            RestitutionEquation => 175,
            InALine => 176,
            Meeting(meeting) => {
                let [first, second] = meeting.of.map(|sphere| sphere as usize);
                177 + 2 * (3 * (3 * usize::from(meeting.number) + first) + second) + usize::from(meeting.with_wall)
            }
            Later(later) => later.place_among_all(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::Meeting;
    use super::*;

    #[test]
    fn places_are_in_the_order_of_the_quantities_and_no_two_are_one() {
        let first = Quantity::of_an_impact();
        let later = (1..4).flat_map(|number| first.iter().filter_map(move |quantity| quantity.in_impact(number)));
        let pairs = Sphere::ALL.into_iter().flat_map(|one| Sphere::ALL.map(|other| [one, other]));
        let walls = pairs.flat_map(|of| [false, true].map(|with_wall| (of, with_wall)));
        let meetings = walls.flat_map(|(of, with_wall)| (1..4).map(move |number| Meeting { number, of, with_wall }));
        let mut all: Vec<Quantity> = first.clone();
        all.extend(later);
        all.extend(meetings.map(Quantity::Meeting));
        all.push(Quantity::InALine);
        all.sort();
        let places: Vec<usize> = all.iter().map(|quantity| quantity.place()).collect();
        assert!(places.windows(2).all(|pair| pair[0] < pair[1]), "{places:?}");
    }
}
