//! Examples of printed formulas, one row each, in all four forms.

use super::*;
use crate::expr::{Expr, Function, Piece, Relation, Text};
use crate::number::Fraction;
use crate::unit::Unit;

fn n(value: i64) -> Expr {
    Expr::integer(value)
}
fn f(numerator: i64, denominator: i64) -> Expr {
    Expr::Number(Fraction::new(numerator, denominator))
}
fn x(name: &str) -> Expr {
    Expr::name(name)
}
fn neg(inner: Expr) -> Expr {
    Expr::Negative(Box::new(inner))
}
fn sum<const N: usize>(terms: [Expr; N]) -> Expr {
    Expr::Sum(terms.into())
}
fn times<const N: usize>(factors: [Expr; N]) -> Expr {
    Expr::Product(factors.into())
}
fn over(numerator: Expr, denominator: Expr) -> Expr {
    Expr::Quotient(Box::new(numerator), Box::new(denominator))
}
fn pow(base: Expr, exponent: Expr) -> Expr {
    Expr::Power(Box::new(base), Box::new(exponent))
}
fn root(inner: Expr) -> Expr {
    Expr::call(Function::Sqrt, inner)
}
fn sin(inner: Expr) -> Expr {
    Expr::call(Function::Sin, inner)
}
fn cos(inner: Expr) -> Expr {
    Expr::call(Function::Cos, inner)
}
fn tan(inner: Expr) -> Expr {
    Expr::call(Function::Tan, inner)
}
fn deg(value: i64) -> Expr {
    Expr::degrees(n(value))
}
fn vector(x: Expr, y: Expr) -> Expr {
    Expr::Vector(Box::new(x), Box::new(y))
}
fn relation(left: Expr, relation: Relation, right: Expr) -> Expr {
    Expr::Relation(Box::new(left), relation, Box::new(right))
}

/// Tree, plain, LaTeX, terminal.
#[test]
fn carom_knows_that_a_formula_is_written_as_a_teacher_writes_it() {
    let rows: Vec<(Expr, &str, &str, &str)> = vec![
        (over(times([n(16), root(n(3))]), n(9)), "16*sqrt(3)/9", r"\frac{16\sqrt{3}}{9}", "16√3/9"),
        (sum([times([n(4), x("i")]), x("j")]), "4*i + j", r"4\mathbf{i}+\mathbf{j}", "4i + j"),
        (
            sum([vector(n(4), n(-1)), neg(vector(n(2), n(5)))]),
            "[4, -1] - [2, 5]",
            r"(4\mathbf{i}-\mathbf{j})-(2\mathbf{i}+5\mathbf{j})",
            "(4i − j) − (2i + 5j)",
        ),
        (sum([sum([x("a"), x("b")]), neg(x("c"))]), "a + b - c", "a+b-c", "a + b − c"),
        (times([n(5), over(root(n(2)), n(2))]), "5*(sqrt(2)/2)", r"5\times\frac{\sqrt{2}}{2}", "5 × √2/2"),
        (times([n(6), sin(deg(10))]), "6*sin(10*deg)", r"6\sin 10^\circ", "6 sin 10°"),
        (
            neg(over(times([x("v"), cos(x("theta")), sum([times([n(2), x("e")]), n(-1)])]), n(3))),
            "-v*cos(theta)*(2*e - 1)/3",
            r"-\frac{v\cos(\theta)(2e-1)}{3}",
            "−v cos(θ)(2e − 1)/3",
        ),
        (neg(pow(n(2), n(2))), "-2^2", "-2^{2}", "−2²"),
        (pow(n(13), n(0)), "13^0", "13^{0}", "13^0"),
        (pow(n(-2), n(2)), "(-2)^2", "(-2)^{2}", "(−2)²"),
        (pow(neg(n(2)), n(2)), "(-2)^2", "(-2)^{2}", "(−2)²"),
        (over(x("a"), times([x("b"), x("c")])), "a/(b*c)", r"\frac{a}{bc}", "a/(bc)"),
        (over(x("a"), over(x("b"), x("c"))), "a/(b/c)", r"\frac{a}{\frac{b}{c}}", "a/(b/c)"),
        (over(over(x("a"), x("b")), x("c")), "(a/b)/c", r"\frac{\frac{a}{b}}{c}", "(a/b)/c"),
        (pow(over(x("a"), x("b")), n(2)), "(a/b)^2", r"\left(\frac{a}{b}\right)^{2}", "(a/b)²"),
        (pow(n(2), n(-1)), "2^(-1)", "2^{-1}", "2⁻¹"),
        (pow(pow(n(2), n(3)), n(2)), "(2^3)^2", "(2^{3})^{2}", "(2³)²"),
        (pow(x("x"), f(1, 2)), "x^(1/2)", r"x^{\frac{1}{2}}", "x^(1/2)"),
        (sum([x("a"), neg(sum([x("b"), neg(x("c"))]))]), "a - (b - c)", "a-(b-c)", "a − (b − c)"),
        (sum([x("a"), n(-3)]), "a - 3", "a-3", "a − 3"),
        (sum([n(4), neg(n(-3))]), "4 - (-3)", "4-(-3)", "4 − (−3)"),
        (sum([n(2), times([n(-3), x("v")])]), "2 - 3*v", "2-3v", "2 − 3v"),
        (times([f(3, 4), x("x")]), "(3/4)*x", r"\frac{3}{4}x", "(3/4)x"),
        (over(times([n(3), x("x")]), n(4)), "3*x/4", r"\frac{3x}{4}", "3x/4"),
        (pow(f(1, 2), n(2)), "(1/2)^2", r"\left(\frac{1}{2}\right)^{2}", "(1/2)²"),
        (f(5, 2), "5/2", r"\frac{5}{2}", "5/2"),
        (f(-5, 2), "-5/2", r"-\frac{5}{2}", "−5/2"),
        (times([f(1, 2), x("m"), pow(x("v"), n(2))]), "(1/2)*m*v^2", r"\frac{1}{2}mv^{2}", "(1/2)mv²"),
        (times([n(1), x("v")]), "v", "v", "v"),
        (times([n(-1), x("v")]), "-v", "-v", "−v"),
        (times([n(2), n(-3)]), "2*(-3)", r"2\times(-3)", "2 × (−3)"),
        (times([n(4), n(4), cos(deg(30))]), "4*4*cos(30*deg)", r"4\times 4\cos 30^\circ", "4 × 4 cos 30°"),
        (times([n(2), x("v"), cos(x("alpha"))]), "2*v*cos(alpha)", r"2v\cos\alpha", "2v cos α"),
        (times([x("m"), x("u"), cos(x("alpha"))]), "m*u*cos(alpha)", r"mu\cos\alpha", "mu cos α"),
        (times([cos(x("alpha")), sin(x("alpha"))]), "cos(alpha)*sin(alpha)", r"\cos\alpha\sin\alpha", "cos α sin α"),
        (times([cos(x("alpha")), x("v")]), "cos(alpha)*v", r"\cos(\alpha)v", "cos(α)v"),
        (pow(tan(x("theta")), n(2)), "tan(theta)^2", r"\tan^2\theta", "tan²θ"),
        (pow(cos(deg(30)), n(2)), "cos(30*deg)^2", r"\cos^2 30^\circ", "cos² 30°"),
        (pow(tan(x("theta")), n(-1)), "tan(theta)^(-1)", r"(\tan\theta)^{-1}", "(tan θ)⁻¹"),
        (sin(times([n(2), x("x")])), "sin(2*x)", r"\sin(2x)", "sin(2x)"),
        (cos(x("x")), "cos(x)", r"\cos x", "cos x"),
        (Expr::call(Function::Atan, f(1, 7)), "atan(1/7)", r"\arctan\frac{1}{7}", "arctan(1/7)"),
        (Expr::call(Function::Atan, over(n(3), n(4))), "atan(3/4)", r"\arctan\frac{3}{4}", "arctan(3/4)"),
        (Expr::call(Function::Abs, x("x")), "abs(x)", "|x|", "|x|"),
        (Expr::call(Function::Abs, neg(x("x"))), "abs(-x)", r"\left|-x\right|", "|−x|"),
        (times([n(2), over(x("v"), n(3))]), "2*(v/3)", r"2\frac{v}{3}", "2(v/3)"),
        (
            times([x("u"), over(sum([n(1), x("e")]), n(3)), cos(x("alpha"))]),
            "u*((1 + e)/3)*cos(alpha)",
            r"u\frac{1+e}{3}\cos\alpha",
            "u((1 + e)/3) cos α",
        ),
        (times([n(2), over(times([n(3), x("e")]), n(5))]), "2*(3*e/5)", r"2\times\frac{3e}{5}", "2 × 3e/5"),
        (times([n(3), x("m"), over(times([n(4), x("u")]), n(5))]), "3*m*(4*u/5)", r"3m\times\frac{4u}{5}", "3m × 4u/5"),
        (times([x("m"), over(x("u"), n(3))]), "m*(u/3)", r"m\frac{u}{3}", "m(u/3)"),
        (
            times([f(1, 2), over(times([root(n(3)), x("u")]), n(2))]),
            "(1/2)*(sqrt(3)*u/2)",
            r"\frac{1}{2}\times\frac{\sqrt{3}u}{2}",
            "(1/2) × √3 u/2",
        ),
        (
            times([root(n(6)), x("u"), root(n(6)), x("e")]),
            "sqrt(6)*u*sqrt(6)*e",
            r"\sqrt{6}u\times\sqrt{6}e",
            "√6 u × √6 e",
        ),
        (times([root(n(2)), root(n(5))]), "sqrt(2)*sqrt(5)", r"\sqrt{2}\times\sqrt{5}", "√2 × √5"),
        (
            times([cos(x("theta")), over(x("u"), n(7))]),
            "cos(theta)*(u/7)",
            r"\cos\theta\times\frac{u}{7}",
            "cos θ × u/7",
        ),
        (times([root(n(3)), x("v")]), "sqrt(3)*v", r"\sqrt{3}v", "√3 v"),
        (times([x("v"), root(sum([n(1), x("e")]))]), "v*sqrt(1 + e)", r"v\sqrt{1+e}", "v√(1 + e)"),
        (times([root(n(3)), n(2)]), "sqrt(3)*2", r"\sqrt{3}\times 2", "√3 × 2"),
        (deg(30), "30*deg", r"30^\circ", "30°"),
        (Expr::degrees(sum([n(180), neg(x("theta"))])), "(180 - theta)*deg", r"(180-\theta)^\circ", "(180 − θ)°"),
        (over(x("alpha"), deg(1)), "alpha/deg", r"\frac{\alpha}{1^\circ}", "α/1°"),
        (Expr::Decimal("46.1".into()), "46.1", "46.1", "46.1"),
        (times([n(2), Expr::Pi]), "2*pi", r"2\pi", "2π"),
        (x("v_A"), "v_A", "v_A", "v_A"),
        (x("u_1"), "u_1", "u_1", "u₁"),
        (x("v1"), "v1", "v_1", "v₁"),
        (x("v_AB"), "v_AB", "v_{AB}", "v_AB"),
        (x("KE"), "KE", r"\mathrm{KE}", "KE"),
        (x("A.after.speed"), "A.after.speed", r"\mathrm{A.after.speed}", "A.after.speed"),
        (times([x("mu"), x("m"), x("g")]), "mu*m*g", r"\mu mg", "μmg"),
        (Expr::equation(x("vector.v_A"), vector(n(1), n(0))), "v_A = [1, 0]", r"\mathbf{v}_A=\mathbf{i}", "v_A = i"),
        (vector(n(1), n(-1)), "[1, -1]", r"\mathbf{i}-\mathbf{j}", "i − j"),
        (vector(n(0), n(-2)), "[0, -2]", r"-2\mathbf{j}", "−2j"),
        (vector(n(0), n(0)), "[0, 0]", r"\mathbf{0}", "0"),
        (vector(f(5, 2), f(1, 2)), "[5/2, 1/2]", r"\frac{5}{2}\mathbf{i}+\frac{1}{2}\mathbf{j}", "(5/2)i + (1/2)j"),
        (
            vector(sum([n(1), x("e")]), times([x("u"), cos(x("alpha"))])),
            "[1 + e, u*cos(alpha)]",
            r"(1+e)\mathbf{i}+u\cos\alpha\,\mathbf{j}",
            "(1 + e)i + u cos α j",
        ),
        (times([n(3), vector(n(1), n(2))]), "3*[1, 2]", r"3(\mathbf{i}+2\mathbf{j})", "3(i + 2j)"),
        (sum([x("u"), vector(n(-1), n(0))]), "u + [-1, 0]", r"u-\mathbf{i}", "u − i"),
        (relation(x("a"), Relation::LessOrEqual, x("b")), "a <= b", r"a\leq b", "a ≤ b"),
        (relation(x("a"), Relation::NotEqual, x("b")), "a != b", r"a\neq b", "a ≠ b"),
        (
            relation(Expr::equation(x("a"), n(1)), Relation::Implies, Expr::equation(x("b"), n(2))),
            "a = 1 => b = 2",
            r"a=1\Rightarrow b=2",
            "a = 1 ⇒ b = 2",
        ),
        (
            relation(x("v"), Relation::Approximately, Expr::Decimal("2.78".into())),
            "v ~ 2.78",
            r"v\approx 2.78",
            "v ≈ 2.78",
        ),
    ];
    for (tree, as_plain, as_latex, as_unicode) in rows {
        assert_eq!(plain(&tree), as_plain);
        assert_eq!(latex(&tree), as_latex, "{as_plain}");
        assert_eq!(unicode(&tree), as_unicode, "{as_plain}");
    }
}

fn angle(expr: Expr) -> Text {
    Text(vec![Piece::Quantity(expr, Unit::Degree)])
}

#[test]
fn carom_knows_how_a_quantity_stands_with_its_unit() {
    let quantity = |expr: Expr, unit: Unit| Text(vec![Piece::Quantity(expr, unit)]);
    let velocity = || sum([times([n(4), x("i")]), neg(x("j"))]);
    let rows = [
        (quantity(n(4), Unit::Kilogram), r"$4\,\mathrm{kg}$", "4 kg"),
        (
            quantity(velocity(), Unit::MetrePerSecond),
            r"$(4\mathbf{i}-\mathbf{j})\,\mathrm{m\,s^{-1}}$",
            "(4i − j) m s⁻¹",
        ),
        (quantity(vector(n(2), n(0)), Unit::NewtonSecond), r"$2\mathbf{i}\,\mathrm{N\,s}$", "2i N s"),
        (quantity(over(n(3), n(2)), Unit::Joule), r"$\frac{3}{2}\,\mathrm{J}$", "(3/2) J"),
        (quantity(f(1, 2), Unit::None), r"$\frac{1}{2}$", "1/2"),
        (angle(n(30)), r"$30^\circ$", "30°"),
        (angle(f(11623, 100)), r"$116.23^\circ$", "116.23°"),
        (angle(f(-45, 2)), r"$-22.5^\circ$", "−22.5°"),
        (angle(f(100, 3)), r"$\left(\frac{100}{3}\right)^\circ$", "(100/3)°"),
        (
            Text(vec![Piece::Formula(Expr::call(Function::Sin, Expr::degrees(f(65, 4))))]),
            r"$\sin 16.25^\circ$",
            "sin 16.25°",
        ),
        (angle(x("alpha")), r"$\alpha^\circ$", "α°"),
        (angle(deg(30)), r"$30^\circ$", "30°"),
        (angle(n(-30)), r"$-30^\circ$", "−30°"),
        (angle(Expr::call(Function::Atan, n(7))), r"$(\arctan 7)^\circ$", "(arctan 7)°"),
        (angle(over(Expr::call(Function::Atan, n(7)), deg(1))), r"$\arctan 7$", "arctan 7"),
        (angle(sum([n(180), neg(x("x"))])), r"$(180-x)^\circ$", "(180 − x)°"),
    ];
    for (text, as_latex, as_unicode) in rows {
        assert_eq!(text_latex(&text), as_latex);
        assert_eq!(text_unicode(&text), as_unicode);
    }
}

#[test]
fn carom_knows_that_words_are_only_words() {
    let hostile = "\\ { } $ & # ^ _ ~ % < > \" | ` [a] \u{1b}[31m \u{202e}drow é – 漢 🎱";
    assert_eq!(
        words_latex(hostile),
        r"\textbackslash{} \{ \} $\$$ \& \# {\normalfont\ttfamily\symbol{94}} \_ $\sim$ \% \textless{} \textgreater{} {\normalfont\ttfamily\symbol{34}} \textbar{} {\normalfont\ttfamily\`{}} {[}a{]} {[}31m drow é -- ? ?"
    );
    assert_eq!(words_latex("a--b---c O''N ,,q"), r"a-\kern0pt -b-\kern0pt -\kern0pt -c O'\kern0pt 'N ,\kern0pt ,q");
    assert_eq!(words_latex("<<q>"), r"\textless{}\kern0pt \textless{}q\textgreater{}");
    assert_eq!(words_latex("a, b's, “c” 1–2—3"), r"a, b's, ``c'' 1--2---3");
    assert_eq!(words_html("<b a='1'>\"&\u{0}\u{202e}"), "&lt;b a=&#39;1&#39;&gt;&quot;&amp;");
    assert_eq!(words_unicode("a\u{1b}[31m\u{7}\u{200f}\nb"), "a[31m b");
    assert_eq!(latex(&x(r"\input{x}")), r"\mathrm{?input?x?}");
    assert_eq!(mathml(&x("<b>")), r#"<mi mathvariant="normal">&lt;b&gt;</mi>"#);
}

#[test]
fn carom_knows_how_a_line_of_words_is_printed() {
    let text = Text(vec![
        Piece::Italic(vec![Piece::Words("A & ".into()), Piece::Formula(x("B"))]),
        Piece::Display(Expr::equation(x("e"), f(1, 2))),
    ]);
    assert_eq!(text_latex(&text), r"\textit{A \& $B$}\[e=\frac{1}{2}\]");
    assert_eq!(
        text_html(&text),
        "<em>A &amp; <math><mi>B</mi></math></em><math display=\"block\" class=\"long\">\
         <mrow><mi>e</mi></mrow><mrow><mo>=</mo><mfrac><mn>1</mn><mn>2</mn></mfrac></mrow></math>"
    );
}

#[test]
fn carom_knows_that_a_stop_follows_its_formula() {
    let (a, b) = ("<math><mi>A</mi></math>", "<math><mi>B</mi></math>");
    let text = |pieces: Vec<Piece>| text_html(&Text(pieces));
    let formula = |name: &str| Piece::Formula(x(name));
    let words = |words: &str| Piece::Words(words.into());
    assert_eq!(
        text(vec![formula("A"), words(", not "), formula("B"), words(").")]),
        format!(r#"<span class="kept">{a},</span> not <span class="kept">{b}).</span>"#)
    );
    assert_eq!(text(vec![words(". "), formula("A"), words(" & so.")]), format!(". {a} &amp; so."));
    assert_eq!(
        text(vec![Piece::Italic(vec![formula("A"), words(".")]), words(".")]),
        format!(r#"<em><span class="kept">{a}.</span></em>."#)
    );
}

#[test]
fn carom_knows_where_a_narrow_page_may_break_a_formula() {
    let formula = Expr::equation(sum([times([n(3), x("v")]), times([n(2), x("w")])]), sum([x("u"), n(-1)]));
    let expected = "<math class=\"long\"><mrow><mn>3</mn><mo>&#x2062;</mo><mi>v</mi></mrow>\
                    <mrow><mo form=\"infix\">+</mo><mn>2</mn><mo>&#x2062;</mo><mi>w</mi></mrow>\
                    <mrow><mo>=</mo><mi>u</mi></mrow><mrow><mo form=\"infix\">−</mo><mn>1</mn></mrow></math>";
    assert_eq!(mathml_inline(&formula), expected);
    assert_eq!(mathml_block(&formula), expected.replace("<math ", "<math display=\"block\" "));
    let short = sum([times([n(3), x("v")]), x("w")]);
    assert!(!mathml_inline(&short).contains("mrow"), "{}", mathml_inline(&short));
    // by itself even a short formula may go on on the next line
    let pieces = "<mrow><mn>3</mn><mo>&#x2062;</mo><mi>v</mi></mrow><mrow><mo form=\"infix\">+</mo><mi>w</mi></mrow>";
    assert_eq!(mathml_block(&short), format!("<math display=\"block\" class=\"long\">{pieces}</math>"));
}

#[test]
fn carom_knows_how_wide_a_piece_is_that_cannot_break() {
    let sum_of = |count: i64| Expr::sum((1..=count).map(|number| times([n(number), x("v")])));
    let root = |inner: Expr| Expr::call(Function::Sqrt, inner);
    for (formula, expected) in [
        (sum_of(9), None),
        (root(sum_of(2)), None),
        (root(sum_of(4)), Some(10.1)),
        // a fraction is as wide as the wider of its parts
        (sum_of(4).over(sum_of(3)), Some(9.5)),
    ] {
        let printed = mathml_inline(&formula);
        let said = printed.split("style=\"--ems: ").nth(1).and_then(|rest| rest.split('"').next());
        assert_eq!(said.map(|width| width.parse().unwrap()), expected, "{printed}");
    }
}

#[test]
fn carom_knows_mathml_that_browsers_draw_themselves() {
    let times_sign = "<mo>&#x2062;</mo>";
    let space = r#"<mspace width="0.1667em"/>"#;
    let rows = [
        (times([n(2), x("v")]), format!("<mn>2</mn>{times_sign}<mi>v</mi>")),
        (
            times([n(2), cos(x("alpha"))]),
            format!("<mn>2</mn>{times_sign}{space}<mrow><mi>cos</mi><mo>&#x2061;</mo>{space}<mi>α</mi></mrow>"),
        ),
        (pow(x("v_1"), n(2)), "<msubsup><mi>v</mi><mn>1</mn><mn>2</mn></msubsup>".to_owned()),
        (vector(n(1), n(-1)), r#"<mi class="vector">𝐢</mi><mo>−</mo><mi class="vector">𝐣</mi>"#.to_owned()),
        (
            pow(sum([x("a"), n(1)]), n(2)),
            r#"<msup><mrow><mo form="prefix" stretchy="false">(</mo><mi>a</mi><mo>+</mo><mn>1</mn><mo form="postfix" stretchy="false">)</mo></mrow><mn>2</mn></msup>"#.to_owned(),
        ),
    ];
    for (tree, expected) in rows {
        assert_eq!(mathml(&tree), expected);
    }
}

#[test]
fn carom_knows_that_a_formula_on_one_line_has_room_for_its_brackets() {
    let vector = |n, d| Expr::product([f(n, d), x("i")]);
    for formula in [vector(5, 2), sum([vector(-5, 2), vector(1, 2)])] {
        let [drawn, written] = [Piece::Formula(formula.clone()), Piece::Words(unicode(&formula))]
            .map(|piece| extent(&Text(vec![piece])).0);
        assert!(drawn >= written, "{}: {drawn} of {written}", unicode(&formula));
    }
}

#[test]
fn a_tower_of_powers_is_printed_storey_by_storey() {
    let tower = (0..40).fold(x("e"), |above, _| pow(x("e"), above));
    assert!([plain(&tower), unicode(&tower), latex(&tower)].iter().all(|printed| printed.len() < 400));
}
