//! What a student calls a value: a right value under the name of another sphere or another quantity is for a person.
//!
//! A letter of the student's own (`v`, `x`, `w`) names nothing in particular. Only what the subject has one name for
//! does: words such as `impulse` and `deflection`, I or J for an impulse, e for the coefficient of restitution.

use crate::mark::reading::Statement;
use crate::mechanics::Quantity;

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
