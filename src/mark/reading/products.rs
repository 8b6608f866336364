//! Products: what is written side by side, what stands below a stroke, and where a unit begins.

use super::characters::{CLOSE, OPEN};
use super::choices::Doubt;
use super::digits::times_power_of_ten;
use super::grammar::{Parsed, Parser};
use super::names;
use super::tokens::{Placed, Token, excerpt};
use crate::expr::{Expr, print};

/// What stands before a factor.
#[derive(Clone, Copy, PartialEq)]
enum Sign {
    Times,
    Over,
    Beside,
}

/// A factor and the tokens between which it stands.
struct Factor {
    sign: Sign,
    value: Expr,
    start: usize,
    end: usize,
    spaced: bool,
    bracket: bool,
}

impl Parser<'_> {
    /// Factors with their signs.
    pub(super) fn product(&mut self) -> Parsed {
        let mut factors = vec![self.one_factor(Sign::Times)?];
        loop {
            self.choices.step(self.place())?;
            let next = match self.sign(0) {
                Some('*') if self.degrees_follow() => {
                    self.at += 2;
                    if let Some(last) = factors.last_mut() {
                        last.value = Expr::degrees(last.value.clone());
                        last.end = self.at;
                    }
                    continue;
                }
                Some('*') => Sign::Times,
                Some('/') => Sign::Over,
                _ if self.times_in_words() => Sign::Times,
                _ if self.continues() => Sign::Beside,
                _ => break,
            };
            if next != Sign::Beside {
                self.at += 1;
            }
            factors.push(self.one_factor(next)?);
        }
        self.folded(factors)
    }

    fn one_factor(&mut self, sign: Sign) -> Result<Factor, super::Unreadable> {
        let start = self.at;
        let spaced = self.spaced(0);
        let bracket = matches!(self.sign(0), Some('(' | '[' | '{' | OPEN));
        let value = if sign == Sign::Beside { self.nested(Self::factor)? } else { self.signed_factor()? };
        Ok(Factor { sign, value, start, end: self.at, spaced, bracket })
    }

    /// `10*deg`
    fn degrees_follow(&self) -> bool {
        self.sign(1) == Some('°') && self.sign(2) != Some('^')
    }

    /// `2 x 3`: an x between numbers, where the question has none.
    fn times_in_words(&self) -> bool {
        let x = matches!(self.token(0), Some(Token::Word(word)) if word.eq_ignore_ascii_case("x"));
        let number = matches!(self.token(1), Some(Token::Number(_) | Token::Root { .. } | Token::Sign('(' | OPEN)));
        let factor =
            matches!(self.token(1), Some(Token::Word(word)) if names::is_made_of_letters(word, self.vocabulary));
        x && (number || factor) && names::letter("x", self.vocabulary).is_none() && self.at > 0
    }

    /// Does a factor follow that is written side by side with the one before?
    pub(super) fn continues(&mut self) -> bool {
        match self.token(0) {
            Some(Token::Word(_) | Token::Greek(_)) => self.word_continues(),
            Some(Token::Function(_) | Token::Reciprocal(_) | Token::Root { .. } | Token::Pi) => true,
            Some(Token::Letter(_) | Token::Along(_)) => true,
            Some(Token::Sign('(' | '[' | '{')) => {
                !(self.outside() && (self.is_unit_in_brackets() || self.repeats_the_value()))
            }
            Some(Token::Sign(OPEN)) => true,
            Some(Token::Sign('|')) => !self.in_bars(),
            // The digit of a vulgar fraction stands in a group; any other number needs a sign.
            Some(Token::Number(_)) => {
                self.is_multiplied_by_a_fraction()
                    || self.is_close_after_brackets()
                    || (self.is_after_a_root() || self.is_after_a_product()) && self.is_fraction(0)
                    || self.is_square_in_energy()
            }
            _ => false,
        }
    }

    /// `(4/9)39^(1/2)`: a number close behind brackets, in which more stands than the number of an equation.
    fn is_close_after_brackets(&self) -> bool {
        let Some(open) = self.at.checked_sub(3) else { return false };
        self.tokens[self.at - 1].is(')') && !self.spaced(0) && !self.tokens[open].is('(')
    }

    /// Does a product of letters end here, the `eu` of `eu 3/5`? Of one letter alone a fraction may be the value.
    fn is_after_a_product(&self) -> bool {
        let before = |back: usize| self.at.checked_sub(back).map(|at| &self.tokens[at]);
        let is_letter = |placed: &Placed| matches!(placed.token, Token::Letter(_));
        let is_factor = |placed: &Placed| is_letter(placed) || matches!(placed.token, Token::Number(_));
        before(1).is_some_and(|last| is_letter(last) && !last.spaced) && before(2).is_some_and(is_factor)
    }

    /// `½m18`: behind the half and the mass of a kinetic energy a number is the square of a speed.
    fn is_square_in_energy(&self) -> bool {
        let before = |back: usize| self.at.checked_sub(back).map(|at| &self.tokens[at].token);
        let is_number = |back: usize, own: i64| matches!(before(back), Some(Token::Number(number)) if *number == Expr::integer(own));
        let is_mass = matches!(before(1), Some(Token::Letter(letter)) if letter == "m");
        let is_group =
            before(2) == Some(&Token::Sign(CLOSE)) && is_number(3, 2) && before(4) == Some(&Token::Sign('/'));
        let is_typed = is_number(2, 2) && before(3) == Some(&Token::Sign('/')) && is_number(4, 1);
        is_mass && (is_group && is_number(5, 1) || is_typed)
    }

    /// Does a root end here: `√39`, `√(39)`?
    fn is_after_a_root(&self) -> bool {
        let is_root = |at: usize| matches!(self.tokens[at].token, Token::Root { .. });
        match self.at.checked_sub(2).map(|root| (root, &self.tokens[self.at - 1].token)) {
            Some((root, Token::Number(_))) => is_root(root),
            Some((inner, Token::Sign(')'))) => {
                let open = self.tokens[..=inner].iter().rposition(|placed| placed.is('(') || placed.is(')'));
                open.is_some_and(|open| self.tokens[open].is('(') && open > 0 && is_root(open - 1))
            }
            _ => false,
        }
    }

    /// A fraction in figures after a blank: the `4/9` of `√39 4/9`.
    pub(super) fn is_fraction(&self, ahead: usize) -> bool {
        let is_whole = |ahead: usize| matches!(self.token(ahead), Some(Token::Number(Expr::Number(number))) if number.is_integer());
        let is_close = !self.spaced(ahead + 1) && !self.spaced(ahead + 2);
        let ends = !matches!(self.sign(ahead + 3), Some('^' | '.' | '/'));
        is_whole(ahead)
            && self.spaced(ahead)
            && self.sign(ahead + 1) == Some('/')
            && is_whole(ahead + 2)
            && is_close
            && ends
    }

    /// `1/3 4cos30`: a fraction in figures, a blank, and a number that has its own factor close behind it. A number
    /// alone would be another answer.
    fn is_multiplied_by_a_fraction(&self) -> bool {
        let whole = |back: usize| {
            let token = self.at.checked_sub(back).and_then(|at| self.tokens.get(at));
            token.is_some_and(
                |placed| matches!(&placed.token, Token::Number(Expr::Number(number)) if number.is_integer()),
            )
        };
        // `½6m`: a fraction of digits in a group, which is no mixed number.
        let signs = |back: usize| self.at.checked_sub(back).map(|at| &self.tokens[at].token);
        let grouped = signs(1) == Some(&Token::Sign(CLOSE))
            && signs(3) == Some(&Token::Sign('/'))
            && signs(5) == Some(&Token::Sign(OPEN))
            && whole(2)
            && whole(4);
        let stroke = self.at >= 2 && matches!(self.tokens[self.at - 2].token, Token::Sign('/'));
        let factor = match self.token(1) {
            Some(Token::Function(_) | Token::Reciprocal(_) | Token::Root { .. } | Token::Sign('(')) => true,
            Some(Token::Word(word)) => names::is_made_of_letters(word, self.vocabulary),
            _ => false,
        };
        // `½ 3 (2² - 1²)`: of a kinetic energy the mass and the bracket may stand apart.
        let is_close = !self.spaced(1) || grouped && self.sign(1) == Some('(');
        (grouped || stroke && whole(1) && whole(3) && self.spaced(0)) && factor && is_close
    }

    /// `2 (m)`: a unit, or a letter of the question if it stands close by.
    fn is_unit_in_brackets(&mut self) -> bool {
        let Some((_, next)) = self.unit_here() else { return false };
        let is_letter = match self.token(1) {
            Some(Token::Word(word)) => next == self.at + 3 && names::letter(word, self.vocabulary).is_some(),
            _ => false,
        };
        let place = self.place();
        !is_letter || (self.choices.otherwise(Doubt::Unit, place) != self.spaced(0))
    }

    /// `25/7 (3.57)`: a blank, and in brackets at the end a decimal, which says the same again.
    fn repeats_the_value(&self) -> bool {
        let decimal = matches!(self.token(1), Some(Token::Number(Expr::Decimal(_))));
        let is_product = self.choices.is_flipped(Doubt::SaidAgain, self.place());
        self.spaced(0) && decimal && self.sign(2) == Some(')') && self.token(3).is_none() && !is_product
    }

    /// A word side by side is letters of the question, or a unit, or both one after the other: `9mJ`.
    fn word_continues(&mut self) -> bool {
        let Some(Token::Word(word)) = self.token(0).cloned() else { return true };
        let letters = names::is_made_of_letters(&word, self.vocabulary);
        let unit = if self.outside() { self.unit_here() } else { None };
        match (&unit, letters) {
            (None, true) => true,
            (Some((_, next)), true) => {
                // A unit of several symbols is hardly a product; a symbol alone is a letter.
                let several = word.len() > 1 || *next > self.at + 1;
                let place = self.place();
                !several || self.choices.otherwise(Doubt::Unit, place)
            }
            (Some(_), false) => {
                let place = self.place();
                let split = self.letters_before_a_unit(&word);
                // `ms^-1` is a unit through and through, `mJ` is m and a joule where the question has an m.
                match split.filter(|_| !matches!(word.as_str(), "ms" | "mps")) {
                    Some(length) if !self.choices.otherwise(Doubt::Unit, place) => {
                        self.part_word(length);
                        true
                    }
                    _ => false,
                }
            }
            (None, false) => match self.outside().then(|| self.letters_before_a_unit(&word)).flatten() {
                Some(length) => {
                    self.part_word(length);
                    true
                }
                None => self.any_name,
            },
        }
    }

    /// Parts a word of letters of the question and a unit after them. `false` if it is none.
    pub(super) fn part_before_a_unit(&mut self) -> bool {
        let Some(Token::Word(word)) = self.token(0).cloned() else { return false };
        let length = if self.outside() { self.letters_before_a_unit(&word) } else { None };
        length.inspect(|length| self.part_word(*length)).is_some()
    }

    /// How many letters of the question stand at the beginning of a word whose rest is a unit.
    fn letters_before_a_unit(&mut self, word: &str) -> Option<usize> {
        let placed = self.tokens[self.at].clone();
        let at = self.at;
        let mut found = None;
        for length in 1..word.len().min(24) {
            let (Some(front), Some(back)) = (word.get(..length), word.get(length..)) else { continue };
            if !names::is_made_of_letters(front, self.vocabulary) {
                continue;
            }
            let start = (placed.start + length).min(placed.end);
            self.tokens[at] = Placed { token: Token::Word(back.to_owned()), start, end: placed.end, spaced: false };
            if self.unit_here().is_some() {
                found = Some(length);
                break;
            }
        }
        self.tokens[at] = placed;
        found
    }

    /// Parts the next word in two.
    fn part_word(&mut self, length: usize) {
        let Placed { token, start, end, spaced } = self.tokens[self.at].clone();
        let Token::Word(word) = token else { return };
        let between = (start + length).min(end);
        let (front, back) = word.split_at(length);
        let front = Placed { token: Token::Word(front.to_owned()), start, end: between, spaced };
        let back = Placed { token: Token::Word(back.to_owned()), start: between, end, spaced: false };
        self.tokens.splice(self.at..=self.at, [front, back]);
        self.end += 1;
    }

    /// The factors multiplied and divided, each stroke with as much below it as is likely, or otherwise.
    fn folded(&mut self, factors: Vec<Factor>) -> Parsed {
        let first = factors[0].start;
        let mut factors = factors.into_iter().peekable();
        let mut value: Option<Expr> = None;
        // Is the product that has been collected one of this walk, to which a factor can be added?
        let mut open = false;
        while let Some(factor) = factors.next() {
            if factor.sign != Sign::Over {
                let below = value.take();
                (value, open) = match below {
                    None => (Some(factor.value), false),
                    Some(left) => (Some(multiplied(left, factor.value, open)), true),
                };
                continue;
            }
            let above = value.take().unwrap_or_else(|| Expr::integer(1));
            let mut beside = Vec::new();
            while factors.peek().is_some_and(|next| next.sign == Sign::Beside) {
                beside.extend(factors.next());
            }
            if beside.is_empty() {
                value = Some(over(above, factor.value));
                open = false;
                continue;
            }
            let below = self.all_below(&above, &factor, &beside);
            let end = beside.last().map_or(factor.end, |last| last.end);
            let rest = beside.into_iter().map(|factor| factor.value);
            let result = match below {
                true => over(above, rest.fold(factor.value, times)),
                false => rest.fold(over(above, factor.value), times),
            };
            let typed = self.tokens.get(first).zip(self.tokens.get(end - 1));
            let typed = typed.map_or("", |(first, last)| excerpt(self.text, first.start, last.end));
            self.choices.note(|| format!("{typed} read as {}", print::unicode(&result)));
            value = Some(result);
            open = false;
        }
        Ok(value.unwrap_or_else(|| Expr::integer(1)))
    }

    /// Does everything side by side after a stroke stand below it? In `u/2v` it does, in `1/2 v` it does not.
    fn all_below(&mut self, above: &Expr, below: &Factor, beside: &[Factor]) -> bool {
        // Nothing can be divided by a vector.
        if beside.iter().any(|factor| has_vector(&factor.value)) {
            return false;
        }
        let number = |expr: &Expr| matches!(expr, Expr::Number(_) | Expr::Decimal(_));
        let is_fraction = number(above) && number(&below.value);
        // `3/7 √3`: nobody leaves a blank within what he divides by.
        if is_fraction && beside[0].spaced && !below.spaced {
            return false;
        }
        let coefficient = is_fraction || below.bracket || beside[0].bracket || (beside[0].spaced && !below.spaced);
        let place = self.tokens.get(below.start).map_or(0, |placed| placed.start);
        coefficient == self.choices.otherwise(Doubt::Stroke, place)
    }
}

/// A factor at the end of a product, or a power of ten taken into the number before it.
fn multiplied(left: Expr, right: Expr, open: bool) -> Expr {
    if let Expr::Power(base, exponent) = &right
        && **base == Expr::integer(10)
        && let Some(power) = whole(exponent)
        && let Some(number) = times_power_of_ten(&left, power)
    {
        return number;
    }
    match left {
        Expr::Product(mut factors) if open => {
            factors.push(right);
            Expr::Product(factors)
        }
        other => times(other, right),
    }
}

fn whole(exponent: &Expr) -> Option<i32> {
    match exponent {
        Expr::Number(value) => match value.as_small()? {
            (power, 1) => i32::try_from(power).ok(),
            _ => None,
        },
        Expr::Negative(inner) => whole(inner).map(|power| -power),
        _ => None,
    }
}

fn times(left: Expr, right: Expr) -> Expr {
    match left {
        Expr::Product(mut factors) => {
            factors.push(right);
            Expr::Product(factors)
        }
        other => Expr::Product(vec![other, right]),
    }
}

/// A quotient; two whole numbers make a fraction as they were written.
fn over(above: Expr, below: Expr) -> Expr {
    Expr::Quotient(Box::new(above), Box::new(below))
}

/// Is there a vector in it?
fn has_vector(expr: &Expr) -> bool {
    match expr {
        Expr::Vector(..) => true,
        Expr::Name(name) => matches!(name.text.as_str(), "i" | "j"),
        Expr::Call(..) => false,
        other => other.children().into_iter().any(has_vector),
    }
}
