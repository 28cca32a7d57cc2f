//! Straight curves that turn back: every turning point is a vertex, unless a vertex lies within the tolerance of it.

use crate::support::{Rng, all_near, bezier, curve, de_casteljau, real, to_3d, xy};
use casteljau::Curve;
use casteljau::glam::DVec2;

/// The parameters at which the coordinate of a straight curve turns back, by sign changes of its differences on a fine
/// grid.
fn turns(along: &[f64]) -> Vec<f64> {
    const STEPS: usize = 20_000;
    let points: Vec<DVec2> = along.iter().map(|&x| DVec2::new(x, 0.0)).collect();
    let at = |i: usize| de_casteljau(&points, real(i) / real(STEPS)).x;
    let values: Vec<f64> = (0..=STEPS).map(at).collect();
    let turn = |w: &&[f64]| (w[1] - w[0]) * (w[2] - w[1]) < 0.0;
    values.windows(3).filter(turn).map(|w| w[1]).collect()
}

/// Checks the curve a·direction, whose points are exact products.
fn check(along: &[f64], direction: DVec2, tolerance: f64) {
    let points: Vec<DVec2> = along.iter().map(|&a| direction * a).collect();
    let curve = Curve::new(&points).expect("finite");
    let line = curve.flatten(tolerance).expect("flat");
    for turn in turns(along) {
        let max = tolerance * 1.001 + 1e-6 * direction.length();
        let near = |p: &DVec2| (*p - direction * turn).length() <= max;
        let what = format!("{along:?} · {direction}, {tolerance}: no vertex at {turn}");
        assert!(line.points.iter().any(near), "{what}");
    }
    // A straight line needs no vertices except turning points and ends.
    let count = line.ts.len();
    assert!(count <= along.len(), "{along:?}: {count} vertices");
}

#[test]
fn every_turn_is_a_vertex() {
    let mut rng = Rng(7);
    let directions = xy("1 0, 0 1, 1 1, -3 0.25, 0.7 0.3");
    for _ in 0..600 {
        let degree = 2 + rng.below(4);
        let mut coordinate = || (rng.signed() * 64.0).round();
        let along: Vec<f64> = (0..=degree).map(|_| coordinate()).collect();
        let tolerance = rng.magnitude(-3.0, 1.5);
        check(&along, rng.pick(&directions), tolerance);
    }
}

#[test]
fn known_turns() {
    // x = 4t(1 − t): to 1 and back to the start.
    let line = bezier("0 0, 2 0, 0 0").flatten(0.01).expect("flat");
    assert_eq!(line.points, xy("0 0, 1 0, 0 0"));
    // linebender/kurbo#426: turning points at −0.383… and 99.88….
    let line = bezier("0 10, -10 10, 180 10, 60 10")
        .flatten(0.25)
        .expect("flat");
    let expected = xy("0 10, -0.3833760138563792 10, 99.88356824761263 10, 60 10");
    all_near(&line.points, &expected, 1e-12);
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
    let point = bezier("3 4, 3 4, 3 4, 3 4").flatten(1e-9).expect("flat");
    assert_eq!((point.points, point.ts), (xy("3 4, 3 4"), vec![0.0, 1.0]));
    for degree in [1, 2, 3, 4, 17, 64] {
        let point = |i: usize| DVec2::new(1.0, -2.0) * real(i);
        let even: Vec<DVec2> = (0..=degree).map(point).collect();
        let line = curve::<DVec2>(&to_3d(&even)).flatten(1e-9).expect("flat");
        assert_eq!(line.ts, [0.0, 1.0], "degree {degree}");
    }
}
