//! The tree of an expression: what a parser reads and what a printer prints.

use crate::number::Fraction;

/// Where something stands in its text: bytes from `start` up to, not including, `end`.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct Span {
    /// First byte.
    pub start: usize,
    /// One past the last byte.
    pub end: usize,
}

/// An expression, equation or vector.
///
/// A tree keeps the form in which a formula was written or composed: `4*4*cos(30 deg)` stays a
/// product of three factors, so that working can show what a student would write.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub enum Expr {
    /// An exact number. Readers produce only numbers that are not negative; composers may produce any.
    Number(Fraction),
    /// Decimal text that is printed as it stands, digits proved elsewhere: `2.78`, `0.590`.
    Decimal(String),
    /// A letter or a quantity: `u`, `alpha`, `v_A`, `A.after.speed`. `i` and `j` are the unit vectors.
    Name(Name),
    /// The ratio of a circle's circumference to its diameter.
    Pi,
    /// An angle given in degrees: `30 deg`.
    Degrees(Box<Expr>),
    /// The expression with its sign changed.
    Negative(Box<Expr>),
    /// A sum of at least two terms; a difference is a sum with a [`Expr::Negative`] term.
    Sum(Vec<Expr>),
    /// A product of at least two factors, in the order written.
    Product(Vec<Expr>),
    /// Numerator over denominator.
    Quotient(Box<Expr>, Box<Expr>),
    /// Base and exponent.
    Power(Box<Expr>, Box<Expr>),
    /// A function applied to one argument.
    Call(Function, Box<Expr>),
    /// A vector by its components along i and j.
    Vector(Box<Expr>, Box<Expr>),
    /// Left side, relation, right side.
    Relation(Box<Expr>, Relation, Box<Expr>),
}

/// A name and where it was read; two names are equal if their texts are.
#[derive(Clone, Debug)]
pub struct Name {
    /// The text: letters, digits, `_` and, in quantities, `.`.
    pub text: String,
    /// Where it stands, so that a fault can point at it.
    pub span: Span,
}

impl PartialEq for Name {
    fn eq(&self, other: &Name) -> bool {
        self.text == other.text
    }
}

impl Eq for Name {}

impl std::hash::Hash for Name {
    fn hash<H: std::hash::Hasher>(&self, state: &mut H) {
        self.text.hash(state);
    }
}

/// The functions of the language. Trigonometry is in radians once an expression has been read.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Function {
    /// Square root.
    Sqrt,
    /// Sine.
    Sin,
    /// Cosine.
    Cos,
    /// Tangent.
    Tan,
    /// Inverse sine, from -pi/2 to pi/2.
    Asin,
    /// Inverse cosine, from 0 to pi.
    Acos,
    /// Inverse tangent, from -pi/2 to pi/2.
    Atan,
    /// Size without sign.
    Abs,
}

impl Function {
    /// Every function, in the order in which messages list them.
    pub const ALL: [Function; 8] = [
        Function::Sqrt,
        Function::Sin,
        Function::Cos,
        Function::Tan,
        Function::Asin,
        Function::Acos,
        Function::Atan,
        Function::Abs,
    ];

    /// The function with whose name a longer word begins, as `cosine` does.
    pub fn begins(word: &str) -> Option<Function> {
        Function::ALL.into_iter().find(|function| word.starts_with(function.name()))
    }

    /// Its name in the language.
    pub fn name(self) -> &'static str {
        match self {
            Function::Sqrt => "sqrt",
            Function::Sin => "sin",
            Function::Cos => "cos",
            Function::Tan => "tan",
            Function::Asin => "asin",
            Function::Acos => "acos",
            Function::Atan => "atan",
            Function::Abs => "abs",
        }
    }
}

/// What stands between the two sides of an equation or requirement.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Relation {
    /// `=`
    Equal,
    /// `!=`
    NotEqual,
    /// `<`
    Less,
    /// `<=`
    LessOrEqual,
    /// `>`
    Greater,
    /// `>=`
    GreaterOrEqual,
    /// Implies; only between two equations in printed working, never read.
    Implies,
    /// Approximately equal, for a rounded value in printed working, never read.
    Approximately,
}

impl Expr {
    /// A whole number.
    pub fn integer(value: i64) -> Expr {
        Expr::Number(Fraction::from(value))
    }

    /// A letter or quantity that was not read from a text.
    pub fn name(text: impl Into<String>) -> Expr {
        Expr::Name(Name { text: text.into(), span: Span::default() })
    }

    /// `left = right`.
    pub fn equation(left: Expr, right: Expr) -> Expr {
        Expr::Relation(Box::new(left), Relation::Equal, Box::new(right))
    }

    /// A function applied to an argument.
    pub fn call(function: Function, argument: Expr) -> Expr {
        Expr::Call(function, Box::new(argument))
    }

    /// The angle of so many degrees.
    pub fn degrees(value: Expr) -> Expr {
        Expr::Degrees(Box::new(value))
    }

    /// Is it the number nought?
    pub fn is_zero(&self) -> bool {
        matches!(self, Expr::Number(value) if value.is_zero())
    }

    /// Is it the number one?
    pub fn is_one(&self) -> bool {
        matches!(self, Expr::Number(value) if value.is_one())
    }

    /// The expression with its sign changed; no double minus, and nought stays nought.
    pub fn negated(self) -> Expr {
        match self {
            Expr::Number(value) => Expr::Number(-value),
            Expr::Negative(inner) => *inner,
            other => Expr::Negative(Box::new(other)),
        }
    }

    /// The sum of the terms that are not nought.
    pub fn sum(terms: impl IntoIterator<Item = Expr>) -> Expr {
        let mut kept: Vec<Expr> = terms.into_iter().filter(|term| !term.is_zero()).collect();
        match kept.len() {
            0 => Expr::integer(0),
            1 => kept.remove(0),
            _ => Expr::Sum(kept),
        }
    }

    /// The product without factors one; nought if any factor is.
    pub fn product(factors: impl IntoIterator<Item = Expr>) -> Expr {
        let mut kept: Vec<Expr> = factors.into_iter().filter(|factor| !factor.is_one()).collect();
        if kept.iter().any(Expr::is_zero) {
            return Expr::integer(0);
        }
        match kept.len() {
            0 => Expr::integer(1),
            1 => kept.remove(0),
            _ => Expr::Product(kept),
        }
    }

    /// Numerator over denominator; over one it is the numerator.
    pub fn over(self, denominator: Expr) -> Expr {
        if denominator.is_one() || self.is_zero() {
            self
        } else {
            Expr::Quotient(Box::new(self), Box::new(denominator))
        }
    }

    /// A whole power; the first power is the base.
    pub fn to_the(self, exponent: i64) -> Expr {
        if exponent == 1 { self } else { Expr::Power(Box::new(self), Box::new(Expr::integer(exponent))) }
    }
}
