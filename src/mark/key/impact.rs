//! A question as the student comes to it: a later impact by itself, with A and B for who meets in it, so that its working is
//! looked through as that of any impact is; and a later part with the wrong values of earlier ones.

use std::borrow::Cow;
use std::cmp::Ordering;

use super::{KeyedMark, KeyedPart, KeyedQuestion};
use crate::bank::{EarnedFor, Find};
use crate::expr::{Expr, Meaning, Turn, evaluate};
use crate::mark::working::{Misread, Theirs};
use crate::mechanics::{
    Axis, Datum, Derivation, Given, Known, Meeting, Moment, Quantity, Scene, Setting, Sphere, Then, Velocity, pose,
    with_letter_of_restitution,
};
use crate::number::{Angle, Range, Value};

impl KeyedQuestion {
    /// Who meets in a later impact.
    pub(crate) fn meeting(&self, number: u8) -> Option<Meeting> {
        self.scene.then.iter().map(|then| then.meeting).find(|meeting| meeting.number == number)
    }

    /// A later impact as the student comes to it, with the velocities that the student has found for what came before; and
    /// the question's parts as far as they are about it, in the words of the laws.
    pub(in crate::mark) fn impact(&self, meeting: Meeting, own: &Theirs) -> Option<Cow<'_, KeyedQuestion>> {
        let wrong: Vec<(Quantity, &Expr)> =
            own.wrong(self).filter(|(quantity, _)| quantity.impact() < meeting.number).collect();
        if !wrong.is_empty() {
            return self.begun_with(meeting, &wrong).map(Cow::Owned);
        }
        // Most students come to it with what is right.
        let right = self.later.get_or_init(|| {
            let right = |then: &Then| self.begun_with(then.meeting, &[]);
            self.scene.then.iter().map(right).collect()
        });
        let place = self.scene.then.iter().position(|then| then.meeting == meeting)?;
        right[place].as_ref().map(Cow::Borrowed)
    }

    /// The same where the student goes on with values as they were rounded, if some were: `7.2` for 7.17.
    pub(in crate::mark) fn impact_as_rounded(&self, meeting: Meeting, own: &Theirs) -> Option<KeyedQuestion> {
        let is_earlier = |(quantity, _): &(Quantity, &Expr)| quantity.impact() < meeting.number;
        let rounded: Vec<(Quantity, &Expr)> = own.rounded(self).filter(is_earlier).collect();
        let wrong = own.wrong(self).filter(is_earlier);
        (!rounded.is_empty())
            .then(|| self.begun_with(meeting, &rounded.iter().copied().chain(wrong).collect::<Vec<_>>()))?
    }

    fn begun_with(&self, meeting: Meeting, own: &[(Quantity, &Expr)]) -> Option<KeyedQuestion> {
        let then = self.scene.then.iter().find(|then| then.meeting == meeting)?;
        let known = self.given_with(own.iter().copied());
        let in_a_line = known.0.contains_key(&Quantity::InALine);
        let axes: &[Axis] = if in_a_line { &[Axis::N] } else { &[Axis::X, Axis::Y] };
        let begins = |part| axes.iter().map(move |axis| Quantity::Velocity(part, Moment::Before, *axis));
        let begins: Vec<Quantity> = Sphere::BOTH.into_iter().flat_map(begins).collect();
        let wanted: Vec<Quantity> = begins.iter().map(|quantity| meeting.quantity(*quantity)).collect();
        let mut derived = known.clone();
        let earlier = self.earlier_velocities(meeting, axes);
        Derivation::carry_out(&mut derived, &[wanted.clone(), earlier.clone()].concat());
        let numbers =
            |of: &[Quantity]| of.iter().filter_map(|quantity| derived.number(*quantity)).collect::<Vec<Value>>();
        let elsewhere = self.elsewhere.at(numbers(&wanted), numbers(&earlier));
        let mut given = meeting.known(&known);
        for (quantity, later) in begins.into_iter().zip(&wanted) {
            if let Some(datum) = derived.0.get(later) {
                given.0.insert_new(quantity, datum.clone());
            }
        }
        let parts = self.parts.iter().map(|part| part.of_impact(meeting)).collect();
        Some(KeyedQuestion { elsewhere, ..self.of_scene(then.scene.clone(), given, parts) })
    }

    /// The velocities of the impacts before this one, before them and after them.
    fn earlier_velocities(&self, meeting: Meeting, axes: &[Axis]) -> Vec<Quantity> {
        let later = self.scene.then.iter().map(|then| then.meeting).filter(|other| other.number < meeting.number);
        let mut all = Vec::new();
        for impact in std::iter::once(Meeting::FIRST).chain(later) {
            for (part, moment) in
                Sphere::BOTH.into_iter().flat_map(|part| [Moment::Before, Moment::After].map(|at| (part, at)))
            {
                all.extend(axes.iter().map(|axis| impact.quantity(Quantity::Velocity(part, moment, *axis))));
            }
        }
        all
    }

    /// A sentence about a law, in the words of its first impact and with the letter that is the coefficient of restitution there.
    pub(in crate::mark) fn said_of_impact(&self, sentence: &str) -> String {
        let said = self.scene.setting.say(sentence);
        with_letter_of_restitution(&said, self.scene.letter_of_restitution()).into_owned()
    }

    /// The question as it is for who has these wrong values from earlier parts, as if they had been given: of one impact in
    /// a straight line, where every velocity is a number of its own.
    pub(in crate::mark) fn with_own(&self, own: &Theirs) -> Option<KeyedQuestion> {
        if self.scene.setting != Setting::Direct || !self.scene.then.is_empty() {
            return None;
        }
        let is_cause =
            |quantity: &Quantity| matches!(quantity, Quantity::Velocity(_, Moment::After, Axis::N) | Quantity::Mass(_));
        let mut wrong = own.wrong(self).filter(|(quantity, _)| is_cause(quantity)).peekable();
        wrong.peek()?;
        let given = self.given_with(wrong);
        Some(self.of_scene(self.scene.clone(), given, self.parts_unstated()))
    }

    /// The question as it is for who has copied a number of its velocities wrongly.
    pub(in crate::mark) fn as_read(&self, misread: &Misread) -> Option<KeyedQuestion> {
        let mut scene = self.scene.clone();
        for velocity in scene.before.iter_mut().flatten() {
            let given = match velocity {
                Velocity::Components(x, y) => vec![x, y],
                Velocity::Polar { speed, .. } => vec![speed],
            };
            for given in given {
                given.shown = misread.read(&given.shown);
                given.value = self.exact(&given.shown)?;
            }
        }
        let given = pose(&scene).ok().filter(|given| *given != self.given)?;
        Some(self.of_scene(scene, given, self.parts_unstated()))
    }

    /// The question as it is for who has set these letters of it equal to one: `let u = 1, m = 1`.
    pub(in crate::mark) fn scaled(&self, letters: &[String]) -> Option<KeyedQuestion> {
        let mut scene = self.scene.clone();
        let one = |name: &str| letters.iter().any(|letter| letter == name).then(|| Expr::integer(1));
        let mut given: Vec<&mut Given> = scene.masses.iter_mut().flatten().collect();
        for velocity in scene.before.iter_mut().chain(&mut scene.after).flatten() {
            match velocity {
                Velocity::Components(x, y) => given.extend([x, y]),
                Velocity::Polar { speed, .. } => given.push(speed),
            }
        }
        for given in given.into_iter().filter(|given| given.shown.names().iter().any(|name| one(&name.text).is_some()))
        {
            let shown = given.shown.substitute(&one);
            *given = Given { value: self.exact(&shown)?, shown };
        }
        let given = pose(&scene).ok().filter(|given| *given != self.given)?;
        let mut parts = self.parts_unstated();
        parts.iter_mut().for_each(|part| part.known = given.clone());
        Some(self.of_scene(scene, given, parts))
    }

    /// The parts, with nothing of what was worked out for the right values.
    pub(super) fn parts_unstated(&self) -> Vec<KeyedPart> {
        let of_mark = |mark: &KeyedMark| KeyedMark { stated: Default::default(), ..mark.clone() };
        let of_part =
            |part: &KeyedPart| KeyedPart { scheme: part.scheme.iter().map(of_mark).collect(), ..part.clone() };
        self.parts.iter().map(of_part).collect()
    }

    /// What is given, and these values of the student's own as if they were given too.
    pub(in crate::mark) fn given_with<'e>(&self, own: impl Iterator<Item = (Quantity, &'e Expr)>) -> Known<Value> {
        let mut known = self.given.clone();
        known.0.extend(own.filter_map(|(quantity, written)| Some((quantity, Datum::Number(self.exact(written)?)))));
        known
    }

    /// The same question about a scene with what is given there: nothing is prepared yet.
    pub(super) fn of_scene(&self, scene: Scene, given: Known<Value>, parts: Vec<KeyedPart>) -> KeyedQuestion {
        KeyedQuestion {
            id: self.id.clone(),
            number: self.number,
            mirrors: self.mirrors.clone(),
            scene,
            given,
            letters: self.letters.clone(),
            given_letters: self.given_letters.clone(),
            parts,
            decimals: self.decimals.clone(),
            angles: self.angles.clone(),
            elsewhere: self.elsewhere.clone(),
            prepared: Default::default(),
            mistakes: Default::default(),
            mistakes_where_found: Default::default(),
            solution: Default::default(),
            needed: Default::default(),
            later: Default::default(),
        }
    }

    /// Where impacts follow or all is in a line, of a speed after an impact of a sphere that moves along the line of centres:
    /// the component there, from which the student goes on, and whether it is negative.
    pub(in crate::mark) fn along_its_line(&self, quantity: Quantity) -> Option<(Quantity, bool)> {
        let is_speed_after = matches!(quantity.of_its_impact(), Quantity::Speed(_, Moment::After));
        let in_a_line = self.scene.setting == Setting::Direct || self.given.0.contains_key(&Quantity::InALine);
        if (self.scene.then.is_empty() && !in_a_line) || !is_speed_after {
            return None;
        }
        let along = quantity.along_the_line()?;
        let right = |quantity: Quantity| self.parts.iter().find_map(|part| part.known.number(quantity));
        let nothing_across = || in_a_line || right(along.along(Axis::T)).is_some_and(|t| t.is_zero());
        match right(along)?.sign()? {
            Ordering::Equal => None,
            sign => nothing_across().then_some((along, sign == Ordering::Less)),
        }
    }

    /// A value as it was written, in the letters of the question.
    pub(in crate::mark) fn exact(&self, written: &Expr) -> Option<Value> {
        let letter = |name: &str| {
            let letter = self.letters.iter().find(|letter| letter.name() == name)?;
            match letter.range() {
                // An acute angle is known by its tangent.
                Range::Acute => Some(Meaning::Angle(Turn::of(Angle::of(&Value::letter(*letter), &Value::ONE)?))),
                _ => Some(Meaning::Number(Value::letter(*letter))),
            }
        };
        match evaluate(written, &letter).ok()? {
            Meaning::Number(value) => Some(value),
            _ => None,
        }
    }
}

impl KeyedPart {
    /// The impacts of which it has steps, each once, in their order.
    pub(in crate::mark) fn impacts(&self) -> Vec<u8> {
        let mut impacts: Vec<u8> = self.derivation.steps.iter().map(|step| step.impact()).collect();
        impacts.sort_unstable();
        impacts.dedup();
        impacts
    }

    /// The part as far as it is about a later impact, in the words of the laws.
    fn of_impact(&self, meeting: Meeting) -> KeyedPart {
        let in_law = |quantity: &Quantity| meeting.in_law(*quantity).unwrap_or(*quantity);
        let mut part = self.clone();
        for blank in &mut part.blanks {
            blank.find = match &blank.find {
                Find::Quantity(quantity) => Find::Quantity(in_law(quantity)),
                Find::Vector(x, y) => Find::Vector(in_law(x), in_law(y)),
                other => other.clone(),
            };
        }
        let mark = |mark: &KeyedMark| KeyedMark {
            earned_for: match &mark.earned_for {
                EarnedFor::Quantity(quantity) => EarnedFor::Quantity(in_law(quantity)),
                EarnedFor::Both(both) => EarnedFor::Both(both.each_ref().map(in_law)),
                other => other.clone(),
            },
            // What is stated of a quantity was worked out under its other name.
            stated: Default::default(),
            ..mark.clone()
        };
        part.scheme = self.scheme.iter().map(mark).collect();
        let here = self.derivation.steps.iter().filter_map(|step| step.later);
        let rules = here.filter(|(other, _)| *other == meeting).map(|(_, rule)| rule);
        part.derivation = Derivation { steps: rules.collect() };
        part.known = meeting.known(&self.known);
        part
    }
}
