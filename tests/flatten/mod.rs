//! Flattening keeps its tolerance on every curve with few chords, by measurement.

mod cases;
mod refused;
mod straight;

use crate::support::adversarial::Kind;
use crate::support::measure::{Reference, farthest, fewest};
use crate::support::threads::on_all;
use crate::support::{self, bezier, curve, real, to_3d};
use cases::Case;
use casteljau::Curve;
use casteljau::glam::{DAffine2, DVec2};
use std::sync::atomic::{AtomicUsize, Ordering::Relaxed};

#[test]
fn keeps_the_tolerance_on_all_curves() {
    on_all(0..support::cases(20_000, 500_000), |i| Case::new(i).check());
}

/// The fewest chords come from a greedy search along the curve, not from a proof. Where a curve nearly reverses, a part
/// takes a few chords for each halving of the distance from that point.
#[test]
fn takes_few_chords() {
    let curves = support::cases(2_000, 25_000);
    let (all, all_few) = (AtomicUsize::new(0), AtomicUsize::new(0));
    on_all(0..curves, |i| {
        let case = Case::new(7 * i + 3);
        // Straight curves need a vertex at each turning point; at a tolerance of a few ulps rounding decides.
        if !matches!(case.kind, Kind::Collinear | Kind::FewUlps) {
            let [ours, few] = chords_and_min(&case);
            all.fetch_add(ours, Relaxed);
            all_few.fetch_add(few, Relaxed);
        }
    });
    let (all, few) = (all.into_inner(), all_few.into_inner());
    assert!(real(all) <= 1.27 * real(few), "{all} chords, fewest {few}");
}

/// The number of chords and the fewest; fails if they are far apart.
fn chords_and_min(case: &Case) -> [usize; 2] {
    let ours = case.flatten().0.len() - 1;
    let reference = Reference::new(&case.points);
    let few = fewest(&reference, reference.length(case.tolerance));
    let max = 1.5 * real(few) + 40.0;
    assert!(real(ours) <= max, "{ours}, not {few} chords: {case:?}");
    [ours, few]
}

/// Nearly straight curves of high degree, for which long chords were missed or cubics were used in vain.
#[test]
fn nearly_straight_curves_take_few_chords() {
    for number in [40_554, 93_474, 96_491, 120_340] {
        chords_and_min(&Case::new(number));
    }
}

/// A curve of degree 46 of a few ulps, whose deviations are below the rounding of its coordinates.
#[test]
fn a_curve_of_a_few_ulps_keeps_the_tolerance() {
    Case::new(696_254).check();
}

/// The chord of a whole loop is a point; only the control points bound the distance of the loop from it.
#[test]
fn closed_curves_at_large_tolerances() {
    let curve = bezier(
        "0.5081333383921331 -0.7269188766115495, -0.24019590067800345 0.7211333756777132,
         0.360438320251673 0.44163351516458227, 0.5081333383921331 -0.7269188766115495",
    );
    let reference = Reference::new(&to_3d(curve.control_points()));
    for tolerance in [0.9053, 0.8, 0.5, 0.1] {
        let line = curve.flatten(tolerance).expect("flat");
        let vertices = reference.locations(&line.points);
        let max = reference.length(tolerance) * (1.0 + 1e-12);
        let off = farthest(&reference, &line.ts, &vertices, max);
        assert!(off <= max, "{tolerance}: {off}");
    }
}

#[test]
fn scaled_reversed_and_turned_curves_get_the_same_polyline() {
    for case in (0..400).map(Case::new) {
        if matches!(case.kind, Kind::FewUlps | Kind::Huge | Kind::Tiny) {
            continue;
        }
        let curve: Curve<DVec2> = curve(&case.points);
        let flat = |map: DAffine2, scale: f64| {
            let image = curve.transform(&map).expect("a finite image");
            image.flatten(case.tolerance * scale).expect("flat").ts
        };
        let plain = flat(DAffine2::IDENTITY, 1.0);
        for scale in [1024.0, 1.0 / 1024.0] {
            let scaled = flat(DAffine2::from_scale(DVec2::splat(scale)), scale);
            assert_eq!(scaled, plain, "{case:?}");
        }
        let turned = flat(DAffine2::from_cols(DVec2::Y, -DVec2::X, DVec2::ZERO), 1.0).len();
        let more = turned.abs_diff(plain.len());
        assert!(more <= 1 + plain.len() / 16, "{case:?}");
    }
}

#[test]
fn flatten_with_gives_the_same_vertices() {
    for case in (0..200).map(Case::new) {
        let curve: Curve<DVec2> = curve(&case.points);
        let line = curve.flatten(case.tolerance).expect("flat");
        let (mut ts, mut points) = (Vec::new(), Vec::new());
        let add = |t: f64, p| {
            ts.push(t);
            points.push(p);
        };
        curve.flatten_with(case.tolerance, add).expect("flat");
        assert_eq!((ts, points), (line.ts, line.points));
    }
}
