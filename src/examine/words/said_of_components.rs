//! What the words say of components, impulses, distances and radii: each as the scene has it.

use super::said::Seen;
use super::sentence::{Noun, Sentence, Token, is_one_of, noun_of, says};
use crate::examine::Finding;
use crate::expr::{Angles, Expr, Meaning, print, read, written};
use crate::mechanics::{Axis, Moment, Quantity, Sphere};
use crate::number::Value;
use crate::unit::Unit;

impl Seen<'_> {
    /// `*A* has component {p m/s} along the line of centres`: so large, and along that line.
    pub(super) fn components(&self, sentence: &Sentence, findings: &mut Vec<Finding>) {
        for (place, token) in sentence.iter().enumerate() {
            let Token::Number(expr, Unit::MetrePerSecond, lead) = token else { continue };
            let is_component = place > 0 && is_one_of(&sentence[place - 1], &["component"]);
            let owner = sentence[..place].iter().rev().find_map(|token| match token {
                Token::Sphere(sphere) if !self.is_object(sentence, *sphere, place) => Some(*sphere),
                _ => None,
            });
            let (true, Some(sphere), Some(axis)) = (is_component, owner, along_which(&sentence[place + 1..])) else {
                continue;
            };
            let towards = sentence[place..].windows(2).find(|pair| is_one_of(&pair[0], &["towards"]));
            if towards.is_some_and(|pair| pair[1] == Token::Sphere(sphere)) && axis == Axis::N {
                let name = sphere.name();
                let message = format!("the words have `*{name}*` move towards itself");
                findings.push(self.finding(message, &format!("towards *{name}*"), "name the other sphere"));
            }
            let scene = self.known.number(Quantity::Velocity(sphere, Moment::Before, axis));
            let (Some(said), Some(has)) = (self.number(expr), scene) else { continue };
            if !(&said * &said).equals(&(&has * &has)) && self.question.scene.then.is_empty() {
                let (sphere, shown) = (sphere.name(), print::plain(expr));
                let line = if axis == Axis::N { "along" } else { "perpendicular to" };
                let has = print::unicode(&written(&has));
                let message = format!(
                    "the words give `*{sphere}*` the component `{shown}` {line} the line of centres, where the scene gives it {has}"
                );
                let help = format!("name in the words what `[scene]` has for `{sphere}`, or change it there");
                findings.push(self.finding(message, lead, &help));
            }
        }
    }

    /// Is a sphere named before a place only as that towards which another moves?
    fn is_object(&self, sentence: &Sentence, sphere: Sphere, place: usize) -> bool {
        let named = sentence[..place].iter().rposition(|token| *token == Token::Sphere(sphere));
        named.is_some_and(|at| at > 0 && is_one_of(&sentence[at - 1], &["towards", "from"]))
    }

    /// `An impulse of {[p, q] N s}`: that of the scene.
    pub(super) fn impulses(&self, sentence: &Sentence, findings: &mut Vec<Finding>) {
        let Some(impulse) = &self.question.scene.impulse else { return };
        let component = |at: usize| self.number(&read(&impulse[at], Angles::Degrees).ok()?);
        for token in sentence {
            let Token::Number(expr, Unit::NewtonSecond, lead) = token else { continue };
            if let Expr::Vector(x, y) = expr
                && let (Some((i, has_i)), Some((j, has_j))) =
                    (self.while_open(Some(&impulse[0]), x), self.while_open(Some(&impulse[1]), y))
            {
                if !(i.equals(&has_i) && j.equals(&has_j)) {
                    self.another_impulse(expr, [has_i, has_j], lead, findings);
                }
                continue;
            }
            let (Some(Meaning::Vector(x, y)), Some(i), Some(j)) = (self.meaning(expr), component(0), component(1))
            else {
                continue;
            };
            if !(x.equals(&i) && y.equals(&j)) {
                self.another_impulse(expr, [i, j], lead, findings);
            }
        }
    }

    fn another_impulse(&self, said: &Expr, [i, j]: [Value; 2], lead: &str, findings: &mut Vec<Finding>) {
        let has = Expr::Vector(Box::new(written(&i)), Box::new(written(&j)));
        let (shown, has) = (print::plain(said), print::unicode(&has));
        let message = format!("the words give the impulse `{shown}`, where the scene gives it {has}");
        findings.push(self.finding(message, lead, "name in the words the `impulse` of `[scene]`, or change it there"));
    }

    /// Radii that each sphere is said to have, and how far the path of *A* is said to pass from the centre of *B*.
    pub(super) fn lengths(&self, sentence: &Sentence, findings: &mut Vec<Finding>) {
        let scene = &self.question.scene;
        let given = |text: &Option<String>| self.number(&read(text.as_ref()?, Angles::Degrees).ok()?);
        let aside = given(&scene.impact_parameter);
        for (place, token) in sentence.iter().enumerate() {
            let Token::Number(expr, Unit::None | Unit::Metre, lead) = token else { continue };
            let is_of_each = says(sentence, &["each", "both"]);
            let is_radius = noun_of(sentence, place).is_some_and(|(_, noun, _)| noun == Noun::Radius);
            let is_distance = place > 0 && is_one_of(&sentence[place - 1], &["is"]) && says(sentence, &["distance"]);
            let (what, has): (_, Vec<Option<Value>>) = match (is_radius && is_of_each, is_distance) {
                (true, _) => ("radius", vec![given(&scene.radii.a), given(&scene.radii.b)]),
                (false, true) if says(sentence, &["centre"]) && edge(sentence).is_none() => {
                    ("distance", vec![aside.clone()])
                }
                _ => continue,
            };
            let Some(said) = self.number(expr) else { continue };
            let other = has.into_iter().flatten().find(|has| !(&said * &said).equals(&(has * has)));
            if let Some(other) = other {
                let (shown, has) = (print::plain(expr), print::unicode(&written(&other)));
                let message = format!("the words give the {what} `{shown}`, where the scene gives it {has}");
                let key = if what == "radius" { "radii" } else { "impact_parameter" };
                findings.push(self.finding(
                    message,
                    lead,
                    &format!("name in the words the `{key}` of `[scene]`, or change it there"),
                ));
            }
        }
    }

    /// Diameters that are those of no sphere, and the distance of a path from the centre of the sphere whose path it is.
    pub(super) fn centres(&self, sentence: &Sentence, findings: &mut Vec<Finding>) {
        let radii = [&self.question.scene.radii.a, &self.question.scene.radii.b].into_iter().flatten();
        let radii: Vec<Value> = radii.filter_map(|radius| self.number(&read(radius, Angles::Degrees).ok()?)).collect();
        for (place, token) in sentence.iter().enumerate().skip(1) {
            let Token::Number(expr, Unit::None | Unit::Metre, lead) = token else { continue };
            let near = &sentence[place.saturating_sub(2)..place];
            let (true, Some(said)) = (says(near, &["diameter", "diameters"]), self.number(expr)) else { continue };
            let is_of = |radius: &Value| said.equals(&(radius + radius));
            if let Some(radius) = radii.first().filter(|_| !radii.iter().any(is_of)) {
                let (shown, has) = (print::plain(expr), print::unicode(&written(&(radius + radius))));
                let message = format!("the words give the diameter `{shown}`, where the scene gives it {has}");
                findings.push(self.finding(message, lead, "say `radius`, or change the `radii` of `[scene]`"));
            }
        }
        self.offset_from_an_edge(sentence, findings);
        let centre_of = |words: &[Token]| match words {
            [centre, of, Token::Sphere(sphere)] if is_one_of(centre, &["centre"]) && is_one_of(of, &["of"]) => {
                Some(*sphere)
            }
            _ => None,
        };
        let named: Vec<Sphere> = sentence.windows(3).filter_map(centre_of).collect();
        if let ([from, of_path, ..], true) = (named.as_slice(), says(sentence, &["distance"]))
            && from == of_path
            && says(sentence, &["line", "path"])
        {
            let name = from.name();
            let message =
                format!("the words give the distance from the centre of `*{name}*` to a line on which this centre is");
            let at = format!("centre of *{name}*");
            findings.push(self.finding(message, &at, "measure it from the centre of the other sphere"));
        }
    }
}

/// The edge of a sphere, from which a distance is measured.
fn edge(sentence: &[Token]) -> Option<(String, Sphere)> {
    const EDGES: [&str; 6] = ["edge", "rim", "circumference", "surface", "side", "boundary"];
    sentence.windows(3).find_map(|words| match words {
        [Token::Word(edge), of, Token::Sphere(sphere)] if EDGES.contains(&edge.as_str()) => {
            is_one_of(of, &["of"]).then(|| (edge.clone(), *sphere))
        }
        _ => None,
    })
}

impl Seen<'_> {
    /// The distance of a path from the edge of a sphere, which is its radius less or more than that from the centre.
    fn offset_from_an_edge(&self, sentence: &Sentence, findings: &mut Vec<Finding>) {
        let Some((edge, sphere)) = edge(sentence).filter(|_| says(sentence, &["distance"])) else { return };
        let offset = self.question.scene.impact_parameter.as_ref();
        let from_centre = offset.and_then(|offset| self.number(&read(offset, Angles::Degrees).ok()?));
        let (Some(from_centre), Some(radius)) = (from_centre, self.radius(sphere)) else { return };
        for (place, token) in sentence.iter().enumerate().skip(1) {
            let Token::Number(expr, Unit::None | Unit::Metre, _) = token else { continue };
            let Some(said) = self.number(expr).filter(|_| is_one_of(&sentence[place - 1], &["is", "of"])) else {
                continue;
            };
            let is_so = |distance: Value| (&distance * &distance).equals(&(&from_centre * &from_centre));
            if !is_so(&said + &radius) && !is_so(&said - &radius) {
                let (name, shown) = (sphere.name(), print::plain(expr));
                let has = print::unicode(&written(&from_centre));
                let message = format!(
                    "the words give `{shown}` as the distance from the {edge} of `*{name}*`, and in the scene it is {has} from \
                     the centre"
                );
                let help = format!("say `from the centre of *{name}*`, or add the radius in `impact_parameter`");
                findings.push(self.finding(message, &format!("{edge} of *{name}*"), &help));
            }
        }
    }
}

/// Along which line words go on: along the line of centres, or perpendicular to it; what is next to another number is not
/// asked.
fn along_which(words: &[Token]) -> Option<Axis> {
    let own = words.iter().take_while(|token| !matches!(token, Token::Sphere(_))).take(12);
    let mut is_across = None;
    for token in own {
        match token {
            Token::Word(word) => match word.as_str() {
                "perpendicular" => is_across = Some(true),
                "along" | "parallel" => is_across = Some(false),
                "centres" => return is_across.map(|across| if across { Axis::T } else { Axis::N }),
                "wall" | "and" | "component" => return None,
                _ => {}
            },
            Token::Number(..) | Token::Comma if is_across.is_some() => return None,
            _ => {}
        }
    }
    None
}

#[cfg(test)]
mod tests {
    use super::super::said_tests::{assert_said, said};

    #[test]
    fn components_distances_and_radii_are_those_of_the_scene() {
        let table = [
            ("vector-impulse/size-of-the-impulse", "{[k*f, k*g] N s}", "{[f, g] N s}", "give the impulse `[f, g]`"),
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
                "vector-impulse/velocity-after-an-impulse",
                "impulse = [\"p\", \"q\"]",
                "impulse = [\"-p\", \"-q\"]",
                "give the impulse `[p, q]`",
            ),
        ];
        assert_said(&table);
        let (id, from) = ("rest-letters/distance-from-the-centre-of-b", "distance from the centre of *B*");
        let edge = (from, "distance from the edge of *B*");
        let part = ("is moving is {d}", "is moving is {d/4}");
        let added = ("impact_parameter = \"-d\"", "impact_parameter = \"-(r - d/4)\"");
        assert_eq!(said(id, &[edge, part, added]), "");
        assert!(said(id, &[edge, part]).contains("give `d/4` as the distance from the edge of `*B*`"));
    }
}
