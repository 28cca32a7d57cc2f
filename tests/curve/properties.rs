//! Properties of random hostile curves; failing cases are shrunk.

use crate::support::{exact, largest, real, to_3d, ulp};
use casteljau::glam::{DVec2, DVec3};
use casteljau::{Curve, Point};
use proptest::collection::vec;
use proptest::prelude::*;
use proptest::sample::Index;
use proptest::test_runner::RngSeed;

/// Coordinates that are typical in use, and extreme ones.
fn coordinate() -> impl Strategy<Value = f64> {
    prop_oneof![
        4 => (-4..=4_i32).prop_map(f64::from),
        4 => -100.0..100.0_f64,
        1 => (0..8_i32).prop_map(|k| 1.0 + f64::from(k) * f64::EPSILON),
        1 => -1e150..1e150_f64,
        1 => -1e-300..1e-300_f64,
        1 => prop::sample::select(vec![0.0, -0.0, 1e-320, -5e-324, 1e16, 1e150, -1e150]),
    ]
}

/// A modification of the points after they are drawn.
#[derive(Clone, Debug)]
enum Harm {
    None,
    Coincide(Index, Index),
    Close,
    OnALine,
    NoHandles,
}

fn harm() -> impl Strategy<Value = Harm> {
    prop_oneof![
        3 => Just(Harm::None),
        2 => any::<(Index, Index)>().prop_map(|(a, b)| Harm::Coincide(a, b)),
        1 => Just(Harm::Close),
        1 => Just(Harm::OnALine),
        1 => Just(Harm::NoHandles),
    ]
}

fn points() -> impl Strategy<Value = Vec<DVec3>> {
    let degree = prop_oneof![9 => 1..=8_usize, 1 => 9..=64_usize];
    let drawn = degree.prop_flat_map(|n| vec((coordinate(), coordinate(), coordinate()), n + 1));
    (drawn, harm()).prop_map(|(drawn, harm)| {
        let mut p: Vec<DVec3> = drawn.into_iter().map(DVec3::from).collect();
        let last = p.len() - 1;
        match harm {
            Harm::None => {}
            Harm::Coincide(a, b) => p[a.index(last + 1)] = p[b.index(last + 1)],
            Harm::Close => p[last] = p[0],
            Harm::OnALine => p
                .iter_mut()
                .for_each(|p| *p = DVec3::new(p.x, 0.5 * p.x, -p.x)),
            Harm::NoHandles => (p[1], p[last - 1]) = (p[0], p[last]),
        }
        p
    })
}

fn space(points: &[DVec3]) -> Curve<DVec3> {
    Curve::new(points).expect("finite")
}

fn plane(points: &[DVec3]) -> Curve<DVec2> {
    let points: Vec<DVec2> = points.iter().map(|p| p.truncate()).collect();
    Curve::new(&points).expect("finite")
}

fn all_finite<P: Point>(curve: &Curve<P>) -> bool {
    curve.control_points().iter().all(|p| p.is_finite())
}

/// n ulps of the largest coordinate for n steps of interpolation.
fn rounding(points: &[DVec3]) -> f64 {
    2.0 * (2.0 + real(points.len())) * ulp(largest(points))
}

/// The seed is fixed, so that every run has the same cases and failures can be reproduced.
const SEED: RngSeed = RngSeed::Fixed(1975);

proptest! {
    #![proptest_config(ProptestConfig { cases: 400, failure_persistence: None, rng_seed: SEED, ..ProptestConfig::default() })]

    #[test]
    fn no_nan_comes_out(points in points(), t in 0.0..=1.0_f64, u in 0.0..=1.0_f64) {
        fn check<P: Point>(curve: &Curve<P>, t: f64, u: f64) {
            let (left, right) = curve.split(t);
            let (first, second) = curve.halve();
            for piece in [left, right, first, second, curve.subsegment(t, u), curve.reverse(), curve.derivative()] {
                assert!(all_finite(&piece), "{piece:?}");
            }
            assert!(curve.degree() == 64 || all_finite(&curve.elevate().expect("below 64")));
            let directions = [curve.eval(t), curve.tangent(t), curve.normal(t), curve.derivative_at(t, 1)];
            assert!(directions.iter().all(|p| p.is_finite()), "{directions:?}");
            assert!(!curve.curvature(t).is_nan());
            let bounds = curve.bounds();
            assert!(bounds.min.is_finite() && bounds.max.is_finite());
            assert!(curve.de_casteljau(t).iter().flatten().all(|p| p.is_finite()));
        }
        check(&space(&points), t, u);
        check(&plane(&points), t, u);
        prop_assert!(plane(&points).hull().iter().all(|p| p.is_finite()));
    }

    #[test]
    fn points_stay_in_the_box(points in points(), t in 0.0..=1.0_f64) {
        let curve = space(&points);
        let (p, bounds, slack) = (curve.eval(t), curve.bounds(), DVec3::splat(rounding(&points)));
        prop_assert!(p.cmpge(bounds.min - slack).all() && p.cmple(bounds.max + slack).all(), "{p} in {bounds:?}");
    }

    #[test]
    fn pieces_are_the_curve(points in points(), t in 0..=16_u32, u in 0..=16_u32, s in 0..=16_u32) {
        let curve = space(&points);
        let [t, u, s] = [t, u, s].map(|k| f64::from(k) / 16.0);
        let near = |piece: &Curve<DVec3>, s: f64, t: f64| {
            let difference = exact::eval(piece.control_points(), s) - exact::eval(&points, t);
            difference.abs().max_element() <= rounding(&points)
        };
        let (left, right) = curve.split(t);
        prop_assert!(near(&left, s, t * s));
        prop_assert!(near(&right, s, t + (1.0 - t) * s));
        prop_assert!(near(&curve.subsegment(t, u), s, t + (u - t) * s));
        prop_assert!(near(&curve.reverse(), s, 1.0 - s));
        prop_assert!(curve.degree() == 64 || near(&curve.elevate().expect("below 64"), s, s));
    }

    #[test]
    fn the_tangent_is_the_direction_of_the_derivative(points in points(), t in 1..16_u32) {
        let t = f64::from(t) / 16.0;
        let curve = plane(&points);
        let flat = to_3d(curve.control_points());
        let derivative = exact::derivative(&flat, t, 1);
        // Only where the derivative is not lost in the rounding of the control points.
        let scale = real(points.len()) * largest(&flat);
        prop_assume!(derivative.max_abs() > 1e-6 * scale);
        let difference = curve.tangent(t).extend(0.0) - Point::normalize_or_zero(derivative);
        prop_assert!(difference.length() < 1e-15 * scale / derivative.max_abs() * (2.0 + real(points.len())));
    }
}
