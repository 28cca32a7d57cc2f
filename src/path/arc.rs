//! Elliptical arcs as cubic Bézier curves.

use crate::geometry::check::MAX_COORDINATE;
use crate::numeric::float::as_f64;
use casteljau_kernels::numeric::trigonometry::{
    angle, rotated, unit_vector, unit_vector_of_degrees,
};
use glam::DVec2;
use std::f64::consts::{FRAC_PI_8, TAU};

/// The maximum angle of one cubic in radians, for the default tolerance: a distance of 10⁻⁵ of the larger radius.
pub(crate) const MAX_PIECE_ANGLE: f64 = 0.9059;

/// The bisections that divide the interval of angles down to its rounding.
const BISECTIONS: usize = 50;

/// More than the relative rounding of an angle, and far too small to matter for the distance.
const QUARTER_TURN_ROUNDING: f64 = 1e-13;

/// Both end points are rounded by up to half an ulp, and so is each operation from them to the half chord.
const ROUNDING: f64 = 2.0 * f64::EPSILON;

/// An arc in the SVG endpoint parametrisation; the end points differ.
#[derive(Clone, Copy)]
pub(crate) struct Arc {
    pub(crate) from: DVec2,
    pub(crate) to: DVec2,
    /// Nonnegative.
    pub(crate) radii: DVec2,
    /// The angle from the x-axis to the first axis of the ellipse.
    pub(crate) degrees: f64,
    pub(crate) large: bool,
    pub(crate) sweep: bool,
}

/// Calls `cubic` with the control points after the first of each cubic. Returns false without a call if the arc is a
/// line: a radius is 0, or one of the radii, scaled up where they are too small, is beyond the limit of coordinates.
/// Points of the arc may be beyond the limit. The cubics are within `tolerance` of the arc, by
/// default 10⁻⁵ of the larger radius, and they are at least `min_pieces`. Where `cubic` returns false, no more cubics are
/// made.
///
/// Points are computed relative to the start, so that a short arc of a very large ellipse keeps its precision: the
/// chord of an angle 2β is 2 sin β long, in the direction at β.
pub(crate) fn arc(
    shape: &Arc,
    tolerance: Option<f64>,
    min_pieces: usize,
    mut cubic: impl FnMut(&[DVec2]) -> bool,
) -> bool {
    let Some(ellipse) = Ellipse::of(shape) else {
        return false;
    };
    let theta = ellipse.theta;
    let max_angle = tolerance.map_or(MAX_PIECE_ANGLE, |tolerance| {
        max_piece_angle(tolerance / ellipse.radii.max_element())
    });
    let pieces = (theta / max_angle).ceil().max(as_f64(min_pieces));
    let half_step = unit_vector(theta / (2.0 * pieces));
    let sign = if shape.sweep { 1.0 } else { -1.0 };
    let step = DVec2::new(half_step.x, sign * half_step.y);
    let reach = 4.0 / 3.0 * step.y / (1.0 + step.x);
    // The end of the current cubic is at the angle 2β.
    let mut beta = DVec2::X;
    let mut point = shape.from;
    let mut handle = ellipse.normal_at(rotated(beta, beta)) * reach;
    let mut left = pieces;
    while left > 0.0 {
        left -= 1.0;
        beta = rotated(beta, step);
        let next = if left == 0.0 {
            shape.to
        } else {
            shape.from + ellipse.chord(beta)
        };
        let next_handle = ellipse.normal_at(rotated(beta, beta)) * reach;
        if !cubic(&[point + handle, next - next_handle, next]) {
            break;
        }
        (point, handle) = (next, next_handle);
    }
    true
}

/// The maximum angle of one cubic in radians, at most a quarter turn, for a distance of at most `tolerance`, a part of
/// the larger radius.
///
/// A cubic with the ends, the tangents and the midpoint of an arc of angle θ deviates by at most 2/27 sin⁶(θ/4) /
/// cos²(θ/4) of the radius. Source: Goldapp, "Approximation of circular arcs by cubic polynomials", CAGD 8 (1991).
fn max_piece_angle(tolerance: f64) -> f64 {
    let bound = 13.5 * tolerance.max(f64::EPSILON);
    let (mut low, mut high) = (0.0, FRAC_PI_8);
    for _ in 0..BISECTIONS {
        let middle = (low + high) / 2.0;
        let DVec2 { x: cos, y: sin } = unit_vector(middle);
        let square = sin * sin;
        if square * square * square <= bound * cos * cos {
            low = middle;
        } else {
            high = middle;
        }
    }
    // Rounding must not divide a quarter turn, whose angle is computed, into two.
    4.0 * low * (1.0 + QUARTER_TURN_ROUNDING)
}

/// The ellipse of an arc, as the image of the unit circle under an affine map.
struct Ellipse {
    radii: DVec2,
    axis: DVec2,
    /// The start of the arc on the unit circle.
    start: DVec2,
    /// The angle of the arc on the unit circle.
    theta: f64,
}

impl Ellipse {
    /// Half the chord on the unit circle is d; the centre lies at ±√(1 − d²) perpendicular to it.
    fn of(shape: &Arc) -> Option<Self> {
        let axis = unit_vector_of_degrees(shape.degrees);
        let inverse_axis = DVec2::new(axis.x, -axis.y);
        let half = rotated((shape.from - shape.to) * 0.5, inverse_axis);
        let mut radii = shape.radii;
        let mut d = half / radii;
        let scale = d.x.abs().max(d.y.abs());
        let part = d / scale;
        let part_length = (part.x * part.x + part.y * part.y).sqrt();
        let mut length = scale * part_length;
        if !(radii.x > 0.0 && radii.y > 0.0 && length > 0.0 && length < f64::INFINITY) {
            return None;
        }
        let largest = shape.from.abs().max(shape.to.abs()).max_element();
        let noise = ROUNDING * (1.0 + largest / radii.min_element());
        let mut height = 0.0;
        if length >= 1.0 - noise {
            radii *= length;
            d /= length;
            length = 1.0;
        } else {
            height = ((1.0 - length) * (1.0 + length)).sqrt();
        }
        if radii.max_element() > MAX_COORDINATE {
            return None;
        }
        let across = DVec2::new(part.y, -part.x) * (height / part_length);
        let left = shape.large == shape.sweep;
        let small = 2.0 * angle(DVec2::new(height, length));
        Some(Self {
            radii,
            axis,
            start: if left { d + across } else { d - across },
            theta: if shape.large { TAU - small } else { small },
        })
    }

    /// Maps a vector from the unit circle to the plane.
    fn to_plane(&self, v: DVec2) -> DVec2 {
        rotated(v * self.radii, self.axis)
    }

    /// The image of the unit-circle radius at an angle from the start, turned by +90°.
    fn normal_at(&self, angle: DVec2) -> DVec2 {
        let end = rotated(self.start, angle);
        self.to_plane(DVec2::new(-end.y, end.x))
    }

    /// The chord from the start to the angle 2β.
    fn chord(&self, beta: DVec2) -> DVec2 {
        let middle = rotated(self.start, beta);
        self.to_plane(DVec2::new(-middle.y, middle.x) * (2.0 * beta.y))
    }
}
