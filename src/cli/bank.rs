//! The bank that the arguments name, and the questions in it that they mean.

use std::path::Path;

use super::failure::Failure;
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
    let ids = contents.headings.iter().map(|heading| heading.id.as_str());
    let last = contents.headings.iter().filter_map(|heading| heading.id.rsplit('/').next());
    let mirrors = contents.headings.iter().filter_map(|heading| heading.mirrors.as_deref());
    let help = match near(name, ids.chain(last).chain(mirrors)) {
        Some(near) => format!("did you mean `{near}`? `carom list` names every question"),
        None => "`carom list` names every question".to_owned(),
    };
    Failure::with_help(format!("unknown question `{name}`"), help)
}
