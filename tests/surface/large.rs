//! Surfaces as large as those of CAD: 2,500 patches, 40,000 with `CASTELJAU_DEEP=1`.

use crate::support::{deep, real};
use casteljau::glam::DVec3;
use casteljau::mesh::TessellationOptions;
use casteljau::{Grid, Surface};

/// The number of patches along each side.
fn side() -> usize {
    if deep() { 200 } else { 50 }
}

/// The height of the hills.
fn height(x: f64, y: f64) -> f64 {
    0.3 * (1.7 * x).sin() * (1.3 * y).cos()
}

/// A terrain of bicubic patches with shared edges, over the square from 0 to `side`.
fn terrain(side: usize) -> Surface {
    let across = 3 * side + 1;
    let at = |k: usize| (real(k % across) / 3.0, real(k / across) / 3.0);
    let vertices = (0..across * across).map(at);
    let vertices = vertices.map(|(x, y)| DVec3::new(x, y, height(x, y)));
    let index = |x: usize, y: usize| u32::try_from(y * across + x).expect("few vertices");
    let patch = |k: usize| {
        let (x, y) = (3 * (k % side), 3 * (k / side));
        (0..16).map(move |i| index(x + i % 4, y + i / 4))
    };
    let indices = (0..side * side).flat_map(patch).collect();
    Surface::new(vertices.collect(), indices, 3, 3).expect("a terrain")
}

#[test]
fn queries_of_a_terrain() {
    let side = side();
    let surface = terrain(side);
    let bounds = surface.bounds().expect("a box");
    assert_eq!((bounds.min.x, bounds.max.y), (0.0, real(side)));
    let flat = real(side) * real(side);
    let area = surface.area();
    assert!(area > flat && area < 1.2 * flat, "{area}");
    let middle = 0.37 * real(side);
    let above = DVec3::new(middle, middle, 5.0);
    let hits = surface.intersect_ray(above, DVec3::NEG_Z).unwrap();
    assert_eq!(hits.len(), 1);
    assert!((hits[0].point.x - middle).abs() < 1e-9);
    let nearest = surface.nearest(above).unwrap().unwrap().distance;
    assert!(nearest <= 5.0 - hits[0].point.z && nearest > 4.5);
}

#[test]
fn meshes_of_a_terrain() {
    let side = side();
    let surface = terrain(side);
    let mesh = surface.tessellate(&TessellationOptions::tolerance(0.02));
    assert!(mesh.unwrap().triangle_count() >= 2 * side * side);
    assert!(surface.subdivide(0.02).unwrap().len() >= side * side);
    let grid = surface.grid(Grid::from(4), false).unwrap();
    assert_eq!(grid.triangle_count(), 32 * side * side);
    assert_eq!(surface.topology().shared.len(), 2 * side * (side - 1));
}
