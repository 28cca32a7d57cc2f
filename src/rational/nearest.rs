//! The point of a rational curve that is nearest to another one.

use super::RationalCurve;
use super::numerators::derivative_numerator;
use super::weighted::Homogeneous;
use crate::bernstein::evaluate::evaluate;
use crate::bernstein::product::Binomials;
use crate::bernstein::roots::max_of;
use crate::bernstein::wronskian::Wronskian;
use crate::curve::Nearest;
use crate::curve::nearest::{DistanceToOrigin, nearest_to_origin};
use crate::geometry::check::check_points;
use crate::geometry::error::Error;
use crate::geometry::normalized::Normalized;
use crate::geometry::point::Point;
use crate::numeric::float::as_f64;
use crate::numeric::list::{Points, Scalars, points_of};
use casteljau_kernels::curve::nearest::search::{
    rational_nearest_in_plane, rational_nearest_in_space,
};

impl<P: Point> RationalCurve<P> {
    /// The point of the curve that is nearest to p: the global minimum of |B(t) − p| for t in \[0, 1\], end points included.
    ///
    /// The candidates are the roots of (A − wp)·D, of degree 3n − 2, where A = wB and D/w² = B′. All are isolated by their
    /// Bernstein coefficients; the search is that of [`Curve::nearest`](crate::Curve::nearest), with its limits of work and
    /// its rules for equal distances.
    ///
    /// # Errors
    /// [`Error::NotFinite`] for a NaN or an infinity, [`Error::Item`] for a coordinate beyond the limit.
    ///
    /// ```
    /// use casteljau::{RationalCurve, glam::DVec2};
    ///
    /// let points = [(1.0, 0.0), (1.0, 1.0), (0.0, 1.0)].map(DVec2::from);
    /// let quarter = RationalCurve::new(&points, &[1.0, 0.5_f64.sqrt(), 1.0])?;
    /// let nearest = quarter.nearest(DVec2::new(3.0, 4.0))?;
    /// assert!((nearest.distance - 4.0).abs() < 1e-14);
    /// # Ok::<(), casteljau::Error>(())
    /// ```
    #[doc(alias = "closest")]
    pub fn nearest(&self, p: P) -> Result<Nearest<P>, Error> {
        check_points("p", &[p])?;
        let normalized = Normalized::new(p, self.max_abs().max(p.max_abs()));
        let about = Self {
            points: normalized.points(&self.points),
            weights: self.scaled_weights(),
        };
        if let Some(t) = about.nearest_to_origin_by_kernel() {
            return Ok(self.nearest_at(t, p));
        }
        let n = self.degree();
        let curve = RationalDistance {
            homogeneous: Derivatives::of(&about.homogeneous(P::ZERO)),
            wronskian: Wronskian::of_degree(n),
            binomials: Binomials::new(n, 2 * n - 2),
        };
        let (t, _) = nearest_to_origin(&curve, about);
        Ok(self.nearest_at(t, p))
    }

    /// The point at t and its distance from p.
    fn nearest_at(&self, t: f64, p: P) -> Nearest<P> {
        let point = self.eval(t);
        let distance = (point - p).norm();
        Nearest { t, point, distance }
    }

    /// The parameter of the point that is nearest to the origin, for degrees 2 and 3 and weights of similar sizes.
    fn nearest_to_origin_by_kernel(&self) -> Option<f64> {
        let size = self.max_abs();
        if P::DIMENSION == 2 && cfg!(feature = "fast") {
            rational_nearest_in_plane(&self.as_cubic(MAX_RATIO, P::to_2d)?, size)
        } else {
            rational_nearest_in_space(&self.as_cubic(MAX_RATIO, P::to_3d)?, size)
        }
    }
}

/// For larger ratios of the weights the coefficients of A·D are not accurate enough in all parts.
const MAX_RATIO: f64 = (1 << 20) as f64;

/// The control points of a homogeneous curve and of its first two derivatives.
pub(super) struct Derivatives<P: Point>([Points<Homogeneous<P>>; 3]);

impl<P: Point> Derivatives<P> {
    pub(super) fn of(points: &[Homogeneous<P>]) -> Self {
        let rate = |points: &[Homogeneous<P>]| -> Points<Homogeneous<P>> {
            let n = as_f64(points.len() - 1);
            let steps = points.windows(2).map(|p| (p[1] - p[0]) * n);
            if points.len() == 1 {
                Points::from([Homogeneous::default()].as_slice())
            } else {
                steps.collect()
            }
        };
        let first = rate(points);
        let second = rate(&first);
        Self([points_of(points), first, second])
    }

    /// The point and the first two derivatives at t. With A = wB: B′ = (A′ − w′B)/w and B″ = (A″ − 2w′B′ − w″B)/w.
    pub(super) fn jet(&self, t: f64) -> [P; 3] {
        let [value, first, second] = [0, 1, 2].map(|k| evaluate(&self.0[k], t));
        let (b, w) = (value.point(), value.weight);
        let b1 = (first.vector - b * first.weight) / w;
        let b2 = (second.vector - b1 * (2.0 * first.weight) - b * second.weight) / w;
        [b, b1, b2]
    }
}

/// A rational curve relative to the query point.
struct RationalDistance<P: Point> {
    homogeneous: Derivatives<P>,
    wronskian: Wronskian,
    binomials: Binomials,
}

impl<P: Point> DistanceToOrigin<P> for RationalDistance<P> {
    type Part = RationalCurve<P>;

    fn hull(part: &RationalCurve<P>) -> &[P] {
        &part.points
    }

    /// A·D.
    fn rate(&self, part: &RationalCurve<P>) -> Scalars {
        let (points, weights) = (&part.points, &part.weights);
        let numerator = derivative_numerator(&self.wronskian, points, weights);
        self.binomials
            .product(|i, j| weights[i] * points[i].dot(numerator[j]))
    }

    /// B·B′ = A·D/w³.
    fn rate_bound(part: &RationalCurve<P>, rate: &[f64]) -> f64 {
        let min = part.weights.iter().copied().fold(f64::INFINITY, f64::min);
        max_of(rate) / (min * min * min)
    }

    fn halve(part: &RationalCurve<P>) -> (RationalCurve<P>, RationalCurve<P>) {
        part.halve()
    }

    fn at(&self, t: f64) -> P {
        evaluate(&self.homogeneous.0[0], t).point()
    }

    fn derivatives(&self, t: f64) -> [P; 2] {
        let [_, first, second] = self.homogeneous.jet(t);
        [first, second]
    }
}
