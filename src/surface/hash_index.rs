//! Grouping of equal items in linear time: the first item of each group represents it.

use glam::DVec3;

/// Marks an empty slot; no surface has so many vertices or edges.
const EMPTY: u32 = u32::MAX;

/// A hash table of the first item of each group: open addressing, at most half full.
pub(crate) struct HashIndex {
    slots: Vec<u32>,
}

impl HashIndex {
    /// A table for up to `count` items.
    pub(crate) fn new(count: usize) -> Self {
        Self {
            slots: vec![EMPTY; (2 * count + 1).next_power_of_two()],
        }
    }

    /// The first item that was added with this hash and is equal to `thing`; `thing` itself if there is none.
    pub(crate) fn find(&mut self, thing: u32, hash: u64, same: impl Fn(u32) -> bool) -> u32 {
        let mask = self.slots.len() - 1;
        // Takes the upper half of the hash, which the multiplication mixes best.
        let mut slot = (hash >> 32) as usize & mask;
        loop {
            let found = &mut self.slots[slot];
            if *found == EMPTY {
                *found = thing;
            }
            if *found == thing || same(*found) {
                return *found;
            }
            slot = (slot + 1) & mask;
        }
    }
}

/// Mixes another number into a hash.
pub(crate) fn mix(hash: u64, number: u64) -> u64 {
    // 2⁶⁴ / the golden ratio, odd: Fibonacci hashing (Knuth, TAOCP 3, §6.4).
    let product = (hash ^ number).wrapping_mul(0x9e37_79b9_7f4a_7c15);
    product ^ (product >> 29)
}

/// For each point, the index of the first point with equal coordinates.
pub(crate) fn joined(points: &[DVec3]) -> Vec<u32> {
    let mut first = HashIndex::new(points.len());
    (0..)
        .zip(points)
        .map(|(index, &p)| first.find(index, hash_of(p), |other| points[other as usize] == p))
        .collect()
}

fn hash_of(point: DVec3) -> u64 {
    // −0 + 0 is 0, so both zeros count as equal.
    point
        .to_array()
        .iter()
        .fold(0, |hash, x| mix(hash, (x + 0.0).to_bits()))
}
