//! Formulas that are right but for powers of their letters: `10m(1 − e²)` for `10mu²(1 − e²)` is no energy.

use std::collections::BTreeSet;

use crate::expr::Expr;
use crate::mark::enclosure::enclose_roughly;
use crate::number::Range;
use crate::unit::Unit;

use super::exact::{self, Equality};
use super::{Model, letters};

/// The powers by which a letter may be left out, or be too much.
const POWERS: [i64; 5] = [0, 1, 2, -1, -2];

/// More letters for masses and speeds no question has.
const MOST_LETTERS: usize = 2;

/// Is it the model once it is multiplied by powers of masses and speeds?
pub(super) fn is_right_but_for_powers(model: &Model, expr: &Expr) -> bool {
    let is_measured = |name: &str| matches!(letters::unit_of(name), Some(Unit::Kilogram | Unit::MetrePerSecond));
    let positive = model.vocabulary.letters.iter().filter(|letter| letter.range() == Range::Positive);
    let names: Vec<&str> = positive.map(|letter| letter.name()).filter(|name| is_measured(name)).collect();
    // All other letters are there.
    let others = |expr: &Expr| -> BTreeSet<String> {
        expr.names().into_iter().map(|name| name.text.clone()).filter(|name| !names.contains(&name.as_str())).collect()
    };
    if names.is_empty() || names.len() > MOST_LETTERS || expr.is_zero() || others(&model.value) != others(expr) {
        return false;
    }
    let mut products = vec![expr.clone()];
    for name in names {
        let times = |product: &Expr| {
            POWERS.map(|power| match (product.clone(), Expr::name(name).to_the(power.abs())) {
                (product, _) if power == 0 => product,
                (product, letters) if power > 0 => Expr::product([product, letters]),
                (product, letters) => product.over(letters),
            })
        };
        products = products.iter().flat_map(times).collect();
    }
    products.iter().skip(1).any(|product| is_near(model, product) && exact::equals(model, product) == Equality::Equal)
}

/// Is it the model, as far as doubles show?
fn is_near(model: &Model, product: &Expr) -> bool {
    let known = model.known();
    exact::points(&model.vocabulary.letters).all(|point| {
        let found = enclose_roughly(product, &model.vocabulary.letters, point);
        known.roughly(point).zip(found).is_some_and(|(right, found)| right.overlaps(found))
    })
}
