//! With how many figures a formula is written that has decimals in it.

use crate::expr::Expr;
use crate::number::Places;

use super::accuracy::{FEWEST, Written, suffices};

/// The coarsest of the decimals in a formula.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Coarsest {
    pub(super) figures: u32,
    pub(super) places: i64,
}

impl Coarsest {
    /// Of the decimals in an expression; `None` if it has none.
    pub(super) fn of(expr: &Expr) -> Option<Coarsest> {
        let own = match expr {
            Expr::Decimal(text) => Written::text(text).map(|w| Coarsest { figures: w.figures, places: w.places }),
            // An exponent is a count and no measurement.
            Expr::Power(base, _) => return Coarsest::of(base),
            _ => None,
        };
        expr.children()
            .into_iter()
            .filter_map(Coarsest::of)
            .chain(own)
            .reduce(|one, two| Coarsest { figures: one.figures.min(two.figures), places: one.places.max(two.places) })
    }

    /// Are there as many figures as the places ask for?
    pub(super) fn suffices(&self, places: &Places) -> bool {
        suffices(self.figures, self.places, places)
    }

    /// Are they too few to be evidence of anything?
    pub(super) fn is_worthless(&self) -> bool {
        self.figures < FEWEST
    }
}
