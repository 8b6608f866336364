//! The operations that each geometry takes, counted by a number that counts.

use std::cell::Cell;
use std::ops::{Add, Mul, Neg, Sub};

use carom::method::{Geometry, Impact};
use carom::number::{Fraction, Number};

/// Additions and subtractions, multiplications, divisions, and special functions.
type Counts = [u32; 4];

thread_local!(static COUNTS: Cell<Counts> = const { Cell::new([0; 4]) });

fn count(place: usize) {
    COUNTS.with(|counts| {
        let mut all = counts.get();
        all[place] += 1;
        counts.set(all);
    });
}

/// A double that counts what is done to it.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Counting(f64);

impl Add for Counting {
    type Output = Counting;
    fn add(self, other: Counting) -> Counting {
        count(0);
        Counting(self.0 + other.0)
    }
}

impl Sub for Counting {
    type Output = Counting;
    fn sub(self, other: Counting) -> Counting {
        count(0);
        Counting(self.0 - other.0)
    }
}

impl Mul for Counting {
    type Output = Counting;
    fn mul(self, other: Counting) -> Counting {
        count(1);
        Counting(self.0 * other.0)
    }
}

impl Neg for Counting {
    type Output = Counting;
    fn neg(self) -> Counting {
        Counting(-self.0)
    }
}

impl Number for Counting {
    fn scaled(&self, factor: &Fraction) -> Counting {
        if factor.is_zero() {
            return Counting(0.0);
        }
        count(1);
        Counting(self.0 * factor.to_f64())
    }
    fn one(&self) -> Counting {
        Counting(1.0)
    }
    fn over(&self, divisor: &Counting) -> Option<Counting> {
        count(2);
        (divisor.0 != 0.0).then(|| Counting(self.0 / divisor.0))
    }
    fn root(&self) -> Option<Counting> {
        count(3);
        Some(Counting(self.0.sqrt()))
    }
    fn size(&self) -> Counting {
        Counting(self.0.abs())
    }
    fn is_nought(&self) -> bool {
        self.0 == 0.0
    }
}

#[test]
fn carom_knows_what_each_geometry_costs() {
    let scenes = [
        (Geometry::AtRest, [[3.0, 0.0], [0.0, 0.0]], [1.0, 0.0], [3, 3, 1, 0]),
        (Geometry::HeadOn, [[3.0, 0.0], [-1.0, 0.0]], [1.0, 0.0], [5, 3, 1, 0]),
        (Geometry::Axis, [[3.0, 2.0], [-1.0, 4.0]], [1.0, 0.0], [5, 3, 1, 0]),
        (Geometry::AnyLine, [[3.0, 2.0], [-1.0, 4.0]], [3.0, 4.0], [10, 12, 1, 0]),
    ];
    for (geometry, before, line, expected) in scenes {
        let impact = Impact { masses: [2.0, 3.0], before, line, restitution: 0.5 };
        let counting = impact.turned_into(|number| Some(Counting(*number))).unwrap();
        COUNTS.set([0; 4]);
        let after = geometry.solve(&counting).unwrap();
        assert_eq!(COUNTS.get(), expected, "{geometry:?}: additions, multiplications, divisions, special functions");
        // It has counted the whole of an impact, and not of something else.
        let right = Geometry::AnyLine.solve(&impact).unwrap();
        for (one, other) in after.as_flattened().iter().zip(right.as_flattened()) {
            assert!((one.0 - other).abs() < 1e-12, "{geometry:?}");
        }
    }
}
