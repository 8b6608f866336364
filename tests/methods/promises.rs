//! Every method keeps its promise on every impact that it takes: floats within their bound, enclosures around the truth.

use carom::method::{Found, Impact, METHODS, Method, Needs, Numbers, Promise, Role, Wanted, solve_once};
use carom::number::{Interval, Value};

use super::corpus::grid;
use super::sufficiency::{is_right, top};

/// The larger speed before.
fn fastest(impact: &Impact<Value>) -> f64 {
    let size = |[x, y]: &[Value; 2]| x.to_f64().unwrap().hypot(y.to_f64().unwrap());
    impact.before.iter().map(size).fold(0.0, f64::max)
}

fn kept(method: &dyn Method, impact: &Impact<Value>, found: &Found, truth: &[[Value; 2]; 2]) -> bool {
    let truths = truth.as_flattened().iter();
    match (method.promises(), found) {
        (_, Found::Missed(_)) => method.role() == Role::Exhibit || method.name() == "letters",
        (Promise::Exact, _) => is_right(found, truth),
        (Promise::Enclosed, Found::Enclosed(after)) => {
            let holds =
                |(interval, value): (&Interval, &Value)| interval.overlaps(&value.enclose_constant(300).unwrap());
            after.as_flattened().iter().zip(truths).all(holds)
        }
        (Promise::Scaled(roundoffs), Found::Float(after)) => {
            let allowed = roundoffs * f64::EPSILON / 2.0 * fastest(impact);
            let near = |(found, value): (&f64, &Value)| (found - value.to_f64().unwrap()).abs() <= allowed;
            after.as_flattened().iter().zip(truths).all(near)
        }
        (Promise::Nothing(_), _) => true,
        _ => false,
    }
}

#[test]
fn carom_knows_that_its_methods_keep_their_promises() {
    let mut runs = vec![0; METHODS.len()];
    for impact in grid() {
        let Some(truth) = top(&impact) else { continue };
        for (method, runs) in METHODS.iter().zip(&mut runs) {
            let Ok(found) = solve_once(*method, &impact) else { continue };
            assert!(kept(*method, &impact, &found, &truth), "{} finds {found:?} of {impact:?}", method.name());
            *runs += 1;
        }
    }
    for (method, runs) in METHODS.iter().zip(runs) {
        assert!(runs >= 12, "{} ran {runs} times", method.name());
    }
}

/// Is the reason that a method gives for a refusal true of the impact?
fn is_true(why: &str, impact: &Impact<Value>) -> bool {
    let letters = impact.numbers().any(|value| !value.is_constant());
    match why {
        _ if why.contains("letters") => letters,
        _ if why.contains("neither axis") => !impact.line.iter().any(Value::is_zero),
        _ if why.contains("e = 0") => impact.restitution.is_zero(),
        _ => Numbers::Integers.lacks().iter().any(|need| Needs::of(impact, Wanted::ExactForm).has(*need)),
    }
}

#[test]
fn carom_knows_that_a_method_refuses_only_what_it_must() {
    for impact in grid() {
        for method in METHODS.iter().filter(|method| method.role() != Role::AnswerPath) {
            if let Err(skip) = solve_once(*method, &impact) {
                assert!(is_true(&skip.why, &impact), "{} refuses {impact:?}: {}", method.name(), skip.why);
            }
        }
    }
}

#[test]
fn carom_knows_its_methods_by_name() {
    for tier in Numbers::ALL {
        assert_eq!(tier.method().name(), tier.name());
        assert_eq!(tier.method().role(), Role::AnswerPath);
    }
    for one in METHODS {
        assert_eq!(METHODS.iter().filter(|other| other.name() == one.name()).count(), 1, "{}", one.name());
        let tiers = Numbers::ALL.iter().filter(|tier| tier.name() == one.name()).count();
        assert_eq!(tiers, usize::from(one.role() == Role::AnswerPath), "{} is a tier", one.name());
    }
}
