//! Lines by their equation, `y = -3x + 2` or `3x + y = 0`, by all multiples of a vector, `λ(i - 3j)`, and by a vector across them.
//!
//! What is read of each is its gradient. A line along **j** has none and goes to a person.

use super::characters::{CLOSE, OPEN};
use super::choices::Choices;
use super::grammar::Parser;
use super::names;
use super::statements::Statements;
use super::tokens::{Placed, Token};
use super::vectors::rational;
use super::{Form, Said, Statement, Unreadable, Vocabulary};
use crate::expr::Expr;
use crate::number::{Letter, Range};

/// Letters that stand for any constant in the equation of a line, where the question does not have them.
const CONSTANTS: [&str; 3] = ["c", "k", "d"];

impl Statements<'_> {
    /// `λ(2i - j)`: every vector along a line.
    pub(super) fn any_multiple(&mut self, tokens: &[Placed]) -> Result<Option<Said>, Unreadable> {
        let Some(vector) = of_any_multiple(tokens, self.vocabulary) else { return Ok(None) };
        let place = tokens[0].start;
        self.multiplier = Some(tokens[0].token.clone());
        let gradient = match self.side(vector)? {
            Expr::Vector(x, y) => along(&x, &y),
            _ => None,
        };
        let Some(gradient) = gradient else {
            return Err(Unreadable::Sign(place, "a multiple of what is no vector, or of one along j".to_owned()));
        };
        Ok(Some(Said { form: Form::Gradient(gradient), unit: None, reference: None, remarks: Vec::new() }))
    }

    /// Where a condition on it begins: `k(i - 3j) for k ≠ 0`.
    pub(super) fn condition_of_multiplier(&self, tokens: &[Placed]) -> Option<usize> {
        let leads = |placed: &Placed| {
            matches!(placed.token, Token::Phrase(_))
                && self.slice(std::slice::from_ref(placed)).eq_ignore_ascii_case("for")
        };
        let at = tokens.iter().position(leads)?;
        let (multiple, condition) = tokens.split_at(at);
        of_any_multiple(multiple, self.vocabulary)?;
        let is_of_it = |placed: &Placed| {
            placed.token == multiple[0].token
                || matches!(&placed.token, Token::Phrase(_) | Token::Sign('≠' | '>' | '<'))
                || placed.token == Token::Number(Expr::integer(0))
        };
        condition.iter().all(is_of_it).then_some(at)
    }

    /// `k(i - 3j), k ≠ 0`: what is said of the letter by which a vector is multiplied leaves the line as it is.
    pub(super) fn is_of_multiplier(&self, sides: &[&[Placed]], relations: &[(char, usize)]) -> bool {
        let ([[letter], [nought]], [(sign, _)]) = (sides, relations) else { return false };
        self.multiplier.as_ref() == Some(&letter.token)
            && nought.token == Token::Number(Expr::integer(0))
            && matches!(sign, '≠' | '>' | '<')
    }
}

/// `5x + 4y = 21, y - x = 3, so x = 1`: two equations that are not of one line, or one beside a value of x or y.
pub(super) fn are_unknowns(lines: &[Expr], statements: &[Statement]) -> bool {
    let is_value = |statement: &Statement| {
        let label = statement.label.as_ref().is_some_and(|label| matches!(&*label.typed, "x" | "y"));
        label && statement.said.iter().any(|said| matches!(said.form, Form::Value(_)))
    };
    let Some((first, others)) = lines.split_first() else { return false };
    others.iter().any(|other| other != first) || statements.iter().any(is_value)
}

/// The gradient of the line with this equation, where x and y are coordinates and no letters of the question.
pub(super) fn gradient(left: &[Placed], right: &[Placed], text: &str, vocabulary: &Vocabulary) -> Option<Expr> {
    let named = |name: &str| vocabulary.letters.iter().any(|letter| letter.name() == name);
    if !vocabulary.vectors || named("x") || named("y") {
        return None;
    }
    let constants = CONSTANTS.into_iter().filter(|name| !named(name));
    let own = ["x", "y"].into_iter().chain(constants).map(|name| Letter::new(name, Range::Real));
    let letters = vocabulary.letters.iter().copied().map(Some).chain(own).collect::<Option<Vec<Letter>>>()?;
    let vocabulary = Vocabulary { letters, vectors: false };
    let mut choices = Choices::default();
    let mut side = |tokens: &[Placed]| {
        let mut parser = Parser::new(tokens.to_vec(), text, &vocabulary, &mut choices);
        parser.sum().ok().filter(|_| parser.at == parser.end)
    };
    // Left minus right is nought on the line.
    let difference = Expr::Sum(vec![side(left)?, side(right)?.negated()]);
    let [across, up] = ["x", "y"].map(|letter| slope(&difference, letter));
    let (across, up) = (across?, up?);
    let has_name = |expr: &Expr, names: &[&str]| expr.names().iter().any(|name| names.contains(&name.text.as_str()));
    let is_linear = [&across, &up].into_iter().all(|slope| !has_name(slope, &["x", "y", "c", "k", "d"]));
    if !is_linear {
        return None;
    }
    quotient(across, up).map(Expr::negated)
}

/// One over the other, as a number if it is one; `None` over nought.
fn quotient(above: Expr, below: Expr) -> Option<Expr> {
    if below.is_zero() {
        return None;
    }
    let exact = rational(&above).zip(rational(&below).and_then(|below| below.reciprocal()));
    Some(exact.map_or_else(|| above.over(below), |(above, share)| Expr::Number(&above * &share)))
}

/// `λ(2i - j)`, `±(2i - j)`, `±1/√5(2i - j)`: the tokens of the vector, where any multiple of it is said.
pub(super) fn of_any_multiple<'t>(tokens: &'t [Placed], vocabulary: &Vocabulary) -> Option<&'t [Placed]> {
    if let [sign, of_one_sign @ ..] = tokens
        && sign.is('±')
        && vocabulary.vectors
        && is_bracketed_once(of_one_sign)
    {
        return Some(of_one_sign);
    }
    let [factor, open, inside @ .., close] = tokens else { return None };
    let is_parameter = match &factor.token {
        Token::Sign(sign) => *sign == '±',
        Token::Greek(name) => names::letter(name, vocabulary).is_none(),
        Token::Word(name) => {
            name.len() == 1 && "abcdkrstpqn".contains(name.as_str()) && names::letter(name, vocabulary).is_none()
        }
        _ => false,
    };
    let is_bracketed = open.is('(') && close.is(')') && !inside.iter().any(|placed| placed.is('(') || placed.is(')'));
    // `k(1, -3)`
    let is_pair = inside.iter().any(|placed| placed.is(','));
    let vector = if is_pair { &tokens[1..] } else { inside };
    (is_parameter && is_bracketed && vocabulary.vectors).then_some(vector)
}

/// Does it all belong to one vector in brackets and the number by which it is multiplied or divided?
fn is_bracketed_once(tokens: &[Placed]) -> bool {
    let is_unit = |placed: &Placed| matches!(&placed.token, Token::Word(word) if matches!(word.as_str(), "i" | "j"));
    let first = tokens.iter().position(is_unit);
    let open = first.and_then(|first| tokens[..first].iter().rposition(|placed| placed.is('(')));
    let close = first.and_then(|first| Some(first + tokens[first..].iter().position(|placed| placed.is(')'))?));
    open.zip(close).is_some_and(|(open, close)| tokens[..open].iter().chain(&tokens[close..]).all(is_of_factor))
}

/// Can it stand in the number by which a vector is multiplied?
fn is_of_factor(placed: &Placed) -> bool {
    match placed.token {
        Token::Number(_) | Token::Root { .. } => true,
        Token::Sign(sign) => matches!(sign, '(' | ')' | '/' | '*' | OPEN | CLOSE),
        _ => false,
    }
}

/// The gradient of the line along a vector.
pub(super) fn along(x: &Expr, y: &Expr) -> Option<Expr> {
    quotient(y.clone(), x.clone())
}

/// The remark on a line that is told by a vector to which it is perpendicular.
pub(crate) const ACROSS: &str = "across the vector";

/// The gradient of the line perpendicular to a vector.
pub(super) fn across(x: &Expr, y: &Expr) -> Option<Expr> {
    quotient(x.clone(), y.clone()).map(Expr::negated)
}

/// What a letter is multiplied by in a formula that is linear in it; `None` if it is not, or the letter is not there.
fn slope(expr: &Expr, letter: &str) -> Option<Expr> {
    let has = |expr: &Expr| expr.names().iter().any(|name| name.text == letter);
    match expr {
        Expr::Name(name) if name.text == letter => Some(Expr::integer(1)),
        Expr::Negative(inner) => Some(slope(inner, letter)?.negated()),
        Expr::Sum(terms) => {
            let with: Vec<Expr> =
                terms.iter().filter(|term| has(term)).map(|term| slope(term, letter)).collect::<Option<_>>()?;
            (!with.is_empty()).then(|| Expr::sum(with))
        }
        Expr::Product(factors) => {
            let (with, without): (Vec<&Expr>, Vec<&Expr>) = factors.iter().partition(|factor| has(factor));
            let [one] = with.as_slice() else { return None };
            Some(Expr::product(without.into_iter().cloned().chain([slope(one, letter)?])))
        }
        Expr::Quotient(above, below) if !has(below) => Some(slope(above, letter)?.over((**below).clone())),
        _ => None,
    }
}
