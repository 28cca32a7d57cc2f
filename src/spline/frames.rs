//! Rotation-minimizing frames along splines in space.

use super::Spline;
use crate::curve::Curve;
use crate::curve::eval::check_segments;
use crate::curve::frames::{FRAME_NUMBERS, Frame, FrameSequence, frames_along};
use crate::geometry::error::Error;
use glam::DVec3;

impl FrameSequence for Spline<DVec3> {
    fn curve_count(&self) -> usize {
        self.segment_count()
    }
    fn segment_at(&self, t: f64) -> (usize, f64) {
        self.locate(t)
    }
    fn curve_at_index(&self, k: usize) -> Curve<DVec3> {
        self.curve(k)
    }
    fn parts_of_length(&self, locations: &[(usize, f64)]) -> Option<Vec<f64>> {
        self.closed.then(|| {
            let ends = self.cumulative_lengths();
            let count = self.segment_count();
            let part = |&(k, t): &(usize, f64)| {
                let whole = self.curve(k).split(t.clamp(0.0, 1.0)).0;
                let length = ends[k] + whole.arc_length(f64::INFINITY);
                // At the end of a segment the sum itself, so that the part at the end of the spline is exactly 1.
                let part = if t < 1.0 { length } else { ends[k + 1] } / ends[count];
                // If the length overflows f64, use the parameter instead.
                if part.is_finite() {
                    part.min(1.0)
                } else {
                    (k as f64 + t) / count as f64
                }
            };
            locations.iter().map(part).collect()
        })
    }
}

impl Spline<DVec3> {
    /// Rotation-minimizing frames at even steps of t, `per_curve` steps per segment, both ends included.
    ///
    /// As [`frames_at`](Self::frames_at) without a requested first normal.
    ///
    /// # Errors
    /// As [`sample`](Self::sample).
    pub fn frames(&self, per_curve: usize) -> Result<Vec<Frame>, Error> {
        let total = per_curve.saturating_mul(self.segment_count());
        check_segments(total, FRAME_NUMBERS)?;
        let ts: Vec<f64> = (0..=total).map(|i| i as f64 / per_curve as f64).collect();
        self.frames_at(&ts, None)
    }

    /// Rotation-minimizing frames at the given parameters, continued from t = 0; see [`Curve::frames_at`].
    ///
    /// At a corner the frame turns with the tangent by the smaller angle; where the tangent reverses exactly, the
    /// normal is kept. A rotation-minimizing frame that is carried around a closed spline returns rotated by an angle φ,
    /// −π to π. Frames of a closed spline are therefore rotated back by φ s/L at arc length s of the total length L, so
    /// that the last frame is the first one; they rotate about the tangent at the constant rate −φ/L. Of all frames
    /// that close, these have the smallest integral of the squared rate. Source: Wang, Jüttler, Zheng and Liu,
    /// "Computation of rotation minimizing frames", ACM Transactions on Graphics 27 (2008), on closed curves.
    ///
    /// Steps are halved at most 4096 + 64 × (number of further segments) times, and for each frame as on a curve.
    ///
    /// # Errors
    /// As [`Curve::frames_at`].
    pub fn frames_at(&self, ts: &[f64], normal: Option<DVec3>) -> Result<Vec<Frame>, Error> {
        frames_along(self, ts, normal)
    }
}
