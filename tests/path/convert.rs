//! Paths from curves, splines and path data, and back to path data.

use crate::support::paths::path;
use casteljau::glam::{DAffine2, DVec2};
use casteljau::path::SvgOptions;
use casteljau::{Curve, MAX_COORDINATE, Path, Spline};

const TEXT: &str = "M0,0 L1,0.5 Q2,3 4,4 C5,4 6,3 6,2 Z M8,8 L9,8";

#[test]
fn text_is_read_and_written() {
    let path = path(TEXT);
    assert_eq!(path, Path::from_svg(TEXT).expect("path data"));
    assert_eq!(path.to_string().parse(), Ok(path.clone()));
    let brief = path
        .to_svg_with(&SvgOptions::new().precision(1))
        .expect("no tolerance");
    assert_eq!(format!("{path:.1}"), brief);
    assert_eq!("M0,0 L1".parse::<Path>(), Path::from_svg("M0,0 L1"));
}

#[test]
fn splines_are_collected() {
    let path = path(TEXT);
    assert_eq!(path.subpaths().collect::<Path>(), path);
    let mut longer = path.clone();
    longer.extend(path.subpath(1));
    assert_eq!(longer.subpath_count(), 3);
    assert_eq!(longer.subpath(2), path.subpath(1));
    assert_eq!(std::iter::empty().collect::<Path>(), Path::default());
}

#[test]
fn a_curve_is_a_spline_and_a_path() {
    let curve = Curve::quad(DVec2::ZERO, DVec2::new(1.0, 2.0), DVec2::new(3.0, 0.0));
    let spline = Spline::from(curve.clone());
    assert!(spline.segments().eq([curve.clone()]));
    assert!(!spline.is_closed());
    assert_eq!(Path::from(curve), Path::from(spline));
}

#[test]
fn maps_multiply() {
    let path = path(TEXT);
    let map = DAffine2::from_angle(1.0);
    assert_eq!(Ok(map * &path), path.transform(&map));
    let spline = path.subpath(0).expect("a subpath");
    assert_eq!(Ok(map * &spline), spline.transform(&map));
}

/// Coordinates beyond the limit are refused, and everything up to it has an answer.
#[test]
fn coordinates_up_to_the_limit() {
    let triangle = |x: f64| Path::from_svg(&format!("M0,{x}L{x},-{x}L-{x},-{x}Z"));
    let error = triangle(f64::MAX).expect_err("too large").to_string();
    assert!(error.contains("from -2^500 to 2^500"), "{error}");
    let path = triangle(MAX_COORDINATE).expect("at the limit");
    assert_eq!(path.self_intersections(), []);
    assert_eq!(path.intersections(&path).len(), 1, "an overlap");
    let region = path.remove_overlaps(casteljau::path::FillRule::NonZero);
    assert_eq!(region.expect("few segments").segment_count(), 3);
}

#[test]
#[should_panic(expected = "image[0]: expected a finite number")]
fn an_operator_cannot_return_an_error() {
    let path = path("M1 2L3 4");
    _ = DAffine2::from_scale(DVec2::splat(f64::INFINITY)) * &path;
}
