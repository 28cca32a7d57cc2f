//! Tubes and ribbons on degenerate surfaces, and rejected input.

use super::{euler, ribbons, tubes};
use crate::support::nets::volume;
use crate::support::nets::{RandomNet, net, nothing, scaled, single, teapot};
use crate::support::wires::check_ribbons;
use crate::support::{Rng, assert_refused};
use casteljau::glam::{DAffine3, DVec3};
use casteljau::mesh::{PatchRange, Wire, WireframeOptions};
use casteljau::models::Up;
use casteljau::{Mesh, Surface};
#[cfg(target_family = "wasm")]
use wasm_bindgen_test::wasm_bindgen_test as test;

#[test]
fn ranges_tell_which_patch_drew() {
    for mesh in [tubes(&teapot(), 3, 0.02, 4), ribbons(&teapot(), 3, 0.02)] {
        assert_eq!(mesh.patch_ranges.len(), 32);
        let (mut vertex, mut index) = (0, 0);
        for range in &mesh.patch_ranges {
            assert_eq!((range.first_vertex, range.first_index), (vertex, index));
            (vertex, index) = (vertex + range.vertices, index + range.indices);
        }
        assert_eq!(vertex as usize, mesh.vertex_count());
        assert_eq!(index as usize, mesh.indices.len());
    }
}

#[test]
fn results_follow_the_surface() {
    let turn =
        DAffine3::from_rotation_y(0.7) * DAffine3::from_translation(DVec3::new(1.0, 2.0, 3.0));
    let cup = Surface::teacup(Up::Z);
    let bands = [&cup, &cup.transform(&turn).unwrap()].map(|s| ribbons(s, 2, 0.02).vertex_count());
    assert!(bands[0].abs_diff(bands[1]) < 20);
    let before = tubes(&cup, 2, 0.02, 8);
    for scale in [1e-9, 1e9] {
        let mesh = tubes(&scaled(&cup, scale), 2, 0.02 * scale, 8);
        assert!(mesh.vertex_count().abs_diff(before.vertex_count()) < 100);
        let share = volume(&mesh) / volume(&before) / scale.powi(3);
        assert!((share - 1.0).abs() < 1e-3, "{share}");
    }
}

#[test]
fn degenerate_lines() {
    let point = single(&[DVec3::ONE; 16], 3, 3);
    for (surface, patches) in [(&point, 1), (&nothing(), 0)] {
        let patch_ranges = vec![PatchRange::default(); patches];
        let empty = Mesh {
            patch_ranges,
            ..Mesh::default()
        };
        assert_eq!(tubes(surface, 3, 0.1, 8), empty);
        assert_eq!(ribbons(surface, 3, 0.1), empty);
    }
    // A patch that is a curve has no normals; on the next ones lines turn back or have cusps.
    let cusp = [(0.0, 0.0), (1.0, 1.0), (0.0, 1.0), (1.0, 0.0)];
    let flat = [[0.0, 1.0, 2.0, 3.0], [0.0, 3.0, -2.0, 1.0], [0.0; 4]];
    let rows = flat.map(|xs| xs.map(|x| (x, 0.0)));
    for (row, depth) in rows.map(|row| (row, 0.0)).into_iter().chain([(cusp, 1.0)]) {
        let mut net = net(3, 3, |_, j| DVec3::Z * j * depth);
        (0..16).for_each(|k| (net[k].x, net[k].y) = row[k % 4]);
        let surface = single(&net, 3, 3);
        euler(&tubes(&surface, 2, 0.01, 7));
        check_ribbons(&ribbons(&surface, 2, 0.01));
    }
    // The cusp ends a line: both arms are separate bodies.
    let net = [0.0, 1.0].map(|z| cusp.map(|(x, y)| DVec3::new(x, y, z)));
    let mesh = tubes(&single(net.as_flattened(), 3, 1), 1, 0.01, 8);
    assert_eq!(euler(&mesh), 2 * (2 + 2 * 2));
}

#[test]
fn adversarial_nets() {
    let mut random = Rng(11);
    for case in 0..300 {
        let (m, n) = (1 + case % 5, 1 + case / 5 % 4);
        let scale = [1.0, 1e-30, 1e30][case % 3];
        let net: Vec<DVec3> = random.net(m, n).iter().map(|&p| p * scale).collect();
        let surface = single(&net, m, n);
        let size = [0.001, 0.1, 3.0][case % 7 % 3] * scale;
        euler(&tubes(&surface, 1 + case % 3, size, 3 + case % 6));
        check_ribbons(&ribbons(&surface, 1 + case % 3, size));
    }
}

#[test]
fn refused() {
    let tube = |radius, sides| Wire::Tube { radius, sides };
    let ribbon = |width| Wire::Ribbon { width };
    let many = usize::MAX;
    for (lines, wire, message) in [
        (
            0,
            ribbon(0.1),
            "lines: expected a whole number from 1, got 0",
        ),
        (
            1,
            tube(0.1, 2),
            "sides: expected a whole number from 3, got 2",
        ),
        (
            1,
            tube(0.0, 8),
            "radius: expected a finite number above 0, got 0",
        ),
        (
            1,
            ribbon(f64::NAN),
            "width: expected a finite number above 0, got NaN",
        ),
        (
            1,
            ribbon(f64::INFINITY),
            "width: expected a finite number above 0, got inf",
        ),
        (1, tube(1e-9, 8), "radius: expected at least "),
        (1, ribbon(1e-9), "width: expected at least "),
        (
            1,
            ribbon(1e39),
            "vertices: expected coordinates that f32 can hold",
        ),
        (1_000_000, ribbon(0.1), "vertices: expected at most "),
        (many, ribbon(0.1), "vertices: expected at most "),
        (2, tube(0.1, many), "vertices: expected at most "),
        (1, tube(2.0, 100_000), "radius: expected at least "),
    ] {
        let result = teapot().wireframe(&WireframeOptions::new().lines(lines).wire(wire));
        assert_refused(result, message);
    }
}
