//! Notation that is open to doubt: each doubt is decided the likely way first, and the other way in a further reading.

use super::Unreadable;

/// A kind of doubt. A student who types `u/2v` once types it so throughout, so doubts of a kind go together first.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Doubt {
    /// `u/2v`: what stands below the stroke.
    Stroke,
    /// `97 - 86 over 97`: what stands above the line.
    Over,
    /// `√(-2² + 3²)`: is the sign squared too?
    SquaredSign,
    /// `sin x/2`, `arctan 3/4`: how far the argument of a function reaches.
    Argument,
    /// `sin x^2`: what is squared.
    Square,
    /// `e2v`: the square of e, or e times 2v.
    Multiple,
    /// `m2 = 3m`: the square of m, or the name of a mass.
    NumberedName,
    /// `2^3/2`: how far the exponent reaches.
    Exponent,
    /// `√uv`: how far the root reaches.
    Root,
    /// `3e2`: a power of ten, or the letter e.
    TenToThe,
    /// `1,000` and `1,5`: thousands, a decimal comma or two values.
    Comma,
    /// `2·78`: a raised point or a multiplication.
    RaisedPoint,
    /// `9mJ`: a letter or a part of the unit.
    Unit,
    /// `(2 -1)`: a column or a difference.
    Column,
    /// `[2, 3]`: coordinates or a range.
    Brackets,
    /// `2 to 3`: two values, as in a ratio, or a range.
    To,
    /// `mu`: one Greek letter or two letters side by side.
    Names,
    /// `4u (2)`: the number of the equation, or a factor.
    EquationNumber,
    /// `½u(1-e) (½u-½eu)`, `6 (0.1736)`: a value and what it is again, or a product.
    SaidAgain,
    /// `A-2.78`: a minus sign or a dash.
    Dash,
    /// `v = 4 w = 6`: two statements, or one with a product in it.
    SideBySide,
    /// `3 and 4/7`: a mixed number, or two values.
    Mixed,
    /// `0.3(6)` and `2.77...`: recurring or not.
    Recurring,
}

/// A doubt to be decided the other way.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Flip {
    /// Wherever it arises.
    Every(Doubt),
    /// At one place of the text.
    At(Doubt, usize),
}

/// The most steps that reading one answer one way may take.
pub(super) const MOST_STEPS: usize = 6_000;

/// The most doubts and decisions of one reading that are kept.
const MOST_DECISIONS: usize = 16;

/// The decisions of one reading, and how much work it was.
#[derive(Default)]
pub(super) struct Choices {
    flips: Vec<Flip>,
    met: Vec<(Doubt, usize)>,
    decided: Vec<String>,
    steps: usize,
}

impl Choices {
    /// Decides as is likely, except where told otherwise.
    pub(super) fn flipping(flips: &[Flip]) -> Choices {
        Choices { flips: flips.to_vec(), ..Choices::default() }
    }

    /// Is this doubt to be decided the other way?
    pub(super) fn otherwise(&mut self, doubt: Doubt, place: usize) -> bool {
        if self.met.len() < MOST_DECISIONS && !self.met.contains(&(doubt, place)) {
            self.met.push((doubt, place));
        }
        self.is_flipped(doubt, place)
    }

    /// Would this doubt be decided the other way, if it arose?
    pub(super) fn is_flipped(&self, doubt: Doubt, place: usize) -> bool {
        self.flips.contains(&Flip::Every(doubt)) || self.flips.contains(&Flip::At(doubt, place))
    }

    /// Says in plain words what was decided.
    pub(super) fn note(&mut self, decision: impl FnOnce() -> String) {
        if self.decided.len() == MOST_DECISIONS {
            return;
        }
        let decision = decision();
        if !self.decided.contains(&decision) {
            self.decided.push(decision);
        }
    }

    /// Takes back what was said since there were so many decisions.
    pub(super) fn forget(&mut self, since: usize) {
        self.decided.truncate(since);
    }

    /// What was decided, in order.
    pub(super) fn decided(&self) -> &[String] {
        &self.decided
    }

    /// One more step of work; there is an end to patience.
    pub(super) fn step(&mut self, place: usize) -> Result<(), Unreadable> {
        self.steps += 1;
        if self.steps > MOST_STEPS {
            return Err(Unreadable::Sign(place, "the answer is too intricate".to_owned()));
        }
        Ok(())
    }

    /// How many steps were taken.
    pub(super) fn steps(&self) -> usize {
        self.steps
    }

    /// The sets of flips that are worth trying after a reading in which these doubts were met: every kind of doubt on its
    /// own, then each place on its own, then the kinds in pairs.
    pub(super) fn further(&self) -> Vec<Vec<Flip>> {
        let mut kinds: Vec<Doubt> = Vec::new();
        for (doubt, _) in &self.met {
            if !kinds.contains(doubt) {
                kinds.push(*doubt);
            }
        }
        let mut sets: Vec<Vec<Flip>> = kinds.iter().map(|doubt| vec![Flip::Every(*doubt)]).collect();
        for doubt in &kinds {
            let places: Vec<usize> = self.met.iter().filter(|(met, _)| met == doubt).map(|(_, place)| *place).collect();
            if places.len() > 1 {
                sets.extend(places.into_iter().map(|place| vec![Flip::At(*doubt, place)]));
            }
        }
        for (index, one) in kinds.iter().enumerate() {
            sets.extend(kinds[index + 1..].iter().map(|other| vec![Flip::Every(*one), Flip::Every(*other)]));
        }
        sets
    }
}
