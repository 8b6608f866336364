//! Unknowns where it is open from which side the bodies approach.
//!
//! A line of centres without a sense points from A to B as the bodies approach. If that depends on an unknown, the line is
//! turned either way, and each solution is that of the way in which they do approach.

use std::sync::Arc;

use super::backwards::Found;
use super::pose::relative;
use super::refusal::{Because, Refusal};
use super::scene::{Contact, Scene};
use super::scene_text::Sense;
use super::unknowns::substituted;
use crate::number::{Letter, Value};

/// The scene with its line of centres turned either way, if the way is open.
pub(super) fn either_way(scene: &Scene) -> Option<[Scene; 2]> {
    let Some(Contact::Along(x, y, None)) = &scene.contact else { return None };
    let speed = approach(scene)?;
    let is_open = speed.sign().is_none() && speed.has_letter(|letter| scene.unknowns.contains(letter));
    let towards =
        |x: Value, y: Value| Scene { contact: Some(Contact::Along(x, y, Some(Sense::FromAToB))), ..scene.clone() };
    is_open.then(|| [towards(x.clone(), y.clone()), towards(-x, -y)])
}

/// How fast A and B approach along the vector that is given.
fn approach(scene: &Scene) -> Option<Value> {
    let Some(Contact::Along(x, y, _)) = &scene.contact else { return None };
    let (u, v) = relative(scene)?;
    Some(&(&u * x) + &(&v * y))
}

/// What is found either way.
pub(super) fn of_both_ways(scene: &Scene, found: [Result<Vec<Found>, Refusal>; 2]) -> Result<Vec<Found>, Refusal> {
    let mut all: Vec<Found> = Vec::new();
    let mut refusals = Vec::new();
    for way in found {
        match way {
            Ok(found) => all.extend(found),
            Err(refusal) => refusals.push(refusal),
        }
    }
    if all.is_empty() {
        // Beyond the methods here is more to tell than impossible.
        refusals.sort_by_key(|refusal| refusal.because == Because::Impossible);
        return Err(refusals.swap_remove(0));
    }
    for one in &mut all {
        // The line of centres has no sense again, and what was found in the place of letters that are not left.
        let (letters, values): (Vec<Letter>, Vec<Value>) = one.values.iter().cloned().unzip();
        let contact = match one.are_left {
            true => Some(scene.contact.clone()),
            false => substituted(scene, &letters, &values).map(|there| there.contact),
        };
        if let Some(contact) = contact {
            Arc::make_mut(&mut one.scene).contact = contact;
        }
        let open = refusals.iter().filter(|refusal| refusal.because != Because::Impossible);
        one.remarks
            .extend(open.map(|refusal| format!("with the line of centres the other way round {}", refusal.reason)));
    }
    Ok(all)
}
