//! What the words say is more or less than a number, where a condition of the scene compares something with that number: the
//! same thing, and in the same way.

use std::cmp::Ordering;

use super::said::Seen;
use super::sentence::{Sentence, Token, is_one_of};
use crate::examine::Finding;
use crate::expr::{Expr, Relation, print};
use crate::mechanics::{Condition, Quantity, Sphere};

/// On which side of a number something lies, and whether it may be equal to it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Bound {
    side: Ordering,
    may_be_equal: bool,
}

/// Nouns of what is compared, in words and in conditions.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Noun {
    Motion,
    Energy,
    Impulse,
    Mass,
}

impl Seen<'_> {
    /// Something that is said to be more or less than a number which a condition of the scene has for something else, or the
    /// other way round.
    pub(super) fn limited(&self, sentence: &Sentence, findings: &mut Vec<Finding>) {
        if !self.question.scene.then.is_empty() {
            return;
        }
        for (place, token) in sentence.iter().enumerate() {
            let Token::Number(expr, _, lead) = token else { continue };
            let (Some(said), Some(noun)) = (bound(&sentence[..place]), noun(&sentence[..place])) else { continue };
            let limits = self.limits(expr);
            let [(quantity, has)] = limits.as_slice() else { continue };
            let number = print::plain(expr);
            let at = format!("{lead}{{{number}");
            let own = of(*quantity);
            if own.is_some_and(|own| own != noun) {
                let message = format!(
                    "the words compare {} with `{number}`, and the condition of the scene {}",
                    noun.name(),
                    own.map_or("", Noun::name)
                );
                let help = format!("name in the words what `{quantity}` is, or compare something else in `conditions`");
                findings.push(self.finding(message, &at, &help));
                continue;
            }
            let named = owner(&sentence[..place]);
            let mine = whose(*quantity);
            if let Some(named) = named.filter(|named| Some(*named) != mine) {
                let of_whom =
                    mine.map_or("that of both together".to_owned(), |other| format!("that of `*{}*`", other.name()));
                let (what, named) = (noun.name(), named.name());
                let message = format!(
                    "the words compare {what} of `*{named}*` with `{number}`, and the condition of the scene {of_whom}"
                );
                let help = match mine {
                    Some(other) => format!("name `*{}*` in the words, or `{named}` in `conditions`", other.name()),
                    None => format!("leave `*{named}*` out of the words, or compare what is its own in `conditions`"),
                };
                findings.push(self.finding(message, &at, &help));
                continue;
            }
            if said.side != has.side {
                let (said, has) = (said.name(), has.name());
                let message =
                    format!("the words say `{said}` of `{number}`, and the condition of the scene has `{has}`");
                findings.push(self.finding(message, &at, "turn the words or the condition round"));
            } else if said.may_be_equal != has.may_be_equal {
                let message = match said.may_be_equal {
                    true => format!("the words let it be equal to `{number}`, and the condition of the scene does not"),
                    false => format!("the condition of the scene lets it be equal to `{number}`, and the words do not"),
                };
                let relation = match (said.side, said.may_be_equal) {
                    (Ordering::Greater, true) => ">=",
                    (Ordering::Greater, false) => ">",
                    (_, true) => "<=",
                    (_, false) => "<",
                };
                let help = format!("write `{relation}` in `conditions`, or mend the words");
                findings.push(self.finding(message, &at, &help).as_warning());
            }
        }
    }

    /// What the conditions of the scene compare with a number, and how.
    fn limits(&self, expr: &Expr) -> Vec<(Quantity, Bound)> {
        let Some(number) = self.number(expr).filter(|number| !number.is_zero()) else { return Vec::new() };
        let limit = |condition: &Condition| {
            let sides = [&condition.left, &condition.right];
            let is_it = |side: &&Expr| self.number(side).is_some_and(|value| value.equals(&number));
            let own = sides.iter().position(is_it)?;
            let quantity = print::plain(sides[1 - own]).parse::<Quantity>().ok()?;
            let (side, may_be_equal) = match condition.relation {
                Relation::Greater => (Ordering::Greater, false),
                Relation::GreaterOrEqual => (Ordering::Greater, true),
                Relation::Less => (Ordering::Less, false),
                Relation::LessOrEqual => (Ordering::Less, true),
                _ => return None,
            };
            let side = if own == 1 { side } else { side.reverse() };
            Some((quantity, Bound { side, may_be_equal }))
        };
        self.variant.scene.conditions.iter().filter_map(limit).collect()
    }
}

impl Bound {
    fn name(self) -> &'static str {
        match (self.side, self.may_be_equal) {
            (Ordering::Greater, false) => "more than",
            (Ordering::Greater, true) => "at least",
            (_, true) => "at most",
            (_, false) => "less than",
        }
    }
}

impl Noun {
    fn name(self) -> &'static str {
        match self {
            Noun::Motion => "the motion",
            Noun::Energy => "an energy",
            Noun::Impulse => "an impulse",
            Noun::Mass => "a mass",
        }
    }
}

/// The comparison that the words end in: `more than`, `does not exceed`, `at least`.
fn bound(before: &[Token]) -> Option<Bound> {
    const MORE: [&str; 6] = ["more", "greater", "larger", "higher", "faster", "bigger"];
    const LESS: [&str; 5] = ["less", "smaller", "lower", "slower", "fewer"];
    let new = |side, may_be_equal| Some(Bound { side, may_be_equal });
    let is_not = |before: &[Token]| before.iter().rev().take(2).any(|token| is_one_of(token, &["not", "no", "never"]));
    match before {
        [before @ .., more, than] if is_one_of(than, &["than"]) => {
            let side = match more {
                more if is_one_of(more, &MORE) => Ordering::Greater,
                less if is_one_of(less, &LESS) => Ordering::Less,
                _ => return None,
            };
            if is_not(before) { new(side.reverse(), true) } else { new(side, false) }
        }
        [.., at, least] if is_one_of(at, &["at"]) && is_one_of(least, &["least"]) => new(Ordering::Greater, true),
        [.., at, most] if is_one_of(at, &["at"]) && is_one_of(most, &["most"]) => new(Ordering::Less, true),
        [before @ .., exceeds] if is_one_of(exceeds, &["exceeds", "exceed", "exceeding"]) => {
            if is_not(before) {
                new(Ordering::Less, true)
            } else {
                new(Ordering::Greater, false)
            }
        }
        [.., below] if is_one_of(below, &["below"]) => new(Ordering::Less, false),
        [.., above] if is_one_of(above, &["above"]) => new(Ordering::Greater, false),
        _ => None,
    }
}

/// The last thing of which the words speak.
fn noun(before: &[Token]) -> Option<Noun> {
    before.iter().rev().find_map(|token| match token {
        Token::Word(word) => match word.as_str() {
            "speed" | "velocity" | "faster" | "slower" => Some(Noun::Motion),
            "energy" => Some(Noun::Energy),
            "impulse" => Some(Noun::Impulse),
            "mass" => Some(Noun::Mass),
            _ => None,
        },
        _ => None,
    })
}

/// What a condition compares; none for what has no such noun.
fn of(quantity: Quantity) -> Option<Noun> {
    match quantity {
        Quantity::Velocity(..) | Quantity::Speed(..) => Some(Noun::Motion),
        Quantity::KineticEnergy(..)
        | Quantity::SphereEnergyLost(_)
        | Quantity::SphereEnergyGained(_)
        | Quantity::TotalEnergy(_)
        | Quantity::EnergyLost
        | Quantity::FractionLost => Some(Noun::Energy),
        Quantity::Impulse(..) | Quantity::ImpulseMagnitude => Some(Noun::Impulse),
        Quantity::Mass(_) => Some(Noun::Mass),
        _ => None,
    }
}

/// The sphere of which a condition compares something.
fn whose(quantity: Quantity) -> Option<Sphere> {
    match quantity {
        Quantity::Velocity(sphere, ..)
        | Quantity::Speed(sphere, _)
        | Quantity::KineticEnergy(sphere, _)
        | Quantity::SphereEnergyLost(sphere)
        | Quantity::SphereEnergyGained(sphere)
        | Quantity::Mass(sphere) => Some(sphere),
        _ => None,
    }
}

/// The sphere whose motion, energy or mass the words name last: `the speed of *A*`, `lost by *A*`.
fn owner(before: &[Token]) -> Option<Sphere> {
    const OF: [&str; 3] = ["speed", "velocity", "energy"];
    before.windows(3).rev().find_map(|words| match words {
        [noun, of, Token::Sphere(sphere)]
            if (is_one_of(noun, &OF) && is_one_of(of, &["of"]))
                || (is_one_of(of, &["by"]) && is_one_of(noun, &["lost", "gained"])) =>
        {
            Some(*sphere)
        }
        _ => None,
    })
}
