//! A sheet: questions with their numbers as they are printed and as they are keyed, and the code that holds them.

use super::code::{CodeFault, SheetCode, digest};
use super::{KeyQuestion, LockedQuestion, PrintedQuestion, compose, key_question};
use crate::bank::{Contents, Question};
use crate::generate::Variant;

/// A sheet, before anything is said of its heading or of who gets it.
#[derive(Clone, Debug)]
pub struct Sheet {
    /// The questions as they are printed.
    pub printed: Vec<PrintedQuestion>,
    /// The questions as a marker needs them.
    pub keyed: Vec<KeyQuestion>,
    /// Which numbers they have, for a lock; none for the reference numbers.
    pub dealt: Vec<LockedQuestion>,
    /// The code.
    pub code: SheetCode,
}

impl Sheet {
    /// The sheet of questions of a bank with these numbers, numbered from 1.
    ///
    /// ```
    /// use carom::bank::Contents;
    /// use carom::generate::Deal;
    /// use carom::paper::{Sheet, SheetCode};
    /// let contents = Contents::shipped();
    /// let question = contents.headings[1].question().unwrap();
    /// let variant = Deal::new(&question, &question.styles[0], 7).next().unwrap();
    /// let sheet = Sheet::new(&contents, [(&question, &variant)]);
    /// let again = Sheet::from_code(&contents, &SheetCode::read(&sheet.code.to_string()).unwrap()).unwrap();
    /// assert_eq!(again.printed, sheet.printed);
    /// ```
    pub fn new<'s>(contents: &Contents, questions: impl IntoIterator<Item = (&'s Question, &'s Variant)>) -> Sheet {
        let questions: Vec<(&Question, &Variant)> = questions.into_iter().collect();
        let (mut printed, mut keyed) = (Vec::new(), Vec::new());
        for (number, (question, variant)) in (1..).zip(&questions) {
            let on_paper = compose(question, variant, number);
            keyed.push(key_question(question, variant, &on_paper));
            printed.push(on_paper);
        }
        let dealt = questions.iter().filter_map(|(question, variant)| {
            let (id, style) = (question.id.clone(), variant.style.name().to_owned());
            Some(LockedQuestion { id, style, index: variant.index? })
        });
        let dealt = dealt.collect();
        let code = SheetCode::of(contents, &questions, digest(&printed, &keyed));
        Sheet { printed, keyed, dealt, code }
    }

    /// The sheet that a code holds.
    ///
    /// # Errors
    ///
    /// That it holds none, or that it does not lead to the sheet of which it is the code: the bank has been edited.
    pub fn from_code(contents: &Contents, code: &SheetCode) -> Result<Sheet, CodeFault> {
        let opened = code.open(contents)?;
        let sheet = Sheet::new(contents, opened.iter().map(|(question, variant)| (question, variant)));
        if sheet.code == *code { Ok(sheet) } else { Err(CodeFault::OtherBank) }
    }

    /// Marks of all questions together.
    pub fn marks(&self) -> usize {
        self.printed.iter().map(PrintedQuestion::marks).sum()
    }
}
