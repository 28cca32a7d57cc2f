//! Points in strokes, compared with the outlines of the strokes, and offsets of regions.

use crate::stroke::cases::{hard, size};
use crate::stroke::round::{WIDTHS, samples};
use crate::support::paths::{path, points};
use crate::support::{Rng, de_casteljau, near};
use casteljau::glam::DVec2;
use casteljau::path::{FillRule, Join, OffsetOptions, StrokeCap, StrokeOptions};
use casteljau::{Path, Spline};
use std::f64::consts::{FRAC_PI_6, PI};

const JOINS: [Join; 3] = [Join::Miter, Join::Round, Join::Bevel];
const CAPS: [StrokeCap; 3] = [StrokeCap::Butt, StrokeCap::Round, StrokeCap::Square];

/// A curve followed by two lines, so that there are corners.
fn with_corners(curve: &Path) -> Path {
    let end = curve.segments().last().expect("a curve").end();
    let [a, b] = [DVec2::new(0.3, 0.1), DVec2::new(0.05, 0.5)].map(|by| end + by * size(curve));
    path(&format!("{curve} L{} {} L{} {}", a.x, a.y, b.x, b.y))
}

/// What is wrong with a stroke: at most one of random points.
fn fault(path: &Path, width: f64, options: &StrokeOptions, rng: &mut Rng) -> Option<String> {
    let tolerance = options.tolerance.expect("a tolerance");
    let outline = path.stroke(width, options).expect("few segments");
    let contains = |p, width| path.stroke_contains(p, width, options).expect("finite");
    let is_wrong = |p: &DVec2| {
        let expected = contains(*p, width);
        if outline.contains(*p, FillRule::NonZero) == expected {
            return false;
        }
        // Points within the tolerance of the exact outline: a slightly wider or narrower stroke differs.
        let wider = [-2.1, 2.1].map(|k| contains(*p, (width + k * tolerance).max(0.0)));
        let reach = 1.05 * tolerance + 1e-8 * size(path);
        let directions = (0..12).map(|k| DVec2::from_angle(f64::from(k) * FRAC_PI_6));
        let mut around = directions.map(|direction| contains(*p + direction * reach, width));
        wider == [expected; 2] && around.all(|inside| inside == expected)
    };
    let samples = samples(path, 0.5 * width, tolerance, rng);
    let wrong = samples.into_iter().find(is_wrong)?;
    Some(format!("{width} {options:?}: {wrong}"))
}

/// Outlines and `stroke_contains` do not share code beyond the checks and the miter limit; they must agree.
#[test]
fn outlines_agree_with_distances_for_all_joins_and_caps() {
    let mut rng = Rng(23);
    let mut faults = Vec::new();
    for (name, curve) in hard() {
        let corners = with_corners(&curve);
        for (path, part) in WIDTHS.iter().flat_map(|w| [(&curve, w), (&corners, w)]) {
            for (k, (join, cap)) in JOINS.iter().flat_map(|j| CAPS.map(|c| (*j, c))).enumerate() {
                let options = StrokeOptions::new()
                    .join(join)
                    .cap(cap)
                    .tolerance([1e-2, 1e-4, 1e-6][k % 3] * size(path))
                    .simple(k % 2 == 0);
                let fault = fault(path, part * size(path), &options, &mut rng);
                faults.extend(fault.map(|fault| format!("{name} {fault}")));
            }
        }
    }
    assert!(faults.is_empty(), "{}\n{}", faults.len(), faults.join("\n"));
}

#[test]
fn points_beside_a_curve_that_is_straight_up_to_rounding() {
    // Closed, of two curves whose control points are nearly collinear and of sizes from 2 to 8e7; p is a joint.
    let points = points(
        "2.293001427718777 2.6800938339283125  269.7565905261779 288.8833979346312
         824.3294071199924 882.312107272538  46.258028396659434 49.72551046727527
         3.757624361809797 4.247334909289066  19.503008921453667 21.095912693263134
         1.9253438819124815 2.2866765290084197  11166568.991231292 -83482084.75
         11166568.248407602 -83482079.125  1.9253438860177994 2.25
         1.9253438860177994 2.25  11166568.991231292 -83482084.75",
    );
    let (p, second) = (points[11], [&points[6..], &points[..1]].concat());
    let distances = (0..=1000).map(|k| de_casteljau(&second, f64::from(k) * 1e-3).distance(p));
    let nearest = distances.fold(f64::INFINITY, f64::min);
    let spline = Spline::with_degrees(points, &[6, 6], true).expect("valid points");
    let options = StrokeOptions::new().join(Join::Round).cap(StrokeCap::Round);
    for (width, expected) in [(2.02 * nearest, true), (1.98 * nearest, false)] {
        let inside = Path::from(spline.clone()).stroke_contains(p, width, &options);
        assert_eq!(inside, Ok(expected), "{width}");
    }
}

#[test]
fn points_in_dashes() {
    let options = StrokeOptions::new().dash(&[3.0, 2.0], 0.0);
    let locations = points("1 0.5  4 0  5.5 -0.9  5.5 -1.1").into_iter();
    for (p, expected) in locations.zip([true, false, true, false]) {
        let inside = path("M0 0H10").stroke_contains(p, 2.0, &options);
        assert_eq!(inside, Ok(expected), "{p}");
    }
}

#[test]
fn regions_grow_and_shrink_whatever_their_orientation() {
    let frame = path("M0 0H10V10H0Z M2 2V8H8V2Z");
    for path in [frame.clone(), frame.reverse()] {
        let area = |distance, join| {
            let tolerance = Some(1e-7);
            let mut options = OffsetOptions::new().join(join);
            options.tolerance = tolerance;
            path.offset(distance, &options).unwrap().area()
        };
        for (join, outer) in JOINS.into_iter().zip([144.0, 140.0 + PI, 142.0]) {
            near(area(1.0, join), outer - 16.0, 1e-5);
            near(area(0.0, join), 64.0, 1e-9);
            near(area(-1.5, join), 0.0, 1e-9);
        }
        let hole = 49.0;
        near(area(-0.5, Join::Miter), 81.0 - hole, 1e-5);
        near(area(4.0, Join::Miter), 324.0, 1e-5);
    }
}

/// An open subpath is closed first, and self-crossings do not matter.
#[test]
fn regions_of_open_and_crossing_paths() {
    let (corner, options) = (path("M0 0H4V4H0"), OffsetOptions::default());
    let grown = corner.offset(1.0, &options).expect("few segments");
    near(grown.area(), 36.0, 1e-6);
    let twice = path("M0 0H4V4H0Z M2 2H6V6H2Z");
    let shrunk = twice.offset(-0.5, &options).expect("few segments");
    near(shrunk.area(), 9.0 + 9.0 - 1.0, 1e-6);
    assert!(corner.offset(f64::NAN, &options).is_err());
    assert!(corner.offset(f64::MAX, &options).is_err());
}
