//! The letters of a scene: declared each with its range, or known by what they mean.

use super::{Reader, at_most};
use crate::diagnostic::near;
use crate::expr::{Angles, Expr, Fault, Span, read};
use crate::mechanics::Quantity;
use crate::mechanics::scene_text::SceneText;
use crate::number::{Letter, Range};

impl Reader<'_> {
    pub(super) fn declare<S: AsRef<str>>(&mut self, text: &SceneText<S>) {
        for (name, range) in &text.symbols {
            let field = format!("symbols.{name}");
            let Some((_, found)) = Range::DECLARED.into_iter().find(|(word, _)| *word == range.as_ref()) else {
                self.unknown_range(&field, name, range.as_ref());
                continue;
            };
            match Letter::new(name, found) {
                _ if !is_name(name) => {
                    let expected = "expected a letter from a to z, then letters, digits or `_`";
                    let message = format!("no name of a letter: `{name}`");
                    self.fault(&field, Fault::new(message, Span::default(), expected));
                    self.help("write `alpha` for α, and `x1` or `x_1` for a letter with a number");
                }
                _ if has_a_meaning(name) => {
                    let message = format!("no name of a letter: `{name}`");
                    self.fault(&field, Fault::new(message, Span::default(), "it has a meaning of its own in formulas"));
                    self.help("call the letter something else");
                    self.letters.extend(Letter::new(name, found));
                }
                Some(letter) => self.letters.push(letter),
                None => {
                    self.fault(&field, Fault::new("a letter's name is too long", Span::default(), at_most()));
                    self.help("give it a short name, such as `u`");
                }
            }
        }
    }

    /// The letter is declared all the same: that it is used is no second fault.
    fn unknown_range(&mut self, field: &str, name: &str, range: &str) {
        let words = || Range::DECLARED.into_iter().map(|(word, _)| word);
        let begun = words().find(|word| word.starts_with(range) && !range.is_empty());
        let meant = begun.or_else(|| near(range, words()));
        let found = Range::DECLARED.into_iter().find(|(word, _)| Some(*word) == meant);
        let help = match meant {
            Some(word) => format!("did you mean `{word}`?"),
            None => {
                "a mass or a speed is `positive`, e is `unit`, an angle is `acute`, and any number is `real`".to_owned()
            }
        };
        self.whole_fault(field, range, "unknown range", "`positive`, `unit`, `acute` or `real`");
        self.help(&help);
        self.letters.extend(Letter::new(name, found.map_or(Range::Real, |(_, range)| range)));
    }

    /// `e`, `A.mass` and `B.mass` need no declaration to be found: their meaning is their range.
    pub(super) fn imply<S: AsRef<str>>(&mut self, text: &SceneText<S>) {
        for name in &text.unknowns {
            let range = match name.as_ref() {
                "e" => Range::Unit,
                "A.mass" | "B.mass" => Range::Positive,
                _ => continue,
            };
            if self.letters.iter().all(|letter| letter.name() != name.as_ref()) {
                self.letters.extend(Letter::new(name.as_ref(), range));
            }
        }
    }
}

/// A letter, then letters, digits or `_`.
fn is_name(name: &str) -> bool {
    name.starts_with(|first: char| first.is_ascii_alphabetic())
        && name.chars().all(|sign| sign.is_ascii_alphanumeric() || sign == '_')
}

/// Is it a constant or a function in every formula, such as `pi`, or a quantity, such as `approach`? *e* is a letter as well.
fn has_a_meaning(name: &str) -> bool {
    let is_quantity = || name != "e" && name.parse::<Quantity>().is_ok();
    !matches!(read(name, Angles::Radians), Ok(Expr::Name(_))) || is_quantity()
}

/// Which letters there are, or how they are declared.
pub(super) fn known_letters(letters: &[Letter]) -> String {
    let known: Vec<String> = letters.iter().map(|letter| format!("`{}`", letter.name())).collect();
    match known.is_empty() {
        true => "declare letters in `symbols`, each as `positive`, `unit`, `acute` or `real`".to_owned(),
        false => format!("the letters declared in `symbols` are {}", known.join(", ")),
    }
}
