//! The page: what a template sees of a paper, every formula printed in the notation of the format.
//!
//! The fields are the names that templates may use; tests hold [`NAMES`](super::names::NAMES) and `templates/README.md` to them.
//! Fields of type [`Value`] are printed already and are not escaped again; `String`s are escaped.

use serde::Serialize;
use tera::Value;

use super::Notation;
use crate::diagram::Diagram;
use crate::expr::{Expr, Piece, Relation, Text};
use crate::paper::{Paper, PrintedAnswer, PrintedPart, PrintedQuestion, SchemeRow, WorkingLine};
use crate::unit::Unit;

/// A paper. Words that were not given are empty; so is the seed of the reference paper.
#[derive(Serialize)]
pub(super) struct Page {
    title: String,
    school: String,
    date: String,
    code: String,
    seed: String,
    marks: usize,
    large_print: bool,
    answer_space: bool,
    questions: Vec<Question>,
}

#[derive(Serialize)]
struct Question {
    number: usize,
    id: String,
    mirrors: String,
    stem: Vec<Value>,
    figure: String,
    diagrams: Vec<Picture>,
    solution_diagrams: Vec<Picture>,
    parts: Vec<Part>,
    marks: usize,
}

#[derive(Serialize)]
struct Picture {
    title: String,
    picture: Value,
    words: String,
}

#[derive(Serialize)]
struct Part {
    label: String,
    ask: Value,
    answers: Vec<Answer>,
    working: Vec<Line>,
    scheme: Vec<Mark>,
    marks: usize,
}

/// The unit stands with the last of the two forms, as it is written by hand: `4√39/9 ≈ 2.78 m s⁻¹`.
#[derive(Serialize)]
struct Answer {
    name: Value,
    exact: Value,
    rounded: Value,
    phrase: Value,
}

#[derive(Serialize)]
struct Line {
    words: Value,
    equations: Vec<Equation>,
    label: String,
}

/// An equation whole, and in three pieces for columns; what is no equation stands in `right` alone.
///
/// In a chain a left side that is the same as the one above it is left out of the pieces.
#[derive(Serialize)]
struct Equation {
    whole: Value,
    left: Value,
    relation: Value,
    right: Value,
}

#[derive(Serialize)]
struct Mark {
    id: String,
    code: String,
    earned: Value,
    equation: Value,
    note: Value,
    depends: Vec<String>,
}

/// The page of a paper.
pub(super) fn page(paper: &Paper, notation: Notation) -> Page {
    Page {
        title: paper.title.clone(),
        school: paper.school.clone(),
        date: paper.date.clone(),
        code: paper.code.clone(),
        seed: paper.seed.map(|seed| seed.to_string()).unwrap_or_default(),
        marks: paper.marks(),
        large_print: paper.edition.large_print,
        answer_space: paper.edition.answer_space,
        questions: questions_on(paper, notation),
    }
}

/// The questions; those with a diagram have the figures of the paper in order.
fn questions_on(paper: &Paper, notation: Notation) -> Vec<Question> {
    let mut figures = 0;
    let number_of_figure = |question: &PrintedQuestion| {
        if paper.edition.no_diagrams || question.diagrams.is_empty() {
            return None;
        }
        figures += 1;
        Some(figures)
    };
    let figures: Vec<Option<usize>> = paper.questions.iter().map(number_of_figure).collect();
    paper.questions.iter().zip(figures).map(|(question, figure)| question_on(question, figure, notation)).collect()
}

fn question_on(question: &PrintedQuestion, figure: Option<usize>, notation: Notation) -> Question {
    let drawn = |diagrams: &[Diagram]| diagrams.iter().map(|diagram| picture(diagram, notation)).collect();
    Question {
        number: question.number,
        id: question.id.clone(),
        mirrors: question.mirrors.clone().unwrap_or_default(),
        stem: question.stem.iter().map(|paragraph| words(paragraph, notation)).collect(),
        figure: figure.map(|figure| figure.to_string()).unwrap_or_default(),
        diagrams: figure.map(|_| drawn(&question.diagrams)).unwrap_or_default(),
        solution_diagrams: drawn(&question.solution_diagrams),
        parts: question.parts.iter().map(|part| part_on(part, notation)).collect(),
        marks: question.marks(),
    }
}

fn picture(diagram: &Diagram, notation: Notation) -> Picture {
    Picture {
        title: diagram.title.clone(),
        picture: Value::safe_string(&notation.diagram(diagram)),
        words: diagram.words.clone(),
    }
}

fn part_on(part: &PrintedPart, notation: Notation) -> Part {
    Part {
        label: part.label.clone(),
        ask: words(&part.ask, notation),
        answers: part.answers.iter().map(|answer| answer_on(answer, notation)).collect(),
        working: part.working.iter().map(|line| line_on(line, notation)).collect(),
        scheme: part.scheme.iter().map(|row| mark_on(row, notation)).collect(),
        marks: part.marks(),
    }
}

fn answer_on(answer: &PrintedAnswer, notation: Notation) -> Answer {
    let quantity = |value: &Expr| words(&Text(vec![Piece::Quantity(value.clone(), answer.unit)]), notation);
    let formula = |value: &Expr| words(&Text(vec![Piece::Formula(value.clone())]), notation);
    let (exact, rounded) = match (&answer.exact, &answer.rounded) {
        (None, _) => (nothing(), nothing()),
        (Some(exact), Some(rounded)) => (formula(exact), quantity(rounded)),
        // 60° is an angle without our help
        (Some(exact @ Expr::Degrees(_)), None) if answer.unit == Unit::Degree => (formula(exact), nothing()),
        (Some(exact), None) => (quantity(exact), nothing()),
    };
    Answer { name: words(&answer.name, notation), exact, rounded, phrase: words(&answer.phrase, notation) }
}

fn line_on(line: &WorkingLine, notation: Notation) -> Line {
    let mut above = None;
    let mut equations = Vec::with_capacity(line.equations.len());
    for equation in &line.equations {
        let sides = sides(equation);
        let left = sides.as_ref().map(|(left, _, _)| (*left).clone());
        equations.push(match sides {
            Some((left, relation, right)) => Equation {
                whole: formula(equation, notation),
                left: if above.as_ref() == Some(left) { nothing() } else { formula(left, notation) },
                relation: Value::safe_string(notation.relation(relation)),
                right: formula(&right, notation),
            },
            None => {
                let whole = formula(equation, notation);
                Equation { whole: whole.clone(), left: nothing(), relation: nothing(), right: whole }
            }
        });
        above = left;
    }
    Line {
        words: words(&line.words, notation),
        equations,
        label: line.label.map(|label| label.to_string()).unwrap_or_default(),
    }
}

fn mark_on(row: &SchemeRow, notation: Notation) -> Mark {
    Mark {
        id: row.id.clone(),
        code: row.code.clone(),
        earned: words(&row.earned, notation),
        equation: row.equation.as_ref().map_or_else(nothing, |equation| formula(equation, notation)),
        note: words(&row.note, notation),
        depends: row.depends.clone(),
    }
}

/// What stands left of the first relation of an equation, that relation, and all the rest.
///
/// `(a = b) ⇒ (c = d)` is read as `a` | `=` | `b ⇒ c = d`, so that it aligns with the equations around it.
fn sides(equation: &Expr) -> Option<(&Expr, Relation, Expr)> {
    let Expr::Relation(left, relation, right) = equation else { return None };
    match sides(left) {
        Some((first, inner, rest)) => Some((first, inner, Expr::Relation(Box::new(rest), *relation, right.clone()))),
        None => Some((left, *relation, (**right).clone())),
    }
}

fn words(text: &Text, notation: Notation) -> Value {
    Value::safe_string(&notation.text(text))
}

fn formula(value: &Expr, notation: Notation) -> Value {
    Value::safe_string(&notation.formula(value))
}

fn nothing() -> Value {
    Value::safe_string("")
}

#[cfg(test)]
mod tests {
    use std::collections::{BTreeMap, BTreeSet};

    use super::super::names::NAMES;
    use super::*;

    fn paper() -> Paper {
        let part = PrintedPart {
            label: "a".into(),
            ask: Text::words("Find"),
            answers: vec![PrintedAnswer {
                name: Text::words("speed"),
                exact: Some(Expr::integer(2)),
                rounded: None,
                unit: Unit::MetrePerSecond,
                phrase: Text::default(),
            }],
            working: vec![WorkingLine {
                words: Text::default(),
                equations: vec![Expr::equation(Expr::name("v"), Expr::integer(2))],
                label: None,
            }],
            scheme: vec![SchemeRow {
                id: "B1".into(),
                code: "B1".into(),
                earned: Text::default(),
                equation: None,
                note: Text::default(),
                depends: Vec::new(),
            }],
        };
        let question = PrintedQuestion {
            number: 1,
            id: "x/y".into(),
            mirrors: None,
            stem: Vec::new(),
            diagrams: vec![Diagram::default()],
            solution_diagrams: vec![Diagram::default()],
            parts: vec![part],
        };
        Paper { questions: vec![question], ..Paper::default() }
    }

    fn chain<const N: usize>(equations: [Expr; N]) -> [[String; 3]; N] {
        let working = WorkingLine { words: Text::default(), equations: equations.to_vec(), label: None };
        let line = line_on(&working, Notation::Unicode);
        let printed = |value: &Value| value.as_str().unwrap_or_default().to_owned();
        std::array::from_fn(|i| {
            let Equation { left, relation, right, .. } = &line.equations[i];
            [left, relation, right].map(printed)
        })
    }

    #[test]
    fn carom_knows_where_equations_align() {
        let relation = |left, sign, right| Expr::Relation(Box::new(left), sign, Box::new(right));
        let (v, two) = (|| Expr::name("v"), || Expr::integer(2));
        assert_eq!(chain([Expr::equation(v(), two())]), [["v", "=", "2"]]);
        let repeated = [Expr::equation(v(), two()), relation(v(), Relation::Approximately, two())];
        assert_eq!(chain(repeated), [["v", "=", "2"], ["", "≈", "2"]]);
        let implied = relation(Expr::equation(two(), v()), Relation::Implies, Expr::equation(v(), two()));
        assert_eq!(chain([implied]), [["2", "=", "v\u{a0}⇒\u{a0}v\u{a0}=\u{a0}2"]]);
        assert_eq!(chain([two()]), [["", "", "2"]]);
        let apart = [Expr::equation(v(), two()), two(), Expr::equation(v(), two())];
        assert_eq!(chain(apart).map(|[left, _, _]| left), ["v", "", "v"]);
    }

    #[test]
    fn carom_knows_where_a_unit_stands() {
        let answer = |exact: Expr, rounded: Option<&str>, unit| {
            let rounded = rounded.map(|digits| Expr::Decimal(digits.into()));
            let exact = Some(exact);
            let answer = PrintedAnswer { name: Text::default(), exact, rounded, unit, phrase: Text::default() };
            let on_page = answer_on(&answer, Notation::Latex);
            [on_page.exact, on_page.rounded].map(|value| value.as_str().unwrap_or_default().to_owned())
        };
        let speed = |rounded| answer(Expr::integer(2), rounded, Unit::MetrePerSecond);
        assert_eq!(speed(None), [r"$2\,\mathrm{m\,s^{-1}}$", ""]);
        assert_eq!(speed(Some("2.00")), ["$2$", r"$2.00\,\mathrm{m\,s^{-1}}$"]);
        assert_eq!(answer(Expr::degrees(Expr::integer(60)), None, Unit::Degree), [r"$60^\circ$", ""]);
        assert_eq!(answer(Expr::integer(60), None, Unit::Degree), [r"$60^\circ$", ""]);
    }

    /// The fields of a page and, for its lists, of the first thing in them.
    fn gather(thing: &str, value: &serde_json::Value, found: &mut BTreeMap<String, BTreeSet<String>>) {
        let Some(fields) = value.as_object() else { return };
        found.insert(thing.to_owned(), fields.keys().cloned().collect());
        let things = [
            ("questions", "question"),
            ("diagrams", "diagram"),
            ("solution_diagrams", "diagram"),
            ("parts", "part"),
            ("answers", "answer"),
            ("working", "line"),
            ("equations", "equation"),
            ("scheme", "mark"),
        ];
        for (list, thing) in things {
            if let Some(first) = fields.get(list).and_then(|list| list.get(0)) {
                gather(thing, first, found);
            }
        }
    }

    #[test]
    fn carom_knows_the_names_of_a_page() {
        let mut found = BTreeMap::new();
        gather("", &serde_json::to_value(page(&paper(), Notation::Unicode)).unwrap(), &mut found);
        let listed: BTreeMap<String, BTreeSet<String>> = NAMES
            .iter()
            .map(|(thing, names)| (thing.to_string(), names.iter().map(|name| name.to_string()).collect()))
            .collect();
        assert_eq!(found, listed);
    }
}
