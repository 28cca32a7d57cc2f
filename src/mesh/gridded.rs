//! Meshes of patches and surfaces on uniform grids.

use super::Mesh;
use super::grid::{Grid, GridMethod};
use super::grid_mesh::GridMeshBuilder;
use crate::geometry::error::Error;
use crate::patch::Patch;
use crate::surface::network::Surface;
use casteljau_kernels::mesh::layout::collect_points;
use glam::DVec3;
use std::ops::Range;

impl Surface {
    /// A mesh of one grid per patch; each patch has its own vertices, also along shared edges.
    ///
    /// Positions are exact at corners, bit-identical along shared edges and within 4 f32 ulps of the largest coordinate
    /// elsewhere. Normals have the length 1 and point within 0.001° of ∂u × ∂v; they are limits at collapsed edges, and
    /// zero for a patch that is a curve or a point. With `quads` the mesh also lists quads.
    ///
    /// # Errors
    /// [`Error::Range`] for 0 segments, [`Error::TooMany`] when the mesh would take more than 1 GiB.
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
        self.grid_by(GridMethod::Bernstein, grid, quads, mesh)
    }

    /// As [`grid_into`](Self::grid_into), by either method.
    ///
    /// With [`GridMethod::ForwardDifference`] corners are exact too, but edges are not bit-identical, and on grids with
    /// very many segments positions may be off by more than 4 ulps.
    ///
    /// # Errors
    /// As `grid`; the mesh is then unchanged.
    pub fn grid_by(
        &self,
        method: GridMethod,
        grid: Grid,
        quads: bool,
        mesh: &mut Mesh,
    ) -> Result<(), Error> {
        let all = 0..self.patch_count();
        let mut builder = GridMeshBuilder::new(all.len(), grid, method, quads)?;
        self.fill_part(&mut builder, all, false, mesh);
        Ok(())
    }

    /// Fills a mesh with the grids of some patches; see [`GridMeshBuilder::fill`].
    pub(crate) fn fill_part(
        &self,
        builder: &mut GridMeshBuilder,
        part: Range<usize>,
        has_layout: bool,
        mesh: &mut Mesh,
    ) {
        let net_of = |patch: usize, net: &mut Vec<DVec3>| {
            let indices = self.patch_indices(patch).unwrap_or_default();
            net.resize(indices.len(), DVec3::ZERO);
            collect_points(self.vertices(), indices, net);
            let [degree_u, degree_v] = self.degrees(patch).unwrap_or_default();
            (degree_u, degree_v)
        };
        builder.fill(part, net_of, has_layout, mesh);
    }
}

impl Patch {
    /// A mesh of one grid over the patch; see [`Surface::grid`].
    ///
    /// # Errors
    /// As `Surface::grid`.
    pub fn grid(&self, grid: Grid, quads: bool) -> Result<Mesh, Error> {
        let mut mesh = Mesh::default();
        self.grid_into(grid, quads, &mut mesh)?;
        Ok(mesh)
    }

    /// As [`grid`](Self::grid), into an existing mesh.
    ///
    /// # Errors
    /// As `grid`; the mesh is then unchanged.
    pub fn grid_into(&self, grid: Grid, quads: bool, mesh: &mut Mesh) -> Result<(), Error> {
        self.grid_by(GridMethod::Bernstein, grid, quads, mesh)
    }

    /// As [`grid_into`](Self::grid_into), by either method; see [`Surface::grid_by`].
    ///
    /// # Errors
    /// As `grid`; the mesh is then unchanged.
    pub fn grid_by(
        &self,
        method: GridMethod,
        grid: Grid,
        quads: bool,
        mesh: &mut Mesh,
    ) -> Result<(), Error> {
        let net_of = |_: usize, net: &mut Vec<DVec3>| {
            net.extend_from_slice(&self.points);
            (self.degree_u(), self.degree_v())
        };
        GridMeshBuilder::new(1, grid, method, quads)?.fill(0..1, net_of, false, mesh);
        Ok(())
    }
}
