//! Minimum distance of two curves.
//!
//! The distance of two segments is at least the gap between their control points along any direction. With the
//! direction from one segment to the other, the error of this lower bound is of second order in the length of the
//! segments. Pairs of segments that cannot be nearer than the best distance found are dropped, and the others are
//! halved. Newton's method finds the exact parameters.

use super::nearest_with_steps;
use super::segment_tree::{Bounded, Heap, SegmentTree};
use crate::curve::Curve;
use crate::curve::with_derivatives::CurveWithDerivatives;
use crate::geometry::normalized::Normalized;
use crate::geometry::point::Point;
use crate::numeric::float::{ratio, ulp};
use crate::numeric::list::Points;
use casteljau_kernels::numeric::work_limit::WorkLimit;

/// The minimum distance of two curves and the parameters where it occurs.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(rename_all = "camelCase")
)]
pub struct Distance {
    /// The distance in the unit of the points; 0 if the curves intersect.
    pub distance: f64,
    /// The parameter on the first curve.
    pub t: f64,
    /// The parameter on the second curve.
    pub u: f64,
}

/// Maximum number of pairs of segments. Only curves with a nearly constant distance along a bend need more.
const MAX_PAIRS: usize = 1536;

/// Maximum total of pairs, steps of Newton's method, and segments in searches for nearest points.
const MAX_STEPS: usize = 16_384;

/// Number of parameters that are sampled if the distance of the curves is nearly constant.
const CONSTANT_DISTANCE_SAMPLES: usize = 64;

/// Maximum relative error of a distance that is found.
const ACCURACY: f64 = 1e-12;

/// Maximum number of steps of Newton's method in one descent: where the curves touch, each step gains one of the 53
/// bits, with 7 as a reserve.
const MAX_TOTAL_STEPS: usize = f64::MANTISSA_DIGITS as usize + 7;

impl<P: Point> Curve<P> {
    /// The minimum distance of two curves and its parameters: the minimum of |A(t) − B(u)| for t and u in \[0, 1\], end
    /// points included.
    ///
    /// It is the global minimum, not a local one. The error is at most 10⁻¹² of the distance or 2 (n + m + 2) ulps of
    /// the largest coordinate, whichever is larger; a distance of at most those ulps counts as an intersection and is
    /// 0. If the minimum occurs more than once, the result is any one of them. Points and straight curves are allowed.
    /// For curves with a nearly constant distance, the search ends after 1536 pairs of segments, or after 16384 counted
    /// steps (pairs, steps of Newton's method, segments in searches for nearest points), with the smallest distance
    /// found.
    ///
    /// Source: Johnson and Cohen, "A framework for efficient minimum distance computations", ICRA 1998.
    ///
    /// ```
    /// use casteljau::{Curve, glam::DVec2};
    ///
    /// let arch = Curve::new(&[(0.0, 0.0), (0.0, 2.0), (2.0, 2.0), (2.0, 0.0)].map(DVec2::from))?;
    /// let line = Curve::new(&[(0.0, 2.0), (2.0, 2.0)].map(DVec2::from))?;
    /// let found = arch.distance_to(&line);
    /// assert_eq!((found.distance, found.t, found.u), (0.5, 0.5, 0.5));
    /// # Ok::<(), casteljau::Error>(())
    /// ```
    pub fn distance_to(&self, other: &Self) -> Distance {
        let size = self.max_abs().max(other.max_abs());
        let normalized = Normalized::new(self.start(), size);
        let [a, b]: [Points<P>; 2] = [self, other].map(|curve| normalized.points(&curve.points));
        // The error bound of a difference of two points, in ulps.
        let ulps = 2.0 * (a.len() + b.len()) as f64;
        let mut search = DistanceSearch::new(&a, &b, ulps * ulp(size * normalized.scale));
        search.find_intersection();
        if search.distance > search.rounding {
            search.run();
        }
        let (t, u) = (search.t, search.u);
        let distance = (self.eval(t) - other.eval(u)).norm();
        Distance {
            distance: if distance <= ulps * ulp(size) {
                0.0
            } else {
                distance
            },
            t,
            u,
        }
    }
}

/// The search for the minimum distance of two curves that are scaled to a size of about 1.
struct DistanceSearch<'a, P: Point> {
    a: CurveWithDerivatives<'a, P>,
    b: CurveWithDerivatives<'a, P>,
    rounding: f64,
    distance: f64,
    t: f64,
    u: f64,
    /// Counts pairs, steps of Newton's method, and the segments of searches for nearest points.
    work: WorkLimit,
    /// Whether the work is still within its limit.
    within: bool,
}

impl<'a, P: Point> DistanceSearch<'a, P> {
    fn new(a: &'a [P], b: &'a [P], rounding: f64) -> Self {
        Self {
            a: CurveWithDerivatives::new(a),
            b: CurveWithDerivatives::new(b),
            rounding,
            distance: f64::INFINITY,
            t: 0.0,
            u: 0.0,
            work: WorkLimit::new(MAX_STEPS),
            within: true,
        }
    }

    /// Starts with the intersections of plane curves, which handle close crossings of nearly coincident curves. The two
    /// points of an intersection may be farther apart than rounding, so the search continues unless an intersection is
    /// exact.
    fn find_intersection(&mut self) {
        let flat = |points: &[P]| points.iter().all(|p| p.to_3d().z == 0.0);
        if !(flat(self.a.points) && flat(self.b.points)) {
            return;
        }
        let plane = |points: &[P]| Curve::from_points(points.iter().map(|p| p.to_2d()).collect());
        for location in plane(self.a.points).intersections(&plane(self.b.points)) {
            self.consider(location.t, location.u);
        }
    }

    fn run(&mut self) {
        // End points first: they decide the cases where the minimum is at an end.
        for end in [0.0, 1.0] {
            let u = self.foot(self.b.points, self.a.at(end));
            self.consider(end, u);
            let t = self.foot(self.a.points, self.b.at(end));
            self.consider(t, end);
        }
        let (mut left, mut right) = (
            SegmentTree::new(self.a.points),
            SegmentTree::new(self.b.points),
        );
        let mut pairs = Heap::from([Bounded {
            min: 0.0,
            of: (0, 0),
        }]);
        for _ in 0..MAX_PAIRS {
            self.within &= self.work.spend(1);
            if !self.within {
                return;
            }
            // The pair with the smallest lower bound; if it cannot improve the result, no pair can.
            let Some(Bounded { min, of: (i, j) }) = pairs.pop() else {
                return;
            };
            let (p, q) = (&left.0[i], &right.0[j]);
            let (first, second) = (p.size, q.size);
            if !self.may_improve(min) || first.max(second) <= self.rounding {
                continue;
            }
            // Halve the larger segment of the pair.
            let halves = if first >= second {
                left.halves(i).map(|i| (i, j))
            } else {
                right.halves(j).map(|j| (i, j))
            };
            for (i, j) in halves {
                let (p, q) = (&left.0[i], &right.0[j]);
                if (p.middle - q.middle).norm() + self.rounding < self.distance {
                    self.descend(p.mid(), q.mid());
                }
                let min = p.distance_bound(q);
                if self.may_improve(min) {
                    pairs.push(Bounded { min, of: (i, j) });
                }
            }
        }
        self.sample_and_refine();
    }

    /// The parameter of the nearest point on a curve.
    fn foot(&mut self, points: &[P], p: P) -> f64 {
        let (t, steps) = nearest_with_steps(points, p);
        self.within &= self.work.spend(steps);
        t
    }

    /// Whether a lower bound allows a significant improvement.
    fn may_improve(&self, min: f64) -> bool {
        min < self.distance * (1.0 - ACCURACY) - self.rounding
    }

    /// Fallback for curves with a nearly constant distance: samples the first curve, then refines the best sample by
    /// ternary search.
    fn sample_and_refine(&mut self) {
        for k in 1..CONSTANT_DISTANCE_SAMPLES {
            if !self.within {
                return;
            }
            self.distance_at(ratio(k, CONSTANT_DISTANCE_SAMPLES));
        }
        let (mut lo, mut hi) = (
            self.t - ratio(1, CONSTANT_DISTANCE_SAMPLES),
            self.t + ratio(1, CONSTANT_DISTANCE_SAMPLES),
        );
        for _ in 0..CONSTANT_DISTANCE_SAMPLES {
            if !self.within {
                return;
            }
            let third = (hi - lo) / 3.0;
            if self.distance_at(lo + third) < self.distance_at(hi - third) {
                hi -= third;
            } else {
                lo += third;
            }
        }
    }

    /// The distance of A(t) from the other curve.
    fn distance_at(&mut self, t: f64) -> f64 {
        let t = t.clamp(0.0, 1.0);
        let u = self.foot(self.b.points, self.a.at(t));
        self.consider(t, u);
        (self.a.at(t) - self.b.at(u)).norm()
    }

    fn consider(&mut self, t: f64, u: f64) {
        let distance = (self.a.at(t) - self.b.at(u)).norm();
        if distance < self.distance {
            (self.distance, self.t, self.u) = (distance, t, u);
        }
    }

    /// Newton's method for the minimum of |A(t) − B(u)|², restricted to [0, 1] and to steps that reduce the distance.
    fn descend(&mut self, mut t: f64, mut u: f64) {
        for _ in 0..MAX_TOTAL_STEPS {
            self.consider(t, u);
            self.within &= self.work.spend(1);
            if !self.within {
                return;
            }
            let vector = self.a.at(t) - self.b.at(u);
            let (step_t, step_u) = self.newton(vector, t, u);
            // Shorten the step until it reduces the distance.
            let mut share = 1.0;
            let old = vector.norm();
            loop {
                let (v, w) = (
                    (t + share * step_t).clamp(0.0, 1.0),
                    (u + share * step_u).clamp(0.0, 1.0),
                );
                if (self.a.at(v) - self.b.at(w)).norm() < old {
                    (t, u) = (v, w);
                    break;
                }
                share *= 0.25;
                if share < 1e-3 {
                    return;
                }
            }
        }
        self.consider(t, u);
    }

    /// The step from t and u, where `vector` is A(t) − B(u): a Newton step if the second derivatives make it a descent
    /// step, otherwise a Gauss–Newton step.
    fn newton(&self, vector: P, t: f64, u: f64) -> (f64, f64) {
        let ([a1, a2], [b1, b2]) = (self.a.derivatives(t), self.b.derivatives(u));
        // Half the gradient of |A − B|² is (g, h), half its Hessian (p, ab; ab, q); Gauss–Newton has (aa, ab; ab, bb).
        let (g, h) = (vector.dot(a1), -vector.dot(b1));
        let (aa, bb, ab) = (a1.dot(a1), b1.dot(b1), -a1.dot(b1));
        // If a step would leave the range at an end, only the other parameter moves.
        let fixed = |x: f64, slope: f64| x <= 0.0 && slope >= 0.0 || x >= 1.0 && slope <= 0.0;
        let (p, q) = (aa + vector.dot(a2), bb - vector.dot(b2));
        let root_of_one = |slope: f64, full: f64, half: f64| {
            let bend = if full > 0.0 { full } else { half };
            if bend > 0.0 { -slope / bend } else { 0.0 }
        };
        match (fixed(t, g), fixed(u, h)) {
            (true, true) => (0.0, 0.0),
            (true, false) => (0.0, root_of_one(h, q, bb)),
            (false, true) => (root_of_one(g, p, aa), 0.0),
            (false, false) => {
                // The Hessian is positive definite by more than its rounding.
                let convex = p > 0.0 && q > 0.0 && p * q - ab * ab > 1e-14 * p * q;
                let damped = 1e-12 * (aa + bb) + f64::MIN_POSITIVE;
                let (p, q) = if convex {
                    (p, q)
                } else {
                    (aa + damped, bb + damped)
                };
                let determinant = p * q - ab * ab;
                (
                    (ab * h - q * g) / determinant,
                    (ab * g - p * h) / determinant,
                )
            }
        }
    }
}
