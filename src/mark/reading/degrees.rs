//! Degrees with their minutes and seconds: `46°6′7″`, `46 degrees and 6 minutes`, and the sign in brackets, `46.1 (degrees)`.

use super::grammar::{Parsed, Parser};
use super::tokens::{Placed, Token};
use crate::expr::Expr;
use crate::number::{Fraction, Places, round};

/// The mark of a part of a degree, its words, how many of it make a degree, and to how many decimals it is measured: a
/// minute about as finely as two decimals are, a second as four.
const PARTS: [(char, &[&str], i64, u32); 2] =
    [('\'', &["min", "mins", "minute", "minutes"], 60, 2), ('"', &["sec", "secs", "second", "seconds"], 3600, 4)];

impl Parser<'_> {
    /// So many degrees, with what minutes and seconds of arc follow.
    pub(super) fn minutes(&mut self, degrees: Expr) -> Parsed {
        let Expr::Number(mut total) = degrees else { return Ok(self.in_degrees(degrees)) };
        let mut places = None;
        for (mark, words, share, decimals) in PARTS {
            if let Some((count, figures)) = self.token(0).and_then(count)
                && self.token(1).is_some_and(|token| is_part(token, mark, words))
            {
                // Of 60 minutes one more degree is made.
                if count >= Fraction::from(60) {
                    return self.fault("there are no more than 59 minutes or seconds");
                }
                total = &total + &(&count * &Fraction::new(1, share));
                places = Some(Places::DecimalPlaces(decimals + figures));
                self.at += 2;
            }
        }
        let rounded = places.map(|places| Expr::Decimal(round(&total, &places).to_string()));
        Ok(Expr::degrees(rounded.unwrap_or(Expr::Number(total))))
    }
}

/// A share of a second so small nobody measures.
const MOST_DECIMALS: u32 = 4;

/// A number, and how many decimals it has: `11.6` of `46°6′11.6″`.
fn count(token: &Token) -> Option<(Fraction, u32)> {
    match token {
        Token::Number(Expr::Number(count)) => Some((count.clone(), 0)),
        Token::Number(Expr::Decimal(typed)) => {
            let decimals = typed.split_once('.').map_or(0, |(_, decimals)| decimals.len());
            Some((typed.parse().ok()?, u32::try_from(decimals).ok().filter(|decimals| *decimals <= MOST_DECIMALS)?))
        }
        _ => None,
    }
}

fn is_part(token: &Token, mark: char, words: &[&str]) -> bool {
    match token {
        Token::Sign(sign) => *sign == mark,
        Token::Word(word) => words.contains(&&*word.to_ascii_lowercase()),
        _ => false,
    }
}

/// Does an `and` or a comma stand here, between degrees and their minutes or between minutes and seconds?
pub(super) fn joins_minutes(tokens: &[Placed], at: usize) -> bool {
    let Some([before, joint, number, part]) = at.checked_sub(1).and_then(|from| tokens.get(from..at + 3)) else {
        return false;
    };
    let is_joint = joint.is(',') || matches!(&joint.token, Token::Word(word) if word.eq_ignore_ascii_case("and"));
    let [minutes, seconds] = PARTS.map(|(mark, words, ..)| move |placed: &Placed| is_part(&placed.token, mark, words));
    is_joint && count(&number.token).is_some() && (before.is('°') && minutes(part) || minutes(before) && seconds(part))
}

/// The sign that stands alone in the brackets that open here: `46.1 (degrees)`.
pub(super) fn in_brackets(tokens: &[Placed], at: usize) -> Option<&Placed> {
    let before = tokens.get(at.checked_sub(1)?)?;
    let [open, degrees, close] = tokens.get(at..at + 3)? else { return None };
    let is_bracket = open.is('(') && close.is(')') || open.is('[') && close.is(']');
    (matches!(before.token, Token::Number(_)) && is_bracket && degrees.is('°')).then_some(degrees)
}
