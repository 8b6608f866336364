//! The page: what a template sees of a paper, every formula printed in the notation of the format.
//!
//! The names are those of [`NAMES`](super::names::NAMES); a test holds the page to them. Only what some template of the
//! format asks for is printed at all. Formulas and texts are safe, that is, not escaped again; plain words are escaped.

use std::borrow::Cow;
use std::collections::{BTreeMap, BTreeSet};

use tera::{Context, Value};

use super::Notation;
use super::names::NAMES;
use crate::diagram::Diagram;
use crate::expr::{Expr, Piece, Relation, Text};
use crate::paper::{Paper, PrintedAnswer, PrintedPart, PrintedQuestion, SchemeRow, WorkingLine};
use crate::unit::Unit;

/// The names for which the templates of a format ask.
#[derive(Clone, Debug)]
pub(super) struct Wanted {
    /// In the order of the table.
    things: Vec<(&'static str, Vec<&'static str>)>,
}

impl Wanted {
    /// All names, or those of the set, each with its thing.
    pub fn new(used: Option<&BTreeSet<(&'static str, &'static str)>>) -> Wanted {
        let is_used = |thing, name| used.is_none_or(|used| used.contains(&(thing, name)));
        let of_thing = |thing, names: &[(&'static str, _)]| {
            names.iter().map(|(name, _)| *name).filter(|name| is_used(thing, name)).collect()
        };
        Wanted { things: NAMES.iter().map(|(thing, names)| (*thing, of_thing(thing, names))).collect() }
    }

    fn of(&self, thing: &str) -> &[&'static str] {
        self.things.iter().find(|(known, _)| *known == thing).map_or(&[], |(_, names)| names)
    }
}

/// The page of a paper. Words that were not given are empty; so is the seed where the code makes the same paper again.
pub(super) fn page(paper: &Paper, notation: Notation, wanted: &Wanted) -> Context {
    let printer = Printer { notation, wanted };
    let page = printer
        .thing("")
        .with("title", || plain(&paper.title))
        .with("school", || plain(&paper.school))
        .with("date", || plain(&paper.date))
        .with("student", || printer.typed(&paper.student))
        .with("code", || plain(&paper.code))
        .with("seed", || seed(paper))
        .with("marks", || paper.marks().into())
        .with("large_print", || paper.edition.large_print.into())
        .with("answer_space", || paper.edition.answer_space.into())
        .with("questions", || printer.questions(paper));
    let mut context = Context::new();
    for (name, value) in page.names {
        context.insert_value(name, value);
    }
    context
}

/// The page of a class. What all papers have in common is said by the first.
pub(super) fn class(papers: &[Paper], notation: Notation, wanted: &Wanted) -> Context {
    let printer = Printer { notation, wanted };
    let first = papers.first().cloned().unwrap_or_default();
    let papers: Vec<(usize, &Paper)> = (1..).zip(papers).collect();
    let class = printer
        .thing("class")
        .with("title", || plain(&first.title))
        .with("school", || plain(&first.school))
        .with("date", || plain(&first.date))
        .with("large_print", || first.edition.large_print.into())
        .with("answer_space", || first.edition.answer_space.into())
        .with("papers", || list(&papers, |(place, paper)| printer.paper(*place, paper)));
    let mut context = Context::new();
    context.insert_value("class", class.value());
    context
}

fn seed(paper: &Paper) -> Value {
    paper.seed.map_or_else(|| plain(""), |seed| seed.to_string().into())
}

/// A thing whose names are being filled in.
pub(super) struct Thing<'p> {
    wanted: &'p [&'static str],
    names: BTreeMap<&'static str, Value>,
}

impl Thing<'_> {
    /// The thing with a name more, if anybody asks for it.
    pub fn with(mut self, name: &'static str, value: impl FnOnce() -> Value) -> Self {
        if self.wanted.contains(&name) {
            self.names.insert(name, value());
        }
        self
    }

    pub fn value(self) -> Value {
        self.names.into()
    }
}

/// How a page is printed.
#[derive(Clone, Copy)]
pub(super) struct Printer<'p> {
    pub notation: Notation,
    pub wanted: &'p Wanted,
}

impl<'p> Printer<'p> {
    pub fn thing(self, name: &str) -> Thing<'p> {
        Thing { wanted: self.wanted.of(name), names: BTreeMap::new() }
    }

    /// A paper of a class, whose place tells it from the others in one document.
    fn paper(self, place: usize, paper: &Paper) -> Value {
        self.thing("paper")
            .with("place", || place.into())
            .with("student", || self.typed(&paper.student))
            .with("code", || plain(&paper.code))
            .with("seed", || seed(paper))
            .with("marks", || paper.marks().into())
            .with("questions", || self.questions(paper))
            .value()
    }

    /// The questions; those with a diagram have the figures of the paper in order.
    fn questions(self, paper: &Paper) -> Value {
        let mut figures = 0;
        let mut on_page = Vec::with_capacity(paper.questions.len());
        for question in &paper.questions {
            let has_figure = !paper.edition.no_diagrams && !question.diagrams.is_empty();
            figures += usize::from(has_figure);
            on_page.push(self.question(question, has_figure.then_some(figures)));
        }
        on_page.into()
    }

    fn question(self, question: &PrintedQuestion, figure: Option<usize>) -> Value {
        self.thing("question")
            .with("number", || question.number.into())
            .with("id", || plain(&question.id))
            .with("mirrors", || plain(question.mirrors.as_deref().unwrap_or_default()))
            .with("stem", || list(&question.stem, |paragraph| self.text(paragraph)))
            .with("figure", || figure.map_or_else(|| plain(""), |figure| figure.to_string().into()))
            .with("diagrams", || {
                let diagrams = if figure.is_some() { &question.diagrams[..] } else { &[] };
                list(diagrams, |diagram| self.diagram(diagram))
            })
            .with("solution_diagrams", || list(&question.solution_diagrams, |diagram| self.diagram(diagram)))
            .with("parts", || list(&question.parts, |part| self.part(part)))
            .with("marks", || question.marks().into())
            .value()
    }

    fn diagram(self, diagram: &Diagram) -> Value {
        self.thing("diagram")
            .with("title", || plain(&diagram.title))
            .with("picture", || Value::safe_string(&self.notation.diagram(diagram)))
            .with("words", || plain(&diagram.words))
            .value()
    }

    fn part(self, part: &PrintedPart) -> Value {
        self.thing("part")
            .with("label", || plain(&part.label))
            .with("ask", || self.text(&part.ask))
            .with("answers", || list(&part.answers, |answer| self.answer(answer)))
            .with("solution_diagrams", || list(&part.solution_diagrams, |diagram| self.diagram(diagram)))
            .with("working", || list(&part.working, |line| self.line(line)))
            .with("scheme", || list(&part.scheme, |row| self.mark(row)))
            .with("marks", || part.marks().into())
            .value()
    }

    /// The unit stands with the last of the two forms, as it is written by hand: `4√39/9 ≈ 2.78 m s⁻¹`.
    fn answer(self, answer: &PrintedAnswer) -> Value {
        let quantity = |value: &Expr| self.text(&Text(vec![Piece::Quantity(value.clone(), answer.unit)]));
        let formula = |value: &Expr| self.text(&Text(vec![Piece::Formula(value.clone())]));
        self.thing("answer")
            .with("name", || self.text(&answer.name))
            .with("exact", || match (&answer.exact, &answer.rounded) {
                (None, _) => nothing(),
                (Some(exact), Some(_)) => formula(exact),
                // 60° is an angle without our help
                (Some(exact @ Expr::Degrees(_)), None) if answer.unit == Unit::Degree => formula(exact),
                (Some(exact), None) => quantity(exact),
            })
            .with("rounded", || match (&answer.exact, &answer.rounded) {
                (Some(_), Some(rounded)) => quantity(rounded),
                _ => nothing(),
            })
            .with("asked", || {
                // An angle shows that it is one; other units are those of the question.
                let bare = |value: &Expr| match value {
                    Expr::Degrees(_) => formula(value),
                    _ if answer.unit == Unit::Degree => quantity(value),
                    _ => formula(value),
                };
                match (&answer.exact, &answer.rounded) {
                    (None, _) => self.text(&answer.phrase),
                    (Some(_), Some(rounded)) if !answer.asks_exact => bare(rounded),
                    (Some(exact), _) => bare(exact),
                }
            })
            .with("phrase", || self.text(&answer.phrase))
            .value()
    }

    pub fn line(self, line: &WorkingLine) -> Value {
        self.thing("line")
            .with("words", || self.text(&line.words))
            .with("equations", || self.equations(&line.equations))
            .with("label", || line.label.map_or_else(|| plain(""), |label| label.to_string().into()))
            .value()
    }

    /// Equations whole, and in three pieces for columns; what is no equation stands in `right` alone.
    ///
    /// A left side that is the same as the one above it is left out of the pieces.
    fn equations(self, equations: &[Expr]) -> Value {
        let mut above = None;
        let mut on_page = Vec::with_capacity(equations.len());
        for equation in equations {
            let sides = sides(equation);
            let left = sides.as_ref().map(|(left, ..)| *left);
            let thing = self.thing("equation").with("whole", || self.formula(equation));
            let thing = match &sides {
                Some((left, relation, right)) => thing
                    .with("left", || if above == Some(*left) { nothing() } else { self.formula(left) })
                    .with("relation", || Value::safe_string(self.notation.relation(*relation)))
                    .with("right", || self.formula(right)),
                None => thing.with("left", nothing).with("relation", nothing).with("right", || self.formula(equation)),
            };
            on_page.push(thing.value());
            above = left;
        }
        on_page.into()
    }

    fn mark(self, row: &SchemeRow) -> Value {
        self.thing("mark")
            .with("id", || plain(&row.id))
            .with("code", || plain(&row.code))
            .with("earned", || self.text(&row.earned))
            .with("equations", || list(&row.equations, |equation| self.measured(equation, row.unit)))
            .with("note", || self.text(&row.note))
            .with("depends", || list(&row.depends, |id| plain(id)))
            .value()
    }

    pub fn text(self, text: &Text) -> Value {
        Value::safe_string(&self.notation.text(text))
    }

    /// A value with its unit, which may be none.
    fn measured(self, value: &Expr, unit: Unit) -> Value {
        Value::safe_string(&self.notation.measured(value, unit))
    }

    pub fn formula(self, formula: &Expr) -> Value {
        Value::safe_string(&self.notation.formula(formula))
    }
}

/// What stands left of the first relation of an equation, that relation, and all the rest.
///
/// `(a = b) ⇒ (c = d)` is read as `a` | `=` | `b ⇒ c = d`, so that it aligns with the equations around it.
fn sides(equation: &Expr) -> Option<(&Expr, Relation, Cow<'_, Expr>)> {
    let Expr::Relation(left, relation, right) = equation else { return None };
    match sides(left) {
        Some((first, inner, rest)) => {
            let rest = Expr::Relation(Box::new(rest.into_owned()), *relation, right.clone());
            Some((first, inner, Cow::Owned(rest)))
        }
        None => Some((left, *relation, Cow::Borrowed(right))),
    }
}

/// Words that the template is to escape.
pub(super) fn plain(words: &str) -> Value {
    Value::from(words)
}

pub(super) fn list<T>(items: &[T], on_page: impl Fn(&T) -> Value) -> Value {
    items.iter().map(on_page).collect::<Vec<Value>>().into()
}

pub(super) fn nothing() -> Value {
    Value::safe_string("")
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeMap;

    use super::super::names::names_of;
    use super::super::names::tests::{below, gather};
    use super::*;

    fn paper() -> Paper {
        let part = PrintedPart {
            label: "a".into(),
            ask: Text::words("Find"),
            answers: vec![PrintedAnswer {
                name: Text::words("speed"),
                exact: Some(Expr::integer(2)),
                rounded: None,
                asks_exact: false,
                unit: Unit::MetrePerSecond,
                phrase: Text::default(),
            }],
            solution_diagrams: vec![Diagram::default()],
            working: vec![WorkingLine {
                words: Text::default(),
                equations: vec![Expr::equation(Expr::name("v"), Expr::integer(2))],
                label: None,
            }],
            scheme: vec![SchemeRow {
                id: "B1".into(),
                code: "B1".into(),
                earned: Text::default(),
                equations: vec![Expr::integer(2)],
                unit: Unit::None,
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

    /// Names of things on a page, as text.
    fn printed<const N: usize>(thing: &serde_json::Value, names: [&str; N]) -> [String; N] {
        names.map(|name| thing[name].as_str().unwrap_or_default().to_owned())
    }

    fn as_json(on_page: impl FnOnce(Printer<'_>) -> Value, notation: Notation) -> serde_json::Value {
        serde_json::to_value(on_page(Printer { notation, wanted: &Wanted::new(None) })).unwrap()
    }

    fn chain<const N: usize>(equations: [Expr; N]) -> [[String; 3]; N] {
        let equations = as_json(|printer| printer.equations(&equations), Notation::Unicode);
        std::array::from_fn(|i| printed(&equations[i], ["left", "relation", "right"]))
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
            let (name, phrase) = Default::default();
            let answer = PrintedAnswer { name, exact, rounded, asks_exact: false, unit, phrase };
            printed(&as_json(|printer| printer.answer(&answer), Notation::Latex), ["exact", "rounded"])
        };
        let speed = |rounded| answer(Expr::integer(2), rounded, Unit::MetrePerSecond);
        assert_eq!(speed(None), [r"$2\,\mathrm{m\,s^{-1}}$", ""]);
        assert_eq!(speed(Some("2.00")), ["$2$", r"$2.00\,\mathrm{m\,s^{-1}}$"]);
        assert_eq!(answer(Expr::degrees(Expr::integer(60)), None, Unit::Degree), [r"$60^\circ$", ""]);
        assert_eq!(answer(Expr::integer(60), None, Unit::Degree), [r"$60^\circ$", ""]);
    }

    fn names_on_page(wanted: &Wanted) -> BTreeMap<String, BTreeSet<String>> {
        let context = page(&paper(), Notation::Unicode, wanted);
        let values = names_of("").iter().filter_map(|(name, _)| Some((*name, context.get(name)?)));
        let page: serde_json::Map<_, _> =
            values.map(|(name, value)| (name.to_owned(), serde_json::to_value(value).unwrap())).collect();
        let mut found = BTreeMap::new();
        gather("", &page.into(), &mut found);
        found
    }

    #[test]
    fn carom_knows_the_names_of_a_page() {
        assert_eq!(names_on_page(&Wanted::new(None)), below(""));
    }

    #[test]
    fn carom_knows_the_names_of_a_class() {
        let context = class(&[paper(), paper()], Notation::Unicode, &Wanted::new(None));
        let mut found = BTreeMap::new();
        gather("class", &serde_json::to_value(context.get("class").unwrap()).unwrap(), &mut found);
        assert_eq!(found, below("class"));
    }

    #[test]
    fn carom_prints_only_what_somebody_asks_for() {
        let used = BTreeSet::from([("", "title"), ("", "questions"), ("question", "marks"), ("part", "ask")]);
        let expected = [("", &["questions", "title"][..]), ("question", &["marks"])];
        let expected =
            expected.map(|(thing, names)| (thing.into(), names.iter().map(|name| name.to_string()).collect()));
        assert_eq!(names_on_page(&Wanted::new(Some(&used))), BTreeMap::from(expected));
    }
}
