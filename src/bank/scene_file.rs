//! `[scene]` of a question file, every string with its place.

use std::collections::BTreeMap;
use std::ops::Range;

use toml::Spanned;
use toml::de::DeValue;

use super::document::{self, Faults, Keys, wrong_type};
use super::literal::Words;
use super::scene_names::scene_names;
use crate::diagnostic::{Diagnostic, Source};
use crate::expr::Angles;
use crate::mechanics::{Pair, PolarText, Scene, SceneText, Sense, ThenText, VelocityText};

/// What is to be done about a fault of the scene of which no more is known.
pub const MEND_SCENE: &str = "mend `[scene]`, where this belongs";

/// A scene as written, and where each of its strings stands.
#[derive(Clone, Debug)]
pub struct SceneFile {
    /// The scene in the exchange format.
    pub text: SceneText,
    /// Its strings by their path, such as `before.A.speed` or `line_of_centres[0]`, in the order of the file.
    pub places: Vec<(String, Words)>,
    /// Where the table stands.
    pub span: Range<usize>,
    /// Where the table of each later impact stands.
    then: Vec<Range<usize>>,
}

/// Reads a file that holds a scene of the exchange format as TOML, and nothing else.
///
/// # Errors
///
/// Every fault of the file, each with its place.
pub fn read_scene(source: &Source) -> Result<Scene, Vec<Diagnostic>> {
    let mut faults = Faults::new(source.clone());
    faults.model = "`carom solve --help` shows a scene";
    let text = source.text.clone();
    let file = document::parse(&text, &mut faults).and_then(|document| {
        let span = document.span();
        SceneFile::read(&Spanned::new(span, DeValue::Table(document.into_inner())), &mut faults)
    });
    if let (Some(file), true) = (file, faults.found.is_empty()) {
        let found = Scene::read(&file.text, &(), Angles::Radians);
        let amiss = scene_names(&file.text);
        match if amiss.is_empty() { found } else { found.and(Err(amiss)) } {
            Ok(scene) => return Ok(scene),
            Err(found) => {
                for fault in found {
                    match file.words(&fault.field) {
                        Some(words) => faults.expression(words, fault.fault),
                        None => {
                            let place = file.place(&fault.field);
                            let place = place.start..place.end.min(place.start + 1).max(place.start);
                            let help = fault.fault.help.unwrap_or_else(|| MEND_SCENE.to_owned());
                            faults.report(place, fault.fault.message, fault.fault.expected, help);
                        }
                    }
                }
            }
        }
    }
    Err(faults.found)
}

impl SceneFile {
    /// Reads the table; what is wrong in it is reported, the rest is read.
    pub fn read(value: &Spanned<DeValue>, faults: &mut Faults) -> Option<SceneFile> {
        let mut keys = Keys::within("a scene", value, faults)?;
        let mut walk = Walk { places: Vec::new(), then: Vec::new(), faults };
        let text = SceneText {
            masses: walk.pair(&mut keys, "masses", Walk::word),
            before: walk.pair(&mut keys, "before", Walk::velocity),
            after: walk.pair(&mut keys, "after", Walk::velocity),
            line_of_centres: keys.get("line_of_centres").and_then(|value| walk.vector("line_of_centres", value)),
            sense: keys.get("sense").and_then(|value| walk.sense("sense", value)),
            positions: walk.pair(&mut keys, "positions", Walk::vector),
            radii: walk.pair(&mut keys, "radii", Walk::word),
            impact_parameter: keys.get("impact_parameter").and_then(|value| walk.word("impact_parameter", value)),
            wall: keys.get("wall").and_then(|value| walk.vector("wall", value)),
            impulse: keys.get("impulse").and_then(|value| walk.vector("impulse", value)),
            e: keys.get("e").and_then(|value| walk.word("e", value)),
            symbols: keys.get("symbols").map_or_else(BTreeMap::new, |value| walk.symbols(value)),
            unknowns: walk.list(&mut keys, "unknowns"),
            conditions: walk.list(&mut keys, "conditions"),
            maximise: keys.get("maximise").and_then(|value| walk.word("maximise", value)),
            then: walk.then(&mut keys),
        };
        let (places, then) = (walk.places, walk.then);
        keys.finish(faults);
        Some(SceneFile { text, places, span: value.span(), then })
    }

    /// Where the string, or the first of several, with this path or below it stands; else the later impact, or the
    /// whole scene, that it would belong to.
    pub fn place(&self, path: &str) -> Range<usize> {
        let within =
            |known: &str| known.strip_prefix(path).is_some_and(|rest| rest.is_empty() || rest.starts_with(['.', '[']));
        let place = self.places.iter().find(|(known, _)| within(known)).map(|(_, words)| words.span());
        let later = || (0..).zip(&self.then).find(|(index, _)| path.starts_with(&format!("then[{index}]")));
        place.or_else(|| later().map(|(_, span)| span.clone())).unwrap_or(self.span.clone())
    }

    /// The string with exactly this path.
    pub fn words(&self, path: &str) -> Option<&Words> {
        self.places.iter().find(|(known, _)| known == path).map(|(_, words)| words)
    }

    /// The letters that it declares, those to be found among them.
    pub fn letters(&self) -> Vec<&str> {
        let declared = self.text.symbols.keys().map(String::as_str);
        declared.chain(self.text.unknowns.iter().map(String::as_str)).collect()
    }
}

struct Walk<'f> {
    places: Vec<(String, Words)>,
    then: Vec<Range<usize>>,
    faults: &'f mut Faults,
}

impl Walk<'_> {
    fn word(&mut self, path: &str, value: &Spanned<DeValue>) -> Option<String> {
        let words = document::words(&format!("`{path}`"), value, self.faults)?;
        let text = words.get_ref().clone();
        self.places.push((path.to_owned(), words));
        Some(text)
    }

    fn pair<T>(
        &mut self,
        keys: &mut Keys,
        key: &'static str,
        read: fn(&mut Self, &str, &Spanned<DeValue>) -> Option<T>,
    ) -> Pair<T> {
        let what = "a pair for the spheres";
        let Some(mut inner) = keys.get(key).and_then(|value| Keys::within(what, value, self.faults)) else {
            return Pair::none();
        };
        let a = inner.get("A").and_then(|value| read(self, &format!("{key}.A"), value));
        let b = inner.get("B").and_then(|value| read(self, &format!("{key}.B"), value));
        inner.finish(self.faults);
        Pair { a, b }
    }

    fn vector(&mut self, path: &str, value: &Spanned<DeValue>) -> Option<[String; 2]> {
        let DeValue::Array(items) = value.get_ref() else {
            let what = format!("`{path}`");
            wrong_type(&what, "a list of two texts in quotes", value.get_ref(), value.span(), self.faults);
            return None;
        };
        if items.len() != 2 {
            let label = format!("expected two components, found {}", items.len());
            let message = format!("`{path}` is no vector");
            self.faults.report(value.span(), message, label, "write `[\"x\", \"y\"]`, along i and along j");
            return None;
        }
        let mut items = items.iter().enumerate();
        let mut next = || items.next().and_then(|(index, item)| self.word(&format!("{path}[{index}]"), item));
        let (x, y) = (next(), next());
        Some([x?, y?])
    }

    fn velocity(&mut self, path: &str, value: &Spanned<DeValue>) -> Option<VelocityText<String>> {
        match value.get_ref() {
            DeValue::Array(_) => return self.vector(path, value).map(VelocityText::Components),
            DeValue::String(_) => return self.word(path, value).map(VelocityText::Along),
            _ => {}
        }
        let DeValue::Table(_) = value.get_ref() else {
            let expected = "`[\"x\", \"y\"]`, `{ speed = …, angle_deg = … }`, or `\"u\"` along one line";
            wrong_type(&format!("`{path}`"), expected, value.get_ref(), value.span(), self.faults);
            return None;
        };
        if let Some([x, y]) = components(value) {
            let (message, expected) = (format!("the components of `{path}` are named"), "expected a list of two texts");
            let help = format!("write `[{x}, {y}]`, along i and along j");
            self.faults.report(value.span(), message, expected, help);
            return None;
        }
        let mut keys = Keys::within("a velocity", value, self.faults)?;
        keys.demand("speed", "speed = \"u\"");
        let mut part = |key: &'static str| keys.get(key).and_then(|value| self.word(&format!("{path}.{key}"), value));
        let (speed, angle_deg, cos, sin) = (part("speed"), part("angle_deg"), part("cos"), part("sin"));
        if !matches!((&angle_deg, &cos, &sin), (Some(_), None, None) | (None, Some(_), Some(_))) {
            self.faults.report(
                value.span(),
                format!("`{path}` has no clear direction"),
                "expected `angle_deg`, or `cos` and `sin`",
                "give the angle anticlockwise from i as `angle_deg`",
            );
        }
        keys.finish(self.faults);
        Some(VelocityText::Polar(PolarText { speed: speed?, angle_deg, cos, sin }))
    }

    fn then(&mut self, keys: &mut Keys) -> Vec<ThenText> {
        let tables = keys.tables("then", "a later impact", self.faults);
        tables.into_iter().enumerate().map(|(index, keys)| self.one_of_then(&format!("then[{index}]"), keys)).collect()
    }

    fn one_of_then(&mut self, path: &str, mut keys: Keys) -> ThenText {
        let path = |key: &str| format!("{path}.{key}");
        self.then.push(keys.span());
        keys.demand("of", "of = [\"A\", \"B\"]");
        let of = keys.list("of", self.faults);
        let then = ThenText {
            of: of.iter().map(|words| words.get_ref().clone()).collect(),
            mass: keys.get("mass").and_then(|value| self.word(&path("mass"), value)),
            before: keys.get("before").and_then(|value| self.velocity(&path("before"), value)),
            line_of_centres: keys.get("line_of_centres").and_then(|value| self.vector(&path("line_of_centres"), value)),
            sense: keys.get("sense").and_then(|value| self.sense(&path("sense"), value)),
            wall: keys.get("wall").and_then(|value| self.vector(&path("wall"), value)),
            e: keys.get("e").and_then(|value| self.word(&path("e"), value)),
        };
        let named = of.into_iter().enumerate().map(|(index, words)| (path(&format!("of[{index}]")), words));
        self.places.extend(named);
        keys.finish(self.faults);
        then
    }

    fn sense(&mut self, path: &str, value: &Spanned<DeValue>) -> Option<Sense> {
        let words = document::words("`sense`", value, self.faults)?;
        self.places.push((path.to_owned(), words.clone()));
        match words.get_ref().as_str() {
            "A_to_B" => Some(Sense::FromAToB),
            "either" => Some(Sense::Either),
            other => {
                let message = format!("unknown sense `{other}`");
                let label = "expected `A_to_B` or `either`".to_owned();
                self.faults.unknown(words.span(), message, label, other, ["A_to_B", "either"]);
                None
            }
        }
    }

    fn symbols(&mut self, value: &Spanned<DeValue>) -> BTreeMap<String, String> {
        let mut found = BTreeMap::new();
        for (name, value) in document::pairs("`symbols`", value, self.faults) {
            let path = format!("symbols.{}", name.get_ref());
            let range = self.word(&path, value);
            found.extend(range.map(|range| (name.into_inner(), range)));
        }
        found
    }

    fn list(&mut self, keys: &mut Keys, key: &'static str) -> Vec<String> {
        let found = keys.list(key, self.faults);
        let texts = found.iter().map(|words| words.get_ref().clone()).collect();
        self.places.extend(found.into_iter().enumerate().map(|(index, words)| (format!("{key}[{index}]"), words)));
        texts
    }
}

/// The two values of `{ x = "3", y = "4" }` as they are written, or what to put in the place of one that is missing.
fn components(value: &Spanned<DeValue>) -> Option<[String; 2]> {
    let DeValue::Table(table) = value.get_ref() else { return None };
    let of = |names: [&str; 2]| {
        let found = names.map(|name| table.iter().find(|(key, _)| key.get_ref() == name).map(|(_, value)| value));
        (table.len() == found.iter().flatten().count() && !table.is_empty()).then_some(found)
    };
    let shown = |(value, name): (Option<&Spanned<DeValue>>, &str)| match value.map(Spanned::get_ref) {
        Some(DeValue::String(text)) => format!("\"{text}\""),
        Some(DeValue::Integer(number)) => format!("\"{number}\""),
        Some(DeValue::Float(number)) => format!("\"{number}\""),
        _ => format!("\"{name}\""),
    };
    let [x, y] = of(["x", "y"]).or_else(|| of(["i", "j"]))?;
    Some([(x, "x"), (y, "y")].map(shown))
}
