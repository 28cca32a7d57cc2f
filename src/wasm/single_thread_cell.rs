//! A static mutable cell for single-threaded wasm.

use std::cell::UnsafeCell;

/// A static value with access by one function at a time: like `thread_local!` with a `RefCell`, with less code per use.
pub(crate) struct SingleThreadCell<T>(UnsafeCell<T>);

// SAFETY: wasm32 without atomics has one thread.
unsafe impl<T> Sync for SingleThreadCell<T> {}

impl<T> SingleThreadCell<T> {
    pub(crate) const fn new(value: T) -> Self {
        Self(UnsafeCell::new(value))
    }

    /// Calls `f` with the value; `f` must not access the same cell again.
    #[inline]
    pub(crate) fn with<R>(&self, f: impl FnOnce(&mut T) -> R) -> R {
        // SAFETY: no exported function calls another, and nothing calls back into JavaScript, so this is the only
        // reference.
        f(unsafe { &mut *self.0.get() })
    }
}
