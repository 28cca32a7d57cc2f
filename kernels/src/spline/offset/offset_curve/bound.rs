//! A bound on the distance between a cubic and the offset curve.
//!
//! Take two pairs, each of a point of the cubic and the foot of its perpendicular on the source. Between them let u run
//! from 0 to 1 on both curves: Q(u) on the cubic, B(u) on the source. E = Q − B is a cubic in u, so |E|², E·B′ and
//! |B′|² − E·B″ are polynomials, which lie between their smallest and their largest Bernstein coefficient. They bound
//! the difference of |E| from the given distance, the deviation of E from the normal, and the distance of the foot of
//! the perpendicular from B(u). With δ the tangential component of E, either
//!
//!   √(δ² + (|E| − d)²)   or   |√(|E|² ∓ S) − d|
//!
//! bounds the distance from Q(u) to the offset curve, if E points to the side of the offset curve. S bounds the difference
//! of |E|² from the square of the distance at the foot, next to B(t) with t ≠ u: for Q(u) the second derivative of half
//! the square by t is that of the pair (t, t) plus (Q(t) − Q(u))·B″(t), so it changes by at most max|Q′| max|B″| |t − u|
//! (`difference_at_zero`). If |B′|² − E·B″ is
//! positive, the foot is the nearest point, so its distance is at most |E|; if negative, at least |E|. A foot beyond the
//! end of a part is in the next one, whose bound is proved as well. |E| is the same on
//! the other side, and tolerances of more than d accept single points there, so the side is checked at the first pair:
//! E cannot change sides without passing B′. The foot moves along with u from one end to the other, so every point of
//! the offset curve is as near to the cubic. Parts for which these bounds are too large are halved, which reduces δ by
//! a factor of four.

use super::fit::{FootPair, evaluate};
use super::{OffsetCurve, VANISHING_SPEED};
use crate::bernstein::vector_products::{
    cubic_by_linear, cubic_by_quadratic, cubic_square, quadratic_by_quadratic, quadratic_square,
};
use crate::numeric::order::{larger, range};
use crate::numeric::work_limit::WorkLimit;
use crate::numeric::zero::difference_at_zero;
use glam::DVec2;

/// Maximum number of bounds evaluated for one cubic before it is rejected; a cubic within the tolerance needs 4 to 40.
const MAX_BOUNDS: usize = 96;

impl OffsetCurve<'_> {
    /// Whether the cubic is proved to be within the tolerance everywhere, with at most `MAX_BOUNDS` bounds.
    pub(super) fn holds(
        &self,
        cubic: &[DVec2; 4],
        pairs: &[FootPair; 5],
        work: &mut WorkLimit,
    ) -> bool {
        let last = work.used() + MAX_BOUNDS;
        pairs
            .windows(2)
            .all(|pair| self.holds_between(cubic, &pair[0], &pair[1], last, work))
    }

    fn holds_between(
        &self,
        cubic: &[DVec2; 4],
        from: &FootPair,
        to: &FootPair,
        last: usize,
        work: &mut WorkLimit,
    ) -> bool {
        if self.bound(from, to) <= self.tolerance || self.near(from, to) {
            return true;
        }
        if work.used() >= last || !work.spend(1) {
            return false;
        }
        let mut middle = [FootPair {
            s: 0.5 * (from.s + to.s),
            ..FootPair::default()
        }];
        middle[0].foot.t = 0.5 * (from.foot.t + to.foot.t);
        self.evaluate_feet(&mut middle);
        evaluate(cubic, &mut middle);
        self.find_feet(&mut middle, (from.foot.t, to.foot.t));
        let [middle] = middle;
        self.error(&middle).abs() <= self.tolerance
            && self.holds_between(cubic, from, &middle, last, work)
            && self.holds_between(cubic, &middle, to, last, work)
    }

    /// Whether the cubic and the offset curve between two pairs are so short that their distance cannot exceed the
    /// tolerance.
    fn near(&self, from: &FootPair, to: &FootPair) -> bool {
        let chord = (to.point - from.point).length();
        if chord > self.tolerance {
            return false;
        }
        // The length of the control polygon is at most that: its outer legs have the lengths Δs |Q′|/3.
        let cubic_length =
            chord + (to.s - from.s) * (from.derivative.length() + to.derivative.length());
        let (a, b) = (&from.foot, &to.foot);
        let offset_length = self.length_bound(a, b);
        let apart =
            |pair: &FootPair| (pair.point - pair.foot.point - pair.normal * self.distance).length();
        a.t <= b.t
            && larger(apart(from), apart(to)) + cubic_length + offset_length <= self.tolerance
    }

    /// The bound between two pairs; infinite if there is none.
    fn bound(&self, from: &FootPair, to: &FootPair) -> f64 {
        let distance = self.distance.abs();
        let (ds, dt) = (to.s - from.s, to.foot.t - from.foot.t);
        // A bound on the distance of the source from a cubic with the same end points and end derivatives.
        let rest = self.fourth * (dt * dt) * (dt * dt) / 384.0;
        if dt.is_nan() || dt <= 0.0 || rest > REMAINDER_SHARE * self.tolerance {
            return f64::INFINITY;
        }
        let (v0, v2) = (from.foot.first * dt, to.foot.first * dt);
        // The mean of the tangent lines to B′ at both ends: differences of points would lose digits for a small dt.
        let half_change = (from.foot.second - to.foot.second) * (0.5 * dt);
        let v1 = (from.foot.first + to.foot.first + half_change) * (0.5 * dt);
        let (e0, e3) = (from.point - from.foot.point, to.point - to.foot.point);
        let e = [
            e0,
            e0 + (from.derivative * ds - v0) * (1.0 / 3.0),
            e3 - (to.derivative * ds - v2) * (1.0 / 3.0),
            e3,
        ];
        let (min, max) = range(cubic_square(&e, DVec2::dot).into_iter());
        let (low, high) = (larger(min, 0.0).sqrt() - rest, max.sqrt() + rest);
        let off = larger(high - distance, distance - low);
        // Q(u) is at most `high` from B(u), and the point of the offset curve is `distance` from it.
        if high + distance <= self.tolerance {
            return high + distance;
        }
        let is_beyond_source = e0.dot(from.normal) * self.distance <= 0.0;
        if off > self.tolerance || is_beyond_source {
            return f64::INFINITY;
        }
        let d = Self::direction([v0, v1, v2]);
        self.with_foot(&e, [v0, v1, v2], &d, (low, high), rest)
    }

    /// The bound including the contribution of the tangential component of E.
    fn with_foot(
        &self,
        e: &[DVec2; 4],
        v: [DVec2; 3],
        d: &[DVec2; 3],
        (low, high): (f64, f64),
        rest: f64,
    ) -> f64 {
        let distance = self.distance.abs();
        let squares = quadratic_square(d, DVec2::dot);
        let (min, max) = range(squares.into_iter());
        let (tangential_low, tangential_high) =
            range(cubic_by_quadratic(e, d, DVec2::dot).into_iter());
        let d_slopes = [(d[1] - d[0]) * 2.0, (d[2] - d[1]) * 2.0];
        let ahead = if *d == v {
            squares
        } else {
            quadratic_by_quadratic(&v, d, DVec2::dot)
        };
        // `ahead` − `curved` is the derivative of −E·d by the parameter of the foot.
        let curved = cubic_by_linear(e, &d_slopes, DVec2::dot);
        let (f_min, f_max) = range((0..5).map(|i| ahead[i] - curved[i]));
        let mut tangential_max = larger(tangential_high, -tangential_low);
        let mut forward = larger(f_min, -f_max);
        let longest =
            |vectors: &[DVec2]| range(vectors.iter().map(|v| v.length_squared())).1.sqrt();
        // The control vectors of Q′ = E′ + B′.
        let mut rate = longest(&[
            (e[1] - e[0]) * 3.0 + v[0],
            (e[2] - e[1]) * 3.0 + v[1],
            (e[3] - e[2]) * 3.0 + v[2],
        ]);
        let mut slope = longest(&d_slopes);
        if rest > 0.0 {
            // With M a bound on the fourth derivative and h the step, B′h differs from the quadratic by at most
            // (1/125 + 1/24) M h⁴ < 20 M h⁴/384, and its derivative by at most eight times as much.
            let fastest = max.sqrt();
            tangential_max += rest * (fastest + 20.0 * high);
            forward -= rest * (40.0 * fastest + 160.0 * high);
            rate += rest * 20.0;
            slope += rest * 160.0;
        }
        // −E·B′ is the derivative of ½ |E|² by the parameter of the foot.
        let square_change = 2.0 * difference_at_zero(tangential_max, forward, rate * slope);
        // Only then is the foot next to this part: where the curve turns slowly, the first condition holds for feet far away.
        if tangential_max < forward && square_change < low * low {
            let found = if f_min > 0.0 {
                larger(
                    high - distance,
                    distance - (low * low - square_change).sqrt(),
                )
            } else {
                larger(
                    (high * high + square_change).sqrt() - distance,
                    distance - low,
                )
            };
            if found <= self.tolerance {
                return found;
            }
        }
        let tangential_square = tangential_max * tangential_max;
        if min <= 0.0 || tangential_square >= low * low * min {
            return f64::INFINITY;
        }
        // δ² is at most that, and the normal component of E is between √(low² − δ²) and `high`.
        let delta_squared = tangential_square / min;
        let up = larger(low * low - delta_squared, 0.0).sqrt();
        let across = larger(high - distance, distance - up);
        (across * across + delta_squared).sqrt()
    }

    /// A quadratic field with the directions of B′dt: B′dt itself, or, if it vanishes at an end, B′dt divided by u or 1
    /// − u.
    fn direction(v: [DVec2; 3]) -> [DVec2; 3] {
        let [v0, v1, v2] = v;
        let (_, max) = range(v.iter().map(|v| v.length_squared()));
        let still = |p: DVec2| p.length_squared() <= VANISHING_SPEED * VANISHING_SPEED * max;
        if still(v0) {
            if still(v1) {
                return [v2; 3];
            }
            // B′dt / u is linear, with the ends 2v₁ and v₂; it is elevated to degree 2.
            return [v1 * 2.0, v1 + v2 * 0.5, v2];
        }
        if still(v2) {
            if still(v1) {
                return [v0; 3];
            }
            return [v0, v1 + v0 * 0.5, v1 * 2.0];
        }
        v
    }
}

/// A cubic that replaces a segment of a higher degree may have an error of this part of the tolerance.
const REMAINDER_SHARE: f64 = 0.02;
