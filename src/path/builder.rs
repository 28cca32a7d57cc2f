//! Building a path command by command.

use super::Path;
use super::arc::{Arc, arc};
use crate::curve::trace::PathSink;
use crate::geometry::check::check_points;
use crate::geometry::error::{Error, MAX_DEGREE};
use glam::DVec2;
use std::fmt;

/// Builds a [`Path`] from commands with absolute coordinates, like the path methods of a canvas.
///
/// `move_to` starts a subpath; a subpath without a segment is omitted. After `close`, a subpath that begins without
/// `move_to` starts at the start of the closed one. A path that does not begin with `move_to` starts at the origin.
/// Commands can be chained. Invalid arguments are reported by [`build`](Self::build), with the number of the command.
///
/// ```
/// use casteljau::{Path, glam::dvec2};
///
/// let path = Path::builder()
///     .move_to(dvec2(0.0, 0.0))
///     .line_to(dvec2(2.0, 0.0))
///     .quad_to(dvec2(2.0, 2.0), dvec2(0.0, 2.0))
///     .close()
///     .build()?;
/// assert_eq!(path.to_string(), "M0,0 L2,0 Q2,2 0,2 Z");
/// # Ok::<(), casteljau::Error>(())
/// ```
#[derive(Clone, Debug, Default)]
pub struct PathBuilder {
    path: Path,
    current: DVec2,
    /// The first point of the subpath.
    start: DVec2,
    /// Whether the subpath has a segment.
    has_segment: bool,
    /// Whether the last command was `close`.
    is_closed: bool,
    /// The largest distance of cubics from arcs; `None` for the default.
    arc_tolerance: Option<f64>,
    /// The number of commands.
    commands: usize,
    /// The first invalid argument.
    error: Option<BuildError>,
}

/// An invalid argument of a command of a [`PathBuilder`].
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct BuildError {
    /// The index of the command; the first one is 0.
    pub command: usize,
    /// What is wrong with it.
    pub error: Error,
}

impl fmt::Display for BuildError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "command {}: {}", self.command, self.error)
    }
}

impl std::error::Error for BuildError {
    fn source(&self) -> Option<&(dyn std::error::Error + 'static)> {
        Some(&self.error)
    }
}

impl From<BuildError> for Error {
    /// The error without the number of the command.
    fn from(error: BuildError) -> Self {
        error.error
    }
}

impl PathBuilder {
    /// A builder of an empty path.
    pub fn new() -> Self {
        Self::default()
    }

    /// Sets the largest distance of cubics from the arcs that follow, in the unit of the points. By default it is 10⁻⁵ of
    /// the larger radius of each arc.
    ///
    /// The smallest useful value is about 10⁻¹⁵ of the radius, which takes 414 cubics for a circle; 10⁻⁹ takes 33. No
    /// cubic covers more than a quarter turn. A value that is not above 0 is reported by [`build`](Self::build).
    pub fn arc_tolerance(&mut self, tolerance: f64) -> &mut Self {
        let error = || Error::Range {
            what: "tolerance",
            expected: "a number above 0",
            got: tolerance,
        };
        if self.check(tolerance > 0.0, error) {
            self.arc_tolerance = Some(tolerance);
        }
        self.counted()
    }

    /// The end of the last command, where the next one starts.
    pub fn current_point(&self) -> DVec2 {
        self.current
    }

    /// Starts a subpath at `p`.
    pub fn move_to(&mut self, p: DVec2) -> &mut Self {
        if self.accept("p", &[p]) {
            self.begin(p);
        }
        self.counted()
    }

    /// Adds a line to `p`.
    pub fn line_to(&mut self, p: DVec2) -> &mut Self {
        self.curve_to(&[p])
    }

    /// Adds a quadratic Bézier curve to `p` with the control point `p1`.
    pub fn quad_to(&mut self, p1: DVec2, p: DVec2) -> &mut Self {
        self.curve_to(&[p1, p])
    }

    /// Adds a cubic Bézier curve to `p` with the control points `p1` and `p2`.
    pub fn cubic_to(&mut self, p1: DVec2, p2: DVec2, p: DVec2) -> &mut Self {
        self.curve_to(&[p1, p2, p])
    }

    /// Adds a Bézier curve of any degree from 1 to 64, given by its control points after the current point.
    pub fn curve_to(&mut self, points: &[DVec2]) -> &mut Self {
        let error = || Error::Count {
            what: "points",
            expected: "1 to 64 points after the current one",
            got: points.len(),
        };
        let fits = (1..=MAX_DEGREE).contains(&points.len());
        if self.check(fits, error) && self.accept("points", points) {
            self.add_segment(points);
        }
        self.counted()
    }

    /// Adds an elliptical arc to `p`, like the command `A` of SVG path data.
    ///
    /// `x_rotation` is the angle from the x-axis to the first axis of the ellipse, in radians. `large` selects an arc
    /// of more than half the ellipse, `sweep` one of increasing angle. Radii that are too small are scaled up; with a
    /// radius of 0, or one that would exceed [`MAX_COORDINATE`](crate::MAX_COORDINATE), the arc is a line; if both
    /// ends are equal it is omitted. The arc is converted to as few cubics as possible within 10⁻⁵ of the larger radius
    /// (7 or 8 for a circle), or within [`arc_tolerance`](Self::arc_tolerance). Source: *SVG 2*, §B.2.
    pub fn arc_to(
        &mut self,
        radii: DVec2,
        x_rotation: f64,
        large: bool,
        sweep: bool,
        p: DVec2,
    ) -> &mut Self {
        let rotation = [DVec2::new(x_rotation, 0.0)];
        if self.accept("radii", &[radii])
            && self.accept("x_rotation", &rotation)
            && self.accept("p", &[p])
        {
            self.add_arc(&Arc {
                from: self.current,
                to: p,
                radii: radii.abs(),
                degrees: x_rotation.to_degrees(),
                large,
                sweep,
            });
        }
        self.counted()
    }

    /// Closes the subpath, with a line to its first point unless it ends there. A second consecutive `close` has no
    /// effect; a subpath without a segment becomes a closed line of length 0.
    pub fn close(&mut self) -> &mut Self {
        if !self.is_closed {
            self.end_closed();
        }
        self.counted()
    }

    /// Closes the subpath.
    pub(crate) fn end_closed(&mut self) {
        if !self.has_segment || self.current != self.start {
            self.add_segment(&[self.start]);
        }
        // −0 and 0 compare equal: store the bits of the first point at both ends.
        if let Some(last) = self.path.points.last_mut() {
            *last = self.start;
        }
        self.path.end_subpath(true);
        (self.current, self.has_segment, self.is_closed) = (self.start, false, true);
    }

    /// The path of all commands. The builder is empty afterwards and keeps its tolerance.
    ///
    /// # Errors
    /// The first invalid command: [`Error::NotFinite`] for a NaN or an infinity, [`Error::Item`] for a
    /// coordinate of an argument or of an arc beyond [`MAX_COORDINATE`](crate::MAX_COORDINATE), [`Error::Count`] for
    /// [`curve_to`](Self::curve_to) with no points or more than 64, [`Error::Range`] for a tolerance that is not above 0.
    pub fn build(&mut self) -> Result<Path, BuildError> {
        let empty = Self {
            arc_tolerance: self.arc_tolerance,
            ..Self::default()
        };
        let built = std::mem::replace(self, empty);
        match built.error {
            Some(error) => Err(error),
            None => Ok(built.finished()),
        }
    }

    /// The path of all valid commands.
    pub(crate) fn finished(mut self) -> Path {
        self.end_open();
        self.path
    }

    /// Adds a segment by its control points after the current point, which must be finite.
    pub(crate) fn add_segment(&mut self, points: &[DVec2]) {
        if !self.has_segment {
            self.path.points.push(self.current);
            self.has_segment = true;
        }
        self.path.points.extend_from_slice(points);
        self.path.ends.push(self.path.points.len() - 1);
        self.is_closed = false;
        self.current = points[points.len() - 1];
    }

    /// Adds an arc that starts at the current point. Returns false if it leaves the limit of coordinates; the builder
    /// keeps the error then.
    pub(crate) fn add_arc(&mut self, shape: &Arc) -> bool {
        let tolerance = self.arc_tolerance;
        let mut fits = true;
        let mut add = |points: &[DVec2]| {
            fits = fits && self.accept("points of the arc", points);
            if fits {
                self.add_segment(points);
            }
            fits
        };
        if shape.from != shape.to && !arc(shape, tolerance, 1, &mut add) {
            add(&[shape.to]);
        }
        self.is_closed = false;
        fits
    }

    /// Starts a subpath.
    pub(super) fn begin(&mut self, p: DVec2) {
        self.end_open();
        (self.current, self.start, self.is_closed) = (p, p, false);
    }

    /// Returns whether the points are valid; keeps the error otherwise.
    pub(super) fn accept(&mut self, what: &'static str, points: &[DVec2]) -> bool {
        let checked = check_points(what, points);
        checked.map_err(|error| self.keep(error)).is_ok()
    }

    /// Returns whether a condition holds; keeps the error otherwise.
    pub(super) fn check(&mut self, holds: bool, error: impl FnOnce() -> Error) -> bool {
        if !holds {
            self.keep(error());
        }
        holds
    }

    fn keep(&mut self, error: Error) {
        let command = self.commands;
        self.error.get_or_insert(BuildError { command, error });
    }

    /// Ends a command.
    pub(super) fn counted(&mut self) -> &mut Self {
        self.commands += 1;
        self
    }

    /// Ends a subpath that is not closed.
    fn end_open(&mut self) {
        if self.has_segment {
            self.path.end_subpath(false);
            self.has_segment = false;
        }
    }
}

impl PathSink for PathBuilder {
    fn move_to(&mut self, p: DVec2) {
        self.move_to(p);
    }
    fn line_to(&mut self, p: DVec2) {
        self.line_to(p);
    }
    fn quad_to(&mut self, p1: DVec2, p: DVec2) {
        self.quad_to(p1, p);
    }
    fn cubic_to(&mut self, p1: DVec2, p2: DVec2, p: DVec2) {
        self.cubic_to(p1, p2, p);
    }
    fn close(&mut self) {
        self.close();
    }
}
