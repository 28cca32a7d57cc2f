//! Tight bounding boxes.

use crate::queries::shapes::{odd_patches, random_patches};
use crate::support::Rng;
use crate::support::near;
use crate::support::nets::{RandomNet, assert_near, graph, nothing, patch, samples, teapot};
use casteljau::glam::{DAffine3, DMat3, DVec3};
#[cfg(target_family = "wasm")]
use wasm_bindgen_test::wasm_bindgen_test as test;

#[test]
fn of_the_teapot() {
    let bounds = teapot().bounds().unwrap();
    // The maximum x is a known figure; the others are exact by symmetry or by control points.
    near(bounds.max.x, 3.434_075_125_471_107, 4e-15);
    assert_eq!(bounds.min.y, -bounds.max.y);
    assert_eq!(bounds.min.z, 0.0);
    assert!((bounds.max.z - 3.15).abs() < 1e-15);
}

#[test]
fn of_polynomials() {
    // z = u² − u + v has its minimum at (½, 0) and its maxima at (0, 1) and (1, 1).
    let bounds = graph(2, 1, &[(1.0, 2, 0), (-1.0, 1, 0), (1.0, 0, 1)]).bounds();
    assert_near(bounds.min, DVec3::new(0.0, 0.0, -0.25), 1e-15);
    assert_near(bounds.max, DVec3::ONE, 1e-15);
    // z = u²(1 − u) v has its maximum at (⅔, 1).
    let bounds = graph(3, 3, &[(1.0, 2, 1), (-1.0, 3, 1)]).bounds();
    assert_near(bounds.max, DVec3::new(1.0, 1.0, 4.0 / 27.0), 1e-15);
    // A saddle that is convex in u and in v: no direction leads down from its smallest corner, (0, 0), but at (1, 0.6)
    // it is lower.
    let saddle = [(1.0, 2, 0), (4.0, 0, 2), (-5.0, 1, 1), (0.2, 0, 1)];
    assert!((graph(2, 2, &saddle).bounds().min.z + 0.44).abs() < 1e-15);
    // z = −(u + v − 1)² is maximal along a line, and z = (u − v)² minimal along a line.
    let square = [(-1.0, 2, 0), (-2.0, 1, 1), (-1.0, 0, 2)];
    let ridge = [&square[..], &[(2.0, 1, 0), (2.0, 0, 1), (-1.0, 0, 0)]];
    assert!(graph(2, 2, &ridge.concat()).bounds().max.z.abs() < 1e-15);
    let valley = [(1.0, 2, 0), (-2.0, 1, 1), (1.0, 0, 2)];
    assert!(graph(3, 2, &valley).bounds().min.z.abs() < 1e-15);
}

#[test]
fn contain_and_touch_the_patch() {
    let random = random_patches(31, &[(3, 3), (2, 2), (6, 4), (1, 3)]);
    for patch in odd_patches().iter().chain(&random) {
        let bounds = patch.bounds();
        let (mut min, mut max) = (DVec3::INFINITY, DVec3::NEG_INFINITY);
        for (u, v) in samples(200) {
            let p = patch.eval(u, v);
            (min, max) = (min.min(p), max.max(p));
        }
        let size = bounds.diagonal();
        let over = (bounds.min - min).max(max - bounds.max).max_element();
        assert!(over <= 1e-14 * size.max(1.0), "{over} of {size}: {patch:?}");
        // The samples are 1/200 apart, and a face touches the surface where the slope is zero.
        let step = DVec3::splat(1e-3 * size);
        assert!((min - bounds.min).cmple(step).all() && (bounds.max - max).cmple(step).all());
    }
}

#[test]
fn follow_scale_and_parameters() {
    let patch = Rng(5).patch(3, 4);
    let bounds = patch.bounds();
    for scale in [1e-6, 1e6, -3.0] {
        let map = DAffine3::from_mat3(DMat3::IDENTITY * scale);
        let image = patch.transform(&map).unwrap().bounds();
        let ends = [bounds.min * scale, bounds.max * scale];
        assert_near(image.min, ends[0].min(ends[1]), 4e-15 * scale.abs());
        assert_near(image.max, ends[0].max(ends[1]), 4e-15 * scale.abs());
    }
    let across = (0..20).map(|k| patch.control_points()[4 * (k % 5) + k / 5]);
    let swapped = crate::support::nets::patch(&across.collect::<Vec<_>>(), 4, 3).bounds();
    assert_near(swapped.min, bounds.min, 4e-15);
    assert_near(swapped.max, bounds.max, 4e-15);
}

#[test]
fn of_little_and_of_much() {
    assert_eq!(nothing().bounds(), None);
    let point = patch(&[DVec3::ONE; 4], 1, 1).bounds();
    assert_eq!((point.min, point.max), (DVec3::ONE, DVec3::ONE));
    for size in [1e-300, 1e150, 3.2e150] {
        let net = [DVec3::ZERO, DVec3::X, DVec3::Y, DVec3::ONE].map(|p| (p * 2.0 - 1.0) * size);
        let bounds = patch(&net, 1, 1).bounds();
        let expected = (DVec3::splat(-size), DVec3::splat(size));
        assert_eq!((bounds.min, bounds.max), expected);
    }
}
