//! Freehand strokes, judged by the discs of their own centre line and widths.

use crate::stroke::variable::{Discs, width};
use crate::support::{Rng, near, real};
use casteljau::glam::DVec2;
use casteljau::path::{FillRule, InkOptions, InkPressure, InkSample, InkStroke};
use casteljau::{Path, Spline};
use std::f64::consts::{PI, TAU};

/// Samples of a hand: waves, loops and sudden turns, with the noise of whole pixels.
fn hand(rng: &mut Rng, count: usize) -> Vec<DVec2> {
    let (mut p, mut angle, mut bend) = (DVec2::new(200.0, 150.0), rng.unit() * TAU, 0.0);
    let mut speed: f64 = 3.0;
    let mut points = Vec::new();
    for _ in 0..count {
        if rng.unit() < 0.05 {
            bend = 0.4 * rng.signed();
        }
        if rng.unit() < 0.02 {
            angle += PI * rng.signed();
        }
        speed = (speed * (1.0 + 0.4 * rng.signed())).clamp(0.3, 25.0);
        angle += bend * speed.min(4.0) / 4.0;
        p += DVec2::from_angle(angle) * speed;
        points.push(p.round());
    }
    points
}

fn ink(options: &InkOptions, points: &[DVec2]) -> InkStroke {
    let mut ink = InkStroke::new(options).expect("valid options");
    for &p in points {
        ink.append(p, InkSample::default()).expect("valid samples");
    }
    ink
}

fn kinds() -> [InkOptions; 4] {
    [
        InkOptions::new(8.0),
        InkOptions::new(16.0).taper(40.0, 90.0).tolerance(0.1),
        InkOptions::new(30.0).thinning(-0.9),
        InkOptions::new(6.0)
            .streamline(0.0)
            .smoothing(0.0)
            .thinning(1.0),
    ]
}

fn tolerance(options: &InkOptions) -> f64 {
    options.tolerance.unwrap_or(0.025 * options.size)
}

/// The contours of all changes, with those that are open at the end.
fn changes(options: &InkOptions, points: &[DVec2], every: usize) -> (Path, InkStroke) {
    let mut ink = InkStroke::new(options).expect("valid options");
    let mut settled: Vec<Spline<DVec2>> = Vec::new();
    let mut open = Path::default();
    for (k, &p) in points.iter().enumerate() {
        ink.append(p, InkSample::default()).expect("valid samples");
        if k % every == 0 || k + 1 == points.len() {
            let changes = ink.changes(&[]).expect("few segments");
            settled.extend(changes.settled.subpaths());
            open = changes.open;
        }
    }
    (settled.into_iter().chain(open.subpaths()).collect(), ink)
}

#[test]
fn outlines_are_those_of_the_discs() {
    let mut rng = Rng(21);
    let mut faults = Vec::new();
    for round in 0..crate::support::cases(6, 500) {
        for (kind, options) in kinds().iter().enumerate() {
            let points = hand(&mut rng, 120);
            let (parts, ink) = changes(options, &points, 1 + round % 7);
            let outline = ink.outline().expect("few segments");
            let path = Path::from(ink.spline().expect("samples"));
            let discs = Discs::new(&path, &ink.widths());
            // The chords of the dense points are within 1e-3 of the curves here.
            let limit = tolerance(options) + 1e-3;
            for spline in outline.subpaths() {
                for p in spline.sample(3).unwrap() {
                    let distance = discs.distance(p);
                    if distance.abs() > limit {
                        faults.push(format!("{round} {kind}: boundary at {p}: {distance}"));
                    }
                }
            }
            for _ in 0..60 {
                let (center, radius) = discs.0[rng.below(discs.0.len())];
                let p = center + DVec2::from_angle(rng.unit() * TAU) * radius * (2.0 * rng.unit());
                let distance = discs.distance(p);
                // Inside of overlapping contours, gaps thinner than two tolerances can be left.
                if distance.abs() <= 2.0 * limit {
                    continue;
                }
                let winding = outline.winding_number(p);
                if winding != i32::from(distance < 0.0) {
                    faults.push(format!(
                        "{round} {kind}: outline at {p}: {winding}, {distance}"
                    ));
                }
                if parts.contains(p, FillRule::NonZero) != (distance < 0.0) {
                    faults.push(format!("{round} {kind}: parts at {p}: {distance}"));
                }
            }
        }
    }
    assert!(faults.is_empty(), "{}\n{}", faults.len(), faults.join("\n"));
}

#[test]
fn the_centre_line_passes_the_samples_within_the_tolerance() {
    let mut rng = Rng(22);
    for _ in 0..crate::support::cases(10, 2_000) {
        let points = hand(&mut rng, 200);
        let options = InkOptions::new(4.0)
            .streamline(0.0)
            .smoothing(0.0)
            .tolerance(0.5);
        let spline = ink(&options, &points).spline().expect("samples");
        assert_eq!(spline.eval(0.0), points[0]);
        assert_eq!(spline.eval(real(spline.segment_count())), points[199]);
        for &p in &points {
            let distance = spline.nearest(p).unwrap().distance;
            assert!(distance <= 0.5 + 1e-9, "{p}: {distance}");
        }
        assert!(spline.segment_count() < 199);
    }
}

#[test]
fn a_long_stroke_changes_at_its_end_only() {
    let spiral = |k: usize| DVec2::from_angle(real(k) * 0.05) * (200.0 + 0.02 * real(k));
    let mut ink = InkStroke::new(&InkOptions::new(10.0).taper(100.0, 100.0)).unwrap();
    let mut most = 0;
    for k in 0..20_000 {
        ink.append(spiral(k), InkSample::default()).unwrap();
        if k % 50 == 0 {
            let changes = ink.changes(&[]).unwrap();
            most = most.max(changes.open.segment_count() + changes.settled.segment_count());
        }
    }
    assert!(most <= 200, "{most}");
    // A straight line never needs a joint, but runs have a bounded length.
    let mut ink = InkStroke::new(&InkOptions::new(10.0)).unwrap();
    for k in 0..2_000 {
        ink.append(DVec2::new(real(k), 0.0), InkSample::default())
            .unwrap();
    }
    let spline = ink.spline().unwrap();
    assert!(
        (4..40).contains(&spline.segment_count()),
        "{}",
        spline.segment_count()
    );
    assert!(spline.degrees().iter().all(|&degree| degree == 1));
}

/// Along a line, pressures from 0 to 1 give widths from size·(1 − thinning) to size·(1 + thinning).
#[test]
fn widths_follow_the_pressure_of_the_device() {
    let options = InkOptions::new(10.0)
        .streamline(0.0)
        .smoothing(0.0)
        .thinning(0.6)
        .pressure(InkPressure::Device);
    let mut ink = InkStroke::new(&options).unwrap();
    for k in 0..=50 {
        let sample = InkSample {
            pressure: Some(real(k) / 50.0),
            time: None,
        };
        ink.append(DVec2::new(4.0 * real(k), 7.0), sample).unwrap();
    }
    let widths = ink.widths();
    for (position, expected) in [(0.0, 4.0), (0.5, 10.0), (1.0, 16.0)] {
        near(width(&widths, position), expected, 0.25);
    }
    assert!(widths.stops.len() < 10);
}

#[test]
fn simulated_pressure_follows_the_speed_and_not_the_rate_of_samples() {
    let middle = |step: f64, times: bool| {
        let mut ink = InkStroke::new(&InkOptions::new(10.0)).unwrap();
        let mut x = 0.0;
        while x <= 400.0 {
            // 5 sizes in each 10 ms, up to the middle; a tenth of the size after it.
            let speed = if x < 200.0 { 5.0 } else { 0.1 };
            let time = if x < 200.0 {
                x / speed
            } else {
                40.0 + (x - 200.0) / speed
            };
            let sample = InkSample {
                pressure: None,
                time: times.then_some(time),
            };
            ink.append(DVec2::new(x, 0.0), sample).unwrap();
            x += step;
        }
        let widths = ink.widths();
        [0.4, 0.95].map(|position| width(&widths, position))
    };
    let ([fast, slow], [fast_too, slow_too]) = (middle(1.0, true), middle(5.0, true));
    assert!(fast < 5.5 && slow > 13.5, "{fast} {slow}");
    near(fast, fast_too, 0.3);
    near(slow, slow_too, 0.3);
    // Without times, 5 units are half of the size in 10 ms.
    near(middle(5.0, false)[1], 10.0, 0.3);
}

#[test]
fn tapers_end_in_points_and_fill_short_strokes() {
    let options = InkOptions::new(10.0).thinning(0.0).taper(30.0, 60.0);
    let line = |length: usize| -> Vec<DVec2> {
        (0..=length / 5)
            .map(|k| DVec2::new(5.0 * real(k), 0.0))
            .collect()
    };
    let widths = ink(&options, &line(300)).widths();
    for (position, expected) in [
        (0.0, 0.0),
        (0.1, 10.0),
        (0.5, 10.0),
        (0.8, 10.0),
        (1.0, 0.0),
    ] {
        near(width(&widths, position), expected, 1e-9);
    }
    // Half of a taper has the width x(2 − x).
    near(width(&widths, 0.05), 7.5, 1e-9);
    let widths = ink(&options, &line(45)).widths();
    near(width(&widths, 1.0 / 3.0), 10.0, 1e-9);
    near(width(&widths, 1.0), 0.0, 1e-9);
}

#[test]
fn predicted_positions_are_open_and_leave_no_trace() {
    let points = hand(&mut Rng(4), 60);
    let next = points[59] + DVec2::new(30.0, 0.0);
    let mut with = ink(&InkOptions::new(6.0), &points);
    let mut without = with.clone();
    let predicted = with
        .changes(&[points[59] + DVec2::new(15.0, 0.0), next])
        .unwrap();
    let plain = without.changes(&[]).unwrap();
    assert!(predicted.settled.approx_eq(&plain.settled, 1e-9));
    assert!(predicted.open.contains(next, FillRule::NonZero));
    assert!(!plain.open.contains(next, FillRule::NonZero));
    assert_eq!(with.outline(), without.outline());
    assert!(with.changes(&[DVec2::NAN]).is_err());
}

#[test]
fn points_and_short_strokes_are_defined() {
    let options = InkOptions::new(10.0).taper(5.0, 5.0);
    let none = InkStroke::new(&options).unwrap();
    assert_eq!(none.outline().unwrap(), Path::default());
    assert!(none.spline().is_none());
    let p = DVec2::new(3.0, 4.0);
    let mut dot = ink(&options, &[p; 5]);
    for outline in [dot.outline().unwrap(), dot.changes(&[]).unwrap().open] {
        near(outline.area(), PI * 25.0, 2.0);
        assert!(outline.contains(p, FillRule::NonZero));
    }
    assert_eq!(dot.spline().unwrap().length(), 0.0);
    let line = ink(&options.taper(0.0, 0.0).thinning(0.0), &[p, p + 20.0]);
    let length = 20.0 * 2.0_f64.sqrt();
    near(
        line.outline().unwrap().area(),
        10.0 * length + PI * 25.0,
        2.0,
    );
    // There and back.
    let back = ink(&options, &[p, p + 20.0, p]);
    assert_eq!(back.spline().unwrap().segment_count(), 2);
    assert!(back.outline().unwrap().area() > 10.0);
}
