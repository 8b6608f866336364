//! The worked solution part by part: what an earlier part found is known to the later ones.

use std::collections::BTreeSet;

use super::WorkingLine;
use super::answer;
use super::put_in::InLetters;
use crate::answer::Kind;
use crate::bank::{Answer, Find, Part, Question};
use crate::diagram::Manner;
use crate::expr::{Expr, Function, Relation, Text};
use crate::generate::Variant;
use crate::mechanics::{Axis, Derivation, Known, Line, Moment, Quantity, Rule, Show, pose};
use crate::number::Value;

/// A step as it is printed.
#[derive(Clone, Debug)]
pub struct Step {
    /// The law and what it is used for.
    pub rule: Rule,
    /// Its lines of working.
    pub lines: Vec<Line>,
    /// The equations that earn a mark.
    pub equations: Vec<Expr>,
}

impl Step {
    fn new(rule: Rule, show: &Show, letters: &[Letter]) -> Step {
        let letters: Vec<Letter> = of_impact(rule.impact(), letters).cloned().collect();
        let lines = rule.lines(show).into_iter().map(|line| renamed(line, &letters)).collect();
        let equations = rule.equations(show).iter().map(|equation| rename(equation, &letters)).collect();
        Step { rule, lines, equations }
    }
}

/// A part with the steps that lead to its answers.
pub struct WorkedPart<'q> {
    /// The part.
    pub part: &'q Part,
    /// What was known before it.
    pub given: BTreeSet<Quantity>,
    /// What is known after it.
    pub known: Known<Value>,
    /// What it asks for.
    pub asked: Vec<Quantity>,
    /// How letters were found, if this part does that.
    pub finding: Vec<Line>,
    /// Its steps, each with its lines.
    pub steps: Vec<Step>,
    /// If letters were found: the steps that led to their conditions, which `finding` tells in words.
    pub behind: Vec<Step>,
    /// The letters that the question uses for angles of the working.
    letters: Vec<Letter>,
}

/// A letter of the question in place of one of the working.
#[derive(Clone, Debug)]
struct Letter {
    /// The quantity that it is the angle of; each impact has its own.
    of: Quantity,
    ours: &'static str,
    theirs: String,
}

/// Every part of a question, worked in the manner of its words. Nothing if the scene cannot be posed, which a variant's
/// can.
pub fn work<'q>(question: &'q Question, variant: &Variant, manner: Manner) -> Vec<WorkedPart<'q>> {
    let scene = variant.solution.scene();
    let Ok(mut known) = pose(scene) else { return Vec::new() };
    let letters = letters(question);
    let mut finding = variant.solution.finding();
    let in_letters = if finding.is_empty() { None } else { InLetters::of(&variant.scene, variant.solution.found()) };
    let step = |found: &InLetters, rule: &Rule| Step::new(rule.clone(), &found.show(), &letters);
    let mut behind: Vec<Step> =
        in_letters.iter().flat_map(|found| found.rules.iter().map(|rule| step(found, rule))).collect();
    let finds = finding_part(question, in_letters.as_ref());
    let mut worked: Vec<WorkedPart> = Vec::new();
    for (place, part) in question.parts.iter().enumerate() {
        let asked = part.asked();
        let given = known.0.keys().copied().collect();
        let (derivation, _) = Derivation::carry_out(&mut known, &asked);
        let show = Show::new(scene, &known, &asked).in_words_of(manner.vectors, manner.with_units);
        let mut steps: Vec<Step> =
            derivation.steps.into_iter().map(|rule| Step::new(rule.clone(), &show, &letters)).collect();
        if let Some(found) = in_letters.as_ref().filter(|_| place >= finds) {
            found.put_into(&mut steps, &show, &asked);
        }
        let (mut finding, behind) = match place == finds {
            true => (std::mem::take(&mut finding), std::mem::take(&mut behind)),
            false => Default::default(),
        };
        // What an earlier part has worked out is not worked out again, to find a letter or once it is found.
        let in_steps = || worked.iter().flat_map(|earlier| &earlier.steps).flat_map(|step| &step.lines);
        finding.retain(|line| in_steps().all(|there| there != line));
        let in_finding = |line: &Line| worked.iter().any(|earlier| earlier.finding.contains(line));
        steps.iter_mut().for_each(|step| step.lines.retain(|line| !in_finding(line)));
        let (known, letters) = (known.clone(), letters.clone());
        worked.push(WorkedPart { part, given, known, asked, finding, steps, behind, letters });
    }
    worked
}

/// The part in which letters are found: that which asks for one, unless an earlier one needs them. Where a letter stays one,
/// as of a range, it is needed by none.
fn finding_part(question: &Question, in_letters: Option<&InLetters>) -> usize {
    let finds = |answer: &Answer| answer.kind == Kind::Range || matches!(answer.find, Find::Unknown(_));
    let asks = |part: &Part| part.answers.iter().any(finds);
    let needs = |part: &Part| in_letters.is_some_and(|found| found.are_needed(&part.asked()));
    question.parts.iter().position(|part| asks(part) || needs(part)).unwrap_or(0)
}

impl WorkedPart<'_> {
    /// The lines, numbered on from `last`, and what is to be shown at their end.
    pub fn lines(&self, variant: &Variant, last: &mut u32) -> Vec<WorkingLine> {
        let mut printed: Vec<WorkingLine> = Vec::new();
        let steps = self.steps.iter().flat_map(|step| &step.lines);
        for (place, line) in self.finding.iter().chain(steps).enumerate() {
            if place == self.finding.len() && place > 0 {
                // The steps have equations (1) and (2) of their own.
                *last = 0;
            }
            let label = line.numbered.then(|| {
                *last += 1;
                *last
            });
            let line = WorkingLine { words: line.words.clone(), equations: line.equations.clone(), label };
            // The same remark twice helps nobody.
            if !printed.contains(&line) {
                printed.push(line);
            }
        }
        if printed.is_empty() {
            let equations = self.found_above(variant);
            let is_first = matches!(self.part.label.as_str(), "" | "a");
            let words = if is_first { "From what is given," } else { "As was found above," };
            printed.push(WorkingLine { words: Text::words(words), equations, label: None });
        }
        let all_shown = self.part.answers.iter().all(|answer| answer.show.is_some());
        for result in self.part.answers.iter().filter_map(|answer| result(answer, variant)) {
            // What is to be shown ends the part: nobody asked for more.
            if let Some(line) = printed.last_mut().filter(|_| all_shown && self.steps.is_empty()) {
                let place = line.equations.iter().position(|equation| *equation == result);
                line.equations.truncate(place.map_or(line.equations.len(), |place| place + 1));
            }
            let there = printed.last().and_then(|line| line.equations.last()) == Some(&result);
            let (words, equations) =
                if there { ("as required.", Vec::new()) } else { ("Hence, as required,", vec![result]) };
            printed.push(WorkingLine { words: Text::words(words), equations, label: None });
        }
        printed
    }

    /// The answers, where earlier parts have found them all.
    fn found_above(&self, variant: &Variant) -> Vec<Expr> {
        let show = Show::new(variant.solution.scene(), &self.known, &self.asked);
        let found = |answer: &Answer| {
            let exact = answer::exact(answer, variant)?;
            let letter = match &answer.find {
                _ if matches!(exact, Expr::Relation(..)) => return Some(exact),
                Find::Unknown(name) => Expr::name(name),
                Find::Quantity(quantity) => show.symbol(self.as_worked(*quantity)),
                Find::Vector(..) => return Some(exact),
            };
            Some(if letter == exact { exact } else { Expr::equation(letter, exact) })
        };
        self.part.answers.iter().filter_map(found).collect()
    }

    /// The quantity by which the working goes: in a direct impact along the line of centres, and not along i.
    fn as_worked(&self, quantity: Quantity) -> Quantity {
        match quantity {
            Quantity::Velocity(sphere, moment, Axis::X) => {
                let along = Quantity::Velocity(sphere, moment, Axis::N);
                if self.known.number(along) == self.known.number(quantity) { along } else { quantity }
            }
            quantity => quantity,
        }
    }

    /// Is there a step of the impact before which so many come in its working?
    pub fn works_on(&self, impact: u8) -> bool {
        self.steps.iter().chain(&self.behind).any(|step| step.rule.impact() == impact)
    }

    /// What the condition from which letters are found comes to, and of a range each bound on what it speaks of.
    pub fn conditions(&self) -> Vec<Expr> {
        let lines = self.finding.iter().filter(|line| line.of_condition);
        let mut equations = lines.filter_map(|line| line.equations.first().cloned());
        let is_bound =
            |equation: &Expr| matches!(equation, Expr::Relation(_, relation, _) if *relation != Relation::Equal);
        let Some(first) = equations.next() else { return Vec::new() };
        let bounds: Vec<Expr> = if is_bound(&first) { equations.filter(is_bound).collect() } else { Vec::new() };
        [vec![first], bounds].concat()
    }

    /// An expression of the working of an impact in the question's own letters.
    pub fn in_its_letters(&self, impact: u8, expr: &Expr) -> Expr {
        let letters: Vec<Letter> = of_impact(impact, &self.letters).cloned().collect();
        rename(expr, &letters)
    }
}

/// What is to be shown: `show = value`.
pub fn result(answer: &Answer, variant: &Variant) -> Option<Expr> {
    let left = super::wording::filled(answer.show.as_ref()?, variant);
    Some(Expr::equation(left, answer::exact(answer, variant)?))
}

/// The working calls the angle to the line of centres, or to a wall, beta and the deflection delta; a question that asks
/// for the tangent of one has a letter of its own for it.
fn letters(question: &Question) -> Vec<Letter> {
    let mut found = Vec::new();
    for answer in question.parts.iter().flat_map(|part| &part.answers) {
        let Find::Quantity(quantity) = answer.find else { continue };
        let ours = match quantity.of_its_impact() {
            Quantity::TanDeflection(_) => "delta",
            Quantity::TOverN(..) | Quantity::TanToLine(..) | Quantity::TanToWall(..) => "beta",
            _ => continue,
        };
        let named = answer.show.as_ref().or_else(|| answer.name.formulas().into_iter().next());
        if let Some(Expr::Call(Function::Tan, inner)) = named
            && let Expr::Name(name) = &**inner
        {
            found.push(Letter { of: quantity, ours, theirs: name.text.clone() });
        }
    }
    found
}

/// The letters of a question for the angle between a path after an impact and the wall, each with the number of impacts
/// before it.
pub fn angles_after_walls(question: &Question) -> Vec<(u8, Expr)> {
    let after_a_wall = |quantity: Quantity| matches!(quantity.of_its_impact(), Quantity::TanToWall(_, Moment::After));
    let letters = letters(question).into_iter().filter(|letter| after_a_wall(letter.of));
    letters.map(|letter| (letter.of.impact(), Expr::name(&letter.theirs))).collect()
}

fn of_impact(impact: u8, letters: &[Letter]) -> impl Iterator<Item = &Letter> {
    letters.iter().filter(move |letter| letter.of.impact() == impact)
}

fn rename(expr: &Expr, letters: &[Letter]) -> Expr {
    expr.substitute(&|name| letters.iter().find(|letter| letter.ours == name).map(|letter| Expr::name(&letter.theirs)))
}

fn renamed(line: Line, letters: &[Letter]) -> Line {
    let words = line.words.map_formulas(&mut |expr| Ok::<_, ()>(rename(expr, letters))).unwrap_or(line.words);
    let equations = line.equations.iter().map(|expr| rename(expr, letters)).collect();
    Line { words, equations, ..line }
}
