//! Invalid arguments are rejected, and the message names the argument, what was expected and what was received.

use crate::support::{bezier, refused};
use casteljau::curve::bernstein;
use casteljau::glam::{DVec2, DVec3};
use casteljau::{Curve, Error};
use std::fmt::Debug;
#[cfg(target_family = "wasm")]
use wasm_bindgen_test::wasm_bindgen_test as test;

fn message<T: Debug>(result: Result<T, Error>) -> String {
    result.expect_err("refused").to_string()
}

#[test]
fn counts() {
    for got in [0, 1, 66, 1000, 1_000_000] {
        let points = vec![DVec2::ZERO; got];
        refused(Curve::new(&points), &format!("Count points {got}"));
        let expected =
            format!("points: expected 2 to 65 control points (degree 1 to 64), got {got}");
        assert_eq!(message(Curve::new(&points)), expected);
    }
    for count in [2, 65] {
        let curve = Curve::new(&vec![DVec3::ONE; count]);
        assert_eq!(curve.map(|curve| curve.degree()), Ok(count - 1));
    }
}

#[test]
fn values_that_are_not_finite() {
    for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        for axis in 0..3 {
            let mut point = DVec3::ONE;
            point[axis] = bad;
            let points = [DVec3::ZERO, DVec3::ONE, point];
            refused(Curve::new(&points), "NotFinite points 2");
            let expected = "points[2]: expected a finite number, got ";
            assert!(message(Curve::new(&points)).starts_with(expected));
        }
        refused(bernstein(3, bad), "NotFinite t 0");
    }
    // A large finite value beside a NaN does not hide it.
    assert!(Curve::new(&[DVec2::new(1e300, f64::NAN), DVec2::ZERO]).is_err());
}

#[test]
fn numbers_out_of_range() {
    let line = bezier("0 0, 1 1");
    let expected = "segments: expected a whole number from 1, got 0";
    assert_eq!(message(line.sample(0)), expected);
    let expected = "degree: expected at most 64, got 65";
    assert_eq!(message(bernstein(65, 0.5)), expected);
    for many in [1_usize << 26, usize::MAX] {
        let Err(Error::TooMany {
            what,
            limit,
            needed,
        }) = line.sample(many)
        else {
            panic!()
        };
        assert_eq!(
            (what, limit, needed),
            ("segments", (1 << 27) / 2 - 1, many as u64)
        );
    }
    let space = Curve::line(DVec3::ZERO, DVec3::ONE);
    refused(space.sample(1 << 26), "TooMany segments 44739241");
}
