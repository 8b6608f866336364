//! A paper composed by hand, small enough to be checked by hand: numbers, vectors, and a 'show that'.

use carom::expr::{Angles, Expr, Relation, Text, read, read_markup};
use carom::paper::{Paper, PrintedAnswer, PrintedPart, PrintedQuestion, SchemeRow, WorkingLine};
use carom::unit::Unit::{self, Degree, MetrePerSecond};

pub fn paper() -> Paper {
    Paper {
        title: "Oblique impact of smooth spheres".into(),
        school: "Riverside Sixth Form".into(),
        date: "12 March 2027".into(),
        code: "KV7-3QX".into(),
        seed: Some(20270312),
        questions: vec![at_rest(), components(), show_that()],
        ..Paper::default()
    }
}

/// A (3 kg) at 6 m/s and 30° strikes B (2 kg) at rest, e = 1/2.
fn at_rest() -> PrintedQuestion {
    let implied = Expr::Relation(
        Box::new(formula("tan(theta) = 5*sqrt(3)/6")),
        Relation::Implies,
        Box::new(about("theta", Expr::degrees(decimal("55.3")))),
    );
    PrintedQuestion {
        number: 1,
        id: "rest/speeds-and-directions".into(),
        mirrors: Some("5C-2".into()),
        stem: read_markup(
            "A smooth uniform sphere *A*, of mass {3 kg}, is moving on a smooth horizontal plane when it collides with a \
             smooth uniform sphere *B*, of mass {2 kg} and the same radius, which is at rest.\n\n\
             Immediately before the collision, *A* is moving with speed {6 m/s} in a direction which makes an angle of \
             {30 deg} with the line of centres. The coefficient of restitution between the spheres is {1/2}.",
        )
        .unwrap(),
        diagrams: Vec::new(),
        solution_diagrams: Vec::new(),
        parts: vec![PrintedPart {
            label: String::new(),
            ask: words("Find the speed and the direction of motion of *A*, and the speed of *B*, immediately after the collision."),
            answers: vec![
                answer("speed of *A*", "3*sqrt(37)/5", "3.65", MetrePerSecond, ""),
                answer("direction of *A*", "atan(5*sqrt(3)/6)", "55.3", Degree, "to the line of centres"),
                answer("speed of *B*", "27*sqrt(3)/10", "4.68", MetrePerSecond, "along the line of centres"),
            ],
            solution_diagrams: Vec::new(),
            working: vec![
                line("Perpendicular to the line of centres the velocity of *A* does not change:", ["6*sin(30) = 3"], None),
                line("Conservation of momentum along the line of centres:", ["3*6*cos(30) = 3*v + 2*w"], Some(1)),
                line("Newton’s law of restitution along the line of centres:", ["w - v = 1/2*6*cos(30)"], Some(2)),
                line("Solving (1) and (2):", ["v = 6*sqrt(3)/5", "w = 27*sqrt(3)/10"], None),
                WorkingLine {
                    words: words("The speed of *A*:"),
                    equations: vec![
                        formula("v_A = sqrt((6*sqrt(3)/5)^2 + 3^2)"),
                        formula("v_A = 3*sqrt(37)/5"),
                        about("v_A", decimal("3.65")),
                    ],
                    label: None,
                },
                WorkingLine {
                    words: words("The angle that it makes with the line of centres:"),
                    equations: vec![implied],
                    label: None,
                },
            ],
            scheme: vec![
                mark("B1", "component of *A* perpendicular to the line of centres unchanged", "", "seen anywhere, also in a diagram"),
                mark("M1", "conservation of momentum along the line of centres", "", "all terms; condone signs and sine for cosine"),
                mark("A1", "", "3*6*cos(30) = 3*v + 2*w", "unsimplified, or with a common factor"),
                mark("M1", "law of restitution along the line of centres", "", "*e* with the speed of approach"),
                mark("A1", "", "w - v = 1/2*6*cos(30)", "signs as in the equation of momentum"),
                mark("dM1", "solves for both", "", "depends on both M marks"),
                mark("A1", "", "v = 6*sqrt(3)/5", "awrt 2.08"),
                mark("A1", "", "w = 27*sqrt(3)/10", "awrt 4.68"),
                mark("M1", "Pythagoras or inverse tangent with their components", "", "both components present"),
                mark("A1", "speed of *A*", "3*sqrt(37)/5", "awrt 3.65"),
                mark("A1", "awrt {55.3 deg} to the line of centres", "", "{34.7 deg} only with ‘to the common tangent’"),
            ],
        }],
    }
}

/// A (2 kg) at 3i + 2j, B (3 kg) at -2i + j, line of centres parallel to i, e = 1/2.
fn components() -> PrintedQuestion {
    PrintedQuestion {
        number: 2,
        id: "components/velocities".into(),
        mirrors: None,
        stem: read_markup(
            "_[In this question {i} and {j} are perpendicular unit vectors in a horizontal plane.]_\n\n\
             Two smooth uniform spheres *A* and *B* of equal radii have masses {2 kg} and {3 kg}. Immediately before they \
             collide, *A* has velocity {[3, 2] m/s} and *B* has velocity {[-2, 1] m/s}. The line joining their centres is \
             then parallel to {i} and the coefficient of restitution is {1/2}.",
        )
        .unwrap(),
        diagrams: Vec::new(),
        solution_diagrams: Vec::new(),
        parts: vec![
            PrintedPart {
                label: "a".into(),
                ask: words("Find the velocity of each sphere immediately after the collision."),
                answers: vec![
                    answer("velocity of *A*", "[-3/2, 2]", "", MetrePerSecond, ""),
                    answer("velocity of *B*", "[1, 1]", "", MetrePerSecond, ""),
                ],
                solution_diagrams: Vec::new(),
                working: vec![
                    line(
                        "The components along {j} do not change. Conservation of momentum along {i}:",
                        ["2*3 - 3*2 = 2*v + 3*w"],
                        Some(1),
                    ),
                    line("Newton’s law of restitution along {i}:", ["w - v = 1/2*(3 + 2)"], Some(2)),
                    line("Solving (1) and (2):", ["v = -3/2", "w = 1"], None),
                ],
                scheme: vec![
                    mark("B1", "components along {j} unchanged", "", ""),
                    mark("M1", "conservation of momentum along {i}", "2*3 - 3*2 = 2*v + 3*w", "condone signs"),
                    mark("A1", "velocity of *A*", "[-3/2, 2]", ""),
                    mark("A1", "velocity of *B*", "[1, 1]", ""),
                ],
            },
            PrintedPart {
                label: "b".into(),
                ask: words(
                    "Find, to the nearest degree, the angle through which the direction of motion of *A* is deflected by \
                     the collision.",
                ),
                answers: vec![answer("angle of deflection of *A*", "acos(-1/(5*sqrt(13)))", "93", Degree, "")],
                solution_diagrams: Vec::new(),
                working: vec![line(
                    "By the scalar product:",
                    ["cos(theta) = (3*(-3/2) + 2*2)/(sqrt(13)*5/2)", "cos(theta) = -1/(5*sqrt(13))"],
                    None,
                )],
                scheme: vec![
                    mark("M1", "scalar product, or difference of two inverse tangents", "", ""),
                    mark("A1ft", "correct unsimplified", "", "from their velocity of *A*"),
                    mark("A1", "{93 deg}", "", "cao"),
                ],
            },
        ],
    }
}

/// m at u and alpha strikes 2m at rest; tan beta = 3 tan alpha / (1 - 2e).
fn show_that() -> PrintedQuestion {
    PrintedQuestion {
        number: 3,
        id: "rest/show-tangent".into(),
        mirrors: None,
        stem: read_markup(
            "A smooth sphere of mass {m} is moving with speed {u} when it collides with a smooth sphere of mass {2*m} and \
             the same radius, which is at rest. Its direction of motion makes the acute angle *alpha* with the line of \
             centres before the collision, and *beta* after it. The coefficient of restitution is {e}, where {e < 1/2}.",
        )
        .unwrap(),
        diagrams: Vec::new(),
        solution_diagrams: Vec::new(),
        parts: vec![PrintedPart {
            label: String::new(),
            ask: words("Show that {display: tan(beta) = 3*tan(alpha)/(1 - 2*e)}"),
            answers: Vec::new(),
            solution_diagrams: Vec::new(),
            working: vec![
                line(
                    "Momentum along the line of centres, and restitution, without the speed of the second sphere:",
                    ["v = u*cos(alpha)*(1 - 2*e)/3"],
                    Some(1),
                ),
                line(
                    "Hence, with (1):",
                    ["tan(beta) = u*sin(alpha)/v", "tan(beta) = 3*tan(alpha)/(1 - 2*e)"],
                    None,
                ),
            ],
            scheme: vec![
                mark("M1", "eliminates the speed of the second sphere", "", ""),
                mark("A1*", "printed result", "tan(beta) = 3*tan(alpha)/(1 - 2*e)", "no slips; *v* or its equivalent visible"),
            ],
        }],
    }
}

fn formula(text: &str) -> Expr {
    read(text, Angles::Degrees).unwrap()
}

fn decimal(digits: &str) -> Expr {
    Expr::Decimal(digits.into())
}

fn about(name: &str, rounded: Expr) -> Expr {
    Expr::Relation(Box::new(Expr::name(name)), Relation::Approximately, Box::new(rounded))
}

/// One paragraph, or nothing.
fn words(text: &str) -> Text {
    read_markup(text).unwrap().into_iter().next().unwrap_or_default()
}

fn answer(name: &str, exact: &str, rounded: &str, unit: Unit, phrase: &str) -> PrintedAnswer {
    PrintedAnswer {
        name: words(name),
        exact: Some(formula(exact)),
        rounded: Some(decimal(rounded)).filter(|_| !rounded.is_empty()),
        asks_exact: unit == MetrePerSecond,
        unit,
        phrase: words(phrase),
    }
}

fn line<const N: usize>(before: &str, equations: [&str; N], label: Option<u32>) -> WorkingLine {
    WorkingLine { words: words(before), equations: equations.map(formula).to_vec(), label }
}

fn mark(code: &str, earned: &str, equation: &str, note: &str) -> SchemeRow {
    SchemeRow {
        id: code.into(),
        code: code.into(),
        earned: words(earned),
        equations: Some(equation).filter(|equation| !equation.is_empty()).map(formula).into_iter().collect(),
        unit: Unit::None,
        note: words(note),
        depends: Vec::new(),
    }
}
