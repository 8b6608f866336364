//! What the words say of the way in which a sphere moves off: whose direction is reversed or kept, who rebounds, and through
//! which angle a path is turned.

use std::cmp::Ordering;

use super::said::Seen;
use super::said_of_conditions::MEND;
use super::sentence::{Sentence, Token, is_one_of, says, subject};
use super::truth::is_at_rest;
use crate::examine::Finding;
use crate::expr::{Relation, print};
use crate::mechanics::{Axis, Condition, Moment, Quantity, Sphere};
use crate::number::Value;
use crate::unit::Unit;

impl Seen<'_> {
    /// A sphere whose direction is said to be reversed, or not to change.
    pub(super) fn turned_back(&self, sentence: &Sentence, findings: &mut Vec<Finding>) {
        // Of a component it may be said in any impact.
        if sentence.iter().any(|token| is_one_of(token, &["component"])) {
            return;
        }
        let Some(at) = sentence.iter().position(|token| is_one_of(token, &["direction"])) else { return };
        let sphere = |token: &Token| if let Token::Sphere(sphere) = token { Some(*sphere) } else { None };
        let verb = ["reversed", "unchanged", "changed"];
        let Some(end) = sentence[at..].iter().position(|token| is_one_of(token, &verb)).map(|end| at + end) else {
            self.changing(&sentence[..at], findings);
            return;
        };
        let Token::Word(word) = &sentence[end] else { return };
        let is_not = sentence[at..end].iter().any(|token| is_one_of(token, &["not"]));
        let is_back = match (word.as_str(), is_not) {
            ("reversed", false) => true,
            ("reversed", true) | ("unchanged", false) | ("changed", true) => false,
            // In a line there is one other direction.
            ("changed", false) if self.is_direct() => true,
            _ => return,
        };
        let of: Vec<Sphere> = sentence[at..end].iter().filter_map(sphere).collect();
        let of = match of.as_slice() {
            [of] => *of,
            // `*A* has its direction of motion reversed`
            [] if !says(&sentence[at..end], &["and", "both", "each"]) => match subject(&sentence[..at]) {
                Some(of) => of,
                None => return,
            },
            _ => return,
        };
        let met = self.known.0.keys().filter(|known| known.of_its_impact() == Quantity::Mass(of));
        if met.map(|mass| mass.impact()).ne([0]) {
            return;
        }
        if self.goes_on(of, is_back) == Some(false) {
            let said = match word.as_str() {
                "changed" if is_back => "changed",
                _ if is_back => "reversed",
                _ => "not changed",
            };
            let message = format!("the words say that the direction of `*{}*` is {said}, and it is not so", of.name());
            findings.push(self.finding(message, &format!("is {}{word}", if is_not { "not " } else { "" }), MEND));
        } else if is_back && self.may_come_to_rest(of) {
            let message = format!(
                "the words say that the direction of `*{}*` is {word}, and the condition lets it come to rest",
                of.name()
            );
            let help = "write `<` or `>` in `conditions`, in the place of `<=` or `>=`";
            findings.push(self.finding(message, &format!("is {word}"), help));
        }
    }

    /// `*A* does not change its` direction, `*A* reverses its` direction.
    fn changing(&self, before: &[Token], findings: &mut Vec<Finding>) {
        let [who @ .., verb, its] = before else { return };
        let is_back = match verb {
            Token::Word(verb) if ["reverse", "reverses"].contains(&verb.as_str()) => true,
            Token::Word(verb) if ["change", "changes"].contains(&verb.as_str()) && self.is_direct() => true,
            _ => return,
        };
        let is_not = who.last().is_some_and(|not| is_one_of(not, &["not", "never"]));
        let Some(sphere) = subject(who).filter(|_| is_one_of(its, &["its"])) else { return };
        let is_first = self.question.scene.then.is_empty();
        if is_first && self.goes_on(sphere, is_back != is_not) == Some(false) {
            let said = if is_not { "is not changed" } else { "is changed" };
            let message = format!("the words say that the direction of `*{}*` {said}, and it is not so", sphere.name());
            let Token::Word(verb) = verb else { return };
            findings.push(self.finding(message, &format!("{verb} its direction"), MEND));
        }
    }

    /// Has a condition on the way in which a sphere goes on nought among its values?
    fn may_come_to_rest(&self, sphere: Sphere) -> bool {
        matches!(self.way_required(sphere), Some(Relation::LessOrEqual | Relation::GreaterOrEqual))
    }

    /// Is the component of a sphere's velocity along the line of centres turned round?
    pub(super) fn turns_round(&self, sphere: Sphere) -> Option<bool> {
        let along = |moment| self.known.number(Quantity::Velocity(sphere, moment, Axis::N))?.sign();
        let before = along(Moment::Before)?;
        let after = along(Moment::After).or_else(|| self.required(sphere))?;
        Some(before.is_ne() && before == after.reverse())
    }

    /// Does a sphere go on in its old direction, or else back against it?
    pub(super) fn goes_on(&self, sphere: Sphere, is_back: bool) -> Option<bool> {
        match self.is_direct() {
            // What is at rest before or after has not turned back.
            true => self.turns_round(sphere).map(|turns| turns == is_back),
            false => self.keeps_its_line(sphere, is_back),
        }
    }

    /// The scalar product of a sphere's velocities before and after in the plane, and their cross product.
    pub(super) fn products(&self, sphere: Sphere) -> Option<(Value, Value)> {
        let along = |moment, axis| self.known.number(Quantity::Velocity(sphere, moment, axis));
        let components = |[one, other]: [Axis; 2]| {
            let of = |moment| Some([along(moment, one)?, along(moment, other)?]);
            Some((of(Moment::Before)?, of(Moment::After)?))
        };
        let found = components([Axis::N, Axis::T]).or_else(|| components([Axis::X, Axis::Y]));
        let ([p, q], [r, s]) = found?;
        Some((&(&p * &r) + &(&q * &s), &(&p * &s) - &(&q * &r)))
    }

    /// Does a sphere go on in its own line, back or forth?
    fn keeps_its_line(&self, sphere: Sphere, is_back: bool) -> Option<bool> {
        let (dot, cross) = self.products(sphere)?;
        let way = if is_back { Ordering::Less } else { Ordering::Greater };
        Some(cross.is_zero() && dot.sign().is_none_or(|sign| sign == way))
    }

    /// A sphere that is said to rebound, and goes on.
    pub(super) fn rebounding(&self, sentence: &Sentence, findings: &mut Vec<Finding>) {
        const REBOUNDS: [&str; 5] = ["rebounds", "rebound", "rebounded", "rebounding", "bounces"];
        let found = sentence.iter().enumerate().find(|(_, token)| is_one_of(token, &REBOUNDS));
        let Some((place, Token::Word(word))) = found else { return };
        if self.is_alone() || !self.question.scene.then.is_empty() {
            return;
        }
        let is_not = place > 0 && sentence[..place].iter().any(|token| is_one_of(token, &["not", "nor"]));
        let Some(sphere) = subject(&sentence[..place]) else { return };
        if self.turns_round(sphere) == Some(is_not) {
            let not = if is_not { "does not rebound" } else { "rebounds" };
            let message = format!("the words say that `*{}*` {not}, and it is not so", sphere.name());
            findings.push(self.finding(
                message,
                word,
                "mend the `conditions` or numbers of `[scene]`, or say what happens",
            ));
        }
    }

    /// The angle through which the path of a sphere is said to be turned.
    pub(super) fn turned_through(&self, sentence: &Sentence, findings: &mut Vec<Finding>) {
        let Some(at) = sentence.iter().position(|token| is_one_of(token, &["through"])) else { return };
        let is_turned =
            sentence[..at].iter().any(|token| is_one_of(token, &["turn", "turns", "turned", "deflects", "deflected"]));
        if is_turned && self.question.scene.then.is_empty() {
            self.turned_further(sentence, at, findings);
        }
        let said = self.angle_said(&sentence[at + 1..]);
        let (Some(said), true, true) = (said, is_turned, self.question.scene.then.is_empty()) else { return };
        // `more than a right angle` is no angle.
        let is_compared = sentence[at + 1..].iter().any(|token| is_one_of(token, &["than", "least", "most"]));
        let named = sentence[..at].iter().filter_map(|token| match token {
            Token::Sphere(sphere) => Some(*sphere),
            _ => None,
        });
        let named: Vec<Sphere> = named.collect();
        // Of `its direction` it is the only one there is.
        let sphere = match named.as_slice() {
            [sphere] => *sphere,
            [] if self.is_alone() => Sphere::A,
            _ => return,
        };
        if is_compared {
            return;
        }
        if is_at_rest(self.variant, sphere) == Some(true) {
            let name = sphere.name();
            let message =
                format!("the words say that the path of `*{name}*` is turned, and `*{name}*` is at rest before");
            let at = through(&sentence[at + 1..]);
            findings.push(self.finding(
                message,
                &at,
                "name the sphere that moves, or give this one a velocity in `[scene]`",
            ));
            return;
        }
        let Some((dot, cross)) = self.products(sphere) else { return };
        let is_so = match (said == 90.0, dot.to_f64(), cross.to_f64()) {
            (is_right, ..) if is_right || dot.is_zero() => is_right && dot.is_zero(),
            (false, Some(dot), Some(cross)) => (cross.abs().atan2(dot).to_degrees() - said).abs() < 1e-6,
            _ => return,
        };
        if !is_so {
            let message =
                format!("the words say that `*{}*` is turned through {said}°, and it is not so", sphere.name());
            let at = through(&sentence[at + 1..]);
            findings.push(self.finding(message, &at, "require the angle that is said, or say another"));
        }
    }

    /// A path that is said to be turned through more than a right angle, or less; through an acute angle, or an obtuse one.
    fn turned_further(&self, sentence: &Sentence, at: usize, findings: &mut Vec<Finding>) {
        let words = &sentence[at + 1..];
        let says_first = |list: &[&str]| words.iter().take(3).any(|token| is_one_of(token, list));
        let is_right = words.iter().take(5).any(|token| is_one_of(token, &["right"]));
        let (said, wanted) = match is_right {
            true if says_first(&["more", "greater"]) => ("more than a right angle", Ordering::Less),
            true if says_first(&["less", "smaller"]) => ("less than a right angle", Ordering::Greater),
            false if says_first(&["obtuse"]) => ("an obtuse angle", Ordering::Less),
            false if says_first(&["acute"]) => ("an acute angle", Ordering::Greater),
            _ => return,
        };
        let named =
            sentence.iter().filter_map(|token| if let Token::Sphere(sphere) = token { Some(*sphere) } else { None });
        let named: Vec<Sphere> = named.collect();
        let [sphere] = named.as_slice() else { return };
        let dot = Quantity::DeflectionDot(*sphere).to_string();
        let is_of_it = |condition: &&Condition| print::plain(&condition.left) == dot && condition.right.is_zero();
        let required =
            self.variant.scene.conditions.iter().find(is_of_it).and_then(|condition| match condition.relation {
                Relation::Less | Relation::LessOrEqual => Some(Ordering::Less),
                Relation::Greater | Relation::GreaterOrEqual => Some(Ordering::Greater),
                Relation::Equal => Some(Ordering::Equal),
                _ => None,
            });
        let known = || self.products(*sphere)?.0.sign();
        if required.or_else(known).is_some_and(|has| has != wanted) {
            let message =
                format!("the words say that `*{}*` is turned through {said}, and it is not so", sphere.name());
            let at = format!("through {}", said.split(' ').take(2).collect::<Vec<_>>().join(" "));
            findings.push(self.finding(message, &at, "require the angle that is said, or say another"));
        }
    }

    /// The angle in degrees that words begin with: `a right angle`, `an acute angle of 40°`. None if the first number is
    /// of something else, or not known.
    fn angle_said(&self, words: &[Token]) -> Option<f64> {
        let is_word = |(token, word): (&Token, &str)| is_one_of(token, &[word]);
        if words.len() > 2 && words.iter().zip(["a", "right", "angle"]).all(is_word) {
            return Some(90.0);
        }
        // Some numbers stand in the words without braces.
        let bare = |word: &String| word.parse().ok();
        let is_number = |token: &&Token| match token {
            Token::Number(..) => true,
            Token::Word(word) => bare(word).is_some(),
            _ => false,
        };
        match words.iter().take(5).find(is_number)? {
            Token::Number(expr, Unit::Degree, _) => self.number(expr)?.to_f64(),
            Token::Word(word) => bare(word),
            _ => None,
        }
    }

    /// The sign that a condition gives to the velocity of a sphere afterwards.
    pub(super) fn required(&self, sphere: Sphere) -> Option<Ordering> {
        match self.way_required(sphere)? {
            Relation::Less | Relation::LessOrEqual => Some(Ordering::Less),
            Relation::Greater | Relation::GreaterOrEqual => Some(Ordering::Greater),
            _ => None,
        }
    }

    fn way_required(&self, sphere: Sphere) -> Option<Relation> {
        let after = [Axis::X, Axis::N].map(|axis| Quantity::Velocity(sphere, Moment::After, axis).to_string());
        let of_it =
            |condition: &&Condition| after.contains(&print::plain(&condition.left)) && condition.right.is_zero();
        Some(self.variant.scene.conditions.iter().find(of_it)?.relation)
    }
}

/// Where the words `through …` stand: up to the number, or the next words.
fn through(after: &[Token]) -> String {
    let number = after.iter().take(5).find_map(|token| match token {
        Token::Number(expr, _, lead) => Some(format!("{lead}{{{}", print::plain(expr))),
        _ => None,
    });
    let words = || {
        let words = after.iter().map_while(|token| match token {
            Token::Word(word) => Some(word.as_str()),
            _ => None,
        });
        ["through"].into_iter().chain(words.take(3)).collect::<Vec<_>>().join(" ")
    };
    number.unwrap_or_else(words)
}

#[cfg(test)]
mod tests {
    use super::super::said_tests::assert_said;

    #[test]
    fn who_turns_back_or_through_an_angle_does_so() {
        let table = [
            (
                "direct/one-sphere-catches-the-other",
                "collide directly.",
                "collide directly. *A* does not change its direction.",
                "",
            ),
            (
                "direct/one-sphere-catches-the-other",
                "collide directly.",
                "collide directly. *A* reverses its direction.",
                "the direction of `*A*` is changed",
            ),
            (
                "direct/one-sphere-catches-the-other",
                "collide directly.",
                "collide. The direction of *B* is reversed.",
                "direction of `*B*` is reversed",
            ),
            (
                "ranges/direction-reversed",
                "A.after.x < 0",
                "A.after.x > 0",
                "the direction of `*A*` is reversed, and it is not",
            ),
            (
                "ranges/direction-reversed",
                "of *A* is reversed",
                "of *B* is reversed",
                "the direction of `*B*` is reversed",
            ),
            (
                "walls/rebound-speed-and-direction",
                "{e}.\n",
                "{e}. The direction of *A* is reversed.\n",
                "direction of `*A*` is reversed",
            ),
            (
                "walls/rebound-speed-and-direction",
                "{e}.\n",
                "{e}. The path of *A* is turned through a right angle.\n",
                "`*A*` is turned through 90°",
            ),
            (
                "walls/turned-through-a-right-angle",
                "through a right angle",
                "through an angle of {80 deg}",
                "through 80°",
            ),
            (
                "rest/speeds-and-directions",
                "is {e}.",
                "is {e}. Sphere *A* rebounds.",
                "`*A*` rebounds, and it is not so",
            ),
            (
                "ranges/turned-through-more-than-a-right-angle",
                "more than a right angle by",
                "less than a right angle by",
                "turned through less than a right angle, and it is not so",
            ),
            (
                "ranges/turned-through-more-than-a-right-angle",
                "through more than a right angle by",
                "through an obtuse angle by",
                "",
            ),
            (
                "rest-letters/turned-through-a-right-angle",
                "turned through a right angle",
                "turned through an acute angle",
                "turned through an acute angle, and it is not so",
            ),
            (
                "rest-letters/turned-through-a-right-angle",
                "the direction of motion of *A* is turned",
                "the direction of motion of *B* is turned",
                "the path of `*B*` is turned, and `*B*` is at rest before",
            ),
            (
                "vector-impulse/mass-from-the-speed-after",
                "Its speed immediately after the impulse is {v m/s}.",
                "Immediately after, its path is not perpendicular to its path before, and *A* has speed {v m/s}.",
                "",
            ),
            (
                "rest-letters/turned-through-a-right-angle",
                "turned through a right angle",
                "turned through an angle of {60 deg}",
                "`*A*` is turned through 60°",
            ),
            ("ranges/mass-ratio-when-a-goes-on", "is not changed", "is reversed", "the direction of `*A*` is reversed"),
            (
                "direct/one-sphere-catches-the-other",
                "collide directly.",
                "collide. *B* has its direction of motion reversed.",
                "`*B*` is reversed",
            ),
            (
                "direct/one-sphere-catches-the-other",
                "collide directly.",
                "collide. They then move in opposite directions.",
                "",
            ),
        ];
        assert_said(&table);
    }
}
