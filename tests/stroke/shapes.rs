//! Closed forms: strokes of lines, corners, points and circles with each kind of join and cap.

use crate::support::near;
use casteljau::Path;
use casteljau::glam::DVec2;
use casteljau::path::{FillRule, Join, StrokeCap, StrokeOptions};
use std::f64::consts::PI;

const TOLERANCE: f64 = 1e-6;

fn read(d: &str) -> Path {
    Path::from_svg_with(d, 1e-9).expect("path data")
}

fn options(join: Join, cap: StrokeCap) -> StrokeOptions {
    StrokeOptions::new()
        .join(join)
        .cap(cap)
        .tolerance(TOLERANCE)
}

fn area(d: &str, width: f64, options: &StrokeOptions) -> f64 {
    let outline = read(d).stroke(width, options).expect("few segments");
    outline.area()
}

fn assert_near(got: f64, expected: f64) {
    near(got, expected, 1e-4);
}

#[test]
fn areas_of_lines_with_caps() {
    let with = |cap| area("M1 2H11", 4.0, &options(Join::Miter, cap));
    assert_near(with(StrokeCap::Butt), 40.0);
    assert_near(with(StrokeCap::Square), 56.0);
    assert_near(with(StrokeCap::Round), 40.0 + 4.0 * PI);
}

#[test]
fn areas_of_points_with_caps() {
    for d in ["M3 3H3", "M3 3Z", "M3 3C3 3 3 3 3 3", "M3 3H3H3"] {
        let with = |cap| area(d, 4.0, &options(Join::Miter, cap));
        assert_near(with(StrokeCap::Butt), 0.0);
        if !read(d).is_empty() {
            assert_near(with(StrokeCap::Square), 16.0);
            assert_near(with(StrokeCap::Round), 4.0 * PI);
        }
    }
}

#[test]
fn widths_that_rounding_swallows_give_the_empty_region() {
    for d in ["M5 5H5", "M5 5h1e-17", "M5 5H8", "M5 5L6 6 5 5"] {
        for cap in [StrokeCap::Butt, StrokeCap::Round, StrokeCap::Square] {
            for width in [1e-300, 1e-30, 1e-17] {
                let options = options(Join::Round, cap);
                for options in [options.clone(), options.simple(false)] {
                    let stroke = read(d).stroke(width, &options).expect("a region");
                    assert_near(stroke.area(), 0.0);
                    assert!(
                        !options.simple || stroke.is_empty(),
                        "{d} {width:e} {cap:?}"
                    );
                }
            }
        }
    }
}

/// Two legs of length 10 at an angle; what a join adds to the two rectangles of width 2 is known.
#[test]
fn areas_of_corners_with_joins() {
    for degrees in [20.0_f64, 60.0, 90.0, 120.0, 150.0, 170.0] {
        for side in [1.0, -1.0] {
            let turn = degrees.to_radians();
            let to = DVec2::X * 10.0 + DVec2::from_angle(side * turn) * 10.0;
            let path = format!("M0 0H10L{} {}", to.x, to.y);
            // The inner sides of the strips overlap.
            let half = (0.5 * turn).tan();
            if half > 10.0 {
                continue;
            }
            let with = |join, miter_limit| {
                let options = options(join, StrokeCap::Butt);
                area(&path, 2.0, &options.miter_limit(miter_limit))
            };
            let (strips, miter, bevel) = (40.0 - half, half, 0.5 * turn.sin());
            assert_near(with(Join::Miter, 100.0), strips + miter);
            assert_near(with(Join::Round, 4.0), strips + 0.5 * turn);
            assert_near(with(Join::Bevel, 4.0), strips + bevel);
            let limit = 1.0 / (0.5 * turn).cos();
            let below = with(Join::Miter, (limit * 0.999).max(1.0));
            assert_near(below, strips + bevel);
            assert_near(with(Join::Miter, limit * 1.001), strips + miter);
        }
    }
}

#[test]
fn a_path_that_turns_back() {
    let with = |join, cap| area("M0 0H10H4", 2.0, &options(join, cap));
    assert_near(with(Join::Round, StrokeCap::Butt), 20.0 + 0.5 * PI);
    assert_near(with(Join::Miter, StrokeCap::Butt), 20.0);
    assert_near(with(Join::Bevel, StrokeCap::Square), 22.0);
}

#[test]
fn closed_paths_have_joins_instead_of_caps() {
    let square = "M0 0H10V10H0Z";
    let with = |join, cap| area(square, 2.0, &options(join, cap));
    for cap in [StrokeCap::Butt, StrokeCap::Square, StrokeCap::Round] {
        assert_near(with(Join::Miter, cap), 144.0 - 64.0);
        assert_near(with(Join::Bevel, cap), 144.0 - 64.0 - 2.0);
        assert_near(with(Join::Round, cap), 140.0 - 64.0 + PI);
    }
    let stroke = |width| read(square).stroke(width, &StrokeOptions::default());
    let outline = stroke(2.0).expect("few segments");
    assert_eq!((outline.subpath_count(), outline.segment_count()), (2, 8));
    // Wider than the square: no hole is left.
    assert_near(stroke(20.5).expect("few segments").area(), 30.5 * 30.5);
}

/// A ring; a stroke wider than the circle fills it, because normals pass through the centre.
#[test]
fn circles() {
    let circle = "M5 0A5 5 0 1 1 -5 0A5 5 0 1 1 5 0Z";
    for join in [Join::Miter, Join::Bevel, Join::Round] {
        let with = |width| area(circle, width, &options(join, StrokeCap::Butt));
        assert_near(with(2.0), PI * (36.0 - 16.0));
        assert_near(with(12.0), PI * 121.0);
        assert_near(with(50.0), PI * 900.0);
    }
}

/// The normals of an arc of 90° and radius 5, 8 to both sides, pass through its centre: the stroke is a sector of
/// radius 13 and the opposite one of radius 3.
#[test]
fn normals_beyond_the_centre_of_an_arc() {
    let sectors = 0.25 * PI * (169.0 + 9.0);
    for simple in [true, false] {
        let options = options(Join::Miter, StrokeCap::Butt).simple(simple);
        let arc = read("M5 0A5 5 0 0 1 0 5");
        let outline = arc.stroke(16.0, &options).expect("few segments");
        let area = outline.filled_area(FillRule::NonZero);
        assert_near(area.expect("few segments"), sectors);
    }
}

#[test]
fn dashes_of_strokes() {
    let options = |cap, dash: &[f64]| options(Join::Miter, cap).dash(dash, 0.0);
    let dashes = area("M0 0H10", 2.0, &options(StrokeCap::Butt, &[3.0, 2.0]));
    assert_near(dashes, 12.0);
    // Dots: disks and squares along the path.
    let dots = area("M0 0L3 4", 1.0, &options(StrokeCap::Round, &[0.0, 2.0]));
    assert_near(dots, 3.0 * 0.25 * PI);
    let squares = read("M0 0L3 4").stroke(1.0, &options(StrokeCap::Square, &[0.0, 2.0]));
    let squares = squares.expect("few segments");
    assert_near(squares.area(), 3.0);
    assert!(squares.contains(DVec2::new(-0.1, 0.69), FillRule::NonZero));
    // No seam in the middle of a dash at the start of a closed path.
    let square = area("M0 0H4V4H0Z", 1.0, &options(StrokeCap::Butt, &[2.0, 2.0]));
    assert_near(square, 8.0);
}

#[test]
fn nothing_has_no_stroke() {
    let usual = StrokeOptions::default();
    assert_eq!(read("M0 0H10").stroke(0.0, &usual), Ok(Path::default()));
    assert_eq!(Path::default().stroke(1.0, &usual), Ok(Path::default()));
}
