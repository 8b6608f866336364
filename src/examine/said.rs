//! Is what the words say what the scene has? Whose each mass and velocity is, how walls and lines lie, what is elastic, and
//! who turns back.

use super::finding::Finding;
use super::sentence::{Noun, Sentence, Token, is_one_of, is_supposed, owner_of, sentences, subject};
use super::tally::numbers;
use crate::bank::{Question, Style};
use crate::expr::{Angles, Expr, Meaning, Relation, Turn, evaluate, print, read, written};
use crate::generate::Variant;
use crate::mechanics::{Axis, Derivation, Known, Moment, Quantity, Sphere, VelocityText};
use crate::number::{Angle, Value};
use crate::unit::Unit;

/// Every statement of the words that a variant contradicts.
pub fn contradicted(question: &Question, style: &Style, variant: &Variant) -> Vec<Finding> {
    let seen = Seen::new(question, style, variant);
    let stem = style.stem.iter().chain([&style.note]).map(|text| (text, false));
    let asks = question.parts.iter().flat_map(|part| &part.ask).map(|text| (text, true));
    let mut findings = Vec::new();
    for (text, is_asked) in stem.chain(asks) {
        let mut is_later = is_asked;
        for sentence in sentences(text).into_iter().filter(|sentence| !is_supposed(sentence)) {
            seen.numbers(&sentence, &mut is_later, &mut findings);
            seen.parallel(&sentence, &mut findings);
            seen.kind(&sentence, &mut findings);
            seen.turned_back(&sentence, &mut findings);
            if !is_later {
                seen.moving(&sentence, &mut findings);
            }
        }
    }
    findings
}

/// A variant with all that follows from what is known of it.
struct Seen<'v> {
    question: &'v Question,
    style: &'v Style,
    variant: &'v Variant,
    known: Known<Value>,
}

impl<'v> Seen<'v> {
    fn new(question: &'v Question, style: &'v Style, variant: &'v Variant) -> Seen<'v> {
        let mut known = variant.solution.known().clone();
        let mut asked = vec![Quantity::Restitution, Quantity::Line(Axis::X), Quantity::Line(Axis::Y)];
        for sphere in Sphere::BOTH {
            for moment in [Moment::Before, Moment::After] {
                let along = [Axis::X, Axis::Y, Axis::N, Axis::T].map(|axis| Quantity::Velocity(sphere, moment, axis));
                asked.extend(along);
                asked.extend([Quantity::Speed(sphere, moment), Quantity::AngleToLine(sphere, moment)]);
                asked.push(Quantity::AngleToWall(sphere, moment));
            }
        }
        Derivation::carry_out(&mut known, &asked);
        Seen { question, style, variant, known }
    }

    /// What a formula of the words stands for; none where it has to be found.
    fn meaning(&self, expr: &Expr) -> Option<Meaning> {
        let is_open = expr.names().iter().any(|name| self.question.scene.unknowns.contains(&name.text));
        let name = |name: &str| self.variant.givens.meaning(name);
        if is_open { None } else { evaluate(expr, &name).ok() }
    }

    fn number(&self, expr: &Expr) -> Option<Value> {
        match self.meaning(expr)? {
            Meaning::Number(value) => Some(value),
            _ => None,
        }
    }

    /// Does all of it happen along one line?
    fn is_direct(&self) -> bool {
        let scene = &self.question.scene;
        let given = [&scene.before.a, &scene.before.b, &scene.after.a, &scene.after.b].into_iter().flatten();
        given.into_iter().any(|velocity| matches!(velocity, VelocityText::Along(_)))
    }

    /// A quantity of the impact in which the sphere takes part first.
    fn first(&self, sphere: Sphere, quantity: Quantity) -> Option<Quantity> {
        let is_its_mass = |known: &&Quantity| known.of_its_impact() == Quantity::Mass(sphere);
        match self.known.0.keys().filter(is_its_mass).map(|mass| mass.impact()).min()? {
            0 => Some(quantity),
            impact => quantity.in_impact(impact),
        }
    }

    fn finding(&self, message: String, at: &str, help: &str) -> Finding {
        let example = self.variant.index.map(|index| format!(", with {}", numbers(self.style, index)));
        let message = format!("{message}{}", example.unwrap_or_default());
        let at = at.split_whitespace().collect::<Vec<_>>();
        let at = at[at.len().saturating_sub(8)..].join(" ");
        Finding::new(message, at, "the scene has it otherwise").with_help(help)
    }

    /// Masses, speeds, velocities and angles of spheres that are named.
    fn numbers(&self, sentence: &Sentence, is_later: &mut bool, findings: &mut Vec<Finding>) {
        for (place, token) in sentence.iter().enumerate() {
            *is_later |= is_one_of(token, &["later", "then", "second", "subsequently", "after"]);
            let (Token::Number(expr, _, lead), Some((noun, sphere))) = (token, owner_of(sentence, place)) else {
                continue;
            };
            // What has gone before an impact that comes later is not asked.
            if noun != Noun::Mass && *is_later && !self.question.scene.then.is_empty() {
                continue;
            }
            let moment = moment(sentence, place);
            let Some((said, other)) = self.compared(noun, sphere, moment, expr, &sentence[place + 1..]) else {
                continue;
            };
            let name = match noun {
                Noun::Mass => "mass",
                Noun::Speed => "speed",
                Noun::Velocity => "velocity",
                Noun::Angle => "angle",
            };
            let (shown, sphere) = (print::plain(expr), sphere.name());
            let value = if said == shown { String::new() } else { format!(", {said},") };
            let message =
                format!("the words give `*{sphere}*` the {name} `{shown}`{value} where the scene gives it {other}");
            let help = format!("name in the words what `[scene]` has for `{sphere}`, or change it there");
            findings.push(self.finding(message, lead, &help));
        }
    }

    /// What is said of a sphere and what it has, where the two differ.
    fn compared(
        &self,
        noun: Noun,
        sphere: Sphere,
        moment: Moment,
        expr: &Expr,
        after: &[Token],
    ) -> Option<(String, String)> {
        let scene = |quantity| self.known.number(self.first(sphere, quantity)?);
        let shown = |value: &Value| print::unicode(&written(value));
        let differ = |said: Value, has: Value| (!said.equals(&has)).then(|| (shown(&said), shown(&has)));
        match noun {
            Noun::Mass => differ(self.number(expr)?, scene(Quantity::Mass(sphere))?),
            Noun::Speed => {
                let (said, has) = (self.number(expr)?, scene(Quantity::Speed(sphere, moment))?);
                if (&said * &said).equals(&(&has * &has)) { None } else { differ(said, has) }
            }
            Noun::Velocity => {
                let Meaning::Vector(x, y) = self.meaning(expr)? else { return None };
                let [i, j] = [Axis::X, Axis::Y].map(|axis| scene(Quantity::Velocity(sphere, moment, axis)));
                let (i, j) = (i?, j?);
                let vector =
                    |x: &Value, y: &Value| print::unicode(&Expr::Vector(Box::new(written(x)), Box::new(written(y))));
                (!(x.equals(&i) && y.equals(&j))).then(|| (vector(&x, &y), vector(&i, &j)))
            }
            Noun::Angle => {
                let with = |words: &[&str]| after.iter().take(8).any(|token| is_one_of(token, words));
                let quantity = match (with(&["centres"]), with(&["wall"])) {
                    (true, _) => Quantity::AngleToLine(sphere, moment),
                    (false, true) => Quantity::AngleToWall(sphere, moment),
                    _ => return None,
                };
                let (y, x) = self.known.direction(self.first(sphere, quantity)?)?;
                let said = match self.meaning(expr)? {
                    Meaning::Number(value) => value.to_f64()?,
                    Meaning::Angle(turn) | Meaning::Degrees(turn) => degrees(&turn)?,
                    _ => return None,
                };
                let has = degrees(&Turn::of(Angle::of(&y, &x)?))?;
                let is_apart = (said - has).abs() > 1e-6 && said < 90.0;
                is_apart.then(|| (format!("{said:.4}"), format!("{has:.4}")))
            }
        }
    }

    /// Walls and lines of centres that are parallel to a vector, or perpendicular to it.
    fn parallel(&self, sentence: &Sentence, findings: &mut Vec<Finding>) {
        let (mut subject, mut nth, mut is_parallel) = (None, None, None);
        for (place, token) in sentence.iter().enumerate() {
            match token {
                Token::Word(word) => match word.as_str() {
                    "first" | "second" | "third" => {
                        nth = ["first", "second", "third"].iter().position(|ordinal| ordinal == word);
                        // `The first wall is parallel to i and the second to j.`
                        if let (Some(Lies::Wall(_)), Some(_)) = (subject, is_parallel) {
                            subject = Some(Lies::Wall(nth));
                        }
                    }
                    "wall" => (subject, nth) = (Some(Lies::Wall(nth)), None),
                    "centres" => subject = Some(Lies::Line),
                    "parallel" | "along" => is_parallel = Some(true),
                    "perpendicular" | "normal" => is_parallel = Some(false),
                    "walls" | "velocity" | "component" | "components" | "plane" | "path" | "direction" | "impulse"
                    | "speed" | "moving" | "moves" => (subject, is_parallel) = (None, None),
                    _ => {}
                },
                Token::Number(expr, Unit::None, lead) => {
                    let leads = place.checked_sub(1).map(|before| &sentence[before]);
                    let is_to = leads.is_some_and(|token| is_one_of(token, &["to", "vector", "along"]));
                    let (Some(Meaning::Vector(x, y)), Some(lies), Some(is_parallel), true) =
                        (self.meaning(expr), subject, is_parallel, is_to)
                    else {
                        continue;
                    };
                    let Some([p, q]) = self.lies(lies) else { continue };
                    let turned = if is_parallel { &(&x * &q) - &(&y * &p) } else { &(&x * &p) + &(&y * &q) };
                    if !turned.is_zero() {
                        let what = if lies == Lies::Line { "line of centres" } else { "wall" };
                        let how = if is_parallel { "parallel" } else { "perpendicular" };
                        let shown = print::unicode(expr);
                        let message = format!("the words say that the {what} is {how} to {shown}, and it is not");
                        let help = format!("say what `[scene]` has for the {what}, or turn it there");
                        findings.push(self.finding(message, lead, &help));
                    }
                }
                _ => {}
            }
        }
    }

    /// How a wall or the line of centres lies.
    fn lies(&self, what: Lies) -> Option<[Value; 2]> {
        let scene = &self.question.scene;
        match what {
            Lies::Line if scene.then.iter().any(|then| then.line_of_centres.is_some()) => None,
            Lies::Line if scene.wall.is_some() => None,
            Lies::Line => {
                let [x, y] = [Axis::X, Axis::Y].map(|axis| self.known.number(Quantity::Line(axis)));
                Some([x?, y?])
            }
            Lies::Wall(nth) => {
                let walls: Vec<_> =
                    scene.wall.iter().chain(scene.then.iter().filter_map(|then| then.wall.as_ref())).collect();
                let wall = match (walls.as_slice(), nth) {
                    ([one], None) => one,
                    (several, nth) => several.get(nth?)?,
                };
                let [x, y] = [0, 1].map(|at| self.number(&read(&wall[at], Angles::Degrees).ok()?));
                Some([x?, y?])
            }
        }
    }

    /// Impacts that are elastic or not at all, direct or oblique.
    fn kind(&self, sentence: &Sentence, findings: &mut Vec<Finding>) {
        const TOGETHER: [&str; 4] = ["coalesce", "coalesces", "coalesced", "inelastic"];
        let scene = &self.question.scene;
        let given = scene.e.as_ref().and_then(|e| read(e, Angles::Degrees).ok());
        let is_open = given.is_none_or(|e| e.names().iter().any(|name| scene.unknowns.contains(&name.text)));
        for (place, token) in sentence.iter().enumerate() {
            let is_perfectly = place > 0 && is_one_of(&sentence[place - 1], &["perfectly"]);
            let coefficient = match token {
                Token::Word(word) if is_perfectly && ["elastic", "elastically"].contains(&word.as_str()) => Value::ONE,
                Token::Word(word) if word == "inelastic" && !is_perfectly => continue,
                _ if is_one_of(token, &TOGETHER) => Value::ZERO,
                _ => continue,
            };
            let all = self.known.0.keys().filter(|quantity| quantity.of_its_impact() == Quantity::Restitution);
            let all: Vec<Value> = all.filter_map(|quantity| self.known.number(*quantity)).collect();
            if !is_open && !all.is_empty() && !all.iter().any(|e| e.equals(&coefficient)) {
                let Token::Word(word) = token else { continue };
                let said = if is_perfectly { format!("perfectly {word}") } else { word.clone() };
                let e = print::unicode(&written(&all[0]));
                let wanted = print::unicode(&written(&coefficient));
                let message = format!("the words say `{said}`, for which e is {wanted}, and in the scene it is {e}");
                findings.push(self.finding(message, &said, "give in `[scene]` the `e` that is said, or say another"));
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
    fn moving(&self, sentence: &Sentence, findings: &mut Vec<Finding>) {
        for (place, token) in sentence.iter().enumerate() {
            if !is_one_of(token, &["moving", "moves"]) || moment(sentence, place) == Moment::After {
                continue;
            }
            let Some(sphere) = subject(&sentence[..place]) else { continue };
            let has = |quantity| self.known.number(self.first(sphere, quantity)?);
            if has(Quantity::Speed(sphere, Moment::Before)).is_some_and(|speed| speed.is_zero()) {
                let message =
                    format!("the words say that `*{}*` is moving, and in the scene it is at rest", sphere.name());
                let at = sentence.get(place + 1).map_or("is moving".to_owned(), |next| match next {
                    Token::Word(next) => format!("moving {next}"),
                    _ => "moving".to_owned(),
                });
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
            let is_with = |sign: std::cmp::Ordering| if ahead > 0.0 { sign.is_lt() } else { sign.is_gt() };
            if sphere != Sphere::C && along.is_some_and(is_with) {
                let message =
                    format!("the words say that `*{}*` moves {way} the other, and it does not", sphere.name());
                let help = "turn its velocity round in `[scene]`, or say which way it is";
                findings.push(self.finding(message, &format!("{way} it"), help));
            }
        }
    }

    /// A sphere whose direction is said to be reversed, or not to change, in a direct impact.
    fn turned_back(&self, sentence: &Sentence, findings: &mut Vec<Finding>) {
        if !self.is_direct() || !self.question.scene.then.is_empty() {
            return;
        }
        let Some(at) = sentence.iter().position(|token| is_one_of(token, &["direction"])) else { return };
        let sphere = |token: &Token| if let Token::Sphere(sphere) = token { Some(*sphere) } else { None };
        let verb = ["reversed", "unchanged", "changed"];
        let Some(end) = sentence[at..].iter().position(|token| is_one_of(token, &verb)).map(|end| at + end) else {
            return;
        };
        let is_not = sentence[at..end].iter().any(|token| is_one_of(token, &["not"]));
        let is_back = is_one_of(&sentence[end], &["reversed"]) != is_not;
        if is_one_of(&sentence[end], &["changed"]) && !is_not {
            return;
        }
        let is_back = is_back && !is_one_of(&sentence[end], &["unchanged", "changed"]);
        let of: Vec<Sphere> = sentence[at..end].iter().filter_map(sphere).collect();
        let [of] = of.as_slice() else { return };
        let along = |moment| self.known.number(Quantity::Velocity(*of, moment, Axis::N))?.sign();
        let Some(before) = along(Moment::Before) else { return };
        let Some(after) = along(Moment::After).or_else(|| self.required(*of)) else { return };
        // What is at rest before or after has not turned back.
        let is_turned = before.is_ne() && before == after.reverse();
        if is_turned != is_back {
            let said = if is_back { "reversed" } else { "not changed" };
            let message = format!("the words say that the direction of `*{}*` is {said}, and it is not so", of.name());
            let Token::Word(word) = &sentence[end] else { return };
            let help = "mend the `conditions` or velocities of `[scene]`, or say what happens";
            findings.push(self.finding(message, &format!("is {}{word}", if is_not { "not " } else { "" }), help));
        }
    }

    /// The sign that a condition gives to the velocity of a sphere afterwards.
    fn required(&self, sphere: Sphere) -> Option<std::cmp::Ordering> {
        let after = [Axis::X, Axis::N].map(|axis| Quantity::Velocity(sphere, Moment::After, axis).to_string());
        self.question.scene.conditions.iter().find_map(|condition| match read(condition, Angles::Degrees).ok()? {
            Expr::Relation(left, relation, right) if after.contains(&print::plain(&left)) && right.is_zero() => {
                match relation {
                    Relation::Less | Relation::LessOrEqual => Some(std::cmp::Ordering::Less),
                    Relation::Greater | Relation::GreaterOrEqual => Some(std::cmp::Ordering::Greater),
                    _ => None,
                }
            }
            _ => None,
        })
    }
}

/// What lies in a direction.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Lies {
    /// The line of centres.
    Line,
    /// A wall, or which of several.
    Wall(Option<usize>),
}

fn degrees(turn: &Turn) -> Option<f64> {
    turn.enclose(64).map(|degrees| degrees.to_f64())
}

/// Is a number of a sentence of the time before the impact, or after it?
fn moment(sentence: &[Token], place: usize) -> Moment {
    let told = |token: &Token| match token {
        Token::Word(word) if word == "before" => Some(Moment::Before),
        Token::Word(word) if ["after", "afterwards"].contains(&word.as_str()) => Some(Moment::After),
        _ => None,
    };
    let next = sentence[place + 1..].iter().take_while(|token| !matches!(token, Token::Number(..)));
    let before = sentence[..place].iter().rev().find_map(told);
    before.or_else(|| next.filter_map(told).next()).unwrap_or(Moment::Before)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::bank::{read_question, shipped};
    use crate::diagnostic::Source;
    use crate::examine::truth;
    use crate::generate::Deal;
    use crate::paper::words;

    /// What is said of the first variant of a shipped question after an edit.
    fn said(id: &str, from: &str, to: &str) -> String {
        let (_, text) = shipped().find(|(shipped, _)| *shipped == id).unwrap();
        assert!(text.contains(from), "{id}: {from}");
        let text = text.replace(from, to);
        let question = read_question(id, &Source::new(id, text)).unwrap_or_else(|faults| panic!("{faults:?}"));
        let style = &question.styles[0];
        let variant = Deal::new(&question, style, 1).next().unwrap();
        let mut remarks = Vec::new();
        truth::untrue(&words(&question, style, &variant), &variant, &mut remarks);
        let found = contradicted(&question, style, &variant);
        found
            .into_iter()
            .map(|finding| finding.message)
            .chain(remarks.iter().map(|remark| format!("{remark:?}")))
            .collect()
    }

    #[test]
    fn words_that_the_scene_contradicts_are_found() {
        let catches = "direct/one-sphere-catches-the-other";
        let moving = "both-moving/energy-lost-and-impulse";
        let table = [
            (catches, "*B* is {w m/s}", "*B* is {w m/s}", ""),
            (catches, "{mA kg} and {mB kg}", "{mB kg} and {mA kg}", "give `*A*` the mass `mB`"),
            (catches, "is {u m/s} and", "is {2*u m/s} and", "give `*A*` the speed `2*u`"),
            (catches, "in the same direction", "in opposite directions", "A and B move in opposite directions"),
            (catches, "in the same direction", "towards each other", "B moves towards each other"),
            (catches, "in the same direction", "away from each other", "A moves away from each other"),
            (catches, "collide directly.", "coalesce.", "the words say `coalesce`, for which e is 0"),
            (catches, "collide directly.", "collide obliquely.", "the words say `obliquely`"),
            (catches, "collide directly.", "collide. The direction of *A* is not reversed.", ""),
            (
                catches,
                "collide directly.",
                "collide. The direction of *B* is reversed.",
                "direction of `*B*` is reversed",
            ),
            (moving, "collide.\n\nImm", "collide directly.\n\nImm", "the words say `directly`"),
            (moving, "acute angle of {alpha deg}", "acute angle of {beta deg}", "give `*A*` the angle `beta`"),
            (moving, "moving towards the other", "moving in the same direction", "A and B move in the same direction"),
            ("both-moving/components-given", "centres, towards *A*", "centres, away from *A*", "B moves away from A"),
            (
                "deflection/elastic",
                "perfectly elastic",
                "perfectly inelastic",
                "for which e is 0, and in the scene it is 1",
            ),
            (
                "walls/velocity-in-i-and-j",
                "wall is parallel to {i}",
                "wall is parallel to {j}",
                "the wall is parallel to j",
            ),
            ("walls/velocity-in-i-and-j", "wall is parallel to {i}", "wall is perpendicular to {j}", ""),
            ("successive/corner", "and the second to {j}", "and the second to {i}", "the wall is parallel to i"),
            (
                "i-j/energy-lost",
                "is parallel to {i}",
                "is perpendicular to {i}",
                "line of centres is perpendicular to i",
            ),
            ("i-j/energy-lost", "{[bx, by] m/s}", "{[by, bx] m/s}", "give `*B*` the velocity"),
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
            ("ranges/mass-ratio-when-a-goes-on", "is not changed", "is reversed", "the direction of `*A*` is reversed"),
        ];
        for (id, from, to, words) in table {
            let said = said(id, from, to);
            assert!(said.contains(words) && said.is_empty() == words.is_empty(), "{id}: {to}: {said}");
        }
    }
}
