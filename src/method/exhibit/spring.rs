//! Contact simulated in time: a linear spring and a dashpot between the spheres while they overlap.
//!
//! The dashpot is chosen so that a head-on contact ends with the given coefficient of restitution. Half of the contact time
//! is the exact damped oscillation's: `t = π/ω`. While they touch, the line of centres turns with the spheres, so an oblique
//! impact is right only in the limit of a short contact, whatever the steps.

use super::{NO_APPROACH, approach};
use crate::method::batch::{LETTERS_ARE_NO_FLOATS, batch, float};
use crate::method::{After, Found, Impact, Method, Prepared, Promise, Role, Skip};
use crate::number::Value;

/// How motion is advanced by one step.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Integrator {
    /// Half a step of velocity, a step of place, half a step of velocity.
    Verlet,
    /// Four slopes a step.
    RungeKutta,
}

/// A contact by spring and dashpot. Radii add up to one metre.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Spring {
    /// How motion is advanced.
    pub integrator: Integrator,
    /// Steps in the time that a head-on contact takes.
    pub steps: u32,
    /// How long a head-on contact takes, in seconds.
    pub contact: f64,
}

impl Spring {
    /// A thousand steps of Verlet in a tenth of a millisecond of contact.
    pub const VERLET: Spring = Spring { integrator: Integrator::Verlet, steps: 1000, contact: 1e-4 };
    /// A thousand steps of Runge and Kutta.
    pub const RUNGE_KUTTA: Spring = Spring { integrator: Integrator::RungeKutta, ..Spring::VERLET };
}

impl Method for Spring {
    fn name(&self) -> &'static str {
        match self.integrator {
            Integrator::Verlet => "spring-verlet",
            Integrator::RungeKutta => "spring-runge-kutta",
        }
    }

    fn role(&self) -> Role {
        Role::Exhibit
    }

    fn accepts(&self) -> &'static str {
        "all nine numbers without letters, spheres that approach, e above nought"
    }

    fn promises(&self) -> Promise {
        Promise::Nothing("steps of time and a contact that takes time each cost figures")
    }

    fn prepare(&self, impacts: &[Impact<Value>]) -> Result<Box<dyn Prepared>, Skip> {
        let setting = *self;
        let form = |impact: &Impact<Value>| {
            let floats = impact.in_floats().ok_or(LETTERS_ARE_NO_FLOATS)?;
            if floats.restitution > 0.0 {
                Ok((floats, ()))
            } else {
                Err("no dashpot stops spheres with e = 0".to_owned())
            }
        };
        batch(
            impacts,
            form,
            move |impact| setting.solve(impact),
            |(), after: &Option<After<f64>>| match after {
                Some(after) => float(*after),
                None => Found::Missed(format!("{NO_APPROACH}, or the contact did not end")),
            },
        )
    }
}

/// Place and velocity of B as seen from A.
type State = [[f64; 2]; 2];

/// Stiffness and damping over the reduced mass.
struct Contact {
    stiffness: f64,
    damping: f64,
}

impl Contact {
    /// The force over the reduced mass.
    fn pull(&self, [place, velocity]: State) -> [f64; 2] {
        let distance = place[0].hypot(place[1]);
        let unit = place.map(|component| component / distance);
        let parting = velocity[0] * unit[0] + velocity[1] * unit[1];
        let size = self.stiffness * (1.0 - distance) - self.damping * parting;
        unit.map(|component| component * size)
    }

    fn slope(&self, state: State) -> State {
        [state[1], self.pull(state)]
    }
}

/// One state and a multiple of a slope.
fn onwards(state: State, slope: State, step: f64) -> State {
    let add = |one: [f64; 2], other: [f64; 2]| [one[0] + step * other[0], one[1] + step * other[1]];
    [add(state[0], slope[0]), add(state[1], slope[1])]
}

impl Spring {
    fn solve(self, impact: &Impact<f64>) -> Option<After<f64>> {
        let (line, _) = approach(impact)?;
        let [a, b] = impact.before;
        // e = exp(-c t/2) with t = π/ω and ω² = k - c²/4, over the reduced mass.
        let damping = -2.0 * impact.restitution.ln() / self.contact;
        let turning = std::f64::consts::PI / self.contact;
        let contact = Contact { stiffness: turning * turning + damping * damping / 4.0, damping };
        let step = self.contact / f64::from(self.steps);
        let start = [line, [b[0] - a[0], b[1] - a[1]]];
        let mut state = start;
        // An oblique contact takes longer than a head-on one, but not for ever.
        for _ in 0..self.steps.saturating_mul(20) {
            state = match self.integrator {
                Integrator::Verlet => verlet(&contact, state, step),
                Integrator::RungeKutta => runge_kutta(&contact, state, step),
            };
            if state[0][0].hypot(state[0][1]) >= 1.0 {
                let change = [state[1][0] - start[1][0], state[1][1] - start[1][1]];
                let [m_a, m_b] = impact.masses;
                let (of_a, of_b) = (m_b / (m_a + m_b), m_a / (m_a + m_b));
                let after_a = [a[0] - of_a * change[0], a[1] - of_a * change[1]];
                return Some([after_a, [b[0] + of_b * change[0], b[1] + of_b * change[1]]]);
            }
        }
        None
    }
}

fn verlet(contact: &Contact, [place, velocity]: State, step: f64) -> State {
    let pull = contact.pull([place, velocity]);
    let half = [velocity[0] + step / 2.0 * pull[0], velocity[1] + step / 2.0 * pull[1]];
    let place = [place[0] + step * half[0], place[1] + step * half[1]];
    let pull = contact.pull([place, half]);
    [place, [half[0] + step / 2.0 * pull[0], half[1] + step / 2.0 * pull[1]]]
}

fn runge_kutta(contact: &Contact, state: State, step: f64) -> State {
    let first = contact.slope(state);
    let second = contact.slope(onwards(state, first, step / 2.0));
    let third = contact.slope(onwards(state, second, step / 2.0));
    let fourth = contact.slope(onwards(state, third, step));
    let sum = onwards(onwards(onwards(first, second, 2.0), third, 2.0), fourth, 1.0);
    onwards(state, sum, step / 6.0)
}
