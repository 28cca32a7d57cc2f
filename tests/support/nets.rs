//! Control nets for the tests of surfaces: random nets, nets of known polynomials, the teapot. Vectors of meshes.

use super::{Rng, numbers};
use casteljau::glam::{DAffine3, DVec3};
use casteljau::{Mesh, Patch, Surface, TeapotOptions};

/// Random control nets; coordinates are in −1 … 1, often on a coarse grid, so that coincident and collinear points occur.
pub(crate) trait RandomNet {
    fn coordinate(&mut self) -> f64;
    fn grid_point(&mut self) -> DVec3;
    fn net(&mut self, degree_u: usize, degree_v: usize) -> Vec<DVec3>;
    fn patch(&mut self, degree_u: usize, degree_v: usize) -> Patch;
}

impl RandomNet for Rng {
    fn coordinate(&mut self) -> f64 {
        let x = self.signed();
        if self.next().is_multiple_of(4) {
            x.round()
        } else {
            x
        }
    }

    fn grid_point(&mut self) -> DVec3 {
        DVec3::new(self.coordinate(), self.coordinate(), self.coordinate())
    }

    fn net(&mut self, degree_u: usize, degree_v: usize) -> Vec<DVec3> {
        let count = (degree_u + 1) * (degree_v + 1);
        (0..count).map(|_| self.grid_point()).collect()
    }

    fn patch(&mut self, degree_u: usize, degree_v: usize) -> Patch {
        Patch::new(&self.net(degree_u, degree_v), degree_u, degree_v).unwrap()
    }
}

/// C(n, k).
pub(crate) fn choose(n: usize, k: usize) -> f64 {
    (0..k).fold(1.0, |c, i| c * (n - i.min(n)) as f64 / (i + 1) as f64)
}

/// Points of space from a text: three numbers for each.
pub(crate) fn points(text: &str) -> Vec<DVec3> {
    vectors(&numbers(text)).collect()
}

/// The net of the points f(i, j).
pub(crate) fn net(m: usize, n: usize, f: impl Fn(f64, f64) -> DVec3) -> Vec<DVec3> {
    let points = (0..(m + 1) * (n + 1)).map(|k| f((k % (m + 1)) as f64, (k / (m + 1)) as f64));
    points.collect()
}

pub(crate) fn patch(net: &[DVec3], degree_u: usize, degree_v: usize) -> Patch {
    Patch::new(net, degree_u, degree_v).unwrap()
}

/// The patch (u, v, f) where f is a sum of monomials c·uᵃ·vᵇ: the Bernstein coefficient i of tᵃ is C(i, a) / C(n, a).
pub(crate) fn graph(degree_u: usize, degree_v: usize, monomials: &[(f64, usize, usize)]) -> Patch {
    let coefficient = |n: usize, i: usize, a: usize| choose(i, a) / choose(n, a);
    let point = |k: usize| {
        let (i, j) = (k % (degree_u + 1), k / (degree_u + 1));
        let term = |&(c, a, b)| c * coefficient(degree_u, i, a) * coefficient(degree_v, j, b);
        let height = monomials.iter().map(term).sum();
        DVec3::new(
            i as f64 / degree_u as f64,
            j as f64 / degree_v as f64,
            height,
        )
    };
    let count = (degree_u + 1) * (degree_v + 1);
    patch(
        &(0..count).map(point).collect::<Vec<_>>(),
        degree_u,
        degree_v,
    )
}

/// z = (u − ½)² + (v − ½)², with its vertex at (½, ½, 0).
pub(crate) fn bowl() -> Patch {
    let linear = [(-1.0, 1, 0), (-1.0, 0, 1), (0.5, 0, 0)];
    graph(2, 2, &[&[(1.0, 2, 0), (1.0, 0, 2)], &linear[..]].concat())
}

/// A surface of one patch.
pub(crate) fn single(net: &[DVec3], degree_u: usize, degree_v: usize) -> Surface {
    let indices = (0..u32::try_from(net.len()).unwrap()).collect();
    Surface::new(net.to_vec(), indices, degree_u, degree_v).unwrap()
}

pub(crate) fn as_surface(patch: &Patch) -> Surface {
    single(patch.control_points(), patch.degree_u(), patch.degree_v())
}

pub(crate) fn nothing() -> Surface {
    Surface::new(Vec::new(), Vec::new(), 3, 3).unwrap()
}

pub(crate) fn teapot() -> Surface {
    Surface::teapot(&TeapotOptions::default())
}

/// The six faces of the cube from 0 to 1 as bilinear patches, normals outwards.
pub(crate) fn cube() -> Surface {
    let bit = |k: u8, axis: u8| f64::from(k >> axis & 1);
    let vertices = (0..8).map(|k| DVec3::new(bit(k, 0), bit(k, 1), bit(k, 2)));
    let faces = [
        0, 2, 1, 3, 4, 5, 6, 7, 0, 1, 4, 5, 2, 6, 3, 7, 0, 4, 2, 6, 1, 3, 5, 7,
    ];
    Surface::new(vertices.collect(), faces.to_vec(), 1, 1).unwrap()
}

/// The selected patches of a surface.
pub(crate) fn part(surface: &Surface, patches: &[usize]) -> Surface {
    let nets = patches
        .iter()
        .flat_map(|&k| surface.patch_indices(k).unwrap());
    let degrees: Vec<_> = patches
        .iter()
        .map(|&k| surface.degrees(k).unwrap())
        .collect();
    let vertices = surface.vertices().to_vec();
    Surface::with_degrees(vertices, nets.copied().collect(), &degrees).unwrap()
}

pub(crate) fn scaled(surface: &Surface, factor: f64) -> Surface {
    let map = DAffine3::from_scale(DVec3::splat(factor));
    surface.transform(&map).unwrap()
}

/// The pairs of count + 1 parameters from 0 to 1.
pub(crate) fn samples(count: u32) -> impl Iterator<Item = (f64, f64)> {
    let t = move |i: u32| f64::from(i) / f64::from(count);
    (0..=count).flat_map(move |j| (0..=count).map(move |i| (t(i), t(j))))
}

/// Vectors from consecutive triples of numbers.
pub(crate) fn vectors<T: Copy + Into<f64>>(numbers: &[T]) -> impl Iterator<Item = DVec3> {
    let triples = numbers.as_chunks().0.iter();
    triples.map(|&[x, y, z]| DVec3::new(x.into(), y.into(), z.into()))
}

/// The vector of a vertex.
pub(crate) fn vector(numbers: &[f32], vertex: usize) -> DVec3 {
    DVec3::from([0, 1, 2].map(|axis| f64::from(numbers[3 * vertex + axis])))
}

pub(crate) fn triangles<T>(mesh: &Mesh<T>) -> Vec<[usize; 3]> {
    let indices: Vec<usize> = mesh.indices.iter().collect();
    indices.as_chunks().0.to_vec()
}

/// The enclosed volume, by the divergence theorem: Σ a · (b × c) / 6.
pub(crate) fn volume(mesh: &Mesh) -> f64 {
    let corner = |vertex| vector(&mesh.positions, vertex);
    let tetrahedron = |[a, b, c]: [usize; 3]| corner(a).dot(corner(b).cross(corner(c))) / 6.0;
    triangles(mesh).into_iter().map(tetrahedron).sum()
}

/// Asserts that two points are within `tolerance` of each other.
#[track_caller]
pub(crate) fn assert_near(a: DVec3, b: DVec3, tolerance: f64) {
    let distance = (a - b).length();
    assert!(distance <= tolerance, "{a} and {b} are {distance:e} apart");
}
