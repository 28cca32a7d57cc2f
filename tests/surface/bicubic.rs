//! Guarantees of grids of bicubic patches on difficult nets: 4 ulps, identical edges, normals within 0.001°.

use crate::support::Rng;
use crate::support::nets::RandomNet;
use casteljau::glam::{DVec3, Vec3};
use casteljau::{Grid, Mesh, Patch};
use wasm_bindgen_test::wasm_bindgen_test;

/// 0.001° in radians.
const MIN_ANGLE: f64 = 1.745e-5;

fn position(mesh: &Mesh, vertex: usize) -> DVec3 {
    Vec3::from_slice(&mesh.positions[3 * vertex..]).as_dvec3()
}

fn normal(mesh: &Mesh, vertex: usize) -> DVec3 {
    Vec3::from_slice(&mesh.normals[3 * vertex..]).as_dvec3()
}

/// Asserts that every position is within 4 f32 ulps of the largest coordinate.
fn assert_positions(patch: &Patch, grid: Grid) {
    let mesh = patch.grid(grid, false).unwrap();
    let points = patch.control_points().iter();
    let largest = points.fold(0.0, |max: f32, p| max.max(p.abs().as_vec3().max_element()));
    let slack = 4.0 * (f64::from(largest) - f64::from(largest.next_down()));
    for iv in 0..=grid.segments_v {
        for iu in 0..=grid.segments_u {
            let (u, v) = grid.uv(iu, iv);
            let off = position(&mesh, grid.vertex(iu, iv)) - patch.eval(u, v);
            assert!(off.abs().max_element() <= slack, "({u}, {v}): {off}");
        }
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn positions_within_four_ulps() {
    let mut random = Rng(21);
    // Just below a power of 2, where an ulp is the smallest fraction of the number, with any sign; and anywhere in
    // between.
    let edge = |random: &mut Rng| {
        let sign = if random.next().is_multiple_of(2) {
            1.0
        } else {
            -1.0
        };
        sign * (1.0 - random.unit() * 1e-3)
    };
    for segments in (1..=20).chain([63, 64, 101]) {
        for _ in 0..20 {
            let net: Vec<DVec3> = (0..16)
                .map(|_| DVec3::new(edge(&mut random), edge(&mut random), random.coordinate()))
                .collect();
            let grid = Grid {
                segments_u: segments,
                segments_v: 1 + segments / 2,
            };
            assert_positions(&Patch::new(&net, 3, 3).unwrap(), grid);
        }
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn positions_of_any_size() {
    let net = Rng(22).net(3, 3);
    for size in [1e-44, 1e-38, 1e-20, 1e20, 1e36, 2e37, 3e37, 1e38] {
        let scaled: Vec<DVec3> = net.iter().map(|&p| p * size).collect();
        assert_positions(&Patch::new(&scaled, 3, 3).unwrap(), Grid::from(9));
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn zeros_of_shared_sides_have_the_same_sign() {
    // Numbers below the range of f32 become a zero, and the bits of −0 differ from those of 0.
    let mut random = Rng(23);
    for size in [1e-46, -1e-46, 1e-60] {
        let side: Vec<DVec3> = (0..4).map(|i| DVec3::splat(size * f64::from(i))).collect();
        let backwards: Vec<DVec3> = side.iter().rev().copied().collect();
        let bits = |mesh: &Mesh, first: usize, step: usize| -> Vec<[u32; 3]> {
            let bits = |vertex: usize| {
                position(mesh, vertex)
                    .as_vec3()
                    .to_array()
                    .map(f32::to_bits)
            };
            (0..=8).map(|k| bits(first + k * step)).collect()
        };
        let mut first = random.net(3, 3);
        first[..4].copy_from_slice(&side);
        let first = Patch::new(&first, 3, 3)
            .unwrap()
            .grid(Grid::from(8), false)
            .unwrap();
        for degree in [2, 3] {
            let mut other = random.net(degree, 3);
            for (row, &point) in other.chunks_mut(degree + 1).zip(&backwards) {
                row[0] = point;
            }
            let other = Patch::new(&other, degree, 3)
                .unwrap()
                .grid(Grid::from(8), false)
                .unwrap();
            let mut expected = bits(&first, 0, 1);
            expected.reverse();
            assert_eq!(bits(&other, 0, 9), expected);
        }
    }
}

/// The largest angle between the normals of the grid and those of the patch in f64.
fn worst_angle(patch: &Patch, grid: Grid) -> f64 {
    let mesh = patch.grid(grid, false).unwrap();
    let mut worst: f64 = 0.0;
    for iv in 0..=grid.segments_v {
        for iu in 0..=grid.segments_u {
            let (u, v) = grid.uv(iu, iv);
            let (ours, exact) = (normal(&mesh, grid.vertex(iu, iv)), patch.normal(u, v));
            assert!((ours.length() - exact.length()).abs() < 3e-7, "({u}, {v})");
            assert!(ours.dot(exact) > 0.0, "({u}, {v}): {ours} {exact}");
            worst = worst.max(ours.cross(exact).length());
        }
    }
    worst
}

/// A patch with collapsed edges: 0 is v = 0, 1 is v = 1, 2 is u = 0, 3 is u = 1.
fn collapsed(random: &mut Rng, sides: &[usize]) -> Patch {
    // A regular grid with noise, so that no two other points coincide and N vanishes nowhere else.
    let mut net: Vec<DVec3> = (0..16)
        .map(|k| DVec3::new(f64::from(k % 4), f64::from(k / 4), 0.0) + 0.2 * random.grid_point())
        .collect();
    for side in sides {
        let locations = [
            [0, 1, 2, 3],
            [12, 13, 14, 15],
            [0, 4, 8, 12],
            [3, 7, 11, 15],
        ][*side];
        let point = net[locations[0]];
        for location in locations {
            net[location] = point;
        }
    }
    Patch::new(&net, 3, 3).unwrap()
}

#[wasm_bindgen_test(unsupported = test)]
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

#[wasm_bindgen_test(unsupported = test)]
fn normals_of_slanted_patches() {
    // ∂u and ∂v are almost parallel: their cross product is 10⁻⁵ of the product of their lengths.
    let mut random = Rng(25);
    for slant in [1e-2, 1e-3, 1e-5] {
        let net: Vec<DVec3> = (0..16)
            .map(|k| {
                let (i, j) = (f64::from(k % 4), f64::from(k / 4));
                DVec3::new(i + j, slant * (j - i), slant * 0.3 * random.coordinate())
            })
            .collect();
        let angle = worst_angle(&Patch::new(&net, 3, 3).unwrap(), Grid::from(24));
        assert!(angle < MIN_ANGLE, "{slant}: {angle:e}");
    }
}

#[wasm_bindgen_test(unsupported = test)]
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
        let net: Vec<DVec3> = (0..16)
            .map(|k| DVec3::new(square[k % 4], (k / 4) as f64, 1e-6 * random.coordinate()))
            .collect();
        let angle = worst_angle(&Patch::new(&net, 3, 3).unwrap(), Grid::from(64));
        assert!(angle < MIN_ANGLE, "{angle:e}");
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn a_curve_and_a_point_have_no_normals() {
    let line: Vec<DVec3> = (0..16).map(|k| DVec3::X * f64::from(k % 4)).collect();
    for net in [line, vec![DVec3::ONE; 16]] {
        let mesh = Patch::new(&net, 3, 3)
            .unwrap()
            .grid(Grid::from(5), false)
            .unwrap();
        assert!(mesh.normals.iter().all(|&n| n == 0.0));
    }
}
