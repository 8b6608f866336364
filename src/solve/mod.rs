//! A scene solved: the derivation carried out in exact numbers, with its working.

mod answer_path;
mod begun;
mod inexact;
mod left;
mod report;

pub use begun::Begun;
pub use inexact::Inexact;
pub use left::Left;
pub use report::{Answer, Report, StepReport, report};

use std::cmp::Ordering;
use std::iter;
use std::sync::Arc;

use answer_path::{AnswerPath, answer_path};

use crate::expr::{Expr, in_degrees, print, written, written_angle};
use crate::mechanics::{
    Derivation, Found, Known, Line, Meeting, Quantity, Refusal, Rule, Scene, Show, Sought, Values, backwards, check_on,
    pose,
};
use crate::method::{Impact, Selection};
use crate::number::{Angle, Letter, Value};

/// A scene with what was asked of it, found.
#[derive(Clone, Debug)]
pub struct Solution {
    root: Found,
    asked: Vec<Quantity>,
    given: Known<Value>,
    known: Known<Value>,
    derivation: Derivation,
    path: Option<AnswerPath>,
}

/// Solves a scene for the quantities asked.
///
/// # Errors
///
/// A [`Refusal`] with its reason in mechanics: the scene cannot happen, leaves a quantity open, or
/// needs more than the methods of an exam.
pub fn solve(scene: impl Into<Arc<Scene>>, asked: &[Quantity]) -> Result<Solution, Refusal> {
    let mut solutions = solve_all(scene, asked)?;
    if solutions.len() > 1 {
        let values: Vec<String> = solutions.iter().map(Solution::found_in_words).collect();
        return Err(Refusal::underdetermined(format!("more than one value is possible: {}", values.join("; or "))));
    }
    solutions.remove(0).with_all_asked()
}

/// Every solution of a scene, with those of the quantities asked that are determined. There is more
/// than one only where the scene has unknowns that its conditions leave more than one value.
///
/// # Errors
///
/// As for [`solve`], but for what is left open.
pub fn solve_all(scene: impl Into<Arc<Scene>>, asked: &[Quantity]) -> Result<Vec<Solution>, Refusal> {
    let scene = scene.into();
    let setting = scene.setting;
    all_solutions(scene, asked).map_err(|refusal| refusal.said_of(setting))
}

fn all_solutions(scene: Arc<Scene>, asked: &[Quantity]) -> Result<Vec<Solution>, Refusal> {
    let one = |root: Found| -> Result<Solution, Refusal> {
        let solution = Solution::from(root, asked)?;
        let is_written = solution.found().is_empty() || solution.without_exact_form().is_empty();
        match if is_written { None } else { solution.root.with_unknowns_left() } {
            Some(left) => Solution::from(left, asked),
            None => Ok(solution),
        }
    };
    backwards(scene)?.into_iter().map(one).collect()
}

/// What letters must fulfil, so that in every impact masses are positive, the spheres meet and a coefficient of restitution
/// is one.
fn needed(scene: &Scene, computed: &Known<Value>) -> Vec<String> {
    let later = scene.then.iter().map(|then| (then.meeting, &then.scene));
    let impacts = || iter::once((Meeting::FIRST, scene)).chain(later.clone());
    let number = |meeting: Meeting, quantity| computed.number(meeting.quantity(quantity));
    let masses = impacts().flat_map(|(_, scene)| scene.masses.iter().flatten().map(|mass| mass.value.clone()));
    let approaches = impacts().filter_map(|(meeting, _)| number(meeting, Quantity::Approach));
    let mut positive: Vec<Value> = Vec::new();
    for value in masses.chain(approaches).filter(|value| value.sign().is_none()) {
        // What is a positive multiple of another needs no more than that.
        let is_said = |said: &Value| value.divided_by(said).and_then(|ratio| ratio.sign()) == Some(Ordering::Greater);
        if !positive.iter().any(is_said) {
            positive.push(value);
        }
    }
    let remark = |value: &Value, bound: &str| format!("this needs {} {bound}", print::unicode(&written(value)));
    let mut remarks: Vec<String> = positive.iter().map(|value| remark(value, "> 0")).collect();
    for (meeting, scene) in impacts() {
        let given = scene.restitution.as_ref().map(|given| given.value.clone());
        let Some(e) = given.or_else(|| number(meeting, Quantity::Restitution)) else { continue };
        let open =
            [(e.sign(), "≥ 0"), ((&Value::ONE - &e).sign(), "≤ 1")].into_iter().filter(|(sign, _)| sign.is_none());
        for said in open.map(|(_, bound)| remark(&e, bound)) {
            if !remarks.contains(&said) {
                remarks.push(said);
            }
        }
    }
    remarks
}

impl Solution {
    /// From what was found of its scene.
    fn from(mut root: Found, asked: &[Quantity]) -> Result<Solution, Refusal> {
        let worked = root.worked.take();
        let is_checked = worked.is_some();
        let (given, mut known) = match worked {
            Some(worked) => worked,
            None => {
                let given = pose(&root.scene)?;
                (given.clone(), given)
            }
        };
        // Where the unknowns are left letters, all that follows is in them, and no method takes letters for numbers.
        let path = if root.are_left { None } else { answer_path(&mut known, given.0.len()) };
        let known = if is_checked { known } else { check_on(&given, known)? };
        Ok(Solution::of(root, given, path, &known, asked))
    }

    /// From all that is known of it.
    fn of(
        mut root: Found,
        given: Known<Value>,
        path: Option<AnswerPath>,
        computed: &Known<Value>,
        asked: &[Quantity],
    ) -> Solution {
        if !root.are_left {
            root.remarks.extend(needed(&root.scene, computed));
        }
        let mut known = given.clone();
        let (derivation, _) = Derivation::carry_out_with(&mut known, computed, asked);
        Solution { root, asked: asked.to_vec(), given, known, derivation, path }
    }

    /// The same, if all that was asked follows from what is given, in numbers and the letters of the scene.
    fn with_all_asked(self) -> Result<Solution, Refusal> {
        if !self.left().is_empty() {
            let found = self.left();
            return Err(Refusal::beyond(format!("{found} has too many roots to go on from it in exact numbers")));
        }
        let missing = self.asked.iter().filter(|quantity| !self.knows(**quantity));
        let missing: Vec<String> = missing.map(|quantity| format!("`{quantity}`")).collect();
        if missing.is_empty() {
            return Ok(self);
        }
        Err(Refusal::underdetermined(format!("what is given does not determine {}", missing.join(", "))))
    }

    /// The scene, unknowns replaced by what was found.
    pub fn scene(&self) -> &Scene {
        &self.root.scene
    }

    /// The steps.
    pub fn derivation(&self) -> &Derivation {
        &self.derivation
    }

    /// Every step: those by which the unknowns were found, and then the others.
    pub fn steps(&self) -> Vec<&'static Rule> {
        let mut steps = self.root.steps().to_vec();
        steps.extend(self.derivation.steps.iter().filter(|step| !self.root.steps().contains(step)));
        steps
    }

    /// The impact in the axes of the line of centres, first along it and then across, if the scene determines all of
    /// what it starts from.
    pub fn impact(&self) -> Option<Impact<Value>> {
        self.path.as_ref().map(|(impact, _)| impact.clone())
    }

    /// The model by which the components after the impact were computed; none where the scene gives other things
    /// than an impact starts from, and the steps themselves are the way.
    pub fn selection(&self) -> Option<Selection> {
        self.path.as_ref().map(|(_, selection)| *selection)
    }

    /// What the scene gives, unknowns replaced by what was found.
    pub fn given(&self) -> &Known<Value> {
        &self.given
    }

    /// All that is known.
    pub fn known(&self) -> &Known<Value> {
        &self.known
    }

    /// The unknowns of the scene and their values; of an angle the tangent.
    pub fn found(&self) -> &[(Letter, Value)] {
        &self.root.values
    }

    /// The unknowns that are letters in what follows though their values were found, which are too long to be put in.
    pub fn left(&self) -> Left<'_> {
        Left(if self.root.are_left { &self.root.values } else { &[] })
    }

    /// The values that an unknown may have, where inequalities leave it a letter.
    pub fn range(&self) -> Option<&Values> {
        self.root.range.as_ref()
    }

    /// What the one unknown was found from; none where there is no unknown, or more than that.
    pub fn sought(&self) -> Option<Sought> {
        self.root.sought()
    }

    /// How the unknowns were found.
    pub fn finding(&self) -> Vec<Line> {
        self.root.lines()
    }

    /// Were there unknowns to be found?
    pub fn finds_unknowns(&self) -> bool {
        self.root.is_of_unknowns()
    }

    /// What else the finding of the unknowns showed: roots that were left out, and why.
    pub fn remarks(&self) -> &[String] {
        &self.root.remarks
    }

    /// Is the quantity known?
    pub fn knows(&self, quantity: Quantity) -> bool {
        self.known.0.contains_key(&quantity)
    }

    /// A quantity that is a number.
    pub fn number(&self, quantity: Quantity) -> Option<Value> {
        self.known.number(quantity)
    }

    /// A quantity that is an angle.
    pub fn angle(&self, quantity: Quantity) -> Option<Angle> {
        let (y, x) = self.known.direction(quantity)?;
        Angle::of(&y, &x)
    }

    /// The exact form of a quantity as a teacher writes it; an angle is an angle, not its degrees.
    pub fn exact(&self, quantity: Quantity) -> Option<Expr> {
        match self.number(quantity) {
            Some(value) => Some(written(&value)),
            None => self.angle(quantity).map(|angle| written_angle(&angle)),
        }
    }

    /// The exact form as the exchange format has it: an angle in degrees.
    pub fn exchange(&self, quantity: Quantity) -> Option<Expr> {
        match self.number(quantity) {
            Some(value) => Some(written(&value)),
            None => self.angle(quantity).map(|angle| in_degrees(&written_angle(&angle))),
        }
    }

    /// The worked solution, once the unknowns are found.
    pub fn lines(&self) -> Vec<Line> {
        let show = Show::new(&self.root.scene, &self.known, &self.asked);
        // Of a range the unknown is still a letter here.
        self.derivation.steps.iter().flat_map(|step| step.lines(&show)).map(Line::with_masses_in_symbols).collect()
    }

    fn found_in_words(&self) -> String {
        let one = |(letter, value): &(Letter, Value)| report::found_in_words(*letter, value);
        self.root.values.iter().map(one).collect::<Vec<_>>().join(", ")
    }
}
