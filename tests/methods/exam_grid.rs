//! The grid of exam impacts: masses 1 to 9 without a common factor, e of denominators to 10, whole speeds from -9 to 9.
//!
//! Every velocity is rounded to three figures and compared with the half-up rounding of the fraction that whole numbers give.

use carom::method::{Impact, Numbers, figures};
use carom::number::{Fraction, Places, Value, round};

/// One of so many is tried where the checks that take their time are left out.
const SHARE: usize = if cfg!(feature = "external") { 1 } else { 60 };

fn coprime(mut a: i64, mut b: i64) -> bool {
    while b != 0 {
        (a, b) = (b, a % b);
    }
    a == 1
}

/// Masses, e as numerator and denominator, both velocities before: A faster than B.
fn grid() -> Vec<([i64; 2], [i64; 2], [i64; 2])> {
    let pairs = |range: std::ops::RangeInclusive<i64>| {
        let all = range.clone().flat_map(move |a| range.clone().map(move |b| [a, b]));
        all.collect::<Vec<_>>()
    };
    let masses: Vec<_> = pairs(1..=9).into_iter().filter(|[a, b]| coprime(*a, *b)).collect();
    let farey: Vec<_> = pairs(0..=10).into_iter().filter(|[p, q]| p <= q && coprime(*p, *q)).collect();
    let speeds: Vec<_> = pairs(-9..=9).into_iter().filter(|[a, b]| a > b).collect();
    let mut grid = Vec::new();
    for masses in &masses {
        for e in &farey {
            grid.extend(speeds.iter().map(|speeds| (*masses, *e, *speeds)));
        }
    }
    grid
}

#[test]
fn carom_knows_three_figures_of_every_exam_impact() {
    let grid = grid();
    assert_eq!(grid.len(), 310_365);
    let three = Places::SignificantFigures(3);
    for ([m_a, m_b], [p, q], [a, b]) in grid.into_iter().step_by(SHARE) {
        let impact = Impact {
            masses: [m_a, m_b].map(Value::from),
            before: [a, b].map(|speed| [Value::from(speed), Value::ZERO]),
            line: [Value::ONE, Value::ZERO],
            restitution: Value::fraction(p, q),
        };
        let below = q * (m_a + m_b);
        let above = [(q * m_a - p * m_b) * a + (p + q) * m_b * b, (p + q) * m_a * a + (q * m_b - p * m_a) * b];
        let expected = above.map(|above| round(&Fraction::new(above, below), &three));
        let (after, tier) = figures(&impact, &three).unwrap();
        assert_eq!((&after[0][0], &after[1][0]), (&expected[0], &expected[1]), "{impact:?}");
        assert_eq!(tier, Numbers::Integers);
    }
}
