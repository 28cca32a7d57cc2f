//! Rotation-minimizing frames along curves in space.
//!
//! The principal normal jumps at inflections and is undefined on straight curves. A *rotation-minimizing* frame has the
//! same tangent and does not rotate about it: its normal changes only as the change of the tangent requires. The double
//! reflection method carries it over a short step with an error of the fifth power of the step; steps are halved until
//! the error is negligible. Source: Wang, Jüttler, Zheng and Liu, "Computation of rotation minimizing frames", ACM
//! Transactions on Graphics 27 (2008).

use super::Curve;
use super::carried_frame::{CarriedFrame, FrameCurve};
use super::eval::check_segments;
use crate::geometry::check::check_points;
use crate::geometry::error::Error;
use crate::numeric::float::ratio;
use crate::numeric::sort::sort_by;
use casteljau_kernels::numeric::work_limit::WorkLimit;
use glam::DVec3;

/// Maximum number of halvings of steps on the first curve, and for each further curve. Moderate curves need less than a
/// tenth.
const MAX_HALVED_STEPS: usize = 1 << 12;
const MAX_HALVED_STEPS_PER_CURVE: usize = 64;

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

    /// Rotation-minimizing frames at the given parameters, continued from t = 0.
    ///
    /// N′ = −(N·T′) T: the normal does not rotate about the tangent, with an error of at most 10⁻⁹. The frame at a
    /// parameter does not depend on the other parameters. The normal at t = 0 is the component of `normal` perpendicular
    /// to the tangent, normalized. If `normal` is not given or is parallel to the tangent, it is the principal normal;
    /// where the curve is straight, it comes from the coordinate axis that is farthest from the tangent. Straight segments and inflections do not
    /// change the frame. At a cusp the frame rotates by 180° in the plane of the cusp; where a straight curve reverses,
    /// it rotates by 180° about its normal.
    ///
    /// Steps are halved at most 4096 times on [0, 1], and 63 times more for each frame (512 outside of [0, 1]). Only curves
    /// whose direction is rounding noise over long ranges need more; after this limit the steps are not refined.
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
    fn curve_count(&self) -> usize;
    /// The index of the curve that contains t, and the local parameter.
    fn segment_at(&self, t: f64) -> (usize, f64);
    /// The k-th curve.
    fn curve_at_index(&self, k: usize) -> Curve<DVec3>;
    /// For pairs (k, t) the part of the total length up to the local parameter t on curve k; `None` if the sequence is
    /// open.
    fn parts_of_length(&self, locations: &[(usize, f64)]) -> Option<Vec<f64>>;
}

impl FrameSequence for Curve<DVec3> {
    fn curve_count(&self) -> usize {
        1
    }
    fn segment_at(&self, t: f64) -> (usize, f64) {
        (0, t)
    }
    fn curve_at_index(&self, _: usize) -> Curve<DVec3> {
        self.clone()
    }
    fn parts_of_length(&self, _: &[(usize, f64)]) -> Option<Vec<f64>> {
        None
    }
}

/// Frames along a sequence of curves; see [`Curve::frames_at`] and
/// [`Spline::frames_at`](crate::Spline::frames_at).
///
/// The normal is carried from t = 0 over steps that do not depend on the parameters, then from the start of a step to
/// each parameter within it.
pub(crate) fn frames_along(
    sequence: &dyn FrameSequence,
    ts: &[f64],
    normal: Option<DVec3>,
) -> Result<Vec<Frame>, Error> {
    Error::unless_finite("ts", ts)?;
    check_points("normal", normal.as_slice())?;
    if ts.is_empty() {
        return Ok(Vec::new());
    }
    let locations: Vec<(usize, f64)> = ts.iter().map(|&t| sequence.segment_at(t)).collect();
    let parts = sequence.parts_of_length(&locations);
    let count = sequence.curve_count();
    let first = first_frame(sequence, normal);
    let mut carried = first;
    let mut found = vec![first; ts.len()];
    let further = MAX_HALVED_STEPS_PER_CURVE.saturating_mul(count - 1);
    let mut work = WorkLimit::new(MAX_HALVED_STEPS.saturating_add(further));
    let mut order: Vec<usize> = (0..ts.len()).collect();
    sort_by(&mut order, |&a, &b| locations[a].0.cmp(&locations[b].0));
    let mut order = order.into_iter().peekable();
    for k in 0..count {
        if order.peek().is_none() && parts.is_none() {
            break;
        }
        let curve = FrameCurve::new(&sequence.curve_at_index(k));
        let steps = curve.steps(carried, &mut work);
        while let Some(index) = order.next_if(|&index| locations[index].0 == k) {
            found[index] = curve.frame_at(&steps, locations[index].1);
        }
        carried = steps[steps.len() - 1].frame();
    }
    if let Some(parts) = parts {
        // The twist that is left after one round.
        let twist = carried.rotated_to(first.tangent).angle_to(first);
        for (frame, part) in found.iter_mut().zip(parts) {
            *frame = frame.rotated(twist * part);
        }
    }
    let frame = |((&t, &(k, local)), found): ((&f64, &(usize, f64)), &CarriedFrame)| Frame {
        t,
        point: sequence.curve_at_index(k).eval(local),
        tangent: found.tangent,
        normal: found.normal,
        binormal: found.tangent.cross(found.normal),
    };
    Ok(ts.iter().zip(&locations).zip(&found).map(frame).collect())
}

/// The frame at the start of the first curve that is not a point; zero if there is none.
fn first_frame(sequence: &dyn FrameSequence, normal: Option<DVec3>) -> CarriedFrame {
    (0..sequence.curve_count())
        .find_map(|k| FrameCurve::new(&sequence.curve_at_index(k)).first(normal))
        .unwrap_or_default()
}
