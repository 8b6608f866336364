//! How long it takes to read the formats, and to turn a paper into pages.

use carom::bank::Bank;
use carom::diagnostic::render_all;
use carom::generate::reference;
use carom::paper::{Paper, compose};
use carom::render::Formats;
use divan::Bencher;
use divan::counter::ItemsCount;

fn main() {
    divan::main();
}

/// Six reference questions, of every kind.
fn paper() -> Paper {
    let bank = Bank::shipped().unwrap_or_else(|faults| panic!("{}", render_all(&faults, false)));
    let every_third = bank.questions.iter().step_by(3).take(6);
    let printed = every_third.enumerate().map(|(index, question)| {
        let variant = reference(question).unwrap_or_else(|_| panic!("{} has no reference numbers", question.id));
        compose(question, &variant, index + 1)
    });
    Paper { title: "Oblique impacts".to_owned(), questions: printed.collect(), ..Paper::default() }
}

#[divan::bench]
fn formats_loaded() -> Formats {
    Formats::shipped().expect("the shipped formats")
}

/// All documents of a paper in one format. The items of a second are questions: a hundred microseconds a question are
/// ten thousand.
#[divan::bench(args = ["latex", "html"])]
fn a_paper_of_six(bencher: Bencher, format: &str) {
    let formats = Formats::shipped().expect("the shipped formats");
    let paper = paper();
    assert_eq!(paper.questions.len(), 6);
    let questions = ItemsCount::new(paper.questions.len());
    bencher.counter(questions).bench(|| formats.render(format, &paper).expect("pages"));
}
