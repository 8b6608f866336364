//! What the student's letters for the velocities after the impact stand for.

use super::equations::Convention;
use super::examine::{Studied, Value, Working};
use super::numbers::sizes;
use crate::mechanics::{Axis, Moment, Quantity, Sphere};

impl Working<'_> {
    /// The names that are given, and the student's letters for the components after the impact, which are these.
    pub(super) fn names(&self, component: &dyn Fn(Quantity) -> Option<Vec<f64>>) -> Vec<(String, Vec<f64>)> {
        let mut names = self.prepared.names.clone();
        let here = self.convention.as_ref().map(|convention| (&convention.letters, &convention.signs));
        // What an earlier part called them, unless a letter is used for something else now.
        let earlier = self.theirs.letters.as_ref().map(|(letters, signs)| (letters, signs));
        let earlier = earlier.filter(|(letters, _)| !letters.iter().any(|letter| self.is_said_to_be_something(letter)));
        if let Some((letters, signs)) = here.or(earlier) {
            for (place, letter) in letters.iter().enumerate() {
                let values = component(Quantity::Velocity(Sphere::BOTH[place], Moment::After, Axis::N));
                let signed = |values: Vec<f64>| values.iter().map(|value| value * signs[place]).collect();
                names.extend(values.map(|values| (letter.clone(), signed(values))));
            }
        }
        names
    }

    /// Does a line have a velocity after the impact as it is, and in no figures?
    pub(super) fn finds_exactly(&self) -> bool {
        let along = Sphere::BOTH.map(|sphere| Quantity::Velocity(sphere, Moment::After, Axis::N));
        let right: Vec<Vec<f64>> = along.iter().filter_map(|along| sizes(&self.prepared.known, *along)).collect();
        let is_exact = |value: &Value, right: &f64| match value {
            Value::Number(number) => (number.middle().abs() - right.abs()).abs() <= 1e-9 * right.abs(),
            Value::Vector(..) => false,
        };
        let is_one = |values: &Vec<Value>| {
            right.iter().any(|right| values.iter().zip(right).all(|(value, right)| is_exact(value, right)))
        };
        let mut members = self.lines.iter().flat_map(|studied| self.members(studied));
        members.any(|(member, values)| member.letter.is_some() && is_one(values))
    }

    fn is_said_to_be_something(&self, letter: &str) -> bool {
        let members = self.lines.iter().filter_map(|studied| studied.reading.as_ref()).flat_map(|line| &line.members);
        members.filter_map(|member| member.letter.as_deref()).any(|own| own == letter)
    }

    /// Whose the student's letters are, where an equation says so.
    pub(super) fn convention_by_laws(&self) -> Option<&Convention> {
        let is_law = |studied: &Studied| !studied.matched.is_empty();
        self.convention.as_ref().filter(|_| self.lines.iter().any(is_law))
    }
}
