//! Components after the impact that a student writes as `v cos β`, v and β both unknown: each is an unknown of its own.

use super::angles::{argument, put_everywhere, sides};
use crate::expr::{Expr, Function, Name, Relation};
use crate::mark::reading::{Form, Label};
use crate::mark::working::lines::ReadLine;
use crate::mark::working::numbers::any_within;
use crate::mark::working::prepared::Prepared;

/// Takes every component for one letter, and the value of one for the value of that letter.
pub(super) fn name_components(reading: &mut ReadLine, prepared: &Prepared) {
    let is_one = |expr: &Expr| matches!(expr, Expr::Product(factors) if component(factors, prepared).is_some());
    if !sides(reading).any(|expr| any_within(expr, &is_one)) {
        return;
    }
    let put = |expr: &Expr| as_component(expr, prepared);
    for statement in &mut reading.statements {
        let Some(label) = statement.label.as_mut() else { continue };
        let named = label.expr.as_ref().map(put);
        if let Some(Expr::Name(name)) = &named
            && named != label.expr
        {
            for member in reading.members.iter_mut().filter(|member| member.label.as_ref() == Some(&label.typed)) {
                member.letter = Some(name.text.clone());
            }
        }
        label.expr = named;
    }
    // `v cos β = 1.92` is no equation but a value with a name.
    for place in 1..reading.members.len() {
        let (named, is_open) = (put(&reading.members[place - 1].expr), reading.members[place - 1].label.is_none());
        if let Expr::Name(name) = &named
            && is_open
            && named != reading.members[place - 1].expr
        {
            reading.members[place].letter = Some(name.text.clone());
            reading.members[place].label = Some(name.text.clone());
        }
    }
    for statement in reading.statements.iter_mut().filter(|statement| statement.label.is_none()) {
        let Some(Form::Equation(Expr::Relation(left, Relation::Equal, right))) =
            statement.said.first().map(|said| &said.form)
        else {
            continue;
        };
        let (named, right) = (put(left), (**right).clone());
        if let Expr::Name(name) = &named
            && named != **left
        {
            statement.label = Some(Label { typed: name.text.clone(), expr: Some(named.clone()) });
            statement.said[0].form = Form::Value(right);
        }
    }
    put_everywhere(reading, &put);
}

/// Where the sine or cosine of an unknown angle and the letter of an unknown velocity stand among factors.
fn component(factors: &[Expr], prepared: &Prepared) -> Option<(usize, usize)> {
    let is_open = |name: &str| !prepared.gives(name);
    let function = factors.iter().position(|factor| match (factor, argument(factor)) {
        (Expr::Call(Function::Sin | Function::Cos, _), Some(Expr::Name(angle))) => is_open(&angle.text),
        _ => false,
    })?;
    let letter = factors.iter().position(|factor| match factor {
        Expr::Name(name) => is_open(&name.text) && name.text.starts_with(['v', 'w', 'V', 'W']),
        _ => false,
    })?;
    Some((function, letter))
}

/// The formula with one letter for each component, `v cos` for `v cos β`.
fn as_component(expr: &Expr, prepared: &Prepared) -> Expr {
    let parts = match expr {
        Expr::Product(factors) => component(factors, prepared).map(|places| (factors, places)),
        _ => None,
    };
    let Some((factors, (function, letter))) = parts else {
        return expr.map_children(&mut |child| as_component(child, prepared));
    };
    let (Expr::Call(which, _), Expr::Name(name)) = (&factors[function], &factors[letter]) else {
        return expr.clone();
    };
    let axis = if *which == Function::Cos { "cos" } else { "sin" };
    let text = match name.text.split_once('_') {
        Some((letter, sphere)) => format!("{letter} {axis}_{sphere}"),
        None => format!("{} {axis}", name.text),
    };
    let component = Expr::Name(Name { text, span: name.span });
    let others = factors.iter().enumerate().filter(|(place, _)| *place != function && *place != letter);
    let mut all: Vec<Expr> = others.map(|(_, factor)| factor.clone()).collect();
    match all.is_empty() {
        true => component,
        false => {
            all.push(component);
            Expr::Product(all)
        }
    }
}

/// Is there `v cos θ` with an unknown v, so that θ is an angle after the impact?
pub(in crate::mark::working) fn has_component(expr: &Expr, angle: &str, prepared: &Prepared) -> bool {
    let is_angle = |factor: &Expr| matches!(argument(factor), Some(Expr::Name(name)) if name.text == angle);
    match expr {
        Expr::Product(factors)
            if component(factors, prepared).is_some_and(|(function, _)| is_angle(&factors[function])) =>
        {
            true
        }
        other => other.children().into_iter().any(|child| has_component(child, angle, prepared)),
    }
}

/// The letter of a component without its sine or cosine.
pub(in crate::mark::working) fn whole(name: &str) -> String {
    name.replace(" cos", "").replace(" sin", "")
}
