//! Intersections of two cubics, compared with lyon_geom; kurbo has no curve-curve intersection.

use crate::inputs::Cubics;
use casteljau::Curve;
use casteljau::glam::DVec2;
use criterion::Criterion;
use lyon_geom::CubicBezierSegment;
use std::hint::black_box;

/// The number of pairs per row.
const PAIRS: usize = 500;

/// The maximum difference of the parameters of both libraries; lyon_geom computes them to 1e-9 or less.
const TOLERANCE: f64 = 1e-5;

/// A pair with nine intersections, from the README of FloBezier.
const NINE: [[[f64; 2]; 4]; 2] = [
    [[6.4, 4.8], [15.0, 5.0], [1.0, 4.0], [10.0, 4.0]],
    [[9.4, 0.4], [9.3, 10.3], [8.1, 0.1], [7.53125, 5.5]],
];

type Lyon = CubicBezierSegment<f64>;

pub(crate) fn bench(criterion: &mut Criterion) {
    let all = Cubics::new();
    let random: Vec<_> = (0..PAIRS)
        .map(|k| {
            let (i, j) = (2 * k, 2 * k + 1);
            (
                [all.ours[i].clone(), all.ours[j].clone()],
                [all.lyon[i], all.lyon[j]],
            )
        })
        .collect();
    row(criterion, "intersect", &random);
    let ours = NINE.map(|points| Curve::new(&points.map(DVec2::from)).expect("finite"));
    let lyon = NINE.map(|[p0, p1, p2, p3]| Lyon {
        from: p0.into(),
        ctrl1: p1.into(),
        ctrl2: p2.into(),
        to: p3.into(),
    });
    row(criterion, "intersect-9", &[(ours, lyon)]);
}

fn row(criterion: &mut Criterion, name: &str, pairs: &[([Curve<DVec2>; 2], [Lyon; 2])]) {
    pairs
        .iter()
        .for_each(|(ours, lyon)| assert_same(ours, lyon));
    let mut group = criterion.benchmark_group(name);
    group.bench_function("lyon_geom", |b| {
        b.iter(|| {
            for (_, [p, q]) in pairs {
                black_box(p.cubic_intersections_t(q));
            }
        });
    });
    group.bench_function("casteljau", |b| {
        b.iter(|| {
            for ([p, q], _) in pairs {
                black_box(p.intersections(q));
            }
        });
    });
    group.finish();
}

fn assert_same([p, q]: &[Curve<DVec2>; 2], [r, s]: &[Lyon; 2]) {
    let mut theirs: Vec<(f64, f64)> = r.cubic_intersections_t(s).to_vec();
    theirs.sort_by(|a, b| a.0.total_cmp(&b.0));
    let ours = p.intersections(q);
    assert_eq!(
        theirs.len(),
        ours.len(),
        "{p:?} {q:?}: {theirs:?}, ours {ours:?}"
    );
    for (their, our) in theirs.iter().zip(ours) {
        let apart = (their.0 - our.t).abs().max((their.1 - our.u).abs());
        assert!(apart <= TOLERANCE, "{their:?}, ours {our:?}");
    }
}
