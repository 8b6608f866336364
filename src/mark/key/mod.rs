//! A key read back: what a script is marked against.
//!
//! A key is enough to mark with, since the bank may have changed since the paper was printed. So its scene is posed
//! again and its expressions are read again; nothing else is taken from anywhere.

mod agreement;
mod fault;
mod impact;
mod mark;
mod misread;
mod motion;
mod papers;
mod part;
mod texts;
mod version;

use std::sync::OnceLock;

pub use fault::KeyFault;
pub use mark::KeyedMark;
#[cfg(test)]
pub(crate) use papers::shipped_key;
pub use papers::{AnswerKey, KeyedPaper};

use super::judging::Model;
use super::slips::{Asked, Mistakes};
use super::working::{Elsewhere, Prepared};
use crate::bank::Find;
use crate::expr::Angles;
use crate::mechanics::{Derivation, Known, Meeting, Quantity, Scene, Setting, Sought, pose};
use crate::number::{Letter, Value};
use crate::paper::KeyQuestion;
use crate::solve::{Solution, solve_all};

/// A question to be marked.
#[derive(Clone, Debug)]
pub struct KeyedQuestion {
    /// Its id in the bank.
    pub id: String,
    /// Its number on the sheet.
    pub number: usize,
    /// The exercise that it mirrors.
    pub mirrors: Option<String>,
    /// The collision as it was given, unknown letters left as letters.
    pub scene: Scene,
    /// What the scene gives.
    pub given: Known<Value>,
    /// The letters of the question.
    pub letters: Vec<Letter>,
    /// Those of them in which something is given; a student may use the others for what is to be found.
    pub(in crate::mark) given_letters: Vec<Letter>,
    /// Its parts.
    pub parts: Vec<KeyedPart>,
    /// The decimals that stand in it: in working they are exact.
    decimals: Vec<String>,
    /// The angles among its parameters, by the names that its words have for them, in degrees.
    angles: Vec<(String, f64)>,
    /// What it gives for every impact.
    elsewhere: Elsewhere,
    prepared: OnceLock<Prepared>,
    mistakes: OnceLock<Mistakes>,
    mistakes_where_found: OnceLock<Option<Mistakes>>,
    needed: OnceLock<Vec<Vec<Vec<bool>>>>,
    /// The scene solved, if it has something to be found.
    solution: OnceLock<Option<Solution>>,
    /// Its later impacts, each by itself.
    later: OnceLock<Vec<Option<KeyedQuestion>>>,
}

/// A part to be marked.
#[derive(Clone, Debug)]
pub struct KeyedPart {
    /// What the impact is between.
    pub setting: Setting,
    /// Who meets in it; where the part is about several impacts, in the last.
    pub(in crate::mark) meeting: Meeting,
    /// The letter of the coefficient of restitution in that impact, where it is a letter.
    letter_of_restitution: Option<Letter>,
    /// `a`, `b`, … or empty.
    pub label: String,
    /// What is to be filled in.
    pub blanks: Vec<KeyedBlank>,
    /// The mark scheme, in the order in which the marks are earned.
    pub scheme: Vec<KeyedMark>,
    /// The steps from what is given, and from what earlier parts found, to what is asked.
    pub derivation: Derivation,
    /// What is known at its end, worked without a mistake.
    pub known: Known<Value>,
}

/// One thing asked.
#[derive(Clone, Debug)]
pub struct KeyedBlank {
    /// What it is called on the sheet that students fill in: `speed of A`.
    pub name: String,
    /// What is to be found.
    pub find: Find,
    /// What is right.
    pub model: Model,
}

impl KeyedQuestion {
    /// Reads a question of a key.
    ///
    /// # Errors
    ///
    /// The first thing that cannot be read, or a collision that cannot happen.
    pub fn read(question: &KeyQuestion) -> Result<KeyedQuestion, KeyFault> {
        let scene = Scene::read(&question.scene, &(), Angles::Radians).map_err(|faults| {
            let fault = faults.into_iter().next();
            let (field, fault) = fault.map(|found| (found.field, found.fault)).unzip();
            let message = fault.as_ref().map_or_else(String::new, |fault| fault.message.clone());
            let expected = fault.map_or_else(String::new, |fault| fault.expected);
            KeyFault { path: format!("scene.{}", field.unwrap_or_default()), ..KeyFault::new(message, expected) }
        })?;
        let refused = |refusal| KeyFault {
            path: "scene".to_owned(),
            ..KeyFault::new(format!("{refusal}"), "expected a collision that can happen")
        };
        let given = pose(&scene).map_err(refused)?;
        let letters = scene.letters.clone();
        let mut known = given.clone();
        let mut parts = Vec::new();
        for (place, part) in question.parts.iter().enumerate() {
            let below = |fault: KeyFault| fault.below(&format!("parts[{place}]"));
            parts.push(KeyedPart::read(part, &scene, &mut known).map_err(below)?);
        }
        part::with_unit_vectors_throughout(&mut parts);
        part::with_the_letters_of_angles(&mut parts, &scene.unknowns);
        let (id, number, mirrors) = (question.id.clone(), question.number, question.mirrors.clone());
        let (decimals, angles) = (texts::decimals(question), texts::angles(question));
        let (given_letters, elsewhere) = (texts::given_letters(question, &letters), Elsewhere::of(&scene));
        let (prepared, mistakes, mistakes_where_found, needed, solution, later) = Default::default();
        Ok(KeyedQuestion {
            id,
            number,
            mirrors,
            scene,
            given,
            letters,
            given_letters,
            parts,
            decimals,
            angles,
            elsewhere,
            prepared,
            mistakes,
            mistakes_where_found,
            needed,
            solution,
            later,
        })
    }

    /// What looking through working needs, made when it is first needed.
    pub(super) fn prepared(&self) -> &Prepared {
        self.prepared.get_or_init(|| {
            let (decimals, angles, elsewhere) = (self.decimals.clone(), self.angles.clone(), self.elsewhere.clone());
            let found = self.solution().map_or(&[][..], Solution::found);
            Prepared::new(&self.scene, &self.given_letters, &self.given, found, decimals, angles, elsewhere)
        })
    }

    /// The wrong values that slips lead to for an answer, each with the tags of what leads to it.
    pub fn mistaken_values(&self, asked: &Asked) -> Vec<(Vec<&'static str>, Vec<f64>)> {
        self.mistakes_where_found().unwrap_or_else(|| self.mistakes()).values(asked)
    }

    /// For a question in numbers: a wrong value of one quantity as a student might have it, to three significant figures,
    /// and what then follows for another. `None` if it does not follow.
    pub fn followed_value(&self, own: Quantity, asked: Quantity) -> Option<(String, f64)> {
        self.prepared().followed_value(own, asked)
    }

    /// For each mark of a part, and each blank of it: would the answer be another if what earns the mark were wrong? Only
    /// then does a right answer imply the mark: that *B* moves along the line of centres says nothing about *e*.
    pub(super) fn needed(&self, part: &KeyedPart) -> &[Vec<bool>] {
        let needed = self.needed.get_or_init(|| {
            let of_part = |part: &KeyedPart| {
                let of_mark = |mark: &KeyedMark| {
                    let of_blank = |blank: &KeyedBlank| self.prepared().is_needed(&mark.earned_for, &blank.find);
                    part.blanks.iter().map(of_blank).collect()
                };
                part.scheme.iter().map(of_mark).collect()
            };
            self.parts.iter().map(of_part).collect()
        });
        let place = self.parts.iter().position(|own| own.label == part.label);
        place.map_or(&[], |place| &needed[place])
    }

    /// What slips lead to, worked out when an answer is first wrong.
    pub(super) fn mistakes(&self) -> &Mistakes {
        let range = || self.solution().filter(|solution| solution.range().is_some())?.sought();
        self.mistakes.get_or_init(|| self.mistakes_from(&self.given, range().as_ref()))
    }

    /// The same with the letters that were to be found as they were found: who has found e goes on with a number.
    pub(super) fn mistakes_where_found(&self) -> Option<&Mistakes> {
        let found = || {
            let solution = self.solution().filter(|solution| solution.range().is_none())?;
            Some(self.mistakes_from(solution.given(), solution.sought().as_ref()))
        };
        self.mistakes_where_found.get_or_init(found).as_ref()
    }

    /// The scene solved, where it has something to be found: a range of values, or values; with what its parts ask, as
    /// far as that is determined.
    fn solution(&self) -> Option<&Solution> {
        let asked = || {
            let blanks = self.parts.iter().flat_map(|part| &part.blanks);
            blanks.flat_map(|blank| blank.find.quantities()).collect::<Vec<_>>()
        };
        let solved = || {
            let mut solutions =
                if self.scene.unknowns.is_empty() { None } else { solve_all(&self.scene, &asked()).ok() }?;
            if solutions.len() == 1 { solutions.pop() } else { None }
        };
        self.solution.get_or_init(solved).as_ref()
    }

    fn mistakes_from(&self, given: &Known<Value>, sought: Option<&Sought>) -> Mistakes {
        let blanks = self.parts.iter().flat_map(|part| &part.blanks);
        let asked: Vec<Asked> = blanks.map(KeyedBlank::asked).collect();
        Mistakes::of(given, &asked, &self.letters, sought)
    }
}
