//! What a learning platform exports of an answer: characters by their names in HTML, and digits raised by tags.

use super::characters::{CLOSE, OPEN};

/// A character as it was typed, or a tag by the signs of the small alphabet that it stands for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Sign {
    /// As it stands, or as it is named: `&radic;`.
    Character(char),
    /// What a tag does: `<sup>` opens a group that is raised.
    Tag(&'static str),
}

/// A sign, and where it was typed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Typed {
    pub sign: Sign,
    /// Its first byte.
    pub place: usize,
    /// One past its last byte.
    pub end: usize,
}

impl Typed {
    /// The character, unless it is a tag.
    pub(super) fn character(self) -> Option<char> {
        match self.sign {
            Sign::Character(character) => Some(character),
            Sign::Tag(_) => None,
        }
    }
}

/// The raised group and the lowered one; a lowered one has a name's letters, and a blank keeps it from what follows.
const PAIRS: [(&str, &str, &str, &str); 2] = [("<sup>", "</sup>", "^⟦", "⟧"), ("<sub>", "</sub>", "_", " ")];

/// Tags that set lines and letters, and say nothing.
const SILENT: [(&str, &str); 23] = [
    ("<p>", "\n"),
    ("</p>", "\n"),
    ("<br>", "\n"),
    ("<br/>", "\n"),
    ("<br />", "\n"),
    ("<b>", ""),
    ("</b>", ""),
    ("<em>", ""),
    ("</em>", ""),
    ("<strong>", ""),
    ("</strong>", ""),
    ("<span>", ""),
    ("</span>", ""),
    ("<u>", ""),
    ("</u>", ""),
    ("<i>", ""),
    ("</i>", ""),
    // What is crossed out.
    ("<s>", "~~"),
    ("</s>", "~~"),
    ("<del>", "~~"),
    ("</del>", "~~"),
    ("<strike>", "~~"),
    ("</strike>", "~~"),
];

/// The signs of an answer in order.
pub(super) fn signs(text: &str) -> Vec<Typed> {
    let mut signs = Vec::with_capacity(text.len());
    let mut open: Option<(&str, &'static str)> = None;
    let mut place = 0;
    while let Some(character) = text[place..].chars().next() {
        let rest = &text[place..];
        let (sign, length) = match character {
            '<' => tag(rest, &mut open),
            '&' => entity(rest).map(|(named, length)| (Sign::Character(named), length)),
            _ => None,
        }
        .unwrap_or((Sign::Character(character), character.len_utf8()));
        signs.push(Typed { sign, place, end: place + length });
        place += length;
    }
    signs
}

/// A tag with which the text begins, and its length. A group is opened only if it is closed, and holds no other.
fn tag(text: &str, open: &mut Option<(&str, &'static str)>) -> Option<(Sign, usize)> {
    if let Some((end, signs)) = *open
        && text.starts_with(end)
    {
        *open = None;
        return Some((Sign::Tag(signs), end.len()));
    }
    for (start, end, before, after) in PAIRS {
        let Some(inside) = text.strip_prefix(start).filter(|_| open.is_none()) else { continue };
        let inside = &inside[..inside.find(end)?];
        let is_group = !inside.contains(['<', OPEN, CLOSE]) && !inside.trim().is_empty();
        return is_group.then(|| {
            *open = Some((end, after));
            (Sign::Tag(before), start.len())
        });
    }
    let (name, signs) = SILENT.into_iter().find(|(name, _)| text.starts_with(name))?;
    Some((Sign::Tag(signs), name.len()))
}

/// The character that is named where the text begins, and the length of its name.
fn entity(text: &str) -> Option<(char, usize)> {
    /// No name that is read here is longer.
    const LONGEST: usize = 10;
    let end = text.bytes().take(LONGEST).position(|byte| byte == b';')?;
    let name = &text[1..end];
    let named = match name.strip_prefix('#') {
        Some(code) => char::from_u32(match code.strip_prefix(['x', 'X']) {
            Some(digits) => u32::from_str_radix(digits, 16).ok()?,
            None => code.parse().ok()?,
        })?,
        None => NAMED.iter().find(|(known, _)| *known == name)?.1,
    };
    Some((named, end + 1))
}

/// The characters that formulas need, by name.
const NAMED: [(&str, char); 46] = [
    ("nbsp", ' '),
    ("thinsp", ' '),
    ("amp", '&'),
    ("lt", '<'),
    ("gt", '>'),
    ("le", '≤'),
    ("ge", '≥'),
    ("ne", '≠'),
    ("quot", '"'),
    ("apos", '\''),
    ("prime", '′'),
    ("minus", '−'),
    ("ndash", '–'),
    ("mdash", '—'),
    ("plusmn", '±'),
    ("times", '×'),
    ("divide", '÷'),
    ("middot", '·'),
    ("sdot", '⋅'),
    ("frasl", '⁄'),
    ("radic", '√'),
    ("infin", '∞'),
    ("deg", '°'),
    ("approx", '≈'),
    ("asymp", '≈'),
    ("cong", '≅'),
    ("equiv", '≡'),
    ("rarr", '→'),
    ("rArr", '⇒'),
    ("there4", '∴'),
    ("frac12", '½'),
    ("frac13", '⅓'),
    ("frac14", '¼'),
    ("frac34", '¾'),
    ("frac15", '⅕'),
    ("sup1", '¹'),
    ("sup2", '²'),
    ("sup3", '³'),
    ("alpha", 'α'),
    ("beta", 'β'),
    ("gamma", 'γ'),
    ("theta", 'θ'),
    ("lambda", 'λ'),
    ("mu", 'μ'),
    ("phi", 'φ'),
    ("pi", 'π'),
];
