//! Mark schemes: for each mark what earns it, in words and as an equation, and what the marker condones.

use std::collections::BTreeSet;

use super::answer::{self, Size};
use super::working::{WorkedPart, result};
use super::{SchemeRow, wording};
use crate::answer::Kind;
use crate::bank::{Answer, Code, EarnedFor, Find, Mark};
use crate::expr::{Expr, Piece, Text, read_markup, written};
use crate::generate::Variant;
use crate::mechanics::{Axis, Derivation, Known, Moment, Quantity, Rule, Scene, Setting, Show, Sphere, pose};
use crate::number::{Places, Value};
use crate::unit::Unit;

/// The rows of one part; `worked` holds it last, after the parts before it.
pub fn rows(worked: &[WorkedPart], variant: &Variant, with_units: &[String]) -> Vec<SchemeRow> {
    let Some(here) = worked.last() else { return Vec::new() };
    let marks = &here.part.marks;
    let row = |(place, mark): (usize, &Mark)| {
        let impact = variant.scene.of_impact(impact_of(place, here));
        let setting = impact.map_or(variant.scene.setting, |scene| scene.setting);
        let before = marks[..place].iter().filter(|other| same_step(other, mark)).count();
        let (equation, rounded) = equation(mark, before, worked, variant, with_units);
        let earned = mark.text.as_ref().map(|text| wording::sentence(text, variant, None));
        let note = mark.note.as_ref().map(|text| wording::sentence(text, variant, None));
        SchemeRow {
            id: mark.id.clone(),
            code: mark.code.name().to_owned(),
            earned: earned.unwrap_or_else(|| usual_words(mark, here, setting)),
            equation,
            note: with_rounded(rounded, note.unwrap_or_else(|| usual_note(mark, setting))),
            depends: mark.depends.clone(),
        }
    };
    marks.iter().enumerate().map(row).collect()
}

/// Of which impact the step is that earns a mark: where the part uses a law more than once, one mark after another.
fn impact_of(place: usize, here: &WorkedPart) -> u8 {
    let marks = &here.part.marks;
    let mark = &marks[place];
    if let EarnedFor::Quantity(quantity) = mark.earned_for {
        return quantity.impact();
    }
    let steps = here.behind.iter().chain(&here.steps).filter(|step| is_of(&step.rule, &mark.earned_for));
    let mut impacts: Vec<u8> = steps.map(|step| step.rule.impact()).collect();
    impacts.dedup();
    let earlier = marks[..place].iter().filter(|other| other.earned_for == mark.earned_for && other.code == mark.code);
    impacts.get(earlier.count()).or(impacts.last()).copied().unwrap_or(0)
}

/// Names of the answers of a part to which a mark belongs: those that cannot be found without its step.
pub fn answers_of(mark: &Mark, here: &WorkedPart) -> Vec<usize> {
    let answers = here.part.answers.iter().enumerate();
    // What is found from conditions needs every step that leads to them.
    let from_conditions = |answer: &Answer| match answer.find {
        Find::Unknown(_) => true,
        // These are quantities of every impact, and letters to be found where a part has a finding.
        Find::Quantity(quantity) if matches!(quantity.of_its_impact(), Quantity::Restitution | Quantity::Mass(_)) => {
            answer.kind == Kind::Range || !here.finding.is_empty()
        }
        _ => answer.kind == Kind::Range,
    };
    let belongs = answers.filter(|(_, answer)| {
        let asked = answer.find.quantities();
        match &mark.earned_for {
            EarnedFor::Quantity(quantity) if here.asked.contains(quantity) => asked.contains(quantity),
            // A step on the way to every answer about its sphere, and to those about both.
            EarnedFor::Quantity(quantity) => {
                let about = |asked: &Quantity| {
                    Sphere::ALL.into_iter().all(|of| is_about(*asked, of) || !is_about(*quantity, of))
                };
                from_conditions(answer) || asked.iter().any(about)
            }
            EarnedFor::Unknown(name) => answer.find == Find::Unknown(name.clone()),
            // Where no answer is what was found, each follows from it.
            EarnedFor::Condition => from_conditions(answer) || !here.part.answers.iter().any(from_conditions),
            step => {
                let steps = steps_to(&asked, &here.given);
                from_conditions(answer) || steps.iter().any(|rule| is_of(rule, step))
            }
        }
    });
    belongs.map(|(place, _)| place).collect()
}

fn steps_to(asked: &[Quantity], given: &BTreeSet<Quantity>) -> Vec<Rule> {
    Derivation::plan(given, asked, &[]).0.steps.into_iter().cloned().collect()
}

fn is_of(rule: &Rule, step: &EarnedFor) -> bool {
    match step {
        EarnedFor::Law(law, sphere) => {
            rule.law == *law
                && sphere.is_none_or(|sphere| rule.gives.first().is_none_or(|gives| is_about(*gives, sphere)))
        }
        EarnedFor::Quantity(quantity) => rule.gives.contains(quantity),
        _ => false,
    }
}

/// Is the quantity one of this sphere, or of no sphere?
fn is_about(quantity: Quantity, sphere: Sphere) -> bool {
    quantity.of_its_impact().sphere().is_none_or(|of| of == sphere)
}

/// Is it another equation of the same law for accuracy?
fn same_step(other: &Mark, mark: &Mark) -> bool {
    other.code.is_accuracy() && mark.code.is_accuracy() && other.earned_for == mark.earned_for
}

/// The equation or value that earns a mark, and its decimal.
fn equation(
    mark: &Mark,
    before: usize,
    worked: &[WorkedPart],
    variant: &Variant,
    with_units: &[String],
) -> (Option<Expr>, Option<(Expr, Unit)>) {
    let Some(here) = worked.last() else { return (None, None) };
    if mark.code == Code::A1Shown {
        return (here.part.answers.iter().find_map(|answer| result(answer, variant)), None);
    }
    match &mark.earned_for {
        EarnedFor::Quantity(quantity) => value(*quantity, here, variant, with_units),
        EarnedFor::Unknown(name) => (answer::letter(variant, name).map(|size| size.exact()), None),
        step if mark.code.is_accuracy() || mark.code == Code::B1 => {
            (law_equation(step, before, mark.code, worked), None)
        }
        _ => (None, None),
    }
}

/// The equation of the step that uses a law, or of the next one if earlier marks have had it. A `B1` for
/// several such steps at once has none.
fn law_equation(step: &EarnedFor, before: usize, code: Code, worked: &[WorkedPart]) -> Option<Expr> {
    for part in worked.iter().rev() {
        let of_step = part.steps.iter().chain(&part.behind).filter(|other| is_of(&other.rule, step));
        let equations: Vec<Expr> = of_step.filter_map(|step| step.equation.clone()).collect();
        if code == Code::B1 && equations.len() > 1 {
            return None;
        }
        if let Some(found) = equations.get(before).or(equations.last()) {
            return Some(found.clone());
        }
    }
    None
}

/// The value of a quantity, as an equation where the working has a letter for it, and its decimal.
fn value(
    quantity: Quantity,
    here: &WorkedPart,
    variant: &Variant,
    with_units: &[String],
) -> (Option<Expr>, Option<(Expr, Unit)>) {
    let answer = here.part.answers.iter().find(|answer| answer.find.quantities().contains(&quantity));
    let along = matches!(quantity.of_its_impact(), Quantity::Velocity(_, Moment::After, Axis::N));
    if let Some(answer) = answer.filter(|_| !along) {
        let rounded = answer::rounded(answer, variant);
        let unit = answer::unit(answer, variant, with_units);
        return (answer::exact(answer, variant), rounded.map(|rounded| (rounded, unit)));
    }
    let found_first = !here.finding.is_empty();
    let scene = if found_first { &variant.scene } else { variant.solution.scene() };
    let Some(known) = known_with(quantity, here, found_first.then_some(scene)) else { return (None, None) };
    let size = known.number(quantity).map(Size::Number);
    let Some((show, in_law)) = Show::new(scene, &known, &here.asked).of(quantity) else { return (None, None) };
    let named_by = |letter| tangent(letter, quantity.impact(), show.value(in_law), here);
    let exact = match in_law {
        // After a wall the working has the component away from it.
        Quantity::Velocity(_, Moment::After, Axis::N) if show.setting().works_away_from_b() => {
            Expr::equation(show.symbol(in_law), written(&-show.exact(in_law)))
        }
        Quantity::Velocity(_, Moment::After, Axis::N) => Expr::equation(show.symbol(in_law), show.shown_value(in_law)),
        Quantity::Velocity(sphere, moment @ Moment::After, axis @ (Axis::X | Axis::Y)) if show.along_an_axis() => {
            // Along the axis of the line of centres the working has its letters.
            let along = Quantity::Velocity(sphere, moment, Axis::N);
            let is_along = !show.exact(Quantity::Line(axis)).is_zero();
            if is_along { Expr::equation(show.symbol(along), show.value(in_law)) } else { show.value(in_law) }
        }
        Quantity::Velocity(sphere, moment, Axis::X | Axis::Y) => {
            let both = |axis| quantity.along(axis);
            let known = known_with(both(Axis::Y), here, None).unwrap_or(known.clone());
            let show = Show::new(variant.solution.scene(), &known, &here.asked);
            let Some((show, _)) = show.of(quantity) else { return (None, None) };
            let vector = Expr::equation(Expr::name(show.vector_letter(sphere, moment)), show.vector(sphere, moment));
            return (Some(show.named(&vector)), None);
        }
        Quantity::TOverN(..) | Quantity::TanToLine(..) => named_by("beta"),
        Quantity::TanDeflection(_) => named_by("delta"),
        _ => match show.angle(in_law) {
            Some(angle) => Show::angle_expr(&angle),
            None => show.value(in_law),
        },
    };
    let places = Places::SignificantFigures(3);
    // Where only the exact value is accepted, no decimal stands beside it.
    let is_exact = answer.is_some_and(|answer| answer.accept(variant.style).places().is_none());
    let rounded = size.filter(|size| !is_exact && !size.is_short(&places)).and_then(|size| size.rounded(&places));
    let rounded = rounded.map(|rounded| (Expr::Decimal(rounded.to_string()), Unit::None));
    (Some(show.named(&exact)), rounded)
}

fn tangent(letter: &str, impact: u8, value: Expr, here: &WorkedPart) -> Expr {
    let left = Expr::call(crate::expr::Function::Tan, Expr::name(letter));
    here.in_its_letters(impact, &Expr::equation(left, value))
}

/// What is known once a quantity that the part need not find is found too.
fn known_with(quantity: Quantity, here: &WorkedPart, scene: Option<&Scene>) -> Option<Known<Value>> {
    // Before letters are found a quantity is a formula in them.
    let mut known = scene.map_or_else(|| Some(here.known.clone()), |scene| pose(scene).ok())?;
    Derivation::carry_out(&mut known, &[quantity]);
    known.0.contains_key(&quantity).then_some(known)
}

/// What earns a mark, where the file does not say.
fn usual_words(mark: &Mark, here: &WorkedPart, setting: Setting) -> Text {
    match &mark.earned_for {
        _ if mark.code == Code::A1Shown => Text::words("the printed result, with no errors seen"),
        EarnedFor::Law(law, _) if mark.code.is_accuracy() => marked_up(&setting.say(law.accuracy())),
        EarnedFor::Law(law, _) => marked_up(&setting.say(law.method().0)),
        EarnedFor::Condition => Text::words("uses what is given of the motion after the impact"),
        EarnedFor::Unknown(_) => Text::words("correct value"),
        EarnedFor::Quantity(quantity) => {
            let answer = here.part.answers.iter().find(|answer| answer.find.quantities().contains(quantity));
            answer.map_or_else(|| in_words(*quantity, setting), |answer| answer.name.clone())
        }
    }
}

fn usual_note(mark: &Mark, setting: Setting) -> Text {
    match &mark.earned_for {
        EarnedFor::Law(law, _) if !mark.code.is_accuracy() => marked_up(&setting.say(law.method().1)),
        _ => Text::default(),
    }
}

/// `awrt 2.78 m s⁻¹`, before the note if there is one.
fn with_rounded(rounded: Option<(Expr, Unit)>, note: Text) -> Text {
    let Some((decimal, unit)) = rounded else { return note };
    let mut pieces = vec![Piece::Words("awrt ".to_owned()), Piece::Quantity(decimal, unit)];
    if !note.is_empty() {
        pieces.push(Piece::Words("; ".to_owned()));
        pieces.extend(note.0);
    }
    Text(pieces)
}

/// A quantity in words.
fn in_words(quantity: Quantity, setting: Setting) -> Text {
    let after = |moment| if moment == Moment::Before { " before" } else { "" };
    let words = match quantity.of_its_impact() {
        Quantity::Velocity(sphere, moment, axis) => {
            let along = match axis {
                Axis::N => "along the line of centres",
                Axis::T => "perpendicular to the line of centres",
                Axis::X => "along {i}",
                Axis::Y => "along {j}",
            };
            format!("component of the velocity of *{}*{} {along}", sphere.name(), after(moment))
        }
        Quantity::Speed(sphere, moment) => format!("speed of *{}*{}", sphere.name(), after(moment)),
        Quantity::AngleToLine(sphere, moment) => format!("direction of *{}*{}", sphere.name(), after(moment)),
        Quantity::TOverN(sphere, _) | Quantity::TanToLine(sphere, _) => {
            format!("tangent of the angle of *{}* to the line of centres", sphere.name())
        }
        Quantity::TanDeflection(sphere) => format!("tangent of the deflection of *{}*", sphere.name()),
        Quantity::Deflection(sphere) => format!("deflection of *{}*", sphere.name()),
        Quantity::EnergyLost => "kinetic energy lost".to_owned(),
        Quantity::FractionLost => "fraction of the kinetic energy lost".to_owned(),
        Quantity::TotalEnergy(moment) => format!("kinetic energy {moment}"),
        Quantity::ImpulseMagnitude => "magnitude of the impulse".to_owned(),
        Quantity::Restitution => "coefficient of restitution".to_owned(),
        other => other.to_string(),
    };
    marked_up(&setting.say(&words))
}

/// Words in the markup of the bank.
fn marked_up(words: &str) -> Text {
    read_markup(words).ok().and_then(|mut paragraphs| paragraphs.pop()).unwrap_or_default()
}
