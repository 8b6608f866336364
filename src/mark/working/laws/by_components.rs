//! Momentum as a vector, written out along i and along j: `2(2) + 3 = 2(4) + x` and `2(5) - 2 = 2(4) + y`.

use super::impulse::Agrees;
use crate::expr::Expr;
use crate::mark::working::examine::{Studied, context};
use crate::mark::working::numbers::{Linear, Spread, Sum, difference, is_composite, size};
use crate::mark::working::prepared::Prepared;
use crate::mark::working::theirs::unknown_sphere;
use crate::mechanics::{Axis, Moment, Quantity, Sphere};

/// Momentum along an axis, with one unknown.
#[derive(Clone, Debug)]
pub(in crate::mark::working) struct AlongAxis {
    /// The place of the line.
    pub(super) place: usize,
    pub(super) agrees: Agrees,
    /// What the component that is to be found is called.
    pub(in crate::mark::working) letter: String,
    /// Which of the equations of the line it is.
    number: usize,
}

/// The two equations that agree best, along i and along j.
pub(in crate::mark::working) fn momentum_by_components(
    lines: &[Studied],
    prepared: &Prepared,
) -> Option<[AlongAxis; 2]> {
    let unknown = unknown_sphere(prepared)?;
    // A particle alone has no momentum to share.
    size(&prepared.known[0], Quantity::Mass(unknown.other()))?;
    let along = |axis| -> Vec<AlongAxis> {
        let each = lines.iter().enumerate().flat_map(|(place, studied)| {
            let equations = studied.reading.iter().flat_map(|reading| &reading.equations).enumerate();
            equations.filter_map(move |(number, equation)| {
                let (agrees, letter) = agreement(equation, unknown, axis, prepared)?;
                Some(AlongAxis { place, agrees, letter, number })
            })
        });
        each.collect()
    };
    let (x, y) = (along(Axis::X), along(Axis::Y));
    let pairs = x.iter().flat_map(|one| y.iter().map(move |other| (one, other)));
    // One equation in numbers is not both, though the components be equal.
    let pairs = pairs
        .filter(|(one, other)| (one.place, one.number) != (other.place, other.number) || one.letter != other.letter);
    let (one, other) = pairs.max_by_key(|(one, other)| one.agrees.min(other.agrees))?;
    Some([one.clone(), other.clone()])
}

/// How an equation agrees with momentum along an axis, and the letter of its unknown. Of a number alone it is not known how
/// it was found.
fn agreement(
    (left, right): &(Expr, Expr),
    unknown: Sphere,
    axis: Axis,
    prepared: &Prepared,
) -> Option<(Agrees, String)> {
    if !is_composite(left) && !is_composite(right) {
        return None;
    }
    let mut letter = None;
    let mut at = |point| {
        let linear = match difference(left, right, &context(prepared, point))? {
            Sum::Number(linear) => linear,
            // `… + m(xi + yj)` is both equations at once.
            Sum::Vector(along_i, along_j) => {
                if axis == Axis::X {
                    along_i
                } else {
                    along_j
                }
            }
        };
        let (name, number) = one_unknown(&linear)?;
        letter = Some(name.to_owned());
        let sought = size(&prepared.known[point], Quantity::Velocity(unknown, Moment::After, axis))?;
        let size = linear.size.max((number.middle() * sought).abs());
        let is_right = (number.times(sought) + linear.constant).may_be_nought(size);
        let is_momentum = || !signs(&linear, unknown, axis, prepared, point).is_empty();
        match is_right {
            true => Some(Agrees::Fully),
            false => is_momentum().then_some(Agrees::ButForSigns),
        }
    };
    let agrees = (0..prepared.points.count).map(&mut at).collect::<Option<Vec<_>>>()?.into_iter().min()?;
    Some((agrees, letter?))
}

fn one_unknown(linear: &Linear) -> Option<(&str, Spread)> {
    match linear.unknowns.as_slice() {
        [(name, number)] => Some((name, *number)),
        _ => None,
    }
}

/// The signs with which the three known momenta along an axis make up the constant of an equation that has the mass of the
/// other sphere before its one unknown.
pub(super) fn signs(linear: &Linear, unknown: Sphere, axis: Axis, prepared: &Prepared, point: usize) -> Vec<[f64; 3]> {
    let at = |quantity| size(&prepared.known[point], quantity);
    let momentum = |sphere, moment| Some(at(Quantity::Mass(sphere))? * at(Quantity::Velocity(sphere, moment, axis))?);
    let terms = [
        momentum(Sphere::A, Moment::Before),
        momentum(Sphere::B, Moment::Before),
        momentum(unknown.other(), Moment::After),
    ];
    let ([Some(a), Some(b), Some(after)], Some((_, number)), Some(mass)) =
        (terms, one_unknown(linear), at(Quantity::Mass(unknown)))
    else {
        return Vec::new();
    };
    let scale = number.middle() / mass;
    let all = (0..8).map(|bits| [0, 1, 2].map(|bit| if bits >> bit & 1 == 1 { -1.0 } else { 1.0 }));
    let sum = |[one, two, three]: &[f64; 3]| scale * (one * a + two * b + three * after);
    all.filter(|signs| linear.constant.may_be(sum(signs))).collect()
}
