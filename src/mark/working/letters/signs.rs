//! Signs beside the name of a velocity: primes, those that say of which component it is, as in `v∥` and `u⊥`, and the dot of a
//! scalar product.

use std::borrow::Cow;

/// A line with such signs as formulas have them.
pub(in crate::mark::working) fn with_signs(line: &str) -> Cow<'_, str> {
    let signed = match with_primes(line) {
        Cow::Borrowed(line) => with_components(line),
        Cow::Owned(line) => Cow::Owned(with_components(&line).into_owned()),
    };
    match signed {
        Cow::Borrowed(line) => with_dots(line),
        Cow::Owned(line) => Cow::Owned(with_dots(&line).into_owned()),
    }
}

/// A line with the dot of a scalar product raised, where a full stop was typed between a velocity and another vector: `u_A.n`.
fn with_dots(line: &str) -> Cow<'_, str> {
    let is_name = |word: &str| {
        let index = word.strip_prefix(|letter| "uvwUVW".contains(letter));
        index.is_some_and(|index| matches!(index.trim_start_matches('_'), "A" | "B" | "a" | "b" | "1" | "2" | ""))
    };
    let is_dot = |at: usize| {
        let word = line[..at].rfind(|sign: char| !(sign.is_alphanumeric() || sign == '_'));
        let before = word.map_or(0, |end| end + line[end..].chars().next().map_or(0, char::len_utf8));
        let mut after = line[at + 1..].chars();
        let is_vector = after.next().is_some_and(char::is_alphabetic);
        is_name(&line[before..at])
            && is_vector
            && !after.next().is_some_and(|next| next.is_alphanumeric() || next == '.')
    };
    let dots: Vec<usize> = line.match_indices('.').map(|(at, _)| at).filter(|at| is_dot(*at)).collect();
    if dots.is_empty() {
        return Cow::Borrowed(line);
    }
    let raised = line.char_indices().map(|(at, sign)| if dots.contains(&at) { '·' } else { sign });
    Cow::Owned(raised.collect())
}

/// A line with primes as keyboards have them, where they are raised or typed as TeX's command: `v^{\\prime}`.
fn with_primes(line: &str) -> Cow<'_, str> {
    const RAISED: [&str; 6] = ["^{\\prime}", "^\\prime", "\\prime", "^{'}", "^'", "^′"];
    let is_there = RAISED.iter().any(|raised| line.contains(raised));
    let put = |line: String, raised: &&str| line.replace(*raised, "'");
    if is_there { Cow::Owned(RAISED.iter().fold(line.to_owned(), put)) } else { Cow::Borrowed(line) }
}

/// The signs for a component along the line of centres and for one across it, and the index that stands for each.
const COMPONENTS: [(char, char); 3] = [('∥', 'n'), ('⊥', 't'), ('⟂', 't')];

fn index(sign: char) -> Option<char> {
    COMPONENTS.iter().find(|(own, _)| *own == sign).map(|(_, index)| *index)
}

/// A line with `v_n` for `v∥`, and `v_At` for `v_{A⊥}`.
fn with_components(line: &str) -> Cow<'_, str> {
    if !line.contains(|sign| index(sign).is_some()) {
        return Cow::Borrowed(line);
    }
    let (mut found, mut rest) = (String::new(), line);
    while let Some(first) = rest.chars().next() {
        let is_start = !found.ends_with(|before: char| before.is_alphabetic() || before == '_');
        match component(rest).filter(|_| is_start) {
            Some((name, after)) => {
                found.push_str(&name);
                rest = after;
            }
            None => {
                found.push(first);
                rest = &rest[first.len_utf8()..];
            }
        }
    }
    Cow::Owned(found)
}

/// The names of components that such signs stand in.
pub(super) fn components(line: &str) -> Vec<String> {
    let at_each = line.char_indices().filter_map(|(at, _)| component(&line[at..]));
    at_each.map(|(name, _)| name).collect()
}

/// The component with whose name something begins, as formulas have it, and what stands behind that.
fn component(typed: &str) -> Option<(String, &str)> {
    let letter = typed.chars().next().filter(|letter| "uvwUVW".contains(*letter))?;
    let rest = typed[1..].strip_prefix('_').unwrap_or(&typed[1..]);
    let (rest, is_grouped) = rest.strip_prefix('{').map_or((rest, false), |inside| (inside, true));
    let after = rest.trim_start_matches(['A', 'B', 'a', 'b', '1', '2']);
    let of = &rest[..rest.len() - after.len()];
    let sign = after.chars().next()?;
    let index = index(sign).filter(|_| of.len() <= 1)?;
    let after = &after[sign.len_utf8()..];
    let after = if is_grouped { after.strip_prefix('}')? } else { after };
    // `v∥i` says what something is parallel to.
    let is_end = !after
        .starts_with(|sign: char| sign.is_alphabetic() || sign.is_ascii_digit() || matches!(sign, '(' | '[' | '_'));
    is_end.then(|| (format!("{letter}_{of}{index}"), after))
}
