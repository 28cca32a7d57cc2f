//! Curves from points without a `Result`, from arrays, and under `*`.

use crate::support::{bezier, refused, xy};
use casteljau::Curve;
use casteljau::curve::Bounds;
use casteljau::glam::{DAffine2, DAffine3, DVec2, DVec3};

#[test]
fn constructors_of_low_degrees_are_those_of_slices() {
    let p: [DVec2; 4] = xy("0 0, 1 3, 2 -1, 4 2").try_into().expect("four");
    let [p0, p1, p2, p3] = p;
    assert_eq!(Ok(Curve::line(p0, p1)), Curve::new(&p[..2]));
    assert_eq!(Ok(Curve::quad(p0, p1, p2)), Curve::new(&p[..3]));
    assert_eq!(Ok(Curve::cubic(p0, p1, p2, p3)), Curve::new(&p));
    assert_eq!(Curve::try_from(p), Curve::new(&p));
    refused(Curve::try_from([p0]), "Count points 1");
}

#[test]
#[should_panic(expected = "p1: expected coordinates from")]
fn a_line_to_nowhere_panics() {
    _ = Curve::line(DVec2::ZERO, DVec2::new(f64::NAN, 0.0));
}

#[test]
fn maps_multiply() {
    let curve = bezier("0 0, 1 3, 2 -1, 4 2");
    let map = DAffine2::from_angle(0.5) * DAffine2::from_translation(DVec2::new(3.0, 1.0));
    assert_eq!(map * &curve, curve.transform(&map).expect("a finite image"));
    let space = Curve::line(DVec3::ZERO, DVec3::new(1.0, 2.0, 3.0));
    let map = DAffine3::from_scale(DVec3::splat(2.0));
    assert_eq!((map * &space).end(), DVec3::new(2.0, 4.0, 6.0));
    let quarter_turn = DAffine2::from_cols(DVec2::Y, -DVec2::X, DVec2::new(10.0, 0.0));
    assert_eq!(quarter_turn * &bezier("1 2, 3 4"), bezier("8 1, 6 3"));
}

#[test]
fn bounds_unite_intersect_and_contain() {
    let bounds = |corners: &str| {
        let corners = xy(corners);
        Bounds {
            min: corners[0],
            max: corners[1],
        }
    };
    let (a, b) = (bounds("0 0, 4 2"), bounds("3 1, 6 5"));
    assert_eq!(a.union(b), bounds("0 0, 6 5"));
    assert_eq!(a.intersection(b), Some(bounds("3 1, 4 2")));
    assert_eq!(a.intersection(bounds("5 0, 6 1")), None);
    assert_eq!(a.intersection(bounds("4 2, 5 3")), Some(bounds("4 2, 4 2")));
    assert!(xy("4 0, 1 1").into_iter().all(|p| a.contains(p)));
    assert!(!xy("1 2.5, -1e-300 1").into_iter().any(|p| a.contains(p)));
}
