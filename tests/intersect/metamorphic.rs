//! Rotated, scaled, reversed and swapped pairs have the same intersections.

use crate::intersect::generate::{case, new};
use crate::intersect::kinds;
use crate::support::Rng;
use casteljau::Curve;
use casteljau::curve::{Intersection, IntersectionKind};
use casteljau::glam::{DAffine2, DVec2};

/// Intersections that do not depend on rounding: crossings at an angle, away from ends.
fn firm(found: &[Intersection], a: &Curve<DVec2>, b: &Curve<DVec2>) -> Vec<(f64, f64)> {
    let inside = |t: f64| t > 1e-3 && t < 1.0 - 1e-3;
    found
        .iter()
        .filter(|p| p.kind == IntersectionKind::Cross && inside(p.t) && inside(p.u))
        .filter(|p| a.tangent(p.t).perp_dot(b.tangent(p.u)).abs() > 1e-2)
        // Next to a cusp an intersection is known only to the cube root of rounding.
        .filter(|p| runs(a, p.t) && runs(b, p.u))
        .map(|p| (p.t, p.u))
        .collect()
}

fn runs(c: &Curve<DVec2>, t: f64) -> bool {
    c.derivative_at(t, 1).length() > 1e-2 * c.control_bounds().diagonal()
}

fn same(all: &[(f64, f64)], some: &[(f64, f64)]) -> bool {
    let near = |p: (f64, f64), q: (f64, f64)| (p.0 - q.0).abs().max((p.1 - q.1).abs()) < 1e-6;
    some.iter().all(|&p| all.iter().any(|&q| near(p, q)))
}

fn locations(found: &[Intersection]) -> Vec<(f64, f64)> {
    found.iter().map(|p| (p.t, p.u)).collect()
}

#[test]
fn the_results_follow() {
    for seed in 0..6000 {
        let case = case(&mut Rng(seed));
        let (a, b) = (case.a, case.b);
        let found = a.intersections(&b);
        // A piece from a parameter to itself is a point whose shape is rounding noise.
        let size = |c: &Curve<DVec2>| c.control_bounds().diagonal();
        if size(&a).min(size(&b)) < 1e-9 * size(&a).max(size(&b)) {
            continue;
        }
        let fixed = firm(&found, &a, &b);
        let known = |how: &str| format!("{} (seed {seed}), {how}: {found:?}", case.name);

        let swapped: Vec<(f64, f64)> = b.intersections(&a).iter().map(|p| (p.u, p.t)).collect();
        assert!(same(&swapped, &fixed), "{}", known("swapped"));

        let reversed = locations(&a.reverse().intersections(&b));
        let reversed: Vec<(f64, f64)> = reversed.iter().map(|&(t, u)| (1.0 - t, u)).collect();
        assert!(same(&reversed, &fixed), "{}", known("reversed"));

        let turn = DAffine2::from_angle(0.7);
        let turned = |c: &Curve<DVec2>| c.transform(&turn).expect("a finite image");
        let turned = locations(&turned(&a).intersections(&turned(&b)));
        assert!(same(&turned, &fixed), "{}", known("turned"));
    }
}

/// Powers of two cause no rounding, so all results are equal, including tangencies and overlaps.
#[test]
fn scaled_by_powers_of_two() {
    for seed in 0..3000 {
        let case = case(&mut Rng(seed));
        let found = kinds(&case.a.intersections(&case.b));
        for factor in [-30, 30].map(|exponent| 2_f64.powi(exponent)) {
            let scale = |c: &Curve<DVec2>| {
                let points = c.control_points().iter().map(|p| *p * factor);
                new(&points.collect::<Vec<_>>())
            };
            let scaled = kinds(&scale(&case.a).intersections(&scale(&case.b)));
            assert_eq!(found, scaled, "{} (seed {seed})", case.name);
        }
    }
}
