//! Checks of every mesh of a surface.

use super::limits::{MAX_DEGREES, limit};
use super::shapes::{SIDES, along, diagonal, largest, meshed};
use super::soup::{Soup, vectors};
use casteljau::glam::DVec3;
use casteljau::mesh::{Indices, TessellationOptions, Weld};
use casteljau::{Mesh, Patch, Surface};
use std::collections::HashSet;

/// The three meshes of one surface, one for each welding rule.
pub(crate) struct Three {
    pub(crate) own: Mesh,
    pub(crate) normal: Mesh,
    pub(crate) position: Mesh,
}

impl Three {
    pub(crate) fn new(surface: &Surface, options: &TessellationOptions) -> Self {
        let of = |weld| meshed(surface, *options, weld);
        Self {
            own: of(Weld::None),
            normal: of(Weld::Normal),
            position: of(Weld::Position),
        }
    }

    /// Checks everything that holds for every surface, watertight or not.
    pub(crate) fn assert_alike(&self, patches: usize) {
        for mesh in [&self.own, &self.normal, &self.position] {
            assert_layout(mesh, patches);
        }
        let bits = |mesh: &Mesh| -> Vec<u32> {
            let corners = mesh.indices.iter();
            let numbers = corners.flat_map(|vertex| &mesh.positions[3 * vertex..][..3]);
            numbers.map(|x| x.to_bits()).collect()
        };
        let ranges = |mesh: &Mesh| -> Vec<[u32; 2]> {
            let ranges = mesh.patch_ranges.iter();
            ranges.map(|r| [r.first_index, r.indices]).collect()
        };
        for (mesh, weld) in [(&self.normal, "normal"), (&self.position, "position")] {
            assert!(bits(mesh) == bits(&self.own), "{weld} moves positions");
            assert!(ranges(mesh) == ranges(&self.own), "{weld} changes ranges");
        }
        self.assert_normals_shared();
    }

    /// Corners share a vertex with weld "normal" only if their normals differ by at most 0.1°.
    fn assert_normals_shared(&self) {
        let own: Vec<DVec3> = vectors(&self.own.normals).collect();
        let shared: Vec<DVec3> = vectors(&self.normal.normals).collect();
        for (a, b) in self.own.indices.iter().zip(self.normal.indices.iter()) {
            let degrees = degrees_between(own[a], shared[b]);
            assert!(degrees < 0.100_1, "a corner's normal is {degrees}° off");
        }
    }
}

/// Checks the sizes and numbers of the buffers.
pub(crate) fn assert_layout<T: Copy + Into<f64>>(mesh: &Mesh<T>, patches: usize) {
    let vertices = mesh.vertex_count();
    assert_eq!(mesh.positions.len(), 3 * vertices);
    assert_eq!(mesh.normals.len(), 3 * vertices);
    assert_eq!(matches!(mesh.indices, Indices::U16(_)), vertices <= 65_536);
    assert!(mesh.quads.is_none());
    let mut used = vec![false; vertices];
    mesh.indices.iter().for_each(|index| used[index] = true);
    let own = !mesh.patch_ids.is_empty();
    assert!(own || !used.contains(&false), "a vertex without triangles");
    assert_eq!(mesh.uvs.len(), if own { 2 * vertices } else { 0 });
    for numbers in [&mesh.positions, &mesh.normals] {
        assert!(numbers.iter().all(|&x| x.into().is_finite()));
    }
    for length in vectors(&mesh.normals).map(|normal| normal.length()) {
        assert!((length - 1.0).abs() < 1e-6, "a normal of length {length}");
    }
    assert_ranges(mesh, patches, own);
}

/// Checks that ranges are contiguous, cover everything, and belong to their patches.
fn assert_ranges<T>(mesh: &Mesh<T>, patches: usize, own: bool) {
    assert_eq!(mesh.patch_ranges.len(), patches);
    let indices: Vec<usize> = mesh.indices.iter().collect();
    let (mut vertex, mut index) = (0, 0);
    for (patch, range) in mesh.patch_ranges.iter().enumerate() {
        let (first_vertex, vertices) = (range.first_vertex as usize, range.vertices as usize);
        let (first_index, count) = (range.first_index as usize, range.indices as usize);
        assert_eq!(first_index, index);
        index += count;
        if !own {
            assert_eq!((first_vertex, vertices), (0, 0));
            continue;
        }
        assert_eq!(first_vertex, vertex);
        vertex += vertices;
        let ids = &mesh.patch_ids[first_vertex..vertex];
        assert!(ids.iter().all(|&id| id as usize == patch));
        let inside = &indices[first_index..index];
        assert!(inside.iter().all(|&i| (first_vertex..vertex).contains(&i)));
    }
    assert_eq!(index, indices.len());
    assert!(!own || vertex == mesh.vertex_count());
}

/// Checks that each vertex is at the point of its patch at its u and v, up to rounding, with the patch's normal.
///
/// `parameter` returns the f64 for an f32 of `uvs`.
pub(crate) fn assert_on_surface(surface: &Surface, mesh: &Mesh, parameter: impl Fn(f32) -> f64) {
    let patches: Vec<Patch> = surface.patches().collect();
    let slack = largest(surface) * 1e-14;
    let locations = vectors(&mesh.positions).zip(vectors(&mesh.normals));
    for ((k, uv), (p, normal)) in mesh.uvs.as_chunks().0.iter().enumerate().zip(locations) {
        let patch = &patches[mesh.patch_ids[k] as usize];
        let [u, v] = uv.map(&parameter);
        let exact = patch.eval(u, v);
        for axis in 0..3 {
            // Half an f32 ulp; for numbers just above a power of two the larger ulp.
            let max = exact[axis].abs() * f64::from(f32::EPSILON) / 2.0 + slack;
            let off = (p[axis] - exact[axis]).abs();
            assert!(off <= max, "a vertex off at {uv:?}: {p} for {exact}");
        }
        let expected = limit(patch, u, v).expect("patches that are curves have no vertices");
        let degrees = degrees_between(normal, expected);
        assert!(degrees < MAX_DEGREES, "{uv:?}: a normal off by {degrees}°");
    }
}

/// Checks that every normal with weld "normal" is the normal of a patch at the vertex's position.
pub(crate) fn assert_normals_of_patches(three: &Three) {
    let soup = Soup::new(&three.own);
    let key = |p: DVec3, normal: DVec3| [p + 0.0, normal].map(|v| v.to_array().map(f64::to_bits));
    let locations = soup.position_of.iter();
    let locations = locations.map(|&location| soup.points[location as usize]);
    let own = locations.zip(vectors(&three.own.normals));
    let known: HashSet<_> = own.map(|(p, normal)| key(p, normal)).collect();
    let welded = vectors(&three.normal.positions).zip(vectors(&three.normal.normals));
    for (p, normal) in welded {
        assert!(known.contains(&key(p, normal)), "no normal at {p}");
    }
}

/// Checks that no edge inside the surface is open or has more than two triangles; edges with one triangle lie on open
/// patch edges.
pub(crate) fn assert_watertight(surface: &Surface, mesh: &Mesh, sheets: u32) -> usize {
    assert!(!mesh.uvs.is_empty(), "for meshes with uvs");
    let soup = Soup::new(mesh);
    soup.assert_no_collapsed_triangle();
    let open = surface.topology().open.into_iter();
    let open: HashSet<(usize, usize)> = open.map(|s| (s.patch, s.edge as usize)).collect();
    let boundary: HashSet<(u32, u32)> = soup.boundary(sheets).into_iter().collect();
    let mut on_open_sides = 0;
    for (locations, corners) in soup.triangles.iter().zip(&soup.corners) {
        for k in 0..3 {
            let (a, b) = (locations[k], locations[(k + 1) % 3]);
            if boundary.contains(&(a, b)) {
                let ends = [corners[k], corners[(k + 1) % 3]];
                let location = soup.points[a as usize];
                assert!(on_side_of(mesh, ends, &open), "open at {location}");
                on_open_sides += 1;
            }
        }
    }
    assert_eq!(on_open_sides, boundary.len());
    on_open_sides
}

fn on_side_of(mesh: &Mesh, ends: [usize; 2], sides: &HashSet<(usize, usize)>) -> bool {
    let uv = ends.map(|k| [f64::from(mesh.uvs[2 * k]), f64::from(mesh.uvs[2 * k + 1])]);
    let patch = mesh.patch_ids[ends[0]] as usize;
    SIDES.iter().any(|&side| {
        sides.contains(&(patch, side as usize)) && uv.iter().all(|&uv| along(side, uv).is_some())
    })
}

/// The angle in degrees, also accurate for small angles.
pub(crate) fn degrees_between(a: DVec3, b: DVec3) -> f64 {
    (2.0 * (a - b).length().atan2((a + b).length())).to_degrees()
}

/// Tolerances from 1e-1 of the diagonal down, three per decade.
pub(crate) fn tolerances(surface: &Surface, count: i32) -> impl Iterator<Item = f64> {
    let size = diagonal(surface);
    (0..count).map(move |k| size * 10_f64.powf(-1.0 - f64::from(k) / 2.75))
}
