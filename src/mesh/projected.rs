//! Drawing of space curves under a projection.
//!
//! A projection maps the control points Pᵢ to (Xᵢ, Yᵢ, Wᵢ), and the curve to the rational curve (ΣBᵢXᵢ, ΣBᵢYᵢ) / ΣBᵢWᵢ.
//! Canvases draw cubics, so the curve is halved until the cubic with the same ends and end tangents is close enough.
//! With the numerator N, the denominator W and the cubic C, the error is (N − C·W) / W. Its numerator is a polynomial,
//! so the largest of its Bernstein coefficients divided by the smallest Wᵢ is a bound. The error falls to 1/16 with
//! each halving.

use crate::bernstein::polynomials::binomials;
use crate::curve::Curve;
use crate::curve::trace::{CUBIC_HALVINGS, PathSink, hidden_by_rounding};
use crate::geometry::point::Point;
use crate::numeric::float::ratio;
use crate::numeric::list::Points;
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
    pub(crate) fn draw(&self, curve: &Curve<DVec3>, sink: &mut (impl PathSink + ?Sized)) {
        let points = curve.control_points().iter();
        let image = points.map(|&p| homogeneous(&self.matrix, p)).collect();
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
        let points = piece.control_points();
        let flat: Points<DVec3> = points.iter().map(|&p| (p / p.z).with_z(1.0)).collect();
        let weight = points[0].z;
        if points.len() == 2 || points.iter().all(|p| p.z == weight) {
            return Some(Curve::from_points(flat));
        }
        let cubic = cubic_of_same_tangents(points, &flat);
        let largest = flat.iter().map(|p| p.max_abs()).fold(0.0, f64::max);
        let tolerance = self
            .tolerance
            .max(hidden_by_rounding(points.len() - 1, largest));
        (must || error_bound(points, &cubic) <= tolerance).then(|| Curve::from_slice(&cubic))
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

/// The cubic with the ends and end derivatives of the rational curve: the first is n·W₁/W₀·(p₁ − p₀), the last its
/// mirror image.
fn cubic_of_same_tangents(points: &[DVec3], flat: &[DVec3]) -> [DVec3; 4] {
    let n = points.len() - 1;
    let reach = |end: usize, inner: usize| {
        flat[end] + (flat[inner] - flat[end]) * (ratio(n, 3) * points[inner].z / points[end].z)
    };
    [flat[0], reach(0, 1), reach(n, n - 1), flat[n]]
}

/// A bound on the distance of the rational curve (X, Y, W) from a cubic, in pixels: the largest coefficient of N − C·W,
/// divided by the smallest W.
fn error_bound(points: &[DVec3], cubic: &[DVec3; 4]) -> f64 {
    let (n, shares) = (points.len() - 1, [1.0, 3.0, 3.0, 1.0]);
    let (of_points, of_product) = (binomials(n), binomials(n + 3));
    let mut largest: f64 = 0.0;
    for k in 0..=n + 3 {
        let mut sum = DVec3::ZERO;
        for i in k.saturating_sub(n)..=k.min(3) {
            let p = points[k - i];
            sum += (p - cubic[i] * p.z) * (shares[i] * of_points[k - i]);
        }
        largest = largest.max(Point::norm(sum.with_z(0.0)) / of_product[k]);
    }
    let min = points.iter().map(|p| p.z).fold(f64::INFINITY, f64::min);
    largest / min
}
