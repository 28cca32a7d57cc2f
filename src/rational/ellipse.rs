//! Conics as arcs of ellipses.

use super::RationalCurve;
use crate::geometry::point::Point;
use casteljau_kernels::numeric::trigonometry::{angle, cos_sin};
use glam::DVec2;
use std::f64::consts::PI;

/// Conjugate radii that are equal and perpendicular up to this part of their squares are those of a circle.
const CIRCLE: f64 = 16.0 * f64::EPSILON;

/// An arc of an ellipse: the points `center` + cos(θ) a + sin(θ) b, where a is the vector of length `radii.x` in the direction
/// `rotation` and b the vector of length `radii.y` at +90° from it.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(rename_all = "camelCase")
)]
pub struct EllipticalArc {
    /// The center of the ellipse.
    pub center: DVec2,
    /// Its radii, along its own axes.
    pub radii: DVec2,
    /// The angle from the x-axis to its first axis, in radians.
    pub rotation: f64,
    /// The angle θ of the start, in radians.
    pub start_angle: f64,
    /// The angle from the start to the end; negative if the arc runs clockwise (x right, y up).
    pub sweep_angle: f64,
}

impl RationalCurve<DVec2> {
    /// The arc of an ellipse or of a circle that the curve is; `None` unless it has degree 2, its points are not on a line, and
    /// w₁² < w₀w₂.
    ///
    /// In standard form, with the weights 1, w, 1, the curve is the image under an affine map of an arc of the unit circle from −α to
    /// α, where cos α = w: the center is P₁ + (M − P₁)/(1 − w²), where M is the middle of the ends, and the images of the
    /// axes are w(P₁ − C) and (P₂ − P₀)/(2 sin α). Its sweep is 2α, below half a turn.
    ///
    /// Source: Farin, *Curves and Surfaces for CAGD*, §12.6.
    pub fn to_elliptical_arc(&self) -> Option<EllipticalArc> {
        let ([p0, p1, p2], [w0, w1, w2]) = (&self.points[..], &self.weights[..]) else {
            return None;
        };
        let w = w1 / (w0 * w2).sqrt();
        // (1 − w)(1 + w) without cancellation where the curve is almost a parabola.
        let sin_squared = (w0 * w2 - w1 * w1) / (w0 * w2);
        if !(sin_squared > 0.0 && (*p1 - *p0).perp_dot(*p2 - *p0) != 0.0) {
            return None;
        }
        let sin = sin_squared.sqrt();
        let middle = (*p0 + *p2) * 0.5;
        let center = *p1 + (middle - *p1) / sin_squared;
        let (e, f) = ((*p1 - center) * w, (*p2 - *p0) * (0.5 / sin));
        let half = angle(DVec2::new(w, sin));
        // Rotating both by φ makes them perpendicular where tan 2φ = 2 e·f/(|e|² − |f|²).
        let (across, along) = (2.0 * e.dot(f), e.dot(e) - f.dot(f));
        let size = e.dot(e) + f.dot(f);
        let is_circle = across.abs().max(along.abs()) <= CIRCLE * size;
        let turn = if is_circle {
            // Every direction is an axis of a circle: θ is counted from the x-axis.
            let from_x = signed_angle(e);
            if e.perp_dot(f) < 0.0 { from_x } else { -from_x }
        } else {
            0.5 * signed_angle(DVec2::new(along, across))
        };
        let (cos, sin) = cos_sin(turn);
        let (a, b) = (e * cos + f * sin, f * cos - e * sin);
        // The second axis is at +90° from the first one; otherwise θ runs the other way.
        let direction = if a.perp_dot(b) < 0.0 { -1.0 } else { 1.0 };
        Some(EllipticalArc {
            center,
            radii: DVec2::new(Point::norm(a), Point::norm(b)),
            rotation: if is_circle { 0.0 } else { signed_angle(a) },
            start_angle: direction * (-half - turn),
            sweep_angle: direction * 2.0 * half,
        })
    }
}

/// The angle of a vector from the x-axis, from −π to π.
fn signed_angle(v: DVec2) -> f64 {
    let unit = Point::unit(v);
    if unit.x >= 0.0 {
        angle(unit)
    } else {
        PI.copysign(unit.y) - angle(DVec2::new(-unit.x, unit.y))
    }
}
