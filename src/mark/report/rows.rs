//! The table of marks: for every part handed in a row for each of its blanks, or one row.

use super::{MarkReport, MarkedScript, MarkedUnder};
use crate::mark::award::{Award, Ground, MarkedAnswer, MarkedPart, Place};
use crate::mark::judging::{Note, Verdict};
use crate::table::{one_line, write};

/// The columns of the table.
pub const MARKS: [&str; 10] =
    ["student", "question", "part", "blank", "verdict", "marks", "available", "codes", "note", "feedback"];

/// A row of the table of marks.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct MarkRow {
    /// The student.
    pub student: String,
    /// The number of the question on the sheet.
    pub question: usize,
    /// `a`, `b`, … or empty.
    pub part: String,
    /// The blank; empty if the row is of the whole part.
    pub blank: String,
    /// The verdict on what was answered.
    pub verdict: Verdict,
    /// The marks earned that stand in this row.
    pub marks: usize,
    /// All marks that stand in this row.
    pub available: usize,
    /// Each of them: `M1 A0 B1`.
    pub codes: String,
    /// A fixed tag; empty if there is nothing to note.
    pub note: String,
    /// What a teacher would say, on one line.
    pub feedback: String,
}

/// The whole table.
pub fn marks_csv(report: &MarkReport) -> String {
    write(MARKS, report.scripts.iter().flat_map(MarkedScript::rows).map(cells_of))
}

/// The cells of a row.
pub(super) fn cells_of(row: MarkRow) -> [String; MARKS.len()] {
    let number = |number: usize| number.to_string();
    [
        row.student,
        number(row.question),
        row.part,
        row.blank,
        row.verdict.name().to_owned(),
        number(row.marks),
        number(row.available),
        row.codes,
        row.note,
        row.feedback,
    ]
}

impl MarkedScript<'_> {
    /// Its rows in the table.
    pub fn rows(&self) -> Vec<MarkRow> {
        self.parts.iter().flat_map(|part| part.rows(&self.student, self.question.number)).collect()
    }
}

impl MarkedUnder<'_> {
    /// The verdict on the part as a whole.
    pub fn verdict(&self) -> Verdict {
        of_all(&self.marked)
    }

    fn rows(&self, student: &str, question: usize) -> Vec<MarkRow> {
        let part = &self.marked;
        let answers = &part.answers;
        let row = |blank: String, verdict: Verdict, answers: &[MarkedAnswer], awards: &[&Award]| MarkRow {
            student: one_line(student),
            question,
            part: part.label.clone(),
            blank,
            verdict,
            marks: awards.iter().filter(|award| award.given).count(),
            available: awards.len(),
            codes: awards.iter().map(|award| award.printed()).collect::<Vec<_>>().join(" "),
            note: note(answers, awards).to_owned(),
            feedback: one_line(&feedback(answers, awards)),
        };
        if !self.named || answers.is_empty() {
            return vec![row(String::new(), self.verdict(), answers, &part.awards.iter().collect::<Vec<_>>())];
        }
        let places: Vec<usize> = (0..part.awards.len()).map(|award| self.row_of(award)).collect();
        let each = answers.iter().enumerate().map(|(place, answer)| {
            let own = part.awards.iter().zip(&places).filter(|(_, at)| **at == place).map(|(award, _)| award);
            let own: Vec<&Award> = own.collect();
            row(answer.name.clone(), answer.judgement.verdict, std::slice::from_ref(answer), &own)
        });
        each.collect()
    }

    /// The blank in whose row a mark stands: that which earned it, else the first answered one to which it belongs, else
    /// the first.
    fn row_of(&self, award: usize) -> usize {
        let evidence = self.marked.awards[award].evidence.as_ref();
        if let Some(Place::Answer(place)) = evidence.map(|evidence| evidence.place) {
            return place.min(self.marked.answers.len() - 1);
        }
        let belongs = self.keyed.scheme.get(award).map_or(&[][..], |mark| &mark.blanks);
        let is_answered =
            |place: &&usize| self.marked.answers.get(**place).is_some_and(|answer| answer.typed.is_some());
        belongs.iter().find(is_answered).or(belongs.first()).copied().unwrap_or(0)
    }
}

/// A verdict on all blanks together.
fn of_all(part: &MarkedPart) -> Verdict {
    let verdicts: Vec<Verdict> = part.answers.iter().map(|answer| answer.judgement.verdict).collect();
    let all = |verdict: Verdict| verdicts.iter().all(|other| *other == verdict);
    let is_credited = |verdict: &Verdict| matches!(verdict, Verdict::Correct | Verdict::Partial);
    match verdicts.first() {
        None => Verdict::Blank,
        Some(first @ (Verdict::Correct | Verdict::Blank | Verdict::Unreadable)) if all(*first) => *first,
        Some(_) if !verdicts.iter().any(is_credited) => Verdict::Wrong,
        Some(_) => Verdict::Partial,
    }
}

/// The tag of a row: of a verdict, else of a mistake, else of a mark. That a mark is implied by a right answer is no news.
fn note<'r>(answers: &'r [MarkedAnswer], awards: &[&'r Award]) -> &'r str {
    let mut judged = answers.iter().filter_map(|answer| answer.judgement.note);
    // Of several blanks one that was left empty says the least.
    let judged = judged.clone().find(|note| *note != Note::Blank.tag()).or_else(|| judged.next());
    let caused = || answers.iter().find_map(|answer| Some(answer.causes.first()?.tag.as_str()));
    let awarded = || awards.iter().filter_map(|award| award.note).find(|note| *note != Ground::Implied.tag());
    judged.or_else(caused).or_else(awarded).unwrap_or_default()
}

/// What a teacher would say of answers and of the marks for them.
fn feedback(answers: &[MarkedAnswer], awards: &[&Award]) -> String {
    let said = |answer: &MarkedAnswer| {
        let cause = answer.causes.first().map(|cause| cause.sentence.as_str());
        let all = [answer.judgement.feedback.as_str(), cause.unwrap_or_default()];
        all.into_iter().filter(|words| !words.is_empty()).collect::<Vec<_>>().join(" ")
    };
    let mut sentences: Vec<String> = match answers {
        [only] => vec![said(only)],
        several => {
            let first = several.first().map(said).unwrap_or_default();
            match several.iter().all(|answer| said(answer) == first) {
                true => vec![first],
                false => several.iter().map(|answer| format!("{}: {}", answer.name, said(answer))).collect(),
            }
        }
    };
    let followed = awards.iter().find(|award| award.given && award.is(Ground::FollowThrough));
    sentences.extend(followed.map(|award| award.feedback.clone()));
    sentences.retain(|sentence| !sentence.is_empty());
    sentences.join(" ")
}
