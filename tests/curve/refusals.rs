//! Invalid arguments are rejected, and the message names the argument, what was expected and what was received.

use crate::support::{all_refused, assert_refused, bezier, ulp};
use casteljau::curve::Basis::{Bezier, Hermite, Matrix};
use casteljau::curve::{Cubic, Line, Quad, bernstein};
use casteljau::glam::{DAffine2, DVec2, DVec3, dvec2};
use casteljau::{Curve, Error, MAX_COORDINATE};
#[cfg(target_family = "wasm")]
use wasm_bindgen_test::wasm_bindgen_test as test;

#[test]
fn numbers_of_points() {
    for got in [0, 1, 66, 1000, 1_000_000] {
        let expected =
            format!("points: expected 2 to 65 control points (degree 1 to 64), got {got}");
        assert_refused(Curve::new(&vec![DVec2::ZERO; got]), &expected);
    }
    for count in [2, 65] {
        let curve = Curve::new(&vec![DVec3::ONE; count]);
        assert_eq!(curve.map(|curve| curve.degree()), Ok(count - 1));
    }
}

#[test]
fn values_that_are_not_finite() {
    let cubic = bezier("0 0, 1 0, 2 0, 3 1");
    for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        for axis in 0..3 {
            let mut point = DVec3::ONE;
            point[axis] = bad;
            let points = [DVec3::ZERO, DVec3::ONE, point];
            assert_refused(
                Curve::new(&points),
                "points[2]: expected a finite number, got ",
            );
        }
        let mut matrix = Bezier.matrix();
        matrix[7] = bad;
        all_refused([
            (bernstein(3, bad).err(), "NotFinite t 0"),
            (cubic.to_basis(Matrix(matrix)).err(), "NotFinite basis 7"),
            (
                Curve::from_basis(Matrix(matrix), [DVec3::ZERO; 4]).err(),
                "NotFinite basis 7",
            ),
            (
                Line::new(DVec2::ZERO, dvec2(bad, 0.0)).err(),
                "NotFinite points 1",
            ),
            (cubic.nearest(dvec2(0.0, bad)).err(), "NotFinite p 0"),
            (cubic.subdivide(bad).err(), "Range tolerance"),
        ]);
    }
    // A large finite value beside a NaN does not hide it.
    assert!(Curve::new(&[DVec2::new(1e300, f64::NAN), DVec2::ZERO]).is_err());
}

#[test]
fn numbers_out_of_range() {
    let (line, arch) = (bezier("0 0, 1 1"), bezier("0 0, 1 2, 2 0"));
    let cubic = bezier("0 0, 1 0, 2 0, 3 1");
    let point = bezier("0 0, 0 0, 0 0, 0 0, 0 0");
    let space = Curve::line(DVec3::ZERO, DVec3::ONE);
    let mut twice = Hermite.matrix();
    twice.copy_within(0..4, 4);
    let largest = dvec2(MAX_COORDINATE, 0.0);
    let huge = Line::new(-largest, largest).expect("within the limit");
    let doubled = huge.transform(&DAffine2::from_scale(DVec2::splat(2.0)));
    let far = Quad::new(DVec2::ZERO, dvec2(0.0, 1e200), DVec2::X);
    let wide = bezier("0 0, 1e9 1e9, -1e9 1e9, 0 0");
    all_refused([
        (
            line.sample(0).err(),
            "segments: expected a whole number from 1, got 0",
        ),
        (line.sample(1 << 26).err(), "TooMany segments 67108863"),
        (line.sample(usize::MAX).err(), "TooMany segments 67108863"),
        (space.sample(1 << 26).err(), "TooMany segments 44739241"),
        (
            bernstein(65, 0.5).err(),
            "degree: expected at most 64, got 65",
        ),
        (
            point.to_basis(Bezier).err(),
            "points: expected at most 4 (degree 3), got 5",
        ),
        (cubic.to_basis(Matrix([0.0; 16])).err(), "Singular basis"),
        (cubic.to_basis(Matrix([1.0; 16])).err(), "Singular basis"),
        (cubic.to_basis(Matrix(twice)).err(), "Singular basis"),
        (
            Cubic::try_from(&Curve::line(DVec2::ZERO, DVec2::X)).err(),
            "Count points 2",
        ),
        (far.err(), "points[1]: expected "),
        (doubled.err(), "image[0]: expected "),
        (huge.flatten(0.0).err(), "Range tolerance"),
        (arch.subdivide(0.0).err(), "Range tolerance"),
        (arch.subdivide(-1.0).err(), "Range tolerance"),
        (wide.subdivide(1e-6).err(), "TooMany leaves 65536"),
    ]);
    let min = 4.0 * ulp(1.5);
    let got = min * 0.99;
    let error = bezier("0 0, 1.5 0").subdivide(got).err();
    assert_eq!(error, Some(Error::Tolerance { min, got }));
}
