//! The solver proved right: the exercises of the seed, laws that hold for every impact, methods that share no code.

mod agreement;
mod alone;
mod backwards;
mod begun;
mod exact_forms;
mod forms;
mod impacts;
mod judge;
mod later;
mod laws;
mod left_as_letters;
mod ranges;
mod scenes;
mod seed;
mod variants;
