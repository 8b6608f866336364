//! What the words of a part request, thing by thing: `the speed of *A* and the angle that its path makes with the wall` are
//! two, and each is to be found by an answer.

use super::sentence::{Token, is_one_of};
use crate::expr::Expr;
use crate::mechanics::Quantity;
use crate::unit::Unit;

/// What a noun stands for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Thing {
    /// How fast something moves.
    Speed,
    /// A speed with its direction, or a component of it.
    Velocity,
    /// An angle or a direction.
    Angle,
    /// A kinetic energy.
    Energy,
    /// A share of one.
    Share,
    /// An impulse.
    Impulse,
    /// A momentum, of which an impulse is the change.
    Momentum,
    /// A coefficient of restitution.
    Restitution,
    /// A mass.
    Mass,
    /// One thing over another.
    Ratio,
    /// What no collision tells.
    Strange,
}

/// Nouns, each with what it stands for.
const NOUNS: [(&str, Thing); 43] = [
    ("speed", Thing::Speed),
    ("speeds", Thing::Speed),
    ("velocity", Thing::Velocity),
    ("velocities", Thing::Velocity),
    ("component", Thing::Velocity),
    ("components", Thing::Velocity),
    ("angle", Thing::Angle),
    ("angles", Thing::Angle),
    ("direction", Thing::Angle),
    ("directions", Thing::Angle),
    ("deflection", Thing::Angle),
    ("deflections", Thing::Angle),
    ("inclination", Thing::Angle),
    ("bearing", Thing::Angle),
    ("energy", Thing::Energy),
    ("energies", Thing::Energy),
    ("ke", Thing::Energy),
    ("fraction", Thing::Share),
    ("proportion", Thing::Share),
    ("percentage", Thing::Share),
    ("impulse", Thing::Impulse),
    ("impulses", Thing::Impulse),
    ("momentum", Thing::Momentum),
    ("momenta", Thing::Momentum),
    ("coefficient", Thing::Restitution),
    ("coefficients", Thing::Restitution),
    ("mass", Thing::Mass),
    ("masses", Thing::Mass),
    ("ratio", Thing::Ratio),
    ("force", Thing::Strange),
    ("forces", Thing::Strange),
    ("friction", Thing::Strange),
    ("distance", Thing::Strange),
    ("distances", Thing::Strange),
    ("displacement", Thing::Strange),
    ("time", Thing::Strange),
    ("times", Thing::Strange),
    ("acceleration", Thing::Strange),
    ("power", Thing::Strange),
    ("height", Thing::Strange),
    ("pressure", Thing::Strange),
    ("weight", Thing::Strange),
    ("weights", Thing::Strange),
];

/// One thing that is requested.
#[derive(Clone, Debug, PartialEq)]
pub struct Request<'s> {
    /// The words from its first noun to the last that describes it.
    pub words: &'s [Token<'s>],
    /// What it is.
    pub thing: Thing,
    /// Is it by how much something changes?
    pub is_change: bool,
    /// Is its magnitude alone wanted?
    pub is_size: bool,
}

/// What a noun stands for, if it is one of a quantity.
pub fn thing(token: &Token) -> Option<Thing> {
    NOUNS.iter().find(|(noun, _)| is_one_of(token, &[noun])).map(|(_, thing)| *thing)
}

/// Words after which something is requested, and words after which something else comes.
const ASKING: [&str; 9] = ["find", "calculate", "determine", "state", "obtain", "deduce", "down", "evaluate", "what"];
const OTHERWISE: [&str; 18] = [
    "show", "showing", "prove", "verify", "given", "giving", "give", "where", "if", "assuming", "knowing", "provided",
    "taking", "leaving", "explain", "justify", "so", "such",
];

/// All that a sentence requests. What only describes a thing, as `the angle that its direction makes`, is none.
pub fn requests<'s>(sentence: &'s [Token<'s>]) -> Vec<Request<'s>> {
    let mut found: Vec<Request> = Vec::new();
    // Between two of something stands an `and` that leads to nothing new.
    let (mut is_asked, mut is_of_two) = (false, false);
    for (place, token) in sentence.iter().enumerate() {
        let leads = match token {
            token if is_one_of(token, &ASKING) => {
                (is_asked, is_of_two) = (true, false);
                true
            }
            // `In terms of the letters given`
            token if is_one_of(token, &OTHERWISE) && !is_of_what_is_given(sentence, place) => {
                is_asked = false;
                false
            }
            token if is_one_of(token, &["between", "ratio", "difference", "sum", "product"]) => {
                is_of_two = true;
                false
            }
            token if is_one_of(token, &["and"]) => !std::mem::take(&mut is_of_two),
            Token::Comma => true,
            _ => false,
        };
        if is_asked && leads {
            found.extend(request(&sentence[place + 1..]));
        }
    }
    found
}

/// `The letters given`, `the constants given`
fn is_of_what_is_given(sentence: &[Token], place: usize) -> bool {
    const LETTERS: [&str; 5] = ["letters", "constants", "symbols", "quantities", "data"];
    let before = place.checked_sub(1).map(|before| &sentence[before]);
    is_one_of(&sentence[place], &["given"]) && before.is_some_and(|before| is_one_of(before, &LETTERS))
}

/// The thing with which words begin, behind articles and what describes it: `the magnitude of the impulse`.
fn request<'s>(words: &'s [Token<'s>]) -> Option<Request<'s>> {
    const DESCRIBED: [&str; 27] = [
        "is",
        "are",
        "the",
        "its",
        "their",
        "a",
        "an",
        "total",
        "kinetic",
        "exact",
        "acute",
        "obtuse",
        "final",
        "possible",
        "greatest",
        "least",
        "largest",
        "smallest",
        "maximum",
        "minimum",
        "new",
        "resulting",
        "relative",
        "common",
        "how",
        "much",
        "also",
    ];
    const SIZES: [&str; 2] = ["magnitude", "size"];
    const CHANGES: [&str; 7] = ["change", "increase", "decrease", "reduction", "gain", "loss", "amount"];
    let (mut is_change, mut is_size) = (false, false);
    for (place, token) in words.iter().enumerate() {
        let is_behind = is_size || is_change;
        if let Some(thing) = thing(token) {
            let words = &words[place..];
            let end = words.iter().position(|token| *token == Token::Comma || is_one_of(token, &["and", "in"]));
            let words = &words[..end.unwrap_or(words.len())];
            // `The direction of *A* being positive` and `by momentum considerations` request nothing.
            if words.iter().any(|token| is_one_of(token, &["being", "having", "considerations"])) {
                return None;
            }
            // There is one of friction too.
            let is_friction = thing == Thing::Restitution && words.iter().any(|token| is_one_of(token, &["friction"]));
            let thing = if is_friction { Thing::Strange } else { thing };
            return Some(Request { words, thing, is_change, is_size });
        }
        match token {
            token if is_one_of(token, &SIZES) => is_size = true,
            token if is_one_of(token, &CHANGES) => is_change = true,
            token if is_one_of(token, &["of", "in"]) && is_behind => {}
            // `By how much`, and not `by momentum`.
            token if is_one_of(token, &["by"]) => {
                words.get(place + 1).filter(|next| is_one_of(next, &["how"])).map(drop)?
            }
            token if is_one_of(token, &DESCRIBED) => {}
            _ => return None,
        }
    }
    None
}

impl Request<'_> {
    /// Is a quantity what is requested?
    pub fn is_found_by(&self, quantity: Quantity) -> bool {
        let is_relative = self.words.iter().any(|token| is_one_of(token, &["approach", "separation", "separate"]));
        match self.thing {
            Thing::Speed | Thing::Velocity if self.is_change => false,
            Thing::Speed if is_relative => {
                matches!(quantity.of_its_impact(), Quantity::Approach | Quantity::Separation)
            }
            Thing::Share if self.words.iter().any(|token| is_one_of(token, &["momentum", "speed", "velocity"])) => {
                false
            }
            Thing::Momentum if !self.is_change && !self.is_given_away() => {
                matches!(quantity.of_its_impact(), Quantity::SphereMomentum(..) | Quantity::TotalMomentum(_))
            }
            thing => thing.is(quantity),
        }
    }

    /// `The momentum that *A* gives to *B*` is an impulse.
    fn is_given_away(&self) -> bool {
        const GIVEN: [&str; 6] = ["gain", "give", "los", "receiv", "transfer", "impart"];
        let is_given = |word: &String| GIVEN.iter().any(|begin| word.starts_with(begin));
        self.words.iter().any(|token| matches!(token, Token::Word(word) if is_given(word)))
    }

    /// As it is said.
    pub fn said(&self) -> String {
        let words = self.words.iter().map(|token| match token {
            Token::Word(word) => word.clone(),
            Token::Sphere(sphere) => format!("*{}*", sphere.name()),
            Token::Number(Expr::Name(name), ..) => name.text.clone(),
            Token::Number(..) | Token::Comma => "…".to_owned(),
        });
        words.take(4).collect::<Vec<_>>().join(" ")
    }
}

impl Thing {
    /// What it is stated in; none where that may be anything.
    pub fn unit(self) -> Option<Unit> {
        match self {
            Thing::Speed | Thing::Velocity => Some(Unit::MetrePerSecond),
            Thing::Angle => Some(Unit::Degree),
            Thing::Energy => Some(Unit::Joule),
            Thing::Impulse | Thing::Momentum => Some(Unit::NewtonSecond),
            Thing::Mass => Some(Unit::Kilogram),
            Thing::Share | Thing::Restitution => Some(Unit::None),
            Thing::Ratio | Thing::Strange => None,
        }
    }

    /// Is a quantity one of these?
    pub fn is(self, quantity: Quantity) -> bool {
        use Quantity::*;
        let quantity = quantity.of_its_impact();
        match self {
            Thing::Speed | Thing::Velocity => matches!(quantity, Speed(..) | Velocity(..) | Approach | Separation),
            Thing::Angle => {
                quantity.is_angle()
                    || matches!(quantity, TanToLine(..) | TOverN(..) | TanToWall(..) | TanDeflection(_))
                    || matches!(quantity, Velocity(..) | Impulse(..) | Line(_) | Tangent(_))
            }
            Thing::Energy | Thing::Share => matches!(
                quantity,
                KineticEnergy(..)
                    | SphereEnergyLost(_)
                    | SphereEnergyGained(_)
                    | TotalEnergy(_)
                    | EnergyLost
                    | FractionLost
                    | MassRatio
            ),
            Thing::Impulse => matches!(quantity, Impulse(..) | ImpulseMagnitude),
            Thing::Momentum => {
                matches!(quantity, Impulse(..) | ImpulseMagnitude | SphereMomentum(..) | TotalMomentum(_))
            }
            Thing::Restitution => quantity == Restitution,
            Thing::Mass => matches!(quantity, Mass(_) | MassRatio),
            Thing::Ratio => matches!(quantity, MassRatio | FractionLost),
            Thing::Strange => false,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::sentence::sentences;
    use super::*;
    use crate::expr::read_markup;

    #[test]
    fn what_is_requested_is_told_from_what_describes_it() {
        let table = [
            ("Find the speed of *A* and the speed of *B*.", "speed of *A*; speed of *B*"),
            (
                "Find its speed, and the angle that its direction then makes with {i}.",
                "speed; angle that its direction",
            ),
            ("Find, in terms of {u} and {e}, the velocity of each sphere.", "velocity of each sphere"),
            ("Find the velocity, momentum and kinetic energy of *B*.", "velocity; momentum; energy of *B*"),
            ("Find the angle between the line of centres and the direction of *A*.", "angle between the line"),
            ("Show that momentum is conserved, and find the magnitude of the impulse.", "impulse"),
            ("Find the speed of *B*, taking the direction of *A* as positive, the speed being small.", "speed of *B*"),
            ("The direction of motion of *A* is reversed.", ""),
            ("Find the set of values of {e}.", ""),
            ("What is the loss in kinetic energy?", "energy"),
            ("By how much is the KE reduced? Find how much KE is lost.", "ke is lost"),
            (
                "Find, by momentum considerations, the speed of *B*, the direction of *A* being positive.",
                "speed of *B*",
            ),
            ("Write down the ratio of the speed of *A* and the speed of *B*.", "ratio of the speed"),
        ];
        for (words, said) in table {
            let text = read_markup(words).unwrap();
            let found: Vec<String> = sentences(&text[0])
                .iter()
                .flat_map(|sentence| requests(sentence).iter().map(Request::said).collect::<Vec<_>>())
                .collect();
            assert_eq!(found.join("; "), said, "{words}");
        }
    }
}
