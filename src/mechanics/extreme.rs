//! The largest value of a quantity: where its rate of change is nought, and at the ends of a range that has them.

use std::cmp::Ordering;

use super::backwards::{Found, Posed};
use super::conditions_in_words::{in_english, no_roots, without_markup};
use super::formula::{difference, times};
use super::law::Known;
use super::line::Line;
use super::refusal::Refusal;
use super::root_in_words::MOST_SHOWN;
use super::working::Show;
use super::{Derivation, Quantity, Scene, pose};
use crate::expr::{Expr, Function, Relation, print, written, written_angle};
use crate::number::{
    Angle, Demand, Fraction, Interval, Letter, NoRoots, Polynomial, Range, Span, Value, solve_inequalities,
    solve_system,
};

/// So many signs stand above the line of a derivative.
const WIDEST: usize = 40;

/// Of several places where a quantity may be largest, those that no other surpasses.
pub(super) fn only_largest(found: &mut Vec<Found>, quantity: Quantity) {
    let sizes: Vec<Option<Known<Value>>> = found
        .iter()
        .map(|one| {
            let mut known = pose(&one.scene).ok()?;
            Derivation::carry_out(&mut known, &[quantity]);
            Some(known)
        })
        .collect();
    let surpasses = |one: &Known<Value>, other: &Known<Value>| match (one.number(quantity), other.number(quantity)) {
        (Some(a), Some(b)) => (&a - &b).sign() == Some(Ordering::Greater),
        // Angles from 0 to 180 degrees, by their vectors.
        _ => one
            .direction(quantity)
            .zip(other.direction(quantity))
            .is_some_and(|((y, x), (v, u))| (&(&y * &u) - &(&x * &v)).sign() == Some(Ordering::Greater)),
    };
    let kept: Vec<bool> = sizes
        .iter()
        .map(|size| !size.iter().any(|one| sizes.iter().flatten().any(|other| surpasses(other, one))))
        .collect();
    let mut kept = kept.into_iter();
    found.retain(|_| kept.next().unwrap_or(true));
}

/// A quantity that is nowhere largest: what was left out where its rate of change is nought.
pub(super) fn without_largest(scene: &Scene, quantity: Quantity, left_out: &str) -> Refusal {
    let name = without_markup(&in_english(quantity, scene.setting));
    let unknown = scene.unknowns.first().map_or("", Letter::name);
    Refusal::impossible(format!("no {unknown} makes {name} as large as possible: {left_out}"))
        .try_this("name in `maximise` what grows and falls again, such as `A.tan_deflection`")
}

impl Posed {
    /// Where the rate of change is nought, and the ends of a range that has them.
    pub(super) fn extremes(&self, quantity: Quantity) -> Result<Vec<Vec<Value>>, Refusal> {
        let slopes = self.stationary(quantity)?;
        let unknown = self.scene.unknowns[0];
        if let Some(pole) = self.pole(quantity, unknown) {
            let name = without_markup(&in_english(quantity, self.scene.setting));
            return Err(Refusal::impossible(format!(
                "{name} has no largest value: it grows beyond every number as {} comes near {}",
                unknown.name(),
                print::unicode(&written(&pole))
            )));
        }
        let mut candidates = match slopes.as_slice() {
            [slope] if slope.is_zero() => {
                let name = without_markup(&in_english(quantity, self.scene.setting));
                let same = Refusal::underdetermined(format!("{name} is the same whatever {} is", unknown.name()));
                return Err(same.try_this("maximise a quantity that depends on it, such as `A.tan_deflection`"));
            }
            [slope] if slope.has_letter(|letter| *letter == unknown) => match solve_system(&slopes, &[unknown]) {
                Err(NoRoots::Never) => Vec::new(),
                outcome => outcome.map_err(no_roots)?,
            },
            _ => Vec::new(),
        };
        if unknown.range() == Range::Unit {
            for end in [Value::ZERO, Value::ONE] {
                if !candidates.iter().any(|candidate| candidate[0].equals(&end)) {
                    candidates.push(vec![end]);
                }
            }
        } else if candidates.is_empty() {
            let name = without_markup(&in_english(quantity, self.scene.setting));
            return Err(Refusal::impossible(format!(
                "{name} has no largest value: its rate of change with {} is never nought",
                unknown.name()
            )));
        }
        Ok(candidates)
    }

    /// Where a quantity grows beyond every number, inside the range of the unknown.
    fn pole(&self, quantity: Quantity, unknown: Letter) -> Option<Value> {
        let value = self.known.number(quantity)?;
        let below = Value::quotient(value.parts().1.into_owned(), Polynomial::one());
        let near = Fraction::new(1, 1 << 20);
        let is_inside = |at: &Fraction| match unknown.range() {
            Range::Real | Range::Degrees => true,
            Range::Positive | Range::Acute => at.sign().is_gt(),
            Range::Unit => at.sign().is_ge() && *at <= Fraction::ONE,
        };
        let grows = |pole: &Value| {
            let Some(at) = pole.as_fraction() else { return false };
            [at - &near, at + &near].iter().filter(|beside| is_inside(beside)).any(|beside| {
                let there = |letter: Letter| (letter == unknown).then(|| Interval::from_fraction(beside, 128));
                value.enclose(128, &there).is_some_and(|large| large.lower() > Fraction::from(1 << 10))
            })
        };
        let poles = solve_system(&[below], &[unknown]).ok()?;
        poles.into_iter().map(|mut pole| pole.remove(0)).find(grows)
    }

    /// The rate of change of what is to be as large as possible. A square root is largest where its
    /// square is.
    fn stationary(&self, quantity: Quantity) -> Result<Vec<Value>, Refusal> {
        let [unknown] = self.scene.unknowns.as_slice() else {
            return Err(Refusal::beyond("a quantity is made as large as possible by one unknown only"));
        };
        let value = match self.known.number(quantity) {
            Some(value) => value,
            None => match self.known.direction(quantity).and_then(|(y, x)| y.divided_by(&x)) {
                Some(tangent) => tangent,
                None => return Err(Refusal::beyond(format!("`{quantity}` cannot be made as large as possible"))),
            },
        };
        let slope = value.derivative(*unknown).or_else(|| (&value * &value).derivative(*unknown));
        slope
            .map(|slope| vec![slope])
            .ok_or_else(|| Refusal::beyond(format!("the largest `{quantity}` is beyond the methods used here")))
    }

    /// The one rate of change.
    pub(super) fn slope(&self, quantity: Quantity) -> Option<Value> {
        self.stationary(quantity).ok().and_then(|mut slopes| slopes.pop())
    }

    /// What is differentiated: the quantity, of an angle its tangent, and the square of what is a root.
    fn differentiated(&self, quantity: Quantity, unknown: Letter) -> Option<Value> {
        let number = self.known.number(quantity);
        let value = number.or_else(|| self.known.direction(quantity).and_then(|(y, x)| y.divided_by(&x)))?;
        if value.derivative(unknown).is_some() { Some(value) } else { Some(&value * &value) }
    }

    /// The rate of change as it is first written down, by the rule for a quotient, and as it comes out.
    fn differentiation(&self, quantity: Quantity, unknown: Letter) -> Vec<Expr> {
        let Some(value) = self.differentiated(quantity, unknown) else { return Vec::new() };
        let show = Show::new(&self.scene, &self.known, &self.asked);
        let symbol = match quantity.of_its_impact() {
            Quantity::TanDeflection(_) | Quantity::Deflection(_) => Expr::call(Function::Tan, show.name("delta")),
            Quantity::EnergyLost if self.known.number(quantity).is_some() => show.name("L"),
            _ => return Vec::new(),
        };
        let step = |of: Expr| Expr::product([Expr::name("d"), of]);
        let left = Expr::Quotient(Box::new(step(symbol)), Box::new(step(written(&Value::letter(unknown)))));
        let quotient = value.as_quotient().filter(|(_, below)| below.degree(unknown) > 0);
        let rights = match quotient {
            Some((above, below)) => {
                let slopes = [above.derivative(unknown), below.derivative(unknown)];
                let [slope, ..] = &slopes;
                // What would begin with a minus above the line is turned round with what stands below it.
                let turned = matches!(written(&Value::quotient(slope.clone(), Polynomial::one())), Expr::Negative(_));
                let whole = |polynomial: Polynomial| {
                    Value::quotient(if turned { -&polynomial } else { polynomial }, Polynomial::one())
                };
                let [du, dv] = slopes.map(whole);
                let [u, v] = [above, below].map(whole);
                let square = written(&v).to_the(2);
                let by_rule = difference(times(written(&du), written(&v)), times(written(&u), written(&dv)));
                let top = &(&du * &v) - &(&u * &dv);
                if top.terms() > MOST_SHOWN {
                    return Vec::new();
                }
                // No line holds a longer fraction.
                let by_rule = Some(by_rule).filter(|by_rule| print::unicode(by_rule).chars().count() <= WIDEST);
                let over = |top: Expr| Expr::Quotient(Box::new(top), Box::new(square.clone()));
                by_rule.into_iter().chain([written(&top)]).map(over).collect()
            }
            None => {
                let slope = value.derivative(unknown).filter(|slope| slope.terms() <= MOST_SHOWN);
                Vec::from_iter(slope.map(|slope| written(&slope)))
            }
        };
        Show::chain(left, rights)
    }

    /// Is it an end of the range of the unknown?
    fn is_end(&self, values: &[Value]) -> bool {
        let is_end = |value: &Value| value.is_zero() || value.equals(&Value::ONE);
        self.scene.unknowns[0].range() == Range::Unit && values.first().is_some_and(is_end)
    }

    /// The slope must fall through nought there.
    pub(super) fn is_maximum(&self, quantity: Quantity, values: &[Value]) -> Result<(), String> {
        if self.is_end(values) {
            return Ok(());
        }
        let (Some(slope), [unknown], [value]) = (
            self.stationary(quantity).ok().and_then(|mut slopes| slopes.pop()),
            self.scene.unknowns.as_slice(),
            values,
        ) else {
            return Ok(());
        };
        let second = slope.derivative(*unknown).and_then(|second| second.substitute(*unknown, value));
        match second.and_then(|second| second.sign()) {
            Some(Ordering::Greater) => Err(format!("`{quantity}` is smallest there, not largest")),
            _ => Ok(()),
        }
    }

    /// Why it is there that the quantity is largest, and what says so, where that is short.
    pub(super) fn largest_lines(&self, quantity: Quantity, values: &[Value]) -> Vec<Line> {
        let setting = self.scene.setting;
        let what = in_english(quantity, setting);
        let slope = self.slope(quantity);
        let ([unknown], [at], Some(slope)) = (self.scene.unknowns.as_slice(), values, slope) else {
            return vec![
                Line::plain(&format!("At the largest value of {what} its rate of change is nought."), vec![])
                    .said_of(setting),
            ];
        };
        if self.is_end(values) && !slope.substitute(*unknown, at).is_some_and(|there| there.is_zero()) {
            return vec![self.end_line(quantity, &slope, *unknown, at).said_of(setting)];
        }
        let variable = written(&Value::letter(*unknown));
        let found = self.differentiation(quantity, *unknown);
        // A quotient is nought where what stands above the line is.
        let above = &slope * &Value::quotient(slope.denominator(), Polynomial::one());
        let above = Some(above).filter(|above| !above.is_constant() && above.terms() <= MOST_SHOWN);
        let equations = Vec::from_iter(above.map(|above| Expr::equation(written(&above), Expr::integer(0))));
        let nought = if equations.is_empty() { "." } else { ":" };
        let lines = if found.is_empty() {
            let words = format!("Where {what} is largest, its derivative with respect to {{x}} is zero{nought}");
            vec![Line::with(&words, &[("x", variable)], equations)]
        } else {
            let words = format!("Differentiating {what} with respect to {{x}}:");
            let second = format!("Where it is largest, this is zero{nought}");
            vec![Line::with(&words, &[("x", variable)], found), Line::plain(&second, equations)]
        };
        lines.into_iter().map(|line| line.said_of(setting)).collect()
    }

    /// Why a quantity is largest at an end of the range of the unknown, where its rate of change is not nought: it grows or
    /// falls all the way, or else, where it does not or that cannot be seen, its values are compared.
    fn end_line(&self, quantity: Quantity, slope: &Value, unknown: Letter, at: &Value) -> Line {
        let what = in_english(quantity, self.scene.setting);
        let name = Expr::name(unknown.name());
        // The rate may be that of the square of a size, or of the tangent of an angle: it has the same sign.
        let of = match self.known.number(quantity) {
            Some(value) if value.derivative(unknown).is_some() => what.clone(),
            Some(_) => format!("the square of {what}"),
            None => format!("the tangent of {what}"),
        };
        let everywhere = |value: &Value, demand| {
            let spans = solve_inequalities(&[(value.clone(), demand)], unknown);
            spans.is_ok_and(|spans| spans == [Span::of(unknown.range())])
        };
        let strictly = |relation| if relation == Relation::Greater { "positive" } else { "negative" };
        let found = [(slope.clone(), Relation::Greater, "negative"), (-slope, Relation::Less, "positive")];
        let found = found.into_iter().find_map(|(value, relation, never)| {
            let weak = if relation == Relation::Greater { Relation::GreaterOrEqual } else { Relation::LessOrEqual };
            if everywhere(&value, Demand::Positive) {
                Some((relation, strictly(relation).to_owned()))
            } else {
                everywhere(&value, Demand::NotNegative).then(|| (weak, format!("never {never}")))
            }
        });
        match found {
            Some((relation, sign)) => {
                let words = format!(
                    "The rate of change of {of} with {{x}} is {sign}, so it is largest at the end {{x}} = {{at}} of the range:"
                );
                let rate = Expr::Relation(Box::new(written(slope)), relation, Box::new(Expr::integer(0)));
                let shown = if slope.terms() <= MOST_SHOWN { vec![rate] } else { vec![] };
                Line::with(&words, &[("x", name), ("at", written(at))], shown)
            }
            None => {
                let mut words =
                    format!("Where its rate of change with {{x}} is nought, and at the ends of the range, {what} is");
                let compared = self.compared(quantity, unknown);
                let names: Vec<[String; 2]> =
                    (0..compared.len()).map(|place| ["p", "v"].map(|name| format!("{name}{place}"))).collect();
                let mut formulas = vec![("x", name)];
                for ([p, v], (place, value)) in names.iter().zip(compared) {
                    let comma = if formulas.len() > 1 { "," } else { "" };
                    words.push_str(&format!("{comma} {{{v}}} for {{x}} = {{{p}}}"));
                    formulas.extend([(p.as_str(), place), (v.as_str(), value)]);
                }
                Line::with(&format!("{words}."), &formulas, vec![])
            }
        }
    }

    /// Each place in the range where a quantity may be largest, and its value there.
    fn compared(&self, quantity: Quantity, unknown: Letter) -> Vec<(Expr, Expr)> {
        let places = self.extremes(quantity).unwrap_or_default().into_iter().flatten();
        // Only e has a range with ends.
        let is_inside = |place: &Value| {
            [place.sign(), (&Value::ONE - place).sign()].iter().all(|sign| sign.is_none_or(Ordering::is_ge))
        };
        let there = |place: &Value| match self.known.number(quantity) {
            Some(value) => Some(written(&value.substitute(unknown, place)?)),
            None => {
                let (y, x) = self.known.direction(quantity)?;
                Angle::of(&y.substitute(unknown, place)?, &x.substitute(unknown, place)?)
                    .map(|angle| written_angle(&angle))
            }
        };
        places.filter(is_inside).filter_map(|place| Some((written(&place), there(&place)?))).collect()
    }
}
