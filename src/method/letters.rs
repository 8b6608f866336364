//! Exact values of every kind, letters too: what a derivation is carried out in.

use super::batch::batch;
use super::kernel::any_line;
use super::{After, Found, Impact, Method, Prepared, Promise, Role, Skip};
use crate::number::Value;

/// Exact values, letters included.
pub(super) struct Letters;

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
        batch(
            impacts,
            |impact| Ok(impact.clone()),
            any_line,
            |_, after: &Option<After<Value>>| match after {
                Some(after) => Found::Exact(after.clone()),
                None => Found::Missed("a quotient by a sum of many roots is not carried out".to_owned()),
            },
        )
    }
}
