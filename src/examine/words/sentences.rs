//! Do the words of a variant read as a person would write them, its numbers put in?
//!
//! What stands between the numbers is the author's; what goes wrong is mostly where the two meet: `2/4`, 'a 8 kg', 'masses
//! m and m', '1 times', a sphere that is said to move towards the other and moves away.

use std::borrow::Cow;

use super::own_words::Heard;
use super::sentence::in_order;
use crate::examine::remark::Remark;
use crate::expr::{Expr, Meaning, Piece, Text, evaluate, print};
use crate::generate::Variant;
use crate::number::Fraction;
use crate::paper::Words;
use crate::unit::Unit;

/// What does not read well; of the author's own words what was heard of them in other variants.
pub fn unreadable(words: &Words, variant: &Variant, heard: &mut Heard, remarks: &mut Vec<Remark>) {
    let mut pieces = Vec::new();
    for text in words.stem.iter().chain(&words.asks).chain(&words.said) {
        pieces.clear();
        in_order(&text.0, &mut pieces);
        heard.unreadable(text, &pieces, remarks);
        of_pieces(&pieces, words, remarks);
        for expr in pieces.iter().copied().filter_map(formula).filter(|expr| divides_by_nought(expr, variant)) {
            let help = "require that what stands below the line is not nought";
            remarks.push(remark("a division by nought", &print::unicode(expr), help));
        }
    }
    each_sentence(words, remarks);
}

/// Sentences begin with a capital and end with a full stop.
fn each_sentence(words: &Words, remarks: &mut Vec<Remark>) {
    let all: Vec<&Text> = words.stem.iter().chain(&words.asks).map(Cow::as_ref).collect();
    for (place, text) in all.iter().enumerate() {
        without_a_capital(text, words, remarks);
        // `Given that the coefficient of restitution is {e},` and then `(a) find …, (b) find …`
        let goes_on = || all.get(place + 1).is_some_and(|next| place + 1 >= words.stem.len() && is_begun_small(next));
        let ends = match text.0.last() {
            Some(Piece::Words(words)) => {
                let words = words.trim_end();
                words.ends_with(['.', '?', '!', ':', ']', ')']) || (words.ends_with([',', ';']) && goes_on())
            }
            Some(Piece::Formula(_) | Piece::Quantity(..)) => false,
            _ => true,
        };
        if !ends {
            let help = if leads_up_to_a_note(words, place) { BETWEEN } else { "end it with a full stop" };
            remarks.push(remark("a sentence without a full stop", &tail(text), help));
        }
    }
}

/// What to do where the stem leads up to the question in some styles alone.
const BETWEEN: &str =
    "end the stem with a full stop and begin the question with a capital: the `note` of this style stands between them";

/// Does a text end in the middle of a sentence, before the note with which the words of a style end?
fn leads_up_to_a_note(words: &Words, place: usize) -> bool {
    let goes_on = words.stem.get(place).is_some_and(|text| tail(text).ends_with([',', ';']));
    goes_on && place + 2 == words.stem.len() && words.asks.first().is_some_and(|ask| is_begun_small(ask))
}

/// A text that begins in small letters, unless what stands before it leads up to it: `Find`, `(a) the speed of *A*`.
fn without_a_capital(text: &Text, words: &Words, remarks: &mut Vec<Remark>) {
    let Some(Piece::Words(start)) = text.0.first() else { return };
    let leads_up = || words.stem.last().is_some_and(|last| !tail(last).ends_with(['.', '?', '!', ']']));
    if is_begun_small(text) && !leads_up() {
        let at = start.split_whitespace().take(4).collect::<Vec<_>>().join(" ");
        let is_parted = words.stem.len() > 1 && leads_up_to_a_note(words, words.stem.len() - 2);
        let help = if is_parted { BETWEEN } else { "begin it with a capital letter" };
        remarks.push(remark_at("a sentence without a capital", &at, &at, help));
    }
}

fn is_begun_small(text: &Text) -> bool {
    matches!(text.0.first(), Some(Piece::Words(words)) if words.starts_with(char::is_lowercase))
}

/// Is there a quotient in it of which what stands below the line comes to nought?
fn divides_by_nought(expr: &Expr, variant: &Variant) -> bool {
    let is_nought = |below: &Expr| {
        let value = evaluate(below, &|name| variant.givens.meaning(name));
        matches!(value, Ok(Meaning::Number(value)) if value.is_zero())
    };
    let here = matches!(expr, Expr::Quotient(_, below) if is_nought(below));
    here || !expr.all_children(&mut |inner| !divides_by_nought(inner, variant))
}

/// Does a number of degrees stand below a line?
fn divides_by_degrees(expr: &Expr) -> bool {
    let here = matches!(expr, Expr::Quotient(_, below) if matches!(**below, Expr::Degrees(_)));
    here || !expr.all_children(&mut |inner| !divides_by_degrees(inner))
}

pub(super) fn remark(what: &str, shown: &str, help: &str) -> Remark {
    Remark::new(format!("a text that reads badly, {what}"), "", "", help).showing(shown)
}

/// The same, of the author's own words, which stand in the file as they are here.
pub(super) fn remark_at(what: &str, at: &str, shown: &str, help: &str) -> Remark {
    Remark::new(format!("a text that reads badly, {what}"), at, "here", help).showing(shown)
}

/// A place in words with the two words before it and the two after, so that no other place is taken for it.
pub(super) fn around(words: &str, at: usize) -> &str {
    let (before, after) = words.split_at(at);
    let start = before.rmatch_indices(char::is_whitespace).nth(2).map_or(0, |(space, _)| space);
    let end = after.match_indices(char::is_whitespace).nth(3).map_or(words.len(), |(space, _)| at + space);
    words[start..end].trim()
}

/// The formula of a piece.
fn formula(piece: &Piece) -> Option<&Expr> {
    match piece {
        Piece::Formula(expr) | Piece::Quantity(expr, _) | Piece::Display(expr) => Some(expr),
        Piece::Words(_) | Piece::Italic(_) => None,
    }
}

/// The numbers and formulas of a text, with the words between them.
fn of_pieces(pieces: &[&Piece], words: &Words, remarks: &mut Vec<Remark>) {
    for (place, piece) in pieces.iter().copied().enumerate() {
        let after = match pieces.get(place + 1) {
            Some(Piece::Words(words)) => words.as_str(),
            _ => "",
        };
        let Some(expr) = formula(piece) else { continue };
        let before = match place.checked_sub(1).and_then(|place| pieces.get(place)) {
            Some(Piece::Words(words)) => words.as_str(),
            _ => "",
        };
        if divides_by_degrees(expr) && shown(piece).contains("/1°") {
            let help = "print it in degrees, as in `{alpha deg}`; or say `{tan(alpha) = t}`, with `alpha` a letter of `symbols`";
            remarks.push(remark("an angle over one degree", &shown(piece), help).warning());
        }
        let is_signed = || is_of_a_vector(&pieces[..place]) && tells_the_sense(words);
        of_number(expr, piece, before, after, &is_signed, remarks);
        if after.trim() == "and" && pieces.get(place + 2) == Some(&piece) && !matches!(expr, Expr::Vector(..)) {
            let one = shown(piece);
            let help = "say `each`, or require that the two differ";
            let twice = remark("the same thing said twice", &format!("{one} and {one}"), help);
            // Components come in twos, and may be equal: 2i + 2j.
            remarks.push(if is_of_components(&pieces[..place]) { twice.warning() } else { twice });
        }
    }
}

/// The words of the sentence that leads up to a number.
fn leading(before: &[&Piece]) -> String {
    let words = before.iter().map(|piece| match piece {
        Piece::Words(words) => words.as_str(),
        _ => " ",
    });
    let words = words.collect::<String>();
    words[words.rfind(". ").map_or(0, |end| end + 2)..].to_lowercase()
}

/// Is what comes now said of components?
fn is_of_components(before: &[&Piece]) -> bool {
    leading(before).contains("components")
}

/// Is what comes now said of a velocity, or of a component of one, and of no speed?
fn is_of_a_vector(before: &[&Piece]) -> bool {
    let words = leading(before);
    let last = |noun: &str| words.rfind(noun);
    last("velocit").max(last("component")) > last("speed")
}

/// Do the words say which way is positive, so that what has a sign has a direction?
fn tells_the_sense(words: &Words) -> bool {
    const SENSES: [&str; 6] = [
        "as positive",
        "is positive",
        "positive direction",
        "positive sense",
        "measured in the direction",
        "in the direction from",
    ];
    let mut all = words.stem.iter().chain(&words.asks);
    all.any(|text| {
        let words = print::text_unicode(text).to_lowercase();
        SENSES.iter().any(|sense| words.contains(sense))
    })
}

fn shown(piece: &Piece) -> String {
    print::text_unicode(&Text(vec![piece.clone()]))
}

/// The last few words.
fn tail(text: &Text) -> String {
    let whole = print::text_unicode(text);
    let words: Vec<&str> = whole.split(' ').collect();
    words[words.len().saturating_sub(6)..].join(" ")
}

/// A number or formula, with the words before and after it.
fn of_number(
    expr: &Expr,
    piece: &Piece,
    before: &str,
    after: &str,
    is_signed: &dyn Fn() -> bool,
    remarks: &mut Vec<Remark>,
) {
    if let Some(bad) = ill_written(expr) {
        let (what, help) = match bad {
            Ill::Unreduced => ("a fraction that is not in its lowest terms", "write the values in lowest terms"),
            Ill::One => ("a factor of one", "derive the formula in `[let]`, which simplifies it"),
            Ill::Signs => ("two signs in a row", "derive the formula in `[let]`, which simplifies it"),
        };
        remarks.push(remark(what, &shown(piece), help));
    }
    let value = constant(expr);
    let sign = before.trim_end().chars().next_back().filter(|sign| matches!(sign, '+' | '-' | '−'));
    if let Some(sign) = sign.filter(|_| value.as_ref().is_some_and(|value| value.sign().is_lt())) {
        let help = "write the whole as one formula, as in `{[ax, ay] m/s}`, or require that it is positive";
        remarks.push(remark("two signs in a row", &format!("{sign} {}", shown(piece)), help));
    }
    if let (Piece::Quantity(_, unit), Some(value)) = (piece, &value) {
        if value.sign().is_lt() && !is_signed() {
            remarks.push(remark("a quantity below nought", &shown(piece), "say which way it is, and give its size"));
        } else if value.is_zero() && *unit != Unit::Degree {
            remarks.push(remark(
                "a quantity of nought",
                &shown(piece),
                "say `at rest`, or require that it is not nought",
            ));
        }
    }
    if let (Piece::Quantity(..), Expr::Vector(x, y)) = (piece, expr)
        && [x, y].iter().all(|component| constant(component).is_some_and(|value| value.is_zero()))
    {
        remarks.push(remark("a vector of nought", &shown(piece), "say `at rest`, or require that it is not nought"));
    }
    if let (Piece::Formula(Expr::Number(number)), false) = (piece, after.is_empty()) {
        let next = after.strip_prefix(' ').and_then(|rest| rest.split([' ', ',', '.', ';', ')']).next()).unwrap_or("");
        if *number == Fraction::ONE && is_plural(next) {
            remarks.push(remark("one of several", &format!("1 {next}"), "require that the number is not one"));
        } else if *number != Fraction::ONE && SINGULAR.contains(&next) {
            let several = format!("{} {next}", shown(piece));
            remarks.push(remark("several of one", &several, "write the word in the plural"));
        }
    }
    plural_of_one(piece, before, after, remarks);
    article(piece, before, remarks);
}

/// `Of masses 3 kg`, where one number stands alone.
fn plural_of_one(piece: &Piece, before: &str, after: &str, remarks: &mut Vec<Remark>) {
    const PLURALS: [&str; 4] = ["masses", "speeds", "velocities", "radii"];
    let before = before.trim_end();
    let Some(plural) = PLURALS.into_iter().find(|plural| before.ends_with(plural)) else { return };
    let clause = after.split('.').next().unwrap_or_default();
    let has_others = clause.starts_with([',', '/']) || [" and", " or", "each"].iter().any(|word| clause.contains(word));
    if !has_others {
        let help = "write the word in the singular, or give each its number";
        remarks.push(remark_at("several of one", plural, &format!("{plural} {}", shown(piece)), help));
    }
}

/// Words for one thing that can be counted.
const SINGULAR: [&str; 9] = ["second", "metre", "kilogram", "newton", "joule", "degree", "time", "sphere", "particle"];

/// Words that end in s and count nothing.
const NO_PLURALS: [&str; 12] =
    ["is", "was", "has", "as", "its", "this", "thus", "less", "makes", "across", "does", "gives"];

fn is_plural(word: &str) -> bool {
    let ends = word.ends_with('s') && !word.ends_with("ss") && !word.ends_with("wards");
    ends && word.chars().all(char::is_lowercase) && !NO_PLURALS.contains(&word)
}

/// 'a 4 kg sphere' and 'an 8 kg sphere'.
fn article(piece: &Piece, before: &str, remarks: &mut Vec<Remark>) {
    let article = before.strip_suffix(' ').and_then(|rest| rest.rsplit([' ', '(']).next());
    let Some(article @ ("a" | "an")) = article else { return };
    let number = match piece {
        Piece::Quantity(expr, _) | Piece::Formula(expr) => constant(expr),
        _ => None,
    };
    let Some(number) = number.filter(Fraction::is_integer) else { return };
    let digits = number.to_string();
    let is_an = digits.starts_with('8') || digits == "11" || digits == "18";
    if (article == "a" && is_an) || (article == "an" && !is_an) {
        let help = "put the number elsewhere in the sentence: `of mass 8 kg`";
        remarks.push(remark("`a` or `an` before a number", &format!("{article} {}", shown(piece)), help));
    }
}

/// The number that an expression of plain numbers is.
fn constant(expr: &Expr) -> Option<Fraction> {
    match expr {
        Expr::Number(number) => Some(number.clone()),
        Expr::Decimal(text) => text.parse().ok(),
        Expr::Negative(inner) => constant(inner).map(|number| -number),
        _ => None,
    }
}

/// How a formula is written as nobody writes it.
enum Ill {
    Unreduced,
    One,
    Signs,
}

fn ill_written(expr: &Expr) -> Option<Ill> {
    let found = match expr {
        Expr::Quotient(above, below) => match (constant(above), constant(below)) {
            (Some(above), Some(below)) if above.is_integer() && below.is_integer() => {
                let lowest = below.reciprocal().map(|part| &above * &part);
                let is_lowest = lowest.is_some_and(|lowest| Fraction::from(lowest.denominator()) == below);
                (!is_lowest || below == Fraction::ONE).then_some(Ill::Unreduced)
            }
            (_, Some(below)) if below == Fraction::ONE => Some(Ill::One),
            _ => None,
        },
        Expr::Product(factors) => {
            let is_one = |factor: &Expr| constant(factor).is_some_and(|number| number.abs() == Fraction::ONE);
            factors.iter().any(is_one).then_some(Ill::One)
        }
        Expr::Negative(inner) => matches!(**inner, Expr::Negative(_)).then_some(Ill::Signs),
        _ => None,
    };
    found.or_else(|| expr.children().into_iter().find_map(ill_written))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::expr::read_markup;

    #[test]
    fn carom_knows_what_nobody_writes() {
        let table = [
            ("The spheres have masses {m} and {2*m}.", ""),
            ("A mass of {2 kg} and {3/4} of {5 m/s}.", ""),
            ("It rebounds {3} times and turns {1} corner.", ""),
            ("Then {1} is the answer, and {1} gives it.", ""),
            ("An {8 kg} mass and a {7 kg} mass, an {11} and a {1}.", ""),
            ("At that instant it has moved so that that is so, and so on ...", ""),
            ("The masses are {m} and {m}.", "m and m"),
            ("The mass is {2/4} of it.", "2/4"),
            ("The mass is {3/1} of it.", "3/1"),
            ("The mass is {1*m}.", "a factor of one"),
            ("The speed is {0 m/s}.", "a quantity of nought"),
            ("The speed is {-3 m/s}.", "below nought"),
            ("The velocity is ({4}{i} + {-3}{j}) m/s.", "two signs in a row"),
            ("The velocity is ({4}{i} + {3}{j}) m/s.", ""),
            ("The velocity is {[0, 0] m/s}.", "a vector of nought"),
            ("It rebounds {1} times.", "1 times"),
            ("After {2} second it stops.", "2 second"),
            ("A sphere of masses {2 kg} moves.", "masses 2 kg"),
            ("The masses are {2 kg} and {3 kg}; of masses {m}, {k} and {l}.", ""),
            ("Two small smooth sphere collide.", "Two … sphere"),
            ("Two small smooth spheres collide, one sphere at rest. The two paths and the wall.", ""),
            ("A {8 kg} mass, a {18 kg} mass.", "a 18 kg"),
            ("An {7 kg} mass, an {7 kg} mass.", "an 7 kg"),
            ("The the mass is {m} , they say.", "stray sign"),
            ("It is the the mass.", "the the"),
            ("It is a a smooth sphere.", "a a"),
            ("A a smooth sphere.", "A a"),
            ("It lies on the\nthe plane.", "the the"),
            ("It starts at a, a point of the plane.", ""),
            ("A smooth sphere *a* strikes the sphere *B*.", "small letter"),
            ("The spheres *A* and *B* have radius *a*.", ""),
            ("The the mass is {m}.", "The the"),
            ("A uniform sphere, an elastic one, a mass, an hour, an {8 kg} mass.", ""),
            ("It is an smooth sphere.", "an smooth"),
            ("A elastic sphere.", "A elastic"),
            ("The mass of *A of {m}.", "mend `*`"),
            ("_Immediately afterwards it stops.", "mend `_`"),
            ("The speed is {{ u }}.", "mend `{`"),
            ("Sphere *A* (of mass {2 kg}, is moving.", "(of mass"),
            ("Sphere *A* (of mass {2 kg}) is moving, with {e} in (0, 1]. (a) Find it. b) Find it.", ""),
            ("It's speed is {u}.", "It's"),
            ("It's given that they meet.", ""),
        ];
        for (words, shown) in table {
            let mut remarks = Vec::new();
            for text in read_markup(words).unwrap() {
                let mut pieces = Vec::new();
                in_order(&text.0, &mut pieces);
                Heard::default().unreadable(&text, &pieces, &mut remarks);
                of_pieces(&pieces, &Words::default(), &mut remarks);
            }
            let said = format!("{remarks:?}");
            assert!(remarks.is_empty() == shown.is_empty() && said.contains(shown), "{words}: {said}");
        }
    }

    #[test]
    fn a_sentence_may_go_on_into_the_parts() {
        let text = |words: &str| Cow::Owned(read_markup(words).unwrap().remove(0));
        let table = [
            ("*A* strikes *B*. Given that e is {e},", &["find the speed of *A*,", "find the speed of *B*."][..], ""),
            ("*A* strikes *B*. Given that e is {e},", &["Find the speed of *A*."], "without a full stop"),
            ("*A* strikes *B*. Find", &["the speed of *A*."], "without a full stop"),
            ("*A* strikes *B*. Find:", &["the speed of *A*;", "the speed of *B*."], ""),
            ("*A* strikes *B*.", &["Find the speed of *A*,"], "without a full stop"),
            ("*A* strikes *B*.", &["find the speed of *A*."], "without a capital"),
        ];
        for (stem, asks, shown) in table {
            let words =
                Words { stem: vec![text(stem)], asks: asks.iter().map(|ask| text(ask)).collect(), said: vec![] };
            let mut remarks = Vec::new();
            each_sentence(&words, &mut remarks);
            let said = format!("{remarks:?}");
            assert!(remarks.is_empty() == shown.is_empty() && said.contains(shown), "{stem} {asks:?}: {said}");
        }
        // The note of a style comes between them.
        let stem = [text("*A* strikes *B*. Given that e is {e},"), text("Give it to 3 significant figures.")];
        let words = Words { stem: stem.to_vec(), asks: vec![text("find the speed of *A*.")], said: vec![] };
        let mut remarks = Vec::new();
        each_sentence(&words, &mut remarks);
        assert_eq!(format!("{remarks:?}").matches("`note` of this style").count(), 2, "{remarks:?}");
    }
}
