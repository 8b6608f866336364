//! The lines from which angles are measured and along which spheres move, with their sense where one is said.

/// A line that is named beside a value.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ReferenceLine {
    /// The line of centres.
    LineOfCentres,
    /// `AB`: the line of centres, or its sense from A to B.
    LineAB,
    /// The line of centres in the sense from A to B.
    FromAToB,
    /// The line of centres in the sense from B to A.
    FromBToA,
    /// The common tangent, or the perpendicular to the line of centres.
    CommonTangent,
    /// **i**
    I,
    /// **j**
    J,
    /// The direction opposite to **i**.
    MinusI,
    /// The original direction of motion.
    OriginalDirection,
    /// Along, or parallel to, the line of centres: a direction rather than an angle.
    AlongLineOfCentres,
    /// `along AB`: along the line of centres, perhaps in the sense from A to B.
    AlongAB,
    /// Along the line of centres from A to B.
    AlongAToB,
    /// Along the line of centres from B to A.
    AlongBToA,
    /// Perpendicular to the line of centres: a direction rather than an angle.
    AlongCommonTangent,
    /// A sense alone: towards B, or away from A.
    TowardsB,
    /// A sense alone: towards A, or away from B.
    TowardsA,
}

/// A sense along the line of centres.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Sense {
    /// From A to B.
    AToB,
    /// From B to A.
    BToA,
    /// `AB` names the sense or just the line: nobody knows.
    Perhaps,
}

use ReferenceLine::{
    AlongAB, AlongAToB, AlongBToA, AlongCommonTangent, AlongLineOfCentres, FromAToB, FromBToA, LineAB, LineOfCentres,
    TowardsA, TowardsB,
};

impl ReferenceLine {
    /// The line without its sense.
    pub fn unsensed(self) -> ReferenceLine {
        match self {
            LineAB | FromAToB | FromBToA => LineOfCentres,
            AlongAB | AlongAToB | AlongBToA => AlongLineOfCentres,
            other => other,
        }
    }

    /// The sense that is said along the line of centres.
    pub fn sense(self) -> Option<Sense> {
        match self {
            FromAToB | AlongAToB | TowardsB => Some(Sense::AToB),
            FromBToA | AlongBToA | TowardsA => Some(Sense::BToA),
            LineAB | AlongAB => Some(Sense::Perhaps),
            _ => None,
        }
    }

    /// Does it name a direction, rather than a line from which to measure?
    pub fn is_direction(self) -> bool {
        matches!(self.unsensed(), AlongLineOfCentres | AlongCommonTangent) || self.is_sense_alone()
    }

    /// `towards B`: which line it is remains to be said.
    pub fn is_sense_alone(self) -> bool {
        matches!(self, TowardsA | TowardsB)
    }

    /// A line and a sense said one after the other: `to the line of centres, towards B`. `None` for two lines, and for two
    /// senses that exclude each other.
    pub fn and(self, other: ReferenceLine) -> Option<ReferenceLine> {
        let says_sense = |line: ReferenceLine| line.is_sense_alone() || matches!(line, AlongAToB | AlongBToA);
        let is_of_centres = |line: ReferenceLine| {
            line.is_sense_alone() || matches!(line.unsensed(), LineOfCentres | AlongLineOfCentres)
        };
        let plain = |line: ReferenceLine| line.sense().filter(|sense| *sense != Sense::Perhaps);
        let sense = match (plain(self), plain(other)) {
            (Some(one), Some(two)) if one != two => return None,
            (one, two) => one.or(two)?,
        };
        if !(says_sense(self) || says_sense(other)) || ![self, other].into_iter().all(is_of_centres) {
            return None;
        }
        let lies = |wanted: ReferenceLine| self.unsensed() == wanted || other.unsensed() == wanted;
        Some(match (sense, lies(LineOfCentres), lies(AlongLineOfCentres)) {
            (Sense::BToA, true, _) => FromBToA,
            (_, true, _) => FromAToB,
            (Sense::BToA, false, true) => AlongBToA,
            (_, false, true) => AlongAToB,
            (Sense::BToA, false, false) => TowardsA,
            (_, false, false) => TowardsB,
        })
    }

    /// As a terminal shows it after a value.
    pub(super) fn words(self) -> &'static str {
        match self {
            LineOfCentres => "to the line of centres",
            LineAB => "to AB",
            FromAToB => "from the direction AB",
            FromBToA => "from the direction BA",
            ReferenceLine::CommonTangent => "to the common tangent",
            ReferenceLine::I => "to i",
            ReferenceLine::J => "to j",
            ReferenceLine::MinusI => "to −i",
            ReferenceLine::OriginalDirection => "to the original direction",
            AlongLineOfCentres => "along the line of centres",
            AlongAB => "along AB",
            AlongAToB => "along the line of centres from A to B",
            AlongBToA => "along the line of centres from B to A",
            AlongCommonTangent => "perpendicular to the line of centres",
            TowardsB => "towards B",
            TowardsA => "towards A",
        }
    }
}
