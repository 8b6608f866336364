//! Impulse is change of momentum: `I = m (v - u)` for the sphere that receives it.
//!
//! The two impulses are equal and opposite, and act along the line of centres.

use smallvec::smallvec;

use super::{Shape, Seen, Datum, Here, Law, Line, Outcome, Rule, Show, Slip, first_equation, full_speed, number, rule, silent, velocity, with_inputs};
use crate::expr::{Expr, Function, written};
use crate::mechanics::formula::{difference, times};
use crate::mechanics::Axis::{N, T, X, Y};
use crate::mechanics::Moment::{After, Before};
use crate::mechanics::{Moment, Quantity, Setting, Sphere};
use crate::number::{Number, Value};

pub const NAME: &str = "impulse";

pub const SEEN: Seen = Seen::Value(
    &[Quantity::Impulse(Sphere::A, N), Quantity::Impulse(Sphere::B, N), Quantity::ImpulseMagnitude],
    Shape::ChangeOfMomentum,
);

pub const ACCURACY: &str = "correct equation, unsimplified";

pub const METHOD: (&str, &str) =
    ("impulse as the change of momentum of one sphere", "a difference of momenta of one sphere, in either order");

pub const SLIPS: &[Slip] = &[
    Slip {
        place: 37,
        tag: "impulse-speed-change",
        did: "subtracted the sizes of the components along the line of centres",
        sentence: "Where a sphere turns back its velocity changes by the sum of the two sizes: keep the signs.",
        also: &[],
        condoned: true,
    },
    Slip {
        place: 38,
        tag: "impulse-resultant-speeds",
        did: "took the change of the full speed",
        sentence: "Impulse is the change of velocity along the line of centres, times the mass, and not the change of speed.",
        also: &[],
        condoned: false,
    },
    Slip {
        place: 39,
        tag: "impulse-wrong-mass",
        did: "multiplied the change of velocity by the mass of the other sphere",
        sentence: "The mass must belong to the sphere whose velocity you follow.",
        also: &[],
        condoned: false,
    },
    Slip {
        place: 40,
        tag: "impulse-after-only",
        did: "gave the momentum after the impact",
        sentence: "Impulse is the change of momentum: the momentum before is to be taken off.",
        also: &[],
        condoned: false,
    },
    Slip {
        place: 41,
        tag: "impulse-both-added",
        did: "added the impulses on the two spheres",
        sentence: "The two spheres receive equal and opposite impulses: the impulse is one of them, not the sum of their sizes.",
        also: &[],
        condoned: false,
    },
    Slip {
        place: 52,
        tag: "impulse-mass-forgotten",
        did: "added the impulse to the velocity without dividing it by the mass",
        sentence: "An impulse is a change of momentum: divide it by the mass to get the change of velocity.",
        also: &[],
        condoned: false,
    },
    Slip {
        place: 53,
        tag: "impulse-taken-off",
        did: "took the impulse off instead of adding it",
        sentence: "The impulse is momentum after less momentum before: check on which side it stands.",
        also: &[],
        condoned: true,
    },
    Slip {
        place: 54,
        tag: "impulse-for-momentum",
        did: "took the impulse for the momentum after",
        sentence: "The impulse is only what is added to the momentum: the momentum before is there already.",
        also: &[],
        condoned: false,
    },
];

const OF_COMPONENT: u8 = 0;
const OF_VECTOR: u8 = 1;
const REACTION: u8 = 2;
const SIZE: u8 = 3;
const SIZE_OF_VECTOR: u8 = 4;
const COMPONENTS: u8 = 5;
const ACROSS: u8 = 6;
const AFTER_GIVEN: u8 = 7;
const BEFORE_GIVEN: u8 = 8;
const MASS: u8 = 9;

pub fn rules() -> Vec<Rule> {
    let mut rules = Vec::new();
    for sphere in [Sphere::B, Sphere::A] {
        let mass = Quantity::Mass(sphere);
        let impulse = |axis| Quantity::Impulse(sphere, axis);
        let at = |moment, axis| velocity(sphere, moment, axis);
        rules.push(rule(Law::Impulse, OF_COMPONENT, &[mass, at(Before, N), at(After, N)], &[impulse(N)], 1));
        let needs = [mass, at(Before, X), at(Before, Y), at(After, X), at(After, Y)];
        rules.push(rule(Law::Impulse, OF_VECTOR, &needs, &[impulse(X), impulse(Y)], 2));
        for axis in [X, Y, N] {
            rules.push(rule(Law::Impulse, REACTION, &[Quantity::Impulse(sphere.other(), axis)], &[impulse(axis)], 1));
        }
        rules.push(rule(Law::Impulse, SIZE, &[impulse(N)], &[Quantity::ImpulseMagnitude], 1));
        rules.push(rule(Law::Impulse, SIZE_OF_VECTOR, &[impulse(X), impulse(Y)], &[Quantity::ImpulseMagnitude], 2));
        let line = [impulse(N), Quantity::Line(X), Quantity::Line(Y)];
        rules.push(rule(Law::Impulse, COMPONENTS, &line, &[impulse(X), impulse(Y)], 2));
        rules.push(rule(Law::Impulse, ACROSS, &[impulse(N)], &[impulse(T)], 1));
    }
    // Of a particle by itself, whose impulse is given.
    let of_a = |moment| [X, Y].map(|axis| velocity(Sphere::A, moment, axis));
    for (form, from, to) in [(AFTER_GIVEN, Before, After), (BEFORE_GIVEN, After, Before)] {
        let mut needs = vec![Quantity::Mass(Sphere::A)];
        needs.extend(of_a(from));
        needs.extend([X, Y].map(Quantity::GivenImpulse));
        rules.push(rule(Law::Impulse, form, &needs, &of_a(to), 2));
    }
    let mut needs = [X, Y].map(Quantity::GivenImpulse).to_vec();
    needs.extend([Before, After].into_iter().flat_map(of_a));
    rules.push(rule(Law::Impulse, MASS, &needs, &[Quantity::Mass(Sphere::A)], 2));
    rules
}

pub fn evaluate<N: Number>(rule: &Rule, known: &Here<N>) -> Outcome<N> {
    match rule.form {
        OF_COMPONENT => {
            let [mass, before, after] = known.numbers([rule.needs[0], rule.needs[1], rule.needs[2]])?;
            number(mass * (after - before))
        }
        OF_VECTOR => {
            let n = &rule.needs;
            let [mass, u_x, u_y, v_x, v_y] = known.numbers([n[0], n[1], n[2], n[3], n[4]])?;
            Some(smallvec![Datum::Number(mass.clone() * (v_x - u_x)), Datum::Number(mass * (v_y - u_y))])
        }
        REACTION => number(-known.number(rule.needs[0])?),
        SIZE => {
            let impulse = known.number(rule.needs[0])?;
            // Of two spheres B is pushed away from A. Which way the normal to a wall runs is not known.
            number(match rule.needs[0] {
                Quantity::Impulse(Sphere::B, _) => impulse.size_of_positive(),
                _ if known.number(Quantity::Mass(Sphere::B)).is_some() => (-impulse).size_of_positive(),
                _ => impulse.size(),
            })
        }
        SIZE_OF_VECTOR => {
            let [x, y] = known.numbers([rule.needs[0], rule.needs[1]])?;
            number((x.squared() + y.squared()).root()?)
        }
        COMPONENTS => {
            let [size, x, y] = known.numbers([rule.needs[0], rule.needs[1], rule.needs[2]])?;
            Some(smallvec![Datum::Number(size.clone() * x), Datum::Number(size * y)])
        }
        AFTER_GIVEN | BEFORE_GIVEN => {
            let n = &rule.needs;
            let [mass, x, y, i, j] = known.numbers([n[0], n[1], n[2], n[3], n[4]])?;
            let (along_x, along_y) = (i.over(&mass)?, j.over(&mass)?);
            let (along_x, along_y) = if rule.form == AFTER_GIVEN { (along_x, along_y) } else { (-along_x, -along_y) };
            Some(smallvec![Datum::Number(x + along_x), Datum::Number(y + along_y)])
        }
        MASS => {
            let n = &rule.needs;
            let [i, j, u_x, u_y] = known.numbers([n[0], n[1], n[2], n[3]])?;
            let [v_x, v_y] = known.numbers([n[4], n[5]])?;
            let (x, y) = (v_x - u_x, v_y - u_y);
            // No mass makes one of the other where they are not parallel.
            let is_parallel = (i.clone() * y.clone() - j.clone() * x.clone()).is_nought();
            let along = if x.is_nought() { j.over(&y) } else { i.over(&x) };
            number(along.filter(|_| is_parallel)?)
        }
        _ => number(known.number(rule.needs[0])?.nought()),
    }
}

pub fn slipped<N: Number>(slip: &str, rule: &Rule, known: &Here<N>) -> Outcome<N> {
    match (rule.form, rule.needs[0]) {
        (OF_COMPONENT, Quantity::Mass(sphere)) => {
            let [mass, before, after] = known.numbers([rule.needs[0], rule.needs[1], rule.needs[2]])?;
            match slip {
                "impulse-speed-change" => number(mass * (after.size() - before.size())),
                "impulse-resultant-speeds" => number(mass * change_of_speed(known, sphere)?),
                "impulse-wrong-mass" => number(known.number(Quantity::Mass(sphere.other()))? * (after - before)),
                "impulse-after-only" => number(mass * after),
                "wrong-axis" => {
                    let [before, after] = known.numbers([velocity(sphere, Before, T), velocity(sphere, After, T)])?;
                    number(mass * (after - before))
                }
                _ => None,
            }
        }
        (OF_VECTOR, Quantity::Mass(sphere)) => {
            let [_, u_x, u_y, ..] = rule.needs[..] else { return None };
            let mass = known.number(Quantity::Mass(sphere.other()));
            match slip {
                "impulse-wrong-mass" => with_inputs(rule, known, &[(rule.needs[0], mass?)]),
                "impulse-after-only" => {
                    let nought = known.number(u_x)?.nought();
                    with_inputs(rule, known, &[(u_x, nought.clone()), (u_y, nought)])
                }
                _ => None,
            }
        }
        (AFTER_GIVEN | BEFORE_GIVEN, Quantity::Mass(_)) => {
            let [mass, x, _, i, j] = rule.needs[..] else { return None };
            match slip {
                "impulse-mass-forgotten" => with_inputs(rule, known, &[(mass, known.number(x)?.one())]),
                "impulse-taken-off" => {
                    with_inputs(rule, known, &[(i, -known.number(i)?), (j, -known.number(j)?)])
                }
                "impulse-for-momentum" if rule.form == AFTER_GIVEN => {
                    let mass = known.number(mass)?;
                    Some(smallvec![Datum::Number(known.number(i)?.over(&mass)?), Datum::Number(known.number(j)?.over(&mass)?)])
                }
                _ => None,
            }
        }
        (SIZE | SIZE_OF_VECTOR, Quantity::Impulse(sphere, _)) => match slip {
            // Beside a wall or by itself there is no other impulse to add.
            "impulse-both-added" if known.number(Quantity::Mass(sphere.other())).is_some() => {
                let outcome = evaluate(rule, known)?;
                let [Datum::Number(size)] = outcome.as_slice() else { return None };
                number(size.clone() + size.clone())
            }
            "impulse-resultant-speeds" if rule.form == SIZE_OF_VECTOR => {
                number((known.number(Quantity::Mass(sphere))? * change_of_speed(known, sphere)?).size())
            }
            _ => None,
        },
        _ => None,
    }
}

fn change_of_speed<N: Number>(known: &Here<N>, sphere: Sphere) -> Option<N> {
    Some(full_speed(known, sphere, After)? - full_speed(known, sphere, Before)?)
}

/// What earns the mark for accuracy.
pub fn earning(rule: &Rule, show: &Show) -> Option<Expr> {
    let lines = lines(rule, show);
    // In terms of a letter that is to be found the velocity itself is what the next step needs.
    let is_open = rule.gives.iter().any(|quantity| !show.exact(*quantity).is_constant());
    match rule.form {
        AFTER_GIVEN if is_open => lines.last().and_then(|line| line.equations.last().cloned()),
        _ => first_equation(&lines),
    }
}

pub fn lines(rule: &Rule, show: &Show) -> Vec<Line> {
    match (rule.form, rule.gives[0]) {
        (OF_COMPONENT, Quantity::Impulse(sphere, _)) => along(show, sphere),
        (OF_VECTOR, Quantity::Impulse(sphere, _)) => vector(show, sphere),
        (AFTER_GIVEN | BEFORE_GIVEN, Quantity::Velocity(sphere, moment, _)) => of_given(show, sphere, moment),
        (MASS, _) => mass(show),
        (COMPONENTS, Quantity::Impulse(sphere, X)) if is_vector(rule, show) => along_the_line(show, sphere),
        (REACTION, Quantity::Impulse(sphere, X)) if is_vector(rule, show) => opposite(show, sphere),
        (SIZE, _) => size(show, None),
        (SIZE_OF_VECTOR, _) => size(show, Some([X, Y].map(|axis| show.exact(Quantity::Impulse(Sphere::A, axis))))),
        _ => silent(),
    }
}

/// `I = m (w - u)` along the line of centres.
fn along(show: &Show, sphere: Sphere) -> Vec<Line> {
    let at = |moment| show.worked(velocity(sphere, moment, N));
    let (before, after) = (show.along(sphere, Before), written(&at(After)));
    let change = difference(after, before);
    let impulse = Quantity::Impulse(sphere, N);
    let rights = [times(show.mass(sphere), change), show.shown_value(impulse)];
    let words = "The impulse on {B} is its change of momentum along the line of centres:";
    vec![Line::with(words, &[("B", Expr::name(sphere.name()))], Show::chain(show.name("I"), rights))]
}

/// Is it asked for along i and j, which a straight line does not have?
fn is_vector(rule: &Rule, show: &Show) -> bool {
    show.is_asked(rule.gives[0]) && show.scene().setting != Setting::Direct
}

/// `I = 5(3i/5 + 4j/5)`: so much along the unit vector of the line of centres, in the positive direction of the working.
fn along_the_line(show: &Show, sphere: Sphere) -> Vec<Line> {
    let turned = |value: Value| if show.is_against_n() { -value } else { value };
    let unit = [X, Y].map(|axis| Box::new(written(&turned(show.exact(Quantity::Line(axis))))));
    let [x, y] = unit;
    let along = times(show.shown_value(Quantity::Impulse(sphere, N)), Expr::Vector(x, y));
    let words = "The impulse on {A} acts along the line of centres:";
    let equations = Show::chain(show.vector_name("I"), [along, found(show, sphere)]);
    vec![Line::with(words, &[("A", Expr::name(sphere.name()))], equations)]
}

/// `-I`, where `I` is the impulse on the other sphere.
fn opposite(show: &Show, sphere: Sphere) -> Vec<Line> {
    let words = "The impulse on {A} is equal and opposite:";
    let equation = Expr::equation(show.vector_name("I").negated(), found(show, sphere));
    vec![Line::with(words, &[("A", Expr::name(sphere.name()))], vec![equation])]
}

/// The impulse on a sphere along i and j.
fn found(show: &Show, sphere: Sphere) -> Expr {
    let [x, y] = [X, Y].map(|axis| Box::new(show.value(Quantity::Impulse(sphere, axis))));
    Expr::Vector(x, y)
}

/// `I = m (v - u)` as a vector.
fn vector(show: &Show, sphere: Sphere) -> Vec<Line> {
    let change = difference(show.vector(sphere, After), show.vector(sphere, Before));
    let at = |axis| Box::new(show.value(Quantity::Impulse(sphere, axis)));
    let rights = [times(show.mass(sphere), change), Expr::Vector(at(X), at(Y))];
    let words = "The impulse on {A} is its change of momentum:";
    vec![Line::with(words, &[("A", Expr::name(sphere.name()))], Show::chain(show.vector_name("I"), rights))]
}

/// `m v = m u + I`, for the velocity that is not given.
fn of_given(show: &Show, sphere: Sphere, moment: Moment) -> Vec<Line> {
    let at = |axis| Box::new(show.value(Quantity::Impulse(sphere, axis)));
    let impulse = Expr::Vector(at(X), at(Y));
    let momentum = |of: Moment| match of == moment {
        true => times(show.mass(sphere), Expr::name(show.vector_letter(sphere, moment))),
        false => times(show.mass(sphere), show.vector(sphere, of)),
    };
    let equation = Expr::equation(impulse, difference(momentum(After), momentum(Before)));
    let name = Expr::name(show.vector_letter(sphere, moment));
    let mut equations = vec![equation, Expr::equation(name.clone(), show.vector(sphere, moment))];
    equations.extend(show.approximate_velocity(&name, sphere, moment));
    let words = "The impulse on {A} is its change of momentum:";
    vec![Line::with(words, &[("A", Expr::name(sphere.name()))], equations)]
}

/// `I = m (v - u)`, for the mass.
fn mass(show: &Show) -> Vec<Line> {
    let at = |axis| Box::new(written(&show.exact(Quantity::GivenImpulse(axis))));
    let name = show.symbol(Quantity::Mass(Sphere::A));
    let change = difference(show.vector(Sphere::A, After), show.vector(Sphere::A, Before));
    let equation = Expr::equation(Expr::Vector(at(X), at(Y)), times(name.clone(), change));
    let found = Expr::equation(name, show.shown_value(Quantity::Mass(Sphere::A)));
    let words = "The impulse on {A} is its change of momentum:";
    vec![Line::with(words, &[("A", Expr::name("A"))], vec![equation, found])]
}

/// The magnitude, of a vector by Pythagoras, with its decimal.
fn size(show: &Show, vector: Option<[Value; 2]>) -> Vec<Line> {
    let value = show.exact(Quantity::ImpulseMagnitude);
    let left = Expr::call(Function::Abs, show.name("I"));
    let root = vector.filter(|sides| sides.iter().all(|side| !side.is_zero())).map(|sides| {
        let squares = sides.iter().map(|side| written(&side.absolute()).to_the(2));
        Expr::call(Function::Sqrt, Expr::sum(squares))
    });
    let mut equations = Show::chain(left.clone(), root.into_iter().chain([written(&value)]));
    equations.extend(Show::approximately(&left, &value));
    let words = format!("So the magnitude of the impulse{} is", show.in_units(&value, "newton seconds"));
    vec![Line::plain(&words, equations)]
}
