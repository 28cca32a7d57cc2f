//! What constructors, queries and changes of splines refuse.

use crate::spline::random;
use crate::support::{Rng, all_refused, refused, spline};
use casteljau::Spline;
use casteljau::glam::{DVec2, DVec3};
use casteljau::spline::Interpolation::{self, CatmullRom, Natural};
use casteljau::spline::JointMode::G1;
#[cfg(target_family = "wasm")]
use wasm_bindgen_test::wasm_bindgen_test as test;

#[test]
fn constructors() {
    let points = vec![DVec2::ZERO; 7];
    let bad = [DVec2::ZERO, DVec2::ONE, DVec2::new(0.0, f64::NAN)];
    let with_degrees =
        |degrees: &[usize], closed| Spline::with_degrees(points.clone(), degrees, closed).err();
    for degree in [0, 65, usize::MAX] {
        all_refused([
            (Spline::new(&points, degree, false).err(), "Range degree"),
            (with_degrees(&[3, degree], false), "Range degrees"),
            (
                Spline::from_bspline(&points, degree, None, false).err(),
                "Range degree",
            ),
        ]);
    }
    all_refused([
        (with_degrees(&[], false), "Count points 7"),
        (with_degrees(&[3], false), "Count points 7"),
        (with_degrees(&[3, 2], false), "Count points 7"),
        (with_degrees(&[3, 3], true), "Count points 7"),
        (Spline::new(&bad, 2, false).err(), "NotFinite points 2"),
        (
            Spline::from_bspline(&bad, 1, None, false).err(),
            "NotFinite points 2",
        ),
        (
            Spline::from_bspline(&points, 7, None, false).err(),
            "Count points 7",
        ),
        (
            Spline::<DVec2>::from_bspline(&[], 1, None, true).err(),
            "Count points 0",
        ),
        (
            Spline::interpolate(&bad, Natural, false).err(),
            "NotFinite points 2",
        ),
    ]);
    let through = |count, kind: Interpolation| Spline::interpolate(&points[..count], kind, true);
    for kind in [Natural, CatmullRom { alpha: 0.5 }] {
        all_refused([
            (through(0, kind).err(), "Count points 0"),
            (through(1, kind).err(), "Count points 1"),
        ]);
    }
    for alpha in [-0.1, 1.1, f64::NAN, f64::INFINITY] {
        refused(through(3, CatmullRom { alpha }), "Range alpha");
    }
}

#[test]
fn knots() {
    let p = [DVec2::ZERO; 5];
    let open = |knots: &[f64], degree| Spline::from_bspline(&p, degree, Some(knots), false).err();
    let closed = |knots: &[f64]| Spline::from_bspline(&p, 2, Some(knots), true).err();
    let nan = [0.0, 1.0, f64::NAN, 3.0, 4.0, 5.0, 6.0, 7.0];
    all_refused([
        (
            open(&[0.0, 1.0, 2.0, 1.5, 3.0, 4.0, 5.0, 6.0], 2),
            "Item knots 3 1.5",
        ),
        // A double inner knot splits a polyline; at an end two are usual, three are too many.
        (
            open(&[0.0, 0.0, 1.0, 1.0, 2.0, 3.0, 3.0], 1),
            "Item knots 3 1",
        ),
        (
            open(&[0.0, 0.0, 0.0, 1.0, 2.0, 3.0, 3.0], 1),
            "Item knots 2 0",
        ),
        (open(&[1.0; 8], 2), "Item knots 5 1"),
        (closed(&[0.0, 1.0, 1.0, 1.0, 2.0, 3.0]), "Item knots 3 1"),
        (closed(&[0.0, 0.0, 0.0, 1.0, 2.0, 3.0]), "Item knots 2 0"),
        (closed(&[4.0; 6]), "Item knots 5 4"),
        (open(&[0.0; 7], 2), "Count knots 7"),
        (open(&[], 2), "Count knots 0"),
        (closed(&[0.0; 8]), "Count knots 8"),
        (open(&nan, 2), "NotFinite knots 2"),
        (open(&[], 65), "Range degree"),
    ]);
    let mixed = Spline::with_degrees(vec![DVec2::ZERO; 6], &[2, 3], false).expect("a spline");
    refused(mixed.to_bspline(), "Item degrees 1 3");
}

#[test]
fn queries_and_changes() {
    let line = spline("0 0, 1 1, 2 0", 1, false);
    let square = spline("0 0, 4 0, 4 4, 0 4", 1, true);
    all_refused([
        (line.flatten(0.0).err(), "Range tolerance"),
        (line.flatten(1e-16).err(), "Tolerance"),
        (line.sample(0).err(), "Range segments"),
        (line.sample(1 << 25).err(), "TooMany segments 67108863"),
        (line.sample(usize::MAX).err(), "TooMany segments 67108863"),
        (line.extrema(2).err(), "Index axis 2"),
        (
            line.times_at_coordinate(0, f64::NAN).err(),
            "NotFinite value 0",
        ),
        (line.insert(-1e-9).err(), "Range t"),
        (line.insert(2.000_001).err(), "Range t"),
        (line.insert(f64::NAN).err(), "Range t"),
        (line.insert(f64::INFINITY).err(), "Range t"),
        (square.append(DVec2::ONE).err(), "ClosedSpline append"),
    ]);
    let mut moved = line.clone();
    for bad in [f64::NAN, f64::INFINITY] {
        let to = DVec2::new(bad, 0.0);
        all_refused([
            (line.append(to).err(), "NotFinite point 0"),
            (moved.move_point(1, to, |_| G1).err(), "NotFinite to 0"),
        ]);
    }
    let index = "index: expected an index from 0 to 2, got ";
    all_refused([
        (moved.move_point(3, DVec2::ONE, |_| G1).err(), index),
        (
            moved.move_point(usize::MAX, DVec2::ONE, |_| G1).err(),
            index,
        ),
    ]);
    assert_eq!(moved, line);
}

#[test]
fn what_is_no_joint() {
    let random = |degrees: &[usize], closed| random::<DVec3>(&mut Rng(37), degrees, closed);
    let open = random(&[3, 3, 3], false);
    let expected = "joint: expected an index from 1 to 2, got ";
    for got in [0, 3, 4, usize::MAX] {
        all_refused([
            (open.remove(got).err(), expected),
            (open.continuity(got).err(), expected),
            (open.set_joint(got, G1).err(), expected),
        ]);
    }
    let (alone, closed) = (random(&[3], false), random(&[3, 3], true));
    all_refused([
        (alone.continuity(1).err(), "NoJoint"),
        (alone.remove(0).err(), "NoJoint"),
        (random(&[3], true).remove(0).err(), "Count segments 1"),
        (closed.remove(2).err(), "Index joint 2"),
    ]);
    assert!(closed.remove(0).is_ok());
}
