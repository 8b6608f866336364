//! Fractions in lowest terms without a largest one: for impacts that outgrow machine integers.

use crate::method::batch::{batch, exact};
use crate::method::needs::geometry_of;
use crate::method::{After, Geometry, Impact, Method, Prepared, Promise, Role, Skip};
use crate::number::Value;

/// Fractions of any size.
pub(in crate::method) struct Fractions;

/// The batch by a geometry.
pub(in crate::method) fn prepare(impacts: &[Impact<Value>], geometry: Geometry) -> Result<Box<dyn Prepared>, Skip> {
    let form = |impact: &Impact<Value>| {
        // Masses in the ratio of fractions, and any vector along the line, do as well as those that were given.
        let factors =
            impact.proportions().ok_or("the masses, e and the line of centres are not in rational proportion")?;
        let rational = |value: &Value| value.as_fraction().is_some().then(|| value.clone());
        let [a, b] = &impact.before;
        let before = [[&a[0], &a[1]], [&b[0], &b[1]]].map(|velocity| velocity.map(rational));
        match before {
            [[Some(a_x), Some(a_y)], [Some(b_x), Some(b_y)]] => {
                let [masses, line] = [factors.masses, factors.line].map(|pair| pair.map(Value::from));
                Ok((Impact { masses, before: [[a_x, a_y], [b_x, b_y]], line, restitution: factors.e.into() }, ()))
            }
            _ => Err("a component of a velocity is no fraction".to_owned()),
        }
    };
    batch(impacts, form, move |impact| geometry.solve(impact), |(), after: &Option<After<Value>>| exact(after.as_ref()))
}

impl Method for Fractions {
    fn name(&self) -> &'static str {
        "fractions"
    }

    fn role(&self) -> Role {
        Role::AnswerPath
    }

    fn accepts(&self) -> &'static str {
        "rational components, e, ratio of masses and direction of the line of centres, of any size"
    }

    fn promises(&self) -> Promise {
        Promise::Exact
    }

    fn prepare(&self, impacts: &[Impact<Value>]) -> Result<Box<dyn Prepared>, Skip> {
        prepare(impacts, geometry_of(impacts))
    }
}
