//! Lengths: integrals of the speed.

use crate::gauss::{GAUSS_8, GAUSS_16, GAUSS_24, GAUSS_32, GAUSS_48, Rule};
use wide::f64x2;

type Complex = [f64; 2];

/// A root this near to the end of an interval, in half lengths of it, leaves nothing that a rule could miss: what
/// |z − root| differs from a linear function integrates to half the square of this times a logarithm.
const AT_THE_END: f64 = 1e-8;

/// The rules have 8, 16, 24, 32 and 48 points. From the least (|z − 1| + |z + 1|) / 2 of a root z on, the interval being
/// [−1, 1], each errs by less than 1.5·10⁻¹³ of the integral: half the axis of the ellipse through z about ±1, inside of
/// which the speed is analytic. Found by integrating |z − root|, whose integral has a closed form, for roots all around
/// each ellipse.
const LEAST_AXIS: [f64; 5] = [2.6, 1.32, 1.132, 1.071, 1.03];

/// A root off the middle has the interval cut so many times as far from its end as the root is: on either side of the
/// cut a rule of 24 or 32 points suffices for this root.
const CUT_RATIO: f64 = 5.0;

/// A root whose foot is that far from the middle, in half lengths, has the interval cut at its foot.
const INNER: f64 = 0.75;

/// The length of a plane cubic, to 10⁻¹³ of itself; coordinates of a size whose fourth powers are in range.
///
/// Seen as complex numbers, the derivative is a quadratic polynomial q, so that the speed |q(z)| = |e| |z − z₁| |z − z₂|
/// has its only singularities at two roots that a closed form gives. How near they are to an interval decides which
/// rule suffices; where none does, the interval is cut at the least speed, or nearer to it. Source of the error of
/// Gauss rules by ellipses: Trefethen, *Approximation Theory and Approximation Practice*, ch. 19.
pub fn plane_cubic_length(points: &[[f64; 2]; 4]) -> f64 {
    let [p0, p1, p2, p3] = *points;
    let (d0, d1, d2) = (minus(p1, p0), minus(p2, p1), minus(p3, p2));
    // B′(t) at t = (1 + z)/2 is ¾ (m + 2dz + ez²).
    let speed = Speed {
        m: plus(plus(d0, d2), plus(d1, d1)),
        d: minus(d2, d0),
        e: minus(minus(d0, d1), minus(d1, d2)),
    };
    0.375 * speed.integral(&speed.roots(), -1.0, 1.0, 0)
}

/// |m + 2dz + ez²|.
#[derive(Clone, Copy)]
struct Speed {
    m: Complex,
    d: Complex,
    e: Complex,
}

impl Speed {
    /// The roots; what is infinite or not a number is nowhere near.
    #[inline(always)]
    fn roots(&self) -> Roots {
        let &Self { m, d, e } = self;
        let root = square_root(minus(times(d, d), times(m, e)));
        // The sum of two that point the same way: nothing cancels.
        let along = d[0] * root[0] + d[1] * root[1];
        let sum = if along < 0.0 {
            minus(root, d)
        } else {
            minus([0.0, 0.0], plus(d, root))
        };
        let ([x, y], [u, v]) = (over(sum, e), over(m, sum));
        Roots {
            x: f64x2::new([x, u]),
            y: f64x2::new([y, v]),
        }
    }

    /// ∫ from `lo` to `hi`.
    fn integral(&self, roots: &Roots, lo: f64, hi: f64, depth: usize) -> f64 {
        let half = 0.5 * (hi - lo);
        let (axis, root) = roots.nearest(lo, hi);
        if axis >= LEAST_AXIS[4] * half || depth >= MOST_CUTS {
            return half * self.about(0.5 * (lo + hi), half).by_rule(axis / half);
        }
        let cut = place_of_cut(root, lo, hi);
        self.integral(roots, lo, cut, depth + 1) + self.integral(roots, cut, hi, depth + 1)
    }

    /// The same with z = middle + half·x.
    fn about(&self, middle: f64, half: f64) -> Self {
        let slope = |k: usize| self.d[k] + self.e[k] * middle;
        let [x, y] = [0, 1].map(|k| self.m[k] + middle * (self.d[k] + slope(k)));
        Self {
            m: [x, y],
            d: [slope(0) * half, slope(1) * half],
            e: self.e.map(|e| e * (half * half)),
        }
    }

    #[inline(always)]
    fn by_rule(&self, axis: f64) -> f64 {
        if axis >= LEAST_AXIS[1] {
            if axis >= LEAST_AXIS[0] {
                self.sum(&GAUSS_8)
            } else {
                self.sum(&GAUSS_16)
            }
        } else if axis >= LEAST_AXIS[2] {
            self.sum(&GAUSS_24)
        } else if axis >= LEAST_AXIS[3] {
            self.sum(&GAUSS_32)
        } else {
            self.sum(&GAUSS_48)
        }
    }

    /// The rule's value of the integral from −1 to 1: two nodes at a time, and their mirror images.
    #[inline(always)]
    fn sum<const HALF: usize>(&self, rule: &Rule<HALF>) -> f64 {
        let two = |z: Complex| z.map(f64x2::splat);
        let (m, d, e) = (two(self.m), two(plus(self.d, self.d)), two(self.e));
        let mut sum = f64x2::splat(0.0);
        for (z, w) in rule.nodes.chunks_exact(2).zip(rule.weights.chunks_exact(2)) {
            let (z, w) = (f64x2::new([z[0], z[1]]), f64x2::new([w[0], w[1]]));
            let square = z * z;
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

/// Both roots, side by side.
struct Roots {
    x: f64x2,
    y: f64x2,
}

impl Roots {
    /// Half the sum of the distances of the root from the ends, and that root: of the one for which it is least.
    #[inline(always)]
    fn nearest(&self, lo: f64, hi: f64) -> (f64, Complex) {
        let square = self.y * self.y;
        let [before, after] = [lo, hi].map(|end| {
            let x = self.x - f64x2::splat(end);
            (x * x + square).sqrt()
        });
        let axes = (f64x2::splat(0.5) * (before + after)).to_array();
        let (x, y) = (self.x.to_array(), self.y.to_array());
        let mut nearest = (f64::INFINITY, [0.0, 0.0]);
        for ((axis, x), y) in axes.into_iter().zip(x).zip(y) {
            let slack = AT_THE_END * 0.5 * (hi - lo);
            let at_the_end = y.abs() <= slack && !(x > lo + slack && x < hi - slack);
            if axis < nearest.0 && !at_the_end {
                nearest = (axis, [x, y]);
            }
        }
        nearest
    }
}

/// Twice what any curve of f64 needs; no endless recursion, whatever rounding does.
const MOST_CUTS: usize = 48;

/// Where an interval is cut for a root near it.
fn place_of_cut([x, y]: Complex, lo: f64, hi: f64) -> f64 {
    let (middle, half) = (0.5 * (lo + hi), 0.5 * (hi - lo));
    let off = x - middle;
    if off.abs() <= INNER * half {
        return x;
    }
    let beyond = off.abs() - half;
    let distance = (beyond * beyond + y * y).sqrt();
    middle + (half - CUT_RATIO * distance).max(0.0).copysign(off)
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

#[inline(always)]
fn over(a: Complex, b: Complex) -> Complex {
    let size = b[0] * b[0] + b[1] * b[1];
    [
        (a[0] * b[0] + a[1] * b[1]) / size,
        (a[1] * b[0] - a[0] * b[1]) / size,
    ]
}

/// One of the two square roots.
#[inline(always)]
fn square_root([x, y]: Complex) -> Complex {
    let size = (x * x + y * y).sqrt();
    let larger = (0.5 * (size + x.abs())).sqrt();
    let smaller = if larger > 0.0 { 0.5 * y / larger } else { 0.0 };
    if x >= 0.0 {
        [larger, smaller]
    } else {
        [smaller, larger]
    }
}
