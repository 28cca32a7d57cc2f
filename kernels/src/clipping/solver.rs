//! The state of a search for contacts.

use super::piece::{Piece, Row};
use crate::work::WorkLimit;

/// Where two curves are as close as rounding can tell: the parameters t₀ ≤ t₁ on the first and, at the same places, u₀
/// and u₁ on the second. A crossing has t₀ = t₁ and u₀ = u₁.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Contact {
    /// First parameter on the first curve.
    pub t: [f64; 2],
    /// The same places on the second curve.
    pub u: [f64; 2],
    /// Whether the two curves surely cross here, at an angle.
    pub crossing: bool,
}

/// Where a piece is halved: not in the middle, where symmetric curves like to meet, to be found by both halves.
pub(crate) const SPLIT: f64 = 0.484375;

/// The search, with what it has found.
pub struct ClippingSolver<R> {
    /// The whole curves.
    pub(crate) whole: [Piece<R>; 2],
    /// Closer than this is a contact: what rounding may have moved.
    pub(crate) slack: f64,
    /// Counts the pairs of pieces that are looked at; past its limit pieces are not cut any more.
    pub(crate) work: WorkLimit,
    /// The contacts, in no order.
    pub found: Vec<Contact>,
}

impl<R: Row> ClippingSolver<R> {
    /// Two curves whose coordinates are at most about 1, the distance that counts as none, and the
    /// most pairs of pieces that are looked at.
    pub fn new(whole: [Piece<R>; 2], slack: f64, limit: usize) -> Self {
        Self {
            whole,
            slack,
            work: WorkLimit::new(limit),
            found: Vec::new(),
        }
    }

    /// Notes that two whole pieces are in contact.
    pub(crate) fn note(&mut self, a: &Piece<R>, b: &Piece<R>) {
        let (mut t, mut u) = ([a.from, a.to], [b.from, b.to]);
        if t[0] > t[1] {
            t.swap(0, 1);
            u.swap(0, 1);
        }
        self.found.push(Contact {
            t,
            u,
            crossing: false,
        });
    }
}
