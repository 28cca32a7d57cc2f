//! Rotation-minimising frames along splines in space.

use super::Spline;
use crate::curve::Curve;
use crate::curve::eval::check_segments;
use crate::curve::frames::{FRAME_NUMBERS, Frame, FrameSequence, frames_along};
use crate::geometry::error::Error;
use glam::DVec3;

impl FrameSequence for Spline<DVec3> {
    fn segment_at(&self, t: f64) -> (usize, f64) {
        self.locate(t)
    }
    fn link(&self, k: usize) -> Curve<DVec3> {
        self.curve(k)
    }
}

impl Spline<DVec3> {
    /// Rotation-minimising frames at even steps of t, `per_curve` steps per segment, both ends included.
    ///
    /// As [`frames_at`](Self::frames_at) without a requested first normal.
    ///
    /// # Errors
    /// As [`sample`](Self::sample).
    pub fn frames(&self, per_curve: usize) -> Result<Vec<Frame>, Error> {
        check_segments(per_curve, FRAME_NUMBERS)?;
        let total = per_curve.saturating_mul(self.segment_count());
        check_segments(total, FRAME_NUMBERS)?;
        let ts: Vec<f64> = (0..=total).map(|i| i as f64 / per_curve as f64).collect();
        self.frames_at(&ts, None)
    }

    /// Rotation-minimising frames at the given parameters, each one propagated from the previous one; see
    /// [`Curve::frames_at`].
    ///
    /// At a corner the frame turns with the tangent by the smaller angle; where the tangent reverses exactly, the
    /// normal is kept. The first and the last frame of a closed spline can differ; the angle between them is the total
    /// twist of the curve.
    ///
    /// # Errors
    /// As [`Curve::frames_at`].
    pub fn frames_at(&self, ts: &[f64], normal: Option<DVec3>) -> Result<Vec<Frame>, Error> {
        frames_along(self, ts, normal)
    }
}
