//! Positions and normals of patches on a grid.
//!
//! Bicubic patches, the most common ones, have an evaluator of their own, [`BicubicGrid`].
//! All others, and the method of forward differences, use [`GenericGridEvaluator`]. Both leave a normal at zero where
//! ∂u × ∂v vanishes; such normals are then computed from the normal net.

use super::buffers::to_f32;
use super::generic_grid_evaluator::GenericGridEvaluator;
use super::grid::{Grid, GridMethod};
use crate::patch::normal::NormalNet;
use crate::patch::tensor_product::directions;
use casteljau_kernels::mesh::bicubic::grid::BicubicGrid;
use glam::DVec3;

/// Evaluates patches on one grid; weights and buffers are reused from patch to patch.
pub(crate) struct GridEvaluator {
    grid: Grid,
    method: GridMethod,
    bicubic: Option<BicubicGrid>,
    general: Option<GenericGridEvaluator>,
}

impl GridEvaluator {
    pub(crate) fn new(grid: Grid, method: GridMethod) -> Self {
        Self {
            grid,
            method,
            bicubic: None,
            general: None,
        }
    }

    /// Fills the buffers of one patch; the length of each is three times the number of vertices of the grid.
    pub(crate) fn fill(
        &mut self,
        net: &[DVec3],
        degree_u: usize,
        degree_v: usize,
        positions: &mut [f32],
        normals: &mut [f32],
    ) {
        let (grid, method) = (self.grid, self.method);
        let (positions, normals) = (positions.as_chunks_mut().0, normals.as_chunks_mut().0);
        let missing = if let (GridMethod::Bernstein, Some(net)) = (method, bicubic(net, degree_u)) {
            self.bicubic
                .get_or_insert_with(|| BicubicGrid::new(grid.segments_u, grid.segments_v))
                .fill(&net, positions, normals)
        } else {
            self.general
                .get_or_insert_with(|| GenericGridEvaluator::new(grid, method))
                .fill(net, degree_u, degree_v, positions, normals)
        };
        if missing {
            self.repair(net, degree_u, degree_v, normals);
        }
    }

    /// Replaces missing normals by their limits.
    #[cold]
    fn repair(&self, net: &[DVec3], degree_u: usize, degree_v: usize, normals: &mut [[f32; 3]]) {
        let (du, dv) = directions(net, degree_u + 1);
        let limits = NormalNet::new(&du, &dv, degree_u, degree_v);
        if limits.vanishes() {
            return;
        }
        let columns = self.grid.segments_u + 1;
        for (vertex, normal) in normals.iter_mut().enumerate() {
            if *normal == [0.0; 3] {
                let (u, v) = self.grid.uv(vertex % columns, vertex / columns);
                *normal = limits.limit(u, v).to_array().map(to_f32);
            }
        }
    }
}

/// The net of a bicubic patch whose coordinates fit into f32; `None` for other patches.
fn bicubic(net: &[DVec3], degree_u: usize) -> Option<[[f64; 3]; 16]> {
    let points = <[DVec3; 16]>::try_from(net).ok()?.map(|p| p.to_array());
    (degree_u == 3 && BicubicGrid::fits(&points)).then_some(points)
}
