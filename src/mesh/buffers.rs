//! Vertex and index buffers of meshes.

use casteljau_kernels::mesh::layout::{lower_halves, push_vector, rounded};
use glam::DVec3;

/// The maximum number of vertices with 16-bit indices.
pub(crate) const MAX_U16_VERTICES: usize = 1 << 16;

/// A triangle mesh as plain buffers, ready for a GPU.
///
/// With `n` vertices and `t` triangles, `positions` and `normals` hold 3n numbers, `uvs` 2n, `patch_ids` n and
/// `indices` 3t. Triangles are counter-clockwise as seen from the side to which ∂u × ∂v points. `uvs` and `patch_ids`
/// are empty where patches share vertices. `T` is f32 or f64.
#[derive(Clone, Debug, Default, PartialEq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(rename_all = "camelCase")
)]
pub struct Mesh<T = f32> {
    /// x, y, z of each vertex.
    pub positions: Vec<T>,
    /// The unit normal of each vertex.
    pub normals: Vec<T>,
    /// The parameters u, v of each vertex in its patch.
    pub uvs: Vec<f32>,
    /// The index of the patch to which each vertex belongs.
    pub patch_ids: Vec<u32>,
    /// Three vertex indices per triangle.
    pub indices: Indices,
    /// Four vertex indices per quad, if requested.
    pub quads: Option<Indices>,
    /// The range of each patch in the buffers.
    pub patch_ranges: Vec<PatchRange>,
}

/// The part of a mesh that belongs to one patch.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(rename_all = "camelCase")
)]
pub struct PatchRange {
    /// Its first vertex.
    pub first_vertex: u32,
    /// Its number of vertices; 0 where patches share vertices.
    pub vertices: u32,
    /// The position of its first triangle in `indices`.
    pub first_index: u32,
    /// Its number of entries in `indices`, three per triangle.
    pub indices: u32,
}

/// Vertex indices in the smallest type that fits: 16 bits up to 65,536 vertices.
#[derive(Clone, Debug, PartialEq, Eq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(rename_all = "lowercase")
)]
pub enum Indices {
    /// Indices of a mesh with at most 65,536 vertices.
    U16(Vec<u16>),
    /// Indices of a larger mesh.
    U32(Vec<u32>),
}

impl<T> Mesh<T> {
    /// The number of vertices.
    pub fn vertex_count(&self) -> usize {
        self.positions.len() / 3
    }

    /// The number of triangles.
    pub fn triangle_count(&self) -> usize {
        self.indices.len() / 3
    }
}

impl Mesh {
    /// All vertices in one buffer, as a GPU reads them with one binding: for each one x, y, z, the normal, and u, v if the
    /// mesh has them. A vertex has 6 or 8 numbers, 24 or 32 bytes.
    pub fn interleaved(&self) -> Vec<f32> {
        let mut numbers =
            Vec::with_capacity(self.positions.len() + self.normals.len() + self.uvs.len());
        for vertex in 0..self.vertex_count() {
            for (list, size) in [(&self.positions, 3), (&self.normals, 3), (&self.uvs, 2)] {
                let start = size * vertex;
                numbers.extend_from_slice(list.get(start..start + size).unwrap_or_default());
            }
        }
        numbers
    }
}

impl Mesh<f64> {
    /// Clears all buffers and keeps their memory.
    pub(crate) fn clear(&mut self) {
        self.positions.clear();
        self.normals.clear();
        self.uvs.clear();
        self.patch_ids.clear();
        self.indices = Indices::default();
        self.quads = None;
        self.patch_ranges.clear();
    }

    /// Appends a vertex.
    pub(crate) fn push(&mut self, position: DVec3, normal: DVec3) {
        push_vector(&mut self.positions, position);
        push_vector(&mut self.normals, normal);
    }

    /// The same mesh in f32.
    pub fn to_f32(self) -> Mesh {
        Mesh {
            positions: rounded(&self.positions),
            normals: rounded(&self.normals),
            uvs: self.uvs,
            patch_ids: self.patch_ids,
            indices: self.indices,
            quads: self.quads,
            patch_ranges: self.patch_ranges,
        }
    }
}

impl Default for Indices {
    fn default() -> Self {
        Self::U16(Vec::new())
    }
}

impl Indices {
    /// Indices below `vertices`, in the smallest type that fits.
    pub(crate) fn smallest(numbers: Vec<u32>, vertices: usize) -> Self {
        if vertices > MAX_U16_VERTICES {
            return Self::U32(numbers);
        }
        Self::U16(lower_halves(&numbers))
    }

    /// The number of indices.
    pub fn len(&self) -> usize {
        match self {
            Self::U16(list) => list.len(),
            Self::U32(list) => list.len(),
        }
    }

    /// Whether there are no indices.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// The index at a position; `None` past the end.
    pub fn get(&self, index: usize) -> Option<usize> {
        match self {
            Self::U16(list) => list.get(index).map(|&i| usize::from(i)),
            Self::U32(list) => list.get(index).map(|&i| i as usize),
        }
    }

    /// The indices as bytes, the lowest one first, padded with zeros to a multiple of 4, as WebGPU demands of the size of a
    /// write.
    pub fn to_bytes(&self) -> Vec<u8> {
        let mut bytes: Vec<u8> = match self {
            Self::U16(list) => list.iter().flat_map(|index| index.to_le_bytes()).collect(),
            Self::U32(list) => list.iter().flat_map(|index| index.to_le_bytes()).collect(),
        };
        bytes.resize(bytes.len().next_multiple_of(4), 0);
        bytes
    }

    /// All indices in order.
    pub fn iter(&self) -> impl Iterator<Item = usize> {
        (0..self.len()).map_while(|index| self.get(index))
    }
}

/// The nearest f32.
#[allow(
    clippy::cast_possible_truncation,
    reason = "rounding to f32 is intended"
)]
#[inline(always)]
pub(crate) const fn to_f32(number: f64) -> f32 {
    number as f32
}
