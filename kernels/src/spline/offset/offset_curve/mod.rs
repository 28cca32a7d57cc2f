//! Offset curves: approximation of B(t) + d·N(t) by cubics within a tolerance, where N is the unit normal.
//!
//! A piece is replaced by one cubic with its exact end points and end tangents, so two numbers are free: the lengths of
//! the handles. The first guess adds the handles of the source's segment to those of the circular arc that the normal
//! describes; a few least-squares steps on the distances at three parameters improve it (`fit`). Then the distance is
//! bounded, not sampled (`bound`). If the bound fails, the piece is cut, at cusps of the offset curve first. Idea:
//! Levien, "Parallel curves of cubic Béziers" (2022).
#![allow(
    clippy::disallowed_methods,
    reason = "the curve is scaled to size 1: nothing overflows"
)]

mod arc;
mod bound;
mod cusps;
mod fit;
mod local;
mod source;

use crate::numeric::order::{larger, smaller};
use crate::numeric::work_limit::WorkLimit;
use crate::numeric::zero::{ROOT_WIDTH, regula_falsi};
pub use arc::add_arc;
use glam::DVec2;
use source::OffsetSample;
pub use source::{Source, fourth_bound};

/// Maximum depth of cutting a piece in two.
const MAX_CUTS: usize = 48;

/// A piece whose length is at most this part of the tolerance needs no bound.
const TINY_PART: f64 = 0.25;

/// The foot of a perpendicular is found to this part of the tolerance: a larger error would make the bounds fail next to
/// it on intervals of any length.
const FOOT_PART: f64 = 0.1;

/// A piece this short, in t, is a point up to rounding.
const SHORTEST: f64 = 1e-12;

/// The largest angle, in radians, by which a normal may leave the angle between its ends. Up to it, the sine that is
/// tested differs from the angle by less than 0.2 %.
const MAX_EXCESS: f64 = 0.1;

/// A derivative below this part of the sum of its terms' lengths is only rounding.
const VANISHING_SPEED: f64 = 1e-14;

/// An end of a piece: the sample, the unit tangent in the limit from inside the piece, and the direction of the offset
/// curve: 1 along the tangent, −1 against it (past its cusp).
///
/// `sign` is the sign of 1 − κd at the parameter `sign_t`. Next to a cusp of the source `sign_t` is a little inside the piece,
/// since rounding exceeds 1 − κd at the cusp itself.
#[derive(Clone, Copy, Debug)]
struct End {
    sample: OffsetSample,
    tangent: DVec2,
    sign: f64,
    sign_t: f64,
}

/// An offset curve of a curve.
pub struct OffsetCurve<'a> {
    source: &'a Source,
    distance: f64,
    tolerance: f64,
    /// The square of the distance along the source by which the foot of a perpendicular may be wrong.
    foot_square: f64,
    /// Bounds on the lengths of the third and fourth derivative of the source.
    third: f64,
    fourth: f64,
}

impl<'a> OffsetCurve<'a> {
    /// The offset curve at a distance along the normal, which is the tangent rotated by +90°.
    pub fn new(source: &'a Source, distance: f64, tolerance: f64) -> Self {
        Self {
            source,
            distance,
            tolerance,
            foot_square: (FOOT_PART * tolerance).powi(2),
            third: source.third(),
            fourth: source.fourth(),
        }
    }

    /// The end of a piece at t.
    fn end(&self, t: f64) -> End {
        let sample = self.source.at(t);
        let sign = if self.cusp_function(&sample) < 0.0 {
            -1.0
        } else {
            1.0
        };
        End {
            sample,
            tangent: sample.first.normalize_or_zero(),
            sign,
            sign_t: t,
        }
    }

    /// |B′|³(1 − κd): positive where the offset curve has the direction of the tangent.
    #[inline]
    fn cusp_function(&self, at: &OffsetSample) -> f64 {
        let square = at.first.length_squared();
        square * square.sqrt() - self.distance * at.first.perp_dot(at.second)
    }

    /// The point of the offset curve at an end.
    #[inline]
    fn point(&self, end: &End) -> DVec2 {
        end.sample.point + end.tangent.perp() * self.distance
    }

    /// The cubic from one end to the other with the given lengths of its handles; negative ones lead against the tangents.
    fn cubic(&self, from: &End, to: &End, (a, b): (f64, f64)) -> [DVec2; 4] {
        let (start, end) = (self.point(from), self.point(to));
        [start, start + from.tangent * a, end - to.tangent * b, end]
    }

    /// Appends three control points for each cubic from one end to the other, without a prior search for cusps. Appends
    /// nothing more once the work limit is exceeded.
    fn cover(&self, from: &End, to: &End, out: &mut Vec<DVec2>, work: &mut WorkLimit) {
        self.cover_deep(from, to, MAX_CUTS, out, work);
    }

    fn cover_deep(
        &self,
        from: &End,
        to: &End,
        cuts: usize,
        out: &mut Vec<DVec2>,
        work: &mut WorkLimit,
    ) {
        if !work.spend(1) {
            return;
        }
        // The direction of the offset curve changes at a cusp between the ends.
        if from.sign != to.sign
            && let Some((before, after)) = self.cusp(from, to)
        {
            self.cover_deep(from, &before, cuts, out, work);
            self.cover_deep(&after, to, cuts, out, work);
            return;
        }
        let local = self.on_piece(from, to);
        if let Some(cubic) = local.fit(from, to, work) {
            out.extend_from_slice(&cubic[1..]);
            return;
        }
        let is_tiny = local.tiny(from, to);
        let chord = || (self.point(to) - self.point(from)).length();
        // Where rounding of B′ turns the normal, the ends are farther apart than the bound on the length says.
        if is_tiny && chord() <= TINY_PART * self.tolerance {
            let cubic = self.cubic(from, to, self.first_handles(from, to));
            out.extend_from_slice(&cubic[1..]);
            return;
        }
        let shortest = cuts == 0 || to.sample.t - from.sample.t <= SHORTEST;
        if shortest || is_tiny || local.is_rotation_about_point(from, to) {
            self.arc(from, to, out);
            return;
        }
        let mut middle = self.cut(from, to);
        if self.source.is_still(&middle.sample) {
            // The direction of B′ is only rounding here.
            middle.tangent = (from.tangent + to.tangent).normalize_or_zero();
        }
        self.cover_deep(from, &middle, cuts - 1, out, work);
        self.cover_deep(&middle, to, cuts - 1, out, work);
    }

    /// Whether the offset of a piece is shorter than a part of the tolerance.
    fn tiny(&self, from: &End, to: &End) -> bool {
        self.length_bound(&from.sample, &to.sample) <= TINY_PART * self.tolerance
    }

    /// Whether the source is a point within the tolerance, and the normal rotates about it without leaving the angle
    /// between its ends. If rounding moves the offset by more than the tolerance, the angle is not tested.
    fn is_rotation_about_point(&self, from: &End, to: &End) -> bool {
        let (a, b) = (&from.sample, &to.sample);
        let h = b.t - a.t;
        // A bound of the length of the source. Up to degree 3 the control polygon is no longer; above, the middle of a
        // piece may lead away although B′ is small at both ends.
        let length = if self.source.degree() <= 3 {
            (b.point - a.point).length() + h * (a.first.length() + b.first.length())
        } else {
            h * self.source.derivative_bound(1, a.t, b.t)
        };
        if length > TINY_PART * self.tolerance {
            return false;
        }
        if self.noise(a).min(self.noise(b)) >= self.tolerance {
            return true;
        }
        let side = from.tangent.perp_dot(to.tangent);
        let sign = if side < 0.0 { -1.0 } else { 1.0 };
        // If the ends are more than 90° apart, no excess is allowed: a normal outside the angle between them could be one that
        // rotates the long way.
        let excess = if from.tangent.dot(to.tangent) > 0.0 {
            -(TINY_PART * self.tolerance / self.distance.abs()).min(MAX_EXCESS)
        } else {
            0.0
        };
        self.source.slopes_between(a.t, b.t, |v| {
            let min = excess * v.length();
            from.tangent.perp_dot(v) * sign >= min
                && v.perp_dot(to.tangent) * sign >= min
                && v.dot(from.tangent + to.tangent) >= 0.0
        })
    }

    /// A bound on the length of the offset curve between two samples; infinite if B′ may vanish between them.
    ///
    /// O′ = (1 − κd) B′ has the length |f| / |B′|² with f = |B′|³ − d (B′ × B″), and |f′| ≤ 3 |B′|² |B″| + |d| |B′|
    /// |B‴|. Near a cusp of the offset curve this is far shorter than the segment of the source.
    fn length_bound(&self, a: &OffsetSample, b: &OffsetSample) -> f64 {
        let (h, third) = (b.t - a.t, self.third);
        // On the piece, B″ changes by at most h max|B‴|, and B′ by at most h max|B″|.
        let max_second = larger(a.second.length(), b.second.length()) + h * third;
        let (u, v) = (a.first.length(), b.first.length());
        let (slowest, fastest) = (
            smaller(u, v) - h * max_second,
            larger(u, v) + h * max_second,
        );
        if slowest <= 0.25 * fastest {
            return f64::INFINITY;
        }
        let change = 3.0 * fastest * fastest * max_second + self.distance.abs() * fastest * third;
        let f = larger(self.cusp_function(a).abs(), self.cusp_function(b).abs()) + h * change;
        h * f / (slowest * slowest)
    }

    /// Appends arcs about a source that is a point within the tolerance.
    fn arc(&self, from: &End, to: &End, out: &mut Vec<DVec2>) {
        let (cos, sin) = (
            from.tangent.dot(to.tangent),
            from.tangent.perp_dot(to.tangent),
        );
        let angle = sin.atan2(cos);
        let (centers, tangents) = (
            [from.sample.point, to.sample.point],
            [from.tangent, to.tangent],
        );
        let tolerance = TINY_PART * self.tolerance;
        add_arc(centers, tangents, angle, self.distance, tolerance, out);
    }

    /// The cusp of the offset curve between two ends with different signs. Next to a cusp of the source, where the sign
    /// is evaluated at some distance inside, the sign in between cannot be computed, since rounding exceeds the value.
    fn cusp(&self, from: &End, to: &End) -> Option<(End, End)> {
        let (t0, t1) = (from.sign_t, to.sign_t);
        let t = self.zero(t0, t1, from.sign, |sample| self.cusp_function(sample))?;
        let before = End {
            sign: from.sign,
            ..self.end(t)
        };
        let after = End {
            sign: to.sign,
            ..before
        };
        Some((before, after))
    }

    /// The point at which a piece is cut: an inflection, or the parameter where the tangent has rotated by half the
    /// angle, or the middle parameter.
    fn cut(&self, from: &End, to: &End) -> End {
        let (t0, t1) = (from.sample.t, to.sample.t);
        let turning = |sample: &OffsetSample| sample.first.perp_dot(sample.second);
        let (b0, b1) = (turning(&from.sample), turning(&to.sample));
        let half = from.tangent + to.tangent;
        let side = from.tangent.perp_dot(half);
        let t = if b0 * b1 < 0.0 {
            self.zero(t0, t1, b0.signum(), turning)
        } else if side.abs() > MIN_TURN {
            self.zero(t0, t1, 1.0, |sample| {
                half.perp_dot(sample.first) * -side.signum()
            })
        } else {
            None
        };
        let inside = |t: &f64| (*t - t0).min(t1 - *t) > MIN_PART * (t1 - t0);
        let t = t.filter(inside);
        self.end(t.unwrap_or(0.5 * (t0 + t1)))
    }

    /// A zero strictly between two parameters of a function with the sign `sign` at the first and the opposite one at
    /// the second.
    fn zero(&self, t0: f64, t1: f64, sign: f64, f: impl Fn(&OffsetSample) -> f64) -> Option<f64> {
        let value = |t: f64| sign * f(&self.source.at(t));
        // Rounding may have changed a sign; `regula_falsi` expects no negative value at t0 and no positive one at t1.
        let ends = [value(t0).max(0.0), value(t1).min(0.0)];
        let t = regula_falsi([t0, t1], ends, ROOT_WIDTH, value);
        (t > t0 && t < t1).then_some(t)
    }
}

/// At smaller angles (as a sine), a piece is cut in the middle of its parameters instead of its directions: the curve is
/// nearly straight, so both are about the same. Only the number of pieces depends on it.
const MIN_TURN: f64 = 0.05;

/// A cut this close to an end, as a part of the piece, is replaced by one in the middle: a cut must shorten a piece. Ten
/// halvings reach a point this close to an end too.
const MIN_PART: f64 = 1e-3;
