//! A class at a glance: on one screen of a terminal, or as JSON.

use serde_json::{Value as Json, json};

use super::super::output::{count, line_length, table};
use crate::expr::print::words_unicode;
use crate::mark::report::{ClassReport, Discrimination, Look, MarkFigures, Mistake, Names, QuestionFigures};

/// A screen has 24 lines: so many questions, and so much of everything else.
const QUESTIONS: usize = 8;
const TOLD: usize = 3;

/// The report as JSON; the mean is in marks, facilities are in per cent, and discrimination is from -1 to 1.
pub fn as_json(report: &ClassReport) -> Json {
    let name = |student: &usize| report.students[*student].id.as_str();
    let notes: Vec<Json> = report.notes.iter().map(|one| json!({"note": one.note, "count": one.count})).collect();
    let mistake = |mistake: &Mistake| {
        let students: Vec<&str> = mistake.students.iter().map(name).collect();
        json!({"tag": mistake.tag, "did": mistake.did, "times": mistake.places.len(), "students": students})
    };
    let finding = |finding: &crate::mark::report::Finding| json!({"tag": finding.tag, "question": report.questions[finding.question].label, "sentence": finding.sentence});
    let look = |look: &Look| {
        json!({
            "student": name(&look.student), "question": look.question, "part": look.part, "place": look.place,
            "typed": typed(report, look), "reason": look.reason,
        })
    };
    json!({
        "students": report.students.len(),
        "marks": report.marks(),
        "mean": report.mean_in_tenths() as f64 / 10.0,
        "available": report.available,
        "questions": report.questions.iter().map(question).collect::<Vec<_>>(),
        "slips": report.slips.iter().map(mistake).collect::<Vec<_>>(),
        "accuracy": report.accuracy.iter().map(mistake).collect::<Vec<_>>(),
        "findings": report.findings.iter().map(finding).collect::<Vec<_>>(),
        "notes": notes,
        "look": report.look.iter().map(look).collect::<Vec<_>>(),
        "not_marked": report.not_marked,
    })
}

fn question(question: &QuestionFigures) -> Json {
    let mark = |mark: &MarkFigures| {
        let discrimination = match mark.discrimination {
            Discrimination::Hundredths(hundredths) => json!(f64::from(hundredths) / 100.0),
            _ => Json::Null,
        };
        json!({
            "part": mark.part, "id": mark.id, "code": mark.code, "won": mark.won,
            "facility": question.facility_of(mark), "discrimination": discrimination,
        })
    };
    json!({
        "number": question.number, "id": question.id, "mirrors": question.mirrors, "scripts": question.scripts,
        "marks": question.marks, "available": question.available, "facility": question.facility(),
        "scheme": question.scheme.iter().map(mark).collect::<Vec<_>>(),
    })
}

/// What was typed; nothing where names are left out, since anybody may type a name.
fn typed<'r>(report: &ClassReport, look: &'r Look) -> &'r str {
    if report.names == Names::Shown { &look.typed } else { "" }
}

/// The report in words.
pub fn in_words(report: &ClassReport) -> String {
    let (mean, students) = (tenths(report.mean_in_tenths()), count(report.students.len(), "student"));
    let mut text = format!("{students}, {mean} of {} marks on average", report.available);
    let earned = || report.students.iter().map(|student| student.marks);
    if let (Some(least), Some(most)) = (earned().min(), earned().max().filter(|_| report.students.len() > 1)) {
        text.push_str(&format!(", from {least} to {most}"));
    }
    text.push_str("\n\n");
    text.push_str(&questions(report));
    let findings = report.findings.iter().map(|finding| {
        let label = &report.questions[finding.question].label;
        format!("question {label}: {}", finding.sentence)
    });
    text.push_str(&told("What looks wrong", "report.html", report.findings.len(), findings));
    let mistakes: Vec<&Mistake> = report.slips.iter().chain(&report.accuracy).collect();
    let did = mistakes.iter().map(|mistake| format!("{:>3} {}", mistake.students.len(), mistake.did));
    text.push_str(&told("Mistakes, and how many students made them", "report.html", mistakes.len(), did));
    let looks = report.look.iter().map(|look| looked_at(report, look));
    text.push_str(&told("For you to look at", "report.html", report.look.len(), looks));
    text
}

/// A heading, the first lines below it, and where the others stand.
fn told(heading: &str, rest: &str, all: usize, lines: impl Iterator<Item = String>) -> String {
    if all == 0 {
        return String::new();
    }
    let mut text = match all > TOLD {
        true => format!("{heading}: {all}, all in `{rest}`\n"),
        false => format!("{heading}: {all}\n"),
    };
    for line in lines.take(TOLD) {
        text.push_str(&format!("  {}\n", short(&line, line_length() - 2)));
    }
    text
}

/// A row for each question, or for the hardest of them.
fn questions(report: &ClassReport) -> String {
    let mut shown: Vec<&QuestionFigures> = report.questions.iter().collect();
    if shown.len() > QUESTIONS {
        shown.sort_by_key(|question| question.facility());
        shown.truncate(QUESTIONS);
    }
    let heads = ["Question", "scripts", "mean mark", "won", "won least often"];
    let mut rows = vec![heads.map(str::to_owned).to_vec()];
    rows.extend(shown.iter().map(|question| {
        vec![
            format!("{:>8}", short(&question.label, LABEL)),
            format!("{:>7}", question.scripts),
            format!("{:>4} of {}", tenths(question.mean_in_tenths()), question.available),
            format!("{:>3}%", question.facility()),
            least_won(question),
        ]
    }));
    let mut text = table(&rows);
    if report.questions.len() > QUESTIONS {
        text.push_str(&format!("the {QUESTIONS} hardest of {}, all in `report.html`\n", report.questions.len()));
    }
    text
}

/// The first of the marks that the fewest won.
fn least_won(question: &QuestionFigures) -> String {
    let least = question.scheme.iter().min_by_key(|mark| mark.won);
    least.map_or_else(String::new, |mark| {
        let part = if mark.part.is_empty() { String::new() } else { format!("({}) ", mark.part) };
        format!("{}: {} of {}", short(&format!("{part}{}", mark.id), LABEL), mark.won, question.scripts)
    })
}

fn looked_at(report: &ClassReport, look: &Look) -> String {
    let part = if look.part.is_empty() { String::new() } else { format!("({})", look.part) };
    let place = if look.place.is_empty() { String::new() } else { format!(", {}", look.place) };
    let typed = typed(report, look);
    let said = if typed.is_empty() { String::new() } else { format!(": {}", short(typed, LONGEST)) };
    let student = short(&report.students[look.student].name, LONGEST);
    format!("{student}, question {}{part}{place}{said}", look.question)
}

/// The longest name of a question or of a mark.
const LABEL: usize = 20;

/// The longest name, and the longest answer, of which more is told than one reads.
const LONGEST: usize = 40;

/// Harmless, and not longer than that.
fn short(typed: &str, longest: usize) -> String {
    let typed = words_unicode(typed);
    match typed.char_indices().nth(longest) {
        Some(_) => typed.chars().take(longest - 1).chain(['…']).collect(),
        None => typed,
    }
}

fn tenths(number: usize) -> String {
    format!("{}.{}", number / 10, number % 10)
}
