//! The answers of `tests/data/answers.jsonl`, as students typed them, judged against what Carom solves for.
//!
//! Each row names an exercise, what was asked and the verdict of one careful examiner under 'exact, or decimals to
//! three significant figures'. Models are solved from the scenes of `seed-cases.json`; only those of exercises 12 and 14,
//! which no collision has as they were printed, are written down here. Rules by which rows become questions to Carom:
//!
//! * `velocity_A` in an exercise without **i** and **j** is a velocity by size and direction, else a vector.
//! * `both_speeds` and `speeds` ask two things, `full_answer` four: the verdict on the whole is `correct` if all are,
//!   `wrong` if none earned anything, `unreadable` if none could be read, and else `partial`.
//! * `show_that` is the printed result.

use std::cmp::Ordering;
use std::collections::BTreeMap;
use std::fs;
use std::path::Path;

use carom::answer::{Accept, Kind};
use carom::expr::{Angles, Expr, number, print};
use carom::mark::judging::{Judgement, Model, ModelOptions, Verdict, judge, judge_together};
use carom::mark::reading::read_answer;
use carom::mechanics::{Quantity, Scene, SceneText};
use carom::number::{Letter, Range};
use carom::solve::solve;
use serde::Deserialize;
use serde_json::{Value as Json, json};

#[derive(Clone, Deserialize)]
struct Row {
    question: String,
    part: String,
    quantity: String,
    answer: String,
    verdict: String,
}

/// Rows on which Carom and the examiner differ: exercise, answer, Carom's verdict, and the reason.
const DISAGREEMENTS: &[(&str, &str, &str, &str)] = &[
    (
        "Q6",
        "deflection = α+β so tan(α+β)=...",
        "unreadable",
        "the line breaks off; that it began wrongly is for a person to say",
    ),
    (
        "Q2",
        "A: speed = 2.78, makes 46.1 with LoC // B: speed = 3.08 // both move to the right",
        "partial",
        "the examiner gives the benefit of the doubt on the direction of B, which is not said",
    ),
];

#[test]
fn the_documentation_argues_every_row_on_which_carom_differs() {
    let page = include_str!("../docs/marking.md");
    for (_, answer, verdict, reason) in DISAGREEMENTS {
        let row = format!("| `{answer}` | {verdict} | {reason} |");
        assert!(page.contains(&row), "{row}");
    }
    let section = page.split("## Where a careful examiner differs").nth(1).and_then(|rest| rest.split("\n## ").next());
    assert_eq!(section.map(|section| section.matches("\n| `").count()), Some(DISAGREEMENTS.len()));
}

/// At least so many rows in a hundred agree.
const AGREEMENT: usize = 98;

#[test]
fn carom_judges_as_a_careful_examiner_does() {
    let rows = rows();
    assert!(rows.len() >= 170, "{} rows", rows.len());
    let mut models = Models::default();
    let (mut agreed, mut faults) = (0, Vec::new());
    for row in &rows {
        let judgements = models.judged(row);
        let verdict = whole(&judgements);
        if verdict == Verdict::Correct && row.verdict != "correct" {
            faults.push(format!("ACCEPTED: {}", described(row, &judgements)));
        }
        let known = DISAGREEMENTS.iter().find(|known| known.0 == row.question && known.1 == row.answer);
        match known {
            None if verdict.name() == row.verdict => agreed += 1,
            Some(known) if known.2 == verdict.name() && known.2 != row.verdict => {}
            _ => faults.push(described(row, &judgements)),
        }
    }
    assert!(faults.is_empty(), "{} of {} rows agree\n{}", agreed, rows.len(), faults.join("\n"));
    assert!(agreed * 100 >= rows.len() * AGREEMENT, "{agreed} of {} rows agree", rows.len());
    for known in DISAGREEMENTS {
        assert!(rows.iter().any(|row| known.0 == row.question && known.1 == row.answer), "{known:?} is no row");
        assert!(known.2 != "correct", "{known:?}: no answer is accepted against the examiner");
    }
}

/// The same answer as other hands and keyboards put it, where that says the same.
fn otherwise(answer: &str) -> Vec<String> {
    let replaced = |from: &str, to: &str| answer.contains(from).then(|| answer.replace(from, to));
    let named = answer.contains(['=', ':', '≈']);
    let plain = answer.is_ascii() && !answer.contains(['$', '\\']);
    let words = answer.split(|letter: char| !letter.is_ascii_alphabetic()).any(|word| word.len() > 3);
    let wide = |sign: char| sign.to_digit(10).and_then(|digit| char::from_u32(0xff10 + digit)).unwrap_or(sign);
    let ways = [
        Some(format!("{answer}.")),
        Some(format!("\t{answer}\u{a0}")),
        Some(format!("{answer}\r\n")),
        Some(format!("\u{200b}{answer}\u{feff}")),
        Some(format!("so {answer}")),
        Some(format!("∴ {answer}")),
        Some(format!("\"{answer}\"")),
        Some(answer.chars().map(wide).collect()),
        (!named).then(|| format!("= {answer}")),
        (!named).then(|| format!("Ans: {answer}")),
        (!named).then(|| format!("the answer is {answer}")),
        (plain && !words).then(|| format!("${answer}$")),
        (plain && !words).then(|| format!("\\({answer}\\)")),
        replaced(" ", "  "),
        replaced(" ", "\u{2009}"),
        replaced("-", "−"),
        replaced("−", "-"),
        replaced("√", "sqrt"),
        replaced("sqrt", "√").filter(|_| plain),
        replaced("^", "**").filter(|_| plain),
        replaced("*", "×"),
        replaced("²", "^2"),
        replaced("°", "º"),
    ];
    ways.into_iter().flatten().filter(|other| other != answer).collect()
}

#[test]
fn what_says_the_same_in_another_way_earns_the_same() {
    let mut models = Models::default();
    let (mut compared, mut faults) = (0, Vec::new());
    for row in rows().into_iter().filter(|row| !row.answer.is_empty()) {
        let expected = whole(&models.judged(&row));
        for answer in otherwise(&row.answer) {
            let other = Row { answer, ..row.clone() };
            let judgements = models.judged(&other);
            compared += 1;
            if whole(&judgements) != expected {
                faults.push(format!("{} (typed as `{}`)", described(&other, &judgements), row.answer));
            }
        }
    }
    assert!(faults.is_empty(), "{} of {compared} differ\n{}", faults.len(), faults.join("\n"));
    assert!(compared > 2_000, "{compared}");
}

fn described(row: &Row, judgements: &[Judgement]) -> String {
    let each = |judgement: &Judgement| {
        let name = judgement.verdict.name();
        format!("{name} {} [{}]", judgement.note.unwrap_or_default(), judgement.reading.as_deref().unwrap_or_default())
    };
    let found: Vec<String> = judgements.iter().map(each).collect();
    let Row { question, part, quantity, answer, verdict } = row;
    format!("{question}{part} {quantity} `{answer}`: {verdict}; Carom: {}", found.join(" | "))
}

fn rows() -> Vec<Row> {
    let text = file("answers.jsonl");
    text.lines().map(|line| serde_json::from_str(line).expect(line)).collect()
}

fn file(name: &str) -> String {
    fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data").join(name)).unwrap()
}

/// The verdict on all that was asked together.
fn whole(judgements: &[Judgement]) -> Verdict {
    let all = |verdict: Verdict| judgements.iter().all(|judgement| judgement.verdict == verdict);
    let earned = |judgement: &Judgement| matches!(judgement.verdict, Verdict::Correct | Verdict::Partial);
    match judgements {
        [single] => single.verdict,
        _ if all(Verdict::Correct) => Verdict::Correct,
        _ if judgements.iter().any(earned) => Verdict::Partial,
        _ if judgements.iter().any(|judgement| judgement.verdict == Verdict::Unreadable) => Verdict::Unreadable,
        _ => Verdict::Wrong,
    }
}

/// The models of the exercises, solved when they are asked for.
#[derive(Default)]
struct Models {
    solved: BTreeMap<String, Model>,
}

/// Exercises whose velocities are given by **i** and **j**.
const IN_VECTORS: [&str; 6] = ["Q9", "Q10", "Q11", "Q12", "Q13", "Q14"];

impl Models {
    fn judged(&mut self, row: &Row) -> Vec<Judgement> {
        let names: Vec<&str> = match row.quantity.as_str() {
            "both_speeds" | "speeds" => vec!["speed_A", "speed_B"],
            "full_answer" => vec!["speed_A", "angle_A", "velocity_B"],
            // `A = √13, B = √20` where one of the two is asked.
            single => vec![single],
        };
        let models: Vec<Model> = names.iter().map(|name| self.model(row, name)).collect();
        let readings = read_answer(&row.answer, &models[0].vocabulary);
        match models.as_slice() {
            [single] => vec![judge(single, &readings)],
            several => judge_together(several, &readings),
        }
    }

    fn model(&mut self, row: &Row, name: &str) -> Model {
        let key = format!("{} {} {name}", row.question, row.part);
        self.solved.entry(key).or_insert_with(|| model(row, name)).clone()
    }
}

fn model(row: &Row, name: &str) -> Model {
    let question = row.question.as_str();
    let vectors = IN_VECTORS.contains(&question);
    let stated = match (question, name) {
        ("Q12", "velocity_B") => Some(("[5/2, 1/2]", Kind::Vector)),
        ("Q12", "line_of_centres") => Some(("[1, -3]", Kind::Line)),
        ("Q14", "velocity_B") => Some(("[0, 0]", Kind::Vector)),
        ("Q4", "show_that") => Some(("tan(theta)^2 = (2*e-1)/3", Kind::Shown)),
        ("Q6", "show_that") if row.part == "a" => Some(("tan(beta) = 2*tan(alpha)/(1-e)", Kind::Shown)),
        ("Q6", "show_that") => Some(("beta - alpha = atan((1+e)*tan(alpha)/(2*tan(alpha)^2+1-e))", Kind::Shown)),
        ("Q16", "show_that") => Some(("tan(theta) = (1+e)/(3-e)", Kind::Shown)),
        _ => None,
    };
    if let Some((text, kind)) = stated {
        return finished(text, kind, None, vectors);
    }
    let sphere = if name.ends_with("_B") { "B" } else { "A" };
    let (asked, kind) = match name {
        "speed_A" | "speed_B" => (vec![format!("{sphere}.after.speed")], Kind::Number),
        "angle_A" => (vec!["A.after.angle_to_loc_deg".to_owned()], Kind::Angle),
        "velocity_A" | "velocity_B" if vectors => {
            (["x", "y"].map(|axis| format!("{sphere}.after.{axis}")).to_vec(), Kind::Vector)
        }
        "velocity_A" | "velocity_B" => {
            (["n", "t"].map(|axis| format!("{sphere}.after.{axis}")).to_vec(), Kind::Velocity)
        }
        "component_A_along_loc" => (vec!["A.after.n".to_owned()], Kind::Number),
        "ke_lost" => (vec!["ke.lost".to_owned()], Kind::Number),
        "fraction_lost" => (vec!["ke.fraction_lost".to_owned()], Kind::Number),
        "impulse" => (vec!["impulse.magnitude".to_owned()], Kind::Number),
        "e" => (vec!["e".to_owned()], Kind::Number),
        "tan_theta" => (vec!["A.tan_deflection".to_owned()], Kind::Number),
        other => panic!("what is `{other}`?"),
    };
    let asked: Vec<Quantity> = asked.iter().map(|name| name.parse().unwrap()).collect();
    let solution = solve(scene(question), &asked).unwrap_or_else(|refusal| panic!("{question}: {}", refusal.reason));
    let exact = |quantity: &Quantity| solution.exact(*quantity).expect("it was asked for");
    let value = match asked.as_slice() {
        [x, y] => Expr::Vector(Box::new(exact(x)), Box::new(exact(y))),
        _ => exact(&asked[0]),
    };
    // The components of a velocity are of one sphere; its unit is that of a speed.
    let quantity = if matches!(kind, Kind::Velocity | Kind::Vector) {
        format!("{sphere}.after.speed").parse().unwrap()
    } else {
        asked[0]
    };
    let mut model = finished(&print::plain(&value), kind, Some(quantity), vectors);
    // The sense in which the sphere moves, without which an angle from BA cannot be judged.
    let along: Quantity = format!("{sphere}.after.n").parse().unwrap();
    let along = solve(scene(question), &[along]).ok().and_then(|solution| solution.exact(along));
    model.rebounds = along.and_then(|along| number(&along, &|_| None).ok()?.sign()).map(Ordering::is_lt);
    model
}

fn finished(text: &str, kind: Kind, quantity: Option<Quantity>, vectors: bool) -> Model {
    let letter = |name: &str| Letter::new(name, Range::Positive);
    let options = ModelOptions {
        kind: Some(kind),
        accept: Some("awrt 3sf".parse::<Accept>().unwrap()),
        // The letters of the exercises, and the angle of A's path before, which many solutions call alpha.
        letters: ["m", "u", "v"].into_iter().filter_map(letter).chain(Letter::new("alpha", Range::Acute)).collect(),
        quantity,
        letter: None,
    };
    let mut model = Model::read(text, &options).unwrap_or_else(|fault| panic!("{text}: {}", fault.message));
    model.vocabulary.vectors |= vectors;
    model
}

/// The scene of an exercise with its reference numbers.
fn scene(question: &str) -> Scene {
    let id = match question {
        "Challenge" => "5C-challenge".to_owned(),
        other => format!("5C-{}", other.trim_start_matches('Q').trim_end_matches('R')),
    };
    let cases: Json = serde_json::from_str(&file("seed-cases.json")).unwrap();
    let case = cases["cases"].as_array().unwrap().iter().find(|case| case["id"] == json!(id)).expect("an exercise");
    let mut scene = case["scene"].clone();
    if question == "Q14R" {
        scene["after"]["A"] = json!(["4", "3"]);
    }
    let text: SceneText = serde_json::from_value(scene).unwrap();
    Scene::read(&text, &(), Angles::Radians).unwrap_or_else(|faults| panic!("{question}: {faults:?}"))
}

/// Models of every shape that the bank's answers have.
const MODELS: [&str; 14] = [
    "4*sqrt(39)/9",
    "10/43",
    "48/25",
    "7*sqrt(2)/9 + 77/54",
    "3*cos(10*deg)",
    "sqrt(2665)/16",
    "u*sqrt(61)/6",
    "9*m",
    "u*cos(alpha)*(1-e)/2",
    "m*u*cos(alpha)*(1+e)/2",
    "(1+e)*tan(alpha)/(2*tan(alpha)^2 + 1 - e)",
    "5/2*i + j/2",
    "-19/16*i + 3*j",
    "atan(3*sqrt(3)/5)",
];

fn inferred(text: &str) -> Model {
    Model::read(text, &ModelOptions::default()).unwrap_or_else(|fault| panic!("{text}: {}", fault.message))
}

fn verdict(model: &Model, answer: &str) -> Judgement {
    judge(model, &read_answer(answer, &model.vocabulary))
}

#[test]
fn carom_accepts_whatever_it_prints_of_a_model_itself() {
    for text in MODELS {
        let model = inferred(text);
        for printed in [print::plain(&model.value), print::unicode(&model.value), print::latex(&model.value)] {
            let found = verdict(&model, &printed);
            assert_eq!(found.verdict, Verdict::Correct, "{printed} for {text}: {found:?}");
        }
    }
}

#[test]
fn one_unit_in_the_third_figure_is_never_accepted() {
    use carom::number::{Fraction, Places};
    for text in ["4*sqrt(39)/9", "16*sqrt(3)/9", "10/43", "48/25", "7*sqrt(2)/9 + 77/54", "3*cos(10*deg)", "25/7", "9"]
    {
        let model = inferred(text);
        let value = number(&model.value, &|_| None).unwrap();
        let rounded = value.rounded(&Places::SignificantFigures(3)).unwrap();
        assert_eq!(verdict(&model, &rounded.to_string()).verdict, Verdict::Correct, "{rounded} for {text}");
        let unit = Fraction::new(1, 10).power(rounded.places as i32).unwrap();
        for shifted in [rounded.to_fraction() + unit.clone(), rounded.to_fraction() - unit] {
            let shifted = carom::number::Decimal::exact(&shifted).unwrap().to_string();
            assert_ne!(verdict(&model, &shifted).verdict, Verdict::Correct, "{shifted} for {text}");
        }
    }
}

#[test]
fn notations_that_say_the_same_earn_the_same() {
    for (model, notations) in [
        ("16*sqrt(3)/9", &["16√3/9", "(16/9)√3", "16sqrt3/9", "\\frac{16\\sqrt{3}}{9}", "16 / (3√3)"][..]),
        (
            "5/2*i + j/2",
            &["5/2i + 1/2j", "½(5i + j)", "2.5i + 0.5j", "j/2 + 5i/2", "\\frac52\\mathbf{i}+\\frac12\\mathbf{j}"],
        ),
        ("48/25", &["1.92", "1.920", "48/25", "1 23/25", "192 × 10^-2", "1,92"]),
        ("v/6", &["v/6", "1/6 v", "\\frac{v}{6}", "⅙v"]),
        ("6*sin(10*deg)", &["6sin10", "6 sin 10°", "6sin(10)", "6\\sin 10^\\circ"]),
    ] {
        let model = inferred(model);
        for notation in notations {
            assert_eq!(
                verdict(&model, notation).verdict,
                Verdict::Correct,
                "{notation}: {:?}",
                verdict(&model, notation)
            );
        }
    }
}
