//! The CSS timing functions `steps()` and `linear()`.
//!
//! `js/geometry/easing-piecewise.ts` performs the same operations in the same order.

use crate::geometry::error::Error;

/// At which ends of the range of x a step function jumps, in addition to the jumps between its intervals.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum StepPosition {
    Start,
    End,
    None,
    Both,
}

/// A control point of `linear()`: a percentage, with x = percentage/100, and y.
pub(crate) type Stop = [f64; 2];

/// The largest number of stops that replace a step function.
const MAX_STOPS: usize = 65_536;

/// The nearest finite number, for results that overflow.
pub(crate) fn clamp_to_finite(value: f64) -> f64 {
    value.clamp(-f64::MAX, f64::MAX)
}

impl StepPosition {
    /// Whether the output jumps at x = 0 and at x = 1.
    fn jumps(self) -> [bool; 2] {
        match self {
            Self::Start => [true, false],
            Self::End => [false, true],
            Self::None => [false, false],
            Self::Both => [true, true],
        }
    }
}

/// The timing function `steps(count, position)`.
///
/// Source: CSS Easing Functions Level 2, "Step easing functions".
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Steps {
    /// The number of intervals.
    pub(crate) count: u32,
    pub(crate) position: StepPosition,
}

impl Steps {
    /// The step at x = 0, and the number of jumps.
    fn range(self) -> [f64; 2] {
        let [at_start, at_end] = self
            .position
            .jumps()
            .map(|jumps| f64::from(u8::from(jumps)));
        [at_start, f64::from(self.count) - 1.0 + at_start + at_end]
    }

    pub(crate) fn eval(self, x: f64) -> f64 {
        let [at_start, jumps] = self.range();
        let mut step = (x * f64::from(self.count)).floor() + at_start;
        if x >= 0.0 {
            step = step.max(0.0);
        }
        if x <= 1.0 {
            step = step.min(jumps);
        }
        clamp_to_finite(step / jumps) + 0.0 // turns −0 into 0
    }

    /// The stops of the `linear()` that is equal to this function.
    ///
    /// # Errors
    /// [`Error::TooMany`] for more than 65,536.
    pub(crate) fn stops(self) -> Result<Vec<Stop>, Error> {
        let [_, at_end] = self.position.jumps();
        let needed = 2 * self.count as usize + usize::from(at_end);
        if needed > MAX_STOPS {
            let (what, limit) = ("stops", MAX_STOPS);
            return Err(Error::too_many(what, limit, needed));
        }
        let [at_start, jumps] = self.range();
        // Interval i has stop 2i at its start and stop 2i + 1 at its end; one more is the jump at x = 1.
        let stop = |k: usize| {
            let (interval, place) = (k / 2, k.div_ceil(2));
            [
                100.0 * place as f64 / f64::from(self.count),
                (interval as f64 + at_start) / jumps,
            ]
        };
        Ok((0..needed).map(stop).collect())
    }
}

/// The timing function `linear(…)`: at a jump the last stop holds.
///
/// Source: CSS Easing Functions Level 2, "Output of a linear easing function".
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Linear {
    /// At least two, with ascending percentages.
    pub(crate) stops: Vec<Stop>,
}

impl Linear {
    pub(crate) fn eval(&self, x: f64) -> f64 {
        let point = |k: usize| [self.stops[k][0] / 100.0, self.stops[k][1] + 0.0]; // turns −0 into 0
        let passed = self.stops.partition_point(|stop| stop[0] / 100.0 <= x);
        if passed > 0 && point(passed - 1)[0] == x {
            return point(passed - 1)[1];
        }
        // Beyond the ends the first and the last part continue.
        let first = passed.saturating_sub(1).min(self.stops.len() - 2);
        let ([ax, ay], [bx, by]) = (point(first), point(first + 1));
        if ax == bx {
            return by;
        }
        // Differences are halved, so that they do not overflow.
        let rise = by / 2.0 - ay / 2.0;
        let width = bx / 2.0 - ax / 2.0;
        if rise == 0.0 || width == 0.0 {
            return ay;
        }
        clamp_to_finite(ay + 2.0 * (rise * ((x / 2.0 - ax / 2.0) / width))) + 0.0
    }
}
