//! Mark schemes: for each mark what earns it, in words and as an equation, and what the marker condones.

use std::collections::BTreeSet;

use super::answer::{self, Size};
use super::working::{Step, WorkedPart, result};
use super::{SchemeRow, wording};
use crate::answer::Kind;
use crate::bank::{Answer, Code, EarnedFor, Find, Mark};
use crate::expr::{Expr, Piece, Text, read_markup, written};
use crate::generate::Variant;
use crate::mechanics::{
    Axis, Derivation, Known, Moment, Quantity, Rule, Scene, Setting, Show, Sphere, pose, with_letter_of_restitution,
};
use crate::number::{Places, Value};
use crate::unit::Unit;

/// The rows of one part; `worked` holds it last, after the parts before it.
pub fn rows(worked: &[WorkedPart], variant: &Variant, with_units: &[String]) -> Vec<SchemeRow> {
    let Some(here) = worked.last() else { return Vec::new() };
    let marks = &here.part.marks;
    let scene = &variant.scene;
    let row = |(place, mark): (usize, &Mark)| {
        let impact = variant.scene.of_impact(impact_of(place, here));
        let setting = impact.map_or(variant.scene.setting, |scene| scene.setting);
        let (equations, rounded) = equations(place, worked, variant, with_units);
        let unit = if equations.len() < 2 { unit(mark, here, variant, with_units) } else { Unit::None };
        let earned = mark.text.as_ref().map(|text| wording::sentence(text, variant, None));
        let note = mark.note.as_ref().map(|text| wording::sentence(text, variant, None));
        SchemeRow {
            id: mark.id.clone(),
            code: mark.code.name().to_owned(),
            earned: earned.unwrap_or_else(|| usual_words(mark, here, setting, scene)),
            equations,
            unit,
            note: with_rounded(rounded, note.unwrap_or_else(|| usual_note(mark, impact.unwrap_or(scene)))),
            depends: mark.depends.clone(),
        }
    };
    marks.iter().enumerate().map(row).collect()
}

/// Of which impact the step is that earns a mark: where the part uses a law more than once, one mark after another.
fn impact_of(place: usize, here: &WorkedPart) -> u8 {
    let marks = &here.part.marks;
    let mark = &marks[place];
    if let Some(quantity) = mark.earned_for.quantities().first() {
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
    // What is found from conditions needs the steps that lead to them.
    let from_conditions = |answer: &Answer| match answer.find {
        Find::Unknown(_) => true,
        // These are quantities of every impact, and letters to be found where a part has a finding.
        Find::Quantity(quantity) if matches!(quantity.of_its_impact(), Quantity::Restitution | Quantity::Mass(_)) => {
            answer.kind == Kind::Range || !here.finding.is_empty()
        }
        _ => answer.kind == Kind::Range,
    };
    // Where no answer of the part that has the finding is what was found, each follows from it.
    let is_found = here.part.answers.iter().any(from_conditions);
    let follows = |answer: &Answer| from_conditions(answer) || (!is_found && !here.finding.is_empty());
    let needs = |step: &EarnedFor| {
        let mut steps = here.behind.iter().chain(&here.steps).peekable();
        steps.peek().is_none() || steps.any(|taken| is_of(&taken.rule, step))
    };
    let belongs = answers.filter(|(_, answer)| {
        let asked = answer.find.quantities();
        let has_value = |quantity: &Quantity| match here.asked.contains(quantity) {
            true => asked.contains(quantity),
            // A step on the way to every answer about its sphere, and to those about both.
            false => {
                let about = |asked: &Quantity| {
                    Sphere::ALL.into_iter().all(|of| is_about(*asked, of) || !is_about(*quantity, of))
                };
                match from_conditions(answer) {
                    true => needs(&EarnedFor::Quantity(*quantity)),
                    false => asked.iter().any(about) || (follows(answer) && needs(&EarnedFor::Quantity(*quantity))),
                }
            }
        };
        match &mark.earned_for {
            EarnedFor::Quantity(_) | EarnedFor::Both(_) => mark.earned_for.quantities().iter().any(has_value),
            EarnedFor::Unknown(name) => answer.find == Find::Unknown(name.clone()),
            EarnedFor::Condition => from_conditions(answer) || !is_found,
            step => {
                let steps = steps_to(&asked, &here.given);
                (follows(answer) && needs(step)) || steps.iter().any(|rule| is_of(rule, step))
            }
        }
    });
    belongs.map(|(place, _)| place).collect()
}

fn steps_to(asked: &[Quantity], given: &BTreeSet<Quantity>) -> Vec<Rule> {
    Derivation::plan(given, asked).0.steps.into_iter().cloned().collect()
}

fn is_of(rule: &Rule, step: &EarnedFor) -> bool {
    match step {
        EarnedFor::Law(law, sphere) => {
            rule.law == *law
                && sphere.is_none_or(|sphere| rule.gives.first().is_none_or(|gives| is_about(*gives, sphere)))
        }
        value => value.quantities().iter().any(|quantity| rule.gives.contains(quantity)),
    }
}

/// Is the quantity one of this sphere, or of no sphere?
fn is_about(quantity: Quantity, sphere: Sphere) -> bool {
    quantity.of_its_impact().sphere().is_none_or(|of| of == sphere)
}

/// How many marks before this one are for the same, and of its kind: for the method, or for accuracy.
fn count_before(place: usize, marks: &[Mark]) -> usize {
    let mark = &marks[place];
    let alike = |other: &&Mark| other.code.is_accuracy() == mark.code.is_accuracy();
    marks[..place].iter().filter(alike).filter(|other| other.earned_for == mark.earned_for).count()
}

/// Has the method mark an accuracy mark of its own, which then has the equation?
fn has_accuracy(place: usize, marks: &[Mark]) -> bool {
    let accuracy = |other: &&Mark| other.code.is_accuracy() && other.earned_for == marks[place].earned_for;
    marks.iter().filter(accuracy).count() > count_before(place, marks)
}

/// The equations or the value that earn a mark, and its decimal.
fn equations(
    place: usize,
    worked: &[WorkedPart],
    variant: &Variant,
    with_units: &[String],
) -> (Vec<Expr>, Option<(Expr, Unit)>) {
    let Some(here) = worked.last() else { return Default::default() };
    let marks = &here.part.marks;
    let mark = &marks[place];
    let one = |(equation, rounded): (Option<Expr>, _)| (Vec::from_iter(equation), rounded);
    match &mark.earned_for {
        _ if mark.code == Code::A1Shown => {
            (here.part.answers.iter().filter_map(|answer| result(answer, variant)).take(1).collect(), None)
        }
        EarnedFor::Quantity(quantity) => one(value(*quantity, here, variant, with_units)),
        EarnedFor::Both(both) => {
            let values = both.iter().filter_map(|quantity| value(*quantity, here, variant, with_units).0);
            (values.collect(), None)
        }
        EarnedFor::Unknown(name) => one(unknown(name, here, variant, with_units)),
        EarnedFor::Condition => (here.conditions(), None),
        // What solving comes to stands in the next row.
        EarnedFor::Law(law, _) if law.only_solves() => Default::default(),
        _ if mark.code.is_method() && has_accuracy(place, marks) => Default::default(),
        step => (law_equations(step, place, worked), None),
    }
}

/// The unit of the value that earns a mark where it is that of an answer; an angle has its own sign.
fn unit(mark: &Mark, here: &WorkedPart, variant: &Variant, with_units: &[String]) -> Unit {
    let EarnedFor::Quantity(quantity) = mark.earned_for else { return Unit::None };
    let answer = here.part.answers.iter().find(|answer| answer.find.quantities().contains(&quantity));
    let is_value = mark.code != Code::A1Shown && !is_worked_with(quantity);
    let unit = answer.filter(|_| is_value).map_or(Unit::None, |answer| answer::unit(answer, variant, with_units));
    if unit == Unit::Degree { Unit::None } else { unit }
}

/// Has the working a letter for it, so that a scheme has the equation with which the letter is found?
fn is_worked_with(quantity: Quantity) -> bool {
    matches!(quantity.of_its_impact(), Quantity::Velocity(_, Moment::After, Axis::N))
}

/// A letter that was found, or the values that it may have.
fn unknown(
    name: &str,
    here: &WorkedPart,
    variant: &Variant,
    with_units: &[String],
) -> (Option<Expr>, Option<(Expr, Unit)>) {
    let symbol = || Expr::name(name.replace("A.mass", "m_A").replace("B.mass", "m_B"));
    let asked = |answer: &&Answer| answer.find == Find::Unknown(name.to_owned()) && answer.show.is_none();
    match here.part.answers.iter().find(asked) {
        Some(answer) => {
            let rounded = answer::rounded(answer, variant);
            let unit = answer::unit(answer, variant, with_units);
            let exact = answer::exact(answer, variant);
            let equation = exact.map(|exact| match exact {
                range @ Expr::Relation(..) => range,
                value => Expr::equation(symbol(), value),
            });
            (equation, rounded.map(|rounded| (rounded, unit)))
        }
        None => (answer::letter(variant, name).map(|size| Expr::equation(symbol(), size.exact())), None),
    }
}

/// The equation of the step that uses a law, or of the next one if earlier marks have had it. A mark for several
/// components at once has an equation for each, and the last for energies all that are left, of which it makes one.
fn law_equations(step: &EarnedFor, place: usize, worked: &[WorkedPart]) -> Vec<Expr> {
    let Some(here) = worked.last() else { return Vec::new() };
    let (marks, code) = (&here.part.marks, here.part.marks[place].code);
    let before = count_before(place, marks);
    let is_last = !marks[place + 1..].iter().any(|later| later.earned_for == *step);
    let EarnedFor::Law(law, _) = step else { return Vec::new() };
    for (earlier, part) in worked.iter().enumerate().rev() {
        // What leads to the letters comes first, and what is found again with their values is the same step; so is what an
        // earlier part has found in the letters.
        let is_known = |own: &Step| {
            let known = worked[..earlier].iter().flat_map(|earlier| &earlier.behind);
            known.into_iter().any(|known| known.equations == own.equations)
        };
        let of_step = |steps: &[Step]| -> Vec<(Option<Axis>, Vec<Expr>)> {
            let of_step = steps.iter().filter(|other| is_of(&other.rule, step) && !other.equations.is_empty());
            of_step.filter(|step| !is_known(step)).map(|step| (axis(&step.rule), step.equations.clone())).collect()
        };
        let found = Some(of_step(&part.behind)).filter(|found| !found.is_empty());
        let mut found = found.unwrap_or_else(|| of_step(&part.steps));
        let Some((first, _)) = found.get(before).or(found.last()).cloned() else { continue };
        if law.is_of_components() && before == 0 && (code == Code::B1 || code.is_accuracy()) {
            // To put components together again along i and j is not of the mark for finding them.
            found.retain(|(axis, _)| *axis == first);
            return found.into_iter().flat_map(|(_, equations)| equations).collect();
        }
        if code == Code::B1 && found.len() > 1 {
            return Vec::new();
        }
        if law.adds_up() && is_last && before < found.len() {
            return found.into_iter().skip(before).flat_map(|(_, equations)| equations).collect();
        }
        let own = found.get(before).or(found.last()).and_then(|(_, equations)| equations.first());
        return own.cloned().into_iter().collect();
    }
    Vec::new()
}

/// The axis of the components that a step gives first.
fn axis(rule: &Rule) -> Option<Axis> {
    match rule.gives.first()?.of_its_impact() {
        Quantity::Velocity(_, _, axis) => Some(axis),
        _ => None,
    }
}

/// The value of a quantity, as an equation where the working has a letter for it, and its decimal.
fn value(
    quantity: Quantity,
    here: &WorkedPart,
    variant: &Variant,
    with_units: &[String],
) -> (Option<Expr>, Option<(Expr, Unit)>) {
    let answer = here.part.answers.iter().find(|answer| answer.find.quantities().contains(&quantity));
    if let Some(answer) = answer.filter(|_| !is_worked_with(quantity)) {
        let rounded = answer::rounded(answer, variant);
        let unit = answer::unit(answer, variant, with_units);
        return (answer::exact(answer, variant), rounded.map(|rounded| (rounded, unit)));
    }
    let found_first = !here.finding.is_empty();
    let scene = if found_first { &variant.scene } else { variant.solution.scene() };
    let Some(known) = known_with(quantity, here, found_first.then_some(scene)) else { return (None, None) };
    let Some((show, in_law)) = Show::new(scene, &known, &here.asked).of(quantity) else { return (None, None) };
    let named_by = |letter| tangent(letter, quantity.impact(), show.value(in_law), here);
    // The decimal is that of what stands there, with the sign that the working gives it.
    let mut size = known.number(quantity);
    let exact = match in_law {
        Quantity::Velocity(_, Moment::After, Axis::N) => {
            // After a wall the working has the component away from it.
            let away = show.setting().works_away_from_b();
            let worked = if away { -show.exact(in_law) } else { show.worked(in_law) };
            let equation = Expr::equation(show.symbol(in_law), written(&worked));
            size = Some(worked);
            equation
        }
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
    let size = size.map(Size::Number).filter(|size| !is_exact && !size.is_short(&places));
    let rounded = size.and_then(|size| size.rounded(&places));
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
fn usual_words(mark: &Mark, here: &WorkedPart, setting: Setting, scene: &Scene) -> Text {
    let name = |quantity: &Quantity| {
        let answer = here.part.answers.iter().find(|answer| answer.find.quantities().contains(quantity));
        answer.map_or_else(|| in_words(*quantity, setting), |answer| answer.name.clone())
    };
    match &mark.earned_for {
        _ if mark.code == Code::A1Shown => Text::words("the printed result, with no errors seen"),
        EarnedFor::Law(law, _) if mark.code.is_accuracy() => marked_up(&setting.say(law.accuracy())),
        EarnedFor::Law(law, _) => {
            let words = setting.say(law.method().0);
            let is_change =
                |quantity| matches!(quantity, Quantity::SphereEnergyLost(_) | Quantity::SphereEnergyGained(_));
            let is_of_one = here.asked.iter().any(|asked| is_change(asked.of_its_impact()));
            marked_up(&if is_of_one { words.replace(", both spheres", "") } else { words.into_owned() })
        }
        EarnedFor::Condition if scene.maximise.is_some() => Text::words("differentiates, or completes a square"),
        EarnedFor::Condition => Text::words("uses what is given of the motion after the impact"),
        EarnedFor::Unknown(_) => Text::words("correct value"),
        EarnedFor::Quantity(quantity) => name(quantity),
        EarnedFor::Both([one, other]) => {
            let pieces = [name(one).0, vec![Piece::Words(" and ".to_owned())], name(other).0];
            Text(pieces.concat())
        }
    }
}

/// What the marker condones, where the file does not say.
fn usual_note(mark: &Mark, scene: &Scene) -> Text {
    match &mark.earned_for {
        EarnedFor::Law(law, _) if !mark.code.is_accuracy() => {
            let said = scene.setting.say(law.method().1);
            marked_up(&with_letter_of_restitution(&said, scene.letter_of_restitution()))
        }
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
    marked_up(&setting.say(&quantity.in_words()))
}

/// Words in the markup of the bank.
fn marked_up(words: &str) -> Text {
    read_markup(words).ok().and_then(|mut paragraphs| paragraphs.pop()).unwrap_or_default()
}
