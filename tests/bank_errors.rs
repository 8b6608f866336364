//! Every fault of a question file as a teacher sees it: `tests/errors/NAME.toml` gives `tests/errors/NAME.txt`; and of a
//! profile for marking, in `tests/errors/profiles`.
//!
//! `CAROM_ACCEPT=1 cargo test --test bank_errors` writes the expected texts anew; read them before you keep them.

use std::fs;
use std::path::{Path, PathBuf};

use carom::bank::{read_question, read_source};
use carom::diagnostic::{Source, render_all};
use carom::mark::Profile;

fn files() -> Vec<PathBuf> {
    files_in("tests/errors")
}

fn files_in(folder: &str) -> Vec<PathBuf> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join(folder);
    let mut files: Vec<PathBuf> = fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path()).collect();
    files.retain(|path| path.extension().is_some_and(|extension| extension == "toml"));
    files.sort();
    files
}

fn faults_of(path: &Path) -> String {
    let name = path.file_stem().unwrap().to_string_lossy().into_owned();
    let faults = match read_source(path) {
        Ok(source) => read_question(&name, &Source::new(format!("{name}.toml"), source.text)).err().unwrap_or_default(),
        Err(faults) => faults,
    };
    // The same picture wherever the tests are.
    let folder = format!("{}/", path.parent().unwrap().display());
    render_all(&faults, false).replace(&folder, "")
}

#[test]
fn carom_tells_a_teacher_what_is_wrong_with_a_question_file() {
    files().iter().for_each(|path| is_as_accepted(path, &faults_of(path)));
}

#[test]
fn carom_tells_a_teacher_what_is_wrong_with_a_profile() {
    let files = files_in("tests/errors/profiles");
    assert!(files.len() >= 10);
    for path in files {
        let name = path.file_name().unwrap().to_string_lossy().into_owned();
        let faults = Profile::read(&Source::new(name, fs::read_to_string(&path).unwrap())).unwrap_err();
        assert!(faults.iter().all(|fault| fault.help.is_some() && !fault.label.is_empty()), "{}", path.display());
        is_as_accepted(&path, &render_all(&faults, false));
    }
}

fn is_as_accepted(path: &Path, shown: &str) {
    let expected = path.with_extension("txt");
    if std::env::var_os("CAROM_ACCEPT").is_some() {
        fs::write(&expected, shown).unwrap();
    }
    let wanted = fs::read_to_string(&expected).unwrap_or_default();
    assert_eq!(shown, wanted, "{} differs; see the head of this file", path.display());
}

#[test]
fn every_fault_says_what_was_expected_and_one_thing_to_try() {
    for path in files() {
        for fault in faults_of(&path).split("error: ").skip(1) {
            assert!(fault.contains("\nhelp: "), "{}: {fault}", path.display());
        }
    }
}

#[test]
fn carom_finds_something_wrong_with_every_file_but_the_sound_one() {
    let files = files();
    assert!(files.len() >= 21);
    for path in files {
        let sound = path.file_stem().is_some_and(|name| name == "sound");
        assert_eq!(faults_of(&path).is_empty(), sound, "{}", path.display());
    }
}

/// What a bracket that is never closed once led to: eighty-nine findings.
#[test]
fn one_slip_of_the_pen_is_one_fault() {
    let single = [
        "answers-misspelt",
        "asked-for-twice",
        "brace-never-closed",
        "brace-of-the-line-before",
        "comma-forgotten",
        "condition-as-a-sentence",
        "condition-misspelt",
        "depends-on-nothing",
        "derived-beside-parameter",
        "empty",
        "empty-title",
        "empty-words",
        "heading-never-closed",
        "hidden-slips-misspelt",
        "key-below-parameters",
        "later-line-of-centres-missing",
        "later-mass-given-again",
        "later-newcomer-without-mass",
        "later-newcomer-without-velocity",
        "later-one-sphere-without-wall",
        "later-quantity-of-no-impact",
        "later-struck-by-nobody",
        "later-unknown-sphere",
        "later-wall-along-the-line",
        "later-wall-with-two-spheres",
        "later-without-of",
        "list-never-closed",
        "marks-never-closed",
        "no-part",
        "not-equal-misspelt",
        "parameters-misspelt",
        "quotes-forgotten",
        "reference-missing",
        "rule-of-acceptance-that-is-none",
        "second-component-tested",
        "stem-never-closed",
        "stem-never-opened",
        "step-of-calculus",
        "table-never-closed",
        "unit-misspelt",
        "unknown-that-is-given",
        "words-alone",
    ];
    let is_single = |path: &PathBuf| path.file_stem().is_some_and(|name| single.iter().any(|one| name == *one));
    let tried: Vec<PathBuf> = files().into_iter().filter(is_single).collect();
    assert_eq!(tried.len(), single.len(), "{tried:?}");
    for path in tried {
        let faults = faults_of(&path).matches("error:").count();
        let allowed = if path.ends_with("quotes-forgotten.toml") { 2 } else { 1 };
        assert!((1..=allowed).contains(&faults), "{}: {faults} faults", path.display());
    }
}

#[test]
fn a_file_full_of_slips_is_told_a_page_of_them() {
    let text = "u = = 1\n".repeat(20_000);
    let faults = read_question("q", &Source::new("q.toml", text)).unwrap_err();
    assert_eq!(faults.len(), 20);
}

#[test]
fn what_is_no_text_file_is_not_read() {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("no-text");
    fs::create_dir_all(folder.join("folder.toml")).unwrap();
    fs::write(folder.join("long.toml"), "#".repeat(100_001)).unwrap();
    for (name, said) in [("folder", "is no file"), ("long", "longer than"), ("absent", "`carom new-question ")] {
        let fault = read_source(&folder.join(format!("{name}.toml"))).unwrap_err()[0].to_string();
        assert!(fault.contains(said) && fault.contains("help:"), "{fault}");
    }
}
