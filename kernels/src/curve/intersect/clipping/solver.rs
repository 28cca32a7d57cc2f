//! The state of a search for contacts.

use super::piece::{Coefficients, Piece, Unweighted, Weights};
use crate::numeric::work_limit::WorkLimit;

/// A range where two curves are as close as rounding can distinguish: the parameters t₀ ≤ t₁ on the first curve and the
/// corresponding u₀ and u₁ on the second. A crossing has t₀ = t₁ and u₀ = u₁.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Contact {
    /// The parameters on the first curve.
    pub t: [f64; 2],
    /// The corresponding parameters on the second curve.
    pub u: [f64; 2],
    /// Whether the two curves certainly cross here at an angle.
    pub crossing: bool,
}

/// The search and its results.
pub struct ClippingSolver<C, W = Unweighted> {
    /// The whole curves.
    pub whole: [Piece<C, W>; 2],
    /// The distance below which points are in contact: the effect of rounding.
    pub slack: f64,
    /// Counts the pairs of segments; above its limit segments are not cut any more.
    pub work: WorkLimit,
    /// The contacts, unsorted.
    pub found: Vec<Contact>,
}

impl<C: Coefficients, W: Weights<C>> ClippingSolver<C, W> {
    /// Expects two curves whose coordinates are at most about 1, the distance that counts as contact, and the maximum
    /// number of pairs of segments.
    pub fn new(whole: [Piece<C, W>; 2], slack: f64, limit: usize) -> Self {
        Self {
            whole,
            slack,
            work: WorkLimit::new(limit),
            found: Vec::new(),
        }
    }

    /// Records that two whole segments are in contact.
    pub fn record_contact(&mut self, a: &Piece<C, W>, b: &Piece<C, W>) {
        let (mut t, mut u) = ([a.from, a.to], [b.from, b.to]);
        // A segment may run backwards; t increases in a contact, and each u stays with its t.
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
