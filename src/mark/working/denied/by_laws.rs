//! Equations that deny what is found: `80 = 18m²` has not led to `m = 4`, nor `5 - 2 = 1 + 2w` to `w = 2`.

use super::{are_far, is_unfinished};
use crate::expr::Expr;
use crate::mark::working::equations::{Convention, differences, is_value};
use crate::mark::working::examine::{Working, value};
use crate::mark::working::lines::Member;
use crate::mark::working::numbers::{Linear, any_within, sizes};
use crate::mark::working::theirs::{is_of_velocity, numbers};
use crate::mechanics::{Axis, Moment, Quantity, Sphere};
use crate::number::Range;

impl Working<'_> {
    /// Do lines set up an equation in the one letter that is sought of which the right value is plainly no root, and none of
    /// which it is? That the letter is so much is no such equation.
    pub(in crate::mark::working) fn denies_what_is_found(&self) -> bool {
        if self.prepared.found.len() != 1 {
            return false;
        }
        let open = self.lines.iter().filter(|studied| studied.matched.is_empty() && !studied.line.is_crossed_out());
        let readings = open.filter_map(|studied| studied.reading.as_ref());
        let set_up = readings.flat_map(|reading| &reading.equations).filter(|(left, right)| {
            !self.is_sought(left) && !self.is_sought(right) && (self.has_sought(left) || self.has_sought(right))
        });
        let set_up: Vec<&(Expr, Expr)> = set_up.collect();
        let holds = |equation: &&(Expr, Expr)| self.holds_only_where_found(equation);
        // What was right at first may have been worked out wrongly: the last of them leads to the value.
        let last = set_up.last().filter(|last| !has_rounded_nought(last) && !holds(last));
        last.is_some_and(|last| self.is_denied(last))
            || set_up.iter().any(|equation| self.is_denied(equation)) && !set_up.iter().any(holds)
    }

    /// Of each sphere: do the student's own equations lead elsewhere than to its right velocity after the impact, and is nothing
    /// after them right that is more than a value? Whatever is right then has not come from them; where they have been followed
    /// to what they lead to, the answer is another attempt.
    pub(in crate::mark::working) fn denies_velocities(&self) -> [bool; 2] {
        if !self.prepared.found.is_empty() {
            return [false; 2];
        }
        let along = Sphere::BOTH.map(|sphere| Quantity::Velocity(sphere, Moment::After, Axis::N));
        let right = along.map(|velocity| sizes(&self.prepared.known, velocity));
        let denied = match (&self.convention, self.own_solution(), &right) {
            (Some(convention), Some(own), [Some(a), Some(b)]) => match self.finds_velocity(convention, [a, b]) {
                true => [false; 2],
                false => [are_far(&own[0], a), are_far(&own[1], b)],
            },
            (_, None, _) => self.denies_one_velocity(&right),
            _ => [false; 2],
        };
        let is_followed = |place: usize| {
            let own = self.theirs.values.get(&along[place]);
            own.zip(right[place].as_ref()).is_some_and(|((own, _), right)| are_far(own, right))
        };
        [0, 1].map(|place| denied[place] && !is_followed(place))
    }

    /// Is a step from both right equations there, or the right formula for one of the two velocities?
    fn finds_velocity(&self, convention: &Convention, right: [&Vec<f64>; 2]) -> bool {
        let is_step = |equation: &(Expr, Expr)| {
            let is_letter = |side: &Expr| matches!(side, Expr::Name(name) if convention.letters.contains(&name.text));
            let is_value = is_letter(&equation.0) || is_letter(&equation.1);
            let laws = self.prepared.laws.as_ref().filter(|_| !is_value);
            laws.zip(differences(equation, self.prepared)).is_some_and(|(laws, line)| laws.is_step(&line, convention))
        };
        let is_found = |member: &Member| {
            let place = convention.letters.iter().position(|letter| member.letter.as_ref() == Some(letter));
            // In letters a formula is what was to be found, and no way to it.
            let is_way = is_unfinished(&member.expr) && member.expr.names().is_empty();
            let own = self.in_given_names(&member.expr).filter(|_| is_way);
            let own = own.and_then(|values| numbers(&values));
            place.zip(own).is_some_and(|(place, own)| {
                let own: Vec<f64> = own.iter().map(|own| own * convention.signs[place]).collect();
                !are_far(&own, right[place])
            })
        };
        let open = self.lines.iter().filter(|studied| studied.matched.is_empty());
        open.filter_map(|studied| studied.reading.as_ref())
            .any(|line| line.equations.iter().any(is_step) || line.members.iter().any(is_found))
    }

    /// The same where one velocity is given: an equation in one letter has another root, and none has the right one.
    fn denies_one_velocity(&self, right: &[Option<Vec<f64>>; 2]) -> [bool; 2] {
        let is_given = |sphere| {
            let along = |axis| Quantity::Velocity(sphere, Moment::After, axis);
            [Axis::X, Axis::N].into_iter().any(|axis| self.prepared.given[0].0.contains_key(&along(axis)))
        };
        let open = Sphere::BOTH.map(|sphere| !is_given(sphere));
        let right = match (open, right) {
            ([false, true], [_, Some(right)]) | ([true, false], [Some(right), _]) => right,
            _ => return [false; 2],
        };
        let root = |equation: &(Expr, Expr)| {
            let at = |linear: &Linear| match linear.unknowns.as_slice() {
                [(letter, number)] if is_of_velocity(letter) => {
                    Some((linear.constant.middle() / number.middle()).abs())
                }
                _ => None,
            };
            differences(equation, self.prepared)?.iter().map(at).collect::<Option<Vec<f64>>>()
        };
        let readings = self.lines.iter().filter_map(|studied| studied.reading.as_ref());
        let equations = readings.flat_map(|line| &line.equations).filter(|equation| !is_value(equation));
        let right: Vec<f64> = right.iter().map(|right| right.abs()).collect();
        let are_elsewhere: Vec<bool> = equations.filter_map(root).map(|own| are_far(&own, &right)).collect();
        let is_denied = !are_elsewhere.is_empty() && are_elsewhere.iter().all(|elsewhere| *elsewhere);
        open.map(|open| open && is_denied)
    }

    /// Is an equation in nothing but the letter that is sought, and plainly false of what that is?
    fn is_denied(&self, (left, right): &(Expr, Expr)) -> bool {
        let found = |name: &str| {
            let mut found = self.prepared.found.iter();
            let (letter, values) = found.find(|(letter, _)| letter.name() == name)?;
            let size = values.first().copied().flatten()?;
            // An angle is known by its tangent.
            Some(match letter.range() {
                Range::Acute => Expr::Degrees(Box::new(decimal(size.atan().to_degrees()))),
                _ => decimal(size),
            })
        };
        let [left, right] = [left, right].map(|side| side.substitute(&found));
        let size = |side: &Expr| numbers(&value(side, self.prepared, &self.prepared.names)?);
        let are_apart = size(&left).zip(size(&right)).is_some_and(|(left, right)| are_far(&left, &right));
        // Where both come to nought, floats leave noise behind.
        are_apart && !(0..self.prepared.points.count).all(|point| self.holds_at(&left, &right, point))
    }
}

fn decimal(number: f64) -> Expr {
    Expr::Decimal(format!("{number:.12}"))
}

/// Is it set equal to nought with decimals, which are rounded? Of nought no part is small.
fn has_rounded_nought((left, right): &(Expr, Expr)) -> bool {
    let is_decimal = |inner: &Expr| matches!(inner, Expr::Decimal(_));
    [left, right].into_iter().any(Expr::is_zero) && [left, right].into_iter().any(|side| any_within(side, &is_decimal))
}
