//! Parallel curves: as far as was asked from the curve, everywhere, without gaps.
#![cfg(not(target_family = "wasm"))]

mod chains;
#[path = "../common/mod.rs"]
mod common;
mod lower;
mod strokes;
mod truth;

use casteljau::Curve;
use casteljau::glam::DVec2;
use common::wild::{self, Kind};
use common::{Rng, largest, real, ulp};
use truth::{Truth, at, dense};

/// How far the offset is from the truth, and the truth from it, in tolerances.
fn error(curve: &Curve<DVec2>, distance: f64, tolerance: f64) -> f64 {
    let offset = curve.offset(distance, Some(tolerance)).expect("finite");
    assert!(
        offset.control_points().iter().all(|p| p.is_finite()),
        "{curve:?} at {distance}"
    );
    let truth = Truth::new(curve.control_points(), distance, 0.02 * tolerance);
    let ours = dense(&offset, 0.02 * tolerance);
    let enough = 1.02 * tolerance;
    let there = truth.farthest(&ours, enough);
    let back = truth::farthest(&ours, &truth.vertices, enough);
    there.max(back) / tolerance
}

const KINDS: [Kind; 12] = [
    Kind::Random,
    Kind::Integers,
    Kind::Closed,
    Kind::Collinear,
    Kind::Cusp,
    Kind::Loop,
    Kind::FlatS,
    Kind::Elevated,
    Kind::LongHandle,
    Kind::Spike,
    Kind::OneAway,
    Kind::Coincident,
];

/// Some thousands, or millions with CASTELJAU_DEEP.
fn cases() -> usize {
    if std::env::var_os("CASTELJAU_DEEP").is_some() {
        2_000_000
    } else {
        8_000
    }
}

/// Whether the curve comes so close to a stop that rounding decides which way its tangent turns there.
fn nearly_stops(points: &[DVec2]) -> bool {
    let slopes: Vec<DVec2> = points.windows(2).map(|p| p[1] - p[0]).collect();
    let fastest = slopes.iter().map(|v| v.length()).fold(0.0, f64::max);
    let speed = |k: usize| at(&slopes, real(k) / 4096.0).length();
    let mut least = (1..4096).filter(|&k| speed(k) <= speed(k - 1) && speed(k) <= speed(k + 1));
    least.any(|k| {
        let (mut lo, mut hi) = (real(k - 1) / 4096.0, real(k + 1) / 4096.0);
        for _ in 0..60 {
            let (a, b) = (lo + (hi - lo) / 3.0, hi - (hi - lo) / 3.0);
            if at(&slopes, a).length() < at(&slopes, b).length() {
                hi = b;
            } else {
                lo = a;
            }
        }
        at(&slopes, lo).length() < 1e-6 * fastest
    })
}

#[test]
fn wild_curves() {
    let mut rng = Rng(1986);
    for case in 0..cases() {
        let kind = rng.pick(&KINDS);
        let degree = match rng.below(10) {
            0..7 => 3,
            7 | 8 => 1 + rng.below(7),
            _ => 1 + rng.below(20),
        };
        let points: Vec<DVec2> = wild::points(&mut rng, kind, degree, 2)
            .iter()
            .map(|p| p.truncate())
            .collect();
        let size = largest(&points);
        let side = if rng.chance(0.5) { 1.0 } else { -1.0 };
        let distance = size * rng.magnitude(-3.0, 1.5) * side;
        let reach = size + distance.abs();
        let tolerance = (size * rng.magnitude(-4.0, -1.0)).max(64.0 * ulp(reach));
        let curve = Curve::new(&points).expect("finite");
        if size == 0.0 || nearly_stops(&points) {
            let offset = curve.offset(distance, Some(tolerance)).expect("finite");
            assert!(offset.control_points().iter().all(|p| p.is_finite()));
            continue;
        }
        let found = error(&curve, distance, tolerance);
        if std::env::var_os("SHOW").is_none() {
            assert!(
                found <= 1.1,
                "{case} {kind:?}: {found} tolerances, {curve:?} at {distance}, {tolerance}"
            );
        } else if found > 1.1 {
            println!(
                "{case} {kind:?} degree {degree}: {found} {curve:?} d {distance} tol {tolerance}"
            );
        }
    }
}

/// Huge, tiny, of any degree: an answer of finite numbers in time.
#[test]
fn any_curve_has_a_parallel() {
    let mut rng = Rng(1999);
    for _ in 0..500 {
        let kind = rng.pick(&wild::ALL);
        let degree = if rng.chance(0.8) {
            3
        } else {
            1 + rng.below(12)
        };
        let points: Vec<DVec2> = wild::points(&mut rng, kind, degree, 2)
            .iter()
            .map(|p| p.truncate())
            .collect();
        let curve = Curve::new(&points).expect("finite");
        let distance = largest(&points) * rng.signed() * rng.magnitude(-9.0, 3.0);
        let offset = curve.offset(distance, None).expect("finite");
        assert!(
            offset.control_points().iter().all(|p| p.is_finite()),
            "{curve:?} at {distance}"
        );
        assert!(offset.segment_count() < 20_000, "{curve:?} at {distance}");
    }
}
