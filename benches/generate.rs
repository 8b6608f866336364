//! How long it takes to find numbers for questions, and to make a sheet of six from nothing.

use carom::bank::{Bank, Contents, Heading};
use carom::diagnostic::render_all;
use carom::generate::{Deal, Shuffle, examine};
use carom::paper::{Dealer, Paper, choose_count, compose};
use carom::render::{Formats, RenderedFile};
use divan::{Bencher, black_box};

fn main() {
    divan::main();
}

fn bank() -> Bank {
    Bank::shipped().unwrap_or_else(|faults| panic!("{}", render_all(&faults, false)))
}

/// Every question in every style that it offers: `rest/speeds-and-directions exact`.
fn styles() -> Vec<String> {
    let bank = bank();
    let each = bank.questions.iter();
    each.flat_map(|question| question.styles.iter().map(|style| format!("{} {}", question.id, style.name.name())))
        .collect()
}

/// The first hundred sets of numbers in the order of a seed, most of them turned away.
#[divan::bench(args = styles(), sample_count = 10, sample_size = 1)]
fn examine_100(bencher: Bencher, name: &str) {
    let bank = bank();
    let (id, style) = name.split_once(' ').expect(name);
    let question = bank.find(id).expect(id);
    let style = question.styles.iter().find(|offered| offered.name.name() == style).expect(name);
    let some: Vec<u64> = Shuffle::new(style.size(), 1, id, style.name.name()).take(100).collect();
    bencher.bench(|| some.iter().filter(|index| examine(question, style, **index).is_ok()).count());
}

/// Ten that are fit for print, as `--count 10` deals them.
#[divan::bench(args = styles(), sample_count = 3, sample_size = 1)]
fn deal_10(bencher: Bencher, name: &str) {
    let bank = bank();
    let (id, style) = name.split_once(' ').expect(name);
    let question = bank.find(id).expect(id);
    let style = question.styles.iter().find(|offered| offered.name.name() == style).expect(name);
    bencher.bench(|| Deal::new(question, style, 1).take(10).count());
}

/// All that `carom sheet --count 6` does but the writing of files: nothing is kept from one run to the next.
#[divan::bench(args = [1, 2, 3], sample_count = 10, sample_size = 1)]
fn a_cold_sheet_of_six(seed: u64) -> Vec<RenderedFile> {
    let contents = Contents::shipped();
    let headings: Vec<&Heading> = contents.headings.iter().collect();
    let chosen = choose_count(&headings, 6, black_box(seed));
    let read =
        |heading: &&Heading| heading.question().unwrap_or_else(|faults| panic!("{}", render_all(&faults, false)));
    let questions: Vec<_> = chosen.iter().map(read).collect();
    let mut dealer = Dealer::new(seed, None);
    let printed = questions.iter().enumerate().map(|(index, question)| {
        let variant = dealer.next(question).expect("numbers");
        compose(question, &variant, index + 1)
    });
    let paper = Paper {
        title: "Oblique impacts".to_owned(),
        seed: Some(seed),
        questions: printed.collect(),
        ..Paper::default()
    };
    let formats = Formats::shipped().expect("the shipped formats");
    ["latex", "html"].into_iter().flat_map(|format| formats.render(format, &paper).expect("pages")).collect()
}
