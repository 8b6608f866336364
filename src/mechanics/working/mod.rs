//! The building blocks of a worked solution: how quantities are written while it is worked.
//!
//! The positive direction of the working is that of n, from A to B; or, where the line of centres is
//! parallel to **i** or **j**, the direction of that unit vector, as one would work on paper. Momentum
//! and restitution read the same either way.

mod chain;
mod equations;
mod names;
mod several;
mod vectors;

use std::borrow::Cow;
use std::cmp::Ordering;

use super::formula::{difference, times};
use super::later::Meeting;
use super::law::Known;
use super::scene::{Contact, Scene, Velocity};
use super::{Axis, Moment, Quantity, Setting, Sphere};
use crate::expr::{Expr, Function, written};
use crate::number::{Angle, Value};

/// What a solution shows of each quantity.
pub struct Show<'a> {
    scene: &'a Scene,
    known: Cow<'a, Known<Value>>,
    asked: Cow<'a, [Quantity]>,
    /// Which impact it is of.
    meeting: Meeting,
    /// Do others come before it or after it?
    one_of_several: bool,
    /// How many numbered equations the earlier ones have.
    numbered_before: usize,
    /// The axis of i and j that the line of centres is parallel to.
    axis: Option<Axis>,
    /// Is the positive direction of the working against n?
    against_n: bool,
    /// Do the words of the question have unit vectors, where that is known?
    unit_vectors: Option<bool>,
    /// The letters that the words of the question give with a unit.
    with_units: &'a [String],
}

impl<'a> Show<'a> {
    /// The view of a solved scene in which some quantities are asked for.
    pub fn new(scene: &'a Scene, known: &'a Known<Value>, asked: &'a [Quantity]) -> Show<'a> {
        let one_of_several = !scene.then.is_empty();
        Show { one_of_several, ..Show::of_one(scene, Cow::Borrowed(known), Cow::Borrowed(asked)) }
    }

    fn of_one(scene: &'a Scene, known: Cow<'a, Known<Value>>, asked: Cow<'a, [Quantity]>) -> Show<'a> {
        let component = |axis| known.number(Quantity::Line(axis));
        let zero = |axis| component(axis).is_some_and(|value| value.is_zero());
        let axis = if zero(Axis::Y) {
            Some(Axis::X)
        } else if zero(Axis::X) {
            Some(Axis::Y)
        } else {
            None
        };
        let against_n = axis.and_then(component).is_some_and(|value| value.sign() == Some(Ordering::Less));
        let meeting = Meeting::FIRST;
        Show {
            scene,
            known,
            asked,
            meeting,
            one_of_several: false,
            numbered_before: 0,
            axis,
            against_n,
            unit_vectors: None,
            with_units: &[],
        }
    }

    /// The same view for a question whose words have unit vectors or have none, and these letters with a unit: the
    /// working speaks as they do.
    pub fn in_words_of(self, unit_vectors: bool, with_units: &'a [String]) -> Show<'a> {
        Show { unit_vectors: Some(unit_vectors), with_units, ..self }
    }

    /// What the impact is between.
    pub fn setting(&self) -> Setting {
        self.scene.setting
    }

    /// The spheres that move.
    pub fn spheres(&self) -> &'static [Sphere] {
        if self.setting().is_of_one() { &Sphere::BOTH[..1] } else { &Sphere::BOTH }
    }

    /// Is the line of centres parallel to i or j?
    pub fn along_an_axis(&self) -> bool {
        self.axis.is_some()
    }

    /// The axis of i and j that the line of centres is parallel to.
    pub fn axis(&self) -> Option<Axis> {
        self.axis
    }

    /// Is the positive direction of the working from B to A?
    pub fn is_against_n(&self) -> bool {
        self.against_n
    }

    /// The positive direction of the working, in words.
    pub fn positive(&self) -> &'static str {
        let in_i_j = self.unit_vectors.unwrap_or_else(|| {
            self.scene.before.iter().flatten().any(|velocity| match velocity {
                Velocity::Components(x, y) => x.value.is_constant() && y.value.is_constant() && !y.value.is_zero(),
                Velocity::Polar { .. } => false,
            })
        });
        match self.axis {
            Some(Axis::X) if in_i_j => "in the direction of {i}",
            Some(_) if in_i_j => "in the direction of {j}",
            _ if self.setting() == Setting::Wall && self.against_n => "away from the wall",
            _ if self.setting() == Setting::Wall => "towards the wall",
            _ if self.against_n => "from *B* towards *A*",
            _ => "from *A* towards *B*",
        }
    }

    /// Is the quantity one of those asked for?
    pub fn is_asked(&self, quantity: Quantity) -> bool {
        self.asked.contains(&quantity)
    }

    /// Is the quantity given or found?
    pub fn has(&self, quantity: Quantity) -> bool {
        self.known.number(quantity).is_some()
    }

    /// The exact value of a quantity, with the sign of its definition.
    pub fn exact(&self, quantity: Quantity) -> Value {
        self.known.number(quantity).unwrap_or(Value::ZERO)
    }

    /// The same, written.
    pub fn value(&self, quantity: Quantity) -> Expr {
        written(&self.exact(quantity))
    }

    /// The value of a quantity in the working: components have the signs of its positive direction.
    pub fn worked(&self, quantity: Quantity) -> Value {
        let value = self.exact(quantity);
        if self.is_turned(quantity) { -value } else { value }
    }

    /// Does the working give a component the other sign than its definition?
    pub fn is_turned(&self, quantity: Quantity) -> bool {
        match quantity {
            Quantity::Velocity(_, _, Axis::N) | Quantity::Impulse(_, Axis::N) => self.against_n,
            // t is n turned by +90 degrees: i for n = -j, and j for n = i.
            Quantity::Velocity(_, _, Axis::T) => {
                matches!((self.axis, self.against_n), (Some(Axis::X), true) | (Some(Axis::Y), false))
            }
            _ => false,
        }
    }

    /// The same, written.
    pub fn shown_value(&self, quantity: Quantity) -> Expr {
        written(&self.worked(quantity))
    }

    /// The letter by which the working calls a quantity.
    pub fn letter_of(&self, quantity: Quantity) -> &'static str {
        use Moment::{After, Before};
        use Sphere::{A, B};
        let plain = !self.taken("v") && !self.taken("w");
        if let (Quantity::Velocity(sphere @ (A | B), After, Axis::N), number @ 1..) = (quantity, self.meeting.number) {
            return self.letter_of_later(sphere, number);
        }
        match quantity {
            Quantity::Velocity(A, After, Axis::N) => {
                if plain {
                    "v"
                } else {
                    "v_A"
                }
            }
            Quantity::Velocity(B, After, Axis::N) => {
                if plain {
                    "w"
                } else {
                    "v_B"
                }
            }
            Quantity::Velocity(A, Before, Axis::N) => "u_A",
            Quantity::Velocity(B, Before, Axis::N) => "u_B",
            Quantity::Mass(A) => "m_A",
            Quantity::Mass(B) => "m_B",
            Quantity::Restitution => "e",
            Quantity::ImpulseMagnitude => self.letter("I"),
            Quantity::Speed(A, _) => "s_A",
            Quantity::Speed(B, _) => "s_B",
            Quantity::EnergyLost => self.letter("L"),
            _ => "x",
        }
    }

    /// The same as an expression.
    pub fn symbol(&self, quantity: Quantity) -> Expr {
        match (quantity, self.given(quantity)) {
            (Quantity::Mass(_) | Quantity::Restitution, Some(shown)) if matches!(shown, Expr::Name(_)) => shown,
            _ => Expr::name(self.letter_of(quantity)),
        }
    }

    /// The form in which a mass or e was given.
    fn given(&self, quantity: Quantity) -> Option<Expr> {
        match quantity {
            Quantity::Mass(sphere) => self.scene.mass(sphere).map(|given| given.shown.clone()),
            Quantity::Restitution => self.scene.restitution.as_ref().map(|given| given.shown.clone()),
            _ => None,
        }
    }

    /// A mass as it was given, or its letter while it is not known.
    pub fn mass(&self, sphere: Sphere) -> Expr {
        let quantity = Quantity::Mass(sphere);
        self.given(quantity).unwrap_or_else(|| self.symbol(quantity))
    }

    /// e as it was given, or its letter.
    pub fn restitution(&self) -> Expr {
        self.given(Quantity::Restitution).unwrap_or_else(|| Expr::name("e"))
    }

    /// The component of a velocity along the line of centres as a student would write it down: `4 cos 30°`.
    pub fn along(&self, sphere: Sphere, moment: Moment) -> Expr {
        self.resolved(sphere, moment, true)
    }

    /// The same across the line of centres: `4 sin 30°`.
    pub fn across(&self, sphere: Sphere, moment: Moment) -> Expr {
        self.resolved(sphere, moment, false)
    }

    fn resolved(&self, sphere: Sphere, moment: Moment, along: bool) -> Expr {
        let at = |axis| self.worked(Quantity::Velocity(sphere, moment, axis));
        let value = at(if along { Axis::N } else { Axis::T });
        if value.is_zero() {
            return Expr::integer(0);
        }
        let size = match (self.scene.velocity(sphere, moment), self.axis) {
            (Some(Velocity::Components(x, y)), Some(axis)) => {
                let given = if (axis == Axis::X) == along { x } else { y };
                return given.shown.clone();
            }
            (Some(Velocity::Polar { speed, angle, .. }), Some(axis)) => {
                // An angle is measured from the line of centres, or from a wall.
                let at_wall = self.setting() == Setting::Wall;
                let (from, across) = if at_wall { (Axis::T, Axis::N) } else { (Axis::N, Axis::T) };
                let acute = Angle::acute(&at(across), &at(from));
                let letter = angle.as_ref().map(|(_, shown)| match shown {
                    Expr::Negative(inner) if at_wall => inner,
                    shown => shown,
                });
                let letter = letter.filter(|shown| matches!(shown, Expr::Name(_)));
                let letter_axis = if at_wall { Axis::Y } else { Axis::X };
                let degrees = || {
                    acute.as_ref().and_then(Angle::whole_degrees).map(|degrees| Expr::degrees(Expr::Number(degrees)))
                };
                let function = if along == at_wall { Function::Sin } else { Function::Cos };
                match letter.cloned().or_else(degrees) {
                    Some(Expr::Degrees(degrees)) if degrees.is_zero() || *degrees == Expr::integer(90) => {
                        speed.shown.clone()
                    }
                    Some(angle) if axis == letter_axis || matches!(angle, Expr::Degrees(_)) => {
                        times(speed.shown.clone(), Expr::call(function, angle))
                    }
                    _ => {
                        let share = value.divided_by(&speed.value).unwrap_or(Value::ONE).absolute();
                        times(speed.shown.clone(), written(&share))
                    }
                }
            }
            _ => return written(&value),
        };
        if value.sign() == Some(Ordering::Less) { size.negated() } else { size }
    }

    /// A component after the impact along the line of centres: an unknown one is a letter, a known one is written.
    pub fn after(&self, sphere: Sphere) -> Expr {
        match self.scene.velocity(sphere, Moment::After) {
            Some(_) => self.along(sphere, Moment::After),
            None => self.symbol(Quantity::Velocity(sphere, Moment::After, Axis::N)),
        }
    }

    /// `m_A a + m_B b`, masses and components as given.
    pub fn momentum_before(&self) -> Expr {
        Expr::sum(Sphere::BOTH.map(|sphere| times(self.mass(sphere), self.along(sphere, Moment::Before))))
    }

    /// `m_A v + m_B w`.
    pub fn momentum_after(&self) -> Expr {
        Expr::sum(Sphere::BOTH.map(|sphere| times(self.mass(sphere), self.after(sphere))))
    }

    /// `w - v`.
    pub fn separation(&self) -> Expr {
        difference(self.after(Sphere::B), self.after(Sphere::A))
    }

    /// `a - b`, as given.
    pub fn approach(&self) -> Expr {
        difference(self.along(Sphere::A, Moment::Before), self.along(Sphere::B, Moment::Before))
    }

    /// `e (a - b)`.
    pub fn e_times_approach(&self) -> Expr {
        times(self.restitution(), self.approach())
    }

    /// The scene that is shown.
    pub fn scene(&self) -> &Scene {
        self.scene
    }

    /// Are the components along the line of centres known, before and after?
    pub fn given_along(&self) -> bool {
        super::law::ALONG.iter().all(|quantity| self.known.number(*quantity).is_some())
    }

    /// An angle among the quantities, written.
    pub fn angle(&self, quantity: Quantity) -> Option<Angle> {
        let (y, x) = self.known.direction(quantity)?;
        Angle::of(&y, &x)
    }

    /// The offset over the sum of the radii, as given.
    pub fn contact_quotient(&self) -> Option<Expr> {
        match self.scene.contact.as_ref()? {
            Contact::Offset { offset, sum, .. } => {
                let offset = match &offset.shown {
                    Expr::Negative(inner) => (**inner).clone(),
                    other => other.clone(),
                };
                Some(Expr::Quotient(Box::new(offset), Box::new(sum.shown.clone())))
            }
            _ => None,
        }
    }
}
