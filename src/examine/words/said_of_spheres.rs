//! What the words say of spheres beside each other: whose masses and radii are alike, who is the heavier, and in which order
//! they lie.

use std::cmp::Ordering;

use super::said::Seen;
use super::sentence::{Noun, Sentence, Token, is_one_of, noun_of, says};
use crate::examine::Finding;
use crate::expr::{Angles, Meaning, print, read};
use crate::generate::Variant;
use crate::mechanics::{Meeting, Quantity, Sphere};
use crate::number::{Demand, Value, solve_inequalities};
use crate::unit::Unit;

impl Seen<'_> {
    /// Masses that are said to be equal, of the spheres that the sentence names or of all.
    pub(super) fn equal_masses(&self, sentence: &Sentence, findings: &mut Vec<Finding>) {
        const MASS: [&str; 2] = ["mass", "masses"];
        let is_equal = |pair: &[Token]| is_one_of(&pair[0], &["equal", "same"]) && is_one_of(&pair[1], &MASS);
        let are_equal = |three: &[Token]| {
            is_one_of(&three[0], &MASS) && is_one_of(&three[1], &["are"]) && is_one_of(&three[2], &["equal"])
        };
        let is_said = sentence.windows(2).any(is_equal) || sentence.windows(3).any(are_equal);
        // `*A* has a different mass from *C*` is said of two that are named.
        let is_unlike =
            |pair: &[Token]| is_one_of(&pair[0], &["different", "unequal", "differing"]) && is_one_of(&pair[1], &MASS);
        let is_said_unlike = !is_said && sentence.windows(2).any(is_unlike) && !says(sentence, &["not", "no"]);
        if !(is_said || is_said_unlike) || self.is_alone() {
            return;
        }
        let named = |sphere: &Sphere| sentence.contains(&Token::Sphere(*sphere));
        let named: Vec<Sphere> = Sphere::ALL.into_iter().filter(named).collect();
        let spheres = if named.len() > 1 { &named[..] } else { &Sphere::ALL };
        let mass = |sphere: &Sphere| {
            let known = self.known.number(self.first(*sphere, Quantity::Mass(*sphere))?)?;
            Some((*sphere, known))
        };
        let masses: Vec<(Sphere, Value)> = spheres.iter().filter_map(mass).collect();
        if is_said_unlike {
            if masses.len() == 2 && masses[0].1.equals(&masses[1].1) {
                let message = "the words say that the masses are different, and in the scene they are equal";
                let at = if says(sentence, &["masses"]) { "masses" } else { "mass" };
                findings.push(self.finding(
                    message.to_owned(),
                    at,
                    "require that they differ, or say that they are equal",
                ));
            }
            return;
        }
        let unlike = |pair: &&[(Sphere, Value)]| !pair[0].1.equals(&pair[1].1);
        if let Some([(one, _), (other, _)]) = masses.windows(2).find(unlike) {
            let message = format!(
                "the words say that masses are equal, and those of `*{}*` and `*{}*` are not",
                one.name(),
                other.name()
            );
            let at = if says(sentence, &["masses"]) { "masses" } else { "mass" };
            findings.push(self.finding(message, at, "give them equal masses in `[scene]`, or say what each has"));
        }
    }

    /// Three spheres that are said to lie in an order: the one that meets both others lies between them.
    pub(super) fn order(&self, sentence: &Sentence, findings: &mut Vec<Finding>) {
        let Some((word, [one, middle, other])) = in_order(sentence).or_else(|| between(sentence)) else { return };
        let later = self.variant.scene.then.iter().map(|then| then.meeting).filter(|meeting| !meeting.with_wall);
        let meets = |[one, other]: [Sphere; 2]| {
            std::iter::once(Meeting::FIRST)
                .chain(later.clone())
                .any(|of| of.of == [one, other] || of.of == [other, one])
        };
        if meets([one, other]) && one != other && middle != one && middle != other {
            let (one, middle, other) = (one.name(), middle.name(), other.name());
            let message =
                format!("the words put `*{middle}*` between `*{one}*` and `*{other}*`, which meet in the scene");
            findings.push(self.finding(message, &word, "name the spheres in the order in which they lie"));
        }
    }

    /// `speed {3*i + 2*j}`, `of magnitude {[p, q] N s}`: a size has no direction.
    pub(super) fn speed_of_a_vector(&self, sentence: &Sentence, findings: &mut Vec<Finding>) {
        for (place, token) in sentence.iter().enumerate() {
            let Token::Number(expr, _, lead) = token else { continue };
            let is_speed = matches!(noun_of(sentence, place), Some((_, Noun::Speed, _)));
            let is_size = place > 0 && is_one_of(&sentence[place - 1], &["magnitude", "size"]);
            if (is_speed || is_size) && matches!(self.meaning(expr), Some(Meaning::Vector(..))) {
                let (called, help) = match is_speed {
                    true => ("speed", "write `velocity`, or give the speed alone"),
                    false => ("magnitude", "leave `magnitude` out, or give the size alone"),
                };
                let message = format!("the words call the vector `{}` a {called}", print::plain(expr));
                findings.push(self.finding(message, lead, help));
            }
        }
    }

    /// `Its velocity is {v m/s}` in a plane: a number is a speed, unless a direction is said.
    pub(super) fn velocity_without_direction(&self, sentence: &Sentence, findings: &mut Vec<Finding>) {
        const WAYS: [&str; 16] = [
            "direction",
            "along",
            "towards",
            "parallel",
            "perpendicular",
            "angle",
            "angles",
            "away",
            "from",
            "line",
            "north",
            "south",
            "east",
            "west",
            "magnitude",
            "size",
        ];
        if self.question.scene.is_in_one_line() || says(sentence, &WAYS) || !says(sentence, &["velocity"]) {
            return;
        }
        // `Its velocity after the impulse is`
        let sentence: Sentence = sentence.iter().filter(|token| !is_one_of(token, &["impulse"])).cloned().collect();
        for (place, token) in sentence.iter().enumerate() {
            let Token::Number(expr, Unit::MetrePerSecond, lead) = token else { continue };
            let is_velocity = matches!(noun_of(&sentence, place), Some((_, Noun::Velocity, false)));
            if is_velocity && matches!(self.meaning(expr), Some(Meaning::Number(_))) {
                let message = format!("the words call `{}` a velocity, and it has no direction", print::plain(expr));
                let help = "write `speed`, or give the velocity as a vector";
                findings.push(self.finding(message, lead, help).as_warning());
            }
        }
    }

    /// Which sphere is the lighter, or the heavier.
    pub(super) fn heavier(&self, sentence: &Sentence, findings: &mut Vec<Finding>) {
        let Some(at) = sentence.iter().position(|token| is_one_of(token, &["lighter", "heavier"])) else { return };
        let is_named = at > 0 && is_one_of(&sentence[at - 1], &["the"]);
        if !is_named || says(sentence, &["than"]) || !self.question.scene.then.is_empty() || self.is_alone() {
            return;
        }
        // `The heavier sphere is *B*` names it after its verb, and `the heavier sphere strikes *B*` does not.
        let follows = match &sentence[at + 1..] {
            [_, is, named, ..] if is_one_of(is, &["is"]) => std::slice::from_ref(named),
            next => &next[..next.len().min(2)],
        };
        let beside = follows.iter().chain(sentence[..at].iter().rev().take(3));
        let sphere = beside.into_iter().find_map(|token| match token {
            Token::Sphere(sphere) => Some(*sphere),
            _ => None,
        });
        let (Some(one), Token::Word(word)) = (sphere, &sentence[at]) else { return };
        let other = if one == Sphere::A { Sphere::B } else { Sphere::A };
        let mass = |sphere| self.known.number(Quantity::Mass(sphere));
        let (Some(own), Some(its)) = (mass(one), mass(other)) else { return };
        let wanted = if word == "lighter" { Ordering::Less } else { Ordering::Greater };
        if is_always(self.variant, &(&own - &its), wanted) == Some(false) {
            let message = format!("the words say that `*{}*` is the {word} sphere, and it is not so", one.name());
            findings.push(self.finding(
                message,
                &format!("the {word}"),
                "require that it is so, or take the words out",
            ));
        }
    }

    /// `The mass of *A* is greater than that of *B*`
    pub(super) fn greater_mass(&self, sentence: &Sentence, findings: &mut Vec<Finding>) {
        const GREATER: [&str; 4] = ["greater", "larger", "more", "bigger"];
        const LESS: [&str; 2] = ["less", "smaller"];
        let sphere = |token: &Token| if let Token::Sphere(sphere) = token { Some(*sphere) } else { None };
        for at in 1..sentence.len().saturating_sub(1) {
            let (before, after) = (&sentence[..at], &sentence[at + 1..]);
            let wanted = match &sentence[at] {
                word if is_one_of(word, &GREATER) => Ordering::Greater,
                word if is_one_of(word, &LESS) => Ordering::Less,
                _ => continue,
            };
            let is_mass = |pair: &[Token]| is_one_of(&pair[0], &["mass"]) && is_one_of(&pair[1], &["of"]);
            let mass = before.windows(2).rposition(is_mass);
            let one = mass.and_then(|mass| before[mass + 2..].iter().find_map(sphere));
            // `than {2} times the mass of *B*` says more.
            let than = after.iter().position(|token| sphere(token).is_some()).unwrap_or(after.len());
            let is_plain = after[..than]
                .iter()
                .all(|token| is_one_of(token, &["than", "that", "of", "the", "mass", "sphere", "ball", "particle"]));
            let (Some(one), Some(other), true) = (one, after.get(than).and_then(sphere), is_plain) else { continue };
            let own = |of: Sphere| self.known.number(self.first(of, Quantity::Mass(of))?);
            let (Some(own), Some(its)) = (own(one), own(other)) else { continue };
            let is_denied = says(before, &["not"]);
            let is_so = is_always(self.variant, &(&own - &its), wanted);
            if is_one_of(&after[0], &["than"]) && is_so == Some(is_denied) {
                let Token::Word(word) = &sentence[at] else { continue };
                let not = if is_denied { "not " } else { "" };
                let message = format!(
                    "the words say that the mass of `*{}*` is {not}{word} than that of `*{}*`, and it is not so",
                    one.name(),
                    other.name()
                );
                let help = "require that it is so, or take the words out";
                findings.push(self.finding(message, &format!("{word} than"), help));
            }
        }
    }

    pub(super) fn radius(&self, sphere: Sphere) -> Option<Value> {
        let radii = &self.question.scene.radii;
        let radius = if sphere == Sphere::A { &radii.a } else { &radii.b };
        self.number(&read(radius.as_ref()?, Angles::Degrees).ok()?)
    }

    /// Radii that are said to be equal, or not to be. Spheres of which the scene has no radii meet as equal ones do.
    pub(super) fn radii(&self, sentence: &Sentence, findings: &mut Vec<Finding>) {
        const EQUAL: [&str; 3] = ["equal", "same", "identical"];
        const OTHER: [&str; 9] =
            ["unequal", "different", "twice", "double", "half", "triple", "thrice", "larger", "smaller"];
        let Some(at) = sentence.iter().position(|token| is_one_of(token, &["radius", "radii"])) else { return };
        let says = |words: &[&str]| sentence.iter().find(|token| is_one_of(token, words));
        // A distance may be half a radius.
        if says(&["distance", "path"]).is_some() || self.is_alone() {
            return;
        }
        let is_said_equal = is_one_of(&sentence[at.saturating_sub(1)], &EQUAL);
        let are_equal = match Sphere::BOTH.map(|sphere| self.radius(sphere)) {
            [Some(a), Some(b)] => a.equals(&b),
            _ => true,
        };
        // `Twice the radius` or `the radius of *A* is twice`, and not a mass that is twice another.
        let near = &sentence[at.saturating_sub(2)..sentence.len().min(at + 5)];
        let is_of_another = near.iter().any(|token| is_one_of(token, &["mass", "masses", "speed", "speeds"]));
        let beside = near.iter().any(|token| is_one_of(token, &OTHER) && !is_of_another);
        let is_told = is_one_of(&sentence[at.saturating_sub(1)], &["different", "unequal"]);
        let (said, is_so) = match is_said_equal {
            true => ("equal", are_equal),
            false if beside || is_told || are_typed_unlike(&sentence[at + 1..]) => ("different", !are_equal),
            false => return,
        };
        if !is_so {
            let message = format!("the words say that the radii are {said}, and in the scene they are not");
            let Token::Word(radii) = &sentence[at] else { return };
            findings.push(self.finding(message, radii, "give in `[scene]` the `radii` that are said, or say others"));
        }
    }
}

/// Has a number this sign, whatever the letter comes to of which a range is found? None where that is not known.
pub(super) fn is_always(variant: &Variant, number: &Value, wanted: Ordering) -> Option<bool> {
    if let Some(sign) = number.sign() {
        return Some(sign == wanted);
    }
    let values = variant.solution.range().filter(|values| number.has_letter(|letter| *letter == values.letter))?;
    let number = if wanted.is_lt() { -number } else { number.clone() };
    let spans = solve_inequalities(&[(number, Demand::Positive)], values.letter).ok()?;
    Some(spans.iter().any(|span| span.holds(&values.span)))
}

/// Are radii typed in the words, as numbers without braces, and is one of them another than the first?
fn are_typed_unlike(after: &[Token]) -> bool {
    let typed = after.iter().take_while(|token| !matches!(token, Token::Comma | Token::Sphere(_) | Token::Number(..)));
    let numbers = typed.filter_map(|token| match token {
        Token::Word(word) => word.parse::<f64>().ok(),
        _ => None,
    });
    let numbers: Vec<f64> = numbers.collect();
    numbers.iter().any(|number| *number != numbers[0])
}

/// Three spheres `in the order *A*, *B*, *C*`, with the word that says so.
fn in_order(sentence: &[Token]) -> Option<(String, [Sphere; 3])> {
    let at = sentence.iter().position(|token| is_one_of(token, &["order"]))?;
    let is_that = at > 0 && is_one_of(&sentence[at - 1], &["that", "this"]);
    let words = if is_that { &sentence[..at] } else { &sentence[at..] };
    let named: Vec<Sphere> = words.iter().filter_map(sphere).take(3).collect();
    Some(("order".to_owned(), named.try_into().ok()?))
}

/// `*B* lies between *A* and *C*`: the three in the order of their line. A coefficient `between *A* and *B*` is of two.
fn between(sentence: &[Token]) -> Option<(String, [Sphere; 3])> {
    let place = |words: &[Token]| match words {
        [middle, between, one, and, other] if is_one_of(between, &["between"]) && is_one_of(and, &["and"]) => {
            Some([sphere(one)?, sphere(middle)?, sphere(other)?])
        }
        _ => None,
    };
    let lies: Vec<Token> =
        sentence.iter().filter(|token| !is_one_of(token, &["is", "lies", "lying", "at", "rest"])).cloned().collect();
    let found = lies.windows(5).find_map(place)?;
    Some((format!("between *{}*", found[0].name()), found))
}

fn sphere(token: &Token) -> Option<Sphere> {
    match token {
        Token::Sphere(sphere) => Some(*sphere),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::super::said_tests::{assert_said, said};
    use crate::examine::Edits;

    #[test]
    fn masses_and_radii_are_as_they_are_said_to_be_beside_each_other() {
        let table = [
            (
                "deflection/equal-masses",
                "and each has mass {mA}",
                "and different masses",
                "say that the masses are different",
            ),
            (
                "rest/speeds-and-directions",
                "The spheres have equal radii.",
                "The spheres have different masses and equal radii.",
                "",
            ),
            ("rest/speeds-and-directions", "have equal radii", "have different radii", "the radii are different"),
            (
                "rest/speeds-and-directions",
                "have equal radii",
                "have equal radii and equal masses",
                "`*A*` and `*B*` are not",
            ),
            (
                "i-j/energy-lost",
                "They are moving",
                "Their masses are equal. They are moving",
                "masses are equal, and those of",
            ),
            (
                "successive/three-in-a-line",
                "of equal radius and",
                "of equal radius, *A* and *B* of equal mass,",
                "are equal",
            ),
            ("deflection/equal-masses", "equal radii", "equal radii and the same mass", ""),
            ("successive/three-in-a-line", "in that order", "in the order *C*, *B*, *A*", ""),
            (
                "successive/three-in-a-line",
                "*A*, *B* and *C*, of",
                "*B*, *A* and *C*, of",
                "`*A*` between `*B*` and `*C*`",
            ),
            (
                "successive/three-in-a-line",
                "in that order",
                "in the order *A*, *C*, *B*",
                "`*C*` between `*A*` and `*B*`",
            ),
            ("i-j/energy-lost", "the velocity of *A* is", "the speed of *A* is", "call the vector `[ax, ay]` a speed"),
            (
                "i-j/energy-lost",
                "velocity of *A* is {[ax, ay] m/s}",
                "velocity of *A* is in the direction of {[ax, ay]}",
                "",
            ),
            (
                "rest/speeds-and-directions",
                "The spheres have equal radii",
                "The radius of *A* is twice that of *B*",
                "the radii are different",
            ),
            ("rest/speeds-and-directions", "have equal radii", "have equal radii, and one mass is twice the other", ""),
            (
                "rest/heavier-sphere-struck",
                "respectively. Sphere *B* is",
                "respectively. Sphere *B*, the lighter, is",
                "`*B*` is the lighter sphere",
            ),
            (
                "rest/heavier-sphere-struck",
                "respectively. Sphere *B* is",
                "respectively. The heavier sphere *B* is",
                "",
            ),
            ("successive/three-in-a-line", "lie in that order\nin a", "lie in a", ""),
            ("successive/three-in-a-line", "lie in that order\nin a", "lie, with *B* between *A* and *C*, in a", ""),
            (
                "successive/three-in-a-line",
                "lie in that order\nin a",
                "lie, with *C* between *A* and *B*, in a",
                "put `*C*` between `*A*` and `*B*`",
            ),
            ("successive/three-in-a-line", "after *A* has struck it.", "after its collision with *A*.", ""),
            (
                "vector-impulse/mass-from-the-speed-after",
                "an impulse of\n",
                "an impulse of magnitude\n",
                "call the vector `[p, q]` a magnitude",
            ),
            (
                "rest/heavier-sphere-struck",
                "Sphere *B* is",
                "The heavier sphere is *A*. *B* is",
                "`*A*` is the heavier sphere",
            ),
            ("rest/heavier-sphere-struck", "Sphere *B* is", "The heavier sphere is *B*. *B* is", ""),
            (
                "rest-letters/distance-from-the-centre-of-b",
                "*A* and *B* each have radius {r}",
                "*A* and *B* have radii {r} and {2*r}",
                "give `*B*` the radius `2*r`",
            ),
            (
                "direct/restitution-from-one-speed",
                "Immediately after the collision the speed of *A* is",
                "It rebounds and *A* leaves *B* with speed",
                "",
            ),
            (
                "direct/one-sphere-catches-the-other",
                "collide directly.",
                "collide directly, with equal speeds before it.",
                "speeds are equal",
            ),
            (
                "both-moving/energy-lost-and-impulse",
                "The coefficient",
                "Before it the spheres have equal speeds. The coefficient",
                "speeds are equal",
            ),
            (
                "both-moving/energy-lost-and-impulse",
                "The coefficient",
                "*B* then has the same speed as before. The coefficient",
                "",
            ),
            (
                "both-moving/energy-lost-and-impulse",
                "The coefficient",
                "The speeds of *A* and *B* are equal after it. The coefficient",
                "speeds are equal",
            ),
            (
                "vector-impulse/mass-from-the-speed-after",
                "Its speed immediately after",
                "The magnitude of its velocity immediately after",
                "",
            ),
            (
                "vector-impulse/mass-from-the-speed-after",
                "Its speed immediately after",
                "Its velocity immediately after",
                "call `v` a velocity",
            ),
            ("rest/speeds-and-directions", "have equal radii", "have different radii", "the radii are different"),
            ("rest/speeds-and-directions", "have equal radii", "have radii 2 cm and 3 cm", "the radii are different"),
            ("rest/speeds-and-directions", "have equal radii", "have equal radii of 2 cm", ""),
            (
                "rest/heavier-sphere-struck",
                "The coefficient",
                "The mass of *A* is greater than that of *B*. The coefficient",
                "`*A*` is greater than that of `*B*`",
            ),
            (
                "rest/heavier-sphere-struck",
                "The coefficient",
                "The mass of *A* is less than the mass of *B*. The coefficient",
                "",
            ),
        ];
        assert_said(&table);
    }

    #[test]
    fn who_is_the_heavier_is_so_for_every_value_of_a_ratio_that_is_found() {
        let (goes_on, can_be) = ("ranges/mass-ratio-when-a-goes-on", "ranges/mass-ratio-that-can-be");
        let constant = "where {k} is a positive constant.";
        let with = |words: &str| format!("{constant} {words}");
        let [lighter, heavier, than, greater] = [
            "The lighter sphere is *A*.",
            "The heavier sphere is *A*.",
            "*B* is heavier than *A*.",
            "The mass of *A* is greater than that of *B*.",
        ]
        .map(with);
        // The speeds 3u and 2u of A leave it 2 to 5 times the mass of B.
        let (three, two) = (("p = \"2..40\"", "p = [\"3\"]"), ("q = \"1..39\"", "q = [\"2\"]"));
        let table: [(&str, Edits, &str); 6] = [
            (goes_on, &[(constant, &lighter)], "`*A*` is the lighter sphere"),
            (can_be, &[three, two, (constant, &heavier)], ""),
            (can_be, &[three, two, (constant, &lighter)], "`*A*` is the lighter sphere"),
            (can_be, &[three, two, (constant, &than)], "B is heavier than A"),
            (can_be, &[three, two, (constant, &greater)], ""),
            (goes_on, &[(constant, &with("The mass of *A* is less than that of *B*."))], "less than that of `*B*`"),
        ];
        for (id, edits, words) in table {
            let said = said(id, edits);
            assert!(said.contains(words) && said.is_empty() == words.is_empty(), "{id}: {edits:?}: {said}");
        }
    }
}
