//! Paths: lists of splines, such as outlines with holes and icons; the equivalent of SVG path data.
//!
//! A path is a list of **subpaths**, each a [`Spline`] of the plane, open or closed. A path can be filled (a hole is a
//! subpath with the opposite direction, or any second one under the even-odd rule); it reads and writes the `d`
//! attribute of an SVG `<path>`. A position on a path is a [`PathTime`]: the index of a subpath, and the parameter t on
//! it.

pub(crate) mod arc;
mod arcs;
#[cfg(feature = "regions")]
mod boolean;
mod bounds;
pub(crate) mod builder;
mod convert;
mod elements;
mod evaluate;
#[cfg(feature = "regions")]
mod ink;
pub(crate) mod intersect;
pub(crate) mod length;
mod moments;
mod nearest;
mod shapes;
#[cfg(feature = "fit")]
mod simplify;
#[cfg(feature = "regions")]
mod stroke;
mod trace;
pub(crate) mod winding;

#[cfg(feature = "io")]
pub use crate::io::{svg_error::SvgError, svg_write::SvgOptions};
pub use crate::spline::Join;
pub use arcs::CircularArc;
#[cfg(all(feature = "count-work", feature = "regions"))]
pub use boolean::take_replaced_segments;
#[cfg(feature = "regions")]
pub use boolean::{BooleanOperation, Face};
pub use builder::{BuildError, PathBuilder};
pub use elements::PathElement;
#[cfg(feature = "regions")]
pub use ink::{InkChanges, InkOptions, InkPressure, InkSample, InkStroke};
pub use intersect::PathIntersection;
pub use length::PathLengths;
pub use nearest::PathPoint;
#[cfg(feature = "regions")]
pub use stroke::{
    CornerOptions, OffsetOptions, StrokeCap, StrokeOptions, WidthInterpolation, WidthPosition,
    WidthProfile,
};
pub use winding::FillRule;

use crate::geometry::check::images;
use crate::geometry::error::Error;
use crate::geometry::point::Point;
use crate::numeric::float::whole_and_rest;
use crate::spline::Spline;
use glam::{DAffine2, DVec2};
use std::cmp::Ordering;
use std::ops::Range;

/// A position on a path; positions are ordered along the path.
#[derive(Clone, Copy, Debug, PartialEq, PartialOrd)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(rename_all = "camelCase")
)]
pub struct PathTime {
    /// The index of the subpath.
    pub subpath: usize,
    /// The parameter on it, from 0 to its number of segments.
    pub t: f64,
}

impl PathTime {
    /// The position t on a subpath.
    pub const fn new(subpath: usize, t: f64) -> Self {
        Self { subpath, t }
    }

    /// The order along the path, in which NaN is the last t.
    pub(crate) fn total_cmp(&self, other: &Self) -> Ordering {
        self.subpath
            .cmp(&other.subpath)
            .then(self.t.total_cmp(&other.t))
    }
}

/// A list of plane splines, open or closed; it may be empty.
///
/// ```
/// use casteljau::{Path, glam::DVec2, path::FillRule};
///
/// let ring = Path::from_svg("M0 0H4V4H0Z M1 1V3H3V1Z").expect("path data");
/// assert_eq!(ring.subpath_count(), 2);
/// assert!(ring.contains(DVec2::new(0.5, 2.0), FillRule::NonZero));
/// assert!(!ring.contains(DVec2::new(2.0, 2.0), FillRule::NonZero));
/// ```
#[derive(Clone, Debug, Default, PartialEq)]
#[must_use = "methods return new values"]
pub struct Path {
    /// The control points of all subpaths, each joint once; a closed subpath ends with its first point again, so that
    /// the points of each segment are contiguous.
    points: Vec<DVec2>,
    /// The index of the last point of every segment; its first point is the last one of the segment before, or the
    /// first one of its subpath.
    ends: Vec<usize>,
    subpaths: Vec<SubpathEnd>,
}

/// The ends of a subpath in the lists of its path; it starts where the previous one ends.
#[derive(Clone, Copy, Debug, PartialEq)]
struct SubpathEnd {
    points: usize,
    segments: usize,
    closed: bool,
}

/// A view of one subpath.
#[derive(Clone, Copy)]
pub(crate) struct Subpath<'a> {
    /// The control points; a closed subpath ends with its first point again.
    pub(crate) points: &'a [DVec2],
    /// The index of the last point of each segment, counted from `first`.
    ends: &'a [usize],
    first: usize,
    pub(crate) closed: bool,
}

/// The subpaths of a path as splines; see [`Path::subpaths`].
#[derive(Clone, Debug)]
pub struct Subpaths<'a> {
    path: &'a Path,
    rest: Range<usize>,
}

impl Iterator for Subpaths<'_> {
    type Item = Spline<DVec2>;

    fn next(&mut self) -> Option<Spline<DVec2>> {
        self.rest.next().map(|k| spline(self.path.part(k)))
    }

    fn size_hint(&self) -> (usize, Option<usize>) {
        self.rest.size_hint()
    }

    fn nth(&mut self, n: usize) -> Option<Spline<DVec2>> {
        self.rest.nth(n).map(|k| spline(self.path.part(k)))
    }
}

impl DoubleEndedIterator for Subpaths<'_> {
    fn next_back(&mut self) -> Option<Spline<DVec2>> {
        self.rest.next_back().map(|k| spline(self.path.part(k)))
    }
}

impl ExactSizeIterator for Subpaths<'_> {}

impl<'a> Subpath<'a> {
    /// The control points of each segment.
    pub(crate) fn segments(self) -> impl Iterator<Item = &'a [DVec2]> + Clone {
        (0..self.segment_count()).map(move |k| self.segment(k))
    }

    /// The control points of segment k, which must exist.
    pub(crate) fn segment(self, k: usize) -> &'a [DVec2] {
        let from = k.checked_sub(1).map_or(0, |before| self.end(before));
        &self.points[from..=self.end(k)]
    }

    /// The index of the last point of segment k.
    fn end(self, k: usize) -> usize {
        self.ends[k] - self.first
    }

    pub(crate) fn segment_count(self) -> usize {
        self.ends.len()
    }

    /// The segment that contains t and the local parameter on it; the end belongs to the last segment.
    fn locate(self, t: f64) -> (usize, f64) {
        whole_and_rest(t, self.segment_count() - 1)
    }

    /// The degree of each segment.
    pub(crate) fn degrees(self) -> impl Iterator<Item = usize> + 'a {
        self.segments().map(|points| points.len() - 1)
    }

    /// The first and the last point.
    pub(crate) fn ends(self) -> (DVec2, DVec2) {
        (self.points[0], self.points[self.points.len() - 1])
    }
}

impl Path {
    /// A path of splines.
    ///
    /// An empty list gives the empty path, which has no bounds and has area and length 0.
    pub fn new(splines: &[Spline<DVec2>]) -> Self {
        let mut path = Self::default();
        for spline in splines {
            path.push_spline(spline);
        }
        path
    }

    fn push_spline(&mut self, spline: &Spline<DVec2>) {
        self.push(
            spline.control_points(),
            spline.degrees(),
            spline.is_closed(),
        );
    }

    /// Appends a subpath given by the parts of a spline.
    pub(crate) fn push(
        &mut self,
        points: &[DVec2],
        degrees: impl IntoIterator<Item = usize>,
        closed: bool,
    ) {
        self.push_segments(self.points.len(), degrees);
        self.points.extend(points);
        if closed {
            self.points.push(points[0]);
        }
        self.end_subpath(closed);
    }

    /// Appends the ends of segments, the first of which starts at the point with index `first`.
    fn push_segments(&mut self, first: usize, degrees: impl IntoIterator<Item = usize>) {
        let mut end = first;
        self.ends.extend(degrees.into_iter().map(|degree| {
            end += degree;
            end
        }));
    }

    /// Ends a subpath: it consists of the points and segments after those of the last subpath.
    fn end_subpath(&mut self, closed: bool) {
        self.subpaths.push(SubpathEnd {
            points: self.points.len(),
            segments: self.ends.len(),
            closed,
        });
    }

    /// The number of subpaths.
    pub fn subpath_count(&self) -> usize {
        self.subpaths.len()
    }

    /// The total number of segments of all subpaths.
    pub fn segment_count(&self) -> usize {
        self.ends.len()
    }

    /// Whether the path has no subpaths.
    pub fn is_empty(&self) -> bool {
        self.subpaths.is_empty()
    }

    /// Subpath k as a spline; `None` past the last one.
    pub fn subpath(&self, k: usize) -> Option<Spline<DVec2>> {
        (k < self.subpath_count()).then(|| spline(self.part(k)))
    }

    /// The subpaths as splines, from the first to the last.
    pub fn subpaths(&self) -> Subpaths<'_> {
        Subpaths {
            path: self,
            rest: 0..self.subpath_count(),
        }
    }

    /// The number of segments before subpath k.
    fn segments_before(&self, k: usize) -> usize {
        k.checked_sub(1)
            .map_or(0, |before| self.subpaths[before].segments)
    }

    /// Subpath k, which must exist.
    fn part(&self, k: usize) -> Subpath<'_> {
        let first = k
            .checked_sub(1)
            .map_or(0, |before| self.subpaths[before].points);
        let segments = self.segments_before(k);
        let end = self.subpaths[k];
        Subpath {
            points: &self.points[first..end.points],
            ends: &self.ends[segments..end.segments],
            first,
            closed: end.closed,
        }
    }

    pub(crate) fn parts(&self) -> impl Iterator<Item = Subpath<'_>> + Clone {
        (0..self.subpath_count()).map(|k| self.part(k))
    }

    /// Whether both paths have the same structure and every control point lies within `tolerance` of its counterpart.
    pub fn approx_eq(&self, other: &Self, tolerance: f64) -> bool {
        let near = |(&a, &b): (&DVec2, &DVec2)| a == b || Point::norm(a - b) <= tolerance;
        self.subpaths == other.subpaths
            && self.ends == other.ends
            && self.points.iter().zip(&other.points).all(near)
    }

    /// The image under an affine map, which is applied to all control points.
    ///
    /// # Errors
    /// [`Error::NotFinite`] and [`Error::Item`] for an image that is not finite or exceeds
    /// [`MAX_COORDINATE`](crate::MAX_COORDINATE).
    pub fn transform(&self, map: &DAffine2) -> Result<Self, Error> {
        Ok(Self {
            points: images(&self.points, map)?,
            ends: self.ends.clone(),
            subpaths: self.subpaths.clone(),
        })
    }

    /// The same path with each subpath reversed; the order of the subpaths and the first point of closed ones are kept.
    /// Areas and winding numbers change their sign.
    pub fn reverse(&self) -> Self {
        let mut path = Self::default();
        for part in self.parts() {
            let backwards = (0..part.segment_count()).rev();
            path.push_segments(
                path.points.len(),
                backwards.map(|k| part.segment(k).len() - 1),
            );
            path.points.extend(part.points.iter().rev());
            path.end_subpath(part.closed);
        }
        path
    }
}

fn spline(part: Subpath<'_>) -> Spline<DVec2> {
    let degrees: Vec<usize> = part.degrees().collect();
    let count = part.points.len() - usize::from(part.closed);
    Spline::from_parts(part.points[..count].to_vec(), &degrees, part.closed)
}
