//! Work limits of iterative algorithms, counted in steps and never in time.
#![allow(
    unreachable_pub,
    reason = "the wasm build compiles this file in another crate, src/wasm/fast"
)]

/// Counts the steps of one call and reports when its limit is exceeded.
///
/// A step is one repetition of the algorithm: a halving, the test of a box, an evaluation. A call that exceeds its
/// limit either returns an error (`Error::TooMany`) or the best result found so far; the documentation of each function
/// says which.
#[derive(Debug)]
pub struct WorkLimit {
    used: usize,
    limit: usize,
}

impl WorkLimit {
    /// A counter that allows `limit` steps.
    #[inline]
    pub fn new(limit: usize) -> Self {
        Self { used: 0, limit }
    }

    /// Counts steps; returns false as soon as the limit is exceeded.
    #[inline]
    #[must_use]
    pub fn spend(&mut self, steps: usize) -> bool {
        self.used = self.used.saturating_add(steps);
        self.used <= self.limit
    }

    /// Whether more steps were counted than the limit allows.
    #[inline]
    pub fn is_exceeded(&self) -> bool {
        self.used > self.limit
    }

    /// The number of counted steps.
    #[inline]
    pub fn used(&self) -> usize {
        self.used
    }
}

/// With the feature `count-work`, the steps of all calls are added up for each thread, so that tests can check limits
/// without measuring time.
#[cfg(feature = "count-work")]
mod total {
    use super::WorkLimit;
    use std::cell::Cell;

    thread_local! {
        static STEPS: Cell<usize> = const { Cell::new(0) };
    }

    impl Drop for WorkLimit {
        fn drop(&mut self) {
            STEPS.with(|steps| steps.set(steps.get().saturating_add(self.used)));
        }
    }

    /// The steps counted on this thread since the last call of this function.
    pub fn take_steps() -> usize {
        STEPS.with(|steps| steps.replace(0))
    }
}

#[cfg(feature = "count-work")]
pub use total::take_steps;
