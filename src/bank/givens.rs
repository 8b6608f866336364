//! Numbers in place of a question's parameters and derived names.

use std::sync::Arc;

use super::question::Style;
use crate::expr::{Expr, Fault, Function, Meaning, Turn, evaluate, written};
use crate::mechanics::{Parameters, SceneText};
use crate::number::{Angle, Letter, Range, Value};

/// The names that a style gives, which are the same for all its sets of numbers.
#[derive(Debug, Default)]
pub struct GivenNames {
    // Letters of the scene, parameters, derived names. There are few, and a later one hides an earlier one of the same name.
    names: Vec<String>,
    /// What the letters mean.
    letters: Vec<Meaning>,
}

impl GivenNames {
    /// Those of a style whose parameters have these names.
    pub fn of<'n>(style: &'n Style, parameters: impl Iterator<Item = &'n String>, scene: &SceneText) -> GivenNames {
        let letters = scene.symbols.iter().filter_map(|(name, range)| Some((name.clone(), letter(name, range)?)));
        let (mut names, letters): (Vec<String>, Vec<Meaning>) = letters.unzip();
        names.extend(parameters.chain(style.lets.iter().map(|(name, _)| name)).cloned());
        GivenNames { names, letters }
    }
}

/// What every given name of a style stands for, in one variant.
#[derive(Clone, Debug, Default)]
pub struct Givens {
    names: Arc<GivenNames>,
    /// Of each name, by its place.
    given: Vec<Given>,
}

#[derive(Clone, Debug)]
struct Given {
    /// As it is printed: a parameter as it stands in its domain, a derived name in its simplest form. A letter of the scene
    /// stands for itself.
    shown: Option<Expr>,
    meaning: Meaning,
}

impl Givens {
    /// The givens for a set of parameters.
    ///
    /// # Errors
    ///
    /// The first formula without a value, with its name: a division by nought, a root of a negative number.
    pub fn new(style: &Style, parameters: &[(String, Expr)], scene: &SceneText) -> Result<Givens, (String, Fault)> {
        let names = GivenNames::of(style, parameters.iter().map(|(name, _)| name), scene);
        Givens::with_meanings(style, Arc::new(names), parameters.iter().map(|(_, value)| value), &|_| None)
    }

    /// The same for the values of the parameters that are among the names, where the meanings of some are known already, by
    /// their places.
    ///
    /// # Errors
    ///
    /// As for [`Givens::new`].
    pub fn with_meanings<'v>(
        style: &Style,
        names: Arc<GivenNames>,
        values: impl Iterator<Item = &'v Expr>,
        known: &dyn Fn(usize) -> Option<Meaning>,
    ) -> Result<Givens, (String, Fault)> {
        let mut given = Vec::with_capacity(names.names.len());
        given.extend(names.letters.iter().map(|meaning| Given { shown: None, meaning: meaning.clone() }));
        let mut givens = Givens { names, given };
        for (place, value) in values.enumerate() {
            let meaning = known(place).map_or_else(|| evaluate(value, &|name| givens.meaning(name)), Ok);
            givens.add(value.clone(), meaning)?;
        }
        for (_, expr) in &style.lets {
            let meaning = evaluate(expr, &|name| givens.meaning(name));
            let typed = || expr.substitute(&|name| givens.shown(name).cloned());
            let shown = match &meaning {
                Ok(Meaning::Number(value)) => match written(value) {
                    product @ Expr::Product(_) => in_order_of(&typed(), product),
                    simple => simple,
                },
                _ => typed(),
            };
            givens.add(shown, meaning)?;
        }
        Ok(givens)
    }

    fn add(&mut self, shown: Expr, meaning: Result<Meaning, Fault>) -> Result<(), (String, Fault)> {
        let meaning = meaning.map_err(|fault| (self.names.names[self.given.len()].clone(), fault))?;
        self.given.push(Given { shown: Some(shown), meaning });
        Ok(())
    }

    fn named(&self, name: &str) -> impl Iterator<Item = &Given> {
        self.given.iter().zip(&self.names.names).rev().filter(move |(_, own)| *own == name).map(|(given, _)| given)
    }

    /// How a parameter or derived name is printed.
    pub fn shown(&self, name: &str) -> Option<&Expr> {
        self.named(name).find_map(|given| given.shown.as_ref())
    }

    /// What a parameter, derived name or letter stands for.
    pub fn meaning(&self, name: &str) -> Option<Meaning> {
        self.named(name).next().map(|given| given.meaning.clone())
    }

    /// Is it a parameter, derived name or letter?
    pub fn contains(&self, name: &str) -> bool {
        self.named(name).next().is_some()
    }
}

impl Parameters for Givens {
    fn shown(&self, name: &str) -> Option<&Expr> {
        self.shown(name)
    }

    fn meaning(&self, name: &str) -> Option<Meaning> {
        self.meaning(name)
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
