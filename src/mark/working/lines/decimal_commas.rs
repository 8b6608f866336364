//! Decimal commas in lines of working, `v = 2,4 cos 65° = 1,014`, where the whole working says that they are no other.

use std::borrow::Cow;

/// Does a working write its decimals with commas? It has no decimal point, no list and no pair of coordinates, and somewhere
/// figures that are neither two values nor thousands: `0,4`, `3,62`. Where the question has no `vectors`, brackets after a factor
/// hold one number: `2(2,5)`.
pub(super) fn has_decimal_commas<'t>(lines: impl Iterator<Item = &'t str>, vectors: bool) -> bool {
    let mut is_certain = false;
    for line in lines {
        let signs: Vec<char> = line.chars().collect();
        if places_between_digits(&signs, '.').next().is_some() {
            return false;
        }
        for comma in places_between_digits(&signs, ',') {
            let digits =
                |signs: &mut dyn Iterator<Item = &char>| signs.take_while(|sign| sign.is_ascii_digit()).count();
            let (whole, decimals) = (digits(&mut signs[..comma].iter().rev()), digits(&mut signs[comma + 1..].iter()));
            let sign = |back: usize| comma.checked_sub(back).map(|at| signs[at]);
            let after = signs.get(comma + decimals + 1).copied();
            // `4(-3,5)`
            let is_signed = matches!(sign(whole + 1), Some('-' | '−' | '–' | '+')) && matches!(after, Some(')' | ']'));
            let first = whole + 1 + usize::from(is_signed);
            let (before, factor) = (sign(first), sign(first + 1));
            let is_factor = !vectors && factor.is_some_and(char::is_alphanumeric);
            let is_pair = matches!(before, Some('(' | '[')) && matches!(after, Some(')' | ']')) && !is_factor;
            if is_pair || before == Some(',') || after == Some(',') {
                return false;
            }
            is_certain |= signs[comma - 1] == '0' && whole == 1 || decimals == 2 || decimals > 3;
        }
    }
    is_certain
}

/// Is there one bracket alone with two numbers and a comma between them without a blank, after a factor: `4(-3,5) = 4v + w`?
/// Where the question has no vectors it may be a number as well, and nobody knows.
pub(super) fn is_perhaps_a_decimal(typed: &str) -> bool {
    let signs: Vec<char> = typed.chars().collect();
    let mut commas = places_between_digits(&signs, ',');
    let (Some(comma), None) = (commas.next(), commas.next()) else { return false };
    let number = |sign: &char| sign.is_ascii_digit();
    let open = signs[..comma].iter().rposition(|sign| !number(sign) && !matches!(sign, '-' | '−' | '–' | '+'));
    let close = signs[comma + 1..].iter().find(|sign| !number(sign));
    let factor = open.and_then(|open| open.checked_sub(1)).map(|at| signs[at]);
    let is_pair = open.is_some_and(|open| signs[open] == '(') && close == Some(&')');
    let has_unit_vector = typed.split(|sign: char| !sign.is_alphabetic()).any(|word| matches!(word, "i" | "j"));
    is_pair && factor.is_some_and(char::is_alphanumeric) && !has_unit_vector && typed.matches(',').count() == 1
}

/// The line with points for its decimal commas.
pub(super) fn with_points(typed: &str) -> Cow<'_, str> {
    let mut signs: Vec<char> = typed.chars().collect();
    let commas: Vec<usize> = places_between_digits(&signs, ',').collect();
    if commas.is_empty() {
        return Cow::Borrowed(typed);
    }
    commas.into_iter().for_each(|at| signs[at] = '.');
    Cow::Owned(signs.into_iter().collect())
}

/// Where this sign stands with a digit on either side.
fn places_between_digits(signs: &[char], sign: char) -> impl Iterator<Item = usize> {
    (1..signs.len().saturating_sub(1))
        .filter(move |at| signs[*at] == sign && signs[at - 1].is_ascii_digit() && signs[at + 1].is_ascii_digit())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn commas_are_decimal_where_all_of_the_working_says_so() {
        let has = |working: &str| has_decimal_commas(working.lines(), false);
        let decimal =
            ["v = 3,62", "0,4(w - v) = 1,6", "√(3,62² + 1,5²) = 3,92", "v = 1,014\nw = 1,69", "2(2,5) = 4v\nw = 3,62"];
        assert!(has("2(-2,5) = 4v\nw = 3,62"));
        assert!(!has("v = (-3,25)") && !has_decimal_commas("2(-3,25) = I".lines(), true));
        assert!(is_perhaps_a_decimal("4(-3,5) = 4v + w") && is_perhaps_a_decimal("4(13,86) = 4v"));
        for other in ["4(-3, 5) = 4v", "(3,5) = v", "4(3,5) + 2(1,0) = I", "4(3,5) = 2i", "4(3,5) = (x, y)"] {
            assert!(!is_perhaps_a_decimal(other), "{other}");
        }
        let other = ["v = 2,4", "1,200 = 3v", "v = 2, w = 3,5", "(3,62)", "v = 3,62\nw = 1.5", "1,2,35", "v = 2,w = 5"];
        decimal.iter().for_each(|working| assert!(has(working), "{working}"));
        other.iter().for_each(|working| assert!(!has(working), "{working}"));
        assert!(!has_decimal_commas("2(2,5) = 4v\nw = 3,62".lines(), true));
        assert_eq!(with_points("√(3,62² + 1,5²), w = 2"), "√(3.62² + 1.5²), w = 2");
    }
}
