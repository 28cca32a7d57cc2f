//! B-splines, compared with the Cox–de Boor recursion: any degree, clamped and unclamped, repeated knots, closed; and
//! conversion back.

use crate::support::{Rng, Space, apart, largest, real};
use casteljau::glam::{DVec2, DVec3};
use casteljau::{Error, Point, Spline};
use wasm_bindgen_test::wasm_bindgen_test;

fn cases() -> usize {
    crate::support::cases(4_000, 200_000)
}

/// The basis functions by their definition; 0/0 is 0, and the last span includes its end.
fn basis(u: &[f64], i: usize, p: usize, x: f64, end: f64) -> f64 {
    if p == 0 {
        let last = x == end && u[i] < x && u[i + 1] == x;
        return if (u[i] <= x && x < u[i + 1] && x != end) || last {
            1.0
        } else {
            0.0
        };
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

/// The knot spans of the segments.
fn spans(u: &[f64], first: usize, last: usize) -> Vec<(f64, f64)> {
    let pairs = u[first..=last].windows(2).map(|w| (w[0], w[1]));
    pairs.filter(|(a, b)| a < b).collect()
}

/// Ascending knots, often repeated, often clamped, equally or unequally spaced.
fn knots(rng: &mut Rng, count: usize, p: usize) -> Vec<f64> {
    let (clamped, even) = (rng.chance(0.5), rng.chance(0.3));
    let needed = count + p + 1;
    let mut u: Vec<f64> = Vec::new();
    let mut x = rng.signed();
    while u.len() < needed {
        let inside = !clamped || (u.len() > p && u.len() + p < needed);
        let times = if inside && rng.chance(0.3) {
            1 + rng.below(p)
        } else {
            1
        };
        let times = times.min(needed - u.len());
        u.extend(std::iter::repeat_n(x, times));
        x += if even {
            1.0
        } else {
            0.05 + rng.unit() * rng.magnitude(-2.0, 1.0)
        };
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
        let points: Vec<P> = (0..count).map(|_| P::of(rng.point(P::DIMENSION))).collect();
        let u = knots(&mut rng, count, p);
        let spline = match Spline::from_bspline(&points, p, Some(&u), false) {
            Ok(spline) => spline,
            // An inner knot with a multiplicity above p can occur by chance.
            Err(Error::Item { .. }) => continue,
            Err(error) => panic!("{error}"),
        };
        let spans = spans(&u, p, count);
        assert_eq!(spline.degrees(), vec![p; spans.len()]);
        for (k, &(a, b)) in spans.iter().enumerate() {
            for s in [0.0, 0.3, 0.5, 0.9, 1.0] {
                let x = if s == 1.0 { b } else { a + s * (b - a) };
                let reference = slow(&points, &u, p, x, u[count]);
                let off = apart(spline.eval(real(k) + s), reference);
                assert!(
                    off < 1e-12 * real(p * p),
                    "degree {p}, {u:?}, span {k} at {s}: {off:e}"
                );
            }
        }
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn as_the_recursion_of_cox_and_de_boor() {
    matches::<DVec2>(111);
    matches::<DVec3>(112);
}

/// Closed B-splines are open ones whose points and knots are periodic.
#[wasm_bindgen_test(unsupported = test)]
fn closed_ones_go_around() {
    let mut rng = Rng(113);
    for case in 0..cases() {
        let p = 1 + rng.below(5);
        let count = 1 + rng.below(9);
        let points: Vec<DVec2> = (0..count).map(|_| DVec2::of(rng.point(2))).collect();
        let uniform = case % 3 == 0;
        let mut u = vec![rng.signed()];
        while u.len() <= count {
            let step = if uniform {
                1.0
            } else if rng.chance(0.2) {
                0.0
            } else {
                rng.unit() + 0.1
            };
            u.push(u[u.len() - 1] + step);
        }
        // Integers, so that all sums are exact.
        u = u.iter().map(|x| ((x - u[0]) * 1024.0).round()).collect();
        let chosen = (!uniform).then_some(&u[..]);
        let Ok(closed) = Spline::from_bspline(&points, p, chosen, true) else {
            assert!(!uniform);
            continue;
        };
        // Enough periods before and after.
        let period = u[count];
        let long: Vec<f64> = (0..2 * p + count + 1)
            .map(|i| {
                let shifted = i + p * count - p;
                u[shifted % count] + (real(shifted / count) - real(p)) * period
            })
            .collect();
        let around: Vec<DVec2> = (0..count + p).map(|i| points[i % count]).collect();
        let open = Spline::from_bspline(&around, p, Some(&long), false).expect("an open one");
        assert_eq!(open.segment_count(), closed.segment_count());
        for k in 0..=10 * closed.segment_count() {
            let t = real(k) / 10.0;
            assert!(closed.eval(t).distance(open.eval(t)) < 1e-11, "{p} {u:?}");
        }
        if uniform && p > 1 && count > 2 {
            for joint in 0..closed.segment_count() {
                let c = closed.continuity(joint, Some(1e-11)).expect("a joint");
                assert!(c.c1 && (p < 3 || c.c2), "{p}: {c:?}");
            }
        }
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn the_uniform_cubic() {
    let d: Vec<DVec2> = [
        (0.0, 0.0),
        (6.0, 0.0),
        (6.0, 12.0),
        (0.0, 12.0),
        (-6.0, 6.0),
    ]
    .map(DVec2::from)
    .to_vec();
    let spline = Spline::from_bspline(&d, 3, None, false).expect("five points");
    assert_eq!(spline.segment_count(), 2);
    // (1, 4, 1)/6 at joints, inner control points at thirds.
    for k in 0..3 {
        let joint = (d[k] + d[k + 1] * 4.0 + d[k + 2]) / 6.0;
        assert!(spline.eval(real(k)).distance(joint) < 1e-14);
    }
    let thirds = [d[1].lerp(d[2], 1.0 / 3.0), d[1].lerp(d[2], 2.0 / 3.0)];
    assert!((0..2).all(|i| spline.control_points()[1 + i].distance(thirds[i]) < 1e-14));
    // The same segment as from the B-spline basis.
    let geometry = [d[0], d[1], d[2], d[3]];
    let basis =
        casteljau::Curve::from_basis(casteljau::curve::Basis::BSpline, geometry).expect("four");
    assert!(
        spline
            .segment(0)
            .expect("a segment")
            .approx_eq(&basis, 1e-14)
    );
    let ring = Spline::from_bspline(&d, 3, None, true).expect("five points");
    assert_eq!((ring.segment_count(), ring.is_closed()), (5, true));
    assert!(ring.segment(0).expect("a segment").approx_eq(&basis, 1e-14));
}

#[wasm_bindgen_test(unsupported = test)]
fn clamped_ends_are_reached_exactly() {
    let mut rng = Rng(114);
    for p in [1, 2, 3, 7, 64] {
        let points: Vec<DVec3> = (0..p + 3).map(|_| rng.point(3)).collect();
        let inner = [0.25, 0.75];
        let u = [vec![0.0; p + 1], inner.to_vec(), vec![1.0; p + 1]].concat();
        let spline = Spline::from_bspline(&points, p, Some(&u), false).expect("clamped");
        assert_eq!(spline.eval(0.0), points[0]);
        assert_eq!(spline.eval(3.0), points[p + 2]);
        assert_eq!(spline.segment_count(), 3);
        // Without inner knots it is the Bézier curve itself.
        let bezier = [vec![-2.0; p + 1], vec![5.0; p + 1]].concat();
        let same = Spline::from_bspline(&points[..=p], p, Some(&bezier), false).expect("Bézier");
        assert_eq!(same.control_points(), &points[..=p]);
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn there_and_back_is_the_same_spline() {
    let mut rng = Rng(115);
    for case in 0..cases() {
        let p = if case % 50 == 0 { 64 } else { 1 + rng.below(6) };
        let closed = rng.chance(0.5);
        let degrees = vec![p; 1 + rng.below(5)];
        let scale = rng.pick(&[1.0, 1e150, 1e-300]);
        let count = p * degrees.len() + usize::from(!closed);
        let points: Vec<DVec2> = (0..count)
            .map(|_| DVec2::of(rng.point(2)) * scale)
            .collect();
        let spline = Spline::new(&points, p, closed).expect("a spline");
        let b = spline.to_bspline().expect("one degree");
        let back = Spline::from_bspline(&b.points, b.degree, Some(&b.knots), b.closed)
            .expect("a B-spline");
        assert_eq!(back, spline);
    }
    let mixed = Spline::with_degrees(vec![DVec2::ZERO; 6], &[2, 3], false).expect("a spline");
    let refused = mixed.to_bspline();
    assert!(
        matches!(
            refused,
            Err(Error::Item {
                what: "degrees",
                index: 1,
                got: 3.0,
                ..
            })
        ),
        "{refused:?}"
    );
}

/// Only ratios of knots matter; affine maps of the points map the curve.
#[wasm_bindgen_test(unsupported = test)]
fn knots_and_points_of_any_size() {
    let mut rng = Rng(116);
    let points: Vec<DVec2> = (0..8).map(|_| DVec2::of(rng.point(2))).collect();
    let u = [0.0, 0.0, 0.0, 0.0, 0.2, 0.3, 0.3, 0.9, 1.0, 1.0, 1.0, 1.0];
    let plain = Spline::from_bspline(&points, 3, Some(&u), false).expect("knots");
    for scale in [1e-300, 1e-9, 1e9, 1e300, -f64::MAX] {
        let shifted: Vec<f64> = if scale < 0.0 {
            u.iter().map(|u| (u - 0.5) * 2.0 * f64::MAX).collect()
        } else {
            u.iter().map(|u| u * scale).collect()
        };
        let other = Spline::from_bspline(&points, 3, Some(&shifted), false).expect("knots");
        assert!(other.approx_eq(&plain, 1e-13), "{scale:e}");
        let around = [shifted[3], shifted[4], shifted[5], shifted[8]];
        let ring = Spline::from_bspline(&points[..3], 5, Some(&around), true).expect("knots");
        assert!(ring.control_points().iter().all(|p| p.length() < 1.5));
    }
    for scale in [1e-300, 1e150, casteljau::MAX_COORDINATE] {
        let scaled: Vec<DVec2> = points.iter().map(|&p| p * scale).collect();
        let other = Spline::from_bspline(&scaled, 3, Some(&u), false).expect("knots");
        let largest = largest(&scaled);
        assert!(
            other
                .control_points()
                .iter()
                .all(|p| p.is_finite() && p.max_abs() <= largest)
        );
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn refusals_of_knots() {
    let p = [DVec2::ZERO; 5];
    let item = |u: &[f64], degree: usize, closed: bool| match Spline::from_bspline(
        &p,
        degree,
        Some(u),
        closed,
    ) {
        Err(Error::Item {
            what: "knots",
            index,
            got,
            ..
        }) => (index, got),
        other => panic!("{other:?}"),
    };
    assert_eq!(
        item(&[0.0, 1.0, 2.0, 1.5, 3.0, 4.0, 5.0, 6.0], 2, false),
        (3, 1.5)
    );
    // A double inner knot splits a polyline; at an end two are usual, three are too many.
    assert_eq!(
        item(&[0.0, 0.0, 1.0, 1.0, 2.0, 3.0, 3.0], 1, false),
        (3, 1.0)
    );
    assert_eq!(
        item(&[0.0, 0.0, 0.0, 1.0, 2.0, 3.0, 3.0], 1, false),
        (2, 0.0)
    );
    assert_eq!(item(&[1.0; 8], 2, false).1, 1.0);
    assert_eq!(item(&[0.0, 1.0, 1.0, 1.0, 2.0, 3.0], 2, true), (3, 1.0));
    assert_eq!(item(&[0.0, 0.0, 0.0, 1.0, 2.0, 3.0], 2, true), (2, 0.0));
    assert_eq!(item(&[4.0; 6], 2, true), (5, 4.0));
    for (u, closed) in [(vec![0.0; 7], false), (vec![], false), (vec![0.0; 8], true)] {
        let got = u.len();
        let refused = Spline::from_bspline(&p, 2, Some(&u), closed);
        assert!(matches!(refused, Err(Error::Count { what: "knots", got: n, .. }) if n == got));
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn refusals_of_degrees_and_points() {
    let p = [DVec2::ZERO; 5];
    for degree in [0, 65] {
        let refused = Spline::from_bspline(&p, degree, None, false);
        assert!(matches!(refused, Err(Error::Range { what: "degree", .. })));
    }
    assert!(matches!(
        Spline::from_bspline(&p, 5, None, false),
        Err(Error::Count {
            what: "points",
            got: 5,
            ..
        })
    ));
    assert!(matches!(
        Spline::<DVec2>::from_bspline(&[], 1, None, true),
        Err(Error::Count { .. })
    ));
    let bad = [0.0, 1.0, f64::NAN, 3.0, 4.0, 5.0, 6.0, 7.0];
    assert!(matches!(
        Spline::from_bspline(&p, 2, Some(&bad), false),
        Err(Error::NotFinite {
            what: "knots",
            index: 2,
            ..
        })
    ));
    let points = [DVec2::ZERO, DVec2::NAN, DVec2::ZERO];
    assert!(matches!(
        Spline::from_bspline(&points, 1, None, false),
        Err(Error::NotFinite { index: 1, .. })
    ));
}

#[wasm_bindgen_test(unsupported = test)]
fn long_ones_in_linear_time() {
    let points: Vec<DVec2> = (0..1_000_000_u32)
        .map(|i| DVec2::new(f64::from(i), f64::from(i % 5)))
        .collect();
    let spline = Spline::from_bspline(&points, 3, None, true).expect("a ring");
    assert_eq!(spline.segment_count(), 1_000_000);
    // Input that would take minutes is rejected at once.
    let refused = Spline::from_bspline(&points, 64, None, true);
    assert!(matches!(
        refused,
        Err(Error::TooMany {
            what: "segments",
            limit: 65_536,
            ..
        })
    ));
}
