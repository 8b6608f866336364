//! Working of several impacts that follow one another: each is looked through by itself, in its own letters.

use super::equations::{Convention, Departure, Matched, differences, is_value, sphere};
use super::examine::{Examined, Studied, examine_one};
use super::numbers::sizes;
use super::prepared::Prepared;
use super::theirs::{Theirs, is_nearly_right};
use crate::bank::{Code, EarnedFor};
use crate::expr::Expr;
use crate::mark::award::{Award, Evidence, Ground, MarkedLine, Place};
use crate::mark::key::{KeyedMark, KeyedPart, KeyedQuestion};
use crate::mechanics::{Law, Meeting, Moment, Quantity, Sphere};

/// Looks through the working of a part; `before` is what the student found in earlier parts.
pub(crate) fn examine(question: &KeyedQuestion, part: &KeyedPart, working: &[String], before: &Theirs) -> Examined {
    if working.is_empty() {
        let awards = part.scheme.iter().map(|_| None).collect();
        return Examined::with(awards, Vec::new(), before);
    }
    if question.scene.then.is_empty() {
        let mut all = examine_one(question, part, working, before, &[]);
        all.follow_laws(question, part, working, before);
        all.follow_misread(question, part, working, before);
        all.follow_scale(question, part, working, before);
        return all;
    }
    let mut impacts = part.impacts();
    // A range is not derived in steps: every impact may have to do with it.
    if impacts.is_empty() {
        impacts.push(0);
        impacts.extend(question.scene.then.iter().map(|then| then.meeting.number));
    }
    let about = about(question, part, &impacts);
    let mut all = match impacts.first() {
        None | Some(0) if !is_done_before(question, part) => examine_one(question, part, working, before, &[]),
        _ => Examined::nothing(part, working, before),
    };
    all.keep_of(0, &about);
    let later: Vec<Meeting> = impacts.into_iter().filter_map(|number| question.meeting(number)).collect();
    if !later.is_empty() {
        all.leave_to_later(question);
    }
    // What is false of one impact may be a line of another, if there is another.
    let is_only = later.len() == 1 && all.has_e.is_none();
    for meeting in later {
        if let Some(mut later) = examine_later(question, part, working, &all, meeting) {
            later.keep_of(meeting.number, &about);
            all.lose_condition_on_other(question, part, meeting, &later);
            let denied = (later.denied.clone(), later.denies_velocities);
            let end = later.end.take();
            all.join(later);
            if is_only {
                (all.denied, all.denies_velocities) = denied;
                all.end = end;
            }
        }
    }
    all
}

/// A part looked through as working of a later impact, in which the student goes on from what was found before.
fn examine_later(
    question: &KeyedQuestion,
    part: &KeyedPart,
    working: &[String],
    before: &Examined,
    meeting: Meeting,
) -> Option<Examined> {
    let examined = |impact: &KeyedQuestion| examine_as_begun(impact, part, working, before, meeting);
    let right = examined(&*question.impact(meeting, &before.theirs)?)?;
    // Who goes on with what was rounded has used the same laws.
    let rounded = question.impact_as_rounded(meeting, &before.theirs).and_then(|impact| examined(&impact));
    let earned = |examined: &Examined| examined.awards.iter().flatten().filter(|award| award.given).count();
    Some(rounded.filter(|rounded| earned(rounded) > earned(&right)).unwrap_or(right))
}

/// The same, where the later impact begins with these velocities.
fn examine_as_begun(
    impact: &KeyedQuestion,
    part: &KeyedPart,
    working: &[String],
    before: &Examined,
    meeting: Meeting,
) -> Option<Examined> {
    let (before, of_others) = (&before.theirs, before.short_of_law.as_slice());
    // `V_B'` after `V_B`: the stroke says that it is of a later impact, and here all is.
    let plain = |line: &String| meeting.in_law_names(&line.replace(['\'', '’', '′'], ""));
    let typed: Vec<String> = working.iter().map(plain).collect();
    let here = before.values.iter().filter_map(|(quantity, own)| Some((meeting.in_law(*quantity)?, own.clone())));
    let part = impact.parts.iter().find(|other| other.label == part.label)?;
    let (slips, meant) = (before.slips.clone(), before.meant.clone());
    let earlier = before.values.iter().map(|(quantity, (_, written))| (*quantity, written.clone())).collect();
    let here = Theirs { values: here.collect(), slips, letters: None, earlier, meant };
    let examined = examine_one(impact, part, &typed, &here, of_others);
    let own = examined.theirs.values.into_iter().map(|(quantity, own)| (meeting.quantity(quantity), own));
    let values = before.values.clone().into_iter().chain(own).collect();
    let (slips, meant) = (examined.theirs.slips, examined.theirs.meant);
    let theirs = Theirs { values, slips, letters: before.letters.clone(), meant, ..Theirs::default() };
    let lines = examined.lines.into_iter().zip(working).map(|(line, typed)| MarkedLine {
        typed: typed.clone(),
        role: meeting.in_words(&line.role),
        ..line
    });
    let of_meeting = |found: Vec<Quantity>| found.into_iter().map(|found| meeting.quantity(found)).collect();
    let [found_once, found_otherwise] = [examined.found_once, examined.found_otherwise].map(of_meeting);
    let (lines, followed, solution) = (lines.collect(), None, None);
    Some(Examined { lines, theirs, followed, solution, found_once, found_otherwise, ..examined })
}

/// Is the first impact the business of an earlier part alone, so that letters here are of what comes later?
fn is_done_before(question: &KeyedQuestion, part: &KeyedPart) -> bool {
    let has_momentum = |part: &KeyedPart| {
        let is_momentum = |mark: &KeyedMark| matches!(mark.earned_for, EarnedFor::Law(law, _) if law.gives(Quantity::MomentumEquation));
        part.scheme.iter().any(is_momentum)
    };
    let mut earlier = question.parts.iter().take_while(|other| other.label != part.label);
    !has_momentum(part) && earlier.any(has_momentum)
}

/// The impact that each mark for a law is about, where every impact that uses the law has a method mark for it.
fn about(question: &KeyedQuestion, part: &KeyedPart, impacts: &[u8]) -> Vec<Option<u8>> {
    let steps = &part.derivation.steps;
    let is_of_two = |number: u8| {
        let then = question.scene.then.iter().find(|then| then.meeting.number == number);
        Quantity::Mass(Sphere::B).is_in(then.map_or(&question.scene, |then| &then.scene).setting)
    };
    let uses = |law: Law, number: u8| match steps.is_empty() {
        // A wall has no momentum that is known.
        true => !law.gives(Quantity::MomentumEquation) || is_of_two(number),
        false => steps.iter().any(|step| step.law == law && step.impact() == number),
    };
    let of_mark = |place: usize| {
        let mark = &part.scheme[place];
        let EarnedFor::Law(law, _) = mark.earned_for else { return None };
        let with_law: Vec<u8> = impacts.iter().copied().filter(|number| uses(law, *number)).collect();
        let alike = |other: &&KeyedMark| other.earned_for == mark.earned_for;
        let methods = part.scheme.iter().filter(alike).filter(|other| !other.code.is_accuracy()).count();
        let of_kind = |other: &&KeyedMark| other.code.is_accuracy() == mark.code.is_accuracy();
        let before = part.scheme[..place].iter().filter(alike).filter(of_kind).count();
        (methods == with_law.len()).then(|| with_law.get(before).copied()).flatten()
    };
    (0..part.scheme.len()).map(of_mark).collect()
}

impl Examined {
    /// Before anything has been looked at.
    fn nothing(part: &KeyedPart, working: &[String], before: &Theirs) -> Examined {
        let awards = part.scheme.iter().map(|_| None).collect();
        let line = |typed: &String| MarkedLine { typed: typed.clone(), reading: None, role: String::new() };
        let lines = working.iter().map(line).collect();
        Examined::with(awards, lines, before)
    }

    /// Nothing found but this.
    fn with(awards: Vec<Option<Award>>, lines: Vec<MarkedLine>, before: &Theirs) -> Examined {
        let (theirs, stated, short_of_law) = (before.clone(), Vec::new(), Vec::new());
        Examined {
            awards,
            lines,
            theirs,
            stated,
            followed: None,
            solution: None,
            has_e: None,
            to_be_subtracted: None,
            turns: Vec::new(),
            letters: None,
            finds_exactly: false,
            short_of_law,
            misread: None,
            denies_what_is_found: false,
            denied: Vec::new(),
            denies_velocities: [false; 2],
            end: None,
            found_once: Vec::new(),
            found_otherwise: Vec::new(),
        }
    }

    /// With the methods that are seen where laws are used with wrong values of earlier parts, as if these had been given.
    fn follow_laws(&mut self, question: &KeyedQuestion, part: &KeyedPart, working: &[String], before: &Theirs) {
        let is_open = |mark: &KeyedMark, award: &Option<Award>| {
            is_method_of_law(mark) && !award.as_ref().is_some_and(|it| it.given)
        };
        if !part.scheme.iter().zip(&self.awards).any(|(mark, award)| is_open(mark, award)) {
            return;
        }
        let Some(own) = question.with_own(before) else { return };
        let feedback = "followed through from your own values";
        self.follow(&own, part, working, before, &is_open, (Ground::FollowThrough.tag(), feedback));
    }

    /// With the methods that are seen where the question is taken as the student has read it, with one number of it copied
    /// wrongly, and what is accurate by follow-through.
    fn follow_misread(&mut self, question: &KeyedQuestion, part: &KeyedPart, working: &[String], before: &Theirs) {
        let Some(misread) = &self.misread else { return };
        let follows = |mark: &KeyedMark| {
            let is_of_law = matches!(mark.earned_for, EarnedFor::Law(..));
            is_of_law && (mark.code.is_method() || mark.code == Code::A1FollowThrough)
        };
        let is_open =
            |mark: &KeyedMark, award: &Option<Award>| follows(mark) && !award.as_ref().is_some_and(|award| award.given);
        if !part.scheme.iter().zip(&self.awards).any(|(mark, award)| is_open(mark, award)) {
            return;
        }
        let Some(own) = question.as_read(misread) else { return };
        let departure = Departure::NumberMisread;
        self.follow(&own, part, working, before, &is_open, (departure.tag(), departure.sentence()));
    }

    /// With the marks that are open and that the working earns as one of another question.
    fn follow(
        &mut self,
        own: &KeyedQuestion,
        part: &KeyedPart,
        working: &[String],
        before: &Theirs,
        is_open: &dyn Fn(&KeyedMark, &Option<Award>) -> bool,
        (note, feedback): (&'static str, &str),
    ) {
        let Some(part) = own.parts.iter().find(|other| other.label == part.label) else { return };
        let followed = examine_one(own, part, working, before, &[]);
        for ((mark, award), other) in part.scheme.iter().zip(&mut self.awards).zip(followed.awards) {
            if is_open(mark, award)
                && let Some(other) = other.filter(|other| other.given)
            {
                *award = Some(Award { note: Some(note), feedback: feedback.to_owned(), ..other });
            }
        }
        for (line, other) in self.lines.iter_mut().zip(followed.lines) {
            if line.role.is_empty() {
                *line = other;
            }
        }
    }

    /// Without what was found of marks that are about another impact.
    fn keep_of(&mut self, number: u8, about: &[Option<u8>]) {
        for (award, _) in self.awards.iter_mut().zip(about).filter(|(_, own)| own.is_some_and(|own| own != number)) {
            *award = None;
        }
    }

    /// Without wrong velocities after the first impact that are right ones after a later one: their letters are of that.
    fn leave_to_later(&mut self, question: &KeyedQuestion) {
        let is_after = |quantity: Quantity| matches!(quantity.of_its_impact(), Quantity::Velocity(_, Moment::After, _));
        let known = &question.prepared().known;
        let all = known.first().into_iter().flat_map(|known| known.0.keys().copied());
        let later: Vec<Vec<f64>> = all
            .filter(|quantity| quantity.impact() > 0 && is_after(*quantity))
            .filter_map(|of| sizes(known, of))
            .collect();
        let wrong: Vec<Quantity> = self.theirs.wrong(question).map(|(quantity, _)| quantity).collect();
        self.theirs.values.retain(|quantity, (own, _)| {
            let is_it = |right: &Vec<f64>| own.iter().zip(right).all(|(own, right)| is_nearly_right(*own, *right));
            !(quantity.impact() == 0 && is_after(*quantity) && wrong.contains(quantity) && later.iter().any(is_it))
        });
    }

    /// Without the condition on a velocity after a later impact where its line has the letter of the other sphere there, as
    /// the equations of that impact show, and not that of its own.
    fn lose_condition_on_other(
        &mut self,
        question: &KeyedQuestion,
        part: &KeyedPart,
        meeting: Meeting,
        later: &Examined,
    ) {
        let sides = question.scene.conditions.iter().flat_map(|condition| [&condition.left, &condition.right]);
        let quantities = sides.filter_map(|side| match side {
            Expr::Name(name) => name.text.parse::<Quantity>().ok(),
            _ => None,
        });
        let mut spheres = quantities.filter_map(|quantity| meeting.in_law(quantity)?.sphere());
        // `v_B` names its sphere by itself, and there goes by another name.
        let letters = later.letters.as_ref().filter(|letters| letters.iter().all(|own| sphere(own).is_none()));
        let (Some(of), Some(letters)) = (spheres.next(), letters) else { return };
        let is_of_other = |line: usize| {
            let typed = self.lines.get(line.wrapping_sub(1)).map_or("", |line| &line.typed);
            let has = |sphere: Sphere| {
                let mut words = typed.split(|sign: char| !sign.is_alphanumeric() && sign != '_');
                Sphere::BOTH.iter().zip(letters).any(|(own, letter)| *own == sphere && words.any(|word| word == letter))
            };
            has(of.other()) && !has(of)
        };
        let is_condition = |mark: &KeyedMark| matches!(mark.earned_for, EarnedFor::Condition);
        for (_, award) in part.scheme.iter().zip(&mut self.awards).filter(|(mark, _)| is_condition(mark)) {
            *award = award.take().filter(|award| match award.evidence {
                Some(Evidence { place: Place::Line(line), .. }) => !is_of_other(line),
                _ => true,
            });
        }
    }

    /// With what was found in the same lines as working of another impact: a mark that is earned there is earned.
    fn join(&mut self, later: Examined) {
        // A line of another impact says nothing against a mark of this one.
        let is_later = |award: &Award| match award.evidence {
            Some(Evidence { place: Place::Line(number), .. }) => {
                number.checked_sub(1).and_then(|line| later.short_of_law.get(line)).is_some_and(Option::is_some)
            }
            _ => false,
        };
        for award in &mut self.awards {
            *award = award.take().filter(|award| award.given || !is_later(award));
        }
        for (award, other) in self.awards.iter_mut().zip(later.awards) {
            let is_given = |award: &Option<Award>| award.as_ref().map(|award| award.given);
            if is_given(&other) > is_given(award) {
                *award = other;
            }
        }
        for (line, other) in self.lines.iter_mut().zip(later.lines) {
            if line.reading.is_none() || line.role.is_empty() {
                *line = other;
            }
        }
        self.stated.resize_with(later.stated.len(), || None);
        for (own, other) in self.stated.iter_mut().zip(later.stated) {
            *own = other.or(own.take());
        }
        self.theirs = later.theirs;
        self.misread = self.misread.take().or(later.misread);
        self.to_be_subtracted = later.to_be_subtracted.or(self.to_be_subtracted.take());
        self.turns.extend(later.turns);
        self.denies_what_is_found &= later.denies_what_is_found;
        self.found_once.extend(later.found_once);
        self.found_otherwise.extend(later.found_otherwise);
        self.denied.clear();
        (self.denies_velocities, self.end) = ([false; 2], None);
        // Each impact has an e of its own.
        self.has_e = [self.has_e, later.has_e].into_iter().flatten().reduce(|one, other| one && other);
        (self.followed, self.solution, self.letters) = (None, None, None);
        let both = self.short_of_law.len().max(later.short_of_law.len());
        self.short_of_law.resize(both, None);
        for (own, other) in self.short_of_law.iter_mut().zip(later.short_of_law) {
            *own = [*own, other].into_iter().flatten().min();
        }
    }
}

fn is_method_of_law(mark: &KeyedMark) -> bool {
    mark.code.is_method() && matches!(mark.earned_for, EarnedFor::Law(..))
}

/// What a line is short of one of the two equations, if it is one as far as a method goes.
pub(super) fn short_of_law(studied: &Studied) -> Option<u32> {
    studied.matched.iter().filter(|matched| matched.is_method()).map(Matched::weight).min()
}

/// The same of a line that is no law but a step from both, `10w = 52.5`: it is of this impact too.
pub(super) fn short_of_law_or_step(
    studied: &Studied,
    convention: Option<&Convention>,
    prepared: &Prepared,
) -> Option<u32> {
    let is_step = |equation: &(Expr, Expr)| {
        let after = convention.zip(prepared.laws.as_ref());
        !is_value(equation)
            && after.is_some_and(|(convention, laws)| {
                differences(equation, prepared).is_some_and(|line| laws.is_step(&line, convention))
            })
    };
    let mut equations = studied.reading.iter().flat_map(|reading| &reading.equations);
    let step = || (studied.matched.is_empty() && equations.any(is_step)).then_some(0);
    short_of_law(studied).or_else(step)
}

/// An equation of one impact is none of another, unless it comes nearer to that or is right for both. Are there any?
pub(super) fn set_aside_of_others(lines: &mut [Studied], of_others: &[Option<u32>]) -> bool {
    let mut any = false;
    for (studied, other) in lines.iter_mut().zip(of_others) {
        let Some(other) = *other else { continue };
        let is_own = short_of_law(studied).is_some_and(|own| own < other || own == 0);
        if !is_own {
            studied.line.readings.clear();
            (studied.reading, studied.matched) = (None, Vec::new());
            studied.role.clear();
            any = true;
        }
    }
    any
}
