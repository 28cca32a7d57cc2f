//! Straight curves that turn back: every turning point is a vertex, unless a vertex lies within the tolerance of it.

use crate::support::{Rng, plane, real};
use casteljau::Curve;
use casteljau::glam::DVec2;

/// The parameters at which the coordinate of a straight curve turns back, by sign changes of its differences on a fine
/// grid.
fn turns(along: &[f64]) -> Vec<f64> {
    const STEPS: usize = 20_000;
    let at = |t: f64| {
        let mut row = along.to_vec();
        while row.len() > 1 {
            row = row
                .windows(2)
                .map(|w| w[0] * (1.0 - t) + w[1] * t)
                .collect();
        }
        row[0]
    };
    let values: Vec<f64> = (0..=STEPS).map(|i| at(real(i) / real(STEPS))).collect();
    let turn = |w: &&[f64]| (w[1] - w[0]) * (w[2] - w[1]) < 0.0;
    values.windows(3).filter(turn).map(|w| w[1]).collect()
}

/// Checks the curve a·direction, whose points are exact products.
fn check(along: &[f64], direction: DVec2, tolerance: f64) {
    let points: Vec<DVec2> = along.iter().map(|&a| direction * a).collect();
    let curve = Curve::new(&points).expect("finite");
    let line = curve.flatten(tolerance).expect("flat");
    let length = direction.length();
    for turn in turns(along) {
        let near =
            |p: &DVec2| (*p - direction * turn).length() <= tolerance * 1.001 + 1e-6 * length;
        assert!(
            line.points.iter().any(near),
            "{along:?} · {direction}, {tolerance}: no vertex at {turn}"
        );
    }
    // A straight line needs no vertices except turning points and ends.
    assert!(
        line.ts.len() <= along.len(),
        "{along:?}: {} vertices",
        line.ts.len()
    );
}

#[test]
fn every_turn_is_a_vertex() {
    let mut rng = Rng(7);
    let directions = [
        DVec2::X,
        DVec2::Y,
        DVec2::new(1.0, 1.0),
        DVec2::new(-3.0, 0.25),
        DVec2::new(0.7, 0.3),
    ];
    for _ in 0..600 {
        let degree = 2 + rng.below(4);
        let along: Vec<f64> = (0..=degree)
            .map(|_| (rng.signed() * 64.0).round())
            .collect();
        let tolerance = rng.magnitude(-3.0, 1.5);
        check(&along, rng.pick(&directions), tolerance);
    }
}

#[test]
fn known_turns() {
    // x = 4t(1 − t): to 1 and back to the start.
    let line = plane(&[(0.0, 0.0), (2.0, 0.0), (0.0, 0.0)])
        .flatten(0.01)
        .expect("flat");
    assert_eq!(line.points, [DVec2::ZERO, DVec2::X, DVec2::ZERO]);
    // linebender/kurbo#426: turning points at −0.383… and 99.88….
    let line = plane(&[(0.0, 10.0), (-10.0, 10.0), (180.0, 10.0), (60.0, 10.0)])
        .flatten(0.25)
        .expect("flat");
    assert_eq!(line.points.len(), 4);
    assert!((line.points[1].x + 0.383_376_013_856_379_2).abs() < 1e-12);
    assert!((line.points[2].x - 99.883_568_247_612_63).abs() < 1e-12);
}

/// Omitting a turning point near the end once exceeded the tolerance at another one.
#[test]
fn turns_near_the_end() {
    let along = [0.0, 40.0, -16.0, 20.0];
    for k in 1..400 {
        check(&along, DVec2::new(1.0, 0.25), 0.025 * real(k));
    }
}

#[test]
fn points_and_lines_take_two_vertices() {
    let point = plane(&[(3.0, 4.0); 4]).flatten(1e-9).expect("flat");
    assert_eq!(
        (point.points, point.ts),
        (vec![DVec2::new(3.0, 4.0); 2], vec![0.0, 1.0])
    );
    for degree in [1, 2, 3, 4, 17, 64] {
        let even: Vec<(f64, f64)> = (0..=degree).map(|i| (real(i), -2.0 * real(i))).collect();
        assert_eq!(
            plane(&even).flatten(1e-9).expect("flat").ts,
            [0.0, 1.0],
            "degree {degree}"
        );
    }
}
