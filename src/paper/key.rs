//! The key of a paper: everything that a marker needs, in the exchange format.

use serde::{Deserialize, Serialize};
use serde_json::{Map, Value as Json, json};

use super::answer::{self, Size};
use super::working::{self, WorkedPart};
use super::{PrintedPart, PrintedQuestion, Sheet, compose, scheme};
use crate::answer::Kind;
use crate::bank::{Answer, EarnedFor, Find, Givens, Question};
use crate::diagram::Manner;
use crate::expr::{Angles, Expr, print, read};
use crate::generate::Variant;
use crate::mechanics::{Pair, PolarText, Quantity, SceneText, ThenText, VelocityText};
use crate::number::Places;

/// A whole key: of one sheet, or of a class in which each student has a sheet of their own.
#[derive(Clone, Debug, Serialize)]
pub struct Key {
    /// The version of carom that wrote it.
    pub carom: &'static str,
    /// The bank the questions come from: `shipped`, or its folder.
    pub bank: String,
    /// The code of the sheet, which stands on its pages; of a class each sheet has its own.
    #[serde(skip_serializing_if = "String::is_empty")]
    pub code: String,
    /// The seed of the numbers; none for the reference numbers, and where the code decided.
    pub seed: Option<u64>,
    /// The questions in the order of the sheet; none for a class.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub questions: Vec<KeyQuestion>,
    /// The sheets of a class, in its order.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub papers: Vec<KeyPaper>,
}

/// The sheet of a student in the key of a class.
#[derive(Clone, Debug, Serialize)]
pub struct KeyPaper {
    /// The student, as the class list and the submissions have it.
    pub student: String,
    /// The student's name; left out if that is all there is.
    #[serde(skip_serializing_if = "String::is_empty")]
    pub name: String,
    /// The code of the sheet.
    pub code: String,
    /// The questions in the order of the sheet.
    pub questions: Vec<KeyQuestion>,
}

impl Key {
    /// The key of questions from a bank, without a code.
    pub fn new(bank: String, seed: Option<u64>, questions: Vec<KeyQuestion>) -> Key {
        Key { carom: env!("CARGO_PKG_VERSION"), bank, code: String::new(), seed, questions, papers: Vec::new() }
    }

    /// The key of a sheet.
    pub fn of_sheet(bank: String, seed: Option<u64>, sheet: &Sheet) -> Key {
        Key { code: sheet.code.to_string(), ..Key::new(bank, seed, sheet.keyed.clone()) }
    }

    /// The key of a class.
    pub fn of_class(bank: String, seed: Option<u64>, papers: Vec<KeyPaper>) -> Key {
        Key { papers, ..Key::new(bank, seed, Vec::new()) }
    }
}

/// A question of a key.
#[derive(Clone, Debug, Deserialize, Serialize)]
pub struct KeyQuestion {
    /// Its id in the bank.
    pub id: String,
    /// Its number on the sheet.
    pub number: usize,
    /// The exercise that it mirrors.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub mirrors: Option<String>,
    /// The style of its numbers.
    pub style: String,
    /// Its parameters by name, in the order of its file.
    pub parameters: Map<String, Json>,
    /// The collision, as `carom solve` takes it.
    pub scene: SceneText,
    /// Its parts.
    pub parts: Vec<KeyPart>,
}

/// A part of a key.
#[derive(Clone, Debug, Deserialize, Serialize)]
pub struct KeyPart {
    /// `a`, `b`, … or empty.
    pub label: String,
    /// Marks available.
    pub marks: usize,
    /// What is to be filled in.
    pub blanks: Vec<Blank>,
    /// The mark scheme.
    pub scheme: Vec<KeyMark>,
}

/// One answer of a key. Of a vector `exact`, `decimal` and `rounded` are lists, and so is `find`.
#[derive(Clone, Debug, Deserialize, Serialize)]
pub struct Blank {
    /// What it is, in words.
    pub name: String,
    /// The quantity that is asked for, or the letter.
    pub find: Json,
    /// Its kind.
    pub kind: String,
    /// The rule of acceptance.
    pub accept: String,
    /// The line from which an angle is measured.
    pub reference: Option<String>,
    /// The exact form, as an expression.
    pub exact: Json,
    /// The same in LaTeX.
    pub latex: String,
    /// At least 15 certified figures; null where letters remain.
    pub decimal: Json,
    /// Rounded as the rule says; null where letters remain.
    pub rounded: Json,
    /// The unit, `m/s`; empty if there is none.
    pub unit: String,
}

/// One mark of a key.
#[derive(Clone, Debug, Deserialize, Serialize)]
pub struct KeyMark {
    /// Its id within the part.
    pub id: String,
    /// Its code.
    pub code: String,
    /// The law or quantity that earns it.
    #[serde(rename = "for")]
    pub earned_for: String,
    /// The marks on which it depends.
    pub depends: Vec<String>,
    /// The blanks to which it belongs.
    pub blanks: Vec<String>,
    /// The equation or value that earns it.
    pub equation: Option<String>,
}

/// The key of a question as it was printed.
pub fn key_question(question: &Question, variant: &Variant, printed: &PrintedQuestion) -> KeyQuestion {
    let with_units = super::wording::letters_with_units(&printed.stem);
    let vectors = super::wording::has_unit_vectors(&printed.stem);
    let worked =
        working::work(question, variant, Manner { vectors, with_units: &with_units, angles: &[], after_walls: &[] });
    let parts = worked.iter().zip(&printed.parts).map(|(part, printed)| key_part(part, printed, variant, &with_units));
    let plain = |expr: &Expr| Json::from(print::plain(expr));
    KeyQuestion {
        id: question.id.clone(),
        number: printed.number,
        mirrors: question.mirrors.clone(),
        style: variant.style.name().to_owned(),
        parameters: variant.parameters.iter().map(|(name, value)| (name.clone(), plain(value))).collect(),
        scene: scene(&question.scene, &variant.givens),
        parts: parts.collect(),
    }
}

fn key_part(part: &WorkedPart, printed: &PrintedPart, variant: &Variant, with_units: &[String]) -> KeyPart {
    let blanks: Vec<Blank> = part.part.answers.iter().map(|answer| blank(answer, variant, with_units)).collect();
    let scheme = part.part.marks.iter().zip(&printed.scheme).map(|(mark, row)| KeyMark {
        id: row.id.clone(),
        code: row.code.clone(),
        earned_for: mark.earned_for.to_string(),
        depends: row.depends.clone(),
        blanks: scheme::answers_of(mark, part).into_iter().map(|place| blanks[place].name.clone()).collect(),
        // Of the energies that a line adds up it is the first that is a step of its own.
        equation: match mark.earned_for {
            EarnedFor::Law(law, _) if law.adds_up() && mark.code.is_accuracy() => row.equations.first(),
            _ => row.equations.last(),
        }
        .map(print::plain),
    });
    KeyPart { label: printed.label.clone(), marks: printed.marks(), scheme: scheme.collect(), blanks }
}

fn blank(answer: &Answer, variant: &Variant, with_units: &[String]) -> Blank {
    let sizes = answer::sizes(answer, variant);
    let usual = Places::SignificantFigures(3);
    let decimal = |places: &Places| {
        one_or_list(&sizes, |size| size.rounded(places).map_or(Json::Null, |decimal| decimal.to_string().into()))
    };
    let find = match &answer.find {
        Find::Quantity(quantity) => json!(quantity.to_string()),
        Find::Vector(x, y) => json!([x.to_string(), y.to_string()]),
        Find::Unknown(name) => json!(name),
    };
    let unit = answer::unit(answer, variant, with_units);
    let accept = answer.accept(variant.style);
    Blank {
        name: print::text_unicode(&compose::name(answer, variant)),
        find,
        kind: answer.kind.name().to_owned(),
        accept: accept.to_string(),
        reference: reference(&answer.find).map(str::to_owned),
        exact: match (&answer.kind, answer::exact(answer, variant)) {
            (Kind::Range, Some(range)) => print::plain(&range).into(),
            _ => one_or_list(&sizes, |size| print::plain(&size.exchange()).into()),
        },
        latex: answer::exact(answer, variant).as_ref().map(print::latex).unwrap_or_default(),
        decimal: decimal(&Places::SignificantFigures(15)),
        rounded: decimal(accept.places().unwrap_or(&usual)),
        unit: unit.plain().to_owned(),
    }
}

fn one_or_list(sizes: &[Size], one: impl Fn(&Size) -> Json) -> Json {
    match sizes {
        [] => Json::Null,
        [single] => one(single),
        several => several.iter().map(one).collect(),
    }
}

/// The line from which an angle is measured.
fn reference(find: &Find) -> Option<&'static str> {
    let Find::Quantity(quantity) = find else { return None };
    match quantity.of_its_impact() {
        Quantity::AngleToLine(..) | Quantity::AngleFromN(..) | Quantity::Alpha => Some("line of centres"),
        Quantity::AngleFromI(..) | Quantity::ImpulseAngle => Some("i"),
        Quantity::AngleToWall(..) => Some("wall"),
        Quantity::Deflection(_) | Quantity::SignedDeflection(_) => Some("direction before"),
        _ => None,
    }
}

/// The scene with numbers in place of parameters. The words of a bank are in degrees, the exchange format in
/// radians.
pub fn scene(scene: &SceneText, givens: &Givens) -> SceneText {
    let text = |text: &String| match read(text, Angles::Degrees) {
        Ok(expr) => print::plain(&expr.substitute(&|name| givens.shown(name).cloned())),
        Err(_) => text.clone(),
    };
    let pair = |[x, y]: &[String; 2]| [text(x), text(y)];
    let velocity = |velocity: &VelocityText<String>| match velocity {
        VelocityText::Along(velocity) => VelocityText::Along(text(velocity)),
        VelocityText::Components(components) => VelocityText::Components(pair(components)),
        VelocityText::Polar(polar) => VelocityText::Polar(PolarText {
            speed: text(&polar.speed),
            angle_deg: polar.angle_deg.as_ref().map(text),
            cos: polar.cos.as_ref().map(text),
            sin: polar.sin.as_ref().map(text),
        }),
    };
    SceneText {
        masses: both(&scene.masses, text),
        before: both(&scene.before, velocity),
        after: both(&scene.after, velocity),
        line_of_centres: scene.line_of_centres.as_ref().map(pair),
        sense: scene.sense,
        positions: both(&scene.positions, pair),
        radii: both(&scene.radii, text),
        impact_parameter: scene.impact_parameter.as_ref().map(text),
        wall: scene.wall.as_ref().map(pair),
        impulse: scene.impulse.as_ref().map(pair),
        e: scene.e.as_ref().map(text),
        symbols: scene.symbols.clone(),
        unknowns: scene.unknowns.clone(),
        conditions: scene.conditions.iter().map(text).collect(),
        maximise: scene.maximise.clone(),
        then: scene
            .then
            .iter()
            .map(|then| ThenText {
                of: then.of.clone(),
                mass: then.mass.as_ref().map(text),
                before: then.before.as_ref().map(velocity),
                line_of_centres: then.line_of_centres.as_ref().map(pair),
                sense: then.sense,
                wall: then.wall.as_ref().map(pair),
                e: then.e.as_ref().map(text),
            })
            .collect(),
    }
}

fn both<T>(pair: &Pair<T>, change: impl Fn(&T) -> T) -> Pair<T> {
    Pair { a: pair.a.as_ref().map(&change), b: pair.b.as_ref().map(&change) }
}
