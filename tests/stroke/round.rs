//! Strokes with round joins and caps: the points within half the width of the path.

use crate::stroke::cases::{curves, hard, size};
use crate::support::Rng;
use casteljau::Path;
use casteljau::glam::DVec2;
use casteljau::path::{Join, StrokeCap, StrokeOptions};

pub(crate) const WIDTHS: [f64; 5] = [0.02, 0.1, 0.5, 1.5, 4.0];

const POINTS: usize = 120;

fn round(tolerance: f64, simple: bool) -> StrokeOptions {
    StrokeOptions::new()
        .join(Join::Round)
        .cap(StrokeCap::Round)
        .tolerance(tolerance)
        .simple(simple)
}

/// Random points, most of them next to the outline.
pub(crate) fn samples(path: &Path, radius: f64, tolerance: f64, rng: &mut Rng) -> Vec<DVec2> {
    let bounds = path.control_bounds().expect("not empty");
    let (min, max) = (bounds.min - radius * 1.2, bounds.max + radius * 1.2);
    let count = path.subpath(0).expect("a subpath").segment_count() as f64;
    (0..POINTS)
        .map(|k| {
            if k % 3 == 0 {
                return min + (max - min) * DVec2::new(rng.unit(), rng.unit());
            }
            let t = rng.unit() * count;
            let spline = path.subpath(0).expect("a subpath");
            let far = radius + tolerance * rng.magnitude(0.0, 2.0) * rng.signed().signum();
            spline.eval(t) + DVec2::from_angle(rng.unit() * 6.3) * far
        })
        .collect()
}

/// Samples farther than the tolerance from the exact outline that a stroke gets wrong.
fn wrong(path: &Path, width: f64, options: &StrokeOptions, rng: &mut Rng) -> Vec<String> {
    let outline = path.stroke(width, options).expect("few segments");
    let tolerance = options.tolerance.expect("a tolerance");
    let scale = size(path).max(width);
    let clear = 1.001 * tolerance + 4e-9 * scale;
    let mut wrong = Vec::new();
    for p in samples(path, 0.5 * width, tolerance, rng) {
        let distance = path.nearest(p).unwrap().unwrap().distance;
        if (distance - 0.5 * width).abs() <= clear {
            continue;
        }
        let winding = outline.winding_number(p);
        let expected = distance < 0.5 * width;
        let is_simple = !options.simple || (0..=1).contains(&winding);
        if (winding != 0) != expected || !is_simple {
            wrong.push(format!(
                "at {p}: {winding}, distance {distance} with width {width}"
            ));
        }
    }
    wrong
}

fn sweep(simple: bool) {
    let mut rng = Rng(7);
    let mut faults = Vec::new();
    for (name, path) in curves() {
        for part in WIDTHS {
            for tolerance in [1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6] {
                let options = round(tolerance * size(&path), simple);
                let found = wrong(&path, part * size(&path), &options, &mut rng);
                if !found.is_empty() {
                    let (count, first) = (found.len(), &found[0]);
                    faults.push(format!(
                        "{name}, {part}, {tolerance:e}: {count} wrong, {first}"
                    ));
                }
            }
        }
    }
    assert!(faults.is_empty(), "{}\n{}", faults.len(), faults.join("\n"));
}

#[test]
fn overlapping_outlines_fill_the_points_within_half_the_width() {
    sweep(false);
}

#[test]
fn simple_outlines_contain_the_points_within_half_the_width() {
    sweep(true);
}

/// The number of segments of kurbo's stroke of all curves and widths, and that of ours, at a tolerance of 1e-3.
#[test]
fn fewer_segments_than_kurbo() {
    let (mut ours, mut theirs) = (0, 0);
    for (name, path) in hard() {
        let mut of_curve = (0, 0);
        for part in WIDTHS {
            let (width, tolerance) = (part * size(&path), 1e-3 * size(&path));
            let outline = path.stroke(width, &round(tolerance, false)).unwrap();
            let (kurbo, style) = (kurbo::BezPath::from(&path), kurbo::Stroke::new(width));
            let stroked = kurbo::stroke(kurbo, &style, &kurbo::StrokeOpts::default(), tolerance);
            of_curve.0 += outline.segment_count();
            of_curve.1 += stroked.segments().count();
        }
        println!("{name}: {of_curve:?}");
        ours += of_curve.0;
        theirs += of_curve.1;
    }
    println!("{ours} {theirs}");
    assert!(ours <= theirs, "{ours} segments, kurbo has {theirs}");
}
