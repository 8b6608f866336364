//! What letters that nobody has explained may stand for in the two equations, tried one after the other.

use crate::expr::Expr;
use crate::mark::working::examine::Working;
use crate::mechanics::{Moment, Quantity, Sphere};

impl Working<'_> {
    /// Does a velocity after the impact come to nought of which nobody has said so? Without its term a line is no law.
    pub(super) fn has_unsaid_nought(&self, after: &[[f64; 2]]) -> bool {
        let is_of = |sphere: Sphere, quantity: &Quantity| match quantity {
            Quantity::Velocity(of, Moment::After, _) | Quantity::Speed(of, Moment::After) => *of == sphere,
            _ => false,
        };
        let is_said = |sphere| {
            let mut known = self.prepared.given[0].0.keys().chain(self.theirs.values.keys());
            known.any(|quantity| is_of(sphere, quantity))
        };
        let is_nought = |place: usize| after.iter().all(|velocities| velocities[place].abs() < 1e-9);
        let is_free = self.question.scene.conditions.is_empty();
        is_free && (0..2).any(|place| is_nought(place) && !is_said(Sphere::BOTH[place]))
    }
}

/// What a letter may stand for by its name, as places in a list of both velocities, both the other way, e, both masses and each
/// mass in parts of the other: a velocity after the impact either way, that of the sphere if it names one, a mass, or e. A mass
/// that is to be found may also be so many times the other, `km`.
pub(super) fn may_stand_for(name: &str, of: Option<Sphere>, is_mass_open: bool) -> &'static [usize] {
    match name.chars().next() {
        Some('e') if name == "e" => &[4],
        Some('m' | 'M') => &[5, 6],
        _ if of == Some(Sphere::A) => &[0, 2],
        _ if of == Some(Sphere::B) => &[1, 3],
        Some('u' | 'v' | 'w' | 'U' | 'V' | 'W' | 'x' | 'y' | 'X' | 'Y' | 'p' | 'q') => &[0, 1, 2, 3],
        _ if is_mass_open => &[0, 1, 2, 3, 4, 5, 6, 7, 8],
        _ => &[0, 1, 2, 3, 4, 5, 6],
    }
}

/// Two letters are not both the velocity of one sphere.
pub(super) fn are_of_one(one: usize, other: usize) -> bool {
    one == other || (one < 4 && other < 4 && one % 2 == other % 2)
}

/// One choice for each letter, by the number of the trial.
pub(super) fn chosen(trial: usize, choices: &[&[usize]]) -> Vec<usize> {
    let mut rest = trial;
    let one = |choices: &&[usize]| {
        let chosen = choices[rest % choices.len()];
        rest /= choices.len();
        chosen
    };
    choices.iter().map(one).collect()
}

/// The degree of a formula in letters of some kind; what is under a power or a root is of more than one.
pub(super) fn degree(expr: &Expr, is_one: &dyn Fn(&str) -> bool) -> usize {
    let of = |expr: &Expr| degree(expr, is_one);
    match expr {
        Expr::Name(name) => usize::from(is_one(&name.text)),
        Expr::Product(factors) => factors.iter().map(of).sum(),
        Expr::Quotient(above, below) => of(above) + of(below),
        Expr::Power(base, _) | Expr::Call(_, base) => 2 * of(base),
        other => other.children().into_iter().map(of).max().unwrap_or(0),
    }
}
