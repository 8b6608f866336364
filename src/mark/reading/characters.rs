//! Characters: what any keyboard, word processor or phone makes of a formula, in one small alphabet.
//!
//! Letters, digits and `+ - * / ^ = ( ) …` stay as they are, `−` becomes `-`, `²` becomes `^` and a group, `½` a group
//! of its own. Groups stand between `⟦` and `⟧`, which nobody types. A recurring digit has a combining dot after it.

use super::Unreadable;
use super::markup::{self, Sign, Typed};

/// A sign of the small alphabet, and where it came from.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Glyph {
    /// The sign.
    pub sign: char,
    /// First byte of what was typed.
    pub place: usize,
    /// One past its last byte.
    pub end: usize,
}

/// What opens a group that was not typed as brackets.
pub(super) const OPEN: char = '⟦';
/// What closes it.
pub(super) const CLOSE: char = '⟧';
/// The dot over a recurring digit; it follows the digit.
pub(super) const RECURS: char = '\u{307}';

/// The text in the small alphabet.
pub(super) fn glyphs(text: &str) -> Result<Vec<Glyph>, Unreadable> {
    let mut out = Vec::with_capacity(text.len());
    let typed = markup::signs(text);
    let mut at = 0;
    while let Some(&Typed { sign, place, end }) = typed.get(at) {
        let character = match sign {
            Sign::Character(character) => character,
            Sign::Tag(signs) => {
                out.extend(signs.chars().map(|sign| Glyph { sign, place, end }));
                at += 1;
                continue;
            }
        };
        if superscript(character).is_some() {
            let mut raised: String = typed[at..].iter().map_while(|typed| superscript(typed.character()?)).collect();
            if raised == "-" {
                // `s⁻1`: a keyboard with a raised minus and no raised digits
                let digit = |typed: &Typed| typed.character().filter(char::is_ascii_digit);
                raised.extend(typed[at + 1..].iter().map_while(digit));
            }
            let length = raised.chars().count();
            let end = typed[at + length - 1].end;
            // `ms-¹`, `s^-¹`: a minus that is not raised before a digit that is
            let is_minus_before = match out.as_slice() {
                [.., before, minus] => minus.sign == '-' && (before.sign == '^' || before.sign.is_alphabetic()),
                _ => false,
            };
            if is_minus_before && is_whole(&raised) && lowered_after_stroke(&typed[at + length..]).is_none() {
                out.pop();
                out.pop_if(|glyph| glyph.sign == '^');
                raised.insert(0, '-');
            }
            let is_power_of_ten = ends_with_times_ten(&out);
            let mut put = |sign: char| out.push(Glyph { sign, place, end });
            if let Some((below, length)) = lowered_after_stroke(&typed[at + length..]).filter(|_| is_whole(&raised)) {
                // `¹⁰⁄₄₃` is a fraction.
                let end = typed[at + raised.chars().count() + length - 1].end;
                let mut put = |sign: char| out.push(Glyph { sign, place, end });
                put(OPEN);
                raised.chars().for_each(&mut put);
                put('/');
                below.chars().for_each(&mut put);
                put(CLOSE);
                at += length;
            } else if raised == "0" && !is_power_of_ten {
                // One raised nought or circle is how degrees are often typed.
                put('°');
            } else {
                put('^');
                put(OPEN);
                raised.chars().for_each(&mut put);
                put(CLOSE);
            }
            at += length;
            continue;
        }
        let mut put = |sign: char| out.push(Glyph { sign, place, end });
        if let Some(lowered) = subscript(character) {
            let again = at > 0 && typed[at - 1].character().and_then(subscript).is_some();
            if !again {
                put('_');
            }
            put(lowered);
        } else if let Some((above, below)) = vulgar(character) {
            put(OPEN);
            [above, '/', below].into_iter().for_each(&mut put);
            put(CLOSE);
        } else {
            let before = out.last().map(|glyph: &Glyph| glyph.sign);
            match plain(character, before) {
                Some("") => {}
                Some(signs) => signs.chars().for_each(|sign| out.push(Glyph { sign, place, end })),
                None => {
                    out.push(Glyph { sign: lettered(character).ok_or_else(|| unknown(character, place))?, place, end })
                }
            }
        }
        at += 1;
    }
    Ok(out)
}

/// Do the glyphs end with a number times ten, as before its power?
fn ends_with_times_ten(glyphs: &[Glyph]) -> bool {
    let mut back = glyphs.iter().rev().map(|glyph| glyph.sign).filter(|sign| *sign != ' ');
    let ten = [back.next(), back.next()] == [Some('0'), Some('1')];
    ten && matches!(back.next(), Some('*' | '⋅' | '·' | 'x')) && back.next().is_some_and(|sign| sign.is_ascii_digit())
}

fn is_whole(digits: &str) -> bool {
    digits.chars().all(|digit| digit.is_ascii_digit())
}

/// The digits of `/₄₃`, and how many characters they take with the stroke.
fn lowered_after_stroke(rest: &[Typed]) -> Option<(String, usize)> {
    let (stroke, below) = rest.split_first()?;
    let lowered = |typed: &Typed| subscript(typed.character()?).filter(char::is_ascii_digit);
    let below: String = below.iter().map_while(lowered).collect();
    (matches!(stroke.character(), Some('/' | '⁄' | '∕')) && !below.is_empty()).then(|| (below.clone(), below.len() + 1))
}

/// `<4,1>` with its brackets as those of coordinates.
pub(super) fn without_pointed_brackets(mut glyphs: Vec<Glyph>) -> Vec<Glyph> {
    let find = |from: usize, signs: &[char]| (from..glyphs.len()).find(|at| signs.contains(&glyphs[*at].sign));
    let pair = find(0, &['<']).and_then(|open| Some((open, find(open + 1, &['<', '>', '=', '\n'])?)));
    if let Some((open, close)) = pair.filter(|(open, close)| {
        glyphs[*close].sign == '>' && glyphs[*open..*close].iter().filter(|glyph| glyph.sign == ',').count() == 1
    }) {
        glyphs[open].sign = '(';
        glyphs[close].sign = ')';
    }
    glyphs
}

/// Is there nothing but blanks, or a dash where somebody has no answer?
pub(super) fn say_nothing(glyphs: &[Glyph]) -> bool {
    glyphs.iter().all(|glyph| glyph.sign.is_whitespace() || glyph.sign == '-')
}

fn unknown(character: char, place: usize) -> Unreadable {
    let shown: String =
        if character.is_alphanumeric() { character.into() } else { character.escape_unicode().collect() };
    Unreadable::Sign(place, format!("the character `{shown}` has no meaning here"))
}

/// What a character stands for; nothing for what is invisible.
fn plain(character: char, before: Option<char>) -> Option<&'static str> {
    Some(match character {
        '\n' | '\r' | '\u{85}' | '\u{2028}' | '\u{2029}' => "\n",
        '−' | '‐' | '‑' | '‒' | '–' | '—' | '―' | '﹣' | '－' | '➖' => "-",
        '➕' | '＋' | '﹢' => "+",
        '﹥' => ">",
        '﹤' => "<",
        '×' | '✕' | '✖' | '∗' | '⨯' => "*",
        // A bullet begins a line.
        '∙' | '•' | '●' | '◦' | '▪' | '‣' | '▸' | '►' | '○' if matches!(before, None | Some('\n')) => {
            " "
        }
        '⋅' | '∙' | '•' => "⋅",
        '‧' | '⸱' | '・' => "·",
        '٫' => ".",
        '÷' | '➗' => "÷",
        '∕' | '⁄' => "/",
        '√' => "√",
        '∛' => "∛",
        'ᶜ' => " rad ",
        // Of a row that is meant as a column.
        'ᵀ' => "^T",
        '°' | 'º' | '˚' | '∘' => "°",
        '≈' | '≃' | '≅' | '≒' | '≐' => "≈",
        '≡' | '＝' | '﹦' => "=",
        '⩽' | '≦' => "≤",
        '⩾' | '≧' => "≥",
        '⇒' | '⟹' | '→' | '⟶' | '∴' | '➡' | '➔' | '➜' => "⇒",
        // To the right is the way that one reads on.
        '←' | '⟵' => " to the left ",
        '∵' => " because ",
        '∩' | '∧' => " and ",
        'ℝ' => "R",
        '@' => " at ",
        '⊥' | '⟂' => " perpendicular ",
        '∥' => " parallel to ",
        '∠' => " angle ",
        '∝' => " proportional to ",
        '‖' => "|",
        '㎧' => " m/s ",
        '㎏' => " kg ",
        '✓' | '✔' | '☑' | '✅' => " ",
        // Faces and the like say nothing of a value; the skin has a sign of its own.
        '\u{1f600}'..='\u{1f64f}'
        | '\u{1f910}'..='\u{1f92f}'
        | '\u{1f970}'..='\u{1f97a}'
        | '\u{1f3fb}'..='\u{1f3ff}' => " ",
        '👍' | '👌' | '👏' | '💪' | '🎉' | '✨' | '🔥' | '🚀' | '⭐' | '🌟' | '💯' | '☺' | '👉' | '📌' => {
            " "
        }
        '✗' | '✘' | '❌' => " rejected ",
        // The number of an equation.
        '①'..='⑳' | '❶'..='❿' => " ",
        '’' | '‘' | '′' | '´' | 'ʹ' | '`' => "'",
        '“' | '”' | '″' => "\"",
        '…' | '⋯' => "…",
        '‹' => "<",
        '›' => ">",
        '∊' => "∈",
        '∶' | 'ː' => ":",
        '⟨' => "(",
        '⟩' => ")",
        'ı' | 'î' | 'Î' | 'ĩ' | 'ⅈ' => "i",
        'ȷ' | 'ĵ' | 'Ĵ' | 'ⅉ' => "j",
        'ℓ' => "l",
        'ℎ' => "h",
        'ɑ' | '⍺' => "α",
        'ϑ' => "θ",
        'ϕ' => "φ",
        'ϵ' => "ε",
        'µ' => "μ",
        '∆' => "Δ",
        // A dot over a digit recurs; a hat, arrow, tilde or bar below marks a letter as a vector.
        '\u{335}' | '\u{336}' => "\u{336}",
        '\u{304}' | '\u{305}' if before.is_some_and(|sign| sign.is_ascii_digit()) => "\u{307}",
        '\u{307}' if before.is_some_and(|sign| sign.is_ascii_digit()) => "\u{307}",
        '\u{304}' | '\u{305}' | '\u{302}' | '\u{303}' | '\u{20d7}' | '\u{332}' | '\u{331}' | '\u{330}' | '\u{20d1}'
            if before.is_some_and(|sign| sign.is_ascii_alphabetic()) =>
        {
            ""
        }
        '\u{200b}'..='\u{200f}' | '\u{202a}'..='\u{202e}' | '\u{2060}'..='\u{2069}' | '\u{feff}' | '\u{ad}' => "",
        '\u{fe00}'..='\u{fe0f}' | '\u{180e}' | '\u{61c}' => "",
        c if c.is_whitespace() => " ",
        _ => return None,
    })
}

/// A letter, digit or sign of the small alphabet, also in bold, italic or full width.
fn lettered(character: char) -> Option<char> {
    let shifted = |base: u32, first: char| char::from_u32(base + first as u32);
    let code = character as u32;
    match character {
        '⟦' | '⟧' => None,
        ' '..='~' => Some(character),
        'α'..='ω' | 'Γ' | 'Δ' | 'Θ' | 'Λ' | 'Ξ' | 'Π' | 'Σ' | 'Φ' | 'Ψ' | 'Ω' => Some(character),
        '≠' | '≤' | '≥' | '±' | '∓' | '·' | '∈' | '∞' => Some(character),
        '\u{ff01}'..='\u{ff5e}' => char::from_u32(code - 0xff01 + 0x21),
        '\u{1d400}'..='\u{1d6a3}' => {
            let letter = (code - 0x1d400) % 52;
            if letter < 26 { shifted(letter, 'A') } else { shifted(letter - 26, 'a') }
        }
        '\u{1d6a4}' => Some('i'),
        '\u{1d6a5}' => Some('j'),
        '\u{1d6a8}'..='\u{1d7cb}' => match (code - 0x1d6a8) % 58 {
            letter @ 26..=50 => shifted(letter - 26, 'α'),
            _ => None,
        },
        '\u{1d7ce}'..='\u{1d7ff}' => shifted((code - 0x1d7ce) % 10, '0'),
        _ => None,
    }
}

fn superscript(character: char) -> Option<char> {
    Some(match character {
        '⁰' | 'ᵒ' => '0',
        '¹' => '1',
        '²' => '2',
        '³' => '3',
        '⁴'..='⁹' => char::from_digit(character as u32 - '⁴' as u32 + 4, 10)?,
        '⁻' => '-',
        '⁺' => '+',
        '⁽' => '(',
        '⁾' => ')',
        'ⁿ' => 'n',
        _ => return None,
    })
}

fn subscript(character: char) -> Option<char> {
    match character {
        '₀'..='₉' => char::from_digit(character as u32 - '₀' as u32, 10),
        // There are few others, and no capitals.
        'ₐ' => Some('a'),
        'ₓ' => Some('x'),
        'ₙ' => Some('n'),
        'ₜ' => Some('t'),
        'ᵢ' => Some('i'),
        'ⱼ' => Some('j'),
        _ => None,
    }
}

fn vulgar(character: char) -> Option<(char, char)> {
    Some(match character {
        '½' => ('1', '2'),
        '⅓' => ('1', '3'),
        '⅔' => ('2', '3'),
        '¼' => ('1', '4'),
        '¾' => ('3', '4'),
        '⅕' => ('1', '5'),
        '⅖' => ('2', '5'),
        '⅗' => ('3', '5'),
        '⅘' => ('4', '5'),
        '⅙' => ('1', '6'),
        '⅚' => ('5', '6'),
        '⅐' => ('1', '7'),
        '⅛' => ('1', '8'),
        '⅜' => ('3', '8'),
        '⅝' => ('5', '8'),
        '⅞' => ('7', '8'),
        '⅑' => ('1', '9'),
        _ => return None,
    })
}
