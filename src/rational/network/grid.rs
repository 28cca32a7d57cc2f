//! Grids of rational patches.
//!
//! Positions come from the homogeneous control points themselves, so that edges with the same points and weights have the same
//! samples bit for bit; normals come from differences in scaled coordinates.

use super::RationalSurface;
use super::mesh::{Normals, differences_u, differences_v};
use crate::geometry::error::Error;
use crate::mesh::buffers::to_f32;
use crate::mesh::generic_grid_evaluator::{GridWeights, blend, prepare, round};
use crate::mesh::grid_mesh::GridMeshBuilder;
use crate::mesh::{Grid, GridMethod, Mesh};
use crate::rational::patch::RationalPatch;
use crate::rational::weighted::Homogeneous;
use casteljau_kernels::mesh::row_sampler::directions;
use glam::DVec3;
use std::ops::Range;
#[cfg(feature = "rayon")]
use {crate::parallel::has_cores, rayon::prelude::*};

impl RationalSurface {
    /// A mesh of one grid per patch; each patch has its own vertices, also along shared edges.
    ///
    /// Positions are within 4 f32 ulps of the largest coordinate, and bit-identical along edges that have the same points and
    /// weights. Normals and quads are those of [`Surface::grid`](crate::Surface::grid).
    ///
    /// # Errors
    /// As [`Surface::grid`](crate::Surface::grid).
    pub fn grid(&self, grid: Grid, quads: bool) -> Result<Mesh, Error> {
        let mut mesh = Mesh::default();
        self.grid_into(grid, quads, &mut mesh)?;
        Ok(mesh)
    }

    /// As [`grid`](Self::grid), into an existing mesh whose buffers are reused where they are large enough.
    ///
    /// # Errors
    /// As `grid`; the mesh is then unchanged.
    pub fn grid_into(&self, grid: Grid, quads: bool, mesh: &mut Mesh) -> Result<(), Error> {
        let all = 0..self.patch_count();
        let builder = GridMeshBuilder::new(all.len(), grid, GridMethod::Bernstein, quads)?;
        self.fill_part(&builder, all, false, mesh);
        Ok(())
    }

    /// Fills a mesh with the grids of some patches; see [`GridMeshBuilder::fill`].
    pub(crate) fn fill_part(
        &self,
        builder: &GridMeshBuilder,
        part: Range<usize>,
        has_layout: bool,
        mesh: &mut Mesh,
    ) {
        builder.prepare(&part, has_layout, mesh);
        let count = builder.grid.vertex_count();
        let fill = |evaluator: &mut RationalGrid, k: usize, positions: &mut [f32], normals| {
            if let Some(patch) = self.patch(part.start + k) {
                evaluator.fill(patch, positions, normals);
            }
        };
        #[cfg(feature = "rayon")]
        if has_cores() {
            let positions = mesh.positions.par_chunks_exact_mut(3 * count);
            let vertices = positions.zip(mesh.normals.par_chunks_exact_mut(3 * count));
            vertices.enumerate().for_each_init(
                || RationalGrid::new(builder.grid),
                |evaluator, (k, (positions, normals))| fill(evaluator, k, positions, normals),
            );
            return;
        }
        let mut evaluator = RationalGrid::new(builder.grid);
        let positions = mesh.positions.chunks_exact_mut(3 * count);
        let vertices = positions.zip(mesh.normals.chunks_exact_mut(3 * count));
        for (k, (positions, normals)) in vertices.enumerate() {
            fill(&mut evaluator, k, positions, normals);
        }
    }
}

/// Evaluates rational patches on one grid; reuses the weights while the degrees stay the same.
struct RationalGrid {
    grid: Grid,
    /// Bernstein weights along u and along v, each for the degree and for the degree of the derivative.
    u: [GridWeights; 2],
    v: [GridWeights; 2],
    /// The points and the differences along u and v, blended at one v.
    row: [Vec<Homogeneous<DVec3>>; 3],
}

impl RationalGrid {
    fn new(grid: Grid) -> Self {
        Self {
            grid,
            u: Default::default(),
            v: Default::default(),
            row: Default::default(),
        }
    }

    fn fill(&mut self, patch: RationalPatch, positions: &mut [f32], normals: &mut [f32]) {
        prepare(&mut self.u, patch.degree_u(), self.grid.segments_u);
        prepare(&mut self.v, patch.degree_v(), self.grid.segments_v);
        let columns = patch.degree_u() + 1;
        let net = patch.homogeneous(DVec3::ZERO);
        let mut finder = Normals::new(patch);
        let scaled = finder.patch.scaled(&finder.frame);
        let (du, dv) = (
            differences_u(&scaled, columns),
            differences_v(&scaled, columns),
        );
        let vertices = positions.as_chunks_mut().0.iter_mut();
        let mut vertices = vertices.zip(normals.as_chunks_mut().0);
        for iv in 0..=self.grid.segments_v {
            let ([values, slopes], [points, along_u, along_v]) = (&self.v, &mut self.row);
            values.blend_rows(iv, &net, columns, points);
            values.blend_rows(iv, &du, columns - 1, along_u);
            slopes.blend_rows(iv, &dv, columns, along_v);
            let [values, slopes] = &self.u;
            for (iu, (position, normal)) in (0..=self.grid.segments_u).zip(vertices.by_ref()) {
                let (values, slopes) = (values.at(iu), slopes.at(iu));
                let homogeneous = blend(values, points);
                let point = homogeneous.point();
                let sums = [blend(slopes, along_u), blend(values, along_v)]
                    .map(|sum| sum.vector.extend(sum.weight).to_array());
                let (u, v) = self.grid.uv(iu, iv);
                let local = finder.frame.local_point(point);
                let along = directions(local, homogeneous.weight, sums, [u, v]);
                *position = round(point);
                *normal = finder.normal(along, [u, v]).to_array().map(to_f32);
            }
        }
    }
}
