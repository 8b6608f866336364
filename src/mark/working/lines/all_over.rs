//! A quotient typed on one line without the brackets that its long stroke stands for: `0.5 = w - v / 8 cos 48°`.

/// A line with what was meant: all that stands before such a stroke, as far as the equals sign, is above it.
///
/// Blanks on both sides of a stroke make it long, and so does e alone, or its number, on the other side.
pub(super) fn all_over(typed: &str) -> Option<String> {
    let sides: Vec<&str> = typed.split('=').collect();
    let is_e_beside = |own: usize| {
        let mut others = sides.iter().enumerate().filter(|(place, _)| *place != own).map(|(_, side)| side.trim());
        sides.len() > 1 && others.all(|side| side == "e" || is_number(side))
    };
    let put: Vec<Option<String>> =
        sides.iter().enumerate().map(|(place, side)| over(side, is_e_beside(place))).collect();
    let is_meant = sides.len() > 1 && put.iter().any(Option::is_some);
    is_meant.then(|| {
        let each = put.into_iter().zip(&sides).map(|(put, side)| put.unwrap_or_else(|| (*side).to_owned()));
        each.collect::<Vec<_>>().join("=")
    })
}

/// One side with brackets around what stands above its stroke, if that is a sum; with `is_all` no blanks are asked for.
fn over(side: &str, is_all: bool) -> Option<String> {
    let is_sign = |sign: char| matches!(sign, '+' | '-' | '−');
    let outside = outside(side);
    let (at, stroke) = *outside.iter().find(|(_, sign)| matches!(sign, '/' | '⁄' | '∕'))?;
    let (above, below) = (&side[..at], &side[at + stroke.len_utf8()..]);
    let first = side.len() - side.trim_start().len();
    let is_sum = outside.iter().any(|(place, sign)| first < *place && *place < at && is_sign(*sign));
    let is_long = above.ends_with(' ') && below.starts_with(' ');
    let has_another =
        outside.iter().filter(|(place, _)| *place > at).any(|(_, sign)| is_sign(*sign) || *sign == stroke);
    let is_meant = is_sum && (is_all || is_long && !has_another);
    is_meant.then(|| format!(" ({})/({})", above.trim(), below.trim()))
}

/// The signs that stand outside brackets, with their places.
fn outside(side: &str) -> Vec<(usize, char)> {
    let mut depth = 0_usize;
    let mut found = Vec::new();
    for (at, sign) in side.char_indices() {
        match sign {
            '(' | '[' | '{' => depth += 1,
            ')' | ']' | '}' => depth = depth.saturating_sub(1),
            _ if depth == 0 => found.push((at, sign)),
            _ => {}
        }
    }
    found
}

fn is_number(side: &str) -> bool {
    side.starts_with(|sign: char| sign.is_numeric() || sign == '.')
        && side.chars().all(|sign| sign.is_numeric() || matches!(sign, '.' | '/'))
}
