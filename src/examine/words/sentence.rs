//! A sentence of a question, token by token, and whose each number in it is.

use crate::expr::{Expr, Piece, Text};
use crate::mechanics::Sphere;
use crate::unit::Unit;

/// What a sentence is made of.
#[derive(Clone, Debug, PartialEq)]
pub enum Token<'t> {
    /// A word, in small letters.
    Word(String),
    /// The name of a sphere.
    Sphere(Sphere),
    /// A number or formula, with its unit and with the words of the file that lead to it.
    Number(&'t Expr, Unit, String),
    /// A comma.
    Comma,
}

pub use super::measured::measured_from;
pub(super) use super::nouns::BETWEEN;
pub use super::nouns::{Noun, noun_of};

use Token::{Comma, Number, Word};

/// A sentence.
pub type Sentence<'t> = Vec<Token<'t>>;

/// The sentences of a text.
pub fn sentences(text: &Text) -> Vec<Sentence<'_>> {
    let mut pieces = Vec::new();
    in_order(&text.0, &mut pieces);
    let (mut found, mut sentence, mut lead) = (Vec::new(), Vec::new(), String::new());
    for piece in pieces {
        match piece {
            Piece::Words(words) => {
                let mut word = String::new();
                let mut signs = words.chars().chain([' ']).peekable();
                while let Some(sign) = signs.next() {
                    // A point within a word ends no sentence: `22.5`, `s.f.`.
                    let is_within = sign == '.' && signs.peek().is_some_and(|next| next.is_alphanumeric());
                    if sign.is_alphanumeric() || sign == '\'' || sign == '-' || (is_within && !word.is_empty()) {
                        word.extend(sign.to_lowercase());
                        continue;
                    }
                    if !word.is_empty() {
                        sentence.push(Word(as_a_wall(std::mem::take(&mut word))));
                    }
                    match sign {
                        ',' => sentence.push(Comma),
                        '.' | '?' | '!' | ':' | ';' => found.push(std::mem::take(&mut sentence)),
                        _ => {}
                    }
                }
                lead.push_str(words);
            }
            Piece::Formula(Expr::Name(name)) if sphere(&name.text).is_some() => {
                sentence.extend(sphere(&name.text).map(Token::Sphere));
                lead = format!("*{}*", name.text);
            }
            Piece::Formula(expr) | Piece::Display(expr) => {
                sentence.push(Number(expr, Unit::None, std::mem::replace(&mut lead, "}".to_owned())));
            }
            Piece::Quantity(expr, unit) => {
                sentence.push(Number(expr, *unit, std::mem::replace(&mut lead, "}".to_owned())));
            }
            Piece::Italic(_) => {}
        }
    }
    found.push(sentence);
    found
}

/// What stands as a wall does, in the word for one.
fn as_a_wall(word: String) -> String {
    match word.as_str() {
        "cushion" | "barrier" => "wall".to_owned(),
        "cushions" | "barriers" => "walls".to_owned(),
        _ => word,
    }
}

/// Is what a sentence says only supposed?
pub fn is_supposed(sentence: &[Token]) -> bool {
    says(sentence, &SUPPOSED)
}

fn sphere(name: &str) -> Option<Sphere> {
    Sphere::ALL.into_iter().find(|sphere| sphere.name() == name)
}

/// Words of what is not said to be so.
const SUPPOSED: [&str; 8] = ["if", "whether", "suppose", "instead", "were", "would", "could", "cannot"];

/// Is a token one of these words?
pub fn is_one_of(token: &Token, words: &[&str]) -> bool {
    matches!(token, Word(word) if words.contains(&word.as_str()))
}

/// Does a sentence hold one of these words?
pub fn says(sentence: &[Token], words: &[&str]) -> bool {
    sentence.iter().any(|token| is_one_of(token, words))
}

/// Whose a number is: the sphere that is named for it.
pub fn owner_of(sentence: &[Token], place: usize) -> Option<(Noun, Sphere)> {
    let (at, noun, is_plural) = noun_of(sentence, place)?;
    let numbers = || sentence[at..].iter().enumerate().filter(|(_, token)| matches!(token, Number(..)));
    let nth = numbers().position(|(number, _)| at + number == place)?;
    if is_plural {
        // `{a} for *A* and {b} for *B*`
        if let [Word(of), Token::Sphere(owner), ..] = &sentence[place + 1..]
            && of == "for"
        {
            return Some((noun, *owner));
        }
        let first = sentence[at..].iter().position(|token| matches!(token, Number(..)))?;
        // `Masses of *A* and *B*`, but `*A* and *B* make angles of {a} and {b}`
        let theirs = Some(listed(&sentence[at..at + first])).filter(|owners| !owners.is_empty());
        let owners = match sentence.get(at + 1) {
            Some(of) if is_one_of(of, &["of"]) && noun != Noun::Angle => theirs.unwrap_or_default(),
            Some(of) if is_one_of(of, &["of"]) => theirs.unwrap_or_else(|| listed(&sentence[..at])),
            _ => listed(&sentence[..at]),
        };
        let after = sentence[at..].iter().skip_while(|token| !matches!(token, Number(..)));
        let row = after.take_while(|token| matches!(token, Number(..) | Comma) || is_one_of(token, &["and"]));
        let row = row.filter(|token| matches!(token, Number(..))).count();
        return (owners.len() == row).then(|| owners.get(nth).map(|owner| (noun, *owner)))?;
    }
    if nth > 0 {
        return None;
    }
    let owner = match &sentence[at + 1..] {
        [Word(of), Token::Sphere(owner), ..] if of == "of" => Some(*owner),
        [Word(of), Word(_), Token::Sphere(owner), ..] if of == "of" => Some(*owner),
        [Word(of), Word(_), Word(_), Token::Sphere(owner), ..] if of == "of" => Some(*owner),
        _ if matches!(noun, Noun::Mass | Noun::Radius) => beside(&sentence[..at]),
        _ if owner_of_a_list(&sentence[..at]).is_some() => owner_of_a_list(&sentence[..at]),
        _ => subject(&sentence[..at]),
    };
    owner.map(|owner| (noun, owner))
}

/// The spheres that were last named in a row: `*A*, *B* and *C*`.
fn listed(before: &[Token]) -> Vec<Sphere> {
    let is_of_row = |token: &Token| matches!(token, Token::Sphere(_) | Comma) || is_one_of(token, &["and"]);
    let last = before.iter().rposition(|token| matches!(token, Token::Sphere(_)));
    let Some(last) = last else { return Vec::new() };
    let row = before[..=last].iter().rev().take_while(|token| is_of_row(token));
    let mut row: Vec<Sphere> =
        row.filter_map(|token| if let Token::Sphere(sphere) = token { Some(*sphere) } else { None }).collect();
    row.reverse();
    row
}

/// The sphere to which `of mass`, `has mass` or `, with mass` is joined.
fn beside(before: &[Token]) -> Option<Sphere> {
    const JOINED: [&str; 12] =
        ["whose", "of", "has", "with", "a", "which", "is", "and", "having", "equal", "same", "radius"];
    let joined = before.iter().rev().skip_while(|token| matches!(token, Comma) || is_one_of(token, &JOINED));
    match joined.collect::<Vec<_>>().as_slice() {
        // Of two in a row it is neither's alone.
        [Token::Sphere(_), Word(and), Token::Sphere(_), ..] if and == "and" => None,
        // `with the same radius as *A*, has mass`
        [Token::Sphere(_), Word(like), ..] if like == "as" || like == "to" => None,
        [Token::Sphere(owner), ..] => Some(*owner),
        _ => None,
    }
}

/// `*B*, with mass {k kg} and` velocity: the sphere that has all that is joined so.
fn owner_of_a_list(before: &[Token]) -> Option<Sphere> {
    const JOINED: [&str; 8] = ["with", "having", "of", "mass", "radius", "a", "equal", "the"];
    let (_, before) = before.split_last().filter(|(and, _)| is_one_of(and, &["and"]))?;
    let last = before.iter().rposition(|token| matches!(token, Token::Sphere(_)))?;
    let list = &before[last + 1..];
    let has_mass = list.iter().any(|token| is_one_of(token, &["mass", "radius"]));
    let is_plain = list.iter().all(|token| matches!(token, Number(..) | Comma) || is_one_of(token, &JOINED));
    // Of two in a row it is neither's alone.
    let in_row = matches!(&before[..last], [.., Token::Sphere(_), Word(and)] if and == "and");
    match before[last] {
        Token::Sphere(sphere) if has_mass && is_plain && !in_row => Some(sphere),
        _ => None,
    }
}

/// Words after which a sphere is not the one that moves.
const OBJECT: [&str; 34] = [
    "as",
    "than",
    "towards",
    "toward",
    "to",
    "from",
    "with",
    "by",
    "strikes",
    "striking",
    "hits",
    "hitting",
    "struck",
    "hit",
    "at",
    "meets",
    "meeting",
    "leaves",
    "leaving",
    "behind",
    "on",
    "between",
    "for",
    "approaches",
    "approaching",
    "follows",
    "following",
    "catches",
    "catching",
    "overtakes",
    "overtaking",
    "against",
    "into",
    "near",
];
/// Words that stand before the name of a sphere.
const BEFORE_A_NAME: [&str; 9] = ["a", "the", "smooth", "uniform", "small", "sphere", "ball", "particle", "another"];

/// The sphere of which a sentence speaks at its end.
pub fn subject(before: &[Token]) -> Option<Sphere> {
    for (at, token) in before.iter().enumerate().rev() {
        let leads = |at: usize| before[..at].iter().rev().find(|token| !is_one_of(token, &BEFORE_A_NAME));
        // `in front of *A*`, `ahead of *A*` and `equals that of *A*`, but `the speed of *A*`.
        let is_ahead = matches!(&before[..at], [.., Word(place), Word(of)] if of == "of" && ["front", "ahead", "that", "side"].contains(&place.as_str()));
        let is_object = is_ahead || leads(at).is_some_and(|token| is_one_of(token, &OBJECT));
        match token {
            Token::Sphere(_) if matches!(leads(at), Some(Token::Sphere(_))) => return None,
            Token::Sphere(sphere) => {
                let in_row = leads(at).is_some_and(|token| is_one_of(token, &["and"]))
                    && matches!(before[..at].iter().rev().nth(1), Some(Token::Sphere(_)));
                // `strikes *B*, of mass m, which is moving`: what follows is said of the one that is struck.
                // It is not `in a direction which makes an angle`.
                let is_described = before[at..].windows(2).any(|pair| {
                    is_one_of(&pair[1], &["which", "that"]) && !is_one_of(&pair[0], &["direction", "line", "path"])
                });
                let is_described = is_described || is_told_of_in_turn(before, at);
                match in_row {
                    true => return None,
                    false
                        if (is_described && !is_over(&before[at + 1..]))
                            || is_owner(&before[at + 1..])
                            || !is_object =>
                    {
                        return Some(*sphere);
                    }
                    false => {}
                }
            }
            Word(word) if ["they", "each", "both", "spheres"].contains(&word.as_str()) => return None,
            Word(word) if word == "it" && !is_object => return None,
            _ => {}
        }
    }
    None
}

/// `*A*, moving with velocity {u}, collides with *B*, moving with velocity`: two in turn, each with what is said of it behind
/// its name.
fn is_told_of_in_turn(before: &[Token], at: usize) -> bool {
    let moves = |name: usize| match &before[name + 1..] {
        [Comma, moving, ..] => is_one_of(moving, &["moving", "travelling", "sliding", "rolling", "going"]),
        _ => false,
    };
    let is_first = |name: usize| matches!(before[name], Token::Sphere(_)) && moves(name);
    let is_last = !before[at + 1..].iter().skip(1).any(|token| *token == Comma);
    moves(at) && is_last && (0..at).any(is_first)
}

/// `Strikes *B*, which is at rest, with speed`: is what was said of the sphere before over, and its striker spoken of again?
fn is_over(after: &[Token]) -> bool {
    let last = after.iter().rposition(|token| *token == Comma);
    last.is_some_and(|last| {
        let describes = after[..last].iter().any(|token| is_one_of(token, &["which", "that"]));
        describes && after.get(last + 1).is_some_and(|next| is_one_of(next, &["with", "at"]))
    })
}

/// `Runs into *B*, whose`: is what follows said of the sphere before it, in a clause that goes on to the end?
fn is_owner(after: &[Token]) -> bool {
    match after {
        [Comma, whose, clause @ ..] | [whose, clause @ ..] => is_one_of(whose, &["whose"]) && !clause.contains(&Comma),
        [] => false,
    }
}

/// Pieces in the order in which they are read, those in italics among them.
pub(in crate::examine) fn in_order<'t>(pieces: &'t [Piece], found: &mut Vec<&'t Piece>) {
    for piece in pieces {
        match piece {
            Piece::Italic(inner) => in_order(inner, found),
            piece => found.push(piece),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::expr::{print, read_markup};
    use crate::mechanics::Axis;

    #[test]
    fn an_angle_is_measured_from_the_line_that_is_named_next() {
        let table = [
            ("{a} with the line of centres, which is perpendicular to the wall", Some(Axis::N)),
            ("{a} to the perpendicular to the line of centres", Some(Axis::T)),
            ("{a} with the common tangent", Some(Axis::T)),
            ("{a} with the common normal, the line through the centres", Some(Axis::N)),
            ("{a}, where {tan(a) = 3/4}, with the wall", Some(Axis::T)),
            ("{a} with the normal to the wall", Some(Axis::N)),
            ("{a} to the normal", Some(Axis::N)),
            ("{a} with a line that is perpendicular to the wall", Some(Axis::N)),
            ("{a} with its first direction when it hits the wall", None),
            ("{a} with a smooth fixed wall", Some(Axis::T)),
            ("{a} and then {b} with the wall", None),
        ];
        for (words, axis) in table {
            let text = read_markup(words).unwrap();
            let sentence = &sentences(&text[0])[0];
            assert_eq!(measured_from(&sentence[1..]), axis, "{words}");
        }
    }

    #[test]
    fn a_number_is_of_the_sphere_for_which_it_is_named() {
        let table = [
            ("Sphere *A*, of mass {m kg}, strikes a sphere *B* of mass {k kg}.", "m: Mass A, k: Mass B"),
            ("The masses of *A* and *B* are {m kg} and {k kg}.", "m: Mass A, k: Mass B"),
            ("*A*, *B* and *C* have masses {m kg}, {k kg} and {l kg} respectively.", "m: Mass A, k: Mass B, l: Mass C"),
            ("The mass of *A* is {m kg} and the mass of the sphere *B* is {k kg}.", "m: Mass A, k: Mass B"),
            ("The spheres *A* and *B* are each of mass {m kg}.", ""),
            ("*A* is moving towards *B* with speed {u m/s}.", "u: Speed A"),
            ("It strikes *B*, of equal radius and of mass {k kg}.", "k: Mass B"),
            ("*A* has equal radius to *B* and mass {k kg}.", ""),
            (
                "*A*, moving with speed {u m/s}, strikes *B*, which is moving with speed {w m/s}.",
                "u: Speed A, w: Speed B",
            ),
            ("*A* collides with *B*. It has speed {u m/s}.", ""),
            (
                "*A*, with mass {m kg} and speed {u m/s}, hits *B*, with mass {k kg} and speed {w m/s}.",
                "m: Mass A, u: Speed A, k: Mass B, w: Speed B",
            ),
            ("*A*, whose speed is {u m/s}, runs into *B*, whose speed is {w m/s}.", "u: Speed A, w: Speed B"),
            ("*A* strikes *B*, whose mass is {m kg}, with speed {u m/s}.", "m: Mass B, u: Speed A"),
            ("*A* strikes *B*, which is at rest, with speed {u m/s}.", "u: Speed A"),
            ("*A* with speed {u m/s} and *B*, in front of *A*, with speed {w m/s}.", "u: Speed A, w: Speed B"),
            ("*B*, which is ahead of *A*, has speed {w m/s}.", "w: Speed B"),
            (
                "*B* moves towards *A* with speed {w m/s} in a direction which makes an acute angle of {b deg} with the line of centres.",
                "w: Speed B, b: Angle B",
            ),
            (
                "*A* has velocity {[p, q] m/s} and *B* has velocity {[r, s] m/s}.",
                "[p, q]: Velocity A, [r, s]: Velocity B",
            ),
            (
                "*A* has speed {u} and its direction makes an acute angle of {t deg} with the wall.",
                "u: Speed A, t: Angle A",
            ),
            ("*B* is approaching *A* at speed {w m/s}.", "w: Speed B"),
            ("*A*, following *B* with speed {u m/s}, runs into *B* of mass {k kg}.", "u: Speed A, k: Mass B"),
            ("*B*, whose radius is the same as that of *A*, is moving with speed {w m/s}.", "w: Speed B"),
            ("*B*, which has the same radius as *A*, is moving with speed {w m/s}.", "w: Speed B"),
            ("*A* and *B* move with speed {u m/s}.", ""),
            ("*A* hits *B* of mass {m kg}, which has speed {u m/s}.", "m: Mass B, u: Speed B"),
            ("Their speed of approach is {u m/s}; the radius is {r}.", ""),
            ("*A*, of radius {r}, hits *B*. The radius of *B* is {2*r}.", "r: Radius A, 2*r: Radius B"),
            ("*A* and *B* have radii {r} and {s}, and each has mass {m kg}.", "r: Radius A, s: Radius B"),
            ("If the mass of *A* were {m kg}, it would stop.", ""),
        ];
        for (words, owners) in table {
            let mut found = Vec::new();
            for text in read_markup(words).unwrap() {
                for sentence in sentences(&text).into_iter().filter(|sentence| !is_supposed(sentence)) {
                    for (place, token) in sentence.iter().enumerate() {
                        if let (Number(expr, ..), Some((noun, owner))) = (token, owner_of(&sentence, place)) {
                            found.push(format!("{}: {noun:?} {}", print::plain(expr), owner.name()));
                        }
                    }
                }
            }
            assert_eq!(found.join(", "), owners, "{words}");
        }
    }
}
