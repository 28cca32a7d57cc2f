//! The union of two outlines of 6,400 cubics, compared with linesweeper and i_curve.

use crate::inputs::Random;
use casteljau::glam::DVec2;
use casteljau::path::{FillRule, PathElement};
use casteljau::{Path, Spline};
use criterion::Criterion;
use i_curve::{CurveBuilder, FloatCurveShape, OverlayRule};
use kurbo::BezPath;
use linesweeper::BinaryOp;
use std::f64::consts::TAU;
use std::hint::black_box;

/// The number of cubics of each outline.
const COUNT: usize = 6400;

/// The pairs of small outlines whose results are counted.
const PAIRS: usize = 200;

const OPERATIONS: [(BinaryOp, OverlayRule); 4] = [
    (BinaryOp::Union, OverlayRule::Union),
    (BinaryOp::Intersection, OverlayRule::Intersect),
    (BinaryOp::Difference, OverlayRule::Difference),
    (BinaryOp::Xor, OverlayRule::Xor),
];

/// The largest difference of the areas of two results, relative to the area; i_curve rounds to a grid.
const TOLERANCE: f64 = 1e-4;

pub(crate) fn bench(criterion: &mut Criterion) {
    let mut random = Random::new(1);
    let [a, b] =
        [DVec2::ZERO, DVec2::new(0.01, 0.005)].map(|centre| ring(&mut random, centre, COUNT, 0.02));
    let (kurbo_a, kurbo_b) = (bez_path(&a), bez_path(&b));
    let (shape_a, shape_b) = (shape(&a), shape(&b));
    let ours = || a.union(&b, FillRule::NonZero).expect("few segments");
    let sweep = || {
        let rule = linesweeper::FillRule::NonZero;
        linesweeper::binary_op(&kurbo_a, &kurbo_b, rule, BinaryOp::Union).expect("finite points")
    };
    let area = ours().area();
    let theirs: f64 = sweep()
        .contours()
        .map(|c| kurbo::Shape::area(&c.path))
        .sum();
    let apart = (area - theirs.abs()).abs();
    assert!(
        apart <= TOLERANCE * area,
        "linesweeper: {theirs}, ours {area}"
    );
    count_segments(&mut random);
    let mut group = criterion.benchmark_group("union");
    group.sample_size(10);
    group.bench_function("linesweeper", |bench| bench.iter(|| black_box(sweep())));
    group.bench_function("i_curve", |bench| {
        let rule = i_curve::FillRule::NonZero;
        bench.iter(|| black_box(shape_a.overlay(&shape_b, OverlayRule::Union, rule)));
    });
    group.bench_function("casteljau", |bench| bench.iter(|| black_box(ours())));
    group.finish();
}

/// The segments of all results of four operations on small outlines, half of which cross themselves.
fn count_segments(random: &mut Random) {
    let [mut ours, mut sweep, mut curve] = [0; 3];
    for pair in 0..PAIRS {
        let [a, b] = [(); 2].map(|()| small(random, pair % 2 == 0));
        let (bez_a, bez_b) = (bez_path(&a), bez_path(&b));
        let (shape_a, shape_b) = (shape(&a), shape(&b));
        let results = [
            a.union(&b, FillRule::NonZero),
            a.intersect(&b, FillRule::NonZero),
            a.subtract(&b, FillRule::NonZero),
            a.exclude(&b, FillRule::NonZero),
        ];
        let of = |path: Result<Path, _>| path.expect("few segments").segment_count();
        ours += results.into_iter().map(of).sum::<usize>();
        for (op, rule) in OPERATIONS {
            let found = linesweeper::binary_op(&bez_a, &bez_b, linesweeper::FillRule::NonZero, op);
            let found = found.expect("finite points");
            sweep += found
                .contours()
                .map(|c| c.path.segments().count())
                .sum::<usize>();
            let found = shape_a.overlay(&shape_b, rule, i_curve::FillRule::NonZero);
            let contours = found.iter().flat_map(|each| each.contours());
            curve += contours.map(|each| each.segments().len()).sum::<usize>();
        }
    }
    println!("segments: linesweeper {sweep}, i_curve {curve}, casteljau {ours}");
    assert!(ours <= curve, "{ours} segments, i_curve {curve}");
}

/// An outline of 8 cubics: a wavy ring, or a loop through random points.
fn small(random: &mut Random, crosses: bool) -> Path {
    if !crosses {
        let centre = DVec2::new(random.next(), random.next());
        return ring(random, centre, 8, 0.7);
    }
    let points: Vec<DVec2> = (0..24)
        .map(|_| DVec2::new(random.next(), random.next()))
        .collect();
    Path::from(Spline::new(&points, 3, true).expect("finite points"))
}

/// A closed smooth outline around a point, with random waves of a depth.
fn ring(random: &mut Random, centre: DVec2, count: usize, wave: f64) -> Path {
    let radii: Vec<f64> = (0..count).map(|_| 1.0 - wave * random.next()).collect();
    let at = |k: usize| {
        let angle = TAU * (k % count) as f64 / count as f64;
        centre + DVec2::from_angle(angle) * radii[k % count]
    };
    let tangent = |k: usize| (at(k + 1) - at(k + count - 1)) / 6.0;
    let points: Vec<DVec2> = (0..count)
        .flat_map(|k| [at(k), at(k) + tangent(k), at(k + 1) - tangent(k + 1)])
        .collect();
    Path::from(Spline::new(&points, 3, true).expect("finite points"))
}

fn bez_path(path: &Path) -> BezPath {
    let point = |p: DVec2| kurbo::Point::new(p.x, p.y);
    let mut copy = BezPath::new();
    for element in path.elements() {
        match element {
            PathElement::MoveTo(p) => copy.move_to(point(p)),
            PathElement::LineTo(p) => copy.line_to(point(p)),
            PathElement::QuadTo(p1, p) => copy.quad_to(point(p1), point(p)),
            PathElement::CubicTo(p1, p2, p) => copy.curve_to(point(p1), point(p2), point(p)),
            PathElement::Close => copy.close_path(),
        }
    }
    copy
}

fn shape(path: &Path) -> FloatCurveShape<[f64; 2]> {
    let mut builder = CurveBuilder::new();
    for element in path.elements() {
        let built = match element {
            PathElement::MoveTo(p) => builder.move_to(p.to_array()),
            PathElement::LineTo(p) => builder.line_to(p.to_array()),
            PathElement::QuadTo(p1, p) => builder.quad_to(p1.to_array(), p.to_array()),
            PathElement::CubicTo(p1, p2, p) => {
                builder.cubic_to(p1.to_array(), p2.to_array(), p.to_array())
            }
            PathElement::Close => builder.close_contour(),
        };
        built.expect("a valid command");
    }
    builder.build().expect("closed contours")
}
