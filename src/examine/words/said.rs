//! Is what the words say what the scene has? Whose each mass and velocity is, and how walls and lines lie.

use super::sentence::{Noun, Sentence, Token, is_one_of, is_supposed, noun_of, owner_of, sentences};
use crate::bank::{Question, Style};
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
