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

/// The parameters at which signs are evaluated, for each degree.
const SAMPLES_PER_DEGREE: usize = 8;

/// A root is accurate enough when the width of its interval is this part of it.
const ROOT_WIDTH: f64 = 1e-13;

/// Values below this are rounding errors, at size 1.
pub(super) const ROUNDING: f64 = 1e-12;

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

/// A part of a curve without a reversal, with a radius that is one polynomial of the position.
pub(super) struct Section {
    pub(super) curve: Curve<DVec2>,
    pub(super) radius: RadiusPolynomial,
    pub(super) by: WidthPosition,
    /// The position at the start, and its rate by arc length or by t.
    pub(super) start: f64,
    pub(super) rate: f64,
}

impl Section {
    pub(super) fn position(&self, t: f64) -> f64 {
        let along = match self.by {
            WidthPosition::T => t,
            _ if self.curve.degree() == 1 => t * self.curve.length(),
            WidthPosition::Length if t == 0.0 => 0.0,
            WidthPosition::Length if t == 1.0 => self.curve.length(),
            WidthPosition::Length => self.curve.part(0.0, t).length(),
        };
        self.start + self.rate * along
    }

    /// The part between two parameters.
    pub(super) fn part(&self, from: f64, to: f64, radii: &Radii) -> Self {
        let start = self.position(from);
        let rate = match self.by {
            WidthPosition::T => self.rate * (to - from),
            WidthPosition::Length => self.rate,
        };
        let mut points = self.curve.part(from, to).control_points().to_vec();
        // The derivative is 0 at a reversal; its rounding has any direction.
        let reversals = self.reversals();
        let last = points.len() - 1;
        if reversals.contains(&from) {
            points[1] = points[0];
        }
        if reversals.contains(&to) {
            points[last - 1] = points[last];
        }
        let curve = Curve::from_slice(&points);
        let middle = 0.5 * (start + self.position(to));
        Self {
            curve,
            radius: radii.polynomial(middle),
            by: self.by,
            start,
            rate,
        }
    }

    /// The parameters at which the curve reverses: its cusps, and the turns of a straight curve.
    pub(super) fn reversals(&self) -> Vec<f64> {
        match self.curve.straight_direction() {
            _ if self.curve.degree() == 1 => Vec::new(),
            Some(direction) => self.curve.turns_along(direction).to_vec(),
            None => self.curve.cusps(),
        }
    }

    /// The parameter at a position inside.
    pub(super) fn time(&self, position: f64) -> f64 {
        let along = (position - self.start) / self.rate;
        match self.by {
            WidthPosition::T => along,
            WidthPosition::Length => self.curve.time_at_length(along),
        }
    }

    /// Whether both sides are straight.
    pub(super) fn is_straight(&self) -> bool {
        self.curve.degree() == 1 && self.radius.is_linear()
    }
}

/// A section with its derivatives.
pub(super) struct SectionEvaluator<'a> {
    pub(super) section: &'a Section,
    with: CurveWithDerivatives<'a, DVec2>,
    /// The arc length of the curve and the unit of this length, if positions follow from it.
    lengths: Option<(ArcLengthTable, f64)>,
}

impl<'a> SectionEvaluator<'a> {
    pub(super) fn new(section: &'a Section) -> Self {
        let points = section.curve.control_points();
        let needs_lengths = section.by == WidthPosition::Length
            && section.curve.degree() > 1
            && !section.radius.is_constant();
        let lengths = needs_lengths.then(|| {
            let (slopes, unit) = hodograph(points);
            (ArcLengthTable::new(&slopes, f64::INFINITY), unit)
        });
        Self {
            section,
            with: CurveWithDerivatives::new(points),
            lengths,
        }
    }

    fn position(&self, t: f64) -> f64 {
        let section = self.section;
        match &self.lengths {
            Some((table, unit)) => section.start + section.rate * (unit * table.length_at(t)),
            None => section.position(t),
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
            section.start
        } else {
            self.position(t)
        };
        let [radius, by_position, bend] = section.radius.at(position);
        let (mut rate, mut rate_change) = (section.rate, 0.0);
        if section.by == WidthPosition::T {
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
        if !section.is_straight() {
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
