//! Words that stand for signs: `times`, `over`, `is equal to`, `greater than`.

use super::Vocabulary;
use super::characters::{CLOSE, OPEN};
use super::choices::{Choices, Doubt};
use super::degrees;
use super::digits::{recurring_value, repeated};
use super::lexicon::{BEFORE_A_NUMBER, SIGNS, Sort, sort};
use super::names;
use super::number_words::{added_fraction, number_in_words};
use super::tokens::{Placed, Token};
use super::units::is_unit_word;
use super::wording::NOTHING_OF;
use crate::expr::Expr;

/// Words after which two bars say that something is parallel to a line.
const LINES: [&str; 7] = ["to", "the", "line", "loc", "ab", "ba", "tangent"];

/// With so many decimals it is not the last figure alone that recurs.
const SURELY_ROUNDED: usize = 6;

/// The block with which decimals begin and go on, to the last of them: `714285` of `7142857`.
fn period(decimals: &str) -> &str {
    let goes_on = |length: &usize| decimals.bytes().skip(*length).eq(decimals.bytes().take(decimals.len() - length));
    let length = (1..decimals.len()).find(goes_on).unwrap_or(decimals.len());
    &decimals[..length]
}

/// The tokens with words for signs as those signs; `square root` is one root.
pub(super) fn with_signs(tokens: &[Placed], vocabulary: &Vocabulary, choices: &mut Choices) -> Vec<Placed> {
    let word = |at: usize| match tokens.get(at).map(|placed| &placed.token) {
        Some(Token::Word(word)) => Some(word.as_str()),
        _ => None,
    };
    let is = |at: usize, wanted: &str| word(at).is_some_and(|word| word.eq_ignore_ascii_case(wanted));
    let mut out: Vec<Placed> = Vec::with_capacity(tokens.len());
    let mut at = 0;
    while let Some(placed) = tokens.get(at) {
        // The token after the words, between which a hyphen may stand.
        let stands = |words: &str| {
            words.split(' ').try_fold(at, |next, wanted| {
                let hyphen = tokens.get(next).is_some_and(|sign| next > at && sign.is('-') && !sign.spaced);
                let next = next + usize::from(hyphen);
                is(next, wanted).then_some(next + 1)
            })
        };
        // Most of an answer is no word, and most words begin otherwise.
        let standing = word(at).and_then(|word| {
            let initial = word.bytes().next().map(|byte| byte.to_ascii_lowercase());
            let begins = |words: &str| words.bytes().next() == initial;
            // `above 1/3`, `above a third`
            let is_number = matches!(tokens.get(at + 1).map(|next| &next.token), Some(Token::Number(_)))
                || BEFORE_A_NUMBER.iter().any(|(words, _)| words.eq_ignore_ascii_case(word))
                    && at + 1 < tokens.len()
                    && number_in_words(&[], tokens, at + 1, vocabulary).is_some();
            // `over 0.6`, `anything over 0.6`, with nothing above it.
            let is_below = |words: &str| words != "over" || out.iter().all(says_nothing);
            let before_number = BEFORE_A_NUMBER.iter().filter(|(words, _)| is_number && is_below(words));
            // `k is positive`, `k positive`; in `1/2 (must be positive)` nobody says what, and `take positive` says it of a value.
            let after_name = matches!(out.last().map(|last| &last.token), Some(Token::Word(_) | Token::Greek(_)));
            let after_letter = match out.last().map(|last| &last.token) {
                Some(Token::Word(name)) => name.len() == 1 && names::is_made_of_letters(name, vocabulary),
                _ => false,
            };
            let fits = |words: &str, signs: &str| match words {
                "positive" => after_letter,
                _ => after_name || !signs.ends_with('0'),
            };
            let standing =
                SIGNS.iter().chain(before_number).filter(|(words, signs)| begins(words) && fits(words, signs));
            standing.filter_map(|(words, signs)| Some((stands(words)?, signs))).max_by_key(|(next, _)| *next)
        });
        // `0.3 recurring`, `0.3 (recurring)`: the last digit recurs.
        let is_sign = |at: usize, sign: char| tokens.get(at).is_some_and(|placed| placed.is(sign));
        let bracket = usize::from(is_sign(at + 1, '(') && is_sign(at + 3, ')'));
        if let Token::Number(Expr::Decimal(digits)) = &placed.token
            && let Some((whole, decimals)) = digits.split_once('.').filter(|(_, decimals)| !decimals.is_empty())
            && ["recurring", "recurs", "rec"].iter().any(|recurs| is(at + 1 + bracket, recurs))
        {
            let (before, block, times) = repeated(decimals);
            let is_long = decimals.len() >= SURELY_ROUNDED;
            let token = if times > 1 {
                Token::Number(recurring_value(whole, before, block))
            } else if !is_long {
                // `0.36 recurring`: the last figure, or both; of `0.318 recurring` the last, all, or the last two.
                let all = decimals.len() > 1 && choices.otherwise(Doubt::Recurring, placed.start);
                let two = !all && decimals.len() > 2 && choices.otherwise(Doubt::Recurring, placed.end);
                let length = if all { decimals.len() } else { 1 + usize::from(two) };
                let (before, block) = decimals.split_at(decimals.len() - length);
                Token::Number(recurring_value(whole, before, block))
            } else if choices.otherwise(Doubt::Recurring, placed.start) {
                // It goes on as a calculator's number does.
                placed.token.clone()
            } else {
                Token::Number(recurring_value(whole, "", period(decimals)))
            };
            at += 2 * (1 + bracket);
            out.push(Placed { token, end: tokens[at - 1].end, ..placed.clone() });
            continue;
        }
        // `// to the line of centres`, `|| LOC`
        let bars = usize::from(is_sign(at, '¦')) + 2 * usize::from(is_sign(at, '|') && is_sign(at + 1, '|'));
        if bars > 0 && LINES.iter().any(|line| is(at + bars, line)) {
            let word = |word: &str| Placed { token: Token::Word(word.to_owned()), ..placed.clone() };
            out.push(word("parallel"));
            out.extend((!is(at + bars, "to")).then(|| word("to")));
            at += bars;
            continue;
        }
        if is(at, "to") && matches!(out.last(), Some(Placed { token: Token::Word(before), .. }) if before == "to") {
            at += 1;
            continue;
        }
        let in_words = number_in_words(&out, tokens, at, vocabulary);
        if let Some((number, next)) = in_words.or_else(|| added_fraction(&out, tokens, at, vocabulary, choices)) {
            out.extend(number);
            at = next;
            continue;
        }
        // `f in [0, 3/4]`, `f is in [0, 3/4]`, `f lies in the interval [0, 3/4]`
        let is_letter = match out.as_slice() {
            [Placed { token: Token::Word(_) | Token::Greek(_), .. }, rest @ ..] => match rest {
                [] => true,
                [Placed { token: Token::Word(is), .. }] => matches!(is.as_str(), "is" | "lies"),
                _ => false,
            },
            _ => false,
        };
        let the = at + 1 + usize::from(is(at + 1, "the"));
        let bracket = if is(the, "interval") || is(the, "range") { the + 1 } else { at + 1 };
        let opens = is_sign(bracket, '[') || is_sign(bracket, '(');
        if is(at, "in") && is_letter && opens && tokens[at..].iter().any(|placed| placed.is(',')) {
            out.truncate(1);
            out.push(Placed { token: Token::Sign('∈'), ..placed.clone() });
            at = bracket;
            continue;
        }
        // `u - eu all over 2`; of `u - eu over 2` it is not said how much stands above.
        let ends_a_side =
            |placed: &Placed| matches!(placed.token, Token::Sign('=' | '≈' | ',' | ';' | ':' | '\n' | '⇒'));
        let start = out.iter().rposition(ends_a_side).map_or(0, |before| before + 1);
        let says_all = is(at, "all") && is(at + 1, "over");
        let may_be_all = || is(at, "over") && is_sum(&out[start..]);
        if says_all || may_be_all() && choices.otherwise(Doubt::Over, placed.start) {
            let place = |token| Placed { token: Token::Sign(token), ..placed.clone() };
            out.insert(start, place(OPEN));
            out.extend([place(CLOSE), place('/')]);
            at += 1 + usize::from(says_all);
            continue;
        }
        // `no energy is lost`: nought is.
        let is_none_of = is(at, "no") && NOTHING_OF.iter().any(|lost| is(at + 1, lost));
        if is_none_of && out.last().is_none_or(|last| matches!(&last.token, Token::Word(word) if word == "has")) {
            out.push(Placed { token: Token::Number(Expr::integer(0)), ..placed.clone() });
            at += 1;
            continue;
        }
        // `3-to-4`, `the x-axis`
        let is_hyphen = |at: usize| is_sign(at, '-') && !tokens[at].spaced;
        let is_of_unit = at > 0 && ["i", "j", "x", "y"].iter().any(|unit| is(at - 1, unit));
        if is_hyphen(at) && (is(at + 1, "axis") || is_of_unit && is(at + 1, "direction")) {
            at += 1;
            continue;
        }
        if degrees::joins_minutes(tokens, at) {
            at += 1;
            continue;
        }
        if let Some(sign) = degrees::in_brackets(tokens, at) {
            out.push(sign.clone());
            at += 3;
            continue;
        }
        // `2.√13`: a point before a root is no decimal point.
        let root_next = matches!(tokens.get(at + 1).map(|next| &next.token), Some(Token::Root { .. }));
        let after_number = matches!(out.last().map(|last| &last.token), Some(Token::Number(_)));
        if is_sign(at, '.') && !placed.spaced && after_number && (root_next || is(at + 1, "root")) {
            out.push(Placed { token: Token::Sign('*'), ..placed.clone() });
            at += 1;
            continue;
        }
        // `k = 4 (positive root)`: which of two roots it is, and not what stands under one.
        if is(at, "positive") && is(at + 1, "root") && !begins_a_root(tokens.get(at + 2)) {
            let word = |word: &str| Placed { token: Token::Word(word.to_owned()), ..placed.clone() };
            out.extend([word("positive"), Placed { spaced: true, ..word("only") }]);
            at += 2;
            continue;
        }
        if is_hyphen(at) && is(at + 1, "to") && is_hyphen(at + 2) {
            out.push(tokens[at + 1].clone());
            at += 3;
            continue;
        }
        // `metres a second`
        let is_rate = ["a", "each", "every"].iter().any(|word| is(at, word)) && is(at + 1, "second");
        if is_rate && matches!(out.last(), Some(Placed { token: Token::Word(unit), .. }) if is_unit_word(unit)) {
            out.push(Placed { token: Token::Word("per".to_owned()), ..placed.clone() });
            at += 1;
            continue;
        }
        // `2 times the square root of 13`
        if is(at, "the") && (is(at + 1, "root") || is(at + 2, "root")) && out.last().is_some_and(|last| last.is('*')) {
            at += 1;
            continue;
        }
        // `4.03x10-3`: the exponent has lost its height.
        if lowered_exponent(tokens, at) && !choices.otherwise(Doubt::TenToThe, placed.start) {
            choices.note(|| "10-n read as a power of ten".to_owned());
            out.push(Placed { token: Token::Sign('^'), ..placed.clone() });
        }
        // `5/18 of mu²`, `130% of v`
        if is(at, "of") && is_share(&out) && tokens.get(at + 1).is_some_and(|next| is_factor(next, vocabulary)) {
            if out.last().is_some_and(|last| last.is('%')) {
                out.pop();
                out.push(Placed { token: Token::Sign('/'), ..placed.clone() });
                out.push(Placed { token: Token::Number(Expr::integer(100)), ..placed.clone() });
            }
            out.push(Placed { token: Token::Sign('*'), ..placed.clone() });
            at += 1;
            continue;
        }
        let Some((next, signs)) = standing else {
            out.push(placed.clone());
            at += 1;
            continue;
        };
        let end = tokens[next - 1].end;
        let mut put = |token, spaced| out.push(Placed { token, start: placed.start, end, spaced });
        if signs.starts_with(char::is_alphabetic) {
            put(Token::Word((*signs).to_owned()), placed.spaced);
        } else {
            for (place, sign) in signs.chars().enumerate() {
                let token = match sign.to_digit(10) {
                    Some(digit) => Token::Number(Expr::integer(i64::from(digit))),
                    None if matches!(sign, '√' | '∛') => Token::Root { cube: sign == '∛' },
                    None => Token::Sign(sign),
                };
                put(token, placed.spaced && place == 0);
            }
        }
        at = next;
    }
    with_fractions_below(out)
}

/// Does the exponent of a power of ten stand here, though it is not written as one: the `-3` of `4.03x10-3`?
fn lowered_exponent(tokens: &[Placed], at: usize) -> bool {
    let Some([mantissa, times, ten, minus, exponent]) = at.checked_sub(3).and_then(|from| tokens.get(from..at + 2))
    else {
        return false;
    };
    let is_mantissa = matches!(&mantissa.token, Token::Number(Expr::Decimal(digits))
        if digits.as_bytes().get(1) == Some(&b'.') && !digits.starts_with('0'));
    let is_times = times.is('*') || matches!(&times.token, Token::Word(word) if word.eq_ignore_ascii_case("x"));
    let is_exponent = matches!(&exponent.token, Token::Number(Expr::Number(power)) if power.is_integer());
    let ends = tokens.get(at + 2).is_none_or(|next| match &next.token {
        Token::Word(_) => next.spaced,
        Token::Sign(sign) => matches!(sign, ',' | ';' | '.' | '\n' | '=' | '≈' | '⇒'),
        _ => false,
    });
    is_mantissa
        && is_times
        && ten.token == Token::Number(Expr::integer(10))
        && minus.is('-')
        && !minus.spaced
        && is_exponent
        && !exponent.spaced
        && ends
}

/// Is it a word that neither is a value nor names one?
fn says_nothing(placed: &Placed) -> bool {
    matches!(&placed.token, Token::Word(word) if sort(&word.to_lowercase()) == Some(Sort::Plain) && word.len() > 1)
}

/// Does a fraction, a decimal or a percentage end here, of which something may be taken?
fn is_share(tokens: &[Placed]) -> bool {
    match tokens {
        [.., number, percent] if percent.is('%') => matches!(number.token, Token::Number(_)),
        [.., stroke, last] if stroke.is('/') => matches!(last.token, Token::Number(_)),
        [.., last] => last.is(CLOSE) || matches!(last.token, Token::Number(Expr::Decimal(_))),
        [] => false,
    }
}

/// Does what stands under a root begin here, or is it told of what it is the root?
fn begins_a_root(next: Option<&Placed>) -> bool {
    next.is_some_and(|next| match &next.token {
        Token::Word(word) => word == "of",
        Token::Sign(sign) => matches!(sign, '(' | '[' | '{') || *sign == OPEN,
        _ => true,
    })
}

/// Is something added or taken off, outside brackets?
fn is_sum(tokens: &[Placed]) -> bool {
    let mut depth = 0_i32;
    tokens.iter().skip(1).any(|placed| {
        depth += i32::from(placed.is('(') || placed.is(OPEN)) - i32::from(placed.is(')') || placed.is(CLOSE));
        depth == 0 && (placed.is('+') || placed.is('-'))
    })
}

/// Does a formula begin with it?
fn is_factor(placed: &Placed, vocabulary: &Vocabulary) -> bool {
    match &placed.token {
        Token::Word(word) => names::is_made_of_letters(word, vocabulary),
        Token::Greek(name) => names::letter(name, vocabulary).is_some(),
        Token::Number(_) | Token::Root { .. } => true,
        Token::Sign(sign) => matches!(*sign, '(' | OPEN),
        _ => false,
    }
}

/// `5/16 ÷ 5/12` as `5/16 / (5/12)`: what is divided by with the sign of division is the whole fraction after it.
fn with_fractions_below(tokens: Vec<Placed>) -> Vec<Placed> {
    if !tokens.iter().any(|placed| placed.is('÷')) {
        return tokens;
    }
    let mut out: Vec<Placed> = Vec::with_capacity(tokens.len());
    let mut open_until = None;
    for (at, placed) in tokens.iter().enumerate() {
        if open_until == Some(at) {
            out.push(Placed { token: Token::Sign(CLOSE), start: placed.start, end: placed.start, spaced: false });
            open_until = None;
        }
        if !placed.is('÷') {
            out.push(placed.clone());
            continue;
        }
        out.push(Placed { token: Token::Sign('/'), ..placed.clone() });
        let length = fraction_length(&tokens[at + 1..]);
        if length > 0 {
            out.push(Placed { token: Token::Sign(OPEN), start: placed.end, end: placed.end, spaced: false });
            open_until = Some(at + 1 + length);
        }
    }
    if let (Some(_), Some(end)) = (open_until, out.last().map(|last| last.end)) {
        out.push(Placed { token: Token::Sign(CLOSE), start: end, end, spaced: false });
    }
    out
}

/// How many tokens the fraction with a stroke takes that begins here; a unit after it is none of it.
fn fraction_length(tokens: &[Placed]) -> usize {
    let mut depth = 0_usize;
    let mut stroke = false;
    for (at, placed) in tokens.iter().enumerate() {
        match placed.token {
            Token::Sign('(' | '[' | '{' | OPEN) => depth += 1,
            Token::Sign(')' | ']' | '}' | CLOSE) if depth > 0 => depth -= 1,
            _ if depth > 0 => {}
            Token::Sign('/') => stroke = true,
            Token::Sign('^' | '.') => {}
            Token::Sign('-') if at == 0 => {}
            Token::Word(_) if stroke && placed.spaced => return at,
            Token::Sign(_) => return if stroke { at } else { 0 },
            _ => {}
        }
    }
    if stroke { tokens.len() } else { 0 }
}
