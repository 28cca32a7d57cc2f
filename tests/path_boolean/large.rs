//! Large inputs: thousands to a million of contacts, judged by closed forms, brute force and winding numbers.

use crate::path_boolean::check::{is_inside, valid};
use crate::path_boolean::oracle::Outline;
use crate::path_boolean::random::Random;
use crate::support::deep;
use casteljau::Path;
use casteljau::glam::DVec2;
use casteljau::path::{BooleanOperation, FillRule, PathBuilder, StrokeOptions};
use std::f64::consts::{PI, TAU};

const RULES: [FillRule; 2] = [FillRule::NonZero, FillRule::EvenOdd];

fn real(n: usize) -> f64 {
    f64::from(u32::try_from(n).expect("a small number"))
}

fn polyline(points: &[DVec2], closed: bool) -> Path {
    let mut builder = PathBuilder::new();
    builder.move_to(points[0]);
    points[1..].iter().for_each(|&p| builder.line_to(p));
    if closed {
        builder.close();
    }
    builder.build().expect("finite points")
}

fn random_points(random: &mut Random, count: usize) -> Vec<DVec2> {
    (0..count)
        .map(|_| DVec2::new(random.between(0.0, 100.0), random.between(0.0, 100.0)))
        .collect()
}

/// The star polygon {n/k} in the unit circle.
fn star(n: usize, k: usize) -> Path {
    let corner = |i: usize| DVec2::from_angle(TAU * real(i * k % n) / real(n));
    polyline(&(0..n).map(corner).collect::<Vec<_>>(), true)
}

/// The areas of the points of the star polygon {n/k} with winding numbers of at least 1 to k.
///
/// Its sides are at the distance d = cos(πk/n) from the centre and intersect at the distances ρₘ = d / cos(πm/n); the
/// points with winding numbers of at least w form a star with 2n corners at ρₘ and ρₘ₋₁, where m = k − w + 1.
fn areas_of_star(n: usize, k: usize) -> Vec<f64> {
    let step = PI / real(n);
    let rho = |m: usize| (step * real(k)).cos() / (step * real(m)).cos();
    (1..=k)
        .map(|w| real(n) * rho(k - w + 1) * rho(k - w) * step.sin())
        .collect()
}

#[test]
fn stars() {
    for (n, k) in [(101, 42), (101, 43), (301, 143), (1001, 100), (1001, 500)] {
        let (path, areas) = (star(n, k), areas_of_star(n, k));
        let outline = valid(path.remove_overlaps(FillRule::NonZero));
        assert_eq!(outline.segment_count(), 2 * n, "{{{n}/{k}}}");
        assert!((outline.area() - areas[0]).abs() < 1e-10, "{{{n}/{k}}}");
        let odd = valid(path.remove_overlaps(FillRule::EvenOdd));
        // Two segments of contours for each of the n(k − 1) crossings, and one more for each side.
        assert_eq!(odd.segment_count(), n + 2 * n * (k - 1), "{{{n}/{k}}}");
        let signs = [1.0, -1.0].iter().cycle();
        let expected: f64 = areas
            .iter()
            .zip(signs)
            .map(|(area, sign)| area * sign)
            .sum();
        assert!((odd.area() - expected).abs() < 1e-10, "{{{n}/{k}}}");
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
    (0..n)
        .map(|i| (i + 1..n).filter(|&j| crosses(i, j)).count())
        .sum()
}

/// Compares the winding numbers of a result with those of its input at random points farther than 10⁻⁷ from it.
fn check_windings(input: &Path, result: &Path, rule: FillRule, count: usize) {
    let (outline, region, mut random) = (Outline::new(input), Outline::new(result), Random::new(5));
    let bounds = input.bounds().expect("a box");
    for _ in 0..count {
        let part = DVec2::new(random.between(0.0, 1.0), random.between(0.0, 1.0));
        let p = bounds.min + (bounds.max - bounds.min) * part;
        let expected = i32::from(is_inside(outline.winding(p), rule));
        assert_eq!(region.winding(p), expected, "at {p}");
    }
}

#[test]
fn random_polygons() {
    // The largest has about 490,000 crossings.
    for count in [240, 600, 2000] {
        let points = random_points(&mut Random::new(1), count);
        let path = polyline(&points, true);
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
    for count in if deep() {
        &[80, 300, 1000][..]
    } else {
        &[80, 300]
    } {
        let mut random = Random::new(2);
        let mut builder = PathBuilder::new();
        for _ in 0..*count {
            let p = random_points(&mut random, 4);
            builder.move_to(p[0]);
            builder.cubic_to(p[1], p[2], p[3]);
        }
        let path = builder.build().expect("finite points");
        for rule in RULES {
            let region = valid(path.remove_overlaps(rule));
            check_windings(&path, &region, rule, 40);
        }
    }
}

#[test]
fn more_than_a_million_contacts() {
    if !deep() {
        return;
    }
    let (n, k) = (1501, 700);
    let odd = valid(star(n, k).remove_overlaps(FillRule::EvenOdd));
    assert_eq!(odd.segment_count(), n + 2 * n * (k - 1));
    let signs = [1.0, -1.0].iter().cycle();
    let expected: f64 = areas_of_star(n, k)
        .iter()
        .zip(signs)
        .map(|(area, sign)| area * sign)
        .sum();
    assert!((odd.area() - expected).abs() < 1e-9);
}

#[test]
fn the_stroke_of_a_scribble() {
    let count = if deep() { 5000 } else { 1500 };
    let mut random = Random::new(3);
    let mut points = vec![DVec2::splat(50.0)];
    while points.len() < count {
        let to = points[points.len() - 1] + random.point(15.0);
        points.push(to.clamp(DVec2::ZERO, DVec2::splat(100.0)));
    }
    let (path, options) = (polyline(&points, false), StrokeOptions::default());
    let stroke = valid(path.stroke(0.5, &options));
    let region = Outline::new(&stroke);
    let distance = |p: DVec2| {
        let sides = points.windows(2).map(|side| {
            let along = side[1] - side[0];
            let t = (p - side[0]).dot(along) / along.length_squared().max(1e-300);
            p.distance(side[0] + along * t.clamp(0.0, 1.0))
        });
        sides.fold(f64::INFINITY, f64::min)
    };
    let mut inside = 0;
    for p in random_points(&mut random, 400) {
        // Miters reach farther than half the width, up to four times.
        let (winding, distance) = (region.winding(p), distance(p));
        if distance < 0.2499 {
            let caps = [points[0], points[points.len() - 1]];
            let in_cap = caps.iter().any(|end| end.distance(p) < 0.26);
            assert!(winding == 1 || in_cap, "{p} is not inside");
            inside += 1;
        } else if distance > 1.001 {
            assert_eq!(winding, 0, "{p} is inside");
        }
        assert!(
            winding == 0 || winding == 1,
            "{p}: winding number {winding}"
        );
    }
    assert!(inside > 50, "{inside} points inside");
}

#[test]
fn the_stroke_of_many_cubics() {
    let mut random = Random::new(4);
    let mut builder = PathBuilder::new();
    for _ in 0..100 {
        let p = random_points(&mut random, 4);
        builder.move_to(p[0]);
        builder.cubic_to(p[1], p[2], p[3]);
    }
    let path = builder.build().expect("finite points");
    let stroke = valid(path.stroke(1.0, &StrokeOptions::default()));
    let (region, options) = (Outline::new(&stroke), StrokeOptions::default());
    for p in random_points(&mut random, 300) {
        // Points next to the boundary of the stroke are decided by its tolerance.
        let near = [0.98, 1.02].map(|width| valid_contains(&path, p, width, &options));
        if near[0] == near[1] {
            assert_eq!(region.winding(p), i32::from(near[0]), "{p}");
        }
    }
}

fn valid_contains(path: &Path, p: DVec2, width: f64, options: &StrokeOptions) -> bool {
    path.stroke_contains(p, width, options)
        .expect("good arguments")
}

fn circles(count: usize) -> (Vec<Path>, Vec<(DVec2, f64)>) {
    let mut random = Random::new(6);
    let disks: Vec<(DVec2, f64)> = random_points(&mut random, count)
        .into_iter()
        .map(|center| (center, random.between(1.0, 2.5)))
        .collect();
    let path = |&(center, r): &(DVec2, f64)| {
        let DVec2 { x, y } = center - DVec2::new(r, 0.0);
        format!(
            "M{x} {y}a{r} {r} 0 0 1 {} 0a{r} {r} 0 0 1 {} 0z",
            2.0 * r,
            -2.0 * r
        )
        .parse()
        .expect("path data")
    };
    (disks.iter().map(path).collect(), disks)
}

#[test]
fn unions_of_overlapping_circles() {
    let (paths, disks) = circles(2000);
    let union = valid(Path::combine(
        &paths,
        BooleanOperation::Union,
        FillRule::NonZero,
    ));
    let pairwise = paths.iter().fold(Path::default(), |all, path| {
        valid(all.union(path, FillRule::NonZero))
    });
    let areas = [union.area(), pairwise.area()];
    assert!((areas[0] - areas[1]).abs() < 1e-6 * areas[0], "{areas:?}");
    assert_eq!(union.subpath_count(), pairwise.subpath_count());
    let (region, mut random, mut inside) = (Outline::new(&union), Random::new(7), 0);
    for p in random_points(&mut random, 2000) {
        let depth = disks
            .iter()
            .map(|(center, radius)| radius - center.distance(p))
            .fold(f64::NEG_INFINITY, f64::max);
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
        builder.move_to(p);
        [q, -p, -q].into_iter().for_each(|p| builder.line_to(p));
        builder.close();
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
        polyline(&[a, b, b + wide, a + wide], true)
    };
    let paths: Vec<Path> = (0..count).map(lines).collect();
    let union = valid(Path::combine(
        &paths,
        BooleanOperation::Union,
        FillRule::NonZero,
    ));
    assert_eq!(union.subpath_count(), count);
    assert!((union.area() - 4.0 * real(count)).abs() < 1e-6);
}
