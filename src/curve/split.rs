//! Splitting a curve by de Casteljau's algorithm.

use super::Curve;
use crate::geometry::check::clamp_to_limit;
use crate::geometry::point::Point;
use crate::numeric::list::points_of_cubic;
use crate::numeric::sort::sort_by;
use casteljau_kernels::bernstein::de_casteljau::{keep_between, split, split_cubic_with};
use std::ops::{Bound, RangeBounds};

impl<P: Point> Curve<P> {
    /// All levels of de Casteljau's triangle at t: the control points first, the point of the curve last.
    ///
    /// Level k has n + 1 − k points; each lies on the segment between two neighbours of the level before.
    pub fn de_casteljau(&self, t: f64) -> Vec<Vec<P>> {
        let mut levels = vec![self.points.to_vec()];
        for level in 0..self.degree() {
            let next = levels[level]
                .windows(2)
                .map(|pair| pair[0].lerp(pair[1], t))
                .collect();
            levels.push(next);
        }
        levels
    }

    /// Splits the curve at t into two curves of the same degree.
    ///
    /// Both share the point B(t), and the outer ends are exact. For t outside [0, 1], one result extends beyond the
    /// curve and the other runs backwards.
    #[inline]
    pub fn split(&self, t: f64) -> (Self, Self) {
        if !(0.0..=1.0).contains(&t) {
            let (before, after) = *self.split_any(t);
            return (before.clamped(), after.clamped());
        }
        match *self.points {
            [p0, p1, p2, p3] => {
                let (left, right) = split_cubic_with([p0, p1, p2, p3], |a, b| a.lerp(b, t));
                let curve = |points| Self::from_points(points_of_cubic(points));
                (curve(left), curve(right))
            }
            [p0, p1, p2] => {
                let (p01, p12) = (p0.lerp(p1, t), p1.lerp(p2, t));
                let p = p01.lerp(p12, t);
                (
                    Self::from_slice(&[p0, p01, p]),
                    Self::from_slice(&[p, p12, p2]),
                )
            }
            _ => *self.split_any(t),
        }
    }

    /// The curve with coordinates beyond the limit set to it: an extrapolation may exceed it.
    pub(crate) fn clamped(mut self) -> Self {
        self.points.iter_mut().for_each(|p| *p = clamp_to_limit(*p));
        self
    }

    /// In a box, since a result that is passed by reference would have to be copied for cubics as well: 15 instead of 5
    /// ns.
    #[inline(never)]
    fn split_any(&self, t: f64) -> Box<(Self, Self)> {
        let (mut left, mut right) = (self.points.clone(), self.points.clone());
        split(&mut left, &mut right, t);
        Box::new((Self::from_points(left), Self::from_points(right)))
    }

    /// Splits the curve at any number of parameters, in any order: the parts from 0 to the smallest, between neighbours,
    /// and from the largest to 1.
    ///
    /// Each part ends at the point where the next one starts, up to the last bit. There is one part more than
    /// parameters: equal ones, 0 and 1 give parts that are points. A part to or from a t outside [0, 1] is that of
    /// [`subsegment`](Self::subsegment).
    ///
    /// ```
    /// use casteljau::{Curve, glam::DVec2};
    ///
    /// let line = Curve::line(DVec2::ZERO, DVec2::new(4.0, 0.0));
    /// let ends: Vec<f64> = line.split_at(&[0.75, 0.25]).iter().map(|part| part.end().x).collect();
    /// assert_eq!(ends, [1.0, 3.0, 4.0]);
    /// ```
    pub fn split_at(&self, ts: &[f64]) -> Vec<Self> {
        parts_at(ts, 1.0, |t0, t1| self.part(t0, t1))
    }

    /// The two halves at t = ½.
    ///
    /// For a cubic these are (P₀+P₁)/2, (P₀+2P₁+P₂)/4, (P₀+3P₁+3P₂+P₃)/8 and their mirror images: only sums and
    /// divisions by powers of two, which do not round.
    #[inline]
    #[doc(alias = "subdivide")]
    pub fn halve(&self) -> (Self, Self) {
        self.split(0.5)
    }

    /// The segment in a range of parameters from t₀ to t₁, as a curve of the same degree; t₀ > t₁ gives the reversed
    /// segment.
    ///
    /// Its end points are B(t₀) and B(t₁). For t₀ = t₁ it is a point. A range without a start begins at 0, one without
    /// an end ends at 1.
    ///
    /// ```
    /// use casteljau::{Curve, glam::DVec2};
    ///
    /// let line = Curve::line(DVec2::ZERO, DVec2::new(4.0, 0.0));
    /// assert_eq!(line.subsegment(0.25..0.5).end(), DVec2::new(2.0, 0.0));
    /// assert_eq!(line.subsegment(0.25..).start(), DVec2::new(1.0, 0.0));
    /// assert_eq!(line.subsegment(1.0..0.0), line.reverse());
    /// # Ok::<(), casteljau::Error>(())
    /// ```
    pub fn subsegment(&self, range: impl RangeBounds<f64>) -> Self {
        let [t0, t1] = ends_of(&range, 1.0);
        self.part(t0, t1)
    }

    /// [`subsegment`](Self::subsegment) from t₀ to t₁.
    pub(crate) fn part(&self, t0: f64, t1: f64) -> Self {
        if t0 > t1 {
            return self.part(t1, t0).reverse();
        }
        let mut piece = self.points.clone();
        keep_between(&mut piece, t0, t1);
        // The same bits as `eval` gives, so that separately computed segments join without a gap.
        let last = piece.len() - 1;
        piece[0] = self.eval(t0);
        piece[last] = self.eval(t1);
        let piece = Self::from_points(piece);
        if t0 >= 0.0 && t1 <= 1.0 {
            piece
        } else {
            piece.clamped()
        }
    }
}

/// The parts from 0 to `end` between the given parameters in ascending order.
pub(crate) fn parts_at<T>(ts: &[f64], end: f64, part: impl Fn(f64, f64) -> T) -> Vec<T> {
    let mut ends = ts.to_vec();
    sort_by(&mut ends, f64::total_cmp);
    let starts = [0.0].into_iter().chain(ends.iter().copied());
    starts
        .zip(ends.iter().copied().chain([end]))
        .map(|(from, to)| part(from, to))
        .collect()
}

/// The ends of a range of parameters, by default 0 and `end`.
pub(crate) fn ends_of(range: &impl RangeBounds<f64>, end: f64) -> [f64; 2] {
    let given = |bound: Bound<&f64>, default: f64| match bound {
        Bound::Included(&t) | Bound::Excluded(&t) => t,
        Bound::Unbounded => default,
    };
    [
        given(range.start_bound(), 0.0),
        given(range.end_bound(), end),
    ]
}
