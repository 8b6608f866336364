//! The table of contents of a bank: what its files say of themselves, before any of them is checked.
//!
//! A sheet of six questions need not check the other eleven.

use std::collections::BTreeMap;
use std::path::Path;

use serde::Deserialize;

use super::folder::{Files, read_files};
use super::{Question, StyleName, read_question, shipped};
use crate::diagnostic::{Diagnostic, Source};

/// A question file and what stands at its head.
#[derive(Clone, Debug)]
pub struct Heading {
    /// Its path in the bank without `.toml`.
    pub id: String,
    /// Its heading in lists.
    pub title: String,
    /// The exercise that it mirrors.
    pub mirrors: Option<String>,
    /// Its topic.
    pub topic: String,
    /// Marks of all parts together.
    pub marks: usize,
    /// Its styles, in no particular order.
    pub styles: Vec<StyleName>,
    /// The file.
    pub source: Source,
}

/// What a heading needs of a file; whatever is wrong with it, the check of the question says better.
#[derive(Default, Deserialize)]
#[serde(default)]
struct Head {
    title: String,
    mirrors: Option<String>,
    topic: String,
    style: BTreeMap<String, toml::Value>,
    part: Vec<PartHead>,
}

#[derive(Default, Deserialize)]
#[serde(default)]
struct PartHead {
    marks: Vec<toml::Value>,
}

/// The headings of a bank, in the order of the exercises that they mirror, the others after them.
#[derive(Clone, Debug)]
pub struct Contents {
    /// Its name: `shipped`, or the folder.
    pub name: String,
    /// The headings.
    pub headings: Vec<Heading>,
    /// A fault for each file that cannot be read.
    pub unreadable: Vec<Diagnostic>,
}

impl Contents {
    /// Those of the bank inside the binary.
    pub fn shipped() -> Contents {
        let files = shipped().map(|(id, text)| (id, Source::new(format!("question_bank/{id}.toml"), text)));
        Contents::of("shipped", files.map(|(id, source)| heading(id, source)).collect(), Vec::new())
    }

    /// Those of a folder; a file that cannot be read hides none of the others.
    ///
    /// # Errors
    ///
    /// If the folder cannot be read, or if there is no question in it.
    pub fn read_folder(folder: &Path) -> Result<Contents, Vec<Diagnostic>> {
        let Files { sources, unreadable } = read_files(folder)?;
        let headings = sources.into_iter().map(|(id, source)| heading(&id, source)).collect();
        Ok(Contents::of(&folder.display().to_string(), headings, unreadable))
    }

    /// Is it the bank inside the binary?
    pub fn is_shipped(&self) -> bool {
        self.name == "shipped"
    }

    fn of(name: &str, mut headings: Vec<Heading>, unreadable: Vec<Diagnostic>) -> Contents {
        headings.sort_by_cached_key(|heading| {
            let mirrors = heading.mirrors.as_deref().map(natural);
            (mirrors.is_none(), mirrors, heading.id.clone())
        });
        Contents { name: name.to_owned(), headings, unreadable }
    }
}

impl Heading {
    /// The question, checked.
    ///
    /// # Errors
    ///
    /// Every fault of its file.
    pub fn question(&self) -> Result<Question, Vec<Diagnostic>> {
        read_question(&self.id, &self.source)
    }
}

fn heading(id: &str, source: Source) -> Heading {
    let head: Head = toml::from_str(&source.text).unwrap_or_default();
    let styles = StyleName::ALL.into_iter().filter(|style| head.style.contains_key(style.name())).collect();
    Heading {
        id: id.to_owned(),
        title: head.title,
        mirrors: head.mirrors,
        topic: head.topic,
        marks: head.part.iter().map(|part| part.marks.len()).sum(),
        styles,
        source,
    }
}

/// Words and numbers of a name, so that `5C-10` stands after `5C-9`.
fn natural(name: &str) -> Vec<(u64, String)> {
    let mut parts: Vec<(u64, String)> = Vec::new();
    let mut rest = name;
    while !rest.is_empty() {
        let digits = rest.bytes().take_while(u8::is_ascii_digit).count();
        let (number, after) = rest.split_at(digits);
        let words = after.find(|c: char| c.is_ascii_digit()).unwrap_or(after.len());
        let (word, after) = after.split_at(words);
        parts.push((number.parse().unwrap_or(u64::MAX), word.to_owned()));
        rest = after;
    }
    parts
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn carom_knows_the_order_of_exercises() {
        let mut names = ["5C-challenge", "5C-10", "5C-2", "5C-1"];
        names.sort_by_key(|name| natural(name));
        assert_eq!(names, ["5C-1", "5C-2", "5C-10", "5C-challenge"]);
    }

    #[test]
    fn a_heading_says_what_the_checked_question_says() {
        for heading in Contents::shipped().headings {
            let Ok(question) = heading.question() else { panic!("{}", heading.id) };
            assert_eq!(heading.title, question.title);
            assert_eq!((heading.marks, heading.styles.len()), (question.marks(), question.styles.len()));
        }
    }
}
