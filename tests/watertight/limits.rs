//! The limit of a patch's normal, in double the precision of f64 and without the normal net.

use super::shapes::teapot;
use crate::support::exact::{Double, exactly, two_sum};
use crate::support::nets::samples;
use casteljau::glam::DVec3;
use casteljau::{Patch, Surface};

/// The maximum error of a normal, in degrees.
pub(crate) const MAX_DEGREES: f64 = 0.001;

type Vector = [Double; 3];

/// The limit of the direction of ∂u × ∂v at (u, v) from the middle of the patch; `None` for a curve or a point.
pub(crate) fn limit(patch: &Patch, u: f64, v: f64) -> Option<DVec3> {
    let size = patch.control_bounds().diagonal();
    let cross = plain(patch, u, v);
    if cross.length() > 1e-6 * size * size {
        return Some(cross.normalize());
    }
    let net: Vec<DVec3> = patch.control_points().iter().map(|&p| p / size).collect();
    let at = |h: f64| precise(&net, patch.degree_u() + 1, [u, v], h);
    let here = at(0.0);
    if here.length() > 1e-20 {
        return Some(here.normalize());
    }
    // Richardson extrapolation: the direction on the line to the middle is smooth in h.
    let h = 1.0 / 1_048_576.0;
    let [a, b, c] = [h, 2.0 * h, 4.0 * h].map(at);
    if a.length() < 1e-28 {
        return None;
    }
    let [a, b, c] = [a, b, c].map(DVec3::normalize);
    Some((a * (8.0 / 3.0) - b * 2.0 + c / 3.0).normalize())
}

fn plain(patch: &Patch, u: f64, v: f64) -> DVec3 {
    let partials = patch.partials(u, v);
    partials.u.cross(partials.v)
}

/// ∂u × ∂v at (u, v), moved by the fraction h of the line to (½, ½), up to a factor.
fn precise(net: &[DVec3], columns: usize, [u, v]: [f64; 2], h: f64) -> DVec3 {
    let moved = |t: f64| two_sum(t, h * (0.5 - t));
    let net: Vec<Vector> = net.iter().map(|p| p.to_array().map(exactly)).collect();
    let du: Vec<Vector> = net.chunks(columns).flat_map(steps).collect();
    let pairs = net.iter().zip(&net[columns..]);
    let dv: Vec<Vector> = pairs.map(|(a, b)| minus(b, a)).collect();
    let du = tensor(&du, columns - 1, moved(u), moved(v));
    let dv = tensor(&dv, columns, moved(u), moved(v));
    let cross = |i: usize, j: usize| (du[i] * dv[j] - du[j] * dv[i]).hi;
    DVec3::new(cross(1, 2), cross(2, 0), cross(0, 1))
}

fn steps(row: &[Vector]) -> Vec<Vector> {
    let step = |pair: &[Vector]| minus(&pair[1], &pair[0]);
    row.windows(2).map(step).collect()
}

fn minus(a: &Vector, b: &Vector) -> Vector {
    [0, 1, 2].map(|k| a[k] - b[k])
}

fn tensor(net: &[Vector], columns: usize, u: Double, v: Double) -> Vector {
    let column = net.chunks(columns).map(|row| casteljau_at(row, u));
    casteljau_at(&column.collect::<Vec<_>>(), v)
}

fn casteljau_at(row: &[Vector], t: Double) -> Vector {
    let s = exactly(1.0) - t;
    let mut row = row.to_vec();
    while row.len() > 1 {
        let next = |pair: &[Vector]| [0, 1, 2].map(|k| pair[0][k] * s + pair[1][k] * t);
        row = row.windows(2).map(next).collect();
    }
    row[0]
}

/// Compares the normals at all degenerate points of a 16 × 16 grid; returns their number.
pub(crate) fn compare(surface: &Surface, max_degrees: f64) -> usize {
    let mut degenerate = 0;
    for (index, patch) in surface.patches().enumerate() {
        let size = patch.control_bounds().diagonal();
        for (u, v) in
            samples(16).filter(|&(u, v)| plain(&patch, u, v).length() <= 1e-9 * size * size)
        {
            degenerate += 1;
            let expected = limit(&patch, u, v).expect("a normal");
            let degrees = patch.normal(u, v).angle_between(expected).to_degrees();
            assert!(
                degrees < max_degrees,
                "patch {index} ({u}, {v}): {degrees}°"
            );
        }
    }
    degenerate
}

#[test]
fn normals_are_limits_at_degenerate_corners_and_edges() {
    assert_eq!(compare(&teapot(), 1e-4), 136);
}
