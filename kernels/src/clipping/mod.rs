//! Where two plane curves meet.
//!
//! Pairs of pieces are cut down until each holds one crossing for sure, or runs along the other one. [`clip`] throws away
//! what cannot meet: a curve lies between two lines parallel to its chord, so the other one matters only where it
//! is between them too. Source: Sederberg and Nishita, "Curve intersection using Bézier clipping", CAD 22 (1990).
//! [`cross`] sees that two pieces meet at most once, and finds where. [`along`] compares two pieces that run in about the
//! same direction as graphs over that direction; it serves tangencies of any order and shared pieces.

mod along;
mod clip;
mod cross;
mod piece;

pub use piece::{Piece, Row};

use crate::work::WorkLimit;
use clip::clip;
use cross::Crossing;

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

/// A clip that leaves more than this is not worth another one: then a piece is halved. Source: Sederberg and Nishita.
const WORTH_CLIPPING: f64 = 0.8;

/// Where both pieces keep more than this they are halved at once.
const WORTH_GOING_ON: f64 = 0.6;

/// Where a piece is halved: not in the middle, where symmetric curves like to meet, to be found by both halves.
const SPLIT: f64 = 0.484375;

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

    /// Looks for all contacts of the two curves between some of their parameters.
    #[inline(always)]
    pub fn run(&mut self, ts: [f64; 2], us: [f64; 2]) {
        let [a, b] = &self.whole;
        let (a, b) = (a.between(ts[0], ts[1]), b.between(us[0], us[1]));
        self.pair(a, b);
    }

    fn pair(&mut self, mut a: Piece<R>, mut b: Piece<R>) {
        loop {
            if !self.work.spend(1) {
                return self.note(&a, &b);
            }
            let Some(left_b) = clip(&a, &mut b, self.slack) else {
                return;
            };
            let Some(left_a) = clip(&b, &mut a, self.slack) else {
                return;
            };
            if let Crossing::Found(contact) = self.crossing(&a, &b) {
                return self.found.push(contact);
            }
            let stuck = left_a > WORTH_GOING_ON && left_b > WORTH_GOING_ON;
            if stuck && self.run_along(&a, &b) {
                return;
            }
            if stuck {
                return self.halve(&a, &b);
            }
        }
    }

    /// Goes on with the halves of the longer piece; two pieces without an extent are a contact.
    fn halve(&mut self, a: &Piece<R>, b: &Piece<R>) {
        let (size_a, size_b) = (a.extent(), b.extent());
        if a.is_off(b, self.slack) {
            return;
        }
        if size_a <= self.slack && size_b <= self.slack {
            self.note(a, b);
        } else if size_a > size_b {
            let (before, after) = a.split(SPLIT);
            self.pair(before, b.clone());
            self.pair(after, b.clone());
        } else {
            let (before, after) = b.split(SPLIT);
            self.pair(a.clone(), before);
            self.pair(a.clone(), after);
        }
    }

    /// Notes that two whole pieces are in contact.
    fn note(&mut self, a: &Piece<R>, b: &Piece<R>) {
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

/// [`ClippingSolver::run`] for cubics.
pub fn intersect_cubics(solver: &mut ClippingSolver<[f64; 4]>, ts: [f64; 2], us: [f64; 2]) {
    solver.run(ts, us);
}
