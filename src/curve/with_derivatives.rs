//! A curve together with its first two derivatives.

use crate::bernstein::evaluate::evaluate;
use crate::geometry::point::Point;
use crate::numeric::list::Points;

pub(crate) struct CurveWithDerivatives<'a, P: Point> {
    pub(crate) points: &'a [P],
    first: Points<P>,
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
}
