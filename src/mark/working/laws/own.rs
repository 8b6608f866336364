//! Methods that are seen where a student goes on from a wrong value, though nothing of what the law gives is right.

use super::impulse::is_worked;
use super::shapes::two_squares;
use crate::bank::Code;
use crate::expr::{Expr, Function};
use crate::mark::judging::may_be_named;
use crate::mark::working::evidence::Evidence;
use crate::mark::working::examine::{Studied, Value, Working};
use crate::mark::working::numbers::{any_within, comes_to, is_vector, sizes};
use crate::mark::working::theirs::unknown_sphere;
use crate::mechanics::{Axis, Law, Moment, Quantity, Seen, Setting, Shape, Sphere};

impl Working<'_> {
    /// A method mark for a law used with a value of the student's own.
    pub(in crate::mark::working) fn by_own(&self, law: Law, code: Code) -> Option<Evidence> {
        if code.is_accuracy() {
            return None;
        }
        match law.seen() {
            Seen::Value(_, Shape::ChangeOfMomentum) | Seen::AlongLine if self.is_in_vectors() => {
                self.impulse_of_own(law)
            }
            Seen::Value(_, Shape::ChangeOfMomentum) => self.impulse_along(law),
            Seen::Value(_, Shape::DifferenceOfSquares) => self.energy_of_one(law),
            Seen::Value(_, Shape::Pythagoras) => {
                self.speed_of_earlier_vector(law).or_else(|| self.speed_of_own_vector(law))
            }
            _ => None,
        }
    }

    /// Pythagoras with both components of the vector that the student has found in an earlier part for a particle: `√(25 + 4)`
    /// after `5i - 2j`.
    fn speed_of_earlier_vector(&self, law: Law) -> Option<Evidence> {
        let finds = self.part.blanks.iter().flat_map(|blank| blank.find.quantities());
        let mut speeds = finds.filter_map(|find| match find {
            Quantity::Speed(sphere, moment) if self.prepared.setting == Setting::Impulse => Some((sphere, moment)),
            _ => None,
        });
        let (sphere, moment) = speeds.next()?;
        let own = |axis| Some(self.theirs.values.get(&Quantity::Velocity(sphere, moment, axis))?.0.clone());
        let (x, y) = own(Axis::X).zip(own(Axis::Y))?;
        let whole: Vec<f64> = x.iter().zip(&y).map(|(x, y)| x.hypot(*y)).collect();
        let is = |expr: &Expr, sizes: &Vec<f64>| self.is_one_of(expr, std::slice::from_ref(sizes));
        let holds = |inner: &Expr| match two_squares(inner) {
            Some((one, other)) => is(&one, &x) && is(&other, &y) || is(&one, &y) && is(&other, &x),
            // `√29` has been worked out in the head.
            None => matches!(inner, Expr::Call(Function::Sqrt, _)) && is(inner, &whole),
        };
        let line = self
            .lines
            .iter()
            .position(|studied| self.members(studied).any(|(member, _)| any_within(&member.expr, &holds)))?;
        Some(Evidence::followed(line, law.name()))
    }

    /// Pythagoras with both components of the vector in which the student's momentum ends, though it be called nothing.
    fn speed_of_own_vector(&self, law: Law) -> Option<Evidence> {
        let (of, found) = match self.prepared.setting {
            Setting::Impulse => (Sphere::A, self.impulse_of_particle(Code::M1)?),
            _ if self.is_in_vectors() => (unknown_sphere(self.prepared)?, self.vector_momentum(Code::M1)?),
            Setting::Wall => return self.speed_of_own_components(law),
            _ => return None,
        };
        let mut own: Option<[Vec<f64>; 2]> = None;
        let mut goes_on = false;
        for (place, studied) in self.lines.iter().enumerate().skip(found.line) {
            let has_squares = |[x, y]: &[Vec<f64>; 2]| {
                let is = |expr: &Expr, sizes: &Vec<f64>| self.is_one_of(expr, std::slice::from_ref(sizes));
                let are = |(one, other): &(Expr, Expr)| is(one, x) && is(other, y) || is(one, y) && is(other, x);
                let holds = |inner: &Expr| two_squares(inner).as_ref().is_some_and(are);
                self.members(studied).any(|(member, _)| {
                    let is_else = |label: &String| !may_be_named(label, Quantity::Speed(of, Moment::After));
                    !member.label.as_ref().is_some_and(is_else) && any_within(&member.expr, &holds)
                })
            };
            if own.as_ref().is_some_and(has_squares) {
                return Some(Evidence::given(place, law.name()));
            }
            // What goes on from an equation for something else is not the velocity either.
            let is_continued = studied.line.goes_on();
            if !is_continued || goes_on {
                let ends = self.unnamed_vector(studied, of);
                goes_on = ends.is_some();
                own = ends.or(own);
            }
        }
        None
    }

    /// The vector in which a line ends that has nothing but vectors, and may be a velocity that nobody has given.
    fn unnamed_vector(&self, studied: &Studied, of: Sphere) -> Option<[Vec<f64>; 2]> {
        let reading = studied.reading.as_ref()?;
        let after = Quantity::Velocity(of, Moment::After, Axis::X);
        let may_be = |label: &String| may_be_named(label, after);
        let are_vectors = |value: &Option<Vec<Value>>| matches!(value.as_deref(), Some([Value::Vector(..), ..]));
        if !reading.members.iter().all(|member| member.letter.is_none() && member.label.as_ref().is_none_or(may_be))
            || !studied.values.iter().all(are_vectors)
        {
            return None;
        }
        let values = studied.values.last()?.as_ref()?;
        let middle = |value: &Value| match value {
            Value::Vector(x, y) => Some((x.middle(), y.middle())),
            Value::Number(_) => None,
        };
        let (x, y) = values.iter().map(middle).collect::<Option<Vec<_>>>()?.into_iter().unzip();
        let is_known = |of_axis: &dyn Fn(Axis) -> Quantity| {
            let [x, y] = [Axis::X, Axis::Y].map(|axis| sizes(&self.prepared.known, of_axis(axis)));
            let both = x.zip(y);
            both.is_some_and(|(x, y)| [1.0, -1.0].into_iter().any(|sign| is_vector(values, &x, &y, sign)))
        };
        let is_given = Sphere::BOTH.into_iter().any(|sphere| {
            is_known(&|axis| Quantity::Velocity(sphere, Moment::Before, axis))
                || is_known(&|axis| Quantity::Impulse(sphere, axis))
                || sphere != of && is_known(&|axis| Quantity::Velocity(sphere, Moment::After, axis))
        });
        (!is_given && !is_known(&Quantity::TotalMomentum)).then_some([x, y])
    }

    /// The change of momentum of a sphere whose velocity after the impact is the student's own.
    fn impulse_of_own(&self, law: Law) -> Option<Evidence> {
        if self.prepared.setting != Setting::Oblique {
            return None;
        }
        let of_both =
            |own: &dyn Fn(Sphere) -> Option<[Vec<f64>; 2]>| Vec::from_iter(Sphere::BOTH.into_iter().filter_map(own));
        let momenta = of_both(&|sphere| self.own_change(sphere));
        // The line of centres is along the change of velocity as well.
        let is_impulse =
            |find: &Quantity| matches!(find.of_its_impact(), Quantity::Impulse(..) | Quantity::ImpulseMagnitude);
        let velocities =
            match self.part.blanks.iter().flat_map(|blank| blank.find.quantities()).any(|find| is_impulse(&find)) {
                true => Vec::new(),
                false => of_both(&|sphere| self.own_change_of_velocity(sphere)),
            };
        let is_one_of = |own: &[[Vec<f64>; 2]], values: &[Value]| {
            own.iter().any(|[x, y]| [1.0, -1.0].iter().any(|sign| is_vector(values, x, y, *sign)))
        };
        let is_change = |expr: &Expr| Sphere::BOTH.into_iter().any(|sphere| self.is_change_of(sphere, expr));
        let line = self.lines.iter().position(|studied| {
            self.members(studied).any(|(member, values)| {
                is_one_of(&momenta, values)
                    || is_worked(&member.expr) && is_one_of(&velocities, values)
                    || is_change(&member.expr)
            })
        })?;
        Some(Evidence::given(line, law.name()))
    }

    /// `m(v - u)` for the student's own v.
    pub(super) fn own_change(&self, sphere: Sphere) -> Option<[Vec<f64>; 2]> {
        let mass = sizes(&self.prepared.known, Quantity::Mass(sphere))?;
        let changes = self.own_change_of_velocity(sphere)?;
        Some(changes.map(|change| change.iter().zip(&mass).map(|(change, mass)| change * mass).collect()))
    }

    /// `v - u` for the student's own v.
    fn own_change_of_velocity(&self, sphere: Sphere) -> Option<[Vec<f64>; 2]> {
        let along = |axis| {
            let (own, _) = self.theirs.values.get(&Quantity::Velocity(sphere, Moment::After, axis))?;
            let before = sizes(&self.prepared.known, Quantity::Velocity(sphere, Moment::Before, axis))?;
            Some(own.iter().zip(before).map(|(after, before)| after - before).collect::<Vec<f64>>())
        };
        let [x, y] = [along(Axis::X)?, along(Axis::Y)?];
        x.iter().chain(&y).any(|size| size.abs() > 1e-9).then_some([x, y])
    }

    /// `m(v - u)` where v may be anything, and m and u belong to one sphere: in either component a difference, for a vector
    /// is read as its components.
    fn is_change_of(&self, sphere: Sphere, expr: &Expr) -> bool {
        let (Some(mass), Expr::Vector(x, y)) = (sizes(&self.prepared.known, Quantity::Mass(sphere)), expr) else {
            return false;
        };
        let is_change = |expr: &Expr, axis| {
            let before = sizes(&self.prepared.known, Quantity::Velocity(sphere, Moment::Before, axis));
            let Some(before) = before else { return false };
            if before.iter().all(|before| *before == 0.0) {
                return true;
            }
            let Some((factors, after, taken)) = two_terms(expr) else { return false };
            let Some(taken) = self.values_of(&product(&factors, taken)) else { return false };
            let is_momentum = taken.iter().zip(before.iter().zip(&mass)).all(|(taken, (before, mass))| match taken {
                Value::Number(taken) => taken.may_be(-before * mass),
                Value::Vector(..) => false,
            });
            let has_mass = |inner: &Expr| self.is_one_of(inner, std::slice::from_ref(&mass));
            // `2 × 5m` has the mass 2m in it, though not as it stands.
            let has_mass = !factors.is_empty() || !after.names().is_empty() || any_within(after, &has_mass);
            is_momentum && has_mass
        };
        is_change(x, Axis::X) && is_change(y, Axis::Y)
    }

    /// `m(v - u)` along the line of centres, with a number for v.
    fn impulse_along(&self, law: Law) -> Option<Evidence> {
        if self.prepared.setting == Setting::Impulse {
            return None;
        }
        let line = self.lines.iter().position(|studied| {
            let members = studied.reading.as_ref().map(|reading| reading.members.as_slice()).unwrap_or_default();
            let is_change = |expr: &Expr| Sphere::BOTH.into_iter().any(|sphere| self.is_change_along(sphere, expr));
            studied.matched.is_empty() && members.iter().any(|member| is_change(&member.expr))
        })?;
        Some(Evidence::given(line, law.name()))
    }

    /// The mass of a sphere times the difference of its velocity before the impact and a number that is no other velocity
    /// before it.
    fn is_change_along(&self, sphere: Sphere, expr: &Expr) -> bool {
        let known = |quantity| sizes(&self.prepared.known, quantity);
        let expr = if let Expr::Negative(inner) = expr { inner } else { expr };
        let before = |of, axis| known(Quantity::Velocity(of, Moment::Before, axis));
        let (Some(mass), Some(own), Some((factors, one, other))) =
            (known(Quantity::Mass(sphere)), before(sphere, Axis::N), two_terms(expr))
        else {
            return false;
        };
        if own.contains(&0.0) {
            return false;
        }
        let times = |mass: &[f64], sizes: &[f64]| -> Vec<f64> {
            sizes.iter().zip(mass).map(|(size, mass)| size * mass).collect()
        };
        let momentum = |sizes: &[f64]| times(&mass, sizes);
        let of_before = |of| [before(of, Axis::N), before(of, Axis::T), known(Quantity::Speed(of, Moment::Before))];
        let others: Vec<Vec<f64>> =
            Sphere::BOTH.into_iter().flat_map(of_before).flatten().map(|sizes| momentum(&sizes)).collect();
        // `2 × 9 − 5 × 2`: the momentum of the other sphere before the impact, by its own mass.
        let is_of_other = |after: &Expr| {
            let Some(mass) = known(Quantity::Mass(sphere.other())) else { return false };
            let has_mass = |factor: &Expr| self.is_one_of(factor, std::slice::from_ref(&mass));
            let own: Vec<Vec<f64>> =
                of_before(sphere.other()).iter().flatten().map(|sizes| times(&mass, sizes)).collect();
            matches!(after, Expr::Product(factors) if factors.iter().any(has_mass)) && self.is_one_of(after, &own)
        };
        let found: Vec<Vec<f64>> = self.sizes_of(sphere, Axis::N).iter().map(|sizes| momentum(sizes)).collect();
        let fits = |taken: &Expr, after: &Expr| {
            let [taken, after] = [taken, after].map(|term| product(&factors, term));
            self.is_one_of(&taken, &[momentum(&own)])
                && self.has_mass(&after, &mass)
                && self.values_of(&after).is_some()
                && !self.is_one_of(&after, &others)
                && !is_of_other(&after)
                // With what is known of v the signs matter.
                && !self.is_near_one_of(&after, &found)
        };
        fits(one, other) || fits(other, one)
    }

    /// The energy of one sphere before an impact less that after it, in which the speed after may be wrong.
    fn energy_of_one(&self, law: Law) -> Option<Evidence> {
        if !matches!(self.prepared.setting, Setting::Wall | Setting::Impulse) {
            return None;
        }
        let before = sizes(&self.prepared.known, Quantity::KineticEnergy(Sphere::A, Moment::Before))?;
        let along = self.energy_along(Moment::Before);
        let line = self.lines.iter().position(|studied| {
            let members = studied.reading.as_ref().map(|reading| reading.members.as_slice()).unwrap_or_default();
            members.iter().any(|member| {
                self.is_energy_less_another(&member.expr, &before, false)
                    || along.as_ref().is_some_and(|along| self.is_energy_less_another(&member.expr, along, true))
            })
        })?;
        Some(Evidence::given(line, law.name()))
    }

    /// The energy of the motion along the line of centres alone, where a wall leaves the rest as it is.
    fn energy_along(&self, moment: Moment) -> Option<Vec<f64>> {
        let known = |quantity| sizes(&self.prepared.known, quantity);
        let along = known(Quantity::Velocity(Sphere::A, moment, Axis::N))?;
        let mass = known(Quantity::Mass(Sphere::A)).filter(|_| self.prepared.setting == Setting::Wall)?;
        Some(along.iter().zip(mass).map(|(along, mass)| mass * along * along / 2.0).collect())
    }

    /// `½mu² - ½mv²` or `½m(u² - v²)`, the first of them right and the other a square, or what the student's own speed
    /// comes to. Of the components alone no more is left than there was, and it is not all the energy after.
    fn is_energy_less_another(&self, expr: &Expr, before: &[f64], is_along: bool) -> bool {
        let Some((factors, one, Expr::Negative(other))) = two_terms(expr) else { return false };
        let values = |last: &Expr| self.values_of(&product(&factors, last));
        let is_square = |inner: &Expr| matches!(inner, Expr::Power(_, exponent) if **exponent == Expr::integer(2));
        let (Some(first), Some(second)) = (values(one), values(other)) else { return false };
        let is_before = first.iter().zip(before).all(|(value, right)| comes_to(*value, *right));
        let is_another = second.iter().zip(before).all(|(value, right)| match value {
            Value::Number(spread) => spread.low > 1e-9 && spread.high < if is_along { *right } else { 2.0 * right },
            Value::Vector(..) => false,
        });
        let totals = [&self.prepared.known, &self.followed]
            .map(|known| sizes(known, Quantity::KineticEnergy(Sphere::A, Moment::After)));
        let second = product(&factors, other);
        let is_total = self.is_near_one_of(&second, &totals.into_iter().flatten().collect::<Vec<_>>());
        // All the energy less that of one component is no difference: what is unchanged is left out on both sides or neither.
        let part = self.energy_along(Moment::After).filter(|_| !is_along && !is_total);
        if part.is_some_and(|part| self.is_near_one_of(&second, &[part])) {
            return false;
        }
        let is_squared = || any_within(other, &is_square);
        let counts = if is_along { is_squared() && !is_total } else { is_squared() || is_total };
        is_before && is_another && counts
    }
}

/// A sum of two terms as it stands, or multiplied by what is common to both: those factors, and the terms.
fn two_terms(expr: &Expr) -> Option<(Vec<&Expr>, &Expr, &Expr)> {
    let (factors, sum): (Vec<&Expr>, &Expr) = match expr {
        Expr::Product(all) => {
            let at = all.iter().position(|factor| matches!(factor, Expr::Sum(_)))?;
            (all.iter().enumerate().filter(|(place, _)| *place != at).map(|(_, factor)| factor).collect(), &all[at])
        }
        _ => (Vec::new(), expr),
    };
    match sum {
        Expr::Sum(terms) => match terms.as_slice() {
            [one, other] => Some((factors, one, other)),
            _ => None,
        },
        _ => None,
    }
}

/// The factors times what comes last.
fn product(factors: &[&Expr], last: &Expr) -> Expr {
    match factors {
        [] => last.clone(),
        _ => Expr::Product(factors.iter().map(|factor| (*factor).clone()).chain([last.clone()]).collect()),
    }
}
