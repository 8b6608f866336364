//! Velocities by simulations, which k makes better and not worse: more steps, or more looks.

use crate::method::Method;
use crate::method::exhibit::{FixedStep, Integrator, Spring};
use crate::study::double::Outcome;
use crate::study::impacts::{in_values, ordinary, truth};
use crate::study::map::{Arrangement, Dealer, Subject};
use crate::study::velocities::{Scale, outcome};
use crate::study::work::CONTACT;

/// A contact that is followed through.
pub const STEPS: Subject = Subject {
    name: "simulated-contact",
    quantity: "velocities, by a contact followed through",
    regime: "10ᵏ steps in the contact",
    exponents: (1, 4),
    arrangements: &[
        Arrangement { name: "spring-verlet", says: "spring and dashpot, by Verlet's half steps" },
        Arrangement { name: "spring-runge-kutta", says: "spring and dashpot, by four slopes a step" },
    ],
    scene: |k, deal| {
        let spring = |integrator| Spring { integrator, steps: 10u32.pow(k), contact: CONTACT };
        outcomes(deal, [&spring(Integrator::Verlet), &spring(Integrator::RungeKutta)])
    },
};

/// A contact that is noticed late.
pub const LOOKS: Subject = Subject {
    name: "simulated-detection",
    quantity: "velocities, by looking for contact",
    regime: "10ᵏ looks a second",
    exponents: (2, 6),
    arrangements: &[Arrangement { name: "fixed-step", says: "the line of centres as it is at the next look" }],
    scene: |k, deal| {
        let step = 1.0 / f64::from(10u32.pow(k));
        outcomes(deal, [&FixedStep { step, ..FixedStep::USUAL }])
    },
};

fn outcomes<const N: usize>(deal: &mut Dealer, methods: [&dyn Method; N]) -> Vec<Outcome> {
    let impact = ordinary(deal);
    let truth = truth(&impact);
    methods.map(|method| outcome(method, &in_values(&impact), &truth, Scale::Largest)).to_vec()
}
