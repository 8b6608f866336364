//! Kinetic energy `½ m v²`, before, after and lost.
//!
//! The components across the line of centres do not change, so what a sphere loses is
//! `½ m (u_n² - v_n²)`.

use super::{Shape, Seen, Here, Law, Line, Outcome, Rule, Show, Slip, components, first_equation, full_speed, number, rule, silent, velocity};
use crate::expr::{Expr, written};
use crate::mechanics::Moment;
use crate::mechanics::formula::times;
use crate::number::{Fraction, Value};
use crate::mechanics::Axis::{N, T, X, Y};
use crate::mechanics::Moment::{After, Before};
use crate::mechanics::Sphere::{A, B};
use crate::mechanics::{Quantity, Setting, Sphere};
use crate::number::Number;

pub const NAME: &str = "energy";

pub const SEEN: Seen = Seen::Value(
    &[Quantity::EnergyLost, Quantity::FractionLost, Quantity::TotalEnergy(Before)],
    Shape::DifferenceOfSquares,
);

pub const ACCURACY: &str = "correct expression, unsimplified";

pub const METHOD: (&str, &str) =
    ("difference of kinetic energies, both spheres", "squares of components may leave out the unchanged ones on both sides");

pub const SLIPS: &[Slip] = &[
    Slip {
        place: 29,
        tag: "energy-square-of-difference",
        did: "squared the changes of velocity",
        sentence: "Find the energy before and the energy after and subtract: the square of a change is not the change of the squares.",
        also: &[],
        condoned: false,
    },
    Slip {
        place: 30,
        tag: "energy-one-sphere",
        did: "counted A alone",
        sentence: "Both spheres have kinetic energy: count both, before and after.",
        also: &[],
        condoned: false,
    },
    Slip {
        place: 31,
        tag: "energy-no-half",
        did: "left out the half",
        sentence: "Kinetic energy is half of mass times speed squared.",
        also: &[],
        condoned: false,
    },
    Slip {
        place: 32,
        tag: "energy-after-along-only",
        did: "left the components across out after the impact but not before it",
        sentence: "The components across the line of centres count after the impact as they do before it: keep them in both, or in neither.",
        also: &[],
        condoned: false,
    },
    Slip {
        place: 33,
        tag: "energy-components-added",
        did: "squared the sum of the components",
        sentence: "Square each component and then add: the square of a sum is something else.",
        also: &[],
        condoned: false,
    },
    Slip {
        place: 34,
        tag: "energy-by-e",
        did: "multiplied all the energy before the impact by 1 - e²",
        sentence: "Only the energy of the relative motion along the line of centres is reduced by e²; all the rest stays.",
        also: &[],
        condoned: false,
    },
    Slip {
        place: 35,
        tag: "fraction-remaining",
        did: "gave the fraction that is left",
        sentence: "That is the fraction that is left: the one that is lost is asked for.",
        also: &[],
        condoned: false,
    },
    Slip {
        place: 36,
        tag: "fraction-of-energy-along",
        did: "divided by the energy of the motion along the line of centres alone",
        sentence: "Divide by all the kinetic energy before the impact, the motion across the line of centres included.",
        also: &[],
        condoned: false,
    },
];

const OF_SPHERE: u8 = 0;
const LOST_ALONG: u8 = 1;
const LOST_IN_I_J: u8 = 2;
const LOST_BY_TOTALS: u8 = 3;
const LOST_BY_SPHERES: u8 = 4;
const TOTAL: u8 = 5;
const FRACTION: u8 = 6;
const FRACTION_BY_TOTALS: u8 = 7;
const OF_SPHERE_IN_I_J: u8 = 8;
const GAINED_ALONG: u8 = 9;
const GAINED_IN_I_J: u8 = 10;

pub fn rules() -> Vec<Rule> {
    let mut rules = Vec::new();
    let totals = [Quantity::TotalEnergy(Before), Quantity::TotalEnergy(After)];
    for sphere in Sphere::BOTH {
        let mass = Quantity::Mass(sphere);
        let at = |moment, axis| velocity(sphere, moment, axis);
        for moment in [Before, After] {
            let energy = Quantity::KineticEnergy(sphere, moment);
            rules.push(rule(Law::Energy, OF_SPHERE, &[mass, Quantity::Speed(sphere, moment)], &[energy], 1));
            rules.push(rule(Law::Energy, OF_SPHERE_IN_I_J, &[mass, at(moment, X), at(moment, Y)], &[energy], 2));
        }
        let lost = Quantity::SphereEnergyLost(sphere);
        rules.push(rule(Law::Energy, LOST_ALONG, &[mass, at(Before, N), at(After, N)], &[lost], 1));
        let x_y = [mass, at(Before, X), at(Before, Y), at(After, X), at(After, Y)];
        rules.push(rule(Law::Energy, LOST_IN_I_J, &x_y, &[lost], 1));
        let gained = Quantity::SphereEnergyGained(sphere);
        rules.push(rule(Law::Energy, GAINED_ALONG, &[mass, at(Before, N), at(After, N)], &[gained], 1));
        rules.push(rule(Law::Energy, GAINED_IN_I_J, &x_y, &[gained], 1));
    }
    for moment in [Before, After] {
        let both = [Quantity::KineticEnergy(A, moment), Quantity::KineticEnergy(B, moment)];
        rules.push(rule(Law::Energy, TOTAL, &both, &[Quantity::TotalEnergy(moment)], 1));
    }
    let spheres = [Quantity::SphereEnergyLost(A), Quantity::SphereEnergyLost(B)];
    rules.push(rule(Law::Energy, LOST_BY_SPHERES, &spheres, &[Quantity::EnergyLost], 1));
    rules.push(rule(Law::Energy, LOST_BY_TOTALS, &totals, &[Quantity::EnergyLost], 3));
    rules.push(rule(Law::Energy, FRACTION_BY_TOTALS, &totals, &[Quantity::FractionLost], 1));
    let lost = [Quantity::EnergyLost, Quantity::TotalEnergy(Before)];
    rules.push(rule(Law::Energy, FRACTION, &lost, &[Quantity::FractionLost], 4));
    rules
}

pub fn evaluate<N: Number>(rule: &Rule, known: &Here<N>) -> Outcome<N> {
    let n = &rule.needs;
    match rule.form {
        OF_SPHERE => {
            let [mass, speed] = known.numbers([n[0], n[1]])?;
            number((mass * speed.squared()).half())
        }
        OF_SPHERE_IN_I_J => {
            let [mass, x, y] = known.numbers([n[0], n[1], n[2]])?;
            number((mass * (x.squared() + y.squared())).half())
        }
        LOST_ALONG | GAINED_ALONG => {
            let [mass, before, after] = known.numbers([n[0], n[1], n[2]])?;
            // As a product, which loses no figures where the two are nearly equal.
            let lost = (mass * (before.clone() - after.clone()) * (before + after)).half();
            number(if rule.form == LOST_ALONG { lost } else { -lost })
        }
        LOST_IN_I_J | GAINED_IN_I_J => {
            let [mass, u_x, u_y, v_x, v_y] = known.numbers([n[0], n[1], n[2], n[3], n[4]])?;
            let lost = (mass * (u_x.squared() + u_y.squared() - v_x.squared() - v_y.squared())).half();
            number(if rule.form == LOST_IN_I_J { lost } else { -lost })
        }
        LOST_BY_SPHERES | TOTAL => number(known.number(n[0])? + known.number(n[1])?),
        LOST_BY_TOTALS => number(known.number(n[0])? - known.number(n[1])?),
        FRACTION => number(known.number(n[0])?.over(&known.number(n[1])?)?),
        _ => {
            let [before, after] = known.numbers([n[0], n[1]])?;
            number((before.clone() - after).over(&before)?)
        }
    }
}

pub fn slipped<N: Number>(slip: &str, rule: &Rule, known: &Here<N>) -> Outcome<N> {
    let n = &rule.needs;
    let gives_loss = rule.gives[0] == Quantity::EnergyLost;
    match (slip, rule.form) {
        ("energy-square-of-difference", _) if gives_loss => {
            let of = |sphere| -> Option<N> {
                let [[u_1, u_2], [v_1, v_2]] = [components(known, sphere, Before)?, components(known, sphere, After)?];
                half_of(known, sphere, (v_1 - u_1).squared() + (v_2 - u_2).squared())
            };
            number(of(A)? + of(B)?)
        }
        ("energy-one-sphere", LOST_BY_SPHERES | TOTAL) => number(known.number(n[0])?),
        ("energy-no-half", OF_SPHERE | OF_SPHERE_IN_I_J | LOST_ALONG | LOST_IN_I_J | GAINED_ALONG | GAINED_IN_I_J) => {
            let whole = evaluate(rule, known)?.pop()?;
            let super::Datum::Number(half) = whole else { return None };
            number(half.clone() + half)
        }
        ("energy-after-along-only", OF_SPHERE) => match rule.gives[0] {
            Quantity::KineticEnergy(sphere, After) => {
                number(half_of(known, sphere, known.number(velocity(sphere, After, N))?.squared())?)
            }
            _ => None,
        },
        ("energy-components-added", OF_SPHERE | OF_SPHERE_IN_I_J) => {
            let Quantity::KineticEnergy(sphere, moment) = rule.gives[0] else { return None };
            let [along, across] = components(known, sphere, moment)?;
            number(half_of(known, sphere, (along.size() + across.size()).squared())?)
        }
        ("energy-by-e", _) if gives_loss => {
            let of = |sphere| half_of(known, sphere, full_speed(known, sphere, Before)?.squared());
            number((of(A)? + of(B)?) * share_by_e(known)?)
        }
        ("energy-by-e", FRACTION | FRACTION_BY_TOTALS) => number(share_by_e(known)?),
        ("fraction-remaining", FRACTION_BY_TOTALS) => number(known.number(n[1])?.over(&known.number(n[0])?)?),
        ("fraction-of-energy-along", FRACTION_BY_TOTALS) => {
            let along = |sphere| half_of(known, sphere, known.number(velocity(sphere, Before, N))?.squared());
            number((known.number(n[0])? - known.number(n[1])?).over(&(along(A)? + along(B)?))?)
        }
        _ => None,
    }
}

/// `½ m` times a square.
fn half_of<N: Number>(known: &Here<N>, sphere: Sphere, square: N) -> Option<N> {
    Some((known.number(Quantity::Mass(sphere))? * square).half())
}

/// `1 - e²`
fn share_by_e<N: Number>(known: &Here<N>) -> Option<N> {
    let e = known.number(Quantity::Restitution)?;
    Some(e.one() - e.squared())
}

/// What earns the mark for accuracy.
pub fn earning(rule: &Rule, show: &Show) -> Option<Expr> {
    first_equation(&lines(rule, show))
}

pub fn lines(rule: &Rule, show: &Show) -> Vec<Line> {
    match (rule.form, rule.gives[0]) {
        (TOTAL, Quantity::TotalEnergy(moment)) => total(show, moment),
        (LOST_BY_SPHERES | LOST_BY_TOTALS, gives) => changed(show, show.spheres(), gives, show.letter("L"), "lost"),
        (_, gives @ Quantity::SphereEnergyLost(sphere)) if show.is_asked(gives) => {
            let (left, of) = if sphere == A { ("L_A", &[A]) } else { ("L_B", &[B]) };
            changed(show, of, gives, left, &format!("that *{}* loses", sphere.name()))
        }
        (_, gives @ Quantity::SphereEnergyGained(sphere)) if show.is_asked(gives) => {
            let (left, of) = if sphere == A { ("G_A", &[A]) } else { ("G_B", &[B]) };
            changed(show, of, gives, left, &format!("that *{}* gains", sphere.name()))
        }
        (form, Quantity::KineticEnergy(sphere, moment)) if show.is_asked(rule.gives[0]) => {
            of_sphere(show, sphere, moment, form == OF_SPHERE)
        }
        (FRACTION | FRACTION_BY_TOTALS, _) => fraction(rule.form, show),
        _ => silent(),
    }
}

/// `½ m`, the half written first.
fn half(show: &Show, sphere: Sphere) -> Expr {
    times(Expr::Number(Fraction::new(1, 2)), show.mass(sphere))
}

/// The energy of both spheres at a moment, by their speeds.
fn total(show: &Show, moment: Moment) -> Vec<Line> {
    let terms = show.spheres().iter().map(|sphere| times(half(show, *sphere), square(show, *sphere, moment)));
    let value = show.exact(Quantity::TotalEnergy(moment));
    let left = if moment == Before { "E_1" } else { "E_2" };
    let words = format!("The kinetic energy {moment} the impact{} is", show.in_units(&value, "joules"));
    vec![Line::plain(&words, Show::chain(Expr::name(left), [Expr::sum(terms), written(&value)]))]
}

/// The energy of one sphere at a moment, by its speed or by its components along i and j.
fn of_sphere(show: &Show, sphere: Sphere, moment: Moment, by_speed: bool) -> Vec<Line> {
    let squared = if by_speed { square(show, sphere, moment) } else { squares_in_i_j(show, sphere, moment) };
    let value = show.exact(Quantity::KineticEnergy(sphere, moment));
    let left = Expr::name(if sphere == A { "K_A" } else { "K_B" });
    let unit = show.in_units(&value, "joules");
    let words = format!("The kinetic energy of *{}* {moment} the impact{unit} is", sphere.name());
    let mut equations = Show::chain(left.clone(), [times(half(show, sphere), squared), written(&value)]);
    equations.extend(Show::approximately(&left, &value));
    vec![Line::plain(&words, equations)]
}

fn squares_in_i_j(show: &Show, sphere: Sphere, moment: Moment) -> Expr {
    let at = |axis| size_of(&show.exact(velocity(sphere, moment, axis))).to_the(2);
    Expr::Sum(vec![at(X), at(Y)])
}

/// The square of a speed: one that is long goes by its letter.
fn square(show: &Show, sphere: Sphere, moment: Moment) -> Expr {
    let speed = show.exact(Quantity::Speed(sphere, moment));
    let size = written(&speed);
    if speed.is_zero() {
        return Expr::integer(0);
    }
    if moment == Before || !Show::is_long(&size) {
        return size.to_the(2);
    }
    let at = |axis| show.exact(velocity(sphere, moment, axis));
    if at(T).is_zero() { show.symbol(velocity(sphere, moment, N)) } else { show.symbol(Quantity::Speed(sphere, moment)) }
        .to_the(2)
}

/// What spheres lose or gain, by the components that change.
fn changed(show: &Show, of: &[Sphere], gives: Quantity, left: &str, words: &str) -> Vec<Line> {
    let along = show.given_along();
    let is_gain = matches!(gives, Quantity::SphereEnergyGained(_));
    let terms = of.iter().map(|sphere| {
        let sphere = *sphere;
        let part = |moment| {
            if along {
                let component = velocity(sphere, moment, N);
                match squared(&show.worked(component)) {
                    // Its letter has been given its value.
                    long if moment == After && Show::is_long(&long) => show.symbol(component).to_the(2),
                    square => square,
                }
            } else {
                squares_in_i_j(show, sphere, moment)
            }
        };
        let [first, second] = if is_gain { [After, Before] } else { [Before, After] };
        times(half(show, sphere), difference_of(part(first), part(second)))
    });
    let value = show.exact(gives);
    let left = Expr::name(left);
    let mut equations = Show::chain(left.clone(), [Expr::sum(terms), written(&value)]);
    equations.extend(Show::approximately(&left, &value));
    let unit = show.in_units(&value, "joules");
    let words = if along && show.scene().setting != Setting::Direct {
        format!("The components perpendicular to the line of centres do not change, so the kinetic energy {words}{unit} is")
    } else {
        format!("The kinetic energy {words}{unit} is")
    };
    vec![Line::plain(&words, equations)]
}

fn size_of(value: &Value) -> Expr {
    written(&if value.sign() == Some(std::cmp::Ordering::Less) { -value } else { value.clone() })
}

/// The square of a component; nought is its own.
fn squared(value: &Value) -> Expr {
    if value.is_zero() { Expr::integer(0) } else { size_of(value).to_the(2) }
}

fn difference_of(first: Expr, second: Expr) -> Expr {
    if second.is_zero() {
        return first;
    }
    // A sum of two squares stays together in its bracket.
    Expr::Sum(vec![first, second.negated()])
}

/// What is lost, or the energies before and after whose difference it is, over the energy before.
fn fraction(form: u8, show: &Show) -> Vec<Line> {
    let (first, name) = match form {
        FRACTION => (Quantity::EnergyLost, show.letter("L")),
        _ => (Quantity::TotalEnergy(After), "E_2"),
    };
    let (first, before) = match [first, Quantity::TotalEnergy(Before)].map(|energy| show.value(energy)) {
        long if long.iter().any(Show::is_long) => (Expr::name(name), Expr::name("E_1")),
        [first, before] => (first, before),
    };
    let lost = if form == FRACTION { first } else { Expr::Sum(vec![before.clone(), first.negated()]) };
    let quotient = Expr::Quotient(Box::new(lost), Box::new(before));
    let (left, value) = (show.name("f"), show.exact(Quantity::FractionLost));
    let mut equations = Show::chain(left.clone(), [quotient, written(&value)]);
    equations.extend(Show::approximately(&left, &value));
    vec![Line::plain("The fraction of the kinetic energy that is lost is", equations)]
}
