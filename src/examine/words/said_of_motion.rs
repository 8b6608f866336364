//! What the words say of how it happens: what is elastic, what is direct, who moves and who rests.

use std::cmp::Ordering;

use super::impacts::impacts;
use super::said::{Seen, moment};
use super::sentence::{Sentence, Token, is_one_of, says, subject};
use super::truth::is_at_rest;
use crate::examine::Finding;
use crate::expr::{Angles, print, read, written};
use crate::mechanics::{Axis, Moment, Quantity, Setting, Sphere};
use crate::number::Value;

/// Words of what does not move.
const RESTS: [&str; 5] = ["rest", "rests", "resting", "stationary", "motionless"];

impl Seen<'_> {
    /// Does all of it happen along one line?
    pub(super) fn is_direct(&self) -> bool {
        self.variant.scene.setting == Setting::Direct
    }

    /// Does a sphere strike a wall first, or is it alone?
    pub(super) fn is_alone(&self) -> bool {
        self.variant.scene.setting.is_of_one()
    }

    /// Impacts that are elastic or not at all, direct or oblique.
    pub(super) fn kind(&self, sentence: &Sentence, findings: &mut Vec<Finding>) {
        const TOGETHER: [&str; 4] = ["coalesce", "coalesces", "coalesced", "inelastic"];
        let scene = &self.question.scene;
        let given = scene.e.as_ref().and_then(|e| read(e, Angles::Degrees).ok());
        let is_open = given.as_ref().is_none_or(|e| e.names().iter().any(|name| scene.unknowns.contains(&name.text)));
        for (place, token) in sentence.iter().enumerate() {
            let is_perfectly = place > 0 && is_one_of(&sentence[place - 1], &["perfectly"]);
            let coefficient = match token {
                Token::Word(word) if word == "energy" && is_kept(sentence, place) => Value::ONE,
                Token::Word(word) if is_perfectly && ["elastic", "elastically"].contains(&word.as_str()) => Value::ONE,
                Token::Word(word) if word == "inelastic" && !is_perfectly => {
                    if given.as_ref().is_some_and(|e| self.number(e).is_some_and(|e| e.equals(&Value::ONE))) {
                        let message = "the words say `inelastic`, and in the scene e is 1".to_owned();
                        let help = "say `perfectly elastic`, or give another `e` in `[scene]`";
                        findings.push(self.finding(message, word, help));
                    }
                    continue;
                }
                Token::Word(word) if is_elastic(sentence, place) => {
                    let of = |quantity: &Quantity| self.known.number(*quantity)?.to_f64();
                    let all = self.known.0.keys().filter(|quantity| quantity.of_its_impact() == Quantity::Restitution);
                    let is_less = |quantity: &Quantity| of(quantity).is_some_and(|e| e < 1.0);
                    if !is_open && all.clone().count() > 0 && all.clone().all(is_less) {
                        let message = format!("the words say `{word}`, and in the scene e is less than 1");
                        let help = "leave the word out; or give 1 for `e` in `[scene]`, and say `perfectly elastic`";
                        findings.push(self.finding(message, word, help).as_warning());
                    }
                    continue;
                }
                _ if is_one_of(token, &TOGETHER) => Value::ZERO,
                _ => continue,
            };
            let all = self.known.0.keys().filter(|quantity| quantity.of_its_impact() == Quantity::Restitution);
            let all: Vec<Value> = all.filter_map(|quantity| self.known.number(*quantity)).collect();
            if !is_open && !all.is_empty() && !all.iter().any(|e| e.equals(&coefficient)) {
                let Token::Word(word) = token else { continue };
                let said = match word.as_str() {
                    "energy" => "no energy is lost".to_owned(),
                    word if is_perfectly => format!("perfectly {word}"),
                    word => word.to_owned(),
                };
                let e = print::unicode(&written(&all[0]));
                let wanted = print::unicode(&written(&coefficient));
                let message = format!("the words say `{said}`, for which e is {wanted}, and in the scene it is {e}");
                let at = if word == "energy" { word } else { &said };
                findings.push(self.finding(message, at, "give in `[scene]` the `e` that is said, or say another"));
            }
        }
        let says = |words: &[&str]| sentence.iter().find(|token| is_one_of(token, words));
        let is_across = || {
            let mut across = Sphere::BOTH.map(|sphere| Quantity::Velocity(sphere, Moment::Before, Axis::T)).into_iter();
            across.any(|across| self.known.number(across).is_some_and(|value| !value.is_zero()))
        };
        let wrong = match self.is_direct() {
            true => says(&["oblique", "obliquely"]),
            // `Moves directly towards *A*` tells of a path.
            false if scene.then.is_empty() && is_across() => sentence.iter().enumerate().find_map(|(place, token)| {
                let is_of_path = sentence.get(place + 1).is_some_and(|next| {
                    is_one_of(
                        next,
                        &["towards", "toward", "away", "along", "at", "from", "behind", "opposite", "above"],
                    )
                });
                let is_of_impact =
                    sentence.get(place + 1).is_some_and(|next| is_one_of(next, &["impact", "collision"]));
                let is_direct = is_one_of(token, &["directly"]) && !is_of_path;
                (is_direct || (is_of_impact && is_one_of(token, &["direct"]))).then_some(token)
            }),
            false => None,
        };
        if let Some(Token::Word(word)) = wrong {
            let other = if word.starts_with("direct") { "oblique" } else { "direct" };
            let message = format!("the words say `{word}`, and in the scene the impact is {other}");
            findings.push(self.finding(message, word, "say what it is, or give other velocities in `[scene]`"));
        }
    }

    /// A sphere that is said to move, or to move towards the other or away from it, before the impact.
    pub(super) fn moving(&self, sentence: &Sentence, findings: &mut Vec<Finding>) {
        for (place, token) in sentence.iter().enumerate() {
            // `*B* is not moving when *A* hits it`
            let is_denied = says(&sentence[place.saturating_sub(2)..place], &["not", "never"]);
            if !is_one_of(token, &["moving", "moves"]) || is_denied || moment(sentence, place) == Moment::After {
                continue;
            }
            let Some(sphere) = subject(&sentence[..place]) else { continue };
            let has = |quantity| self.known.number(self.first(sphere, quantity)?);
            if has(Quantity::Speed(sphere, Moment::Before)).is_some_and(|speed| speed.is_zero()) {
                let message =
                    format!("the words say that `*{}*` is moving, and in the scene it is at rest", sphere.name());
                let at = match &sentence[place..] {
                    [Token::Word(moving), Token::Word(next), ..] => format!("{moving} {next}"),
                    [Token::Word(moving), ..] => moving.clone(),
                    _ => String::new(),
                };
                findings.push(self.finding(message, &at, "say that it is at rest, or give it a velocity in `[scene]`"));
            }
            let (way, sense) = match &sentence[place + 1..] {
                [Token::Word(to), Token::Word(it), ..] if to == "towards" && it == "it" => ("towards", 1.0),
                [Token::Word(away), Token::Word(_), Token::Word(it), ..] if away == "away" && it == "it" => {
                    ("away from", -1.0)
                }
                _ => continue,
            };
            let ahead = if sphere == Sphere::A { sense } else { -sense };
            let along = has(Quantity::Velocity(sphere, Moment::Before, Axis::N)).and_then(|along| along.sign());
            let is_with = |sign: Ordering| if ahead > 0.0 { sign.is_lt() } else { sign.is_gt() };
            if sphere != Sphere::C && along.is_some_and(is_with) {
                let message =
                    format!("the words say that `*{}*` moves {way} the other, and it does not", sphere.name());
                let help = "turn its velocity round in `[scene]`, or say which way it is";
                findings.push(self.finding(message, &format!("{way} it"), help));
            }
        }
    }

    /// The direction of motion, or the path, of a sphere that is at rest before the impact.
    pub(super) fn direction_of_nothing(&self, sentence: &Sentence, findings: &mut Vec<Finding>) {
        const OF: [&str; 4] = ["direction", "directions", "path", "motion"];
        for (place, words) in sentence.windows(3).enumerate() {
            let [noun, of, Token::Sphere(sphere)] = words else { continue };
            let is_told = is_one_of(noun, &OF) && is_one_of(of, &["of"]) && moment(sentence, place) == Moment::Before;
            if is_told && is_at_rest(self.variant, *sphere) == Some(true) {
                let name = sphere.name();
                let message = format!("the words speak of the direction of `*{name}*`, which is at rest there");
                let help = "name the sphere that moves, or give this one a velocity in `[scene]`";
                let Token::Word(noun) = noun else { continue };
                findings.push(self.finding(message, &format!("{noun} of *{name}*"), help));
            }
        }
    }

    /// A sphere that is at rest, and of which the words do not say so.
    pub(super) fn resting(&self, sentences: &[Sentence], findings: &mut Vec<Finding>) {
        // A wall stands still, and nobody says so.
        let impacts = impacts(&self.question.scene);
        let is_there = |sphere: Sphere| impacts.iter().any(|impact| impact.has(sphere));
        let rests = |sphere: &Sphere| is_there(*sphere) && is_at_rest(self.variant, *sphere) == Some(true);
        let resting: Vec<Sphere> = Sphere::ALL.into_iter().filter(rests).collect();
        const LIES: [&str; 8] = ["lying", "lies", "standing", "stands", "sitting", "sits", "kept", "held"];
        let is_still = |pair: &[Token]| {
            (is_one_of(&pair[0], &["not"]) && is_one_of(&pair[1], &["moving", "move"]))
                || (is_one_of(&pair[0], &LIES) && is_one_of(&pair[1], &["still"]))
        };
        let tells = |words: &&Sentence| says(words, &RESTS) || words.windows(2).any(is_still);
        let said: Vec<&Sentence> = sentences.iter().filter(tells).collect();
        let is_of_all = said.iter().any(|words| says(words, &["both", "they", "others", "all", "each", "spheres"]));
        // `All three are at rest until *A* is projected`
        let are_all = |words: &&Sentence| {
            let begun = words.iter().take_while(|token| !is_one_of(token, &RESTS));
            begun.clone().all(|token| !matches!(token, Token::Sphere(_)))
                && begun.into_iter().any(|token| is_one_of(token, &["all", "both", "each", "they"]))
        };
        if said.iter().any(are_all) {
            return;
        }
        let is_said = |sphere: Sphere| {
            let is_named = said.iter().any(|words| words.contains(&Token::Sphere(sphere)));
            !said.is_empty() && (resting.len() == 1 || is_named)
        };
        for sphere in resting.iter().copied().filter(|sphere| !is_said(*sphere)) {
            let names_any = said.iter().flat_map(|words| words.iter()).any(|token| matches!(token, Token::Sphere(_)));
            if is_of_all && !names_any {
                continue;
            }
            let message = format!("the words do not say that `*{}*` is at rest", sphere.name());
            let help = "say that it is, or give it a velocity in `[scene]`";
            findings.push(self.finding(message, "stem", help).as_warning());
        }
    }
}

/// `An elastic collision`, `the impact is elastic`, `collide elastically`; spheres may be elastic with any e.
fn is_elastic(sentence: &[Token], place: usize) -> bool {
    const IMPACTS: [&str; 4] = ["collision", "collisions", "impact", "impacts"];
    let denied = says(&sentence[place.saturating_sub(2)..place], &["not", "perfectly", "partly", "partially"]);
    let next = sentence.get(place + 1).is_some_and(|next| is_one_of(next, &IMPACTS));
    let before = &sentence[..place];
    let is_said = matches!(before, [.., impact, is] if is_one_of(impact, &IMPACTS) && is_one_of(is, &["is", "are"]));
    let elastic = is_one_of(&sentence[place], &["elastic"]) && (next || is_said);
    !denied && (elastic || is_one_of(&sentence[place], &["elastically"]))
}

/// Do the words say that no energy is lost? Of its conservation a law of mechanics speaks too, but not of kinetic energy.
fn is_kept(sentence: &[Token], energy: usize) -> bool {
    let (before, after) = (&sentence[..energy], &sentence[energy + 1..]);
    let is_of_motion = before.last().is_some_and(|token| is_one_of(token, &["kinetic"]));
    let is_none = before.iter().rev().take(3).any(|token| is_one_of(token, &["no"]));
    let is_lost = after.iter().take(2).any(|token| is_one_of(token, &["lost"]));
    let is_conserved = after.iter().take(2).any(|token| is_one_of(token, &["conserved"]));
    is_of_motion && ((is_none && is_lost) || (is_conserved && !says(sentence, &["not", "if"])))
}

#[cfg(test)]
mod tests {
    use super::super::said_tests::assert_said;

    #[test]
    fn impacts_are_direct_and_elastic_and_spheres_at_rest_as_they_are_said_to_be() {
        let table = [
            (
                "direct/one-sphere-catches-the-other",
                "collide directly.",
                "coalesce.",
                "the words say `coalesce`, for which e is 0",
            ),
            (
                "direct/one-sphere-catches-the-other",
                "collide directly.",
                "collide obliquely.",
                "the words say `obliquely`",
            ),
            (
                "direct/one-sphere-catches-the-other",
                "collide directly.",
                "collide. The direction of *A* is not reversed.",
                "",
            ),
            (
                "both-moving/energy-lost-and-impulse",
                "collide.\n\nImm",
                "collide directly.\n\nImm",
                "the words say `directly`",
            ),
            (
                "deflection/elastic",
                "perfectly elastic",
                "perfectly inelastic",
                "for which e is 0, and in the scene it is 1",
            ),
            (
                "ranges/direction-reversed",
                "moving towards it",
                "moving away from it",
                "`*A*` moves away from the other",
            ),
            (
                "rest/speeds-and-directions",
                "which is at rest",
                "which is moving",
                "`*B*` is moving, and in the scene it is",
            ),
            ("deflection/elastic", "perfectly elastic", "inelastic", "say `inelastic`, and in the scene e is 1"),
            (
                "successive/three-in-a-line",
                "Spheres *B* and *C* are at rest",
                "Sphere *B* is at rest",
                "the words do not say that `*C*` is at rest",
            ),
            ("successive/three-in-a-line", "Spheres *B* and *C* are at rest", "The others are at rest", ""),
            (
                "successive/three-in-a-line",
                "Spheres *B* and *C* are at rest",
                "All three are at rest until *A* is projected",
                "",
            ),
            (
                "successive/three-in-a-line",
                "Spheres *B* and *C* are at rest",
                "Sphere *B* is at rest, as they all see",
                "the words do not say that `*C*` is at rest",
            ),
            (
                "rest/speeds-and-directions",
                ", which is at rest on the plane",
                " on the plane",
                "the words do not say that `*B*` is at rest",
            ),
            (
                "direct/one-sphere-catches-the-other",
                "collide directly.",
                "collide. No kinetic energy is lost.",
                "`no energy is lost`, for which e is 1",
            ),
            (
                "direct/one-sphere-catches-the-other",
                "collide directly.",
                "collide. Kinetic energy is not conserved.",
                "",
            ),
        ];
        assert_said(&table);
    }
}
