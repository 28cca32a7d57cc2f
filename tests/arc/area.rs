//! Areas and moments, compared with closed forms, polygons and an integral in double the precision of f64.

use crate::support::adversarial::{self, ALL, ORDINARY};
use crate::support::{Rng, cases, curve, exact, largest, plane, real};
use casteljau::curve::Moments;
use casteljau::glam::{DVec2, DVec3};
use casteljau::{Curve, MAX_COORDINATE, Spline};

fn close(got: f64, expected: f64, slack: f64) {
    assert!(
        (got - expected).abs() <= slack,
        "{got}, expected {expected}"
    );
}

#[test]
fn closed_forms() {
    // The region below y = 1 − x³, as a sector from the origin: an example from kurbo.
    let third = 1.0 / 3.0;
    close(
        plane(&[(1., 0.), (2. * third, 1.), (third, 1.), (0., 1.)]).area(),
        0.75,
        1e-15,
    );
    // The triangle (0,0) (2,0) (0,3).
    let line = plane(&[(2., 0.), (0., 3.)]);
    all_close(
        numbers(line.moments()),
        [3.0, 2.0, 3.0, 2.0, 1.5, 4.5],
        4e-15,
    );
    assert_eq!(line.area(), 3.0);
    assert_eq!(line.reverse().area(), -3.0);
    // A parabola and its chord: two thirds of the bounding box.
    let arch = Spline::from_curves(
        &[
            plane(&[(0., 0.), (1., 2.), (2., 0.)]),
            plane(&[(2., 0.), (0., 0.)]),
        ],
        true,
    );
    close(arch.expect("closed").area(), -4. / 3., 1e-15);
}

#[test]
fn a_closed_spline_encloses_the_same_anywhere() {
    // A circle of four arcs, with the usual handle length; its area is not exactly π.
    let k = 0.552_284_749_830_793_4;
    let points = [
        (1., 0.),
        (1., k),
        (k, 1.),
        (0., 1.),
        (-k, 1.),
        (-1., k),
        (-1., 0.),
        (-1., -k),
        (-k, -1.),
        (0., -1.),
        (k, -1.),
        (1., -k),
    ];
    let circle = |at: DVec2, r: f64| {
        let points: Vec<DVec2> = points
            .iter()
            .map(|&(x, y)| at + DVec2::new(x, y) * r)
            .collect();
        Spline::new(&points, 3, true).expect("a circle")
    };
    let unit = circle(DVec2::ZERO, 1.0).area();
    close(unit, std::f64::consts::PI, 1e-3);
    close(circle(DVec2::new(1e6, -3e6), 1.0).area(), unit, 1e-8);
    close(circle(DVec2::ZERO, 1e150).area() / 1e300, unit, 1e-14);
    assert_eq!(circle(DVec2::ZERO, 1e-200).area(), 0.0);
    close(circle(DVec2::ZERO, 3e150).area() / 9e300, unit, 1e-14);
}

/// ½ ∫ (x dy − y dx), with sums in double the precision of f64.
fn exact_area(points: &[DVec3]) -> f64 {
    let x: Vec<f64> = points.iter().map(|p| p.x).collect();
    let y: Vec<f64> = points.iter().map(|p| p.y).collect();
    let n = x.len() - 1;
    let binomial = |n: usize, k: usize| (0..k).fold(1.0, |c, i| c * real(n - i) / real(i + 1));
    let mut sum = exact::exactly(0.0);
    for i in 0..=n {
        for j in 0..n {
            // ∫ Bᵢⁿ Bⱼⁿ⁻¹ = C(n,i) C(n−1,j) / C(2n−1,i+j) / 2n, and B′ = n Σ Δⱼ Bⱼⁿ⁻¹.
            let share = binomial(n, i) * binomial(n - 1, j) / binomial(2 * n - 1, i + j) * 0.25;
            let step = |v: &[f64]| exact::two_sum(v[j + 1], -v[j]);
            let swept = exact::exactly(x[i]) * step(&y) - exact::exactly(y[i]) * step(&x);
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
        let degree = if case % 20 == 0 {
            1 + rng.below(64)
        } else {
            1 + rng.below(6)
        };
        let points = adversarial::points(&mut rng, kind, degree, 2);
        let curve: Curve<DVec2> = curve(&points);
        let size = largest(&points);
        let slack = 1e-15 * real(degree + 3) * size * size;
        close(curve.area(), exact_area(&points), slack);
        close(curve.moments().area, curve.area(), slack);
        close(curve.reverse().area(), -curve.area(), slack);
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
            sum.iter_mut()
                .zip(terms)
                .for_each(|(sum, term)| *sum += share * term);
        }
    }
    sum
}

fn numbers(m: Moments) -> [f64; 6] {
    [m.area, m.x, m.y, m.xx, m.xy, m.yy]
}

fn all_close(got: [f64; 6], expected: [f64; 6], slack: f64) {
    got.iter()
        .zip(expected)
        .for_each(|(&g, e)| close(g, e, slack));
}

#[test]
fn moments_are_the_limit_of_polygons() {
    let mut rng = Rng(1828);
    for degree in [1, 2, 3, 4, 5, 8, 9, 16, 17, 33, 64] {
        let curve: Curve<DVec2> = curve(&adversarial::points(
            &mut rng,
            adversarial::Kind::Random,
            degree,
            2,
        ));
        let [coarse, fine] = [2000, 4000].map(|n| of_polygon(&curve.sample(n).expect("samples")));
        // Richardson extrapolation: the polygon's error falls with the square of the step.
        let limit = [0, 1, 2, 3, 4, 5].map(|k| (4.0 * fine[k] - coarse[k]) / 3.0);
        all_close(numbers(curve.moments()), limit, 1e-9);
        let (left, right) = curve.split(0.3);
        let mut sum = left.moments();
        sum += right.moments();
        all_close(
            numbers(sum),
            numbers(curve.moments()),
            1e-14 * real(degree + 3),
        );
    }
}

#[test]
fn no_nan_for_any_size() {
    let mut rng = Rng(1830);
    for kind in ALL {
        for degree in [1, 2, 3, 5, 64] {
            let curve: Curve<DVec2> = curve(&adversarial::points(&mut rng, kind, degree, 2));
            let all = numbers(curve.moments());
            assert!(
                !curve.area().is_nan() && all.iter().all(|v| !v.is_nan()),
                "{curve:?}: {all:?}"
            );
        }
    }
    let far = plane(&[
        (MAX_COORDINATE, -MAX_COORDINATE),
        (-MAX_COORDINATE, MAX_COORDINATE),
        (MAX_COORDINATE, MAX_COORDINATE),
    ]);
    assert!(!far.area().is_nan() && !far.moments().xx.is_nan());
}
