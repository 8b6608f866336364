//! Every shipped question, marked as handed in by students whose marks are known.

use carom::bank::{Question, read_question, shipped};
use carom::diagnostic::Source;
use carom::examine::{Coverage, coverage};
use carom::generate::{Deal, reference};

fn questions() -> impl Iterator<Item = Question> {
    shipped().map(|(id, text)| read_question(id, &Source::new(id, text)).unwrap())
}

/// Part (a) finds a range and has no marks for momentum; part (b) goes on to the next impact in the letter of the range, and its
/// model solution has no line of the first.
const ON_FROM_A_RANGE: &str = r#"
title = "Three spheres"
topic = "ranges of values"
stem = '''
Three small smooth spheres *A*, *B* and *C*, of equal radius, have masses {mA}, {k*m} and {mC} respectively. They are at rest in that order
in a straight line on a smooth horizontal plane. Sphere *A* is projected towards *B* with speed {u} and strikes it directly; then *B* strikes
*C* directly. The coefficient of restitution between any two of the spheres is {e}.
'''
require = ["p != r"]
[parameters]
p = "1..6"
r = "1..8"
e = ["1/4", "1/3", "1/2"]
[let]
mA = "p*m"
mC = "r*m"
[style.friendly]
[scene]
masses = { A = "mA", B = "k*m" }
before = { A = "u", B = "0" }
e = "e"
symbols = { m = "positive", u = "positive", k = "positive" }
unknowns = ["k"]
conditions = ["A.after.x < 0"]
[[scene.then]]
of = ["B", "C"]
mass = "mC"
before = "0"
e = "e"
[[part]]
ask = "The direction of motion of *A* is reversed when it strikes *B*. Find the set of possible values of {k}."
answers = [{ name = "values of *k*", find = "k", kind = "range", accept = "exact" }]
marks = [{ code = "M1", for = "condition" }, { code = "A1", for = "k" }]
[[part]]
ask = "Find, in terms of {u} and {k}, the speed of *C* after *B* has struck it."
answers = [{ name = "speed of *C*", find = "second.C.after.speed", accept = "exact" }]
marks = [
  { code = "M1", for = "momentum" },
  { code = "A1", for = "momentum" },
  { code = "M1", for = "restitution" },
  { code = "A1", for = "restitution" },
  { code = "A1", for = "second.C.after.speed" },
]
[reference]
p = "2"
r = "3"
e = "1/2"
"#;

#[test]
fn the_next_impact_is_marked_though_no_line_of_the_first_is_written() {
    let question = read_question("three", &Source::new("three", ON_FROM_A_RANGE)).unwrap();
    let found = examined(&question);
    assert_eq!(found.faults.iter().map(ToString::to_string).collect::<Vec<_>>(), Vec::<String>::new());
    assert_eq!(found.idle().count(), 0);
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
