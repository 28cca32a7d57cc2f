//! Rays that are tangent to a patch, that run within it, or that hit a collapsed edge.

use crate::queries::rays::{assert_hits, shoot};
use crate::support::nets::{assert_near, bowl, graph, patch, points, teapot};
use casteljau::Surface;
use casteljau::glam::DVec3;
use casteljau::patch::PatchPoint;
#[cfg(target_family = "wasm")]
use wasm_bindgen_test::wasm_bindgen_test as test;

#[test]
fn a_touch_is_one_hit() {
    assert_hits(&bowl(), "-1 0.5 0  1 0 0", "0.5 0.5 0", 1e-14);
    assert_hits(&bowl(), "0.5 4 0  0 -0.1 0", "0.5 0.5 0", 1e-14);
    // The tangent at (0.3, 0.6) in the direction (1, 2), which starts 0.37 of that before the point.
    assert_hits(&bowl(), "-0.07 -0.14 0.05  1 2 0", "0.3 0.6 0.05", 1e-7);
    // At a tiny offset there are two hits, or none.
    assert_eq!(shoot(&bowl(), "-1 0.5 1e-10  1 0 0").len(), 2);
    assert_eq!(shoot(&bowl(), "-1 0.5 -1e-10  1 0 0").len(), 0);
    // An inflection: z = (u − ½)³ has one hit of multiplicity three.
    let cube = [(1.0, 3, 0), (-1.5, 2, 0), (0.75, 1, 0), (-0.125, 0, 0)];
    assert_hits(&graph(3, 1, &cube), "-1 0.4 0  1 0 0", "0.5 0.4 0", 1e-5);
}

/// Next to this ray there are three hits on one side and one on the other; on the ray itself two of the three coincide.
#[test]
fn a_touch_beside_a_crossing() {
    let net = points("-1 0 0  -1 0 1  -1 0 1  0 1 1  0 -1 1  0 1 0  1 1 0  1 1 0  1 1 1");
    let patch = patch(&net, 2, 2);
    let hits = |z: f64| shoot(&patch, &format!("1 0.5 {z}  -1 -0.125 0.09375"));
    let counts = [0.5 - 1e-3, 0.5, 0.5 + 1e-3].map(|z| hits(z).len());
    assert_eq!(counts, [3, 2, 1]);
    let location = patch.eval(0.75, 0.5);
    let near = |hit: &PatchPoint| hit.point.distance(location) < 1e-7;
    assert!(hits(0.5).iter().any(near));
}

#[test]
fn a_ray_within_the_patch_meets_its_sides() {
    let flat = graph(3, 3, &[]);
    assert_hits(&flat, "-1 0.25 0  1 0 0", "0 0.25 0  1 0.25 0", 1e-14);
    assert_hits(&flat, "-1 -1 0  1 1 0", "0 0 0  1 1 0", 1e-14);
    // Along an edge, and from a start on the patch.
    assert_hits(&flat, "-1 0 0  1 0 0", "0 0 0  1 0 0", 1e-14);
    assert_hits(&flat, "0.5 0.25 0  1 0 0", "0.5 0.25 0  1 0.25 0", 1e-14);
    // The straight lines of z = uv.
    let saddle = graph(1, 1, &[(1.0, 1, 1)]);
    assert_hits(
        &saddle,
        "-0.5 0.5 -0.25  1 0 0.5",
        "0 0.5 0  1 0.5 0.5",
        1e-14,
    );
}

#[test]
fn a_pole_is_one_hit() {
    let teapot = teapot();
    let hits = teapot.intersect_ray(DVec3::Z * 9.0, -DVec3::Z).unwrap();
    // The lid's knob, inner sides of the lid's patches if any, and the bottom.
    let heights: Vec<f64> = hits.iter().map(|hit| hit.point.z).collect();
    assert_eq!(hits.len(), 2, "{hits:?}");
    assert!((heights[0] - 3.15).abs() < 1e-14 && heights[1].abs() < 1e-14);
    for hit in hits {
        assert_near(hit.point, DVec3::Z * hit.point.z, 1e-13);
    }
}

#[test]
fn a_seam_is_hit_once() {
    // A tube whose first and last control points of each row coincide: u = 0 and u = 1 are the same line.
    let net = points("1 0 0  1 3 0  -3 1 0  1 0 0  1 0 1  1 3 1  -3 1 1  1 0 1");
    let tube = patch(&net, 3, 1);
    for (z, slant) in [(0.0, 0.0), (0.25, 0.3), (1.0, -0.2), (0.7, 5.0)] {
        let aim = DVec3::new(1.0, 0.0, z);
        let along = DVec3::new(-1.0, 0.1, slant);
        let hits = tube.intersect_ray(aim - along * 3.0, along).unwrap();
        let there = hits.iter().filter(|hit| hit.point.distance(aim) < 1e-9);
        assert_eq!(there.count(), 1, "{hits:?}");
    }
}

#[test]
fn hits_near_an_edge_are_two_from_far_away_too() {
    // A roof of two faces, intersected slightly below its ridge.
    let net = points("-1 0 -1  -1 1 -1  0 0 0  0 1 0  1 0 -1  1 1 -1");
    let roof = Surface::new(net, vec![0, 1, 2, 3, 2, 3, 4, 5], 1, 1).unwrap();
    for far in [2.0, 1e3, 1e6] {
        let hits = |z: f64| {
            let origin = DVec3::new(-far, 0.5, z);
            roof.intersect_ray(origin, DVec3::X).unwrap()
        };
        for below in [1e-4, 1e-6] {
            let hits = hits(-below);
            assert_eq!(hits.len(), 2, "{far} {below}");
            let width = hits[0].point.distance(hits[1].point);
            assert!((width - 2.0 * below).abs() < 1e-15 * far, "{width} {below}");
        }
        assert_eq!(hits(0.0).len(), 1, "{far}");
    }
}
