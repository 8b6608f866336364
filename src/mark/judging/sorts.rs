//! The words that the subject has for quantities, and which of them go with what is asked.

use crate::mark::reading::is_dotted;
use crate::mechanics::Quantity;

/// What a name is the name of.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Sort {
    Speed,
    /// It has a size and a direction, and either may be called by it.
    Velocity,
    Energy,
    Impulse,
    Angle,
    Deflection,
    /// From the north, which no question has.
    Bearing,
    /// What no question asks for.
    Unasked,
    Restitution,
    Mass,
}

impl Sort {
    /// Is it what no question asks for?
    pub(super) fn is_unasked(self) -> bool {
        matches!(self, Sort::Bearing | Sort::Unasked)
    }
}

/// The words of a text; `k.e.` is one, without its last full stop.
pub(super) fn words(label: &str) -> impl Iterator<Item = &str> {
    let pieces = label.split(|letter: char| !letter.is_alphanumeric() && letter != '.');
    pieces.flat_map(|piece| {
        let (dotted, plain) = if is_dotted(piece) { (Some(piece.trim_end_matches('.')), "") } else { (None, piece) };
        dotted.into_iter().chain(plain.split('.').filter(move |_| dotted.is_none()))
    })
}

/// What a word is the name of.
pub(super) fn sort(word: &str) -> Option<Sort> {
    match word {
        "I" | "J" => return Some(Sort::Impulse),
        "e" => return Some(Sort::Restitution),
        _ => {}
    }
    match word.to_lowercase().as_str() {
        "speed" | "speeds" => Some(Sort::Speed),
        "velocity" | "velocities" | "vel" => Some(Sort::Velocity),
        "ke" | "k.e" | "kinetic" | "energy" => Some(Sort::Energy),
        "impulse" | "momentum" => Some(Sort::Impulse),
        "angle" | "angles" | "direction" => Some(Sort::Angle),
        "bearing" => Some(Sort::Bearing),
        "acceleration" | "work" | "distance" | "force" | "time" => Some(Sort::Unasked),
        "deflection" | "deflected" | "deflects" | "turned" | "turns" | "deviation" | "deviated" | "deviates"
        | "rotated" | "rotates" => Some(Sort::Deflection),
        "restitution" | "cor" | "c.o.r" => Some(Sort::Restitution),
        "mass" => Some(Sort::Mass),
        _ => None,
    }
}

/// May the quantity be called so?
pub(super) fn suits(asked: Quantity, sort: Sort) -> bool {
    use Quantity::*;
    match asked {
        _ if sort.is_unasked() => false,
        Velocity(..) | Speed(..) | Approach | Separation => matches!(sort, Sort::Speed | Sort::Velocity),
        KineticEnergy(..)
        | TotalEnergy(_)
        | EnergyLost
        | SphereEnergyLost(_)
        | SphereEnergyGained(_)
        | FractionLost => sort == Sort::Energy,
        SphereMomentum(..) | TotalMomentum(_) | Impulse(..) | ImpulseMagnitude => sort == Sort::Impulse,
        AngleToLine(..) | AngleFromN(..) | AngleFromI(..) | AngleToWall(..) | AngleBetween(_) | Alpha => {
            matches!(sort, Sort::Angle | Sort::Velocity)
        }
        Deflection(_) | SignedDeflection(_) | TanDeflection(_) => matches!(sort, Sort::Angle | Sort::Deflection),
        TanToLine(..) | TOverN(..) | TanToWall(..) => matches!(sort, Sort::Angle | Sort::Velocity),
        Restitution => sort == Sort::Restitution,
        Mass(_) | MassRatio => sort == Sort::Mass,
        _ => true,
    }
}

/// Is it lost or gained in an impact?
pub(super) fn is_of_change(asked: Quantity) -> bool {
    is_of_gain(asked) || matches!(asked, Quantity::EnergyLost | Quantity::SphereEnergyLost(_) | Quantity::FractionLost)
}

/// Is it gained?
pub(super) fn is_of_gain(asked: Quantity) -> bool {
    matches!(asked, Quantity::SphereEnergyGained(_))
}

/// Words for what is lost.
pub(super) const LOSSES: [&str; 10] =
    ["loss", "losses", "lost", "lose", "loses", "decrease", "decreases", "decreased", "change", "dissipated"];

/// Words for what is gained.
pub(super) const GAINS: [&str; 7] = ["gain", "gains", "gained", "increase", "increases", "increased", "change"];

/// Words for what is lost, or gained where that is asked.
pub(super) fn changes_in_words(asked: Quantity) -> &'static [&'static str] {
    if is_of_gain(asked) { &GAINS } else { &LOSSES }
}
