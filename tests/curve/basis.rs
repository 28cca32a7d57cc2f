//! Conversion of cubics to other bases and back.

use crate::curve::assert_close;
use crate::support::exact::{Double, exactly};
use crate::support::{Rng, largest, plane, real};
use casteljau::curve::Basis;
use casteljau::glam::DVec3;
use casteljau::{Curve, Error};
use wasm_bindgen_test::wasm_bindgen_test;

const NAMED: [Basis; 4] = [
    Basis::Bezier,
    Basis::Hermite,
    Basis::BSpline,
    Basis::CatmullRom,
];

/// The weight of each geometry point at t, by the textbook formulas.
fn blend(basis: Basis, t: f64) -> [Double; 4] {
    let [o, t, two, three] = [1.0, t, 2.0, 3.0].map(exactly);
    let (s, c) = (o - t, exactly);
    let (tt, ss) = (t * t, s * s);
    match basis {
        Basis::Bezier => [ss * s, three * ss * t, three * s * tt, tt * t],
        Basis::Hermite => [
            (o + two * t) * ss,
            tt * (three - two * t),
            t * ss,
            tt * (t - o),
        ],
        Basis::CatmullRom => [
            c(-0.5) * t * ss,
            c(1.5) * tt * t - c(2.5) * tt + o,
            c(-1.5) * tt * t + two * tt + c(0.5) * t,
            c(-0.5) * tt * s,
        ],
        // Six times the weights; the caller passes points that are divisible by six.
        _ => [
            ss * s,
            three * tt * t - c(6.0) * tt + c(4.0),
            three * t + three * tt - three * tt * t + o,
            tt * t,
        ],
    }
}

/// Geometry points that are divisible by six.
fn geometry(rng: &mut Rng) -> [DVec3; 4] {
    [(); 4].map(|()| (rng.point(3) * 100.0).round() * 6.0)
}

#[wasm_bindgen_test(unsupported = test)]
fn the_curve_of_a_basis_is_the_blend_of_its_points() {
    let mut rng = Rng(41);
    for basis in NAMED {
        let divisor = if basis == Basis::BSpline { 6.0 } else { 1.0 };
        for _ in 0..50 {
            let points = geometry(&mut rng);
            let curve = Curve::from_basis(basis, points).expect("finite");
            for t in (0..=16).map(|i| real(i) / 16.0) {
                let weights = blend(basis, t);
                let axis = |k: usize| {
                    let terms = points
                        .iter()
                        .zip(weights)
                        .map(|(p, w)| exactly(p[k] / divisor) * w);
                    terms.reduce(|a, b| a + b).expect("four").hi
                };
                assert_close(
                    curve.eval(t),
                    DVec3::new(axis(0), axis(1), axis(2)),
                    6.0,
                    largest(&points),
                );
            }
        }
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn control_points_by_the_books() {
    let mut rng = Rng(8);
    let of = |basis, points| {
        Curve::from_basis(basis, points)
            .expect("finite")
            .control_points()
            .to_vec()
    };
    for _ in 0..100 {
        let g = geometry(&mut rng);
        let [a, b, c, d] = g;
        assert_eq!(of(Basis::Bezier, g), g);
        // P₀, P₁, M₀, M₁
        assert_eq!(of(Basis::Hermite, g), [a, a + c / 3.0, b - d / 3.0, b]);
        assert_eq!(
            of(Basis::CatmullRom, g),
            [b, b + (c - a) / 6.0, c - (d - b) / 6.0, c]
        );
        let spline = [
            (a + b * 4.0 + c) / 6.0,
            (b * 2.0 + c) / 3.0,
            (b + c * 2.0) / 3.0,
            (b + c * 4.0 + d) / 6.0,
        ];
        for (got, expected) in of(Basis::BSpline, g).into_iter().zip(spline) {
            assert_close(got, expected, 2.0, largest(&g));
        }
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn there_and_back_is_the_same() {
    let mut rng = Rng(77);
    for basis in NAMED {
        for _ in 0..100 {
            let points = geometry(&mut rng);
            let curve = Curve::from_basis(basis, points).expect("finite");
            let back = curve.to_basis(basis).expect("invertible");
            // The rows of the inverse B-spline matrix have absolute sums of up to 11.
            back.iter()
                .zip(points)
                .for_each(|(&p, q)| assert_close(p, q, 32.0, largest(&points)));
            let again = Curve::from_basis(basis, back).expect("finite");
            let (p, q) = (again.control_points(), curve.control_points());
            p.iter()
                .zip(q)
                .for_each(|(&p, &q)| assert_close(p, q, 32.0, largest(&back)));
        }
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn from_any_basis_to_any_other() {
    // A known curve, (t, t³), in all four bases.
    let cubic = plane(&[(0.0, 0.0), (1.0 / 3.0, 0.0), (2.0 / 3.0, 0.0), (1.0, 1.0)]);
    let geometry = |basis| {
        cubic
            .to_basis(basis)
            .expect("a cubic")
            .map(|p| p.extend(0.0))
    };
    let expected = |points: [(f64, f64); 4], basis| {
        for (got, (x, y)) in geometry(basis).into_iter().zip(points) {
            assert_close(got, DVec3::new(x, y, 0.0), 32.0, 2.0);
        }
    };
    expected(
        [(0.0, 0.0), (1.0, 1.0), (1.0, 0.0), (1.0, 3.0)],
        Basis::Hermite,
    );
    // Catmull-Rom: tangents (P₂ − P₀)/2 = (1, 0) and (P₃ − P₁)/2 = (1, 3).
    expected(
        [(-1.0, 1.0), (0.0, 0.0), (1.0, 1.0), (2.0, 6.0)],
        Basis::CatmullRom,
    );
    // The polar form of t³ at (−2,−1,0), (−1,0,1), (0,1,2), (1,2,3).
    expected(
        [(-1.0, 0.0), (0.0, 0.0), (1.0, 0.0), (2.0, 6.0)],
        Basis::BSpline,
    );
}

#[wasm_bindgen_test(unsupported = test)]
fn own_matrices() {
    let mut rng = Rng(13);
    for _ in 0..100 {
        let mut matrix = [0.0; 16];
        matrix
            .iter_mut()
            .for_each(|m| *m = (rng.signed() * 4.0).round());
        // A dominant diagonal, so that the matrix has an inverse.
        (0..4).for_each(|k| matrix[5 * k] += 16.0);
        let points = [(); 4].map(|()| rng.point(3));
        let curve = Curve::from_basis(Basis::Matrix(matrix), points).expect("finite");
        for t in [0.0, 0.25, 0.5, 1.0] {
            let powers = [t * t * t, t * t, t, 1.0];
            let weight = |k: usize| {
                (0..4)
                    .map(|row| powers[row] * matrix[4 * row + k])
                    .sum::<f64>()
            };
            let expected = (0..4).map(|k| points[k] * weight(k)).sum::<DVec3>();
            assert_close(curve.eval(t), expected, 64.0, 16.0);
        }
        let back = curve.to_basis(Basis::Matrix(matrix)).expect("invertible");
        back.iter()
            .zip(points)
            .for_each(|(&p, q)| assert_close(p, q, 256.0, 1.0));
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn lower_degrees_are_elevated_and_higher_ones_refused() {
    let line = plane(&[(0.0, 0.0), (3.0, 6.0)])
        .to_basis(Basis::Hermite)
        .expect("a line");
    let expected = [(0.0, 0.0), (3.0, 6.0), (3.0, 6.0), (3.0, 6.0)];
    line.iter()
        .zip(expected)
        .for_each(|(p, (x, y))| assert_close(p.extend(0.0), DVec3::new(x, y, 0.0), 4.0, 6.0));
    let quartic = plane(&[(0.0, 0.0); 5]).to_basis(Basis::Bezier);
    assert_eq!(
        quartic,
        Err(Error::Count {
            what: "points",
            expected: "at most 4 (degree 3)",
            got: 5
        })
    );
}

#[wasm_bindgen_test(unsupported = test)]
fn matrices_that_do_not_work_are_refused() {
    let cubic = plane(&[(0.0, 0.0), (1.0, 0.0), (2.0, 0.0), (3.0, 1.0)]);
    let mut twice = Basis::Hermite.matrix();
    twice.copy_within(0..4, 4);
    for singular in [[0.0; 16], [1.0; 16], twice] {
        let refused = cubic.to_basis(Basis::Matrix(singular));
        assert!(
            matches!(refused, Err(Error::Range { what: "basis", .. })),
            "{refused:?}"
        );
    }
    for bad in [f64::NAN, f64::INFINITY] {
        let mut matrix = Basis::Bezier.matrix();
        matrix[7] = bad;
        let refused = cubic.to_basis(Basis::Matrix(matrix));
        assert!(
            matches!(
                refused,
                Err(Error::NotFinite {
                    what: "basis",
                    index: 7,
                    ..
                })
            ),
            "{refused:?}"
        );
        let result = Curve::from_basis(Basis::Matrix(matrix), [DVec3::ZERO; 4]);
        assert!(
            matches!(
                result,
                Err(Error::NotFinite {
                    what: "basis",
                    index: 7,
                    ..
                })
            ),
            "{result:?}"
        );
    }
}
