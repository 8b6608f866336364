//! A class on paper: one file in class order, each sheet from page 1 under its name, and all answers on a single page.

use std::path::Path;
use std::process::Command;

use super::{folder, said};

#[test]
#[ignore = "needs TeX, poppler and Chromium, which `.ci/run` installs"]
fn a_class_of_thirty_is_one_print_job_with_a_key_of_one_page() {
    let folder = folder("class");
    let list = Path::new(env!("CARGO_MANIFEST_DIR")).join("examples/class.csv");
    let mut carom = Command::new(env!("CARGO_BIN_EXE_carom"));
    carom.current_dir(&folder).args(["sheet", "--seed", "7", "--format", "pdf", "--class"]).arg(&list);
    said(&mut carom);
    let text = |name: &str| {
        let pdf = folder.join("sheet").join(name);
        said(Command::new("pdftotext").arg("-layout").arg(pdf).arg("-"))
    };
    let pages = |name: &str| -> Vec<String> { text(name).split_terminator('\u{c}').map(str::to_owned).collect() };
    let list = std::fs::read_to_string(&list).unwrap();
    let names: Vec<String> = list
        .lines()
        .skip(1)
        .filter_map(|line| line.split_once(','))
        .map(|(id, name)| format!("{name} ({id})"))
        .collect();
    assert_eq!(names.len(), 30);
    for file in ["question-sheets.pdf", "mark-schemes.pdf", "worked-solutions-by-student.pdf"] {
        let pages = pages(file);
        let first: Vec<&String> = pages.iter().filter(|page| page.contains("Page 1 of")).collect();
        assert_eq!(first.len(), 30, "{file}");
        for (page, name) in first.iter().zip(&names) {
            assert!(plain(page).contains(&plain(name)), "{file}: {name} in\n{page}");
        }
    }
    let key = pages("teachers-key.pdf");
    assert_eq!(key.len(), 1, "the key has {} pages", key.len());
    let key = plain(&key[0]);
    assert!(names.iter().all(|name| key.contains(&plain(name))), "{key}");
}

/// TeX prints a typewriter's apostrophe as a printed one, and its oldest fonts an accent as a sign of its own, which is
/// read before its letter or after it, or as a letter with an accent.
fn plain(text: &str) -> String {
    let accents = [('á', 'a'), ('ë', 'e'), ('í', 'i'), ('ı', 'i')];
    let letter = |c: char| accents.iter().find(|(accented, _)| *accented == c).map_or(c, |(_, letter)| *letter);
    text.replace('’', "'").chars().filter(|c| !matches!(c, '\u{301}' | '\u{308}' | '´' | '¨')).map(letter).collect()
}
