//! Patches that touch themselves: folded flaps, and tubes thinner than the tolerance.

use super::checks::assert_layout;
use super::distance::greatest;
use super::shapes::segments;
use super::soup::{Soup, vectors};
use casteljau::glam::DVec3;
use casteljau::mesh::{TessellationOptions, Weld};
use casteljau::{Patch, Surface};

#[track_caller]
fn assert_within(patch: &Patch, tolerance: f64) {
    let mesh = patch
        .tessellate(&TessellationOptions::tolerance(tolerance).weld(Weld::None))
        .unwrap();
    assert_layout(&mesh, 1);
    let count = patch.control_points().len();
    let indices = (0..u32::try_from(count).unwrap()).collect();
    let surface = Surface::new(
        patch.control_points().to_vec(),
        indices,
        patch.degree_u(),
        patch.degree_v(),
    )
    .unwrap();
    let (max, _) = greatest(&surface, &Soup::new(&mesh), 2_000);
    assert!(max <= tolerance, "{max} for {tolerance}");
}

/// Opposite corners coincide: half of the square lies on the other half.
#[test]
fn a_square_folded_along_its_diagonal() {
    let [a, b, c] = [
        DVec3::new(3.7, 3.6, 0.4),
        DVec3::new(2.2, 0.0, 0.9),
        DVec3::new(0.3, 2.5, 0.3),
    ];
    for net in [[a, b, c, a], [b, a, a, c]] {
        let patch = Patch::new(&net, 1, 1).unwrap();
        for tolerance in [10.0, 2.0, 0.75, 0.05] {
            assert_within(&patch, tolerance);
        }
        // Along the fold the two sides have opposite normals; either is accepted.
        let mesh = patch.tessellate(&segments(2, 2).weld(Weld::None)).unwrap();
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
    let nets = [
        [[-1, 2, -1], [0, -2, -2], [-1, -2, -1], [-1, 2, -1]],
        [[-1, 2, -1], [-1, -2, -1], [0, -2, -2], [-1, 2, -1]],
        [[0, 0, 0], [1, 1, 1], [2, 2, 1], [0, 0, 0]],
    ];
    for net in nets {
        let net = net.map(|p| DVec3::from(p.map(f64::from)));
        let patch = Patch::new(&net, 1, 1).unwrap();
        for eighths in 1..24 {
            assert_within(&patch, f64::from(eighths) / 8.0);
        }
    }
}

/// S(u, v) = S(1 − u, v).
#[test]
fn a_strip_folded_in_the_middle() {
    let row = |y: f64| [0.0, 1.0, 0.0].map(|x| DVec3::new(x, y, x));
    let patch = Patch::new([row(0.0), row(5.0)].as_flattened(), 2, 1).unwrap();
    for tolerance in [10.0, 0.3, 0.01] {
        assert_within(&patch, tolerance);
    }
}

/// A tube from one patch whose first and last rows coincide: along u, along v, as a cone, as a ring.
#[test]
fn tubes_thinner_than_the_tolerance() {
    let ring = [(0.0, 0.0), (0.1, 0.0), (0.1, 0.1), (0.0, 0.0)].map(|(x, y)| DVec3::new(x, y, 0.0));
    let lifted = |z: f64, size: f64| ring.map(|p| p * size + DVec3::Z * z);
    let nets = [
        [lifted(0.0, 1.0), lifted(10.0, 1.0)],
        [lifted(0.0, 0.0), lifted(10.0, 1.0)],
        [lifted(0.0, 1.0), lifted(10.0, 0.0)],
    ];
    for rows in &nets {
        let along: Vec<DVec3> = (0..4).flat_map(|k| rows.map(|row| row[k])).collect();
        for patch in [
            Patch::new(rows.as_flattened(), 3, 1),
            Patch::new(&along, 1, 3),
        ] {
            for tolerance in [0.5, 0.2, 0.02, 0.001] {
                assert_within(patch.as_ref().unwrap(), tolerance);
            }
        }
    }
    // Closed in both directions.
    let rows = [0.0, 1.0, 2.0, 0.0].map(|z| ring.map(|p| DVec3::new(p.x + z, p.y, z * 3.0 - p.x)));
    let patch = Patch::new(rows.as_flattened(), 3, 3).unwrap();
    for tolerance in [20.0, 1.0, 0.2, 0.01] {
        assert_within(&patch, tolerance);
    }
}

/// Both halves of a tube are closed: a figure of eight, thinner than the tolerance.
#[test]
fn tubes_whose_halves_are_tubes() {
    let eight = [
        (0.0, 0.0),
        (0.1, -0.1),
        (0.1, 0.1),
        (-0.1, -0.1),
        (-0.1, 0.1),
        (0.0, 0.0),
    ];
    let ring = |z: f64| eight.map(|(x, y)| DVec3::new(x, y, z));
    let patch = Patch::new([ring(0.0), ring(10.0)].as_flattened(), 5, 1).unwrap();
    for tolerance in [0.5, 0.2, 0.02, 0.001] {
        assert_within(&patch, tolerance);
    }
}
