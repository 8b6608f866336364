//! Velocities `a + b√2 + c√3 + d√6`, as those at 30, 45 and 60 degrees are: the rational matrix acts on a, b, c and d.

use super::matrix;
use crate::method::elements::Element;
use crate::method::needs::geometry_of;
use crate::method::{Geometry, Impact, Method, Prepared, Promise, Role, Skip};
use crate::number::{Root, Value};

/// Machine integers for each of 1, √2, √3 and √6.
pub(in crate::method) struct SurdIntegers;

/// 1, √2, √3 and √6.
pub(super) fn field() -> Vec<Element> {
    let both = [2, 3].map(Root::Prime);
    let roots = [&[][..], &both[..1], &both[1..], &both];
    roots.into_iter().map(|roots| (roots.into(), Vec::new())).collect()
}

/// The four, whatever the impact.
pub(in crate::method) fn elements(_: &Impact<Value>) -> Option<Vec<Element>> {
    Some(field())
}

/// The batch by a geometry.
pub(in crate::method) fn prepare(impacts: &[Impact<Value>], geometry: Geometry) -> Result<Box<dyn Prepared>, Skip> {
    matrix::prepare::<4>(impacts, geometry, elements, "a + b√2 + c√3 + d√6")
}

impl Method for SurdIntegers {
    fn name(&self) -> &'static str {
        "surd-integers"
    }

    fn role(&self) -> Role {
        Role::AnswerPath
    }

    fn accepts(&self) -> &'static str {
        "components a + b√2 + c√3 + d√6; rational e, ratio of masses and direction of the line of centres; not too large"
    }

    fn promises(&self) -> Promise {
        Promise::Exact
    }

    fn prepare(&self, impacts: &[Impact<Value>]) -> Result<Box<dyn Prepared>, Skip> {
        prepare(impacts, geometry_of(impacts))
    }
}
