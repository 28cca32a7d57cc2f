//! Sampling of plane cubics.

use crate::numeric::lanes::f64x2;
use glam::DVec2;

/// Points of the plane cubic with the given control points at equal steps of t from 0 to 1.
///
/// Two points are computed at a time. Every weight and sum is rounded as in the scalar formula, so the numbers are the
/// same.
pub fn sample_plane_cubic(points: [DVec2; 4], out: &mut [DVec2]) {
    let last = f64x2::splat(out.len().saturating_sub(1).max(1) as f64);
    let x = points.map(|p| f64x2::splat(p.x));
    let y = points.map(|p| f64x2::splat(p.y));
    let two_points = |i: f64x2| {
        let weights = cubic_weights(i / last);
        let ([x0, x1], [y0, y1]) = (blend(&x, weights).to_array(), blend(&y, weights).to_array());
        [DVec2::new(x0, y0), DVec2::new(x1, y1)]
    };
    let (two, four) = (f64x2::splat(2.0), f64x2::splat(4.0));
    let mut i = f64x2::new([0.0, 1.0]);
    // Two pairs per iteration, so that their divisions overlap.
    let mut quads = out.chunks_exact_mut(4);
    for quad in &mut quads {
        let (near, far) = quad.split_at_mut(2);
        near.copy_from_slice(&two_points(i));
        far.copy_from_slice(&two_points(i + two));
        i += four;
    }
    for pair in quads.into_remainder().chunks_mut(2) {
        pair.copy_from_slice(&two_points(i)[..pair.len()]);
        i += two;
    }
}

/// The Bernstein weights of degree 3.
#[inline(always)]
fn cubic_weights(t: f64x2) -> [f64x2; 4] {
    let s = f64x2::splat(1.0) - t;
    let (ss, tt, three) = (s * s, t * t, f64x2::splat(3.0));
    [ss * s, three * ss * t, three * s * tt, tt * t]
}

#[inline(always)]
fn blend(coordinates: &[f64x2; 4], [a, b, c, d]: [f64x2; 4]) -> f64x2 {
    coordinates[0] * a + coordinates[1] * b + coordinates[2] * c + coordinates[3] * d
}
