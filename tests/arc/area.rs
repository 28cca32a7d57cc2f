//! Areas and moments, compared with closed forms, polygons and an integral in double the precision of f64.

use crate::support::adversarial::{self, ALL, ORDINARY};
use crate::support::{
    Rng, bezier, binomial, cases, curve, exact, largest, near, near_at, real, spline,
};
use casteljau::curve::Moments;
use casteljau::glam::{DAffine2, DVec2, DVec3};
use casteljau::{Curve, MAX_COORDINATE};
use std::f64::consts::PI;

#[test]
fn closed_forms() {
    // The region below y = 1 − x³, as a sector from the origin: an example from kurbo.
    let third = 1.0 / 3.0;
    let cubic = bezier(&format!("1 0, {} 1, {third} 1, 0 1", 2.0 * third));
    near(cubic.area(), 0.75, 1e-15);
    // The triangle (0,0) (2,0) (0,3).
    let line = bezier("2 0, 0 3");
    let expected = [3.0, 2.0, 3.0, 2.0, 1.5, 4.5];
    all_near(&line, numbers(line.moments()), expected, 4e-15);
    assert_eq!((line.area(), line.reverse().area()), (3.0, -3.0));
    // A parabola and its chord: two thirds of the bounding box.
    let arch = [bezier("0 0, 1 2, 2 0"), bezier("2 0, 0 0")];
    let arch = casteljau::Spline::from_curves(&arch, true).expect("closed");
    near(arch.area(), -4.0 / 3.0, 1e-15);
}

#[test]
fn a_closed_spline_encloses_the_same_anywhere() {
    // A circle of four arcs, with the usual handle length; its area is not exactly π.
    let text = "1 0, 1 k, k 1, 0 1, -k 1, -1 k, -1 0, -1 -k, -k -1, 0 -1, k -1, 1 -k";
    let unit = spline(&text.replace('k', "0.5522847498307934"), 3, true);
    let area = unit.area();
    near(area, PI, 1e-3);
    let scaled = |size: f64| {
        let map = DAffine2::from_scale(DVec2::splat(size));
        unit.transform(&map).expect("a finite image").area()
    };
    let moved = DAffine2::from_translation(DVec2::new(1e6, -3e6));
    near(
        unit.transform(&moved).expect("a finite image").area(),
        area,
        1e-8,
    );
    near(scaled(1e150) / 1e300, area, 1e-14);
    near(scaled(3e150) / 9e300, area, 1e-14);
    assert_eq!(scaled(1e-200), 0.0);
}

/// ½ ∫ (x dy − y dx), with sums in double the precision of f64.
fn exact_area(points: &[DVec3]) -> f64 {
    let n = points.len() - 1;
    let mut sum = exact::exactly(0.0);
    for (i, p) in points.iter().enumerate() {
        for (j, w) in points.windows(2).enumerate() {
            // ∫ Bᵢⁿ Bⱼⁿ⁻¹ = C(n,i) C(n−1,j) / C(2n−1,i+j) / 2n, and B′ = n Σ Δⱼ Bⱼⁿ⁻¹.
            let share = binomial(n, i) * binomial(n - 1, j) / binomial(2 * n - 1, i + j) * 0.25;
            let step = [0, 1].map(|axis| exact::two_sum(w[1][axis], -w[0][axis]));
            let swept = exact::exactly(p.x) * step[1] - exact::exactly(p.y) * step[0];
            sum = sum + swept * exact::exactly(share);
        }
    }
    sum.hi
}

#[test]
fn area_is_the_integral() {
    let mut rng = Rng(1821);
    for case in 0..cases(20_000, 500_000) {
        let kind = rng.pick(&ORDINARY);
        let degree = 1 + rng.below(if case % 20 == 0 { 64 } else { 6 });
        let points = adversarial::points(&mut rng, kind, degree, 2);
        let curve: Curve<DVec2> = curve(&points);
        let size = largest(&points);
        let slack = 1e-15 * real(degree + 3) * size * size;
        near_at(curve.area(), exact_area(&points), slack, &points);
        near_at(curve.moments().area, curve.area(), slack, &points);
        near_at(curve.reverse().area(), -curve.area(), slack, &points);
    }
}

/// The moments of a polygon's sector from the origin, summed over triangles.
fn of_polygon(points: &[DVec2]) -> [f64; 6] {
    let mut sum = [0.0; 6];
    for pair in points.windows(2) {
        let (a, b) = (pair[0], pair[1]);
        let share = a.perp_dot(b) / 6.0;
        // The midpoints of the sides give a quadrature that is exact up to degree 2.
        for p in [0.5 * a, 0.5 * b, 0.5 * (a + b)] {
            let terms = [1.0, p.x, p.y, p.x * p.x, p.x * p.y, p.y * p.y];
            (0..6).for_each(|k| sum[k] += share * terms[k]);
        }
    }
    sum
}

fn numbers(m: Moments) -> [f64; 6] {
    [m.area, m.x, m.y, m.xx, m.xy, m.yy]
}

fn all_near(curve: &Curve<DVec2>, got: [f64; 6], expected: [f64; 6], slack: f64) {
    (0..6).for_each(|k| near_at(got[k], expected[k], slack, (k, curve)));
}

#[test]
fn moments_are_the_limit_of_polygons() {
    let mut rng = Rng(1828);
    for degree in [1, 2, 3, 4, 5, 8, 9, 16, 17, 33, 64] {
        let points = adversarial::points(&mut rng, adversarial::Kind::Random, degree, 2);
        let curve: Curve<DVec2> = curve(&points);
        let moments = numbers(curve.moments());
        let [coarse, fine] = [2000, 4000].map(|n| of_polygon(&curve.sample(n).expect("samples")));
        // Richardson extrapolation: the polygon's error falls with the square of the step.
        let limit = [0, 1, 2, 3, 4, 5].map(|k| (4.0 * fine[k] - coarse[k]) / 3.0);
        all_near(&curve, moments, limit, 1e-9);
        let (left, right) = curve.split(0.3);
        let mut sum = left.moments();
        sum += right.moments();
        all_near(&curve, numbers(sum), moments, 1e-14 * real(degree + 3));
    }
}

#[test]
fn no_nan_for_any_size() {
    let mut rng = Rng(1830);
    let far = [(1.0, -1.0), (-1.0, 1.0), (1.0, 1.0)].map(|p| DVec2::from(p) * MAX_COORDINATE);
    let mut curves = vec![Curve::new(&far).expect("finite")];
    for kind in ALL {
        for degree in [1, 2, 3, 5, 64] {
            curves.push(curve(&adversarial::points(&mut rng, kind, degree, 2)));
        }
    }
    for curve in curves {
        let all = numbers(curve.moments());
        let valid = !curve.area().is_nan() && all.iter().all(|v| !v.is_nan());
        assert!(valid, "{curve:?}: {all:?}");
    }
}
