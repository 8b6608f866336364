//! The page that a student gets back, set by three engines and shown by a browser, whatever the student typed; and the
//! report on the class.

use carom::mark::report::{ClassReport, Names, QuestionFigures, StudentMarks};
use carom::render::{Formats, RenderedFile};

use super::browser::seen;
use super::class::{pages, report};
use super::engine::{PDFLATEX, set_fully};
use super::screen::on_a4;
use super::{folder, on_both};

/// The page of each student of a small class.
fn rendered(format: &str) -> Vec<RenderedFile> {
    let formats = Formats::shipped().unwrap();
    let mut all = Vec::new();
    pages(|pages| all.extend(pages.iter().map(|page| formats.feedback(format, page).unwrap().unwrap())));
    assert!(all.len() > 1);
    all
}

#[test]
#[ignore = "needs TeX, poppler and Chromium, which `.ci/run` installs"]
fn carom_knows_feedback_for_three_engines() {
    let documents = rendered("latex");
    let engines = [PDFLATEX, "lualatex", "xelatex"];
    let work: Vec<_> = engines.iter().flat_map(|engine| documents.iter().map(move |page| (*engine, page))).collect();
    let complaints = on_both(&work, |(engine, document)| {
        let folder = folder(&format!("feedback/{engine}/{}", document.name));
        let complaints = set_fully(engine, &folder, document).complaints().into_iter();
        complaints.map(|said| format!("{engine}: {said}")).collect::<Vec<_>>()
    });
    assert!(complaints.iter().all(Vec::is_empty), "\n{}", complaints.concat().join("\n"));
}

#[test]
#[ignore = "needs TeX, poppler and Chromium, which `.ci/run` installs"]
fn carom_knows_feedback_that_fits_on_a_phone() {
    on_both(&rendered("html"), |page| {
        for seen in seen(&folder(&format!("feedback/{}", page.name)), page) {
            assert!(seen.reach <= seen.window, "{}: {seen:?}", page.name);
            assert!(seen.faults.is_empty(), "{}: {seen:?}", page.name);
        }
    });
}

/// The same class with so many questions, and a student with a name as long as they come.
fn with_questions(class: &ClassReport, count: usize) -> ClassReport {
    let question = |place: usize| QuestionFigures { label: (place + 1).to_string(), ..class.questions[0].clone() };
    let student = |student: &StudentMarks| StudentMarks { questions: vec![Some(11); count], ..student.clone() };
    let mut many = ClassReport {
        questions: (0..count).map(question).collect(),
        students: class.students.iter().map(student).collect(),
        ..class.clone()
    };
    many.students[0].name = "Wolfeschlegelsteinhausenbergerdorff".repeat(3);
    many
}

#[test]
#[ignore = "needs TeX, poppler and Chromium, which `.ci/run` installs"]
fn carom_knows_a_report_that_fits_on_a_phone_a_desk_and_a_sheet_of_paper() {
    let mut work = Vec::new();
    for (names, called) in [(Names::Shown, "named"), (Names::LeftOut, "nameless")] {
        for count in [2, 12, 18, 19, 60] {
            report(names, |class| {
                let class = with_questions(class, count);
                let page = Formats::shipped().unwrap().report("html", &class).unwrap().unwrap();
                work.push((format!("report/{called}-{count}"), page));
            });
        }
    }
    on_both(&work, |(name, page)| {
        let all = seen(&folder(name), page);
        for seen in &all {
            assert!(seen.reach <= seen.window, "{name}: {seen:?}");
        }
        let found = on_a4(&format!("{name}/printed"), page, &all[0].margins);
        assert!(found.is_empty(), "{name}: {found:?}");
    });
}
