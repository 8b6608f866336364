//! What is previewed: the file of a question, and templates of one's own, read again as often as one likes.

use std::path::{Component, Path, PathBuf};

use crate::bank::{Contents, read_source};
use crate::cli::bank;
use crate::cli::failure::Failure;
use crate::cli::template_folder::own_templates;
use crate::diagnostic::Source;
use crate::render::TemplateFile;

/// A question, and where it is read.
pub struct Subject {
    /// Its id: by this and the seed its numbers are dealt.
    pub id: String,
    text: Text,
    templates: Option<PathBuf>,
}

enum Text {
    /// In a file.
    In(PathBuf),
    /// Inside carom.
    Shipped(Source),
}

/// All that a preview depends on.
#[derive(Clone, PartialEq)]
pub struct Written {
    /// The question file.
    pub source: Source,
    /// The templates of one's own.
    pub templates: Vec<TemplateFile>,
}

impl Subject {
    /// The question that a person means: by the path of its file, or as the other commands find it in a bank.
    pub fn find(name: &str, bank: Option<&Path>, templates: Option<&Path>) -> Result<Subject, Failure> {
        let templates = templates.map(Path::to_owned);
        if name.ends_with(".toml") {
            let path = PathBuf::from(name);
            return Ok(Subject { id: id(&path, bank), text: Text::In(path), templates });
        }
        let contents: Contents = bank::open(bank)?;
        let heading = bank::find(&contents, name)?;
        let text = match bank {
            Some(folder) => Text::In(folder.join(format!("{}.toml", heading.id))),
            None => Text::Shipped(heading.source.clone()),
        };
        Ok(Subject { id: heading.id.clone(), text, templates })
    }

    /// Reads it.
    pub fn read(&self) -> Result<Written, Failure> {
        let source = match &self.text {
            Text::Shipped(source) => source.clone(),
            Text::In(path) => read_source(path)?,
        };
        Ok(Written { source, templates: own_templates(self.templates.as_deref())? })
    }

    /// The command that examines the bank of the question.
    pub fn check(&self) -> String {
        let bank = match &self.text {
            Text::Shipped(_) => return "carom check".to_owned(),
            Text::In(path) => path.ancestors().nth(self.id.split('/').count()),
        };
        let bank = bank.filter(|bank| !bank.as_os_str().is_empty()).unwrap_or(Path::new("."));
        let bank = bank.display().to_string();
        if bank.contains(' ') { format!("carom check \"{bank}\"") } else { format!("carom check {bank}") }
    }

    /// What may change: the names of file and folder.
    pub fn watched(&self) -> Result<String, Failure> {
        let file = match &self.text {
            Text::In(path) => Some(path.display().to_string()),
            Text::Shipped(_) => None,
        };
        let folder = self.templates.as_ref().map(|folder| folder.display().to_string());
        let names: Vec<String> = file.into_iter().chain(folder).collect();
        if names.is_empty() {
            let message = format!("`{}` is inside carom: there is no file to watch", self.id);
            let help = "copy it into a file of your own by `carom new-question FILE --like QUESTION`, or watch `--templates DIR`";
            return Err(Failure::with_help(message, help));
        }
        Ok(names.join(" and "))
    }
}

/// The id that the file has in its bank; if nobody says which folder that is, it is taken to be `family/question`.
fn id(path: &Path, bank: Option<&Path>) -> String {
    let within = bank.and_then(|folder| path.strip_prefix(folder).ok());
    let stem = within.unwrap_or(path).with_extension("");
    let names = stem.components().filter_map(|part| match part {
        Component::Normal(name) => Some(name.to_string_lossy()),
        _ => None,
    });
    let names: Vec<_> = names.collect();
    let first = if within.is_some() { 0 } else { names.len().saturating_sub(2) };
    names[first..].join("/")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn carom_knows_the_bank_of_a_file() {
        for (path, command) in [
            ("new.toml", "carom check ."),
            ("rest/new.toml", "carom check ."),
            ("my-bank/rest/new.toml", "carom check my-bank"),
            ("my bank/rest/new.toml", "carom check \"my bank\""),
        ] {
            let check = Subject::find(path, None, None).ok().map(|subject| subject.check());
            assert_eq!(check.as_deref(), Some(command), "{path}");
        }
    }

    #[test]
    fn carom_knows_the_id_of_a_file() {
        let cases = [
            ("new.toml", None, "new"),
            ("./new.toml", None, "new"),
            ("my-bank/rest/new.toml", None, "rest/new"),
            ("/home/me/my-bank/rest/new.toml", None, "rest/new"),
            ("my-bank/new.toml", Some("my-bank"), "new"),
            ("my-bank/a/b/c.toml", Some("my-bank/"), "a/b/c"),
            ("elsewhere/rest/new.toml", Some("my-bank"), "rest/new"),
        ];
        for (path, bank, expected) in cases {
            assert_eq!(id(Path::new(path), bank.map(Path::new)), expected, "{path}");
        }
    }
}
