//! Marks as JSON lines: a line a part, with everything that was read, found and decided.

use serde::Serialize;

use super::{MarkReport, MarkedScript, MarkedUnder};
use crate::expr::print;
use crate::mark::award::{Award, Cause, Examiner, MarkedAnswer, MarkedLine, Place};
use crate::paper::WorkingLine;

/// A line for each part that was handed in.
pub fn marks_jsonl(report: &MarkReport) -> String {
    report.scripts.iter().map(lines_of).collect()
}

/// A line for each part of a script.
pub(super) fn lines_of(script: &MarkedScript) -> String {
    let mut text = String::new();
    for part in &script.parts {
        // Strings and numbers under names that are strings always make JSON.
        text.push_str(&serde_json::to_string(&line(script, part)).unwrap_or_default());
        text.push('\n');
    }
    text
}

#[derive(Serialize)]
struct PartLine<'r> {
    student: &'r str,
    question: usize,
    id: &'r str,
    part: &'r str,
    verdict: &'static str,
    marks: usize,
    available: usize,
    answers: Vec<AnswerLine<'r>>,
    lines: Vec<LineRead<'r>>,
    awards: Vec<AwardLine<'r>>,
    followed: Vec<FollowedLine>,
}

#[derive(Serialize)]
struct AnswerLine<'r> {
    blank: &'r str,
    typed: Option<&'r str>,
    verdict: &'static str,
    reading: Option<&'r str>,
    note: Option<&'static str>,
    feedback: &'r str,
    causes: Vec<CauseLine<'r>>,
}

#[derive(Serialize)]
struct CauseLine<'r> {
    tag: &'r str,
    sentence: &'r str,
    probable: &'r [String],
}

#[derive(Serialize)]
struct LineRead<'r> {
    typed: &'r str,
    reading: Option<&'r str>,
    role: &'r str,
}

#[derive(Serialize)]
struct AwardLine<'r> {
    id: &'r str,
    code: &'static str,
    given: bool,
    by: &'static str,
    note: Option<&'static str>,
    evidence: Option<EvidenceLine<'r>>,
    feedback: &'r str,
}

#[derive(Serialize)]
struct EvidenceLine<'r> {
    line: Option<usize>,
    blank: Option<&'r str>,
    reading: &'r str,
}

#[derive(Serialize)]
struct FollowedLine {
    words: String,
    equations: Vec<String>,
    label: Option<u32>,
}

fn line<'r>(script: &'r MarkedScript, part: &'r MarkedUnder) -> PartLine<'r> {
    let marked = &part.marked;
    PartLine {
        student: &script.student,
        question: script.question.number,
        id: &script.question.id,
        part: &marked.label,
        verdict: part.verdict().name(),
        marks: marked.marks(),
        available: marked.awards.len(),
        answers: marked.answers.iter().map(answer).collect(),
        lines: marked.lines.iter().map(read).collect(),
        awards: marked.awards.iter().map(|one| award(one, &marked.answers)).collect(),
        followed: script.from_own_values(part).iter().map(followed).collect(),
    }
}

fn answer(answer: &MarkedAnswer) -> AnswerLine<'_> {
    AnswerLine {
        blank: &answer.name,
        typed: answer.typed.as_deref(),
        verdict: answer.judgement.verdict.name(),
        reading: answer.judgement.reading.as_deref(),
        note: answer.judgement.note,
        feedback: &answer.judgement.feedback,
        causes: answer
            .causes
            .iter()
            .map(|Cause { tag, sentence, probable }| CauseLine { tag, sentence, probable })
            .collect(),
    }
}

fn read(line: &MarkedLine) -> LineRead<'_> {
    LineRead { typed: &line.typed, reading: line.reading.as_deref(), role: &line.role }
}

fn award<'r>(award: &'r Award, answers: &'r [MarkedAnswer]) -> AwardLine<'r> {
    let evidence = award.evidence.as_ref().map(|evidence| {
        let (line, blank) = match evidence.place {
            Place::Line(number) => (Some(number), None),
            Place::Answer(place) => (None, answers.get(place).map(|answer| answer.name.as_str())),
        };
        EvidenceLine { line, blank, reading: &evidence.reading }
    });
    let by = match award.by {
        Examiner::Marker => "marker",
        Examiner::Person => "person",
    };
    let (code, note) = (award.code.name(), award.note);
    AwardLine { id: &award.id, code, given: award.given, by, note, evidence, feedback: &award.feedback }
}

fn followed(line: &WorkingLine) -> FollowedLine {
    let equations = line.equations.iter().map(print::plain).collect();
    FollowedLine { words: print::text_unicode(&line.words), equations, label: line.label }
}
