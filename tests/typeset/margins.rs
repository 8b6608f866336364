//! Words and lines stay inside the margins that the page has set itself, and every font travels with the file.

use std::path::Path;
use std::process::Command;

use carom::diagram::Point;
use carom::paper::Paper;
use carom::render::RenderedFile;

use super::diagrams::TEX_POINTS;
use super::engine::{PDFLATEX, set_fully};
use super::ink::{Area, ink};
use super::papers::{editions, reference_set, strained, whole_bank};
use super::words::words;
use super::{folder, on_both, rendered, said};

/// By how many points something may stand out: half of a full stop.
const FORGIVEN: f64 = 1.0;

/// How near to the edge of a sheet a printer prints, in millimetres.
const EDGE: f64 = 8.0;

/// Makes LaTeX write down where it sets words.
fn telling(document: &RenderedFile) -> RenderedFile {
    let tell = "\\AtBeginDocument{\\typeout{margins \\the\\dimexpr1in+\\oddsidemargin\\relax\\space\
                \\the\\dimexpr1in+\\topmargin+\\headheight+\\headsep\\relax\\space\
                \\the\\textwidth\\space\\the\\textheight\\space\\the\\paperheight}}\n\\begin{document}";
    let contents = document.contents.replacen("\\begin{document}", tell, 1);
    RenderedFile { name: document.name.clone(), contents }
}

/// The body of each page, and the room below it for the foot, in points of a PDF.
fn places(log: &str) -> [Area; 2] {
    let told = log.lines().find_map(|line| line.strip_prefix("margins ")).expect("LaTeX tells its margins");
    let points = |length: &str| length.trim_end_matches("pt").parse::<f64>().unwrap() * 72.0 / TEX_POINTS;
    let lengths: Vec<f64> = told.split(' ').map(points).collect();
    let [left, top, width, height, sheet] = lengths.try_into().expect("five lengths");
    // the last line of a page hangs a little below it, and the foot keeps clear of that
    const HANGS: f64 = 4.0;
    let at = |x: f64, y: f64| Point { x, y };
    let body = Area { low: at(left, top), high: at(left + width, top + height + HANGS) };
    let foot = Area { low: at(left, body.high.y), high: at(left + width, sheet - EDGE / 25.4 * 72.0) };
    [body, foot].map(|place| place.grown(FORGIVEN))
}

/// What stands neither in the body nor in the foot; of each page the first of each kind.
fn outside(places: [Area; 2], pdf: &Path) -> Vec<String> {
    let [body, _] = places;
    let mut found = Vec::new();
    for (page, words) in (1..).zip(words(pdf)) {
        // a word's box is as high as its font says, and the fonts of roots and brackets say anything: see its letters
        let word = words.iter().find(|word| word.area.low.x < body.low.x || word.area.high.x > body.high.x);
        let ink = ink(pdf, page);
        let letter = ink.letters.iter().find(|letter| !places.iter().any(|place| place.covers(**letter)));
        let line = ink.lines.iter().flatten().find(|at| !places.iter().any(|place| place.holds(**at)));
        let said = [
            word.map(|word| format!("`{}` at {:?}", word.text, word.area)),
            letter.map(|at| format!("a letter at {at:?}")),
            line.map(|at| format!("a line at {at:?}")),
        ];
        found.extend(said.into_iter().flatten().map(|what| format!("page {page}: {what}")));
    }
    found
}

/// Fonts that do not travel with the file, or travel as pictures.
pub fn fonts(pdf: &Path) -> Vec<String> {
    if !pdf.exists() {
        return vec!["no pages and so no fonts".to_owned()];
    }
    poor_fonts(&said(Command::new("pdffonts").arg(pdf)))
}

fn poor_fonts(told: &str) -> Vec<String> {
    let rows = told.lines().skip(2);
    let poor = |row: &&str| {
        // from the right: object, generation, unicode, subset, embedded
        let embedded = row.split_whitespace().rev().nth(4);
        embedded != Some("yes") || row.contains("Type 3")
    };
    rows.filter(poor).map(str::to_owned).collect()
}

/// Everything that is wrong with a document's pages.
fn faults(name: &str, document: &RenderedFile) -> Vec<String> {
    let sheet = set_fully(PDFLATEX, &folder(name), &telling(document));
    let found = outside(places(&sheet.log), &sheet.pdf).into_iter().chain(fonts(&sheet.pdf));
    found.map(|fault| format!("{name}: {fault}")).collect()
}

#[test]
#[ignore = "needs TeX, poppler and Chromium, which `.ci/run` installs"]
fn carom_knows_pages_within_their_margins() {
    let mut work = Vec::new();
    for (edition, how) in editions() {
        let paper = if edition == "plain" { whole_bank() } else { reference_set() };
        for document in rendered("latex", &Paper { edition: how, ..paper }) {
            work.push((format!("margins/{edition}/{}", document.name), document));
        }
    }
    for document in rendered("latex", &strained()) {
        work.push((format!("margins/strained/{}", document.name), document));
    }
    let found = on_both(&work, |(name, document)| faults(name, document)).concat();
    assert!(found.is_empty(), "\n{}", found.join("\n"));
}

#[test]
#[ignore = "needs TeX, poppler and Chromium, which `.ci/run` installs"]
fn what_stands_in_a_margin_is_seen() {
    let document = rendered("latex", &reference_set()).remove(0);
    let planted = |before: &str, place: &str| {
        let contents = document.contents.replacen(place, &format!("{before}{place}"), 1);
        faults("margins/planted", &RenderedFile { contents, ..document.clone() })
    };
    let end = "\\end{document}";
    assert_eq!(planted("", end), [""; 0]);
    for (before, promised) in [
        (r"\noindent\rlap{\kern\textwidth\kern3pt astray}", "`astray`"),
        (r"\noindent\llap{astray\kern3pt}", "`astray`"),
        (r"\noindent\rlap{\vrule width\dimexpr\textwidth+5pt\relax height2pt}", "a line"),
        (r"\newpage\vbox to0pt{\kern-40pt\hbox{astray}\vss}", "a letter"),
    ] {
        let found = planted(before, end);
        assert!(found.iter().any(|fault| fault.contains(promised)), "{before} lacks {promised}: {found:?}");
    }
    let found = planted("\\pdfmapline{=cmr10 Times-Roman 4 <8r.enc}", "\\begin{document}");
    assert!(found.iter().any(|fault| fault.contains("Times-Roman")), "{found:?}");
}

#[test]
fn a_font_of_dots_is_seen() {
    let told = "name                                 type              encoding         emb sub uni object ID\n\
                ------------------------------------ ----------------- ---------------- --- --- --- ---------\n\
                EKJZTE+CMR10                         Type 1            Builtin          yes yes yes      4  0\n\
                Helvetica                            Type 1            WinAnsi          no  no  no       5  0\n\
                [none]                               Type 3            Custom           yes no  no       6  0";
    assert_eq!(poor_fonts(told).len(), 2, "{:?}", poor_fonts(told));
}
