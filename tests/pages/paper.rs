//! A paper composed by hand, small enough to be checked by hand: numbers, vectors, and a 'show that'.

use carom::expr::{Expr, Function, Piece, Relation, Text};
use carom::number::Fraction;
use carom::paper::{Paper, PrintedAnswer, PrintedPart, PrintedQuestion, SchemeRow, WorkingLine};
use carom::unit::Unit::{self, Degree, Kilogram, MetrePerSecond};

pub fn paper() -> Paper {
    Paper {
        title: "Oblique impact of smooth spheres".into(),
        school: "Riverside Sixth Form".into(),
        date: "12 March 2027".into(),
        seed: Some(20270312),
        questions: vec![at_rest(), components(), show_that()],
    }
}

/// A (3 kg) at 6 m/s and 30° strikes B (2 kg) at rest, e = 1/2.
fn at_rest() -> PrintedQuestion {
    let root3 = || call(Function::Sqrt, n(3));
    let v = || n(6).times(root3()).over(n(5));
    let w = || n(27).times(root3()).over(n(10));
    let cos30 = || call(Function::Cos, Expr::degrees(n(30)));
    let momentum = || equal(product([n(3), n(6), cos30()]), Expr::sum([n(3).times(name("v")), n(2).times(name("w"))]));
    let restitution = || equal(Expr::sum([name("w"), name("v").negated()]), product([half(), n(6), cos30()]));
    PrintedQuestion {
        number: 1,
        id: "rest/speeds-and-directions".into(),
        mirrors: Some("5C-2".into()),
        stem: vec![
            text([
                w_("A smooth uniform sphere "),
                f(name("A")),
                w_(", of mass "),
                q(n(3), Kilogram),
                w_(", is moving on a smooth horizontal plane when it collides with a smooth uniform sphere "),
                f(name("B")),
                w_(", of mass "),
                q(n(2), Kilogram),
                w_(" and the same radius, which is at rest."),
            ]),
            text([
                w_("Immediately before the collision, "),
                f(name("A")),
                w_(" is moving with speed "),
                q(n(6), MetrePerSecond),
                w_(" in a direction which makes an angle of "),
                f(Expr::degrees(n(30))),
                w_(" with the line of centres. The coefficient of restitution between the spheres is "),
                f(half()),
                w_("."),
            ]),
        ],
        parts: vec![PrintedPart {
            label: String::new(),
            ask: text([
                w_("Find the speed and the direction of motion of "),
                f(name("A")),
                w_(", and the speed of "),
                f(name("B")),
                w_(", immediately after the collision."),
            ]),
            answers: vec![
                answer(
                    "speed of ",
                    "A",
                    n(3).times(call(Function::Sqrt, n(37))).over(n(5)),
                    "3.65",
                    MetrePerSecond,
                    "",
                ),
                answer(
                    "direction of ",
                    "A",
                    call(Function::Atan, n(5).times(root3()).over(n(6))),
                    "55.3",
                    Degree,
                    "to the line of centres",
                ),
                answer("speed of ", "B", w(), "4.68", MetrePerSecond, "along the line of centres"),
            ],
            working: vec![
                line(
                    "Perpendicular to the line of centres the velocity of A does not change:",
                    [equal(n(6).times(call(Function::Sin, Expr::degrees(n(30)))), n(3))],
                    None,
                ),
                line("Conservation of momentum along the line of centres:", [momentum()], Some(1)),
                line("Newton’s law of restitution along the line of centres:", [restitution()], Some(2)),
                line("Solving (1) and (2):", [equal(name("v"), v()), equal(name("w"), w())], None),
                line(
                    "The speed of A:",
                    [
                        equal(name("v_A"), call(Function::Sqrt, Expr::sum([v().to_the(2), n(3).to_the(2)]))),
                        equal(name("v_A"), n(3).times(call(Function::Sqrt, n(37))).over(n(5))),
                        relation(name("v_A"), Relation::Approximately, decimal("3.65")),
                    ],
                    None,
                ),
                line(
                    "The angle that it makes with the line of centres:",
                    [relation(
                        equal(call(Function::Tan, name("theta")), n(3).over(v())),
                        Relation::Implies,
                        relation(name("theta"), Relation::Approximately, Expr::degrees(decimal("55.3"))),
                    )],
                    None,
                ),
            ],
            scheme: vec![
                mark(
                    "B1",
                    "component of A perpendicular to the line of centres unchanged",
                    None,
                    "seen anywhere, also in a diagram",
                ),
                mark(
                    "M1",
                    "conservation of momentum along the line of centres",
                    None,
                    "all terms; condone signs and sine for cosine",
                ),
                mark("A1", "", Some(momentum()), "unsimplified, or with a common factor"),
                mark("M1", "law of restitution along the line of centres", None, "e with the speed of approach"),
                mark("A1", "", Some(restitution()), "signs as in the equation of momentum"),
                mark("dM1", "solves for both", None, "depends on both M marks"),
                mark("A1", "", Some(equal(name("v"), v())), "awrt 2.08"),
                mark("A1", "", Some(equal(name("w"), w())), "awrt 4.68"),
                mark("M1", "Pythagoras or inverse tangent with their components", None, "both components present"),
                mark("A1", "speed of A", Some(n(3).times(call(Function::Sqrt, n(37))).over(n(5))), "awrt 3.65"),
                mark(
                    "A1",
                    "direction of A",
                    Some(Expr::degrees(decimal("55.3"))),
                    "34.7° only with ‘to the common tangent’",
                ),
            ],
        }],
    }
}

/// A (2 kg) at 3i + 2j, B (3 kg) at -2i + j, line of centres parallel to i, e = 1/2.
fn components() -> PrintedQuestion {
    let a_after = || Expr::Vector(Box::new(fraction(-3, 2)), Box::new(n(2)));
    let b_after = || Expr::Vector(Box::new(n(1)), Box::new(n(1)));
    let momentum = || {
        equal(
            Expr::sum([n(2).times(n(3)), n(3).times(n(2)).negated()]),
            Expr::sum([n(2).times(name("v")), n(3).times(name("w"))]),
        )
    };
    PrintedQuestion {
        number: 2,
        id: "components/velocities".into(),
        mirrors: None,
        stem: vec![
            Text(vec![Piece::Italic(vec![
                w_("[In this question "),
                f(name("i")),
                w_(" and "),
                f(name("j")),
                w_(" are perpendicular unit vectors in a horizontal plane.]"),
            ])]),
            text([
                w_("Two smooth uniform spheres "),
                f(name("A")),
                w_(" and "),
                f(name("B")),
                w_(" of equal radii have masses "),
                q(n(2), Kilogram),
                w_(" and "),
                q(n(3), Kilogram),
                w_(". Immediately before they collide, "),
                f(name("A")),
                w_(" has velocity "),
                q(Expr::Vector(Box::new(n(3)), Box::new(n(2))), MetrePerSecond),
                w_(" and "),
                f(name("B")),
                w_(" has velocity "),
                q(Expr::Vector(Box::new(n(-2)), Box::new(n(1))), MetrePerSecond),
                w_(". The line joining their centres is then parallel to "),
                f(name("i")),
                w_(" and the coefficient of restitution is "),
                f(half()),
                w_("."),
            ]),
        ],
        parts: vec![
            PrintedPart {
                label: "a".into(),
                ask: Text::words("Find the velocity of each sphere immediately after the collision."),
                answers: vec![
                    exact_answer("velocity of ", "A", a_after(), MetrePerSecond),
                    exact_answer("velocity of ", "B", b_after(), MetrePerSecond),
                ],
                working: vec![
                    line(
                        "The components along j do not change. Conservation of momentum along i:",
                        [momentum()],
                        Some(1),
                    ),
                    line(
                        "Newton’s law of restitution along i:",
                        [equal(Expr::sum([name("w"), name("v").negated()]), half().times(Expr::sum([n(3), n(2)])))],
                        Some(2),
                    ),
                    line("Solving (1) and (2):", [equal(name("v"), fraction(-3, 2)), equal(name("w"), n(1))], None),
                ],
                scheme: vec![
                    mark("B1", "components along j unchanged", None, ""),
                    mark("M1", "conservation of momentum along i", Some(momentum()), "condone signs"),
                    mark("A1", "velocity of A", Some(a_after()), ""),
                    mark("A1", "velocity of B", Some(b_after()), ""),
                ],
            },
            PrintedPart {
                label: "b".into(),
                ask: text([
                    w_("Find, to the nearest degree, the angle through which the direction of motion of "),
                    f(name("A")),
                    w_(" is deflected by the collision."),
                ]),
                answers: vec![answer(
                    "angle of deflection of ",
                    "A",
                    call(Function::Acos, n(1).over(n(5).times(call(Function::Sqrt, n(13)))).negated()),
                    "93",
                    Degree,
                    "",
                )],
                working: vec![line(
                    "By the scalar product:",
                    [equal(
                        call(Function::Cos, name("theta")),
                        Expr::sum([n(3).times(fraction(-3, 2)), n(2).times(n(2))])
                            .over(call(Function::Sqrt, n(13)).times(fraction(5, 2))),
                    )],
                    None,
                )],
                scheme: vec![
                    mark("M1", "scalar product, or difference of two inverse tangents", None, ""),
                    mark("A1ft", "correct unsimplified", None, "from their velocity of A"),
                    mark("A1", "93°", None, "cao"),
                ],
            },
        ],
    }
}

/// m at u and alpha strikes 2m at rest; tan beta = 3 tan alpha / (1 - 2e).
fn show_that() -> PrintedQuestion {
    let tan = |letter: &str| call(Function::Tan, name(letter));
    let one_less_2e = || Expr::sum([n(1), n(2).times(name("e")).negated()]);
    let result = || equal(tan("beta"), n(3).times(tan("alpha")).over(one_less_2e()));
    let u_cos = || name("u").times(call(Function::Cos, name("alpha")));
    PrintedQuestion {
        number: 3,
        id: "rest/show-tangent".into(),
        mirrors: None,
        stem: vec![text([
            w_("A smooth sphere of mass "),
            f(name("m")),
            w_(" is moving with speed "),
            f(name("u")),
            w_(" when it collides with a smooth sphere of mass "),
            f(n(2).times(name("m"))),
            w_(" and the same radius, which is at rest. Its direction of motion makes the acute angle "),
            f(name("alpha")),
            w_(" with the line of centres before the collision, and "),
            f(name("beta")),
            w_(" after it. The coefficient of restitution is "),
            f(name("e")),
            w_(", where "),
            f(relation(name("e"), Relation::Less, half())),
            w_("."),
        ])],
        parts: vec![PrintedPart {
            label: String::new(),
            ask: Text(vec![w_("Show that "), Piece::Display(result())]),
            answers: Vec::new(),
            working: vec![
                line(
                    "Momentum along the line of centres, and restitution, without the speed of the second sphere:",
                    [equal(name("v"), u_cos().times(one_less_2e()).over(n(3)))],
                    Some(1),
                ),
                line(
                    "Hence, with (1):",
                    [equal(tan("beta"), name("u").times(call(Function::Sin, name("alpha"))).over(name("v"))), result()],
                    None,
                ),
            ],
            scheme: vec![
                mark("M1", "eliminates the speed of the second sphere", None, ""),
                mark("A1*", "printed result", Some(result()), "no slips; v or its equivalent visible"),
            ],
        }],
    }
}

/// Products by hand, in the order written.
trait Times {
    fn times(self, other: Expr) -> Expr;
}

impl Times for Expr {
    fn times(self, other: Expr) -> Expr {
        Expr::Product(vec![self, other])
    }
}

fn n(value: i64) -> Expr {
    Expr::integer(value)
}

fn half() -> Expr {
    fraction(1, 2)
}

fn fraction(numerator: i64, denominator: i64) -> Expr {
    Expr::Number(Fraction::new(numerator, denominator))
}

fn decimal(digits: &str) -> Expr {
    Expr::Decimal(digits.into())
}

fn name(letter: &str) -> Expr {
    Expr::name(letter)
}

fn product(factors: impl IntoIterator<Item = Expr>) -> Expr {
    Expr::Product(factors.into_iter().collect())
}

fn call(function: Function, argument: Expr) -> Expr {
    Expr::call(function, argument)
}

fn equal(left: Expr, right: Expr) -> Expr {
    Expr::equation(left, right)
}

fn relation(left: Expr, sign: Relation, right: Expr) -> Expr {
    Expr::Relation(Box::new(left), sign, Box::new(right))
}

fn text(pieces: impl IntoIterator<Item = Piece>) -> Text {
    Text(pieces.into_iter().collect())
}

fn w_(words: &str) -> Piece {
    Piece::Words(words.into())
}

fn f(formula: Expr) -> Piece {
    Piece::Formula(formula)
}

fn q(value: Expr, unit: Unit) -> Piece {
    Piece::Quantity(value, unit)
}

fn answer(what: &str, sphere: &str, exact: Expr, rounded: &str, unit: Unit, phrase: &str) -> PrintedAnswer {
    PrintedAnswer {
        rounded: Some(decimal(rounded)),
        phrase: if phrase.is_empty() { Text::default() } else { Text::words(phrase) },
        ..exact_answer(what, sphere, exact, unit)
    }
}

fn exact_answer(what: &str, sphere: &str, exact: Expr, unit: Unit) -> PrintedAnswer {
    PrintedAnswer { name: text([w_(what), f(name(sphere))]), exact, rounded: None, unit, phrase: Text::default() }
}

fn line(words: &str, equations: impl IntoIterator<Item = Expr>, label: Option<u32>) -> WorkingLine {
    WorkingLine { words: Text::words(words), equations: equations.into_iter().collect(), label }
}

fn mark(code: &str, earned: &str, equation: Option<Expr>, note: &str) -> SchemeRow {
    let words = |words: &str| if words.is_empty() { Text::default() } else { Text::words(words) };
    SchemeRow {
        id: format!("{code}-{earned}"),
        code: code.into(),
        earned: words(earned),
        equation,
        note: words(note),
        depends: Vec::new(),
    }
}
