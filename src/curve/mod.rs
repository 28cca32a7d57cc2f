//! One Bézier curve of any degree, in the plane or in space.
//!
//! Each file implements one operation or query: evaluation ([`eval`](Curve::eval)), tangents
//! ([`tangent`](Curve::tangent)), flattening ([`flatten`](Curve::flatten)) …
//!
//! In the kernels, for their speed: points of a plane cubic at equal parameters, the rates of chords, bounds of the curvature.

pub(crate) mod arc_length;
pub(crate) mod area;
pub(crate) mod basis;
mod bounds;
pub(crate) mod carried_frame;
mod classify;
mod convert;
mod copy;
mod curvature_numerator;
pub(crate) mod derivative;
pub(crate) mod elevate;
pub(crate) mod eval;
pub(crate) mod extrema;
pub(crate) mod flatten;
pub(crate) mod frames;
pub(crate) mod hodograph;
mod hull;
pub(crate) mod inflections;
mod interpolate;
pub(crate) mod intersect;
pub(crate) mod moments;
pub(crate) mod nearest;
mod reduce;
pub(crate) mod split;
pub(crate) mod straight;
pub(crate) mod subdivide;
mod torsion;
pub(crate) mod trace;
pub(crate) mod with_derivatives;

pub use crate::bernstein::polynomials::bernstein;
pub use crate::geometry::bounds::Bounds;
pub use arc_length::point_at_length::PointAtLength;
pub use basis::Basis;
pub use classify::CurveKind;
pub use copy::{Cubic, Line, Quad};
pub use flatten::Polyline;
pub use frames::Frame;
pub use intersect::{Intersection, IntersectionKind, SelfIntersection};
pub use moments::Moments;
pub use nearest::Nearest;
pub use nearest::distance::Distance;
pub use reduce::Reduced;
pub use subdivide::Subdivision;
pub use trace::PathSink;

use crate::geometry::check::{check_points, images, max_abs};
use crate::geometry::error::{Error, MAX_DEGREE};
use crate::geometry::point::Point;
use crate::numeric::list::{Points, points_of};

/// A Bézier curve of degree 1 to 64.
///
/// B(t) = Σ C(n, i) (1 − t)ⁿ⁻ⁱ tⁱ Pᵢ with the control points P₀ … Pₙ. The parameter t runs from 0 to 1; values outside
/// extrapolate. The curve starts at P₀ and ends at Pₙ, exactly, and lies in the convex hull of its control points. A
/// curve is immutable: every operation returns a new one.
///
/// ```
/// use casteljau::{Curve, glam::DVec2};
///
/// let curve = Curve::new(&[DVec2::new(0.0, 0.0), DVec2::new(1.0, 2.0), DVec2::new(2.0, 0.0)])?;
/// assert_eq!(curve.eval(0.5), DVec2::new(1.0, 1.0));
/// # Ok::<(), casteljau::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
#[must_use = "methods return new values"]
pub struct Curve<P: Point> {
    points: Points<P>,
}

impl<P: Point> Curve<P> {
    /// Makes a curve from its control points P₀ … Pₙ. The degree is their number minus one.
    ///
    /// Coincident points are allowed; the curve may be a single point.
    ///
    /// # Errors
    /// [`Error::Count`] unless there are 2 to 65 points, [`Error::NotFinite`] for a NaN or an infinity, [`Error::Item`] for a coordinate
    /// beyond [`MAX_COORDINATE`](crate::MAX_COORDINATE).
    pub fn new(points: &[P]) -> Result<Self, Error> {
        if points.len() < 2 || points.len() > MAX_DEGREE + 1 {
            return Err(Error::Count {
                what: "points",
                expected: "2 to 65 control points (degree 1 to 64)",
                got: points.len(),
            });
        }
        check_points("points", points)?;
        Ok(Self::from_slice(points))
    }

    /// Makes a curve from points that are already checked.
    #[inline]
    pub(crate) fn from_slice(points: &[P]) -> Self {
        Self {
            points: points_of(points),
        }
    }

    /// Makes a curve from points that are already checked, without a copy.
    #[inline]
    pub(crate) fn from_points(points: Points<P>) -> Self {
        Self { points }
    }

    /// The degree n; a line has 1, a cubic 3.
    #[inline]
    pub fn degree(&self) -> usize {
        self.points.len() - 1
    }

    /// The control points P₀ … Pₙ.
    #[inline]
    pub fn control_points(&self) -> &[P] {
        &self.points
    }

    /// The first point, P₀.
    #[inline]
    pub fn start(&self) -> P {
        self.points[0]
    }

    /// The last point, Pₙ.
    #[inline]
    pub fn end(&self) -> P {
        self.points[self.points.len() - 1]
    }

    /// Whether both curves have the same degree and every control point lies within `tolerance` of its counterpart.
    ///
    /// A tolerance of 0 requires equal numbers. Curves of equal shape but different control points (another degree,
    /// reversed direction) are not equal.
    pub fn approx_eq(&self, other: &Self, tolerance: f64) -> bool {
        self.points.len() == other.points.len()
            && self
                .points
                .iter()
                .zip(&other.points)
                .all(|(&a, &b)| a == b || (a - b).norm() <= tolerance)
    }

    /// The curve in the opposite direction: B(1 − t).
    pub fn reverse(&self) -> Self {
        Self {
            points: self.points.iter().rev().copied().collect(),
        }
    }

    /// The image of the curve under an affine map, which is the curve of the mapped control points.
    ///
    /// # Errors
    /// [`Error::NotFinite`] and [`Error::Item`] for an image that is not finite or exceeds
    /// [`MAX_COORDINATE`](crate::MAX_COORDINATE).
    pub fn transform(&self, map: &P::Affine) -> Result<Self, Error> {
        images(&self.points, map).map(|points| Self::from_slice(&points))
    }

    /// The largest absolute coordinate of the control points, which bounds that of the curve.
    pub(crate) fn max_abs(&self) -> f64 {
        max_abs(&self.points)
    }
}
