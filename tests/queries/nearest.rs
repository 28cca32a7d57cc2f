//! Nearest points on patches and surfaces.

use crate::queries::shapes::{odd_patches, samples, teapot};
use crate::support::Rng;
use crate::support::nets::{RandomNet, assert_near, graph};
use casteljau::glam::{DAffine3, DQuat, DVec3};
use casteljau::{Error, Patch, Surface};
use wasm_bindgen_test::wasm_bindgen_test;

#[wasm_bindgen_test(unsupported = test)]
fn of_a_rectangle() {
    let flat = graph(3, 2, &[]);
    for (p, expected) in [
        (DVec3::new(0.3, 0.6, 2.0), DVec3::new(0.3, 0.6, 0.0)),
        (DVec3::new(0.3, 0.6, 0.0), DVec3::new(0.3, 0.6, 0.0)),
        (DVec3::new(-1.0, 0.5, 1.0), DVec3::new(0.0, 0.5, 0.0)),
        (DVec3::new(0.25, 9.0, -1.0), DVec3::new(0.25, 1.0, 0.0)),
        (DVec3::new(2.0, -2.0, 5.0), DVec3::new(1.0, 0.0, 0.0)),
        (DVec3::new(1e9, 0.5, 0.0), DVec3::new(1.0, 0.5, 0.0)),
    ] {
        let nearest = flat.nearest(p).unwrap();
        assert_near(nearest.point, expected, 1e-9);
        assert_near(DVec3::new(nearest.u, nearest.v, 0.0), expected, 1e-9);
        let distance = (p - expected).length();
        assert!((nearest.distance - distance).abs() <= 1e-15 * distance.max(1.0));
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn of_a_paraboloid() {
    // Above the vertex of z = (u − ½)² + (v − ½)², the nearest point is the vertex as long as the height of p is below
    // ½, the radius of curvature.
    let bowl = graph(
        2,
        2,
        &[
            (1.0, 2, 0),
            (1.0, 0, 2),
            (-1.0, 1, 0),
            (-1.0, 0, 1),
            (0.5, 0, 0),
        ],
    );
    let low = bowl.nearest(DVec3::new(0.5, 0.5, 0.25)).unwrap();
    assert!((low.distance - 0.25).abs() < 1e-15);
    assert_near(low.point, DVec3::new(0.5, 0.5, 0.0), 1e-9);
    // Above that height a circle is nearest: r² = z with z = h − ½, at the distance √(h − ¼).
    let high = bowl.nearest(DVec3::new(0.5, 0.5, 0.625)).unwrap();
    assert!((high.distance - 0.375_f64.sqrt()).abs() < 1e-14);
    assert!((high.point.z - 0.125).abs() < 1e-7);
}

/// Checks that no sample is nearer, and that the point is on the surface.
fn check(patch: &Patch, p: DVec3, count: u32) {
    let nearest = patch.nearest(p).unwrap();
    assert_eq!(nearest.point, patch.eval(nearest.u, nearest.v));
    assert!((nearest.point.distance(p) - nearest.distance).abs() <= 1e-15 * nearest.distance);
    let min = samples(count)
        .map(|(u, v)| patch.eval(u, v).distance(p))
        .fold(f64::INFINITY, f64::min);
    let size = patch.control_bounds().diagonal();
    assert!(
        nearest.distance <= min + 1e-15 * (size + min),
        "{} > {min} at {p}",
        nearest.distance
    );
    assert!(min - nearest.distance <= 0.1 * size);
}

#[wasm_bindgen_test(unsupported = test)]
fn no_sample_is_nearer() {
    let mut random = Rng(3);
    for patch in odd_patches() {
        for _ in 0..10 {
            check(&patch, random.grid_point() * 2.0, 50);
        }
    }
    for (m, n) in [(3, 3), (2, 2), (4, 1), (5, 5)] {
        let patch = random.patch(m, n);
        for _ in 0..20 {
            check(&patch, random.grid_point(), 100);
        }
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn points_of_the_surface_are_their_own_nearest() {
    let teapot = teapot();
    for (k, patch) in teapot.patches().enumerate() {
        for (u, v) in samples(3) {
            let p = patch.eval(u, v);
            let nearest = teapot.nearest(p).unwrap().unwrap();
            assert!(
                nearest.distance < 4e-15,
                "{} at {u} {v} of patch {k}",
                nearest.distance
            );
        }
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn of_the_teapot() {
    let teapot = teapot();
    let patches: Vec<Patch> = teapot.patches().collect();
    let mut random = Rng(8);
    for _ in 0..20 {
        let p = random.grid_point() * 3.0 + DVec3::Z * 1.5;
        let nearest = teapot.nearest(p).unwrap().unwrap();
        assert_eq!(
            nearest.point,
            patches[nearest.patch].eval(nearest.u, nearest.v)
        );
        let each = patches
            .iter()
            .map(|patch| patch.nearest(p).unwrap().distance);
        let min = each.fold(f64::INFINITY, f64::min);
        assert!((nearest.distance - min).abs() < 1e-14);
        let sampled = patches
            .iter()
            .flat_map(|patch| samples(20).map(|(u, v)| patch.eval(u, v).distance(p)))
            .fold(f64::INFINITY, f64::min);
        assert!(nearest.distance <= sampled);
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn follows_rotation_and_scale() {
    let mut random = Rng(12);
    let patch = random.patch(3, 3);
    let turn = DQuat::from_axis_angle(DVec3::new(1.0, 2.0, -2.0) / 3.0, 0.7);
    for scale in [1e-6, 1.0, 1e6] {
        let map = DAffine3::from_scale_rotation_translation(
            DVec3::splat(scale),
            turn,
            DVec3::splat(scale),
        );
        let image = patch.transform(&map).expect("a finite image");
        for _ in 0..10 {
            let p = random.grid_point();
            let (a, b) = (
                patch.nearest(p).unwrap(),
                image.nearest(map.transform_point3(p)).unwrap(),
            );
            assert!((a.distance * scale - b.distance).abs() <= 1e-14 * scale);
        }
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn of_nothing_and_of_extremes() {
    let empty = Surface::new(vec![], vec![], 3, 3).unwrap();
    assert_eq!(empty.nearest(DVec3::ZERO), Ok(None));
    for size in [1e-300, 1e-150, 1e150] {
        let net = [DVec3::ZERO, DVec3::X, DVec3::Y, DVec3::ONE].map(|p| p * size);
        let patch = Patch::new(&net, 1, 1).unwrap();
        for p in [
            DVec3::ZERO,
            DVec3::ONE,
            DVec3::splat(1e150),
            DVec3::splat(size * 0.4),
        ] {
            let nearest = patch.nearest(p).unwrap();
            assert!(nearest.point.is_finite() && !nearest.distance.is_nan());
            assert!(nearest.distance <= (p.length() + size) * 1.0001);
        }
    }
    let patch = graph(1, 1, &[]);
    for bad in [f64::NAN, f64::INFINITY] {
        let error = patch.nearest(DVec3::new(0.0, bad, 0.0)).unwrap_err();
        assert!(matches!(
            error,
            Error::NotFinite {
                what: "point",
                index: 0,
                ..
            }
        ));
    }
}
