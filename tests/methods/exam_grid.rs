//! The grid of exam impacts: masses 1 to 9 without a common factor, e of denominators to 10, whole speeds from -9 to 9.
//!
//! Every velocity is rounded to three figures and compared with the half-up rounding of the fraction that whole numbers give.

use carom::method::{Found, Geometry, Impact, Numbers, figures};
use carom::number::{Fraction, Places, Value, round};

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

/// The impact of a place of the grid.
fn impact([m_a, m_b]: [i64; 2], [p, q]: [i64; 2], [a, b]: [i64; 2]) -> Impact<Value> {
    Impact {
        masses: [m_a, m_b].map(Value::from),
        before: [a, b].map(|speed| [Value::from(speed), Value::ZERO]),
        line: [Value::ONE, Value::ZERO],
        restitution: Value::fraction(p, q),
    }
}

/// Both velocities after, by whole numbers alone.
fn truth([m_a, m_b]: [i64; 2], [p, q]: [i64; 2], [a, b]: [i64; 2]) -> [Fraction; 2] {
    let below = q * (m_a + m_b);
    let above = [(q * m_a - p * m_b) * a + (p + q) * m_b * b, (p + q) * m_a * a + (q * m_b - p * m_a) * b];
    above.map(|above| Fraction::new(above, below))
}

/// Does it lie half-way between two roundings to three figures?
fn is_tie(value: &Fraction, three: &Places) -> bool {
    let rounded = round(value, three).to_fraction();
    let next = &(value + value) - &rounded;
    rounded != *value && round(&next, three).to_fraction() == next
}

#[test]
fn carom_knows_what_a_certified_float_leaves_open() {
    let three = Places::SignificantFigures(3);
    let cases: Vec<_> = grid();
    let impacts: Vec<Impact<Value>> = cases.iter().map(|(masses, e, speeds)| impact(*masses, *e, *speeds)).collect();
    let mut batch = Numbers::CertifiedFloat.prepare(&impacts, Geometry::HeadOn).unwrap();
    batch.run();
    let mut open = 0;
    for ((masses, e, speeds), found) in cases.iter().zip(batch.found()) {
        let Found::Enclosed([[a, _], [b, _]]) = found else { panic!("{found:?}") };
        for (enclosure, value) in [a, b].iter().zip(truth(*masses, *e, *speeds)) {
            assert!(enclosure.contains(&value));
            let settled = round(&enclosure.lower(), &three) == round(&enclosure.upper(), &three);
            assert_eq!(settled, !value.is_zero() && !is_tie(&value, &three), "{value} in {enclosure:?}");
            open += usize::from(!settled);
        }
    }
    let share = open as f64 / (2 * cases.len()) as f64;
    assert!((0.03..0.05).contains(&share), "{share} of all are left open");
    // All ties and all noughts of the grid.
    assert_eq!(open, 22_890 + 2_104);
}

#[test]
fn carom_knows_three_figures_of_every_exam_impact() {
    let grid = grid();
    assert_eq!(grid.len(), 310_365);
    let three = Places::SignificantFigures(3);
    for (masses, e, speeds) in grid {
        let impact = impact(masses, e, speeds);
        let expected = truth(masses, e, speeds).map(|value| round(&value, &three));
        let (after, tier) = figures(&impact, &three).unwrap();
        assert_eq!((&after[0][0], &after[1][0]), (&expected[0], &expected[1]), "{impact:?}");
        assert_eq!(tier, Numbers::Integers);
    }
}
