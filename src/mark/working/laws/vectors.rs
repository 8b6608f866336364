//! Marks of collisions that are given backwards, in vectors: the line of centres from an impulse, components along it, and e
//! from those.

use crate::bank::Code;
use crate::expr::Expr;
use crate::mark::award::Ground;
use crate::mark::working::equations::Departure;
use crate::mark::working::evidence::Evidence;
use crate::mark::working::examine::{Studied, Value, Working, context};
use crate::mark::working::lines::{Member, says_along};
use crate::mark::working::numbers::{Sum, any_within, is_composite, is_parallel, sizes, sum};
use crate::mark::working::theirs::numbers;
use crate::mechanics::{Axis, Law, Moment, Quantity, Seen, Setting, Sphere};

/// A component with its size at every point.
type Component = (Quantity, Vec<f64>);

impl Working<'_> {
    /// A change of momentum or of velocity, which is along the line of centres. For the accuracy of the line the vector in which
    /// it ends is: what is worked out wrongly, or another line that is concluded, costs the mark.
    pub(super) fn along_impulse(&self, law: Law, code: Code) -> Option<Evidence> {
        let line = |axis| sizes(&self.prepared.known, Quantity::Line(axis));
        let (x, y) = line(Axis::X).zip(line(Axis::Y))?;
        let is_along = |values: &Vec<Value>| is_parallel(values, &x, &y);
        let has_one = |studied: &Studied| self.vectors_in(studied).any(is_along);
        let names_it = |studied: &&Studied| {
            let typed = &studied.line.typed;
            (says_along(typed) || typed.contains("parallel")) && self.vectors_in(studied).next().is_some()
        };
        let Some(place) = self.lines.iter().position(has_one) else {
            // Another line of centres is named, and none is right.
            let place = self.lines.iter().position(|studied| names_it(&studied))?;
            let (note, feedback) = (Some(Ground::Contradicted.tag()), "it names another line of centres".to_owned());
            let lost = Evidence { given: false, note, feedback, ..Evidence::given(place, law.name()) };
            return (code.is_accuracy() && law.seen() == Seen::AlongLine).then_some(lost);
        };
        let ends_so = |place: usize| self.last_vector_from(place).is_some_and(is_along);
        let ends = (place..self.lines.len()).find(|place| has_one(&self.lines[*place]) && ends_so(*place));
        let is_concluded = self.lines.iter().rev().find(names_it).is_none_or(has_one);
        match ends.filter(|_| is_concluded) {
            Some(place) => Some(Evidence::given(place, law.name())),
            None if code.is_accuracy() && law.seen() == Seen::AlongLine => {
                let feedback = "it ends in a vector that is not along the line of centres".to_owned();
                Some(Evidence { given: false, feedback, ..Evidence::given(place, law.name()) })
            }
            None => Some(Evidence::given(place, law.name())),
        }
    }

    pub(super) fn vectors_in<'s>(&self, studied: &'s Studied) -> impl Iterator<Item = &'s Vec<Value>> {
        let vectors = |values: &&Vec<Value>| matches!(values.first(), Some(Value::Vector(..)));
        self.members(studied).map(|(_, values)| values).filter(vectors)
    }

    /// The last vector of a line and of those that go on from it with an equals sign.
    fn last_vector_from(&self, place: usize) -> Option<&Vec<Value>> {
        let goes_on = |studied: &&Studied| studied.line.goes_on();
        let further = self.lines[place + 1..].iter().take_while(goes_on);
        std::iter::once(&self.lines[place]).chain(further).flat_map(|studied| self.vectors_in(studied)).last()
    }

    /// Components along the line of centres; a factor that all have in common does not matter. A number is one where the
    /// line stands in the working or is given, and a scalar product that is worked out speaks for itself. For their accuracy
    /// all have their signs, for one direction along the line; at a wall each may be counted either way.
    pub(super) fn resolved(&self, code: Code) -> Option<Evidence> {
        let is_wall = self.prepared.setting == Setting::Wall;
        let components = self.components_to_resolve(is_wall);
        let is_line_known = is_wall || self.lines.iter().any(|studied| self.has_line(studied));
        let mut best: Option<(usize, usize, usize, bool)> = None;
        for scale in self.scales() {
            let seen = |alike: &Vec<Component>| {
                let size = |sign: f64| alike[0].1.iter().map(|right| sign * right.abs() * scale).collect::<Vec<f64>>();
                let is = |expr: &Expr| {
                    let product = || alike.iter().any(|(quantity, _)| self.is_scalar_product(expr, *quantity));
                    let is_open = expr.names().iter().any(|name| self.is_unknown(&name.text));
                    !is_open && self.is_one_of(expr, &[size(1.0)]) && (is_line_known || product())
                };
                let in_sums = |studied: &Studied| {
                    let members = studied.reading.iter().flat_map(|reading| &reading.members);
                    let mut terms = members.flat_map(|member| sums_in(&member.expr)).flat_map(|sum| sum.children());
                    terms.any(is)
                };
                let first =
                    self.lines.iter().position(|studied| times(studied, &is, &|_| true) > 0 || in_sums(studied))?;
                let stated = |should_be: &dyn Fn(&Expr) -> bool| -> usize {
                    self.lines.iter().map(|studied| times(studied, &is, should_be)).sum()
                };
                // Those that point either way, each with its sign, where the direction is taken so.
                let with_signs = |direction: f64| {
                    [1.0, -1.0].into_iter().all(|sign| {
                        let has_sign = |expr: &Expr| self.is_exactly(expr, &size(sign * direction));
                        stated(&has_sign) >= alike.iter().filter(|(_, right)| right[0] * sign > 0.0).count()
                    })
                };
                let in_right_sums = self.times_in_sums(&is, |sum| is_wall || self.is_difference_along(sum, scale));
                let is_shown = in_right_sums >= alike.len();
                let each = match is_wall {
                    true => [is_shown || stated(&|_| true) >= alike.len(); 2],
                    false => [1.0, -1.0].map(|direction| is_shown || with_signs(direction)),
                };
                Some((first, stated(&|_| true).min(alike.len()), each))
            };
            let found: Vec<(usize, usize, [bool; 2])> = components.iter().filter_map(seen).collect();
            if found.len() > best.map_or(0, |(count, ..)| count) {
                let last = found.iter().map(|(place, ..)| *place).max().unwrap_or(0);
                let stated = found.iter().map(|(_, stated, _)| stated).sum();
                let each = (0..2).any(|direction| found.iter().all(|(.., each)| each[direction]));
                best = Some((found.len(), stated, last, each));
            }
        }
        let [along, across] = [Axis::T, Axis::N].map(|axis| self.by_unknown_components(axis, code));
        if let Some((along, across)) = along.zip(across) {
            return Some(Evidence::given(along.max(across), "components along the line of centres"));
        }
        let (count, stated, place, each) = best?;
        // Two velocities may have components of one size.
        let is_method = stated >= 2 || count >= if is_wall { 1 } else { 2.min(components.len()) };
        let is_complete = count == components.len();
        let evidence = Evidence::given(place, "components along the line of centres");
        match code.is_accuracy() {
            false => is_method.then_some(evidence),
            // Two of one size, of which one is shown: at a wall signs do not matter.
            true if is_complete && !each && is_wall => {
                let feedback = "only one of the two components is there".to_owned();
                Some(Evidence { given: false, feedback, ..evidence })
            }
            true if is_complete && !each => {
                let sign = Departure::Sign;
                let (note, feedback) = (Some(sign.tag()), sign.sentence().to_owned());
                Some(Evidence { given: false, note, feedback, ..evidence })
            }
            true => is_complete.then_some(evidence),
        }
    }

    /// Does it come to this with its sign?
    fn is_exactly(&self, expr: &Expr, right: &[f64]) -> bool {
        let is = |(value, right): (&Value, &f64)| matches!(value, Value::Number(spread) if spread.may_be(*right));
        self.values_of(expr).is_some_and(|values| values.iter().zip(right).all(is))
    }

    /// Is it the speed of approach or of separation, up to a sign, so that what it is made of has the right signs?
    fn is_difference_along(&self, sum: &Expr, scale: f64) -> bool {
        let difference = |moment| {
            let along = |sphere| sizes(&self.prepared.known, Quantity::Velocity(sphere, moment, Axis::N));
            let (a, b) = along(Sphere::A).zip(along(Sphere::B))?;
            Some(a.iter().zip(b).map(|(a, b)| (a - b) * scale).collect::<Vec<f64>>())
        };
        let differences: Vec<Vec<f64>> = [Moment::Before, Moment::After].into_iter().filter_map(difference).collect();
        self.is_one_of(sum, &differences)
    }

    /// How often such a formula stands in sums that are not the same: `(1 + 4)/(4 + 3)` has a 4 in two.
    fn times_in_sums(&self, is: &dyn Fn(&Expr) -> bool, counts: impl Fn(&Expr) -> bool) -> usize {
        let readings = self.lines.iter().filter_map(|studied| studied.reading.as_ref());
        let mut sums: Vec<&Expr> = Vec::new();
        for sum in readings.flat_map(|reading| &reading.members).flat_map(|member| sums_in(&member.expr)) {
            if !sums.contains(&sum) && counts(sum) {
                sums.push(sum);
            }
        }
        sums.into_iter().flat_map(|sum| sum.children()).filter(|term| is(term)).count()
    }

    /// What a scheme has resolved, those of one size together: of two such, one number shows one.
    fn components_to_resolve(&self, is_wall: bool) -> Vec<Vec<Component>> {
        let of = |sphere, moment, axis| {
            let quantity = Quantity::Velocity(sphere, moment, axis);
            Some((quantity, sizes(&self.prepared.known, quantity)?))
        };
        let all: Vec<Option<Component>> = match is_wall {
            true => [Axis::N, Axis::T].map(|axis| of(Sphere::A, Moment::Before, axis)).to_vec(),
            false => {
                let moments = [Moment::Before, Moment::After];
                Sphere::BOTH.into_iter().flat_map(|sphere| moments.map(|moment| of(sphere, moment, Axis::N))).collect()
            }
        };
        let mut groups: Vec<Vec<Component>> = Vec::new();
        for component in all.into_iter().flatten().filter(|(_, sizes)| sizes.iter().any(|size| size.abs() > 1e-9)) {
            let is_alike = |other: &Component| {
                let mut pairs = other.1.iter().zip(&component.1);
                pairs.all(|(one, other)| (one.abs() - other.abs()).abs() < 1e-9)
            };
            match groups.iter_mut().find(|group| is_alike(&group[0])) {
                Some(group) => group.push(component),
                None => groups.push(vec![component]),
            }
        }
        groups
    }

    /// `-3i + vj`: is it a vector with the component across the line of centres, and an unknown along it?
    pub(super) fn has_component_beside_unknown(&self, expr: &Expr, sphere: Sphere) -> bool {
        let lies =
            |axis| sizes(&self.prepared.known, Quantity::Line(axis)).is_some_and(|line| line[0].abs() > 1.0 - 1e-9);
        let across = match [Axis::X, Axis::Y].map(lies) {
            [true, _] => Axis::Y,
            [_, true] => Axis::X,
            _ => return false,
        };
        let Some(own) = sizes(&self.prepared.known, Quantity::Velocity(sphere, Moment::Before, across)) else {
            return false;
        };
        (0..self.prepared.points.count).all(|point| {
            let (across, along) = match sum(expr, &context(self.prepared, point)) {
                Some(Sum::Vector(x, y)) => {
                    if across == Axis::X {
                        (x, y)
                    } else {
                        (y, x)
                    }
                }
                _ => return false,
            };
            across.is_number() && across.constant.may_be(own[point]) && !along.is_number()
        })
    }

    /// Is there a vector along the line of centres?
    fn has_line(&self, studied: &Studied) -> bool {
        let line = |axis| sizes(&self.prepared.known, Quantity::Line(axis));
        let Some((x, y)) = line(Axis::X).zip(line(Axis::Y)) else { return false };
        self.members(studied).any(|(_, values)| is_parallel(values, &x, &y))
    }

    /// `2 - 5`, or that over √2: both products of the components of a velocity and of a vector along the line of centres?
    fn is_scalar_product(&self, expr: &Expr, component: Quantity) -> bool {
        let terms = match expr {
            Expr::Sum(terms) => terms.as_slice(),
            Expr::Quotient(inner, _) | Expr::Negative(inner) => return self.is_scalar_product(inner, component),
            Expr::Product(factors) => return factors.iter().any(|factor| self.is_scalar_product(factor, component)),
            _ => return false,
        };
        let ([one, other], Quantity::Velocity(sphere, moment, _)) = (terms, component) else { return false };
        let product = |axis| {
            let line = sizes(&self.prepared.known, Quantity::Line(axis))?;
            let own = sizes(&self.prepared.known, Quantity::Velocity(sphere, moment, axis))?;
            Some(line.iter().zip(own).map(|(line, own)| (line * own).abs()).collect::<Vec<f64>>())
        };
        let Some((x, y)) = product(Axis::X).zip(product(Axis::Y)) else { return false };
        let sizes_of = |expr| self.values_of(expr).and_then(|values| numbers(&values));
        let Some((one, other)) = sizes_of(one).zip(sizes_of(other)) else { return false };
        let in_proportion = |(a, b): (&Vec<f64>, &Vec<f64>)| {
            (0..a.len())
                .all(|at| (one[at].abs() * b[at] - other[at].abs() * a[at]).abs() < 0.005 * one[at].abs() * b[at])
        };
        in_proportion((&x, &y)) || in_proportion((&y, &x))
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
    pub(super) fn restitution_from_components(&self) -> Option<Evidence> {
        let at =
            |sphere, moment| sizes(&self.prepared.known, Quantity::Velocity(sphere, moment, Axis::N)).map(|s| s[0]);
        let [a, b] = Sphere::BOTH.map(|sphere| at(sphere, Moment::Before));
        let [x, y] = Sphere::BOTH.map(|sphere| at(sphere, Moment::After));
        let (a, b, x, y) = (a?, b?, x?, y?);
        let scales = self.scales();
        let is = |expr: &Expr, sizes: [f64; 2], scale: f64| {
            let candidates: Vec<Vec<f64>> = sizes.iter().map(|size| vec![size * scale]).collect();
            self.is_one_of(expr, &candidates)
        };
        // Where e is given, two numbers are e as it stands in the question.
        let is_given = self.prepared.given[0].0.contains_key(&Quantity::Restitution);
        let is_quotient = |expr: &Expr| match expr {
            Expr::Quotient(above, below) if is_given && !is_composite(above) && !is_composite(below) => false,
            Expr::Quotient(above, below) => {
                let mut scales = scales.iter();
                scales.any(|scale| is(above, [y - x, y + x], *scale) && is(below, [a - b, a + b], *scale))
            }
            _ => false,
        };
        let line = self.lines.iter().position(|studied| {
            let Some(reading) = &studied.reading else { return false };
            reading.members.iter().any(|member| any_within(&member.expr, &is_quotient))
        })?;
        Some(Evidence::given(line, "a quotient of differences of components"))
    }
}

/// How often a line has such a formula for a value, the last of its kind as it should be: `2 + 2 = 4` has it once.
fn times(studied: &Studied, is: &dyn Fn(&Expr) -> bool, should_be: &dyn Fn(&Expr) -> bool) -> usize {
    let members = studied.reading.as_ref().map(|reading| reading.members.as_slice()).unwrap_or_default();
    let same_statement = |one: &Member, other: &Member| one.label == other.label;
    let ends_so = |chain: &&[Member]| {
        let last = chain.iter().rev().find(|member| is(&member.expr));
        last.is_some_and(|member| should_be(&member.expr))
    };
    members.chunk_by(same_statement).filter(ends_so).count()
}

/// The sums in a formula, above and below a line.
fn sums_in(expr: &Expr) -> Vec<&Expr> {
    match expr {
        Expr::Sum(_) => vec![expr],
        Expr::Quotient(above, below) => [above, below].into_iter().flat_map(|part| sums_in(part)).collect(),
        _ => Vec::new(),
    }
}
