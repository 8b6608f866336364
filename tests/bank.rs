//! Question files of several kinds, read into checked questions.

use carom::answer::{Accept, Kind};
use carom::bank::{Code, EarnedFor, Find, Question, StyleName, read_question};
use carom::diagnostic::{Source, render_all};
use carom::expr::print;
use carom::generate::{Deal, enumerate, reference};
use carom::mechanics::Law;
use carom::number::Places;

fn question(text: &str) -> Question {
    match read_question("rest/test", &Source::new("test.toml", text)) {
        Ok(question) => question,
        Err(faults) => panic!("{}", render_all(&faults, false)),
    }
}

fn sound() -> Question {
    question(include_str!("errors/sound.toml"))
}

#[test]
fn carom_knows_what_each_mark_depends_on() {
    let question = sound();
    let marks = &question.parts[0].marks;
    let table: Vec<(&str, &str, String)> =
        marks.iter().map(|mark| (mark.id.as_str(), mark.code.name(), mark.depends.join(" "))).collect();
    let expected = [
        ("B1a", "B1", ""),
        ("M1a", "M1", ""),
        ("A1a", "A1", "M1a"),
        ("M1b", "M1", ""),
        ("A1b", "A1", "M1b"),
        ("M1c", "dM1", "M1a M1b"),
        ("A1c", "A1", "M1c"),
        ("M1d", "M1", ""),
        ("A1d", "A1", "M1d"),
    ];
    assert_eq!(table.len(), expected.len());
    for ((id, code, depends), (wanted_id, wanted_code, wanted)) in table.iter().zip(expected) {
        assert_eq!((*id, *code, depends.as_str()), (wanted_id, wanted_code, wanted));
    }
    assert_eq!(question.marks(), 9);
    assert_eq!(marks[1].code, Code::M1);
    assert_eq!(marks[1].earned_for, EarnedFor::Law(Law::Momentum, None));
}

#[test]
fn carom_knows_the_styles_of_a_question_and_their_sizes() {
    let question = sound();
    let sizes: Vec<(StyleName, u64)> = question.styles.iter().map(|style| (style.name, style.size())).collect();
    let rest = 6 * 6 * 11 * 3;
    assert_eq!(sizes, [(StyleName::Exact, rest * 3), (StyleName::Calculator, rest * 71)]);
    let first: Vec<String> = question.styles[1]
        .parameters_at(72)
        .iter()
        .map(|(name, value)| format!("{name} {}", print::plain(value)))
        .collect();
    assert_eq!(first, ["mA 1", "mB 1", "u 2", "e 1/3", "alpha 11"]);
    assert_eq!(question.parts[0].answers[0].accept(StyleName::Exact), &Accept::RoundsTo(Places::SignificantFigures(3)));
    assert_eq!(question.parts[0].answers[0].kind, Kind::Number);
}

const LETTERS: &str = r#"
title = "Masses m and 2m"
topic = "letters"
stem = "Sphere *A* of mass {m kg} strikes *B* of mass {r*m kg}, at rest, with speed {u m/s} at {alpha deg}; _then_ {e}."
[parameters]
r = "2..3"
[style.exact]
parameters = { alpha = ["30", "60"] }
[scene]
masses = { A = "m", B = "r*m" }
before = { A = { speed = "u", angle_deg = "alpha" }, B = ["0", "0"] }
line_of_centres = ["1", "0"]
sense = "A_to_B"
e = "e"
symbols = { m = "positive", u = "positive", e = "unit" }
[[part]]
ask = "Find, in terms of {u} and {e}, the speed of *B*."
answers = [{ name = "speed of *B*", find = "B.after.speed" }]
marks = [{ code = "M1", for = "momentum" }, { code = "A1", for = "B.after.speed" }]
[[part]]
ask = "Find the velocity of *A*."
answers = [{ name = "velocity of *A*", find = ["A.after.x", "A.after.y"] }]
marks = [{ code = "M1", for = "speed A" }, { code = "A1ft", for = "A.after.speed" }, { code = "E1", for = "condition" }]
[reference]
r = "2"
alpha = "60"
erratum = "none"
"#;

#[test]
fn carom_reads_a_question_in_letters() {
    let question = question(LETTERS);
    let labels: Vec<&str> = question.parts.iter().map(|part| part.label.as_str()).collect();
    assert_eq!(labels, ["a", "b"]);
    let all = question.parts.iter().flat_map(|part| &part.answers);
    let answers: Vec<(Kind, &Accept)> = all.map(|answer| (answer.kind, answer.accept(StyleName::Exact))).collect();
    assert_eq!(answers, [(Kind::Expression, &Accept::Exact), (Kind::Vector, &Accept::Exact)]);
    assert_eq!(question.erratum.as_deref(), Some("none"));
    let variant = reference(&question).unwrap();
    // m u/2 = m v + 2m w and w - v = e u/2 give w = u (1 + e)/6.
    let speed = variant.solution.exact("B.after.speed".parse().unwrap()).unwrap();
    assert_eq!(print::plain(&speed), "u*(1 + e)/6");
    let census = enumerate(&question, &question.styles[0], &|_| {}, &|_| {});
    assert_eq!((census.size, census.fit), (4, 4));
}

const BACKWARDS: &str = r#"
title = "A turned through a right angle"
topic = "backwards"
stem = "Spheres *A* and *B* of equal mass {m kg}; *B* is at rest; *A* moves at an angle {theta} to the line of centres; {e}."
[parameters]
e = ["1/4", "1/3", "1/2"]
[style.exact]
[scene]
masses = { A = "m", B = "m" }
before = { A = { speed = "u", angle_deg = "theta" }, B = ["0", "0"] }
line_of_centres = ["1", "0"]
sense = "A_to_B"
e = "e"
symbols = { m = "positive", u = "positive", theta = "acute" }
unknowns = ["theta"]
conditions = ["A.tan_deflection = 1"]
[[part]]
ask = "Show that {display: result}."
answers = [{ name = "tan(theta)", find = "theta", kind = "shown", show = "tan(theta)" }]
marks = [{ code = "M1", for = "condition" }, { code = "A1*", for = "theta" }]
[reference]
e = "1/3"
"#;

#[test]
fn carom_reads_a_question_that_runs_backwards() {
    let text = BACKWARDS.replace("A.tan_deflection = 1", "A.after.angle_to_loc_deg = 60");
    let question = question(&text);
    let answer = &question.parts[0].answers[0];
    assert_eq!(answer.find, Find::Unknown("theta".to_owned()));
    assert_eq!(answer.show.as_ref().map(print::plain), Some("tan(theta)".to_owned()));
    assert_eq!(question.parts[0].marks[1].earned_for, EarnedFor::Unknown("theta".to_owned()));
    let variant = reference(&question).unwrap();
    // Equal masses: A keeps (1 - e)/2 of its component, so tan 60 = tan theta / (1/3).
    let (_, tangent) = &variant.solution.found()[0];
    assert_eq!(print::plain(&carom::expr::written(tangent)), "sqrt(3)/3");
}

#[test]
fn carom_deals_variants_of_every_shipped_question_in_every_style() {
    let bank = carom::bank::Bank::shipped().unwrap_or_else(|faults| panic!("{}", render_all(&faults, false)));
    for question in &bank.questions {
        for style in &question.styles {
            let mut deal = Deal::new(question, style, 1);
            let dealt = deal.by_ref().take(3).count();
            assert_eq!(dealt, 3, "{} {}: {:?} of {}", question.id, style.name, deal.end(), style.size());
        }
    }
}

#[test]
fn carom_condones_beside_a_scalar_product_what_can_go_wrong_in_one() {
    let bank = carom::bank::Bank::shipped().unwrap_or_else(|faults| panic!("{}", render_all(&faults, false)));
    let mut found = 0;
    for question in &bank.questions {
        let printed = carom::paper::compose(question, &reference(question).unwrap(), 1);
        for row in printed.parts.iter().flat_map(|part| &part.scheme) {
            let (earned, note) = (print::text_unicode(&row.earned), print::text_unicode(&row.note));
            if earned.contains("scalar product") && !earned.contains("difference") {
                assert!(!note.contains("difference"), "{}: {earned} [{note}]", question.id);
                found += 1;
            }
        }
    }
    assert!(found > 1, "{found}");
}
