//! Nearest point on a cubic. lyon_geom has no such function.

use crate::inputs::{Cubics, parameters};
use casteljau::glam::DVec2;
use criterion::Criterion;
use kurbo::{ParamCurveNearest, Point};
use std::hint::black_box;

/// Control points and queries lie in a square of this size.
const SIZE: f64 = 200.0;

/// The accuracy requested from kurbo; our result is exact up to rounding.
const ACCURACY: f64 = 1e-9;

pub(crate) fn bench(criterion: &mut Criterion) {
    let (cubics, ts) = (Cubics::new(), parameters());
    // Random points in the square: the parameters in two different orders.
    let queries: Vec<DVec2> = (ts.iter().zip(ts.iter().rev()))
        .map(|(&x, &y)| DVec2::new(x, y) * SIZE)
        .collect();
    let theirs = |k: usize| cubics.kurbo[k].nearest(point(queries[k]), ACCURACY);
    let ours = |k: usize| cubics.ours[k].nearest(queries[k]).expect("finite");
    for k in 0..queries.len() {
        let (theirs, ours) = (theirs(k).distance_sq.sqrt(), ours(k).distance);
        assert!((theirs - ours).abs() < 1e-6, "{theirs}, ours {ours}");
    }
    let mut group = criterion.benchmark_group("nearest");
    group.bench_function("kurbo", |b| {
        b.iter(|| {
            (0..queries.len()).for_each(|k| {
                black_box(theirs(k));
            })
        });
    });
    group.bench_function("casteljau", |b| {
        b.iter(|| {
            (0..queries.len()).for_each(|k| {
                black_box(ours(k));
            })
        });
    });
    group.finish();
}

fn point(p: DVec2) -> Point {
    Point::new(p.x, p.y)
}
