//! The ASCII form in which expressions are exchanged with other programs: `16*sqrt(3)/9`.

use super::letter::VECTOR;
use super::shape::{Vectors, tidied};
use crate::expr::{Expr, Relation};

/// The exchange form, in radians, with every product and power explicit.
///
/// ```
/// use carom::expr::{Expr, Function, print};
/// let root = Expr::call(Function::Sqrt, Expr::integer(3));
/// let size = Expr::product([Expr::integer(16), root]).over(Expr::integer(9));
/// assert_eq!(print::plain(&size), "16*sqrt(3)/9");
/// ```
pub fn plain(expr: &Expr) -> String {
    bare(&tidied(expr, Vectors::Pairs))
}

/// How tightly the outermost sign of a text holds it together.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Hold {
    Relation,
    Sum,
    Product,
    Power,
    Atom,
}

fn hold(expr: &Expr) -> Hold {
    match expr {
        Expr::Relation(..) => Hold::Relation,
        Expr::Sum(_) | Expr::Negative(_) => Hold::Sum,
        Expr::Product(_) | Expr::Quotient(..) => Hold::Product,
        Expr::Number(value) if !value.is_integer() => Hold::Product,
        Expr::Degrees(inner) if !inner.is_one() => Hold::Product,
        Expr::Power(..) => Hold::Power,
        _ => Hold::Atom,
    }
}

/// The text, in brackets if it holds together less tightly than its place demands.
fn at(expr: &Expr, demanded: Hold) -> String {
    if hold(expr) < demanded { format!("({})", bare(expr)) } else { bare(expr) }
}

fn bare(expr: &Expr) -> String {
    match expr {
        Expr::Number(value) => value.to_string(),
        Expr::Decimal(text) => text.clone(),
        Expr::Name(name) => name.text.trim_start_matches(VECTOR).to_owned(),
        Expr::Pi => "pi".to_owned(),
        Expr::Degrees(inner) if inner.is_one() => "deg".to_owned(),
        Expr::Degrees(inner) => format!("{}*deg", at(inner, Hold::Atom)),
        Expr::Negative(inner) => format!("-{}", at(inner, Hold::Product)),
        Expr::Sum(terms) => sum(terms),
        Expr::Product(factors) => product(factors),
        Expr::Quotient(numerator, denominator) => {
            let top = match &**numerator {
                product @ Expr::Product(_) => bare(product),
                other => at(other, Hold::Power),
            };
            format!("{top}/{}", at(denominator, Hold::Power))
        }
        Expr::Power(base, exponent) => format!("{}^{}", at(base, Hold::Atom), at(exponent, Hold::Atom)),
        Expr::Call(function, argument) => format!("{}({})", function.name(), bare(argument)),
        Expr::Vector(x, y) => format!("[{}, {}]", bare(x), bare(y)),
        Expr::Relation(left, relation, right) => format!("{} {} {}", bare(left), sign(*relation), bare(right)),
    }
}

fn product(factors: &[Expr]) -> String {
    let mut out = String::new();
    for (place, factor) in factors.iter().enumerate() {
        let text = at(factor, Hold::Power);
        match text.as_str() {
            _ if place == 0 => out.push_str(&text),
            // A bare `*deg` would make degrees of the factor before it.
            "deg" => out.push_str("*(deg)"),
            _ => out.extend(["*", &text]),
        }
    }
    out
}

fn sum(terms: &[Expr]) -> String {
    let mut out = String::new();
    for (place, term) in terms.iter().enumerate() {
        match term {
            Expr::Negative(size) => {
                out.push_str(if place == 0 { "-" } else { " - " });
                out.push_str(&at(size, Hold::Product));
            }
            _ => {
                out.push_str(if place == 0 { "" } else { " + " });
                out.push_str(&at(term, if place == 0 { Hold::Sum } else { Hold::Product }));
            }
        }
    }
    out
}

/// The relation in ASCII; the last two are never read.
fn sign(relation: Relation) -> &'static str {
    match relation {
        Relation::Equal => "=",
        Relation::NotEqual => "!=",
        Relation::Less => "<",
        Relation::LessOrEqual => "<=",
        Relation::Greater => ">",
        Relation::GreaterOrEqual => ">=",
        Relation::Implies => "=>",
        Relation::Approximately => "~",
    }
}
