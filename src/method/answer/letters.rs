//! Exact values of every kind, letters too: what a derivation is carried out in.

use crate::method::batch::{batch, exact};
use crate::method::needs::geometry_of;
use crate::method::{After, Geometry, Impact, Method, Prepared, Promise, Role, Skip};
use crate::number::Value;

/// Exact values, letters included.
pub(in crate::method) struct Letters;

/// The batch by a geometry.
pub(in crate::method) fn prepare(impacts: &[Impact<Value>], geometry: Geometry) -> Result<Box<dyn Prepared>, Skip> {
    let form = |impact: &Impact<Value>| Ok((impact.clone(), ()));
    batch(impacts, form, move |impact| geometry.solve(impact), |(), after: &Option<After<Value>>| exact(after.as_ref()))
}

impl Method for Letters {
    fn name(&self) -> &'static str {
        "letters"
    }

    fn role(&self) -> Role {
        Role::AnswerPath
    }

    fn accepts(&self) -> &'static str {
        "everything: fractions, surds, sines and cosines, letters"
    }

    fn promises(&self) -> Promise {
        Promise::Exact
    }

    fn prepare(&self, impacts: &[Impact<Value>]) -> Result<Box<dyn Prepared>, Skip> {
        prepare(impacts, geometry_of(impacts))
    }
}
