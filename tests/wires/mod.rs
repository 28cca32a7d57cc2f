//! Wireframe meshes: tubes and ribbons along isocurves.

mod limits;
mod ribbons;
mod tubes;

use casteljau::glam::DVec3;
use casteljau::mesh::{Wire, WireframeOptions};
use casteljau::{Mesh, Surface, TeapotOptions};
use std::collections::HashMap;

pub(crate) fn teapot() -> Surface {
    Surface::teapot(TeapotOptions::default())
}

pub(crate) fn single(net: Vec<DVec3>, m: usize, n: usize) -> Surface {
    let indices = (0..u32::try_from(net.len()).unwrap()).collect();
    Surface::new(net, indices, m, n).unwrap()
}

pub(crate) fn tubes(surface: &Surface, lines: usize, radius: f64, sides: usize) -> Mesh {
    let wire = Wire::Tube { radius, sides };
    surface
        .wireframe(&WireframeOptions { lines, wire })
        .unwrap()
}

pub(crate) fn ribbons(surface: &Surface, lines: usize, width: f64) -> Mesh {
    let wire = Wire::Ribbon { width };
    surface
        .wireframe(&WireframeOptions { lines, wire })
        .unwrap()
}

pub(crate) fn vector(list: &[f32], vertex: usize) -> DVec3 {
    let [x, y, z] = [0, 1, 2].map(|axis| f64::from(list[3 * vertex + axis]));
    DVec3::new(x, y, z)
}

pub(crate) fn triangles(mesh: &Mesh) -> Vec<[usize; 3]> {
    let indices: Vec<usize> = mesh.indices.iter().collect();
    indices.chunks(3).map(|t| [t[0], t[1], t[2]]).collect()
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

pub(crate) fn volume(mesh: &Mesh) -> f64 {
    let corner = |vertex| vector(&mesh.positions, vertex);
    let tetrahedron = |t: [usize; 3]| corner(t[0]).dot(corner(t[1]).cross(corner(t[2]))) / 6.0;
    triangles(mesh).into_iter().map(tetrahedron).sum()
}
