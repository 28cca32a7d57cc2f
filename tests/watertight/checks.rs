//! Checks of every mesh of a surface.

use super::limits::{MAX_DEGREES, limit};
use super::shapes::{SIDES, along, diagonal, largest};
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
        let of = |weld| surface.tessellate(&options.weld(weld)).unwrap();
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
        let triangles = |mesh: &Mesh| -> Vec<[u32; 9]> {
            let corner =
                |index: usize| [0, 1, 2].map(|axis| mesh.positions[3 * index + axis].to_bits());
            let numbers: Vec<u32> = mesh.indices.iter().flat_map(corner).collect();
            numbers.as_chunks().0.to_vec()
        };
        let own = triangles(&self.own);
        assert!(
            own == triangles(&self.normal),
            "weld \"normal\" moves positions"
        );
        assert!(
            own == triangles(&self.position),
            "weld \"position\" moves positions"
        );
        assert_eq!(self.own.patch_ranges.len(), patches);
        let same = |a: &Mesh, b: &Mesh| {
            a.patch_ranges
                .iter()
                .zip(&b.patch_ranges)
                .all(|(a, b)| (a.first_index, a.indices) == (b.first_index, b.indices))
        };
        assert!(same(&self.own, &self.normal) && same(&self.own, &self.position));
        self.assert_normals_shared();
    }

    /// Corners share a vertex with weld "normal" only if their normals differ by at most 0.1°.
    fn assert_normals_shared(&self) {
        let own: Vec<DVec3> = vectors(&self.own.normals).collect();
        let shared: Vec<DVec3> = vectors(&self.normal.normals).collect();
        for (a, b) in self.own.indices.iter().zip(self.normal.indices.iter()) {
            let degrees = degrees_between(own[a], shared[b]);
            assert!(
                degrees < 0.100_1,
                "a corner's normal is {degrees}° from its vertex's"
            );
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
    assert!(
        own || used.iter().all(|&used| used),
        "a vertex without triangles"
    );
    assert_eq!(mesh.uvs.len(), if own { 2 * vertices } else { 0 });
    for numbers in [&mesh.positions, &mesh.normals] {
        assert!(numbers.iter().all(|&x| x.into().is_finite()));
    }
    for normal in vectors(&mesh.normals) {
        assert!(
            (normal.length() - 1.0).abs() < 1e-6,
            "a normal of length {}",
            normal.length()
        );
    }
    assert_ranges(mesh, patches, own);
}

/// Checks that ranges are contiguous, cover everything, and belong to their patches.
fn assert_ranges<T>(mesh: &Mesh<T>, patches: usize, own: bool) {
    assert_eq!(mesh.patch_ranges.len(), patches);
    let indices: Vec<usize> = mesh.indices.iter().collect();
    let (mut vertex, mut index) = (0, 0);
    for (patch, range) in mesh.patch_ranges.iter().enumerate() {
        let [first_vertex, vertices, first_index, count] = [
            range.first_vertex,
            range.vertices,
            range.first_index,
            range.indices,
        ]
        .map(|n| n as usize);
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
            assert!(
                (p[axis] - exact[axis]).abs() <= max,
                "a vertex off its patch at {uv:?}: {p} for {exact}"
            );
        }
        let expected = limit(patch, u, v).expect("patches that are curves have no vertices");
        let degrees = degrees_between(normal, expected);
        assert!(
            degrees < MAX_DEGREES,
            "patch {} {uv:?}: a normal off by {degrees}°",
            mesh.patch_ids[k]
        );
    }
}

/// Checks that every normal with weld "normal" is the normal of a patch at the vertex's position.
pub(crate) fn assert_normals_of_patches(three: &Three) {
    let soup = Soup::new(&three.own);
    let key = |location: DVec3, normal: DVec3| {
        (
            location.to_array().map(f64::to_bits),
            normal.to_array().map(f64::to_bits),
        )
    };
    let locations = soup
        .position_of
        .iter()
        .map(|&location| soup.points[location as usize]);
    let known: HashSet<_> = locations
        .zip(vectors(&three.own.normals))
        .map(|(p, n)| key(p, n))
        .collect();
    for (p, normal) in vectors(&three.normal.positions).zip(vectors(&three.normal.normals)) {
        assert!(
            known.contains(&key(p + 0.0, normal)),
            "a normal of no patch at {p}"
        );
    }
}

/// Checks that no edge inside the surface is open or has more than two triangles; edges with one triangle lie on open
/// patch edges.
pub(crate) fn assert_watertight(surface: &Surface, mesh: &Mesh, sheets: u32) -> usize {
    assert!(!mesh.uvs.is_empty(), "for meshes with uvs");
    let soup = Soup::new(mesh);
    soup.assert_no_collapsed_triangle();
    let open: HashSet<(usize, usize)> = surface
        .topology()
        .open
        .iter()
        .map(|s| (s.patch, s.edge as usize))
        .collect();
    let boundary: HashSet<(u32, u32)> = soup.boundary(sheets).into_iter().collect();
    let mut on_open_sides = 0;
    for (locations, corners) in soup.triangles.iter().zip(&soup.corners) {
        for k in 0..3 {
            let (a, b) = (locations[k], locations[(k + 1) % 3]);
            if boundary.contains(&(a, b)) {
                let ends = [corners[k], corners[(k + 1) % 3]];
                assert!(
                    on_side_of(mesh, ends, &open),
                    "an open edge inside at {}",
                    soup.points[a as usize]
                );
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
