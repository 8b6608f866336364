//! A part of a key read: its blanks with their model answers, and its mark scheme.

use std::collections::BTreeSet;

use super::{KeyFault, KeyedBlank, KeyedMark, KeyedPart, motion};
use crate::answer::{Accept, Kind};
use crate::bank::{Code, EarnedFor, Find};
use crate::expr::{Angles, Expr, read_range};
use crate::mark::judging::{Model, ModelOptions, is_named};
use crate::mark::reading::Statement;
use crate::mark::slips::Asked;
use crate::mechanics::{Derivation, Known, Meeting, Quantity, Scene, with_letter_of_restitution};
use crate::number::{Letter, Value};
use crate::paper::{Blank, KeyMark, KeyPart};

impl KeyedPart {
    pub(super) fn read(part: &KeyPart, scene: &Scene, known: &mut Known<Value>) -> Result<KeyedPart, KeyFault> {
        let each = part.blanks.iter().enumerate();
        let blanks = each.map(|(place, blank)| {
            KeyedBlank::read(blank, printed_result(blank, part), scene)
                .map_err(|fault| fault.below(&format!("blanks[{place}]")))
        });
        let mut blanks = blanks.collect::<Result<Vec<_>, _>>()?;
        let each = part.scheme.iter().enumerate();
        let scheme = each.map(|(place, mark)| {
            KeyedMark::read(mark, part, scene).map_err(|fault| fault.below(&format!("scheme[{place}]")))
        });
        let scheme = scheme.collect::<Result<Vec<_>, _>>()?;
        let mut asked: Vec<Quantity> = blanks.iter().flat_map(|blank| blank.find.quantities()).collect();
        let marked = scheme.iter().flat_map(|mark| mark.earned_for.quantities().iter().copied());
        asked.extend(marked.collect::<BTreeSet<_>>());
        let (derivation, _) = Derivation::carry_out(known, &asked);
        for blank in &mut blanks {
            motion::tell(&mut blank.model, &blank.name, &blank.find, scene, known);
        }
        let last = derivation.steps.iter().map(|step| step.impact()).max();
        let then = scene.then.iter().find(|then| Some(then.meeting.number) == last);
        Ok(KeyedPart {
            setting: then.map_or(scene.setting, |then| then.scene.setting),
            letter_of_restitution: then.map_or(scene, |then| &then.scene).letter_of_restitution(),
            meeting: then.map_or(Meeting::FIRST, |then| then.meeting),
            label: part.label.clone(),
            blanks,
            scheme,
            derivation,
            known: known.clone(),
        })
    }

    /// A sentence about a law, in the words of its impact and with the names of who and what takes part in it.
    pub(in crate::mark) fn said(&self, sentence: &str) -> String {
        let said = self.setting.say(sentence);
        self.meeting.in_words(&with_letter_of_restitution(&said, self.letter_of_restitution))
    }

    /// Is a value called what this blank asks for, and not what another of the part does?
    pub(in crate::mark) fn calls(&self, place: usize, statement: &Statement) -> bool {
        let blank = &self.blanks[place];
        if let Find::Unknown(name) = &blank.find {
            return statement.label.as_ref().is_some_and(|label| {
                label.typed == *name || matches!(&label.expr, Some(Expr::Name(own)) if own.text == *name)
            });
        }
        let mut others = self.blanks.iter().enumerate().filter(|(other, _)| *other != place);
        is_named(&blank.model, statement) && !others.any(|(_, other)| is_named(&other.model, statement))
    }

    /// How many marks it has.
    pub fn available(&self) -> usize {
        self.scheme.len()
    }
}

impl KeyedBlank {
    /// What it asks for, as slips see it.
    pub(crate) fn asked(&self) -> Asked {
        Asked::of(&self.find, self.model.kind)
    }

    fn read(blank: &Blank, printed: Option<&String>, scene: &Scene) -> Result<KeyedBlank, KeyFault> {
        let at = |field: &str, message: String, expected: &str| KeyFault {
            path: field.to_owned(),
            ..KeyFault::new(message, expected)
        };
        let quantity = |value: &serde_json::Value| value.as_str().and_then(|name| name.parse::<Quantity>().ok());
        let find = match &blank.find {
            serde_json::Value::Array(both) => match both.as_slice() {
                [x, y] => quantity(x).zip(quantity(y)).map(|(x, y)| Find::Vector(x, y)),
                _ => None,
            },
            serde_json::Value::String(name) => match quantity(&blank.find) {
                Some(quantity) => Some(Find::Quantity(quantity)),
                None => scene.unknowns.iter().any(|letter| letter.name() == name).then(|| Find::Unknown(name.clone())),
            },
            _ => None,
        };
        let find = find.ok_or_else(|| {
            at("find", format!("{} is nothing to find", blank.find), "expected a quantity, such as `A.after.speed`")
        })?;
        let kind: Kind = blank.kind.parse().map_err(|_| {
            at("kind", format!("unknown kind of answer `{}`", blank.kind), "expected a kind such as `number`")
        })?;
        let accept: Accept = blank.accept.parse().map_err(|_| {
            at("accept", format!("unknown rule of acceptance `{}`", blank.accept), "expected a rule such as `awrt 3sf`")
        })?;
        let text = match &blank.exact {
            _ if printed.is_some() => printed.cloned().unwrap_or_default(),
            serde_json::Value::String(text) => text.clone(),
            serde_json::Value::Array(both) => {
                match (both.first().and_then(|x| x.as_str()), both.get(1).and_then(|y| y.as_str())) {
                    (Some(x), Some(y)) => format!("[{x}, {y}]"),
                    _ => String::new(),
                }
            }
            _ => String::new(),
        };
        let (quantity, letter) = match &find {
            Find::Quantity(quantity) => (Some(*quantity), None),
            Find::Vector(x, _) => (Some(*x), None),
            Find::Unknown(name) => (None, Some(name.clone())),
        };
        let letters = scene.letters.clone();
        let options = ModelOptions { kind: Some(kind), accept: Some(accept), letters, quantity, letter };
        let model = Model::read(&text, &options).map_err(|fault| at("exact", fault.message, &fault.expected))?;
        Ok(KeyedBlank { name: blank.name.clone(), find, model })
    }
}

/// A question that asks for a vector has **i** and **j** for its magnitude too: `|4i + j| = √17`.
pub(super) fn with_unit_vectors_throughout(parts: &mut [KeyedPart]) {
    let vectors = parts.iter().flat_map(|part| &part.blanks).any(|blank| blank.model.vocabulary.vectors);
    let numbers = parts.iter_mut().flat_map(|part| &mut part.blanks).map(|blank| &mut blank.model);
    for model in numbers.filter(|model| matches!(model.kind, Kind::Number | Kind::Angle)) {
        model.vocabulary.vectors |= vectors;
    }
}

/// The Greek letters by which the question calls what each blank asks, and what the others ask.
pub(super) fn with_the_letters_of_angles(parts: &mut [KeyedPart], unknowns: &[Letter]) {
    let mut blanks: Vec<&mut KeyedBlank> = parts.iter_mut().flat_map(|part| &mut part.blanks).collect();
    let letters: Vec<Option<String>> = blanks.iter().map(|blank| greek_letter(&blank.name)).collect();
    for (blank, own) in blanks.iter_mut().zip(&letters) {
        blank.model.angle.clone_from(own);
        let unknowns = unknowns.iter().map(|letter| letter.name().to_owned());
        let others = letters.iter().flatten().cloned().chain(unknowns);
        blank.model.other_angles = others.filter(|other| Some(other) != own.as_ref()).collect();
    }
}

/// The Greek letter in the name of a blank: `value of tan β`.
fn greek_letter(name: &str) -> Option<String> {
    let letters =
        [('α', "alpha"), ('β', "beta"), ('γ', "gamma"), ('δ', "delta"), ('θ', "theta"), ('φ', "phi"), ('ψ', "psi")];
    letters.into_iter().find(|(letter, _)| name.contains(*letter)).map(|(_, spelt)| spelt.to_owned())
}

/// The equation that was to be shown, where that is what is asked: the mark for it has both sides.
fn printed_result<'k>(blank: &Blank, part: &'k KeyPart) -> Option<&'k String> {
    let is_shown = blank.kind == Kind::Shown.name();
    let mut marks =
        part.scheme.iter().filter(|mark| mark.code == Code::A1Shown.name() && mark.blanks.contains(&blank.name));
    marks.find(|_| is_shown)?.equation.as_ref()
}

impl KeyedMark {
    fn read(mark: &KeyMark, part: &KeyPart, scene: &Scene) -> Result<KeyedMark, KeyFault> {
        let at = |field: &str, message: String, expected: &str| KeyFault {
            path: field.to_owned(),
            ..KeyFault::new(message, expected)
        };
        let code = Code::ALL.into_iter().find(|code| code.name() == mark.code);
        let code = code
            .ok_or_else(|| at("code", format!("unknown mark code `{}`", mark.code), "expected a code such as `M1`"))?;
        let unknowns: Vec<String> = scene.unknowns.iter().map(|letter| letter.name().to_owned()).collect();
        let earned_for = EarnedFor::read(&mark.earned_for, &unknowns)
            .ok_or_else(|| at("for", format!("unknown step `{}`", mark.earned_for), "expected a law or a quantity"))?;
        let place = |id: &String| part.scheme.iter().position(|other| other.id == *id);
        let depends = mark.depends.iter().map(|id| {
            place(id).ok_or_else(|| {
                at("depends", format!("no mark `{id}` in this part"), "expected the id of an earlier mark")
            })
        });
        let belongs = mark.blanks.iter().map(|name| {
            let found = part.blanks.iter().position(|blank| blank.name == *name);
            found.ok_or_else(|| at("blanks", format!("no blank `{name}` in this part"), "expected the name of a blank"))
        });
        // What is only approximately equal proves nothing.
        let equation = match mark.equation.as_ref().filter(|text| !text.contains('~')) {
            Some(text) => Some(
                read_range(text, Angles::Radians).map_err(|fault| at("equation", fault.message, &fault.expected))?,
            ),
            None => None,
        };
        Ok(KeyedMark {
            id: mark.id.clone(),
            code,
            earned_for,
            depends: depends.collect::<Result<_, _>>()?,
            blanks: belongs.collect::<Result<_, _>>()?,
            equation,
            stated: Default::default(),
        })
    }
}
