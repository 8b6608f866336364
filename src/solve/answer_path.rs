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

/// The path to the components after the impact, if all that it starts from follows from what is given, the first so many
/// entries of what is known; and what is found on it is known then. Where a velocity after is given as well, the steps
/// themselves must say whether the two agree.
pub(super) fn answer_path(known: &mut Known<Value>, given: usize) -> Option<AnswerPath> {
    let of_after = |quantity: Quantity| {
        use Quantity::{GivenDirection, Speed, Velocity};
        // Of a direct impact it is given that nothing is across.
        matches!(
            quantity,
            Velocity(_, Moment::After, Axis::X | Axis::N) | Speed(_, Moment::After) | GivenDirection(_, Moment::After)
        )
    };
    if known.0.as_entered().take(given).any(of_after) {
        return None;
    }
    Derivation::carry_on(known, given, &BEFORE);
    let impact = impact(known)?;
    let selection = Selection::of(&impact, Wanted::ExactForm);
    let Found::Exact(after) = selection.solve(&impact) else { return None };
    for (quantity, [along, _]) in ALONG[2..].iter().zip(after) {
        known.0.insert_new(*quantity, Datum::Number(along));
    }
    Some((impact, selection))
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
