//! Strokes with round joins and caps, compared with kurbo, whose outlines overlap.

use crate::inputs::Cubics;
use casteljau::Path;
use casteljau::path::{FillRule, Join, StrokeCap, StrokeOptions};
use criterion::Criterion;
use kurbo::{BezPath, Shape, StrokeOpts};
use std::hint::black_box;

const WIDTH: f64 = 10.0;
const TOLERANCE: f64 = 0.1;

pub(crate) fn bench(criterion: &mut Criterion) {
    let cubics = Cubics::new();
    let paths: Vec<Path> = cubics.ours.iter().map(|c| Path::from(c.clone())).collect();
    let theirs: Vec<BezPath> = cubics.kurbo.iter().map(|c| c.to_path(TOLERANCE)).collect();
    let overlapping = StrokeOptions::new()
        .join(Join::Round)
        .cap(StrokeCap::Round)
        .tolerance(TOLERANCE)
        .simple(false);
    check(&theirs, &paths, &overlapping);
    let mut group = criterion.benchmark_group("stroke");
    group.bench_function("kurbo", |b| {
        b.iter(|| {
            for path in &theirs {
                black_box(by_kurbo(path));
            }
        });
    });
    group.bench_function("casteljau", |b| b.iter(|| strokes(&paths, &overlapping)));
    group.finish();
    let simple = overlapping.simple(true);
    let mut group = criterion.benchmark_group("stroke-simple");
    group.bench_function("casteljau", |b| b.iter(|| strokes(&paths, &simple)));
    group.finish();
}

fn by_kurbo(path: &BezPath) -> BezPath {
    let style = kurbo::Stroke::new(WIDTH);
    kurbo::stroke(path.iter(), &style, &StrokeOpts::default(), TOLERANCE)
}

fn strokes(paths: &[Path], options: &StrokeOptions) {
    for path in paths {
        let _ = black_box(path.stroke(WIDTH, options).expect("finite points"));
    }
}

/// Checks that the areas of most strokes agree, and that ours have no more segments in total.
fn check(theirs: &[BezPath], paths: &[Path], options: &StrokeOptions) {
    let (mut their_count, mut our_count, mut same) = (0, 0, 0);
    for (their, our) in theirs.iter().zip(paths) {
        let (their, our) = (by_kurbo(their), our.stroke(WIDTH, options).expect("finite"));
        their_count += their.segments().count();
        our_count += our.segments().count();
        let [theirs, ours] = [Path::try_from(&their).expect("finite"), our].map(|outline| {
            let area = outline.filled_area(FillRule::NonZero);
            area.expect("few segments")
        });
        same += usize::from((theirs - ours).abs() < 1e-2 * ours);
    }
    println!("segments: kurbo {their_count}, casteljau {our_count}; {same} areas agree");
    assert!(our_count <= their_count && 10 * same >= 9 * paths.len());
}
