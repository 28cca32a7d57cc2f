//! Conversion of cubics to other bases and back.

use crate::curve::near;
use crate::support::exact::{Double, exactly};
use crate::support::{Rng, bezier, largest, random_points, real, xy};
use casteljau::Curve;
use casteljau::curve::Basis::{self, BSpline, Bezier, CatmullRom, Hermite, Matrix};
use casteljau::glam::{DVec2, DVec3};
#[cfg(target_family = "wasm")]
use wasm_bindgen_test::wasm_bindgen_test as test;

const NAMED: [Basis; 4] = [Bezier, Hermite, BSpline, CatmullRom];

/// The weight of each geometry point at t, by the textbook formulas.
fn blend(basis: Basis, t: f64) -> [Double; 4] {
    let [o, t, two, three] = [1.0, t, 2.0, 3.0].map(exactly);
    let (s, c) = (o - t, exactly);
    let (tt, ss) = (t * t, s * s);
    let ttt = tt * t;
    match basis {
        Bezier => [ss * s, three * ss * t, three * s * tt, ttt],
        Hermite => [
            (o + two * t) * ss,
            tt * (three - two * t),
            t * ss,
            tt * (t - o),
        ],
        CatmullRom => {
            let p1 = c(1.5) * ttt - c(2.5) * tt + o;
            let p2 = c(-1.5) * ttt + two * tt + c(0.5) * t;
            [c(-0.5) * t * ss, p1, p2, c(-0.5) * tt * s]
        }
        // Six times the weights; the caller passes points that are divisible by six.
        _ => {
            let p1 = three * ttt - c(6.0) * tt + c(4.0);
            let p2 = three * t + three * tt - three * ttt + o;
            [ss * s, p1, p2, ttt]
        }
    }
}

/// Geometry points that are divisible by six.
fn geometry(rng: &mut Rng) -> [DVec3; 4] {
    [(); 4].map(|()| (rng.point(3) * 100.0).round() * 6.0)
}

fn curve_of(basis: Basis, points: [DVec3; 4]) -> Curve<DVec3> {
    Curve::from_basis(basis, points).expect("finite")
}

fn all_close(got: &[DVec3], expected: &[DVec3], ulps: f64, size: f64) {
    assert_eq!(got.len(), expected.len());
    let pairs = got.iter().zip(expected);
    pairs.for_each(|(&p, &q)| near(p, q, ulps, size));
}

#[test]
fn the_curve_of_a_basis_is_the_blend_of_its_points() {
    let mut rng = Rng(41);
    for basis in NAMED {
        let divisor = if basis == BSpline { 6.0 } else { 1.0 };
        for _ in 0..50 {
            let points = geometry(&mut rng);
            let curve = curve_of(basis, points);
            for t in (0..=16).map(|i| real(i) / 16.0) {
                let weights = blend(basis, t);
                let axis = |k: usize| {
                    let term = |i: usize| exactly(points[i][k] / divisor) * weights[i];
                    (0..4).map(term).reduce(|a, b| a + b).expect("four").hi
                };
                let expected = DVec3::new(axis(0), axis(1), axis(2));
                near(curve.eval(t), expected, 6.0, largest(&points));
            }
        }
    }
}

#[test]
fn control_points_by_the_books() {
    let mut rng = Rng(8);
    for _ in 0..100 {
        let g = geometry(&mut rng);
        let [a, b, c, d] = g;
        let mid = [(b * 2.0 + c) / 3.0, (b + c * 2.0) / 3.0];
        for (basis, expected, ulps) in [
            (Bezier, g, 0.0),
            // P₀, P₁, M₀, M₁
            (Hermite, [a, a + c / 3.0, b - d / 3.0, b], 0.0),
            (
                CatmullRom,
                [b, b + (c - a) / 6.0, c - (d - b) / 6.0, c],
                0.0,
            ),
            (
                BSpline,
                [
                    (a + b * 4.0 + c) / 6.0,
                    mid[0],
                    mid[1],
                    (b + c * 4.0 + d) / 6.0,
                ],
                2.0,
            ),
        ] {
            all_close(
                curve_of(basis, g).control_points(),
                &expected,
                ulps,
                largest(&g),
            );
        }
    }
}

#[test]
fn there_and_back_is_the_same() {
    let mut rng = Rng(77);
    for basis in NAMED {
        for _ in 0..100 {
            let points = geometry(&mut rng);
            let curve = curve_of(basis, points);
            let back = curve.to_basis(basis).expect("invertible");
            // The rows of the inverse B-spline matrix have absolute sums of up to 11.
            all_close(&back, &points, 32.0, largest(&points));
            let again = curve_of(basis, back);
            all_close(
                again.control_points(),
                curve.control_points(),
                32.0,
                largest(&back),
            );
        }
    }
}

#[test]
fn known_curves_in_every_basis() {
    let third = 1.0 / 3.0;
    // The curve (t, t³).
    let cubic = format!("0 0, {third} 0, {} 0, 1 1", 2.0 * third);
    for (curve, basis, expected, ulps, size) in [
        (cubic.as_str(), Hermite, "0 0, 1 1, 1 0, 1 3", 32.0, 2.0),
        // Tangents (P₂ − P₀)/2 = (1, 0) and (P₃ − P₁)/2 = (1, 3).
        (&cubic, CatmullRom, "-1 1, 0 0, 1 1, 2 6", 32.0, 2.0),
        // The polar form of t³ at (−2,−1,0), (−1,0,1), (0,1,2), (1,2,3).
        (&cubic, BSpline, "-1 0, 0 0, 1 0, 2 6", 32.0, 2.0),
        // Lower degrees are elevated.
        ("0 0, 3 6", Hermite, "0 0, 3 6, 3 6, 3 6", 4.0, 6.0),
    ] {
        let got = bezier(curve).to_basis(basis).expect("a cubic");
        let space =
            |points: &[DVec2]| -> Vec<DVec3> { points.iter().map(|p| p.extend(0.0)).collect() };
        all_close(&space(&got), &space(&xy(expected)), ulps, size);
    }
}

#[test]
fn own_matrices() {
    let mut rng = Rng(13);
    for _ in 0..100 {
        let mut matrix = [0.0; 16].map(|_: f64| (rng.signed() * 4.0).round());
        // A dominant diagonal, so that the matrix has an inverse.
        (0..4).for_each(|k| matrix[5 * k] += 16.0);
        let points: Vec<DVec3> = random_points(&mut rng, 4);
        let curve = curve_of(Matrix(matrix), [points[0], points[1], points[2], points[3]]);
        for t in [0.0, 0.25, 0.5, 1.0] {
            let powers = [t * t * t, t * t, t, 1.0];
            let weight =
                |k: usize| -> f64 { (0..4).map(|row| powers[row] * matrix[4 * row + k]).sum() };
            let expected = (0..4).map(|k| points[k] * weight(k)).sum::<DVec3>();
            near(curve.eval(t), expected, 64.0, 16.0);
        }
        let back = curve.to_basis(Matrix(matrix)).expect("invertible");
        all_close(&back, &points, 256.0, 1.0);
    }
}
