//! Marks for everything but momentum and restitution along the line of centres, law by law.

mod across;
mod across_implied;
mod along_wall;
mod by_components;
mod by_law;
mod centre_of_mass;
mod change_of_momentum;
mod cleared;
mod compound;
mod condition;
mod energies;
mod impulse;
mod losses;
mod own;
mod own_condition;
mod own_line;
mod own_speed;
mod printed;
mod rebound;
mod shapes;
mod turned;
mod unknown_components;
mod values;
mod vector_momentum;
mod vectors;
mod wrong_side;

pub(super) use by_components::momentum_by_components;
pub(super) use cleared::is_of_deflection;
pub(super) use energies::ToBeSubtracted;
pub(super) use impulse::is_worked;
pub(super) use own_speed::multiple;
pub(super) use printed::{Spot, Truth, leaves};
pub(super) use shapes::are_bare;
pub(super) use values::along_for;
