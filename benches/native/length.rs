//! Arc length to 10⁻⁹, and the parameter at a given arc length.

use crate::inputs::Cubics;
use casteljau::Curve;
use casteljau::glam::DVec2;
use criterion::Criterion;
use kurbo::ParamCurveArclen;
use lyon_geom::CubicBezierSegment;
use std::hint::black_box;

/// The tolerance in the unit of the points, which lie in a square of size 200.
const ACCURACY: f64 = 1e-9;

/// The tolerance for lyon_geom, which flattens the curve; 10⁻⁹ would take minutes.
const COARSE: f64 = 1e-3;

pub(crate) fn bench(criterion: &mut Criterion) {
    let cubics = Cubics::new();
    length(criterion, &cubics);
    coarse_length(criterion, &cubics);
}

fn ours(curve: &Curve<DVec2>, tolerance: f64) -> f64 {
    curve.length_within(tolerance).expect("a fit tolerance")
}

fn length(criterion: &mut Criterion, cubics: &Cubics) {
    for (k, curve) in cubics.ours.iter().enumerate() {
        assert_near(
            cubics.kurbo[k].arclen(ACCURACY),
            ours(curve, ACCURACY),
            3.0 * ACCURACY,
        );
    }
    let mut group = criterion.benchmark_group("length");
    group.bench_function("kurbo", |b| {
        b.iter(|| each(&cubics.kurbo, |curve| curve.arclen(ACCURACY)))
    });
    group.bench_function("casteljau", |b| {
        b.iter(|| each(&cubics.ours, |curve| ours(curve, ACCURACY)))
    });
    group.finish();
}

fn coarse_length(criterion: &mut Criterion, cubics: &Cubics) {
    for (k, curve) in cubics.ours.iter().enumerate() {
        assert_near(
            cubics.lyon[k].approximate_length(COARSE),
            ours(curve, COARSE),
            1.0,
        );
    }
    let mut group = criterion.benchmark_group("length-0.001");
    group.bench_function("kurbo", |b| {
        b.iter(|| each(&cubics.kurbo, |curve| curve.arclen(COARSE)))
    });
    group.bench_function("lyon_geom", |b| {
        b.iter(|| {
            each(&cubics.lyon, |curve: &CubicBezierSegment<f64>| {
                curve.approximate_length(COARSE)
            })
        })
    });
    group.bench_function("casteljau", |b| {
        b.iter(|| each(&cubics.ours, |curve| ours(curve, COARSE)))
    });
    group.finish();
}

/// Calls a function with every curve.
#[inline(always)]
fn each<C, R>(curves: &[C], act: impl Fn(&C) -> R) {
    for curve in curves {
        black_box(act(curve));
    }
}

fn assert_near(theirs: f64, ours: f64, max: f64) {
    assert!((theirs - ours).abs() <= max, "{theirs}, ours {ours}");
}
