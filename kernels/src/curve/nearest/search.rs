//! Nearest point of a cubic, or of a rational one.

use crate::bernstein::de_casteljau::{halve, lerp, split_cubic_with};
use crate::bernstein::derivatives::CubicWithDerivatives;
use crate::curve::rational_cubic::RationalCubic;
use crate::numeric::vector::{Euclidean, Vector};
use crate::numeric::work_limit::WorkLimit;
use glam::{DVec2, DVec3};

/// Halvings of the coefficients; more would make their rounding significant.
const ROUGH_HALVINGS: u32 = 5;

/// Further halvings, after which several roots count as one: their squared distances then differ by the square of the
/// width, for which half of the bits are enough, with 3 as a reserve.
const CLOSE_HALVINGS: u32 = f64::MANTISSA_DIGITS / 2 + 3 - ROUGH_HALVINGS;

/// Maximum number of segments. In exact arithmetic at most two segments of each width have more than one sign change,
/// which makes about 120 segments; if the distance is constant up to rounding, every segment has sign changes.
const MAX_PIECES: usize = 256;

/// Maximum number of steps of Newton's method; not even a root of multiplicity 5, where it converges slowest, needs as
/// many.
const MAX_STEPS: usize = 80;

/// Between these sizes, fourth powers and constant factors stay in the range of f64.
const PLAIN_SIZES: std::ops::Range<f64> = 1e-60..1e60;

/// The parameter in [0, 1] at which the cubic with the given control points is nearest to a point; of equally near ones
/// (up to rounding) the smallest. `None` if the numbers are so large or so small that their powers leave the range of
/// f64.
///
/// Every local minimum is found: with B relative to that point, half the derivative of the squared distance, B·B′, is a
/// quintic, whose sign changes are isolated by Descartes' rule in Bernstein form. Only those from − to + are
/// considered.
pub fn nearest_in_plane(points: &[DVec2; 4], to: DVec2) -> Option<f64> {
    nearest_on_cubic(points, to)
}

/// [`nearest_in_plane`] in space. (A public generic function would be compiled in the calling crate, for size.)
pub fn nearest_in_space(points: &[DVec3; 4], to: DVec3) -> Option<f64> {
    nearest_on_cubic(points, to)
}

/// The parameter at which a rational curve is nearest to the origin, as [`nearest_in_plane`]: A·D, of degree 7, has the sign of
/// B·B′.
pub fn rational_nearest_in_plane(curve: &RationalCubic<DVec2>, size: f64) -> Option<f64> {
    nearest(curve, size)
}

/// [`rational_nearest_in_plane`] in space.
pub fn rational_nearest_in_space(curve: &RationalCubic<DVec3>, size: f64) -> Option<f64> {
    nearest(curve, size)
}

#[inline(always)]
fn nearest_on_cubic<V: Euclidean>(points: &[V; 4], to: V) -> Option<f64> {
    let points = points.map(|p| p - to);
    let size = points.iter().fold(0.0, |m: f64, p| m.max(p.max_abs()));
    nearest(&CubicWithDerivatives::new(points), size)
}

/// The parameter at which a curve is nearest to the origin; `size` is its largest coordinate.
#[inline(always)]
fn nearest<const N: usize>(curve: &impl Distance<N>, size: f64) -> Option<f64> {
    let [start, end] = curve.squares_at_ends();
    let mut best = Best::new(size, start);
    // The size is 0 if all points coincide.
    if !(PLAIN_SIZES.contains(&best.size) || best.size == 0.0) {
        return None;
    }
    let whole = curve.rate();
    // Without a negative coefficient the distance does not decrease, and the start is nearest.
    if signs(&whole) != 0 {
        search(curve, &whole, [0.0, 1.0], ROUGH_HALVINGS, &mut best);
    }
    best.take(1.0, end);
    Some(best.t)
}

/// The squared distance of the points of a curve from the origin.
trait Distance<const N: usize>: Sized {
    /// The Bernstein coefficients of a polynomial with the sign of the derivative. Only their signs and ratios count.
    fn rate(&self) -> [f64; N];
    /// The squared distances of both ends.
    fn squares_at_ends(&self) -> [f64; 2];
    /// The squared distance at t, and half its derivative and half its second derivative up to a common positive factor and to
    /// multiples of the derivative; the square of the derivative divided by the second one is in the unit of the squared distance.
    fn at(&self, t: f64) -> (f64, f64, f64);
    /// The part from lo to hi.
    fn part(&self, lo: f64, hi: f64) -> Self;
    /// Both halves.
    fn halves(&self) -> (Self, Self);
    /// Whether the distance decreases at the end of this curve, and does not at the start of the next one.
    fn ends_at_minimum(&self, next: &Self) -> bool;
}

impl<V: Euclidean> Distance<6> for CubicWithDerivatives<V> {
    /// B·B′.
    #[inline(always)]
    fn rate(&self) -> [f64; 6] {
        let by = |i: usize, j: usize| self.points[i].dot(self.first[j]);
        [
            by(0, 0),
            0.4 * by(0, 1) + 0.6 * by(1, 0),
            0.1 * by(0, 2) + 0.6 * by(1, 1) + 0.3 * by(2, 0),
            0.3 * by(1, 2) + 0.6 * by(2, 1) + 0.1 * by(3, 0),
            0.6 * by(2, 2) + 0.4 * by(3, 1),
            by(3, 2),
        ]
    }

    #[inline(always)]
    fn squares_at_ends(&self) -> [f64; 2] {
        [0, 3].map(|k| self.points[k].dot(self.points[k]))
    }

    #[inline(always)]
    fn at(&self, t: f64) -> (f64, f64, f64) {
        let [point, first, second] = self.at(t);
        (
            point.dot(point),
            point.dot(first),
            first.dot(first) + point.dot(second),
        )
    }

    #[inline(always)]
    fn part(&self, lo: f64, hi: f64) -> Self {
        let at = |[a, b, c]: [f64; 3]| {
            let [p, q, r, s] = self.points;
            let (pq, qr, rs) = (lerp(p, q, a), lerp(q, r, a), lerp(r, s, a));
            lerp(lerp(pq, qr, b), lerp(qr, rs, b), c)
        };
        // The control points are the values of the blossom.
        Self::new([[lo, lo, lo], [lo, lo, hi], [lo, hi, hi], [hi, hi, hi]].map(at))
    }

    #[inline(always)]
    fn halves(&self) -> (Self, Self) {
        let (left, right) = split_cubic_with(self.points, |a, b| (a + b) * 0.5);
        (Self::new(left), Self::new(right))
    }

    #[inline(always)]
    fn ends_at_minimum(&self, next: &Self) -> bool {
        let [centre, after, ..] = next.points;
        centre.dot(centre - self.points[2]) < 0.0 && centre.dot(after - centre) >= 0.0
    }
}

/// C(3, i) C(4, j) / C(7, i + j): the shares of the products of coefficients in those of a product.
const SHARES: [[f64; 5]; 4] = {
    let (cubic, quartic) = ([1.0, 3.0, 3.0, 1.0], [1.0, 4.0, 6.0, 4.0, 1.0]);
    let septic = [1.0, 7.0, 21.0, 35.0, 35.0, 21.0, 7.0, 1.0];
    let mut shares = [[0.0; 5]; 4];
    let mut k = 0;
    while k < 20 {
        let (i, j) = (k / 5, k % 5);
        shares[i][j] = cubic[i] * quartic[j] / septic[i + j];
        k += 1;
    }
    shares
};

impl<V: Euclidean> Distance<8> for RationalCubic<V> {
    /// A·D.
    #[inline(never)]
    fn rate(&self) -> [f64; 8] {
        let mut rate = [0.0; 8];
        for (i, (point, shares)) in self.points.iter().zip(&SHARES).enumerate() {
            for (j, (d, share)) in self.derivative.iter().zip(shares).enumerate() {
                rate[i + j] += share * point.dot(*d);
            }
        }
        rate
    }

    #[inline(always)]
    fn squares_at_ends(&self) -> [f64; 2] {
        [0, 3].map(|k| {
            let point = self.points[k] / self.weights[k];
            point.dot(point)
        })
    }

    /// With F = A·D, the derivative of F/w is (A·D′ + D·D/w)/w, because A′ = (D + w′A)/w; and B·B′ = F/w³.
    #[inline(never)]
    fn at(&self, t: f64) -> (f64, f64, f64) {
        let u = 1.0 - t;
        let (uu, ut, tt) = (u * u, u * t, t * t);
        let cubic = [uu * u, 3.0 * (uu * t), 3.0 * (u * tt), tt * t];
        let point = V::blend4(self.points, cubic);
        let weight = f64::blend4(self.weights, cubic);
        let [a, b, c, d, e] = self.derivative;
        let first = V::blend4(
            [a, b, c, d],
            [uu * uu, 4.0 * (uu * ut), 6.0 * (ut * ut), 4.0 * (ut * tt)],
        ) + e * (tt * tt);
        let second = V::blend4([b - a, c - b, d - c, e - d], cubic) * 4.0;
        let part = 1.0 / weight;
        let cube = part * part * part;
        (
            point.dot(point) * (part * part),
            point.dot(first) * cube,
            (point.dot(second) + first.dot(first) * part) * cube,
        )
    }

    #[inline(always)]
    fn part(&self, lo: f64, hi: f64) -> Self {
        self.part(lo, hi)
    }

    #[inline(always)]
    fn halves(&self) -> (Self, Self) {
        self.halves()
    }

    #[inline(always)]
    fn ends_at_minimum(&self, next: &Self) -> bool {
        let centre = next.points[0];
        centre.dot(self.derivative[4]) < 0.0 && centre.dot(next.derivative[0]) >= 0.0
    }
}

/// One bit for each negative coefficient. Zeros count as positive, which can add sign changes but never hide one.
#[inline(always)]
fn signs<const N: usize>(b: &[f64; N]) -> u32 {
    let mut bits = 0;
    for (k, &c) in b.iter().enumerate() {
        bits |= u32::from(c < 0.0) << k;
    }
    bits
}

/// The coefficients of the two halves.
#[inline(always)]
fn halves_of<const N: usize>(b: &[f64; N]) -> ([f64; N], [f64; N]) {
    let (mut left, mut right) = (*b, *b);
    halve(&mut left, &mut right);
    (left, right)
}

/// Halves a segment until each part has at most one sign change, from left to right.
fn search<const N: usize>(
    curve: &impl Distance<N>,
    rate: &[f64; N],
    [lo, hi]: [f64; 2],
    halvings: u32,
    best: &mut Best,
) {
    let force = !best.work.spend(1);
    if try_finish(curve, rate, [lo, hi], [0.0, 1.0], force, best) {
        return;
    }
    if halvings == 0 {
        // Because of rounding, a root at an end may lie on neither side.
        let piece = curve.part(lo, hi);
        let [start, end] = piece.squares_at_ends();
        best.take(lo, start);
        search_closely(&piece, [lo, hi], CLOSE_HALVINGS, best);
        best.take(hi, end);
        return;
    }
    let (left, right) = halves_of(rate);
    let mid = 0.5 * (lo + hi);
    search(curve, &left, [lo, mid], halvings - 1, best);
    search(curve, &right, [mid, hi], halvings - 1, best);
}

/// Same as `search`, but halves the control points and not the coefficients: if roots are close together, the
/// coefficients of the halves are small, and so is their rounding.
#[inline(never)]
fn search_closely<const N: usize, C: Distance<N>>(
    piece: &C,
    [lo, hi]: [f64; 2],
    halvings: u32,
    best: &mut Best,
) {
    let force = halvings == 0 || !best.work.spend(1);
    if try_finish(piece, &piece.rate(), [0.0, 1.0], [lo, hi], force, best) {
        return;
    }
    let (left, right) = piece.halves();
    let mid = 0.5 * (lo + hi);
    search_closely(&left, [lo, mid], halvings - 1, best);
    // Because of rounding, a root in the middle may lie in neither half.
    if left.ends_at_minimum(&right) {
        best.take(mid, right.squares_at_ends()[0]);
    }
    search_closely(&right, [mid, hi], halvings - 1, best);
}

/// Whether the polynomial of a segment, from lo to hi on this curve, has at most one sign change, or `force`. If so, it
/// considers the minimum, which exists only if the first sign is negative. This curve is the part [from, to] of the whole
/// one.
#[inline(always)]
fn try_finish<const N: usize>(
    curve: &impl Distance<N>,
    rate: &[f64; N],
    [lo, hi]: [f64; 2],
    [from, to]: [f64; 2],
    force: bool,
    best: &mut Best,
) -> bool {
    let signs = signs(rate);
    // Bit k is set if the coefficients k and k + 1 differ in sign. x & (x − 1) clears the lowest bit that is set.
    let changes = (signs ^ (signs >> 1)) & ((1 << (N - 1)) - 1);
    let converged = changes & changes.wrapping_sub(1) == 0 || force;
    if converged && changes != 0 && signs & 1 == 1 {
        let k = changes.trailing_zeros() as usize;
        let (before, after) = (rate[k], rate[k + 1]);
        // The zero of the control polygon.
        let guess = 1.0 / (N - 1) as f64 * (k as f64 + before / (before - after));
        let (t, square) = refine_root(curve, [lo, hi], lo + (hi - lo) * guess, best.slack);
        best.take(from + (to - from) * t, square);
    }
    converged
}

/// The root of B·B′ with a sign change from − to +, by Newton's method restricted to lo and hi, and |B|² at the root. The
/// iteration ends with the step that reduces the distance by less than rounding.
#[inline(always)]
fn refine_root<const N: usize>(
    curve: &impl Distance<N>,
    [mut lo, mut hi]: [f64; 2],
    guess: f64,
    slack: f64,
) -> (f64, f64) {
    let mut t = guess;
    for _ in 0..MAX_STEPS {
        let (square, value, slope) = curve.at(t);
        if value < 0.0 {
            lo = t;
        } else {
            hi = t;
        }
        // To second order, the step reduces |B|² by value²/slope.
        let step = value / slope;
        let (next, gain) = (t - step, value * step);
        if gain * gain <= slack * square && next >= lo && next <= hi {
            return (next, square - gain);
        }
        t = if next > lo && next < hi {
            next
        } else {
            0.5 * (lo + hi)
        };
    }
    (t, curve.at(t).0)
}

/// The nearest point found so far.
struct Best {
    /// The largest coordinate.
    size: f64,
    t: f64,
    square: f64,
    /// The square of the rounding error of a distance.
    slack: f64,
    /// Counts the processed segments.
    work: WorkLimit,
}

impl Best {
    /// Starts with the start point.
    #[inline(always)]
    fn new(size: f64, start: f64) -> Self {
        let rounding = 4.0 * f64::EPSILON * size;
        Self {
            size,
            t: 0.0,
            square: start,
            slack: rounding * rounding,
            work: WorkLimit::new(MAX_PIECES),
        }
    }

    /// Accepts t if it is nearer by more than rounding.
    #[inline(always)]
    fn take(&mut self, t: f64, square: f64) {
        // |a|² < |b|² − |b|·rounding, without a square root.
        let gain = self.square - square;
        if gain > 0.0 && gain * gain > self.slack * self.square {
            (self.t, self.square) = (t, square);
        }
    }
}
