//! The two equations known by their terms, where a velocity after the impact stands in them as a number.
//!
//! `2 × 4 − 5 = 2 × (−5/4) + w`: once one velocity is given or found, momentum and restitution come to the same for the
//! other, and only their terms tell which of them a line is. Terms are compared as numbers, up to a factor that they have
//! in common; a letter that is still open is tried for what it may stand for.

use super::compare::any_within;
use super::convention::is_value;
use super::evidence::Evidence;
use super::examine::{Studied, Working, context};
use super::linear::{Context, constant};
use super::spread::Spread;
use crate::bank::Code;
use crate::expr::{Expr, Relation};
use crate::mechanics::{Axis, Known, Law, Moment, Quantity, Sphere};

/// Nobody writes more terms into one of the two equations.
const MOST_TERMS: usize = 8;

/// How a line agrees with a law.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Agrees {
    /// In every term but for signs.
    ButForSigns,
    Fully,
}

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

    /// What a letter may stand for that is not known by its name.
    fn anything(&self) -> Vec<f64> {
        let [v, w] = self.after;
        let mut all = vec![v, w, -v, -w, self.e];
        all.extend(self.masses);
        all
    }
}

impl Working<'_> {
    /// One of the two equations by its terms.
    pub(super) fn by_terms(&self, law: Law, code: Code) -> Option<Evidence> {
        let equation = [Quantity::MomentumEquation, Quantity::RestitutionEquation]
            .into_iter()
            .find(|equation| law.gives(*equation))?;
        let right = self.numbers(&|point| self.prepared.where_found(point).unwrap_or(&self.prepared.known[point]));
        let own = if self.theirs.0.is_empty() { None } else { self.numbers(&|point| &self.followed[point]) };
        let line = |numbers: &[Numbers], least: Agrees| {
            self.lines.iter().position(|studied| {
                studied.matched.iter().all(|matched| !matched.is_method())
                    && !self.is_printed_result(studied)
                    && self.agreement(studied, equation, numbers) >= Some(least)
            })
        };
        let found = |least| right.as_ref().and_then(|right| line(right, least));
        if let Some(place) = found(Agrees::Fully) {
            return Some(Evidence::given(place, law.name()));
        }
        let (place, note, feedback) = match found(Agrees::ButForSigns) {
            Some(place) => (place, Some("sign-error"), "a sign or a number in it is wrong"),
            None => (line(own.as_ref()?, Agrees::ButForSigns)?, None, "it starts from a value that is not right"),
        };
        let evidence = Evidence::given(place, law.name());
        match code.is_accuracy() {
            false => Some(evidence),
            true => Some(Evidence { given: false, note, feedback: feedback.to_owned(), ..evidence }),
        }
    }

    fn numbers<'k>(&'k self, at: &dyn Fn(usize) -> &'k Known<f64>) -> Option<Vec<Numbers>> {
        (0..self.prepared.points.count).map(|point| Numbers::of(at(point))).collect()
    }

    /// How a line agrees with one of the two equations, if it does.
    fn agreement(&self, studied: &Studied, equation: Quantity, numbers: &[Numbers]) -> Option<Agrees> {
        let reading = studied.reading.as_ref()?;
        let quotients = reading.members.iter().filter(|_| equation == Quantity::RestitutionEquation);
        let of_equations = reading
            .equations
            .iter()
            .filter(|equation| !is_value(equation))
            .filter_map(|(left, right)| self.of_equation(left, right, equation, numbers));
        let of_quotients = quotients.filter_map(|member| self.of_quotient(&member.expr, numbers));
        of_equations.chain(of_quotients).max()
    }

    fn of_equation(&self, left: &Expr, right: &Expr, equation: Quantity, numbers: &[Numbers]) -> Option<Agrees> {
        self.tried(&[left, right], numbers, &|at, context| {
            let mut terms = terms(left, context)?;
            terms.extend(terms_negated(right, context)?);
            let whole = agreement_of_three(&terms, &at.terms(equation));
            whole.or_else(|| {
                agreement_of_three(&terms, &at.with_sum_before(equation)).filter(|agrees| *agrees == Agrees::Fully)
            })
        })
    }

    /// `(w − v)/(a − b)`, which is e.
    fn of_quotient(&self, expr: &Expr, numbers: &[Numbers]) -> Option<Agrees> {
        let best = std::cell::Cell::new(None);
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
                    let is_e = (scale - other).abs() <= 1e-6 * scale.abs();
                    Some(if is_e { above.min(below) } else { Agrees::ButForSigns })
                });
                best.set(best.get().max(agrees));
            }
            false
        });
        best.get()
    }

    /// How well formulas agree at every point, their open letters standing for what makes them agree best.
    fn tried(
        &self,
        formulas: &[&Expr],
        numbers: &[Numbers],
        agrees: &dyn Fn(&Numbers, &Context) -> Option<Agrees>,
    ) -> Option<Agrees> {
        let is_open = |name: &str| {
            !matches!(name, "i" | "j")
                && self.prepared.points.letter(name, 0).is_none()
                && !self.prepared.names.iter().any(|(known, _)| known == name)
        };
        let mut open: Vec<&str> =
            formulas.iter().flat_map(|formula| formula.names()).map(|name| name.text.as_str()).collect();
        open.sort_unstable();
        open.dedup();
        open.retain(|name| is_open(name));
        let found = self.prepared.found.iter().map(|(letter, _)| letter.name().to_owned());
        let found: Vec<String> = found.collect();
        open.retain(|name| !found.contains(&(*name).to_owned()));
        let many = numbers.first()?.anything().len();
        let trials = many.checked_pow(u32::try_from(open.len()).ok()?).filter(|_| open.len() <= 2)?;
        let trial = |trial: usize| {
            let at = |(point, at): (usize, &Numbers)| {
                let anything = at.anything();
                let stands_for = |place: usize| anything[trial / many.pow(place as u32) % many];
                let mut names = self.prepared.names.clone();
                for (place, name) in open.iter().enumerate() {
                    names.push(((*name).to_owned(), vec![stands_for(place); self.prepared.points.count]));
                }
                let points = self.prepared.points.with(&self.prepared.found, point);
                agrees(at, &Context { points: &points, given: &names, ..context(self.prepared, point) })
            };
            numbers.iter().enumerate().map(at).collect::<Option<Vec<Agrees>>>()?.into_iter().min()
        };
        let mut best = None;
        for one in 0..trials {
            best = best.max(trial(one));
            if best == Some(Agrees::Fully) {
                break;
            }
        }
        best
    }
}

/// What is added up in a formula, brackets multiplied out.
fn terms(expr: &Expr, context: &Context) -> Option<Vec<Spread>> {
    let found = match expr {
        Expr::Sum(all) => {
            let each: Option<Vec<Vec<Spread>>> = all.iter().map(|term| terms(term, context)).collect();
            each?.concat()
        }
        Expr::Negative(inner) => terms(inner, context)?.into_iter().map(|term| -term).collect(),
        Expr::Product(factors) => {
            let mut product = vec![Spread::exactly(1.0)];
            for factor in factors {
                let factor = terms(factor, context)?;
                product = product.iter().flat_map(|one| factor.iter().map(|other| *one * *other)).collect();
                if product.len() > MOST_TERMS {
                    return None;
                }
            }
            product
        }
        Expr::Quotient(above, below) => {
            let below = constant(below, context)?;
            terms(above, context)?.into_iter().map(|term| term.over(below)).collect::<Option<_>>()?
        }
        Expr::Relation(_, Relation::Equal, _) => return None,
        other => vec![constant(other, context)?],
    };
    (found.len() <= MOST_TERMS).then_some(found)
}

fn terms_negated(expr: &Expr, context: &Context) -> Option<Vec<Spread>> {
    Some(terms(expr, context)?.into_iter().map(|term| -term).collect())
}

/// The same of a law with three terms or more: two could be anything.
fn agreement_of_three(terms: &[Spread], law: &[f64]) -> Option<Agrees> {
    let is_whole = law.iter().filter(|term| term.abs() > 1e-9).count() >= 3;
    is_whole.then(|| agreement(terms, law)).flatten().map(|(agrees, _)| agrees)
}

/// Do the terms agree with those of a law, up to a factor? And the factor. What is nought need not be written.
fn agreement(terms: &[Spread], law: &[f64]) -> Option<(Agrees, f64)> {
    let size = law.iter().fold(0.0, |size: f64, term| size.max(term.abs()));
    let law: Vec<f64> = law.iter().copied().filter(|term| term.abs() > 1e-9 * size).collect();
    let largest = terms.iter().fold(0.0, |size: f64, term| size.max(term.middle().abs()));
    let terms: Vec<Spread> = terms.iter().copied().filter(|term| !term.may_be_nought(largest)).collect();
    if terms.len() != law.len() || law.is_empty() {
        return None;
    }
    let mut best: Option<(Agrees, f64)> = None;
    for one in &law {
        let scale = terms[0].middle() / one;
        for (agrees, scale) in [(Agrees::Fully, scale), (Agrees::ButForSigns, scale)] {
            let is = |term: Spread, own: f64| match agrees {
                Agrees::Fully => term.may_be(own * scale),
                Agrees::ButForSigns => near(term.absolute(), (own * scale).abs()),
            };
            if best.is_none_or(|(found, _)| found < agrees) && pairs_off(&terms, &law, &is) {
                best = Some((agrees, scale));
            }
        }
    }
    best
}

/// Is it this number, or this number rounded more than its figures show?
fn near(term: Spread, number: f64) -> bool {
    let slack = 0.002 * number.abs();
    term.may_be(number) || (term.low - slack..=term.high + slack).contains(&number)
}

/// Has each term one of the law's for its own?
fn pairs_off(terms: &[Spread], law: &[f64], is: &dyn Fn(Spread, f64) -> bool) -> bool {
    let Some((first, rest)) = terms.split_first() else { return law.is_empty() };
    (0..law.len()).any(|place| {
        is(*first, law[place]) && {
            let mut others = law.to_vec();
            others.remove(place);
            pairs_off(rest, &others, is)
        }
    })
}
