//! A model answer from its text: plain ASCII in radians, as the exchange formats have it.

use crate::answer::{Accept, Kind};
use crate::expr::{Angles, Expr, Fault, Function, Meaning, Relation, Span, evaluate, read, read_range};
use crate::mark::reading::Vocabulary;
use crate::mechanics::Quantity;
use crate::number::{Letter, Places, Range};

use super::{Model, exact};

/// What is said of a model answer besides its value.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ModelOptions {
    /// Its kind; left out, it is inferred from the value.
    pub kind: Option<Kind>,
    /// The rule of acceptance; left out, `awrt 3sf` for numbers and `exact` for letters.
    pub accept: Option<Accept>,
    /// Letters whose range is declared.
    pub letters: Vec<Letter>,
    /// What is asked for, if that is known.
    pub quantity: Option<Quantity>,
    /// The letter that is to be found, where one is.
    pub letter: Option<String>,
}

/// Words after the size of a velocity that say its direction.
const ALONG: [&str; 2] = ["along the line of centres", "parallel to the line of centres"];
const ACROSS: [&str; 2] = ["perpendicular to the line of centres", "along the common tangent"];

/// Names that are angles, by the custom of the subject.
const ANGLES: [&str; 7] = ["alpha", "beta", "gamma", "delta", "theta", "phi", "psi"];

impl Model {
    /// Reads a model answer. Letters that are not declared are acute where they are angles, from 0 to 1 if they are `e`,
    /// and else positive.
    ///
    /// ```
    /// use carom::answer::Kind;
    /// use carom::mark::judging::{Model, ModelOptions};
    /// let model = Model::read("4*i + j", &ModelOptions::default()).unwrap();
    /// assert_eq!(model.kind, Kind::Vector);
    /// assert_eq!(Model::read("2*(3", &ModelOptions::default()).unwrap_err().message, "`(` is never closed");
    /// ```
    ///
    /// # Errors
    ///
    /// A text that cannot be read or has no exact value, or a value that is not of the kind asked for.
    pub fn read(text: &str, options: &ModelOptions) -> Result<Model, Fault> {
        // An inequality for one letter is a range unless it is said to be something else.
        let range =
            (options.kind.is_none() && text.contains(['<', '>']) && is_for_one_letter(text)).then_some(Kind::Range);
        let options = &ModelOptions { kind: options.kind.or(range), ..options.clone() };
        let value = match options.kind {
            Some(Kind::Velocity) => velocity(text)?,
            Some(Kind::Range) => read_range(text, Angles::Radians)?,
            _ => read(text, Angles::Radians)?,
        };
        let whole = Span { start: 0, end: text.len() };
        let mut letters = options.letters.clone();
        declare(&value, false, &mut letters, whole)?;
        let inferred = infer(&value, &letters).map_err(|fault| placed(fault, whole))?;
        // A number of degrees, where an angle is asked.
        let is_angle = inferred == Kind::Number && options.quantity.is_some_and(Quantity::is_angle);
        let kind = options.kind.unwrap_or(if is_angle { Kind::Angle } else { inferred });
        fits(kind, inferred, whole)?;
        let lettered = letters.iter().any(|letter| value.names().iter().any(|name| name.text == letter.name()));
        let accept = options.accept.clone().unwrap_or(
            match lettered || matches!(kind, Kind::Shown | Kind::Equation | Kind::Range) {
                true => Accept::Exact,
                false => Accept::RoundsTo(Places::SignificantFigures(3)),
            },
        );
        let vectors = matches!(kind, Kind::Vector | Kind::Line) || inferred == Kind::Vector;
        let from_i = matches!(options.quantity, Some(Quantity::AngleFromI(..) | Quantity::ImpulseAngle));
        let vectors = (vectors || from_i) && kind != Kind::Velocity;
        let model = Model::new(value, kind, accept, Vocabulary { letters, vectors });
        // An answer is judged alike of whichever impact it is.
        let quantity = options.quantity.map(Quantity::of_its_impact);
        let is_of_both = quantity.is_some_and(Quantity::is_of_all);
        Ok(Model { quantity, letter: options.letter.clone(), is_of_both, ..model })
    }
}

fn is_for_one_letter(inequality: &str) -> bool {
    read_range(inequality, Angles::Radians).is_ok_and(|value| {
        let names = value.names();
        names.first().is_some_and(|first| names.iter().all(|name| name.text == first.text))
    })
}

/// A velocity may end in words: `6*sin(10*deg) perpendicular to the line of centres`.
fn velocity(text: &str) -> Result<Expr, Fault> {
    let size = |words: &str| text.trim_end().strip_suffix(words).map(|size| read(size, Angles::Radians));
    let nought = || Box::new(Expr::integer(0));
    if let Some(size) = ALONG.iter().find_map(|words| size(words)) {
        return Ok(Expr::Vector(Box::new(size?), nought()));
    }
    if let Some(size) = ACROSS.iter().find_map(|words| size(words)) {
        return Ok(Expr::Vector(nought(), Box::new(size?)));
    }
    read(text, Angles::Radians)
}

/// Declares the letters that are not: acute under a sine, `e` from 0 to 1, else positive.
fn declare(expr: &Expr, in_angle: bool, letters: &mut Vec<Letter>, whole: Span) -> Result<(), Fault> {
    if let Expr::Name(name) = expr {
        let known = letters.iter().any(|letter| letter.name() == name.text);
        if known || matches!(name.text.as_str(), "i" | "j") {
            return Ok(());
        }
        let range = match name.text.as_str() {
            angle if in_angle || ANGLES.contains(&angle) => Range::Acute,
            "e" => Range::Unit,
            _ => Range::Positive,
        };
        let letter = Letter::new(&name.text, range);
        let long = || {
            let expected = format!("at most {} characters", Letter::LONGEST);
            placed(Fault::new(format!("the name `{}` is too long", name.text), name.span, expected), whole)
        };
        letters.push(letter.ok_or_else(long)?);
        return Ok(());
    }
    let in_angle = in_angle || matches!(expr, Expr::Call(Function::Sin | Function::Cos | Function::Tan, _));
    expr.children().into_iter().try_for_each(|child| declare(child, in_angle, letters, whole))
}

/// The kind that a value is of, or why it has none.
fn infer(value: &Expr, letters: &[Letter]) -> Result<Kind, Fault> {
    let names = |name: &str| exact::meaning_of(letters, name);
    if let Expr::Relation(left, relation, right) = value {
        match &**left {
            // Two relations in a row, of a range.
            Expr::Relation(low, _, middle) => evaluate(low, &names).and_then(|_| evaluate(middle, &names))?,
            left => evaluate(left, &names)?,
        };
        evaluate(right, &names)?;
        assert!(!matches!(relation, Relation::Implies | Relation::Approximately), "these are never read");
        return Ok(Kind::Equation);
    }
    match evaluate(value, &names)? {
        Meaning::Vector(..) => Ok(Kind::Vector),
        Meaning::Angle(_) if is_multiple_of_pi(value) => Ok(Kind::Number),
        Meaning::Angle(_) | Meaning::Degrees(_) => Ok(Kind::Angle),
        Meaning::Number(number) if number.is_constant() => Ok(Kind::Number),
        Meaning::Number(_) => Ok(Kind::Expression),
        Meaning::OverPi(_) => Err(Fault::new("one over pi has no use here", Span::default(), "a value")),
    }
}

/// Is it a number such as `2*pi/3`, which nobody calls an angle unless asked for one?
fn is_multiple_of_pi(value: &Expr) -> bool {
    match value {
        Expr::Pi => true,
        Expr::Name(_) | Expr::Call(..) | Expr::Degrees(_) => false,
        _ => value.children().into_iter().any(is_multiple_of_pi) && value.names().is_empty() && !has_degrees(value),
    }
}

fn has_degrees(value: &Expr) -> bool {
    matches!(value, Expr::Degrees(_) | Expr::Call(..)) || value.children().into_iter().any(has_degrees)
}

/// Can a value that looks like one kind be of the other?
fn fits(kind: Kind, inferred: Kind, whole: Span) -> Result<(), Fault> {
    let possible = match kind {
        Kind::Number | Kind::Expression => matches!(inferred, Kind::Number | Kind::Expression | Kind::Angle),
        Kind::Angle => matches!(inferred, Kind::Angle | Kind::Number),
        Kind::Vector => inferred == Kind::Vector,
        Kind::Velocity | Kind::Ratio | Kind::Line => matches!(inferred, Kind::Vector | Kind::Number | Kind::Expression),
        Kind::Equation | Kind::Range => inferred == Kind::Equation,
        Kind::Shown => true,
    };
    if possible {
        return Ok(());
    }
    let message = format!("the model is of kind `{}`, not `{}`", inferred.name(), kind.name());
    let expected = match kind {
        Kind::Vector => "a vector, such as `4*i + j`",
        Kind::Equation => "an equation, such as `v = 2*u`",
        Kind::Range => "a range, such as `1/3 < e <= 1` or `k > 2`",
        Kind::Angle => "an angle, such as `atan(7)` or a number of degrees",
        _ => "a number or formula",
    };
    Err(Fault::new(message, whole, expected).try_this("leave the kind out, and it is inferred"))
}

/// A fault of the expression as a whole is shown under all of it.
fn placed(fault: Fault, whole: Span) -> Fault {
    if fault.span == Span::default() { Fault { span: whole, ..fault } } else { fault }
}
