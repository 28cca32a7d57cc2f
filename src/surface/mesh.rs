//! What is drawn: plain buffers.

/// A triangle mesh as plain data, ready for a graphics card.
///
/// With `n` vertices and `t` triangles: `positions` and `normals` hold 3n numbers, `uvs` 2n, `patch_ids` n, `indices`
/// 3t. Triangles run counter-clockwise as seen from the side that ∂u × ∂v points to.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Mesh {
    /// x, y, z of each vertex.
    pub positions: Vec<f32>,
    /// The unit normal of each vertex.
    pub normals: Vec<f32>,
    /// u, v of each vertex in its patch.
    pub uvs: Vec<f32>,
    /// The patch that each vertex belongs to.
    pub patch_ids: Vec<u32>,
    /// Three vertices per triangle.
    pub indices: Indices,
    /// Four vertices per face, where they were asked for.
    pub quads: Option<Indices>,
    /// Where each patch lies in the buffers.
    pub patch_ranges: Vec<PatchRange>,
}

/// The part of a mesh that one patch has filled.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct PatchRange {
    /// Its first vertex.
    pub first_vertex: u32,
    /// Its number of vertices.
    pub vertices: u32,
    /// Where its first triangle starts in `indices`.
    pub first_index: u32,
    /// Its number of entries in `indices`, three per triangle.
    pub indices: u32,
}

/// Vertex numbers in the smallest type that fits: 16 bits up to 65,536 vertices.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Indices {
    /// Of a mesh with at most 65,536 vertices.
    U16(Vec<u16>),
    /// Of a larger mesh.
    U32(Vec<u32>),
}

impl Mesh {
    /// The number of vertices.
    pub fn vertex_count(&self) -> usize {
        self.positions.len() / 3
    }

    /// The number of triangles.
    pub fn triangle_count(&self) -> usize {
        self.indices.len() / 3
    }
}

impl Default for Indices {
    fn default() -> Self {
        Self::U16(Vec::new())
    }
}

impl Indices {
    /// How many numbers there are.
    pub fn len(&self) -> usize {
        match self {
            Self::U16(list) => list.len(),
            Self::U32(list) => list.len(),
        }
    }

    /// Whether there are none.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// The number at a place; `None` past the end.
    pub fn get(&self, place: usize) -> Option<usize> {
        match self {
            Self::U16(list) => list.get(place).map(|&i| usize::from(i)),
            Self::U32(list) => list.get(place).map(|&i| i as usize),
        }
    }

    /// All numbers in turn.
    pub fn iter(&self) -> impl Iterator<Item = usize> {
        (0..self.len()).map_while(|place| self.get(place))
    }
}
