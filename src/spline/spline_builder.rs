//! Plane splines under construction.

use super::Spline;
use glam::DVec2;

/// A spline under construction: its points, and the degree of each segment.
#[derive(Default)]
pub(crate) struct SplineBuilder {
    pub(crate) points: Vec<DVec2>,
    pub(crate) degrees: Vec<usize>,
    pub(crate) closed: bool,
}

impl SplineBuilder {
    pub(crate) fn spline(self) -> Spline<DVec2> {
        Spline::from_parts(self.points, &self.degrees, self.closed)
    }

    /// Adds the start point if the spline is empty.
    pub(crate) fn start(&mut self, p: DVec2) {
        if self.points.is_empty() {
            self.points.push(p);
        }
    }

    pub(crate) fn line_to(&mut self, p: DVec2) {
        self.points.push(p);
        self.degrees.push(1);
    }
}

#[cfg(feature = "regions")]
impl SplineBuilder {
    /// Adds a line unless it has no length.
    pub(crate) fn connect_to(&mut self, p: DVec2) {
        if self.points.last() != Some(&p) {
            self.line_to(p);
        }
    }

    /// Adds a cubic.
    pub(crate) fn cubic_to(&mut self, points: [DVec2; 3]) {
        self.points.extend(points);
        self.degrees.push(3);
    }
}
