//! Work limits of iterative algorithms, counted in steps and never in time.

/// Counts the steps of one call and reports when its limit is exceeded.
///
/// A step is one repetition of the algorithm: a halving, the test of a box, an evaluation. A call that exceeds its
/// limit either returns an error (`Error::TooMany`) or the best result found so far; the documentation of each function
/// says which.
///
/// Numbers of steps have 64 bits on all targets: a limit that grows with the input exceeds 32 bits.
#[derive(Debug)]
pub struct WorkLimit {
    used: u64,
    limit: u64,
}

impl WorkLimit {
    /// A counter that allows `limit` steps.
    #[inline]
    pub fn new(limit: usize) -> Self {
        Self {
            used: 0,
            limit: limit as u64,
        }
    }

    /// Raises the limit by a number of steps for each of `count` items.
    #[inline]
    pub fn raise_limit(&mut self, steps: usize, count: usize) {
        let further = (steps as u64).saturating_mul(count as u64);
        self.limit = self.limit.saturating_add(further);
    }

    /// Allows no further steps.
    #[inline]
    pub fn stop(&mut self) {
        self.limit = 0;
    }

    /// The number of steps allowed and the number used.
    pub fn limit_and_used(&self) -> (u64, u64) {
        (self.limit, self.used)
    }

    /// Counts steps; returns false as soon as the limit is exceeded.
    #[inline]
    #[must_use]
    pub fn spend(&mut self, steps: usize) -> bool {
        self.count(steps);
        !self.is_exceeded()
    }

    /// Counts steps that are already done.
    #[inline]
    pub fn count(&mut self, steps: usize) {
        self.used = self.used.saturating_add(steps as u64);
    }

    /// Whether more steps were counted than the limit allows.
    #[inline]
    pub fn is_exceeded(&self) -> bool {
        self.used > self.limit
    }

    /// The number of counted steps.
    #[inline]
    pub fn used(&self) -> usize {
        usize::try_from(self.used).unwrap_or(usize::MAX)
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
            STEPS.with(|steps| steps.set(steps.get().saturating_add(self.used())));
        }
    }

    /// The steps counted on this thread since the last call of this function.
    pub fn take_steps() -> usize {
        STEPS.with(|steps| steps.replace(0))
    }
}

#[cfg(feature = "count-work")]
pub use total::take_steps;
