//! Where the spheres touch: the line of centres from the offset of A's path relative to B.
//!
//! At the impact the centres are `r_A + r_B` apart. Let `w` be the unit vector of A's velocity relative
//! to B, and `d` how far B's centre lies to the left of the line through A's centre along `w`. The
//! line of centres makes the angle α with `w`, anticlockwise, where `sin α = d/(r_A + r_B)`.

use smallvec::smallvec;

use super::{Shape, Seen, Datum, Here, Law, Line, Outcome, Rule, Show, Slip, rule, velocity, first_equation};
use crate::expr::{Expr, Function, written};
use crate::mechanics::Axis::{X, Y};
use crate::mechanics::Moment::Before;
use crate::mechanics::Quantity;
use crate::mechanics::Sphere::{A, B};
use crate::number::Number;

pub const NAME: &str = "contact";

pub const SEEN: Seen = Seen::Value(&[Quantity::ContactSine], Shape::Any);

pub const ACCURACY: &str = "correct expression, unsimplified";

pub const METHOD: (&str, &str) = (
    "right-angled triangle with the line joining the centres as hypotenuse",
    "the sum of the radii as the hypotenuse must be seen or implied",
);

pub const SLIPS: &[Slip] = &[
    Slip {
        place: 51,
        tag: "one-radius",
        did: "took one radius for the distance of the centres",
        sentence: "When the spheres touch, their centres are two radii apart, not one.",
        also: &[],
        condoned: false,
    },
];

pub fn rules() -> Vec<Rule> {
    let needs = [
        Quantity::ContactSine,
        velocity(A, Before, X),
        velocity(A, Before, Y),
        velocity(B, Before, X),
        velocity(B, Before, Y),
    ];
    vec![rule(Law::Contact, 0, &needs, &[Quantity::Line(X), Quantity::Line(Y)], 2)]
}

fn line<N: Number>(rule: &Rule, known: &Here<N>, sine: N) -> Outcome<N> {
    let [_, ax, ay, bx, by] = known.numbers([rule.needs[0], rule.needs[1], rule.needs[2], rule.needs[3], rule.needs[4]])?;
    let (x, y) = (ax - bx, ay - by);
    let size = (x.squared() + y.squared()).root()?;
    let (x, y) = (x.over(&size)?, y.over(&size)?);
    let one = x.one();
    let cosine = (one - sine.squared()).root()?;
    let n_x = x.clone() * cosine.clone() - y.clone() * sine.clone();
    let n_y = y * cosine + x * sine;
    Some(smallvec![Datum::Number(n_x), Datum::Number(n_y)])
}

pub fn evaluate<N: Number>(rule: &Rule, known: &Here<N>) -> Outcome<N> {
    line(rule, known, known.number(Quantity::ContactSine)?)
}

pub fn slipped<N: Number>(slip: &str, rule: &Rule, known: &Here<N>) -> Outcome<N> {
    let sine = known.number(Quantity::ContactSine)?;
    match slip {
        "one-radius" => line(rule, known, sine.clone() + sine),
        _ => None,
    }
}

/// What earns the mark for accuracy.
pub fn earning(rule: &Rule, show: &Show) -> Option<Expr> {
    first_equation(&lines(rule, show))
}

pub fn lines(_: &Rule, show: &Show) -> Vec<Line> {
    let sine = Expr::call(Function::Sin, Expr::name(show.contact_angle()));
    let size = written(&show.exact(Quantity::ContactSine).absolute());
    let chain = match show.contact_quotient() {
        Some(quotient) => Show::chain(sine, [quotient, size]),
        None => vec![Expr::equation(sine, size)],
    };
    vec![Line::with(
        "At the impact the line joining the centres is as long as the two radii together. If it makes an angle {a} with the path of {A},",
        &[("a", Expr::name(show.contact_angle())), ("A", Expr::name("A"))],
        chain,
    )]
}
