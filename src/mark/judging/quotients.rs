//! Names that are quotients: which of two quantities stands over the other.

use crate::mechanics::Quantity;

use super::sorts::words;

/// `m_A/m_B` where the mass of B over that of A is asked, `approach/separation` for the coefficient of restitution,
/// `n/t` for the tangent of the angle with the line of centres.
pub(super) fn is_upside_down(label: &str, asked: Quantity) -> bool {
    let label = label.to_lowercase();
    let asked = asked.of_its_impact();
    let is_tangent = matches!(asked, Quantity::TanToLine(..) | Quantity::TOverN(..));
    // Of an angle it is an equation, `cot θ = 3/4`.
    if is_tangent && label.trim() == "cot" {
        return true;
    }
    let sides =
        label.split_once(['/', ':']).or_else(|| label.split_once(" over ")).or_else(|| label.split_once(" to "));
    let Some((above, below)) = sides else { return false };
    let ends = |side: &str, name: &str| side.trim_matches([' ', '(', ')', '{', '}']).ends_with(name);
    match asked {
        Quantity::MassRatio => ends(above, "a") && ends(below, "b"),
        Quantity::Restitution => {
            above.contains("app") && below.contains("sep") || is_of_speeds_before(above) && is_of_speeds_after(below)
        }
        _ if is_tangent => lies(above, &ALONG) && lies(below, &ACROSS),
        _ => false,
    }
}

/// Names of what lies along the line of centres, and across it. How **i** and x lie differs from question to question.
const ALONG: [&str; 5] = ["n", "along", "parallel", "para", "loc"];
const ACROSS: [&str; 6] = ["t", "perp", "perpendicular", "across", "tangent", "tangential"];

/// Is it called so, by a word or by the subscript of a letter?
fn lies(side: &str, names: &[&str]) -> bool {
    side.split(|sign: char| !sign.is_alphanumeric()).any(|word| names.contains(&word))
}

/// `u`, `u_A − u_B`: only what the subject has for speeds before an impact.
fn is_of_speeds_before(side: &str) -> bool {
    has_letter(side, 'u') && !is_of_speeds_after(side)
}

/// `v`, `w − v`
fn is_of_speeds_after(side: &str) -> bool {
    has_letter(side, 'v') || has_letter(side, 'w')
}

/// Does one of its names begin with this letter, and have no more than a subscript after it?
fn has_letter(side: &str, letter: char) -> bool {
    words(side).any(|word| word.starts_with(letter) && word.len() <= 2)
}

/// Is it a quotient, or a ratio in words, of other things than make up what is asked: `(u − v)/w`, `speed after/speed before`
/// for the coefficient of restitution?
pub(super) fn is_another(label: &str, asked: Quantity) -> bool {
    if asked.of_its_impact() != Quantity::Restitution {
        return false;
    }
    let small = label.to_lowercase();
    let has = |wanted: &[&str]| words(&small).any(|word| wanted.contains(&word));
    let is_mixed = |(above, _): (&str, &str)| has_letter(above, 'u') && is_of_speeds_after(above);
    let is_of_plain_speeds = has(&["speed", "speeds", "velocity", "velocities"])
        && !has(&["separation", "approach", "relative", "component", "components", "along", "difference", "normal"]);
    small.split_once('/').is_some_and(is_mixed) || is_of_plain_speeds
}
