//! Offset curves of a curve.
//!
//! The offset curve at a distance d is O(t) = B(t) + d·N(t), with N the tangent rotated by +90°. In general it is not a
//! Bézier curve, so cubics approximate it within a tolerance. The offset continues where |κd| exceeds 1: there O′ = (1
//! − κd)·B′ reverses its direction and O has cusps (a swallowtail; nothing is trimmed). Where the curve itself
//! reverses, at a cusp or at a turn of a straight curve, N jumps to the other side; a half circle about that point,
//! around its outside, joins the two sides.

use crate::curve::Curve;
use crate::curve::hodograph::{derivative_zeros, first_step};
use crate::geometry::check::{MAX_COORDINATE, check_tolerance};
use crate::geometry::error::Error;
use crate::geometry::point::Point;
use crate::numeric::float::{ulp, unit_scale};
use crate::numeric::list::Points;
use crate::spline::Spline;
use crate::spline::spline_builder::SplineBuilder;
use casteljau_kernels::numeric::vector::Euclidean;
use casteljau_kernels::numeric::work_limit::WorkLimit;
use casteljau_kernels::spline::offset::offset_curve::{OffsetCurve, Source, add_arc};
use glam::DVec2;
use std::f64::consts::PI;

/// The default tolerance, as a part of the diagonal of the control points' box.
const DEFAULT_RATIO: f64 = 1e-4;

/// The default tolerance is at least this part of the largest coordinate plus the distance.
const MIN_DEFAULT: f64 = 1e-12;

/// Rounding error of a distance, relative to the distance and the size of the curve.
const ROUNDING: f64 = 16.0 * f64::EPSILON;

/// Maximum number of steps for one curve: attempted pieces and evaluated bounds. A cubic at a tolerance of 10⁻¹² of its
/// size takes some thousands.
const MAX_STEPS: usize = 1 << 17;

/// The part of the tolerance for the approximation. The rest is for rounding of the control points: an ulp of the
/// coordinates if the tolerance is 256 ulps.
const FITTED_PART: f64 = 1.0 - 1.0 / 256.0;

/// Larger distances, in sizes of the curve, are clamped to this one: beyond it the curve is far smaller than an ulp of
/// the offset.
const MAX_DISTANCE: f64 = 1e30;

impl Curve<DVec2> {
    /// The offset curve at a distance along the normal, as a spline of lines and cubics.
    ///
    /// O(t) = B(t) + d·N(t), with N the tangent rotated by +90°; a negative distance gives the other side. The maximum
    /// distance from any point of O to the spline and from any point of the spline to O is 10⁻⁴ of the diagonal of the
    /// control points' box, and at least 10⁻¹² of the largest coordinate plus the distance;
    /// [`offset_within`](Self::offset_within) sets another one. End points and end tangents are exact, and adjacent
    /// pieces share their ends.
    ///
    /// Where |κd| passes 1 the offset curve has a cusp, and so has the spline; nothing is trimmed. Where the curve
    /// reverses (a cusp, a turn of a straight curve), a half circle about that point joins the two sides. Lines stay
    /// lines. Where the derivative is so small that its rounding moves the offset by more than the tolerance, the
    /// tolerance holds for a curve whose control points differ by rounding. A distance of 0 gives the curve itself. A
    /// curve that is a point has no normal and is returned unchanged.
    ///
    /// # Errors
    /// [`Error::Range`] for a distance that is not finite or makes coordinates infinite; [`Error::TooMany`] if more than 2¹⁷ steps (attempted pieces and evaluated bounds) would be needed.
    ///
    /// Source: Levien, "Parallel curves of cubic Béziers" (2022), for the idea; the bound on the distance is our own.
    pub fn offset(&self, distance: f64) -> Result<Spline<DVec2>, Error> {
        self.offset_builder(distance, None)
            .map(SplineBuilder::spline)
    }

    /// [`offset`](Self::offset) with a maximum distance from the exact offset curve, in the unit of the points.
    ///
    /// # Errors
    /// Also [`Error::Range`] for a tolerance that is not above 0, and [`Error::Tolerance`] for one below 4 ulps of the
    /// largest coordinate plus the distance.
    pub fn offset_within(&self, distance: f64, tolerance: f64) -> Result<Spline<DVec2>, Error> {
        self.offset_builder(distance, Some(tolerance))
            .map(SplineBuilder::spline)
    }

    /// [`offset`](Self::offset) with an optional tolerance, as the builder of the spline.
    pub(crate) fn offset_builder(
        &self,
        distance: f64,
        tolerance: Option<f64>,
    ) -> Result<SplineBuilder, Error> {
        let diagonal = || self.control_bounds().diagonal();
        let tolerance = offset_tolerance(distance, tolerance, self.max_abs(), diagonal)?;
        let mut builder = SplineBuilder::default();
        builder.add_offset(self, distance, tolerance)?;
        Ok(builder)
    }
}

/// The given tolerance after its checks, or the default for the size of the curve; returns an error for an invalid
/// distance or tolerance.
pub(crate) fn offset_tolerance(
    distance: f64,
    requested: Option<f64>,
    largest: f64,
    diagonal: impl FnOnce() -> f64,
) -> Result<f64, Error> {
    let reach = largest + distance.abs();
    if !(..=MAX_COORDINATE).contains(&(reach * 4.0)) {
        return Err(Error::Range {
            what: "distance",
            expected: "a finite number, and coordinates that stay below 2^498",
            got: distance,
        });
    }
    match requested {
        Some(tolerance) => check_tolerance(tolerance, reach).map(|()| tolerance),
        None => Ok((DEFAULT_RATIO * diagonal())
            .max(MIN_DEFAULT * reach)
            .max(4.0 * ulp(reach))),
    }
}

impl SplineBuilder {
    /// Appends the offset curve of a curve. A spline that is not empty ends at the start of that offset curve.
    pub(crate) fn add_offset(
        &mut self,
        curve: &Curve<DVec2>,
        distance: f64,
        tolerance: f64,
    ) -> Result<(), Error> {
        let reach = max_difference(curve);
        if distance == 0.0 || reach == 0.0 {
            self.start(curve.start());
            self.points.extend(&curve.control_points()[1..]);
            self.degrees.push(curve.degree());
        } else if let Some(direction) = curve.straight_direction() {
            self.add_offset_of_straight(curve, direction, distance, tolerance);
        } else {
            NormalizedCurve::new(curve, reach, distance, tolerance).add_to(self, true)?;
        }
        Ok(())
    }

    /// Appends the offset of a straight curve: lines in both directions, and half circles about the points where the
    /// curve reverses.
    fn add_offset_of_straight(
        &mut self,
        curve: &Curve<DVec2>,
        direction: DVec2,
        distance: f64,
        tolerance: f64,
    ) {
        let mut reversals = curve.turns_along(direction);
        reversals.push(1.0);
        // The signs come from the derivative, because different points may be equal after rounding.
        let mut runs: Vec<(DVec2, DVec2, f64)> = Vec::new();
        let (mut t, mut from) = (0.0, curve.start());
        for &next in &reversals {
            let to = if next < 1.0 {
                curve.eval(next)
            } else {
                curve.end()
            };
            let sign = sign_between(curve, direction, t, next);
            match runs.last_mut() {
                _ if sign == 0.0 => {}
                Some((_, end, last)) if *last == sign => *end = to,
                _ => runs.push((from, to, sign)),
            }
            (t, from) = (next, to);
        }
        if runs.is_empty() {
            runs.push((curve.start(), curve.end(), 1.0)); // all signs of the derivative are rounding errors
        }
        for (k, &(from, to, sign)) in runs.iter().enumerate() {
            let normal = direction.perp() * sign;
            if k > 0 {
                self.add_arc_about(
                    from,
                    -direction * sign,
                    direction * sign,
                    distance,
                    tolerance,
                );
            }
            self.start(from + normal * distance);
            self.line_to(to + normal * distance);
        }
    }

    /// Appends an arc about a point, as the normal rotates from one tangent to another by at most 180°. A half turn
    /// goes around the outside.
    pub(crate) fn add_arc_about(
        &mut self,
        center: DVec2,
        from: DVec2,
        to: DVec2,
        distance: f64,
        tolerance: f64,
    ) {
        let (sin, cos) = (from.perp_dot(to), from.dot(to));
        // On the outside of a half turn the tangent rotates clockwise for a positive distance.
        let reversed = cos < 0.0 && sin.abs() <= REVERSED_SINE;
        let angle = if reversed {
            -PI.copysign(distance)
        } else {
            sin.atan2(cos)
        };
        let before = self.points.len();
        add_arc(
            [center; 2],
            [from, to],
            angle,
            distance,
            tolerance,
            &mut self.points,
        );
        let pieces = (self.points.len() - before) / 3;
        self.degrees.extend(std::iter::repeat_n(3, pieces));
    }
}

#[cfg(feature = "regions")]
impl SplineBuilder {
    /// [`add_offset`](Self::add_offset) for a distance other than 0 and a curve that is not straight, if neither the curve
    /// nor its offset curve has a cusp.
    pub(crate) fn add_smooth_offset(
        &mut self,
        curve: &Curve<DVec2>,
        distance: f64,
        tolerance: f64,
    ) -> Result<(), Error> {
        NormalizedCurve::new(curve, max_difference(curve), distance, tolerance).add_to(self, false)
    }
}

/// Where the sign of a derivative is evaluated between two of its zeros, as parts of the interval: at the first ones the
/// derivative may be zero without a change of its sign.
const INSIDE: [f64; 4] = [0.5, 0.382, 0.7, 0.1];

/// The sign of the derivative of a straight curve between two reversals; 0 if it stands still.
fn sign_between(curve: &Curve<DVec2>, direction: DVec2, t0: f64, t1: f64) -> f64 {
    let signs = INSIDE.map(|part| curve.sign_along(direction, t0 + part * (t1 - t0)));
    signs.into_iter().find(|&sign| sign != 0.0).unwrap_or(0.0)
}

/// Tangents whose angle differs from 180° by at most this sine count as opposite; this is the rounding of unit vectors.
const REVERSED_SINE: f64 = 1e-12;

/// A handle of at most this part of the largest |B′| has no direction, because rounding moves its end by as much.
const NO_HANDLE: f64 = 1e-15;

/// A curve that is not straight, scaled to a size of about 1.
struct NormalizedCurve<'a> {
    curve: &'a Curve<DVec2>,
    /// Its scaled control points.
    points: Points<DVec2>,
    source: Source,
    /// The unit tangents at the start and at the end.
    tangents: [DVec2; 2],
    distance: f64,
    tolerance: f64,
    /// The scaled distance and tolerance.
    scaled: (f64, f64),
    /// The factor back to the unit of the caller.
    unit: f64,
}

impl<'a> NormalizedCurve<'a> {
    fn new(curve: &'a Curve<DVec2>, reach: f64, distance: f64, tolerance: f64) -> Self {
        let scale = unit_scale(reach);
        let scaled_points = curve.control_points().iter().map(|&p| p * scale);
        let points: Points<DVec2> = scaled_points.collect();
        let scaled = (distance * scale).clamp(-MAX_DISTANCE, MAX_DISTANCE);
        // For a clamped distance, the unit maps the clamped distance to the given one.
        let unit = if scaled.abs() < MAX_DISTANCE {
            1.0 / scale
        } else {
            (distance / scaled).abs()
        };
        let source = Source::new(&points);
        let is_far = |v: &DVec2| Point::norm(*v) > NO_HANDLE * source.speed();
        let steps = [
            first_step(points[0], points.iter(), is_far),
            -first_step(points[curve.degree()], points.iter().rev(), is_far),
        ];
        Self {
            curve,
            points,
            source,
            tangents: steps.map(Euclidean::unit),
            distance,
            tolerance,
            // The tolerance is at least the rounding of distances.
            scaled: (
                scaled,
                (FITTED_PART * tolerance / unit).max(ROUNDING * (1.0 + scaled.abs())),
            ),
            unit,
        }
    }

    fn add_to(&self, builder: &mut SplineBuilder, may_have_cusps: bool) -> Result<(), Error> {
        let mut work = WorkLimit::new(MAX_STEPS);
        let [first, last] = self.tangents;
        let (mut t, mut tangent) = (0.0, first);
        let cusps = may_have_cusps.then(|| {
            let zeros = derivative_zeros(&self.points);
            self.source.cusps(&zeros)
        });
        for cusp in cusps.into_iter().flatten() {
            let (before, after) = self.source.cusp_tangents(cusp);
            let center = self.curve.eval(cusp);
            let ends = ((t, cusp), [tangent, before], center);
            self.add_run(builder, ends, may_have_cusps, &mut work);
            builder.add_arc_about(center, before, after, self.distance, self.tolerance);
            (t, tangent) = (cusp, after);
        }
        let ends = ((t, 1.0), [tangent, last], self.curve.end());
        self.add_run(builder, ends, may_have_cusps, &mut work);
        Error::unless_within("steps of an offset", &work)
    }

    /// Appends the offset of the curve between two cusps, from its parameters and tangents there and its end. Cusps of the
    /// offset curve are found first if there may be some.
    fn add_run(
        &self,
        builder: &mut SplineBuilder,
        (ts, tangents, end): ((f64, f64), [DVec2; 2], DVec2),
        may_have_cusps: bool,
        work: &mut WorkLimit,
    ) {
        let normal = |tangent: DVec2| tangent.perp() * self.distance;
        if ts.0 == 0.0 {
            builder.start(self.curve.start() + normal(tangents[0]));
        }
        let mut out = Vec::with_capacity(12);
        OffsetCurve::new(&self.source, self.scaled.0, self.scaled.1).run(
            ts,
            tangents,
            may_have_cusps,
            &mut out,
            work,
        );
        let origin = self.curve.start();
        let position = |&p: &DVec2| p * self.unit + origin;
        builder.points.extend(out.iter().map(position));
        builder
            .degrees
            .extend(std::iter::repeat_n(3, out.len() / 3));
        // The exact end point, without the rounding of the scaling.
        if let Some(p) = builder.points.last_mut() {
            *p = end + normal(tangents[1]);
        }
    }
}

/// The largest difference of a coordinate from that of the start.
fn max_difference(curve: &Curve<DVec2>) -> f64 {
    // The difference of two coordinates may overflow, that of their halves does not.
    let start = curve.start() * 0.5;
    let half = curve
        .control_points()
        .iter()
        .fold(0.0, |m: f64, &p| m.max(Point::max_abs(p * 0.5 - start)));
    2.0 * half.min(f64::MAX / 4.0)
}
