//! Arc length.

use super::RationalCurve;
use super::numerators::derivative_numerator;
use crate::bernstein::wronskian::Wronskian;
use crate::curve::PointAtLength;
use crate::curve::arc_length::integral::{ArcLengthTable, Speed, times_binomials};
use crate::curve::arc_length::inverse::InverseByTable;
use crate::geometry::normalized::Normalized;
use crate::geometry::point::Point;
use crate::numeric::list::{Points, Scalars};
use casteljau_kernels::bernstein::de_casteljau::keep_between;
use casteljau_kernels::curve::arc_length::rational_cubic::{
    rational_length_in_plane, rational_length_in_space,
};
use casteljau_kernels::curve::arc_length::speed::rational_speed_integral;
use casteljau_kernels::numeric::vector::Vector;
use casteljau_kernels::numeric::zero::regula_falsi;
use glam::DVec3;

impl<P: Point> RationalCurve<P> {
    /// The length of the curve from t = 0 to 1.
    ///
    /// ∫ |D|/w² dt, where D/w² = B′, by Gauss–Legendre rules: the relative error is at most 10⁻¹² for weights whose ratios are at
    /// most 2²⁰ (up to degree 3, 2¹⁰⁰), with at most 4096 intervals. Up to degree 3 the intervals are halved until bounds of D and w
    /// show that a rule suffices; above, they are cut as for [`Curve::length`](crate::Curve::length). A curve that is a point
    /// has length 0.
    ///
    /// Source: Trefethen, *Approximation Theory and Approximation Practice*, ch. 19.
    ///
    /// ```
    /// use casteljau::{RationalCurve, glam::DVec2};
    ///
    /// let points = [(1.0, 0.0), (1.0, 1.0), (0.0, 1.0)].map(DVec2::from);
    /// let quarter = RationalCurve::new(&points, &[1.0, 0.5_f64.sqrt(), 1.0])?;
    /// assert!((quarter.length() - std::f64::consts::FRAC_PI_2).abs() < 1e-14);
    /// # Ok::<(), casteljau::Error>(())
    /// ```
    #[doc(alias = "arclen")]
    pub fn length(&self) -> f64 {
        if self.degree() == 1 {
            return self.start().distance(self.end());
        }
        let normalized = self.around_start();
        let length = self.length_by_kernel(&normalized).or_else(|| {
            let table = self.length_table(&normalized);
            table.map(|table| table.length())
        });
        length.unwrap_or(0.0) / normalized.scale
    }

    /// The parameter t at a given arc length s: the inverse of the length from 0 to t.
    ///
    /// s runs from 0 to the whole length; outside this range the result is the nearer end, 0 or 1. For a curve that is
    /// a point it is 0; for NaN it is NaN. The error, as a length, is at most 10⁻¹² of the whole length, or that of rounding t; ratios of
    /// weights are as for [`length`](Self::length).
    #[doc(alias = "inv_arclen")]
    pub fn time_at_length(&self, s: f64) -> f64 {
        if let Some(t) = self.time_by_kernel(s) {
            return t;
        }
        let normalized = self.around_start();
        let table = self.length_table(&normalized);
        let length = table
            .as_ref()
            .map_or(0.0, |table| table.length() / normalized.scale);
        InverseByTable::new(table, length, 0.0).time(s)
    }

    /// The point at the arc length s from the start, with tangent and normal; see
    /// [`time_at_length`](Self::time_at_length).
    pub fn point_at_length(&self, s: f64) -> PointAtLength<P> {
        let t = self.time_at_length(s);
        PointAtLength {
            t,
            point: self.eval(t),
            tangent: self.tangent(t),
            normal: self.normal(t),
        }
    }

    /// [`time_at_length`](Self::time_at_length) where the table is not accurate, by the lengths of parts.
    fn time_by_kernel(&self, s: f64) -> Option<f64> {
        let [max, min] = [f64::max, f64::min].map(|f| self.weights.iter().copied().reduce(f));
        if !(2..=3).contains(&self.degree()) || max? <= MAX_RATIO_OF_TABLE * min? {
            return None;
        }
        let length = self.length();
        if !(s > 0.0 && s < length) {
            return Some(if s.is_nan() {
                s
            } else {
                f64::from(u8::from(s > 0.0))
            });
        }
        let rest = |t: f64| s - self.split_unchecked(t).0.length();
        Some(regula_falsi(
            [0.0, 1.0],
            [s, s - length],
            f64::EPSILON,
            rest,
        ))
    }

    /// The map to points relative to the start, of a moderate size.
    fn around_start(&self) -> Normalized<P> {
        Normalized::around(self.start(), &self.points)
    }

    /// The length of the image, for degrees 2 and 3 and weights whose ratio is not extreme.
    fn length_by_kernel(&self, normalized: &Normalized<P>) -> Option<f64> {
        let about = Self {
            points: normalized.points(&self.points),
            weights: self.scaled_weights(),
        };
        // A curve passes no point more than three times, unless it is one.
        let [a, b, c] = [0.25, 0.5, 1.0].map(|t| about.eval(t));
        let shortest = a.norm() + (b - a).norm() + (c - b).norm();
        if P::DIMENSION == 2 && cfg!(feature = "fast") {
            let cubic = about.as_cubic(MAX_RATIO, P::to_2d)?;
            Some(rational_length_in_plane(&cubic, shortest))
        } else {
            let cubic = about.as_cubic(MAX_RATIO, P::to_3d)?;
            Some(rational_length_in_space(&cubic, shortest))
        }
    }

    /// The table of lengths of the image, unless the curve is a point.
    fn length_table(&self, normalized: &Normalized<P>) -> Option<ArcLengthTable<RationalSpeed>> {
        let points: Points<P> = normalized.points(&self.points);
        let is_point = points.iter().all(|&p| p == P::ZERO);
        (!is_point)
            .then(|| RationalSpeed::new(&points, self.scaled_weights()))
            .map(|speed| ArcLengthTable::new(speed, f64::INFINITY))
    }
}

/// For larger ratios of the weights the table of lengths is not accurate.
const MAX_RATIO_OF_TABLE: f64 = (1 << 20) as f64;

/// For larger ratios of the weights the squares of D in the kernel may leave the range of f64.
const MAX_RATIO: f64 = (1_u128 << 100) as f64;

/// The speed |D|/w² of a rational curve.
struct RationalSpeed {
    numerator: Points<DVec3>,
    weights: Scalars,
    /// D, w and their derivatives, each coefficient times its binomial coefficient.
    weighted: (Points<DVec3>, Scalars),
    rates: (Points<DVec3>, Scalars),
}

impl RationalSpeed {
    fn new<P: Point>(points: &[P], weights: Scalars) -> Self {
        let points: Points<DVec3> = points.iter().map(|p| p.to_3d()).collect();
        let wronskian = Wronskian::of_degree(points.len() - 1);
        let numerator = derivative_numerator(&wronskian, &points, &weights);
        Self {
            weighted: (times_binomials(&numerator), times_binomials(&weights)),
            rates: (
                times_binomials(&differences(&numerator)),
                times_binomials(&differences(&weights)),
            ),
            numerator,
            weights,
        }
    }
}

impl Speed for RationalSpeed {
    fn at(&self, t: f64) -> f64 {
        let w = horner(&self.weighted.1, t);
        Point::norm(horner(&self.weighted.0, t)) / (w * w)
    }

    fn integral(&self, lo: f64, hi: f64) -> f64 {
        rational_speed_integral(&self.weighted.0, &self.weighted.1, lo, hi)
    }

    /// D·D′ w − 2 D·D w′.
    fn growth(&self) -> impl Fn(f64) -> f64 + '_ {
        |t| {
            let (d, w) = (horner(&self.weighted.0, t), horner(&self.weighted.1, t));
            d.dot(horner(&self.rates.0, t)) * w - 2.0 * d.dot(d) * horner(&self.rates.1, t)
        }
    }

    /// The control vectors of D, divided by the square of the smallest weight.
    fn slopes_between(&self, lo: f64, hi: f64) -> Points<DVec3> {
        let (mut slopes, mut weights) = (self.numerator.clone(), self.weights.clone());
        keep_between(&mut slopes, lo, hi);
        keep_between(&mut weights, lo, hi);
        let min = weights.iter().copied().fold(f64::INFINITY, f64::min);
        slopes.iter_mut().for_each(|slope| *slope /= min * min);
        slopes
    }

    /// The coefficients of D in an interval bound its size too coarsely where the weights differ much: the speed is taken
    /// from three places instead.
    fn rounding_error(&self, lo: f64, hi: f64, slopes: &[DVec3]) -> f64 {
        let at = [lo, 0.5 * (lo + hi), hi].map(|t| self.at(t));
        let speed = at.into_iter().fold(0.0, f64::max);
        (slopes.len() as f64 + 4.0) * f64::EPSILON * speed
    }
}

/// The value at t for coefficients that are multiplied by their binomial coefficients.
#[inline]
fn horner<V: Vector>(coefficients: &[V], t: f64) -> V {
    let (s, mut power) = (1.0 - t, 1.0);
    let mut sum = V::default();
    for &c in coefficients.iter().rev() {
        sum = sum * t + c * power;
        power *= s;
    }
    sum
}

/// The Bernstein coefficients of the derivative; zero for a constant.
fn differences<V: Vector>(coefficients: &[V]) -> Points<V> {
    let n = coefficients.len() - 1;
    if n == 0 {
        return Points::from([V::default()].as_slice());
    }
    let pairs = coefficients.windows(2);
    pairs.map(|pair| (pair[1] - pair[0]) * n as f64).collect()
}
