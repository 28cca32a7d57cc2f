//! A curve together with its first two derivatives.

use crate::bernstein::evaluate::evaluate;
use crate::geometry::point::Point;
use crate::numeric::list::Points;

/// The maximum number of steps to the foot of a perpendicular; some of them may halve the one before.
const FOOT_STEPS: usize = 40;

/// A smaller step changes nothing: some roundings of a parameter.
pub(crate) const LAST_STEP: f64 = 1e-15;

pub(crate) struct CurveWithDerivatives<'a, P: Point> {
    pub(crate) points: &'a [P],
    pub(crate) first: Points<P>,
    second: Points<P>,
}

impl<'a, P: Point> CurveWithDerivatives<'a, P> {
    pub(crate) fn new(points: &'a [P]) -> Self {
        let rate = |points: &[P]| -> Points<P> {
            let n = points.len() - 1;
            let steps = points.windows(2).map(|p| (p[1] - p[0]) * n as f64);
            if n == 0 {
                Points::from([P::default()].as_slice())
            } else {
                steps.collect()
            }
        };
        let first = rate(points);
        let second = rate(&first);
        Self {
            points,
            first,
            second,
        }
    }

    pub(crate) fn at(&self, t: f64) -> P {
        evaluate(self.points, t)
    }

    pub(crate) fn derivatives(&self, t: f64) -> [P; 2] {
        [evaluate(&self.first, t), evaluate(&self.second, t)]
    }

    /// The point and the first two derivatives.
    pub(crate) fn jet(&self, t: f64) -> [P; 3] {
        let [first, second] = self.derivatives(t);
        [self.at(t), first, second]
    }
}

/// The parameter of the foot of the perpendicular from a point, or of the nearer end, found from a nearby parameter by
/// Newton's method. Steps that increase the distance are halved. The curve is given by its point and its first two derivatives.
pub(crate) fn foot<P: Point>(jet: impl Fn(f64) -> [P; 3], point: P, near: f64) -> f64 {
    let (mut best, mut min) = (near, f64::INFINITY);
    let mut t = near;
    for _ in 0..FOOT_STEPS {
        let [p, d, dd] = jet(t);
        let gap = p - point;
        let distance = gap.dot(gap);
        if distance >= min {
            if (t - best).abs() <= LAST_STEP {
                break;
            }
            t = 0.5 * (t + best);
            continue;
        }
        (best, min) = (t, distance);
        // Newton's method for (B − q) · B′ = 0 where it leads to a minimum, otherwise a step along the tangent.
        let second = d.dot(d) + gap.dot(dd);
        let slope = if second > 0.5 * d.dot(d) {
            second
        } else {
            d.dot(d)
        };
        let next = t - gap.dot(d) / slope;
        if !next.is_finite() {
            break;
        }
        t = next.clamp(0.0, 1.0);
    }
    best
}
