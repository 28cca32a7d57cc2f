//! Triangles over the leaves of a patch, without T-junctions.
//!
//! Where a neighbour is cut finer, its vertices lie on the leaf's sides. All of them become corners of the leaf, which
//! is then a polygon inside its rectangle; triangles zip its lower left chain to its upper right one.

use super::leaves::Leaf;
use glam::DVec3;

/// The vertices of one patch by their parameters, which are whole numbers, in two orders.
#[derive(Default)]
pub(super) struct Lattice {
    /// v in the upper half, u in the lower: row by row. A vertex's number is its place here.
    rows: Vec<u64>,
    /// u in the upper half, v in the lower: column by column.
    columns: Vec<u64>,
}

/// The two ways round a leaf, both from its corner (u₁, v₀) to (u₀, v₁).
#[derive(Default)]
pub(super) struct Chains {
    /// By (u₀, v₀).
    below: Vec<u32>,
    /// By (u₁, v₁).
    above: Vec<u32>,
}

/// Two numbers in one that sorts by the first.
pub(super) fn pair(first: u32, second: u32) -> u64 {
    u64::from(first) << 32 | u64::from(second)
}

/// The second number of a pair.
#[allow(
    clippy::cast_possible_truncation,
    reason = "the lower half is what is wanted"
)]
pub(super) fn second(pair: u64) -> u32 {
    pair as u32
}

/// The first number of a pair.
pub(super) fn first(pair: u64) -> u32 {
    second(pair >> 32)
}

/// Sorts and keeps one of each.
pub(super) fn sort_distinct(numbers: &mut Vec<u64>) {
    numbers.sort_unstable();
    numbers.dedup();
}

/// The place of a number among sorted ones, or where it would be.
pub(super) fn place(sorted: &[u64], number: u64) -> usize {
    sorted.partition_point(|&other| other < number)
}

impl Lattice {
    /// All corners of the leaves, and more vertices (u, v).
    pub(super) fn fill(&mut self, leaves: &[Leaf], more: impl Iterator<Item = (u32, u32)>) {
        self.rows.clear();
        for leaf in leaves {
            let (far_u, far_v) = (leaf.u + leaf.du, leaf.v + leaf.dv);
            self.rows.extend([
                pair(leaf.v, leaf.u),
                pair(leaf.v, far_u),
                pair(far_v, leaf.u),
                pair(far_v, far_u),
            ]);
        }
        self.rows.extend(more.map(|(u, v)| pair(v, u)));
        sort_distinct(&mut self.rows);
        self.columns.clear();
        self.columns
            .extend(self.rows.iter().map(|&key| key.rotate_right(32)));
        self.columns.sort_unstable();
    }

    /// (u, v) of all vertices in turn.
    pub(super) fn vertices(&self) -> impl Iterator<Item = (u32, u32)> {
        self.rows.iter().map(|&key| (second(key), first(key)))
    }

    /// The vertices with the same v from u to `far_u`, by number.
    fn row(&self, v: u32, u: u32, far_u: u32) -> impl DoubleEndedIterator<Item = u32> {
        let from = place(&self.rows, pair(v, u));
        let to = place(&self.rows[from..], pair(v, far_u)) + from;
        number(from)..number(to + 1)
    }

    /// The vertices with the same u from v to `far_v`, by number.
    fn column(&self, u: u32, v: u32, far_v: u32) -> impl DoubleEndedIterator<Item = u32> {
        let from = place(&self.columns, pair(u, v));
        let to = place(&self.columns[from..], pair(u, far_v)) + from;
        let keys = self.columns[from..=to].iter();
        keys.map(|key| number(place(&self.rows, key.rotate_right(32))))
    }

    /// The chains of a leaf.
    fn chains(&self, leaf: &Leaf, chains: &mut Chains) {
        let (far_u, far_v) = (leaf.u + leaf.du, leaf.v + leaf.dv);
        chains.below.clear();
        chains.below.extend(self.row(leaf.v, leaf.u, far_u).rev());
        chains
            .below
            .extend(self.column(leaf.u, leaf.v, far_v).skip(1));
        chains.above.clear();
        chains.above.extend(self.column(far_u, leaf.v, far_v));
        chains
            .above
            .extend(self.row(far_v, leaf.u, far_u).rev().skip(1));
    }

    /// Hands out the triangles of a leaf, counter-clockwise over (u, v); `point_of` tells where a vertex is.
    ///
    /// A leaf without further vertices gives the two triangles of a grid's cell.
    pub(super) fn triangulate(
        &self,
        leaf: &Leaf,
        chains: &mut Chains,
        point_of: impl Fn(u32) -> DVec3,
        mut emit: impl FnMut([u32; 3]),
    ) {
        self.chains(leaf, chains);
        let (below, above) = (&chains.below[..], &chains.above[..]);
        let (last_below, last_above) = (below.len() - 2, above.len() - 2);
        emit([below[1], below[0], above[1]]);
        let (mut i, mut j) = (1, 1);
        // Neither chain reaches the common end before the last triangle, which so is never flat on one side.
        while i < last_below || j < last_above {
            let gap =
                |i: usize, j: usize| (point_of(below[i]) - point_of(above[j])).length_squared();
            let advance_below =
                j == last_above || (i < last_below && gap(i + 1, j) < gap(i, j + 1));
            if advance_below {
                emit([below[i + 1], below[i], above[j]]);
                i += 1;
            } else {
                emit([below[i], above[j], above[j + 1]]);
                j += 1;
            }
        }
        emit([below[i], above[j], below[i + 1]]);
    }
}

fn number(place: usize) -> u32 {
    u32::try_from(place).unwrap_or(u32::MAX)
}
