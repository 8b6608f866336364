//! A line of working as a student writes it: a few words, then an equation, a chain of equals signs, or values.

use std::borrow::Cow;
use std::rc::Rc;

use super::products::{Products, factors_of_functions, has_letters};
use super::remarks::{
    after_impact, after_remark, after_stationary, along_impulse, is_formula, named_by_moment, turned_round,
    without_arrow, without_cancelling, without_lead_in, without_remark,
};
use crate::expr::{Expr, Relation};
use crate::mark::reading::{Form, Reading, Said, Statement, Vocabulary, is_never_letters, read_whole};
use crate::mark::working::letters::{indexed_letters, own_capitals, own_unknowns, short_letters, with_primes};
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

/// The signs of an equation or an inequality.
const RELATIONS: [char; 5] = ['=', '<', '>', '≤', '≥'];

/// More lines than this are for a person to read.
pub(in crate::mark) const MOST_LINES: usize = 60;

/// Reads lines of working where the question has these letters, and perhaps vectors.
pub(in crate::mark::working) fn read(working: &[String], letters: &[Letter], vectors: bool) -> Vec<Line> {
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
    let indexed = indexed_letters(working);
    let unknowns = own_unknowns(working, letters);
    let own = capitals.iter().chain(&short).chain(&unknowns).map(String::as_str).chain(indexed);
    let usual: Vec<&str> = UNKNOWNS.into_iter().chain(GIVEN).chain(own).collect();
    let doubtful: Vec<&str> = usual.iter().copied().chain(DOUBTFUL).collect();
    let own: Vec<&str> = doubtful.iter().copied().chain(OWN).collect();
    let mut vocabularies = vec![with(&usual), with(&doubtful), with(&own)];
    // A student may choose i and j where the question has none.
    if !vectors {
        vocabularies.push(Vocabulary { vectors: true, ..vocabularies[2].clone() });
    }
    let products = Products::of(typed(working), letters);
    let read = |(place, typed): (usize, &str)| Line {
        number: place + 1,
        typed: typed.to_owned(),
        readings: readings(&products.signed(&with_primes(typed)), &vocabularies).into_iter().map(Rc::new).collect(),
    };
    typed(working).take(MOST_LINES).enumerate().map(read).collect()
}

/// The lines of a working that say something.
pub(in crate::mark::working) fn typed(working: &[String]) -> impl Iterator<Item = &str> {
    working.iter().flat_map(|cell| cell.lines()).map(str::trim).filter(|line| !line.is_empty())
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
    // What a letter stands for is no aside here: `… = 35t/(9 + 44t²), where t = tan α`.
    let explained = [" where ", " let ", " letting "].into_iter().find_map(|word| typed.split_once(word));
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
    let candidates = candidates(typed);
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
                return found;
            }
        }
        // What makes sense without an equation has none in other letters.
        if !found.is_empty() && !may_equate {
            return found;
        }
    }
    found
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

/// The line, and the line without the words before its formula: `CLM: …`, `by conservation of momentum …`.
///
/// With the words of which a colon says that they are its name.
fn candidates(typed: &str) -> Vec<(Option<&str>, String)> {
    let typed = typed.trim_start_matches(['∴', '→', '⇒', '•']).trim_start_matches("=>").trim();
    // An equals sign with nothing after it waits for what is worked out on the next line.
    let typed = without_remark(without_cancelling(typed.trim_end_matches(['=', ' '])));
    // A bullet stands apart; a minus sign does not.
    let typed = ["- ", "* "].iter().find_map(|bullet| typed.strip_prefix(bullet)).unwrap_or(typed).trim();
    let typed = without_lead_in(typed);
    // `3 × −2` and `4·3` are written with signs that words do not have.
    let mut all: Vec<(Option<&str>, String)> = Vec::new();
    all.extend(case(typed).map(|both| (None, both)));
    all.extend(turned_round(typed).map(|turned| (None, turned)));
    all.extend(along_impulse(typed).map(|along| (None, along)));
    all.extend(after_impact(typed).map(|after| (None, after)));
    all.extend(after_remark(typed).map(|formula| (None, formula.to_owned())));
    all.extend(named_by_moment(typed).map(|(name, formula)| (Some(name), formula.to_owned())));
    all.push((None, typed.to_owned()));
    if let Some((before, after)) = typed.split_once(':')
        && after.contains(RELATIONS)
    {
        // A law in general letters is no name of its numbers: `mu = m_A v_A + m_B v_B: 16 cos 30° = …`.
        let is_law = before.contains('=') && !before.contains(|sign: char| sign.is_ascii_digit());
        let name = if is_law { None } else { Some(before.trim()).filter(|before| !before.contains('=')) };
        // `product = -1: …` says in words what the formula is set equal to.
        let is_said = before
            .split_once('=')
            .map(|(name, _)| name.trim())
            .is_some_and(|name| name.len() > 3 && !is_formula(name) && name.chars().all(char::is_alphabetic));
        match name {
            _ if is_said => all = vec![(None, after.trim().to_owned())],
            _ if is_law => all.insert(0, (None, after.trim().to_owned())),
            None => {}
            name => all.push((name, after.trim().to_owned())),
        }
    }
    // `d/dt = 0: 2 - 6t² = 0` is no ratio.
    if let Some(formula) = after_stationary(typed) {
        all.insert(0, (None, formula.to_owned()));
    }
    // `v - u = 2i - 2j, which is parallel to i - j`: the vector, and one along it.
    let along = ["parallel to", "parallel", "∥"].into_iter().find_map(|word| typed.split_once(word));
    if let Some((before, after)) = along.filter(|(before, _)| before.contains('=')) {
        let before = before.trim_end().trim_end_matches("which is").trim_end_matches([' ', ',']);
        all.push((None, format!("{before}, {}", after.trim())));
    }
    // A scalar product is worked out on its right: `(2i + 5j).(i - j) = 2 - 5`, `p = (2i + 5j).(i - j) = -3`.
    let sides: Vec<&str> = typed.split('=').collect();
    let is_product = |side: &&str| SCALAR_PRODUCTS.iter().any(|sign| side.contains(sign));
    if let Some(product) = sides.iter().rposition(is_product).filter(|at| at + 1 < sides.len()) {
        let after = sides[product + 1..].join("=").trim().to_owned();
        all.extend((product > 0).then(|| (None, format!("{} = {after}", sides[0].trim()))));
        all.push((None, after));
    }
    // `p = -3 gives m = 2`: both, or what is concluded from a remark.
    for word in [" so ", " gives ", " hence ", " therefore "] {
        let Some((before, after)) = typed.split_once(word) else { continue };
        if after.contains(RELATIONS) {
            all.push((None, format!("{before}, {after}")));
            all.push((None, after.trim().to_owned()));
        }
    }
    let is_word = |word: &str| {
        let letters = word.trim_matches(['(', ')', '.', ',', ':']);
        // `3 and 4` are two values.
        let is_long = letters.chars().count() >= 3 && letters != "and";
        is_long && letters.chars().all(char::is_alphabetic) && !is_formula(letters)
    };
    let words: Vec<&str> = typed.split_whitespace().collect();
    let last = words.iter().take_while(|word| !word.contains('=')).enumerate().filter(|(_, word)| is_word(word)).last();
    if let Some((last, _)) = last
        && last + 1 < words.len()
    {
        all.push((None, without_lead_in(&words[last + 1..].join(" ")).to_owned()));
    }
    all
}

/// `for v = 0: 10 = 3w`: what holds in a case, and the equation there, if there is one. It has a letter: `k = 3 : 2 = 1.5` is a ratio.
fn case(typed: &str) -> Option<String> {
    let (case, equation) = typed.split_once(':')?;
    let sides: Vec<&str> = case.split(RELATIONS).collect();
    let (words, letter) = sides[0].trim_end().rsplit_once(' ').unwrap_or(("", sides[0].trim()));
    let is_letter = letter.len() <= 3 && letter.starts_with(char::is_alphabetic);
    let is_case = sides.len() == 2
        && is_letter
        && words.split_whitespace().all(|word| CASES.contains(&word.to_lowercase().as_str()));
    let case = case[words.len()..].trim().to_owned();
    let is_equation = equation.contains(RELATIONS) && equation.contains(char::is_alphabetic);
    match equation.trim() {
        "" => Some(case),
        equation => is_equation.then(|| format!("{case}, {equation}")),
    }
    .filter(|_| is_case)
}

/// What is said before a case.
const CASES: [&str; 13] =
    ["for", "when", "if", "the", "at", "let", "with", "where", "put", "take", "case", "critical", "limiting"];

/// How the sign of a scalar product stands before a vector: `(2i + 5j).(i - j)`, `u_A·(1, -1)`.
const SCALAR_PRODUCTS: [&str; 7] = [".(", " . (", "·(", "· (", "•(", "• (", "⋅("];

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
        members.extend(sides.into_iter().map(|expr| Member {
            statement: place,
            label: typed.clone(),
            letter: letter.clone(),
            expr,
            is_given,
            multiple: multiple.clone(),
        }));
    }
    ReadLine { printed: reading.printed, equations, members, statements: reading.statements, is_guessed: false }
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
