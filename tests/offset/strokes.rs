//! Splines fitted to points, and splines with fewer segments.

use crate::offset::corners::{corners, is_within};
use crate::offset::reference::{dense, farthest};
use crate::support::measure::from_polyline;
use crate::support::{Rng, near, real, spline, xy};
use casteljau::Spline;
use casteljau::glam::{DVec2, DVec3};
use casteljau::spline::FitOptions;

/// A smooth spline of random cubics, with a corner occasionally.
fn known(rng: &mut Rng, segments: usize, corners: bool) -> (Spline<DVec2>, Vec<DVec2>) {
    let mut points = vec![rng.point(2).truncate()];
    let mut direction = DVec2::from_angle(6.0 * rng.unit());
    let mut sharp = Vec::new();
    for k in 0..segments {
        let start = points[points.len() - 1];
        let turn = DVec2::from_angle(rng.signed());
        let end = start + turn.rotate(direction) * (1.0 + rng.unit());
        let leave = turn.rotate(turn.rotate(direction));
        points.extend([start + direction * 0.4, end - leave * 0.4, end]);
        direction = leave;
        if corners && k + 1 < segments && rng.chance(0.3) {
            sharp.push(end);
            let angle = if rng.chance(0.5) { 1.8 } else { -1.8 };
            direction = DVec2::from_angle(angle).rotate(direction);
        }
    }
    (Spline::new(&points, 3, false).expect("finite"), sharp)
}

fn fit(points: &[DVec2], tolerance: f64) -> Spline<DVec2> {
    Spline::fit(points, &FitOptions::new(tolerance)).expect("finite")
}

#[test]
fn points_lie_within_the_tolerance_and_corners_are_found() {
    let mut rng = Rng(41);
    let mut beside = 0;
    for case in 0..300 {
        let count = 2 + rng.below(8);
        let (spline, sharp) = known(&mut rng, count, case % 2 == 0);
        let points = spline.sample(200).expect("samples");
        let tolerance = rng.magnitude(-5.0, -1.8);
        let fitted = fit(&points, tolerance);
        assert_eq!(fitted.eval(0.0), points[0]);
        is_within(&fitted, &points, tolerance);
        let found = corners(&fitted);
        for p in &sharp {
            let near = |q: &DVec2| (*q - *p).length() < 0.02 + tolerance;
            assert!(found.iter().any(near), "{case}: no corner at {p}");
        }
        beside += found.len().saturating_sub(sharp.len());
        if tolerance > 1e-3 {
            let count = fitted.segment_count();
            assert!(count <= 3 * spline.segment_count(), "{case}: {count}");
        }
    }
    // Bends that are too tight to be distinguished from corners.
    assert!(beside <= 3, "{beside}");
}

/// Someone stands still and walks on: what lies within the tolerance is one place, however many points there are.
#[test]
fn a_cluster_is_one_piece() {
    let mut rng = Rng(2202);
    for count in [100, 5_000, 40_000] {
        for place in [0, 100, 200] {
            let walk = |k: usize| DVec2::new(real(k), 30.0 * (0.05 * real(k)).sin());
            let still = (0..count).map(|_| walk(place) + DVec2::new(rng.signed(), rng.signed()));
            let still: Vec<DVec2> = still.collect();
            let (before, after) = ((0..place).map(walk), (place..200).map(walk));
            let points: Vec<DVec2> = before.chain(still).chain(after).collect();
            let fitted = fit(&points, 5.0);
            assert!(
                fitted.segment_count() <= 8,
                "{count} at {place}: {}",
                fitted.segment_count()
            );
            is_within(&fitted, &points, 5.0);
        }
    }
}

#[test]
fn degenerate_points() {
    let p = DVec2::new(3.0, 4.0);
    assert_eq!(fit(&[p, p, p], 0.1).control_points(), [p, p]);
    assert!(Spline::fit(&[p], &FitOptions::new(0.1)).is_err());
    let line: Vec<DVec2> = (0..1000).map(|k| p * real(k)).collect();
    assert_eq!(fit(&line, 0.01).segment_count(), 1);
    // The line is traversed forth and back.
    let back: Vec<DVec2> = line.iter().chain(line.iter().rev()).copied().collect();
    let fitted = fit(&back, 0.01);
    assert!(farthest(&dense(&fitted, 1e-4), &back, 0.01) <= 0.01);
    assert_eq!(fitted.segment_count(), 2);
    for scale in [1e148, 1e-300, 1e9] {
        let point = |k: usize| DVec2::from_angle(real(k) * 0.05) * scale;
        let far: Vec<DVec2> = (0..100).map(point).collect();
        let fitted = fit(&far, 1e-3 * scale);
        assert!(fitted.control_points().iter().all(|p| p.is_finite()));
        assert!(fitted.segment_count() < 10);
    }
}

#[test]
fn a_square_and_a_circle() {
    let square = Spline::fit(
        &xy("0 0, 1 0, 1 1, 0 1"),
        &FitOptions::new(0.01).closed(true),
    )
    .expect("finite");
    assert!(square.is_closed());
    assert_eq!((square.segment_count(), corners(&square).len()), (4, 4));
    let point = |k: usize| DVec2::from_angle(real(k).to_radians());
    let circle: Vec<DVec2> = (0..360).map(point).collect();
    let circle = Spline::fit(&circle, &FitOptions::new(1e-3).closed(true)).expect("finite");
    assert!(circle.segment_count() <= 5, "{}", circle.segment_count());
    let g1 = |k: usize| circle.continuity_within(k, 1e-9).expect("a joint").g1;
    assert!((0..circle.segment_count()).all(g1));
}

#[test]
fn strokes_with_noise() {
    let mut rng = Rng(43);
    for _ in 0..50 {
        let (spline, _) = known(&mut rng, 4, false);
        let tolerance = 0.02;
        let mut noise = || rng.point(2).truncate() * (0.5 * tolerance);
        let points = spline.sample(60).expect("samples");
        let noisy: Vec<DVec2> = points.iter().map(|&p| p + noise()).collect();
        let fitted = fit(&noisy, tolerance);
        assert!(farthest(&dense(&fitted, 1e-4), &noisy, tolerance) <= 1.01 * tolerance);
        assert!(fitted.segment_count() <= 24, "{}", fitted.segment_count());
    }
}

#[test]
fn space_as_well() {
    let point = |t: f64| DVec3::new(t.cos(), t.sin(), 0.2 * t);
    let helix: Vec<DVec3> = (0..2000).map(|k| point(real(k) * 0.01)).collect();
    let fitted = Spline::fit(&helix, &FitOptions::new(1e-3)).expect("finite");
    let line = fitted.flatten(1e-4).expect("flat").points;
    for &p in &helix {
        near(from_polyline(p, &line), 0.0, 1.2e-3);
    }
    assert!(fitted.segment_count() < 30, "{}", fitted.segment_count());
}

/// A wave from 0 to 100 by a hundred thousand points: a tenth of it needs about a tenth of the segments, and far fewer
/// than it has points.
#[test]
fn many_points() {
    let segments = |count: usize| {
        let wave = |t: f64| DVec2::new(t, (3.0 * t).sin() + 0.2 * (11.0 * t).cos());
        let points: Vec<DVec2> = (0..count).map(|k| wave(real(k) * 1e-3)).collect();
        fit(&points, 1e-3).segment_count()
    };
    let (few, many) = (segments(10_000), segments(100_000));
    assert!(few < 1_000 && many <= 12 * few, "{few} and {many} segments");
}

#[test]
fn simplified_splines_are_close_in_both_directions() {
    let mut rng = Rng(47);
    for case in 0..300 {
        let count = 1 + rng.below(6);
        let (spline, sharp) = known(&mut rng, count, case % 2 == 0);
        let mut cut = spline.clone();
        for k in (0..spline.segment_count()).rev() {
            for part in [0.8, 0.6, 0.3] {
                cut = cut.insert(real(k) + part).expect("inside");
            }
        }
        let tolerance = rng.magnitude(-5.0, -1.5);
        let simple = cut.simplify(tolerance).expect("finite");
        assert!(simple.segment_count() <= cut.segment_count());
        let sag = 0.01 * tolerance;
        let (a, b) = (dense(&cut, sag), dense(&simple, sag));
        let apart = farthest(&a, &b, tolerance).max(farthest(&b, &a, tolerance));
        assert!(apart <= 1.02 * tolerance, "{case}: {apart} for {tolerance}");
        let found = corners(&simple);
        let kept = |p: &DVec2| found.iter().any(|q| (*q - *p).length() < 1e-9);
        assert!(sharp.iter().all(kept), "{case}");
        let count = simple.segment_count();
        assert!(
            tolerance <= 1e-3 || count < cut.segment_count(),
            "{case}: {count}"
        );
    }
}

#[test]
fn simplifying_what_is_simple() {
    let point = spline("1 1, 1 1, 1 1, 1 1", 3, false);
    assert_eq!(point.simplify(0.1), Ok(point));
    let one = spline("0 0, 1 3, 4 3, 5 0", 3, false);
    assert_eq!(one.simplify(0.001), Ok(one));
    let large = spline("0 0, 1e9 3e9, 4e9 3e9, 5e9 0", 3, false);
    assert_eq!(
        large.simplify(1e6).map(|simple| simple.segment_count()),
        Ok(1)
    );
}
