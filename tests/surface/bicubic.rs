//! Guarantees of grids of bicubic patches on difficult nets: 4 ulps, identical edges, normals within 0.001°.

use crate::support::nets::{RandomNet, net, patch, teapot, vector};
use crate::support::{Rng, assert_refused};
use casteljau::glam::DVec3;
use casteljau::{Grid, Mesh, Patch, Surface};
#[cfg(target_family = "wasm")]
use wasm_bindgen_test::wasm_bindgen_test as test;

/// 0.001° in radians.
const MIN_ANGLE: f64 = 1.745e-5;

/// The vertices of a grid with their parameters.
fn vertices(grid: Grid) -> impl Iterator<Item = (usize, f64, f64)> {
    let rows = 0..=grid.segments_v;
    let indices = rows.flat_map(move |iv| (0..=grid.segments_u).map(move |iu| (iu, iv)));
    indices.map(move |(iu, iv)| (grid.vertex(iu, iv), grid.uv(iu, iv).0, grid.uv(iu, iv).1))
}

/// Asserts that every position is within 4 f32 ulps of the largest coordinate.
fn assert_positions(patch: &Patch, grid: Grid) {
    let mesh = patch.grid(grid, false).unwrap();
    let points = patch.control_points().iter();
    let largest = points.fold(0.0, |max: f32, p| max.max(p.abs().as_vec3().max_element()));
    let slack = 4.0 * (f64::from(largest) - f64::from(largest.next_down()));
    for (vertex, u, v) in vertices(grid) {
        let off = vector(&mesh.positions, vertex) - patch.eval(u, v);
        assert!(off.abs().max_element() <= slack, "({u}, {v}): {off}");
    }
}

#[test]
fn positions_within_four_ulps() {
    let mut random = Rng(21);
    // Just below a power of 2, where an ulp is the smallest fraction of the number, with any sign; and anywhere in
    // between.
    let edge = |random: &mut Rng| random.pick(&[1.0, -1.0]) * (1.0 - random.unit() * 1e-3);
    for segments_u in (1..=20).chain([63, 64, 101]) {
        let segments_v = 1 + segments_u / 2;
        for _ in 0..20 {
            let net = [(); 16]
                .map(|()| DVec3::new(edge(&mut random), edge(&mut random), random.coordinate()));
            assert_positions(
                &patch(&net, 3, 3),
                Grid {
                    segments_u,
                    segments_v,
                },
            );
        }
    }
}

#[test]
fn positions_of_any_size() {
    let net = Rng(22).net(3, 3);
    for size in [1e-44, 1e-38, 1e-20, 1e20, 1e36, 2e37, 3e37, 1e38] {
        let scaled: Vec<DVec3> = net.iter().map(|&p| p * size).collect();
        assert_positions(&patch(&scaled, 3, 3), Grid::from(9));
    }
}

#[test]
fn zeros_of_shared_sides_have_the_same_sign() {
    // Numbers below the range of f32 become a zero, and the bits of −0 differ from those of 0.
    let mut random = Rng(23);
    for size in [1e-46, -1e-46, 1e-60] {
        let side: Vec<DVec3> = (0..4).map(|i| DVec3::splat(size * f64::from(i))).collect();
        let backwards: Vec<DVec3> = side.iter().rev().copied().collect();
        let bits = |mesh: &Mesh, step: usize| -> Vec<[u32; 3]> {
            let bits = |k: usize| {
                mesh.positions[3 * k * step..][..3]
                    .iter()
                    .map(|x| x.to_bits())
            };
            (0..=8)
                .map(|k| bits(k).collect::<Vec<_>>().try_into().unwrap())
                .collect()
        };
        let grid = |net: &[DVec3], m| patch(net, m, 3).grid(Grid::from(8), false).unwrap();
        let mut first = random.net(3, 3);
        first[..4].copy_from_slice(&side);
        let mut expected = bits(&grid(&first, 3), 1);
        expected.reverse();
        for degree in [2, 3] {
            let mut other = random.net(degree, 3);
            let rows = other.chunks_mut(degree + 1).zip(&backwards);
            rows.for_each(|(row, &point)| row[0] = point);
            assert_eq!(bits(&grid(&other, degree), 9), expected);
        }
    }
}

/// The largest angle between the normals of the grid and those of the patch in f64.
fn worst_angle(patch: &Patch, grid: Grid) -> f64 {
    let mesh = patch.grid(grid, false).unwrap();
    let mut worst: f64 = 0.0;
    for (vertex, u, v) in vertices(grid) {
        let (ours, exact) = (vector(&mesh.normals, vertex), patch.normal(u, v));
        assert!((ours.length() - exact.length()).abs() < 3e-7, "({u}, {v})");
        assert!(ours.dot(exact) > 0.0, "({u}, {v}): {ours} {exact}");
        worst = worst.max(ours.cross(exact).length());
    }
    worst
}

/// A patch with collapsed edges: 0 is v = 0, 1 is v = 1, 2 is u = 0, 3 is u = 1.
fn collapsed(random: &mut Rng, sides: &[usize]) -> Patch {
    // A regular grid with noise, so that no two other points coincide and N vanishes nowhere else.
    let mut net = net(3, 3, |i, j| DVec3::new(i, j, 0.0));
    net.iter_mut().for_each(|p| *p += 0.2 * random.grid_point());
    for side in sides {
        let (first, step) = [(0, 1), (12, 1), (0, 4), (3, 4)][*side];
        (1..4).for_each(|k| net[first + k * step] = net[first]);
    }
    patch(&net, 3, 3)
}

#[test]
fn normals_near_collapsed_sides() {
    let mut random = Rng(24);
    for sides in [&[0][..], &[1], &[2], &[3], &[0, 1], &[2, 3]] {
        for segments in [1, 2, 3, 4, 7, 16, 200] {
            let patch = collapsed(&mut random, sides);
            let angle = worst_angle(&patch, Grid::from(segments));
            assert!(angle < MIN_ANGLE, "{sides:?}, {segments}: {angle:e}");
        }
    }
}

#[test]
fn normals_of_slanted_patches() {
    // ∂u and ∂v are almost parallel: their cross product is 10⁻⁵ of the product of their lengths.
    let mut random = Rng(25);
    for slant in [1e-2, 1e-3, 1e-5] {
        let mut net = net(3, 3, |i, j| DVec3::new(i + j, slant * (j - i), 0.0));
        net.iter_mut()
            .for_each(|p| p.z = slant * 0.3 * random.coordinate());
        let angle = worst_angle(&patch(&net, 3, 3), Grid::from(24));
        assert!(angle < MIN_ANGLE, "{slant}: {angle:e}");
    }
}

#[test]
fn normals_where_little_is_left_of_the_product() {
    // A fold: x = (u − 0.5003)², so that ∂u × ∂v changes its sign between two samples and is small at both.
    let fold = 0.5003;
    let square = [
        fold * fold,
        fold * fold - 2.0 / 3.0 * fold,
        fold * fold - 4.0 / 3.0 * fold + 1.0 / 3.0,
        (1.0 - fold) * (1.0 - fold),
    ];
    let mut random = Rng(26);
    for _ in 0..10 {
        let net = |k: usize| DVec3::new(square[k % 4], (k / 4) as f64, 1e-6 * random.coordinate());
        let net: Vec<DVec3> = (0..16).map(net).collect();
        let angle = worst_angle(&patch(&net, 3, 3), Grid::from(64));
        assert!(angle < MIN_ANGLE, "{angle:e}");
    }
}

#[test]
fn a_surface_is_evaluated_by_its_patches() {
    let surface = teapot();
    for k in [0, 7, 31] {
        let patch = surface.patch(k).expect("a patch");
        assert_eq!(surface.eval(k, 0.25, 0.75), Ok(patch.eval(0.25, 0.75)));
    }
    assert_refused(
        surface.eval(32, 0.5, 0.5),
        "patch: expected an index from 0 to 31, got 32",
    );
    let none = Surface::new(Vec::new(), Vec::new(), 3, 3).expect("no patches");
    assert_refused(
        none.eval(0, 0.5, 0.5),
        "patches: expected at least 1, got 0",
    );
}
