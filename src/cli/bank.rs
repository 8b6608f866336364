//! The bank that the arguments name, and the questions in it that they mean.

use std::path::Path;

use super::failure::Failure;
use super::new_question::typed;
use super::output::listed;
use crate::bank::{Contents, Heading};
use crate::diagnostic::near;

/// The bank in a folder, every file of which can be read, or the one inside the binary.
pub fn open(folder: Option<&Path>) -> Result<Contents, Failure> {
    let contents = in_part(folder)?;
    if contents.unreadable.is_empty() { Ok(contents) } else { Err(Failure::Faults(contents.unreadable)) }
}

/// The same of which some files cannot be read.
pub fn in_part(folder: Option<&Path>) -> Result<Contents, Failure> {
    match folder {
        None => Ok(Contents::shipped()),
        Some(folder) => Contents::read_folder(folder).map_err(Failure::from),
    }
}

/// The question that a person means: by its id, by the exercise that it mirrors, or by a part of its id that no
/// other has.
pub fn find<'c>(contents: &'c Contents, name: &str) -> Result<&'c Heading, Failure> {
    let headings = &contents.headings;
    let wanted = name.trim().to_lowercase();
    if let Some(heading) = headings.iter().find(|heading| heading.id == name) {
        return Ok(heading);
    }
    let mirrors = |heading: &&Heading| heading.mirrors.as_ref().is_some_and(|name| name.to_lowercase() == wanted);
    let mut found: Vec<&Heading> = headings.iter().filter(mirrors).collect();
    if found.is_empty() && !wanted.is_empty() {
        found = headings.iter().filter(|heading| heading.id.to_lowercase().contains(&wanted)).collect();
    }
    match found.as_slice() {
        [one] => Ok(one),
        [] => Err(unknown(contents, name)),
        several => {
            let ids = listed(several.iter().map(|heading| heading.id.as_str()));
            Err(Failure::with_help(format!("`{name}` may mean more than one question"), format!("name one of {ids}")))
        }
    }
}

fn unknown(contents: &Contents, name: &str) -> Failure {
    let pieces: Vec<&str> = name.split(',').map(str::trim).collect();
    let other = if Path::new(name).is_dir() {
        Some(format!("that is a folder: for the questions of a bank in it write `--bank {name}`"))
    } else if Path::new(name).is_file() {
        Some(
            "that is a file: a question is named by its id in its bank, which `carom list --bank DIR` shows".to_owned(),
        )
    } else if pieces.len() > 1 && pieces.iter().all(|piece| find(contents, piece).is_ok()) {
        Some(format!("write spaces between questions: `{}`", pieces.join(" ")))
    } else {
        None
    };
    if let Some(help) = other {
        return Failure::with_help(format!("unknown question `{name}`"), help);
    }
    let ids = contents.headings.iter().map(|heading| heading.id.as_str());
    let last = contents.headings.iter().filter_map(|heading| heading.id.rsplit('/').next());
    let mirrors = contents.headings.iter().filter_map(|heading| heading.mirrors.as_deref());
    let near = near(name, ids.chain(last).chain(mirrors)).map(str::to_owned);
    let near = near.into_iter().collect::<Vec<_>>();
    let meant = if near.is_empty() { with_a_word_near(contents, name) } else { near };
    let of =
        if contents.is_shipped() { String::new() } else { format!(" --bank {}", typed(Path::new(&contents.name))) };
    let list = format!("`carom list{of}` names every question");
    let help = match meant.as_slice() {
        [] => list,
        meant => {
            let meant = meant.iter().map(|id| format!("`{id}`")).collect::<Vec<_>>().join(" or ");
            format!("did you mean {meant}? {list}")
        }
    };
    Failure::with_help(format!("unknown question `{name}`"), help)
}

/// A few questions whose ids have a word that is nearly what was typed, or that mirror exercises which begin with it.
fn with_a_word_near(contents: &Contents, name: &str) -> Vec<String> {
    const FEW: usize = 3;
    let words = |id: &str| id.split(['/', '-']).filter(|word| word.len() > 3).map(str::to_owned).collect::<Vec<_>>();
    let mut all: Vec<String> = contents.headings.iter().flat_map(|heading| words(&heading.id)).collect();
    all.sort();
    all.dedup();
    let word = near(name, all.iter().map(String::as_str));
    let has_it = |heading: &&Heading| match (word, &heading.mirrors) {
        (Some(word), _) => words(&heading.id).iter().any(|own| own == word),
        (None, Some(mirrors)) => {
            !name.trim().is_empty() && mirrors.to_lowercase().starts_with(&name.trim().to_lowercase())
        }
        (None, None) => false,
    };
    let found = contents.headings.iter().filter(has_it).take(FEW);
    found
        .map(|heading| if word.is_none() { heading.mirrors.clone() } else { None }.unwrap_or(heading.id.clone()))
        .collect()
}
