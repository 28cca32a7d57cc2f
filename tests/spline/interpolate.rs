//! Interpolating splines: the textbook equations, the joints, coincident points, huge coordinates, linear time.

use crate::spline::{continuity, is_finite};
use crate::support::{Rng, Space, all_near, largest, near, near_at};
use crate::support::{random_points, real, xy};
use casteljau::curve::Basis;
use casteljau::glam::{DVec2, DVec3};
use casteljau::spline::Interpolation::{self, CatmullRom, Natural};
use casteljau::{Curve, Point, Spline};
#[cfg(target_family = "wasm")]
use wasm_bindgen_test::wasm_bindgen_test as test;

const KINDS: [Interpolation; 5] = [
    Natural,
    CatmullRom { alpha: 0.0 },
    CatmullRom { alpha: 0.5 },
    CatmullRom { alpha: 1.0 },
    CatmullRom { alpha: 0.3 },
];

fn cases() -> usize {
    crate::support::cases(20_000, 1_000_000)
}

fn interpolate<P: Point>(points: &[P], kind: Interpolation, closed: bool) -> Spline<P> {
    Spline::interpolate(points, kind, closed).expect("points")
}

/// The equations themselves, which have a unique solution: C2 at every joint, zero second derivative at free ends.
fn natural<P: Space>(seed: u64) {
    let mut rng = Rng(seed);
    for round in 0..600 {
        let closed = round % 2 == 0;
        let p = random_points::<P>(&mut rng, 2 + (round * 7 % 61).min(round));
        let spline = interpolate(&p, Natural, closed);
        let n = spline.segment_count();
        let expected = (p.len() - usize::from(!closed), closed);
        assert_eq!((n, spline.is_closed()), expected);
        for (k, &point) in p.iter().enumerate() {
            assert_eq!(spline.eval(real(k)), point);
        }
        let segments = spline.segments().collect::<Vec<_>>();
        for joint in usize::from(!closed)..n {
            let (left, right) = (&segments[(joint + n - 1) % n], &segments[joint]);
            for order in [1, 2] {
                let (a, b) = (
                    left.derivative_at(1.0, order),
                    right.derivative_at(0.0, order),
                );
                near_at(a, b, 1e-13, (p.len(), joint));
            }
        }
        if !closed {
            let start = segments[0].derivative_at(0.0, 2);
            let end = segments[n - 1].derivative_at(1.0, 2);
            assert!(start.max_abs().max(end.max_abs()) < 1e-13);
        }
    }
}

#[test]
fn natural_splines_solve_their_equations() {
    natural::<DVec2>(101);
    natural::<DVec3>(102);
}

/// Parameters from chord lengths, then the textbook's tangent.
fn tangents<P: Point>([a, b, c]: [P; 3], alpha: f64) -> (P, P) {
    let (d1, d2) = ((b - a).norm().powf(alpha), (c - b).norm().powf(alpha));
    let t = (b - a) / d1 - (c - a) / (d1 + d2) + (c - b) / d2;
    (t * d1, t * d2)
}

fn catmull_rom<P: Space>(seed: u64) {
    let mut rng = Rng(seed);
    for round in 0..600 {
        let closed = round % 2 == 0;
        let alpha = [0.0, 0.5, 1.0, rng.unit()][round / 2 % 4];
        let p = random_points::<P>(&mut rng, 3 + round % 9);
        let spline = interpolate(&p, CatmullRom { alpha }, closed);
        let (n, q) = (p.len(), spline.control_points());
        for i in usize::from(!closed)..n - usize::from(!closed) {
            let (behind, ahead) = tangents([p[(i + n - 1) % n], p[i], p[(i + 1) % n]], alpha);
            assert_eq!(q[3 * i], p[i]);
            let before = q[(3 * i + q.len() - 1) % q.len()];
            near_at(before, p[i] - behind / 3.0, 1e-13, alpha);
            near_at(q[3 * i + 1], p[i] + ahead / 3.0, 1e-13, alpha);
        }
        if !closed {
            near(q[1], p[0] + (p[1] - p[0]) / 3.0, 1e-15);
            near(
                q[q.len() - 2],
                p[n - 1] - (p[n - 1] - p[n - 2]) / 3.0,
                1e-15,
            );
        }
    }
}

#[test]
fn catmull_rom_splines_have_the_tangents_of_the_book() {
    catmull_rom::<DVec2>(103);
    catmull_rom::<DVec3>(104);
}

#[test]
fn uniform_ones_are_the_classical_basis() {
    let p = [(0.0, 0.0), (1.0, 1.0), (3.0, 1.0), (4.0, 0.0)].map(DVec2::from);
    let spline = interpolate(&p, CatmullRom { alpha: 0.0 }, false);
    let basis = Curve::from_basis(Basis::CatmullRom, p).expect("four");
    all_near(
        &spline.control_points()[3..7],
        basis.control_points(),
        1e-15,
    );
    // Three points in a ring: a closed spline has a joint at each.
    let ring = interpolate(&p[..3], CatmullRom { alpha: 0.0 }, true);
    assert!((0..3).all(|k| continuity(&ring, k, None).c1));
}

#[test]
fn two_points_make_a_line() {
    let p = xy("1 2, 4 -1");
    for kind in KINDS {
        let line = interpolate(&p, kind, false);
        all_near(line.control_points(), &xy("1 2, 2 1, 3 0, 4 -1"), 1e-15);
        let back = interpolate(&p, kind, true);
        assert_eq!(back.segment_count(), 2);
        let on_line = |q: &DVec2| (q.x + q.y - 3.0).abs() < 1e-15;
        assert!(back.control_points().iter().all(on_line), "{kind:?}");
    }
}

#[test]
fn a_point_that_comes_twice_is_a_corner() {
    let p = xy("0 0, 1 0, 1 0, 1 1");
    let spline = interpolate(&p, CatmullRom { alpha: 0.5 }, false);
    let q = spline.control_points();
    assert!(q[3..=6].iter().all(|&q| q == p[1]));
    near(q[2], DVec2::new(2.0 / 3.0, 0.0), 1e-15);
    near(q[7], DVec2::new(1.0, 1.0 / 3.0), 1e-15);
}

/// Hostile points: the result is finite, passes through all points, and is equivariant under scaling and reversal.
fn adversarial<P: Space>(seed: u64) {
    let mut rng = Rng(seed);
    for case in 0..cases() / 4 {
        let mut p = random_points::<P>(&mut rng, 2 + case % 7);
        let last = p.len() - 1;
        match rng.below(6) {
            0 => p[last] = p[0],
            1 => p[1] = p[0],
            2 => p = vec![p[0]; last + 1],
            3 => p
                .iter_mut()
                .for_each(|q| *q = P::of(DVec3::X * q.coordinate(0))),
            4 => p[last] = p[last] * 1e-200,
            _ => {}
        }
        let (kind, closed) = (rng.pick(&KINDS), rng.chance(0.5));
        let plain = interpolate(&p, kind, closed);
        for scale in [1.0, 1e9, 1e-9, 1e150, 3.2e150, 1e-300, 5e-324] {
            let scaled: Vec<P> = p.iter().map(|&q| q * scale).collect();
            let spline = interpolate(&scaled, kind, closed);
            assert!(is_finite(&spline), "{kind:?} {scale:e}");
            for (k, &q) in scaled.iter().enumerate() {
                assert_eq!(spline.control_points()[3 * k], q);
            }
            if (1e-10..1e10).contains(&scale) {
                let back: Vec<P> = spline.control_points().iter().map(|&q| q / scale).collect();
                all_near(&back, plain.control_points(), 1e-12);
            }
        }
        p.reverse();
        if closed {
            p.rotate_right(1);
        }
        let back = interpolate(&p, kind, closed);
        assert!(back.approx_eq(&plain.reverse(), 1e-13), "{kind:?} {closed}");
    }
}

#[test]
fn any_points() {
    adversarial::<DVec2>(105);
    adversarial::<DVec3>(106);
}

#[test]
fn a_million_points() {
    let point = |i: u32| DVec2::new(f64::from(i), f64::from(i % 7));
    let p: Vec<DVec2> = (0..1_000_000).map(point).collect();
    let centripetal = CatmullRom { alpha: 0.5 };
    for (kind, closed) in [(Natural, false), (Natural, true), (centripetal, true)] {
        let spline = interpolate(&p, kind, closed);
        assert_eq!(spline.eval(777_777.0), p[777_777]);
        let size = largest(&spline.control_points()[..300]);
        assert!(size < 105.0 || closed, "{size}");
    }
}
