//! The report as tables for a spreadsheet: by student, by mark, and by mistake.

use super::{ClassReport, Mistake, QuestionFigures};
use crate::table::{append, one_line};

/// A row for each student: the marks of each question, empty where it was not handed in. Where the key of a class has
/// names, the second column has them.
pub fn students_table(report: &ClassReport) -> String {
    let has_names = report.students.iter().any(|student| !student.own_name().is_empty());
    let head = ["student"].into_iter().chain(has_names.then_some("name")).chain(["marks", "available", "per_cent"]);
    let head = head.map(str::to_owned);
    let head = head.chain(report.questions.iter().map(|question| format!("question {}", question.label)));
    let rows = report.students.iter().map(|student| {
        let sums = [student.marks, student.available, student.per_cent()].map(Some).into_iter();
        let cells = sums.chain(student.questions.iter().copied());
        let cells = cells.map(|cell| cell.map(|marks| marks.to_string()).unwrap_or_default());
        let name = has_names.then(|| one_line(student.own_name()));
        [one_line(&student.id)].into_iter().chain(name).chain(cells).collect()
    });
    append(std::iter::once(head.collect::<Vec<String>>()).chain(rows))
}

/// A row for each mark: how many won it, and whether it tells strong students from weak ones.
pub fn marks_table(report: &ClassReport) -> String {
    let head = ["question", "id", "mirrors", "part", "mark", "code", "scripts", "won", "facility", "discrimination"];
    let head = head.into_iter().chain(["why_none"]).map(str::to_owned).collect();
    let rows = report.questions.iter().flat_map(|question| question.scheme.iter().map(move |mark| (question, mark)));
    let rows = rows.map(|(question, mark)| {
        let QuestionFigures { label, id, mirrors, scripts, .. } = question;
        let numbers = [*scripts, mark.won, question.facility_of(mark)].map(|number| number.to_string());
        let mut cells = vec![label.clone(), id.clone(), mirrors.clone()];
        cells.extend([mark.part.clone(), mark.id.clone(), mark.code.clone()]);
        cells.extend(numbers);
        cells.extend([mark.discrimination.printed(), mark.discrimination.why_not().to_owned()]);
        cells
    });
    append(std::iter::once(head).chain(rows))
}

/// A row for each time a student made a mistake: slips first, then what was lost for figures.
pub fn mistakes_table(report: &ClassReport) -> String {
    let head = ["tag", "did", "student", "question", "part"].map(str::to_owned).to_vec();
    let rows = report.slips.iter().chain(&report.accuracy).flat_map(|mistake: &Mistake| {
        mistake.places.iter().map(|made| {
            let student = one_line(&report.students[made.student].id);
            let question = report.questions[made.question].label.clone();
            vec![mistake.tag.to_owned(), mistake.did.to_owned(), student, question, made.part.clone()]
        })
    });
    append(std::iter::once(head).chain(rows))
}
