//! A static mutable cell for single-threaded wasm.

use std::cell::UnsafeCell;

/// A static value with access by one function at a time: like `thread_local!` with a `RefCell`, with less code per use.
pub(crate) struct SingleThreadCell<T>(UnsafeCell<T>);

// SAFETY: wasm32 without atomics has one thread. On other targets there is no such impl.
#[cfg(all(target_arch = "wasm32", not(target_feature = "atomics")))]
unsafe impl<T> Sync for SingleThreadCell<T> {}

impl<T> SingleThreadCell<T> {
    pub(crate) const fn new(value: T) -> Self {
        Self(UnsafeCell::new(value))
    }

    /// Calls `f` with the value; `f` must not access the same cell again.
    #[inline]
    pub(crate) fn with<R>(&self, f: impl FnOnce(&mut T) -> R) -> R {
        // SAFETY: this is the only reference. There is one thread; exported functions do not call each other; and `f` calls
        // JavaScript only for `Math.pow` and to copy into typed arrays, which do not call this module. Drawing on a canvas,
        // whose methods may be anything, happens after `with` has returned.
        f(unsafe { &mut *self.0.get() })
    }
}
