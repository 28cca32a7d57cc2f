//! Invalid arguments are rejected, and the message names the argument, what was expected and what was received.

use crate::support::plane;
use casteljau::curve::bernstein;
use casteljau::glam::{DVec2, DVec3};
use casteljau::{Curve, Error};
use wasm_bindgen_test::wasm_bindgen_test;

#[wasm_bindgen_test(unsupported = test)]
fn counts() {
    for got in [0, 1, 66, 1000, 1_000_000] {
        let refused = Curve::new(&vec![DVec2::ZERO; got]).expect_err("refused");
        assert!(matches!(refused, Error::Count { what: "points", got: g, .. } if g == got));
        let expected =
            format!("points: expected 2 to 65 control points (degree 1 to 64), got {got}");
        assert_eq!(refused.to_string(), expected);
    }
    for count in [2, 65] {
        assert_eq!(
            Curve::new(&vec![DVec3::ONE; count]).map(|curve| curve.degree()),
            Ok(count - 1)
        );
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn values_that_are_not_finite() {
    for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        for axis in 0..3 {
            let mut point = DVec3::ONE;
            point[axis] = bad;
            let refused = Curve::new(&[DVec3::ZERO, DVec3::ONE, point]).expect_err("refused");
            assert!(
                matches!(
                    refused,
                    Error::NotFinite {
                        what: "points",
                        index: 2,
                        ..
                    }
                ),
                "{refused:?}"
            );
            assert!(
                refused
                    .to_string()
                    .starts_with("points[2]: expected a finite number, got "),
                "{refused}"
            );
        }
    }
    // A large finite value beside a NaN does not hide it.
    assert!(Curve::new(&[DVec2::new(1e300, f64::NAN), DVec2::ZERO]).is_err());
}

#[wasm_bindgen_test(unsupported = test)]
fn segments() {
    let line = plane(&[(0.0, 0.0), (1.0, 1.0)]);
    let refused = line.sample(0).expect_err("refused");
    assert_eq!(
        refused.to_string(),
        "segments: expected a whole number from 1, got 0"
    );
    for needed in [1_usize << 26, usize::MAX] {
        let limit = (1 << 27) / 2 - 1;
        assert_eq!(
            line.sample(needed),
            Err(Error::TooMany {
                what: "segments",
                limit,
                needed: needed as u64
            })
        );
    }
    let space = Curve::new(&[DVec3::ZERO, DVec3::ONE]).expect("a line");
    assert!(
        matches!(space.sample(1 << 26), Err(Error::TooMany { limit, .. }) if limit == (1 << 27) / 3 - 1)
    );
}

#[wasm_bindgen_test(unsupported = test)]
fn weights() {
    let refused = bernstein(65, 0.5).expect_err("refused");
    assert_eq!(refused.to_string(), "degree: expected at most 64, got 65");
    for bad in [f64::NAN, f64::INFINITY] {
        assert!(matches!(
            bernstein(3, bad),
            Err(Error::NotFinite { what: "t", .. })
        ));
    }
}
