//! Evaluation, Bernstein weights and samples.

use crate::curve::{adversarial_points, assert_close, steps};
use crate::support::adversarial::ALL;
use crate::support::exact::{self, exactly};
use crate::support::{Rng, Space, curve, largest, parameters, plane, real, to_3d, ulp};
use casteljau::Curve;
use casteljau::curve::bernstein;
use casteljau::glam::{DVec2, DVec3};
use wasm_bindgen_test::wasm_bindgen_test;

#[wasm_bindgen_test(unsupported = test)]
fn end_points_are_exact() {
    fn check<P: Space>(points: &[DVec3]) {
        let curve = curve::<P>(points);
        assert_eq!(curve.eval(0.0), P::of(points[0]));
        assert_eq!(curve.eval(1.0), P::of(points[points.len() - 1]));
        assert_eq!(
            (curve.start(), curve.end()),
            (curve.eval(0.0), curve.eval(1.0))
        );
    }
    adversarial_points(&ALL, |points| {
        check::<DVec2>(points);
        check::<DVec3>(points);
    });
}

/// De Casteljau's algorithm in f64, as in textbooks.
fn de_casteljau(points: &[DVec3], t: f64) -> DVec3 {
    let mut row = points.to_vec();
    while row.len() > 1 {
        row = row
            .windows(2)
            .map(|pair| pair[0] * (1.0 - t) + pair[1] * t)
            .collect();
    }
    row[0]
}

#[wasm_bindgen_test(unsupported = test)]
fn closed_forms_are_as_exact_as_de_casteljau() {
    fn check<P: Space>(points: &[DVec3], t: f64, compared: &mut (usize, usize)) {
        let points = to_3d(&points.iter().map(|&p| P::of(p)).collect::<Vec<P>>());
        let got = curve::<P>(&points).eval(t).to_3d();
        let size = largest(&points);
        assert_close(got, exact::eval(&points, t), 3.0, size);
        // De Casteljau's algorithm itself is off by up to 2.6 ulps, rarely in the other direction.
        let difference = (got - de_casteljau(&points, t)).abs().max_element();
        assert!(difference <= 4.0 * ulp(size));
        compared.0 += 1;
        compared.1 += usize::from(difference > 2.0 * ulp(size));
    }
    let mut compared = (0, 0);
    adversarial_points(&ALL, |points| {
        let low = &points[..points.len().min(4)];
        for t in parameters(64) {
            check::<DVec2>(low, t, &mut compared);
            check::<DVec3>(low, t, &mut compared);
        }
    });
    let (all, beyond_2_ulps) = compared;
    assert!(
        1000 * beyond_2_ulps < all,
        "{beyond_2_ulps} of {all} differ by more than 2 ulps"
    );
}

#[wasm_bindgen_test(unsupported = test)]
fn points_of_any_degree_are_right_to_an_ulp_for_each_step() {
    adversarial_points(&ALL, |points| {
        for t in parameters(16) {
            let got = curve::<DVec3>(points).eval(t);
            assert_close(got, exact::eval(points, t), steps(points), largest(points));
        }
    });
}

#[wasm_bindgen_test(unsupported = test)]
fn values_outside_extrapolate() {
    // The parabola y = x² and the cubic y = x³ outside the interval [0, 1].
    let parabola = plane(&[(0.0, 0.0), (0.5, 0.0), (1.0, 1.0)]);
    let cubic = plane(&[(0.0, 0.0), (1.0, 0.0), (2.0, 0.0), (3.0, 27.0)]);
    for x in [-3.0, -0.5, 1.5, 4.0] {
        assert_eq!(parabola.eval(x), DVec2::new(x, x * x));
        assert!((cubic.eval(x / 3.0) - DVec2::new(x, x.powi(3))).length() < 1e-13);
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn weights_sum_to_one_within_an_ulp() {
    let mut rng = Rng(5);
    for degree in 0..=64 {
        let random: Vec<f64> = (0..40).map(|_| rng.unit()).collect();
        for t in parameters(50).chain(random) {
            let weights = bernstein(degree, t).expect("weights");
            assert_eq!(weights.len(), degree + 1);
            assert!(weights.iter().all(|&w| w >= 0.0), "degree {degree} at {t}");
            let off = (exact::sum(&weights) - 1.0).abs();
            assert!(
                off <= f64::EPSILON,
                "degree {degree} at {t}: off by {off:e}"
            );
        }
        for (t, one) in [(0.0, 0), (1.0, degree)] {
            let weights = bernstein(degree, t).expect("weights");
            let expected: Vec<f64> = (0..=degree)
                .map(|i| if i == one { 1.0 } else { 0.0 })
                .collect();
            assert_eq!(weights, expected);
        }
    }
}

/// C(n, i) by Pascal's triangle, exact in u128.
fn binomials(n: usize) -> Vec<f64> {
    let mut row = vec![1_u128];
    for _ in 0..n {
        let inner = row.windows(2).map(|w| w[0] + w[1]);
        row = std::iter::once(1).chain(inner).chain([1]).collect();
    }
    row.iter().map(|&c| c as f64).collect()
}

#[wasm_bindgen_test(unsupported = test)]
fn weights_are_binomials_times_powers() {
    for degree in 0..=64 {
        let n = i32::try_from(degree).expect("small");
        // k/16 and 1 − k/16 are exact; the last two extrapolate.
        for t in (1..16).map(|k| real(k) / 16.0).chain([-0.5, 1.5]) {
            let weights = bernstein(degree, t).expect("weights");
            for ((&got, c), i) in weights.iter().zip(binomials(degree)).zip(0..) {
                let expected = c * t.powi(i) * (1.0 - t).powi(n - i);
                let ratio = (got / expected - 1.0).abs();
                assert!(
                    ratio < 1e-13,
                    "degree {degree}, {i} at {t}: {got} instead of {expected}"
                );
            }
        }
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn samples_are_points_at_even_steps() {
    fn check<P: Space>(points: &[DVec3]) {
        let curve = curve::<P>(points);
        for segments in [1, 2, 3, 7, 100] {
            let samples = curve.sample(segments).expect("samples");
            assert_eq!(samples.len(), segments + 1);
            assert_eq!(
                (samples[0], samples[segments]),
                (curve.start(), curve.end())
            );
            let ts: Vec<f64> = (0..=segments).map(|i| real(i) / real(segments)).collect();
            assert_eq!(samples, curve.eval_at(&ts));
            assert_eq!(
                samples,
                ts.iter().map(|&t| curve.eval(t)).collect::<Vec<P>>()
            );
        }
        curve.sample_into(&mut []);
        let mut one = [P::default()];
        curve.sample_into(&mut one);
        assert_eq!(one[0], curve.start());
    }
    for degree in [1, 2, 3, 4, 9] {
        let mut rng = Rng(degree as u64);
        let points: Vec<DVec3> = (0..=degree).map(|_| rng.point(3)).collect();
        check::<DVec2>(&points);
        check::<DVec3>(&points);
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn every_level_of_the_triangle() {
    adversarial_points(&ALL, |points| {
        let curve = curve::<DVec3>(points);
        for t in [0.0, 0.25, 0.625, 1.0] {
            let levels = curve.de_casteljau(t);
            let lengths: Vec<usize> = levels.iter().map(Vec::len).collect();
            assert_eq!(lengths, (1..=points.len()).rev().collect::<Vec<usize>>());
            assert_eq!(levels[0], points);
            for pair in levels.windows(2) {
                for (edge, &p) in pair[0].windows(2).zip(&pair[1]) {
                    assert_close(p, exact::eval(edge, t), 1.0, largest(edge));
                }
            }
        }
    });
}

#[wasm_bindgen_test(unsupported = test)]
fn huge_coordinates_do_not_overflow() {
    for size in [1e150, casteljau::MAX_COORDINATE] {
        let corners = [
            (size, -size),
            (-size, size),
            (size, size),
            (-size, -size),
            (size, 0.0),
        ];
        for count in 2..=5 {
            let curve = plane(&corners[..count]);
            for t in parameters(32) {
                assert!(curve.eval(t).is_finite(), "{count} points of {size} at {t}");
            }
            let halves = curve.halve();
            let all = [
                halves.0,
                halves.1,
                curve.split(0.3).0,
                curve.subsegment(0.2, 0.7),
            ];
            let finite = |c: &Curve<DVec2>| c.control_points().iter().all(|p| p.is_finite());
            assert!(all.iter().all(finite), "{count} points of {size}");
        }
    }
}

/// The reference arithmetic: (1/3 + 1/3) + 1/3 and (1 + 2⁻⁸⁰) − 1 are accurate to 100 bits.
#[wasm_bindgen_test(unsupported = test)]
fn exact_arithmetic_is_exact() {
    let tiny = exactly(2_f64.powi(-80));
    let kept = exactly(1.0) + tiny - exactly(1.0);
    assert_eq!(kept.hi, 2_f64.powi(-80));
    let square = exactly(1.0 + f64::EPSILON) * exactly(1.0 - f64::EPSILON) - exactly(1.0);
    assert_eq!(square.hi, -f64::EPSILON * f64::EPSILON);
    assert_eq!(exact::sum(&[1e16, 1.0, -1e16, 2.0]), 3.0);
}
