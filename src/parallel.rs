//! The same work for many patches: on all cores with the feature `rayon`, otherwise one after the other. The results
//! are the same bit for bit, because each depends on its patch only and they are combined in order.

#[cfg(feature = "rayon")]
use rayon::prelude::*;

/// The smallest number of patches that a core takes at once.
#[cfg(feature = "rayon")]
const MIN_PATCHES: usize = 4;

/// The number of patches whose results are made before they are put together, where a result can be large.
#[cfg(feature = "rayon")]
pub(crate) const PATCHES_AT_ONCE: usize = 256;

/// Whether there is more than one core to use.
#[cfg(feature = "rayon")]
pub(crate) fn has_cores() -> bool {
    rayon::current_num_threads() > 1
}

/// f(0), …, f(count − 1), in order.
#[cfg(feature = "rayon")]
pub(crate) fn map_patches<T: Send>(count: usize, f: impl Fn(usize) -> T + Sync + Send) -> Vec<T> {
    if !has_cores() {
        return (0..count).map(f).collect();
    }
    let numbers = (0..count).into_par_iter().with_min_len(MIN_PATCHES);
    numbers.map(f).collect()
}

/// f(0), …, f(count − 1), in order.
#[cfg(not(feature = "rayon"))]
pub(crate) fn map_patches<T>(count: usize, f: impl Fn(usize) -> T) -> impl Iterator<Item = T> {
    (0..count).map(f)
}
