//! Rational curves: control points with weights.
//!
//! A rational curve is the projection of a polynomial one: the homogeneous points (wᵢPᵢ, wᵢ) are the control points of
//! a curve (A, w), and the rational curve is A/w. What only interpolates works on points with weights
//! ([`weighted`]); distances, extrema and curvature use polynomials made of differences of points
//! ([`numerators`]), never homogeneous coordinates.

mod area;
mod ellipse;
mod eval;
mod flatten;
mod intersect;
mod length;
mod nearest;
#[cfg(feature = "surfaces")]
mod network;
mod numerators;
mod nurbs;
#[cfg(feature = "surfaces")]
mod patch;
mod shape;
pub(crate) mod spline;
mod split;
#[cfg(feature = "surfaces")]
mod surface;
mod transform;
mod weighted;

pub use ellipse::EllipticalArc;
#[cfg(feature = "surfaces")]
pub use network::RationalSurface;
pub use nurbs::NurbsCurve;
#[cfg(feature = "surfaces")]
pub use patch::RationalPatch;
#[cfg(feature = "surfaces")]
pub use surface::NurbsSurface;

use crate::curve::Curve;
use crate::geometry::check::{check_points, max_abs};
use crate::geometry::error::{Error, MAX_DEGREE};
use crate::geometry::point::Point;
use crate::numeric::list::{Points, Scalars, points_of};
use weighted::{Homogeneous, WeightedPoint, are_proportional, weight_scale};

/// The largest weight, 2⁵⁰⁰, and the inverse of the smallest: products of two weights stay in the range of f64.
pub(crate) const MAX_WEIGHT: f64 = crate::geometry::check::MAX_COORDINATE;

/// A rational Bézier curve of degree 1 to 64, in the plane or in space.
///
/// B(t) = Σ wᵢ Bᵢ(t) Pᵢ / Σ wᵢ Bᵢ(t), where Bᵢ(t) = C(n, i) (1 − t)ⁿ⁻ⁱ tⁱ, with the control points P₀ … Pₙ and the weights
/// w₀ … wₙ above 0. Equal weights give the polynomial [`Curve`]; a larger weight pulls the curve towards its point. The
/// curve starts at P₀ and ends at Pₙ, exactly, and lies in the convex hull of its control points. Conic sections are
/// rational curves of degree 2: [`conic`](Self::conic). A common factor of all weights changes nothing.
///
/// Source: Farin, *Curves and Surfaces for CAGD*, ch. 13; Piegl and Tiller, *The NURBS Book*, §1.4.
///
/// ```
/// use casteljau::{RationalCurve, glam::DVec2};
///
/// // A quarter of the unit circle.
/// let points = [(1.0, 0.0), (1.0, 1.0), (0.0, 1.0)].map(DVec2::from);
/// let quarter = RationalCurve::new(&points, &[1.0, 0.5_f64.sqrt(), 1.0])?;
/// let p = quarter.eval(0.3);
/// assert!((p.x * p.x + p.y * p.y - 1.0).abs() < 1e-15);
/// # Ok::<(), casteljau::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
#[must_use = "methods return new values"]
pub struct RationalCurve<P: Point> {
    points: Points<P>,
    weights: Scalars,
}

impl<P: Point> RationalCurve<P> {
    /// Makes a curve from its control points and as many weights. The degree is their number minus one.
    ///
    /// # Errors
    /// [`Error::Count`] unless there are 2 to 65 points and as many weights; [`Error::NotFinite`] for a NaN or an infinity;
    /// [`Error::Item`] for a coordinate beyond [`MAX_COORDINATE`](crate::MAX_COORDINATE) and for a weight that is not
    /// above 0, or not between 2⁻⁵⁰⁰ and 2⁵⁰⁰.
    pub fn new(points: &[P], weights: &[f64]) -> Result<Self, Error> {
        if points.len() < 2 || points.len() > MAX_DEGREE + 1 {
            return Err(Error::Count {
                what: "points",
                expected: "2 to 65 control points (degree 1 to 64)",
                got: points.len(),
            });
        }
        check_points("points", points)?;
        check_weights(weights, points.len())?;
        Ok(Self {
            points: points_of(points),
            weights: points_of(weights),
        })
    }

    /// The conic section of degree 2 with the weights 1, w, 1.
    ///
    /// It touches the lines p₀p₁ and p₁p₂ at its ends. w < 1 gives an arc of an ellipse, w = 1 of a parabola, w > 1 of a
    /// hyperbola. If p₁ is at the same distance from both ends, w = cos α gives an arc of a circle, where 2α is its angle,
    /// and α is the angle between p₀p₁ and p₀p₂.
    ///
    /// # Errors
    /// As [`new`](Self::new); the weight is `weights[1]`.
    ///
    /// Source: Farin, *Curves and Surfaces for CAGD*, §12.
    pub fn conic(p0: P, p1: P, p2: P, w: f64) -> Result<Self, Error> {
        Self::new(&[p0, p1, p2], &[1.0, w, 1.0])
    }

    /// Makes a curve from valid parts.
    fn from_weighted(parts: &[WeightedPoint<P>]) -> Self {
        Self {
            points: parts.iter().map(|part| part.point).collect(),
            weights: parts.iter().map(|part| part.weight).collect(),
        }
    }

    /// The curve of valid points with weights, or of points of which some are not finite.
    #[cfg(feature = "surfaces")]
    pub(crate) fn from_valid(parts: impl Iterator<Item = (P, f64)>) -> Self {
        let (points, weights) = parts.unzip();
        Self { points, weights }
    }

    /// The curve of the given degree whose control points begin at an index of valid lists.
    fn between(points: &[P], weights: &[f64], from: usize, degree: usize) -> Self {
        Self {
            points: points_of(&points[from..=from + degree]),
            weights: points_of(&weights[from..=from + degree]),
        }
    }

    /// Replaces the end.
    fn end_at(&mut self, end: WeightedPoint<P>) {
        let n = self.degree();
        (self.points[n], self.weights[n]) = (end.point, end.weight);
    }

    /// The degree n; a conic has 2.
    #[inline]
    pub fn degree(&self) -> usize {
        self.points.len() - 1
    }

    /// The control points P₀ … Pₙ.
    #[inline]
    pub fn control_points(&self) -> &[P] {
        &self.points
    }

    /// The weights w₀ … wₙ.
    #[inline]
    pub fn weights(&self) -> &[f64] {
        &self.weights
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

    /// The curve in the opposite direction: B(1 − t).
    pub fn reverse(&self) -> Self {
        Self {
            points: self.points.iter().rev().copied().collect(),
            weights: self.weights.iter().rev().copied().collect(),
        }
    }

    /// Whether both curves have the same degree, every control point lies within `tolerance` of its counterpart, and the
    /// weights are equal up to a common factor, each within `tolerance` times the largest weight.
    pub fn approx_eq(&self, other: &Self, tolerance: f64) -> bool {
        let close = |(&a, &b): (&P, &P)| a == b || (a - b).norm() <= tolerance;
        self.points.len() == other.points.len()
            && self.points.iter().zip(&other.points).all(close)
            && are_proportional(&self.weights, &other.weights, tolerance)
    }

    /// The polynomial curve if all weights are equal.
    pub(crate) fn as_polynomial(&self) -> Option<Curve<P>> {
        let first = self.weights[0];
        let is_polynomial = self.weights.iter().all(|&w| w == first);
        is_polynomial.then(|| Curve::from_slice(&self.points))
    }

    /// The control points with their weights.
    fn weighted(&self) -> Points<WeightedPoint<P>> {
        let parts = self.points.iter().zip(&self.weights);
        parts
            .map(|(&point, &weight)| WeightedPoint { point, weight })
            .collect()
    }

    /// The power of two that makes the largest weight 1 to 2.
    fn weight_scale(&self) -> f64 {
        weight_scale(&self.weights)
    }

    /// The homogeneous control points relative to an origin, with a largest weight of 1 to 2.
    fn homogeneous(&self, origin: P) -> Points<Homogeneous<P>> {
        let scale = self.weight_scale();
        let parts = self.points.iter().zip(&self.weights);
        parts
            .map(|(&p, &w)| Homogeneous::new(p - origin, w * scale))
            .collect()
    }

    /// The largest absolute coordinate of the control points, which bounds that of the curve.
    fn max_abs(&self) -> f64 {
        max_abs(&self.points)
    }
}

impl<P: Point> From<&Curve<P>> for RationalCurve<P> {
    /// The same curve with the weights 1.
    fn from(curve: &Curve<P>) -> Self {
        let points = points_of(curve.control_points());
        let weights = points.iter().map(|_| 1.0).collect();
        Self { points, weights }
    }
}

/// Returns an error unless there are `count` weights, each between 2⁻⁵⁰⁰ and 2⁵⁰⁰.
fn check_weights(weights: &[f64], count: usize) -> Result<(), Error> {
    if weights.len() != count {
        return Err(Error::Count {
            what: "weights",
            expected: "a weight for each point",
            got: weights.len(),
        });
    }
    Error::unless_finite("weights", weights)?;
    let is_valid = |&w: &f64| (1.0 / MAX_WEIGHT..=MAX_WEIGHT).contains(&w);
    match weights.iter().position(|w| !is_valid(w)) {
        None => Ok(()),
        Some(index) => Err(Error::Item {
            what: "weights",
            index,
            expected: "a number above 0, from 2^-500 to 2^500",
            got: weights[index],
        }),
    }
}
