//! Reading what a student typed on one line.
//!
//! Characters become a small alphabet, LaTeX goes the same way, signs become tokens and words become phrases; what is
//! left is formulas, read by a grammar that is a student's and not a programmer's. Where notation is open to doubt, the
//! likely reading comes first and the other follows; a report says which was used.

mod alone;
mod angle_names;
mod around;
mod asides;
mod axes;
mod both_signs;
mod centres;
mod characters;
mod choices;
mod columns;
mod commands;
mod common_letter;
mod crossed_out;
mod degrees;
mod digits;
mod directions;
mod emphasis;
mod ends;
mod environments;
mod equalities;
mod equation_number;
mod events;
mod formula;
mod functions;
mod grammar;

mod inequalities;
mod infix_fraction;
mod latex;
mod lexicon;
mod line;
mod markup;
mod named_line;
mod names;
mod number_words;
mod operands;
mod part_label;
mod phrases;
mod printed;
mod products;
mod ranges;
mod reference;
mod rewritten;
mod said;
mod said_again;
mod second_thoughts;
mod segments;
mod side_by_side;
mod sides;
mod signs;
mod spelling;
mod statements;
#[cfg(test)]
mod tests;
mod tokens;
mod units;
mod values;
mod vectors;
mod word;
mod wording;

pub(crate) use events::{FURTHER, MEETING, NEVER};
pub(crate) use lexicon::{
    LEAST, MOST, NOT_QUITE, PAST, SIZES, WAYS, is_never_letters, is_rejection, is_strange, names_a_quantity,
    turns_round,
};
pub(crate) use line::ACROSS;
pub(crate) use named_line::{NamedLine, named_line};
pub use reference::{ReferenceLine, Sense};
pub use said::{End, Form, Label, Notation, Reading, Said, SaidUnit, Statement, Unreadable, Vocabulary};
pub(crate) use second_thoughts::{is_in_place_of, is_second_thought};
pub(crate) use tokens::{greek, greek_name};
pub(crate) use word::is_dotted;

use choices::{Choices, Flip};
use crossed_out::{is_withdrawn, without_crossed_out};

/// The longest answer that is read, in bytes; a longer one goes to a person.
pub const LONGEST: usize = 2000;

/// The most readings of one answer.
pub const MOST_READINGS: usize = 8;

/// The most ways in which one answer is tried.
const MOST_TRIALS: usize = 24;

/// After so many steps no further reading is tried.
const PATIENCE: usize = 2_000;

/// Every reading that a person might see in an answer, the likeliest first: at least one, at most [`MOST_READINGS`].
///
/// ```
/// use carom::mark::reading::{Vocabulary, read_answer};
/// use carom::number::{Letter, Range};
/// let letters = ["u", "v"].map(|name| Letter::new(name, Range::Positive).unwrap());
/// let question = Vocabulary { letters: letters.into(), vectors: false };
/// let readings = read_answer("u/2v", &question).unwrap();
/// let printed: Vec<&str> = readings.iter().map(|reading| reading.printed.as_str()).collect();
/// assert_eq!(printed, ["u/(2v)", "(u/2)v"]);
/// assert_eq!(readings[0].decided, ["u/2v read as u/(2v)"]);
/// ```
///
/// # Errors
///
/// The first thing that makes no sense in the likeliest reading, if no reading makes sense.
pub fn read_answer(text: &str, vocabulary: &Vocabulary) -> Result<Vec<Reading>, Unreadable> {
    if is_date(text) {
        return Err(Unreadable::Sign(0, "a date: a spreadsheet makes one of `3/4`".to_owned()));
    }
    if text.len() <= LONGEST && is_withdrawn(text) {
        let mut readings = read_whole(text, vocabulary)?;
        readings.iter_mut().for_each(Reading::take_back);
        return Ok(readings);
    }
    let readings = read_whole(text, vocabulary);
    // `I = m(v − u) = 3(5 − 2) = 9`
    let may_lead_on = matches!(readings, Err(Unreadable::Sign(..))) && text.matches('=').count() > 1;
    match may_lead_on.then(|| counted(text, vocabulary, true).0) {
        Some(Ok(found)) => Ok(found),
        _ => readings,
    }
}

/// `3/4/2026`, which is what a spreadsheet makes of three quarters.
fn is_date(text: &str) -> bool {
    let is_year = |year: &str| year.len() == 4 && (year.starts_with("19") || year.starts_with("20"));
    let is_day = |day: &str| (1..=2).contains(&day.len());
    let text = text.trim();
    let is_in_figures = text.bytes().all(|sign| matches!(sign, b'0'..=b'9' | b'/' | b'-' | b'.'));
    let parts: Vec<&str> = if is_in_figures { text.split(['/', '-', '.']).collect() } else { Vec::new() };
    match parts.as_slice() {
        [one, two, year] if is_year(year) => is_day(one) && is_day(two),
        [year, one, two] => is_year(year) && is_day(one) && is_day(two),
        _ => false,
    }
}

/// The readings of every word of an answer or a line of working: no formula is passed over.
pub(super) fn read_whole(text: &str, vocabulary: &Vocabulary) -> Result<Vec<Reading>, Unreadable> {
    let readings = counted(text, vocabulary, false).0;
    let is_sign = matches!(readings, Err(Unreadable::Sign(..)));
    let with_small = is_sign.then(|| names::with_small_unit_vectors(text, vocabulary)).flatten();
    if let Some(Ok(mut found)) = with_small.map(|small| counted(&small, vocabulary, false).0) {
        found.iter_mut().for_each(|reading| reading.decided.push("I and J read as i and j".to_owned()));
        return Ok(found);
    }
    // `|3i + 4j| = 5` where no answer is a vector.
    let has_own = vocabulary.vectors || vocabulary.letters.iter().any(|letter| matches!(letter.name(), "i" | "j"));
    if has_own || !matches!(readings, Err(Unreadable::Sign(..))) || !has_unit_vector(text) {
        return readings;
    }
    let with_vectors = Vocabulary { vectors: true, ..vocabulary.clone() };
    match counted(text, &with_vectors, false).0 {
        Ok(found) if !found.iter().any(is_of_direction) => Ok(found),
        _ => readings,
    }
}

/// How **i** lies where no answer is a vector, nobody says.
fn is_of_direction(reading: &Reading) -> bool {
    let mut said = reading.statements.iter().flat_map(|statement| &statement.said);
    said.any(|said| said.reference.is_some() || matches!(said.form, Form::Vector(_, _, Notation::Words)))
}

/// Does an i or j stand by itself, or after figures?
fn has_unit_vector(text: &str) -> bool {
    let mut words = text.split(|sign: char| !sign.is_alphabetic());
    words.any(|word| matches!(word, "i" | "j"))
}

/// The readings, and how many steps it took to find them.
fn counted(text: &str, vocabulary: &Vocabulary, passes_over: bool) -> (Result<Vec<Reading>, Unreadable>, usize) {
    if text.len() > LONGEST {
        return (Err(Unreadable::TooLong), 0);
    }
    let glyphs = match characters::glyphs(text)
        .map(emphasis::without_bold)
        .map(emphasis::without_italics)
        .map(emphasis::without_emphasis)
        .map(without_crossed_out)
        .and_then(|glyphs| latex::without_latex(&glyphs))
    {
        Ok(glyphs) if characters::say_nothing(&glyphs) => return (Err(Unreadable::Blank), 0),
        Ok(glyphs) if vocabulary.vectors => characters::without_pointed_brackets(glyphs),
        Ok(glyphs) => glyphs,
        Err(reason) => return (Err(reason), 0),
    };
    let read = |flips: &[Flip]| {
        let mut choices = Choices::flipping(flips);
        let statements = tokens::tokens(&glyphs, &vocabulary.letters, &mut choices)
            .map(|tokens| units::with_joules(tokens, vocabulary))
            .map(|tokens| part_label::without_question_number(tokens, vocabulary))
            .map(|tokens| common_letter::without_common_letter(tokens, vocabulary, &mut choices))
            .map(|tokens| vectors::with_numbers_first(tokens, vocabulary))
            .map(|tokens| columns::on_two_lines(tokens, vocabulary, &mut choices))
            .map(|tokens| columns::with_joined_lines(tokens, vocabulary))
            .map(|tokens| angle_names::with_angles(tokens, vocabulary, &mut choices))
            .and_then(|tokens| phrases::with_phrases(&tokens, vocabulary, &mut choices))
            .and_then(|tokens| statements::statements(tokens, text, vocabulary, &mut choices, passes_over));
        (statements, choices)
    };
    let (first, choices) = read(&[]);
    let mut steps = choices.steps();
    let mut reason = None;
    let mut readings: Vec<Reading> = Vec::new();
    let mut keep = |statements: Result<Vec<Statement>, Unreadable>, choices: &Choices| match statements {
        Ok(statements) if readings.iter().all(|reading| reading.statements != statements) => {
            let printed = printed::shown(&statements);
            readings.push(Reading { statements, printed, decided: choices.decided().to_vec() });
        }
        Ok(_) => {}
        Err(fault) => reason = reason.take().or(Some(fault)),
    };
    keep(first, &choices);
    for flips in choices.further().iter().take(MOST_TRIALS) {
        // An answer that is long and laborious is read as is likely.
        if steps > PATIENCE {
            break;
        }
        let (statements, tried) = read(flips);
        steps += tried.steps();
        keep(statements, &tried);
    }
    readings.truncate(MOST_READINGS);
    let found = match (readings.is_empty(), reason) {
        (true, Some(reason)) => Err(reason),
        (true, None) => Err(Unreadable::Blank),
        _ => Ok(readings),
    };
    (found, steps)
}
