//! Splines: Bézier curves joined end to end.
//!
//! Segment k covers t from k to k + 1 and has its own degree; two segments meet at a joint. The control points are one
//! list: neighbouring segments share the point of their joint, and a closed spline ends at the first point of the list.
//!
//! In the kernels, where a fit spends its time: one cubic along a run of points.

mod area;
pub(crate) mod bspline;
mod build;
mod continuity;
mod convert;
mod coordinates;
#[cfg(feature = "fit")]
mod corners;
#[cfg(feature = "fit")]
pub(crate) mod cubics;
mod derivative;
mod edit;
#[cfg(feature = "fit")]
pub(crate) mod fit;
mod frames;
#[cfg(feature = "fit")]
mod grid;
mod interpolate;
mod intersect;
pub(crate) mod joint;
pub(crate) mod knots;
mod length;
#[cfg(feature = "fit")]
mod local_fit;
mod measure;
mod nearest;
pub(crate) mod offset;
#[cfg(feature = "fit")]
mod polyline;
mod repair;
#[cfg(feature = "fit")]
mod simplify;
#[cfg(feature = "fit")]
mod smoothing;
pub(crate) mod spline_builder;
pub(crate) mod spline_set;
mod split;

pub use bspline::BSpline;
pub use continuity::Continuity;
#[cfg(feature = "fit")]
pub use cubics::FitEffort;
#[cfg(feature = "fit")]
pub use fit::FitOptions;
pub use interpolate::Interpolation;
pub use joint::JointMode;
pub use offset::Join;
#[cfg(feature = "fit")]
pub use simplify::SimplifyOptions;

use crate::curve::Curve;
use crate::geometry::check::{check_points, images, max_abs};
use crate::geometry::error::{Error, MAX_DEGREE};
use crate::geometry::point::Point;
use std::borrow::Cow;

/// A sequence of joined Bézier curves, open or closed.
///
/// ```
/// use casteljau::{Spline, glam::DVec2};
///
/// let points = [(0, 0), (0, 2), (2, 2), (2, 0), (2, -2), (4, -2), (4, 0)].map(|(x, y)| DVec2::new(x.into(), y.into()));
/// let spline = Spline::new(&points, 3, false)?;
/// assert_eq!(spline.segment_count(), 2);
/// assert_eq!(spline.eval(1.0), points[3]);
/// assert!(spline.continuity(1)?.c1);
/// # Ok::<(), casteljau::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
#[must_use = "methods return new values"]
pub struct Spline<P: Point> {
    points: Vec<P>,
    /// The index of the first control point of each segment, and the index at which the next segment would start.
    starts: Vec<usize>,
    closed: bool,
}

impl<P: Point> Spline<P> {
    /// A spline whose segments all have the same degree.
    ///
    /// An open spline of n segments takes n · degree + 1 points, a closed one n · degree.
    ///
    /// # Errors
    /// [`Error::Range`] for a degree of 0 or above 64, [`Error::Count`] for a number of points that does not match,
    /// [`Error::NotFinite`] for a NaN or an infinity, [`Error::Item`] for a coordinate
    /// beyond [`MAX_COORDINATE`](crate::MAX_COORDINATE).
    pub fn new(points: &[P], degree: usize, closed: bool) -> Result<Self, Error> {
        if !(1..=MAX_DEGREE).contains(&degree) {
            return Err(Error::Range {
                what: "degree",
                expected: "1 to 64",
                got: degree as f64,
            });
        }
        let open_end = usize::from(!closed);
        if points.len() < degree + open_end || !(points.len() - open_end).is_multiple_of(degree) {
            let expected = if closed {
                "n · degree points (closed)"
            } else {
                "n · degree + 1 points (open)"
            };
            return Err(Error::Count {
                what: "points",
                expected,
                got: points.len(),
            });
        }
        let segments = (points.len() - open_end) / degree;
        Self::with_degrees(points.to_vec(), &vec![degree; segments], closed)
    }

    /// A spline from all its control points and the degree of each segment.
    ///
    /// # Errors
    /// As [`new`](Self::new).
    pub fn with_degrees(points: Vec<P>, degrees: &[usize], closed: bool) -> Result<Self, Error> {
        if let Some(&bad) = degrees.iter().find(|&&d| !(1..=MAX_DEGREE).contains(&d)) {
            return Err(Error::Range {
                what: "degrees",
                expected: "1 to 64",
                got: bad as f64,
            });
        }
        let needed = degrees.iter().sum::<usize>() + usize::from(!closed);
        if degrees.is_empty() || points.len() != needed {
            let expected = "the sum of the degrees (and one more for an open spline)";
            return Err(Error::Count {
                what: "points",
                expected,
                got: points.len(),
            });
        }
        check_points("points", &points)?;
        Ok(Self::from_parts(points, degrees, closed))
    }

    /// A spline from parts that are known to be valid.
    pub(crate) fn from_parts(points: Vec<P>, degrees: &[usize], closed: bool) -> Self {
        let mut starts = Vec::with_capacity(degrees.len() + 1);
        starts.push(0);
        starts.extend(degrees.iter().scan(0, |start, degree| {
            *start += degree;
            Some(*start)
        }));
        Self {
            points,
            starts,
            closed,
        }
    }

    /// All control points, each joint once.
    pub fn control_points(&self) -> &[P] {
        &self.points
    }

    /// Whether the spline is closed: its end is its start.
    pub fn is_closed(&self) -> bool {
        self.closed
    }

    /// The number of segments, which is also the t of the end.
    pub fn segment_count(&self) -> usize {
        self.starts.len() - 1
    }

    /// The degree of each segment.
    pub fn degrees(&self) -> Vec<usize> {
        self.starts
            .windows(2)
            .map(|pair| pair[1] - pair[0])
            .collect()
    }

    /// Segment k as a curve; `None` past the last one.
    pub fn segment(&self, k: usize) -> Option<Curve<P>> {
        (k < self.segment_count()).then(|| self.curve(k))
    }

    /// The segments as curves, from the first to the last.
    ///
    /// Curves up to degree 3 need no allocation.
    ///
    /// ```
    /// use casteljau::{Spline, glam::DVec2};
    ///
    /// let points = [(0.0, 0.0), (3.0, 4.0), (3.0, 5.0)].map(DVec2::from);
    /// let spline = Spline::new(&points, 1, false)?;
    /// let longest = spline.segments().map(|line| line.end().distance(line.start())).fold(0.0, f64::max);
    /// assert_eq!(longest, 5.0);
    /// # Ok::<(), casteljau::Error>(())
    /// ```
    pub fn segments(
        &self,
    ) -> impl ExactSizeIterator<Item = Curve<P>> + DoubleEndedIterator + Clone + '_ {
        (0..self.segment_count()).map(|k| self.curve(k))
    }

    /// Segment k, which must exist.
    pub(crate) fn curve(&self, k: usize) -> Curve<P> {
        Curve::from_slice(&self.segment_points(k))
    }

    /// The control points of segment k, which must exist.
    pub(crate) fn segment_points(&self, k: usize) -> Cow<'_, [P]> {
        let (from, to) = (self.starts[k], self.starts[k + 1]);
        self.points.get(from..=to).map_or_else(
            // The last segment of a closed spline ends at the first point.
            || Cow::Owned([&self.points[from..], &self.points[..1]].concat()),
            Cow::Borrowed,
        )
    }

    /// Whether both splines have the same structure and every control point lies within `tolerance` of its counterpart.
    pub fn approx_eq(&self, other: &Self, tolerance: f64) -> bool {
        let near = |(&a, &b): (&P, &P)| a == b || (a - b).norm() <= tolerance;
        self.closed == other.closed
            && self.starts == other.starts
            && self.points.iter().zip(&other.points).all(near)
    }

    /// The same spline with reversed direction.
    pub fn reverse(&self) -> Self {
        let degrees: Vec<usize> = self.degrees().into_iter().rev().collect();
        let mut points: Vec<P> = self.points.iter().rev().copied().collect();
        if self.closed {
            // Keep the first point first.
            points.rotate_right(1);
        }
        Self::from_parts(points, &degrees, self.closed)
    }

    /// The image under an affine map.
    ///
    /// # Errors
    /// [`Error::NotFinite`] and [`Error::Item`] for an image that is not finite or exceeds
    /// [`MAX_COORDINATE`](crate::MAX_COORDINATE).
    pub fn transform(&self, map: &P::Affine) -> Result<Self, Error> {
        let points = images(&self.points, map)?;
        Ok(Self {
            points,
            ..self.clone()
        })
    }

    /// The largest absolute coordinate.
    pub(crate) fn max_abs(&self) -> f64 {
        max_abs(&self.points)
    }
}
