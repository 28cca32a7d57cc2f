//! Which sides of patches are the same line?

use super::Surface;
use crate::list::Side;
use std::collections::BinaryHeap;

/// The vertices of a side in one of its two directions, the lesser.
type Key = Side;

/// The sides of a patch in this order: u = 0, u = 1, v = 0, v = 1.
pub(super) const SIDES: usize = 4;

impl Surface {
    /// For each side of each patch whether to draw it: not when an earlier patch has named the same vertices, in the
    /// same order or reversed, and not when all of them are one vertex.
    pub(super) fn distinct_sides(&self) -> Vec<[bool; SIDES]> {
        // Sorted by a heap, whose code is small.
        let sides: BinaryHeap<(Key, usize)> = (0..self.patch_count() * SIDES)
            .map(|side| (self.side(side), side))
            .collect();
        let sides = sides.into_sorted_vec();
        let mut distinct = vec![[false; SIDES]; self.patch_count()];
        let mut before: &[u32] = &[];
        for (key, side) in &sides {
            let collapsed = key.windows(2).all(|pair| pair[0] == pair[1]);
            distinct[side / SIDES][side % SIDES] = before != &key[..] && !collapsed;
            before = key;
        }
        distinct
    }

    /// The vertices of side `side % 4` of patch `side / 4`.
    fn side(&self, side: usize) -> Key {
        let (patch, side) = (side / SIDES, side % SIDES);
        let indices = self.patch_indices(patch).unwrap_or_default();
        let columns = self.degrees(patch).map_or(1, |[degree_u, _]| degree_u + 1);
        let last = indices.len().saturating_sub(columns);
        let forwards: Key = match side {
            0 => indices.iter().step_by(columns).copied().collect(),
            1 => indices
                .iter()
                .skip(columns - 1)
                .step_by(columns)
                .copied()
                .collect(),
            2 => indices.iter().take(columns).copied().collect(),
            _ => Key::from(&indices[last..]),
        };
        let backwards: Key = forwards.iter().rev().copied().collect();
        forwards.min(backwards)
    }
}
