//! Short lists: natively without an allocation; in wasm, where size counts and allocating is cheap, plain vectors.

use glam::DVec3;

#[cfg(not(target_family = "wasm"))]
type List<T, const N: usize> = smallvec::SmallVec<[T; N]>;
#[cfg(target_family = "wasm")]
type List<T, const N: usize> = Vec<T>;

/// The control points of a curve.
pub(crate) type Points<P> = List<P, 4>;

/// Numbers that go with control points: coefficients, roots.
pub(crate) type Scalars = List<f64, 4>;

/// The control points of a patch.
pub(crate) type Net = List<DVec3, 16>;

/// The control points of a slice; natively a copy of bytes where `From` would go point by point.
#[inline]
pub(crate) fn points_of<P: Copy>(slice: &[P]) -> Points<P> {
    #[cfg(not(target_family = "wasm"))]
    return Points::from_slice(slice);
    #[cfg(target_family = "wasm")]
    return slice.to_vec();
}
