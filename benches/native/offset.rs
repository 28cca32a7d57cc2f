//! Offset curves, compared with kurbo. Our error is bounded; kurbo's is estimated from samples.

use crate::inputs::Cubics;
use casteljau::glam::DVec2;
use criterion::Criterion;
use kurbo::BezPath;
use std::hint::black_box;

const DISTANCE: f64 = 10.0;
const TOLERANCE: f64 = 0.1;

pub(crate) fn bench(criterion: &mut Criterion) {
    let cubics = Cubics::new();
    check(&cubics);
    let mut group = criterion.benchmark_group("offset-0.1");
    group.bench_function("kurbo", |b| {
        let mut path = BezPath::new();
        b.iter(|| {
            for &curve in &cubics.kurbo {
                kurbo::offset::offset_cubic(curve, DISTANCE, TOLERANCE, &mut path);
                black_box(&path);
            }
        });
    });
    group.bench_function("casteljau", |b| {
        b.iter(|| {
            for curve in &cubics.ours {
                let _ = black_box(curve.offset_within(DISTANCE, TOLERANCE).expect("finite"));
            }
        });
    });
    group.finish();
}

/// Checks that both libraries give the same end points, and that ours needs no more segments in total.
fn check(cubics: &Cubics) {
    let (mut theirs, mut ours) = (0, 0);
    let mut path = BezPath::new();
    for (&curve, own) in cubics.kurbo.iter().zip(&cubics.ours) {
        kurbo::offset::offset_cubic(curve, DISTANCE, TOLERANCE, &mut path);
        let spline = own.offset_within(DISTANCE, TOLERANCE).expect("finite");
        theirs += path.elements().len() - 1;
        ours += spline.segment_count();
        let end = path
            .elements()
            .last()
            .and_then(|element| element.end_point());
        let end = end.map_or(DVec2::NAN, |p| DVec2::new(p.x, p.y));
        let own_end = spline.control_points()[spline.control_points().len() - 1];
        assert!((end - own_end).length() < 1e-6, "{end} and {own_end}");
    }
    println!("pieces: kurbo {theirs}, casteljau {ours}");
    assert!(ours <= theirs, "{ours} pieces, kurbo {theirs}");
}
