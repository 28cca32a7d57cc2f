//! Grids: layout, positions and normals compared with the patch, shared edges, reuse of buffers, limits.

use crate::support::nets::{RandomNet, assert_near, nothing, patch, teapot, triangles, vector};
use crate::support::{Rng, assert_refused, near};
use casteljau::curve::bernstein;
use casteljau::glam::DVec3;
use casteljau::{Grid, Indices, Mesh, Patch, Surface};
#[cfg(target_family = "wasm")]
use wasm_bindgen_test::wasm_bindgen_test as test;

fn cells(segments_u: usize, segments_v: usize) -> Grid {
    Grid {
        segments_u,
        segments_v,
    }
}

fn mesh(patch: &Patch, grid: Grid) -> Mesh {
    patch.grid(grid, false).unwrap()
}

#[test]
fn vertices_in_one_buffer_and_indices_as_bytes() {
    let mesh = teapot().grid(cells(2, 1), false).unwrap();
    let numbers = mesh.interleaved();
    assert_eq!(numbers.len(), 8 * mesh.vertex_count());
    for (vertex, all) in numbers.chunks(8).enumerate() {
        let three = 3 * vertex..3 * vertex + 3;
        assert_eq!(all[..3], mesh.positions[three.clone()]);
        assert_eq!(all[3..6], mesh.normals[three]);
        assert_eq!(all[6..], mesh.uvs[2 * vertex..2 * vertex + 2]);
    }
    let shared = Mesh {
        uvs: Vec::new(),
        ..mesh
    };
    assert_eq!(shared.interleaved().len(), 6 * shared.vertex_count());
    assert_eq!(
        Indices::U16(vec![1, 258, 3]).to_bytes(),
        [1, 0, 2, 1, 3, 0, 0, 0]
    );
    assert_eq!(Indices::U32(vec![0x0403_0201]).to_bytes(), [1, 2, 3, 4]);
    assert!(Indices::default().to_bytes().is_empty());
}

#[test]
fn layout_of_the_buffers() {
    let grid = cells(3, 2);
    assert_eq!((grid.vertex_count(), grid.triangle_count()), (12, 12));
    let mesh = teapot().grid(grid, true).unwrap();
    let counts = [mesh.vertex_count(), mesh.triangle_count()];
    assert_eq!(counts, [32 * 12; 2]);
    assert_eq!(mesh.normals.len(), mesh.positions.len());
    assert_eq!(mesh.uvs.len(), 2 * mesh.vertex_count());
    assert_eq!(mesh.quads.as_ref().unwrap().len(), 32 * 6 * 4);
    assert_eq!(mesh.patch_ranges.len(), 32);
    for (id, range) in (0_u32..).zip(&mesh.patch_ranges) {
        assert_eq!((range.first_vertex, range.vertices), (12 * id, 12));
        assert_eq!((range.first_index, range.indices), (36 * id, 36));
        for vertex in 12 * id as usize..12 * (id as usize + 1) {
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

#[test]
fn faces_run_counter_clockwise_and_cover_the_square_once() {
    let grid = cells(5, 3);
    let mesh = Rng(1).patch(3, 3).grid(grid, true).unwrap();
    let uv = |vertex: usize| [0, 1].map(|k| f64::from(mesh.uvs[2 * vertex + k]));
    let cross = |(&a, &b): (&usize, &usize)| uv(a)[0] * uv(b)[1] - uv(a)[1] * uv(b)[0];
    let area = |face: &[usize]| -> f64 {
        let next = face.iter().cycle().skip(1);
        face.iter().zip(next).map(|pair| cross(pair) / 2.0).sum()
    };
    let lists = [&mesh.indices, mesh.quads.as_ref().unwrap()];
    let indices: [Vec<usize>; 2] = lists.map(|list| list.iter().collect());
    for (all, corners, faces) in [(&indices[0], 3, 30), (&indices[1], 4, 15)] {
        for face in all.chunks(corners) {
            near(area(face), 1.0 / f64::from(faces), 1e-7);
        }
        assert_eq!(all.len() / corners, faces as usize);
    }
    assert!(grid.triangles().flatten().eq(indices[0].iter().copied()));
    assert!(grid.quads().flatten().eq(indices[1].iter().copied()));
}

#[test]
fn triangles_face_where_the_normals_point() {
    let mesh = teapot().grid(Grid::from(16), false).unwrap();
    let mut flat = 0;
    for face in triangles(&mesh) {
        let [a, b, c] = face.map(|vertex| vector(&mesh.positions, vertex));
        let across = (b - a).cross(c - a);
        if across.length() < 1e-9 {
            flat += 1;
            continue;
        }
        let normals = face.map(|vertex| vector(&mesh.normals, vertex));
        assert!(normals.iter().all(|&normal| across.dot(normal) > 0.0));
    }
    // Eight collapsed edges, one triangle for each of their sixteen segments.
    assert_eq!(flat, 128);
}

#[test]
fn samples_are_points_and_normals_of_the_patch() {
    let mut random = Rng(2);
    for (m, n) in [(1, 1), (2, 3), (3, 3), (3, 2), (5, 4), (1, 64), (64, 1)] {
        for segments_u in [1, 2, 3, 4, 7, 8, 13] {
            let (grid, patch) = (cells(segments_u, 3), random.patch(m, n));
            let mesh = mesh(&patch, grid);
            let bounds = patch.control_bounds();
            let largest = bounds.min.abs().max(bounds.max.abs());
            let largest = largest.as_vec3().max_element();
            let slack = f64::from(4.0 * (largest.next_up() - largest));
            for (iv, iu) in (0..=3).flat_map(|iv| (0..=segments_u).map(move |iu| (iv, iu))) {
                let ((u, v), vertex) = (grid.uv(iu, iv), grid.vertex(iu, iv));
                let (p, q) = (vector(&mesh.positions, vertex), patch.eval(u, v));
                assert!((p - q).abs().max_element() <= slack, "{p} {q}");
                assert_near(vector(&mesh.normals, vertex), patch.normal(u, v), 1e-6);
            }
        }
    }
}

#[test]
fn corners_are_exact() {
    let mut random = Rng(3);
    for _ in 0..100 {
        let patch = random.patch(3, 3);
        let mesh = mesh(&patch, Grid::from(5));
        for (vertex, index) in [(0, 0), (5, 3), (30, 12), (35, 15)] {
            let corner = patch.control_points()[index].as_vec3().as_dvec3();
            assert_eq!(vector(&mesh.positions, vertex), corner);
        }
    }
}

/// The bits of the positions at v = 0, or at u = 1, of a grid of n × n cells.
fn side(mesh: &Mesh, n: usize, along_v: bool) -> Vec<[u32; 3]> {
    let (first, step) = if along_v { (n, n + 1) } else { (0, 1) };
    let bits = |vertex: usize| [0, 1, 2].map(|axis| mesh.positions[3 * vertex + axis].to_bits());
    (0..=n).map(|k| bits(first + k * step)).collect()
}

/// Asserts that patches with these points along an edge have the same positions there, whatever their other degree and
/// points, and the reversed ones where the points are reversed.
fn assert_shared(points: &[DVec3], random: &mut Rng, degrees: &[usize], n: usize) {
    let grid = Grid::from(n);
    let expected = side(&mesh(&along_v0(points, random, degrees[0]), grid), n, false);
    let backwards: Vec<DVec3> = points.iter().rev().copied().collect();
    for (points, reversed) in [(points, false), (&backwards, true)] {
        for &degree in &degrees[1..] {
            let below = side(&mesh(&along_v0(points, random, degree), grid), n, false);
            let right = side(&mesh(&along_u1(points, random, degree), grid), n, true);
            for mut got in [below, right] {
                if reversed {
                    got.reverse();
                }
                assert_eq!(got, expected);
            }
        }
    }
}

#[test]
fn shared_sides_are_bit_identical_from_both_patches() {
    let mut random = Rng(4);
    for degree in [1, 2, 3, 5, 8] {
        for other in [1, 3, 4] {
            let side = random.net(degree, 0);
            for n in [1, 2, 5, 16, 23] {
                assert_shared(&side, &mut random, &[other, 3, 2], n);
            }
        }
    }
}

#[test]
fn shared_sides_are_bit_identical_where_everything_cancels() {
    // Edges that pass through 0 at one sample, where only the rounding of f64 remains: it must be equal for both
    // patches.
    let mut random = Rng(9);
    for degree in [2, 3, 4] {
        for n in [7, 16, 23, 49] {
            for k in 1..n {
                let weights = bernstein(degree, k as f64 / n as f64).unwrap();
                let mut side = random.net(degree, 0);
                let others = side.iter().zip(&weights).take(degree);
                let sum: DVec3 = others.map(|(&p, &w)| p * w).sum();
                side[degree] = -sum / weights[degree];
                assert_shared(&side, &mut random, &[3, 2, 3], n);
            }
        }
    }
}

/// A random patch with these points along v = 0.
fn along_v0(side: &[DVec3], random: &mut Rng, degree_v: usize) -> Patch {
    let mut net = random.net(side.len() - 1, degree_v);
    net[..side.len()].copy_from_slice(side);
    patch(&net, side.len() - 1, degree_v)
}

/// A random patch with these points along u = 1.
fn along_u1(side: &[DVec3], random: &mut Rng, degree_u: usize) -> Patch {
    let mut net = random.net(degree_u, side.len() - 1);
    let rows = net.chunks_mut(degree_u + 1).zip(side);
    rows.for_each(|(row, &point)| row[degree_u] = point);
    patch(&net, degree_u, side.len() - 1)
}

#[test]
fn degenerate_and_extreme_patches_give_numbers() {
    let line: Vec<DVec3> = (0..16).map(|k| DVec3::X * f64::from(k % 4)).collect();
    for net in [vec![DVec3::ONE; 16], line] {
        let mesh = mesh(&patch(&net, 3, 3), Grid::from(5));
        assert!(mesh.normals.iter().all(|&n| n == 0.0));
        assert!(net[1] != DVec3::ONE || mesh.positions.iter().all(|&x| x == 1.0));
    }
    let net = Rng(5).net(3, 3);
    for size in [1e-300, 1e-30, 1e30, 1e149] {
        let scaled: Vec<DVec3> = net.iter().map(|&p| p * size).collect();
        let mesh = mesh(&patch(&scaled, 3, 3), Grid::from(4));
        // Positions too large for f32 are infinite, not NaN; the normal keeps its direction.
        assert!(mesh.positions.iter().all(|x| !x.is_nan()));
        let lengths = (0..mesh.vertex_count()).map(|vertex| vector(&mesh.normals, vertex).length());
        lengths.for_each(|length| near(length, 1.0, 1e-6));
    }
}

#[test]
fn sixteen_bits_up_to_65536_vertices() {
    for (n, small) in [(255, true), (256, false)] {
        let mesh = mesh(&Rng(6).patch(1, 1), Grid::from(n));
        assert_eq!(matches!(mesh.indices, Indices::U16(_)), small);
        assert_eq!(mesh.indices.iter().max(), Some(mesh.vertex_count() - 1));
    }
}

#[test]
fn an_earlier_mesh_is_reused() {
    let mut mesh = teapot().grid(Grid::from(20), true).unwrap();
    let buffers = |mesh: &Mesh| (mesh.positions.as_ptr(), mesh.normals.as_ptr());
    let before = buffers(&mesh);
    // The last two: from 16 to 32 bits and back.
    for (n, quads) in [(16, false), (20, true), (3, false), (50, true), (2, true)] {
        teapot().grid_into(Grid::from(n), quads, &mut mesh).unwrap();
        assert_eq!(mesh, teapot().grid(Grid::from(n), quads).unwrap());
        assert!(n == 50 || n == 2 || buffers(&mesh) == before);
    }
    let patch = Rng(7).patch(2, 4);
    patch.grid_into(Grid::from(4), false, &mut mesh).unwrap();
    assert_eq!(mesh, patch.grid(Grid::from(4), false).unwrap());
}

#[test]
fn patches_of_different_degrees_in_one_surface() {
    let mut random = Rng(8);
    let degrees = [[3, 3], [2, 1], [3, 3], [1, 5]];
    let patches = degrees.map(|[m, n]| random.patch(m, n));
    let vertices = patches.each_ref().map(Patch::control_points).concat();
    let indices = (0..u32::try_from(vertices.len()).unwrap()).collect();
    let surface = Surface::with_degrees(vertices, indices, &degrees).unwrap();
    let grid = Grid::from(6);
    let whole = surface.grid(grid, false).unwrap();
    for (k, patch) in patches.iter().enumerate() {
        assert_eq!(surface.patch(k).as_ref(), Some(patch));
        assert_eq!(surface.degrees(k), Some(degrees[k]));
        let numbers = 3 * grid.vertex_count();
        let (single, range) = (mesh(patch, grid), k * numbers..(k + 1) * numbers);
        assert_eq!(whole.positions[range.clone()], single.positions);
        assert_eq!(whole.normals[range], single.normals);
    }
    assert_eq!(surface.patch(4), None);
    assert_eq!(nothing().grid(grid, false), Ok(Mesh::default()));
    assert_eq!(nothing().control_bounds(), None);
}

#[test]
fn segments_are_checked_before_anything_is_allocated() {
    let mut mesh = teapot().grid(Grid::from(2), false).unwrap();
    let before = mesh.clone();
    let zero = "segments: expected a whole number from 1, got 0";
    let long = "segments: expected at most 220751, this needs 1000000";
    for (u, v, message) in [
        (0, 0, zero),
        (0, 5, zero),
        (5, 0, zero),
        (
            1_000_000,
            1_000_000,
            "segments: expected at most 663, this needs 1000000",
        ),
        (1_000_000, 1, long),
        (1, 1_000_000, long),
        (usize::MAX, usize::MAX, "segments: expected at most 663"),
    ] {
        assert_refused(teapot().grid_into(cells(u, v), false, &mut mesh), message);
        assert_eq!(mesh, before);
    }
}

#[test]
fn surfaces_that_do_not_add_up() {
    let vertices = vec![DVec3::ZERO; 16];
    let indices: Vec<u32> = (0..16).collect();
    let surface = |vertices: &[DVec3], indices: &[u32], n| {
        Surface::new(vertices.to_vec(), indices.to_vec(), 3, n)
    };
    assert!(surface(&vertices, &indices, 3).is_ok());
    let count =
        "patches: expected (degree_u + 1)·(degree_v + 1) vertex indices for each patch, got ";
    for got in [1, 15, 17, 31] {
        let surface = surface(&vertices, &vec![0; got], 3);
        assert_refused(surface, &format!("{count}{got}"));
    }
    let mut wrong = indices.repeat(2);
    wrong[20] = 16;
    let message = "patches[1]: expected vertex indices below 16, got 16";
    assert_refused(surface(&vertices, &wrong, 3), message);
    let mut broken = vertices.clone();
    broken[3].y = f64::NAN;
    let finite = "vertices[3]: expected a finite number";
    assert_refused(surface(&broken, &indices, 3), finite);
    assert_refused(surface(&vertices, &indices, 0), "degree_v: ");
    let degrees = [[3, 3], [1, 1]];
    let surface = Surface::with_degrees(vertices, indices, &degrees);
    assert_refused(surface, &format!("{count}16"));
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
