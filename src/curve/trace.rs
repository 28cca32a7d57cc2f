//! Output of a curve as path commands: lines, quadratics and cubics.

use super::Curve;
use crate::bernstein::polynomials::binomials;
use crate::geometry::check::check_tolerance;
use crate::geometry::error::Error;
use crate::geometry::point::Point;
use crate::numeric::float::{ratio, ulp};
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
    /// Degrees 1 to 3 are sent unchanged. A higher degree n becomes cubics with the same end tangents, whose distance from
    /// the curve is at most 10⁻⁴ of the diagonal of the control points' box, or n² ulps of the largest coordinate if that
    /// is more, which rounding hides.
    pub fn trace(&self, sink: &mut (impl PathSink + ?Sized)) {
        sink.move_to(self.start());
        self.trace_on(sink, None);
    }

    /// [`trace`](Self::trace) with the largest distance of cubics from a curve above degree 3, in the unit of the
    /// points.
    ///
    /// # Errors
    /// Same as [`flatten`](Self::flatten) for the tolerance.
    pub fn trace_within(
        &self,
        sink: &mut (impl PathSink + ?Sized),
        tolerance: f64,
    ) -> Result<(), Error> {
        check_tolerance(tolerance, self.max_abs())?;
        sink.move_to(self.start());
        self.trace_on(sink, Some(tolerance));
        Ok(())
    }
}

impl<P: Point> Curve<P> {
    /// Continues from the current point with the projection of the curve along z.
    pub(crate) fn trace_on(&self, sink: &mut (impl PathSink + ?Sized), tolerance: Option<f64>) {
        match *self.points {
            [_, p1] => sink.line_to(p1.to_2d()),
            [_, p1, p2] => sink.quad_to(p1.to_2d(), p2.to_2d()),
            [_, p1, p2, p3] => sink.cubic_to(p1.to_2d(), p2.to_2d(), p3.to_2d()),
            _ => {
                let default = || 1e-4 * self.control_bounds().diagonal();
                let mut draw = |cubic: &Self| cubic.trace_on(sink, None);
                self.for_each_cubic(tolerance.unwrap_or_else(default), &mut draw);
            }
        }
    }

    /// Calls `emit` with the curve if its degree is at most 3, and otherwise with cubics in its place, of which each has the
    /// ends and the end tangents of its part of the curve, within a tolerance or what rounding hides.
    pub(crate) fn for_each_cubic(&self, tolerance: f64, emit: &mut impl FnMut(&Self)) {
        if self.degree() <= 3 {
            return emit(self);
        }
        let hidden = hidden_by_rounding(self.degree(), self.max_abs());
        self.halve_to_cubics(tolerance.max(hidden), CUBIC_HALVINGS, emit);
    }

    fn halve_to_cubics(&self, tolerance: f64, halvings: usize, emit: &mut impl FnMut(&Self)) {
        let cubic = self.cubic_of_same_tangents();
        if halvings == 0 || self.control_point_distance(&cubic) <= tolerance {
            return emit(&cubic);
        }
        let (left, right) = self.halve();
        left.halve_to_cubics(tolerance, halvings - 1, emit);
        right.halve_to_cubics(tolerance, halvings - 1, emit);
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
    pub(crate) fn control_point_distance(&self, other: &Self) -> f64 {
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

/// The distance of a cubic from a curve of degree n that rounding hides: halving leaves errors of some ulps in the control
/// points, which n/3 multiplies for the handles of the cubic.
pub(crate) fn hidden_by_rounding(degree: usize, largest: f64) -> f64 {
    (degree * degree) as f64 * ulp(largest)
}

/// The error of the cubic is at most n⁴/4! times the largest coordinate, and falls by a factor of 16 with each halving: to
/// n² ulps by 13 halvings for the 53 bits of f64 and 3 for n = 64, and 4 as a reserve for rounding.
pub(crate) const CUBIC_HALVINGS: usize = f64::MANTISSA_DIGITS as usize / 4 + 3 + 4;
