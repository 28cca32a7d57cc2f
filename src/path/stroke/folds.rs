//! The parts that the normal sweeps backwards.
//!
//! Where the curvature κ exceeds 1/r, the points of the normal beyond the evolute B + N/κ move backwards, and the
//! offset curve counts their region as −1. The outline keeps only the part of it that is next to the evolute
//! ([`side_boundary`](super::side_boundary)); beyond it the count is larger by 1, so the following argument still applies.
//!
//! Around a point take the distance to the path as a function of t: the offset curves count its minima up to r as +1
//! and its maxima as −1. In an interval where the distance is below r, minima and maxima alternate, so the count is 1
//! if the interval ends inside the path. It can be 0 or −1 only if the interval ends at an end or corner and the point
//! lies ahead of that end. A round or square cap, a round join and a miter count such points once more; a butt cap and
//! a bevel do not, so what is swept backwards near them is added here. On a closed subpath the count is 0 also where no
//! distance exceeds r.

use super::contours::push_disk;
use super::options::Pen;
use super::outline::{Outline, push_closed};
use super::side::{Side, Turns};
use crate::curve::Curve;
use crate::curve::with_derivatives::CurveWithDerivatives;
use crate::geometry::error::Error;
use crate::geometry::point::Point;
use crate::path::Path;
use crate::spline::spline_builder::SplineBuilder;
use glam::DVec2;

/// The parameters at which the sign of 1 − κd is evaluated, for each degree.
const SAMPLES_PER_DEGREE: usize = 16;

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
        let turns = Turns::of(curve, SAMPLES_PER_DEGREE);
        for distance in [pen.radius, -pen.radius] {
            let side = Side::new(curve, distance);
            for run in side.backward_runs(&turns) {
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
    whole.is_none_or(|whole| (whole.max - whole.min).max_element() <= 2.0 * radius)
}

impl Side<'_> {
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
            let moved = [0, 1].map(|k| Point::norm(pair[1][k] - pair[0][k]));
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
        let piece = self.curve.part(run[0], run[1]);
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
    Point::norm(p - nearest)
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
    let is_close = |k: usize| Point::norm(cubic.eval(parts[k]) - midway[k]) <= tolerance;
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
