//! Strokes with different widths on both sides: closed forms, and points compared with the normals of the path.

use crate::support::paths::path;
use crate::support::{Rng, near};
use casteljau::Path;
use casteljau::curve::Curve;
use casteljau::glam::DVec2;
use casteljau::path::{FillRule, StrokeCap, StrokeOptions};
use casteljau::spline::Join;
use std::f64::consts::PI;

fn fine() -> StrokeOptions {
    StrokeOptions::new().tolerance(1e-6)
}

fn sides(d: &str, [left, right]: [f64; 2], options: &StrokeOptions) -> Path {
    path(d)
        .stroke_sides(left, right, options)
        .expect("a stroke")
}

#[test]
fn of_a_line_with_each_cap() {
    for [left, right] in [[3.0, 1.0], [0.0, 2.0], [2.0, 0.0], [0.1, 20.0]] {
        let width = left + right;
        for (cap, ends) in [
            (StrokeCap::Butt, 0.0),
            (StrokeCap::Square, width * width),
            (StrokeCap::Round, 0.25 * PI * width * width),
        ] {
            let result = sides("M0 0H10", [left, right], &fine().cap(cap));
            near(result.area(), 10.0 * width + ends, 1e-4);
            let bounds = result.bounds().expect("a region");
            near(bounds.max.y, left, 1e-6);
            near(bounds.min.y, -right, 1e-6);
            // A path that is a point has caps along the x-axis.
            let dot = sides("M0 0H0", [left, right], &fine().cap(cap));
            near(dot.area(), ends, 1e-4);
            if let Some(bounds) = dot.bounds() {
                near(bounds.max.y, left, 1e-6);
            }
        }
    }
}

#[test]
fn of_a_corner_with_each_join() {
    for [left, right] in [[3.0_f64, 1.0], [1.0, 3.0], [0.0, 2.0], [2.0, 0.0]] {
        for (d, outer) in [("M0 0H10V10", right), ("M0 0H10V-10", left)] {
            let inner: f64 = left + right - outer;
            let whole = (10.0 + outer).powi(2) - (10.0 - inner).powi(2);
            for (join, missing) in [
                (Join::Miter, 0.0),
                (Join::Bevel, 0.5 * outer * outer),
                (Join::Round, (1.0 - 0.25 * PI) * outer * outer),
            ] {
                let result = sides(d, [left, right], &fine().join(join));
                near(result.area(), whole - missing, 1e-4);
            }
        }
    }
}

/// A circle from which the stroke extends inwards by less than the radius, by more, and beyond the other side.
#[test]
fn of_a_circle_with_wide_insides() {
    let circle = Path::circle(DVec2::ZERO, 5.0).expect("a circle");
    let clockwise: Path = circle.subpaths().map(|spline| spline.reverse()).collect();
    for inside in [0.0, 1.0, 4.5, 5.0, 7.0, 12.0, 14.0] {
        let outside = 2.0_f64;
        let hole: f64 = if inside < 5.0 { 5.0 - inside } else { 0.0 };
        // What reaches beyond the centre covers the disc of the radius `inside` − 5.
        let radius = (5.0 + outside).max(inside - 5.0);
        for (path, [left, right]) in [
            (&circle, [inside, outside]),
            (&clockwise, [outside, inside]),
        ] {
            let result = path.stroke_sides(left, right, &fine()).expect("a stroke");
            near(result.area(), PI * (radius * radius - hole * hole), 2e-3);
        }
    }
}

#[test]
fn what_turns_back_has_the_wider_half_disk() {
    for [left, right] in [[2.0_f64, 1.0], [1.0, 2.0], [2.0, 0.0]] {
        let (wide, narrow) = (left.max(right), left.min(right));
        let half_disk = 0.5 * PI * wide * wide;
        let area = 6.25 * (wide + narrow) + 2.25 * (wide - narrow) + half_disk;
        let options = fine().join(Join::Round);
        // A curve and lines from 0 to 6.25 and back to 4.
        for d in ["M0 0Q10 0 4 0", "M0 0H6.25H4"] {
            near(sides(d, [left, right], &options).area(), area, 1e-4);
        }
    }
}

#[test]
fn equal_widths_are_a_stroke_of_both() {
    for d in ["M0 0C40 60 60 -60 100 0", "M0 0H10V10Z M3 3Q9 0 3 8"] {
        for cap in [StrokeCap::Butt, StrokeCap::Round, StrokeCap::Square] {
            let options = StrokeOptions::new().cap(cap);
            let stroke = path(d).stroke(6.0, &options).expect("a stroke");
            assert_eq!(sides(d, [3.0, 3.0], &options), stroke);
        }
    }
    assert!(sides("M0 0H10", [0.0, 0.0], &fine()).is_empty());
}

#[test]
fn dashes_have_caps_of_their_own() {
    let options = fine().cap(StrokeCap::Round).dash(&[4.0, 6.0], 0.0);
    let result = sides("M0 0H20", [1.5, 0.5], &options);
    assert_eq!(result.subpath_count(), 2);
    near(result.area(), 2.0 * (8.0 + PI), 1e-4);
}

/// By how much a point is inside of the stroke of a curve with butt caps, by dense samples of its normals; negative
/// outside. Positive if a normal on the left is shorter than its width by that much, or one on the right.
fn depth(curve: &Curve<DVec2>, p: DVec2, [left, right]: [f64; 2]) -> f64 {
    let along = |t: f64| (curve.eval(t) - p).dot(curve.tangent(t));
    let mut best = f64::NEG_INFINITY;
    let count = 1000;
    for k in 0..count {
        let (mut a, mut b) = (
            f64::from(k) / f64::from(count),
            f64::from(k + 1) / f64::from(count),
        );
        let (from, to) = (along(a), along(b));
        if from * to > 0.0 {
            continue;
        }
        for _ in 0..50 {
            let middle = 0.5 * (a + b);
            if along(middle) * from > 0.0 {
                a = middle;
            } else {
                b = middle;
            }
        }
        let signed = (p - curve.eval(a)).dot(curve.normal(a));
        best = best.max(if signed >= 0.0 {
            left - signed
        } else {
            right + signed
        });
    }
    best
}

/// Curves whose normals on one side are longer than the radius of curvature: what is swept backwards is covered.
#[test]
fn points_are_covered_if_a_normal_reaches_them() {
    let mut rng = Rng(4711);
    let mut checked = [0, 0];
    for case in 0..60 {
        let point = |rng: &mut Rng| DVec2::new(rng.unit(), rng.unit()) * 10.0;
        let points: Vec<DVec2> = (0..3 + case % 3).map(|_| point(&mut rng)).collect();
        let curve = Curve::new(&points).expect("points");
        let widths = [[6.0, 0.5], [0.0, 4.0], [9.0, 2.0]][case / 3 % 3];
        let outline = |simple: bool| {
            Path::from(curve.clone())
                .stroke_sides(
                    widths[0],
                    widths[1],
                    &StrokeOptions::new().tolerance(1e-3).simple(simple),
                )
                .expect("a stroke")
        };
        let (region, overlapping) = (outline(true), outline(false));
        for _ in 0..60 {
            let p = DVec2::new(rng.unit(), rng.unit()) * 30.0 - DVec2::splat(10.0);
            let depth = depth(&curve, p, widths);
            // At the ends of the butt caps, the depth jumps.
            let near_end = |t: f64| (p - curve.eval(t)).dot(curve.tangent(t)).abs() < 0.02;
            if depth.abs() < 0.02 || near_end(0.0) || near_end(1.0) {
                continue;
            }
            let expected = depth > 0.0;
            checked[usize::from(expected)] += 1;
            for (what, result) in [("simple", &region), ("overlapping", &overlapping)] {
                let contains = result.contains(p, FillRule::NonZero);
                assert_eq!(
                    contains, expected,
                    "{what} {case}: {p:?}, depth {depth}, {points:?}"
                );
            }
        }
    }
    assert!(checked.iter().all(|&count| count > 300), "{checked:?}");
}
