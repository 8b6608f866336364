//! What an answer asks for, as slips see it.

use crate::answer::Kind;
use crate::bank::Find;
use crate::mechanics::Quantity;

/// What an answer asks for.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Asked {
    /// A quantity, or the components of a vector.
    Quantities(Vec<Quantity>),
    /// The letter that is found backwards; of an angle the angle.
    Unknown,
    /// The values that this letter can have: their ends.
    Ends,
}

impl Asked {
    /// What an answer of this kind asks for.
    pub fn of(find: &Find, kind: Kind) -> Asked {
        match find {
            _ if kind == Kind::Range => Asked::Ends,
            Find::Unknown(_) => Asked::Unknown,
            _ => Asked::Quantities(find.quantities()),
        }
    }

    /// The quantities.
    pub fn quantities(&self) -> &[Quantity] {
        match self {
            Asked::Quantities(quantities) => quantities,
            Asked::Unknown | Asked::Ends => &[],
        }
    }
}
