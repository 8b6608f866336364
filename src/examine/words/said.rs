//! Is what the words say what the scene has? Whose each mass and velocity is, and how walls and lines lie.

use super::sentence::{Noun, Sentence, Token, is_one_of, is_supposed, noun_of, owner_of, sentences};
use crate::bank::{Question, Style};
use crate::examine::Finding;
use crate::examine::remark::numbers;
use crate::expr::{Angles, Expr, Meaning, Text, evaluate, print, read, written};
use crate::generate::Variant;
use crate::mechanics::{Axis, Derivation, Known, Moment, Quantity, Sphere};
use crate::number::Value;
use crate::unit::Unit;

/// Every statement of the words that a variant contradicts.
pub fn contradicted(question: &Question, style: &Style, variant: &Variant) -> Vec<Finding> {
    let seen = Seen::new(question, style, variant);
    let stem = seen.stem().map(|text| (text, false));
    let asks = question.parts.iter().flat_map(|part| &part.ask).map(|text| (text, true));
    let mut findings = Vec::new();
    for (text, is_asked) in stem.chain(asks) {
        let mut is_later = is_asked;
        for sentence in sentences(text).into_iter().filter(|sentence| !is_supposed(sentence)) {
            let known = findings.len();
            seen.numbers(&sentence, &mut is_later, &mut findings);
            seen.parallel(&sentence, &mut findings);
            seen.equations(&sentence, &mut findings);
            seen.coefficients(&sentence, &mut findings);
            seen.kind(&sentence, &mut findings);
            seen.turned_back(&sentence, &mut findings);
            seen.rebounding(&sentence, &mut findings);
            seen.turned_through(&sentence, &mut findings);
            seen.radii(&sentence, &mut findings);
            seen.lengths(&sentence, &mut findings);
            seen.heavier(&sentence, &mut findings);
            seen.impulses(&sentence, &mut findings);
            seen.meeting_again(&sentence, &mut findings);
            seen.directed(&sentence, &mut findings);
            seen.same_way(&sentence, &mut findings);
            seen.growing(&sentence, &mut findings);
            seen.declared(&sentence, &mut findings);
            if !is_later {
                seen.moving(&sentence, &mut findings);
                seen.components(&sentence, &mut findings);
                seen.lines_of_motion(&sentence, &mut findings);
            }
            // What is said otherwise than it is has been told.
            if findings.len() == known {
                seen.constants(&sentence, &mut findings);
            }
        }
    }
    let stem: Vec<Sentence> = seen.stem().flat_map(sentences).collect();
    seen.resting(&stem, &mut findings);
    findings
}

/// A variant with all that follows from what is known of it.
pub(super) struct Seen<'v> {
    pub(super) question: &'v Question,
    pub(super) style: &'v Style,
    pub(super) variant: &'v Variant,
    pub(super) known: Known<Value>,
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

    /// The words before the first part.
    pub(super) fn stem(&self) -> impl Iterator<Item = &'v Text> + use<'v> {
        self.style.stem.iter().chain([&self.style.note])
    }

    /// What a formula of the words stands for; none where it has to be found.
    pub(super) fn meaning(&self, expr: &Expr) -> Option<Meaning> {
        let is_open = expr.names().iter().any(|name| self.question.scene.unknowns.contains(&name.text));
        let name = |name: &str| self.variant.givens.meaning(name);
        if is_open { None } else { evaluate(expr, &name).ok() }
    }

    pub(super) fn number(&self, expr: &Expr) -> Option<Value> {
        match self.meaning(expr)? {
            Meaning::Number(value) => Some(value),
            _ => None,
        }
    }

    /// A quantity of the impact in which the sphere takes part first.
    pub(super) fn first(&self, sphere: Sphere, quantity: Quantity) -> Option<Quantity> {
        let is_its_mass = |known: &&Quantity| known.of_its_impact() == Quantity::Mass(sphere);
        match self.known.0.keys().filter(is_its_mass).map(|mass| mass.impact()).min()? {
            0 => Some(quantity),
            impact => quantity.in_impact(impact),
        }
    }

    pub(super) fn finding(&self, message: String, at: &str, help: &str) -> Finding {
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
            let Token::Number(expr, _, lead) = token else { continue };
            let Some((noun, sphere)) = owner_of(sentence, place).or_else(|| self.only_owner(sentence, place)) else {
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
                Noun::Radius => "radius",
            };
            let (shown, sphere) = (print::plain(expr), sphere.name());
            let value = if said == shown { String::new() } else { format!(", {said},") };
            let message =
                format!("the words give `*{sphere}*` the {name} `{shown}`{value} where the scene gives it {other}");
            let help = format!("name in the words what `[scene]` has for `{sphere}`, or change it there");
            findings.push(self.finding(message, lead, &help));
        }
    }

    /// Where there is but one sphere, what is an angle is its angle.
    fn only_owner(&self, sentence: &Sentence, place: usize) -> Option<(Noun, Sphere)> {
        let is_only = self.is_alone() && self.question.scene.then.is_empty();
        match noun_of(sentence, place) {
            Some((_, Noun::Angle, false)) if is_only => Some((Noun::Angle, Sphere::A)),
            _ => None,
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
            Noun::Radius => differ(self.number(expr)?, self.radius(sphere)?),
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
            Noun::Angle => self.angle(sphere, moment, expr, after),
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
                    "wall" => {
                        if let (Some(Lies::Line), Some(is_parallel)) = (subject, is_parallel) {
                            self.line_beside_wall(is_parallel, nth, findings);
                        }
                        (subject, nth) = (Some(Lies::Wall(nth)), None);
                    }
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

    /// A line of centres that is parallel to a wall, or perpendicular to it.
    fn line_beside_wall(&self, is_parallel: bool, nth: Option<usize>, findings: &mut Vec<Finding>) {
        let (Some([x, y]), Some([p, q])) = (self.lies(Lies::Line), self.lies(Lies::Wall(nth))) else { return };
        let turned = if is_parallel { &(&x * &q) - &(&y * &p) } else { &(&x * &p) + &(&y * &q) };
        if !turned.is_zero() {
            let how = if is_parallel { "parallel" } else { "perpendicular" };
            let message = format!("the words say that the line of centres is {how} to the wall, and it is not");
            let help = "say how they lie in `[scene]`, or turn one of them there";
            findings.push(self.finding(message, &format!("{how} to the wall"), help));
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
}

impl Seen<'_> {
    fn radius(&self, sphere: Sphere) -> Option<Value> {
        let radii = &self.question.scene.radii;
        let radius = if sphere == Sphere::A { &radii.a } else { &radii.b };
        self.number(&read(radius.as_ref()?, Angles::Degrees).ok()?)
    }

    /// Radii that are said to be equal, or not to be. Spheres of which the scene has no radii meet as equal ones do.
    fn radii(&self, sentence: &Sentence, findings: &mut Vec<Finding>) {
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
        let beside = near.iter().find(|token| is_one_of(token, &OTHER) && !is_of_another);
        let (said, is_so) = match (is_said_equal, beside) {
            (true, _) => ("equal", are_equal),
            (false, Some(_)) => ("different", !are_equal),
            (false, None) => return,
        };
        if !is_so {
            let message = format!("the words say that the radii are {said}, and in the scene they are not");
            let Token::Word(radii) = &sentence[at] else { return };
            findings.push(self.finding(message, radii, "give in `[scene]` the `radii` that are said, or say others"));
        }
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

/// Words of what happens once the impact is over.
const AFTERWARDS: [&str; 6] = ["after", "afterwards", "rebounds", "rebounding", "leaves", "leaving"];

/// Is a number of a sentence of the time before the impact, or after it?
pub(super) fn moment(sentence: &[Token], place: usize) -> Moment {
    let told = |token: &Token| match token {
        Token::Word(word) if word == "before" => Some(Moment::Before),
        Token::Word(word) if AFTERWARDS.contains(&word.as_str()) => Some(Moment::After),
        _ => None,
    };
    let next = sentence[place + 1..].iter().take_while(|token| !matches!(token, Token::Number(..)));
    let before = sentence[..place].iter().rev().find_map(told);
    before.or_else(|| next.filter_map(told).next()).unwrap_or(Moment::Before)
}

#[cfg(test)]
mod tests {
    use super::super::truth;
    use super::*;
    use crate::examine::edited;
    use crate::generate::Deal;
    use crate::paper::words;

    /// What is said of the first variant of a shipped question after an edit.
    fn said(id: &str, from: &str, to: &str) -> String {
        let question = edited(id, &[(from, to)]);
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
            (catches, "in the same direction", "towards each other", "B moves towards A"),
            (catches, "in the same direction", "away from each other", "A moves away from B"),
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
            ("walls/rebound-speed-and-direction", "{alpha deg} with the wall", "{alpha deg} to the wall", ""),
            (
                "walls/rebound-speed-and-direction",
                "{alpha deg} with the wall",
                "{alpha deg} with the normal to the wall",
                "give `*A*` the angle `alpha`",
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
                "ranges/turned-back-by-an-oblique-impact",
                "{tan(alpha) = t}",
                "{sin(alpha) = t}",
                "give `*A*` the angle `alpha`",
            ),
            ("ranges/turned-back-by-an-oblique-impact", "{tan(alpha) = t}", "{sin(alpha) = t/sqrt(1 + t^2)}", ""),
            (
                "ranges/turned-through-more-than-a-right-angle",
                "angle {alpha} with the wall",
                "angle {alpha} with the normal to the wall",
                "give `*A*` the angle `alpha`",
            ),
            (
                "rest-letters/direction-and-deflection",
                "acute angle {alpha} with the line of centres",
                "acute angle {alpha} with the common tangent",
                "give `*A*` the angle `alpha`",
            ),
            (
                "rest/speeds-and-directions",
                "spheres is {e}.",
                "spheres is {e}, and {sin(alpha) = 5/7}.",
                "the words say that `sin(alpha) = 5/7`",
            ),
            (
                "rest/speeds-and-directions",
                "is {e}.",
                "is {e}. Sphere *A* rebounds.",
                "`*A*` rebounds, and it is not so",
            ),
            ("rest/speeds-and-directions", "have equal radii", "have different radii", "the radii are different"),
            (
                "rest/speeds-and-directions",
                "The spheres have equal radii",
                "The radius of *A* is twice that of *B*",
                "the radii are different",
            ),
            ("rest/speeds-and-directions", "have equal radii", "have equal radii, and one mass is twice the other", ""),
            (
                "rest/speeds-and-directions",
                "have equal radii",
                "have radius {5} and one has mass twice that of {4}",
                "",
            ),
            (
                "rest/speeds-and-directions",
                "is {e}.",
                "is {e}. The path of *A* is turned through an angle and then makes another of {60 deg} with it.",
                "the words give `60 deg`, and nothing in the scene has it",
            ),
            (
                "rest-letters/distance-from-the-centre-of-b",
                "B = \"r\" }",
                "B = \"2*r\" }",
                "give the radius `r`, where the scene gives it 2r",
            ),
            (
                "rest-letters/distance-from-the-centre-of-b",
                "impact_parameter = \"-d\"",
                "impact_parameter = \"-d/2\"",
                "give the distance `d`",
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
                "ranges/turned-back-by-an-oblique-impact",
                "directed away from *B*",
                "directed towards *B*",
                "`*A*` then moves towards *B*",
            ),
            (
                "successive/second-collision",
                "*B* collides with *A* again",
                "*B* does not collide with *A* again",
                "do not meet again, and with the conditions of the scene they meet",
            ),
            (
                "successive/no-more-collisions",
                "does not strike *B* again",
                "strikes *B* again",
                "meet again, and with the conditions of the scene they do not meet",
            ),
            (
                "successive/no-more-collisions",
                "second.B.after.n >= A.after.n",
                "A.after.n > second.B.after.n",
                "do not meet again",
            ),
            (
                "ranges/mass-ratio-that-can-be",
                "with speed {vA}.",
                "with speed {vA}. After it *A* moves in the opposite direction.",
                "`*A*` moves in the opposite direction, and it is not so",
            ),
            (
                catches,
                "collide directly.",
                "collide directly. The speed of *A* increases.",
                "say `increases` of the speed of `*A*`",
            ),
            (catches, "collide directly.", "collide directly. The speed of *B* is increased.", ""),
            (
                "direct/mass-from-the-velocities",
                "are moving towards each other",
                "are moving in the same direction",
                "A and B move in the same direction",
            ),
            (
                "both-moving/components-given",
                "{p m/s} perpendicular to the line",
                "{p m/s} parallel to the line",
                "give `*A*` the component `p` along the line of centres",
            ),
            (
                "both-moving/components-given",
                "A = [\"a\", \"p\"]",
                "A = [\"p\", \"a\"]",
                "give `*A*` the component `a` along",
            ),
            (
                "both-moving/paths-at-right-angles",
                "{uA} perpendicular to the line",
                "{uA} along the line",
                "`*A*` moves along the line of centres",
            ),
            (
                "both-moving/paths-at-right-angles",
                "centres, towards *A*",
                "centres, towards *B*",
                "have `*B*` move towards itself",
            ),
            (
                "successive/struck-onto-a-wall",
                "which is perpendicular to the wall",
                "which is parallel to the wall",
                "the line of centres is parallel to the wall",
            ),
            (
                "vector-impulse/velocity-after-an-impulse",
                "impulse = [\"p\", \"q\"]",
                "impulse = [\"-p\", \"-q\"]",
                "give the impulse `[p, q]`",
            ),
            ("deflection/elastic", "perfectly elastic", "inelastic", "say `inelastic`, and in the scene e is 1"),
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
            ("deflection/equal-masses", "{e < 1}", "{e > 1}", "say that `e > 1`, and the scene declares it `unit`"),
            ("vector-impulse/size-of-the-impulse", "is a positive constant", "is a negative constant", "k is negative"),
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
                "rest-letters/turned-through-a-right-angle",
                "turned through a right angle",
                "turned through an angle of {60 deg}",
                "`*A*` is turned through 60°",
            ),
            (
                "walls/turned-through-a-right-angle",
                "through a right angle",
                "by {60 deg}",
                "the words give `60 deg`, and nothing in the scene has it",
            ),
            (
                "walls/rebound-speed-and-direction",
                "is {e}.",
                "is {1 - e}.",
                "the coefficient of restitution `1 - e` where the scene gives it",
            ),
            (
                "successive/three-in-a-line",
                "*A* and *B* is {e}, and that between *B* and *C* is {f}",
                "*A* and *B* is {f}, and that between *B* and *C* is {e}",
                "the coefficient of restitution `f` where the scene gives it",
            ),
            (
                "successive/corner",
                "the first wall is {e}, and that between *A* and the second wall is {f}",
                "the second wall is {f}, and that between *A* and the first wall is {e}",
                "",
            ),
            (
                "successive/corner",
                "the first wall is {e}, and that between *A* and the second wall is {f}",
                "the first wall is {f}, and that between *A* and the second wall is {e}",
                "the coefficient of restitution `e` where the scene gives it",
            ),
            (
                "successive/three-in-a-line",
                "Spheres *B* and *C* are at rest",
                "Sphere *B* is at rest",
                "the words do not say that `*C*` is at rest",
            ),
            ("successive/three-in-a-line", "Spheres *B* and *C* are at rest", "The others are at rest", ""),
            (
                "rest/speeds-and-directions",
                ", which is at rest on the plane",
                " on the plane",
                "the words do not say that `*B*` is at rest",
            ),
            ("ranges/mass-ratio-when-a-goes-on", "is not changed", "is reversed", "the direction of `*A*` is reversed"),
        ];
        let mut wrong = Vec::new();
        for (id, from, to, words) in table {
            let said = said(id, from, to);
            if !said.contains(words) || said.is_empty() != words.is_empty() {
                wrong.push(format!("{id}: {to}: {said}"));
            }
        }
        assert!(wrong.is_empty(), "{wrong:#?}");
    }
}
