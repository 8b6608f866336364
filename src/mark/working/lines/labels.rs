//! What a student calls an equation, where that could be taken for a part of it: `3v + 4w = 16 --- (i)`, `… = 16 (3)`,
//! `… <1>`, `… #1`, `… ← eq 1`, `… [cons. of mom.]`, `… [M1]`, a figure that stands far to the right, and `3. v = …`.

use super::remarks::is_formula;

/// An equation without its label. In brackets after a blank an `i` is a label where no other unit vector stands.
pub(super) fn without_label(typed: &str) -> &str {
    let typed = without_lead_in(without_count(typed));
    let Some((equation, label)) = label(typed.trim_end()) else { return typed };
    let bare = without_lead(equation);
    let is_led_to = bare.len() < equation.trim_end().len();
    let is_apart = equation.ends_with(char::is_whitespace);
    let is_certain = match label {
        Label::Sign => is_apart || is_led_to,
        Label::Numeral => (is_led_to || is_apart) && !has_unit_vector(equation),
        Label::Figure => is_led_to,
        Label::Number => is_apart && ends_with_whole_value(bare) && !has_product_apart(equation),
    };
    let ends = |sign: char| sign.is_alphanumeric() || ")]}²³°½'".contains(sign);
    if is_certain && bare.contains('=') && bare.ends_with(ends) { bare } else { typed }
}

/// `3. v = 2.4`: a line without its number, as nobody puts a blank after a decimal point.
fn without_count(typed: &str) -> &str {
    let line = typed.trim_start();
    let after = line.trim_start_matches(|sign: char| sign.is_ascii_digit());
    let is_count = (1..=2).contains(&(line.len() - after.len()));
    match after.strip_prefix('.') {
        Some(rest) if is_count && rest.starts_with(' ') && rest.contains('=') => rest.trim_start(),
        _ => typed,
    }
}

/// `Hence: v = 2.4`, `Step 3: …`, `By conservation of momentum: …`: a line without words that say nothing of what it is of.
fn without_lead_in(typed: &str) -> &str {
    const FIRST: [&str; 24] = [
        "hence",
        "so",
        "thus",
        "therefore",
        "then",
        "now",
        "next",
        "step",
        "eq",
        "eqn",
        "equation",
        "line",
        "answer",
        "ans",
        "final",
        "finally",
        "solving",
        "by",
        "using",
        "from",
        "substituting",
        "adding",
        "subtracting",
        "working",
    ];
    const FURTHER: [&str; 22] = [
        "answer",
        "answers",
        "conservation",
        "cons",
        "of",
        "momentum",
        "clm",
        "pcm",
        "nel",
        "nlr",
        "restitution",
        "law",
        "newton",
        "newton's",
        "newtons",
        "experimental",
        "impact",
        "and",
        "the",
        "above",
        "equations",
        "number",
    ];
    let Some((before, line)) = typed.split_once(':') else { return typed };
    let lower = before.to_lowercase();
    let is_number = |word: &str| !word.is_empty() && word.bytes().all(|sign| sign.is_ascii_digit());
    let bare = |word: &str| word.trim_matches(|sign: char| sign.is_ascii_punctuation() && sign != '\'').to_owned();
    let mut words = lower.split_whitespace().map(bare);
    let is_first = |word: String| FIRST.contains(&word.trim_end_matches(|sign: char| sign.is_ascii_digit()));
    let says_nothing = words.next().is_some_and(is_first)
        && words.all(|word| is_number(&word) || FIRST.contains(&word.as_str()) || FURTHER.contains(&word.as_str()));
    if says_nothing && line.contains('=') { line.trim_start() } else { typed }
}

/// Does a number stand at the end that is no share? `3/5 (3)` and `0.6 (3)` are what is left of an approach of 3.
fn ends_with_whole_value(equation: &str) -> bool {
    let before = equation.trim_end_matches(|sign: char| sign.is_ascii_digit() || sign == '.');
    let value = equation[before.len()..].parse::<f64>();
    !before.trim_end().ends_with('/') && value.is_ok_and(|value| value >= 1.0)
}

/// `2 (5) + 3 (1)`: does a bracket with a blank before it multiply elsewhere in the line?
fn has_product_apart(equation: &str) -> bool {
    let is_after_number = |at: usize| {
        let before = &equation[..at];
        before.ends_with(' ') && before.trim_end().ends_with(|sign: char| sign.is_ascii_digit())
    };
    equation.match_indices('(').any(|(at, _)| is_after_number(at))
}

/// How sure it is that something is a label.
enum Label {
    /// `<1>`, `#1`, `eq 1`, `[CLM]`: nothing else looks so.
    Sign,
    /// `(i)`, which may be a vector.
    Numeral,
    /// `①`, which says nothing where nothing leads there.
    Figure,
    /// `(3)` behind a number, which may multiply it. Behind anything else the reader of answers knows it for a label.
    Number,
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
            '[' if matches!(inside, "A" | "B" | "C" | "D") || is_mark(inside) || is_said() => {
                Some((before, Label::Sign))
            }
            '<' => None,
            _ if number(inside) => Some((before, Label::Number)),
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

/// `M1`, `A1`, `dM1`: what a mark scheme has in the margin.
fn is_mark(inside: &str) -> bool {
    let mark = inside.trim_start_matches('d');
    matches!(mark.as_bytes(), [b'A' | b'B' | b'M', b'1'..=b'3'])
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
