//! Checks many cases on all processors, because a single test that runs alone at the end would leave the others idle.

use std::sync::{Mutex, PoisonError};
use std::thread;

/// Generates the cases sequentially, as a single thread would, and checks them in parallel.
pub(crate) fn on_all<T: Send>(cases: impl Iterator<Item = T> + Send, check: impl Fn(T) + Sync) {
    let cases = Mutex::new(cases.fuse());
    let next = || {
        let mut cases = cases.lock().unwrap_or_else(PoisonError::into_inner);
        cases.next()
    };
    let work = || {
        while let Some(case) = next() {
            check(case);
        }
    };
    let threads = thread::available_parallelism().map_or(1, usize::from);
    thread::scope(|scope| {
        for _ in 0..threads {
            scope.spawn(work);
        }
    });
}
