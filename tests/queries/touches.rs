//! Rays that touch a patch, run within it, or meet it where a side is a point.

use crate::nets::{assert_near, graph};
use crate::rays::{assert_hits, bowl, shoot};
use crate::shapes::teapot;
use casteljau::glam::DVec3;
use wasm_bindgen_test::wasm_bindgen_test;

#[wasm_bindgen_test(unsupported = test)]
fn a_touch_is_one_hit() {
    let bowl = bowl();
    assert_hits(
        &bowl,
        [-1.0, 0.5, 0.0],
        [1.0, 0.0, 0.0],
        &[[0.5, 0.5, 0.0]],
        1e-14,
    );
    assert_hits(
        &bowl,
        [0.5, 4.0, 0.0],
        [0.0, -0.1, 0.0],
        &[[0.5, 0.5, 0.0]],
        1e-14,
    );
    // The tangent at (0.3, 0.6), in the direction (1, 2), starting a little before.
    let (at, slope) = (
        DVec3::new(0.3, 0.6, 0.05),
        DVec3::new(1.0, 2.0, -0.4 + 2.0 * 0.2),
    );
    let start = at - slope * 0.37;
    assert_hits(&bowl, start.into(), slope.into(), &[at.into()], 1e-7);
    // A tiny way off there are two, or none.
    assert_eq!(shoot(&bowl, [-1.0, 0.5, 1e-10], [1.0, 0.0, 0.0]).len(), 2);
    assert_eq!(shoot(&bowl, [-1.0, 0.5, -1e-10], [1.0, 0.0, 0.0]).len(), 0);
    // An inflection: z = (u − ½)³ has one hit, three times.
    let wave = graph(
        3,
        1,
        &[(1.0, 3, 0), (-1.5, 2, 0), (0.75, 1, 0), (-0.125, 0, 0)],
    );
    assert_hits(
        &wave,
        [-1.0, 0.4, 0.0],
        [1.0, 0.0, 0.0],
        &[[0.5, 0.4, 0.0]],
        1e-5,
    );
}

#[wasm_bindgen_test(unsupported = test)]
fn a_ray_within_the_patch_meets_its_sides() {
    let flat = graph(3, 3, &[]);
    let across = [[0.0, 0.25, 0.0], [1.0, 0.25, 0.0]];
    assert_hits(&flat, [-1.0, 0.25, 0.0], [1.0, 0.0, 0.0], &across, 1e-14);
    assert_hits(
        &flat,
        [-1.0, -1.0, 0.0],
        [1.0, 1.0, 0.0],
        &[[0.0; 3], [1.0, 1.0, 0.0]],
        1e-14,
    );
    // Along a side, and from a start on the patch.
    assert_hits(
        &flat,
        [-1.0, 0.0, 0.0],
        [1.0, 0.0, 0.0],
        &[[0.0; 3], [1.0, 0.0, 0.0]],
        1e-14,
    );
    let inside = [[0.5, 0.25, 0.0], [1.0, 0.25, 0.0]];
    assert_hits(&flat, [0.5, 0.25, 0.0], [1.0, 0.0, 0.0], &inside, 1e-14);
    // The lines of z = uv.
    let saddle = graph(1, 1, &[(1.0, 1, 1)]);
    assert_hits(
        &saddle,
        [-0.5, 0.5, -0.25],
        [1.0, 0.0, 0.5],
        &[[0.0, 0.5, 0.0], [1.0, 0.5, 0.5]],
        1e-14,
    );
}

#[wasm_bindgen_test(unsupported = test)]
fn a_pole_is_one_hit() {
    let teapot = teapot();
    let hits = teapot.intersect_ray(DVec3::Z * 9.0, -DVec3::Z).unwrap();
    // The lid's knob, the inside of the lid's patches if any, the bottom.
    let heights: Vec<f64> = hits.iter().map(|hit| hit.point.z).collect();
    assert_eq!(hits.len(), 2, "{hits:?}");
    assert!((heights[0] - 3.15).abs() < 1e-14 && heights[1].abs() < 1e-14);
    for hit in hits {
        assert_near(hit.point, DVec3::Z * hit.point.z, 1e-13);
    }
}
