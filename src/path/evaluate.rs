//! Points, derivatives and parts of a path at given positions.

use super::{Path, PathTime, spline};
use crate::curve::Curve;
use crate::curve::arc_length::point_at_length::PointAtLength;
use crate::curve::eval::check_segments;
use crate::geometry::error::Error;
use crate::numeric::sort::sort_by;
use crate::spline::Spline;
use glam::DVec2;
use std::ops::{Bound, RangeBounds};

/// A position is a [`PathTime`]: a subpath, and t from 0 to its number of segments. At a joint the segment that starts
/// there counts, at the end the last segment; values outside extrapolate the first and the last segment. All functions
/// return [`Error::Index`] for a subpath that does not exist, and [`Error::Count`] for the empty path.
impl Path {
    /// The point at a position.
    ///
    /// ```
    /// use casteljau::{Path, glam::DVec2, path::PathTime};
    ///
    /// let path = Path::from_svg("M0 0H4 M0 1H4V5").expect("path data");
    /// let t = PathTime::new(1, 1.5);
    /// assert_eq!(path.eval(t)?, DVec2::new(4.0, 3.0));
    /// assert_eq!(path.tangent(t)?, DVec2::Y);
    /// # Ok::<(), casteljau::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::Index`] for a subpath that does not exist, [`Error::Count`] for the empty path.
    pub fn eval(&self, time: PathTime) -> Result<DVec2, Error> {
        self.at(time, Curve::eval)
    }

    /// The points at the given positions.
    ///
    /// # Errors
    /// As [`eval`](Self::eval).
    pub fn eval_at(&self, times: &[PathTime]) -> Result<Vec<DVec2>, Error> {
        times.iter().map(|&time| self.eval(time)).collect()
    }

    /// For each subpath, the points at even steps of t, both ends included; see [`Spline::sample`].
    ///
    /// [`Spline::sample`]: crate::Spline::sample
    ///
    /// # Errors
    /// As [`Curve::sample`]; the limit of 1 GiB is that of all subpaths together.
    pub fn sample(&self, per_curve: usize) -> Result<Vec<Vec<DVec2>>, Error> {
        if !self.is_empty() {
            check_segments(per_curve.saturating_mul(self.segment_count()), 2)?;
        }
        self.subpaths()
            .map(|spline| spline.sample(per_curve))
            .collect()
    }

    /// The k-th derivative with respect to t at a position; zero if k exceeds the degree of the segment.
    ///
    /// # Errors
    /// As [`eval`](Self::eval).
    pub fn derivative_at(&self, time: PathTime, k: usize) -> Result<DVec2, Error> {
        self.at(time, |curve, t| curve.derivative_at(t, k))
    }

    /// The unit tangent at a position, see [`Curve::tangent`]; zero if the segment is a point.
    ///
    /// # Errors
    /// As [`eval`](Self::eval).
    pub fn tangent(&self, time: PathTime) -> Result<DVec2, Error> {
        self.at(time, Curve::tangent)
    }

    /// The unit normal at a position: the tangent rotated by +90°, (x, y) → (−y, x).
    ///
    /// # Errors
    /// As [`eval`](Self::eval).
    pub fn normal(&self, time: PathTime) -> Result<DVec2, Error> {
        self.at(time, Curve::normal)
    }

    /// The curvature at a position in 1 / unit of length, positive for a counter-clockwise turn (x right, y up);
    /// infinite at a cusp. See [`Curve::curvature`].
    ///
    /// # Errors
    /// As [`eval`](Self::eval).
    pub fn curvature(&self, time: PathTime) -> Result<f64, Error> {
        self.at(time, Curve::curvature)
    }

    /// The position at the arc length s from the start of the first subpath, with point, tangent and normal; `None` for
    /// the empty path. See [`time_at_length`](Self::time_at_length).
    pub fn point_at_length(&self, s: f64) -> Option<PointAtLength<DVec2, PathTime>> {
        self.point_and_directions(self.time_at_length(s)?)
    }

    /// The point at a position of the path, with its directions.
    pub(crate) fn point_and_directions(
        &self,
        t: PathTime,
    ) -> Option<PointAtLength<DVec2, PathTime>> {
        let all = |curve: &Curve<DVec2>, rest: f64| PointAtLength {
            t,
            point: curve.eval(rest),
            tangent: curve.tangent(rest),
            normal: curve.normal(rest),
        };
        self.at(t, all).ok()
    }

    /// The arc length from the start of the first subpath to a position: the inverse of
    /// [`time_at_length`](Self::time_at_length). Beyond the ends of a subpath, the end counts; for NaN it is NaN.
    ///
    /// ```
    /// use casteljau::{Path, path::PathTime};
    ///
    /// let path = Path::from_svg("M0 0H4 M0 1H4V5").expect("path data");
    /// assert_eq!(path.length_at(PathTime::new(1, 1.5))?, 10.0);
    /// # Ok::<(), casteljau::Error>(())
    /// ```
    ///
    /// # Errors
    /// As [`eval`](Self::eval).
    pub fn length_at(&self, time: PathTime) -> Result<f64, Error> {
        let PathTime { subpath, t } = self.checked(time)?;
        if t.is_nan() {
            return Ok(t);
        }
        let mut splines = self.subpaths();
        let before = splines.by_ref().take(subpath);
        let before: f64 = before.map(|spline| spline.length()).sum();
        let t = t.clamp(0.0, self.end_of(subpath).t);
        let part = splines.next().filter(|_| t > 0.0);
        Ok(before + part.map_or(0.0, |spline| spline.subsegment(..t).length()))
    }

    /// The part before a position and the part after it.
    ///
    /// The subpath that contains the position becomes two open ones (a closed subpath is also divided at its start); all
    /// others are unchanged. At the start or the end of a subpath nothing is divided, so one of the parts may be an
    /// empty path.
    ///
    /// # Errors
    /// As [`eval`](Self::eval).
    pub fn split(&self, time: PathTime) -> Result<(Self, Self), Error> {
        Ok((self.subsegment(..time)?, self.subsegment(time..)?))
    }

    /// The parts before, between and after any number of positions, in any order.
    ///
    /// Each part is what [`split`](Self::split) leaves between two neighbours, so there is one part more than positions;
    /// parts between equal positions, and before the start or after the end of the path, are empty paths.
    ///
    /// ```
    /// use casteljau::{Path, path::PathTime};
    ///
    /// let path = Path::from_svg("M0 0H4 M0 1H4").expect("path data");
    /// let parts = path.split_at(&[PathTime::new(1, 0.25), PathTime::new(0, 0.5)])?;
    /// assert_eq!(parts[1].to_string(), "M2,0 L4,0 M0,1 L1,1");
    /// # Ok::<(), casteljau::Error>(())
    /// ```
    ///
    /// # Errors
    /// As [`eval`](Self::eval).
    pub fn split_at(&self, times: &[PathTime]) -> Result<Vec<Self>, Error> {
        let mut ends = Vec::with_capacity(times.len() + 1);
        for &time in times {
            ends.push(self.checked(time)?);
        }
        let Some(last) = self.subpath_count().checked_sub(1) else {
            return Ok(vec![Self::default()]);
        };
        sort_by(&mut ends, PathTime::total_cmp);
        ends.push(self.end_of(last));
        let mut start = PathTime::new(0, 0.0);
        let part = |end| self.subpaths_between(std::mem::replace(&mut start, end), end);
        Ok(ends.into_iter().map(part).collect())
    }

    /// The part of the path in a range of positions; if the start is after the end, the same part with the opposite
    /// direction and the subpaths in the opposite order.
    ///
    /// Parts of a subpath are open; a closed subpath that is contained as a whole stays closed. A part does not cross
    /// the start of a closed subpath. If both positions are equal, the part is a single segment that is a point (with an
    /// open range, such as `..start`, it is empty).
    ///
    /// ```
    /// use casteljau::{Path, path::PathTime};
    ///
    /// let path = Path::from_svg("M0 0H4 M0 1H4").expect("path data");
    /// let part = path.subsegment(PathTime::new(0, 0.5)..PathTime::new(1, 0.25))?;
    /// assert_eq!(part.to_string(), "M2,0 L4,0 M0,1 L1,1");
    /// # Ok::<(), casteljau::Error>(())
    /// ```
    ///
    /// # Errors
    /// As [`eval`](Self::eval); [`Error::Count`] for the empty path only if the range has a start or an end.
    pub fn subsegment(&self, range: impl RangeBounds<PathTime>) -> Result<Self, Error> {
        let given = |bound: Bound<&PathTime>| match bound {
            Bound::Included(&time) | Bound::Excluded(&time) => self.checked(time).map(Some),
            Bound::Unbounded => Ok(None),
        };
        let (from, to) = (given(range.start_bound())?, given(range.end_bound())?);
        let Some(last) = self.subpath_count().checked_sub(1) else {
            return Ok(Self::default());
        };
        let start = from.unwrap_or(PathTime::new(0, 0.0));
        let end = to.unwrap_or_else(|| self.end_of(last));
        if start > end && from.is_some() && to.is_some() {
            let part = self.subsegment(end..start)?;
            return part
                .subpaths()
                .rev()
                .map(|spline| Ok(spline.reverse()))
                .collect();
        }
        if from.is_some() && from == to {
            let spline = self.subpaths().nth(start.subpath);
            return Ok(spline
                .map(|spline| spline.part(start.t, start.t))
                .into_iter()
                .collect());
        }
        Ok(self.subpaths_between(start, end))
    }

    /// The subpaths between two positions in order; parts whose ends have the same t are omitted.
    fn subpaths_between(&self, start: PathTime, end: PathTime) -> Self {
        let mut path = Self::default();
        for k in start.subpath..=end.subpath {
            let spline = spline(self.part(k));
            let whole = self.end_of(k).t;
            let from = if k == start.subpath { start.t } else { 0.0 };
            let to = if k == end.subpath { end.t } else { whole };
            if from == 0.0 && to == whole {
                path.push_spline(&spline);
            } else if from != to {
                path.push_spline(&spline.part(from, to));
            }
        }
        path
    }

    /// The positions where a coordinate (0 is x, 1 is y) has a local extremum, in the order of the path; see
    /// [`Spline::extrema`](crate::Spline::extrema).
    ///
    /// # Errors
    /// [`Error::Index`] for an axis other than 0 and 1.
    pub fn extrema(&self, axis: usize) -> Result<Vec<PathTime>, Error> {
        self.times(|spline| spline.extrema(axis))
    }

    /// All positions at which a coordinate (0 is x, 1 is y) has a given value, in the order of the path; see
    /// [`Spline::times_at_coordinate`](crate::Spline::times_at_coordinate).
    ///
    /// # Errors
    /// As [`Curve::times_at_coordinate`].
    pub fn times_at_coordinate(&self, axis: usize, value: f64) -> Result<Vec<PathTime>, Error> {
        self.times(|spline| spline.times_at_coordinate(axis, value))
    }

    /// The positions at the times that a function gives for each subpath.
    fn times(
        &self,
        of: impl Fn(&Spline<DVec2>) -> Result<Vec<f64>, Error>,
    ) -> Result<Vec<PathTime>, Error> {
        let mut times = Vec::new();
        for (subpath, spline) in self.subpaths().enumerate() {
            times.extend(of(&spline)?.into_iter().map(|t| PathTime::new(subpath, t)));
        }
        Ok(times)
    }

    /// The end of subpath k, which must exist.
    pub(super) fn end_of(&self, k: usize) -> PathTime {
        PathTime {
            subpath: k,
            t: self.part(k).segment_count() as f64,
        }
    }

    /// A position, if its subpath exists.
    pub(super) fn checked(&self, time: PathTime) -> Result<PathTime, Error> {
        let count = self.subpath_count();
        match count.checked_sub(1) {
            None => Err(Error::Count {
                what: "subpaths",
                expected: "at least 1, of which one contains the position",
                got: 0,
            }),
            Some(last) if time.subpath > last => Err(Error::Index {
                what: "subpath",
                first: 0,
                last,
                got: time.subpath,
            }),
            Some(_) => Ok(time),
        }
    }

    /// The value of a function of a segment and the parameter on it at a position.
    fn at<R>(&self, time: PathTime, value: impl Fn(&Curve<DVec2>, f64) -> R) -> Result<R, Error> {
        let PathTime { subpath, t } = self.checked(time)?;
        let (k, rest) = self.part(subpath).locate(t);
        Ok(value(
            &Curve::from_slice(self.part(subpath).segment(k)),
            rest,
        ))
    }
}
