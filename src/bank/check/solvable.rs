//! The question tried with its reference numbers: every formula has a value, and all that is asked can be found.

use super::super::document::Faults;
use super::super::file::QuestionFile;
use super::super::givens::Givens;
use super::super::literal::Words;
use super::super::posed::{Posed, Unposed};
use super::super::question::{Question, Style};
use super::super::scene_file::{MEND_SCENE, SceneFile};
use crate::answer::Kind;
use crate::expr::{Angles, Expr, Fault};
use crate::mechanics::{Because, Derivation, Given, Quantity, Refusal, Scene, SceneFault, SceneText, pose};
use crate::number::Value;
use crate::solve::solve;

/// Reports what cannot be found with the reference numbers, and why.
pub fn solvable(question: &Question, file: &QuestionFile, faults: &mut Faults) {
    let (Some(style), Some(scene)) = (question.styles.get(question.reference_style), &file.scene) else { return };
    let givens = match Givens::new(style, &question.reference, &question.scene) {
        Ok(givens) => givens,
        Err((name, fault)) => return given(&name, fault, question, file, faults),
    };
    match Posed::new(question, style, givens.clone()) {
        Ok(posed) => {
            requirements(&posed, style, file, faults);
            ranges(&posed, question, file, faults);
            given_answers(&posed, question, file, faults);
            given_conditions(&posed, scene, faults);
        }
        Err(Unposed::Given(name, fault)) => given(&name, fault, question, file, faults),
        Err(Unposed::Scene(found)) => {
            for fault in found {
                in_scene(fault, scene, faults);
            }
        }
        Err(Unposed::Refused(refusal)) => refused(&refusal, question, &givens, file, scene, faults),
    }
}

/// What inequalities leave open is answered by a range, and nothing else is.
fn ranges(posed: &Posed, question: &Question, file: &QuestionFile, faults: &mut Faults) {
    let limited = posed.solution.range().map(|values| values.letter.name().to_owned());
    let answers = question.parts.iter().flat_map(|part| &part.answers);
    let written = file.parts.iter().flat_map(|part| &part.answers);
    for (answer, written) in answers.zip(written) {
        let Some(found) = written.find.first().map(|words| words.get_ref().clone()) else { continue };
        let is_limited = limited.as_ref() == Some(&found);
        let span = || written.kind.as_ref().or(written.find.first()).map_or(written.span.clone(), |words| words.span());
        if answer.kind == Kind::Range && !is_limited {
            let help = "add an inequality such as `conditions = [\"A.after.n < 0\"]` to `[scene]`, and name what it limits in `unknowns`";
            faults.report(span(), format!("`{found}` has no range"), "no inequality of the scene limits it", help);
        } else if answer.kind != Kind::Range && is_limited {
            let message = format!("`{found}` has no single value");
            faults.report(span(), message, "inequalities leave it a range", "write `kind = \"range\"`");
        }
    }
}

/// What the scene gives is nothing to be found. What is found from conditions stands in a scene as if it were given.
fn given_answers(posed: &Posed, question: &Question, file: &QuestionFile, faults: &mut Faults) {
    let Ok(given) = pose(&posed.scene) else { return };
    if !question.scene.unknowns.is_empty() {
        return;
    }
    let answers = question.parts.iter().flat_map(|part| &part.answers);
    let written = file.parts.iter().flat_map(|part| &part.answers);
    for (answer, written) in answers.zip(written) {
        let asked = answer.find.quantities();
        if let (Some(words), true) = (written.find.first(), asked.iter().all(|asked| given.0.contains_key(asked))) {
            let message = format!("`{}` is given by the scene, so there is nothing to find", words.get_ref());
            let help = "ask for something else; or name it in `unknowns` of `[scene]`, with what determines it in `conditions`";
            faults.report(words.span(), message, "asked for here", help);
        }
    }
}

/// A condition on what the scene determines without it says nothing of the unknown, which comes from somewhere else.
fn given_conditions(posed: &Posed, scene: &SceneFile, faults: &mut Faults) {
    let Ok(given) = pose(&posed.scene) else { return };
    let is_open = |value: &Value| value.has_letter(|letter| posed.scene.unknowns.contains(letter));
    for (place, condition) in posed.scene.conditions.iter().enumerate() {
        let names: Vec<_> = [&condition.left, &condition.right].into_iter().flat_map(Expr::names).collect();
        let quantities: Option<Vec<Quantity>> = names.iter().map(|name| name.text.parse().ok()).collect();
        let Some(quantities) = quantities.filter(|of| !of.is_empty()) else { continue };
        let mut known = given.clone();
        Derivation::carry_out(&mut known, &quantities);
        let is_determined = |quantity: &Quantity| known.number(*quantity).is_some_and(|value| !is_open(&value));
        if !quantities.iter().all(is_determined) {
            continue;
        }
        if let Some(words) = scene.words(&format!("conditions[{place}]")) {
            let message = format!("the condition says of `{}` what the scene determines without it", quantities[0]);
            let help = "take the condition out, or leave out of the scene what gives the same";
            faults.report(words.span(), message, "nothing is found from it", help);
        }
    }
}

/// A fault of the value of a parameter or derived name.
fn given(name: &str, fault: Fault, question: &Question, file: &QuestionFile, faults: &mut Faults) {
    let style = question.styles[question.reference_style].name.name();
    let own = file.styles.iter().filter(|written| written.name.get_ref() == style).flat_map(|style| &style.lets);
    let all = file.reference.iter().chain(own).chain(&file.lets);
    if let Some((_, words)) = all.into_iter().find(|(written, _)| written.get_ref() == name) {
        with_reference(words, fault, faults);
    }
}

fn in_scene(found: SceneFault, scene: &SceneFile, faults: &mut Faults) {
    let SceneFault { field, fault, is_of_the_form } = found;
    match scene.words(&field) {
        Some(words) if !is_of_the_form => with_reference(words, fault, faults),
        _ => {
            let with = if is_of_the_form { "" } else { "with the reference numbers: " };
            let help = fault.help.unwrap_or_else(|| MEND_SCENE.to_owned());
            faults.report(scene.place(&field), format!("{with}{}", fault.message), fault.expected, help);
        }
    }
}

/// A fault that only shows once numbers are put in; its place within the string may be that of a number put in.
fn with_reference(words: &Words, fault: Fault, faults: &mut Faults) {
    let message = format!("with the reference numbers: {}", fault.message);
    let inside = fault.span.end <= words.get_ref().len();
    let span = if inside { fault.span } else { Default::default() };
    let help = fault.help.or_else(|| Some("mend the formula, or take other numbers in `[reference]`".to_owned()));
    faults.expression(words, Fault { message, span, help, ..fault });
}

/// Requirements must have a truth, if not hold, with the reference numbers.
fn requirements(posed: &Posed, style: &Style, file: &QuestionFile, faults: &mut Faults) {
    let own = file.styles.iter().filter(|written| written.name.get_ref() == style.name.name());
    let written = file.require.iter().chain(own.flat_map(|written| &written.require));
    for (requirement, words) in style.require.iter().zip(written) {
        if let Err(fault) = requirement.holds(&|name| posed.meaning(name)) {
            with_reference(words, fault, faults);
        }
    }
}

fn refused(
    refusal: &Refusal,
    question: &Question,
    givens: &Givens,
    file: &QuestionFile,
    scene: &SceneFile,
    faults: &mut Faults,
) {
    let Ok(read) = Scene::read(&question.scene, givens, Angles::Degrees) else { return };
    // If the collision itself is sound, each quantity that is left open is a fault of its own.
    if refusal.because == Because::Underdetermined && solve(&read, &[]).is_ok() && open(&read, question, file, faults) {
        return;
    }
    let (message, label) = match refusal.because {
        Because::Impossible => ("with its reference numbers the collision cannot happen", &file.reference_span),
        Because::Underdetermined => ("with its reference numbers the question has no single answer", &None),
        Because::BeyondMethods => ("the question needs more than exam methods", &None),
    };
    // What is to be found and is not found is nearer than the scene.
    let nearest = || {
        let words = scene.words("unknowns[0]").or_else(|| scene.words("conditions[0]"));
        words.map_or(scene.span.clone(), |words| words.span())
    };
    let span = label.clone().unwrap_or_else(nearest);
    let other = match refusal.because {
        Because::Impossible => "take numbers in `[reference]` for which you know the answers",
        _ => "give more in `[scene]`, or other `conditions`: one equation for each of `unknowns`",
    };
    let unknown = || unknown_meant(refusal, question, givens);
    let help = refusal.help.clone().or_else(unknown).unwrap_or_else(|| other.to_owned());
    faults.report(span, message, refusal.reason.clone(), help);
}

/// The letter that makes an impossible collision possible, once it is one to be found.
fn unknown_meant(refusal: &Refusal, question: &Question, givens: &Givens) -> Option<String> {
    let scene = &question.scene;
    let is_open = refusal.because == Because::Impossible && scene.unknowns.is_empty() && scene.conditions.is_empty();
    let possible = |letter: &&String| {
        let with_unknown = SceneText { unknowns: vec![(*letter).clone()], ..scene.clone() };
        Scene::read(&with_unknown, givens, Angles::Degrees).is_ok_and(|scene| solve(&scene, &[]).is_ok())
    };
    let letter = scene.symbols.keys().filter(|_| is_open).find(possible)?;
    Some(format!("if `{letter}` is to be found, write `unknowns = [\"{letter}\"]` in `[scene]`"))
}

/// Reports what is asked for and not determined by the scene; was there any such thing?
fn open(read: &Scene, question: &Question, file: &QuestionFile, faults: &mut Faults) -> bool {
    let (mut is_told, mut open): (bool, Vec<(&Words, Quantity)>) = (false, Vec::new());
    for words in wanted(question, file) {
        let quantity = words.get_ref().parse::<Quantity>();
        if let Ok(quantity) = quantity
            && solve(read, &[quantity]).is_err()
        {
            let impacts = question.scene.then.len() + 1;
            if usize::from(quantity.impact()) >= impacts {
                let message = format!("`{quantity}` is of an impact that the scene does not have");
                let label = if impacts == 1 { "it has one".to_owned() } else { format!("it has {impacts}") };
                let help = format!("ask for `{}`, or add the impact as `[[scene.then]]`", quantity.of_its_impact());
                faults.report(words.span(), message, label, help);
                is_told = true;
                continue;
            }
            open.push((words, quantity));
        }
    }
    if let Some((words, quantity)) = open.first() {
        let others = match open.len() - 1 {
            0 => String::new(),
            1 => ", nor what else is asked for".to_owned(),
            more => format!(", nor {more} others for which you ask"),
        };
        let message = format!("the scene does not determine `{quantity}`{others}");
        let own = usize::from(quantity.impact()).checked_sub(1).and_then(|place| question.scene.then.get(place));
        let help = match needs_only_e(read, *quantity) {
            _ if own.is_some_and(|then| then.e.is_none()) => {
                "give `e` in the `[[scene.then]]` of this impact, or ask for something else".to_owned()
            }
            true => "give more in `[scene]`, such as `e`, the coefficient of restitution, or ask for something else"
                .to_owned(),
            false => match left_out(&question.scene) {
                Some(missing) => format!("give in `[scene]` {missing}, or ask for something else"),
                None => "give more in `[scene]`, or ask for something else".to_owned(),
            },
        };
        faults.report(words.span(), message, "asked for here, with the reference numbers", help);
    }
    is_told || !open.is_empty()
}

/// Would a coefficient of restitution, which the scene does not give, determine the quantity?
fn needs_only_e(scene: &Scene, quantity: Quantity) -> bool {
    let half = Given { value: Value::fraction(1, 2), shown: Expr::Decimal("0.5".to_owned()) };
    let with_e = || Scene { restitution: Some(half), ..scene.clone() };
    scene.restitution.is_none() && solve(with_e(), &[quantity]).is_ok()
}

/// The first thing that a scene of two spheres, or of one and a wall, has as a rule and this one has not.
fn left_out(scene: &SceneText) -> Option<&'static str> {
    if scene.before.a.is_none() {
        return Some("the velocity of *A* before, `before.A`");
    }
    match (scene.is_of_one(), scene.masses.b.is_some()) {
        (true, _) => None,
        (false, false) if scene.before.b.is_none() => {
            Some("what *A* meets, a sphere by `masses.B` and `before.B` or a `wall`")
        }
        (false, false) => Some("the mass of *B*, `masses.B`"),
        (false, true) if scene.before.b.is_none() => {
            Some("the velocity of *B* before, `before.B`, which is nought if it is at rest")
        }
        (false, true) => scene.masses.a.is_none().then_some("the mass of *A*, `masses.A`"),
    }
}

/// Every string that asks for a quantity.
fn wanted<'f>(question: &Question, file: &'f QuestionFile) -> Vec<&'f Words> {
    let is_quantity = |words: &&Words| !question.scene.unknowns.contains(words.get_ref());
    let finds = file.parts.iter().flat_map(|part| &part.answers).flat_map(|answer| &answer.find);
    finds.filter(is_quantity).collect()
}
