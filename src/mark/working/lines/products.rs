//! Products as students type them in lines, with the sign that is meant: `3 x 4`, `ma` for m times their own a, `½m5²`.

use std::borrow::Cow;

use crate::mark::reading::Vocabulary;
use crate::number::Letter;

/// Which products a student types in a working.
pub(super) struct Products {
    /// Is x a letter of the question?
    has_x: bool,
    /// Is m one?
    has_m: bool,
    /// Are a and b the student's own letters for velocities?
    own_a_and_b: bool,
}

impl Products {
    pub(in crate::mark::working) fn of<'t>(mut lines: impl Iterator<Item = &'t str>, letters: &[Letter]) -> Products {
        let has = |name: &str| letters.iter().any(|letter| letter.name() == name);
        let (has_x, has_m) = (has("x"), has("m"));
        let is_free = has_m && !has("a") && !has("b");
        Products { has_x, has_m, own_a_and_b: is_free && lines.any(has_a_and_b) }
    }

    /// A line with the signs of its products.
    pub(super) fn signed<'t>(&self, typed: &'t str) -> Cow<'t, str> {
        let mut signed = without_units(typed);
        if !self.has_x && signed.contains(" x ") {
            signed = Cow::Owned(with_times(&signed));
        }
        if signed.contains("e ") {
            signed = Cow::Owned(with_e_apart(&signed));
        }
        if self.has_m && signed.contains('m') {
            signed = Cow::Owned(self.with_masses_apart(&signed));
        }
        signed
    }

    /// `m a` for `ma`, and `m × 5²` for `m5²`.
    fn with_masses_apart(&self, typed: &str) -> String {
        let mut out = String::with_capacity(typed.len() + 8);
        for (at, sign) in typed.char_indices() {
            out.push(sign);
            let (before, after) = (&typed[..at], &typed[at + sign.len_utf8()..]);
            if sign != 'm' || before.ends_with(|sign: char| sign.is_alphabetic() || sign == '_' || sign == '\\') {
                continue;
            }
            let ends = |rest: &str| !rest.starts_with(|sign: char| sign.is_alphanumeric() || sign == '_');
            let is_velocity = ["a", "b"].into_iter().any(|own| after.strip_prefix(own).is_some_and(ends));
            if self.own_a_and_b && is_velocity {
                out.push(' ');
            } else if is_number_times(before, after) {
                out.push_str(if after.starts_with(' ') { " ×" } else { " × " });
            }
        }
        out
    }
}

/// `3 kg × 5 m/s = 3 kg × v + 4 kg × w` without its units: a kilogram that is multiplied says no more than its number.
fn without_units(typed: &str) -> Cow<'_, str> {
    const VELOCITY: [&str; 7] = ["m/s", "ms⁻¹", "m s⁻¹", "ms^-1", "ms^{-1}", "ms-1", "m s^-1"];
    let is_multiplied =
        |rest: &str| rest.trim_start().starts_with(['×', '*', '·', '⋅', '(']) || rest.starts_with(" x ");
    let has_factor = typed.split("kg").skip(1).any(is_multiplied);
    if !has_factor || !typed.contains('=') {
        return Cow::Borrowed(typed);
    }
    let mut out = String::with_capacity(typed.len());
    let mut rest = typed;
    while let Some(next) = rest.chars().next() {
        let is_after_number = out.trim_end().ends_with(|sign: char| sign.is_ascii_digit() || sign == ')');
        let unit = ["kg"].iter().chain(&VELOCITY).find(|unit| is_after_number && rest.starts_with(**unit));
        let ends = |unit: &&&str| !rest[unit.len()..].starts_with(|sign: char| sign.is_alphanumeric() || sign == '_');
        match unit.filter(ends) {
            Some(unit) => rest = &rest[unit.len()..],
            None => {
                out.push(next);
                rest = &rest[next.len_utf8()..];
            }
        }
    }
    Cow::Owned(out)
}

/// Do a and b stand on one side of an equals sign, or on both, each by itself?
fn has_a_and_b(line: &str) -> bool {
    let stands = |own: &str| line.split(|sign: char| !sign.is_alphabetic()).any(|word| word == own);
    // `cosα` is no word, nor is `evcosα`.
    let is_word = |word: &str| word.len() > 4 && word.bytes().all(|sign| sign.is_ascii_alphabetic());
    let in_words = line.split_whitespace().any(is_word);
    line.contains('=') && !in_words && stands("a") && stands("b")
}

/// `3 x 4` and `2 x v` with the sign of times: an x that stands between two factors is no letter.
fn with_times(typed: &str) -> String {
    let mut out = String::with_capacity(typed.len() + 8);
    for (place, part) in typed.split(" x ").enumerate() {
        if place > 0 {
            let is_after_factor = out.ends_with(|sign: char| sign.is_ascii_digit() || ")½¼¾⅓⅔".contains(sign));
            let next = part.trim_start_matches(['-', '−']);
            let is_before_factor = next.starts_with(|sign: char| sign.is_alphanumeric() || "(√½¼¾⅓⅔".contains(sign));
            out.push_str(if is_after_factor && is_before_factor { " × " } else { " x " });
        }
        out.push_str(part);
    }
    out
}

/// `e × 10 cos α` for `e 10 cos α`: a number after the coefficient of restitution and a blank, with more behind it.
fn with_e_apart(typed: &str) -> String {
    let mut out = String::with_capacity(typed.len() + 8);
    let mut before = None;
    for (at, sign) in typed.char_indices() {
        out.push(sign);
        let is_alone =
            sign == 'e' && !before.is_some_and(|sign: char| sign.is_alphabetic() || sign == '_' || sign == '\\');
        let number = typed[at + sign.len_utf8()..].strip_prefix(' ');
        let behind = number.map(|rest| rest.trim_start_matches(|sign: char| sign.is_ascii_digit() || sign == '.'));
        let goes_on = behind.is_some_and(|behind| {
            behind.trim_start().starts_with(|sign: char| sign.is_alphabetic() || sign == '(' || sign == '√')
        });
        if is_alone && goes_on && number.is_some_and(|rest| rest.starts_with(|sign: char| sign.is_ascii_digit())) {
            out.push_str(" ×");
        }
        before = Some(sign);
    }
    out
}

/// Does a number follow an m that it multiplies: squared, under or before a root, or after a blank? `m1` is a mass.
fn is_number_times(before: &str, after: &str) -> bool {
    let number = after.trim_start_matches(' ');
    let is_apart = number.len() < after.len();
    let rest = number.trim_start_matches(|sign: char| sign.is_ascii_digit() || sign == '.');
    let is_squared = rest.starts_with('²') || rest.starts_with("^2");
    let is_factor = before.trim_end().ends_with(|sign: char| sign.is_ascii_digit() || "=+-−)½".contains(sign));
    rest.len() < number.len()
        && number.starts_with(|sign: char| sign.is_ascii_digit())
        && is_factor
        && (is_squared || rest.starts_with('√') || is_apart && !rest.trim_start().starts_with(char::is_alphabetic))
}

/// Functions of an angle.
pub(in crate::mark::working) const FUNCTIONS: [&str; 3] = ["sin", "cos", "tan"];

/// The letters that stand before a sine, cosine or tangent as in `xcosθ`, which is no word.
pub(super) fn factors_of_functions(typed: &str) -> impl Iterator<Item = &str> {
    let words = typed.split(|sign: char| !sign.is_ascii_alphabetic());
    let before = |word: &'_ str| FUNCTIONS.iter().find_map(|name| word.find(name));
    let factors = words.filter_map(move |word| before(word).map(|at| &word[..at]));
    factors.filter(|own| (1..=2).contains(&own.len()) && *own != "a")
}

/// Is each a letter by itself?
pub(super) fn has_letters(vocabulary: &Vocabulary, own: &str) -> bool {
    own.chars().all(|sign| vocabulary.letters.iter().any(|letter| letter.name().chars().eq([sign])))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::Range;

    fn signed(letters: &[&str], lines: &[&str]) -> Vec<String> {
        let letters: Vec<Letter> = letters.iter().filter_map(|name| Letter::new(name, Range::Real)).collect();
        let products = Products::of(lines.iter().copied(), &letters);
        lines.iter().map(|line| products.signed(line).into_owned()).collect()
    }

    #[test]
    fn an_x_between_factors_is_times_and_an_x_after_a_number_is_a_letter() {
        assert_eq!(signed(&[], &["1 x 5 + 2 x -1 = 2 x v"]), ["1 × 5 + 2 × -1 = 2 × v"]);
        assert_eq!(
            signed(&[], &["0.5 x 3 = 0.5x + 0.4y", "2 x + 3 y = 4"]),
            ["0.5 × 3 = 0.5x + 0.4y", "2 x + 3 y = 4"]
        );
        assert_eq!(signed(&["x"], &["5 x 3 = 4"]), ["5 x 3 = 4"]);
    }

    #[test]
    fn a_mass_beside_the_students_own_letters_is_a_factor() {
        assert_eq!(signed(&["m"], &["4m - 5m = ma + 3mb", "b - a = 6"])[0], "4m - 5m = m a + 3m b");
        assert_eq!(signed(&["m", "v"], &["7mv = 7ma", "b - a = ev cosα"])[0], "7mv = 7m a");
        assert_eq!(signed(&["m"], &["ma u + mb w = 3"]), ["ma u + mb w = 3"]);
        assert_eq!(signed(&["m"], &["½m5² + 1/2 m 13² = 97m"]), ["½m × 5² + 1/2 m × 13² = 97m"]);
        assert_eq!(signed(&["m"], &["√80 = m 3√2", "m1u1 = 3", "m 1 = 3"]), ["√80 = m × 3√2", "m1u1 = 3", "m 1 = 3"]);
    }
}
