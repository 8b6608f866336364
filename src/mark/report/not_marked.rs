//! The table of what was not marked, which can be put right and handed in again.

use crate::mark::submissions::SetAside;
use crate::table::write;

/// Line and reason, and then the row as it was typed.
pub fn not_marked_csv(set_aside: &[SetAside]) -> String {
    let header = ["line", "reason", "student", "question", "part", "blank", "answer", "working"];
    let rows = set_aside.iter().map(|aside| {
        let row = &aside.row;
        let [student, question, part, blank, answer] =
            [row.student(), row.question(), row.part(), row.blank(), row.answer()].map(str::to_owned);
        let working = row.working().collect::<Vec<_>>().join("\n");
        [row.line.to_string(), aside.reason.clone(), student, question, part, blank, answer, working]
    });
    write(header, rows)
}
