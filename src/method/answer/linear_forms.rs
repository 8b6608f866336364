//! Velocities `r cos α + s sin α`, or other sums of up to four things: the rational matrix acts on the coefficients.
//!
//! What the things are does not matter: cos 10° and sin 10°, cos α and sin α for a letter, √5, or a speed v. As r and s are
//! exact, so is a nought among them: a sphere that stops along the line of centres at 10 degrees has stopped.

use super::matrix;
use crate::method::elements::{Element, coefficients};
use crate::method::needs::geometry_of;
use crate::method::{Geometry, Impact, Method, Prepared, Promise, Role, Skip};
use crate::number::Value;

/// Machine integers for each of up to four things.
pub(in crate::method) struct LinearForms;

/// The most things.
const MOST: usize = 4;

/// What the velocities are sums of, if of no more than four things.
pub(in crate::method) fn elements(impact: &Impact<Value>) -> Option<Vec<Element>> {
    let mut elements: Vec<Element> = Vec::new();
    for component in impact.before.as_flattened() {
        for (element, _) in coefficients(component)? {
            if !elements.contains(&element) {
                elements.push(element);
            }
        }
    }
    (elements.len() <= MOST).then_some(elements)
}

/// The batch by a geometry.
pub(in crate::method) fn prepare(impacts: &[Impact<Value>], geometry: Geometry) -> Result<Box<dyn Prepared>, Skip> {
    let named = "a sum of at most four things";
    let counts = impacts.iter().map(|impact| elements(impact).map_or(MOST, |elements| elements.len()));
    match counts.max() {
        Some(0..=2) => matrix::prepare::<2>(impacts, geometry, elements, named),
        _ => matrix::prepare::<MOST>(impacts, geometry, elements, named),
    }
}

impl Method for LinearForms {
    fn name(&self) -> &'static str {
        "linear-forms"
    }

    fn role(&self) -> Role {
        Role::AnswerPath
    }

    fn accepts(&self) -> &'static str {
        "components r cos α + s sin α, or of at most four other things; rational e, ratio of masses and direction of the line of centres; not too large"
    }

    fn promises(&self) -> Promise {
        Promise::Exact
    }

    fn prepare(&self, impacts: &[Impact<Value>]) -> Result<Box<dyn Prepared>, Skip> {
        prepare(impacts, geometry_of(impacts))
    }
}
