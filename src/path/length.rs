//! Arc length of a path, and positions at given arc lengths.

use super::{Path, PathTime};
use crate::curve::Curve;
use crate::curve::PointAtLength;
use crate::curve::arc_length::segments::SegmentLengths;
use crate::curve::eval::check_segments;
use crate::geometry::check::check_tolerance;
use crate::geometry::error::Error;
use crate::geometry::point::Point;
use crate::numeric::float::as_f64;
use casteljau_kernels::curve::arc_length::plane_cubic::plane_cubic_length;
use glam::{DVec2, DVec3};

impl Path {
    /// The sum of the arc lengths of all segments; the gaps between subpaths and the lines that would close open
    /// subpaths do not count.
    ///
    /// The relative error is at most 10⁻¹². The empty path has length 0. Source: as [`Curve::length`].
    #[doc(alias = "arclen")]
    pub fn length(&self) -> f64 {
        self.arc_length(f64::INFINITY)
    }

    /// [`length`](Self::length) with a maximum error of the sum, in the unit of the points.
    ///
    /// # Errors
    /// As [`Curve::length_within`].
    pub fn length_within(&self, tolerance: f64) -> Result<f64, Error> {
        check_tolerance(tolerance, self.max_abs())?;
        Ok(self.arc_length(tolerance / as_f64(self.segment_count().max(1))))
    }

    /// The sum of the lengths of the segments, each within `share`.
    fn arc_length(&self, share: f64) -> f64 {
        let lengths = self
            .segment_points()
            .map(|points| segment_length(points, share));
        lengths.fold(0.0, |sum, length| sum + length)
    }

    /// The position at the arc length s from the start of the first subpath; `None` for the empty path.
    ///
    /// If s lies outside 0 to the total length the result is the nearer end. Where a subpath ends and another one
    /// starts, the result is the start. For NaN, t is NaN. The error, as a length, is at most 10⁻¹² of the length of the
    /// segment.
    #[doc(alias = "inv_arclen")]
    pub fn time_at_length(&self, s: f64) -> Option<PathTime> {
        self.time_at(s, None)
    }

    /// [`time_at_length`](Self::time_at_length) with a maximum error, as a length in the unit of the points.
    ///
    /// # Errors
    /// As [`Curve::length_within`].
    pub fn time_at_length_within(&self, s: f64, tolerance: f64) -> Result<Option<PathTime>, Error> {
        check_tolerance(tolerance, self.max_abs())?;
        Ok(self.time_at(s, Some(tolerance)))
    }

    fn time_at(&self, s: f64, tolerance: Option<f64>) -> Option<PathTime> {
        self.lengths().position(s, tolerance)
    }

    /// The arc lengths of all segments, for many questions about one path: each one of [`PathLengths`] costs a binary
    /// search and a step on one segment, where [`time_at_length`](Self::time_at_length) and
    /// [`point_at_length`](Self::point_at_length) compute all lengths first.
    ///
    /// ```
    /// use casteljau::{Path, path::PathTime};
    ///
    /// let path = Path::from_svg("M0 0H4 M0 1H4V5").expect("path data");
    /// let mut lengths = path.lengths();
    /// assert_eq!(lengths.total(), 12.0);
    /// assert_eq!(lengths.time_at(10.0), Some(PathTime::new(1, 1.5)));
    /// assert_eq!(lengths.point_at(10.0).map(|at| at.point.y), Some(3.0));
    /// ```
    pub fn lengths(&self) -> PathLengths<'_> {
        let index = SegmentIndex::new(self);
        let lengths = index.lengths();
        PathLengths {
            path: self,
            index,
            lengths,
        }
    }

    /// `segments` + 1 positions that divide the path into parts of equal length; an empty list for the empty path.
    ///
    /// The first is the start of the first subpath, the last is the end of the last one; a part may contain joints and
    /// gaps between subpaths. For a path of length 0: even steps of t.
    ///
    /// # Errors
    /// As [`Curve::equidistant_times`].
    pub fn equidistant_times(&self, segments: usize) -> Result<Vec<PathTime>, Error> {
        check_segments(segments, 3)?;
        if self.is_empty() {
            return Ok(Vec::new());
        }
        let index = SegmentIndex::new(self);
        let positions = index
            .lengths()
            .even_positions(segments, &|k| index.curve(k));
        Ok(positions
            .into_iter()
            .map(|at| index.path_time(at))
            .collect())
    }
}

/// The arc lengths of the segments of a path; see [`Path::lengths`].
///
/// The tables of the segment that was asked last are kept, too, so questions in the order of the path are fastest.
pub struct PathLengths<'a> {
    path: &'a Path,
    index: SegmentIndex<'a>,
    lengths: SegmentLengths,
}

impl PathLengths<'_> {
    /// As [`Path::length`].
    pub fn total(&self) -> f64 {
        self.lengths.ends()[self.path.segment_count()]
    }

    /// As [`Path::time_at_length`].
    pub fn time_at(&mut self, s: f64) -> Option<PathTime> {
        self.position(s, None)
    }

    /// As [`Path::point_at_length`].
    pub fn point_at(&mut self, s: f64) -> Option<PointAtLength<DVec2, PathTime>> {
        let time = self.time_at(s)?;
        self.path.point_and_directions(time)
    }

    fn position(&mut self, s: f64, tolerance: Option<f64>) -> Option<PathTime> {
        if self.path.is_empty() {
            return None;
        }
        let Self { index, lengths, .. } = self;
        let at = lengths.position(s, 0.0, tolerance, &|k| index.curve(k));
        Some(index.path_time(at))
    }
}

/// The arc length of one segment.
///
/// Lines have a fast path, and so do quadratics and cubics without a tolerance. A quadratic is elevated to a cubic,
/// relative to its start, so that no precision is lost far from the origin.
fn segment_length(points: &[DVec2], tolerance: f64) -> f64 {
    let plain = tolerance == f64::INFINITY;
    match *points {
        [a, b, c, d] if plain => plane_cubic_length(&[a, b, c, d].map(|p| p.to_array())),
        [a, b, c] if plain => {
            let (first, chord) = ((b - a) * (2.0 / 3.0), c - a);
            let raised = [DVec2::ZERO, first, first + chord / 3.0, chord];
            plane_cubic_length(&raised.map(|p| p.to_array()))
        }
        [a, b] => Point::norm(b - a),
        _ => to_3d(points).arc_length(tolerance),
    }
}

/// The segment as a 3D curve; all lengths except those of the fast paths are computed in 3D.
fn to_3d(points: &[DVec2]) -> Curve<DVec3> {
    Curve::from_points(points.iter().map(|p| p.to_3d()).collect())
}

/// The segments of a path: the subpath of each, its index on it, and its control points.
pub(crate) struct SegmentIndex<'a>(Vec<(usize, usize, &'a [DVec2])>);

impl<'a> SegmentIndex<'a> {
    pub(crate) fn new(path: &'a Path) -> Self {
        let parts = path.parts().enumerate();
        let segments = parts.flat_map(|(subpath, part)| {
            let numbered = part.segments().enumerate();
            numbered.map(move |(k, points)| (subpath, k, points))
        });
        Self(segments.collect())
    }

    pub(crate) fn lengths(&self) -> SegmentLengths {
        let length =
            |&(_, _, points): &(usize, usize, &[DVec2])| segment_length(points, f64::INFINITY);
        SegmentLengths::new(self.0.iter().map(length))
    }

    fn curve(&self, k: usize) -> Curve<DVec3> {
        to_3d(self.0[k].2)
    }

    fn path_time(&self, (k, t): (usize, f64)) -> PathTime {
        let (subpath, before, _) = self.0[k];
        PathTime {
            subpath,
            t: as_f64(before) + t,
        }
    }
}
