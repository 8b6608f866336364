//! What stands around a number: it tells a factor from a part of the number.

use super::characters::{Glyph, OPEN};

/// Is there an operation besides the sign at this place, or more than one sign of equality? The strokes and signs of units are
/// none.
pub(super) fn has_operation(glyphs: &[Glyph], own: usize) -> bool {
    let sign = |at: usize| glyphs.get(at).map_or(' ', |glyph| glyph.sign);
    let equals = glyphs.iter().filter(|glyph| glyph.sign == '=').count();
    let is_operation = |at: usize| match sign(at) {
        '+' | '*' | '·' | '⋅' | '√' => at != own,
        '-' => at > 0 && !matches!(sign(at - 1), 's' | '^' | '(' | OPEN),
        '/' => sign(at + 1).is_ascii_digit() || matches!(sign(at + 1), '(' | OPEN),
        _ => false,
    };
    equals > 1 || (0..glyphs.len()).any(is_operation)
}

/// `w - v = 0.5(7)`: what a sum of letters equals is rather a law with its numbers in it than a result.
pub(super) fn equals_letters(glyphs: &[Glyph]) -> bool {
    let mut signs = glyphs.iter().map(|glyph| glyph.sign).filter(|sign| *sign != ' ').peekable();
    let (mut is_equation, mut has_sum, mut before) = (false, false, ' ');
    while let Some(sign) = signs.next() {
        is_equation |= sign == '=';
        let joins = matches!(sign, '+' | '-') && before.is_ascii_alphabetic();
        has_sum |= joins && signs.peek().is_some_and(|after| after.is_ascii_alphanumeric());
        before = sign;
    }
    is_equation && has_sum
}
