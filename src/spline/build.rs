//! Building splines from curves; adding, inserting and removing segments and joints.

use super::Spline;
use crate::curve::Curve;
use crate::geometry::check::{check_points, clamp_to_limit, is_within_limit};
use crate::geometry::error::Error;
use crate::geometry::point::Point;
use crate::numeric::float::as_f64;

/// End points within this ratio of the largest coordinate count as equal; parsing and printing lose that much.
const JOINT_GAP_RATIO: f64 = 1e-9;

impl<P: Point> Spline<P> {
    /// A spline from consecutive curves.
    ///
    /// The end of a curve and the start of the next one may differ by 10⁻⁹ of the largest coordinate; the end of the
    /// earlier curve is kept.
    ///
    /// # Errors
    /// [`Error::Count`] for an empty list, [`Error::Gap`] if a curve does not start at the end of the previous one (for
    /// a closed spline, also if the first does not start at the end of the last).
    pub fn from_curves(curves: &[Curve<P>], closed: bool) -> Result<Self, Error> {
        let Some((first, last)) = curves.first().zip(curves.last()) else {
            return Err(Error::Count {
                what: "curves",
                expected: "at least 1 curve",
                got: 0,
            });
        };
        let size = curves.iter().map(Curve::max_abs).fold(0.0, f64::max);
        let check = |index: usize, end: P, start: P| {
            let got = (start - end).norm();
            if got > JOINT_GAP_RATIO * size {
                Err(Error::Gap { index, got })
            } else {
                Ok(())
            }
        };
        for (k, pair) in curves.windows(2).enumerate() {
            check(k + 1, pair[0].end(), pair[1].start())?;
        }
        let mut points = vec![first.start()];
        points.extend(curves.iter().flat_map(|curve| &curve.control_points()[1..]));
        if closed {
            check(0, last.end(), first.start())?;
            points.pop();
        }
        let degrees: Vec<usize> = curves.iter().map(Curve::degree).collect();
        Ok(Self::from_parts(points, &degrees, closed))
    }

    /// The spline extended by a segment that ends at `point`.
    ///
    /// The new segment has the degree of the last one, at most 3. It starts in the direction in which the last one ends
    /// (G1) and has the shape of a quadratic curve; a line is followed by a line.
    ///
    /// # Errors
    /// [`Error::ClosedSpline`], [`Error::NotFinite`] for a NaN or an infinity.
    pub fn append(&self, point: P) -> Result<Self, Error> {
        if self.closed {
            return Err(Error::ClosedSpline { what: "append" });
        }
        check_points("point", &[point])?;
        let last = self.curve(self.segment_count() - 1);
        let from = last.end();
        // The middle control point of a quadratic that starts in the direction of the last tangent.
        let corner = from + last.tangent(1.0) * (0.5 * (point - from).norm());
        let corner = clamp_to_limit(corner);
        let mut points = self.points.clone();
        match last.degree() {
            1 => points.push(point),
            2 => points.extend([corner, point]),
            // The same quadratic, elevated to degree 3.
            _ => points.extend([
                from.lerp(corner, 2.0 / 3.0),
                point.lerp(corner, 2.0 / 3.0),
                point,
            ]),
        }
        let mut degrees = self.degrees();
        degrees.push(last.degree().min(3));
        Ok(Self::from_parts(points, &degrees, false))
    }

    /// The same curve with an additional joint at t: the segment that contains t is split exactly.
    ///
    /// Returns the spline unchanged if t is already a joint or an end.
    ///
    /// # Errors
    /// [`Error::Range`] for t outside 0 to the number of segments.
    pub fn insert(&self, t: f64) -> Result<Self, Error> {
        if !(0.0..=as_f64(self.segment_count())).contains(&t) {
            return Err(Error::Range {
                what: "t",
                expected: "0 to the number of segments",
                got: t,
            });
        }
        let (k, rest) = self.locate(t);
        if rest == 0.0 || rest == 1.0 {
            return Ok(self.clone());
        }
        let (left, right) = self.curve(k).split(rest);
        Ok(self.replace(k, 1, &[left, right]))
    }

    /// The spline without a joint: one segment replaces the two segments at the joint. In general the result does not
    /// keep the shape, but it undoes an [`insert`](Self::insert) exactly.
    ///
    /// With a and b the lengths of the derivatives before and after the joint and t₀ = a/(a + b), the first half of the
    /// new control points extrapolates the left segment to the parameter 1/t₀, and the second half extrapolates the
    /// reversed right segment; for an even degree the middle point is the mean of both. If a or b vanishes, t₀ =
    /// √|P₁P₃| / (√|P₁P₃| + √|P₅P₃|); if that is undefined too, or if the points overflow, t₀ = ½; if the points still
    /// overflow, a line joins the two ends. The lower degree is elevated first. Joint 0 of a closed spline can be
    /// removed too; the control points then start at the next joint.
    ///
    /// # Errors
    /// [`Error::Index`] unless `joint` lies between two segments, [`Error::NoJoint`] for a single open segment.
    pub fn remove(&self, joint: usize) -> Result<Self, Error> {
        self.check_joint(joint)?;
        if self.segment_count() < 2 {
            return Err(Error::Count {
                what: "segments",
                expected: "at least 2 to remove a joint",
                got: 1,
            });
        }
        // After a rotation by one segment, joint 0 is the last joint.
        if joint == 0 {
            return self.rotate().remove(self.segment_count() - 1);
        }
        let merged = merged_curve(self.curve(joint - 1), self.curve(joint));
        Ok(self.replace(joint - 1, 2, &[merged]))
    }

    /// Replaces `count` segments from k on by curves; the outer end points are kept.
    fn replace(&self, k: usize, count: usize, curves: &[Curve<P>]) -> Self {
        let mut inner = Vec::new();
        for curve in curves {
            inner.extend_from_slice(&curve.control_points()[1..]);
        }
        // The last end point is already in the list (or is the first point of a closed spline).
        inner.pop();
        let (before, after) = (self.starts[k] + 1, self.starts[k + count]);
        let points = [&self.points[..before], &inner, &self.points[after..]].concat();
        let (degrees, new) = (
            self.degrees(),
            Vec::from_iter(curves.iter().map(Curve::degree)),
        );
        let degrees = [&degrees[..k], &new, &degrees[k + count..]].concat();
        Self::from_parts(points, &degrees, self.closed)
    }

    /// The same closed spline with its start moved to the next joint.
    fn rotate(&self) -> Self {
        let mut points = self.points.clone();
        points.rotate_left(self.starts[1]);
        let mut degrees = self.degrees();
        degrees.rotate_left(1);
        Self::from_parts(points, &degrees, self.closed)
    }
}

/// One curve that replaces two consecutive curves.
fn merged_curve<P: Point>(mut left: Curve<P>, mut right: Curve<P>) -> Curve<P> {
    while left.degree() < right.degree() {
        left = left.elevated();
    }
    while right.degree() < left.degree() {
        right = right.elevated();
    }
    let merged = merged_at(&left, &right, split_parameter(&left, &right));
    if merged.control_points().iter().all(|&p| is_within_limit(p)) {
        return merged;
    }
    // At ½ the larger of the extrapolation factors 1/t and 1/(1 − t) is smallest.
    let merged = merged_at(&left, &right, 0.5);
    if merged.control_points().iter().all(|&p| is_within_limit(p)) {
        return merged;
    }
    Curve::from_points([left.start(), right.end()].into_iter().collect())
}

/// One curve that replaces two curves of the same degree, with the former joint at t.
fn merged_at<P: Point>(left: &Curve<P>, right: &Curve<P>, t: f64) -> Curve<P> {
    let n = left.degree();
    let (whole, halves) = extrapolate(left, right, t);
    let point = |i: usize| match i {
        0 => left.start(),
        _ if i == n => right.end(),
        _ if 2 * i < n => whole[i],
        _ if 2 * i > n => halves[i],
        _ => whole[i].lerp(halves[i], 0.5),
    };
    Curve::from_points((0..=n).map(point).collect())
}

/// The control points of the curve whose part up to t is `left`, and of the curve whose part from t on is `right`.
fn extrapolate<P: Point>(left: &Curve<P>, right: &Curve<P>, t: f64) -> (Vec<P>, Vec<P>) {
    // The parameters 0 and 1 of the whole curve are 0 and 1/t on `left`, and −t/(1 − t) and 1 on `right`.
    let whole = left.split(1.0 / t).0;
    let back = right.split(-t / (1.0 - t)).1;
    (
        whole.control_points().to_vec(),
        back.control_points().to_vec(),
    )
}

/// The parameter of the joint of two curves of the same degree on the single curve that replaces them.
fn split_parameter<P: Point>(left: &Curve<P>, right: &Curve<P>) -> f64 {
    let n = left.degree();
    let (l, r) = (left.control_points(), right.control_points());
    let joint = left.end();
    let share = |a: f64, b: f64| {
        if a > 0.0 && b > 0.0 {
            a / (a + b)
        } else {
            f64::NAN
        }
    };
    // If both curves are parts of one curve, the handles at its parameter t have the ratio t to 1 − t.
    let by_handles = share((joint - l[n - 1]).norm(), (r[1] - joint).norm());
    if by_handles > 0.0 && by_handles < 1.0 {
        return by_handles;
    }
    // Where B′ is zero, the second control points have distances in the ratio t² to (1 − t)².
    let second = |p: P| (p - joint).norm().sqrt();
    let by_next = share(second(l[n.saturating_sub(2)]), second(r[2.min(n)]));
    if by_next > 0.0 && by_next < 1.0 {
        by_next
    } else {
        0.5
    }
}
