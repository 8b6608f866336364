//! What earns a mark: the use of a law or of a condition, or a value.

use std::fmt;

use crate::mechanics::{Law, Quantity, Sphere};

/// The step of a solution that earns a mark.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum EarnedFor {
    /// The use of a law, for one sphere if it is named.
    Law(Law, Option<Sphere>),
    /// The use of a condition of the scene: `condition`.
    Condition,
    /// The value of a quantity.
    Quantity(Quantity),
    /// The values of two quantities, both of them: `A.after.n and B.after.n`.
    Both([Quantity; 2]),
    /// The value of a letter that the scene names among its unknowns.
    Unknown(String),
}

/// What a mark is `for` that is earned by using a condition of the scene.
const CONDITION: &str = "condition";

/// What stands between two quantities that a mark is for.
const BETWEEN: &str = " and ";

impl EarnedFor {
    /// A step by its name in bank files and keys: a law, perhaps with its sphere, a quantity or two, `condition`, or one of
    /// the letters that are to be found. `None` if it is none of them.
    ///
    /// ```
    /// use carom::bank::EarnedFor;
    /// let step = EarnedFor::read("speed A", &[]).unwrap();
    /// assert_eq!(step.to_string(), "speed A");
    /// assert_eq!(EarnedFor::read("A.after.n and B.after.n", &[]).unwrap().quantities().len(), 2);
    /// assert_eq!(EarnedFor::read("momentun", &[]), None);
    /// ```
    pub fn read(name: &str, unknowns: &[String]) -> Option<EarnedFor> {
        let name = name.trim();
        let (law, sphere) = match name.rsplit_once(' ') {
            Some((law, "A")) => (law, Some(Sphere::A)),
            Some((law, "B")) => (law, Some(Sphere::B)),
            _ => (name, None),
        };
        if let Some(law) = Law::ALL.iter().find(|known| known.name() == law) {
            return Some(EarnedFor::Law(*law, sphere));
        }
        if name == CONDITION {
            return Some(EarnedFor::Condition);
        }
        if let Ok(quantity) = name.parse::<Quantity>() {
            return Some(EarnedFor::Quantity(quantity));
        }
        if let Some((one, other)) = name.split_once(BETWEEN) {
            let both = [one.trim().parse().ok()?, other.trim().parse().ok()?];
            return (both[0] != both[1]).then_some(EarnedFor::Both(both));
        }
        unknowns.iter().any(|unknown| unknown == name).then(|| EarnedFor::Unknown(name.to_owned()))
    }

    /// The quantities whose values earn the mark; none where a step earns it.
    pub fn quantities(&self) -> &[Quantity] {
        match self {
            EarnedFor::Quantity(quantity) => std::slice::from_ref(quantity),
            EarnedFor::Both(both) => both,
            EarnedFor::Law(..) | EarnedFor::Condition | EarnedFor::Unknown(_) => &[],
        }
    }

    /// Is it the speed of the sphere whose direction this is? Where a scheme has no mark for the direction, its mark for
    /// the speed is for both: 'speed of *B*, along the line of centres'.
    pub fn is_speed_beside(&self, direction: Quantity) -> bool {
        let EarnedFor::Quantity(speed) = self else { return false };
        let beside = match direction.of_its_impact() {
            Quantity::AngleToLine(sphere, moment) | Quantity::AngleToWall(sphere, moment) => {
                Quantity::Speed(sphere, moment)
            }
            _ => return false,
        };
        speed.impact() == direction.impact() && speed.of_its_impact() == beside
    }

    /// The names of all steps that are neither quantities nor letters.
    pub fn names() -> Vec<&'static str> {
        Law::ALL.iter().map(|law| law.name()).chain([CONDITION]).collect()
    }
}

impl fmt::Display for EarnedFor {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            EarnedFor::Law(law, Some(sphere)) => write!(f, "{} {}", law.name(), sphere.name()),
            EarnedFor::Law(law, None) => f.write_str(law.name()),
            EarnedFor::Condition => f.write_str(CONDITION),
            EarnedFor::Quantity(quantity) => write!(f, "{quantity}"),
            EarnedFor::Both([one, other]) => write!(f, "{one}{BETWEEN}{other}"),
            EarnedFor::Unknown(name) => f.write_str(name),
        }
    }
}
