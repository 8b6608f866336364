//! What a student calls an equation at its end, where that could be taken for a part of it: `3v + 4w = 16 --- (i)`,
//! `… <1>`, `… #1`, `… ← eq 1`, `… [cons. of mom.]`, and a figure that stands far to the right.

use super::remarks::is_formula;

/// An equation without its label. In brackets after a blank an `i` is a label where no other unit vector stands.
pub(super) fn without_label(typed: &str) -> &str {
    let Some((equation, label)) = label(typed.trim_end()) else { return typed };
    let bare = without_lead(equation);
    let is_led_to = bare.len() < equation.trim_end().len();
    let is_apart = equation.ends_with(char::is_whitespace);
    let is_certain = match label {
        Label::Sign => is_apart || is_led_to,
        Label::Numeral => (is_led_to || is_apart) && !has_unit_vector(equation),
        Label::Figure => is_led_to,
    };
    let ends = |sign: char| sign.is_alphanumeric() || ")]}²³°½'".contains(sign);
    if is_certain && bare.contains('=') && bare.ends_with(ends) { bare } else { typed }
}

/// How sure it is that something is a label.
enum Label {
    /// `<1>`, `#1`, `eq 1`, `[CLM]`: nothing else looks so.
    Sign,
    /// `(i)`, which may be a vector.
    Numeral,
    /// `①`, which says nothing where nothing leads there.
    Figure,
}

/// What stands before the label at the end of a line, and what kind of label that is.
fn label(typed: &str) -> Option<(&str, Label)> {
    const NUMERALS: [&str; 6] = ["i", "ii", "iii", "iv", "vi", "*"];
    let number = |typed: &str| matches!(typed.parse(), Ok(1..=20_u8));
    let brackets =
        [('(', ')'), ('[', ']'), ('{', '}'), ('<', '>')].into_iter().find(|(_, close)| typed.ends_with(*close));
    if let Some((open, close)) = brackets {
        let (before, inside) = typed.strip_suffix(close)?.rsplit_once(open)?;
        let inside = inside.trim();
        let has_word =
            || inside.split_whitespace().any(|word| word.chars().filter(|sign| sign.is_alphabetic()).count() > 2);
        let is_said = || {
            has_word()
                && inside.chars().all(|sign| sign.is_alphabetic() || " .,'’".contains(sign))
                && !is_formula(inside)
        };
        return match open {
            '<' if number(inside) => Some((before, Label::Sign)),
            '[' if matches!(inside, "A" | "B" | "C" | "D") || is_said() => Some((before, Label::Sign)),
            '<' => None,
            _ if NUMERALS.contains(&inside) => Some((before, Label::Numeral)),
            _ => None,
        };
    }
    if let Some(before) = typed.strip_suffix(|sign: char| ('①'..='⑳').contains(&sign)) {
        return Some((before, Label::Figure));
    }
    let before = typed.trim_end_matches(|sign: char| sign.is_ascii_digit());
    if !number(&typed[before.len()..]) {
        return None;
    }
    // `3v + 4w = 16        1`
    let blanks = before.len() - before.trim_end().len();
    if blanks >= FAR || before.ends_with('\t') {
        return Some((before, Label::Sign));
    }
    let named = before.trim_end_matches(['.', ' ']);
    let name = ["#", "equation", "Equation", "eqn", "Eqn", "eq", "Eq"]
        .into_iter()
        .find_map(|name| named.strip_suffix(name))?;
    Some((name, Label::Sign))
}

/// So many blanks before a figure set it apart from the equation.
const FAR: usize = 4;

/// Without what leads from an equation to its label: dots, dashes, arrows.
fn without_lead(equation: &str) -> &str {
    const LEADS: [char; 14] = [' ', '\t', '.', '…', '-', '–', '—', '−', '←', '→', '⇐', '·', ',', ';'];
    // `<-` and `->`
    equation.trim_end_matches(LEADS).trim_end_matches(['<', '>']).trim_end_matches(LEADS)
}

/// Does an i or j stand by itself?
fn has_unit_vector(typed: &str) -> bool {
    let typed = typed.replace("i.e", " ");
    typed.split(|sign: char| !sign.is_alphabetic()).any(|word| matches!(word, "i" | "j"))
}
