//! Momentum is conserved along the line of centres.
//!
//! `m_A a + m_B b = m_A x + m_B y` for the components a, b before and x, y after, all positive from A
//! to B.

use smallvec::smallvec;

use super::{Seen, ALONG, Datum, Here, Law, Line, MASSES, Outcome, Rule, Show, Slip, number, rule, first_equation, unresolved, with_inputs};
use crate::expr::Expr;
use crate::mechanics::Quantity;
use crate::number::Number;

pub const NAME: &str = "momentum";

pub const SEEN: Seen = Seen::Equation;

pub const ACCURACY: &str = "correct equation, unsimplified";

pub const METHOD: (&str, &str) = (
    "conservation of momentum along the line of centres, all terms",
    "condone sign errors and sine for cosine; each mass with its own velocity",
);

pub const SLIPS: &[Slip] = &[
    Slip {
        place: 2,
        tag: "not-resolved",
        did: "put the full speeds into both equations",
        sentence: "Momentum and restitution are about motion along the line of centres: find the component of each velocity along it first.",
        also: &[Law::Restitution],
        condoned: false,
    },
    Slip {
        place: 8,
        tag: "momentum-sign",
        did: "counted the momentum of B as positive although B moves towards A",
        sentence: "B moves the other way, so its momentum counts as negative.",
        also: &[],
        condoned: true,
    },
    Slip {
        place: 10,
        tag: "momentum-ignores-b",
        did: "left the momentum of B before the impact out",
        sentence: "B was moving before the impact too: its momentum belongs in the equation.",
        also: &[],
        condoned: false,
    },
    Slip {
        place: 16,
        tag: "masses-swapped",
        did: "gave each sphere the mass of the other",
        sentence: "Each velocity goes with the mass of its own sphere: check which mass is whose.",
        also: &[Law::VectorMomentum],
        condoned: false,
    },
    Slip {
        place: 17,
        tag: "masses-omitted",
        did: "left the masses out",
        sentence: "Momentum is mass times velocity, and these masses do not cancel.",
        also: &[Law::VectorMomentum],
        condoned: false,
    },
];

/// The forms: an equation for two unknowns, or the one unknown, in the order a, b, x, y, m_A, m_B.
const EQUATION: u8 = 0;
/// The ratio of the masses, where neither is given.
const MASS_RATIO: u8 = 7;

pub fn rules() -> Vec<Rule> {
    let [a, b, x, y] = ALONG;
    let [m_a, m_b] = MASSES;
    let all = [a, b, x, y, m_a, m_b];
    let mut rules = vec![rule(Law::Momentum, EQUATION, &[m_a, m_b, a, b], &[Quantity::MomentumEquation], 1)];
    rules.push(rule(Law::Momentum, MASS_RATIO, &ALONG, &[Quantity::MassRatio], 8));
    for (index, unknown) in all.into_iter().enumerate() {
        let needs: Vec<Quantity> = all.into_iter().filter(|quantity| *quantity != unknown).collect();
        rules.push(rule(Law::Momentum, index as u8 + 1, &needs, &[unknown], 2));
    }
    rules
}

pub fn evaluate<N: Number>(rule: &Rule, known: &Here<N>) -> Outcome<N> {
    let at = |quantity| known.number(quantity);
    let [a, b, x, y] = ALONG;
    let [m_a, m_b] = MASSES;
    match rule.form {
        EQUATION => {
            let [m_a, m_b, a, b] = known.numbers([m_a, m_b, a, b])?;
            Some(smallvec![Datum::Equation([m_a.clone(), m_b.clone(), m_a * a + m_b * b])])
        }
        1 => number(at(x)? + (at(m_b)? * (at(y)? - at(b)?)).over(&at(m_a)?)?),
        2 => number(at(y)? + (at(m_a)? * (at(x)? - at(a)?)).over(&at(m_b)?)?),
        3 => number(at(a)? + (at(m_b)? * (at(b)? - at(y)?)).over(&at(m_a)?)?),
        4 => number(at(b)? + (at(m_a)? * (at(a)? - at(x)?)).over(&at(m_b)?)?),
        MASS_RATIO => {
            let [a, b, x, y] = known.numbers(ALONG)?;
            number((a - x).over(&(y - b))?)
        }
        5 => number((at(m_b)? * (at(y)? - at(b)?)).over(&(at(a)? - at(x)?))?),
        _ => number((at(m_a)? * (at(a)? - at(x)?)).over(&(at(y)? - at(b)?))?),
    }
}

pub fn slipped<N: Number>(slip: &str, rule: &Rule, known: &Here<N>) -> Outcome<N> {
    let [m_a, m_b] = MASSES;
    let b = ALONG[1];
    let at = |quantity| known.number(quantity);
    match slip {
        "not-resolved" if rule.form == EQUATION => with_inputs(rule, known, &unresolved(known)?),
        "momentum-sign" => with_inputs(rule, known, &[(b, at(b)?.size())]),
        "momentum-ignores-b" => with_inputs(rule, known, &[(b, at(b)?.nought())]),
        "masses-swapped" => with_inputs(rule, known, &[(m_a, at(m_b)?), (m_b, at(m_a)?)]),
        "masses-omitted" => {
            let one = at(m_a)?.one();
            with_inputs(rule, known, &[(m_a, one.clone()), (m_b, one)])
        }
        _ => None,
    }
}

/// What earns the mark for accuracy.
pub fn earning(rule: &Rule, show: &Show) -> Option<Expr> {
    first_equation(&lines(rule, show))
}

pub fn lines(rule: &Rule, show: &Show) -> Vec<Line> {
    let equation = Expr::equation(show.momentum_before(), show.momentum_after());
    let words = "Momentum is conserved along the line of centres:";
    if rule.form == EQUATION {
        let after = |quantity| Expr::name(show.letter_of(quantity));
        let letters = Line::with(
            &format!("Let {{v}} and {{w}} be the components of the velocities of *A* and *B* after the impact along the line of centres, positive {}.", show.positive()),
            &[("v", after(ALONG[2])), ("w", after(ALONG[3]))],
            vec![],
        );
        return vec![letters, Line::numbered(words, show.with_simplified(equation, Quantity::MomentumEquation))];
    }
    let unknown = rule.gives[0];
    let symbol = match rule.form {
        MASS_RATIO => show.symbol(MASSES[1]).over(show.symbol(MASSES[0])),
        _ => show.symbol(unknown),
    };
    vec![Line::plain(words, vec![equation, Expr::equation(symbol, show.shown_value(unknown))])]
}
