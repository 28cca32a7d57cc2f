//! Intersections of rays with patches and surfaces.

use crate::queries::shapes::{map, odd_patches, random_patches};
use crate::support::nets::{RandomNet, assert_near, bowl, graph, nothing, points, samples, teapot};
use crate::support::{Rng, assert_refused, near};
use casteljau::glam::DVec3;
use casteljau::patch::PatchPoint;
use casteljau::{Patch, Surface};
#[cfg(target_family = "wasm")]
use wasm_bindgen_test::wasm_bindgen_test as test;

/// The hits of the ray with this origin and this direction.
pub(crate) fn shoot(patch: &Patch, ray: &str) -> Vec<PatchPoint> {
    let ray = points(ray);
    patch.intersect_ray(ray[0], ray[1]).unwrap()
}

/// Asserts the points, and that u, v and distance agree with them.
#[track_caller]
pub(crate) fn assert_hits(patch: &Patch, ray: &str, expected: &str, tolerance: f64) {
    let (hits, expected) = (shoot(patch, ray), points(expected));
    assert_eq!(hits.len(), expected.len(), "{hits:?}");
    for (hit, point) in hits.iter().zip(expected) {
        assert_near(hit.point, point, tolerance);
        assert_eq!(hit.point, patch.eval(hit.u, hit.v));
        let distance = hit.point.distance(points(ray)[0]);
        near(hit.distance, distance, 1e-15 * hit.distance);
    }
}

/// The smallest distance of a hit from a point.
fn nearest(hits: &[PatchPoint], p: DVec3) -> f64 {
    let distances = hits.iter().map(|hit| hit.point.distance(p));
    distances.fold(f64::INFINITY, f64::min)
}

#[test]
fn a_rectangle() {
    let flat = graph(3, 3, &[]);
    assert_hits(&flat, "0.25 0.5 2  0 0 -7", "0.25 0.5 0", 1e-15);
    assert_hits(&flat, "0 0 1  0.25 0.5 -1", "0.25 0.5 0", 1e-15);
    // Away from the patch, past it, and from a point on it.
    assert_hits(&flat, "0.25 0.5 2  0 0 1", "", 0.0);
    assert_hits(&flat, "1.25 0.5 2  0 0 -1", "", 0.0);
    assert_hits(&flat, "0.25 0.5 0  0.3 0 -1", "0.25 0.5 0", 1e-15);
    // Edges and corners belong to the patch.
    for aim in points("0 0.3 0  1 0.7 0  0.1 0 0  0.9 1 0  0 0 0  1 1 0  0 1 0") {
        let (x, y) = (aim.x, aim.y);
        assert_hits(
            &flat,
            &format!("{x} {y} 2  0 0 -1"),
            &format!("{x} {y} 0"),
            1e-15,
        );
        let slanted = format!("{} {} 4  -1 1.5 -2", x + 2.0, y - 3.0);
        assert_hits(&flat, &slanted, &format!("{x} {y} 0"), 1e-14);
    }
    assert_hits(&flat, "1.000000000001 0.5 2  0 0 -1", "", 0.0);
}

#[test]
fn a_paraboloid_from_the_side_and_from_above() {
    // √0.04 is 0.2, up to rounding.
    assert_hits(
        &bowl(),
        "-1 0.5 0.04  2 0 0",
        "0.3 0.5 0.04  0.7 0.5 0.04",
        1e-15,
    );
    // A ray that starts between the two hits has one hit.
    assert_hits(&bowl(), "0.5 0.5 0.04  1 0 0", "0.7 0.5 0.04", 1e-15);
    assert_hits(&bowl(), "0.5 0.5 3  0 0 -1", "0.5 0.5 0", 1e-15);
    assert_hits(&bowl(), "-1 0.5 -1e-3  1 0 0", "", 0.0);
}

/// Every hit lies on the ray and on the surface; points of the surface at which rays are aimed are among the hits.
#[test]
fn what_is_aimed_at_is_hit() {
    let mut random = Rng(5);
    let others = random_patches(4, &[(3, 3), (5, 2), (3, 4), (1, 1)]);
    for patch in teapot().patches().chain(others) {
        for (u, v) in samples(4) {
            let (origin, aim) = (random.grid_point() * 5.0, patch.eval(u, v));
            let direction = (aim - origin) * (0.1 + random.unit());
            let hits = patch.intersect_ray(origin, direction).unwrap();
            let min = nearest(&hits, aim);
            assert!(min < 1e-6, "{min} {u} {v} {origin} {direction} {patch:?}");
            for hit in &hits {
                let off = (hit.point - origin).cross(direction.normalize()).length();
                assert!(off < 1e-13, "{off} {origin} {direction} {hit:?} {patch:?}");
            }
            assert!(hits.is_sorted_by_key(|hit| hit.distance));
        }
    }
}

#[test]
fn shared_sides_are_hit_once() {
    let teapot = teapot();
    for (k, patch) in teapot.patches().enumerate().skip(4).take(8) {
        for t in [0.0, 0.25, 0.5, 0.8, 1.0] {
            for (u, v) in [(t, 0.0), (0.0, t), (1.0, t), (t, 1.0)] {
                let aim = patch.eval(u, v);
                let out = DVec3::new(aim.x, aim.y, 0.1).normalize();
                let hits = teapot.intersect_ray(aim + out * 4.0, -out).unwrap();
                let there = hits.iter().filter(|hit| hit.point.distance(aim) < 1e-6);
                assert_eq!(there.count(), 1, "patch {k}, {t}: {hits:?}");
            }
        }
    }
}

#[test]
fn rays_through_the_closed_part_of_the_teapot_come_out_again() {
    // The number of hits with a closed surface is even: here the bowl and a mirrored copy, joined at the rim.
    let mut all = bowl().control_points().to_vec();
    all.iter_mut().for_each(|p| p.z -= 0.5);
    all.extend(graph(2, 2, &[]).control_points());
    let surface = Surface::new(all, (0..18).collect(), 2, 2).unwrap();
    let above = DVec3::new(0.5, 0.5, 3.0);
    let hits = surface.intersect_ray(above, -DVec3::Z).unwrap();
    assert_eq!(hits.iter().map(|hit| hit.patch).collect::<Vec<_>>(), [1, 0]);
    assert_eq!(hits[0].distance, 3.0);
    assert_eq!(hits[1].distance, 3.5);
}

#[test]
fn hits_follow_rotation_and_scale() {
    let mut random = Rng(21);
    let patch = random.patch(3, 3);
    for scale in [1e-6, 1.0, 1e6] {
        let map = map([2.0, -1.0, 2.0], 1.1, scale, 1.0);
        let image = patch.transform(&map).unwrap();
        for _ in 0..50 {
            let (origin, direction) = (random.grid_point() * 2.0, random.grid_point());
            if direction == DVec3::ZERO {
                continue;
            }
            let before = patch.intersect_ray(origin, direction).unwrap();
            let (origin, direction) = (
                map.transform_point3(origin),
                map.transform_vector3(direction),
            );
            let after = image.intersect_ray(origin, direction).unwrap();
            assert_eq!(before.len(), after.len());
            for (a, b) in before.iter().zip(&after) {
                assert_near(map.transform_point3(a.point), b.point, 1e-10 * scale);
            }
        }
    }
}

#[test]
fn odd_patches_give_few_finite_hits() {
    let mut random = Rng(6);
    for patch in odd_patches() {
        for (u, v) in [(0.0, 0.0), (1.0, 1.0), (0.5, 0.5), (0.3, 0.0)] {
            let target = patch.eval(u, v);
            let origin = random.grid_point() * 3.0 + DVec3::splat(0.1);
            for direction in [target - origin, DVec3::X, DVec3::Y] {
                let hits = patch.intersect_ray(origin, direction).unwrap();
                assert!(hits.len() < 20);
                let mut all = hits.iter();
                assert!(all.all(|hit| hit.point.is_finite() && hit.distance >= 0.0));
            }
            let aimed = patch.intersect_ray(origin, target - origin).unwrap();
            let min = nearest(&aimed, target);
            assert!(min < 1e-5, "{min} from {origin} to {target} on {patch:?}");
            // A ray that starts on the patch.
            let started = patch.intersect_ray(target, DVec3::X).unwrap();
            assert!(!started.is_empty(), "{target} {patch:?}");
        }
    }
}

#[test]
fn refusals_and_extremes() {
    let patch = graph(1, 1, &[]);
    let zero = "direction: expected a vector of a length above 0, got 0";
    assert_refused(patch.intersect_ray(DVec3::ONE, DVec3::ZERO), zero);
    for bad in [DVec3::NAN, DVec3::X * f64::INFINITY] {
        assert_refused(
            patch.intersect_ray(bad, DVec3::X),
            "origin[0]: expected a finite number",
        );
        assert_refused(
            patch.intersect_ray(DVec3::X, bad),
            "direction[0]: expected a finite number",
        );
    }
    assert_eq!(nothing().intersect_ray(DVec3::ZERO, DVec3::X), Ok(vec![]));
    for size in [1e-300, 1e-150, 1e150] {
        let net = [DVec3::ZERO, DVec3::X, DVec3::Y, DVec3::X + DVec3::Y].map(|p| p * size);
        let patch = Patch::new(&net, 1, 1).unwrap();
        let origin = DVec3::new(0.25, 0.5, 1.0) * size;
        let hits = patch.intersect_ray(origin, -DVec3::Z * 1e-200).unwrap();
        assert_eq!(hits.len(), 1, "{size}");
        assert_near(hits[0].point / size, DVec3::new(0.25, 0.5, 0.0), 1e-15);
        near(hits[0].distance / size, 1.0, 1e-15);
        let far = DVec3::splat(1e150);
        assert!(patch.intersect_ray(far, DVec3::NEG_ONE).is_ok());
    }
}
