//! What a student calls a value: a right value under the name of another sphere or another quantity is for a person.
//!
//! A letter of the student's own (`v`, `x`, `w`) names nothing in particular. Only what the subject has one name for
//! does: words such as `impulse` and `deflection`, I or J for an impulse, e for the coefficient of restitution.

use crate::answer::Kind;
use crate::expr::Expr;
use crate::mark::reading::Statement;
use crate::mechanics::{Moment, Quantity};

use super::finding::Finding;
use super::statements::{named_sphere, sphere};
use super::{Model, Note};

/// What a name is the name of.
#[derive(Clone, Copy, PartialEq)]
enum Sort {
    Speed,
    /// It has a size and a direction, and either may be called by it.
    Velocity,
    Energy,
    Impulse,
    Angle,
    Deflection,
    Restitution,
    Mass,
}

/// What was found of a value, if it is called what is asked for.
pub(super) fn as_called(model: &Model, statement: &Statement, finding: Finding) -> Finding {
    let Some((label, asked)) = statement.label.as_ref().zip(model.quantity) else { return finding };
    if !finding.is_credited() {
        return finding;
    }
    let others = named_sphere(statement).zip(sphere(asked)).is_some_and(|(named, asked)| named != asked);
    // `speed of separation/speed of approach` is neither of the two.
    let is_ratio = label.typed.contains('/') || words(&label.typed).any(|word| word.eq_ignore_ascii_case("ratio"));
    let sorts: Vec<Sort> = words(&label.typed).filter_map(sort).filter(|_| !is_ratio).collect();
    if others || !(sorts.is_empty() || sorts.iter().any(|sort| suits(asked, *sort))) {
        return Finding::unreadable(Note::NamedOtherwise);
    }
    let is_loss = matches!(asked, Quantity::EnergyLost | Quantity::SphereEnergyLost(_) | Quantity::FractionLost);
    if is_loss && is_gain(&label.typed) && finding.note != Some(Note::ChangeNotLoss) {
        return finding.at_most_partial(Note::Sign);
    }
    finding
}

/// Is a value called what is asked for, by a name that the subject has for it? A letter of the student's own is none, nor
/// is what names a part of it.
pub(in crate::mark) fn is_named(model: &Model, statement: &Statement) -> bool {
    let Some(label) = &statement.label else { return false };
    if matches!(model.kind, Kind::Vector | Kind::Velocity | Kind::Line) {
        return true;
    }
    let Some(asked) = model.quantity else { return false };
    let spheres = (sphere(asked), named_sphere(statement));
    if is_of_a_part(&label.typed, asked) || spheres.1.is_some_and(|named| spheres.0 != Some(named)) {
        return false;
    }
    let has = |wanted: &[&str]| words(&label.typed).any(|word| wanted.contains(&word.to_lowercase().as_str()));
    let is_sort = || words(&label.typed).filter_map(sort).any(|sort| suits(asked, sort));
    let letter = match &label.expr {
        Some(Expr::Name(name)) => name.text.as_str(),
        _ => "",
    };
    let is_own_letter = || !model.vocabulary.letters.iter().any(|own| own.name() == letter);
    match asked.of_its_impact() {
        Quantity::Speed(..) | Quantity::Velocity(..) => {
            is_sort() || (spheres.1.is_some() && letter.starts_with(['v', 'V']))
        }
        Quantity::EnergyLost | Quantity::SphereEnergyLost(_) => {
            has(&["lost", "loss", "loses", "change", "decrease"]) || label.typed.contains(['Δ', '∆'])
        }
        Quantity::FractionLost => has(&["fraction", "proportion", "lost", "loss"]),
        Quantity::TanDeflection(_) | Quantity::TanToLine(..) => label.typed.starts_with("tan") || is_sort(),
        _ if asked.is_angle() => {
            is_sort() || (["theta", "phi", "alpha", "beta", "gamma", "delta"].contains(&letter) && is_own_letter())
        }
        Quantity::Mass(_) => is_sort() || (spheres.1.is_some() && letter.starts_with(['m', 'M'])),
        Quantity::Impulse(..) | Quantity::ImpulseMagnitude | Quantity::Restitution => is_sort(),
        Quantity::KineticEnergy(..) | Quantity::TotalEnergy(_) => is_sort(),
        _ => false,
    }
}

/// Does a label speak of a component, or of another moment, where that is not what is asked?
pub(in crate::mark) fn is_of_a_part(label: &str, asked: Quantity) -> bool {
    const COMPONENT: [&str; 14] = [
        "component",
        "components",
        "comp",
        "comps",
        "cpt",
        "perpendicular",
        "perp",
        "parallel",
        "para",
        "along",
        "i",
        "j",
        "x",
        "y",
    ];
    const BEFORE: [&str; 4] = ["before", "initial", "initially", "original"];
    let asked = asked.of_its_impact();
    let is_whole = matches!(asked, Quantity::Speed(..));
    let is_after = matches!(asked, Quantity::Speed(_, Moment::After) | Quantity::Velocity(_, Moment::After, _))
        || matches!(asked, Quantity::KineticEnergy(_, Moment::After) | Quantity::TotalEnergy(Moment::After))
        || matches!(asked, Quantity::EnergyLost | Quantity::SphereEnergyLost(_));
    let several = words(label).count() > 1;
    words(label).map(str::to_lowercase).any(|word| {
        let is = |list: &[&str]| list.contains(&word.as_str());
        (is_whole && several && is(&COMPONENT)) || (is_after && is(&BEFORE) && !label.contains("after"))
    })
}

fn words(label: &str) -> impl Iterator<Item = &str> {
    label.split(|letter: char| !letter.is_alphanumeric())
}

/// Does the label speak of a gain, which a loss is the opposite of?
pub(super) fn is_gain(label: &str) -> bool {
    let is = |wanted: &[&str]| words(label).any(|word| wanted.contains(&word.to_lowercase().as_str()));
    is(&["gain", "gains", "gained", "increase", "increases", "increased"]) && !is(&["loss", "lost", "loses"])
}

fn sort(word: &str) -> Option<Sort> {
    match word {
        "I" | "J" => return Some(Sort::Impulse),
        "e" => return Some(Sort::Restitution),
        _ => {}
    }
    match word.to_lowercase().as_str() {
        "speed" | "speeds" => Some(Sort::Speed),
        "velocity" | "velocities" | "vel" => Some(Sort::Velocity),
        "ke" | "kinetic" | "energy" => Some(Sort::Energy),
        "impulse" | "momentum" => Some(Sort::Impulse),
        "angle" | "angles" | "direction" | "bearing" => Some(Sort::Angle),
        "deflection" | "deflected" => Some(Sort::Deflection),
        "restitution" => Some(Sort::Restitution),
        "mass" => Some(Sort::Mass),
        _ => None,
    }
}

/// May the quantity be called so?
fn suits(asked: Quantity, sort: Sort) -> bool {
    use Quantity::*;
    match asked {
        Velocity(..) | Speed(..) | Approach | Separation => matches!(sort, Sort::Speed | Sort::Velocity),
        KineticEnergy(..) | TotalEnergy(_) | EnergyLost | SphereEnergyLost(_) | FractionLost => sort == Sort::Energy,
        SphereMomentum(..) | TotalMomentum(_) | Impulse(..) | ImpulseMagnitude => sort == Sort::Impulse,
        AngleToLine(..) | AngleFromN(..) | AngleFromI(..) | AngleToWall(..) | AngleBetween(_) | Alpha => {
            matches!(sort, Sort::Angle | Sort::Velocity)
        }
        Deflection(_) | SignedDeflection(_) | TanDeflection(_) => matches!(sort, Sort::Angle | Sort::Deflection),
        Restitution => sort == Sort::Restitution,
        Mass(_) | MassRatio => sort == Sort::Mass,
        _ => true,
    }
}
