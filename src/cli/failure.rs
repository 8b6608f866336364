//! Why a command failed, and how a person is told.

use std::io::{self, Write};

use super::write::refusal;
use crate::diagnostic::{Diagnostic, briefly, render_all};
use crate::mechanics::Refusal;
use crate::render::RenderFault;

/// Why a command failed. All of these exit with 1 but the first.
pub enum Failure {
    /// Whoever read the output has gone away, as `head` does: no failure at all.
    ReaderGone,
    /// Something said in one sentence, and one thing to try.
    Said(String, Option<String>),
    /// Faults in a person's files.
    Faults(Vec<Diagnostic>),
    /// Findings that have been printed already.
    Found,
}

impl Failure {
    /// A failure without help.
    pub fn said(message: impl Into<String>) -> Failure {
        Failure::Said(message.into(), None)
    }

    /// A failure with one thing to try.
    pub fn with_help(message: impl Into<String>, help: impl Into<String>) -> Failure {
        Failure::Said(message.into(), Some(help.into()))
    }

    /// Tells the person.
    pub fn print(&self) {
        let mut stderr = io::stderr().lock();
        // If even this cannot be written there is nobody to tell.
        let _ = write!(stderr, "{}", self.in_words(is_coloured()));
    }

    /// What the person is told, in whole lines.
    pub fn in_words(&self, colour: bool) -> String {
        match self {
            Failure::ReaderGone | Failure::Found => String::new(),
            Failure::Said(message, None) => format!("error: {}\n", harmless(message)),
            Failure::Said(message, Some(help)) => format!("error: {}\nhelp: {}\n", harmless(message), harmless(help)),
            Failure::Faults(faults) => render_all(faults, colour),
        }
    }
}

/// A name that was typed is repeated without what commands a terminal.
fn harmless(words: &str) -> String {
    briefly(words).chars().filter(|c| !c.is_control() || *c == '\n').collect()
}

/// Tells of what was hardly meant, but stops nothing.
pub fn warn(warnings: &[Diagnostic]) {
    // If this cannot be written there is nobody to tell.
    let _ = write!(io::stderr().lock(), "{}", render_all(warnings, is_coloured()));
}

fn is_coloured() -> bool {
    console::colors_enabled_stderr()
}

impl From<Vec<Diagnostic>> for Failure {
    fn from(faults: Vec<Diagnostic>) -> Failure {
        Failure::Faults(faults)
    }
}

impl From<RenderFault> for Failure {
    fn from(fault: RenderFault) -> Failure {
        let help = fault.help();
        match fault {
            RenderFault::Templates(faults) => Failure::Faults(faults),
            RenderFault::UnknownFormat { .. } => Failure::Said(fault.to_string(), help),
        }
    }
}

impl From<Refusal> for Failure {
    fn from(refusal: Refusal) -> Failure {
        Failure::Said(refusal.reason, refusal.help)
    }
}

/// What is printed does not arrive.
impl From<io::Error> for Failure {
    fn from(error: io::Error) -> Failure {
        if error.kind() == io::ErrorKind::BrokenPipe {
            return Failure::ReaderGone;
        }
        let (why, help) = refusal(&error);
        Failure::with_help(format!("what is printed cannot be written: {why}"), help)
    }
}
