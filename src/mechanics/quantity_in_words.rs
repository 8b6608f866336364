//! What a quantity is called in words, as a mark scheme says it.

use super::{Axis, Moment, Quantity};

impl Quantity {
    /// The quantity in the markup of the bank, as between two spheres: `speed of *A*`. What is found after the impact is not
    /// said to be after it.
    pub fn in_words(self) -> String {
        let before = |moment| if moment == Moment::Before { " before" } else { "" };
        let along = |axis| match axis {
            Axis::N => "along the line of centres",
            Axis::T => "perpendicular to the line of centres",
            Axis::X => "along {i}",
            Axis::Y => "along {j}",
        };
        match self.of_its_impact() {
            Quantity::Mass(sphere) => format!("mass of *{}*", sphere.name()),
            Quantity::Velocity(sphere, moment, axis) => {
                format!("component of the velocity of *{}*{} {}", sphere.name(), before(moment), along(axis))
            }
            Quantity::Speed(sphere, moment) => format!("speed of *{}*{}", sphere.name(), before(moment)),
            Quantity::KineticEnergy(sphere, moment) => format!("kinetic energy of *{}* {moment}", sphere.name()),
            Quantity::SphereMomentum(sphere, moment, axis) => {
                format!("momentum of *{}*{} {}", sphere.name(), before(moment), along(axis))
            }
            Quantity::AngleToLine(sphere, moment)
            | Quantity::AngleFromN(sphere, moment)
            | Quantity::AngleFromI(sphere, moment)
            | Quantity::AngleToWall(sphere, moment)
            | Quantity::GivenDirection(sphere, moment) => format!("direction of *{}*{}", sphere.name(), before(moment)),
            Quantity::TOverN(sphere, _) | Quantity::TanToLine(sphere, _) => {
                format!("tangent of the angle of *{}* to the line of centres", sphere.name())
            }
            Quantity::TanToWall(sphere, _) => format!("tangent of the angle of *{}* to the wall", sphere.name()),
            Quantity::TanDeflection(sphere) => format!("tangent of the deflection of *{}*", sphere.name()),
            Quantity::Deflection(sphere)
            | Quantity::SignedDeflection(sphere)
            | Quantity::DeflectionCross(sphere)
            | Quantity::DeflectionDot(sphere) => format!("deflection of *{}*", sphere.name()),
            Quantity::Impulse(sphere, _) => format!("impulse on *{}*", sphere.name()),
            Quantity::SphereEnergyLost(sphere) => format!("kinetic energy that *{}* loses", sphere.name()),
            Quantity::SphereEnergyGained(sphere) => format!("kinetic energy that *{}* gains", sphere.name()),
            Quantity::ImpulseMagnitude => "magnitude of the impulse".to_owned(),
            Quantity::ImpulseAngle => "direction of the impulse".to_owned(),
            Quantity::GivenImpulse(axis) => format!("impulse {}", along(axis)),
            Quantity::Approach => "speed of approach along the line of centres".to_owned(),
            Quantity::Separation => "speed of separation along the line of centres".to_owned(),
            Quantity::Restitution => "coefficient of restitution".to_owned(),
            Quantity::MassRatio => "ratio of the masses".to_owned(),
            Quantity::Line(_) => "line of centres".to_owned(),
            Quantity::Tangent(_) => "common tangent".to_owned(),
            Quantity::TotalEnergy(moment) => format!("kinetic energy {moment}"),
            Quantity::EnergyLost => "kinetic energy lost".to_owned(),
            Quantity::FractionLost => "fraction of the kinetic energy lost".to_owned(),
            Quantity::TotalMomentum(axis) => format!("momentum {}", along(axis)),
            Quantity::AngleBetween(moment) => format!("angle between the velocities {moment}"),
            Quantity::Alpha => "angle of the relative velocity to the line of centres".to_owned(),
            other => other.to_string(),
        }
    }

    /// The same without any markup: `speed of A`.
    pub fn in_plain_words(self) -> String {
        self.in_words().replace(['*', '{', '}'], "")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_quantity_that_has_a_name_in_files_is_called_by_it() {
        for quantity in Quantity::all() {
            let words = quantity.in_plain_words();
            assert!(!words.contains(['.', '_']) && words != quantity.to_string(), "{words}");
        }
    }
}
