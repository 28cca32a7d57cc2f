//! Bindings of patches and surfaces.
//!
//! Patches: the net at the start of the arena. Surfaces: the number of vertices and of patches, the degrees u and v
//! of each patch, the vertices, the indices of all nets; further arguments behind them.

use super::alone::Alone;
use super::arena::{self, Arena};
use super::given;
use super::pen::CanvasPen;
use crate::error::Error;
use crate::surface::{Grid, Height, Indices, Mesh, Patch, Surface, TeapotOptions, Up};
use glam::{DMat4, DVec3};
use js_sys::{Float32Array, Uint16Array, Uint32Array};
use wasm_bindgen::prelude::wasm_bindgen;
use wasm_bindgen::{JsCast, JsValue};

/// The last mesh, whose buffers the next one reuses.
static MESH: Alone<Mesh> = Alone::new(Mesh {
    positions: Vec::new(),
    normals: Vec::new(),
    uvs: Vec::new(),
    patch_ids: Vec::new(),
    indices: Indices::U16(Vec::new()),
    quads: None,
    patch_ranges: Vec::new(),
});

fn patch(a: &Arena, degree_u: usize, degree_v: usize) -> Patch {
    Patch::from_checked(a.points(0, (degree_u + 1) * (degree_v + 1)), degree_u)
}

/// Leaves the point at (u, v).
#[wasm_bindgen]
pub fn patch_eval(degree_u: usize, degree_v: usize, u: f64, v: f64) {
    arena::with(|a| a.put_point(patch(a, degree_u, degree_v).eval(u, v)));
}

/// Leaves ∂u, ∂v, ∂uu, ∂uv, ∂vv.
#[wasm_bindgen]
pub fn patch_partials(degree_u: usize, degree_v: usize, u: f64, v: f64) {
    arena::with(|a| {
        let p = patch(a, degree_u, degree_v).partials(u, v);
        a.put(0, &[p.u, p.v, p.uu, p.uv, p.vv]);
    });
}

/// Leaves the unit normal at (u, v).
#[wasm_bindgen]
pub fn patch_normal(degree_u: usize, degree_v: usize, u: f64, v: f64) {
    arena::with(|a| a.put_point(patch(a, degree_u, degree_v).normal(u, v)));
}

/// Leaves the control points of the curve of constant u (or v); their number of f64.
#[wasm_bindgen]
pub fn patch_isocurve(degree_u: usize, degree_v: usize, constant_u: bool, at: f64) -> usize {
    arena::with(|a| {
        let patch = patch(a, degree_u, degree_v);
        let curve = if constant_u {
            patch.isocurve_at_u(at)
        } else {
            patch.isocurve_at_v(at)
        };
        a.put(0, curve.control_points())
    })
}

/// Leaves the nets of the two pieces before and after u (or v).
#[wasm_bindgen]
pub fn patch_split(degree_u: usize, degree_v: usize, along_u: bool, at: f64) {
    arena::with(|a| {
        let patch = patch(a, degree_u, degree_v);
        let (before, after) = if along_u {
            patch.split_u(at)
        } else {
            patch.split_v(at)
        };
        let end = a.put(0, before.control_points());
        a.put(end, after.control_points());
    });
}

/// Makes the mesh of one patch; 0.
#[wasm_bindgen]
pub fn patch_grid(
    degree_u: usize,
    degree_v: usize,
    segments_u: usize,
    segments_v: usize,
    quads: bool,
) -> isize {
    arena::answer(|a| {
        let patch = patch(a, degree_u, degree_v);
        let grid = Grid {
            segments_u,
            segments_v,
        };
        MESH.with(|mesh| patch.grid_into(grid, quads, mesh))?;
        Ok(0)
    })
}

/// The surface at the start of the arena, and where it ends.
fn surface(a: &Arena) -> Result<(Surface, usize), Error> {
    let (vertices, patches) = (a.count(0), a.count(1));
    let degrees: Vec<[usize; 2]> = (0..patches)
        .map(|k| [a.count(2 + 2 * k), a.count(3 + 2 * k)])
        .collect();
    let at = 2 + 2 * patches;
    let indices_at = at + 3 * vertices;
    let count = degrees
        .iter()
        .map(|[u, v]| (u + 1) * (v + 1))
        .sum::<usize>();
    let indices = a.small_counts(indices_at, count);
    let points = a.points::<DVec3>(at, vertices).to_vec();
    let surface = Surface::with_degrees(points, indices, &degrees)?;
    Ok((surface, indices_at + count))
}

/// Leaves the teapot. `parts`: bit 0 rim, 1 body, 2 handle, 3 spout, 4 lid, 5 bottom.
#[wasm_bindgen]
pub fn surface_teapot(parts: u32, original_height: bool, y_up: bool) -> usize {
    let part = |bit: u32| parts >> bit & 1 == 1;
    let teapot = Surface::teapot(TeapotOptions {
        rim: part(0),
        body: part(1),
        handle: part(2),
        spout: part(3),
        lid: part(4),
        bottom: part(5),
        height: if original_height {
            Height::Original
        } else {
            Height::Squashed
        },
        up: if y_up { Up::Y } else { Up::Z },
    });
    arena::with(|a| put(a, &teapot))
}

/// Leaves the teacup, or the teaspoon.
#[wasm_bindgen]
pub fn surface_teaset(spoon: bool, y_up: bool) -> usize {
    let up = if y_up { Up::Y } else { Up::Z };
    let surface = if spoon {
        Surface::teaspoon(up)
    } else {
        Surface::teacup(up)
    };
    arena::with(|a| put(a, &surface))
}

fn put(a: &mut Arena, surface: &Surface) -> usize {
    let mut head = vec![
        surface.vertices().len() as f64,
        surface.patch_count() as f64,
    ];
    head.extend(
        (0..surface.patch_count())
            .filter_map(|k| surface.degrees(k))
            .flatten()
            .map(|d| d as f64),
    );
    let at = a.put_numbers(0, &head);
    let at = a.put(at, surface.vertices());
    let indices: Vec<f64> = surface.indices().iter().map(|&i| f64::from(i)).collect();
    a.put_numbers(at, &indices)
}

/// Makes the mesh of a surface; 0.
#[wasm_bindgen]
pub fn surface_grid(segments_u: usize, segments_v: usize, quads: bool) -> isize {
    arena::answer(|a| {
        let (surface, _) = surface(a)?;
        let grid = Grid {
            segments_u,
            segments_v,
        };
        MESH.with(|mesh| surface.grid_into(grid, quads, mesh))?;
        Ok(0)
    })
}

/// In: a 4×4 matrix behind the surface, in columns. Draws all isocurves, projected, on a context or a path.
#[wasm_bindgen]
pub fn surface_trace(target: &JsValue, lines: usize, tolerance: f64) -> isize {
    let read = arena::with(|a| {
        let (surface, end) = surface(a)?;
        Ok::<_, Error>((surface, DMat4::from_cols_slice(a.numbers(end, 16))))
    });
    let mut pen = CanvasPen::new(target);
    let draw = |(surface, matrix): (Surface, DMat4)| {
        surface.trace_projected(&mut pen, &matrix, lines, given(tolerance))
    };
    arena::settle(read.and_then(draw).map(|()| 0))
}

/// The number of entries of a buffer of the last mesh: 0 positions, 1 normals, 2 uvs, 3 patch numbers, 4 indices,
/// 5 quads (0 where there are none), 6 patch ranges (four each).
#[wasm_bindgen]
pub fn mesh_length(buffer: usize) -> usize {
    MESH.with(|mesh| match buffer {
        0 => mesh.positions.len(),
        1 => mesh.normals.len(),
        2 => mesh.uvs.len(),
        3 => mesh.patch_ids.len(),
        4 => mesh.indices.len(),
        6 => 4 * mesh.patch_ranges.len(),
        _ => mesh.quads.as_ref().map_or(0, Indices::len),
    })
}

/// Copies a buffer of the last mesh into a typed array of its kind and of exactly its length.
#[wasm_bindgen]
pub fn mesh_copy(buffer: usize, into: &JsValue) {
    MESH.with(|mesh| match buffer {
        0 => into
            .unchecked_ref::<Float32Array>()
            .copy_from(&mesh.positions),
        1 => into
            .unchecked_ref::<Float32Array>()
            .copy_from(&mesh.normals),
        2 => into.unchecked_ref::<Float32Array>().copy_from(&mesh.uvs),
        3 => into
            .unchecked_ref::<Uint32Array>()
            .copy_from(&mesh.patch_ids),
        4 => copy_indices(&mesh.indices, into),
        6 => into
            .unchecked_ref::<Uint32Array>()
            .copy_from(&range_numbers(mesh)),
        _ => mesh
            .quads
            .iter()
            .for_each(|quads| copy_indices(quads, into)),
    });
}

fn range_numbers(mesh: &Mesh) -> Vec<u32> {
    mesh.patch_ranges
        .iter()
        .flat_map(|r| [r.first_vertex, r.vertices, r.first_index, r.indices])
        .collect()
}

fn copy_indices(indices: &Indices, into: &JsValue) {
    match indices {
        Indices::U16(list) => into.unchecked_ref::<Uint16Array>().copy_from(list),
        Indices::U32(list) => into.unchecked_ref::<Uint32Array>().copy_from(list),
    }
}

/// Gives the memory of the last mesh back.
#[wasm_bindgen]
pub fn mesh_drop() {
    MESH.with(|mesh| *mesh = Mesh::default());
}
