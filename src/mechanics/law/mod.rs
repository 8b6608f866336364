//! The laws of an oblique impact, one file each, and the one list of them.
//!
//! A law is a room of its own: the [`Rule`]s by which it leads from known quantities to others, their
//! evaluation in any kind of number, the words and equations of a worked solution, and the slips that
//! students make with it. To add a law, write its file and add its line to the list below.
//!
//! A rule of a later impact is a rule of a law with other names for what it needs and gives; see [`Meeting`].

mod here;
mod rule;

pub(super) use here::Here;
pub use rule::Rule;

use std::collections::BTreeMap;
use std::sync::{Mutex, OnceLock, PoisonError};

use smallvec::{SmallVec, smallvec};

use super::later::Meeting;
use super::line::Line;
use super::seen::{Seen, Shape};
use super::working::Show;
use super::{Axis, Moment, Quantities, Quantity, Sphere};
use crate::expr::Expr;
use crate::number::Number;

/// What is known of a quantity.
#[derive(Clone, Debug, PartialEq)]
pub enum Datum<N> {
    /// A number.
    Number(N),
    /// An angle, by a vector that has it: anticlockwise from the positive x-direction.
    Direction {
        /// The y-component.
        y: N,
        /// The x-component.
        x: N,
    },
    /// `p x + q y = r` for the components x, y of A and B after the impact along the line of centres.
    Equation([N; 3]),
}

/// The quantities that are known so far.
#[derive(Clone, Debug, PartialEq)]
pub struct Known<N>(pub Quantities<Datum<N>>);

impl<N> Default for Known<N> {
    fn default() -> Known<N> {
        Known(Quantities::default())
    }
}

impl<N: Number> Datum<N> {
    /// If it is a number.
    pub fn number(&self) -> Option<N> {
        match self {
            Datum::Number(number) => Some(number.clone()),
            _ => None,
        }
    }

    /// The vector of an angle.
    pub fn direction(&self) -> Option<(N, N)> {
        match self {
            Datum::Direction { y, x } => Some((y.clone(), x.clone())),
            _ => None,
        }
    }

    /// If it is an equation.
    pub fn equation(&self) -> Option<[N; 3]> {
        match self {
            Datum::Equation(coefficients) => Some(coefficients.clone()),
            _ => None,
        }
    }
}

impl<N: Number> Known<N> {
    /// A quantity that is a number.
    pub fn number(&self, quantity: Quantity) -> Option<N> {
        self.0.get(&quantity)?.number()
    }

    /// Several quantities that are numbers.
    pub fn numbers<const COUNT: usize>(&self, quantities: [Quantity; COUNT]) -> Option<[N; COUNT]> {
        all(quantities.map(|quantity| self.number(quantity)))
    }

    /// The vector of an angle.
    pub fn direction(&self, quantity: Quantity) -> Option<(N, N)> {
        self.0.get(&quantity)?.direction()
    }

    /// An equation.
    pub fn equation(&self, quantity: Quantity) -> Option<[N; 3]> {
        self.0.get(&quantity)?.equation()
    }
}

/// All of a few things, if none is missing.
fn all<T, const COUNT: usize>(found: [Option<T>; COUNT]) -> Option<[T; COUNT]> {
    if found.iter().any(Option::is_none) {
        return None;
    }
    Some(found.map(|one| one.expect("none is missing")))
}

/// A mistake that students make with a law, or with several: then it stands with the law that owns it, and the others
/// answer to its tag.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Slip {
    /// Its place among all slips, likely ones first: where a wrong value has several causes they are named in this order.
    pub place: u8,
    /// A fixed tag: `sincos-swap`.
    pub tag: &'static str,
    /// What the student did.
    pub did: &'static str,
    /// What a good teacher says.
    pub sentence: &'static str,
    /// The other laws that answer to it.
    pub also: &'static [Law],
    /// Is it of the kind that a method mark condones, as a wrong sign is? Only the accuracy is lost then.
    pub condoned: bool,
}

impl Slip {
    /// Every slip with the law that owns it, in the order of their places.
    pub fn all() -> &'static [(Law, &'static Slip)] {
        static ALL: OnceLock<Vec<(Law, &'static Slip)>> = OnceLock::new();
        ALL.get_or_init(|| {
            let owned = |law: &Law| law.slips().iter().map(|slip| (*law, slip)).collect::<Vec<_>>();
            let mut all: Vec<(Law, &'static Slip)> = Law::ALL.iter().flat_map(owned).collect();
            all.sort_by_key(|(_, slip)| slip.place);
            all
        })
    }
}

/// The numbers a rule arrives at, in the order of its `gives`; there are rarely more than two.
pub type Outcome<N> = Option<SmallVec<[Datum<N>; 2]>>;

macro_rules! laws {
    ($($(#[$doc:meta])* $law:ident in $file:ident;)*) => {
        $(mod $file;)*

        /// A law of mechanics, or a step of mathematics that earns marks as one does.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
        pub enum Law {
            $($(#[$doc])* $law,)*
        }

        impl Law {
            /// Every law, in the order in which a worked solution uses them.
            pub const ALL: &[Law] = &[$(Law::$law),*];

            /// Its name in a bank file: `momentum`, `line of centres`.
            pub fn name(self) -> &'static str {
                match self { $(Law::$law => $file::NAME,)* }
            }

            /// The ways to use it, made anew.
            fn own_rules(self) -> Vec<Rule> {
                match self { $(Law::$law => $file::rules(),)* }
            }

            /// The slips that students make with it.
            pub fn slips(self) -> &'static [Slip] {
                match self { $(Law::$law => $file::SLIPS,)* }
            }

            /// What the method mark is for, and what the marker condones, in the markup of the bank.
            pub fn method(self) -> (&'static str, &'static str) {
                match self { $(Law::$law => $file::METHOD,)* }
            }
        }

        impl Law {
            /// Does it give an equation for two unknowns, to be solved with another?
            pub fn gives_equation(self) -> bool {
                self.gives(Quantity::MomentumEquation) || self.gives(Quantity::RestitutionEquation)
            }

            /// Does it give this quantity?
            pub fn gives(self, quantity: Quantity) -> bool {
                all_rules(&[]).iter().any(|rule| rule.law == self && rule.gives.contains(&quantity))
            }
        }

        impl Law {
            /// How its use shows in working.
            pub fn seen(self) -> Seen {
                match self { $(Law::$law => $file::SEEN,)* }
            }
        }

        impl Law {
            /// What the accuracy mark of its equation is for.
            pub fn accuracy(self) -> &'static str {
                match self { $(Law::$law => $file::ACCURACY,)* }
            }
        }

        impl Rule {
            fn earning(&self, show: &Show) -> Option<Expr> {
                match self.law { $(Law::$law => $file::earning(self, show),)* }
            }

            fn evaluated<N: Number>(&self, known: &Here<N>) -> Outcome<N> {
                match self.law { $(Law::$law => $file::evaluate(self, known),)* }
            }

            fn evaluated_with<N: Number>(&self, slip: &str, known: &Here<N>) -> Outcome<N> {
                match self.law { $(Law::$law => $file::slipped(slip, self, known),)* }
            }

            fn shown(&self, show: &Show) -> Vec<Line> {
                match self.law { $(Law::$law => $file::lines(self, show),)* }
            }
        }
    };
}

impl Law {
    /// Does it solve equations that other laws give, so that what it comes to is a value?
    pub fn only_solves(self) -> bool {
        self == Law::Solve
    }

    /// Does one mark stand for every component of a velocity that it gives?
    pub fn is_of_components(self) -> bool {
        matches!(self, Law::Resolve | Law::Perpendicular)
    }

    /// Does it make one quantity of others that it gives, as of the energies before and after what is lost?
    pub fn adds_up(self) -> bool {
        self == Law::Energy
    }
}

laws! {
    /// A velocity that one impact leaves is that with which the next begins.
    Carried in carried;
    /// Where the spheres touch: the line of centres from positions or from the offset of a path.
    Contact in contact;
    /// Components of a velocity.
    Resolve in resolve;
    /// No impulse perpendicular to the line of centres.
    Perpendicular in perpendicular;
    /// Momentum is conserved as a vector.
    VectorMomentum in vector_momentum;
    /// Momentum is conserved along the line of centres.
    Momentum in momentum;
    /// Newton's law of restitution.
    Restitution in restitution;
    /// Two equations for two unknowns.
    Solve in pair;
    /// Impulse is change of momentum.
    Impulse in impulse;
    /// The line of centres is the direction of the impulse.
    LineOfCentres in line_of_centres;
    /// Pythagoras.
    Speed in speed;
    /// The direction of a velocity.
    Direction in direction;
    /// The angle through which a path turns.
    Deflection in deflection;
    /// Kinetic energy, before, after and lost.
    Energy in energy;
    /// Velocities relative to each other.
    Relative in relative;
}

/// All rules of all laws, in the order of the list, for a scene with these later impacts, and the first if it is with a
/// wall.
pub fn all_rules(meetings: &[Meeting]) -> &'static [Rule] {
    static OF_ONE: OnceLock<Vec<Rule>> = OnceLock::new();
    static OF_SEVERAL: Mutex<BTreeMap<Vec<Meeting>, &'static [Rule]>> = Mutex::new(BTreeMap::new());
    let of_one = OF_ONE.get_or_init(|| Law::ALL.iter().flat_map(|law| law.own_rules()).collect());
    if meetings.is_empty() {
        return of_one;
    }
    // There are few ways in which three spheres can meet, and a bank uses very few of them.
    let mut known = OF_SEVERAL.lock().unwrap_or_else(PoisonError::into_inner);
    known.entry(meetings.to_vec()).or_insert_with(|| {
        let mut rules = of_one.clone();
        rules.extend(carried::between(meetings));
        let later = meetings.iter().filter(|meeting| meeting.number > 0);
        rules.extend(later.flat_map(|meeting| of_one.iter().map(|rule| rule.of_later(*meeting))));
        rules.leak()
    })
}

fn rule(law: Law, form: u8, needs: &[Quantity], gives: &[Quantity], cost: u32) -> Rule {
    Rule { law, form, needs: needs.to_vec(), gives: gives.to_vec(), cost, later: None }
}

fn number<N>(value: N) -> Outcome<N> {
    Some(smallvec![Datum::Number(value)])
}

/// The component of a sphere's velocity along an axis.
fn velocity(sphere: Sphere, moment: Moment, axis: Axis) -> Quantity {
    Quantity::Velocity(sphere, moment, axis)
}

/// The four components along the line of centres: A and B before, A and B after.
pub const ALONG: [Quantity; 4] = [
    Quantity::Velocity(Sphere::A, Moment::Before, Axis::N),
    Quantity::Velocity(Sphere::B, Moment::Before, Axis::N),
    Quantity::Velocity(Sphere::A, Moment::After, Axis::N),
    Quantity::Velocity(Sphere::B, Moment::After, Axis::N),
];

pub(super) const MASSES: [Quantity; 2] = [Quantity::Mass(Sphere::A), Quantity::Mass(Sphere::B)];

/// The rule with other numbers for some of what it needs: most slips take a wrong number into the right equation.
fn with_inputs<N: Number>(rule: &Rule, known: &Here<N>, inputs: &[(Quantity, N)]) -> Outcome<N> {
    if !inputs.iter().any(|(quantity, _)| rule.needs.contains(quantity)) {
        return None;
    }
    rule.evaluated(&known.with(inputs))
}

/// A velocity by its components along and across the line of centres, or else along i and j. What is known of the
/// component across after the impact is that it has not changed.
fn components<N: Number>(known: &Here<N>, sphere: Sphere, moment: Moment) -> Option<[N; 2]> {
    let at = |moment, axis| known.number(velocity(sphere, moment, axis));
    let across = || at(moment, Axis::T).or_else(|| at(Moment::Before, Axis::T));
    let along_and_across = at(moment, Axis::N).and_then(|along| Some([along, across()?]));
    along_and_across.or_else(|| Some([at(moment, Axis::X)?, at(moment, Axis::Y)?]))
}

/// The size of a velocity.
fn full_speed<N: Number>(known: &Here<N>, sphere: Sphere, moment: Moment) -> Option<N> {
    let [along, across] = components(known, sphere, moment)?;
    match known.number(Quantity::Speed(sphere, moment)) {
        Some(speed) if moment == Moment::Before => Some(speed),
        _ if across.is_nought() => Some(along.size()),
        _ => (along.squared() + across.squared()).root(),
    }
}

/// The size of a component: the spheres approach each other, which may decide its sign where letters leave it open.
fn size<N: Number>(component: N, known: &Here<N>) -> N {
    let along = |sphere| known.number(velocity(sphere, Moment::Before, Axis::N));
    component.size_where_positive(|| Some(along(Sphere::A)? - along(Sphere::B)?))
}

/// A number with the sign of another; of nought the sign that is given.
fn with_sign_of<N: Number>(size: &N, sign: &N, of_nought: &N) -> N {
    let unit = sign.over(&sign.size()).unwrap_or_else(|| of_nought.clone());
    size.size() * unit
}

/// The full speeds in place of the components along the line of centres before the impact, each with its sign; what moves
/// across it is taken to move towards the other sphere.
fn unresolved<N: Number>(known: &Here<N>) -> Option<[(Quantity, N); 2]> {
    let [a, b] = known.numbers([ALONG[0], ALONG[1]])?;
    let speed = |sphere| full_speed(known, sphere, Moment::Before);
    let one = a.one();
    let a_full = with_sign_of(&speed(Sphere::A)?, &a, &one);
    let b_full = with_sign_of(&speed(Sphere::B)?, &b, &-one);
    Some([(ALONG[0], a_full), (ALONG[1], b_full)])
}

/// Is the sphere at rest before the impact?
fn is_at_rest_before<N: Number>(known: &Here<N>, sphere: Sphere) -> bool {
    components(known, sphere, Moment::Before).is_some_and(|both| both.iter().all(N::is_nought))
}

/// Is B a wall, which has no mass and never moves?
fn is_at_wall<N: Number>(known: &Here<N>) -> bool {
    let after = known.number(velocity(Sphere::B, Moment::After, Axis::N));
    !known.knows(Quantity::Mass(Sphere::B)) && after.is_some_and(|after| after.is_nought())
}

fn first_equation(lines: &[Line]) -> Option<Expr> {
    lines.iter().find_map(|line| line.equations.first().cloned())
}

/// Nothing to show: the step is part of another.
fn silent() -> Vec<Line> {
    Vec::new()
}
