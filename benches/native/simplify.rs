//! Simplification of smooth outlines, compared with kurbo, whose accuracy is estimated from samples.

use crate::inputs::Random;
use casteljau::glam::DVec2;
use casteljau::{Path, Spline};
use criterion::Criterion;
use kurbo::BezPath;
use kurbo::simplify::{SimplifyOptions, simplify_bezpath};
use std::f64::consts::TAU;
use std::hint::black_box;

const OUTLINES: usize = 20;

/// The number of cubics of each outline.
const COUNT: usize = 200;
const RADIUS: f64 = 100.0;
const TOLERANCE: f64 = 0.1;

pub(crate) fn bench(criterion: &mut Criterion) {
    let mut random = Random::new(5);
    let outlines: Vec<Path> = (0..OUTLINES).map(|_| outline(&mut random)).collect();
    let paths: Vec<BezPath> = outlines.iter().map(BezPath::from).collect();
    let theirs =
        |path: &BezPath| simplify_bezpath(path.iter(), TOLERANCE, &SimplifyOptions::default());
    let ours = |path: &Path| path.simplify(TOLERANCE).expect("a tolerance");
    let count: usize = outlines.iter().map(|path| ours(path).segment_count()).sum();
    let their_count: usize = paths
        .iter()
        .map(|path| theirs(path).segments().count())
        .sum();
    println!("segments: kurbo {their_count}, casteljau {count}");
    assert!(
        count <= their_count,
        "{count} segments, kurbo {their_count}"
    );
    let mut group = criterion.benchmark_group("simplify");
    group.bench_function("kurbo", |b| {
        b.iter(|| paths.iter().for_each(|path| drop(black_box(theirs(path)))));
    });
    group.bench_function("casteljau", |b| {
        b.iter(|| outlines.iter().for_each(|path| drop(black_box(ours(path)))));
    });
    group.finish();
}

/// A smooth outline with five lobes and a random phase.
fn outline(random: &mut Random) -> Path {
    let phase = TAU * random.next();
    let corner = |k: usize| {
        let angle = TAU * k as f64 / COUNT as f64;
        DVec2::from_angle(angle) * (RADIUS * (1.0 + 0.2 * (5.0 * angle + phase).sin()))
    };
    let points: Vec<DVec2> = (0..COUNT).map(corner).collect();
    let spline = Spline::interpolate(&points, Default::default(), true).expect("points");
    Path::new(&[spline])
}
