//! Grids by forward differencing: their accuracy, and what is exact.

use crate::support::Rng;
use crate::support::nets::{RandomNet, patch, teapot, vector};
use casteljau::glam::DVec3;
use casteljau::{Grid, GridMethod, Mesh, Patch};
#[cfg(target_family = "wasm")]
use wasm_bindgen_test::wasm_bindgen_test as test;

fn stepped(patch: &Patch, grid: Grid) -> Mesh {
    let mut mesh = Mesh::default();
    let method = GridMethod::ForwardDifference;
    patch.grid_by(method, grid, false, &mut mesh).unwrap();
    mesh
}

#[test]
fn positions_drift_no_further_than_stated() {
    let mut random = Rng(31);
    for (m, n) in [(1, 1), (2, 3), (3, 3), (3, 1), (4, 2), (6, 3), (10, 2)] {
        for segments_u in [1, 2, 3, 16, 100, 1024] {
            let grid = Grid {
                segments_u,
                segments_v: 2,
            };
            let patch = random.patch(m, n);
            let mesh = stepped(&patch, grid);
            let drift = segments_u as f64 * 3_f64.powf(m as f64) * 2_f64.powi(-53);
            // Coordinates are below 1, where half an ulp of f32 is 2⁻²⁵.
            let slack = drift + 2_f64.powi(-25);
            for (iu, iv) in (0..=segments_u).flat_map(|iu| [(iu, 0), (iu, 1), (iu, 2)]) {
                let (u, v) = grid.uv(iu, iv);
                let off = vector(&mesh.positions, grid.vertex(iu, iv)) - patch.eval(u, v);
                assert!(off.abs().max_element() <= slack, "{m}, {segments_u}: {off}");
            }
        }
    }
}

#[test]
fn the_last_sample_of_a_line_is_exact() {
    let mut random = Rng(32);
    for degree in [1, 2, 3, 5, 9, 64] {
        for n in [1, 2, 7, 333] {
            let (patch, grid) = (
                random.patch(degree, 2),
                Grid {
                    segments_u: n,
                    segments_v: 4,
                },
            );
            let (mesh, exact) = (stepped(&patch, grid), patch.grid(grid, false).unwrap());
            for last in (0..=4).map(|iv| 3 * grid.vertex(n, iv)) {
                // For a bicubic patch the other method rounds to f32 earlier, but not on edges.
                let [a, b] = [&mesh, &exact].map(|mesh| &mesh.positions[last..last + 3]);
                assert_eq!(a, b, "degree {degree}, {n} segments");
            }
            let row = degree + 1;
            for (iu, iv, point) in [
                (0, 0, 0),
                (n, 0, degree),
                (0, 4, 2 * row),
                (n, 4, 3 * row - 1),
            ] {
                let corner = patch.control_points()[point].as_vec3().as_dvec3();
                assert_eq!(vector(&mesh.positions, grid.vertex(iu, iv)), corner);
            }
        }
    }
}

#[test]
fn the_teapot_looks_the_same() {
    let (grid, mut mesh) = (Grid::from(16), Mesh::default());
    let method = GridMethod::ForwardDifference;
    teapot().grid_by(method, grid, true, &mut mesh).unwrap();
    let exact = teapot().grid(grid, true).unwrap();
    let apart = |a: &[f32], b: &[f32]| {
        let each = a.iter().zip(b).map(|(a, b)| (a - b).abs());
        each.fold(0.0, f32::max)
    };
    // The teapot is 3.525 units long.
    assert!(apart(&mesh.positions, &exact.positions) <= 4.0 * f32::EPSILON * 2.0);
    assert!(apart(&mesh.normals, &exact.normals) < 1e-5);
    assert_eq!(mesh.indices, exact.indices);
    assert_eq!(mesh.quads, exact.quads);
    assert_eq!((mesh.uvs, mesh.patch_ids), (exact.uvs, exact.patch_ids));
}

#[test]
fn any_finite_net_gives_numbers() {
    let mut random = Rng(33);
    for degree in [1, 3, 64] {
        for size in [1e-300, 1e-30, 1e30, 1e38, 1e40, 1e149] {
            let net: Vec<DVec3> = random.net(degree, 2).iter().map(|&p| p * size).collect();
            let mesh = stepped(&patch(&net, degree, 2), Grid::from(5));
            let numbers = !mesh.positions.iter().any(|x| x.is_nan());
            let finite = mesh.normals.iter().all(|x| x.is_finite());
            assert!(numbers && finite, "{degree} {size}");
        }
    }
}
