//! Conversions from and to kurbo.
#![cfg(feature = "kurbo")]

use crate::support::paths::path;
use casteljau::curve::{Cubic, Line, Quad};
use casteljau::glam::DVec2;
use casteljau::path::FillRule;
use casteljau::{Curve, Error, Path, Spline};
use kurbo::{BezPath, Circle, CubicBez, ParamCurve, PathSeg, QuadBez, Shape};

const TEXT: &str = "M0,0 L1,0.5 Q2,3 4,4 C5,4 6,3 6,2 Z M8,8 L9,8";

#[test]
fn a_path_comes_back_from_kurbo() {
    let path = path(TEXT);
    let there = BezPath::from(&path);
    assert_eq!(there.segments().count(), path.segment_count());
    assert_eq!(BezPath::from(path.clone()), there);
    assert_eq!(Path::try_from(there), Ok(path));
}

#[test]
fn segments_have_the_same_points() {
    let path = path(TEXT);
    for curve in path.segments() {
        let segment = PathSeg::try_from(&curve).expect("a degree up to 3");
        let (ours, theirs) = (curve.eval(0.3), segment.eval(0.3));
        assert!((ours - DVec2::new(theirs.x, theirs.y)).length() < 1e-14);
        assert_eq!(Curve::try_from(segment), Ok(curve.clone()));
        assert_eq!(BezPath::from(&curve), BezPath::from(&Spline::from(curve)));
    }
}

#[test]
fn curves_of_fixed_degrees_are_the_same() {
    let [a, b, c, d] = [(0.0, 0.0), (1.0, 2.0), (3.0, 1.0), (4.0, 5.0)].map(DVec2::from);
    let cubic = Cubic::new(a, b, c, d).expect("finite");
    let theirs = CubicBez::from(cubic);
    assert_eq!(Cubic::try_from(theirs), Ok(cubic));
    assert_eq!(CubicBez::try_from(&Curve::from(cubic)), Ok(theirs));
    assert_eq!(theirs.eval(0.5).x, cubic.eval(0.5).x);
    let line = Line::new(a, b).expect("finite");
    assert_eq!(Line::try_from(kurbo::Line::from(line)), Ok(line));
    let quad = Quad::new(a, b, c).expect("finite");
    assert_eq!(Quad::try_from(QuadBez::from(quad)), Ok(quad));
    let refused = QuadBez::try_from(&Curve::from(cubic));
    assert!(matches!(refused, Err(Error::Range { what: "degree", .. })));
}

#[test]
fn what_kurbo_cannot_hold_is_refused_or_approximated() {
    let quartic = Curve::new(&[DVec2::ZERO, DVec2::X, DVec2::ONE, DVec2::Y, DVec2::ZERO]);
    let quartic = quartic.expect("a curve");
    let Error::Range { what, got, .. } = PathSeg::try_from(&quartic).expect_err("degree 4") else {
        panic!("another error");
    };
    assert_eq!((what, got), ("degree", 4.0));
    let cubics = BezPath::from(&quartic);
    assert!(cubics.segments().count() > 1);
    let mut wrong = BezPath::new();
    wrong.move_to((0.0, 0.0));
    wrong.line_to((f64::INFINITY, 0.0));
    let error = Path::try_from(&wrong);
    assert!(matches!(error, Err(Error::NotFinite { .. })));
}

#[test]
fn shapes_become_outlines() {
    let circle = Circle::new((1.0, 2.0), 3.0);
    let path = Path::from_kurbo(&circle, 1e-9).expect("finite");
    assert!((path.area() - circle.area()).abs() < 1e-6);
    assert!(path.contains(DVec2::new(1.0, 2.0), FillRule::NonZero));
}
