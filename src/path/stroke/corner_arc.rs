//! The arc that replaces a corner.

use super::tangent_circle::{Corner, MIN_RADIUS, RADIUS, Side};
use crate::curve::Curve;
use crate::curve::with_derivatives::CurveWithDerivatives;
use crate::geometry::check::max_abs;
use crate::numeric::float::unit_scale;
use crate::spline::offset::start_tangent;
use glam::DVec2;

/// A joint is a corner if the sine of its turn is larger. This holds for turns of 0.06° to 179.94°.
const MIN_CORNER_SINE: f64 = 1e-3;

/// Larger radii, as a multiple of the size, are limited by the segments.
const MAX_RADIUS: f64 = 1e9;

/// An arc that replaces a corner.
#[derive(Clone, Copy)]
pub(super) struct CornerArc {
    /// The parameters of the points of tangency, on the segment before the corner and on the one after it, both counted
    /// from the corner.
    pub(super) from_corner: [f64; 2],
    /// The points of tangency.
    pub(super) ends: [DVec2; 2],
    /// The unit tangents of the path there.
    pub(super) tangents: [DVec2; 2],
    /// The radius in units of `unit`, negative for a right turn.
    pub(super) radius: f64,
    pub(super) unit: f64,
}

/// Whether a joint with these unit tangents is a corner that an arc can replace.
pub(super) fn is_corner([before, after]: [DVec2; 2]) -> bool {
    before.perp_dot(after).abs() > MIN_CORNER_SINE
}

/// The arc of a radius above 0 at a corner. Both sides are lists of segments that are not points, start at the corner,
/// and lead away from it. The points of tangency are at most at the given parameters; the radius is reduced where it
/// must be. `None` if only a negligible arc is possible.
pub(super) fn corner_arc(
    sides: &[Vec<Curve<DVec2>>; 2],
    radius: f64,
    limits: [f64; 2],
) -> Option<CornerArc> {
    let corner = sides[1][0].start();
    let tangents = [-start_tangent(&sides[0][0]), start_tangent(&sides[1][0])];
    let (scaled, unit) = scaled(sides, corner);
    let sign = 1.0_f64.copysign(tangents[0].perp_dot(tangents[1]));
    let side = |k: usize, sign: f64| Side {
        pieces: scaled[k]
            .iter()
            .map(|points| CurveWithDerivatives::new(points))
            .collect(),
        current: 0,
        sign,
        limit: limits[k],
    };
    let mut fitted = Corner {
        sides: [side(0, -sign), side(1, sign)],
        tangents,
        sign,
    };
    let contact = fitted.fit((radius / unit).min(MAX_RADIUS));
    if contact[RADIUS] < MIN_RADIUS {
        return None;
    }
    let between_lines = fitted.starts_with_lines() && contact[0].max(contact[1]) <= 1.0;
    let distance = contact[RADIUS] * fitted.tangent_of_half_turn() * unit;
    let end = |k: usize, outward: DVec2| {
        if between_lines && contact[k] < 1.0 && contact[k] != limits[k] {
            corner + outward * distance
        } else {
            eval(&sides[k], contact[k])
        }
    };
    Some(CornerArc {
        from_corner: [contact[0], contact[1]],
        ends: [end(0, -tangents[0]), end(1, tangents[1])],
        tangents: [-fitted.outward(&contact, 0)?, fitted.outward(&contact, 1)?],
        radius: sign * contact[RADIUS],
        unit,
    })
}

/// The control points of the curves relative to the corner, scaled to a size of about 1, and the unit.
fn scaled(sides: &[Vec<Curve<DVec2>>; 2], corner: DVec2) -> ([Vec<Vec<DVec2>>; 2], f64) {
    let halves = sides.each_ref().map(|side| {
        let half = |curve: &Curve<DVec2>| -> Vec<DVec2> {
            let points = curve.control_points();
            points.iter().map(|&p| p * 0.5 - corner * 0.5).collect()
        };
        side.iter().map(half).collect::<Vec<_>>()
    });
    let size = halves.iter().flatten().map(|points| max_abs(points));
    let scale = unit_scale(size.fold(0.0, f64::max));
    let scaled = halves.map(|mut side| {
        side.iter_mut().flatten().for_each(|p| *p *= scale);
        side
    });
    (scaled, 2.0 / scale)
}

/// The point of a list of curves at a parameter.
fn eval(curves: &[Curve<DVec2>], x: f64) -> DVec2 {
    let mut rest = x;
    for curve in &curves[..curves.len() - 1] {
        if rest < 1.0 {
            return curve.eval(rest);
        }
        rest -= 1.0;
    }
    curves[curves.len() - 1].eval(rest)
}
