//! Reads a scene: every expression evaluated, every fault kept with its field.

mod contact;
mod formulas;
mod letters;
mod then;
mod velocities;

use std::fmt::Display;
use std::rc::Rc;

use letters::known_letters;

use super::scene::{Condition, Given, Scene, Velocity};
use super::scene_text::SceneText;
use super::setting::Setting;
use super::{Sphere, name_meant};
use crate::expr::{Angles, Expr, Fault, Meaning, Relation, Span, Turn, number, written};
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

/// Formulas in a scene may not be longer than this; their derived quantities grow with the square.
const MOST_TERMS: usize = 40;

/// Each angle in degrees within one number doubles what there is to do, and so does each root within a root.
const MOST_ANGLES: usize = 4;
const MOST_DEPTH: u32 = 4;

/// So many different roots a vector may have of whose direction a unit vector is made: each more doubles that vector.
const MOST_ROOTS: usize = 5;

/// How many angles in degrees stand in a value.
fn given_angles(value: &Value) -> usize {
    value.letters().iter().filter(|letter| letter.is_constant()).count()
}

/// What names in a scene stand for that are no letters of it: the parameters of a question, with the numbers of a variant.
/// A scene on its own has none, and is read with `&()`.
pub trait Parameters {
    /// A parameter as it is printed.
    fn shown(&self, name: &str) -> Option<&Expr>;

    /// What it stands for.
    fn meaning(&self, name: &str) -> Option<Meaning>;
}

impl Parameters for () {
    fn shown(&self, _: &str) -> Option<&Expr> {
        None
    }

    fn meaning(&self, _: &str) -> Option<Meaning> {
        None
    }
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
        parameters: &dyn Parameters,
        angles: Angles,
    ) -> Result<Scene, Vec<SceneFault>> {
        let mut reader = Reader { parameters, angles, letters: Vec::new(), faults: Vec::new() };
        let scene = reader.scene(text);
        if reader.faults.is_empty() { Ok(scene) } else { Err(reader.faults) }
    }
}

struct Reader<'a> {
    parameters: &'a dyn Parameters,
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
            .map(|(mass, sphere)| self.optional(mass.as_ref(), format_args!("masses.{}", sphere.name())));
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
                let (label, help) = name_meant(name.as_ref(), &[]);
                self.whole_fault("maximise", name.as_ref(), "unknown quantity", label);
                self.help(&help);
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

    /// A formula as it stands, in names.
    fn formula(&mut self, text: &str, field: impl Display) -> Option<Rc<Expr>> {
        match formulas::read(text, self.angles) {
            Ok(expr) => Some(expr),
            Err(fault) => {
                self.fault(&field.to_string(), fault);
                None
            }
        }
    }

    /// The same with parameters as they are printed.
    fn filled(&self, formula: &Expr) -> Expr {
        formula.substitute(&|name| self.parameters.shown(name).cloned())
    }

    /// What a name stands for.
    fn meaning(&self, name: &str) -> Option<Meaning> {
        self.parameters.meaning(name).or_else(|| meaning(&self.letters, name))
    }

    /// Is it a decimal number? What was given as one is shown as one, also in the working.
    fn is_decimal(&self, formula: &Expr) -> bool {
        match formula {
            Expr::Decimal(_) => true,
            Expr::Negative(inner) => self.is_decimal(inner),
            Expr::Name(name) => self.parameters.shown(&name.text).is_some_and(|shown| self.is_decimal(shown)),
            _ => false,
        }
    }

    /// What a text comes to. The name of its field is made where it must be told.
    fn value(&mut self, text: &str, field: impl Display) -> Option<Given> {
        let formula = self.formula(text, &field)?;
        match number(&formula, &|name| self.meaning(name)) {
            Ok(value) if !is_too_much(&value) => {
                let worked_out = value.as_fraction().is_some() && !self.is_decimal(&formula);
                let shown = if worked_out { written(&value) } else { self.filled(&formula) };
                Some(Given { value, shown })
            }
            Ok(value) => {
                self.too_much(text, &field.to_string(), &value);
                None
            }
            Err(fault) => {
                self.located(text, &field.to_string(), fault);
                None
            }
        }
    }

    /// A fault of a text that comes to more than is worked with.
    fn too_much(&mut self, text: &str, field: &str, value: &Value) {
        if value.terms() > MOST_TERMS {
            return self.whole_fault(field, text, "too long a formula", "a shorter one");
        }
        if given_angles(value) > MOST_ANGLES {
            let expected = format!("sines, cosines and tangents of at most {MOST_ANGLES} angles");
            self.whole_fault(field, text, "too many different angles in one formula", &expected);
        } else {
            let expected = format!("at most {MOST_DEPTH} roots, one within another");
            self.whole_fault(field, text, "too many roots within roots", &expected);
        }
        self.help("write what it comes to as a decimal");
    }

    /// Is a vector one whose direction would take minutes? That is a fault of the second component, with this text.
    fn has_too_many_roots(&mut self, [x, y]: [&Value; 2], text: &str, field: &str) -> bool {
        let of_x = x.roots();
        let of_y = y.roots();
        let roots: Vec<_> = of_x.iter().chain(of_y.iter().filter(|root| !of_x.contains(root))).collect();
        let are_too_many = roots.len() > MOST_ROOTS;
        if are_too_many {
            let expected = format!("at most {MOST_ROOTS} different roots in both components");
            self.whole_fault(field, text, "too many different roots in one vector", &expected);
            self.help("write what it comes to as a decimal");
        }
        are_too_many
    }

    /// A fault of evaluation; without a place of its own it is that of the whole text.
    fn located(&mut self, text: &str, field: &str, mut fault: Fault) {
        if fault.span == Span::default() {
            fault.span = Span { start: 0, end: text.len() };
        }
        let is_unknown = fault.message.starts_with("unknown name") && fault.help.is_none();
        if let Some(function) = Fault::unknown_function(text, fault.span).filter(|_| is_unknown) {
            fault = function;
        } else if is_unknown {
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

    fn optional<S: AsRef<str>>(&mut self, text: Option<&S>, field: impl Display) -> Option<Given> {
        self.value(text?.as_ref(), field)
    }

    /// Two components.
    fn pair<S: AsRef<str>>(&mut self, [x, y]: &[S; 2], field: impl Display) -> Option<[Given; 2]> {
        let x = self.value(x.as_ref(), format_args!("{field}[0]"));
        let y = self.value(y.as_ref(), format_args!("{field}[1]"));
        Some([x?, y?])
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
                    self.help("take it out here");
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
                    self.help(&format!("declare it in `symbols`, as in `{name} = \"positive\"`, or name one of those"));
                }
            }
        }
        unknowns
    }

    fn conditions<S: AsRef<str>>(&mut self, text: &SceneText<S>) -> Vec<Condition> {
        let mut conditions = Vec::new();
        for (index, condition) in text.conditions.iter().enumerate() {
            let field = format_args!("conditions[{index}]");
            let condition_formula = self.formula(condition.as_ref(), field);
            match condition_formula.map(|formula| self.filled(&formula)) {
                Some(Expr::Relation(left, relation, right)) if relation != Relation::NotEqual => {
                    conditions.push(Condition { left: *left, relation, right: *right });
                }
                Some(other) => {
                    self.whole_fault(
                        &field.to_string(),
                        condition.as_ref(),
                        "no equation or inequality in",
                        "two quantities with `=`, `<`, `<=`, `>` or `>=` between them",
                    );
                    self.help(match other {
                        Expr::Relation(..) => "write `<` or `>`, whichever is meant: `!=` leaves a value on both sides",
                        _ => "write what it is equal to, as in `A.after.speed = 3`",
                    });
                }
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

/// Is a value more than is worked with?
fn is_too_much(value: &Value) -> bool {
    value.terms() > MOST_TERMS || given_angles(value) > MOST_ANGLES || value.depth() > MOST_DEPTH
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
