//! From what a scene gives to the components after the impact, by the least model that suffices.
//!
//! Velocities are resolved first, along and across the line of centres, which is exact; then the selector looks at the
//! values. What it computes enters the derivation where a step gives just that: the step is still taken, printed
//! and marked, and only its arithmetic is done once.

use crate::mechanics::{ALONG, Axis, Datum, Derivation, Known, Moment, Quantity, Sphere};
use crate::method::{Found, Impact, Selection, Wanted};
use crate::number::Value;

/// The impact in the axes of the line of centres, first along it, then across; and the model that suffices for it.
pub(super) type AnswerPath = (Impact<Value>, Selection);

/// What must be known before the impact: masses, e, and the components.
const BEFORE: [Quantity; 7] = [
    Quantity::Mass(Sphere::A),
    Quantity::Mass(Sphere::B),
    Quantity::Restitution,
    Quantity::Velocity(Sphere::A, Moment::Before, Axis::N),
    Quantity::Velocity(Sphere::A, Moment::Before, Axis::T),
    Quantity::Velocity(Sphere::B, Moment::Before, Axis::N),
    Quantity::Velocity(Sphere::B, Moment::Before, Axis::T),
];

/// The path to the components after the impact with all that is known on it, if all that it starts from follows from what is
/// given. Where a velocity after is
/// given as well, the steps themselves must say whether the two agree. Some of what follows may have been derived already.
pub(super) fn answer_path(given: &Known<Value>, derived: &Known<Value>) -> Option<(AnswerPath, Known<Value>)> {
    let of_after = |quantity: &Quantity| {
        use Quantity::{GivenDirection, Speed, Velocity};
        // Of a direct impact it is given that nothing is across.
        matches!(
            quantity,
            Velocity(_, Moment::After, Axis::X | Axis::N) | Speed(_, Moment::After) | GivenDirection(_, Moment::After)
        )
    };
    if given.0.keys().any(of_after) {
        return None;
    }
    let mut computed = given.clone();
    Derivation::carry_out_with(&mut computed, derived, &BEFORE);
    let impact = impact(&computed)?;
    let selection = Selection::of(&impact, Wanted::ExactForm);
    let Found::Exact(after) = selection.solve(&impact) else { return None };
    for (quantity, [along, _]) in ALONG[2..].iter().zip(after) {
        computed.0.insert_new(*quantity, Datum::Number(along));
    }
    Some(((impact, selection), computed))
}

/// The impact in the axes of the line of centres.
pub(super) fn impact(known: &Known<Value>) -> Option<Impact<Value>> {
    let [m_a, m_b, e, a_n, a_t, b_n, b_t] = known.numbers(BEFORE)?;
    Some(Impact {
        masses: [m_a, m_b],
        before: [[a_n, a_t], [b_n, b_t]],
        line: [Value::ONE, Value::ZERO],
        restitution: e,
    })
}
