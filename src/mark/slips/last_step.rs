//! Mistakes in the last line, which need no law: something else is handed in, or the right figures wrongly.

use crate::mechanics::{Axis, Moment, Quantity, Sphere};

/// A mistake in the last line.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::mark) struct LastStep {
    pub(in crate::mark) tag: &'static str,
    pub(super) did: &'static str,
    pub(in crate::mark) sentence: &'static str,
}

pub(super) const SIGN: LastStep = LastStep {
    tag: "wrong-sign",
    did: "gave the opposite sign",
    sentence: "The size is right and the sense is opposite: check which way is positive.",
};
pub(super) const FACTOR_OF_TEN: LastStep = LastStep {
    tag: "factor-of-ten",
    did: "put the decimal point elsewhere",
    sentence: "The figures are right and the decimal point is not.",
};
pub(super) const RADIANS: LastStep = LastStep {
    tag: "angle-in-radians",
    did: "gave the angle in radians",
    sentence: "That is the angle in radians: set your calculator to degrees.",
};
pub(in crate::mark) const OTHER_SPHERE: LastStep = LastStep {
    tag: "other-sphere",
    did: "gave the value of the other sphere",
    sentence: "That belongs to the other sphere: check which of the two is asked for.",
};
pub(super) const ONE_COMPONENT: LastStep = LastStep {
    tag: "one-component",
    did: "gave a component for the speed",
    sentence: "That is one component of the velocity: the speed is made of both.",
};
pub(super) const BEFORE_FOR_AFTER: LastStep = LastStep {
    tag: "before-for-after",
    did: "gave the value before the impact",
    sentence: "That is the value before the impact: the one after it is asked for.",
};
pub(super) const ONE_SIGN: LastStep = LastStep {
    tag: "sign-of-one",
    did: "gave one component of a vector the opposite sign",
    sentence: "One component has the opposite sign: check which way each of them points.",
};
pub(super) const NOT_RECOMBINED: LastStep = LastStep {
    tag: "not-recombined",
    did: "gave the components along the line of centres and across it for those along i and j",
    sentence: "Those are the components along the line of centres and perpendicular to the line of centres: multiply each by its unit vector and add.",
};
pub(super) const AXIS_ASSUMED: LastStep = LastStep {
    tag: "axis-assumed",
    did: "took a wall that slants to be parallel to i or j",
    sentence: "The wall is parallel to neither i nor j: resolve the velocity along the wall and perpendicular to it first.",
};
pub(super) const NOTHING_TURNED_BACK: LastStep = LastStep {
    tag: "not-turned-back",
    did: "multiplied the component along a wall by e, and let the one perpendicular to it stay",
    sentence: "A wall turns back the component perpendicular to it, times e; the one along the wall is unchanged.",
};
pub(super) const ENERGY_AT_ONE_MOMENT: LastStep = LastStep {
    tag: "energy-not-lost",
    did: "gave the energy before or after the impact for the loss",
    sentence: "That is the kinetic energy at one moment: the loss is the energy before less the energy after.",
};
pub(super) const LOSS_FOR_FRACTION: LastStep = LastStep {
    tag: "loss-for-fraction",
    did: "gave the energy lost for the fraction",
    sentence: "That is the energy lost: divide it by the energy before the impact.",
};
pub(in crate::mark) const ANOTHER_ANSWER: LastStep = LastStep {
    tag: "another-answer",
    did: "gave the answer to another part",
    sentence: "That answers another part of the question.",
};

/// All of them: first what is right but for its form, then what is something else.
pub(super) const ALL: [LastStep; 13] = [
    SIGN,
    FACTOR_OF_TEN,
    RADIANS,
    OTHER_SPHERE,
    ONE_COMPONENT,
    BEFORE_FOR_AFTER,
    NOT_RECOMBINED,
    AXIS_ASSUMED,
    NOTHING_TURNED_BACK,
    ONE_SIGN,
    ENERGY_AT_ONE_MOMENT,
    LOSS_FOR_FRACTION,
    ANOTHER_ANSWER,
];

/// How many of [`ALL`] are right but for their form.
pub(super) const OF_FORM: usize = 3;

/// What may be handed in for a quantity, and which mistake that is.
pub(super) fn taken_for(quantity: Quantity) -> Vec<(Quantity, LastStep)> {
    let taken = of_one_impact(quantity.of_its_impact()).into_iter();
    taken.filter_map(|(other, step)| Some((other.in_impact(quantity.impact())?, step))).collect()
}

fn of_one_impact(quantity: Quantity) -> Vec<(Quantity, LastStep)> {
    use Moment::{After, Before};
    let mut taken = Vec::new();
    if let Some(other) = of_other_sphere(quantity) {
        taken.push((other, OTHER_SPHERE));
    }
    match quantity {
        Quantity::Speed(sphere, After) => {
            // The component along the line of centres is what is left when the other is dropped, a slip with a law.
            taken.push((Quantity::Velocity(sphere, After, Axis::T), ONE_COMPONENT));
            taken.push((Quantity::Speed(sphere, Before), BEFORE_FOR_AFTER));
        }
        Quantity::Velocity(sphere, After, axis) => {
            taken.push((Quantity::Velocity(sphere, Before, axis), BEFORE_FOR_AFTER));
        }
        Quantity::AngleToLine(sphere, After) => {
            taken.push((Quantity::AngleToLine(sphere, Before), BEFORE_FOR_AFTER));
        }
        Quantity::EnergyLost => {
            taken.extend([Before, After].map(|moment| (Quantity::TotalEnergy(moment), ENERGY_AT_ONE_MOMENT)));
        }
        Quantity::SphereEnergyLost(sphere) | Quantity::SphereEnergyGained(sphere) => {
            taken.extend([Before, After].map(|moment| (Quantity::KineticEnergy(sphere, moment), ENERGY_AT_ONE_MOMENT)));
        }
        Quantity::FractionLost => taken.push((Quantity::EnergyLost, LOSS_FOR_FRACTION)),
        _ => {}
    }
    taken
}

/// The same of the other sphere.
fn of_other_sphere(quantity: Quantity) -> Option<Quantity> {
    use Quantity::{
        AngleToLine, Deflection, KineticEnergy, Speed, SphereEnergyGained, SphereEnergyLost, TanDeflection, TanToLine,
        Velocity,
    };
    let other = Sphere::other;
    Some(match quantity {
        Speed(sphere, moment) => Speed(other(sphere), moment),
        Velocity(sphere, moment, axis) => Velocity(other(sphere), moment, axis),
        KineticEnergy(sphere, moment) => KineticEnergy(other(sphere), moment),
        SphereEnergyLost(sphere) => SphereEnergyLost(other(sphere)),
        SphereEnergyGained(sphere) => SphereEnergyGained(other(sphere)),
        AngleToLine(sphere, moment) => AngleToLine(other(sphere), moment),
        TanToLine(sphere, moment) => TanToLine(other(sphere), moment),
        Deflection(sphere) => Deflection(other(sphere)),
        TanDeflection(sphere) => TanDeflection(other(sphere)),
        _ => return None,
    })
}

/// Is the sign of the quantity part of the answer?
pub(super) fn has_a_sense(quantity: Quantity) -> bool {
    use Quantity::{Impulse, SignedDeflection, SphereMomentum, TOverN, TanDeflection, TotalMomentum, Velocity};
    matches!(
        quantity,
        Velocity(..)
            | Impulse(..)
            | SphereMomentum(..)
            | TotalMomentum(_)
            | TOverN(..)
            | TanDeflection(_)
            | SignedDeflection(_)
            | Quantity::AngleFromN(..)
            | Quantity::AngleFromI(..)
    )
}
