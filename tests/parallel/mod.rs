//! The feature `rayon`: every number of threads gives the same bits and the same errors.

use crate::support::near;
use crate::support::nets::{cube, teapot};
use casteljau::glam::{DAffine3, DMat4, DVec2, DVec3, DVec4};
use casteljau::mesh::{Grid, GridMethod, TessellationOptions, View};
use casteljau::{Error, Mesh, Surface};
use rayon::ThreadPoolBuilder;

/// Not a multiple of the number of patches that are computed together, and more than three times as many.
const TEAPOTS: usize = 25;

const CUBES: usize = 20;

/// The largest numbers of threads: one, as many as a small machine has, and more than it has.
const THREADS: [usize; 3] = [1, 2, 5];

/// Copies of a surface, side by side.
fn copies(surface: &Surface, maps: impl Iterator<Item = DAffine3>) -> Surface {
    let (mut vertices, mut indices) = (Vec::new(), Vec::new());
    for map in maps {
        let first = u32::try_from(vertices.len()).unwrap();
        indices.extend(surface.indices().iter().map(|index| first + index));
        vertices.extend(surface.vertices().iter().map(|&p| map.transform_point3(p)));
    }
    let [m, n] = surface.degrees(0).unwrap();
    Surface::new(vertices, indices, m, n).unwrap()
}

/// Teapots of different sizes and directions.
fn many_teapots() -> Surface {
    let maps = (0..TEAPOTS).map(|k| {
        let turn = DAffine3::from_rotation_z(k as f64) * DAffine3::from_rotation_x(0.3 * k as f64);
        let scale = DAffine3::from_scale(DVec3::splat(1.0 + 0.1 * k as f64));
        let location = DVec3::new(20.0 * (k % 5) as f64, 20.0 * (k / 5) as f64, 0.0);
        DAffine3::from_translation(location) * turn * scale
    });
    copies(&teapot(), maps)
}

fn side_of(cube: usize) -> f64 {
    1.0 + 0.1 * cube as f64
}

/// Closed cubes of different sizes.
fn many_cubes() -> Surface {
    let maps = (0..CUBES).map(|k| {
        let location = DAffine3::from_translation(DVec3::X * 10.0 * k as f64);
        location * DAffine3::from_scale(DVec3::splat(side_of(k)))
    });
    copies(&cube(), maps)
}

/// Checks that the result is the same with every number of threads, and returns it.
fn same<T: PartialEq + Send>(result: impl Fn() -> T + Sync) -> T {
    let pool = |threads| ThreadPoolBuilder::new().num_threads(threads).build();
    let results = THREADS.map(|threads| pool(threads).unwrap().install(&result));
    let [first, second, third] = results;
    assert!(first == second && first == third);
    first
}

/// The bits of a mesh, so that −0 differs from 0.
fn bits(mesh: &Mesh) -> Vec<u64> {
    let floats = [&mesh.positions, &mesh.normals, &mesh.uvs];
    let floats = floats.into_iter().flatten().map(|x| x.to_bits());
    let indices = mesh.indices.iter().map(|index| index as u64);
    let ids = mesh.patch_ids.iter().copied();
    let ranges = mesh.patch_ranges.iter();
    let ranges = ranges.flat_map(|r| [r.first_vertex, r.vertices, r.first_index, r.indices]);
    let others = ids.chain(ranges).map(u64::from);
    floats.map(u64::from).chain(indices).chain(others).collect()
}

/// Half a pixel for a camera below the origin that looks along z.
fn view() -> TessellationOptions {
    let distance = 150.0;
    let projection = DMat4::from_cols(DVec4::X, DVec4::Y, DVec4::W, DVec4::W * distance);
    TessellationOptions::pixels(View {
        pixels: 0.5,
        view_projection: projection,
        viewport: DVec2::new(1200.0, 800.0),
    })
}

#[test]
fn grids_are_the_same() {
    let surface = many_teapots();
    for method in [GridMethod::Bernstein, GridMethod::ForwardDifference] {
        let grid = same(|| {
            let mut mesh = Mesh::default();
            let filled = surface.grid_by(method, Grid::from(9), true, &mut mesh);
            filled.map(|()| bits(&mesh)).unwrap()
        });
        assert!(grid.len() > TEAPOTS * 32 * 100 * 6);
    }
}

#[test]
fn tessellations_are_the_same() {
    let surface = many_teapots();
    let (even, fine) = (
        TessellationOptions::segments(5),
        TessellationOptions::tolerance(0.02),
    );
    for options in [even, fine, view()] {
        let mesh = same(|| bits(&surface.tessellate(&options).unwrap()));
        assert!(mesh.len() > 1000 * TEAPOTS);
    }
}

#[test]
fn areas_and_volumes_are_the_same() {
    let surface = many_teapots();
    let area = same(|| surface.area().to_bits());
    assert!(f64::from_bits(area) > 0.0);
    let cubes = many_cubes();
    let volume = f64::from_bits(same(|| cubes.volume().unwrap().to_bits()));
    let expected: f64 = (0..CUBES).map(|k| side_of(k).powi(3)).sum();
    near(volume / expected, 1.0, 1e-12);
}

#[test]
fn points_of_a_ray_are_the_same() {
    let surface = many_teapots();
    let origin = DVec3::new(-50.0, 0.5, 1.0);
    let points = same(|| surface.intersect_ray(origin, DVec3::X).unwrap());
    assert!(points.len() >= 10, "{} points", points.len());
}

#[test]
fn errors_are_the_same() {
    let surface = many_teapots();
    let refused = |tolerance: f64| {
        let options = TessellationOptions::tolerance(tolerance);
        same(|| surface.tessellate_f64(&options).map(|mesh| mesh.positions)).unwrap_err()
    };
    assert!(matches!(refused(1e-8), Error::TooMany { .. }));
    assert!(matches!(refused(1e-17), Error::Tolerance { .. }));
}
