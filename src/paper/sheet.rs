//! A sheet: questions with their numbers as they are printed and as they are keyed, and the code that holds them.

use super::code::{CodeFault, SheetCode, digest};
use super::{KeyQuestion, LockedQuestion, PrintedQuestion, compose, key_question};
use crate::bank::{Contents, Question};
use crate::generate::Variant;
use crate::mechanics::Setting;

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
    /// What its questions are about, for a sheet that has no title of its own.
    pub heading: &'static str,
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
        let heading = heading(questions.iter().map(|(_, variant)| variant.scene.setting));
        Sheet { printed, keyed, dealt, code, heading }
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

/// What questions in these settings are about.
fn heading(settings: impl IntoIterator<Item = Setting>) -> &'static str {
    let settings: Vec<Setting> = settings.into_iter().collect();
    let all = |setting: Setting| settings.iter().all(|other| *other == setting);
    match settings[..] {
        _ if all(Setting::Oblique) => "Oblique impacts of smooth spheres",
        _ if all(Setting::Direct) => "Direct impacts of two spheres",
        _ if all(Setting::Wall) => "Impacts with a wall",
        _ if all(Setting::Impulse) => "Impulses on a particle",
        _ if settings.contains(&Setting::Impulse) => "Impulses and collisions",
        _ => "Impacts and collisions",
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_sheet_is_headed_by_what_is_on_it() {
        use Setting::{Direct, Impulse, Oblique, Wall};
        let cases: [(&[Setting], &str); 8] = [
            (&[], "Oblique impacts of smooth spheres"),
            (&[Oblique, Oblique], "Oblique impacts of smooth spheres"),
            (&[Wall, Wall], "Impacts with a wall"),
            (&[Direct], "Direct impacts of two spheres"),
            (&[Impulse, Impulse], "Impulses on a particle"),
            (&[Oblique, Wall], "Impacts and collisions"),
            (&[Direct, Wall, Oblique], "Impacts and collisions"),
            (&[Wall, Impulse], "Impulses and collisions"),
        ];
        for (settings, expected) in cases {
            assert_eq!(heading(settings.iter().copied()), expected, "{settings:?}");
        }
    }
}
