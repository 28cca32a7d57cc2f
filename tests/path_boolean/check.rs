//! All checks of one pair of paths.

use crate::oracle::Outline;
use crate::random::Random;
use casteljau::Path;
use casteljau::glam::DVec2;
use casteljau::path::FillRule;

/// The number of random points, half of them next to the outlines.
const POINTS: usize = 160;

/// The region operations, and whether a point inside (a, b) is in the result.
type Operation = (
    &'static str,
    fn(&Path, &Path, FillRule) -> Path,
    fn(bool, bool) -> bool,
);

pub(crate) const OPERATIONS: [Operation; 4] = [
    (
        "union",
        |a, b, rule| a.union(b, rule).expect("few segments"),
        |a, b| a || b,
    ),
    (
        "intersect",
        |a, b, rule| a.intersect(b, rule).expect("few segments"),
        |a, b| a && b,
    ),
    (
        "subtract",
        |a, b, rule| a.subtract(b, rule).expect("few segments"),
        |a, b| a && !b,
    ),
    (
        "exclude",
        |a, b, rule| a.exclude(b, rule).expect("few segments"),
        |a, b| a != b,
    ),
];

/// What is wrong with the results of a pair.
pub(crate) fn faults(a: &Path, b: &Path, rule: FillRule, random: &mut Random) -> Vec<String> {
    let results = OPERATIONS.map(|(_, operation, _)| operation(a, b, rule));
    let (own, other) = (Outline::new(a), Outline::new(b));
    let outlines = results.each_ref().map(Outline::new);
    let mut faults = Vec::new();
    for p in sample_points(&own, &other, random) {
        let [inside_a, inside_b] = [&own, &other].map(|outline| inside(outline.winding(p), rule));
        for (k, outline) in outlines.iter().enumerate() {
            let (name, _, expected) = OPERATIONS[k];
            let expected = i32::from(expected(inside_a, inside_b));
            let got = outline.winding(p);
            if got != expected && outline.distance(p) > 2.0 * outline.error {
                faults.push(format!("{name}: at {p} expected {expected}, got {got}"));
            }
        }
    }
    faults
}

fn inside(winding: i32, rule: FillRule) -> bool {
    match rule {
        FillRule::NonZero => winding != 0,
        FillRule::EvenOdd => winding % 2 != 0,
    }
}

/// Random points farther from both outlines than the error of their polylines and the ε of the operations.
fn sample_points(a: &Outline, b: &Outline, random: &mut Random) -> Vec<DVec2> {
    let vertices = [a.vertices(), b.vertices()].concat();
    let (mut min, mut max) = (vertices[0], vertices[0]);
    for &p in &vertices {
        (min, max) = (min.min(p), max.max(p));
    }
    let size = (max - min).max_element();
    let clear = 2.0 * (a.error + b.error) + 4e-9 * size;
    (0..POINTS)
        .map(|k| {
            if k % 2 == 0 {
                min + (max - min) * DVec2::new(random.unit(), random.unit())
            } else {
                let near = vertices[random.below(vertices.len())];
                let far = size * 10.0_f64.powf(random.between(-8.0, -1.0));
                near + DVec2::from_angle(random.between(0.0, 6.3)) * far
            }
        })
        .filter(|&p| a.distance(p).min(b.distance(p)) > clear)
        .collect()
}

/// The largest error of the identities of areas, relative to the square of the size.
pub(crate) fn identity_error(a: &Path, b: &Path, rule: FillRule) -> f64 {
    let [union, intersection, difference, exclusion] =
        OPERATIONS.map(|(_, operation, _)| operation(a, b, rule).area());
    let [of_a, of_b] = [a, b].map(|path| path.remove_overlaps(rule).expect("few segments").area());
    let bounds = a
        .bounds()
        .expect("not empty")
        .union(b.bounds().expect("not empty"));
    let size = (bounds.max - bounds.min).max_element();
    let errors = [
        union + intersection - of_a - of_b,
        exclusion - (union - intersection),
        difference - (of_a - intersection),
    ];
    errors
        .into_iter()
        .fold(0.0, |m: f64, error| m.max(error.abs()))
        / (size * size)
}
