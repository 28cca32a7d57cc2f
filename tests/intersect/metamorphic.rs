//! Rotated, scaled, reversed and swapped pairs have the same intersections.

use crate::intersect::generate::{case, new};
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
    some.iter().all(|p| {
        all.iter()
            .any(|q| (p.0 - q.0).abs().max((p.1 - q.1).abs()) < 1e-6)
    })
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

        let reversed: Vec<(f64, f64)> = a
            .reverse()
            .intersections(&b)
            .iter()
            .map(|p| (1.0 - p.t, p.u))
            .collect();
        assert!(same(&reversed, &fixed), "{}", known("reversed"));

        let turn = DAffine2::from_angle(0.7);
        let turned = locations(
            &a.transform(&turn)
                .expect("a finite image")
                .intersections(&b.transform(&turn).expect("a finite image")),
        );
        assert!(same(&turned, &fixed), "{}", known("turned"));
    }
}

/// Powers of two cause no rounding, so all results are equal, including tangencies and overlaps.
#[test]
fn scaled_by_powers_of_two() {
    for seed in 0..3000 {
        let case = case(&mut Rng(seed));
        let found = case.a.intersections(&case.b);
        for exponent in [-30, 30] {
            let scale = |c: &Curve<DVec2>| {
                let points: Vec<DVec2> = c
                    .control_points()
                    .iter()
                    .map(|p| *p * 2_f64.powi(exponent))
                    .collect();
                new(&points)
            };
            let scaled = scale(&case.a).intersections(&scale(&case.b));
            let plain = |found: &[Intersection]| {
                found.iter().map(|p| (p.t, p.u, p.kind)).collect::<Vec<_>>()
            };
            assert_eq!(plain(&found), plain(&scaled), "{} (seed {seed})", case.name);
        }
    }
}
