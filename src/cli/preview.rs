//! `carom preview`: one question with its numbers, solution, scheme and answers, for whoever writes it.

mod page;
pub(super) mod subject;
mod watch;

use std::io::{self, IsTerminal};
use std::path::PathBuf;

use clap::Args;

use super::failure::{Failure, warn};
use super::output::{line_length, listed, print, say};
use super::sheet::{fresh_seed, seed};
use crate::bank::{Question, StyleName, read_question};
use crate::diagnostic::render_all;
use crate::examine::glance;
use crate::generate::{Variant, reference};
use crate::paper::{Dealer, Paper, compose};
use crate::render::Formats;
use page::Page;
use subject::{Subject, Written};

const AFTER: &str = "Examples:
  carom preview 5C-2                             a question with fresh numbers
  carom preview rest/speeds --style friendly --seed 7
  carom preview my-bank/rest/new.toml --watch    again at every save, with its faults
  carom preview my-bank/rest/new.toml --watch --open";

/// Show one question with its worked solution, mark scheme and answers
///
/// In the terminal, or with --open in a browser. With --watch it is shown again whenever its file is saved.
#[derive(Args)]
#[command(after_help = AFTER)]
pub struct PreviewArguments {
    /// The question: its id, a part of it, the exercise it mirrors, or the path of its file (new.toml)
    #[arg(value_name = "QUESTION")]
    question: String,
    /// The manner of the numbers; without it the seed chooses one
    #[arg(long, value_name = "STYLE", value_parser = ["friendly", "exact", "calculator"])]
    style: Option<String>,
    /// The number that decides all choices; without it the clock does
    #[arg(long, value_name = "SEED", value_parser = seed, allow_negative_numbers = true)]
    seed: Option<u64>,
    /// The numbers of the exercise itself, in place of fresh ones
    #[arg(long, conflicts_with_all = ["seed", "style"])]
    reference: bool,
    /// A bank of your own
    #[arg(long, value_name = "DIR")]
    bank: Option<PathBuf>,
    /// Templates of your own, which take the place of those of the same name
    #[arg(long, value_name = "DIR")]
    templates: Option<PathBuf>,
    /// Show it in a browser
    #[arg(long)]
    open: bool,
    /// The file of the page for the browser; without it, one in a temporary folder
    #[arg(long, value_name = "FILE", requires = "open")]
    out: Option<PathBuf>,
    /// Show it again whenever its file or the templates change, until Ctrl-C
    #[arg(long)]
    watch: bool,
}

/// Previews the question.
pub fn run(arguments: &PreviewArguments) -> Result<(), Failure> {
    let subject = Subject::find(&arguments.question, arguments.bank.as_deref(), arguments.templates.as_deref())?;
    let style = arguments.style.as_ref().and_then(|name| StyleName::ALL.into_iter().find(|style| style.name() == name));
    let seed = (!arguments.reference).then(|| arguments.seed.unwrap_or_else(fresh_seed));
    let numbers = Numbers { seed, style };
    if arguments.watch {
        return keep_showing(arguments, &subject, &numbers);
    }
    let preview = Preview::new(&subject, &subject.read()?, &numbers)?;
    warn(preview.formats.warnings());
    preview.amiss.iter().for_each(|line| say(line));
    if arguments.open {
        let page = Page::new(arguments.out.as_deref())?;
        page.write(&preview.html()?)?;
        say(&preview.note);
        print(&format!("{}\n", page.path().display()))?;
        return page.open();
    }
    print(&preview.text()?)?;
    say(&preview.note);
    Ok(())
}

/// Shows the question again after each change: in the terminal the question or, if a browser has it, where; faults
/// in both.
fn keep_showing(arguments: &PreviewArguments, subject: &Subject, numbers: &Numbers) -> Result<(), Failure> {
    let watched = subject.watched()?;
    let page = if arguments.open { Some(Page::new(arguments.out.as_deref())?) } else { None };
    let on_terminal = io::stdout().is_terminal();
    let colour = console::colors_enabled();
    let mut opened = None;
    let mut first = true;
    // A window of another width is a change like any other.
    let look = || (subject.read().map_err(|failure| failure.in_words(false)), line_length());
    let has_arrived = |look: &(Result<Written, String>, usize)| look.0.is_ok();
    watch::watch(look, has_arrived, |(written, _)| {
        let preview = match written {
            Ok(written) => Preview::new(subject, written, numbers),
            Err(words) => Err(Failure::Said(words.trim_start_matches("error: ").trim_end().to_owned(), None)),
        };
        let shown = preview.and_then(|preview| match &page {
            None => Ok((preview.text()?, String::new(), preview.notes(colour))),
            Some(_) => Ok((String::new(), preview.html()?, preview.notes(colour))),
        });
        let (mut text, html, note) = match shown {
            Ok(shown) => shown,
            Err(failure) => (failure.in_words(colour), page::of_faults(&failure.in_words(false)), String::new()),
        };
        if let Some(page) = &page {
            page.write(&page::reloading(&html))?;
            let opened = *opened.get_or_insert_with(|| page.open().is_ok());
            let what = if opened { "the page is" } else { "no browser could be started: open" };
            text.push_str(&format!("{}{what} {}\n", if text.is_empty() { "" } else { "\n" }, page.path().display()));
        }
        let before = match (on_terminal, first) {
            (true, _) => "\u{1b}[2J\u{1b}[3J\u{1b}[H".to_owned(),
            (false, true) => String::new(),
            (false, false) => format!("{}\n", "═".repeat(line_length())),
        };
        first = false;
        let note = if note.is_empty() { note } else { format!("{note}\n") };
        print(&format!("{before}{text}\n{note}watching {watched}; Ctrl-C ends\n"))
    })
}

/// Which numbers are shown.
struct Numbers {
    /// Decides all choices; nothing for the numbers of the exercise itself.
    seed: Option<u64>,
    style: Option<StyleName>,
}

/// A question as it is previewed.
struct Preview {
    formats: Formats,
    paper: Paper,
    /// What must be mended, line by line, and how to learn more of it.
    amiss: Vec<String>,
    /// How to see the same numbers again.
    note: String,
}

impl Preview {
    fn new(subject: &Subject, written: &Written, numbers: &Numbers) -> Result<Preview, Failure> {
        let formats = Formats::with(written.templates.iter().cloned())?;
        let question = read_question(&subject.id, &written.source)?;
        let variant = numbers.of(&question)?;
        let printed = compose(&question, &variant, 1);
        let amiss = amiss(subject, &question, &variant, written);
        let paper =
            Paper { title: question.title.clone(), seed: numbers.seed, questions: vec![printed], ..Paper::default() };
        let note = match numbers.seed {
            None => "with the numbers of the exercise".to_owned(),
            Some(seed) => {
                let style = numbers.style.map(|style| format!(" --style {style}")).unwrap_or_default();
                format!("seed {seed}, style {}; `--seed {seed}{style}` shows the same numbers again", variant.style)
            }
        };
        Ok(Preview { formats, paper, amiss, note })
    }

    /// What there is to say besides, files of one's own that nothing uses among it.
    fn notes(&self, colour: bool) -> String {
        let amiss = self.amiss.iter().map(|line| format!("{line}\n")).collect::<String>();
        render_all(self.formats.warnings(), colour) + &amiss + &self.note
    }

    fn text(&self) -> Result<String, Failure> {
        self.format("text")
    }

    fn html(&self) -> Result<String, Failure> {
        self.format("html")
    }

    fn format(&self, name: &str) -> Result<String, Failure> {
        self.formats.preview(name, &self.paper, line_length())?.ok_or_else(|| {
            let message = format!("templates/{name}/format.toml names no template for previews");
            Failure::with_help(message, format!("say `preview = \"preview.…\"` in it, as the shipped `{name}` does"))
        })
    }
}

/// What is amiss with the question and shows in this variant, as `carom check` words it, and the command that tells where.
fn amiss(subject: &Subject, question: &Question, variant: &Variant, written: &Written) -> Vec<String> {
    let found = glance(question, variant);
    let told = found.iter().map(|finding| finding.diagnostic(&subject.id, &written.source));
    let mut lines: Vec<String> = told.map(|fault| format!("error: {}", fault.message)).collect();
    if !lines.is_empty() {
        lines.push(format!("`{}` says where each stands and what to try", subject.check()));
    }
    lines
}

impl Numbers {
    /// A variant of the question, the one that `carom sheet` deals first.
    fn of(&self, question: &Question) -> Result<Variant, Failure> {
        let Some(seed) = self.seed else {
            return reference(question)
                .map_err(|_| Failure::said(format!("the reference numbers of `{}` make no question", question.id)));
        };
        if let Some(style) = self.style.filter(|style| question.style(*style).is_none()) {
            let styles = listed(question.styles.iter().map(|style| style.name.name()));
            let message = format!("`{}` has no style `{style}`", question.id);
            return Err(Failure::with_help(message, format!("it has {styles}")));
        }
        Dealer::new(seed, self.style).next(question).ok_or_else(|| {
            Failure::with_help(
                format!("no numbers meet the requirements of `{}`", question.id),
                "give the parameters more values, or demand less in `require`",
            )
        })
    }
}
