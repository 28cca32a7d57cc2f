//! Arcs of the normal about a point, as cubics.

use crate::numeric::trigonometry::cos_sin;
use glam::DVec2;

/// A half circle in this many pieces has an error below rounding.
const MAX_ARC_PIECES: f64 = 512.0;

/// Appends three control points for each cubic of an arc: the points at a distance along the normal from a centre, while
/// the tangent rotates from one direction to another by an angle. The two centres, at the start and at the end of the
/// arc, differ by less than the tolerance.
///
/// The derivative of the normal is opposite to the tangent, N′ = −θ′T.
pub fn add_arc(
    centers: [DVec2; 2],
    tangents: [DVec2; 2],
    angle: f64,
    distance: f64,
    tolerance: f64,
    out: &mut Vec<DVec2>,
) {
    let pieces = arc_pieces(angle, distance.abs(), tolerance);
    let (cos, sin) = cos_sin(0.25 * angle / pieces);
    // The angle of a piece is θ = angle/pieces; the sign is that of N′ = −θ′T.
    let handle = -distance * (4.0 / 3.0) * (sin / cos);
    let [first, end] = [0, 1].map(|k| (centers[k], tangents[k]));
    let point = |(center, tangent): (DVec2, DVec2)| center + tangent.perp() * distance;
    let (mut last, mut k) = (first, 1.0);
    while k <= pieces {
        let next = if k == pieces {
            end
        } else {
            let (cos, sin) = cos_sin(angle * (k / pieces));
            (first.0, DVec2::new(cos, sin).rotate(first.1))
        };
        out.extend_from_slice(&[
            point(last) + last.1 * handle,
            point(next) - next.1 * handle,
            point(next),
        ]);
        (last, k) = (next, k + 1.0);
    }
}

/// The number of cubics for an arc: a cubic for the angle θ with handles 4/3 tan(θ/4) has an error of (2/27)
/// sin⁶(θ/4)/cos²(θ/4) of the radius. Source: Dokken, Dæhlen, Lyche and Mørken, "Good approximation of circles by
/// curvature-continuous Bézier curves", CAGD 7 (1990).
fn arc_pieces(angle: f64, radius: f64, tolerance: f64) -> f64 {
    let error = |pieces: f64| {
        let (cos, sin) = cos_sin(0.25 * angle / pieces);
        let square = sin * sin;
        (2.0 / 27.0) * square * square * square / (cos * cos) * radius
    };
    let mut pieces = (angle.abs() / std::f64::consts::PI).ceil().max(1.0);
    while error(pieces) > tolerance && pieces < MAX_ARC_PIECES {
        pieces += 1.0;
    }
    pieces
}
