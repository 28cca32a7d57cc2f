//! Filling a mesh: one grid per patch.

use super::kernel::Kernel;
use super::{Grid, GridMethod, Indices, Mesh, PatchRange};
use crate::error::Error;
use casteljau_kernels::{fill_indices_u16, fill_indices_u32, fill_patch_ids, fill_uvs};
use glam::DVec3;

/// The most vertices that 16 bits can number.
pub(super) const MAX_U16_VERTICES: usize = 1 << 16;

/// What a grid is asked for.
pub(crate) struct Wanted {
    pub(crate) grid: Grid,
    pub(crate) method: GridMethod,
    pub(crate) quads: bool,
    /// The mesh holds a grid of the same counts already, so that all that depends on them only can stay.
    pub(crate) has_layout: bool,
}

/// Fills `mesh` with one grid for each of `patches` patches; `net_of` hands out their nets and degrees in u and v.
///
/// Buffers that are large enough are reused, all others grow.
pub(super) fn fill_mesh(
    patches: usize,
    net_of: impl Fn(usize, &mut Vec<DVec3>) -> (usize, usize),
    wanted: &Wanted,
    mesh: &mut Mesh,
) -> Result<(), Error> {
    let grid = wanted.grid;
    grid.check(patches)?;
    if !wanted.has_layout {
        fill_layout(patches, grid, wanted.quads, mesh);
    }
    let numbers = 3 * grid.vertex_count();
    mesh.positions.resize(patches * numbers, 0.0);
    mesh.normals.resize(patches * numbers, 0.0);
    let mut kernel = Kernel::new(grid, wanted.method);
    let mut net = Vec::new();
    let parts = mesh
        .positions
        .chunks_exact_mut(numbers)
        .zip(mesh.normals.chunks_exact_mut(numbers));
    for (patch, (positions, normals)) in parts.enumerate() {
        net.clear();
        let (degree_u, degree_v) = net_of(patch, &mut net);
        kernel.fill(&net, degree_u, degree_v, positions, normals);
    }
    Ok(())
}

/// Everything that depends on counts only.
fn fill_layout(patches: usize, grid: Grid, quads: bool, mesh: &mut Mesh) {
    let count = grid.vertex_count();
    mesh.uvs.resize(2 * patches * count, 0.0);
    fill_uvs(grid.segments_u, grid.segments_v, &mut mesh.uvs);
    mesh.patch_ids.resize(patches * count, 0);
    fill_patch_ids(count, &mut mesh.patch_ids);
    let [a, b, c, d] = grid.quad(0, 0);
    fill_indices(patches, grid, &[a, b, c, a, c, d], &mut mesh.indices);
    mesh.quads = quads.then(|| {
        let mut faces = mesh.quads.take().unwrap_or_default();
        fill_indices(patches, grid, &[a, b, c, d], &mut faces);
        faces
    });
    let (vertices, indices) = (to_u32(count), to_u32(3 * grid.triangle_count()));
    mesh.patch_ranges.clear();
    mesh.patch_ranges
        .extend((0..to_u32(patches)).map(|patch| PatchRange {
            first_vertex: patch * vertices,
            vertices,
            first_index: patch * indices,
            indices,
        }));
}

/// The vertex numbers of all cells: those of the cell at (0, 0), in `cell`, moved along the rows and the patches.
fn fill_indices(patches: usize, grid: Grid, cell: &[usize], indices: &mut Indices) {
    let count = grid.vertex_count();
    let total = patches * grid.segments_u * grid.segments_v * cell.len();
    let repeats = [
        (grid.segments_u, 1),
        (grid.segments_v, grid.segments_u + 1),
        (patches, count),
    ];
    if patches * count <= MAX_U16_VERTICES {
        let mut list = match std::mem::take(indices) {
            Indices::U16(list) => list,
            Indices::U32(_) => Vec::new(),
        };
        list.resize(total, 0);
        for (place, &vertex) in list.iter_mut().zip(cell) {
            *place = to_u16(vertex);
        }
        fill_indices_u16(&mut list, cell.len(), repeats);
        *indices = Indices::U16(list);
    } else {
        let mut list = match std::mem::take(indices) {
            Indices::U16(_) => Vec::new(),
            Indices::U32(list) => list,
        };
        list.resize(total, 0);
        for (place, &vertex) in list.iter_mut().zip(cell) {
            *place = to_u32(vertex);
        }
        fill_indices_u32(&mut list, cell.len(), repeats);
        *indices = Indices::U32(list);
    }
}

/// A number below 2¹⁶; the caller has counted.
fn to_u16(number: usize) -> u16 {
    u16::try_from(number).unwrap_or(u16::MAX)
}

/// A number below 2³²: a mesh of 1 GiB has fewer vertices and indices.
fn to_u32(number: usize) -> u32 {
    u32::try_from(number).unwrap_or(u32::MAX)
}

/// The nearest f32.
#[allow(
    clippy::cast_possible_truncation,
    reason = "rounding to f32 is what meshes are for"
)]
#[inline(always)]
pub(super) const fn to_f32(number: f64) -> f32 {
    number as f32
}
