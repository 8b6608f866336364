//! What can be wrong with a format or a template, said to the teacher who edits it.

use std::fmt;

use crate::diagnostic::{Diagnostic, near, render_all};

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
    /// Faults of templates and manifests, each in its file.
    Templates(Vec<Diagnostic>),
}

impl RenderFault {
    /// One thing to try, where the faults do not say it themselves.
    pub fn help(&self) -> Option<String> {
        let RenderFault::UnknownFormat { format, available } = self else { return None };
        let names = || available.iter().map(String::as_str);
        Some(match near(format, names()) {
            Some(name) => format!("did you mean `{name}`?"),
            None => format!("there are {}", listed(&names().collect::<Vec<_>>())),
        })
    }
}

impl fmt::Display for RenderFault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            RenderFault::UnknownFormat { format, .. } => write!(f, "unknown format `{format}`"),
            RenderFault::Templates(faults) => f.write_str(render_all(faults, false).trim_end()),
        }
    }
}

impl std::error::Error for RenderFault {}

impl From<Vec<Diagnostic>> for RenderFault {
    fn from(faults: Vec<Diagnostic>) -> RenderFault {
        RenderFault::Templates(faults)
    }
}

/// A noun with its article.
pub(super) fn a(noun: &str) -> String {
    let article = if noun.starts_with(['a', 'e']) { "an" } else { "a" };
    format!("{article} {noun}")
}

/// `` `a`, `b` and `c` ``
pub(super) fn listed(names: &[&str]) -> String {
    let quoted: Vec<String> = names.iter().map(|name| format!("`{name}`")).collect();
    match quoted.split_last() {
        None => "none".to_owned(),
        Some((last, [])) => last.clone(),
        Some((last, rest)) => format!("{} and {last}", rest.join(", ")),
    }
}
