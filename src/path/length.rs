//! Arc length of a path, and positions at given arc lengths.

use super::{Path, PathTime};
use crate::curve::Curve;
use crate::curve::arc_length::inverse::{ArcLengthInverse, check_length};
use crate::curve::arc_length::plane_cubic::plane_cubic_length;
use crate::curve::eval::check_segments;
use crate::geometry::check::check_tolerance;
use crate::geometry::error::Error;
use crate::geometry::point::Point;
use glam::{DVec2, DVec3};

impl Path {
    /// The sum of the arc lengths of all segments; the gaps between subpaths and the lines that would close open
    /// subpaths do not count.
    ///
    /// `tolerance` is the maximum error of the sum, in the unit of the points; the default is 10⁻¹² of the length. The
    /// empty path has length 0. Source: as [`Curve::length`].
    ///
    /// # Errors
    /// As [`Curve::length`].
    pub fn length(&self, tolerance: Option<f64>) -> Result<f64, Error> {
        let share = match tolerance {
            Some(tolerance) => {
                check_tolerance(tolerance, self.max_abs())?;
                tolerance / self.segment_count().max(1) as f64
            }
            None => f64::INFINITY,
        };
        let lengths = self
            .segment_points()
            .map(|points| segment_length(points, share));
        Ok(lengths.fold(0.0, |sum, length| sum + length))
    }

    /// The position at the arc length s from the start of the first subpath; `None` for the empty path.
    ///
    /// If s lies outside 0 to the total length the result is the nearer end. Where a subpath ends and another one
    /// starts, the result is the start. `tolerance` is the maximum error as a length; the default is 10⁻¹² of the
    /// length of the segment.
    ///
    /// # Errors
    /// As [`Curve::time_at_length`].
    pub fn time_at_length(
        &self,
        s: f64,
        tolerance: Option<f64>,
    ) -> Result<Option<PathTime>, Error> {
        check_length(s)?;
        if let Some(tolerance) = tolerance {
            check_tolerance(tolerance, self.max_abs())?;
        }
        if self.is_empty() {
            return Ok(None);
        }
        let index = ArcLengthIndex::new(self);
        if s > 0.0 && s >= index.whole() {
            return Ok(Some(index.end()));
        }
        let (k, rest) = index.segment_at(s);
        let t = ArcLengthInverse::new(&index.curve(k), tolerance).time(rest);
        Ok(Some(index.path_time(k, t)))
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
        let index = ArcLengthIndex::new(self);
        let mut times = Vec::with_capacity(segments + 1);
        let mut table: Option<(usize, ArcLengthInverse)> = None;
        for i in 0..segments {
            let part = i as f64 / segments as f64;
            let (k, rest) = index.segment_of(part);
            let (_, curve) = match table.take().filter(|&(of, _)| of == k) {
                Some(table) => table,
                None => (k, ArcLengthInverse::new(&index.curve(k), None)),
            };
            let t = if index.whole() > 0.0 {
                curve.time(rest)
            } else {
                rest
            };
            times.push(index.path_time(k, t));
            table = Some((k, curve));
        }
        times.push(index.end());
        Ok(times)
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
        [a, b] => Point::length(b - a),
        _ => to_3d(points).arc_length(tolerance),
    }
}

/// The segment as a 3D curve; all lengths except those of the fast paths are computed in 3D.
fn to_3d(points: &[DVec2]) -> Curve<DVec3> {
    Curve::from_points(points.iter().map(|p| p.to_3d()).collect())
}

/// The cumulative arc lengths of the segments of a nonempty path.
struct ArcLengthIndex<'a> {
    /// The subpath, the segment's index in it, and the control points.
    segments: Vec<(usize, usize, &'a [DVec2])>,
    /// The arc length from the start of the path to the start of each segment, and the total.
    starts: Vec<f64>,
}

impl<'a> ArcLengthIndex<'a> {
    fn new(path: &'a Path) -> Self {
        let parts = path.parts().enumerate();
        let segments: Vec<_> = parts
            .flat_map(|(subpath, part)| {
                let numbered = part.segments().enumerate();
                numbered.map(move |(k, points)| (subpath, k, points))
            })
            .collect();
        let mut starts = vec![0.0];
        let mut whole = 0.0;
        for (_, _, points) in &segments {
            whole += segment_length(points, f64::INFINITY);
            starts.push(whole);
        }
        Self { segments, starts }
    }

    fn whole(&self) -> f64 {
        self.starts[self.segments.len()]
    }

    /// The segment that contains the arc length s, and the rest of s on it; past the end the rest exceeds the segment.
    fn segment_at(&self, s: f64) -> (usize, f64) {
        if s <= 0.0 {
            return (0, 0.0);
        }
        let last = self.segments.len() - 1;
        let k = self.starts[1..=last].partition_point(|&end| end <= s);
        (k, s - self.starts[k])
    }

    /// [`segment_at`](Self::segment_at) for a ratio of the total length; if that is 0, for a ratio of the parameter
    /// range.
    #[allow(
        clippy::cast_possible_truncation,
        reason = "below the number of segments"
    )]
    #[allow(clippy::cast_sign_loss, reason = "not negative")]
    fn segment_of(&self, part: f64) -> (usize, f64) {
        if self.whole() > 0.0 {
            return self.segment_at(part * self.whole());
        }
        let t = part * self.segments.len() as f64;
        ((t as usize).min(self.segments.len() - 1), t.fract())
    }

    fn curve(&self, k: usize) -> Curve<DVec3> {
        to_3d(self.segments[k].2)
    }

    fn end(&self) -> PathTime {
        self.path_time(self.segments.len() - 1, 1.0)
    }

    fn path_time(&self, k: usize, t: f64) -> PathTime {
        let (subpath, before, _) = self.segments[k];
        PathTime {
            subpath,
            t: before as f64 + t,
        }
    }
}
