//! A scene as it is written down: the exchange format, in JSON or TOML, every number an expression.

use std::collections::BTreeMap;

use serde::{Deserialize, Serialize};

/// A scene in words of the exchange format. `S` is what holds an expression: a `String`, or where
/// faults must point into a file a string with its place.
///
/// Lengths are in metres, masses in kilograms, speeds in metres a second; see `docs/exchange-formats.md`.
#[derive(Clone, Debug, Deserialize, Serialize)]
#[serde(deny_unknown_fields, bound(deserialize = "S: Deserialize<'de>"))]
pub struct SceneText<S = String> {
    /// The masses; one may be left out to be found.
    #[serde(default = "Pair::none")]
    pub masses: Pair<S>,
    /// Velocities immediately before the impact.
    #[serde(default = "Pair::none")]
    pub before: Pair<VelocityText<S>>,
    /// Velocities immediately after it, where they are given.
    #[serde(default = "Pair::none", skip_serializing_if = "Pair::is_none")]
    pub after: Pair<VelocityText<S>>,
    /// A vector along the line of centres, of any length.
    #[serde(default = "none", skip_serializing_if = "Option::is_none")]
    pub line_of_centres: Option<[S; 2]>,
    /// Whether that vector points from A to B; else it is turned so that the spheres approach.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub sense: Option<Sense>,
    /// Positions of the centres, in place of the line of centres.
    #[serde(default = "Pair::none", skip_serializing_if = "Pair::is_none")]
    pub positions: Pair<[S; 2]>,
    /// Radii.
    #[serde(default = "Pair::none", skip_serializing_if = "Pair::is_none")]
    pub radii: Pair<S>,
    /// How far B's centre lies to the left of the path of A relative to B.
    #[serde(default = "none", skip_serializing_if = "Option::is_none")]
    pub impact_parameter: Option<S>,
    /// A vector along a fixed smooth wall that A strikes, in place of B.
    #[serde(default = "none", skip_serializing_if = "Option::is_none")]
    pub wall: Option<[S; 2]>,
    /// The impulse that A receives, where it is one particle by itself.
    #[serde(default = "none", skip_serializing_if = "Option::is_none")]
    pub impulse: Option<[S; 2]>,
    /// The coefficient of restitution, if it is given.
    #[serde(default = "none", skip_serializing_if = "Option::is_none")]
    pub e: Option<S>,
    /// The letters, each with its range: `positive`, `unit`, `acute` or `real`.
    #[serde(default = "BTreeMap::new", skip_serializing_if = "BTreeMap::is_empty")]
    pub symbols: BTreeMap<String, S>,
    /// Letters to be found from the conditions.
    #[serde(default = "Vec::new", skip_serializing_if = "Vec::is_empty")]
    pub unknowns: Vec<S>,
    /// Equations between quantities, or inequalities for a range of the unknown.
    #[serde(default = "Vec::new", skip_serializing_if = "Vec::is_empty")]
    pub conditions: Vec<S>,
    /// A quantity that the unknown makes as large as possible.
    #[serde(default = "none", skip_serializing_if = "Option::is_none")]
    pub maximise: Option<S>,
    /// The impacts that come later, in their order.
    #[serde(default = "Vec::new", skip_serializing_if = "Vec::is_empty")]
    pub then: Vec<ThenText<S>>,
}

impl<S> SceneText<S> {
    /// Does everything move in one line before the first impact?
    pub fn is_in_one_line(&self) -> bool {
        [&self.before.a, &self.before.b]
            .into_iter()
            .flatten()
            .any(|velocity| matches!(velocity, VelocityText::Along(_)))
    }

    /// Is nothing given but one body in a plane, before and after, or the impulse that it receives?
    pub fn is_of_one_particle(&self) -> bool {
        let in_a_plane = |velocity: &Option<VelocityText<S>>| !matches!(velocity, None | Some(VelocityText::Along(_)));
        let of_b = self.masses.b.is_some() || self.before.b.is_some() || self.after.b.is_some();
        let of_an_impact = self.wall.is_some()
            || self.e.is_some()
            || self.line_of_centres.is_some()
            || !self.positions.is_none()
            || self.impact_parameter.is_some();
        self.impulse.is_some() || (in_a_plane(&self.before.a) && in_a_plane(&self.after.a) && !of_b && !of_an_impact)
    }

    /// Is there no other sphere in the first impact?
    pub fn is_of_one(&self) -> bool {
        self.wall.is_some() || self.is_of_one_particle()
    }
}

/// An impact that comes after another. Masses and velocities are those that the spheres have by then.
#[derive(Clone, Debug, Deserialize, Serialize)]
#[serde(deny_unknown_fields, bound(deserialize = "S: Deserialize<'de>"))]
pub struct ThenText<S = String> {
    /// Who meets: two of `A`, `B` and `C`, along one line in their order on it; one alone strikes a wall.
    pub of: Vec<S>,
    /// The mass of the one that takes part for the first time.
    #[serde(default = "none", skip_serializing_if = "Option::is_none")]
    pub mass: Option<S>,
    /// Its velocity before.
    #[serde(default = "none", skip_serializing_if = "Option::is_none")]
    pub before: Option<VelocityText<S>>,
    /// A vector along the line of centres, of any length.
    #[serde(default = "none", skip_serializing_if = "Option::is_none")]
    pub line_of_centres: Option<[S; 2]>,
    /// Whether that vector points from the first to the second; else it is turned so that they approach.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub sense: Option<Sense>,
    /// A vector along a fixed smooth wall.
    #[serde(default = "none", skip_serializing_if = "Option::is_none")]
    pub wall: Option<[S; 2]>,
    /// The coefficient of restitution, if it is given.
    #[serde(default = "none", skip_serializing_if = "Option::is_none")]
    pub e: Option<S>,
}

fn none<T>() -> Option<T> {
    None
}

/// Something for each sphere.
#[derive(Clone, Debug, Deserialize, Serialize)]
#[serde(deny_unknown_fields, bound(deserialize = "T: Deserialize<'de>"))]
pub struct Pair<T> {
    /// For A.
    #[serde(rename = "A", default = "none")]
    pub a: Option<T>,
    /// For B.
    #[serde(rename = "B", default = "none")]
    pub b: Option<T>,
}

impl<T> Pair<T> {
    /// Nothing for either sphere.
    pub fn none() -> Pair<T> {
        Pair { a: None, b: None }
    }

    /// Is there nothing for either sphere?
    pub fn is_none(&self) -> bool {
        self.a.is_none() && self.b.is_none()
    }
}

/// A velocity: along the one line of a direct impact, by its components, or by a speed and a direction.
#[derive(Clone, Debug, Deserialize, Serialize)]
#[serde(untagged)]
pub enum VelocityText<S> {
    /// `"u"`, signed, along the line from A to B, in which both spheres move.
    Along(S),
    /// `["x", "y"]`, along i and j.
    Components([S; 2]),
    /// A speed and an angle anticlockwise from i, or the cosine and sine of that angle.
    Polar(PolarText<S>),
}

/// A speed with a direction.
#[derive(Clone, Debug, Deserialize, Serialize)]
#[serde(deny_unknown_fields, bound(deserialize = "S: Deserialize<'de>"))]
pub struct PolarText<S> {
    /// The speed.
    pub speed: S,
    /// Degrees anticlockwise from i.
    #[serde(default = "none", skip_serializing_if = "Option::is_none")]
    pub angle_deg: Option<S>,
    /// Cosine of that angle.
    #[serde(default = "none", skip_serializing_if = "Option::is_none")]
    pub cos: Option<S>,
    /// Sine of that angle.
    #[serde(default = "none", skip_serializing_if = "Option::is_none")]
    pub sin: Option<S>,
}

/// Which way a given line of centres points.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize, Serialize)]
pub enum Sense {
    /// From A to B.
    #[serde(rename = "A_to_B")]
    FromAToB,
    /// Whichever way the spheres approach.
    #[serde(rename = "either")]
    Either,
}
