//! All checks of one pair of paths.

use crate::path_boolean::oracle::Outline;
use crate::support::Rng;
use crate::support::paths::RandomPlane;
pub(crate) use crate::support::paths::path;
use casteljau::Path;
use casteljau::glam::DVec2;
use casteljau::path::FillRule;

/// The number of random points, most of them next to the outlines.
const POINTS: usize = 160;

/// ε of the operations, relative to the size.
const EPSILON: f64 = 1e-9;

type Expected = fn(bool, bool) -> bool;
type Apply = fn(&Path, &Path, FillRule) -> Path;

/// The operations of two regions, and whether a point is in the result, from whether it is in both regions.
pub(crate) const OPERATIONS: [(&str, Apply, Expected); 4] = [
    ("union", |a, b, rule| valid(a.union(b, rule)), |a, b| a || b),
    (
        "intersect",
        |a, b, rule| valid(a.intersect(b, rule)),
        |a, b| a && b,
    ),
    (
        "subtract",
        |a, b, rule| valid(a.subtract(b, rule)),
        |a, b| a && !b,
    ),
    (
        "exclude",
        |a, b, rule| valid(a.exclude(b, rule)),
        |a, b| a != b,
    ),
];

pub(crate) fn valid(result: Result<Path, casteljau::Error>) -> Path {
    result.expect("few segments")
}

/// The larger side of the box around two paths.
pub(crate) fn size(a: &Path, b: &Path) -> f64 {
    let boxes = [a, b].into_iter().filter_map(|path| path.bounds());
    let all = boxes.reduce(|a, b| a.union(b));
    all.map_or(0.0, |all| (all.max - all.min).max_element())
}

/// What is wrong with the results of a pair: winding numbers at points that are farther from the outlines than ε,
/// areas, and the structure of the results.
pub(crate) fn faults(a: &Path, b: &Path, rule: FillRule, random: &mut Rng) -> Vec<String> {
    faults_beyond(EPSILON, a, b, rule, random)
}

/// [`faults`] with another ε.
pub(crate) fn faults_beyond(
    epsilon: f64,
    a: &Path,
    b: &Path,
    rule: FillRule,
    random: &mut Rng,
) -> Vec<String> {
    let results = OPERATIONS.map(|(_, apply, _)| apply(a, b, rule));
    let (own, other) = (Outline::new(a), Outline::new(b));
    let outlines = results.each_ref().map(Outline::new);
    let mut faults: Vec<String> = results.iter().filter_map(structure_fault).collect();
    for p in sample_points([&own, &other], size(a, b), epsilon, random) {
        let [inside_a, inside_b] = [&own, &other].map(|o| is_inside(o.winding(p), rule));
        for ((name, _, expected), outline) in OPERATIONS.iter().zip(&outlines) {
            let expected = i32::from(expected(inside_a, inside_b));
            let got = outline.winding(p);
            if got != expected {
                faults.push(format!("{name}: at {p} expected {expected}, got {got}"));
            }
        }
    }
    faults
}

pub(crate) fn is_inside(winding: i32, rule: FillRule) -> bool {
    match rule {
        FillRule::NonZero => winding != 0,
        FillRule::EvenOdd => winding % 2 != 0,
    }
}

/// Random points farther from both outlines than ε.
fn sample_points(outlines: [&Outline; 2], size: f64, epsilon: f64, random: &mut Rng) -> Vec<DVec2> {
    let samples = outlines.map(|outline| outline.samples(16)).concat();
    let centre = samples.iter().sum::<DVec2>() / samples.len() as f64;
    let mut point = |k: usize| {
        if k.is_multiple_of(4) {
            return centre + random.spot(size);
        }
        let far = size * random.magnitude(epsilon.log10() + 0.4, -1.0);
        random.pick(&samples) + random.direction() * far
    };
    let mut points: Vec<DVec2> = (0..POINTS).map(&mut point).collect();
    points.retain(|&p| {
        let clear = 2.0 * epsilon * size;
        !outlines.iter().any(|outline| outline.is_near(p, clear))
    });
    points
}

/// What is wrong with the contours of a result: all are closed; each that runs clockwise is a hole of the last one that
/// runs counter-clockwise, and no point comes twice in a contour.
fn structure_fault(result: &Path) -> Option<String> {
    let mut outer: Option<Outline> = None;
    for (k, spline) in result.subpaths().enumerate() {
        if !spline.is_closed() {
            return Some(format!("contour {k} is open"));
        }
        let starts = spline.segments().map(|curve| curve.start() + 0.0);
        let mut joints: Vec<_> = starts.map(|p| p.to_array().map(f64::to_bits)).collect();
        joints.sort_unstable();
        if joints.windows(2).any(|pair| pair[0] == pair[1]) {
            return Some(format!("contour {k} passes a point twice"));
        }
        let contour = Path::from(spline);
        if contour.area() > 0.0 {
            outer = Some(Outline::new(&contour));
            continue;
        }
        let Some(outer) = &outer else {
            return Some(format!("contour {k} is a hole of nothing"));
        };
        let points = Outline::new(&contour).samples(7);
        let inside = points.iter().filter(|&&p| outer.winding(p) == 1).count();
        if 4 * inside < points.len() {
            return Some(format!("contour {k} is not inside the one before"));
        }
    }
    None
}

/// The largest error of the identities of areas, relative to the square of the size.
pub(crate) fn identity_error(a: &Path, b: &Path, rule: FillRule) -> f64 {
    let [union, intersection, difference, exclusion] =
        OPERATIONS.map(|(_, apply, _)| apply(a, b, rule).area());
    let [of_a, of_b] = [a, b].map(|path| path.filled_area(rule).expect("few segments"));
    let size = size(a, b);
    let errors = [
        union + intersection - of_a - of_b,
        exclusion - (union - intersection),
        difference - (of_a - intersection),
    ];
    errors.map(f64::abs).into_iter().fold(0.0, f64::max) / (size * size)
}
