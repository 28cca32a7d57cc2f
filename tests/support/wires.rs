//! Meshes of wireframes, and checks of them.

use super::nets::{triangles, vector, vectors};
use casteljau::mesh::{Wire, WireframeOptions};
use casteljau::{Mesh, Surface};
use std::collections::HashMap;

fn mesh(surface: &Surface, lines: usize, wire: Wire) -> Mesh {
    let options = WireframeOptions::new().lines(lines).wire(wire);
    surface.wireframe(&options).unwrap()
}

pub(crate) fn tubes(surface: &Surface, lines: usize, radius: f64, sides: usize) -> Mesh {
    mesh(surface, lines, Wire::Tube { radius, sides })
}

pub(crate) fn ribbons(surface: &Surface, lines: usize, width: f64) -> Mesh {
    mesh(surface, lines, Wire::Ribbon { width })
}

/// Checks lengths and normals, and that ranges cover the mesh; returns V − E + F of a closed mesh.
pub(crate) fn euler(mesh: &Mesh) -> isize {
    let vertices = mesh.vertex_count();
    assert_eq!(mesh.normals.len(), 3 * vertices);
    assert!(mesh.uvs.is_empty() && mesh.patch_ids.is_empty());
    for vertex in 0..vertices {
        assert!(vector(&mesh.positions, vertex).is_finite());
        let length = vector(&mesh.normals, vertex).length();
        assert!((length - 1.0).abs() < 3e-7, "{vertex}: {length}");
    }
    let mut edges: HashMap<(usize, usize), isize> = HashMap::new();
    for triangle in triangles(mesh) {
        for k in 0..3 {
            let (a, b) = (triangle[k], triangle[(k + 1) % 3]);
            assert!(a < vertices && a != b);
            *edges.entry((a, b)).or_default() += 1;
        }
    }
    // Each edge occurs once in each direction: the mesh is closed and consistently oriented.
    for (&(a, b), &times) in &edges {
        assert_eq!((times, edges.get(&(b, a))), (1, Some(&1)));
    }
    let count = |n: usize| isize::try_from(n).unwrap();
    count(vertices) - count(edges.len() / 2) + count(mesh.triangle_count())
}

/// Checks that positions are finite, normals have the length 1, and indices are in range.
pub(crate) fn check_ribbons(mesh: &Mesh) {
    assert!(vectors(&mesh.positions).all(|p| p.is_finite()));
    assert!(vectors(&mesh.normals).all(|n| (n.length() - 1.0).abs() < 3e-7));
    let (mut all, count) = (triangles(mesh).into_iter().flatten(), mesh.vertex_count());
    assert!(all.all(|vertex| vertex < count));
}
