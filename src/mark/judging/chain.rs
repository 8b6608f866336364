//! A chain of equals signs: which of its values counts.
//!
//! A value that is exactly right wins and what follows is ignored; else the last decides, unless an earlier right decimal
//! was only rounded further. Two bare numbers of which one is wrong are rivals, and what false arithmetic leads to is for a
//! person.

use crate::expr::{Expr, Function, Relation};
use crate::mark::enclosure::about;
use crate::mark::reading::{Form, Said, Statement};
use crate::mechanics::Quantity;

use super::accuracy::Written;
use super::exact::{self, Equality};
use super::finding::Finding;
use super::left_side::{self, Equation, Left};
use super::statements::One;
use super::{Model, Note, Verdict, called, vector};

/// One statement, perhaps a chain of equals signs.
pub(super) fn chain(model: &Model, statement: &Statement, one: One) -> Finding {
    let left = statement.label.as_ref().map_or(Left::Name, |label| left_side::of(model, label));
    let of_equation = |equation: &Equation| {
        let finding = links(statement, &|said, _| equation.judge(model, said, one));
        // `v² = 7.70 = 2.78`: the value itself, at the end of what led to it.
        let leads = statement.said.first().is_some_and(|first| equation.judge(model, first, one).is_credited());
        match statement.said.as_slice() {
            [_, .., last] if leads => finding.or_better(one(last, None)),
            _ => finding,
        }
    };
    let finding = match &left {
        Left::Equation(equation) => match of_equation(equation) {
            // `v + eu = …` is an equation for v, and what w is called by restitution.
            finding if !finding.is_credited() && equation.is_by_restitution(model) => {
                finding.or_better(links(statement, one))
            }
            finding if !finding.is_credited() => of_formula(model, statement, one).unwrap_or(finding),
            finding => finding,
        },
        _ => links(statement, &|said, label| match left_side::unnamed(model, said) {
            Some((equation, right)) => {
                let of_right = equation.judge(model, &Said { form: Form::Value(right.clone()), ..said.clone() }, one);
                of_right.or_better(one(said, label))
            }
            None => {
                let (finding, by_letter) = (one(said, label), || by_a_letter(model, said, one));
                if finding.is_credited() { finding } else { by_letter().unwrap_or(finding) }
            }
        }),
    };
    match left {
        // The angle itself, where its tangent is asked.
        Left::Another if left_side::is_tangent(model.quantity) && statement.said.iter().any(is_of_angle) => finding,
        Left::Another if finding.is_credited() && finding.note != Some(Note::AngleForTangent) => {
            Finding::unreadable(Note::NamedOtherwise)
        }
        Left::NameOrPower(equation) if !finding.is_credited() => match of_equation(&equation) {
            finding if finding.is_credited() => finding,
            finding => of_formula(model, statement, one).unwrap_or(finding),
        },
        _ => called::as_remarked(model, statement, called::as_called(model, statement, finding)),
    }
}

/// `√(v² + 3.625²) = 3.76`: what is asked, by its components of which one is a letter from the working; and `20(1 + f) = 35`
/// or `10√e = 3.84`, by a coefficient of restitution that has a value there, which is for a person. Other formulas are equations for the letter.
fn of_formula(model: &Model, statement: &Statement, one: One) -> Option<Finding> {
    worked_out(model, statement.label.as_ref()?.expr.as_ref()?, one(statement.said.last()?, None))
}

/// The same where nothing is named.
fn by_a_letter(model: &Model, said: &Said, one: One) -> Option<Finding> {
    let Form::Equation(Expr::Relation(formula, Relation::Equal, right)) = &said.form else { return None };
    worked_out(model, formula, one(&Said { form: Form::Value((**right).clone()), ..said.clone() }, None))
}

/// A formula, and what is found of the value to which it is said to come.
fn worked_out(model: &Model, formula: &Expr, last: Finding) -> Option<Finding> {
    if !last.is_correct() {
        return None;
    }
    let is_square = |term: &Expr| matches!(term, Expr::Power(_, two) if **two == Expr::integer(2));
    if let Expr::Call(Function::Sqrt, under) = formula
        && let Expr::Sum(terms) = &**under
        && terms.iter().any(|term| is_square(term) && !term.names().is_empty())
    {
        return Some(last);
    }
    // Where it was to be found before, no value has it as a letter.
    let is_restitution = |name: &str| matches!(name, "e" | "f") && !left_side::is_given(model, name);
    let names = formula.names();
    let is_by_restitution = !names.is_empty() && names.iter().all(|name| is_restitution(&name.text));
    let is_asked = model.quantity.is_none_or(|asked| asked.of_its_impact() == Quantity::Restitution);
    (is_by_restitution && !is_asked).then(|| Finding::unreadable(Note::CannotBeCompared))
}

fn is_of_angle(said: &Said) -> bool {
    said.unit.as_ref().is_some_and(|unit| unit.degrees)
}

/// A chain of equals signs.
pub(super) fn links(statement: &Statement, one: One) -> Finding {
    let label = statement.label.as_ref();
    let findings: Vec<Finding> = statement.said.iter().map(|said| one(said, label)).collect();
    let Some(last) = findings.last().copied() else { return Finding::unreadable(Note::CannotBeRead) };
    let spoilt_after = |at: usize| findings[at + 1..].iter().any(|finding| finding.verdict == Verdict::Wrong);
    // `2.78 = 3`: a right value, and a rounding of it.
    let only_rounded_after = |at: usize| {
        let later = findings.iter().zip(&statement.said).skip(at + 1);
        let mut wrong = later.filter(|(finding, _)| finding.verdict == Verdict::Wrong);
        wrong.all(|(_, said)| is_rounding(&statement.said[at], said))
    };
    let is_bare = |at: usize| is_bare_number(&statement.said[at]);
    // `2 = 3` and `3 = 4` are no working: two numbers that are said to be one are rivals.
    // What is only rounded too far is no other number; what is a little off is one.
    // `24² + 18² = 900 = 30`: an equals sign where the root is taken of what was worked out.
    let is_rooted = |at: usize| {
        let before = label.and_then(|label| label.expr.as_ref());
        let is_worked_out = at > 0 || before.is_some_and(|before| makes_about(before, &statement.said[at]));
        at + 1 < findings.len() && is_worked_out && is_square_of(&statement.said[at], &statement.said[at + 1])
    };
    // `2.7756 = 2.77`: the value is there, and rounded as it should not be.
    let is_rounded_wrongly = |at: usize| {
        let is_off = findings[at].note == Some(Note::NearMiss);
        is_off
            && (0..at).any(|before| {
                findings[before].is_correct() && is_nearly_rounding(&statement.said[before], &statement.said[at])
            })
    };
    let is_other = |at: usize| match findings[at].verdict {
        _ if is_rooted(at) || is_rounded_wrongly(at) => false,
        Verdict::Wrong => findings[at].note != Some(Note::TooFewFigures),
        _ => findings[at].note == Some(Note::NearMiss),
    };
    let all = 0..findings.len();
    // `4√39/9 = 2.78 = 2.87`: with the exact value it does not matter by how many figures a decimal is right.
    let is_settled = all.clone().any(|at| findings[at].exact && !is_bare(at) && !is_unfinished(&statement.said[at]));
    let any_other = all.clone().any(|at| is_bare(at) && is_other(at));
    if !is_settled && any_other && all.clone().any(|at| is_bare(at) && findings[at].is_correct()) {
        return Finding::wrong(Note::RivalAnswers);
    }
    // `98 + 2 - 92.5 = 8.5`: with a sum still to be worked out the answer is what it is worked out to be.
    let is_off = |finding: &Finding| matches!(finding.note, Some(Note::NearMiss | Note::Truncated));
    // `arctan(5/8) = 58.0°`: so it is here, but for a figure that is a little off.
    let ends_elsewhere = last.verdict == Verdict::Wrong && last.note != Some(Note::TooFewFigures);
    let worked_out_wrong = |at: usize| {
        let is_off = spoilt_after(at) || findings[at + 1..].iter().any(is_off);
        is_unfinished(&statement.said[at]) && is_off
            || is_angle_by_its_ratio(&statement.said[at]) && ends_elsewhere && at + 1 < findings.len()
    };
    let counts = |at: &usize| findings[*at].exact && !worked_out_wrong(*at);
    // `√7 = 2.83`, `7/5 = 5/7`: an exact value that is finished, and another one; `5 − 2 = 2.83`: arithmetic that is false.
    let is_preceded = |right: usize| {
        let is_wrong = |at: usize| findings[at].verdict == Verdict::Wrong;
        let is_rival = |at: usize| is_wrong(at) && is_finished_number(&statement.said[at]) && !is_rooted(at);
        let is_false =
            |at: usize| is_wrong(at) && !is_rooted(at) && cannot_lead_to(&statement.said[at], &statement.said[at + 1]);
        let is_named = label.is_none_or(|label| matches!(label.expr, None | Some(Expr::Name(_))));
        let is_untrue =
            |at: usize| is_wrong(at) && !is_rooted(at) && is_another(&statement.said[at], &statement.said[at + 1]);
        label.is_none() && (0..right).any(|at| is_rival(at) || is_untrue(at))
            || is_named && right.checked_sub(1).is_some_and(is_false)
    };
    if let Some(at) = all.clone().find(counts) {
        if is_preceded(at) {
            return Finding::unreadable(Note::CannotBeCompared);
        }
        if statement.said.get(at + 1).is_some_and(|next| is_no_size_of(&statement.said[at], next)) {
            return Finding::unreadable(Note::CannotBeCompared);
        }
        let right = findings[at];
        return if spoilt_after(at) { right.remarked(Note::IgnoredAfter) } else { right };
    }
    if last.is_correct() {
        return match is_preceded(findings.len() - 1) {
            true => Finding::unreadable(Note::CannotBeCompared),
            false => last,
        };
    }
    let right = (0..findings.len()).find(|at| findings[*at].is_correct() && !worked_out_wrong(*at));
    match right {
        Some(at) if is_rounded_wrongly(findings.len() - 1) => findings[at].remarked(Note::IgnoredAfter),
        Some(at) if !spoilt_after(at) => findings[at],
        Some(at) if only_rounded_after(at) => findings[at].remarked(Note::IgnoredAfter),
        // `10√0.147 = 3.83`: nothing is cut off there but what was put in.
        None if last.note == Some(Note::Truncated) && is_rounded_from_figures(&statement.said) => {
            Finding::partial(Note::EarlyRounding)
        }
        _ => last,
    }
}

/// Do two numbers lie so near that they may be one, rounded?
fn are_about(one: f64, other: f64) -> bool {
    (one - other).abs() <= 0.005 * other.abs()
}

/// Is a number the square of the one after it?
fn is_square_of(said: &Said, next: &Said) -> bool {
    let number = |said: &Said| match &said.form {
        Form::Value(value) => about(value, &[]),
        _ => None,
    };
    number(said).zip(number(next)).is_some_and(|(square, root)| are_about(square, root * root))
}

/// Does arithmetic on the left come to what stands on the right?
fn makes_about(left: &Expr, said: &Said) -> bool {
    let Form::Value(value) = &said.form else { return false };
    has_arithmetic(left) && about(left, &[]).zip(about(value, &[])).is_some_and(|(left, right)| are_about(left, right))
}

/// `4i - 3j = 1`: is a vector set equal to a number that is not its size?
fn is_no_size_of(said: &Said, next: &Said) -> bool {
    let (Form::Vector(x, y, _), Form::Value(value)) = (&said.form, &next.form) else { return false };
    let size = about(&vector::magnitude(x, y), &[]).zip(about(value, &[]));
    size.is_some_and(|(size, value)| !are_about(value, size))
}

/// A number without any rounding, in front of another that is not made with it, as the root in `2² + 3² = √13` is.
fn cannot_lead_to(said: &Said, next: &Said) -> bool {
    fn any(expr: &Expr, is: &dyn Fn(&Expr) -> bool) -> bool {
        is(expr) || expr.children().into_iter().any(|child| any(child, is))
    }
    let (Form::Value(number), Form::Value(next)) = (&said.form, &next.form) else { return false };
    let is_exact = number.names().is_empty() && !has_decimal(number) && said.unit.is_none();
    // `√2² + 3²`: a root sign that was to reach further.
    let is_undone =
        |part: &Expr| matches!(part, Expr::Power(root, _) if matches!(**root, Expr::Call(Function::Sqrt, _)));
    let is_it = |part: &Expr| exact::same(part, number, &[]) == Equality::Equal;
    is_exact && !any(number, &is_undone) && !any(next, &is_it)
}

fn has_decimal(expr: &Expr) -> bool {
    matches!(expr, Expr::Decimal(_)) || expr.children().into_iter().any(has_decimal)
}

/// `9.1 = √73`: a decimal that is set equal to a finished number, and is another.
fn is_another(said: &Said, next: &Said) -> bool {
    let value = |said: &Said| match &said.form {
        Form::Value(value) => about(value, &[]),
        _ => None,
    };
    let is_decimal = matches!(&said.form, Form::Value(Expr::Decimal(text)) if Written::text(text).is_some_and(|own| own.figures > 1));
    is_decimal
        && is_finished_number(next)
        && value(said).zip(value(next)).is_some_and(|(one, other)| !are_about(one, other))
}

/// `√7`, `7/5`, `2√3/3`: a number with nothing left to work out.
fn is_finished_number(said: &Said) -> bool {
    let is_root_or_share = |expr: &Expr| match expr {
        Expr::Quotient(above, below) => [above, below].into_iter().all(|part| matches!(**part, Expr::Number(_))),
        Expr::Call(Function::Sqrt, under) => matches!(**under, Expr::Number(_)),
        _ => false,
    };
    matches!(&said.form, Form::Value(expr) if is_root_or_share(expr) && !has_arithmetic(expr))
}

/// Is arithmetic with plain numbers left to be done in it?
fn is_unfinished(said: &Said) -> bool {
    match &said.form {
        Form::Value(expr) => has_arithmetic(expr),
        Form::Vector(x, y, _) => has_arithmetic(x) || has_arithmetic(y),
        _ => false,
    }
}

/// `arctan(5/8)`, of which the calculator has the value.
fn is_angle_by_its_ratio(said: &Said) -> bool {
    matches!(&said.form, Form::Value(Expr::Call(Function::Asin | Function::Acos | Function::Atan, _)))
}

/// `98 + 2`, `½ × 4 × 7²`, `16/2`; no `25/7`, and no `4√39/9`.
pub(super) fn has_arithmetic(expr: &Expr) -> bool {
    let is_number = |expr: &&Expr| is_plain(expr);
    match expr {
        Expr::Sum(terms) | Expr::Product(terms) if terms.iter().filter(is_number).count() > 1 => true,
        Expr::Quotient(above, below) => match (&**above, &**below) {
            (Expr::Number(above), Expr::Number(below)) => {
                let quotient = below.reciprocal().map(|share| above * &share);
                !above.is_integer() || quotient.is_none_or(|quotient| quotient.is_integer())
            }
            (above, below) if is_plain(above) && is_plain(below) => true,
            (above, below) if has_ratio_of_number(above) && has_ratio_of_number(below) => true,
            _ => has_arithmetic(above) || has_arithmetic(below),
        },
        Expr::Power(base, exponent) if is_plain(base) && is_plain(exponent) => true,
        _ => expr.children().into_iter().any(has_arithmetic),
    }
}

/// The sine, cosine or tangent of a number: `tan 30°/tan 60°` is still to be worked out.
fn has_ratio_of_number(expr: &Expr) -> bool {
    match expr {
        Expr::Call(Function::Sin | Function::Cos | Function::Tan, angle) => angle.names().is_empty(),
        other => other.children().into_iter().any(has_ratio_of_number),
    }
}

/// Is it a number, or made of numbers alone?
fn is_plain(expr: &Expr) -> bool {
    match expr {
        Expr::Number(_) | Expr::Decimal(_) => true,
        Expr::Negative(_) | Expr::Sum(_) | Expr::Product(_) | Expr::Quotient(..) => {
            expr.children().into_iter().all(is_plain)
        }
        Expr::Power(base, exponent) => {
            is_plain(base) && matches!(&**exponent, Expr::Number(power) if power.is_integer())
        }
        _ => false,
    }
}

/// Is the second of two bare numbers the first, rounded to the places that it has?
pub(in crate::mark) fn is_rounding(first: &Said, second: &Said) -> bool {
    let written = |said: &Said| match &said.form {
        Form::Value(expr) => Written::of(expr),
        _ => None,
    };
    written(first).zip(written(second)).is_some_and(|(first, second)| second.is_short_for(&first))
}

/// Is the second of two bare numbers less than one in its last place off the first, which has more places: `3.7643 = 3.77`?
pub(in crate::mark) fn is_nearly_rounding(first: &Said, second: &Said) -> bool {
    let written = |said: &Said| match &said.form {
        Form::Value(expr) => Written::of(expr),
        _ => None,
    };
    let is_near = |(first, second): (Written, Written)| {
        let apart = (first.value.to_f64() - second.value.to_f64()).abs();
        second.places < first.places && apart < 0.999_999 * place_value(&second)
    };
    written(first).zip(written(second)).is_some_and(is_near)
}

/// What one in the last place of a decimal is worth.
fn place_value(written: &Written) -> f64 {
    i32::try_from(-written.places).map_or(f64::INFINITY, |power| 10f64.powi(power))
}

/// Does a formula with rounded figures come to the decimal at the end, rounded as it should be?
fn is_rounded_from_figures(said: &[Said]) -> bool {
    let [formulas @ .., Said { form: Form::Value(end), .. }] = said else { return false };
    let Some(end) = Written::of(end) else { return false };
    let is_rounded = |value: f64| (value - end.value.to_f64()).abs() <= 0.5 * place_value(&end);
    formulas.iter().any(|said| match &said.form {
        Form::Value(formula) if Written::of(formula).is_none() && has_decimal(formula) => {
            about(formula, &[]).is_some_and(is_rounded)
        }
        _ => false,
    })
}

/// Is it a number as it stands, with nothing left to work out?
pub(super) fn is_bare_number(said: &Said) -> bool {
    matches!(&said.form, Form::Value(expr) if Written::of(expr).is_some())
}
