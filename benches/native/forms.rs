//! Queries with closed forms for cubics (area, inflections, bounds, polylines of lines), the parameter at a length, and
//! the text and the dashes of a path.

use crate::inputs::{Cubics, parameters};
use casteljau::glam::DVec2;
use casteljau::{Curve, Path};
use criterion::Criterion;
use kurbo::{
    BezPath, CubicBez, ParamCurveArclen, ParamCurveArea, ParamCurveExtrema, PathEl, Shape,
};
use std::hint::black_box;

/// The accuracy of the parameter at a length, in the unit of the points, which lie in a square of size 200.
const ACCURACY: f64 = 1e-9;

/// The largest relative difference of the results.
const TOLERANCE: f64 = 1e-11;

pub(crate) fn bench(criterion: &mut Criterion) {
    let cubics = Cubics::new();
    area(criterion, &cubics);
    inflections(criterion, &cubics);
    bounds(criterion, &cubics);
    time_at_length(criterion, &cubics);
    path(criterion, &cubics);
}

/// Measures a function of a curve of ours and the same of kurbo.
fn both<R, S>(
    criterion: &mut Criterion,
    name: &str,
    cubics: &Cubics,
    theirs: impl Fn(&CubicBez, usize) -> R,
    ours: impl Fn(&Curve<DVec2>, usize) -> S,
) {
    let mut group = criterion.benchmark_group(name);
    group.bench_function("kurbo", |b| {
        b.iter(|| each(&cubics.kurbo, &theirs));
    });
    group.bench_function("casteljau", |b| {
        b.iter(|| each(&cubics.ours, &ours));
    });
    group.finish();
}

#[inline(always)]
fn each<C, R>(curves: &[C], act: impl Fn(&C, usize) -> R) {
    for (k, curve) in curves.iter().enumerate() {
        black_box(act(curve, k));
    }
}

/// Checks that two results are equal up to rounding; `size` is that of the numbers they were computed from.
fn assert_near(theirs: f64, ours: f64, size: f64) {
    let apart = (theirs - ours).abs();
    assert!(apart <= TOLERANCE * size, "{theirs}, ours {ours}");
}

fn area(criterion: &mut Criterion, cubics: &Cubics) {
    for (theirs, ours) in cubics.kurbo.iter().zip(&cubics.ours) {
        assert_near(theirs.signed_area(), ours.area(), 1e5);
    }
    both(
        criterion,
        "area",
        cubics,
        |curve, _| curve.signed_area(),
        |curve, _| curve.area(),
    );
}

fn inflections(criterion: &mut Criterion, cubics: &Cubics) {
    for (theirs, ours) in cubics.kurbo.iter().zip(&cubics.ours) {
        let (theirs, ours) = (CubicBez::inflections(theirs), ours.inflections());
        assert_eq!(theirs.len(), ours.len());
        for (&theirs, &ours) in theirs.iter().zip(&ours) {
            assert_near(theirs, ours, 1e3);
        }
    }
    both(
        criterion,
        "inflections",
        cubics,
        |curve, _| CubicBez::inflections(curve),
        |curve, _| curve.inflections(),
    );
}

fn bounds(criterion: &mut Criterion, cubics: &Cubics) {
    for (theirs, ours) in cubics.kurbo.iter().zip(&cubics.ours) {
        let (theirs, ours) = (ParamCurveExtrema::bounding_box(theirs), ours.bounds());
        assert_near(theirs.x0, ours.min.x, 200.0);
        assert_near(theirs.y1, ours.max.y, 200.0);
    }
    both(
        criterion,
        "bounds",
        cubics,
        |curve, _| ParamCurveExtrema::bounding_box(curve),
        |curve, _| curve.bounds(),
    );
}

fn time_at_length(criterion: &mut Criterion, cubics: &Cubics) {
    let parts = parameters();
    let lengths: Vec<f64> = cubics.ours.iter().map(Curve::length).collect();
    let s = |k: usize| parts[k] * lengths[k];
    let theirs = |curve: &CubicBez, k: usize| curve.inv_arclen(s(k), ACCURACY);
    let ours = |curve: &Curve<DVec2>, k: usize| {
        let found = curve.time_at_length_within(s(k), ACCURACY);
        found.expect("a tolerance above the rounding")
    };
    for (k, curve) in cubics.ours.iter().enumerate() {
        let at = |t: f64| curve.subsegment(0.0..t).length();
        let apart = (at(theirs(&cubics.kurbo[k], k)) - at(ours(curve, k))).abs();
        assert!(apart <= 10.0 * ACCURACY, "{apart}");
    }
    both(criterion, "time-at-length", cubics, theirs, ours);
}

/// One path of all cubics, in which every second one is replaced by a line.
fn path(criterion: &mut Criterion, cubics: &Cubics) {
    let (mut theirs, mut lines) = (BezPath::new(), BezPath::new());
    for (k, cubic) in cubics.kurbo.iter().enumerate() {
        if k == 0 {
            theirs.move_to(cubic.p0);
            lines.move_to(cubic.p0);
        }
        lines.line_to(cubic.p3);
        if k % 2 == 0 {
            theirs.curve_to(cubic.p1, cubic.p2, cubic.p3);
        } else {
            theirs.line_to(cubic.p3);
        }
    }
    theirs.close_path();
    let ours = Path::try_from(&theirs).expect("finite");
    let our_lines = Path::try_from(&lines).expect("finite");
    assert_near(theirs.area(), ours.area(), 1e7);

    let mut group = criterion.benchmark_group("path-area");
    group.bench_function("kurbo", |b| b.iter(|| theirs.area()));
    group.bench_function("casteljau", |b| b.iter(|| ours.area()));
    group.finish();

    let mut group = criterion.benchmark_group("flatten-lines");
    group.bench_function("kurbo", |b| {
        b.iter(|| {
            kurbo::flatten(lines.elements().iter().copied(), 0.01, |element| {
                if let PathEl::LineTo(p) = element {
                    black_box(p);
                }
            });
        });
    });
    group.bench_function("casteljau", |b| {
        b.iter(|| {
            let done = our_lines.flatten_with(0.01, |_, p| {
                black_box(p);
            });
            done.expect("within the limits");
        });
    });
    group.finish();

    let mut group = criterion.benchmark_group("to-svg");
    group.bench_function("kurbo", |b| b.iter(|| theirs.to_svg()));
    group.bench_function("casteljau", |b| b.iter(|| ours.to_svg()));
    group.finish();

    let pattern = [7.0, 3.0];
    let mut group = criterion.benchmark_group("dash");
    group.bench_function("kurbo", |b| {
        b.iter(|| {
            kurbo::dash(theirs.elements().iter().copied(), 0.0, &pattern).collect::<BezPath>()
        });
    });
    group.bench_function("casteljau", |b| {
        b.iter(|| ours.dash(&pattern, 0.0));
    });
    group.finish();
}
