//! Evaluation, derivatives, tangent, normal and curvature.

use super::RationalCurve;
use super::weighted::Homogeneous;
use crate::bernstein::evaluate::{evaluate_scalar, weigh3, weigh4};
use crate::bernstein::polynomials::binomials;
use crate::curve::Curve;
use crate::curve::derivative::Taylor;
use crate::curve::eval::check_segments;
use crate::geometry::check::clamp_to_limit;
use crate::geometry::error::{Error, MAX_DEGREE};
use crate::geometry::point::Point;
use crate::numeric::float::{as_f64, ratio};
use crate::numeric::list::{Points, Scalars};
use casteljau_kernels::bernstein::de_casteljau::{keep_after, lerp};

impl<P: Point> RationalCurve<P> {
    /// The point B(t).
    ///
    /// t in [0, 1] runs along the curve; the end points are exact, and the others are within 4 ulps of the largest coordinate up
    /// to degree 3. Other values extrapolate as long as the denominator Σ wᵢ Bᵢ(t) is above 0, and give NaN where it is not.
    /// Source: Farin, *Curves and Surfaces for CAGD*, §13.1.
    #[inline]
    pub fn eval(&self, t: f64) -> P {
        if t == 0.0 {
            return self.start();
        }
        if t == 1.0 {
            return self.end();
        }
        // Products of the largest coordinates and weights stay in the range of f64.
        let at = |i: usize| Homogeneous::new(self.points[i], self.weights[i]);
        let sum = match self.degree() {
            1 => lerp(at(0), at(1), t),
            2 => weigh3([at(0), at(1), at(2)], t),
            3 => weigh4([at(0), at(1), at(2), at(3)], t),
            n => {
                let mut row = [Homogeneous::default(); MAX_DEGREE + 1];
                (0..=n).for_each(|i| row[i] = at(i));
                keep_after(&mut row[..=n], t);
                row[0]
            }
        };
        sum.point()
    }

    /// `segments` + 1 points at t = i / `segments`, both ends included.
    ///
    /// Equal steps of t are not equal steps of arc length.
    ///
    /// # Errors
    /// [`Error::Range`] for 0 segments, [`Error::TooMany`] above 1 GiB of numbers.
    pub fn sample(&self, segments: usize) -> Result<Vec<P>, Error> {
        check_segments(segments, P::DIMENSION)?;
        let at = |i| self.eval(ratio(i, segments));
        Ok((0..=segments).map(at).collect())
    }

    /// The points at the given parameters.
    pub fn eval_at(&self, ts: &[f64]) -> Vec<P> {
        ts.iter().map(|&t| self.eval(t)).collect()
    }

    /// The k-th derivative at t; k = 0 is the point itself.
    ///
    /// With the origin at B(t), A = wB, and so A⁽ᵏ⁾ = Σ C(k, i) w⁽ⁱ⁾ B⁽ᵏ⁻ⁱ⁾, which is solved for the derivatives of B in turn.
    /// A coordinate beyond [`MAX_COORDINATE`](crate::MAX_COORDINATE) is set to it. NaN where [`eval`](Self::eval) is.
    ///
    /// # Errors
    /// [`Error::Range`] for k above 64.
    ///
    /// Source: Piegl and Tiller, *The NURBS Book*, §4.3.
    pub fn derivative_at(&self, t: f64, k: usize) -> Result<P, Error> {
        if k > MAX_DEGREE {
            return Err(Error::Range {
                what: "k",
                expected: "0 to 64",
                got: as_f64(k),
            });
        }
        let point = self.eval(t);
        if k == 0 || !point.is_finite() {
            return Ok(point);
        }
        let numerator = self.numerator(point);
        let mut factorial = 1.0;
        let mut coefficients: Points<P> = (1..=k)
            .map(|order| {
                factorial *= as_f64(order);
                numerator.derivative_at(t, order) / factorial
            })
            .collect();
        divide_series(&mut coefficients, &self.denominator_series(t));
        Ok(clamp_to_limit(coefficients[k - 1] * factorial))
    }

    /// The unit tangent at t: the direction of the first derivative that does not vanish at t.
    ///
    /// At zero-length handles and at cusps this is the limit from the right, except at t = 1, where it is the limit
    /// from the left. The result is zero for a curve that is a point.
    pub fn tangent(&self, t: f64) -> P {
        self.taylor(t).map_or(P::default(), |local| local.tangent())
    }

    /// The unit normal at t: in the plane the tangent rotated by +90°, in space the principal normal.
    ///
    /// It is zero for a curve that is a point and, in space, for a straight one; see [`Curve::normal`].
    pub fn normal(&self, t: f64) -> P {
        self.taylor(t).map_or(P::default(), |local| local.normal())
    }

    /// The curvature κ = (B′ × B″) / |B′|³ at t, in 1 / unit of length; signs and limits as of [`Curve::curvature`].
    ///
    /// Source: Farin, *Curves and Surfaces for CAGD*, §13.6.
    pub fn curvature(&self, t: f64) -> f64 {
        self.taylor(t).map_or(0.0, |local| local.curvature())
    }

    /// w(B − origin): a polynomial curve with the control points wᵢ(Pᵢ − origin), where the largest weight is 1 to 2.
    fn numerator(&self, origin: P) -> Curve<P> {
        let points = self.homogeneous(origin);
        Curve::from_points(points.into_iter().map(|p| p.vector).collect())
    }

    /// w₀, w₁, …: the Taylor coefficients Σ wₖ τᵏ of the denominator at t, where the largest weight is 1 to 2.
    fn denominator_series(&self, t: f64) -> Scalars {
        let scale = self.weight_scale();
        let mut differences: Scalars = self.weights.iter().map(|w| w * scale).collect();
        let orders = binomials(self.degree()).into_iter();
        orders
            .map(|binomial| {
                let coefficient = binomial * evaluate_scalar(&differences, t);
                for i in 1..differences.len() {
                    differences[i - 1] = differences[i] - differences[i - 1];
                }
                differences.truncate(differences.len().max(2) - 1);
                coefficient
            })
            .collect()
    }

    /// The Taylor expansion at t, where each order lacks a sum of multiples of lower orders; `None` for a curve that is a point.
    ///
    /// It is that of the numerator w(B − B(t)), divided by w at t. Tangent, normal and curvature depend on the first order that
    /// does not vanish and the first later one that is not parallel to it, of the latter only across the former; so
    /// those sums do not matter, and nothing of their size cancels.
    fn taylor(&self, t: f64) -> Option<Taylor<P>> {
        let mut local = self.numerator(self.eval(t)).taylor(t)?;
        let scale = self.weight_scale();
        let weights: Scalars = self.weights.iter().map(|w| w * scale).collect();
        local.scale /= evaluate_scalar(&weights, t);
        Some(local)
    }
}

/// Divides Σ aₖ τᵏ, k from 1, by Σ wₖ τᵏ, k from 0: sₖ = (aₖ − w₁ sₖ₋₁ − … − wₖ₋₁ s₁) / w₀.
fn divide_series<P: Point>(a: &mut [P], w: &[f64]) {
    for k in 0..a.len() {
        let known = (1..w.len().min(k + 1)).fold(P::default(), |sum, i| sum + a[k - i] * w[i]);
        a[k] = (a[k] - known) / w[0];
    }
}
