//! What the words say of how it happens: what is elastic, what is direct, who moves which way and who turns back.

use std::cmp::Ordering;

use super::impacts::impacts;
use super::said::{Seen, moment};
use super::sentence::{Sentence, Token, is_one_of, says, subject};
use super::truth::is_at_rest;
use crate::examine::Finding;
use crate::expr::{Angles, Relation, print, read, written};
use crate::mechanics::{Axis, Condition, Moment, Quantity, Setting, Sphere};
use crate::number::Value;
use crate::unit::Unit;

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
            false if scene.then.is_empty() && is_across() => says(&["directly"]),
            false => None,
        };
        if let Some(Token::Word(word)) = wrong {
            let other = if word == "directly" { "oblique" } else { "direct" };
            let message = format!("the words say `{word}`, and in the scene the impact is {other}");
            findings.push(self.finding(message, word, "say what it is, or give other velocities in `[scene]`"));
        }
    }

    /// A sphere that is said to move, or to move towards the other or away from it, before the impact.
    pub(super) fn moving(&self, sentence: &Sentence, findings: &mut Vec<Finding>) {
        for (place, token) in sentence.iter().enumerate() {
            if !is_one_of(token, &["moving", "moves"]) || moment(sentence, place) == Moment::After {
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
        let said: Vec<&Sentence> =
            sentences.iter().filter(|words| says(words, &["rest", "stationary", "motionless"])).collect();
        let is_of_all = said.iter().any(|words| says(words, &["both", "they", "others", "all", "each", "spheres"]));
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
            let help = "mend the `conditions` or velocities of `[scene]`, or say what happens";
            findings.push(self.finding(message, &format!("is {}{word}", if is_not { "not " } else { "" }), help));
        } else if is_back && self.may_come_to_rest(of) {
            let message = format!(
                "the words say that the direction of `*{}*` is {word}, and the condition lets it come to rest",
                of.name()
            );
            let help = "write `<` or `>` in `conditions`, in the place of `<=` or `>=`";
            findings.push(self.finding(message, &format!("is {word}"), help));
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
        let Some((dot, cross)) = self.products(sphere) else { return };
        let is_so = match (said == 90.0, dot.to_f64(), cross.to_f64()) {
            (is_right, ..) if is_right || dot.is_zero() => is_right && dot.is_zero(),
            (false, Some(dot), Some(cross)) => (cross.abs().atan2(dot).to_degrees() - said).abs() < 1e-6,
            _ => return,
        };
        if !is_so {
            let message =
                format!("the words say that `*{}*` is turned through {said}°, and it is not so", sphere.name());
            let said = sentence[at + 1..].iter().map_while(|token| match token {
                Token::Word(word) => Some(word.as_str()),
                _ => None,
            });
            let at = ["through"].into_iter().chain(said.take(3)).collect::<Vec<_>>().join(" ");
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

/// Do the words say that no energy is lost? Of its conservation a law of mechanics speaks too, but not of kinetic energy.
fn is_kept(sentence: &[Token], energy: usize) -> bool {
    let (before, after) = (&sentence[..energy], &sentence[energy + 1..]);
    let is_of_motion = before.last().is_some_and(|token| is_one_of(token, &["kinetic"]));
    let is_none = before.iter().rev().take(3).any(|token| is_one_of(token, &["no"]));
    let is_lost = after.iter().take(2).any(|token| is_one_of(token, &["lost"]));
    let is_conserved = after.iter().take(2).any(|token| is_one_of(token, &["conserved"]));
    is_of_motion && ((is_none && is_lost) || (is_conserved && !says(sentence, &["not", "if"])))
}
