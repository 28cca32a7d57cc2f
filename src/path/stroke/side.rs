//! The boundary of one side of a section of a stroke.
//!
//! Where it runs forward it is the envelope of the discs: an offset curve if the radius is constant. Where it runs
//! backwards, the chord between both sides turns about a point of itself, its pivot (the evolute if the radius is
//! constant), and what the part of the chord beyond the pivot sweeps counts as −1. There the boundary may be any line
//! between the pivots and the side: the winding number of points beyond it is then 0 instead of −1, and that of the other
//! points of the region is larger by at least 1. A few lines midway are shorter than the side, and stay away from the other
//! boundaries, whose errors could otherwise leave slivers uncovered.
//!
//! Around a point take f, the distance from the centre of a disc less its radius, as a function of t: the sides count the
//! minima of f up to 0 as +1 and its maxima as −1. In an interval with f below 0, minima and maxima alternate, so the count
//! is 1 if the interval ends inside the path. It can be 0 or −1 only if the interval ends at an end or corner and the point
//! lies ahead of that end. A round or square cap, a round join and a miter count such points once more; a butt cap and a
//! bevel do not, so what is swept backwards near them is added: the folds. On a closed subpath the count is 0 also where
//! f is nowhere above 0. With different widths on both sides, some minima or maxima belong to normals that are too short,
//! so all folds are added.

use super::section::{Disc, RIGHT, SectionEvaluator, SideInterval, speed_index};
use super::side_fit::SideFit;
use crate::curve::Curve;
use crate::geometry::error::Error;
use crate::geometry::point::Point;
use crate::numeric::float::as_f64;
use crate::spline::spline_builder::SplineBuilder;
use glam::DVec2;

/// Maximum depth of halvings of lines midway. Where rounding keeps a line from running between its chords, the number of lines
/// doubles with each halving: the tests of strokes reach this depth 16 times, and 16 halvings would make 3766 such lines.
const MAX_MIDWAY_HALVINGS: usize = 8;

/// The parts of an interval at whose ends its chords are compared with a line midway.
const MIDWAY_PARTS: usize = 8;

/// The parts of an interval that runs backwards at whose ends its chords are compared with blunt ends.
const FOLD_PARTS: usize = 16;

/// With more blunt ends than this, folds are added without comparison.
const MAX_COMPARED_ENDS: usize = 64;

/// Maximum depth of halvings of the curve of pivots. The error of an interpolating cubic falls to 1/16 with each: half of this
/// depth is too small for 12 folds in the tests of variable strokes, twice as much changes nothing there.
const MAX_PIVOT_HALVINGS: usize = 12;

/// A curve of pivots with more segments is not divided further: its chords are rounding errors, and the union refuses so
/// many.
const MAX_FOLD_SEGMENTS: usize = 1 << 10;

/// One side of a section.
pub(super) struct Side<'a> {
    pub(super) evaluator: &'a SectionEvaluator<'a>,
    pub(super) side: f64,
    pub(super) tolerance: f64,
}

impl Side<'_> {
    /// Appends an interval that runs forward, or all of it backwards if the sign is −1, to a chain that ends at its start.
    /// The section is not straight.
    pub(super) fn add(
        &self,
        interval: &SideInterval,
        sign: f64,
        chain: &mut SplineBuilder,
    ) -> Result<(), Error> {
        let section = self.evaluator.section;
        if section.radius.is_constant() {
            let distance = self.side * interval.ends[0].radius_of(self.side);
            if distance == 0.0 {
                chain.points.extend(&section.curve.control_points()[1..]);
                chain.degrees.push(section.curve.degree());
                return Ok(());
            }
            if interval.span == [0.0, 1.0] {
                return chain.add_smooth_offset(&section.curve, distance, self.tolerance);
            }
            let part = section.curve.part(interval.span[0], interval.span[1]);
            if !part.has_size() || part.straight_direction().is_some() {
                chain.connect_to(interval.ends[1].point(self.side));
                return Ok(());
            }
            return chain.add_smooth_offset(&part, distance, self.tolerance);
        }
        let fit = SideFit {
            evaluator: self.evaluator,
            side: self.side,
            tolerance: self.tolerance,
            sign,
        };
        fit.add(interval, chain)
    }

    /// The pivot of the chord at t, and its end on this side.
    fn chord(&self, t: f64) -> [DVec2; 2] {
        let (disc, side_speeds) = self.evaluator.evaluate(t);
        let [own, other] = [self.side, -self.side].map(|side| disc.point(side));
        let [ahead, beyond] = [self.side, -self.side].map(|side| side_speeds[speed_index(side)]);
        let part = if beyond <= 0.0 {
            1.0 // the whole chord moves backwards
        } else {
            // The speed across the chord changes linearly from this side to the other one; at the pivot it is 0.
            let part = ahead / (ahead - beyond);
            // At a cusp the curvature is infinite, and the pivot is on the curve.
            if part.is_nan() {
                disc.radius_of(self.side) / (disc.radii[0] + disc.radii[1])
            } else {
                part.clamp(0.0, 1.0)
            }
        };
        [own + (other - own) * part, own]
    }

    /// The point midway between the pivot and the side.
    fn midway(&self, t: f64) -> DVec2 {
        let [pivot, own] = self.chord(t);
        (pivot + own) * 0.5
    }

    /// Appends lines along an interval that runs backwards; the chain may be empty.
    pub(super) fn add_midway(&self, interval: &SideInterval, chain: &mut SplineBuilder) {
        let points = interval.ends.map(|disc| disc.point(self.side));
        chain.start(points[0]);
        // At an end of the section the lines begin or end between the pivot and the side, elsewhere on the side.
        let ends = [0, 1].map(|k| {
            let t = interval.span[k];
            if t == 0.0 || t == 1.0 {
                self.midway(t)
            } else {
                points[k]
            }
        });
        // In the middle of a section the chain already ends at this point, up to rounding.
        if interval.span[0] == 0.0 {
            chain.connect_to(ends[0]);
        }
        self.add_midway_lines(interval.span, ends, MAX_MIDWAY_HALVINGS, chain);
        chain.connect_to(points[1]);
    }

    fn add_midway_lines(
        &self,
        [from, to]: [f64; 2],
        ends: [DVec2; 2],
        halvings: usize,
        chain: &mut SplineBuilder,
    ) {
        let is_between = |k: usize| {
            let [pivot, own] = self.chord(from + (to - from) * (as_f64(k) / as_f64(MIDWAY_PARTS)));
            let side_of = |p: DVec2| (ends[1] - ends[0]).perp_dot(p - ends[0]);
            // The line runs between the pivot and the side.
            side_of(pivot) * side_of(own) <= 0.0
        };
        if halvings == 0 || (1..MIDWAY_PARTS).all(is_between) {
            return chain.connect_to(ends[1]);
        }
        let middle = 0.5 * (from + to);
        let between = self.midway(middle);
        self.add_midway_lines([from, middle], [ends[0], between], halvings - 1, chain);
        self.add_midway_lines([middle, to], [between, ends[1]], halvings - 1, chain);
    }

    /// Whether a point of an interval that runs backwards may lie ahead of a blunt end, and within its disc.
    pub(super) fn is_near_blunt_end(&self, [from, to]: [f64; 2], blunt_ends: &[Disc]) -> bool {
        if blunt_ends.len() > MAX_COMPARED_ENDS {
            return true;
        }
        let at = |k: usize| self.chord(from + (to - from) * (as_f64(k) / as_f64(FOLD_PARTS)));
        let chords: Vec<[DVec2; 2]> = (0..=FOLD_PARTS).map(at).collect();
        let step = |pair: &[[DVec2; 2]]| {
            let moved = [0, 1].map(|k| Point::norm(pair[1][k] - pair[0][k]));
            moved[0].max(moved[1])
        };
        let slack = chords.windows(2).map(step).fold(0.0, f64::max);
        blunt_ends.iter().any(|disc| {
            let middle = disc.center - disc.tangent * (disc.slope * disc.radius());
            chords.iter().any(|&[a, b]| {
                let ahead = [a, b].map(|p| (p - middle).dot(disc.tangent));
                ahead[0].max(ahead[1]) > -slack
                    && distance_to_line(disc.center, a, b) <= disc.radius() + slack
            })
        })
    }

    /// The contour of what is swept backwards: the side forwards and the pivots backwards.
    pub(super) fn fold(&self, interval: &SideInterval) -> Result<SplineBuilder, Error> {
        let mut fold = SplineBuilder::default();
        let [a, b] = interval.span;
        let start = interval.ends[0].point(self.side);
        fold.start(start);
        self.add(interval, -1.0, &mut fold)?;
        let pivot = |t: f64| self.chord(t)[0];
        fold.connect_to(pivot(b));
        let thirds = [0.0, 1.0 / 3.0, 2.0 / 3.0, 1.0].map(|part| pivot(b + (a - b) * part));
        let tolerance = 0.5 * self.tolerance;
        push_interpolated(
            &pivot,
            [b, a],
            thirds,
            tolerance,
            MAX_PIVOT_HALVINGS,
            &mut fold,
        );
        fold.line_to(start);
        if self.side == RIGHT {
            fold.points.reverse();
            fold.degrees.reverse();
        }
        Ok(fold)
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
/// Both what is swept forwards and what is swept backwards cover the convex side of the pivots, so an error moves the
/// boundary of the stroke by no more than itself.
fn push_interpolated(
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
        push_interpolated(curve, interval, thirds, tolerance, halvings - 1, out);
    }
}
