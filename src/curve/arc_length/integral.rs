//! Arc length by numerical integration for any degree, and its inverse.

use crate::bernstein::evaluate::evaluate;
use crate::geometry::check::max_abs;
use crate::geometry::point::Point;
use crate::numeric::list::Points;
use casteljau_kernels::bernstein::de_casteljau::keep_between;
use casteljau_kernels::bernstein::weights::binomial;
use casteljau_kernels::curve::arc_length::speed::speed_integral;
use casteljau_kernels::numeric::vector::Vector;
use casteljau_kernels::numeric::work_limit::WorkLimit;
use casteljau_kernels::numeric::zero::{newton_in_bracket, regula_falsi};
use glam::DVec3;

/// Target error as a part of the length; the documented guarantee is 10⁻¹².
const USUAL_PART: f64 = 1e-14;

/// Maximum depth of cuts: the 53 bits of a parameter, and 3 as a reserve for cuts that are not in the middle.
const MAX_CUTS: usize = f64::MANTISSA_DIGITS as usize + 3;

/// Every interval is halved at least this often at degrees of 25 and more.
const MAX_MIN_DEPTH: usize = 6;

/// Maximum number of intervals, more than ten times what curves with moderate numbers need. After it, the remaining
/// intervals are accepted without a check.
const MAX_INTERVALS: usize = 1 << 12;

/// An interval is cut at its minimum speed if that is at least this part of the interval away from both ends. A minimum
/// closer to an end is separated by the halvings.
const OFF_THE_ENDS: f64 = 0.03;

/// The precision of that minimum, as a part of the interval: at a cusp the rules on both sides err by its square.
const MIN_SPEED_PRECISION: f64 = 1e-10;

/// The distance from the end of an interval to the first node of its rule, rounded up, as a part of the interval. A
/// sharp turn in this range would not be sampled.
const BEFORE_FIRST_NODE: f64 = 0.006;

/// A minimum of the speed is narrow if the speed grows by this factor before the first node: √(a² + b²x²) does so over
/// the width a/b of its tip, from a to √2 a.
const NARROW_MINIMUM: f64 = 1.4;

/// The speed varies much on an interval if the smallest of three speeds is less than this part of the largest. Then both
/// levels must agree to this part of the tolerance: on one of 10⁵ adversarial curves, both estimates agreed 100 times
/// better than either was right.
const STEEP_RATIO: f64 = 0.25;
const STEEP_PART: f64 = 1.0 / 256.0;

/// Cosine of the largest allowed change of direction (25°) before the first node.
const SHARP_COSINE: f64 = 0.9;

/// The speed of a curve, as the table needs it.
pub(crate) trait Speed {
    /// The speed at t.
    fn at(&self, t: f64) -> f64;
    /// The integral of the speed from `lo` to `hi`, by one rule.
    fn integral(&self, lo: f64, hi: f64) -> f64;
    /// A function with the sign of the derivative of the speed.
    fn growth(&self) -> impl Fn(f64) -> f64 + '_;
    /// Vectors whose hull contains the derivative of the curve in an interval; those at the ends have its direction there.
    fn slopes_between(&self, lo: f64, hi: f64) -> Points<DVec3>;
    /// The rounding error of an integral over an interval of length 1 in which the derivative is as between `lo` and `hi`.
    fn rounding_error(&self, lo: f64, hi: f64, slopes: &[DVec3]) -> f64;
}

/// The speed of a polynomial curve.
pub(crate) struct PolynomialSpeed {
    /// The control vectors of B′.
    slopes: Points<DVec3>,
    /// `slopes` times their binomial coefficients.
    weighted: Points<DVec3>,
}

impl PolynomialSpeed {
    /// The speed for the differences of the control points.
    pub(crate) fn new<P: Point>(differences: &[P]) -> Self {
        let degree = differences.len() as f64;
        let slopes: Points<DVec3> = differences.iter().map(|p| p.to_3d() * degree).collect();
        let weighted = times_binomials(&slopes);
        Self { slopes, weighted }
    }
}

/// Coefficients times their binomial coefficients.
pub(crate) fn times_binomials<V: Vector>(coefficients: &[V]) -> Points<V> {
    let last = coefficients.len() - 1;
    let pairs = coefficients.iter().enumerate();
    pairs.map(|(i, &c)| c * binomial(last, i)).collect()
}

impl Speed for PolynomialSpeed {
    fn at(&self, t: f64) -> f64 {
        Point::norm(evaluate(&self.slopes, t))
    }

    fn integral(&self, lo: f64, hi: f64) -> f64 {
        speed_integral(&self.weighted, lo, hi)
    }

    /// B′·B″.
    fn growth(&self) -> impl Fn(f64) -> f64 + '_ {
        let pairs = self.slopes.windows(2);
        let bend: Points<DVec3> = pairs.map(|pair| pair[1] - pair[0]).collect();
        move |t| evaluate(&self.slopes, t).dot(evaluate(&bend, t))
    }

    fn slopes_between(&self, lo: f64, hi: f64) -> Points<DVec3> {
        let mut slopes = self.slopes.clone();
        keep_between(&mut slopes, lo, hi);
        slopes
    }

    fn rounding_error(&self, _lo: f64, _hi: f64, slopes: &[DVec3]) -> f64 {
        (slopes.len() as f64 + 4.0) * f64::EPSILON * max_abs(slopes)
    }
}

/// An interval that one rule integrates: its end, and the arc length up to that end.
#[derive(Clone, Copy)]
struct Interval {
    t: f64,
    length: f64,
}

/// The speed of a curve, cut into intervals that one rule integrates accurately.
pub(crate) struct ArcLengthTable<S = PolynomialSpeed> {
    source: S,
    /// The number of control vectors of B′.
    slope_count: usize,
    intervals: Vec<Interval>,
    /// Counts the intervals.
    work: WorkLimit,
    tolerance: f64,
    /// Rounding error of an integral over [0, 1].
    noise: f64,
}

impl<S: Speed> ArcLengthTable<S> {
    /// Makes the table from a speed that is of moderate size and not 0 everywhere.
    /// `tolerance`, infinite for none, is used only if it is finer than the usual target. A coarser tolerance does not
    /// reduce the work: rules of a few points may agree by chance, and a large error would not be detected.
    pub(crate) fn new(source: S, tolerance: f64) -> Self {
        let slopes = source.slopes_between(0.0, 1.0);
        let mut arc = Self {
            intervals: Vec::new(),
            work: WorkLimit::new(MAX_INTERVALS),
            tolerance: 0.0,
            noise: source.rounding_error(0.0, 1.0, &slopes),
            slope_count: slopes.len(),
            source,
        };
        let whole = arc.between(0.0, 1.0);
        arc.tolerance = (USUAL_PART * whole).min(tolerance / 8.0);
        arc.refine(0.0, 1.0, whole, 0);
        arc
    }

    /// The arc length of the whole curve.
    pub(crate) fn length(&self) -> f64 {
        self.intervals
            .last()
            .map_or(0.0, |interval| interval.length)
    }

    /// The arc length up to t, for 0 ≤ t ≤ 1.
    #[cfg(feature = "regions")]
    pub(crate) fn length_at(&self, t: f64) -> f64 {
        let k = self.intervals.partition_point(|interval| interval.t < t);
        match self.intervals.get(k) {
            Some(end) if end.t == t => end.length,
            _ => {
                let start = self.start(k);
                start.length + self.between(start.t, t)
            }
        }
    }

    /// The start of an interval.
    fn start(&self, k: usize) -> Interval {
        let zero = Interval {
            t: 0.0,
            length: 0.0,
        };
        k.checked_sub(1)
            .map_or(zero, |before| self.intervals[before])
    }

    /// The t up to which the arc length is s, for 0 ≤ s ≤ the whole length; `slack` is the allowed error of s.
    ///
    /// Newton's method inside an interval of the table, with bisection where it leaves the bracket that contains t.
    pub(crate) fn time(&self, s: f64, slack: f64) -> f64 {
        let last = self.intervals.len() - 1;
        let k = self
            .intervals
            .partition_point(|interval| interval.length < s)
            .min(last);
        let start = self.start(k);
        let Interval { t: end, length } = self.intervals[k];
        let (rest, whole) = (s - start.length, length - start.length);
        let guess = self.first_guess(start.t, end, rest / whole, whole);
        newton_in_bracket([start.t, end], guess, slack, |t| {
            (self.between(start.t, t) - rest, self.speed(t))
        })
    }

    /// First guess of t: the cubic Hermite interpolant of t over the part x of the length, with the derivatives at both
    /// ends.
    fn first_guess(&self, lo: f64, hi: f64, x: f64, length: f64) -> f64 {
        let even = length / (hi - lo);
        // The derivatives of t by the length at both ends, both scaled to [0, 1], minus 1.
        let [first, second] = [lo, hi].map(|t| even / self.speed(t) - 1.0);
        let guess = x + x * (1.0 - x) * (first * (1.0 - x) - second * x);
        // The guess may be infinite or NaN if the speed is 0 at an end.
        let part = if guess > 0.0 && guess < 1.0 { guess } else { x };
        (lo + (hi - lo) * part).clamp(lo, hi)
    }

    fn speed(&self, t: f64) -> f64 {
        self.source.at(t)
    }

    /// ∫ |B′| from `lo` to `hi`, by one rule.
    fn between(&self, lo: f64, hi: f64) -> f64 {
        self.source.integral(lo, hi)
    }

    /// Cuts an interval until the integrals over both parts together agree with the integral over the whole; then each
    /// part is accurate.
    fn refine(&mut self, lo: f64, hi: f64, whole: f64, depth: usize) {
        let cut = self.location_of_cut(lo, hi, depth);
        let (left, right) = (self.between(lo, cut), self.between(cut, hi));
        let off = (left + right - whole).abs();
        let good = depth >= self.min_depth()
            && off <= self.allowed_difference([lo, cut, hi], self.noise)
            && self.is_accurate([lo, cut, hi], off)
            && [(lo, cut), (cut, lo), (cut, hi), (hi, cut)]
                .into_iter()
                .all(|(end, other)| self.ends_smoothly(end, other));
        if !self.work.spend(1) || good || depth >= MAX_CUTS {
            self.push(cut, left);
            self.push(hi, right);
        } else {
            self.refine(lo, cut, left, depth + 1);
            self.refine(cut, hi, right, depth + 1);
        }
    }

    /// Whether the difference between both levels is allowed for the rounding of this interval alone, and the curve does
    /// not reverse between the nodes of a rule, which would not detect it.
    fn is_accurate(&self, at @ [lo, _, hi]: [f64; 3], off: f64) -> bool {
        let slopes = self.source.slopes_between(lo, hi);
        let noise = self.source.rounding_error(lo, hi, &slopes);
        let chord = slopes.iter().fold(DVec3::ZERO, |sum, &slope| sum + slope);
        off <= self.allowed_difference(at, noise) && !self.deviates(&slopes, chord, 0.0, hi - lo)
    }

    /// The largest difference between both levels at which an interval is accepted; `noise` is the rounding error of an
    /// integral over [0, 1].
    ///
    /// Where the speed varies much, the error of a rule does not shrink steadily from level to level, and two levels may
    /// agree by chance.
    fn allowed_difference(&self, at: [f64; 3], noise: f64) -> f64 {
        let [a, b, c] = at.map(|t| self.speed(t));
        let steep = a.min(b).min(c) < STEEP_RATIO * a.max(b).max(c);
        let part = if steep { STEEP_PART } else { 1.0 };
        (part * self.tolerance).max(noise * (at[2] - at[0]))
    }

    /// Whether nothing is hidden between an end of an interval and the first node of its rule.
    fn ends_smoothly(&self, end: f64, other: f64) -> bool {
        !self.slows_down_near(end, other) && !self.turns_near(end, other)
    }

    /// High degrees may oscillate between the nodes of the first rules.
    fn min_depth(&self) -> usize {
        (self.slope_count / 4).min(MAX_MIN_DEPTH)
    }

    /// Whether the curve turns sharply between an end and the first node, where no rule samples it. At the end itself
    /// the derivative may be zero.
    fn turns_near(&self, end: f64, cut: f64) -> bool {
        let node = end + BEFORE_FIRST_NODE * (cut - end);
        let (lo, hi) = (end.min(node), end.max(node));
        let slopes = self.source.slopes_between(lo, hi);
        // The derivative at the node.
        let inside = slopes[if node < end { 0 } else { slopes.len() - 1 }];
        self.deviates(&slopes, inside, SHARP_COSINE, hi - lo)
    }

    /// Whether the speed has a narrow minimum at an end of an interval, before the first node of its rule.
    ///
    /// Next to a near-cusp the speed is √(a² + b²x²) or similar, with a tiny a. The rules of both levels miss the same
    /// contribution of its tip, which is at most about a times the width of the tip, so that they agree all the same.
    fn slows_down_near(&self, end: f64, other: f64) -> bool {
        let width = BEFORE_FIRST_NODE * (other - end);
        let hidden = self.tolerance.max(self.noise * (other - end).abs());
        let min = self.speed(end);
        min * width.abs() > hidden && self.speed(end + width) > NARROW_MINIMUM * min
    }

    /// Whether one of the derivative's control points on an interval deviates from a direction by an angle whose cosine
    /// is below `cosine`, and contributes more than the tolerance over the width. The derivative lies in the convex
    /// hull of these points.
    fn deviates(&self, slopes: &[DVec3], direction: DVec3, cosine: f64, width: f64) -> bool {
        let hidden = self.tolerance.max(self.noise * width);
        let size = cosine * Point::norm(direction);
        slopes.iter().any(|&slope| {
            let length = Point::norm(slope);
            slope.dot(direction) <= size * length && length * width > hidden
        })
    }

    fn push(&mut self, t: f64, length: f64) {
        let before = self.length();
        self.intervals.push(Interval {
            t,
            length: before + length,
        });
    }

    /// The middle; at depth 2 and more the minimum of the speed, if it is inside.
    fn location_of_cut(&self, lo: f64, hi: f64, depth: usize) -> f64 {
        let middle = 0.5 * (lo + hi);
        if depth < 2 {
            return middle;
        }
        let min = self.min_speed(lo, hi);
        let margin = OFF_THE_ENDS * (hi - lo);
        if min > lo + margin && min < hi - margin {
            min
        } else {
            middle
        }
    }

    /// The parameter of a minimum of the speed inside; otherwise an end.
    fn min_speed(&self, lo: f64, hi: f64) -> f64 {
        let growth = self.source.growth();
        let (before, after) = (growth(lo), growth(hi));
        if !(before < 0.0 && after > 0.0) {
            return lo;
        }
        let precision = MIN_SPEED_PRECISION * (hi - lo) / hi;
        // Negated, because `regula_falsi` expects a change from + to −.
        regula_falsi([lo, hi], [-before, -after], precision, |t| -growth(t))
    }
}
