//! Evaluation and splitting of cubics.

use crate::inputs::{COUNT, Cubics, parameters};
use casteljau::curve::Cubic;
use casteljau::glam::DVec2;
use criterion::Criterion;
use kurbo::{CubicBez, ParamCurve};
use lyon_geom::CubicBezierSegment;
use std::hint::black_box;

/// Tolerance of the comparison; coordinates are up to 200.
const TOLERANCE: f64 = 1e-11;

pub(crate) fn bench(criterion: &mut Criterion) {
    let (cubics, ts) = (Cubics::new(), parameters());
    let cubic = |curve| Cubic::try_from(curve).expect("a cubic");
    let ours: Vec<Cubic<DVec2>> = cubics.ours.iter().map(cubic).collect();
    eval(criterion, &cubics, &ours, &ts);
    split(criterion, &cubics, &ours, &ts);
    halve(criterion, &cubics, &ours);
}

fn eval(criterion: &mut Criterion, cubics: &Cubics, ours: &[Cubic<DVec2>], ts: &[f64]) {
    for (k, &t) in ts.iter().enumerate() {
        let point = ours[k].eval(t);
        assert_same(of_kurbo(cubics.kurbo[k].eval(t)), point);
        assert_same(of_lyon(cubics.lyon[k].sample(t)), point);
    }
    let mut group = criterion.benchmark_group("eval");
    group.bench_function("kurbo", |b| {
        b.iter(|| each(&cubics.kurbo, ts, CubicBez::eval));
    });
    group.bench_function("lyon_geom", |b| {
        b.iter(|| each(&cubics.lyon, ts, CubicBezierSegment::sample));
    });
    group.bench_function("casteljau", |b| {
        b.iter(|| each(ours, ts, Cubic::eval));
    });
    group.finish();
}

/// kurbo has no function that splits a curve at t.
fn split(criterion: &mut Criterion, cubics: &Cubics, ours: &[Cubic<DVec2>], ts: &[f64]) {
    for (k, &t) in ts.iter().enumerate() {
        let pieces = ours[k].split(t);
        let (before, after) = cubics.lyon[k].split(t);
        assert_same_pieces([lyon_points(before), lyon_points(after)], pieces);
    }
    let mut group = criterion.benchmark_group("split");
    group.bench_function("lyon_geom", |b| {
        b.iter(|| each(&cubics.lyon, ts, CubicBezierSegment::split));
    });
    group.bench_function("casteljau", |b| {
        b.iter(|| each(ours, ts, Cubic::split));
    });
    group.finish();
}

fn halve(criterion: &mut Criterion, cubics: &Cubics, ours: &[Cubic<DVec2>]) {
    for (k, cubic) in ours.iter().enumerate() {
        let pieces = cubic.halve();
        let (before, after) = cubics.kurbo[k].subdivide();
        assert_same_pieces([kurbo_points(before), kurbo_points(after)], pieces);
        let (before, after) = cubics.lyon[k].split(0.5);
        assert_same_pieces([lyon_points(before), lyon_points(after)], pieces);
    }
    let ts = [0.5; COUNT];
    let mut group = criterion.benchmark_group("halve");
    group.bench_function("kurbo", |b| {
        b.iter(|| each(&cubics.kurbo, &ts, |curve, _| curve.subdivide()));
    });
    group.bench_function("lyon_geom", |b| {
        b.iter(|| each(&cubics.lyon, &ts, |curve, _| curve.split(0.5)));
    });
    group.bench_function("casteljau", |b| {
        b.iter(|| each(ours, &ts, |curve, _| curve.halve()));
    });
    group.finish();
}

/// Calls a function with every curve and its parameter.
#[inline(always)]
fn each<C, R>(curves: &[C], ts: &[f64], act: impl Fn(&C, f64) -> R) {
    for (curve, &t) in curves.iter().zip(ts) {
        black_box(act(curve, t));
    }
}

fn assert_same(theirs: DVec2, ours: DVec2) {
    let apart = (theirs - ours).abs().max_element();
    assert!(apart <= TOLERANCE, "{theirs}, ours {ours}");
}

fn assert_same_pieces(theirs: [[DVec2; 4]; 2], (a, b): (Cubic<DVec2>, Cubic<DVec2>)) {
    let ours = [a.control_points(), b.control_points()];
    for (theirs, ours) in theirs.as_flattened().iter().zip(ours.as_flattened()) {
        assert_same(*theirs, *ours);
    }
}

fn kurbo_points(curve: CubicBez) -> [DVec2; 4] {
    [curve.p0, curve.p1, curve.p2, curve.p3].map(of_kurbo)
}

fn lyon_points(curve: CubicBezierSegment<f64>) -> [DVec2; 4] {
    [curve.from, curve.ctrl1, curve.ctrl2, curve.to].map(of_lyon)
}

fn of_kurbo(p: kurbo::Point) -> DVec2 {
    DVec2::new(p.x, p.y)
}

fn of_lyon(p: lyon_geom::Point<f64>) -> DVec2 {
    DVec2::new(p.x, p.y)
}
