//! Welding: which corners of triangles become one vertex.

use super::buffers::to_f32;
use super::options::Weld;
use super::stitched_mesh::StitchedMesh;
use super::{Indices, Mesh, PatchRange};
use crate::geometry::point::Point;
use casteljau_kernels::numeric::order::to_u32;
use glam::DVec3;

/// The square of the chord of 0.1°: normals that differ by less share a vertex.
const SAME_NORMAL_SQUARED: f64 = 3.046_174e-6;

/// The maximum number of normals that are compared at one node, the latest first. Where thousands of patches meet in a
/// point, comparing each with all others would take too long; some equal normals may then stay separate.
const MAX_COMPARED: usize = 256;

/// Marks a node or a corner without a vertex.
const NONE: u32 = u32::MAX;

/// A vertex: a node and its normal.
struct WeldedVertex {
    node: u32,
    normal: DVec3,
    /// The previous vertex of the same node.
    before: u32,
}

/// Numbers vertices in the order in which triangles use them.
struct Welder<'a> {
    stitched_mesh: &'a StitchedMesh,
    vertices: Vec<WeldedVertex>,
    /// The last vertex of each node.
    last: Vec<u32>,
    /// The vertex of each corner.
    of_corner: Vec<u32>,
}

impl StitchedMesh {
    /// Writes the mesh with vertices shared according to the rule.
    pub(crate) fn weld(&self, weld: Weld, mesh: &mut Mesh<f64>) {
        mesh.clear();
        if weld == Weld::None {
            self.keep_corners(mesh);
            return;
        }
        let mut welder = Welder {
            stitched_mesh: self,
            vertices: Vec::new(),
            last: vec![NONE; self.nodes.len()],
            of_corner: vec![NONE; self.corners.len()],
        };
        let mut numbers = self.triangles.as_flattened().to_vec();
        for number in &mut numbers {
            *number = welder.vertex(*number, weld);
        }
        if weld == Weld::Position {
            welder.average_normals(&numbers);
        }
        for vertex in &welder.vertices {
            mesh.push(self.nodes[vertex.node as usize], vertex.normal);
        }
        mesh.indices = Indices::smallest(numbers, welder.vertices.len());
        self.fill_ranges(mesh, false);
    }

    /// Writes the mesh with one vertex for each corner.
    fn keep_corners(&self, mesh: &mut Mesh<f64>) {
        for corner in &self.corners {
            mesh.push(self.nodes[corner.node as usize], corner.normal);
            mesh.uvs.extend([to_f32(corner.u), to_f32(corner.v)]);
        }
        let mut from = 0;
        for (patch, end) in self.ends.iter().enumerate() {
            let ids = std::iter::repeat_n(to_u32(patch), end.corners - from);
            mesh.patch_ids.extend(ids);
            from = end.corners;
        }
        let numbers = self.triangles.as_flattened().to_vec();
        mesh.indices = Indices::smallest(numbers, self.corners.len());
        self.fill_ranges(mesh, true);
    }

    /// The triangles of a patch are always contiguous; its vertices are contiguous only if they belong to this patch
    /// alone.
    fn fill_ranges(&self, mesh: &mut Mesh<f64>, own_vertices: bool) {
        let (mut corners, mut triangles) = (0, 0);
        for end in &self.ends {
            let mut range = PatchRange {
                first_index: to_u32(3 * triangles),
                indices: to_u32(3 * (end.triangles - triangles)),
                ..PatchRange::default()
            };
            if own_vertices {
                range.first_vertex = to_u32(corners);
                range.vertices = to_u32(end.corners - corners);
            }
            mesh.patch_ranges.push(range);
            (corners, triangles) = (end.corners, end.triangles);
        }
    }
}

impl Welder<'_> {
    fn vertex(&mut self, corner: u32, weld: Weld) -> u32 {
        let known = self.of_corner[corner as usize];
        if known != NONE {
            return known;
        }
        let vertex = self.shared_vertex(corner, weld);
        self.of_corner[corner as usize] = vertex;
        vertex
    }

    /// The vertex of the corner's node that can be its vertex too, or a new one.
    fn shared_vertex(&mut self, corner: u32, weld: Weld) -> u32 {
        let corner = &self.stitched_mesh.corners[corner as usize];
        // The vertices of a node are a linked list, the latest first. NONE ends it, because it is no index.
        let last = self.last[corner.node as usize];
        let mut found = last;
        for _ in 0..MAX_COMPARED {
            let Some(vertex) = self.vertices.get(found as usize) else {
                break;
            };
            let apart = vertex.normal - corner.normal;
            if weld == Weld::Position || apart.length_squared() <= SAME_NORMAL_SQUARED {
                return found;
            }
            found = vertex.before;
        }
        self.vertices.push(WeldedVertex {
            node: corner.node,
            normal: corner.normal,
            before: last,
        });
        let new = to_u32(self.vertices.len() - 1);
        self.last[corner.node as usize] = new;
        new
    }

    /// Replaces normals by the mean of the normals of their corners, weighted by the angles of the triangles. So the mean
    /// does not depend on how a face is divided into triangles. Source: Thürmer and Wüthrich, "Computing vertex normals
    /// from polygonal facets", Journal of Graphics Tools 3 (1998).
    fn average_normals(&mut self, numbers: &[u32]) {
        let mut sums = vec![DVec3::ZERO; self.vertices.len()];
        let corners = self.stitched_mesh.triangles.as_flattened();
        for (triangle, corners) in numbers.chunks_exact(3).zip(corners.chunks_exact(3)) {
            let point = |k: usize| {
                let vertex = &self.vertices[triangle[k % 3] as usize];
                self.stitched_mesh.nodes[vertex.node as usize]
            };
            for (k, &corner) in corners.iter().enumerate() {
                let (a, b) = (point(k + 1) - point(k), point(k + 2) - point(k));
                let normal = self.stitched_mesh.corners[corner as usize].normal;
                sums[triangle[k] as usize] += normal * angle(Point::unit(a), Point::unit(b));
            }
        }
        for (vertex, sum) in self.vertices.iter_mut().zip(sums) {
            // If the normals cancel, the first one is kept.
            let mean = Point::unit(sum);
            if mean != DVec3::ZERO {
                vertex.normal = mean;
            }
        }
    }
}

/// The angle between unit vectors, also accurate for small angles: 2·atan(|a − b| / |a + b|) (Kahan).
fn angle(a: DVec3, b: DVec3) -> f64 {
    2.0 * Point::norm(a - b).atan2(Point::norm(a + b))
}
