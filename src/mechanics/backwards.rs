//! Scenes that run backwards: unknown letters found from conditions on the collision.
//!
//! The collision is derived forwards with the unknowns as letters; each condition then is an equation
//! in them, and so is each law that the given data do not satisfy by themselves. Every solution is put
//! back into the scene, tried in the original condition, and tested for whether it can happen.

use std::sync::Arc;

use super::condition::{beyond_its_range, fault, name_of, put_back, residual, vanishes, without_direction};
use super::conditions_in_words::{CONDITION_THAT_TELLS, condition_line, name_the_unknown, no_roots, of_no_impact};
use super::extreme;
use super::law::{Known, Rule};
use super::line::Line;
use super::range::{self, Values};
use super::refusal::Refusal;
use super::root_in_words;
use super::scene::{Condition, Scene};
use super::scene_reader::meaning;
use super::unknowns::{in_range, in_words, mentions, substituted, with_letters};
use super::validity::{Broken, broken_laws, check, demanding};
use super::ways::{either_way, of_both_ways};
use super::working::Show;
use super::{Derivation, Quantity, pose};
use crate::expr::{Expr, Meaning, Turn, holds, print};
use crate::number::{Angle, Letter, Range, Value, discriminant_of_squares, solve_system};

/// One solution for the unknowns of a scene.
#[derive(Clone, Debug)]
pub struct Found {
    /// The scene with the unknowns replaced.
    pub scene: Arc<Scene>,
    /// Each unknown with its value; of an angle the tangent.
    pub values: Vec<(Letter, Value)>,
    /// The values that an unknown may have, where inequalities determine no single one; it stays a letter.
    pub range: Option<Values>,
    /// Roots that were left out and why, and what the letters that remain must satisfy.
    pub remarks: Vec<String>,
    /// The values of the other solutions, which are as possible.
    others: Vec<Vec<Value>>,
    /// Where values were put back: what was given then, and all that is known then, which begins with it.
    pub worked: Option<(Known<Value>, Known<Value>)>,
    /// Are the unknowns letters in the scene still, because their values are too long to be put back?
    pub are_left: bool,
    /// What they were found from; none where nothing was to be found.
    posed: Option<Arc<Posed>>,
}

impl Found {
    /// A scene that is its own only solution.
    pub fn given(scene: Arc<Scene>) -> Found {
        let (values, remarks, others) = (Vec::new(), Vec::new(), Vec::new());
        Found { scene, values, range: None, remarks, others, worked: None, are_left: false, posed: None }
    }

    pub(super) fn from(posed: Arc<Posed>, scene: Scene) -> Found {
        Found { posed: Some(posed), ..Found::given(Arc::new(scene)) }
    }

    /// Was there something to be found?
    pub fn is_of_unknowns(&self) -> bool {
        self.posed.is_some()
    }

    /// The same with the unknowns left letters, for what cannot be written with their values in it.
    pub fn with_unknowns_left(&self) -> Option<Found> {
        let values: Vec<Value> = self.values.iter().map(|(_, value)| value.clone()).collect();
        let left = self.posed.as_ref()?.in_letters(&values).ok()??;
        Some(Found { remarks: self.remarks.clone(), others: self.others.clone(), ..left })
    }

    /// What they were found from.
    pub(super) fn posed(&self) -> Option<&Posed> {
        self.posed.as_deref()
    }

    /// The steps to the quantities of which the conditions speak, in terms of the unknowns.
    pub fn steps(&self) -> &[&'static Rule] {
        self.posed.as_ref().map_or(&[], |posed| &posed.derivation.steps)
    }

    /// How the unknowns were found.
    pub fn lines(&self) -> Vec<Line> {
        match (&self.posed, &self.range) {
            (None, _) => Vec::new(),
            (Some(posed), Some(values)) => range::lines(posed, values),
            (Some(posed), None) => posed.lines(&self.values, &self.others),
        }
    }
}

/// Finds the unknowns of a scene. A scene without unknowns is its own only solution.
///
/// # Errors
///
/// The conditions leave the unknowns open, contradict each other or what can happen, or lead to an
/// equation beyond the methods of an exam.
pub fn backwards(scene: Arc<Scene>) -> Result<Vec<Found>, Refusal> {
    if scene.unknowns.is_empty() {
        if scene.conditions.is_empty() && scene.maximise.is_none() {
            return Ok(vec![Found::given(scene)]);
        }
        let what = match scene.maximise.is_some() {
            true => "a quantity is to be as large as possible, but there is no unknown on which it depends",
            false => "there are conditions, but no unknown to be found from them",
        };
        return Err(Refusal::underdetermined(what).try_this(name_the_unknown(&scene)));
    }
    if scene.maximise.is_some() && !scene.conditions.is_empty() {
        return Err(Refusal::underdetermined("`maximise` and `conditions` are two ways to find an unknown")
            .try_this("leave one of the two out"));
    }
    let scene = with_letters(&scene);
    for unknown in &scene.unknowns {
        if !mentions(&scene, *unknown) {
            return Err(Refusal::underdetermined(format!(
                "the unknown `{}` does not occur in the scene",
                unknown.name()
            ))
            .try_this("write it where the scene gives a value, or take it out of `unknowns`"));
        }
    }
    let letters = |name: &str| meaning(&scene.letters, name);
    if let Some(refusal) = scene.conditions.iter().find_map(|condition| beyond_its_range(condition, &letters)) {
        return Err(refusal);
    }
    let mut found = match either_way(&scene).filter(|_| scene.maximise.is_none()) {
        Some(ways) if !scene.conditions.iter().any(Condition::is_inequality) => of_both_ways(&scene, ways.map(solved))?,
        _ => solved(scene)?,
    };
    let values = |one: &Found| one.values.iter().map(|(_, value)| value.clone()).collect();
    let all: Vec<Vec<Value>> = found.iter().map(values).collect();
    for (place, one) in found.iter_mut().enumerate() {
        one.others = all.clone();
        one.others.remove(place);
    }
    Ok(found)
}

/// The unknowns of a scene whose line of centres has its sense, or finds it.
fn solved(scene: Scene) -> Result<Vec<Found>, Refusal> {
    let posed = Arc::new(Posed::new(scene)?);
    let scene = &posed.scene;
    if scene.conditions.iter().any(Condition::is_inequality) {
        let range = Some(range::values(&posed)?);
        // The letter stays one: what else is asked is asked in it.
        let scene = Scene { unknowns: Vec::new(), conditions: Vec::new(), ..scene.clone() };
        return Ok(vec![Found { range, ..Found::from(posed, scene) }]);
    }
    let candidates = posed.candidates()?;
    let mut found = Vec::new();
    let (mut left_out, mut undecided) = (Vec::new(), Vec::new());
    for values in candidates {
        let named = || in_words(&posed.scene.unknowns, &values);
        match tried(&posed, &values) {
            Ok(one) => found.push(one),
            Err(Reason::Not(reason)) => left_out.push(format!("{} is left out: {reason}", named())),
            Err(Reason::Undecided) => {
                undecided.push(format!("{} has too many roots to decide whether it satisfies the conditions", named()));
            }
        }
    }
    if let Some(quantity) = scene.maximise {
        extreme::only_largest(&mut found, quantity);
    }
    if found.is_empty() && !undecided.is_empty() {
        return Err(Refusal::beyond(undecided.join("; ")));
    }
    if found.is_empty() {
        if let (Some(quantity), false) = (scene.maximise, left_out.is_empty()) {
            return Err(extreme::without_largest(scene, quantity, &left_out.join("; ")));
        }
        let reasons = if left_out.is_empty() { "it has no real solution".to_string() } else { left_out.join("; ") };
        return Err(Refusal::impossible(format!("no collision satisfies the conditions: {reasons}")));
    }
    for one in &mut found {
        one.remarks.extend(left_out.iter().chain(&undecided).cloned());
    }
    Ok(found)
}

/// Why a candidate is no solution.
pub(super) enum Reason {
    /// It is none, in words.
    Not(String),
    /// The exact methods do not tell.
    Undecided,
}

impl From<String> for Reason {
    fn from(reason: String) -> Reason {
        Reason::Not(reason)
    }
}

/// A scene derived forwards with its unknowns as letters.
#[derive(Debug)]
pub(super) struct Posed {
    pub(super) scene: Scene,
    pub(super) given: Known<Value>,
    pub(super) known: Known<Value>,
    pub(super) derivation: Derivation,
    pub(super) asked: Vec<Quantity>,
    /// What the laws demand beyond the derivation, where more is given than it needs.
    pub(super) broken: Vec<Broken>,
}

impl Posed {
    fn new(scene: Scene) -> Result<Posed, Refusal> {
        let given = pose(&scene)?;
        let mut known = given.clone();
        let mut asked: Vec<Quantity> = scene.maximise.into_iter().collect();
        for condition in &scene.conditions {
            for side in [&condition.left, &condition.right] {
                asked.extend(side.names().iter().filter_map(|name| name.text.parse::<Quantity>().ok()));
            }
        }
        asked.sort();
        asked.dedup();
        let (mut derivation, missing) = Derivation::carry_out(&mut known, &asked);
        let impacts = scene.then.len() + 1;
        if let Some(beyond) = missing.iter().find(|quantity| usize::from(quantity.impact()) >= impacts) {
            return Err(of_no_impact(*beyond, impacts));
        }
        if !missing.is_empty() {
            let names: Vec<String> = missing.iter().map(|quantity| format!("`{quantity}`")).collect();
            return Err(Refusal::underdetermined(format!(
                "a condition speaks of {}, which what is given does not determine",
                names.join(", ")
            )));
        }
        let broken = broken_laws(&known);
        derivation.steps.extend(demanding(&scene.unknowns, &broken));
        Ok(Posed { scene, given, known, derivation, asked, broken })
    }

    /// Every assignment of the unknowns that solves the equations, right or not.
    fn candidates(&self) -> Result<Vec<Vec<Value>>, Refusal> {
        let unknowns = &self.scene.unknowns;
        let mut equations = Vec::new();
        for condition in &self.scene.conditions {
            let letters = |name: &str| meaning(&self.scene.letters, name);
            equations.push(residual(condition, &letters, &self.known).map_err(fault)?.value);
        }
        if let Some(quantity) = self.scene.maximise {
            return self.extremes(quantity);
        }
        let open = |value: &Value| value.has_letter(|letter| unknowns.contains(letter));
        equations.extend(self.demands().filter(open));
        let names: Vec<&str> = unknowns.iter().map(Letter::name).collect();
        if equations.iter().any(|equation| !open(equation) && !equation.is_zero()) {
            return Err(Refusal::impossible(format!("the condition cannot hold, whatever {} is", names.join(", "))));
        }
        let conditions = equations.len();
        equations.retain(open);
        if equations.is_empty() && conditions > 0 {
            let holds = Refusal::underdetermined(format!("the condition holds whatever {} is", names.join(", ")));
            return Err(holds.try_this(CONDITION_THAT_TELLS));
        }
        if let ([equation], [_, _]) = (equations.as_slice(), unknowns.as_slice()) {
            equations.extend(discriminant_of_squares(equation, unknowns));
        }
        if equations.len() < unknowns.len() {
            return Err(Refusal::underdetermined(format!(
                "{} condition{} cannot determine {} unknown{} ({})",
                equations.len(),
                if equations.len() == 1 { "" } else { "s" },
                unknowns.len(),
                if unknowns.len() == 1 { "" } else { "s" },
                names.join(", ")
            ))
            .try_this(CONDITION_THAT_TELLS));
        }
        solve_system(&equations, unknowns).map_err(no_roots)
    }

    /// Does a condition hold at these values, by what was derived in letters? `None` where that is not told.
    pub(super) fn holds_at(&self, condition: &Condition, values: &[Value]) -> Option<bool> {
        let letters = |name: &str| meaning(&self.scene.letters, name);
        residual(condition, &letters, &self.known).ok()?.vanishes_at(&self.scene.unknowns, values)
    }

    /// The one equation for the one unknown, where there is no other.
    fn equation(&self) -> Option<Value> {
        let [unknown] = self.scene.unknowns.as_slice() else { return None };
        if let Some(quantity) = self.scene.maximise {
            return self.slope(quantity);
        }
        let letters = |name: &str| meaning(&self.scene.letters, name);
        let gap = |condition| residual(condition, &letters, &self.known).ok().map(|gap| gap.value);
        let conditions: Option<Vec<Value>> = self.scene.conditions.iter().map(gap).collect();
        let mut open: Vec<Value> = conditions?.into_iter().chain(self.demands()).collect();
        open.retain(|value| value.has_letter(|own| own == unknown));
        open.pop().filter(|_| open.is_empty())
    }

    fn demands(&self) -> impl Iterator<Item = Value> {
        self.broken.iter().map(|law| law.difference.clone())
    }

    /// The forward derivation in letters, the condition, and what follows from it; the other solutions are told from roots
    /// that are none.
    fn lines(&self, values: &[(Letter, Value)], others: &[Vec<Value>]) -> Vec<Line> {
        let show = Show::new(&self.scene, &self.known, &self.asked);
        let mut lines: Vec<Line> = self.derivation.steps.iter().flat_map(|step| step.lines(&show)).collect();
        for condition in &self.scene.conditions {
            let mut line = condition_line(condition, &self.scene).of_condition(&self.scene);
            line.equations.extend(self.condition_in_unknowns(condition));
            lines.push(line);
        }
        if let Some(quantity) = self.scene.maximise {
            let values: Vec<Value> = values.iter().map(|(_, value)| value.clone()).collect();
            let largest = self.largest_lines(quantity, &values).into_iter();
            lines.extend(largest.map(|line| Line { of_condition: true, ..line }));
        }
        let equation = self.equation();
        for (place, (letter, value)) in values.iter().enumerate() {
            let others: Vec<&Value> = others.iter().filter_map(|other| other.get(place)).collect();
            lines.extend(root_in_words::lines(equation.as_ref(), *letter, value, &others));
        }
        lines.into_iter().map(|line| line.without_identities().with_masses_in_symbols()).collect()
    }
}

/// A candidate put back: its ranges, the original conditions, and whether it can happen.
fn tried(posed: &Arc<Posed>, values: &[Value]) -> Result<Found, Reason> {
    let unknowns = &posed.scene.unknowns;
    let mut remarks = Vec::new();
    for (unknown, value) in unknowns.iter().zip(values) {
        in_range(*unknown, value, &mut remarks)?;
    }
    if let Some(found) = posed.left_as_letters(values)? {
        return Ok(found);
    }
    let scene = substituted(&posed.scene, unknowns, values)
        .ok_or_else(|| Reason::Not("a quantity does not exist there".to_owned()))?;
    let given = pose(&scene).map_err(|refusal| refusal.reason)?;
    let mut known = check(&given).map_err(|refusal| refusal.reason)?;
    Derivation::carry_on(&mut known, given.0.len(), &posed.asked);
    for own in &posed.scene.conditions {
        let put_back = |expr: &Expr| put_back(expr, unknowns, values);
        let condition = Condition { left: put_back(&own.left), relation: own.relation, right: put_back(&own.right) };
        let relation = Expr::equation(condition.left.clone(), condition.right.clone());
        let letters = |name: &str| {
            let place = unknowns.iter().position(|unknown| unknown.name() == name);
            match place.filter(|place| unknowns[*place].range() == Range::Acute) {
                Some(place) => Some(Meaning::Angle(Turn::of(Angle::of(&values[place], &Value::ONE)?))),
                None => meaning(&scene.letters, name),
            }
        };
        let gap = || residual(&condition, &letters, &known);
        match holds(&relation, &|name| name_of(name, &letters, &known)) {
            Ok(Some(true)) => {}
            // The sine of the gap is nought half a turn away too.
            Ok(Some(false)) if gap().is_ok_and(|gap| gap.is_of_angles()) => {
                let relation = print::plain(&relation);
                return Err(format!("it does not satisfy `{relation}`: the direction would be opposite").into());
            }
            Err(_) if let Some(reason) = without_direction(&relation, &known, given.0.len()) => {
                return Err(reason.into());
            }
            _ if gap().is_ok_and(|gap| vanishes(&gap.value)) => {}
            // What it speaks of has no short exact form there.
            Err(_) if posed.holds_at(own, values).ok_or(Reason::Undecided)? => {}
            _ if posed.scene.conditions.len() > 1 => {
                return Err(format!("it does not satisfy `{}`", print::plain(&relation)).into());
            }
            _ => return Err("it does not satisfy the condition itself, only its square".to_owned().into()),
        }
    }
    if let Some(quantity) = posed.scene.maximise {
        posed.is_maximum(quantity, values)?;
    }
    let values: Vec<(Letter, Value)> = unknowns.iter().copied().zip(values.iter().cloned()).collect();
    Ok(Found { values, remarks, worked: Some((given, known)), ..Found::from(Arc::clone(posed), scene) })
}
