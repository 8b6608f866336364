//! The pages in a real browser: formulas, diagrams and margins measured, on a desk, on a phone and on A4.

use carom::diagram::{Diagram, Drawing, Point, svg};
use carom::paper::{Edition, Paper};
use carom::render::RenderedFile;

use super::browser::{Picture, Seen, printed, seen};
use super::clear::faults;
use super::diagrams::{diagrams, of_solution, planted, sphere};
use super::ink::{Area, Ink};
use super::papers::{empty, strained, whole_bank};
use super::words::{Word, words};
use super::{folder, on_both, rendered};

/// The papers that are looked at, by name.
fn papers() -> [(&'static str, Paper); 3] {
    let large_print =
        Paper { edition: Edition { large_print: true, answer_space: true, ..Edition::default() }, ..whole_bank() };
    [("bank", whole_bank()), ("large-print", large_print), ("strained", strained())]
}

/// The ink of a picture in the places of its drawing.
fn in_ems(drawing: &Drawing, picture: &Picture) -> Ink {
    let em = drawing.high.x - drawing.low.x;
    let placed = |[x, y]: [f64; 2]| Point { x: drawing.low.x + x * em, y: drawing.high.y - y * em };
    let lines = picture.lines.iter().map(|line| line.iter().copied().map(placed).collect()).collect();
    let letters = picture.letters.iter().map(|corners| Area::around(corners.map(placed)).expect("two corners"));
    Ink { lines, letters: letters.collect() }
}

/// What is wrong with diagrams as a browser shows them, in order.
fn unclear<'d>(drawings: impl IntoIterator<Item = &'d Drawing>, seen: &Seen) -> Vec<Vec<String>> {
    let pairs = drawings.into_iter().zip(&seen.diagrams);
    pairs.map(|(drawing, picture)| faults(drawing, &in_ems(drawing, picture))).collect()
}

/// The diagrams that a document shows, in its order: those of the questions or those of the solutions.
fn shown(paper: &Paper, count: usize) -> Vec<(String, Diagram)> {
    let questions = diagrams(paper, |question| question.diagrams.iter().collect());
    let solutions = diagrams(paper, of_solution);
    let fitting = [Vec::new(), questions, solutions].into_iter().find(|diagrams| diagrams.len() == count);
    fitting.unwrap_or_else(|| panic!("{count} diagrams are neither those of the questions nor of the solutions"))
}

/// Everything that is wrong with a page on a desk and on a phone.
fn on_screen(paper: &Paper, page: &RenderedFile, all: &[Seen]) -> Vec<String> {
    let mut found = Vec::new();
    for seen in all {
        let mut say = |fault: String| found.push(format!("{} at {} pixels: {fault}", page.name, seen.width));
        if seen.reach > seen.window {
            say(format!("reaches {} pixels far in a window of {}", seen.reach, seen.window));
        }
        seen.faults.iter().cloned().for_each(&mut say);
        let diagrams = shown(paper, seen.diagrams.len());
        let drawings = diagrams.iter().map(|(_, diagram)| &diagram.drawing);
        for (((name, _), picture), faults) in diagrams.iter().zip(&seen.diagrams).zip(unclear(drawings, seen)) {
            if picture.width > f64::from(seen.window) {
                say(format!("{name}: is {} pixels wide", picture.width));
            }
            faults.into_iter().for_each(|fault| say(format!("{name}: {fault}")));
        }
    }
    found
}

/// Words of the printed page beyond the margins at its sides, and pages without any.
pub fn on_a4(name: &str, page: &RenderedFile, margins: &[String; 4]) -> Vec<String> {
    let points = |length: &String| {
        let millimetres: f64 = length.strip_suffix("mm").and_then(|number| number.parse().ok()).expect("millimetres");
        millimetres / 25.4 * 72.0
    };
    let [_, right, bottom, left] = margins.each_ref().map(points);
    let [wide, high] = ["210mm", "297mm"].map(|length| points(&length.to_owned()));
    let mut found = Vec::new();
    for (number, words) in (1..).zip(words(&printed(&folder(name), page, margins))) {
        if words.is_empty() {
            found.push(format!("{}: page {number} is empty", page.name));
        }
        // what stands at the foot of the sheet stands in its margin by intent
        for Word { text, area } in words.into_iter().filter(|word| word.area.middle().y < high - bottom) {
            if area.low.x < left - 1.0 || area.high.x > wide - right + 1.0 {
                found.push(format!("{}: page {number}: `{text}` at {area:?}", page.name));
            }
        }
    }
    found
}

#[test]
#[ignore = "needs TeX, poppler and Chromium, which `.ci/run` installs"]
fn carom_knows_pages_that_a_browser_shows_as_they_are_meant() {
    let mut work = Vec::new();
    for (name, paper) in papers() {
        work.extend(rendered("html", &paper).into_iter().map(|page| (name, paper.clone(), page)));
    }
    let found = on_both(&work, |(name, paper, page)| {
        let folder = format!("screen/{name}/{}", page.name);
        let all = seen(&super::folder(&folder), page);
        let seen = &all[0];
        println!("{name}/{}: {} formulas, {} diagrams", page.name, seen.formulas, seen.diagrams.len());
        assert!(seen.formulas > 10 && seen.fractions > 1, "{name}/{}: {seen:?}", page.name);
        let mut found = on_screen(paper, page, &all);
        found.extend(on_a4(&format!("{folder}/printed"), page, &seen.margins));
        found.into_iter().map(|fault| format!("{name}: {fault}")).collect::<Vec<_>>()
    });
    assert!(found.iter().all(Vec::is_empty), "\n{}", found.concat().join("\n"));
}

#[test]
#[ignore = "needs TeX, poppler and Chromium, which `.ci/run` installs"]
fn carom_knows_diagrams_that_are_clear_in_the_letters_that_a_page_falls_back_to() {
    let paper = whole_bank();
    let mut pages = rendered("html", &paper);
    pages.retain(|page| page.contents.contains("<svg"));
    assert!(pages.len() > 1);
    let found = on_both(&pages, |page| {
        let page = in_fallback(page);
        // no phone has these letters
        let on_desk = seen(&folder(&format!("screen/fallback/{}", page.name)), &page).remove(0);
        on_screen(&paper, &page, &[on_desk])
    });
    assert!(found.iter().all(Vec::is_empty), "\n{}", found.concat().join("\n"));
}

/// A page whose diagrams have the widest letters that a machine without the fonts of `style.css` is likely to give them.
fn in_fallback(page: &RenderedFile) -> RenderedFile {
    let style = "<style>svg text { font-family: \"DejaVu Serif\" }</style>\n</head>";
    RenderedFile { name: page.name.clone(), contents: page.contents.replacen("</head>", style, 1) }
}

/// A page of our own, with what is to be found in it.
fn page(body: &str) -> RenderedFile {
    let style = "@page { size: A4; margin: 18mm 18mm 20mm } .narrow { width: 20px; overflow: hidden }";
    let contents = format!("<!DOCTYPE html><meta charset=\"utf-8\"><style>{style}</style><body>{body}</body>");
    RenderedFile { name: "planted.html".into(), contents }
}

#[test]
#[ignore = "needs TeX, poppler and Chromium, which `.ci/run` installs"]
fn a_formula_that_is_not_as_it_is_meant_is_seen() {
    let fraction = "<math><mfrac><mi>a</mi><mi>b</mi></mfrac></math>";
    let long = format!("<math><mrow>{}</mrow></math>", "<mi>x</mi><mo>+</mo>".repeat(300));
    for (body, promised) in [
        (format!("<p>{fraction}</p>"), ""),
        ("<p><math></math></p>".to_owned(), "fills 0 by"),
        ("<p><math><merror><mtext>what</mtext></merror></math></p>".to_owned(), "is an error"),
        (
            format!("<style>mfrac {{ display: inline }} mi {{ display: inline }}</style><p>{fraction}</p>"),
            "without a bar",
        ),
        (format!("<p>{long}</p>"), "reaches"),
        (format!("<p class=\"narrow\">{long}</p>"), "is cut off at a side"),
        (format!("<p style=\"height: 5px; overflow: hidden\">{fraction}</p>"), "is cut off above or below"),
        ("<p style=\"width: 900px\">wide</p>".to_owned(), "at 360 pixels: reaches"),
    ] {
        let page = page(&body);
        let all = seen(&folder("screen/planted"), &page);
        let found = on_screen(&Paper::default(), &page, &all);
        match promised {
            "" => assert_eq!(found, [""; 0]),
            promised => {
                assert!(found.iter().any(|fault| fault.contains(promised)), "{body} lacks {promised}: {found:?}")
            }
        }
    }
}

#[test]
#[ignore = "needs TeX, poppler and Chromium, which `.ci/run` installs"]
fn what_is_not_clear_on_screen_is_seen() {
    let planted: Vec<(Drawing, &str)> = [(sphere(), "")].into_iter().chain(planted()).collect();
    let element = |drawing: &Drawing| {
        let diagram = Diagram { title: String::new(), drawing: drawing.clone(), words: "a sphere".into() };
        format!("<p>{}</p>", svg(&diagram))
    };
    let body: String = planted.iter().map(|(drawing, _)| element(drawing)).collect();
    // in the letters of a real page
    let mut page = rendered("html", &empty()).remove(0);
    page.contents = page.contents.replacen("</main>", &format!("{body}</main>"), 1);
    let seen = seen(&folder("screen/planted-diagrams"), &page).remove(0);
    assert_eq!(seen.diagrams.len(), planted.len());
    let drawings = planted.iter().map(|(drawing, _)| drawing);
    for ((_, promised), found) in planted.iter().zip(unclear(drawings, &seen)) {
        match *promised {
            "" => assert_eq!(found, [""; 0]),
            promised => assert!(found.iter().any(|fault| fault.contains(promised)), "lacks `{promised}`: {found:?}"),
        }
    }
}

#[test]
#[ignore = "needs TeX, poppler and Chromium, which `.ci/run` installs"]
fn a_printed_word_in_a_margin_is_seen() {
    let body = |style: &str| page(&format!("<p style=\"{style}\">astray</p>"));
    let margins = ["18mm", "18mm", "20mm", "18mm"].map(str::to_owned);
    assert_eq!(on_a4("screen/margin-kept", &body(""), &margins), [""; 0]);
    for style in ["margin-left: -40px", "text-align: right; margin-right: -40px", "margin-left: 700px"] {
        let found = on_a4("screen/margin-lost", &body(style), &margins);
        assert!(found.iter().any(|fault| fault.contains("`astray`")), "{style}: {found:?}");
    }
    let found = on_a4("screen/empty", &body("page-break-before: always; visibility: hidden"), &margins);
    assert!(found.iter().any(|fault| fault.ends_with("is empty")), "{found:?}");
}
