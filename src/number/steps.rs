//! How much arithmetic was done, counted in builds with assertions, as those of tests, and by the fuzzer: a bound on work is
//! asserted by counting, never by a clock.

#[cfg(any(debug_assertions, test, fuzzing))]
pub use counter::taken;

/// So many steps more.
pub(crate) fn add(steps: usize) {
    #[cfg(any(debug_assertions, test, fuzzing))]
    counter::add(steps);
    #[cfg(not(any(debug_assertions, test, fuzzing)))]
    let _ = steps;
}

/// Steps that an operation on integers of so many bits is worth: one, and one more for each two dozen pairs of words,
/// which take no longer than what there is to do beside them.
pub(crate) fn of_bits(bits: usize) -> usize {
    1 + (bits / 64).pow(2) / 24
}

#[cfg(any(debug_assertions, test, fuzzing))]
mod counter {
    use std::cell::Cell;

    thread_local! {
        static STEPS: Cell<u64> = const { Cell::new(0) };
    }

    /// So many steps more.
    pub(super) fn add(steps: usize) {
        STEPS.with(|count| count.set(count.get() + steps as u64));
    }

    /// The steps of this thread since it was last asked.
    pub fn taken() -> u64 {
        STEPS.with(Cell::take)
    }
}
