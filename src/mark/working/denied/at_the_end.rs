//! Working that ends with a number without a name: `√(1.01² + 3.63²) = 2.4`, where the blank has 3.77.

use super::by_line::Wanted;
use super::{is_unfinished, middle};
use crate::mark::reading::{Reading, Statement};
use crate::mark::working::examine::{Value, Working};
use crate::mark::working::lines::Member;
use crate::mark::working::numbers::{comes_to, sizes};
use crate::mark::working::theirs::is_nearly_right;
use crate::mechanics::{Axis, Moment, Quantity, Sphere};

/// The number with which the working of a part ends, if it is called nothing and is nothing that anybody finds on the way.
pub(crate) struct End {
    /// What it says.
    pub(crate) reading: Reading,
    /// For each blank: does the right value stand nowhere in the lines, but as what this number was worked out from?
    pub(crate) is_never_right: Vec<bool>,
    /// Does it stand there?
    pub(crate) is_worked_out: Vec<bool>,
}

impl Working<'_> {
    pub(in crate::mark::working) fn end(&self) -> Option<End> {
        let studied = self.lines.iter().rfind(|studied| !studied.line.is_crossed_out())?;
        let reading = studied.reading.as_ref()?;
        let (member, values) = self.members(studied).last()?;
        let statement = reading.statements.last()?;
        let said = statement.said.last()?;
        let is_plain = member.expr.names().is_empty() && !is_unfinished(&member.expr);
        let is_named = statement.label.is_some() || member.letter.is_some();
        let is_result = studied.line.typed.contains(['=', '≈']) || said.unit.is_some();
        let is_number = values.iter().all(|value| matches!(value, Value::Number(_)));
        if !(is_plain && is_number && is_result) || is_named || self.is_on_the_way(values) {
            return None;
        }
        let before = self.members_before(studied, member);
        let is_before = |own: &Member| before.iter().any(|one| std::ptr::eq(*one, own));
        let of_blanks = |of: &dyn Fn(&Wanted) -> bool| {
            let each = self.part.blanks.iter().map(|blank| self.wanted(&blank.find));
            each.map(|wanted| wanted.is_some_and(|wanted| of(&wanted))).collect()
        };
        let is_never_right = of_blanks(&|wanted| self.members_that_are(wanted).all(|(_, own)| is_before(own)));
        let is_worked_out = of_blanks(&|wanted| self.members_that_are(wanted).any(|(_, own)| is_before(own)));
        let statement = Statement { said: vec![said.clone()], ..statement.clone() };
        let reading = Reading { statements: vec![statement], printed: String::new(), decided: Vec::new() };
        Some(End { reading, is_never_right, is_worked_out })
    }

    /// Is it the size of anything that is known of the impact, or the square of a speed, a momentum, an energy, or a speed of
    /// approach or of separation? Who ends with such a number has written a step, and the answer in its place.
    fn is_on_the_way(&self, values: &[Value]) -> bool {
        let known = |quantity: Quantity| sizes(&self.prepared.known, quantity);
        // It may come of what was rounded.
        let nearly =
            |value: &Value, size: f64| comes_to(*value, size) || is_nearly_right(middle(value)[0].abs(), size.abs());
        let is = |of: &dyn Fn(usize) -> Option<f64>| {
            values.iter().enumerate().all(|(point, value)| of(point).is_some_and(|size| nearly(value, size)))
        };
        let quantities = || self.prepared.known[0].0.keys().copied();
        let is_speed = |quantity: &Quantity| matches!(quantity, Quantity::Velocity(..) | Quantity::Speed(..));
        let mass = |sphere: Sphere, point: usize| Some(known(Quantity::Mass(sphere))?[point]);
        let of_speed = |speed: &[f64]| {
            is(&|point| Some(speed[point].powi(2)))
                || Sphere::BOTH.into_iter().any(|sphere| {
                    is(&|point| Some(mass(sphere, point)? * speed[point]))
                        || is(&|point| Some(0.5 * mass(sphere, point)? * speed[point].powi(2)))
                })
        };
        let of_both = |moment: Moment| {
            let along = Sphere::BOTH.map(|sphere| known(Quantity::Velocity(sphere, moment, Axis::N)));
            let [Some(a), Some(b)] = along else { return false };
            let momentum = |point: usize| Some(mass(Sphere::A, point)? * a[point] + mass(Sphere::B, point)? * b[point]);
            is(&|point| Some(a[point] - b[point])) || is(&momentum)
        };
        quantities().filter_map(known).any(|all| is(&|point| Some(all[point])))
            || quantities().filter(is_speed).filter_map(known).any(|speed| of_speed(&speed))
            || [Moment::Before, Moment::After].into_iter().any(of_both)
    }
}
