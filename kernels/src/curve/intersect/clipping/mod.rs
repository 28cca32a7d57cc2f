//! Intersections of two plane curves by fat-line clipping.
//!
//! Pairs of segments are cut down until each certainly contains one crossing, or runs along the other one. `clip`
//! discards parts that cannot intersect: a curve lies between two lines parallel to its chord (its fat line), so only
//! the part of the other curve between these lines matters. Source: Sederberg and Nishita, "Curve intersection using
//! Bézier clipping", CAD 22 (1990). `crossing` detects that two segments intersect at most once, and computes the
//! crossing. `along` compares two segments with about the same direction as graphs over that direction; it handles
//! tangencies of any order and overlaps.

mod along;
mod clip;
mod constants;
mod crossing;
mod piece;
mod solver;

pub use constants::CONTACT;
pub use crossing::crossing_step;
pub use piece::{Coefficients, Piece, Unweighted, Weights, balancing_speed};
pub use solver::{ClippingSolver, Contact};

use clip::clip;
use constants::WORTH_GOING_ON;
use crossing::Crossing;

impl<C: Coefficients, W: Weights<C>> ClippingSolver<C, W> {
    /// Finds all contacts of the two curves between the given parameters.
    #[inline(always)]
    pub fn run(&mut self, ts: [f64; 2], us: [f64; 2]) {
        let [a, b] = &self.whole;
        let (a, b) = (a.between(ts[0], ts[1]), b.between(us[0], us[1]));
        self.clip_pair(a, b);
    }

    fn clip_pair(&mut self, mut a: Piece<C, W>, mut b: Piece<C, W>) {
        loop {
            if !self.work.spend(1) {
                return self.record_contact(&a, &b);
            }
            let Some(remaining_b) = clip(&a, &mut b, self.slack) else {
                return;
            };
            let Some(remaining_a) = clip(&b, &mut a, self.slack) else {
                return;
            };
            if let Crossing::Found(contact) = self.crossing(&a, &b) {
                return self.found.push(contact);
            }
            // Clipping is slow where the segments run along each other or intersect several times.
            let stuck = remaining_a > WORTH_GOING_ON && remaining_b > WORTH_GOING_ON;
            if stuck && self.intersect_as_graphs(&a, &b) {
                return;
            }
            if stuck {
                return self.halve(&a, &b);
            }
        }
    }

    /// Continues with the halves of the larger segment; two segments without an extent are a contact.
    fn halve(&mut self, a: &Piece<C, W>, b: &Piece<C, W>) {
        let size = |piece: &Piece<C, W>| {
            if W::is_indivisible(piece) {
                0.0
            } else {
                piece.extent()
            }
        };
        let (size_a, size_b) = (size(a), size(b));
        if a.boxes_are_disjoint(b, self.slack) {
            return;
        }
        let is_small = |size: f64| size <= self.slack || size.is_nan();
        if is_small(size_a) && is_small(size_b) {
            self.record_contact(a, b);
        } else if size_a > size_b {
            let (before, after) = a.split(a.weights.middle());
            self.clip_pair(before, b.clone());
            self.clip_pair(after, b.clone());
        } else {
            let (before, after) = b.split(b.weights.middle());
            self.clip_pair(a.clone(), before);
            self.clip_pair(a.clone(), after);
        }
    }
}

/// [`ClippingSolver::run`] for cubics.
pub fn intersect_cubics(solver: &mut ClippingSolver<[f64; 4]>, ts: [f64; 2], us: [f64; 2]) {
    solver.run(ts, us);
}
