//! The component perpendicular to the line of centres, or along a wall, which an impact leaves as it is.

use super::shapes::{components_in, is_tangent, two_squares};
use crate::bank::Code;
use crate::expr::{Expr, Function};
use crate::mark::judging::may_be_named;
use crate::mark::reading::{Form, Label, Said};
use crate::mark::working::equations::{Departure, Matched};
use crate::mark::working::evidence::Evidence;
use crate::mark::working::examine::{Studied, Value, Working, has_vectors};
use crate::mark::working::lines::{
    Member, clauses, clauses_by_words, is_called_otherwise, says_across, says_along, says_into_wall,
};
use crate::mark::working::numbers::{any_within, comes_to, is_sum_of_figures, is_vector, sizes};
use crate::mechanics::{Axis, Moment, Quantity, Setting, Sphere};

impl Working<'_> {
    /// The components across the line of centres, of every sphere that has one, seen.
    pub(super) fn unchanged(&self) -> Option<Evidence> {
        let across = self.across();
        let seen = |(sphere, right): &(Sphere, Vec<f64>)| {
            let is_oblique = self.prepared.setting == Setting::Oblique;
            let shows = |studied: &Studied| {
                self.shows_component(studied, *sphere, right) || is_oblique && self.lists_components(studied, &across)
            };
            self.lines.iter().position(shows)
        };
        let places: Vec<usize> = across.iter().filter_map(seen).collect();
        let exchanged = || if places.len() < across.len() { self.line_beside_other(&across) } else { None };
        let role = "the component perpendicular to the line of centres";
        if let Some(line) = exchanged() {
            let feedback = "this is the component of the other sphere: each keeps its own".to_owned();
            return Some(Evidence { given: false, feedback, ..Evidence::given(line, role) });
        }
        // Of a ratio of components both are seen.
        let at_wall = || self.tangent_by_e().or_else(|| self.by_unknown_components(Axis::T, Code::A1));
        let seen = places.iter().max().copied().or_else(at_wall).or_else(|| self.across_implied(&across));
        let found = Evidence::given(seen?, role);
        let changed = |(line, says): (usize, &str)| {
            let (note, feedback) = (Some(Departure::WrongAxis.tag()), format!("{says}: e has no part in it"));
            Evidence { line, given: false, note, feedback, ..Evidence::given(line, found.role.clone()) }
        };
        let by_wall =
            || Some((self.changes_along_wall()?, "a smooth wall leaves the component parallel to it as it is"));
        let by_sphere = || Some((self.changes_across(&across)?, "each sphere keeps this component as it is"));
        if let Some(line) = by_wall().or_else(by_sphere) {
            return Some(changed(line));
        }
        match places.is_empty() || places.len() == across.len() {
            true => Some(found),
            false => {
                let feedback = "only one of the two components is there, and each sphere keeps its own".to_owned();
                Some(Evidence { given: false, feedback, ..found })
            }
        }
    }

    /// The components across the line of centres before the impact, of every sphere that has one.
    pub(in crate::mark::working) fn across(&self) -> Vec<(Sphere, Vec<f64>)> {
        let across = Sphere::BOTH.into_iter().filter_map(|sphere| {
            let across = sizes(&self.prepared.known, Quantity::Velocity(sphere, Moment::Before, Axis::T))?;
            across.iter().any(|size| size.abs() > 1e-9).then_some((sphere, across))
        });
        across.collect()
    }

    /// Does a line show this component: as a value, in Pythagoras, in a tangent, or in a vector?
    fn shows_component(&self, studied: &Studied, sphere: Sphere, right: &[f64]) -> bool {
        let comes = |(value, right): (&Value, &f64)| comes_to(*value, *right) || is_without_last_nought(*value, *right);
        let is_right = |values: &[Value]| values.iter().zip(right).all(comes);
        let is_law = !studied.matched.is_empty();
        let whole = self.members(studied).filter(|(member, _)| !is_law || self.is_beside_law(studied, member)).any(
            |(member, values)| {
                let is_composite = self.is_worked_out(&member.expr) && !is_sum_of_figures(&member.expr);
                let is_called = self.is_called(member) || is_composite || self.says_across(&studied.line.typed);
                let is_called = is_called || self.says_unchanged(&studied.line.typed);
                let named = is_called && !is_called_otherwise(member, sphere);
                let before = member.letter.as_ref().is_some_and(|letter| letter.starts_with('u') && !is_composite);
                let unknown = member.letter.as_ref().is_some_and(|letter| self.is_unknown(letter));
                let unknown = unknown || self.is_open_multiple(member);
                let fits = named && !unknown && !before && !member.is_given && is_right(values);
                let fits = fits && !self.is_rebound(studied, member.statement);
                (fits && !self.is_taken_along(studied, member))
                    || self.has_component(values, sphere, right)
                    || self.has_part_along_wall(&member.expr, values, right)
            },
        );
        if whole {
            return true;
        }
        let Some(reading) = &studied.reading else { return false };
        let is_own = |member: &&Member| !is_called_otherwise(member, sphere);
        if reading.members.iter().filter(is_own).any(|member| self.has_component_beside_unknown(&member.expr, sphere)) {
            return true;
        }
        let is_open = |member: &&Member| {
            studied.matched.is_empty()
                && !self.says_along(studied, member)
                && !self.is_beside_other(&member.expr, sphere, right)
        };
        let formulas = reading.members.iter().filter(is_open);
        let mut components = formulas.clone().flat_map(|member| components_in(&member.expr, is_tangent(member)));
        let is_over_unknown = |inner: &Expr| match inner {
            Expr::Quotient(above, below) => {
                self.is_along_or_tangent(below) && self.values_of(above).is_some_and(|values| is_right(&values))
            }
            _ => false,
        };
        components.any(|expr| self.values_of(&expr).is_some_and(|values| is_right(&values)))
            || formulas.clone().any(|member| any_within(&member.expr, &is_over_unknown))
            || formulas.into_iter().any(|member| self.has_sum_of_squares(&member.expr, sphere, right))
    }

    /// Does a value stand on the line of a law, and in a statement of its own, `24cos48 = 3v + 4w; V sin β = 8sin48`?
    fn is_beside_law(&self, studied: &Studied, member: &Member) -> bool {
        let Some(statement) = studied.reading.as_ref().and_then(|reading| reading.statements.get(member.statement))
        else {
            return false;
        };
        let is_open = |expr: &Expr| expr.names().iter().any(|name| self.is_unknown(&name.text));
        // `-u = v + w` is no list of values.
        let is_value = |said: &Said| matches!(&said.form, Form::Value(expr) if !is_open(expr));
        let has_unknown = |label: &Label| label.expr.as_ref().is_some_and(is_open);
        statement.said.iter().all(is_value) && !statement.label.as_ref().is_some_and(has_unknown)
    }

    /// The first line in which a component across the line of centres stands beside that of the other sphere along it.
    fn line_beside_other(&self, across: &[(Sphere, Vec<f64>)]) -> Option<usize> {
        let has =
            |member: &Member| across.iter().any(|(sphere, right)| self.is_beside_other(&member.expr, *sphere, right));
        self.lines.iter().position(|studied| self.members(studied).any(|(member, _)| has(member)))
    }

    /// Is this component of a sphere in Pythagoras with that of the other sphere along the line of centres, where both spheres
    /// have both: `√(4² + 3²)`, where 4 is that of B and 3 that of A?
    fn is_beside_other(&self, expr: &Expr, sphere: Sphere, right: &[f64]) -> bool {
        if self.across().len() < 2 {
            return false;
        }
        let [own, others] = [sphere, sphere.other()].map(|of| self.sizes_of(of, Axis::N));
        let is = |expr: &Expr, sizes: &[Vec<f64>]| self.is_one_of(expr, sizes) || self.is_near_one_of(expr, sizes);
        let across = [right.to_vec()];
        let are = |one: &Expr, along: &Expr| is(one, &across) && is(along, &others) && !is(along, &own);
        any_within(expr, &|inner| two_squares(inner).is_some_and(|(one, other)| are(&one, &other) || are(&other, &one)))
    }

    /// The line on which *e* is put to a component across the line of centres that is nowhere reckoned with as it is.
    fn changes_across(&self, across: &[(Sphere, Vec<f64>)]) -> Option<usize> {
        if self.prepared.setting != Setting::Oblique || self.is_in_vectors() {
            return None;
        }
        let before = |sphere| sizes(&self.prepared.known, Quantity::Velocity(sphere, Moment::Before, Axis::N));
        let along: Vec<Vec<f64>> = Sphere::BOTH.into_iter().filter_map(before).collect();
        let is_alike = |one: &[f64], other: &[f64]| {
            one.iter().zip(other).all(|(one, other)| (one.abs() - other.abs()).abs() < 1e-9)
        };
        // `e × 4` may also be of a velocity along the line of centres, or of those of both spheres.
        let approach: Vec<f64> = match along.as_slice() {
            [a, b] => a.iter().zip(b).map(|(a, b)| a - b).collect(),
            _ => return None,
        };
        let is_only_across = |own: &[f64]| along.iter().chain([&approach]).all(|other| !is_alike(own, other));
        let mut own = across.iter().filter(|(_, own)| is_only_across(own));
        own.find_map(|(sphere, own)| {
            let after = Quantity::Velocity(*sphere, Moment::After, Axis::T);
            let changes = |studied: &Studied| {
                let is_else = |member: &Member| member.label.as_ref().is_some_and(|label| !may_be_named(label, after));
                !studied.line.is_crossed_out()
                    && studied.matched.is_empty()
                    && self.members(studied).any(|(member, _)| !is_else(member) && self.is_e_times(&member.expr, own))
            };
            self.lines.iter().position(changes).filter(|line| !self.reckons_with(own, *line))
        })
    }

    /// Is it the student's letter for a component along the line of centres, or the tangent of an angle? What stands over it
    /// is across: the gradient `v sin θ/p`, and `u sin α/tan β`.
    fn is_along_or_tangent(&self, expr: &Expr) -> bool {
        match expr {
            Expr::Name(name) => self.is_unknown(&name.text),
            Expr::Call(Function::Tan, _) => self.values_of(expr).is_none(),
            _ => false,
        }
    }

    /// Is a value one that the student takes for a component along the line of centres: because it is said to be, or because it
    /// stands in the equations for one and nowhere is said to be across?
    fn is_taken_along(&self, studied: &Studied, member: &Member) -> bool {
        let laws = || self.lines.iter().flat_map(|studied| &studied.matched);
        let is_exchanged = |matched: &Matched| {
            matched.departures.iter().any(|one| matches!(one, Departure::SineForCosine | Departure::WrongAxis))
        };
        let is_used_along = || match laws().next() {
            Some(_) => laws().all(is_exchanged),
            None => member.label.as_ref().is_some_and(|label| label.ends_with('x')),
        };
        let is_oblique = self.prepared.setting == Setting::Oblique && !self.is_in_vectors();
        self.says_along(studied, member) || is_oblique && !says_across(self.clause(studied, member)) && is_used_along()
    }

    fn says_along(&self, studied: &Studied, member: &Member) -> bool {
        match self.prepared.setting {
            Setting::Wall => says_into_wall(self.clause(studied, member)),
            _ => says_along(self.clause(studied, member)),
        }
    }

    /// The part of a line in which a value stands; all of it where that cannot be told.
    pub(super) fn clause<'s>(&self, studied: &'s Studied, member: &Member) -> &'s str {
        let whole: &str = &studied.line.typed;
        let Some(reading) = &studied.reading else { return whole };
        let clauses = clauses(whole);
        // `parallel 8, perp 6` may be one list of two values.
        let place_in = |clauses: &[&str]| match clauses.len() {
            all if all == reading.statements.len() => Some(member.statement),
            all if all == reading.members.len() => reading.members.iter().position(|own| std::ptr::eq(own, member)),
            _ => None,
        };
        // `parallel 8 perp 6` has no sign between them.
        let by_words = || clauses_by_words(whole);
        let clause_in = |clauses: &[&'s str]| place_in(clauses).map(|place| clauses[place]);
        clause_in(&clauses).or_else(|| clause_in(&by_words())).unwrap_or(whole)
    }

    /// Is it in words that a number is perpendicular to the line of centres? At a wall that is the component along the wall.
    pub(super) fn says_across(&self, typed: &str) -> bool {
        let typed = typed.to_lowercase();
        match self.prepared.setting {
            Setting::Wall => {
                let is_short = |word: &str| matches!(word, "par" | "para");
                typed.contains("parallel")
                    || typed.contains("along the wall")
                    || typed.contains("along wall")
                    || typed.split(|sign: char| !sign.is_alphabetic()).any(is_short)
            }
            _ => typed.contains("perp") || typed.contains('⊥'),
        }
    }

    /// Is it a vector with this component, and not the one that was given? Along i or j it keeps its sign.
    pub(in crate::mark::working) fn has_component(&self, values: &[Value], sphere: Sphere, right: &[f64]) -> bool {
        let known = |quantity| sizes(&self.prepared.known, quantity);
        let before = |axis| known(Quantity::Velocity(sphere, Moment::Before, axis));
        // Components of a speed that is given with an angle have been found.
        let in_vectors = has_vectors(self.question);
        let given = before(Axis::X).zip(before(Axis::Y)).filter(|_| in_vectors);
        let is_given = given.is_some_and(|(x, y)| is_vector(values, &x, &y, 1.0));
        let is_along =
            |axis| known(Quantity::Line(axis)).is_some_and(|line| line.iter().all(|size| size.abs() > 1.0 - 1e-9));
        let across = if is_along(Axis::X) { Some(Axis::Y) } else { Some(Axis::X).filter(|_| is_along(Axis::Y)) };
        let signed = across.filter(|_| in_vectors).and_then(|axis| Some((axis, before(axis)?)));
        let is_one = |(point, value): (usize, &Value)| match (value, &signed) {
            (Value::Vector(_, y), Some((Axis::Y, own))) => y.may_be(own[point]),
            (Value::Vector(x, _), Some((_, own))) => x.may_be(own[point]),
            // Along a slanting line neither i nor j has it.
            (Value::Vector(x, y), None) if !in_vectors => {
                [x, y].into_iter().any(|one| one.absolute().may_be(right[point].abs()))
            }
            (Value::Vector(..), None) => false,
            (Value::Number(_), _) => false,
        };
        !is_given && values.iter().enumerate().all(is_one)
    }
}

/// Is it a rounded value of which the last nought was left out: 4.5 for 4.4995?
fn is_without_last_nought(value: Value, right: f64) -> bool {
    /// How far it is off then, in parts of itself.
    const MOST: f64 = 0.0005;
    matches!(value, Value::Number(own) if (own.middle().abs() - right.abs()).abs() <= MOST * right.abs())
}
