//! Answers remembered: of thousands of students many write the same, and what was found of it once holds for all of them.

use std::cell::{OnceCell, RefCell};
use std::collections::HashMap;
use std::rc::Rc;

use super::causes::Found;
use super::given_masses::GivenMasses;
use crate::mark::judging::Judgement;
use crate::mark::key::{KeyedBlank, KeyedQuestion};
use crate::mark::reading::{Reading, Said, Unreadable, Vocabulary, read_answer};

/// How many answers are remembered at most; when there are more everything is forgotten.
const MOST: usize = 1 << 13;

/// The longest answer that is remembered, in bytes: nobody writes a long one twice.
const LONGEST: usize = 64;

/// What answers to blanks were read as and judged, by one profile.
#[derive(Default)]
pub(in crate::mark) struct Memory {
    /// By blank, which stays where it is while it is marked by; then by what was typed.
    judged: HashMap<usize, HashMap<Box<str>, Rc<Judged>>>,
    count: usize,
}

/// What the lines of a part were read as. Its blanks have the letters of one question, and each may look at every line.
pub(super) struct Lines {
    read: RefCell<Vec<Line>>,
    masses: GivenMasses,
}

struct Line {
    typed: String,
    vectors: bool,
    readings: Rc<Result<Vec<Reading>, Unreadable>>,
}

impl Lines {
    pub(super) fn of(question: &KeyedQuestion) -> Lines {
        Lines { read: RefCell::default(), masses: GivenMasses::of(question) }
    }

    /// Reads an answer; what makes no sense as it stands may have masses by the names of their spheres.
    pub(super) fn read_answer(&self, typed: &str, vocabulary: &Vocabulary) -> Result<Vec<Reading>, Unreadable> {
        read_answer(typed, vocabulary).or_else(|fault| match self.masses.put_into(typed) {
            Some(put) => read_answer(&put, vocabulary).map_err(|_| fault),
            None => Err(fault),
        })
    }

    pub(super) fn read(&self, typed: &str, vocabulary: &Vocabulary) -> Rc<Result<Vec<Reading>, Unreadable>> {
        let is_it = |line: &&Line| line.typed == typed && line.vectors == vocabulary.vectors;
        if let Some(line) = self.read.borrow().iter().find(is_it) {
            return line.readings.clone();
        }
        let readings = Rc::new(self.read_answer(typed, vocabulary));
        let line = Line { typed: typed.to_owned(), vectors: vocabulary.vectors, readings: readings.clone() };
        self.read.borrow_mut().push(line);
        readings
    }
}

/// What was found of an answer by itself.
pub(super) struct Judged {
    pub(super) judgement: Judgement,
    /// How it was read; nothing if it was not, or if it does not stand for this blank alone.
    pub(super) readings: Option<Vec<Reading>>,
    /// The mistakes behind it, where the student shows nothing on the way.
    pub(super) causes: OnceCell<Vec<Found>>,
}

impl Judged {
    pub(super) fn new(judgement: Judgement, readings: Option<Vec<Reading>>) -> Rc<Judged> {
        Rc::new(Judged { judgement, readings, causes: OnceCell::new() })
    }

    /// What the answer comes to in the end, as it was read first.
    pub(super) fn said_last(&self) -> Option<&Said> {
        self.readings.as_ref()?.first()?.statements.last()?.said.last()
    }
}

impl Memory {
    /// What was found of the answer, or is found now.
    pub(super) fn judged(&mut self, blank: &KeyedBlank, typed: &str, judge: impl FnOnce() -> Rc<Judged>) -> Rc<Judged> {
        if typed.len() > LONGEST {
            return judge();
        }
        let blank = std::ptr::from_ref(blank).addr();
        if let Some(known) = self.judged.get(&blank).and_then(|answers| answers.get(typed)) {
            return known.clone();
        }
        let found = judge();
        if self.count == MOST {
            self.judged.clear();
            self.count = 0;
        }
        self.count += 1;
        self.judged.entry(blank).or_default().insert(typed.into(), found.clone());
        found
    }
}
