//! What a scene has by a sign or by a letter, and a student only by the words: which way things move, and what a letter is.

use super::sentence::{Sentence, Token, is_one_of, says, sentences};
use crate::bank::{Question, Style};
use crate::examine::Finding;
use crate::expr::{Angles, Expr, Function, print, read};
use crate::mechanics::VelocityText;

/// Words by which one motion is told from another in its line.
const WAYS: [&str; 38] = [
    "towards",
    "toward",
    "opposite",
    "opposing",
    "same",
    "behind",
    "catches",
    "catch",
    "overtakes",
    "overtake",
    "away",
    "positive",
    "negative",
    "approach",
    "approaching",
    "approaches",
    "follows",
    "following",
    "ahead",
    "front",
    "left",
    "right",
    "east",
    "west",
    "north",
    "south",
    "head-on",
    "head",
    "meet",
    "meets",
    "chasing",
    "chases",
    "pursuing",
    "rear",
    "back",
    "trailing",
    "sense",
    "faster",
];

/// Two spheres that move in one line, and components along the line of centres, of which no word says which way.
pub fn ways(question: &Question) -> Vec<Finding> {
    let found = question.styles.iter().find_map(|style| in_a_line(question, style).or_else(|| component(style)));
    found.into_iter().map(Finding::as_warning).collect()
}

fn said(style: &Style) -> Vec<Sentence<'_>> {
    style.stem.iter().chain([&style.note]).flat_map(sentences).collect()
}

/// Two spheres that move before a direct impact, and none of them is said to go towards the other or after it.
fn in_a_line(question: &Question, style: &Style) -> Option<Finding> {
    let before = &question.scene.before;
    let moves = |velocity: &Option<VelocityText<String>>| match velocity {
        Some(VelocityText::Along(text)) => text.trim() != "0",
        _ => false,
    };
    let is_vector = |expr: &Expr| expr.names().iter().any(|name| name.text == "i");
    let said = said(style);
    // `The same straight line` has two ways.
    let is_of_a_way =
        |next: Option<&Token>| next.is_some_and(|next| is_one_of(next, &["direction", "directions", "sense", "way"]));
    let tells = |sentence: &Sentence, place: usize| match &sentence[place] {
        Token::Number(expr, ..) => matches!(expr, Expr::Vector(..)) || is_vector(expr),
        token if is_one_of(token, &["direction"]) => {
            sentence.get(place + 1).is_some_and(|next| is_one_of(next, &["from"]))
        }
        token if is_one_of(token, &["same"]) => is_of_a_way(sentence.get(place + 1)),
        token => is_one_of(token, &WAYS),
    };
    let is_told = said.iter().any(|sentence| (0..sentence.len()).any(|place| tells(sentence, place)));
    if !moves(&before.a) || !moves(&before.b) || is_told {
        return None;
    }
    let message = "the words never tell which way the spheres move before they collide";
    let help = "say `towards each other in opposite directions`, or `in the same direction`, as the scene has it";
    Some(Finding::new(message, "collide", "a student cannot know it").with_help(help))
}

/// `A component of 3 m/s along the line of centres`, which has two ends.
fn component(style: &Style) -> Option<Finding> {
    said(style).iter().find_map(|sentence| {
        let is_one = |token: &Token| is_one_of(token, &["component", "components"]);
        let mut clauses = sentence.split(is_one).skip(1);
        let is_open = |clause: &&[Token]| {
            let begins = matches!(clause.first(), Some(Token::Number(..)));
            let is_along = clause.iter().skip(1).take(6).any(|token| is_one_of(token, &["centres", "centers"]))
                && clause.get(1).is_some_and(|token| is_one_of(token, &["along"]));
            let others = ["directed", "direction", "from", "sense", "each"];
            begins && is_along && !says(clause, &WAYS) && !says(clause, &others)
        };
        let clause = clauses.find(is_open)?;
        let Some(Token::Number(_, _, lead)) = clause.first() else { return None };
        let message = "the words never tell which way a component along the line of centres points";
        let help = "go on with `towards *B*` or `away from *B*`";
        Some(Finding::new(message, lead.trim(), "it may point either way").with_help(help))
    })
}

/// Coefficients of restitution that are printed, as letters or as numbers, of which no sentence says so.
pub fn coefficients(question: &Question) -> Vec<Finding> {
    let scene = &question.scene;
    let of = scene.e.iter().chain(scene.then.iter().filter_map(|then| then.e.as_ref()));
    let given: Vec<Expr> = of.filter_map(|e| read(e, Angles::Degrees).ok()).collect();
    let mut pairs = given.iter().flat_map(|e| question.styles.iter().map(move |style| (e, style)));
    pairs.find_map(|(e, style)| coefficient(question, style, e)).into_iter().collect()
}

/// One of them, in the words of a style.
fn coefficient(question: &Question, style: &Style, e: &Expr) -> Option<Finding> {
    const TELLING: [&str; 6] = ["coefficient", "elastic", "elasticity", "newton's", "denote", "denoted"];
    // There is a coefficient of friction too, and a modulus of elasticity.
    const OTHERWISE: [&str; 6] = ["friction", "modulus", "fraction", "proportion", "percentage", "energy"];
    let is_known = |name: &str| question.scene.symbols.contains_key(name) || question.is_given(style, name);
    let names = e.names();
    if names.is_empty() || !names.iter().all(|name| is_known(&name.text)) {
        return None;
    }
    let in_parameters = |expr: &Expr| print::plain(&in_parameters(expr, style));
    let whole = in_parameters(e);
    // A letter alone is known in every formula that has it.
    let has = |expr: &Expr| match e {
        Expr::Name(own) if expr.names().iter().any(|name| name.text == own.text) => true,
        _ => in_parameters(expr) == whole,
    };
    let asks = question.parts.iter().flat_map(|part| &part.ask);
    let said: Vec<Sentence> = style.stem.iter().chain([&style.note]).chain(asks).flat_map(sentences).collect();
    let is_in = |token: &Token| matches!(token, Token::Number(expr, ..) if has(expr));
    let printing: Vec<&Sentence> = said.iter().filter(|sentence| sentence.iter().any(is_in)).collect();
    let is_other = |sentence: &Sentence| says(sentence, &OTHERWISE) && !says(sentence, &["restitution"]);
    let tells =
        |sentence: &Sentence| says(sentence, &["restitution"]) || (says(sentence, &TELLING) && !is_other(sentence));
    // `For the spheres the coefficient of restitution is {e}; for the wall it is {f}.`
    let goes_on = |pair: &[Sentence]| {
        pair[1].iter().any(is_in)
            && tells(&pair[0])
            && says(&pair[1], &["it", "this", "that", "value", "corresponding"])
    };
    if printing.iter().any(|sentence| tells(sentence)) || said.windows(2).any(goes_on) {
        return None;
    }
    let formulas = printing.iter().flat_map(|sentence| sentence.iter()).filter_map(|token| match token {
        Token::Number(expr, ..) if has(expr) => Some(*expr),
        _ => None,
    });
    let shown = print::plain(formulas.min_by_key(|expr| print::plain(expr).len())?);
    let message = format!("the words print `{shown}`, and never tell that it is a coefficient of restitution");
    let help =
        format!("say it in the stem, as in `The coefficient of restitution between *A* and *B* is {{{shown}}}.`");
    let found = Finding::new(message, format!("{{{shown}}}"), "a student cannot know it").with_help(help);
    Some(if printing.iter().any(|sentence| is_other(sentence)) { found } else { found.as_warning() })
}

/// A formula with all that `[let]` derives written out.
fn in_parameters(expr: &Expr, style: &Style) -> Expr {
    let derive = |whole: Expr, (name, meaning): &(String, Expr)| {
        whole.substitute(&|own| if own == name { Some(meaning.clone()) } else { None })
    };
    style.lets.iter().rev().fold(expr.clone(), derive)
}

/// Angles that the scene takes in degrees, and whose values or formulas are in radians.
pub fn in_radians(question: &Question) -> Vec<Finding> {
    let scene = &question.scene;
    let velocities = [&scene.before.a, &scene.before.b, &scene.after.a, &scene.after.b].into_iter().flatten();
    let angles = velocities.filter_map(|velocity| match velocity {
        VelocityText::Polar(polar) => polar.angle_deg.as_ref(),
        _ => None,
    });
    let mut findings = Vec::new();
    for angle in angles {
        let Ok(taken) = read(angle, Angles::Degrees) else { continue };
        if is_small(&taken) {
            let message = format!("`angle_deg` is in degrees, and `{angle}` has so many radians");
            let found = Finding::new(message, format!("\"{angle}\""), "a number of degrees");
            findings.push(found.with_help("write the number of degrees alone, without `deg`"));
        }
        for style in &question.styles {
            for (name, domain) in
                style.parameters.iter().filter(|(name, _)| taken.names().iter().any(|own| own.text == *name))
            {
                let Some(value) = domain.formulas().iter().find(|value| is_radian(value)) else { continue };
                let shown = print::plain(value);
                let message = format!("`{name}` is taken in degrees, and `{shown}` is in radians");
                let found = Finding::at_parameter(message, style.name, name, "a number of degrees");
                findings.push(found.with_help(format!("write `{shown}/deg`, or the number of degrees")));
            }
        }
    }
    findings
}

/// Has it an angle by a letter or an inverse function, which nothing turns into degrees?
fn is_radian(expr: &Expr) -> bool {
    let has = |of: &dyn Fn(&Expr) -> bool| any(expr, of);
    has(&|inner| matches!(inner, Expr::Pi | Expr::Call(Function::Asin | Function::Acos | Function::Atan, _)))
        && !has(&|inner| matches!(inner, Expr::Degrees(_)))
}

/// Is it a number of degrees turned into radians?
fn is_small(expr: &Expr) -> bool {
    match expr {
        Expr::Degrees(_) => true,
        // An angle in radians over a degree is their number, and a sine is no angle.
        Expr::Quotient(_, below) if any(below, &|inner| matches!(inner, Expr::Degrees(_))) => false,
        Expr::Call(..) => false,
        other => other.children().into_iter().any(is_small),
    }
}

fn any(expr: &Expr, of: &dyn Fn(&Expr) -> bool) -> bool {
    of(expr) || expr.children().into_iter().any(|inner| any(inner, of))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::examine::{Edits, edited};

    #[test]
    fn ways_and_letters_are_told() {
        const TOLD: &str = "The coefficient of restitution between the spheres is {e}.";
        let line = "direct/velocities-after-impact";
        let (components, again, rest) =
            ("both-moving/components-given", "successive/second-collision", "rest/speeds-and-directions");
        let table: [(&str, Edits, &str); 22] = [
            (line, &[], ""),
            (
                again,
                &[
                    (
                        "The coefficient of restitution between the spheres is {e}.\n\nLater *B* strikes the wall. The coefficient of restitution",
                        "Later *B* strikes the wall. The coefficient of restitution between the spheres is {e}; that",
                    ),
                    ("and the wall is {f}", "and the wall, it is {f}"),
                ],
                "",
            ),
            (
                line,
                &[("are moving towards each other in opposite directions", "are moving")],
                "which way the spheres move",
            ),
            (line, &[("are moving towards each other in opposite directions", "are moving, and collide head-on")], ""),
            ("direct/one-sphere-catches-the-other", &[], ""),
            (components, &[], ""),
            (
                components,
                &[("along the line of centres, towards *A*, and", "along the line of centres, and")],
                "which way a component",
            ),
            (again, &[], ""),
            (
                again,
                &[("coefficient of restitution between *B* and the wall", "corresponding coefficient for the wall")],
                "",
            ),
            (
                again,
                &[(" The coefficient of restitution between *B* and the wall is {f}.", "")],
                "print `f`, and never tell",
            ),
            (rest, &[(TOLD, "The coefficient of friction between the spheres is {e}.")], "print `e`, and never tell"),
            (rest, &[(TOLD, "The modulus of elasticity of the spheres is {e}.")], "print `e`, and never tell"),
            (rest, &[(TOLD, "The fraction of the kinetic energy lost is {e}.")], "print `e`, and never tell"),
            (rest, &[(TOLD, "For the spheres *A* and *B* it is {e}.")], "print `e`, and never tell"),
            (rest, &[(TOLD, "In Newton's law of impact it is {e}.")], ""),
            (
                rest,
                &[(TOLD, "The coefficient of friction is {r}."), ("kA = \"", "r = \"e\"\nkA = \"")],
                "print `r`, and never tell",
            ),
            (rest, &[(TOLD, "The coefficient of restitution is {r}."), ("kA = \"", "r = \"e\"\nkA = \"")], ""),
            (
                rest,
                &[("[\"30\", \"60\"]", "[\"pi/6\", \"pi/3\"]")],
                "`alpha` is taken in degrees, and `pi/6` is in radians",
            ),
            (rest, &[("angle_deg = \"alpha\"", "angle_deg = \"alpha*deg\"")], "`alpha*deg` has so many radians"),
            (rest, &[("angle_deg = \"alpha\"", "angle_deg = \"-alpha*deg\"")], "`-alpha*deg` has so many radians"),
            (rest, &[("angle_deg = \"alpha\"", "angle_deg = \"-atan(3/4)/deg\"")], ""),
            (rest, &[("angle_deg = \"alpha\"", "angle_deg = \"360 - atan(3/4)/deg\"")], ""),
        ];
        for (id, edits, words) in table {
            let question = edited(id, edits);
            let found = [ways, coefficients, in_radians].into_iter().flat_map(|check| check(&question));
            let said: String = found.map(|finding| finding.message).collect();
            assert!(said.contains(words) && said.is_empty() == words.is_empty(), "{id}: {edits:?}: {said}");
        }
    }
}
