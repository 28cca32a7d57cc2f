//! Intersections of rays with patches and surfaces.

use crate::queries::shapes::{odd_patches, samples, teapot};
use crate::support::Rng;
use crate::support::nets::{RandomNet, assert_near, graph};
use casteljau::glam::{DAffine3, DQuat, DVec3};
use casteljau::patch::PatchPoint;
use casteljau::{Error, Patch, Surface};
use wasm_bindgen_test::wasm_bindgen_test;

/// z = (u − ½)² + (v − ½)², with its vertex at (½, ½, 0).
pub(crate) fn bowl() -> Patch {
    graph(
        2,
        2,
        &[
            (1.0, 2, 0),
            (1.0, 0, 2),
            (-1.0, 1, 0),
            (-1.0, 0, 1),
            (0.5, 0, 0),
        ],
    )
}

pub(crate) fn shoot(patch: &Patch, origin: [f64; 3], direction: [f64; 3]) -> Vec<PatchPoint> {
    patch
        .intersect_ray(origin.into(), direction.into())
        .unwrap()
}

/// Asserts the points, and that u, v and distance agree with them.
#[track_caller]
pub(crate) fn assert_hits(
    patch: &Patch,
    origin: [f64; 3],
    direction: [f64; 3],
    expected: &[[f64; 3]],
    tolerance: f64,
) {
    let hits = shoot(patch, origin, direction);
    assert_eq!(hits.len(), expected.len(), "{hits:?}");
    for (hit, &point) in hits.iter().zip(expected) {
        assert_near(hit.point, point.into(), tolerance);
        assert_eq!(hit.point, patch.eval(hit.u, hit.v));
        assert!((hit.distance - hit.point.distance(origin.into())).abs() <= 1e-15 * hit.distance);
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn a_rectangle() {
    let flat = graph(3, 3, &[]);
    assert_hits(
        &flat,
        [0.25, 0.5, 2.0],
        [0.0, 0.0, -7.0],
        &[[0.25, 0.5, 0.0]],
        1e-15,
    );
    assert_hits(
        &flat,
        [0.0, 0.0, 1.0],
        [0.25, 0.5, -1.0],
        &[[0.25, 0.5, 0.0]],
        1e-15,
    );
    // Away from the patch, past it, and from a point on it.
    assert_hits(&flat, [0.25, 0.5, 2.0], [0.0, 0.0, 1.0], &[], 0.0);
    assert_hits(&flat, [1.25, 0.5, 2.0], [0.0, 0.0, -1.0], &[], 0.0);
    assert_hits(
        &flat,
        [0.25, 0.5, 0.0],
        [0.3, 0.0, -1.0],
        &[[0.25, 0.5, 0.0]],
        1e-15,
    );
    // Edges and corners belong to the patch.
    for [x, y] in [
        [0.0, 0.3],
        [1.0, 0.7],
        [0.1, 0.0],
        [0.9, 1.0],
        [0.0, 0.0],
        [1.0, 1.0],
        [0.0, 1.0],
    ] {
        assert_hits(&flat, [x, y, 2.0], [0.0, 0.0, -1.0], &[[x, y, 0.0]], 1e-15);
        assert_hits(
            &flat,
            [x + 2.0, y - 3.0, 4.0],
            [-1.0, 1.5, -2.0],
            &[[x, y, 0.0]],
            1e-14,
        );
    }
    assert_hits(&flat, [1.0 + 1e-12, 0.5, 2.0], [0.0, 0.0, -1.0], &[], 0.0);
}

#[wasm_bindgen_test(unsupported = test)]
fn a_paraboloid_from_the_side_and_from_above() {
    let bowl = bowl();
    let s = 0.04_f64.sqrt();
    let two = [[0.5 - s, 0.5, 0.04], [0.5 + s, 0.5, 0.04]];
    assert_hits(&bowl, [-1.0, 0.5, 0.04], [2.0, 0.0, 0.0], &two, 1e-15);
    // A ray that starts between the two hits has one hit.
    assert_hits(&bowl, [0.5, 0.5, 0.04], [1.0, 0.0, 0.0], &two[1..], 1e-15);
    assert_hits(
        &bowl,
        [0.5, 0.5, 3.0],
        [0.0, 0.0, -1.0],
        &[[0.5, 0.5, 0.0]],
        1e-15,
    );
    assert_hits(&bowl, [-1.0, 0.5, -1e-3], [1.0, 0.0, 0.0], &[], 0.0);
}

/// Every hit lies on the ray and on the surface; points of the surface at which rays are aimed are among the hits.
#[wasm_bindgen_test(unsupported = test)]
fn what_is_aimed_at_is_hit() {
    let mut random = Rng(4);
    let mut patches: Vec<Patch> = teapot().patches().collect();
    patches.extend([(3, 3), (5, 2), (3, 4), (1, 1)].map(|(m, n)| random.patch(m, n)));
    for patch in patches {
        for (u, v) in samples(4) {
            let (origin, aim) = (random.grid_point() * 5.0, patch.eval(u, v));
            let direction = (aim - origin) * (0.1 + random.unit());
            let hits = patch.intersect_ray(origin, direction).unwrap();
            let min = hits
                .iter()
                .map(|hit| hit.point.distance(aim))
                .fold(f64::INFINITY, f64::min);
            assert!(
                min < 1e-6,
                "{min} {u} {v} {hits:?} {origin:?} {direction:?} {patch:?}"
            );
            for hit in &hits {
                let off = (hit.point - origin).cross(direction.normalize()).length();
                assert!(off < 1e-13, "{off} {origin} {direction} {hit:?} {patch:?}");
            }
            let mut pairs = hits.windows(2);
            assert!(pairs.all(|pair| pair[0].distance <= pair[1].distance));
        }
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn shared_sides_are_hit_once() {
    let teapot = teapot();
    for (k, patch) in teapot.patches().enumerate().skip(4).take(8) {
        for t in [0.0, 0.25, 0.5, 0.8, 1.0] {
            for aim in [
                patch.eval(t, 0.0),
                patch.eval(0.0, t),
                patch.eval(1.0, t),
                patch.eval(t, 1.0),
            ] {
                let out = DVec3::new(aim.x, aim.y, 0.1).normalize();
                let hits = teapot.intersect_ray(aim + out * 4.0, -out).unwrap();
                let there = hits
                    .iter()
                    .filter(|hit| hit.point.distance(aim) < 1e-6)
                    .count();
                assert_eq!(there, 1, "patch {k}, {t}: {hits:?}");
            }
        }
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn rays_through_the_closed_part_of_the_teapot_come_out_again() {
    // The number of hits with a closed surface is even: here the bowl and a mirrored copy, joined at the rim.
    let down: Vec<DVec3> = bowl()
        .control_points()
        .iter()
        .map(|p| p - DVec3::Z * 0.5)
        .collect();
    let ellipsoid = graph(2, 2, &[]);
    let all: Vec<DVec3> = down
        .iter()
        .chain(ellipsoid.control_points())
        .copied()
        .collect();
    let surface = Surface::new(all, (0..18).collect(), 2, 2).unwrap();
    let hits = surface
        .intersect_ray(DVec3::new(0.5, 0.5, 3.0), -DVec3::Z)
        .unwrap();
    assert_eq!(hits.iter().map(|hit| hit.patch).collect::<Vec<_>>(), [1, 0]);
    assert_eq!(hits[0].distance, 3.0);
    assert_eq!(hits[1].distance, 3.5);
}

#[wasm_bindgen_test(unsupported = test)]
fn hits_follow_rotation_and_scale() {
    let mut random = Rng(21);
    let patch = random.patch(3, 3);
    let turn = DQuat::from_axis_angle(DVec3::new(2.0, -1.0, 2.0) / 3.0, 1.1);
    for scale in [1e-6, 1.0, 1e6] {
        let map = DAffine3::from_scale_rotation_translation(
            DVec3::splat(scale),
            turn,
            DVec3::splat(scale),
        );
        let image = patch.transform(&map).expect("a finite image");
        for _ in 0..50 {
            let (origin, direction) = (random.grid_point() * 2.0, random.grid_point());
            if direction == DVec3::ZERO {
                continue;
            }
            let before = patch.intersect_ray(origin, direction).unwrap();
            let mapped = (
                map.transform_point3(origin),
                map.transform_vector3(direction),
            );
            let after = image.intersect_ray(mapped.0, mapped.1).unwrap();
            assert_eq!(before.len(), after.len());
            for (a, b) in before.iter().zip(&after) {
                assert_near(map.transform_point3(a.point), b.point, 1e-10 * scale);
            }
        }
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn odd_patches_give_few_finite_hits() {
    let mut random = Rng(6);
    for patch in odd_patches() {
        let corner = patch.eval(0.0, 0.0);
        for target in [
            corner,
            patch.eval(1.0, 1.0),
            patch.eval(0.5, 0.5),
            patch.eval(0.3, 0.0),
        ] {
            let origin = random.grid_point() * 3.0 + DVec3::splat(0.1);
            for direction in [target - origin, DVec3::X, DVec3::Y] {
                let hits = patch.intersect_ray(origin, direction).unwrap();
                assert!(hits.len() < 20);
                assert!(
                    hits.iter()
                        .all(|hit| hit.point.is_finite() && hit.distance >= 0.0)
                );
            }
            let aimed = patch.intersect_ray(origin, target - origin).unwrap();
            let min = aimed
                .iter()
                .map(|hit| hit.point.distance(target))
                .fold(f64::INFINITY, f64::min);
            assert!(min < 1e-5, "{min} from {origin} to {target} on {patch:?}");
            // A ray that starts on the patch.
            assert!(
                !patch.intersect_ray(target, DVec3::X).unwrap().is_empty(),
                "{target} {patch:?}"
            );
        }
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn refusals_and_extremes() {
    let patch = graph(1, 1, &[]);
    let zero = patch.intersect_ray(DVec3::ONE, DVec3::ZERO).unwrap_err();
    assert_eq!(
        zero.to_string(),
        "direction: expected a vector of a length above 0, got 0"
    );
    for bad in [DVec3::NAN, DVec3::X * f64::INFINITY] {
        let origin = patch.intersect_ray(bad, DVec3::X);
        assert!(matches!(
            origin,
            Err(Error::NotFinite { what: "origin", .. })
        ));
        let direction = patch.intersect_ray(DVec3::X, bad);
        assert!(matches!(
            direction,
            Err(Error::NotFinite {
                what: "direction",
                ..
            })
        ));
    }
    let empty = Surface::new(vec![], vec![], 3, 3).unwrap();
    assert_eq!(empty.intersect_ray(DVec3::ZERO, DVec3::X), Ok(vec![]));
    for size in [1e-300, 1e-150, 1e150] {
        let net = [DVec3::ZERO, DVec3::X, DVec3::Y, DVec3::X + DVec3::Y].map(|p| p * size);
        let patch = Patch::new(&net, 1, 1).unwrap();
        let hits = patch
            .intersect_ray(DVec3::new(0.25, 0.5, 1.0) * size, -DVec3::Z * 1e-200)
            .unwrap();
        assert_eq!(hits.len(), 1, "{size}");
        assert_near(hits[0].point / size, DVec3::new(0.25, 0.5, 0.0), 1e-15);
        assert!((hits[0].distance / size - 1.0).abs() < 1e-15);
        patch
            .intersect_ray(DVec3::splat(1e150), DVec3::NEG_ONE)
            .unwrap();
    }
}
