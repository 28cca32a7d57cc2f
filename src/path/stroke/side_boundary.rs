//! The boundary of one side of the stroke of a curve.
//!
//! It is the offset curve, except where that runs backwards. There the points of the normal beyond the evolute are
//! counted as −1 (see [`folds`](super::folds)), and the boundary may be any line between the evolute and the offset
//! curve: the winding number of points beyond it is then 0 instead of −1, and that of the other points of the region is
//! larger by at least 1. A few lines midway are shorter than the offset curve, and stay away from the other
//! boundaries, whose errors could otherwise leave slivers uncovered.

use super::side::{Side, Turns};
use crate::bernstein::product::product_of;
use crate::curve::Curve;
use crate::curve::with_derivatives::CurveWithDerivatives;
use crate::geometry::error::Error;
use crate::numeric::list::Points;
use crate::spline::spline_builder::SplineBuilder;
use glam::DVec2;

/// Maximum depth of halvings of an interval.
const MAX_HALVINGS: usize = 8;

/// An interval is extended by this part of itself, so that nothing beside it runs backwards because of rounding. The
/// offset curve moves there by the square of this.
const BESIDE: f64 = 1e-6;

/// The parts of an interval, at whose ends its normals are compared with a line.
const COMPARED: usize = 8;

/// The parameters at which the sign of 1 − κd is evaluated, for each degree. Where they miss an interval, the offset
/// curve is the boundary.
const SAMPLES_PER_DEGREE: usize = 8;

/// Appends the boundaries on the left and on the right, at the same distance.
pub(super) fn add_sides(
    [left, right]: [&mut SplineBuilder; 2],
    curve: &Curve<DVec2>,
    distance: f64,
    tolerance: f64,
) -> Result<(), Error> {
    let sides = [(left, distance), (right, -distance)];
    if bends_little(curve, distance) || curve.straight_direction().is_some() {
        return add_offsets(sides, curve, tolerance);
    }
    let turns = Turns::of(curve, SAMPLES_PER_DEGREE);
    if !turns.cusps.is_empty() {
        // The offset curves have half circles about these points.
        return add_offsets(sides, curve, tolerance);
    }
    for (builder, distance) in sides {
        let side = Side::new(curve, distance);
        let runs = side.backward_runs(&turns);
        add_side(builder, &side, &runs, tolerance)?;
    }
    Ok(())
}

fn add_offsets(
    sides: [(&mut SplineBuilder, f64); 2],
    curve: &Curve<DVec2>,
    tolerance: f64,
) -> Result<(), Error> {
    for (builder, distance) in sides {
        builder.add_offset(curve, distance, tolerance)?;
    }
    Ok(())
}

/// Appends the boundary of one side, from the offset of the start to that of the end; the offset runs backwards in the
/// given intervals.
fn add_side(
    builder: &mut SplineBuilder,
    side: &Side,
    runs: &[[f64; 2]],
    tolerance: f64,
) -> Result<(), Error> {
    let add = |from: f64, to: f64, builder: &mut SplineBuilder| {
        if [from, to] == [0.0, 1.0] {
            return builder.add_offset(side.curve, side.distance, tolerance);
        }
        builder.add_offset(&side.curve.part(from, to), side.distance, tolerance)
    };
    let midway = Midway {
        with: CurveWithDerivatives::new(&side.points),
        side,
    };
    let mut t = 0.0;
    for &[from, to] in runs {
        let beside = BESIDE * (to - from);
        let (from, to) = ((from - beside).max(t), (to + beside).min(1.0));
        if t < from {
            add(t, from, builder)?;
        } else {
            builder.start(midway.normal(from)[1]);
        }
        midway.add_lines([from, to], builder);
        t = to;
    }
    if t < 1.0 {
        return add(t, 1.0, builder);
    }
    builder.line_to(midway.normal(1.0)[1]);
    Ok(())
}

/// Whether |κd| ≤ 1 follows from the Bernstein coefficients of |B′|² and B′ × B″, which bound these polynomials.
fn bends_little(curve: &Curve<DVec2>, distance: f64) -> bool {
    let n = curve.degree();
    if n < 2 {
        return true;
    }
    let rates = |points: &[DVec2]| -> Points<DVec2> {
        let degree = (points.len() - 1) as f64;
        points
            .windows(2)
            .map(|pair| (pair[1] - pair[0]) * degree)
            .collect()
    };
    let first = rates(curve.control_points());
    let second = rates(&first);
    let squares = product_of(n - 1, n - 1, |i, j| first[i].dot(first[j]));
    let crosses = product_of(n - 1, n - 2, |i, j| first[i].perp_dot(second[j]));
    let slowest = squares.iter().copied().fold(f64::INFINITY, f64::min);
    let most = crosses.iter().fold(0.0, |m: f64, cross| m.max(cross.abs()));
    slowest > 0.0 && distance.abs() * most <= slowest * slowest.sqrt()
}

/// The lines midway between the evolute and the offset curve.
struct Midway<'a> {
    side: &'a Side<'a>,
    with: CurveWithDerivatives<'a, DVec2>,
}

impl Midway<'_> {
    /// The points of the evolute and of the offset curve at t.
    fn normal(&self, t: f64) -> [DVec2; 2] {
        self.side.ends_at(&self.with, t)
    }

    fn at(&self, t: f64) -> DVec2 {
        let [evolute, offset] = self.normal(t);
        (evolute + offset) * 0.5
    }

    /// Appends lines from the end of the spline, past an interval that runs backwards.
    fn add_lines(&self, [from, to]: [f64; 2], builder: &mut SplineBuilder) {
        if from == 0.0 {
            builder.line_to(self.at(from));
        }
        self.add_halves([from, to], MAX_HALVINGS, builder);
    }

    /// Appends lines from the point at the start of an interval, which ends the spline, to that at its end.
    fn add_halves(&self, [from, to]: [f64; 2], halvings: usize, builder: &mut SplineBuilder) {
        let ends = [from, to].map(|t| self.at(t));
        let inside = (1..COMPARED).all(|k| {
            let part = k as f64 / COMPARED as f64;
            self.crosses(from + (to - from) * part, ends)
        });
        if halvings == 0 || inside {
            builder.line_to(ends[1]);
            return;
        }
        let middle = 0.5 * (from + to);
        self.add_halves([from, middle], halvings - 1, builder);
        self.add_halves([middle, to], halvings - 1, builder);
    }

    /// Whether a line crosses the normal at t between the evolute and the offset curve.
    fn crosses(&self, t: f64, [a, b]: [DVec2; 2]) -> bool {
        let [evolute, offset] = self.normal(t);
        let side_of = |p: DVec2| (b - a).perp_dot(p - a);
        side_of(evolute) * side_of(offset) <= 0.0
    }
}
