//! Long words as they are meant, where they are misspelt: `perpindicular`, `reccuring`, `degress`.

use super::lexicon::sort;

/// Long words that are often misspelt, and without which an answer says nothing.
const MISSPELT: [&str; 8] =
    ["perpendicular", "parallel", "degrees", "recurring", "centres", "centers", "tangent", "direction"];

/// The word that is meant by one that is misspelt: a letter doubled or not, and one letter wrong, missing, too many or
/// exchanged with the next.
pub(super) fn mended(typed: &str) -> Option<&'static str> {
    if typed.len() < 6 || !typed.is_ascii() {
        return None;
    }
    let initial = typed.as_bytes()[0].to_ascii_lowercase();
    let mut wanted = MISSPELT.into_iter().filter(|wanted| wanted.as_bytes()[0] == initial).peekable();
    wanted.peek()?;
    let small = typed.to_ascii_lowercase();
    // The singular of a word is no misspelling of its plural.
    let is_itself = |wanted: &str| small.trim_end_matches('s') == wanted.trim_end_matches('s');
    let single = |word: &str| {
        let mut letters: Vec<u8> = word.bytes().collect();
        letters.dedup();
        letters
    };
    if small == "centre" || small == "center" || sort(&small).is_some() {
        return None;
    }
    let found = wanted.find(|wanted| is_itself(wanted) || is_one_slip_away(&single(&small), &single(wanted)));
    found.filter(|wanted| !is_itself(wanted))
}

/// Are two words one letter apart at most, or two that are exchanged?
fn is_one_slip_away(one: &[u8], other: &[u8]) -> bool {
    let same = one.iter().zip(other).take_while(|(one, other)| one == other).count();
    let (one, other) = (&one[same..], &other[same..]);
    match (one, other) {
        ([], rest) | (rest, []) => rest.len() <= 1,
        ([first, left @ ..], [second, right @ ..]) => {
            let is_exchanged = matches!((left, right), ([a, ..], [b, ..]) if a == second && b == first);
            left == right || left == other || one == right || (is_exchanged && left[1..] == right[1..])
        }
    }
}
