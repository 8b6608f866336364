//! The moment of which a value is, by the words around it, and what belongs to an impact and to no moment of it.

use crate::mechanics::{Moment, Quantity};

use super::sorts::{Sort, sort, words};

/// Words for what there is before an impact, and for what there is once it is over.
const STATES: [&str; 9] = ["before", "initial", "after", "final", "left", "remaining", "remains", "retained", "kept"];
/// Those of them for what there is once it is over.
pub(super) const AT_THE_END: &[&str] = STATES.split_at(2).1;

/// Words that name what there is at one moment, and do not go with what is lost: a fraction may be one of the energy before.
pub(super) fn states(asked: Quantity) -> &'static [&'static str] {
    if asked == Quantity::FractionLost { AT_THE_END } else { &STATES }
}

pub(super) const EARLIER: [&str; 6] = ["before", "initial", "initially", "original", "incidence", "approach"];
/// Those of them that name a moment and no thing.
const BEFOREHAND: &[&str] = EARLIER.split_at(3).0;
pub(super) const LATER: [&str; 4] = ["after", "afterwards", "final", "finally"];

/// Words that speak of another moment for comparison: `7.31 as before`, `perpendicular to its direction before`.
pub(super) const COMPARING: [&str; 7] = ["as", "same", "direction", "path", "motion", "line", "velocity"];

const SEVERAL: [&str; 9] = ["first", "1st", "second", "2nd", "third", "3rd", "fourth", "4th", "next"];

/// The moment of which the quantity is, if it is of one.
pub(super) fn moment(asked: Quantity) -> Option<Moment> {
    use Quantity::*;
    match asked {
        Velocity(_, moment, _) | Speed(_, moment) | KineticEnergy(_, moment) | SphereMomentum(_, moment, _) => {
            Some(moment)
        }
        AngleToLine(_, moment) | AngleFromN(_, moment) | AngleFromI(_, moment) | AngleToWall(_, moment) => Some(moment),
        TanToLine(_, moment) | TOverN(_, moment) | TanToWall(_, moment) => Some(moment),
        TotalEnergy(moment) | AngleBetween(moment) => Some(moment),
        Approach => Some(Moment::Before),
        Separation => Some(Moment::After),
        _ => None,
    }
}

/// Does it belong to an impact and to no moment of it? An impulse, an angle turned through, a share lost, e.
fn is_of_the_impact(asked: Quantity) -> bool {
    use Quantity::*;
    is_a_turn(asked) || matches!(asked, Impulse(..) | ImpulseMagnitude | FractionLost | Restitution)
}

fn is_a_turn(asked: Quantity) -> bool {
    use Quantity::*;
    matches!(asked, Deflection(_) | SignedDeflection(_) | TanDeflection(_))
}

/// Does a name, in small letters, speak of the moment of what is asked, or of none?
pub(super) fn fit(asked: Quantity, name: &str) -> bool {
    let has = |wanted: &[&str]| words(name).any(|word| wanted.contains(&word));
    match moment(asked) {
        // Of several impacts one comes before the other.
        _ if has(&SEVERAL) => true,
        Some(Moment::After) => !has(&EARLIER) || has(&LATER),
        Some(Moment::Before) => !has(&LATER) || has(&EARLIER),
        // `initial angle`, but `turned from the original direction`
        None if is_a_turn(asked) => {
            let tells_of_a_turn = || words(name).any(|word| sort(word) == Some(Sort::Deflection));
            let is_of_one = has(&EARLIER) != has(&LATER);
            !is_of_one || tells_of_a_turn() || has(&["change", "from", "between"])
        }
        None if is_of_the_impact(asked) => !has(BEFOREHAND) || has(&LATER) || has(&["of", "change"]),
        None => true,
    }
}

/// Do the words beside a value speak of another moment than that of what is asked?
pub(super) fn are_of_another(asked: Quantity, remarks: &[&String]) -> bool {
    let has = |wanted: &[&str]| remarks.iter().flat_map(|remark| words(remark)).any(|word| wanted.contains(&word));
    let is_all = |word: &str| remarks.iter().any(|remark| remark.trim() == word);
    let is_of_another = match moment(asked) {
        Some(Moment::After) => (has(&["before", "initially"]) || is_all("initial")) && !has(&LATER),
        Some(Moment::Before) => has(&["after", "finally"]) && !has(&EARLIER),
        // `50 before impact`, but `a quarter of the energy before impact`
        None if is_of_the_impact(asked) => {
            const ALONE: [&str; 8] = ["before", "initially", "the", "impact", "collision", "it", "hits", ""];
            let is_alone = |remark: &&&String| words(remark).all(|word| ALONE.contains(&word));
            let mut alone = remarks.iter().filter(is_alone);
            alone.any(|remark| words(remark).any(|word| EARLIER.contains(&word)))
        }
        None => false,
    };
    is_of_another && !has(&SEVERAL) && !has(&COMPARING)
}

/// `KE1`, `kef`, `T_2`, `KEbefore`, `KE_A1`: an energy by its letters, and by the moment of which it is.
pub(super) fn is_energy_of_one(name: &str) -> bool {
    const MOMENTS: [&str; 8] = ["1", "2", "i", "f", "before", "after", "initial", "final"];
    let name = name.to_lowercase().replace('_', "");
    let rest = name.strip_prefix("ke").or_else(|| name.strip_prefix(['t', 'e', 'k']));
    let of_sphere = rest.and_then(|rest| rest.strip_prefix(['a', 'b', 'c']));
    [rest, of_sphere].into_iter().flatten().any(|moment| MOMENTS.contains(&moment))
}
