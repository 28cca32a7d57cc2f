//! Construction of meshes with one grid per patch.

use super::buffers::MAX_U16_VERTICES;
use super::grid::{Grid, GridMethod};
use super::grid_evaluator::GridEvaluator;
use super::{Indices, Mesh, PatchRange};
use crate::geometry::error::Error;
use casteljau_kernels::mesh::layout::{
    fill_indices_u16, fill_indices_u32, fill_patch_ids, fill_uvs,
};
use casteljau_kernels::numeric::order::to_u32;
use glam::DVec3;
use std::ops::Range;
#[cfg(feature = "rayon")]
use {crate::parallel::has_cores, rayon::prelude::*};

/// The smallest number of samples that a core takes at once.
#[cfg(feature = "rayon")]
const MIN_SAMPLES: usize = 1 << 12;

/// Writes the net of a patch and returns its degrees in u and v.
pub(crate) trait NetOf: Fn(usize, &mut Vec<DVec3>) -> (usize, usize) + Sync {}
impl<F: Fn(usize, &mut Vec<DVec3>) -> (usize, usize) + Sync> NetOf for F {}

/// Fills meshes with one grid for each patch: all patches at once, or part by part.
pub(crate) struct GridMeshBuilder {
    pub(crate) patches: usize,
    pub(crate) grid: Grid,
    #[cfg(feature = "rayon")]
    method: GridMethod,
    pub(crate) quads: bool,
    kernel: GridEvaluator,
    net: Vec<DVec3>,
}

impl GridMeshBuilder {
    pub(crate) fn new(
        patches: usize,
        grid: Grid,
        method: GridMethod,
        quads: bool,
    ) -> Result<Self, Error> {
        grid.check(patches)?;
        Ok(Self {
            patches,
            grid,
            #[cfg(feature = "rayon")]
            method,
            quads,
            kernel: GridEvaluator::new(grid, method),
            net: Vec::new(),
        })
    }

    /// Whether indices need 32 bits.
    pub(crate) fn wide(&self) -> bool {
        self.patches * self.grid.vertex_count() > MAX_U16_VERTICES
    }

    /// Fills the mesh with a part of the patches. With `has_layout` the mesh already holds a grid with the same counts,
    /// and everything that depends only on the counts is kept.
    ///
    /// Buffers that are large enough are reused; the others grow.
    pub(crate) fn fill(
        &mut self,
        part: Range<usize>,
        net_of: impl NetOf,
        has_layout: bool,
        mesh: &mut Mesh,
    ) {
        self.prepare(&part, has_layout, mesh);
        self.fill_vertices(part, net_of, mesh);
    }

    /// As [`fill`](Self::fill), without positions and normals.
    pub(crate) fn prepare(&self, part: &Range<usize>, has_layout: bool, mesh: &mut Mesh) {
        if !has_layout {
            self.fill_layout(part, mesh);
        }
        let numbers = 3 * self.grid.vertex_count();
        mesh.positions.resize(part.len() * numbers, 0.0);
        mesh.normals.resize(part.len() * numbers, 0.0);
    }

    fn fill_vertices(&mut self, part: Range<usize>, net_of: impl NetOf, mesh: &mut Mesh) {
        #[cfg(feature = "rayon")]
        if has_cores() {
            return self.fill_on_all_cores(part, net_of, mesh);
        }
        let numbers = 3 * self.grid.vertex_count();
        let vertex_range = mesh
            .positions
            .chunks_exact_mut(numbers)
            .zip(mesh.normals.chunks_exact_mut(numbers));
        for (patch, (positions, normals)) in part.zip(vertex_range) {
            self.net.clear();
            let (degree_u, degree_v) = net_of(patch, &mut self.net);
            self.kernel
                .fill(&self.net, degree_u, degree_v, positions, normals);
        }
    }

    #[cfg(feature = "rayon")]
    fn fill_on_all_cores(&self, part: Range<usize>, net_of: impl NetOf, mesh: &mut Mesh) {
        let count = self.grid.vertex_count();
        let vertex_range = mesh
            .positions
            .par_chunks_exact_mut(3 * count)
            .zip(mesh.normals.par_chunks_exact_mut(3 * count))
            .with_min_len(MIN_SAMPLES.div_ceil(count));
        let evaluator = || (GridEvaluator::new(self.grid, self.method), Vec::new());
        vertex_range.enumerate().for_each_init(
            evaluator,
            |(kernel, net), (index, (positions, normals))| {
                net.clear();
                let (degree_u, degree_v) = net_of(part.start + index, net);
                kernel.fill(net, degree_u, degree_v, positions, normals);
            },
        );
    }

    /// Fills everything that depends only on the counts.
    fn fill_layout(&self, part: &Range<usize>, mesh: &mut Mesh) {
        let grid = self.grid;
        let count = grid.vertex_count();
        mesh.uvs.resize(2 * part.len() * count, 0.0);
        fill_uvs(grid.segments_u, grid.segments_v, &mut mesh.uvs);
        mesh.patch_ids.resize(part.len() * count, 0);
        fill_patch_ids(to_u32(part.start), count, &mut mesh.patch_ids);
        let cell = grid.quad(0, 0).map(|vertex| vertex + part.start * count);
        let [a, b, c, d] = cell;
        self.fill_indices(part, &[a, b, c, a, c, d], &mut mesh.indices);
        mesh.quads = self.quads.then(|| {
            let mut faces = mesh.quads.take().unwrap_or_default();
            self.fill_indices(part, &cell, &mut faces);
            faces
        });
        let (vertices, indices) = (to_u32(count), to_u32(3 * grid.triangle_count()));
        mesh.patch_ranges.clear();
        mesh.patch_ranges
            .extend(part.clone().map(|patch| PatchRange {
                first_vertex: to_u32(patch) * vertices,
                vertices,
                first_index: to_u32(patch) * indices,
                indices,
            }));
    }

    /// The vertex indices of all cells: the indices of the first cell, in `cell`, shifted along the rows and the
    /// patches.
    fn fill_indices(&self, part: &Range<usize>, cell: &[usize], indices: &mut Indices) {
        let grid = self.grid;
        let total = part.len() * grid.segments_u * grid.segments_v * cell.len();
        let repeats = [
            (grid.segments_u, 1),
            (grid.segments_v, grid.segments_u + 1),
            (part.len(), grid.vertex_count()),
        ];
        if self.wide() {
            let mut list = match std::mem::take(indices) {
                Indices::U16(_) => Vec::new(),
                Indices::U32(list) => list,
            };
            list.resize(total, 0);
            for (location, &vertex) in list.iter_mut().zip(cell) {
                *location = to_u32(vertex);
            }
            fill_indices_u32(&mut list, cell.len(), repeats);
            *indices = Indices::U32(list);
        } else {
            let mut list = match std::mem::take(indices) {
                Indices::U16(list) => list,
                Indices::U32(_) => Vec::new(),
            };
            list.resize(total, 0);
            for (location, &vertex) in list.iter_mut().zip(cell) {
                *location = to_u16(vertex);
            }
            fill_indices_u16(&mut list, cell.len(), repeats);
            *indices = Indices::U16(list);
        }
    }
}

/// Converts a number below 2¹⁶; the caller guarantees the range.
fn to_u16(number: usize) -> u16 {
    u16::try_from(number).unwrap_or(u16::MAX)
}
