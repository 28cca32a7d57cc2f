//! Nearest points on patches and surfaces.

use crate::queries::shapes::{map, odd_patches};
use crate::support::nets::{RandomNet, assert_near, bowl, graph, nothing, points, samples, teapot};
use crate::support::{Rng, assert_refused, near};
use casteljau::Patch;
use casteljau::glam::DVec3;
#[cfg(target_family = "wasm")]
use wasm_bindgen_test::wasm_bindgen_test as test;

#[test]
fn of_a_rectangle() {
    let flat = graph(3, 2, &[]);
    let asked = "0.3 0.6 2  0.3 0.6 0  -1 0.5 1  0.25 9 -1  2 -2 5  1e9 0.5 0";
    let expected = points("0.3 0.6 0  0.3 0.6 0  0 0.5 0  0.25 1 0  1 0 0  1 0.5 0");
    for (p, expected) in points(asked).into_iter().zip(expected) {
        let nearest = flat.nearest(p).unwrap();
        assert_near(nearest.point, expected, 1e-9);
        assert_near(DVec3::new(nearest.u, nearest.v, 0.0), expected, 1e-9);
        let distance = (p - expected).length();
        near(nearest.distance, distance, 1e-15 * distance.max(1.0));
    }
}

#[test]
fn of_a_paraboloid() {
    // Above the vertex of z = (u − ½)² + (v − ½)², the nearest point is the vertex as long as the height of p is below
    // ½, the radius of curvature.
    let low = bowl().nearest(DVec3::new(0.5, 0.5, 0.25)).unwrap();
    near(low.distance, 0.25, 1e-15);
    assert_near(low.point, DVec3::new(0.5, 0.5, 0.0), 1e-9);
    // Above that height a circle is nearest: r² = z with z = h − ½, at the distance √(h − ¼).
    let high = bowl().nearest(DVec3::new(0.5, 0.5, 0.625)).unwrap();
    near(high.distance, 0.375_f64.sqrt(), 1e-14);
    near(high.point.z, 0.125, 1e-7);
}

/// Checks that no sample is nearer, and that the point is on the surface.
fn check(patch: &Patch, p: DVec3, count: u32) {
    let nearest = patch.nearest(p).unwrap();
    assert_eq!(nearest.point, patch.eval(nearest.u, nearest.v));
    assert!((nearest.point.distance(p) - nearest.distance).abs() <= 1e-15 * nearest.distance);
    let distances = samples(count).map(|(u, v)| patch.eval(u, v).distance(p));
    let min = distances.fold(f64::INFINITY, f64::min);
    let (size, distance) = (patch.control_bounds().diagonal(), nearest.distance);
    let allowed = min + 1e-15 * (size + min);
    assert!(distance <= allowed, "{distance} > {min} at {p}");
    assert!(min - distance <= 0.1 * size);
}

#[test]
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

#[test]
fn points_of_the_surface_are_their_own_nearest() {
    for (k, patch) in teapot().patches().enumerate() {
        for (u, v) in samples(3) {
            let nearest = teapot().nearest(patch.eval(u, v)).unwrap().unwrap();
            let distance = nearest.distance;
            assert!(distance < 4e-15, "{distance} at {u} {v} of patch {k}");
        }
    }
}

#[test]
fn of_the_teapot() {
    let patches: Vec<Patch> = teapot().patches().collect();
    let mut random = Rng(8);
    let min = |distances: &mut dyn Iterator<Item = f64>| distances.fold(f64::INFINITY, f64::min);
    for _ in 0..20 {
        let p = random.grid_point() * 3.0 + DVec3::Z * 1.5;
        let nearest = teapot().nearest(p).unwrap().unwrap();
        let on = patches[nearest.patch].eval(nearest.u, nearest.v);
        assert_eq!(nearest.point, on);
        let each = min(&mut patches
            .iter()
            .map(|patch| patch.nearest(p).unwrap().distance));
        near(nearest.distance, each, 1e-14);
        let points = patches
            .iter()
            .flat_map(|patch| samples(20).map(|(u, v)| patch.eval(u, v)));
        assert!(nearest.distance <= min(&mut points.map(|q| q.distance(p))));
    }
}

#[test]
fn follows_rotation_and_scale() {
    let mut random = Rng(12);
    let patch = random.patch(3, 3);
    for scale in [1e-6, 1.0, 1e6] {
        let map = map([1.0, 2.0, -2.0], 0.7, scale, 1.0);
        let image = patch.transform(&map).unwrap();
        for _ in 0..10 {
            let p = random.grid_point();
            let before = patch.nearest(p).unwrap().distance;
            let after = image.nearest(map.transform_point3(p)).unwrap().distance;
            near(after, before * scale, 1e-14 * scale);
        }
    }
}

#[test]
fn of_nothing_and_of_extremes() {
    assert_eq!(nothing().nearest(DVec3::ZERO), Ok(None));
    for size in [1e-300, 1e-150, 1e150] {
        let net = [DVec3::ZERO, DVec3::X, DVec3::Y, DVec3::ONE].map(|p| p * size);
        let patch = Patch::new(&net, 1, 1).unwrap();
        for p in [0.0, 1.0, 1e150, size * 0.4].map(DVec3::splat) {
            let nearest = patch.nearest(p).unwrap();
            assert!(nearest.point.is_finite() && !nearest.distance.is_nan());
            assert!(nearest.distance <= (p.length() + size) * 1.0001);
        }
    }
    for bad in [f64::NAN, f64::INFINITY] {
        let refused = graph(1, 1, &[]).nearest(DVec3::new(0.0, bad, 0.0));
        assert_refused(refused, "point[0]: expected a finite number");
    }
}
