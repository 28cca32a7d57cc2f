//! Paths: lists of splines, such as outlines with holes and icons; the equivalent of SVG path data.
//!
//! A path is a list of **subpaths**, each a [`Spline`] of the plane, open or closed. A path can be filled (a hole is a
//! subpath with the opposite direction, or any second one under the even-odd rule); it reads and writes the `d`
//! attribute of an SVG `<path>`. A position on a path is a [`PathTime`]: the index of a subpath, and the parameter t on
//! it.

pub(crate) mod arc;
mod boolean;
mod bounds;
pub(crate) mod builder;
mod convert;
mod elements;
pub(crate) mod intersect;
mod length;
mod moments;
mod nearest;
mod stroke;
mod trace;
mod winding;

pub use crate::io::svg_error::SvgError;
pub use boolean::{BooleanOperation, Face};
pub use builder::PathBuilder;
pub use elements::PathElement;
pub use intersect::PathIntersection;
pub use nearest::PathPoint;
pub use stroke::{OffsetOptions, StrokeCap, StrokeOptions};
pub use winding::FillRule;

use crate::geometry::check::images;
use crate::geometry::error::Error;
use crate::geometry::point::Point;
use crate::spline::Spline;
use glam::{DAffine2, DVec2};

/// A position on a path.
#[derive(Clone, Copy, Debug, PartialEq)]
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
pub struct Path {
    /// The control points of all subpaths, each joint once; a closed subpath ends with its first point again, so that
    /// the points of each segment are contiguous.
    points: Vec<DVec2>,
    /// The degree of every segment, 1 to 64.
    degrees: Vec<u8>,
    subpaths: Vec<Extent>,
}

/// The ends of a subpath in the lists of its path; it starts where the previous one ends.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Extent {
    points: usize,
    degrees: usize,
    closed: bool,
}

/// A view of one subpath.
#[derive(Clone, Copy)]
pub(crate) struct Subpath<'a> {
    /// The control points; a closed subpath ends with its first point again.
    pub(crate) points: &'a [DVec2],
    degrees: &'a [u8],
    pub(crate) closed: bool,
}

impl<'a> Subpath<'a> {
    /// The control points of each segment.
    pub(crate) fn segments(self) -> impl Iterator<Item = &'a [DVec2]> + Clone {
        let mut from = 0;
        self.degrees.iter().map(move |&degree| {
            let to = from + usize::from(degree);
            let points = &self.points[from..=to];
            from = to;
            points
        })
    }

    pub(crate) fn segment_count(self) -> usize {
        self.degrees.len()
    }

    pub(crate) fn ends_with_line(self) -> bool {
        self.degrees.last() == Some(&1)
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
            let degrees = spline.degrees();
            path.push(spline.control_points(), &degrees, spline.is_closed());
        }
        path
    }

    /// Appends a subpath given by the parts of a spline.
    pub(crate) fn push<D: Copy + TryInto<u8>>(
        &mut self,
        points: &[DVec2],
        degrees: &[D],
        closed: bool,
    ) {
        self.points.extend(points);
        if closed {
            self.points.push(points[0]);
        }
        let small = |&degree: &D| degree.try_into().unwrap_or(u8::MAX); // at most 64
        self.degrees.extend(degrees.iter().map(small));
        self.end_subpath(closed);
    }

    /// Ends a subpath: it consists of the points and degrees after those of the last subpath.
    fn end_subpath(&mut self, closed: bool) {
        self.subpaths.push(Extent {
            points: self.points.len(),
            degrees: self.degrees.len(),
            closed,
        });
    }

    /// The number of subpaths.
    pub fn subpath_count(&self) -> usize {
        self.subpaths.len()
    }

    /// The total number of segments of all subpaths.
    pub fn segment_count(&self) -> usize {
        self.degrees.len()
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
    pub fn subpaths(
        &self,
    ) -> impl ExactSizeIterator<Item = Spline<DVec2>> + DoubleEndedIterator + Clone + '_ {
        (0..self.subpath_count()).map(|k| spline(self.part(k)))
    }

    /// Subpath k, which must exist.
    fn part(&self, k: usize) -> Subpath<'_> {
        let (points, degrees) = match k.checked_sub(1).map(|before| self.subpaths[before]) {
            Some(before) => (before.points, before.degrees),
            None => (0, 0),
        };
        let end = self.subpaths[k];
        Subpath {
            points: &self.points[points..end.points],
            degrees: &self.degrees[degrees..end.degrees],
            closed: end.closed,
        }
    }

    pub(crate) fn parts(&self) -> impl Iterator<Item = Subpath<'_>> + Clone {
        (0..self.subpath_count()).map(|k| self.part(k))
    }

    /// Whether both paths have the same structure and every control point lies within `tolerance` of its counterpart.
    pub fn approx_eq(&self, other: &Self, tolerance: f64) -> bool {
        let near = |(&a, &b): (&DVec2, &DVec2)| a == b || Point::length(a - b) <= tolerance;
        self.subpaths == other.subpaths
            && self.degrees == other.degrees
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
            degrees: self.degrees.clone(),
            subpaths: self.subpaths.clone(),
        })
    }

    /// The same path with each subpath reversed; the order of the subpaths and the first point of closed ones are kept.
    /// Areas and winding numbers change their sign.
    #[must_use]
    pub fn reverse(&self) -> Self {
        let mut path = Self::default();
        for part in self.parts() {
            path.points.extend(part.points.iter().rev());
            path.degrees.extend(part.degrees.iter().rev());
            path.end_subpath(part.closed);
        }
        path
    }
}

fn spline(part: Subpath<'_>) -> Spline<DVec2> {
    let degrees: Vec<usize> = part.degrees.iter().map(|&d| usize::from(d)).collect();
    let count = part.points.len() - usize::from(part.closed);
    Spline::from_parts(part.points[..count].to_vec(), &degrees, part.closed)
}
