//! The quantities of a collision, by the names that scenes, questions and keys use.
//!
//! Conventions. `n` is the unit vector along the line of centres from A to B, `t` is `n` turned by
//! +90 degrees. Components, momenta and impulses are signed; `impulse` of a sphere is what that
//! sphere receives; a loss is positive when energy is lost. Names are `A.after.speed`,
//! `impulse.magnitude`, `ke.lost`, …; angles are in degrees.

use std::cell::Cell;
use std::collections::HashMap;
use std::fmt;
use std::str::FromStr;
use std::sync::OnceLock;

use foldhash::fast::FixedState;

use super::Setting;
use super::later::{Later, Meeting};
use crate::unit::Unit;

/// A sphere. A law knows two, A and B; in an impact that comes later a third may have their parts.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Sphere {
    /// The sphere from which `n` points.
    A,
    /// The sphere to which `n` points.
    B,
    /// A sphere that is struck later.
    C,
}

/// Immediately before or immediately after the impact.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Moment {
    /// Immediately before the impact.
    Before,
    /// Immediately after the impact.
    After,
}

/// A direction along which a vector is resolved.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Axis {
    /// Along **i**.
    X,
    /// Along **j**.
    Y,
    /// Along the line of centres, from A to B.
    N,
    /// Perpendicular to the line of centres, `n` turned by +90 degrees.
    T,
}

/// A quantity of a collision.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Quantity {
    /// `A.mass`
    Mass(Sphere),
    /// `A.before.x`: a component of a velocity.
    Velocity(Sphere, Moment, Axis),
    /// `A.after.speed`
    Speed(Sphere, Moment),
    /// `A.after.ke`
    KineticEnergy(Sphere, Moment),
    /// `A.after.px`, `A.after.py`
    SphereMomentum(Sphere, Moment, Axis),
    /// `A.after.angle_to_loc_deg`: acute, 0 to 90.
    AngleToLine(Sphere, Moment),
    /// `A.after.angle_from_n_deg`: signed, anticlockwise.
    AngleFromN(Sphere, Moment),
    /// `A.after.angle_from_i_deg`: signed, anticlockwise.
    AngleFromI(Sphere, Moment),
    /// `A.after.tan_to_loc`: |t|/|n|.
    TanToLine(Sphere, Moment),
    /// `A.after.t_over_n`: signed.
    TOverN(Sphere, Moment),
    /// `A.after.angle_to_wall_deg`: acute, 0 to 90; with the wall, or the common tangent of two spheres.
    AngleToWall(Sphere, Moment),
    /// `A.after.tan_to_wall`: |n|/|t|.
    TanToWall(Sphere, Moment),
    /// `A.deflection_deg`: 0 to 180.
    Deflection(Sphere),
    /// `A.deflection_signed_deg`: anticlockwise from before to after.
    SignedDeflection(Sphere),
    /// `A.deflection_cross`: before × after.
    DeflectionCross(Sphere),
    /// `A.deflection_dot`: before · after.
    DeflectionDot(Sphere),
    /// `A.tan_deflection`: cross over dot, signed.
    TanDeflection(Sphere),
    /// `A.impulse.x`: a component of the impulse that the sphere receives.
    Impulse(Sphere, Axis),
    /// `A.ke_lost`
    SphereEnergyLost(Sphere),
    /// `A.ke_gained`
    SphereEnergyGained(Sphere),
    /// `impulse.magnitude`
    ImpulseMagnitude,
    /// `impulse.angle_to_i_deg`: acute, 0 to 90; of the impulse on A, or on B, with i.
    ImpulseAngle,
    /// `approach`: speed of approach along the line of centres.
    Approach,
    /// `separation`: speed of separation along the line of centres.
    Separation,
    /// `e`
    Restitution,
    /// `mass_ratio`: the mass of B over that of A.
    MassRatio,
    /// `n.x`, `n.y`
    Line(Axis),
    /// `t.x`, `t.y`
    Tangent(Axis),
    /// `ke.before`, `ke.after`
    TotalEnergy(Moment),
    /// `ke.lost`
    EnergyLost,
    /// `ke.fraction_lost`
    FractionLost,
    /// `momentum.x`, `momentum.y`
    TotalMomentum(Axis),
    /// `angle_between_before_deg`, `angle_between_after_deg`
    AngleBetween(Moment),
    /// `alpha_deg`: the acute angle of the relative velocity before to `n`.
    Alpha,
    /// Not by name: the direction of a velocity as it was given.
    GivenDirection(Sphere, Moment),
    /// Not by name: a component of the impulse as it was given.
    GivenImpulse(Axis),
    /// Not by name: the sine of the angle from the path of A relative to B to the line of centres.
    ContactSine,
    /// Not by name: the equation of momentum along the line of centres.
    MomentumEquation,
    /// Not by name: the equation of restitution.
    RestitutionEquation,
    /// Not by name: that all of it happens along one line, which is that of i.
    InALine,
    /// Not by name: that an impact comes later, and between whom.
    Meeting(Meeting),
    /// `second.B.after.speed`: a quantity of a later impact.
    Later(Later),
}

use Axis::{N, T, X, Y};
use Moment::{After, Before};
use Sphere::{A, B, C};

impl Sphere {
    /// Both spheres of an impact.
    pub const BOTH: [Sphere; 2] = [A, B];

    /// Every sphere that a scene may have.
    pub const ALL: [Sphere; 3] = [A, B, C];

    /// The other sphere of an impact between A and B.
    pub fn other(self) -> Sphere {
        if self == A { B } else { A }
    }

    /// `A`, `B` or `C`.
    pub fn name(self) -> &'static str {
        match self {
            A => "A",
            B => "B",
            C => "C",
        }
    }
}

impl Quantity {
    /// Every quantity that has a name, in the order in which `solve` lists them.
    pub fn all() -> Vec<Quantity> {
        Quantity::named(&Sphere::BOTH)
    }

    /// The same of other spheres.
    pub(super) fn named(spheres: &[Sphere]) -> Vec<Quantity> {
        use Quantity::*;
        let mut all = Vec::new();
        for sphere in spheres.iter().copied() {
            all.push(Mass(sphere));
            for moment in [Before, After] {
                all.extend([X, Y, N, T].map(|axis| Velocity(sphere, moment, axis)));
                all.extend([Speed(sphere, moment), KineticEnergy(sphere, moment)]);
                all.extend([X, Y].map(|axis| SphereMomentum(sphere, moment, axis)));
                all.extend([AngleToLine(sphere, moment), AngleFromN(sphere, moment), AngleFromI(sphere, moment)]);
                all.extend([TanToLine(sphere, moment), TOverN(sphere, moment)]);
                all.extend([AngleToWall(sphere, moment), TanToWall(sphere, moment)]);
            }
            all.extend([Deflection(sphere), SignedDeflection(sphere), DeflectionCross(sphere)]);
            all.extend([DeflectionDot(sphere), TanDeflection(sphere)]);
            all.extend([X, Y, N, T].map(|axis| Impulse(sphere, axis)));
            all.extend([SphereEnergyLost(sphere), SphereEnergyGained(sphere)]);
        }
        all.extend([ImpulseMagnitude, ImpulseAngle, Approach, Separation, Restitution, MassRatio]);
        all.extend([Line(X), Line(Y), Tangent(X), Tangent(Y)]);
        all.extend([TotalEnergy(Before), TotalEnergy(After), EnergyLost, FractionLost]);
        all.extend([TotalMomentum(X), TotalMomentum(Y), AngleBetween(Before), AngleBetween(After), Alpha]);
        all
    }

    /// Every quantity of one impact, those without a name after the others.
    pub(super) fn of_an_impact() -> Vec<Quantity> {
        use Quantity::*;
        let mut all = Quantity::named(&Sphere::ALL);
        for sphere in Sphere::ALL {
            all.extend([Before, After].map(|moment| GivenDirection(sphere, moment)));
        }
        all.extend([GivenImpulse(X), GivenImpulse(Y), ContactSine, MomentumEquation, RestitutionEquation]);
        all
    }

    /// The same quantity with other spheres in their parts.
    pub(super) fn with_spheres(self, of: impl Fn(Sphere) -> Sphere) -> Quantity {
        use Quantity::*;
        match self {
            Mass(s) => Mass(of(s)),
            Velocity(s, moment, axis) => Velocity(of(s), moment, axis),
            Speed(s, moment) => Speed(of(s), moment),
            KineticEnergy(s, moment) => KineticEnergy(of(s), moment),
            SphereMomentum(s, moment, axis) => SphereMomentum(of(s), moment, axis),
            AngleToLine(s, moment) => AngleToLine(of(s), moment),
            AngleFromN(s, moment) => AngleFromN(of(s), moment),
            AngleFromI(s, moment) => AngleFromI(of(s), moment),
            TanToLine(s, moment) => TanToLine(of(s), moment),
            TOverN(s, moment) => TOverN(of(s), moment),
            AngleToWall(s, moment) => AngleToWall(of(s), moment),
            TanToWall(s, moment) => TanToWall(of(s), moment),
            Deflection(s) => Deflection(of(s)),
            SignedDeflection(s) => SignedDeflection(of(s)),
            DeflectionCross(s) => DeflectionCross(of(s)),
            DeflectionDot(s) => DeflectionDot(of(s)),
            TanDeflection(s) => TanDeflection(of(s)),
            Impulse(s, axis) => Impulse(of(s), axis),
            SphereEnergyLost(s) => SphereEnergyLost(of(s)),
            SphereEnergyGained(s) => SphereEnergyGained(of(s)),
            GivenDirection(s, moment) => GivenDirection(of(s), moment),
            other => other,
        }
    }

    /// Does a scene of this setting have it? A wall is no sphere, and only a wall makes an angle with itself.
    pub fn is_in(self, setting: Setting) -> bool {
        match self {
            Quantity::AngleToWall(..) | Quantity::TanToWall(..) => setting == Setting::Wall,
            _ => !(setting.is_of_one() && self.sphere() == Some(B)),
        }
    }

    /// The unit in which it is stated.
    pub fn unit(self) -> Unit {
        use Quantity::*;
        match self {
            Later(later) => later.quantity().unit(),
            Mass(_) => Unit::Kilogram,
            Velocity(..) | Speed(..) | Approach | Separation => Unit::MetrePerSecond,
            KineticEnergy(..) | SphereEnergyLost(_) | SphereEnergyGained(_) | TotalEnergy(_) | EnergyLost => {
                Unit::Joule
            }
            SphereMomentum(..) | Impulse(..) | ImpulseMagnitude | TotalMomentum(_) => Unit::NewtonSecond,
            AngleToLine(..) | AngleFromN(..) | AngleFromI(..) | Deflection(_) | SignedDeflection(_) => Unit::Degree,
            AngleToWall(..) | AngleBetween(_) | Alpha | ImpulseAngle => Unit::Degree,
            _ => Unit::None,
        }
    }

    /// Is it an equation for two unknowns rather than a quantity with a value?
    pub fn is_equation(self) -> bool {
        match self {
            Quantity::Later(later) => later.quantity().is_equation(),
            _ => matches!(self, Quantity::MomentumEquation | Quantity::RestitutionEquation),
        }
    }

    /// The sphere of which it is a quantity, if it is of one.
    pub fn sphere(self) -> Option<Sphere> {
        let of = Cell::new(None);
        self.with_spheres(|sphere| {
            of.set(Some(sphere));
            sphere
        });
        of.get()
    }

    /// Is it an angle?
    pub fn is_angle(self) -> bool {
        self.unit() == Unit::Degree
    }

    /// Is it of all that takes part in an impact together, and of no sphere alone?
    pub fn is_of_all(self) -> bool {
        matches!(
            self,
            Quantity::EnergyLost | Quantity::FractionLost | Quantity::TotalEnergy(_) | Quantity::TotalMomentum(_)
        )
    }
}

impl fmt::Display for Axis {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            X => "x",
            Y => "y",
            N => "n",
            T => "t",
        })
    }
}

impl fmt::Display for Moment {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(if *self == Before { "before" } else { "after" })
    }
}

impl fmt::Display for Quantity {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        use Quantity::*;
        match self {
            Mass(s) => write!(f, "{}.mass", s.name()),
            Velocity(s, m, axis) => write!(f, "{}.{m}.{axis}", s.name()),
            Speed(s, m) => write!(f, "{}.{m}.speed", s.name()),
            KineticEnergy(s, m) => write!(f, "{}.{m}.ke", s.name()),
            SphereMomentum(s, m, axis) => write!(f, "{}.{m}.p{axis}", s.name()),
            AngleToLine(s, m) => write!(f, "{}.{m}.angle_to_loc_deg", s.name()),
            AngleFromN(s, m) => write!(f, "{}.{m}.angle_from_n_deg", s.name()),
            AngleFromI(s, m) => write!(f, "{}.{m}.angle_from_i_deg", s.name()),
            TanToLine(s, m) => write!(f, "{}.{m}.tan_to_loc", s.name()),
            TOverN(s, m) => write!(f, "{}.{m}.t_over_n", s.name()),
            AngleToWall(s, m) => write!(f, "{}.{m}.angle_to_wall_deg", s.name()),
            TanToWall(s, m) => write!(f, "{}.{m}.tan_to_wall", s.name()),
            Deflection(s) => write!(f, "{}.deflection_deg", s.name()),
            SignedDeflection(s) => write!(f, "{}.deflection_signed_deg", s.name()),
            DeflectionCross(s) => write!(f, "{}.deflection_cross", s.name()),
            DeflectionDot(s) => write!(f, "{}.deflection_dot", s.name()),
            TanDeflection(s) => write!(f, "{}.tan_deflection", s.name()),
            Impulse(s, axis) => write!(f, "{}.impulse.{axis}", s.name()),
            SphereEnergyLost(s) => write!(f, "{}.ke_lost", s.name()),
            SphereEnergyGained(s) => write!(f, "{}.ke_gained", s.name()),
            ImpulseMagnitude => f.write_str("impulse.magnitude"),
            ImpulseAngle => f.write_str("impulse.angle_to_i_deg"),
            Approach => f.write_str("approach"),
            Separation => f.write_str("separation"),
            Restitution => f.write_str("e"),
            MassRatio => f.write_str("mass_ratio"),
            Line(axis) => write!(f, "n.{axis}"),
            Tangent(axis) => write!(f, "t.{axis}"),
            TotalEnergy(m) => write!(f, "ke.{m}"),
            EnergyLost => f.write_str("ke.lost"),
            FractionLost => f.write_str("ke.fraction_lost"),
            TotalMomentum(axis) => write!(f, "momentum.{axis}"),
            AngleBetween(m) => write!(f, "angle_between_{m}_deg"),
            Alpha => f.write_str("alpha_deg"),
            GivenDirection(s, m) => write!(f, "direction of {} {m}", s.name()),
            GivenImpulse(axis) => write!(f, "given impulse along {axis}"),
            ContactSine => f.write_str("offset over the sum of the radii"),
            MomentumEquation => f.write_str("equation of momentum"),
            RestitutionEquation => f.write_str("equation of restitution"),
            Later(later) => later.fmt(f),
            Meeting(meeting) => meeting.fmt(f),
            InALine => f.write_str("all of it along one line"),
        }
    }
}

/// No quantity has this name.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct UnknownQuantity;

impl FromStr for Quantity {
    type Err = UnknownQuantity;
    fn from_str(name: &str) -> Result<Quantity, UnknownQuantity> {
        // Names are looked up for every requirement of every variant.
        static NAMES: OnceLock<HashMap<String, Quantity, FixedState>> = OnceLock::new();
        let names = NAMES
            .get_or_init(|| Quantity::all().into_iter().map(|quantity| (quantity.to_string(), quantity)).collect());
        names.get(name).copied().or_else(|| Later::named(name).map(Quantity::Later)).ok_or(UnknownQuantity)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_quantity_is_found_by_its_own_name_and_no_two_share_one() {
        let mut names: Vec<String> = Quantity::all().iter().map(Quantity::to_string).collect();
        for quantity in Quantity::all() {
            assert_eq!(quantity.to_string().parse(), Ok(quantity));
        }
        names.sort();
        names.dedup();
        assert_eq!(names.len(), Quantity::all().len());
    }
}
