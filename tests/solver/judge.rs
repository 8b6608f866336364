//! A judge of impacts with formulas of its own: exact for one whole outcome, in doubles for any one quantity.

use std::cmp::Ordering;
use std::ops::{Add, Mul, Sub};

use carom::mechanics::{Axis, Moment, Quantity, Sphere};
use carom::number::{Fraction, Value};
use dashu_int::UBig;
use dashu_ratio::RBig;

/// A kind of number in which an outcome can be judged: sums, products and what is nought.
pub trait Exact: Clone + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> {
    fn one() -> Self;
    fn is_nought(&self) -> bool;
    /// `None` where letters leave it open.
    fn sign(&self) -> Option<Ordering>;
}

impl Exact for RBig {
    fn one() -> RBig {
        RBig::ONE
    }
    fn is_nought(&self) -> bool {
        *self == RBig::ZERO
    }
    fn sign(&self) -> Option<Ordering> {
        Some(self.cmp(&RBig::ZERO))
    }
}

impl Exact for Value {
    fn one() -> Value {
        Value::ONE
    }
    fn is_nought(&self) -> bool {
        self.is_zero()
    }
    fn sign(&self) -> Option<Ordering> {
        Value::sign(self)
    }
}

/// An impact with all that happens in it.
#[derive(Clone, Debug)]
pub struct Outcome<N> {
    pub masses: [N; 2],
    pub before: [[N; 2]; 2],
    pub after: [[N; 2]; 2],
    /// A vector along the line of centres from A to B, of any length.
    pub line: [N; 2],
    pub e: N,
    /// The kinetic energy lost.
    pub lost: N,
}

fn dot<N: Exact>(a: &[N; 2], b: &[N; 2]) -> N {
    a[0].clone() * b[0].clone() + a[1].clone() * b[1].clone()
}

fn cross<N: Exact>(a: &[N; 2], b: &[N; 2]) -> N {
    a[0].clone() * b[1].clone() - a[1].clone() * b[0].clone()
}

fn minus<N: Exact>(a: &[N; 2], b: &[N; 2]) -> [N; 2] {
    [a[0].clone() - b[0].clone(), a[1].clone() - b[1].clone()]
}

/// The speed of approach along the line of centres, times the length of its vector.
pub fn approach<N: Exact>(before: &[[N; 2]; 2], line: &[N; 2]) -> N {
    dot(&minus(&before[0], &before[1]), line)
}

/// The first law that the outcome breaks. Separation is signed: energy alone does not tell spheres that pass
/// through each other. Signs that letters leave open are not complained of.
pub fn judge<N: Exact>(case: &Outcome<N>) -> Result<(), &'static str> {
    let [m_a, m_b] = &case.masses;
    let ([u_a, u_b], [v_a, v_b]) = (&case.before, &case.after);
    let negative = |number: &N| number.sign() == Some(Ordering::Less);
    if case.masses.iter().any(|mass| mass.is_nought() || negative(mass)) {
        return Err("positive masses");
    }
    for axis in [0, 1] {
        let gained =
            |mass: &N, after: &[N; 2], before: &[N; 2]| mass.clone() * (after[axis].clone() - before[axis].clone());
        if !(gained(m_a, v_a, u_a) + gained(m_b, v_b, u_b)).is_nought() {
            return Err("momentum");
        }
    }
    if [(u_a, v_a), (u_b, v_b)].into_iter().any(|(before, after)| !cross(&minus(after, before), &case.line).is_nought())
    {
        return Err("perpendicular components");
    }
    let (approach, separation) = (approach(&case.before, &case.line), dot(&minus(v_b, v_a), &case.line));
    if approach.is_nought() || negative(&approach) {
        return Err("approach");
    }
    if negative(&separation) || !(separation - case.e.clone() * approach.clone()).is_nought() {
        return Err("restitution");
    }
    if negative(&case.e) || negative(&(N::one() - case.e.clone())) {
        return Err("0 <= e <= 1");
    }
    let twice = |a: &[N; 2], b: &[N; 2]| m_a.clone() * dot(a, a) + m_b.clone() * dot(b, b);
    let twice_lost = twice(u_a, u_b) - twice(v_a, v_b);
    let inelastic = N::one() - case.e.clone() * case.e.clone();
    let expected = m_a.clone() * m_b.clone() * inelastic * approach.clone() * approach;
    if !(twice_lost.clone() * (m_a.clone() + m_b.clone()) * dot(&case.line, &case.line) - expected).is_nought()
        || !(case.lost.clone() + case.lost.clone() - twice_lost).is_nought()
        || negative(&case.lost)
    {
        return Err("energy");
    }
    Ok(())
}

impl Outcome<Value> {
    /// The same in another kind of number; `None` where one has no such form.
    pub fn turned_into<N>(&self, into: impl Fn(&Value) -> Option<N>) -> Option<Outcome<N>> {
        let pair = |[x, y]: &[Value; 2]| Some([into(x)?, into(y)?]);
        Some(Outcome {
            masses: pair(&self.masses)?,
            before: [pair(&self.before[0])?, pair(&self.before[1])?],
            after: [pair(&self.after[0])?, pair(&self.after[1])?],
            line: pair(&self.line)?,
            e: into(&self.e)?,
            lost: into(&self.lost)?,
        })
    }
}

/// A rational value for the judge.
pub fn to_judge(value: &Value) -> Option<RBig> {
    let number: &Fraction = value.as_fraction()?;
    Some(RBig::from_parts(number.numerator(), UBig::try_from(number.denominator()).ok()?))
}

/// A quantity by its definition, from masses and velocities in doubles; the line of centres may have any length.
pub fn by_definition(quantity: Quantity, case: &Outcome<f64>) -> Option<f64> {
    use Quantity::*;
    let size = case.line[0].hypot(case.line[1]);
    let n = [case.line[0] / size, case.line[1] / size];
    let t = [-n[1], n[0]];
    let times = |a: [f64; 2], b: [f64; 2]| a[0] * b[0] + a[1] * b[1];
    let turned = |a: [f64; 2], b: [f64; 2]| a[0] * b[1] - a[1] * b[0];
    let less = |a: [f64; 2], b: [f64; 2]| [a[0] - b[0], a[1] - b[1]];
    let along = |v: [f64; 2], axis: Axis| match axis {
        Axis::X => v[0],
        Axis::Y => v[1],
        Axis::N => times(v, n),
        Axis::T => times(v, t),
    };
    let mass = |s: Sphere| case.masses[s as usize];
    let v = |s: Sphere, m: Moment| if m == Moment::Before { case.before[s as usize] } else { case.after[s as usize] };
    let energy = |s: Sphere, m: Moment| mass(s) * times(v(s, m), v(s, m)) / 2.0;
    let total = |m: Moment| energy(Sphere::A, m) + energy(Sphere::B, m);
    let path = |s: Sphere| (v(s, Moment::Before), v(s, Moment::After));
    let [a, b] = Sphere::BOTH;
    let relative = less(v(a, Moment::Before), v(b, Moment::Before));
    Some(match quantity {
        Mass(s) => mass(s),
        Velocity(s, m, axis) => along(v(s, m), axis),
        Speed(s, m) => v(s, m)[0].hypot(v(s, m)[1]),
        KineticEnergy(s, m) => energy(s, m),
        SphereMomentum(s, m, axis) => mass(s) * along(v(s, m), axis),
        AngleToLine(s, m) => times(v(s, m), t).abs().atan2(times(v(s, m), n).abs()).to_degrees(),
        AngleFromN(s, m) => times(v(s, m), t).atan2(times(v(s, m), n)).to_degrees(),
        AngleFromI(s, m) => v(s, m)[1].atan2(v(s, m)[0]).to_degrees(),
        TanToLine(s, m) => (times(v(s, m), t) / times(v(s, m), n)).abs(),
        AngleToWall(s, m) => times(v(s, m), n).abs().atan2(times(v(s, m), t).abs()).to_degrees(),
        TanToWall(s, m) => (times(v(s, m), n) / times(v(s, m), t)).abs(),
        TOverN(s, m) => times(v(s, m), t) / times(v(s, m), n),
        Deflection(s) => turned(path(s).0, path(s).1).abs().atan2(times(path(s).0, path(s).1)).to_degrees(),
        SignedDeflection(s) => turned(path(s).0, path(s).1).atan2(times(path(s).0, path(s).1)).to_degrees(),
        DeflectionCross(s) => turned(path(s).0, path(s).1),
        DeflectionDot(s) => times(path(s).0, path(s).1),
        TanDeflection(s) => turned(path(s).0, path(s).1) / times(path(s).0, path(s).1),
        Impulse(s, axis) => mass(s) * along(less(path(s).1, path(s).0), axis),
        SphereEnergyLost(s) => energy(s, Moment::Before) - energy(s, Moment::After),
        SphereEnergyGained(s) => energy(s, Moment::After) - energy(s, Moment::Before),
        ImpulseMagnitude => {
            let change = less(path(a).1, path(a).0);
            mass(a) * change[0].hypot(change[1])
        }
        ImpulseAngle => {
            let change = less(path(a).1, path(a).0);
            change[1].abs().atan2(change[0].abs()).to_degrees()
        }
        Approach => times(relative, n),
        Separation => times(less(v(b, Moment::After), v(a, Moment::After)), n),
        Restitution => times(less(v(b, Moment::After), v(a, Moment::After)), n) / times(relative, n),
        MassRatio => mass(b) / mass(a),
        Line(axis) => along(n, axis),
        Tangent(axis) => along(t, axis),
        TotalEnergy(m) => total(m),
        EnergyLost => total(Moment::Before) - total(Moment::After),
        FractionLost => 1.0 - total(Moment::After) / total(Moment::Before),
        TotalMomentum(axis) => Sphere::BOTH.into_iter().map(|s| mass(s) * along(v(s, Moment::Before), axis)).sum(),
        AngleBetween(m) => turned(v(a, m), v(b, m)).abs().atan2(times(v(a, m), v(b, m))).to_degrees(),
        Alpha => times(relative, t).abs().atan2(times(relative, n).abs()).to_degrees(),
        GivenDirection(..) | GivenImpulse(_) | ContactSine | MomentumEquation | RestitutionEquation => return None,
        // Chains of impacts have a judge of their own.
        Later(_) | Meeting(_) | InALine => return None,
    })
}

/// A of mass 2 strikes B of mass 1 with velocity (3, 4); e = 1/2: A goes on with (3/2, 4), B with (3, 0).
fn by_hand() -> Outcome<Value> {
    let pair = |x: Value, y: i64| [x, Value::from(y)];
    Outcome {
        masses: pair(Value::from(2), 1),
        before: [pair(Value::from(3), 4), pair(Value::ZERO, 0)],
        after: [pair(Value::fraction(3, 2), 4), pair(Value::from(3), 0)],
        line: pair(Value::from(7), 0),
        e: Value::fraction(1, 2),
        lost: Value::fraction(9, 4),
    }
}

#[test]
fn carom_knows_that_its_judge_complains_of_every_broken_law() {
    let right = by_hand();
    let mut wrong: Vec<(&str, Outcome<Value>)> = Vec::new();
    let mut broken = |law, change: &dyn Fn(&mut Outcome<Value>)| {
        let mut case = right.clone();
        change(&mut case);
        wrong.push((law, case));
    };
    // A goes through B: momentum is kept and energy falls as it should, but A is still the faster.
    broken("restitution", &|case| {
        case.after = [[Value::fraction(5, 2), Value::from(4)], [Value::ONE, Value::ZERO]];
    });
    broken("restitution", &|case| case.e = Value::fraction(1, 3));
    broken("momentum", &|case| case.after[1][0] = Value::fraction(31, 10));
    broken("momentum", &|case| case.after[0][1] = Value::from(5));
    broken("perpendicular components", &|case| {
        case.after[0][1] = Value::from(5);
        case.after[1][1] = Value::from(-2);
    });
    broken("approach", &|case| case.line[0] = Value::from(-7));
    broken("positive masses", &|case| case.masses = [Value::from(-2), Value::from(-1)]);
    broken("energy", &|case| case.lost = Value::from(2));
    // e = 2 keeps momentum and restitution, and makes energy.
    broken("0 <= e <= 1", &|case| {
        case.e = Value::from(2);
        case.after = [[Value::ZERO, Value::from(4)], [Value::from(6), Value::ZERO]];
    });
    assert_eq!(judge(&right), Ok(()));
    assert_eq!(judge(&right.turned_into(to_judge).unwrap()), Ok(()));
    for (law, case) in wrong {
        assert_eq!(judge(&case), Err(law), "in values");
        assert_eq!(judge(&case.turned_into(to_judge).unwrap()), Err(law), "in fractions");
    }
}
