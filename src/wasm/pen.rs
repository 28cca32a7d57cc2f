//! A pen that writes its steps down; JavaScript draws them on a canvas.

use super::arena::Arena;
use crate::curve::Pen;
use glam::DVec2;

/// Leaves each step in the arena as its code and its coordinates: 0 close, 1 line, 2 quadratic, 3 cubic (the codes are
/// the numbers of points), 4 move.
pub(super) struct ArenaPen<'a> {
    arena: &'a mut Arena,
    at: usize,
}

const MOVE: f64 = 4.0;

impl<'a> ArenaPen<'a> {
    pub(super) fn new(arena: &'a mut Arena) -> Self {
        Self { arena, at: 0 }
    }

    /// The number of f64 written so far.
    pub(super) fn end(&self) -> usize {
        self.at
    }

    fn step(&mut self, code: f64, points: &[DVec2]) {
        self.at = self.arena.put_numbers(self.at, &[code]);
        self.at = self.arena.put(self.at, points);
    }
}

impl Pen for ArenaPen<'_> {
    fn move_to(&mut self, p: DVec2) {
        self.step(MOVE, &[p]);
    }
    fn line_to(&mut self, p: DVec2) {
        self.step(1.0, &[p]);
    }
    fn quad_to(&mut self, p1: DVec2, p: DVec2) {
        self.step(2.0, &[p1, p]);
    }
    fn cubic_to(&mut self, p1: DVec2, p2: DVec2, p: DVec2) {
        self.step(3.0, &[p1, p2, p]);
    }
    fn close(&mut self) {
        self.step(0.0, &[]);
    }
}
