//! What answers show of the steps that lead to them, though they are wrong: a component that has not changed, and the
//! solution of the student's own equations.

use std::borrow::Cow;

use super::equations::Departure;
use super::examine::{Examined, Value, Working, value};
use super::laws::{ToBeSubtracted, along_for, is_of_deflection};
use super::numbers::{is_vector, sizes};
use super::prepared::Prepared;
use super::theirs::Theirs;
use crate::bank::{Code, EarnedFor, Find};
use crate::expr::Expr;
use crate::mark::award::{Award, Evidence, Examiner, Place};
use crate::mark::key::{KeyedMark, KeyedPart, KeyedQuestion};
use crate::mark::reading::{Form, Reading};
use crate::mechanics::{Axis, Law, Moment, Quantity, Seen, Setting, Sphere};

impl Examined {
    /// Gives the marks for steps that no line shows and the answers do; `before` is what the student found in earlier parts.
    pub(crate) fn see_in_answers<'r>(
        &mut self,
        question: &KeyedQuestion,
        part: &KeyedPart,
        before: &Theirs,
        answers: impl Iterator<Item = Option<&'r [Reading]>>,
    ) {
        let said: Vec<Option<(Expr, String)>> = answers.map(|readings| said(readings?)).collect();
        if are_on_the_other_axis(question.prepared(), part, &said) {
            self.lose_laws_of_other_axis(part);
        }
        let is_open = |mark: &KeyedMark, award: &Option<Award>| {
            let law = match mark.earned_for {
                EarnedFor::Law(law, _) if matches!(law.seen(), Seen::Unchanged | Seen::Unknown) => law,
                EarnedFor::Law(law, _) if law.gives(Quantity::EnergyLost) => law,
                EarnedFor::Law(law, _) if mark.code.is_method() && is_of_deflection(law) => law,
                EarnedFor::Law(law, _) if mark.code.is_method() && law.gives(Quantity::RestitutionEquation) => law,
                _ => return None,
            };
            // A line has the component changed: an answer is not what it stayed.
            let is_changed = |award: &Award| award.note == Some(Departure::WrongAxis.tag());
            award.as_ref().is_none_or(|award| !award.given && !is_changed(award)).then_some(law)
        };
        let marks = part.scheme.iter().zip(&self.awards).enumerate();
        let open: Vec<(usize, Law)> =
            marks.filter_map(|(place, (mark, award))| Some((place, is_open(mark, award)?))).collect();
        if open.is_empty() {
            return;
        }
        for (place, law) in open {
            let mark = &part.scheme[place];
            let shown = match law.seen() {
                Seen::Unchanged => unchanged(question, part, before, &said).or_else(|| {
                    let solution = self.solution.as_ref()?;
                    unchanged_in_speeds(question, part, solution, &said)
                }),
                Seen::Equation => rebounds(question, part, &said),
                Seen::Value(..) if is_of_deflection(law) && mark.code == Code::M1 => {
                    turned(question.prepared(), part, &self.turns, &said)
                }
                Seen::Value(..) if is_of_deflection(law) => self.cleared_in_answers(part, law, &said),
                Seen::Value(..) => {
                    let energies = self.to_be_subtracted.as_ref().filter(|own| own.allows(mark.code));
                    energies.and_then(|own| subtracted(question.prepared(), part, own, &said))
                }
                _ => self.solution.as_ref().and_then(|solution| solved(question.prepared(), part, solution, &said)),
            };
            let Some(blank) = shown else { continue };
            let reading = said[blank].as_ref().map(|(_, printed)| printed.clone()).unwrap_or_default();
            self.awards[place] = Some(Award {
                id: mark.id.clone(),
                code: mark.code,
                given: true,
                by: Examiner::Marker,
                note: None,
                evidence: Some(Evidence { place: Place::Answer(blank), reading }),
                feedback: String::new(),
            });
        }
    }
}

impl Examined {
    /// Without the two equations, which were written for the components that do not change: in numbers they may be the same.
    fn lose_laws_of_other_axis(&mut self, part: &KeyedPart) {
        let is_law =
            |mark: &KeyedMark| matches!(mark.earned_for, EarnedFor::Law(law, _) if law.seen() == Seen::Equation);
        for (_, award) in part.scheme.iter().zip(&mut self.awards).filter(|(mark, _)| is_law(mark)) {
            if let Some(award) = award.as_mut().filter(|award| award.given) {
                let feedback = Departure::WrongAxis.sentence().to_owned();
                *award = Award { given: false, note: Some(Departure::WrongAxis.tag()), feedback, ..award.clone() };
            }
        }
    }
}

/// Do the vectors of both spheres keep the component along the line of centres, which lies along i or j, and change the other,
/// where both are of one size before the impact, so that equations do not tell which of them is meant?
fn are_on_the_other_axis(prepared: &Prepared, part: &KeyedPart, said: &[Option<(Expr, String)>]) -> bool {
    let [known] = prepared.known.as_slice() else { return false };
    let both = |of: &dyn Fn(Axis) -> Quantity| known.numbers([Axis::X, Axis::Y].map(of));
    let Some(line) = both(&Quantity::Line).filter(|line| line.iter().any(|one| one.abs() < 1e-9)) else { return false };
    let (along, across) = if line[0].abs() < 1e-9 { (1, 0) } else { (0, 1) };
    let is_kept = |sphere: Sphere| {
        let find =
            |find: &Find| matches!(find, Find::Vector(Quantity::Velocity(own, Moment::After, _), _) if *own == sphere);
        let place = part.blanks.iter().position(|blank| find(&blank.find))?;
        let (expr, _) = said[place].as_ref()?;
        let [Value::Vector(x, y)] = value(expr, prepared, &prepared.names)?[..] else { return None };
        let (own, [before, after]) = (
            [x.middle(), y.middle()],
            [
                both(&|axis| Quantity::Velocity(sphere, Moment::Before, axis))?,
                both(&|axis| Quantity::Velocity(sphere, Moment::After, axis))?,
            ],
        );
        let is = |one: f64, other: f64| (one - other).abs() <= 1e-9;
        Some(
            is(before[along].abs(), before[across].abs())
                && is(own[along], before[along])
                && !is(before[along], after[along])
                && !is(own[across], before[across]),
        )
    };
    Sphere::BOTH.into_iter().all(|sphere| is_kept(sphere) == Some(true))
}

/// The value or the vector that an answer ends with, and how the answer is read.
fn said(readings: &[Reading]) -> Option<(Expr, String)> {
    let reading = readings.first()?;
    let expr = match &reading.statements.last()?.said.last()?.form {
        Form::Value(expr) => expr.clone(),
        Form::Vector(x, y, _) => Expr::Vector(Box::new(x.clone()), Box::new(y.clone())),
        _ => return None,
    };
    Some((expr, reading.printed.clone()))
}

/// The last blank with a vector, if the component across the line of centres is in those of all spheres that have one.
fn unchanged(
    question: &KeyedQuestion,
    part: &KeyedPart,
    before: &Theirs,
    said: &[Option<(Expr, String)>],
) -> Option<usize> {
    let vectors = part.blanks.iter().zip(said).enumerate().filter_map(|(place, (blank, said))| match blank.find {
        Find::Vector(x, _) => Some((place, x, &said.as_ref()?.0)),
        _ => None,
    });
    let vectors: Vec<(usize, Quantity, &Expr)> = vectors.collect();
    let (last, first, _) = *vectors.last()?;
    let meeting = question.meeting(first.impact());
    let impact = match meeting {
        Some(meeting) => question.impact(meeting, before)?,
        None => Cow::Borrowed(question),
    };
    let working = Working::without_lines(&impact, part);
    let of = |quantity: Quantity| match meeting {
        Some(meeting) => meeting.in_law(quantity),
        None => Some(quantity),
    };
    let has = |(sphere, right): &(Sphere, Vec<f64>)| {
        vectors.iter().any(|(_, quantity, expr)| {
            let is_own = of(*quantity).is_some_and(
                |quantity| matches!(quantity, Quantity::Velocity(own, Moment::After, _) if own == *sphere),
            );
            let values = value(expr, working.prepared, &working.prepared.names);
            let has_it = |values: Vec<Value>| {
                working.has_component(&values, *sphere, right) || working.keeps_part_along_wall(&values, right)
            };
            is_own && values.is_some_and(has_it)
        })
    };
    let across = working.across();
    (!across.is_empty() && across.iter().all(has)).then_some(last)
}

/// The last blank with a speed, if those of all spheres that have a component across the line of centres are made of it and of
/// what the student's own equations come to.
fn unchanged_in_speeds(
    question: &KeyedQuestion,
    part: &KeyedPart,
    solution: &[Vec<f64>; 2],
    said: &[Option<(Expr, String)>],
) -> Option<usize> {
    let working = Working::without_lines(question, part);
    let blank_of = |(sphere, _): &(Sphere, Vec<f64>)| {
        let is_speed = |find: &Find| *find == Find::Quantity(Quantity::Speed(*sphere, Moment::After));
        let place = part.blanks.iter().position(|blank| is_speed(&blank.find))?;
        let (expr, _) = said[place].as_ref()?;
        let values = value(expr, working.prepared, &working.prepared.names)?;
        let own = own_speed(working.prepared, *sphere, solution)?;
        are_near_sizes(&values, &own).then_some(place)
    };
    let places: Vec<usize> = working.across().iter().map(blank_of).collect::<Option<_>>()?;
    places.into_iter().max()
}

/// The speed of a sphere by what the student's own equations come to, and the component that does not change.
fn own_speed(prepared: &Prepared, sphere: Sphere, solution: &[Vec<f64>; 2]) -> Option<Vec<f64>> {
    let across = sizes(&prepared.known, Quantity::Velocity(sphere, Moment::After, Axis::T));
    let along = solution.get(usize::from(sphere == Sphere::B))?;
    let speed = |(point, along): (usize, &f64)| along.hypot(across.as_ref().map_or(0.0, |all| all[point]));
    Some(along.iter().enumerate().map(speed).collect())
}

/// A blank with the velocity after an impact with a wall, if only the sense of the component is wrong that the wall turns round.
fn rebounds(question: &KeyedQuestion, part: &KeyedPart, said: &[Option<(Expr, String)>]) -> Option<usize> {
    part.blanks.iter().zip(said).position(|(blank, said)| {
        let (Find::Vector(first, _), Some((expr, _))) = (&blank.find, said) else { return false };
        let impact = match question.meeting(first.impact()) {
            Some(meeting) => question.impact(meeting, &Theirs::default()),
            None => Some(Cow::Borrowed(question)),
        };
        let Some(impact) = impact else { return false };
        let prepared = impact.prepared();
        let turned = prepared.known.iter().map(|known| {
            let after = |axis| known.number(Quantity::Velocity(Sphere::A, Moment::After, axis));
            let line = |axis| known.number(Quantity::Line(axis));
            let ([x, y], [i, j]) = ([after(Axis::X)?, after(Axis::Y)?], [line(Axis::X)?, line(Axis::Y)?]);
            let into = x * i + y * j;
            Some((x - 2.0 * into * i, y - 2.0 * into * j))
        });
        let turned = turned.collect::<Option<(Vec<f64>, Vec<f64>)>>();
        let values = value(expr, prepared, &prepared.names);
        prepared.setting == Setting::Wall
            && turned.zip(values).is_some_and(|((x, y), values)| is_vector(&values, &x, &y, 1.0))
    })
}

/// A blank with what the student's own equations come to for one of the spheres.
fn solved(
    prepared: &Prepared,
    part: &KeyedPart,
    solution: &[Vec<f64>; 2],
    said: &[Option<(Expr, String)>],
) -> Option<usize> {
    let of = |sphere: Sphere| &solution[usize::from(sphere == Sphere::B)];
    let is = |(find, said): (&Find, &Option<(Expr, String)>)| {
        let Some(values) = said.as_ref().and_then(|(expr, _)| value(expr, prepared, &prepared.names)) else {
            return false;
        };
        match find {
            Find::Quantity(Quantity::Speed(sphere, Moment::After)) => {
                own_speed(prepared, *sphere, solution).is_some_and(|own| are_near_sizes(&values, &own))
            }
            Find::Quantity(quantity) => match along_for(*quantity, prepared) {
                Quantity::Velocity(sphere, Moment::After, Axis::N) => are_near_sizes(&values, of(sphere)),
                _ => false,
            },
            Find::Vector(Quantity::Velocity(sphere, Moment::After, _), _) => are_along(&values, of(*sphere), prepared),
            _ => false,
        }
    };
    let finds: Vec<&Find> = part.blanks.iter().map(|blank| &blank.find).collect();
    finds.into_iter().zip(said).position(is)
}

impl ToBeSubtracted {
    /// Does a mark of this code condone that an energy is the student's own?
    fn allows(&self, code: Code) -> bool {
        self.is_right || !code.is_accuracy() || code == Code::A1FollowThrough
    }
}

/// A blank for the energy lost with the difference of the two energies that stand in the lines.
fn subtracted(
    prepared: &Prepared,
    part: &KeyedPart,
    energies: &ToBeSubtracted,
    said: &[Option<(Expr, String)>],
) -> Option<usize> {
    part.blanks.iter().zip(said).position(|(blank, said)| {
        let is_loss = blank.find.quantities().iter().any(|find| find.of_its_impact() == Quantity::EnergyLost);
        let values = said.as_ref().filter(|_| is_loss).and_then(|(expr, _)| value(expr, prepared, &prepared.names));
        values.is_some_and(|values| are_near_sizes(&values, &energies.difference))
    })
}

/// A blank for a deflection with what two directions that stand in the lines come to.
fn turned(prepared: &Prepared, part: &KeyedPart, turns: &[Vec<f64>], said: &[Option<(Expr, String)>]) -> Option<usize> {
    part.blanks.iter().zip(said).position(|(blank, said)| {
        let is_turn = blank.find.quantities().iter().any(|find| matches!(find, Quantity::Deflection(_)));
        let values = said.as_ref().filter(|_| is_turn).and_then(|(expr, _)| value(expr, prepared, &prepared.names));
        values.is_some_and(|values| turns.iter().any(|turn| are_near_sizes(&values, turn)))
    })
}

/// Are they these numbers but for their signs, rounded perhaps on the way?
fn are_near_sizes(values: &[Value], sizes: &[f64]) -> bool {
    values.iter().zip(sizes).all(|(value, size)| match value {
        Value::Number(number) => is_near(number.middle().abs(), size.abs()),
        Value::Vector(..) => false,
    })
}

/// Are they vectors with these components along the line of centres?
fn are_along(values: &[Value], sizes: &[f64], prepared: &Prepared) -> bool {
    values.iter().zip(sizes).zip(&prepared.known).all(|((value, size), known)| {
        let line = [Axis::X, Axis::Y].map(|axis| known.number(Quantity::Line(axis)));
        match (value, line) {
            (Value::Vector(x, y), [Some(i), Some(j)]) => is_near(x.middle() * i + y.middle() * j, *size),
            _ => false,
        }
    })
}

fn is_near(own: f64, other: f64) -> bool {
    other.abs() > 1e-9 && (own - other).abs() <= 0.005 * other.abs()
}

impl<'a> Working<'a> {
    /// Nothing but the question.
    fn without_lines(question: &'a KeyedQuestion, part: &'a KeyedPart) -> Working<'a> {
        Working {
            question,
            prepared: question.prepared(),
            part,
            lines: Vec::new(),
            convention: None,
            theirs: Theirs::default(),
            followed: Vec::new(),
            names: Vec::new(),
            by_numbers: Default::default(),
        }
    }

    /// A line with a vector that has in it what the student's own equations come to.
    pub(super) fn solved_in_vectors(&self) -> Option<usize> {
        let solution = self.own_solution()?;
        self.lines.iter().position(|studied| {
            // Without what the letters have been found to be: `vi + 2j` solves nothing.
            let mut members = studied.reading.iter().flat_map(|reading| &reading.members);
            members.any(|member| {
                let values = value(&member.expr, self.prepared, &self.prepared.names);
                values.is_some_and(|values| solution.iter().any(|own| are_along(&values, own, self.prepared)))
            })
        })
    }
}
