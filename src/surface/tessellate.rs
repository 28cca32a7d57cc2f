//! Filling a mesh: one grid per patch.

use super::kernel::Kernel;
use super::{Grid, Indices, Mesh, PatchRange};
use crate::error::Error;
use glam::DVec3;

/// The most vertices that 16 bits can number.
pub(super) const MAX_U16_VERTICES: usize = 1 << 16;

/// Fills `mesh` with one grid for each of `patches` patches; `net_of` hands out their nets and degrees in u and v.
///
/// Buffers that are large enough are reused, all others grow.
pub(super) fn fill_mesh(
    patches: usize,
    net_of: impl Fn(usize, &mut Vec<DVec3>) -> (usize, usize),
    grid: Grid,
    quads: bool,
    mesh: &mut Mesh,
) -> Result<(), Error> {
    grid.check(patches)?;
    fill_layout(patches, grid, quads, mesh);
    let numbers = 3 * grid.vertex_count();
    mesh.positions.resize(patches * numbers, 0.0);
    mesh.normals.resize(patches * numbers, 0.0);
    let mut kernel = Kernel::new(grid);
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
    fill_uvs(patches, grid, &mut mesh.uvs);
    mesh.patch_ids.resize(patches * count, 0);
    for (id, part) in (0..).zip(mesh.patch_ids.chunks_exact_mut(count)) {
        part.fill(id);
    }
    let [a, b, c, d] = grid.quad(0, 0);
    fill_indices(patches, grid, [a, b, c, a, c, d], &mut mesh.indices);
    mesh.quads = quads.then(|| {
        let mut faces = mesh.quads.take().unwrap_or_default();
        fill_indices(patches, grid, [a, b, c, d], &mut faces);
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

/// The same (u, v) for every patch.
fn fill_uvs(patches: usize, grid: Grid, uvs: &mut Vec<f32>) {
    let numbers = 2 * grid.vertex_count();
    uvs.resize(patches * numbers, 0.0);
    let mut parts = uvs.chunks_exact_mut(numbers);
    let Some(first) = parts.next() else { return };
    let row = 2 * (grid.segments_u + 1);
    for (iv, line) in first.chunks_exact_mut(row).enumerate() {
        for (iu, pair) in line.chunks_exact_mut(2).enumerate() {
            let (u, v) = grid.uv(iu, iv);
            pair.copy_from_slice(&[to_f32(u), to_f32(v)]);
        }
    }
    for part in parts {
        part.copy_from_slice(first);
    }
}

/// The vertex numbers of all cells: those of the cell at (0, 0), in the `cell`, moved along the rows and the patches.
fn fill_indices<const N: usize>(
    patches: usize,
    grid: Grid,
    cell: [usize; N],
    indices: &mut Indices,
) {
    let count = grid.vertex_count();
    if patches * count <= MAX_U16_VERTICES {
        let mut list = match std::mem::take(indices) {
            Indices::U16(list) => list,
            Indices::U32(_) => Vec::new(),
        };
        fill_list(patches, grid, cell, &mut list, to_u16, u16::wrapping_add);
        *indices = Indices::U16(list);
    } else {
        let mut list = match std::mem::take(indices) {
            Indices::U16(_) => Vec::new(),
            Indices::U32(list) => list,
        };
        fill_list(patches, grid, cell, &mut list, to_u32, u32::wrapping_add);
        *indices = Indices::U32(list);
    }
}

/// [`fill_indices`] for one type of numbers.
fn fill_list<T: Copy, const N: usize>(
    patches: usize,
    grid: Grid,
    cell: [usize; N],
    list: &mut Vec<T>,
    number: impl Fn(usize) -> T,
    add: impl Fn(T, T) -> T,
) {
    list.clear();
    list.extend(cell.map(&number));
    repeat(list, grid.segments_u, number(1), &add);
    repeat(list, grid.segments_v, number(grid.segments_u + 1), &add);
    repeat(list, patches, number(grid.vertex_count()), &add);
}

/// Repeats the list `times` in all, each time with numbers `step` higher than before.
fn repeat<T: Copy>(list: &mut Vec<T>, times: usize, step: T, add: impl Fn(T, T) -> T) {
    let count = list.len();
    list.reserve_exact(count * times.saturating_sub(1));
    for copy in 1..times {
        list.extend_from_within((copy - 1) * count..);
        for index in &mut list[copy * count..] {
            *index = add(*index, step);
        }
    }
    list.truncate(count * times);
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
