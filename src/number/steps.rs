//! How much arithmetic was done: a bound on work is asserted by counting, never by a clock.

use std::cell::Cell;

thread_local! {
    static STEPS: Cell<u64> = const { Cell::new(0) };
}

/// So many steps more.
pub(crate) fn add(steps: usize) {
    STEPS.with(|count| count.set(count.get() + steps as u64));
}

/// Steps that an operation on integers of so many bits is worth: one, and one more for each two dozen pairs of words,
/// which take no longer than what there is to do beside them.
pub(crate) fn of_bits(bits: usize) -> usize {
    1 + (bits / 64).pow(2) / 24
}

/// The steps of this thread since it was last asked.
pub fn taken() -> u64 {
    STEPS.with(Cell::take)
}
