//! Components of a velocity along two perpendicular directions.
//!
//! `v_n = v·n` and `v_t = v·t`, where `t` is `n` turned by +90 degrees; and back again. A velocity that
//! was given by its speed and direction has the components `v cos θ`, `v sin θ`.

use smallvec::smallvec;

use super::{Seen, Datum, Here, Law, Line, Outcome, Rule, Show, Slip, rule, silent, velocity, first_equation, components, is_at_rest_before, with_inputs, with_sign_of};
use crate::expr::{Expr, Function, written};
use crate::mechanics::Axis::{N, T, X, Y};
use crate::mechanics::formula::times;
use crate::mechanics::{Moment, Quantity, Setting, Sphere};
use crate::number::{Number, Value};

pub const NAME: &str = "resolve";

pub const SEEN: Seen = Seen::Components;

pub const ACCURACY: &str = "correct expression, unsimplified";

pub const METHOD: (&str, &str) =
    ("velocities resolved along the line of centres", "scalar product or sine and cosine; condone sine for cosine");

pub const SLIPS: &[Slip] = &[
    Slip {
        place: 1,
        tag: "sincos-swap",
        did: "took the component across the line of centres for the one along it, sine for cosine",
        sentence: "The angle is with the line of centres, so cosine gives the component along it and sine the one across, which does not change.",
        also: &[Law::Deflection],
        condoned: true,
    },
];

/// The forms: what the components come from.
const FROM_SPEED: u8 = 0;
const FROM_SPEED_IN_I_J: u8 = 1;
const FROM_I_J: u8 = 2;
const TO_I_J: u8 = 3;
const TURNED: u8 = 4;

pub fn rules() -> Vec<Rule> {
    let (n_x, n_y) = (Quantity::Line(X), Quantity::Line(Y));
    let mut rules = vec![rule(Law::Resolve, TURNED, &[n_x, n_y], &[Quantity::Tangent(X), Quantity::Tangent(Y)], 1)];
    for sphere in Sphere::BOTH {
        for moment in [Moment::Before, Moment::After] {
            let given = [Quantity::Speed(sphere, moment), Quantity::GivenDirection(sphere, moment)];
            let x_y = [velocity(sphere, moment, X), velocity(sphere, moment, Y)];
            let n_t = [velocity(sphere, moment, N), velocity(sphere, moment, T)];
            rules.push(rule(Law::Resolve, FROM_SPEED, &[given[0], given[1], n_x, n_y], &n_t, 1));
            rules.push(rule(Law::Resolve, FROM_SPEED_IN_I_J, &given, &x_y, 1));
            rules.push(rule(Law::Resolve, FROM_I_J, &[x_y[0], x_y[1], n_x, n_y], &n_t, 1));
            rules.push(rule(Law::Resolve, TO_I_J, &[n_t[0], n_t[1], n_x, n_y], &x_y, 1));
        }
    }
    rules
}

pub fn evaluate<N: Number>(rule: &Rule, known: &Here<N>) -> Outcome<N> {
    let pair = |a: N, b: N| Some(smallvec![Datum::Number(a), Datum::Number(b)]);
    let line = || known.numbers([Quantity::Line(X), Quantity::Line(Y)]);
    match rule.form {
        FROM_SPEED | FROM_SPEED_IN_I_J => {
            let speed = known.number(rule.needs[0])?;
            let (sin, cos) = known.direction(rule.needs[1])?;
            let (x, y) = (speed.clone() * cos, speed * sin);
            if rule.form == FROM_SPEED_IN_I_J {
                return pair(x, y);
            }
            let [n_x, n_y] = line()?;
            pair(x.clone() * n_x.clone() + y.clone() * n_y.clone(), y * n_x - x * n_y)
        }
        FROM_I_J => {
            let [x, y] = known.numbers([rule.needs[0], rule.needs[1]])?;
            let [n_x, n_y] = line()?;
            pair(x.clone() * n_x.clone() + y.clone() * n_y.clone(), y * n_x - x * n_y)
        }
        TO_I_J => {
            let [n, t] = known.numbers([rule.needs[0], rule.needs[1]])?;
            let [n_x, n_y] = line()?;
            pair(n.clone() * n_x.clone() - t.clone() * n_y.clone(), n * n_y + t * n_x)
        }
        _ => {
            let [n_x, n_y] = line()?;
            pair(-n_y, n_x)
        }
    }
}

pub fn slipped<N: Number>(slip: &str, rule: &Rule, known: &Here<N>) -> Outcome<N> {
    match (slip, rule.form) {
        // The arrows still point the right way.
        ("sincos-swap", FROM_SPEED | FROM_I_J) => {
            let components = evaluate(rule, known)?;
            let [Datum::Number(n), Datum::Number(t)] = components.as_slice() else { return None };
            let one = n.one();
            Some(smallvec![Datum::Number(with_sign_of(t, n, &one)), Datum::Number(with_sign_of(n, t, &one))])
        }
        ("struck-inherits", TO_I_J) if rule.gives[0] == velocity(Sphere::B, Moment::After, X) => {
            let [along, across] = components(known, Sphere::A, Moment::Before)?;
            if !is_at_rest_before(known, Sphere::B) {
                return None;
            }
            let speed = known.number(rule.needs[0])?;
            let unit = (along.squared() + across.squared()).root()?;
            let inherited = |component: N| Some(speed.clone() * component.over(&unit)?);
            with_inputs(rule, known, &[(rule.needs[0], inherited(along)?), (rule.needs[1], inherited(across)?)])
        }
        _ => None,
    }
}

/// What earns the mark for accuracy.
pub fn earning(rule: &Rule, show: &Show) -> Option<Expr> {
    first_equation(&lines(rule, show))
}

pub fn lines(rule: &Rule, show: &Show) -> Vec<Line> {
    let Some(Quantity::Velocity(sphere, moment, _)) = rule.gives.first().copied() else {
        return rule.gives.iter().flat_map(|tangent| show.statement(*tangent)).collect();
    };
    match rule.form {
        // The angle to the line of centres is known from where the spheres touch.
        FROM_I_J
            if show.contact_quotient().is_some()
                && moment == Moment::Before
                && is_at_rest(show, Sphere::B, Moment::Before) =>
        {
            by_contact_angle(show, sphere)
        }
        // Along an axis there is nothing to resolve.
        // A sphere at rest has nothing to resolve either.
        FROM_I_J if !show.along_an_axis() && !is_at_rest(show, sphere, moment) => {
            if show.setting() == Setting::Wall {
                return at_a_slanted_wall(show, moment);
            }
            let component = Expr::name(show.letter_of(velocity(sphere, moment, N)));
            // The first of them says what n is.
            let n = match (sphere, moment) {
                (Sphere::A, Moment::Before) => "The unit vector along the line of centres, from {A} to {B}, is {n}. ",
                _ => "",
            };
            let words = format!("{n}The component along it of the velocity of {{S}} {moment} the impact is");
            let formulas = [("S", Expr::name(sphere.name())), ("n", show.line_vector())];
            let rights = [scalar_product(show, sphere, moment), show.along(sphere, moment)];
            vec![Line::with(&words, &formulas, Show::chain(component, rights))]
        }
        // In one line a velocity is a number.
        TO_I_J if show.setting() == Setting::Direct => silent(),
        TO_I_J if show.is_asked(rule.gives[0]) || show.is_asked(rule.gives[1]) => {
            let vector = show.vector(sphere, moment);
            if !show.along_an_axis() {
                return vec![recombined(show, sphere, moment)];
            }
            let stated = show.approximate_velocity(&vector, sphere, moment).unwrap_or(vector);
            vec![Line::with(
                "So the velocity of {A} after the impact is {v m/s}.",
                &[("A", Expr::name(sphere.name())), ("v", stated)],
                vec![],
            )]
        }
        _ => silent(),
    }
}

/// Both components at a wall that is parallel to neither i nor j, by scalar products with its unit vectors.
fn at_a_slanted_wall(show: &Show, moment: Moment) -> Vec<Line> {
    let unit = |n: bool| {
        let [x, y] = [X, Y].map(|axis| show.exact(Quantity::Line(axis)));
        // Along the wall, in the sense in which the sphere moves.
        let backwards = show.exact(velocity(Sphere::A, moment, T)).sign().is_some_and(|sign| sign.is_lt());
        match (n, backwards) {
            (true, _) => [x, y],
            (false, true) => [y, -x],
            (false, false) => [-y, x],
        }
    };
    let [n, t] = [true, false].map(unit);
    let vector = |[x, y]: &[Value; 2]| Expr::Vector(Box::new(written(x)), Box::new(written(y)));
    let product = |unit: &[Value; 2]| {
        let terms = [X, Y].into_iter().zip(unit);
        Expr::sum(terms.map(|(axis, unit)| times(show.value(velocity(Sphere::A, moment, axis)), written(unit))))
    };
    let at = |axis| written(&show.exact(velocity(Sphere::A, moment, axis)).absolute());
    let part = |words: &str, unit: &[Value; 2], left: &str, axis| {
        let rights = match axis {
            N if moment == Moment::After => [product(unit), written(&show.exact(velocity(Sphere::A, moment, N)))],
            _ => [product(unit), at(axis)],
        };
        Line::with(words, &[("n", vector(unit))], Show::chain(Expr::name(left), rights))
    };
    let when = format!("of the velocity of *A* {moment} the impact");
    let towards = format!("The unit vector perpendicular to the wall, towards it, is {{n}}. The component along it {when} is");
    let parallel = format!("The unit vector parallel to the wall is {{n}}. The component along it {when} is");
    let perpendicular = if moment == Moment::Before { "u_A" } else { "v_A" };
    vec![part(&towards, &n, perpendicular, N), part(&parallel, &t, "p", T)]
}

/// Both components times their unit vectors, where neither of these is i or j.
fn recombined(show: &Show, sphere: Sphere, moment: Moment) -> Line {
    let at = |axis| show.exact(velocity(sphere, moment, axis));
    let (along, across) = (at(N), at(T));
    let [x, y] = [X, Y].map(|axis| show.exact(Quantity::Line(axis)));
    // The unit vector along the wall points as the sphere moves.
    let backwards = across.sign().is_some_and(|sign| sign.is_lt());
    let parallel = if backwards { [y.clone(), -&x] } else { [-&y, x.clone()] };
    let vector = |[x, y]: &[Value; 2]| Expr::Vector(Box::new(written(x)), Box::new(written(y)));
    let part = |size: &Value, unit: &[Value; 2]| if size.is_zero() { Expr::integer(0) } else { times(written(size), vector(unit)) };
    let across = part(&across.absolute(), &parallel);
    let along = part(&along, &[x, y]);
    let sum = if across.is_zero() { along } else { Expr::sum([across, along]) };
    let name = Expr::name(show.vector_letter(sphere, moment));
    let unit = show.in_units(&show.exact(velocity(sphere, moment, X)), "metres per second");
    let words = format!("So the velocity of {{A}} {moment} the impact{unit} is");
    let mut equations = Show::chain(name.clone(), [sum, show.vector(sphere, moment)]);
    equations.extend(show.approximate_velocity(&name, sphere, moment));
    Line::with(&words, &[("A", Expr::name(sphere.name()))], equations)
}

/// `u cos α` and `u sin α` for a sphere that strikes one at rest.
fn by_contact_angle(show: &Show, sphere: Sphere) -> Vec<Line> {
    if is_at_rest(show, sphere, Moment::Before) {
        return silent();
    }
    let at = |axis| show.exact(velocity(sphere, Moment::Before, axis));
    let Some(speed) = (at(X).squared() + at(Y).squared()).root() else { return silent() };
    let speed = written(&speed);
    let angle = Expr::name(show.contact_angle());
    let part = |function, axis| {
        let value = written(&at(axis).absolute());
        Expr::equation(times(speed.clone(), Expr::call(function, angle.clone())), value)
    };
    let words = "The components of the velocity of {S} before the impact, along the line of centres and perpendicular to it, are";
    vec![Line::with(words, &[("S", Expr::name(sphere.name()))], vec![part(Function::Cos, N), part(Function::Sin, T)])]
}

/// `u_x n_x + u_y n_y` in numbers.
fn scalar_product(show: &Show, sphere: Sphere, moment: Moment) -> Expr {
    let term = |axis| times(show.value(velocity(sphere, moment, axis)), show.value(Quantity::Line(axis)));
    Expr::sum([term(X), term(Y)])
}

fn is_at_rest(show: &Show, sphere: Sphere, moment: Moment) -> bool {
    [X, Y].into_iter().all(|axis| show.exact(velocity(sphere, moment, axis)).is_zero())
}
