//! How far the examination has come, on a terminal; nothing in a pipe.

use indicatif::{ProgressBar, ProgressStyle};
use serde_json::{Value as Json, json};

use crate::bank::{Question, Style, StyleName};
use crate::examine::work;
use crate::generate::{Census, enumerate};

/// How many sets of numbers have been tried.
pub struct Progress {
    bar: ProgressBar,
}

impl Progress {
    /// The progress through all styles of some questions.
    pub fn new<'q>(questions: impl IntoIterator<Item = &'q Question>) -> Progress {
        // The bar draws itself on stderr, and not at all if that is no terminal.
        let bar = ProgressBar::new(work(questions));
        if let Ok(style) = ProgressStyle::with_template("{bar:40} {pos}/{len} sets of numbers, {eta} left") {
            bar.set_style(style);
        }
        Progress { bar }
    }

    /// So many sets more.
    pub fn advance(&self, done: u64) {
        self.bar.inc(done);
    }

    fn at(&self, before: u64, done: u64) {
        // Threads finish out of order.
        let position = before + done;
        if position > self.bar.position() {
            self.bar.set_position(position);
        }
    }

    /// Takes the bar away.
    pub fn finish(&self) {
        self.bar.finish_and_clear();
    }
}

/// A style with what became of its sets of numbers.
pub struct StyleCount {
    /// The style.
    pub style: StyleName,
    /// The count.
    pub census: Census,
}

impl StyleCount {
    /// As `--json` has it.
    pub fn json(&self) -> Json {
        let Census { size, examined, fit, .. } = self.census;
        json!({"style": self.style.name(), "sets": size, "examined": examined, "variants": fit})
    }
}

/// Every style of a question, enumerated.
pub fn counts(question: &Question, progress: &Progress) -> Vec<StyleCount> {
    let one = |style: &Style| {
        let before = progress.bar.position();
        let census = enumerate(question, style, &|_| (), &|done| progress.at(before, done));
        progress.bar.set_position(before + census.examined);
        StyleCount { style: style.name, census }
    };
    question.styles.iter().map(one).collect()
}
