//! Pairs with known intersections.

use crate::intersect::generate::{graph, new};
use crate::intersect::{kinds, overlap};
use crate::support::{Rng, bezier, binomial, real};
use casteljau::curve::IntersectionKind::{Cross, Overlap, Tangent};
use casteljau::glam::DVec2;

#[test]
fn lines_and_points() {
    for (a, b, expected) in [
        ("0 0, 4 0", "1 -1, 1 1", Some((0.25, 0.5, Cross))),
        ("1 -1, 1 1", "0 0, 4 0", Some((0.5, 0.25, Cross))),
        ("0 0, 4 0", "0 1e-9, 4 1e-9", None),
        // End to end on one line, with an end on the other line, and without contact.
        ("0 0, 4 0", "4 0, 6 0", Some((1.0, 0.0, Tangent))),
        ("0 0, 4 0", "2 0, 2 5", Some((0.5, 0.0, Cross))),
        ("0 0, 4 0", "5 0, 6 0", None),
        ("0 0, 4 0", "2 0, 6 0", Some((0.5, 0.0, overlap(1.0, 0.5)))),
        ("0 0, 4 0", "6 0, 2 0", Some((0.5, 1.0, overlap(1.0, 0.5)))),
        ("1 0, 1 0", "0 0, 4 0", Some((0.0, 0.25, Cross))),
        ("1 0, 1 0", "1 0, 1 0", Some((0.0, 0.0, Cross))),
    ] {
        let found = kinds(&bezier(a).intersections(&bezier(b)));
        assert_eq!(found, Vec::from_iter(expected), "{a} and {b}");
    }
    for s in [1e150, 1e-300, 1e-310, 3.2e150] {
        let line = |x: f64, y: f64| new(&[DVec2::new(-x, -y), DVec2::new(x, y)]);
        let found = kinds(&line(s, s).intersections(&line(s, -s)));
        let [(t, u, Cross)] = found[..] else {
            panic!("{s}: {found:?}")
        };
        assert!((t - 0.5).abs() + (u - 0.5).abs() < 1e-15, "{found:?}");
    }
}

#[test]
fn graphs_cross_at_the_roots_of_their_difference() {
    // y = 0 and products of (x − k/16): up to five crossings, exactly at the roots.
    let mut rng = Rng(5);
    for _ in 0..2000 {
        let degree = 1 + rng.below(5);
        let mut root = || real(1 + rng.below(15)) / 16.0;
        let mut roots: Vec<f64> = (0..degree).map(|_| root()).collect();
        roots.sort_by(f64::total_cmp);
        let times = |rows: Vec<f64>, r: &f64| product(&rows, [-r, 1.0 - r]);
        let rows = roots.iter().fold(vec![16.0], times);
        let found = new(&graph(&rows)).intersections(&bezier("0 0, 1 0"));
        let mut distinct = roots.clone();
        distinct.dedup();
        assert_eq!(found.len(), distinct.len(), "{roots:?}: {found:?}");
        for (location, root) in found.iter().zip(distinct) {
            let times = roots.iter().filter(|&&r| r == root).count();
            let near = [1e-12, 1e-9, 1e-4, 1e-3, 1e-2][times - 1];
            assert!((location.t - root).abs() <= near, "{roots:?}: {location:?}");
            let touches = location.kind == Tangent;
            assert_eq!(touches, times > 1, "{roots:?}: {location:?}");
        }
    }
}

/// The product of a polynomial in Bernstein form and a linear one.
fn product(rows: &[f64], factor: [f64; 2]) -> Vec<f64> {
    let n = rows.len();
    let term = |i: usize| {
        let part = real(i) / real(n);
        let upper = rows
            .get(i)
            .map_or(0.0, |row| row * factor[0] * (1.0 - part));
        let lower = if i > 0 {
            rows[i - 1] * factor[1] * part
        } else {
            0.0
        };
        upper + lower
    };
    (0..=n).map(term).collect()
}

#[test]
fn close_crossings_are_two_and_close_misses_none() {
    let arch = bezier("-1 -1, 0 1, 1 -1");
    for d in [1e-4, 1e-5, 1e-6] {
        let level = |y: f64| new(&[DVec2::new(-1.0, y), DVec2::new(1.0, y)]);
        let found = arch.intersections(&level(-d * d));
        assert_eq!(found.len(), 2, "{d}: {found:?}");
        assert!(((found[1].point.x - found[0].point.x) / (2.0 * d) - 1.0).abs() < 1e-3);
        assert!(found.iter().all(|p| p.kind == Cross));
        assert_eq!(arch.intersections(&level(d * d)), []);
    }
}

#[test]
fn a_curve_that_traces_another_at_its_own_pace() {
    // y = x², traversed by a cubic in t: an improper sextic.
    let x = [0.0, 0.6, 0.1, 1.0];
    let mut rows = vec![0.0; 7];
    for (i, j) in (0..16).map(|k| (k / 4, k % 4)) {
        rows[i + j] += x[i] * x[j] * binomial(3, i) * binomial(3, j) / binomial(6, i + j);
    }
    let mut wide = new(&x.map(|x| DVec2::new(x, 0.0)));
    while wide.degree() < 6 {
        wide = wide.elevate().expect("low");
    }
    let points = wide.control_points().iter().zip(rows);
    let points: Vec<DVec2> = points.map(|(p, y)| DVec2::new(p.x, y)).collect();
    let found = bezier("0 0, 0.5 0, 1 1").intersections(&new(&points));
    let overlaps = found.iter().all(|p| matches!(p.kind, Overlap { .. }));
    assert!(!found.is_empty() && overlaps, "{found:?}");
    assert_eq!(found[0].t, 0.0);
}
