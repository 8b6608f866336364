//! Names that a student gives to both velocities after the impact, where they are none of the usual ones: `v'` and `w'`,
//! `v_{Ax}` and `v_{Bx}`, `r` and `s`.

use super::signs::{components, with_signs};
use crate::mark::reading::greek_name;
use crate::mark::working::lines::typed;
use crate::number::Letter;

/// Names of the student's own for what is to be found: each with a prime or a sign for its component, λ and μ, and both of a
/// pair of which one line has the sum and another the difference, as the two laws have. No other formulas have such two lines.
pub(in crate::mark::working) fn own_unknowns(working: &[String], letters: &[Letter]) -> Vec<String> {
    let is_free = |name: &str| {
        let of_question = |letter: &Letter| without_underscores(letter.name()) == without_underscores(name);
        let base = name.split(['_', '\'']).next().unwrap_or_default();
        let is_sign = || matches!(name, "x" | "X") && typed(working).any(has_x_for_times);
        !NEVER.contains(&base.trim_end_matches(['A', 'B'])) && !letters.iter().any(of_question) && !is_sign()
    };
    let mut found: Vec<String> = Vec::new();
    let mut sums: Vec<(String, String, char)> = Vec::new();
    for line in typed(working).filter(|line| line.contains('=')) {
        let pieces = pieces(&with_signs(line), letters);
        let primed = pieces.iter().filter_map(|piece| match piece {
            // Neither λ nor μ is an angle.
            Piece::Name(name) if name.ends_with('\'') || matches!(&**name, "lambda" | "mu") => Some(name.clone()),
            _ => None,
        });
        found.extend(primed.chain(components(line)));
        sums.extend(sums_in(&pieces));
    }
    for (one, other, sign) in &sums {
        let is_other_sign = |(first, second, of): &(String, String, char)| {
            of != sign && ((first, second) == (one, other) || (first, second) == (other, one))
        };
        if sums.iter().any(is_other_sign) && one != other {
            found.extend([one.clone(), other.clone()]);
        }
    }
    let mut own: Vec<String> = Vec::new();
    for name in found.into_iter().filter(|name| is_free(name)) {
        if !own.iter().any(|known| without_underscores(known) == without_underscores(&name)) {
            own.push(name);
        }
    }
    own
}

/// `3x4`, `3 x 8cos48`: does an x stand for a sign here?
fn has_x_for_times(line: &str) -> bool {
    line.match_indices(['x', 'X']).any(|(at, sign)| {
        let (before, after) = (line[..at].trim_end(), line[at + sign.len()..].trim_start());
        let is_factor = |next: char| next.is_alphanumeric() || "(√½¼¾⅓⅔".contains(next);
        before.ends_with(|last: char| last.is_ascii_digit() || ")½¼¾⅓⅔".contains(last)) && after.starts_with(is_factor)
    })
}

/// Names that have a meaning of their own: unit vectors, e, impulses, energies, π and degrees.
const NEVER: [&str; 11] = ["i", "j", "e", "E", "I", "J", "KE", "ke", "PE", "π", "o"];

/// A piece of a line: a name as formulas have it, a number, or any other sign.
#[derive(Clone, Debug, PartialEq)]
enum Piece {
    Name(String),
    Number,
    Sign(char),
}

/// The pieces of a line, its blanks left out. A letter of the question before another is what that is multiplied by: `mx + my`.
fn pieces(line: &str, letters: &[Letter]) -> Vec<Piece> {
    let signs: Vec<char> = line.chars().collect();
    let (mut found, mut at) = (Vec::new(), 0);
    let run = |from: usize, is: &dyn Fn(char) -> bool| signs[from..].iter().take_while(|sign| is(**sign)).count();
    while at < signs.len() {
        let sign = signs[at];
        if sign.is_ascii_digit() {
            at += run(at, &|sign| sign.is_ascii_digit() || sign == '.');
            found.push(Piece::Number);
        } else if sign.is_alphabetic() {
            let mut length = run(at, &|sign| sign.is_alphabetic());
            length += run(at + length, &|sign| sign.is_ascii_digit());
            let mut name: String = signs[at..at + length].iter().collect();
            at += length;
            if signs.get(at) == Some(&'_') {
                let is_grouped = signs.get(at + 1) == Some(&'{');
                let from = at + 1 + usize::from(is_grouped);
                let below = run(from, &|sign| sign.is_alphanumeric() || (is_grouped && is_prime(sign)));
                name.push('_');
                name.extend(signs[from..from + below].iter().map(|sign| if is_prime(*sign) { '\'' } else { *sign }));
                at = from + below + usize::from(is_grouped);
            }
            let primes = run(at, &is_prime);
            // The apostrophe of `don't` and `A's`.
            let is_apostrophe = signs.get(at + primes).is_some_and(|next| next.is_alphabetic());
            name.extend(std::iter::repeat_n('\'', if is_apostrophe { 0 } else { primes }));
            at += primes;
            // `mu` is m and u.
            let greek = greek_name(&name).filter(|_| name.chars().count() != 2);
            if let Some(multiplied) = multiplied(&name, letters) {
                found.extend([Piece::Number, Piece::Name(multiplied.to_owned())]);
                continue;
            }
            found.push(match greek {
                Some(greek) => Piece::Name(greek.to_owned()),
                None if is_name(&name) => Piece::Name(name),
                None => Piece::Sign('w'),
            });
        } else {
            found.extend((!sign.is_whitespace()).then_some(Piece::Sign(if sign == '−' { '-' } else { sign })));
            at += 1;
        }
    }
    found
}

/// The letter behind one of the question's, if it is neither of these nor the name of a sphere: `x` in `mx`.
fn multiplied<'n>(name: &'n str, letters: &[Letter]) -> Option<&'n str> {
    let is_of_question = |own: &str| letters.iter().any(|letter| letter.name() == own);
    let (first, rest) = name.split_at_checked(1)?;
    let is_letter =
        rest.len() == 1 && rest.starts_with(|sign: char| sign.is_ascii_lowercase() && !"abe".contains(sign));
    (is_letter && is_of_question(first) && !is_of_question(rest)).then_some(rest)
}

fn is_prime(sign: char) -> bool {
    matches!(sign, '\'' | '’' | '′' | '´' | '`')
}

/// A letter, perhaps with the name of a sphere, a component or a number behind it.
fn is_name(name: &str) -> bool {
    let base = name.trim_end_matches('\'');
    match base.split_once('_') {
        Some((letter, below)) => (1..=3).contains(&letter.chars().count()) && below.chars().count() <= 3,
        None => {
            let mut signs = base.chars();
            let is_index =
                |sign: char| matches!(sign, 'A' | 'B' | 'P' | 'Q' | 'a' | 'b' | 'x' | 'y') || sign.is_ascii_digit();
            signs.next().is_some_and(char::is_alphabetic) && base.chars().count() <= 3 && signs.all(is_index)
        }
    }
}

/// The sums and differences of two names, each perhaps with a number before it: `3r + 4s`, `s - r`.
fn sums_in(pieces: &[Piece]) -> Vec<(String, String, char)> {
    let begins = |at: usize| {
        let before = pieces[..at].iter().rposition(|piece| *piece != Piece::Number).map(|before| &pieces[before]);
        matches!(before, None | Some(Piece::Sign('=' | '+' | '-' | ',' | '(' | ':')))
    };
    let ends = |at: usize| {
        !matches!(pieces.get(at), Some(Piece::Name(_) | Piece::Number | Piece::Sign('²' | '^' | '/' | '(')))
    };
    let sum = |at: usize| {
        let Piece::Name(one) = &pieces[at] else { return None };
        let Some(Piece::Sign(sign @ ('+' | '-'))) = pieces.get(at + 1) else { return None };
        let other = at + 2 + pieces[at + 2..].iter().take_while(|piece| **piece == Piece::Number).count();
        let Some(Piece::Name(second)) = pieces.get(other) else { return None };
        (begins(at) && ends(other + 1)).then(|| (one.clone(), second.clone(), *sign))
    };
    (0..pieces.len()).filter_map(sum).collect()
}

fn without_underscores(name: &str) -> String {
    name.replace('_', "")
}
