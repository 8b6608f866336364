//! Three engines set the same sheets, and pdflatex does with the two packages that are promised.

use std::collections::BTreeSet;
use std::fs;
use std::path::Path;
use std::process::Command;

use carom::paper::Paper;

use super::engine::{PDFLATEX, Sheet, set_fully};
use super::margins::fonts;
use super::papers::{editions, reference_set, strained};
use super::{folder, on_both, rendered, run, said};

const ENGINES: [&str; 3] = [PDFLATEX, "lualatex", "xelatex"];

#[test]
#[ignore = "needs TeX, poppler and Chromium, which `.ci/run` installs"]
fn carom_knows_latex_for_three_engines() {
    let mut work = Vec::new();
    for engine in ENGINES {
        for (edition, how) in editions() {
            let paper = Paper { edition: how, ..reference_set() };
            work.extend(rendered("latex", &paper).into_iter().map(|document| (engine, edition, document)));
        }
        work.extend(rendered("latex", &strained()).into_iter().map(|document| (engine, "strained", document)));
    }
    let complaints = on_both(&work, |(engine, edition, document)| {
        let folder = folder(&format!("engines/{engine}/{edition}/{}", document.name));
        let sheet = set_fully(engine, &folder, document);
        let complaints = sheet.complaints().into_iter().chain(fonts(&sheet.pdf));
        complaints.map(|said| format!("{engine}, {edition}: {said}")).collect::<Vec<_>>()
    });
    println!("{} documents set", work.len());
    assert!(complaints.iter().all(Vec::is_empty), "\n{}", complaints.concat().join("\n"));
}

/// What a machine has on which the two promised packages have been installed.
fn promised() -> BTreeSet<String> {
    let mut known = BTreeSet::new();
    let mut open = vec!["texlive-latex-base".to_owned(), "texlive-pictures".to_owned()];
    while let Some(package) = open.pop() {
        // what is not there is one of several, and another one is
        let told = run(Command::new("dpkg-query").args(["-W", "-f", "${Depends}", &package]));
        if told.status.success() && known.insert(package) {
            let told = String::from_utf8_lossy(&told.stdout).into_owned();
            open.extend(
                told.split([',', '|'])
                    .filter_map(|one| Some(one.split([' ', ':']).find(|word| !word.is_empty())?.to_owned())),
            );
        }
    }
    known
}

/// The packages of the system from which the engine took the files that it read, by its own record.
fn packages(folder: &Path, sheet: &Sheet) -> BTreeSet<String> {
    let record = fs::read_to_string(folder.join(&sheet.name).with_extension("fls")).unwrap();
    let read = record.lines().filter_map(|line| line.strip_prefix("INPUT "));
    // what the machine made when the packages came, such as the format, belongs to none
    let installed = read.filter(|path| path.starts_with("/usr/")).map(|path| fs::canonicalize(path).unwrap());
    let installed: BTreeSet<_> = installed.collect();
    assert!(installed.len() > 30, "{record}");
    let owners = said(Command::new("dpkg").arg("-S").args(&installed));
    owners.lines().filter_map(|line| Some(line.split_once(": ")?.0.to_owned())).collect()
}

#[test]
#[ignore = "needs TeX, poppler and Chromium, which `.ci/run` installs"]
fn carom_knows_latex_that_needs_two_packages() {
    let (folder, promised) = (folder("two-packages"), promised());
    for document in rendered("latex", &reference_set()) {
        let packages = packages(&folder, &set_fully(PDFLATEX, &folder, &document));
        let more: Vec<_> = packages.difference(&promised).collect();
        assert!(more.is_empty(), "{} needs {more:?}", document.name);
        assert!(packages.contains("texlive-latex-base"), "{packages:?}");
    }
}

#[test]
#[ignore = "needs TeX, poppler and Chromium, which `.ci/run` installs"]
fn a_package_that_is_not_promised_is_seen() {
    let folder = folder("one-package-more");
    let mut document = rendered("latex", &reference_set()).remove(0);
    document.contents = document.contents.replacen(r"\begin{document}", "\\usepackage{luatex85}\\begin{document}", 1);
    let packages = packages(&folder, &set_fully(PDFLATEX, &folder, &document));
    assert_eq!(packages.difference(&promised()).collect::<Vec<_>>(), ["texlive-luatex"]);
}
