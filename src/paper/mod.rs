//! Papers: what stands on a question sheet, a mark scheme and a page of worked solutions.
//!
//! A [`Paper`] holds everything that is printed, and nothing about how: words and formulas are
//! [`Text`], not LaTeX or HTML. The room `render` turns it into files.

mod answer;
mod choice;
mod class;
mod class_list;
mod code;
mod compose;
mod dealer;
mod key;
mod legible;
mod lock;
mod pool;
mod put_in;
mod scheme;
mod series;
mod sheet;
mod wording;
mod words;
mod working;

pub use answer::{Size, letter, sizes};
pub use choice::{choose_count, choose_marks};
pub use class::{Class, Hand, PlaceDealt, TooFew, deal};
pub use class_list::{ClassList, Student};
pub use code::{CodeFault, SheetCode};
pub use compose::compose;
pub use dealer::Dealer;
pub use key::{Blank, Key, KeyMark, KeyPaper, KeyPart, KeyQuestion, key_question};
pub use lock::{Lock, LockFault, Locked, LockedQuestion};
pub use pool::{Alike, Candidate, Likeness, Motion, Pool};
pub(crate) use series::{is_of_later_series, series};
pub use sheet::Sheet;
pub use words::{Words, words};

use crate::diagram::Diagram;
use crate::expr::{Expr, Piece, Text};
use crate::unit::Unit;

/// A sheet of questions with its solutions.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Paper {
    /// The heading of the sheet.
    pub title: String,
    /// Name of the school, empty if none was given.
    pub school: String,
    /// Date as the teacher typed it, empty if none was given.
    pub date: String,
    /// For whom it is; empty if for anybody.
    pub student: String,
    /// The few characters that all pages of the same paper share, as its [`Key`] has them.
    pub code: String,
    /// The seed that makes the same paper again; `None` where the code does.
    pub seed: Option<u64>,
    /// How it is set.
    pub edition: Edition,
    /// The questions, in order.
    pub questions: Vec<PrintedQuestion>,
}

/// How a paper is set, where a teacher has a choice.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Edition {
    /// Letters half as large again.
    pub large_print: bool,
    /// Lines to write on below each part, by its marks.
    pub answer_space: bool,
    /// Questions without their diagrams, which students then draw.
    pub no_diagrams: bool,
}

/// One question of a paper.
#[derive(Clone, Debug, PartialEq)]
pub struct PrintedQuestion {
    /// Number on the sheet, from 1.
    pub number: usize,
    /// The question's id in the bank, `rest/speeds-and-directions`.
    pub id: String,
    /// The exercise whose skills it practises, `5C-2`.
    pub mirrors: Option<String>,
    /// The paragraphs before the first part.
    pub stem: Vec<Text>,
    /// What is given, as pictures; none where a picture would give something away.
    pub diagrams: Vec<Diagram>,
    /// The pictures of its solution: before and after, of several impacts the first.
    pub solution_diagrams: Vec<Diagram>,
    /// The parts; a question without parts has one whose label is empty.
    pub parts: Vec<PrintedPart>,
}

/// One part of a question with its answer, working and marks.
#[derive(Clone, Debug, PartialEq)]
pub struct PrintedPart {
    /// `a`, `b`, … or empty.
    pub label: String,
    /// What is asked.
    pub ask: Text,
    /// Answers in the order asked.
    pub answers: Vec<PrintedAnswer>,
    /// The pictures of the later impacts that this part is the first to work on.
    pub solution_diagrams: Vec<Diagram>,
    /// The worked solution.
    pub working: Vec<WorkingLine>,
    /// The mark scheme, in the order in which the marks are earned.
    pub scheme: Vec<SchemeRow>,
}

/// One final answer.
#[derive(Clone, Debug, PartialEq)]
pub struct PrintedAnswer {
    /// What it is, in words: `speed of A`.
    pub name: Text,
    /// The exact form, simplest as a teacher writes it, or the decimal where no line holds that; none where the phrase
    /// says all, as `along the line of centres` does.
    pub exact: Option<Expr>,
    /// The certified decimal, if the answer is not already short and exact: `2.78`.
    pub rounded: Option<Expr>,
    /// Does the question ask for the exact form?
    pub asks_exact: bool,
    /// Unit of both.
    pub unit: Unit,
    /// Words that complete a direction, such as `to the line of centres`; may be empty.
    pub phrase: Text,
}

/// One line of a worked solution: words, or an equation, or both.
#[derive(Clone, Debug, PartialEq)]
pub struct WorkingLine {
    /// The sentence before the equation; may be empty.
    pub words: Text,
    /// The equation, or a chain of them on successive lines aligned at the relation.
    pub equations: Vec<Expr>,
    /// The number by which later lines refer to the last equation.
    pub label: Option<u32>,
}

/// One mark of a mark scheme.
#[derive(Clone, Debug, PartialEq)]
pub struct SchemeRow {
    /// Its id within the part, `M1a`.
    pub id: String,
    /// `B1`, `M1`, `A1`, `dM1`, `A1ft`, `A1*`.
    pub code: String,
    /// What earns it.
    pub earned: Text,
    /// The equations or values that earn it, where there are any.
    pub equations: Vec<Expr>,
    /// The unit of a single value that is an answer, as the answer has it.
    pub unit: Unit,
    /// What the marker condones or demands; may be empty.
    pub note: Text,
    /// Ids of the marks it depends on.
    pub depends: Vec<String>,
}

impl SchemeRow {
    /// What earns it with its equations or values behind it, for where a row has no place of its own for them.
    pub fn in_one_line(&self) -> Text {
        let mut whole = self.earned.clone();
        for (place, equation) in self.equations.iter().enumerate() {
            let before = match place {
                0 => ": ",
                _ if place + 1 == self.equations.len() => " and ",
                _ => ", ",
            };
            whole.0.push(Piece::Words(before.to_owned()));
            whole.0.push(Piece::Quantity(equation.clone(), self.unit));
        }
        whole
    }
}

impl PrintedPart {
    /// The number of marks: one a row.
    pub fn marks(&self) -> usize {
        self.scheme.len()
    }
}

impl PrintedQuestion {
    /// Marks of all parts together.
    pub fn marks(&self) -> usize {
        self.parts.iter().map(PrintedPart::marks).sum()
    }
}

impl Paper {
    /// Marks of all questions together.
    pub fn marks(&self) -> usize {
        self.questions.iter().map(PrintedQuestion::marks).sum()
    }
}
