//! Approximation by polynomial curves.
//!
//! A part is replaced by the cubic with the same ends and end tangents, and halved until that is close enough. With the
//! numerator A, the denominator w and the cubic C, the error is (A − wC)/w. Its numerator is a polynomial, so the largest of its
//! Bernstein coefficients divided by the smallest weight is a bound. It falls to 1/16 with each halving.

use super::RationalCurve;
use crate::bernstein::polynomials::binomials;
use crate::curve::Curve;
use crate::curve::trace::{CUBIC_HALVINGS, PathSink, hidden_by_rounding};
use crate::geometry::check::check_tolerance;
use crate::geometry::error::Error;
use crate::geometry::point::Point;
use crate::numeric::float::{exponent, ratio};
use crate::spline::Spline;
use glam::DVec2;

impl<P: Point> RationalCurve<P> {
    /// A spline of cubics within `tolerance` of the curve, in the unit of the points; exactly the curve, as one segment of its degree, if
    /// all weights are equal.
    ///
    /// Its joints are smooth: each cubic has the ends and the end tangents of its part of the curve. A circle of radius 1
    /// takes 8 cubics for 10⁻⁴ and 16 for 10⁻⁶.
    ///
    /// # Errors
    /// As [`flatten`](Self::flatten) for the tolerance.
    pub fn to_spline(&self, tolerance: f64) -> Result<Spline<P>, Error> {
        check_tolerance(tolerance, self.max_abs())?;
        let mut points = vec![self.start()];
        let mut degrees = Vec::new();
        self.for_each_polynomial(tolerance, &mut |curve| {
            degrees.push(curve.degree());
            points.extend_from_slice(&curve.control_points()[1..]);
        });
        Ok(Spline::from_parts(points, &degrees, false))
    }

    /// Calls `act` with the curve if it is polynomial, and otherwise with lines or cubics in its place.
    pub(crate) fn for_each_polynomial(&self, tolerance: f64, act: &mut impl FnMut(&Curve<P>)) {
        // Each halving also halves the ratio of the weights on the side where it is large.
        let weights = self.scaled_weights();
        let min = weights.iter().copied().fold(f64::INFINITY, f64::min);
        let halvings = CUBIC_HALVINGS + 1 + exponent(min).unsigned_abs() as usize;
        // Otherwise no bound would end the halving.
        let halvings = if self.points.iter().all(|p| p.is_finite()) {
            halvings
        } else {
            0
        };
        let hidden = hidden_by_rounding(self.degree(), self.max_abs());
        self.halve_to_cubics(tolerance.max(hidden), halvings, act);
    }

    fn halve_to_cubics(&self, tolerance: f64, halvings: usize, act: &mut impl FnMut(&Curve<P>)) {
        if self.degree() == 1 {
            return act(&Curve::from_slice(&self.points));
        }
        if let Some(curve) = self.as_polynomial() {
            return act(&curve);
        }
        let (cubic, error) = self.cubic_of_conic().unwrap_or_else(|| {
            let cubic = cubic_of_same_tangents(&self.points, &self.weights);
            let error = error_bound(&self.points, &self.scaled_weights(), &cubic);
            (cubic, error)
        });
        if halvings == 0 || error <= tolerance {
            return act(&Curve::from_slice(&cubic));
        }
        // The halves of a conic in standard form are alike.
        let standard = if self.degree() == 2 {
            self.reparametrize().ok()
        } else {
            None
        };
        let (left, right) = standard.as_ref().unwrap_or(self).halve();
        left.halve_to_cubics(tolerance, halvings - 1, act);
        right.halve_to_cubics(tolerance, halvings - 1, act);
    }

    /// For a conic, the cubic that has its ends, its end tangents and its point in the middle, and a bound on the distance;
    /// it falls to 1/64 with each halving.
    ///
    /// With the weights 1, w, 1 and barycentric coordinates τ of the control points, the conic is f = τ₁² − 4w² τ₀τ₂ = 0. The cubic
    /// has the handles λ (P₁ − P₀) and λ (P₁ − P₂) with λ = 4w/(3(1 + w)); there f = w²κ² (t(1 − t)(1 − 2t))² with κ = 2 − 3λ, at most
    /// w²κ²/108. Parallel to the median through P₁, f changes by 2τ₁ + 2w²(1 − τ₁) ≥ 2 min(1, w²) for a step of half the length of
    /// P₀ − 2P₁ + P₂. Source: Floater, "An O(h²ⁿ) Hermite approximation for conic sections", CAGD 14 (1997).
    fn cubic_of_conic(&self) -> Option<([P; 4], f64)> {
        let ([a, b, c], [u, v, w]) = (&self.points[..], &self.weights[..]) else {
            return None;
        };
        let w = v / (u * w).sqrt();
        let reach = 4.0 * w / (3.0 * (1.0 + w));
        let cubic = [*a, *a + (*b - *a) * reach, *c + (*b - *c) * reach, *c];
        // 2 − 3λ without cancellation.
        let rest = 2.0 * (1.0 - w) / (1.0 + w);
        let height = (*a - *b - (*b - *c)).norm();
        Some((cubic, (w * w).max(1.0) * rest * rest / 432.0 * height))
    }
}

/// The cubic with the ends and end derivatives of a rational curve: the first is n·w₁/w₀·(P₁ − P₀), the last its mirror image.
pub(crate) fn cubic_of_same_tangents<P: Point>(points: &[P], w: &[f64]) -> [P; 4] {
    let n = points.len() - 1;
    let reach = |end: usize, inner: usize| {
        points[end] + (points[inner] - points[end]) * (ratio(n, 3) * w[inner] / w[end])
    };
    [points[0], reach(0, 1), reach(n, n - 1), points[n]]
}

/// A bound on the distance of a rational curve from a cubic at equal parameters.
pub(crate) fn error_bound<P: Point>(points: &[P], weights: &[f64], cubic: &[P; 4]) -> f64 {
    let (n, shares) = (points.len() - 1, [1.0, 3.0, 3.0, 1.0]);
    let (of_points, of_product) = (binomials(n), binomials(n + 3));
    let mut largest: f64 = 0.0;
    for (k, whole) in of_product.iter().enumerate() {
        let terms = k.saturating_sub(n)..=k.min(3);
        let sum = terms.fold(P::default(), |sum, i| {
            let share = shares[i] * of_points[k - i] * weights[k - i];
            sum + (points[k - i] - cubic[i]) * share
        });
        largest = largest.max(sum.norm() / whole);
    }
    largest / weights.iter().copied().fold(f64::INFINITY, f64::min)
}

impl RationalCurve<DVec2> {
    /// Sends the curve to `sink` as lines and cubics within `tolerance`, beginning with a `move_to` its start.
    ///
    /// # Errors
    /// As [`flatten`](Self::flatten) for the tolerance.
    pub fn trace_within(
        &self,
        sink: &mut (impl PathSink + ?Sized),
        tolerance: f64,
    ) -> Result<(), Error> {
        check_tolerance(tolerance, self.max_abs())?;
        sink.move_to(self.start());
        self.for_each_polynomial(tolerance, &mut |curve| {
            curve.trace_on(sink, Some(tolerance));
        });
        Ok(())
    }
}
