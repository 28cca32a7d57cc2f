//! The feature `rayon`: every number of threads gives the same bits and the same errors.

use casteljau::glam::{DAffine3, DMat4, DVec2, DVec3, DVec4};
use casteljau::mesh::{Grid, GridMethod, TessellationOptions, View};
use casteljau::{Error, Mesh, Surface, TeapotOptions};
use rayon::{ThreadPool, ThreadPoolBuilder};

/// Not a multiple of the number of patches that are computed together, and more than three times as many.
const TEAPOTS: usize = 25;

const CUBES: usize = 20;

/// The largest numbers of threads: one, as many as a small machine has, and more than it has.
const THREADS: [usize; 3] = [1, 2, 5];

/// Teapots of different sizes and directions, side by side.
fn many_teapots() -> Surface {
    let teapot = Surface::teapot(TeapotOptions::default());
    let (mut vertices, mut indices) = (Vec::new(), Vec::new());
    for k in 0..TEAPOTS {
        let turn = DAffine3::from_rotation_z(k as f64) * DAffine3::from_rotation_x(0.3 * k as f64);
        let scale = DAffine3::from_scale(DVec3::splat(1.0 + 0.1 * k as f64));
        let location = DVec3::new(20.0 * (k % 5) as f64, 20.0 * (k / 5) as f64, 0.0);
        let copy = teapot
            .transform(&(DAffine3::from_translation(location) * turn * scale))
            .expect("a finite image");
        let first = u32::try_from(vertices.len()).unwrap();
        indices.extend(copy.indices().iter().map(|index| first + index));
        vertices.extend_from_slice(copy.vertices());
    }
    Surface::new(vertices, indices, 3, 3).unwrap()
}

fn side_of(cube: usize) -> f64 {
    1.0 + 0.1 * cube as f64
}

/// Closed cubes of different sizes, side by side.
fn many_cubes() -> Surface {
    const FACES: [[u32; 4]; 6] = [
        [0, 2, 1, 3],
        [4, 5, 6, 7],
        [0, 1, 4, 5],
        [2, 6, 3, 7],
        [0, 4, 2, 6],
        [1, 3, 5, 7],
    ];
    let (mut vertices, mut indices) = (Vec::new(), Vec::new());
    for cube in 0..CUBES {
        let first = u32::try_from(vertices.len()).unwrap();
        let corner = DVec3::new(10.0 * cube as f64, 0.0, 0.0);
        let bit = |n: usize, k: usize| f64::from(u8::try_from(n >> k & 1).unwrap());
        let corners = (0..8).map(|n| DVec3::new(bit(n, 0), bit(n, 1), bit(n, 2)));
        vertices.extend(corners.map(|p| corner + side_of(cube) * p));
        indices.extend(FACES.as_flattened().iter().map(|index| first + index));
    }
    Surface::new(vertices, indices, 1, 1).unwrap()
}

fn with_threads(threads: usize) -> ThreadPool {
    ThreadPoolBuilder::new()
        .num_threads(threads)
        .build()
        .unwrap()
}

/// Checks that the result is the same with every number of threads, and returns it.
fn same<T: PartialEq + Send>(result: impl Fn() -> T + Sync) -> T {
    let mut results = THREADS
        .map(|threads| with_threads(threads).install(&result))
        .into_iter();
    let first = results.next().unwrap();
    assert!(results.all(|other| other == first));
    first
}

/// The bits of a mesh, so that −0 differs from 0.
fn bits(mesh: &Mesh) -> Vec<u32> {
    let floats = [&mesh.positions, &mesh.normals, &mesh.uvs];
    let floats = floats.into_iter().flatten().map(|x| x.to_bits());
    let indices = mesh
        .indices
        .iter()
        .map(|index| u32::try_from(index).unwrap());
    let (ids, ranges) = (&mesh.patch_ids, &mesh.patch_ranges);
    let ranges = ranges
        .iter()
        .flat_map(|r| [r.first_vertex, r.vertices, r.first_index, r.indices]);
    let all = floats.chain(indices).chain(ids.iter().copied());
    all.chain(ranges).collect()
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
            surface
                .grid_by(method, Grid::from(9), true, &mut mesh)
                .unwrap();
            bits(&mesh)
        });
        assert!(grid.len() > TEAPOTS * 32 * 100 * 6);
    }
}

#[test]
fn tessellations_are_the_same() {
    let surface = many_teapots();
    let all = [
        TessellationOptions::segments(5),
        TessellationOptions::tolerance(0.02),
        view(),
    ];
    for options in all {
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
    assert!(
        (volume / expected - 1.0).abs() < 1e-12,
        "{volume} {expected}"
    );
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
