//! Momentum on two lines: `momentum before = 20` and `momentum after = v + 3w`.

use crate::expr::Expr;
use crate::mark::working::examine::Studied;
use crate::mark::working::lines::Member;

/// Where the second of the two stands, in which of the readings of its line, and the two as one equation.
pub(super) fn momentum(lines: &[Studied]) -> Option<(usize, usize, (Expr, Expr))> {
    let find = |words: &[&str]| {
        let readings = lines.iter().enumerate().flat_map(|(place, studied)| {
            studied.line.readings.iter().enumerate().map(move |(which, reading)| (place, which, reading))
        });
        readings
            .flat_map(|(place, which, reading)| reading.members.iter().map(move |member| (place, which, member)))
            .find(|(.., member)| is_momentum(member, words))
    };
    let (place, _, before) = find(&["before", "initial"])?;
    let (later, which, after) = find(&["after", "final"])?;
    (later != place).then(|| (later, which, (before.expr.clone(), after.expr.clone())))
}

/// Is it called the whole momentum at this moment, and no sphere's?
fn is_momentum(member: &Member, moment: &[&str]) -> bool {
    let Some(label) = &member.label else { return false };
    let words = || label.split(|sign: char| !sign.is_alphanumeric());
    let has = |wanted: &[&str]| words().any(|word| wanted.contains(&word.to_lowercase().as_str()));
    has(&["momentum"])
        && has(moment)
        && !has(&["change", "loss", "gain"])
        && !words().any(|word| matches!(word, "A" | "B"))
}
