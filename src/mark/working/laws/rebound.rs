//! What a wall does to a sphere: restitution gives the one component after it at once, and all that follows from that.

use super::shapes::{components_in, is_tangent};
use crate::answer::Kind;
use crate::bank::Code;
use crate::expr::{Expr, Function};
use crate::mark::judging::may_be_named;
use crate::mark::working::equations::Departure;
use crate::mark::working::evidence::Evidence;
use crate::mark::working::examine::{Studied, Value, Working};
use crate::mark::working::lines::{Member, says_into_wall};
use crate::mark::working::numbers::{comes_to, is_vector, sizes};
use crate::mechanics::{Axis, Datum, Known, Law, Moment, Quantity, Setting, Sphere};

impl Working<'_> {
    /// Restitution at a wall gives the one component after at once. A method mark condones sine for cosine.
    pub(super) fn rebound(&self, code: Code) -> Option<Evidence> {
        if self.prepared.setting != Setting::Wall {
            return None;
        }
        let after = Quantity::Velocity(Sphere::A, Moment::After, Axis::N);
        let is_nought = |quantity| {
            sizes(&self.prepared.known, quantity).is_none_or(|sizes| sizes.iter().all(|size| size.abs() < 1e-9))
        };
        // From a velocity of nought there is nothing to find.
        if is_nought(after) {
            return None;
        }
        // The tangent after the impact has the component in it.
        let is_shown = self.part.blanks.iter().any(|blank| blank.model.kind == Kind::Shown);
        let angle = Quantity::AngleToLine(Sphere::A, Moment::After);
        let speaks = |line: &usize| self.speaks_of_angle(&self.lines[*line]);
        let by_tangent = || {
            self.line_that_is(&self.prepared.known, angle).filter(|line| !is_shown && !is_nought(angle) && speaks(line))
        };
        let right = self.line_that_is(&self.prepared.known, after).or_else(by_tangent);
        let right = right.or_else(|| self.inequality_with(&sizes(&self.prepared.known, after)?));
        let right = right.or_else(|| self.rebound_as_vector()).or_else(|| self.rebound_along_axis());
        let right = right.or_else(|| self.rebound_in_axes(code)).or_else(|| self.said_to_rebound(after, code));
        let right = right.or_else(|| self.rebound_in_tangent()).or_else(|| self.tangent_by_e());
        let right = right.or_else(|| self.by_unknown_components(Axis::N, code));
        let by_method = || self.exchanged(after, code).or_else(|| self.rebound_of_own());
        // Along i or j the components are there already.
        let is_resolved = || self.lies_along_axis().then(|| self.rebound_of_all()).flatten();
        let found = right.or_else(|| if code.is_accuracy() { None } else { by_method().or_else(is_resolved) });
        // From the result itself nothing has been found.
        if let Some(line) = found.filter(|line| *line <= self.end_of_finding()) {
            return Some(Evidence::given(line, "restitution"));
        }
        if let Some(wrong) = self.rebound_on_wrong_side() {
            return Some(wrong);
        }
        let unresolved = Departure::Unresolved;
        let (note, feedback) = (Some(unresolved.tag()), unresolved.sentence().to_owned());
        Some(Evidence { given: false, note, feedback, ..Evidence::given(self.rebound_of_all()?, "restitution") })
    }

    /// Does the line of centres lie along i or j?
    fn lies_along_axis(&self) -> bool {
        let lies =
            |axis| sizes(&self.prepared.known, Quantity::Line(axis)).is_some_and(|line| line[0].abs() > 1.0 - 1e-9);
        lies(Axis::X) || lies(Axis::Y)
    }

    /// A value that is said to be that of the rebound, and is: `rebound 4.67`; or the two components listed, `after: 5 and -2`.
    pub(super) fn said_to_rebound(&self, after: Quantity, code: Code) -> Option<usize> {
        let right = sizes(&self.prepared.known, after)?;
        let is_right = |values: &[Value]| values.iter().zip(&right).all(|(value, right)| comes_to(*value, *right));
        self.lines.iter().position(|studied| {
            let typed = studied.line.typed.to_lowercase();
            let says = ["rebound", "bounces", "comes off"].iter().any(|word| typed.contains(word));
            let says_of = |member: &Member| {
                !code.is_accuracy() && typed.contains("after") && says_into_wall(self.clause(studied, member))
            };
            let mut members = self.members(studied).filter(|(member, _)| member.label.is_none());
            members.any(|(member, values)| (says || says_of(member)) && is_right(values))
                || typed.contains("after") && self.lists_both_components(studied, &right)
        })
    }

    /// Are the component away from the wall and the one along it all the values of a line, and not of one size?
    fn lists_both_components(&self, studied: &Studied, away: &[f64]) -> bool {
        let after = Quantity::Velocity(Sphere::A, Moment::After, Axis::T);
        let Some(along) = sizes(&self.prepared.known, after) else { return false };
        let is = |values: &[Value], right: &[f64]| {
            values.iter().zip(right).all(|(value, right)| *right != 0.0 && comes_to(*value, *right))
        };
        let is_alike = away.iter().zip(&along).any(|(one, other)| (one.abs() - other.abs()).abs() < 1e-9);
        match self.members(studied).collect::<Vec<_>>().as_slice() {
            [(_, one), (_, other)] if !is_alike => {
                is(one, away) && is(other, &along) || is(one, &along) && is(other, away)
            }
            _ => false,
        }
    }

    /// The component after the impact within a tangent, above the line or below it: `tan β = eu sin α/(u cos α)`.
    fn rebound_in_tangent(&self) -> Option<usize> {
        let velocity = |moment, axis| sizes(&self.prepared.known, Quantity::Velocity(Sphere::A, moment, axis));
        let after = velocity(Moment::After, Axis::N)?;
        let is_after =
            |other: &Vec<f64>| other.iter().zip(&after).all(|(one, after)| (one.abs() - after.abs()).abs() < 1e-9);
        let mut before = [Axis::N, Axis::T].into_iter().filter_map(|axis| velocity(Moment::Before, axis));
        // Of two that are alike nobody can tell which is meant.
        if before.any(|component| is_after(&component)) {
            return None;
        }
        let after = [after];
        self.lines.iter().position(|studied| {
            self.members(studied).any(|(member, _)| {
                let components = components_in(&member.expr, is_tangent(member));
                components.iter().any(|component| self.is_one_of(component, &after))
            })
        })
    }

    /// *e* times the tangent of the angle at which a second wall is hit, `tan γ = ½ × 3/tan α`, where a result is to be shown: at
    /// the first that would be the result itself.
    pub(super) fn tangent_by_e(&self) -> Option<usize> {
        let before = |axis| sizes(&self.prepared.known, Quantity::Velocity(Sphere::A, Moment::Before, axis));
        let is_shown = self.part.blanks.iter().any(|blank| blank.model.kind == Kind::Shown);
        let is_open = self.prepared.setting == Setting::Wall && is_shown && self.part.meeting.number > 0;
        let (into, along) = before(Axis::N).zip(before(Axis::T)).filter(|_| is_open)?;
        let tangent: Vec<f64> = into.iter().zip(&along).map(|(into, along)| (into / along).abs()).collect();
        if tangent.iter().any(|size| !size.is_normal()) {
            return None;
        }
        self.lines.iter().position(|studied| {
            let mut members = studied.reading.iter().flat_map(|reading| &reading.members);
            let is_it = |expr: &Expr| {
                let known = self.with_tangents_asked(expr);
                // `f/tan β` has two factors, and the result itself, `f/(e tan α)`, no more than one.
                let apart = match &known {
                    Expr::Quotient(above, below) if known != *expr => {
                        Expr::product([(**above).clone(), Expr::integer(1).over((**below).clone())])
                    }
                    other => other.clone(),
                };
                self.is_e_times(&apart, &tangent)
            };
            self.speaks_of_angle(studied) && members.any(|member| is_it(&member.expr))
        })
    }

    /// The component after the impact by its unit vector, `2j` for `½ × 4` along j.
    fn rebound_along_axis(&self) -> Option<usize> {
        let known = |quantity| sizes(&self.prepared.known, quantity);
        let after = known(Quantity::Velocity(Sphere::A, Moment::After, Axis::N))?;
        let along = |axis| -> Option<Vec<f64>> {
            Some(known(Quantity::Line(axis))?.iter().zip(&after).map(|(line, after)| line * after).collect())
        };
        let (x, y) = (along(Axis::X)?, along(Axis::Y)?);
        self.lines.iter().position(|studied| self.members(studied).any(|(_, values)| is_vector(values, &x, &y, 1.0)))
    }

    /// The velocity after the impact by both components, `-3i + 0.6(6)j`, where the wall lies along an axis. A method mark
    /// condones the sign of the one that restitution gives.
    fn rebound_in_axes(&self, code: Code) -> Option<usize> {
        let sizes = |quantity| sizes(&self.prepared.known, quantity);
        let lies = |axis| sizes(Quantity::Line(axis)).is_some_and(|line| line[0].abs() > 1.0 - 1e-9);
        let line = [Axis::X, Axis::Y].into_iter().find(|axis| lies(*axis))?;
        let velocity = |moment, axis| sizes(Quantity::Velocity(Sphere::A, moment, axis));
        let (before, after) = (velocity(Moment::Before, line)?, velocity(Moment::After, line)?);
        // Where e is 1 the size is the one that was given.
        if before.iter().zip(&after).all(|(before, after)| (before.abs() - after.abs()).abs() < 1e-9) {
            return None;
        }
        let is_it = |values: &[Value]| {
            let is = |sign: f64| {
                let along: Vec<f64> = after.iter().map(|size| sign * size).collect();
                let of = |axis| if axis == line { Some(along.clone()) } else { velocity(Moment::After, axis) };
                of(Axis::X).zip(of(Axis::Y)).is_some_and(|(x, y)| is_vector(values, &x, &y, 1.0))
            };
            is(1.0) || !code.is_accuracy() && is(-1.0)
        };
        let quantity = Quantity::Velocity(Sphere::A, Moment::After, Axis::N);
        let is_else = |member: &Member| member.label.as_ref().is_some_and(|label| !may_be_named(label, quantity));
        self.lines
            .iter()
            .position(|studied| self.members(studied).any(|(member, values)| is_it(values) && !is_else(member)))
    }

    /// The impulse of a wall, or the energy lost there, from the component that stays: a method mark condones sine for
    /// cosine.
    pub(super) fn with_sine_for_cosine(&self, law: Law, code: Code) -> Option<Evidence> {
        let mut quantities = [Quantity::EnergyLost, Quantity::ImpulseMagnitude].into_iter();
        let line = self.exchanged(quantities.find(|quantity| law.gives(*quantity))?, code)?;
        Some(Evidence::given(line, law.name()))
    }

    /// The line that comes to what a wall would do with sine for cosine: for the components that are there, or for those
    /// that are written.
    fn exchanged(&self, quantity: Quantity, code: Code) -> Option<usize> {
        // Components that are given are no sine and cosine.
        if code.is_accuracy() || self.prepared.setting != Setting::Wall || self.prepared.in_components {
            return None;
        }
        self.by_component_across(quantity).or_else(|| self.with_functions_exchanged(quantity))
    }

    /// At a second wall both components have a factor of their own: there it is the formula in which they are exchanged.
    fn with_functions_exchanged(&self, quantity: Quantity) -> Option<usize> {
        let right = [sizes(&self.prepared.known, quantity)?];
        let is_exchanged = |member: &Member| {
            let exchanged = exchanged(&member.expr);
            exchanged != member.expr && self.is_one_of(&exchanged, &right)
        };
        self.lines.iter().position(|studied| {
            studied.matched.is_empty()
                && self.members(studied).any(|(member, _)| {
                    let is_else = |label: &String| !may_be_named(label, quantity);
                    (self.is_called(member) || self.is_worked_out(&member.expr))
                        && !member.label.as_ref().is_some_and(is_else)
                        && is_exchanged(member)
                        && !self.says_across(self.clause(studied, member))
                })
        })
    }

    fn by_component_across(&self, quantity: Quantity) -> Option<usize> {
        let swapped = self.prepared.known.iter().map(|known| {
            let across = known.number(Quantity::Velocity(Sphere::A, Moment::Before, Axis::T))?;
            let (e, mass) = (known.number(Quantity::Restitution)?, known.number(Quantity::Mass(Sphere::A)));
            let number = match quantity {
                Quantity::EnergyLost => mass? * across * across * (1.0 - e * e) / 2.0,
                Quantity::ImpulseMagnitude => mass? * across * (1.0 + e),
                _ => e * across,
            };
            let mut swapped = known.clone();
            swapped.0.insert(quantity, Datum::Number(number));
            (across != 0.0).then_some(swapped)
        });
        let swapped: Vec<Known<f64>> = swapped.collect::<Option<_>>()?;
        let sizes = [sizes(&swapped, quantity)?];
        // What is said to be along the wall was not taken for the other.
        let is_other = |studied: &Studied| {
            let mut members = self.members(studied).filter(|(member, _)| self.is_one_of(&member.expr, &sizes));
            members.any(|(member, _)| !self.says_across(self.clause(studied, member)))
        };
        self.line_that_is(&swapped, quantity).filter(|line| is_other(&self.lines[*line]))
    }

    /// The line of a vector with both components after an impact with a wall, whichever way the student's axes along the
    /// wall and across it point. Where the question has axes, they are those of the student.
    pub(super) fn rebound_as_vector(&self) -> Option<usize> {
        if self.prepared.in_components {
            return None;
        }
        let after = |axis| sizes(&self.prepared.known, Quantity::Velocity(Sphere::A, Moment::After, axis));
        let [along, across] = [after(Axis::N)?, after(Axis::T)?];
        let turned: Vec<f64> = across.iter().map(|across| -across).collect();
        let is_it = |values: &[Value]| {
            [1.0, -1.0].into_iter().any(|sign| {
                let is = |x: &[f64], y: &[f64]| is_vector(values, x, y, sign);
                [&across, &turned].into_iter().any(|across| is(&along, across) || is(across, &along))
            })
        };
        self.lines.iter().position(|studied| self.members(studied).any(|(_, values)| is_it(values)))
    }
}

/// The formula with sine for cosine and cosine for sine.
fn exchanged(expr: &Expr) -> Expr {
    match expr {
        Expr::Call(Function::Sin, angle) => Expr::Call(Function::Cos, angle.clone()),
        Expr::Call(Function::Cos, angle) => Expr::Call(Function::Sin, angle.clone()),
        other => other.map_children(&mut exchanged),
    }
}
