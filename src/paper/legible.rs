//! Numbers that no line holds: a formula of many sines of general angles gives way to its decimal.

use super::{PrintedPart, WorkingLine};
use crate::expr::{Expr, Function, Relation, number, print};
use crate::number::Places;

/// So many letters and digits fit on a line of a page.
const LINE: usize = 100;

/// So many of them in one fraction or root: a line is broken at signs, and these are not.
const PIECE: usize = 52;

/// The same in the narrower column of a mark scheme.
const COLUMN: usize = 44;

/// With so many figures a value goes into the next line of the working.
const CARRIED: Places = Places::SignificantFigures(5);

/// A part with nothing in it that is too long to be read.
pub fn part(mut part: PrintedPart) -> PrintedPart {
    part.working = part.working.into_iter().map(line).collect();
    for row in &mut part.scheme {
        // The note of a mark for a single value has its decimal already.
        let has_note = row.equations.len() == 1 && !row.earned.is_empty();
        row.equations.retain_mut(|equation| {
            let legible = formula(equation, COLUMN);
            let told = has_note && matches!(legible, Expr::Decimal(_)) && legible != *equation;
            *equation = legible;
            !told
        });
    }
    for answer in &mut part.answers {
        let long = answer.exact.as_ref().is_some_and(|exact| formula(exact, COLUMN) != *exact);
        if long && answer.rounded.is_some() {
            answer.exact = answer.rounded.take();
        }
    }
    part
}

/// A line of working. In a chain what is exact stands before what is not; a carried value is left out where another
/// follows.
fn line(mut line: WorkingLine) -> WorkingLine {
    let side = |equation: &Expr| match equation {
        Expr::Relation(left, ..) => Some((**left).clone()),
        _ => None,
    };
    let is_about = |equation: &Expr| matches!(equation, Expr::Relation(_, Relation::Approximately, _));
    let is_decimal =
        |equation: &Expr| matches!(equation, Expr::Relation(_, _, right) if matches!(**right, Expr::Decimal(_)));
    let mut chains: Vec<Vec<(Expr, bool)>> = Vec::new();
    for equation in &line.equations {
        let legible = formula(equation, PIECE);
        let is_carried = legible != *equation && is_decimal(&legible);
        match chains.last_mut().filter(|chain| side(&chain[0].0).is_some_and(|left| Some(left) == side(&legible))) {
            Some(chain) => chain.push((legible, is_carried)),
            None => chains.push(vec![(legible, is_carried)]),
        }
    }
    for chain in &mut chains {
        if chain.len() > 1 && chain.iter().any(|(_, is_carried)| !is_carried) {
            chain.retain(|(_, is_carried)| !is_carried);
        }
        // Two steps that come to one decimal are one.
        chain.dedup_by(|next, last| next.0 == last.0);
        chain.sort_by_key(|(equation, _)| is_about(equation));
    }
    line.equations = chains.into_iter().flatten().map(|(equation, _)| equation).collect();
    line
}

/// A formula in which every number that is too long for its place is a decimal; an equation is then an approximation.
fn formula(expr: &Expr, most: usize) -> Expr {
    match expr {
        Expr::Relation(left, Relation::Equal, right) => {
            let (first, second) = (shortened(left, most), shortened(right, most));
            let same = first == **left && second == **right;
            let relation = if same { Relation::Equal } else { Relation::Approximately };
            Expr::Relation(Box::new(first), relation, Box::new(second))
        }
        other => shortened(other, most),
    }
}

fn shortened(expr: &Expr, most: usize) -> Expr {
    if matches!(expr, Expr::Quotient(..) | Expr::Call(Function::Sqrt, _)) {
        return piece(expr, most);
    }
    let pieces = expr.map_children(&mut |child| shortened(child, most));
    if length(&pieces) <= LINE { pieces } else { decimal(expr).unwrap_or(pieces) }
}

/// The same within a fraction or a root.
fn piece(expr: &Expr, most: usize) -> Expr {
    if length(expr) <= most {
        return expr.clone();
    }
    decimal(expr)
        .or_else(|| with_decimal_coefficient(expr))
        .unwrap_or_else(|| expr.map_children(&mut |child| piece(child, most)))
}

/// `26.212m`: letters times a number that is too long, all of it one decimal.
fn with_decimal_coefficient(expr: &Expr) -> Option<Expr> {
    let (above, below) = match expr {
        Expr::Quotient(above, below) => (&**above, Some(&**below)),
        other => (other, None),
    };
    let Expr::Product(factors) = above else { return None };
    let (numbers, letters): (Vec<Expr>, Vec<Expr>) =
        factors.iter().cloned().partition(|factor| factor.names().is_empty());
    let number = Expr::product(numbers);
    let coefficient = decimal(&below.map_or_else(|| number.clone(), |below| number.clone().over(below.clone())))?;
    Some(Expr::product(std::iter::once(coefficient).chain(letters)))
}

fn length(expr: &Expr) -> usize {
    print::unicode(expr).chars().count()
}

/// The decimal of what is a number.
fn decimal(expr: &Expr) -> Option<Expr> {
    let value = number(expr, &|_| None).ok()?.rounded(&CARRIED).ok()?;
    Some(Expr::Decimal(value.to_string()))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::expr::{Angles, Text, read};

    fn read_equation(text: &str) -> Expr {
        let (left, right) = text.split_once(" = ").unwrap();
        Expr::equation(read(left, Angles::Degrees).unwrap(), read(right, Angles::Degrees).unwrap())
    }

    /// 1 + 1 + … as a sum of so many squares of sine and cosine.
    fn ones(count: usize) -> String {
        vec!["(sin(37)^2 + cos(37)^2)"; count].join(" + ")
    }

    #[test]
    fn carom_prints_a_decimal_where_no_line_holds_the_number() {
        let short = read_equation("v = 3*cos(37) - 7*sin(65)");
        assert_eq!(formula(&short, PIECE), short);
        let long = formula(&read_equation(&format!("v = {}", ones(9))), PIECE);
        assert_eq!(print::unicode(&long), "v ≈ 9.0000");
        let with_letter = formula(&read_equation(&format!("L = m*({})/64", ones(9))), PIECE);
        assert_eq!(print::unicode(&with_letter), "L ≈ 0.14063m");
        assert_eq!(formula(&with_letter, PIECE), with_letter);
        let in_a_fraction = formula(&read_equation(&format!("v = 2 + (1 + {})/4", ones(3))), PIECE);
        assert_eq!(print::unicode(&in_a_fraction), "v ≈ 2 + 1.0000");
        let broken_at_signs = read_equation(&format!("v = 2*(1 + {})", ones(2)));
        assert_eq!(formula(&broken_at_signs, PIECE), broken_at_signs);
        // What holds a letter in every part cannot be shortened.
        let letters = read_equation(&format!("v = {}", vec!["cos(theta)*m"; 30].join(" + ")));
        assert_eq!(formula(&letters, PIECE), letters);
    }

    #[test]
    fn carom_does_not_round_twice_in_a_row() {
        let about = |digits: &str| {
            Expr::Relation(
                Box::new(Expr::name("v")),
                Relation::Approximately,
                Box::new(Expr::Decimal(digits.to_owned())),
            )
        };
        let equations =
            vec![read_equation("v = sqrt(80 + 1)"), read_equation(&format!("v = {}", ones(9))), about("9.00")];
        let printed = line(WorkingLine { words: Text::default(), equations, label: None });
        assert_eq!(printed.equations.iter().map(print::unicode).collect::<Vec<_>>(), ["v = √(80 + 1)", "v ≈ 9.00"]);
    }

    #[test]
    fn carom_says_the_same_decimal_once() {
        let steps = [format!("5 - 5 + {}", ones(9)), ones(9)];
        let equations = steps.map(|right| read_equation(&format!("cos(delta) = {right}")));
        let printed = line(WorkingLine { words: Text::default(), equations: equations.to_vec(), label: None });
        assert_eq!(printed.equations.iter().map(print::unicode).collect::<Vec<_>>(), ["cos δ ≈ 9.0000"]);
    }
}
