//! The figures of a question: how hard it was, and each mark of its scheme.

use super::discrimination::{Discrimination, Sums};
use super::entries::Class;
use super::rounded;
use crate::mark::judging::Verdict;

/// The figures of a question.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct QuestionFigures {
    /// What it is called: its number, or its id if it has not the same number on all sheets.
    pub label: String,
    /// Its number on the first sheet that has it.
    pub number: usize,
    /// Its id in the bank.
    pub id: String,
    /// The exercise that it mirrors; empty if there is none.
    pub mirrors: String,
    /// How many handed it in.
    pub scripts: usize,
    /// How many of them wrote something there: an answer or a line of working.
    pub answered: usize,
    /// All marks earned with it.
    pub marks: usize,
    /// The marks of one script.
    pub available: usize,
    /// How many wrote something there that could not be read.
    pub unreadable: usize,
    /// Each mark of its scheme.
    pub scheme: Vec<MarkFigures>,
}

/// The figures of a mark.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct MarkFigures {
    /// The label of the part.
    pub part: String,
    /// Its id within the part.
    pub id: String,
    /// Its code.
    pub code: String,
    /// How many of those who handed in the question won it.
    pub won: usize,
    /// Does it tell strong students from weak ones?
    pub discrimination: Discrimination,
}

impl QuestionFigures {
    /// The share of the marks that was earned, in whole per cent.
    pub fn facility(&self) -> usize {
        rounded(100 * self.marks, self.scripts * self.available)
    }

    /// The mean mark in tenths of a mark, rounded.
    pub fn mean_in_tenths(&self) -> usize {
        rounded(10 * self.marks, self.scripts)
    }

    /// The share of those who handed in the question that won a mark of it, in whole per cent.
    pub fn facility_of(&self, mark: &MarkFigures) -> usize {
        rounded(100 * mark.won, self.scripts)
    }
}

/// The figures of all questions.
pub(super) fn figures(class: &Class) -> Vec<QuestionFigures> {
    (0..class.columns.len()).map(|column| of_question(class, column)).collect()
}

fn of_question(class: &Class, place: usize) -> QuestionFigures {
    let column = &class.columns[place];
    let mut scheme: Vec<(MarkFigures, Sums)> = Vec::new();
    let (mut scripts, mut answered, mut marks, mut available, mut unreadable) = (0, 0, 0, 0, 0);
    let mut mirrors = None;
    for (student, script) in class.scripts(place) {
        let total = class.entries[student].marks();
        scripts += 1;
        marks += script.marks();
        available = available.max(script.available());
        mirrors = mirrors.or(script.question.mirrors.as_deref());
        let answers = || script.parts.iter().flat_map(|part| &part.marked.answers);
        let is_written = answers().any(|answer| answer.typed.is_some())
            || script.parts.iter().any(|part| !part.marked.lines.is_empty());
        answered += usize::from(is_written);
        unreadable += usize::from(answers().any(|answer| answer.judgement.verdict == Verdict::Unreadable));
        for part in &script.question.parts {
            let handed = script.parts.iter().find(|handed| handed.marked.label == part.label);
            let rest = total - handed.map_or(0, |handed| handed.marked.marks());
            for mark in &part.scheme {
                let awards = handed.into_iter().flat_map(|handed| &handed.marked.awards);
                let won = awards.into_iter().any(|award| award.id == mark.id && award.given);
                let known = scheme.iter().position(|(known, _)| known.part == part.label && known.id == mark.id);
                let at = known.unwrap_or_else(|| {
                    let (part, id, code) = (part.label.clone(), mark.id.clone(), mark.code.name().to_owned());
                    let discrimination = Discrimination::FewStudents;
                    scheme.push((MarkFigures { part, id, code, won: 0, discrimination }, Sums::default()));
                    scheme.len() - 1
                });
                scheme[at].0.won += usize::from(won);
                scheme[at].1.add(won, rest);
            }
        }
    }
    let scheme = scheme.into_iter().map(|(mark, sums)| MarkFigures { discrimination: sums.discrimination(), ..mark });
    QuestionFigures {
        label: if column.everywhere { column.number.to_string() } else { column.id.to_owned() },
        number: column.number,
        id: column.id.to_owned(),
        mirrors: mirrors.unwrap_or_default().to_owned(),
        scripts,
        answered,
        marks,
        available,
        unreadable,
        scheme: scheme.collect(),
    }
}
