//! How much arithmetic was done, counted in tests alone: a bound on work is asserted by counting, never by a clock.

#[cfg(test)]
pub(crate) use counter::taken;

/// So many steps more.
pub(crate) fn add(steps: usize) {
    #[cfg(test)]
    counter::add(steps);
    #[cfg(not(test))]
    let _ = steps;
}

/// Steps that an operation on integers of so many bits is worth: one for each pair of words.
pub(crate) fn of_bits(bits: usize) -> usize {
    (1 + bits / 64).pow(2)
}

#[cfg(test)]
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
    pub(crate) fn taken() -> u64 {
        STEPS.with(Cell::take)
    }
}
