//! The page that a student gets back: what a template sees of it.
//!
//! All that a student typed is plain words, escaped for the notation, cut where nobody would read on, and breakable
//! anywhere, so that a line of ten thousand letters leaves no page.

use tera::{Context, Value};

use super::Notation;
use super::page::{Printer, Wanted, list, nothing, plain};
use crate::bank::EarnedFor;
use crate::expr::{Piece, Text, print, read_markup};
use crate::mark::judging::{Note, Verdict};
use crate::mark::report::{Feedback, MarkedScript, MarkedUnder};
use crate::mark::{Award, Cause, Examiner, KeyedMark, KeyedPart, MarkedAnswer, MarkedLine, MarkedPart, Place};
use crate::mechanics::Quantity;

/// The most letters of what a student typed in one place.
const LONGEST: usize = 300;

/// So many letters in a row are broken if they must be.
const UNBROKEN: usize = 12;

/// The page of a student.
pub(super) fn page(feedback: &Feedback, notation: Notation, wanted: &Wanted) -> Context {
    let printer = Printer { notation, wanted };
    let page = printer
        .thing("feedback")
        .with("student", || printer.typed(&feedback.shown))
        .with("code", || plain(feedback.code))
        .with("marks", || feedback.marks().into())
        .with("available", || feedback.available().into())
        .with("scripts", || list(&feedback.scripts, |script| printer.script(script)))
        .value();
    let mut context = Context::new();
    context.insert_value("feedback", page);
    context
}

impl Printer<'_> {
    fn script(self, script: &MarkedScript) -> Value {
        self.thing("script")
            .with("number", || script.question.number.into())
            .with("id", || plain(&script.question.id))
            .with("marks", || script.marks().into())
            .with("available", || script.available().into())
            .with("replies", || list(&script.parts, |part| self.reply(script, part)))
            .value()
    }

    fn reply(self, script: &MarkedScript, part: &MarkedUnder) -> Value {
        let marked = &part.marked;
        let lines: Vec<(usize, &MarkedLine)> = (1..).zip(&marked.lines).collect();
        self.thing("reply")
            .with("label", || plain(&marked.label))
            .with("verdict", || plain(part.verdict().name()))
            .with("marks", || marked.marks().into())
            .with("available", || marked.awards.len().into())
            .with("responses", || list(&marked.answers, |answer| self.response(marked, answer)))
            .with("lines", || list(&lines, |(number, line)| self.written(*number, line)))
            .with("awards", || {
                let awards: Vec<(usize, &Award)> = marked.awards.iter().enumerate().collect();
                list(&awards, |(place, award)| self.award(award, part.keyed.scheme.get(*place), part))
            })
            .with("followed", || list(&script.from_own_values(part), |line| self.line(line)))
            .value()
    }

    fn response(self, part: &MarkedPart, answer: &MarkedAnswer) -> Value {
        let typed = answer.typed.as_deref().unwrap_or_default();
        let reading = answer.judgement.reading.as_deref().unwrap_or_default();
        self.thing("response")
            .with("name", || plain(&answer.name))
            .with("typed", || self.typed(typed))
            .with("reading", || self.typed(reading))
            .with("verdict", || plain(answer.judgement.verdict.name()))
            // Where nothing is noted the verdict says it all.
            .with("comment", || {
                // A mistake that was found out says better what a likeness to the right angle hints at.
                let likeness = [Note::Complement, Note::Supplement, Note::Sign, Note::EarlyRounding].map(Note::tag);
                let is_noted = match answer.judgement.note {
                    Some(note) if likeness.contains(&note) => answer.causes.is_empty(),
                    Some(_) => answer.judgement.verdict != Verdict::Blank,
                    None => false,
                };
                plain(if is_noted { &answer.judgement.feedback } else { "" })
            })
            .with("causes", || list(&answer.causes, |cause| self.cause(part, cause)))
            .value()
    }

    fn cause(self, part: &MarkedPart, cause: &Cause) -> Value {
        // Where there is working, it has been marked for what it is.
        let probable: Vec<&Award> = match part.lines.is_empty() {
            true => part.awards.iter().filter(|award| !award.given && cause.probable.contains(&award.id)).collect(),
            false => Vec::new(),
        };
        self.thing("cause")
            .with("sentence", || plain(&cause.sentence))
            .with("probable", || list(&probable, |award| plain(award.code.name())))
            .value()
    }

    fn written(self, number: usize, line: &MarkedLine) -> Value {
        self.thing("written")
            .with("number", || number.into())
            .with("typed", || self.typed(&line.typed))
            .with("reading", || self.typed(line.reading.as_deref().unwrap_or_default()))
            .with("role", || plain(&line.role))
            .value()
    }

    fn award(self, award: &Award, mark: Option<&KeyedMark>, part: &MarkedUnder) -> Value {
        let equation = mark.and_then(|mark| mark.equation.as_ref());
        // What an answer earned stands below the answer; a line of working has to be named.
        let line = award.evidence.as_ref().and_then(|evidence| match evidence.place {
            Place::Line(number) => Some((number, evidence.reading.as_str())),
            Place::Answer(_) => None,
        });
        self.thing("award")
            .with("code", || plain(&award.printed()))
            .with("given", || award.given.into())
            .with("person", || (award.by == Examiner::Person).into())
            .with("reason", || match mark.and_then(|mark| needed(award, mark, part)) {
                Some(needed) => self.text(&needed),
                None => self.typed(&award.feedback),
            })
            .with("place", || line.map_or_else(|| plain(""), |(number, _)| plain(&format!("line {number}"))))
            .with("reading", || self.typed(line.map_or("", |(_, reading)| reading)))
            .with("earned", || {
                mark.and_then(|mark| earned(mark, part.keyed)).map_or_else(nothing, |words| self.text(&words))
            })
            .with("equation", || equation.map_or_else(nothing, |equation| self.formula(equation)))
            .value()
    }

    /// What a student typed. Only LaTeX has to be told where a line may end.
    pub fn typed(self, words: &str) -> Value {
        let words = words.trim();
        let words = match words.char_indices().nth(LONGEST) {
            Some((cut, _)) => format!("{}…", &words[..cut]),
            None => words.to_owned(),
        };
        match self.notation {
            Notation::Latex => Value::safe_string(&breakable(&words)),
            Notation::Html | Notation::Unicode => plain(&words),
        }
    }
}

/// What a mark is for, in words, where its equation does not say it: of a value, whose it is.
fn earned(mark: &KeyedMark, part: &KeyedPart) -> Option<Text> {
    let say = |words: &str| marked_up(&part.setting.say(words));
    let name = |quantity: &Quantity| {
        let asked = part.blanks.iter().find(|blank| blank.find.quantities().contains(quantity));
        asked.map_or_else(|| say(&quantity.in_words()), |blank| Text::words(&blank.name))
    };
    match &mark.earned_for {
        EarnedFor::Law(law, _) if !mark.code.is_accuracy() => Some(say(law.method().0)),
        EarnedFor::Law(law, _) if mark.equation.is_none() => Some(say(law.accuracy())),
        EarnedFor::Condition if mark.equation.is_none() => Some(Text::words("the condition used")),
        EarnedFor::Quantity(quantity) => Some(name(quantity)),
        EarnedFor::Both([one, other]) => Some(Text([name(one).0, Text::words(" and ").0, name(other).0].concat())),
        _ => None,
    }
}

/// The mark with which a mark falls, by what it is for: ids stand on no page.
fn needed(award: &Award, mark: &KeyedMark, part: &MarkedUnder) -> Option<Text> {
    let is_missing = |needed: &usize| part.marked.awards.get(*needed).is_some_and(|award| !award.given);
    let missing = mark.depends.iter().find(|needed| award.falls_with_another() && is_missing(needed))?;
    let missing = part.keyed.scheme.get(*missing)?;
    let mut words = Text::words(format!("depends on {}", missing.code.name()));
    if let Some(what_for) = earned(missing, part.keyed) {
        words.0.push(Piece::Words(" (".to_owned()));
        words.0.extend(what_for.0);
        words.0.push(Piece::Words(")".to_owned()));
    }
    Some(words)
}

/// Words in the markup of the bank.
fn marked_up(words: &str) -> Text {
    read_markup(words).ok().and_then(|mut paragraphs| paragraphs.pop()).unwrap_or_else(|| Text::words(words))
}

/// Words of LaTeX in which a line may end within whatever is too long for one.
fn breakable(words: &str) -> String {
    let mut printed = String::new();
    for word in words.split_inclusive(char::is_whitespace) {
        let letters: Vec<char> = word.chars().collect();
        for (index, piece) in letters.chunks(UNBROKEN).enumerate() {
            if index > 0 {
                printed.push_str(r"\allowbreak{}");
            }
            printed.push_str(&print::words_latex(&piece.iter().collect::<String>()));
        }
    }
    printed
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeMap;

    use super::super::names::tests::{below, gather};
    use super::*;
    use crate::bank::Code;
    use crate::diagnostic::Source;
    use crate::expr::Expr;
    use crate::mark::report::MarkReport;
    use crate::mark::submissions::{read_rows, sort};
    use crate::mark::{AnswerKey, Profile};

    /// The key of a shipped question.
    fn key() -> AnswerKey {
        crate::mark::shipped_key("rest/speeds-and-directions", 1)
    }

    #[test]
    fn carom_knows_the_names_of_a_page_of_feedback() {
        let key = key();
        let part = key.papers[0].questions[0].parts[0].label.clone();
        let rows = format!("student,question,part,answer,working\nAda,1,{part},2,v = 1\n");
        let sorted = sort(&key, read_rows(&Source::new("submissions.csv", rows.as_str())).unwrap());
        let mut report = MarkReport::new(&sorted.scripts, &Profile::default(), Vec::new());
        let marked = &mut report.scripts[0].parts[0].marked;
        marked.answers[0].causes =
            vec![Cause { tag: "sign".into(), sentence: "A sign is wrong.".into(), probable: vec!["M1a".into()] }];
        marked.lines = vec![MarkedLine { typed: "v = 1".into(), reading: None, role: String::new() }];
        marked.own = vec![("A.after.n".parse().unwrap(), Expr::integer(2))];
        let pages = Feedback::of(&report);
        let context = page(&pages[0], Notation::Html, &Wanted::new(None));
        let mut found = BTreeMap::new();
        gather("feedback", &serde_json::to_value(context.get("feedback").unwrap()).unwrap(), &mut found);
        assert_eq!(found, below("feedback"));
    }

    #[test]
    fn a_mark_that_falls_with_another_says_what_that_was_for() {
        let key = key();
        let part = key.papers[0].questions[0].parts[0].label.clone();
        let rows = format!("student,question,part,answer\nAda,1,{part},2\n");
        let sorted = sort(&key, read_rows(&Source::new("submissions.csv", rows.as_str())).unwrap());
        let mut report = MarkReport::new(&sorted.scripts, &Profile::default(), Vec::new());
        let awards = &mut report.scripts[0].parts[0].marked.awards;
        let solved = awards.iter_mut().find(|award| award.code == Code::DependentM1).unwrap();
        (solved.note, solved.feedback) = (Some("depends"), "depends on M1a".to_owned());
        let context = page(&Feedback::of(&report)[0], Notation::Unicode, &Wanted::new(None));
        let page = serde_json::to_value(context.get("feedback").unwrap()).unwrap();
        let awards = page["scripts"][0]["replies"][0]["awards"].as_array().unwrap();
        let reasons: Vec<&str> = awards.iter().filter_map(|award| award["reason"].as_str()).collect();
        let expected = "depends on M1 (conservation of momentum along the line of centres, all terms)";
        assert!(reasons.contains(&expected), "{reasons:?}");
    }

    #[test]
    fn what_is_too_long_for_a_line_can_end_anywhere() {
        assert_eq!(breakable("2.78 m/s"), "2.78 m/s");
        assert_eq!(breakable("abcdefghijklmnop"), r"abcdefghijkl\allowbreak{}mnop");
        assert_eq!(breakable(r"\input{x}"), r"\textbackslash{}input\{x\}");
    }
}
