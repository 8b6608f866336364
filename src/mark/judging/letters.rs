//! What letters stand for by the custom of the subject.

use crate::mechanics::{Moment, Quantity};
use crate::unit::Unit;

use super::moments::moment;
use super::sorts::{Sort, sort, suits};
use super::{Model, left_side};

/// Can what is asked be called by this name?
pub(super) fn may_be_called(model: &Model, name: &str, typed: &str) -> bool {
    let is_own = !left_side::is_given(model, name)
        // A capital that was typed for itself.
        || (typed.chars().count() == 1 && typed != name && typed.to_lowercase() == name);
    if is_of_another_angle(model, name) {
        return false;
    }
    let Some(asked) = model.quantity else {
        let is_else = |letter: Sort| letter.is_unasked() || is_for_another_letter(model, letter);
        let is_unasked = is_own && of_letter(name).is_some_and(is_else);
        return !(is_product(name) || is_unasked);
    };
    // A capital, though the question has an e.
    if typed == "E" && suits(asked, Sort::Energy) {
        return true;
    }
    let letter = of_letter(name);
    // `v_x`: a component.
    const COMPONENTS: [&str; 9] = ["v_x", "v_y", "vx", "vy", "V_x", "V_y", "v_n", "v_t", "v_perp"];
    if matches!(asked, Quantity::Speed(..)) && COMPONENTS.contains(&name) {
        return false;
    }
    if is_own && moment(asked) == Some(Moment::After) && is_of_before(name) {
        return false;
    }
    match is_own {
        true => !is_product(name) && !is_abbreviation(name) && letter.is_none_or(|letter| letter_suits(asked, letter)),
        false => {
            matches!((asked, letter), (Quantity::Restitution, Some(Sort::Restitution)) | (Quantity::Alpha, Some(_)))
        }
    }
}

/// `u_A`, `v_0`: the custom has such for what was before the impact.
fn is_of_before(name: &str) -> bool {
    let mut letters = name.chars();
    let first = letters.next();
    let subscript = letters.as_str().trim_start_matches('_');
    match first {
        Some('u' | 'U') => matches!(subscript, "A" | "B" | "C" | "P" | "Q" | "1" | "2"),
        Some('v' | 'V') => matches!(subscript, "0" | "i" | "before" | "initial"),
        _ => false,
    }
}

/// Is a letter to be found, and this the sort of thing that it does not stand for? A `k` stands for none.
pub(super) fn is_for_another_letter(model: &Model, sort: Sort) -> bool {
    model.letter.as_deref().is_some_and(|letter| of_letter(letter) != Some(sort))
}

/// The unit of what a letter stands for, where the subject has one.
pub(super) fn unit_of(letter: &str) -> Option<Unit> {
    match of_letter(letter)? {
        Sort::Mass => Some(Unit::Kilogram),
        Sort::Speed => Some(Unit::MetrePerSecond),
        Sort::Restitution => Some(Unit::None),
        _ => None,
    }
}

/// Is it a Greek letter that stands for another angle than the one that is asked? `θ` and `φ` are anybody's.
pub(super) fn is_of_another_angle(model: &Model, name: &str) -> bool {
    let is_angle = |name: &str| of_letter(name) == Some(Sort::Angle);
    if !is_angle(name) || left_side::is_given(model, name) {
        return false;
    }
    let is_other = |own: &String| is_angle(own) && own != name && !matches!(name, "theta" | "phi" | "θ" | "φ");
    model.other_angles.iter().any(|other| other == name) || model.letter.iter().chain(&model.angle).any(is_other)
}

/// `mv`: two letters of quantities side by side, and no letter with its subscript.
fn is_product(name: &str) -> bool {
    (2..=3).contains(&name.len()) && name.chars().all(|letter| "mMuvwVIe".contains(letter))
}

/// `GPE`: capitals that are short for something that nobody asks.
fn is_abbreviation(name: &str) -> bool {
    let capitals = name.len() > 1 && name.chars().all(|letter| letter.is_ascii_uppercase());
    capitals && of_letter(name).is_none() && sort(name).is_none()
}

/// What a letter stands for by the custom of the subject, whatever its subscript.
pub(super) fn of_letter(name: &str) -> Option<Sort> {
    if matches!(name, "alpha" | "beta" | "gamma" | "delta" | "theta" | "phi" | "psi") {
        return Some(Sort::Angle);
    }
    let mut letters = name.chars();
    let first = letters.next()?;
    let subscript = letters.as_str().trim_start_matches('_');
    let is_subscript =
        subscript.len() <= 2 && subscript.chars().all(|sign| "ABCPQabcpqxyntijkf0123456789".contains(sign));
    if !is_subscript || matches!(name, "max" | "min") {
        return None;
    }
    match first {
        'u' | 'v' | 'w' | 'U' | 'V' | 'W' => Some(Sort::Speed),
        'm' | 'M' => Some(Sort::Mass),
        'I' | 'J' => Some(Sort::Impulse),
        'E' | 'K' => Some(Sort::Energy),
        'F' => Some(Sort::Unasked),
        // Gravity, where the question does not have it.
        'g' if name == "g" => Some(Sort::Unasked),
        'e' => Some(Sort::Restitution),
        'α' | 'β' | 'γ' | 'δ' | 'θ' | 'φ' | 'ψ' => Some(Sort::Angle),
        _ => None,
    }
}

/// May the quantity be called by such a letter?
fn letter_suits(asked: Quantity, letter: Sort) -> bool {
    use Quantity::*;
    let is_speed = matches!(asked, Velocity(..) | Speed(..) | Approach | Separation);
    match letter {
        Sort::Speed | Sort::Velocity => is_speed,
        Sort::Angle | Sort::Deflection => asked.unit() == Unit::Degree,
        // A capital may be meant for the coefficient.
        Sort::Energy => asked == Restitution || (!is_speed && suits(asked, letter)),
        _ => asked.unit() != Unit::Degree && !left_side::is_tangent(Some(asked)) && suits(asked, letter),
    }
}
