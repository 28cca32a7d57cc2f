//! Arc length of plane cubics by integration of the speed.

use crate::numeric::gauss::{GAUSS_8, GAUSS_16, GAUSS_24, GAUSS_32, GAUSS_48, GAUSS_64, Rule};
use crate::numeric::lanes::f64x2;
use crate::numeric::order::larger;
use crate::numeric::order::smaller;
use crate::numeric::zero::newton_in_bracket;

type Complex = [f64; 2];

/// A root this close to the end of an interval, in half lengths, does not impair a rule: the difference of |z − root|
/// from a linear function integrates to half the square of this times a logarithm.
const AT_THE_END: f64 = 1e-8;

/// Thresholds of the rules of 8, 16, 24, 32, 48 and 64 points. The interval is scaled to [−1, 1]. If (|z − 1| + |z +
/// 1|) / 2 of every root z is at least the threshold, the relative error is below 5·10⁻¹³, and mostly much smaller.
/// This value is half the major axis of the ellipse through z with the foci ±1, inside which the speed is analytic. The
/// thresholds were found by integrating |z − root|, whose integral has a closed form, for roots all around each
/// ellipse.
const MIN_AXIS: [f64; 6] = [2.45, 1.29, 1.12, 1.0655, 1.0275, 1.0156];

/// For a root away from the middle, the interval is cut at this multiple of the root's distance from the end: on either
/// side of the cut a rule of 24 or 32 points suffices for this root.
const CUT_RATIO: f64 = 5.0;

/// If the projection of a root is at most this far from the middle, in half lengths, the interval is cut at the
/// projection.
const SPLIT_AT_PROJECTION_WITHIN: f64 = 0.75;

/// The arc length of a plane cubic, with a relative error of some 10⁻¹³.
///
/// In complex numbers, the derivative is a quadratic polynomial q. The only singularities of the speed |q(z)| = |e| |z
/// − z₁| |z − z₂| are the two roots, which have a closed form. Their distance from an interval determines which rule
/// suffices; if none does, the interval is cut at the minimum of the speed, or closer to it. Source of the error bounds
/// of Gauss rules by ellipses: Trefethen, *Approximation Theory and Approximation Practice*, ch. 19.
pub fn plane_cubic_length(points: &[[f64; 2]; 4]) -> f64 {
    let (steps, unit) = steps_and_unit(points);
    if unit == 0.0 {
        return 0.0;
    }
    let speed = Speed::of_steps(steps);
    LENGTH_UNIT * speed.integral(&speed.roots(), -1.0, 1.0, 0) * unit
}

/// The inverse of the arc length of a plane cubic.
///
/// Newton's method, safeguarded by bisection. Each step integrates only from the last parameter to the next, also from one
/// call to the next: successive lengths are mostly close to each other.
pub struct PlaneCubicInverse {
    speed: Speed,
    roots: Roots,
    /// The length of the curve.
    length: f64,
    /// The same as an integral of the speed.
    whole: f64,
    /// The allowed error of an integral.
    slack: f64,
    /// The last z = 2t − 1, and the integral up to it.
    last: [f64; 2],
}

impl PlaneCubicInverse {
    /// `slack` is the allowed error as a length, in addition to rounding.
    pub fn new(points: &[[f64; 2]; 4], slack: f64) -> Self {
        let (steps, unit) = steps_and_unit(points);
        let speed = Speed::of_steps(steps);
        let roots = speed.roots();
        let whole = if unit == 0.0 {
            0.0
        } else {
            speed.integral(&roots, -1.0, 1.0, 0)
        };
        Self {
            slack: larger(slack / (LENGTH_UNIT * unit), ROUNDING * whole),
            speed,
            roots,
            length: LENGTH_UNIT * whole * unit,
            whole,
            last: [-1.0, 0.0],
        }
    }

    /// The t up to which the arc length is s; 0 or 1 for an s outside the range, NaN for NaN.
    pub fn time(&mut self, s: f64) -> f64 {
        if s.is_nan() {
            return s;
        }
        if s <= 0.0 || self.length == 0.0 {
            return 0.0;
        }
        if s >= self.length {
            return 1.0;
        }
        let part = s / self.length;
        let s = part * self.whole;
        let first_guess = self.first_guess(s, part);
        newton_in_bracket([0.0, 1.0], first_guess, self.slack, |t| {
            let (z, [at, before]) = (2.0 * t - 1.0, self.last);
            let between = self.speed.integral(&self.roots, at.min(z), at.max(z), 0);
            self.last = [z, before + between.copysign(z - at)];
            // The derivative by t is twice the speed, because z = 2t − 1.
            (self.last[1] - s, 2.0 * self.speed.at(z))
        })
    }

    /// A first guess of the t at the length s: near the last parameter with the speed there, otherwise the cubic Hermite
    /// interpolant of t with its derivatives at both ends.
    fn first_guess(&self, s: f64, part: f64) -> f64 {
        let [z, before] = self.last;
        let near = 0.5 * (1.0 + z + (s - before) / self.speed.at(z));
        if (s - before).abs() < NEAR * self.whole && near > 0.0 && near < 1.0 {
            return near;
        }
        // The derivatives of t, minus 1. The mean speed over z is half of the whole, because z runs from −1 to 1.
        let [first, second] = [-1.0, 1.0].map(|z| 0.5 * self.whole / self.speed.at(z) - 1.0);
        let first_guess = part + part * (1.0 - part) * (first * (1.0 - part) - second * part);
        if first_guess > 0.0 && first_guess < 1.0 {
            first_guess
        } else {
            part
        }
    }
}

/// Lengths that differ by less than this part of the whole are near.
const NEAR: f64 = 0.2;

/// An integral of the speed over z, times this, is a length.
const LENGTH_UNIT: f64 = 0.375;

/// The rounding of an integral, as a part of it.
const ROUNDING: f64 = 4.0 * f64::EPSILON;

/// The differences of the control points in a unit, for which fourth powers stay in the range of f64. The unit is 0 if all
/// points coincide.
#[inline(always)]
fn steps_and_unit(points: &[[f64; 2]; 4]) -> ([Complex; 3], f64) {
    let [a, b, c, d] = *points;
    let steps = [minus(b, a), minus(c, b), minus(d, c)];
    let longest = longest(&steps);
    if longest > 1e-70 && longest < 1e70 {
        (steps, 1.0)
    } else {
        scaled_steps(points)
    }
}

/// [`steps_and_unit`] of very large and very small cubics, and of points.
#[cold]
fn scaled_steps(points: &[[f64; 2]; 4]) -> ([Complex; 3], f64) {
    // The difference of ±1e308 overflows; that of their halves does not.
    let part = if longest(points) < 1e300 { 1.0 } else { 0.5 };
    let [a, b, c, d] = points.map(|p| p.map(|x| x * part));
    let steps = [minus(b, a), minus(c, b), minus(d, c)];
    let unit = longest(&steps);
    let scale = |x: f64| if unit == 0.0 { x } else { x / unit };
    (steps.map(|step| step.map(scale)), unit / part)
}

/// The largest absolute coordinate.
#[inline(always)]
fn longest(vectors: &[Complex]) -> f64 {
    let size = |v: &Complex| larger(v[0].abs(), v[1].abs());
    vectors.iter().map(size).fold(0.0, larger)
}

/// The speed |m + 2dz + ez²|.
#[derive(Clone, Copy)]
struct Speed {
    m: Complex,
    d: Complex,
    e: Complex,
}

impl Speed {
    /// The speed of the cubic with the given differences of control points: B′(t) is ¾ (m + 2dz + ez²) at t = (1 + z)/2.
    #[inline(always)]
    fn of_steps([a, b, c]: [Complex; 3]) -> Self {
        Self {
            m: plus(plus(a, c), plus(b, b)),
            d: minus(c, a),
            e: minus(minus(a, b), minus(b, c)),
        }
    }

    /// The speed at z.
    #[inline(always)]
    fn at(&self, z: f64) -> f64 {
        let [x, y] = self.substituted(z, 0.0).m;
        (x * x + y * y).sqrt()
    }

    /// The roots, without a branch, because it would be unpredictable.
    #[inline(always)]
    fn roots(&self) -> Roots {
        let &Self { m, d, e } = self;
        let root = square_root(minus(times(d, d), times(m, e)));
        // Nothing cancels in the sum of two vectors with a non-negative scalar product.
        let sign = (d[0] * root[0] + d[1] * root[1]).signum();
        let sum = [0, 1].map(|k| -(d[k] + sign * root[k]));
        // The roots are sum/e and m/sum.
        let pairs = |k: usize| (f64x2::new([sum[k], m[k]]), f64x2::new([e[k], sum[k]]));
        let ((over_x, under_x), (over_y, under_y)) = (pairs(0), pairs(1));
        // The quotient of complex numbers: a/b = a b̄ / |b|².
        let part = f64x2::splat(1.0) / (under_x * under_x + under_y * under_y);
        Roots {
            x: (over_x * under_x + over_y * under_y) * part,
            y: (over_y * under_x - over_x * under_y) * part,
        }
    }

    /// ∫ |m + 2dz + ez²| dz from `lo` to `hi`.
    #[inline(never)]
    fn integral(&self, roots: &Roots, lo: f64, hi: f64, depth: usize) -> f64 {
        let half = 0.5 * (hi - lo);
        let axes = roots.axes(lo, hi);
        if axes.min() >= MIN_AXIS[5] * half {
            return self.by_rule(lo, half, axes.min());
        }
        // A root is close to the interval, or at an end.
        let (axis, root) = roots.nearest(axes, lo, hi);
        if axis >= MIN_AXIS[5] * half || depth >= MAX_CUTS {
            return self.by_rule(lo, half, axis);
        }
        let cut = location_of_cut(root, lo, hi);
        self.integral(roots, lo, cut, depth + 1) + self.integral(roots, cut, hi, depth + 1)
    }

    /// The speed after the substitution z = middle + half·x.
    fn substituted(&self, middle: f64, half: f64) -> Self {
        let slope = |k: usize| self.d[k] + self.e[k] * middle;
        let [x, y] = [0, 1].map(|k| self.m[k] + middle * (self.d[k] + slope(k)));
        Self {
            m: [x, y],
            d: [slope(0) * half, slope(1) * half],
            e: self.e.map(|e| e * (half * half)),
        }
    }

    /// The integral over [lo, lo + 2·half] by the smallest sufficient rule.
    #[inline]
    fn by_rule(&self, lo: f64, half: f64, axis: f64) -> f64 {
        let here = self.substituted(lo + half, half);
        let sum = if axis >= MIN_AXIS[2] * half {
            if axis >= MIN_AXIS[0] * half {
                here.sum(&GAUSS_8)
            } else if axis >= MIN_AXIS[1] * half {
                here.sum(&GAUSS_16)
            } else {
                here.sum(&GAUSS_24)
            }
        } else if axis >= MIN_AXIS[3] * half {
            here.sum(&GAUSS_32)
        } else if axis >= MIN_AXIS[4] * half {
            here.sum(&GAUSS_48)
        } else {
            here.sum(&GAUSS_64)
        };
        half * sum
    }

    /// The value of the rule for the integral from −1 to 1: two nodes at a time, and their mirror images.
    #[inline(always)]
    fn sum<const HALF: usize>(&self, rule: &Rule<HALF>) -> f64 {
        let two = |z: Complex| z.map(f64x2::splat);
        let (m, d, e) = (two(self.m), two(plus(self.d, self.d)), two(self.e));
        let mut sum = f64x2::splat(0.0);
        for (z, w) in rule.nodes.chunks_exact(2).zip(rule.weights.chunks_exact(2)) {
            let (z, w) = (f64x2::new([z[0], z[1]]), f64x2::new([w[0], w[1]]));
            let square = z * z;
            // The value at z is the sum of the even and the odd part, that at −z their difference.
            let (even_x, odd_x) = (m[0] + e[0] * square, d[0] * z);
            let (even_y, odd_y) = (m[1] + e[1] * square, d[1] * z);
            let [x, y] = [even_x + odd_x, even_y + odd_y];
            let [u, v] = [even_x - odd_x, even_y - odd_y];
            sum += w * ((x * x + y * y).sqrt() + (u * u + v * v).sqrt());
        }
        let [a, b] = sum.to_array();
        a + b
    }
}

/// Both roots, in the lanes of a vector.
struct Roots {
    x: f64x2,
    y: f64x2,
}

impl Roots {
    /// Half the sums of the distances of each root from the ends; infinite if a root is NaN.
    #[inline(always)]
    fn axes(&self, lo: f64, hi: f64) -> Axes {
        let square = self.y * self.y;
        let [before, after] = [lo, hi].map(|end| {
            let x = self.x - f64x2::splat(end);
            (x * x + square).sqrt()
        });
        let axes = f64x2::splat(0.5) * (before + after);
        let far = |axis: f64| smaller(axis, f64::INFINITY);
        Axes(f64x2::new(axes.to_array().map(far)))
    }

    /// The closest root that is not at an end, and its axis.
    #[inline(always)]
    fn nearest(&self, axes: Axes, lo: f64, hi: f64) -> (f64, Complex) {
        let ([x, u], [y, v]) = (self.x.to_array(), self.y.to_array());
        let [first, second] = axes.0.to_array();
        let (axis, root) = if first <= second {
            (first, [x, y])
        } else {
            (second, [u, v])
        };
        // Only a real root can be at an end.
        if root[1].abs() > AT_THE_END * 0.5 * (hi - lo) {
            (axis, root)
        } else {
            self.nearest_inside(axes, lo, hi)
        }
    }

    /// [`Self::nearest`] if a root may be at an end.
    #[cold]
    #[inline(never)]
    fn nearest_inside(&self, axes: Axes, lo: f64, hi: f64) -> (f64, Complex) {
        let (x, y) = (self.x.to_array(), self.y.to_array());
        let slack = AT_THE_END * 0.5 * (hi - lo);
        let mut nearest = (f64::INFINITY, [0.0, 0.0]);
        for ((axis, x), y) in axes.0.to_array().into_iter().zip(x).zip(y) {
            let at_the_end = y.abs() <= slack && !(x > lo + slack && x < hi - slack);
            if axis < nearest.0 && !at_the_end {
                nearest = (axis, [x, y]);
            }
        }
        nearest
    }
}

/// Half the major axes of the ellipses through both roots, with foci at the ends of an interval.
#[derive(Clone, Copy)]
struct Axes(f64x2);

impl Axes {
    #[inline(always)]
    fn min(self) -> f64 {
        let [a, b] = self.0.to_array();
        self.0.fast_min(f64x2::new([b, a])).to_array()[0]
    }
}

/// Maximum depth of cuts, twice what any curve of f64 needs. It prevents endless recursion, whatever rounding does.
const MAX_CUTS: usize = 48;

/// The parameter at which an interval is cut because of a root near it.
fn location_of_cut([x, y]: Complex, lo: f64, hi: f64) -> f64 {
    let (middle, half) = (0.5 * (lo + hi), 0.5 * (hi - lo));
    let off = x - middle;
    if off.abs() <= SPLIT_AT_PROJECTION_WITHIN * half {
        return x;
    }
    // The distance of the root from the nearer end.
    let beyond = off.abs() - half;
    let distance = (beyond * beyond + y * y).sqrt();
    let kept = half - CUT_RATIO * distance;
    if kept > 0.0 {
        middle + kept.copysign(off)
    } else {
        middle
    }
}

#[inline(always)]
fn plus(a: Complex, b: Complex) -> Complex {
    [a[0] + b[0], a[1] + b[1]]
}

#[inline(always)]
fn minus(a: Complex, b: Complex) -> Complex {
    [a[0] - b[0], a[1] - b[1]]
}

#[inline(always)]
fn times(a: Complex, b: Complex) -> Complex {
    [a[0] * b[0] - a[1] * b[1], a[0] * b[1] + a[1] * b[0]]
}

/// One of the two square roots, with a relative error of about 10⁻⁸: this error of a root only moves a cut by as much.
#[inline(always)]
fn square_root([x, y]: Complex) -> Complex {
    let size = (x * x + y * y).sqrt();
    let squares = f64x2::splat(0.5) * (f64x2::splat(size) + f64x2::new([x, -x]));
    let [real, imaginary] = squares.fast_max(f64x2::splat(0.0)).sqrt().to_array();
    [real, imaginary.copysign(y)]
}
