//! The marker: what students hand in, read and judged as an examiner does.
//!
//! An answer goes two steps. [`reading`] turns what was typed into every [`Reading`](reading::Reading) that a person
//! might see in it, the likeliest first, and never guesses in silence: what cannot be read is
//! [`Unreadable`](reading::Unreadable) and goes to a person. [`judging`] compares the readings with the model answer.

pub mod judging;
pub mod reading;
