//! Marks for everything but the two equations: a law has been used where a line shows what it gives.
//!
//! What a law gives is known from the derivation, evaluated from right values and from the student's own. A line that
//! comes to it, in a formula or under a name, has used the law; its sign is condoned. Besides that a few laws are known by
//! their form, so that a slip of the calculator costs no method mark.

use super::examine::{Studied, Value, Working};
use super::points::sizes;
use super::spread::Spread;
use crate::answer::Kind;
use crate::bank::Code;
use crate::expr::{Expr, Function};
use crate::mark::judging::{Model, Verdict, judge};
use crate::mark::key::KeyedMark;
use crate::mark::reading::{Reading, Statement, Vocabulary};
use crate::mechanics::{Axis, Datum, Known, Law, Moment, Quantity, Sphere};
use crate::number::Value as Exact;

/// What a line shows of a mark.
pub(super) struct Evidence {
    /// The place of the line.
    pub(super) line: usize,
    pub(super) given: bool,
    pub(super) note: Option<&'static str>,
    pub(super) feedback: String,
    /// What the line is.
    pub(super) role: String,
}

impl Evidence {
    fn given(line: usize, role: impl Into<String>) -> Evidence {
        Evidence { line, given: true, note: None, feedback: String::new(), role: role.into() }
    }

    fn followed(line: usize, role: impl Into<String>) -> Evidence {
        let feedback = "followed through from your own values".to_owned();
        Evidence { note: Some("follow-through"), feedback, ..Evidence::given(line, role) }
    }
}

/// Quantities whose value anywhere in the lines shows that a law was used.
fn shown_by(law: Law, sphere: Option<Sphere>) -> Vec<Quantity> {
    use Moment::{After, Before};
    let spheres = || Sphere::BOTH.into_iter().filter(move |of| sphere.is_none_or(|sphere| sphere == *of));
    match law {
        Law::Speed => spheres().map(|of| Quantity::Speed(of, After)).collect(),
        Law::Direction => {
            spheres().flat_map(|of| [Quantity::AngleToLine(of, After), Quantity::TOverN(of, After)]).collect()
        }
        Law::Deflection => spheres()
            .flat_map(|of| [Quantity::Deflection(of), Quantity::TanDeflection(of), Quantity::DeflectionDot(of)])
            .collect(),
        Law::Energy => vec![Quantity::EnergyLost, Quantity::FractionLost, Quantity::TotalEnergy(Before)],
        Law::Impulse => {
            let mut all: Vec<Quantity> = spheres().map(|of| Quantity::Impulse(of, Axis::N)).collect();
            all.push(Quantity::ImpulseMagnitude);
            all
        }
        Law::Contact => vec![Quantity::ContactSine],
        Law::Restitution => vec![Quantity::Restitution],
        _ => Vec::new(),
    }
}

impl Working<'_> {
    /// A mark for the use of a law.
    pub(super) fn by_law(&self, law: Law, sphere: Option<Sphere>, code: Code) -> Option<Evidence> {
        match law {
            Law::Perpendicular => self.unchanged(),
            Law::VectorMomentum => self.vector_momentum(code),
            Law::LineOfCentres | Law::Impulse if self.is_in_vectors() => self.along_impulse(law),
            Law::Resolve => self.resolved(code),
            Law::Restitution => self.restitution_from_components(),
            _ => self.by_value(law, sphere, code).or_else(|| self.by_form(law, sphere, code)),
        }
    }

    /// A line that comes to what the law gives: from right values, or from the student's own.
    fn by_value(&self, law: Law, sphere: Option<Sphere>, code: Code) -> Option<Evidence> {
        let follows = !code.is_accuracy() || code == Code::A1FollowThrough;
        let quantities = shown_by(law, sphere);
        for (known, own) in [(&self.prepared.known, false), (&self.followed, true)] {
            if own && !follows {
                continue;
            }
            for quantity in &quantities {
                if let Some(line) = self.line_that_is(known, *quantity, law) {
                    let role = law.name();
                    return Some(if own { Evidence::followed(line, role) } else { Evidence::given(line, role) });
                }
            }
        }
        None
    }

    /// The first line with a member of this value; a bare number does only if the line calls it something.
    fn line_that_is(&self, known: &[Known<f64>], quantity: Quantity, law: Law) -> Option<usize> {
        let is_angle = matches!(known[0].0.get(&quantity)?, Datum::Direction { .. });
        let right = sizes(known, quantity)?;
        if right.iter().any(|size| !size.is_finite()) {
            return None;
        }
        self.lines.iter().position(|studied| {
            studied.matched.is_empty()
                && !self.is_printed_result(studied)
                && self.members(studied).any(|(member, values)| {
                    let worth = member.label.is_some() || is_composite(&member.expr);
                    // The unknowns of the two equations have their own marks.
                    let taken =
                        member.letter.as_ref().is_some_and(|letter| self.is_unknown(letter)) && law != Law::Speed;
                    worth
                        && !taken
                        && values.iter().zip(&right).all(|(value, right)| comes_to(*value, *right, is_angle))
                })
        })
    }

    fn members<'s>(&self, studied: &'s Studied) -> impl Iterator<Item = (&'s super::line::Member, &'s Vec<Value>)> {
        let members = studied.reading.as_ref().map(|reading| reading.members.as_slice()).unwrap_or_default();
        members.iter().zip(&studied.values).filter_map(|(member, values)| Some((member, values.as_ref()?)))
    }

    fn is_unknown(&self, letter: &str) -> bool {
        self.convention.as_ref().is_some_and(|convention| convention.letters.iter().any(|known| known == letter))
    }

    /// Is the line what was to be shown, written once more?
    fn is_printed_result(&self, studied: &Studied) -> bool {
        let Some(reading) = &studied.reading else { return false };
        let results =
            self.part.scheme.iter().filter(|mark| mark.code == Code::A1Shown).filter_map(|mark| mark.equation.as_ref());
        let mut results = results.peekable();
        results.peek().is_some()
            && results.any(|result| {
                let Expr::Relation(left, _, right) = result else { return false };
                reading.equations.iter().any(|equation| equation.0 == **left && self.same_at_points(&equation.1, right))
            })
            && reading.equations.len() == 1
    }

    fn same_at_points(&self, one: &Expr, other: &Expr) -> bool {
        (0..self.prepared.points.count).all(|point| {
            let context = super::examine::context(self.prepared, point);
            let value = |expr| super::linear::constant(expr, &context);
            matches!((value(one), value(other)), (Some(one), Some(other)) if (one - other).may_be_nought(1.0))
        })
    }

    fn is_in_vectors(&self) -> bool {
        !self.prepared.given[0].0.contains_key(&Quantity::Line(Axis::X))
            && !self.prepared.given[0].0.contains_key(&Quantity::ContactSine)
    }

    /// The components across the line of centres, of every sphere that has one, seen.
    fn unchanged(&self) -> Option<Evidence> {
        let across: Vec<Vec<f64>> = Sphere::BOTH
            .into_iter()
            .filter_map(|sphere| sizes(&self.prepared.known, Quantity::Velocity(sphere, Moment::Before, Axis::T)))
            .filter(|sizes| sizes.iter().any(|size| size.abs() > 1e-9))
            .collect();
        let seen = |right: &Vec<f64>| self.lines.iter().position(|studied| self.shows_component(studied, right));
        let places: Option<Vec<usize>> = across.iter().map(seen).collect();
        let last = places?.into_iter().max()?;
        Some(Evidence::given(last, "the component perpendicular to the line of centres"))
    }

    /// Does a line show this component: as a value, in Pythagoras, in a tangent, or in a vector?
    fn shows_component(&self, studied: &Studied, right: &[f64]) -> bool {
        let is_right =
            |values: &[Value]| values.iter().zip(right).all(|(value, right)| comes_to(*value, *right, false));
        let in_vector = |values: &[Value]| {
            values.iter().zip(right).all(|(value, right)| match value {
                Value::Vector(x, y) => x.absolute().may_be(right.abs()) || y.absolute().may_be(right.abs()),
                Value::Number(_) => false,
            })
        };
        let whole = studied.matched.is_empty()
            && self.members(studied).any(|(member, values)| {
                let named = member.label.is_some() || is_composite(&member.expr);
                let unknown = member.letter.as_ref().is_some_and(|letter| self.is_unknown(letter));
                (named && !unknown && is_right(values)) || in_vector(values)
            });
        if whole {
            return true;
        }
        let Some(reading) = &studied.reading else { return false };
        let formulas = reading.members.iter().filter(|_| studied.matched.is_empty()).map(|member| &member.expr);
        formulas.flat_map(components_in).any(|expr| self.values_of(&expr).is_some_and(|values| is_right(&values)))
    }

    fn values_of(&self, expr: &Expr) -> Option<Vec<Value>> {
        let at = |point| {
            let context = self.context(point);
            super::linear::constant(expr, &context).map(Value::Number)
        };
        (0..self.prepared.points.count).map(at).collect()
    }

    /// A law known by its form.
    fn by_form(&self, law: Law, sphere: Option<Sphere>, code: Code) -> Option<Evidence> {
        if code.is_accuracy() {
            return None;
        }
        let has_form = |expr: &Expr| match law {
            Law::Speed => any_within(expr, &|inner| self.is_pythagoras(inner, sphere)),
            Law::Direction => any_within(expr, &|inner| self.is_tangent(inner, sphere)),
            Law::Energy => is_energy_difference(expr),
            Law::Impulse => any_within(expr, &|inner| self.is_change_of_momentum(inner)),
            _ => false,
        };
        let line = self.lines.iter().position(|studied| {
            let members = studied.reading.as_ref().map(|reading| reading.members.as_slice()).unwrap_or_default();
            studied.matched.is_empty() && members.iter().any(|member| has_form(&member.expr))
        })?;
        Some(Evidence::given(line, law.name()))
    }

    /// The sizes that a component after the impact may have: the right one, the student's own, and across the line also
    /// what the exchange of sine and cosine makes of it.
    fn sizes_of(&self, sphere: Sphere, axis: Axis) -> Vec<Vec<f64>> {
        let mut all = Vec::new();
        let quantity = Quantity::Velocity(sphere, Moment::After, axis);
        all.extend(sizes(&self.prepared.known, quantity));
        all.extend(self.theirs.0.get(&quantity).map(|(values, _)| values.clone()));
        if axis == Axis::T {
            all.extend(sizes(&self.prepared.known, Quantity::Velocity(sphere, Moment::Before, Axis::N)));
        }
        all
    }

    fn is_one_of(&self, expr: &Expr, sizes: &[Vec<f64>]) -> bool {
        let Some(values) = self.values_of(expr) else { return false };
        sizes.iter().any(|right| values.iter().zip(right).all(|(value, right)| comes_to(*value, *right, false)))
    }

    fn spheres(&self, sphere: Option<Sphere>) -> Vec<Sphere> {
        sphere.map_or(Sphere::BOTH.to_vec(), |sphere| vec![sphere])
    }

    /// `p² + v²`, with one component that is across the line and one along it.
    fn is_pythagoras(&self, expr: &Expr, sphere: Option<Sphere>) -> bool {
        let Expr::Sum(terms) = expr else { return false };
        let [one, other] = terms.as_slice() else { return false };
        let Some((one, other)) = base_of_square(one).zip(base_of_square(other)) else { return false };
        self.are_components(&one, &other, sphere) || self.are_components(&other, &one, sphere)
    }

    fn are_components(&self, across: &Expr, along: &Expr, sphere: Option<Sphere>) -> bool {
        self.spheres(sphere).into_iter().any(|of| {
            let own = self.theirs.0.contains_key(&Quantity::Velocity(of, Moment::After, Axis::N));
            let in_i_j = [Axis::X, Axis::Y].map(|axis| self.sizes_of(of, axis));
            let along_fits = match own {
                true => self.is_one_of(along, &self.sizes_of(of, Axis::N)),
                // Nowhere said what the component is: this says it.
                false => self.values_of(along).is_some(),
            };
            (self.is_one_of(across, &self.sizes_of(of, Axis::T)) && along_fits)
                || (self.is_one_of(across, &in_i_j[0]) && self.is_one_of(along, &in_i_j[1]))
        })
    }

    /// `p/v` or `v/p`.
    fn is_tangent(&self, expr: &Expr, sphere: Option<Sphere>) -> bool {
        let Expr::Quotient(above, below) = expr else { return false };
        self.are_components(above, below, sphere) || self.are_components(below, above, sphere)
    }

    /// `m(v - u)` for one of the spheres.
    fn is_change_of_momentum(&self, expr: &Expr) -> bool {
        let Expr::Product(factors) = expr else { return false };
        let [mass, change] = factors.as_slice() else { return false };
        let Expr::Sum(terms) = change else { return false };
        let masses: Vec<Vec<f64>> =
            Sphere::BOTH.into_iter().filter_map(|sphere| sizes(&self.prepared.known, Quantity::Mass(sphere))).collect();
        terms.len() == 2 && self.is_one_of(mass, &masses)
    }

    /// Momentum as a vector: an equation with the velocity that is to be found.
    fn vector_momentum(&self, code: Code) -> Option<Evidence> {
        let unknown = Sphere::BOTH.into_iter().find(|sphere| {
            !self.prepared.given[0].0.contains_key(&Quantity::Velocity(*sphere, Moment::After, Axis::X))
        })?;
        let right = |axis| sizes(&self.prepared.known, Quantity::Velocity(unknown, Moment::After, axis));
        let (x, y) = right(Axis::X).zip(right(Axis::Y))?;
        let mut method = None;
        for (place, studied) in self.lines.iter().enumerate() {
            let Some(reading) = &studied.reading else { continue };
            // The velocity itself, or a multiple of it, is what the equation leads to.
            let is_velocity = self.members(studied).any(|(_, values)| is_vector(values, &x, &y, 1.0));
            if is_velocity || reading.equations.iter().any(|equation| self.solves_to(equation, &x, &y)) {
                return Some(Evidence::given(place, "momentum as a vector"));
            }
            let is_method = reading.equations.iter().any(|equation| self.is_momentum_of_vectors(equation));
            if is_method && method.is_none() {
                method = Some(place);
            }
        }
        let place = method?;
        let feedback = "a sign or a number in it is wrong".to_owned();
        match code.is_accuracy() {
            false => Some(Evidence::given(place, "momentum as a vector")),
            true => Some(Evidence {
                given: false,
                note: Some("sign-error"),
                feedback,
                ..Evidence::given(place, "momentum as a vector")
            }),
        }
    }

    /// Is the equation true when the unknown is this vector?
    fn solves_to(&self, (left, right): &(Expr, Expr), x: &[f64], y: &[f64]) -> bool {
        (0..self.prepared.points.count).all(|point| {
            let context = super::examine::context(self.prepared, point);
            let Some(super::linear::Sum::Vector(along_i, along_j)) = super::linear::difference(left, right, &context)
            else {
                return false;
            };
            let [(name, number)] = along_i.unknowns.as_slice() else { return false };
            let holds = |linear: &super::linear::Linear, value: f64| {
                let total = linear.before(name) * Spread::exactly(value) + linear.constant;
                total.may_be_nought(linear.size.max((number.middle() * value).abs()))
            };
            holds(&along_i, x[point]) && holds(&along_j, y[point])
        })
    }

    /// Is it such an equation but for signs: the right mass before the unknown, and all three known momenta?
    fn is_momentum_of_vectors(&self, (left, right): &(Expr, Expr)) -> bool {
        let context = super::examine::context(self.prepared, 0);
        let Some(super::linear::Sum::Vector(along_i, along_j)) = super::linear::difference(left, right, &context)
        else {
            return false;
        };
        let [(_, number)] = along_i.unknowns.as_slice() else { return false };
        let known = &self.prepared.known[0..1];
        let at = |quantity| sizes(known, quantity).map(|sizes| sizes[0]);
        let momentum =
            |sphere, moment, axis| Some(at(Quantity::Mass(sphere))? * at(Quantity::Velocity(sphere, moment, axis))?);
        Sphere::BOTH.into_iter().any(|unknown| {
            let (Some(mass), other) = (at(Quantity::Mass(unknown)), unknown.other()) else { return false };
            let scale = number.middle() / mass;
            let fits = |axis: Axis, constant: Spread| -> Option<Vec<[f64; 3]>> {
                let terms = [
                    momentum(Sphere::A, Moment::Before, axis)?,
                    momentum(Sphere::B, Moment::Before, axis)?,
                    momentum(other, Moment::After, axis)?,
                ];
                let signs = (0..8).map(|bits| [0, 1, 2].map(|bit| if bits >> bit & 1 == 1 { -1.0 } else { 1.0 }));
                let sum =
                    |signs: &[f64; 3]| signs.iter().zip(&terms).map(|(sign, term)| sign * term * scale).sum::<f64>();
                Some(signs.filter(|signs| constant.may_be(sum(signs))).collect())
            };
            let (Some(one), Some(two)) = (fits(Axis::X, along_i.constant), fits(Axis::Y, along_j.constant)) else {
                return false;
            };
            one.iter().any(|signs| two.contains(signs))
        })
    }

    /// A change of momentum or of velocity, which is along the line of centres.
    fn along_impulse(&self, law: Law) -> Option<Evidence> {
        let line = |axis| sizes(&self.prepared.known, Quantity::Line(axis));
        let (x, y) = line(Axis::X).zip(line(Axis::Y))?;
        let place = self
            .lines
            .iter()
            .position(|studied| self.members(studied).any(|(_, values)| is_parallel(values, &x, &y)))?;
        Some(Evidence::given(place, law.name()))
    }

    /// Components along the line of centres; a factor that all have in common does not matter.
    fn resolved(&self, code: Code) -> Option<Evidence> {
        let quantities = Sphere::BOTH.into_iter().flat_map(|sphere| {
            [Moment::Before, Moment::After].map(|moment| Quantity::Velocity(sphere, moment, Axis::N))
        });
        let right: Vec<Vec<f64>> = quantities
            .filter_map(|quantity| sizes(&self.prepared.known, quantity))
            .filter(|sizes| sizes.iter().any(|size| size.abs() > 1e-9))
            .collect();
        let mut best: Option<(usize, usize)> = None;
        for scale in self.scales() {
            let seen = |right: &Vec<f64>| {
                self.lines.iter().position(|studied| {
                    let Some(reading) = &studied.reading else { return false };
                    let formulas = reading.members.iter().flat_map(|member| parts_of(&member.expr));
                    let scaled: Vec<f64> = right.iter().map(|right| right * scale).collect();
                    formulas.into_iter().any(|expr| self.is_one_of(expr, std::slice::from_ref(&scaled)))
                })
            };
            let places: Vec<usize> = right.iter().filter_map(seen).collect();
            if places.len() > best.map_or(0, |(count, _)| count) {
                best = Some((places.len(), places.into_iter().max().unwrap_or(0)));
            }
        }
        let (count, place) = best?;
        let enough = if code.is_accuracy() { count == right.len() } else { count >= 2.min(right.len()) };
        enough.then(|| Evidence::given(place, "components along the line of centres"))
    }

    /// By how much a student's vector along the line of centres may be longer than the unit vector.
    fn scales(&self) -> Vec<f64> {
        let line = |axis| sizes(&self.prepared.known, Quantity::Line(axis));
        let Some((x, y)) = line(Axis::X).zip(line(Axis::Y)) else { return vec![1.0] };
        let mut scales = vec![1.0];
        for studied in &self.lines {
            for (_, values) in self.members(studied).filter(|(_, values)| is_parallel(values, &x, &y)) {
                if let Some(Value::Vector(x, y)) = values.first() {
                    scales.push(x.middle().hypot(y.middle()));
                }
            }
        }
        let smallest = [x[0], y[0]].into_iter().map(f64::abs).filter(|size| *size > 1e-9).fold(f64::INFINITY, f64::min);
        // The shortest with whole components is what students use.
        scales.extend((1..=6).map(|whole| f64::from(whole) / smallest));
        scales
    }

    /// e as a quotient of two differences of components, whatever their signs.
    fn restitution_from_components(&self) -> Option<Evidence> {
        let at =
            |sphere, moment| sizes(&self.prepared.known, Quantity::Velocity(sphere, moment, Axis::N)).map(|s| s[0]);
        let [a, b] = Sphere::BOTH.map(|sphere| at(sphere, Moment::Before));
        let [x, y] = Sphere::BOTH.map(|sphere| at(sphere, Moment::After));
        let (a, b, x, y) = (a?, b?, x?, y?);
        let scales = self.scales();
        let is = |expr: &Expr, sizes: [f64; 2]| {
            let candidates: Vec<Vec<f64>> =
                scales.iter().flat_map(|scale| sizes.map(|size| vec![size * scale])).collect();
            self.is_one_of(expr, &candidates)
        };
        let is_quotient = |expr: &Expr| match expr {
            Expr::Quotient(above, below) => is(above, [y - x, y + x]) && is(below, [a - b, a + b]),
            _ => false,
        };
        let line = self.lines.iter().position(|studied| {
            let Some(reading) = &studied.reading else { return false };
            reading.members.iter().any(|member| any_within(&member.expr, &is_quotient))
        })?;
        Some(Evidence::given(line, "restitution"))
    }

    /// A line that holds only because of what is given of the motion after the impact.
    pub(super) fn uses_condition(&self, mark: &KeyedMark) -> Option<Evidence> {
        if mark.code.is_accuracy() {
            return None;
        }
        let line = self.lines.iter().position(|studied| {
            let Some(reading) = &studied.reading else { return false };
            !self.is_printed_result(studied)
                && studied.matched.is_empty()
                && reading.equations.iter().any(|equation| self.holds_only_where_found(equation))
        })?;
        Some(Evidence::given(line, "uses what is given of the motion after the impact"))
    }

    fn holds_only_where_found(&self, (left, right): &(Expr, Expr)) -> bool {
        let mut held = 0;
        for point in 0..self.prepared.points.count {
            let Some(there) = self.prepared.where_found(point) else { continue };
            let at = |quantity| Some(vec![there.number(quantity)?; self.prepared.points.count]);
            let names = self.names(&at);
            let points = self.prepared.points.with(&self.prepared.found, point);
            let context = super::linear::Context {
                points: &points,
                given: &names,
                ..super::examine::context(self.prepared, point)
            };
            let Some(difference) = super::linear::difference(left, right, &context) else { return false };
            let super::linear::Sum::Number(linear) = difference else { return false };
            if !linear.is_number() || !linear.constant.may_be_nought(linear.size * 100.0) {
                return false;
            }
            held += 1;
        }
        // And not everywhere: an identity says nothing.
        held > 0 && !(0..self.prepared.points.count).all(|point| self.holds_at(left, right, point))
    }

    fn holds_at(&self, left: &Expr, right: &Expr, point: usize) -> bool {
        let names = self.names(&|quantity| sizes(&self.prepared.known, quantity));
        let context = super::linear::Context { given: &names, ..super::examine::context(self.prepared, point) };
        match super::linear::difference(left, right, &context) {
            Some(super::linear::Sum::Number(linear)) => {
                linear.is_number() && linear.constant.may_be_nought(linear.size)
            }
            _ => false,
        }
    }

    /// A mark for a value: a line states it, with the figures that are asked for.
    pub(super) fn value_of(&self, quantity: Quantity, code: Code, mark: &KeyedMark) -> Option<Evidence> {
        if let Some(Expr::Vector(..)) = mark.equation.as_ref().map(right_side) {
            return self.vector_of(quantity);
        }
        let along = along_for(quantity, self.prepared);
        let letter = self.convention.as_ref().and_then(|convention| {
            let place = Sphere::BOTH
                .into_iter()
                .position(|sphere| along == Quantity::Velocity(sphere, Moment::After, Axis::N))?;
            Some((convention.letters[place].clone(), convention.signs[place]))
        });
        let sign = letter.as_ref().map_or(1.0, |(_, sign)| *sign);
        let model = self.model_of(along, sign)?;
        for (place, studied) in self.lines.iter().enumerate() {
            let Some(reading) = &studied.reading else { continue };
            for statement in &reading.statements {
                let named = statement.label.as_ref().and_then(|label| label.expr.as_ref());
                let is_named = match (&letter, named) {
                    (Some((letter, _)), Some(Expr::Name(name))) => name.text == *letter,
                    (Some(_), _) => false,
                    (None, _) => statement.label.is_some() || statement.said.len() > 1,
                };
                if !is_named {
                    continue;
                }
                let verdict = |statement: Statement| {
                    let reading = Reading { statements: vec![statement], printed: String::new(), decided: Vec::new() };
                    judge(&model, &Ok(vec![reading])).verdict
                };
                let mut end = statement.clone();
                end.said.drain(..end.said.len().saturating_sub(1));
                // A right formula that is worked out wrongly is no right value.
                if verdict(statement.clone()) == Verdict::Correct && verdict(end) != Verdict::Wrong {
                    return Some(Evidence::given(place, format!("{quantity}")));
                }
            }
        }
        if code == Code::A1FollowThrough {
            let line = self.line_that_is(&self.followed, quantity, Law::Speed)?;
            return Some(Evidence::followed(line, format!("{quantity}")));
        }
        None
    }

    fn vector_of(&self, quantity: Quantity) -> Option<Evidence> {
        let Quantity::Velocity(sphere, moment, _) = quantity else { return None };
        let at = |axis| sizes(&self.prepared.known, Quantity::Velocity(sphere, moment, axis));
        let (x, y) = at(Axis::X).zip(at(Axis::Y))?;
        let line = self
            .lines
            .iter()
            .position(|studied| self.members(studied).any(|(_, values)| is_vector(values, &x, &y, 1.0)))?;
        Some(Evidence::given(line, format!("the velocity of {}", sphere.name())))
    }

    /// The model answer for a quantity, in the student's direction.
    fn model_of(&self, quantity: Quantity, sign: f64) -> Option<Model> {
        let mut known = self.part.known.clone();
        crate::mechanics::Derivation::carry_out(&mut known, &[quantity]);
        let (value, kind) = match known.0.get(&quantity)? {
            Datum::Number(value) => {
                let value = if sign < 0.0 { &Exact::ZERO - value } else { value.clone() };
                let kind = if value.is_constant() { Kind::Number } else { Kind::Expression };
                (crate::expr::written(&value), kind)
            }
            Datum::Direction { y, x } => (crate::expr::written_angle(&crate::number::Angle::of(y, x)?), Kind::Angle),
            Datum::Equation(_) => return None,
        };
        let figures = crate::number::Places::SignificantFigures(3);
        let accept = crate::answer::Accept::RoundsTo(figures);
        let vocabulary = Vocabulary { letters: self.question.letters.clone(), vectors: false };
        Some(Model::new(value, kind, accept, vocabulary))
    }
}

/// The component along the line of centres that a component along i or j is, where the line is parallel to it.
fn along_for(quantity: Quantity, prepared: &super::Prepared) -> Quantity {
    match quantity {
        Quantity::Velocity(sphere, moment, axis @ (Axis::X | Axis::Y)) => {
            let along =
                sizes(&prepared.known, Quantity::Line(axis)).is_some_and(|line| (line[0].abs() - 1.0).abs() < 1e-12);
            if along { Quantity::Velocity(sphere, moment, Axis::N) } else { quantity }
        }
        other => other,
    }
}

fn right_side(expr: &Expr) -> &Expr {
    match expr {
        Expr::Relation(_, _, right) => right,
        other => other,
    }
}

/// Does the value come to this, whatever its sign? An angle may be in degrees or radians, its complement, or its tangent.
fn comes_to(value: Value, right: f64, is_angle: bool) -> bool {
    let Value::Number(spread) = value else { return false };
    let size = spread.absolute();
    if !is_angle {
        return size.may_be(right.abs());
    }
    let degrees = right.abs();
    let tangent = degrees.to_radians().tan().abs();
    let angles = [degrees, 90.0 - degrees, degrees.to_radians(), (90.0 - degrees).to_radians(), tangent, 1.0 / tangent];
    angles.into_iter().any(|angle| angle.is_finite() && size.may_be(angle.abs()))
}

fn is_vector(values: &[Value], x: &[f64], y: &[f64], scale: f64) -> bool {
    values.iter().zip(x.iter().zip(y)).all(|(value, (x, y))| match value {
        Value::Vector(along_i, along_j) => along_i.may_be(x * scale) && along_j.may_be(y * scale),
        Value::Number(_) => false,
    })
}

fn is_parallel(values: &[Value], x: &[f64], y: &[f64]) -> bool {
    values.iter().zip(x.iter().zip(y)).all(|(value, (x, y))| match value {
        Value::Vector(along_i, along_j) => {
            let cross = *along_i * Spread::exactly(*y) - *along_j * Spread::exactly(*x);
            let size = along_i.absolute().high + along_j.absolute().high;
            size > 0.0 && cross.may_be_nought(size)
        }
        Value::Number(_) => false,
    })
}

/// Is it more than a number as it stands?
fn is_composite(expr: &Expr) -> bool {
    match expr {
        Expr::Number(_) | Expr::Decimal(_) | Expr::Name(_) => false,
        Expr::Negative(inner) | Expr::Degrees(inner) => is_composite(inner),
        _ => true,
    }
}

fn any_within(expr: &Expr, is: &dyn Fn(&Expr) -> bool) -> bool {
    is(expr) || expr.children().into_iter().any(|child| any_within(child, is))
}

/// The formula and all that is added up in it.
fn parts_of(expr: &Expr) -> Vec<&Expr> {
    let mut all = vec![expr];
    match expr {
        Expr::Sum(_) | Expr::Quotient(..) | Expr::Negative(_) => {
            all.extend(expr.children().into_iter().flat_map(parts_of));
        }
        _ => {}
    }
    all
}

/// The formulas within one that stand where a component of a velocity does: squared, or over another.
fn components_in(expr: &Expr) -> Vec<Expr> {
    let mut all = Vec::new();
    match expr {
        Expr::Quotient(above, below) => all.extend([(**above).clone(), (**below).clone()]),
        Expr::Sum(terms) if terms.len() == 2 => all.extend(terms.iter().filter_map(base_of_square)),
        _ => all.extend(base_of_square(expr).filter(|_| matches!(expr, Expr::Power(..)))),
    }
    all.extend(expr.children().into_iter().flat_map(components_in));
    all
}

/// What a term of Pythagoras is the square of; a number alone is a square that has been worked out.
fn base_of_square(term: &Expr) -> Option<Expr> {
    match term {
        Expr::Power(base, exponent) if **exponent == Expr::integer(2) => Some((**base).clone()),
        Expr::Number(_) | Expr::Decimal(_) => Some(Expr::call(Function::Sqrt, term.clone())),
        Expr::Quotient(..) if !is_lettered(term) => Some(Expr::call(Function::Sqrt, term.clone())),
        _ => None,
    }
}

fn is_lettered(expr: &Expr) -> bool {
    !expr.names().is_empty()
}

/// A difference of kinetic energies: squares of velocities added and subtracted, none of them of a difference.
fn is_energy_difference(expr: &Expr) -> bool {
    let mut signs = [0, 0];
    count_squares(expr, false, &mut signs);
    signs[0] >= 1 && signs[1] >= 1 && signs[0] + signs[1] >= 4
}

fn count_squares(expr: &Expr, negative: bool, signs: &mut [usize; 2]) {
    match expr {
        Expr::Power(_, exponent) if **exponent == Expr::integer(2) => signs[usize::from(negative)] += 1,
        Expr::Negative(inner) => count_squares(inner, !negative, signs),
        _ => expr.children().into_iter().for_each(|child| count_squares(child, negative, signs)),
    }
}
