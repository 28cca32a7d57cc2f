//! Circles, ellipses, arcs, rectangles and polygons.

use crate::support::near;
use casteljau::Path;
use casteljau::glam::DVec2;
use std::f64::consts::{FRAC_PI_2, PI, TAU};

fn xy(x: f64, y: f64) -> DVec2 {
    DVec2::new(x, y)
}

/// The largest difference between the radius and the distance of points of a path from a point.
fn off_circle(path: &Path, center: DVec2, radius: f64) -> f64 {
    let points = path
        .segments()
        .flat_map(|curve| curve.sample(32).expect("few"));
    points
        .map(|p| (p.distance(center) - radius).abs())
        .fold(0.0, f64::max)
}

#[test]
fn circles_keep_their_tolerance() {
    let (center, radius) = (xy(3.0, -2.0), 5.0);
    for (tolerance, count) in [
        (None, 8),
        (Some(2.73e-4 * radius), 4),
        (Some(1e-9 * radius), 36),
    ] {
        let mut builder = Path::builder();
        if let Some(tolerance) = tolerance {
            builder.arc_tolerance(tolerance);
        }
        let circle = builder.circle(center, radius).build().expect("a circle");
        let max = tolerance.unwrap_or(4.3e-6 * radius);
        assert!(off_circle(&circle, center, radius) <= max, "{tolerance:?}");
        assert_eq!(circle.segment_count(), count, "{tolerance:?}");
        near(circle.area(), PI * radius * radius, 10.0 * radius * max);
        let bounds = circle.bounds().expect("not empty");
        assert_eq!([bounds.min, bounds.max], [xy(-2.0, -7.0), xy(8.0, 3.0)]);
        assert_eq!(circle.subpath(0).expect("one").eval(0.0), xy(8.0, -2.0));
    }
}

#[test]
fn ellipses_are_images_of_circles() {
    let (radii, angle) = (xy(3.0, 1.0), 0.5);
    let ellipse = Path::ellipse(xy(1.0, 2.0), radii, angle).expect("an ellipse");
    near(ellipse.area(), PI * 3.0, 1e-4);
    for curve in ellipse.segments() {
        for p in curve.sample(16).expect("few") {
            let local = DVec2::from_angle(-angle).rotate(p - xy(1.0, 2.0)) / radii;
            near(local.length(), 1.0, 1e-5);
        }
    }
}

#[test]
fn arcs_have_their_length_and_direction() {
    for (from, to) in [
        (0.0, FRAC_PI_2),
        (0.3, 2.0),
        (1.0, -2.0),
        (0.0, TAU),
        (2.0, 2.0),
    ] {
        let arc = Path::arc(xy(1.0, 1.0), 2.0, from, to).expect("an arc");
        near(arc.length(), 2.0 * f64::abs(to - from), 1e-4);
        let spline = arc.subpath(0).expect("a subpath");
        assert!(!spline.is_closed());
        for (t, angle) in [(0.0, from), (spline.segment_count() as f64, to)] {
            let expected = xy(1.0, 1.0) + DVec2::from_angle(angle) * 2.0;
            near(spline.eval(t).distance(expected), 0.0, 1e-15 * 8.0);
        }
        if to != from {
            let turn = spline.tangent(0.0).dot(DVec2::from_angle(from).perp());
            near(turn, (to - from).signum(), 1e-9);
        }
    }
    let quarter = Path::arc(DVec2::ZERO, 1.0, 0.0, FRAC_PI_2).expect("an arc");
    assert_eq!(
        quarter.segments().last().map(|curve| curve.end()),
        Some(DVec2::Y)
    );
}

#[test]
fn rectangles() {
    let plain = Path::rect(xy(1.0, 2.0), xy(3.0, 4.0)).expect("a rectangle");
    assert_eq!(plain.to_svg(), "M1,2 L4,2 L4,6 L1,6 Z");
    let round = Path::rounded_rect(xy(1.0, 2.0), xy(3.0, 4.0), [0.5, 0.0, 1.0, 0.25]);
    let round = round.expect("a rectangle");
    let corners: f64 = [0.5, 1.0, 0.25]
        .iter()
        .map(|r| r * r * (1.0 - PI / 4.0))
        .sum();
    near(round.area(), 12.0 - corners, 1e-4);
    assert_eq!(round.bounds(), plain.bounds());
    // Radii that do not fit are reduced together: this is a slot with half circles.
    let slot = Path::rounded_rect(DVec2::ZERO, xy(6.0, 2.0), [5.0; 4]).expect("a slot");
    near(slot.area(), 8.0 + PI, 1e-4);
    let lines = slot.segments().filter(|curve| curve.degree() == 1);
    assert_eq!(lines.count(), 2);
}

#[test]
fn polygons_and_shapes_without_extent() {
    let corners = [(0.0, 0.0), (4.0, 0.0), (0.0, 3.0)].map(DVec2::from);
    let triangle = Path::polygon(&corners).expect("a polygon");
    assert_eq!((triangle.area(), triangle.length()), (6.0, 12.0));
    assert_eq!(Path::polygon(&[]), Ok(Path::default()));
    for point in [
        Path::circle(DVec2::ONE, 0.0),
        Path::rect(DVec2::ONE, DVec2::ZERO),
        Path::polygon(&[DVec2::ONE]),
    ] {
        let point = point.expect("a point");
        assert_eq!((point.subpath_count(), point.length()), (1, 0.0));
        assert_eq!(
            point.segments().next().map(|curve| curve.start()),
            Some(DVec2::ONE)
        );
    }
}
