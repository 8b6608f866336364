//! Marks of Markdown around letters and answers: bold, italic, underlined.

use super::characters::Glyph;

/// `_2.78_`, `*2.78*`: an answer without the marks of Markdown around all of it.
pub(super) fn without_emphasis(mut glyphs: Vec<Glyph>) -> Vec<Glyph> {
    let is_blank = |glyph: &Glyph| glyph.sign.is_whitespace();
    while let Some(first) = glyphs.iter().position(|glyph| !is_blank(glyph)).filter(|at| glyphs.len() > at + 2)
        && let Some(last) = glyphs.iter().rposition(|glyph| !is_blank(glyph))
        && matches!(glyphs[first].sign, '*' | '_')
        && glyphs[first].sign == glyphs[last].sign
    {
        glyphs.remove(last);
        glyphs.remove(first);
    }
    glyphs
}

/// `4**i** + **j**`, `**2.78**`: bold letters of Markdown without its stars. Between a base and a bare exponent two stars
/// are a power.
pub(super) fn without_bold(mut glyphs: Vec<Glyph>) -> Vec<Glyph> {
    let mut from = 0;
    loop {
        let sign = |at: usize| glyphs.get(at).map_or(' ', |glyph| glyph.sign);
        let stars = |at: &usize| sign(*at) == '*' && sign(*at + 1) == '*';
        let Some(open) = (from..glyphs.len()).find(stars) else { return glyphs };
        let before = open.checked_sub(1).map_or(' ', sign);
        let of_vector = matches!(sign(open + 2), 'i' | 'j') && stars(&(open + 3));
        let may_open = of_vector || matches!(before, ' ' | '+' | '-' | '=' | ',' | '\n');
        let may_close = |at: &usize| {
            let after = sign(*at + 2);
            stars(at) && sign(*at - 1) != ' ' && !after.is_alphanumeric() && after != '('
        };
        let close = (open + 3..glyphs.len()).find(may_close).filter(|_| may_open && sign(open + 2) != ' ');
        match close {
            Some(close) => {
                glyphs.drain(close..close + 2);
                glyphs.drain(open..open + 2);
                from = open;
            }
            None => from = open + 2,
        }
    }
}

/// `4*i* - 3*j*`, `_v_ = 4_i_`: a letter between two marks without them, where nothing follows that could be multiplied.
pub(super) fn without_italics(mut glyphs: Vec<Glyph>) -> Vec<Glyph> {
    let mut at = 0;
    while at + 2 < glyphs.len() {
        if is_italic(&glyphs, at) {
            glyphs.remove(at + 2);
            glyphs.remove(at);
        }
        at += 1;
    }
    glyphs
}

fn is_italic(glyphs: &[Glyph], at: usize) -> bool {
    let sign = |at: usize| glyphs.get(at).map_or(' ', |glyph| glyph.sign);
    let before = at.checked_sub(1).map_or(' ', sign);
    let is_mark = matches!(sign(at), '*' | '_') && sign(at + 2) == sign(at) && before != sign(at);
    let letter = sign(at + 1);
    let is_letter = match letter {
        'i' | 'j' => !before.is_alphabetic(),
        _ => letter.is_ascii_alphabetic() && matches!(before, ' ' | '\n'),
    };
    let next = glyphs[at + 3..].iter().map(|glyph| glyph.sign).find(|sign| *sign != ' ');
    is_mark && is_letter && next.is_none_or(|next| "+-=,;)\n".contains(next))
}
