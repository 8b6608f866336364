//! Scenes that run backwards: unknown letters found from conditions on the collision.

use super::refusal::Refusal;
use super::scene::Scene;
use super::working::Line;
use crate::number::{Letter, Value};

/// One solution for the unknowns of a scene.
#[derive(Clone, Debug)]
pub struct Found {
    /// The scene with the unknowns replaced.
    pub scene: Scene,
    /// Each unknown with its value; of an angle the tangent.
    pub values: Vec<(Letter, Value)>,
    /// How they were found.
    pub lines: Vec<Line>,
    /// Roots that were left out, and why.
    pub remarks: Vec<String>,
}

/// Finds the unknowns of a scene. A scene without unknowns is its own only solution.
pub fn backwards(scene: &Scene) -> Result<Vec<Found>, Refusal> {
    if scene.unknowns.is_empty() {
        return Ok(vec![Found { scene: scene.clone(), values: vec![], lines: vec![], remarks: vec![] }]);
    }
    Err(Refusal::beyond("unknowns are not found yet"))
}
