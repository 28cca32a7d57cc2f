//! Dashes: their lengths, and where they start.

use crate::stroke::cases::hard;
use crate::support::paths::path;
use crate::support::{Rng, near};
use casteljau::Path;

/// The lengths of the dashes of an open path by adding up the pattern.
fn expected(whole: f64, pattern: &[f64], offset: f64) -> Vec<f64> {
    let entries: Vec<f64> = pattern.repeat(1 + pattern.len() % 2);
    let sum: f64 = entries.iter().sum();
    let mut rest = offset.rem_euclid(sum);
    let mut k = 0;
    while rest >= entries[k] {
        rest -= entries[k];
        k = (k + 1) % entries.len();
    }
    let (mut s, mut dashes) = (0.0, Vec::new());
    while s < whole {
        let step = entries[k] - rest;
        if k % 2 == 0 {
            dashes.push(step.min(whole - s));
        }
        (s, rest, k) = (s + step, 0.0, (k + 1) % entries.len());
    }
    dashes
}

#[test]
fn lengths_of_dashes_on_hard_curves() {
    let mut rng = Rng(11);
    for (name, path) in hard() {
        let whole = path.length();
        for _ in 0..if whole == 0.0 { 0 } else { 20 } {
            let count = 1 + rng.below(5);
            let entries = (0..count).map(|_| whole * rng.magnitude(-2.5, 0.2));
            let pattern: Vec<f64> = entries.collect();
            let offset = whole * 3.0 * rng.signed();
            let dashes = path.dash(&pattern, offset).expect("few dashes");
            let expected = expected(whole, &pattern, offset);
            let counts = (dashes.subpath_count(), expected.len());
            assert_eq!(counts.0, counts.1, "{name}: {pattern:?} {offset}");
            for (dash, expected) in dashes.subpaths().zip(&expected) {
                assert!(!dash.is_closed());
                near(dash.length(), *expected, 1e-9 * whole);
            }
        }
    }
}

#[test]
fn dashes_continue_across_joints_and_the_start() {
    let square = path("M0 0H4V4H0Z");
    let dash = |pattern: &[f64], offset| square.dash(pattern, offset).expect("few dashes");
    assert_eq!(dash(&[5.0, 1.0], 0.0), path("M0 4L0 0L4 0L4 1M4 2L4 4L1 4"));
    assert_eq!(dash(&[4.0], 0.0), path("M0 0L4 0M4 4L0 4"));
    assert_eq!(dash(&[4.0], 2.0), path("M0 2L0 0L2 0M4 2L4 4L2 4"));
    assert_eq!(dash(&[4.0], -4.0), path("M4 0L4 4M0 4L0 0"));
    assert_eq!(dash(&[20.0, 1.0], 1.0), square);
    assert_eq!(dash(&[], 3.0), square);
    let open = path("M0 0H4V4M9 9H10");
    let dashes = open.dash(&[3.0, 2.0], 0.0).expect("few dashes");
    assert_eq!(dashes, path("M0 0L3 0M4 1L4 4M9 9L10 9"));
}

#[test]
fn dashes_of_length_zero() {
    let line = path("M0 0H4");
    let dots = line.dash(&[0.0, 2.0], 0.0).expect("few dashes");
    assert_eq!(dots, path("M0 0L0 0M2 0L2 0"));
    let point = path("M3 3H3");
    assert_eq!(point.dash(&[1.0], 0.5).expect("on"), point);
    assert!(point.dash(&[1.0], 1.5).expect("off").is_empty());
    assert!(Path::default().dash(&[1.0], 0.0).expect("empty").is_empty());
}
