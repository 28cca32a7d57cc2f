//! Rotation-minimizing frames along curves in space.
//!
//! The principal normal jumps at inflections and is undefined on straight curves. A *rotation-minimizing* frame has the
//! same tangent and does not rotate about it: its normal changes only as the change of the tangent requires. The double
//! reflection method carries it over a short step with an error of the fifth power of the step; steps are halved until
//! the error is negligible. Source: Wang, Jüttler, Zheng and Liu, "Computation of rotation minimizing frames", ACM
//! Transactions on Graphics 27 (2008).

use super::Curve;
use super::eval::check_segments;
use crate::bernstein::evaluate::evaluate;
use crate::curve::arc_length::length::hodograph;
use crate::geometry::error::Error;
use crate::geometry::point::Point;
use crate::numeric::float::ratio;
use crate::numeric::work_limit::WorkLimit;
use glam::DVec3;

/// A step is short enough if halving it moves the normal by less than this; the remaining error is about 20 times
/// smaller.
const CARRIED_APART: f64 = 1e-10;

/// The cosine of the largest allowed angle, 60°, between the tangents of half a step.
const GENTLE_COSINE: f64 = 0.5;

/// A step of t this short over which the tangent still turns sharply contains a cusp.
const CUSP_STEP: f64 = 1e-10;

/// Below this cosine of the angle between two tangents, the direction counts as reversed.
const BACK_COSINE: f64 = -0.9;

/// Above this part of the largest speed the tangent is the normalized derivative; below, it is the limit of the
/// tangent.
const CLEAR_SPEED: f64 = 1e-6;

/// A chord shorter than this is rounding noise. The normal is then rotated by the smallest rotation between the two
/// tangents.
const MIN_DISPLACEMENT: f64 = 1e-10;

/// Derivatives count as parallel when the sine of their angle is below this.
const PARALLELISM_SINE: f64 = 1e-9;

/// Maximum number of halvings: a fixed part for all steps together, and a part for each frame. Moderate curves need
/// less than a tenth.
const MAX_HALVINGS: usize = 1 << 12;
const MAX_HALVINGS_PER_FRAME: usize = 64;

/// A point on a curve in space with an orthonormal frame: tangent, normal and binormal.
///
/// The binormal is tangent × normal. For a curve that is a point all directions are zero.
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
    /// The unit normal of the rotation-minimizing frame.
    pub normal: DVec3,
    /// Tangent × normal.
    pub binormal: DVec3,
}

impl Curve<DVec3> {
    /// `segments` + 1 rotation-minimizing frames at t = i / `segments`.
    ///
    /// Same as [`frames_at`](Self::frames_at) with equal steps of t and no given first normal.
    ///
    /// # Errors
    /// [`Error::Range`] for 0 segments, [`Error::TooMany`] above 1 GiB of numbers.
    pub fn frames(&self, segments: usize) -> Result<Vec<Frame>, Error> {
        check_segments(segments, FRAME_NUMBERS)?;
        let ts: Vec<f64> = (0..=segments).map(|i| ratio(i, segments)).collect();
        self.frames_at(&ts, None)
    }

    /// Rotation-minimizing frames at the given parameters, each continued from the previous one.
    ///
    /// N′ = −(N·T′) T: the normal does not rotate about the tangent, with an error of at most 10⁻⁹ for any number of
    /// frames. The first normal is the component of `normal` perpendicular to the tangent, normalized. If `normal` is
    /// not given or is parallel to the tangent, the first normal is the principal normal; where the curve is straight,
    /// it comes from the coordinate axis that is farthest from the tangent. Straight segments and inflections do not
    /// change the frame. At a cusp the frame rotates by 180° in the plane of the cusp; where a straight curve reverses,
    /// it rotates by 180° about its normal.
    ///
    /// Steps are halved at most 4096 + 64 × (number of frames) times in total. Only curves whose direction is rounding
    /// noise over long ranges need more; after this limit each step goes from frame to frame.
    ///
    /// ```
    /// use casteljau::{Curve, glam::DVec3};
    ///
    /// // A camera that flies at constant speed and starts upright.
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

/// The size of a frame in numbers of f64: t, the point and three directions.
pub(crate) const FRAME_NUMBERS: usize = 13;

/// A sequence of consecutive curves.
pub(crate) trait FrameSequence {
    /// The index of the curve that contains t, and the local parameter.
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

/// Frames along a sequence of curves; see [`Curve::frames_at`].
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
    // The last direction: a curve of the sequence that is a single point has no direction of its own.
    let mut direction = frame_curve.tangent(at);
    let mut carried = frame_curve.first_normal(at, normal);
    let mut work = WorkLimit::new(
        MAX_HALVINGS.saturating_add(MAX_HALVINGS_PER_FRAME.saturating_mul(ts.len())),
    );
    for &t in ts {
        let (to, rest) = sequence.segment_at(t);
        while k != to {
            // Continue to the end of this curve, then rotate into the start of the next.
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

/// A curve for frames. `unit` is a copy with the start at the origin and a moderate size.
struct FrameCurve {
    curve: Curve<DVec3>,
    unit: Curve<DVec3>,
    slopes: crate::numeric::list::Points<DVec3>,
}

/// The data that a step needs of one of its ends.
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
        // The largest coordinate of the slopes is between 1 and 2.
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

    /// The tangent, or `before` where there is none.
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
        // Ignore a requested normal that is parallel to the tangent.
        let clear = |v: &DVec3| {
            Point::length(Point::normalize_or_zero(*v).cross(tangent)) > PARALLELISM_SINE
        };
        all.into_iter()
            .flatten()
            .find(clear)
            .map_or(DVec3::ZERO, across)
    }

    /// Carries the normal from t₀ to t₁.
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

    /// The normal of the plane in which a cusp lies; zero if there is none.
    fn axis(&self, t: f64) -> DVec3 {
        let derivative = |k: usize| Point::normalize_or_zero(self.unit.derivative_at(t, k));
        let second = derivative(2);
        (3..=self.unit.degree())
            .map(|k| second.cross(derivative(k)))
            .find(|axis| Point::length(*axis) > PARALLELISM_SINE)
            .map_or(DVec3::ZERO, Point::normalize_or_zero)
    }
}

/// The normal carried to the next sample by a double reflection.
fn reflected(from: &FrameSample, normal: DVec3, to: &FrameSample) -> DVec3 {
    let displacement = to.point - from.point;
    if displacement.max_abs() < MIN_DISPLACEMENT && from.tangent.dot(to.tangent) > GENTLE_COSINE {
        return turned(from.tangent, normal, to.tangent, DVec3::ZERO);
    }
    let normal = double_reflection(normal, [from.tangent, to.tangent], displacement);
    Point::normalize_or_zero(normal - to.tangent * to.tangent.dot(normal))
}

/// A vector perpendicular to a curve, transported from one point to another without rotation about the curve: reflected
/// in the bisecting plane of both points, then in the plane that maps the reflected tangent to the tangent at the second
/// point. Source: Wang, Jüttler, Zheng and Liu, "Computation of rotation minimizing frames", ACM TOG 27 (2008).
pub(crate) fn double_reflection(
    vector: DVec3,
    [before, after]: [DVec3; 2],
    displacement: DVec3,
) -> DVec3 {
    let mirror = |v: DVec3, axis: DVec3| v - axis * (2.0 * axis.dot(v));
    let chord = Point::normalize_or_zero(displacement);
    let (vector, tangent) = (mirror(vector, chord), mirror(before, chord));
    mirror(vector, Point::normalize_or_zero(after - tangent))
}

/// The normal after the tangent has rotated from `before` to `after` at one point, by the smallest rotation. `axis` is
/// the rotation axis for a reversed tangent; if it is zero (unknown), the normal stays.
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
