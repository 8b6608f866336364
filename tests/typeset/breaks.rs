//! Pages break where a reader would break them: a stem stays with its diagram and its first part, and no page has only
//! a line or two of a question.
//!
//! The paper is marked with words of its own before it is set, so that no template has to say what is where: `Q7` is
//! where question 7 begins, `S7` is the end of its stem, `F7` in its figure, `P7` in its first part, `W7` in the pictures
//! of its solution, `E7` where it ends, `V7` the last words of its solution.

use std::collections::BTreeMap;
use std::path::Path;

use carom::diagram::Diagram;
use carom::expr::{Expr, Piece, Text};
use carom::paper::{Edition, Paper, PrintedQuestion, WorkingLine};
use carom::render::RenderedFile;

use super::engine::{PDFLATEX, set_fully};
use super::papers::{editions, empty, reference_set, whole_bank};
use super::words::{Word, lines, words};
use super::{folder, on_both, rendered};

/// The fewest lines of a question on a page, unless it has no more.
const FEWEST: usize = 3;

fn marked(mut paper: Paper) -> Paper {
    for question in &mut paper.questions {
        mark(question);
    }
    paper
}

fn mark(question: &mut PrintedQuestion) {
    let word = |letter: char, number: usize| format!(" {letter}{number} ");
    let number = question.number;
    let begins = |text: &mut Text, letter: char| text.0.insert(0, Piece::Words(word(letter, number)));
    question.id = format!("Q{number}");
    begins(&mut question.stem[0], 'Q');
    let last = question.stem.last_mut().expect("a stem has words");
    last.0.push(Piece::Words(word('S', number)));
    let first = &mut question.parts[0];
    begins(&mut first.ask, 'P');
    begins(&mut first.working[0].words, 'Q');
    begins(&mut first.scheme[0].earned, 'Q');
    let ends = |text: &mut Text, letter: char| text.0.push(Piece::Words(word(letter, number)));
    let last = question.parts.last_mut().expect("a question asks");
    ends(&mut last.ask, 'E');
    ends(&mut last.working.last_mut().expect("a part has a solution").words, 'V');
    ends(&mut last.scheme.last_mut().expect("a part has marks").earned, 'E');
    let labelled = |diagrams: &mut [Diagram], letter: char| {
        for label in diagrams.iter_mut().filter_map(|diagram| diagram.drawing.labels.first_mut()) {
            label.text = Text::words(word(letter, number));
        }
    };
    labelled(&mut question.diagrams, 'F');
    labelled(&mut question.solution_diagrams, 'W');
}

/// Where marks stand: pages from 0, and how far down.
fn places(pages: &[Vec<Word>]) -> BTreeMap<&str, Vec<(usize, f64)>> {
    let mut places: BTreeMap<&str, Vec<(usize, f64)>> = BTreeMap::new();
    for (page, words) in pages.iter().enumerate() {
        for word in words {
            places.entry(word.text.trim_end_matches([',', '.'])).or_default().push((page, word.area.low.y));
        }
    }
    places.values_mut().for_each(|places| places.sort_by(|a, b| a.partial_cmp(b).expect("a place")));
    places
}

/// What is torn apart in a document of a marked paper.
fn torn(pdf: &Path, paper: &Paper) -> Vec<String> {
    let pages = words(pdf);
    let places = places(&pages);
    let first = |letter: char, number: usize| places.get(format!("{letter}{number}").as_str()).map(|places| places[0]);
    let last = |letter: char, number: usize| places.get(format!("{letter}{number}").as_str())?.last().copied();
    let mut found = Vec::new();
    for number in 1..=paper.questions.len() {
        let Some(begin) = first('Q', number) else {
            found.push(format!("question {number} is not there"));
            continue;
        };
        if number == 1 && begin.0 != 0 {
            found.push("the heading of the paper stands by itself".to_owned());
        }
        for (letter, what) in [('S', "stem"), ('F', "figure"), ('P', "first part"), ('W', "diagrams")] {
            let marks = places.get(format!("{letter}{number}").as_str()).into_iter().flatten();
            // a page of large print may be full of a stem and its figure, and below the heading of less than that
            let may_part = paper.edition.large_print && (letter == 'P' || (letter != 'S' && number == 1));
            for (page, _) in marks.filter(|(page, _)| *page != begin.0 && !may_part) {
                let (from, to) = (begin.0 + 1, page + 1);
                found.push(format!("question {number} begins on page {from} and has its {what} on page {to}"));
            }
        }
        let is_sheet = pdf.file_stem().is_some_and(|name| name == "question-sheet");
        if is_sheet && number == paper.questions.len() && last('E', number).is_some_and(|at| at.0 + 1 != pages.len()) {
            found.push("the total of the paper stands by itself".to_owned());
        }
        // a part with lines to write on fills a page by itself
        if paper.edition.answer_space {
            continue;
        }
        // what tells the marks comes after the end, or the equations after the last words
        let equations = || {
            let line = paper.questions.get(number - 1)?.parts.last()?.working.last()?;
            Some((last('V', number)?, line.equations.len()))
        };
        let Some((end, after)) = last('E', number).map(|at| (at, 1)).or_else(equations) else {
            found.push(format!("question {number} has no end"));
            continue;
        };
        for page in (begin.0..=end.0).filter(|_| begin.0 != end.0) {
            let from = if page == begin.0 { begin.1 - 1.0 } else { 0.0 };
            let foot = pages[page].iter().map(|word| word.area.low.y).fold(0.0, f64::max) - 20.0;
            let to = if page == end.0 { end.1 + 1.0 } else { foot };
            let between = |word: &&Word| word.area.low.y >= from && word.area.low.y < to;
            let count = lines(&pages[page].iter().filter(between).collect::<Vec<_>>());
            let count = count + if page == end.0 { after } else { 0 };
            if count < FEWEST {
                found.push(format!("page {} has {count} lines of question {number}", page + 1));
            }
        }
    }
    found
}

fn set_and_torn(name: &str, document: &RenderedFile, paper: &Paper) -> Vec<String> {
    let sheet = set_fully(PDFLATEX, &folder(name), document);
    torn(&sheet.pdf, paper).into_iter().map(|fault| format!("{name}: {fault}")).collect()
}

#[test]
#[ignore = "needs TeX, poppler and Chromium, which `.ci/run` installs"]
fn carom_knows_where_pages_break() {
    let bank = marked(whole_bank());
    let mut work = Vec::new();
    for (edition, how) in editions() {
        let paper = Paper { edition: how, ..bank.clone() };
        let documents = rendered("latex", &paper);
        work.extend(
            documents
                .into_iter()
                .map(|document| (format!("breaks/{edition}/{}", document.name), document, paper.clone())),
        );
    }
    let found = on_both(&work, |(name, document, paper)| set_and_torn(name, document, paper)).concat();
    assert!(found.is_empty(), "\n{}", found.join("\n"));
}

/// Where a page is hardly large enough for one question and its pictures.
#[test]
#[ignore = "needs TeX, poppler and Chromium, which `.ci/run` installs"]
fn carom_knows_papers_whose_heading_and_total_do_not_stand_by_themselves() {
    let bank = reference_set();
    let large = Edition { large_print: true, ..Edition::default() };
    let long = bank.questions.iter().filter(|question| question.id.starts_with("successive/"));
    let mut work = Vec::new();
    for question in long {
        let name = format!("breaks/alone/{}", question.id);
        let question = PrintedQuestion { number: 1, ..question.clone() };
        let paper = marked(Paper { questions: vec![question], edition: large, ..empty() });
        let documents = rendered("latex", &paper).into_iter().filter(|document| document.name != "mark-scheme.tex");
        work.extend(documents.map(|document| (format!("{name}/{}", document.name), document, paper.clone())));
    }
    assert!(work.len() > 8, "{} documents", work.len());
    let found = on_both(&work, |(name, document, paper)| set_and_torn(name, document, paper)).concat();
    assert!(found.is_empty(), "\n{}", found.join("\n"));
}

/// The longest left side of a part pushes all of its equations to the right, as far as they have room there.
#[test]
#[ignore = "needs TeX, poppler and Chromium, which `.ci/run` installs"]
fn a_formula_is_broken_only_where_no_line_of_its_own_holds_it() {
    let sum = |from: i64, to: i64| Expr::Sum((from..=to).map(Expr::integer).collect());
    let line = |left, right| WorkingLine {
        words: Text::words("Hence"),
        equations: vec![Expr::equation(left, right)],
        label: None,
    };
    let set = |last: i64| {
        let mut paper = super::by_hand::paper();
        paper.questions.truncate(1);
        let part = &mut paper.questions[0].parts[0];
        part.working = vec![line(sum(1, 9), Expr::integer(45)), line(Expr::name("L"), sum(201, last))];
        let mut documents = rendered("latex", &paper).into_iter();
        let solutions = documents.find(|document| document.name == "worked-solutions.tex").unwrap();
        words(&set_fully(PDFLATEX, &folder("breaks/formula"), &solutions).pdf).concat()
    };
    for (last, is_whole) in [(206, true), (212, true), (230, false)] {
        let words = set(last);
        let foot =
            |text: String| words.iter().find(|word| word.text.contains(&text)).map(|word| word.area.high.y).unwrap();
        assert_eq!((foot("201".into()) - foot(last.to_string())).abs() < 3.0, is_whole, "to {last}");
    }
}

#[test]
#[ignore = "needs TeX, poppler and Chromium, which `.ci/run` installs"]
fn what_is_torn_apart_is_seen() {
    let lines = |count: usize| r"a line\\".repeat(count);
    let (three, many) = (lines(3), lines(5));
    let two = Paper { questions: super::by_hand::paper().questions[..2].to_vec(), ..Paper::default() };
    let set = |body: &str| {
        let contents = format!("\\documentclass{{article}}\\begin{{document}}\\noindent {body}\\end{{document}}");
        let document = RenderedFile { name: "torn.tex".into(), contents };
        set_and_torn("breaks/planted", &document, &two)
    };
    let second = format!(r"Q2 S2 F2 P2 W2\\{three}E2\\total");
    assert_eq!(set(&format!(r"Q1 S1 F1 P1 W1\\{many}\newpage\noindent {three}E1\\total\\{second}")), [""; 0]);
    for (body, promised) in [
        (
            format!(r"Q1 {three}\newpage S1 P1 {three}E1\\total\\{second}"),
            "question 1 begins on page 1 and has its stem on page 2",
        ),
        (format!(r"Q1 S1 {three}\newpage F1 P1 {three}E1\\total\\{second}"), "has its figure on page 2"),
        (format!(r"Q1 S1 {three}\newpage P1 {three}E1\\total\\{second}"), "has its first part on page 2"),
        (format!(r"Q1 {three}\newpage W1 {three}E1\\total\\{second}"), "has its diagrams on page 2"),
        (format!(r"Q1 S1 P1\newpage\noindent {many}E1\\total\\{second}"), "page 1 has 1 lines of question 1"),
        (format!(r"Q1 S1 P1 {many}\newpage\noindent E1\\total\\{second}"), "page 2 has 2 lines of question 1"),
        (format!(r"Q1 S1 P1 {many}"), "question 1 has no end"),
        (format!(r"Q1 S1 P1 {many} E1"), "question 2 is not there"),
    ] {
        let found = set(&body);
        assert!(found.iter().any(|fault| fault.contains(promised)), "{body} lacks {promised}: {found:?}");
    }
}
