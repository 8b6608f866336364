//! For which values of an unknown something happens: 'the set of values of e for which A turns back'.
//!
//! The collision is derived forwards with the unknown as a letter. Each condition is then an inequality in it, and so is
//! everything without which there is no collision: the spheres approach, they do not pass through each other, and e lies
//! between 0 and 1.

use super::backwards::{Found, Posed};
use super::condition::residual;
use super::conditions_in_words::{inequality_words, no_roots};
use super::later::Meeting;
use super::line::Line;
use super::refusal::Refusal;
use super::scene::{Condition, Scene};
use super::scene_reader::meaning;
use super::working::Show;
use super::{Derivation, Quantity};
use crate::expr::{Expr, Relation, print, written};
use crate::number::{Demand, Letter, Range, Span, Value, solve_inequalities};

/// The values of an unknown for which the conditions hold.
#[derive(Clone, Debug, PartialEq)]
pub struct Values {
    /// The unknown.
    pub letter: Letter,
    /// From where to where.
    pub span: Span,
}

impl Values {
    /// `1/3 < e ≤ 1`, or `k > 2`.
    pub fn written(&self) -> Expr {
        let name = Expr::name(self.letter.name().replace("A.mass", "m_A").replace("B.mass", "m_B"));
        let relation = |included: bool, strict, weak| if included { weak } else { strict };
        match (&self.span.low, &self.span.high) {
            (Some(low), Some(high)) => {
                let first = relation(low.included, Relation::Less, Relation::LessOrEqual);
                let second = relation(high.included, Relation::Less, Relation::LessOrEqual);
                let left = Expr::Relation(Box::new(written(&low.value)), first, Box::new(name));
                Expr::Relation(Box::new(left), second, Box::new(written(&high.value)))
            }
            (Some(low), None) => {
                let first = relation(low.included, Relation::Greater, Relation::GreaterOrEqual);
                Expr::Relation(Box::new(name), first, Box::new(written(&low.value)))
            }
            (None, Some(high)) => {
                let second = relation(high.included, Relation::Less, Relation::LessOrEqual);
                Expr::Relation(Box::new(name), second, Box::new(written(&high.value)))
            }
            (None, None) => name,
        }
    }
}

impl Condition {
    /// Is it an inequality?
    pub fn is_inequality(&self) -> bool {
        self.relation != Relation::Equal
    }
}

/// The set of values of the one unknown.
///
/// # Errors
///
/// More than one unknown, equations beside inequalities, values that are not from one number to another, none or all of
/// them, or inequalities beyond the methods of an exam.
pub(super) fn values(posed: &Posed) -> Result<Found, Refusal> {
    let scene = posed.scene;
    let [unknown] = scene.unknowns.as_slice() else {
        return Err(Refusal::beyond("an inequality is solved for one unknown only"));
    };
    if scene.maximise.is_some() || !scene.conditions.iter().all(Condition::is_inequality) {
        return Err(Refusal::beyond("inequalities beside equations or `maximise` are not solved here"));
    }
    if unknown.range() == Range::Acute {
        return Err(Refusal::beyond("a range of angles is not found here").try_this("ask for a range of its tangent"));
    }
    let mut demands = posed.physical();
    let mut shown = Vec::new();
    for condition in &scene.conditions {
        let letters = |name: &str| meaning(&scene.letters, name);
        let gap = residual(condition, &letters, &posed.known).map_err(super::condition::fault)?;
        if gap.of_angles {
            return Err(Refusal::beyond("an inequality between angles is not solved here")
                .try_this("compare their tangents, as `A.after.tan_to_loc`"));
        }
        shown.push(Expr::Relation(Box::new(written(&gap.value)), condition.relation, Box::new(Expr::integer(0))));
        demands.push(match condition.relation {
            Relation::Greater => (gap.value, Demand::Positive),
            Relation::GreaterOrEqual => (gap.value, Demand::NotNegative),
            Relation::Less => (-gap.value, Demand::Positive),
            _ => (-gap.value, Demand::NotNegative),
        });
    }
    let mut spans = solve_inequalities(&demands, *unknown).map_err(no_roots)?;
    let name = unknown.name();
    match spans.len() {
        0 => return Err(Refusal::impossible(format!("the conditions hold for no value of {name}"))),
        1 if spans[0] == Span::of(unknown.range()) => {
            return Err(Refusal::underdetermined(format!("the conditions hold whatever {name} is")));
        }
        1 => {}
        _ => {
            let all = spans.drain(..).map(|span| Values { letter: *unknown, span });
            let all: Vec<String> = all.map(|values| print::unicode(&values.written())).collect();
            return Err(Refusal::beyond(format!("the values of {name} are not in one piece: {}", all.join(", or "))));
        }
    }
    let values = Values { letter: *unknown, span: spans.remove(0) };
    let lines = lines(posed, shown, &values);
    // The letter stays one: what else is asked is asked in it.
    let scene = Scene { unknowns: Vec::new(), conditions: Vec::new(), ..scene.clone() };
    Ok(Found { scene, values: Vec::new(), range: Some(values), lines, remarks: Vec::new() })
}

/// The forward derivation in letters, each condition as an inequality, and what follows.
fn lines(posed: &Posed, shown: Vec<Expr>, values: &Values) -> Vec<Line> {
    let show = Show::new(posed.scene, &posed.known, &posed.asked);
    let mut lines: Vec<Line> = posed.derivation.steps.iter().flat_map(|step| step.lines(&show)).collect();
    for (condition, inequality) in posed.scene.conditions.iter().zip(shown) {
        lines.push(inequality_words(condition, inequality, posed.scene.setting));
    }
    let at_most_1 = values.letter.range() == Range::Unit
        && values.span.high.as_ref().is_some_and(|high| high.included && high.value.equals(&Value::ONE));
    let words = if at_most_1 { "A coefficient of restitution is at most 1, so" } else { "So" };
    lines.push(Line::plain(words, vec![values.written()]));
    lines
}

impl Posed<'_> {
    /// What must hold for there to be a collision at all, as far as it depends on the unknown.
    fn physical(&self) -> Vec<(Value, Demand)> {
        let of_one = [
            (Quantity::Approach, Demand::Positive),
            (Quantity::Separation, Demand::NotNegative),
            (Quantity::Restitution, Demand::NotNegative),
        ];
        let mut demands = of_one.to_vec();
        for meeting in Meeting::all(self.known.0.keys()) {
            demands.extend(of_one.map(|(quantity, demand)| (meeting.quantity(quantity), demand)));
        }
        let asked: Vec<Quantity> = demands.iter().map(|(quantity, _)| *quantity).collect();
        let mut known = self.known.clone();
        Derivation::carry_out(&mut known, &asked);
        let mut found = Vec::new();
        let open = |value: &Value| value.letters().iter().any(|letter| self.scene.unknowns.contains(letter));
        for (quantity, demand) in demands {
            let Some(value) = known.number(quantity).filter(open) else { continue };
            let is_e = |quantity| matches!(quantity, Quantity::Restitution);
            if is_e(quantity) || matches!(quantity, Quantity::Later(later) if is_e(later.quantity())) {
                found.push((&Value::ONE - &value, Demand::NotNegative));
            }
            found.push((value, demand));
        }
        found
    }
}
