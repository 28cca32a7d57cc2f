//! Interpolating splines: the textbook equations, the joints, coincident points, huge coordinates, linear time.

use crate::support::{Rng, Space, apart, largest, real};
use casteljau::glam::{DVec2, DVec3};
use casteljau::spline::Interpolation::{self, CatmullRom, Natural};
use casteljau::{Error, Point, Spline};
use wasm_bindgen_test::wasm_bindgen_test;

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

fn points<P: Space>(rng: &mut Rng, count: usize) -> Vec<P> {
    (0..count).map(|_| P::of(rng.point(P::DIMENSION))).collect()
}

fn interpolate<P: Point>(points: &[P], kind: Interpolation, closed: bool) -> Spline<P> {
    Spline::interpolate(points, kind, closed).expect("points")
}

/// The equations themselves, which have a unique solution: C2 at every joint, zero second derivative at free ends.
fn natural<P: Space>(seed: u64) {
    let mut rng = Rng(seed);
    for round in 0..600 {
        let closed = round % 2 == 0;
        let p = points::<P>(&mut rng, 2 + (round * 7 % 61).min(round));
        let spline = interpolate(&p, Natural, closed);
        let n = spline.segment_count();
        assert_eq!(
            (n, spline.is_closed()),
            (p.len() - usize::from(!closed), closed)
        );
        for (k, &point) in p.iter().enumerate() {
            assert_eq!(spline.eval(real(k)), point);
        }
        let segments = spline.segments().collect::<Vec<_>>();
        for joint in usize::from(!closed)..n {
            let (left, right) = (&segments[(joint + n - 1) % n], &segments[joint]);
            for order in [1, 2] {
                let off = apart(
                    left.derivative_at(1.0, order),
                    right.derivative_at(0.0, order),
                );
                assert!(off < 1e-13, "{} points, joint {joint}: {off:e}", p.len());
            }
        }
        if !closed {
            let (start, end) = (
                segments[0].derivative_at(0.0, 2),
                segments[n - 1].derivative_at(1.0, 2),
            );
            assert!(start.max_abs().max(end.max_abs()) < 1e-13);
        }
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn natural_splines_solve_their_equations() {
    natural::<DVec2>(101);
    natural::<DVec3>(102);
}

/// Parameters from chord lengths, then the textbook's tangent.
fn tangents<P: Point>([a, b, c]: [P; 3], alpha: f64) -> (P, P) {
    let (d1, d2) = ((b - a).length().powf(alpha), (c - b).length().powf(alpha));
    let t = (b - a) / d1 - (c - a) / (d1 + d2) + (c - b) / d2;
    (t * d1, t * d2)
}

fn catmull_rom<P: Space>(seed: u64) {
    let mut rng = Rng(seed);
    for round in 0..600 {
        let closed = round % 2 == 0;
        let alpha = [0.0, 0.5, 1.0, rng.unit()][round / 2 % 4];
        let p = points::<P>(&mut rng, 3 + round % 9);
        let spline = interpolate(&p, CatmullRom { alpha }, closed);
        let (n, q) = (p.len(), spline.control_points());
        for i in usize::from(!closed)..n - usize::from(!closed) {
            let (behind, ahead) = tangents([p[(i + n - 1) % n], p[i], p[(i + 1) % n]], alpha);
            assert_eq!(q[3 * i], p[i]);
            let before = q[(3 * i + q.len() - 1) % q.len()];
            assert!(apart(before, p[i] - behind / 3.0) < 1e-13, "alpha {alpha}");
            assert!(
                apart(q[3 * i + 1], p[i] + ahead / 3.0) < 1e-13,
                "alpha {alpha}"
            );
        }
        if !closed {
            assert!(apart(q[1], p[0] + (p[1] - p[0]) / 3.0) < 1e-15);
            assert!(apart(q[q.len() - 2], p[n - 1] - (p[n - 1] - p[n - 2]) / 3.0) < 1e-15);
        }
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn catmull_rom_splines_have_the_tangents_of_the_book() {
    catmull_rom::<DVec2>(103);
    catmull_rom::<DVec3>(104);
}

#[wasm_bindgen_test(unsupported = test)]
fn uniform_ones_are_the_classical_basis() {
    let p = [(0.0, 0.0), (1.0, 1.0), (3.0, 1.0), (4.0, 0.0)].map(DVec2::from);
    let spline = interpolate(&p, CatmullRom { alpha: 0.0 }, false);
    let basis = casteljau::Curve::from_basis(casteljau::curve::Basis::CatmullRom, p).expect("four");
    assert!(
        spline
            .segment(1)
            .expect("a segment")
            .approx_eq(&basis, 1e-15)
    );
    // Three points in a ring: a closed spline has a joint at each.
    let ring = interpolate(&p[..3], CatmullRom { alpha: 0.0 }, true);
    assert!((0..3).all(|k| ring.continuity(k, None).expect("a joint").c1));
}

#[wasm_bindgen_test(unsupported = test)]
fn two_points_make_a_line() {
    let p = [DVec2::new(1.0, 2.0), DVec2::new(4.0, -1.0)];
    for kind in KINDS {
        let line = interpolate(&p, kind, false);
        let thirds = [
            p[0],
            p[0].lerp(p[1], 1.0 / 3.0),
            p[0].lerp(p[1], 2.0 / 3.0),
            p[1],
        ];
        assert!(
            line.approx_eq(&Spline::new(&thirds, 3, false).expect("a line"), 1e-15),
            "{kind:?}"
        );
        let back = interpolate(&p, kind, true);
        assert_eq!(back.segment_count(), 2);
        assert!(
            back.control_points()
                .iter()
                .all(|q| (q.x - 1.0) + (q.y - 2.0) == 0.0 || (q.x + q.y - 3.0).abs() < 1e-15)
        );
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn a_point_that_comes_twice_is_a_corner() {
    let p = [(0.0, 0.0), (1.0, 0.0), (1.0, 0.0), (1.0, 1.0)].map(DVec2::from);
    let spline = interpolate(&p, CatmullRom { alpha: 0.5 }, false);
    let q = spline.control_points();
    assert!(q[3..=6].iter().all(|&q| q == p[1]));
    assert!(
        apart(q[2], DVec2::new(2.0 / 3.0, 0.0)) < 1e-15
            && apart(q[7], DVec2::new(1.0, 1.0 / 3.0)) < 1e-15
    );
}

/// Hostile points: the result is finite, passes through all points, and is equivariant under scaling and reversal.
fn adversarial<P: Space>(seed: u64) {
    let mut rng = Rng(seed);
    for case in 0..cases() / 4 {
        let mut p = points::<P>(&mut rng, 2 + case % 7);
        let last = p.len() - 1;
        match rng.below(6) {
            0 => p[last] = p[0],
            1 => p[1] = p[0],
            2 => p = vec![p[0]; last + 1],
            3 => p
                .iter_mut()
                .for_each(|q| *q = P::of(DVec3::new(q.coordinate(0), 0.0, 0.0))),
            4 => p[last] = p[last] * 1e-200,
            _ => {}
        }
        let (kind, closed) = (rng.pick(&KINDS), rng.chance(0.5));
        let plain = interpolate(&p, kind, closed);
        for scale in [1.0, 1e9, 1e-9, 1e150, 3.2e150, 1e-300, 5e-324] {
            let scaled: Vec<P> = p.iter().map(|&q| q * scale).collect();
            let spline = interpolate(&scaled, kind, closed);
            assert!(
                spline
                    .control_points()
                    .iter()
                    .all(|q| q.max_abs().is_finite()),
                "{kind:?} {scale:e}"
            );
            for (k, &q) in scaled.iter().enumerate() {
                assert_eq!(spline.control_points()[3 * k], q);
            }
            if (1e-10..1e10).contains(&scale) {
                let back: Vec<P> = spline.control_points().iter().map(|&q| q / scale).collect();
                let off = back
                    .iter()
                    .zip(plain.control_points())
                    .map(|(&a, &b)| apart(a, b));
                assert!(off.fold(0.0, f64::max) < 1e-12, "{kind:?} {scale:e}");
            }
        }
        p.reverse();
        if closed {
            p.rotate_right(1);
        }
        assert!(
            interpolate(&p, kind, closed).approx_eq(&plain.reverse(), 1e-13),
            "{kind:?} {closed}"
        );
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn any_points() {
    adversarial::<DVec2>(105);
    adversarial::<DVec3>(106);
}

#[wasm_bindgen_test(unsupported = test)]
fn a_million_points() {
    let p: Vec<DVec2> = (0..1_000_000_u32)
        .map(|i| DVec2::new(f64::from(i), f64::from(i % 7)))
        .collect();
    for (kind, closed) in [
        (Natural, false),
        (Natural, true),
        (CatmullRom { alpha: 0.5 }, true),
    ] {
        let spline = interpolate(&p, kind, closed);
        assert_eq!(spline.eval(777_777.0), p[777_777]);
        let size = largest(&spline.control_points()[..300]);
        assert!(size < 105.0 || closed, "{size}");
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn refusals() {
    for count in [0, 1] {
        let few = vec![DVec2::ZERO; count];
        for kind in KINDS {
            let refused = Spline::interpolate(&few, kind, true);
            assert!(
                matches!(refused, Err(Error::Count { what: "points", got, .. }) if got == count)
            );
        }
    }
    for alpha in [-0.1, 1.1, f64::NAN, f64::INFINITY] {
        let refused = Spline::interpolate(&[DVec2::ZERO; 3], CatmullRom { alpha }, false);
        assert!(matches!(refused, Err(Error::Range { what: "alpha", .. })));
    }
    let bad = [DVec2::ZERO, DVec2::new(0.0, f64::NAN)];
    assert!(matches!(
        Spline::interpolate(&bad, Natural, false),
        Err(Error::NotFinite { index: 1, .. })
    ));
}
