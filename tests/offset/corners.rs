//! Corners of fitted splines: those of known shapes are kept, noise adds none.

use crate::offset::reference::{dense, farthest};
use crate::support::measure::from_polyline;
use crate::support::{Rng, bezier, real, refused, spline};
use casteljau::Spline;
use casteljau::glam::DVec2;
use casteljau::spline::FitOptions;
use std::f64::consts::{PI, TAU};

/// Points along a closed polygon, `count` on each edge.
fn along(polygon: &[DVec2], count: usize) -> Vec<DVec2> {
    let ends = polygon.iter().zip(polygon.iter().cycle().skip(1));
    ends.flat_map(|(&a, &b)| (0..count).map(move |k| a.lerp(b, real(k) / real(count))))
        .collect()
}

fn with_noise(rng: &mut Rng, points: &[DVec2], size: f64) -> Vec<DVec2> {
    let moved = |&p: &DVec2| p + DVec2::new(rng.signed(), rng.signed()) * size;
    points.iter().map(moved).collect()
}

fn regular(count: usize) -> Vec<DVec2> {
    let angle = |k: usize| TAU * real(k) / real(count);
    (0..count)
        .map(|k| DVec2::from_angle(angle(k)) * 200.0)
        .collect()
}

fn star() -> Vec<DVec2> {
    let radius = |k: usize| if k.is_multiple_of(2) { 200.0 } else { 90.0 };
    let point = |k: usize| DVec2::from_angle(TAU * real(k) / 10.0) * radius(k);
    (0..10).map(point).collect()
}

/// The joints where the tangent turns, also at the start of a closed spline.
pub(crate) fn corners(spline: &Spline<DVec2>) -> Vec<DVec2> {
    let sharp = |k: &usize| !spline.continuity_within(*k, 1e-6).expect("a joint").g1;
    let joints = usize::from(!spline.is_closed())..spline.segment_count();
    joints.filter(sharp).map(|k| spline.eval(real(k))).collect()
}

/// The largest turn of the direction within an arc length, by small steps.
fn sharpest_turn(spline: &Spline<DVec2>, length: f64) -> f64 {
    let points = spline.sample(64).expect("few");
    let steps = points.windows(2).map(|p| p[1] - p[0]);
    let steps: Vec<DVec2> = steps.filter(|step| step.length() > 1e-9).collect();
    let (mut s, mut angle) = (0.0, 0.0);
    let mut turned = vec![(0.0, 0.0)];
    for pair in steps.windows(2) {
        s += pair[0].length();
        angle += pair[0].angle_to(pair[1]);
        turned.push((s, angle));
    }
    let mut first = 0;
    let mut sharpest: f64 = 0.0;
    for (k, &(s, angle)) in turned.iter().enumerate() {
        while turned[first].0 < s - length {
            first += 1;
        }
        for &(_, before) in &turned[first..k] {
            sharpest = sharpest.max((angle - before).abs());
        }
    }
    sharpest
}

pub(crate) fn is_within(spline: &Spline<DVec2>, points: &[DVec2], tolerance: f64) {
    let off = farthest(&dense(spline, 0.01 * tolerance), points, tolerance);
    assert!(off <= 1.02 * tolerance, "{off} for {tolerance}");
}

#[test]
fn polygons_keep_exactly_their_corners() {
    let mut rng = Rng(83);
    let shapes = [regular(4), regular(6), regular(8), star()];
    for (shape, polygon) in shapes.iter().enumerate() {
        // With fewer points on an edge, those of a hexagon or an octagon may be a circle's.
        for count in [2, 5, 30, 200, 1000] {
            for (noise, tolerance) in [(0.0, 1.0), (0.0, 0.1), (0.5, 1.0), (0.5, 3.0)] {
                let seeds = if noise == 0.0 || count == 1000 { 1 } else { 8 };
                for seed in 0..seeds {
                    let what = format!("shape {shape}, {count}, ±{noise}, {tolerance}, {seed}");
                    let points = with_noise(&mut rng, &along(polygon, count), noise);
                    let fitted = Spline::fit(&points, &FitOptions::new(tolerance).closed(true))
                        .expect("finite");
                    let found = corners(&fitted);
                    assert_eq!(found.len(), polygon.len(), "{what}");
                    for &corner in polygon {
                        let near = |p: &DVec2| (*p - corner).length() < 4.0 * (tolerance + noise);
                        assert!(found.iter().any(near), "{what}: none at {corner}");
                    }
                    is_within(&fitted, &points, tolerance);
                    if noise == 0.0 {
                        assert_eq!(fitted.segment_count(), polygon.len(), "{what}");
                    }
                }
            }
        }
    }
}

#[test]
fn a_sparse_square_or_star_has_corners_and_a_sparse_circle_has_none() {
    let count = |polygon: &[DVec2]| {
        let fitted = Spline::fit(polygon, &FitOptions::new(1.0).closed(true)).expect("finite");
        corners(&fitted).len()
    };
    // Only the outer turns of the star are above 75°, and the inner ones are not twice as large as those beside them.
    assert_eq!((count(&regular(4)), count(&star())), (4, 5));
    for n in [6, 8, 12, 40, 400] {
        assert_eq!(count(&regular(n)), 0, "{n}");
    }
}

/// Spirals as a mouse draws them, in whole pixels, and with noise: no corner, whether the tolerance is above the noise
/// or below.
#[test]
fn noise_on_smooth_strokes_is_no_corner() {
    let mut rng = Rng(89);
    for (turns, radius) in [(3.0, 300.0), (8.0, 300.0), (20.0, 500.0)] {
        let spiral = |k: usize| {
            let t = real(k) / 4999.0;
            DVec2::from_angle(TAU * turns * t) * (radius * t) + DVec2::splat(400.0)
        };
        let exact: Vec<DVec2> = (0..5000).map(spiral).collect();
        let rounded: Vec<DVec2> = exact.iter().map(|p| p.round()).collect();
        let needed = Spline::fit(&exact, &FitOptions::new(1.0)).expect("finite");
        for seed in 0..4 {
            let jittered = with_noise(&mut rng, &exact, 0.5);
            for (points, kind) in [(&rounded, "rounded"), (&jittered, "jittered")] {
                for tolerance in [0.5, 0.75, 1.0, 2.0, 4.0] {
                    let fitted = Spline::fit(points, &FitOptions::new(tolerance)).expect("finite");
                    let what = format!("{turns} turns {kind}, {tolerance}, {seed}");
                    assert_eq!(corners(&fitted).len(), 0, "{what}");
                    is_within(&fitted, points, tolerance);
                    if tolerance >= 1.0 {
                        let (got, needed) = (fitted.segment_count(), needed.segment_count());
                        assert!(got <= 3 * needed, "{what}: {got} and {needed} segments");
                    }
                }
            }
        }
    }
}

/// A wave whose smallest radius of curvature is 30: over 2 units it turns by at most 4°.
#[test]
fn noise_on_smooth_strokes_is_no_hook() {
    let mut rng = Rng(97);
    for count in [50, 500, 5000] {
        let wave = |k: usize| {
            let t = real(k) / real(count - 1);
            DVec2::new(800.0 * t, 150.0 * (12.0 * t).sin())
        };
        let exact: Vec<DVec2> = (0..count).map(wave).collect();
        for tolerance in [1.0, 2.0] {
            for _ in 0..10 {
                let points = with_noise(&mut rng, &exact, 0.5);
                let fitted = Spline::fit(&points, &FitOptions::new(tolerance)).expect("finite");
                let turn = sharpest_turn(&fitted, 2.0).to_degrees();
                assert!(turn < 45.0, "{count}, {tolerance}: {turn}°");
                is_within(&fitted, &points, tolerance);
            }
        }
    }
}

#[test]
fn circles_with_noise_close_smoothly() {
    let mut rng = Rng(101);
    for count in [40, 400, 4000] {
        for _ in 0..8 {
            let points = with_noise(&mut rng, &regular(count), 0.5);
            for tolerance in [0.5, 1.0, 2.0] {
                let fitted =
                    Spline::fit(&points, &FitOptions::new(tolerance).closed(true)).expect("finite");
                assert_eq!(corners(&fitted).len(), 0, "{count}, {tolerance}");
                is_within(&fitted, &points, tolerance);
            }
        }
    }
}

/// Long edges that turn by 20°, 50° and 100°.
#[test]
fn the_corner_angle_selects_corners() {
    let mut points = vec![DVec2::ZERO];
    let mut direction = DVec2::X;
    for turn in [0.0_f64, 20.0, 50.0, 100.0] {
        direction = DVec2::from_angle(turn.to_radians()).rotate(direction);
        let start = points[points.len() - 1];
        points.extend((1..=100).map(|k| start + direction * (3.0 * real(k))));
    }
    let count = |angle: Option<f64>| {
        let options = FitOptions::new(1.0);
        let options = angle.map_or(options, |angle| options.corner_angle(angle));
        let fitted = Spline::fit(&points, &options).expect("finite");
        is_within(&fitted, &points, 1.0);
        corners(&fitted).len()
    };
    let angles = [10.0_f64, 30.0, 70.0, 120.0].map(|angle| count(Some(angle.to_radians())));
    assert_eq!((angles, count(None)), ([3, 2, 1, 0], 2));
    for angle in [0.0, -1.0, 3.2, f64::NAN, f64::INFINITY] {
        refused(
            Spline::fit(&points, &FitOptions::new(1.0).corner_angle(angle)),
            "Range corner_angle",
        );
    }
    assert_eq!(count(Some(PI)), 0);
}

/// The derivative of this straight curve is zero at ½ and has the same sign on both sides.
#[test]
fn a_straight_curve_that_stops_goes_on() {
    let offset = bezier("0 0, -3 0, -2 0, -1 0, -4 0").offset(1.0);
    assert_eq!(offset, Ok(spline("0 -1, -4 -1", 1, false)));
}

/// Between two points at a distance L, a fitted spline stays within the tolerance plus L/6 of their edge.
#[test]
fn fits_of_sparse_points_stay_near_the_edges() {
    let mut rng = Rng(77);
    for round in 0..200 {
        let count = 5 + round % 30;
        // In order of x, so that the nearest place of a point is that after the one before it.
        let points: Vec<DVec2> = (0..count)
            .map(|k| DVec2::new(12.0 * real(k), 20.0 * rng.signed()))
            .collect();
        let tolerance = 0.2 + rng.signed().abs();
        let fitted = Spline::fit(&points, &FitOptions::new(tolerance)).expect("finite");
        let end = real(fitted.segment_count());
        let mut feet: Vec<f64> = points
            .iter()
            .map(|&p| fitted.nearest(p).expect("finite").t)
            .collect();
        (feet[0], feet[count - 1]) = (0.0, end);
        for (edge, t) in points.windows(2).zip(feet.windows(2)) {
            let length = edge[0].distance(edge[1]);
            let room = tolerance + (length / 6.0).max(0.25 * tolerance);
            for k in 0..=16 {
                let p = fitted.eval(t[0] + (t[1] - t[0]) * real(k) / 16.0);
                let distance = from_polyline(p, edge);
                assert!(distance <= room, "{round}: {distance} above {room}");
            }
        }
    }
}

/// A cubic that is straight but for more than the tolerance stays a cubic.
#[test]
fn lines_keep_a_fine_tolerance() {
    let points: Vec<DVec2> = (0..200)
        .map(|k| {
            let x = 4000.0 * real(k) / 199.0 - 2000.0;
            DVec2::new(x, 1e-6 * (x / 700.0).sin())
        })
        .collect();
    let tolerance = 1e-9;
    let fitted = Spline::fit(&points, &FitOptions::new(tolerance)).expect("finite");
    is_within(&fitted, &points, tolerance);
}

/// Noise within half the tolerance, on smooth strokes of 100 to 4000 points, takes at most 30 % more segments.
#[test]
fn noise_within_half_the_tolerance_takes_few_segments() {
    let mut rng = Rng(103);
    let (mut of_exact, mut of_noisy) = (0, 0);
    for round in 0..crate::support::cases(60, 5_000) {
        let count = [100, 400, 1500, 4000][round % 4];
        let [a, b, c, d] = [(); 4].map(|()| rng.unit());
        let wave = |k: usize| {
            let t = 4.0 * real(k) / real(count);
            let x = 100.0 * t + 60.0 * (3.0 * a * t + 6.0 * b).sin();
            let y = 100.0 * c * (4.0 * d * t).sin() + 20.0 * b * (13.0 * c * t).sin();
            DVec2::new(x, y)
        };
        let exact: Vec<DVec2> = (0..count).map(wave).collect();
        let options = FitOptions::new(1.0);
        let mut in_disc = || DVec2::from_angle(TAU * rng.unit()) * (0.5 * rng.unit().sqrt());
        let noisy: Vec<DVec2> = exact.iter().map(|&p| p + in_disc()).collect();
        let [own, other] =
            [&exact, &noisy].map(|points| Spline::fit(points, &options).expect("finite"));
        is_within(&other, &noisy, 1.0);
        of_exact += own.segment_count();
        of_noisy += other.segment_count();
    }
    let ratio = real(of_noisy) / real(of_exact);
    println!("{of_noisy} segments with noise, {of_exact} without: {ratio}");
    assert!(ratio <= 1.3, "{ratio}");
}
