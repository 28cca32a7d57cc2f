//! Nearest point on patches where the distance is small.
//!
//! The square of a distance below 1e-7 of the size is lost in the rounding of the polynomial that [`minimise`]
//! searches. This search bounds the distance itself: a piece lies in the box of its control points. The bound is of
//! first order only, but it is exact to rounding in each coordinate.
//!
//! [`minimise`]: crate::surface::minimum::minimise

use super::piece::PolynomialPiece;
use super::queued_piece::QueuedPiece;
use casteljau_kernels::numeric::work_limit::WorkLimit;
use std::collections::BinaryHeap;

/// Pieces are dropped unless their bound is smaller than the smallest distance found by more than `MIN_IMPROVEMENT` of that
/// distance, or by more than `MIN_IMPROVEMENT_OF_SIZE` of the size.
const MIN_IMPROVEMENT: f64 = 1.0 / 16.0;
const MIN_IMPROVEMENT_OF_SIZE: f64 = 1.0 / 16_777_216.0;

/// The cost of one descent, in evaluations of a piece with derivatives.
const DESCENT_JETS: usize = 16;

/// The maximum number of coefficients in the queue: 16 MB.
const MAX_QUEUED_COEFFICIENTS: usize = 1 << 21;

/// Searches pieces whose planes are the coordinates of S − p for the smallest distance.
///
/// `min` is the smallest distance so far; `descend` descends from a point and returns the distance that it reaches.
/// Pieces farther away than `cutoff` are dropped. The search ends at a distance of `goal` or when no piece can be
/// nearer. It also ends when it has taken the maximum number of steps, and then returns `false`.
pub(crate) fn search_small(
    wholes: Vec<PolynomialPiece>,
    mut min: f64,
    [goal, cutoff]: [f64; 2],
    descend: &mut dyn FnMut(usize, [f64; 2]) -> f64,
    mut work: WorkLimit,
) -> bool {
    let mut queue: BinaryHeap<QueuedPiece> = wholes.into_iter().map(by_box).collect();
    let mut coefficients = 0;
    while let Some(QueuedPiece { low, piece }) = queue.pop() {
        coefficients = usize::saturating_sub(coefficients, piece.plane(0).len());
        let is_far = |low: f64, min: f64| low > cutoff.min(improvement_limit(min));
        if min <= goal || is_far(low, min) {
            return true;
        }
        let (start, corner) = nearest_corner(&piece);
        let descends = corner < improvement_limit(min);
        let jets = if descends { DESCENT_JETS } else { 0 };
        if !work.spend(piece.steps() + jets * piece.jet_steps()) {
            return false;
        }
        if descends {
            min = min.min(descend(piece.index, start));
        }
        if piece.is_divisible() {
            let halves = piece.halves(3).map(by_box);
            let near = halves.into_iter().filter(|half| !is_far(half.low, min));
            for half in near {
                coefficients += half.piece.plane(0).len();
                queue.push(half);
            }
            if coefficients > MAX_QUEUED_COEFFICIENTS {
                return false;
            }
        }
    }
    true
}

/// The distance below which a point is a sufficient improvement.
fn improvement_limit(min: f64) -> f64 {
    min - (MIN_IMPROVEMENT * min).min(MIN_IMPROVEMENT_OF_SIZE)
}

/// A piece and the distance of the bounding box of its control points.
fn by_box(piece: PolynomialPiece) -> QueuedPiece {
    let gap = |axis: usize| {
        let [low, high] = piece.range(axis);
        low.max(-high).max(0.0)
    };
    let low = length([gap(0), gap(1), gap(2)]);
    QueuedPiece { low, piece }
}

/// The nearest corner and its distance.
fn nearest_corner(piece: &PolynomialPiece) -> ([f64; 2], f64) {
    let [x, y, z] = [0, 1, 2].map(|axis| piece.corners(axis));
    (0..4)
        .map(|k| (x[k].0, length([x[k].1, y[k].1, z[k].1])))
        .fold(
            ([0.0; 2], f64::INFINITY),
            |a, b| if b.1 < a.1 { b } else { a },
        )
}

fn length([x, y, z]: [f64; 3]) -> f64 {
    (x * x + y * y + z * z).sqrt()
}
