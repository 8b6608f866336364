//! Marks for everything but the two equations: a law has been used where a line shows what it gives.
//!
//! What a law gives is known from the derivation, evaluated from right values and from the student's own. A line that
//! comes to it, in a formula or under a name, has used the law; its sign is condoned. Besides that a few laws are known by
//! the shape of their formula, so that a slip of the calculator costs no method mark.

use super::cleared::is_of_deflection;
use crate::answer::Kind;
use crate::bank::{Code, EarnedFor};
use crate::expr::Expr;
use crate::mark::judging::{is_of_a_part, may_be_named};
use crate::mark::key::KeyedMark;
use crate::mark::working::evidence::Evidence;
use crate::mark::working::examine::{Studied, Value, Working, value};
use crate::mark::working::lines::Member;
use crate::mark::working::numbers::{any_within, comes_to, comes_to_angle, constant, sizes};
use crate::mechanics::{Axis, Datum, Known, Law, Moment, Quantity, Seen, Setting, Shape, Sphere};

impl Working<'_> {
    /// A mark for the use of a law.
    pub(in crate::mark::working) fn by_law(&self, law: Law, sphere: Option<Sphere>, code: Code) -> Option<Evidence> {
        match law.seen() {
            Seen::Unchanged => self.unchanged(),
            Seen::VectorEquation => self.vector_momentum(code),
            Seen::Value(_, Shape::ChangeOfMomentum) if self.prepared.setting == Setting::Impulse => {
                self.impulse_of_particle(code)
            }
            Seen::AlongLine | Seen::Value(_, Shape::ChangeOfMomentum) if self.is_in_vectors() => {
                self.along_impulse(law, code)
            }
            Seen::Components => {
                let along_own = || if code.is_accuracy() { None } else { self.resolved_along_own_line() };
                self.resolved(code).or_else(along_own)
            }
            Seen::Equation if law.gives(Quantity::RestitutionEquation) => {
                if let Some(found) = self.energy_kept(law) {
                    return Some(found);
                }
                let along_own = || if code.is_accuracy() { None } else { self.restitution_along_own_line(law) };
                let quotient = || self.restitution_from_components().or_else(|| self.rebound(code)).or_else(along_own);
                self.by_terms(law, code).filter(|found| found.given).or_else(quotient)
            }
            Seen::Equation => self.by_terms(law, code),
            Seen::Value(quantities, shape) => {
                let about =
                    |quantity: &&Quantity| sphere.is_none() || quantity.sphere().is_none_or(|of| Some(of) == sphere);
                // What was there before the impact is no difference, unless that is what the scheme has.
                let is_before = |quantity: &Quantity| {
                    matches!(
                        quantity,
                        Quantity::TotalEnergy(Moment::Before) | Quantity::KineticEnergy(_, Moment::Before)
                    )
                };
                let counts =
                    |quantity: &&Quantity| about(quantity) && (!is_before(quantity) || self.has_energy_before());
                let quantities: Vec<Quantity> = quantities.iter().filter(counts).copied().collect();
                if let Some(wrong) = self.squared_wrongly(law, shape) {
                    return Some(wrong);
                }
                let found = self.by_value(law, &quantities, code).or_else(|| self.by_shape(law, shape, sphere, code));
                let found = found.or_else(|| if code.is_accuracy() { None } else { self.fraction_of_energies(law) });
                let is_of_wall = shape == Shape::ChangeOfMomentum && self.prepared.setting == Setting::Wall;
                let found = found.or_else(|| if is_of_wall { self.change_in_vectors(law.name(), code) } else { None });
                let found = found.or_else(|| self.energies_apart(law, code).or_else(|| self.losses_apart(law, code)));
                let found = found.or_else(|| self.with_sine_for_cosine(law, code));
                let found = found.or_else(|| self.without_a_letter(law, &quantities, code));
                let by_cosine = || self.scalar_quotient(law).or_else(|| self.between_directions(law));
                let alike = || self.directions_turn_alike(law);
                let by_angle = || self.compound_angle(law).or_else(by_cosine).or_else(alike);
                let expanded = || self.compound_equation(law, &quantities);
                let of_deflection = || self.demanded_of_turn(law).or_else(by_angle);
                match (is_of_deflection(law), code) {
                    (true, Code::M1) => found.or_else(of_deflection),
                    (true, Code::DependentM1) => self.cleared(found.or_else(expanded)?, &quantities),
                    (true, code) if code.is_accuracy() => found.or_else(expanded),
                    _ => found,
                }
            }
            Seen::AlongLine | Seen::Unknown => None,
        }
    }

    /// Where a part asks for the speed of a sphere and for its direction, and has one method mark for both, an inverse tangent
    /// combines the components as well as Pythagoras does.
    pub(in crate::mark::working) fn by_direction(
        &self,
        law: Law,
        sphere: Option<Sphere>,
        code: Code,
    ) -> Option<Evidence> {
        let combines = |law: &Law, by: Shape| matches!(law.seen(), Seen::Value(_, shape) if shape == by);
        if !combines(&law, Shape::Pythagoras) || code.is_accuracy() {
            return None;
        }
        let direction = *Law::ALL.iter().find(|other| combines(other, Shape::Tangent))?;
        let has_own = |mark: &KeyedMark| matches!(mark.earned_for, EarnedFor::Law(law, _) if law == direction);
        let is_angle = |quantity: &Quantity| direction.gives(*quantity) && quantity.sphere() == sphere;
        let mut asked = self.part.blanks.iter().flat_map(|blank| blank.find.quantities());
        if self.part.scheme.iter().any(has_own) || !asked.any(|find| is_angle(&find)) {
            return None;
        }
        let speaks = |found: &Evidence| found.given && self.speaks_of_angle(&self.lines[found.line]);
        // A component may come to the tangent by chance, on a line that does not speak of it.
        let by_shape = || self.by_shape(direction, Shape::Tangent, sphere, code);
        self.by_law(direction, sphere, code).filter(speaks).or_else(|| by_shape().filter(speaks))
    }

    pub(super) fn speaks_of_angle(&self, studied: &Studied) -> bool {
        let typed = studied.line.typed.to_lowercase();
        ["tan", "angle", "direction"].iter().any(|word| typed.contains(word))
            || self.members(studied).any(|(member, _)| is_greek(member))
    }

    /// Does the scheme have the energy before the impact as a step of its own?
    fn has_energy_before(&self) -> bool {
        let is_energy_before = |equation: &Expr| match equation {
            Expr::Relation(left, ..) => matches!(&**left, Expr::Name(name) if name.text == "E_1"),
            _ => false,
        };
        self.part.scheme.iter().filter_map(|mark| mark.equation.as_ref()).any(is_energy_before)
    }

    /// Where a fraction is asked for, all the energy before and all that is left are as good as their difference.
    fn fraction_of_energies(&self, law: Law) -> Option<Evidence> {
        let asks = |quantity| self.part.blanks.iter().any(|blank| blank.find.quantities().contains(&quantity));
        if !law.gives(Quantity::FractionLost) || !asks(Quantity::FractionLost) {
            return None;
        }
        let seen = |known: &[Known<f64>], moment| self.line_that_is(known, Quantity::TotalEnergy(moment));
        let before = seen(&self.prepared.known, Moment::Before)?;
        let after = seen(&self.prepared.known, Moment::After).or_else(|| seen(&self.followed, Moment::After))?;
        Some(Evidence::given(before.max(after), law.name()))
    }

    /// A line that comes to what the law gives: from right values, or from the student's own.
    fn by_value(&self, law: Law, quantities: &[Quantity], code: Code) -> Option<Evidence> {
        let follows = !code.is_accuracy() || code == Code::A1FollowThrough;
        let found = self.prepared.all_where_found().unwrap_or_default();
        for (known, own) in [(&self.prepared.known, false), (&found, false), (&self.followed, true)] {
            if own && !follows {
                continue;
            }
            let counts = |quantity: &&Quantity| !known.is_empty() && (!own || !self.is_trivial(**quantity));
            for quantity in quantities.iter().filter(counts) {
                if let Some(line) = self.line_that_is(known, *quantity) {
                    let role = law.name();
                    return Some(if own { Evidence::followed(line, role) } else { Evidence::given(line, role) });
                }
            }
        }
        None
    }

    /// The first line with a member of this value; a bare number does only if the line calls it something.
    pub(in crate::mark::working) fn line_that_is(&self, known: &[Known<f64>], quantity: Quantity) -> Option<usize> {
        let is_angle = matches!(known[0].0.get(&quantity)?, Datum::Direction { .. });
        let right = sizes(known, quantity)?;
        if right.iter().any(|size| !size.is_finite()) {
            return None;
        }
        let comes = |value: Value, right: f64| match is_angle {
            // What moves along the line of centres has no angle with it that anybody would take off 90°.
            true => comes_to_angle(value, right, right.abs() > 1e-9 && self.may_be_complement(quantity)),
            false if quantity == Quantity::ContactSine => comes_to(value, right) || comes_to(value, right.asin()),
            false => comes_to(value, right),
        };
        // The angle itself, `α = 30°`, says what its sine is.
        let is_angle_of_contact = |member: &Member, values: &[Value]| {
            let comes = |(value, right): (&Value, &f64)| comes_to(*value, right.asin().to_degrees());
            quantity == Quantity::ContactSine && is_greek(member) && values.iter().zip(&right).all(comes)
        };
        let is_of_another_function =
            |label: &str| ["tan", "cos"].iter().any(|name| label.trim_start().starts_with(name));
        self.lines.iter().position(|studied| {
            studied.matched.is_empty()
                && !self.is_printed_result(studied)
                && self.members(studied).any(|(member, values)| {
                    let is_else = |label: &String| {
                        is_of_a_part(label, quantity)
                            || self.is_loss_of_one(label, quantity)
                            || !may_be_named(label, quantity)
                            || quantity == Quantity::ContactSine && is_of_another_function(label)
                    };
                    let worth = self.is_called(member) || self.is_worked_out(&member.expr);
                    worth
                        && !member.label.as_ref().is_some_and(is_else)
                        && !self.is_so_much_of_a_letter(member, quantity)
                        && self.may_be_loss(member, quantity)
                        && !member.is_given
                        && !self.is_taken(member, quantity)
                        && !self.is_printed_value(&member.expr)
                        && (values.iter().zip(&right).all(|(value, right)| comes(*value, *right))
                            || is_angle_of_contact(member, values))
                        && !self.is_denied_by_line(studied, member)
                })
        })
    }

    /// Is the value one of `2v` or `w²`, of which nothing is known? It says nothing of any quantity but an energy, `½mv²`.
    fn is_so_much_of_a_letter(&self, member: &Member, quantity: Quantity) -> bool {
        let Some(multiple) = &member.multiple else { return false };
        let is_power = |inner: &Expr| matches!(inner, Expr::Power(..));
        let is_energy = matches!(quantity, Quantity::KineticEnergy(..) | Quantity::TotalEnergy(_))
            && !is_power(multiple)
            && any_within(multiple, &is_power);
        !is_energy && self.is_open_multiple(member)
    }

    /// Is it `2v` itself, or the value of a `2v` of which nothing is known?
    pub(super) fn is_open_multiple(&self, member: &Member) -> bool {
        let is_given = |own: &Expr| value(own, self.prepared, &self.prepared.names).is_some();
        let is_open = |own: &Expr| !is_given(own) && (member.expr == *own || self.values_of(own).is_none());
        member.multiple.as_ref().is_some_and(is_open)
    }

    /// The unknowns of the two equations have their own marks; the letter of a sphere may be used again for its speed.
    fn is_taken(&self, member: &Member, quantity: Quantity) -> bool {
        let letters = self.convention.as_ref().map(|convention| convention.letters.as_slice()).unwrap_or_default();
        let place = letters.iter().position(|letter| member.letter.as_ref() == Some(letter));
        place.is_some_and(|place| !matches!(quantity, Quantity::Speed(sphere, _) if sphere == Sphere::BOTH[place]))
    }

    /// May an angle be given by its complement? A deflection has none, and what is to be shown says which angle it is.
    pub(super) fn may_be_complement(&self, quantity: Quantity) -> bool {
        let is_deflection = matches!(quantity, Quantity::Deflection(_) | Quantity::TanDeflection(_));
        !is_deflection && self.part.blanks.iter().all(|blank| blank.model.kind != Kind::Shown)
    }

    pub(in crate::mark::working) fn members<'s>(
        &self,
        studied: &'s Studied,
    ) -> impl Iterator<Item = (&'s Member, &'s Vec<Value>)> {
        let members = studied.reading.as_ref().map(|reading| reading.members.as_slice()).unwrap_or_default();
        members.iter().zip(&studied.values).filter_map(|(member, values)| Some((member, values.as_ref()?)))
    }

    pub(super) fn is_unknown(&self, letter: &str) -> bool {
        self.convention.as_ref().is_some_and(|convention| convention.letters.iter().any(|known| known == letter))
    }

    pub(super) fn is_in_vectors(&self) -> bool {
        !self.prepared.given[0].0.contains_key(&Quantity::Line(Axis::X))
            && !self.prepared.given[0].0.contains_key(&Quantity::ContactSine)
    }

    pub(in crate::mark::working) fn values_of(&self, expr: &Expr) -> Option<Vec<Value>> {
        let at = |point| {
            let context = self.context(point);
            constant(expr, &context).map(Value::Number)
        };
        (0..self.prepared.points.count).map(at).collect()
    }
}

/// Is it called by a letter for an angle?
fn is_greek(member: &Member) -> bool {
    const GREEK: [&str; 6] = ["alpha", "beta", "gamma", "delta", "theta", "phi"];
    member.letter.as_ref().is_some_and(|letter| GREEK.contains(&letter.as_str()))
}
