//! Reads a scene: every expression evaluated, every fault kept with its field.

mod contact;
mod letters;
mod then;

use std::collections::BTreeMap;

use letters::known_letters;

use super::Sphere;
use super::scene::{Condition, Given, Scene, Velocity};
use super::scene_text::{Pair, SceneText, VelocityText};
use super::setting::Setting;
use crate::expr::{
    Angles, Expr, Fault, Meaning, Relation, Span, Turn, degrees, evaluate, number, print, read, written,
};
use crate::number::{Angle, Letter, Range, Value};

/// A fault in one expression of a scene.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct SceneFault {
    /// Which one: `before.A.speed`.
    pub field: String,
    /// What is wrong with it; the span counts within that expression.
    pub fault: Fault,
    /// Is it wrong whatever the numbers are?
    pub is_of_the_form: bool,
}

/// Is it a decimal number? What was given as one is shown as one, also in the working.
fn is_decimal(expr: &Expr) -> bool {
    match expr {
        Expr::Decimal(_) => true,
        Expr::Negative(inner) => is_decimal(inner),
        _ => false,
    }
}

/// Formulas in a scene may not be longer than this; their derived quantities grow with the square.
const MOST_TERMS: usize = 40;

/// Each angle in degrees within one number doubles what there is to do, and so does each root within a root.
const MOST_ANGLES: usize = 4;
const MOST_DEPTH: u32 = 4;

/// How many angles in degrees stand in a value.
fn given_angles(value: &Value) -> usize {
    value.letters().iter().filter(|letter| letter.is_constant()).count()
}

impl Scene {
    /// Reads every expression of a scene. Names stand for parameters, or for the scene's letters;
    /// in the words of a bank question a bare trigonometric argument is in degrees.
    ///
    /// # Errors
    ///
    /// Every fault of the scene, each with the field it is in.
    pub fn read<S: AsRef<str>>(
        text: &SceneText<S>,
        parameters: &BTreeMap<String, Expr>,
        angles: Angles,
    ) -> Result<Scene, Vec<SceneFault>> {
        let mut reader = Reader { parameters, angles, letters: Vec::new(), faults: Vec::new() };
        let scene = reader.scene(text);
        if reader.faults.is_empty() { Ok(scene) } else { Err(reader.faults) }
    }
}

struct Reader<'a> {
    parameters: &'a BTreeMap<String, Expr>,
    angles: Angles,
    letters: Vec<Letter>,
    faults: Vec<SceneFault>,
}

impl Reader<'_> {
    fn scene<S: AsRef<str>>(&mut self, text: &SceneText<S>) -> Scene {
        self.declare(text);
        self.imply(text);
        let setting = self.setting(text);
        let masses = [(&text.masses.a, Sphere::A), (&text.masses.b, Sphere::B)]
            .map(|(mass, sphere)| self.optional(mass.as_ref(), &format!("masses.{}", sphere.name())));
        let mut before = self.velocities(&text.before, "before");
        let mut after = self.velocities(&text.after, "after");
        if setting == Setting::Wall {
            // The wall stands in the place of B.
            let at_rest = || Velocity::Components(Given::nought(), Given::nought());
            (before[1], after[1]) = (Some(at_rest()), Some(at_rest()));
        }
        let restitution = self.optional(text.e.as_ref(), "e");
        let contact = self.contact(text, setting);
        let impulse = text.impulse.as_ref().and_then(|impulse| self.pair(impulse, "impulse"));
        let unknowns = self.unknowns(text);
        let conditions = self.conditions(text);
        let maximise = text.maximise.as_ref().and_then(|name| {
            let found = name.as_ref().parse().ok();
            if found.is_none() {
                self.whole_fault(
                    "maximise",
                    name.as_ref(),
                    "unknown quantity",
                    "a quantity such as `A.tan_deflection`",
                );
            }
            found
        });
        let letters = self.letters.clone();
        let then = Vec::new();
        let mut scene = Scene {
            setting,
            masses,
            before,
            after,
            contact,
            impulse,
            restitution,
            letters,
            unknowns,
            conditions,
            maximise,
            then,
        };
        scene.then = self.then(text, &scene);
        scene
    }

    fn fault(&mut self, field: &str, fault: Fault) {
        self.faults.push(SceneFault { field: field.to_string(), fault, is_of_the_form: false });
    }

    /// A fault of what is there and what is not, whatever the numbers are.
    fn misfit(&mut self, field: &str, message: &str, expected: &str, help: &str) {
        let fault = Fault::new(message, Span::default(), expected).try_this(help);
        self.faults.push(SceneFault { field: field.to_string(), fault, is_of_the_form: true });
    }

    /// One thing to try about the last fault.
    fn help(&mut self, help: &str) {
        if let Some(SceneFault { fault, .. }) = self.faults.last_mut() {
            fault.help.get_or_insert_with(|| help.to_owned());
        }
    }

    /// A fault of a whole text.
    fn whole_fault(&mut self, field: &str, text: &str, message: &str, expected: &str) {
        let span = Span { start: 0, end: text.len() };
        self.fault(field, Fault::new(format!("{message} `{text}`"), span, expected));
    }

    fn expression(&mut self, text: &str, field: &str) -> Option<Expr> {
        match read(text, self.angles) {
            Ok(expr) => Some(expr.substitute(&|name| self.parameters.get(name).cloned())),
            Err(fault) => {
                self.fault(field, fault);
                None
            }
        }
    }

    fn value(&mut self, text: &str, field: &str) -> Option<Given> {
        let expr = self.expression(text, field)?;
        let letters = &self.letters;
        match number(&expr, &|name| meaning(letters, name)) {
            Ok(value) if value.terms() > MOST_TERMS => {
                self.whole_fault(field, text, "too long a formula", "a shorter one");
                None
            }
            Ok(value) if given_angles(&value) > MOST_ANGLES => {
                let expected = format!("sines, cosines and tangents of at most {MOST_ANGLES} angles");
                self.whole_fault(field, text, "too many different angles in one formula", &expected);
                self.help("write what it comes to as a decimal");
                None
            }
            Ok(value) if value.depth() > MOST_DEPTH => {
                let expected = format!("at most {MOST_DEPTH} roots, one within another");
                self.whole_fault(field, text, "too many roots within roots", &expected);
                self.help("write what it comes to as a decimal");
                None
            }
            Ok(value) => {
                let worked_out = value.as_fraction().is_some() && !is_decimal(&expr);
                let shown = if worked_out { written(&value) } else { expr };
                Some(Given { value, shown })
            }
            Err(fault) => {
                self.located(text, field, fault);
                None
            }
        }
    }

    /// A fault of evaluation; without a place of its own it is that of the whole text.
    fn located(&mut self, text: &str, field: &str, mut fault: Fault) {
        if fault.span == Span::default() {
            fault.span = Span { start: 0, end: text.len() };
        }
        if fault.message.starts_with("unknown name") && fault.help.is_none() {
            let known = known_letters(&self.letters);
            fault.help = Some(not_a_letter(text, &fault).unwrap_or(known));
        }
        self.fault(field, fault);
        self.help_with_number();
    }

    /// What to try about a number that does not exist.
    fn help_with_number(&mut self) {
        let message = self.faults.last().map_or("", |found| &found.fault.message);
        let help = match message {
            "division by nought" => "change what stands below the line, or leave the field out if it is not given",
            "the square root of a negative number" => "check the sign of what stands under the root",
            _ => return,
        };
        self.help(help);
    }

    fn optional<S: AsRef<str>>(&mut self, text: Option<&S>, field: &str) -> Option<Given> {
        self.value(text?.as_ref(), field)
    }

    /// Two components.
    fn pair<S: AsRef<str>>(&mut self, [x, y]: &[S; 2], field: &str) -> Option<[Given; 2]> {
        let x = self.value(x.as_ref(), &format!("{field}[0]"));
        let y = self.value(y.as_ref(), &format!("{field}[1]"));
        Some([x?, y?])
    }

    fn velocities<S: AsRef<str>>(&mut self, pair: &Pair<VelocityText<S>>, moment: &str) -> [Option<Velocity>; 2] {
        [(&pair.a, "A"), (&pair.b, "B")].map(|(velocity, sphere)| {
            let field = format!("{moment}.{sphere}");
            self.velocity(velocity.as_ref()?, &field)
        })
    }

    /// The components of a vector that was typed as one text, `4i + j`.
    fn vector_in_words(&self, text: &str) -> Option<[String; 2]> {
        let expr = read(text, self.angles).ok()?.substitute(&|name| self.parameters.get(name).cloned());
        match evaluate(&expr, &|name| meaning(&self.letters, name)) {
            Ok(Meaning::Vector(x, y)) => Some([x, y].map(|part| print::plain(&written(&part)))),
            _ => None,
        }
    }

    /// Is a velocity one number, along a line? A vector in one text is a fault of its own.
    fn is_along<S: AsRef<str>>(&self, velocity: &VelocityText<S>) -> bool {
        matches!(velocity, VelocityText::Along(text) if self.vector_in_words(text.as_ref()).is_none())
    }

    /// A fault of one number among vectors.
    fn along_among_others(&mut self, field: &str) {
        let expected = "expected `[\"x\", \"y\"]`, as the others are in a plane";
        let help = "give its components along i and along j; of a sphere at rest they are `[\"0\", \"0\"]`";
        self.misfit(field, "a velocity along a line among others in a plane", expected, help);
    }

    fn velocity<S: AsRef<str>>(&mut self, text: &VelocityText<S>, field: &str) -> Option<Velocity> {
        let polar = match text {
            VelocityText::Along(velocity) => {
                if let Some([x, y]) = self.vector_in_words(velocity.as_ref()) {
                    let expected = format!("`[\"{x}\", \"{y}\"]`");
                    self.whole_fault(field, velocity.as_ref(), "a vector in one text", &expected);
                    self.help("write the components along i and along j as a list of two texts");
                    return None;
                }
                return Some(Velocity::Components(self.value(velocity.as_ref(), field)?, Given::nought()));
            }
            VelocityText::Components(components) => {
                let [x, y] = self.pair(components, field)?;
                return Some(Velocity::Components(x, y));
            }
            VelocityText::Polar(polar) => polar,
        };
        let speed = self.value(polar.speed.as_ref(), &format!("{field}.speed"));
        if speed.as_ref().is_some_and(|speed| speed.value.sign().is_some_and(|sign| sign.is_lt())) {
            self.whole_fault(
                &format!("{field}.speed"),
                polar.speed.as_ref(),
                "a negative speed",
                "a speed, not negative",
            );
            self.help("leave the sign out, and turn the direction round by 180° if it is meant to be the opposite one");
        }
        match (&polar.angle_deg, &polar.cos, &polar.sin) {
            (Some(angle), None, None) => {
                let field = format!("{field}.angle_deg");
                let expr = self.expression(angle.as_ref(), &field)?;
                let letters = &self.letters;
                let turn = match degrees(&expr, &|name| meaning(letters, name)) {
                    Ok(turn) => turn,
                    Err(fault) => {
                        self.located(angle.as_ref(), &field, fault);
                        return None;
                    }
                };
                let Some(direction) = turn.direction() else {
                    self.whole_fault(&field, angle.as_ref(), "too finely given an angle", &at_most());
                    return None;
                };
                let speed = speed?;
                Some(Velocity::Polar { speed, cos: direction.cos, sin: direction.sin, angle: Some((turn, expr)) })
            }
            (None, Some(cos), Some(sin)) => {
                let cos = self.value(cos.as_ref(), &format!("{field}.cos"));
                let sin_given = self.value(sin.as_ref(), &format!("{field}.sin"));
                let (speed, cos, sin_value) = (speed?, cos?.value, sin_given?.value);
                if !(&(&cos * &cos) + &(&sin_value * &sin_value)).equals(&Value::ONE) {
                    let message = "the squares of cosine and sine do not add up to 1 with";
                    self.whole_fault(
                        &format!("{field}.sin"),
                        sin.as_ref(),
                        message,
                        "a sine that belongs to the cosine",
                    );
                    return None;
                }
                Some(Velocity::Polar { speed, cos, sin: sin_value, angle: None })
            }
            _ => {
                let expected = "`angle_deg`, or both `cos` and `sin`";
                self.whole_fault(field, polar.speed.as_ref(), "a speed without one direction", expected);
                None
            }
        }
    }

    /// Letters to be found.
    fn unknowns<S: AsRef<str>>(&mut self, text: &SceneText<S>) -> Vec<Letter> {
        let mut unknowns = Vec::new();
        for (index, name) in text.unknowns.iter().enumerate() {
            let name = name.as_ref();
            match self.letters.iter().find(|letter| letter.name() == name).copied() {
                Some(letter) if unknowns.contains(&letter) => {
                    let field = format!("unknowns[{index}]");
                    self.whole_fault(&field, name, "the unknown is named twice:", "each letter once");
                }
                Some(letter) => unknowns.push(letter),
                None => {
                    let field = format!("unknowns[{index}]");
                    self.whole_fault(
                        &field,
                        name,
                        "unknown letter",
                        "a letter of `symbols`, `e`, `A.mass` or `B.mass`",
                    );
                }
            }
        }
        unknowns
    }

    fn conditions<S: AsRef<str>>(&mut self, text: &SceneText<S>) -> Vec<Condition> {
        let mut conditions = Vec::new();
        for (index, condition) in text.conditions.iter().enumerate() {
            let field = format!("conditions[{index}]");
            match self.expression(condition.as_ref(), &field) {
                Some(Expr::Relation(left, relation, right)) if relation != Relation::NotEqual => {
                    conditions.push(Condition { left: *left, relation, right: *right });
                }
                Some(_) => self.whole_fault(
                    &field,
                    condition.as_ref(),
                    "no equation or inequality in",
                    "two quantities with `=`, `<`, `<=`, `>` or `>=` between them",
                ),
                None => {}
            }
        }
        conditions
    }
}

/// What stands straight behind a number and was hardly meant as a letter: a unit, or a power of ten as calculators write it.
fn not_a_letter(text: &str, fault: &Fault) -> Option<String> {
    const UNITS: [&str; 12] = ["kg", "g", "m", "cm", "mm", "km", "s", "ms", "h", "N", "Ns", "J"];
    let (before, name) = (text.get(..fault.span.start)?, text.get(fault.span.start..fault.span.end)?);
    if !before.trim_end().ends_with(|c: char| c.is_ascii_digit()) {
        return None;
    }
    let power = name.strip_prefix(['e', 'E']).filter(|_| before.ends_with(|c: char| c.is_ascii_digit()));
    if power.is_some_and(|digits| digits.bytes().all(|byte| byte.is_ascii_digit())) {
        return Some("write a power of ten as `5*10^2` or `5*10^(-2)`, or the number as a decimal".to_owned());
    }
    let unit = UNITS.contains(&name);
    unit.then(|| "leave the unit out: masses are in kg, speeds in m/s, impulses in N s, angles in degrees".to_owned())
}

/// How long a name, of a letter or of an angle in degrees, may be.
fn at_most() -> String {
    format!("at most {} characters", Letter::LONGEST)
}

/// What a letter of the scene stands for in an expression.
pub(crate) fn meaning(letters: &[Letter], name: &str) -> Option<Meaning> {
    let letter = letters.iter().find(|letter| letter.name() == name)?;
    Some(match letter.range() {
        Range::Acute => Meaning::Angle(Turn::of(Angle::of(&Value::letter(*letter), &Value::ONE)?)),
        _ => Meaning::Number(Value::letter(*letter)),
    })
}
