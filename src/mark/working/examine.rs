//! Which marks the lines of a part earn.

use super::numbers::{Context, Spread, Sum, sizes, sum};
use std::rc::Rc;

use super::denied::End;
use super::equations::{BOTH, ByNumbers, Convention, Matched, Misread, line_shows_e, take_as_laws};
use super::evidence::Evidence as Shown;
use super::going_on::{follow, follow_to};
use super::impacts::{set_aside_of_others, short_of_law_or_step};
use super::laws::ToBeSubtracted;
use super::letters::{is_used_anew, undone};
use super::lines::{Line, ReadLine, Stated, set_aside_replaced};
use super::prepared::Prepared;
use super::theirs::{Theirs, own_values};
use super::{letters, lines};
use crate::bank::{Code, EarnedFor};
use crate::expr::Expr;
use crate::mark::award::{Award, Evidence, Examiner, MarkedLine, Place};
use crate::mark::key::{KeyedMark, KeyedPart, KeyedQuestion};
use crate::mechanics::{Axis, Known, Law, Moment, Quantity, Seen, Sphere};

/// What looking through the working of a part found.
pub(crate) struct Examined {
    /// For each mark of the scheme an award, if the lines say anything of it.
    pub(crate) awards: Vec<Option<Award>>,
    /// What each line is.
    pub(crate) lines: Vec<MarkedLine>,
    /// The values that the student found, in this part and before.
    pub(crate) theirs: Theirs,
    /// For each blank the last line that calls a value what is asked for.
    pub(crate) stated: Vec<Option<Stated>>,
    /// Everything that follows from them, at every point, where that was worked out to look through the lines.
    pub(super) followed: Option<Vec<Known<f64>>>,
    /// What the student's own two equations come to, where they are those of the first impact.
    pub(super) solution: Option<[Vec<f64>; 2]>,
    /// Is e seen in them, where they were looked through?
    pub(super) has_e: Option<bool>,
    /// Both energies, where only an answer may be their difference.
    pub(super) to_be_subtracted: Option<ToBeSubtracted>,
    /// What a deflection would be by two directions that stand in the lines, where only an answer may have it.
    pub(super) turns: Vec<Vec<f64>>,
    /// The student's letters for the velocities of A and B after the impact, where an equation says so.
    pub(super) letters: Option<[String; 2]>,
    /// Does a line have a velocity after the impact exactly, so that nobody had to go on in figures?
    pub(crate) finds_exactly: bool,
    /// What each line is short of one of the two equations, if it is one.
    pub(super) short_of_law: Vec<Option<u32>>,
    /// A number of the question that is copied wrongly into an equation.
    pub(crate) misread: Option<Misread>,
    /// Do equations deny the right value of the letter that is to be found?
    pub(crate) denies_what_is_found: bool,
    /// For each blank: is the right value in the lines, and only behind an equals sign that is false?
    pub(crate) denied: Vec<bool>,
    /// Of each sphere: do the student's own equations lead elsewhere than to its right velocity after the impact?
    pub(crate) denies_velocities: [bool; 2],
    /// The value with which the lines end.
    pub(crate) end: Option<End>,
    /// The velocities after the impact that some letter is said to be: another value of it may be of something else.
    pub(crate) found_once: Vec<Quantity>,
    /// The velocities after the impact of which the lines have found another value, so that the right one has not come from them.
    pub(crate) found_otherwise: Vec<Quantity>,
}

/// Of the letters for the velocities of A and B, is it that of the other sphere?
pub(super) fn is_of_other(letters: &[String; 2], letter: &str, sphere: Sphere) -> bool {
    Sphere::BOTH.into_iter().zip(letters).any(|(own, name)| own != sphere && name == letter)
}

impl Examined {
    /// Does e stand in the lines, so that it was not forgotten?
    pub(crate) fn has_e(&self) -> bool {
        self.has_e == Some(true)
    }

    /// Is it the student's letter for the velocity of the other sphere?
    pub(crate) fn is_of_other(&self, letter: &str, sphere: Sphere) -> bool {
        self.letters.as_ref().is_some_and(|letters| is_of_other(letters, letter, sphere))
    }

    /// What follows for a quantity from the student's own other values, at every point.
    pub(crate) fn followed(&self, question: &KeyedQuestion, quantity: Quantity) -> Option<Vec<f64>> {
        let is_stated = self.theirs.values.contains_key(&quantity);
        let known = self.followed.as_deref().filter(|_| !is_stated).and_then(|known| sizes(known, quantity));
        known.or_else(|| {
            let others = self.theirs.values.iter().filter(|(own, _)| **own != quantity);
            let values = others.map(|(own, value)| (*own, value.clone())).collect();
            let others = Theirs { values, ..Theirs::default() };
            follow_to(question.prepared(), &others, quantity)
        })
    }
}

/// Does a formula in the question's letters come to these at every point, whatever their sign?
pub(crate) fn has_these_sizes(question: &KeyedQuestion, expr: &Expr, sizes: &[f64]) -> bool {
    let prepared = question.prepared();
    let own = prepared.sizes_of(expr);
    let is = |(own, size): (&f64, &f64)| (own.abs() - size.abs()).abs() <= 1e-9 * size.abs();
    own.is_some_and(|own| own.iter().zip(sizes).all(is))
}

/// A line with what it comes to.
pub(super) struct Studied {
    pub(super) line: Line,
    /// The reading that was used.
    pub(super) reading: Option<Rc<ReadLine>>,
    /// The value of each member at every point: a number, or a vector.
    pub(super) values: Vec<Option<Vec<Value>>>,
    /// Which of the two equations it is; one of each if it has both.
    pub(super) matched: Vec<Matched>,
    pub(super) role: String,
    /// A number of the question that is copied wrongly into it.
    pub(super) misread: Option<Misread>,
}

/// What a member comes to at a point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Value {
    Number(Spread),
    Vector(Spread, Spread),
}

/// The working of a part with all that is known of it.
pub(super) struct Working<'a> {
    pub(super) question: &'a KeyedQuestion,
    pub(super) prepared: &'a Prepared,
    pub(super) part: &'a KeyedPart,
    pub(super) lines: Vec<Studied>,
    pub(super) convention: Option<Convention>,
    pub(super) theirs: Theirs,
    /// What follows from the student's own values, at every point.
    pub(super) followed: Vec<Known<f64>>,
    /// What names stand for: what is given, and the student's letters for the two components after the impact.
    pub(super) names: Vec<(String, Vec<f64>)>,
    /// What was found of lines by their terms.
    pub(super) by_numbers: ByNumbers,
}

/// Looks through the working of one impact; `of_others` is what each line is short of a law of those before it.
pub(super) fn examine_one(
    question: &KeyedQuestion,
    part: &KeyedPart,
    working: &[String],
    before: &Theirs,
    of_others: &[Option<u32>],
) -> Examined {
    let prepared = question.prepared();
    let vectors = has_vectors(question);
    let mut before = before.clone();
    before.meant.retain(|(letter, _)| !is_used_anew(letter, working, &question.letters));
    let mut read = lines::read(working, &question.letters, vectors, &before.meant);
    letters::put_in_place(&mut read, &question.letters, &mut before.meant, prepared);
    let (undone, slips) = undone(&read, &before.slips, prepared);
    before.slips = slips;
    let mut all = examine_lines(question, part, read, &before, of_others);
    if let Some(lines) = undone {
        all.follow_slips(part, examine_lines(question, part, lines, &before, of_others));
    }
    all.lines.extend(first_unread(working));
    all
}

fn examine_lines(
    question: &KeyedQuestion,
    part: &KeyedPart,
    read: Vec<Line>,
    before: &Theirs,
    of_others: &[Option<u32>],
) -> Examined {
    let prepared = question.prepared();
    let mut lines: Vec<Studied> = read
        .into_iter()
        .map(|line| {
            let reading = line.readings.first().cloned();
            Studied { line, reading, values: Vec::new(), matched: Vec::new(), role: String::new(), misread: None }
        })
        .collect();
    let mut convention = take_as_laws(&mut lines, prepared);
    if set_aside_of_others(&mut lines, of_others) {
        convention = take_as_laws(&mut lines, prepared);
    }
    // In restitution the numbers are those of velocities themselves.
    let misread_in = |equation| {
        let is_it = |studied: &&Studied| studied.matched.iter().any(|matched| matched.equation == equation);
        lines.iter().filter(is_it).find_map(|studied| studied.misread.clone())
    };
    let misread = misread_in(Quantity::RestitutionEquation).or_else(|| misread_in(Quantity::MomentumEquation));
    let short_of_law =
        lines.iter().map(|studied| short_of_law_or_step(studied, convention.as_ref(), prepared)).collect();
    set_aside_replaced(&mut lines);
    evaluate(&mut lines, prepared, &prepared.names);
    let mut theirs = before.clone();
    let found = own_values(&lines, convention.as_ref(), part, prepared);
    theirs.values.extend(found);
    let followed = follow(prepared, &theirs);
    let names = Vec::new();
    let mut working = Working {
        question,
        prepared,
        part,
        lines,
        convention,
        theirs,
        followed,
        names,
        by_numbers: ByNumbers::default(),
    };
    // Now that it is known what the student's letters stand for, formulas with them have values.
    working.names = working.names(&|quantity| {
        working
            .theirs
            .values
            .get(&quantity)
            .map(|(values, _)| values.clone())
            .or_else(|| sizes(&prepared.known, quantity))
    });
    working.settle_doubts();
    working.evaluate();
    let awards = part.scheme.iter().map(|mark| working.award(mark)).collect();
    working.tell_unlike_momentum();
    let stated = (0..part.blanks.len()).map(|place| working.stated(place)).collect();
    let solution = working.own_solution();
    let to_be_subtracted = working.to_be_subtracted();
    let turns = working.turns();
    let (denied, end, found_once) = (working.denied_by_lines(), working.end(), working.found_once());
    let found_otherwise = working.found_otherwise();
    let finds_exactly = working.finds_exactly();
    let denies_velocities = working.denies_velocities();
    let denies_what_is_found = working.denies_what_is_found();
    let has_e = Some(working.lines.iter().any(|studied| line_shows_e(studied, prepared)));
    let letters = working.convention_by_laws().map(|convention| convention.letters.clone());
    let lines = working.lines.iter().map(|studied| MarkedLine {
        typed: studied.line.typed.clone(),
        reading: studied.reading.as_ref().map(|reading| reading.printed.clone()),
        role: question.said_of_impact(&studied.role),
    });
    let lines = lines.collect();
    if question.scene.then.is_empty() {
        let by_laws = working.convention_by_laws().map(|own| (own.letters.clone(), own.signs));
        working.theirs.letters = by_laws.or(working.theirs.letters.take());
    }
    let (theirs, followed) = (working.theirs, Some(working.followed));
    Examined {
        awards,
        lines,
        theirs,
        stated,
        followed,
        solution,
        has_e,
        to_be_subtracted,
        turns,
        letters,
        finds_exactly,
        short_of_law,
        misread,
        denies_what_is_found,
        denied,
        denies_velocities,
        end,
        found_once,
        found_otherwise,
    }
}

/// The first line of more than are read: a person is told of it.
fn first_unread(working: &[String]) -> Option<MarkedLine> {
    let mut rest = lines::typed(working).skip(lines::MOST_LINES);
    rest.next().map(|typed| MarkedLine { typed: typed.to_owned(), reading: None, role: String::new() })
}

pub(super) fn has_vectors(question: &KeyedQuestion) -> bool {
    use crate::mechanics::Velocity;
    let components =
        question.scene.before.iter().chain(&question.scene.after).flatten().any(|velocity| match velocity {
            Velocity::Components(x, y) => {
                x.value.is_constant() && y.value.is_constant() && !(x.value.is_zero() && y.value.is_zero())
            }
            Velocity::Polar { .. } => false,
        });
    components || question.parts.iter().flat_map(|part| &part.blanks).any(|blank| blank.model.vocabulary.vectors)
}

/// The names and decimals of the question at a point.
pub(super) fn context(prepared: &Prepared, point: usize) -> Context<'_> {
    Context { points: &prepared.points, point, given: &prepared.names, exact: &prepared.decimals, rounded_from: 3 }
}

/// Finds what every member of every line comes to.
pub(super) fn evaluate(lines: &mut [Studied], prepared: &Prepared, names: &[(String, Vec<f64>)]) {
    for studied in lines {
        let members = studied.reading.as_ref().map(|reading| reading.members.as_slice()).unwrap_or_default();
        studied.values = members.iter().map(|member| value(&member.expr, prepared, names)).collect();
    }
}

/// What a formula without unknowns comes to at every point.
pub(super) fn value(expr: &Expr, prepared: &Prepared, names: &[(String, Vec<f64>)]) -> Option<Vec<Value>> {
    let at = |point| match sum(expr, &Context { given: names, ..context(prepared, point) })? {
        Sum::Number(linear) if linear.is_number() => Some(Value::Number(linear.constant)),
        Sum::Vector(x, y) if x.is_number() && y.is_number() => Some(Value::Vector(x.constant, y.constant)),
        _ => None,
    };
    (0..prepared.points.count).map(at).collect()
}

impl Working<'_> {
    /// What formulas are evaluated with at a point.
    pub(super) fn context(&self, point: usize) -> Context<'_> {
        Context { given: &self.names, ..context(self.prepared, point) }
    }

    /// What the lines say of a mark.
    fn award(&mut self, mark: &KeyedMark) -> Option<Award> {
        if self.lines.is_empty() {
            return None;
        }
        let shown = match (&mark.earned_for, mark.code) {
            (_, Code::A1Shown) => self.printed_result(),
            (EarnedFor::Law(law, _), code) if law.seen() == Seen::Equation && self.uses_pair(*law) => {
                let by_terms = || self.energy_kept(*law).or_else(|| self.by_terms(*law, code));
                let terms = || by_terms().or_else(|| self.by_centre_of_mass(code));
                match self.pair_equation(*law, code) {
                    Some(shown) if !shown.given => {
                        // Where the terms show the method and the form does not, they say what is wrong as well.
                        let is_better = |found: &Shown| found.given || code.is_accuracy() && !self.is_method_seen(*law);
                        terms().filter(is_better).or(Some(shown))
                    }
                    shown => shown.or_else(terms),
                }
            }
            (EarnedFor::Law(law, _), _) if law.seen() == Seen::Unknown => self.solved(),
            (EarnedFor::Law(law, sphere), code) => match self.by_law(*law, *sphere, code) {
                Some(shown) if shown.given => Some(shown),
                shown => {
                    let by_direction = || self.by_direction(*law, *sphere, code);
                    self.by_own(*law, code)
                        .or_else(by_direction)
                        .or(shown)
                        .or_else(|| self.direction_by_deflection(mark))
                }
            },
            (EarnedFor::Condition, _) => self.uses_condition(mark),
            (EarnedFor::Quantity(_) | EarnedFor::Both(_), code) => {
                self.own_values(code, mark).or_else(|| self.direction_by_deflection(mark))
            }
            (EarnedFor::Unknown(_), _) => None,
        }?;
        let studied = &mut self.lines[shown.line];
        let reading = studied.reading.as_ref().map(|reading| reading.printed.clone()).unwrap_or_default();
        // What a line might be by its form, wrong in its method, is not what it is by its terms.
        let is_by_form = studied.matched.iter().any(Matched::is_method) || !shown.given;
        if studied.role.is_empty() || !studied.matched.is_empty() && !is_by_form {
            studied.role = shown.role.clone();
        }
        Some(Award {
            id: mark.id.clone(),
            code: mark.code,
            given: shown.given,
            by: Examiner::Marker,
            note: shown.note,
            evidence: Some(Evidence { place: Place::Line(studied.line.number), reading }),
            feedback: self.question.said_of_impact(&shown.feedback),
        })
    }

    /// Does the solution have this law as one of its two equations?
    fn uses_pair(&self, law: Law) -> bool {
        let given = Quantity::Velocity(Sphere::A, Moment::After, Axis::X);
        let mut steps = self.part.derivation.steps.iter().filter(|step| step.law == law);
        steps.any(|step| step.gives.iter().any(|gives| BOTH.contains(gives)))
            || (self.prepared.laws.is_some() && !self.prepared.given[0].0.contains_key(&given))
    }

    /// Is a line by its form one of the two equations as far as its method goes?
    fn is_method_seen(&self, law: Law) -> bool {
        let mut matched = self.lines.iter().flat_map(|studied| &studied.matched);
        matched.any(|matched| law.gives(matched.equation) && matched.is_method())
    }
}
