//! The samples along the edges of patches: each line that patches share has one list, with all samples that any of its
//! patches needs.

use super::cut::SurfaceCells;
use super::mesh_patch::PatchNetwork;
use crate::surface::topology::{SIDES, SideUse};
use casteljau_kernels::mesh::cell_triangulator::{
    Cell, index_of, lower_half, pack, sort_distinct, upper_half,
};
use casteljau_kernels::numeric::order::to_u32;
use glam::DVec3;

/// The samples inside all lines.
pub(crate) struct EdgeSamples {
    /// Their points, rounded.
    pub(crate) points: Vec<DVec3>,
    uses: Vec<SideUse>,
    /// Sorted: the number of the line's first edge, and the parameter along it.
    samples: Vec<u64>,
    /// The integer that represents the parameter 1.
    full: u32,
}

impl EdgeSamples {
    /// `round` rounds a point to the mesh's number type.
    pub(crate) fn new<S: PatchNetwork>(
        surface: &S,
        cut: &SurfaceCells,
        round: fn(DVec3) -> DVec3,
    ) -> Self {
        let mut all = Self {
            points: Vec::new(),
            uses: surface.side_uses(),
            samples: Vec::new(),
            full: cut.full,
        };
        for patch in 0..surface.network().patch_count() {
            for cell in cut.of_patch(patch) {
                for (side, from, length) in all.sides_of(cell).into_iter().flatten() {
                    for k in [from, from + length] {
                        let sample = all.sample(SIDES * patch + side, k);
                        all.samples.extend(sample);
                    }
                }
            }
        }
        sort_distinct(&mut all.samples);
        all.evaluate(surface, round);
        all
    }

    fn evaluate<S: PatchNetwork>(&mut self, surface: &S, round: fn(DVec3) -> DVec3) {
        let mut line = None;
        for &sample in &self.samples {
            let side = upper_half(sample);
            let edge = match line {
                Some((number, ref edge)) if number == side => edge,
                _ => &line.insert((side, surface.edge(side as usize))).1,
            };
            let t = f64::from(lower_half(sample)) / f64::from(self.full);
            self.points.push(round(S::edge_point(edge, t)));
        }
    }

    /// The place in the list of the sample at k of an edge; `None` at its ends and on an edge that is a point.
    pub(crate) fn index(&self, side: usize, k: u32) -> Option<usize> {
        let sample = self.sample(side, k)?;
        Some(index_of(&self.samples, sample))
    }

    /// The patch edges on which a cell lies, and the interval of each that it covers.
    fn sides_of(&self, cell: &Cell) -> [Option<(usize, u32, u32)>; SIDES] {
        let Cell { u, v, du, dv } = *cell;
        let full = self.full;
        [
            (u == 0).then_some((0, v, dv)),
            (u + du == full).then_some((1, v, dv)),
            (v == 0).then_some((2, u, du)),
            (v + dv == full).then_some((3, u, du)),
        ]
    }

    fn sample(&self, side: usize, k: u32) -> Option<u64> {
        let used = self.uses[side];
        if used.collapsed || k == 0 || k == self.full {
            return None;
        }
        let along = if used.reversed { self.full - k } else { k };
        Some(pack(to_u32(used.first), along))
    }

    /// The (u, v) of all samples on the edges of a patch.
    pub(crate) fn of_patch(&self, patch: usize) -> impl Iterator<Item = (u32, u32)> {
        let full = self.full;
        (0..SIDES).flat_map(move |side| {
            let used = self.uses[SIDES * patch + side];
            let line = to_u32(used.first);
            let from = index_of(&self.samples, pack(line, 0));
            let to = index_of(&self.samples, pack(line + 1, 0));
            // The list of an edge that is a point is empty, since such an edge has no samples.
            self.samples[from..to].iter().map(move |&sample| {
                let along = lower_half(sample);
                let k = if used.reversed { full - along } else { along };
                match side {
                    0 => (0, k),
                    1 => (full, k),
                    2 => (k, 0),
                    _ => (k, full),
                }
            })
        })
    }
}
