//! Crack-free triangulation of the cells of all patches.
//!
//! The samples of a line that patches share are evaluated once, from the control points of the edge, and are used by all
//! patches at this line. A point of the surface that several patches share is one *node*; a *corner* is a node as part
//! of one patch, with its own u, v and normal.

use super::cut::SurfaceCells;
use super::edge_samples::EdgeSamples;
use super::mesh_patch::{MeshPatch, PatchNetwork, PatchSampler};
use crate::surface::topology::SIDES;
use casteljau_kernels::mesh::cell_triangulator::{Cell, CellTriangulator};
use casteljau_kernels::numeric::order::to_u32;
use glam::DVec3;
use std::ops::Range;
#[cfg(feature = "rayon")]
use {crate::parallel::has_cores, rayon::prelude::*};

/// Marks a vertex without a node.
pub(super) const NONE: u32 = u32::MAX;

/// Positions inside a folded cell at which a corner is added, in units of 1/`INNER_PARTS` of its lengths; the first
/// position that works is used.
const INNER_CORNERS: [[u32; 2]; 3] = [[4, 4], [3, 4], [4, 3]];
const INNER_PARTS: u32 = 8;

/// A node as part of one patch.
#[derive(Clone, Copy, Debug)]
pub(crate) struct MeshCorner {
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
    pub(crate) corners: Vec<MeshCorner>,
    /// The indices of three corners for each triangle.
    pub(crate) triangles: Vec<[u32; 3]>,
    pub(crate) ends: Vec<PatchEnd>,
}

/// Triangulates the cells of all patches; `round` rounds a point to the mesh's number type.
pub(crate) fn stitch<S: PatchNetwork>(
    surface: &S,
    cut: &SurfaceCells,
    round: fn(DVec3) -> DVec3,
) -> StitchedMesh {
    let edges = EdgeSamples::new(surface, cut, round);
    #[cfg(feature = "rayon")]
    if has_cores() {
        return stitch_on_all_cores(&edges, surface.network().patch_count(), || {
            Stitcher::new(surface, cut, round, &edges)
        });
    }
    let mut stitcher = Stitcher::new(surface, cut, round, &edges);
    stitcher.add_patches(0..surface.network().patch_count());
    let mut out = stitcher.out;
    let mut nodes = edges.points;
    nodes.append(&mut out.nodes);
    out.nodes = nodes;
    out
}

/// The state of the stitching.
pub(super) struct Stitcher<'a, S> {
    surface: &'a S,
    cut: &'a SurfaceCells,
    round: fn(DVec3) -> DVec3,
    edges: &'a EdgeSamples,
    /// The node of each vertex that is a corner of patches.
    pub(super) node_of_vertex: Vec<u32>,
    /// Its nodes follow those of `edges`.
    pub(super) out: StitchedMesh,
}

impl<'a, S: PatchNetwork> Stitcher<'a, S> {
    fn new(
        surface: &'a S,
        cut: &'a SurfaceCells,
        round: fn(DVec3) -> DVec3,
        edges: &'a EdgeSamples,
    ) -> Self {
        Self {
            surface,
            cut,
            round,
            edges,
            node_of_vertex: vec![NONE; surface.network().vertices().len()],
            out: StitchedMesh::default(),
        }
    }

    pub(super) fn add_patches(&mut self, numbers: Range<usize>) {
        let mut triangulator = CellTriangulator::default();
        for k in numbers {
            let Some(patch) = self.surface.patch(k) else {
                return;
            };
            let mut sampler = patch.sampler();
            if sampler.has_area() {
                let (cells, samples) = (self.cut.of_patch(k), self.edges.of_patch(k));
                triangulator.fill(cells, self.cut.full, samples);
                let base = self.out.corners.len();
                self.add_corners(k, &triangulator, &mut sampler);
                self.add_triangles(k, &mut triangulator, &mut sampler, base);
            }
            let (corners, triangles) = (self.out.corners.len(), self.out.triangles.len());
            self.out.ends.push(PatchEnd { corners, triangles });
        }
    }

    fn add_corners(
        &mut self,
        patch: usize,
        triangulator: &CellTriangulator,
        sampler: &mut impl PatchSampler,
    ) {
        for (u, v) in triangulator.vertices() {
            let (at_u, at_v) = (self.parameter(u), self.parameter(v));
            let (point, normal) = sampler.point_and_normal(at_u, at_v);
            let node = match self.shared_node(patch, u, v) {
                Some(node) => node,
                None => self.add_node(point),
            };
            self.out.corners.push(MeshCorner {
                node,
                u: at_u,
                v: at_v,
                normal,
            });
        }
    }

    fn add_node(&mut self, point: DVec3) -> u32 {
        self.out.nodes.push((self.round)(point));
        to_u32(self.edges.points.len() + self.out.nodes.len() - 1)
    }

    fn point(&self, node: u32) -> [f64; 3] {
        let (node, shared) = (node as usize, &self.edges.points);
        let point = match shared.get(node) {
            Some(point) => point,
            None => &self.out.nodes[node - shared.len()],
        };
        point.to_array()
    }

    /// The node of a vertex on an edge; `None` for an inner vertex.
    fn shared_node(&mut self, patch: usize, u: u32, v: u32) -> Option<u32> {
        let full = self.cut.full;
        let inside = |k: u32| k != 0 && k != full;
        // On the edges U0 and U1 the parameter along the edge is v, on V0 and V1 it is u; corners of the patch are on
        // U0 or U1.
        let (side, k) = match (inside(u), inside(v)) {
            (true, true) => return None,
            (false, _) => (usize::from(u == full), v),
            (true, false) => (2 + usize::from(v == full), u),
        };
        let side = SIDES * patch + side;
        if let Some(index) = self.edges.index(side, k) {
            return Some(to_u32(index));
        }
        // An end of an edge, or any point of an edge that is a point: a vertex of the surface.
        let mut ends = self.surface.network().side(side);
        let vertex = if k == full {
            ends.next_back()
        } else {
            ends.next()
        }?;
        let index = vertex as usize;
        if self.node_of_vertex[index] == NONE {
            let point = self.surface.network().vertices()[index];
            self.node_of_vertex[index] = self.add_node(point);
        }
        Some(self.node_of_vertex[index])
    }

    /// Adds the triangles of a patch, except those with two coincident corners.
    fn add_triangles(
        &mut self,
        patch: usize,
        triangulator: &mut CellTriangulator,
        sampler: &mut impl PatchSampler,
        base: usize,
    ) {
        let corners = self.out.corners[base..].iter();
        let mut points: Vec<_> = corners.map(|c| self.point(c.node)).collect();
        for cell in self.cut.of_patch(patch) {
            // If the triangles do not cover a folded cell, those around a corner inside of it take their place.
            let (from, base) = (self.out.triangles.len(), to_u32(base));
            let covers = triangulator.triangulate(cell, &points, base, &mut self.out.triangles);
            if !covers
                && self.cut.has_tolerance
                && let Some(corner) = self.inner_corner(cell, triangulator, sampler, &points)
            {
                let center = to_u32(points.len());
                points.push(self.point(corner.node));
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
        sampler: &mut impl PatchSampler,
        points: &[[f64; 3]],
    ) -> Option<MeshCorner> {
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
            is_new.then(|| MeshCorner {
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

/// The number of parts for each core: more of them divide the work more evenly, and need more memory.
#[cfg(feature = "rayon")]
const PARTS_PER_CORE: usize = 4;

/// The mesh of all patches on all cores: the patches in several parts, whose nodes, corners and triangles are then
/// renumbered as if the patches had been added one after the other. `start` makes a stitcher without patches.
#[cfg(feature = "rayon")]
fn stitch_on_all_cores<'a, S: PatchNetwork + 'a>(
    edges: &EdgeSamples,
    patches: usize,
    start: impl Fn() -> Stitcher<'a, S> + Sync,
) -> StitchedMesh {
    let length = patches
        .div_ceil(PARTS_PER_CORE * rayon::current_num_threads())
        .max(1);
    let parts: Vec<Stitcher<S>> = (0..patches.div_ceil(length))
        .into_par_iter()
        .map(|k| {
            let mut part = start();
            part.add_patches(k * length..((k + 1) * length).min(patches));
            part
        })
        .collect();
    let mut whole = start();
    whole.out.nodes.clone_from(&edges.points);
    reserve(&mut whole.out, &parts);
    for part in parts {
        append(&mut whole, part, edges.points.len());
    }
    whole.out
}

/// Room for all parts at once, so that nothing is copied again when a list grows.
#[cfg(feature = "rayon")]
fn reserve<S>(out: &mut StitchedMesh, parts: &[Stitcher<S>]) {
    let total =
        |length: fn(&StitchedMesh) -> usize| parts.iter().map(|part| length(&part.out)).sum();
    out.nodes.reserve(total(|part| part.nodes.len()));
    out.corners.reserve(total(|part| part.corners.len()));
    out.triangles.reserve(total(|part| part.triangles.len()));
}

/// Appends a part whose own nodes begin at number `shared`. A vertex that an earlier part has as a node keeps it.
#[cfg(feature = "rayon")]
fn append<S>(whole: &mut Stitcher<S>, part: Stitcher<S>, shared: usize) {
    let nodes = renumber(whole, &part, shared);
    let out = &mut whole.out;
    let (corners, triangles) = (out.corners.len(), out.triangles.len());
    out.corners.extend(part.out.corners.iter().map(|corner| {
        // The nodes on shared edges have the same numbers in all parts.
        let own = (corner.node as usize).checked_sub(shared);
        MeshCorner {
            node: own.map_or(corner.node, |own| nodes[own]),
            ..*corner
        }
    }));
    let first = to_u32(corners);
    let moved = part.out.triangles.iter().map(|t| t.map(|k| k + first));
    out.triangles.extend(moved);
    out.ends.extend(part.out.ends.iter().map(|end| PatchEnd {
        corners: corners + end.corners,
        triangles: triangles + end.triangles,
    }));
}

/// The number in the whole of each own node of a part; new nodes are appended.
#[cfg(feature = "rayon")]
fn renumber<S>(whole: &mut Stitcher<S>, part: &Stitcher<S>, shared: usize) -> Vec<u32> {
    let mut vertex_of = vec![NONE; part.out.nodes.len()];
    for (vertex, &node) in (0..).zip(&part.node_of_vertex) {
        if node != NONE {
            vertex_of[node as usize - shared] = vertex;
        }
    }
    let mut number = |(&point, vertex): (_, u32)| {
        // NONE is beyond the list: a node inside of a patch belongs to no vertex.
        let known = whole.node_of_vertex.get_mut(vertex as usize);
        if let Some(&mut node) = known
            && node != NONE
        {
            return node;
        }
        whole.out.nodes.push(point);
        let node = to_u32(whole.out.nodes.len() - 1);
        if let Some(entry) = known {
            *entry = node;
        }
        node
    };
    part.out
        .nodes
        .iter()
        .zip(vertex_of)
        .map(&mut number)
        .collect()
}
