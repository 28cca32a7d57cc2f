//! Output of a curve as path commands: lines, quadratics and cubics.

use super::Curve;
use crate::bernstein::polynomials::binomials;
use crate::geometry::check::check_tolerance;
use crate::geometry::error::Error;
use crate::geometry::point::Point;
use crate::numeric::float::ratio;
use glam::DVec2;

/// Receives path commands; for example an HTML canvas, a path builder or a plotter.
pub trait PathSink {
    /// Begins a subpath at `p`.
    fn move_to(&mut self, p: DVec2);
    /// Adds a line to `p`.
    fn line_to(&mut self, p: DVec2);
    /// Adds a quadratic Bézier curve to `p`.
    fn quad_to(&mut self, p1: DVec2, p: DVec2);
    /// Adds a cubic Bézier curve to `p`.
    fn cubic_to(&mut self, p1: DVec2, p2: DVec2, p: DVec2);
    /// Closes the subpath.
    fn close(&mut self);
}

impl Curve<DVec2> {
    /// Sends the curve to `sink`, beginning with a `move_to` its start.
    ///
    /// Degrees 1 to 3 are sent unchanged. Higher degrees become cubics with the same end tangents, whose distance from
    /// the curve is at most 10⁻⁴ of the diagonal of the control points' box.
    pub fn trace(&self, sink: &mut impl PathSink) {
        sink.move_to(self.start());
        self.trace_on(sink, None);
    }

    /// [`trace`](Self::trace) with the largest distance of cubics from a curve above degree 3, in the unit of the
    /// points.
    ///
    /// # Errors
    /// Same as [`flatten`](Self::flatten) for the tolerance.
    pub fn trace_within(&self, sink: &mut impl PathSink, tolerance: f64) -> Result<(), Error> {
        check_tolerance(tolerance, self.max_abs())?;
        sink.move_to(self.start());
        self.trace_on(sink, Some(tolerance));
        Ok(())
    }
}

impl<P: Point> Curve<P> {
    /// Continues from the current point with the projection of the curve along z.
    pub(crate) fn trace_on(&self, sink: &mut impl PathSink, tolerance: Option<f64>) {
        match *self.points {
            [_, p1] => sink.line_to(p1.to_2d()),
            [_, p1, p2] => sink.quad_to(p1.to_2d(), p2.to_2d()),
            [_, p1, p2, p3] => sink.cubic_to(p1.to_2d(), p2.to_2d(), p3.to_2d()),
            _ => {
                let default = || 1e-4 * self.control_bounds().diagonal();
                self.trace_cubics(sink, tolerance.unwrap_or_else(default), MAX_HALVINGS);
            }
        }
    }

    /// Halves the curve until a cubic is within the tolerance.
    fn trace_cubics(&self, sink: &mut impl PathSink, tolerance: f64, halvings: usize) {
        let cubic = self.cubic_of_same_tangents();
        if halvings == 0 || self.distance_of_controls(&cubic) <= tolerance {
            cubic.trace_on(sink, None);
            return;
        }
        let (left, right) = self.halve();
        left.trace_cubics(sink, tolerance, halvings - 1);
        right.trace_cubics(sink, tolerance, halvings - 1);
    }

    /// The cubic with the same end points and the same end derivatives.
    pub(crate) fn cubic_of_same_tangents(&self) -> Self {
        let n = self.degree();
        let reach = ratio(n, 3);
        let (start, end) = (self.start(), self.end());
        let (p1, p2) = (self.points[1], self.points[n - 1]);
        Self::from_slice(&[
            start,
            start + (p1 - start) * reach,
            end + (p2 - end) * reach,
            end,
        ])
    }

    /// A bound on the distance to a curve of a lower degree m: the maximum distance between control points after
    /// elevation to the same degree.
    ///
    /// The control points of `other` at degree n are Σᵢ C(m, i) C(n − m, k − i) / C(n, k) Qᵢ (Farin, *Curves and
    /// Surfaces for CAGD*, section 6.1, repeated).
    pub(crate) fn distance_of_controls(&self, other: &Self) -> f64 {
        let (n, m) = (self.degree(), other.degree());
        let [of_n, of_m, of_rest] = [n, m, n - m].map(binomials);
        let raised = |k: usize| {
            let range = k.saturating_sub(n - m)..=k.min(m);
            range.fold(P::default(), |sum, i| {
                sum + other.points[i] * (of_m[i] * of_rest[k - i] / of_n[k])
            })
        };
        let distances = self.points.iter().enumerate();
        distances
            .map(|(k, &p)| (p - raised(k)).norm())
            .fold(0.0, f64::max)
    }
}

/// The error of the cubic falls by a factor of 16 with each halving: 13 halvings exhaust the 52 bits of f64.
const MAX_HALVINGS: usize = 13;
