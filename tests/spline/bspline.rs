//! B-splines, compared with the Cox–de Boor recursion: any degree, clamped and unclamped, repeated knots, closed; and
//! conversion back.

use crate::spline::continuity;
use crate::support::{Rng, Space, all_near, apart, largest, near, near_at};
use crate::support::{random_points, real, refused, xy};
use casteljau::curve::Basis;
use casteljau::glam::{DVec2, DVec3};
use casteljau::spline::BSpline;
use casteljau::{Curve, Error, Point, Spline};
#[cfg(target_family = "wasm")]
use wasm_bindgen_test::wasm_bindgen_test as test;

fn cases() -> usize {
    crate::support::cases(4_000, 200_000)
}

fn open<P: Point>(points: &[P], degree: usize, knots: &[f64]) -> Spline<P> {
    Spline::from_bspline(points, degree, Some(knots), false).expect("a B-spline")
}

/// The basis functions by their definition; 0/0 is 0, and the last span includes its end.
fn basis(u: &[f64], i: usize, p: usize, x: f64, end: f64) -> f64 {
    if p == 0 {
        let last = x == end && u[i] < x && u[i + 1] == x;
        let inside = (u[i] <= x && x < u[i + 1] && x != end) || last;
        return if inside { 1.0 } else { 0.0 };
    }
    let part = |from: f64, to: f64, x: f64| {
        if to > from {
            (x - from) / (to - from)
        } else {
            0.0
        }
    };
    let left = part(u[i], u[i + p], x);
    let right = part(-u[i + p + 1], -u[i + 1], -x);
    left * basis(u, i, p - 1, x, end) + right * basis(u, i + 1, p - 1, x, end)
}

/// The curve at x as the sum of all basis functions.
fn slow<P: Point>(points: &[P], u: &[f64], p: usize, x: f64, end: f64) -> P {
    let add = |sum: P, (i, &point): (usize, &P)| sum + point * basis(u, i, p, x, end);
    points.iter().enumerate().fold(P::default(), add)
}

/// Ascending knots, often repeated, often clamped, equally or unequally spaced.
fn knots(rng: &mut Rng, count: usize, p: usize) -> Vec<f64> {
    let (clamped, even) = (rng.chance(0.5), rng.chance(0.3));
    let needed = count + p + 1;
    let mut u: Vec<f64> = Vec::new();
    let mut x = rng.signed();
    while u.len() < needed {
        let inside = !clamped || (u.len() > p && u.len() + p < needed);
        let repeated = inside && rng.chance(0.3);
        let times = if repeated { 1 + rng.below(p) } else { 1 };
        u.extend(std::iter::repeat_n(x, times.min(needed - u.len())));
        let step = |rng: &mut Rng| 0.05 + rng.unit() * rng.magnitude(-2.0, 1.0);
        x += if even { 1.0 } else { step(rng) };
    }
    if clamped {
        let (first, last) = (u[0] - 1.0, x + 1.0);
        u[..=p].fill(first);
        u[count..].fill(last);
    }
    u
}

fn matches<P: Space>(seed: u64) {
    let mut rng = Rng(seed);
    for case in 0..cases() {
        let p = 1 + rng.below(if case % 10 == 0 { 8 } else { 4 });
        let count = p + 1 + rng.below(6);
        let points: Vec<P> = random_points(&mut rng, count);
        let u = knots(&mut rng, count, p);
        let spline = match Spline::from_bspline(&points, p, Some(&u), false) {
            Ok(spline) => spline,
            // An inner knot with a multiplicity above p can occur by chance.
            Err(Error::Item { .. }) => continue,
            Err(error) => panic!("{error}"),
        };
        let mut joints = u[p..=count].to_vec();
        joints.dedup();
        assert_eq!(spline.degrees(), vec![p; joints.len() - 1]);
        for (k, pair) in joints.windows(2).enumerate() {
            for s in [0.0, 0.3, 0.5, 0.9, 1.0] {
                let x = if s == 1.0 {
                    pair[1]
                } else {
                    pair[0] + s * (pair[1] - pair[0])
                };
                let reference = slow(&points, &u, p, x, u[count]);
                let off = apart(spline.eval(real(k) + s), reference);
                let close = off < 1e-12 * real(p * p);
                assert!(close, "degree {p}, {u:?}, span {k} at {s}: {off:e}");
            }
        }
    }
}

#[test]
fn as_the_recursion_of_cox_and_de_boor() {
    matches::<DVec2>(111);
    matches::<DVec3>(112);
}

/// Closed B-splines are open ones whose points and knots are periodic.
#[test]
fn closed_ones_go_around() {
    let mut rng = Rng(113);
    for case in 0..cases() {
        let p = 1 + rng.below(5);
        let count = 1 + rng.below(9);
        let points: Vec<DVec2> = random_points(&mut rng, count);
        let uniform = case % 3 == 0;
        // Integers, so that all sums are exact.
        let mut u = vec![(rng.signed() * 1024.0).round()];
        while u.len() <= count {
            let repeated = !uniform && rng.chance(0.2);
            let step = if uniform { 1.0 } else { rng.unit() + 0.1 };
            let step = if repeated {
                0.0
            } else {
                (step * 1024.0).round()
            };
            u.push(u[u.len() - 1] + step);
        }
        let chosen = (!uniform).then_some(&u[..]);
        let Ok(closed) = Spline::from_bspline(&points, p, chosen, true) else {
            assert!(!uniform);
            continue;
        };
        // Enough periods before and after.
        let period = u[count] - u[0];
        let at = |i: usize| u[i % count] + (real(i / count) - real(p)) * period;
        let long: Vec<f64> = (0..2 * p + count + 1)
            .map(|i| at(i + p * count - p))
            .collect();
        let around: Vec<DVec2> = (0..count + p).map(|i| points[i % count]).collect();
        let open = open(&around, p, &long);
        assert_eq!(open.segment_count(), closed.segment_count());
        for t in (0..=10 * closed.segment_count()).map(|k| real(k) / 10.0) {
            near_at(closed.eval(t), open.eval(t), 1e-11, (p, &u));
        }
        if uniform && p > 1 && count > 2 {
            for joint in 0..closed.segment_count() {
                let c = continuity(&closed, joint, Some(1e-11));
                assert!(c.c1 && (p < 3 || c.c2), "{p}: {c:?}");
            }
        }
    }
}

#[test]
fn the_uniform_cubic() {
    let d = xy("0 0, 6 0, 6 12, 0 12, -6 6");
    let spline = Spline::from_bspline(&d, 3, None, false).expect("five points");
    assert_eq!(spline.segment_count(), 2);
    // (1, 4, 1)/6 at joints, inner control points at thirds.
    for k in 0..3 {
        let joint = (d[k] + d[k + 1] * 4.0 + d[k + 2]) / 6.0;
        near(spline.eval(real(k)), joint, 1e-14);
    }
    let thirds = [1.0, 2.0].map(|k| d[1].lerp(d[2], k / 3.0));
    all_near(&spline.control_points()[1..3], &thirds, 1e-14);
    // The same segment as from the B-spline basis.
    let basis = Curve::from_basis(Basis::BSpline, [d[0], d[1], d[2], d[3]]).expect("finite");
    all_near(&spline.control_points()[..4], basis.control_points(), 1e-14);
    let ring = Spline::from_bspline(&d, 3, None, true).expect("five points");
    assert_eq!((ring.segment_count(), ring.is_closed()), (5, true));
    all_near(
        &ring.control_points()[..4],
        &spline.control_points()[..4],
        1e-14,
    );
}

#[test]
fn clamped_ends_are_reached_exactly() {
    let mut rng = Rng(114);
    for p in [1, 2, 3, 7, 64] {
        let points: Vec<DVec3> = random_points(&mut rng, p + 3);
        let u = [vec![0.0; p + 1], vec![0.25, 0.75], vec![1.0; p + 1]].concat();
        let spline = open(&points, p, &u);
        assert_eq!(
            (spline.eval(0.0), spline.eval(3.0)),
            (points[0], points[p + 2])
        );
        assert_eq!(spline.segment_count(), 3);
        // Without inner knots it is the Bézier curve itself.
        let bezier = [vec![-2.0; p + 1], vec![5.0; p + 1]].concat();
        assert_eq!(
            open(&points[..=p], p, &bezier).control_points(),
            &points[..=p]
        );
    }
}

#[test]
fn there_and_back_is_the_same_spline() {
    let mut rng = Rng(115);
    for case in 0..cases() {
        let p = if case % 50 == 0 { 64 } else { 1 + rng.below(6) };
        let (closed, count) = (rng.chance(0.5), 1 + rng.below(5));
        let scale = rng.pick(&[1.0, 1e150, 1e-300]);
        let points: Vec<DVec2> = random_points(&mut rng, p * count + usize::from(!closed));
        let points: Vec<DVec2> = points.iter().map(|&point| point * scale).collect();
        let spline = Spline::new(&points, p, closed).expect("a spline");
        let b = spline.to_bspline().expect("one degree");
        let back = Spline::from_bspline(&b.points, b.degree, Some(&b.knots), b.closed);
        assert_eq!(back, Ok(spline));
    }
}

/// Only ratios of knots matter; affine maps of the points map the curve.
#[test]
fn knots_and_points_of_any_size() {
    let points: Vec<DVec2> = random_points(&mut Rng(116), 8);
    let u = [0.0, 0.0, 0.0, 0.0, 0.2, 0.3, 0.3, 0.9, 1.0, 1.0, 1.0, 1.0];
    let plain = open(&points, 3, &u);
    for scale in [1e-300, 1e-9, 1e9, 1e300, -f64::MAX] {
        let map = |u: f64| {
            if scale < 0.0 {
                (u - 0.5) * 2.0 * f64::MAX
            } else {
                u * scale
            }
        };
        let u = u.map(map);
        assert!(open(&points, 3, &u).approx_eq(&plain, 1e-13), "{scale:e}");
        let around = [u[3], u[4], u[5], u[8]];
        let ring = Spline::from_bspline(&points[..3], 5, Some(&around), true).expect("knots");
        assert!(ring.control_points().iter().all(|p| p.length() < 1.5));
    }
    for scale in [1e-300, 1e150, casteljau::MAX_COORDINATE] {
        let scaled: Vec<DVec2> = points.iter().map(|&p| p * scale).collect();
        let within = |p: &DVec2| p.is_finite() && p.max_abs() <= largest(&scaled);
        assert!(open(&scaled, 3, &u).control_points().iter().all(within));
    }
}

#[test]
fn long_ones_in_linear_time() {
    let point = |i: u32| DVec2::new(f64::from(i), f64::from(i % 5));
    let points: Vec<DVec2> = (0..1_000_000).map(point).collect();
    let spline = Spline::from_bspline(&points, 3, None, true).expect("a ring");
    assert_eq!(spline.segment_count(), 1_000_000);
    // Input that would take minutes is rejected at once.
    refused(
        Spline::from_bspline(&points, 64, None, true),
        "TooMany segments 65536",
    );
}

/// By the Cox–de Boor recursion; outside its range the curve ends at its ends.
#[test]
fn evaluation_keeps_the_knots() {
    let mut rng = Rng(117);
    for case in 0..cases() / 4 {
        let p = 1 + rng.below(5);
        let count = p + 1 + rng.below(6);
        let u = knots(&mut rng, count, p);
        let points: Vec<DVec2> = random_points(&mut rng, count);
        let Ok(b) = BSpline::new(points.clone(), p, Some(u.clone()), false) else {
            continue;
        };
        let (from, to) = (u[p], u[count]);
        for _ in 0..5 {
            let x = from + (to - from) * rng.unit();
            let expected = slow(&points, &u, p, x, to);
            near_at(b.eval(x).expect("knots"), expected, 1e-11, case);
        }
        assert_eq!(b.eval(from - 1.0), b.eval(from));
        assert_eq!(b.eval(to + 1.0), b.eval(to));
        assert_eq!(b.knots, u);
        assert_eq!(Ok(&b), BSpline::new(points, p, Some(u), false).as_ref());
        let spline = b.to_spline().expect("knots");
        let ends = [
            spline.control_points()[0],
            spline.eval(real(spline.segment_count())),
        ];
        near_at(b.eval(from).expect("knots"), ends[0], 1e-12, case);
        near_at(b.eval(to).expect("knots"), ends[1], 1e-12, case);
    }
    let around = BSpline::new(xy("0 0, 2 0, 1 2"), 2, Some(vec![1.0, 2.0, 4.0, 5.0]), true);
    let around = around.expect("a closed one");
    let spline = Spline::try_from(&around).expect("a closed one");
    for (u, t) in [
        (1.0, 0.0),
        (1.5, 0.5),
        (2.0, 1.0),
        (3.0, 1.5),
        (4.5, 2.5),
        (5.0, 3.0),
    ] {
        near_at(around.eval(u).expect("knots"), spline.eval(t), 1e-15, u);
    }
    refused(around.eval(f64::NAN), "NotFinite u 0");
    let mut broken = around;
    broken.knots.swap(0, 1);
    refused(broken.eval(1.5), "Item knots 1 1");
}
