//! Walks over an expression: its names, and other expressions put in their place.

use super::{Expr, Name, Span};

impl Expr {
    /// The same node with each child replaced.
    pub(crate) fn map_children(&self, change: &mut dyn FnMut(&Expr) -> Expr) -> Expr {
        match self {
            Expr::Number(_) | Expr::Decimal(_) | Expr::Name(_) | Expr::Pi => self.clone(),
            Expr::Degrees(inner) => Expr::Degrees(Box::new(change(inner))),
            Expr::Negative(inner) => Expr::Negative(Box::new(change(inner))),
            Expr::Call(function, argument) => Expr::Call(*function, Box::new(change(argument))),
            Expr::Sum(terms) => Expr::Sum(terms.iter().map(change).collect()),
            Expr::Product(factors) => Expr::Product(factors.iter().map(change).collect()),
            Expr::Quotient(a, b) => Expr::Quotient(Box::new(change(a)), Box::new(change(b))),
            Expr::Power(a, b) => Expr::Power(Box::new(change(a)), Box::new(change(b))),
            Expr::Vector(a, b) => Expr::Vector(Box::new(change(a)), Box::new(change(b))),
            Expr::Relation(a, relation, b) => Expr::Relation(Box::new(change(a)), *relation, Box::new(change(b))),
        }
    }

    /// Is it so of every child?
    pub(crate) fn all_children(&self, is_so: &mut dyn FnMut(&Expr) -> bool) -> bool {
        match self {
            Expr::Number(_) | Expr::Decimal(_) | Expr::Name(_) | Expr::Pi => true,
            Expr::Degrees(inner) | Expr::Negative(inner) | Expr::Call(_, inner) => is_so(inner),
            Expr::Sum(parts) | Expr::Product(parts) => parts.iter().all(is_so),
            Expr::Quotient(a, b) | Expr::Power(a, b) | Expr::Vector(a, b) | Expr::Relation(a, _, b) => {
                is_so(a) && is_so(b)
            }
        }
    }

    /// The parts of which the node is made, in the order in which they are written.
    pub fn children(&self) -> Vec<&Expr> {
        match self {
            Expr::Number(_) | Expr::Decimal(_) | Expr::Name(_) | Expr::Pi => Vec::new(),
            Expr::Degrees(inner) | Expr::Negative(inner) | Expr::Call(_, inner) => vec![inner],
            Expr::Sum(parts) | Expr::Product(parts) => parts.iter().collect(),
            Expr::Quotient(a, b) | Expr::Power(a, b) | Expr::Vector(a, b) | Expr::Relation(a, _, b) => vec![a, b],
        }
    }

    /// The expression with other expressions in place of the names for which `value` has one.
    ///
    /// ```
    /// use carom::expr::{Expr, print};
    /// let twice = Expr::product([Expr::integer(2), Expr::name("u")]);
    /// let speed = twice.substitute(&|name| (name == "u").then(|| Expr::integer(-3)));
    /// assert_eq!(print::plain(&speed), "2*(-3)");
    /// ```
    pub fn substitute(&self, value: &dyn Fn(&str) -> Option<Expr>) -> Expr {
        match self {
            Expr::Name(name) => value(&name.text).unwrap_or_else(|| self.clone()),
            _ => self.map_children(&mut |child| child.substitute(value)),
        }
    }

    /// The expression with the places of its names moved on by so many bytes.
    pub(crate) fn moved(self, by: usize) -> Expr {
        match self {
            Expr::Name(Name { text, span }) => {
                Expr::Name(Name { text, span: Span { start: span.start + by, end: span.end + by } })
            }
            other => other.map_children(&mut |child| child.clone().moved(by)),
        }
    }

    /// Every name in it, as often and in the order in which they stand, unit vectors included.
    pub fn names(&self) -> Vec<&Name> {
        let mut found = Vec::new();
        self.collect_names(&mut found);
        found
    }

    fn collect_names<'a>(&'a self, found: &mut Vec<&'a Name>) {
        if let Expr::Name(name) = self {
            found.push(name);
        }
        for child in self.children() {
            child.collect_names(found);
        }
    }
}
