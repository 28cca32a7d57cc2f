//! Entries of a priority queue of pieces, ordered by their lower bound.

use super::piece::PolynomialPiece;
use std::cmp::Ordering;

/// A piece and a lower bound on the searched quantity in it. In [`BinaryHeap`](std::collections::BinaryHeap), the
/// greatest entry is the one with the smallest bound; of equal bounds, the one with the smallest area.
pub(crate) struct QueuedPiece {
    pub(crate) low: f64,
    pub(crate) piece: PolynomialPiece,
}

impl Ord for QueuedPiece {
    fn cmp(&self, other: &Self) -> Ordering {
        let area = |queued: &Self| queued.piece.area();
        let by_area = || area(other).total_cmp(&area(self));
        other.low.total_cmp(&self.low).then_with(by_area)
    }
}

impl PartialOrd for QueuedPiece {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl PartialEq for QueuedPiece {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other).is_eq()
    }
}

impl Eq for QueuedPiece {}
