//! The values that a parameter can take: a range or a list, from the text of a bank file.

use crate::expr::{Angles, Expr, Fault, Span, print, read, read_as_written, written};
use crate::number::{Decimal, Fraction, Value};

/// Finitely many values in a fixed order.
///
/// ```
/// use carom::bank::Domain;
/// let quarters = Domain::range("1/4..3/4 step 1/4").unwrap();
/// assert_eq!(quarters.size(), 3);
/// assert_eq!(carom::expr::print::plain(&quarters.value(1)), "1/2");
/// ```
#[derive(Clone, Debug, PartialEq)]
pub enum Domain {
    /// From the first value in equal steps.
    Range {
        /// The first value.
        first: Fraction,
        /// From each value to the next; above nought.
        step: Fraction,
        /// How many values; at least one.
        count: u64,
        /// Whether they were written, and are printed, with a decimal point.
        decimals: bool,
    },
    /// Expressions as they were written; at least one.
    List(Vec<Expr>),
}

/// A range of so many values is written out where it stands among others.
const MOST_WRITTEN: u64 = 12;

impl Domain {
    /// The values that were written out one by one; none of a range.
    pub fn formulas(&self) -> &[Expr] {
        match self {
            Domain::Range { .. } => &[],
            Domain::List(values) => values,
        }
    }

    /// Is a text meant for a range, and not for one value?
    pub fn is_range(text: &str) -> bool {
        text.contains("..")
            || between_dashes(text).is_some()
            || between_words(text).is_some()
            || listed(text).is_some()
            || text.trim().is_empty()
    }

    /// Reads `2..12`, `10..80 step 5`, `1/4..3/4 step 1/4`, or one expression.
    ///
    /// # Errors
    ///
    /// A [`Fault`] if an end is no number, the range runs backwards or the step is not above nought.
    pub fn range(text: &str) -> Result<Domain, Fault> {
        if let Some(start) = text.find("...") {
            let end = start + text[start..].find(|sign| sign != '.').unwrap_or(text.len() - start);
            let meant = format!("{}..{}", text[..start].trim_end(), text[end..].trim_start());
            return Err(Fault::new("more than two dots in a range", Span { start, end }, "expected `..`")
                .try_this(format!("write `{meant}`")));
        }
        if let Some((first, last)) = between_dashes(text) {
            let whole = trimmed(text, 0, text.len());
            return Err(Fault::new("a difference where values are expected", whole, "a range has two dots")
                .try_this(format!("write `{first}..{last}`")));
        }
        if let Some((first, last)) = between_words(text) {
            let whole = trimmed(text, 0, text.len());
            return Err(Fault::new("words where values are expected", whole, "a range has two dots")
                .try_this(format!("write `{first}..{last}`")));
        }
        if let Some(values) = listed(text) {
            // A range among them is written out.
            let each = values.iter().flat_map(|value| match Domain::range(value) {
                Ok(Domain::Range { count, .. }) if count > MOST_WRITTEN => vec![(*value).to_owned()],
                Ok(range @ Domain::Range { .. }) => {
                    (0..range.size()).map(|place| print::plain(&range.value(place))).collect()
                }
                _ => vec![(*value).to_owned()],
            });
            let list = each.map(|value| format!("\"{value}\"")).collect::<Vec<_>>().join(", ");
            let whole = trimmed(text, 0, text.len());
            return Err(Fault::new("several values in one text", whole, "in a list each has its own quotes")
                .try_this(format!("write `[{list}]`")));
        }
        if text.trim().is_empty() {
            let expected = "a range or a list of values";
            return Err(Fault::new("no value stands here", Span::default(), expected)
                .try_this("write a range, `\"4..12\"`, or a list, `[\"1/4\", \"1/2\"]`"));
        }
        let Some(dots) = text.find("..") else {
            return Ok(Domain::List(vec![read_as_written(text, Angles::Degrees)?]));
        };
        let after = dots + 2;
        if let Some(at) = text[after..].find("steps") {
            let (start, end) = (after + at, after + at + "steps".len());
            let meant = format!("{}step{}", &text[..start], &text[end..]);
            return Err(Fault::new("`steps` in a range", Span { start, end }, "expected `step`")
                .try_this(format!("write `{meant}`")));
        }
        let (last_end, step_text) = match text[after..].find("step") {
            Some(at) => (after + at, Some(after + at + 4)),
            None => (text.len(), None),
        };
        let first = number(text, 0, dots)?;
        let last = number(text, after, last_end)?;
        let step = match step_text {
            Some(from) => number(text, from, text.len())?,
            None => Fraction::ONE,
        };
        let step_span = || trimmed(text, step_text.unwrap_or(0), text.len());
        if step.sign().is_le() {
            return Err(Fault::new("the step is not above nought", step_span(), "expected a positive step")
                .try_this("leave `step` out for steps of one, or write `step 1/2`, `step 5`"));
        }
        let whole = trimmed(text, 0, last_end);
        if last < first {
            let swapped = format!("{}..{}", text[after..last_end].trim(), text[..dots].trim());
            return Err(Fault::new("the range runs backwards", whole, "it holds no value")
                .try_this(format!("did you mean `{swapped}`?")));
        }
        let steps = &(&last - &first) / &step;
        let beyond = || Fault::new("the range is too long", whole, "more values than can be counted");
        let count = u64::try_from(steps.floor()).ok().and_then(|steps| steps.checked_add(1)).ok_or_else(beyond)?;
        if !steps.is_integer() {
            let reached = &first + &(&step * &Fraction::from(steps.floor()));
            return Err(Fault::new(
                "the steps do not reach the end of the range",
                whole,
                format!("the last value is {reached}"),
            )
            .try_this(format!("end the range at {reached}")));
        }
        Ok(Domain::Range { first, step, count, decimals: text.replace("..", " ").contains('.') })
    }

    /// How many values there are.
    pub fn size(&self) -> u64 {
        match self {
            Domain::Range { count, .. } => *count,
            Domain::List(values) => values.len() as u64,
        }
    }

    /// The value with an index below [`Domain::size`]; larger ones begin again at the first.
    pub fn value(&self, index: u64) -> Expr {
        let index = index % self.size().max(1);
        match self {
            Domain::Range { first, step, decimals, .. } => {
                let value = first + &(step * &Fraction::from(dashu_int::IBig::from(index)));
                if *decimals { decimal(&value) } else { written(&Value::from(value)) }
            }
            Domain::List(values) => values.get(index as usize).cloned().unwrap_or_else(|| Expr::integer(0)),
        }
    }

    /// Does a value stand in it, written in the same way?
    pub fn contains(&self, value: &Expr) -> bool {
        match self {
            Domain::List(values) => values.contains(value),
            Domain::Range { first, step, count, .. } => constant(value).is_some_and(|value| {
                let steps = &(&value - first) / step;
                steps.is_integer() && steps.sign().is_ge() && steps < Fraction::from(dashu_int::IBig::from(*count))
            }),
        }
    }
}

/// The two whole numbers of `4-12`, which nobody writes for the value −8.
fn between_dashes(text: &str) -> Option<(&str, &str)> {
    let (first, last) = text.split_once(['-', '–'])?;
    let is_whole = |end: &str| !end.is_empty() && end.bytes().all(|sign| sign.is_ascii_digit());
    Some((first.trim(), last.trim())).filter(|(first, last)| is_whole(first) && is_whole(last))
}

/// Values that are written one after another in one text: `2, 3, 4`. `2,5` is one decimal number.
fn listed(text: &str) -> Option<Vec<&str>> {
    let values: Vec<&str> = text.split([',', ';']).map(str::trim).filter(|value| !value.is_empty()).collect();
    let is_list = values.len() > 2 || (values.len() == 2 && text.contains([' ', ';']));
    (is_list && !text.contains(['(', '[', '"'])).then_some(values)
}

/// The two numbers of `4 to 12`.
fn between_words(text: &str) -> Option<(&str, &str)> {
    let (first, last) = [" to ", " until ", " up to "].iter().rev().find_map(|word| text.split_once(word))?;
    let is_number = |end: &str| end.starts_with(|sign: char| sign.is_ascii_digit() || sign == '-');
    Some((first.trim(), last.trim())).filter(|(first, last)| is_number(first) && is_number(last))
}

/// With a decimal point, if it has finitely many decimals.
fn decimal(value: &Fraction) -> Expr {
    match Decimal::exact(&value.abs()) {
        Some(digits) if digits.places > 0 && value.sign().is_lt() => Expr::Decimal(digits.to_string()).negated(),
        Some(digits) if digits.places > 0 => Expr::Decimal(digits.to_string()),
        _ => written(&Value::from(value.clone())),
    }
}

/// A part of the text without the space around it.
fn trimmed(text: &str, from: usize, to: usize) -> Span {
    let part = &text[from..to];
    let start = from + part.len() - part.trim_start().len();
    Span { start, end: start + part.trim().len() }
}

/// The number that stands in a part of the text.
fn number(text: &str, from: usize, to: usize) -> Result<Fraction, Fault> {
    let span = trimmed(text, from, to);
    let part = &text[span.start..span.end];
    if part.is_empty() {
        return Err(Fault::new("an end of the range is missing", Span { start: from, end: to }, "expected a number")
            .try_this("write a range as `first..last` or `first..last step s`"));
    }
    let shifted = |fault: Fault| {
        let span = Span { start: fault.span.start + span.start, end: fault.span.end + span.start };
        Fault { span, ..fault }
    };
    let expr = read(part, Angles::Degrees).map_err(shifted)?;
    let no_number = || {
        Fault::new(format!("`{part}` is no plain number"), span, "the ends and the step of a range are numbers")
            .try_this("write other values as a list: `[\"sqrt(2)\", \"sqrt(3)\"]`")
    };
    constant(&expr).ok_or_else(no_number)
}

/// The fraction that an expression of plain numbers is.
pub(crate) fn constant(expr: &Expr) -> Option<Fraction> {
    match expr {
        Expr::Number(value) => Some(value.clone()),
        Expr::Decimal(text) => text.parse().ok(),
        Expr::Negative(inner) => Some(-constant(inner)?),
        Expr::Quotient(above, below) => Some(&constant(above)? * &constant(below)?.reciprocal()?),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::expr::print;

    #[test]
    fn ranges_hold_their_ends_and_every_step_between() {
        let table = [
            ("1..6", 6, "1", "6"),
            ("10..80 step 5", 15, "10", "80"),
            ("1/4..3/4 step 1/4", 3, "1/4", "3/4"),
            ("-3..3 step 2", 4, "-3", "3"),
            ("0.2 .. 0.8 step 0.1", 7, "1/5", "4/5"),
            ("5..5", 1, "5", "5"),
        ];
        for (text, size, first, last) in table {
            let domain = Domain::range(text).unwrap();
            assert_eq!(domain.size(), size, "{text}");
            assert_eq!(constant(&domain.value(0)), first.parse().ok(), "{text}");
            assert_eq!(constant(&domain.value(size - 1)), last.parse().ok(), "{text}");
            assert!((0..size).all(|index| domain.contains(&domain.value(index))), "{text}");
        }
    }

    #[test]
    fn decimals_are_printed_as_decimals() {
        let values = |text: &str| {
            let domain = Domain::range(text).unwrap();
            (0..domain.size()).map(|index| print::plain(&domain.value(index))).collect::<Vec<_>>()
        };
        assert_eq!(values("-0.5..1 step 0.5"), ["-0.5", "0", "0.5", "1"]);
        assert_eq!(values("0.25"), ["0.25"]);
        assert_eq!(values("-1/2..1/2 step 1/2"), ["-1/2", "0", "1/2"]);
    }

    #[test]
    fn values_in_one_text_are_written_as_a_list() {
        let help = |text: &str| Domain::range(text).unwrap_err().help.unwrap();
        assert_eq!(help("2, 3"), "write `[\"2\", \"3\"]`");
        assert_eq!(help("2..4, 8"), "write `[\"2\", \"3\", \"4\", \"8\"]`");
    }

    #[test]
    fn a_range_that_cannot_be_walked_is_a_fault_at_its_place() {
        let table = [
            ("6..1", "the range runs backwards", "6..1"),
            ("4...12", "more than two dots in a range", "..."),
            ("4-12", "a difference where values are expected", "4-12"),
            ("4 to 12", "words where values are expected", "4 to 12"),
            ("0.5 up to 2.5", "words where values are expected", "0.5 up to 2.5"),
            ("2,3,4", "several values in one text", "2,3,4"),
            ("1/2, 3/4", "several values in one text", "1/2, 3/4"),
            ("2; 3", "several values in one text", "2; 3"),
            ("2..6 steps 2", "`steps` in a range", "steps"),
            ("", "no value stands here", ""),
            ("1..6 step 0", "the step is not above nought", "0"),
            ("1..", "an end of the range is missing", ""),
            ("1..sqrt(2)", "`sqrt(2)` is no plain number", "sqrt(2)"),
            ("1..6 step 2", "the steps do not reach the end of the range", "1..6"),
            ("1..10^9999999", "`10^9999999` is no plain number", "10^9999999"),
            ("0..1 step 1/99999999999999999999999", "the range is too long", "0..1"),
        ];
        for (text, message, at) in table {
            let fault = Domain::range(text).unwrap_err();
            assert_eq!(fault.message, message);
            assert_eq!(&text[fault.span.start..fault.span.end], at);
        }
    }
}
