//! What is really on paper and on screen: pages set by TeX engines and by a browser, then measured.
//!
//! Each file holds one promise and shows that its check can fail. `.ci/run` installs what they need; alone they run by
//! `cargo test --release --test typeset -- --ignored`, and `--show-output` says how much was set.

#[path = "../pages/paper.rs"]
mod by_hand;
#[path = "../pages/class.rs"]
mod class;

mod breaks;
mod browser;
mod by_student;
mod chromium;
mod clear;
mod diagrams;
mod engine;
mod engines;
mod feedback;
mod ink;
mod margins;
mod on_both;
mod papers;
mod screen;
mod variants;
mod words;

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

use carom::paper::Paper;
use carom::render::{Formats, RenderedFile};
use on_both::on_both;

/// A folder of its own, empty.
fn folder(name: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("typeset").join(name);
    let _ = fs::remove_dir_all(&folder);
    fs::create_dir_all(&folder).unwrap();
    folder
}

/// All documents of a paper, whichever the format has.
fn rendered(format: &str, paper: &Paper) -> Vec<RenderedFile> {
    let documents = Formats::shipped().unwrap().render(format, paper).unwrap();
    assert!(documents.len() > 1, "{format} has no more than {} document", documents.len());
    documents
}

/// What a program printed and how it ended.
fn run(command: &mut Command) -> Output {
    match command.output() {
        Ok(output) => output,
        Err(error) => panic!("{:?} cannot be run, and `.ci/run` installs it: {error}", command.get_program()),
    }
}

/// What a program printed; it has to succeed.
fn said(command: &mut Command) -> String {
    let output = run(command);
    assert!(output.status.success(), "{command:?}:\n{}", String::from_utf8_lossy(&output.stderr));
    String::from_utf8_lossy(&output.stdout).into_owned()
}
