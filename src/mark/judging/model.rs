//! What an answer is held against.

use crate::answer::{Accept, Kind};
use crate::expr::Expr;
use crate::mark::reading::Vocabulary;
use crate::mechanics::{Quantity, Sphere};
use crate::unit::Unit;

use super::known::Prepared;
use super::letters;

/// What is right, and how near an answer must come.
#[derive(Clone, Debug, PartialEq)]
pub struct Model {
    /// The exact value; for an angle so many degrees, or an angle such as `atan(7)`.
    pub value: Expr,
    /// Its kind.
    pub kind: Kind,
    /// The rule of acceptance.
    pub accept: Accept,
    /// The letters of the question.
    pub vocabulary: Vocabulary,
    /// What is asked for, where that is known: from it come the unit, the sphere and the line of an angle.
    pub quantity: Option<Quantity>,
    /// The letter that is to be found, where one is: another letter is then the name of something else.
    pub letter: Option<String>,
    /// The Greek letter that the question has for what is asked, `θ` where tan θ is; another is then the name of another angle.
    pub angle: Option<String>,
    /// Greek letters that stand for other things which the question asks for.
    pub other_angles: Vec<String>,
    /// Does the sphere move from B towards A? An angle measured from BA can be judged only where that is known.
    pub rebounds: Option<bool>,
    /// Does the sphere go back along the line of centres, where its speed or velocity is asked, or is it to, where a range is?
    pub turns_back: Option<bool>,
    /// Does the sphere whose speed is asked go the same way along the line of centres as the other one of its impact, where
    /// both move along it?
    pub same_way: Option<bool>,
    /// Of the size of an impulse: does it act from B to A, or away from a wall? Known only where the question says on whom.
    pub pushes_back: Option<bool>,
    /// Are two spheres to meet again, or not to, where a range is asked?
    pub meet_again: Option<bool>,
    /// Does an angle that is asked turn anticlockwise, from **i** or from the path before?
    pub anticlockwise: Option<bool>,
    /// Does an impulse of which the angle with **i** is asked point against **i**? Known only where one body alone receives it.
    pub against_i: Option<bool>,
    /// The spheres that take no part in the impact of which a quantity is asked: nothing of it is named after them.
    pub strangers: Vec<Sphere>,
    /// Of a speed: the acute angle between the path of the sphere and the line of centres. A direction told beside a speed
    /// can be judged only where that is known.
    pub path: Option<Expr>,
    /// The vector in **i** and **j** of which the size is asked.
    pub vector: Option<[Expr; 2]>,
    /// Is it of two spheres together, as the energy lost in their impact is? Then no sphere alone is its name.
    pub is_of_both: bool,
    /// What has been worked out of it.
    pub(crate) prepared: Prepared,
}

impl Model {
    /// A model of which no more is known than its value, its kind, the rule and the letters.
    pub fn new(value: Expr, kind: Kind, accept: Accept, vocabulary: Vocabulary) -> Model {
        Model {
            is_of_both: false,
            value,
            kind,
            accept,
            vocabulary,
            quantity: None,
            letter: None,
            angle: None,
            other_angles: Vec::new(),
            rebounds: None,
            turns_back: None,
            same_way: None,
            pushes_back: None,
            meet_again: None,
            anticlockwise: None,
            against_i: None,
            strangers: Vec::new(),
            path: None,
            vector: None,
            prepared: Prepared::default(),
        }
    }

    /// The right unit, if it is known what is asked for.
    pub(super) fn unit(&self) -> Option<Unit> {
        self.quantity.map(Quantity::unit).or_else(|| self.letter.as_deref().and_then(letters::unit_of))
    }
}
