//! What a question demands of its numbers: `mA != mB`, `A.after.n > 0`, `A.after.speed is an integer`,
//! `denominator(A.after.speed) = 2`.

use std::str::FromStr;

use super::domain::constant;
use super::givens::names_in_degrees;
use crate::diagnostic::near;
use crate::expr::{Angles, Expr, Fault, Meaning, Name, Names, Span, evaluate, holds, read};
use crate::mechanics::{Quantity, Sphere, formula_meant, formulas_meant, is_sentence};
use crate::number::{Fraction, Root, Value};

/// A relation that must hold, over givens or results.
#[derive(Clone, Debug)]
pub struct Requirement {
    /// As it was written.
    pub text: String,
    /// The relation; where a measure was written stands a name of our own.
    relation: Expr,
    /// These names, each with its measure and what is measured.
    measured: Vec<(String, Measure, Expr)>,
    /// Every other name in it, and the quantity that has it: looked up once, and not for every set of numbers.
    names: Vec<(Name, Option<Quantity>)>,
}

/// How simple a number is; only requirements can ask.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Measure {
    /// `denominator(x)`: of a fraction, or the common one of a sum of surds.
    Denominator,
    /// `radicand(x)`: what stands under the square root, one if nothing does.
    Radicand,
    /// `terms(x)`: of how many terms it is the sum.
    Terms,
}

impl Measure {
    /// Every measure.
    pub const ALL: [Measure; 3] = [Measure::Denominator, Measure::Radicand, Measure::Terms];

    /// Its name in a requirement.
    pub fn name(self) -> &'static str {
        match self {
            Measure::Denominator => "denominator",
            Measure::Radicand => "radicand",
            Measure::Terms => "terms",
        }
    }

    /// The measure of a number; `None` where it has no meaning, as the radicand of a nested root.
    ///
    /// ```
    /// use carom::bank::Measure;
    /// use carom::number::Value;
    /// let root = Value::fraction(12, 25).square_root().unwrap();
    /// assert_eq!(Measure::Denominator.of(&root), Some(5.into()));
    /// assert_eq!(Measure::Radicand.of(&root), Some(3.into()));
    /// assert_eq!(Measure::Terms.of(&root), Some(1.into()));
    /// ```
    pub fn of(self, value: &Value) -> Option<Fraction> {
        let (terms, below) = value.parts();
        match self {
            Measure::Denominator => {
                below.as_constant()?;
                let mut common = Fraction::ONE;
                for coefficient in terms.coefficients() {
                    let denominator = Fraction::from(coefficient.as_constant()?.denominator());
                    let shared = Fraction::from((&common / &denominator).denominator());
                    // Times what the other denominator has beyond the common one.
                    common = &common * &shared;
                }
                Some(common)
            }
            Measure::Radicand => {
                let mut largest = Fraction::ONE;
                for roots in terms.products() {
                    let mut product = Fraction::ONE;
                    for root in roots {
                        match root {
                            Root::Prime(_) => product = &product * root.square().as_fraction()?,
                            _ => return None,
                        }
                    }
                    largest = largest.max(product);
                }
                value.is_constant().then_some(largest)
            }
            Measure::Terms => Some(Fraction::from(i64::try_from(terms.len()).ok()?)),
        }
    }
}

/// How to close a bracket: as a rule what it holds ends where the relation begins.
fn closed_before_relation(text: &str, open: usize) -> String {
    let end = text[open..].find(['<', '>', '=', '!']).map(|end| open + end);
    match end.map(|end| (text[..end].trim_end(), &text[end..])) {
        Some((inside, relation)) => format!("write `{inside}) {relation}`"),
        None => "write `)` where the brackets end".to_owned(),
    }
}

impl Requirement {
    /// Reads a requirement.
    ///
    /// # Errors
    ///
    /// A [`Fault`] with its place, if it cannot be read or is no relation.
    pub fn read(text: &str) -> Result<Requirement, Fault> {
        if let Some((what, measures)) = in_words(text).filter(|(what, _)| !is_sentence(what)) {
            return Requirement::all_one(text, what, measures);
        }
        if is_sentence(text) && said_meant(text).is_none() {
            return Err(sentence_fault("a requirement in words", text));
        }
        let mut plain = text.to_owned();
        let mut measured = Vec::new();
        while let Some((measure, start, open)) = next_measure(&plain) {
            let Some(end) = closing(&plain, open) else {
                let span = Span { start: open, end: open + 1 };
                let fault = Fault::new("`(` is never closed", span, "its `)` is missing");
                return Err(fault.try_this(closed_before_relation(&plain, open)));
            };
            let inside = read(&plain[open + 1..end], Angles::Degrees).map_err(|fault| fault.shifted(open + 1))?;
            // A name of equal length keeps every other place where it is.
            let name = format!("{:_<width$}", format!("Q{}", measured.len()), width = end + 1 - start);
            plain.replace_range(start..end + 1, &name);
            measured.push((name, measure, names_in_degrees(&inside.moved(open + 1))));
        }
        let relation = names_in_degrees(&read(&plain, Angles::Degrees)?);
        if !matches!(relation, Expr::Relation(..)) {
            let span = Span { start: 0, end: text.len() };
            return Err(Fault::new(
                "a requirement without a relation",
                span,
                "expected `=`, `!=`, `<`, `<=`, `>`, `>=`, `is an integer` or `is rational`",
            )
            .try_this(relation_meant(text)));
        }
        Ok(Requirement::new(text, relation, measured))
    }

    fn new(text: &str, relation: Expr, measured: Vec<(String, Measure, Expr)>) -> Requirement {
        let own = |name: &&Name| !measured.iter().any(|(own, ..)| *own == name.text);
        let plain = relation.names().into_iter().filter(own);
        let names = plain.chain(measured.iter().flat_map(|(_, _, inside)| inside.names()));
        let names = names.map(|name| (name.clone(), Quantity::from_str(&name.text).ok())).collect();
        Requirement { text: text.to_owned(), relation, measured, names }
    }

    /// That every one of these measures of a formula is one.
    fn all_one(text: &str, what: &str, measures: &[Measure]) -> Result<Requirement, Fault> {
        let inside = names_in_degrees(&read(what, Angles::Degrees)?);
        let name = |place: usize| format!("Q{place}");
        let names: Vec<String> = (0..measures.len()).map(name).collect();
        // Each is at least one, so that all are if their product is.
        let relation = read(&format!("{} = 1", names.join("*")), Angles::Degrees)?;
        let measured = measures.iter().enumerate().map(|(place, measure)| (name(place), *measure, inside.clone()));
        Ok(Requirement::new(text, relation, measured.collect()))
    }

    /// Every name in it.
    pub fn names(&self) -> impl Iterator<Item = &Name> {
        self.names.iter().map(|(name, _)| name)
    }

    /// The quantities in it that are neither parameters nor derived names: what must be solved for first.
    pub fn quantities(&self, is_given: &dyn Fn(&str) -> bool) -> impl Iterator<Item = Quantity> {
        self.names.iter().filter_map(move |(name, quantity)| quantity.filter(|_| !is_given(&name.text)))
    }

    /// Must the collision be solved before it can be tried? If it names a quantity, or a letter that is to be found.
    pub fn is_on_results(&self, unknowns: &[String], is_given: &dyn Fn(&str) -> bool) -> bool {
        self.names().any(|name| unknowns.contains(&name.text)) || self.quantities(is_given).next().is_some()
    }

    /// Does it hold? Not if that depends on letters, or if a name has no value.
    ///
    /// # Errors
    ///
    /// A [`Fault`] if its formulas have no value, as by a division by nought.
    pub fn holds(&self, names: Names) -> Result<bool, Fault> {
        let mut sizes: Vec<(&str, Fraction)> = Vec::new();
        for (name, measure, inside) in &self.measured {
            let size = match evaluate(inside, names)? {
                Meaning::Number(value) => measure.of(&value),
                // The degrees of a whole or half number of degrees are a number; others are no fraction.
                _ => None,
            };
            match size {
                Some(size) => sizes.push((name.as_str(), size)),
                None => return Ok(false),
            }
        }
        let with_sizes = |name: &str| match sizes.iter().find(|(own, _)| *own == name) {
            Some((_, size)) => Some(Meaning::Number(Value::from(size.clone()))),
            None => names(name),
        };
        Ok(holds(&self.relation, &with_sizes)? == Some(true))
    }

    /// For givens that are all plain numbers: is it always true, or always false?
    pub(crate) fn is_constant(&self) -> bool {
        match &self.relation {
            Expr::Relation(left, _, right) => constant(left).is_some() && constant(right).is_some(),
            _ => false,
        }
    }
}

/// What was perhaps to be said where no relation stands.
fn relation_meant(text: &str) -> String {
    if let Some(meant) = said_meant(text).or_else(|| measure_meant(text)) {
        return format!("did you mean `{meant}`?");
    }
    format!("write `{}`", formula_meant(text).unwrap_or_else(|| format!("{text} > 0")))
}

/// What is said of a formula, with a slip of the pen in it: `A.after.speed is an integr`.
fn said_meant(text: &str) -> Option<String> {
    let (what, said) = text.split_once(" is ")?;
    let is_not = said.trim().starts_with("not ");
    if said.trim() == "irrational" || said.trim() == "not rational" {
        return Some(format!("radicand({}) > 1", what.trim()));
    }
    let words = near(said.trim(), SAID.map(|(words, _)| words)).filter(|_| !is_not && !is_sentence(what))?;
    Some(format!("{} is {words}", what.trim()))
}

/// What is said of a formula as if it were a function: `integer(A.after.speed)`.
fn measure_meant(text: &str) -> Option<String> {
    let (function, inside) = text.strip_suffix(')')?.split_once('(')?;
    let said = SAID.iter().find(|(words, _)| words.ends_with(function.trim()) && !function.trim().is_empty())?;
    Some(format!("{} is {}", inside.trim(), said.0))
}

/// The fault of a sentence where a relation is expected, with the formula to write.
pub(super) fn sentence_fault(message: &str, text: &str) -> Fault {
    let span = Span { start: 0, end: text.len() };
    let is_sphere = |what: &str| Sphere::ALL.iter().any(|sphere| sphere.name() == what.trim());
    let help = match (formulas_meant(text).as_slice(), text.split_once(" is ")) {
        ([one], _) => format!("write `{one}`"),
        ([one, other], _) => format!("write `{one}` and `{other}`, each in its own quotes"),
        (_, Some((what, _))) if !is_sentence(what) && !is_sphere(what) => {
            format!("write `{} is an integer`, or a relation such as `{} > 0`", what.trim(), what.trim())
        }
        _ if text.contains(" or ") => {
            "each of them must hold; for one value or another write a product, `(n - 3)*(n - 4) = 0`".to_owned()
        }
        _ => "write a relation such as `A.after.speed > 3`, or `A.after.speed is an integer`".to_owned(),
    };
    Fault::new(message, span, "expected a relation between formulas").try_this(help)
}

/// What can be said of a number in words.
const SAID: [(&str, &[Measure]); 3] = [
    ("an integer", &[Measure::Denominator, Measure::Radicand]),
    ("a whole number", &[Measure::Denominator, Measure::Radicand]),
    ("rational", &[Measure::Radicand]),
];

/// What is said to be an integer or rational, and the measures that are one of such a number.
fn in_words(text: &str) -> Option<(&str, &'static [Measure])> {
    SAID.into_iter().find_map(|(words, measures)| {
        let what = text.trim_end().strip_suffix(words)?.trim_end().strip_suffix(" is")?;
        Some((what, measures))
    })
}

/// The first measure in the text: which, where it begins, where its bracket opens.
fn next_measure(text: &str) -> Option<(Measure, usize, usize)> {
    let found = Measure::ALL.into_iter().flat_map(|measure| {
        text.match_indices(measure.name()).filter_map(move |(start, word)| {
            let is_name = |c: char| c.is_ascii_alphanumeric() || c == '_' || c == '.';
            let after = &text[start + word.len()..];
            let open = text.len() - after.trim_start().len();
            (!text[..start].ends_with(is_name) && text[open..].starts_with('(')).then_some((measure, start, open))
        })
    });
    found.min_by_key(|(_, start, _)| *start)
}

/// The bracket that closes the one at `open`.
fn closing(text: &str, open: usize) -> Option<usize> {
    let mut depth = 0;
    for (at, c) in text[open..].char_indices() {
        depth += i32::from(c == '(') - i32::from(c == ')');
        if depth == 0 {
            return Some(open + at);
        }
    }
    None
}

#[cfg(test)]
mod tests {
    use super::*;

    fn value(name: &str) -> Option<Meaning> {
        let number = match name {
            "a" => Value::fraction(7, 12),
            "b" => Value::from(18).square_root().unwrap(),
            "c" => &Value::fraction(1, 6) + &Value::fraction(27, 16).square_root().unwrap(),
            "A.after.n" => Value::from(-2),
            "alpha" => Value::from(30),
            _ => return None,
        };
        Some(Meaning::Number(number))
    }

    #[test]
    fn requirements_hold_or_do_not() {
        let table = [
            ("a != b", true),
            ("A.after.n > 0", false),
            ("denominator(a) = 12", true),
            ("denominator(b) = 1", true),
            ("denominator(c) = 12", true),
            ("radicand(b) = 2", true),
            ("radicand(a) = 1", true),
            ("radicand(c) <= 3", true),
            ("terms(c) = 2", true),
            ("terms (a + (b)) + 1 = 3", true),
            ("denominator(2*a) < denominator(a)", true),
            ("tan(alpha)^2 = 1/3", true),
            ("sin(2*alpha + 30) = 1", true),
            ("denominator(cos(alpha)) = 2", true),
            ("A.after.n is an integer", true),
            ("a is an integer", false),
            ("12*a is a whole number", true),
            ("b is an integer", false),
            ("b^2 is an integer", true),
            ("a + 5/12 is rational ", true),
            ("c is rational", false),
            ("alpha is an integer", true),
            ("a - a is an integer", true),
        ];
        for (text, expected) in table {
            assert_eq!(Requirement::read(text).unwrap().holds(&value), Ok(expected), "{text}");
        }
    }

    #[test]
    fn what_is_said_in_words_is_written_as_it_was_meant() {
        for (text, meant) in [
            ("A.after.speed is an integr", "A.after.speed is an integer"),
            ("A.after.speed is irrational", "radicand(A.after.speed) > 1"),
            ("A.after.speed is not rational", "radicand(A.after.speed) > 1"),
        ] {
            assert_eq!(said_meant(text).as_deref(), Some(meant), "{text}");
        }
    }

    #[test]
    fn the_names_of_a_requirement_keep_their_places() {
        let text = "denominator(x + y) = z";
        let requirement = Requirement::read(text).unwrap();
        let names: Vec<&Name> = requirement.names().collect();
        assert_eq!(names.iter().map(|name| name.text.as_str()).collect::<Vec<_>>(), ["z", "x", "y"]);
        assert!(names.iter().all(|name| text[name.span.start..name.span.end] == name.text));
        let fault = Requirement::read("denominator(x + ) = 1").unwrap_err();
        assert_eq!(fault.span.start, 15);
        assert!(Requirement::read("mA + 1").is_err());
        assert!(Requirement::read("terms(x").is_err());
    }

    #[test]
    fn results_are_told_from_givens() {
        let requirement = Requirement::read("e + A.after.n > separation").unwrap();
        let quantities = requirement.quantities(&|name| name == "e");
        assert_eq!(quantities.map(|quantity| quantity.to_string()).collect::<Vec<_>>(), ["A.after.n", "separation"]);
    }
}
