//! The discs of a stroke along a part of a curve, and the two sides that they touch.

use super::profile::{Radii, RadiusPolynomial, WidthPosition};
use crate::curve::Curve;
use crate::curve::arc_length::integral::{ArcLengthTable, PolynomialSpeed};
use crate::curve::hodograph::Hodograph;
use crate::curve::with_derivatives::CurveWithDerivatives;
use crate::geometry::point::Point;
use crate::numeric::float::as_f64;
use crate::numeric::list::{List, Points, Scalars, points_of};
use casteljau_kernels::curve::curvature::curvature_is_within;
use casteljau_kernels::numeric::order::{larger, range, smaller};
use casteljau_kernels::numeric::zero::{ROOT_WIDTH, regula_falsi};
use casteljau_kernels::spline::offset::offset_curve::fourth_bound;
use glam::DVec2;
use std::borrow::Cow;
use std::cell::OnceCell;

/// The two sides, as the signs of their normals.
pub(super) const LEFT: f64 = 1.0;
pub(super) const RIGHT: f64 = -1.0;

/// What belongs to each of the compared points.
pub(super) type Compared<T> = [T; 6];

/// The parameters at which a cubic is compared with the side, as parts of an interval: Chebyshev points, which are dense
/// at the ends, where a side may start with a high speed.
pub(super) const CHEBYSHEV_NODES: Compared<f64> = [0.0170, 0.1464, 0.3706, 0.6294, 0.8536, 0.9830];

/// The number of regular parameters at which the sides are examined, for each degree.
const SAMPLES_PER_DEGREE: usize = 8;

/// Parameters next to the slowest one approach it by this factor.
const APPROACH_FACTOR: f64 = 0.25;

/// Steps towards a parameter of smallest speed.
const NEWTON_STEPS: usize = 4;

/// Values below this are rounding errors, at size 1.
pub(super) const ROUNDING: f64 = 1e-12;

/// A side runs forward if the terms that slow it down, r′² + |r r″| + |rκ|, are below this; it stops at 1.
const MAX_REGULAR_SUM: f64 = 1.0 - 1e-9;

/// An interval that runs backwards is extended by this part of itself, so that nothing beside it runs backwards because
/// of rounding. The side moves there by the square of this.
const BACKWARD_MARGIN: f64 = 1e-6;

/// Parameters at which a curve is divided.
pub(super) type Breaks = Scalars;

/// The disc at one point; two half discs if the sides have different widths.
#[derive(Clone, Copy)]
pub(super) struct Disc {
    pub(super) center: DVec2,
    pub(super) tangent: DVec2,
    /// On the left and on the right; they differ only where r′ is 0.
    pub(super) radii: [f64; 2],
    /// r′, at most 1 in size.
    pub(super) slope: f64,
    /// |B′|.
    pub(super) speed: f64,
}

impl Disc {
    /// The larger radius.
    pub(super) fn radius(&self) -> f64 {
        larger(self.radii[0], self.radii[1])
    }

    pub(super) fn radius_of(&self, side: f64) -> f64 {
        self.radii[usize::from(side != LEFT)]
    }

    /// The disc whose diameter is the line between both sides, for caps.
    pub(super) fn cap_disc(&self) -> Self {
        let [left, right] = self.radii;
        if left == right {
            return *self;
        }
        Self {
            center: self.center + self.tangent.perp() * (0.5 * (left - right)),
            radii: [0.5 * (left + right); 2],
            ..*self
        }
    }

    /// The unit vector from the centre to the point of a side.
    pub(super) fn normal(&self, side: f64) -> DVec2 {
        let across = larger(1.0 - self.slope * self.slope, 0.0).sqrt();
        self.tangent.perp() * (side * across) - self.tangent * self.slope
    }

    pub(super) fn point(&self, side: f64) -> DVec2 {
        self.center + self.normal(side) * self.radius_of(side)
    }

    /// The direction of a side.
    pub(super) fn forward(&self, side: f64) -> DVec2 {
        self.normal(side).perp() * -side
    }

    /// The value of r′ on the way to another disc if one of both contains the other.
    pub(super) fn contained_slope(&self, other: &Self) -> f64 {
        (other.radius() - self.radius()).signum()
    }

    /// The angle from the tangent to the normal of the left side.
    pub(super) fn angle(&self) -> f64 {
        (-self.slope).acos()
    }
}

/// Whether control points of the derivative prove that it does not vanish, and that the curvature is below a limit. Up to
/// degree 3 only.
fn is_less_curved(derivative: &[DVec2], limit: f64) -> bool {
    let quadratic = match *derivative {
        [a] => [a; 3],
        [a, b] => [a, (a + b) * 0.5, b],
        [a, b, c] => [a, b, c],
        _ => return false,
    };
    curvature_is_within(&quadratic, [-limit, limit])
}

/// Whether a curve is straight, and the parameters at which it reverses, with both ends: its cusps, and the turns of a
/// straight curve.
fn reversals(curve: &Curve<DVec2>) -> (bool, Breaks) {
    let is_line = curve.degree() == 1;
    let direction = if is_line {
        None
    } else {
        curve.straight_direction()
    };
    let has_no_cusp = || {
        let steps = curve.control_points().windows(2);
        let steps: Points<DVec2> = steps.map(|pair| pair[1] - pair[0]).collect();
        is_less_curved(&steps, f64::INFINITY)
    };
    let mut ts = match direction {
        _ if is_line => Breaks::new(),
        Some(direction) => curve.turns_along(direction),
        None if has_no_cusp() => Breaks::new(),
        None => curve.cusps().into_iter().collect(),
    };
    sort_with_ends(&mut ts);
    (is_line || direction.is_some(), ts)
}

/// The part of a curve between two of its reversals, or its ends.
fn part_between(curve: &Curve<DVec2>, [from, to]: [f64; 2]) -> Curve<DVec2> {
    let part = curve.part(from, to);
    let mut points = points_of(part.control_points());
    // The derivative is 0 at a reversal; its rounding has any direction.
    let last = points.len() - 1;
    if from > 0.0 {
        points[1] = points[0];
    }
    if to < 1.0 {
        points[last - 1] = points[last];
    }
    Curve::from_points(points)
}

/// A curve without a reversal, with the positions along it, by arc length or by t.
pub(super) struct PositionedCurve {
    curve: Curve<DVec2>,
    by: WidthPosition,
    /// The position at the start, and its rate by arc length or by t.
    pub(super) start: f64,
    rate: f64,
    /// The length of the curve, if positions follow from it.
    length: f64,
    is_straight: bool,
    /// Whether it starts where a curve of the subpath does, and not at a reversal.
    pub(super) is_first: bool,
    /// The arc length by t and its unit, made when they are needed.
    table: OnceCell<Box<(ArcLengthTable, f64)>>,
}

impl PositionedCurve {
    /// Appends the parts of a curve between its reversals; the position starts at `start` and has a rate.
    pub(super) fn push_parts(
        parts: &mut Vec<Self>,
        curve: Curve<DVec2>,
        by: WidthPosition,
        mut start: f64,
        rate: f64,
    ) {
        let (is_straight, ts) = reversals(&curve);
        for pair in ts.windows(2) {
            let curve = if ts.len() == 2 {
                curve.clone()
            } else {
                part_between(&curve, [pair[0], pair[1]])
            };
            let (length, rate) = match by {
                WidthPosition::Length => (curve.length(), rate),
                WidthPosition::T => (0.0, rate * (pair[1] - pair[0])),
            };
            let part = Self {
                curve,
                by,
                start,
                rate,
                length,
                is_straight,
                is_first: pair[0] == 0.0,
                table: OnceCell::new(),
            };
            start = part.position(1.0);
            parts.push(part);
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
                    let Hodograph { vectors, unit } = Hodograph::of(self.curve.control_points());
                    Box::new((
                        ArcLengthTable::new(PolynomialSpeed::new(&vectors), f64::INFINITY),
                        unit,
                    ))
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
        let curve = if span == [0.0, 1.0] {
            Cow::Borrowed(&self.curve)
        } else {
            Cow::Owned(self.curve.part(span[0], span[1]))
        };
        let ends = [self.position(span[0]), self.position(span[1])];
        Section {
            curve,
            radius: radii.polynomial(0.5 * (ends[0] + ends[1])),
            sides: radii.sides,
            ends,
            rate: match self.by {
                WidthPosition::T => self.rate * (span[1] - span[0]),
                WidthPosition::Length => self.rate,
            },
            whole: self,
            span,
        }
    }
}

/// A part of a curve without a reversal, with a radius that is one polynomial of the position.
#[derive(Clone)]
pub(super) struct Section<'a> {
    pub(super) curve: Cow<'a, Curve<DVec2>>,
    pub(super) radius: RadiusPolynomial,
    /// The radii on the left and on the right, if they are different; the larger one is the radius.
    sides: Option<[f64; 2]>,
    /// The positions at both ends.
    ends: [f64; 2],
    /// The rate of the position by arc length or by t.
    rate: f64,
    whole: &'a PositionedCurve,
    /// The parameters of the ends on the whole curve.
    span: [f64; 2],
}

impl Section<'_> {
    fn position(&self, t: f64) -> f64 {
        if t == 0.0 || t == 1.0 {
            return self.ends[usize::from(t == 1.0)];
        }
        self.whole.position(self.parameter(t))
    }

    /// Whether both sides are straight.
    pub(super) fn is_straight(&self) -> bool {
        let by_length = self.whole.by == WidthPosition::Length || self.radius.is_constant();
        self.whole.is_straight && self.radius.is_linear() && (by_length || self.curve.degree() == 1)
    }

    /// A bound of the distances of the curve and of the radius from cubics with the same values and derivatives at the ends
    /// of an interval of length `dt`; `slopes` are the coefficients of the derivative of the first cubic.
    ///
    /// The error is at most max|g⁗|/384 for a function g. By arc length s, g⁗ follows from s′ = |B′|, |s″| ≤ |B″|,
    /// |s‴| ≤ |B″|²/|B′| + |B‴| and |s⁗| ≤ 3 |B″| |B‴|/|B′| + 2 |B″|³/(√3 |B′|²) + |B⁗|.
    pub(super) fn hermite_error(&self, slopes: [DVec2; 3], dt: f64) -> f64 {
        let fourth = fourth_bound(self.curve.control_points()) * (dt * dt) * (dt * dt);
        let error = fourth / 384.0;
        let [_, r1, r2, r3] = self.radius.bounds(self.ends);
        if self.whole.by == WidthPosition::T || self.radius.is_constant() {
            return error; // the radius is a cubic
        }
        let [v0, v1, v2] = slopes;
        let largest = |a: DVec2, b: DVec2| larger(Point::norm(a), Point::norm(b));
        // |B′| is at least its component in any direction.
        let along = Point::unit(v0 + v2);
        // The derivatives of the curve differ from those of the cubic by less than these parts of its fourth.
        let (least, _) = range([v0, v1, v2].into_iter().map(|v| v.dot(along)));
        let least = larger(least - fourth / 124.0, 0.0);
        let first = larger(largest(v0, v1), Point::norm(v2)) + fourth / 124.0;
        let second = 2.0 * largest(v1 - v0, v2 - v1) + fourth / 12.0;
        let third = 2.0 * Point::norm(v0 - v1 * 2.0 + v2) + fourth / 2.0;
        let bend = second * second / least;
        let s3 = bend + third;
        let s4 = second * (3.0 * third + 1.2 * bend) / least + fourth;
        let rate = self.rate.abs();
        let of_radius = r1 * s4
            + r2 * rate * (4.0 * first * s3 + 3.0 * second * second)
            + 6.0 * r3 * rate * rate * first * first * second;
        error + rate * (of_radius / 384.0).min(2.0 * r1 * first)
    }

    /// The parameter on the whole curve.
    #[inline]
    fn parameter(&self, t: f64) -> f64 {
        let [from, to] = self.span;
        if t == 1.0 { to } else { from + (to - from) * t }
    }

    fn width(&self) -> f64 {
        self.span[1] - self.span[0]
    }

    /// Whether the centres of an interval are the same point up to rounding, so that its radii are rounding errors too.
    pub(super) fn is_point(&self, interval: &SideInterval) -> bool {
        let start = interval.ends[0].center;
        let is_near = |&p: &DVec2| Point::max_abs(p - start) <= ROUNDING;
        let [from, to] = interval.span;
        is_near(&interval.ends[1].center)
            && self
                .curve
                .part(from, to)
                .control_points()
                .iter()
                .all(is_near)
    }

    /// The discs at both ends.
    pub(super) fn end_discs(&self) -> [Disc; 2] {
        let curve = &self.whole.curve;
        let points = curve.control_points();
        let n = points.len() - 1;
        let centers = self.curve.control_points();
        [(0, 0.0), (centers.len() - 1, 1.0)].map(|(k, t)| {
            let (first, tangent) = match self.parameter(t) {
                0.0 => ((points[1] - points[0]) * as_f64(n), curve.start_tangent()),
                1.0 => ((points[n] - points[n - 1]) * as_f64(n), curve.end_tangent()),
                t => (curve.derivative_at(t, 1), curve.tangent(t)),
            };
            let rates = self.rates(t, first * self.width(), DVec2::ZERO);
            rates.disc(centers[k], tangent)
        })
    }

    #[inline]
    fn disc(&self, t: f64, center: DVec2, rates: &Rates) -> Disc {
        let curve = &self.whole.curve;
        let tangent = match self.parameter(t) {
            0.0 => curve.start_tangent(),
            1.0 => curve.end_tangent(),
            _ => Point::unit(rates.first),
        };
        rates.disc(center, tangent)
    }

    #[inline]
    fn rates(&self, t: f64, first: DVec2, second: DVec2) -> Rates {
        let speed = Point::norm(first);
        let cube = speed * speed * speed;
        let mut rates = Rates {
            first,
            // That of a straight curve would be a rounding error.
            curvature: if self.whole.is_straight {
                0.0
            } else {
                first.perp_dot(second) / cube
            },
            radii: self.sides.unwrap_or([0.0; 2]),
            slope: 0.0,
            slope_change: 0.0,
        };
        if self.sides.is_some() {
            return rates;
        }
        rates.radii = [self.radius.at(self.ends[0])[0]; 2];
        if self.radius.is_constant() {
            return rates;
        }
        let [radius, by_position, bend] = self.radius.at(self.position(t));
        let (mut rate, mut rate_change) = (self.rate, 0.0);
        if self.whole.by == WidthPosition::T {
            rate /= speed;
            rate_change = -rate * first.dot(second) / cube;
        }
        rates.radii = [radius; 2];
        // The rate is infinite where the speed is 0.
        if by_position != 0.0 {
            rates.slope = by_position * rate;
        }
        rates.slope_change = bend * rate * rate + by_position * rate_change;
        rates
    }
}

/// An interval of a section in which a side has one kind.
#[derive(Clone, Copy)]
pub(super) struct SideInterval {
    pub(super) span: [f64; 2],
    pub(super) ends: [Disc; 2],
    pub(super) kind: SideKind,
}

#[derive(Clone, Copy, PartialEq)]
pub(super) enum SideKind {
    Forward,
    Backward,
    /// One disc contains the others.
    Inside,
}

/// The derivative of the curve, its curvature, and the radii with their first two derivatives by arc length.
struct Rates {
    first: DVec2,
    curvature: f64,
    radii: [f64; 2],
    slope: f64,
    slope_change: f64,
}

impl Rates {
    #[inline]
    fn disc(&self, center: DVec2, tangent: DVec2) -> Disc {
        Disc {
            center,
            tangent,
            radii: self.radii.map(|radius| larger(radius, 0.0)),
            slope: self.slope.clamp(-1.0, 1.0),
            speed: Point::norm(self.first),
        }
    }

    #[inline]
    fn side_speeds(&self) -> [f64; 3] {
        let square = 1.0 - self.slope * self.slope;
        let [left, right] = self.radii;
        let root = larger(square, 0.0).sqrt();
        let ahead = |radius: f64| square - radius * self.slope_change;
        let turn = |radius: f64| radius * self.curvature * root;
        [square, ahead(left) - turn(left), ahead(right) + turn(right)]
    }
}

/// A section with its derivatives.
pub(super) struct SectionEvaluator<'a> {
    pub(super) section: &'a Section<'a>,
    with: CurveWithDerivatives<'a, DVec2>,
    /// The discs with which a cubic along the whole section is compared.
    compared: OnceCell<Compared<Disc>>,
}

impl<'a> SectionEvaluator<'a> {
    pub(super) fn new(section: &'a Section<'a>) -> Self {
        Self {
            section,
            with: CurveWithDerivatives::new(section.whole.curve.control_points()),
            compared: OnceCell::new(),
        }
    }

    /// Whether bounds show that no disc contains another and that no side runs backwards.
    fn is_proved_regular(&self) -> bool {
        let section = self.section;
        let [radius, slope, change, _] = section.radius.bounds(section.ends);
        if section.whole.by != WidthPosition::Length && !section.radius.is_constant() {
            return false;
        }
        let (slope, change) = (slope * section.rate, change * section.rate * section.rate);
        let steps: Points<DVec2>;
        let derivative = if section.span == [0.0, 1.0] {
            &self.with.first
        } else {
            let n = as_f64(section.curve.degree());
            let pairs = section.curve.control_points().windows(2);
            steps = pairs.map(|pair| (pair[1] - pair[0]) * n).collect();
            &steps
        };
        // The curvature κ at which 1 − r′² − r r″ − rκ would be 0; the factor √(1 − r′²) of rκ is at most 1.
        let limit = (MAX_REGULAR_SUM - slope * slope - radius * change) / radius;
        limit > 0.0 && is_less_curved(derivative, limit)
    }

    /// The discs with which a cubic is compared in an interval.
    pub(super) fn compared(&self, [a, b]: [f64; 2]) -> Compared<Disc> {
        let discs = || CHEBYSHEV_NODES.map(|part| self.at(a + (b - a) * part));
        if [a, b] == [0.0, 1.0] {
            *self.compared.get_or_init(discs)
        } else {
            discs()
        }
    }

    /// The first two derivatives by the parameter of the section.
    fn derivatives(&self, t: f64) -> [DVec2; 2] {
        let width = self.section.width();
        let [first, second] = self.with.derivatives(self.section.parameter(t));
        [first * width, second * (width * width)]
    }

    pub(super) fn at(&self, t: f64) -> Disc {
        self.evaluate(t).0
    }

    /// 1 − r′², which is negative where one disc contains the others, and the speeds of the left and the right side by arc
    /// length of the curve, times √(1 − r′²): 1 − r′² − r r″ ∓ rκ √(1 − r′²). These are negative where the side runs
    /// backwards.
    pub(super) fn side_speeds(&self, t: f64) -> [f64; 3] {
        let [first, second] = self.derivatives(t);
        self.section.rates(t, first, second).side_speeds()
    }

    /// The disc together with [`side_speeds`](Self::side_speeds).
    pub(super) fn evaluate(&self, t: f64) -> (Disc, [f64; 3]) {
        let center = self.with.at(self.section.parameter(t));
        let [first, second] = self.derivatives(t);
        let rates = self.section.rates(t, first, second);
        (self.section.disc(t, center, &rates), rates.side_speeds())
    }

    /// The [`side_speeds`](Self::side_speeds) at regular parameters, at those where the curve is slowest, next to tight
    /// turns, and at parameters that approach these: r′ and the curvature change there within |B′|/|B″|. Empty if bounds
    /// show that no value changes its sign.
    pub(super) fn samples(&self) -> SideSpeedSamples {
        if self.is_proved_regular() {
            return SideSpeedSamples(Vec::new());
        }
        let count = SAMPLES_PER_DEGREE * self.section.curve.degree();
        let at = |k: usize| as_f64(k) / as_f64(count);
        let mut samples = Vec::with_capacity(2 * count);
        let mut insert = |t: f64, [first, second]: [DVec2; 2]| {
            let values = self.section.rates(t, first, second).side_speeds();
            if values.iter().all(|value| value.is_finite()) {
                let after = samples.partition_point(|&(other, _)| other < t);
                samples.insert(after, (t, values));
            }
        };
        let mut squares = Vec::with_capacity(count + 1);
        for k in 0..=count {
            let derivatives = self.derivatives(at(k));
            squares.push(derivatives[0].dot(derivatives[0]));
            insert(at(k), derivatives);
        }
        for k in 0..=count {
            let [before, after] = [k.saturating_sub(1), (k + 1).min(count)];
            if squares[k] > smaller(squares[before], squares[after]) {
                continue;
            }
            let slowest = slowest_near(|t| self.derivatives(t), at(k), [at(before), at(after)]);
            let [first, second] = self.derivatives(slowest);
            if slowest != at(k) {
                insert(slowest, [first, second]);
            }
            let speed = Point::norm(first);
            let is_cusp = speed == 0.0 && (slowest == 0.0 || slowest == 1.0);
            // The curvature alone has one extremum at a tight turn.
            let is_tight_turn = speed > 0.0 && !self.section.radius.is_constant();
            if !is_cusp && !is_tight_turn {
                continue;
            }
            let least = (APPROACH_FACTOR * speed / Point::norm(second)).max(ROUNDING);
            let mut step = APPROACH_FACTOR * at(1);
            while step > least {
                for t in [slowest - step, slowest + step] {
                    if (0.0..=1.0).contains(&t) {
                        insert(t, self.derivatives(t));
                    }
                }
                step *= APPROACH_FACTOR;
            }
        }
        SideSpeedSamples(samples)
    }

    /// The intervals of one side, in order; `ends` are the discs at the ends of the section.
    pub(super) fn side_intervals(
        &self,
        samples: &SideSpeedSamples,
        side: f64,
        ends: [Disc; 2],
    ) -> List<SideInterval, 1> {
        let mut intervals: List<SideInterval, 1> = List::new();
        let mut push = |span: [f64; 2]| {
            let kind = self.kind(span, samples, side);
            match intervals.last_mut() {
                Some(last) if last.kind == kind => last.span[1] = span[1],
                _ => intervals.push(SideInterval { span, ends, kind }),
            }
        };
        if samples.0.is_empty() {
            push([0.0, 1.0]);
            return intervals;
        }
        let mut breaks = Breaks::new();
        if !self.section.radius.is_constant() {
            self.push_zeros(samples, 0, &mut breaks);
        }
        self.push_zeros(samples, speed_index(side), &mut breaks);
        sort_with_ends(&mut breaks);
        for pair in breaks.windows(2) {
            push([pair[0], pair[1]]);
        }
        extend_backward(&mut intervals);
        for k in 1..intervals.len() {
            let mut disc = self.at(intervals[k].span[0]);
            // Beside discs that one contains, both sides are at the same point: r′ is exactly 1 or −1. The radius is
            // monotone in a section.
            if [k - 1, k]
                .iter()
                .any(|&k| intervals[k].kind == SideKind::Inside)
            {
                disc.slope = ends[0].contained_slope(&ends[1]);
            }
            intervals[k - 1].ends[1] = disc;
            intervals[k].ends[0] = disc;
        }
        intervals
    }

    /// What a side does in most of an interval between two zeros that were found: there may be others between samples, where
    /// a value is almost 0.
    fn kind(&self, span: [f64; 2], samples: &SideSpeedSamples, side: f64) -> SideKind {
        if self.section.radius.is_zero() {
            return SideKind::Inside;
        }
        if samples.0.is_empty() {
            return SideKind::Forward;
        }
        let is_mostly_up_to = |which: usize, limit: f64| {
            samples
                .is_mostly_up_to(span, which, limit)
                .unwrap_or_else(|| self.side_speeds(0.5 * (span[0] + span[1]))[which] <= limit)
        };
        if !self.section.radius.is_constant() && is_mostly_up_to(0, 0.0) {
            SideKind::Inside
        } else if is_mostly_up_to(speed_index(side), -ROUNDING) {
            SideKind::Backward
        } else {
            SideKind::Forward
        }
    }

    /// Appends the parameters at which one of the [`side_speeds`](Self::side_speeds) changes its sign.
    fn push_zeros(&self, samples: &SideSpeedSamples, which: usize, breaks: &mut Breaks) {
        // The speed may be 0 at an end.
        let value = |t: f64| self.side_speeds(t)[which];
        let mut last: Option<(f64, f64)> = None;
        for &(t, ref values) in &samples.0 {
            let found = values[which];
            if found.abs() <= ROUNDING {
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

/// Parameters with their [`side_speeds`](SectionEvaluator::side_speeds), which is finite.
pub(super) struct SideSpeedSamples(Vec<(f64, [f64; 3])>);

impl SideSpeedSamples {
    /// Whether a value is at most a limit in most of an interval; `None` without samples inside.
    fn is_mostly_up_to(&self, [from, to]: [f64; 2], which: usize, limit: f64) -> Option<bool> {
        let first = self.0.partition_point(|&(t, _)| t <= from);
        let end = self.0.partition_point(|&(t, _)| t < to);
        let is_below = |k: usize| self.0[k].1[which] <= limit;
        if !(first..end).any(is_below) {
            return (first < end).then_some(false);
        }
        // Each sample counts with the distance between its neighbours.
        let (mut below, mut others) = (0.0, 0.0);
        for k in first..end {
            let before = k.checked_sub(1).map_or(from, |k| larger(self.0[k].0, from));
            let after = self.0.get(k + 1).map_or(to, |next| smaller(next.0, to));
            if is_below(k) {
                below += after - before;
            } else {
                others += after - before;
            }
        }
        Some(below > others)
    }
}

/// Which of the [`side_speeds`](SectionEvaluator::side_speeds) is negative where a side runs backwards.
pub(super) fn speed_index(side: f64) -> usize {
    if side == LEFT { 1 } else { 2 }
}

/// Moves the ends of intervals that run backwards into those that run forward next to them.
fn extend_backward(intervals: &mut List<SideInterval, 1>) {
    for k in 1..intervals.len() {
        let [before, after] = [intervals[k - 1], intervals[k]];
        let end = before.span[1];
        let moved = match (before.kind, after.kind) {
            (SideKind::Forward, SideKind::Backward) => {
                (end - BACKWARD_MARGIN * (after.span[1] - end)).max(before.span[0])
            }
            (SideKind::Backward, SideKind::Forward) => {
                (end + BACKWARD_MARGIN * (end - before.span[0])).min(after.span[1])
            }
            _ => end,
        };
        intervals[k - 1].span[1] = moved;
        intervals[k].span[0] = moved;
    }
    intervals.retain(|interval| interval.span[0] < interval.span[1]);
}

/// The parameter of the smallest speed near another one.
fn slowest_near(derivatives: impl Fn(f64) -> [DVec2; 2], mut t: f64, [from, to]: [f64; 2]) -> f64 {
    for _ in 0..NEWTON_STEPS {
        let [first, second] = derivatives(t);
        let square = second.dot(second);
        let next = (t - first.dot(second) / square).clamp(from, to);
        if square == 0.0 || next == t {
            break;
        }
        t = next;
    }
    t
}

/// Sorts parameters, removes those that are equal to others or to an end, and adds both ends.
pub(super) fn sort_with_ends(ts: &mut Breaks) {
    if ts.is_empty() {
        return ts.extend([0.0, 1.0]);
    }
    ts.retain(|t| *t > ROUNDING && *t < 1.0 - ROUNDING);
    ts.sort_by(f64::total_cmp);
    ts.dedup_by(|next, last| *next - *last <= ROUNDING);
    ts.insert(0, 0.0);
    ts.push(1.0);
}
