//! The fewest stops of a CSS `linear()` within a tolerance of a timing function.
//!
//! `js/geometry/easing-stops.ts` performs the same operations in the same order.

use super::piecewise::{Linear, Stop};
use super::polyline::approximate;

/// The part of the tolerance that is reserved for the distance between the function and its polyline.
const POLYLINE_SHARE: f64 = 1.0 / 64.0;
/// The largest number of halvings of the parameter range: the distance from a chord falls by 4 with each, to 2⁻⁴⁰.
const MAX_DEPTH: usize = 20;
/// The largest number of decimal places to which percentages are rounded; outputs have two more.
const MAX_DECIMALS: usize = 12;
/// Larger numbers have no decimal places (2⁵²).
const WHOLE_FROM: f64 = 1.0 / f64::EPSILON;

/// The fewest stops of a `linear()` within a tolerance, which is at least 10⁻⁴ of `scale`.
pub(crate) fn fewest_stops([x1, y1, x2, y2]: [f64; 4], tolerance: f64, scale: f64) -> Vec<Stop> {
    // Outputs are divided by their scale, so that no difference overflows.
    let relative = tolerance / scale;
    let share = relative * POLYLINE_SHARE;
    let mut run = vec![[0.0, 0.0]];
    let x = [0.0, 100.0 * x1, 100.0 * x2, 100.0];
    let y = [0.0, y1 / scale, y2 / scale, 1.0 / scale];
    subdivide(x, y, MAX_DEPTH, share, &mut run);
    // The run is within one share of the curve; at least another one is left for rounding.
    let stops = approximate(&run, relative - 2.0 * share);
    rounded(run, &stops, relative - share, scale)
}

/// The stops of a `linear()` with as few as the tolerance permits between one jump and the next.
pub(crate) fn reduced_stops(stops: &[Stop], tolerance: f64, scale: f64) -> Vec<Stop> {
    stops
        .chunk_by(|a, b| b[0] > a[0])
        .flat_map(|run| reduced(run, tolerance / scale, scale))
        .collect()
}

/// A run with as few stops as the tolerance permits; its ends stay.
fn reduced(run: &[Stop], relative: f64, scale: f64) -> Vec<Stop> {
    if run.len() < 3 {
        return run.to_vec();
    }
    let in_unit = |stops: &[Stop]| {
        let stops = stops.iter().map(|[x, y]| [*x, y / scale]).collect();
        Linear { stops }
    };
    let given = in_unit(run);
    let share = relative * POLYLINE_SHARE;
    let stops = approximate(&given.stops, relative - share);
    let mut result = rounded(given.stops.clone(), &stops, relative, scale);
    let last = result.len() - 1;
    (result[0], result[last]) = (run[0], run[run.len() - 1]);
    let candidate = in_unit(&result);
    // The ends were set after `rounded` compared the functions.
    let is_close = is_within(&given.stops, &candidate, relative)
        && is_within(&candidate.stops, &given, relative);
    if is_close && result.len() < run.len() {
        result
    } else {
        run.to_vec()
    }
}

/// Appends the vertices of a polyline along a cubic curve, except for its start. The control values x ascend in t.
///
/// The vertical distance of the curve from its chord is a cubic polynomial whose inner Bernstein coefficients are the
/// distances of the handles; their weights add up to at most 3/4.
fn subdivide(x: [f64; 4], y: [f64; 4], depth: usize, tolerance: f64, run: &mut Vec<Stop>) {
    let slope = (y[3] - y[0]) / (x[3] - x[0]);
    let is_close = |k: usize| 0.75 * (y[k] - y[0] - slope * (x[k] - x[0])).abs() <= tolerance;
    if depth == 0 || (is_close(1) && is_close(2)) {
        run.push([x[3], y[3]]);
        return;
    }
    let ([x_left, x_right], [y_left, y_right]) = (halves(x), halves(y));
    subdivide(x_left, y_left, depth - 1, tolerance, run);
    subdivide(x_right, y_right, depth - 1, tolerance, run);
}

/// The control values of both halves.
fn halves([a, b, c, d]: [f64; 4]) -> [[f64; 4]; 2] {
    let [ab, bc, cd] = [(a + b) / 2.0, (b + c) / 2.0, (c + d) / 2.0];
    let [abc, bcd] = [(ab + bc) / 2.0, (bc + cd) / 2.0];
    let middle = (abc + bcd) / 2.0;
    [[a, ab, abc, middle], [middle, bcd, cd, d]]
}

/// The stops with outputs multiplied by `scale`, with as few decimal places as the tolerance permits.
fn rounded(run: Vec<Stop>, stops: &[Stop], tolerance: f64, scale: f64) -> Vec<Stop> {
    let run = Linear { stops: run };
    let mut unit = 1.0;
    for _ in 0..=MAX_DECIMALS {
        let rounded = stops
            .iter()
            .map(|[x, y]| [round(*x, unit), round(y * scale, 100.0 * unit)]);
        let rounded: Vec<Stop> = rounded.collect();
        let relative = rounded.iter().map(|[x, y]| [*x, y / scale]).collect();
        let candidate = Linear { stops: relative };
        // Both functions are linear between vertices and stops, so the distance is greatest at one of these.
        if is_within(&run.stops, &candidate, tolerance)
            && is_within(&candidate.stops, &run, tolerance)
        {
            return rounded;
        }
        unit *= 10.0;
    }
    let mut unrounded: Vec<Stop> = stops.iter().map(|[x, y]| [*x, y * scale]).collect();
    if let Some(last) = unrounded.last_mut() {
        *last = [100.0, 1.0];
    }
    unrounded
}

fn round(value: f64, unit: f64) -> f64 {
    let scaled = value * unit;
    if scaled.abs() < WHOLE_FROM {
        (scaled + 0.5).floor() / unit + 0.0 // turns −0 into 0
    } else {
        value
    }
}

fn is_within(stops: &[Stop], function: &Linear, tolerance: f64) -> bool {
    let mut stops = stops.iter();
    stops.all(|[x, y]| (function.eval(x / 100.0) - y).abs() <= tolerance)
}
