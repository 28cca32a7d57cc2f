//! Fitting of the handle lengths by least squares.

use super::source::OffsetSample;
use super::{End, OffsetCurve};
use crate::bernstein::derivatives::cubic_with_derivative;
use crate::numeric::order::larger;
use crate::numeric::work_limit::WorkLimit;
use crate::spline::handles::{HandleEquations, MAX_ROUNDS, MIN_DAMPING};
use glam::DVec2;

/// The parameters at which distances are measured.
const SAMPLES: [f64; 3] = [0.25, 0.5, 0.75];

/// Maximum number of Newton steps for the foot of a perpendicular; the least-squares rounds use one or two.
const FOOT_STEPS: u8 = 4;

/// If the error at the samples is below this part of the tolerance, it cannot be the reason why a bound fails.
const SMALL_PART: f64 = 0.01;

/// A point of the cubic (parameter, point and derivative) and the foot of its perpendicular on the source.
#[derive(Clone, Copy, Default)]
pub(super) struct FootPair {
    /// The unit normal at the foot.
    pub(super) normal: DVec2,
    /// The parameter of the cubic.
    pub(super) s: f64,
    pub(super) point: DVec2,
    pub(super) derivative: DVec2,
    pub(super) foot: OffsetSample,
}

impl OffsetCurve<'_> {
    /// A cubic from one end to the other within the tolerance, if one is found.
    pub(super) fn fit(&self, from: &End, to: &End, work: &mut WorkLimit) -> Option<[DVec2; 4]> {
        let (mut a, mut b) = self.first_handles(from, to);
        let mut previous = f64::INFINITY;
        let mut pairs = self.pairs(from, to);
        let between = (from.sample.t, to.sample.t);
        for round in 0..MAX_ROUNDS {
            let cubic = self.cubic(from, to, (a, b));
            let mut equations = HandleEquations::default();
            let mut worst: f64 = 0.0;
            let [_, inner @ .., _] = &mut pairs;
            evaluate(&cubic, inner);
            // In the first round the feet start at proportional parameters, later at the feet of the previous round.
            for _ in 0..if round == 0 { 2 } else { 1 } {
                self.step(inner, between);
            }
            set_normals(inner);
            for pair in inner {
                let n = pair.normal;
                let error = self.error(pair);
                worst = larger(worst, error.abs());
                equations.add(pair.s, [from.tangent.dot(n), to.tangent.dot(n)], error);
            }
            if worst <= self.tolerance {
                self.evaluate_ends(&cubic, &mut pairs);
                let [_, inner @ .., _] = &mut pairs;
                self.find_feet(inner, between);
                if self.holds(&cubic, &pairs, work) {
                    return Some(cubic);
                }
            }
            let improves = worst < 0.5 * previous;
            if worst <= SMALL_PART * self.tolerance || !improves {
                return None;
            }
            previous = worst;
            if round + 1 == MAX_ROUNDS {
                break;
            }
            let [da, db] = equations.solved(MIN_DAMPING);
            // A handle must not lead against the direction of the offset curve; it may have the length 0.
            a = from.sign * larger(from.sign * (a + da), 0.0);
            b = to.sign * larger(to.sign * (b + db), 0.0);
        }
        None
    }

    /// The sums of the handles of the source's segment and of the arc of the normal, 4/3 tan(θ/4).
    pub(super) fn first_handles(&self, from: &End, to: &End) -> (f64, f64) {
        let third = (to.sample.t - from.sample.t) / 3.0;
        let (cos, sin) = (
            from.tangent.dot(to.tangent),
            from.tangent.perp_dot(to.tangent),
        );
        let half_cos = larger(0.5 + 0.5 * cos, 0.0).sqrt();
        // The root of 1 − cos θ would lose the digits of a small angle.
        let half_sin = if cos > 0.0 {
            0.5 * sin / half_cos
        } else {
            larger(0.5 - 0.5 * cos, 0.0).sqrt().copysign(sin)
        };
        // tan(θ/4) = sin(θ/2) / (1 + cos(θ/2)).
        let arc = self.distance * (4.0 / 3.0) * half_sin / (1.0 + half_cos);
        let handle = |end: &End| {
            let length = third * end.sample.first.length() - arc;
            end.sign * larger(end.sign * length, 0.0)
        };
        (handle(from), handle(to))
    }

    fn pairs(&self, from: &End, to: &End) -> [FootPair; 5] {
        let mut pairs = [FootPair::default(); 5];
        (pairs[0].foot, pairs[0].normal) = (from.sample, from.tangent.perp());
        (pairs[4].s, pairs[4].foot, pairs[4].normal) = (1.0, to.sample, to.tangent.perp());
        for (pair, s) in pairs[1..4].iter_mut().zip(SAMPLES) {
            pair.s = s;
            pair.foot.t = from.sample.t + (to.sample.t - from.sample.t) * s;
        }
        self.evaluate_feet(&mut pairs[1..4]);
        pairs
    }

    /// Evaluates the source at the parameters of the feet.
    pub(super) fn evaluate_feet(&self, pairs: &mut [FootPair]) {
        for pair in pairs {
            pair.foot = self.source.at(pair.foot.t);
        }
    }

    /// Finds the points of the source on whose normals the points of the pairs lie, by at most `FOOT_STEPS` Newton steps,
    /// which all pairs take together.
    pub(super) fn find_feet(&self, pairs: &mut [FootPair], between: (f64, f64)) {
        for _ in 0..FOOT_STEPS {
            let is_found = |pair: &FootPair| {
                let first = pair.foot.first;
                let along = (pair.point - pair.foot.point).dot(first);
                along * along <= self.foot_square * first.length_squared()
            };
            if pairs.iter().all(is_found) {
                break;
            }
            self.step(pairs, between);
        }
        set_normals(pairs);
    }

    /// A Newton step towards the feet; a function of its own, because copies of it are larger and not faster.
    #[inline(never)]
    fn step(&self, pairs: &mut [FootPair], between: (f64, f64)) {
        for pair in pairs.iter_mut() {
            let foot = &pair.foot;
            let gap = pair.point - foot.point;
            let (along, square) = (gap.dot(foot.first), foot.first.length_squared());
            let t = foot.t + along / (square - gap.dot(foot.second));
            pair.foot.t = inside(between, foot.t, t);
        }
        self.evaluate_feet(pairs);
    }

    /// The signed distance from the source minus the given distance.
    pub(super) fn error(&self, pair: &FootPair) -> f64 {
        (pair.point - pair.foot.point).dot(pair.normal) - self.distance
    }

    fn evaluate_ends(&self, cubic: &[DVec2; 4], pairs: &mut [FootPair; 5]) {
        let [p0, p1, p2, p3] = *cubic;
        (pairs[0].point, pairs[0].derivative) = (p0, (p1 - p0) * 3.0);
        (pairs[4].point, pairs[4].derivative) = (p3, (p3 - p2) * 3.0);
    }
}

/// Evaluates a cubic at the parameters of pairs.
pub(super) fn evaluate(cubic: &[DVec2; 4], pairs: &mut [FootPair]) {
    for pair in pairs {
        (pair.point, pair.derivative) = cubic_with_derivative(cubic, pair.s);
    }
}

fn set_normals(pairs: &mut [FootPair]) {
    for pair in pairs {
        pair.normal = pair.foot.first.normalize_or_zero().perp();
    }
}

/// The next parameter of a Newton iteration: where it would leave the interval, half the way to that end.
#[inline]
fn inside((t0, t1): (f64, f64), last: f64, next: f64) -> f64 {
    if next <= t0 {
        0.5 * (t0 + last)
    } else if next >= t1 {
        0.5 * (last + t1)
    } else if next.is_nan() {
        last
    } else {
        next
    }
}
