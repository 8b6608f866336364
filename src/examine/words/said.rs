//! Is what the words say what the scene has? Whose each mass and velocity is, and how walls and lines lie.

use super::in_turn::{lines_of_row, named_in_turn, of_them};
use super::said_of_walls::STRUCK;
use super::sentence::{Noun, Sentence, Token, is_one_of, is_supposed, noun_of, owner_of, says, sentences, subject};
use crate::bank::{Answer, Question, Style};
use crate::examine::Finding;
use crate::examine::remark::numbers;
use crate::expr::{Angles, Expr, Meaning, Text, evaluate, print, read, written};
use crate::generate::Variant;
use crate::mechanics::{Axis, Derivation, Known, Moment, Quantity, Sphere};
use crate::number::Value;

/// Every statement of the words that a variant contradicts.
pub fn contradicted(question: &Question, style: &Style, variant: &Variant) -> Vec<Finding> {
    let seen = Seen::new(question, style, variant);
    let stem = seen.stem().map(|text| (text, false));
    let asks = question.parts.iter().flat_map(|part| &part.ask).map(|text| (text, true));
    let mut findings = Vec::new();
    for (text, is_asked) in stem.chain(asks) {
        let (mut is_later, mut is_struck, mut before, mut them) = (is_asked, is_asked, None, Vec::new());
        for sentence in sentences(text).into_iter().filter(|sentence| !is_supposed(sentence)) {
            let known = findings.len();
            seen.numbers(&sentence, (before, &them, is_struck), &mut is_later, &mut findings);
            them = named_in_turn(&sentence, them);
            before = only_subject(&sentence).or(before.filter(|_| speaks_of_it(&sentence)));
            seen.parallel(&sentence, &mut findings);
            seen.equations(&sentence, &mut findings);
            seen.walls(&sentence, &mut findings);
            seen.coefficients(&sentence, &mut findings);
            seen.collisions(&sentence, &mut findings);
            seen.kind(&sentence, &mut findings);
            seen.turned_back(&sentence, &mut findings);
            seen.rebounding(&sentence, &mut findings);
            seen.turned_through(&sentence, &mut findings);
            seen.radii(&sentence, &mut findings);
            seen.lengths(&sentence, &mut findings);
            seen.centres(&sentence, &mut findings);
            seen.equal_masses(&sentence, &mut findings);
            seen.heavier(&sentence, &mut findings);
            seen.greater_mass(&sentence, &mut findings);
            seen.order(&sentence, &mut findings);
            seen.speed_of_a_vector(&sentence, &mut findings);
            seen.velocity_without_direction(&sentence, &mut findings);
            seen.impulses(&sentence, &mut findings);
            seen.meeting_again(&sentence, &mut findings);
            seen.met_before(&sentence, &mut findings);
            seen.directed(&sentence, &mut findings);
            seen.positive(&sentence, &mut findings);
            seen.same_way(&sentence, &mut findings);
            seen.old_way(&sentence, &mut findings);
            seen.towards_itself(&sentence, &mut findings);
            seen.sides(&sentence, &mut findings);
            seen.lines_of_motion(&sentence, is_later, &mut findings);
            seen.perpendicular_paths(&sentence, is_later, &mut findings);
            seen.across(&sentence, &mut findings);
            seen.about_a_wall(&sentence, is_struck, &mut findings);
            seen.nearer_to_a_wall(&sentence, &mut findings);
            seen.striking(&sentence, is_struck, &mut findings);
            seen.squarely(&sentence, &mut findings);
            is_struck |= says(&sentence, &STRUCK);
            seen.growing(&sentence, &mut findings);
            seen.limited(&sentence, &mut findings);
            seen.shares(&sentence, &mut findings);
            seen.brought_to_rest(&sentence, &mut findings);
            seen.resting_when_struck(&sentence, &mut findings);
            seen.described_at_rest(&sentence, &mut findings);
            seen.declared(&sentence, &mut findings);
            if !is_later {
                seen.moving(&sentence, &mut findings);
                seen.direction_of_nothing(&sentence, &mut findings);
                seen.components(&sentence, &mut findings);
            }
            // What is said otherwise than it is has been told.
            if findings.len() == known {
                seen.constants(&sentence, &mut findings);
            }
        }
    }
    let stem: Vec<Sentence> = seen.stem().flat_map(sentences).collect();
    seen.resting(&stem, &mut findings);
    seen.struck_first(&stem, &mut findings);
    seen.letters_unsaid(&mut findings);
    seen.titled(&mut findings);
    seen.results(&mut findings);
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

    /// Masses, speeds, velocities and angles of spheres that are named, of `them` in turn, or of `it`: the sphere of which alone
    /// the sentence before has spoken. Has something been struck in the sentences before, what happens `then` comes after that.
    fn numbers(
        &self,
        sentence: &Sentence,
        (before, them, is_struck): (Option<Sphere>, &[Sphere], bool),
        is_later: &mut bool,
        findings: &mut Vec<Finding>,
    ) {
        for (place, token) in sentence.iter().enumerate() {
            // `The first wall is parallel to {i} and the second to {j}` tells of no impact.
            let is_told = !is_one_of(token, &["second"]) || says(sentence, &STRUCK);
            *is_later |= is_told && is_one_of(token, &["later", "then", "second", "subsequently", "after"]);
            let Token::Number(expr, _, lead) = token else { continue };
            let owner = owner_of(sentence, place).or_else(|| self.only_owner(sentence, place));
            let owner = owner.or_else(|| of_them(sentence, place, them));
            let Some((noun, sphere)) = owner.or_else(|| of_it(sentence, place, before?)) else { continue };
            // What has gone before an impact that comes later is not asked.
            if noun != Noun::Mass && *is_later && !self.question.scene.then.is_empty() {
                continue;
            }
            let moment = match told(sentence, place) {
                None if is_struck && then_moves(&sentence[..place]) => Moment::After,
                _ => moment(sentence, place),
            };
            if noun == Noun::Speed && self.is_to_be_shown(expr, sphere) {
                continue;
            }
            let Some((said, other)) = self.compared(noun, sphere, moment, expr, lines_of_row(sentence, place)) else {
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
            findings.push(self.finding(message, &format!("{lead}{{{shown}"), &help));
        }
    }

    /// Is it the letter that a part shows to be the speed of a sphere?
    fn is_to_be_shown(&self, expr: &Expr, sphere: Sphere) -> bool {
        let is_its = |quantity: &Quantity| quantity.of_its_impact().sphere() == Some(sphere);
        let shows = |answer: &Answer| answer.show.as_ref() == Some(expr) && answer.find.quantities().iter().any(is_its);
        self.question.parts.iter().flat_map(|part| &part.answers).any(shows)
    }

    /// Where there is but one sphere, what is an angle is its angle, and `its` velocity no other's.
    fn only_owner(&self, sentence: &Sentence, place: usize) -> Option<(Noun, Sphere)> {
        let is_only = self.is_alone() && self.question.scene.then.is_empty();
        match noun_of(sentence, place) {
            Some((_, Noun::Angle, false)) if is_only => Some((Noun::Angle, Sphere::A)),
            Some((at, noun @ (Noun::Speed | Noun::Velocity), false)) if is_only && at > 0 => {
                is_one_of(&sentence[at - 1], &["its"]).then_some((noun, Sphere::A))
            }
            _ => None,
        }
    }

    /// What a text of the scene and a formula of the words come to while what is to be found has no value: `k*m` and `k`.
    /// None where neither has a letter that is to be found, and the values tell more.
    pub(super) fn while_open(&self, scene: Option<&String>, expr: &Expr) -> Option<(Value, Value)> {
        let scene = read(scene?, Angles::Degrees).ok()?;
        let is_open = |expr: &Expr| expr.names().iter().any(|name| self.question.scene.unknowns.contains(&name.text));
        let value = |expr: &Expr| match evaluate(expr, &|name| self.variant.givens.meaning(name)) {
            Ok(Meaning::Number(value)) => Some(value),
            _ => None,
        };
        if is_open(&scene) || is_open(expr) { Some((value(expr)?, value(&scene)?)) } else { None }
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
            Noun::Mass => {
                let masses = &self.question.scene.masses;
                let given = [(Sphere::A, &masses.a), (Sphere::B, &masses.b)].into_iter().find(|(of, _)| *of == sphere);
                match self.while_open(given.and_then(|(_, mass)| mass.as_ref()), expr) {
                    Some((said, has)) => differ(said, has),
                    None => differ(self.number(expr)?, scene(Quantity::Mass(sphere))?),
                }
            }
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
}

/// The sphere that a sentence is about, if it names no other.
pub(super) fn only_subject(sentence: &[Token]) -> Option<Sphere> {
    let is_another = |own: Sphere| sentence.iter().any(|token| matches!(token, Token::Sphere(other) if *other != own));
    // `The line of centres of the spheres` comes after what it is about.
    let last = sentence.iter().rposition(|token| matches!(token, Token::Sphere(_)))?;
    subject(&sentence[..=last]).filter(|own| !is_another(*own))
}

/// Does a sentence name no sphere, and speak of `it`?
fn speaks_of_it(sentence: &[Token]) -> bool {
    let names_any = sentence.iter().any(|token| matches!(token, Token::Sphere(_)));
    !names_any && says(sentence, &["it", "its"])
}

/// What a number is of that belongs to `it`, named in the sentence before.
fn of_it(sentence: &[Token], place: usize, it: Sphere) -> Option<(Noun, Sphere)> {
    let (at, noun, is_plural) = noun_of(sentence, place)?;
    (is_of_motion(sentence, place) && !is_plural && speaks_of_it(&sentence[..at])).then_some((noun, it))
}

/// Words of what happens once the impact is over.
const AFTERWARDS: [&str; 8] =
    ["after", "afterwards", "result", "rebounds", "rebound", "rebounding", "leaves", "leaving"];

/// Words of motion that go before `off`.
const MOVES: [&str; 5] = ["moves", "move", "moving", "goes", "going"];

/// `*A* then moves with speed {v}`
fn then_moves(before: &[Token]) -> bool {
    let moves = |token: &Token| is_one_of(token, &MOVES) || is_one_of(token, &["has", "travels", "travelling"]);
    let is_said = |pair: &[Token]| {
        (is_one_of(&pair[0], &["then", "now"]) && moves(&pair[1]))
            || (is_one_of(&pair[1], &["then"]) && is_one_of(&pair[0], &["is"]))
    };
    before.windows(2).any(is_said)
}

/// Words of an impact that comes next.
const MEETS: [&str; 6] = ["strikes", "strike", "hits", "collides", "collide", "meets"];

/// Is a number of a sentence of the time before the impact, or after it?
pub(super) fn moment(sentence: &[Token], place: usize) -> Moment {
    told(sentence, place).map_or(Moment::Before, |(_, moment)| moment)
}

/// The word that says of which time a number is, and that time: before the number, or after it in a sentence that has its
/// first so, `makes an angle {a} with the wall before the impact and an angle {b} after it`.
pub(super) fn told(sentence: &[Token], place: usize) -> Option<(usize, Moment)> {
    let next = || {
        // `Moving with velocity {v}, collides with the wall and rebounds`: what follows the impact is no word of the number.
        let ends = |token: &Token| matches!(token, Token::Number(..)) || is_one_of(token, &MEETS);
        let next = (place + 1..sentence.len()).take_while(|at| !ends(&sentence[*at]));
        next.filter_map(|at| time(sentence, at)).next().filter(|(at, _)| !leads_on(sentence, *at))
    };
    let is_of_motion = |at: &usize| matches!(sentence[*at], Token::Number(..)) && is_of_motion(sentence, *at);
    let first = (0..place).find(is_of_motion).unwrap_or(place);
    match told_before(sentence, first) {
        Some(_) => told_before(sentence, place),
        None => next().or_else(|| told_before(sentence, place)),
    }
}

/// Is a word of time, as in `and immediately after the hit its velocity is {v}`, of what comes next?
fn leads_on(sentence: &[Token], at: usize) -> bool {
    let lead = sentence[..at].iter().rev().find(|token| !is_one_of(token, &["immediately", "just", "shortly"]));
    let is_joined = lead.is_some_and(|lead| *lead == Token::Comma || is_one_of(lead, &["and"]));
    // `And afterwards hits the second wall`
    let is_of_next = sentence.get(at + 1).is_some_and(|next| is_one_of(next, &MEETS));
    let has_number =
        || (at..sentence.len()).any(|at| matches!(sentence[at], Token::Number(..)) && is_of_motion(sentence, at));
    // `And, after rebounding from it, hits the second wall`
    let is_ended = || sentence[at..].contains(&Token::Comma);
    let is_of_deed = matches!(sentence.get(at + 1), Some(Token::Word(deed)) if deed.ends_with("ing")) && is_ended();
    is_joined && (is_of_next || is_of_deed || has_number())
}

/// Is a number a speed, a velocity or an angle?
fn is_of_motion(sentence: &[Token], place: usize) -> bool {
    let noun = noun_of(sentence, place).map(|(_, noun, _)| noun);
    matches!(noun, Some(Noun::Speed | Noun::Velocity | Noun::Angle))
}

/// The same, by the words before it alone.
pub(super) fn told_before(sentence: &[Token], place: usize) -> Option<(usize, Moment)> {
    (0..place).rev().find_map(|at| time(sentence, at))
}

/// `Opposite to that in which it was moving`, `as the one it had`: so a comparison ends, and a time that follows is of it.
fn is_of_what_was(before: &[Token]) -> bool {
    let near = &before[before.len().saturating_sub(9)..];
    let is_led = |pair: &[Token]| {
        is_one_of(&pair[0], &["to", "as", "from", "than"]) && is_one_of(&pair[1], &["that", "the", "those"])
    };
    let Some(led) = near.windows(2).rposition(is_led) else { return false };
    let clause = &near[led + 2..];
    says(clause, &["was", "were", "had"])
        && !clause.iter().any(|token| matches!(token, Token::Comma | Token::Number(..)))
}

/// The time of which a word tells. `As before`, `than before` and `perpendicular to its direction before` tell of none.
fn time(sentence: &[Token], at: usize) -> Option<(usize, Moment)> {
    let is_beside = |[to, _, noun]: &[Token; 3]| {
        is_one_of(to, &["to"]) && is_one_of(noun, &["direction", "motion", "path", "velocity"])
    };
    let is_compared = at > 0 && is_one_of(&sentence[at - 1], &["as", "than", "to"])
        || sentence[..at].last_chunk::<3>().is_some_and(is_beside)
        || is_of_what_was(&sentence[..at]);
    match &sentence[at] {
        Token::Word(word) if word == "before" && !is_compared => Some((at, Moment::Before)),
        Token::Word(word) if AFTERWARDS.contains(&word.as_str()) => Some((at, Moment::After)),
        // `They collide, and *A* moves off with speed {v}`
        Token::Word(word) if word == "off" && at > 0 && is_one_of(&sentence[at - 1], &MOVES) => {
            Some((at, Moment::After))
        }
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::super::said_tests::assert_said;

    #[test]
    fn each_mass_speed_velocity_and_angle_is_that_of_its_sphere() {
        let table = [
            ("direct/one-sphere-catches-the-other", "*B* is {w m/s}", "*B* is {w m/s}", ""),
            (
                "direct/one-sphere-catches-the-other",
                "{mA kg} and {mB kg}",
                "{mB kg} and {mA kg}",
                "give `*A*` the mass `mB`",
            ),
            ("direct/one-sphere-catches-the-other", "is {u m/s} and", "is {2*u m/s} and", "give `*A*` the speed `2*u`"),
            (
                "direct/one-sphere-catches-the-other",
                "collide directly.",
                "collide directly, and *A* carries on in the same direction as before.",
                "",
            ),
            (
                "direct/one-sphere-catches-the-other",
                "collide directly.",
                "collide directly. As a result *A* moves on with speed {w m/s}.",
                "give `*A*` the speed `w`",
            ),
            (
                "vector-impulse/impulse-from-two-velocities",
                "struck by a stick. Immediately after it has been\nstruck its",
                "struck by a stick, and immediately after the hit its",
                "",
            ),
            (
                "vector-impulse/impulse-from-two-velocities",
                "struck by a stick. Immediately after it has been\nstruck its velocity is {[v, w] m/s}",
                "struck by a stick, and immediately after the hit its velocity is {[x, y] m/s}",
                "give `*A*` the velocity `[x, y]`",
            ),
            (
                "both-moving/paths-at-right-angles",
                "*B* is moving with speed {uB} along",
                "*B* is moving directly along",
                "",
            ),
            (
                "walls/restitution-from-two-angles",
                "Before the collision the path of *A* makes an acute angle {alpha} with the wall, where {tan(alpha) = before}. After \
             the collision\nits path makes an acute angle {beta} with the wall, where {tan(beta) = after}.",
                "The path of *A* makes an acute angle {alpha} with the wall before the collision and an acute angle {beta} with \
             the wall after it, where {tan(alpha) = before} and {tan(beta) = after}.",
                "",
            ),
            (
                "walls/restitution-from-two-angles",
                "Before the collision the path of *A* makes an acute angle {alpha} with the wall, where {tan(alpha) = before}. After \
             the collision\nits path makes an acute angle {beta} with the wall, where {tan(beta) = after}.",
                "The path of *A* makes an acute angle {alpha} with the wall after the collision and an acute angle {beta} with \
             the wall before it, where {tan(alpha) = before} and {tan(beta) = after}.",
                "give `*A*` the angle `alpha`",
            ),
            ("walls/restitution-from-two-angles", "{tan(beta) = after}", "{sin(beta) = after}", "the angle `beta`"),
            (
                "walls/restitution-from-two-angles",
                "{beta} with the wall",
                "{beta} with the normal to the wall",
                "`beta`",
            ),
            (
                "ranges/mass-ratio-that-can-be",
                "{k*m} and",
                "{k} and",
                "give `*A*` the mass `k` where the scene gives it",
            ),
            (
                "both-moving/energy-lost-and-impulse",
                "acute angle of {alpha deg}",
                "acute angle of {beta deg}",
                "give `*A*` the angle `beta`",
            ),
            ("i-j/energy-lost", "{[bx, by] m/s}", "{[by, bx] m/s}", "give `*B*` the velocity"),
            ("walls/rebound-speed-and-direction", "{alpha deg} with the wall", "{alpha deg} to the wall", ""),
            (
                "walls/rebound-speed-and-direction",
                "{alpha deg} with the wall",
                "{alpha deg} with the normal to the wall",
                "give `*A*` the angle `alpha`",
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
                "deflection/equal-masses",
                "{theta} with the line of centres",
                "{theta} with the common tangent",
                "give `*A*` the angle `theta`",
            ),
        ];
        assert_said(&table);
    }
}
