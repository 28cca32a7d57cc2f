//! Entries of a priority queue of pieces, ordered by their lower bound.

use super::piece::Piece;
use std::cmp::Ordering;

/// A piece and a lower bound on the searched quantity in it. In [`BinaryHeap`](std::collections::BinaryHeap), the
/// greatest entry is the one with the smallest bound; of equal bounds, the one with the smallest area.
pub(crate) struct Waiting {
    pub(crate) low: f64,
    pub(crate) piece: Piece,
}

impl Ord for Waiting {
    fn cmp(&self, other: &Self) -> Ordering {
        let area = |waiting: &Self| waiting.piece.area();
        let by_area = || area(other).total_cmp(&area(self));
        other.low.total_cmp(&self.low).then_with(by_area)
    }
}

impl PartialOrd for Waiting {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl PartialEq for Waiting {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other).is_eq()
    }
}

impl Eq for Waiting {}
