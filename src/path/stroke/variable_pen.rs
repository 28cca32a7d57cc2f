//! The pen of a stroke of varying width: its discs along a part of a curve, and the two sides that they touch.

use super::profile::{Radii, RadiusPolynomial, WidthPosition};
use super::side::slowest_near;
use crate::curve::Curve;
use crate::curve::arc_length::integral::ArcLengthTable;
use crate::curve::arc_length::length::hodograph;
use crate::curve::with_derivatives::CurveWithDerivatives;
use crate::geometry::point::Point;
use crate::numeric::float::as_f64;
use crate::numeric::zero::regula_falsi;
use crate::spline::offset::{end_tangent, start_tangent};
use glam::DVec2;
use std::cell::OnceCell;

/// The parameters at which signs are evaluated, for each degree.
const SAMPLES_PER_DEGREE: usize = 8;

/// A root is accurate enough when the width of its interval is this part of it.
const ROOT_WIDTH: f64 = 1e-13;

/// Values below this are rounding errors, at size 1.
pub(super) const ROUNDING: f64 = 1e-12;

/// The bound of the sum of what turns a side backwards, below which it does not; it would at 1.
const GENTLE: f64 = 0.9;

/// The two sides, as the signs of their normals.
pub(super) const LEFT: f64 = 1.0;
pub(super) const RIGHT: f64 = -1.0;

/// The pen at one point.
#[derive(Clone, Copy)]
pub(super) struct PenAt {
    pub(super) center: DVec2,
    pub(super) tangent: DVec2,
    pub(super) radius: f64,
    /// r′, at most 1 in size.
    pub(super) slope: f64,
}

impl PenAt {
    /// The unit vector from the centre to the point of a side.
    pub(super) fn normal(&self, side: f64) -> DVec2 {
        let across = (1.0 - self.slope * self.slope).max(0.0).sqrt();
        self.tangent.perp() * (side * across) - self.tangent * self.slope
    }

    pub(super) fn point(&self, side: f64) -> DVec2 {
        self.center + self.normal(side) * self.radius
    }

    /// The direction of a side.
    pub(super) fn forward(&self, side: f64) -> DVec2 {
        self.normal(side).perp() * -side
    }

    /// The angle from the tangent to the normal of the left side.
    pub(super) fn angle(&self) -> f64 {
        (-self.slope).acos()
    }
}

/// The positions along a curve of a subpath, by arc length or by t.
pub(super) struct Along {
    curve: Curve<DVec2>,
    by: WidthPosition,
    /// The position at the start, and its rate by arc length or by t.
    pub(super) start: f64,
    rate: f64,
    /// The length of the curve, if positions follow from it.
    length: f64,
    /// The parameters at which the curve reverses: its cusps, and the turns of a straight curve.
    pub(super) reversals: Vec<f64>,
    /// The arc length by t and its unit, made when they are needed.
    table: OnceCell<(ArcLengthTable, f64)>,
}

impl Along {
    pub(super) fn new(curve: Curve<DVec2>, by: WidthPosition, start: f64, rate: f64) -> Self {
        let reversals = match curve.straight_direction() {
            _ if curve.degree() == 1 => Vec::new(),
            Some(direction) => curve.turns_along(direction).to_vec(),
            None => curve.cusps(),
        };
        let length = match by {
            WidthPosition::Length => curve.length(),
            WidthPosition::T => 0.0,
        };
        Self {
            curve,
            by,
            start,
            rate,
            length,
            reversals,
            table: OnceCell::new(),
        }
    }

    pub(super) fn position(&self, t: f64) -> f64 {
        let along = match self.by {
            WidthPosition::T => t,
            WidthPosition::Length if t == 0.0 => 0.0,
            WidthPosition::Length if t == 1.0 => self.length,
            _ if self.curve.degree() == 1 => t * self.length,
            WidthPosition::Length => {
                let (table, unit) = self.table.get_or_init(|| {
                    let (slopes, unit) = hodograph(self.curve.control_points());
                    (ArcLengthTable::new(&slopes, f64::INFINITY), unit)
                });
                unit * table.length_at(t)
            }
        };
        self.start + self.rate * along
    }

    /// The parameter at a position inside.
    pub(super) fn time(&self, position: f64) -> f64 {
        let along = (position - self.start) / self.rate;
        match self.by {
            WidthPosition::T => along,
            WidthPosition::Length => self.curve.time_at_length(along),
        }
    }

    /// The part between two parameters, on which the radius is one polynomial.
    pub(super) fn part(&self, span: [f64; 2], radii: &Radii) -> Section<'_> {
        let mut points = self.curve.part(span[0], span[1]).control_points().to_vec();
        // The derivative is 0 at a reversal; its rounding has any direction.
        let last = points.len() - 1;
        if self.reversals.contains(&span[0]) {
            points[1] = points[0];
        }
        if self.reversals.contains(&span[1]) {
            points[last - 1] = points[last];
        }
        let [start, end] = span.map(|t| self.position(t));
        Section {
            curve: Curve::from_slice(&points),
            radius: radii.polynomial(0.5 * (start + end)),
            ends: [start, end],
            rate: match self.by {
                WidthPosition::T => self.rate * (span[1] - span[0]),
                WidthPosition::Length => self.rate,
            },
            along: self,
            span,
        }
    }
}

/// A part of a curve without a reversal, with a radius that is one polynomial of the position.
pub(super) struct Section<'a> {
    pub(super) curve: Curve<DVec2>,
    pub(super) radius: RadiusPolynomial,
    /// The positions at both ends.
    ends: [f64; 2],
    /// The rate of the position by arc length or by t.
    rate: f64,
    along: &'a Along,
    /// The parameters of the ends on the whole curve.
    span: [f64; 2],
}

impl Section<'_> {
    fn position(&self, t: f64) -> f64 {
        if t == 0.0 || t == 1.0 {
            return self.ends[usize::from(t == 1.0)];
        }
        let [from, to] = self.span;
        self.along.position(from + (to - from) * t)
    }

    /// Whether both sides are straight.
    pub(super) fn is_straight(&self) -> bool {
        self.curve.degree() == 1 && self.radius.is_linear()
    }

    /// Whether bounds show that no disc contains another and that no side runs backwards.
    fn is_gentle(&self) -> bool {
        if self.along.by != WidthPosition::Length {
            return false;
        }
        let points = self.curve.control_points();
        let degree = as_f64(points.len() - 1);
        let direction = Point::unit(points[points.len() - 1] - points[0]);
        let slopes: Vec<DVec2> = points.windows(2).map(|p| (p[1] - p[0]) * degree).collect();
        let along = slopes.iter().map(|slope| slope.dot(direction));
        let speed = along.fold(f64::INFINITY, f64::min);
        let bends = slopes.windows(2).map(|d| Point::norm(d[1] - d[0]));
        let bend = bends.fold(0.0, f64::max) * (degree - 1.0);
        let [radius, slope, change] = self.radius.bounds(self.ends);
        let (slope, change) = (slope * self.rate, change * self.rate * self.rate);
        speed > 0.0 && radius * bend / (speed * speed) + slope * slope + radius * change < GENTLE
    }
}

/// A section with its derivatives.
pub(super) struct SectionEvaluator<'a> {
    pub(super) section: &'a Section<'a>,
    with: CurveWithDerivatives<'a, DVec2>,
}

impl<'a> SectionEvaluator<'a> {
    pub(super) fn new(section: &'a Section<'a>) -> Self {
        Self {
            section,
            with: CurveWithDerivatives::new(section.curve.control_points()),
        }
    }

    /// The pen, and 1 − r′² and 1 − r′² − r r″ ∓ rκ √(1 − r′²), which are negative where the left or the right side runs
    /// backwards.
    pub(super) fn evaluate(&self, t: f64) -> (PenAt, [f64; 3]) {
        let section = self.section;
        let [center, first, second] = self.with.jet(t);
        let speed = Point::norm(first);
        let tangent = match t {
            0.0 => start_tangent(&section.curve),
            1.0 => end_tangent(&section.curve),
            _ => Point::unit(first),
        };
        let position = if section.radius.is_constant() {
            section.ends[0]
        } else {
            section.position(t)
        };
        let [radius, by_position, bend] = section.radius.at(position);
        let (mut rate, mut rate_change) = (section.rate, 0.0);
        if section.along.by == WidthPosition::T {
            rate /= speed;
            rate_change = -rate * first.dot(second) / (speed * speed * speed);
        }
        let slope = if by_position == 0.0 {
            0.0
        } else {
            by_position * rate
        };
        let square = 1.0 - slope * slope;
        let slope_change = bend * rate * rate + by_position * rate_change;
        let curvature = first.perp_dot(second) / (speed * speed * speed);
        let turn = radius * curvature * square.max(0.0).sqrt();
        let ahead = square - radius * slope_change;
        let pen = PenAt {
            center,
            tangent,
            radius: radius.max(0.0),
            slope: slope.clamp(-1.0, 1.0),
        };
        (pen, [square, ahead - turn, ahead + turn])
    }

    pub(super) fn at(&self, t: f64) -> PenAt {
        self.evaluate(t).0
    }

    /// Regular parameters, those where the curve is slowest, next to tight turns, and parameters that approach an end where the
    /// speed is 0: r′ and the curvature change without bound there.
    fn samples(&self) -> Vec<f64> {
        let count = SAMPLES_PER_DEGREE * self.section.curve.degree();
        let at = |k: usize| as_f64(k) / as_f64(count);
        let speed = |k: usize| {
            let [first, _] = self.with.derivatives(at(k));
            first.dot(first)
        };
        let mut ts: Vec<f64> = (0..=count).map(at).collect();
        for k in 0..=count {
            let [before, after] = [k.saturating_sub(1), (k + 1).min(count)];
            if speed(k) <= speed(before).min(speed(after)) {
                ts.push(slowest_near(&self.with, at(k), [at(before), at(after)]));
            }
        }
        for (k, sign) in [(0, 1.0), (count, -1.0)] {
            if speed(k) == 0.0 {
                let steps = std::iter::successors(Some(at(1)), |step| Some(step * 0.25));
                let steps = steps.take_while(|&step| step > ROUNDING);
                ts.extend(steps.map(|step| at(k) + sign * step));
            }
        }
        ts.sort_by(f64::total_cmp);
        ts
    }

    /// The parameters from 0 to 1 between which no value of `evaluate` changes its sign.
    pub(super) fn breaks(&self) -> Vec<f64> {
        let mut breaks = Vec::new();
        let section = self.section;
        if !section.is_straight() && !section.is_gentle() {
            let samples: Vec<(f64, [f64; 3])> = self
                .samples()
                .into_iter()
                .map(|t| (t, self.evaluate(t).1))
                .collect();
            for which in 0..3 {
                // The speed may be 0 at an end.
                let value = |t: f64| self.evaluate(t).1[which];
                let mut last: Option<(f64, f64)> = None;
                for &(t, ref values) in &samples {
                    let found = values[which];
                    if !found.is_finite() || found.abs() <= ROUNDING {
                        continue;
                    }
                    if let Some((before, old)) = last
                        && old * found < 0.0
                    {
                        let sign = old.signum();
                        let ends = [sign * old, sign * found];
                        let zero = regula_falsi([before, t], ends, ROOT_WIDTH, |t| sign * value(t));
                        breaks.push(zero);
                    }
                    last = Some((t, found));
                }
            }
        }
        between_ends(&mut breaks);
        breaks
    }
}

/// Sorts parameters, removes those that are equal to others or to an end, and adds both ends.
pub(super) fn between_ends(ts: &mut Vec<f64>) {
    ts.retain(|&t| t > ROUNDING && t < 1.0 - ROUNDING);
    ts.extend([0.0, 1.0]);
    ts.sort_by(f64::total_cmp);
    ts.dedup_by(|next, last| *next - *last <= ROUNDING);
}
