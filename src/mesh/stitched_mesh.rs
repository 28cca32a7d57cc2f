//! Crack-free triangulation of the cells of all patches.
//!
//! Each line that patches share gets one list of samples: all samples that any of its patches needs. They are evaluated
//! once, from the control points of the edge, and are used by all patches at this line. A point of the surface that
//! several patches share is one *node*; a *corner* is a node as part of one patch, with its own u, v and normal.

use super::sampler::Sampler;
use crate::bernstein::evaluate::evaluate;
use crate::mesh::cell_triangulator::{
    Cell, CellTriangulator, index_of, lower_half, pack, sort_distinct, upper_half,
};
use crate::numeric::list::Points;
use crate::numeric::order::to_u32;
use crate::surface::network::Surface;
use crate::surface::topology::{SIDES, SideUse};
use glam::DVec3;

/// Marks a vertex without a node.
const NONE: u32 = u32::MAX;

/// Positions inside a folded cell at which a corner is added, in units of 1/`INNER_PARTS` of its lengths; the first
/// position that works is used.
const INNER_CORNERS: [[u32; 2]; 3] = [[4, 4], [3, 4], [4, 3]];
const INNER_PARTS: u32 = 8;

/// A node as part of one patch.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Corner {
    pub(crate) node: u32,
    pub(crate) u: f64,
    pub(crate) v: f64,
    pub(crate) normal: DVec3,
}

/// The ends of the part of one patch in the lists of corners and triangles.
#[derive(Clone, Copy, Debug)]
pub(crate) struct PatchEnd {
    pub(crate) corners: usize,
    pub(crate) triangles: usize,
}

/// The triangles of a surface before their corners are welded to vertices.
#[derive(Debug, Default)]
pub(crate) struct StitchedMesh {
    /// The position of each node.
    pub(crate) nodes: Vec<DVec3>,
    pub(crate) corners: Vec<Corner>,
    /// The indices of three corners for each triangle.
    pub(crate) triangles: Vec<[u32; 3]>,
    pub(crate) ends: Vec<PatchEnd>,
}

/// The cells of all patches.
pub(crate) struct SurfaceCells {
    pub(crate) cells: Vec<Cell>,
    /// The end of each patch's cells in `cells`.
    pub(crate) ends: Vec<usize>,
    /// The integer that represents the parameter 1.
    pub(crate) full: u32,
    /// Whether corners may be added inside cells to keep a tolerance.
    pub(crate) has_tolerance: bool,
}

/// The state of the stitching.
struct Stitcher<'a> {
    surface: &'a Surface,
    cut: &'a SurfaceCells,
    round: fn(DVec3) -> DVec3,
    uses: Vec<SideUse>,
    /// The samples inside shared lines, sorted: the number of the line's first edge, and the parameter along it.
    samples: Vec<u64>,
    /// The node of each vertex that is a corner of patches; the nodes of `samples` precede these nodes.
    node_of_vertex: Vec<u32>,
    out: StitchedMesh,
}

impl SurfaceCells {
    fn of_patch(&self, patch: usize) -> &[Cell] {
        let from = if patch == 0 { 0 } else { self.ends[patch - 1] };
        &self.cells[from..self.ends[patch]]
    }
}

/// Triangulates the cells of all patches; `round` rounds a point to the mesh's number type.
pub(crate) fn stitch(
    surface: &Surface,
    cut: &SurfaceCells,
    round: fn(DVec3) -> DVec3,
) -> StitchedMesh {
    let mut stitcher = Stitcher {
        surface,
        cut,
        round,
        uses: surface.side_uses(),
        samples: Vec::new(),
        node_of_vertex: vec![NONE; surface.vertices().len()],
        out: StitchedMesh::default(),
    };
    stitcher.sample_sides();
    let mut triangulator = CellTriangulator::default();
    for (k, patch) in surface.patches().enumerate() {
        let mut sampler = Sampler::new(&patch.points, patch.columns);
        if sampler.has_area() {
            triangulator.fill(cut.of_patch(k), cut.full, stitcher.side_vertices(k));
            let base = stitcher.out.corners.len();
            stitcher.add_corners(k, &triangulator, &mut sampler);
            stitcher.add_triangles(k, &mut triangulator, &mut sampler, base);
        }
        let (corners, triangles) = (stitcher.out.corners.len(), stitcher.out.triangles.len());
        stitcher.out.ends.push(PatchEnd { corners, triangles });
    }
    stitcher.out
}

impl Stitcher<'_> {
    /// Adds one node for each sample inside a line.
    fn sample_sides(&mut self) {
        for patch in 0..self.surface.patch_count() {
            for cell in self.cut.of_patch(patch) {
                for (side, from, length) in self.sides_of(cell).into_iter().flatten() {
                    for k in [from, from + length] {
                        let sample = self.sample(SIDES * patch + side, k);
                        self.samples.extend(sample);
                    }
                }
            }
        }
        sort_distinct(&mut self.samples);
        let (mut side, mut line) = (NONE, Points::new());
        for &sample in &self.samples {
            if upper_half(sample) != side {
                side = upper_half(sample);
                let vertices = self.surface.side(side as usize);
                line = vertices
                    .map(|v| self.surface.vertices()[v as usize])
                    .collect();
            }
            let point = evaluate(&line, self.parameter(lower_half(sample)));
            self.out.nodes.push((self.round)(point));
        }
    }

    /// The patch edges on which a cell lies, and the interval of each that it covers.
    fn sides_of(&self, cell: &Cell) -> [Option<(usize, u32, u32)>; SIDES] {
        let Cell { u, v, du, dv } = *cell;
        let full = self.cut.full;
        [
            (u == 0).then_some((0, v, dv)),
            (u + du == full).then_some((1, v, dv)),
            (v == 0).then_some((2, u, du)),
            (v + dv == full).then_some((3, u, du)),
        ]
    }

    /// The sample at k of an edge; `None` at its ends and on an edge that is a point.
    fn sample(&self, side: usize, k: u32) -> Option<u64> {
        let used = self.uses[side];
        if used.collapsed || k == 0 || k == self.cut.full {
            return None;
        }
        let along = if used.reversed { self.cut.full - k } else { k };
        Some(pack(to_u32(used.first), along))
    }

    /// The (u, v) of all samples on the edges of a patch.
    fn side_vertices(&self, patch: usize) -> impl Iterator<Item = (u32, u32)> {
        let full = self.cut.full;
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

    fn add_corners(
        &mut self,
        patch: usize,
        triangulator: &CellTriangulator,
        sampler: &mut Sampler,
    ) {
        for (u, v) in triangulator.vertices() {
            let (at_u, at_v) = (self.parameter(u), self.parameter(v));
            let (point, normal) = sampler.point_and_normal(at_u, at_v);
            let node = match self.shared_node(patch, u, v) {
                Some(node) => node,
                None => self.add_node(point),
            };
            self.out.corners.push(Corner {
                node,
                u: at_u,
                v: at_v,
                normal,
            });
        }
    }

    fn add_node(&mut self, point: DVec3) -> u32 {
        self.out.nodes.push((self.round)(point));
        to_u32(self.out.nodes.len() - 1)
    }

    /// The node of a vertex on an edge; `None` for an inner vertex.
    fn shared_node(&mut self, patch: usize, u: u32, v: u32) -> Option<u32> {
        let full = self.cut.full;
        let inside = |k: u32| k != 0 && k != full;
        let (side, k) = match (inside(u), inside(v)) {
            (true, true) => return None,
            (false, _) => (usize::from(u == full), v),
            (true, false) => (2 + usize::from(v == full), u),
        };
        let side = SIDES * patch + side;
        if let Some(sample) = self.sample(side, k) {
            return Some(to_u32(index_of(&self.samples, sample)));
        }
        let mut ends = self.surface.side(side);
        let vertex = if k == full {
            ends.next_back()
        } else {
            ends.next()
        }?;
        let index = vertex as usize;
        if self.node_of_vertex[index] == NONE {
            let point = self.surface.vertices()[index];
            self.node_of_vertex[index] = self.add_node(point);
        }
        Some(self.node_of_vertex[index])
    }

    /// Adds the triangles of a patch, except those with two coincident corners.
    fn add_triangles(
        &mut self,
        patch: usize,
        triangulator: &mut CellTriangulator,
        sampler: &mut Sampler,
        base: usize,
    ) {
        let corners = self.out.corners[base..].iter();
        let mut points: Vec<_> = corners
            .map(|c| self.out.nodes[c.node as usize].to_array())
            .collect();
        for cell in self.cut.of_patch(patch) {
            let (from, base) = (self.out.triangles.len(), to_u32(base));
            let covers = triangulator.triangulate(cell, &points, base, &mut self.out.triangles);
            if !covers
                && self.cut.has_tolerance
                && let Some(corner) = self.inner_corner(cell, triangulator, sampler, &points)
            {
                let center = to_u32(points.len());
                points.push(self.out.nodes[corner.node as usize].to_array());
                self.out.corners.push(corner);
                self.out.triangles.truncate(from);
                triangulator.fan(center, &points, base, &mut self.out.triangles);
            }
        }
    }

    /// A corner inside a cell that coincides with no vertex of the cell's outline; `None` if the cell is too small or
    /// all candidates coincide after rounding.
    ///
    /// The outline of a folded cell may visit a point twice. Triangles between these visits have no area, and points of
    /// the surface near such a triangle may be far from all other triangles. The bound on the distance holds for all
    /// triangles with corners in the cell, so it also holds for the triangles from an inner corner to the edges of the
    /// outline.
    fn inner_corner(
        &mut self,
        cell: &Cell,
        triangulator: &CellTriangulator,
        sampler: &mut Sampler,
        points: &[[f64; 3]],
    ) -> Option<Corner> {
        if cell.du.min(cell.dv) < INNER_PARTS {
            return None;
        }
        INNER_CORNERS.iter().find_map(|[i, j]| {
            let u = self.parameter(cell.u + cell.du / INNER_PARTS * i);
            let v = self.parameter(cell.v + cell.dv / INNER_PARTS * j);
            let (point, normal) = sampler.point_and_normal(u, v);
            let rounded = (self.round)(point).to_array();
            let is_new = triangulator
                .outline()
                .all(|k| points[k as usize] != rounded);
            is_new.then(|| Corner {
                node: self.add_node(point),
                u,
                v,
                normal,
            })
        })
    }

    fn parameter(&self, k: u32) -> f64 {
        f64::from(k) / f64::from(self.cut.full)
    }
}
