//! Ribbons: bands in the tangent planes of a surface.

use super::ribbons;
use crate::support::Rng;
use crate::support::nets::{RandomNet, single, triangles, vector};
use casteljau::glam::DVec3;
use std::f64::consts::PI;
#[cfg(target_family = "wasm")]
use wasm_bindgen_test::wasm_bindgen_test as test;

#[test]
fn ribbons_lie_in_the_tangent_planes() {
    let surface = single(&Rng(8).net(3, 3), 3, 3);
    let width = 0.04;
    let mesh = ribbons(&surface, 1, width);
    let patch = surface.patch(0).unwrap();
    let curves = surface.isocurves(1).unwrap();
    assert_eq!(curves.len(), 4);
    for vertex in (0..mesh.vertex_count()).step_by(2) {
        let [left, right] = [0, 1].map(|k| vector(&mesh.positions, vertex + k));
        assert!((left.distance(right) - width).abs() < 1e-6);
        let normal = vector(&mesh.normals, vertex);
        assert_eq!(normal, vector(&mesh.normals, vertex + 1));
        assert!(normal.dot(right - left).abs() < 1e-7);
        // The middle is a point of an edge, and the normal is the patch's normal there.
        let middle = 0.5 * (left + right);
        let edges = (0..=4000).map(|k| f64::from(k) / 4000.0);
        let edges = edges.flat_map(|t| [(0.0, t), (1.0, t), (t, 0.0), (t, 1.0)]);
        let all = edges.map(|(u, v)| (patch.eval(u, v).distance(middle), u, v));
        let nearest = all.fold((1.0, 0.0, 0.0), |a, b| if b.0 < a.0 { b } else { a });
        assert!(nearest.0 < 2e-3);
        assert!(normal.dot(patch.normal(nearest.1, nearest.2)) > 0.999);
    }
    for [a, b, c] in triangles(&mesh) {
        let [p, q, r] = [a, b, c].map(|vertex| vector(&mesh.positions, vertex));
        let cross = (q - p).cross(r - p);
        assert!(cross.dot(vector(&mesh.normals, a)) > 0.0);
    }
}

#[test]
fn ribbons_turn_with_the_surface() {
    // z = 20xy: every line is straight, but the surface turns about it by almost half a turn from end to end.
    let net = [(0.0, 0.0), (1.0, 0.0), (0.0, 1.0), (1.0, 1.0)];
    let net = net.map(|(x, y)| DVec3::new(x - 0.5, y - 0.5, 20.0 * (x - 0.5) * (y - 0.5)));
    let mesh = ribbons(&single(&net, 1, 1), 2, 0.01);
    assert!(mesh.vertex_count() > 2 * 3 * 6);
    for [a, b, ..] in triangles(&mesh) {
        let turn = vector(&mesh.normals, a).dot(vector(&mesh.normals, b));
        assert!(turn >= (PI / 4.0).cos() - 1e-6);
    }
}
