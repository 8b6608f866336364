//! Angles: with the line from which they are measured and the sense, in degrees or in radians.
//!
//! Conventions. The model is an angle to the line of centres in the sense from A to B, unless the quantity says
//! otherwise. A bare number is degrees. The complement is right with the common tangent named and wrong without. Measured
//! from BA it is the supplement that is right, unless the sphere rebounds; from the direction AB, if it does. `AB` alone may be
//! the line or the direction. Where nobody says whether the sphere rebounds, a sense goes to a person.

use std::borrow::Cow;
use std::cell::OnceCell;
use std::sync::OnceLock;

use crate::expr::{Expr, Function, Meaning, Relation, Turn};
use crate::mark::reading::{Form, Label, ReferenceLine, Said, Sense};
use crate::mechanics::Quantity;
use crate::number::{FloatInterval, Fraction, Interval, Letter, Places};

use super::accuracy::{BITS, Nearly, Target, Written, decimal, places};
use super::angle_at_points::{as_angle, at_points, by_enclosure};
use super::coarsest::Coarsest;
use super::exact::{self, Equality};
use super::finding::Finding;
use super::{Model, Note, number, sense};
use crate::answer::Accept;

/// Judges one value against an angle.
pub(super) fn judge(model: &Model, said: &Said, label: Option<&Label>) -> Finding {
    let letters = &model.vocabulary.letters;
    let known = model.known();
    let Some(right) = known.turn() else {
        return match &said.form {
            Form::Value(expr) if said.reference.is_none_or(|named| Some(named) == own_line(model)) => {
                match at_points(model, expr) {
                    Finding::WRONG if !known.has_names() => by_enclosure(model, said, expr),
                    finding => finding,
                }
            }
            _ => Finding::unreadable(Note::CannotBeCompared),
        };
    };
    let expr = match &said.form {
        Form::Value(expr) => expr,
        Form::Equation(Expr::Relation(left, Relation::Equal, value)) => {
            return match &**left {
                Expr::Call(function @ (Function::Sin | Function::Cos | Function::Tan), _) => {
                    ratio_of_angle(model, *function, value)
                }
                // `arctan((4u/5)/(3u/20)) = 79.4°`
                _ => {
                    let one =
                        |expr: &Expr| judge(model, &Said { form: Form::Value(expr.clone()), ..said.clone() }, None);
                    let (left, right) = (one(left), one(value));
                    if left.exact || (left.is_correct() && right.is_correct()) { left } else { Finding::WRONG }
                }
            };
        }
        Form::Direction => return direction(model, &right.turn, own_line(model), said.reference),
        _ => return Finding::WRONG,
    };
    if let Some(function) = label.and_then(named_ratio) {
        return ratio_of_angle(model, function, expr);
    }
    if exact::unknown_letter(expr, letters).is_some() {
        let bare = matches!(expr, Expr::Name(_));
        return if bare { Finding::unreadable(Note::UnknownLetter) } else { Finding::wrong(Note::UnknownLetter) };
    }
    // `0.222π°` is no degree and a bit, and nobody knows what it is.
    if said.unit.as_ref().is_some_and(|unit| unit.degrees) && has_pi(expr) {
        return Finding::unreadable(Note::CannotBeCompared);
    }
    let stated = &Stated::of(expr);
    let radians = match &said.unit {
        None => false,
        Some(unit) if unit.degrees => false,
        Some(unit) if unit.dimension == [0, 0, 0, 1] => true,
        Some(_) => return compare(model, stated, right, false).spoilt_by(Note::UnitWrong),
    };
    if let (Some(sense), Some(ReferenceLine::LineOfCentres)) =
        (said.reference.and_then(ReferenceLine::sense), own_line(model))
    {
        let finding = in_a_sense(model, stated, right, radians, sense);
        let explained = finding == Finding::WRONG && sense != Sense::BToA;
        return if explained { explain(model, said, stated, right, finding) } else { finding };
    }
    if said.reference == Some(ReferenceLine::MinusI) && matches!(model.quantity, Some(Quantity::AngleFromI(..))) {
        return right.from(180).map_or(Finding::WRONG, |turn| compare(model, stated, &turn, radians));
    }
    match expected(right, own_line(model), said.reference) {
        Some(expected) => {
            let finding = compare(model, stated, &expected, radians);
            if finding.is_credited() { finding } else { explain(model, said, stated, right, finding) }
        }
        None => from_another_line(model, stated, right, radians, said.reference),
    }
}

/// The function of which a label is the value, `tan α`, or `tan` alone.
fn named_ratio(label: &Label) -> Option<Function> {
    match (&label.expr, label.typed.trim()) {
        (Some(Expr::Call(function, _)), _) => Some(*function),
        (None, "sin") => Some(Function::Sin),
        (None, "cos") => Some(Function::Cos),
        (None, "tan") => Some(Function::Tan),
        _ => None,
    }
}

/// Is π in it, and not under a function?
fn has_pi(expr: &Expr) -> bool {
    *expr == Expr::Pi || !matches!(expr, Expr::Call(..)) && expr.children().into_iter().any(has_pi)
}

/// An angle from a line that lies nobody knows how to the model's own. What it comes to from the path before the impact, or
/// which end of i is meant of an acute angle, a person can see.
fn from_another_line(
    model: &Model,
    stated: &Stated,
    right: &Enclosed,
    radians: bool,
    named: Option<ReferenceLine>,
) -> Finding {
    let finding = compare(model, stated, right, radians);
    let is_supplement = || right.from(180).is_some_and(|turn| compare(model, stated, &turn, radians).is_credited());
    match named {
        // The acute angle of what points against i is that with -i.
        Some(ReferenceLine::MinusI) if finding.is_credited() && model.against_i == Some(true) => finding,
        Some(ReferenceLine::MinusI) if finding.is_credited() || is_supplement() => {
            Finding::unreadable(Note::ReferenceUnchecked)
        }
        Some(ReferenceLine::OriginalDirection) if !finding.is_credited() => {
            Finding::unreadable(Note::ReferenceUnchecked)
        }
        // The paths of two spheres lie alike by chance.
        _ if own_line(model).is_none() && finding.is_credited() => Finding::unreadable(Note::ReferenceUnchecked),
        _ => finding.at_most_partial(Note::ReferenceUnchecked),
    }
}

/// An angle with its enclosure in degrees, which is worked out once.
#[derive(Clone)]
pub(super) struct Enclosed {
    pub(super) turn: Turn,
    degrees: OnceLock<Option<Nearly>>,
}

impl Enclosed {
    pub(super) fn of(turn: Turn) -> Enclosed {
        Enclosed { turn, degrees: OnceLock::new() }
    }

    /// So many degrees less the angle.
    fn from(&self, degrees: i64) -> Option<Enclosed> {
        let turn = Turn::degrees(Fraction::from(degrees)).plus(&self.turn.reversed())?;
        let enclosure = self.enclosure().map(|own| Interval::integer(degrees, BITS) - own.finely.clone());
        Some(Enclosed { turn, degrees: enclosure.map(Nearly::of).into() })
    }

    /// Is it exactly the other angle? Nearly always two enclosures tell that it is not.
    fn equals(&self, other: &Enclosed) -> Equality {
        let enclosures = self.enclosure().zip(other.enclosure());
        if enclosures.is_some_and(|(own, others)| !own.finely.overlaps(&others.finely)) {
            return Equality::Different;
        }
        let gap = self.turn.plus(&other.turn.reversed());
        match gap.map(|gap| gap.is_surely_degrees(&Fraction::ZERO)) {
            Some(Some(true)) => Equality::Equal,
            Some(None) => Equality::Undecided,
            Some(Some(false)) | None => Equality::Different,
        }
    }

    /// In degrees; `None` while there are letters in it.
    pub(super) fn enclosure(&self) -> Option<&Nearly> {
        self.degrees.get_or_init(|| self.turn.enclose(BITS).map(Nearly::of)).as_ref()
    }

    pub(super) fn enclose(&self, bits: usize) -> Option<Interval> {
        // A rounding may be certified by any enclosure that is narrow enough.
        if bits <= BITS { self.enclosure().map(|nearly| nearly.finely.clone()) } else { self.turn.enclose(bits) }
    }
}

/// The angle that something means; a plain number is degrees.
pub(super) fn as_turn(meaning: &Meaning) -> Option<Turn> {
    match meaning {
        Meaning::Angle(turn) | Meaning::Degrees(turn) => Some(turn.clone()),
        Meaning::Number(value) => value.as_fraction().map(|degrees| Turn::degrees(degrees.clone())),
        _ => None,
    }
}

/// What a student stated for an angle. What it means is compared with the angle, its complement and its supplement, and
/// worked out once.
struct Stated<'a> {
    expr: &'a Expr,
    meaning: OnceCell<Option<Meaning>>,
}

impl<'a> Stated<'a> {
    fn of(expr: &'a Expr) -> Stated<'a> {
        Stated { expr, meaning: OnceCell::new() }
    }

    fn meaning(&self, letters: &[Letter]) -> Option<&Meaning> {
        self.meaning.get_or_init(|| exact::meaning(self.expr, letters)).as_ref()
    }
}

/// The line from which the model is measured; `None` of an angle between two paths.
fn own_line(model: &Model) -> Option<ReferenceLine> {
    use Quantity::*;
    match model.quantity.map(Quantity::of_its_impact) {
        Some(AngleFromI(..) | ImpulseAngle) => Some(ReferenceLine::I),
        Some(AngleToWall(..) | TanToWall(..)) => Some(ReferenceLine::CommonTangent),
        Some(Deflection(_) | SignedDeflection(_) | TanDeflection(_)) => Some(ReferenceLine::OriginalDirection),
        Some(AngleBetween(_)) => None,
        _ => Some(ReferenceLine::LineOfCentres),
    }
}

/// The model's angle as measured from the line that was named; `None` if only a person can tell.
fn expected(right: &Enclosed, own: Option<ReferenceLine>, named: Option<ReferenceLine>) -> Option<Cow<'_, Enclosed>> {
    use ReferenceLine::{CommonTangent, I, J, LineOfCentres};
    // Towards a sphere is no line.
    let Some(named) = named.filter(|named| !named.is_sense_alone()) else { return Some(Cow::Borrowed(right)) };
    match (own?, named) {
        (own, named) if own == named => Some(Cow::Borrowed(right)),
        (LineOfCentres, CommonTangent) | (CommonTangent, LineOfCentres) | (I, J) => right.from(90).map(Cow::Owned),
        _ => None,
    }
}

/// An angle measured from AB or from BA: by the sense in which the sphere moves, if that is known.
fn in_a_sense(model: &Model, stated: &Stated, right: &Enclosed, radians: bool, sense: Sense) -> Finding {
    let acute = compare(model, stated, right, radians);
    if sense == Sense::Perhaps && acute.is_credited() {
        return acute;
    }
    let obtuse = right.from(180).map_or(Finding::WRONG, |turn| compare(model, stated, &turn, radians));
    let (own, other) = match (model.rebounds, sense) {
        (None, _) if obtuse.or_better(acute).is_credited() => return Finding::unreadable(Note::ReferenceUnchecked),
        (None, _) => return Finding::WRONG,
        (Some(rebounds), _) if rebounds == (sense == Sense::BToA) => (acute, obtuse),
        (Some(_), _) => (obtuse, acute),
    };
    if other.is_credited() && !own.is_credited() { Finding::wrong(Note::Supplement) } else { own }
}

/// An angle told by words alone: along the line from which it is measured, or across it. How any other line lies to that
/// one nobody but a person can tell.
fn direction(model: &Model, right: &Turn, own: Option<ReferenceLine>, named: Option<ReferenceLine>) -> Finding {
    use ReferenceLine::{AlongCommonTangent, AlongLineOfCentres, CommonTangent, LineOfCentres};
    let degrees = match (own, named.map(ReferenceLine::unsensed)) {
        (Some(LineOfCentres), Some(AlongLineOfCentres)) | (Some(CommonTangent), Some(AlongCommonTangent)) => 0,
        (Some(LineOfCentres), Some(AlongCommonTangent)) | (Some(CommonTangent), Some(AlongLineOfCentres)) => 90,
        _ => return Finding::unreadable(Note::CannotBeCompared),
    };
    if !right.is_degrees(&Fraction::from(degrees)) {
        return Finding::WRONG;
    }
    let said = named.and_then(ReferenceLine::sense);
    match (sense::agrees(said, model.rebounds), said) {
        (Some(true), _) => Finding::EXACT,
        (Some(false), _) => Finding::wrong(Note::Supplement),
        (None, Some(Sense::Perhaps)) if model.rebounds.is_none() => Finding::EXACT,
        (None, _) => Finding::unreadable(Note::ReferenceUnchecked),
    }
}

/// The model's value as an angle, of which sines can be taken.
pub(super) fn in_turns(model: &Model) -> Expr {
    match model.known().meaning() {
        Some(Meaning::Number(_) | Meaning::Degrees(_)) => Expr::degrees(model.value.clone()),
        Some(_) => model.value.clone(),
        None => as_angle(model),
    }
}

/// The sine, cosine or tangent where the angle is asked: a step short.
fn ratio_of_angle(model: &Model, function: Function, value: &Expr) -> Finding {
    let of_angle = model.of_value(Expr::call(function, in_turns(model)));
    let finding = number::value(&of_angle, value, &Written::of(value));
    if finding.is_correct() { Finding::partial(Note::RatioOfAngle) } else { Finding::WRONG }
}

/// Compares what was written with an angle.
fn compare(model: &Model, stated: &Stated, right: &Enclosed, radians: bool) -> Finding {
    let expr = stated.expr;
    let constant = right.enclosure().is_some();
    let is_own = || model.known().turn().is_some_and(|own| own.turn == right.turn);
    let number = match stated.meaning(&model.vocabulary.letters) {
        Some(Meaning::Angle(turn) | Meaning::Degrees(turn)) => {
            let found = Enclosed::of(turn.clone());
            match right.equals(&found) {
                Equality::Equal => return Finding::EXACT,
                Equality::Undecided if is_own() => return at_points(model, expr),
                Equality::Undecided => return Finding::unreadable(Note::CannotBeCompared),
                Equality::Different => {}
            }
            return Coarsest::of(expr)
                .filter(|_| constant)
                .map_or(Finding::WRONG, |decimals| rounded(&found, &decimals, right, model));
        }
        Some(Meaning::Number(value)) => value,
        // What is too long to be worked out may be it all the same.
        None if is_own() => return at_points(model, expr),
        _ => return Finding::WRONG,
    };
    if !constant {
        return Finding::WRONG;
    }
    let target = if radians { Target::Radians(right) } else { Target::Degrees(right) };
    let written = Written::of(expr).or_else(|| {
        let value = number.as_fraction()?;
        Some(Written::worked_out(value.clone(), &Coarsest::of(expr)?))
    });
    match written {
        Some(written) if radians => {
            let degrees = right.enclosure().map(|nearly| nearly.roughly);
            let accept = degrees.map_or_else(|| model.accept.clone(), |degrees| in_radians(&model.accept, degrees));
            decimal(&written, &target, &accept)
        }
        Some(written) => decimal(&written, &target, &model.accept),
        None if number.as_fraction().is_some_and(|value| target.equals(value)) => Finding::EXACT,
        None => Finding::WRONG,
    }
}

/// The rule of an angle in degrees where it is stated in radians: as many significant figures as the degrees would have,
/// since a step or a place of degrees is none of radians.
fn in_radians(accept: &Accept, degrees: FloatInterval) -> Accept {
    let step = match accept.places() {
        Some(Places::DecimalPlaces(places)) => 0.1_f64.powi((*places).min(60).cast_signed()),
        Some(Places::Nearest(step)) => step.decimal().to_fraction().to_f64(),
        _ => return accept.clone(),
    };
    let figures = (degrees.abs().upper.log10().floor() - step.log10().floor() + 1.0).clamp(1.0, 20.0);
    Accept::RoundsTo(Places::SignificantFigures(figures as u32))
}

/// An inverse tangent of a decimal, as `arctan 1.04`.
fn rounded(found: &Enclosed, decimals: &Coarsest, right: &Enclosed, model: &Model) -> Finding {
    let wanted = places(&model.accept);
    let both = Target::Degrees(found).rounded(&wanted).ok().zip(Target::Degrees(right).rounded(&wanted).ok());
    let agree = both.is_some_and(|(found, right)| found.to_fraction() == right.to_fraction());
    match (agree, decimals.suffices(&wanted)) {
        (true, true) if model.accept.places().is_none() => Finding::partial(Note::ExactWanted),
        (true, true) => Finding::correct(None),
        (true, false) if !decimals.is_worthless() => Finding::partial(Note::UnderAccurate),
        (false, _) if decimals.suffices(&Places::SignificantFigures(3)) && is_within_a_hundredth(found, right) => {
            Finding::partial(Note::NearMiss)
        }
        _ => Finding::WRONG,
    }
}

fn is_within_a_hundredth(found: &Enclosed, right: &Enclosed) -> bool {
    let between = found.enclosure().zip(right.enclosure());
    between
        .is_some_and(|(found, right)| (found.roughly - right.roughly).abs().upper < right.roughly.abs().lower / 100.0)
}

/// Is a plain number far from the angle, its complement, its supplement, its negative and its radians alike?
fn is_unrelated(expr: &Expr, right: &Enclosed, wanted: &Places) -> bool {
    let Some((written, nearly)) = Written::of(expr).zip(right.enclosure()) else { return false };
    let (degrees, whole) = (nearly.roughly, FloatInterval::point);
    let radians = (degrees * FloatInterval::pi()).checked_div(whole(180.0));
    let others = [Some(whole(90.0) - degrees), Some(whole(180.0) - degrees), Some(-degrees), radians, Some(degrees)];
    others.iter().flatten().all(|other| written.is_far_from(*other, wanted))
}

/// Why the number is not the one asked for, where that can be told.
fn explain(model: &Model, said: &Said, stated: &Stated, right: &Enclosed, finding: Finding) -> Finding {
    let is = |angle: &Enclosed, radians: bool| compare(model, stated, angle, radians).is_correct();
    let is_from = |degrees: i64| right.from(degrees).is_some_and(|angle| is(&angle, false));
    if is_unrelated(stated.expr, right, &places(&model.accept)) {
        return finding;
    }
    if said.reference.is_some_and(|named| Some(named.unsensed()) != own_line(model)) {
        return if is(right, false) { Finding::wrong(Note::ReferenceWrong) } else { finding };
    }
    if said.unit.is_none() && is(right, true) {
        return Finding::partial(Note::RadiansUnstated);
    }
    // How far a path is turned is measured from no line.
    let is_turn = model.quantity.is_some_and(|asked| matches!(asked.of_its_impact(), Quantity::Deflection(_)));
    if is_from(90) && !is_turn {
        return Finding::wrong(Note::Complement);
    }
    if is_from(180) {
        return Finding::wrong(Note::Supplement);
    }
    if is_from(0) {
        return Finding::wrong(Note::Sign);
    }
    finding
}
