//! Which marks the lines of a part earn.

use std::collections::BTreeMap;

use super::laws::Evidence as Shown;
use super::line::{self, Line, ReadLine};
use super::linear::{Context, Linear, Sum, difference};
use super::pair::{Convention, Departure, Matched, conventions, sphere};
use super::points::sizes;
use super::prepared::{Prepared, complete};
use super::spread::Spread;
use crate::bank::{Code, EarnedFor, Find};
use crate::expr::Expr;
use crate::mark::award::{Award, Evidence, Examiner, MarkedLine, Place};
use crate::mark::key::{KeyedMark, KeyedPart, KeyedQuestion};
use crate::mark::reading::{Form, Reading};
use crate::mechanics::{Axis, Datum, Known, Law, Moment, Quantity, Sphere};

/// A student's own values, by quantity: at every point, and as they were written.
#[derive(Clone, Debug, Default)]
pub(crate) struct Theirs(pub(crate) BTreeMap<Quantity, (Vec<f64>, Expr)>);

impl Theirs {
    /// Those that are not right, as they were written.
    pub(crate) fn wrong<'t>(&'t self, question: &'t KeyedQuestion) -> impl Iterator<Item = (Quantity, &'t Expr)> {
        let right = |quantity: &Quantity| sizes(&question.prepared().known, *quantity).unwrap_or_default();
        let near = |(own, right): (&f64, &f64)| (own - right).abs() <= 0.01 * right.abs();
        self.0.iter().filter_map(move |(quantity, (values, written))| {
            let is_right = values.iter().zip(&right(quantity)).all(near);
            (!is_right).then_some((*quantity, written))
        })
    }

    /// Takes the answers that were read as numbers, for the parts that follow: right or not, the student goes on with
    /// them.
    pub(crate) fn take_answers(
        &mut self,
        question: &KeyedQuestion,
        part: &KeyedPart,
        answers: &[Option<Vec<Reading>>],
    ) {
        let prepared = question.prepared();
        for (blank, readings) in part.blanks.iter().zip(answers) {
            let Some(reading) = readings.as_ref().and_then(|readings| readings.first()) else { continue };
            let Some(said) = reading.statements.last().and_then(|statement| statement.said.last()) else { continue };
            match (&blank.find, &said.form) {
                (Find::Quantity(quantity), Form::Value(expr)) if !quantity.is_angle() => {
                    let numbers = value(expr, prepared, &prepared.names).and_then(|values| numbers(&values));
                    self.0.extend(numbers.map(|numbers| (*quantity, (numbers, expr.clone()))));
                }
                (Find::Vector(x, y), Form::Vector(along_i, along_j, _)) => {
                    for (quantity, expr) in [(x, along_i), (y, along_j)] {
                        let numbers = value(expr, prepared, &prepared.names).and_then(|values| numbers(&values));
                        self.0.extend(numbers.map(|numbers| (*quantity, (numbers, expr.clone()))));
                    }
                }
                _ => {}
            }
        }
    }
}

fn numbers(values: &[Value]) -> Option<Vec<f64>> {
    let number = |value: &Value| match value {
        Value::Number(spread) => Some(spread.middle()),
        Value::Vector(..) => None,
    };
    values.iter().map(number).collect()
}

/// What looking through the working of a part found.
pub(crate) struct Examined {
    /// For each mark of the scheme an award, if the lines say anything of it.
    pub(crate) awards: Vec<Option<Award>>,
    /// What each line is.
    pub(crate) lines: Vec<MarkedLine>,
    /// The values that the student found, in this part and before.
    pub(crate) theirs: Theirs,
    /// What follows from them, at every point.
    pub(crate) followed: Vec<Known<f64>>,
}

/// A line with what it comes to.
pub(super) struct Studied {
    pub(super) line: Line,
    /// The reading that was used.
    pub(super) reading: Option<ReadLine>,
    /// The value of each member at every point: a number, or a vector.
    pub(super) values: Vec<Option<Vec<Value>>>,
    /// Which of the two equations it is; one of each if it has both.
    pub(super) matched: Vec<Matched>,
    pub(super) role: String,
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
    names: Vec<(String, Vec<f64>)>,
}

/// Looks through the working of a part; `before` is what the student found in earlier parts.
pub(crate) fn examine(question: &KeyedQuestion, part: &KeyedPart, working: &[String], before: &Theirs) -> Examined {
    let prepared = question.prepared();
    let vectors = has_vectors(question);
    let read = line::read(working, &question.letters, vectors);
    let mut lines: Vec<Studied> = read
        .into_iter()
        .map(|line| {
            let reading = line.readings.first().cloned();
            Studied { line, reading, values: Vec::new(), matched: Vec::new(), role: String::new() }
        })
        .collect();
    let convention = take_as_laws(&mut lines, prepared);
    evaluate(&mut lines, prepared, &prepared.names);
    let mut theirs = before.clone();
    let found = own_values(&lines, convention.as_ref(), part, prepared);
    theirs.0.extend(found);
    let followed = follow(prepared, &theirs);
    let names = Vec::new();
    let mut working = Working { question, prepared, part, lines, convention, theirs, followed, names };
    // Now that it is known what the student's letters stand for, formulas with them have values.
    working.names = working.names(&|quantity| {
        working.theirs.0.get(&quantity).map(|(values, _)| values.clone()).or_else(|| sizes(&prepared.known, quantity))
    });
    evaluate(&mut working.lines, prepared, &working.names);
    let awards = part.scheme.iter().map(|mark| working.award(mark)).collect();
    let lines = working.lines.iter().map(|studied| MarkedLine {
        typed: studied.line.typed.clone(),
        reading: studied.reading.as_ref().map(|reading| reading.printed.clone()),
        role: studied.role.clone(),
    });
    let lines = lines.collect();
    Examined { awards, lines, theirs: working.theirs, followed: working.followed }
}

fn has_vectors(question: &KeyedQuestion) -> bool {
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
fn evaluate(lines: &mut [Studied], prepared: &Prepared, names: &[(String, Vec<f64>)]) {
    for studied in lines {
        let members = studied.reading.as_ref().map(|reading| reading.members.as_slice()).unwrap_or_default();
        studied.values = members.iter().map(|member| value(&member.expr, prepared, names)).collect();
    }
}

/// What a formula without unknowns comes to at every point.
fn value(expr: &Expr, prepared: &Prepared, names: &[(String, Vec<f64>)]) -> Option<Vec<Value>> {
    let at = |point| match super::linear::sum(expr, &Context { given: names, ..context(prepared, point) })? {
        Sum::Number(linear) if linear.is_number() => Some(Value::Number(linear.constant)),
        Sum::Vector(x, y) if x.is_number() && y.is_number() => Some(Value::Vector(x.constant, y.constant)),
        _ => None,
    };
    (0..prepared.points.count).map(at).collect()
}

/// Left minus right of an equation at every point; of a vector the component along the line of centres.
fn differences(equation: &(Expr, Expr), prepared: &Prepared) -> Option<Vec<Linear>> {
    let at = |point| match difference(&equation.0, &equation.1, &context(prepared, point))? {
        Sum::Number(linear) => Some(linear),
        Sum::Vector(x, y) => {
            let line = |axis| prepared.known[point].number(Quantity::Line(axis)).map(Spread::exactly);
            Some(x.times(line(Axis::X)?).plus(&y.times(line(Axis::Y)?)))
        }
    };
    (0..prepared.points.count).map(at).collect()
}

/// The place of a line, which of its readings, and what it is.
type Found = (usize, usize, Matched);

/// Finds the lines that are momentum or restitution, and the student's choice of letters and directions that makes them
/// agree best.
fn take_as_laws(lines: &mut [Studied], prepared: &Prepared) -> Option<Convention> {
    let laws = prepared.laws.as_ref()?;
    // Every equation of every reading that is more than `v = 3`.
    let mut offered: Vec<(usize, usize, Vec<Linear>)> = Vec::new();
    for (place, studied) in lines.iter().enumerate() {
        for (which, reading) in studied.line.readings.iter().enumerate() {
            for equation in reading.equations.iter().filter(|equation| !is_value(equation)) {
                if let Some(linear) = differences(equation, prepared)
                    && (1..=2).contains(&linear[0].unknowns.len())
                {
                    offered.push((place, which, linear));
                }
            }
        }
    }
    let pairs = pairs(&offered, lines);
    let matches = |convention: &Convention| -> Vec<Found> {
        let each = offered.iter();
        each.filter_map(|(place, which, linear)| Some((*place, *which, laws.matched(linear, convention)?))).collect()
    };
    let mut best: Option<(u32, Convention, Vec<Found>)> = None;
    for convention in pairs.iter().flat_map(|pair| conventions(pair)) {
        let found = matches(&convention);
        let weight = weight(&found) + u32::from(convention.is_unusual) + disagreement(lines, &convention, prepared);
        if best.as_ref().is_none_or(|(least, ..)| weight < *least) {
            best = Some((weight, convention, found));
        }
        if weight == 0 {
            break;
        }
    }
    let (_, convention, found) = best?;
    for (place, which, matched) in found {
        let studied = &mut lines[place];
        let own = studied.matched.iter().position(|before| before.law == matched.law);
        match own {
            Some(own) if studied.matched[own].weight() <= matched.weight() => continue,
            Some(own) => studied.matched[own] = matched,
            None => studied.matched.push(matched),
        }
        studied.reading = Some(studied.line.readings[which].clone());
    }
    for studied in lines.iter_mut() {
        studied.role = studied.matched.iter().map(role).collect::<Vec<_>>().join("; ");
    }
    Some(convention)
}

/// Do the values that are stated speak against this choice? Where masses are equal the two equations do not tell.
fn disagreement(lines: &[Studied], convention: &Convention, prepared: &Prepared) -> u32 {
    let disagrees = |place: usize| {
        let right = sizes(&prepared.known, Quantity::Velocity(Sphere::BOTH[place], Moment::After, Axis::N));
        let members = lines.iter().filter_map(|studied| studied.reading.as_ref()).flat_map(|reading| &reading.members);
        let mut own = members.filter(|member| member.letter.as_ref() == Some(&convention.letters[place]));
        right.is_some_and(|right| {
            own.any(|member| {
                let values = value(&member.expr, prepared, &prepared.names).and_then(|values| numbers(&values));
                let near =
                    |(own, right): (&f64, &f64)| (own * convention.signs[place] - right).abs() < 0.01 * right.abs();
                values.is_some_and(|values| !values.iter().zip(&right).all(near))
            })
        })
    };
    2 * (0..2).filter(|place| disagrees(*place)).count() as u32
}

/// What the best line of each law is short of; a law without a line costs more than any line.
fn weight(found: &[Found]) -> u32 {
    let least =
        |law| found.iter().filter(|(.., matched)| matched.law == law).map(|(.., matched)| matched.weight()).min();
    [Law::Momentum, Law::Restitution].into_iter().map(|law| least(law).unwrap_or(20)).sum()
}

fn role(matched: &Matched) -> String {
    let law = matched.law.name();
    match matched.departures.as_slice() {
        [] => law.to_owned(),
        departures => {
            let reasons: Vec<&str> = departures.iter().map(|departure| departure.sentence()).collect();
            format!("{law}: {}", reasons.join("; "))
        }
    }
}

/// Is it `v = 3` or `3 = v`?
fn is_value((left, right): &(Expr, Expr)) -> bool {
    let is_letter = |expr: &Expr| matches!(expr, Expr::Name(_));
    (is_letter(left) && right.names().is_empty()) || (is_letter(right) && left.names().is_empty())
}

/// Pairs of unknowns that stand together in an equation, the most frequent first; else those that usually do.
fn pairs(offered: &[(usize, usize, Vec<Linear>)], lines: &[Studied]) -> Vec<Vec<String>> {
    let mut counted: Vec<(Vec<String>, usize)> = Vec::new();
    for (.., linear) in offered {
        let mut names: Vec<String> = linear[0].unknowns.iter().map(|(name, _)| name.clone()).collect();
        names.sort();
        if names.len() == 2 {
            match counted.iter_mut().find(|(known, _)| *known == names) {
                Some((_, count)) => *count += 1,
                None => counted.push((names, 1)),
            }
        }
    }
    counted.sort_by_key(|(_, count)| std::cmp::Reverse(*count));
    let mut pairs: Vec<Vec<String>> = counted.into_iter().map(|(names, _)| names).take(2).collect();
    if pairs.is_empty() {
        let letters: Vec<String> = lines
            .iter()
            .filter_map(|studied| studied.reading.as_ref())
            .flat_map(|reading| reading.members.iter().filter_map(|member| member.letter.clone()))
            .chain(offered.iter().flat_map(|(.., linear)| linear[0].unknowns.iter().map(|(name, _)| name.clone())))
            .collect();
        let usual = [["v_A", "v_B"], ["v_1", "v_2"], ["V_A", "V_B"], ["v", "w"], ["V", "W"], ["x", "y"]];
        let used = |pair: &&[&str; 2]| pair.iter().any(|name| letters.iter().any(|letter| letter == name));
        pairs.extend(usual.iter().find(used).map(|pair| pair.iter().map(|name| (*name).to_owned()).collect()));
    }
    pairs
}

/// The values that the student states for quantities.
fn own_values(
    lines: &[Studied],
    convention: Option<&Convention>,
    part: &KeyedPart,
    prepared: &Prepared,
) -> BTreeMap<Quantity, (Vec<f64>, Expr)> {
    let mut found = BTreeMap::new();
    for studied in lines {
        let Some(reading) = &studied.reading else { continue };
        for (member, values) in reading.members.iter().zip(&studied.values) {
            let (Some(letter), Some(values)) = (&member.letter, values) else { continue };
            let numbers = numbers(values);
            let place = convention.and_then(|convention| convention.letters.iter().position(|known| known == letter));
            match (numbers, place, convention) {
                (Some(numbers), Some(place), Some(convention)) => {
                    let own = Quantity::Velocity(Sphere::BOTH[place], Moment::After, Axis::N);
                    // A letter may also be used for the speed that is found from it in the end.
                    if !is_asked_speed(part, Sphere::BOTH[place], &numbers, prepared) || !found.contains_key(&own) {
                        let sign = convention.signs[place];
                        let written = if sign < 0.0 { member.expr.clone().negated() } else { member.expr.clone() };
                        found.insert(own, (numbers.iter().map(|number| number * sign).collect(), written));
                    }
                }
                (None, ..) => {
                    let of = sphere(letter).or(unknown_sphere(prepared));
                    let vector = |component: fn(&Value) -> Option<Spread>| -> Option<Vec<f64>> {
                        values.iter().map(|value| component(value).map(Spread::middle)).collect()
                    };
                    let is_after = letter.starts_with(['v', 'V', 'w']);
                    if let (Some(of), true) = (of, is_after)
                        && let (Some(x), Some(y)) = (vector(first), vector(second))
                    {
                        if let Expr::Vector(along_i, along_j) = &member.expr {
                            found.insert(Quantity::Velocity(of, Moment::After, Axis::X), (x, (**along_i).clone()));
                            found.insert(Quantity::Velocity(of, Moment::After, Axis::Y), (y, (**along_j).clone()));
                        }
                    }
                }
                _ => {}
            }
        }
    }
    let is_own = |quantity: &Quantity| !prepared.given[0].0.contains_key(quantity);
    found.retain(|quantity, (values, _)| is_own(quantity) && values.iter().all(|value| value.is_finite()));
    found
}

fn first(value: &Value) -> Option<Spread> {
    match value {
        Value::Vector(x, _) => Some(*x),
        Value::Number(_) => None,
    }
}

fn second(value: &Value) -> Option<Spread> {
    match value {
        Value::Vector(_, y) => Some(*y),
        Value::Number(_) => None,
    }
}

/// Is the value the speed that the part asks for, rather than the component?
fn is_asked_speed(part: &KeyedPart, sphere: Sphere, values: &[f64], prepared: &Prepared) -> bool {
    let speed = Quantity::Speed(sphere, Moment::After);
    let asked = part.blanks.iter().any(|blank| blank.find.quantities().contains(&speed));
    let right = sizes(&prepared.known, speed);
    asked
        && right
            .is_some_and(|right| right.iter().zip(values).all(|(right, value)| (right - value).abs() < 0.006 * right))
}

/// The sphere whose velocity after the impact is to be found, where that of the other is given.
fn unknown_sphere(prepared: &Prepared) -> Option<Sphere> {
    let given = |sphere| prepared.given[0].0.contains_key(&Quantity::Velocity(sphere, Moment::After, Axis::X));
    match (given(Sphere::A), given(Sphere::B)) {
        (true, false) => Some(Sphere::B),
        (false, true) => Some(Sphere::A),
        _ => None,
    }
}

/// What follows from what is given and from the student's own values.
///
/// A value that would make the rest trivial is not followed: nought where nothing is nought, a coefficient of restitution
/// that is none.
pub(super) fn follow(prepared: &Prepared, theirs: &Theirs) -> Vec<Known<f64>> {
    let mut at_points = prepared.given.clone();
    for (quantity, (values, _)) in &theirs.0 {
        let right = sizes(&prepared.known, *quantity);
        let trivial = match quantity {
            Quantity::Restitution => values.iter().any(|value| !(0.0..=1.0).contains(value)),
            _ => right
                .is_some_and(|right| right.iter().zip(values).any(|(right, own)| *own == 0.0 && right.abs() > 1e-9)),
        };
        if !trivial {
            for (known, value) in at_points.iter_mut().zip(values) {
                known.0.insert(*quantity, Datum::Number(*value));
            }
        }
    }
    at_points.iter().map(complete).collect()
}

impl Working<'_> {
    /// The names that are given, and the student's letters for the components after the impact, which are these.
    pub(super) fn names(&self, component: &dyn Fn(Quantity) -> Option<Vec<f64>>) -> Vec<(String, Vec<f64>)> {
        let mut names = self.prepared.names.clone();
        if let Some(convention) = &self.convention {
            for (place, letter) in convention.letters.iter().enumerate() {
                let values = component(Quantity::Velocity(Sphere::BOTH[place], Moment::After, Axis::N));
                let signed = |values: Vec<f64>| values.iter().map(|value| value * convention.signs[place]).collect();
                names.extend(values.map(|values| (letter.clone(), signed(values))));
            }
        }
        names
    }

    /// What formulas are evaluated with at a point.
    pub(super) fn context(&self, point: usize) -> Context<'_> {
        Context { given: &self.names, ..context(self.prepared, point) }
    }

    /// What the lines say of a mark.
    fn award(&mut self, mark: &KeyedMark) -> Option<Award> {
        let shown = match (&mark.earned_for, mark.code) {
            (_, Code::A1Shown) => None,
            (EarnedFor::Law(law @ (Law::Momentum | Law::Restitution), _), code) if self.uses_pair(*law) => {
                self.pair_equation(*law, code)
            }
            (EarnedFor::Law(Law::Solve, _), _) => self.solved(),
            (EarnedFor::Law(law, sphere), code) => self.by_law(*law, *sphere, code),
            (EarnedFor::Condition, _) => self.uses_condition(mark),
            (EarnedFor::Quantity(quantity), code) => self.value_of(*quantity, code, mark),
            (EarnedFor::Unknown(_), _) => None,
        }?;
        let studied = &mut self.lines[shown.line];
        let reading = studied.reading.as_ref().map(|reading| reading.printed.clone()).unwrap_or_default();
        if studied.role.is_empty() {
            studied.role = shown.role.clone();
        }
        Some(Award {
            id: mark.id.clone(),
            code: mark.code,
            given: shown.given,
            by: Examiner::Marker,
            note: shown.note,
            evidence: Some(Evidence { place: Place::Line(studied.line.number), reading }),
            feedback: shown.feedback,
        })
    }

    /// Does the solution have this law as one of its two equations?
    fn uses_pair(&self, law: Law) -> bool {
        let equation =
            |quantity: &Quantity| matches!(quantity, Quantity::MomentumEquation | Quantity::RestitutionEquation);
        let own = self.part.derivation.steps.iter().any(|step| step.law == law && step.gives.iter().any(equation));
        own || self.prepared.laws.is_some()
            && !self.prepared.given[0].0.contains_key(&Quantity::Velocity(Sphere::A, Moment::After, Axis::X))
    }

    /// A mark for one of the two equations.
    fn pair_equation(&self, law: Law, code: Code) -> Option<Shown> {
        let own = self.lines.iter().enumerate().filter_map(|(place, studied)| {
            studied.matched.iter().find(|matched| matched.law == law).map(|matched| (place, matched))
        });
        let (line, best) = own.min_by_key(|(_, matched)| matched.weight())?;
        let given = if code.is_accuracy() { best.departures.is_empty() } else { best.is_method() };
        let lost = |departure: &&Departure| code.is_accuracy() || !departure.is_condoned();
        let reason = best.departures.iter().find(lost);
        let note = if given { None } else { reason.map(|departure| departure.tag()) };
        let feedback = match (given, reason) {
            (false, Some(departure)) => departure.sentence().to_owned(),
            (true, _) if !best.departures.is_empty() => {
                let condoned: Vec<&str> = best.departures.iter().map(|departure| departure.sentence()).collect();
                format!("condoned here: {}", condoned.join("; "))
            }
            _ => String::new(),
        };
        Some(Shown { line, given, note, feedback, role: law.name().to_owned() })
    }

    /// The mark for solving the two equations: a value of one of the unknowns follows them.
    fn solved(&self) -> Option<Shown> {
        let convention = self.convention.as_ref()?;
        let states = |studied: &Studied| {
            let members = studied.reading.as_ref().map(|reading| reading.members.as_slice()).unwrap_or_default();
            members.iter().zip(&studied.values).any(|(member, value)| {
                let is_unknown = member.letter.as_ref().is_some_and(|letter| convention.letters.contains(letter));
                is_unknown && value.is_some()
            })
        };
        let line = self.lines.iter().position(states)?;
        Some(Shown { line, given: true, note: None, feedback: String::new(), role: "the equations solved".to_owned() })
    }
}
