//! The papers of a key, and which of them is whose.

use std::collections::HashMap;

use serde::Deserialize;

use super::fault::KeyFault;
use super::{KeyedQuestion, agreement, version};
use crate::paper::KeyQuestion;
#[cfg(test)]
use crate::paper::{Key, compose, key_question};

/// A key, read and checked.
#[derive(Clone, Debug)]
pub struct AnswerKey {
    /// The papers: one without a student's name, or one for each student of a class.
    pub papers: Vec<KeyedPaper>,
    /// The place of each student's paper.
    places: HashMap<String, usize>,
}

/// A paper of a key.
#[derive(Clone, Debug)]
pub struct KeyedPaper {
    /// For whom it was printed; nobody if all have the same.
    pub student: Option<String>,
    /// The student's name, where the school calls the student something else; empty if that is all there is.
    pub name: String,
    /// The code at the foot of its pages.
    pub code: String,
    /// Its questions in the order of the sheet.
    pub questions: Vec<KeyedQuestion>,
}

#[derive(Deserialize)]
struct KeyText {
    #[serde(default)]
    code: String,
    questions: Option<Vec<KeyQuestion>>,
    papers: Option<Vec<PaperText>>,
}

#[derive(Deserialize)]
struct PaperText {
    student: String,
    #[serde(default)]
    name: String,
    #[serde(default)]
    code: String,
    questions: Vec<KeyQuestion>,
}

impl AnswerKey {
    /// Reads a key from its JSON.
    ///
    /// # Errors
    ///
    /// Every fault of the key, each with its place. A key that a later version wrote is not read, since it may say what
    /// this one would pass over; one of an earlier version is, as far as it can be.
    pub fn read(text: &str) -> Result<AnswerKey, Vec<KeyFault>> {
        let other = version::other(text)?;
        if let Some(later) = other.as_ref().filter(|other| other.is_later()) {
            return Err(vec![later.fault()]);
        }
        AnswerKey::of_any_version(text)
            .map_err(|faults| other.map(|other| other.fault()).into_iter().chain(faults).collect())
    }

    fn of_any_version(text: &str) -> Result<AnswerKey, Vec<KeyFault>> {
        let text: KeyText = serde_json::from_str(text).map_err(|error| vec![KeyFault::unreadable(&error)])?;
        let mut faults = Vec::new();
        let mut read = |student, name, code, questions_of_paper: &[KeyQuestion], path: &str| {
            let each = questions_of_paper.iter().enumerate();
            let questions = each.filter_map(|(place, question)| {
                let path = format!("{path}questions[{place}]");
                let read = KeyedQuestion::read(question).map_err(|fault| faults.push(fault.below(&path))).ok()?;
                faults.extend(agreement::of_question(question, &read).into_iter().map(|fault| fault.below(&path)));
                Some(read)
            });
            let read = questions.collect();
            let below = |fault: KeyFault| KeyFault { path: format!("{path}{}", fault.path), ..fault };
            faults.extend(agreement::of_paper(questions_of_paper).into_iter().map(below));
            KeyedPaper { student, name, code, questions: read }
        };
        let papers: Vec<KeyedPaper> = match (text.questions, text.papers) {
            (Some(questions), None) => vec![read(None, String::new(), text.code, &questions, "")],
            (None, Some(papers)) => {
                let each = papers.into_iter().enumerate();
                let path = |place| format!("papers[{place}].");
                each.map(|(at, paper)| read(Some(paper.student), paper.name, paper.code, &paper.questions, &path(at)))
                    .collect()
            }
            _ => {
                let message = "a key has `questions`, or `papers` with questions";
                return Err(vec![KeyFault::new(message, "expected the `key.json` that `carom sheet` writes")]);
            }
        };
        if !faults.is_empty() {
            return Err(faults);
        }
        let mut places = HashMap::new();
        for (place, student) in
            papers.iter().enumerate().filter_map(|(place, paper)| Some((place, paper.student.clone()?)))
        {
            if places.insert(student, place).is_some() {
                let fault =
                    KeyFault::new("there is another paper for the same student", "expected a paper for each student");
                return Err(vec![fault.below(&format!("papers[{place}].student"))]);
            }
        }
        Ok(AnswerKey { papers, places })
    }

    /// The paper of a student: the student's own, or the one that all have.
    pub fn paper(&self, student: &str) -> Option<&KeyedPaper> {
        let of_all = || self.papers.first().filter(|paper| paper.student.is_none());
        self.places.get(student).map(|place| &self.papers[*place]).or_else(of_all)
    }
}

/// The key of a shipped question with its reference numbers, by itself under a number of the sheet.
#[cfg(test)]
pub(crate) fn shipped_key(id: &str, number: usize) -> AnswerKey {
    let (id, text) = crate::bank::shipped().find(|(shipped, _)| *shipped == id).unwrap();
    let question = crate::bank::read_question(id, &crate::diagnostic::Source::new(id, text)).unwrap();
    let variant = crate::generate::reference(&question).unwrap();
    let question = key_question(&question, &variant, &compose(&question, &variant, number));
    AnswerKey::read(&serde_json::to_string(&Key::new("shipped".to_owned(), None, vec![question])).unwrap()).unwrap()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::bank::{read_question, shipped};
    use crate::diagnostic::Source;
    use crate::generate::{Deal, reference};

    fn key_of(all: impl Iterator<Item = (&'static str, &'static str)>) -> String {
        let questions = all.enumerate().map(|(place, (id, text))| {
            let question = read_question(id, &Source::new(id, text)).unwrap();
            let variant = reference(&question).unwrap();
            key_question(&question, &variant, &compose(&question, &variant, place + 1))
        });
        serde_json::to_string(&Key::new("shipped".to_owned(), None, questions.collect())).unwrap()
    }

    #[test]
    fn the_key_of_every_shipped_question_is_read_back_with_all_that_is_asked() {
        let key = AnswerKey::read(&key_of(shipped())).unwrap();
        let questions = &key.papers[0].questions;
        assert_eq!(questions.len(), shipped().count());
        for part in questions.iter().flat_map(|question| &question.parts) {
            assert!(!part.blanks.is_empty() && !part.scheme.is_empty());
            for quantity in part.blanks.iter().flat_map(|blank| blank.find.quantities()) {
                assert!(part.known.0.contains_key(&quantity), "{quantity}");
            }
            assert!(part.scheme.iter().all(|mark| !mark.blanks.is_empty()), "{:?}", part.scheme);
        }
    }

    /// At the wall the coefficient of restitution is *f*, and between the spheres 1/2.
    #[test]
    fn a_reason_has_the_letter_of_its_impact() {
        let found = shipped().filter(|(id, _)| *id == "successive/second-collision");
        let key = AnswerKey::read(&key_of(found)).unwrap();
        let question = &key.papers[0].questions[0];
        let at_wall = question.impact(question.meeting(1).unwrap(), &Default::default()).unwrap();
        let reason = "e is on the wrong side: it multiplies the speed of approach";
        assert_eq!(question.said_of_impact(reason), reason);
        assert_eq!(at_wall.said_of_impact(reason), reason.replacen('e', "f", 1));
    }

    #[test]
    fn what_carom_writes_agrees_with_itself() {
        for (id, text) in shipped() {
            let question = read_question(id, &Source::new(id, text)).unwrap();
            let dealt = question.styles.iter().flat_map(|style| Deal::new(&question, style, 11).take(3));
            let keyed = dealt
                .enumerate()
                .map(|(place, variant)| key_question(&question, &variant, &compose(&question, &variant, place + 1)));
            let key = serde_json::to_string(&Key::new("shipped".to_owned(), None, keyed.collect())).unwrap();
            assert_eq!(AnswerKey::read(&key).map(|_| ()), Ok(()), "{id}");
        }
    }

    /// Whether a right answer shows that a step was right is a matter of the question, and no chance of its numbers.
    #[test]
    fn what_a_right_answer_implies_is_the_same_in_all_variants() {
        for (id, text) in shipped() {
            let question = read_question(id, &Source::new(id, text)).unwrap();
            let dealt = question.styles.iter().flat_map(|style| Deal::new(&question, style, 3).take(20));
            let variants: Vec<_> = reference(&question).into_iter().chain(dealt).collect();
            let place = 1..;
            let keyed = variants.iter().zip(place);
            let keyed =
                keyed.map(|(variant, place)| key_question(&question, variant, &compose(&question, variant, place)));
            let key = serde_json::to_string(&Key::new("shipped".to_owned(), None, keyed.collect())).unwrap();
            let key = AnswerKey::read(&key).unwrap();
            let questions = &key.papers[0].questions;
            let needed =
                |of: &KeyedQuestion| -> Vec<_> { of.parts.iter().map(|part| of.needed(part).to_vec()).collect() };
            for (keyed, variant) in questions.iter().zip(&variants) {
                assert_eq!(needed(keyed), needed(&questions[0]), "{id}: {:?}", variant.parameters);
            }
        }
    }

    #[test]
    fn a_key_that_contradicts_itself_is_refused() {
        let of = |ids: [&'static str; 2]| {
            let text = |id| shipped().find(|(shipped, _)| *shipped == id).unwrap();
            serde_json::from_str::<serde_json::Value>(&key_of(ids.map(text).into_iter())).unwrap()
        };
        let key = of(["rest/speeds-and-directions", "backwards/velocity-of-b-and-restitution"]);
        let letters = of(["rest-letters/direction-and-deflection", "direct/velocities-in-letters"]);
        let found = of(["walls/turned-through-a-right-angle", "deflection/elastic"]);
        let ranges = of(["ranges/direction-reversed", "ranges/mass-ratio-that-can-be"]);
        type Edit<'t> = (&'t serde_json::Value, &'t str, serde_json::Value, &'t str, &'t str);
        let blank = |question, part, blank, field| format!("/questions/{question}/parts/{part}/blanks/{blank}/{field}");
        let cases: [Edit; 12] = [
            (&key, &blank(0, 0, 0, "exact"), "3".into(), "exact", "`3` is not what the scene of the question leads to"),
            (&key, &blank(0, 0, 0, "decimal"), "3.5".into(), "decimal", "`3.5` is not the decimal of"),
            (
                &key,
                &blank(1, 0, 0, "exact/1"),
                "7".into(),
                "exact",
                "`7` is not what the scene of the question leads to",
            ),
            (
                &key,
                &blank(1, 1, 0, "exact"),
                "1/2".into(),
                "exact",
                "`1/2` is not what the scene of the question leads to",
            ),
            (&key, "/questions/0/scene/e", "1/8".into(), "exact", "is not what the scene of the question leads to"),
            (&letters, &blank(1, 0, 0, "exact"), "7*u".into(), "exact", "`7*u` is not what the scene"),
            (&found, &blank(0, 0, 0, "exact"), "1/7".into(), "exact", "`1/7` is not what the scene"),
            (&ranges, &blank(0, 0, 0, "exact"), "1/9 < e <= 1".into(), "exact", "`1/9 < e <= 1` is not what"),
            (&key, "/questions/0/parts/0/marks", 3.into(), "parts[0].marks", "3 marks, and the scheme has "),
            (&key, "/questions/1/number", 1.into(), "questions[1].number", "there are two questions 1: `rest/speeds"),
            (
                &key,
                "/questions/1/parts/1/label",
                "a".into(),
                "parts[1].label",
                "there are two parts (a): `parts[0]` is",
            ),
            (&key, "/carom", "banana".into(), "carom", "`banana` is no version of carom"),
        ];
        for (key, pointer, value, path, message) in cases {
            let mut key = key.clone();
            assert!(AnswerKey::read(&key.to_string()).is_ok());
            *key.pointer_mut(pointer).unwrap_or_else(|| panic!("{pointer}")) = value;
            let fault = AnswerKey::read(&key.to_string()).unwrap_err().remove(0);
            assert!(fault.path.ends_with(path) && fault.message.contains(message), "{pointer}: {fault:?}");
            assert!(!fault.expected.is_empty() && !fault.help.is_empty(), "{fault:?}");
        }
        // Another form of the right value, fewer figures of it, and another rule are a teacher's own business.
        let mut own = key.clone();
        let exact = key.pointer(&blank(0, 0, 0, "exact")).and_then(|exact| exact.as_str()).unwrap();
        *own.pointer_mut(&blank(0, 0, 0, "exact")).unwrap() = format!("2*({exact})/2").into();
        *own.pointer_mut(&blank(0, 0, 0, "decimal")).unwrap() =
            key.pointer(&blank(0, 0, 0, "rounded")).unwrap().clone();
        *own.pointer_mut(&blank(0, 0, 0, "accept")).unwrap() = "2sf".into();
        assert_eq!(AnswerKey::read(&own.to_string()).map(|_| ()), Ok(()));
    }

    #[test]
    fn a_fault_of_a_key_says_where() {
        let key = key_of(shipped().take(1));
        let cases = [
            ("\"code\":\"M1\"", "\"code\":\"M9\"", "questions[0].parts[0].scheme[0].code", "unknown mark code `M9`"),
            ("\"A\":\"3*m\"", "\"A\":\"3*\"", "questions[0].scene.masses.A", "the expression ends too early"),
            (
                "\"kind\":\"number\"",
                "\"kind\":\"numbre\"",
                "questions[0].parts[0].blanks[0].kind",
                "unknown kind of answer `numbre`",
            ),
        ];
        for (from, to, path, message) in cases {
            let fault = AnswerKey::read(&key.replacen(from, to, 1)).unwrap_err().remove(0);
            assert_eq!((fault.path.as_str(), fault.message.as_str()), (path, message), "{fault:?}");
        }
        let fault = AnswerKey::read("{\"carom\": \"0.1.0\"}").unwrap_err().remove(0);
        assert_eq!(fault.message, "a key has `questions`, or `papers` with questions");
        assert_eq!(AnswerKey::read("student,question").unwrap_err()[0].place, Some((1, 1)));
    }
}
