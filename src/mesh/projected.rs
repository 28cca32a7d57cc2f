//! Drawing of space curves under a projection.
//!
//! A projection maps the control points Pᵢ to (Xᵢ, Yᵢ, Wᵢ), and the curve to the rational curve (ΣBᵢXᵢ, ΣBᵢYᵢ) / ΣBᵢWᵢ.
//! Canvases draw cubics, so the curve is halved until the cubic with the same ends and end tangents is close enough.

use super::mesh_patch::SpaceCurve;
use crate::curve::Curve;
use crate::curve::trace::{CUBIC_HALVINGS, PathSink, hidden_by_rounding};
use crate::geometry::point::Point;
use crate::numeric::list::{Points, Scalars};
use crate::rational::spline::{cubic_of_same_tangents, error_bound};
use glam::{DMat4, DVec3, DVec4};

/// The smallest depth that is drawn, as a fraction of the largest depth.
const NEAR_RATIO: f64 = 1e-3;

/// A projection to a canvas.
pub(crate) struct Projection {
    matrix: DMat4,
    /// The smallest W that is drawn; above 0.
    near: f64,
    tolerance: f64,
}

/// A sink, and whether its current point is the end of the previous piece.
struct ProjectedSubpath<'a, T: ?Sized> {
    sink: &'a mut T,
    down: bool,
}

impl Projection {
    pub(crate) fn new(matrix: &DMat4, vertices: &[DVec3], tolerance: f64) -> Self {
        let far = vertices
            .iter()
            .map(|&p| homogeneous(matrix, p).z)
            .fold(0.0, f64::max);
        Self {
            matrix: *matrix,
            near: (far * NEAR_RATIO).max(f64::MIN_POSITIVE),
            tolerance,
        }
    }

    /// Draws the part of a curve that lies in front of the eye.
    pub(crate) fn draw(&self, curve: &impl SpaceCurve, sink: &mut (impl PathSink + ?Sized)) {
        let points = curve.weighted_points();
        let image = points
            .map(|(p, weight)| homogeneous(&self.matrix, p) * weight)
            .collect();
        let mut stroke = ProjectedSubpath { sink, down: false };
        self.draw_piece(&Curve::from_points(image), &mut stroke, CUBIC_HALVINGS);
    }

    /// Draws a piece of a curve (X, Y, W), or its halves.
    fn draw_piece(
        &self,
        piece: &Curve<DVec3>,
        stroke: &mut ProjectedSubpath<impl PathSink + ?Sized>,
        halvings: usize,
    ) {
        let before_eye = |p: &DVec3| p.z >= self.near;
        let all = piece.control_points().iter().all(before_eye);
        if all && let Some(cubic) = self.flat_curve(piece, halvings == 0) {
            stroke.draw(&cubic, self.tolerance);
            return;
        }
        let any = piece.control_points().iter().any(before_eye);
        if halvings == 0 || !any {
            stroke.down = false;
            return;
        }
        let (left, right) = piece.halve();
        self.draw_piece(&left, stroke, halvings - 1);
        self.draw_piece(&right, stroke, halvings - 1);
    }

    /// The polynomial curve for a piece in front of the eye; `None` if it is not close enough, unless `must` is set.
    fn flat_curve(&self, piece: &Curve<DVec3>, must: bool) -> Option<Curve<DVec3>> {
        let points = piece.control_points().iter();
        let (flat, weights): (Points<DVec3>, Scalars) =
            points.map(|&p| ((p / p.z).with_z(0.0), p.z)).unzip();
        if flat.len() == 2 || weights.iter().all(|&w| w == weights[0]) {
            return Some(Curve::from_points(flat));
        }
        let cubic = cubic_of_same_tangents(&flat, &weights);
        let largest = flat.iter().map(|p| Point::max_abs(*p)).fold(0.0, f64::max);
        let tolerance = self
            .tolerance
            .max(hidden_by_rounding(flat.len() - 1, largest));
        (must || error_bound(&flat, &weights, &cubic) <= tolerance)
            .then(|| Curve::from_slice(&cubic))
    }
}

impl<T: PathSink + ?Sized> ProjectedSubpath<'_, T> {
    /// Draws a curve, joined to the previous one if that was drawn; nothing if coordinates overflow.
    fn draw(&mut self, flat: &Curve<DVec3>, tolerance: f64) {
        if !flat.max_abs().is_finite() {
            self.down = false;
            return;
        }
        if !self.down {
            self.sink.move_to(flat.start().to_2d());
        }
        flat.trace_on(self.sink, Some(tolerance));
        self.down = true;
    }
}

/// The homogeneous coordinates (X, Y, W).
fn homogeneous(matrix: &DMat4, p: DVec3) -> DVec3 {
    let DVec4 { x, y, w, .. } = *matrix * p.extend(1.0);
    DVec3::new(x, y, w)
}
