//! Extrema of a coordinate of a spline, and parameters at which a coordinate has a given value.

use super::Spline;
use crate::curve::Curve;
use crate::geometry::error::Error;
use crate::geometry::point::Point;
use crate::numeric::float::{as_f64, ulp};

impl<P: Point> Spline<P> {
    /// The parameters where a coordinate (0 is x, 1 is y, 2 is z) has a local extremum, in ascending order.
    ///
    /// They lie inside segments, see [`Curve::extrema`], or at joints where the coordinate changes between rising and
    /// falling; for a closed spline also at its start, as t = 0. The ends of an open spline do not count. Where the
    /// coordinate is constant between a rise and a fall, the joints of that part are extrema.
    ///
    /// ```
    /// use casteljau::{Spline, glam::DVec2};
    ///
    /// let roof = Spline::new(&[(0.0, 0.0), (1.0, 2.0), (2.0, 0.0)].map(DVec2::from), 1, false)?;
    /// assert_eq!(roof.extrema(1)?, [1.0]);
    /// # Ok::<(), casteljau::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::Index`] for an axis that the points do not have.
    pub fn extrema(&self, axis: usize) -> Result<Vec<f64>, Error> {
        let mut inside = Vec::with_capacity(self.segment_count());
        for curve in self.segments() {
            inside.push(curve.extrema(axis)?);
        }
        let directions: Vec<[f64; 2]> = self.segments().map(|c| directions(&c, axis)).collect();
        // The direction before each joint, and the direction after it, where a segment is not constant.
        let wrapped = |whole: f64| if self.closed { whole } else { 0.0 };
        let mut before = wrapped(first_nonzero(directions.iter().rev().map(|pair| pair[1])));
        let mut after = vec![0.0; directions.len()];
        let mut next = wrapped(first_nonzero(directions.iter().map(|pair| pair[0])));
        for (k, pair) in directions.iter().enumerate().rev() {
            if pair[0] != 0.0 {
                next = pair[0];
            }
            after[k] = next;
        }
        let mut ts: Vec<f64> = Vec::new();
        for (k, times) in inside.into_iter().enumerate() {
            if before * after[k] < 0.0 {
                ts.push(as_f64(k));
            }
            ts.extend(times.into_iter().map(|t| as_f64(k) + t));
            if directions[k][1] != 0.0 {
                before = directions[k][1];
            }
        }
        ts.dedup(); // k + t may be rounded to a joint
        Ok(ts)
    }

    /// All parameters at which a coordinate (0 is x, 1 is y, 2 is z) has a given value, in ascending order.
    ///
    /// As [`Curve::times_at_coordinate`]: crossings, end points and tangential contacts. A joint is reported once, the
    /// end of a closed spline as 0. For a segment on which the coordinate has that value everywhere, its ends.
    ///
    /// # Errors
    /// As [`Curve::times_at_coordinate`].
    pub fn times_at_coordinate(&self, axis: usize, value: f64) -> Result<Vec<f64>, Error> {
        let mut ts: Vec<f64> = Vec::new();
        for (k, curve) in self.segments().enumerate() {
            let times = curve.times_at_coordinate(axis, value)?;
            ts.extend(times.into_iter().map(|t| as_f64(k) + t));
        }
        ts.dedup();
        let end = as_f64(self.segment_count());
        // The start and the end of a closed spline are the same point.
        if self.closed && ts.first() == Some(&0.0) && ts.last() == Some(&end) {
            ts.pop();
        }
        Ok(ts)
    }
}

/// The signs of a coordinate's first change after the start and of its last one before the end; 0 where it is constant.
/// Rounding is no change.
fn directions<P: Point>(curve: &Curve<P>, axis: usize) -> [f64; 2] {
    let values: Vec<f64> = curve
        .control_points()
        .iter()
        .map(|p| p.coordinate(axis))
        .collect();
    let rounding = ulp(values.iter().fold(0.0, |m: f64, v| m.max(v.abs())));
    let change = |from: f64, value: &f64| {
        let step = value - from;
        if step.abs() > rounding {
            step.signum()
        } else {
            0.0
        }
    };
    // The first control value that differs from that of an end shows the direction next to the end.
    let (first, last) = (values[0], values[values.len() - 1]);
    [
        first_nonzero(values.iter().map(|value| change(first, value))),
        -first_nonzero(values.iter().rev().map(|value| change(last, value))),
    ]
}

fn first_nonzero(mut numbers: impl Iterator<Item = f64>) -> f64 {
    numbers.find(|&d| d != 0.0).unwrap_or(0.0)
}
