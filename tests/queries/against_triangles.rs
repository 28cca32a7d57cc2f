//! Rays, compared with intersections of the triangles of a fine grid.

use crate::support::Rng;
use crate::support::nets::RandomNet;
use casteljau::glam::DVec3;
use casteljau::{Grid, Patch};
#[cfg(target_family = "wasm")]
use wasm_bindgen_test::wasm_bindgen_test as test;

const SEGMENTS: usize = 96;

/// The distance along a ray to its intersection with a triangle (Möller–Trumbore).
fn met([a, b, c]: [DVec3; 3], origin: DVec3, along: DVec3) -> Option<f64> {
    let (e1, e2, from) = (b - a, c - a, origin - a);
    let p = along.cross(e2);
    let q = from.cross(e1);
    let det = e1.dot(p);
    let [u, v, t] = [from.dot(p), along.dot(q), e2.dot(q)].map(|x| x / det);
    (u >= 0.0 && v >= 0.0 && u + v <= 1.0 && t >= 0.0).then_some(t)
}

fn triangles(patch: &Patch) -> Vec<[DVec3; 3]> {
    let grid = Grid::from(SEGMENTS);
    let uvs = (0..grid.vertex_count()).map(|k| grid.uv(k % (SEGMENTS + 1), k / (SEGMENTS + 1)));
    let points: Vec<DVec3> = uvs.map(|(u, v)| patch.eval(u, v)).collect();
    let corners = grid.triangles().map(|t| t.map(|vertex| points[vertex]));
    corners.collect()
}

#[test]
fn as_many_hits_at_the_same_distances() {
    let mut random = Rng(77);
    let mut hits = 0;
    for k in 0..20 {
        let patch = random.patch(1 + k % 5, 1 + k / 5);
        let triangles = triangles(&patch);
        for _ in 0..40 {
            let origin = random.grid_point() * 2.0;
            let aim = DVec3::from([0; 3].map(|_| 1.5 * random.unit() - 0.75));
            let along = (aim - origin).normalize_or(DVec3::X);
            let met = triangles.iter().filter_map(|&t| met(t, origin, along));
            let mut expected: Vec<f64> = met.collect();
            expected.sort_by(f64::total_cmp);
            let found = patch.intersect_ray(origin, along).unwrap();
            let counts = (found.len(), expected.len());
            assert_eq!(counts.0, counts.1, "{origin} {along} {patch:?}");
            for (hit, distance) in found.iter().zip(expected) {
                assert!((hit.distance - distance).abs() < 0.02, "{hit:?} {distance}");
            }
            hits += found.len();
        }
    }
    assert!(hits > 200, "{hits}");
}
