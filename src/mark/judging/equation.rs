//! Equations and inequalities: equal if they have the same solutions.
//!
//! Two equations have the same solutions if left minus right of one is a multiple of left minus right of the other, by a
//! factor that is nought nowhere in the ranges of the letters: `2mv + 3mw = 4mu` is `2v + 3w = 4u`, since m is never
//! nought. What stands below a line is nought for neither. For an inequality the factor must be positive.

use std::cmp::Ordering;
use std::sync::OnceLock;

use crate::expr::{Expr, Meaning, Relation};
use crate::mark::reading::{Form, Reading, Statement};
use crate::number::{Letter, Polynomial, Value};

use super::exact::{self, Equality, same};
use super::finding::Finding;
use super::statements::is_rival;
use super::{Model, Note};

/// Judges a whole reading against an equation: all that it states must be right.
pub(super) fn judge(model: &Model, reading: &Reading) -> Finding {
    let each = reading.statements.iter().map(|statement| judge_statement(model, statement));
    let found: Vec<Finding> = each.collect();
    let any_rival = reading.statements.iter().flat_map(|statement| &statement.said).any(is_rival);
    match found.iter().position(Finding::is_credited) {
        Some(_) if any_rival && !found.iter().all(Finding::is_credited) => Finding::wrong(Note::RivalAnswers),
        Some(_) if !found.iter().all(Finding::is_credited) => Finding::partial(Note::SeveralAnswers),
        Some(at) => found[at],
        None => found.last().copied().unwrap_or(Finding::unreadable(Note::CannotBeRead)),
    }
}

fn judge_statement(model: &Model, statement: &Statement) -> Finding {
    let letters = &model.vocabulary.letters;
    let Expr::Relation(left, _, right) = &model.value else { return Finding::unreadable(Note::CannotBeCompared) };
    let offered = equations(statement);
    if offered.is_empty() {
        let side = |form: &Form| match form {
            Form::Value(expr) => [left, right].iter().any(|side| same(side, expr, letters) == Equality::Equal),
            _ => false,
        };
        let half = statement.said.last().is_some_and(|said| side(&said.form));
        return if half { Finding::partial(Note::NotAnEquation) } else { Finding::wrong(Note::NotAnEquation) };
    }
    let found = offered.iter().map(|equation| {
        if exact::unknown_letter(equation, letters).is_some() {
            return Finding::wrong(Note::UnknownLetter);
        }
        match same_solutions(model, equation) {
            Equality::Equal => Finding::EXACT,
            Equality::Different => Finding::WRONG,
            Equality::Undecided => Finding::unreadable(Note::CannotBeCompared),
        }
    });
    found.reduce(Finding::and).unwrap_or(Finding::WRONG)
}

/// Every equation of a statement: `a = b = c` makes two.
pub(super) fn equations(statement: &Statement) -> Vec<Expr> {
    let mut sides: Vec<Expr> = statement.label.iter().filter_map(|label| label.expr.clone()).collect();
    let mut found = Vec::new();
    for said in &statement.said {
        match &said.form {
            Form::Equation(equation) => found.push(equation.clone()),
            Form::Value(expr) => sides.push(expr.clone()),
            _ => {}
        }
    }
    found.extend(sides.windows(2).map(|pair| Expr::equation(pair[0].clone(), pair[1].clone())));
    found
}

/// Left minus right of a relation, turned so that it is `=`, `!=`, `>` or `>=`.
pub(super) struct Difference {
    kind: Relation,
    value: Value,
    /// What is nought for the same letters, for an equation without roots; worked out when it is first asked for.
    plain: OnceLock<Value>,
}

impl Difference {
    pub(super) fn of(relation: &Expr, letters: &[Letter]) -> Option<Difference> {
        let (value, kind) = difference(relation, letters)?;
        Some(Difference { kind, value, plain: OnceLock::new() })
    }

    fn plain(&self) -> &Value {
        match self.kind {
            Relation::Equal => self.plain.get_or_init(|| without_roots(&numerator(&self.value))),
            _ => &self.value,
        }
    }
}

/// Does the relation hold for the same values of its letters as the model's?
pub(super) fn same_solutions(model: &Model, relation: &Expr) -> Equality {
    let (known, letters) = (model.known(), &model.vocabulary.letters);
    let Some(first) = known.difference() else { return Equality::Undecided };
    let Some(second) = Difference::of(relation, letters) else { return Equality::Undecided };
    let kind = first.kind;
    if kind != second.kind {
        return Equality::Different;
    }
    if first.value.is_zero() || second.value.is_zero() {
        let both = first.value.is_zero() == second.value.is_zero();
        return if both { Equality::Equal } else { Equality::Different };
    }
    if first.value.is_laborious() || second.value.is_laborious() {
        return Equality::Undecided;
    }
    let Some(factor) = second.plain().divided_by(first.plain()) else { return Equality::Undecided };
    match (factor.sign(), kind) {
        (Some(Ordering::Greater), _) | (Some(Ordering::Less), Relation::Equal | Relation::NotEqual) => Equality::Equal,
        _ => Equality::Different,
    }
}

/// What is nought where a quotient is: `e = (w - v)/(a - b)` is `w - v = e(a - b)`, whichever of a and b is larger.
fn numerator(quotient: &Value) -> Value {
    quotient * &Value::quotient(quotient.denominator(), Polynomial::one())
}

/// The same solutions without roots of letters, where that needs no case distinction: `a = b√r` is `a² = b²r` if
/// `a + b√r` is never nought. So `sin θ = 3/5` is seen to be `tan θ = 3/4`.
fn without_roots(difference: &Value) -> Value {
    let mut plain = difference.clone();
    for root in plain.roots().into_iter().rev() {
        if Value::root(root.clone()).is_constant() {
            continue;
        }
        let (a, b) = plain.split(&root);
        let conjugate = &a - &(&b * &Value::root(root));
        if conjugate.sign().is_some_and(Ordering::is_ne) {
            plain = &plain * &conjugate;
        }
    }
    plain
}

/// Left minus right, turned so that the relation is `=`, `!=`, `>` or `>=`.
fn difference(relation: &Expr, letters: &[Letter]) -> Option<(Value, Relation)> {
    let Expr::Relation(left, relation, right) = relation else { return None };
    let (left, right, relation) = match relation {
        Relation::Less => (right, left, Relation::Greater),
        Relation::LessOrEqual => (right, left, Relation::GreaterOrEqual),
        other => (left, right, *other),
    };
    let difference = match (exact::meaning(left, letters)?, exact::meaning(right, letters)?) {
        (Meaning::Number(left), Meaning::Number(right)) => &left - &right,
        // Angles of less than a half turn are equal where the sine of their difference is nought.
        (Meaning::Angle(left), Meaning::Angle(right)) if relation == Relation::Equal => {
            left.plus(&right.reversed())?.cross()?
        }
        _ => return None,
    };
    Some((difference, relation))
}
