//! Fractions as machine integers over one denominator: most impacts of an exam, as quick as in floating point.

use super::matrix;
use crate::method::elements::Element;
use crate::method::needs::geometry_of;
use crate::method::{Geometry, Impact, Method, Prepared, Promise, Role, Skip};
use crate::number::Value;

/// Machine integers over one denominator.
pub(in crate::method) struct Integers;

/// A fraction is a multiple of one.
pub(in crate::method) fn elements(_: &Impact<Value>) -> Option<Vec<Element>> {
    Some(vec![Element::default()])
}

/// The batch by a geometry.
pub(in crate::method) fn prepare(impacts: &[Impact<Value>], geometry: Geometry) -> Result<Box<dyn Prepared>, Skip> {
    matrix::prepare::<1>(impacts, geometry, elements, "a fraction")
}

impl Method for Integers {
    fn name(&self) -> &'static str {
        "integers"
    }

    fn role(&self) -> Role {
        Role::AnswerPath
    }

    fn accepts(&self) -> &'static str {
        "rational components, e, ratio of masses and direction of the line of centres, if they are not too large"
    }

    fn promises(&self) -> Promise {
        Promise::Exact
    }

    fn prepare(&self, impacts: &[Impact<Value>]) -> Result<Box<dyn Prepared>, Skip> {
        prepare(impacts, geometry_of(impacts))
    }
}
