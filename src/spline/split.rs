//! Splitting splines, and subsegments.

use super::Spline;
use crate::curve::Curve;
use crate::curve::split::{ends_of, parts_at};
use crate::geometry::point::Point;
use crate::numeric::float::as_f64;
use std::ops::RangeBounds;

impl<P: Point> Spline<P> {
    /// The two parts before and after t, as open splines.
    ///
    /// The segment that contains t is split by [`Curve::split`]; all other control points are unchanged. At a joint no
    /// segment is split. At the start and at the end one part is a single segment that is a point. A closed spline is
    /// also divided at its start: the first part begins there, the second part ends there. t outside 0 to the number of
    /// segments extrapolates the first or the last segment, as [`eval`](Self::eval) does.
    ///
    /// ```
    /// use casteljau::{Spline, glam::DVec2};
    ///
    /// let points = [(0.0, 0.0), (2.0, 0.0), (2.0, 2.0)].map(DVec2::from);
    /// let (left, right) = Spline::new(&points, 1, false)?.split(1.5);
    /// assert_eq!(left.segment_count(), 2);
    /// assert_eq!(right.control_points(), [DVec2::new(2.0, 1.0), DVec2::new(2.0, 2.0)]);
    /// # Ok::<(), casteljau::Error>(())
    /// ```
    pub fn split(&self, t: f64) -> (Self, Self) {
        let (segment, rest) = self.locate(t);
        let curves = |from: usize, to: usize| (from..to).map(|k| self.curve(k));
        let count = self.segment_count();
        if rest == 0.0 && segment > 0 {
            return (
                Self::from_joined(curves(0, segment)),
                Self::from_joined(curves(segment, count)),
            );
        }
        let (left, right) = self.curve(segment).split(rest);
        (
            Self::from_joined(curves(0, segment).chain([left])),
            Self::from_joined([right].into_iter().chain(curves(segment + 1, count))),
        )
    }

    /// Splits the spline at any number of parameters, in any order: the parts from 0 to the smallest, between neighbours,
    /// and from the largest to the number of segments, as [`subsegment`](Self::subsegment) gives them.
    ///
    /// Each part ends at the point where the next one starts, up to the last bit. There is one part more than
    /// parameters: equal ones, and those at the ends, give parts that are points. The parts of a closed spline are open,
    /// too, and the first one begins at its start.
    pub fn split_at(&self, ts: &[f64]) -> Vec<Self> {
        parts_at(ts, as_f64(self.segment_count()), |t0, t1| self.part(t0, t1))
    }

    /// The part in a range of parameters from t₀ to t₁, as an open spline; t₀ > t₁ reverses it.
    ///
    /// Its ends are the points of [`eval`](Self::eval) at t₀ and t₁; whole segments between them keep their control
    /// points. With t₀ = t₁ the part is a point. Values outside 0 to the number of segments extrapolate the first and
    /// the last segment; a part does not cross the start of a closed spline. A range without a start begins at 0, one
    /// without an end ends at the number of segments.
    pub fn subsegment(&self, range: impl RangeBounds<f64>) -> Self {
        let [t0, t1] = ends_of(&range, as_f64(self.segment_count()));
        self.part(t0, t1)
    }

    /// [`subsegment`](Self::subsegment) from t₀ to t₁.
    pub(crate) fn part(&self, t0: f64, t1: f64) -> Self {
        if t0 > t1 {
            return self.part(t1, t0).reverse();
        }
        let (first, from) = self.locate(t0);
        let (mut last, mut to) = self.locate(t1);
        // A part that ends at a joint ends with the segment before the joint.
        if to == 0.0 && last > first {
            (last, to) = (last - 1, 1.0);
        }
        if first == last {
            return Self::from(self.curve(first).part(from, to));
        }
        let start = match from {
            0.0 => self.curve(first),
            _ => self.curve(first).part(from, 1.0),
        };
        let end = match to {
            1.0 => self.curve(last),
            _ => self.curve(last).part(0.0, to),
        };
        let between = (first + 1..last).map(|k| self.curve(k));
        Self::from_joined([start].into_iter().chain(between).chain([end]))
    }

    /// An open spline of curves, each of which starts at the end of the previous one.
    fn from_joined(curves: impl Iterator<Item = Curve<P>>) -> Self {
        let (mut points, mut degrees) = (Vec::new(), Vec::new());
        for curve in curves {
            points.pop(); // the next curve contains the joint
            points.extend_from_slice(curve.control_points());
            degrees.push(curve.degree());
        }
        Self::from_parts(points, &degrees, false)
    }
}
