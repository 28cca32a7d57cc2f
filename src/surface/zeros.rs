//! Where are two polynomials over the unit square both zero?
//!
//! Pieces whose coefficients are all above or all below zero hold nothing. A piece on which the pair of polynomials is
//! one-to-one holds one zero at most, and Newton's method finds it. What is left in the end are zeros where the pair
//! only touches zero: pieces so small that rounding decides.

use super::newton::{SAME, greater, off, onto_square, slid, touch, zero_near};
use super::piece::{Piece, search};
use casteljau_kernels::WorkLimit;

/// What counts as zero, for coefficients of the size 1 to 4: their rounding after products and halvings.
pub(crate) const NEAR: f64 = 32.0 * f64::EPSILON;

/// More pieces in one round than isolated zeros can cause: a pair of bicubic polynomials has 18 zeros at most, and about
/// one where the pair touches zero some hundreds are left while they are small.
const MAX_PIECES: usize = 1024;

/// The most that the derivative may differ from its mean, for Newton's method to be sure of the zero (1 would do for
/// there to be one only).
const MAX_SPREAD: f64 = 0.5;

/// The share of a patch's extent that the ray must run in it for a whole curve to be seen. Where it touches, it seems to
/// run in it for the root of rounding, to the fourth for a touch of that order: some 1e-4.
const CURVE_SHARE: f64 = 1.0 / 64.0;

/// The most steps of a search over the square, its sides and its corners.
pub(crate) const MAX_RAY_STEPS: usize = 1 << 27;

/// The zeros that were found.
pub(crate) struct Zeros {
    /// Where they are.
    pub(crate) points: Vec<[f64; 2]>,
    /// Whether there are finitely many and these are all.
    pub(crate) complete: bool,
}

/// A zero, known to lie in a rectangle.
#[derive(Clone, Copy, Debug)]
struct Zero {
    u: [f64; 2],
    v: [f64; 2],
    /// Where the pair is nearest to zero, as far as is known, and how near.
    at: [f64; 2],
    off: f64,
}

/// The common zeros of the planes 0 and 1 of a whole piece. Where they are zero along a curve, its ends on the sides;
/// where they are zero along a side, the side's ends. Plane 2 tells a curve of zeros from one place that has many
/// parameters: along a curve it changes. `None` when that takes more steps than [`MAX_RAY_STEPS`].
pub(crate) fn common_zeros(whole: &Piece) -> Option<Zeros> {
    let mut zeros = Vec::new();
    let mut work = WorkLimit::new(MAX_RAY_STEPS);
    let complete = collect(whole.clone(), whole, &mut zeros, &mut work);
    let points = zeros.iter().map(|zero| zero.at).collect();
    (!work.is_exceeded()).then_some(Zeros { points, complete })
}

/// Adds the zeros of a piece: the whole one, a side of it, or a corner.
fn collect(piece: Piece, whole: &Piece, zeros: &mut Vec<Zero>, work: &mut WorkLimit) -> bool {
    let sides = piece.sides();
    let mut finder = Finder {
        whole,
        on_face: sides.len() == 4,
        min_curve: CURVE_SHARE * length(whole.range(2)),
        zeros,
        curve: None,
    };
    let few = search(vec![piece], MAX_PIECES, work, &mut |piece, work| {
        finder.look(piece, work)
    });
    let curve = finder.curve;
    if few && curve.is_none() {
        return true;
    }
    for side in sides {
        collect(side, whole, zeros, work);
    }
    // A touch of so high an order that it looked like a curve.
    if let (Some(zero), true) = (curve, zeros.is_empty()) {
        zeros.push(zero);
    }
    false
}

/// The state of a search.
struct Finder<'a> {
    whole: &'a Piece,
    /// Not on a side or at a corner, where the pair's derivative means nothing.
    on_face: bool,
    /// By how much plane 2 changes along what counts as a curve.
    min_curve: f64,
    zeros: &'a mut Vec<Zero>,
    /// A place on a curve of zeros.
    curve: Option<Zero>,
}

impl Finder<'_> {
    /// Whether a piece has to be seen closer; adds the zero of one that has not.
    fn look(&mut self, piece: &Piece, work: &mut WorkLimit) -> bool {
        let ranges = [piece.range(0), piece.range(1)];
        let is_far = |range: &[f64; 2]| range[0] > NEAR || range[1] < -NEAR;
        if ranges.iter().any(is_far) {
            return false;
        }
        let is_point = ranges.iter().all(|range| length(*range) <= NEAR);
        if !self.on_face {
            if is_point {
                self.add_last(piece, work);
            }
            return !is_point;
        }
        let slopes = mean_slopes(piece);
        let across = range_across(piece, &slopes);
        if is_far(&across) {
            return false;
        }
        if is_point || length(across) <= NEAR && (self.is_along(piece) || is_small(piece)) {
            self.add_last(piece, work);
            return false;
        }
        if !is_one_to_one(piece, &slopes) {
            return true;
        }
        let Some(at) = zero_near(piece, self.whole, work) else {
            return true;
        };
        let zero = Zero::at(self.whole, onto_square(self.whole, at));
        if zero.off <= NEAR {
            add(self.zeros, zero);
        }
        false
    }

    /// Whether plane 2 changes as much as along a curve of zeros.
    fn is_along(&self, piece: &Piece) -> bool {
        length(piece.range(2)) > self.min_curve
    }

    /// Adds the zero of a piece in which rounding decides.
    fn add_last(&mut self, piece: &Piece, work: &mut WorkLimit) {
        let mut zero = Zero::within(self.whole, piece);
        if self.is_along(piece) {
            self.curve = Some(zero);
            return;
        }
        if self.on_face {
            let touch = touch(self.whole, zero.at, work);
            let slid = slid(self.whole, zero.at, work);
            for at in [touch, Some(slid)].into_iter().flatten() {
                zero = zero.union(&Zero::at(self.whole, onto_square(self.whole, at)));
            }
        }
        // Zero in the one direction to rounding, in the other to what is left in the piece.
        if zero.off <= 4.0 * NEAR {
            add(self.zeros, zero);
        }
    }
}

/// Whether a piece is so small that zeros in it, of which rounding makes a whole neighbourhood, are one.
fn is_small(piece: &Piece) -> bool {
    [piece.u, piece.v]
        .iter()
        .all(|range| length(*range) <= SAME.sqrt())
}

fn length([low, high]: [f64; 2]) -> f64 {
    high - low
}

/// The middle, or the end of the whole range that an interval reaches.
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
    /// A zero whose place is known.
    fn at(whole: &Piece, at: [f64; 2]) -> Self {
        let [u, v] = at.map(|t| [t; 2]);
        Self {
            u,
            v,
            at,
            off: off(whole, at),
        }
    }

    /// A zero somewhere in a piece; if it lies on a side of the square, there.
    fn within(whole: &Piece, piece: &Piece) -> Self {
        let wider = |[from, to]: [f64; 2]| [from - (to - from), to + (to - from)];
        Self {
            u: wider(piece.u),
            v: wider(piece.v),
            ..Self::at(whole, [piece.u, piece.v].map(snapped))
        }
    }

    fn touches(&self, other: &Self) -> bool {
        let overlap = |a: [f64; 2], b: [f64; 2]| a[0] <= b[1] + SAME && b[0] <= a[1] + SAME;
        overlap(self.u, other.u) && overlap(self.v, other.v)
    }

    fn union(&self, other: &Self) -> Self {
        let both = |a: [f64; 2], b: [f64; 2]| [a[0].min(b[0]), a[1].max(b[1])];
        let nearer = if other.off < self.off { other } else { self };
        Self {
            u: both(self.u, other.u),
            v: both(self.v, other.v),
            ..*nearer
        }
    }
}

/// Adds a zero; with all that it touches it is one.
fn add(zeros: &mut Vec<Zero>, mut zero: Zero) {
    let mut k = 0;
    while k < zeros.len() {
        if zeros[k].touches(&zero) {
            zero = zero.union(&zeros.swap_remove(k));
            k = 0;
        } else {
            k += 1;
        }
    }
    zeros.push(zero);
}

/// The mean of the derivatives' coefficients: of both planes along u, and along v.
fn mean_slopes(piece: &Piece) -> [[f64; 2]; 2] {
    [true, false].map(|along_u| {
        [0, 1].map(|k| {
            let (sum, count) = piece
                .slopes(k, along_u)
                .fold((0.0, 0.0), |(sum, n), slope| (sum + slope, n + 1.0));
            sum / count
        })
    })
}

/// The range of the pair across its greatest derivative, where a touching pair changes least.
fn range_across(piece: &Piece, slopes: &[[f64; 2]; 2]) -> [f64; 2] {
    let [x, y] = greater(slopes[0], slopes[1]);
    let size = x.hypot(y).max(f64::MIN_POSITIVE);
    piece
        .plane(0)
        .iter()
        .zip(piece.plane(1))
        .map(|(a, b)| (x * b - y * a) / size)
        .fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], c| {
            [low.min(c), high.max(c)]
        })
}

/// Whether the derivative stays so close to its mean that no two points have the same image.
///
/// With J the mean of the derivative's coefficients, every value of J⁻¹ times the derivative lies within [`MAX_SPREAD`]
/// of the identity, in the norm of the greatest row.
fn is_one_to_one(piece: &Piece, [[au, bu], [av, bv]]: &[[f64; 2]; 2]) -> bool {
    let det = au * bv - av * bu;
    // For each row the most that it is off by the coefficients along u, and along v.
    let mut spread = [[0.0_f64; 2]; 2];
    for (direction, along_u) in [true, false].into_iter().enumerate() {
        for (a, b) in piece.slopes(0, along_u).zip(piece.slopes(1, along_u)) {
            let image = [(bv * a - av * b) / det, (au * b - bu * a) / det];
            for (row, value) in image.into_iter().enumerate() {
                let off = (value - if row == direction { 1.0 } else { 0.0 }).abs();
                // A singular mean gives NaN, which `max` would hide.
                if off.is_nan() {
                    return false;
                }
                spread[row][direction] = spread[row][direction].max(off);
            }
        }
    }
    spread.iter().all(|[a, b]| a + b < MAX_SPREAD)
}
