//! Digits into numbers: decimal points and commas, thousands, recurring decimals, powers of ten.

use super::Unreadable;
use super::around::{equals_letters, has_operation};
use super::characters::{CLOSE, Glyph, OPEN, RECURS};
use super::choices::{Choices, Doubt};
use crate::expr::Expr;
use crate::number::{Fraction, Letter};

/// The most digits that a number may have; nobody writes more.
const MOST_DIGITS: usize = 30;

/// The highest power of ten that is read.
const HIGHEST_POWER: i32 = 20;

/// The glyphs with letter O between or beside digits as nought, and with an I or l before a point or a digit, or above a
/// stroke, as one.
///
/// Between digits other letters are left as they are, and are found to make no sense.
pub(super) fn repaired(glyphs: &[Glyph], letters: &[Letter], choices: &mut Choices) -> Vec<Glyph> {
    let mut out = glyphs.to_vec();
    // `I2 = 28` is an impulse, and beside a J the I is **i**.
    let may_be_name = glyphs.iter().any(|glyph| matches!(glyph.sign, '=' | 'J' | 'j'));
    for at in 0..out.len() {
        let before = at.checked_sub(1).map_or(' ', |before| out[before].sign);
        let sign = |ahead: usize| glyphs.get(at + ahead).map_or(' ', |glyph| glyph.sign);
        let number_after = sign(1).is_ascii_digit() || (sign(1) == '.' && sign(2).is_ascii_digit());
        let is_letter = |sign: char| letters.iter().any(|letter| letter.name().starts_with(sign));
        match out[at].sign {
            'O' if !is_letter('O')
                && !before.is_alphabetic()
                && before != '_'
                && (before.is_ascii_digit()
                    || (before == '.' && at > 1 && out[at - 2].sign.is_ascii_digit())
                    || number_after)
                && (!sign(1).is_alphabetic() || sign(1) == 'O') =>
            {
                out[at].sign = '0';
                choices.note(|| "letter O read as 0".to_owned());
            }
            letter @ ('I' | 'l')
                if !is_letter(letter)
                    && (sign(1) == '.' || !may_be_name && matches!(sign(1), '/' | '0'..='9'))
                    && (sign(1).is_ascii_digit() || sign(2).is_ascii_digit())
                    && !before.is_alphanumeric()
                    && !matches!(before, '.' | ',' | '_' | '^') =>
            {
                out[at].sign = '1';
                choices.note(|| format!("letter {letter} read as 1"));
            }
            _ => {}
        }
    }
    out
}

/// The number that begins at `at`, and its length in glyphs.
pub(super) fn number(
    glyphs: &[Glyph],
    at: usize,
    depth: usize,
    letters: &[Letter],
    choices: &mut Choices,
) -> Result<(Expr, usize), Unreadable> {
    let mut reader = Digits { glyphs, start: at, at, whole: String::new(), decimals: None, marks: Vec::new() };
    reader.whole_part(depth, choices);
    reader.decimal_part(depth, choices)?;
    if reader.whole.len() + reader.decimals.as_ref().map_or(0, String::len) > MOST_DIGITS {
        return Err(reader.fault(format!("a number of more than {MOST_DIGITS} digits")));
    }
    let recurring = reader.recurring(choices)?;
    let value = match recurring {
        Some(value) => value,
        None => reader.plain(),
    };
    let value = reader.power_of_ten(value, letters, choices)?;
    Ok((value, reader.at - at))
}

struct Digits<'a> {
    glyphs: &'a [Glyph],
    start: usize,
    at: usize,
    whole: String,
    decimals: Option<String>,
    /// Which decimals have a dot.
    marks: Vec<usize>,
}

impl Digits<'_> {
    fn sign(&self, ahead: usize) -> char {
        self.glyphs.get(self.at + ahead).map_or(' ', |glyph| glyph.sign)
    }

    fn place(&self) -> usize {
        self.glyphs[self.start].place
    }

    fn fault(&self, message: impl Into<String>) -> Unreadable {
        Unreadable::Sign(self.place(), message.into())
    }

    /// How many digits stand from so many glyphs ahead.
    fn run(&self, ahead: usize) -> usize {
        (ahead..).take_while(|ahead| self.sign(*ahead).is_ascii_digit()).count()
    }

    fn take(&mut self, count: usize) -> String {
        let digits = self.glyphs[self.at..self.at + count].iter().map(|glyph| glyph.sign).collect();
        self.at += count;
        digits
    }

    fn typed(&self) -> String {
        self.glyphs[self.start..self.at].iter().map(|glyph| glyph.sign).collect()
    }

    /// The digits before the point, thousands set apart included.
    fn whole_part(&mut self, depth: usize, choices: &mut Choices) {
        let count = self.run(0);
        self.whole = self.take(count);
        let leads = (1..=3).contains(&count) && !self.whole.starts_with('0') && depth == 0;
        if leads && self.sign(0) == ' ' && self.run(1) == 3 && !self.after_group(4) {
            while self.sign(0) == ' ' && self.run(1) == 3 && !self.after_group(4) {
                self.at += 1;
                let group = self.take(3);
                self.whole.push_str(&group);
            }
            choices.note(|| format!("{} read as {}", self.typed(), self.whole));
        } else if leads && self.sign(0) == ',' && self.run(1) == 3 && self.sign(4) != '.' {
            let single = self.sign(4) != ',' || self.run(5) == 0;
            let place = self.place();
            if single && choices.otherwise(Doubt::Comma, place) {
                return;
            }
            while self.sign(0) == ',' && self.run(1) == 3 {
                self.at += 1;
                let group = self.take(3);
                self.whole.push_str(&group);
            }
            choices.note(|| format!("{} read as {}", self.typed(), self.whole));
        } else if leads && self.sign(0) == ',' && self.run(1) == 3 {
            // `1,234.5` has its point still to come.
            self.at += 1;
            let group = self.take(3);
            self.whole.push_str(&group);
        }
    }

    /// Does what follows a group of three digits belong to the number too?
    fn after_group(&self, ahead: usize) -> bool {
        self.sign(ahead) == '/' || (self.sign(ahead) == '.' && self.sign(ahead + 1).is_ascii_digit())
    }

    fn decimal_part(&mut self, depth: usize, choices: &mut Choices) -> Result<(), Unreadable> {
        let place = self.place();
        let digit_after = self.sign(1).is_ascii_digit() || (self.sign(1) == '(' && self.sign(0) == '.');
        let raised = self.sign(0) == '·' && digit_after;
        // `4·39^½` is rather a product than a power of a decimal, `3·10cos α` may be one of a mass and a component, and so may
        // be what stands in `6·15 = 6v + 3w`; `0·75` is none, and `½·4·36` can be nothing else.
        let after = 1 + self.run(1);
        let is_resolved =
            || ["cos", "sin"].iter().any(|name| name.chars().zip(after..).all(|(own, at)| self.sign(at) == own));
        let is_likely =
            || self.run(1) == 1 || self.sign(after) == '^' || is_resolved() || has_operation(self.glyphs, self.at);
        let may_multiply = raised && !matches!(&*self.whole, "" | "0") && is_likely();
        let is_raised = |sign: char| matches!(sign, '·' | '⋅');
        let follows = self.start > 0 && is_raised(self.glyphs[self.start - 1].sign);
        let is_chain = follows || is_raised(self.sign(after)) && self.sign(after + 1).is_ascii_digit();
        let point = self.sign(0) == '.' && digit_after
            || raised && (!may_multiply || choices.otherwise(Doubt::RaisedPoint, place) == is_chain)
            || self.sign(0) == '⋅' && digit_after && choices.otherwise(Doubt::RaisedPoint, place);
        let comma = self.sign(0) == ',' && self.sign(1).is_ascii_digit() && self.comma_is_decimal(depth, choices);
        if !point && !comma {
            return Ok(());
        }
        self.at += 1;
        let mut decimals = String::new();
        loop {
            match self.sign(0) {
                digit if digit.is_ascii_digit() => decimals.push(digit),
                RECURS if !decimals.is_empty() => self.marks.push(decimals.len() - 1),
                _ => break,
            }
            self.at += 1;
        }
        let two = |digits: &Digits| digits.sign(0) == '.' && digits.sign(1).is_ascii_digit();
        if two(self) || (comma && self.sign(0) == ',' && self.sign(1).is_ascii_digit()) {
            return Err(self.fault("a number with two decimal points"));
        }
        self.decimals = Some(decimals);
        if comma {
            let read = self.plain();
            choices.note(|| format!("{} read as {}", self.typed(), crate::expr::print::unicode(&read)));
        }
        Ok(())
    }

    /// `2,78` alone is a decimal; in `(4,1)` and `1,2,3` and beside decimal points a comma parts two values.
    fn comma_is_decimal(&self, depth: usize, choices: &mut Choices) -> bool {
        let count = self.run(1);
        let before = self.start.checked_sub(1).map_or(' ', |before| self.glyphs[before].sign);
        let after = self.sign(1 + count);
        let list = before == ',' || (after == ',' && self.sign(2 + count).is_ascii_digit());
        let near = self.start.saturating_sub(60).max(1)..(self.at + 60).min(self.glyphs.len().saturating_sub(1));
        let points = near.into_iter().any(|at| {
            let digit = |at: usize| self.glyphs[at].sign.is_ascii_digit();
            self.glyphs[at].sign == '.' && digit(at + 1) && digit(at - 1)
        });
        if depth > 0 || list || points || after == '/' {
            return false;
        }
        // `3,1` might be two values; nobody would take `3,08` for them.
        count != 1 || after.is_alphabetic() || self.whole == "0" || !choices.otherwise(Doubt::Comma, self.place())
    }

    /// The number as it stands.
    fn plain(&self) -> Expr {
        let whole = if self.whole.is_empty() { "0" } else { &self.whole };
        match &self.decimals {
            Some(decimals) => Expr::Decimal(format!("{whole}.{decimals}")),
            None => Expr::Number(whole.parse().unwrap_or(Fraction::ZERO)),
        }
    }

    /// `0.3̇`, `0.3̇6̇`, `0.(36)`, `0.3636…`
    fn recurring(&mut self, choices: &mut Choices) -> Result<Option<Expr>, Unreadable> {
        let Some(decimals) = self.decimals.clone() else { return Ok(None) };
        if let (Some(first), Some(last)) = (self.marks.first(), self.marks.last()) {
            if last + 1 != decimals.len() {
                return Err(self.fault("digits after the recurring ones"));
            }
            return Ok(Some(self.repeating(&decimals[..*first], &decimals[*first..])));
        }
        if self.sign(0) == '(' && self.run(1) > 0 && self.sign(1 + self.run(1)) == ')' {
            let place = self.place();
            let product_first = !decimals.is_empty() && self.stands_in_arithmetic();
            if !decimals.is_empty() && choices.otherwise(Doubt::Recurring, place) != product_first {
                if product_first {
                    let block: String =
                        self.glyphs[self.at..self.at + 2 + self.run(1)].iter().map(|g| g.sign).collect();
                    choices.note(|| format!("{}{block} read as a product", self.typed()));
                }
                return Ok(None);
            }
            self.at += 1;
            let count = self.run(0);
            let block = self.take(count);
            self.at += 1;
            if block.len() + decimals.len() > MOST_DIGITS {
                return Err(self.fault("too many recurring digits"));
            }
            let value = self.repeating(&decimals, &block);
            choices.note(|| format!("{} read as {}", self.typed(), crate::expr::print::unicode(&value)));
            return Ok(Some(value));
        }
        // Two points or three, after which no digit follows.
        let points = (0..3).take_while(|ahead| self.sign(*ahead) == '.').count();
        let points = if points >= 2 && !self.sign(points).is_ascii_digit() { points } else { 0 };
        if self.sign(0) != '…' && points == 0 {
            return Ok(None);
        }
        self.at += points.max(1);
        let place = self.place();
        let (before, block, times) = match decimals.len() {
            // `0.6...` is two thirds, for nobody breaks off so early.
            1 => ("", decimals.as_str(), 2),
            _ => repeated(&decimals),
        };
        // `7.2111…` may be 2√13 on a calculator.
        let is_open = block.len() == 1 && (times == 2 || !before.is_empty());
        if times < 2 || (is_open && choices.otherwise(Doubt::Recurring, place)) {
            return Ok(None);
        }
        let value = self.repeating(before, block);
        choices.note(|| format!("{} read as {}", self.typed(), crate::expr::print::unicode(&value)));
        Ok(Some(value))
    }

    /// `0.5(9) - 0.5(4)`: beside other terms and factors a bracket is a factor, too.
    fn stands_in_arithmetic(&self) -> bool {
        let signs = |at: usize| self.glyphs.get(at).map(|glyph| glyph.sign);
        let is_blank = |at: &usize| signs(*at) == Some(' ');
        let close = self.at + 1 + self.run(1);
        let after = (close + 1..self.glyphs.len()).find(|at| !is_blank(at)).and_then(signs);
        let mut before = (0..self.start).rev().filter(|at| !is_blank(at)).map_while(signs);
        let is_operation =
            |sign: char| matches!(sign, '+' | '-' | '*' | '/' | '÷' | '⋅' | '·' | '(' | '[' | '√' | OPEN);
        let is_term = |sign: char| sign.is_alphanumeric() || matches!(sign, ')' | ']' | CLOSE);
        let joined = match before.next() {
            Some('+' | '-') => before.next().is_some_and(is_term),
            Some(sign) => matches!(sign, '*' | '/' | '÷' | '⋅' | '·' | '√' | ')' | CLOSE),
            None => false,
        };
        joined || after.is_some_and(is_operation) || equals_letters(self.glyphs)
    }

    /// The fraction of a whole part, decimals that do not recur and a block that does.
    fn repeating(&self, before: &str, block: &str) -> Expr {
        let whole = if self.whole.is_empty() { "0" } else { &self.whole };
        recurring_value(whole, before, block)
    }

    /// `3e2`: three hundred, unless the question has a letter e.
    fn power_of_ten(&mut self, value: Expr, letters: &[Letter], choices: &mut Choices) -> Result<Expr, Unreadable> {
        let sign = self.sign(0);
        let signed = usize::from(matches!(self.sign(1), '+' | '-'));
        let count = self.run(1 + signed);
        let ends = !self.sign(1 + signed + count).is_alphanumeric();
        if !matches!(sign, 'e' | 'E') || count == 0 || count > 4 || !ends {
            return Ok(value);
        }
        let has_e = letters.iter().any(|letter| letter.name() == "e");
        if has_e {
            // A phone writes the letter as a capital, too: `2E-1`.
            let sensible = signed == 0 || matches!(value, Expr::Decimal(_));
            if !sensible || choices.otherwise(Doubt::TenToThe, self.place()) == (sign == 'E') {
                return Ok(value);
            }
        }
        let exponent: String = self.glyphs[self.at + 1..self.at + 1 + signed + count].iter().map(|g| g.sign).collect();
        self.at += 1 + signed + count;
        let power = exponent.trim_start_matches('+').parse().unwrap_or(i32::MAX);
        let value = times_power_of_ten(&value, power).ok_or_else(|| self.fault("the power of ten is too high"))?;
        choices.note(|| format!("{} read as {}", self.typed(), crate::expr::print::unicode(&value)));
        Ok(value)
    }
}

/// The fraction of `whole.before` with `block` repeated for ever.
pub(super) fn recurring_value(whole: &str, before: &str, block: &str) -> Expr {
    let parse = |digits: &str| digits.parse::<Fraction>().unwrap_or(Fraction::ZERO);
    let ten = |count: usize| parse(&format!("1{}", "0".repeat(count)));
    let nines = parse(&"9".repeat(block.len()));
    let fixed = &parse(&format!("0{before}")) + &(&parse(block) * &nines.reciprocal().unwrap_or(Fraction::ZERO));
    let scaled = &fixed * &ten(before.len()).reciprocal().unwrap_or(Fraction::ZERO);
    Expr::Number(&parse(whole) + &scaled)
}

/// Decimals as what comes before, the shortest block that ends them at least twice, and how often it stands there.
pub(super) fn repeated(decimals: &str) -> (&str, &str, usize) {
    for length in 1..=decimals.len() / 2 {
        let (mut rest, block) = decimals.split_at(decimals.len() - length);
        let mut times = 1;
        while let Some(shorter) = rest.strip_suffix(block) {
            rest = shorter;
            times += 1;
        }
        if times >= 2 {
            return (rest, block, times);
        }
    }
    (decimals, "", 0)
}

/// A number times a power of ten, with the digits that it was written with.
pub(super) fn times_power_of_ten(value: &Expr, power: i32) -> Option<Expr> {
    if power.abs() > HIGHEST_POWER {
        return None;
    }
    let (digits, mut point) = match value {
        Expr::Number(number) if number.is_integer() => (number.to_string(), 0),
        Expr::Decimal(text) => {
            let (whole, decimals) = text.split_once('.')?;
            (format!("{whole}{decimals}"), i32::try_from(decimals.len()).ok()?)
        }
        _ => return None,
    };
    point -= power;
    if point <= 0 {
        let zeros = "0".repeat(usize::try_from(-point).ok()?);
        return Some(Expr::Number(format!("{digits}{zeros}").parse().ok()?));
    }
    let point = usize::try_from(point).ok()?;
    let padded = format!("{}{digits}", "0".repeat((point + 1).saturating_sub(digits.len())));
    let (whole, decimals) = padded.split_at(padded.len() - point);
    let whole = whole.trim_start_matches('0');
    Some(Expr::Decimal(format!("{}.{decimals}", if whole.is_empty() { "0" } else { whole })))
}
