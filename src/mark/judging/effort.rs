//! How much work the exact value of an answer would be, told before any of it is done.
//!
//! A tower of powers fits on one line and would take for ever to work out. So the size of every step is bounded from
//! the sizes of its parts: how many terms the normal form can have above and below the line, how many digits, how many
//! roots. What would be more work than any answer of an exam goes to a person.

use super::turns::{Turns, is_angle, is_halved};
use crate::expr::{Expr, Function};
use crate::mark::enclosure::enclose_roughly;

/// The most work that one exact value may be. A long answer of an exam takes some hundreds.
pub(super) const MOST_EFFORT: u64 = 20_000;

/// The longest number in an exact calculation, in bits: about 300 figures.
const LONGEST_NUMBER: u64 = 1_000;

/// The numbers in the tangent of an angle that is one of degrees are no longer than that, in bits.
const SHORT: u64 = 24;

/// The most different roots, sines and the like; each doubles the number of terms.
const MOST_ROOTS: usize = 12;

/// What working out an expression takes; `None` if it is more than [`MOST_EFFORT`].
pub(super) fn effort(expr: &Expr) -> Option<u64> {
    Work { done: 0, letters: Letters::Kept }.of(expr)
}

/// What it takes where short fractions stand in the place of its letters, and of the tangents of its angles.
pub(super) fn effort_at_point(expr: &Expr) -> Option<u64> {
    Work { done: 0, letters: Letters::Fractions }.of(expr)
}

/// What becomes of letters.
#[derive(Clone, Copy, PartialEq)]
enum Letters {
    Kept,
    Fractions,
}

/// The length of a fraction that stands in the place of a letter, or of the tangent of an angle, in bits.
const POINT: u64 = 30;

/// A root that can meet itself in a product, where what is under it takes its place.
#[derive(Clone, PartialEq)]
struct Root {
    /// What it is the root of, as text; of a sine and a cosine the angle.
    of: String,
    /// Is there more under it than a number?
    nested: bool,
    above: u64,
    below: u64,
    degree: u64,
    bits: u64,
}

/// Bounds for a normal form.
#[derive(Clone)]
struct Size {
    /// Terms above the line.
    above: u64,
    /// Terms below; one for a number.
    below: u64,
    /// The highest power of any product of letters, above or below.
    degree: u64,
    /// The length of its numbers.
    bits: u64,
    letters: Vec<String>,
    roots: Vec<Root>,
}

impl Size {
    fn number(bits: u64) -> Size {
        Size { above: 1, below: 1, degree: 0, bits, letters: Vec::new(), roots: Vec::new() }
    }

    /// No more terms than there are products of the letters and roots.
    fn capped(mut self) -> Size {
        let products = choose(self.degree + self.letters.len() as u64, self.letters.len() as u64);
        self.below = self.below.min(products);
        self.above = self.above.min(products.saturating_mul(1 << self.roots.len().min(MOST_ROOTS)));
        self
    }

    /// What is under a root has taken its place.
    fn with_square(mut self, root: &Root) -> Size {
        self.above = self.above.saturating_mul(root.above);
        self.below = self.below.saturating_mul(root.below);
        self.degree += root.degree;
        self.bits += root.bits;
        self
    }

    fn joined<T: Clone + PartialEq>(one: &[T], two: &[T]) -> Vec<T> {
        let more = two.iter().filter(|item| !one.contains(item));
        one.iter().chain(more).cloned().collect()
    }
}

/// How many ways to choose so many of `n`, or more than matters.
fn choose(n: u64, count: u64) -> u64 {
    (0..count).fold(1_u64, |ways, at| ways.saturating_mul(n - at) / (at + 1)).max(1)
}

struct Work {
    done: u64,
    letters: Letters,
}

impl Work {
    fn of(mut self, expr: &Expr) -> Option<u64> {
        let size = self.size(expr)?;
        self.decision(size)?;
        Some(self.done)
    }

    /// Whether it is nought: a sum with a nested root is squared until none is left, `a + b√r` to `a² - b²r`.
    fn decision(&mut self, mut rest: Size) -> Option<()> {
        while rest.above > 1
            && let Some(at) = rest.roots.iter().rposition(|root| root.nested)
        {
            let root = rest.roots.remove(at);
            rest = self.product(rest.clone(), rest)?.with_square(&root);
        }
        Some(())
    }

    fn letter(&self, name: &str) -> Size {
        match self.letters {
            Letters::Kept => Size { degree: 1, letters: vec![name.to_owned()], ..Size::number(1) },
            Letters::Fractions => Size::number(POINT),
        }
    }

    /// A sine or cosine of a letter: its tangent is a letter and its cosine a root, or both are fractions.
    fn wave(&self, angle: &Expr) -> Size {
        let of = format!("{angle:?}");
        match self.letters {
            Letters::Fractions if matches!(angle, Expr::Name(_)) => Size::number(POINT),
            Letters::Fractions => {
                let root = Root { of, nested: false, above: 1, below: 1, degree: 0, bits: 2 * POINT };
                Size { roots: vec![root], ..Size::number(POINT) }
            }
            Letters::Kept => {
                let letter = self.letter(&of);
                let root = Root { of, nested: false, above: 1, below: 2, degree: 2, bits: 1 };
                Size { roots: vec![root], ..letter }
            }
        }
    }

    fn spend(&mut self, steps: u64) -> Option<()> {
        self.done = self.done.saturating_add(steps);
        (self.done <= MOST_EFFORT).then_some(())
    }

    /// The work of a step whose result is so large, and whose terms are so many before they are collected.
    fn step(&mut self, size: Size, terms: u64) -> Option<Size> {
        if size.bits > LONGEST_NUMBER || size.roots.len() > MOST_ROOTS {
            return None;
        }
        let words = 1 + size.bits / 64;
        self.spend(terms.saturating_mul(words * words))?;
        // What is above and below is freed of common factors.
        if size.below > 1 {
            let letters = size.letters.len() as u64;
            self.spend((size.above.saturating_add(size.below)).saturating_mul(letters * (size.degree + 1)))?;
        }
        Some(size.capped())
    }

    fn size(&mut self, expr: &Expr) -> Option<Size> {
        self.spend(1)?;
        match expr {
            Expr::Number(number) => {
                use dashu_int::ops::BitTest;
                Some(Size::number((number.numerator().bit_len() + number.denominator().bit_len()) as u64))
            }
            Expr::Decimal(text) => Some(Size::number(7 * text.len() as u64)),
            Expr::Name(name) => Some(self.letter(&name.text)),
            Expr::Pi => Some(Size::number(8)),
            Expr::Degrees(inner) | Expr::Negative(inner) => self.size(inner),
            Expr::Sum(parts) | Expr::Product(parts) => {
                let join = if matches!(expr, Expr::Sum(_)) { Work::sum } else { Work::product };
                let size = self.all(parts, join)?;
                // Angles are added by their tangents.
                if is_angle(expr) { self.added_up(expr) } else { Some(size) }
            }
            Expr::Quotient(above, below) => {
                let (above, below) = (self.size(above)?, self.size(below)?);
                let below = self.reciprocal(below)?;
                self.product(above, below)
            }
            Expr::Power(base, exponent) => self.power(base, exponent),
            Expr::Call(function, argument) => self.call(*function, argument),
            Expr::Vector(x, y) | Expr::Relation(x, _, y) => {
                let (x, y) = (self.size(x)?, self.size(y)?);
                self.sum(x, y)
            }
        }
    }

    fn all(&mut self, parts: &[Expr], join: fn(&mut Work, Size, Size) -> Option<Size>) -> Option<Size> {
        let mut whole: Option<Size> = None;
        for part in parts {
            let next = self.size(part)?;
            whole = Some(match whole {
                None => next,
                Some(whole) => join(self, whole, next)?,
            });
        }
        Some(whole.unwrap_or(Size::number(1)))
    }

    fn sum(&mut self, one: Size, two: Size) -> Option<Size> {
        let apart = one.below > 1 || two.below > 1;
        let (left, right) = if apart { (two.below, one.below) } else { (1, 1) };
        let above = one.above.saturating_mul(left).saturating_add(two.above.saturating_mul(right));
        let size = Size {
            above,
            below: one.below.saturating_mul(two.below),
            degree: if apart { one.degree + two.degree } else { one.degree.max(two.degree) },
            bits: one.bits + two.bits + 1,
            letters: Size::joined(&one.letters, &two.letters),
            roots: Size::joined(&one.roots, &two.roots),
        };
        self.step(size, above)
    }

    fn product(&mut self, one: Size, two: Size) -> Option<Size> {
        let mut above = one.above.saturating_mul(two.above);
        let mut below = one.below.saturating_mul(two.below);
        let (mut degree, mut bits) = (one.degree + two.degree, one.bits + two.bits);
        let terms = above.saturating_add(below);
        for root in one.roots.iter().filter(|root| two.roots.contains(root)) {
            above = above.saturating_mul(root.above);
            below = below.saturating_mul(root.below);
            degree += root.degree;
            bits += root.bits;
        }
        bits += 64 - above.min(1 << 20).leading_zeros() as u64;
        let letters = Size::joined(&one.letters, &two.letters);
        let roots = Size::joined(&one.roots, &two.roots);
        self.step(Size { above, below, degree, bits, letters, roots }, terms)
    }

    /// One root after another is multiplied away from below the line.
    fn reciprocal(&mut self, size: Size) -> Option<Size> {
        let mut factor = Size { below: 1, ..Size::number(1) };
        let mut rest = size;
        while let Some(root) = rest.roots.pop() {
            let with = Size { roots: [rest.roots.clone(), vec![root.clone()]].concat(), ..rest.clone() };
            factor = self.product(factor, with.clone())?;
            if rest.above > 1 {
                rest = self.product(rest.clone(), rest)?;
            }
            rest = rest.with_square(&root);
        }
        (rest.above, rest.below) = (rest.below, rest.above);
        self.product(factor, rest)
    }

    fn power(&mut self, base: &Expr, exponent: &Expr) -> Option<Size> {
        let (count, inverse) = match exponent {
            Expr::Negative(inner) => (&**inner, true),
            other => (other, false),
        };
        let (count, half) = match count {
            Expr::Number(number) => number.as_small().map(|(above, below)| (above.abs(), below != 1)),
            // An exponent that must be worked out: a fraction such as 1/2, or more than is read.
            other => {
                self.size(other)?;
                Some((1, true))
            }
        }?;
        let mut size = self.size(base)?;
        // The square of a root is what is under it.
        if let (Expr::Call(Function::Sqrt, under), 2, false, false) = (base, count, half, inverse) {
            return self.size(under);
        }
        if half {
            size = self.root(base, size)?;
        }
        let one = size.clone();
        for _ in 1..count {
            size = self.product(size, one.clone())?;
        }
        if inverse { self.reciprocal(size) } else { Some(size) }
    }

    fn root(&mut self, under: &Expr, size: Size) -> Option<Size> {
        // Squares are looked for, among the factors of its numbers too.
        self.spend(match size.bits {
            0..=40 => 10,
            41..=64 => 500,
            _ => 5_000,
        })?;
        let terms = size.above.saturating_add(size.below);
        self.spend(terms.saturating_mul(terms).saturating_mul(1 + size.letters.len() as u64))?;
        let Size { above, below, degree, bits, letters, mut roots } = size;
        let nested = degree > 0 || above > 1;
        roots.push(Root { of: format!("{under:?}"), nested, above, below, degree, bits });
        self.step(Size { above: 1, below, degree, bits, letters, roots }, 1)
    }

    fn call(&mut self, function: Function, argument: &Expr) -> Option<Size> {
        let inner = self.size(argument)?;
        match function {
            Function::Abs => Some(inner),
            Function::Sqrt => self.root(argument, inner),
            Function::Asin | Function::Acos | Function::Atan => {
                let square = self.product(inner.clone(), inner.clone())?;
                let other = self.root(argument, square)?;
                self.product(inner, other)
            }
            Function::Sin | Function::Cos => self.turned(argument, false),
            Function::Tan => self.turned(argument, true),
        }
    }

    /// The sine and cosine, or the tangent, of a sum of angles: added one after another.
    fn turned(&mut self, argument: &Expr, tangent: bool) -> Option<Size> {
        let mut turns = Turns::default();
        turns.count(argument, 1);
        self.of_turns(turns, tangent)
    }

    /// A sum of angles: degrees are added up by themselves.
    fn added_up(&mut self, sum: &Expr) -> Option<Size> {
        let mut turns = Turns::default();
        turns.count(sum, 1);
        let mut open = Vec::new();
        for (angle, times) in turns.angles {
            if !self.is_of_degrees(angle)? {
                open.push((angle, times));
            }
        }
        self.of_turns(Turns { angles: open }, true)
    }

    /// Is it a number of degrees, as `30°` is, or `arctan √3`, or too near to one to be anything else?
    fn is_of_degrees(&mut self, angle: &Expr) -> Option<bool> {
        Some(match angle {
            Expr::Degrees(inner) => inner.names().is_empty(),
            Expr::Number(_) | Expr::Decimal(_) | Expr::Pi => true,
            Expr::Call(_, argument) if angle.names().is_empty() => {
                let is_short = self.size(argument)?.bits <= SHORT;
                let halves = enclose_roughly(angle, &[], 0).map(|radians| 2.0 * radians.upper.to_degrees());
                is_short && halves.is_some_and(|halves| (halves - halves.round()).abs() < 1e-9)
            }
            _ => false,
        })
    }

    fn of_turns(&mut self, turns: Turns, tangent: bool) -> Option<Size> {
        // Halves of angles are roots in roots, unless a fraction stands for the angle.
        if self.letters == Letters::Kept && turns.angles.iter().any(|(angle, _)| is_halved(angle)) {
            return None;
        }
        let mut whole: Option<Size> = None;
        for (angle, times) in turns.angles {
            let one = match angle {
                Expr::Call(Function::Atan, of) if tangent => self.size(of)?,
                Expr::Call(..) => self.size(angle)?,
                _ if tangent => self.letter(&format!("{angle:?}")),
                _ => self.wave(angle),
            };
            for _ in 0..times {
                whole = Some(match whole {
                    None => one.clone(),
                    Some(whole) => self.added(whole, one.clone(), tangent)?,
                });
            }
        }
        Some(whole.unwrap_or(Size::number(4)))
    }

    /// sin(a + b) from sin a and sin b, tan(a + b) from tan a and tan b.
    fn added(&mut self, one: Size, two: Size, tangent: bool) -> Option<Size> {
        let product = self.product(one.clone(), two.clone())?;
        if !tangent {
            return self.sum(product.clone(), product);
        }
        let above = self.sum(one, two)?;
        let below = self.sum(Size::number(1), product)?;
        let below = self.reciprocal(below)?;
        self.product(above, below)
    }
}
