//! Methods proved without a clock: the selector takes the least model that suffices, and promises are kept.

mod corpus;
mod exam_grid;
mod minimality;
mod promises;
mod sufficiency;
mod work;
