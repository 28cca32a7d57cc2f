//! The parts that the normal sweeps backwards.
//!
//! Where the curvature κ exceeds 1/r, the points of the normal beyond the evolute B + N/κ move backwards, and the
//! outline counts their region as −1. Around a point take the distance to the path as a function of t: the outline
//! counts its minima up to r as +1 and its maxima as −1. In an interval where the distance is below r, minima and
//! maxima alternate, so the count is 1 if the interval ends inside the path. It can be 0 or −1 only if the interval ends
//! at an end or corner and the point lies ahead of that end. A round or square cap, a round join and a miter count such
//! points once more; a butt cap and a bevel do not, so what is swept backwards near them is added here. On a closed
//! subpath the count is 0 also where no distance exceeds r.

use super::contours::push_disk;
use super::options::Pen;
use super::outline::{Outline, push_closed};
use crate::bernstein::product::product_of;
use crate::bernstein::roots::roots_inside;
use crate::curve::Curve;
use crate::curve::with_derivatives::CurveWithDerivatives;
use crate::geometry::error::Error;
use crate::geometry::point::Point;
use crate::numeric::float::unit_scale;
use crate::numeric::list::{Points, Scalars};
use crate::numeric::sort::sort_by;
use crate::numeric::zero::regula_falsi;
use crate::path::Path;
use crate::spline::spline_builder::SplineBuilder;
use glam::DVec2;

/// The parameters at which the sign of 1 − κd is evaluated, for each degree.
const SAMPLES_PER_DEGREE: usize = 16;

/// A root is accurate enough when the width of its interval is this part of it.
const ROOT_WIDTH: f64 = 1e-13;

/// The normals of a fold that are compared with blunt ends.
const COMPARED: usize = 16;

/// With more blunt ends than this, folds are added without comparison.
const MAX_COMPARED_ENDS: usize = 64;

/// Maximum depth of halvings of an evolute.
const MAX_HALVINGS: usize = 12;

/// An evolute of more segments is not divided further: its normals are rounding errors, and the union refuses so many.
const MAX_FOLD_SEGMENTS: usize = 1 << 10;

/// Appends the parts that are swept backwards and may lie ahead of a blunt end, as contours of the winding number 1.
pub(super) fn push_folds(
    path: &mut Path,
    curves: &[Curve<DVec2>],
    outline: &Outline,
    pen: &Pen,
) -> Result<(), Error> {
    let surrounds = outline.closed && is_within(curves, pen.radius);
    if outline.blunt_ends.is_empty() {
        if surrounds {
            // What is within the radius of all points of the path is within it of the first one.
            push_disk(path, curves[0].start(), pen);
        }
        return Ok(());
    }
    for curve in curves.iter().filter(|curve| curve.degree() > 1) {
        for distance in [pen.radius, -pen.radius] {
            let side = Side::new(curve, distance);
            for run in side.backward_runs() {
                if surrounds || side.is_near(run, &outline.blunt_ends) {
                    side.push_fold(run, pen, path)?;
                }
            }
        }
    }
    Ok(())
}

/// Whether a disk of the radius may contain all curves.
fn is_within(curves: &[Curve<DVec2>], radius: f64) -> bool {
    let boxes = curves.iter().map(Curve::control_bounds);
    let whole = boxes.reduce(|a, b| a.union(b));
    whole.is_none_or(|whole| (whole.max * 0.5 - whole.min * 0.5).max_element() <= radius)
}

/// One side of a curve.
struct Side<'a> {
    curve: &'a Curve<DVec2>,
    distance: f64,
    /// The control points relative to the start, scaled to a size of about 1.
    points: Points<DVec2>,
    scale: f64,
}

impl<'a> Side<'a> {
    fn new(curve: &'a Curve<DVec2>, distance: f64) -> Self {
        let start = curve.start();
        let relative = curve.control_points().iter().map(|&p| p - start);
        let size = relative.clone().fold(0.0, |m: f64, p| m.max(p.max_abs()));
        let scale = unit_scale(size);
        Self {
            curve,
            distance,
            points: relative.map(|p| p * scale).collect(),
            scale,
        }
    }

    /// |B′|³ and d (B′ × B″) of the scaled curve.
    fn terms(&self, with: &CurveWithDerivatives<DVec2>, t: f64) -> [f64; 2] {
        let [first, second] = with.derivatives(t);
        let speed = Point::length(first);
        let bend = self.distance * self.scale * first.perp_dot(second);
        [speed * speed * speed, bend]
    }

    /// The intervals of t with κd > 1, divided at the cusps of the curve.
    fn backward_runs(&self) -> Vec<[f64; 2]> {
        let mut breaks = vec![0.0];
        breaks.extend(self.curve.cusps());
        breaks.push(1.0);
        let slowest = self.slowest();
        let mut runs = Vec::new();
        for ends in breaks.windows(2) {
            let [from, to] = [ends[0], ends[1]];
            let count = SAMPLES_PER_DEGREE * self.curve.degree();
            let even = (0..count).map(|k| from + (to - from) * ((k as f64 + 0.5) / count as f64));
            let inside = slowest.iter().copied().filter(|&t| from < t && t < to);
            let mut ts: Vec<f64> = even.chain(inside).collect();
            sort_by(&mut ts, f64::total_cmp);
            self.push_runs([from, to], &ts, &mut runs);
        }
        runs.retain(|run| run[0] < run[1]);
        runs
    }

    /// The parameters at which the speed is smallest or largest; a tight turn is next to a smallest one.
    fn slowest(&self) -> Scalars {
        let steps = |points: &[DVec2]| -> Points<DVec2> {
            points.windows(2).map(|pair| pair[1] - pair[0]).collect()
        };
        let first = steps(&self.points);
        let second = steps(&first);
        let n = first.len() - 1;
        roots_inside(&product_of(n, n - 1, |i, j| first[i].dot(second[j])))
    }

    /// Appends the intervals with κd > 1 between two parameters, found by the signs at given ones.
    fn push_runs(&self, [from, to]: [f64; 2], ts: &[f64], runs: &mut Vec<[f64; 2]>) {
        let with = CurveWithDerivatives::new(&self.points);
        let forward = |t: f64| {
            let [cube, bend] = self.terms(&with, t);
            cube - bend
        };
        let mut start = None;
        let mut last = (from, 0.0);
        for &t in ts {
            let value = forward(t);
            let zero = || {
                let sign = if last.1 < 0.0 { -1.0 } else { 1.0 };
                let bracket = [sign * last.1, sign * value];
                regula_falsi([last.0, t], bracket, ROOT_WIDTH, |t| sign * forward(t))
            };
            match start {
                None if value < 0.0 => start = Some(if last.0 == from { from } else { zero() }),
                Some(start_of_run) if value >= 0.0 => {
                    runs.push([start_of_run, zero()]);
                    start = None;
                }
                _ => {}
            }
            last = (t, value);
        }
        runs.extend(start.map(|start| [start, to]));
    }

    /// The points of the evolute and of the offset curve at t.
    fn ends_at(&self, with: &CurveWithDerivatives<DVec2>, t: f64) -> [DVec2; 2] {
        let [cube, bend] = self.terms(with, t);
        let normal = Point::normalize_or_zero(with.derivatives(t)[0]).perp();
        let point = self.curve.eval(t);
        // ρ/d, which is from 0 to 1 in an interval with κd > 1.
        let part = if bend > cube {
            (cube / bend).max(0.0)
        } else {
            1.0
        };
        [part, 1.0].map(|part| point + normal * (self.distance * part))
    }

    /// Whether a point that is swept backwards may lie ahead of a blunt end, and within the distance of it.
    fn is_near(&self, [from, to]: [f64; 2], blunt_ends: &[(DVec2, DVec2)]) -> bool {
        if blunt_ends.len() > MAX_COMPARED_ENDS {
            return true;
        }
        let with = CurveWithDerivatives::new(&self.points);
        let at = |k: usize| {
            let t = from + (to - from) * (k as f64 / COMPARED as f64);
            self.ends_at(&with, t)
        };
        let normals: Vec<[DVec2; 2]> = (0..=COMPARED).map(at).collect();
        let step = |pair: &[[DVec2; 2]]| {
            let moved = [0, 1].map(|k| Point::length(pair[1][k] - pair[0][k]));
            moved[0].max(moved[1])
        };
        let slack = normals.windows(2).map(step).fold(0.0, f64::max);
        blunt_ends.iter().any(|&(end, tangent)| {
            normals.iter().any(|&[a, b]| {
                let ahead = (a - end).dot(tangent).max((b - end).dot(tangent));
                ahead > -slack && distance_to_line(end, a, b) <= self.distance.abs() + slack
            })
        })
    }

    /// Appends the contour of what is swept backwards: the offset curve forwards and the evolute backwards.
    fn push_fold(&self, run: [f64; 2], pen: &Pen, path: &mut Path) -> Result<(), Error> {
        let piece = self.curve.subsegment(run[0], run[1]);
        if piece.control_points().iter().all(|&p| p == piece.start()) {
            return Ok(());
        }
        let mut contour = SplineBuilder::default();
        contour.add_offset(&piece, self.distance, pen.tolerance)?;
        let with = CurveWithDerivatives::new(&self.points);
        let start = contour.points[0];
        let evolute = |t: f64| self.ends_at(&with, t)[0];
        let [from, to] = [run[1], run[0]];
        contour.line_to(evolute(from));
        let thirds =
            [0.0, 1.0 / 3.0, 2.0 / 3.0, 1.0].map(|part| evolute(from + (to - from) * part));
        push_evolute(
            &evolute,
            [from, to],
            thirds,
            0.5 * pen.tolerance,
            MAX_HALVINGS,
            &mut contour,
        );
        contour.line_to(start);
        if self.distance < 0.0 {
            contour.points.reverse();
            contour.degrees.reverse();
        }
        push_closed(path, contour);
        Ok(())
    }
}

/// The distance of a point from a line segment.
fn distance_to_line(p: DVec2, a: DVec2, b: DVec2) -> f64 {
    let chord = b - a;
    let t = (p - a).dot(chord) / chord.dot(chord);
    let nearest = if t > 0.0 { a + chord * t.min(1.0) } else { a };
    Point::length(p - nearest)
}

/// Appends cubics that interpolate a curve; `thirds` are its points at the ends and at the thirds of the interval.
///
/// Both what is swept forwards and what is swept backwards cover the convex side of the evolute, so an error moves the
/// boundary of the stroke by no more than itself.
fn push_evolute(
    curve: &impl Fn(f64) -> DVec2,
    [from, to]: [f64; 2],
    [a, p, q, d]: [DVec2; 4],
    tolerance: f64,
    halvings: usize,
    out: &mut SplineBuilder,
) {
    let b = (p * 18.0 - a * 5.0 - q * 9.0 + d * 2.0) / 6.0;
    let c = (a * 2.0 - p * 9.0 + q * 18.0 - d * 5.0) / 6.0;
    let cubic = Curve::from_slice(&[a, b, c, d]);
    // Midway between the interpolated points; with these they are the thirds of both halves.
    let parts = [1.0 / 6.0, 0.5, 5.0 / 6.0];
    let midway = parts.map(|part| curve(from + (to - from) * part));
    let is_close = |k: usize| Point::length(cubic.eval(parts[k]) - midway[k]) <= tolerance;
    let is_last = halvings == 0 || out.degrees.len() >= MAX_FOLD_SEGMENTS;
    if is_last || (0..3).all(is_close) {
        out.points.extend([b, c, d]);
        out.degrees.push(3);
        return;
    }
    let middle = 0.5 * (from + to);
    let halves = [
        ([from, middle], [a, midway[0], p, midway[1]]),
        ([middle, to], [midway[1], q, midway[2], d]),
    ];
    for (interval, thirds) in halves {
        push_evolute(curve, interval, thirds, tolerance, halvings - 1, out);
    }
}
