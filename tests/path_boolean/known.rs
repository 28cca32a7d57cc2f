//! Results that are known exactly, and operations that cut.

use crate::path_boolean::check::{path, valid};
use crate::path_boolean::families::circle;
use casteljau::Path;
use casteljau::glam::DVec2;
use casteljau::path::{BooleanOperation, FillRule};

const RULE: FillRule = FillRule::NonZero;

#[test]
fn squares_side_by_side_become_one_outline() {
    let union = valid(path("M0 0H2V2H0Z").union(&path("M2 0H4V2H2Z"), RULE));
    assert_eq!((union.subpath_count(), union.area()), (1, 8.0));
    // The shared side is gone; the points at its ends are those of the input.
    assert_eq!(union.to_string(), "M0,0 L2,0 L4,0 L4,2 L2,2 L0,2 Z");
    let common = valid(path("M0 0H2V2H0Z").intersect(&path("M2 0H4V2H2Z"), RULE));
    assert!(common.is_empty());
}

#[test]
fn squares_that_touch_at_a_corner_stay_two_contours() {
    let union = valid(path("M0 0H2V2H0Z").union(&path("M2 2H4V4H2Z"), RULE));
    let expected = "M0,0 L2,0 L2,2 L0,2 Z M2,2 L4,2 L4,4 L2,4 Z";
    assert_eq!(union.to_string(), expected);
}

#[test]
fn a_hole_that_touches_its_outline_is_a_contour_of_its_own() {
    let square = path("M0 0H4V4H0Z");
    let result = valid(square.subtract(&path("M2 4L1 2H3Z"), RULE));
    assert_eq!((result.subpath_count(), result.area()), (2, 14.0));
    assert_eq!(result.subpath(0), square.subpath(0));
}

#[test]
fn open_subpaths_are_closed_and_empty_paths_are_empty() {
    let open = path("M0 0H2V2");
    let closed = valid(open.remove_overlaps(RULE));
    assert_eq!(closed.to_string(), "M0,0 L2,0 L2,2 Z");
    let nothing = Path::default();
    assert_eq!(valid(open.union(&nothing, RULE)).area(), 2.0);
    assert_eq!(valid(nothing.subtract(&open, RULE)), nothing);
    assert_eq!(valid(nothing.intersect(&nothing, RULE)), nothing);
    use BooleanOperation::{Exclude, Intersect, Union};
    for operation in [Union, Intersect, Exclude] {
        assert_eq!(valid(Path::combine([], operation, RULE)), nothing);
    }
}

#[test]
fn outlines_without_an_area_disappear() {
    let curves = ["M0 0C1 1 2 2 0.5 0.5Z", "M0 0C2 0 -1 0 1 0Z"];
    let lines = ["M0 0L1 1Z", "M0 0L2 1L1 0.5Z", "M1 1Z"];
    for d in lines.iter().chain(&curves) {
        assert!(valid(path(d).remove_overlaps(RULE)).is_empty(), "{d}");
        let square = path("M-1 -1H3V3H-1Z");
        assert_eq!(valid(square.union(&path(d), RULE)), square, "{d}");
    }
}

#[test]
fn combine_counts_all_paths() {
    let squares = ["M0 0H4V1H0Z", "M1 0H5V1H1Z", "M2 0H6V1H2Z"].map(path);
    let area = |operation| valid(Path::combine(&squares, operation, RULE)).area();
    assert_eq!(area(BooleanOperation::Union), 6.0);
    assert_eq!(area(BooleanOperation::Intersect), 2.0);
    // In one or three of them: [0, 1], [2, 4], [5, 6].
    assert_eq!(area(BooleanOperation::Exclude), 4.0);
}

#[test]
fn faces_cover_the_union_once() {
    let paths = [path("M0 0H4V4H0Z M1 1V3H3V1Z"), path("M2 -1H8V2H2Z")];
    let faces = Path::faces(&paths, RULE).expect("few segments");
    let total = |inside: [bool; 2]| -> f64 {
        let own = faces.iter().filter(|face| face.inside == inside);
        own.map(|face| face.path.area()).sum()
    };
    // The ring has area 12, the bar 18; they share [2, 4] × [0, 2] without [2, 3] × [1, 2].
    assert_eq!(total([true, true]), 3.0);
    assert_eq!(total([true, false]), 9.0);
    assert_eq!(total([false, true]), 15.0);
    assert_eq!(total([false, false]), 3.0);
}

#[test]
fn divide_cuts_along_open_and_closed_paths() {
    let square = path("M0 0H4V4H0Z");
    let areas = |cut: &str| -> Vec<f64> {
        let parts = square.divide(&path(cut), RULE).expect("few segments");
        let mut areas: Vec<f64> = parts.iter().map(Path::area).collect();
        areas.sort_by(f64::total_cmp);
        areas
    };
    assert_eq!(areas("M-1 1H5M1 -1V5"), [1.0, 3.0, 3.0, 9.0]);
    assert_eq!(areas("M1 1H3V3H1Z"), [4.0, 12.0]);
    assert_eq!(areas("M-1 1H3"), [16.0], "the cut ends inside");
    assert_eq!(areas("M5 5H6"), [16.0]);
    let ring = path("M0 0H4V4H0Z M1 1V3H3V1Z");
    let halves = ring.divide(&path("M2 -1V5"), RULE).expect("few segments");
    let areas: Vec<f64> = halves.iter().map(Path::area).collect();
    assert_eq!(areas, [6.0, 6.0]);
}

#[test]
fn clip_keeps_directions_and_closed_subpaths() {
    let region = path("M0 0H4V4H0Z");
    for (d, expected) in [
        ("M5 1H-1", "M4,1 L0,1"),
        ("M1 1H3V3", "M1,1 L3,1 L3,3"),
        ("M1 1H3V3Z", "M1,1 L3,1 L3,3 Z"),
        ("M5 5H6", ""),
        // The closed square starts inside; its parts join across the start.
        ("M2 2H6V3H2Z", "M4,3 L2,3 L2,2 L4,2"),
        // The boundary belongs to the region.
        ("M-1 0H5", "M0,0 L4,0"),
    ] {
        assert_eq!(valid(path(d).clip(&region, RULE)).to_string(), expected);
    }
}

#[test]
fn circles_that_touch_keep_their_segments() {
    let circles = [0.0, 2.0].map(|x| circle(DVec2::new(x, 0.0), 1.0));
    let union = valid(circles[0].union(&circles[1], RULE));
    assert_eq!(union, circles.iter().flat_map(Path::subpaths).collect());
}
