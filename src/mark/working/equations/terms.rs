//! The two equations known by their terms, where a velocity after the impact stands in them as a number.
//!
//! `2 × 4 − 5 = 2 × (−5/4) + w`: once one velocity is given or found, momentum and restitution come to the same for the
//! other, and only their terms tell which of them a line is. Terms are compared as numbers, up to a factor that they have
//! in common; a letter that is still open is tried for what it may stand for.

use std::cell::{Cell, OnceCell};

use super::added_up::{count, terms, terms_negated};
use super::agreement::{Agrees, LEAST_TERMS, SLACK, agreement, agreement_of_three, near};
use super::convention::is_value;
use super::conventions::sphere;
use super::departure::Departure;
use super::pair::BOTH;
use super::trials::{are_of_one, chosen, degree, may_stand_for};
use crate::bank::Code;
use crate::expr::Expr;
use crate::mark::judging::may_be_named;
use crate::mark::working::evidence::Evidence;
use crate::mark::working::examine::{Studied, Working, context};
use crate::mark::working::letters::whole;
use crate::mark::working::numbers::{Context, Points, Spread, any_within, constant};
use crate::mechanics::{Axis, Known, Law, Moment, Quantity, Sphere};

/// What is known of an impact at a point, along the line of centres.
struct Numbers {
    masses: [f64; 2],
    before: [f64; 2],
    after: [f64; 2],
    e: f64,
}

impl Numbers {
    fn of(known: &Known<f64>) -> Option<Numbers> {
        let both = |of: &dyn Fn(Sphere) -> Quantity| known.numbers(Sphere::BOTH.map(of));
        let along = |moment| both(&|sphere| Quantity::Velocity(sphere, moment, Axis::N));
        Some(Numbers {
            masses: both(&Quantity::Mass)?,
            before: along(Moment::Before)?,
            after: along(Moment::After)?,
            e: known.number(Quantity::Restitution)?,
        })
    }

    /// The same in so many times the unit of speed.
    fn over(self, unit: f64) -> Numbers {
        let [before, after] = [self.before, self.after].map(|speeds| speeds.map(|speed| speed / unit));
        Numbers { before, after, ..self }
    }

    /// The terms of a law, all on one side.
    fn terms(&self, equation: Quantity) -> [f64; 4] {
        let ([m, n], [a, b], [v, w]) = (self.masses, self.before, self.after);
        match equation {
            Quantity::MomentumEquation => [m * a, n * b, -m * v, -n * w],
            _ => [w, -v, -self.e * a, self.e * b],
        }
    }

    /// The same, where what was before the impact is one number.
    fn with_sum_before(&self, equation: Quantity) -> [f64; 3] {
        match (equation, self.terms(equation)) {
            (Quantity::MomentumEquation, [a, b, v, w]) => [a + b, v, w],
            (_, [w, v, a, b]) => [w, v, a + b],
        }
    }

    /// What a letter may stand for that is not known by its name: see [`may_stand_for`].
    fn anything(&self) -> Vec<f64> {
        let [v, w] = self.after;
        let mut all = vec![v, w, -v, -w, self.e];
        let [m, n] = self.masses;
        all.extend([m, n, m / n, n / m]);
        all
    }
}

/// How the lines agree with momentum and with restitution, found when it is first asked for: with what is right, and
/// with what follows from the student's own values.
#[derive(Default)]
pub(in crate::mark::working) struct ByNumbers([[OnceCell<Vec<Option<Agrees>>>; 2]; 2]);

impl ByNumbers {
    fn of(&self, of: usize, equation: Quantity, find: impl FnOnce() -> Vec<Option<Agrees>>) -> &[Option<Agrees>] {
        self.0[of][usize::from(equation == Quantity::MomentumEquation)].get_or_init(find)
    }

    fn right(&self, equation: Quantity, find: impl FnOnce() -> Vec<Option<Agrees>>) -> &[Option<Agrees>] {
        self.of(0, equation, find)
    }

    fn own(&self, equation: Quantity, find: impl FnOnce() -> Vec<Option<Agrees>>) -> &[Option<Agrees>] {
        self.of(1, equation, find)
    }
}

impl Working<'_> {
    /// One of the two equations by its terms.
    pub(in crate::mark::working) fn by_terms(&self, law: Law, code: Code) -> Option<Evidence> {
        let equation = BOTH.into_iter().find(|equation| law.gives(*equation))?;
        let line =
            |agreements: &[Option<Agrees>], least: Agrees| agreements.iter().position(|agrees| *agrees >= Some(least));
        let right_of = |equation| {
            self.by_numbers.right(equation, || {
                let there = |point| self.prepared.where_found(point).unwrap_or(&self.prepared.known[point]);
                self.agreements(equation, &there)
            })
        };
        let right = right_of(equation);
        if let Some(place) = line(right, Agrees::Fully) {
            return Some(Evidence::given(place, law.name()));
        }
        let own = || {
            self.by_numbers.own(equation, || match self.theirs.values.is_empty() {
                true => Vec::new(),
                false => self.agreements(equation, &|point| &self.followed[point]),
            })
        };
        let but_for_signs = || {
            let place = line(right, Agrees::ButForSignsAndFactor)?;
            // What is as near to the other law is neither.
            let other = BOTH.into_iter().find(|other| *other != equation)?;
            (right_of(other).get(place).copied().flatten() < right[place]).then_some(place)
        };
        let by_own = || line(own(), Agrees::ButForSignsAndFactor);
        let (place, note, feedback) = match (but_for_signs(), by_own()) {
            (Some(place), _) => (place, Some("sign-error"), "a sign or a number in it is wrong"),
            (None, Some(place)) => (place, None, "it starts from a value that is not right"),
            (None, None) => {
                let missing = Departure::LetterMissing;
                (self.without_letter(equation)?, Some(missing.tag()), missing.sentence())
            }
        };
        let evidence = Evidence::given(place, law.name());
        match code.is_accuracy() {
            false => Some(evidence),
            true => Some(Evidence { given: false, note, feedback: feedback.to_owned(), ..evidence }),
        }
    }

    /// The line that is one of the two equations in every term, but that a letter of the speeds is left out of all: `37k = 36k + w`.
    fn without_letter(&self, equation: Quantity) -> Option<usize> {
        self.prepared.laws.iter().flat_map(|laws| &laws.speeds).find_map(|letter| {
            let at = |(point, letter): (usize, &f64)| Some(Numbers::of(&self.prepared.known[point])?.over(*letter));
            let numbers = letter.iter().enumerate().map(at).collect::<Option<Vec<Numbers>>>()?;
            self.agreements_with(equation, &numbers).iter().position(|agrees| *agrees == Some(Agrees::Fully))
        })
    }

    /// How each line that is not known by its form agrees with one of the two equations, with these numbers.
    fn agreements<'k>(&'k self, equation: Quantity, at: &dyn Fn(usize) -> &'k Known<f64>) -> Vec<Option<Agrees>> {
        let numbers: Option<Vec<Numbers>> =
            (0..self.prepared.points.count).map(|point| Numbers::of(at(point))).collect();
        numbers.map_or(Vec::new(), |numbers| self.agreements_with(equation, &numbers))
    }

    fn agreements_with(&self, equation: Quantity, numbers: &[Numbers]) -> Vec<Option<Agrees>> {
        if self.has_unsaid_nought(&numbers.iter().map(|at| at.after).collect::<Vec<_>>()) {
            return Vec::new();
        }
        let agrees = |studied: &Studied| {
            let is_open =
                studied.matched.iter().all(|matched| !matched.is_method()) && !self.is_printed_result(studied);
            is_open.then(|| self.agreement(studied, equation, numbers)).flatten()
        };
        self.lines.iter().map(agrees).collect()
    }

    /// How a line agrees with one of the two equations, if it does.
    fn agreement(&self, studied: &Studied, equation: Quantity, numbers: &[Numbers]) -> Option<Agrees> {
        let reading = studied.reading.as_ref()?;
        // What is called an energy or a tangent is neither, though three of its numbers be in proportion.
        let is_energy = |label: &String| {
            may_be_named(label, Quantity::EnergyLost) && !may_be_named(label, Quantity::Speed(Sphere::A, Moment::After))
        };
        let is_of_angle =
            |label: &String| ["tan", "sin", "cos"].iter().any(|name| label.trim_start().starts_with(name));
        if reading
            .members
            .iter()
            .filter_map(|member| member.label.as_ref())
            .any(|label| is_energy(label) || is_of_angle(label))
        {
            return None;
        }
        let quotients = reading.members.iter().filter(|_| equation == Quantity::RestitutionEquation);
        // `1.5` in `e = (8u + 2u)/(4u/3 + 16u/3) = 1.5` is no factor of the law, but what its quotient comes to.
        let is_worth = |(left, right): &(Expr, Expr)| {
            let is_called_e = || reading.equations.iter().any(|(name, quotient)| is_e(name) && quotient == left);
            right.names().is_empty() && is_called_e()
        };
        let of_equations = reading
            .equations
            .iter()
            .filter(|equation| !is_value(equation) && !is_worth(equation))
            .filter_map(|(left, right)| self.of_equation(left, right, equation, numbers));
        let of_quotients = quotients
            .filter(|member| {
                // `e = (w − v)/(a − b)` is what it says, whatever the calculator makes of it.
                let is_said = |(left, right): &(Expr, Expr)| is_e(left) && *right == member.expr;
                let is_e_all_along =
                    || reading.members.iter().all(|other| self.may_be_e(&other.expr, &member.expr, numbers));
                reading.equations.iter().any(is_said) || is_e_all_along()
            })
            .filter_map(|member| self.of_quotient(&member.expr, numbers));
        of_equations.chain(of_quotients).max()
    }

    fn of_equation(&self, left: &Expr, right: &Expr, equation: Quantity, numbers: &[Numbers]) -> Option<Agrees> {
        if count(left) + count(right) < LEAST_TERMS {
            return None;
        }
        // Three numbers in the proportion of restitution may be anything: `1 + 2 = 3`.
        let is_bare = equation == Quantity::RestitutionEquation && left.names().is_empty() && right.names().is_empty();
        self.tried(&[left, right], numbers, &|at, context| {
            let mut terms = terms(left, context)?;
            terms.extend(terms_negated(right, context)?);
            let fits = |(agrees, scale): (Agrees, f64)| {
                let is_as_it_is = terms.len() > LEAST_TERMS || (scale.abs() - 1.0).abs() <= SLACK;
                (is_as_it_is || !is_bare && (self.has_letters() || is_whole_or_share(scale))).then_some(agrees)
            };
            let whole = agreement_of_three(&terms, &at.terms(equation)).and_then(fits);
            whole.or_else(|| {
                let found = agreement_of_three(&terms, &at.with_sum_before(equation)).and_then(fits);
                found.filter(|agrees| *agrees == Agrees::Fully)
            })
        })
    }

    /// Are masses and speeds letters, by any power of which a law may be divided?
    fn has_letters(&self) -> bool {
        !self.question.letters.is_empty()
    }

    /// Is what a line sets equal to a quotient e: by its letter, by its value, or as what the quotient comes to?
    fn may_be_e(&self, other: &Expr, quotient: &Expr, numbers: &[Numbers]) -> bool {
        let at = |expr: &Expr, point: usize| constant(expr, &context(self.prepared, point));
        let is = |(point, at_point): (usize, &Numbers)| {
            let Some(value) = at(other, point) else { return false };
            let own = at(quotient, point).map(Spread::middle);
            let is_own = |own: f64| (value.middle() - own).abs() <= 0.02 * own.abs();
            near(value.absolute(), at_point.e) || own.is_some_and(is_own)
        };
        other == quotient || is_e(other) || numbers.iter().enumerate().all(is)
    }

    /// `(w − v)/(a − b)`, which is e.
    fn of_quotient(&self, expr: &Expr, numbers: &[Numbers]) -> Option<Agrees> {
        let best = Cell::new(None);
        any_within(expr, &|inner| {
            if let Expr::Quotient(above, below) = inner {
                let agrees = self.tried(&[above, below], numbers, &|at, context| {
                    let [v, w] = at.after;
                    let [a, b] = at.before;
                    let (above, below) = (terms(above, context)?, terms(below, context)?);
                    // One of the two may have been worked out before.
                    let (above, below) = match (above.len(), below.len()) {
                        (1, 2..) => (agreement(&above, &[w - v]), agreement(&below, &[a, -b])),
                        (2.., 1) => (agreement(&above, &[w, -v]), agreement(&below, &[a - b])),
                        _ => (agreement(&above, &[w, -v]), agreement(&below, &[a, -b])),
                    };
                    let ((above, scale), (below, other)) = above.zip(below)?;
                    // A number alone would agree with anything, were the factor another.
                    let is = |other: f64| (scale - other).abs() <= SLACK * scale.abs();
                    match (is(other), is(-other)) {
                        (true, _) => Some(above.min(below)),
                        (false, true) => Some(Agrees::ButForSigns),
                        (false, false) => None,
                    }
                });
                best.set(best.get().max(agrees));
            }
            false
        });
        best.get()
    }

    /// The sphere that a letter names: `v_A` always, `v_1` where the equations do not say otherwise.
    fn sphere_of(&self, letter: &str) -> Option<Sphere> {
        let told = sphere(letter)?;
        let mut letters = self.convention.iter().flat_map(|convention| &convention.letters);
        letters.position(|known| known == letter).map(|place| Sphere::BOTH[place]).or(Some(told))
    }

    /// How well formulas agree at every point, their open letters standing for what makes them agree best.
    fn tried(
        &self,
        formulas: &[&Expr],
        numbers: &[Numbers],
        agrees: &dyn Fn(&Numbers, &Context) -> Option<Agrees>,
    ) -> Option<Agrees> {
        let is_open = |name: &str| !matches!(name, "i" | "j") && !self.prepared.gives(name);
        let mut open: Vec<&str> =
            formulas.iter().flat_map(|formula| formula.names()).map(|name| name.text.as_str()).collect();
        open.sort_unstable();
        open.dedup();
        open.retain(|name| is_open(name));
        let found = self.prepared.found.iter().map(|(letter, _)| letter.name().to_owned());
        let found: Vec<String> = found.collect();
        open.retain(|name| !found.contains(&(*name).to_owned()));
        // A letter that is a component itself has none.
        let letters = self.convention.as_ref().map(|convention| convention.letters.as_slice()).unwrap_or_default();
        if open.iter().any(|name| name.contains(' ') && letters.contains(&whole(name))) {
            return None;
        }
        let is_velocity = |name: &str| open.contains(&name) && may_stand_for(name, None, false)[0] == 0;
        // With both unknowns in it a line is one of the two by its form, or neither.
        if letters.len() == 2 && letters.iter().all(|letter| open.contains(&letter.as_str())) {
            return None;
        }
        if open.len() > 2 || formulas.iter().any(|formula| degree(formula, &is_velocity) > 1) {
            return None;
        }
        let anything: Vec<Vec<f64>> = numbers.iter().map(Numbers::anything).collect();
        let is_mass_open =
            Sphere::BOTH.iter().any(|sphere| !self.prepared.given[0].0.contains_key(&Quantity::Mass(*sphere)));
        let choices = open.iter().map(|name| may_stand_for(name, self.sphere_of(name), is_mass_open));
        let choices: Vec<&[usize]> = choices.collect();
        let trials = choices.iter().map(|choices| choices.len()).product();
        let points: Vec<Points> =
            (0..numbers.len()).map(|point| self.prepared.points.with(&self.prepared.found, point)).collect();
        let mut names = self.prepared.names.clone();
        let known = names.len();
        names.extend(open.iter().map(|name| ((*name).to_owned(), vec![0.0; numbers.len()])));
        let mut best = None;
        for trial in 0..trials {
            let chosen = chosen(trial, &choices);
            if chosen.len() == 2 && are_of_one(chosen[0], chosen[1]) {
                continue;
            }
            for (chosen, (_, values)) in chosen.into_iter().zip(&mut names[known..]) {
                values.iter_mut().zip(&anything).for_each(|(value, anything)| *value = anything[chosen]);
            }
            let at = |(point, at): (usize, &Numbers)| {
                agrees(at, &Context { points: &points[point], given: &names, ..context(self.prepared, point) })
            };
            let least = numbers.iter().enumerate().map(at).try_fold(Agrees::Fully, |least, one| Some(least.min(one?)));
            best = best.max(least);
            if best == Some(Agrees::Fully) {
                break;
            }
        }
        best
    }
}

fn is_e(expr: &Expr) -> bool {
    matches!(expr, Expr::Name(name) if name.text == "e")
}

/// Is a law multiplied or divided by it to be rid of fractions, or of a factor that all its terms have? Three terms in its proportion
/// may be those of something else: `6 = 6v + 4.5`.
fn is_whole_or_share(scale: f64) -> bool {
    let is_whole = |scale: f64| scale > 0.5 && (scale - scale.round()).abs() <= SLACK * scale;
    is_whole(scale.abs()) || is_whole(1.0 / scale.abs())
}

#[cfg(test)]
mod tests {
    use super::is_whole_or_share;

    #[test]
    fn a_law_is_multiplied_by_a_whole_number_or_divided_by_one() {
        let found = [1.0, -2.0, 0.5, -1.0 / 3.0, 1.5, 0.4, -2.5].map(is_whole_or_share);
        assert_eq!(found, [true, true, true, true, false, false, false]);
    }
}
