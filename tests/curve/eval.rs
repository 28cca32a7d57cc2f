//! Evaluation, Bernstein weights and samples.

use crate::curve::{adversarial_points, near, outside, steps};
use crate::support::adversarial::ALL;
use crate::support::exact::{self, exactly};
use crate::support::{Rng, Space, binomial, curve, de_casteljau, largest};
use crate::support::{parameters, random_points, real, to_3d, ulp};
use casteljau::MAX_COORDINATE;
use casteljau::curve::bernstein;
use casteljau::glam::{DVec2, DVec3};
#[cfg(target_family = "wasm")]
use wasm_bindgen_test::wasm_bindgen_test as test;

#[test]
fn closed_forms_are_as_exact_as_de_casteljau() {
    fn check<P: Space>(points: &[DVec3], t: f64, compared: &mut (usize, usize)) {
        let curve = curve::<P>(points);
        let points = to_3d(curve.control_points());
        let got = curve.eval(t).to_3d();
        let size = largest(&points);
        near(got, exact::eval(&points, t), 3.0, size);
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
    let (all, beyond) = compared;
    assert!(1000 * beyond < all, "{beyond} of {all} by more than 2 ulps");
}

#[test]
fn points_of_any_degree_are_right_to_an_ulp_for_each_step() {
    adversarial_points(&ALL, |points| {
        let curve = curve::<DVec3>(points);
        for t in parameters(16) {
            let expected = exact::eval(points, t);
            near(curve.eval(t), expected, steps(points), largest(points));
        }
        for (t, growth) in outside(points) {
            let expected = exact::eval(points, t);
            near(
                curve.eval(t),
                expected,
                growth * steps(points),
                largest(points),
            );
        }
        let ends = (points[0], points[points.len() - 1]);
        assert_eq!((curve.eval(0.0), curve.eval(1.0)), ends);
    });
}

#[test]
fn weights_sum_to_one_within_an_ulp() {
    let mut rng = Rng(5);
    for degree in 0..=64 {
        let random: Vec<f64> = (0..40).map(|_| rng.unit()).collect();
        for t in parameters(50).chain(random) {
            let weights = bernstein(degree, t).expect("weights");
            assert_eq!(weights.len(), degree + 1);
            assert!(weights.iter().all(|&w| w >= 0.0), "degree {degree} at {t}");
            let off = (exact::sum(&weights) - 1.0).abs();
            assert!(off <= f64::EPSILON, "degree {degree} at {t}: {off:e}");
        }
        for (t, one) in [(0.0, 0), (1.0, degree)] {
            let mut expected = vec![0.0; degree + 1];
            expected[one] = 1.0;
            assert_eq!(bernstein(degree, t), Ok(expected));
        }
    }
}

#[test]
fn weights_are_binomials_times_powers() {
    for degree in 0..=64 {
        let n = i32::try_from(degree).expect("small");
        // k/16 and 1 − k/16 are exact; the last two extrapolate.
        for t in (1..16).map(|k| real(k) / 16.0).chain([-0.5, 1.5]) {
            let weights = bernstein(degree, t).expect("weights");
            for (k, i) in (0..=degree).zip(0..) {
                let expected = binomial(degree, k) * t.powi(i) * (1.0 - t).powi(n - i);
                let ratio = (weights[k] / expected - 1.0).abs();
                assert!(ratio < 1e-13, "degree {degree}, {i} at {t}: {ratio:e}");
            }
        }
    }
}

#[test]
fn samples_are_points_at_even_steps() {
    fn check<P: Space>(points: &[DVec3]) {
        let curve = curve::<P>(points);
        for segments in [1, 2, 3, 7, 100] {
            let samples = curve.sample(segments).expect("samples");
            let ts: Vec<f64> = (0..=segments).map(|i| real(i) / real(segments)).collect();
            assert_eq!(samples, curve.eval_at(&ts));
            let points: Vec<P> = ts.iter().map(|&t| curve.eval(t)).collect();
            assert_eq!(samples, points);
        }
        curve.sample_into(&mut []);
        let mut one = [P::default()];
        curve.sample_into(&mut one);
        assert_eq!(one[0], curve.start());
    }
    for degree in [1, 2, 3, 4, 9] {
        let points = random_points(&mut Rng(degree as u64), degree + 1);
        check::<DVec2>(&points);
        check::<DVec3>(&points);
    }
}

#[test]
fn every_level_of_the_triangle() {
    adversarial_points(&ALL, |points| {
        let curve = curve::<DVec3>(points);
        for t in [0.0, 0.25, 0.625, 1.0] {
            let levels = curve.de_casteljau(t);
            let lengths: Vec<usize> = levels.iter().map(Vec::len).collect();
            assert!(lengths.into_iter().rev().eq(1..=points.len()));
            assert_eq!(levels[0], points);
            for pair in levels.windows(2) {
                for (edge, &p) in pair[0].windows(2).zip(&pair[1]) {
                    near(p, exact::eval(edge, t), 1.0, largest(edge));
                }
            }
        }
    });
}

/// Coordinates of any size within one curve: every result is finite.
#[test]
fn extreme_coordinates_do_not_overflow() {
    fn check<P: Space>(points: &[DVec3], t: f64, u: f64) {
        let curve = curve::<P>(points);
        let ((a, b), (c, d)) = (curve.split(t), curve.halve());
        let mut pieces = vec![a, b, c, d, curve.subsegment(t..u), curve.reverse()];
        pieces.push(curve.derivative());
        pieces.extend(curve.elevate());
        let mut all: Vec<P> = Vec::new();
        pieces
            .iter()
            .for_each(|piece| all.extend(piece.control_points()));
        for t in parameters(8).chain([t]) {
            all.extend([
                curve.eval(t),
                curve.tangent(t),
                curve.normal(t),
                curve.derivative_at(t, 1),
            ]);
            assert!(!curve.curvature(t).is_nan(), "{points:?} at {t}");
        }
        all.extend([curve.bounds().min, curve.bounds().max]);
        all.extend(curve.de_casteljau(t).into_iter().flatten());
        let finite = all.iter().all(|p| p.max_abs().is_finite());
        assert!(finite, "{points:?}, {t}, {u}");
    }
    let mut rng = Rng(1975);
    for case in 0..if cfg!(target_family = "wasm") {
        100
    } else {
        1000
    } {
        let degree = if case % 10 == 0 {
            9 + rng.below(56)
        } else {
            1 + rng.below(8)
        };
        let coordinate = |rng: &mut Rng| {
            let extremes = [0.0, -0.0, 1e-320, -5e-324, 1e16, 1e150, MAX_COORDINATE];
            match rng.below(6) {
                0 | 1 => (rng.signed() * 4.0).round(),
                2 => rng.signed() * rng.pick(&[100.0, 1e150, 1e-300]),
                3 => 1.0 + real(rng.below(8)) * f64::EPSILON,
                _ => rng.pick(&extremes) * rng.pick(&[1.0, -1.0]),
            }
        };
        let mut p: Vec<DVec3> = (0..=degree)
            .map(|_| DVec3::from([(); 3].map(|()| coordinate(&mut rng))))
            .collect();
        match rng.below(6) {
            0 => p[rng.below(degree + 1)] = p[rng.below(degree + 1)],
            1 => p[degree] = p[0],
            2 => p
                .iter_mut()
                .for_each(|p| *p = DVec3::new(p.x, 0.5 * p.x, -p.x)),
            3 => (p[1], p[degree - 1]) = (p[0], p[degree]),
            _ => {}
        }
        check::<DVec2>(&p, rng.unit(), rng.unit());
        check::<DVec3>(&p, rng.unit(), rng.unit());
        let hull = curve::<DVec2>(&p).hull();
        assert!(hull.iter().all(|p| p.is_finite()));
    }
}

/// The reference arithmetic: (1/3 + 1/3) + 1/3 and (1 + 2⁻⁸⁰) − 1 are accurate to 100 bits.
#[test]
fn exact_arithmetic_is_exact() {
    let tiny = exactly(2_f64.powi(-80));
    let kept = exactly(1.0) + tiny - exactly(1.0);
    assert_eq!(kept.hi, 2_f64.powi(-80));
    let square = exactly(1.0 + f64::EPSILON) * exactly(1.0 - f64::EPSILON) - exactly(1.0);
    assert_eq!(square.hi, -f64::EPSILON * f64::EPSILON);
    assert_eq!(exact::sum(&[1e16, 1.0, -1e16, 2.0]), 3.0);
}
