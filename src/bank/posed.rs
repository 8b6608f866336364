//! A question with numbers in it: its scene read and solved.

use std::sync::Arc;

use super::givens::Givens;
use super::question::{Question, Style};
use crate::expr::{Angles, Fault, Meaning, Turn};
use crate::mechanics::{Quantity, Refusal, Scene, SceneFault};
use crate::number::{Angle, Range, Value};
use crate::solve::{Solution, solve, solve_all};

/// A question with numbers in it, solved for all that it asks and requires. Styles that have the same numbers share it.
#[derive(Clone, Debug)]
pub struct Posed {
    /// What its names stand for.
    pub givens: Arc<Givens>,
    /// The collision.
    pub scene: Arc<Scene>,
    /// Its solution.
    pub solution: Arc<Solution>,
}

/// Why numbers do not make a question.
#[derive(Clone, Debug)]
pub enum Unposed {
    /// A derived name has no value.
    Given(String, Fault),
    /// Formulas of the scene have no value.
    Scene(Vec<SceneFault>),
    /// It cannot happen, or cannot be found.
    Refused(Refusal),
}

impl Posed {
    /// Solves a question for the quantities that it asks for and those that its requirements name.
    ///
    /// # Errors
    ///
    /// Why these numbers do not make a question that can be solved.
    pub fn new(question: &Question, style: &Style, givens: Givens) -> Result<Posed, Unposed> {
        Posed::for_wanted(question, &question.wanted(style), Arc::new(givens))
    }

    /// The same for quantities that are known: those that [`Question::wanted`] tells.
    ///
    /// # Errors
    ///
    /// As for [`Posed::new`].
    pub fn for_wanted(question: &Question, wanted: &[Quantity], givens: Arc<Givens>) -> Result<Posed, Unposed> {
        let scene = Scene::read(&question.scene, &*givens, Angles::Degrees).map_err(Unposed::Scene)?;
        let scene = Arc::new(scene);
        let solution = solve(Arc::clone(&scene), wanted).map_err(Unposed::Refused)?;
        Ok(Posed { givens, scene, solution: Arc::new(solution) })
    }

    /// The same with no more than what is determined, where something that is wanted is left open; nothing if there is more
    /// than one solution.
    ///
    /// # Errors
    ///
    /// As for [`Posed::new`].
    pub fn as_far_as_determined(
        question: &Question,
        wanted: &[Quantity],
        givens: Arc<Givens>,
    ) -> Result<Option<Posed>, Unposed> {
        let scene = Scene::read(&question.scene, &*givens, Angles::Degrees).map_err(Unposed::Scene)?;
        let scene = Arc::new(scene);
        let mut solutions = solve_all(Arc::clone(&scene), wanted).map_err(Unposed::Refused)?;
        let only = solutions.pop().filter(|_| solutions.is_empty());
        Ok(only.map(|solution| Posed { givens, scene, solution: Arc::new(solution) }))
    }

    /// What a name of a requirement stands for: a given, or a result.
    pub fn meaning(&self, name: &str) -> Option<Meaning> {
        let quantity = || self.quantity(name.parse().ok()?);
        // There is no dot in a name that an author gives.
        if name.contains('.') {
            return quantity();
        }
        self.found(name).or_else(|| self.givens.meaning(name)).or_else(quantity)
    }

    fn quantity(&self, quantity: Quantity) -> Option<Meaning> {
        match self.solution.number(quantity) {
            Some(value) => Some(Meaning::Number(value)),
            None => self.solution.angle(quantity).map(|angle| degrees(&angle)),
        }
    }

    /// What a letter of the scene was found to be.
    pub fn found(&self, name: &str) -> Option<Meaning> {
        let (letter, value) = self.solution.found().iter().find(|(letter, _)| letter.name() == name)?;
        match letter.range() {
            Range::Acute => Some(Meaning::Angle(Turn::of(Angle::of(value, &Value::ONE)?))),
            _ => Some(Meaning::Number(value.clone())),
        }
    }
}

/// A number of degrees: a plain number where it is a rational one.
fn degrees(angle: &Angle) -> Meaning {
    match angle.whole_degrees() {
        Some(exact) => Meaning::Number(Value::from(exact)),
        None => Meaning::Degrees(Turn::of(angle.clone())),
    }
}
