//! Pieces that wait in a priority queue, the one with the least bound first.

use super::piece::Piece;
use std::cmp::Ordering;

/// A piece and a lower bound on what is searched for in it. In [`BinaryHeap`](std::collections::BinaryHeap), the greatest
/// of them is the one with the least bound, of equal ones the smallest.
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
