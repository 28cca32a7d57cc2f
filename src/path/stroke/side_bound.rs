//! A bound of the distance between a cubic and one side of a stroke of varying radius.
//!
//! Take two pairs, each of a point of the cubic Q and a disc of the stroke, whose centre is on the curve B. Between them
//! let u run from 0 to 1 on the cubic, on the curve and along the radius r; B and r are replaced by cubics with the same
//! values and derivatives at the pairs. With E = Q − B, the distance of a point of the cubic from a disc is f = |E| − r. Where f
//! is stationary as a function of the disc, it is the distance from the side. With M = (E, r), W = (B′, −r′) and the product
//! ⟨a, b⟩ = a₁b₁ + a₂b₂ − a₃b₃ the polynomials
//!
//!   ⟨M, M⟩ = (|E| + r) f,   ⟨M, W⟩ = −|E| f′ − f r′,   ⟨W, W⟩ − ⟨M, W′⟩ = |E| f″ + f′ (f′ + 2 r′) + f r″
//!
//! (where f′ and f″ are derivatives with respect to the disc) lie between their least and their greatest Bernstein
//! coefficient. So f is bounded, and the stationary value differs from it by at most f′²/(2 f″), which is doubled here:
//! f″ is bounded only at the pairs between. Next to cusps of a side f″ is 0; while the stationary disc is between the two
//! pairs, its value differs by at most |f′|. That disc moves along with u from the first pair of the cubic to the last one,
//! so every point of the side is as near to the cubic. Intervals for which the bound is too large are halved.
//!
//! The idea of M is from Choi, Choi and Moon, "Mathematical theory of medial axis transform", Pacific J. Math. 181 (1997).

use super::section::{Disc, SectionEvaluator};
use crate::bernstein::vector_products::{
    cubic_by_linear, cubic_by_quadratic, cubic_square, quadratic_by_quadratic,
};
use crate::curve::with_derivatives::CurveWithDerivatives;
use crate::geometry::point::Point;
use crate::numeric::order::range;
use crate::numeric::work_limit::WorkLimit;
use glam::{DVec2, DVec3};

/// Maximum number of bounds evaluated for one cubic before it is rejected.
const MAX_BOUNDS: usize = 96;

/// Newton steps to the point of a cubic next to a point of the side.
const FOOT_STEPS: usize = 2;

/// A point of a cubic, and the disc whose point of the side is next to it.
#[derive(Clone, Copy)]
pub(super) struct Pair {
    /// The parameter of the cubic.
    pub(super) u: f64,
    /// The parameter of the disc on the section.
    pub(super) t: f64,
    pub(super) disc: Disc,
}

/// A cubic that may stand for a part of a side.
pub(super) struct SideBound<'a> {
    pub(super) evaluator: &'a SectionEvaluator<'a>,
    pub(super) side: f64,
    /// −1 where the side runs backwards.
    pub(super) sign: f64,
    pub(super) tolerance: f64,
    pub(super) cubic: CurveWithDerivatives<'a, DVec2>,
}

impl SideBound<'_> {
    /// Whether the cubic is proved to be within the tolerance of the side between the first and the last pair.
    pub(super) fn holds(&self, pairs: &[Pair]) -> bool {
        let mut work = WorkLimit::new(MAX_BOUNDS);
        pairs
            .windows(2)
            .all(|pair| self.holds_between(&pair[0], &pair[1], &mut work))
    }

    fn holds_between(&self, from: &Pair, to: &Pair, work: &mut WorkLimit) -> bool {
        if self.bound(from, to) <= self.tolerance {
            return true;
        }
        if !work.spend(1) {
            return false;
        }
        let t = 0.5 * (from.t + to.t);
        let disc = self.evaluator.at(t);
        let point = disc.point(self.side);
        let mut u = 0.5 * (from.u + to.u);
        for _ in 0..FOOT_STEPS {
            u = foot_step(&self.cubic, u, point).clamp(from.u, to.u);
        }
        let middle = Pair { u, t, disc };
        Point::norm(self.cubic.at(u) - point) <= self.tolerance
            && self.holds_between(from, &middle, work)
            && self.holds_between(&middle, to, work)
    }

    /// The bound between two pairs; infinite or NaN if there is none.
    fn bound(&self, from: &Pair, to: &Pair) -> f64 {
        let (du, dt) = (to.u - from.u, to.t - from.t);
        // (B, −r), and W and W′.
        let [p, q] = [from, to].map(|pair| pair.disc.center.extend(-pair.disc.radius));
        let [v, w] = [from, to].map(|pair| {
            let disc = &pair.disc;
            disc.tangent.extend(-disc.slope) * (disc.speed * dt)
        });
        let slopes = [v, (q - p) * 3.0 - v - w, w];
        let changes = [(slopes[1] - slopes[0]) * 2.0, (slopes[2] - slopes[1]) * 2.0];
        // M, from its values and derivatives at the ends.
        let [a, d] = [(from, p, v), (to, q, w)].map(|(pair, disc, rate)| {
            let [point, first, _] = self.cubic.jet(pair.u);
            [(point, disc), (first * du, rate)]
                .map(|(of_cubic, of_disc)| of_cubic.extend(0.0) - of_disc)
        });
        let m = [a[0], a[0] + a[1] / 3.0, d[0] - d[1] / 3.0, d[0]];
        let rest = self
            .evaluator
            .section
            .hermite_error(slopes.map(DVec3::truncate), dt);
        let largest = |values: &[DVec3]| values.iter().fold(0.0, |max: f64, v| max.max(v.z.abs()));
        let least_radius = m.iter().fold(f64::INFINITY, |min, v| min.min(v.z)).max(0.0);
        // f is between −r and |E|.
        let size = m
            .iter()
            .fold(largest(&m), |max, v| max.max(Point::norm(v.truncate())));
        if size + rest <= self.tolerance {
            return size + rest;
        }
        let (min, max) = range(cubic_square(&m, product).into_iter());
        let least = (least_radius * least_radius + min).max(0.0).sqrt();
        let off = max.max(-min) / (least_radius + least);
        let (min, max) = range(cubic_by_quadratic(&m, &slopes, product).into_iter());
        let f_rate = (max.max(-min) + off * largest(&slopes)) / least;
        let squares = quadratic_by_quadratic(&slopes, &slopes, product);
        let bends = cubic_by_linear(&m, &changes, product);
        let ahead = (0..5).map(|k| self.sign * (squares[k] - bends[k]));
        let curvature = ahead.fold(f64::INFINITY, f64::min)
            - f_rate * (2.0 * largest(&slopes) + f_rate)
            - off * largest(&changes);
        let steps = f_rate * size / curvature.max(0.0);
        off + f_rate * steps.min(1.0) + rest
    }
}

/// ⟨a, b⟩.
fn product(a: DVec3, b: DVec3) -> f64 {
    a.x * b.x + a.y * b.y - a.z * b.z
}

/// A Newton step from a parameter of a curve to that of its point next to another one.
pub(super) fn foot_step(curve: &CurveWithDerivatives<DVec2>, t: f64, point: DVec2) -> f64 {
    let [p, first, _] = curve.jet(t);
    let step = (p - point).dot(first) / first.dot(first);
    if step.is_finite() {
        (t - step).clamp(0.0, 1.0)
    } else {
        t
    }
}
