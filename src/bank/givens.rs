//! Numbers in place of a question's parameters and derived names.

use std::collections::BTreeMap;

use super::question::Style;
use crate::expr::{Expr, Fault, Function, Meaning, Turn, evaluate, written};
use crate::mechanics::SceneText;
use crate::number::{Angle, Letter, Range, Value};

/// What every given name of a style stands for, in one variant.
#[derive(Clone, Debug, Default)]
pub struct Givens {
    /// As it is printed: parameters as they stand in their domain, derived names in their simplest form.
    pub shown: BTreeMap<String, Expr>,
    meanings: BTreeMap<String, Meaning>,
}

impl Givens {
    /// The givens for a set of parameters.
    ///
    /// # Errors
    ///
    /// The first formula without a value, with its name: a division by nought, a root of a negative number.
    pub fn new(style: &Style, parameters: &[(String, Expr)], scene: &SceneText) -> Result<Givens, (String, Fault)> {
        let mut givens = Givens::default();
        for (name, range) in &scene.symbols {
            givens.meanings.extend(letter(name, range).map(|meaning| (name.clone(), meaning)));
        }
        for (name, expr) in parameters {
            let meaning = evaluate(expr, &|name| givens.meaning(name)).map_err(|fault| (name.clone(), fault))?;
            givens.meanings.insert(name.clone(), meaning);
            givens.shown.insert(name.clone(), expr.clone());
        }
        for (name, expr) in &style.lets {
            let meaning = evaluate(expr, &|name| givens.meaning(name)).map_err(|fault| (name.clone(), fault))?;
            let typed = expr.substitute(&|name| givens.shown.get(name).cloned());
            let shown = match &meaning {
                Meaning::Number(value) => in_order_of(&typed, written(value)),
                _ => typed,
            };
            givens.meanings.insert(name.clone(), meaning);
            givens.shown.insert(name.clone(), shown);
        }
        Ok(givens)
    }

    /// What a parameter, derived name or letter stands for.
    pub fn meaning(&self, name: &str) -> Option<Meaning> {
        self.meanings.get(name).cloned()
    }

    /// Is it a parameter, derived name or letter?
    pub fn contains(&self, name: &str) -> bool {
        self.meanings.contains_key(name)
    }
}

/// A product with its factors in the order in which they were typed: `km`, and not `mk`.
fn in_order_of(typed: &Expr, product: Expr) -> Expr {
    let (Expr::Product(typed), Expr::Product(factors)) = (typed, &product) else { return product };
    let typed: Vec<Expr> = typed.iter().filter(|factor| !factor.is_one()).cloned().collect();
    let is_same = typed.len() == factors.len() && factors.iter().all(|factor| typed.contains(factor));
    if is_same { Expr::Product(typed) } else { product }
}

/// A letter that the scene declares: an acute angle, or a number.
fn letter(name: &str, range: &str) -> Option<Meaning> {
    let (_, range) = Range::DECLARED.into_iter().find(|(word, _)| *word == range)?;
    let value = Value::letter(Letter::new(name, range)?);
    match range {
        Range::Acute => Some(Meaning::Angle(Turn::of(Angle::of(&value, &Value::ONE)?))),
        _ => Some(Meaning::Number(value)),
    }
}

/// The expression with each name under a sine, cosine or tangent taken in degrees, as a bare number there is: in
/// `tan(alpha)` the parameter `alpha` is a number of degrees. An angle stays the angle that it is.
pub(crate) fn names_in_degrees(expr: &Expr) -> Expr {
    match expr {
        Expr::Call(function @ (Function::Sin | Function::Cos | Function::Tan), argument) => {
            Expr::call(*function, measured(argument))
        }
        _ => expr.map_children(&mut names_in_degrees),
    }
}

fn measured(argument: &Expr) -> Expr {
    match argument {
        Expr::Name(_) => Expr::degrees(argument.clone()),
        Expr::Degrees(_) | Expr::Call(..) => names_in_degrees(argument),
        _ => argument.map_children(&mut measured),
    }
}
