//! Examples and laws of reading.

use super::*;
use crate::expr::print::{latex, mathml, plain, unicode};
use crate::expr::{Expr, Function, Relation};
use crate::number::Fraction;

#[test]
fn carom_knows_what_a_text_means() {
    let rows = [
        ("4i - j", "4*i - j"),
        ("2v", "2*v"),
        ("4(a+b)", "4*(a + b)"),
        ("(a+b)(a-b)", "(a + b)*(a - b)"),
        ("2 sqrt(3)", "2*sqrt(3)"),
        ("16√3/9", "16*sqrt(3)/9"),
        ("√(2+x)", "sqrt(2 + x)"),
        ("mu*m", "mu*m"),
        ("-2^2", "-2^2"),
        ("(-2)^2", "(-2)^2"),
        ("2^-1", "2^(-1)"),
        ("2**3", "2^3"),
        ("2^3^2", "2^(3^2)"),
        ("x²", "x^2"),
        ("a/b*c", "(a/b)*c"),
        ("a/b/c", "(a/b)/c"),
        ("a*b*c/d", "a*b*c/d"),
        ("a-b-c", "a - b - c"),
        ("a-(b-c)", "a - (b - c)"),
        ("--a", "-(-a)"),
        ("2*-3", "2*(-3)"),
        ("+3", "3"),
        ("1/2m", "(1/2)*m"),
        ("½m", "(1/2)*m"),
        ("2½", "5/2"),
        ("0.125", "1/8"),
        (".5", "1/2"),
        ("6sin(10 deg)", "6*sin(10*deg)"),
        ("10 deg", "10*deg"),
        ("10*deg", "10*deg"),
        ("10°", "10*deg"),
        ("deg", "deg"),
        ("alpha/deg", "alpha/deg"),
        ("atan(7)/deg", "atan(7)/deg"),
        ("4*10*deg", "4*(10*deg)"),
        ("x^2 deg", "(x^2)*deg"),
        ("cos alpha", "cos(alpha)"),
        ("u cos alpha i", "u*cos(alpha)*i"),
        ("sin2x", "sin(2*x)"),
        ("cos 30 deg", "cos(30*deg)"),
        ("sin alpha cos beta", "sin(alpha)*cos(beta)"),
        ("sin^2(x)", "sin(x)^2"),
        ("tan²θ", "tan(theta)^2"),
        ("tan^-1(7)", "atan(7)"),
        ("arctan(7)", "atan(7)"),
        ("sqrt3 i", "sqrt(3)*i"),
        ("[a, b]", "[a, b]"),
        ("(1/2, -3)", "[1/2, -3]"),
        ("[a+b]c", "(a + b)*c"),
        ("A.after.speed <= 2*v_1", "A.after.speed <= 2*v_1"),
        ("a == b", "a = b"),
        ("a≠b", "a != b"),
        ("α·μ_1 − π×2", "alpha*mu_1 - pi*2"),
        ("e2", "e2"),
        ("2e - 1", "2*e - 1"),
    ];
    for (text, expected) in rows {
        assert_eq!(read(text, Angles::Radians).map(|expr| plain(&expr)).as_deref(), Ok(expected), "{text}");
    }
}

#[test]
fn carom_knows_that_students_measure_in_degrees() {
    let rows = [
        ("6sin10", "6*sin(10*deg)"),
        ("6cos10i + 6sin10j", "6*cos(10*deg)*i + 6*sin(10*deg)*j"),
        ("sin(20/2)", "sin((20/2)*deg)"),
        ("cos(90 - theta)", "cos(90*deg - theta)"),
        ("cos(180 - 2*30)", "cos((180 - 2*30)*deg)"),
        ("sin(pi/6)", "sin(pi/6)"),
        ("sin(10 deg)", "sin(10*deg)"),
        ("sin(atan(7))", "sin(atan(7))"),
        ("sin(atan(7)/2)", "sin(atan(7)/2)"),
        ("tan(-30)", "tan(-30*deg)"),
        ("sin^-1(0.5)", "asin(1/2)"),
        ("cos alpha", "cos(alpha)"),
        ("cos²30", "cos(30*deg)^2"),
    ];
    for (text, expected) in rows {
        assert_eq!(read(text, Angles::Degrees).map(|expr| plain(&expr)).as_deref(), Ok(expected), "{text}");
    }
    assert_eq!(plain(&read("sin(10)", Angles::Radians).unwrap()), "sin(10)");
}

/// Text, message, what stands above the caret, label.
#[test]
fn what_is_nearly_right_is_told_as_it_is_meant() {
    let rows = [
        ("mA <> mB", "write `!=`"),
        ("a >< b", "write `!=`"),
        ("a =< b", "write `<=`"),
        ("a => b", "write `>=`"),
        ("a === b", "write `=`"),
        ("0,5", "write `0.5`"),
        ("u + 12,25*e", "write `12.25`"),
        ("1, 2", "write a vector as `[2, 3]` or `2i + 3j`"),
        ("1.5,2", "write a vector as `[2, 3]` or `2i + 3j`"),
    ];
    for (text, help) in rows {
        assert_eq!(read(text, Angles::Degrees).unwrap_err().help.as_deref(), Some(help), "{text}");
    }
}

#[test]
fn carom_knows_where_a_text_goes_wrong() {
    let rows = [
        ("", "an empty expression", ""),
        ("2*(u + ", "the expression ends too early", ""),
        ("2*(u + 1", "`(` is never closed", "("),
        ("(2]", "`]` closes `(`", "]"),
        ("2)", "unexpected `)`", ")"),
        ("sqrt()", "`sqrt` without its argument", "sqrt()"),
        ("2*( )", "nothing in the brackets", "( )"),
        ("1, 2", "unexpected `,`", ","),
        ("[1, 2, 3]", "a third component", ","),
        ("a = b = c", "a second relation", "="),
        ("(a = b)", "a relation in brackets", "="),
        ("= 3", "a relation without its left side", "="),
        ("a <> b", "two relations in a row", "<>"),
        ("a = < b", "two relations in a row", "= <"),
        ("0,5", "a decimal comma", "0,5"),
        ("2 $ 3", "unknown character `$`", "$"),
        ("2 3", "a number without a sign before it", "3"),
        ("sin", "`sin` without its argument", "sin"),
        ("2 + sin -30", "`sin` without its argument", "sin"),
        ("sin x^2", "a power after a function without brackets", "^"),
        ("2 * / 3", "a sign without its operand", "/"),
        ("é", "unknown character `é`", "é"),
    ];
    for (text, message, at) in rows {
        let fault = read(text, Angles::Degrees).unwrap_err();
        assert_eq!(fault.message, message, "{text}");
        assert_eq!(&text[fault.span.start..fault.span.end], at, "{text}");
        assert!(!fault.expected.is_empty());
    }
}

#[test]
fn carom_knows_names_by_their_places() {
    let expr = read("2u + v_A", Angles::Degrees).unwrap();
    let places: Vec<_> =
        expr.names().into_iter().map(|name| (&name.text[..], name.span.start, name.span.end)).collect();
    assert_eq!(places, [("u", 1, 2), ("v_A", 5, 8)]);
}

/// A small generator of repeatable pseudo-random numbers (Knuth's MMIX constants), enough for fuzzing.
struct Chance(u64);

impl Chance {
    fn below(&mut self, bound: usize) -> usize {
        self.0 = self.0.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        (self.0 >> 33) as usize % bound
    }
    fn tree(&mut self, depth: usize) -> Expr {
        let letters = ["u", "v_A", "alpha", "i", "j", "e", "A.after.speed", "k2"];
        let child = |chance: &mut Chance| chance.tree(depth - 1);
        match self.below(if depth == 0 { 4 } else { 14 }) {
            0 => Expr::integer(self.below(5) as i64 - 2),
            1 => Expr::Number(Fraction::new(self.below(9) as i64 - 4, 1 + self.below(4) as i64)),
            2 => Expr::name(letters[self.below(letters.len())]),
            3 => {
                if self.below(2) == 0 {
                    Expr::Pi
                } else {
                    Expr::degrees(Expr::integer(1))
                }
            }
            4 => Expr::degrees(child(self)),
            5 => Expr::Negative(Box::new(child(self))),
            6 | 7 => Expr::Sum((0..self.below(4)).map(|_| child(self)).collect()),
            8 | 9 => Expr::Product((0..self.below(4)).map(|_| child(self)).collect()),
            10 => Expr::Quotient(Box::new(child(self)), Box::new(child(self))),
            11 => Expr::Power(Box::new(child(self)), Box::new(child(self))),
            12 => Expr::call(Function::ALL[self.below(8)], child(self)),
            _ => Expr::Vector(Box::new(child(self)), Box::new(child(self))),
        }
    }
}

#[test]
fn carom_knows_that_what_it_prints_it_reads_as_the_same() {
    let mut chance = Chance(1);
    let mut compared = 0;
    for _ in 0..20_000 {
        let mut tree = chance.tree(4);
        if chance.below(8) == 0 {
            tree = Expr::Relation(Box::new(tree), Relation::LessOrEqual, Box::new(chance.tree(2)));
        }
        let printed = plain(&tree);
        let again = read(&printed, Angles::Radians).unwrap_or_else(|fault| panic!("{printed}: {fault:?}"));
        assert_eq!(plain(&again), printed, "{tree:?}");
        compared += usize::from(same_value(&tree, &again, &printed));
    }
    assert!(compared > 4_000, "{compared}");
}

/// Fails if two trees differ in value where all letters are numbers; says whether doubles could tell.
fn same_value(before: &Expr, after: &Expr, printed: &str) -> bool {
    let (Some(a), Some(b)) = (value(before), value(after)) else { return false };
    assert!((a - b).abs() <= 1e-6 * (1.0 + a.abs()), "{printed}: {a} became {b}");
    true
}

/// The value in doubles where it is of middling size at each node, so that rounding cannot decide.
fn value(expr: &Expr) -> Option<f64> {
    let size = match expr {
        Expr::Number(number) => number.to_f64(),
        Expr::Name(name) => 1.0 + name.text.len() as f64 / 7.0,
        Expr::Pi => std::f64::consts::PI,
        Expr::Degrees(inner) => value(inner)?.to_radians(),
        Expr::Negative(inner) => -value(inner)?,
        Expr::Sum(terms) => terms.iter().map(value).sum::<Option<f64>>()?,
        Expr::Product(factors) => factors.iter().map(value).product::<Option<f64>>()?,
        Expr::Quotient(a, b) => value(a)? / value(b)?,
        Expr::Power(a, b) => value(a)?.powf(value(b)?),
        Expr::Call(Function::Sqrt, inner) => value(inner)?.sqrt(),
        Expr::Call(Function::Abs, inner) => value(inner)?.abs(),
        Expr::Call(Function::Sin, inner) => value(inner).filter(|angle| angle.abs() < 100.0)?.sin(),
        Expr::Call(Function::Tan, inner) => value(inner).filter(|angle| angle.abs() < 100.0)?.tan(),
        // Trigonometry of large numbers magnifies rounding, and vectors have no value here.
        Expr::Call(..) | Expr::Decimal(_) | Expr::Vector(..) | Expr::Relation(..) => return None,
    };
    (1e-6..1e6).contains(&size.abs()).then_some(size)
}

#[test]
fn carom_knows_that_no_text_can_stop_it() {
    let pieces = [
        "(",
        ")",
        "[",
        "]",
        ",",
        "+",
        "-",
        "*",
        "/",
        "^",
        "**",
        "sin",
        "sqrt",
        "tan^-1",
        " ",
        "2",
        "0.5",
        ".",
        "x",
        "i",
        "A.after.speed",
        "deg",
        "°",
        "²",
        "√",
        "½",
        "=",
        "<=",
        "π",
        "θ",
        "_",
        "é",
        "\u{202e}",
        "\0",
        "🎱",
        "10",
    ];
    let mut chance = Chance(2);
    for _ in 0..60_000 {
        let text: String = (0..chance.below(14)).map(|_| pieces[chance.below(pieces.len())]).collect();
        for angles in [Angles::Radians, Angles::Degrees] {
            match read(&text, angles) {
                Ok(expr) => {
                    let printed = plain(&expr);
                    assert_eq!(
                        read(&printed, Angles::Radians).map(|again| plain(&again)).as_ref(),
                        Ok(&printed),
                        "{text}"
                    );
                    let _ = (latex(&expr), mathml(&expr), unicode(&expr));
                }
                Err(fault) => assert!(text.get(fault.span.start..fault.span.end).is_some(), "{text}: {fault:?}"),
            }
        }
    }
    for _ in 0..60_000 {
        let bytes: Vec<u8> = (0..chance.below(20)).map(|_| chance.below(256) as u8).collect();
        let text = String::from_utf8_lossy(&bytes);
        if let Err(fault) = read(&text, Angles::Degrees) {
            assert!(text.get(fault.span.start..fault.span.end).is_some(), "{text}: {fault:?}");
        }
    }
}

#[test]
fn carom_knows_that_formulas_have_a_bottom() {
    for piece in ["(", "-", "2^", "sin(", "√", "[1,", "a/", "((a/b", "2^-", "tan^(", "x^2^"] {
        let text = piece.repeat(1_900 / piece.len());
        assert!(read(&text, Angles::Degrees).is_err(), "{piece}");
        let ended = format!("{text}1");
        let fault = read(&ended, Angles::Degrees).unwrap_err();
        assert_eq!(fault.message, "the expression is nested too deeply", "{piece}");
    }
    let deep = format!("{}{}", "1", " deg".repeat(900));
    assert_eq!(read(&deep, Angles::Degrees).unwrap_err().message, "the expression is nested too deeply");
    let long = "1+".repeat(1_900) + "1";
    let printed = plain(&read(&long, Angles::Degrees).unwrap());
    assert_eq!(printed.len(), 1_901 + 3 * 1_900);
    assert!(read(&"1+".repeat(2_001), Angles::Degrees).unwrap_err().message.contains("4002 bytes"));
    assert!(read(&format!("{}1{}", "(".repeat(90), ")".repeat(90)), Angles::Degrees).is_ok());
}

impl Chance {
    /// A tree whose one-line form uses only characters that are read.
    fn printable(&mut self, depth: usize) -> Expr {
        let child = |chance: &mut Chance| chance.printable(depth - 1);
        match self.below(if depth == 0 { 3 } else { 12 }) {
            0 => Expr::integer(self.below(7) as i64 - 3),
            1 => Expr::Number(Fraction::new(self.below(9) as i64 - 4, 1 + self.below(4) as i64)),
            2 => Expr::name(["alpha", "theta", "mu", "lambda_1x"][self.below(4)]),
            3 => Expr::degrees(child(self)),
            4 => Expr::Negative(Box::new(child(self))),
            5 | 6 => Expr::Sum((0..self.below(4)).map(|_| child(self)).collect()),
            7 | 8 => Expr::Product((0..self.below(4)).map(|_| child(self)).collect()),
            9 => Expr::Quotient(Box::new(child(self)), Box::new(child(self))),
            10 => Expr::Power(Box::new(child(self)), Box::new(Expr::integer(2 + self.below(2) as i64))),
            _ => Expr::call([Function::Sqrt, Function::Sin, Function::Tan][self.below(3)], child(self)),
        }
    }
}

#[test]
fn carom_knows_that_a_formula_on_a_terminal_means_what_it_says() {
    let mut chance = Chance(3);
    let mut compared = 0;
    for _ in 0..20_000 {
        let tree = chance.printable(4);
        let printed = unicode(&tree);
        let again = read(&printed, Angles::Radians).unwrap_or_else(|fault| panic!("{printed}: {fault:?}"));
        compared += usize::from(same_value(&tree, &again, &printed));
    }
    assert!(compared > 4_000, "{compared}");
}
