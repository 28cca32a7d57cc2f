//! Nearest point of a curve.
//!
//! At the nearest point the vector to the query is perpendicular to the curve, or the curve ends. The candidates are
//! therefore all roots of (B(t) − q)·B′(t) = 0, found by root isolation and not by sampling, and both end points. Plane
//! and space share the algorithm; degrees up to 3 have their own kernel, which considers only minima.

pub(crate) mod distance;
mod hausdorff;
mod segment_tree;

use super::Curve;
use super::with_derivatives::CurveWithDerivatives;
use crate::bernstein::evaluate::evaluate;
use crate::bernstein::product::Binomials;
use crate::bernstein::roots::{max_of, roots_inside, sign_changes};
use crate::geometry::bounds::Bounds;
use crate::geometry::check::{check_points, max_abs};
use crate::geometry::error::Error;
use crate::geometry::normalized::Normalized;
use crate::geometry::point::Point;
use crate::numeric::list::{Points, Scalars};
use casteljau_kernels::curve::nearest::search::{nearest_in_plane, nearest_in_space};
use casteljau_kernels::numeric::work_limit::WorkLimit;

/// The point of a curve or of a spline that is nearest to another point.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(rename_all = "camelCase")
)]
pub struct Nearest<P> {
    /// The parameter; on a spline from 0 to the number of segments.
    pub t: f64,
    /// The point at t.
    pub point: P,
    /// The distance from the query point.
    pub distance: f64,
}

/// Halvings after which several roots count as one: their squared distances then differ by the square of the width, which
/// needs half of the bits.
const ROOT_HALVINGS: usize = f64::MANTISSA_DIGITS as usize / 2;

/// Maximum number of segments: a fixed number, and an additional one for each degree. More than ten times what curves
/// with moderate numbers need.
const MAX_PIECES: usize = 64;
const MAX_PIECES_PER_DEGREE: usize = 16;

/// The work of a search on a quadratic or a cubic, in segments.
const STEPS_OF_CUBIC: usize = 8;

/// Maximum number of steps of Newton's method after a root is found; usually one or two are needed.
const MAX_STEPS: usize = 12;

impl<P: Point> Curve<P> {
    /// The point of the curve that is nearest to p: the minimum of |B(t) − p| for t in \[0, 1\], end points included.
    ///
    /// It is the global minimum, not a local one: every root of the polynomial (B(t) − p)·B′(t), of degree 2n − 1, is
    /// isolated by its Bernstein coefficients. Distances that differ by less than a few ulps of the largest coordinate
    /// of B − p count as equal; of equally near points the result is the one with the smallest t. For a curve that is a
    /// point, t = 0. The distance is in the unit of the points.
    ///
    /// The search processes at most 256 segments of the polynomial up to degree 3, and 64 + 16 n above; segments that
    /// are farther away than a point already found are skipped. Only distances that are constant up to rounding need
    /// more segments; after the limit, the remaining ones are not halved any more.
    ///
    /// # Errors
    /// [`Error::NotFinite`] for a NaN or an infinity.
    ///
    /// Source: Schneider, "Solving the nearest-point-on-curve problem", *Graphics Gems* (1990), for the polynomial;
    /// Lane and Riesenfeld, BIT 21 (1981), for the isolation.
    ///
    /// ```
    /// use casteljau::{Curve, glam::DVec2};
    ///
    /// let parabola = Curve::new(&[(0.0, 0.0), (100.0, 0.0), (100.0, 100.0)].map(DVec2::from))?;
    /// let nearest = parabola.nearest(DVec2::new(80.0, 20.0))?;
    /// assert_eq!((nearest.t, nearest.point), (0.5, DVec2::new(75.0, 25.0)));
    /// # Ok::<(), casteljau::Error>(())
    /// ```
    #[doc(alias = "closest")]
    pub fn nearest(&self, p: P) -> Result<Nearest<P>, Error> {
        check_points("p", &[p])?;
        Ok(nearest_on(&self.points, p))
    }
}

/// The nearest point of the curve with the given control points; all numbers are finite.
pub(crate) fn nearest_on<P: Point>(points: &[P], p: P) -> Nearest<P> {
    let t = nearest_parameter(points, p);
    let point = evaluate(points, t);
    let distance = (point - p).norm();
    Nearest { t, point, distance }
}

/// Squared distances are compared after two roundings each; a box may therefore seem this much too far away.
pub(crate) const BOX_ROUNDING: f64 = 1.0 - 8.0 * f64::EPSILON;

/// The nearest point of several curves, the first of equally near ones, and the index of its curve; `None` for no curves.
///
/// The nearest end point gives an upper bound of the distance; curves whose control-point box is farther away than that or
/// than the best point so far are skipped. Source: Roussopoulos, Kelley and Vincent, "Nearest neighbor queries", SIGMOD
/// 1995, for the bounds.
pub(crate) fn nearest_of_curves<P: Point, C: AsRef<[P]>>(
    curves: impl Iterator<Item = C> + Clone,
    p: P,
    nearest_on: impl Fn(&[P], P) -> Nearest<P>,
) -> Option<(usize, Nearest<P>)> {
    let square = |v: P| v.dot(v);
    let ends = curves.clone().map(|curve| {
        let points = curve.as_ref();
        square(points[0] - p).min(square(points[points.len() - 1] - p))
    });
    let mut max = ends.fold(f64::INFINITY, f64::min);
    let mut best: Option<(usize, Nearest<P>)> = None;
    for (k, curve) in curves.enumerate() {
        let points = curve.as_ref();
        if square(Bounds::from_points(points).outside(p)) * BOX_ROUNDING > max {
            continue;
        }
        let found = nearest_on(points, p);
        if best.is_none_or(|(_, best)| found.distance < best.distance) {
            max = max.min(found.distance * found.distance);
            best = Some((k, found));
        }
    }
    best
}

/// The parameter of the nearest point of the curve with the given control points.
pub(crate) fn nearest_parameter<P: Point>(points: &[P], p: P) -> f64 {
    nearest_with_steps(points, p).0
}

/// The parameter of the nearest point and the number of processed segments; up to degree 3 an equivalent number.
pub(crate) fn nearest_with_steps<P: Point>(points: &[P], p: P) -> (f64, usize) {
    if let Some(t) = as_cubic(points).and_then(|cubic| on_cubic(cubic, p)) {
        return (t, STEPS_OF_CUBIC);
    }
    // The kernel does not take lines, degrees above 3, and numbers whose powers leave the range of f64.
    let size = max_abs(points).max(p.max_abs());
    let about: Points<P> = Normalized::new(p, size).points(points);
    if let [a, b] = *about {
        return (on_segment(a, b), 1);
    }
    as_cubic(&about)
        .and_then(|cubic| on_cubic(cubic, P::default()))
        .map_or_else(|| of_any_degree(&about), |t| (t, STEPS_OF_CUBIC))
}

/// The parameter of the point from a to b that is nearest to the origin.
fn on_segment<P: Point>(a: P, b: P) -> f64 {
    let chord = b - a;
    let t = -a.dot(chord) / chord.dot(chord);
    // The quotient is 0/0 if both points coincide.
    if t > 0.0 { t.min(1.0) } else { 0.0 }
}

/// A curve of degree 2 or 3 as a cubic.
#[inline]
pub(crate) fn as_cubic<P: Point>(points: &[P]) -> Option<[P; 4]> {
    match *points {
        [a, b, c] => Some([a, b.lerp(a, 1.0 / 3.0), b.lerp(c, 1.0 / 3.0), c]),
        [a, b, c, d] => Some([a, b, c, d]),
        _ => None,
    }
}

#[inline]
fn on_cubic<P: Point>(points: [P; 4], p: P) -> Option<f64> {
    // Without the feature one kernel serves both dimensions; in the plane it takes 14 to 40 % longer.
    if P::DIMENSION == 2 && cfg!(feature = "fast") {
        nearest_in_plane(&points.map(P::to_2d), p.to_2d())
    } else {
        nearest_in_space(&points.map(P::to_3d), p.to_3d())
    }
}

/// The parameter for points relative to the query, by the roots of B·B′, and the number of processed segments.
fn of_any_degree<P: Point>(points: &[P]) -> (f64, usize) {
    let n = points.len() - 1;
    let curve = PolynomialDistance {
        curve: CurveWithDerivatives::new(points),
        binomials: Binomials::new(n, n - 1),
    };
    nearest_to_origin(&curve, Curve::from_slice(points))
}

/// A curve relative to the query point: what the search for the nearest point needs.
pub(crate) trait DistanceToOrigin<P: Point> {
    /// The curve, or a part of it.
    type Part;
    /// Points whose hull contains a part; the first and the last are its ends.
    fn hull(part: &Self::Part) -> &[P];
    /// The Bernstein coefficients of a polynomial with the sign of the derivative of the distance.
    fn rate(&self, part: &Self::Part) -> Scalars;
    /// A bound of |B·B′| on a part, by the coefficients of the rate.
    fn rate_bound(part: &Self::Part, rate: &[f64]) -> f64;
    /// Both halves of a part.
    fn halve(part: &Self::Part) -> (Self::Part, Self::Part);
    /// The point at t of the whole curve.
    fn at(&self, t: f64) -> P;
    /// The first two derivatives there.
    fn derivatives(&self, t: f64) -> [P; 2];
}

/// A polynomial curve relative to the query point.
struct PolynomialDistance<'a, P: Point> {
    curve: CurveWithDerivatives<'a, P>,
    binomials: Binomials,
}

impl<P: Point> DistanceToOrigin<P> for PolynomialDistance<'_, P> {
    type Part = Curve<P>;

    fn hull(part: &Curve<P>) -> &[P] {
        &part.points
    }

    /// B·B′/n.
    fn rate(&self, part: &Curve<P>) -> Scalars {
        let points = &part.points;
        self.binomials
            .product(|i, j| points[i].dot(points[j + 1] - points[j]))
    }

    fn rate_bound(part: &Curve<P>, rate: &[f64]) -> f64 {
        part.degree() as f64 * max_of(rate)
    }

    fn halve(part: &Curve<P>) -> (Curve<P>, Curve<P>) {
        part.halve()
    }

    fn at(&self, t: f64) -> P {
        self.curve.at(t)
    }

    fn derivatives(&self, t: f64) -> [P; 2] {
        self.curve.derivatives(t)
    }
}

/// The parameter of the point that is nearest to the origin, and the number of processed parts.
pub(crate) fn nearest_to_origin<P: Point, C: DistanceToOrigin<P>>(
    curve: &C,
    whole: C::Part,
) -> (f64, usize) {
    let points = C::hull(&whole);
    let n = points.len() - 1;
    let mut search = Search {
        curve,
        slack: 4.0 * f64::EPSILON * max_abs(points),
        t: 0.0,
        min: points[0].norm(),
        end: points[n].norm(),
        work: WorkLimit::new(MAX_PIECES + MAX_PIECES_PER_DEGREE * n),
    };
    search.run(&whole, [0.0, 1.0], ROOT_HALVINGS);
    search.consider(1.0);
    (search.t, search.work.used())
}

/// The search for the point of a curve that is nearest to the origin.
struct Search<'a, C> {
    curve: &'a C,
    /// Distances that differ by less than this are equal.
    slack: f64,
    t: f64,
    /// The distance at t.
    min: f64,
    /// The distance of the end point.
    end: f64,
    work: WorkLimit,
}

impl<C> Search<'_, C> {
    fn consider<P: Point>(&mut self, t: f64)
    where
        C: DistanceToOrigin<P>,
    {
        let (t, distance) = polish(self.curve, t);
        if distance < self.min - self.slack {
            (self.t, self.min) = (t, distance);
        }
    }

    /// Considers the parameters where B·B′ changes sign from − to +, from left to right. The control points of B are
    /// subdivided, not the coefficients of B·B′: near multiple roots the coefficients of the parts are small, and so is
    /// their rounding.
    fn run<P: Point>(&mut self, part: &C::Part, [lo, hi]: [f64; 2], halvings: usize)
    where
        C: DistanceToOrigin<P>,
    {
        let within = self.work.spend(1);
        let bound = Bounds::from_points(C::hull(part)).distance(P::default());
        if bound > self.min.min(self.end) + self.slack {
            return;
        }
        let rate = self.curve.rate(part);
        let (changes, sign) = sign_changes(&rate);
        // Without a sign change the distance is monotone; a change from + to − is a maximum.
        if changes == 0 || changes == 1 && sign > 0.0 {
            return;
        }
        let mid = 0.5 * (lo + hi);
        if C::rate_bound(part, &rate) <= self.slack * bound {
            // B·B′ / |B| is the derivative of the distance, which is constant here up to rounding.
            return self.consider(mid);
        }
        if changes == 1 || halvings == 0 || !within {
            roots_inside(&rate)
                .iter()
                .for_each(|s| self.consider(lo + (hi - lo) * s));
            return;
        }
        let (left, right) = C::halve(part);
        self.run(&left, [lo, mid], halvings - 1);
        // Because of rounding, a root in the middle may lie in neither half.
        self.consider(mid);
        self.run(&right, [mid, hi], halvings - 1);
    }
}

/// The parameter and the distance after Newton's method, which is continued as long as it reduces the distance from the
/// origin, or leaves it equal up to rounding with ever shorter steps. It uses the control points themselves, because the roots of B·B′ are inaccurate where the curve hardly
/// moves.
fn polish<P: Point>(curve: &impl DistanceToOrigin<P>, mut t: f64) -> (f64, f64) {
    let mut p = curve.at(t);
    let mut last_step = f64::INFINITY;
    for _ in 0..MAX_STEPS {
        let [first, second] = curve.derivatives(t);
        let next = t - p.dot(first) / (first.dot(first) + p.dot(second));
        if !(next > 0.0 && next < 1.0) {
            break;
        }
        let (q, step) = (curve.at(next), (next - t).abs());
        let is_equal = q.dot(q) <= p.dot(p) * (1.0 + 4.0 * f64::EPSILON);
        if q.dot(q) >= p.dot(p) && !(is_equal && step < 0.5 * last_step) {
            break;
        }
        (t, p, last_step) = (next, q, step);
    }
    (t, p.norm())
}
