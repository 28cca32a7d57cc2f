//! Global minimum of polynomials over patches by branch and bound.

use super::descent::descend;
use super::piece::{MODERATE_DEGREE, PolynomialPiece};
use super::queued_piece::QueuedPiece;
use casteljau_kernels::numeric::work_limit::WorkLimit;
use std::collections::BinaryHeap;

/// Rounding error of coefficients of size 1 to 8 after products and halvings; values that differ by at most this count
/// as equal.
const SLACK: f64 = 64.0 * f64::EPSILON;

/// Minima nearer than this in u and v count as one: the square root of rounding, for a flat minimum, with a margin.
const SAME_POINT: f64 = 1.0 / 1_048_576.0;

/// The maximum number of coefficients in the queue: 16 MB.
const MAX_QUEUED_COEFFICIENTS: usize = 1 << 21;

/// The work that a refinement counts as, in evaluations with derivatives. Only the work limit depends on it: a refinement
/// ends after one evaluation unless the distance is small, and then takes at most 16 steps.
const REFINEMENT_JETS: usize = 4;

const UNIT_SQUARE: [[f64; 2]; 2] = [[0.0, 1.0]; 2];

/// The maximum number of starts that are tried although they are only as good as the best point. Isolated minima of
/// equal value are few; where whole curves are minimal, trying all starts would take long.
const MAX_TIES: usize = 256;

/// A point where a minimum is attained.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Minimum {
    /// The index of the polynomial, from its piece.
    pub(crate) index: usize,
    pub(crate) u: f64,
    pub(crate) v: f64,
    /// The value of the objective.
    pub(crate) value: f64,
}

/// The quantity to minimise, computed directly and not from the polynomials; both have the same order of values.
pub(crate) trait Objective {
    /// The value at a point of a polynomial. It decides between points that the polynomials cannot distinguish.
    fn value(&self, index: usize, at: [f64; 2]) -> f64;

    /// The degree of the polynomial divided by the degree of its patch.
    fn degree_factor(&self) -> usize {
        1
    }

    /// A point that is at least as good, found by a method that loses fewer digits.
    fn refine(&self, _index: usize, at: [f64; 2]) -> [f64; 2] {
        at
    }

    /// Whether the search can end: no point is better by more than rounding, or a more exact search follows.
    fn is_final(&self, _minimum: &Minimum) -> bool {
        false
    }
}

/// The minimum of polynomials over the unit square, with coefficients of size at most 1 to 8.
///
/// If the minimum is attained along a curve, the result is one of its points. When the search reaches the maximum
/// number of steps for each polynomial, the result is the best point found: a local minimum, reached from the smallest
/// corner of all pieces so far. The flag tells whether the search is complete.
pub(crate) fn minimise(
    wholes: &[PolynomialPiece],
    objective: &dyn Objective,
) -> Option<(Minimum, bool)> {
    let limits = wholes
        .iter()
        .map(|whole| whole.max_search_steps(objective.degree_factor() * MODERATE_DEGREE));
    let mut work = WorkLimit::new(limits.fold(0, usize::saturating_add));
    minimise_within(wholes, objective, &mut work)
}

/// As [`minimise`], with another maximum number of steps.
pub(crate) fn minimise_within(
    wholes: &[PolynomialPiece],
    objective: &dyn Objective,
    work: &mut WorkLimit,
) -> Option<(Minimum, bool)> {
    let mut search = MinimumSearch {
        wholes,
        objective,
        is_done: false,
        min_value: f64::INFINITY,
        best: None,
        ties: 0,
    };
    // The better the first point, the more pieces are excluded at once; corners are points, not only bounds.
    let corner = |piece: &PolynomialPiece| min_corner(piece).1;
    let first = wholes
        .iter()
        .min_by(|a, b| corner(a).total_cmp(&corner(b)))?;
    search.improve(first, &UNIT_SQUARE, true, work);
    for whole in wholes {
        for (at, _) in whole.corners(0) {
            search.keep_better(whole, at, work);
        }
    }
    let is_complete = search.run(work);
    search.best.map(|best| (best, is_complete))
}

/// The smallest value found so far.
struct MinimumSearch<'a> {
    wholes: &'a [PolynomialPiece],
    objective: &'a dyn Objective,
    /// Whether no point can be better than the best one.
    is_done: bool,
    /// The smallest value of a polynomial found so far.
    min_value: f64,
    best: Option<Minimum>,
    /// The number of starts that were tried although they are no better than `best`.
    ties: usize,
}

impl MinimumSearch<'_> {
    /// Examines pieces in the order of their smallest coefficient, and halves those that may contain a smaller value.
    /// Returns `false` when a limit ends the search.
    fn run(&mut self, work: &mut WorkLimit) -> bool {
        let mut queue: BinaryHeap<QueuedPiece> = self
            .wholes
            .iter()
            .cloned()
            .map(by_min_coefficient)
            .collect();
        // Counts the coefficients of halves only: all whole polynomials are in the queue from the start.
        let mut coefficients = 0;
        while let Some(QueuedPiece { low, piece }) = queue.pop() {
            let count = piece.plane(0).len();
            coefficients = usize::saturating_sub(coefficients, count);
            // The coefficients of all other pieces are not smaller.
            if self.is_done || low >= self.min_value + SLACK {
                return true;
            }
            if !work.spend(piece.steps()) {
                return false;
            }
            if self.must_be_halved(&piece, low, work) {
                coefficients += 2 * count;
                if coefficients > MAX_QUEUED_COEFFICIENTS {
                    return false;
                }
                queue.extend(piece.halves(1).map(by_min_coefficient));
            }
        }
        true
    }

    /// Whether a piece may contain a smaller value and has to be halved.
    fn must_be_halved(&mut self, piece: &PolynomialPiece, low: f64, work: &mut WorkLimit) -> bool {
        self.improve(piece, &UNIT_SQUARE, false, work);
        if self.is_done || low >= self.min_value - SLACK || !piece.is_divisible() {
            return false;
        }
        // A minimum of a convex piece is its only one.
        !(is_convex(piece) && self.improve(piece, &[piece.u, piece.v], true, work))
    }

    /// Descends from the smallest corner of a piece if that can improve the result; returns whether it converged to a
    /// minimum.
    fn improve(
        &mut self,
        piece: &PolynomialPiece,
        within: &[[f64; 2]; 2],
        always: bool,
        work: &mut WorkLimit,
    ) -> bool {
        let (start, corner) = min_corner(piece);
        let whole = &self.wholes[piece.index];
        // A corner that is as good as the best point up to rounding is tried if its exact value is better. One that is
        // better by more than rounding is always tried.
        if !always && corner > self.min_value - SLACK {
            if corner > self.min_value + SLACK
                || self.ties == MAX_TIES
                || self.is_known(piece.index, start)
                || !work.spend(whole.jet_steps())
                || !self.is_better(self.objective.value(piece.index, start))
            {
                return false;
            }
            self.ties += 1;
        }
        let (at, value, converged) = descend(whole, within, start, work);
        self.min_value = self.min_value.min(value);
        self.keep_better(whole, at, work);
        converged
    }

    fn is_better(&self, value: f64) -> bool {
        self.best.is_none_or(|best| value < best.value)
    }

    /// Makes a point the best one if its value is smaller.
    fn keep_better(&mut self, piece: &PolynomialPiece, at: [f64; 2], work: &mut WorkLimit) {
        let index = piece.index;
        let [u, v] = if work.spend(REFINEMENT_JETS * piece.jet_steps()) {
            self.objective.refine(index, at)
        } else {
            at
        };
        let value = self.objective.value(index, [u, v]);
        if self.is_better(value) {
            let best = Minimum { index, u, v, value };
            self.is_done = self.objective.is_final(&best);
            self.best = Some(best);
        }
    }

    /// Whether a point is the best one found so far.
    fn is_known(&self, index: usize, [u, v]: [f64; 2]) -> bool {
        self.best.is_some_and(|best| {
            best.index == index
                && (best.u - u).abs() < SAME_POINT
                && (best.v - v).abs() < SAME_POINT
        })
    }
}

fn by_min_coefficient(piece: PolynomialPiece) -> QueuedPiece {
    let [low, _] = piece.range(0);
    QueuedPiece { low, piece }
}

/// The corner of a piece with the smallest value, and this value.
fn min_corner(piece: &PolynomialPiece) -> ([f64; 2], f64) {
    let [first, others @ ..] = piece.corners(0);
    let lesser = |a: ([f64; 2], f64), b: ([f64; 2], f64)| if b.1 < a.1 { b } else { a };
    others.into_iter().fold(first, lesser)
}

/// Whether the coefficients of the second derivatives prove that the polynomial has one minimum in the piece.
fn is_convex(piece: &PolynomialPiece) -> bool {
    let [uu, uv, vv] = piece.second_derivatives();
    // The Hessian matrix is positive definite (Sylvester's criterion) for all values in these ranges.
    uu[0] > 0.0 && vv[0] > 0.0 && uu[0] * vv[0] > uv[0].abs().max(uv[1].abs()).powi(2)
}
