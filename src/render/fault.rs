//! What can be wrong with a format or a template, said to the teacher who edits it.

use std::fmt;

/// Why no files were rendered.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum RenderFault {
    /// There is no format of that name.
    UnknownFormat {
        /// What was asked for.
        format: String,
        /// What there is.
        available: Vec<String>,
    },
    /// A folder of templates has no `format.toml`.
    NoManifest {
        /// Name of the folder.
        format: String,
    },
    /// A `format.toml` does not say what a manifest must say.
    Manifest {
        /// Path of the manifest: `latex/format.toml`.
        file: String,
        /// What is wrong, with line and caret where there are any.
        message: String,
    },
    /// A template cannot be read, or asks for a name that its page has not.
    Template {
        /// Path of the template: `latex/mark-scheme.tex`.
        file: String,
        /// What the template engine says, with line and caret where there are any.
        message: String,
    },
    /// A template uses a name that there is not.
    UnknownName {
        /// Path of the template.
        file: String,
        /// What it is looked for in: a `page`, a `question`, a `part`, …
        of: String,
        /// The name that it uses.
        name: String,
        /// The names that there are.
        available: Vec<String>,
    },
}

impl fmt::Display for RenderFault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            RenderFault::UnknownFormat { format, available } => {
                write!(f, "unknown format `{format}`: there are {}", listed(available))
            }
            RenderFault::NoManifest { format } => {
                write!(f, "templates/{format}: a format needs a `format.toml`; copy one of the shipped formats")
            }
            RenderFault::Manifest { file, message } | RenderFault::Template { file, message } => {
                write!(f, "templates/{file}: {message}")
            }
            RenderFault::UnknownName { file, of, name, available } => {
                write!(f, "templates/{file}: unknown name `{name}`: {} {of} has {}", article(of), listed(available))
            }
        }
    }
}

impl std::error::Error for RenderFault {}

fn article(noun: &str) -> &'static str {
    if noun.starts_with(['a', 'e']) { "an" } else { "a" }
}

/// `` `a`, `b` and `c` ``
fn listed(names: &[String]) -> String {
    let quoted: Vec<String> = names.iter().map(|name| format!("`{name}`")).collect();
    match quoted.split_last() {
        None => "none".to_owned(),
        Some((last, [])) => last.clone(),
        Some((last, rest)) => format!("{} and {last}", rest.join(", ")),
    }
}
