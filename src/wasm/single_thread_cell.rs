//! Values that live as long as the module.

use std::cell::UnsafeCell;

/// A static that one function at a time works on: `thread_local!` with a `RefCell`, without their code in every caller.
pub(crate) struct SingleThreadCell<T>(UnsafeCell<T>);

// SAFETY: wasm32 without atomics has one thread.
unsafe impl<T> Sync for SingleThreadCell<T> {}

impl<T> SingleThreadCell<T> {
    pub(crate) const fn new(value: T) -> Self {
        Self(UnsafeCell::new(value))
    }

    /// Runs `f` on the value; `f` must not come back here for the same value.
    #[inline]
    pub(crate) fn with<R>(&self, f: impl FnOnce(&mut T) -> R) -> R {
        // SAFETY: no exported function calls another, and nothing calls back into JavaScript, so this is the only
        // reference.
        f(unsafe { &mut *self.0.get() })
    }
}
