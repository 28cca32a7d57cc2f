//! Short lists: inline storage natively; plain vectors in wasm, where code size matters and allocation is cheap.

use glam::DVec3;

#[cfg(not(target_family = "wasm"))]
type List<T, const N: usize> = smallvec::SmallVec<[T; N]>;
#[cfg(target_family = "wasm")]
type List<T, const N: usize> = Vec<T>;

/// The control points of a curve.
pub(crate) type Points<P> = List<P, 4>;

/// Numbers that belong to control points: coefficients, roots.
pub(crate) type Scalars = List<f64, 4>;

/// The control points of a patch.
pub(crate) type Net = List<DVec3, 16>;

/// The control points of a slice; natively a copy of bytes, where `From` would copy point by point.
#[inline]
pub(crate) fn points_of<P: Copy>(slice: &[P]) -> Points<P> {
    #[cfg(not(target_family = "wasm"))]
    return Points::from_slice(slice);
    #[cfg(target_family = "wasm")]
    return slice.to_vec();
}

/// The four control points of a cubic, without a copy from a slice.
#[inline]
pub(crate) fn points_of_cubic<P: Copy>(points: [P; 4]) -> Points<P> {
    #[cfg(not(target_family = "wasm"))]
    return Points::from_buf(points);
    #[cfg(target_family = "wasm")]
    return points.to_vec();
}
