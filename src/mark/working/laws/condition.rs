//! Lines that use what is given of the motion after the impact.

use crate::expr::{Expr, Relation};
use crate::mark::key::KeyedMark;
use crate::mark::reading::Form;
use crate::mark::working::equations::Departure;
use crate::mark::working::evidence::Evidence;
use crate::mark::working::examine::{Studied, Working, context};
use crate::mark::working::lines::ReadLine;
use crate::mark::working::numbers::{Context, Sum, comes_to, difference, is_composite, sizes};
use crate::mark::working::theirs::numbers;
use crate::mechanics::{Axis, Known, Moment, Quantity, Sphere};

impl Working<'_> {
    /// A line that holds only because of what is given of the motion after the impact.
    pub(in crate::mark::working) fn uses_condition(&self, mark: &KeyedMark) -> Option<Evidence> {
        if mark.code.is_accuracy() {
            return None;
        }
        // Who starts from the result has not found it: what is true of it says nothing from there on.
        let restates = |studied: &Studied| {
            studied.reading.iter().flat_map(|reading| &reading.equations).any(|equation| self.restates_number(equation))
        };
        let copied_from = self.lines.iter().position(restates).unwrap_or(self.lines.len());
        let copied_from = copied_from.min(self.end_of_finding());
        // What is concluded beside the inequality that points the wrong way has not come from it.
        let turned = self.turned_round(mark);
        let line = (0..self.lines.len()).find(|place| {
            let studied = &self.lines[*place];
            let Some(reading) = &studied.reading else { return false };
            let statements = || reading.statements.iter().flat_map(|statement| &statement.said);
            let is_demanded = |form: &Form| {
                self.is_demanded(form, mark, *place, 1.0)
                    || self.is_of_angles(form)
                    || self.is_own_inequality(form, *place)
                    || turned.is_none() && self.is_own_bound(form, *place)
            };
            let is_inequality = || statements().any(|said| is_demanded(&said.form));
            let is_copied =
                |equation: &(Expr, Expr)| self.is_printed_value(&equation.1) || self.restates_number(equation);
            let mut worked = reading.equations.iter().filter(|equation| !is_copied(equation));
            let holds = |equation: &(Expr, Expr)| {
                *place < copied_from && self.holds_only_where_found(equation)
                    || self.is_of_own_speed(equation, *place)
                    || self.is_speed_by_letters(equation, *place)
                    || self.makes_right_angle(equation)
                    || self.is_set_on_own(equation, *place)
            };
            let mut holds = || worked.any(holds);
            !self.is_printed_result(studied) && studied.matched.is_empty() && (holds() || is_inequality())
        });
        let role = "uses what is given of the motion after the impact";
        line.map(|line| Evidence::given(line, role)).or_else(|| {
            let (line, departure) = (turned?, Departure::InequalityReversed);
            let (note, feedback) = (Some(departure.tag()), departure.sentence().to_owned());
            Some(Evidence { given: false, note, feedback, ..Evidence::given(line, role) })
        })
    }

    /// The line of the inequality that is demanded, if it points the wrong way. Who says for which values it holds, as in `not
    /// reversed if 30 - 150e ≥ 0, e ≤ 1/5`, argues from the others.
    fn turned_round(&self, mark: &KeyedMark) -> Option<usize> {
        let said = |studied: &Studied, is: &dyn Fn(&Form) -> bool| {
            let statements = studied.reading.iter().flat_map(|reading| &reading.statements);
            statements.flat_map(|statement| &statement.said).any(|said| is(&said.form))
        };
        let place = self.lines.iter().enumerate().position(|(place, studied)| {
            let is_turned = |form: &Form| self.is_demanded(form, mark, place, -1.0);
            !studied.line.is_crossed_out() && said(studied, &is_turned)
        })?;
        let demanded = self.demanded_by_scheme(mark)?;
        let says_of_others = |form: &Form| {
            let Form::Equation(Expr::Relation(left, relation, right)) = form else { return false };
            let excess = self.excess(left, *relation, right).filter(|_| self.is_sought(left) || self.is_sought(right));
            let opposite = excess.map(|excess| excess.into_iter().map(|excess| -excess).collect::<Vec<f64>>());
            opposite.is_some_and(|opposite| self.is_positive_multiple(&opposite, &demanded))
        };
        (!self.lines[place..].iter().any(|studied| said(studied, &says_of_others))).then_some(place)
    }

    /// Is it the inequality of the scheme for the student's own components at a wall?
    fn is_own_inequality(&self, form: &Form, place: usize) -> bool {
        match form {
            Form::Equation(Expr::Relation(left, relation, right)) if *relation != Relation::Equal => {
                self.is_own_turn(left, *relation, right, place)
            }
            _ => false,
        }
    }

    pub(in crate::mark::working) fn holds_only_where_found(&self, (left, right): &(Expr, Expr)) -> bool {
        let mut held = 0;
        for point in 0..self.prepared.points.count {
            let Some(there) = self.prepared.where_found(point) else { continue };
            let at = |quantity| Some(vec![there.number(quantity)?; self.prepared.points.count]);
            let names = self.names(&at);
            let points = self.prepared.points.with(&self.prepared.found, point);
            let context = Context { points: &points, given: &names, ..context(self.prepared, point) };
            let Some(difference) = difference(left, right, &context) else { return false };
            let Sum::Number(linear) = difference else { return false };
            if !linear.is_number() || !linear.constant.may_be_nought(linear.size * 100.0) {
                return false;
            }
            held += 1;
        }
        // And not everywhere: an identity says nothing.
        held > 0 && !(0..self.prepared.points.count).all(|point| self.holds_at(left, right, point))
    }

    /// Does the letter that is sought stand in it?
    pub(in crate::mark::working) fn has_sought(&self, expr: &Expr) -> bool {
        let sought = |name: &str| self.question.scene.unknowns.iter().any(|letter| letter.name() == name);
        expr.names().into_iter().any(|name| sought(&name.text))
    }

    /// Is it the inequality of the scheme, or what that is for the student's own velocity, up to a factor of this sign? The
    /// letter alone on one side is what has been concluded from it.
    fn is_demanded(&self, form: &Form, mark: &KeyedMark, place: usize, sign: f64) -> bool {
        let Form::Equation(Expr::Relation(left, relation, right)) = form else { return false };
        let alone = self.left_alone(place);
        let is_stated = |side: &Expr| !self.is_sought(side) && self.is_of_stated(side, &alone);
        if !is_stated(left) || !is_stated(right) {
            return false;
        }
        let [left, right] = [left, right].map(|side| self.with_stated_tangents(side, place));
        let Some(mut stated) = self.excess_of(&left, *relation, &right, &alone) else { return false };
        stated.iter_mut().for_each(|excess| *excess *= sign);
        let is = |demanded: &Vec<f64>| self.is_positive_multiple(&stated, demanded);
        self.demanded_by_scheme(mark).as_ref().is_some_and(is) || self.demanded_of_own(place).iter().any(is)
    }

    /// By how much one side of the scheme's inequality is to be the greater.
    fn demanded_by_scheme(&self, mark: &KeyedMark) -> Option<Vec<f64>> {
        let Some(Expr::Relation(left, relation, right)) = &mark.equation else { return None };
        self.excess(left, *relation, right)
    }

    /// The line of the equation that the inequality of a mark is at the end of the range: `4 - 9e = 0`.
    pub(super) fn critical_line(&self, mark: &KeyedMark) -> Option<usize> {
        let demanded = self.demanded_by_scheme(mark)?;
        let is_it = |(left, right): &(Expr, Expr)| {
            let both = [(left, right), (right, left)];
            let mut stated = both.into_iter().filter_map(|(one, other)| self.excess(one, Relation::Greater, other));
            left.names().len() + right.names().len() > 0
                && !matches!(left, Expr::Name(_))
                && stated.any(|stated| self.is_positive_multiple(&stated, &demanded))
        };
        let equations = |reading: &ReadLine| reading.equations.iter().any(is_it);
        self.lines.iter().position(|studied| studied.reading.as_deref().is_some_and(equations))
    }

    /// By how much one side is to be the greater with the student's own velocities: those that follow from what was found, or
    /// for one after a later impact what a line up to this one says of a letter. Two that point the same way may be compared
    /// as speeds.
    fn demanded_of_own(&self, place: usize) -> Vec<Vec<f64>> {
        let mut conditions = self.question.scene.conditions.iter();
        let Some(condition) = conditions.next().filter(|condition| condition.is_inequality()) else {
            return Vec::new();
        };
        let sides = [&condition.left, &condition.right];
        let quantity = |side: &Expr| match side {
            Expr::Name(name) => name.text.parse::<Quantity>().ok(),
            _ => None,
        };
        let at_points = |all: &[Known<f64>], side: &Expr| match side {
            Expr::Number(number) => Some(vec![number.to_f64(); all.len()]),
            other => sizes(all, quantity(other)?),
        };
        let both = |all: &[Known<f64>]| {
            let [left, right] = sides.map(|side| at_points(all, side));
            Some([left?, right?])
        };
        let (Some(right), Some(own)) = (both(&self.prepared.known), both(&self.followed)) else { return Vec::new() };
        let mut pairs = vec![own.clone()];
        let with = |side: usize, said: Vec<f64>| {
            let mut pair = own.clone();
            pair[side] = said;
            pair
        };
        if let Some(later) = sides.iter().position(|side| quantity(side).is_some_and(|quantity| quantity.impact() > 0))
        {
            pairs.extend(self.said_of_letters(place).into_iter().map(|said| with(later, said)));
        }
        for (side, expr) in sides.into_iter().enumerate() {
            pairs.extend(self.own_side(expr, place).into_iter().map(|said| with(side, said)));
        }
        let sense =
            right.iter().flatten().map(|size| size.signum()).reduce(|one, next| if one == next { one } else { 0.0 });
        let excess = |[left, right]: &[Vec<f64>; 2]| -> Option<Vec<f64>> {
            left.iter().zip(right).map(|(left, right)| oriented(left - right, condition.relation)).collect()
        };
        let as_speeds = |pair: &[Vec<f64>; 2]| {
            let sense = sense.filter(|sense| *sense != 0.0)?;
            Some(pair.clone().map(|sizes| sizes.into_iter().map(|size| sense * size.abs()).collect()))
        };
        let speeds: Vec<[Vec<f64>; 2]> = pairs.iter().filter_map(as_speeds).collect();
        pairs.iter().chain(&speeds).filter_map(excess).collect()
    }

    /// What the lines up to one say of letters, in the letter that is sought: `x = 3/f`.
    fn said_of_letters(&self, place: usize) -> Vec<Vec<f64>> {
        let members = self.lines[..=place].iter().flat_map(|studied| self.members(studied));
        let said = members.filter(|(member, _)| member.letter.is_some() && self.has_sought(&member.expr));
        said.filter_map(|(_, values)| numbers(values)).collect()
    }

    /// The line of an inequality of which one side comes to this by a formula: `4f > 2` has the speed after a wall.
    pub(super) fn inequality_with(&self, right: &[f64]) -> Option<usize> {
        let is = |side: &Expr| {
            let values = self.values_of(side).filter(|_| is_composite(side));
            values.is_some_and(|values| values.iter().zip(right).all(|(value, right)| comes_to(*value, *right)))
        };
        let has = |form: &Form| match form {
            Form::Equation(Expr::Relation(left, relation, right)) => {
                oriented(0.0, *relation).is_some() && (is(left) || is(right))
            }
            _ => false,
        };
        self.lines.iter().position(|studied| {
            let statements = studied.reading.iter().flat_map(|reading| &reading.statements);
            statements.flat_map(|statement| &statement.said).any(|said| has(&said.form))
        })
    }

    /// Has every velocity in it been stated before, by an equation that leaves it alone or otherwise, so that it says
    /// something of the letter that is sought?
    fn is_of_stated(&self, expr: &Expr, alone: &[(String, Vec<f64>)]) -> bool {
        let letters = self.convention.as_ref().map(|convention| convention.letters.as_slice()).unwrap_or_default();
        let is_stated = |name: &str| {
            let place = letters.iter().position(|letter| letter == name);
            let along = |place: usize| Quantity::Velocity(Sphere::BOTH[place], Moment::After, Axis::N);
            alone.iter().any(|(own, _)| own == name)
                || place.is_none_or(|place| self.theirs.values.contains_key(&along(place)))
        };
        expr.names().into_iter().all(|name| is_stated(&name.text))
    }

    /// By how much the side that is to be greater is, at every point.
    pub(super) fn excess(&self, left: &Expr, relation: Relation, right: &Expr) -> Option<Vec<f64>> {
        self.excess_of(left, relation, right, &[])
    }

    /// The same with what equations have left alone.
    fn excess_of(
        &self,
        left: &Expr,
        relation: Relation,
        right: &Expr,
        alone: &[(String, Vec<f64>)],
    ) -> Option<Vec<f64>> {
        let names: Vec<(String, Vec<f64>)> = alone.iter().chain(&self.names).cloned().collect();
        let with = |point| Context { given: &names, ..self.context(point) };
        let at = |point| match difference(left, right, &with(point))? {
            Sum::Number(linear) if linear.is_number() => oriented(linear.constant.middle(), relation),
            _ => None,
        };
        (0..self.prepared.points.count).map(at).collect()
    }

    /// Is one the other with a positive factor: a number, or with it the masses together or letters that were cancelled?
    pub(super) fn is_positive_multiple(&self, stated: &[f64], demanded: &[f64]) -> bool {
        if demanded.iter().any(|demanded| demanded.abs() < 1e-9) {
            return false;
        }
        let quotients: Vec<f64> = stated.iter().zip(demanded).map(|(stated, demanded)| stated / demanded).collect();
        let masses = Sphere::BOTH.map(|sphere| sizes(&self.prepared.known, Quantity::Mass(sphere)));
        let together = match masses {
            [Some(a), Some(b)] => Some(a.iter().zip(b).map(|(a, b)| a + b).collect::<Vec<f64>>()),
            _ => None,
        };
        let is_sought = |name: &str| self.question.scene.unknowns.iter().any(|letter| letter.name() == name);
        let letters = self.question.letters.iter().filter(|letter| !is_sought(letter.name()));
        let mut factors = vec![vec![1.0; quotients.len()]];
        factors.extend(together);
        for letter in letters {
            let at = |point| self.prepared.points.letter(letter.name(), point).unwrap_or(1.0);
            let powers = factors.iter().flat_map(|factor| {
                [-2, -1, 0, 1, 2].map(|power| {
                    factor.iter().enumerate().map(|(point, one)| one * at(point).powi(power)).collect::<Vec<f64>>()
                })
            });
            factors = powers.collect();
        }
        factors.iter().any(|factor| {
            let mut each = quotients.iter().zip(factor).map(|(quotient, factor)| quotient / factor);
            let Some(first) = each.next().filter(|first| *first > 1e-9) else { return false };
            each.all(|other| (other - first).abs() < 1e-6 * first)
        })
    }

    pub(in crate::mark::working) fn holds_at(&self, left: &Expr, right: &Expr, point: usize) -> bool {
        let names = self.names(&|quantity| sizes(&self.prepared.known, quantity));
        let context = Context { given: &names, ..context(self.prepared, point) };
        match difference(left, right, &context) {
            Some(Sum::Number(linear)) => linear.is_number() && linear.constant.may_be_nought(linear.size),
            _ => false,
        }
    }
}

/// A difference as what is to be greater less what is to be smaller; `None` of an equation.
pub(super) fn oriented(difference: f64, relation: Relation) -> Option<f64> {
    match relation {
        Relation::Greater | Relation::GreaterOrEqual => Some(difference),
        Relation::Less | Relation::LessOrEqual => Some(-difference),
        _ => None,
    }
}
