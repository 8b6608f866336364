//! From which line the words measure an angle.

use super::sentence::{Token, is_one_of};
use crate::expr::Expr;
use crate::mechanics::Axis;
use Token::{Number, Word};

/// The axis from which an angle is measured for which these words come next: along the line of centres and the normal to a
/// wall, or across it, as the tangent at the point of contact is.
pub fn measured_from(after: &[Token]) -> Option<Axis> {
    const DESCRIBED: [&str; 10] =
        ["the", "a", "this", "that", "smooth", "fixed", "vertical", "first", "second", "third"];
    let (mut is_across, mut is_normal) = (false, false);
    for (place, token) in after.iter().enumerate().take(10).take_while(|(_, token)| !is_value(token)) {
        let Word(word) = token else { continue };
        // `When it hits the wall` measures nothing.
        let lead = after[..place].iter().rev().find(|token| !is_one_of(token, &DESCRIBED));
        let is_line = lead.is_some_and(|lead| is_one_of(lead, &["with", "to", "and", "between"]));
        match word.as_str() {
            "perpendicular" => is_across = true,
            "normal" => (is_across, is_normal) = (true, true),
            "centres" | "centers" => return Some(if is_across { Axis::T } else { Axis::N }),
            "wall" if is_line => return Some(if is_across { Axis::N } else { Axis::T }),
            "common" if after.get(place + 1).is_some_and(|next| is_one_of(next, &["normal", "perpendicular"])) => {
                return Some(Axis::N);
            }
            "common" => return Some(Axis::T),
            "tangent" if is_line => return Some(if is_across { Axis::N } else { Axis::T }),
            _ => {}
        }
    }
    is_normal.then_some(Axis::N)
}

/// Is it a number or formula, and no equation?
fn is_value(token: &Token) -> bool {
    matches!(token, Number(expr, ..) if !matches!(expr, Expr::Relation(..)))
}
