//! Building a path command by command.

use super::Path;
use super::arc::{Arc, arc};
use crate::curve::trace::PathSink;
use crate::geometry::check::check_points;
use crate::geometry::error::{Error, MAX_DEGREE};
use glam::DVec2;

/// Builds a [`Path`] from commands with absolute coordinates, like the path methods of a canvas.
///
/// `move_to` starts a subpath; a subpath without a segment is omitted. After `close`, a subpath that begins without
/// `move_to` starts at the start of the closed one. A path that does not begin with `move_to` starts at the origin.
/// Invalid arguments are reported by [`build`](Self::build).
///
/// ```
/// use casteljau::{glam::DVec2, path::PathBuilder};
///
/// let mut builder = PathBuilder::new();
/// builder.move_to(DVec2::ZERO);
/// builder.line_to(DVec2::new(2.0, 0.0));
/// builder.quad_to(DVec2::new(2.0, 2.0), DVec2::new(0.0, 2.0));
/// builder.close();
/// let path = builder.build()?;
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
    /// The error of the first invalid argument.
    error: Option<Error>,
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
    pub fn set_arc_tolerance(&mut self, tolerance: f64) {
        if tolerance > 0.0 {
            self.arc_tolerance = Some(tolerance);
        } else {
            self.error.get_or_insert(Error::Range {
                what: "tolerance",
                expected: "a number above 0",
                got: tolerance,
            });
        }
    }

    /// The end of the last command, where the next one starts.
    pub fn current_point(&self) -> DVec2 {
        self.current
    }

    /// Starts a subpath at `p`.
    pub fn move_to(&mut self, p: DVec2) {
        if !self.accept("p", &[p]) {
            return;
        }
        self.end_open();
        (self.current, self.start, self.is_closed) = (p, p, false);
    }

    /// Adds a line to `p`.
    pub fn line_to(&mut self, p: DVec2) {
        self.curve_to(&[p]);
    }

    /// Adds a quadratic Bézier curve to `p` with the control point `p1`.
    pub fn quad_to(&mut self, p1: DVec2, p: DVec2) {
        self.curve_to(&[p1, p]);
    }

    /// Adds a cubic Bézier curve to `p` with the control points `p1` and `p2`.
    pub fn cubic_to(&mut self, p1: DVec2, p2: DVec2, p: DVec2) {
        self.curve_to(&[p1, p2, p]);
    }

    /// Adds a Bézier curve of any degree from 1 to 64, given by its control points after the current point.
    pub fn curve_to(&mut self, points: &[DVec2]) {
        if !(1..=MAX_DEGREE).contains(&points.len()) {
            self.error.get_or_insert(Error::Count {
                what: "points",
                expected: "1 to 64 points after the current one",
                got: points.len(),
            });
        } else if self.accept("points", points) {
            self.add_segment(points);
        }
    }

    /// Adds an elliptical arc to `p`, like the command `A` of SVG path data.
    ///
    /// `x_rotation` is the angle from the x-axis to the first axis of the ellipse, in radians. `large` selects an arc
    /// of more than half the ellipse, `sweep` one of increasing angle. Radii that are too small are scaled up; with a
    /// radius of 0 the arc is a line; if both ends are equal it is omitted. The arc is converted to as few
    /// cubics as possible within 10⁻⁵ of the larger radius (7 or 8 for a circle), or within
    /// [`set_arc_tolerance`](Self::set_arc_tolerance). Source: *SVG 2*, §B.2.
    pub fn arc_to(&mut self, radii: DVec2, x_rotation: f64, large: bool, sweep: bool, p: DVec2) {
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
    }

    /// Closes the subpath, with a line to its first point unless it ends there. A second consecutive `close` has no
    /// effect; a subpath without a segment becomes a closed line of length 0.
    pub fn close(&mut self) {
        if self.is_closed {
            return;
        }
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

    /// The path of all commands.
    ///
    /// # Errors
    /// The error of the first invalid command: [`Error::NotFinite`] for a NaN or an infinity, [`Error::Item`] for a
    /// coordinate beyond [`MAX_COORDINATE`](crate::MAX_COORDINATE), [`Error::Count`] for
    /// [`curve_to`](Self::curve_to) with no points or more than 64, [`Error::Range`] for a tolerance that is not above 0.
    pub fn build(self) -> Result<Path, Error> {
        match self.error {
            Some(error) => Err(error),
            None => Ok(self.finished()),
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
        let degree = points.len().try_into().unwrap_or(u8::MAX); // at most 64
        self.path.degrees.push(degree);
        self.is_closed = false;
        self.current = points[points.len() - 1];
    }

    /// Adds an arc that starts at the current point.
    pub(crate) fn add_arc(&mut self, shape: &Arc) {
        let tolerance = self.arc_tolerance;
        if shape.from != shape.to && !arc(shape, tolerance, |points| self.add_segment(points)) {
            self.add_segment(&[shape.to]);
        }
        self.is_closed = false;
    }

    fn accept(&mut self, what: &'static str, points: &[DVec2]) -> bool {
        match check_points(what, points) {
            Ok(()) => true,
            Err(error) => {
                self.error.get_or_insert(error);
                false
            }
        }
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
