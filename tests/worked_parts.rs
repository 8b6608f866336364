//! The working of a question stands in the parts to which it belongs: a letter is found where it is asked for, nothing is
//! worked out twice, and no part is an empty heading.

use carom::bank::{Bank, Question, read_question};
use carom::diagnostic::{Source, render_all};
use carom::examine::coverage;
use carom::expr::print;
use carom::generate::{Deal, reference};
use carom::paper::{WorkingLine, compose};

const IN_LETTERS: &str = r#"
title = "A strikes B at rest"
topic = "ranges"
stem = "*A*, of mass {m}, strikes *B*, of mass {k*m}, directly with speed {u}. The coefficient of restitution is {e}."
[parameters]
k = "2..6"
[style.exact]
[scene]
masses = { A = "m", B = "k*m" }
before = { A = "u", B = "0" }
e = "e"
symbols = { e = "unit", u = "positive", m = "positive" }
unknowns = ["e"]
conditions = ["CONDITION"]
PARTS
[reference]
k = "3"
"#;

const SPEED_BEFORE: &str = "A.before.speed";
const B_AFTER: &str = "B.after.x";

fn read(id: &str, text: &str) -> Question {
    read_question(id, &Source::new("own", text)).unwrap_or_else(|faults| panic!("{}", render_all(&faults, false)))
}

/// A condition, what is asked of each part, and of each an equation that stands in its working and one that does not.
type Row<'t> = (&'t str, &'t [&'t str], &'t [(&'t str, &'t str)]);

/// The working of each part, its words and its equations.
fn working(condition: &str, asked: &[&str]) -> Vec<Vec<String>> {
    let part = |find: &&str| {
        let kind = if *find == "e" && condition.contains('<') { ", kind = \"range\"" } else { "" };
        format!(
            "[[part]]\nask = \"Find it.\"\nanswers = [{{ name = \"it\", find = \"{find}\"{kind} }}]\n\
             marks = [{{ code = \"B1\", for = \"{find}\" }}]\n"
        )
    };
    let parts: String = asked.iter().map(part).collect();
    let text = IN_LETTERS.replace("CONDITION", condition).replace("PARTS", &parts);
    let question = read("ranges/own", &text);
    let variant = reference(&question).unwrap_or_else(|refused| panic!("{refused:?}"));
    let lines = compose(&question, &variant, 1).parts.into_iter().map(|part| part.working);
    let words = |lines: Vec<WorkingLine>| {
        let each = lines.into_iter().map(|line| (print::text_unicode(&line.words), line.equations));
        each.flat_map(|(words, equations)| {
            let equations = equations.iter().map(print::plain).collect::<Vec<_>>();
            std::iter::once(words).chain(equations).filter(|line| !line.is_empty())
        })
        .collect()
    };
    lines.map(words).collect()
}

#[test]
fn a_letter_is_found_in_the_part_that_asks_for_it() {
    let momentum = "m*u = m*v + 3*m*w";
    let range = "1/3 < e <= 1";
    let table: [Row; 7] = [
        ("A.after.x < 0", &["e"], &[(range, "w = u")]),
        ("A.after.x < 0", &[SPEED_BEFORE, "e"], &[("", momentum), (momentum, "u = u")]),
        ("A.after.x < 0", &[B_AFTER, "e"], &[(momentum, range), (range, momentum)]),
        ("A.after.x < 0", &["e", B_AFTER], &[(range, ""), ("w = u*(1 + e)/4", momentum)]),
        ("A.after.x = -u/5", &[SPEED_BEFORE, "e"], &[("", momentum), ("e = 3/5", "")]),
        // What is asked first needs the letter.
        ("A.after.x = -u/5", &[B_AFTER, "e"], &[("e = 3/5", ""), ("e = 3/5", momentum)]),
        ("A.after.x = -u/5", &["e", B_AFTER], &[("e = 3/5", ""), ("w = 2*u/5", momentum)]),
    ];
    for (condition, asked, expected) in table {
        let worked = working(condition, asked);
        assert_eq!(worked.len(), expected.len());
        for (part, (has, has_not)) in worked.iter().zip(expected) {
            let there = |equation: &str| part.iter().any(|line| line == equation);
            assert!(has.is_empty() || there(has), "{condition}, {asked:?}: `{has}` is not in {part:#?}");
            assert!(has_not.is_empty() || !there(has_not), "{condition}, {asked:?}: `{has_not}` is in {part:#?}");
            assert!(!part.is_empty(), "{condition}, {asked:?}: an empty heading");
        }
    }
}

/// What a row of a mark scheme shows, its words and its equation, with the reference numbers of a shipped question.
fn rows(id: &str, part: usize) -> Vec<String> {
    let bank = Bank::shipped().unwrap_or_else(|faults| panic!("{}", render_all(&faults, false)));
    let question = bank.questions.iter().find(|question| question.id == id).unwrap();
    let variant = reference(question).unwrap_or_else(|refused| panic!("{refused:?}"));
    let scheme = compose(question, &variant, 1).parts.swap_remove(part).scheme;
    let shown = |row: carom::paper::SchemeRow| {
        let equations: Vec<String> = row.equations.iter().map(print::unicode).collect();
        format!("{} {}", print::text_unicode(&row.earned), equations.join(", "))
    };
    scheme.into_iter().map(shown).collect()
}

#[test]
fn a_mark_shows_the_equations_that_it_is_for_and_no_others() {
    let table = [
        ("walls/wall-along-a-vector", 0, "both components before", "p = ", "v_A"),
        ("successive/walls-at-an-angle", 1, "both components before", "p = ", "v_A"),
        ("both-moving/speeds-and-fraction-of-energy-lost", 1, "correct expression", "E₁ = ", "??"),
        ("both-moving/speeds-and-fraction-of-energy-lost", 1, "correct expression", "E₂ = ", "??"),
        ("walls/restitution-from-two-angles", 1, "lost over kinetic energy before", "E₂ = ", "??"),
        ("walls/restitution-from-two-angles", 1, "lost over kinetic energy before", "f = ", "??"),
        ("ranges/mass-ratio-that-can-be", 0, "between 0 and 1", "≥ 0", "??"),
        ("ranges/mass-ratio-that-can-be", 0, "between 0 and 1", "≤ 1", "??"),
        ("ranges/direction-reversed", 0, "velocity of A negative", "< 0", "≤"),
    ];
    for (id, part, mark, has, has_not) in table {
        let rows = rows(id, part);
        let row = rows.iter().find(|row| row.contains(mark)).unwrap_or_else(|| panic!("{id}: {rows:#?}"));
        assert!(row.contains(has) && !row.contains(has_not), "{id}: {row}");
    }
}

#[test]
fn what_is_asked_for_is_what_the_working_comes_to() {
    let table = [
        ("A.ke_lost", "L_A = "),
        ("A.ke_gained", "G_A = "),
        ("A.after.ke", "K_A = "),
        ("momentum.x", "The momentum along i is mu"),
        ("A.after.px", "The momentum of A along i is "),
    ];
    for (asked, words) in table {
        let worked = working("A.after.x = -u/5", &["e", asked]);
        assert!(worked[1].iter().any(|line| line.starts_with(words)), "{asked}: {worked:#?}");
    }
}

#[test]
fn a_mass_has_its_letters_in_the_order_in_which_they_were_typed() {
    let text = IN_LETTERS
        .replace("B = \"k*m\"", "B = \"mB\"")
        .replace("k = \"2..6\"\n", "q = \"2..6\"\n[let]\nmB = \"k*m\"\n")
        .replace("*B*, of mass {k*m}", "*B*, of mass {mB}")
        .replace("directly with speed {u}", "directly with speed {q*u}")
        .replace("before = { A = \"u\"", "before = { A = \"q*u\"")
        .replace("m = \"positive\" }", "m = \"positive\", k = \"positive\" }")
        .replace("unknowns = [\"e\"]\nconditions = [\"CONDITION\"]\n", "")
        .replace("k = \"3\"", "q = \"3\"")
        .replace(
            "PARTS",
            "[[part]]\nask = \"Find it.\"\nanswers = [{ name = \"it\", find = \"B.after.x\" }]\n\
             marks = [{ code = \"B1\", for = \"B.after.x\" }]\n",
        );
    let question = read("ranges/own", &text);
    let variant = reference(&question).unwrap_or_else(|refused| panic!("{refused:?}"));
    let stem = compose(&question, &variant, 1).stem;
    assert!(print::text_unicode(&stem[0]).contains("of mass km"), "{}", print::text_unicode(&stem[0]));
}

const SUCCESSIVE: &str = r#"
title = "A strikes B, and B strikes C"
topic = "ranges"
stem = "*A*, of mass {2*m}, strikes *B*, of mass {k*m}, directly with speed {u}. Then *B* strikes *C*, of mass {c*m}."
[parameters]
c = "3..4"
[let]
mA = "2*m"
mC = "c*m"
[style.exact]
[scene]
masses = { A = "mA", B = "k*m" }
before = { A = "u", B = "0" }
e = "1/2"
symbols = { k = "positive", u = "positive", m = "positive" }
unknowns = ["k"]
conditions = ["A.after.x < 0"]
[[scene.then]]
of = ["B", "C"]
mass = "mC"
before = "0"
e = "1/2"
[[part]]
ask = "*A* turns back. Find the values of {k}."
answers = [{ name = "values of *k*", find = "k", kind = "range" }]
marks = [{ code = "M1", for = "condition" }, { code = "A1", for = "k" }]
[[part]]
ask = "Find the speed of *C*."
answers = [{ name = "speed of *C*", find = "second.C.after.speed" }]
marks = [
  { code = "M1", for = "momentum" },
  { code = "A1", for = "momentum" },
  { code = "M1", for = "restitution" },
  { code = "A1", for = "restitution" },
  { code = "A1", for = "second.C.after.speed" },
]
[reference]
c = "3"
"#;

#[test]
fn a_mark_of_a_later_impact_shows_its_equation_though_a_letter_was_found_from_the_first() {
    let question = read("ranges/own", SUCCESSIVE);
    let printed = compose(&question, &reference(&question).unwrap(), 1);
    let scheme = &printed.parts[1].scheme;
    let equations: Vec<String> =
        scheme.iter().flat_map(|row| &row.equations).map(print::unicode).filter(|row| row.contains('x')).collect();
    assert_eq!(equations, ["km × 3u/(2 + k) = kmx + 3my", "y − x = (1/2) × 3u/(2 + k)"]);
}

/// The model solution of (b) has no line of the first impact, and yet goes on from it.
#[test]
fn the_next_impact_is_marked_though_no_line_of_the_first_is_written() {
    let question = read("ranges/own", SUCCESSIVE);
    let mut found = coverage(&question, &reference(&question).unwrap());
    for variant in Deal::new(&question, &question.styles[0], 5).take(2) {
        found.add(coverage(&question, &variant));
    }
    assert_eq!(found.faults.iter().map(ToString::to_string).collect::<Vec<_>>(), Vec::<String>::new());
    assert_eq!(found.idle().count(), 0);
}

const STOPPED: &str = r#"
title = "A is brought to rest"
topic = "direct impact"
stem = "*A*, of mass {mA kg}, moves at {u m/s} and strikes *B*, of mass {M kg}, which is at rest. *A* stops, and *B* moves at {v m/s}."
[parameters]
mA = "2..3"
mB = "4..5"
u = ["10"]
[let]
v = "mA*u/mB"
[style.exact]
[scene]
masses = { A = "mA", B = "M" }
before = { A = "u", B = "0" }
after = { A = "0", B = "v" }
symbols = { M = "positive" }
unknowns = ["M"]
[[part]]
ask = "Find the value of {M}."
answers = [{ name = "{M}", find = "M" }]
marks = [{ code = "M1", for = "momentum" }, { code = "A1", for = "momentum" }, { code = "A1", for = "M" }]
[reference]
mA = "2"
mB = "4"
u = "10"
"#;

/// No condition says what the letter is: the law itself does, and so it stands there.
#[test]
fn a_law_that_determines_a_letter_stands_in_the_working_and_in_the_scheme() {
    let question = read("direct/own", STOPPED);
    let printed = compose(&question, &reference(&question).unwrap(), 1);
    let lines = &printed.parts[0].working;
    let working: Vec<String> = lines.iter().flat_map(|line| &line.equations).map(print::unicode).collect();
    assert_eq!(working, ["2 × 10 = M × 5", "M = 4"]);
    let scheme = &printed.parts[0].scheme;
    let equations: Vec<String> = scheme.iter().flat_map(|row| &row.equations).map(print::unicode).collect();
    assert_eq!(equations[0], "2 × 10 = M × 5");
}

const IN_A_PLANE: &str = r#"
title = "A strikes B"
topic = "impulse"
stem = "{m kg}"
[parameters]
m = "2..3"
[style.exact]
[scene]
masses = { A = "1", B = "m" }
before = { A = ["4", "7"], B = ["1", "3"] }
line_of_centres = ["3", "4"]
e = "1/2"
[[part]]
ask = "Find the impulse."
answers = [{ name = "impulse", find = ["SPHERE.impulse.x", "SPHERE.impulse.y"] }]
marks = [{ code = "M1", for = "impulse" }, { code = "A1", for = "SPHERE.impulse.x" }]
[reference]
m = "2"
"#;

/// The impulse that is asked for as a vector is the last thing that the working finds, on whichever sphere it acts.
#[test]
fn an_impulse_along_i_and_j_is_found_from_that_along_the_line_of_centres() {
    for (sphere, end) in [("B", "= 3i + 4j"), ("A", "= −3i − 4j")] {
        let text = IN_A_PLANE.replace("SPHERE", sphere);
        let question = read("impulse/own", &text);
        let printed = compose(&question, &reference(&question).unwrap(), 1);
        let last = printed.parts[0].working.last().unwrap();
        let (words, equations) = (print::text_unicode(&last.words), &last.equations);
        assert!(words.starts_with(&format!("The impulse on {sphere} ")), "{words}");
        let shown: Vec<String> = equations.iter().map(print::unicode).collect();
        assert!(shown.last().is_some_and(|equation| equation.ends_with(end)), "{shown:?}");
    }
}
