//! Is what the words say of the collision so? Who is at rest, who moves towards whom, and which angles are acute.

use super::compared::{Compared, compared};
use super::sentence::in_order;
use super::sentences::around;
use crate::examine::remark::Remark;
use crate::expr::{Expr, Meaning, Piece, Text, evaluate};
use crate::generate::Variant;
use crate::mechanics::{Axis, Moment, Quantity, Setting, Sphere};
use crate::number::Value;
use crate::paper::Words;
use crate::unit::Unit;

/// A remark on words of the author that are not so, at their place in the file.
pub(super) fn remark(what: &str, at: &str, shown: &str, help: &str) -> Remark {
    Remark::new(what, at, "here", help).showing(shown)
}

/// What the words say of the motion before the collision, found once for all variants: they say the same, whatever the
/// numbers in them are.
#[derive(Clone, Debug)]
pub struct Claims {
    ways: Vec<Way>,
    rests: Vec<Rest>,
    compared: Vec<Compared>,
}

impl Claims {
    /// Reads them in the words of a variant.
    pub fn of(words: &Words) -> Claims {
        let mut claims = Claims { ways: Vec::new(), rests: Vec::new(), compared: Vec::new() };
        for paragraph in &words.stem {
            ways(paragraph, &mut claims.ways);
            compared(paragraph, &mut claims.compared);
            rests(paragraph, &mut claims.rests);
        }
        claims
    }
}

/// What is said and is not so.
pub fn untrue(claims: &Claims, words: &Words, variant: &Variant, remarks: &mut Vec<Remark>) {
    remarks.extend(claims.ways.iter().filter_map(|way| way.if_untrue(variant)));
    remarks.extend(claims.compared.iter().filter_map(|compared| compared.if_untrue(variant)));
    remarks.extend(claims.rests.iter().filter_map(|rest| rest.if_untrue(variant)));
    for text in words.stem.iter().chain(&words.asks) {
        angles(text, variant, remarks);
    }
}

/// Whether a sphere is at rest before its first impact; none where that is not known.
pub(super) fn is_at_rest(variant: &Variant, sphere: Sphere) -> Option<bool> {
    let mut first: Option<(u8, Vec<Value>)> = None;
    let known = variant.solution.known();
    let is_before = |quantity: &Quantity| match quantity.of_its_impact() {
        Quantity::Velocity(of, Moment::Before, _) | Quantity::Speed(of, Moment::Before) => of == sphere,
        _ => false,
    };
    for quantity in known.0.keys().filter(|quantity| is_before(quantity)) {
        let Some(value) = known.number(*quantity) else { continue };
        match &mut first {
            Some((impact, values)) if *impact == quantity.impact() => values.push(value),
            Some((impact, _)) if *impact < quantity.impact() => {}
            _ => first = Some((quantity.impact(), vec![value])),
        }
    }
    let (_, values) = first?;
    match values.iter().all(Value::is_zero) {
        true => (values.len() > 1).then_some(true),
        false => Some(false),
    }
}

/// Words of what comes later, or is only supposed.
const ELSEWHERE: [&str; 5] = ["after", "brought", "come", "came", "if "];

/// A sentence that says of spheres that they are at rest before the collision, or that they move.
#[derive(Clone, Debug)]
struct Rest {
    /// Those of whom it is said, if they are named before it.
    named: Vec<Sphere>,
    /// Is it rest that is said of them?
    rests: bool,
    /// Does it speak of rest at all, be it of nobody that is named?
    of_rest: bool,
    at: String,
}

impl Rest {
    fn if_untrue(&self, variant: &Variant) -> Option<Remark> {
        let wrong = self.named.iter().find(|sphere| is_at_rest(variant, **sphere) == Some(!self.rests));
        let nobody = || {
            Sphere::ALL.into_iter().all(|sphere| match sphere {
                Sphere::A => is_at_rest(variant, sphere) == Some(false),
                // A wall stands in the place of a sphere, and is at rest.
                _ if !is_there(variant, sphere) => true,
                _ => is_at_rest(variant, sphere) != Some(true) && !is_open(variant, sphere),
            })
        };
        let said = match wrong {
            Some(sphere) => format!("{} is {}", sphere.name(), if self.rests { "at rest" } else { "moving" }),
            None if self.of_rest && nobody() => "at rest".to_owned(),
            None => return None,
        };
        let help = "give in `[scene]` the velocity that is said, or say the one that is given";
        Some(remark("a motion that is not so", &self.at, &said, help))
    }
}

/// Who is said to be at rest before the collision, and who to move.
fn rests(text: &Text, found: &mut Vec<Rest>) {
    let mut pieces = Vec::new();
    in_order(&text.0, &mut pieces);
    let mut elsewhere = false;
    for (place, piece) in pieces.iter().enumerate() {
        let Piece::Words(words) = piece else { continue };
        for (nth, sentence) in words.split_inclusive('.').enumerate() {
            let starts = |of: &[&str]| nth == 0 && of.iter().any(|start| sentence.starts_with(start));
            let (rests, moves) = (starts(&[" is at rest", " are at rest"]), starts(&[" is moving", " are moving"]));
            let of_rest = sentence.contains(" at rest");
            let lower = sentence.to_lowercase();
            let is_elsewhere = elsewhere || ELSEWHERE.iter().any(|word| lower.contains(word));
            elsewhere = is_elsewhere && !sentence.ends_with('.');
            if is_elsewhere || !(rests || moves || of_rest) {
                continue;
            }
            let named = if rests || moves { named_before(&pieces[..place]) } else { Vec::new() };
            let at = words.find(sentence).unwrap_or(0)
                + sentence.find(" at rest").or(sentence.find(" mov")).unwrap_or(0)
                + 1;
            found.push(Rest { named, rests, of_rest, at: around(words, at).to_owned() });
        }
    }
}

/// Does a sphere take part in any impact?
fn is_there(variant: &Variant, sphere: Sphere) -> bool {
    let scene = &variant.scene;
    let meets = |of: [Sphere; 2]| of.contains(&sphere);
    sphere == Sphere::A
        || (sphere == Sphere::B && !scene.setting.is_of_one())
        || scene.then.iter().any(|then| !then.meeting.with_wall && meets(then.meeting.of))
}

/// Does a sphere take part of which it is not known whether it is at rest?
fn is_open(variant: &Variant, sphere: Sphere) -> bool {
    let is_its_mass = |quantity: &Quantity| quantity.of_its_impact() == Quantity::Mass(sphere);
    is_at_rest(variant, sphere).is_none() && variant.solution.known().0.keys().any(is_its_mass)
}

/// The spheres named at the end: `*B*`, `*B* and *C*`, or `*A*, *B* and *C*`.
fn named_before(pieces: &[&Piece]) -> Vec<Sphere> {
    let name = |piece: Option<&&Piece>| match piece {
        Some(Piece::Formula(Expr::Name(name))) => Sphere::ALL.into_iter().find(|sphere| sphere.name() == name.text),
        _ => None,
    };
    let mut named: Vec<Sphere> = name(pieces.last()).into_iter().collect();
    let mut before = pieces;
    while let [earlier @ .., Piece::Words(between), _] = before {
        let joins = if named.len() == 1 { between.trim() == "and" } else { between.trim() == "," };
        match name(earlier.last()).filter(|_| joins && !named.is_empty()) {
            Some(one) => named.insert(0, one),
            None => break,
        }
        before = earlier;
    }
    named
}

/// An angle that is said to be acute is below 90 degrees, and one that is obtuse above.
fn angles(text: &Text, variant: &Variant, remarks: &mut Vec<Remark>) {
    for pair in text.0.windows(2) {
        let (Piece::Words(words), Piece::Quantity(expr, Unit::Degree) | Piece::Formula(expr)) = (&pair[0], &pair[1])
        else {
            continue;
        };
        let before = words.trim_end().trim_end_matches(" of").trim_end();
        let kind = before.strip_suffix(" angle").unwrap_or_default();
        let said = ["acute", "obtuse"].into_iter().find(|said| kind.ends_with(said));
        let Some(said) = said else { continue };
        let Some(is_acute) = is_acute(expr, &pair[1], variant) else { continue };
        if is_acute != (said == "acute") {
            let shown = crate::expr::print::text_unicode(&Text(vec![pair[1].clone()]));
            let help = "say `an angle`, or require that it is what is said";
            let at = around(words, before.len() - "angle".len());
            remarks.push(remark("an angle that is not so", at, &format!("{said} angle {shown}"), help));
        }
    }
}

/// Is an angle acute, and not obtuse? None of what is neither, or is not known.
fn is_acute(expr: &Expr, piece: &Piece, variant: &Variant) -> Option<bool> {
    let degrees = match evaluate(expr, &|name| variant.givens.meaning(name)).ok()? {
        Meaning::Number(value) if matches!(piece, Piece::Quantity(..)) => value.to_f64()?,
        // A letter for an angle is declared acute.
        Meaning::Angle(_) if matches!(expr, Expr::Name(_)) => return Some(true),
        Meaning::Angle(turn) | Meaning::Degrees(turn) => turn.to_f64()?,
        _ => return None,
    };
    let is_near = |other: f64| (degrees - other).abs() < 1e-9;
    match degrees {
        _ if is_near(0.0) || is_near(90.0) || is_near(180.0) => None,
        _ if 0.0 < degrees && degrees < 90.0 => Some(true),
        _ => (90.0 < degrees && degrees < 180.0).then_some(false),
    }
}

/// Words of who moves which way along the line of centres, and what they say of *A* and of *B*: with the line from *A* to
/// *B* or against it. What is said of the other is said of both.
const WAYS: [(&str, Whom); 20] = [
    ("towards each other", Whom::Both(1.0, -1.0)),
    ("towards one another", Whom::Both(1.0, -1.0)),
    ("towards the other", Whom::Both(1.0, -1.0)),
    ("towards", Whom::Next(1.0)),
    ("away from each other", Whom::Both(-1.0, 1.0)),
    ("away from one another", Whom::Both(-1.0, 1.0)),
    ("away from the other", Whom::Both(-1.0, 1.0)),
    ("away from", Whom::Next(-1.0)),
    ("in opposite directions", Whom::Opposite(-1.0)),
    ("in the opposite direction along", Whom::Opposite(-1.0)),
    ("in the same direction", Whom::Opposite(1.0)),
    ("going the same way", Whom::Opposite(1.0)),
    ("moving the same way", Whom::Opposite(1.0)),
    ("travelling the same way", Whom::Opposite(1.0)),
    ("going the opposite way", Whom::Opposite(-1.0)),
    ("moving the opposite way", Whom::Opposite(-1.0)),
    ("travelling the opposite way", Whom::Opposite(-1.0)),
    ("behind", Whom::Behind),
    ("in front of", Whom::Ahead),
    ("ahead of", Whom::Ahead),
];

/// What comes next where a sphere's way is set beside its own old one.
const OF_ITSELF: [&str; 4] = [" as before", " as it ", " as its ", " as that"];

/// Whom such words are said of.
#[derive(Clone, Copy, Debug)]
enum Whom {
    /// The other than the sphere whose name comes next.
    Next(f64),
    /// Both, each its way.
    Both(f64, f64),
    /// Both, the one as the other or against it.
    Opposite(f64),
    /// The sphere before it, which goes the way of that after it.
    Behind,
    /// The sphere before it, which the one after it follows.
    Ahead,
}

/// Who is said to move towards *A* or *B* or away from it, or as the other does, along the line of centres before the
/// collision.
#[derive(Clone, Debug)]
struct Way {
    way: &'static str,
    whom: Whom,
    /// The name that comes next.
    next: String,
    at: String,
}

impl Way {
    fn if_untrue(&self, variant: &Variant) -> Option<Remark> {
        let said = untrue_way(self.way, self.whom, &self.next, variant)?;
        let help = "turn its velocity round in `[scene]`, or say which way it is";
        Some(remark("a direction that is not so", &self.at, &said, help))
    }
}

fn ways(text: &Text, found: &mut Vec<Way>) {
    let mut is_after = false;
    for (place, piece) in text.0.iter().enumerate() {
        let Piece::Words(words) = piece else { continue };
        for sentence in words.split_inclusive('.') {
            let is_said = |way: &&(&str, Whom)| match way.1 {
                Whom::Next(_) | Whom::Behind | Whom::Ahead => sentence.trim_end().ends_with(way.0),
                _ => sentence.split(way.0).skip(1).any(|rest| !OF_ITSELF.iter().any(|old| rest.starts_with(old))),
            };
            let lower = sentence.to_lowercase();
            is_after = is_after || ["after ", " then "].iter().any(|later| lower.contains(later));
            for (way, whom) in WAYS.iter().filter(is_said).filter(|_| !is_after) {
                let next = match text.0.get(place + 1) {
                    Some(Piece::Formula(Expr::Name(name))) => name.text.clone(),
                    _ => String::new(),
                };
                let at = match whom {
                    Whom::Next(_) | Whom::Behind | Whom::Ahead => format!("{way} *{next}*"),
                    _ => around(words, words.find(way).unwrap_or(0)).to_owned(),
                };
                found.push(Way { way, whom: *whom, next, at });
            }
            is_after = is_after && !sentence.ends_with('.');
        }
    }
}

/// What is said and is not so, of a sphere or of both.
fn untrue_way(way: &str, whom: Whom, next: &str, variant: &Variant) -> Option<String> {
    // A sphere alone moves towards walls and ends of walls, which is looked at elsewhere.
    if variant.scene.setting == Setting::Wall {
        return None;
    }
    let along = |sphere| component(variant, sphere).filter(|along: &f64| along.abs() > 1e-9);
    // A third sphere may be the one that moves.
    let is_third = is_at_rest(variant, Sphere::C).is_some();
    let rests = |sphere: Sphere| !is_third && is_at_rest(variant, sphere) == Some(true);
    let wrong = |sphere: Sphere, sense: f64| rests(sphere) || along(sphere).is_some_and(|along| along * sense < 0.0);
    let of_one = |sphere: Sphere, sense: f64, other: &str| {
        let way = if way.starts_with("away") { "away from" } else { "towards" };
        wrong(sphere, sense).then(|| format!("{} moves {way} {other}", sphere.name()))
    };
    let of_both = |sense: f64| Some(along(Sphere::A)? * along(Sphere::B)? * sense < 0.0);
    match (whom, next) {
        (Whom::Next(sense), "A") => of_one(Sphere::B, -sense, next),
        (Whom::Next(sense), "B") => of_one(Sphere::A, sense, next),
        (Whom::Both(a, b), _) => of_one(Sphere::A, a, "B").or_else(|| of_one(Sphere::B, b, "A")),
        (Whom::Opposite(sense), _) if !is_third => {
            let way =
                ["going ", "moving ", "travelling "].iter().find_map(|verb| way.strip_prefix(verb)).unwrap_or(way);
            of_both(sense)?.then(|| format!("A and B move {way}"))
        }
        // Who is behind goes towards the other.
        (Whom::Behind | Whom::Ahead, "A" | "B") => {
            let is_ahead = matches!(whom, Whom::Ahead);
            let sense = if (next == "B") != is_ahead { 1.0 } else { -1.0 };
            let is_wrong = [Sphere::A, Sphere::B].into_iter().any(|sphere| wrong(sphere, sense));
            let said = if is_ahead { way } else { "behind" };
            is_wrong.then(|| format!("{} is {said} {next}", if next == "B" { "A" } else { "B" }))
        }
        _ => None,
    }
}

/// The component of a velocity before along the line of centres from A to B, roughly; of letters its sign, if they have one.
fn component(variant: &Variant, sphere: Sphere) -> Option<f64> {
    let known = variant.solution.known();
    if let Some(value) = known.number(Quantity::Velocity(sphere, Moment::Before, Axis::N)) {
        return value.to_f64().or_else(|| value.sign().map(|sign| f64::from(sign as i8)));
    }
    let number = |quantity| known.number(quantity)?.to_f64();
    let [x, y] = [Axis::X, Axis::Y].map(|axis| number(Quantity::Velocity(sphere, Moment::Before, axis)));
    let [i, j] = [Axis::X, Axis::Y].map(|axis| number(Quantity::Line(axis)));
    Some(x? * i? + y? * j?)
}

#[cfg(test)]
mod tests {
    use super::super::said_tests::assert_said;

    #[test]
    fn who_moves_towards_whom_does_so() {
        let table = [
            (
                "direct/one-sphere-catches-the-other",
                "in the same direction",
                "in opposite directions",
                "A and B move in opposite directions",
            ),
            (
                "direct/one-sphere-catches-the-other",
                "in the same direction",
                "in the opposite direction along one line",
                "A and B move in the opposite",
            ),
            (
                "both-moving/energy-lost-and-impulse",
                "moving towards the other",
                "moving towards each other in the same direction",
                "A and B move in the same direction",
            ),
            ("direct/one-sphere-catches-the-other", "in the same direction", "towards each other", "B moves towards A"),
            (
                "direct/one-sphere-catches-the-other",
                "in the same direction",
                "towards one another",
                "B moves towards A",
            ),
            ("direct/one-sphere-catches-the-other", "in the same direction", "with *B* going the same way", ""),
            (
                "direct/one-sphere-catches-the-other",
                "in the same direction",
                "with *B* going the opposite way",
                "A and B move the opposite way",
            ),
            (
                "direct/one-sphere-catches-the-other",
                "in the same direction",
                "away from each other",
                "A moves away from B",
            ),
            (
                "walls/tangents-in-letters",
                "A smooth sphere *A* of mass {mass} slides",
                "A smooth sphere *A* of mass {mass} at rest slides",
                "at rest",
            ),
            (
                "both-moving/energy-lost-and-impulse",
                "moving towards the other",
                "moving in the same direction",
                "A and B move in the same direction",
            ),
            ("both-moving/components-given", "centres, towards *A*", "centres, away from *A*", "B moves away from A"),
            (
                "direct/mass-from-the-velocities",
                "are moving towards each other",
                "are moving in the same direction",
                "A and B move in the same direction",
            ),
        ];
        assert_said(&table);
    }
}
