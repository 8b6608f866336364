//! What a question of several impacts gives besides the impact that is looked through: who takes a number from there has
//! not copied one wrongly.

use super::equations::numbers;
use super::numbers::Points;
use crate::expr::{Expr, written};
use crate::mechanics::Scene;
use crate::number::Value;

/// The numbers of a question in all of its impacts.
#[derive(Clone, Debug, Default)]
pub(in crate::mark) struct Elsewhere {
    /// For masses.
    pub(super) masses: Vec<Expr>,
    /// Coefficients of restitution, numbers or letters.
    pub(super) restitutions: Vec<Expr>,
    /// The velocities of earlier impacts, before and after them, as far as they are known.
    velocities: Vec<Value>,
    /// Those with which this impact begins.
    begins: Vec<Value>,
}

impl Elsewhere {
    /// Those of a scene and of those that follow it.
    pub(in crate::mark) fn of(scene: &Scene) -> Elsewhere {
        let mut all = Elsewhere::default();
        let scenes = std::iter::once(scene).chain(scene.then.iter().map(|then| &then.scene));
        for scene in scenes {
            all.masses.extend(scene.masses.iter().flatten().flat_map(|mass| numbers(&mass.shown)));
            all.restitutions.extend(scene.restitution.iter().map(|given| given.shown.clone()));
        }
        all
    }

    /// The same for an impact that begins with some velocities, and before which there were others.
    pub(in crate::mark) fn at(&self, begins: Vec<Value>, velocities: Vec<Value>) -> Elsewhere {
        Elsewhere { begins, velocities, ..self.clone() }
    }

    /// The sizes of the velocities with which this impact begins, as numbers.
    pub(super) fn carried(&self) -> Vec<Expr> {
        let size = |value: &Value| match written(value) {
            Expr::Number(number) => Some(Expr::Number(number.abs())),
            _ => None,
        };
        self.begins.iter().filter(|value| !value.is_zero()).filter_map(size).collect()
    }

    /// The sizes of the velocities that are the same at every point.
    pub(super) fn speeds(&self, points: &Points) -> Vec<f64> {
        let constant = self.velocities.iter().filter(|value| value.is_constant());
        constant.filter_map(|value| Some(points.value(value, 0)?.abs())).collect()
    }
}
