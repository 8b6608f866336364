//! A question with numbers in it: its scene read and solved.

use std::sync::Arc;

use super::givens::Givens;
use super::question::{Question, Style};
use super::requirement::Requirement;
use crate::expr::{Angles, Fault, Meaning, Turn};
use crate::mechanics::{Quantity, Refusal, Scene, SceneFault};
use crate::number::{Angle, Range, Value};
use crate::solve::{Begun, Solution, solve, solve_all};

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

/// A question with numbers in it: its scene read, and followed no further than its requirements ask.
#[derive(Clone, Debug)]
pub struct Opened {
    givens: Arc<Givens>,
    scene: Arc<Scene>,
    /// None where the scene has unknowns: nothing is known before they are found.
    begun: Option<Begun>,
}

impl Opened {
    /// Reads the scene of a question.
    ///
    /// # Errors
    ///
    /// Why these numbers make no scene, as far as that is known before it is solved.
    pub fn new(question: &Question, givens: Arc<Givens>) -> Result<Opened, Unposed> {
        let scene = Scene::read(&question.scene, &*givens, Angles::Degrees).map_err(Unposed::Scene)?;
        let scene = Arc::new(scene);
        let begun = Begun::new(Arc::clone(&scene)).map_err(Unposed::Refused)?;
        Ok(Opened { givens, scene, begun })
    }

    /// Does a requirement hold that names these quantities? None where that is not known before all of it is solved.
    pub fn meets(&mut self, requirement: &Requirement, quantities: &[Quantity]) -> Option<bool> {
        let begun = self.begun.as_mut()?;
        begun.derive(quantities);
        let quantity = |quantity| meaning(begun.number(quantity), || begun.angle(quantity));
        requirement.holds(&|name| named(name, &self.givens, &|_| None, &quantity)).ok()
    }

    /// Solves it for quantities that are known: those that [`Question::wanted`] tells.
    ///
    /// # Errors
    ///
    /// Why these numbers do not make a question that can be solved.
    pub fn solve(self, wanted: &[Quantity]) -> Result<Posed, Unposed> {
        let Opened { givens, scene, begun } = self;
        let solution = match begun {
            Some(begun) => begun.solve(wanted),
            None => solve(Arc::clone(&scene), wanted),
        };
        let solution = Arc::new(solution.map_err(Unposed::Refused)?);
        Ok(Posed { givens, scene, solution })
    }

    /// Solves it for no more than what is determined, where something that is wanted is left open; nothing if there is more
    /// than one solution.
    ///
    /// # Errors
    ///
    /// As for [`Opened::solve`].
    pub fn as_far_as_determined(self, wanted: &[Quantity]) -> Result<Option<Posed>, Unposed> {
        let Opened { givens, scene, .. } = self;
        let mut solutions = solve_all(Arc::clone(&scene), wanted).map_err(Unposed::Refused)?;
        let only = solutions.pop().filter(|only| solutions.is_empty() && only.left().is_empty());
        Ok(only.map(|solution| Posed { givens, scene, solution: Arc::new(solution) }))
    }
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
        Opened::new(question, Arc::new(givens))?.solve(&question.wanted(style))
    }

    /// Does a requirement hold?
    pub fn meets(&self, requirement: &Requirement) -> bool {
        requirement.holds(&|name| self.meaning(name)).unwrap_or(false)
    }

    /// What a name of a requirement stands for: a given, or a result.
    pub fn meaning(&self, name: &str) -> Option<Meaning> {
        let quantity = |quantity| meaning(self.solution.number(quantity), || self.solution.angle(quantity));
        named(name, &self.givens, &|name| self.found(name), &quantity)
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

/// What a name of a requirement stands for: a letter that was found, a given, or a result.
fn named(
    name: &str,
    givens: &Givens,
    found: &dyn Fn(&str) -> Option<Meaning>,
    quantity: &dyn Fn(Quantity) -> Option<Meaning>,
) -> Option<Meaning> {
    let result = || quantity(name.parse().ok()?);
    // There is no dot in a name that an author gives.
    if name.contains('.') {
        return result();
    }
    found(name).or_else(|| givens.meaning(name)).or_else(result)
}

/// A result that is a number, or an angle.
fn meaning(number: Option<Value>, angle: impl FnOnce() -> Option<Angle>) -> Option<Meaning> {
    number.map(Meaning::Number).or_else(|| angle().map(|angle| degrees(&angle)))
}

/// A number of degrees: a plain number where it is a rational one.
fn degrees(angle: &Angle) -> Meaning {
    match angle.whole_degrees() {
        Some(exact) => Meaning::Number(Value::from(exact)),
        None => Meaning::Degrees(Turn::of(angle.clone())),
    }
}
