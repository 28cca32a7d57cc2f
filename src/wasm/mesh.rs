//! Bindings of meshes: crack-free tessellation, grids, and copying of mesh buffers.

use super::arena;
use super::arena::Arena;
use super::decode_surface::{patch, surface};
use super::single_thread_cell::SingleThreadCell;
use crate::geometry::error::Error;
use crate::mesh::grid::{Grid, GridMethod};
use crate::mesh::grid_mesh::GridMeshBuilder;
use crate::mesh::options::Weld;
use crate::mesh::options::{Detail, TessellationOptions, View};
use crate::mesh::{Indices, Mesh};
use crate::surface::network::Surface;
use crate::surface::topology::{EdgeUse, Topology};
use glam::{DMat4, DVec2};
use js_sys::{Float32Array, Float64Array, Uint16Array, Uint32Array};
use std::ops::Range;
use wasm_bindgen::prelude::wasm_bindgen;
use wasm_bindgen::{JsCast, JsValue};

/// The maximum number of bytes of a part of a mesh, unless a single patch takes more: a part should stay in the
/// processor's cache until it is copied.
const PART_BYTES: usize = 5 << 17;

/// The last mesh; the next one reuses its buffers.
static MESH: SingleThreadCell<Mesh> = SingleThreadCell::new(Mesh {
    positions: Vec::new(),
    normals: Vec::new(),
    uvs: Vec::new(),
    patch_ids: Vec::new(),
    indices: Indices::U16(Vec::new()),
    quads: None,
    patch_ranges: Vec::new(),
});

/// The grid that is being built part by part.
static GRID: SingleThreadCell<Option<(Surface, GridMeshBuilder)>> = SingleThreadCell::new(None);

/// The layout of the last mesh if it is a part of a grid.
static LAYOUT: SingleThreadCell<Option<PartLayout>> = SingleThreadCell::new(None);

/// Everything that the layout of a part depends on: the patches, the grid, whether there are quads, and whether indices
/// have 32 bits.
type PartLayout = (Range<usize>, Grid, bool, bool);

/// The positions and normals of the last mesh in f64, if requested.
static PRECISE: SingleThreadCell<[Vec<f64>; 2]> = SingleThreadCell::new([Vec::new(), Vec::new()]);

/// Makes a mesh without cracks; returns 0. `kind` 0: `a` × `b` segments; 1: within the tolerance `a`; 2: within `a`
/// pixels, with the matrix (column-major), width and height after the surface. `weld`: 0 position, 1 normal, 2 none.
#[wasm_bindgen]
pub fn surface_tessellate(kind: u32, a: f64, b: f64, weld: u32, precise: bool) -> isize {
    arena::answer(|arena| {
        let (surface, end) = surface(arena)?;
        let options = options(arena, end, kind, [a, b], weld);
        keep_surface(&surface, &options, precise)
    })
}

/// As `surface_tessellate`, for a patch.
#[wasm_bindgen]
pub fn patch_tessellate(
    degree_u: usize,
    degree_v: usize,
    kind: u32,
    a: f64,
    b: f64,
    weld: u32,
    precise: bool,
) -> isize {
    arena::answer(|arena| {
        let patch = patch(arena, degree_u, degree_v);
        let end = 3 * patch.control_points().len();
        let options = options(arena, end, kind, [a, b], weld);
        keep_surface(&patch.as_surface(), &options, precise)
    })
}

/// Prepares a grid, whose parts `grid_part` makes; returns 0.
pub(crate) fn begin_grid(
    surface: Surface,
    grid: Grid,
    quads: bool,
    differences: bool,
) -> Result<usize, Error> {
    let method = if differences {
        GridMethod::ForwardDifference
    } else {
        GridMethod::Bernstein
    };
    let builder = GridMeshBuilder::new(surface.patch_count(), grid, method, quads)?;
    GRID.with(|kept| *kept = Some((surface, builder)));
    Ok(0)
}

/// Makes the part of the grid that starts with patch `first`, to be copied; returns the number of its patches. Buffers
/// that depend only on counts are kept if the last mesh was a part with the same layout. The last part frees the grid.
#[wasm_bindgen]
pub fn grid_part(first: usize) -> usize {
    let Some((surface, mut builder)) = GRID.with(Option::take) else {
        return 0;
    };
    let part = part(&builder, first);
    let layout = Some((part.clone(), builder.grid, builder.quads, builder.wide()));
    let has_layout = LAYOUT.with(|last| std::mem::replace(last, layout.clone()) == layout);
    MESH.with(|mesh| surface.fill_part(&mut builder, part.clone(), has_layout, mesh));
    if part.end < surface.patch_count() {
        GRID.with(|kept| *kept = Some((surface, builder)));
    }
    part.len()
}

/// The patches from `first` that make a part of the mesh within [`PART_BYTES`].
fn part(builder: &GridMeshBuilder, first: usize) -> Range<usize> {
    let per_cell = if builder.quads { 6 + 4 } else { 6 };
    let patch = builder.grid.vertex_count() * (9 + per_cell) * size_of::<f32>();
    first..builder.patches.min(first + (PART_BYTES / patch).max(1))
}

const WELDS: [Weld; 3] = [Weld::Position, Weld::Normal, Weld::None];

#[allow(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "JavaScript checks that they are counts"
)]
pub(super) fn options(
    arena: &Arena,
    end: usize,
    kind: u32,
    [a, b]: [f64; 2],
    weld: u32,
) -> TessellationOptions {
    let detail = match kind {
        0 => Detail::Segments(Grid {
            segments_u: a as usize,
            segments_v: b as usize,
        }),
        1 => Detail::Tolerance(a),
        _ => Detail::Pixels(View {
            pixels: a,
            view_projection: DMat4::from_cols_slice(arena.numbers(end, 16)),
            viewport: DVec2::from_slice(arena.numbers(end + 16, 2)),
        }),
    };
    TessellationOptions::from(detail).weld(WELDS[weld as usize % 3])
}

fn keep_surface(
    surface: &Surface,
    options: &TessellationOptions,
    precise: bool,
) -> Result<usize, Error> {
    keep(
        precise,
        || surface.tessellate(options),
        || surface.tessellate_f64(options),
    )
}

/// Makes a mesh and stores it to be copied; f64 positions and normals are stored separately.
pub(super) fn keep(
    precise: bool,
    in_f32: impl FnOnce() -> Result<Mesh, Error>,
    in_f64: impl FnOnce() -> Result<Mesh<f64>, Error>,
) -> Result<usize, Error> {
    let mesh = if precise {
        let mut mesh = in_f64()?;
        let numbers = [&mut mesh.positions, &mut mesh.normals].map(std::mem::take);
        PRECISE.with(|kept| *kept = numbers);
        mesh.to_f32()
    } else {
        in_f32()?
    };
    Ok(keep_mesh(mesh))
}

/// Stores a mesh that is not a grid, to be copied; returns 0.
pub(crate) fn keep_mesh(mesh: Mesh) -> usize {
    LAYOUT.with(|last| *last = None);
    MESH.with(|kept| *kept = mesh);
    0
}

/// Writes the topology: five lists (shared edges, edges of three or more patches, open edges, collapsed edges,
/// components). Each list is its number of groups, and for each group its number of members and the members: patch · 8
/// + side · 2 + (1 if the direction is reversed), or for components the patch index.
#[wasm_bindgen]
pub fn surface_topology() -> isize {
    arena::answer(|a| {
        let topology = surface(a)?.0.topology();
        Ok(write_topology(a, topology))
    })
}

pub(super) fn write_topology(a: &mut Arena, topology: Topology) -> usize {
    let code = |s: &EdgeUse| s.patch * 8 + s.edge as usize * 2 + usize::from(s.reversed);
    let mut numbers = Vec::new();
    for groups in [&topology.shared, &topology.non_manifold] {
        write_groups(&mut numbers, groups, code);
    }
    for sides in [topology.open, topology.collapsed] {
        write_groups(&mut numbers, &[sides], code);
    }
    write_groups(&mut numbers, &topology.components, |&patch| patch);
    a.write_counts(0, numbers.into_iter())
}

fn write_groups<T>(numbers: &mut Vec<usize>, groups: &[Vec<T>], code: impl Fn(&T) -> usize) {
    numbers.push(groups.len());
    for group in groups {
        numbers.push(group.len());
        numbers.extend(group.iter().map(&code));
    }
}

/// The number of entries of a buffer of the last mesh: 0 positions, 1 normals, 2 uvs, 3 patch indices, 4 indices,
/// 5 quads (0 if there are none), 6 patch ranges (four each), 7 and 8 positions and normals in f64.
#[wasm_bindgen]
pub fn mesh_length(buffer: usize) -> usize {
    MESH.with(|mesh| match buffer {
        0 => mesh.positions.len(),
        1 => mesh.normals.len(),
        2 => mesh.uvs.len(),
        3 => mesh.patch_ids.len(),
        4 => mesh.indices.len(),
        6 => 4 * mesh.patch_ranges.len(),
        7 | 8 => PRECISE.with(|kept| kept[buffer - 7].len()),
        _ => mesh.quads.as_ref().map_or(0, Indices::len),
    })
}

/// Copies a buffer of the last mesh to a typed array of matching type and of exactly the same length.
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
        7 | 8 => PRECISE.with(|kept| {
            into.unchecked_ref::<Float64Array>()
                .copy_from(&kept[buffer - 7])
        }),
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

/// Frees the memory of the last mesh.
#[wasm_bindgen]
pub fn mesh_drop() {
    LAYOUT.with(|last| *last = None);
    MESH.with(|mesh| *mesh = Mesh::default());
    PRECISE.with(|kept| *kept = [Vec::new(), Vec::new()]);
}

/// Prepares the grid of one patch, evaluated by forward `differences` or by Bernstein polynomials; returns 0.
#[wasm_bindgen]
pub fn patch_grid(
    degree_u: usize,
    degree_v: usize,
    segments_u: usize,
    segments_v: usize,
    quads: bool,
    differences: bool,
) -> isize {
    arena::answer(|a| {
        let patch = patch(a, degree_u, degree_v);
        let grid = Grid {
            segments_u,
            segments_v,
        };
        begin_grid(patch.as_surface(), grid, quads, differences)
    })
}

/// As `patch_grid`, for a surface.
#[wasm_bindgen]
pub fn surface_grid(segments_u: usize, segments_v: usize, quads: bool, differences: bool) -> isize {
    arena::answer(|a| {
        let (surface, _) = surface(a)?;
        let grid = Grid {
            segments_u,
            segments_v,
        };
        begin_grid(surface, grid, quads, differences)
    })
}
