//! The limit of a patch's normal, in double the precision of f64 and without the normal net.

use crate::support::exact::{Double, exactly, two_sum};
use casteljau::Patch;
use casteljau::glam::DVec3;

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
    let dv: Vec<Vector> = net
        .iter()
        .zip(&net[columns..])
        .map(|(a, b)| minus(b, a))
        .collect();
    let du = tensor(&du, columns - 1, moved(u), moved(v));
    let dv = tensor(&dv, columns, moved(u), moved(v));
    let cross = |i: usize, j: usize| (du[i] * dv[j] - du[j] * dv[i]).hi;
    DVec3::new(cross(1, 2), cross(2, 0), cross(0, 1))
}

fn steps(row: &[Vector]) -> Vec<Vector> {
    row.windows(2)
        .map(|pair| minus(&pair[1], &pair[0]))
        .collect()
}

fn minus(a: &Vector, b: &Vector) -> Vector {
    [0, 1, 2].map(|k| a[k] - b[k])
}

fn tensor(net: &[Vector], columns: usize, u: Double, v: Double) -> Vector {
    let column: Vec<Vector> = net
        .chunks(columns)
        .map(|row| casteljau_at(row, u))
        .collect();
    casteljau_at(&column, v)
}

fn casteljau_at(row: &[Vector], t: Double) -> Vector {
    let s = exactly(1.0) - t;
    let mut row = row.to_vec();
    while row.len() > 1 {
        row = row
            .windows(2)
            .map(|pair| [0, 1, 2].map(|k| pair[0][k] * s + pair[1][k] * t))
            .collect();
    }
    row[0]
}
