//! What the lines of working say of the mistakes that may be behind an answer: a law that stands there rightly was not
//! mistaken.

use super::decide::is_own;
use crate::bank::{Code, EarnedFor};
use crate::mark::award::{Award, Cause, Place};
use crate::mark::key::{KeyedPart, KeyedQuestion};
use crate::mark::slips::{self, ARITHMETIC};
use crate::mark::working::Examined;
use crate::mechanics::{Law, Quantity, Seen};

/// Mistakes that a line shows plainly, so that another mistake in the same law is none.
const PLAIN: [&str; 7] =
    ["masses-swapped", "masses-omitted", "e-taken-as-1", "e-wrong-side", "coalesce", "not-resolved", "sincos-swap"];

/// The laws and values that lines of a part, or of parts before it, have right.
#[derive(Clone, Debug, Default)]
pub(super) struct ByLines {
    laws: Vec<Law>,
    /// The equations that they have right as far as the method goes.
    methods: Vec<Law>,
    /// The others that lines of this part use.
    last: Vec<Law>,
    /// Is e seen in them?
    has_e: bool,
    values: Vec<Quantity>,
    /// What is plainly wrong with a law.
    wrong: Vec<(Law, &'static str)>,
    /// The equations that a line has wrongly, by what is seen of it: no value comes from the right ones.
    departed: Vec<Law>,
    /// The marks of this part that lines earn, and the last of those lines.
    earned: Vec<bool>,
    last_line: Option<usize>,
    /// Does every equation of this part stand there rightly?
    has_all_equations: bool,
}

impl ByLines {
    /// Have no lines said anything, of this part or of those before?
    pub(super) fn says_nothing(&self) -> bool {
        let laws = [&self.laws, &self.methods, &self.last, &self.departed];
        laws.into_iter().all(Vec::is_empty)
            && self.values.is_empty()
            && self.wrong.is_empty()
            && !(self.has_e || self.earned.contains(&true))
    }

    /// With what the lines of the next part show. What is known of the laws holds for one impact only.
    pub(super) fn go_on(self, question: &KeyedQuestion, part: &KeyedPart, examined: &Examined) -> ByLines {
        let awards = &examined.awards;
        let mut all = match question.scene.then.is_empty() {
            true => ByLines { earned: Vec::new(), last: Vec::new(), last_line: None, has_all_equations: false, ..self },
            false => ByLines::default(),
        };
        all.has_e |= examined.has_e();
        all.values.extend(examined.theirs.right_velocities(question));
        let mut equations = Vec::new();
        for (mark, award) in part.scheme.iter().zip(awards) {
            let line = award.as_ref().and_then(|award| match award.evidence.as_ref()?.place {
                Place::Line(number) => Some((award, number)),
                Place::Answer(_) => None,
            });
            let given = line.filter(|(award, _)| award.given && award.note.is_none());
            all.earned.push(line.is_some_and(|(award, _)| award.given));
            // Who has another component has not slipped in the arithmetic.
            if mark.code == Code::B1 && line.is_some_and(|(award, _)| !award.given) {
                equations.push(false);
            }
            if !mark.code.is_accuracy() {
                // Of a later impact the scheme may have the methods alone.
                if let EarnedFor::Law(law, _) = mark.earned_for
                    && is_equation(law)
                    && mark.code.is_method()
                {
                    let right = given.filter(|(award, _)| award.feedback.is_empty());
                    equations.push(line.is_some_and(|(award, _)| award.given));
                    all.last_line = all.last_line.max(right.map(|(_, number)| number));
                }
                if let (EarnedFor::Law(law, _), Some((Award { given: true, .. }, _))) = (&mark.earned_for, line) {
                    let of = match (mark.code, is_equation(*law)) {
                        // What has its own mark stands there rightly, and the answer is found by others.
                        (Code::B1, _) => &mut all.laws,
                        (_, true) => &mut all.methods,
                        (_, false) => &mut all.last,
                    };
                    of.push(*law);
                }
                // A slip of a law is what a line shows plainly where its method is not given.
                if let (EarnedFor::Law(law, _), Some((Award { given: false, note: Some(note), .. }, _))) =
                    (&mark.earned_for, line)
                    && law.slips().iter().any(|slip| slip.tag == *note)
                    && !is_equation(*law)
                {
                    all.wrong.push((*law, *note));
                }
                continue;
            }
            all.last_line = all.last_line.max(given.map(|(_, number)| number));
            match &mark.earned_for {
                EarnedFor::Law(law, _) if is_equation(*law) => {
                    equations.push(given.is_some());
                    all.laws.extend(given.map(|_| *law));
                    let note = line.filter(|(award, _)| !award.given).and_then(|(award, _)| award.note);
                    all.wrong.extend(note.filter(|note| PLAIN.contains(note)).map(|note| (*law, note)));
                    all.departed.extend(note.filter(|note| *note == "sign-error").map(|_| *law));
                }
                // A speed may be right though its law was not used rightly: the root of one square is its base.
                value => {
                    let is_velocity = |quantity: &&Quantity| matches!(quantity, Quantity::Velocity(..));
                    let velocities = value.quantities().iter().filter(is_velocity);
                    all.values.extend(velocities.filter(|_| given.is_some()));
                }
            }
        }
        all.has_all_equations = !equations.is_empty() && equations.iter().all(|given| *given);
        all
    }

    /// May this be the mistake? Not if it spoils what a line has right, nor if a line has another in the same law.
    pub(super) fn allows(&self, cause: &slips::Cause) -> bool {
        let is_of_law = !cause.laws.is_empty();
        let is_of_e = |tag: &&str| ["coalesce", "e-taken-as-1"].contains(tag);
        let forgets_e = || self.has_e && cause.tags.iter().any(is_of_e);
        let spoils = || {
            self.laws.iter().any(|law| !cause.earns_accuracy(*law))
                || self.methods.iter().any(|law| !cause.earns_method(*law))
                || self.values.iter().any(|quantity| !cause.keeps(*quantity))
        };
        let is_another = || {
            let differs = |(law, note): &(Law, &str)| cause.laws.contains(law) && !has(cause, note);
            self.wrong.iter().any(differs)
        };
        let presupposes = self.departed.iter().any(|law| cause.earns_accuracy(*law));
        !(presupposes || is_of_law && (spoils() || is_another() || forgets_e()))
    }

    /// Is it a mistake that a line shows plainly?
    pub(super) fn shows(&self, cause: &slips::Cause) -> bool {
        self.wrong.iter().any(|(_, note)| has(cause, note))
    }

    /// Is the mistake in the law by which lines of this part go on to their answer? Then it explains the answer, and what
    /// may have been wrong before it does not.
    pub(super) fn is_of_last_step(&self, cause: &slips::Cause) -> bool {
        !cause.laws.is_empty() && cause.laws.iter().all(|law| self.last.contains(law))
    }

    /// Where every equation is right and the method for the answer is seen, what is left is a slip in the arithmetic.
    pub(super) fn arithmetic(&self, part: &KeyedPart, blank: usize, follows: bool) -> Option<Cause> {
        let own = part.scheme.iter().find(|mark| is_own(mark, &part.blanks[blank]))?;
        let has_method = follows || !own.depends.is_empty() && own.depends.iter().all(|mark| self.earned[*mark]);
        let last = self.last_line.filter(|_| has_method && self.has_all_equations)?;
        let sentence = format!("What you need is there: look for an error in the arithmetic after line {last}.");
        Some(Cause { tag: ARITHMETIC.to_owned(), sentence, probable: Vec::new() })
    }
}

/// Is the mistake, or one of two, what a line was noted for? `not-resolved` is said of either equation.
fn has(cause: &slips::Cause, note: &str) -> bool {
    cause.tags.iter().any(|tag| tag.ends_with(note))
}

/// Is it momentum or restitution as an equation?
fn is_equation(law: Law) -> bool {
    matches!(law.seen(), Seen::Equation | Seen::VectorEquation)
}
