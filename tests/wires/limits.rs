//! Tubes and ribbons on degenerate surfaces, and rejected input.

use super::{euler, ribbons, single, teapot, triangles, tubes, vector, volume};
use crate::support::Rng;
use crate::support::nets::RandomNet;
use casteljau::glam::{DAffine3, DVec3};
use casteljau::mesh::{Wire, WireframeOptions};
use casteljau::models::Up;
use casteljau::{Mesh, Surface};
use wasm_bindgen_test::wasm_bindgen_test;

#[wasm_bindgen_test(unsupported = test)]
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

#[wasm_bindgen_test(unsupported = test)]
fn results_follow_the_surface() {
    let turn =
        DAffine3::from_rotation_y(0.7) * DAffine3::from_translation(DVec3::new(1.0, 2.0, 3.0));
    let count = |mesh: &Mesh| (mesh.vertex_count(), mesh.triangle_count());
    let cup = Surface::teacup(Up::Z);
    let (plain, turned) = (
        ribbons(&cup, 2, 0.02),
        ribbons(&cup.transform(&turn).expect("a finite image"), 2, 0.02),
    );
    assert!(count(&plain).0.abs_diff(count(&turned).0) < 20);
    for scale in [1e-9, 1e9] {
        let scaled = cup
            .transform(&DAffine3::from_scale(DVec3::splat(scale)))
            .expect("a finite image");
        let mesh = tubes(&scaled, 2, 0.02 * scale, 8);
        assert!(count(&mesh).0.abs_diff(count(&tubes(&cup, 2, 0.02, 8)).0) < 100);
        let share = volume(&mesh) / volume(&tubes(&cup, 2, 0.02, 8)) / scale.powi(3);
        assert!((share - 1.0).abs() < 1e-3, "{share}");
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn degenerate_lines() {
    let point = single(vec![DVec3::ONE; 16], 3, 3);
    assert_eq!(tubes(&point, 3, 0.1, 8), empty(1));
    assert_eq!(ribbons(&point, 3, 0.1), empty(1));
    let nothing = Surface::new(Vec::new(), Vec::new(), 3, 3).unwrap();
    assert_eq!(tubes(&nothing, 3, 0.1, 8), empty(0));
    // A patch that is a curve has no normals; on the next ones lines turn back or have cusps.
    let along = |xs: [f64; 4]| {
        let row = move |y: f64| xs.map(|x| DVec3::new(x, y, 0.0));
        [0.0, 0.0, 0.0, 0.0].map(row).concat()
    };
    let cusp = [(0.0, 0.0), (1.0, 1.0), (0.0, 1.0), (1.0, 0.0)];
    let cusps: Vec<DVec3> = (0..16)
        .map(|i| DVec3::new(cusp[i % 4].0, cusp[i % 4].1, (i / 4) as f64))
        .collect();
    for net in [
        along([0.0, 1.0, 2.0, 3.0]),
        along([0.0, 3.0, -2.0, 1.0]),
        along([0.0; 4]),
        cusps,
    ] {
        let surface = single(net, 3, 3);
        euler(&tubes(&surface, 2, 0.01, 7));
        check_ribbons(&ribbons(&surface, 2, 0.01));
    }
    // The cusp ends a line: both arms are separate bodies.
    let cusps = [[0.0, 0.0], [1.0, 1.0], [0.0, 1.0], [1.0, 0.0]];
    let net = [0.0, 1.0]
        .map(|z| cusps.map(|[x, y]| DVec3::new(x, y, z)))
        .concat();
    assert_eq!(
        euler(&tubes(&single(net, 3, 1), 1, 0.01, 8)),
        2 * (2 + 2 * 2)
    );
}

fn empty(patches: usize) -> Mesh {
    Mesh {
        patch_ranges: vec![casteljau::mesh::PatchRange::default(); patches],
        ..Mesh::default()
    }
}

fn check_ribbons(mesh: &Mesh) {
    let finite = |list: &[f32]| list.iter().all(|x| x.is_finite());
    assert!(finite(&mesh.positions) && finite(&mesh.normals));
    for vertex in 0..mesh.vertex_count() {
        assert!((vector(&mesh.normals, vertex).length() - 1.0).abs() < 3e-7);
    }
    assert!(
        triangles(mesh)
            .iter()
            .flatten()
            .all(|&v| v < mesh.vertex_count())
    );
}

#[wasm_bindgen_test(unsupported = test)]
fn adversarial_nets() {
    let mut random = Rng(11);
    for case in 0..300 {
        let (m, n) = (1 + case % 5, 1 + case / 5 % 4);
        let scale = [1.0, 1e-30, 1e30][case % 3];
        let net = random.net(m, n).into_iter().map(|p| p * scale);
        let surface = single(net.collect(), m, n);
        let size = [0.001, 0.1, 3.0][case % 7 % 3] * scale;
        euler(&tubes(&surface, 1 + case % 3, size, 3 + case % 6));
        check_ribbons(&ribbons(&surface, 1 + case % 3, size));
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn refused() {
    let of = |lines, wire| {
        let result = teapot().wireframe(&WireframeOptions { lines, wire });
        result.unwrap_err().to_string()
    };
    let tube = |radius, sides| Wire::Tube { radius, sides };
    let ribbon = |width| Wire::Ribbon { width };
    assert_eq!(
        of(0, ribbon(0.1)),
        "lines: expected a whole number from 1, got 0"
    );
    assert_eq!(
        of(1, tube(0.1, 2)),
        "sides: expected a whole number from 3, got 2"
    );
    assert_eq!(
        of(1, tube(0.0, 8)),
        "radius: expected a finite number above 0, got 0"
    );
    assert_eq!(
        of(1, ribbon(f64::NAN)),
        "width: expected a finite number above 0, got NaN"
    );
    assert_eq!(
        of(1, ribbon(f64::INFINITY)),
        "width: expected a finite number above 0, got inf"
    );
    assert!(of(1, tube(1e-9, 8)).starts_with("radius: expected at least "));
    assert!(of(1, ribbon(1e-9)).starts_with("width: expected at least "));
    assert!(of(1, ribbon(1e39)).starts_with("vertices: expected coordinates that f32 can hold"));
    assert!(of(1_000_000, ribbon(0.1)).starts_with("vertices: expected at most "));
    assert!(of(usize::MAX, ribbon(0.1)).starts_with("vertices: expected at most "));
    assert!(of(2, tube(0.1, usize::MAX)).starts_with("vertices: expected at most "));
    assert!(of(1, tube(2.0, 100_000)).contains("expected at "));
}

/// Gumbo, the most difficult model: many corners and edges are collapsed.
#[cfg(not(target_family = "wasm"))]
#[test]
fn gumbo() {
    let Some(surface) = crate::support::surfaces::gumbo() else {
        return;
    };
    // 247 edges are shared by two patches, 10 are a point.
    let curves = 128 * 2 * 5 - 247 - 10;
    assert_eq!(surface.isocurves(4).unwrap().len(), curves);
    let mesh = tubes(&surface, 4, 0.05, 6);
    assert!(euler(&mesh) >= 2 * isize::try_from(curves).unwrap());
    let bands = ribbons(&surface, 4, 0.1);
    assert!(bands.vertex_count() >= 4 * curves);
    check_ribbons(&bands);
    assert_eq!(Surface::parse(&surface.to_text()), Ok(surface));
}
