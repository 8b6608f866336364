//! What is worked out of a model answer once, however many answers are judged by it.

use std::sync::{Arc, OnceLock};

use crate::answer::Kind;
use crate::expr::{Expr, Meaning};
use crate::mark::enclosure::{enclose, enclose_roughly};
use crate::number::{FloatInterval, Interval, Letter, Value};

use super::accuracy::{BITS, Nearly, Target};
use super::angle::{Enclosed, as_turn};
use super::equation::Difference;
use super::{Model, exact};

/// What is known of a model's value, worked out when it is first asked for.
///
/// It is no part of the model: two models are the same whether or not anything has been worked out yet. Copies of a model
/// share it, so that a copy for every script of a class costs nothing.
#[derive(Clone, Default)]
pub(crate) struct Prepared(Arc<OnceLock<Arc<Known>>>);

impl PartialEq for Prepared {
    fn eq(&self, _: &Prepared) -> bool {
        true
    }
}

impl std::fmt::Debug for Prepared {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str("Prepared")
    }
}

/// Enclosures and exact value of an expression.
pub(super) struct Known {
    of: Expr,
    letters: Vec<Letter>,
    enclosures: Vec<OnceLock<Option<Interval>>>,
    rough: Vec<OnceLock<Option<FloatInterval>>>,
    meaning: OnceLock<Option<Meaning>>,
    has_names: OnceLock<bool>,
    written: OnceLock<Option<Expr>>,
    /// The value, where it is a constant, nearly.
    nearly: OnceLock<Option<Nearly>>,
    turn: OnceLock<Option<Enclosed>>,
    difference: OnceLock<Option<Difference>>,
    further: [OnceLock<Model>; Further::COUNT],
}

/// Other models that follow from one, by which an answer may also be judged.
#[derive(Clone, Copy)]
pub(super) enum Further {
    /// The size of a velocity.
    Size,
    /// The direction of a velocity.
    Direction,
    /// The angle with that tangent.
    ArcTangent,
}

impl Further {
    const COUNT: usize = 3;
}

impl Known {
    fn of(model: &Model) -> Known {
        let letters = model.vocabulary.letters.clone();
        let enclosures = exact::points(&letters).map(|_| OnceLock::new()).collect();
        let rough = exact::points(&letters).map(|_| OnceLock::new()).collect();
        Known {
            of: model.value.clone(),
            letters,
            enclosures,
            rough,
            meaning: OnceLock::new(),
            has_names: OnceLock::new(),
            written: OnceLock::new(),
            nearly: OnceLock::new(),
            turn: OnceLock::new(),
            difference: OnceLock::new(),
            further: Default::default(),
        }
    }

    /// What is a constant is the same at every point.
    fn point(&self, point: u32) -> u32 {
        if self.has_names() { point } else { 0 }
    }

    /// The enclosure of the value at a fixed point.
    pub(super) fn enclosure(&self, point: u32) -> Option<Interval> {
        let point = self.point(point);
        let known = self.enclosures.get(point as usize)?;
        known.get_or_init(|| enclose(&self.of, &self.letters, point, exact::BITS)).clone()
    }

    /// The enclosure between doubles.
    pub(super) fn roughly(&self, point: u32) -> Option<FloatInterval> {
        let point = self.point(point);
        let known = self.rough.get(point as usize)?;
        *known.get_or_init(|| enclose_roughly(&self.of, &self.letters, point))
    }

    /// The exact meaning.
    pub(super) fn meaning(&self) -> Option<&Meaning> {
        self.meaning.get_or_init(|| exact::meaning(&self.of, &self.letters)).as_ref()
    }

    /// Are there letters in it?
    pub(super) fn has_names(&self) -> bool {
        *self.has_names.get_or_init(|| !self.of.names().is_empty())
    }

    /// The exact value, if it is a plain number or a formula.
    pub(super) fn value(&self) -> Option<&Value> {
        match self.meaning()? {
            Meaning::Number(value) => Some(value),
            _ => None,
        }
    }

    /// What a decimal is held against, where it is a plain number; with letters it has no enclosure.
    pub(super) fn target(&self) -> Option<Target<'_>> {
        Some(Target::Value(self.value()?, self.nearly()))
    }

    /// Its enclosures, if it is a constant.
    pub(super) fn nearly(&self) -> Option<&Nearly> {
        let enclosed = || match self.value() {
            Some(value) => value.enclose_constant(BITS),
            None if self.has_names() => None,
            None => self.enclosure(0),
        };
        self.nearly.get_or_init(|| enclosed().map(Nearly::of)).as_ref()
    }

    /// The angle that it means; a plain number is degrees.
    pub(super) fn turn(&self) -> Option<&Enclosed> {
        self.turn.get_or_init(|| self.meaning().and_then(as_turn).map(Enclosed::of)).as_ref()
    }

    /// Left minus right, if it is an equation.
    pub(super) fn difference(&self) -> Option<&Difference> {
        self.difference.get_or_init(|| Difference::of(&self.of, &self.letters)).as_ref()
    }

    /// The value as it is written when it has been worked out.
    pub(super) fn written(&self) -> Option<&Expr> {
        self.written.get_or_init(|| self.value().map(crate::expr::written)).as_ref()
    }
}

impl Model {
    /// What is known of the value; worked out anew for a model that was changed after it had been used.
    pub(super) fn known(&self) -> Arc<Known> {
        let known = self.prepared.0.get_or_init(|| Arc::new(Known::of(self)));
        let same = known.of == self.value && known.letters == self.vocabulary.letters;
        if same { known.clone() } else { Arc::new(Known::of(self)) }
    }

    /// A model that follows from this one, with the rule of this one; its value is the same for all answers.
    pub(super) fn further(&self, which: Further, kind: Kind, value: impl FnOnce() -> Expr) -> Model {
        let known = self.known();
        let further = known.further[which as usize].get_or_init(|| {
            let further = self.of_value(value());
            further.known();
            further
        });
        Model { kind, accept: self.accept.clone(), rebounds: self.rebounds, ..further.clone() }
    }

    /// A model of another value in the same question, about which nothing is known yet.
    pub(crate) fn of_value(&self, value: Expr) -> Model {
        let other = Model::new(value, self.kind, self.accept.clone(), self.vocabulary.clone());
        Model { rebounds: self.rebounds, ..other }
    }
}
