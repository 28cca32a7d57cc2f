//! Values that live as long as the module.

use std::cell::UnsafeCell;

/// A static that one function at a time works on: `thread_local!` with a `RefCell`, without their code in every caller.
pub(crate) struct SingleThreadCell<T>(UnsafeCell<T>);

// SAFETY: wasm32 without atomics has one thread. On other targets there is no such impl.
#[cfg(all(target_arch = "wasm32", not(target_feature = "atomics")))]
unsafe impl<T> Sync for SingleThreadCell<T> {}

impl<T> SingleThreadCell<T> {
    pub(crate) const fn new(value: T) -> Self {
        Self(UnsafeCell::new(value))
    }

    /// Runs `f` on the value; `f` must not come back here for the same value.
    #[inline]
    pub(crate) fn with<R>(&self, f: impl FnOnce(&mut T) -> R) -> R {
        // SAFETY: this is the only reference. There is one thread; exported functions do not call each other; and `f` calls
        // JavaScript only for `Math.pow` and to copy into typed arrays, which do not call this module. Drawing on a canvas,
        // whose methods may be anything, happens after `with` has returned.
        f(unsafe { &mut *self.0.get() })
    }
}
