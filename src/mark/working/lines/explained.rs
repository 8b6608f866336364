//! What a line says at its end of a letter of the student's own: `3u = 3v + 4w, where u = 8 cos 48°`, `… (u = 8 cos 48°)`.

use crate::mark::working::letters::is_short;

/// A line in what it says and in what it explains.
pub(super) fn explained(typed: &str) -> Option<(&str, &str)> {
    let by_word = [" where ", " let ", " letting "].into_iter().find_map(|word| typed.split_once(word));
    let by_word = by_word.filter(|(_, after)| after.contains('='));
    let with = || typed.split_once(" with ").filter(|(_, after)| defined(after).is_some());
    by_word.or_else(with).or_else(|| in_brackets(typed))
}

/// Is a letter explained at the end of a line?
pub(in crate::mark::working) fn explains(typed: &str, letter: &str) -> bool {
    let after = explained(typed).map_or("", |(_, after)| after);
    after.split([',', ';']).any(|clause| defined(clause) == Some(letter))
}

/// An equation, and in brackets behind it what one of its letters stands for.
fn in_brackets(typed: &str) -> Option<(&str, &str)> {
    let whole = typed.trim_end_matches(['.', ' ']);
    let inside = whole.strip_suffix([')', ']'])?;
    let mut depth = 1;
    let open = inside.char_indices().rev().find(|(_, sign)| {
        match sign {
            ')' | ']' => depth += 1,
            '(' | '[' => depth -= 1,
            _ => {}
        }
        depth == 0
    });
    let (before, inside) = (&inside[..open?.0], inside[open?.0 + 1..].trim());
    let inside = ["where ", "with ", "let "].iter().find_map(|word| inside.strip_prefix(word)).unwrap_or(inside);
    let letter = defined(inside)?;
    let is_it = |word: &str| word.trim_start_matches(|sign: char| sign.is_ascii_digit()) == letter;
    let is_used = before.split(|sign: char| !sign.is_alphanumeric() && sign != '_').any(is_it);
    (is_used && before.contains('=') && defined(before) != Some(letter)).then_some((before.trim_end(), inside))
}

/// The letter that is set equal to something here, where it may be one for what is known.
fn defined(clause: &str) -> Option<&str> {
    let letter = clause.split_once('=')?.0.trim();
    let is_name = letter.len() <= 3 && letter.chars().all(|sign| sign.is_alphanumeric() || sign == '_');
    (is_name && is_short(letter)).then_some(letter)
}
