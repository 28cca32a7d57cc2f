//! The arena: one block of f64 in wasm memory that holds the arguments and the results of all calls.
//!
//! JavaScript writes the arguments at its start, calls, and reads the result from its start. Small calls allocate
//! nothing; a large result makes the arena grow, after which JavaScript asks for its address again.

use super::single_thread_cell::SingleThreadCell;
use crate::geometry::error::{Error, Part};
use crate::geometry::point::Point;
use bytemuck::Pod;
use glam::DVec3;
use wasm_bindgen::prelude::wasm_bindgen;

/// Enough for all levels of de Casteljau's algorithm at degree 64 in 3D (65·66/2 points), the largest result of a small
/// call.
const MIN_LENGTH: usize = 8192;

static ARENA: SingleThreadCell<Arena> = SingleThreadCell::new(Arena(Vec::new()));

/// The block, with methods that decode arguments and encode results.
pub(crate) struct Arena(Vec<f64>);

/// Calls `f` with the arena.
#[inline]
pub(crate) fn with<R>(f: impl FnOnce(&mut Arena) -> R) -> R {
    ARENA.with(f)
}

/// Calls `f` with the arena and returns its count; see [`encode_result`].
#[inline]
pub(crate) fn answer(f: impl FnOnce(&mut Arena) -> Result<usize, Error>) -> isize {
    encode_result(with(f))
}

/// The return value of an export: a count, or −1 for an error, whose message is left in the arena.
///
/// Exports do not return a `Result`, because wasm-bindgen would add code for thrown values to every function.
pub(crate) fn encode_result(result: Result<usize, Error>) -> isize {
    match result {
        Ok(count) => count.cast_signed(),
        Err(error) => {
            with(|arena| arena.write_message(&error));
            -1
        }
    }
}

/// Makes the arena hold at least `length` numbers and returns its address.
#[wasm_bindgen]
pub fn arena_reserve(length: usize) -> *const f64 {
    with(|arena| {
        arena.grow(length.max(MIN_LENGTH));
        arena.0.as_ptr()
    })
}

/// The number of f64 that the arena holds.
#[wasm_bindgen]
pub fn arena_length() -> usize {
    with(|arena| arena.0.len())
}

/// Frees the memory of a large result.
#[wasm_bindgen]
pub fn arena_trim() {
    with(|arena| {
        arena.0.truncate(MIN_LENGTH);
        arena.0.shrink_to_fit();
    });
}

impl Arena {
    fn grow(&mut self, length: usize) {
        if self.0.len() < length {
            self.0.resize(length, 0.0);
        }
    }

    /// `count` points, starting at number `at`.
    #[inline]
    pub(crate) fn points<P: Point + Pod>(&self, at: usize, count: usize) -> &[P] {
        bytemuck::cast_slice(self.numbers(at, count * P::DIMENSION))
    }

    /// `count` numbers, starting at number `at`.
    #[inline]
    pub(crate) fn numbers(&self, at: usize, count: usize) -> &[f64] {
        &self.0[at..at + count]
    }

    /// The points as 3D points; plane points get z = 0.
    ///
    /// Operations that work alike in both dimensions (splitting, derivatives, joints …) are done in 3D for both, which
    /// halves the code in the module. The zeros do not change any result.
    pub(crate) fn points_in_space<L: FromIterator<DVec3>>(
        &self,
        at: usize,
        count: usize,
        dimension: usize,
    ) -> L {
        (0..count)
            .map(|k| self.point_in_space(at + k * dimension, dimension))
            .collect()
    }

    /// One point as a 3D point.
    pub(crate) fn point_in_space(&self, at: usize, dimension: usize) -> DVec3 {
        let p = self.numbers(at, dimension);
        DVec3::new(p[0], p[1], p.get(2).copied().unwrap_or(0.0))
    }

    /// Writes 3D points, with `dimension` numbers each, starting at number `at`; returns the end.
    pub(crate) fn write_from_space(
        &mut self,
        at: usize,
        points: &[DVec3],
        dimension: usize,
    ) -> usize {
        let end = at + points.len() * dimension;
        self.grow(end);
        for (place, point) in self.0[at..end].chunks_exact_mut(dimension).zip(points) {
            // Assignments instead of a copy, because a copy of unknown length is a function call.
            (place[0], place[1]) = (point.x, point.y);
            if let Some(z) = place.get_mut(2) {
                *z = point.z;
            }
        }
        end
    }

    /// One number.
    pub(crate) fn number(&self, at: usize) -> f64 {
        self.0[at]
    }

    /// A count or an index, stored as a number.
    #[allow(
        clippy::cast_possible_truncation,
        reason = "JavaScript checks that it is a count"
    )]
    #[allow(
        clippy::cast_sign_loss,
        reason = "JavaScript checks that it is a count"
    )]
    pub(crate) fn count(&self, at: usize) -> usize {
        self.0[at] as usize
    }

    /// Indices, stored as numbers.
    #[allow(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "JavaScript passes integers below 2³²"
    )]
    pub(crate) fn small_counts(&self, at: usize, count: usize) -> Vec<u32> {
        let numbers = self.numbers(at, count).iter();
        numbers.map(|&number| number as u32).collect()
    }

    /// Writes one point at the start.
    #[inline]
    pub(crate) fn write_point<P: Point + Pod>(&mut self, point: P) {
        self.0[..P::DIMENSION].copy_from_slice(bytemuck::cast_slice(&[point]));
    }

    /// Writes points, starting at number `at`; returns the end.
    #[inline]
    pub(crate) fn write<P: Point + Pod>(&mut self, at: usize, points: &[P]) -> usize {
        self.write_numbers(at, bytemuck::cast_slice(points))
    }

    /// Writes numbers, starting at number `at`; returns the end.
    #[inline]
    pub(crate) fn write_numbers(&mut self, at: usize, numbers: &[f64]) -> usize {
        let end = at + numbers.len();
        self.grow(end);
        self.0[at..end].copy_from_slice(numbers);
        end
    }

    /// Writes counts, starting at number `at`; returns the end.
    pub(crate) fn write_counts(&mut self, at: usize, counts: impl Iterator<Item = usize>) -> usize {
        let numbers: Vec<f64> = counts.map(|count| count as f64).collect();
        self.write_numbers(at, &numbers)
    }

    /// Writes the parts of a message: address and length of a text, or a number and −1. JavaScript joins them.
    #[inline(never)]
    fn write_message(&mut self, error: &Error) {
        let mut at = 0;
        for part in error.parts() {
            // The texts are constants of the module, so their addresses stay valid.
            let pair = match part {
                Part::Text(text) => [text.as_ptr().addr() as f64, text.len() as f64],
                Part::Number(number) => [number, -1.0],
            };
            at = self.write_numbers(at, &pair);
        }
    }

    /// Two output slices of equal length: the first `length` numbers of the arena, and a copy of them.
    pub(crate) fn two_outputs(&mut self, length: usize) -> (&mut [f64], &mut [f64]) {
        self.grow(2 * length);
        // Both outputs start as the input, which is changed in place.
        self.0.copy_within(..length, length);
        self.0[..2 * length].split_at_mut(length)
    }

    /// Space for `count` points at the start, to be written in place.
    pub(crate) fn reserve<P: Point + Pod>(&mut self, count: usize) -> &mut [P] {
        self.grow(count * P::DIMENSION);
        bytemuck::cast_slice_mut(&mut self.0[..count * P::DIMENSION])
    }
}
