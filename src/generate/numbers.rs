//! One set of numbers of a style, examined: does everything hold that is required of it?

use std::cell::{OnceCell, RefCell, RefMut};
use std::sync::Arc;

use super::sieve::Sieve;
use super::variant::{Unfit, Variant, answer_rounds_safely, variant};
use crate::bank::{Givens, Opened, Posed, Question, Requirement, Style, Unposed};
use crate::expr::Expr;
use crate::mechanics::{Because, Quantity};

/// A set of numbers. What follows from it is worked out when it is first asked for, and once for all styles that have the
/// same sets.
pub struct Numbers<'s> {
    /// Its index in the style.
    pub index: u64,
    sieve: &'s Sieve<'s>,
    values: OnceCell<Vec<Expr>>,
    givens: OnceCell<Result<Arc<Givens>, String>>,
    worked: RefCell<Worked>,
}

/// How far the collision has been worked out.
#[derive(Default)]
enum Worked {
    #[default]
    NotAtAll,
    /// As far as requirements have asked.
    InPart(Box<Opened>),
    Out(Posed),
    /// There is none, and why.
    Refused(Unfit),
}

impl Worked {
    /// Does a requirement hold that names these quantities? None where that is not known yet.
    fn meets(&mut self, requirement: &Requirement, quantities: &[Quantity]) -> Option<bool> {
        match self {
            Worked::InPart(opened) => opened.meets(requirement, quantities),
            Worked::Out(posed) => Some(posed.meets(requirement)),
            Worked::NotAtAll | Worked::Refused(_) => None,
        }
    }
}

/// Is a set that was turned away asked whether anything else would have turned it away too?
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Further {
    /// The first reason is enough.
    Never,
    /// If it was not turned away by its givens.
    OfResults,
    /// Even then, though its collision must be worked out for that.
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
        Numbers { index, sieve, values: OnceCell::new(), givens: OnceCell::new(), worked: RefCell::default() }
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
        turned.goes_on = further != Further::Never;
        // Most sets are turned away by what can be told without working all of it out.
        let mut untold = Vec::new();
        for (place, requirement, quantities) in sieve.on_results() {
            match self.begun().meets(requirement, quantities) {
                Some(true) => {}
                Some(false) => turned.away(Unfit::Results(place))?,
                None => untold.push((place, requirement)),
            }
        }
        let refused = |reason: Unfit| self.turned_away_though_open(sieve, &reason).unwrap_or(reason);
        let posed = self.posed().map_err(|reason| (turned.first.clone().unwrap_or_else(|| refused(reason)), false))?;
        for (place, requirement) in untold {
            if !posed.meets(requirement) {
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
                Ok(variant(question, style, Some(self.index), parameters, posed))
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
    /// turns away a sphere that is at rest and so has no direction. Without unknowns it has turned it away before.
    fn turned_away_though_open(&self, sieve: &Sieve, reason: &Unfit) -> Option<Unfit> {
        if *reason != Unfit::Underdetermined || sieve.question.scene.unknowns.is_empty() {
            return None;
        }
        let opened = Opened::new(sieve.question, self.givens().ok()?.clone()).ok()?;
        let posed = opened.as_far_as_determined(&sieve.wanted).ok()??;
        let is_unmet = |requirement: &Requirement| requirement.holds(&|name| posed.meaning(name)) == Ok(false);
        let unmet = sieve.on_results().find(|(_, requirement, _)| is_unmet(requirement));
        unmet.map(|(place, ..)| Unfit::Results(place))
    }

    /// The collision, worked out in part at least if there is one.
    fn begun(&self) -> RefMut<'_, Worked> {
        let mut worked = self.worked.borrow_mut();
        if let Worked::NotAtAll = *worked {
            let opened = self.givens().map_err(|_| Unfit::NoValue).and_then(|givens| {
                Opened::new(self.sieve.question, givens.clone()).map_err(|reason| Unfit::from(&reason))
            });
            *worked = opened.map_or_else(Worked::Refused, |opened| Worked::InPart(Box::new(opened)));
        }
        worked
    }

    /// The collision worked out; or why these numbers make none, whatever is required of them.
    ///
    /// # Errors
    ///
    /// That reason.
    pub fn posed(&self) -> Result<Posed, Unfit> {
        let mut worked = self.begun();
        *worked = match std::mem::take(&mut *worked) {
            Worked::InPart(opened) => {
                let posed = opened.solve(&self.sieve.wanted).map_err(|reason| Unfit::from(&reason));
                posed.map_or_else(Worked::Refused, Worked::Out)
            }
            other => other,
        };
        match &*worked {
            Worked::Out(posed) => Ok(posed.clone()),
            Worked::Refused(reason) => Err(reason.clone()),
            Worked::NotAtAll | Worked::InPart(_) => unreachable!("it has been worked out"),
        }
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
