//! Which way up, along a curve in space? Frames that turn as little as can be.
//!
//! The principal normal jumps at inflections and is not there on straight pieces. A *rotation-minimising* frame has the
//! same tangent and does not turn about it: its normal moves only as the tangent makes it. Carrying it over a short step
//! by two reflections errs with the fifth power of the step; steps are halved until that no longer shows. Source: Wang,
//! Jüttler, Zheng and Liu, "Computation of rotation minimizing frames", ACM Transactions on Graphics 27 (2008).

use super::Curve;
use super::eval::check_segments;
use crate::bernstein::evaluate::evaluate;
use crate::curve::arc_length::length::hodograph;
use crate::geometry::error::Error;
use crate::geometry::point::Point;
use crate::numeric::float::ratio;
use casteljau_kernels::WorkLimit;
use glam::DVec3;

/// A step is short enough when the normal moves by less than this if it is halved; what is left is some 20 times less.
const CARRIED_APART: f64 = 1e-10;

/// The cosine of the angle, 60°, that the tangent may turn in half a step.
const GENTLE_COSINE: f64 = 0.5;

/// A step so short in t that still turns sharply goes over a cusp.
const CUSP_STEP: f64 = 1e-10;

/// Below this cosine the tangent counts as turned back.
const BACK_COSINE: f64 = -0.9;

/// A speed above this part of the greatest has a direction of its own; below, the limit is asked for.
const CLEAR_SPEED: f64 = 1e-6;

/// A chord below this is rounding; over so short a way the tangent all but goes straight to its new direction.
const MIN_DISPLACEMENT: f64 = 1e-10;

/// Derivatives count as parallel when the sine of their angle is below this.
const PARALLELISM_SINE: f64 = 1e-9;

/// Halvings of all ways together, and so many more for each frame: more than ten times what moderate curves need.
const MAX_HALVINGS: usize = 1 << 12;
const MAX_HALVINGS_PER_FRAME: usize = 64;

/// A place on a curve in space with three directions at right angles, each of length 1.
///
/// The binormal is tangent × normal. Of a curve that is a point the directions are zero.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(rename_all = "camelCase")
)]
pub struct Frame {
    /// The parameter.
    pub t: f64,
    /// The point of the curve.
    pub point: DVec3,
    /// The unit tangent.
    pub tangent: DVec3,
    /// The direction that turns as little as can be.
    pub normal: DVec3,
    /// Tangent × normal.
    pub binormal: DVec3,
}

impl Curve<DVec3> {
    /// `segments` + 1 rotation-minimising frames at t = i / `segments`.
    ///
    /// As [`frames_at`](Self::frames_at) with even steps of t and no wish for the first normal.
    ///
    /// # Errors
    /// [`Error::Range`] for 0 segments, [`Error::TooMany`] above 1 GiB of numbers.
    pub fn frames(&self, segments: usize) -> Result<Vec<Frame>, Error> {
        check_segments(segments, FRAME_NUMBERS)?;
        let ts: Vec<f64> = (0..=segments).map(|i| ratio(i, segments)).collect();
        self.frames_at(&ts, None)
    }

    /// Rotation-minimising frames at the given parameters, each carried on from the one before.
    ///
    /// N′ = −(N·T′) T: the normal does not turn about the tangent, to 10⁻⁹ however few frames are asked for. The first
    /// normal is what of `normal` is at right angles to the tangent; without it, or where nothing is left, the principal
    /// normal there; on a straight piece the axis that is farthest from the tangent, made so. Straight pieces and inflections
    /// change nothing; over a cusp the frame turns by 180° in the plane of the cusp, and over a turn-back on a line
    /// about its normal.
    ///
    /// Steps are halved up to 4096 + 64 times the number of frames in all. Only curves whose direction is rounding, on
    /// long stretches, need more; from there on the steps are as long as the way from frame to frame.
    ///
    /// ```
    /// use casteljau::{Curve, glam::DVec3};
    ///
    /// // A camera that flies at an even pace and starts upright.
    /// let path = [(0., 0., 0.), (4., 0., 1.), (4., 4., 2.), (0., 4., 0.)].map(DVec3::from);
    /// let path = Curve::new(&path)?;
    /// let flight = path.frames_at(&path.equidistant_times(100)?, Some(DVec3::Z))?;
    /// assert!(flight.iter().all(|frame| frame.tangent.dot(frame.normal).abs() < 1e-15));
    /// # Ok::<(), casteljau::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::NotFinite`] for a parameter or a normal that is not finite.
    pub fn frames_at(&self, ts: &[f64], normal: Option<DVec3>) -> Result<Vec<Frame>, Error> {
        frames_along(self, ts, normal)
    }
}

/// t, point and three directions: what a frame holds, in numbers of f64.
pub(crate) const FRAME_NUMBERS: usize = 13;

/// Curves one after the other.
pub(crate) trait FrameSequence {
    /// The curve of a t and the parameter on it.
    fn segment_at(&self, t: f64) -> (usize, f64);
    /// The k-th curve.
    fn link(&self, k: usize) -> Curve<DVec3>;
}

impl FrameSequence for Curve<DVec3> {
    fn segment_at(&self, t: f64) -> (usize, f64) {
        (0, t)
    }
    fn link(&self, _: usize) -> Curve<DVec3> {
        self.clone()
    }
}

/// Frames along a chain; see [`Curve::frames_at`].
pub(crate) fn frames_along(
    sequence: &dyn FrameSequence,
    ts: &[f64],
    normal: Option<DVec3>,
) -> Result<Vec<Frame>, Error> {
    check_all_finite(ts, normal)?;
    let mut frames = Vec::with_capacity(ts.len());
    let Some(&first) = ts.first() else {
        return Ok(frames);
    };
    let (mut k, mut at) = sequence.segment_at(first);
    let mut frame_curve = FrameCurve::new(sequence.link(k));
    // The last direction: a curve of a chain that is a point has none of its own.
    let mut direction = frame_curve.tangent(at);
    let mut carried = frame_curve.first_normal(at, normal);
    let mut work = WorkLimit::new(
        MAX_HALVINGS.saturating_add(MAX_HALVINGS_PER_FRAME.saturating_mul(ts.len())),
    );
    for &t in ts {
        let (to, rest) = sequence.segment_at(t);
        while k != to {
            // To the end of this curve, and round the corner.
            let (end, start, next) = if k < to {
                (1.0, 0.0, k + 1)
            } else {
                (0.0, 1.0, k - 1)
            };
            carried = frame_curve.carried(carried, at, end, &mut work);
            direction = frame_curve.direction(end, direction);
            frame_curve = FrameCurve::new(sequence.link(next));
            let after = frame_curve.direction(start, direction);
            carried = if carried == DVec3::ZERO {
                frame_curve.first_normal(start, normal)
            } else {
                turned(direction, carried, after, DVec3::ZERO)
            };
            (k, at, direction) = (next, start, after);
        }
        carried = frame_curve.carried(carried, at, rest, &mut work);
        (at, direction) = (rest, frame_curve.direction(rest, direction));
        frames.push(Frame {
            t,
            point: frame_curve.curve.eval(at),
            tangent: direction,
            normal: carried,
            binormal: direction.cross(carried),
        });
    }
    Ok(frames)
}

fn check_all_finite(ts: &[f64], normal: Option<DVec3>) -> Result<(), Error> {
    Error::unless_finite("ts", ts)?;
    crate::geometry::check::check_finite("normal", normal.as_slice())
}

/// A curve as a rail for frames; also moved to the origin and to a moderate size.
struct FrameCurve {
    curve: Curve<DVec3>,
    unit: Curve<DVec3>,
    slopes: crate::numeric::list::Points<DVec3>,
}

/// What a step needs to know of its ends.
#[derive(Clone, Copy)]
struct FrameSample {
    t: f64,
    point: DVec3,
    tangent: DVec3,
}

impl FrameCurve {
    fn new(curve: Curve<DVec3>) -> Self {
        let (slopes, _) = hodograph(curve.control_points());
        let mut point = DVec3::ZERO;
        let later = slopes.iter().map(|&slope| {
            point += slope;
            point
        });
        let unit = Curve::from_points(std::iter::once(DVec3::ZERO).chain(later).collect());
        Self {
            curve,
            unit,
            slopes,
        }
    }

    fn tangent(&self, t: f64) -> DVec3 {
        let slope = evaluate(&self.slopes, t);
        // The slopes have a largest coordinate of 1 to 2.
        if slope.max_abs() > CLEAR_SPEED {
            Point::normalize_or_zero(slope)
        } else {
            self.unit.tangent(t)
        }
    }

    fn segment_at(&self, t: f64) -> FrameSample {
        FrameSample {
            t,
            point: self.unit.eval(t),
            tangent: self.tangent(t),
        }
    }

    /// The tangent, or what it was before where there is none.
    fn direction(&self, t: f64, before: DVec3) -> DVec3 {
        let tangent = self.tangent(t);
        if tangent == DVec3::ZERO {
            before
        } else {
            tangent
        }
    }

    fn first_normal(&self, t: f64, wanted: Option<DVec3>) -> DVec3 {
        let tangent = self.tangent(t);
        if tangent == DVec3::ZERO {
            return DVec3::ZERO;
        }
        let across = |v: DVec3| DVec3::normal_of(tangent, v);
        let farthest = DVec3::AXES
            .into_iter()
            .min_by(|a, b| a.dot(tangent).abs().total_cmp(&b.dot(tangent).abs()));
        let all = [wanted, Some(self.unit.normal(t)), farthest];
        // What is along the tangent but for rounding is no wish.
        let clear = |v: &DVec3| {
            Point::length(Point::normalize_or_zero(*v).cross(tangent)) > PARALLELISM_SINE
        };
        all.into_iter()
            .flatten()
            .find(clear)
            .map_or(DVec3::ZERO, across)
    }

    /// The normal at t₀ carried to t₁.
    fn carried(&self, normal: DVec3, t0: f64, t1: f64, work: &mut WorkLimit) -> DVec3 {
        if t0 == t1 || self.slopes.iter().all(|&slope| slope == DVec3::ZERO) {
            return normal;
        }
        self.in_steps(&self.segment_at(t0), normal, &self.segment_at(t1), work)
    }

    fn in_steps(
        &self,
        from: &FrameSample,
        normal: DVec3,
        to: &FrameSample,
        work: &mut WorkLimit,
    ) -> DVec3 {
        let middle = self.segment_at(0.5 * (from.t + to.t));
        let at_once = reflected(from, normal, to);
        let in_two = reflected(&middle, reflected(from, normal, &middle), to);
        let cosine = from
            .tangent
            .dot(middle.tangent)
            .min(middle.tangent.dot(to.tangent));
        let gentle = cosine > GENTLE_COSINE;
        if work.is_exceeded() || (gentle && Point::length(in_two - at_once) <= CARRIED_APART) {
            return in_two;
        }
        if (to.t - from.t).abs() <= CUSP_STEP {
            return turned(from.tangent, normal, to.tangent, self.axis(middle.t));
        }
        if !work.spend(1) {
            return in_two;
        }
        let half = self.in_steps(from, normal, &middle, work);
        self.in_steps(&middle, half, to, work)
    }

    /// The normal of the plane in which a cusp lies; zero where there is none.
    fn axis(&self, t: f64) -> DVec3 {
        let derivative = |k: usize| Point::normalize_or_zero(self.unit.derivative_at(t, k));
        let second = derivative(2);
        (3..=self.unit.degree())
            .map(|k| second.cross(derivative(k)))
            .find(|axis| Point::length(*axis) > PARALLELISM_SINE)
            .map_or(DVec3::ZERO, Point::normalize_or_zero)
    }
}

/// The double reflection: in the plane amid both points, then in that which takes the reflected tangent to the new one.
fn reflected(from: &FrameSample, normal: DVec3, to: &FrameSample) -> DVec3 {
    let displacement = to.point - from.point;
    if displacement.max_abs() < MIN_DISPLACEMENT && from.tangent.dot(to.tangent) > GENTLE_COSINE {
        return turned(from.tangent, normal, to.tangent, DVec3::ZERO);
    }
    let chord = Point::normalize_or_zero(displacement);
    let mirror = |v: DVec3, axis: DVec3| v - axis * (2.0 * axis.dot(v));
    let (normal, tangent) = (mirror(normal, chord), mirror(from.tangent, chord));
    let second = Point::normalize_or_zero(to.tangent - tangent);
    let normal = mirror(normal, second);
    Point::normalize_or_zero(normal - to.tangent * to.tangent.dot(normal))
}

/// The normal after the tangent has turned from `before` to `after` at one place, the short way; `axis` says about what
/// it has turned if it points back, and is zero if that is not known: then the normal stays.
fn turned(before: DVec3, normal: DVec3, after: DVec3, axis: DVec3) -> DVec3 {
    let (mut before, mut normal) = (before, normal);
    if before.dot(after) < BACK_COSINE && (axis != DVec3::ZERO || before.dot(after) < -1.0 + 1e-12)
    {
        if axis != DVec3::ZERO {
            normal = axis * (2.0 * axis.dot(normal)) - normal;
        }
        before = -before;
    }
    let shared = normal.dot(after) / (1.0 + before.dot(after));
    let normal = normal - (before + after) * shared;
    Point::normalize_or_zero(normal - after * after.dot(normal))
}
