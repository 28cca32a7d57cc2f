//! Common zeros of two polynomials over the unit square ("the pair").
//!
//! A piece on which the coefficients of one polynomial are all above or all below zero contains no common zero. A piece
//! on which the pair is one-to-one contains at most one zero, and Newton's method finds it. The remaining zeros are
//! those where the pair only touches zero: pieces so small that rounding decides.

use super::newton::{
    SAME_ZERO, distance_from_zero, longer, onto_square, project_to_zero_set, touching_zero,
    zero_near,
};
use super::piece::{PolynomialPiece, search};
use casteljau_kernels::numeric::order::range;
use casteljau_kernels::numeric::work_limit::WorkLimit;

/// Values up to this count as zero, for coefficients of size 1 to 4: their rounding error after products and halvings.
pub(crate) const ZERO_TOLERANCE: f64 = 32.0 * f64::EPSILON;

/// More pieces in one round than isolated zeros can cause: a pair of bicubic polynomials has at most 18 zeros, and
/// around a zero that the pair only touches a few hundred pieces remain while they are small.
const MAX_PIECES: usize = 1024;

/// The maximum deviation of the derivative from its mean at which Newton's method reliably finds the zero (1 would
/// suffice to prove that there is only one).
const MAX_SPREAD: f64 = 0.5;

/// The fraction of a patch's extent over which the ray must run within the patch to count as a curve of zeros. Where
/// the ray is tangent, it seems to run within the patch over the square root of rounding, and over the fourth root,
/// about 1e-4, for a tangency of fourth order.
const CURVE_SHARE: f64 = 1.0 / 64.0;

/// The maximum number of steps of a search over the square, its edges and its corners.
pub(crate) const MAX_RAY_STEPS: usize = 1 << 27;

/// The common zeros that were found.
pub(crate) struct Zeros {
    /// The parameters (u, v) of the zeros.
    pub(crate) points: Vec<[f64; 2]>,
    /// Whether the zeros are finitely many and all of them are listed.
    pub(crate) complete: bool,
}

/// A zero that is known to lie in a rectangle.
#[derive(Clone, Copy, Debug)]
struct Zero {
    u: [f64; 2],
    v: [f64; 2],
    /// The known point where the pair is nearest to zero, and the pair's absolute value there.
    at: [f64; 2],
    residual: f64,
}

/// The common zeros of planes 0 and 1 of a whole piece. If they are zero along a curve, the result contains the ends of
/// the curve on the edges; if they are zero along an edge, the ends of the edge. Plane 2 distinguishes a curve of zeros
/// from a single point with many parameters: it changes along a curve. `None` when the search takes more steps than
/// [`MAX_RAY_STEPS`].
pub(crate) fn common_zeros(whole: &PolynomialPiece) -> Option<Zeros> {
    let mut zeros = Vec::new();
    let mut work = WorkLimit::new(MAX_RAY_STEPS);
    let complete = collect(whole.clone(), whole, &mut zeros, &mut work);
    let points = zeros.iter().map(|zero| zero.at).collect();
    (!work.is_exceeded()).then_some(Zeros { points, complete })
}

/// Adds the zeros of a piece: the whole piece, an edge of it, or a corner.
fn collect(
    piece: PolynomialPiece,
    whole: &PolynomialPiece,
    zeros: &mut Vec<Zero>,
    work: &mut WorkLimit,
) -> bool {
    let sides = piece.sides();
    let mut finder = ZeroFinder {
        whole,
        on_face: sides.len() == 4,
        min_curve: CURVE_SHARE * length(whole.range(2)),
        zeros,
        curve: None,
    };
    let few = search(vec![piece], MAX_PIECES, work, &mut |piece, work| {
        finder.examine(piece, work)
    });
    let curve = finder.curve;
    if few && curve.is_none() {
        return true;
    }
    // The zeros are not isolated: those on the edges are listed instead, among them the ends of a curve of zeros.
    for side in sides {
        collect(side, whole, zeros, work);
    }
    // This is a tangency of such a high order that it looked like a curve.
    if let (Some(zero), true) = (curve, zeros.is_empty()) {
        zeros.push(zero);
    }
    false
}

/// The state of a search.
struct ZeroFinder<'a> {
    whole: &'a PolynomialPiece,
    /// Whether the search covers the square; on an edge or at a corner the derivative of the pair has no meaning.
    on_face: bool,
    /// The smallest change of plane 2 along a curve of zeros.
    min_curve: f64,
    zeros: &'a mut Vec<Zero>,
    /// A point on a curve of zeros.
    curve: Option<Zero>,
}

impl ZeroFinder<'_> {
    /// Whether a piece has to be halved; if not, adds its zero, if any.
    fn examine(&mut self, piece: &PolynomialPiece, work: &mut WorkLimit) -> bool {
        let ranges = [piece.range(0), piece.range(1)];
        let is_far = |range: &[f64; 2]| range[0] > ZERO_TOLERANCE || range[1] < -ZERO_TOLERANCE;
        if ranges.iter().any(is_far) {
            return false;
        }
        let is_point = ranges.iter().all(|range| length(*range) <= ZERO_TOLERANCE);
        // Two equations for one parameter, or for none, have no Jacobian determinant: pieces are halved to the end.
        if !self.on_face {
            if is_point {
                self.add_undecided(piece, work);
            }
            return !is_point;
        }
        // Where neither polynomial excludes a zero, this component of the pair may.
        let slopes = mean_slopes(piece);
        let across = range_across(piece, &slopes);
        if is_far(&across) {
            return false;
        }
        // Halving does not help where the component is zero up to rounding.
        if is_point
            || length(across) <= ZERO_TOLERANCE && (self.may_be_curve(piece) || is_small(piece))
        {
            self.add_undecided(piece, work);
            return false;
        }
        if !is_one_to_one(piece, &slopes) {
            return true;
        }
        let Some(at) = zero_near(piece, self.whole, work) else {
            return true;
        };
        let zero = Zero::at(self.whole, onto_square(self.whole, at));
        if zero.residual <= ZERO_TOLERANCE {
            add(self.zeros, zero);
        }
        false
    }

    /// Whether plane 2 changes as much as along a curve of zeros.
    fn may_be_curve(&self, piece: &PolynomialPiece) -> bool {
        length(piece.range(2)) > self.min_curve
    }

    /// Adds the zero of a piece in which rounding decides.
    fn add_undecided(&mut self, piece: &PolynomialPiece, work: &mut WorkLimit) {
        let mut zero = Zero::within(self.whole, piece);
        if self.may_be_curve(piece) {
            self.curve = Some(zero);
            return;
        }
        if self.on_face {
            let touching_zero = touching_zero(self.whole, zero.at, work);
            let projected = project_to_zero_set(self.whole, zero.at, work);
            for at in [touching_zero, Some(projected)].into_iter().flatten() {
                zero = zero.union(&Zero::at(self.whole, onto_square(self.whole, at)));
            }
        }
        // The pair is zero to rounding in one direction, and to what remains in the piece in the other.
        if zero.residual <= 4.0 * ZERO_TOLERANCE {
            add(self.zeros, zero);
        }
    }
}

/// Whether a piece is so small that all zeros in it count as one; rounding turns such a zero into a whole
/// neighbourhood.
fn is_small(piece: &PolynomialPiece) -> bool {
    [piece.u, piece.v]
        .iter()
        .all(|range| length(*range) <= SAME_ZERO.sqrt())
}

fn length([low, high]: [f64; 2]) -> f64 {
    high - low
}

/// The middle of an interval, or 0 or 1 if it is an end of the interval.
fn snapped([from, to]: [f64; 2]) -> f64 {
    if from == 0.0 {
        0.0
    } else if to == 1.0 {
        1.0
    } else {
        0.5 * (from + to)
    }
}

impl Zero {
    /// A zero whose parameters are known.
    fn at(whole: &PolynomialPiece, at: [f64; 2]) -> Self {
        let [u, v] = at.map(|t| [t; 2]);
        Self {
            u,
            v,
            at,
            residual: distance_from_zero(whole, at),
        }
    }

    /// A zero somewhere in a piece; on the edge of the square if the piece reaches it.
    fn within(whole: &PolynomialPiece, piece: &PolynomialPiece) -> Self {
        let wider = |[from, to]: [f64; 2]| [from - (to - from), to + (to - from)];
        Self {
            u: wider(piece.u),
            v: wider(piece.v),
            ..Self::at(whole, [piece.u, piece.v].map(snapped))
        }
    }

    fn touches(&self, other: &Self) -> bool {
        let overlap =
            |a: [f64; 2], b: [f64; 2]| a[0] <= b[1] + SAME_ZERO && b[0] <= a[1] + SAME_ZERO;
        overlap(self.u, other.u) && overlap(self.v, other.v)
    }

    fn union(&self, other: &Self) -> Self {
        let both = |a: [f64; 2], b: [f64; 2]| [a[0].min(b[0]), a[1].max(b[1])];
        let nearer = if other.residual < self.residual {
            other
        } else {
            self
        };
        Self {
            u: both(self.u, other.u),
            v: both(self.v, other.v),
            ..*nearer
        }
    }
}

/// Adds a zero and merges it with all zeros that it touches.
fn add(zeros: &mut Vec<Zero>, mut zero: Zero) {
    let mut k = 0;
    while k < zeros.len() {
        if zeros[k].touches(&zero) {
            zero = zero.union(&zeros.swap_remove(k));
            // The union may touch zeros that the zero did not touch.
            k = 0;
        } else {
            k += 1;
        }
    }
    zeros.push(zero);
}

/// The mean of the coefficients of the derivatives of both planes: along u, and along v.
fn mean_slopes(piece: &PolynomialPiece) -> [[f64; 2]; 2] {
    [true, false].map(|along_u| {
        [0, 1].map(|k| {
            let (sum, count) = piece
                .slopes(k, along_u)
                .fold((0.0, 0.0), |(sum, n), slope| (sum + slope, n + 1.0));
            sum / count
        })
    })
}

/// The range of the component of the pair perpendicular to its largest derivative, in which a pair that touches zero
/// changes least.
fn range_across(piece: &PolynomialPiece, slopes: &[[f64; 2]; 2]) -> [f64; 2] {
    let [x, y] = longer(slopes[0], slopes[1]);
    let size = x.hypot(y).max(f64::MIN_POSITIVE);
    let pairs = piece.plane(0).iter().zip(piece.plane(1));
    range(pairs.map(|(a, b)| (x * b - y * a) / size)).into()
}

/// Whether the derivative stays so close to its mean that no two points have the same image.
///
/// With J the mean of the derivative's coefficients, every value of J⁻¹ times the derivative lies within [`MAX_SPREAD`]
/// of the identity, in the maximum row sum norm.
fn is_one_to_one(piece: &PolynomialPiece, [[au, bu], [av, bv]]: &[[f64; 2]; 2]) -> bool {
    let det = au * bv - av * bu;
    // For each row, the largest deviation of the coefficients along u, and along v.
    let mut spread = [[0.0_f64; 2]; 2];
    for (direction, along_u) in [true, false].into_iter().enumerate() {
        for (a, b) in piece.slopes(0, along_u).zip(piece.slopes(1, along_u)) {
            let image = [(bv * a - av * b) / det, (au * b - bu * a) / det];
            for (row, value) in image.into_iter().enumerate() {
                let residual = (value - if row == direction { 1.0 } else { 0.0 }).abs();
                // A singular mean gives NaN, which `max` would ignore.
                if residual.is_nan() {
                    return false;
                }
                spread[row][direction] = spread[row][direction].max(residual);
            }
        }
    }
    spread.iter().all(|[a, b]| a + b < MAX_SPREAD)
}
