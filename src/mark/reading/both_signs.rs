//! Both roots, between which somebody chooses: `v = ±2√2, v > 0 so v = 2√2`.

use super::phrases::Phrase;
use super::tokens::{Placed, Token};

/// `±8, k > 0` is `8 or -8, k > 0`; where nothing follows, nobody has chosen, and both signs stay.
pub(super) fn with_both_signs(mut tokens: Vec<Placed>) -> Vec<Placed> {
    let mut from = 0;
    while let Some(sign) = tokens[from..].iter().position(|placed| placed.is('±')).map(|at| from + at) {
        let end = sign + 1 + tokens[sign + 1..].iter().take_while(|placed| !ends_value(placed)).count();
        let begins = sign == 0 || tokens[sign - 1].is('=') || ends_value(&tokens[sign - 1]);
        if begins && end > sign + 1 && end < tokens.len() {
            let with = |token: Token| Placed { token, ..tokens[sign].clone() };
            let value = &tokens[sign + 1..end];
            let other = [&[with(Token::Phrase(Phrase::Or)), with(Token::Sign('-'))], value].concat();
            tokens.splice(end..end, other);
            tokens.remove(sign);
        }
        from = end;
    }
    tokens
}

/// Does it stand after a value, and is no part of it?
fn ends_value(placed: &Placed) -> bool {
    matches!(placed.token, Token::Sign(',' | ';' | '\n' | '⇒') | Token::Phrase(_))
}
