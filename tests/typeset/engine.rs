//! A TeX engine at work on one document, and what it has against it.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use carom::paper::Paper;
use carom::render::RenderedFile;

use super::{rendered, run};

/// The engine that everybody has; the others are `lualatex` and `xelatex`.
pub const PDFLATEX: &str = "pdflatex";

/// A document that has been set.
pub struct Sheet {
    /// Its name without its ending.
    pub name: String,
    /// The pages; there need be none if the engine failed.
    pub pdf: PathBuf,
    /// All that the engine wrote down.
    pub log: String,
}

/// Sets a document once, in a folder. One run settles the layout; a second one knows the number of pages too.
pub fn set(engine: &str, folder: &Path, document: &RenderedFile) -> Sheet {
    let source = folder.join(&document.name);
    fs::write(&source, &document.contents).unwrap();
    let mut command = Command::new(engine);
    // unbroken lines, so that each complaint is one
    command.env("max_print_line", "1000").args(["-recorder", "-interaction=nonstopmode", &document.name]);
    run(command.current_dir(folder));
    let log = fs::read(source.with_extension("log")).unwrap_or_default();
    let name = source.file_stem().unwrap().to_string_lossy().into_owned();
    Sheet { name, pdf: source.with_extension("pdf"), log: String::from_utf8_lossy(&log).into_owned() }
}

/// Sets a document as often as it asks for, twice at least, so that it knows its own pages.
pub fn set_fully(engine: &str, folder: &Path, document: &RenderedFile) -> Sheet {
    set(engine, folder, document);
    set(engine, folder, document)
}

impl Sheet {
    /// What the engine has against the document.
    pub fn complaints(&self) -> Vec<String> {
        let said = self.log.lines().filter(|line| is_complaint(line));
        let unprinted = (!self.log.contains("Output written on")).then_some("no pages were written");
        said.chain(unprinted).map(|line| format!("{}: {line}", self.name)).collect()
    }
}

/// An error, a warning, a letter that the font lacks, or a line that is wider than its place by more than the eye
/// forgives.
fn is_complaint(line: &str) -> bool {
    const FORGIVEN: f64 = 2.0;
    if let Some(rest) = line.strip_prefix(r"Overfull \hbox (") {
        return rest
            .split("pt")
            .next()
            .and_then(|width| width.parse::<f64>().ok())
            .is_none_or(|width| width > FORGIVEN);
    }
    let spoken = ["Overfull", "Warning", "warning", "Missing character"];
    // packages call themselves by what they do: `Package: infwarerr … Providing info/warning/error messages`
    let is_name = line.starts_with("Package: ") || line.starts_with('(');
    line.starts_with('!') || (!is_name && spoken.iter().any(|word| line.contains(word)))
}

/// What pdflatex has against all documents of a paper, set once.
pub fn complaints(folder: &Path, paper: &Paper) -> Vec<String> {
    rendered("latex", paper).iter().flat_map(|document| set(PDFLATEX, folder, document).complaints()).collect()
}

/// The questions that a paper's complaints are about, by their places, each with the first complaint.
///
/// A paper that complains is halved until single questions complain: no template has to say where it is. What no half
/// says again is about the paper as a whole.
pub fn placed(paper: &Paper, judge: &dyn Fn(&Paper) -> Vec<String>) -> Vec<(Option<usize>, String)> {
    placed_from(0, paper, judge)
}

fn placed_from(first: usize, paper: &Paper, judge: &dyn Fn(&Paper) -> Vec<String>) -> Vec<(Option<usize>, String)> {
    let Some(complaint) = judge(paper).into_iter().next() else { return Vec::new() };
    if paper.questions.len() < 2 {
        return vec![(Some(first), complaint)];
    }
    let middle = paper.questions.len() / 2;
    let half = |questions: &[_]| Paper { questions: questions.to_vec(), ..paper.clone() };
    let mut found = placed_from(first, &half(&paper.questions[..middle]), judge);
    // a style that fails does so in many ways, and two of them tell
    if found.len() < 2 {
        found.extend(placed_from(first + middle, &half(&paper.questions[middle..]), judge));
    }
    if found.is_empty() { vec![(None, complaint)] } else { found }
}

#[test]
fn a_complaint_of_an_engine_is_seen() {
    for line in [
        r"Overfull \hbox (2.5pt too wide) in paragraph at lines 3--4",
        r"Overfull \vbox (0.5pt too high) has occurred while \output is active",
        "LaTeX Warning: There were undefined references.",
        "Package longtable Warning: Table widths have changed. Rerun LaTeX.",
        "pdfTeX warning: pdflatex: no such map",
        "Missing character: There is no ž in font cmr10!",
        "! Undefined control sequence.",
    ] {
        assert!(is_complaint(line), "{line}");
    }
    for line in [
        r"Overfull \hbox (1.5pt too wide) in paragraph at lines 3--4",
        "Underfull \\hbox (badness 10000) in paragraph at lines 3--4",
        "Package: infwarerr 2019/12/03 v1.5 Providing info/warning/error messages (HO)",
    ] {
        assert!(!is_complaint(line), "{line}");
    }
}

#[test]
#[ignore = "needs TeX, poppler and Chromium, which `.ci/run` installs"]
fn a_complaint_is_placed_to_its_question() {
    let mut paper = super::papers::strained();
    paper.questions[5].stem[0].0.push(carom::expr::Piece::Words("x".repeat(200)));
    let folder = super::folder("placed");
    let found = placed(&paper, &|paper| complaints(&folder, paper));
    assert_eq!(found.iter().map(|(place, _)| *place).collect::<Vec<_>>(), [Some(5)], "{found:?}");
    assert!(found[0].1.starts_with(r"question-sheet: Overfull \hbox ("), "{found:?}");
}
