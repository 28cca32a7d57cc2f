//! Curves from points without a `Result`, from arrays, and under `*`.

use casteljau::curve::Bounds;
use casteljau::glam::{DAffine2, DAffine3, DVec2, DVec3};
use casteljau::{Curve, Error};

const P: [DVec2; 4] = [
    DVec2::new(0.0, 0.0),
    DVec2::new(1.0, 3.0),
    DVec2::new(2.0, -1.0),
    DVec2::new(4.0, 2.0),
];

#[test]
fn constructors_of_low_degrees_are_those_of_slices() {
    let [p0, p1, p2, p3] = P;
    assert_eq!(Ok(Curve::line(p0, p1)), Curve::new(&P[..2]));
    assert_eq!(Ok(Curve::quad(p0, p1, p2)), Curve::new(&P[..3]));
    assert_eq!(Ok(Curve::cubic(p0, p1, p2, p3)), Curve::new(&P));
    assert_eq!(Curve::try_from(P), Curve::new(&P));
    assert!(matches!(
        Curve::try_from([p0]),
        Err(Error::Count { got: 1, .. })
    ));
}

#[test]
#[should_panic(expected = "p1: expected coordinates from")]
fn a_line_to_nowhere_panics() {
    _ = Curve::line(DVec2::ZERO, DVec2::new(f64::NAN, 0.0));
}

#[test]
fn maps_multiply() {
    let curve = Curve::new(&P).expect("a cubic");
    let map = DAffine2::from_angle(0.5) * DAffine2::from_translation(DVec2::new(3.0, 1.0));
    assert_eq!(map * &curve, curve.transform(&map).expect("a finite image"));
    let space = Curve::line(DVec3::ZERO, DVec3::new(1.0, 2.0, 3.0));
    let map = DAffine3::from_scale(DVec3::splat(2.0));
    assert_eq!((map * &space).end(), DVec3::new(2.0, 4.0, 6.0));
}

#[test]
fn bounds_unite_intersect_and_contain() {
    let bounds = |x0: f64, y0: f64, x1: f64, y1: f64| Bounds {
        min: DVec2::new(x0, y0),
        max: DVec2::new(x1, y1),
    };
    let (a, b) = (bounds(0.0, 0.0, 4.0, 2.0), bounds(3.0, 1.0, 6.0, 5.0));
    assert_eq!(a.union(b), bounds(0.0, 0.0, 6.0, 5.0));
    assert_eq!(a.intersection(b), Some(bounds(3.0, 1.0, 4.0, 2.0)));
    assert_eq!(a.intersection(bounds(5.0, 0.0, 6.0, 1.0)), None);
    let corner = bounds(4.0, 2.0, 5.0, 3.0);
    assert_eq!(a.intersection(corner), Some(bounds(4.0, 2.0, 4.0, 2.0)));
    assert!(a.contains(DVec2::new(4.0, 0.0)) && a.contains(DVec2::new(1.0, 1.0)));
    assert!(!a.contains(DVec2::new(1.0, 2.5)) && !a.contains(DVec2::new(-1e-300, 1.0)));
}
