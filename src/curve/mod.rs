//! One Bézier curve of any degree, in the plane or in space.
//!
//! Each file answers one question: where is the point ([`eval`](Curve::eval)), which way does it go
//! ([`tangent`](Curve::tangent)), which polyline is close enough ([`flatten`](Curve::flatten)) …

mod arc;
mod area;
mod basis;
mod bernstein;
mod bounds;
mod casteljau;
mod classify;
mod convert;
mod derivative;
mod deviation;
mod distance;
mod eval;
mod even;
mod extrema;
mod flatten;
mod flatten_any;
mod flatten_cubics;
mod frames;
mod hausdorff;
mod hull;
mod inflections;
mod interpolate;
mod intersect;
mod length;
mod moments;
mod nearest;
mod offset;
mod product;
mod reduce;
pub(crate) mod roots;
mod straight;
mod subdivide;
mod torsion;
mod trace;
mod turning;

pub use basis::Basis;
pub use bernstein::bernstein;
pub(crate) use bernstein::{bernstein_into, binomials};
pub use bounds::Bounds;
pub use classify::CurveKind;
pub use distance::Distance;
pub use flatten::Polyline;
pub use frames::Frame;
pub use intersect::{Intersection, IntersectionKind, SelfIntersection};
pub use moments::Moments;
pub use nearest::Nearest;
pub(crate) use nearest::nearest_on;
pub(crate) use offset::{SplineBuilder, offset_tolerance};
pub use reduce::Reduced;
pub use subdivide::Subdivision;
pub use trace::PathSink;
#[cfg(feature = "wasm")]
pub(crate) use {
    extrema::{extrema_of, times_of},
    inflections::inflections_of,
    nearest::nearest_parameter,
};

pub(crate) use area::{area_about, triangle_area};
pub(crate) use basis::apply;
pub(crate) use casteljau::{blossom_piece, evaluate_by_casteljau, split_into};
pub(crate) use eval::{MAX_OUTPUT_F64, check_segments, evaluate, evaluate_scalar};
pub(crate) use even::{ArcLengthInverse, check_length};
pub(crate) use flatten::{MAX_VERTICES, check_vertices};
pub(crate) use frames::{FRAME_NUMBERS, FrameSequence, frames_along};
pub(crate) use moments::moments;
#[cfg(feature = "wasm")]
pub(crate) use {casteljau::split_numbers, eval::cubic_scalar};

use crate::error::{Error, MAX_DEGREE};
use crate::point::Point;

use crate::list::points_of;
pub(crate) use crate::list::{Points, Scalars};

/// A Bézier curve of degree 1 to 64.
///
/// B(t) = Σ C(n, i) (1 − t)ⁿ⁻ⁱ tⁱ Pᵢ with the control points P₀ … Pₙ. The parameter t runs from 0 to 1; values
/// outside extrapolate. The curve starts at P₀ and ends at Pₙ, exactly, and lies in the convex hull of its control
/// points. A curve is a value: every change returns a new one.
///
/// ```
/// use casteljau::{Curve, glam::DVec2};
///
/// let curve = Curve::new(&[DVec2::new(0.0, 0.0), DVec2::new(1.0, 2.0), DVec2::new(2.0, 0.0)])?;
/// assert_eq!(curve.eval(0.5), DVec2::new(1.0, 1.0));
/// # Ok::<(), casteljau::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Curve<P: Point> {
    points: Points<P>,
}

impl<P: Point> Curve<P> {
    /// A curve from its control points P₀ … Pₙ, the degree being their number less one.
    ///
    /// Coincident points are allowed: the curve may be a point.
    ///
    /// # Errors
    /// [`Error::Count`] unless there are 2 to 65 points, [`Error::NotFinite`] for a NaN or an infinity.
    pub fn new(points: &[P]) -> Result<Self, Error> {
        if points.len() < 2 || points.len() > MAX_DEGREE + 1 {
            return Err(Error::Count {
                what: "points",
                expected: "2 to 65 control points (degree 1 to 64)",
                got: points.len(),
            });
        }
        check_finite("points", points)?;
        Ok(Self::from_slice(points))
    }

    /// A curve from points that were checked before.
    #[inline]
    pub(crate) fn from_slice(points: &[P]) -> Self {
        Self {
            points: points_of(points),
        }
    }

    /// A curve from points that were checked before, without a copy.
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
    /// A tolerance of 0 asks for equal numbers. Equal shapes with other control points (another degree, a reversed
    /// direction) are not equal.
    pub fn approx_eq(&self, other: &Self, tolerance: f64) -> bool {
        self.points.len() == other.points.len()
            && self
                .points
                .iter()
                .zip(&other.points)
                .all(|(&a, &b)| a == b || (a - b).length() <= tolerance)
    }

    /// The same curve run through backwards: B(1 − t).
    #[must_use]
    pub fn reverse(&self) -> Self {
        Self {
            points: self.points.iter().rev().copied().collect(),
        }
    }

    /// The image of the curve under an affine map, which is the curve of the mapped control points.
    #[must_use]
    pub fn transform(&self, map: &P::Affine) -> Self {
        Self {
            points: self.points.iter().map(|p| p.transform(map)).collect(),
        }
    }

    /// The same curve with one more control point: degree n + 1.
    ///
    /// Qᵢ = (i Pᵢ₋₁ + (n + 1 − i) Pᵢ) / (n + 1), Q₀ = P₀, Qₙ₊₁ = Pₙ. Source: Farin, *Curves and Surfaces for
    /// CAGD*, 5th ed., §6.1.
    ///
    /// # Errors
    /// [`Error::Range`] at degree 64.
    pub fn elevate(&self) -> Result<Self, Error> {
        if self.degree() >= MAX_DEGREE {
            return Err(Error::Range {
                what: "degree",
                expected: "a degree below 64",
                got: 64.0,
            });
        }
        Ok(self.elevated())
    }

    /// [`elevate`](Self::elevate) for a curve whose degree is known to be below 64.
    pub(crate) fn elevated(&self) -> Self {
        let count = self.points.len();
        let inner = (1..count).map(|i| self.points[i].lerp(self.points[i - 1], ratio(i, count)));
        let ends = |p: P| std::iter::once(p);
        Self {
            points: ends(self.start())
                .chain(inner)
                .chain(ends(self.end()))
                .collect(),
        }
    }

    /// The largest absolute coordinate of the control points, which bounds that of the curve.
    pub(crate) fn max_abs(&self) -> f64 {
        max_abs(&self.points)
    }
}

/// i / n as a number; both are small counts.
#[inline]
pub(crate) fn ratio(i: usize, n: usize) -> f64 {
    i as f64 / n as f64
}

/// The largest absolute coordinate.
pub(crate) fn max_abs<P: Point>(points: &[P]) -> f64 {
    points
        .iter()
        .fold(0.0, |largest: f64, p| largest.max(p.max_abs()))
}

/// Refuses the first point with a NaN or an infinity.
pub(crate) fn check_finite<P: Point>(what: &'static str, points: &[P]) -> Result<(), Error> {
    match points.iter().position(|p| !p.is_finite()) {
        Some(index) => Err(Error::NotFinite {
            what,
            index,
            got: first_not_finite(points[index]),
        }),
        None => Ok(()),
    }
}

/// The first coordinate of a point that is not finite.
fn first_not_finite<P: Point>(point: P) -> f64 {
    let mut coordinates = (0..P::DIMENSION).map(|axis| point.coordinate(axis));
    coordinates.find(|x| !x.is_finite()).unwrap_or(f64::NAN)
}

/// Refuses a tolerance that is not positive or finer than the coordinates can resolve: 4 ulps of the largest.
///
/// Below that, rounding alone moves points farther than the tolerance allows.
pub(crate) fn check_tolerance(tolerance: f64, largest_coordinate: f64) -> Result<(), Error> {
    if !(tolerance > 0.0 && tolerance < f64::INFINITY) {
        return Err(Error::Range {
            what: "tolerance",
            expected: "a finite number above 0",
            got: tolerance,
        });
    }
    let min = 4.0 * ulp(largest_coordinate);
    if tolerance < min {
        Err(Error::Tolerance {
            min,
            got: tolerance,
        })
    } else {
        Ok(())
    }
}

/// The distance from |x| to the next larger number; 0 for 0.
pub(crate) fn ulp(x: f64) -> f64 {
    let x = x.abs();
    if x == 0.0 {
        0.0
    } else {
        (x.next_up() - x)
            .min(x - x.next_down())
            .max(f64::MIN_POSITIVE * f64::EPSILON)
    }
}
