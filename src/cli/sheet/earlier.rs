//! What an earlier run has left in the folder of a sheet. The key there says whose pages lie beside it.

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;

use serde_json::Value as Json;

use super::super::failure::Failure;
use super::super::formats::Printed;
use super::super::output::{listed, say};
use super::super::write::{OutputFile, spares};
use super::SUBMISSIONS;
use crate::mark::submissions::is_filled_in;
use crate::paper::Key;

/// What the key is called beside the sheets.
pub(super) const KEY: &str = "key.json";

/// Who has which sheet: its code by the student, of whom there is none where all have the same.
type Codes = BTreeMap<String, String>;

/// The sheets of which a folder is.
pub(super) struct Earlier {
    codes: Option<Codes>,
}

/// What stands in a file, if it is one. A device that is linked to in its place may have no end.
fn regular(path: &Path) -> Option<Vec<u8>> {
    if path.is_file() { fs::read(path).ok() } else { None }
}

impl Earlier {
    /// Looks for a key of Carom's in a folder.
    pub fn find(folder: &Path) -> Earlier {
        let text = regular(&folder.join(KEY)).unwrap_or_default();
        Earlier { codes: serde_json::from_slice(&text).ok().and_then(|key| codes(&key)) }
    }

    /// Makes sure that nothing is written over that is not Carom's, and that no answers come to lie beside a key to other
    /// questions. Is there anything in the table of answers, which must then be left as it is?
    ///
    /// A table that names students is still an empty one if they are those of the earlier class.
    pub fn gives_way(&self, folder: &Path, files: &[OutputFile], key: &Key) -> Result<bool, Failure> {
        let new = serde_json::to_value(key).ok().and_then(|key| codes(&key)).unwrap_or_default();
        let no_codes = Codes::new();
        let old = self.codes.as_ref().unwrap_or(&no_codes);
        let students: Vec<&str> = old.keys().chain(new.keys()).map(String::as_str).collect();
        let table = folder.join(SUBMISSIONS);
        let has_answers = regular(&table).is_some_and(|bytes| is_filled_in(&bytes, &students));
        if has_answers && self.is_of_other_sheets(&new) {
            let is_to = match old.iter().next() {
                None => format!("no `{KEY}` beside it says to which sheet"),
                Some((student, code)) if student.is_empty() => format!("they are to the sheet {code}"),
                Some(_) => "they are to the sheets of another class".to_owned(),
            };
            let message = format!("`{}` has answers in it, and {is_to}", table.display());
            let help = "mark them first and move them away, or name another folder with `--out`";
            return Err(Failure::with_help(message, help));
        }
        if self.codes.is_none() {
            spares(folder, files, &format!("no `{KEY}` of Carom's is beside it"))?;
        }
        Ok(has_answers)
    }

    /// Has nobody the sheet that was theirs, or somebody another? Who has left the class, or is new to it, changes nothing.
    fn is_of_other_sheets(&self, new: &Codes) -> bool {
        let old = self.codes.iter().flatten();
        let mut both = old.filter_map(|(student, code)| Some(new.get(student)? == code)).peekable();
        both.peek().is_none() || both.any(|is_same| !is_same)
    }

    /// Says what in the folder is of other sheets than those that now stand in it: of `pages`, the names that Carom gives to
    /// any, those that were not written, and the folders of students without a sheet.
    pub fn tell(&self, folder: &Path, pages: &[String], new: &Printed, key: &Key) {
        let codes = serde_json::to_value(key).ok().and_then(|key| codes(&key));
        let is_other = self.codes.is_some() && self.codes != codes;
        let as_pdf = |page: &String| Path::new(page).with_extension("pdf").display().to_string();
        let pdfs = pages.iter().map(as_pdf).filter(|_| new.missing.is_some() || is_other);
        let pages = pages.iter().filter(|_| is_other).cloned();
        let mut old: Vec<String> = pages.chain(pdfs).filter(|name| folder.join(name).is_file()).collect();
        let students = fs::read_dir(folder.join(STUDENTS)).into_iter().flatten().flatten().filter(|_| is_other);
        old.extend(students.map(|entry| format!("{STUDENTS}/{}", entry.file_name().to_string_lossy())));
        let is_new = |old: &String| {
            let inside = format!("{old}/");
            new.files.iter().any(|file| file.name == *old || file.name.starts_with(&inside))
        };
        old.retain(|old| !is_new(old));
        old.sort();
        old.dedup();
        if !old.is_empty() {
            let are = if old.len() == 1 { "is" } else { "are" };
            let old: Vec<String> = old.iter().map(|name| folder.join(name).display().to_string()).collect();
            say(&format!("{} {are} of an earlier sheet", listed(old.iter().map(String::as_str))));
        }
    }
}

/// The folder with a folder for each student.
pub(super) const STUDENTS: &str = "students";

/// The codes of a key; none of what is no key of a sheet.
fn codes(key: &Json) -> Option<Codes> {
    key.get("carom")?.as_str()?;
    let text = |json: &Json, field: &str| json.get(field).and_then(Json::as_str).unwrap_or_default().to_owned();
    match (key.get("questions"), key.get("papers")) {
        (Some(Json::Array(_)), None) => Some(Codes::from([(String::new(), text(key, "code"))])),
        (None, Some(Json::Array(papers))) => {
            Some(papers.iter().map(|paper| (text(paper, "student"), text(paper, "code"))).collect())
        }
        _ => None,
    }
}
