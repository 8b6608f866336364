//! Two formulas that are set equal where one value is asked.

use crate::expr::Expr;
use crate::mark::reading::{Form, Said};

use super::chain::has_arithmetic;
use super::coarsest::Coarsest;
use super::exact::{self, Equality, same};
use super::finding::Finding;
use super::number::as_it_stands;
use super::{Model, Note};

/// `5m/2 × 8u = 20mu`: two ways of writing one value, of which the second is the answer.
pub(super) fn said_twice(model: &Model, said: &Said, sides: [&Expr; 2]) -> Finding {
    let [left, right] =
        sides.map(|side| as_it_stands(model, &Said { form: Form::Value(side.clone()), ..said.clone() }, None));
    let is_one = same(sides[0], sides[1], &model.vocabulary.letters) == Equality::Equal;
    if is_one || (left.is_correct() && right.is_correct()) || (right.exact && left.is_credited()) {
        right
    } else if left.exact && (Coarsest::of(sides[1]).is_some() || is_finished(model, sides)) {
        // `√7u/4 = 0.66u`: what comes after the exact value is its decimal, or a slip in making it simpler.
        left.remarked(Note::IgnoredAfter)
    } else if right.is_correct() && has_names_of_its_own(model, sides) {
        // `mv(1 + e) sin α = 4mv sin α/3`: with what is given of e, for a person to see.
        Finding::unreadable(Note::CannotBeCompared)
    } else {
        Finding::WRONG
    }
}

/// Is there a letter on the left that is not on the right, and none that is to be found? In `k/2 = 8` it is the only one, and
/// what is found.
fn has_names_of_its_own(model: &Model, [left, right]: [&Expr; 2]) -> bool {
    let (on_the_left, on_the_right) = (left.names(), right.names());
    let is_own = |own: &str| on_the_right.iter().all(|name| name.text != own);
    on_the_left.len() > 1
        && on_the_left.iter().any(|name| is_own(&name.text))
        && on_the_left.iter().all(|name| Some(&name.text) != model.letter.as_ref())
}

/// Is nothing left to be worked out in the first of two sides, which is a formula with numbers in it and no law, where the
/// second is in the letters of the question too?
fn is_finished(model: &Model, [left, right]: [&Expr; 2]) -> bool {
    fn has_number(expr: &Expr) -> bool {
        matches!(expr, Expr::Number(_)) || expr.children().into_iter().any(has_number)
    }
    let is_known = exact::unknown_letter(right, &model.vocabulary.letters).is_none();
    // `5M = m` is no slip in making 5m simpler.
    let is_simpler = !right.names().is_empty() && !matches!(right, Expr::Name(_));
    is_known && is_simpler && has_number(left) && !has_arithmetic(left)
}
