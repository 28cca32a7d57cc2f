//! Rational cubics beside polynomial ones with the same points: the cost of weights.

use crate::inputs::{Cubics, parameters};
use casteljau::glam::DVec2;
use casteljau::{Curve, RationalCurve};
use criterion::Criterion;
use std::hint::black_box;

/// The tolerance of flattening, in a square of size 200.
const TOLERANCE: f64 = 0.1;

pub(crate) fn bench(criterion: &mut Criterion) {
    let (curves, ts) = (Cubics::new().ours, parameters());
    // Weights from ½ to 2.
    let weight = |t: f64| (2.0 * t - 1.0).exp2();
    let rational: Vec<RationalCurve<DVec2>> = curves
        .iter()
        .enumerate()
        .map(|(k, curve)| {
            let weights = [0, 1, 2, 3].map(|i| weight(ts[(k + 7 * i) % ts.len()]));
            RationalCurve::new(curve.control_points(), &weights).expect("valid")
        })
        .collect();
    let queries: Vec<DVec2> = (ts.iter().zip(ts.iter().rev()))
        .map(|(&x, &y)| DVec2::new(x, y) * 200.0)
        .collect();
    let mut rows = Rows {
        criterion,
        curves: &curves,
        rational: &rational,
    };
    rows.row("rational-eval", |k, c| c.eval(ts[k]), |k, c| c.eval(ts[k]));
    rows.row("rational-length", |_, c| c.length(), |_, c| c.length());
    rows.row(
        "rational-nearest",
        |k, c| c.nearest(queries[k]).expect("finite").t,
        |k, c| c.nearest(queries[k]).expect("finite").t,
    );
    rows.row(
        "rational-flatten",
        |_, c| c.flatten(TOLERANCE).expect("a tolerance").ts.len(),
        |_, c| c.flatten(TOLERANCE).expect("a tolerance").ts.len(),
    );
}

struct Rows<'a> {
    criterion: &'a mut Criterion,
    curves: &'a [Curve<DVec2>],
    rational: &'a [RationalCurve<DVec2>],
}

impl Rows<'_> {
    fn row<R>(
        &mut self,
        name: &str,
        polynomial: impl Fn(usize, &Curve<DVec2>) -> R,
        rational: impl Fn(usize, &RationalCurve<DVec2>) -> R,
    ) {
        let mut group = self.criterion.benchmark_group(name);
        group.bench_function("polynomial", |b| {
            b.iter(|| {
                for (k, curve) in self.curves.iter().enumerate() {
                    black_box(polynomial(k, curve));
                }
            });
        });
        group.bench_function("rational", |b| {
            b.iter(|| {
                for (k, curve) in self.rational.iter().enumerate() {
                    black_box(rational(k, curve));
                }
            });
        });
        group.finish();
    }
}
