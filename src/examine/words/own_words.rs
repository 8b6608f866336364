//! Do the author's own words read well, whatever the numbers between them are: punctuation, doubled words, articles?

use std::collections::HashMap;
use std::sync::OnceLock;

use foldhash::fast::FixedState;

use super::agreement::disagreeing;
use super::exact_form::AsksExact;
use super::grammar::noun;
use super::misspelt::{meant, meant_after};
use super::sentences::{around, remark_at};
use super::truth::Claims;
use crate::examine::remark::Remark;
use crate::expr::{Expr, Piece, Text};
use crate::mechanics::Sphere;
use crate::paper::Words;

/// What has been said of texts that were looked at, and what they say: they are the same in every variant but for their
/// numbers, so each is looked at once.
#[derive(Clone, Debug, Default)]
pub struct Heard {
    texts: HashMap<String, Vec<Remark>, FixedState>,
    /// Room for the words that are looked up.
    words: String,
    claims: OnceLock<Claims>,
    exact: OnceLock<AsksExact>,
}

impl Heard {
    /// What the words say of the motion.
    pub(super) fn claims(&self, words: &Words) -> &Claims {
        self.claims.get_or_init(|| Claims::of(words))
    }

    /// Which of the words ask for exact form.
    pub(super) fn asks_exact(&self, words: &Words) -> &AsksExact {
        self.exact.get_or_init(|| AsksExact::of(words))
    }

    /// What does not read well in the words of a text, of which these are the pieces.
    pub(super) fn unreadable(&mut self, text: &Text, pieces: &[&Piece], remarks: &mut Vec<Remark>) {
        self.words.clear();
        self.words.extend(pieces.iter().map(|piece| match piece {
            Piece::Words(words) => words.as_str(),
            Piece::Formula(Expr::Name(name)) => name.text.as_str(),
            _ => "{}",
        }));
        match self.texts.get(&self.words) {
            Some(known) => remarks.extend_from_slice(known),
            None => {
                let found = looked_at(text, pieces);
                remarks.extend_from_slice(&found);
                self.texts.insert(self.words.clone(), found);
            }
        }
    }
}

fn looked_at(text: &Text, pieces: &[&Piece]) -> Vec<Remark> {
    let mut remarks = Vec::new();
    let mut before = "";
    for piece in pieces {
        if let Piece::Words(words) = piece {
            of_words(words, before, &mut remarks);
        }
        before = closing(piece);
    }
    pieces.windows(2).for_each(|pair| small_name(pair, &mut remarks));
    never_closed(pieces, &mut remarks);
    disagreeing(text, &mut remarks);
    remarks
}

/// A bracket that is opened in the words and never closed; a half-open interval closes with another.
fn never_closed(pieces: &[&Piece], remarks: &mut Vec<Remark>) {
    let mut open: Vec<String> = Vec::new();
    for words in pieces.iter().filter_map(|piece| if let Piece::Words(words) = piece { Some(words) } else { None }) {
        for (at, sign) in words.char_indices() {
            match sign {
                '(' => open.push(words[at..].split_whitespace().take(3).collect::<Vec<_>>().join(" ")),
                ')' | ']' => drop(open.pop()),
                _ => {}
            }
        }
    }
    if let Some(at) = open.first() {
        remarks.push(remark_at("a bracket that is never closed", at, at, "write `)` where it ends, or take it out"));
    }
}

/// `A sphere *a*`, which no other place of the question knows.
fn small_name(pair: &[&Piece], remarks: &mut Vec<Remark>) {
    const BODIES: [&str; 5] = ["sphere", "spheres", "particle", "ball", "disc"];
    let [Piece::Words(words), Piece::Formula(Expr::Name(name))] = pair else { return };
    let capital = name.text.to_uppercase();
    let is_body = words.ends_with(' ') && words.split_whitespace().last().is_some_and(|last| BODIES.contains(&last));
    if is_body && capital != name.text && Sphere::ALL.iter().any(|sphere| sphere.name() == capital) {
        let (at, help) = (format!("*{}*", name.text), format!("write `*{capital}*`"));
        remarks.push(remark_at("the name of a sphere in a small letter", &at, &name.text, &help));
    }
}

/// The sign with which a formula closes in the file.
fn closing(piece: &Piece) -> &'static str {
    match piece {
        Piece::Formula(Expr::Name(name)) if name.text.starts_with(|first: char| first.is_ascii_uppercase()) => "*",
        _ => "}",
    }
}

/// Words alone: punctuation and doubled words; `before` is the sign that stands before them in the file.
fn of_words(words: &str, before: &str, remarks: &mut Vec<Remark>) {
    for sign in [" .", " ,", " ;", "..", ",,", "( ", " )", "$", "\\", "*", "_", "{", "}", "`"] {
        if let Some(at) = words.find(sign).filter(|_| !words.contains("...")) {
            let place = around(words, at);
            // Signs alone stand everywhere; with what is before them they have a place.
            let place = match place.contains(char::is_alphanumeric) {
                true => place.to_owned(),
                false => format!("{before}{}", words[..at + sign.len()].trim_end()),
            };
            remarks.push(remark_at("a stray sign", &place, words.trim(), &format!("mend `{sign}`")));
        }
    }
    if let Some((at, tag)) = markup(words) {
        let help = "take it out: a text holds words, formulas in braces, and `*A*` for letters";
        remarks.push(remark_at("a sign of another language", around(words, at), tag, help));
    }
    for close in ["mark)", "marks)", "mark]", "marks]"] {
        let before = |at: usize| words[..at].trim_end().trim_end_matches(|sign: char| sign.is_ascii_digit());
        let is_count =
            |at: &usize| before(*at).ends_with(['(', '[']) && before(*at).len() < words[..*at].trim_end().len();
        if let Some(at) = words.find(close).filter(is_count) {
            let shown = &words[before(at).len() - 1..at + close.len()];
            let help = "take it out: the sheet prints how many rows `marks` has";
            remarks.push(remark_at("marks in words", shown, shown, help));
        }
    }
    for figure in ["significant figure", "decimal place"] {
        const SEVERAL: [&str; 8] = ["2", "3", "4", "5", "two", "three", "four", "five"];
        let is_alone = |at: usize| !words[at + figure.len()..].starts_with('s');
        let is_of_several =
            |at: usize| words[..at].split_whitespace().last().is_some_and(|count| SEVERAL.contains(&count));
        if let Some(at) = words.find(figure).filter(|at| is_alone(*at) && is_of_several(*at)) {
            remarks.push(remark_at("several of one", around(words, at), figure, "write the word in the plural"));
        }
    }
    let mut before = "";
    let mut at = 0;
    let mut all = words.split_whitespace().peekable();
    while let Some(word) = all.next() {
        at += words[at..].find(word).unwrap_or(0);
        // A letter alone may stand twice as the name of something; `a` as an article may not.
        let bare = word.trim_matches(|sign: char| sign.is_ascii_punctuation());
        let begins = before.is_empty() || before.ends_with(['.', ':', '?', '!', ']']);
        if Sphere::ALL.iter().any(|sphere| sphere.name() == bare) && !(bare == "A" && begins) {
            let help = format!("write `*{bare}*`, which is set as a letter");
            remarks.push(remark_at("the name of a sphere without its stars", around(words, at), word, &help));
            at += word.len();
            before = "";
            continue;
        }
        let is_word = word.len() > 1 || word == "a";
        if is_word && word.eq_ignore_ascii_case(before) && word.chars().all(char::is_alphabetic) && word != "that" {
            let shown = format!("{before} {word}");
            remarks.push(remark_at("a word said twice", around(words, at), &shown, "take one of them out"));
        }
        // `It's speed is`, and not `it's given that`.
        let is_of_it = ["It's", "It’s"].contains(&bare) && all.peek().is_some_and(|next| noun(next).is_some());
        let of_it = || is_of_it.then_some("Its");
        if let Some(meant) = meant(bare).or_else(|| meant_after(before, bare)).or_else(of_it) {
            let help = format!("write `{meant}`");
            remarks.push(remark_at("a slip of the pen", around(words, at), bare, &help));
        }
        if word.starts_with(|c: char| c.is_ascii_lowercase()) && takes_the_other_article(before, word) {
            let (shown, help) = (format!("{before} {word}"), "write the other of the two");
            remarks.push(remark_at("`a` or `an` before a word", around(words, at), &shown, help));
        }
        at += word.len();
        before = word;
    }
}

/// Signs of HTML in words, `<b>` or `&nbsp;`: where they begin, and what they are.
fn markup(words: &str) -> Option<(usize, &str)> {
    let begun = words.match_indices(['<', '&']);
    begun.into_iter().find_map(|(at, sign)| {
        let close = if sign == "<" { '>' } else { ';' };
        let end = words[at..].find(close)?;
        let inner = &words[at + 1..at + end];
        let is_tag = inner.chars().all(|sign| sign.is_ascii_alphanumeric() || "/#".contains(sign)) && !inner.is_empty();
        is_tag.then(|| (at, &words[at..=at + end]))
    })
}

/// Before a sound of a vowel stands `an`, before any other `a`; words in which the sound is not that of the letter are left
/// alone.
fn takes_the_other_article(article: &str, word: &str) -> bool {
    let has_another_sound = ["u", "eu", "h", "one", "once"].iter().any(|start| word.starts_with(start));
    let is_vowel = word.starts_with(['a', 'e', 'i', 'o']);
    let is_whole = word.chars().filter(|c| c.is_ascii_alphabetic()).count() > 1;
    let wrong = if is_vowel { "a" } else { "an" };
    is_whole && !has_another_sound && article.eq_ignore_ascii_case(wrong)
}
