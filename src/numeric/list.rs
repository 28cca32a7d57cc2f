//! Short lists: with inline storage, or, without the feature `fast`, plain vectors, which are less code.
//!
//! With plain vectors, [`split`](crate::Curve::split) takes 7 to 11 times as long, clones and derivatives twice, parts 1.4
//! times; intersections, and bounds of degree 5, take 5 to 10 % less time.

#[cfg(feature = "fast")]
pub(crate) type List<T, const N: usize> = smallvec::SmallVec<[T; N]>;
#[cfg(not(feature = "fast"))]
pub(crate) type List<T, const N: usize> = Vec<T>;

/// The control points of a curve.
pub(crate) type Points<P> = List<P, 4>;

/// Numbers that belong to control points: coefficients, roots.
pub(crate) type Scalars = List<f64, 4>;

/// The control points of a patch.
#[cfg(feature = "surfaces")]
pub(crate) type Net = List<glam::DVec3, 16>;

/// The control points of a slice; with inline storage a copy of bytes, where `From` would copy point by point.
#[inline]
pub(crate) fn points_of<P: Copy>(slice: &[P]) -> Points<P> {
    #[cfg(feature = "fast")]
    return Points::from_slice(slice);
    #[cfg(not(feature = "fast"))]
    return slice.to_vec();
}

/// The four control points of a cubic, without a copy from a slice.
#[inline]
pub(crate) fn points_of_cubic<P: Copy>(points: [P; 4]) -> Points<P> {
    #[cfg(feature = "fast")]
    return Points::from_buf(points);
    #[cfg(not(feature = "fast"))]
    return points.to_vec();
}
