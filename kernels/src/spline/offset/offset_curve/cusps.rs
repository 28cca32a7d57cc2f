//! Cusps of the source and of the offset curve, at which a curve must be cut before the offsets of its parts are
//! smooth.

use super::source::Source;
use super::{End, OffsetCurve};
use crate::curve::curvature::curvature_is_within;
use crate::numeric::work_limit::WorkLimit;
use glam::DVec2;

/// A second derivative below this part of the largest speed gives no direction.
const VANISHING_BEND: f64 = 1e-9;

/// The step in t to a neighbouring point. Its square root is used if no derivative gives a direction; times the length
/// of the piece, it is used to evaluate the direction of the offset curve.
const BESIDE: f64 = 1.0 / (1_u32 << 20) as f64;

/// Steps of the search for cusps of the offset curve; a cusp that it misses is cut when no cubic fits.
const CUSP_STEPS: usize = 12;

impl Source {
    /// The cusps, where B′ reverses, among the zeros of B′ inside (0, 1).
    pub fn cusps(&self, zeros: &[f64]) -> Vec<f64> {
        let mut found: Vec<f64> = zeros.iter().filter_map(|&t| self.refined(t)).collect();
        found.dedup_by(|b, a| *b - *a < 2.0 * BESIDE * BESIDE);
        found
    }

    /// The cusp near t, if there is one: Gauss–Newton steps for the minimum of |B′|².
    fn refined(&self, mut t: f64) -> Option<f64> {
        for _ in 0..4 {
            let sample = self.at(t);
            let square = sample.second.length_squared();
            if square > 0.0 {
                t -= sample.first.dot(sample.second) / square;
            }
        }
        if t <= BESIDE || t >= 1.0 - BESIDE {
            return None;
        }
        let zero = self.is_still(&self.at(t));
        // Next to zero-length handles B′ is also small, but does not reverse.
        let beside = BESIDE.sqrt().min(0.5 * t).min(0.5 * (1.0 - t));
        let turns = self.at(t - beside).first.dot(self.at(t + beside).first) < 0.0;
        (zero && turns).then_some(t)
    }

    /// The tangents before and after a cusp.
    pub fn cusp_tangents(&self, t: f64) -> (DVec2, DVec2) {
        let sample = self.at(t);
        if sample.second.length() > VANISHING_BEND * self.speed() {
            // Next to the cusp, B′ is about B″ times the difference of the parameters.
            return (
                -sample.second.normalize_or_zero(),
                sample.second.normalize_or_zero(),
            );
        }
        let beside = BESIDE.sqrt().min(0.5 * t).min(0.5 * (1.0 - t));
        (
            self.at(t - beside).first.normalize_or_zero(),
            self.at(t + beside).first.normalize_or_zero(),
        )
    }
}

impl OffsetCurve<'_> {
    /// Appends three control points for each cubic between two parameters, between which B′ does not vanish; the
    /// tangents are the limits from inside. The first point is already present. If the work limit is exceeded, the rest
    /// is missing. `may_have_cusps`: whether the offset curve may have cusps; they are found first.
    pub fn run(
        &self,
        (t0, t1): (f64, f64),
        tangents: [DVec2; 2],
        may_have_cusps: bool,
        out: &mut Vec<DVec2>,
        work: &mut WorkLimit,
    ) {
        let mut from = self.outer_end(t0, tangents[0], BESIDE * (t1 - t0));
        let to = self.outer_end(t1, tangents[1], -BESIDE * (t1 - t0));
        let mut last = from;
        if may_have_cusps && !self.has_no_cusp((t0, t1)) {
            for step in 1..CUSP_STEPS {
                let t = t0 + (t1 - t0) * (step as f64 / CUSP_STEPS as f64);
                last = self.emit_up_to_cusp(&mut from, &last, self.end(t), out, work);
            }
        }
        self.emit_up_to_cusp(&mut from, &last, to, out, work);
        self.cover(&from, &to, out, work);
    }

    /// If there is a cusp between two ends, appends the cubics up to the cusp and continues behind it.
    fn emit_up_to_cusp(
        &self,
        from: &mut End,
        last: &End,
        next: End,
        out: &mut Vec<DVec2>,
        work: &mut WorkLimit,
    ) -> End {
        if last.sign != next.sign
            && let Some((before, after)) = self.cusp(last, &next)
        {
            self.cover(from, &before, out, work);
            *from = after;
        }
        next
    }

    fn outer_end(&self, t: f64, tangent: DVec2, inwards: f64) -> End {
        let mut end = self.end(t);
        if self.source.is_still(&end.sample) {
            // Only the limit of the tangent is known: B′ has no direction, and the sign is evaluated inside.
            end.sample.first = DVec2::default();
            end.sign_t = t + inwards;
            end.sign = self.end(end.sign_t).sign;
        }
        End { tangent, ..end }
    }

    /// Whether the curvature is proved to allow no cusp of the offset curve. Up to degree 3 only.
    fn has_no_cusp(&self, (t0, t1): (f64, f64)) -> bool {
        if self.source.degree() > 3 || (t0, t1) != (0.0, 1.0) {
            return false;
        }
        let limit = 1.0 / self.distance;
        // 1 − κd > 0 means κ < 1/d for a positive distance, and κ > 1/d for a negative one.
        let limits = if limit > 0.0 {
            [f64::NEG_INFINITY, limit]
        } else {
            [limit, f64::INFINITY]
        };
        curvature_is_within(&self.source.first_vectors(), limits)
    }
}
