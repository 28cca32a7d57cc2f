//! Crack-free triangulation of the cells of all patches.
//!
//! The samples of a line that patches share are evaluated once, from the control points of the edge, and are used by all
//! patches at this line. A point of the surface that several patches share is one *node*; a *corner* is a node as part
//! of one patch, with its own u, v and normal.

use super::cut::SurfaceCells;
use super::edge_samples::EdgeSamples;
use super::sampler::Sampler;
use crate::mesh::cell_triangulator::{Cell, CellTriangulator};
use crate::numeric::order::to_u32;
#[cfg(feature = "rayon")]
use crate::parallel::{PATCHES_AT_ONCE, has_cores, map_patches};
#[cfg(feature = "rayon")]
use crate::patch::Patch;
use crate::surface::network::Surface;
use crate::surface::topology::SIDES;
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

/// The state of the stitching.
struct Stitcher<'a> {
    surface: &'a Surface,
    cut: &'a SurfaceCells,
    round: fn(DVec3) -> DVec3,
    /// Their nodes come first, in the same order.
    edges: EdgeSamples,
    /// The node of each vertex that is a corner of patches.
    node_of_vertex: Vec<u32>,
    out: StitchedMesh,
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
        edges: EdgeSamples::new(surface, cut),
        node_of_vertex: vec![NONE; surface.vertices().len()],
        out: StitchedMesh::default(),
    };
    let points = stitcher.edges.points(surface);
    stitcher.out.nodes.extend(points.map(round));
    stitcher.add_patches();
    stitcher.out
}

impl Stitcher<'_> {
    fn add_patches(&mut self) {
        #[cfg(feature = "rayon")]
        if has_cores() {
            return self.add_patches_on_all_cores();
        }
        let mut triangulator = CellTriangulator::default();
        for (k, patch) in self.surface.patches().enumerate() {
            let mut sampler = Sampler::new(&patch.points, patch.columns);
            if sampler.has_area() {
                self.fill(&mut triangulator, k);
                let base = self.out.corners.len();
                for (u, v) in triangulator.vertices() {
                    let sample = sampler.point_and_normal(self.parameter(u), self.parameter(v));
                    self.add_corner(k, (u, v), sample);
                }
                self.add_triangles(k, &mut triangulator, &mut sampler, base);
            }
            self.end_patch();
        }
    }

    /// The vertices of some patches at a time are computed on all cores, and put together in order.
    #[cfg(feature = "rayon")]
    fn add_patches_on_all_cores(&mut self) {
        let patches: Vec<Patch> = self.surface.patches().collect();
        let first = (0..).step_by(PATCHES_AT_ONCE);
        for (batch, first) in patches.chunks(PATCHES_AT_ONCE).zip(first) {
            let this = &*self;
            let filled = map_patches(batch.len(), |k| this.samples_of(first + k, &batch[k]));
            for (k, parts) in (first..).zip(filled) {
                if let Some((mut sampler, mut triangulator, samples)) = parts {
                    let base = self.out.corners.len();
                    for (vertex, sample) in triangulator.vertices().zip(samples) {
                        self.add_corner(k, vertex, sample);
                    }
                    self.add_triangles(k, &mut triangulator, &mut sampler, base);
                }
                self.end_patch();
            }
        }
    }

    /// The point and the normal at each vertex of a patch; `None` for a patch that is a curve or a point.
    #[cfg(feature = "rayon")]
    fn samples_of(
        &self,
        number: usize,
        patch: &Patch,
    ) -> Option<(Sampler, CellTriangulator, Vec<(DVec3, DVec3)>)> {
        let mut sampler = Sampler::new(&patch.points, patch.columns);
        sampler.has_area().then(|| {
            let mut triangulator = CellTriangulator::default();
            self.fill(&mut triangulator, number);
            let vertices = triangulator.vertices();
            let samples = vertices
                .map(|(u, v)| sampler.point_and_normal(self.parameter(u), self.parameter(v)))
                .collect();
            (sampler, triangulator, samples)
        })
    }

    fn fill(&self, triangulator: &mut CellTriangulator, patch: usize) {
        let (cells, samples) = (self.cut.of_patch(patch), self.edges.of_patch(patch));
        triangulator.fill(cells, self.cut.full, samples);
    }

    fn end_patch(&mut self) {
        let (corners, triangles) = (self.out.corners.len(), self.out.triangles.len());
        self.out.ends.push(PatchEnd { corners, triangles });
    }

    fn add_corner(&mut self, patch: usize, (u, v): (u32, u32), (point, normal): (DVec3, DVec3)) {
        let node = match self.shared_node(patch, u, v) {
            Some(node) => node,
            None => self.add_node(point),
        };
        self.out.corners.push(Corner {
            node,
            u: self.parameter(u),
            v: self.parameter(v),
            normal,
        });
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
        if let Some(index) = self.edges.index(side, k) {
            return Some(to_u32(index));
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
