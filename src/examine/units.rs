//! Are the numbers that the scene takes said in their units?

use super::finding::Finding;
use super::given::unit_of;
use crate::bank::{Question, Style};
use crate::expr::{Angles, Expr, Piece, read};
use crate::mechanics::VelocityText;
use crate::unit::Unit;

/// Numbers in the words with the unit of something else, and angles without theirs.
pub fn astray(question: &Question) -> Vec<Finding> {
    let mut findings: Vec<Finding> = Vec::new();
    for style in &question.styles {
        let asks = question.parts.iter().flat_map(|part| &part.ask);
        for text in style.stem.iter().chain([&style.note]).chain(asks) {
            of_text(&text.0, question, style, &mut findings);
        }
    }
    // Styles share most of their words.
    findings.sort_by(|one, other| one.message.cmp(&other.message));
    findings.dedup();
    findings
}

fn of_text(pieces: &[Piece], question: &Question, style: &Style, findings: &mut Vec<Finding>) {
    for piece in pieces {
        let (expr, said) = match piece {
            Piece::Italic(inner) => {
                of_text(inner, question, style, findings);
                continue;
            }
            Piece::Quantity(expr, unit) => (expr, *unit),
            Piece::Formula(expr) => (expr, Unit::None),
            _ => continue,
        };
        let Expr::Name(name) = expr else { continue };
        let own = if is_in_degrees(&name.text, question) { Unit::Degree } else { unit_of(&name.text, &question.scene) };
        // A letter brings its unit with it, and a bare mass or speed may be one of several: 'masses 3m and {k}m'.
        let is_bare = said == Unit::None && (own != Unit::Degree || !is_number(&name.text, style));
        if own == Unit::None || own == said || is_bare {
            continue;
        }
        let (said, own, name) = (said.plain(), own.plain(), &name.text);
        let (at, message) = match said {
            "" => (format!("{{{name}}}"), format!("the angle `{name}` is said without a unit")),
            _ => (format!("{{{name} {said}}}"), format!("`{name}` is said in {said}, and the scene takes it in {own}")),
        };
        findings
            .push(Finding::new(message, at, format!("expected {own}")).with_help(format!("write `{{{name} {own}}}`")));
    }
}

/// Is it a parameter whose values are all plain numbers?
fn is_number(name: &str, style: &Style) -> bool {
    let domain = style.parameters.iter().find(|(own, _)| own == name).map(|(_, domain)| domain);
    domain.is_some_and(|domain| (0..domain.size().min(100)).all(|place| domain.value(place).names().is_empty()))
}

/// Is it a number of degrees, or a term of one, as in `180 - beta`?
fn is_in_degrees(name: &str, question: &Question) -> bool {
    let scene = &question.scene;
    let velocities = [&scene.before.a, &scene.before.b, &scene.after.a, &scene.after.b].into_iter().flatten();
    let mut angles = velocities.filter_map(|velocity| match velocity {
        VelocityText::Polar(polar) => polar.angle_deg.as_ref(),
        _ => None,
    });
    angles.any(|angle| read(angle, Angles::Degrees).is_ok_and(|expr| has_term(&expr, name)))
}

fn has_term(expr: &Expr, name: &str) -> bool {
    match expr {
        Expr::Name(own) => own.text == name,
        Expr::Negative(inner) => has_term(inner, name),
        Expr::Sum(terms) => terms.iter().any(|term| has_term(term, name)),
        _ => false,
    }
}
