//! A line of working as a student writes it: a few words, then an equation, a chain of equals signs, or values.

use std::borrow::Cow;
use std::rc::Rc;

use super::all_over::all_over;
use super::candidates::candidates;
use super::decimal_commas::{has_decimal_commas, is_perhaps_a_decimal, with_points};
use super::explained::explained;
use super::labels::without_label;
use super::products::{Products, factors_of_functions, has_letters};
use super::remarks::{before_and_after, is_formula, without_arrow};
use super::sentence::{equations_in_sentence, steps};
use crate::expr::{Expr, Relation};
use crate::mark::reading::{Form, Reading, Said, Statement, Vocabulary, is_never_letters, read_whole};
use crate::mark::working::letters::{indexed_letters, own_capitals, own_unknowns, short_letters, with_signs};
use crate::number::{Letter, Range};

/// A line of working, read.
#[derive(Clone, Debug)]
pub(in crate::mark::working) struct Line {
    /// Its number in the working, from 1.
    pub(in crate::mark::working) number: usize,
    /// What was typed.
    pub(in crate::mark::working) typed: String,
    /// What it may say, the likeliest first; nothing if it cannot be read. The same wherever the line is looked at.
    pub(in crate::mark::working) readings: Vec<Rc<ReadLine>>,
}

impl Line {
    /// Does it go on from the line before?
    pub(in crate::mark::working) fn goes_on(&self) -> bool {
        goes_on(&self.typed)
    }

    /// Its readings, to be changed.
    pub(in crate::mark::working) fn readings_mut(&mut self) -> impl Iterator<Item = &mut ReadLine> {
        self.readings.iter_mut().map(Rc::make_mut)
    }

    /// Is all of it crossed out?
    pub(in crate::mark::working) fn is_crossed_out(&self) -> bool {
        let typed = self.typed.trim();
        let between = typed.strip_prefix("~~").and_then(|rest| rest.strip_suffix("~~"));
        let is_struck = |(place, sign): (usize, char)| {
            !sign.is_alphanumeric() || typed[place + sign.len_utf8()..].starts_with('\u{336}')
        };
        between.is_some_and(|between| !between.contains("~~"))
            || (typed.contains('\u{336}') && typed.char_indices().all(is_struck))
    }
}

/// One way to read a line.
#[derive(Clone, Debug)]
pub(in crate::mark::working) struct ReadLine {
    /// In the notation of a terminal.
    pub(in crate::mark::working) printed: String,
    /// Every equation: `a = b = c` makes two.
    pub(in crate::mark::working) equations: Vec<(Expr, Expr)>,
    /// Every value with what it is called.
    pub(in crate::mark::working) members: Vec<Member>,
    /// What was read.
    pub(in crate::mark::working) statements: Vec<Statement>,
    /// Was a letter for an angle taken for the only angle that the question names?
    pub(in crate::mark::working) is_guessed: bool,
}

/// One side of an equals sign, or a value alone.
#[derive(Clone, Debug)]
pub(in crate::mark::working) struct Member {
    /// The place of its statement in the line.
    pub(in crate::mark::working) statement: usize,
    /// What the statement is called as it was typed, if it is called anything.
    pub(in crate::mark::working) label: Option<String>,
    /// The letter before the first equals sign, if that is what stands there.
    pub(in crate::mark::working) letter: Option<String>,
    /// The value.
    pub(in crate::mark::working) expr: Expr,
    /// Is it said to be a mass or e: by its name, or by its unit?
    pub(in crate::mark::working) is_given: bool,
    /// `2v` or `w²` before the first equals sign: so much of a letter, which names no value.
    pub(in crate::mark::working) multiple: Option<Expr>,
}

/// Letters that students give to what they look for. What the question has stands before these.
const UNKNOWNS: [&str; 23] = [
    "v", "w", "v_A", "v_B", "v_1", "v_2", "V", "W", "V_A", "V_B", "V_1", "V_2", "w_A", "w_B", "u_A", "u_B", "u_1",
    "u_2", "I", "theta", "alpha", "beta", "phi",
];
/// Letters that are also signs: only where a line cannot be read without them.
const DOUBTFUL: [&str; 7] = ["x", "y", "X", "Y", "p", "q", "J"];
/// What else a student may call the unknowns: where a line makes sense in no other way.
pub(in crate::mark::working) const OWN: [&str; 26] = [
    "a", "b", "c", "d", "s", "t", "u", "f", "g", "h", "k", "z", "m", "M", "X", "Y", "x_1", "x_2", "y_1", "y_2", "x_A",
    "x_B", "y_A", "y_B", "w_1", "w_2",
];
/// Letters that stand for what is given as a number.
const GIVEN: [&str; 5] = ["e", "m_A", "m_B", "m_1", "m_2"];

/// More lines than this are for a person to read.
pub(in crate::mark) const MOST_LINES: usize = 60;

/// Reads lines of working where the question has these letters, and perhaps vectors; an earlier part has `explained` others.
pub(in crate::mark::working) fn read(
    working: &[String],
    letters: &[Letter],
    vectors: bool,
    explained: &[(String, Expr)],
) -> Vec<Line> {
    let with = |names: &[&str]| {
        let mut all = letters.to_vec();
        for name in names {
            if !letters.iter().any(|letter| letter.name() == *name) {
                all.extend(Letter::new(name, Range::Real));
            }
        }
        Vocabulary { letters: all, vectors }
    };
    let capitals = own_capitals(working, letters);
    let short = short_letters(working, letters);
    let indexed = indexed_letters(working, letters);
    let unknowns = own_unknowns(working, letters);
    let explained = explained.iter().map(|(letter, _)| letter);
    let own = capitals.iter().chain(&short).chain(&unknowns).chain(&indexed).chain(explained).map(String::as_str);
    let usual: Vec<&str> = UNKNOWNS.into_iter().chain(GIVEN).chain(own).collect();
    let doubtful: Vec<&str> = usual.iter().copied().chain(DOUBTFUL).collect();
    let own: Vec<&str> = doubtful.iter().copied().chain(OWN).collect();
    let mut vocabularies = vec![with(&usual), with(&doubtful), with(&own)];
    // A student may choose i and j where the question has none.
    if !vectors {
        vocabularies.push(Vocabulary { vectors: true, ..vocabularies[2].clone() });
    }
    let products = Products::of(typed(working), letters);
    let has_commas = has_decimal_commas(typed(working), vectors);
    let read = |(place, typed): (usize, &str)| {
        let pointed = if has_commas { with_points(typed) } else { Cow::Borrowed(typed) };
        let signed = with_signs(without_label(&pointed));
        let are_numbers = !vectors && is_perhaps_a_decimal(&pointed);
        let readings =
            readings(&products.signed(&signed), &vocabularies[..vocabularies.len() - usize::from(are_numbers)]);
        Line { number: place + 1, typed: typed.to_owned(), readings: readings.into_iter().map(Rc::new).collect() }
    };
    typed(working).take(MOST_LINES).enumerate().map(read).collect()
}

/// Does a line begin with an equals sign, and so go on from the one before? An arrow `=>` draws a conclusion.
pub(in crate::mark) fn goes_on(typed: &str) -> bool {
    let typed = typed.trim_start();
    typed.starts_with(['=', '≈']) && !typed.starts_with("=>")
}

/// The lines of a working that say something, each step of a line by itself.
pub(in crate::mark) fn typed(working: &[String]) -> impl DoubleEndedIterator<Item = &str> {
    working.iter().flat_map(|cell| cell.lines()).flat_map(steps)
}

impl ReadLine {
    /// The same with other letters.
    pub(in crate::mark::working) fn in_letters(&self, letter: &dyn Fn(&str) -> Option<Expr>) -> ReadLine {
        self.with(&|expr| expr.substitute(letter))
    }

    /// The same with other formulas.
    pub(in crate::mark::working) fn with(&self, put: &dyn Fn(&Expr) -> Expr) -> ReadLine {
        let mut line = read_line(Reading::with(&self.statements, put));
        // A name that stands before a colon is none of the statement's.
        for (member, before) in line.members.iter_mut().zip(&self.members).filter(|(member, _)| member.label.is_none())
        {
            member.label.clone_from(&before.label);
        }
        line
    }
}

fn readings(typed: &str, vocabularies: &[Vocabulary]) -> Vec<ReadLine> {
    let mut found: Vec<ReadLine> = Vec::new();
    // What a letter stands for is no aside here.
    let explained = explained(typed);
    // `x = … from u cos θ = x + y`: from another equation, not from a line.
    let from = [" from ", " means "].into_iter().find_map(|word| typed.split_once(word));
    let explained = explained.or_else(|| from.filter(|(before, _)| before.contains('=')));
    let listed = match explained.filter(|(_, after)| after.contains('=')) {
        Some((before, after)) => Cow::Owned(format!("{}, {after}", before.trim_end_matches(','))),
        None => Cow::Borrowed(typed),
    };
    let typed = &*listed;
    let may_equate =
        typed.contains(['=', '≈', '<', '>', '≤', '≥']) || typed.contains("equal") || typed.contains(" is ");
    let typed = &*without_arrow(typed);
    let has_factors = |vocabulary: &Vocabulary| factors_of_functions(typed).all(|own| has_letters(vocabulary, own));
    let may_have = vocabularies.iter().any(has_factors);
    let (mut candidates, sentence) = (candidates(typed), equations_in_sentence(typed));
    // Of components along a slanting line, which have roots: of others one does not change.
    if vocabularies[0].vectors && typed.contains('√') {
        candidates.splice(0..0, before_and_after(typed).map(|both| (None, both)));
    }
    for (place, vocabulary) in vocabularies.iter().enumerate() {
        if may_have && !has_factors(vocabulary) {
            continue;
        }
        if place > 0 && !says_more(typed, &vocabularies[place - 1], vocabulary) {
            continue;
        }
        for (name, text) in &candidates {
            let Ok(readings) = read_whole(text, vocabulary) else { continue };
            for reading in readings {
                let mut line = read_line(reading);
                for member in line.members.iter_mut().filter(|member| member.label.is_none()) {
                    member.label = name.map(str::to_owned);
                }
                if found.iter().all(|other| other.statements != line.statements) {
                    // `A after: 4 − 3 = 1` is an equation with a name.
                    let is_named = name.is_some() && !line.equations.is_empty();
                    let place = if is_named { 0 } else { found.len() };
                    found.insert(place, line);
                }
            }
            // Words before a formula may be a name or a remark: what has an equation or a value is enough.
            if found.iter().any(|line| !line.equations.is_empty()) {
                break;
            }
        }
        // A sentence of several equations says more than one of them with a name.
        let sentence = sentence.as_deref().and_then(|text| read_whole(text, vocabulary).ok());
        let most = found.iter().map(|line| line.equations.len()).max().unwrap_or(0);
        let several = sentence.into_iter().flatten().map(read_line).filter(|line| line.equations.len() > most);
        found.splice(0..0, several);
        // What may be meant by a stroke without brackets comes last.
        let quotient = candidates.iter().rev().find_map(|(_, text)| read_whole(&all_over(text)?, vocabulary).ok());
        if !found.is_empty() {
            let lines = quotient.into_iter().flatten().map(read_line).filter(|line| !line.equations.is_empty());
            found.extend(lines.take(1));
        }
        if found.iter().any(|line| !line.equations.is_empty()) {
            found.sort_by_key(|line| has_gradient_alone(line) && is_apart_from_origin(typed));
            return found;
        }
        // What makes sense without an equation has none in other letters.
        if !found.is_empty() && !may_equate {
            return found;
        }
    }
    found
}

/// Is nothing in it but the gradient of a line, which was given by its equation?
fn has_gradient_alone(line: &ReadLine) -> bool {
    let is_gradient = |said: &Said| matches!(said.form, Form::Gradient(_));
    line.equations.is_empty() && line.statements.iter().flat_map(|statement| &statement.said).all(is_gradient)
}

/// Does an equation end in a number that is not nought? `3x + 4y = 35` is for two components: the line of centres as one has
/// `y = -3x`.
fn is_apart_from_origin(typed: &str) -> bool {
    let end = typed.rsplit('=').next().unwrap_or_default().trim().trim_start_matches(['-', '−']);
    end.parse::<f64>().is_ok_and(|number| number != 0.0)
}

/// May a line say something else with more letters, or with vectors? What only remarks and figures stand in does not.
fn says_more(typed: &str, few: &Vocabulary, more: &Vocabulary) -> bool {
    // Letters of another alphabet may be ours in another shape.
    let added = |sign: char| {
        !sign.is_ascii() || more.letters[few.letters.len()..].iter().any(|letter| letter.name().starts_with(sign))
    };
    let is_vector = |sign: char| more.vectors && !few.vectors && matches!(sign, 'i' | 'j');
    let mut words =
        typed.split(|sign: char| !sign.is_alphabetic()).filter(|word| !is_formula(word) && !is_never_letters(word));
    words.any(|word| word.contains(|sign| added(sign) || is_vector(sign)))
        || (more.vectors && !few.vectors && may_have_column(typed))
}

/// Do brackets stand here that may hold the components of a vector?
fn may_have_column(typed: &str) -> bool {
    let is_component = |sign: char| sign.is_ascii_digit() || " .-−/".contains(sign);
    let inside = |opened: &&str| {
        opened.split(')').next().is_some_and(|inside| inside.trim().contains(' ') && inside.chars().all(is_component))
    };
    typed.contains([',', ';', '[', '<', '⟨', '\\', '&']) || typed.split('(').skip(1).any(|opened| inside(&opened))
}

fn read_line(reading: Reading) -> ReadLine {
    let mut equations = Vec::new();
    let mut members = Vec::new();
    for (place, statement) in reading.statements.iter().enumerate() {
        let label = statement.label.as_ref();
        let letter = label.and_then(|label| match &label.expr {
            Some(Expr::Name(name)) => Some(name.text.clone()),
            _ => None,
        });
        let typed = label.map(|label| label.typed.clone());
        let mut sides: Vec<Expr> = label.and_then(|label| label.expr.clone()).into_iter().collect();
        for said in &statement.said {
            match &said.form {
                Form::Value(expr) | Form::Percentage(expr) | Form::Gradient(expr) | Form::Mixed(expr) => {
                    sides.push(expr.clone())
                }
                Form::Vector(x, y, _) => sides.push(Expr::Vector(Box::new(x.clone()), Box::new(y.clone()))),
                Form::Equation(Expr::Relation(left, Relation::Equal, right)) => {
                    sides.extend([(**left).clone(), (**right).clone()]);
                }
                Form::AtRest => sides.push(Expr::integer(0)),
                Form::Equation(_) | Form::Ratio(..) | Form::Range(..) | Form::Direction => {}
            }
        }
        let multiple = sides.first().filter(|first| sides.len() > 1 && is_multiple(first)).cloned();
        let in_kilograms = |said: &Said| said.unit.as_ref().is_some_and(|unit| unit.typed.ends_with("kg"));
        let is_mass = |letter: &str| letter.eq_ignore_ascii_case("m") || GIVEN.contains(&letter);
        let is_given = letter.as_deref().is_some_and(is_mass)
            || typed.as_ref().is_some_and(|typed| typed.to_lowercase().contains("mass"))
            || statement.said.iter().any(in_kilograms);
        equations.extend(sides.windows(2).map(|pair| (pair[0].clone(), pair[1].clone())));
        let of_second = letter.as_ref().map(|_| of_second_letter(place, &sides)).unwrap_or_default();
        members.extend(sides.into_iter().map(|expr| Member {
            statement: place,
            label: typed.clone(),
            letter: letter.clone(),
            expr,
            is_given,
            multiple: multiple.clone(),
        }));
        members.extend(of_second);
    }
    ReadLine { printed: reading.printed, equations, members, statements: reading.statements, is_guessed: false }
}

/// In `v = w = 2/3` the values are those of w too.
fn of_second_letter(statement: usize, sides: &[Expr]) -> Vec<Member> {
    let [_, Expr::Name(second), values @ ..] = sides else { return Vec::new() };
    let member = |expr: &Expr| Member {
        statement,
        label: Some(second.text.clone()),
        letter: Some(second.text.clone()),
        expr: expr.clone(),
        is_given: false,
        multiple: None,
    };
    values.iter().map(member).collect()
}

/// Is it a letter times numbers, or a power of one: `2v`, `v/3`, `½·3·w²`?
fn is_multiple(expr: &Expr) -> bool {
    let is_plain = |expr: &Expr| matches!(expr, Expr::Name(_));
    match expr {
        Expr::Negative(inner) | Expr::Power(inner, _) => is_plain(inner) || is_multiple(inner),
        Expr::Quotient(above, below) => below.names().is_empty() && (is_plain(above) || is_multiple(above)),
        Expr::Product(factors) => {
            let mut lettered = factors.iter().filter(|factor| !factor.names().is_empty());
            let letter = lettered.next().is_some_and(|letter| is_plain(letter) || is_multiple(letter));
            letter && lettered.next().is_none()
        }
        _ => false,
    }
}
