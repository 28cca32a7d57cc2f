//! Pairs with known intersections.

use crate::intersect::generate::new;
use crate::support::{Rng, plane, real};
use casteljau::Curve;
use casteljau::curve::IntersectionKind;
use casteljau::glam::DVec2;

fn line(from: (f64, f64), to: (f64, f64)) -> Curve<DVec2> {
    plane(&[from, to])
}

fn kinds(a: &Curve<DVec2>, b: &Curve<DVec2>) -> Vec<(f64, f64, IntersectionKind)> {
    a.intersections(b)
        .iter()
        .map(|p| (p.t, p.u, p.kind))
        .collect()
}

#[test]
fn lines() {
    let level = line((0.0, 0.0), (4.0, 0.0));
    let upright = line((1.0, -1.0), (1.0, 1.0));
    assert_eq!(
        kinds(&level, &upright),
        [(0.25, 0.5, IntersectionKind::Cross)]
    );
    assert_eq!(
        kinds(&upright, &level),
        [(0.5, 0.25, IntersectionKind::Cross)]
    );
    let aside = line((0.0, 1e-9), (4.0, 1e-9));
    assert_eq!(kinds(&level, &aside), []);
    // End to end on one line, with an end on the other line, and without contact.
    assert_eq!(
        kinds(&level, &line((4.0, 0.0), (6.0, 0.0))),
        [(1.0, 0.0, IntersectionKind::Tangent)]
    );
    assert_eq!(
        kinds(&level, &line((2.0, 0.0), (2.0, 5.0))),
        [(0.5, 0.0, IntersectionKind::Cross)]
    );
    assert_eq!(kinds(&level, &line((5.0, 0.0), (6.0, 0.0))), []);
    let shared = IntersectionKind::Overlap {
        t_end: 1.0,
        u_end: 0.5,
    };
    assert_eq!(
        kinds(&level, &line((2.0, 0.0), (6.0, 0.0))),
        [(0.5, 0.0, shared)]
    );
    let against = IntersectionKind::Overlap {
        t_end: 1.0,
        u_end: 0.5,
    };
    assert_eq!(
        kinds(&level, &line((6.0, 0.0), (2.0, 0.0))),
        [(0.5, 1.0, against)]
    );
}

#[test]
fn graphs_cross_at_the_roots_of_their_difference() {
    // y = 0 and products of (x − k/16): up to five crossings, exactly at the roots.
    let mut rng = Rng(5);
    for _ in 0..2000 {
        let degree = 1 + rng.below(5);
        let mut roots: Vec<f64> = (0..degree)
            .map(|_| real(1 + rng.below(15)) / 16.0)
            .collect();
        roots.sort_by(f64::total_cmp);
        let rows = roots
            .iter()
            .fold(vec![16.0], |rows, r| product(&rows, [-r, 1.0 - r]));
        let n = real(rows.len() - 1);
        let points: Vec<DVec2> = rows
            .iter()
            .enumerate()
            .map(|(i, &y)| DVec2::new(real(i) / n, y))
            .collect();
        let found = new(&points).intersections(&line((0.0, 0.0), (1.0, 0.0)));
        let mut distinct = roots.clone();
        distinct.dedup();
        assert_eq!(found.len(), distinct.len(), "{roots:?}: {found:?}");
        for (location, root) in found.iter().zip(distinct) {
            let times = roots.iter().filter(|&&r| r == root).count();
            let near = [1e-12, 1e-9, 1e-4, 1e-3, 1e-2][times - 1];
            assert!((location.t - root).abs() <= near, "{roots:?}: {location:?}");
            assert_eq!(
                location.kind == IntersectionKind::Tangent,
                times > 1,
                "{roots:?}: {location:?}"
            );
        }
    }
}

/// The product of a polynomial in Bernstein form and a linear one.
fn product(rows: &[f64], factor: [f64; 2]) -> Vec<f64> {
    let n = rows.len();
    (0..=n)
        .map(|i| {
            let part = real(i) / real(n);
            let upper = if i < n {
                rows[i] * factor[0] * (1.0 - part)
            } else {
                0.0
            };
            let lower = if i > 0 {
                rows[i - 1] * factor[1] * part
            } else {
                0.0
            };
            upper + lower
        })
        .collect()
}

#[test]
fn close_crossings_are_two_and_close_misses_none() {
    for k in 4..7 {
        let d = 10_f64.powi(-k);
        let arch = plane(&[(-1.0, -1.0), (0.0, 1.0), (1.0, -1.0)]);
        let through = line((-1.0, -d * d), (1.0, -d * d));
        let found = arch.intersections(&through);
        assert_eq!(found.len(), 2, "{d}: {found:?}");
        assert!(((found[1].point.x - found[0].point.x) / (2.0 * d) - 1.0).abs() < 1e-3);
        assert!(found.iter().all(|p| p.kind == IntersectionKind::Cross));
        assert_eq!(arch.intersections(&line((-1.0, d * d), (1.0, d * d))), []);
    }
}

#[test]
fn a_curve_that_traces_another_at_its_own_pace() {
    // y = x², traversed by a cubic in t: an improper sextic.
    let x = [0.0, 0.6, 0.1, 1.0];
    let mut rows = vec![0.0; 7];
    let binomial = |n: usize, k: usize| (0..k).fold(1.0, |c, i| c * real(n - i) / real(i + 1));
    for i in 0..4 {
        for j in 0..4 {
            rows[i + j] += x[i] * x[j] * binomial(3, i) * binomial(3, j) / binomial(6, i + j);
        }
    }
    let mut wide = plane(&x.map(|x| (x, 0.0)));
    for _ in 0..3 {
        wide = wide.elevate().expect("low");
    }
    let points: Vec<DVec2> = wide
        .control_points()
        .iter()
        .zip(rows)
        .map(|(p, y)| DVec2::new(p.x, y))
        .collect();
    let parabola = plane(&[(0.0, 0.0), (0.5, 0.0), (1.0, 1.0)]);
    let found = parabola.intersections(&new(&points));
    assert!(
        !found.is_empty()
            && found
                .iter()
                .all(|p| matches!(p.kind, IntersectionKind::Overlap { .. })),
        "{found:?}"
    );
    assert_eq!(found[0].t, 0.0);
}

#[test]
fn points_and_extremes() {
    let dot = plane(&[(1.0, 0.0), (1.0, 0.0)]);
    let level = line((0.0, 0.0), (4.0, 0.0));
    assert_eq!(kinds(&dot, &level), [(0.0, 0.25, IntersectionKind::Cross)]);
    assert_eq!(kinds(&dot, &dot), [(0.0, 0.0, IntersectionKind::Cross)]);
    for scale in [1e150, 1e-300, 1e-310, 3.2e150] {
        let a = plane(&[(-scale, -scale), (scale, scale)]);
        let b = plane(&[(-scale, scale), (scale, -scale)]);
        let found = kinds(&a, &b);
        let [(t, u, IntersectionKind::Cross)] = found[..] else {
            panic!("{scale}: {found:?}");
        };
        assert!((t - 0.5).abs() + (u - 0.5).abs() < 1e-15, "{found:?}");
    }
}
