//! Every diagram on paper: pdflatex prints what its drawing says, and no label touches another or a stroke.

use std::fmt::Write;
use std::path::PathBuf;

use carom::diagram::{Diagram, Drawing, Label, Point, Section, Stroke, Style, tikz};
use carom::expr::Text;
use carom::paper::{Edition, Paper, PrintedQuestion};
use carom::render::RenderedFile;

use super::clear::{as_meant, faults};
use super::engine::{PDFLATEX, set};
use super::ink::{Ink, ink};
use super::papers::{empty, whole_bank};
use super::{folder, on_both, rendered};

/// White around each picture, in points of TeX, so that what leaves it is seen.
const AROUND: f64 = 40.0;

/// In one inch there are so many points of TeX, and 72 of a PDF.
pub const TEX_POINTS: f64 = 72.27;

/// The pictures of a question's solution, in the order in which they stand in it.
pub fn of_solution(question: &PrintedQuestion) -> Vec<&Diagram> {
    question.solution_diagrams.iter().chain(question.parts.iter().flat_map(|part| &part.solution_diagrams)).collect()
}

/// Diagrams of a paper's questions, each with what it is called.
pub fn diagrams(paper: &Paper, of: impl Fn(&PrintedQuestion) -> Vec<&Diagram>) -> Vec<(String, Diagram)> {
    let each = paper.questions.iter().flat_map(|question| {
        let named = |diagram: &Diagram| format!("{} ({}) {}", question.id, question.number, diagram.title);
        of(question).into_iter().map(move |diagram| (named(diagram), diagram.clone()))
    });
    each.collect()
}

/// Drawings set by themselves, one a page, with the shipped documents' own preamble; and the length of an em in points
/// of TeX.
fn pages(name: &str, edition: Edition, drawings: &[&Drawing]) -> (PathBuf, f64) {
    let document = rendered("latex", &Paper { edition, ..empty() }).remove(0);
    let (mut contents, _) = document.contents.split_once(r"\begin{document}").map(|(a, b)| (a.to_owned(), b)).unwrap();
    contents += "\\begin{document}\n\\typeout{one em is \\the\\dimexpr1em\\relax}\n";
    // At their own size: what is wider than a line of large print is drawn a little smaller there.
    contents += "\\linewidth=\\maxdimen\n";
    writeln!(contents, "\\pdfhorigin={AROUND}pt \\pdfvorigin={AROUND}pt").unwrap();
    for drawing in drawings {
        let wide = 2.0 * AROUND;
        write!(
            contents,
            "\\setbox0\\hbox{{{}}}\n\\pdfpagewidth=\\dimexpr\\wd0+{wide}pt\\relax\n\
             \\pdfpageheight=\\dimexpr\\ht0+\\dp0+{wide}pt\\relax\n\\shipout\\box0\n",
            tikz(drawing)
        )
        .unwrap();
    }
    contents += "\\end{document}\n";
    let sheet = set(PDFLATEX, &folder(name), &RenderedFile { name: "pictures.tex".into(), contents });
    assert!(sheet.complaints().is_empty(), "{}", sheet.complaints().join("\n"));
    let em = sheet.log.split("one em is ").nth(1).and_then(|rest| rest.split("pt").next()?.parse().ok());
    (sheet.pdf, em.expect("an em has a length"))
}

/// The ink of a page in the places of its drawing: in ems, y upwards.
fn in_ems(drawing: &Drawing, em: f64, mut ink: Ink) -> Ink {
    let scale = TEX_POINTS / 72.0 / em;
    let placed = |at: &mut Point| {
        let around = AROUND / em;
        *at = Point { x: drawing.low.x + at.x * scale - around, y: drawing.high.y - (at.y * scale - around) };
    };
    ink.lines.iter_mut().flatten().for_each(placed);
    for letter in &mut ink.letters {
        placed(&mut letter.low);
        placed(&mut letter.high);
        std::mem::swap(&mut letter.low.y, &mut letter.high.y);
    }
    ink
}

/// What is wrong with drawings on paper, each fault with the place of its drawing.
pub fn on_paper(name: &str, edition: Edition, drawings: &[&Drawing]) -> Vec<(usize, String)> {
    let (pdf, em) = pages(name, edition, drawings);
    let numbered: Vec<(usize, &Drawing)> = drawings.iter().copied().enumerate().collect();
    let found = on_both(&numbered, |(place, drawing)| {
        let faults = faults(drawing, &in_ems(drawing, em, ink(&pdf, place + 1)));
        faults.into_iter().map(|fault| (*place, fault)).collect::<Vec<_>>()
    });
    found.concat()
}

#[test]
#[ignore = "needs TeX, poppler and Chromium, which `.ci/run` installs"]
fn carom_knows_diagrams_that_are_clear_on_paper() {
    let bank = whole_bank();
    let mut diagrams = diagrams(&bank, |question| question.diagrams.iter().collect());
    diagrams.extend(self::diagrams(&bank, of_solution));
    assert!(!diagrams.is_empty());
    let drawings: Vec<&Drawing> = diagrams.iter().map(|(_, diagram)| &diagram.drawing).collect();
    for (edition, large_print) in [("plain", false), ("large", true)] {
        let how = Edition { large_print, ..Edition::default() };
        let found = on_paper(&format!("diagrams-{edition}"), how, &drawings);
        let named = |(place, fault): &(usize, String)| format!("{edition} {}: {fault}", diagrams[*place].0);
        assert!(found.is_empty(), "\n{}", found.iter().map(named).collect::<Vec<_>>().join("\n"));
    }
    println!("{} diagrams measured on paper", diagrams.len());
}

/// A sphere with its name in it, an arrow with its speed above it, and the line of centres.
pub fn sphere() -> Drawing {
    let at = |x: f64, y: f64| Point { x, y };
    let line = |style, from, to| Stroke { style, from, pieces: vec![Section::Line(to)] };
    let (r, k) = (2.0, 2.0 * 0.552_285);
    let quarter = |a: Point, b: Point, c: Point| Section::Curve(a, b, c);
    let rim = Stroke {
        style: Style::Rim,
        from: at(8.0 + r, 3.0),
        pieces: vec![
            quarter(at(8.0 + r, 3.0 + k), at(8.0 + k, 3.0 + r), at(8.0, 3.0 + r)),
            quarter(at(8.0 - k, 3.0 + r), at(8.0 - r, 3.0 + k), at(8.0 - r, 3.0)),
            quarter(at(8.0 - r, 3.0 - k), at(8.0 - k, 3.0 - r), at(8.0, 3.0 - r)),
            quarter(at(8.0 + k, 3.0 - r), at(8.0 + r, 3.0 - k), at(8.0 + r, 3.0)),
        ],
    };
    let head = vec![Section::Line(at(5.5, 3.2)), Section::Line(at(5.5, 2.8)), Section::Line(at(6.0, 3.0))];
    let label = |text: &str, centre, wide: f64| {
        let text = carom::expr::read_markup(text).unwrap().remove(0);
        Label { text, centre, size: at(wide, 1.1) }
    };
    Drawing {
        strokes: vec![
            line(Style::Centres, at(0.0, 3.0), at(12.0, 3.0)),
            rim,
            line(Style::Velocity, at(2.0, 3.0), at(5.8, 3.0)),
            Stroke { style: Style::Filled, from: at(6.0, 3.0), pieces: head },
        ],
        labels: vec![label("*A*", at(8.0, 2.2), 0.8), label("{6 m/s}", at(3.5, 4.0), 3.0)],
        low: at(0.0, 0.0),
        high: at(12.0, 6.0),
    }
}

/// Drawings that are wrong, and what is found.
pub fn planted() -> Vec<(Drawing, &'static str)> {
    let moved = |label: usize, x: f64, y: f64| {
        let mut drawing = sphere();
        drawing.labels[label].centre = Point { x, y };
        drawing
    };
    let mut narrow = sphere();
    narrow.labels[1].size.x = 1.0;
    vec![
        (moved(1, 8.0, 3.0), "touches"),
        (moved(1, 3.5, 3.0), "touches a stroke: Velocity"),
        (moved(1, 8.0, 5.0), "touches a stroke: Rim"),
        (moved(0, 11.0, 3.0), "touches a stroke: Centres"),
        (moved(1, 8.0, 2.4), "touches"),
        (moved(1, 11.0, 5.0), "leaves the picture"),
        (narrow, "more than"),
    ]
}

#[test]
#[ignore = "needs TeX, poppler and Chromium, which `.ci/run` installs"]
fn what_is_not_clear_on_paper_is_seen() {
    assert_eq!(on_paper("diagrams-right", Edition::default(), &[&sphere()]), []);
    assert_eq!(faults(&sphere(), &as_meant(&sphere())), [""; 0]);
    let planted = planted();
    for (drawing, promised) in planted.iter().filter(|(_, promised)| *promised != "more than") {
        let found = faults(drawing, &as_meant(drawing));
        assert!(found.iter().any(|fault| fault.contains(promised)), "lacks `{promised}`: {found:?}");
    }
    let drawings: Vec<&Drawing> = planted.iter().map(|(drawing, _)| drawing).collect();
    let found = on_paper("diagrams-planted", Edition::default(), &drawings);
    for (place, (_, promised)) in planted.iter().enumerate() {
        let said: Vec<&String> = found.iter().filter(|(at, _)| *at == place).map(|(_, fault)| fault).collect();
        assert!(said.iter().any(|fault| fault.contains(promised)), "{place} lacks `{promised}`: {said:?}");
    }
}

#[test]
#[ignore = "needs TeX, poppler and Chromium, which `.ci/run` installs"]
fn a_picture_that_is_not_its_drawing_is_seen() {
    let drawing = sphere();
    let (pdf, em) = pages("diagrams-other", Edition::default(), &[&drawing]);
    let right = in_ems(&drawing, em, ink(&pdf, 1));
    let mut fewer = right.clone();
    fewer.lines.truncate(3);
    assert_eq!(faults(&drawing, &fewer), ["shows 3 of 4 strokes"]);
    let mut turned = right.clone();
    turned.lines[2].iter_mut().for_each(|at| at.y = 2.0 * at.x);
    assert!(faults(&drawing, &turned)[0].starts_with("Velocity is at"), "{:?}", faults(&drawing, &turned));
    let mut unwritten = drawing.clone();
    unwritten.labels.push(Label {
        text: Text::words("w"),
        centre: Point { x: 1.0, y: 1.0 },
        size: Point { x: 1.0, y: 1.0 },
    });
    assert_eq!(faults(&unwritten, &right), ["`w` is not written"]);
}
