//! Widths that change at joints and in steps, on segments that are shorter than the stroke is wide.

use crate::stroke::variable::wrong;
use crate::support::paths::path;
use crate::support::{Rng, real};
use casteljau::glam::DVec2;
use casteljau::path::{
    FillRule, Join, StrokeCap, StrokeOptions, WidthInterpolation, WidthPosition, WidthProfile,
};
use casteljau::{Path, Spline};
use std::f64::consts::{FRAC_PI_2, PI, TAU};

/// Segments of about the length 1 that turn to both sides, some of them with tight turns at their ends.
fn short_segments(rng: &mut Rng) -> Spline<DVec2> {
    let mut points = vec![DVec2::new(rng.signed(), rng.signed()) * 100.0];
    let mut degrees = Vec::new();
    let mut angle = rng.unit() * TAU;
    for _ in 0..3 + rng.below(4) {
        let start = points[points.len() - 1];
        let end = start + DVec2::from_angle(angle) * rng.magnitude(-1.0, 0.5);
        let length = start.distance(end);
        let degree = 1 + rng.below(3);
        let turns = [angle + rng.signed(), angle + rng.signed()];
        for k in 1..degree {
            let handle = length * rng.pick(&[0.02, 0.3, 0.6]);
            points.push(if k == 1 {
                start + DVec2::from_angle(turns[0]) * handle
            } else {
                end - DVec2::from_angle(turns[1]) * handle
            });
        }
        points.push(end);
        degrees.push(degree);
        angle = match rng.below(3) {
            0 => turns[1],
            1 => angle + PI * rng.signed(),
            _ => angle + 0.3 * rng.signed(),
        };
    }
    Spline::with_degrees(points, &degrees, false).expect("finite points")
}

/// The positions of the joints, some of them moved by a little.
fn joints(spline: &Spline<DVec2>, at: WidthPosition, rng: &mut Rng) -> Vec<f64> {
    let count = spline.segment_count();
    let position = |k: usize| match at {
        WidthPosition::T => real(k) / real(count),
        _ => spline.split(real(k)).0.length() / spline.length(),
    };
    let inner: Vec<f64> = (1..count).map(position).collect();
    let mut all = vec![0.0, 1.0];
    for position in inner {
        for _ in 0..1 + rng.below(2) {
            let by = rng.pick(&[0.0, 1e-16, 1e-14, 1e-12, 1e-10, 1e-8, 1e-4]);
            all.push(position + by * rng.signed());
        }
    }
    all.sort_by(f64::total_cmp);
    all.dedup();
    all
}

#[test]
fn short_segments_are_covered() {
    let mut rng = Rng(31);
    let mut faults = Vec::new();
    for case in 0..crate::support::cases(60, 1_000) {
        let spline = short_segments(&mut rng);
        let width = rng.magnitude(-0.5, 1.0);
        let at = rng.pick(&[WidthPosition::T, WidthPosition::Length]);
        let is_constant = rng.unit() < 0.2;
        let stops: Vec<(f64, f64)> = joints(&spline, at, &mut rng)
            .into_iter()
            .map(|position| {
                let part = if is_constant { 1.0 } else { 1.0 + rng.unit() };
                (position, width * part)
            })
            .collect();
        let interpolation = rng.pick(&[WidthInterpolation::Linear, WidthInterpolation::Smooth]);
        let profile = WidthProfile::new(&stops)
            .at(at)
            .interpolation(interpolation);
        let tolerance = width * rng.magnitude(-5.0, -2.0);
        let found = wrong(&Path::from(spline), &profile, tolerance, &mut rng);
        if let Some(first) = found.first() {
            let count = found.len();
            faults.push(format!(
                "{case}: {profile:?} {tolerance:e}: {count}, {first}"
            ));
        }
    }
    assert!(faults.is_empty(), "{}\n{}", faults.len(), faults.join("\n"));
}

/// A stop next to a joint cuts off a piece of the curve whose control points are rounding errors.
#[test]
fn stops_next_to_joints_leave_no_holes() {
    // Both segments have a common tangent, and the first one turns sharply at its end.
    let path = path(
        "M211 276C210.98644184638633 275.9389883087385 210.98644184638633 272.0610116912615 211 272\
         C211.36621441371685 270.3520351382742 212.8062870566386 269.1937129433614 214 268",
    );
    let spline = path.subpath(0).expect("a subpath");
    let joint = spline.split(1.0).0.length() / spline.length();
    let options = StrokeOptions::new()
        .join(Join::Round)
        .cap(StrokeCap::Round)
        .tolerance(0.15);
    for interpolation in [WidthInterpolation::Linear, WidthInterpolation::Smooth] {
        for distance in -200..=200 {
            let position = joint + f64::from(distance) * 3e-15;
            let profile = WidthProfile::new(&[(0.0, 7.8), (position, 7.83), (1.0, 7.64)])
                .interpolation(interpolation);
            let outline = path.stroke_with(&profile, &options).expect("few segments");
            assert_eq!(outline.subpath_count(), 1, "{distance}");
        }
    }
}

/// For every join, the region agrees with the distances from the path.
#[test]
fn short_segments_have_all_joins() {
    let mut rng = Rng(32);
    let mut faults = Vec::new();
    for case in 0..crate::support::cases(60, 1_000) {
        let path = Path::from(short_segments(&mut rng));
        let width = rng.magnitude(-0.5, 1.0);
        let tolerance = width * rng.magnitude(-5.0, -2.0);
        let join = rng.pick(&[Join::Miter, Join::Round, Join::Bevel]);
        let cap = rng.pick(&[StrokeCap::Butt, StrokeCap::Round, StrokeCap::Square]);
        let options = StrokeOptions::new()
            .join(join)
            .cap(cap)
            .tolerance(tolerance);
        let outline = path.stroke(width, &options).expect("few segments");
        let contains = |p, width| path.stroke_contains(p, width, &options).expect("finite");
        let spline = path.subpath(0).expect("a subpath");
        for _ in 0..60 {
            let center = spline.eval(rng.unit() * real(spline.segment_count()));
            let p = center + DVec2::from_angle(rng.unit() * TAU) * (0.7 * width * rng.unit());
            let expected = contains(p, width);
            // Far from the boundary only.
            let is_far = (0..12).all(|k| {
                let by = DVec2::from_angle(TAU * f64::from(k) / 12.0) * 2.1 * tolerance;
                contains(p + by, width) == expected
            }) && [-4.2, 4.2].map(|k| contains(p, width + k * tolerance))
                == [expected; 2];
            if is_far && outline.contains(p, FillRule::NonZero) != expected {
                faults.push(format!("{case}: {join:?} {cap:?} {width}: {p} {expected}"));
            }
        }
    }
    assert!(faults.is_empty(), "{}\n{}", faults.len(), faults.join("\n"));
}

/// Two discs with almost the same centre are both part of the stroke.
#[test]
fn steps_have_their_area() {
    let line = path("M1 2L7 10");
    let options = StrokeOptions::new()
        .join(Join::Round)
        .cap(StrokeCap::Round)
        .tolerance(1e-6);
    // The part of the half disc of radius 3 that the stroke of width 2 covers.
    let common = 8.0_f64.sqrt() + 9.0 * (1.0_f64 / 3.0).asin();
    for distance in [2.0_f64.powi(-53), 1e-15, 1e-13, 1e-11, 1e-9] {
        for at in [WidthPosition::T, WidthPosition::Length] {
            for interpolation in [WidthInterpolation::Linear, WidthInterpolation::Smooth] {
                for narrow in [0.0, 0.5, 1.0 - distance] {
                    let from = (narrow > 0.0).then_some((0.0, 2.0));
                    let to = (narrow + distance < 1.0).then_some((1.0, 6.0));
                    let step = [(narrow, 2.0), ((narrow + distance).min(1.0), 6.0)];
                    let mut stops: Vec<(f64, f64)> =
                        from.into_iter().chain(step).chain(to).collect();
                    if stops.windows(2).any(|pair| pair[0].0 >= pair[1].0) {
                        continue; // nothing is between
                    }
                    let mut area = 9.0 * PI + 60.0 * (1.0 - narrow);
                    if narrow > 0.0 {
                        area += 20.0 * narrow + FRAC_PI_2 - common;
                    }
                    for _ in 0..2 {
                        let profile = WidthProfile::new(&stops)
                            .at(at)
                            .interpolation(interpolation);
                        let outline = line.stroke_with(&profile, &options).unwrap();
                        assert!(
                            (outline.area() - area).abs() < 1e-4,
                            "{profile:?} {} {area}",
                            outline.area()
                        );
                        // The same stroke the other way around.
                        stops.reverse();
                        stops.iter_mut().for_each(|stop| stop.0 = 1.0 - stop.0);
                    }
                }
            }
        }
    }
}
