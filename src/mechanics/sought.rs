//! What a letter that was found backwards was found from, so that it can be found again by somebody who goes another way:
//! with a slip, another letter comes out.

use super::Quantity;
use super::backwards::Found;
use super::law::Known;
use super::scene::Condition;
use crate::number::{Letter, Value};

/// A letter that was found, and from what.
#[derive(Clone, Debug)]
pub struct Sought {
    /// The letter.
    pub letter: Letter,
    /// All letters of the scene.
    pub letters: Vec<Letter>,
    /// What the scene gives, with the letter in it.
    pub given: Known<Value>,
    /// What was asked of the scene on the way.
    pub asked: Vec<Quantity>,
    /// Its value, or the ends of its values that come of the scene, each with what vanishes there; of an angle the tangent.
    pub places: Vec<(Value, Vanishing)>,
    /// Are there many values, of which the places are the ends?
    pub is_range: bool,
}

/// What is nought where a letter has the value that was found.
#[derive(Clone, Debug, PartialEq)]
pub enum Vanishing {
    /// The difference between the sides of a condition.
    Gap(Condition),
    /// How far a quantity is from what it can be at most or at least.
    Distance(Quantity, Value),
    /// The rate of change of a quantity that is largest there.
    Slope(Quantity),
}

impl Vanishing {
    /// Is it a rate of change?
    pub fn is_slope(&self) -> bool {
        matches!(self, Vanishing::Slope(_))
    }
}

impl Found {
    /// What its one letter was found from. None where there was nothing to be found, or more than that.
    pub fn sought(&self) -> Option<Sought> {
        let posed = self.posed()?;
        let [letter] = posed.scene.unknowns.as_slice() else { return None };
        let places = match (&self.range, posed.scene.maximise, posed.scene.conditions.as_slice()) {
            (Some(values), ..) => posed.ends(values),
            (None, Some(quantity), _) => vec![(self.values.first()?.1.clone(), Vanishing::Slope(quantity))],
            (None, None, [condition]) => vec![(self.values.first()?.1.clone(), Vanishing::Gap(condition.clone()))],
            _ => return None,
        };
        let bounded = places.iter().filter_map(|(_, vanishing)| match vanishing {
            Vanishing::Distance(quantity, _) => Some(*quantity),
            _ => None,
        });
        let mut asked: Vec<Quantity> = posed.asked.iter().copied().chain(bounded).collect();
        asked.sort();
        asked.dedup();
        let given = posed.given.clone();
        let letters = posed.scene.letters.clone();
        Some(Sought { letter: *letter, letters, given, asked, places, is_range: self.range.is_some() })
    }
}
