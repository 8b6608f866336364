//! Kinetic energies known by the shape of their formula, and the slips that show in it.

use super::change_of_momentum::two;
use super::values::names_loss;
use crate::bank::Code;
use crate::expr::Expr;
use crate::mark::working::evidence::Evidence;
use crate::mark::working::examine::{Studied, Working};
use crate::mark::working::lines::Member;
use crate::mark::working::numbers::{any_within, sizes};
use crate::mark::working::theirs::numbers;
use crate::mechanics::{Axis, Law, Moment, Quantity, Setting, Shape, Sphere};

/// All the energy before an impact and all that after it, where no line takes one from the other.
pub(crate) struct ToBeSubtracted {
    /// Of what was made of them, at every point.
    pub(in crate::mark::working) difference: Vec<f64>,
    /// Are both right, and not only what follows from the student's own values?
    pub(in crate::mark::working) is_right: bool,
}

impl Working<'_> {
    /// All the energy before the impact less a number for that after it, in either order: the number may be a slip of the
    /// calculator, and is not the energy of one sphere, nor of the motion along the line of centres alone.
    pub(super) fn is_difference_of_totals(&self, expr: &Expr) -> bool {
        let Expr::Sum(terms) = expr else { return false };
        let (taken, counted): (Vec<&Expr>, Vec<&Expr>) =
            terms.iter().partition(|term| matches!(term, Expr::Negative(_)));
        let total = |terms: Vec<&Expr>| Expr::Sum(terms.into_iter().cloned().collect());
        if taken.is_empty() || counted.is_empty() {
            return false;
        }
        let before: Vec<Vec<f64>> =
            sizes(&self.prepared.known, Quantity::TotalEnergy(Moment::Before)).into_iter().collect();
        let partial = self.partial_energies();
        let is_before = |expr: &Expr| self.is_one_of(expr, &before);
        let is_after = |expr: &Expr| self.values_of(expr).is_some() && !self.is_one_of(expr, &partial);
        let (taken, counted) = (total(taken), total(counted));
        (is_before(&taken) && is_after(&counted)) || (is_before(&counted) && is_after(&taken))
    }

    /// The energies before the impact less those after it, where squares are worked out, as in `½ × 4(49 - 6.5²)`: some
    /// two of its numbers, or squares, stand for the squares of the speeds after. What else there is must then be what each
    /// sphere had before, and each of the two must count with half the mass of its sphere.
    pub(super) fn is_difference_of_worked_out(&self, expr: &Expr) -> bool {
        let known = |quantity| sizes(&self.prepared.known, quantity);
        let of_both = |quantity: fn(Sphere) -> Quantity| -> Option<[Vec<f64>; 2]> {
            Some([known(quantity(Sphere::A))?, known(quantity(Sphere::B))?])
        };
        let mut squares = Vec::new();
        collect_squares(expr, &mut squares);
        squares.dedup();
        let Some([mass_a, mass_b]) = of_both(Quantity::Mass).filter(|_| squares.len() <= MOST_SQUARES) else {
            return false;
        };
        let speeds = of_both(|sphere| Quantity::Speed(sphere, Moment::Before));
        let along = of_both(|sphere| Quantity::Velocity(sphere, Moment::Before, Axis::N));
        let energy = |mass: &f64, speed: &f64| mass * speed * speed / 2.0;
        let totals = [speeds, along].into_iter().flatten().flat_map(|[a, b]| {
            let both = mass_a.iter().zip(&a).zip(mass_b.iter().zip(&b));
            let total: Vec<f64> = both.map(|((m, u), (n, w))| energy(m, u) + energy(n, w)).collect();
            let negative = total.iter().map(|total| -total).collect();
            [total, negative]
        });
        let totals: Vec<Vec<f64>> = totals.collect();
        let number = |expr: &Expr| numbers(&self.values_of(expr)?);
        let same = |one: &f64, other: &f64| (one - other).abs() <= 1e-9 * other.abs().max(1.0);
        // What is there without one square is what was there before, less half the mass times the other.
        let leaves = |gone: &Expr, total: &[f64], mass: &[f64], other: &Expr| {
            let (Some(left), Some(square)) = (number(&without(expr, &[gone])), number(other)) else { return false };
            let mut each = left.iter().zip(total).zip(mass.iter().zip(&square));
            each.all(|((left, total), (mass, square))| {
                *square > 0.0 && same(left, &(total - total.signum() * mass * square / 2.0))
            })
        };
        squares.iter().any(|of_a| {
            squares.iter().filter(|of_b| *of_b != of_a).any(|of_b| {
                let Some(rest) = number(&without(expr, &[of_a, of_b])) else { return false };
                let is_total = |total: &&Vec<f64>| rest.iter().zip(*total).all(|(one, other)| same(one, other));
                totals
                    .iter()
                    .filter(is_total)
                    .any(|total| leaves(of_b, total, &mass_a, of_a) && leaves(of_a, total, &mass_b, of_b))
            })
        })
    }

    /// `½ × 3(6.6² - 4.4²)` at a wall where e is 2/3: half the mass times the square of a component of the student's own, less the
    /// same with e times it.
    pub(super) fn is_loss_of_own_at_wall(&self, expr: &Expr) -> bool {
        let known = |quantity| sizes(&self.prepared.known, quantity);
        let mut squares = Vec::new();
        collect_squares(expr, &mut squares);
        let is_wall = self.prepared.setting == Setting::Wall && squares.len() <= MOST_SQUARES;
        let Some((mass, e)) = known(Quantity::Mass(Sphere::A)).zip(known(Quantity::Restitution)).filter(|_| is_wall)
        else {
            return false;
        };
        let number = |expr: &Expr| numbers(&self.values_of(expr)?);
        let near = |one: f64, other: f64| (one - other).abs() <= 0.005 * other.abs();
        squares.iter().any(|after| {
            squares.iter().filter(|before| *before != after).any(|before| {
                let (Some(rest), Some(first), Some(second)) =
                    (number(&without(expr, &[after])), number(before), number(after))
                else {
                    return false;
                };
                let all = number(&without(expr, &[before, after]));
                all.is_some_and(|all| all.iter().all(|left| left.abs() < 1e-9))
                    && (0..mass.len()).all(|at| {
                        near(rest[at].abs(), mass[at] * first[at] / 2.0) && near(second[at], e[at] * e[at] * first[at])
                    })
            })
        })
    }

    /// A line with the square of a sum that no velocity is, where energies are looked for and none stands rightly.
    pub(super) fn squared_wrongly(&self, law: Law, shape: Shape) -> Option<Evidence> {
        if shape != Shape::DifferenceOfSquares {
            return None;
        }
        let wrong = |studied: &Studied| {
            let mut members = studied.reading.iter().flat_map(|reading| &reading.members);
            members.find_map(|member| self.wrong_square(member))
        };
        let (line, tag) = self.lines.iter().enumerate().find_map(|(place, studied)| Some((place, wrong(studied)?)))?;
        let is_right_elsewhere = self.by_shape(law, shape, None, Code::M1).is_some();
        let slip = law.slips().iter().find(|slip| slip.tag == tag).filter(|_| !is_right_elsewhere)?;
        let (note, feedback) = (Some(slip.tag), slip.sentence.to_owned());
        Some(Evidence { given: false, note, feedback, ..Evidence::given(line, law.name()) })
    }

    /// `½m(v - u)²`, or `½m(3 - 1)²` for a velocity of 3i - j: which slip it is. The square of the speed of approach is no
    /// slip, nor is that of anything that comes to a component or a speed, unless it alone is called what is lost.
    fn wrong_square(&self, member: &Member) -> Option<&'static str> {
        let mut bases = Vec::new();
        collect_bases(&member.expr, &mut bases);
        let is_loss = bases.len() == 1 && member.label.as_deref().is_some_and(names_loss);
        let sums = bases.iter().filter(|base| two(base).is_some());
        sums.clone().next()?;
        let known = |quantity| sizes(&self.prepared.known, quantity).into_iter();
        let own = |quantity| self.theirs.values.get(&quantity).map(|(values, _)| values.clone()).into_iter();
        let either = |quantity| known(quantity).chain(own(quantity));
        let components = |sphere, moment| -> Vec<Vec<f64>> {
            let axes = [Axis::N, Axis::T, Axis::X, Axis::Y].into_iter();
            axes.flat_map(|axis| either(Quantity::Velocity(sphere, moment, axis))).collect()
        };
        let moments = [Moment::Before, Moment::After];
        let velocities = Sphere::BOTH.into_iter().flat_map(|sphere| moments.map(|moment| (sphere, moment)));
        let velocities = velocities.flat_map(|(sphere, moment)| {
            components(sphere, moment).into_iter().chain(either(Quantity::Speed(sphere, moment)))
        });
        let velocities: Vec<Vec<f64>> = velocities.collect();
        if bases.iter().any(|base| self.is_approach(base)) {
            return None;
        }
        // At a wall nobody takes one velocity from another for a third.
        let is_wall = self.prepared.setting == Setting::Wall;
        let sums = sums.filter(|base| is_loss || is_wall || !self.is_one_of(base, &velocities));
        let sums: Vec<(&Expr, [&Expr; 2])> = sums.filter_map(|base| Some((*base, two(base)?))).collect();
        let is_of = |term: &Expr, sphere, moment| self.is_one_of(term, &components(sphere, moment));
        let is_change = |[one, other]: [&Expr; 2]| {
            Sphere::BOTH.into_iter().any(|sphere| {
                let speed = |moment| either(Quantity::Speed(sphere, moment)).collect::<Vec<_>>();
                let is_speed = |term: &Expr, moment| self.is_one_of(term, &speed(moment));
                is_of(one, sphere, Moment::Before) && is_of(other, sphere, Moment::After)
                    || is_speed(one, Moment::Before) && is_speed(other, Moment::After)
            })
        };
        let is_of_both = |[one, other]: [&Expr; 2]| is_change([one, other]) || is_change([other, one]);
        let is_velocity = |[one, other]: &[&Expr; 2]| {
            let mut states = Sphere::BOTH.into_iter().flat_map(|sphere| moments.map(|moment| (sphere, moment)));
            states.any(|(sphere, moment)| is_of(one, sphere, moment) && is_of(other, sphere, moment))
        };
        // 3 - 2 may be of one velocity and of two: where every square is that of a change, it is.
        let changes: Vec<Vec<f64>> = self.changes_of_components(&either);
        let are_changes = sums.iter().all(|(base, _)| self.is_one_of(base, &changes));
        match !are_changes && sums.iter().any(|(_, terms)| is_velocity(terms)) {
            true => Some("energy-components-added"),
            false => sums.iter().any(|(_, terms)| is_of_both(*terms)).then_some("energy-square-of-difference"),
        }
    }

    /// By how much the components of either sphere change, with these sizes.
    fn changes_of_components<S: Iterator<Item = Vec<f64>>>(&self, sizes: &dyn Fn(Quantity) -> S) -> Vec<Vec<f64>> {
        let both =
            Sphere::BOTH.into_iter().flat_map(|sphere| [Axis::N, Axis::T, Axis::X, Axis::Y].map(|axis| (sphere, axis)));
        let changes = both.flat_map(|(sphere, axis)| {
            let of = |moment| sizes(Quantity::Velocity(sphere, moment, axis)).collect::<Vec<_>>();
            let (before, after) = (of(Moment::Before), of(Moment::After));
            let change = |one: &Vec<f64>, other: &Vec<f64>| one.iter().zip(other).map(|(a, b)| a - b).collect();
            before.iter().flat_map(|one| after.iter().map(move |other| change(one, other))).collect::<Vec<Vec<f64>>>()
        });
        changes.collect()
    }

    fn is_approach(&self, base: &Expr) -> bool {
        let along = |sphere| sizes(&self.prepared.known, Quantity::Velocity(sphere, Moment::Before, Axis::N));
        let (Some(a), Some(b)) = (along(Sphere::A), along(Sphere::B)) else { return false };
        self.is_one_of(base, &[a.iter().zip(b).map(|(a, b)| a - b).collect()])
    }

    /// All the energy before the impact and all that after it, each right on a line of its own, and then a loss: whatever
    /// the calculator made of them.
    pub(super) fn energies_apart(&self, law: Law, code: Code) -> Option<Evidence> {
        let [before, after] = self.totals(law, code)?;
        let speaks_of_loss = |studied: &Studied| {
            let typed = studied.line.typed.to_lowercase();
            ["los", "change", "before - after", "before − after"].iter().any(|word| typed.contains(word))
        };
        let last = before.max(after);
        let takes_off = |expr: &Expr| matches!(expr, Expr::Sum(terms) if terms.iter().any(|term| matches!(term, Expr::Negative(_))));
        // `T1 - T2 = 70` says it before the sign.
        let is_called_difference = |member: &Member| {
            member.label.as_ref().is_some_and(|label| label.contains(['-', '−']) && label.contains(char::is_alphabetic))
        };
        let subtracts = |studied: &Studied| {
            let mut members = studied.reading.iter().flat_map(|reading| &reading.members);
            members.any(|member| takes_off(&member.expr) || is_called_difference(member)) || speaks_of_loss(studied)
        };
        // All of it may stand on one line.
        let first = if before == after { last } else { last + 1 };
        let line = self.lines.iter().skip(first).position(subtracts)?;
        Some(Evidence::given(first + line, law.name()))
    }

    /// The lines of all the energy before the impact and of all that after it, where the part asks for the loss.
    fn totals(&self, law: Law, code: Code) -> Option<[usize; 2]> {
        let mut asked = self.part.blanks.iter().flat_map(|blank| blank.find.quantities());
        if !law.gives(Quantity::EnergyLost) || !asked.any(|find| find == Quantity::EnergyLost) {
            return None;
        }
        let total = |known, moment| self.line_that_is(known, Quantity::TotalEnergy(moment));
        let follows = !code.is_accuracy() || code == Code::A1FollowThrough;
        let own = || if follows { total(&self.followed, Moment::After) } else { None };
        let before = total(&self.prepared.known, Moment::Before)?;
        let after = total(&self.prepared.known, Moment::After).or_else(own)?;
        let energies =
            [Moment::Before, Moment::After].map(|moment| sizes(&self.prepared.known, Quantity::TotalEnergy(moment)));
        // Where nothing is lost, one number is both.
        (before != after || energies[0] != energies[1]).then_some([before, after])
    }

    /// Both energies, of which the answer alone may be the difference.
    pub(in crate::mark::working) fn to_be_subtracted(&self) -> Option<ToBeSubtracted> {
        let law = *Law::ALL.iter().find(|law| law.gives(Quantity::EnergyLost))?;
        let totals = self.totals(law, Code::M1).filter(|[before, after]| before != after)?;
        let worked_out = |place: usize| {
            let (_, values) = self.members(&self.lines[place]).last()?;
            numbers(values)
        };
        let [before, after] = totals.map(worked_out);
        let difference = before?.iter().zip(after?).map(|(before, after)| before - after).collect();
        Some(ToBeSubtracted { difference, is_right: self.totals(law, Code::A1).is_some() })
    }

    /// What students take for the energy after the impact and is part of it only.
    fn partial_energies(&self) -> Vec<Vec<f64>> {
        let mut all = Vec::new();
        for known in [&self.prepared.known, &self.followed] {
            let each = |sphere| sizes(known, Quantity::KineticEnergy(sphere, Moment::After));
            let along = |sphere| {
                let velocities = sizes(known, Quantity::Velocity(sphere, Moment::After, Axis::N))?;
                let masses = sizes(known, Quantity::Mass(sphere))?;
                Some(velocities.iter().zip(masses).map(|(v, mass)| mass * v * v / 2.0).collect::<Vec<f64>>())
            };
            // Where there is one sphere alone, its energy is all there is.
            let both = Sphere::BOTH.map(each);
            if let [Some(_), Some(_)] = both {
                all.extend(both.into_iter().flatten());
            }
            let parts: Vec<Vec<f64>> = Sphere::BOTH.into_iter().filter_map(along).collect();
            if let Some(first) = parts.first() {
                let sum: Vec<f64> = (0..first.len()).map(|at| parts.iter().map(|part| part[at]).sum()).collect();
                let is_all = sizes(known, Quantity::TotalEnergy(Moment::After))
                    .is_some_and(|total| total.iter().zip(&sum).all(|(one, other)| (one - other).abs() < 1e-9 * one));
                all.extend((!is_all).then_some(sum));
            }
        }
        all.retain(|sizes| sizes.iter().any(|size| *size > 1e-9));
        all
    }

    /// Are there squares of what each sphere that was moving had before the impact: its speed, its component along the
    /// line of centres, or both components in i and j?
    pub(super) fn has_both_spheres(&self, expr: &Expr) -> bool {
        let is_squared = |quantity: Quantity| {
            let Some(right) = sizes(&self.prepared.known, quantity) else { return false };
            let is_nought = right.iter().all(|size| size.abs() < 1e-9);
            let is_base = |inner: &Expr| match inner {
                Expr::Power(base, exponent) if **exponent == Expr::integer(2) => {
                    self.is_one_of(base, std::slice::from_ref(&right))
                }
                _ => false,
            };
            is_nought || any_within(expr, &is_base)
        };
        let component = |sphere, axis| is_squared(Quantity::Velocity(sphere, Moment::Before, axis));
        Sphere::BOTH.into_iter().all(|sphere| {
            let along = !self.is_in_vectors() && (component(sphere, Axis::N) || component(sphere, Axis::T));
            let both = self.is_in_vectors() && component(sphere, Axis::X) && component(sphere, Axis::Y);
            is_squared(Quantity::Speed(sphere, Moment::Before)) || along || both
        })
    }
}

/// A difference of kinetic energies: squares of velocities added and subtracted, none of them of a difference. Squares that
/// multiply a sum of others, as in `(1 - e²)(½m u² + ½m w²)`, are not added to them.
pub(super) fn is_energy_difference(expr: &Expr) -> bool {
    let mut signs = [0, 0];
    count_squares(expr, false, &mut signs);
    signs[0] >= 1 && signs[1] >= 1 && signs[0] + signs[1] >= 4
}

/// Formulas of energies have no more numbers than that.
const MOST_SQUARES: usize = 12;

/// What may be the square of a speed: powers of two, and numbers that are in none.
fn collect_squares<'e>(expr: &'e Expr, squares: &mut Vec<&'e Expr>) {
    match expr {
        Expr::Power(_, exponent) if **exponent == Expr::integer(2) => squares.push(expr),
        Expr::Number(_) | Expr::Decimal(_) => squares.push(expr),
        _ => expr.children().into_iter().for_each(|child| collect_squares(child, squares)),
    }
}

/// With nought in place of these.
fn without(expr: &Expr, gone: &[&Expr]) -> Expr {
    match gone.contains(&expr) {
        true => Expr::integer(0),
        false => expr.map_children(&mut |child| without(child, gone)),
    }
}

/// Of everything that is squared in a formula.
fn collect_bases<'e>(expr: &'e Expr, bases: &mut Vec<&'e Expr>) {
    if let Expr::Power(base, exponent) = expr
        && **exponent == Expr::integer(2)
    {
        bases.push(base);
    }
    expr.children().into_iter().for_each(|child| collect_bases(child, bases));
}

fn count_squares(expr: &Expr, negative: bool, signs: &mut [usize; 2]) {
    match expr {
        Expr::Power(_, exponent) if **exponent == Expr::integer(2) => signs[usize::from(negative)] += 1,
        Expr::Negative(inner) => count_squares(inner, !negative, signs),
        Expr::Product(factors) if is_multiplied_by_squares(factors) => {}
        _ => expr.children().into_iter().for_each(|child| count_squares(child, negative, signs)),
    }
}

/// Is one of the factors a sum with squares in it, and are there squares in another?
fn is_multiplied_by_squares(factors: &[Expr]) -> bool {
    let is_square = |expr: &Expr| matches!(expr, Expr::Power(_, exponent) if **exponent == Expr::integer(2));
    let with_squares: Vec<&Expr> = factors.iter().filter(|factor| any_within(factor, &is_square)).collect();
    with_squares.len() > 1 && with_squares.iter().any(|factor| matches!(factor, Expr::Sum(_)))
}
