//! Patches that touch themselves: folded flaps, and tubes thinner than the tolerance.

use super::checks::assert_layout;
use super::distance::greatest;
use super::shapes::{meshed, segments, tolerance};
use super::soup::{Soup, vectors};
use crate::support::nets::{as_surface, patch, points};
use casteljau::Patch;
use casteljau::glam::DVec3;
use casteljau::mesh::Weld;

#[track_caller]
fn assert_within(patch: &Patch, tolerances: &[f64]) {
    for &max in tolerances {
        let surface = as_surface(patch);
        let mesh = patch.tessellate(&tolerance(max).weld(Weld::None)).unwrap();
        assert_layout(&mesh, 1);
        let (distance, _) = greatest(&surface, &Soup::new(&mesh), 2_000);
        assert!(distance <= max, "{distance} for {max}");
    }
}

/// Opposite corners coincide: half of the square lies on the other half.
#[test]
fn a_square_folded_along_its_diagonal() {
    let corners = points("3.7 3.6 0.4  2.2 0 0.9  0.3 2.5 0.3");
    let [a, b, c] = corners.try_into().unwrap();
    for net in [[a, b, c, a], [b, a, a, c]] {
        let patch = patch(&net, 1, 1);
        assert_within(&patch, &[10.0, 2.0, 0.75, 0.05]);
        // Along the fold the two sides have opposite normals; either is accepted.
        let mesh = meshed(&as_surface(&patch), segments(2, 2), Weld::None);
        let plane = (b - a).cross(c - a).normalize();
        for normal in vectors(&mesh.normals) {
            assert!((normal.dot(plane).abs() - 1.0).abs() < 1e-6, "{normal}");
        }
    }
}

/// With few cells, the outline of a cell visits a point of the coincident edges twice. Triangles between these visits
/// have no area, and the corner beyond them belongs to no other triangle.
#[test]
fn a_square_folded_along_its_diagonal_in_few_cells() {
    let tolerances: Vec<f64> = (1..24).map(|eighths| f64::from(eighths) / 8.0).collect();
    for net in [
        "-1 2 -1  0 -2 -2  -1 -2 -1  -1 2 -1",
        "-1 2 -1  -1 -2 -1  0 -2 -2  -1 2 -1",
        "0 0 0  1 1 1  2 2 1  0 0 0",
    ] {
        assert_within(&patch(&points(net), 1, 1), &tolerances);
    }
}

/// S(u, v) = S(1 − u, v).
#[test]
fn a_strip_folded_in_the_middle() {
    let net = points("0 0 0  1 0 1  0 0 0  0 5 0  1 5 1  0 5 0");
    assert_within(&patch(&net, 2, 1), &[10.0, 0.3, 0.01]);
}

/// A tube from one patch whose first and last rows coincide: along u, along v, as a cone, as a ring.
#[test]
fn tubes_thinner_than_the_tolerance() {
    let ring = points("0 0 0  0.1 0 0  0.1 0.1 0  0 0 0");
    for sizes in [[1.0, 1.0], [0.0, 1.0], [1.0, 0.0]] {
        let row = |k: usize| {
            ring.iter()
                .map(move |&p| p * sizes[k] + DVec3::Z * 10.0 * k as f64)
        };
        let rows: Vec<DVec3> = row(0).chain(row(1)).collect();
        let columns: Vec<DVec3> = (0..4).flat_map(|k| [rows[k], rows[k + 4]]).collect();
        for patch in [patch(&rows, 3, 1), patch(&columns, 1, 3)] {
            assert_within(&patch, &[0.5, 0.2, 0.02, 0.001]);
        }
    }
    // Closed in both directions.
    let rows = [0.0, 1.0, 2.0, 0.0].into_iter();
    let row = |z: f64| {
        ring.iter()
            .map(move |p| DVec3::new(p.x + z, p.y, z * 3.0 - p.x))
    };
    let net: Vec<DVec3> = rows.flat_map(row).collect();
    assert_within(&patch(&net, 3, 3), &[20.0, 1.0, 0.2, 0.01]);
}

/// Both halves of a tube are closed: a figure of eight, thinner than the tolerance.
#[test]
fn tubes_whose_halves_are_tubes() {
    let eight = points("0 0 0  0.1 -0.1 0  0.1 0.1 0  -0.1 -0.1 0  -0.1 0.1 0  0 0 0");
    let upper: Vec<DVec3> = eight.iter().map(|&p| p + DVec3::Z * 10.0).collect();
    let patch = patch(&[eight, upper].concat(), 5, 1);
    assert_within(&patch, &[0.5, 0.2, 0.02, 0.001]);
}
