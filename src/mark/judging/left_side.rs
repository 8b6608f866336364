//! What stands left of an equals sign: a name of what is asked, an equation for it, or something else.
//!
//! * A single name, words, or what the quantity is made of (`E_1 − E_2` for an energy lost) name what stands on the right.
//! * An expression in one letter that can be what is asked is an equation: `2v = 17.9`, `90 − θ = 26.6`, `1/e = 14/11`. It
//!   must be true of the right value, and then the last step is still missing. Sums and signs are undone first, so that the
//!   figures are those of the value itself; what is left is worked out for the right value and compared.
//! * Anything else, as `v_A/v_B`, is the name of something else.

use std::cell::OnceCell;

use crate::answer::Kind;
use crate::expr::{Expr, Function, Relation};
use crate::mark::reading::{Form, Label, Said, SaidUnit};
use crate::mechanics::{Quantity, Sphere};
use crate::number::{Places, round};

use super::accuracy::Written;
use super::exact::{self, Equality};
use super::finding::Finding;
use super::multiplied::SQUARED;
use super::statements::One;
use super::{Model, Note, angle, changes, moments, number, vector};
use super::{called, letters, sorts, spheres};

/// What the left side is to the value on the right.
pub(super) enum Left {
    /// Its name.
    Name,
    /// A name, or else the power of one: `v2`.
    NameOrPower(Equation),
    /// An expression in what is asked.
    Equation(Equation),
    /// The name of something else.
    Another,
}

/// An expression in one letter that stands for what is asked.
pub(super) struct Equation {
    left: Expr,
    unknown: String,
    /// What the left side is for the right value, worked out once for all the values of a chain.
    of_right: OnceCell<Model>,
}

/// What a label is where this is asked.
pub(super) fn of(model: &Model, label: &Label) -> Left {
    if !matches!(model.kind, Kind::Number | Kind::Expression | Kind::Angle | Kind::Vector) {
        return Left::Name;
    }
    let typed = label.typed.trim();
    let Some(expr) = &label.expr else {
        // `speed² = 80`
        let of_square = SQUARED.iter().find_map(|power| typed.strip_suffix(power));
        let is_speed = |word: &str| word.to_lowercase().contains("speed") || word.to_lowercase().contains("velocity");
        if of_square.is_some_and(|word| is_speed(word) && called::words_fit(model, word.trim())) {
            let unknown = "x".to_owned();
            return Left::Equation(Equation::of(Expr::name(&unknown).to_the(2), unknown));
        }
        return if called::words_fit(model, typed) { Left::Name } else { Left::Another };
    };
    // `ΔE`, but no `Δv`
    if changes::is_change(typed) {
        let is_of_motion = matches!(model.quantity, Some(Quantity::Speed(..) | Quantity::Velocity(..)));
        // An impulse is a change of mv.
        let is_of_speed = typed.trim_start_matches(['Δ', 'δ', '∆', ' ']).starts_with(['v', 'V', 'u']);
        let is_impulse = matches!(model.quantity, Some(Quantity::Impulse(..) | Quantity::ImpulseMagnitude));
        return if is_of_motion || is_impulse && is_of_speed { Left::Another } else { Left::Name };
    }
    // `T_2`: what there is at one moment, and not what is lost.
    if model.quantity.is_some_and(sorts::is_of_change) && moments::is_energy_of_one(typed) {
        return Left::Another;
    }
    match expr {
        // `|−1|`
        number if number.names().is_empty() => Left::Name,
        Expr::Name(name) => match letters::may_be_called(model, &name.text, typed) {
            true => Left::Name,
            false => Left::Another,
        },
        // What is asked may be the sine or the tangent itself.
        _ if model.quantity.is_none() && model.kind != Kind::Angle && is_ratio_of_angle(expr) => Left::Name,
        Expr::Call(Function::Abs, inner) if matches!(**inner, Expr::Name(_)) => Left::Name,
        Expr::Call(Function::Tan, angle) if is_tangent(model.quantity) && names_an_angle(model, angle) => Left::Name,
        Expr::Call(_, angle) if is_deflection(model.quantity) && matches!(**angle, Expr::Sum(_)) => Left::Name,
        _ if is_of_others(model.quantity, expr) => Left::Name,
        _ => match unknown(model, expr) {
            // `v2`: a subscript, or the raised two of another keyboard.
            Some(equation) if is_name_and_digit(typed) => Left::NameOrPower(equation),
            Some(equation) => Left::Equation(equation),
            None => Left::Another,
        },
    }
}

/// The equation that is said without a name, in the one letter of the question that can be what is asked: `2k = 16`.
pub(super) fn unnamed<'s>(model: &Model, said: &'s Said) -> Option<(Equation, &'s Expr)> {
    let Form::Equation(Expr::Relation(left, Relation::Equal, right)) = &said.form else { return None };
    let equation =
        unknown(model, left).filter(|_| matches!(model.kind, Kind::Number | Kind::Expression | Kind::Angle))?;
    let is_solved = right.names().iter().all(|name| is_given(model, &name.text));
    is_solved.then_some((equation, &**right))
}

fn is_name_and_digit(typed: &str) -> bool {
    let mut signs = typed.chars();
    let letter = signs.next().is_some_and(char::is_alphabetic);
    letter && signs.next().is_some_and(|sign| sign.is_ascii_digit()) && signs.next().is_none()
}

/// Is the tangent of an angle asked?
pub(super) fn is_tangent(asked: Option<Quantity>) -> bool {
    use Quantity::{TOverN, TanDeflection, TanToLine, TanToWall};
    matches!(asked, Some(TanDeflection(_) | TanToLine(..) | TOverN(..) | TanToWall(..)))
}

/// The sum or difference of two angles may be the one that is asked.
fn is_deflection(asked: Option<Quantity>) -> bool {
    matches!(asked, Some(Quantity::Deflection(_) | Quantity::SignedDeflection(_)))
}

/// An angle by its letter, which the question has not given, or as a sum of such: `tan β`, `tan(β − α)`.
fn names_an_angle(model: &Model, angle: &Expr) -> bool {
    match angle {
        Expr::Name(name) => !is_given(model, &name.text) && !letters::is_of_another_angle(model, &name.text),
        Expr::Sum(terms) => terms.len() == 2 && terms.iter().all(|term| matches!(unsigned(term), Expr::Name(_))),
        _ => false,
    }
}

fn unsigned(term: &Expr) -> &Expr {
    match term {
        Expr::Negative(inner) => inner,
        other => other,
    }
}

/// A letter of the question in which the value is: of others nobody knows but that they may be what is asked.
pub(super) fn is_given(model: &Model, name: &str) -> bool {
    let is_of_value = || model.value.names().iter().any(|own| own.text == name);
    model.vocabulary.letters.iter().any(|letter| letter.name() == name) && is_of_value()
}

fn distinct(expr: &Expr) -> Vec<String> {
    let mut names: Vec<String> = expr.names().iter().map(|name| name.text.clone()).collect();
    names.sort();
    names.dedup();
    names
}

/// Is it called by what it is made of: `E_1 − E_2` for an energy lost?
pub(in crate::mark) fn is_made_of_others(model: &Model, label: &Label) -> bool {
    label.expr.as_ref().is_some_and(|expr| is_of_others(model.quantity, expr))
}

/// Formulas that say what is asked by other quantities: separation over approach, energy before less energy after.
fn is_of_others(asked: Option<Quantity>, expr: &Expr) -> bool {
    use Quantity::*;
    let Some(asked) = asked else { return false };
    let count = distinct(expr).len();
    let is_difference = |expr: &Expr| match expr {
        Expr::Sum(terms) => terms.iter().any(|term| matches!(term, Expr::Negative(_))),
        _ => false,
    };
    let has_difference = |expr: &Expr| is_difference(expr) || expr.children().into_iter().any(is_difference);
    match (asked, expr) {
        (Restitution, Expr::Quotient(above, below)) => {
            let is_of_speeds = |name: &String| name.starts_with(['v', 'u', 'w', 'V', 'x', 'y', 's', 'a']);
            distinct(above).iter().all(is_of_speeds) && distinct(below).iter().all(is_of_speeds) && count > 1
        }
        (FractionLost, Expr::Quotient(above, below)) => is_difference(above) || is_loss_of_start(above, below),
        (FractionLost, Expr::Sum(_)) => count > 1 && is_difference(expr),
        (MassRatio | TanToLine(..) | TOverN(..) | TanToWall(..) | TanDeflection(_), Expr::Quotient(..)) => count > 1,
        (EnergyLost | SphereEnergyLost(_) | SphereEnergyGained(_) | Separation | Approach, _) => {
            count > 1 && has_difference(expr)
        }
        (Impulse(..) | ImpulseMagnitude, Expr::Sum(_)) => count > 1 && is_difference(expr),
        (Impulse(..) | ImpulseMagnitude, Expr::Product(_)) => {
            distinct(expr).iter().any(|name| name.starts_with(['m', 'M'])) && count > 1
        }
        (KineticEnergy(..) | TotalEnergy(_), _) => {
            distinct(expr).iter().any(|name| name.starts_with(['m', 'M'])) && count > 1
        }
        (Speed(..), Expr::Call(Function::Sqrt, _)) => count > 1,
        (Velocity(..), Expr::Product(factors)) => {
            let is_share = |factor: &Expr| matches!(factor, Expr::Call(Function::Sin | Function::Cos, _));
            factors.iter().any(is_share) && count > 1
        }
        (Deflection(_) | SignedDeflection(_) | AngleBetween(_), Expr::Sum(terms)) => {
            terms.len() == 2 && terms.iter().all(|term| matches!(unsigned(term), Expr::Name(_)))
        }
        _ => false,
    }
}

/// `KE_lost/KE_before`, and not the other way round.
fn is_loss_of_start(above: &Expr, below: &Expr) -> bool {
    let (Expr::Name(above), Expr::Name(below)) = (above, below) else { return false };
    let [above, below] = [above, below].map(|name| name.text.to_lowercase());
    let is_energy = |name: &String| name.starts_with(['k', 'e', 't']);
    let has = |name: &str, words: &[&str]| words.iter().any(|word| name.contains(word));
    let is_start = has(&below, &moments::EARLIER) || has(&below, &["total", "_i", "_1"]);
    [&above, &below].into_iter().all(is_energy)
        && has(&above, &["lost", "loss"])
        && is_start
        && !has(&below, moments::AT_THE_END)
}

/// The one letter of the expression that the question does not give, if it can be what is asked.
fn unknown(model: &Model, expr: &Expr) -> Option<Equation> {
    let own: Vec<String> = distinct(expr).into_iter().filter(|name| !is_given(model, name)).collect();
    let [unknown] = own.as_slice() else { return None };
    let is_angle = is_tangent(model.quantity) && has_function(expr) && !letters::is_of_another_angle(model, unknown);
    let fits = is_angle || letters::may_be_called(model, unknown, unknown);
    fits.then(|| Equation::of(expr.clone(), unknown.clone()))
}

/// `tan β`, `tan²θ`
fn is_ratio_of_angle(expr: &Expr) -> bool {
    match expr {
        Expr::Power(base, _) => is_ratio_of_angle(base),
        Expr::Call(Function::Sin | Function::Cos | Function::Tan, angle) => !angle.names().is_empty(),
        _ => false,
    }
}

fn has_function(expr: &Expr) -> bool {
    matches!(expr, Expr::Call(Function::Sin | Function::Cos | Function::Tan, _))
        || expr.children().into_iter().any(has_function)
}

/// What is still to be done once an equation is true.
fn step_left(expr: &Expr, atom: &dyn Fn(&Expr) -> bool) -> Option<Note> {
    if atom(expr) {
        return None;
    }
    let own = match expr {
        Expr::Power(..) => Some(Note::SquareLeft),
        Expr::Call(Function::Sin | Function::Cos | Function::Tan, _) => Some(Note::RatioOfAngle),
        Expr::Call(..) => Some(Note::Unsolved),
        _ => None,
    };
    let inner = expr.children().into_iter().filter(|child| !child.names().is_empty());
    match (own, inner.filter_map(|child| step_left(child, atom)).next()) {
        (Some(_), Some(_)) => Some(Note::Unsolved),
        (own, inner) => own.or(inner),
    }
}

impl Equation {
    fn of(left: Expr, unknown: String) -> Equation {
        Equation { left, unknown, of_right: OnceCell::new() }
    }

    /// `v + eu` where w is asked, `w - eu` where v is: what it is called by restitution, in the letter that custom gives the other
    /// sphere.
    pub(super) fn is_by_restitution(&self, model: &Model) -> bool {
        let Expr::Sum(terms) = &self.left else { return false };
        let is_taken = |term: &Expr| matches!(term, Expr::Negative(_));
        let (letter, rest): (Vec<&Expr>, Vec<&Expr>) =
            terms.iter().partition(|term| matches!(unsigned(term), Expr::Name(name) if name.text == self.unknown));
        let of_b = model.quantity.and_then(spheres::sphere) == Some(Sphere::B);
        spheres::is_of_the_other_by_custom(model, &self.unknown)
            && !letter.is_empty()
            && letter.iter().all(|letter| !is_taken(letter))
            && rest.iter().all(|term| is_taken(term) != of_b)
    }

    /// Is the equation true of what is asked, and solved but for arithmetic?
    pub(super) fn judge(&self, model: &Model, said: &Said, one: One) -> Finding {
        let (left, form, unit) = self.peeled(said);
        let said = &Said { form, unit, ..said.clone() };
        if matches!(&left, Expr::Name(_)) {
            return unsolved_if(has_sum(&self.left), one(said, None));
        }
        let is_atom = |expr: &Expr| match expr {
            Expr::Name(_) => true,
            Expr::Call(Function::Tan, angle) if is_tangent(model.quantity) => matches!(**angle, Expr::Name(_)),
            _ => false,
        };
        let right = match model.kind {
            Kind::Angle => angle::in_turns(model),
            _ if is_tangent(model.quantity) && has_function(&left) => Expr::call(Function::Atan, model.value.clone()),
            _ => model.value.clone(),
        };
        let of_right = left.substitute(&|name| (name == self.unknown).then(|| right.clone()));
        // Sums are undone for numbers alone, so that the left side is nearly always the same.
        let worked_out = match self.of_right.get_or_init(|| model.of_value(of_right.clone())) {
            known if known.value == of_right => known.clone(),
            _ => model.of_value(of_right),
        };
        let finding = match (model.kind, &said.form) {
            (Kind::Vector, _) => vector::judge(&worked_out, said),
            (Kind::Angle, _) if !has_function(&left) => angle::judge(&worked_out, said, None),
            (_, Form::Value(value)) => {
                number::value(&Model { kind: Kind::Number, ..worked_out }, value, &Written::of(value))
            }
            _ => Finding::WRONG,
        };
        // `v − v = 0` is true whatever v is.
        if finding.is_credited() && !self.tells_apart(model, &left, &right) {
            return Finding::unreadable(Note::CannotBeCompared);
        }
        // A sum inside may swallow figures.
        let swallows = has_sum(&left) && !finding.exact && finding.is_credited();
        // `(k − 8)(k + 24) = 0` may be true of other values too.
        let is_gathered = left.names().iter().filter(|name| name.text == self.unknown).count() < 2;
        match step_left(&left, &is_atom).or((!is_gathered).then_some(Note::Unsolved)) {
            _ if swallows => Finding::unreadable(Note::CannotBeCompared),
            Some(Note::SquareLeft) => finding.at_most_partial(Note::SquareLeft),
            Some(note) if finding.is_correct() => Finding::partial(note),
            Some(_) => Finding::WRONG,
            // `2v = 17.9`
            None => unsolved_if(!is_atom(&left), finding),
        }
    }

    /// Would the left side be another, were the answer another?
    fn tells_apart(&self, model: &Model, left: &Expr, right: &Expr) -> bool {
        let other = if right.is_zero() { Expr::integer(1) } else { Expr::product([Expr::integer(2), right.clone()]) };
        let of = |value: &Expr| left.substitute(&|name| (name == self.unknown).then(|| value.clone()));
        exact::same(&of(right), &of(&other), &model.vocabulary.letters) == Equality::Different
    }

    /// Signs and sums on the left undone on the right.
    fn peeled(&self, said: &Said) -> (Expr, Form, Option<SaidUnit>) {
        let (mut left, mut form, unit) = (self.left.clone(), said.form.clone(), said.unit.clone());
        let has = |expr: &Expr| expr.names().iter().any(|name| name.text == self.unknown);
        loop {
            let next = match (&left, &form) {
                (Expr::Negative(inner), Form::Value(value)) => Some(((**inner).clone(), value.clone().negated())),
                (Expr::Sum(terms), Form::Value(value)) => {
                    let (with, rest): (Vec<&Expr>, Vec<&Expr>) = terms.iter().partition(|term| has(term));
                    let [one] = with.as_slice() else { break };
                    Some(((*one).clone(), less(value, Expr::sum(rest.into_iter().cloned()))))
                }
                _ => None,
            };
            let Some((inner, value)) = next else { break };
            (left, form) = (inner, Form::Value(value));
        }
        (left, form, unit)
    }
}

/// What is found of an equation that is true, and may still have to be solved.
fn unsolved_if(is_left: bool, finding: Finding) -> Finding {
    if is_left && finding.is_correct() { Finding::partial(Note::Unsolved) } else { finding }
}

fn has_sum(expr: &Expr) -> bool {
    matches!(expr, Expr::Sum(_)) || expr.children().into_iter().any(has_sum)
}

/// One less the other, with the decimal places that both have.
fn less(value: &Expr, other: Expr) -> Expr {
    let bare = |expr: &Expr| match expr {
        Expr::Degrees(inner) => (**inner).clone(),
        plain => plain.clone(),
    };
    let difference = || Expr::sum([value.clone(), other.clone().negated()]);
    let numbers = Written::of(value).zip(exact::value(&bare(&other), &[]));
    let Some((written, taken)) = numbers.and_then(|(written, taken)| Some((written, taken.as_fraction()?.clone())))
    else {
        return difference();
    };
    let is_decimal = |expr: &Expr| matches!(unsigned(&bare(expr)), Expr::Decimal(_));
    let of_value = is_decimal(value).then_some(written.places);
    let of_other = Written::of(&bare(&other)).filter(|_| is_decimal(&other)).map(|other| other.places);
    // `v − 2.78 = 0` has the figures of the decimal, wherever it stands.
    let Some(places) = of_value.into_iter().chain(of_other).min() else {
        return Expr::Number(&written.value - &taken);
    };
    match u32::try_from(places) {
        Ok(places) => {
            let rounded = round(&(&written.value - &taken), &Places::DecimalPlaces(places)).to_string();
            match rounded.strip_prefix('-') {
                Some(size) => Expr::Decimal(size.to_owned()).negated(),
                None => Expr::Decimal(rounded),
            }
        }
        Err(_) => difference(),
    }
}
