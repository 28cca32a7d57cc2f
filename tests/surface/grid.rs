//! Grids: layout, positions and normals compared with the patch, shared edges, reuse of buffers, limits.

use crate::support::Rng;
use crate::support::nets::{RandomNet, assert_near};
use casteljau::curve::bernstein;
use casteljau::glam::{DVec3, Vec3};
use casteljau::{Error, Grid, Indices, Mesh, Patch, Surface, TeapotOptions};
use wasm_bindgen_test::wasm_bindgen_test;

fn position(mesh: &Mesh, vertex: usize) -> Vec3 {
    Vec3::from_slice(&mesh.positions[3 * vertex..])
}

fn normal(mesh: &Mesh, vertex: usize) -> Vec3 {
    Vec3::from_slice(&mesh.normals[3 * vertex..])
}

#[wasm_bindgen_test(unsupported = test)]
fn layout_of_the_buffers() {
    let grid = Grid {
        segments_u: 3,
        segments_v: 2,
    };
    assert_eq!((grid.vertex_count(), grid.triangle_count()), (12, 12));
    let surface = Surface::teapot(TeapotOptions::default());
    let mesh = surface.grid(grid, true).unwrap();
    assert_eq!(mesh.vertex_count(), 32 * 12);
    assert_eq!(mesh.triangle_count(), 32 * 12);
    assert_eq!(mesh.normals.len(), mesh.positions.len());
    assert_eq!(mesh.uvs.len(), 2 * mesh.vertex_count());
    assert_eq!(mesh.quads.as_ref().unwrap().len(), 32 * 6 * 4);
    assert_eq!(mesh.patch_ranges.len(), 32);
    for (id, range) in (0_u32..).zip(&mesh.patch_ranges) {
        assert_eq!((range.first_vertex, range.vertices), (12 * id, 12));
        assert_eq!((range.first_index, range.indices), (36 * id, 36));
        for vertex in 12 * id..12 * (id + 1) {
            let vertex = vertex as usize;
            assert_eq!(mesh.patch_ids[vertex], id);
            let (iu, iv) = (vertex % 12 % 4, vertex % 12 / 4);
            assert_eq!(mesh.uvs[2 * vertex], iu as f32 / 3.0);
            assert_eq!(mesh.uvs[2 * vertex + 1], iv as f32 / 2.0);
        }
        for location in range.first_index..range.first_index + range.indices {
            let vertex = mesh.indices.get(location as usize).unwrap();
            assert_eq!(vertex / 12, id as usize);
        }
    }
    assert_eq!(mesh.indices.get(mesh.indices.len()), None);
}

#[wasm_bindgen_test(unsupported = test)]
fn faces_run_counter_clockwise_and_cover_the_square_once() {
    let grid = Grid {
        segments_u: 5,
        segments_v: 3,
    };
    let mesh = Rng(1).patch(3, 3).grid(grid, true).unwrap();
    let uv = |vertex: usize| [0, 1].map(|k| f64::from(mesh.uvs[2 * vertex + k]));
    let area = |face: &[usize]| -> f64 {
        let next = face.iter().cycle().skip(1);
        face.iter()
            .zip(next)
            .map(|(&a, &b)| (uv(a)[0] * uv(b)[1] - uv(a)[1] * uv(b)[0]) / 2.0)
            .sum()
    };
    let quads = mesh.quads.as_ref().unwrap();
    for (list, corners) in [(&mesh.indices, 3), (quads, 4)] {
        let all: Vec<usize> = list.iter().collect();
        let cell = 1.0 / 15.0 * if corners == 3 { 0.5 } else { 1.0 };
        for face in all.chunks(corners) {
            assert!((area(face) - cell).abs() < 1e-7, "{face:?}");
        }
        assert_eq!(all.len() / corners, if corners == 3 { 30 } else { 15 });
    }
    let listed: Vec<usize> = grid.triangles().flatten().collect();
    assert_eq!(listed, mesh.indices.iter().collect::<Vec<_>>());
    let listed: Vec<usize> = grid.quads().flatten().collect();
    assert_eq!(listed, quads.iter().collect::<Vec<_>>());
}

#[wasm_bindgen_test(unsupported = test)]
fn triangles_face_where_the_normals_point() {
    let mesh = Surface::teapot(TeapotOptions::default())
        .grid(Grid::from(16), false)
        .unwrap();
    let indices: Vec<usize> = mesh.indices.iter().collect();
    let mut flat = 0;
    for face in indices.chunks(3) {
        let [a, b, c] = [face[0], face[1], face[2]].map(|i| position(&mesh, i).as_dvec3());
        let across = (b - a).cross(c - a);
        if across.length() < 1e-9 {
            flat += 1;
            continue;
        }
        for &vertex in face {
            assert!(across.dot(normal(&mesh, vertex).as_dvec3()) > 0.0);
        }
    }
    // Eight collapsed edges, one triangle for each of their sixteen segments.
    assert_eq!(flat, 128);
}

#[wasm_bindgen_test(unsupported = test)]
fn samples_are_points_and_normals_of_the_patch() {
    let mut random = Rng(2);
    for (m, n) in [(1, 1), (2, 3), (3, 3), (3, 2), (5, 4), (1, 64), (64, 1)] {
        for segments_u in [1, 2, 3, 4, 7, 8, 13] {
            let grid = Grid {
                segments_u,
                segments_v: 3,
            };
            let patch = random.patch(m, n);
            let mesh = patch.grid(grid, false).unwrap();
            let bounds = patch.control_bounds();
            let largest = bounds
                .min
                .abs()
                .max(bounds.max.abs())
                .as_vec3()
                .max_element();
            let slack = f64::from(4.0 * (largest.next_up() - largest));
            for iv in 0..=3 {
                for iu in 0..=segments_u {
                    let (u, v) = grid.uv(iu, iv);
                    let vertex = grid.vertex(iu, iv);
                    let (p, q) = (position(&mesh, vertex).as_dvec3(), patch.eval(u, v));
                    assert!((p - q).abs().max_element() <= slack, "{p} {q}");
                    let vertex_normal = normal(&mesh, vertex).as_dvec3();
                    assert_near(vertex_normal, patch.normal(u, v), 1e-6);
                }
            }
        }
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn corners_are_exact() {
    let mut random = Rng(3);
    for _ in 0..100 {
        let patch = random.patch(3, 3);
        let mesh = patch.grid(Grid::from(5), false).unwrap();
        for (vertex, index) in [(0, 0), (5, 3), (30, 12), (35, 15)] {
            let corner = patch.control_points()[index].as_vec3();
            assert_eq!(position(&mesh, vertex), corner);
        }
    }
}

/// The four edges of a grid of n × n cells: u = 0, u = 1, v = 0, v = 1.
fn sides(mesh: &Mesh, n: usize) -> [Vec<[u32; 3]>; 4] {
    let bits = |vertex: usize| position(mesh, vertex).to_array().map(f32::to_bits);
    let line = |first: usize, step: usize| (0..=n).map(|k| bits(first + k * step)).collect();
    [
        line(0, n + 1),
        line(n, n + 1),
        line(0, 1),
        line(n * (n + 1), 1),
    ]
}

#[wasm_bindgen_test(unsupported = test)]
fn shared_sides_are_bit_identical_from_both_patches() {
    let mut random = Rng(4);
    for degree in [1, 2, 3, 5, 8] {
        for other in [1, 3, 4] {
            let side = random.net(degree, 0);
            let first = along_v0(&side, &mut random, other);
            let backwards: Vec<DVec3> = side.iter().rev().copied().collect();
            for n in [1, 2, 5, 16, 23] {
                let grid = Grid::from(n);
                let shared = &sides(&first.grid(grid, false).unwrap(), n)[2];
                let reversed: Vec<_> = shared.iter().rev().copied().collect();
                for (points, expected) in [(&side, shared), (&backwards, &reversed)] {
                    // The neighbour's degree across the edge does not matter.
                    let below = along_v0(points, &mut random, 3);
                    let right = along_u1(points, &mut random, 2);
                    let mesh = below.grid(grid, false).unwrap();
                    assert_eq!(&sides(&mesh, n)[2], expected);
                    let mesh = right.grid(grid, false).unwrap();
                    assert_eq!(&sides(&mesh, n)[1], expected);
                }
            }
        }
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn shared_sides_are_bit_identical_where_everything_cancels() {
    // Edges that pass through 0 at one sample, where only the rounding of f64 remains: it must be equal for both
    // patches.
    let mut random = Rng(9);
    for degree in [2, 3, 4] {
        for n in [7, 16, 23, 49] {
            let grid = Grid::from(n);
            for k in 1..n {
                let weights = bernstein(degree, k as f64 / n as f64).unwrap();
                let mut side = random.net(degree, 0);
                let others = side.iter().zip(&weights).take(degree);
                let sum: DVec3 = others.map(|(&p, &w)| p * w).sum();
                side[degree] = -sum / weights[degree];
                let backwards: Vec<DVec3> = side.iter().rev().copied().collect();
                let a = along_v0(&side, &mut random, 3);
                let b = along_v0(&backwards, &mut random, 2);
                let c = along_u1(&backwards, &mut random, 3);
                let mut expected = sides(&a.grid(grid, false).unwrap(), n)[2].clone();
                expected.reverse();
                assert_eq!(sides(&b.grid(grid, false).unwrap(), n)[2], expected);
                assert_eq!(sides(&c.grid(grid, false).unwrap(), n)[1], expected);
            }
        }
    }
}

/// A random patch with these points along v = 0.
fn along_v0(side: &[DVec3], random: &mut Rng, degree_v: usize) -> Patch {
    let mut net = random.net(side.len() - 1, degree_v);
    net[..side.len()].copy_from_slice(side);
    Patch::new(&net, side.len() - 1, degree_v).unwrap()
}

/// A random patch with these points along u = 1.
fn along_u1(side: &[DVec3], random: &mut Rng, degree_u: usize) -> Patch {
    let mut net = random.net(degree_u, side.len() - 1);
    for (row, &point) in net.chunks_mut(degree_u + 1).zip(side) {
        row[degree_u] = point;
    }
    Patch::new(&net, degree_u, side.len() - 1).unwrap()
}

#[wasm_bindgen_test(unsupported = test)]
fn degenerate_and_extreme_patches_give_numbers() {
    let point = Patch::new(&[DVec3::ONE; 16], 3, 3).unwrap();
    let mesh = point.grid(Grid::from(4), false).unwrap();
    for vertex in 0..mesh.vertex_count() {
        assert_eq!(position(&mesh, vertex), Vec3::ONE);
        assert_eq!(normal(&mesh, vertex), Vec3::ZERO);
    }
    let net = Rng(5).net(3, 3);
    for size in [1e-300, 1e-30, 1e30, 1e149] {
        let scaled: Vec<DVec3> = net.iter().map(|&p| p * size).collect();
        let patch = Patch::new(&scaled, 3, 3).unwrap();
        let mesh = patch.grid(Grid::from(4), false).unwrap();
        for vertex in 0..mesh.vertex_count() {
            // Positions too large for f32 are infinite, not NaN; the normal keeps its direction.
            assert!(!position(&mesh, vertex).is_nan());
            assert!((normal(&mesh, vertex).length() - 1.0).abs() < 1e-6);
        }
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn sixteen_bits_up_to_65536_vertices() {
    let patch = Rng(6).patch(1, 1);
    for (n, small) in [(255, true), (256, false)] {
        let mesh = patch.grid(Grid::from(n), false).unwrap();
        assert_eq!(matches!(mesh.indices, Indices::U16(_)), small);
        assert_eq!(mesh.indices.iter().max(), Some(mesh.vertex_count() - 1));
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn an_earlier_mesh_is_reused() {
    let teapot = Surface::teapot(TeapotOptions::default());
    let mut mesh = teapot.grid(Grid::from(20), true).unwrap();
    let buffers = |mesh: &Mesh| (mesh.positions.as_ptr(), mesh.normals.as_ptr());
    let before = buffers(&mesh);
    for (n, quads) in [(16, false), (20, true), (3, false)] {
        teapot.grid_into(Grid::from(n), quads, &mut mesh).unwrap();
        assert_eq!(mesh, teapot.grid(Grid::from(n), quads).unwrap());
        assert_eq!(buffers(&mesh), before);
    }
    // From 16 to 32 bits and back, and to another surface.
    for n in [50, 2] {
        teapot.grid_into(Grid::from(n), true, &mut mesh).unwrap();
        assert_eq!(mesh, teapot.grid(Grid::from(n), true).unwrap());
    }
    let patch = Rng(7).patch(2, 4);
    patch.grid_into(Grid::from(4), false, &mut mesh).unwrap();
    assert_eq!(mesh, patch.grid(Grid::from(4), false).unwrap());
}

#[wasm_bindgen_test(unsupported = test)]
fn patches_of_different_degrees_in_one_surface() {
    let mut random = Rng(8);
    let degrees = [[3, 3], [2, 1], [3, 3], [1, 5]];
    let patches = degrees.map(|[m, n]| random.patch(m, n));
    let vertices: Vec<DVec3> = patches
        .iter()
        .flat_map(|patch| patch.control_points().to_vec())
        .collect();
    let indices = (0..u32::try_from(vertices.len()).unwrap()).collect();
    let surface = Surface::with_degrees(vertices, indices, &degrees).unwrap();
    let grid = Grid::from(6);
    let mesh = surface.grid(grid, false).unwrap();
    for (k, patch) in patches.iter().enumerate() {
        assert_eq!(surface.patch(k).as_ref(), Some(patch));
        assert_eq!(surface.degrees(k), Some(degrees[k]));
        let numbers = 3 * grid.vertex_count();
        let single = patch.grid(grid, false).unwrap();
        let range = k * numbers..(k + 1) * numbers;
        assert_eq!(mesh.positions[range.clone()], single.positions);
        assert_eq!(mesh.normals[range], single.normals);
    }
    assert_eq!(surface.patch(4), None);
}

#[wasm_bindgen_test(unsupported = test)]
fn an_empty_surface_gives_an_empty_mesh() {
    let surface = Surface::new(Vec::new(), Vec::new(), 3, 3).unwrap();
    let mesh = surface.grid(Grid::from(4), false).unwrap();
    assert_eq!(mesh, Mesh::default());
    assert_eq!(surface.control_bounds(), None);
}

#[wasm_bindgen_test(unsupported = test)]
fn segments_are_checked_before_anything_is_allocated() {
    let teapot = Surface::teapot(TeapotOptions::default());
    let mut mesh = teapot.grid(Grid::from(2), false).unwrap();
    let before = mesh.clone();
    let mut refusal = |segments_u, segments_v| {
        let grid = Grid {
            segments_u,
            segments_v,
        };
        let error = teapot.grid_into(grid, false, &mut mesh).unwrap_err();
        assert_eq!(mesh, before);
        error.to_string()
    };
    let zero = "segments: expected a whole number from 1, got 0";
    assert_eq!(refusal(0, 0), zero);
    assert_eq!(refusal(0, 5), zero);
    assert_eq!(refusal(5, 0), zero);
    let million = "segments: expected at most 663, this needs 1000000";
    assert_eq!(refusal(1_000_000, 1_000_000), million);
    let long = "segments: expected at most 220751, this needs 1000000";
    assert_eq!(refusal(1_000_000, 1), long);
    assert_eq!(refusal(1, 1_000_000), long);
    assert!(refusal(usize::MAX, usize::MAX).contains("at most 663"));
}

#[wasm_bindgen_test(unsupported = test)]
fn surfaces_that_do_not_add_up() {
    let vertices = vec![DVec3::ZERO; 16];
    let indices: Vec<u32> = (0..16).collect();
    let surface = |vertices: &[DVec3], indices: &[u32], m, n| {
        Surface::new(vertices.to_vec(), indices.to_vec(), m, n)
    };
    assert!(surface(&vertices, &indices, 3, 3).is_ok());
    for count in [1, 15, 17, 31] {
        let list = vec![0; count];
        let error = surface(&vertices, &list, 3, 3).unwrap_err();
        assert!(matches!(error, Error::Count { got, .. } if got == count));
    }
    let mut wrong = [indices.clone(), indices.clone()].concat();
    wrong[20] = 16;
    let error = surface(&vertices, &wrong, 3, 3).unwrap_err();
    let message = "patches[1]: expected vertex indices below 16, got 16";
    assert_eq!(error.to_string(), message);
    let mut broken = vertices.clone();
    broken[3].y = f64::NAN;
    let error = surface(&broken, &indices, 3, 3).unwrap_err();
    assert!(matches!(error, Error::NotFinite { index: 3, .. }));
    let error = surface(&vertices, &indices, 3, 0).unwrap_err();
    assert!(matches!(
        error,
        Error::Range {
            what: "degree_v",
            ..
        }
    ));
    let error = Surface::with_degrees(vertices, indices, &[[3, 3], [1, 1]]).unwrap_err();
    assert!(matches!(error, Error::Count { got: 16, .. }));
}

/// Counts and indices beyond the range of integers do not overflow.
#[test]
fn grids_of_any_size_have_counts() {
    for segments in [usize::MAX, usize::MAX / 2, usize::MAX >> 9] {
        let grid = Grid::from(segments);
        assert_eq!(grid.vertex_count(), usize::MAX);
        assert_eq!(grid.triangle_count(), usize::MAX);
        assert!(grid.check(1).is_err());
        assert_eq!(grid.quads().next(), Some(grid.quad(0, 0)));
        assert_eq!(grid.vertex(usize::MAX, usize::MAX), usize::MAX);
        assert_eq!(grid.quad(usize::MAX, usize::MAX), [usize::MAX; 4]);
    }
}
