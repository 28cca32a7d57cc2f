//! Points in strokes, compared with the outlines of the strokes, and offsets of regions.

use crate::stroke::cases::{HARD, path, size};
use crate::stroke::round::{WIDTHS, samples};
use crate::support::Rng;
use casteljau::glam::DVec2;
use casteljau::path::{FillRule, OffsetOptions, StrokeCap, StrokeOptions};
use casteljau::spline::OffsetJoin;
use casteljau::{Path, Spline};

const JOINS: [OffsetJoin; 3] = [OffsetJoin::Miter, OffsetJoin::Round, OffsetJoin::Bevel];
const CAPS: [StrokeCap; 3] = [StrokeCap::Butt, StrokeCap::Round, StrokeCap::Square];

/// Whether a point is farther from all contours than a distance.
fn is_clear(outline: &Path, p: DVec2, distance: f64) -> bool {
    let nearest = outline.nearest(p).expect("finite");
    nearest.is_none_or(|nearest| nearest.distance > distance)
}

/// The points of the hard curves followed by two lines, so that there are corners.
fn with_corners(points: &[(f64, f64)]) -> Path {
    let curve = path(points);
    let far = size(&curve);
    let end = curve.subpath(0).expect("a subpath").eval(1.0);
    let mut text = curve.to_string();
    for by in [DVec2::new(0.3, 0.1), DVec2::new(0.05, 0.5)] {
        let to = end + by * far;
        text += &format!(" L{} {}", to.x, to.y);
    }
    text.parse().expect("path data")
}

/// Outlines and `stroke_contains` do not share code beyond the checks and the miter limit; they must agree.
#[test]
fn outlines_agree_with_distances_for_all_joins_and_caps() {
    let mut rng = Rng(23);
    let mut faults = Vec::new();
    for (name, points) in HARD {
        for (path, part) in WIDTHS
            .iter()
            .flat_map(|w| [(path(&points), w), (with_corners(&points), w)])
        {
            for (k, (join, cap)) in JOINS.iter().flat_map(|j| CAPS.map(|c| (*j, c))).enumerate() {
                let tolerance = [1e-2, 1e-4, 1e-6][k % 3] * size(&path);
                let width = part * size(&path);
                let options = StrokeOptions {
                    join,
                    cap,
                    tolerance: Some(tolerance),
                    simple: k % 2 == 0,
                    ..StrokeOptions::default()
                };
                let outline = path.stroke(width, &options).expect("few segments");
                for p in samples(&path, 0.5 * width, tolerance, &mut rng) {
                    let inside = outline.contains(p, FillRule::NonZero);
                    let expected = path.stroke_contains(p, width, &options).expect("finite");
                    if inside == expected {
                        continue;
                    }
                    // Points within the tolerance of the exact outline: a slightly wider or narrower stroke differs.
                    let wider = [-2.1, 2.1].map(|k| {
                        let width = (width + k * tolerance).max(0.0);
                        path.stroke_contains(p, width, &options).expect("finite")
                    });
                    let around = (0..12).any(|k| {
                        let q = p + DVec2::from_angle(f64::from(k) * std::f64::consts::FRAC_PI_6)
                            * (1.05 * tolerance + 1e-8 * size(&path));
                        path.stroke_contains(q, width, &options).expect("finite") != expected
                    });
                    if !around && wider == [expected; 2] {
                        let text = format!(
                            "{name} {width} {join:?} {cap:?} {tolerance:e} simple {}: {p} {expected}",
                            options.simple
                        );
                        faults.push(text);
                        break;
                    }
                }
            }
        }
    }
    assert!(faults.is_empty(), "{}\n{}", faults.len(), faults.join("\n"));
}

#[test]
fn points_beside_a_curve_that_is_straight_up_to_rounding() {
    // Closed, of two curves whose control points are nearly collinear and of sizes from 2 to 8e7; p is a joint.
    let points = [
        (2.293001427718777, 2.6800938339283125),
        (269.7565905261779, 288.8833979346312),
        (824.3294071199924, 882.312107272538),
        (46.258028396659434, 49.72551046727527),
        (3.757624361809797, 4.247334909289066),
        (19.503008921453667, 21.095912693263134),
        (1.9253438819124815, 2.2866765290084197),
        (11166568.991231292, -83482084.75),
        (11166568.248407602, -83482079.125),
        (1.9253438860177994, 2.25),
        (1.9253438860177994, 2.25),
        (11166568.991231292, -83482084.75),
    ];
    let points = points.map(DVec2::from).to_vec();
    let p = points[11];
    let spline = Spline::with_degrees(points, &[6, 6], true).expect("valid points");
    let path: Path = [spline].into_iter().collect();
    let nearest = (0..=1000)
        .map(|k| {
            path.segments()
                .nth(1)
                .expect("a curve")
                .eval(f64::from(k) * 1e-3)
        })
        .map(|q| q.distance(p))
        .fold(f64::INFINITY, f64::min);
    let options = StrokeOptions {
        join: OffsetJoin::Round,
        cap: StrokeCap::Round,
        ..StrokeOptions::default()
    };
    for (width, expected) in [(2.02 * nearest, true), (1.98 * nearest, false)] {
        let inside = path.stroke_contains(p, width, &options).expect("a width");
        assert_eq!(inside, expected, "{width}");
    }
}

#[test]
fn points_in_dashes() {
    let line: Path = "M0 0H10".parse().expect("path data");
    let options = StrokeOptions {
        dash: vec![3.0, 2.0],
        ..StrokeOptions::default()
    };
    let at = |x, y| {
        line.stroke_contains(DVec2::new(x, y), 2.0, &options)
            .expect("finite")
    };
    assert!(at(1.0, 0.5) && !at(4.0, 0.0) && at(5.5, -0.9) && !at(5.5, -1.1));
}

#[test]
fn regions_grow_and_shrink_whatever_their_orientation() {
    let frame: Path = "M0 0H10V10H0Z M2 2V8H8V2Z".parse().expect("path data");
    for path in [frame.clone(), frame.reverse()] {
        let area = |distance, join| {
            let options = OffsetOptions {
                join,
                tolerance: Some(1e-7),
                ..OffsetOptions::default()
            };
            path.offset(distance, &options)
                .expect("few segments")
                .area()
        };
        for join in JOINS {
            let outer = match join {
                OffsetJoin::Miter => 144.0,
                OffsetJoin::Round => 140.0 + std::f64::consts::PI,
                OffsetJoin::Bevel => 142.0,
            };
            assert!((area(1.0, join) - (outer - 16.0)).abs() < 1e-5, "{join:?}");
            assert!((area(0.0, join) - 64.0).abs() < 1e-9);
            assert!((area(-1.5, join)).abs() < 1e-9, "{join:?}");
            assert!(!is_clear(&path, DVec2::ONE, 2.0));
        }
        let hole = 49.0;
        assert!((area(-0.5, OffsetJoin::Miter) - (81.0 - hole)).abs() < 1e-5);
        assert!((area(4.0, OffsetJoin::Miter) - 324.0).abs() < 1e-5);
    }
}

/// An open subpath is closed first, and self-crossings do not matter.
#[test]
fn regions_of_open_and_crossing_paths() {
    let corner: Path = "M0 0H4V4H0".parse().expect("path data");
    let options = OffsetOptions::default();
    let grown = corner.offset(1.0, &options).expect("few segments");
    assert!((grown.area() - 36.0).abs() < 1e-6);
    let twice: Path = "M0 0H4V4H0Z M2 2H6V6H2Z".parse().expect("path data");
    let shrunk = twice.offset(-0.5, &options).expect("few segments");
    assert!(
        (shrunk.area() - (9.0 + 9.0 - 1.0)).abs() < 1e-6,
        "{}",
        shrunk.area()
    );
    assert!(corner.offset(f64::NAN, &options).is_err());
    assert!(corner.offset(f64::MAX, &options).is_err());
}
