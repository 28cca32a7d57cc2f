//! Large inputs: thousands to a million of contacts, judged by closed forms, brute force and winding numbers.

use crate::path_boolean::check::{is_inside, path, valid};
use crate::path_boolean::oracle::Outline;
use crate::support::measure::from_polyline;
use crate::support::paths::{RandomPlane, lines};
use crate::support::{Rng, deep, near, real};
use casteljau::Path;
use casteljau::glam::DVec2;
use casteljau::path::{BooleanOperation, FillRule, PathBuilder, StrokeOptions};
use std::f64::consts::{PI, TAU};

const RULES: [FillRule; 2] = [FillRule::NonZero, FillRule::EvenOdd];

fn spots(random: &mut Rng, count: usize) -> Vec<DVec2> {
    (0..count).map(|_| random.spot(50.0) + 50.0).collect()
}

/// Separate random cubics.
fn cubics(seed: u64, count: usize) -> Path {
    let (mut random, mut builder) = (Rng(seed), PathBuilder::new());
    for _ in 0..count {
        let p = spots(&mut random, 4);
        builder.move_to(p[0]);
        builder.cubic_to(p[1], p[2], p[3]);
    }
    builder.build().expect("finite points")
}

/// The star polygon {n/k} in the unit circle.
fn star(n: usize, k: usize) -> Path {
    let corner = |i: usize| DVec2::from_angle(TAU * real(i * k % n) / real(n));
    lines(&(0..n).map(corner).collect::<Vec<_>>(), true)
}

/// The areas of the points of the star polygon {n/k} with winding numbers of at least 1 to k.
///
/// Its sides are at the distance d = cos(πk/n) from the centre and intersect at the distances ρₘ = d / cos(πm/n); the
/// points with winding numbers of at least w form a star with 2n corners at ρₘ and ρₘ₋₁, where m = k − w + 1.
fn areas_of_star(n: usize, k: usize) -> Vec<f64> {
    let step = PI / real(n);
    let rho = |m: usize| (step * real(k)).cos() / (step * real(m)).cos();
    let area = |w: usize| real(n) * rho(k - w + 1) * rho(k - w) * step.sin();
    (1..=k).map(area).collect()
}

/// Checks the region with odd winding numbers of a star polygon.
fn assert_odd_region(n: usize, k: usize, tolerance: f64) {
    let odd = valid(star(n, k).remove_overlaps(FillRule::EvenOdd));
    // Two segments of contours for each of the n(k − 1) crossings, and one more for each side.
    assert_eq!(odd.segment_count(), n + 2 * n * (k - 1), "{{{n}/{k}}}");
    let signs = [1.0, -1.0].iter().cycle();
    let areas = areas_of_star(n, k).into_iter().zip(signs);
    let expected = areas.map(|(area, sign)| area * sign).sum();
    near(odd.area(), expected, tolerance);
}

#[test]
fn stars() {
    for (n, k) in [(101, 42), (101, 43), (301, 143), (1001, 100), (1001, 500)] {
        let outline = valid(star(n, k).remove_overlaps(FillRule::NonZero));
        assert_eq!(outline.segment_count(), 2 * n, "{{{n}/{k}}}");
        near(outline.area(), areas_of_star(n, k)[0], 1e-10);
        assert_odd_region(n, k, 1e-10);
    }
}

/// The number of crossings of the sides of a polygon, by comparing all pairs.
fn crossing_count(points: &[DVec2]) -> usize {
    let n = points.len();
    let side = |i: usize| (points[i], points[(i + 1) % n]);
    let separates = |(a, b): (DVec2, DVec2), (c, d): (DVec2, DVec2)| {
        (b - a).perp_dot(c - a) * (b - a).perp_dot(d - a) < 0.0
    };
    let crosses = |i: usize, j: usize| {
        let is_next = j == i + 1 || (i, j) == (0, n - 1);
        !is_next && separates(side(i), side(j)) && separates(side(j), side(i))
    };
    let crossings = |i: usize| (i + 1..n).filter(move |&j| crosses(i, j)).count();
    (0..n).map(crossings).sum()
}

/// Compares the winding numbers of a result with those of its input at random points farther than 10⁻⁷ from it.
fn check_windings(input: &Path, result: &Path, rule: FillRule, count: usize) {
    let (outline, region, mut random) = (Outline::new(input), Outline::new(result), Rng(5));
    let bounds = input.bounds().expect("a box");
    for _ in 0..count {
        let part = DVec2::new(random.unit(), random.unit());
        let p = bounds.min + (bounds.max - bounds.min) * part;
        let expected = i32::from(is_inside(outline.winding(p), rule));
        assert_eq!(region.winding(p), expected, "at {p}");
    }
}

#[test]
fn random_polygons() {
    // The largest has about 490,000 crossings.
    for count in [240, 600, 2000] {
        // No three sides of these polygons pass within ε of a point: their crossings would count as one.
        let points = spots(&mut Rng(5), count);
        let path = lines(&points, true);
        let odd = valid(path.remove_overlaps(FillRule::EvenOdd));
        let expected = count + 2 * crossing_count(&points);
        assert_eq!(odd.segment_count(), expected, "{count} points");
        check_windings(&path, &odd, FillRule::EvenOdd, 40);
        let filled = valid(path.remove_overlaps(FillRule::NonZero));
        check_windings(&path, &filled, FillRule::NonZero, 40);
        assert!(filled.area() > odd.area(), "{count} points");
    }
}

#[test]
fn random_cubics() {
    let counts: &[usize] = if deep() { &[80, 300, 1000] } else { &[80, 300] };
    for &count in counts {
        let path = cubics(2, count);
        for rule in RULES {
            let region = valid(path.remove_overlaps(rule));
            check_windings(&path, &region, rule, 40);
        }
    }
}

#[test]
fn more_than_a_million_contacts() {
    if deep() {
        assert_odd_region(1501, 700, 1e-9);
    }
}

#[test]
fn the_stroke_of_a_scribble() {
    let count = if deep() { 5000 } else { 1500 };
    let mut random = Rng(3);
    let mut points = vec![DVec2::splat(50.0)];
    while points.len() < count {
        let to = points[points.len() - 1] + random.spot(15.0);
        points.push(to.clamp(DVec2::ZERO, DVec2::splat(100.0)));
    }
    let (path, options) = (lines(&points, false), StrokeOptions::default());
    let stroke = valid(path.stroke(0.5, &options));
    let region = Outline::new(&stroke);
    let mut inside = 0;
    for p in spots(&mut random, 400) {
        // Miters reach farther than half the width, up to four times.
        let (winding, distance) = (region.winding(p), from_polyline(p, &points));
        if distance < 0.2499 {
            let caps = [points[0], points[points.len() - 1]];
            let in_cap = caps.iter().any(|end| end.distance(p) < 0.26);
            assert!(winding == 1 || in_cap, "{p} is not inside");
            inside += 1;
        } else if distance > 1.001 {
            assert_eq!(winding, 0, "{p} is inside");
        }
        assert!((0..=1).contains(&winding), "{p}: winding number {winding}");
    }
    assert!(inside > 50, "{inside} points inside");
}

#[test]
fn the_stroke_of_many_cubics() {
    let (path, options) = (cubics(4, 100), StrokeOptions::default());
    let region = Outline::new(&valid(path.stroke(1.0, &options)));
    for p in spots(&mut Rng(5), 300) {
        // Points next to the boundary of the stroke are decided by its tolerance.
        let near = [0.98, 1.02].map(|width| path.stroke_contains(p, width, &options));
        if near[0] == near[1] {
            assert_eq!(Ok(region.winding(p)), near[0].map(i32::from), "{p}");
        }
    }
}

fn circles(count: usize) -> (Vec<Path>, Vec<(DVec2, f64)>) {
    let mut random = Rng(6);
    let centres = spots(&mut random, count).into_iter();
    let disks = centres.map(|centre| (centre, random.between(1.0, 2.5)));
    let disks: Vec<_> = disks.collect();
    let circle = |&(DVec2 { x, y }, r): &(DVec2, f64)| {
        let (left, width) = (x - r, 2.0 * r);
        path(&format!(
            "M{left} {y}a{r} {r} 0 0 1 {width} 0a{r} {r} 0 0 1 -{width} 0z"
        ))
    };
    (disks.iter().map(circle).collect(), disks)
}

fn union_of(paths: &[Path]) -> Path {
    let operation = BooleanOperation::Union;
    valid(Path::combine(paths, operation, FillRule::NonZero))
}

#[test]
fn unions_of_overlapping_circles() {
    let (paths, disks) = circles(2000);
    let union = union_of(&paths);
    let pairwise = paths.iter().fold(Path::default(), |all, path| {
        valid(all.union(path, FillRule::NonZero))
    });
    let areas = [union.area(), pairwise.area()];
    assert!((areas[0] - areas[1]).abs() < 1e-6 * areas[0], "{areas:?}");
    assert_eq!(union.subpath_count(), pairwise.subpath_count());
    let (region, mut random, mut inside) = (Outline::new(&union), Rng(7), 0);
    for p in spots(&mut random, 2000) {
        let depth = |(centre, radius): &(DVec2, f64)| radius - centre.distance(p);
        let depth = disks.iter().map(depth).fold(f64::NEG_INFINITY, f64::max);
        if depth.abs() > 1e-4 {
            assert_eq!(region.winding(p), i32::from(depth > 0.0), "{p}");
            inside += i32::from(depth > 0.0);
        }
    }
    assert!((500..1900).contains(&inside), "{inside} points inside");
}

#[test]
fn many_lines_through_a_point() {
    // Each pair of the parallelograms crosses near the centre, and opposite ones coincide.
    let count = 120;
    let mut builder = PathBuilder::new();
    for k in 0..count {
        let [p, q] = [0.0, 0.3].map(|part| DVec2::from_angle(TAU * (real(k) + part) / real(count)));
        builder.polygon(&[p, q, -p, -q]);
    }
    let path = builder.build().expect("finite points");
    let odd = valid(path.remove_overlaps(FillRule::EvenOdd));
    assert!(odd.area() < 1e-12, "{}", odd.area());
    let filled = valid(path.remove_overlaps(FillRule::NonZero));
    check_windings(&path, &filled, FillRule::NonZero, 500);
}

#[test]
fn hatching_crosses_nothing() {
    let count = 1000;
    let lines = |k: usize| {
        let x = 100.0 * real(k) / real(count);
        let [a, b] = [DVec2::new(x, 0.0), DVec2::new(x + 100.0, 100.0)];
        let wide = DVec2::new(0.04, 0.0);
        lines(&[a, b, b + wide, a + wide], true)
    };
    let paths: Vec<Path> = (0..count).map(lines).collect();
    let union = union_of(&paths);
    assert_eq!(union.subpath_count(), count);
    assert!((union.area() - 4.0 * real(count)).abs() < 1e-6);
}
