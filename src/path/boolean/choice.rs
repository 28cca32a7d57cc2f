//! The choice between arcs that coincide: a result follows the same outline as long as it can.

use super::arrangement::Arrangement;
use super::outline::Piece;

/// How many edges ahead the choice looks.
const LOOK_AHEAD: usize = 64;

/// The arcs along some half-edges, one after the other.
struct Choices<'a> {
    arrangement: &'a Arrangement,
    half_edges: &'a [usize],
}

/// For each half-edge of a contour one of its arcs: preferably the one that continues what comes before, or else the
/// one that goes on longest.
pub(super) fn chosen_pieces(arrangement: &Arrangement, half_edges: &[usize]) -> Vec<Piece> {
    let choices = Choices {
        arrangement,
        half_edges,
    };
    let count = half_edges.len();
    let single = (0..count).find(|&k| choices.at(k).len() == 1).unwrap_or(0);
    let mut pieces: Vec<Piece> = Vec::with_capacity(count);
    for k in single..single + count {
        let continued = pieces.last().and_then(|last| choices.continuing(last, k));
        pieces.extend(continued.or_else(|| choices.longest(k)));
    }
    pieces
}

impl Choices<'_> {
    /// The pieces for half-edge k of the closed contour.
    fn at(&self, k: usize) -> impl ExactSizeIterator<Item = Piece> + '_ {
        let h = self.half_edges[k % self.half_edges.len()];
        let edges = &self.arrangement.edges;
        let members = edges.members(h / 2).iter();
        members.map(move |member| Piece::new(member, h.is_multiple_of(2)))
    }

    fn continuing(&self, last: &Piece, k: usize) -> Option<Piece> {
        self.at(k)
            .find(|piece| last.continues(self.arrangement, piece))
    }

    /// The piece for half-edge k whose outline runs along most of the next half-edges.
    fn longest(&self, k: usize) -> Option<Piece> {
        let mut alive: Vec<(Piece, Piece)> = self.at(k).map(|piece| (piece, piece)).collect();
        for ahead in k + 1..k + 1 + LOOK_AHEAD.min(self.half_edges.len()) {
            if alive.len() == 1 {
                break;
            }
            let longer: Vec<(Piece, Piece)> = alive
                .iter()
                .filter_map(|(first, last)| Some((*first, self.continuing(last, ahead)?)))
                .collect();
            if longer.is_empty() {
                break;
            }
            alive = longer;
        }
        alive.first().map(|&(first, _)| first)
    }
}
