//! How far the examination has come, on a terminal; nothing in a pipe.

use std::fmt::Write;
use std::sync::Once;
use std::time::Duration;

use indicatif::{HumanDuration, ProgressBar, ProgressState, ProgressStyle};
use serde_json::{Value as Json, json};

use crate::bank::{Question, Style, StyleName};
use crate::examine::{Step, work};
use crate::generate::{Census, enumerate};

/// How many sets of numbers have been tried, and then of how many styles the variants have been marked.
pub struct Progress {
    bar: ProgressBar,
    marks: Once,
}

impl Progress {
    /// The progress through all styles of some questions.
    pub fn new<'q>(questions: impl IntoIterator<Item = &'q Question>) -> Progress {
        // The bar draws itself on stderr, and not at all if that is no terminal.
        let progress = Progress { bar: ProgressBar::new(work(questions)), marks: Once::new() };
        progress.count("sets of numbers");
        progress
    }

    /// What the bar counts.
    fn count(&self, what: &str) {
        if let Ok(style) = ProgressStyle::with_template(&format!("{{bar:40}} {{pos}}/{{len}} {what}{{left}}")) {
            let left = |state: &ProgressState, line: &mut dyn Write| {
                let left = left(state.elapsed(), state.fraction());
                // A line that cannot be drawn is drawn again at once.
                let _ = left.map_or(Ok(()), |left| write!(line, ", {:#} left", HumanDuration(left)));
            };
            self.bar.set_style(style.with_key("left", left));
        }
    }

    /// One step further.
    pub fn advance(&self, step: Step) {
        match step {
            Step::Sets(done) => self.bar.inc(done),
            Step::Marked { of } => {
                self.marks.call_once(|| {
                    // Nothing is drawn before all three are new.
                    self.count("styles marked");
                    self.bar.reset_elapsed();
                    self.bar.update(|state| {
                        state.set_pos(0);
                        state.set_len(of);
                    });
                });
                self.bar.inc(1);
            }
        }
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

/// How long the rest will take at the pace so far; nothing while so little is done that it would be a guess.
fn left(elapsed: Duration, done: f32) -> Option<Duration> {
    let is_known = elapsed >= Duration::from_secs(2) && done >= 0.05;
    is_known.then(|| elapsed.mul_f32((1.0 - done).max(0.0) / done))
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_left_is_said_when_enough_is_done() {
        let left = |elapsed, done| left(Duration::from_secs(elapsed), done).map(|left| left.as_secs());
        assert_eq!((left(1, 0.5), left(10, 0.01), left(3, 0.25), left(4, 1.0)), (None, None, Some(9), Some(0)));
    }
}
