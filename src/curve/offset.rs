//! Which curve runs beside?
//!
//! The parallel at a distance d is O(t) = B(t) + d·N(t), N being the tangent turned by +90°. It is no Bézier curve in
//! general, so cubics take its place, within a tolerance. It goes on where the curve bends too sharply for it: there
//! O′ = (1 − κd)·B′ changes its direction and O has a cusp (it runs back and forth in a swallowtail; nothing is trimmed).
//! Where the curve itself turns back, at a cusp or at an end of a straight way back and forth, N jumps to the other
//! side; a half circle about that point, around its outside, leads from one to the other.

use super::Curve;
use crate::geometry::check::check_tolerance;
use crate::geometry::error::Error;
use crate::geometry::point::Point;
use crate::numeric::float::ulp;
use crate::spline::Spline;
use casteljau_kernels::{OffsetCurve, Plane, Source, WorkLimit, arc_pieces, cos_sin};
use glam::DVec2;
use std::f64::consts::PI;

/// The tolerance by default, as a part of the diagonal of the control points' box.
const DEFAULT_RATIO: f64 = 1e-4;

/// And at least this part of the largest coordinate and the distance.
const MIN_DEFAULT: f64 = 1e-12;

/// What rounding leaves of a distance, as a part of it and the curve's size.
const ROUNDING: f64 = 16.0 * f64::EPSILON;

/// The most steps for one curve: pieces tried and bounds evaluated. A cubic at a tolerance of 10⁻¹² of its size takes
/// some thousands.
const MAX_STEPS: usize = 1 << 17;

/// The part of the tolerance that the pieces may use; the rest is for rounding.
const FITTED_PART: f64 = 1.0 - 1.0 / 256.0;

/// Up to this distance, in sizes of the curve, its own size is told from a point: beyond, it is far below an ulp.
const FARTHEST: f64 = 1e30;

impl Curve<DVec2> {
    /// The parallel curve at a distance along the normal, as a spline of lines and cubics.
    ///
    /// O(t) = B(t) + d·N(t), N the tangent turned by +90°; a negative distance lies on the other side. `tolerance`
    /// is the greatest distance from any point of O to the spline and from any point of the spline to O, in the
    /// input's unit; by default 10⁻⁴ of the diagonal of the control points' box, and at least 10⁻¹² of the largest coordinate
    /// plus the distance. Ends and end tangents are exact, and
    /// the pieces share their ends.
    ///
    /// Where |κd| passes 1 the parallel has a cusp, and so has the spline; nothing is trimmed. Where the curve turns
    /// back (a cusp, a straight way back and forth) a half circle about that point joins the two sides. Lines stay
    /// lines. Where the derivative is so small that rounding it moves the offset by more than the tolerance, the tolerance
    /// holds for a curve with control points that differ by rounding. A distance of 0 gives the curve itself. A curve that is a point has no normal: it comes back as it is.
    ///
    /// # Errors
    /// [`Error::Range`] for a distance that is not finite, or with which coordinates would not be, and unless the
    /// tolerance is above 0; [`Error::Tolerance`] when it is below 4 ulps of the largest coordinate and the distance;
    /// [`Error::TooMany`] when more than 2¹⁷ steps (pieces tried and bounds evaluated) would be needed.
    ///
    /// Source: Levien, "OffsetCurve curves of cubic Béziers" (2022), for the idea; the bound on the distance is ours.
    pub fn offset(&self, distance: f64, tolerance: Option<f64>) -> Result<Spline<DVec2>, Error> {
        self.offset_builder(distance, tolerance)
            .map(SplineBuilder::spline)
    }

    /// As [`offset`](Self::offset), not yet a spline.
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

/// Refuses what cannot be done; the tolerance that was given or that of a size.
pub(crate) fn offset_tolerance(
    distance: f64,
    requested: Option<f64>,
    largest: f64,
    diagonal: impl FnOnce() -> f64,
) -> Result<f64, Error> {
    let reach = largest + distance.abs();
    if !(reach * 4.0).is_finite() {
        return Err(Error::Range {
            what: "distance",
            expected: "a finite number, and coordinates that stay finite",
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

/// A spline in the making: its points, and the degree of each segment.
#[derive(Default)]
pub(crate) struct SplineBuilder {
    pub(crate) points: Vec<DVec2>,
    pub(crate) degrees: Vec<usize>,
    pub(crate) closed: bool,
}

impl SplineBuilder {
    pub(crate) fn spline(self) -> Spline<DVec2> {
        Spline::from_parts(self.points, &self.degrees, self.closed)
    }

    /// The start, unless the chain has one.
    fn start(&mut self, p: DVec2) {
        if self.points.is_empty() {
            self.points.push(p);
        }
    }

    pub(crate) fn line_to(&mut self, p: DVec2) {
        self.points.push(p);
        self.degrees.push(1);
    }

    /// Appends the parallel of a curve; a chain that is not empty ends at its start.
    pub(crate) fn add_offset(
        &mut self,
        curve: &Curve<DVec2>,
        distance: f64,
        tolerance: f64,
    ) -> Result<(), Error> {
        let reach = farthest(curve);
        if distance == 0.0 || reach == 0.0 {
            self.start(curve.start());
            self.points.extend(&curve.points[1..]);
            self.degrees.push(curve.degree());
        } else if let Some(direction) = curve.straight_direction() {
            self.add_offset_of_straight(curve, direction, distance, tolerance);
        } else {
            NormalizedCurve::new(curve, reach, distance, tolerance).add_to(self)?;
        }
        Ok(())
    }

    /// Lines there and back, and half circles about the points where the curve turns.
    fn add_offset_of_straight(
        &mut self,
        curve: &Curve<DVec2>,
        direction: DVec2,
        distance: f64,
        tolerance: f64,
    ) {
        let mut turns = curve.turns_along(direction);
        turns.push(1.0);
        // Signs are those of the derivative: points that differ may be equal when rounded.
        let mut runs: Vec<(DVec2, DVec2, f64)> = Vec::new();
        let (mut t, mut from) = (0.0, curve.start());
        for &next in &turns {
            let to = if next < 1.0 {
                curve.eval(next)
            } else {
                curve.end()
            };
            let sign = curve.sign_along(direction, 0.5 * (t + next));
            match runs.last_mut() {
                _ if sign == 0.0 => {}
                Some((_, end, last)) if *last == sign => *end = to,
                _ => runs.push((from, to, sign)),
            }
            (t, from) = (next, to);
        }
        for (k, &(from, to, sign)) in runs.iter().enumerate() {
            let normal = direction.perp() * sign;
            if k > 0 {
                self.turn(
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

    /// Appends an arc about a point, as the normal turns from one tangent to another by at most 180°; a full half turn
    /// goes around the outside.
    pub(crate) fn turn(
        &mut self,
        about: DVec2,
        from: DVec2,
        to: DVec2,
        distance: f64,
        tolerance: f64,
    ) {
        let (sin, cos) = (from.perp_dot(to), from.dot(to));
        let reversed = cos < 0.0 && sin.abs() <= REVERSED_SINE;
        let angle = if reversed {
            -PI.copysign(distance)
        } else {
            sin.atan2(cos)
        };
        let pieces = arc_pieces(angle, distance.abs(), tolerance);
        let (cos, sin) = cos_sin(0.25 * angle / pieces);
        let handle = distance * (4.0 / 3.0) * (sin / cos);
        let tangent = |k: f64| {
            if k == pieces {
                to
            } else {
                let (cos, sin) = cos_sin(angle * (k / pieces));
                DVec2::new(cos, sin).rotate(from)
            }
        };
        let at = |tangent: DVec2| about + tangent.perp() * distance;
        let mut k = 0.0;
        while k < pieces {
            let (t0, t1) = (tangent(k), tangent(k + 1.0));
            self.points
                .extend([at(t0) - t0 * handle, at(t1) + t1 * handle, at(t1)]);
            self.degrees.push(3);
            k += 1.0;
        }
    }
}

/// Tangents this close to opposite, as a sine, are opposite: rounding of unit vectors.
const REVERSED_SINE: f64 = 1e-12;

/// A curve that bends, scaled to a size of about 1.
struct NormalizedCurve<'a> {
    curve: &'a Curve<DVec2>,
    source: Source,
    distance: f64,
    tolerance: f64,
    /// The distance and the tolerance as scaled.
    scaled: (f64, f64),
    /// Back to the caller's unit.
    unit: f64,
}

impl<'a> NormalizedCurve<'a> {
    fn new(curve: &'a Curve<DVec2>, reach: f64, distance: f64, tolerance: f64) -> Self {
        let scale = power_of_two(reach);
        let points: crate::numeric::list::Points<DVec2> =
            curve.points.iter().map(|&p| p * scale).collect();
        let scaled = (distance * scale).clamp(-FARTHEST, FARTHEST);
        let unit = if scaled.abs() < FARTHEST {
            1.0 / scale
        } else {
            (distance / scaled).abs()
        };
        Self {
            curve,
            source: Source::new(bytemuck::cast_slice(&points)),
            distance,
            tolerance,
            // Distances cannot be told to less than rounding.
            scaled: (
                scaled,
                (FITTED_PART * tolerance / unit).max(ROUNDING * (1.0 + scaled.abs())),
            ),
            unit,
        }
    }

    fn add_to(&self, builder: &mut SplineBuilder) -> Result<(), Error> {
        let mut work = WorkLimit::new(MAX_STEPS);
        let [first, last] = self.source.end_tangents();
        let (mut t, mut tangent) = (0.0, first);
        for cusp in self.source.cusps() {
            let (before, after) = self.source.cusp_tangents(cusp);
            let about = self.curve.eval(cusp);
            self.add_run(builder, (t, cusp), [tangent, before], about, &mut work);
            builder.turn(
                about,
                vector(before),
                vector(after),
                self.distance,
                self.tolerance,
            );
            (t, tangent) = (cusp, after);
        }
        self.add_run(
            builder,
            (t, 1.0),
            [tangent, last],
            self.curve.end(),
            &mut work,
        );
        if work.is_exceeded() {
            return Err(Error::TooMany {
                what: "steps of an offset",
                limit: MAX_STEPS,
                needed: work.used(),
            });
        }
        Ok(())
    }

    /// A piece between two cusps of the curve.
    fn add_run(
        &self,
        builder: &mut SplineBuilder,
        ts: (f64, f64),
        tangents: [Plane; 2],
        end: DVec2,
        work: &mut WorkLimit,
    ) {
        let normal = |tangent: Plane| vector(tangent).perp() * self.distance;
        if ts.0 == 0.0 {
            builder.start(self.curve.start() + normal(tangents[0]));
        }
        let mut out = Vec::with_capacity(12);
        OffsetCurve::new(&self.source, self.scaled.0, self.scaled.1)
            .run(ts, tangents, &mut out, work);
        let origin = self.curve.start();
        let position = |p: &Plane| vector(*p) * self.unit + origin;
        builder.points.extend(out.iter().map(position));
        builder
            .degrees
            .extend(std::iter::repeat_n(3, out.len() / 3));
        // Not what scaling has left of it.
        if let Some(p) = builder.points.last_mut() {
            *p = end + normal(tangents[1]);
        }
    }
}

fn vector(p: Plane) -> DVec2 {
    DVec2::new(p.x, p.y)
}

/// The greatest difference of a coordinate from the start.
fn farthest(curve: &Curve<DVec2>) -> f64 {
    let start = curve.start() * 0.5;
    let half = curve
        .control_points()
        .iter()
        .fold(0.0, |m: f64, &p| m.max(Point::max_abs(p * 0.5 - start)));
    2.0 * half.min(f64::MAX / 4.0)
}

/// About 1/x, a power of two whose inverse is finite.
fn power_of_two(x: f64) -> f64 {
    (-x.log2().round()).clamp(-1000.0, 1000.0).exp2()
}
