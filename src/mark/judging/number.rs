//! Numbers and formulas in letters: exact equality first, then the decimals that the student wrote.

use std::cmp::Ordering;

use crate::answer::Kind;
use crate::expr::{Expr, Function, Meaning, Relation};
use crate::mark::enclosure::enclose_roughly;
use crate::mark::reading::{Form, Label, Notation, Said};
use crate::mechanics::Quantity;
use crate::number::{FloatInterval, Fraction, Places, Range, Span, Value};
use crate::unit::Unit;

use super::accuracy::{Target, Written, decimal, is_far, places};
use super::coarsest::Coarsest;
use super::coefficients;
use super::exact::{self, Equality, same};
use super::finding::Finding;
use super::known::Further;
use super::powers::is_right_but_for_powers;
use super::said_twice::said_twice;
use super::units::{self, UnitCheck};
use super::{Model, Note, angle, changes, left_side, sense};

/// Judges one value against a number or formula.
pub(super) fn judge(model: &Model, said: &Said, label: Option<&Label>) -> Finding {
    if let Some(finding) = through_its_tangent(model, said, label).or_else(|| sense::judge(model, said, label)) {
        return finding;
    }
    let finding = as_it_stands(model, said, label);
    if finding.is_credited() {
        return finding;
    }
    match said_of_the_square(said, label) {
        // Letters under a root are compared there; a decimal has the figures of the square.
        Some(square) if Written::of(square).is_none() => {
            let root = Expr::call(Function::Sqrt, square.clone());
            value(model, &root, &None).at_most_partial(Note::SquareLeft)
        }
        Some(square) => {
            let of_square = model.of_value(model.value.clone().to_the(2));
            value(&of_square, square, &Written::of(square)).at_most_partial(Note::SquareLeft)
        }
        None => finding,
    }
}

/// What is said of the square of a quantity: `v² = 7.7`.
fn said_of_the_square<'s>(said: &'s Said, label: Option<&Label>) -> Option<&'s Expr> {
    let is_square = |expr: &Expr| matches!(expr, Expr::Power(base, two) if matches!(**base, Expr::Name(_)) && **two == Expr::integer(2));
    match &said.form {
        Form::Value(value) if label.and_then(|label| label.expr.as_ref()).is_some_and(is_square) => Some(value),
        Form::Equation(Expr::Relation(left, Relation::Equal, right)) if is_square(left) => Some(right),
        _ => None,
    }
}

pub(super) fn as_it_stands(model: &Model, said: &Said, label: Option<&Label>) -> Finding {
    let nought = Expr::integer(0);
    let (expr, percent) = match &said.form {
        Form::Value(expr) => (expr, false),
        Form::Percentage(expr) => (expr, true),
        Form::AtRest => (&nought, false),
        // `4.8 N s in the direction -j`: the size, and a direction that is not asked.
        Form::Vector(x, y, Notation::Words) if !has_a_sense(model.quantity) && (!x.is_zero() || !y.is_zero()) => {
            let size = &match (x.is_zero(), y.is_zero()) {
                (true, _) => y.clone(),
                (_, true) => x.clone(),
                _ => super::vector::magnitude(x, y),
            };
            let sized =
                |expr: &Expr| as_it_stands(model, &Said { form: Form::Value(expr.clone()), ..said.clone() }, label);
            let finding = sized(size).or_better(sized(&size.clone().negated()));
            let is_impulse = model.quantity.map(Quantity::of_its_impact) == Some(Quantity::ImpulseMagnitude)
                && !sense::is_across_the_vector(model, x, y);
            return if is_impulse { finding } else { finding.at_most_partial(Note::DirectionUnchecked) };
        }
        Form::Vector(x, y, _) => return magnitude_left(model, x, y),
        // Of two masses a ratio may be right, and does not say the one.
        Form::Ratio(..) if matches!(model.quantity.map(Quantity::of_its_impact), Some(Quantity::Mass(_))) => {
            return Finding::unreadable(Note::CannotBeCompared);
        }
        Form::Ratio(above, below) => {
            let quotient = above.clone().over(below.clone());
            return value(model, &quotient, &Written::of(&quotient)).at_most_partial(Note::RatioForNumber);
        }
        Form::Mixed(_) => return Finding::wrong(Note::NumberPlusVector),
        Form::Equation(Expr::Relation(left, Relation::Equal, right)) => return said_twice(model, said, [left, right]),
        Form::Equation(_) | Form::Gradient(_) | Form::Range(..) | Form::Direction => return Finding::WRONG,
    };
    let vector = Expr::names(expr).iter().any(|name| matches!(name.text.as_str(), "i" | "j"));
    if let (true, Some(Meaning::Vector(x, y))) = (vector, exact::meaning(expr, &model.vocabulary.letters)) {
        return magnitude_left(model, &crate::expr::written(&x), &crate::expr::written(&y));
    }
    let plain = if percent {
        let hundredth = Fraction::new(1, 100);
        let written = Written::of(expr).map(|written| written.times(&hundredth, -2));
        signed(model, &expr.clone().over(Expr::integer(100)), &written, label)
    } else {
        signed(model, expr, &Written::of(expr), label)
    };
    if let Some((number, note)) = units::taken_for_a_letter(model, expr).filter(|_| !plain.is_credited()) {
        return signed(model, &number, &Written::of(&number), label).at_most_partial(note);
    }
    match units::check(model, said.unit.as_ref()) {
        UnitCheck::Fine if percent && model.unit().is_some_and(|unit| unit != Unit::None) => {
            plain.spoilt_by(Note::UnitWrong)
        }
        UnitCheck::Fine => plain,
        UnitCheck::Condoned(note) => plain.remarked(note),
        // `2.7g`: a 9, or grams?
        UnitCheck::Spoilt(_) if said.unit.as_ref().is_some_and(units::are_grams) => {
            Finding::unreadable(Note::CannotBeRead)
        }
        UnitCheck::Spoilt(note) => plain.spoilt_by(note),
        UnitCheck::Converted(scale) => {
            let own = units::in_its_own_unit(model, &scale).map(|own| signed(&own, expr, &Written::of(expr), label));
            let written = Written::of(expr).map(|written| written.converted(&scale));
            let scaled = Expr::product([Expr::Number(scale), expr.clone()]);
            let usual = signed(model, &scaled, &written, label);
            let converted = own.map_or(usual, |own| own.or_better(usual)).remarked(Note::UnitConverted);
            converted.or_better(plain.at_most_partial(Note::UnitWrong))
        }
    }
}

/// The value as it is, or with its sign changed.
fn signed(model: &Model, expr: &Expr, written: &Option<Written>, label: Option<&Label>) -> Finding {
    let plain = value(model, expr, written);
    if plain.is_credited() || plain.verdict == super::Verdict::Unreadable {
        return plain;
    }
    if is_of_another_size(model, expr) {
        return plain;
    }
    let turned = value(model, &expr.clone().negated(), &written.as_ref().map(Written::negated));
    if !turned.is_credited() {
        return plain;
    }
    if turned.note == Some(Note::LetterMissing) {
        return Finding::wrong(Note::LetterAndSign);
    }
    let positive = model.known().value().and_then(Value::sign);
    if positive != Some(Ordering::Greater) || has_a_sense(model.quantity) || is_never_negative(model) {
        return Finding::wrong(Note::Sign);
    }
    let is_loss = label.is_some_and(|label| changes::is_of_loss(model, &label.typed));
    if is_loss { Finding { note: Some(Note::ChangeNotLoss), ..turned } } else { Finding::partial(Note::Sign) }
}

/// Is it one of which a negative value shows that nobody looked: a mass, e, a letter that is positive? Of a speed and an
/// impulse the sign tells a sense.
fn is_never_negative(model: &Model) -> bool {
    let asked = model.quantity.map(Quantity::of_its_impact);
    let is_positive = |name: &String| {
        let mut letters = model.vocabulary.letters.iter();
        letters.any(|letter| letter.name() == name && Span::of(letter.range()).low.is_some())
    };
    matches!(asked, Some(Quantity::Restitution | Quantity::Mass(_) | Quantity::MassRatio | Quantity::FractionLost))
        || asked.is_none() && model.letter.as_ref().is_some_and(is_positive)
}

/// Is it so plainly a number of another size that its sign need not be looked at?
fn is_of_another_size(model: &Model, expr: &Expr) -> bool {
    if let Some(decimals) = Coarsest::of(expr) {
        return is_far_off(model, expr, &decimals, FloatInterval::abs);
    }
    between_doubles(model, expr).is_some_and(|(right, found)| !right.abs().overlaps(found.abs()))
}

/// Is a number that was worked out with decimals farther off than any rule forgives?
fn is_far_off(model: &Model, expr: &Expr, decimals: &Coarsest, size: impl Fn(FloatInterval) -> FloatInterval) -> bool {
    let is_far = |(right, found)| is_far(size(found), decimals.places, size(right), &places(&model.accept));
    between_doubles(model, expr).is_some_and(is_far)
}

/// The model answer and what was found, where the question has no letters.
fn between_doubles(model: &Model, expr: &Expr) -> Option<(FloatInterval, FloatInterval)> {
    let letters = &model.vocabulary.letters;
    let right = model.known().roughly(0).filter(|_| letters.is_empty())?;
    Some((right, enclose_roughly(expr, letters, 0)?))
}

/// Is the sign of the quantity part of the answer?
pub(super) fn has_a_sense(quantity: Option<Quantity>) -> bool {
    matches!(
        quantity,
        Some(
            Quantity::Velocity(..)
                | Quantity::Impulse(..)
                | Quantity::SphereMomentum(..)
                | Quantity::TotalMomentum(_)
                | Quantity::TOverN(..)
                | Quantity::TanDeflection(_)
        )
    )
}

/// The comparison itself.
pub(super) fn value(model: &Model, expr: &Expr, written: &Option<Written>) -> Finding {
    let letters = &model.vocabulary.letters;
    if exact::unknown_letter(expr, letters).is_some() {
        let bare = matches!(expr, Expr::Name(_));
        return if bare { Finding::unreadable(Note::UnknownLetter) } else { Finding::wrong(Note::UnknownLetter) };
    }
    let known = model.known();
    if let Some((written, target)) = written.as_ref().zip(known.target())
        && known.value().is_some_and(Value::is_constant)
    {
        return decimal(written, &target, &model.accept);
    }
    let equality = exact::equals(model, expr);
    if equality == Equality::Equal {
        return Finding::EXACT;
    }
    // `303/1000` is the decimal 0.303, where that is right.
    if let Some((written, target)) = Written::over_power_of_ten(expr).zip(known.target())
        && known.value().is_some_and(Value::is_constant)
    {
        let as_decimal = decimal(&written, &target, &model.accept);
        if as_decimal.is_correct() {
            return as_decimal;
        }
    }
    let Some(right) = known.value() else {
        if let (Some(written), Some(Meaning::Angle(_)), Some(angle)) = (written, known.meaning(), known.turn()) {
            // A number such as pi is that of an angle in radians.
            return decimal(written, &Target::Radians(angle), &model.accept);
        }
        if let Some(written) = written
            && known.meaning().is_none()
            && !known.has_names()
        {
            // Too long to be worked out exactly; its figures can be proved all the same.
            return decimal(written, &Target::Formula(&model.value, known.nearly()), &model.accept);
        }
        return if equality == Equality::Different {
            Finding::WRONG
        } else {
            Finding::unreadable(Note::CannotBeCompared)
        };
    };
    let mut finding = Finding::WRONG;
    if let Some(decimals) = Coarsest::of(expr) {
        if !worth_working_out(model, expr) {
            return Finding::WRONG;
        }
        if !is_far_off(model, expr, &decimals, |number| number) {
            let Some(found) = exact::value(expr, letters) else { return Finding::unreadable(Note::CannotBeCompared) };
            finding = coefficients::compare(right, &found, &decimals, &model.accept);
            if finding.is_credited() {
                return finding;
            }
        }
    } else if equality == Equality::Undecided {
        return Finding::unreadable(Note::CannotBeCompared);
    }
    if known.written().is_some_and(|right| is_broken_off(model, right, expr)) {
        return Finding::unreadable(Note::BrokenOff);
    }
    if letter_missing(model, expr) {
        return Finding::partial(Note::LetterMissing);
    }
    let reciprocal = Expr::integer(1).over(expr.clone());
    if !expr.is_zero() && exact::equals(model, &reciprocal) == Equality::Equal {
        return Finding::wrong(Note::Inverted);
    }
    if finding == Finding::WRONG && is_right_but_for_powers(model, expr) {
        return Finding::wrong(Note::PowersOfLetters);
    }
    finding
}

/// Is it all that stands above the line of the answer, roots and all? Nobody gets there by chance.
fn is_broken_off(model: &Model, right: &Expr, expr: &Expr) -> bool {
    match right {
        Expr::Quotient(above, below) => {
            let has_root =
                |expr: &Expr| expr.children().iter().any(|part| matches!(part, Expr::Call(Function::Sqrt, _)));
            matches!(**below, Expr::Number(_))
                && has_root(above)
                && same(above, expr, &model.vocabulary.letters) == Equality::Equal
        }
        _ => false,
    }
}

/// Is it, or a multiple of it by a letter, anywhere near? Spares long calculations with what cannot be right.
fn worth_working_out(model: &Model, expr: &Expr) -> bool {
    let (known, letters) = (model.known(), &model.vocabulary.letters);
    let near = |expr: &Expr| {
        exact::points(letters).all(|point| {
            let found = enclose_roughly(expr, letters, point);
            known
                .roughly(point)
                .zip(found)
                .is_none_or(|(right, found)| (right - found).abs().lower <= right.abs().upper)
        })
    };
    near(expr) || missing_letters(model, expr).any(|product| near(&product))
}

/// The products of the expression with a letter that the model has and it has not.
fn missing_letters<'a>(model: &'a Model, expr: &'a Expr) -> impl Iterator<Item = Expr> + 'a {
    let has = |expr: &Expr, name: &str| expr.names().iter().any(|found| found.text.eq_ignore_ascii_case(name));
    let letters = model.vocabulary.letters.iter().filter(|letter| letter.range() == Range::Positive);
    letters
        .filter(move |letter| has(&model.value, letter.name()) && !has(expr, letter.name()))
        .map(|letter| Expr::product([expr.clone(), Expr::name(letter.name())]))
}

/// Is it right but for one letter of which the whole answer is a multiple?
fn letter_missing(model: &Model, expr: &Expr) -> bool {
    let letters = &model.vocabulary.letters;
    if expr.is_zero() {
        return false;
    }
    missing_letters(model, expr).any(|product| {
        exact::equals(model, &product) == Equality::Equal
            || Coarsest::of(&product).is_some_and(|decimals| {
                let both = model.known().value().cloned().zip(exact::value(&product, letters));
                both.is_some_and(|(right, found)| {
                    coefficients::compare(&right, &found, &decimals, &model.accept).is_correct()
                })
            })
    })
}

/// A vector where its magnitude is asked: the last step is missing.
fn magnitude_left(model: &Model, x: &Expr, y: &Expr) -> Finding {
    // `45j`: an energy has no direction, and a small j may be joules.
    if x.is_zero() && model.unit() == Some(Unit::Joule) {
        return value(model, y, &Written::of(y));
    }
    let magnitude = super::vector::magnitude(x, y);
    let finding = value(&Model { kind: Kind::Number, ..model.clone() }, &magnitude, &None);
    // A mass, e, or a letter that is to be found is the magnitude of nothing.
    let has_none = |quantity: Quantity| matches!(quantity.of_its_impact(), Quantity::Mass(_) | Quantity::Restitution);
    let is_no_magnitude = model.letter.is_some() || model.quantity.is_some_and(has_none);
    match finding.is_correct() {
        true if is_no_magnitude => Finding::unreadable(Note::CannotBeCompared),
        true => Finding::partial(Note::VectorForScalar),
        false => Finding::WRONG,
    }
}

/// An angle where its tangent is asked, said to be one by its unit, its label or its form.
fn through_its_tangent(model: &Model, said: &Said, label: Option<&Label>) -> Option<Finding> {
    let tangent_asked = left_side::is_tangent(model.quantity);
    if !(tangent_asked || model.quantity.is_none()) {
        return None;
    }
    let Form::Value(expr) = &said.form else { return None };
    // `arctan(e tan α)`
    if let Expr::Call(Function::Atan, tangent) = expr
        && tangent_asked
        && model.known().has_names()
    {
        return Some(value(model, tangent, &Written::of(tangent)).at_most_partial(Note::AngleForTangent));
    }
    let is_angle = said.unit.as_ref().is_some_and(|unit| unit.degrees || unit.dimension == [0, 0, 0, 1])
        || exact::is_angle(expr, &model.vocabulary.letters);
    let names_angle = |label: &Label| matches!(&label.expr, Some(Expr::Name(name)) if is_angle_name(&name.text));
    let labelled = tangent_asked && label.is_some_and(names_angle);
    if !(is_angle || labelled || tangent_asked) || model.known().value().is_none() {
        return None;
    }
    let is_said = is_angle || labelled;
    // What is not said to be an angle may be one to its figures: nobody writes the exact one.
    let rule = model.accept.places().cloned().or((!is_said).then_some(Places::SignificantFigures(3)));
    let accept = rule.map_or_else(|| model.accept.clone(), crate::answer::Accept::RoundsTo);
    let arc = || Expr::call(Function::Atan, model.value.clone());
    let angle_model =
        Model { accept, quantity: model.quantity, ..model.further(Further::ArcTangent, Kind::Angle, arc) };
    let finding = angle::judge(&angle_model, said, None);
    // `tan θ = arctan(12/19)` is false, whatever is meant.
    if is_angle && label.is_some_and(|label| matches!(label.expr, Some(Expr::Call(Function::Tan, _)))) {
        return Some(finding.at_most_partial(Note::AngleForTangent));
    }
    if is_said {
        return Some(finding.remarked(Note::AngleForTangent)).filter(|finding| is_angle || finding.is_credited());
    }
    // A bare number of degrees may be meant for the tangent: it is no more than partly right.
    finding.is_correct().then(|| Finding::partial(Note::AngleForTangent))
}

/// Is it the name of an angle, by the custom of the subject?
pub(super) fn is_angle_name(name: &str) -> bool {
    matches!(name, "theta" | "alpha" | "beta" | "phi" | "delta" | "gamma" | "θ" | "α" | "β" | "φ" | "δ" | "γ")
}
