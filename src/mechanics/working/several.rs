//! One impact of several: its view, its words and its letters.

use std::borrow::Cow;

use super::Show;
use crate::expr::Expr;
use crate::mechanics::later::{self, Meeting};
use crate::mechanics::{Line, Quantity, Sphere};

impl<'a> Show<'a> {
    /// The view of a later impact, in which its spheres have the parts of A and B.
    pub fn of_later(&self, meeting: Meeting) -> Option<Show<'a>> {
        let scene = self.scene.of_impact(meeting.number)?;
        let asked: Vec<Quantity> = self.asked.iter().filter_map(|quantity| meeting.in_law(*quantity)).collect();
        let show = Show::of_one(scene, Cow::Owned(meeting.known(&self.known)), Cow::Owned(asked));
        let is_earlier =
            |quantity: &&Quantity| quantity.of_its_impact().is_equation() && quantity.impact() < meeting.number;
        let numbered_before = self.known.0.keys().filter(is_earlier).count();
        let (unit_vectors, with_units) = (self.unit_vectors, self.with_units);
        Some(Show { meeting, one_of_several: true, numbered_before, unit_vectors, with_units, ..show })
    }

    /// The view of the impact that a quantity is of, and what the laws call the quantity there.
    pub fn of(self, quantity: Quantity) -> Option<(Show<'a>, Quantity)> {
        if quantity.impact() == 0 {
            return Some((self, quantity));
        }
        let then = self.scene.then.iter().find(|then| then.meeting.number == quantity.impact())?;
        Some((self.of_later(then.meeting)?, then.meeting.in_law(quantity)?))
    }

    /// A line of a law as it is said here: of this setting, of this impact, and of who takes part in it.
    pub fn said(&self, line: Line) -> Line {
        let line = line.said_by(&|words| {
            let words = self.setting().say(words);
            if self.one_of_several { later::numbered(self.meeting.number, &words) } else { words.into_owned() }
        });
        if self.meeting.number == 0 {
            return line;
        }
        let [one, two] = [1, 2].map(|number| format!("({})", self.numbered_before + number));
        let line = line.said_by(&|words| words.replace("(2)", &two).replace("(1)", &one));
        let words = line.words.map_formulas(&mut |expr| Ok::<_, ()>(self.named(expr))).unwrap_or(line.words);
        let equations = line.equations.iter().map(|equation| self.named(equation)).collect();
        Line { words, equations, ..line }
    }

    /// A formula of the laws with the names of who takes part here.
    pub fn named(&self, expr: &Expr) -> Expr {
        if self.meeting.of == Meeting::FIRST.of {
            return expr.clone();
        }
        expr.substitute(&|name| self.meeting.name(name).map(Expr::name))
    }

    /// A component after a later impact: every impact has two letters of its own.
    pub(super) fn letter_of_later(&self, sphere: Sphere, number: u8) -> &'static str {
        const LETTERS: [[&str; 2]; 3] = [["x", "y"], ["p", "q"], ["r", "s"]];
        const WHERE_TAKEN: [[&str; 2]; 3] = [["X", "Y"], ["P", "Q"], ["R", "S"]];
        let place = usize::from(number - 1) % LETTERS.len();
        let taken = LETTERS[place].iter().any(|letter| self.taken(letter));
        let letters = if taken { WHERE_TAKEN[place] } else { LETTERS[place] };
        letters[usize::from(sphere == Sphere::B)]
    }
}
