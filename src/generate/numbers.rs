//! One set of numbers of a style, examined: does everything hold that is required of it?

use std::cell::OnceCell;
use std::sync::Arc;

use super::sieve::Sieve;
use super::variant::{Unfit, Variant, answer_rounds_safely, variant};
use crate::bank::{Givens, Posed, Question, Requirement, Style, Unposed};
use crate::expr::Expr;
use crate::mechanics::Because;

/// A set of numbers. What follows from it is worked out when it is first asked for, and once for all styles that have the
/// same sets.
pub struct Numbers<'s> {
    /// Its index in the style.
    pub index: u64,
    sieve: &'s Sieve<'s>,
    values: OnceCell<Vec<Expr>>,
    givens: OnceCell<Result<Arc<Givens>, String>>,
    posed: OnceCell<Result<Posed, Unfit>>,
}

/// Is a set that was turned away asked whether anything else would have turned it away too?
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Further {
    /// The first reason is enough.
    Never,
    /// If it has been solved already.
    OnceSolved,
    /// Even if it must be solved for that.
    Always,
}

/// What has turned a set away so far.
struct Turned {
    first: Option<Unfit>,
    goes_on: bool,
}

impl Turned {
    /// A reason more. The second one settles it, and the first one too if nobody wants to know of a second.
    fn away(&mut self, reason: Unfit) -> Result<(), (Unfit, bool)> {
        match self.first.take() {
            Some(first) => Err((first, false)),
            None if self.goes_on => {
                self.first = Some(reason);
                Ok(())
            }
            None => Err((reason, false)),
        }
    }
}

/// A set of parameters with an index below the style's size, examined.
///
/// # Errors
///
/// The first thing that makes it unfit.
pub fn examine(question: &Question, style: &Style, index: u64) -> Result<Variant, Unfit> {
    let sieve = Sieve::for_one(question, style);
    Numbers::new(&sieve, index).examine(&sieve, Further::Never).map_err(|(reason, _)| reason)
}

impl<'s> Numbers<'s> {
    /// The set with an index below the size of the sieve's style.
    pub fn new(sieve: &'s Sieve<'s>, index: u64) -> Numbers<'s> {
        let (values, givens, posed) = (OnceCell::new(), OnceCell::new(), OnceCell::new());
        Numbers { index, sieve, values, givens, posed }
    }

    /// The variant of a style that has the same sets as the one of [`Numbers::new`]; of an unfit set whether it would be
    /// fit if only that one thing were not required of it.
    ///
    /// # Errors
    ///
    /// The first thing that makes it unfit, and whether it is known to be the only one.
    pub fn examine(&self, sieve: &Sieve, further: Further) -> Result<Variant, (Unfit, bool)> {
        let mut turned = Turned { first: None, goes_on: further == Further::Always };
        if !sieve.has_values(self) {
            return Err((Unfit::NoValue, false));
        }
        for reason in sieve.givens_refused(self) {
            turned.away(reason)?;
        }
        // What cannot be posed is unfit whatever is required of it.
        let first = turned.first.clone();
        let refused = |reason: &Unfit| self.turned_away_though_open(sieve, reason).unwrap_or_else(|| reason.clone());
        let posed = self.posed().as_ref().map_err(|reason| (first.unwrap_or_else(|| refused(reason)), false))?;
        turned.goes_on = further != Further::Never;
        for (place, requirement) in sieve.on_results() {
            if !requirement.holds(&|name| posed.meaning(name)).unwrap_or(false) {
                turned.away(Unfit::Results(place))?;
            }
        }
        let (question, style) = (sieve.question, sieve.style);
        for (place, answer) in question.parts.iter().flat_map(|part| &part.answers).enumerate() {
            if !answer_rounds_safely(answer, style.name, &posed.solution) {
                turned.away(Unfit::Tie(place))?;
            }
        }
        match turned.first {
            Some(only) => Err((only, true)),
            None => {
                let names = style.parameters.iter().map(|(name, _)| name.clone());
                let parameters = names.zip(self.values().iter().cloned()).collect();
                Ok(variant(question, style, Some(self.index), parameters, posed.clone()))
            }
        }
    }

    /// The values of the parameters.
    fn values(&self) -> &[Expr] {
        self.values.get_or_init(|| self.sieve.style.values_at(self.index))
    }

    /// What its names stand for, or the first that has no value.
    pub(super) fn givens(&self) -> Result<&Arc<Givens>, &str> {
        let (style, names, values) = (self.sieve.style, &self.sieve.names, self.values());
        let known = |place: usize| self.sieve.meaning(self.index, place, &values[place]);
        let givens = || Givens::with_meanings(style, Arc::clone(names), values.iter(), &known);
        let givens = || givens().map(Arc::new).map_err(|(name, _)| name);
        self.givens.get_or_init(givens).as_ref().map_err(String::as_str)
    }

    /// The first requirement that what is determined does not meet, where something else is left open: one on its speed
    /// turns away a sphere that is at rest and so has no direction.
    fn turned_away_though_open(&self, sieve: &Sieve, reason: &Unfit) -> Option<Unfit> {
        if *reason != Unfit::Underdetermined {
            return None;
        }
        let givens = self.givens().ok()?.clone();
        let posed = Posed::as_far_as_determined(sieve.question, &sieve.wanted, givens).ok()??;
        let is_unmet = |requirement: &Requirement| requirement.holds(&|name| posed.meaning(name)) == Ok(false);
        sieve.on_results().find(|(_, requirement)| is_unmet(requirement)).map(|(place, _)| Unfit::Results(place))
    }

    fn posed(&self) -> &Result<Posed, Unfit> {
        self.posed.get_or_init(|| {
            let givens = self.givens().map_err(|_| Unfit::NoValue)?.clone();
            let posed = Posed::for_wanted(self.sieve.question, &self.sieve.wanted, givens);
            posed.map_err(|reason| Unfit::from(&reason))
        })
    }
}

impl From<&Unposed> for Unfit {
    fn from(reason: &Unposed) -> Unfit {
        match reason {
            Unposed::Given(..) | Unposed::Scene(_) => Unfit::NoValue,
            Unposed::Refused(refusal) => match refusal.because {
                Because::Impossible => Unfit::Impossible,
                Because::Underdetermined => Unfit::Underdetermined,
                Because::BeyondMethods => Unfit::BeyondMethods,
            },
        }
    }
}
