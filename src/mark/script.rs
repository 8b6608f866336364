//! What a student hands in, sorted by question and part.

/// What one student handed in for one question.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Script {
    /// The student.
    pub student: String,
    /// The number of the question on the sheet.
    pub question: usize,
    /// Its parts, in the order handed in.
    pub parts: Vec<PartScript>,
}

/// What stands under one part.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct PartScript {
    /// `a`, `b`, … or empty.
    pub label: String,
    /// Answers with the names of their blanks; an answer without one says all that the part asks.
    pub answers: Vec<(Option<String>, String)>,
    /// Lines of working, in order.
    pub working: Vec<String>,
}
