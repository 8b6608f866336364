//! A TOML document read table by table, with every unknown key and every wrong type reported.

use std::ops::Range;

use toml::Spanned;
use toml::de::{DeTable, DeValue};

use super::literal::{self, Words};
use super::{StyleName, syntax};
use crate::diagnostic::{Diagnostic, Source, near};
use crate::expr::{Fault, Span};

/// The faults found so far in one file.
#[derive(Debug)]
pub struct Faults {
    /// The file.
    pub source: Source,
    /// What is wrong with it.
    pub found: Vec<Diagnostic>,
    /// The keys that are written before the first heading, and whose they are. Whatever stands below a heading belongs to it.
    above: (&'static str, Vec<&'static str>),
    /// Is a table of it unread, since its key is misspelt? Then what lacks is no fault.
    pub is_unread: bool,
    /// What to compare the file with, where nothing better is known.
    pub model: &'static str,
}

impl Faults {
    /// None yet.
    pub fn new(source: Source) -> Faults {
        let model = "compare with a question that works, as `carom new-question` writes one";
        Faults { source, found: Vec::new(), above: ("", Vec::new()), is_unread: false, model }
    }

    /// A fault at a place in the file: what is wrong, what was expected, one thing to try.
    pub fn report(
        &mut self,
        span: Range<usize>,
        message: impl Into<String>,
        label: impl Into<String>,
        help: impl Into<String>,
    ) {
        self.found.push(Diagnostic::new(message, &self.source, span, label).with_help(help));
    }

    /// A name that is not among those that can stand here.
    pub fn unknown<'a>(
        &mut self,
        span: Range<usize>,
        message: String,
        label: String,
        name: &str,
        known: impl IntoIterator<Item = &'a str>,
    ) {
        let fault = Diagnostic::new(message, &self.source, span, label);
        let fault = fault.with_help("write one of those, or take it out");
        self.found.push(fault.with_near(near(name, known)));
    }

    /// What stands in a list twice, or in it and before it; space between signs is no difference.
    pub fn twice(&mut self, what: &str, before: &[Words], list: &[Words]) {
        let plain = |words: &Words| words.get_ref().split_whitespace().collect::<String>();
        for (place, words) in list.iter().enumerate() {
            if before.iter().chain(&list[..place]).any(|other| plain(other) == plain(words)) {
                let message = format!("{what} `{}` stands here twice", words.get_ref());
                self.report(words.span(), message, "it was there before", "take one of the two out");
            }
        }
    }

    /// Is a key of the whole file written below the heading of something else? Then that is reported.
    fn is_astray(&mut self, what: &str, key: &Spanned<impl AsRef<str>>) -> bool {
        let name = key.get_ref().as_ref();
        let (whose, above) = &self.above;
        let is_astray = above.contains(&name);
        if is_astray {
            let label = format!("it is a key of {whose}");
            let help = "write it above the first heading in brackets: what stands below a heading belongs to it";
            self.report(key.span(), format!("`{name}` stands in {what}"), label, help);
        }
        is_astray
    }

    /// A fault of an expression, at its place inside a string of the file.
    pub fn expression(&mut self, words: &Words, fault: Fault) {
        self.expression_from(words, 0, fault);
    }

    /// As [`Faults::expression`], where the expression begins some bytes into the string.
    pub fn expression_from(&mut self, words: &Words, start: usize, fault: Fault) {
        let mut span = self.place(words, Span { start: start + fault.span.start, end: start + fault.span.end });
        if fault.span == Span::default() && start == 0 {
            // No part of it in particular: the whole string.
            span = words.span();
        }
        // What a value should have been is what to write in its place.
        let help = fault.help.unwrap_or_else(|| format!("write {} in its place", fault.expected));
        self.report(span, fault.message, fault.expected, help);
    }

    /// Where a part of a string stands in the file.
    pub fn place(&self, words: &Words, part: Span) -> Range<usize> {
        literal::place(&self.source.text, words, part)
    }
}

/// The document as a table; `None`, and the faults reported, if it is no TOML.
pub fn parse<'a>(text: &'a str, faults: &mut Faults) -> Option<Spanned<DeTable<'a>>> {
    let table = parse_even_empty(text, faults)?;
    if table.get_ref().is_empty() {
        let help = "`carom new-question FILE` writes one to begin with";
        faults.report(0..0, "nothing stands in this file", "expected a question", help);
        return None;
    }
    Some(table)
}

/// The same of a file in which nothing need stand.
pub fn parse_even_empty<'a>(text: &'a str, faults: &mut Faults) -> Option<Spanned<DeTable<'a>>> {
    let (table, errors) = DeTable::parse_recoverable(text);
    syntax::report(&errors, faults);
    errors.is_empty().then_some(table)
}

/// Where a key of a style stands: a parameter or derived name, of the style's own or of all styles, or one of its lists.
pub fn key_span(text: &str, style: StyleName, name: &str) -> Option<Range<usize>> {
    let (document, _) = DeTable::parse_recoverable(text);
    let styles = || document.get_ref().get("style")?.get_ref().as_table();
    let own = || styles()?.get(style.name());
    let of = |table: &Spanned<DeValue>| {
        let mut keys = table.get_ref().as_table()?.keys();
        keys.find(|key| key.get_ref() == name).map(Spanned::span)
    };
    let own_list = |list: &str| own()?.get_ref().as_table()?.get(list).and_then(of);
    let among = |list: &str| own_list(list).or_else(|| document.get_ref().get(list).and_then(of));
    among("parameters").or_else(|| among("let")).or_else(|| own().and_then(of))
}

/// Where a row stands in the list of that name, `answers` or `marks`, of a part.
pub fn row_span(text: &str, part: usize, list: &str, row: usize) -> Option<Range<usize>> {
    let (document, _) = DeTable::parse_recoverable(text);
    let part = document.get_ref().get("part")?.get_ref().as_array()?.get(part)?.get_ref().as_table()?;
    part.get(list)?.get_ref().as_array()?.get(row).map(Spanned::span)
}

/// One table of the document while its keys are asked for one by one.
pub struct Keys<'t, 'd> {
    /// What the table is to a person: `a part`.
    what: &'static str,
    table: &'t DeTable<'d>,
    span: Range<usize>,
    known: Vec<&'static str>,
    /// Keys that must be there and are not, each with what to write.
    missing: Vec<(&'static str, String)>,
}

impl<'t, 'd> Keys<'t, 'd> {
    /// The keys of a table.
    pub fn of(what: &'static str, table: &'t DeTable<'d>, span: Range<usize>) -> Keys<'t, 'd> {
        Keys { what, table, span, known: Vec::new(), missing: Vec::new() }
    }

    /// The keys of a value that must be a table.
    pub fn within(what: &'static str, value: &'t Spanned<DeValue<'d>>, faults: &mut Faults) -> Option<Keys<'t, 'd>> {
        match value.get_ref() {
            DeValue::Table(table) => Some(Keys::of(what, table, value.span())),
            other => {
                wrong_type(what, "a table", other, value.span(), faults);
                None
            }
        }
    }

    /// Notes that the keys asked for so far are written before the first heading, and whose they are.
    pub fn are_above_headings(&self, whose: &'static str, faults: &mut Faults) {
        faults.above = (whose, self.known.clone());
    }

    /// Where the table stands.
    pub fn span(&self) -> Range<usize> {
        self.span.clone()
    }

    /// The value of a key, which is known from now on.
    pub fn get(&mut self, key: &'static str) -> Option<&'t Spanned<DeValue<'d>>> {
        self.known.push(key);
        self.table.get(key)
    }

    /// A string, if the key is there.
    pub fn words(&mut self, key: &'static str, faults: &mut Faults) -> Option<Words> {
        let value = self.get(key)?;
        words(&format!("`{key}`"), value, faults)
    }

    /// A string that must be there.
    pub fn required(&mut self, key: &'static str, example: &str, faults: &mut Faults) -> Option<Words> {
        self.demand(key, example);
        let words = self.words(key, faults)?;
        if words.get_ref().trim().is_empty() {
            let help = format!("write `{example}`");
            faults.report(words.span(), format!("`{key}` is empty"), "expected words", help);
            return None;
        }
        Some(words)
    }

    /// A list of strings; empty if the key is not there.
    pub fn list(&mut self, key: &'static str, faults: &mut Faults) -> Vec<Words> {
        let Some(value) = self.get(key) else { return Vec::new() };
        list(&format!("`{key}`"), value, faults)
    }

    /// The tables of a list; empty if the key is not there.
    pub fn tables(&mut self, key: &'static str, what: &'static str, faults: &mut Faults) -> Vec<Keys<'t, 'd>> {
        let Some(value) = self.get(key) else { return Vec::new() };
        let DeValue::Array(items) = value.get_ref() else {
            wrong_type(&format!("`{key}`"), "a list of tables", value.get_ref(), value.span(), faults);
            let written = faults.source.text.get(value.span()).unwrap_or_default();
            let help = match written.trim_matches(['[', ']']) {
                heading if written.starts_with('[') => format!("write `[[{heading}]]`, in two pairs of brackets"),
                _ => format!("write `{key} = [{{ … }}]`, each table of the list in braces"),
            };
            if let Some(fault) = faults.found.last_mut() {
                fault.help = Some(help);
            }
            return Vec::new();
        };
        items.iter().filter_map(|item| Keys::within(what, item, faults)).collect()
    }

    /// Notes that a key is missing, if it is; [`Keys::finish`] reports it.
    pub fn demand(&mut self, key: &'static str, example: &str) {
        if !self.table.contains_key(key) {
            self.missing.push((key, example.to_owned()));
        }
    }

    /// Every key that nobody asked for is a fault, and so is every key that must be there and is not, unless it stands
    /// there misspelt.
    pub fn finish(self, faults: &mut Faults) {
        let mut meant: Vec<&str> = Vec::new();
        for (key, value) in self.table.iter() {
            let name: &str = key.get_ref();
            if !self.known.contains(&name) && !faults.is_astray(self.what, key) {
                let near_one = near(name, self.known.iter().copied());
                // A heading that is misspelt beside one that is not stands for a table of its own.
                let is_heading = faults.source.text[..key.span().start].ends_with('[');
                faults.is_unread |= near_one.is_some_and(|meant| is_heading || !self.table.contains_key(meant))
                    && holds_tables(value.get_ref());
                meant.extend(near_one);
                let message = format!("unknown key `{name}`");
                let known = self.known.iter().copied();
                let label = match near(name, known.clone()) {
                    Some(_) => format!("{} has no such key", self.what),
                    None => format!("{} has {}", self.what, listed(&self.known)),
                };
                faults.unknown(key.span(), message, label, name, known);
            }
        }
        for (key, example) in self.missing.iter().filter(|(key, _)| !meant.contains(key)) {
            let span = if self.span.start == 0 { 0..0 } else { self.span.clone() };
            let help = format!("add `{example}`");
            faults.report(span, format!("{} without `{key}`", self.what), "it is missing here", help);
        }
    }
}

/// Is it a table or a list of tables?
fn holds_tables(value: &DeValue) -> bool {
    match value {
        DeValue::Table(_) => true,
        DeValue::Array(items) => items.iter().any(|item| holds_tables(item.get_ref())),
        _ => false,
    }
}

/// Names in backticks, with commas between.
pub fn listed<S: AsRef<str>>(names: &[S]) -> String {
    names.iter().map(|name| format!("`{}`", name.as_ref())).collect::<Vec<_>>().join(", ")
}

/// The pairs of a table whose keys are free, in the order of the file.
pub fn pairs<'t, 'd>(
    what: &str,
    value: &'t Spanned<DeValue<'d>>,
    faults: &mut Faults,
) -> Vec<(Words, &'t Spanned<DeValue<'d>>)> {
    let DeValue::Table(table) = value.get_ref() else {
        wrong_type(what, "a table", value.get_ref(), value.span(), faults);
        return Vec::new();
    };
    let own = table.iter().filter(|(key, _)| !faults.is_astray(what, key));
    own.map(|(key, value)| (Spanned::new(key.span(), key.get_ref().to_string()), value)).collect()
}

/// A string.
pub fn words(what: &str, value: &Spanned<DeValue>, faults: &mut Faults) -> Option<Words> {
    match value.get_ref() {
        DeValue::String(text) => Some(Spanned::new(value.span(), text.to_string())),
        other => {
            wrong_type(what, "text in quotes", other, value.span(), faults);
            None
        }
    }
}

/// A list of strings.
pub fn list(what: &str, value: &Spanned<DeValue>, faults: &mut Faults) -> Vec<Words> {
    match value.get_ref() {
        DeValue::Array(items) => items.iter().filter_map(|item| words(what, item, faults)).collect(),
        other => {
            wrong_type(what, "a list of texts in quotes", other, value.span(), faults);
            Vec::new()
        }
    }
}

/// What was found where something else was expected.
pub fn wrong_type(what: &str, expected: &str, found: &DeValue, span: Range<usize>, faults: &mut Faults) {
    let kind = kind(found);
    let written = faults.source.text.get(span.clone()).unwrap_or_default().to_owned();
    let message = format!("{what} is {kind}");
    let label = format!("expected {expected}");
    match (found, expected) {
        (DeValue::Integer(_) | DeValue::Float(_), "text in quotes") => {
            faults.report(span, message, label, format!("put it in quotes: `\"{written}\"`"));
        }
        (DeValue::String(_), "a list of texts in quotes") => {
            faults.report(span, message, label, "put it in brackets: `[\"…\"]`");
        }
        (DeValue::Boolean(_) | DeValue::Datetime(_), "text in quotes") => {
            faults.report(span, message, label, format!("put it in quotes, if it is meant: `\"{written}\"`"));
        }
        (DeValue::Array(_), "text in quotes") => {
            faults.report(span, message, label, "write one text, without the brackets");
        }
        (DeValue::Table(_), "text in quotes") => {
            faults.report(span, message, label, "write one text, `… = \"…\"`, without a heading or braces");
        }
        (_, "a table") => {
            let help = "write `{ key = \"…\" }`, or a heading in brackets with the keys on lines below it";
            faults.report(span, message, label, help);
        }
        _ => faults.report(span, message, label, "write it as the README of the bank shows it"),
    }
}

/// What a value is to a person.
pub fn kind(value: &DeValue) -> &'static str {
    match value {
        DeValue::String(_) => "a text",
        DeValue::Integer(_) | DeValue::Float(_) => "a bare number",
        DeValue::Boolean(_) => "true or false",
        DeValue::Datetime(_) => "a date",
        DeValue::Array(_) => "a list",
        DeValue::Table(_) => "a table",
    }
}
