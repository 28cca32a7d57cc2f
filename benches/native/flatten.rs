//! Flattening: time, number of segments, and the actual distance from the curve.

use crate::inputs::Cubics;
use casteljau::Curve;
use casteljau::glam::DVec2;
use criterion::Criterion;
use kurbo::{CubicBez, PathEl};
use lyon_geom::CubicBezierSegment;
use std::hint::black_box;

const TOLERANCES: [f64; 2] = [0.1, 0.01];

/// The number of points of a curve at which the distance from the polyline is measured.
const PROBES: usize = 500;

/// The maximum ratio of distance to tolerance. Only our implementation guarantees the tolerance; the others aim at it.
const OUR_SLACK: f64 = 1.0 + 1e-9;
const THEIR_SLACK: f64 = 4.0;

/// Flattens the curve with the given index and passes each vertex except the first to a function.
type Flatten<'a> = &'a dyn Fn(usize, f64, &mut dyn FnMut(DVec2));

pub(crate) fn bench(criterion: &mut Criterion) {
    let cubics = Cubics::new();
    let counted: Vec<_> = TOLERANCES
        .iter()
        .map(|&tolerance| count(&cubics, tolerance))
        .collect();
    // benches/js/run.js reads this file.
    let file = concat!(env!("CARGO_TARGET_TMPDIR"), "/flatten.json");
    std::fs::write(file, serde_json::Value::from(counted).to_string()).expect(file);
    for tolerance in TOLERANCES {
        time(criterion, &cubics, tolerance);
    }
}

/// Benchmarks one group: 1,000 cubics per iteration.
fn time(criterion: &mut Criterion, cubics: &Cubics, tolerance: f64) {
    let mut group = criterion.benchmark_group(format!("flatten-{tolerance}"));
    group.bench_function("kurbo", |b| {
        b.iter(|| {
            for curve in &cubics.kurbo {
                flatten_kurbo(curve, tolerance, consume);
            }
        });
    });
    group.bench_function("lyon_geom", |b| {
        b.iter(|| {
            for curve in &cubics.lyon {
                flatten_lyon(curve, tolerance, consume);
            }
        });
    });
    group.bench_function("casteljau", |b| {
        b.iter(|| {
            for curve in &cubics.ours {
                flatten_ours(curve, tolerance, consume);
            }
        });
    });
    group.finish();
}

fn consume(p: DVec2) {
    black_box(p);
}

fn flatten_kurbo(curve: &CubicBez, tolerance: f64, mut vertex: impl FnMut(DVec2)) {
    let path = [
        PathEl::MoveTo(curve.p0),
        PathEl::CurveTo(curve.p1, curve.p2, curve.p3),
    ];
    kurbo::flatten(path, tolerance, |element| {
        if let PathEl::LineTo(p) = element {
            vertex(DVec2::new(p.x, p.y));
        }
    });
}

fn flatten_lyon(curve: &CubicBezierSegment<f64>, tolerance: f64, mut vertex: impl FnMut(DVec2)) {
    curve.for_each_flattened(tolerance, &mut |line| {
        vertex(DVec2::new(line.to.x, line.to.y));
    });
}

fn flatten_ours(curve: &Curve<DVec2>, tolerance: f64, mut vertex: impl FnMut(DVec2)) {
    let done = curve.flatten_with(tolerance, |t, p| {
        if t > 0.0 {
            vertex(p);
        }
    });
    done.expect("a tolerance far above rounding");
}

/// Counts the segments of each library, measures the maximum distance from the curves, and prints both.
fn count(cubics: &Cubics, tolerance: f64) -> serde_json::Value {
    let kurbo: Flatten<'_> = &|k, tolerance, v| flatten_kurbo(&cubics.kurbo[k], tolerance, v);
    let lyon: Flatten<'_> = &|k, tolerance, v| flatten_lyon(&cubics.lyon[k], tolerance, v);
    let ours: Flatten<'_> = &|k, tolerance, v| flatten_ours(&cubics.ours[k], tolerance, v);
    let sides = [
        ("kurbo", kurbo, THEIR_SLACK),
        ("lyon_geom", lyon, THEIR_SLACK),
        ("casteljau", ours, OUR_SLACK),
    ];
    let (mut all_segments, mut all_worst) = (serde_json::Map::new(), serde_json::Map::new());
    for (name, flatten, slack) in sides {
        let (segments, worst) = measure(cubics, tolerance, flatten);
        println!(
            "flatten to {tolerance}: {name:10} {segments:6} segments, greatest distance {worst:.3} of the tolerance"
        );
        assert!(worst <= slack, "{name} strays from the curve");
        all_segments.insert(name.into(), segments.into());
        all_worst.insert(name.into(), worst.into());
    }
    serde_json::json!({ "tolerance": tolerance, "segments": all_segments, "worst": all_worst })
}

/// The number of segments, and the maximum distance as a ratio of the tolerance.
fn measure(cubics: &Cubics, tolerance: f64, flatten: Flatten<'_>) -> (usize, f64) {
    let (mut segments, mut worst) = (0, 0.0_f64);
    for (k, curve) in cubics.ours.iter().enumerate() {
        let mut line = vec![curve.start()];
        flatten(k, tolerance, &mut |p| line.push(p));
        let end = line[line.len() - 1];
        assert!((end - curve.end()).length() < 1e-9, "ends elsewhere: {end}");
        segments += line.len() - 1;
        worst = worst.max(distance(curve, &line) / tolerance);
    }
    (segments, worst)
}

/// The maximum distance of points of the curve from the polyline.
fn distance(curve: &Curve<DVec2>, line: &[DVec2]) -> f64 {
    let nearest = |p: DVec2| {
        let distances = line
            .windows(2)
            .map(|ends| distance_squared(p, ends[0], ends[1]));
        distances.fold(f64::INFINITY, f64::min)
    };
    let points = curve.sample(PROBES).expect("few segments");
    points.into_iter().map(nearest).fold(0.0, f64::max).sqrt()
}

fn distance_squared(p: DVec2, from: DVec2, to: DVec2) -> f64 {
    let along = to - from;
    let location = (p - from).dot(along) / along.length_squared();
    let foot = if location.is_nan() {
        from
    } else {
        from + along * location.clamp(0.0, 1.0)
    };
    (p - foot).length_squared()
}
