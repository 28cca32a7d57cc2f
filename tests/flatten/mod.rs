//! Flattening keeps its tolerance on every curve with few chords, by measurement.

mod cases;
mod refused;
mod straight;

use crate::support::adversarial::Kind;
use crate::support::measure::{self, Reference, fewest};
use crate::support::threads::on_all;
use crate::support::{self, apart, plane, real};
use cases::Case;
use std::sync::atomic::{AtomicUsize, Ordering::Relaxed};

#[test]
fn keeps_the_tolerance_on_all_curves() {
    on_all(0..support::cases(20_000, 1_000_000), |i| {
        Case::new(i).check()
    });
}

/// The rule is max(fewest + 1, 1.1 · fewest). The fewest chords come from a greedy search along the curve, not from a
/// proof, and slightly shorter chords may reach an inflection at an unfavourable point: 1 % of the curves may exceed
/// the rule.
#[test]
fn takes_few_chords() {
    let curves = support::cases(2_000, 100_000);
    let beyond = AtomicUsize::new(0);
    on_all(0..curves, |i| {
        let case = Case::new(7 * i + 3);
        let ours = case.flatten().0.len() - 1;
        // Straight curves need a vertex at each turning point; at a tolerance of a few ulps rounding decides.
        let exempt = matches!(case.kind, Kind::Collinear | Kind::FewUlps);
        if !exempt && ours > 2 && takes_more_than_the_rule(&case, ours) {
            beyond.fetch_add(1, Relaxed);
        }
    });
    let beyond = beyond.into_inner();
    assert!(
        100 * beyond <= curves,
        "{beyond} of {curves} curves beyond the rule"
    );
}

/// Whether a polyline has more chords than the rule allows; fails if it has far more.
fn takes_more_than_the_rule(case: &Case, ours: usize) -> bool {
    let reference = Reference::new(&case.points);
    let few = fewest(&reference, reference.length(case.tolerance));
    let max = real(few + 4).max(1.2 * real(few));
    assert!(
        real(ours) <= max,
        "{ours} chords instead of {few}: {case:?}"
    );
    real(ours) > real(few + 1).max(1.1 * real(few))
}

/// Nearly straight curves of high degree, for which long chords were missed or cubics were used in vain.
#[test]
fn nearly_straight_curves_take_few_chords() {
    for number in [40_554, 93_474, 96_491, 120_340] {
        let case = Case::new(number);
        let ours = case.flatten().0.len() - 1;
        takes_more_than_the_rule(&case, ours);
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
    let start = (0.508_133_338_392_133_1, -0.726_918_876_611_549_5);
    let far = [
        (-0.240_195_900_678_003_45, 0.721_133_375_677_713_2),
        (0.360_438_320_251_673, 0.441_633_515_164_582_27),
    ];
    let curve = plane(&[start, far[0], far[1], start]);
    for tolerance in [0.9053, 0.8, 0.5, 0.1] {
        let line = curve.flatten(tolerance).expect("flat");
        let (points, ts) = (curve.control_points(), &line.ts);
        let reference = Reference::new(&crate::support::to_3d(points));
        let vertices: Vec<_> = line
            .points
            .iter()
            .map(|&p| reference.location(p.extend(0.0)))
            .collect();
        let max = reference.length(tolerance) * (1.0 + 1e-12);
        assert!(
            measure::farthest(&reference, ts, &vertices, max) <= max,
            "{tolerance}"
        );
    }
}

#[test]
fn scaled_reversed_and_turned_curves_get_the_same_polyline() {
    for i in 0..400 {
        let case = Case::new(i);
        if matches!(case.kind, Kind::FewUlps | Kind::Huge | Kind::Tiny) {
            continue;
        }
        let points: Vec<(f64, f64)> = case.points.iter().map(|p| (p.x, p.y)).collect();
        let flat = |map: fn((f64, f64)) -> (f64, f64), scale: f64| {
            let mapped: Vec<(f64, f64)> = points.iter().map(|&p| map(p)).collect();
            plane(&mapped)
                .flatten(case.tolerance * scale)
                .expect("flat")
                .ts
        };
        let plain = flat(|p| p, 1.0);
        assert_eq!(
            flat(|(x, y)| (x * 1024.0, y * 1024.0), 1024.0),
            plain,
            "{case:?}"
        );
        assert_eq!(
            flat(|(x, y)| (x / 1024.0, y / 1024.0), 1.0 / 1024.0),
            plain,
            "{case:?}"
        );
        let turned = flat(|(x, y)| (-y, x), 1.0);
        assert!(
            turned.len().abs_diff(plain.len()) <= 1 + plain.len() / 16,
            "{case:?}"
        );
    }
}

#[test]
fn flatten_with_gives_the_same_vertices() {
    for i in 0..200 {
        let case = Case::new(i);
        let points: Vec<(f64, f64)> = case.points.iter().map(|p| (p.x, p.y)).collect();
        let curve = plane(&points);
        let line = curve.flatten(case.tolerance).expect("flat");
        let mut k = 0;
        let same = |t: f64, p| {
            assert_eq!((t, apart(p, line.points[k])), (line.ts[k], 0.0));
            k += 1;
        };
        curve.flatten_with(case.tolerance, same).expect("flat");
        assert_eq!(k, line.ts.len());
    }
}
