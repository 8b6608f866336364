//! Words that name another sphere or another quantity than the one that is asked.

use crate::expr::Expr;
use crate::mechanics::{Quantity, Sphere};

use super::Model;
use super::sorts::{sort, suits, words};
use super::spheres::sphere;

/// Does a remark that is no more than a name, as `(B)` or `(speed of B)`, name another sphere or another quantity?
pub(super) fn remark_names_another(model: &Model, asked: Quantity, remarks: &[&String], remark: &str) -> bool {
    const FILLERS: [&str; 25] = [
        "",
        "only",
        "alone",
        "its",
        "their",
        "the",
        "of",
        "by",
        "through",
        "on",
        "for",
        "is",
        "sphere",
        "ball",
        "particle",
        "lost",
        "loses",
        "after",
        "before",
        "impact",
        "collision",
        "with",
        "path",
        "motion",
        "s",
    ];
    if asked == Quantity::EnergyLost && words(remark).any(|word| word == "each") {
        return true;
    }
    if matches!(asked, Quantity::SphereEnergyLost(_) | Quantity::SphereEnergyGained(_))
        && words(remark).any(|word| word == "total")
    {
        return true;
    }
    if matches!(asked, Quantity::Impulse(..) | Quantity::ImpulseMagnitude) && words(remark).any(|word| word == "force")
    {
        return true;
    }
    // The wall is pushed as hard as the sphere, but the other way.
    if asked.of_its_impact() != Quantity::ImpulseMagnitude && ["on the wall", "on wall"].contains(&remark) {
        return true;
    }
    let of_relative_motion = |word: &str| matches!(word, "separation" | "approach");
    let is_either = asked == Quantity::Restitution || is_named_by_its_own(asked, remark);
    if !is_either && words(remark).any(of_relative_motion) {
        return true;
    }
    // `50 between A and B`
    let names_several = || {
        let mut all = remarks.iter().flat_map(|remark| words(remark));
        all.any(|word| matches!(word, "b" | "c" | "spheres" | "paths" | "velocities" | "directions"))
    };
    if matches!(asked, Quantity::AngleToLine(..)) && remark.contains("between") && names_several() {
        return true;
    }
    if matches!(asked, Quantity::Mass(_)) && words(remark).any(|word| word == "total") {
        return true;
    }
    // `2.78 lost`
    if matches!(asked, Quantity::Speed(..) | Quantity::Velocity(..)) && tells_difference(remark) {
        return true;
    }
    // `2 m/s in the i direction`
    if remark == "direction" {
        return false;
    }
    let is_name = |word: &str| {
        let small = word.to_lowercase();
        FILLERS.contains(&small.as_str()) || sort(&small).is_some() || matches!(&*small, "a" | "b" | "c")
    };
    // `10 m/s before the impulse`
    let remark = ["before the impulse", "after the impulse"]
        .iter()
        .find_map(|moment| remark.strip_suffix(moment))
        .unwrap_or(remark);
    if !words(remark).all(is_name) {
        return false;
    }
    // `by A and B` is two remarks.
    let is_alone = || remarks.iter().map(|remark| spheres_in_remark(remark).len()).sum::<usize>() == 1;
    let is_of_another = match (sphere(asked), spheres_in_remark(remark).as_slice()) {
        (Some(asked), [named]) => *named != asked && is_alone(),
        (None, [named]) => (model.is_of_both || model.strangers.contains(named)) && is_alone(),
        _ => false,
    };
    let mut sorts = words(remark).filter_map(|word| sort(&word.to_lowercase())).peekable();
    is_of_another || (sorts.peek().is_some() && !sorts.any(|sort| suits(asked, sort)))
}

/// `separation` for the speed of separation, but not for that of approach.
fn is_named_by_its_own(asked: Quantity, name: &str) -> bool {
    let has = |wanted: &str| words(name).any(|word| word == wanted);
    match asked {
        Quantity::Separation => has("separation"),
        Quantity::Approach => has("approach"),
        _ => false,
    }
}

/// The spheres that a remark names. In small letters an `a` is an article, unless it ends the words or goes before `to`.
pub(super) fn spheres_in_remark(remark: &str) -> Vec<Sphere> {
    let words: Vec<&str> = words(remark).filter(|word| !word.is_empty()).collect();
    let named = words.iter().enumerate().filter_map(|(at, word)| match *word {
        "a" => matches!(words.get(at + 1), None | Some(&("to" | "first" | "respectively"))).then_some(Sphere::A),
        "A" => Some(Sphere::A),
        "b" | "B" => Some(Sphere::B),
        "c" | "C" => Some(Sphere::C),
        _ => None,
    });
    named.collect()
}

/// Words for a component of a velocity.
pub(super) const PARTS: [&str; 4] = ["component", "components", "comp", "comps"];
/// Words that give a speed a direction, which is then that of a component.
pub(super) const DIRECTED: [&str; 8] =
    ["along", "parallel", "perpendicular", "perp", "normal", "tangential", "horizontal", "vertical"];
/// Words of which the name of a line has one.
const LINES: [&str; 11] = ["line", "loc", "centres", "centers", "normal", "tangent", "wall", "ab", "ba", "i", "j"];
/// Words for a difference of velocities, as in `speed of separation`.
const DIFFERENCES: [&str; 14] = [
    "relative",
    "average",
    "mean",
    "separation",
    "approach",
    "change",
    "difference",
    "lost",
    "loss",
    "loses",
    "gain",
    "gains",
    "gained",
    "reduction",
];
/// Words that tell a difference unless `to` follows them.
const CHANGES: [&str; 17] = [
    "increase",
    "increases",
    "increased",
    "decrease",
    "decreases",
    "decreased",
    "reduced",
    "reduces",
    "falls",
    "fell",
    "drop",
    "drops",
    "dropped",
    "slows",
    "slowed",
    "rises",
    "rose",
];

/// Do the words tell how far something changes, and not to what?
fn is_of_change(small: &str) -> bool {
    let has = |wanted: &[&str]| words(small).any(|word| wanted.contains(&word));
    has(&CHANGES) && !has(&["to"])
}

/// Do the words name a difference of velocities or of speeds?
fn tells_difference(small: &str) -> bool {
    words(small).any(|word| DIFFERENCES.contains(&word)) || is_of_change(small)
}

/// Do they tell to what something changes?
pub(super) fn is_changed_to(small: &str) -> bool {
    let has = |wanted: &[&str]| words(small).any(|word| wanted.contains(&word));
    has(&CHANGES) && has(&["to"])
}

/// Do words that name a speed or a momentum name another than is asked: a component of a velocity, a difference of speeds?
pub(super) fn is_another_of_its_sort(model: &Model, asked: Quantity, small: &str) -> bool {
    let has = |wanted: &[&str]| words(small).any(|word| wanted.contains(&word));
    let is_along = || model.path.as_ref().is_some_and(Expr::is_zero);
    match asked {
        Quantity::Speed(..) => {
            let is_directed = has(&DIRECTED) && !is_along();
            has(&PARTS) || is_directed || tells_difference(small)
        }
        Quantity::Velocity(..) => tells_difference(small),
        // `angle between the paths`, but `angle between its path and the line of centres`
        Quantity::AngleToLine(..) => has(&["between"]) && !has(&LINES),
        Quantity::Approach | Quantity::Separation => {
            has(&["approach", "separation"]) && (!is_named_by_its_own(asked, small) || small.contains('/'))
        }
        Quantity::Mass(_) => has(&["total", "combined"]),
        Quantity::Impulse(..) | Quantity::ImpulseMagnitude => {
            let is_difference = || has(&["change", "difference", "lost", "loss", "gain", "gained", "minus"]);
            let is_state =
                has(&["before", "after", "initial", "final", "original", "total"]) && !small.contains(['-', '−']);
            let is_of_one_moment = is_state || !small.contains(['-', '−', '/']);
            has(&["force", "per"]) || (has(&["momentum", "momenta"]) && is_of_one_moment && !is_difference())
        }
        // Both of them make it up.
        Quantity::Restitution => {
            has(&["separation"]) != has(&["approach"]) || has(&["fraction", "proportion", "lost", "loss"])
        }
        _ => false,
    }
}
