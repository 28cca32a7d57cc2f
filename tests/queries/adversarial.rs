//! Queries on patches with any finite coordinates: results are finite numbers, with bounded work.

use crate::support::Rng;
use crate::support::nets::{RandomNet, patch, samples};
use casteljau::Patch;
use casteljau::glam::DVec3;
use proptest::prelude::*;
use proptest::test_runner::RngSeed;
use std::ops::Range;

/// A coordinate that is often 0, repeated, huge or tiny.
fn coordinate() -> impl Strategy<Value = f64> {
    prop_oneof![
        Just(0.0),
        Just(1.0),
        -1.0..1.0_f64,
        -1e150..1e150_f64,
        -1e-300..1e-300_f64,
        Just(casteljau::MAX_COORDINATE),
        Just(f64::MIN_POSITIVE),
    ]
}

fn point() -> impl Strategy<Value = DVec3> {
    [coordinate(), coordinate(), coordinate()].prop_map(DVec3::from)
}

fn any_patch(degrees: Range<usize>) -> impl Strategy<Value = Patch> {
    (degrees.clone(), degrees).prop_flat_map(|(m, n)| {
        prop::collection::vec(point(), (m + 1) * (n + 1)).prop_map(move |net| patch(&net, m, n))
    })
}

/// A patch with few different coordinates, so that it has many coincident, collinear and coplanar points.
fn coarse_patch() -> impl Strategy<Value = Patch> {
    (1..4_usize, 1..4_usize).prop_flat_map(|(m, n)| {
        let point = [-1..2_i8, -1..2_i8, 0..2_i8].prop_map(|p| DVec3::from(p.map(f64::from)));
        prop::collection::vec(point, (m + 1) * (n + 1)).prop_map(move |net| patch(&net, m, n))
    })
}

/// The seed is fixed, so that every run has the same cases and failures can be reproduced.
const SEED: RngSeed = RngSeed::Fixed(1975);

proptest! {
    #![proptest_config(ProptestConfig { cases: 64, failure_persistence: None, rng_seed: SEED, ..ProptestConfig::default() })]

    #[test]
    fn answers_are_numbers(patch in any_patch(1..5), p in point(), d in point(), u in 0.0..=1.0, v in 0.0..=1.0) {
        let bounds = patch.bounds();
        prop_assert!(bounds.min.is_finite() && bounds.max.is_finite() && bounds.min.cmple(bounds.max).all());
        let nearest = patch.nearest(p).unwrap();
        prop_assert!(nearest.point.is_finite() && !nearest.distance.is_nan());
        for hit in patch.intersect_ray(p, d + DVec3::X * 1e-300).unwrap() {
            prop_assert!(hit.point.is_finite() && hit.distance >= 0.0);
        }
        let c = patch.curvature(u, v);
        prop_assert!([c.gaussian, c.mean, c.k1, c.k2].iter().all(|k| !k.is_nan()));
        prop_assert!(!patch.area().is_nan() && !patch.flatness().is_nan());
    }

    #[test]
    fn coarse_nets(patch in coarse_patch(), p in [-2..3_i8, -2..3_i8, -2..3_i8], at in (0..5_u8, 0..5_u8)) {
        let p = DVec3::from(p.map(f64::from)) * 0.5;
        let aim = patch.eval(f64::from(at.0) / 4.0, f64::from(at.1) / 4.0);
        let nearest = patch.nearest(p).unwrap();
        prop_assert!(nearest.distance <= aim.distance(p) + 1e-14);
        prop_assert!(patch.nearest(aim).unwrap().distance < 1e-7);
        if aim.distance(p) > 1e-3 {
            let hits = patch.intersect_ray(p, aim - p).unwrap();
            prop_assert!(!hits.is_empty(), "no hit at {aim}");
            for hit in hits {
                let off = (hit.point - p).cross((aim - p).normalize()).length();
                prop_assert!(off < 1e-6, "{off} {hit:?}");
            }
        }
        let bounds = patch.bounds();
        let slack = DVec3::splat(1e-15);
        prop_assert!(aim.cmpge(bounds.min - slack).all() && aim.cmple(bounds.max + slack).all());
        prop_assert!(patch.area().is_finite());
    }
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, rng_seed: SEED, ..ProptestConfig::default() })]

    #[test]
    fn points_and_normals_are_numbers(patch in any_patch(1..6), u in 0.0..=1.0, v in 0.0..=1.0) {
        prop_assert!(patch.eval(u, v).is_finite());
        let normal = patch.normal(u, v);
        let length = normal.length();
        prop_assert!(length == 0.0 || (length - 1.0).abs() < 1e-14, "{normal}");
        for piece in patch.split(u, v) {
            prop_assert!(piece.control_points().iter().all(|p| p.is_finite()));
        }
    }
}

/// The highest degrees, with curvature in every direction: the work is limited.
#[test]
fn the_highest_degrees() {
    let patch = Rng(3).patch(64, 64);
    let p = DVec3::new(0.3, 0.2, 0.1);
    let nearest = patch.nearest(p).unwrap();
    let bounds = patch.bounds();
    for (u, v) in samples(30) {
        let sample = patch.eval(u, v);
        assert!(sample.cmpge(bounds.min).all() && sample.cmple(bounds.max).all());
        assert!(nearest.distance <= sample.distance(p));
    }
    let hits = patch.intersect_ray(p, nearest.point - p).unwrap();
    let mut distances = hits.iter().map(|hit| hit.point.distance(nearest.point));
    assert!(distances.any(|distance| distance < 1e-9));
    assert!(patch.area() > 0.0);
}
