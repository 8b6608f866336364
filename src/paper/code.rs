//! The code of a sheet: its questions and their numbers in a few characters that can be typed again.
//!
//! A code holds content and no state of a generator. Each question is its place in the bank, and its numbers are their
//! place in the finite set of the style; both are digits of one large number, whose bases the bank gives. Below them stands
//! a digest of all that is printed and asked, by which a bank that has been edited since is noticed, and last a check
//! digit, by which a slip of the fingers is.

use std::fmt;

use dashu_int::{UBig, ops::DivRem};

use super::{KeyQuestion, PrintedQuestion};
use crate::bank::{Contents, Heading, Question};
use crate::expr::print;
use crate::generate::{Variant, examine, reference};

/// Digits and letters without I, L, O and U, of which the first three are read as 1, 1 and 0.
const DIGITS: &[u8; 32] = b"0123456789ABCDEFGHJKMNPQRSTVWXYZ";

/// A code with more characters than this nobody types.
const LONGEST: usize = 40;

/// The bits of the digest in a code that holds the sheet: an edited bank goes unnoticed once in a million times.
const DIGEST: usize = 20;

/// The bits of the digest in a code that only names a sheet.
const NAME: usize = 30;

/// The code of a sheet.
///
/// ```
/// use carom::paper::SheetCode;
/// let code = SheetCode::read("Ok7v 3qx-4").unwrap();
/// assert_eq!(code.to_string(), "0K7V-3QX4");
/// assert!(SheetCode::read("0K7V-3Q4X").unwrap_err().to_string().contains("mistyped"));
/// ```
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct SheetCode {
    /// The places of its characters among the digits, the check digit last. The first is nought if it only names the sheet.
    digits: Vec<u8>,
}

/// Why a code is no code, or leads to no sheet.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum CodeFault {
    /// A character that stands in no code.
    Character(char),
    /// Too few characters.
    Short,
    /// Too many.
    Long,
    /// The check digit does not agree.
    Mistyped,
    /// It names a sheet of too many questions and does not hold them.
    NamesOnly,
    /// In this bank it leads to another sheet, or to none.
    OtherBank,
}

impl SheetCode {
    /// Reads a code as a person types it: capital or small, with hyphens and blanks or without, O for 0 and I or L for 1.
    ///
    /// # Errors
    ///
    /// What is no code. Every code with one character wrong, and every one with two neighbours exchanged, is found out.
    pub fn read(text: &str) -> Result<SheetCode, CodeFault> {
        let mut digits = Vec::new();
        for letter in text.chars().filter(|c| !c.is_whitespace() && !matches!(c, '-' | '‐' | '‑' | '–')) {
            let meant = match letter.to_ascii_uppercase() {
                'O' => '0',
                'I' | 'L' => '1',
                other => other,
            };
            let place = DIGITS.iter().position(|digit| char::from(*digit) == meant);
            digits.push(place.ok_or(CodeFault::Character(letter))? as u8);
        }
        match digits.len() {
            0..6 => Err(CodeFault::Short),
            beyond if beyond > LONGEST => Err(CodeFault::Long),
            _ if checked(&digits) != 0 => Err(CodeFault::Mistyped),
            _ => Ok(SheetCode { digits }),
        }
    }

    /// The code of questions with their numbers, as they are printed and keyed; of a sheet that is too long, its name.
    pub(super) fn of(contents: &Contents, sheet: &[(&Question, &Variant)], digest: u64) -> SheetCode {
        let held = held(contents, sheet).map(|held| (held << DIGEST) + folded(digest, DIGEST));
        let digits = held.map(|number| digits(&number)).filter(|digits| digits.len() < LONGEST);
        let mut digits = digits.unwrap_or_else(|| {
            let mut named = digits_of_name(folded(digest, NAME));
            named.insert(0, 0);
            named
        });
        digits.push(times_two(checked(&digits)));
        SheetCode { digits }
    }

    /// Does it hold the sheet, or only name it?
    pub fn holds_the_sheet(&self) -> bool {
        self.digits.first() != Some(&0)
    }

    /// The questions and numbers that it holds, in a bank that may have been edited: see [`Sheet::from_code`].
    ///
    /// [`Sheet::from_code`]: super::Sheet::from_code
    pub(super) fn open(&self, contents: &Contents) -> Result<Vec<(Question, Variant)>, CodeFault> {
        if !self.holds_the_sheet() {
            return Err(CodeFault::NamesOnly);
        }
        let data = &self.digits[..self.digits.len() - 1];
        let number = data.iter().fold(UBig::ZERO, |number, digit| (number << 5) + *digit);
        let (mut rest, kind) = (number >> DIGEST).div_rem(&UBig::from(2u8));
        let is_reference = kind.is_one();
        let mut opened = Vec::new();
        while !rest.is_zero() {
            let place = take(&mut rest, contents.headings.len() as u64 + 1).checked_sub(1);
            let heading = place.and_then(|place| contents.headings.get(place as usize));
            let question = heading.and_then(|heading: &Heading| heading.question().ok()).ok_or(CodeFault::OtherBank)?;
            let variant = if is_reference {
                reference(&question).ok()
            } else {
                let slot = take(&mut rest, slots(&question));
                numbered(&question, slot)
            };
            opened.push((question, variant.ok_or(CodeFault::OtherBank)?));
        }
        Ok(opened)
    }
}

/// The questions and numbers as one number: in the lowest place the kind, above it for each question its place in the bank,
/// counted from 1 so that the end shows, and the place of its numbers. `None` if a question is not of this bank.
fn held(contents: &Contents, sheet: &[(&Question, &Variant)]) -> Option<UBig> {
    let is_reference = sheet.iter().all(|(_, variant)| variant.index.is_none());
    let mut number = UBig::ZERO;
    for (question, variant) in sheet.iter().rev() {
        let place = contents.headings.iter().position(|heading| heading.id == question.id)? as u64;
        if !is_reference {
            number = number * slots(question) + slot(question, variant)?;
        }
        number = number * (contents.headings.len() as u64 + 1) + (place + 1);
    }
    Some(number * 2u8 + u8::from(is_reference))
}

/// How many sets of numbers a question has in all its styles.
fn slots(question: &Question) -> u64 {
    question.styles.iter().fold(0, |sum: u64, style| sum.saturating_add(style.size()))
}

/// The place of a variant among them.
fn slot(question: &Question, variant: &Variant) -> Option<u64> {
    let mut before = question.styles.iter().take_while(|style| style.name != variant.style);
    before.try_fold(variant.index?, |sum: u64, style| sum.checked_add(style.size()))
}

/// The variant at a place.
fn numbered(question: &Question, mut slot: u64) -> Option<Variant> {
    for style in &question.styles {
        match slot.checked_sub(style.size()) {
            Some(rest) => slot = rest,
            None => return examine(question, style, slot).ok(),
        }
    }
    None
}

/// Takes the lowest digit of a number in a base.
fn take(number: &mut UBig, base: u64) -> u64 {
    let (rest, digit) = (&*number).div_rem(&UBig::from(base.max(1)));
    *number = rest;
    u64::try_from(digit).unwrap_or_default()
}

/// A number in base 32, the highest digit first.
fn digits(number: &UBig) -> Vec<u8> {
    let mut rest = number.clone();
    let mut digits = Vec::new();
    while !rest.is_zero() {
        digits.push(take(&mut rest, 32) as u8);
    }
    digits.reverse();
    digits
}

/// As many digits for every name.
fn digits_of_name(digest: u64) -> Vec<u8> {
    (0..NAME / 5).rev().map(|place| (digest >> (5 * place)) as u8 & 31).collect()
}

/// So many bits of a digest, all of it folded into them.
fn folded(digest: u64, bits: usize) -> u64 {
    let mask = (1 << bits) - 1;
    (digest ^ (digest >> bits) ^ (digest >> (2 * bits))) & mask
}

/// The characters as a polynomial over the field of 32 elements, at a place where neither one wrong coefficient nor two
/// neighbours exchanged leave its value as it was. Nought if the last character agrees.
fn checked(digits: &[u8]) -> u8 {
    // One in front, so that a nought lost or added there shows too.
    digits.iter().fold(1, |value, digit| times_two(value) ^ digit)
}

/// Twice an element of the field, whose elements are polynomials modulo x⁵ + x² + 1.
fn times_two(element: u8) -> u8 {
    (element << 1) ^ if element & 16 == 0 { 0 } else { 0b10_0101 }
}

/// A digest of what students see and markers decide by: FNV-1a, fixed for ever; no secret is kept with it.
pub(super) fn digest(printed: &[PrintedQuestion], keyed: &[KeyQuestion]) -> u64 {
    let mut digest: u64 = 0xcbf2_9ce4_8422_2325;
    let mut take = |text: &str| {
        for byte in text.bytes().chain([0]) {
            digest = (digest ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3);
        }
    };
    for (printed, keyed) in printed.iter().zip(keyed) {
        take(&keyed.id);
        printed.stem.iter().for_each(|text| take(&print::text_unicode(text)));
        keyed.parameters.iter().for_each(|(name, value)| take(&format!("{name}={value}")));
        for (printed, part) in printed.parts.iter().zip(&keyed.parts) {
            take(&part.label);
            take(&print::text_unicode(&printed.ask));
            for blank in &part.blanks {
                [&blank.name, &blank.kind, &blank.accept, &blank.unit].into_iter().for_each(|text| take(text));
                take(&format!("{} {}", blank.find, blank.exact));
            }
            for mark in &part.scheme {
                [&mark.code, &mark.earned_for].into_iter().chain(&mark.depends).for_each(|text| take(text));
            }
        }
    }
    digest
}

impl fmt::Display for SheetCode {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (place, digit) in self.digits.iter().enumerate() {
            if place > 0 && place % 4 == 0 {
                f.write_str("-")?;
            }
            write!(f, "{}", char::from(DIGITS[usize::from(*digit) % DIGITS.len()]))?;
        }
        Ok(())
    }
}

impl fmt::Display for CodeFault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            CodeFault::Character(letter) => write!(f, "no code has a `{}` in it", letter.escape_debug()),
            CodeFault::Short => f.write_str("too few characters for a code"),
            CodeFault::Long => f.write_str("too many characters for a code"),
            CodeFault::Mistyped => f.write_str("a character of the code is mistyped, or two are exchanged"),
            CodeFault::NamesOnly => {
                f.write_str("this code names a sheet of so many questions that it cannot hold them")
            }
            CodeFault::OtherBank => {
                f.write_str("in this bank the code leads to another sheet: the bank has been edited")
            }
        }
    }
}

impl CodeFault {
    /// One thing to try.
    pub fn help(&self) -> &'static str {
        match self {
            CodeFault::Character(_) | CodeFault::Short | CodeFault::Long => {
                "a code has 6 to 40 digits and letters: it stands below the heading of the sheet"
            }
            CodeFault::Mistyped => "compare it with the sheet, character by character",
            CodeFault::NamesOnly => "the `key.json` of the sheet holds them, and the seed in it makes the sheet again",
            CodeFault::OtherBank => {
                "name the bank from which it was printed, with `--bank`; the `key.json` of the sheet needs no bank"
            }
        }
    }
}
