//! Characters into tokens: numbers, names and signs, with the places where they stand.

use super::parser::TAKE_APART;
use crate::expr::fault::Fault;
use crate::expr::{Function, Relation, Span};

/// One token.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Token {
    /// Digits with at most one decimal point.
    Number(String),
    /// A letter or quantity.
    Name(String),
    /// A function by one of its names.
    Function(Function),
    /// `pi`
    Pi,
    /// `deg` or the degree sign.
    Degrees,
    /// A fraction written as one character.
    Vulgar(i64, i64),
    Plus,
    Minus,
    Times,
    Over,
    Power,
    /// The sign of the square root.
    Root,
    /// `(` or `[`
    Open(char),
    /// `)` or `]`
    Close(char),
    Comma,
    Relation(Relation),
}

/// A token, where it stands, and whether space stands before it.
#[derive(Clone, Debug)]
pub(super) struct Placed {
    pub token: Token,
    pub span: Span,
    pub spaced: bool,
}

/// The longest text that is read, in bytes.
const LONGEST: usize = 4_000;

/// Every token of the text.
pub(super) fn tokens(text: &str) -> Result<Vec<Placed>, Fault> {
    if text.len() > LONGEST {
        let span = Span { start: 0, end: 0 };
        return Err(Fault::new(
            format!("an expression of {} bytes", text.len()),
            span,
            format!("at most {LONGEST} bytes are read"),
        )
        .try_this(TAKE_APART));
    }
    let mut found = Vec::new();
    let mut at = 0;
    while at < text.len() {
        let rest = &text[at..];
        let first = rest.chars().next().unwrap_or_default();
        if first.is_whitespace() {
            at += first.len_utf8();
            continue;
        }
        let spaced = text[..at].ends_with(char::is_whitespace);
        let (token, length) = token(rest, first).ok_or_else(|| unknown(first, at))?;
        let span = Span { start: at, end: at + length };
        at += length;
        found.push(Placed { token, span, spaced });
        if let '²' | '³' = first {
            let digit = if first == '²' { "2" } else { "3" };
            found.push(Placed { token: Token::Number(digit.to_owned()), span, spaced: false });
        }
    }
    Ok(found)
}

/// The first token of a text that does not begin with space, and its length in bytes.
fn token(rest: &str, first: char) -> Option<(Token, usize)> {
    if first.is_ascii_digit() || (first == '.' && rest[1..].starts_with(|c: char| c.is_ascii_digit())) {
        let length = number_length(rest);
        return Some((Token::Number(rest[..length].to_owned()), length));
    }
    if first.is_ascii_alphabetic() {
        return Some(word(rest));
    }
    let two = |token| Some((token, 2));
    match rest.get(..2) {
        Some("**") => return two(Token::Power),
        Some("==") => return two(Token::Relation(Relation::Equal)),
        Some("!=") => return two(Token::Relation(Relation::NotEqual)),
        Some("<=") => return two(Token::Relation(Relation::LessOrEqual)),
        Some(">=") => return two(Token::Relation(Relation::GreaterOrEqual)),
        _ => {}
    }
    let token = match first {
        '+' => Token::Plus,
        '-' | '−' => Token::Minus,
        '*' | '×' | '·' => Token::Times,
        '/' | '÷' => Token::Over,
        '^' | '²' | '³' => Token::Power,
        '(' | '[' => Token::Open(first),
        ')' | ']' => Token::Close(first),
        ',' => Token::Comma,
        '=' => Token::Relation(Relation::Equal),
        '<' => Token::Relation(Relation::Less),
        '>' => Token::Relation(Relation::Greater),
        '≠' => Token::Relation(Relation::NotEqual),
        '≤' => Token::Relation(Relation::LessOrEqual),
        '≥' => Token::Relation(Relation::GreaterOrEqual),
        '√' => Token::Root,
        '°' => Token::Degrees,
        'π' => Token::Pi,
        '½' => Token::Vulgar(1, 2),
        '¼' => Token::Vulgar(1, 4),
        '¾' => Token::Vulgar(3, 4),
        '⅓' => Token::Vulgar(1, 3),
        '⅔' => Token::Vulgar(2, 3),
        _ => return greek(rest, first),
    };
    Some((token, first.len_utf8()))
}

/// A Greek letter, with a subscript if it has one: `θ`, `μ_1`.
fn greek(rest: &str, first: char) -> Option<(Token, usize)> {
    let name = match first {
        'α' => "alpha",
        'β' => "beta",
        'γ' => "gamma",
        'θ' => "theta",
        'λ' => "lambda",
        'μ' | 'µ' => "mu",
        'φ' => "phi",
        _ => return None,
    };
    let letter = first.len_utf8();
    let below = &rest[letter..];
    let length = below.find(|c: char| !c.is_ascii_alphanumeric() && c != '_').unwrap_or(below.len());
    let subscript = if below.starts_with('_') { &below[..length] } else { "" };
    Some((Token::Name(format!("{name}{subscript}")), letter + subscript.len()))
}

fn number_length(rest: &str) -> usize {
    let digits = |text: &str| text.bytes().take_while(u8::is_ascii_digit).count();
    let whole = digits(rest);
    match rest[whole..].strip_prefix('.') {
        Some(decimals) => whole + 1 + digits(decimals),
        None => whole,
    }
}

/// A name, function or constant.
fn word(rest: &str) -> (Token, usize) {
    let part = |text: &str| text.bytes().take_while(|c| c.is_ascii_alphanumeric() || *c == b'_').count();
    let letters = rest.bytes().take_while(u8::is_ascii_alphabetic).count();
    // `sin10` is the sine of ten; a quantity such as `e2` stays a name.
    if let Some(function) = function(&rest[..letters])
        && (rest[letters..].starts_with(|c: char| c.is_ascii_digit()) || part(rest) == letters)
    {
        return (Token::Function(function), letters);
    }
    let mut length = part(rest);
    while let Some(more) = rest[length..].strip_prefix('.').map(part).filter(|more| *more > 0) {
        length += 1 + more;
    }
    let token = match &rest[..length] {
        "pi" => Token::Pi,
        "deg" => Token::Degrees,
        name => Token::Name(name.to_owned()),
    };
    (token, length)
}

fn function(name: &str) -> Option<Function> {
    match name {
        "arcsin" => Some(Function::Asin),
        "arccos" => Some(Function::Acos),
        "arctan" => Some(Function::Atan),
        _ => Function::ALL.into_iter().find(|function| function.name() == name),
    }
}

fn unknown(found: char, at: usize) -> Fault {
    let span = Span { start: at, end: at + found.len_utf8() };
    let shown: String = if found.is_control() { found.escape_unicode().collect() } else { found.into() };
    let help = match found {
        '!' => "write `!=` for what is not equal",
        '|' => "write `abs(x)` for the size of x",
        '&' => "write two requirements for two that must both hold",
        '\\' | '$' => "write it without LaTeX: `sqrt(3)`, `alpha`, `1/2`",
        '%' => "write it as a decimal or a fraction: `0.3`, `3/10`",
        _ if found.is_alphabetic() => "write names with the letters from a to z",
        _ => "take it out: an expression has names, numbers, brackets and `+ - * / ^ = < >`",
    };
    Fault::new(format!("unknown character `{shown}`"), span, "not part of an expression").try_this(help)
}
