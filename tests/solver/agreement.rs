//! The same derivation in exact, certified and float numbers, and random scenes before a judge.

use std::fmt::Display;
use std::thread;

use carom::mechanics::{Datum, Derivation, Known, Quantity, pose};
use carom::method::{Found, Impact, METHODS, Role, solve_once};
use carom::number::{Fraction, Interval, Number, Value};
use dashu_ratio::RBig;
use rand::RngExt;
use rand::rngs::ChaCha8Rng;

use super::judge::{Outcome, approach, judge, to_judge};
use super::scenes::{AFTER, Forward, Kind, generator, random, read};

/// What is known, in another kind of number; `None` where one has no such form.
pub fn turned_into<N: Number>(known: &Known<Value>, into: impl Fn(&Value) -> Option<N>) -> Option<Known<N>> {
    let mut turned = Known::default();
    for (quantity, datum) in known.0.iter() {
        let datum = match datum {
            Datum::Number(value) => Datum::Number(into(value)?),
            Datum::Direction { y, x } => Datum::Direction { y: into(y)?, x: into(x)? },
            Datum::Equation([p, q, r]) => Datum::Equation([into(p)?, into(q)?, into(r)?]),
        };
        turned.0.insert(*quantity, datum);
    }
    Some(turned)
}

fn close(float: f64, exact: f64) -> bool {
    (float - exact).abs() <= 1e-9 * exact.abs().max(1.0)
}

/// Compares the evaluations of one derivation in certified and float numbers with the exact one; the number of
/// quantities compared.
pub fn agree(given: &Known<Value>, derivation: &Derivation, exact: &Known<Value>, scene: &dyn Display) -> usize {
    let mut certified = turned_into(given, |value| value.enclose_constant(160)).unwrap();
    let mut float = turned_into(given, Value::to_f64).unwrap();
    let at = |what: &str, quantity: &Quantity| format!("{what} {quantity}\n{scene}");
    // An interval that cannot tell nought from its neighbours may stop at a quotient that exists.
    let _ = derivation.evaluate(&mut certified);
    derivation.evaluate(&mut float).unwrap_or_else(|end| panic!("{end:?} in floats\n{scene}"));
    let mut compared = 0;
    for (quantity, datum) in exact.0.iter() {
        match datum {
            Datum::Number(value) => {
                let truth = value.enclose_constant(256).unwrap();
                assert!(close(float.number(*quantity).unwrap(), truth.to_f64()), "{}", at("float", quantity));
                if let Some(interval) = certified.number(*quantity) {
                    assert!(interval.overlaps(&truth), "{}", at("interval", quantity));
                    assert!(interval.width() < Fraction::new(1, 1 << 62), "{}", at("wide interval of", quantity));
                    compared += 1;
                }
            }
            Datum::Direction { y, x } => {
                let truth = Interval::atan2(&y.enclose_constant(256).unwrap(), &x.enclose_constant(256).unwrap());
                let (y, x) = float.direction(*quantity).unwrap();
                if let Some(truth) = truth {
                    let turns = (y.atan2(x) - truth.to_f64()) / std::f64::consts::TAU;
                    assert!((turns - turns.round()).abs() < 1e-9, "{}", at("float", quantity));
                    let certified = certified.direction(*quantity).and_then(|(y, x)| Interval::atan2(&y, &x));
                    if let Some(interval) = certified {
                        assert!(interval.overlaps(&truth), "{}", at("interval", quantity));
                        compared += 1;
                    }
                }
            }
            Datum::Equation(_) => {}
        }
    }
    compared
}

fn compare(scene: &Forward, asked: &[Quantity]) -> usize {
    let given = pose(&read(&scene.json())).unwrap();
    let mut exact = given.clone();
    let (derivation, _) = Derivation::carry_out(&mut exact, asked);
    agree(&given, &derivation, &exact, &scene.json())
}

#[test]
fn carom_knows_the_same_in_exact_certified_and_float_numbers() {
    let everything = Quantity::all();
    // The tangents of a velocity with surds and a given degree in it are long: fewer of those.
    for (kind, count) in [(Kind::Rational, 300), (Kind::Surd, 60), (Kind::Degrees, 40)] {
        let mut numbers = generator(21);
        let mut compared = 0;
        for _ in 0..count {
            compared += compare(&random(kind, &mut numbers), &everything);
        }
        assert!(compared > 60 * count, "{kind:?}: only {compared} quantities were compared");
    }
}

/// A scene of small fractions, in numbers of the judge's own.
struct Judged {
    scene: Forward,
    masses: [RBig; 2],
    before: [[RBig; 2]; 2],
    line: [RBig; 2],
    e: RBig,
}

fn rational(numerator: i64, denominator: u64) -> RBig {
    RBig::from_parts(numerator.into(), denominator.into())
}

fn judged(numbers: &mut ChaCha8Rng) -> Judged {
    let mut quotient = |low: i64, high: i64| {
        let (above, below) = (numbers.random_range(low..=high), numbers.random_range(1..=3_u64));
        (format!("{above}/{below}"), rational(above, below))
    };
    let masses = [quotient(1, 9), quotient(1, 9)];
    let velocities = [[quotient(-9, 9), quotient(-9, 9)], [quotient(-9, 9), quotient(-9, 9)]];
    let mut line = [numbers.random_range(-5..=5), numbers.random_range(-5..=5)];
    if line == [0, 0] {
        line = [1, 0];
    }
    let below = numbers.random_range(1..=6_u64);
    let above = numbers.random_range(0..=below as i64);
    let scene = Forward {
        masses: masses.each_ref().map(|(text, _)| text.clone()),
        before: velocities.each_ref().map(|v| v.each_ref().map(|(text, _)| text.clone())),
        line: line.map(|component| component.to_string()),
        e: format!("{above}/{below}"),
    };
    Judged {
        scene,
        masses: masses.map(|(_, value)| value),
        before: velocities.map(|v| v.map(|(_, value)| value)),
        line: line.map(|component| rational(component, 1)),
        e: rational(above, below),
    }
}

/// Solves and judges scenes; half of the random ones part instead of meeting, and are turned round.
fn judge_many(seed: u64, count: usize) {
    let mut numbers = generator(seed);
    let mut done = 0;
    while done < count {
        let mut case = judged(&mut numbers);
        let approach = approach(&case.before, &case.line);
        if approach == RBig::ZERO {
            assert!(case.scene.solve(&AFTER).is_err(), "no approach\n{}", case.scene.json());
            continue;
        }
        if approach < RBig::ZERO {
            case.scene = case.scene.turned_round();
            case.line = case.line.map(|component| -component);
        }
        let [a, b, c, d] = AFTER;
        let asked = [a, b, c, d, Quantity::EnergyLost];
        let solution = case.scene.solve(&asked).unwrap_or_else(|r| panic!("{r}\n{}", case.scene.json()));
        let values = AFTER.map(|quantity| solution.number(quantity).unwrap());
        let rational = |quantity: Quantity| {
            let value = solution.number(quantity).unwrap();
            to_judge(&value).unwrap_or_else(|| panic!("{value:?} is rational\n{}", case.scene.json()))
        };
        let [a_x, a_y, b_x, b_y, lost] = asked.map(rational);
        let outcome = Outcome {
            masses: case.masses.clone(),
            before: case.before.clone(),
            after: [[a_x, a_y], [b_x, b_y]],
            line: case.line.clone(),
            e: case.e.clone(),
            lost,
        };
        if let Err(law) = judge(&outcome) {
            panic!("{law}\n{}", case.scene.json());
        }
        methods_agree(&case, &values);
        done += 1;
    }
}

fn methods_agree(case: &Judged, values: &[Value; 4]) {
    let exact = |number: &RBig| {
        let below = dashu_int::IBig::from(number.denominator().clone());
        Value::from(Fraction::from_integers(number.numerator().clone(), below).unwrap())
    };
    let impact = Impact {
        masses: case.masses.each_ref().map(exact),
        before: case.before.each_ref().map(|velocity| velocity.each_ref().map(exact)),
        line: case.line.each_ref().map(exact),
        restitution: exact(&case.e),
    };
    for method in METHODS.iter().filter(|method| method.role() != Role::Exhibit) {
        let found = solve_once(*method, &impact);
        let right = match &found {
            Ok(Found::Exact(after)) => after.as_flattened() == values,
            Ok(Found::Enclosed(after)) => {
                let holds = |(found, value): (&Interval, &Value)| found.contains(value.as_fraction().unwrap());
                after.as_flattened().iter().zip(values).all(holds)
            }
            Ok(Found::Float(after)) => {
                // Single precision has seven figures.
                let allowed = if method.name() == "single" { 1e-4 } else { 1e-9 };
                let near = |(found, value): (&f64, &Value)| (found - value.to_f64().unwrap()).abs() <= allowed;
                after.as_flattened().iter().zip(values).all(near)
            }
            Err(skip) => !case.line.contains(&RBig::ZERO) && skip.why.ends_with("neither axis"),
            Ok(Found::Missed(_)) => false,
        };
        assert!(right, "{} finds {found:?}\n{}", method.name(), case.scene.json());
    }
}

/// So many scenes in each of two threads.
fn impacts_before_a_judge(scenes: usize) {
    thread::scope(|scope| {
        for seed in [31, 32] {
            scope.spawn(move || judge_many(seed, scenes));
        }
    });
}

#[test]
fn carom_knows_thousands_of_impacts_as_an_independent_judge_does() {
    impacts_before_a_judge(7_500);
}

#[test]
#[ignore = "takes half a minute; `.ci/run` runs it"]
fn carom_knows_a_hundred_thousand_impacts_as_an_independent_judge_does() {
    impacts_before_a_judge(50_000);
}
