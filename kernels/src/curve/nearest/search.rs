//! Nearest point of a cubic.

use crate::bernstein::de_casteljau::{halve, lerp, split_cubic_with};
use crate::bernstein::derivatives::CubicWithDerivatives;
use crate::numeric::vector::Euclidean;
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
    nearest(points, to)
}

/// [`nearest_in_plane`] in space. (A public generic function would be compiled in the calling crate, for size.)
pub fn nearest_in_space(points: &[DVec3; 4], to: DVec3) -> Option<f64> {
    nearest(points, to)
}

#[inline(always)]
fn nearest<V: Euclidean>(points: &[V; 4], to: V) -> Option<f64> {
    let points = points.map(|p| p - to);
    let mut best = Best::new(&points);
    // The size is 0 if all points coincide.
    if !(PLAIN_SIZES.contains(&best.size) || best.size == 0.0) {
        return None;
    }
    let cubic = Cubic(CubicWithDerivatives::new(points));
    let whole = cubic.quintic();
    // Without a negative coefficient the distance does not decrease, and the start is nearest.
    if signs(&whole) != 0 {
        cubic.search(&whole, [0.0, 1.0], ROUGH_HALVINGS, &mut best);
    }
    best.take(1.0, points[3].dot(points[3]));
    Some(best.t)
}

/// The Bernstein coefficients of B·B′ on a segment. Only their signs and ratios count, so B′ may have any
/// positive factor.
type Quintic = [f64; 6];

/// One bit for each negative coefficient. Zeros count as positive, which can add sign changes but never hide one.
#[inline(always)]
fn signs(b: &Quintic) -> u32 {
    let mut bits = 0;
    for (k, &c) in b.iter().enumerate() {
        bits |= u32::from(c < 0.0) << k;
    }
    bits
}

/// The coefficients of the two halves.
#[inline(always)]
fn quintic_halves(b: &Quintic) -> (Quintic, Quintic) {
    let (mut left, mut right) = (*b, *b);
    halve(&mut left, &mut right);
    (left, right)
}

/// Same as `Cubic::search`, but halves the control points and not the coefficients: if roots are close together, the
/// coefficients of the halves are small, and so is their rounding.
#[inline(never)]
fn search_closely<V: Euclidean>(
    points: [V; 4],
    [lo, hi]: [f64; 2],
    halvings: u32,
    best: &mut Best,
) {
    let piece = Cubic(CubicWithDerivatives::new(points));
    let force = halvings == 0 || !best.work.spend(1);
    if piece.try_finish(&piece.quintic(), [0.0, 1.0], [lo, hi], force, best) {
        return;
    }
    let (left, right) = split_cubic_with(points, |a, b| (a + b) * 0.5);
    let mid = 0.5 * (lo + hi);
    search_closely(left, [lo, mid], halvings - 1, best);
    // Because of rounding, a root in the middle may lie in neither half.
    let centre = right[0];
    if centre.dot(centre - left[2]) < 0.0 && centre.dot(right[1] - centre) >= 0.0 {
        best.take(mid, centre.dot(centre));
    }
    search_closely(right, [mid, hi], halvings - 1, best);
}

/// A cubic relative to the point to which it shall be nearest.
struct Cubic<V>(CubicWithDerivatives<V>);

impl<V: Euclidean> Cubic<V> {
    #[inline(always)]
    fn quintic(&self) -> Quintic {
        let by = |i: usize, j: usize| self.0.points[i].dot(self.0.first[j]);
        [
            by(0, 0),
            0.4 * by(0, 1) + 0.6 * by(1, 0),
            0.1 * by(0, 2) + 0.6 * by(1, 1) + 0.3 * by(2, 0),
            0.3 * by(1, 2) + 0.6 * by(2, 1) + 0.1 * by(3, 0),
            0.6 * by(2, 2) + 0.4 * by(3, 1),
            by(3, 2),
        ]
    }

    /// Halves a segment until each part has at most one sign change, from left to right.
    fn search(&self, quintic: &Quintic, [lo, hi]: [f64; 2], halvings: u32, best: &mut Best) {
        let force = !best.work.spend(1);
        if self.try_finish(quintic, [lo, hi], [0.0, 1.0], force, best) {
            return;
        }
        if halvings == 0 {
            // Because of rounding, a root at an end may lie on neither side.
            let piece = self.piece(lo, hi);
            best.take(lo, piece[0].dot(piece[0]));
            search_closely(piece, [lo, hi], CLOSE_HALVINGS, best);
            best.take(hi, piece[3].dot(piece[3]));
            return;
        }
        let (left, right) = quintic_halves(quintic);
        let mid = 0.5 * (lo + hi);
        self.search(&left, [lo, mid], halvings - 1, best);
        self.search(&right, [mid, hi], halvings - 1, best);
    }

    /// Whether the quintic of a segment, from lo to hi on this curve, has at most one sign change, or `force`. If so,
    /// it considers the minimum, which exists only if the first sign is negative. This curve is the part [from, to] of
    /// the whole one.
    #[inline(always)]
    fn try_finish(
        &self,
        quintic: &Quintic,
        [lo, hi]: [f64; 2],
        [from, to]: [f64; 2],
        force: bool,
        best: &mut Best,
    ) -> bool {
        let signs = signs(quintic);
        // Bit k is set if the coefficients k and k + 1 differ in sign. x & (x − 1) clears the lowest bit that is set.
        let changes = (signs ^ (signs >> 1)) & 31;
        let converged = changes & changes.wrapping_sub(1) == 0 || force;
        if converged && changes != 0 && signs & 1 == 1 {
            let k = changes.trailing_zeros() as usize;
            let (before, after) = (quintic[k], quintic[k + 1]);
            // The zero of the control polygon.
            let guess = 0.2 * (k as f64 + before / (before - after));
            let (t, square) = self.refine_root([lo, hi], lo + (hi - lo) * guess, best.slack);
            best.take(from + (to - from) * t, square);
        }
        converged
    }

    /// The control points of the segment from lo to hi.
    fn piece(&self, lo: f64, hi: f64) -> [V; 4] {
        let at = |[a, b, c]: [f64; 3]| {
            let [p, q, r, s] = self.0.points;
            let (pq, qr, rs) = (lerp(p, q, a), lerp(q, r, a), lerp(r, s, a));
            lerp(lerp(pq, qr, b), lerp(qr, rs, b), c)
        };
        // The control points are the values of the blossom.
        [[lo, lo, lo], [lo, lo, hi], [lo, hi, hi], [hi, hi, hi]].map(at)
    }

    /// The root of B·B′ with a sign change from − to +, by Newton's method restricted to lo and hi, and |B|² at the
    /// root. The iteration ends with the step that reduces the distance by less than rounding.
    #[inline(always)]
    fn refine_root(&self, [mut lo, mut hi]: [f64; 2], guess: f64, slack: f64) -> (f64, f64) {
        let mut t = guess;
        for _ in 0..MAX_STEPS {
            let (square, value, slope) = self.eval_squared_distance(t);
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
        (t, self.eval_squared_distance(t).0)
    }

    /// |B|² at t and half its first and second derivatives.
    #[inline(always)]
    fn eval_squared_distance(&self, t: f64) -> (f64, f64, f64) {
        let [point, first, second] = self.0.at(t);
        (
            point.dot(point),
            point.dot(first),
            first.dot(first) + point.dot(second),
        )
    }
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
    fn new<V: Euclidean>(points: &[V; 4]) -> Self {
        let size = points.iter().fold(0.0, |m: f64, p| m.max(p.max_abs()));
        let rounding = 4.0 * f64::EPSILON * size;
        Self {
            size,
            t: 0.0,
            square: points[0].dot(points[0]),
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
