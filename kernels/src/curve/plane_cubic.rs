//! One cubic in the plane.

use glam::DVec2;

/// The point and the derivative of a cubic.
#[inline]
pub fn point_and_derivative(p: &[DVec2; 4], t: f64) -> (DVec2, DVec2) {
    let r = 1.0 - t;
    let (a, b, c) = (
        p[0] * r + p[1] * t,
        p[1] * r + p[2] * t,
        p[2] * r + p[3] * t,
    );
    let (d, e) = (a * r + b * t, b * r + c * t);
    (d * r + e * t, (e - d) * 3.0)
}
