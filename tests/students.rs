//! Every shipped question, marked as handed in by students whose marks are known.

use carom::bank::{Question, read_question, shipped};
use carom::diagnostic::Source;
use carom::examine::{Coverage, coverage};
use carom::generate::{Deal, reference};

fn questions() -> impl Iterator<Item = Question> {
    shipped().map(|(id, text)| read_question(id, &Source::new(id, text)).unwrap())
}

/// The reference numbers and two variants of every style.
fn examined(question: &Question) -> Coverage {
    let mut found = coverage(question, &reference(question).unwrap());
    for style in &question.styles {
        for variant in Deal::new(question, style, 5).take(2) {
            found.add(coverage(question, &variant));
        }
    }
    found
}

#[test]
fn every_student_earns_what_is_due_and_every_mark_is_won_and_lost() {
    let mut wrong = String::new();
    let mut scripts = 0;
    for question in questions() {
        let found = examined(&question);
        scripts += found.scripts;
        for fault in &found.faults {
            wrong += &format!("{}: {fault}\n", question.id);
        }
        for mark in found.idle() {
            wrong += &format!(
                "{}: ({}) {} is won {} times and lost {} times\n",
                question.id, mark.part, mark.id, mark.won, mark.lost
            );
        }
    }
    assert!(wrong.is_empty(), "{wrong}");
    assert!(scripts > 2000, "{scripts}");
}
