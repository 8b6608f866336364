//! The values of a letter for which inequalities hold.
//!
//! A value changes its sign only where it is nought, where its reciprocal is, or where a square root in it begins to exist.
//! Between two such places one number tells for all, and its sign is decided exactly. So the set that is found is the whole
//! set, ends included or not.

use std::cmp::Ordering;

use super::{Fraction, Letter, NoRoots, Range, Root, Value, solve_system};

/// What is demanded of a value.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Demand {
    /// More than nought.
    Positive,
    /// Nought or more.
    NotNegative,
}

/// One end of a span.
#[derive(Clone, Debug, PartialEq)]
pub struct End {
    /// Where it is.
    pub value: Value,
    /// Does it belong to the span?
    pub included: bool,
}

/// All values between two ends; without an end it goes on for ever.
#[derive(Clone, Debug, PartialEq)]
pub struct Span {
    /// The lower end.
    pub low: Option<End>,
    /// The upper end.
    pub high: Option<End>,
}

impl Span {
    /// All that a letter can be: of an acute angle its tangent.
    pub fn of(range: Range) -> Span {
        let end = |value, included| Some(End { value, included });
        match range {
            Range::Unit => Span { low: end(Value::ZERO, true), high: end(Value::ONE, true) },
            Range::Positive | Range::Acute => Span { low: end(Value::ZERO, false), high: None },
            _ => Span { low: None, high: None },
        }
    }

    /// Does another lie within it?
    pub fn holds(&self, other: &Span) -> bool {
        let ends = |own: &Option<End>, its: &Option<End>, inwards: Ordering| match (own, its) {
            (None, _) => true,
            (Some(own), Some(its)) => match (&its.value - &own.value).sign() {
                Some(Ordering::Equal) => own.included || !its.included,
                sign => sign == Some(inwards),
            },
            (Some(_), None) => false,
        };
        ends(&self.low, &other.low, Ordering::Greater) && ends(&self.high, &other.high, Ordering::Less)
    }
}

/// The spans of a letter, from the least up, in which every demand is met. Other letters may remain in the values, as
/// long as what they are decides nothing.
///
/// ```
/// use carom::number::{Demand, Letter, Range, Value, solve_inequalities};
/// let e = Letter::new("e", Range::Unit).unwrap();
/// // 2 - 3e < 0
/// let demand = (&(&Value::from(3) * &Value::letter(e)) - &Value::from(2), Demand::Positive);
/// let spans = solve_inequalities(&[demand], e).unwrap();
/// let low = spans[0].low.clone().unwrap();
/// assert!(low.value.equals(&Value::fraction(2, 3)) && !low.included);
/// ```
///
/// # Errors
///
/// Where a value is nought cannot be found, or its sign depends on other letters.
pub fn solve_inequalities(demands: &[(Value, Demand)], letter: Letter) -> Result<Vec<Span>, NoRoots> {
    let domain = Span::of(letter.range());
    let places = places(demands, letter, &domain)?;
    // Each place and each gap, in turn: does all hold there, and from where to where is it?
    let mut spans: Vec<Span> = Vec::new();
    let mut open = false;
    let mut take = |holds: bool, low: Option<End>, high: Option<End>| {
        match (holds, open, spans.last_mut()) {
            (true, true, Some(last)) => last.high = high,
            (true, _, _) => spans.push(Span { low, high }),
            _ => {}
        }
        open = holds;
    };
    for gap in 0..=places.len() {
        let low = gap.checked_sub(1).map(|before| places[before].clone());
        let high = places.get(gap).cloned();
        if let Some(at) = &low {
            let is_in = at.included && hold(demands, letter, &at.value)?;
            let end = |included| Some(End { value: at.value.clone(), included });
            take(is_in, end(true), end(true));
        }
        let outside = (gap == 0 && domain.low.is_some()) || (gap == places.len() && domain.high.is_some());
        if outside {
            continue;
        }
        let within = between(low.as_ref().map(|end| &end.value), high.as_ref().map(|end| &end.value))?;
        let holds = hold(demands, letter, &within)?;
        let excluded = |end: Option<End>| end.map(|end| End { included: false, ..end });
        take(holds, excluded(low), excluded(high));
    }
    Ok(spans)
}

/// Where something may change, in order: the ends of what the letter can be, and what lies between them. Each says
/// whether the letter can be that.
fn places(demands: &[(Value, Demand)], letter: Letter, domain: &Span) -> Result<Vec<End>, NoRoots> {
    let mut found: Vec<End> = domain.low.iter().chain(&domain.high).cloned().collect();
    for (value, _) in demands.iter().filter(|(value, _)| value.has_letter(|own| *own == letter)) {
        let mut all = vec![value.clone()];
        radicands(value, &mut all);
        let reciprocals: Vec<Value> = all.iter().filter_map(Value::reciprocal).collect();
        for of in all.into_iter().chain(reciprocals) {
            if !of.has_letter(|own| *own == letter) {
                continue;
            }
            let roots = match solve_system(std::slice::from_ref(&of), &[letter]) {
                Ok(roots) => roots,
                Err(NoRoots::Never | NoRoots::Always) => Vec::new(),
                Err(other) => return Err(other),
            };
            for root in roots.into_iter().flatten() {
                let compared = |end: &Option<End>| match end {
                    Some(end) => (&root - &end.value).sign().map(Some),
                    None => Some(None),
                };
                let (low, high) = (compared(&domain.low), compared(&domain.high));
                let (Some(low), Some(high)) = (low, high) else { return Err(NoRoots::TooLong) };
                let inside = low.is_none_or(Ordering::is_gt) && high.is_none_or(Ordering::is_lt);
                if inside && !found.iter().any(|end| end.value.equals(&root)) {
                    found.push(End { value: root, included: true });
                }
            }
        }
    }
    let mut unordered = false;
    found.sort_by(|one, other| {
        (&one.value - &other.value).sign().unwrap_or_else(|| {
            unordered = true;
            Ordering::Equal
        })
    });
    if unordered { Err(NoRoots::TooLong) } else { Ok(found) }
}

/// What square roots are taken of in a value, unless it can be seen that it is never negative.
fn radicands(value: &Value, found: &mut Vec<Value>) {
    for root in value.roots() {
        let Root::Nested { radicand, .. } = root else { continue };
        radicands(&radicand, found);
        if radicand.sign().is_none() && radicand.square_root_of_square().is_none() && !found.contains(&radicand) {
            found.push(radicand);
        }
    }
}

/// Are all demands met there? A value that does not exist meets none.
fn hold(demands: &[(Value, Demand)], letter: Letter, at: &Value) -> Result<bool, NoRoots> {
    for (value, demand) in demands {
        let Some(value) = value.substitute(letter, at) else { return Ok(false) };
        let sign = value.sign().ok_or(NoRoots::TooLong)?;
        let met = match demand {
            Demand::Positive => sign.is_gt(),
            Demand::NotNegative => sign.is_ge(),
        };
        if !met {
            return Ok(false);
        }
    }
    Ok(true)
}

/// A fraction between two values.
fn between(low: Option<&Value>, high: Option<&Value>) -> Result<Value, NoRoots> {
    let number = |value: &Value| value.to_f64().ok_or(NoRoots::TooLong);
    let middle = match (low, high) {
        (Some(low), Some(high)) => (number(low)? + number(high)?) / 2.0,
        (Some(low), None) => number(low)?.floor() + 2.0,
        (None, Some(high)) => number(high)?.ceil() - 2.0,
        (None, None) => 0.0,
    };
    let middle = Fraction::from_f64(middle).map(Value::from).ok_or(NoRoots::TooLong)?;
    let is_above = |low: &Value| (&middle - low).sign() == Some(Ordering::Greater);
    let is_below = |high: &Value| (high - &middle).sign() == Some(Ordering::Greater);
    // Two values that are one in floating point have nothing between them that it can tell.
    if low.is_none_or(is_above) && high.is_none_or(is_below) { Ok(middle) } else { Err(NoRoots::TooLong) }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn letter(name: &str, range: Range) -> Letter {
        Letter::new(name, range).unwrap()
    }

    /// `[low, high]` with round brackets where an end does not belong.
    fn shown(spans: &[Span]) -> String {
        let end = |end: &Option<End>| match end {
            Some(end) => (format!("{:.3}", end.value.to_f64().unwrap()), end.included),
            None => ("..".to_owned(), false),
        };
        let one = |span: &Span| {
            let ((low, closed), (high, shut)) = (end(&span.low), end(&span.high));
            format!("{}{low}, {high}{}", if closed { '[' } else { '(' }, if shut { ']' } else { ')' })
        };
        spans.iter().map(one).collect::<Vec<_>>().join(" ")
    }

    #[test]
    fn the_set_is_found_with_its_ends() {
        use Demand::{NotNegative, Positive};
        let e = letter("e", Range::Unit);
        let k = letter("k", Range::Positive);
        let x = letter("x", Range::Real);
        let of = |letter: Letter, c: i64, b: i64, a: i64| {
            let value = Value::letter(letter);
            &(&Value::from(c) + &(&Value::from(b) * &value)) + &(&Value::from(a) * &(&value * &value))
        };
        let cases = [
            (vec![(of(e, -2, 3, 0), Positive)], e, "(0.667, 1.000]"),
            (vec![(of(e, -2, 3, 0), NotNegative)], e, "[0.667, 1.000]"),
            (vec![(of(e, 1, -3, 0), Positive)], e, "[0.000, 0.333)"),
            (vec![(of(e, -1, 3, 0), Positive), (of(e, 2, -3, 0), NotNegative)], e, "(0.333, 0.667]"),
            (vec![(of(e, -2, 0, 1), Positive)], e, ""),
            (vec![(of(e, 2, 0, -1), Positive)], e, "[0.000, 1.000]"),
            (vec![(of(k, -2, 0, 1), Positive)], k, "(1.414, ..)"),
            (vec![(of(k, 3, -4, 1), Positive)], k, "(0.000, 1.000) (3.000, ..)"),
            (vec![(of(k, 4, -4, 1), Positive)], k, "(0.000, 2.000) (2.000, ..)"),
            (vec![(of(k, -4, 4, -1), NotNegative)], k, "[2.000, 2.000]"),
            (vec![(of(x, 1, 0, 0), Positive)], x, "(.., ..)"),
            (vec![(of(x, -1, 0, 1), NotNegative)], x, "(.., -1.000] [1.000, ..)"),
            (vec![(of(x, 1, 0, -1), Positive)], x, "(-1.000, 1.000)"),
        ];
        for (demands, letter, expected) in cases {
            assert_eq!(shown(&solve_inequalities(&demands, letter).unwrap()), expected);
        }
        // 1/(k - 2) > 0: there is no value at 2.
        let pole = of(k, -2, 1, 0).reciprocal().unwrap();
        assert_eq!(shown(&solve_inequalities(&[(pole, NotNegative)], k).unwrap()), "(2.000, ..)");
        // mu(3e - 2) > 0 whatever the positive letters are; (m - e) > 0 is not decided.
        let m = Value::letter(letter("m", Range::Positive));
        assert_eq!(shown(&solve_inequalities(&[(&m * &of(e, -2, 3, 0), Positive)], e).unwrap()), "(0.667, 1.000]");
        assert_eq!(solve_inequalities(&[(&m - &Value::letter(e), Positive)], e), Err(NoRoots::TooLong));
    }
}
