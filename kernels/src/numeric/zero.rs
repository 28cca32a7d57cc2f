//! Zeros of functions inside a bracket: fast methods that fall back on bisection.

/// The maximum number of steps of Newton's method; bisection alone needs about 64.
const MAX_NEWTON_STEPS: usize = 80;

/// A root is accurate enough when the width of its interval is this part of it.
pub const ROOT_WIDTH: f64 = 1e-13;

/// The maximum number of steps of regula falsi: three steps halve the bracket or contain a bisection, and about 60
/// halvings exhaust the digits.
const MAX_SECANT_STEPS: usize = 200;

/// A zero between lo and hi of a function that is negative at lo and positive at hi, by Newton's method from `t`;
/// a step that leaves the bracket is replaced by bisection.
///
/// `f` returns the value and the derivative. The search ends when the value is at most `slack`, or a step changes only
/// the last digit.
#[inline(always)]
pub fn newton_in_bracket(
    [mut lo, mut hi]: [f64; 2],
    mut t: f64,
    slack: f64,
    mut f: impl FnMut(f64) -> (f64, f64),
) -> f64 {
    for _ in 0..MAX_NEWTON_STEPS {
        let (value, slope) = f(t);
        if value.abs() <= slack {
            break;
        }
        if value < 0.0 {
            lo = t;
        } else {
            hi = t;
        }
        let newton = t - value / slope;
        let next = if newton > lo && newton < hi {
            newton
        } else {
            0.5 * (lo + hi)
        };
        if (next - t).abs() <= f64::EPSILON * t {
            return next;
        }
        t = next;
    }
    t
}

/// A zero between lo and hi of a function that is positive at lo and negative at hi, by regula falsi (Illinois
/// algorithm). Where the bracket has not halved in three steps, one step bisects.
///
/// `values` are the values at both ends. The search ends when the width of the bracket is at most `precision` times its
/// upper end, or the bracket contains no further number. Source: Dowell and Jarratt, "A modified regula falsi method
/// for computing the root of an equation", BIT 11 (1971).
#[inline]
pub fn regula_falsi(
    [mut lo, mut hi]: [f64; 2],
    [mut f_lo, mut f_hi]: [f64; 2],
    precision: f64,
    f: impl Fn(f64) -> f64,
) -> f64 {
    // The sign of the last value: if it repeats, the other end was kept, and its value is halved.
    let mut last = 0.0;
    let mut earlier_width = hi - lo;
    for step in 0..MAX_SECANT_STEPS {
        let middle = 0.5 * (lo + hi);
        if hi - lo <= precision * hi || middle <= lo || middle >= hi {
            break;
        }
        let secant = lo + (hi - lo) * f_lo / (f_lo - f_hi);
        let is_slow = step % 3 == 2 && hi - lo > 0.5 * earlier_width;
        if step % 3 == 2 {
            earlier_width = hi - lo;
        }
        let t = if is_slow || !(secant > lo && secant < hi) {
            middle
        } else {
            secant
        };
        let value = f(t);
        if value == 0.0 {
            return t;
        }
        let share = if last * value > 0.0 { 0.5 } else { 1.0 };
        if value > 0.0 {
            (lo, f_lo) = (t, value);
            f_hi *= share;
        } else {
            (hi, f_hi) = (t, value);
            f_lo *= share;
        }
        last = value.signum();
    }
    0.5 * (lo + hi)
}

/// A bound of the difference between the value of a function at a point and at a zero of its derivative next to it;
/// infinite if there need not be one.
///
/// At the point the derivative is at most `slope`; at a distance x from it the second derivative has a constant sign and
/// is at least `curvature` − `change`·x. Within the distance at which that is m = (curvature + √(curvature² −
/// 4 change slope))/2 the derivative has a zero, and the values differ by at most slope²/(2m).
#[inline]
pub fn difference_at_zero(slope: f64, curvature: f64, change: f64) -> f64 {
    let discriminant = curvature * curvature - 4.0 * change * slope;
    if curvature > 0.0 && discriminant >= 0.0 {
        slope * slope / (curvature + discriminant.sqrt())
    } else {
        f64::INFINITY
    }
}
