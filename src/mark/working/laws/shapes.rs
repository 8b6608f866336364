//! Laws known by the shape of their formula.

use super::energies::is_energy_difference;
use crate::answer::Kind;
use crate::bank::Code;
use crate::expr::{Expr, Function};
use crate::mark::working::equations::Departure;
use crate::mark::working::evidence::Evidence;
use crate::mark::working::examine::{Working, context};
use crate::mark::working::letters::squared;
use crate::mark::working::lines::{Member, ReadLine};
use crate::mark::working::numbers::{Context, any_within, comes_to, constant, sizes};
use crate::mark::working::theirs::numbers;
use crate::mechanics::{Axis, Datum, Known, Law, Moment, Quantity, Setting, Shape, Sphere};
use crate::number::Range;

impl Working<'_> {
    /// A law known by its form.
    pub(super) fn by_shape(&self, law: Law, shape: Shape, sphere: Option<Sphere>, code: Code) -> Option<Evidence> {
        if code.is_accuracy() {
            return None;
        }
        // Where nothing else is asked, a difference without a name is meant for the impulse.
        let is_impulse = |find: Quantity| find.of_its_impact() == Quantity::ImpulseMagnitude;
        let is_only_impulse = self.part.blanks.iter().flat_map(|blank| blank.find.quantities()).all(is_impulse);
        let has_form = |member: &Member| {
            let expr = &member.expr;
            match shape {
                Shape::Pythagoras => {
                    any_within(expr, &|inner| self.is_pythagoras(inner, sphere)) && !self.is_without_root(member)
                }
                Shape::Tangent => {
                    any_within(expr, &|inner| self.is_tangent(inner, sphere) || self.is_cotangent(inner, sphere))
                }
                Shape::DifferenceOfSquares => {
                    (is_energy_difference(expr) && self.has_both_spheres(expr))
                        || self.is_difference_of_totals(expr)
                        || self.is_difference_of_worked_out(expr)
                        || self.is_loss_of_own_at_wall(expr)
                }
                Shape::ChangeOfMomentum => {
                    let is_called = self.is_called(member) || is_only_impulse && member.label.is_none();
                    self.is_change_of_momentum(expr, is_called)
                }
                Shape::Any => false,
            }
        };
        let is_tangent = |equation: &(Expr, Expr)| {
            let tangent =
                Some(equation).filter(|_| shape == Shape::Tangent).and_then(|equation| self.tangent_in(equation));
            tangent.is_some_and(|tangent| self.is_tangent(&tangent, sphere))
        };
        let line = self.lines.iter().position(|studied| {
            let has =
                |reading: &ReadLine| reading.members.iter().any(has_form) || reading.equations.iter().any(is_tangent);
            studied.matched.is_empty() && studied.reading.as_deref().is_some_and(has)
        })?;
        let mut found = Evidence::given(line, law.name());
        if shape == Shape::Tangent && self.is_upside_down(line, sphere) {
            (found.note, found.feedback) = (Some("inverted"), "condoned here: the ratio is upside down".to_owned());
        }
        Some(found)
    }

    /// An energy or an impulse in which a letter of the masses or the speeds is left out of every term, or both.
    pub(super) fn without_a_letter(&self, law: Law, quantities: &[Quantity], code: Code) -> Option<Evidence> {
        let is_of_mass = |quantity: &&Quantity| {
            matches!(quantity, Quantity::EnergyLost | Quantity::Impulse(..) | Quantity::ImpulseMagnitude)
        };
        let positive = self.question.letters.iter().filter(|letter| letter.range() == Range::Positive);
        let letters: Vec<Vec<f64>> = positive
            .filter_map(|letter| {
                (0..self.prepared.points.count).map(|at| self.prepared.points.letter(letter.name(), at)).collect()
            })
            .collect();
        let times = |one: &[f64], other: &[f64]| -> Vec<f64> { one.iter().zip(other).map(|(a, b)| a * b).collect() };
        let mut factors = letters.clone();
        factors.extend(letters.iter().flat_map(|one| letters.iter().map(|other| times(one, other))));
        factors.extend(letters.iter().flat_map(|one| letters.iter().map(|other| times(one, &times(other, other)))));
        let line_without = |factors: &[Vec<f64>]| {
            quantities.iter().filter(is_of_mass).find_map(|quantity| {
                let right = sizes(&self.prepared.known, *quantity)?;
                factors.iter().find_map(|factor| {
                    let at = |(right, factor): (&f64, &f64)| {
                        let mut known = Known::default();
                        known.0.insert(*quantity, Datum::Number(right / factor));
                        known
                    };
                    let without: Vec<Known<f64>> = right.iter().zip(factor).map(at).collect();
                    self.line_that_is(&without, *quantity)
                })
            })
        };
        let letter = line_without(&factors).map(|line| (line, Departure::LetterMissing));
        let number = || line_without(&self.number_of_mass(&letters)).map(|line| (line, Departure::NumberMisread));
        let (line, departure) = letter.or_else(number)?;
        let feedback = match code.is_accuracy() {
            true => departure.sentence().to_owned(),
            false => format!("condoned here: {}", departure.sentence()),
        };
        let (given, note) = (!code.is_accuracy(), Some(departure.tag()));
        Some(Evidence { given, note, feedback, ..Evidence::given(line, law.name()) })
    }

    /// The number before the letter of a mass, `m` for 2m, where it is that of no other sphere.
    fn number_of_mass(&self, letters: &[Vec<f64>]) -> Vec<Vec<f64>> {
        let mass =
            sizes(&self.prepared.known, Quantity::Mass(Sphere::A)).filter(|_| self.prepared.setting == Setting::Wall);
        let over = |letter: &Vec<f64>| -> Option<Vec<f64>> {
            let numbers: Vec<f64> = mass.as_ref()?.iter().zip(letter).map(|(mass, letter)| mass / letter).collect();
            let is_number =
                numbers.iter().all(|number| (number - numbers[0]).abs() < 1e-9) && (numbers[0] - 1.0).abs() > 1e-9;
            is_number.then_some(numbers)
        };
        letters.iter().filter_map(over).collect()
    }

    /// The sizes that a component after the impact may have: the right one, the student's own, and across the line also
    /// what the exchange of sine and cosine makes of it, and e, and what a letter leaves of it that is left out.
    pub(in crate::mark::working) fn sizes_of(&self, sphere: Sphere, axis: Axis) -> Vec<Vec<f64>> {
        let mut all = Vec::new();
        let quantity = Quantity::Velocity(sphere, Moment::After, axis);
        all.extend(sizes(&self.prepared.known, quantity));
        all.extend(self.theirs.values.get(&quantity).map(|(values, _)| values.clone()));
        if axis == Axis::T {
            all.extend(sizes(&self.prepared.known, Quantity::Velocity(sphere, Moment::Before, Axis::N)));
            // And what e makes of it.
            let e = sizes(&self.prepared.known, Quantity::Restitution);
            let product = |(across, e): (Vec<f64>, Vec<f64>)| across.iter().zip(e).map(|(one, e)| one * e).collect();
            all.extend(sizes(&self.prepared.known, quantity).zip(e).map(product));
            let letters = self.prepared.laws.iter().flat_map(|laws| &laws.speeds);
            let across = sizes(&self.prepared.known, quantity);
            let without =
                |letter: &Vec<f64>| Some(across.as_ref()?.iter().zip(letter).map(|(one, of)| one / of).collect());
            all.extend(letters.filter_map(without));
        }
        all
    }

    pub(in crate::mark::working) fn is_one_of(&self, expr: &Expr, sizes: &[Vec<f64>]) -> bool {
        let Some(values) = self.values_of(expr) else { return false };
        sizes.iter().any(|right| values.iter().zip(right).all(|(value, right)| comes_to(*value, *right)))
    }

    /// The same of a number that was rounded more than its figures show.
    pub(in crate::mark::working) fn is_near_one_of(&self, expr: &Expr, sizes: &[Vec<f64>]) -> bool {
        let Some(values) = self.values_of(expr).and_then(|values| numbers(&values)) else {
            return false;
        };
        let near = |value: &f64, right: &f64| (value.abs() - right.abs()).abs() <= 0.002 * right.abs();
        sizes.iter().any(|right| values.iter().zip(right).all(|(value, right)| near(value, right)))
    }

    fn spheres(&self, sphere: Option<Sphere>) -> Vec<Sphere> {
        sphere.map_or(Sphere::BOTH.to_vec(), |sphere| vec![sphere])
    }

    /// `p² + v²`, with one component that is across the line and one along it.
    pub(in crate::mark::working) fn is_pythagoras(&self, expr: &Expr, sphere: Option<Sphere>) -> bool {
        let Some((one, other)) = two_squares(expr) else { return false };
        let is_bare = matches!(expr, Expr::Sum(terms) if are_bare(terms));
        let are = |across: &Expr, along: &Expr| match is_bare {
            true => self.spheres(sphere).into_iter().any(|of| self.are_known_components(across, along, of)),
            false => self.are_components(across, along, sphere),
        };
        are(&one, &other) || are(&other, &one)
    }

    fn are_components(&self, across: &Expr, along: &Expr, sphere: Option<Sphere>) -> bool {
        self.spheres(sphere).into_iter().any(|of| {
            let own = self.theirs.values.contains_key(&Quantity::Velocity(of, Moment::After, Axis::N));
            // A velocity before that was to be found is as good as one after, right or the student's own.
            let in_i_j = [Axis::X, Axis::Y].map(|axis| {
                let before = Quantity::Velocity(of, Moment::Before, axis);
                let mut all = self.sizes_of(of, axis);
                all.extend(self.theirs.values.get(&before).map(|(values, _)| values.clone()));
                let is_given = self.prepared.given[0].0.contains_key(&before);
                all.extend(sizes(&self.prepared.known, before).filter(|_| !is_given));
                all
            });
            let is = |expr: &Expr, sizes: &[Vec<f64>]| self.is_one_of(expr, sizes) || self.rounds_one_of(expr, sizes);
            let along_fits = match own {
                true => is(along, &self.sizes_of(of, Axis::N)),
                // Nowhere said what the component is: this says it.
                false => self.values_of(along).is_some(),
            };
            (is(across, &self.sizes_of(of, Axis::T)) && along_fits)
                || (self.is_in_vectors() && is(across, &in_i_j[0]) && is(along, &in_i_j[1]))
        })
    }

    /// Two figures are enough to see which number was rounded: `7.1` for 2.67².
    pub(in crate::mark::working) fn rounds_one_of(&self, expr: &Expr, sizes: &[Vec<f64>]) -> bool {
        let at = |(point, size): (usize, &f64)| {
            let context = Context { given: &self.names, rounded_from: 2, ..context(self.prepared, point) };
            constant(expr, &context).is_some_and(|own| own.absolute().may_be(size.abs()))
        };
        sizes.iter().any(|right| right.iter().enumerate().all(at))
    }

    /// `p/v`.
    fn is_tangent(&self, expr: &Expr, sphere: Option<Sphere>) -> bool {
        let are = |above: &Expr, below: &Expr| {
            self.are_components(above, below, sphere) || self.are_components_of_impulse(above, below)
        };
        matches!(expr, Expr::Quotient(above, below) if are(above, below))
    }

    /// Both components of the impulse on a particle, right or the student's own, in either order.
    fn are_components_of_impulse(&self, one: &Expr, other: &Expr) -> bool {
        let of = |axis| {
            let quantity = Quantity::Impulse(Sphere::A, axis);
            let own = self.theirs.values.get(&quantity).map(|(values, _)| values.clone());
            let both = sizes(&self.prepared.known, quantity).into_iter().chain(own);
            both.collect::<Vec<_>>()
        };
        let is = |expr: &Expr, axis| self.is_one_of(expr, &of(axis));
        self.prepared.setting == Setting::Impulse
            && (is(one, Axis::X) && is(other, Axis::Y) || is(one, Axis::Y) && is(other, Axis::X))
    }

    /// What the tangent of an angle that is not given is in `x tan β = u sin α` or `x = u sin α/tan β`.
    fn tangent_in(&self, (left, right): &(Expr, Expr)) -> Option<Expr> {
        let is_tangent = |expr: &Expr| matches!(expr, Expr::Call(Function::Tan, _)) && self.values_of(expr).is_none();
        let of = |side: &Expr, other: &Expr| match side {
            Expr::Quotient(above, below) if is_tangent(below) => Some((**above).clone().over(other.clone())),
            Expr::Product(factors) => {
                let at = factors.iter().position(is_tangent)?;
                let rest = factors.iter().enumerate().filter(|(place, _)| *place != at);
                Some(other.clone().over(Expr::product(rest.map(|(_, factor)| factor.clone()))))
            }
            _ => None,
        };
        of(left, right).or_else(|| of(right, left))
    }

    /// `v/p`.
    fn is_cotangent(&self, expr: &Expr, sphere: Option<Sphere>) -> bool {
        matches!(expr, Expr::Quotient(above, below) if self.are_components(below, above, sphere))
    }

    /// Does a line call `v/p` a tangent, where the result says which angle it is of?
    fn is_upside_down(&self, line: usize, sphere: Option<Sphere>) -> bool {
        let is_tangent = |member: &&Member| member.label.as_ref().is_some_and(|label| label.trim().starts_with("tan"));
        let mut members = self.lines[line].reading.iter().flat_map(|reading| &reading.members).filter(is_tangent);
        self.part.blanks.iter().any(|blank| blank.model.kind == Kind::Shown)
            && members.any(|member| any_within(&member.expr, &|inner| self.is_cotangent(inner, sphere)))
    }

    /// The cosine of a deflection by a scalar product: something over the product of the speeds before and after.
    pub(super) fn scalar_quotient(&self, law: Law) -> Option<Evidence> {
        let speeds: Vec<Vec<f64>> = Sphere::BOTH
            .into_iter()
            .filter_map(|sphere| {
                let of = |known, moment| sizes(known, Quantity::Speed(sphere, moment));
                let before = of(&self.prepared.known, Moment::Before)?;
                let found = self.prepared.all_where_found().unwrap_or_default();
                let after = [&self.prepared.known, &self.followed, &found].map(|known| of(known, Moment::After));
                let product =
                    |after: Vec<f64>| before.iter().zip(after).map(|(before, after)| before * after).collect();
                let after = after.into_iter().flatten().filter(|after| !after.is_empty());
                Some(after.map(product).collect::<Vec<Vec<f64>>>())
            })
            .flatten()
            .collect();
        // Speeds of two figures are enough to see what stands below.
        let is_product = |below: &Expr| self.is_near_one_of(below, &speeds) || self.rounds_one_of(below, &speeds);
        let is_quotient = |inner: &Expr| matches!(inner, Expr::Quotient(_, below) if is_product(below));
        let line = self.lines.iter().position(|studied| {
            self.members(studied).any(|(member, _)| {
                let is_cosine = member.label.as_ref().is_some_and(|label| label.trim_start().starts_with("cos"));
                let has_inverse =
                    |inner: &Expr| matches!(inner, Expr::Call(Function::Acos, of) if any_within(of, &is_quotient));
                is_cosine && any_within(&member.expr, &is_quotient) || any_within(&member.expr, &has_inverse)
            })
        })?;
        Some(Evidence::given(line, law.name()))
    }
}

/// Is it called the tangent of an angle?
pub(super) fn is_tangent(member: &Member) -> bool {
    member.label.as_ref().is_some_and(|label| label.trim().starts_with("tan"))
}

/// The formulas within one that stand where a component of a velocity does: squared, or over another within a tangent.
pub(super) fn components_in(expr: &Expr, in_tangent: bool) -> Vec<Expr> {
    let mut all = Vec::new();
    match expr {
        Expr::Quotient(above, below) if in_tangent => all.extend([(**above).clone(), (**below).clone()]),
        // A number is a square only beside another: not in `4 - 2`.
        Expr::Sum(terms) if terms.len() == 2 && !are_bare(terms) => {
            let bases: Vec<Expr> = terms.iter().filter_map(base_of_square).collect();
            let has_figure = terms.iter().any(|term| are_bare(std::slice::from_ref(term)));
            all.extend(bases.into_iter().filter(|_| !has_figure || terms.iter().all(is_square)));
        }
        _ => all.extend(base_of_square(expr).filter(|_| matches!(expr, Expr::Power(..)))),
    }
    let in_tangent = matches!(expr, Expr::Call(Function::Atan, _));
    all.extend(expr.children().into_iter().flat_map(|child| components_in(child, in_tangent)));
    all
}

/// May it be a term of Pythagoras?
fn is_square(term: &Expr) -> bool {
    base_of_square(term).is_some()
}

/// Are they numbers as they stand?
pub(in crate::mark::working) fn are_bare(terms: &[Expr]) -> bool {
    terms.iter().all(|term| matches!(term, Expr::Number(_) | Expr::Decimal(_)))
}

/// What the two terms of Pythagoras are the squares of.
pub(super) fn two_squares(expr: &Expr) -> Option<(Expr, Expr)> {
    let Expr::Sum(terms) = expr else { return None };
    let [one, other] = terms.as_slice() else { return None };
    base_of_square(one).zip(base_of_square(other))
}

/// What a term of Pythagoras is the square of; a number alone is a square that has been worked out.
fn base_of_square(term: &Expr) -> Option<Expr> {
    match term {
        Expr::Power(..) => squared(term).cloned(),
        Expr::Number(_) | Expr::Decimal(_) => Some(Expr::call(Function::Sqrt, term.clone())),
        Expr::Product(_) => Some(Expr::call(Function::Sqrt, term.clone())),
        Expr::Quotient(..) if !is_lettered(term) => Some(Expr::call(Function::Sqrt, term.clone())),
        _ => None,
    }
}

fn is_lettered(expr: &Expr) -> bool {
    !expr.names().is_empty()
}
