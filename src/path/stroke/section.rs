//! The discs of a stroke along a part of a curve, and the two sides that they touch.

use super::profile::{Radii, RadiusPolynomial, WidthPosition};
use crate::bernstein::product::product_of;
use crate::curve::Curve;
use crate::curve::arc_length::integral::ArcLengthTable;
use crate::curve::arc_length::length::hodograph;
use crate::curve::with_derivatives::CurveWithDerivatives;
use crate::geometry::point::Point;
use crate::numeric::float::as_f64;
use crate::numeric::list::{List, Points, Scalars, points_of};
use crate::numeric::zero::regula_falsi;
use crate::spline::offset::{end_tangent, start_tangent};
use glam::DVec2;
use std::borrow::Cow;
use std::cell::OnceCell;

/// The two sides, as the signs of their normals.
pub(super) const LEFT: f64 = 1.0;
pub(super) const RIGHT: f64 = -1.0;

/// The parameters at which a cubic is compared with the side, as parts of an interval: Chebyshev points, which are dense
/// at the ends, where a side may start with a high speed.
pub(super) const COMPARED: [f64; 8] = [
    0.0096, 0.0843, 0.2222, 0.4025, 0.5975, 0.7778, 0.9157, 0.9904,
];

/// The parameters at which signs are evaluated, for each degree.
const SAMPLES_PER_DEGREE: usize = 8;

/// A root is accurate enough when the width of its interval is this part of it.
const ROOT_WIDTH: f64 = 1e-13;

/// Steps towards a parameter of smallest speed.
const NEWTON_STEPS: usize = 4;

/// Values below this are rounding errors, at size 1.
pub(super) const ROUNDING: f64 = 1e-12;

/// The bound of the sum of what turns a side backwards, below which it does not; it would at 1.
const GENTLE: f64 = 1.0 - 1e-9;

/// An interval that runs backwards is extended by this part of itself, so that nothing beside it runs backwards because
/// of rounding. The side moves there by the square of this.
const BESIDE: f64 = 1e-6;

/// Parameters at which a curve is divided.
pub(super) type Breaks = Scalars;

/// The disc at one point.
#[derive(Clone, Copy)]
pub(super) struct Disc {
    pub(super) center: DVec2,
    pub(super) tangent: DVec2,
    pub(super) radius: f64,
    /// r′, at most 1 in size.
    pub(super) slope: f64,
}

impl Disc {
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

/// Bounds of a curve from the Bernstein coefficients of |B′|² and B′ × B″.
#[derive(Clone, Copy)]
struct Bends {
    /// The least speed; 0 if it is not known to be above 0.
    speed: f64,
    /// The greatest |B′ × B″|.
    cross: f64,
}

impl Bends {
    fn of(points: &[DVec2]) -> Self {
        let n = points.len() - 1;
        if n == 1 {
            return Self {
                speed: Point::norm(points[1] - points[0]),
                cross: 0.0,
            };
        }
        let rates = |points: &[DVec2]| -> Points<DVec2> {
            let degree = as_f64(points.len() - 1);
            let steps = points.windows(2);
            steps.map(|pair| (pair[1] - pair[0]) * degree).collect()
        };
        let first = rates(points);
        let squares = product_of(n - 1, n - 1, |i, j| first[i].dot(first[j]));
        let slowest = squares.iter().copied().fold(f64::INFINITY, f64::min);
        let second = rates(&first);
        let crosses = product_of(n - 1, n - 2, |i, j| first[i].perp_dot(second[j]));
        let cross = crosses
            .iter()
            .fold(0.0, |max: f64, cross| max.max(cross.abs()));
        Self {
            speed: slowest.max(0.0).sqrt(),
            cross,
        }
    }

    /// A bound of the curvature.
    fn curvature(&self) -> f64 {
        self.cross / (self.speed * self.speed * self.speed)
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
    pub(super) reversals: Breaks,
    bends: Bends,
    is_straight: bool,
    /// The arc length by t and its unit, made when they are needed.
    table: OnceCell<Box<(ArcLengthTable, f64)>>,
}

impl Along {
    pub(super) fn new(curve: Curve<DVec2>, by: WidthPosition, start: f64, rate: f64) -> Self {
        let bends = Bends::of(curve.control_points());
        let is_line = curve.degree() == 1;
        let direction = if is_line {
            None
        } else {
            curve.straight_direction()
        };
        let reversals = match direction {
            _ if bends.speed > 0.0 => Breaks::new(),
            Some(direction) => curve.turns_along(direction),
            None => curve.cusps().into_iter().collect(),
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
            bends,
            is_straight: is_line || direction.is_some(),
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
                let (table, unit) = &**self.table.get_or_init(|| {
                    let (slopes, unit) = hodograph(self.curve.control_points());
                    Box::new((ArcLengthTable::new(&slopes, f64::INFINITY), unit))
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
    pub(super) fn section(&self, span: [f64; 2], radii: &Radii) -> Section<'_> {
        let (curve, bends) = if span == [0.0, 1.0] {
            (Cow::Borrowed(&self.curve), self.bends)
        } else {
            let part = self.curve.part(span[0], span[1]);
            let mut points = points_of(part.control_points());
            // The derivative is 0 at a reversal; its rounding has any direction.
            let last = points.len() - 1;
            if self.reversals.contains(&span[0]) {
                points[1] = points[0];
            }
            if self.reversals.contains(&span[1]) {
                points[last - 1] = points[last];
            }
            let bends = Bends::of(&points);
            (Cow::Owned(Curve::from_points(points)), bends)
        };
        let ends = span.map(|t| self.position(t));
        Section {
            curve,
            bends,
            radius: radii.polynomial(0.5 * (ends[0] + ends[1])),
            ends,
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
#[derive(Clone)]
pub(super) struct Section<'a> {
    pub(super) curve: Cow<'a, Curve<DVec2>>,
    bends: Bends,
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
        let by_length = self.along.by == WidthPosition::Length || self.radius.is_constant();
        self.along.is_straight && self.radius.is_linear() && (by_length || self.curve.degree() == 1)
    }

    /// Whether bounds show that no disc contains another and that no side runs backwards.
    fn is_gentle(&self) -> bool {
        let [radius, slope, change] = self.radius.bounds(self.ends);
        if self.along.by != WidthPosition::Length && !self.radius.is_constant() {
            return false;
        }
        let (slope, change) = (slope * self.rate, change * self.rate * self.rate);
        radius * self.bends.curvature() + slope * slope + radius * change < GENTLE
    }
}

/// An interval of a section in which a side has one kind.
#[derive(Clone, Copy)]
pub(super) struct Run {
    pub(super) span: [f64; 2],
    pub(super) kind: RunKind,
}

#[derive(Clone, Copy, PartialEq)]
pub(super) enum RunKind {
    Forward,
    Backward,
    /// One disc contains the others.
    Inside,
}

/// The derivative of the curve, its curvature, and the radius with its first two derivatives by arc length.
struct Rates {
    first: DVec2,
    curvature: f64,
    radius: f64,
    slope: f64,
    slope_change: f64,
}

impl Rates {
    #[inline]
    fn values(&self) -> [f64; 3] {
        let square = 1.0 - self.slope * self.slope;
        let turn = self.radius * self.curvature * square.max(0.0).sqrt();
        let ahead = square - self.radius * self.slope_change;
        [square, ahead - turn, ahead + turn]
    }
}

/// A section with its derivatives.
pub(super) struct SectionEvaluator<'a> {
    pub(super) section: &'a Section<'a>,
    with: CurveWithDerivatives<'a, DVec2>,
    /// The discs with which a cubic along the whole section is compared.
    compared: OnceCell<[Disc; COMPARED.len()]>,
}

impl<'a> SectionEvaluator<'a> {
    pub(super) fn new(section: &'a Section<'a>) -> Self {
        Self {
            section,
            with: CurveWithDerivatives::new(section.curve.control_points()),
            compared: OnceCell::new(),
        }
    }

    /// The discs with which a cubic is compared in an interval.
    pub(super) fn compared(&self, [a, b]: [f64; 2]) -> [Disc; COMPARED.len()] {
        let discs = || COMPARED.map(|part| self.at(a + (b - a) * part));
        if [a, b] == [0.0, 1.0] {
            *self.compared.get_or_init(discs)
        } else {
            discs()
        }
    }

    pub(super) fn at(&self, t: f64) -> Disc {
        let jet = self.with.jet(t);
        self.disc(t, jet[0], &self.rates(t, jet[1], jet[2]))
    }

    /// 1 − r′² and 1 − r′² − r r″ ∓ rκ √(1 − r′²), which are negative where the left or the right side runs backwards.
    pub(super) fn values(&self, t: f64) -> [f64; 3] {
        let [first, second] = self.with.derivatives(t);
        self.rates(t, first, second).values()
    }

    /// The disc together with [`values`](Self::values).
    pub(super) fn evaluate(&self, t: f64) -> (Disc, [f64; 3]) {
        let [center, first, second] = self.with.jet(t);
        let rates = self.rates(t, first, second);
        (self.disc(t, center, &rates), rates.values())
    }

    #[inline]
    fn disc(&self, t: f64, center: DVec2, rates: &Rates) -> Disc {
        let tangent = match t {
            0.0 => start_tangent(&self.section.curve),
            1.0 => end_tangent(&self.section.curve),
            _ => Point::unit(rates.first),
        };
        Disc {
            center,
            tangent,
            radius: rates.radius.max(0.0),
            slope: rates.slope.clamp(-1.0, 1.0),
        }
    }

    #[inline]
    fn rates(&self, t: f64, first: DVec2, second: DVec2) -> Rates {
        let section = self.section;
        let speed = Point::norm(first);
        let cube = speed * speed * speed;
        let curvature = first.perp_dot(second) / cube;
        if section.radius.is_constant() {
            let radius = section.radius.at(section.ends[0])[0];
            let (slope, slope_change) = (0.0, 0.0);
            return Rates {
                first,
                curvature,
                radius,
                slope,
                slope_change,
            };
        }
        let [radius, by_position, bend] = section.radius.at(section.position(t));
        let (mut rate, mut rate_change) = (section.rate, 0.0);
        if section.along.by == WidthPosition::T {
            rate /= speed;
            rate_change = -rate * first.dot(second) / cube;
        }
        // The rate is infinite where the speed is 0.
        let slope = if by_position == 0.0 {
            0.0
        } else {
            by_position * rate
        };
        let slope_change = bend * rate * rate + by_position * rate_change;
        Rates {
            first,
            curvature,
            radius,
            slope,
            slope_change,
        }
    }

    /// The [`values`](Self::values) at regular parameters, at those where the curve is slowest, next to tight turns, and at
    /// parameters that approach an end where the speed is 0: r′ and the curvature change without bound there. None if bounds
    /// show that no value changes its sign.
    pub(super) fn signs(&self) -> Signs {
        if self.section.is_straight() || self.section.is_gentle() {
            return Signs(Vec::new());
        }
        let count = SAMPLES_PER_DEGREE * self.section.curve.degree();
        let at = |k: usize| as_f64(k) / as_f64(count);
        let derivatives: Vec<[DVec2; 2]> =
            (0..=count).map(|k| self.with.derivatives(at(k))).collect();
        let square = |k: usize| derivatives[k][0].dot(derivatives[k][0]);
        let mut signs = Vec::with_capacity(count + 4);
        for (k, &[first, second]) in derivatives.iter().enumerate() {
            let own = (at(k), self.rates(at(k), first, second).values());
            let [before, after] = [k.saturating_sub(1), (k + 1).min(count)];
            let mut slowest = at(k);
            if square(k) <= square(before).min(square(after)) {
                slowest = slowest_near(&self.with, at(k), [at(before), at(after)]);
            }
            if slowest < at(k) {
                signs.push((slowest, self.values(slowest)));
            }
            signs.push(own);
            if slowest > at(k) {
                signs.push((slowest, self.values(slowest)));
            }
        }
        for (k, sign) in [(0, 1.0), (count, -1.0)] {
            if square(k) == 0.0 {
                let mut step = at(1);
                while step > ROUNDING {
                    step *= 0.25;
                    let t = at(k) + sign * step;
                    signs.push((t, self.values(t)));
                }
                signs.sort_by(|a, b| a.0.total_cmp(&b.0));
            }
        }
        Signs(signs)
    }

    /// The intervals of one side, in order.
    pub(super) fn runs(&self, signs: &Signs, side: f64) -> List<Run, 4> {
        let mut runs: List<Run, 4> = List::new();
        if signs.0.is_empty() {
            runs.push(Run {
                span: [0.0, 1.0],
                kind: self.kind(0.5, signs, side),
            });
            return runs;
        }
        let mut breaks = Breaks::new();
        if !self.section.radius.is_constant() {
            self.push_zeros(signs, 0, &mut breaks);
        }
        self.push_zeros(signs, value_of(side), &mut breaks);
        between_ends(&mut breaks);
        for pair in breaks.windows(2) {
            let [from, to] = [pair[0], pair[1]];
            let kind = self.kind(0.5 * (from + to), signs, side);
            match runs.last_mut() {
                Some(last) if last.kind == kind => last.span[1] = to,
                _ => runs.push(Run {
                    span: [from, to],
                    kind,
                }),
            }
        }
        extend_backward(&mut runs);
        runs
    }

    fn kind(&self, t: f64, signs: &Signs, side: f64) -> RunKind {
        if self.section.radius.is_zero() {
            return RunKind::Inside;
        }
        if signs.0.is_empty() && self.section.radius.is_constant() {
            return RunKind::Forward;
        }
        let values = self.values(t);
        if values[0] <= 0.0 || values[0].is_nan() {
            RunKind::Inside
        } else if values[value_of(side)] < -ROUNDING {
            RunKind::Backward
        } else {
            RunKind::Forward
        }
    }

    /// Appends the parameters at which one of the [`values`](Self::values) changes its sign.
    fn push_zeros(&self, signs: &Signs, which: usize, breaks: &mut Breaks) {
        // The speed may be 0 at an end.
        let value = |t: f64| self.values(t)[which];
        let mut last: Option<(f64, f64)> = None;
        for &(t, ref values) in &signs.0 {
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

/// Parameters with their [`values`](SectionEvaluator::values).
pub(super) struct Signs(Vec<(f64, [f64; 3])>);

/// Which of the [`values`](SectionEvaluator::values) is negative where a side runs backwards.
pub(super) fn value_of(side: f64) -> usize {
    if side == LEFT { 1 } else { 2 }
}

/// Moves the ends of intervals that run backwards into those that run forward next to them.
fn extend_backward(runs: &mut List<Run, 4>) {
    for k in 1..runs.len() {
        let [before, after] = [runs[k - 1], runs[k]];
        let end = before.span[1];
        let moved = match (before.kind, after.kind) {
            (RunKind::Forward, RunKind::Backward) => {
                (end - BESIDE * (after.span[1] - end)).max(before.span[0])
            }
            (RunKind::Backward, RunKind::Forward) => {
                (end + BESIDE * (end - before.span[0])).min(after.span[1])
            }
            _ => end,
        };
        runs[k - 1].span[1] = moved;
        runs[k].span[0] = moved;
    }
    runs.retain(|run| run.span[0] < run.span[1]);
}

/// The parameter of the smallest speed near another one.
fn slowest_near(with: &CurveWithDerivatives<DVec2>, mut t: f64, [from, to]: [f64; 2]) -> f64 {
    for _ in 0..NEWTON_STEPS {
        let [first, second] = with.derivatives(t);
        let square = second.dot(second);
        if square > 0.0 {
            t = (t - first.dot(second) / square).clamp(from, to);
        }
    }
    t
}

/// Sorts parameters, removes those that are equal to others or to an end, and adds both ends.
pub(super) fn between_ends(ts: &mut Breaks) {
    ts.retain(|t| *t > ROUNDING && *t < 1.0 - ROUNDING);
    ts.sort_by(f64::total_cmp);
    ts.dedup_by(|next, last| *next - *last <= ROUNDING);
    ts.insert(0, 0.0);
    ts.push(1.0);
}
