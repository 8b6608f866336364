//! A given angle whose sine, cosine or tangent was taken wrongly: after `cos α = √3/2` every √3/2 stands for the cosine of α,
//! and 1/2 for its sine.

use std::cmp::Reverse;

use super::angles::{NEW, definition};
use crate::expr::{Expr, Function};
use crate::mark::working::examine::context;
use crate::mark::working::numbers::{constant, sizes};
use crate::mark::working::prepared::Prepared;
use crate::mark::working::theirs::is_nearly_right;
use crate::mechanics::{Moment, Quantity, Sphere};

/// Two angles in degrees: the one that was taken, and the one that is given.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct WrongAngle {
    taken: f64,
    given: f64,
}

/// More factors do not make one sine: `√3/2`, `(2√5)/5`.
const MOST_FACTORS: u32 = 3;

/// Of a longer product only so many factors are looked at.
const MOST_TRIED: usize = 8;

impl WrongAngle {
    /// `cos α = √3/2` of an angle that the question gives, and that is another.
    pub(super) fn of(equation: &(Expr, Expr), prepared: &Prepared) -> Option<WrongAngle> {
        let (name, taken) = definition(equation, prepared)?;
        let named = prepared.angles.iter().find(|(own, _)| *own == name).map(|(_, angle)| *angle);
        let given = named.or_else(|| only_angle(prepared).filter(|_| !NEW.contains(&name.as_str())))?;
        // At 45 degrees nobody can tell a sine from a cosine.
        let is_other = !is_nearly_right(taken, given) && (1.0..89.0).contains(&taken) && (taken - 45.0).abs() > 0.1;
        is_other.then_some(WrongAngle { taken, given })
    }

    /// Is it the same given angle?
    pub(super) fn is_of_the_same(&self, other: &WrongAngle) -> bool {
        self.given == other.given
    }

    /// A product some of whose factors make the sine, cosine or tangent of the angle that was taken, with that of the given one
    /// in their place: `8 × √3/2`, which is read as 8√3 over 2.
    pub(super) fn undone_in_product(&self, expr: &Expr, prepared: &Prepared) -> Option<Expr> {
        let factors = factors(expr);
        let (tried, _) = factors.split_at(factors.len().min(MOST_TRIED));
        let size = |factor: &Factor| {
            let size =
                constant(&factor.expr, &context(prepared, 0)).filter(|_| factor.expr.names().is_empty())?.middle();
            Some(if factor.is_below { size.recip() } else { size })
        };
        let sizes: Vec<Option<f64>> = tried.iter().map(size).collect();
        let chosen = |set: u32| move |place: usize| place < MOST_TRIED && set >> place & 1 == 1;
        // `2/√5` is the cosine, where 1/√5 alone would be the sine.
        let mut sets: Vec<u32> = (1..1 << tried.len()).filter(|set: &u32| set.count_ones() <= MOST_FACTORS).collect();
        sets.sort_by_key(|set| Reverse(set.count_ones()));
        let (set, function) = sets.into_iter().find_map(|set| {
            let is_chosen = chosen(set);
            let own = (0..sizes.len()).filter(|place| is_chosen(*place)).map(|place| sizes[place]);
            let product = own.product::<Option<f64>>()?;
            let function = self.function(product).filter(|_| !is_given(product, prepared))?;
            Some((set, function))
        })?;
        let is_chosen = chosen(set);
        let rest = factors.into_iter().enumerate().filter(|(place, _)| !is_chosen(*place)).map(|(_, factor)| factor);
        let (below, above): (Vec<Factor>, Vec<Factor>) = rest.partition(|factor| factor.is_below);
        let right = Expr::call(function, Expr::degrees(Expr::Decimal(format!("{:.12}", self.given))));
        let above = Expr::Product(std::iter::once(right).chain(above.into_iter().map(|factor| factor.expr)).collect());
        let below: Vec<Expr> = below.into_iter().map(|factor| factor.expr).collect();
        Some(if below.is_empty() { above } else { above.over(Expr::Product(below)) })
    }

    /// Which function of the angle that was taken is this number, to as many figures as anybody writes?
    fn function(&self, number: f64) -> Option<Function> {
        let angle = self.taken.to_radians();
        let all = [(Function::Cos, angle.cos()), (Function::Sin, angle.sin()), (Function::Tan, angle.tan())];
        all.into_iter().find(|(_, value)| (value - number).abs() <= 6e-4 * value).map(|(function, _)| function)
    }
}

/// The angle with the line of centres before the impact, where there is one and nobody has given it a name.
fn only_angle(prepared: &Prepared) -> Option<f64> {
    let angle = |sphere| sizes(&prepared.known, Quantity::AngleToLine(sphere, Moment::Before))?.first().copied();
    let is_open = |angle: &f64| (1.0..179.0).contains(angle) && (angle - 90.0).abs() > 1.0;
    let mut angles = Sphere::BOTH.into_iter().filter_map(angle).filter(is_open);
    angles.next().filter(|_| prepared.angles.is_empty() && angles.next().is_none())
}

/// Is it a number of the question, or its *e*? These are left alone.
fn is_given(number: f64, prepared: &Prepared) -> bool {
    let is_it = |own: f64| (own - number).abs() < 1e-9;
    let is_e = || sizes(&prepared.known, Quantity::Restitution).is_some_and(|e| e.first().is_some_and(|e| is_it(*e)));
    let value = |given: &Expr| constant(given, &context(prepared, 0));
    prepared.given_numbers.iter().filter_map(value).any(|given| is_it(given.middle())) || is_e()
}

/// A factor of a product, or what stands below its line.
struct Factor {
    expr: Expr,
    is_below: bool,
}

fn factors(expr: &Expr) -> Vec<Factor> {
    let turned = |factor: Factor| Factor { is_below: !factor.is_below, ..factor };
    match expr {
        Expr::Product(inner) => inner.iter().flat_map(factors).collect(),
        Expr::Quotient(above, below) => {
            factors(above).into_iter().chain(factors(below).into_iter().map(turned)).collect()
        }
        other => vec![Factor { expr: other.clone(), is_below: false }],
    }
}
