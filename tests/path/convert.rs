//! Paths from curves, splines and path data, and back to path data.

use casteljau::glam::{DAffine2, DVec2};
use casteljau::{Curve, Path, Spline};

const TEXT: &str = "M0,0 L1,0.5 Q2,3 4,4 C5,4 6,3 6,2 Z M8,8 L9,8";

#[test]
fn text_is_read_and_written() {
    let path: Path = TEXT.parse().expect("path data");
    assert_eq!(path, Path::from_svg(TEXT).expect("path data"));
    assert_eq!(path.to_string().parse(), Ok(path.clone()));
    assert_eq!(
        format!("{path:.1}"),
        path.to_svg(Some(1), None).expect("no tolerance")
    );
    assert_eq!("M0,0 L1".parse::<Path>(), Path::from_svg("M0,0 L1"));
}

#[test]
fn splines_are_collected() {
    let path: Path = TEXT.parse().expect("path data");
    assert_eq!(path.subpaths().collect::<Path>(), path);
    let mut longer = path.clone();
    longer.extend(path.subpath(1));
    assert_eq!(
        (longer.subpath_count(), longer.subpath(2)),
        (3, path.subpath(1))
    );
    assert_eq!(std::iter::empty().collect::<Path>(), Path::default());
}

#[test]
fn a_curve_is_a_spline_and_a_path() {
    let curve = Curve::quad(DVec2::ZERO, DVec2::new(1.0, 2.0), DVec2::new(3.0, 0.0));
    let spline = Spline::from(curve.clone());
    assert_eq!(
        (spline.segment(0), spline.segment(1)),
        (Some(curve.clone()), None)
    );
    assert!(!spline.is_closed());
    assert_eq!(Path::from(curve), Path::from(spline));
}

#[test]
fn maps_multiply() {
    let path: Path = TEXT.parse().expect("path data");
    let map = DAffine2::from_angle(1.0);
    assert_eq!(map * &path, path.transform(&map));
    let spline = path.subpath(0).expect("a subpath");
    assert_eq!(map * &spline, spline.transform(&map));
}
