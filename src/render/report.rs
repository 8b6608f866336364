//! The report on a class: what a template sees of it.

use tera::{Context, Value};

use super::page::{Printer, Wanted, list, nothing, plain};
use super::{Notation, chart};
use crate::mark::report::{ClassReport, Finding, Look, MarkFigures, Mistake, Names, QuestionFigures, StudentMarks};

/// The most students, and the most things to look at, on a page; the tables have all.
const LONGEST: usize = 1000;

/// The most names that stand beside one mistake.
const NAMED: usize = 40;

/// So many questions are columns beside each other; of more, each student has a paragraph.
const COLUMNS: usize = 18;

/// The page of a class.
pub(super) fn page(class: &ClassReport, notation: Notation, wanted: &Wanted) -> Context {
    let printer = Printer { notation, wanted };
    let mut context = Context::new();
    context.insert_value("report", printer.report(class));
    context
}

impl Printer<'_> {
    fn report(self, class: &ClassReport) -> Value {
        let marks = || class.students.iter().map(|student| student.marks);
        let bands: Vec<(usize, usize)> = class.tenths().into_iter().enumerate().collect();
        let wide = class.questions.len() > COLUMNS || class.questions.iter().any(|question| question.label.len() > 3);
        let facilities: Vec<(&str, usize)> =
            class.questions.iter().map(|question| (question.label.as_str(), question.facility())).collect();
        let mistakes = |all: &[Mistake]| list(all, |mistake| self.mistake(class, mistake));
        self.thing("report")
            .with("students", || class.students.len().into())
            .with("has_names", || (class.names == Names::Shown).into())
            .with("mean", || tenths(class.mean_in_tenths()))
            .with("available", || class.available.into())
            .with("per_cent", || per_cent(class).into())
            .with("least", || marks().min().unwrap_or(0).into())
            .with("most", || marks().max().unwrap_or(0).into())
            .with("wide", || wide.into())
            .with("totals", || self.picture(chart::columns(&class.tenths())))
            .with("bands", || list(&bands, |(tenth, students)| self.band(*tenth, *students)))
            .with("facilities", || self.picture(chart::bars(&facilities)))
            .with("questions", || list(&class.questions, |question| self.item(question)))
            .with("rows", || list(first(&class.students), |student| self.row(class, student)))
            .with("more_rows", || beyond(&class.students).into())
            .with("slips", || mistakes(&class.slips))
            .with("accuracy", || mistakes(&class.accuracy))
            .with("findings", || list(&class.findings, |finding| self.finding(class, finding)))
            .with("looks", || list(first(&class.look), |look| self.look(class, look)))
            .with("more_looks", || beyond(&class.look).into())
            .with("not_marked", || class.not_marked.into())
            .value()
    }

    /// A chart, where the notation is one of a page that shows it.
    fn picture(self, picture: String) -> Value {
        if self.notation == Notation::Html { Value::safe_string(&picture) } else { nothing() }
    }

    fn band(self, tenth: usize, students: usize) -> Value {
        let range = if tenth == 9 { "90 to 100".to_owned() } else { format!("{0}0 to {0}9", tenth) };
        let range = if tenth == 0 { "0 to 9".to_owned() } else { range };
        self.thing("band").with("range", || plain(&range)).with("students", || students.into()).value()
    }

    fn item(self, question: &QuestionFigures) -> Value {
        self.thing("item")
            .with("label", || plain(&question.label))
            .with("id", || plain(&question.id))
            .with("mirrors", || plain(&question.mirrors))
            .with("scripts", || question.scripts.into())
            .with("mean", || tenths(question.mean_in_tenths()))
            .with("available", || question.available.into())
            .with("facility", || question.facility().into())
            .with("scheme", || list(&question.scheme, |mark| self.tally(question, mark)))
            .value()
    }

    fn tally(self, question: &QuestionFigures, mark: &MarkFigures) -> Value {
        let facility = question.facility_of(mark);
        self.thing("tally")
            .with("part", || plain(&mark.part))
            .with("id", || plain(&mark.id))
            .with("code", || plain(&mark.code))
            .with("won", || mark.won.into())
            .with("facility", || facility.into())
            .with("bar", || self.picture(chart::bar(facility)))
            .with("discrimination", || plain(&mark.discrimination.printed().replace('-', "−")))
            .with("why_not", || plain(mark.discrimination.why_not()))
            .value()
    }

    fn row(self, class: &ClassReport, student: &StudentMarks) -> Value {
        let cells: Vec<(&QuestionFigures, Option<usize>)> =
            class.questions.iter().zip(student.questions.iter().copied()).collect();
        self.thing("row")
            .with("student", || self.typed(&student.name))
            .with("marks", || student.marks.into())
            .with("available", || student.available.into())
            .with("per_cent", || student.per_cent().into())
            .with("cells", || list(&cells, |(question, marks)| self.cell(question, *marks)))
            .value()
    }

    fn cell(self, question: &QuestionFigures, marks: Option<usize>) -> Value {
        self.thing("cell")
            .with("label", || plain(&question.label))
            .with("marks", || marks.map_or_else(nothing, Value::from))
            .with("available", || question.available.into())
            .with("handed_in", || marks.is_some().into())
            .value()
    }

    fn mistake(self, class: &ClassReport, mistake: &Mistake) -> Value {
        let mut places: Vec<(usize, &str)> =
            mistake.places.iter().map(|made| (made.question, made.part.as_str())).collect();
        places.sort_unstable();
        places.dedup();
        let in_words = |(question, part): &(usize, &str)| {
            let label = &class.questions[*question].label;
            if part.is_empty() { label.clone() } else { format!("{label} ({part})") }
        };
        let questions: Vec<String> = places.iter().map(in_words).collect();
        let students = &mistake.students[..mistake.students.len().min(NAMED)];
        self.thing("mistake")
            .with("tag", || plain(mistake.tag))
            .with("did", || plain(mistake.did))
            .with("count", || mistake.students.len().into())
            .with("times", || mistake.places.len().into())
            .with("questions", || plain(&questions.join(", ")))
            .with("students", || list(students, |student| self.typed(&class.students[*student].name)))
            .with("more", || (mistake.students.len() - students.len()).into())
            .value()
    }

    fn finding(self, class: &ClassReport, finding: &Finding) -> Value {
        self.thing("finding")
            .with("question", || plain(&class.questions[finding.question].label))
            .with("sentence", || self.typed(&finding.sentence))
            .value()
    }

    fn look(self, class: &ClassReport, look: &Look) -> Value {
        self.thing("look")
            .with("student", || self.typed(&class.students[look.student].name))
            .with("question", || look.question.into())
            .with("part", || plain(&look.part))
            .with("place", || plain(&look.place))
            // Anybody may type a name.
            .with("typed", || if class.names == Names::Shown { self.typed(&look.typed) } else { nothing() })
            .with("reason", || plain(&look.reason))
            .value()
    }
}

fn per_cent(class: &ClassReport) -> usize {
    let available: usize = class.students.iter().map(|student| student.available).sum();
    (200 * class.marks() + available).checked_div(2 * available).unwrap_or(0)
}

fn tenths(number: usize) -> Value {
    plain(&format!("{}.{}", number / 10, number % 10))
}

fn first<T>(all: &[T]) -> &[T] {
    &all[..all.len().min(LONGEST)]
}

fn beyond<T>(all: &[T]) -> usize {
    all.len() - first(all).len()
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeMap;

    use super::super::names::tests::{below, gather};
    use super::*;
    use crate::mark::report::{Discrimination, Made};

    /// A class of one with something of everything.
    fn class() -> ClassReport {
        let discrimination = Discrimination::FewStudents;
        let (part, id, code) = ("a".to_owned(), "M1a".to_owned(), "M1".to_owned());
        let mark = MarkFigures { part: part.clone(), id, code, won: 1, discrimination };
        let question = QuestionFigures {
            label: "1".into(),
            number: 1,
            id: "rest/x".into(),
            mirrors: String::new(),
            scripts: 1,
            marks: 3,
            available: 4,
            answered: 1,
            unreadable: 0,
            scheme: vec![mark],
        };
        let (student, place) = (0, String::new());
        let mistake = Mistake {
            tag: "masses-omitted",
            did: "left the masses out",
            students: vec![student],
            places: vec![Made { student, question: 0, part: part.clone() }],
        };
        let named = |name: &str| StudentMarks {
            id: name.to_owned(),
            name: name.to_owned(),
            marks: 3,
            available: 4,
            questions: vec![Some(3)],
        };
        ClassReport {
            names: Names::Shown,
            students: vec![named("Ada")],
            available: 4,
            questions: vec![question],
            slips: vec![mistake.clone()],
            accuracy: vec![mistake],
            notes: Vec::new(),
            findings: vec![Finding { tag: "hard", question: 0, sentence: "It is hard.".into() }],
            look: vec![Look { student, question: 1, part, place, typed: "Ada".into(), reason: "Unclear.".into() }],
            not_marked: 2,
        }
    }

    #[test]
    fn carom_knows_the_names_of_a_report() {
        let context = page(&class(), Notation::Html, &Wanted::new(None));
        let mut found = BTreeMap::new();
        gather("report", &serde_json::to_value(context.get("report").unwrap()).unwrap(), &mut found);
        assert_eq!(found, below("report"));
    }

    #[test]
    fn a_class_of_any_size_has_a_page_and_what_is_left_out_is_counted() {
        let one = class();
        let students = vec![one.students[0].clone(); LONGEST + 5];
        let mistake = Mistake { students: (0..NAMED + 3).collect(), ..one.slips[0].clone() };
        let many = ClassReport { students, slips: vec![mistake], ..one };
        let context = page(&many, Notation::Html, &Wanted::new(None));
        let report = serde_json::to_value(context.get("report").unwrap()).unwrap();
        assert_eq!((report["rows"].as_array().unwrap().len(), &report["more_rows"]), (LONGEST, &5.into()));
        assert_eq!((&report["slips"][0]["count"], &report["slips"][0]["more"]), (&(NAMED + 3).into(), &3.into()));
    }
}
