//! Expressions in templates, read so far as to know what each stands for.

use std::collections::BTreeMap;

use super::code::Word;
use super::lookup::Found;
use super::names::Kind;
use super::scope::Scope;
use crate::diagnostic::{Diagnostic, Source};

/// A reading of the words of one piece of code.
pub(super) struct Reading<'r, 't> {
    /// The words.
    pub words: &'r [Word<'t>],
    /// How many have been read.
    pub at: usize,
    /// The names that there are.
    pub scope: &'r Scope<'t>,
    /// The template, for faults.
    pub source: &'r Source,
    /// What has been found.
    pub found: &'r mut Found<'t>,
}

/// What a filter or a component is given: by name, what it stands for, and the text if it is nothing but quoted text.
type Given<'t> = BTreeMap<&'t str, (Kind, Option<Word<'t>>)>;

impl<'t> Reading<'_, 't> {
    /// The next word, if it is this one.
    pub fn take(&mut self, text: &str) -> bool {
        let is_next = self.peek() == text;
        self.at += usize::from(is_next);
        is_next
    }

    /// The next word.
    pub fn next(&mut self) -> Option<Word<'t>> {
        let word = self.words.get(self.at).copied();
        self.at += usize::from(word.is_some());
        word
    }

    fn peek(&self) -> &'t str {
        self.words.get(self.at).map_or("", |word| word.text)
    }

    /// An expression.
    pub fn expression(&mut self) -> Kind {
        let value = self.without_choice();
        if !self.take("if") {
            return value;
        }
        let condition = self.expression();
        self.found.truth(condition);
        self.take("else");
        let other = self.expression();
        self.found.either(value, other)
    }

    /// An expression without `if`, as it stands between `in` and `if` in a list.
    fn without_choice(&mut self) -> Kind {
        let mut value = self.operand();
        loop {
            value = match self.peek() {
                "and" | "or" => {
                    self.at += 1;
                    let other = self.operand();
                    self.found.truth(value);
                    self.found.truth(other);
                    self.found.either(value, other)
                }
                "is" => {
                    self.at += 1;
                    self.take("not");
                    self.next();
                    self.given();
                    self.found.truth(value)
                }
                "|" => {
                    self.at += 1;
                    self.filter(value)
                }
                "not" | "in" | "==" | "!=" | "<" | ">" | "<=" | ">=" | "+" | "-" | "*" | "/" | "//" | "**" | "%"
                | "~" => {
                    self.at += 1;
                    self.take("in");
                    let other = self.operand();
                    self.found.as_whole(value);
                    self.found.as_whole(other)
                }
                _ => return value,
            };
        }
    }

    /// A value with what is asked of it: names, places in lists, filters.
    fn operand(&mut self) -> Kind {
        let Some(word) = self.next() else { return Kind::Plain };
        let mut value = match word.text {
            "not" | "-" => {
                let value = self.operand();
                return self.found.truth(value);
            }
            "(" => {
                let value = self.expression();
                self.take(")");
                value
            }
            "[" => self.list(),
            "{" => self.map(),
            "<" => {
                self.component();
                Kind::Plain
            }
            "true" | "True" | "false" | "False" | "none" | "None" | "null" => Kind::Plain,
            _ if word.is_name() && self.peek() == "(" => self.function(word),
            "loop" if self.scope.in_loop() => {
                // Tera has looked at what follows
                self.at += 2;
                Kind::Plain
            }
            _ if word.is_name() => self.name(word),
            _ => Kind::Plain,
        };
        loop {
            value = match self.peek() {
                "." | "?." => {
                    self.at += 1;
                    match self.next() {
                        Some(name) => self.field(value, name.text, name),
                        None => value,
                    }
                }
                "[" | "?[" => {
                    self.at += 1;
                    self.place(value)
                }
                "|" => {
                    self.at += 1;
                    self.filter(value)
                }
                _ => return value,
            };
        }
    }

    fn name(&mut self, word: Word<'t>) -> Kind {
        self.found.name(word, self.scope, self.source)
    }

    fn field(&mut self, of: Kind, name: &str, word: Word<'t>) -> Kind {
        self.found.field(of, name, word, self.source)
    }

    /// What stands in square brackets after a value.
    fn place(&mut self, of: Kind) -> Kind {
        let first = self.words.get(self.at).copied();
        let mut is_slice = self.take(":");
        let begin = self.at;
        while !self.take("]") && self.at < self.words.len() {
            let key = self.expression();
            self.found.as_whole(key);
            while self.take(":") {
                is_slice = true;
            }
            // whatever this is, it has been looked at
            self.at = self.at.max(begin + 1);
        }
        match (of, first.and_then(|word| Some((word, word.quoted()?)))) {
            _ if is_slice => of,
            (Kind::Thing(_), Some((word, key))) => self.field(of, key, word),
            (Kind::Thing(_), None) => {
                self.found.as_whole(of);
                Kind::Anything
            }
            _ => of.element(),
        }
    }

    /// The filter after its stroke.
    fn filter(&mut self, value: Kind) -> Kind {
        let name = self.next().map_or("", |word| word.text);
        let given = self.given();
        let text = |key: &str| given.get(key).and_then(|(_, word)| Some(((*word)?, (*word)?.quoted()?)));
        let attribute = text("attribute");
        match (name, value) {
            ("length", _) => Kind::Plain,
            ("first" | "last" | "nth", Kind::Things(_) | Kind::Plains | Kind::Anything) => value.element(),
            ("reverse", _) => value,
            ("sort", Kind::Things(_)) if attribute.is_some() => {
                self.path(value.element(), attribute);
                value
            }
            ("group_by", Kind::Things(_)) => {
                self.path(value.element(), attribute);
                self.found.as_whole(value);
                Kind::Anything
            }
            ("default", _) => {
                let other = given.get("value").map_or(value, |(kind, _)| *kind);
                self.found.either(value, other)
            }
            ("get", Kind::Thing(_)) if text("key").is_some() => {
                text("key").map_or(Kind::Anything, |(word, key)| self.field(value, key, word))
            }
            (_, Kind::Plain) => Kind::Plain,
            _ => {
                self.found.as_whole(value);
                Kind::Anything
            }
        }
    }

    /// Names with full stops between them, in quotes.
    fn path(&mut self, of: Kind, path: Option<(Word<'t>, &'t str)>) {
        let Some((word, path)) = path else { return };
        path.split('.').fold(of, |kind, name| self.field(kind, name, word));
    }

    /// What stands in round brackets after a filter, a test or a function, if anything does.
    fn given(&mut self) -> Given<'t> {
        let mut given = Given::new();
        if !self.take("(") {
            return given;
        }
        while !self.take(")") {
            let Some(name) = self.next() else { break };
            if self.take("=") {
                let begin = self.at;
                let kind = self.expression();
                let alone = (self.at == begin + 1).then(|| self.words[begin]);
                given.insert(name.text, (kind, alone));
            }
        }
        given
    }

    fn function(&mut self, name: Word<'t>) -> Kind {
        for (kind, _) in self.given().into_values() {
            self.found.as_whole(kind);
        }
        match name.text {
            "range" => Kind::Plains,
            "super" => Kind::Plain,
            _ => Kind::Anything,
        }
    }

    /// What stands in square brackets by itself: values, or `value for name in list if condition`.
    fn list(&mut self) -> Kind {
        if let Some(begin) = self.comprehended() {
            return self.comprehension(begin);
        }
        let mut of = None;
        while !self.take("]") && self.at < self.words.len() {
            let begin = self.at;
            let spread = self.take("...");
            let value = self.expression();
            let value = if spread { value.element() } else { value };
            of = Some(of.map_or(value, |before| self.found.either(before, value)));
            self.take(",");
            self.at = self.at.max(begin + 1);
        }
        of.unwrap_or(Kind::Plain).listed()
    }

    /// Where the `for` of a list stands, if it has one.
    fn comprehended(&self) -> Option<usize> {
        let mut depth = 0;
        for (place, word) in self.words.iter().enumerate().skip(self.at) {
            match word.text {
                "for" if depth == 0 => return Some(place),
                "(" | "[" | "{" | "?[" => depth += 1,
                "]" if depth == 0 => return None,
                ")" | "]" | "}" => depth -= 1,
                _ => {}
            }
        }
        None
    }

    fn comprehension(&mut self, begin: usize) -> Kind {
        let value_begin = std::mem::replace(&mut self.at, begin + 1);
        let names = self.loop_names();
        let list = self.without_choice();
        let bound = self.bind(&names, list);
        let mut scope = self.scope.clone();
        bound.into_iter().for_each(|(name, kind)| scope.set(name, kind));
        let mut inner =
            Reading { words: self.words, at: self.at, scope: &scope, source: self.source, found: &mut *self.found };
        if inner.take("if") {
            let condition = inner.without_choice();
            inner.found.truth(condition);
        }
        let end = inner.at;
        inner.at = value_begin;
        let kind = inner.expression();
        self.at = end;
        self.take("]");
        kind.listed()
    }

    /// The names after `for`, up to and with `in`.
    pub fn loop_names(&mut self) -> Vec<Word<'t>> {
        let mut names = Vec::new();
        while let Some(word) = self.next() {
            match word.text {
                "in" => break,
                "," => {}
                _ => names.push(word),
            }
        }
        names
    }

    /// What the names after `for` stand for, going through a list.
    pub fn bind(&mut self, names: &[Word<'t>], list: Kind) -> Vec<(&'t str, Kind)> {
        match names {
            [key, value] => {
                if matches!(list, Kind::Things(_) | Kind::Plains) {
                    let label = "a list has one name after `for`; two go through names and what they stand for";
                    let fault = Diagnostic::new("two names for one list", self.source, key.span(), label);
                    self.found.faults.push(fault.with_help("`loop.index` counts from 1, `loop.index0` from 0"));
                } else {
                    self.found.as_whole(list);
                }
                vec![(key.text, Kind::Plain), (value.text, list.element())]
            }
            _ => {
                if let Kind::Thing(_) = list {
                    self.found.as_whole(list);
                }
                names.iter().map(|name| (name.text, list.element())).collect()
            }
        }
    }

    /// What stands in braces by itself.
    fn map(&mut self) -> Kind {
        while !self.take("}") && self.at < self.words.len() {
            self.take("...");
            let key_or_value = self.expression();
            self.found.as_whole(key_or_value);
            if !self.take(":") && !self.take(",") && self.peek() != "}" {
                self.at += 1;
            }
        }
        Kind::Anything
    }

    /// A component after its `<`, up to its `>`.
    pub fn component(&mut self) {
        let mut name = String::new();
        while let Some(word) = self.words.get(self.at).filter(|word| word.is_name() || word.text == ".") {
            if word.is_name() && !name.is_empty() && !name.ends_with('.') {
                break;
            }
            name.push_str(word.text);
            self.at += 1;
        }
        let mut given = BTreeMap::new();
        while let Some(word) = self.next() {
            match word.text {
                ">" => break,
                "{" => {
                    self.take("...");
                    let spread = self.expression();
                    self.found.as_whole(spread);
                    self.take("}");
                }
                _ if word.is_name() => {
                    let kind = if !self.take("=") {
                        self.name(word)
                    } else if self.take("{") {
                        let kind = self.expression();
                        self.take("}");
                        kind
                    } else {
                        self.next();
                        Kind::Plain
                    };
                    given.insert(word.text, kind);
                }
                _ => {}
            }
        }
        self.found.calls.push((name, given));
    }
}
